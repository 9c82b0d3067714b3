//! TRANSLATOR and ALIGN as a program uses them, and what they reject.

#![expect(clippy::float_cmp, reason = "exact results are expected exactly")]

use jointproof::connector::align::{self, Align, AlignFromStart};
use jointproof::connector::slot::Slot;
use jointproof::connector::translator;
use jointproof::connector::translator::{
    ContactForce, ContactLoads, Friction, FrictionLoads, Gradient, Loads, Pose, Translator,
};
use jointproof::element::cardan::{Angles, MOST_CONDITION, Triads, condition, rotation, turned};
use jointproof::element::frame::Triad;
use jointproof::formula::{Fields, check, value};
use jointproof::{Error, catalog, formula};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;
use std::f64::consts::PI;

fn triad(alpha: f64, beta: f64, gamma: f64) -> Triad {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let [e1, e2, e3] = turned(&axes, &rotation(alpha, beta, gamma));
    Triad::new(e1, e2, e3).unwrap()
}

fn pose() -> Pose {
    Pose {
        triad_a: triad(0.3, -0.4, 0.5),
        triad_b: triad(-1.0, 0.8, 2.0),
        xa: Vector3::new(1.0, 2.0, -3.0),
        xb: Vector3::new(2.5, 1.25, -2.0),
    }
}

#[test]
fn it_is_slot_and_align_assembled() {
    let (start, now) = (Pose { triad_b: triad(0.1, 0.2, 0.3), xb: Vector3::zeros(), ..pose() }, pose());
    let translator = Translator::new(&start).unwrap();
    let slot = Slot::new(&start.slot()).unwrap();
    let align = Align::new(&start.triad_a, &start.triad_b).unwrap();
    assert_eq!((translator.slot(), translator.align()), (&slot, &align));

    let (residuals, gradients) = translator.constraint_jacobian(&now).unwrap();
    assert_eq!(residuals, translator.constraint(&now).unwrap());
    let (of_slot, slot_rows) = slot.constraint_jacobian(&now.slot()).unwrap();
    assert_eq!((residuals.gy, residuals.gz), (of_slot.gy, of_slot.gz));
    assert_eq!(
        (gradients.gy.triads.e2a, gradients.gy.xa, gradients.gy.xb),
        (slot_rows.gy.e2a, slot_rows.gy.xa, slot_rows.gy.xb)
    );
    assert_eq!(
        (gradients.gz.triads.e3a, gradients.gz.xa, gradients.gz.xb),
        (slot_rows.gz.e3a, slot_rows.gz.xa, slot_rows.gz.xb)
    );
    let (of_align, align_rows) = align.constraint_jacobian(&now.triad_a, &now.triad_b).unwrap();
    assert_eq!((residuals.ur1, residuals.ur2, residuals.ur3), (of_align.ur1, of_align.ur2, of_align.ur3));
    for (gradient, row) in
        [(gradients.ur1, align_rows.ur1), (gradients.ur2, align_rows.ur2), (gradients.ur3, align_rows.ur3)]
    {
        assert_eq!(gradient, Gradient { triads: row, xa: Vector3::zeros(), xb: Vector3::zeros() });
    }
    assert_eq!(translator.relative_motion(&now).unwrap(), slot.relative_motion(&now.slot()).unwrap());
    assert_eq!(translator.relative_position(&now).unwrap(), slot.relative_position(&now.slot()).unwrap());
    assert_eq!(translator.gaps(&now).unwrap(), None);
}

/// The outputs of the catalog's formula with this identifier for these inputs.
fn by_formula(id: &str, inputs: &[f64]) -> Vec<f64> {
    catalog::find(id).unwrap().value(inputs).unwrap()
}

