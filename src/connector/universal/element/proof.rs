use super::{UniversalElement, UniversalStart};
use crate::element::nodes::proof::poses;
use crate::element::{Nothing, Parameters};
use crate::formula::proof::{Case, ProvedElement, Step};
use nalgebra::Vector1;

impl ProvedElement<1> for UniversalElement {
    fn cases() -> Vec<Case<Step<Self, f64, 1>>> {
        let multipliers = Vector1::new(3.0);
        let parameters = Parameters { start: UniversalStart { c0: 0.25 }, contact: None };
        let step = |nodes| Step { nodes, multipliers, parameters, before: Nothing::new() };
        poses().map(|pose| Case::hard(pose.id, pose.comment, step(pose.value))).into()
    }
}
