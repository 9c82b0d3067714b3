//! The judgement of answers, in words.

use super::answer::{Answer, Heard};
use super::parts::{Part, Parts, is_well};
use super::verdict::{Court, Verdict};
use super::{report, taylor};
use serde_json::{Value, json};

/// The judgement of all answers, its parts, its causes, and the full report.
pub struct Judgement {
    pub(super) found: Verdict,
    pub(super) verdict: Parts,
    is_strict: bool,
    /// The causes, one line each.
    pub causes: Vec<String>,
    /// The full report.
    pub text: String,
    /// The same for programs.
    pub json: Value,
}

impl Judgement {
    /// Whether it is the formula: right at ordinary points and on kinks; if it is judged strictly, within our bounds everywhere.
    pub fn is_well(&self) -> bool {
        is_well(&self.found, &self.verdict, self.is_strict)
    }

    /// The parts of the verdict, in order.
    pub fn parts(&self) -> &[Part] {
        &self.verdict.parts
    }
}

impl Court<'_> {
    /// Judges the answers of the first and of the second pass.
    pub fn judged(&self, program: &[String], answers: &[Vec<Answer>; 2], heard: &Heard) -> Judgement {
        let slope = taylor::message(self, &answers[0]);
        let found = self.judge(answers);
        let verdict = self.parts(answers, &found);
        let causes = report::causes(&verdict);
        let text = report::text(self, program, &found, &verdict, heard, slope.as_deref());
        let is_strict = self.is_strict;
        let json = json!({
            "formula": self.formula.spec().id,
            "right": is_well(&found, &verdict, is_strict),
            "strict": is_strict,
            "parts": verdict.parts.iter().map(|part| self.part_as_json(part)).collect::<Vec<_>>(),
            "causes": causes,
        });
        Judgement { found, verdict, is_strict, causes, text, json }
    }

    fn part_as_json(&self, part: &Part) -> Value {
        let [right, of] = part.right;
        json!({
            "part": part.title,
            "conclusion": part.standing.name(),
            "right": right,
            "of": of,
            "says": part.says,
            "details": part.details,
            "point": part.point.map(|k| report::inputs(self, k)),
        })
    }
}
