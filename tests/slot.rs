//! SLOT as a program uses it: every method gives the result of the documented formula, in space and in the plane.

use jointproof::catalog;
use jointproof::connector::slot::{Gaps, Pose, Pose2d, Slot, Slot2d};
use jointproof::element::frame::{PlaneTriad, Triad};
use jointproof::formula::Fields;
use nalgebra::{Vector2, Vector3};

/// The outputs of the catalog's formula with this identifier for these inputs.
fn by_formula(id: &str, inputs: &[&[f64]]) -> Vec<f64> {
    catalog::find(id).unwrap().value(&inputs.concat()).unwrap()
}

/// No axis coincides with a global axis, and no coordinate is 0.
fn triad() -> Triad {
    let (e1, e2) = (Vector3::new(2.0, 3.0, 6.0) / 7.0, Vector3::new(3.0, -6.0, 2.0) / 7.0);
    Triad::new(e1, e2, e1.cross(&e2)).unwrap()
}

const XA: Vector3<f64> = Vector3::new(1.0, -2.0, 0.5);
const START: Vector3<f64> = Vector3::new(3.0, 1.5, -1.0);
const NOW: Vector3<f64> = Vector3::new(-2.0, 4.0, 2.5);

fn pose(xb: Vector3<f64>) -> Pose {
    Pose { triad: triad(), xa: XA, xb }
}

#[test]
fn the_connector_says_what_the_formulas_say() {
    let slot = Slot::new(&pose(START)).unwrap();
    let (triad, now) = (triad(), pose(NOW));
    let [e1a, e2a, e3a] = [triad.e1(), triad.e2(), triad.e3()].map(<[f64; 3]>::from);
    let [xa, start, xb] = [XA, START, NOW].map(<[f64; 3]>::from);
    let initial = by_formula("slot.relative_position", &[&e1a, &e2a, &e3a, &xa, &start]);
    let position = by_formula("slot.relative_position", &[&e1a, &e2a, &e3a, &xa, &xb]);
    assert_eq!(slot.relative_position(&now).unwrap().components(), position);

    let residuals = by_formula("slot.constraint", &[&e2a, &e3a, &xa, &xb, &initial[1..]]);
    assert_eq!(slot.constraint(&now).unwrap().components(), residuals);
    let (again, rows) = slot.constraint_jacobian(&now).unwrap();
    assert_eq!(again.components(), residuals);
    assert_eq!((rows.gy.xb, rows.gz.xb), (triad.e2(), triad.e3()));

    let force = by_formula("slot.constraint_force", &[&e2a, &e3a, &[3.0, -4.0]]);
    assert_eq!(slot.constraint_force(&triad, 3.0, -4.0).unwrap().f.as_slice(), force);
    let force = by_formula("slot.kinetic_force", &[&e1a, &[5.0]]);
    assert_eq!(slot.kinetic_force(&triad, 5.0).unwrap().f.as_slice(), force);

    // The reference length is the initial one unless another is given.
    let [x, x0] = [position[0], initial[0]];
    let motion = |l1_ref| by_formula("slot.relative_motion", &[&[x, x0, l1_ref]]);
    assert_eq!(slot.relative_motion(&now).unwrap().components(), motion(x0));
    let other = slot.with_reference_length(0.25).unwrap();
    assert_eq!(other.relative_motion(&now).unwrap().components(), motion(0.25));
    assert_ne!(motion(0.25), motion(x0));

    let friction = |fc_int, mu| by_formula("slot.friction", &[&[2.0, 3.0, -4.0, fc_int, mu]]);
    assert_eq!(slot.friction(2.0, 3.0, -4.0).unwrap().components(), friction(0.0, 0.0));
    let rough = slot.with_friction(0.25, 7.0).unwrap();
    assert_eq!(rough.friction(2.0, 3.0, -4.0).unwrap().components(), friction(7.0, 0.25));
    let (value, slopes) = rough.friction_jacobian(2.0, 3.0, -4.0).unwrap();
    assert_eq!(value.components(), friction(7.0, 0.25));
    assert_eq!((slopes.phi.f1, slopes.r#fn.f2, slopes.r#fn.f3), (1.0, 0.6, -0.8));
}

#[test]
fn a_stop_that_is_missing_is_infinitely_far() {
    let slot = Slot::new(&pose(START)).unwrap();
    let x = slot.relative_position(&pose(NOW)).unwrap().x;
    let gaps = |slot: Slot| slot.gaps(&pose(NOW)).unwrap();
    let far = f64::INFINITY;
    assert_eq!(gaps(slot), None);
    let both = slot.with_stops(-9.0, 8.0).unwrap();
    assert_eq!(gaps(both), Some(Gaps { gap_min: x + 9.0, gap_max: 8.0 - x }));
    assert_eq!(gaps(slot.with_lower_stop(-9.0).unwrap()), Some(Gaps { gap_min: x + 9.0, gap_max: far }));
    assert_eq!(gaps(slot.with_upper_stop(8.0).unwrap()), Some(Gaps { gap_min: far, gap_max: 8.0 - x }));
    // Setting one stop again leaves the other unchanged.
    assert_eq!(gaps(both.with_lower_stop(-7.0).unwrap()), Some(Gaps { gap_min: x + 7.0, gap_max: 8.0 - x }));
    assert_eq!(gaps(both.with_upper_stop(6.0).unwrap()), Some(Gaps { gap_min: x + 9.0, gap_max: 6.0 - x }));
}

#[test]
fn in_the_plane_it_is_that_of_space_without_the_third_axis() {
    let (e1, e2) = (Vector2::new(0.6, 0.8), Vector2::new(-0.8, 0.6));
    let pose = |xb| Pose2d { triad: PlaneTriad::new(e1, e2).unwrap(), xa: Vector2::new(1.0, -2.0), xb };
    let in_space = |xb: Vector2<f64>| Pose {
        triad: PlaneTriad::new(e1, e2).unwrap().in_space(),
        xa: Vector3::new(1.0, -2.0, 0.0),
        xb: Vector3::new(xb.x, xb.y, 0.0),
    };
    let (start, now) = (Vector2::new(3.0, 1.5), Vector2::new(-2.0, 4.0));
    let plane = Slot2d::new(&pose(start)).unwrap().with_stops(-9.0, 8.0).unwrap().with_friction(0.25, 7.0).unwrap();
    let space = Slot::new(&in_space(start)).unwrap().with_stops(-9.0, 8.0).unwrap().with_friction(0.25, 7.0).unwrap();
    let residual = plane.constraint(&pose(now)).unwrap().gy;
    assert!((residual - space.constraint(&in_space(now)).unwrap().gy).abs() < 1e-15);
    assert!(residual.abs() > 1.0);
    let (again, row) = plane.constraint_jacobian(&pose(now)).unwrap();
    assert_eq!((again.gy, row.gy.xb, row.gy.xa, row.gy.y0), (residual, e2, -e2, -1.0));
    assert_eq!(plane.relative_motion(&pose(now)).unwrap(), space.relative_motion(&in_space(now)).unwrap());
    assert_eq!(plane.gaps(&pose(now)).unwrap(), space.gaps(&in_space(now)).unwrap());
    assert_eq!(plane.friction(2.0, 3.0).unwrap(), space.friction(2.0, 3.0, 0.0).unwrap());
}
