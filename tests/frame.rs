//! Triads: an accepted triad is orthonormal within the tolerance, whichever vector or pair of vectors deviates, and in either
//! direction.

use jointproof::element::frame::{PlaneTriad, TOLERANCE, Triad};
use nalgebra::{Vector2, Vector3};

/// Within the tolerance, and outside of it.
const NEAR: f64 = 0.9 * TOLERANCE;
const FAR: f64 = 1.1 * TOLERANCE;

fn axes() -> [Vector3<f64>; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()]
}

fn refusal([e1, e2, e3]: [Vector3<f64>; 3]) -> Option<String> {
    Triad::new(e1, e2, e3).err().map(|error| error.to_string())
}

#[test]
fn every_length_is_held_to_the_tolerance() {
    for (k, name) in ["e1", "e2", "e3"].iter().enumerate() {
        for sign in [1.0, -1.0] {
            let scaled = |by: f64| {
                let mut axes = axes();
                axes[k] *= 1.0 + sign * by;
                refusal(axes)
            };
            assert_eq!(scaled(NEAR), None, "{name}");
            assert!(scaled(FAR).unwrap().starts_with(&format!("{name} has length ")), "{name}");
        }
    }
}

/// The error for axes of which one is tilted towards another by this amount.
fn leaned(leaning: usize, other: usize, by: f64) -> Option<String> {
    let mut axes = axes();
    let to = axes[other];
    axes[leaning] += to * by;
    refusal(axes)
}

#[test]
fn every_angle_is_held_to_the_tolerance() {
    for (leaning, other, name) in [(0, 1, "e1·e2"), (1, 2, "e2·e3"), (2, 0, "e3·e1")] {
        for sign in [1.0, -1.0] {
            let leaned = |by: f64| leaned(leaning, other, sign * by);
            assert_eq!(leaned(NEAR), None, "{name}");
            assert!(leaned(FAR).unwrap().starts_with(&format!("{name} is ")), "{name}");
        }
    }
}

#[test]
fn the_tolerance_itself_is_let_in_and_the_next_number_is_not() {
    for (leaning, other) in [(0, 1), (1, 2), (2, 0)] {
        for sign in [1.0, -1.0] {
            let leaned = |by: f64| leaned(leaning, other, sign * by);
            assert_eq!(leaned(TOLERANCE), None);
            assert!(leaned(TOLERANCE.next_up()).is_some());
        }
    }
    let (x, y) = (Vector2::x(), Vector2::y());
    assert!(PlaneTriad::new(x, y + x * TOLERANCE).is_ok() && PlaneTriad::new(x, y - x * TOLERANCE).is_ok());
    let next = TOLERANCE.next_up();
    assert!(PlaneTriad::new(x, y + x * next).is_err() && PlaneTriad::new(x, y - x * next).is_err());
}

#[test]
fn triads_are_let_in_however_their_volume_is_rounded() {
    for degrees in 0..360 {
        let (s, c) = f64::from(degrees).to_radians().sin_cos();
        let [e1, e2, e3] = [Vector3::new(c, s, 0.0), Vector3::new(-s, c, 0.0), Vector3::z()];
        for [e1, e2, e3] in [[e1, e2, e3], [e2, e3, e1], [e3, e1, e2]] {
            assert_eq!(refusal([e1, e2, e3]), None, "{degrees}°");
            assert!(refusal([e1, e2, -e3]).unwrap().contains("right-handed"), "{degrees}°");
        }
    }
}

#[test]
fn left_handed_triads_are_refused_in_space_and_in_the_plane() {
    let [e1, e2, e3] = axes();
    assert_eq!(refusal([e2, e3, e1]), None);
    assert!(refusal([e2, e1, e3]).unwrap().contains("right-handed"));
    let (x, y) = (Vector2::x(), Vector2::y());
    assert!(PlaneTriad::new(y, -x).is_ok());
    assert!(PlaneTriad::new(y, x).is_err());
    assert!(PlaneTriad::new(x, y + x * NEAR).is_ok() && PlaneTriad::new(x, y - x * NEAR).is_ok());
    assert!(PlaneTriad::new(x, y + x * FAR).is_err() && PlaneTriad::new(x, y - x * FAR).is_err());
    assert!(PlaneTriad::new(x * (1.0 + FAR), y).is_err() && PlaneTriad::new(x, y * (1.0 - FAR)).is_err());
}

#[test]
fn a_triad_gives_back_its_vectors() {
    let [e1, e2, e3] = [Vector3::new(0.0, 0.6, 0.8), Vector3::new(0.0, -0.8, 0.6), Vector3::x()];
    let triad = Triad::new(e1, e2, e3).unwrap();
    assert_eq!([triad.e1(), triad.e2(), triad.e3()], [e1, e2, e3]);
    let plane = PlaneTriad::new(Vector2::new(0.6, 0.8), Vector2::new(-0.8, 0.6)).unwrap();
    let space = plane.in_space();
    assert_eq!(
        [space.e1(), space.e2(), space.e3()],
        [Vector3::new(0.6, 0.8, 0.0), Vector3::new(-0.8, 0.6, 0.0), Vector3::z()]
    );
    assert_eq!([plane.e1(), plane.e2()], [Vector2::new(0.6, 0.8), Vector2::new(-0.8, 0.6)]);
    // At any angle, however the sine and the cosine are rounded.
    for degrees in 0..360 {
        let (s, c) = f64::from(degrees).to_radians().sin_cos();
        let (e1, e2) = (Vector2::new(c, s), Vector2::new(-s, c));
        assert!(PlaneTriad::new(e1, e2).is_ok() && PlaneTriad::new(e1, -e2).is_err(), "{degrees}°");
    }
    let global = PlaneTriad::global().in_space();
    assert_eq!([global.e1(), global.e2(), global.e3()], axes());
}
