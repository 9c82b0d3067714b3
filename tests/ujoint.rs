//! UJOINT as a program uses it, what it rejects, and its derivatives at ordinary and at extreme positions.

use crate::common;
use jointproof::connector::join::Join;
use jointproof::connector::ujoint::{
    ContactMoments, Cross, Friction, FrictionLoads, Gradient, JointLoads, JointResiduals, Loads, Pose, Stops, UJoint,
};
use jointproof::connector::universal::Universal;
use jointproof::element::cardan::{Triads, rotation, turned};
use jointproof::element::frame::Triad;
use jointproof::formula::proof::value_and_jacobian_by_ad;
use jointproof::formula::{Fields, Formula, Jacobian, value};
use jointproof::toolkit::verify::exactly;
use jointproof::{Error, Octuple, Scalar, catalog};
use nalgebra::Vector3;
use proptest::prelude::*;

fn triad(alpha: f64, beta: f64, gamma: f64) -> Triad {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let [e1, e2, e3] = turned(&axes, &rotation(alpha, beta, gamma));
    Triad::new(e1, e2, e3).unwrap()
}

/// Node b displaced from its initial position, and the cross not at a right angle.
fn pose() -> Pose {
    Pose {
        triad_a: triad(0.3, -0.4, 0.5),
        triad_b: triad(-1.0, 0.8, 2.0),
        xa: Vector3::new(1.0, 2.0, -3.0),
        xb: Vector3::new(2.5, 1.25, -2.0),
    }
}

const LOADS: Loads = Loads { f1: 3.0, f2: -4.0, f3: 12.0, m1: 0.5, m2: 7.0, m3: -2.0 };
const CROSS: Cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
const STOPS: Stops = Stops { theta1_min: -2.0, theta1_max: 3.0, theta3_min: -3.0, theta3_max: 2.5 };

#[test]
fn it_is_join_and_universal_assembled() {
    let (start, now) = (Pose { triad_b: triad(0.1, 0.2, 0.3), xb: Vector3::zeros(), ..pose() }, pose());
    let joint = UJoint::new(&start).unwrap();
    let join = Join::new(&start.slot()).unwrap();
    let universal = Universal::new(&start.triad_a, &start.triad_b).unwrap();
    assert_eq!((joint.join(), joint.universal()), (&join, &universal));

    let (residuals, gradients) = joint.constraint_jacobian(&now).unwrap();
    assert_eq!(residuals, joint.constraint(&now).unwrap());
    let (of_join, join_rows) = join.constraint_jacobian(&now.slot()).unwrap();
    let (of_universal, universal_row) = universal.constraint_jacobian(&now.triad_a, &now.triad_b).unwrap();
    assert_eq!(residuals, JointResiduals { g: of_join.g, g_rot: of_universal.g });
    let none = Triads::filled(0.0);
    for (gradient, row) in gradients.g.iter().zip(join_rows.g.iter()) {
        let triads = Triads { e1a: row.e1a, e2a: row.e2a, e3a: row.e3a, ..none };
        assert_eq!(*gradient, Gradient { triads, xa: row.xa, xb: row.xb });
    }
    let triads = Triads { e1a: universal_row.g.e1a, e3b: universal_row.g.e3b, ..none };
    assert_eq!(gradients.g_rot, Gradient { triads, xa: Vector3::zeros(), xb: Vector3::zeros() });
    let of_universal = universal.relative_motion(&now.triad_a, &now.triad_b).unwrap();
    assert_eq!(joint.relative_motion(&now).unwrap(), of_universal);
}

fn components(vectors: &[Vector3<f64>]) -> Vec<f64> {
    vectors.iter().flat_map(|v| v.iter().copied()).collect()
}

/// The outputs of the catalog's formula with this identifier for these inputs.
fn by_formula(id: &str, inputs: &[&[f64]]) -> Vec<f64> {
    catalog::find(id).unwrap().value(&inputs.concat()).unwrap()
}

