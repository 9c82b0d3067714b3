//! The closest point of a curve to the slave point.
//!
//! The foot X(u) of the slave point xs on a curve makes the gap xs − X perpendicular to the curve, (xs − X)·X′ = 0: a
//! polynomial equation of degree 1, 3 or 5. Of all its roots those count where the distance has a minimum, and beside
//! them the ends of the curve; the nearest of them is taken, the one of smaller coordinate on a tie. Beyond an end the
//! foot is that end, and the separation (xs − X)·n is measured from the tangent there.
//!
//! The search runs in numbers without derivatives, in all their digits. Then the foot is settled
//! in the full scalar: by one step of Newton's method on the equation itself, evaluated from differences of nodes, and
//! by the implicit function theorem for the derivatives. With r(u) = (xs − X)·X′ the closed form is
//! ∂u/∂xs = −X′/r′ and ∂u/∂xᵢ = (Nᵢ X′ − Nᵢ′ (xs − X))/r′; and since to first order the motion of the foot does not
//! matter, ∂E11/∂xs = n and ∂E11/∂xᵢ = −Nᵢ n, with Nᵢ + τ Nᵢ′ in place of Nᵢ beyond an end, τ = (xs − X)·X′/|X′|².
//!
//! At a centre of curvature r′ = 0: two feet merge, and the coordinate u has no derivative; it is set to 0 there.
//! Near it u is as ill-conditioned as 1/r′, but the separation is not.

#[cfg(feature = "verify")]
mod evidence;
mod linear;
mod parabolic;
mod piece;
mod roots;
mod smoothed_linear;
mod smoothed_parabolic;

pub use linear::{ClosestLinear, LinearSlave, SegmentFoot};
pub use parabolic::{ClosestParabolic, ParabolicSlave};
pub(super) use piece::{PieceFoot, curved_foot, straight_foot};
pub use smoothed_linear::{ClosestSmoothedLinear, CornerFoot, LinearCornerSlave};
pub use smoothed_parabolic::{ClosestSmoothedParabolic, ParabolicCornerSlave};

use super::basis::length_and_tangent;
use super::shape::{Shape, combination, gap};
use super::{left, length};
use crate::binade::Binade;
use crate::error::Error;
use crate::scalar::{Leaf, Scalar, abs, constant, leaf};
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use std::cmp::Ordering;
use std::marker::PhantomData;

/// A curve as seen from the slave point, in a unit of length near its own size.
///
/// X(u) = X(0) + c Y(u), where the factor c does not move the foot.
#[derive(Clone, Copy, Debug)]
struct View<D, S, const N: usize> {
    xs: Vector2<D>,
    nodes: [Vector2<D>; N],
    f: D,
    binade: Binade,
    shape: PhantomData<S>,
}

impl<D: Scalar, S: Shape<N>, const N: usize> View<D, S, N> {
    fn new(xs: Vector2<D>, nodes: [Vector2<D>; N], f: D) -> Self {
        let sides = nodes.iter().map(|x| x - nodes[N / 2]);
        let binade = Binade::of(sides.flat_map(|side| [side.x, side.y]));
        Self { xs, nodes, f, binade, shape: PhantomData }
    }

    fn in_unit(&self, v: Vector2<D>) -> Vector2<D> {
        v * D::from(self.binade.per_unit)
    }

    fn combination(&self, weights: [D; N]) -> Vector2<D> {
        self.in_unit(combination(&self.nodes, weights))
    }

    fn gap(&self, weights: [D; N]) -> Vector2<D> {
        self.in_unit(gap(self.xs, &self.nodes, weights))
    }

    fn at(&self, u: D) -> Place<D> {
        Place {
            gap: self.gap(S::weights(self.f, u)),
            rate: self.combination(S::rates(self.f, u)),
            bend: self.combination(S::bends(self.f, u)),
            factor: S::factor(self.f),
        }
    }

    /// A derivative with respect to a position, back in the model's unit of length.
    fn per_unit(&self, gradient: Vector2<D>) -> Vector2<D> {
        self.in_unit(gradient)
    }

    /// For the search of the foot.
    fn expansion(&self) -> Expansion<D::Leaf> {
        let zero = D::zero();
        let Place { gap, rate, bend, factor } = self.at(zero);
        let jolt = self.combination(S::jolts(self.f));
        let leaves = |v: Vector2<D>, factor: f64| v.map(|x| leaf(x * factor));
        let sixth = |v: Vector2<D>| v.map(|x| leaf(x / 6.0));
        Expansion {
            gap: leaves(gap, 1.0),
            factor: leaf(factor),
            y: [leaves(rate, 1.0), leaves(bend, 0.5), sixth(jolt)],
        }
    }
}

