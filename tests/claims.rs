//! Claims of the chapters that something depends on nothing else, makes no difference or is symmetric. A chapter names the
//! test, and the test quotes the chapter: `verify` compares the words.

use jointproof::catalog::find;
use nalgebra::{Matrix3, Matrix4, Quaternion, Rotation3, SMatrix, UnitQuaternion, Vector3, Vector4};

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