#[test]
fn the_connector_says_what_the_formulas_say() {
    let (start, now) = (Pose { triad_b: triad(0.1, 0.2, 0.3), ..pose() }, pose());
    let joint = UJoint::new(&start).unwrap().with_stops(&STOPS).unwrap().with_friction(&CROSS).unwrap();
    let (a, b) = (now.triad_a, now.triad_b);
    let vectors = components(&[a.e1(), a.e2(), a.e3(), b.e3()]);
    let [e1a, e2a, e3a, e3b] = [&vectors[..3], &vectors[3..6], &vectors[6..9], &vectors[9..]];
    let d0 = joint.join().initial_position();
    let Loads { f1, f2, f3, m1, m2, m3 } = LOADS;

    let positions = components(&[now.xa, now.xb, d0]);
    let documented = by_formula("ujoint.constraint", &[&vectors, &positions, &[joint.universal().initial_cosine()]]);
    assert_eq!(joint.constraint(&now).unwrap().components(), documented);
    assert_eq!(joint.reaction(&LOADS).unwrap().components(), by_formula("ujoint.reaction", &[&[f1, f2, f3]]));
    let moment = by_formula("universal.constraint_moment", &[e2a, e3a, e3b, &[m2]]);
    assert_eq!(joint.constraint_moment(&now, &LOADS).unwrap().m.as_slice(), moment);
    let moment = by_formula("universal.kinetic_moment", &[e1a, e3b, &[m1, m3]]);
    assert_eq!(joint.kinetic_moment(&now, &LOADS).unwrap().m.as_slice(), moment);
    let force = joint.constraint_force(&a, &LOADS).unwrap().f;
    assert!((force - (a.e1() * f1 + a.e2() * f2 + a.e3() * f3)).norm() < 1e-14);

    let turns = by_formula("universal.angles", &[&Triads::from((&a, &b)).components()]);
    let gaps = by_formula("ujoint.stop", &[&turns, &[-2.0, 3.0, -3.0, 2.5]]);
    assert_eq!(joint.gaps(&now).unwrap().unwrap().components(), gaps);

    let loads = [f1, f2, f3, m2, CROSS.rp, CROSS.la, CROSS.ra, CROSS.ls];
    let contact = by_formula("ujoint.contact_moments", &[&vectors, &loads]);
    assert_eq!(joint.contact_moments(&now, &LOADS).unwrap().unwrap().components(), contact);
    let normal = by_formula("ujoint.normal_moments", &[&contact, &[CROSS.mc1_int, CROSS.mc3_int]]);
    let (friction, jac) = joint.friction_jacobian(&now, &LOADS).unwrap().unwrap();
    assert_eq!(Some(friction), joint.friction(&now, &LOADS).unwrap());
    assert_eq!(friction.components(), [m1.abs() - CROSS.mu * normal[0], m3.abs() - CROSS.mu * normal[1]]);
    assert_eq!((jac.phi1.m1, jac.phi3.m3, jac.phi1.mu), (1.0, -1.0, -normal[0]));
}

#[test]
fn at_the_start_no_residual_is_left() {
    let residuals = UJoint::new(&pose()).unwrap().constraint(&pose()).unwrap();
    assert_eq!(residuals.components(), [0.0; 4]);
}

#[test]
fn without_stops_and_cross_there_are_no_gaps_and_no_friction() {
    let joint = UJoint::new(&pose()).unwrap();
    assert_eq!(joint.gaps(&pose()).unwrap(), None);
    assert_eq!(joint.contact_moments(&pose(), &LOADS).unwrap(), None);
    assert_eq!(joint.friction(&pose(), &LOADS).unwrap(), None);
    assert_eq!(joint.friction_jacobian(&pose(), &LOADS).unwrap(), None);
}

/// A virtual motion of both nodes: a translation and a spin of each.
struct Motion {
    dxa: Vector3<f64>,
    dxb: Vector3<f64>,
    spin_a: Vector3<f64>,
    spin_b: Vector3<f64>,
}

impl Motion {
    /// The change of a residual: every vector of a node rotates with it, δe = δθ × e.
    fn of(&self, pose: &Pose, row: &Gradient) -> f64 {
        let [on_a, on_b] = Triads::from((&pose.triad_a, &pose.triad_b)).moments(&row.triads);
        row.xa.dot(&self.dxa) + row.xb.dot(&self.dxb) + on_a.dot(&self.spin_a) + on_b.dot(&self.spin_b)
    }
}

/// Twelve virtual motions that span all motions.
fn motions() -> impl Iterator<Item = Motion> {
    (0..12).map(|k| {
        let v = |first: usize| Vector3::from_fn(|row, _| if first + row == k { 1.0 } else { 0.0 });
        Motion { dxa: v(0), dxb: v(3), spin_a: v(6), spin_b: v(9) }
    })
}

