//! The judgement of answers, in words.

use super::answer::{Answer, Heard};
use super::verdict::{Court, Verdict};
use super::{diagnosis, report, taylor};

/// The judgement of all answers, its causes, and the full report.
pub struct Judgement {
    pub(super) found: Verdict,
    /// The causes, one line each.
    pub causes: Vec<String>,
    /// The full report.
    pub text: String,
}

impl Judgement {
    /// Whether nothing is wrong.
    pub fn is_well(&self) -> bool {
        self.found.is_well()
    }
}

impl Court<'_> {
    /// Judges the answers of the first and of the second pass.
    pub fn judged(&self, program: &[String], answers: &[Vec<Answer>; 2], heard: &Heard) -> Judgement {
        let slope = taylor::message(self, &answers[0]);
        let found = self.judge(answers);
        let causes = diagnosis::diagnose(self, answers, &found);
        let text = report::text(self, program, &found, heard, slope.as_deref(), &causes);
        Judgement { found, causes, text }
    }
}