#[test]
fn the_connectors_say_what_the_formulas_say() {
    let (start, now) = (Pose { triad_b: triad(0.1, 0.2, 0.3), xb: Vector3::zeros(), ..pose() }, pose());
    let translator = Translator::new(&start).unwrap().with_levers(0.5, 2.0).unwrap().with_friction(0.25, -3.0).unwrap();
    let triads = jointproof::element::cardan::Triads::from((&now.triad_a, &now.triad_b)).components();
    let Angles { alpha, beta, gamma } = translator.align().initial();
    let initial = Slot::new(&start.slot()).unwrap().relative_position(&start.slot()).unwrap();
    let positions: Vec<_> = now.xa.iter().chain(now.xb.iter()).copied().collect();

    let found = translator.constraint(&now).unwrap().components();
    let documented = [&triads[..], &positions, &[initial.y, initial.z, alpha, beta, gamma]].concat();
    let documented = by_formula("translator.constraint", &documented);
    assert!(found.iter().zip(&documented).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?} {documented:?}");
    let aligned = by_formula("align.constraint", &[&triads[..], &[alpha, beta, gamma]].concat());
    assert_eq!(aligned, documented[2..]);

    let loads = Loads { f1: 1.0, f2: 3.0, f3: -4.0, m1: 0.5, m2: 7.0, m3: -2.0 };
    let Loads { f1, f2, f3, m1, m2, m3 } = loads;
    let moment = by_formula("align.constraint_moment", &[&triads[..9], &[m1, m2, m3]].concat());
    assert_eq!(translator.constraint_moment(&now.triad_a, &loads).unwrap().m.as_slice(), moment);
    let friction = translator.friction(&loads).unwrap();
    assert_eq!(
        by_formula("translator.friction", &[f1, f2, f3, m1, m2, m3, 0.5, 2.0, -3.0, 0.25]),
        friction.components()
    );
    let parts = by_formula("translator.torque_force", &[m1, 0.5])[1]
        + by_formula("translator.radial_force", &[f2, f3])[0]
        + by_formula("translator.bending_force", &[m2, m3, 2.0])[1];
    assert_eq!(by_formula("translator.contact_force", &[f2, f3, m1, m2, m3, 0.5, 2.0]), [parts]);
    assert_eq!(friction.r#fn, (parts - 3.0).abs());
}

#[test]
fn at_the_start_no_residual_is_left() {
    let start = pose();
    let residuals = Translator::new(&start).unwrap().constraint(&start).unwrap();
    assert_eq!(residuals.components(), [0.0; 5]);
}

#[test]
fn the_documented_forces_do_the_work_of_the_residuals() {
    // Aligned at the start and now, so that the moment is conjugate to the angles.
    let mut pose = pose();
    pose.triad_b = pose.triad_a;
    let translator = Translator::new(&pose).unwrap();
    let (_, rows) = translator.constraint_jacobian(&pose).unwrap();
    let loads = Loads { f1: 0.0, f2: 3.0, f3: -4.0, m1: 0.5, m2: 7.0, m3: -2.0 };
    let rows =
        [(rows.gy, loads.f2), (rows.gz, loads.f3), (rows.ur1, loads.m1), (rows.ur2, loads.m2), (rows.ur3, loads.m3)];
    let triads = jointproof::element::cardan::Triads::from((&pose.triad_a, &pose.triad_b));
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    for (row, multiplier) in rows {
        force += row.xb * multiplier;
        moment += triads.moments(&row.triads)[1] * multiplier;
    }
    assert!((force - translator.constraint_force(&pose.triad_a, &loads).unwrap().f).norm() < 1e-14);
    assert!((moment - translator.constraint_moment(&pose.triad_a, &loads).unwrap().m).norm() < 1e-14);
    assert!(force.dot(&pose.triad_a.e1()).abs() < 1e-14, "no work along the slot");
}

#[test]
fn a_joint_that_starts_at_half_a_turn_does_not_jump() {
    let a = Triad::global();
    let align = Align::new(&a, &triad(PI, 0.0, 0.0)).unwrap();
    for step in [1e-3, -1e-3] {
        let ur1 = align.constraint(&a, &triad(PI + step, 0.0, 0.0)).unwrap().ur1;
        assert!((ur1 - step).abs() < 1e-15, "{ur1}");
    }
    let align = Align::new(&a, &triad(0.0, 0.0, PI)).unwrap();
    for step in [1e-3, -1e-3] {
        let ur3 = align.constraint(&a, &triad(0.0, 0.0, PI + step)).unwrap().ur3;
        assert!((ur3 - step).abs() < 1e-15, "{ur3}");
    }
    // The documented residual is the plain difference, nearly a full turn on one side.
    let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let b = triad(PI - 1e-3, 0.0, 0.0);
    let plain = value::<align::Constraint>(&align::Orientations {
        e1a,
        e2a,
        e3a,
        e1b: b.e1(),
        e2b: b.e2(),
        e3b: b.e3(),
        alpha0: -PI,
        beta0: 0.0,
        gamma0: 0.0,
    });
    assert!((plain.unwrap().ur1 - (2.0 * PI - 1e-3)).abs() < 1e-15);
}

#[test]
fn gimbal_lock_is_rejected_at_the_start_and_later() {
    let global = Triad::global();
    let upright = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x()).unwrap();
    assert!(matches!(Align::new(&global, &upright).unwrap_err(), Error::GimbalLock { .. }));
    let since = AlignFromStart::new(&global, &global);
    assert!(matches!(since.constraint(&global, &upright).unwrap_err(), Error::GimbalLock { .. }));
    assert!(matches!(since.constraint_jacobian(&global, &upright).unwrap_err(), Error::GimbalLock { .. }));
    let start = Pose { triad_a: global, triad_b: global, xa: Vector3::zeros(), xb: Vector3::zeros() };
    let translator = Translator::new(&start).unwrap();
    let locked = Pose { triad_b: upright, ..start };
    assert!(matches!(translator.constraint(&locked).unwrap_err(), Error::GimbalLock { .. }));
    assert!(matches!(translator.constraint_jacobian(&locked).unwrap_err(), Error::GimbalLock { .. }));
}

