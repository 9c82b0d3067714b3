//! The foot of the slave point on a curve: selected from the candidates, refined, and given its derivatives.

use super::candidates::{Place, Reach};
use super::view::{CurveAt, View};
use crate::contact::slide_line::basis::length_and_tangent;
use crate::contact::slide_line::shape::Shape;
use crate::contact::slide_line::{left, length};
use crate::formula::error::Error;
use crate::number::scalar::{Scalar, abs, choice, constant, is_between, leaf};
use nalgebra::Vector2;

/// The closest point of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<D, const N: usize> {
    pub(super) u: D,
    /// The remaining difference of the foot from u, as far as the precision allows: less than half the distance to the next
    /// number.
    pub(super) missing: D,
    /// The weights of the nodes in X, for the variation of the separation.
    ///
    /// Beyond an end they are those of the point on the tangent that is closest to the slave point.
    pub(super) weights: [D; N],
    /// The weights of the nodes in Y′.
    pub(super) rates: [D; N],
    /// xs minus the foot or, beyond an end, minus the closest point of the tangent.
    pub(super) gap: Vector2<D>,
    /// Y′.
    pub(super) rate: Vector2<D>,
    /// 1/r′, or 0 if the foot does not move.
    pub(super) per_slope: D,
    /// The distance of the slave point beyond an end along the tangent, divided by |Y′|; 0 inside.
    pub(super) beyond: D,
    pub(super) inside: bool,
}

impl<D: Scalar, const N: usize> Foot<D, N> {
    /// Whether Y′ is no larger than the rounding errors of its terms.
    pub(super) fn stands_still<S: Shape<N>>(&self, view: &View<D, S, N>) -> bool {
        let base = view.nodes[N / 2];
        let size = |v: Vector2<D>| abs(v.x) + abs(v.y);
        let terms = view.nodes.iter().zip(self.rates).map(|(x, rate)| size(view.in_unit((x - base) * rate)));
        size(self.rate) <= terms.fold(D::zero(), |sum, term| sum + term) * (8.0 * f64::EPSILON)
    }

    /// The foot on the whole curve.
    pub(super) fn on<S: Shape<N>>(view: &View<D, S, N>) -> Self {
        Self::between(view, S::ENDS.map(D::Leaf::from))
    }

    /// The foot on the part between two coordinates.
    pub(super) fn between<S: Shape<N>>(view: &View<D, S, N>, ends: [D::Leaf; 2]) -> Self {
        match Reach::new(view, ends).nearest() {
            Place::Inside(u) => Self::inside(view, u, ends),
            Place::End(u) => Self::at_end(view, constant(u)),
        }
    }

