//! A formula that is exported, and what every language says of it: names, what it is, and which inputs it refuses.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::graph::{Graph, NotRecorded};
use jointproof::quantity::Domain;

/// A formula that can be exported.
pub(super) struct Recorded {
    pub(super) formula: &'static dyn AnyFormula,
    pub(super) graph: Graph,
}

/// The graphs of formulas, and those that have none.
pub(super) fn record(
    formulas: &[&'static dyn AnyFormula],
) -> (Vec<Recorded>, Vec<(&'static dyn AnyFormula, NotRecorded)>) {
    let (mut recorded, mut refused) = (Vec::new(), Vec::new());
    for &formula in formulas {
        match formula.graph() {
            Ok(graph) => recorded.push(Recorded { formula, graph }),
            Err(why) => refused.push((formula, why)),
        }
    }
    (recorded, refused)
}

/// `slot_constraint` of `slot.constraint`.
pub(super) fn stem(one: &Recorded) -> String {
    one.formula.spec().id.replace('.', "_")
}

/// What the head of a formula's file says, line by line.
pub(super) fn description(one: &Recorded) -> Vec<String> {
    let spec = one.formula.spec();
    let mut lines = vec![
        format!("{}: {}", spec.id, spec.title),
        format!("{}; {}", spec.source, spec.source.provenance),
        String::new(),
    ];
    lines.extend(wrapped(spec.latex));
    lines.push(String::new());
    lines.extend(one.formula.inputs().iter().map(|field| described("in ", field)));
    lines.extend(one.formula.outputs().iter().map(|field| described("out", field)));
    lines.push(String::new());
    lines
        .push(format!("eta <= {} of the value, <= {} of the Jacobian, in units of 2^-53", spec.eta, spec.eta_jacobian));
    lines.extend(one.formula.kinks().iter().flat_map(|kink| wrapped(&format!("kink: {}", kink.condition))));
    lines.push("Golden cases: golden/".to_owned() + spec.id + ".json of jointproof " + env!("CARGO_PKG_VERSION"));
    lines.push("Printed by jointproof; free of conditions (CC0-1.0).".into());
    lines.iter().map(|line| line.trim_end().to_owned()).collect()
}

fn described(role: &str, field: &Field) -> String {
    let shape = match field.len() {
        1 => String::new(),
        len => format!("({len})"),
    };
    format!("{role} {}{shape} [{}] {}", field.name, field.quantity.unit, field.quantity.meaning)
}

/// In lines of at most 90 characters, broken at spaces.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.last_mut().expect("there is a first line");
        if !last.is_empty() && last.chars().count() + word.chars().count() > 89 {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}

/// What a component must be beside finite: comparisons of it, `lower`, with numbers.
pub(super) fn bounds(domain: Domain) -> Vec<(&'static str, f64)> {
    match domain {
        Domain::NonNegative => vec![(">=", 0.0)],
        Domain::Positive => vec![(">", 0.0)],
        Domain::Between(low, high) => vec![(">", low), ("<", high)],
        Domain::Within(low, high) => vec![(">=", low), ("<=", high)],
        Domain::HalfOpen(low, high) => vec![(">=", low), ("<", high)],
        _ => Vec::new(),
    }
}

/// A name that no word of the language has.
pub(super) fn unreserved(name: &str, reserved: &[&str]) -> String {
    if reserved.contains(&name) { format!("{name}_") } else { name.to_owned() }
}

/// A text that grows.
pub(super) struct Text(String);

impl Text {
    pub(super) fn push(&mut self, text: impl AsRef<str>) {
        self.0.push_str(text.as_ref());
    }

    pub(super) fn finished(self) -> String {
        self.0
    }
}

impl<S: Into<String>> From<S> for Text {
    fn from(text: S) -> Self {
        Self(text.into())
    }
}