#[test]
fn bad_parameters_are_named() {
    let translator = Translator::new(&pose()).unwrap();
    let message = |result: Result<Translator, Error>| result.unwrap_err().to_string();
    assert_eq!(message(translator.with_levers(-1.0, 1.0)), "rr is -1.0; allowed is a finite number ≥ 0");
    assert_eq!(message(translator.with_levers(1.0, -1.0)), "l is -1.0; allowed is a finite number ≥ 0");
    assert_eq!(message(translator.with_levers(1.0, f64::INFINITY)), "l is inf; allowed is a finite number ≥ 0");
    assert_eq!(message(translator.with_friction(-0.1, 0.0)), "mu is -0.1; allowed is a finite number ≥ 0");
    assert_eq!(message(translator.with_friction(0.1, f64::NAN)), "fc_int is NaN; allowed is a finite number");
    assert_eq!(message(translator.with_reference_length(f64::NAN)), "l1_ref is NaN; allowed is a finite number");
    assert_eq!(
        message(translator.with_stops(2.0, 1.0)),
        "l1_min = 2.0 is above l1_max = 1.0; allowed is l1_min ≤ l1_max"
    );
    let loads = Loads { m2: f64::NAN, ..Loads::default() };
    assert_eq!(translator.friction(&loads).unwrap_err().to_string(), "m2 is NaN; allowed is a finite number");
    let far = Pose { xb: Vector3::new(f64::NAN, 0.0, 0.0), ..pose() };
    assert_eq!(translator.constraint(&far).unwrap_err().to_string(), "xb[0] is NaN; allowed is a finite number");
}

