//! SLIDER: node m stays on the straight line through nodes 1 and n, which may move.
//!
//! | | |
//! |---|---|
//! | frames | the global axes i, j, k; the line has d = xn − x1, l = abs(d), n = d/l |
//! | matrix | the columns t1, t2, n are orthonormal and right-handed (t1 × t2 = n): t1 = n × i normalised, or n × k if n is along i; t2 = n × t1 |
//! | position | node m is at the fraction ξ = (xm − x1)·n/l of the line: 0 at node 1, 1 at node n |
//! | zero position | node m on the line: (xm − x1)·t1 = (xm − x1)·t2 = 0 |
//! | signs | in the plane the distance g is positive to the left of the direction from node 1 to node n |
//!
//! Two of the three coordinates of m follow from the third; [`Pivots`] determines which two. The formulas take the direct route,
//! through the ratios n_i/n_k. The [`documented`] route, through t1 and t2, is their definition, and gives the same result.

#![expect(clippy::inline_always, reason = "a call would write the coordinates to memory, and wait for them there")]

mod across;
mod along;
#[cfg(feature = "scene")]
pub(crate) mod axes;
mod basis;
mod connector;
mod connector_plane;
mod constraint;
mod element;
mod eliminate;
mod equation;
#[cfg(feature = "verify")]
pub(crate) mod hard;
mod line;
mod pivots;
mod place;
mod plane;
pub mod rows;
pub mod rows_plane;
#[cfg(feature = "verify")]
mod running;
mod slide;
mod span;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub(crate) use across::Axis;
pub use basis::{Basis, BasisVariation, LineDirection, TangentChanges, Tangents, TurningDirection};
pub use connector::{Coefficients, Slider, Variations};
pub use connector_plane::{Coefficients2d, Slider2d};
pub use constraint::{Constraint, Distances, IncrementalConstraint, IncrementalResiduals, MovingNodes, Nodes};
pub use element::{SliderElement, SliderElement2d};
pub use eliminate::{Coordinates, Eliminate, Increment, Increments, KeptCoordinate, KeptIncrement, documented};
pub use equation::{LineNode, LinearEquation, Term};
pub use line::{Direction, DirectionChange, DirectionVariation, Ends, Line, MovingEnds};
pub use pivots::{Pivots, Pivots2d};
pub use plane::{
    Constraint2d, Coordinate2d, Distance2d, Eliminate2d, Increment2d, Increment2dOutput, IncrementalConstraint2d,
    IncrementalResidual2d, KeptCoordinate2d, KeptIncrement2d, MovingNodes2d, Nodes2d,
};
pub(crate) use span::{Span, Station};
