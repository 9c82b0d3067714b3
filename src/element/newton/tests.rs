//! Each contribution is the derivative of its own forces and residuals, by automatic differentiation in 237 bits, in stick and in
//! slip.

use super::{
    Contribution, CrossContact, Element, Nodes, SlotContact, SlotElement, TranslatorContact, TranslatorElement,
    UJointElement, UJointState,
};
use crate::Octuple;
use crate::cardan::rotation;
use crate::element::Forces;
use crate::element::motion::{Motion, Moving, still};
use crate::ujoint::Cross;
use nalgebra::{Matrix3, SVector, Vector3};
use num_dual::{Dual, Dual2};

const SLOT: SlotElement = SlotElement { start: Vector3::new(0.125, 0.25, -0.5), contact: None };
const TRANSLATOR: TranslatorElement =
    TranslatorElement { start: Vector3::new(0.125, 0.25, -0.5), angles0: [0.4, 0.2, -0.6], contact: None };
const UJOINT: UJointElement =
    UJointElement { d0: Vector3::new(0.5, 0.25, 0.125), c0: 0.0, angles0: [0.1, -0.2], contact: None };

/// Two nodes apart, turned against each other and off the global axes.
fn nodes() -> Nodes<Octuple> {
    let exact = |m: Matrix3<f64>| [0, 1, 2].map(|k| m.column(k).map(Octuple::from));
    let a = rotation(0.3, -0.5, 0.7);
    let place = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(Octuple::from);
    Nodes { a: exact(a), b: exact(a * rotation(0.4, 0.2, -0.6)), xa: place(1.0, 2.0, 3.0), xb: place(2.5, 2.25, 4.0) }
}

/// The nodes as they move.
fn moving(nodes: &Nodes<Octuple>, motion: &Motion) -> Nodes<Moving> {
    let [xa, xb] = motion.places([nodes.xa, nodes.xb]);
    Nodes { a: nodes.a.map(|e| motion.of_a(e)), b: nodes.b.map(|e| motion.of_b(e)), xa, xb }
}

/// A state that does not move.
trait Still<S> {
    fn still(&self) -> S;
}

impl Still<Moving> for Octuple {
    fn still(&self) -> Moving {
        still(*self)
    }
}

impl Still<UJointState<Moving>> for UJointState<Octuple> {
    fn still(&self) -> UJointState<Moving> {
        UJointState { turns: self.turns.map(still), slip: self.slip.map(still) }
    }
}

/// The largest difference between a contribution's derivatives and those of its forces and residuals.
fn furthest<E: Element<N>, const N: usize>(element: &E, multipliers: SVector<f64, N>, before: E::State<Octuple>) -> f64
where
    E::State<Octuple>: Still<E::State<Moving>>,
{
    let (nodes, multipliers) = (nodes(), multipliers.map(Octuple::from));
    let (found, _) = element.contribution(&nodes, &multipliers, &before);
    let here = before.still();
    let mut furthest = 0.0_f64;
    let mut compare = |left: Octuple, right: Octuple| furthest = furthest.max((left - right).to_f64().abs());
    for (k, motion) in Motion::alone().iter().flatten().enumerate() {
        let (moved, _) = element.contribution(&moving(&nodes, motion), &multipliers.map(still), &here);
        moved.forces.iter().zip(&found.stiffness.column(k)).for_each(|(force, &entry)| compare(force.eps, entry));
        moved.residuals.iter().zip(&found.rows.column(k)).for_each(|(residual, &entry)| compare(residual.eps, entry));
    }
    for k in 0..N {
        let one = |j: usize| Octuple::from(if j == k { 1.0 } else { 0.0 });
        let loaded = SVector::from_fn(|j, _| Dual::new(multipliers[j], one(j)));
        let (moved, _) = element.contribution(&moving(&nodes, &Motion::none()), &loaded, &here);
        moved.forces.iter().zip(&found.by_multipliers.column(k)).for_each(|(f, &entry)| compare(f.eps, entry));
    }
    furthest
}

/// The nodes as they move with constant velocities, in the second order of time.
fn flying(nodes: &Nodes<Octuple>, velocities: &Forces<Octuple>) -> Nodes<Dual2<Octuple>> {
    let part = |k: usize| velocities.fixed_rows::<3>(k).into_owned();
    let place = |x: Vector3<Octuple>, v: Vector3<Octuple>| x.zip_map(&v, |x, v| Dual2::new(x, v, Octuple::from(0.0)));
    let axis = |e: Vector3<Octuple>, spin: Vector3<Octuple>| {
        let first = spin.cross(&e);
        e.zip_zip_map(&first, &spin.cross(&first), Dual2::new)
    };
    let (of_a, of_b) = (part(3), part(9));
    Nodes {
        a: nodes.a.map(|e| axis(e, of_a)),
        b: nodes.b.map(|e| axis(e, of_b)),
        xa: place(nodes.xa, part(0)),
        xb: place(nodes.xb, part(6)),
    }
}

