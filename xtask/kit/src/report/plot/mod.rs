//! Plots as SVG for inclusion in a page: colours, type and line widths come from the theme by classes, so that they
//! follow light and dark mode, and every colour is accompanied by a shape or a dash.

mod all;
mod curve;
mod overview;
mod plane;
mod style;

pub(crate) use all::all;
pub(crate) use curve::curve;
pub(crate) use overview::overview;
pub(crate) use plane::plane;
