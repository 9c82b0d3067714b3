//! Plots as SVG: one axis and one drawing for the figures of the book, the results of scenes and the report.

mod axis;
mod chart;
mod drawing;

pub use axis::Axis;
pub(crate) use axis::{power, rounded};
pub use chart::{Chart, Curve};
pub use drawing::tenth;
pub(crate) use drawing::{BY_CLASS, Drawing};