/// xs − X(0), c, and the coefficients of u, u², u³ in Y.
#[derive(Clone, Copy, Debug)]
struct Expansion<D> {
    gap: Vector2<D>,
    factor: D,
    y: [Vector2<D>; 3],
}

impl<D: Leaf> Expansion<D> {
    /// The coefficients of (xs − X)·Y′.
    fn residual(&self) -> [D; 6] {
        let Self { gap, factor, y: [y1, y2, y3] } = *self;
        [
            gap.dot(&y1),
            gap.dot(&y2) * 2.0 - factor * y1.dot(&y1),
            (gap.dot(&y3) - factor * y1.dot(&y2)) * 3.0,
            -(factor * (y1.dot(&y3) * 2.0 + y2.dot(&y2)) * 2.0),
            -(factor * y2.dot(&y3) * 5.0),
            -(factor * y3.dot(&y3) * 3.0),
        ]
    }

    fn y_at(&self, u: D) -> Vector2<D> {
        let [y1, y2, y3] = self.y;
        ((y3 * u + y2) * u + y1) * u
    }

    /// How the distance at u compares with that at v, both being minima; equal where rounding hides which is less.
    fn compare(&self, u: D, v: D) -> Ordering {
        // |G_u|² − |G_v|² = (G_u − G_v)·(G_u + G_v)
        let [reach_u, reach_v] = [u, v].map(|u| self.y_at(u) * self.factor);
        let (step, twice) = (reach_v - reach_u, self.gap * D::from(2.0));
        let excess = step.dot(&(twice - (reach_u + reach_v)));
        let size = |v: Vector2<D>| v.map(abs);
        let blur = size(step).dot(&(size(twice) + size(reach_u) + size(reach_v))) * (16.0 * D::EPSILON);
        if excess < -blur {
            Ordering::Less
        } else if excess > blur {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }
}

/// What a curve is at one of its points.
#[derive(Clone, Copy, Debug)]
struct Place<D> {
    /// xs − X.
    gap: Vector2<D>,
    /// Y′, along the tangent.
    rate: Vector2<D>,
    /// Y″.
    bend: Vector2<D>,
    /// c.
    factor: D,
}

impl<D: Scalar> Place<D> {
    /// (xs − X)·Y′: 0 at a foot, positive where the distance falls.
    fn residual(&self) -> D {
        self.gap.dot(&self.rate)
    }

    /// Its derivative: negative at a minimum of the distance, 0 at a centre of curvature.
    fn slope(&self) -> D {
        self.gap.dot(&self.bend) - self.factor * self.rate.dot(&self.rate)
    }

    /// Newton's step for the residual; 0 at a centre of curvature.
    fn newton_step(&self) -> D::Leaf {
        let slope = leaf(self.slope());
        if slope == 0.0 { slope } else { -leaf(self.residual()) / slope }
    }
}

/// The places of a curve where the distance has a minimum, in order; the ends among them.
struct Candidates<L> {
    expansion: Expansion<L>,
    /// The coordinate, and whether it is between the ends.
    places: ArrayVec<(L, bool), 7>,
}

impl<L: Leaf> Candidates<L> {
    /// Between two coordinates.
    ///
    /// Whether the distance falls at the ends is told by the full equation, and the search is held to it. So either an
    /// end counts or, between ends towards which it rises, a root is found, however near to an end.
    fn new<D: Scalar<Leaf = L>, S: Shape<N>, const N: usize>(view: &View<D, S, N>, ends: [L; 2]) -> Self {
        let expansion = view.expansion();
        let [low, high] = ends.map(|u| leaf(view.at(constant(u)).residual()));
        let mut places = ArrayVec::new();
        if low <= 0.0 {
            places.push((ends[0], false));
        }
        let roots = roots::falling(&expansion.residual(), ends, [low, high]);
        places.extend(roots.into_iter().map(|u| (u, true)));
        // Also where nothing was found because a number overflowed: the result then says so.
        if high >= 0.0 || places.is_empty() {
            places.push((ends[1], false));
        }
        Self { expansion, places }
    }

