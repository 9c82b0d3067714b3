//! SLIDER: the choice of the eliminated coordinates, and of the kept one.

use jointproof::connector::slider::{Pivots, Pivots2d, Slider, Slider2d};
use nalgebra::{Vector2, Vector3};

/// Lines through a grid on the faces of a cube, in every direction, none of them in a special position.
fn cube() -> impl Iterator<Item = Vector3<f64>> {
    let steps = || (0..122).map(|k| f64::from(2 * k - 121) / 121.0);
    let faces = (0..3).flat_map(move |axis| steps().flat_map(move |u| steps().map(move |v| (axis, u, v))));
    faces.flat_map(|(axis, u, v)| {
        [1.0, -1.0].map(|side| {
            let mut d = Vector3::repeat(side);
            (d[(axis + 1) % 3], d[(axis + 2) % 3]) = (u, v);
            d
        })
    })
}

/// The least |n_k| that a rule keeps, and its direction: the best on a grid, refined by ever smaller steps.
fn least(rule: impl Fn(&Vector3<f64>, &Vector3<f64>) -> Pivots) -> (f64, Vector3<f64>) {
    let kept = |d: &Vector3<f64>| d[rule(&Vector3::zeros(), d).k].abs() / d.norm();
    let mut best = cube().min_by(|a, b| kept(a).total_cmp(&kept(b))).unwrap();
    let mut step = 1.0 / 128.0;
    while step > 1e-17 {
        let moves = (0..27).map(|k| Vector3::new(k / 9, k / 3 % 3, k % 3).map(|x: i32| f64::from(x - 1)) * step);
        match moves.map(|by| best + by).find(|d| kept(d) < kept(&best)) {
            Some(better) => best = better,
            None => step /= 2.0,
        }
    }
    (kept(&best), best.abs() / best.amax())
}

#[test]
fn the_kept_axis_is_never_nearly_across_the_line() {
    let (size, d) = least(Pivots::new);
    assert!((size - Pivots::LEAST).abs() < 1e-15, "{size}");
    assert!((d - Vector3::new(1.0, 0.5, 0.5)).amax() < 1e-14, "{d}");
    assert!((Pivots::LEAST * 6.0_f64.sqrt() - 1.0).abs() < 2e-16);

    let (size, d) = least(Pivots::largest);
    assert!((size - Pivots::LEAST_OF_LARGEST).abs() < 1e-15, "{size}");
    assert!((d - Vector3::repeat(1.0)).amax() < 1e-14, "{d}");
    assert!((Pivots::LEAST_OF_LARGEST * 3.0_f64.sqrt() - 1.0).abs() < 2e-16);
}

/// The rule as documented: i has the largest |t1|, j of the others the larger |t2|; if rounding decides, either is accepted.
#[test]
fn the_pivots_are_those_of_t1_and_t2() {
    for d in cube().step_by(7) {
        let t = Slider::new(Vector3::zeros(), d).unwrap().basis();
        let Pivots { i, j, k } = Pivots::new(&Vector3::zeros(), &d);
        let slack = 1e-15;
        assert!((0..3).all(|axis| t.t1[i].abs() >= t.t1[axis].abs() - slack), "{d}");
        assert!(t.t2[j].abs() >= t.t2[k].abs() - slack, "{d}");
        let determinant = t.t1[i] * t.t2[j] - t.t1[j] * t.t2[i];
        assert!((determinant.abs() - (d[k] / d.norm()).abs()).abs() < slack, "{d}");
    }
}

/// Erratum: where |d1| = |d2| and d3 = 0, the rule in the plane keeps axis 1, and the one in space axis 2.
#[test]
fn at_a_tie_plane_and_space_keep_different_axes() {
    for (x, y) in [(1.0, 1.0), (1.0, -1.0), (-3.0, 3.0)] {
        let (plane, space) = (Vector2::new(x, y), Vector3::new(x, y, 0.0));
        let (plane, space) =
            (Slider2d::new(Vector2::zeros(), plane).unwrap(), Slider::new(Vector3::zeros(), space).unwrap());
        assert_eq!(plane.pivots(), Pivots2d { i: 1, k: 0 });
        assert_eq!(space.pivots(), Pivots { i: 2, j: 0, k: 1 });
        // Both move m onto the same line, each by the coordinate that it keeps.
        assert_eq!(plane.place(Vector2::new(0.5 * x, 7.0)).unwrap(), Vector2::new(0.5 * x, 0.5 * y));
        assert_eq!(space.place(Vector3::new(7.0, 0.5 * y, 7.0)).unwrap(), Vector3::new(0.5 * x, 0.5 * y, 0.0));
    }
    // One ulp next to the tie they agree.
    let d = Vector2::new(1.0_f64.next_up(), 1.0);
    assert_eq!((Pivots2d::new(&Vector2::zeros(), &d).k, Pivots::new(&Vector3::zeros(), &d.push(0.0)).k), (0, 0));
}
