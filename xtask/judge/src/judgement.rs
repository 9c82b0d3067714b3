//! Answers judged, and put into words.

use super::answer::{Answer, Heard};
use super::verdict::{Court, Verdict};
use super::{diagnosis, report, taylor};

/// What was found about all answers, its causes, and all of it as text.
pub struct Judgement {
    pub(super) found: Verdict,
    /// What explains it, a line each.
    pub causes: Vec<String>,
    /// Everything that was found.
    pub text: String,
}

impl Judgement {
    /// Whether nothing is to be mended.
    pub fn is_well(&self) -> bool {
        self.found.is_well()
    }
}

impl Court<'_> {
    /// What the answers of the first and of the second time are worth.
    pub fn judged(&self, program: &[String], answers: &[Vec<Answer>; 2], heard: &Heard) -> Judgement {
        let slope = taylor::told(self, &answers[0]);
        let found = self.judge(answers);
        let causes = diagnosis::diagnose(self, answers, &found);
        let text = report::text(self, program, &found, heard, slope.as_deref(), &causes);
        Judgement { found, causes, text }
    }
}
