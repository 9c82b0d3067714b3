//! ALIGN: node b keeps the orientation to node a that it had at the start.
//!
//! | | |
//! |---|---|
//! | frames | the triads e1a, e2a, e3a and e1b, e2b, e3b of both nodes, each orthonormal and right-handed |
//! | matrix | `R_ij = e_ia·e_jb` = R1(α) R2(β) R3(γ), written out in [`cardan`](crate::element::cardan) |
//! | zero position | both triads equal: α = β = γ = 0; the constraint holds the initial angles α0, β0, γ0 |
//! | signs | each angle rotates b relative to a by the right-hand rule: α about e1a, β about the line of nodes, γ about e3b; m1 e1a + m2 e2a + m3 e3a acts on b and its opposite on a |
//!
//! [`Align`] is what a program calls; its formulas are [`Constraint`] and [`ConstraintMoment`].

mod connector;
mod element;
mod kinematics;
#[cfg(feature = "scene")]
pub(crate) mod since;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use connector::{Align, AlignFromStart};
pub(crate) use element::MULTIPLIERS;
pub use element::{AlignElement, AlignStart};
pub(crate) use kinematics::wrapped;
pub use kinematics::{Constraint, ConstraintMoment, Misalignment, Moment, Moments, Orientations};
