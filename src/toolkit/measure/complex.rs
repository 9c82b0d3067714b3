//! Jacobians by the complex step, as in programs that are compiled for complex numbers.

use super::difference::by_columns;
use crate::formula::{Fields, Formula, ValueAndJacobian, from_array, to_array};
use crate::number::newtype::{newtype_dual_num, newtype_number};
use crate::number::scalar::{Scalar, norm, sum_of_squares};
use num_dual::DualNum;
use num_traits::FromPrimitive;
use std::fmt;
use std::str::FromStr;

type Number = nalgebra::Complex<f64>;

/// The imaginary part relative to the size of the field. Its square vanishes beside 1, so there is no truncation error.
const STEP: f64 = 1e-100;

/// A complex number in place of a real one: its imaginary part is the step times a derivative.
///
/// Sums, products, quotients and square roots are complex. Comparisons look at the real part, so that branches and the absolute
/// value are those of real numbers. All other functions are exact to first order in the imaginary part: the two-argument angle
/// is not analytic, and the usual complex arc functions lose small imaginary parts.
#[derive(Clone, Copy, Debug)]
struct Step(Number);

/// Value and Jacobian of `F`: one complex evaluation for each input.
pub(super) fn value_and_jacobian<F: Formula>(i: &F::Inputs<f64>) -> ValueAndJacobian<F, f64> {
    by_columns::<F>(STEP, i, |x, k, step, _| {
        let mut stepped = F::Inputs::array_of(Step::ZERO);
        for (stepped, &x) in stepped.as_mut().iter_mut().zip(x.as_ref()) {
            *stepped = Step::from(x);
        }
        stepped.as_mut()[k].0.im = step;
        let complex = to_array(&F::eval(&from_array(&stepped)));
        let mut column = F::Outputs::array_of(0.0);
        for (derivative, y) in column.as_mut().iter_mut().zip(complex.as_ref()) {
            *derivative = y.0.im / step;
        }
        column
    })
}

newtype_number!(Step(Number), zero: Number::ZERO, one: Number::ONE, rem: ::std::ops::Rem::rem);
newtype_dual_num!(Step, functions);

impl Step {
    fn to_f64(self) -> f64 {
        self.0.re
    }
}

/// What the shared operators ask of a float.
trait Signs {
    fn abs(self) -> Self;
    fn signum(self) -> Self;
    fn is_sign_positive(&self) -> bool;
    fn is_sign_negative(&self) -> bool;
}

impl Signs for Number {
    fn abs(self) -> Self {
        self.scale(self.re.signum())
    }
    fn signum(self) -> Self {
        self.re.signum().into()
    }
    fn is_sign_positive(&self) -> bool {
        self.re.is_sign_positive()
    }
    fn is_sign_negative(&self) -> bool {
        self.re.is_sign_negative()
    }
}

/// The elementary functions.
mod functions {
    use super::Number;
    use crate::number::scalar;
    use num_dual::{Dual64, DualNum};

    fn first_order(x: Number, function: impl FnOnce(Dual64) -> Dual64) -> Number {
        let Dual64 { re, eps, .. } = function(Dual64::new(x.re, x.im));
        Number::new(re, eps)
    }

    macro_rules! first_order {
        ($($function:ident)*) => {
            $(pub(super) fn $function(x: Number) -> Number {
                first_order(x, |x| DualNum::$function(&x))
            })*
        };
    }

    first_order!(cbrt exp exp2 exp_m1 ln log2 log10 ln_1p sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh);

    pub(super) fn recip(x: Number) -> Number {
        x.inv()
    }
    pub(super) fn sqrt(x: Number) -> Number {
        x.sqrt()
    }
    pub(super) fn powi(x: Number, n: i32) -> Number {
        first_order(x, |x| DualNum::powi(&x, n))
    }
    pub(super) fn powf(x: Number, n: Number) -> Number {
        first_order(x, |x| DualNum::powd(&x, Dual64::new(n.re, n.im)))
    }
    pub(super) fn log(x: Number, base: Number) -> Number {
        first_order(x, |x| DualNum::log(&x, base.re))
    }
    pub(super) fn sin_cos(x: Number) -> (Number, Number) {
        (sin(x), cos(x))
    }
    pub(super) fn atan2(y: Number, x: Number) -> Number {
        first_order(y, |y| scalar::atan2(y, Dual64::new(x.re, x.im)))
    }
    pub(super) fn mul_add(x: Number, factor: Number, addend: Number) -> Number {
        x * factor + addend
    }
}

impl PartialEq for Step {
    fn eq(&self, other: &Self) -> bool {
        self.0.re == other.0.re
    }
}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.0.re.partial_cmp(&other.0.re)
    }
}

impl From<f64> for Step {
    fn from(re: f64) -> Self {
        Self(re.into())
    }
}

impl FromPrimitive for Step {
    fn from_i64(n: i64) -> Option<Self> {
        f64::from_i64(n).map(Self::from)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f64::from_u64(n).map(Self::from)
    }
    /// The default would go through an integer.
    fn from_f64(value: f64) -> Option<Self> {
        Some(value.into())
    }
}

impl FromStr for Step {
    type Err = std::num::ParseFloatError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        text.parse::<f64>().map(Self::from)
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl Scalar for Step {
    type Leaf = f64;
    const ZERO: Self = Self(Number::ZERO);
    const ONE: Self = Self(Number::ONE);
    const MINUS_ONE: Self = Self(Number::new(-1.0, 0.0));
    fn leaf_of(x: Self) -> f64 {
        x.0.re
    }
    fn constant_of(x: f64) -> Self {
        x.into()
    }
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        if norm(x.map(Self::leaf_of)) == 0.0 { Self::ZERO } else { Self(sum_of_squares(x).0.sqrt()) }
    }
    fn angle_of(y: Self, x: Self) -> Self {
        DualNum::atan2(&y, x)
    }
}

#[cfg(test)]
mod tests {
    use super::value_and_jacobian;
    use crate::connector::slot::{ContactForce, CrossForces};
    use crate::formula::entries;

    #[test]
    fn no_digit_is_lost_to_the_step() {
        let (value, jacobian) = value_and_jacobian::<ContactForce>(&CrossForces { f2: 3.0, f3: 4.0 });
        assert_eq!(value.fc, 5.0);
        for (found, exact) in entries(&jacobian).into_iter().zip([0.6, 0.8]) {
            assert!((found - exact).abs() <= f64::EPSILON, "{found}");
        }
    }

    /// The convention at a kink, where a square root alone would divide by 0.
    #[test]
    fn a_vanishing_length_has_no_derivative() {
        let (_, jacobian) = value_and_jacobian::<ContactForce>(&CrossForces { f2: 0.0, f3: 0.0 });
        assert_eq!(entries(&jacobian), [0.0, 0.0]);
    }
}
