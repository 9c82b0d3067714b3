use super::{JoinElement, JoinStart};
use crate::element::nodes::proof::poses;
use crate::element::{Nothing, Parameters};
use crate::formula::proof::{Case, ProvedElement, Step};
use nalgebra::Vector3;

impl ProvedElement<3> for JoinElement {
    fn cases() -> Vec<Case<Step<Self, f64, 3>>> {
        let multipliers = Vector3::new(3.0, -4.0, 2.0);
        let parameters = Parameters { start: JoinStart { d0: Vector3::new(0.5, 0.25, 0.125) }, contact: None };
        let step = |nodes| Step { nodes, multipliers, parameters, before: Nothing::new() };
        poses().map(|pose| Case::hard(pose.id, pose.comment, step(pose.value))).into()
    }
}