#[test]
fn a_lever_of_zero_drops_its_moment_and_a_short_one_does_not() {
    let loads = ContactLoads { f2: 3.0, f3: 4.0, m1: -6.0, m2: 5.0, m3: -12.0, rr: 0.0, l: 0.0 };
    assert_eq!(value::<ContactForce>(&loads).unwrap().fc, 5.0);
    let jac = <ContactForce as formula::Formula>::jacobian(&loads).fc;
    assert_eq!((jac.m1, jac.m2, jac.m3, jac.rr, jac.l), (0.0, 0.0, 0.0, 0.0, 0.0));
    assert_eq!(value::<ContactForce>(&ContactLoads { rr: 0.5, ..loads }).unwrap().fc, 17.0);
    assert_eq!(value::<ContactForce>(&ContactLoads { l: 2.0, ..loads }).unwrap().fc, 18.0);
    assert!(matches!(
        value::<ContactForce>(&ContactLoads { rr: 1e-310, m1: 1e10, ..loads }),
        Err(Error::Overflow { name: "fc" })
    ));
}

#[test]
fn without_friction_parameters_there_is_no_friction() {
    let translator = Translator::new(&pose()).unwrap();
    let loads = Loads { f1: -2.0, f2: 3.0, f3: 4.0, m1: 1.0, m2: 2.0, m3: 3.0 };
    let (friction, jac) = translator.friction_jacobian(&loads).unwrap();
    assert_eq!((friction.p, friction.r#fn, friction.phi), (2.0, 5.0, 2.0));
    assert_eq!((jac.phi.f1, jac.phi.mu), (-1.0, -5.0));
}

/// Any load: nothing, tiny, huge, of either sign.
fn load() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -10.0..10.0, -1e-150..1e-150, -1e150..1e150, Just(1e-310)]
}

fn lever() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 1e-3..1e3, Just(1e-12), Just(1e12)]
}

