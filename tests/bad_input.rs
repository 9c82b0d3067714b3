//! Bad input gets a typed error that names the parameter, its value and what is allowed.

use jointproof::Error;
use jointproof::catalog::CATALOG;
use jointproof::frame::{PlaneTriad, Triad};
use jointproof::proof::Flag;
use jointproof::scalar::norm;
use jointproof::slot::{Pose, Pose2d, Slot, Slot2d};
use jointproof::verify::golden::components;
use nalgebra::{Vector2, Vector3};

fn pose() -> Pose {
    Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) }
}

#[track_caller]
fn assert_message<T: std::fmt::Debug>(result: Result<T, Error>, message: &str) {
    assert_eq!(result.unwrap_err().to_string(), message);
}

#[test]
fn every_invalid_case_is_answered_by_its_error() {
    for formula in CATALOG {
        for case in formula.golden().cases.iter().filter(|case| case.flags.contains(&Flag::Invalid)) {
            let inputs = components(formula.inputs(), &case.inputs).unwrap();
            let error = formula.value(&inputs).unwrap_err();
            let id = formula.spec().id;
            assert_eq!(Some(error.kind()), case.error.as_deref(), "{id} {}", case.id);
            assert!(error.to_string().contains("; allowed "), "{id} {}: {error}", case.id);
            assert_eq!(formula.audit_at(&inputs).unwrap_err().to_string(), error.to_string());
        }
    }
}

#[test]
fn the_wrong_number_of_components_is_an_error() {
    for formula in CATALOG {
        assert_eq!(formula.value(&[]).unwrap_err().kind(), "Components");
    }
}

#[test]
fn triads_must_be_finite_orthonormal_and_right_handed() {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    assert!(Triad::new(x, y, z).is_ok());
    assert_message(Triad::new(x, Vector3::new(0.0, f64::NAN, 0.0), z), "e2[1] is NaN; allowed is a finite number");
    assert_message(Triad::new(x, y, z * f64::INFINITY), "e3[0] is NaN; allowed is a finite number");
    assert_message(Triad::new(x * 2.0, y, z), "e1 has length 2.0; allowed is 1 within 1e-10");
    assert_message(Triad::new(x, x, z), "e1·e2 is 1.0; allowed is 0 within 1e-10");
    assert_message(
        Triad::new(x, y, -z),
        "e3 points against e1 × e2; allowed is a right-handed triad (reverse one vector)",
    );
    assert_message(
        Triad::new(Vector3::repeat(1e300), y, z),
        "e1 has length 1.7320508075688774e300; allowed is 1 within 1e-10",
    );
}

#[test]
fn plane_triads_too() {
    let (x, y) = (Vector2::x(), Vector2::y());
    assert!(PlaneTriad::new(x, y).is_ok());
    assert_message(
        PlaneTriad::new(x, -y),
        "e2 points to the right of e1; allowed is e1 turned left by 90° (reverse one vector)",
    );
    assert_message(PlaneTriad::new(x, y * 0.5), "e2 has length 0.5; allowed is 1 within 1e-10");
    assert_message(PlaneTriad::new(x, Vector2::new(0.6, 0.8)), "e1·e2 is 0.6; allowed is 0 within 1e-10");
}

#[test]
fn slots_name_the_parameter() {
    let slot = Slot::new(&pose()).unwrap();
    assert_message(slot.with_stops(2.0, 1.0), "l1_min = 2.0 is above l1_max = 1.0; allowed is l1_min ≤ l1_max");
    assert_message(slot.with_stops(f64::NEG_INFINITY, 1.0), "l1_min is -inf; allowed is a finite number");
    assert_message(slot.with_friction(-0.1, 0.0), "mu is -0.1; allowed is a finite number ≥ 0");
    assert_message(slot.with_friction(0.1, f64::NAN), "fc_int is NaN; allowed is a finite number");
    assert_message(slot.with_reference_length(f64::INFINITY), "l1_ref is inf; allowed is a finite number");
    assert_message(slot.friction(1.0, f64::NAN, 0.0), "f2 is NaN; allowed is a finite number");
    let far = Pose { xb: Vector3::new(f64::MAX, 0.0, 0.0), xa: Vector3::new(-f64::MAX, 0.0, 0.0), ..pose() };
    assert_message(
        Slot::new(&far),
        "x is too large for a double; allowed are results below 1.8e308 (use units in which the inputs are closer to 1)",
    );
    let lost = Pose { xb: Vector3::new(0.0, f64::NAN, 0.0), ..pose() };
    assert_message(slot.constraint(&lost), "xb[1] is NaN; allowed is a finite number");
}

#[test]
fn plane_slots_too() {
    let pose = Pose2d { triad: PlaneTriad::global(), xa: Vector2::zeros(), xb: Vector2::new(1.0, f64::NAN) };
    assert_message(Slot2d::new(&pose), "xb[1] is NaN; allowed is a finite number");
    let slot = Slot2d::new(&Pose2d { xb: Vector2::x(), ..pose }).unwrap();
    assert_message(slot.with_friction(f64::NAN, 0.0), "mu is NaN; allowed is a finite number ≥ 0");
}

/// Whether two points coincide is mostly decided by a sum of magnitudes; at the limit it must be the length that decides.
#[test]
fn points_are_apart_where_their_distance_is_a_normal_number() {
    let directions = [[1.0, 0.0, 0.0], [0.0, -1.0, 1.0], [1.0, 1.0, -1.0], [0.6, 0.0, 0.8], [1.0, 1e-3, 0.0]];
    let sizes = (0..=600).map(|k| f64::MIN_POSITIVE * (f64::from(k) / 100.0)).chain([1e-300, 1.0, f64::MAX]);
    let mut decided = [0, 0];
    for (direction, size) in sizes.flat_map(|size| directions.map(|direction| (Vector3::from(direction), size))) {
        let x = direction * size;
        let apart = Error::check_apart(("a", Vector3::zeros()), ("b", x)).is_ok();
        assert_eq!(apart, norm(<[f64; 3]>::from(x)) >= f64::MIN_POSITIVE, "{x:?}");
        assert_eq!(apart, Error::check_direction("d", x).is_ok());
        decided[usize::from(apart)] += 1;
    }
    assert!(decided.iter().all(|&count| count > 300), "{decided:?}");
    let nowhere = Vector3::new(1.0, f64::NAN, f64::INFINITY);
    assert!(Error::check_apart(("a", Vector3::zeros()), ("b", nowhere)).is_err());
}
