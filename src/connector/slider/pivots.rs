//! The choice of the coordinates of node m that are eliminated, and of the one that is kept.

use crate::number::binade::Binade;
use crate::number::eft::Pair;
use crate::number::scalar::{Leaf, Scalar, abs, choice, leaf, number_if};
use nalgebra::{SVector, Vector2, Vector3};

/// The axes of elimination in space, counted from 0: coordinates i and j of node m follow from coordinate k.
///
/// The rule is the documented one: i is the axis of the largest |t1|, and j, of the other two, that of the larger |t2|.
/// With d = xn − x1, t1 ∥ (0, d3, −d2) and t2 ∥ (−(d2² + d3²), d1 d2, d1 d3), so the pivots follow from d alone. Let p and q be
/// the larger and the smaller of |d2| and |d3|; then i is the axis of q, and j is axis 1 if p² + q² ≥ p |d1|, else the axis of p.
/// Equal sizes count as "larger" for i = 2 and for j = 1; for d2 = d3 = 0 the axes are (i, j, k) = (2, 3, 1).
///
/// # Guarantee
/// |n_k| ≥ 1/√6 ([`Pivots::LEAST`]), with equality at d ∝ (±2, ±1, ±1): the division by n_k is always safe.
///
/// Equal sizes are recognised although d is rounded: every comparison is made on the exact differences.
///
/// ```
/// use jointproof::connector::slider::Pivots;
/// use nalgebra::Vector3;
/// let from_origin = |x, y, z| Pivots::new(&Vector3::zeros(), &Vector3::new(x, y, z));
/// assert_eq!(from_origin(5.0, 1.0, 2.0), Pivots { i: 1, j: 2, k: 0 });
/// assert_eq!(from_origin(2.0, 1.0, 1.0), Pivots { i: 1, j: 0, k: 2 }); // both comparisons are ties
/// assert_eq!(from_origin(-1.0, 0.0, 0.0), Pivots { i: 1, j: 2, k: 0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pivots {
    /// The axis of the first eliminated coordinate.
    pub i: usize,
    /// The axis of the second eliminated coordinate.
    pub j: usize,
    /// The axis of the coordinate that is kept.
    pub k: usize,
}

impl Pivots {
    /// The least |n_k| that the rule allows, 1/√6.
    pub const LEAST: f64 = 0.408_248_290_463_863;
    /// The least |n_k| that [`Pivots::largest`] allows, 1/√3.
    pub const LEAST_OF_LARGEST: f64 = 0.577_350_269_189_625_8;

    /// The pivots of the line from x1 to xn.
    #[inline]
    pub fn new<D: Scalar>(x1: &Vector3<D>, xn: &Vector3<D>) -> Self {
        let [i, j, k] = Spatial::new(x1, xn).arranged([0, 1, 2]);
        Self { i, j, k }
    }

    /// The alternative rule: keep the axis of the largest |n_k|, the first on a tie, so that |n_k| ≥ 1/√3. The formulas do not
    /// use it; it is provided for comparison, and because `CalculiX` chooses this way.
    ///
    /// ```
    /// use jointproof::connector::slider::Pivots;
    /// use nalgebra::Vector3;
    /// assert_eq!(Pivots::largest(&Vector3::zeros(), &Vector3::new(2.0, 1.0, 1.0)), Pivots { i: 1, j: 2, k: 0 });
    /// ```
    pub fn largest<D: Scalar>(x1: &Vector3<D>, xn: &Vector3<D>) -> Self {
        let first = usize::from(!at_least(x1, xn, 0, 1));
        match if at_least(x1, xn, first, 2) { first } else { 2 } {
            0 => Self { i: 1, j: 2, k: 0 },
            1 => Self { i: 0, j: 2, k: 1 },
            k => Self { i: 0, j: 1, k },
        }
    }
}

/// The axes of elimination in the plane, counted from 0: coordinate i of node m follows from coordinate k, the axis of the
/// larger |n_k|, axis 1 on a tie. So |n_k| ≥ 1/√2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pivots2d {
    /// The axis of the eliminated coordinate.
    pub i: usize,
    /// The axis of the coordinate that is kept.
    pub k: usize,
}

impl Pivots2d {
    /// The pivots of the line from x1 to xn.
    #[inline]
    pub fn new<D: Scalar>(x1: &Vector2<D>, xn: &Vector2<D>) -> Self {
        let [i, k] = Plane::new(x1, xn).arranged([0, 1]);
        Self { i, k }
    }
}

