//! SLIDER in scenes: in space, in the plane and in the plane of radius and axis.

use super::axes::{KeptAxis, KeptAxis2d, PivotAxes, PivotAxis2d};
use crate::connector::slider;
use crate::element::table::{Dimension, Kind, Origin, always};
use Origin::{Increment, Position};

pub(crate) const SLIDER: Kind = Kind {
    name: "slider",
    dimension: Dimension::Space,
    nodes: &["first", "last", "node"],
    given: &[&[
        ("x1", Position(0)),
        ("xn", Position(1)),
        ("xm", Position(2)),
        ("dx1", Increment(0)),
        ("dxn", Increment(1)),
        ("dxm", Increment(2)),
    ]],
    ordered: &[],
    formulas: &[&[
        always(&slider::Line),
        always(&slider::Constraint),
        always(&slider::IncrementalConstraint),
        always(&KeptAxis),
        always(&PivotAxes),
        always(&slider::Eliminate),
        always(&slider::Increment),
    ]],
    meanings: &[],
    outputs: &[&[
        ("N", "n"),
        ("L", "l"),
        ("G1", "g1"),
        ("G2", "g2"),
        ("R1", "r1"),
        ("R2", "r2"),
        ("AXES", "axes"),
        ("XMI", "xmi"),
        ("XMJ", "xmj"),
        ("DXMI", "dxmi"),
        ("DXMJ", "dxmj"),
    ]],
};

/// The line is the formula of space: positions have a third coordinate, which is 0.
pub(crate) const SLIDER_2D: Kind = Kind {
    dimension: Dimension::Plane,
    formulas: &[&[
        always(&slider::Line),
        always(&slider::Constraint2d),
        always(&slider::IncrementalConstraint2d),
        always(&KeptAxis2d),
        always(&PivotAxis2d),
        always(&slider::Eliminate2d),
        always(&slider::Increment2d),
    ]],
    outputs: &[&[("N", "n"), ("L", "l"), ("G", "g"), ("R", "r"), ("AXIS", "axis"), ("XMI", "xmi"), ("DXMI", "dxmi")]],
    ..SLIDER
};

/// The same in the plane of radius and axis.
pub(crate) const SLIDER_AXISYMMETRIC: Kind = Kind { dimension: Dimension::Axisymmetric, ..SLIDER_2D };
