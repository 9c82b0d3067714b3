//! Claims of the chapters that something depends on nothing else, makes no difference or is symmetric. A chapter names the
//! test, and the test quotes the chapter: `verify` compares the words.

use jointproof::catalog::{ELEMENTS, find};
use nalgebra::{Matrix3, Matrix4, Quaternion, Rotation3, SMatrix, SVector, UnitQuaternion, Vector3, Vector4};

/// Value and Jacobian of a formula, row by row, at the components of its inputs in order.
fn at(id: &str, point: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (value, jacobian) = find(id).unwrap().value_and_closed_jacobian(point).unwrap();
    (value, jacobian.chunks(point.len()).map(Vec::from).collect())
}

fn value(id: &str, point: &[f64]) -> Vec<f64> {
    at(id, point).0
}

#[test]
fn a_friction_force_follows_the_trial_force_or_the_limit() {
    // In stick the force does not depend on $\mu$ and $F_N$.
    for [mu, normal] in [[0.5, 4.0], [0.75, 4.0], [0.5, 100.0]] {
        let (force, slopes) = at("coulomb.return_map", &[1.0, mu, normal]);
        assert_eq!((force, slopes), (vec![1.0], vec![vec![1.0, 0.0, 0.0]]));
    }
    // In slip it does not depend on the motion in its own direction, which changes the trial force.
    for trial in [2.5, 3.0, 1e6] {
        let (force, slopes) = at("coulomb.return_map", &[trial, 0.5, 4.0]);
        assert_eq!((force, slopes), (vec![2.0], vec![vec![0.0, 4.0, 0.5]]));
    }
}

#[test]
fn a_slot_presses_alike_in_every_direction() {
    // The magnitude does not depend on the direction of the constraint force within the cross-section.
    for [f2, f3] in [[3.0, 4.0], [-4.0, 3.0], [5.0, 0.0], [0.0, -5.0]] {
        assert_eq!(value("slot.contact_force", &[f2, f3]), [5.0]);
    }
}

/// e1a, e2a, e3a, and the third axis of b, turned by the angle about e1a.
fn cross(alpha: f64) -> [f64; 12] {
    [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -alpha.sin(), alpha.cos()]
}

const ARMS: [f64; 4] = [1.0, 2.0, 0.5, 4.0];

#[test]
fn moments_of_a_cross_follow_both_angles_and_no_sign() {
    let moments =
        |alpha: f64, loads: [f64; 4]| value("ujoint.contact_moments", &[&cross(alpha)[..], &loads, &ARMS].concat());
    let loads = [20.0, -16.0, 80.0, 152.0];
    // With magnitudes the result does not depend on the sign of the load.
    assert_eq!(moments(0.25, loads), moments(0.25, loads.map(|load| -load)));
    // The components of the force along the axes of the cross turn with the other angle.
    let about_third = [0.0, 0.5, 1.0].map(|alpha| moments(alpha, loads)[1]);
    assert!(about_third.windows(2).all(|pair| (pair[0] - pair[1]).abs() > 0.1), "{about_third:?}");
    // A friction moment of one axis does not depend on whether the other axis slips: its normal moment has no input of the
    // other axis.
    let (_, slopes) = at("ujoint.normal_moments", &[5.0, 2.0, -1.0, 3.0]);
    assert_eq!([slopes[0][1], slopes[0][3], slopes[1][0], slopes[1][2]], [0.0; 4]);
    assert!([slopes[0][0], slopes[0][2], slopes[1][1], slopes[1][3]].iter().all(|slope| *slope != 0.0));
    // A press fit adds a contact moment that does not depend on the load.
    for load in [0.0, 5.0, 1000.0] {
        let with = value("ujoint.normal_moments", &[load, load, -1.0, 3.0]);
        let without = value("ujoint.normal_moments", &[load, load, 0.0, 0.0]);
        assert_eq!([with[0] - without[0], with[1] - without[1]], [1.0, 3.0]);
    }
}

#[test]
fn the_tangent_of_a_slide_line_ignores_a_common_offset() {
    // It depends only on differences of nodal positions.
    let nodes = [1.0, 0.25, 2.5, 1.0, 3.0, -0.5];
    for [r, z] in [[0.0, 0.0], [8.0, -4.0], [1024.0, 0.5]] {
        let moved: Vec<f64> = nodes.iter().enumerate().map(|(k, x)| x + if k % 2 == 0 { r } else { z }).collect();
        let tangent =
            |id: &str, count: usize, nodes: &[f64]| value(id, &[&nodes[..count], &[0.25]].concat())[2..].to_vec();
        for (id, count) in [("slide_line.linear_point", 4), ("slide_line.parabolic_point", 6)] {
            assert_eq!(tangent(id, count, &moved), tangent(id, count, &nodes), "{id}");
        }
    }
}

