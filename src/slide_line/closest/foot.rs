//! The foot of the slave point on a curve: found among the candidates, settled, and given its derivatives.

use super::candidates::{Place, Reach};
use super::view::{CurveAt, View};
use crate::error::Error;
use crate::scalar::{Scalar, abs, choice, constant, leaf};
use crate::slide_line::basis::length_and_tangent;
use crate::slide_line::shape::Shape;
use crate::slide_line::{left, length};
use nalgebra::Vector2;

/// The closest point of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<D, const N: usize> {
    pub(super) u: D,
    /// What the foot is from u, as far as the numbers tell: less than half the distance to the next.
    pub(super) missing: D,
    /// The weights of the nodes in X, for a change of the separation.
    ///
    /// Beyond an end they are those of the point of the tangent that is closest to the slave point.
    pub(super) weights: [D; N],
    /// The weights of the nodes in Y′.
    pub(super) rates: [D; N],
    /// xs minus the point of these weights.
    pub(super) gap: Vector2<D>,
    /// Y′.
    pub(super) rate: Vector2<D>,
    /// 1/r′, or 0 where the foot does not move.
    pub(super) per_slope: D,
    /// How far the slave point is beyond an end: its distance along the tangent, per |Y′|; 0 inside.
    pub(super) beyond: D,
    pub(super) inside: bool,
}

impl<D: Scalar, const N: usize> Foot<D, N> {
    /// Whether Y′ is no more than the rounding of its terms.
    pub(super) fn stands_still<S: Shape<N>>(&self, view: &View<D, S, N>) -> bool {
        let base = view.nodes[N / 2];
        let size = |v: Vector2<D>| abs(v.x) + abs(v.y);
        let terms = view.nodes.iter().zip(self.rates).map(|(x, rate)| size(view.in_unit((x - base) * rate)));
        size(self.rate) <= terms.fold(D::zero(), |sum, term| sum + term) * (8.0 * f64::EPSILON)
    }

    /// On the whole curve.
    pub(super) fn on<S: Shape<N>>(view: &View<D, S, N>) -> Self {
        Self::between(view, S::ENDS.map(D::Leaf::from))
    }

    /// On the part between two coordinates.
    pub(super) fn between<S: Shape<N>>(view: &View<D, S, N>, ends: [D::Leaf; 2]) -> Self {
        match Reach::new(view, ends).nearest() {
            Place::Inside(u) => Self::inside(view, u, ends),
            Place::End(u) => Self::at_end(view, constant(u)),
        }
    }

    /// At a root, brought to working precision and given its derivatives.
    pub(super) fn inside<S: Shape<N>>(view: &View<D, S, N>, u: D::Leaf, [from, to]: [D::Leaf; 2]) -> Self {
        let (mut u, mut place) = (constant(u), view.at(constant(u)));
        let next = leaf(u) + place.newton_step();
        if from < next && next < to {
            let better = view.at(constant(next));
            if abs(leaf(better.residual())) < abs(leaf(place.residual())) {
                (u, place) = (constant(next), better);
            }
        }
        // r(u) = 0 also when an input varies, so du = −dr/r′: each step makes one more order of derivatives right.
        let slope = leaf(place.slope());
        if slope != 0.0 {
            for _ in 0..D::NDERIV {
                let residual = place.residual();
                let varying = residual - constant::<D>(leaf(residual));
                u -= varying / constant::<D>(slope);
                place = view.at(u);
            }
        }
        // The foot is between two neighbouring numbers. At the tip of a bent segment the tangent turns within a few
        // of them, so what is missing is carried on to all that depends on it.
        let missing = constant::<D>(place.newton_step());
        let rates = S::rates(view.f, u);
        let weights = moved(S::weights(view.f, u), rates, S::factor(view.f) * missing);
        let place = CurveAt {
            gap: view.gap(weights),
            rate: place.rate + place.second * missing,
            second: place.second + view.combination(S::third_derivatives(view.f)) * missing,
            ..place
        };
        let slope = place.slope();
        let [per_slope] = choice(|| [if slope == 0.0 { D::zero() } else { slope.recip() }]);
        Self {
            u,
            missing,
            weights,
            rates: moved(rates, S::second_derivatives(view.f, u), missing),
            gap: place.gap,
            rate: place.rate,
            per_slope,
            beyond: D::zero(),
            inside: true,
        }
    }

    pub(super) fn at_end<S: Shape<N>>(view: &View<D, S, N>, u: D) -> Self {
        let place = view.at(u);
        let (length, t) = length_and_tangent(place.rate);
        let beyond = place.gap.dot(&t) / length;
        let weights = S::on_end_tangent(view.xs, &view.nodes, view.f, u);
        Self {
            u,
            missing: D::zero(),
            weights,
            rates: S::rates(view.f, u),
            gap: view.gap(weights),
            rate: place.rate,
            per_slope: D::zero(),
            beyond,
            inside: false,
        }
    }

    pub(super) fn normal(&self) -> Vector2<D> {
        left(length_and_tangent(self.rate).1)
    }

    /// 1 − u and u of a corner, with what is missing.
    pub(super) fn parts(&self) -> [D; 2] {
        [-self.u + 1.0 - self.missing, self.u + self.missing]
    }

    /// |Y′| in the model's unit of length.
    pub(super) fn speed<S: Shape<N>>(&self, view: &View<D, S, N>) -> D {
        length(self.rate) * view.binade.unit
    }

    /// n·(xs − X).
    pub(super) fn separation(&self) -> D {
        self.normal().dot(&self.gap)
    }

    /// The gradient of the coordinate with respect to a node that has these weights in X and Y′.
    ///
    /// The slave point is a node of weights −1 and 0.
    pub(super) fn coordinate_by(&self, n: D, m: D) -> Vector2<D> {
        (self.rate * n - self.gap * m) * self.per_slope
    }
}

impl<D: Scalar, const N: usize> Foot<D, N> {
    /// On the whole curve, unless that [stands still](Self::stands_still) there.
    pub(super) fn with_tangent<S: Shape<N>>(view: &View<D, S, N>, coordinate: &'static str) -> Result<Self, Error> {
        let foot = Self::on(view);
        if foot.stands_still(view) { Err(Error::NoTangent { coordinate, value: foot.u.re() }) } else { Ok(foot) }
    }
}

/// Weights of the nodes a step further, from how fast they change.
#[inline]
pub(super) fn moved<D: Scalar, const N: usize>(weights: [D; N], rates: [D; N], step: D) -> [D; N] {
    std::array::from_fn(|k| weights[k] + rates[k] * step)
}
