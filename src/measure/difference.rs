//! Jacobians by differences in `f64`, as a program without derivatives computes them.

use crate::formula::{Fields, Formula, ValueAndJacobian};
use crate::proof::{Array, from_array, jacobian_of, no_rows, to_array};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A scheme of differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Scheme {
    /// (f(x + h) − f(x)) / h: one more evaluation an input.
    Forward,
    /// (f(x + h) − f(x − h)) / 2h: two evaluations an input.
    Central,
    /// (8(f(x + h) − f(x − h)) − (f(x + 2h) − f(x − 2h))) / 12h: four evaluations an input.
    Fourth,
}

impl Scheme {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Forward, Self::Central, Self::Fourth];

    /// The identifier of the way.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Central => "central",
            Self::Fourth => "fourth",
        }
    }

    /// What it is.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Forward => "forward differences",
            Self::Central => "central differences",
            Self::Fourth => "fourth-order differences",
        }
    }

    /// Value and Jacobian of `F`. The step is `relative_step` times the size of the field that an input belongs to, or
    /// times 1 where that is zero, and a difference of two doubles.
    #[inline]
    pub(super) fn value_and_jacobian<F: Formula>(
        self,
        relative_step: f64,
        i: &F::Inputs<f64>,
    ) -> ValueAndJacobian<F, f64> {
        let mut x = to_array(i);
        let here = F::eval(i);
        let mut rows = no_rows::<F>();
        let mut k = 0;
        for field in F::Inputs::<f64>::FIELDS {
            let end = k + field.len();
            let size = x.as_ref()[k..end].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            let step = relative_step * if size == 0.0 { 1.0 } else { size };
            while k < end {
                let column = self.column::<F>(&mut x, k, step, &here);
                let entries = rows.as_mut().iter_mut().map(|row| &mut row.as_mut()[k]);
                entries.zip(column.as_ref()).for_each(|(entry, &derivative)| *entry = derivative);
                k += 1;
            }
        }
        (here, jacobian_of::<F>(&rows))
    }

    /// The derivatives with respect to input component `k`.
    #[inline]
    fn column<F: Formula>(
        self,
        x: &mut Array<F::Inputs<f64>>,
        k: usize,
        step: f64,
        here: &F::Outputs<f64>,
    ) -> Array<F::Outputs<f64>> {
        let at = x.as_ref()[k];
        // What is added to `at` indeed.
        let h = (at + step) - at;
        let mut value = |moved: f64| {
            x.as_mut()[k] = moved;
            evaluate::<F>(x)
        };
        let column = match self {
            Self::Forward => combine::<F, 2>([&value(at + h), here], |[above, below]| (above - below) / h),
            Self::Central => {
                combine::<F, 2>([&value(at + h), &value(at - h)], |[above, below]| (above - below) / (2.0 * h))
            }
            Self::Fourth => combine::<F, 4>(
                [&value(at + h), &value(at - h), &value(at + 2.0 * h), &value(at - 2.0 * h)],
                |[above, below, far_above, far_below]| (8.0 * (above - below) - (far_above - far_below)) / (12.0 * h),
            ),
        };
        x.as_mut()[k] = at;
        column
    }
}

/// A call of its own, as it is where the formula is somebody else's; and compiled once, not once a term of every scheme.
#[inline(never)]
fn evaluate<F: Formula>(x: &Array<F::Inputs<f64>>) -> F::Outputs<f64> {
    F::eval(&from_array(x))
}

/// One function of several outputs, component by component.
#[inline]
fn combine<F: Formula, const N: usize>(
    outputs: [&F::Outputs<f64>; N],
    function: impl Fn([f64; N]) -> f64,
) -> Array<F::Outputs<f64>> {
    let parts = outputs.map(to_array);
    let mut result = F::Outputs::array_of(0.0);
    for (k, result) in result.as_mut().iter_mut().enumerate() {
        *result = function(parts.each_ref().map(|part| part.as_ref()[k]));
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slot::{ContactForce, CrossForces};

    /// Truncation falls with the order of the scheme: h, h², h⁴.
    #[test]
    fn every_scheme_has_its_order() {
        let i = CrossForces { f2: 3.0, f3: 4.0 };
        let error = |scheme: Scheme, step| (scheme.value_and_jacobian::<ContactForce>(step, &i).1.fc.f2 - 0.6).abs();
        for (scheme, order) in Scheme::ALL.into_iter().zip([1, 2, 4]) {
            // At smaller steps the rounding of the fourth order shows.
            let gain = error(scheme, 1e-1) / error(scheme, 1e-2);
            let expected = 10.0_f64.powi(order);
            assert!((0.5 * expected..2.0 * expected).contains(&gain), "{}: {gain}", scheme.id());
        }
    }
}
