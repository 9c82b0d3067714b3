//! The book's tables of the kinds of elements, generated from the tables used to read scenes.

use jointproof::scene::{Dimension, Fallback, Kind, Use};
use kit::{Served, Table};

/// The tables of every dimension, with the name used in `{{#table name}}`: `kinds-3d`.
pub(crate) fn tables() -> Vec<(String, Vec<Table>)> {
    let mut tables: Vec<(String, Vec<Table>)> = Vec::new();
    for kind in Kind::all() {
        let name = format!("kinds-{}", kind.dimension.name());
        match tables.iter_mut().find(|(known, _)| *known == name) {
            Some((_, tables)) => tables.extend(described(kind)),
            None => tables.push((name, described(kind).into())),
        }
    }
    tables
}

/// The anchor of a kind's tables in the chapter on scenes.
pub(crate) fn anchor(kind: &Kind) -> String {
    format!("{}-{}", kind.name, kind.dimension.name())
}

/// Every output of a kind with each formula that computes it.
pub(crate) fn served() -> Vec<Served> {
    let of_output = |kind: &'static Kind, (output, register): (&str, &str)| -> Vec<Served> {
        let served = |formula: &'static Use| Served {
            formula: formula.id().into(),
            output: output.into(),
            of: match kind.dimension {
                Dimension::Space => kind.name.into(),
                dimension => format!("{} ({})", kind.name, dimension.name()),
            },
            place: format!("scenes.html#{}", anchor(kind)),
        };
        kind.writers(register).map(served).collect()
    };
    Kind::all().flat_map(|kind| kind.outputs().flat_map(move |output| of_output(kind, output))).collect()
}

/// The parameters of a kind, and its outputs with the formulas behind them.
fn described(kind: &'static Kind) -> [Table; 2] {
    let parameter = |(name, fallback): (&str, Fallback)| {
        let without = match fallback {
            Fallback::Required => "asked for".into(),
            Fallback::Number(number) => number.to_string(),
            Fallback::As(other) => format!("`{other}`"),
        };
        vec![format!("`{name}`"), meaning(kind, name), without]
    };
    let load = |name: &str| vec![format!("`{name}`"), meaning(kind, name), "a load, 0 until a frame gives it".into()];
    let output = |(name, register): (&str, &str)| {
        let formulas: Vec<_> = kind.writers(register).map(|formula| format!("`{}`", formula.id())).collect();
        vec![format!("`{name}`"), meaning(kind, register), formulas.join(", ")]
    };
    let head = |names: [&str; 3]| names.map(String::from).into();
    [
        Table {
            anchor: anchor(kind),
            title: format!("`{}`, nodes {}", kind.name, kind.nodes.join(", ")),
            head: head(["Given", "Meaning", "If not given"]),
            rows: kind.parameters().map(parameter).chain(kind.loads().map(load)).collect(),
        },
        Table {
            head: head(["Output", "Meaning", "Formula"]),
            rows: kind.outputs().map(output).collect(),
            ..Table::default()
        },
    ]
}

/// The meaning of a register, and its unit.
fn meaning(kind: &Kind, register: &str) -> String {
    kind.quantity(register).map_or_else(String::new, |quantity| format!("{} ({})", quantity.meaning, quantity.unit))
}