/// The order of the axes: first those that are eliminated, then the one that is kept.
///
/// Components are selected by comparisons, not by index: rows of a batch, each with an order of its own, are computed together.
pub(super) trait Order<const N: usize>: Copy {
    /// Components given by axis, in this order.
    fn arranged<T: Copy>(self, by_axis: [T; N]) -> [T; N];
    /// Components given in this order, by axis.
    fn by_axis<T: Copy>(self, arranged: [T; N]) -> [T; N];
    /// A number, or NaN if rows are computed together and rounding could affect the order.
    fn if_known<D: Scalar>(self, x: D) -> D;
}

/// The order (i, j, k) of [`Pivots`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Spatial {
    /// Whether |d3| ≥ |d2|.
    far_is_third: bool,
    /// Whether axis 1 is eliminated.
    is_steep: bool,
    is_known: bool,
}

impl Spatial {
    #[inline(always)]
    pub(super) fn new<D: Scalar>(x1: &Vector3<D>, xn: &Vector3<D>) -> Self {
        let far_is_third = at_least(x1, xn, 2, 1);
        let [d1, d2, d3] = [0, 1, 2].map(|axis| abs(leaf(xn[axis]) - leaf(x1[axis])));
        let sizes = if far_is_third { [d1, d3, d2] } else { [d1, d2, d3] };
        let far_is_larger = |far| at_least(x1, xn, far, 0);
        if D::has_extremes() {
            let [far, near] = if far_is_third { [2, 1] } else { [1, 2] };
            let decide = || steep_exactly(&x1.map(leaf), &xn.map(leaf), near, far);
            let is_steep = answer::<D::Leaf>(|| steep(sizes, || far_is_larger(far)).unwrap_or_else(decide));
            return Self { far_is_third, is_steep, is_known: true };
        }
        let [larger_as_second, larger_as_third] = [1, 2].map(far_is_larger);
        let is_larger = if far_is_third { larger_as_third } else { larger_as_second };
        let ([excess, doubt], is_flat) = (excess(sizes), sizes[2] == 0.0);
        let is_steep = answer::<D::Leaf>(|| match (is_flat, D::ignores_extremes()) {
            (true, _) => is_larger && sizes[1] > 0.0,
            (_, true) => excess >= 0.0,
            _ => excess > doubt,
        });
        let is_known = answer::<D::Leaf>(|| is_flat | (abs(excess) > doubt));
        Self { far_is_third, is_steep, is_known }
    }
}

impl Order<3> for Spatial {
    #[inline(always)]
    fn arranged<T: Copy>(self, [first, second, third]: [T; 3]) -> [T; 3] {
        let [near, far] = if self.far_is_third { [second, third] } else { [third, second] };
        if self.is_steep { [near, first, far] } else { [near, far, first] }
    }
    #[inline(always)]
    fn by_axis<T: Copy>(self, [near, j, k]: [T; 3]) -> [T; 3] {
        let [first, far] = if self.is_steep { [j, k] } else { [k, j] };
        if self.far_is_third { [first, near, far] } else { [first, far, near] }
    }
    #[inline(always)]
    fn if_known<D: Scalar>(self, x: D) -> D {
        number_if(self.is_known, x)
    }
}

/// The order (i, k) of [`Pivots2d`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// Whether |d1| ≥ |d2|.
    first_is_kept: bool,
}

impl Plane {
    #[inline(always)]
    pub(super) fn new<D: Scalar>(x1: &Vector2<D>, xn: &Vector2<D>) -> Self {
        Self { first_is_kept: at_least(x1, xn, 0, 1) }
    }
}

impl Order<2> for Plane {
    #[inline(always)]
    fn arranged<T: Copy>(self, [first, second]: [T; 2]) -> [T; 2] {
        if self.first_is_kept { [second, first] } else { [first, second] }
    }
    #[inline(always)]
    fn by_axis<T: Copy>(self, arranged: [T; 2]) -> [T; 2] {
        self.arranged(arranged)
    }
    #[inline(always)]
    fn if_known<D: Scalar>(self, x: D) -> D {
        x
    }
}

/// Whether |d_a| ≥ |d_b|, for the exact d = xn − x1.
///
/// Rounding is monotonic: if the rounded differences differ, they decide; if they are equal, their rounding errors decide.
#[inline]
fn at_least<D: Scalar, const N: usize>(x1: &SVector<D, N>, xn: &SVector<D, N>, a: usize, b: usize) -> bool {
    let [a, b] = [a, b].map(|axis| Pair::difference(leaf(xn[axis]), leaf(x1[axis])).abs());
    answer::<D::Leaf>(|| if a.high == b.high { a.low >= b.low } else { a.high > b.high })
}

/// The result of a comparison, as one [`choice`].
#[inline]
fn answer<L: Leaf>(is_so: impl Fn() -> bool) -> bool {
    let [one] = choice(|| [L::from(if is_so() { 1.0 } else { 0.0 })]);
    one == 1.0
}