#[test]
fn the_multipliers_do_the_work_of_the_documented_force_and_moment() {
    let perpendicular = Pose { triad_b: pose().triad_a, ..pose() };
    let skewed = pose();
    for now in [perpendicular, skewed] {
        let joint = UJoint::new(&now).unwrap();
        let (_, rows) = joint.constraint_jacobian(&now).unwrap();
        let force = joint.constraint_force(&now.triad_a, &LOADS).unwrap().f;
        // The multiplier m2 is conjugate to sin β, the moment m2 to β.
        let cos_beta = now.triad_a.e1().cross(&now.triad_b.e3()).norm();
        let moment = joint.constraint_moment(&now, &LOADS).unwrap().m * cos_beta;
        let arm = now.xb - now.xa;
        for motion in motions() {
            let Loads { f1, f2, f3, m2, .. } = LOADS;
            let rows = [(rows.g.x, f1), (rows.g.y, f2), (rows.g.z, f3), (rows.g_rot, m2)];
            let of_multipliers: f64 = rows.iter().map(|(row, multiplier)| motion.of(&now, row) * multiplier).sum();
            let of_loads = force.dot(&(motion.dxb - motion.dxa)) - arm.cross(&force).dot(&motion.spin_a)
                + moment.dot(&(motion.spin_b - motion.spin_a));
            assert!((of_multipliers - of_loads).abs() < 1e-13, "{of_multipliers} {of_loads}");
        }
    }
    assert!((skewed.triad_a.e1().dot(&skewed.triad_b.e3())).abs() > 0.1, "the other position must be skewed");
}

#[test]
fn the_constraint_does_no_work_in_the_free_directions() {
    let now = pose();
    let joint = UJoint::new(&now).unwrap();
    let moment = joint.constraint_moment(&now, &LOADS).unwrap().m;
    for free in [now.triad_a.e1(), now.triad_b.e3()] {
        assert!(moment.dot(&free).abs() < 1e-14);
        let (_, rows) = joint.constraint_jacobian(&now).unwrap();
        let turn = Motion { dxa: Vector3::zeros(), dxb: Vector3::zeros(), spin_a: Vector3::zeros(), spin_b: free };
        for row in [rows.g.x, rows.g.y, rows.g.z, rows.g_rot] {
            assert!(turn.of(&now, &row).abs() < 1e-15, "b may turn about it");
        }
    }
}

#[test]
fn bad_parameters_are_named() {
    let joint = UJoint::new(&pose()).unwrap();
    let of_cross = |cross: Cross| joint.with_friction(&cross).unwrap_err().to_string();
    assert_eq!(of_cross(Cross { rp: 0.0, ..CROSS }), "rp is 0.0; allowed is a finite number > 0");
    assert_eq!(of_cross(Cross { rp: -1.0, ..CROSS }), "rp is -1.0; allowed is a finite number > 0");
    assert_eq!(of_cross(Cross { la: 0.0, ..CROSS }), "la is 0.0; allowed is a finite number > 0");
    assert_eq!(of_cross(Cross { la: -2.0, ..CROSS }), "la is -2.0; allowed is a finite number > 0");
    assert_eq!(of_cross(Cross { ra: -0.5, ..CROSS }), "ra is -0.5; allowed is a finite number ≥ 0");
    assert_eq!(of_cross(Cross { ls: -4.0, ..CROSS }), "ls is -4.0; allowed is a finite number ≥ 0");
    assert_eq!(of_cross(Cross { mu: -0.1, ..CROSS }), "mu is -0.1; allowed is a finite number ≥ 0");
    assert_eq!(of_cross(Cross { mc1_int: f64::NAN, ..CROSS }), "mc1_int is NaN; allowed is a finite number");
    assert_eq!(of_cross(Cross { mc3_int: f64::INFINITY, ..CROSS }), "mc3_int is inf; allowed is a finite number");
    let of_stops = |stops: Stops| joint.with_stops(&stops).unwrap_err().to_string();
    assert_eq!(of_stops(Stops { theta1_min: f64::NAN, ..STOPS }), "theta1_min is NaN; allowed is a finite number");
    assert_eq!(
        of_stops(Stops { theta3_min: 3.0, ..STOPS }),
        "theta3_min = 3.0 is above theta3_max = 2.5; allowed is theta3_min ≤ theta3_max"
    );
    let angles = joint.with_reference_angles(0.0, f64::NAN).unwrap_err().to_string();
    assert_eq!(angles, "theta3_ref is NaN; allowed is a finite number");
    let loads = Loads { f2: f64::NAN, ..LOADS };
    let joint = joint.with_friction(&CROSS).unwrap();
    assert_eq!(joint.friction(&pose(), &loads).unwrap_err().to_string(), "f2 is NaN; allowed is a finite number");
    let far = Pose { xb: Vector3::new(f64::NAN, 0.0, 0.0), ..pose() };
    assert_eq!(joint.constraint(&far).unwrap_err().to_string(), "xb[0] is NaN; allowed is a finite number");
}

