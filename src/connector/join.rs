//! JOIN: node b stays at its initial position in the triad of node a.
//!
//! | | |
//! |---|---|
//! | frames | the triad e1a, e2a, e3a of node a; node b has none |
//! | position | d = xb − xa in that triad: (e1a·d, e2a·d, e3a·d) = Rᵀ d, where the columns of R are e1a, e2a, e3a |
//! | zero position | the initial position d0, which is 0 if the nodes coincide |
//! | signs | f1 e1a + f2 e2a + f3 e3a acts on b and its opposite on a |
//!
//! [`Join`] is what a program calls.

mod connector;
mod element;
mod kinematics;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use connector::Join;
pub use element::{JoinElement, JoinStart};
pub use kinematics::{Constraint, Displaced, Joined};