/// Whether p² + q² ≥ p |d1|, for rounded sizes |d1|, p = |d_far| ≥ q = |d_near|; `None` if they are so close to a tie that
/// rounding could decide, or if they overflow. For p = 0, a line along axis 1, the answer is no; for q = 0 it is exact, whether p
/// is at least |d1|.
#[inline]
fn steep<L: Leaf>(sizes: [L; 3], far_is_larger: impl Fn() -> bool) -> Option<bool> {
    let [_, p, q] = sizes;
    if q == 0.0 {
        return Some(p > 0.0 && far_is_larger());
    }
    let [excess, doubt] = excess(sizes);
    (abs(excess) > doubt).then_some(excess > doubt)
}

/// p² + q² − p |d1|, and a bound of its rounding error.
#[inline(always)]
fn excess<L: Leaf>([along, p, q]: [L; 3]) -> [L; 2] {
    // 32 roundings; those of differences, products and sums add up to at most 9.
    [q * q - p * (along - p), p * (along + p) * (16.0 * L::EPSILON) + f64::MIN_POSITIVE]
}

#[cold]
#[inline(never)]
fn steep_exactly<L: Leaf>(x1: &Vector3<L>, xn: &Vector3<L>, near: usize, far: usize) -> bool {
    let per_unit = Binade::of(x1.iter().chain(xn).copied()).per_unit;
    let difference = |axis: usize| Pair::difference(xn[axis] * per_unit, x1[axis] * per_unit).abs();
    let [along, p, q] = [0, far, near].map(difference);
    if let Some(steep) = steep([along.high, p.high, q.high], || at_least(x1, xn, far, 0)) {
        return steep;
    }
    // q² − p |d1| + p², with each number split into its parts.
    let one = L::one();
    let squared = |x: Pair<L>| [[x.low, x.low, one, one], [x.low * 2.0, x.high, one, one], [x.high, x.high, one, one]];
    let crossed = |x: L| [[x, -along.low, one, one], [x, -along.high, one, one]];
    let products = [squared(q).as_slice(), &squared(p), &crossed(p.low), &crossed(p.high)].concat();
    L::exact_sum(products) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use proptest::prelude::*;

    /// d1 exceeds d2 by 2⁴⁶⁷, rounded by 2⁴⁸⁸: d2 (d1 − d2) is below d3² = 2¹⁰²², but overflows when rounded.
    #[test]
    fn pivots_are_those_of_the_exact_differences_where_products_overflow() {
        let power = |exponent| 2.0_f64.powi(exponent);
        let d2 = power(540) + power(488);
        let x1 = Vector3::new(power(487), power(467) - power(487), 0.0);
        let xn = Vector3::new(d2 + power(488), d2, power(511));
        assert_eq!((xn - x1).xy(), xn.xy());
        assert_eq!(Pivots::new(&x1, &xn), Pivots { i: 2, j: 0, k: 1 });
    }

    /// Otherwise every line would be decided exactly, which takes a hundred times as long.
    #[test]
    fn rounding_decides_only_beside_a_tie() {
        let ways = [[3.0, 1.0, 5.0], [10.0, 5.0, 1.0], [10.0, 9.0, 3.0]].map(|sizes| steep(sizes, || unreachable!()));
        assert_eq!(ways, [Some(true), Some(false), None]);
        let beside = [10.0, 9.0, 3.0 + 1e-12];
        assert_eq!(steep(beside, || unreachable!()), Some(true));
    }

    proptest! {
        /// At ties, and where the rounding of a coordinate moved the line close to one.
        #[test]
        fn pivots_are_those_of_the_exact_differences(
            x1 in prop::array::uniform3(prop_oneof![Just(0.0), -2.0..2.0_f64]),
            (along, p, q) in prop_oneof![Just((2.0, 1.0, 1.0)), Just((5.0, 4.0, 2.0)), Just((10.0, 9.0, 3.0)), Just((1.0, 1.0, 0.0))],
            scale in prop_oneof![Just(1.0), Just(1e-150), Just(1e150), 0.1..10.0_f64],
            exchanged: bool,
        ) {
            let x1 = Vector3::from(x1) * scale;
            let xn = x1 + if exchanged { Vector3::new(-along, p, q) } else { Vector3::new(along, q, -p) } * scale;
            let [d1, d2, d3] = [0, 1, 2].map(|c| abs(Octuple::from(xn[c]) - x1[c]));
            let (i, far) = if d3 >= d2 { (1, 2) } else { (2, 1) };
            let (p, q) = if d3 >= d2 { (d3, d2) } else { (d2, d3) };
            let expected = if p * p + q * q >= p * d1 { Pivots { i, j: 0, k: far } } else { Pivots { i, j: far, k: 0 } };
            prop_assert_eq!(Pivots::new(&x1, &xn), expected);
        }
    }
}