    /// The nearest; of two that are equally near, the one of smaller coordinate.
    fn nearest(&self) -> (L, bool) {
        let nearer = |best: (L, bool), next: (L, bool)| {
            if self.expansion.compare(next.0, best.0).is_lt() { next } else { best }
        };
        self.places.iter().copied().reduce(nearer).unwrap_or((L::from(f64::NAN), false))
    }
}

/// The closest point of a curve.
#[derive(Clone, Copy, Debug)]
struct Foot<D, const N: usize> {
    u: D,
    /// What the foot is from u, as far as the numbers tell: less than half the distance to the next.
    missing: D,
    /// The weights of the nodes in X, for a change of the separation.
    ///
    /// Beyond an end they are those of the point of the tangent that is closest to the slave point.
    weights: [D; N],
    /// The weights of the nodes in Y′.
    rates: [D; N],
    /// xs minus the point of these weights.
    gap: Vector2<D>,
    /// Y′.
    rate: Vector2<D>,
    /// 1/r′, or 0 where the foot does not move.
    per_slope: D,
    /// How far the slave point is beyond an end: its distance along the tangent, per |Y′|; 0 inside.
    beyond: D,
    inside: bool,
}

impl<D: Scalar, const N: usize> Foot<D, N> {
    /// Whether Y′ is no more than the rounding of its terms.
    fn stands_still<S: Shape<N>>(&self, view: &View<D, S, N>) -> bool {
        let base = view.nodes[N / 2];
        let size = |v: Vector2<D>| v.x.re().abs() + v.y.re().abs();
        let terms: f64 = view.nodes.iter().zip(self.rates).map(|(x, rate)| size(view.in_unit((x - base) * rate))).sum();
        size(self.rate) <= 8.0 * f64::EPSILON * terms
    }

    /// On the whole curve.
    fn on<S: Shape<N>>(view: &View<D, S, N>) -> Self {
        Self::between(view, S::ENDS.map(D::Leaf::from))
    }

    /// On the part between two coordinates.
    fn between<S: Shape<N>>(view: &View<D, S, N>, ends: [D::Leaf; 2]) -> Self {
        let (u, inside) = Candidates::new(view, ends).nearest();
        if inside { Self::inside(view, u, ends) } else { Self::at_end(view, constant(u)) }
    }

    /// At a root, brought to working precision and given its derivatives.
    fn inside<S: Shape<N>>(view: &View<D, S, N>, u: D::Leaf, [from, to]: [D::Leaf; 2]) -> Self {
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
        let moved = |n: [D; N], rates: [D; N], step: D| std::array::from_fn(|k| n[k] + rates[k] * step);
        let rates = S::rates(view.f, u);
        let weights = moved(S::weights(view.f, u), rates, S::factor(view.f) * missing);
        let place = Place {
            gap: view.gap(weights),
            rate: place.rate + place.bend * missing,
            bend: place.bend + view.combination(S::jolts(view.f)) * missing,
            ..place
        };
        let slope = place.slope();
        Self {
            u,
            missing,
            weights,
            rates: moved(rates, S::bends(view.f, u), missing),
            gap: place.gap,
            rate: place.rate,
            per_slope: if slope == 0.0 { D::zero() } else { slope.recip() },
            beyond: D::zero(),
            inside: true,
        }
    }

    fn at_end<S: Shape<N>>(view: &View<D, S, N>, u: D) -> Self {
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

    fn normal(&self) -> Vector2<D> {
        left(length_and_tangent(self.rate).1)
    }

    /// 1 − u and u of a corner, with what is missing.
    fn parts(&self) -> [D; 2] {
        [-self.u + 1.0 - self.missing, self.u + self.missing]
    }

    /// |Y′| in the model's unit of length.
    fn speed<S: Shape<N>>(&self, view: &View<D, S, N>) -> D {
        length(self.rate) * view.binade.unit
    }

    /// n·(xs − X).
    fn separation(&self) -> D {
        self.normal().dot(&self.gap)
    }

    /// The gradient of the coordinate with respect to a node that has these weights in X and Y′.
    ///
    /// The slave point is a node of weights −1 and 0.
    fn coordinate_by(&self, n: D, m: D) -> Vector2<D> {
        (self.rate * n - self.gap * m) * self.per_slope
    }
}

/// Rejects a curve that [stands still](Foot::stands_still) at the foot.
fn check_tangent<S: Shape<N>, const N: usize>(view: &View<f64, S, N>, coordinate: &'static str) -> Result<(), Error> {
    let foot = Foot::on(view);
    if foot.stands_still(view) { Err(Error::NoTangent { coordinate, value: foot.u }) } else { Ok(()) }
}
