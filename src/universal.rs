//! UNIVERSAL: two shafts, e1a and e3b, stay at their initial angle, a right one as a rule, and each turns freely.
//!
//! Of the Cardan angles of b relative to a ([`crate::cardan`]) the second is held, e1a·e3b = sin β = c0; α about e1a and
//! γ about e3b are free. The formulas stand in two rooms: angles and constraint in one, moments in the other.
//! [`Universal`] is what a program calls.

mod connector;
mod kinematics;
mod moments;

pub use connector::Universal;
pub use kinematics::*;
pub use moments::*;
