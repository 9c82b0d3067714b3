//! Slide lines.

use crate::statements::erratum::{Erratum, apart, at, erratum};
use jointproof::contact::slide_line::{self, LinearNodes};
use jointproof::formula::Formula;
use nalgebra::Vector2;
use std::f64::consts::PI;

pub(super) fn errata() -> Vec<Erratum> {
    vec![width()]
}

fn width() -> Erratum {
    let nodes = LinearNodes { x1: Vector2::new(1.0, 0.0), x2: Vector2::new(3.0, 0.0) };
    let (length, radii) = ((nodes.x2 - nodes.x1).norm(), [nodes.x1.x, nodes.x2.x]);
    let ring = PI * length * (radii[0] + radii[1]);
    let constant = 2.0 * PI * radii[0] * length;
    let slide_line::TwoAreas { a1, a2 } = slide_line::ContactAreaLinear::eval(&nodes);
    erratum(
        "width-of-an-element",
        vec![
            at(
                "a straight element, from $r = 1$ to $r = 3$",
                "the areas of its nodes add up to that of the ring between them",
            )
            .literal(
                "one width, that of the first node",
                r"A_1 + A_2 = 2\pi r_1\,\ell",
                constant,
                apart(constant, ring),
            )
            .here::<slide_line::ContactAreaLinear>(
                r"A_1 + A_2 = \pi\ell\,r_1 + \pi\ell\,r_2",
                a1 + a2,
                apart(a1 + a2, ring),
            ),
        ],
    )
}