#[test]
fn past_the_end_of_a_straight_segment_the_gap_goes_on_as_before() {
    // On a straight segment there is no difference between the curve and its tangent.
    for r in [4.5, 4.9, 5.1, 5.5] {
        let linear = at("slide_line.closest_linear", &[r, 2.0, 1.0, 0.0, 5.0, 0.0]);
        let parabolic = at("slide_line.closest_parabolic", &[r, 2.0, 1.0, 0.0, 3.0, 0.0, 5.0, 0.0]);
        for (value, slopes) in [linear, parabolic] {
            assert_eq!((value[1], &slopes[1][..2]), (2.0, &[0.0, 1.0][..]), "{r}");
            // An end is a kink of the coordinate, which stops there.
            assert_eq!(value[0] == 1.0, r > 5.0);
        }
    }
}

#[test]
fn angles_of_two_triads_that_turn_together_stay() {
    // The angles depend only on the difference of the two spins.
    let turn = |angles: [f64; 3]| {
        let [x, y, z] = angles;
        *Rotation3::from_euler_angles(x, y, z).matrix()
    };
    let (a, b) = (turn([0.1, 0.2, 0.3]), turn([0.4, -0.2, 0.6]));
    let columns = |m: &Matrix3<f64>| m.as_slice().to_vec();
    let angles = |together: &Matrix3<f64>| {
        value("cardan.angles", &[columns(&(together * a)), columns(&(together * b))].concat())
    };
    let here = angles(&Matrix3::identity());
    for spin in [[0.5, 0.0, 0.0], [0.0, -1.0, 0.0], [0.3, 0.4, 2.0]] {
        let there = angles(&turn(spin));
        assert!(here.iter().zip(&there).all(|(here, there)| (here - there).abs() < 1e-14), "{here:?} {there:?}");
    }
}

/// The moment of a dead force c at the point d of a body, which has the potential c·(R d), and its derivative with respect to spins.
fn dead_force(rotation: &UnitQuaternion<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let (c, d) = (Vector3::new(2.0, -1.0, 3.0), Vector3::new(0.5, 1.0, -2.0));
    let arm = rotation * d;
    (arm.cross(&c), arm * c.transpose() - Matrix3::identity() * arm.dot(&c))
}

#[test]
fn the_stiffness_by_rotation_vectors_is_a_hessian() {
    // It is symmetric if the forces have a potential.
    let psi = Vector3::new(0.5, -1.0, 0.75);
    let (moment, by_spins) = dead_force(&UnitQuaternion::from_scaled_axis(psi));
    let (_, slopes) = at("element.rotation_vector", &[psi.as_slice(), moment.as_slice()].concat());
    let spins = Matrix3::from_fn(|row, column| slopes[row][3 + column]);
    let stiffness = spins * by_spins * spins.transpose() + Matrix3::from_fn(|row, column| slopes[row][column]);
    assert!((stiffness - stiffness.transpose()).amax() < 1e-13 && (by_spins - by_spins.transpose()).amax() > 0.1);
}

#[test]
fn the_stiffness_by_quaternions_is_a_hessian_along_unit_quaternions() {
    let q = Vector4::new(0.5, 0.1, -0.7, 0.5).normalize();
    let (moment, by_spins) = dead_force(&UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3])));
    let point = [q.as_slice(), moment.as_slice()].concat();
    let (_, slopes) = at("element.euler_parameters", &point);
    let block = |row: usize, column: usize| slopes[row][column];
    // Columns by m are the transpose of the spins by q.
    let spins: SMatrix<f64, 4, 3> = SMatrix::from_fn(|row, column| block(row, 4 + column));
    let own = Matrix4::from_fn(block);
    let stiffness = spins * by_spins * spins.transpose() + own;
    // It is symmetric only on motions that keep the length of the quaternion.
    let skew = stiffness - stiffness.transpose();
    let keeps = Matrix4::identity() - q * q.transpose();
    assert!((keeps * skew * keeps).amax() < 1e-13 && skew.amax() > 0.1, "{skew}");
}

