//! Jacobians by differences, to judge automatic differentiation itself.

use super::subject::Subject;
use crate::Octuple;
use crate::formula::Field;
use crate::proof::Proved;
use num_traits::{Signed, Zero};

/// The gradient of every output with respect to input component `k`, by fourth-order central differences in 237 bits:
/// (8(y₊₁ − y₋₁) − (y₊₂ − y₋₂)) / 12h, with h = `step` times the size of the input (where it is 0, of its field or of what has its unit).
///
/// Rounding costs about 2⁻²³⁶/`step` and truncation `step`⁴: at 3e-19 both are far below 1e-50. Near a kink the step
/// must be shorter than the distance to it, and fewer digits remain.
pub fn central_differences<F: Proved>(inputs: &[Octuple], k: usize, step: f64) -> Vec<Octuple> {
    let subject = Subject::of::<F>();
    differences(&subject, inputs, &(subject.exact_value)(inputs), (k, step)).central
}

/// The gradient of every output with respect to an input component.
pub(super) struct Differences {
    /// As [`central_differences`].
    pub(super) central: Vec<Octuple>,
    /// From the point to where the component is smaller, and to where it is larger.
    pub(super) one_sided: [Vec<Octuple>; 2],
}

impl Differences {
    /// The derivatives of an output on both sides.
    pub(super) fn sides_of(&self, output: usize) -> [Octuple; 2] {
        self.one_sided.each_ref().map(|side| side[output])
    }
}

/// Differences of a formula without its types, which has these values `here`, by a component and a step.
pub(super) fn differences(
    subject: &Subject,
    inputs: &[Octuple],
    here: &[Octuple],
    (k, step): (usize, f64),
) -> Differences {
    let h = step_size(subject.inputs, inputs, k) * step;
    let shifted = |steps: f64| -> Vec<Octuple> {
        let mut moved = inputs.to_vec();
        if let Some(x) = moved.get_mut(k) {
            *x += h * steps;
        }
        (subject.exact_value)(&moved)
    };
    let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(shifted);
    let near = above.iter().zip(&below).map(|(&above, &below)| (above - below) * 8.0);
    let far = far_above.iter().zip(&far_below).map(|(&above, &below)| above - below);
    let central = near.zip(far).map(|(near, far)| (near - far) / (h * 12.0)).collect();
    let from =
        |values: &[Octuple], sign: f64| values.iter().zip(here).map(|(&y, &here)| (y - here) / (h * sign)).collect();
    Differences { central, one_sided: [from(&below, -1.0), from(&above, 1.0)] }
}

/// The largest number of the field of the k-th component.
pub(super) fn largest_of_field(fields: &[Field], numbers: &[Octuple], k: usize) -> Octuple {
    let field_of = fields.iter().enumerate().flat_map(|(f, field)| vec![f; field.len()]);
    let fields: Vec<_> = field_of.collect();
    let same = numbers.iter().zip(&fields).filter(|(_, field)| fields.get(k) == Some(*field));
    same.fold(Octuple::zero(), |largest, (x, _)| if x.abs() > largest { x.abs() } else { largest })
}

/// |x|, or the largest of its field where x is 0, or the largest of its unit where the whole field is 0, or 1.
pub(super) fn step_size(fields: &[Field], inputs: &[Octuple], k: usize) -> Octuple {
    if let Some(own) = inputs.get(k).map(Signed::abs).filter(|own| !own.is_zero()) {
        return own;
    }
    let field_of: Vec<_> = fields.iter().enumerate().flat_map(|(f, field)| vec![f; field.len()]).collect();
    let largest_where = |counts: &dyn Fn(usize) -> bool| {
        let sizes = inputs.iter().zip(&field_of).filter(|(_, field)| counts(**field)).map(|(x, _)| x.abs());
        sizes.fold(Octuple::zero(), |largest, x| if x > largest { x } else { largest })
    };
    let Some(&field) = field_of.get(k) else { return Octuple::from(1.0) };
    let unit = |f: usize| fields[f].quantity.unit;
    let candidates = [largest_where(&|f| f == field), largest_where(&|f| unit(f) == unit(field))];
    candidates.into_iter().find(|size| !size.is_zero()).unwrap_or_else(|| Octuple::from(1.0))
}
