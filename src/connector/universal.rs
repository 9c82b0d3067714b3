//! UNIVERSAL: two shafts, e1a and e3b, stay at their initial angle, normally a right angle, and each rotates freely.
//!
//! | | |
//! |---|---|
//! | frames | the triads e1a, e2a, e3a and e1b, e2b, e3b of both nodes, each orthonormal and right-handed |
//! | matrix | `R_ij = e_ia·e_jb` = R1(α) R2(β) R3(γ), written out in [`cardan`](crate::element::cardan); the constraint holds `R_13` = e1a·e3b = sin β |
//! | zero position | both triads equal: α = β = γ = 0; the constraint holds the initial c0 = e1a·e3b |
//! | signs | α rotates b relative to a about e1a, γ about e3b, both by the right-hand rule; m2 acts on b and its opposite on a; m1 and m3 are conjugate to ur1 and ur3, so that m1 e1a + m3 e3b acts on a and its opposite on b |
//!
//! The formulas are in two modules: angles and constraint in one, moments in the other. [`Universal`] is what a program calls.

mod connector;
mod element;
mod kinematics;
mod moments;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use connector::Universal;
pub use element::{UniversalElement, UniversalStart};
pub use kinematics::{Angles, Constraint, RelativeMotion, Rotations, Shafts, Skew, Turns, TurnsSince};
pub use moments::{ConstraintMoment, Driven, FreeMoment, KineticMoment, Moment, Twisted};
