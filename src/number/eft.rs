//! Error-free transformations: sums and products together with their rounding errors.
//!
//! The rounding error of a sum or a product of two numbers is itself such a number, and a few operations compute it.
//! Where terms cancel, these errors are all that is left. A [`Pair`] carries them along, which doubles the digits; an
//! [`Expansion`] keeps all of them, so that its sum and the sign of the sum are exact.
//!
//! This holds in every binary arithmetic that rounds to nearest, whatever its precision, as long as nothing over- or
//! underflows; scaling is up to the caller. Fused multiply-add is not used: not every processor has it, and emulating
//! it takes longer than everything here.
//!
//! - T. J. Dekker, *A floating-point technique for extending the available precision*, Numerische Mathematik 18 (1971)
//! - D. E. Knuth, *The Art of Computer Programming*, volume 2, section 4.2.2
//! - J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, Discrete &
//!   Computational Geometry 18 (1997)
//! - T. Ogita, S. M. Rump, S. Oishi, *Accurate sum and dot product*, SIAM Journal on Scientific Computing 26 (2005)

use crate::number::power::power_of_two;
use crate::number::scalar::Leaf;
use arrayvec::ArrayVec;
use std::ops::{Add, Mul, Neg, Sub};

/// The number high + low, where low is small compared with the terms that high was summed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pair<L> {
    pub(crate) high: L,
    pub(crate) low: L,
}

impl<L: Leaf> Pair<L> {
    /// a + b, exactly (Knuth's TwoSum).
    #[inline]
    pub(crate) fn sum(a: L, b: L) -> Self {
        let high = a + b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// a − b, exactly.
    #[inline]
    pub(crate) fn difference(a: L, b: L) -> Self {
        Self::sum(a, -b)
    }

    /// a b, exactly (Dekker's TwoProduct).
    #[inline]
    pub(crate) fn product(a: L, b: L) -> Self {
        let high = a * b;
        let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
        Self { high, low: a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2) }
    }

    /// The absolute value.
    #[inline]
    pub(crate) fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    /// The rounded value.
    #[inline]
    pub(crate) fn value(self) -> L {
        self.high + self.low
    }
}

/// Splits a number into a sum of two with half its digits each (Veltkamp), so that products of the parts are exact.
#[inline]
fn halves<L: Leaf>(x: L) -> [L; 2] {
    let large = x * const { half_of_digits(L::EPSILON) } + x;
    let high = large - (large - x);
    [high, x - high]
}

/// 2^⌈p/2⌉ for numbers of p digits, with ε = 2^(1 − p).
const fn half_of_digits(epsilon: f64) -> f64 {
    let mut exponent = 0;
    while power_of_two(2 * exponent) * epsilon < 2.0 {
        exponent += 1;
    }
    power_of_two(exponent)
}

impl<L: Leaf> From<L> for Pair<L> {
    #[inline]
    fn from(high: L) -> Self {
        Self { high, low: L::zero() }
    }
}

impl<L: Leaf> Neg for Pair<L> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

/// Accurate to twice the digits of the numbers, relative to the sizes of the terms.
impl<L: Leaf> Add for Pair<L> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let Self { high, low } = Self::sum(self.high, other.high);
        Self { high, low: low + (self.low + other.low) }
    }
}

impl<L: Leaf> Sub for Pair<L> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Accurate to twice the digits of the numbers.
impl<L: Leaf> Mul<L> for Pair<L> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: L) -> Self {
        let Self { high, low } = Self::product(self.high, factor);
        Self { high, low: low + self.low * factor }
    }
}

/// An exact sum of at most N numbers, kept as non-overlapping non-zero parts, smallest first.
#[derive(Clone, Debug)]
pub(crate) struct Expansion<L, const N: usize>(ArrayVec<L, N>);

impl<L: Leaf, const N: usize> Expansion<L, N> {
    pub(crate) fn new() -> Self {
        Self(ArrayVec::new())
    }

    /// Adds a number (Shewchuk's Grow-Expansion, zeros left out).
    pub(crate) fn add(&mut self, x: L) {
        if x == 0.0 {
            return;
        }
        let (mut carried, mut kept) = (x, 0);
        for k in 0..self.0.len() {
            let Pair { high, low } = Pair::sum(carried, self.0[k]);
            carried = high;
            if low != 0.0 {
                self.0[kept] = low;
                kept += 1;
            }
        }
        self.0.truncate(kept);
        if carried != 0.0 {
            self.0.push(carried);
        }
    }

    /// Adds the product a b, which is a sum of two numbers.
    pub(crate) fn add_product(&mut self, a: L, b: L) {
        if a != 0.0 && b != 0.0 {
            let Pair { high, low } = Pair::product(a, b);
            self.add(low);
            self.add(high);
        }
    }

    /// Adds a multiple of another sum: two numbers for each of its parts.
    pub(crate) fn add_multiple<const M: usize>(&mut self, sum: &Expansion<L, M>, factor: L) {
        for &part in &sum.0 {
            self.add_product(part, factor);
        }
    }

    /// The rounded value. It is 0 only if the sum is 0, and has the right sign, since the last part is larger than all
    /// others together.
    pub(crate) fn value(&self) -> L {
        self.0.iter().fold(L::zero(), |sum, &part| sum + part)
    }
}