    /// The foot at a root, refined to working precision and given its derivatives.
    pub(super) fn inside<S: Shape<N>>(view: &View<D, S, N>, u: D::Leaf, [from, to]: [D::Leaf; 2]) -> Self {
        let (mut u, mut place) = (constant(u), view.at(constant(u)));
        let next = leaf(u) + place.newton_step();
        if from < next && next < to {
            let better = view.at(constant(next));
            if abs(leaf(better.residual())) < abs(leaf(place.residual())) {
                (u, place) = (constant(next), better);
            }
        }
        // r(u) = 0 also when an input varies, so du = −dr/r′: each step makes derivatives of one more order correct.
        let slope = leaf(place.slope());
        if slope != 0.0 {
            for _ in 0..D::NDERIV {
                let residual = place.residual();
                let varying = residual - constant::<D>(leaf(residual));
                u -= varying / constant::<D>(slope);
                place = view.at(u);
            }
        }
        // The foot is between two neighbouring numbers. At the tip of a bent segment the tangent rotates within a few of them, so
        // the remaining difference is applied to everything that depends on it.
        let missing = constant::<D>(place.newton_step());
        let rates = S::rates(view.f, u);
        let weights = moved(S::weights(view.f, u), rates, S::factor(view.f) * missing);
        let place = CurveAt {
            gap: view.gap(weights),
            rate: place.rate + place.second * missing,
            second: place.second + view.combination(S::third_derivatives(view.f)) * missing,
            ..place
        };
        let slope = Self::slope(view, &place);
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

    /// r′ at the foot.
    ///
    /// The gap is along the normal, so (xs − X)·Y″ is also the product of n·(xs − X) and n·Y″ = Y′ × Y″ / |Y′|: the one of the two
    /// with the smaller terms is taken.
    fn slope<S: Shape<N>>(view: &View<D, S, N>, place: &CurveAt<D>) -> D {
        let CurveAt { gap, rate, second, factor } = *place;
        let Some([side, other]) = S::turning(&view.nodes).map(|sides| sides.map(|side| view.in_unit(side))) else {
            return place.slope();
        };
        let square = rate.dot(&rate);
        let depth = rate.perp(&gap) / square;
        let terms = |x: D, y: D| abs(x) + abs(y);
        let turned = terms(side.x * other.y, side.y * other.x) * abs(depth);
        let [along] = choice(|| {
            let is_less = turned < terms(gap.x * second.x, gap.y * second.y);
            [if is_less { side.perp(&other) * depth } else { gap.dot(&second) }]
        });
        along - factor * square
    }

    pub(super) fn at_end<S: Shape<N>>(view: &View<D, S, N>, u: D) -> Self {
        let place = view.at(u);
        let (length, t) = length_and_tangent(place.rate);
        let beyond = place.gap.dot(&t) / length;
        let weights = S::on_end_tangent(view.xs, &view.nodes, view.f, u);
        // With a sum of 1 they are those of a point of the tangent, whatever the rounding errors of |Y′|; unless they are so large
        // that nothing is left of the sum.
        let sum = weights.iter().fold(D::zero(), |sum, &weight| sum + weight);
        let [per_sum] = choice(|| [if is_between(sum, 0.5, 2.0) { sum.recip() } else { D::one() }]);
        Self {
            u,
            missing: D::zero(),
            weights,
            rates: S::rates(view.f, u),
            gap: view.gap(weights.map(|weight| weight * per_sum)),
            rate: place.rate,
            per_slope: D::zero(),
            beyond,
            inside: false,
        }
    }

    pub(super) fn normal(&self) -> Vector2<D> {
        left(length_and_tangent(self.rate).1)
    }

    /// 1 − u and u of a corner, including the remaining difference.
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
    /// The foot on the whole curve, unless the curve's derivative [vanishes](Self::stands_still) there.
    pub(super) fn with_tangent<S: Shape<N>>(view: &View<D, S, N>, coordinate: &'static str) -> Result<Self, Error> {
        let foot = Self::on(view);
        if foot.stands_still(view) { Err(Error::NoTangent { coordinate, value: foot.u.re() }) } else { Ok(foot) }
    }
}

/// The weights of the nodes after a step, from their rates.
#[inline]
pub(super) fn moved<D: Scalar, const N: usize>(weights: [D; N], rates: [D; N], step: D) -> [D; N] {
    std::array::from_fn(|k| weights[k] + rates[k] * step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::slide_line::shape::{Parabola, ParabolicCorner};

    /// If the ends leave no space for a step, the whole difference to the foot remains, so that its effect is visible.
    #[test]
    fn what_is_missing_is_carried_on_to_all_that_depends_on_it() {
        // On (g, g²) at g = 1/2: r = 1/8 and r′ = −1/2.
        let nodes = [[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]].map(Vector2::from);
        let view = View::<f64, Parabola, 3>::new(Vector2::new(-0.125, 1.0), nodes, 0.0);
        let foot = Foot::inside(&view, 0.5, [0.5, 0.5]);
        assert_eq!((foot.u, foot.missing, foot.beyond, foot.inside), (0.5, 0.25, 0.0, true));
        assert_eq!((foot.weights, foot.rates), ([-0.125, 0.5, 0.625], [0.25, -1.5, 1.25]));
        assert_eq!((foot.gap, foot.rate), (Vector2::new(-0.875, 0.5), Vector2::new(1.0, 1.5)));
        assert_eq!((foot.per_slope, foot.parts()), (-2.25_f64.recip(), [0.25, 0.75]));
    }

    #[test]
    fn on_a_cubic_the_third_derivative_is_carried_on_too() {
        let nodes = [[0.0, 0.0], [1.0, 2.0], [2.0, 1.0], [3.0, 4.0], [6.0, 5.0]].map(Vector2::from);
        let (f, u) = (0.375, 0.25);
        let view = View::<f64, ParabolicCorner, 5>::new(Vector2::new(1.75, 2.5), nodes, f);
        let place = view.at(u);
        let foot = Foot::inside(&view, u, [u, u]);
        let step = place.newton_step();
        assert_eq!((foot.u, foot.missing), (u, step));
        assert!(step.abs() > 0.01, "{step}");
        let [rates, seconds] = [ParabolicCorner::rates(f, u), ParabolicCorner::second_derivatives(f, u)];
        let third = view.combination(ParabolicCorner::third_derivatives(f));
        assert_eq!(foot.weights, moved(ParabolicCorner::weights(f, u), rates, f * step));
        assert_eq!(foot.rates, moved(rates, seconds, step));
        assert_eq!(foot.gap, view.gap(foot.weights));
        let [rate, second] = [place.rate + place.second * step, place.second + third * step];
        let close =
            |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-14, "{found} and not {expected}");
        close(foot.rate.x, rate.x);
        close(foot.rate.y, rate.y);
        close(foot.per_slope.recip(), foot.gap.dot(&second) - f * rate.dot(&rate));
    }

    #[test]
    fn a_step_is_taken_where_it_is_inside_and_makes_the_residual_smaller() {
        let nodes = [[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]].map(Vector2::from);
        let view = View::<f64, Parabola, 3>::new(Vector2::new(0.0, 0.25), nodes, 0.0);
        // r = −u/2 − 2u³: from 1/8 to 1/88.
        let taken = |ends| Foot::inside(&view, 0.125, ends).u;
        let step = view.at(0.125).newton_step();
        assert_eq!(taken([-1.0, 1.0]), 0.125 + step);
        assert_eq!((taken([0.125 + step, 1.0]), taken([-1.0, 0.125 + step])), (0.125, 0.125));
        // From a point next to a maximum of r a step leads far away, where r is larger: r = ½u − 2u³.
        let view = View::<f64, Parabola, 3>::new(Vector2::new(0.0, 0.75), nodes, 0.0);
        let (place, step) = (view.at(0.3125), view.at(0.3125).newton_step());
        assert!(view.at(0.3125 + step).residual().abs() > place.residual().abs());
        assert_eq!(Foot::inside(&view, 0.3125, [-9.0, 9.0]).u, 0.3125);
    }

    #[test]
    fn a_curve_stands_still_where_its_rate_is_only_rounding() {
        let at = |middle: f64| {
            let nodes = [0.0, middle, 4.0].map(|x| Vector2::new(x + 8.0, 1.0));
            let view = View::<f64, Parabola, 3>::new(Vector2::new(7.0, 1.0), nodes, 0.0);
            Foot::at_end(&view, -1.0).stands_still(&view)
        };
        // X′(−1) is 2 (x₂ − x₁) − ½ (x₃ − x₁), with terms that add up to 3 if x₂ is the quarter point.
        assert_eq!([0.0, 1e-15, 1e-14, 1e-13, 1.0].map(|by| at(1.0 + by)), [true, true, false, false, false]);
    }
}
