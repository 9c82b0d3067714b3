//! What the functions of an element give, in every language.

use super::subject::{Output, Shape, placed};
use crate::uel::len;
use jointproof::formula::Field;
use jointproof::toolkit::verify::Layout;

/// The outputs in the order of the results.
pub(super) fn outputs(layout: &Layout, rubs: bool) -> Vec<Output> {
    let [n, m, held] = [layout.unknowns, layout.residuals, layout.multipliers].map(len);
    let after = if rubs { len(layout.state) } else { 0 };
    let all = placed([
        ("residuals", Shape::Vector(m)),
        ("rows", Shape::Matrix(m, n)),
        ("forces", Shape::Vector(n)),
        ("stiffness", Shape::Matrix(n, n)),
        ("by_multipliers", Shape::Matrix(n, held)),
        ("after", Shape::Vector(after)),
    ]);
    all.into_iter().filter(|output| output.len() > 0).collect()
}

/// A line of the head for each output: what its rows and columns are.
pub(super) fn described(layout: &Layout, rubs: bool) -> Vec<String> {
    let Layout { unknowns, forces, residuals, multipliers, state, .. } = layout;
    let line = |output: Output| {
        let what = match output.name {
            "residuals" if multipliers.is_empty() => names(residuals),
            "residuals" => format!("{}, which the multipliers keep at 0", names(residuals)),
            "rows" => format!("derivative of the residuals with respect to {}", names(unknowns)),
            "forces" => format!("on the nodes: {}", names(forces)),
            "stiffness" => "derivative of the forces with respect to the same".to_owned(),
            "by_multipliers" => format!("derivative of the forces with respect to {}", names(multipliers)),
            _ => format!("{} after the step", names(state)),
        };
        let shape = match output.shape {
            Shape::Matrix(rows, columns) => format!("({rows}, {columns})"),
            _ => format!("({})", output.len()),
        };
        format!("out {}{shape} {what}", output.name)
    };
    outputs(layout, rubs).into_iter().map(line).collect()
}

/// Fields with their lengths: `ua(3), ta(3)`.
pub(super) fn names(fields: &[Field]) -> String {
    let name = |field: &Field| match field.len() {
        1 => field.name.to_owned(),
        len => format!("{}({len})", field.name),
    };
    fields.iter().map(name).collect::<Vec<_>>().join(", ")
}
