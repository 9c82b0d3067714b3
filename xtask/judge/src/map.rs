//! A map of an answer that shows which numbers are right.

use super::question::Wanted;
use super::verdict::Grade;
use crate::console::{green, red, yellow};
use jointproof::formula::Field;
use std::fmt::Write;

/// The names of all numbers of an answer: outputs, then entries of the Jacobian or products.
pub(super) fn names(inputs: &[Field], outputs: &[Field], wanted: Wanted) -> Vec<String> {
    let (inputs, outputs) = (components(inputs), components(outputs));
    let more: Vec<_> = match wanted {
        Wanted::Value => Vec::new(),
        Wanted::Jacobian => outputs.iter().flat_map(|y| inputs.iter().map(move |x| format!("∂{y}/∂{x}"))).collect(),
        Wanted::Products => {
            let products = outputs.iter().map(|y| format!("(J v) of {y}"));
            products.chain(inputs.iter().map(|x| format!("(wᵀJ) of {x}"))).collect()
        }
    };
    outputs.iter().cloned().chain(more).collect()
}

/// The names of the components of fields: `fc`, `e1a[0]`.
pub fn components(fields: &[Field]) -> Vec<String> {
    let of_field = |field: &Field| match field.len() {
        1 => vec![field.name.to_owned()],
        len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
    };
    fields.iter().flat_map(of_field).collect()
}

/// The mark of a number; `None` if it was never given.
fn mark(grade: Option<Grade>) -> String {
    match grade {
        None => "-".into(),
        Some(Grade::Right) => green("+"),
        Some(Grade::Inaccurate) => yellow("~"),
        Some(Grade::Wrong) => red("x"),
    }
}

/// One line per output: its value, then its derivatives, field by field.
pub(super) fn map(inputs: &[Field], outputs: &[Field], wanted: Wanted, grades: &[Option<Grade>]) -> String {
    let (rows, width) = (components(outputs), components(inputs).len());
    let (values, rest) = grades.split_at(rows.len().min(grades.len()));
    let name = rows.iter().map(String::len).max().unwrap_or_default();
    let mut text = String::new();
    for (k, (row, value)) in rows.iter().zip(values).enumerate() {
        let marks = match wanted {
            Wanted::Value => String::new(),
            Wanted::Jacobian => format!(" | {}", by_field(inputs, &rest[k * width..][..width])),
            Wanted::Products => format!(" | {}", mark(rest[k])),
        };
        let _ = writeln!(text, "    {row:name$} {}{marks}", mark(*value));
    }
    if wanted == Wanted::Products {
        let _ = writeln!(text, "    {:name$}   | {}", "wᵀJ", by_field(inputs, &rest[rows.len()..]));
    }
    if wanted != Wanted::Value {
        let fields: Vec<_> = inputs.iter().map(|field| field.name).collect();
        let _ = writeln!(text, "    {:name$}     {}", "by", fields.join(" "));
    }
    text
}

/// The marks of a row, with a gap between fields.
fn by_field(fields: &[Field], grades: &[Option<Grade>]) -> String {
    let mut rest = grades.iter().copied();
    let of_field = |field: &Field| rest.by_ref().take(field.len()).map(mark).collect::<String>();
    fields.iter().map(of_field).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_tell_what_was_not_given_from_what_is_right() {
        assert_eq!(mark(None), "-");
        let marks = [Grade::Right, Grade::Inaccurate, Grade::Wrong].map(|grade| mark(Some(grade)));
        assert_eq!(marks, [green("+"), yellow("~"), red("x")]);
    }
}
