//! Shared evidence of the closest points: the corner z = r² + 1/4, which straight segments and parabolas have in common, and the
//! points where a foot has no derivative.

use super::candidates::{Candidates, Reach};
use super::foot::Foot;
use super::view::View;
use crate::Octuple;
use crate::contact::slide_line::left;
use crate::contact::slide_line::shape::Shape;
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink};
use crate::number::scalar::{Leaf, Scalar, direction};
use nalgebra::Vector2;

/// Slave points around the corner, given by their position (r, z) relative to the vertex; except for the first, which names it.
pub(super) fn cases<I>(at_corner: fn(f64, f64) -> I) -> Vec<Case<I>> {
    vec![
        Case::hand("on-the-curve", "separation 0", at_corner(0.25, 0.3125)),
        Case::hand("closed", "penetration of 1/4", at_corner(0.0, 0.0)),
        Case::hand("tied", "two places inside are equally near: the first is taken", at_corner(0.0, 0.875)),
        Case::hand("tied-ends", "both ends are equally near: the first is taken", at_corner(0.0, 3.0)),
        Case::hand("before-start", "the foot stays at t = 0", at_corner(-2.0, 1.0)),
        Case::hand("behind-end", "the foot stays at t = 1", at_corner(2.0, 1.0)),
        Case::hand("at-start", "foot exactly at t = 0", at_corner(-1.0, 0.0)),
        Case::hand("at-end", "foot exactly at t = 1", at_corner(1.0, 0.0)),
        Case::hard("centre", "on the centre of curvature: three feet merge", at_corner(0.0, 0.75)),
        Case::hard("near-centre-1e-4", "1e-4 beside the centre of curvature", at_corner(1e-4, 0.75)),
        Case::hard("near-centre-1e-8", "1e-8 beside the centre of curvature", at_corner(1e-8, 0.75)),
        Case::hard("near-medial", "1e-12 beside the medial axis", at_corner(1e-12, 0.875)),
    ]
}

/// A slave point from two random numbers: the foot at −1 … 1 along the line, in three of ten cases beyond an end, and the
/// distance from it. `on` gives a point of the line, and the tangent there.
pub(in crate::contact::slide_line) fn slave_point(
    drawn: Vector2<f64>,
    on: impl Fn(f64) -> [Vector2<f64>; 2],
) -> Vector2<f64> {
    let [x, tangent] = on(1.0625 * drawn.x / (1.0 + drawn.x.abs()));
    x + left(Vector2::from(direction([tangent.x, tangent.y]))) * drawn.y
}

/// Whether inputs are on a kink.
type Holds<F> = fn(&<F as Formula>::Inputs<Octuple>) -> bool;
/// A point on the kink, or a direction away from it.
type Inputs<F> = fn() -> <F as Formula>::Inputs<f64>;

/// The points where the foot has no derivative: it enters or leaves an end, there are two feet, or several merge.
pub(super) fn kinks<F: Formula>(holds: [Holds<F>; 3], at: [Inputs<F>; 3], across: Inputs<F>) -> Vec<Kink<F>> {
    let conditions = [
        r"(\mathbf{x}_s-\mathbf{X})\cdot\mathbf{X}' = 0 \text{ at } t = 0 \text{ or } 1",
        r"\text{two places equally near}",
        r"\mathbf{x}_s \text{ on the centre of curvature}",
    ];
    let switch = |k: usize| Kink::<F>::switch(conditions[k], holds[k], at[k](), across());
    (0..3).map(switch).collect()
}

impl<D: Scalar, S: Shape<N>, const N: usize> View<D, S, N> {
    /// Whether two points of the whole curve are equally near.
    pub(super) fn is_tied(&self) -> bool {
        Reach::new(self, S::ENDS.map(D::Leaf::from)).candidates().tied()
    }
}

impl<D: Scalar, const N: usize> Foot<D, N> {
    /// Whether the slave point is exactly where the foot enters or leaves an end.
    pub(super) fn is_exactly_at_end<S: Shape<N>>(&self, view: &View<D, S, N>) -> bool {
        !self.inside && view.at(self.u).residual() == 0.0
    }

    /// Whether several feet merge here.
    pub(super) fn is_centre_of_curvature(&self) -> bool {
        self.inside && self.per_slope == 0.0
    }
}

impl<L: Leaf> Candidates<L> {
    /// Whether another point is as near as the nearest.
    fn tied(&self) -> bool {
        let best = self.nearest().coordinate();
        let mut others = self.places.iter().map(|place| place.coordinate()).filter(|&u| u != best);
        others.any(|u| self.expansion.compare(u, best).is_eq())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::slide_line::closest::candidates::Place;
    use crate::contact::slide_line::closest::expansion::Expansion;

    #[test]
    fn two_places_are_tied_whatever_a_third_is() {
        // The distance to (u, 0) from (0, 1).
        let expansion =
            Expansion { gap: Vector2::y(), factor: 1.0, y: [Vector2::x(), Vector2::zeros(), Vector2::zeros()] };
        let tied = |places: &[f64]| {
            Candidates { expansion, places: places.iter().map(|&u| Place::Inside(u)).collect() }.tied()
        };
        assert!(tied(&[-1.0, 1.0, 2.0]) && tied(&[2.0, -1.0, 1.0]));
        assert!(!tied(&[-1.0, 2.0, 3.0]) && !tied(&[1.0]));
    }
}
