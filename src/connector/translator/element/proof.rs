use super::{SlotState, TranslatorContact, TranslatorElement, TranslatorStart};
use crate::connector::slot::RelativePosition;
use crate::connector::slot::element::proof::along;
use crate::connector::translator::{Friction, FrictionLoads};
use crate::element::Parameters;
use crate::element::angle::{self, AlignLoads};
use crate::element::nodes::proof::poses;
use crate::formula::Formula;
use crate::formula::proof::{Case, ProvedElement, Rubbed, Step};
use crate::number::scalar::Scalar;
use nalgebra::SVector;

impl ProvedElement<5> for TranslatorElement {
    fn cases() -> Vec<Case<Step<Self, f64, 5>>> {
        let (multipliers, before) = (SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]), SlotState { u1: 0.5, f1: -0.25 });
        let start = TranslatorStart { x0: 0.125, y0: 0.25, z0: -0.5, alpha0: 0.375, beta0: 0.25, gamma0: -0.625 };
        let rubs = |k_stick, rr, l| Some(TranslatorContact { k_stick, rr, l, fc_int: 1.0, mu: 0.25 });
        let ways = [
            ("", None),
            ("-soft", rubs(0.0625, 0.5, 2.0)),
            ("-stiff", rubs(1e3, 0.5, 2.0)),
            ("-forces-alone", rubs(1e3, 0.0, 0.0)),
        ];
        let step = |nodes, contact| Step { nodes, multipliers, parameters: Parameters { start, contact }, before };
        let all = poses().into_iter().flat_map(|pose| {
            ways.map(|(how, contact)| Case::hard(format!("{}{how}", pose.id), pose.comment, step(pose.value, contact)))
        });
        all.collect()
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 5>, after: &SlotState<D>) -> Vec<Rubbed<D>> {
        let Parameters { start, contact } = step.parameters;
        let Some(TranslatorContact { k_stick, rr, l, fc_int, mu }) = contact else { return Vec::new() };
        let motion = RelativePosition::eval(&step.nodes.positions()).x - start.x0;
        let [f2, f3, l1, l2, l3] = step.multipliers.data.0[0];
        let moment = angle::Moments::eval(&AlignLoads::new(&step.nodes.triads(), [l1, l2, l3])).mb;
        let [m1, m2, m3] = [l1, step.nodes.e2a.dot(&moment), step.nodes.e3a.dot(&moment)];
        let phi = |f1| Friction::eval(&FrictionLoads { f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu }).phi;
        vec![along(motion, k_stick, [step.before, *after], phi)]
    }
}
