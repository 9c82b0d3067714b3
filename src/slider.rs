//! SLIDER: node m stays on the straight line through nodes 1 and n, which may move.
//!
//! The line runs from x1 to xn, with d = xn − x1, l = |d| and n = d/l. Node m sits at the share ξ = (xm − x1)·n/l of
//! the way. Two of its three coordinates follow from the third; which two, [`Pivots`] says.
//!
//! The formulas take the direct route, by the ratios n_i/n_k. The [`documented`] route, through directions t1, t2 across the
//! line, is their definition, and equal to them.

#![expect(clippy::inline_always, reason = "a call would write the coordinates to memory, and wait for them there")]

mod across;
mod basis;
mod connector;
mod connector_plane;
mod constraint;
pub mod documented;
mod eliminate;
mod hard;
mod line;
mod pivots;
mod place;
mod plane;
mod slide;
mod span;
mod stability;

pub use basis::*;
pub use connector::{Coefficients, Slider, Variations};
pub use connector_plane::{Coefficients2d, Slider2d};
pub use constraint::*;
pub use eliminate::*;
pub use line::*;
pub use pivots::*;
pub use plane::*;
pub use stability::{RouteErrors, Setting};
