//! The closest point of one piece of a slide line: of a segment, of the part of it between smoothed corners, or of a corner.

use super::{ClosestLinear, Foot, LinearSlave, View};
use crate::Scalar;
use crate::contact::slide_line::basis::length_and_tangent;
use crate::contact::slide_line::shape::{self, Shape};
use crate::formula::Formula;
use crate::number::scalar::norm;
use arrayvec::ArrayVec;
use nalgebra::Vector2;

/// The closest point of one piece.
#[derive(Clone, Debug)]
pub(in crate::contact::slide_line) struct PieceFoot<D> {
    /// The coordinate.
    pub(in crate::contact::slide_line) u: D,
    /// Whether it is between the ends, where the gap is perpendicular to the piece.
    pub(in crate::contact::slide_line) inside: bool,
    /// The distance to the piece.
    pub(in crate::contact::slide_line) distance: f64,
    /// The distance of the slave point past an end, along the outward tangent there.
    pub(in crate::contact::slide_line) beyond: D,
    pub(in crate::contact::slide_line) tangent: Vector2<D>,
    /// The separation from the tangent.
    pub(in crate::contact::slide_line) separation: D,
    /// The weights of the piece's nodes; they add up to 1.
    pub(in crate::contact::slide_line) weights: ArrayVec<D, 5>,
    /// Whether the curve's derivative vanishes there, so that the tangent consists of rounding errors.
    pub(in crate::contact::slide_line) stands_still: bool,
}

/// The foot on the part of a straight segment between two coordinates.
pub(in crate::contact::slide_line) fn straight_foot<D: Scalar>(
    i: &LinearSlave<D>,
    [from, to]: [f64; 2],
) -> PieceFoot<D> {
    let whole = ClosestLinear::eval(i);
    let (length, tangent) = length_and_tangent(i.x2 - i.x1);
    let inside = from < whole.g.re() && whole.g.re() < to;
    if inside {
        let weights = shape::linear(whole.g).into_iter().collect();
        let distance = whole.separation.re().abs();
        let beyond = D::zero();
        let (u, separation) = (whole.g, whole.separation);
        return PieceFoot { u, inside, distance, beyond, tangent, separation, weights, stands_still: false };
    }
    let end = if whole.g <= from { from } else { to };
    let u = D::from(end);
    let gap = shape::gap(i.xs, &[i.x1, i.x2], shape::linear(u));
    let along = gap.dot(&tangent);
    PieceFoot {
        u,
        inside,
        distance: size(gap),
        beyond: along * end.signum(),
        tangent,
        separation: whole.separation,
        weights: shape::linear(along / length * 2.0 + u).into_iter().collect(),
        stands_still: false,
    }
}

/// The foot on the part of a curve between two coordinates.
pub(in crate::contact::slide_line) fn curved_foot<D: Scalar, S: Shape<N>, const N: usize>(
    xs: Vector2<D>,
    nodes: [Vector2<D>; N],
    f: f64,
    [from, to]: [f64; 2],
) -> PieceFoot<D> {
    let view = View::<D, S, N>::new(xs, nodes, D::from(f));
    let foot = Foot::between(&view, [from, to].map(D::Leaf::from));
    let at_end = S::weights(view.f, foot.u);
    let gap = if foot.inside { foot.gap } else { view.gap(at_end) };
    // At an end the weights are those of the end plus a step along the tangent, so that they add up to 1 whatever the step.
    let on_tangent = std::array::from_fn(|k| at_end[k] + foot.rates[k] * foot.beyond);
    let weights: [D; N] = if foot.inside { foot.weights } else { on_tangent };
    let tangent = length_and_tangent(foot.rate).1;
    let outward = if foot.u.re() == from { -1.0 } else { 1.0 };
    PieceFoot {
        u: foot.u,
        inside: foot.inside,
        distance: size(gap) * view.binade.unit.re(),
        beyond: if foot.inside { D::zero() } else { gap.dot(&tangent) * (view.binade.unit * outward) },
        tangent,
        separation: foot.separation() * view.binade.unit,
        weights: weights.into_iter().collect(),
        stands_still: foot.stands_still(&view),
    }
}

fn size<D: Scalar>(v: Vector2<D>) -> f64 {
    norm([v.x.re(), v.y.re()])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::slide_line::shape::Parabola;

    #[test]
    fn past_either_end_of_a_curve_the_distance_is_that_along_the_outward_tangent() {
        let nodes = [0.0, 2.0, 4.0].map(|x| Vector2::new(x, 0.0));
        for x in [-3.0, 7.0] {
            let foot = curved_foot::<f64, Parabola, 3>(Vector2::new(x, 0.5), nodes, 0.0, [-1.0, 1.0]);
            assert_eq!((foot.inside, foot.beyond), (false, 3.0));
            // The weights are those of the point on that tangent.
            let point: Vector2<f64> = nodes.iter().zip(&foot.weights).map(|(node, &weight)| node * weight).sum();
            assert_eq!((point, foot.weights.iter().sum::<f64>()), (Vector2::new(x, 0.0), 1.0));
        }
    }
}
