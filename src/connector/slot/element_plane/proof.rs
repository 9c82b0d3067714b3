use super::{SlotContact, SlotElement2d, SlotStart2d, SlotState};
use crate::connector::slot::element::proof::along;
use crate::connector::slot::plane::PlanePlaces;
use crate::connector::slot::{Friction, SlotLoads};
use crate::element::Parameters;
use crate::formula::Formula;
use crate::formula::proof::hard::plane_triad;
use crate::formula::proof::{Case, ProvedElement, Rubbed, Step};
use crate::number::scalar::Scalar;
use nalgebra::{Vector1, Vector2};

impl ProvedElement<1, 6> for SlotElement2d {
    fn cases() -> Vec<Case<Step<Self, f64, 1, 6>>> {
        let ([_, e2a], near) = (plane_triad(), Vector2::new(0.75, -0.5));
        let poses = [
            (
                "aligned",
                "along the global axes",
                PlanePlaces { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(2.0, 0.0) },
            ),
            (
                "turned",
                "away from both axes",
                PlanePlaces { e2a, xa: Vector2::new(1.0, 2.0), xb: Vector2::new(2.5, 2.25) },
            ),
            ("coincident", "both nodes coincide", PlanePlaces { e2a, xa: near, xb: near }),
            ("offset-1e8", "far from the origin", PlanePlaces { e2a, xa: near * 1e8, xb: near * 1e8 + near }),
            ("distance-1e8", "nodes far apart", PlanePlaces { e2a, xa: near, xb: near * 1e8 }),
        ];
        let (multipliers, before) = (Vector1::new(-4.0), SlotState { u1: 0.5, f1: -0.25 });
        let start = SlotStart2d { x0: 0.25, y0: -0.5 };
        let rubs = |k_stick| Some(SlotContact { k_stick, fc_int: 1.0, mu: 0.25 });
        let step = |nodes, contact| Step { nodes, multipliers, parameters: Parameters { start, contact }, before };
        let all = poses.into_iter().flat_map(|(id, comment, nodes)| {
            [("", None), ("-soft", rubs(0.0625)), ("-stiff", rubs(1e3))]
                .map(|(how, contact)| Case::hard(format!("{id}{how}"), comment, step(nodes, contact)))
        });
        all.collect()
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 1, 6>, after: &SlotState<D>) -> Vec<Rubbed<D>> {
        let Parameters { start, contact } = step.parameters;
        let Some(SlotContact { k_stick, fc_int, mu }) = contact else { return Vec::new() };
        let PlanePlaces { e2a, xa, xb } = step.nodes;
        let motion = e2a.perp(&(xa - xb)) - start.x0;
        let phi = |f1| Friction::eval(&SlotLoads { f1, f2: step.multipliers.x, f3: D::zero(), fc_int, mu }).phi;
        vec![along(motion, k_stick, [step.before, *after], phi)]
    }
}