/// The velocity term against the second time derivative of the residuals.
fn off_in_time<E: Element<N>, const N: usize>(
    element: &E,
    rest: E::State<Octuple>,
    moving: E::State<Dual2<Octuple>>,
) -> f64 {
    let velocities = Forces::from_fn(|k, _| {
        Octuple::from([1.0, -2.0, 0.5, 0.25, 3.0, -1.0][k % 6] * if k < 6 { 1.0 } else { -1.5 })
    });
    let term = element.velocity_term(&nodes(), &velocities, &rest);
    let (found, _) = element.smooth().contribution(&flying(&nodes(), &velocities), &SVector::zeros(), &moving);
    found.residuals.iter().zip(&term).map(|(residual, &term)| (residual.v2 - term).to_f64().abs()).fold(0.0, f64::max)
}

#[test]
fn the_velocity_term_is_what_residuals_do_without_acceleration() {
    let zero = Octuple::from(0.0);
    let flat = Dual2::from_re(zero);
    assert!(off_in_time(&SLOT, zero, flat) < 1e-60);
    assert!(off_in_time(&TRANSLATOR, zero, flat) < 1e-60);
    let rest = UJointState { turns: [zero; 2], slip: [zero; 2] };
    assert!(off_in_time(&UJOINT, rest, UJointState { turns: [flat; 2], slip: [flat; 2] }) < 1e-60);
}

#[test]
fn with_penalties_the_stiffness_is_the_derivative_of_the_forces() {
    let slot = SlotElement { contact: Some(SlotContact { k_el: 1e3, fc_int: 1.0, mu: 0.25 }), ..SLOT };
    let exact = |numbers: [f64; 2]| SVector::from(numbers.map(Octuple::from));
    let (multipliers, penalties, before) = (exact([3.0, -4.0]), exact([100.0, 300.0]), Octuple::from(0.5));
    let (found, _) = slot.penalised(&nodes(), &multipliers, &penalties, &before);
    for (k, motion) in Motion::alone().iter().flatten().enumerate() {
        let (multipliers, penalties) = (multipliers.map(still), penalties.map(still));
        let (moved, _) = slot.penalised(&moving(&nodes(), motion), &multipliers, &penalties, &still(before));
        for (force, &entry) in moved.forces.iter().zip(&found.stiffness.column(k)) {
            assert!((force.eps - entry).to_f64().abs() < 1e-55);
        }
    }
    let residuals = slot.contribution(&nodes(), &multipliers, &before).0.residuals;
    assert_eq!(found.multipliers, multipliers - penalties.component_mul(&residuals));
}

fn symmetric<const N: usize>(found: &Contribution<Octuple, N>) -> bool {
    found.by_multipliers == found.rows.transpose()
}

#[test]
fn slot_is_its_own_derivative() {
    let slot = SLOT;
    let rough = |k_el| SlotElement { contact: Some(SlotContact { k_el, fc_int: 1.0, mu: 0.25 }), ..slot };
    let (multipliers, before) = (SVector::from([3.0, -4.0]), Octuple::from(0.5));
    for element in [slot, rough(0.125), rough(1e3)] {
        assert!(furthest(&element, multipliers, before) < 1e-60, "{element:?}");
    }
    assert!(symmetric(&slot.contribution(&nodes(), &multipliers.map(Octuple::from), &before).0));
    assert!(!symmetric(&rough(1e3).contribution(&nodes(), &multipliers.map(Octuple::from), &before).0));
}

#[test]
fn translator_is_its_own_derivative() {
    let smooth = TRANSLATOR;
    let contact = |k_el| TranslatorContact { k_el, rr: 0.5, l: 2.0, fc_int: 1.0, mu: 0.25 };
    let rough = |k_el| TranslatorElement { contact: Some(contact(k_el)), ..smooth };
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]);
    for element in [smooth, rough(0.125), rough(1e3)] {
        assert!(furthest(&element, multipliers, Octuple::from(0.5)) < 1e-60, "{element:?}");
    }
}

#[test]
fn ujoint_is_its_own_derivative() {
    let smooth = UJOINT;
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
    let rough = |k_el1, k_el3| UJointElement { contact: Some(CrossContact { cross, k_el1, k_el3 }), ..smooth };
    let before = UJointState { turns: [0.0, 6.0], slip: [-1.0, 8.0] }.map();
    for element in [smooth, rough(0.125, 0.125), rough(1e3, 0.125), rough(1e3, 1e3)] {
        assert!(furthest(&element, SVector::from([3.0, -4.0, 12.0, 5.0]), before) < 1e-60, "{element:?}");
    }
}

impl UJointState<f64> {
    fn map(self) -> UJointState<Octuple> {
        UJointState { turns: self.turns.map(Octuple::from), slip: self.slip.map(Octuple::from) }
    }
}

#[test]
fn what_is_not_valid_is_refused() {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let nodes = Nodes { a: axes, b: axes, xa: Vector3::zeros(), xb: Vector3::x() };
    let slot = SlotElement { start: Vector3::zeros(), contact: Some(SlotContact { k_el: 0.0, fc_int: 0.0, mu: 0.25 }) };
    let refused =
        |found: Result<_, crate::Error>| found.map(|_: (Contribution<f64, 2>, f64)| ()).unwrap_err().to_string();
    assert_eq!(refused(slot.newton(&nodes, &SVector::zeros(), &0.0)), "k_el is 0.0; allowed is a finite number > 0");
    let smooth = SlotElement { contact: None, ..slot };
    let lost = Nodes { xb: Vector3::new(f64::NAN, 0.0, 0.0), ..nodes };
    assert_eq!(refused(smooth.newton(&lost, &SVector::zeros(), &0.0)), "xb[0] is NaN; allowed is a finite number");
}