#[test]
fn gimbal_lock_is_rejected_at_the_start_and_later() {
    let global = Triad::global();
    let in_line = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x()).unwrap();
    let start = Pose { triad_a: global, triad_b: global, xa: Vector3::zeros(), xb: Vector3::zeros() };
    let locked = Pose { triad_b: in_line, ..start };
    assert!(matches!(UJoint::new(&locked), Err(Error::GimbalLock { .. })));
    let joint = UJoint::new(&start).unwrap().with_stops(&STOPS).unwrap();
    assert!(matches!(joint.relative_motion(&locked), Err(Error::GimbalLock { .. })));
    assert!(matches!(joint.gaps(&locked), Err(Error::GimbalLock { .. })));
    assert_eq!(joint.constraint(&locked).unwrap().g_rot, 1.0, "the residual itself is defined");
}

/// At every quarter turn, on and off the axes, with no load, each load alone and all together: of ordinary and of extreme size.
fn positions_and_loads() -> Vec<JointLoads<f64>> {
    let mut all = Vec::new();
    for [e1a, e2a, e3a] in [Triad::global(), triad(0.3, -0.4, 0.5)].map(|t| [t.e1(), t.e2(), t.e3()]) {
        // α = 0, ±90°, ±180° and in between.
        for e3b in [e3a, -e2a, e2a, -e3a, e3a * 0.8 - e2a * 0.6] {
            for size in [1e-150, 1.0, 1e150] {
                let alone = |k: usize| std::array::from_fn(|load| if load == k { size } else { 0.0 });
                for [f1, f2, f3, m2] in [[0.0; 4], alone(0), alone(1), alone(2), alone(3), [size, -size, size, -size]] {
                    for [ra, ls] in [[0.5, 4.0], [0.0, 4.0], [0.5, 0.0], [0.0, 0.0]] {
                        all.push(JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp: 1.0, la: 2.0, ra, ls });
                    }
                }
            }
        }
    }
    all
}

/// Whether the closed form and automatic differentiation, in f64 and in 237 bits, give numbers.
fn derivatives_are_numbers<F: Formula>(i: &F::Inputs<f64>) -> bool {
    fn are_numbers<F: Formula, D: Scalar>(jacobian: &Jacobian<F, D>) -> bool {
        jacobian.components().iter().flat_map(Fields::components).all(|slope| slope.re().is_finite())
    }
    let exact = exactly::<F>(i);
    are_numbers::<F, f64>(&F::jacobian(i))
        && are_numbers::<F, f64>(&value_and_jacobian_by_ad::<F, f64>(i).1)
        && are_numbers::<F, Octuple>(&F::jacobian(&exact))
        && are_numbers::<F, Octuple>(&value_and_jacobian_by_ad::<F, Octuple>(&exact).1)
}

#[test]
fn no_derivative_is_nan_at_quarter_turns_without_load_or_with_one_load_alone() {
    for i in positions_and_loads() {
        assert!(derivatives_are_numbers::<ContactMoments>(&i), "{i:?}");
        let JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls } = i;
        let (m1, m3, mc1_int, mc3_int, mu) = (f1, m2, 0.0, f3, 0.25);
        let friction =
            FrictionLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, m1, m3, mc1_int, mc3_int, mu };
        assert!(derivatives_are_numbers::<Friction>(&friction), "{friction:?}");
    }
}

