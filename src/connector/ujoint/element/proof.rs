use super::{Nodes, UJointContact, UJointElement, UJointStart, UJointState, turned};
use crate::connector::ujoint::{Friction, FrictionLoads, YieldPair};
use crate::element::Parameters;
use crate::element::nodes::proof::poses;
use crate::formula::Formula;
use crate::formula::proof::{Case, ProvedElement, Rubbed, Step};
use crate::number::scalar::Scalar;
use nalgebra::{Vector3, Vector4};

impl ProvedElement<4> for UJointElement {
    fn cases() -> Vec<Case<Step<Self, f64, 4>>> {
        let multipliers = Vector4::new(3.0, -4.0, 12.0, 5.0);
        let before = UJointState { ur1: 0.0, ur3: 6.0, m1: 0.5, m3: -0.25 };
        let start = UJointStart { d0: Vector3::new(0.5, 0.25, 0.125), c0: 0.0, alpha0: 0.125, gamma0: -0.25 };
        let contact = UJointContact {
            k_stick1: 1e3,
            k_stick3: 1e3,
            rp: 1.0,
            la: 2.0,
            ra: 0.5,
            ls: 4.0,
            mc1_int: 1.0,
            mc3_int: -2.0,
            mu: 0.25,
        };
        let ways = [
            ("", None),
            ("-soft", Some(UJointContact { k_stick1: 0.125, k_stick3: 0.0625, ..contact })),
            ("-stiff", Some(UJointContact { k_stick3: 1e4, ..contact })),
            ("-stiff-about-one", Some(UJointContact { k_stick3: 0.0625, ..contact })),
            ("-without-axial", Some(UJointContact { ra: 0.0, ls: 0.0, ..contact })),
        ];
        let step = |nodes, contact| Step { nodes, multipliers, parameters: Parameters { start, contact }, before };
        let all = poses().into_iter().flat_map(|pose| {
            ways.map(|(how, contact)| Case::hard(format!("{}{how}", pose.id), pose.comment, step(pose.value, contact)))
        });
        all.collect()
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 4>, after: &UJointState<D>) -> Vec<Rubbed<D>> {
        let Parameters { start, contact } = step.parameters;
        let Some(UJointContact { k_stick1, k_stick3, rp, la, ra, ls, mc1_int, mc3_int, mu }) = contact else {
            return Vec::new();
        };
        let (Nodes { e1a, e2a, e3a, e3b, .. }, [f1, f2, f3, lambda_rot]) = (step.nodes, *step.multipliers.as_ref());
        let [ur1, ur3] = turned(&step.nodes, &start, &step.before);
        let UJointState { m1, m3, .. } = *after;
        let sine = e1a.dot(&e3b);
        let m2 = lambda_rot * ((D::one() - sine) * (D::one() + sine)).sqrt();
        let loads = FrictionLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, m1, m3, mc1_int, mc3_int, mu };
        let YieldPair { phi1, phi3 } = Friction::eval(&loads);
        vec![
            Rubbed { motion: ur1 - step.before.ur1, force: [step.before.m1, m1], k_stick: k_stick1, phi: phi1 },
            Rubbed { motion: ur3 - step.before.ur3, force: [step.before.m3, m3], k_stick: k_stick3, phi: phi3 },
        ]
    }
}