/// The stiffness of a SLOT at a pose along no axis, with these parameters and this state of friction, and its last friction force.
fn slot_in_stick(k_stick: f64) -> (SMatrix<f64, 12, 12>, f64) {
    let nodes =
        [[0.6, 0.8, 0.0, -0.48, 0.36, 0.8, 0.64, -0.48, 0.6], [0.6, 0.64, -0.48, 0.0, 0.6, 0.8, 0.8, -0.48, 0.36]];
    let rest = [1.0, 2.0, 3.0, 2.5, 2.25, 4.0, 3.0, -4.0, 0.125, 0.25, -0.5, k_stick, 100.0, 0.25, 0.5, -0.25];
    let slot = ELEMENTS.iter().find(|element| element.spec().id == "slot").unwrap();
    let results = slot.value(&[&nodes.concat()[..], &rest].concat(), true).unwrap();
    let (stiffness, after) = (&results[2 + 24 + 12..][..144], results[results.len() - 1]);
    (SMatrix::from_row_slice(stiffness), after)
}

#[test]
fn a_friction_force_that_turns_with_its_node_has_a_geometric_stiffness() {
    // Besides $k_{\mathrm{stick}}$, the matrix has the geometric stiffness of the friction force itself, in stick as in slip.
    let (e, d) = (Vector3::new(0.6, 0.8, 0.0), Vector3::new(1.5, 0.25, 1.0));
    let turning = e.cross(&d);
    let along: SVector<f64, 12> =
        SVector::from_iterator((-e).iter().chain(&turning).chain(&e).chain(&[0.0; 3]).copied());
    let (with, force) = slot_in_stick(0.5);
    let (without, force_before) = slot_in_stick(1e-300);
    let own = with - without + along * along.transpose() * 0.5;
    // The rest is what the forces along e1a add when a turns: a force of −f1 e1a on b, and of f1 e1a on a.
    let change = (force - force_before) * e.cross_matrix();
    assert!((own.fixed_view::<3, 3>(0, 3) - change.map(|x| -x)).amax() < 1e-14, "{own}");
    assert!(own.amax() > 0.1 && (force - force_before).abs() > 0.1);
}

#[test]
fn forces_of_a_contact_are_those_on_a_segment() {
    // Both formulas refuse a coordinate beyond the ends of the segment.
    for (id, nodes) in [
        ("slide_line.nodal_forces_linear", vec![1.0, 2.0, 5.0, -1.0]),
        ("slide_line.nodal_forces_parabolic", vec![1.0, 2.0, 3.0, 0.5, 5.0, -1.0]),
    ] {
        let at = |g: f64| find(id).unwrap().value_and_closed_jacobian(&[&nodes[..], &[g, 2.0, 5.0, -3.0]].concat());
        assert!([-1.0, 0.5, 1.0].iter().all(|&g| at(g).is_ok()), "{id}");
        assert!([-1.5, 1.0_f64.next_up(), 2.0].iter().all(|&g| at(g).is_err()), "{id}");
    }
}

#[test]
fn in_the_plane_one_condition_of_a_slider_holds_for_every_point() {
    // The *first* condition is satisfied automatically where n2 ≠ 0; it is the second only for a line along the 1-axis.
    for (end, always) in [([3.0, 4.0, 0.0], 0), ([0.0, -2.0, 0.0], 0), ([-5.0, 1e-9, 0.0], 0), ([2.0, 0.0, 0.0], 1)] {
        for beside in [[1.0, 5.0, 0.0], [-2.0, 0.5, 0.0]] {
            let residuals = value("slider.constraint", &[[0.0; 3], end, beside].concat());
            assert!(residuals[always] == 0.0 && residuals[1 - always] != 0.0, "{end:?}: {residuals:?}");
        }
    }
}

#[test]
fn some_formulas_are_faster_than_a_copy_of_their_results() {
    // A formula with a structured Jacobian can be faster than copying, since it does not write the zeros.
    let report = include_str!("../book/report.json");
    let median = |text: &str, name: &str| -> Option<f64> {
        text.split_once(name)?.1.split_once("\"median\":")?.1.split([',', '}']).next()?.parse().ok()
    };
    let is_faster = |line: &&str| {
        let closed = line.split_once("\"id\":\"closed\"").and_then(|(_, rest)| median(rest, "\"jacobian\":"));
        median(line, "\"copy\":").zip(closed).is_some_and(|(copy, closed)| closed < copy)
    };
    let measured = report.lines().filter(|line| line.contains("\"copy\":")).count();
    let faster = report.lines().filter(is_faster).count();
    assert!(faster > 0 && faster < measured, "{faster} of {measured}");
}
