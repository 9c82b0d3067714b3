//! The closest point of a curve to the slave point.
//!
//! The foot X(u) of the slave point xs on a curve makes the gap xs − X perpendicular to the curve, (xs − X)·X′ = 0: a
//! polynomial equation of degree 1, 3 or 5. The algorithm, for every curve:
//!
//! 1. Scale the curve to a unit near its own size, a power of two ([`View`]), and expand X in powers of u ([`Expansion`]).
//! 2. Find every root at which (xs − X)·X′ falls through 0, a minimum of the distance: bracketed by the roots of the
//!    derivative, by Newton's method or bisection ([`roots`]), in numbers without derivatives, to full precision.
//! 3. Add an end if the distance increases from it into the curve ([`Reach`]).
//! 4. Take the nearest of them; of two that are equally near to within rounding errors, the one with the smaller coordinate.
//! 5. Refine it in the full scalar ([`Foot`]): one step of Newton's method on the equation from differences of nodes.
//! 6. Compute its derivatives by the implicit function theorem: a further step for each order.
//! 7. Apply the remaining fraction of a step, below the resolution of doubles, to weights, gap and tangent.
//! 8. Compute E11 = (xs − X)·n; beyond an end from the tangent there.
//!
//! With r(u) = (xs − X)·X′ the closed form is ∂u/∂xs = −X′/r′ and ∂u/∂xᵢ = (Nᵢ X′ − Nᵢ′ (xs − X))/r′; and since to first order
//! the motion of the foot is irrelevant, ∂E11/∂xs = n and ∂E11/∂xᵢ = −Nᵢ n, with Nᵢ + τ Nᵢ′ in place of Nᵢ beyond an end,
//! τ = (xs − X)·X′/|X′|².
//!
//! At a centre of curvature r′ = 0: two feet merge, and the coordinate u has no derivative; it is set to 0 there.
//! Near it u is as ill-conditioned as 1/r′, but the separation is not.

mod candidates;
#[cfg(feature = "verify")]
pub(super) mod evidence;
mod expansion;
mod foot;
mod linear;
mod parabolic;
mod piece;
mod roots;
mod smoothed_linear;
mod smoothed_parabolic;
mod view;

pub use linear::{ClosestLinear, LinearSlave, SegmentFoot};
pub use parabolic::{ClosestParabolic, ParabolicSlave};
pub(super) use piece::{PieceFoot, curved_foot, straight_foot};
pub use smoothed_linear::{ClosestSmoothedLinear, CornerFoot, LinearCornerSlave};
pub use smoothed_parabolic::{ClosestSmoothedParabolic, ParabolicCornerSlave};

use foot::Foot;
use view::View;
#[cfg(doc)]
use {candidates::Reach, expansion::Expansion};
