//! What the book says about the kinds of elements, from the tables that the scenes are read with.

use crate::book::content::{Given, Kind as KindOfElement, Shown};
use jointproof::scene::{Fallback, Kind};

/// Every kind, in the order of the tables.
pub(crate) fn kinds() -> Vec<KindOfElement> {
    Kind::all().map(described).collect()
}

fn described(kind: &'static Kind) -> KindOfElement {
    let parameter = |(name, fallback): (&str, Fallback)| Given {
        name: name.into(),
        meaning: meaning(kind, name),
        without: match fallback {
            Fallback::Required => "asked for".into(),
            Fallback::Number(number) => number.to_string(),
            Fallback::As(other) => format!("`{other}`"),
        },
    };
    let load = |name: &str| Given { name: name.into(), meaning: meaning(kind, name), without: String::new() };
    let output = |&(name, register): &(&str, &str)| Shown {
        name: name.into(),
        meaning: meaning(kind, register),
        formulas: kind.writers(register).map(|formula| formula.id().into()).collect(),
    };
    KindOfElement {
        name: kind.name.into(),
        dimension: kind.dimension.name().into(),
        nodes: kind.nodes.join(", "),
        parameters: kind.parameters().map(parameter).collect(),
        loads: kind.loads().map(load).collect(),
        outputs: kind.outputs.iter().map(output).collect(),
    }
}

/// What a register holds, and its unit.
fn meaning(kind: &Kind, register: &str) -> String {
    kind.quantity(register).map_or_else(String::new, |quantity| format!("{} ({})", quantity.meaning, quantity.unit))
}
