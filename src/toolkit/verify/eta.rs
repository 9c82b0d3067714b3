//! The error measures.

use crate::Octuple;
use crate::formula::Field;
use num_dual::DualNum;
use num_traits::{Signed, Zero};

/// Unit roundoff of `f64`, 2⁻⁵³.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// Σ |∂y/∂xᵢ · xᵢ|: the change of y caused by a relative change of 1 in every input.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivity(Octuple);

impl Sensitivity {
    /// From the gradient of y and the inputs.
    pub fn new(gradient: &[Octuple], inputs: &[Octuple]) -> Self {
        let terms = gradient.iter().zip(inputs).map(|(&g, &x)| (g * x).abs());
        Self(terms.fold(Octuple::zero(), |sum, term| sum + term))
    }

    /// The same by whole vectors, Σ |∂y/∂x| |x| over the fields x: the change of y where each vector changes by its size in the worst
    /// direction. It does not depend on the axes.
    pub(crate) fn by_fields(fields: &[Field], gradient: &[Octuple], inputs: &[Octuple]) -> Self {
        let length = |all: &[Octuple]| all.iter().fold(Octuple::zero(), |sum, &x| sum + x * x).sqrt();
        let terms = Field::ranges(fields).map(|range| length(&gradient[range.clone()]) * length(&inputs[range]));
        Self(terms.fold(Octuple::zero(), |sum, term| sum + term))
    }

    /// For a number that depends on no input.
    pub(crate) fn none() -> Self {
        Self(Octuple::zero())
    }

    /// The sum with |y| itself.
    #[must_use]
    pub fn plus(self, y: Octuple) -> Self {
        Self(self.0 + y.abs())
    }

    /// For this number multiplied by a factor.
    pub(super) fn times(self, factor: f64) -> Self {
        Self((self.0 * factor).abs())
    }

    /// An upper bound for the sum of this number and another one.
    pub(super) fn and(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }

    /// The sum itself.
    pub(crate) fn size(self) -> Octuple {
        self.0
    }

    /// The deviation relative to this; 0 if there is none, ∞ if it is NaN.
    pub fn share_of(self, deviation: Octuple) -> f64 {
        if deviation.is_zero() {
            return 0.0;
        }
        let share = (deviation.abs() / self.0).to_f64();
        if share.is_nan() { f64::INFINITY } else { share }
    }

    /// Divided by the size of an input.
    pub fn per(self, size: Octuple) -> Octuple {
        self.0 / size
    }
}

/// Backward error of a computed number in units of u = 2⁻⁵³: η = |ŷ − y| / (u (Σᵢ |∂y/∂xᵢ · xᵢ| + |y|)).
///
/// An algorithm with a small η is as accurate as its inputs allow, however ill-conditioned the problem is. Half the
/// smallest subnormal is added to the denominator, since no double is closer to an exact result than that. A computed
/// NaN has η = ∞.
pub fn eta(computed: f64, exact: Octuple, sensitivity: Sensitivity) -> f64 {
    eta_beside(computed, exact, sensitivity.plus(exact))
}

/// The same for a number judged by the size of another one, |y| plus its sensitivity.
pub(super) fn eta_beside(computed: f64, exact: Octuple, other: Sensitivity) -> f64 {
    let deviation = (Octuple::from(computed) - exact).abs();
    if deviation.is_zero() && !other.0.is_nan() {
        return 0.0;
    }
    // The smallest subnormal, 2⁻¹⁰⁷⁴.
    let underflow = Octuple::from(f64::from_bits(1));
    let unit = other.0 * U + underflow * 0.5;
    let eta = (deviation / unit).to_f64();
    if eta.is_nan() { f64::INFINITY } else { eta }
}

/// How exactly a derivative is known that was computed in 237 bits in two ways: along a vector whose length does not matter it is 0, and
/// in 237 bits a rounding of the largest in its row. Two ways that are further apart than that are no roundings of each other.
pub(super) fn rounding(one: Octuple, other: Octuple, largest: Octuple) -> Octuple {
    let off = (one - other).abs();
    if off <= largest * (-200.0_f64).exp2() { off * 4.0 } else { Octuple::zero() }
}