proptest! {
    #[test]
    fn friction_and_its_derivatives_are_numbers_for_any_load(
        loads in proptest::array::uniform6(load()),
        levers in proptest::array::uniform2(lever()),
        fc_int in load(),
        mu in 0.0..2.0,
    ) {
        let ([f1, f2, f3, m1, m2, m3], [rr, l]) = (loads, levers);
        let inputs = FrictionLoads { f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu };
        prop_assert!(check::<Friction>(&inputs).is_ok());
        let (out, jac) = formula::value_and_jacobian::<Friction>(&inputs).unwrap();
        prop_assert!(out.p >= 0.0 && out.r#fn >= 0.0 && out.phi.is_finite());
        let entries = jac.components().into_iter().flat_map(|row| row.components());
        prop_assert!(entries.into_iter().all(f64::is_finite), "{jac:?}");
    }

    #[test]
    fn each_part_adds_to_the_contact_force(
        loads in proptest::array::uniform5(-10.0..10.0),
        rr in 1e-3..1e3,
        l in 1e-3..1e3,
    ) {
        let [f2, f3, m1, m2, m3] = loads;
        let whole = value::<ContactForce>(&ContactLoads { f2, f3, m1, m2, m3, rr, l }).unwrap().fc;
        let torque = value::<translator::TorqueForce>(&translator::Torque { m1, rr }).unwrap().f_torq;
        let bending = value::<translator::BendingForce>(&translator::Bending { m2, m3, l }).unwrap().f_bend;
        let slot = value::<ContactForce>(&ContactLoads { f2, f3, m1, m2, m3, rr: 0.0, l: 0.0 }).unwrap().fc;
        prop_assert_eq!(whole, torque + slot + bending);
    }
}

#[test]
fn a_start_near_a_right_angle_is_refused_with_its_condition_number() {
    let a = triad(0.3, -0.4, 0.5);
    let [e1, e2, e3] = [a.e1(), a.e2(), a.e3()];
    let b = |degrees: f64| {
        let [e1, e2, e3] = turned(&[e1, e2, e3], &rotation(0.7, degrees.to_radians(), -0.2));
        Triad::new(e1, e2, e3).unwrap()
    };
    for degrees in [0.0, 60.0, -85.0, 89.88] {
        assert!(
            condition(f64::to_radians(degrees)) < MOST_CONDITION && Align::new(&a, &b(degrees)).is_ok(),
            "{degrees}"
        );
    }
    for degrees in [89.89, -89.9, 90.0] {
        let error = Align::new(&a, &b(degrees)).unwrap_err();
        assert!(matches!(error, Error::IllConditioned { condition, .. } if condition > MOST_CONDITION), "{error}");
        let initial = Pose { triad_a: a, triad_b: b(degrees), ..pose() };
        assert_eq!(Translator::new(&initial).unwrap_err(), error);
    }
    let said = Align::new(&a, &b(89.9)).unwrap_err().to_string();
    assert!(said.contains("(89.900°), where the angles have the condition number 1.146e3; allowed is"), "{said}");
}

/// At the start, the derivative with respect to a spin of b is the triad of a, for every orientation of b.
#[test]
fn angles_from_the_start_are_regular_everywhere() {
    let a = triad(0.3, -0.4, 0.5);
    for beta in [0.0, 1.0, std::f64::consts::FRAC_PI_2, -1.5706, 3.0] {
        let axes = [a.e1(), a.e2(), a.e3()];
        let at = |turn: [Vector3<f64>; 3]| {
            let [e1, e2, e3] = turned(&turn, &rotation(0.7, beta, -0.2));
            Triad::new(e1, e2, e3).unwrap()
        };
        let b = at(axes);
        let align = AlignFromStart::new(&a, &b);
        let (residuals, rows) = align.constraint_jacobian(&a, &b).unwrap();
        for (row, axis) in [rows.ur1, rows.ur2, rows.ur3].into_iter().zip(axes) {
            let spin = b.e1().cross(&row.e1b) + b.e2().cross(&row.e2b) + b.e3().cross(&row.e3b);
            assert!((spin - axis).norm() < 1e-15, "{beta}: {spin} is not {axis}");
        }
        assert!([residuals.ur1, residuals.ur2, residuals.ur3].iter().all(|u| u.abs() < 1e-15));
        // After three rotations about the axes of a since the start, it returns these angles.
        let moved = at(turned(&axes, &rotation(0.1, -0.2, 0.3)));
        let found = align.constraint(&a, &moved).unwrap();
        for (found, expected) in [(found.ur1, 0.1), (found.ur2, -0.2), (found.ur3, 0.3)] {
            assert!((found - expected).abs() < 1e-15, "{beta}: {found} is not {expected}");
        }
        // There the derivative is that of differences, with respect to spins of either node.
        let rows = align.constraint_jacobian(&a, &moved).unwrap().1;
        let by_spins = [rows.ur1, rows.ur2, rows.ur3].map(|row| Triads::from((&a, &moved)).moments(&row));
        let read = |a: &Triad, b: &Triad| {
            let found = align.constraint(a, b).unwrap();
            Vector3::new(found.ur1, found.ur2, found.ur3)
        };
        for axis in 0..3 {
            let spun = |t: &Triad, angle: f64| {
                let turn = Rotation3::new(Vector3::ith(axis, angle));
                Triad::new(turn * t.e1(), turn * t.e2(), turn * t.e3()).unwrap()
            };
            let step = 1e-5;
            let by_a = read(&spun(&a, step), &moved) - read(&spun(&a, -step), &moved);
            let by_b = read(&a, &spun(&moved, step)) - read(&a, &spun(&moved, -step));
            for (row, spins) in by_spins.iter().enumerate() {
                for (spin, difference) in spins.iter().zip([by_a, by_b]) {
                    assert!((spin[axis] - difference[row] / (2.0 * step)).abs() < 1e-9, "{beta}: {row} by {axis}");
                }
            }
        }
    }
}
