//! Answers judged, and put into words.

use super::answer::{Answer, Heard};
use super::verdict::{Court, Verdict};
use super::{diagnosis, report};

/// What was found about all answers, its causes, and all of it as text.
pub(super) struct Judgement {
    pub(super) found: Verdict,
    pub(super) causes: Vec<String>,
    pub(super) text: String,
}

impl Court<'_> {
    /// What the answers of the first and of the second time are worth; the slope is said of the Taylor remainder.
    pub(super) fn judged(
        &self,
        program: &[String],
        answers: &[Vec<Answer>; 2],
        heard: &Heard,
        slope: Option<&str>,
    ) -> Judgement {
        let found = self.judge(answers);
        let causes = diagnosis::diagnose(self, answers, &found);
        let text = report::text(self, program, &found, heard, slope, &causes);
        Judgement { found, causes, text }
    }
}