#[test]
fn a_parameter_of_zero_drops_its_term_and_a_small_one_does_not() {
    let loads = [3.0, -4.0, 12.0, 7.0];
    let moments = |ra: f64, ls: f64| {
        let [f1, f2, f3, m2] = loads;
        let (e1a, e2a, e3a) = (Vector3::x(), Vector3::y(), Vector3::z());
        let i = JointLoads { e1a, e2a, e3a, e3b: e3a, f1, f2, f3, m2, rp: 1.0, la: 2.0, ra, ls };
        (value::<ContactMoments>(&i).unwrap(), ContactMoments::jacobian(&i))
    };
    let (neither, by) = moments(0.0, 0.0);
    assert_eq!((by.mc1.ls, by.mc3.ls), (0.0, 0.0));
    assert_eq!(moments(1e-300, 0.0).0, neither);
    // The moments are linear in Ra, without a kink at Ra = 0, where the axial forces have no lever.
    let (lever, there) = (0.5, moments(0.5, 0.0).0);
    assert_eq!((neither.mc1 + by.mc1.ra * lever, neither.mc3 + by.mc3.ra * lever), (there.mc1, there.mc3));
    assert!(by.mc1.ra > 0.0 && by.mc3.ra > 0.0);
    assert!(moments(0.0, 1e-3).0.mc1 > 1e3);
}

/// Whatever a program passes, the connector returns numbers or an error.
fn does_not_panic(
    x: [f64; 6],
    loads: [f64; 6],
    cross: [f64; 7],
    stops: [f64; 4],
    [alpha, gamma]: [f64; 2],
) -> Result<(), TestCaseError> {
    let [xa, xb] = [Vector3::new(x[0], x[1], x[2]), Vector3::new(x[3], x[4], x[5])];
    let now = Pose { triad_b: triad(alpha, 0.1, gamma), xa, xb, ..pose() };
    let [f1, f2, f3, m1, m2, m3] = loads;
    let loads = Loads { f1, f2, f3, m1, m2, m3 };
    let [rp, la, ra, ls, mu, mc1_int, mc3_int] = cross;
    let [theta1_min, theta1_max, theta3_min, theta3_max] = stops;
    let joint = UJoint::new(&pose()).unwrap();
    if let Ok(residuals) = joint.constraint(&now) {
        prop_assert!(residuals.components().iter().all(|x| x.is_finite()));
    }
    if let Ok(force) = joint.constraint_force(&now.triad_a, &loads) {
        prop_assert!(force.f.iter().all(|f| f.is_finite()));
    }
    if let Ok(joint) = joint.with_stops(&Stops { theta1_min, theta1_max, theta3_min, theta3_max })
        && let Ok(gaps) = joint.gaps(&now)
    {
        for (gap, stop) in gaps.unwrap().components().into_iter().zip(stops) {
            let as_its_stop = if stop.is_finite() { gap.is_finite() } else { gap == f64::INFINITY };
            prop_assert!(as_its_stop, "{} before {}", gap, stop);
        }
    }
    let _ = (UJoint::new(&now), joint.constraint_jacobian(&now), joint.relative_motion(&now));
    let _ = (joint.constraint_moment(&now, &loads), joint.kinetic_moment(&now, &loads), joint.reaction(&loads));
    if let Ok(joint) = joint.with_friction(&Cross { rp, la, ra, ls, mu, mc1_int, mc3_int })
        && let Ok(Some((phi, jac))) = joint.friction_jacobian(&now, &loads)
    {
        prop_assert!(phi.components().iter().all(|phi| phi.is_finite()));
        prop_assert!(jac.components().iter().all(|row| row.components().iter().all(|slope| slope.is_finite())));
    }
    Ok(())
}

/// A missing stop, with all other numbers 0 of either sign.
#[test]
fn a_stop_at_infinity_is_none() {
    let mut x = [0.0; 6];
    x[2] = -0.0;
    let mut loads = [0.0; 6];
    loads[4] = -0.0;
    does_not_panic(x, loads, [0.0; 7], [0.0, 0.0, 0.0, f64::INFINITY], [0.0; 2]).unwrap();
}

proptest! {
    /// The formulas are tested in the same way in `properties.rs`.
    #[test]
    fn the_connector_does_not_panic(
        x in proptest::array::uniform6(common::anything()),
        loads in proptest::array::uniform6(common::anything()),
        cross in proptest::array::uniform7(common::anything()),
        stops in proptest::array::uniform4(common::anything()),
        [alpha, gamma] in proptest::array::uniform2(-3.5..3.5),
    ) {
        does_not_panic(x, loads, cross, stops, [alpha, gamma])?;
    }
}