/// A sum of products of four numbers each, of the right sign: products and sum are exact, and rounded once at the end.
pub(crate) fn exact_sum<L: Leaf>(products: impl IntoIterator<Item = [L; 4]>) -> L {
    let mut sum = Expansion::<L, 144>::new();
    for [a, b, c, d] in products {
        let mut two = Expansion::<L, 2>::new();
        two.add_product(a, b);
        let mut three = Expansion::<L, 4>::new();
        three.add_multiple(&two, c);
        sum.add_multiple(&three, d);
    }
    sum.value()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::scalar::abs;
    use crate::{Octuple, Single};
    use num_dual::DualStruct;
    use proptest::prelude::*;

    fn number(exponents: std::ops::Range<i32>) -> impl Strategy<Value = f64> {
        (1.0..2.0_f64, exponents, any::<bool>())
            .prop_map(|(x, exponent, negative)| if negative { -x } else { x } * 2.0_f64.powi(exponent))
    }

    fn wide<L: Leaf + DualStruct<Real = f64>>(x: L) -> Octuple {
        x.re().into()
    }

    /// Whether high + low is exact: both sides are the rounded value of one exact number.
    fn is_exact<L: Leaf>(Pair { high, low }: Pair<L>, exact: Octuple) -> bool {
        wide(high) + wide(low) == exact
    }

    #[test]
    fn halves_have_half_the_digits() {
        assert_eq!(
            [f64::EPSILON, Single::EPSILON, Octuple::EPSILON.to_f64()].map(half_of_digits),
            [27, 12, 119].map(power_of_two)
        );
    }

    #[test]
    fn sums_and_products_of_octuples_are_exact() {
        let (one, tiny) = (Octuple::from(1.0), Octuple::EPSILON);
        assert_eq!(Pair::sum(one, tiny * tiny), Pair { high: one, low: tiny * tiny });
        assert_eq!(Pair::product(one + tiny, one - tiny), Pair { high: one, low: -tiny * tiny });
    }

    proptest! {
        #[test]
        fn sums_are_exact(a in number(-1022..1023), b in number(-1022..1023), near in number(-60..60)) {
            for b in [b, near * a, -a, a.next_up() * 0.75] {
                prop_assert!(!(a + b).is_finite() || is_exact(Pair::sum(a, b), wide(a) + wide(b)));
                prop_assert!(!(a - b).is_finite() || is_exact(Pair::difference(a, b), wide(a) - wide(b)));
            }
        }

        #[test]
        fn products_are_exact(a in number(-450..450), b in number(-450..450)) {
            prop_assert!(is_exact(Pair::product(a, b), wide(a) * wide(b)));
        }

        #[test]
        fn singles_too(a in number(-40..40), b in number(-40..40)) {
            let [a, b] = [a, b].map(Single::from);
            prop_assert!(is_exact(Pair::sum(a, b), wide(a) + wide(b)));
            prop_assert!(is_exact(Pair::product(a, b), wide(a) * wide(b)));
        }

        #[test]
        fn pairs_have_twice_the_digits(a in number(-3..3), b in number(-3..3), c in number(-3..3), d in number(-3..3)) {
            let pair = (Pair::product(a, b) - Pair::product(c, d)) * a;
            let exact = (wide(a) * b - wide(c) * d) * a;
            let size = (a * b).abs() + (c * d).abs();
            prop_assert!(abs(wide(pair.high) + pair.low - exact) <= size * a.abs() * (8.0 * f64::EPSILON * f64::EPSILON));
        }

        /// Products and their opposites in any order, one factor changed in its last digit.
        #[test]
        fn expansions_have_the_exact_sign(
            factors in prop::collection::vec((number(-25..25), number(-25..25)), 1..9),
            order in prop::collection::vec(any::<prop::sample::Index>(), 20),
            altered in -1..2_i8,
        ) {
            let mut terms: Vec<_> = factors.iter().flat_map(|&(a, b)| [(a, b), (-b, a)]).collect();
            let (a, b) = terms[0];
            let changed = match altered {
                0 => a,
                1 => a.next_up(),
                _ => a.next_down(),
            };
            terms[0].0 = changed;
            for (k, at) in order.iter().enumerate() {
                let (k, at) = (k % terms.len(), at.index(terms.len()));
                terms.swap(k, at);
            }
            let mut sum = Expansion::<f64, 32>::new();
            let mut multiple = Expansion::<f64, 64>::new();
            for (a, b) in terms {
                sum.add_product(a, b);
            }
            multiple.add_multiple(&sum, -3.0);
            // What remains is the change of one factor times the other factor.
            let left = (changed - a) * b;
            prop_assert_eq!((sum.value(), multiple.value()), (left, left * -3.0));
        }

        #[test]
        fn expansions_of_what_does_not_cancel_are_rounded_sums(
            factors in prop::collection::vec((number(-25..25), number(-25..25)), 0..9),
        ) {
            let mut sum = Expansion::<f64, 16>::new();
            for &(a, b) in &factors {
                sum.add_product(a, b);
            }
            let exact = factors.iter().fold(Octuple::from(0.0), |sum, &(a, b)| sum + wide(a) * b);
            prop_assert!(abs(wide(sum.value()) - exact) <= abs(exact) * f64::EPSILON);
        }
    }
}
