//! Inputs for which no result overflows, so that results need no check.

#![expect(clippy::inline_always, reason = "beside the formula what is known of an input costs nothing")]

use super::Fields;
use crate::number::power::power_of_two;

/// Inputs for which neither an output nor a derivative of a formula overflows.
///
/// For these, [`value_and_jacobian`](super::value_and_jacobian) checks the inputs alone, which are fewer than the
/// results. The audit tests each formula's claim at inputs drawn to break it.
///
/// Products of a few numbers below [`Finite::LARGEST`] stay below the limit of doubles, 2¹⁰²⁴. So do quotients whose
/// divisor is at least as large as [`Finite::SMALLEST`] implies: the difference of two unequal numbers of this kind
/// exceeds 2⁻¹⁵³.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Finite {
    /// Not known: every result is checked.
    #[default]
    Unknown,
    /// All components are below [`Finite::LARGEST`] in magnitude: for sums, products, and quotients by a length that
    /// is no smaller than the dividend.
    Below,
    /// All components are 0, or have a magnitude of at least [`Finite::SMALLEST`] and below [`Finite::LARGEST`].
    Between,
}

impl Finite {
    /// 2⁻¹⁰⁰ ≈ 8e-31.
    pub const SMALLEST: f64 = power_of_two(-100);
    /// 2¹²⁸ ≈ 3.4e38.
    pub const LARGEST: f64 = power_of_two(128);

    /// Whether the inputs satisfy this; false if one is infinite or NaN.
    #[inline(always)]
    pub(crate) fn covers(self, i: &impl Fields<f64>) -> bool {
        match self {
            Self::Unknown => false,
            Self::Below => are_below(i),
            Self::Between => are_between(i),
        }
    }
}

/// Zero if x is finite: x − x is then 0, and otherwise NaN. The compiler vectorises these two operations.
#[inline(always)]
#[expect(clippy::eq_op, reason = "the difference of a number and itself tells whether it is finite")]
pub(crate) fn bits_unless_finite(x: f64) -> u64 {
    (x - x).to_bits()
}

/// The inputs are scaled so that [`Finite::LARGEST`] overflows.
#[inline(always)]
fn are_below(i: &impl Fields<f64>) -> bool {
    let mut bits = 0;
    i.for_each_component(&mut |x| bits |= bits_unless_finite(x * power_of_two(1024 - 128)));
    bits == 0
}

#[inline(always)]
#[expect(clippy::needless_bitwise_bool, reason = "a branch for every component would cost more")]
fn are_between(i: &impl Fields<f64>) -> bool {
    let mut all = true;
    i.for_each_component(&mut |x| {
        let size = x.abs();
        all &= (size < Finite::LARGEST) & ((size >= Finite::SMALLEST) | (size == 0.0));
    });
    all
}

#[cfg(test)]
mod tests {
    use super::Finite;
    use crate::connector::slot::CrossForces;

    #[test]
    fn the_limits_are_where_they_are_said_to_be() {
        let tiny = f64::from_bits(1);
        let (below_smallest, below_largest) = (Finite::SMALLEST.next_down(), Finite::LARGEST.next_down());
        for (x, below, between) in [
            (0.0, true, true),
            (-0.0, true, true),
            (1.0, true, true),
            (tiny, true, false),
            (below_smallest, true, false),
            (Finite::SMALLEST, true, true),
            (below_largest, true, true),
            (Finite::LARGEST, false, false),
            (f64::MAX, false, false),
            (f64::INFINITY, false, false),
            (f64::NAN, false, false),
        ] {
            for x in [x, -x] {
                for i in [CrossForces { f2: x, f3: 1.0 }, CrossForces { f2: 1.0, f3: x }] {
                    assert_eq!([Finite::Below.covers(&i), Finite::Between.covers(&i)], [below, between], "{x:e}");
                    assert!(!Finite::Unknown.covers(&i));
                }
            }
        }
    }
}
