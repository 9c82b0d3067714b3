//! The scale by which a number of an answer is judged: not by itself alone, but by the vector, row and block that it belongs to.
//!
//! A program that arranges a formula in another way loses digits of small components beside large ones: δ − nnᵀ, u − f/k.

use super::question::{Question, Wanted, sizes};
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::formula::quantity::Unit;

/// The scale of every number at a question, from the right numbers there.
///
/// The scale of an output is the largest component of the outputs of its unit, each with what relative changes of the inputs do
/// to it, and of the inputs of this unit. That of a derivative is the largest entry by inputs of the same unit of these outputs,
/// and the scale of the output divided by the size of these inputs.
pub(super) fn scales(formula: &dyn AnyFormula, wanted: Wanted, question: &Question, right: &[f64]) -> Option<Vec<f64>> {
    let [n, m] = sizes(formula);
    let x = &question.inputs;
    let own;
    let jacobian = if wanted == Wanted::Jacobian {
        &right[m..]
    } else {
        own = formula.value_and_jacobian(x).ok()?.1;
        &own
    };
    let (inputs, outputs) = (placed(formula.inputs()), placed(formula.outputs()));
    let largest = |of: &[f64]| of.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let of_unit = |unit: Unit| {
        let same = inputs.iter().filter(|(field, _)| field.quantity.unit == unit);
        same.map(|(_, start)| start).fold(0.0, |size: f64, places| size.max(largest(&x[places.clone()])))
    };
    let mut scales = vec![0.0; m];
    let mut entries = vec![0.0; m * n];
    let of_row = |i: usize| {
        let row = jacobian[i * n..][..n].iter();
        right[i].abs() + row.zip(x).map(|(slope, x)| (slope * x).abs()).sum::<f64>()
    };
    for (output, rows) in &outputs {
        let alike = |fields: &[(&'static Field, std::ops::Range<usize>)], unit: Unit| -> Vec<usize> {
            fields
                .iter()
                .filter(|(field, _)| field.quantity.unit == unit)
                .flat_map(|(_, places)| places.clone())
                .collect()
        };
        let of_alike = alike(&outputs, output.quantity.unit);
        let size = of_alike.iter().map(|&i| of_row(i)).fold(of_unit(output.quantity.unit), f64::max);
        scales[rows.clone()].fill(size.max(f64::MIN_POSITIVE));
        for (input, columns) in &inputs {
            let by = of_unit(input.quantity.unit);
            let by_alike = alike(&inputs, input.quantity.unit);
            let entry = |i: usize| by_alike.iter().map(|&j| jacobian[i * n + j].abs()).fold(0.0, f64::max);
            let block = of_alike.iter().map(|&i| entry(i)).fold(0.0, f64::max);
            let per = if by > 0.0 { size / by } else { 0.0 };
            for i in rows.clone() {
                entries[i * n..][columns.clone()].fill(block.max(per).max(f64::MIN_POSITIVE));
            }
        }
    }
    match (wanted, &question.directions) {
        (Wanted::Value, _) => {}
        (Wanted::Products, Some([v, w])) => {
            let row = |i: usize| (0..n).map(|j| (entries[i * n + j] * v[j]).abs()).sum::<f64>();
            let column = |j: usize| (0..m).map(|i| (entries[i * n + j] * w[i]).abs()).sum::<f64>();
            scales.extend((0..m).map(row).chain((0..n).map(column)).map(|size| size.max(f64::MIN_POSITIVE)));
        }
        _ => scales.extend(entries),
    }
    scales.iter().all(|scale| scale.is_finite()).then_some(scales)
}

/// Fields with the indices of their components.
pub(super) fn placed(fields: &'static [Field]) -> Vec<(&'static Field, std::ops::Range<usize>)> {
    let mut next = 0;
    let place = |field: &'static Field| {
        let start = next;
        next += field.len();
        (field, start..next)
    };
    fields.iter().map(place).collect()
}