/// Whether a computed number cannot be told from the exact one, as that and its sensitivity are known no better.
pub(super) fn is_rounding(computed: f64, exact: Octuple, sensitivity: Sensitivity, rounding: Octuple) -> bool {
    (Octuple::from(computed) - exact).abs() <= rounding && sensitivity.size() <= rounding * 20.0_f64.exp2()
}

/// |a − b| / max(|a|, |b|); 0 for two zeros, ∞ where one is NaN.
pub fn relative(a: Octuple, b: Octuple) -> f64 {
    let difference = (a - b).abs();
    if difference.is_zero() {
        return 0.0;
    }
    let largest = if a.abs() > b.abs() { a.abs() } else { b.abs() };
    let relative = (difference / largest).to_f64();
    if relative.is_nan() { f64::INFINITY } else { relative }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_relative_difference_is_of_the_larger_size() {
        for (a, b, expected) in [(-1.0, -2.0, 0.5), (-2.0, -1.0, 0.5), (1.0, -1.0, 2.0), (0.0, 0.0, 0.0)] {
            assert_eq!(relative(a.into(), b.into()), expected);
        }
        assert_eq!(relative(f64::NAN.into(), 1.0.into()), f64::INFINITY);
    }

    /// For x y at (3, −4), whose gradient is (−4, 3).
    fn of_product() -> Sensitivity {
        Sensitivity::new(&[-4.0, 3.0].map(Octuple::from), &[3.0, -4.0].map(Octuple::from))
    }

    #[test]
    fn a_sensitivity_is_the_sum_of_what_each_input_does() {
        assert_eq!(of_product().size(), 24.0);
        assert_eq!(of_product().plus((-2.0).into()).size(), 26.0);
        assert_eq!(of_product().times(-0.5).size(), 12.0);
        assert_eq!(of_product().and(of_product().times(2.0)).size(), 72.0);
        assert_eq!(of_product().per(8.0.into()), 3.0);
        assert_eq!(Sensitivity::none().size(), 0.0);
    }

    /// |(−4, 3)| |(3, −4)| for a vector, 12 + 12 for two numbers.
    #[test]
    fn a_sensitivity_to_a_vector_does_not_depend_on_its_components() {
        use crate::formula::quantity::{F2, XA_PLANE};
        let size = |fields: &[Field]| {
            let [gradient, inputs] = [[-4.0, 3.0], [3.0, -4.0]].map(|all| all.map(Octuple::from));
            Sensitivity::by_fields(fields, &gradient, &inputs).size()
        };
        assert_eq!(size(&[Field::new("x", &XA_PLANE)]), 25.0);
        assert_eq!(size(&[Field::new("f", &F2), Field::new("g", &F2)]), 24.0);
    }

    #[test]
    fn a_share_is_relative_but_of_nothing_and_of_what_is_no_number() {
        let share_of = |deviation: f64| of_product().share_of(deviation.into());
        assert_eq!([6.0, -12.0, 0.0, f64::NAN].map(share_of), [0.25, 0.5, 0.0, f64::INFINITY]);
        assert_eq!([0.0, 1.0].map(|x| Sensitivity::none().share_of(x.into())), [0.0, f64::INFINITY]);
    }

    #[test]
    fn a_backward_error_is_in_roundings_of_the_number_and_of_its_inputs() {
        let (one, twice) = (Octuple::from(1.0), 1.0 + 2.0 * U);
        let eta_of = |computed, exact, size: f64| eta(computed, exact, Sensitivity::none().plus(size.into()));
        assert_eq!((eta_of(twice, one, 0.0), eta_of(twice, one, 3.0)), (2.0, 0.5));
        assert_eq!((eta_of(-twice, -one, 0.0), eta_of(1.0, one * twice, 0.0)), (2.0, 2.0 / twice));
        assert_eq!(eta_of(f64::NAN, one, 0.0), f64::INFINITY);
    }

    /// No double is nearer to half of the smallest one than 0 and the smallest one.
    #[test]
    fn a_backward_error_at_nothing_is_in_halves_of_the_smallest_double() {
        let smallest = f64::from_bits(1);
        let eta_of = |computed, exact| eta(computed, exact, Sensitivity::none());
        assert_eq!(eta_of(0.0, 0.0.into()), 0.0);
        assert_eq!(eta_of(smallest, 0.0.into()), 2.0);
        assert!((eta_of(0.0, Octuple::from(smallest) * 0.5) - 1.0).abs() < 1e-15);
    }
}
