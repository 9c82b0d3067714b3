//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Bending, BendingForce, RadialForce, Torque, TorqueForce};
use crate::Octuple;
use crate::connector::slot::{self, CrossForces};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};

impl Proved for TorqueForce {
    fn cases() -> Vec<Case<Torque<f64>>> {
        let hand = Torque { m1: -6.0, rr: 0.5 };
        vec![
            Case::running("|-6| / 0.5 = 12", hand),
            Case::limit("no-radius", "R_r = 0: the torque is ignored", Torque { rr: 0.0, ..hand }),
            Case::hard("no-torque", "m1 = 0: derivative 0 by convention", Torque { m1: 0.0, ..hand }),
            Case::hard("nothing", "neither torque nor radius", Torque { m1: 0.0, rr: 0.0 }),
            Case::hard("thirds", "a quotient that is not a double", Torque { m1: 1.0, rr: 3.0 }),
            Case::hard("tiny", "1e-200 on a radius of 1e-12", Torque { m1: 1e-200, rr: 1e-12 }),
            Case::hard("huge", "1e200 on a radius of 1e-12", Torque { m1: -1e200, rr: 1e-12 }),
            Case::hard("wide", "a radius of 1e12", Torque { m1: 7.0, rr: 1e12 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(Torque { m1: -6.0, rr: 0.0 }, |i| [i.rr]),
            Kink::<Self>::of_abs(Torque { m1: 0.0, rr: 0.5 }, |i| [i.m1]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing the torque does not change it", |i| {
                law::equal(Self::eval(i).f_torq, Self::eval(&Torque { m1: -i.m1, ..*i }).f_torq)
            }),
            Law::<Self>::new("the contact force at its lever is the torque: F_torq R_r = M_torq", |i| {
                law::equal(Self::eval(i).f_torq * i.rr, Self::eval(i).m_torq)
            }),
        ]
    }
}

impl Proved for RadialForce {
    fn cases() -> Vec<Case<CrossForces<f64>>> {
        slot::ContactForce::cases()
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_norm(CrossForces { f2: 0.0, f3: 0.0 }, |i| [i.f2, i.f3])]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the contact force of a SLOT", |i| {
                law::equal(Self::eval(i).fr, slot::ContactForce::eval(i).fc)
            }),
            Law::<Self>::new("turning the force about the slot does not change it", |i| {
                let [c, s] = [3.0, 4.0].map(Octuple::from);
                let turned = CrossForces { f2: i.f2 * c - i.f3 * s, f3: i.f2 * s + i.f3 * c };
                law::equal(Self::eval(i).fr * 5.0, Self::eval(&turned).fr)
            }),
        ]
    }
}

impl Proved for BendingForce {
    fn cases() -> Vec<Case<Bending<f64>>> {
        let hand = Bending { m2: 5.0, m3: -12.0, l: 2.0 };
        let mut cases = vec![
            Case::running("2 × 13 / 2 = 13", hand),
            Case::limit("no-length", "L = 0: bending is ignored", Bending { l: 0.0, ..hand }),
            Case::hard("nothing", "neither moment nor length", Bending { m2: 0.0, m3: 0.0, l: 0.0 }),
            Case::hard("short", "a length of 1e-12", Bending { l: 1e-12, ..hand }),
            Case::hard("long", "a length of 1e12", Bending { l: 1e12, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2, m3] = load.value;
            Case::hard(load.id, load.comment, Bending { m2, m3, l: 0.375 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(Bending { m2: 5.0, m3: -12.0, l: 0.0 }, |i| [i.l]),
            Kink::<Self>::of_norm(Bending { m2: 0.0, m3: 0.0, l: 2.0 }, |i| [i.m2, i.m3]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("turning the moment about the slot does not change it", |i| {
                let [c, s] = [3.0, 4.0].map(Octuple::from);
                let turned = Bending { m2: i.m2 * c - i.m3 * s, m3: i.m2 * s + i.m3 * c, ..*i };
                law::equal(Self::eval(i).f_bend * 5.0, Self::eval(&turned).f_bend)
            }),
            Law::<Self>::new("two opposite forces of F_bend/2 at the distance L carry the moment", |i| {
                law::equal(Self::eval(i).f_bend * i.l * 0.5, Self::eval(i).m_bend)
            }),
        ]
    }
}
