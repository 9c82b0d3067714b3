//! Plots as SVG, to stand in a page: colours, type and line widths come from the theme by classes, so that they follow
//! light and dark, and every colour has a shape or a dash beside it.

mod curve;
mod drawing;
mod overview;
mod plane;

pub(crate) use curve::curve;
pub(crate) use overview::overview;
pub(crate) use plane::plane;
