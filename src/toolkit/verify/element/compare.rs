//! Comparison of numbers in 237 bits with their expected values.

use super::linear::Matrix;
use crate::Octuple;
use crate::toolkit::verify::claim::Claim;
use crate::toolkit::verify::point::Point;
use num_traits::{Signed, Zero};

/// The tolerance in 237 bits between closed forms and automatic differentiation, and for laws.
pub(super) const EXACT: f64 = 1e-60;
/// The tolerance in 237 bits between automatic differentiation and differences: at hard points digits are lost.
pub(super) const DIFFERENCES: f64 = 1e-35;
/// Numbers below this fraction of the largest are also judged relative to the largest, as rounding errors in 237 bits.
const NOTHING: f64 = 1e-8;

pub(super) fn largest(numbers: impl Iterator<Item = Octuple>) -> Octuple {
    numbers.fold(Octuple::zero(), |most, x| if x.abs() > most { x.abs() } else { most })
}

/// Compares every number relative to its size plus a fraction of the largest size.
pub(super) fn compare(
    claim: &mut Claim,
    point: &Point,
    found: &Matrix,
    expected: &Matrix,
    sizes: &Matrix,
    name: impl Fn(usize, usize) -> String,
) {
    let nothing = largest(sizes.iter().copied()) * NOTHING;
    for row in 0..found.nrows() {
        for column in 0..found.ncols() {
            let at = (row, column);
            let pair = [found[at], expected[at]];
            record(claim, point, || name(row, column), pair, sizes[at] + nothing);
        }
    }
}

/// Records a difference relative to a size.
pub(super) fn record(
    claim: &mut Claim,
    point: &Point,
    name: impl FnOnce() -> String,
    [found, expected]: [Octuple; 2],
    size: Octuple,
) {
    let off = (found - expected).abs();
    let share = if off.is_zero() { 0.0 } else { (off / size).to_f64() };
    let bound = claim.bound;
    claim.record(share, bound, |share| point.deviation(share, name(), found.to_f64(), expected.to_f64()));
}
