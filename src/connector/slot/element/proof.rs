use super::{SlotContact, SlotElement, SlotStart, SlotState};
use crate::connector::slot::{Friction, RelativePosition, SlotLoads};
use crate::element::Parameters;
use crate::element::nodes::proof::poses;
use crate::formula::Formula;
use crate::formula::proof::{Case, ProvedElement, Rubbed, Step};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

/// The friction along a slot, from the states before and after the step.
pub(crate) fn along<D: Scalar>(
    u1: D,
    k_stick: D,
    [before, after]: [SlotState<D>; 2],
    phi: impl FnOnce(D) -> D,
) -> Rubbed<D> {
    Rubbed { motion: u1 - before.u1, force: [before.f1, after.f1], k_stick, phi: phi(after.f1) }
}

impl ProvedElement<2> for SlotElement {
    fn cases() -> Vec<Case<Step<Self, f64, 2>>> {
        let (multipliers, before) = (Vector2::new(3.0, -4.0), SlotState { u1: 0.5, f1: -0.25 });
        let start = SlotStart { x0: 0.125, y0: 0.25, z0: -0.5 };
        let rubs = |k_stick| Some(SlotContact { k_stick, fc_int: 1.0, mu: 0.25 });
        let step = |nodes, contact| Step { nodes, multipliers, parameters: Parameters { start, contact }, before };
        let all = poses().into_iter().flat_map(|pose| {
            [("", None), ("-soft", rubs(0.0625)), ("-stiff", rubs(1e3))]
                .map(|(how, contact)| Case::hard(format!("{}{how}", pose.id), pose.comment, step(pose.value, contact)))
        });
        all.collect()
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 2>, after: &SlotState<D>) -> Vec<Rubbed<D>> {
        let Parameters { start, contact } = step.parameters;
        let Some(SlotContact { k_stick, fc_int, mu }) = contact else { return Vec::new() };
        let motion = RelativePosition::eval(&step.nodes.positions()).x - start.x0;
        let [f2, f3] = *step.multipliers.as_ref();
        let phi = |f1| Friction::eval(&SlotLoads { f1, f2, f3, fc_int, mu }).phi;
        vec![along(motion, k_stick, [step.before, *after], phi)]
    }
}
