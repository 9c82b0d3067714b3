use super::{Nodes, Nodes2d, SliderElement, SliderElement2d};
use crate::Octuple;
use crate::element::Nothing;
use crate::element::Parameters;
use crate::formula::proof::{Case, ProvedElement, Step};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector1, Vector2, Vector3};

/// Node m projected onto the line.
fn on_line<D: Scalar, const N: usize>([x1, xn, xm]: [SVector<D, N>; 3]) -> SVector<D, N> {
    let d = xn - x1;
    x1 + d * ((xm - x1).dot(&d) / d.dot(&d))
}

const ON_LINE: &str = "on the line, a quarter of its length from node 1";

/// Nodes 1, n and m.
fn poses() -> [(&'static str, &'static str, [Vector3<f64>; 3]); 7] {
    let (x1, d, beside) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(2.0, -1.0, 4.0), Vector3::new(0.25, 0.5, -0.125));
    let far = Vector3::new(1e8, -1e8, 1e8);
    [
        (
            "level",
            "the line is across the third axis, five long, and m one along it",
            [Vector3::zeros(), Vector3::new(3.0, 4.0, 0.0), Vector3::new(0.6, 0.8, 0.0)],
        ),
        ("on-line", ON_LINE, [x1, x1 + d, x1 + d * 0.25]),
        ("beside", "beside the line", [x1, x1 + d, x1 + d * 0.25 + beside]),
        ("before", "before node 1 and beside the line", [x1, x1 + d, x1 - d * 0.5 + beside]),
        ("past", "past node n and beside the line", [x1, x1 + d, x1 + d * 1.5 + beside]),
        ("offset-1e8", "far from the origin", [x1 + far, x1 + far + d, x1 + far + d * 0.25 + beside]),
        ("length-1e8", "a long line", [x1, x1 + d * 1e8, x1 + d + beside]),
    ]
}

impl ProvedElement<2, 9> for SliderElement {
    const EXACT_ROWS: bool = false;

    fn cases() -> Vec<Case<Step<Self, f64, 2, 9>>> {
        let (multipliers, before) = (Vector2::new(3.0, -4.0), Nothing::new());
        let parameters = Parameters { start: Nothing::new(), contact: None };
        let step =
            |[x1, xn, xm]: [Vector3<f64>; 3]| Step { nodes: Nodes { x1, xn, xm }, multipliers, parameters, before };
        poses().map(|(id, comment, places)| Case::hard(id, comment, step(places))).into()
    }

    fn held(step: Step<Self, Octuple, 2, 9>) -> Step<Self, Octuple, 2, 9> {
        let Nodes { x1, xn, xm } = step.nodes;
        Step { nodes: Nodes { x1, xn, xm: on_line([x1, xn, xm]) }, ..step }
    }
}

impl ProvedElement<1, 6> for SliderElement2d {
    const EXACT_ROWS: bool = false;

    fn cases() -> Vec<Case<Step<Self, f64, 1, 6>>> {
        let (multipliers, before) = (Vector1::new(3.0), Nothing::new());
        let parameters = Parameters { start: Nothing::new(), contact: None };
        let step = |places: [Vector3<f64>; 3]| {
            let [x1, xn, xm] = places.map(|x| x.xy());
            Step { nodes: Nodes2d { x1, xn, xm }, multipliers, parameters, before }
        };
        poses().map(|(id, comment, places)| Case::hard(id, comment, step(places))).into()
    }

    fn held(step: Step<Self, Octuple, 1, 6>) -> Step<Self, Octuple, 1, 6> {
        let Nodes2d { x1, xn, xm } = step.nodes;
        Step { nodes: Nodes2d { x1, xn, xm: on_line([x1, xn, xm]) }, ..step }
    }
}
