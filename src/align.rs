//! ALIGN: node b keeps the orientation to node a that it had at the start.
//!
//! The three Cardan angles of b's triad relative to a's ([`crate::cardan`]) stay at their initial values, all
//! zero where both triads agree. Moments act on node b.
//!
//! [`Align`] is what a program calls; the formulas behind it stand in [`Constraint`] and [`ConstraintMoment`].

mod connector;
mod kinematics;

pub use connector::Align;
pub use kinematics::*;
