use super::{AlignElement, AlignStart};
use crate::element::nodes::proof::poses;
use crate::element::{Nothing, Parameters};
use crate::formula::proof::{Case, ProvedElement, Step};
use nalgebra::Vector3;

impl ProvedElement<3> for AlignElement {
    fn cases() -> Vec<Case<Step<Self, f64, 3>>> {
        let multipliers = Vector3::new(3.0, -4.0, 2.0);
        let start = AlignStart { alpha0: 0.375, beta0: 0.25, gamma0: -0.625 };
        let parameters = Parameters { start, contact: None };
        let step = |nodes| Step { nodes, multipliers, parameters, before: Nothing::new() };
        poses().map(|pose| Case::hard(pose.id, pose.comment, step(pose.value))).into()
    }
}
