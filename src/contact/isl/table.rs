//! ISL21A and ISL22A, the axisymmetric elements that slide on a slide line.
//!
//! The formulas are listed here for the quantities they compute; which of them a node needs depends on its position on the line,
//! so that they are evaluated by [`isl`](crate::contact::isl), not in the plan's registers.

use crate::contact::{coulomb, interaction, slide_line};
use crate::element::table::{Dimension, Kind, Use, always, renamed};
use crate::formula::quantity::{Domain, NORMAL, Quantity, Shape, TANGENT, Unit};

const STRESS: Unit = Unit::new(-2, 1, 0);

const E12: Quantity = Quantity {
    latex: "E12",
    shape: Shape::Scalar,
    unit: Unit::L,
    domain: Domain::Real,
    meaning: "accumulated relative tangential displacement of each node, positive along the line",
};
const S11: Quantity =
    Quantity { latex: "S11", unit: STRESS, meaning: "pressure at each node, positive when it pushes", ..E12 };
const S12: Quantity = Quantity {
    latex: "S12",
    unit: STRESS,
    meaning: "shear stress at each node, positive when it resists positive slip",
    ..E12
};

const AREA: Quantity = Quantity {
    latex: "A",
    unit: Unit::new(2, 0, 0),
    meaning: "part of the contact area of each node that belongs to this element, around the whole circumference",
    ..E12
};
const T1: Quantity =
    Quantity { latex: r"\mathbf{t}_1", meaning: "tangent of the line at the closest point of each node", ..TANGENT };
const T2: Quantity = Quantity {
    latex: r"\mathbf{t}_2\cdot\mathbf{s}",
    unit: Unit::ONE,
    meaning: "second tangent of the line along the circumferential direction s, at each node: t2 = −s",
    ..E12
};
const N: Quantity = Quantity { meaning: "normal of the line at the closest point of each node", ..NORMAL };

/// A coordinate along the line is no output.
const FOOT: &[(&str, &str)] = &[("g", "coordinate"), ("separation", "e11")];
const SMOOTHED_FOOT: &[(&str, &str)] = &[("t", "coordinate"), ("separation", "e11")];
const SLIP: &[(&str, &str)] = &[("dslip", "e12")];
const PRESSURE: &[(&str, &str)] = &[("p", "s11")];

/// The formulas of contact, which every element on a slide line has at its nodes.
const CONTACT: &[Use] = &[
    renamed(&slide_line::ClosestLinear, FOOT),
    renamed(&slide_line::ClosestSmoothedLinear, SMOOTHED_FOOT),
    renamed(&slide_line::ClosestParabolic, FOOT),
    renamed(&slide_line::ClosestSmoothedParabolic, SMOOTHED_FOOT),
    renamed(&slide_line::SlipIncrementLinear, SLIP),
    renamed(&slide_line::SlipIncrementParabolic, SLIP),
    renamed(&interaction::PressureLinear, PRESSURE),
    renamed(&interaction::PressureExponential, PRESSURE),
    renamed(&interaction::Damping, PRESSURE),
    renamed(&coulomb::Response, &[("f", "s12")]),
];

pub(crate) const ISL21A: Kind = Kind {
    name: "isl21a",
    dimension: Dimension::Axisymmetric,
    nodes: &["1", "2"],
    given: &[],
    ordered: &[],
    formulas: &[
        CONTACT,
        &[
            always(&slide_line::TorqueLinear),
            renamed(&slide_line::ContactAreaLinear, &[("a1", "area"), ("a2", "area")]),
        ],
    ],
    meanings: &[
        ("e12", &E12),
        ("s11", &S11),
        ("s12", &S12),
        ("area", &AREA),
        ("tangent", &T1),
        ("normal", &N),
        ("second_tangent", &T2),
    ],
    outputs: &[&[
        ("E11", "e11"),
        ("E12", "e12"),
        ("S11", "s11"),
        ("S12", "s12"),
        ("T", "t"),
        ("AREA", "area"),
        ("T1", "tangent"),
        ("N", "normal"),
        ("T2", "second_tangent"),
    ]],
};

pub(crate) const ISL22A: Kind = Kind {
    name: "isl22a",
    nodes: &["1", "2", "3"],
    formulas: &[
        CONTACT,
        &[
            always(&slide_line::TorqueParabolic),
            renamed(&slide_line::ContactAreaParabolic, &[("a1", "area"), ("a2", "area"), ("a3", "area")]),
        ],
    ],
    ..ISL21A
};
