//! Jacobians by finite differences in `f64`, as in programs without derivatives.

use crate::formula::{Array, from_array, jacobian_of, no_rows, to_array};
use crate::formula::{Fields, Formula, ValueAndJacobian};
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
    /// All schemes.
    pub const ALL: [Self; 3] = [Self::Forward, Self::Central, Self::Fourth];

    /// The identifier of the method.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Central => "central",
            Self::Fourth => "fourth",
        }
    }

    /// The title of the method.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Forward => "forward differences",
            Self::Central => "central differences",
            Self::Fourth => "fourth-order differences",
        }
    }

    /// Value and Jacobian of `F`. The step is the difference of two doubles.
    #[inline]
    pub(super) fn value_and_jacobian<F: Formula>(
        self,
        relative_step: f64,
        i: &F::Inputs<f64>,
    ) -> ValueAndJacobian<F, f64> {
        by_columns::<F>(relative_step, i, |x, k, step, here| self.column::<F>(x, k, step, here))
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
        // The step actually taken after rounding.
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

/// Value and Jacobian of `F`, one input component after the other: `column` gives the derivatives with respect to component `k`. The
/// step is `relative_step` times the size of the field to which the component belongs, or times 1 if that is zero.
#[inline]
pub(super) fn by_columns<F: Formula>(
    relative_step: f64,
    i: &F::Inputs<f64>,
    column: impl Fn(&mut Array<F::Inputs<f64>>, usize, f64, &F::Outputs<f64>) -> Array<F::Outputs<f64>>,
) -> ValueAndJacobian<F, f64> {
    let mut x = to_array(i);
    let here = F::eval(i);
    let mut rows = no_rows::<F, f64>();
    let mut k = 0;
    for field in F::Inputs::<f64>::FIELDS {
        let end = k + field.len();
        let size = x.as_ref()[k..end].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let step = relative_step * if size == 0.0 { 1.0 } else { size };
        while k < end {
            let column = column(&mut x, k, step, &here);
            let entries = rows.as_mut().iter_mut().map(|row| &mut row.as_mut()[k]);
            entries.zip(column.as_ref()).for_each(|(entry, &derivative)| *entry = derivative);
            k += 1;
        }
    }
    (here, jacobian_of::<F, f64>(&rows))
}

/// A separate call, as for a formula in another library; and compiled once, not once per term of every scheme.
#[inline(never)]
fn evaluate<F: Formula>(x: &Array<F::Inputs<f64>>) -> F::Outputs<f64> {
    F::eval(&from_array(x))
}

/// Applies a function of several outputs component by component.
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
    use crate::Scalar;
    use crate::connector::slot::{ContactForce, CrossForces};
    use crate::fields;
    use crate::formula::quantity::{Domain, Quantity, Shape, Unit};
    use crate::formula::{Component, Document, Jacobian, Spec};
    use nalgebra::Vector2;

    const P: Quantity = Quantity::new("p", Shape::Vec2, Unit::ONE, Domain::Real, "two numbers");
    const Q: Quantity = Quantity::scalar("q", Unit::ONE, Domain::Real, "another");
    const Y: Quantity = Quantity::new("y", Shape::Vec2, Unit::ONE, Domain::Real, "squares");
    fields! { struct Inputs<T> { p: Vector2<T> = P, q: T = Q } }
    fields! { struct Outputs<T> { y: Vector2<T> = Y } }

    #[derive(Clone, Copy)]
    struct Squares;

    impl Formula for Squares {
        const SPEC: Spec = Spec::new("t.squares", "Squares", Document::new("Squares").printed(""));
        type Inputs<T: Component> = Inputs<T>;
        type Outputs<T: Component> = Outputs<T>;
        fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
            Outputs { y: Vector2::new(i.p.x * i.p.x - i.p.y, i.p.y * i.q * i.q) }
        }
        fn jacobian<D: Scalar>(i: &Inputs<D>) -> Jacobian<Self, D> {
            let (zero, one) = (D::zero(), D::one());
            let first = Inputs { p: Vector2::new(i.p.x * 2.0, -one), q: zero };
            let second = Inputs { p: Vector2::new(zero, i.q * i.q), q: i.p.y * i.q * 2.0 };
            Outputs { y: Vector2::new(first, second) }
        }
    }

    /// For a square, the error of the forward difference is the step itself, a fraction of the largest component of
    /// its input: all is exact.
    #[test]
    fn a_step_is_a_part_of_the_largest_component_of_an_input() {
        let entries =
            |jacobian: &Jacobian<Squares, f64>| [jacobian.y.x, jacobian.y.y].map(|row| [row.p.x, row.p.y, row.q]);
        let forward = |p: [f64; 2], q: f64| {
            let inputs = Inputs { p: p.into(), q };
            let (value, jacobian) = Scheme::Forward.value_and_jacobian::<Squares>(0.25, &inputs);
            ([value.y.x, value.y.y], entries(&jacobian))
        };
        // Steps of 1 and 2.
        let large = [[-8.0 + 1.0, -1.0, 0.0], [0.0, 64.0, -32.0 + 2.0 * 2.0]];
        assert_eq!(forward([-4.0, 2.0], -8.0), ([14.0, 128.0], large));
        // Steps of 1/8 and 1/16.
        let small = [[0.5 + 0.125, -1.0, 0.0], [0.0, 0.0625, -0.25 - 0.5 * 0.0625]];
        assert_eq!(forward([0.25, -0.5], 0.25), ([0.5625, -0.03125], small));
        // At 0 the step is a quarter.
        assert_eq!(forward([0.0, 0.0], 0.0), ([0.0, 0.0], [[0.25, -1.0, 0.0], [0.0; 3]]));
        for scheme in [Scheme::Central, Scheme::Fourth] {
            let inputs = Inputs { p: Vector2::new(-4.0, 2.0), q: -8.0 };
            let (_, found) = scheme.value_and_jacobian::<Squares>(0.25, &inputs);
            assert_eq!(entries(&found), entries(&Squares::jacobian(&inputs)), "{scheme:?}");
        }
    }

    /// The truncation error decreases with the order of the scheme: h, h², h⁴.
    #[test]
    fn every_scheme_has_its_order() {
        let i = CrossForces { f2: 3.0, f3: 4.0 };
        let error = |scheme: Scheme, step| (scheme.value_and_jacobian::<ContactForce>(step, &i).1.fc.f2 - 0.6).abs();
        for (scheme, order) in Scheme::ALL.into_iter().zip([1, 2, 4]) {
            // At smaller steps, rounding becomes visible in the fourth-order scheme.
            let gain = error(scheme, 1e-1) / error(scheme, 1e-2);
            let expected = 10.0_f64.powi(order);
            assert!((0.5 * expected..2.0 * expected).contains(&gain), "{}: {gain}", scheme.id());
        }
    }
}
