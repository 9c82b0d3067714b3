//! SLIDER as a program uses it: the typed API, both routes, the pivots, second derivatives, and arbitrary input.

#[path = "../xtask/src/studies/routes.rs"]
mod routes;

use crate::common;
use jointproof::connector::slider::{
    Basis, Constraint, Coordinates, Distances, Eliminate, Increment, IncrementalConstraint, Increments, KeptCoordinate,
    KeptIncrement, LineDirection, MovingNodes, Nodes, Pivots, Pivots2d, Slider, Slider2d, documented,
};
use jointproof::formula::proof::Proved;
use jointproof::formula::proof::value_and_jacobian_by_ad;
use jointproof::formula::{Fields, Formula};
use jointproof::number::scalar::{Scalar, abs};
use jointproof::toolkit::verify::{Sampler, Sensitivity, derivative_of_jacobian, eta, exactly};
use jointproof::{Error, Octuple};
use nalgebra::{Const, SMatrix, SVector, U1, Vector2, Vector3};
use num_dual::{Dual2, DualSVec};
use proptest::prelude::*;
use routes::Setting;

const AXES: [Vector3<f64>; 3] = [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 1.0)];

/// Distances of n from ±i at which t1 and t2 rotate increasingly fast.
const TILTS: [f64; 4] = [1e-16, 1e-12, 1e-8, 1e-4];

fn sampled<F: Proved>(points: usize) -> Vec<F::Inputs<f64>> {
    let mut sampler = Sampler::new::<F>(4);
    (0..points).map(|_| sampler.inputs::<F>()).collect()
}

// ---- the typed API

#[test]
fn bad_lines_are_named() {
    let (x1, nan) = (Vector3::new(1.0, 2.0, 3.0), f64::NAN);
    let message = |error: Error| error.to_string();
    let coincident = "x1 and xn are 0.0 apart; allowed is a distance ≥ 2.2250738585072014e-308";
    assert_eq!(message(Slider::new(x1, x1).unwrap_err()), coincident);
    assert_eq!(message(Slider2d::new(x1.xy(), x1.xy()).unwrap_err()), coincident);
    let lost = "xn[1] is NaN; allowed is a finite number";
    assert_eq!(message(Slider::new(x1, Vector3::new(0.0, nan, 0.0)).unwrap_err()), lost);
    assert_eq!(message(Slider2d::new(x1.xy(), Vector2::new(0.0, nan)).unwrap_err()), lost);
    let far = Vector3::repeat(f64::MAX);
    assert!(matches!(Slider::new(far, -far).unwrap_err(), Error::Overflow { .. }));
    assert!(matches!(Slider2d::new(far.xy(), -far.xy()).unwrap_err(), Error::Overflow { name: "l" }));

    let slider = Slider::new(Vector3::zeros(), x1).unwrap();
    let motion = Nodes { x1: Vector3::zeros(), xn: Vector3::new(0.0, 0.0, f64::INFINITY), xm: Vector3::zeros() };
    assert_eq!(message(slider.variations(x1, &motion).unwrap_err()), "motion.xn[2] is inf; allowed is a finite number");
    assert_eq!(message(slider.eliminate(nan).unwrap_err()), "xmk is NaN; allowed is a finite number");
    assert_eq!(message(slider.increment(x1, x1, x1, nan).unwrap_err()), "dxmk is NaN; allowed is a finite number");
    let short = Slider2d::new(Vector2::zeros(), Vector2::new(1e-300, 0.0)).unwrap();
    assert!(matches!(short.eliminate(f64::NEG_INFINITY).unwrap_err(), Error::NonFinite { .. }));
}

#[test]
fn the_typed_slider_says_what_the_formulas_say() {
    for i in sampled::<Increment>(200) {
        let KeptIncrement { x1, xn, xm, dx1, dxn, dxmk } = i;
        let slider = Slider::new(x1, xn).unwrap();
        let Pivots { i: axis_i, j: axis_j, k } = slider.pivots();
        let Increments { dxmi, dxmj } = Increment::eval(&i);
        let dxm = slider.increment(xm, dx1, dxn, dxmk).unwrap();
        assert_eq!((dxm[axis_i], dxm[axis_j], dxm[k]), (dxmi, dxmj, dxmk));
        let placed = slider.place(xm).unwrap();
        let coordinates = slider.eliminate(xm[k]).unwrap();
        assert_eq!((placed[axis_i], placed[axis_j], placed[k]), (coordinates.xmi, coordinates.xmj, xm[k]));
        let (residuals, rows) = slider.constraint_jacobian(xm).unwrap();
        assert_eq!(residuals, slider.constraint(xm).unwrap());
        assert_eq!(rows, Constraint::jacobian(&Nodes { x1, xn, xm }));
        assert_eq!(slider.basis(), Basis::eval(&LineDirection { n: slider.line().n }));
    }
}

#[test]
fn coefficients_times_variations_are_the_increment() {
    for i in sampled::<Increment>(500) {
        let KeptIncrement { x1, xn, xm, dx1, dxn, dxmk } = i;
        let coefficients = Slider::new(x1, xn).unwrap().coefficients(xm).unwrap();
        let matrix = coefficients.matrix();
        let variations = SVector::<f64, 7>::from_iterator(dx1.iter().chain(&dxn).copied().chain([dxmk]));
        let size = matrix.abs() * variations.abs();
        let Increments { dxmi, dxmj } = Increment::eval(&i);
        let error = matrix * variations - Vector2::new(dxmi, dxmj);
        assert!(error.iter().zip(&size).all(|(error, size)| error.abs() < 1e-15 * size), "{error} of {size}");

        let flat = Slider2d::new(x1.xy(), xn.xy()).unwrap();
        let matrix = flat.coefficients(xm.xy()).unwrap().matrix();
        let variations = SVector::<f64, 5>::new(dx1.x, dx1.y, dxn.x, dxn.y, dxmk);
        let dxm = flat.increment(xm.xy(), dx1.xy(), dxn.xy(), dxmk).unwrap();
        let (error, size) = (matrix * variations, matrix.abs() * variations.abs());
        assert!((error.x - dxm[flat.pivots().i]).abs() < 1e-15 * size.x);
        assert_eq!(dxm[flat.pivots().k], dxmk);
    }
}

#[test]
fn coefficients_are_the_derivative_of_the_elimination() {
    for KeptCoordinate { x1, xn, xmk } in sampled::<Eliminate>(200) {
        let slider = Slider::new(x1, xn).unwrap();
        let mut xm = Vector3::repeat(xmk);
        xm = slider.place(xm).unwrap();
        let matrix = slider.coefficients(xm).unwrap().matrix();
        let rows =
            value_and_jacobian_by_ad::<Eliminate, Octuple>(&exactly::<Eliminate>(&KeptCoordinate { x1, xn, xmk })).1;
        for (row, gradient) in [rows.xmi, rows.xmj].into_iter().enumerate() {
            let gradient = gradient.components().into_iter().map(Octuple::to_f64);
            for (found, expected) in matrix.row(row).iter().zip(gradient) {
                // m is on the line to within rounding; its fraction of the line is accurate to the rounding of the coordinates.
                let size = 1.0 + (xm.amax() + x1.amax() + xn.amax()) / (xn - x1).amax();
                assert!((found - expected).abs() < 1e-14 * size, "{found} {expected} {size}");
            }
        }
    }
}

// ---- any input at all

fn any3() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(common::anything()).prop_map(Vector3::from)
}

fn all_finite<const R: usize, const C: usize>(result: Result<SMatrix<f64, R, C>, Error>) -> bool {
    result.is_err() || result.is_ok_and(|m| m.iter().all(|x| x.is_finite()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// For every input: a finite result or an error, and no panic.
    #[test]
    fn no_input_panics(
        x1 in any3(), xn in any3(), xm in any3(), dx1 in any3(), dxn in any3(), dxm in any3(), number in common::anything(),
    ) {
        Pivots::new(&x1, &xn);
        Pivots::largest(&x1, &xn);
        Pivots2d::new(&x1.xy(), &xn.xy());
        documented::eliminate(&KeptCoordinate { x1, xn, xmk: number });
        documented::increment(&KeptIncrement { x1, xn, xm, dx1, dxn, dxmk: number });
        if let Ok(slider) = Slider::new(x1, xn) {
            prop_assert!(slider.line().components().iter().all(|x| x.is_finite()));
            prop_assert!(slider.basis().components().iter().all(|x| x.is_finite()));
            prop_assert!(all_finite(slider.place(xm)));
            prop_assert!(all_finite(slider.increment(xm, dx1, dxn, number)));
            prop_assert!(all_finite(slider.coefficients(xm).map(|c| c.matrix())));
            prop_assert!(all_finite(slider.eliminate(number).map(|m| Vector2::new(m.xmi, m.xmj))));
            prop_assert!(all_finite(slider.constraint(xm).map(|g| Vector2::new(g.g1, g.g2))));
            let rows = slider.constraint_jacobian(xm).map(|(_, g)| [g.g1, g.g2].map(|row| row.components()).concat());
            prop_assert!(rows.is_err() || rows.is_ok_and(|rows| rows.iter().all(|x| x.is_finite())));
            let motion = Nodes { x1: dx1, xn: dxn, xm: dxm };
            let g = slider.variations(xm, &motion).map(|v| [v.value, v.first, v.second].map(|g| Vector2::new(g.g1, g.g2)));
            prop_assert!(all_finite(g.map(|columns| SMatrix::<f64, 2, 3>::from_columns(&columns))));
        }
        if let Ok(slider) = Slider2d::new(x1.xy(), xn.xy()) {
            let xm = xm.xy();
            prop_assert!(all_finite(slider.place(xm)));
            prop_assert!(all_finite(slider.increment(xm, dx1.xy(), dxn.xy(), number)));
            prop_assert!(all_finite(slider.coefficients(xm).map(|c| c.matrix())));
            prop_assert!(all_finite(slider.eliminate(number).map(|x| Vector2::new(x, x))));
            prop_assert!(all_finite(slider.constraint(xm).map(|g| Vector2::new(g.g, g.g))));
            let row = slider.constraint_jacobian(xm).map(|(_, row)| row.g.components());
            prop_assert!(row.is_err() || row.is_ok_and(|row| row.iter().all(|x| x.is_finite())));
        }
    }

    /// The line itself never causes an error: every finite pair of distinct nodes makes a slider.
    #[test]
    fn any_two_nodes_make_a_line(x1 in prop::array::uniform3(common::signed()), xn in prop::array::uniform3(common::signed())) {
        let (x1, xn) = (Vector3::from(x1), Vector3::from(xn));
        prop_assume!(x1 != xn);
        let slider = Slider::new(x1, xn).unwrap();
        let Pivots { i, j, k } = slider.pivots();
        prop_assert_eq!(i + j + k, 3);
        prop_assert!(slider.line().n[k].abs() >= Pivots::LEAST - f64::EPSILON);
    }
}

// ---- both routes

/// A line with m on it at a fraction of the line, and increments: the variables of both routes, on the line.
fn on_the_line<D: Scalar>(v: &SVector<D, 14>) -> KeptIncrement<D> {
    let at = |k: usize| v.fixed_rows::<3>(k).into_owned();
    let (x1, xn) = (at(0), at(3));
    KeptIncrement { x1, xn, xm: x1 + (xn - x1) * v[12], dx1: at(6), dxn: at(9), dxmk: v[13] }
}

/// Value and gradient of both outputs of a route with respect to line, fraction and increments.
fn differentiated<T: Scalar>(
    v: &SVector<T, 14>,
    route: impl Fn(&KeptIncrement<DualSVec<T, 14>>) -> [DualSVec<T, 14>; 2],
) -> Vec<T> {
    let mut axis = 0..;
    let seeded = v.map(|x| DualSVec::from_re(x).derivative(axis.next().unwrap_or_default()));
    let parts = |out: DualSVec<T, 14>| {
        let gradient = out.eps.unwrap_generic(Const::<14>, U1);
        std::iter::once(out.re).chain(gradient.iter().copied().collect::<Vec<_>>())
    };
    route(&on_the_line(&seeded)).into_iter().flat_map(parts).collect()
}

/// Values and derivatives of the increments and of the position, by both routes.
fn both_routes<T: Scalar>(v: &SVector<T, 14>) -> [(Vec<T>, Vec<T>); 2] {
    let kept = |i: &KeptIncrement<DualSVec<T, 14>>| {
        let k = Pivots::new(&i.x1, &i.xn).k;
        KeptCoordinate { x1: i.x1, xn: i.xn, xmk: i.xm[k] }
    };
    let increments = |out: Increments<DualSVec<T, 14>>| [out.dxmi, out.dxmj];
    let coordinates = |out: Coordinates<DualSVec<T, 14>>| [out.xmi, out.xmj];
    [
        (
            differentiated(v, |i| increments(Increment::eval(i))),
            differentiated(v, |i| increments(documented::increment(i))),
        ),
        (
            differentiated(v, |i| coordinates(Eliminate::eval(&kept(i)))),
            differentiated(v, |i| coordinates(documented::eliminate(&kept(i)))),
        ),
    ]
}

/// Arbitrary lines and motions, with numbers of about one.
fn ordinary(points: usize) -> impl Iterator<Item = SVector<f64, 14>> {
    let scene = |tilt: f64, share: f64| Setting { tilt, share, ..Setting::default() }.scenes();
    let all = [0.25, 0.5, 1.0, 2.0, 4.0].into_iter().flat_map(move |tilt| scene(tilt, 0.5));
    all.zip((0..).map(|k: i32| f64::from(k % 7) - 2.5)).take(points).map(|(i, share)| {
        let parts = [i.x1, i.xn, i.dx1, i.dxn].into_iter().flat_map(|v| [v.x, v.y, v.z]);
        SVector::from_iterator(parts.chain([share, i.dxmk]))
    })
}

#[test]
fn the_documented_route_is_the_direct_one() {
    for v in ordinary(320) {
        let exact = both_routes(&v.map(Octuple::from));
        for ((direct, documented), (f64_direct, f64_documented)) in exact.iter().zip(&both_routes(&v)) {
            for (k, (&a, &b)) in direct.iter().zip(documented).enumerate() {
                let size = 1.0 + abs(a).to_f64();
                assert!(abs(a - b).to_f64() < 1e-66 * size, "entry {k} of {v}: {a} {b}");
                assert!((f64_direct[k] - a.to_f64()).abs() < 2e-14 * size, "direct, entry {k} of {v}");
                assert!((f64_documented[k] - a.to_f64()).abs() < 1e-13 * size, "documented, entry {k} of {v}");
            }
        }
    }
}

#[test]
fn off_the_line_the_documented_increments_are_others() {
    let on = Setting::default().scenes()[0];
    let off = KeptIncrement { xm: on.xm + Vector3::new(0.0, 0.25, 0.0), ..on };
    let [direct, documented] = [Increment::eval(&off), documented::increment(&off)];
    assert!((direct.dxmi - documented.dxmi).abs() > 1e-3);
    // Only the direct ones satisfy the incremental constraint there.
    let residual = |Increments { dxmi, dxmj }| {
        let Pivots { i, j, k } = Pivots::new(&off.x1, &off.xn);
        let dxm = AXES[i] * dxmi + AXES[j] * dxmj + AXES[k] * off.dxmk;
        let KeptIncrement { x1, xn, xm, dx1, dxn, .. } = off;
        let r = IncrementalConstraint::eval(&MovingNodes { x1, xn, xm, dx1, dxn, dxm });
        r.r1.abs().max(r.r2.abs())
    };
    assert!(residual(direct) < 1e-16 && residual(documented) > 1e-3);
}

#[test]
fn the_direct_route_keeps_its_digits_where_the_documented_one_loses_them() {
    let ordinary = Setting::default();
    let settings = [
        TILTS.map(|tilt| Setting { tilt, ..ordinary }),
        TILTS.map(|length| Setting { length, ..ordinary }),
        TILTS.map(|per_share| Setting { share: 1.0 / per_share, ..ordinary }),
        TILTS.map(|per_offset| Setting { offset: (1.0 / per_offset).min(1e12), ..ordinary }),
        [0.0, 1.0, 1e4, 1e16].map(|tilt| Setting { tilt, ..ordinary }),
    ];
    for setting in settings.as_flattened() {
        let (increment, eliminate) = (setting.increment_errors(), setting.eliminate_errors());
        assert!(increment.direct < 1e-15, "{setting:?} {increment:?}");
        assert!(eliminate.direct < 5e-16, "{setting:?} {eliminate:?}");
    }
    let lost = |setting: Setting| setting.increment_errors().documented;
    assert!(lost(Setting { tilt: 1e-8, ..ordinary }) > 1e-9);
    assert!(lost(Setting { length: 1e-8, ..ordinary }) > 1e-9);
    assert!(lost(Setting { offset: 1e8, ..ordinary }) > 1e-9);
    assert!(lost(Setting { share: 1e8, ..ordinary }) < 1e-14);
}

// ---- near ±i, and on it

/// The largest η of values and of the closed-form Jacobian.
fn worst_eta<F: Formula>(i: &F::Inputs<f64>) -> f64 {
    let exact = exactly::<F>(i);
    let inputs = exact.components();
    let gradients = value_and_jacobian_by_ad::<F, Octuple>(&exact).1.components();
    let values = F::eval(i).components().into_iter().zip(F::eval(&exact).components());
    let of_values = values
        .zip(&gradients)
        .map(|((found, expected), gradient)| eta(found, expected, Sensitivity::new(&gradient.components(), &inputs)));
    let entries = |rows: Vec<Vec<f64>>| rows.concat();
    let found = entries(F::jacobian(i).components().iter().map(Fields::components).collect());
    let expected: Vec<_> = gradients.iter().flat_map(Fields::components).collect();
    let of_entries = found.into_iter().zip(expected).zip(derivative_of_jacobian::<F, Octuple>(&exact));
    let of_entries = of_entries.map(|((found, expected), row)| eta(found, expected, Sensitivity::new(&row, &inputs)));
    of_values.chain(of_entries).fold(0.0, f64::max)
}

#[test]
fn near_the_x_axis_eta_is_at_most_8() {
    let mut worst = [0.0_f64; 3];
    for tilt in TILTS {
        for (length, offset, share) in [(1.0, 0.0, 0.4), (1.0, 0.1, 0.9), (1e-3, 1e-3, -30.0), (1e3, 7.0, 1e6)] {
            let setting = Setting { tilt, length, share, offset };
            for i in setting.scenes().into_iter().step_by(3) {
                let KeptIncrement { x1, xn, xm, dx1, dxn, dxmk } = i;
                if xn.yz() == x1.yz() {
                    continue; // The tilt is lost in the rounding of the offset.
                }
                let k = Pivots::new(&x1, &xn).k;
                let dxm = (dx1 + dxn) * 0.5 + AXES[k] * dxmk;
                let found = [
                    worst_eta::<Eliminate>(&KeptCoordinate { x1, xn, xmk: xm[k] }),
                    worst_eta::<Increment>(&i),
                    worst_eta::<IncrementalConstraint>(&MovingNodes { x1, xn, xm, dx1, dxn, dxm }),
                ];
                worst = [0, 1, 2].map(|f| worst[f].max(found[f]));
            }
        }
    }
    println!("worst η of eliminate, increment, incremental_constraint near ±i: {worst:.2?}");
    assert!(worst.iter().all(|&eta| eta <= 8.0), "{worst:?}");
}

#[test]
fn at_the_x_axis_directions_jump_and_what_they_constrain_does_not() {
    // The distance does not depend on the directions, and the increment of m does not depend on them either.
    let m = Vector3::new(1.0, 0.0, 0.25);
    let (dx1, dxn) = (Vector3::new(0.25, -0.5, 0.75), Vector3::new(-0.5, 0.125, 0.25));
    let from_origin = |xn: Vector3<f64>| Slider::new(Vector3::zeros(), xn).unwrap();
    for side in [1.0, -1.0] {
        let at = from_origin(Vector3::new(side, 0.0, 0.0));
        for (y, z) in [(1e-16, 0.0), (0.0, 1e-16), (-0.6e-16, 0.8e-16), (0.6e-16, -0.8e-16)] {
            let near = from_origin(Vector3::new(side, y, z));
            let distance = |slider: &Slider| {
                let Distances { g1, g2 } = slider.constraint(m).unwrap();
                g1.hypot(g2)
            };
            assert!((distance(&near) - distance(&at)).abs() < 2.5e-16);
            assert_eq!(near.pivots().k, at.pivots().k);
            let place = |slider: &Slider| slider.place(m).unwrap();
            assert!((place(&near) - place(&at)).amax() < 2.5e-16);
            let increment = |slider: &Slider| slider.increment(m, dx1, dxn, 0.375).unwrap();
            assert!((increment(&near) - increment(&at)).amax() < 2.5e-16);
        }
        let directions =
            [(1e-16, 0.0), (0.0, 1e-16), (-1e-16, 0.0)].map(|(y, z)| from_origin(Vector3::new(side, y, z)).basis().t1);
        assert_eq!(directions[0].dot(&directions[1]), 0.0);
        assert_eq!(directions[0].dot(&directions[2]), -1.0);
    }
}

// ---- second derivatives

/// The nodes along a motion, at a time.
fn moved<D: Scalar>(i: &MovingNodes<D>, time: D) -> Nodes<D> {
    Nodes { x1: i.x1 + i.dx1 * time, xn: i.xn + i.dxn * time, xm: i.xm + i.dxm * time }
}

/// Second-order duals over T.
fn second_order<T: Scalar>(i: &MovingNodes<T>) -> [[T; 3]; 2]
where
    Dual2<T>: Scalar,
{
    let components: Vec<_> = i.components().into_iter().map(Dual2::from_re).collect();
    let lifted = MovingNodes::from_slice(&components).unwrap();
    let Distances { g1, g2 } = Constraint::eval(&moved(&lifted, Dual2::new(T::zero(), T::one(), T::zero())));
    [g1, g2].map(|g| [g.re, g.v1, g.v2])
}

/// First and second derivatives by differences of fourth order, in 237 bits.
fn by_differences(i: &MovingNodes<Octuple>) -> [[Octuple; 2]; 2] {
    let h = Octuple::from(1e-12);
    let at = |steps: f64| {
        let Distances { g1, g2 } = Constraint::eval(&moved(i, h * steps));
        [g1, g2]
    };
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(at);
    [0, 1].map(|q| {
        let first = (a[q] - e[q] + (d[q] - b[q]) * 8.0) / (h * 12.0);
        let second = ((b[q] + d[q]) * 16.0 - a[q] - e[q] - c[q] * 30.0) / (h * h * 12.0);
        [first, second]
    })
}

#[test]
fn second_derivatives_of_the_constraint_agree_with_differences() {
    let near_i = Setting { tilt: 1e-3, ..Setting::default() }.scenes();
    let scenes = ordinary(40).map(|v| on_the_line(&v)).chain(near_i.into_iter().step_by(5));
    for i in scenes {
        let KeptIncrement { x1, xn, dx1, dxn, .. } = i;
        let xm = i.xm + Vector3::new(0.125, -0.25, 0.375); // off the line
        let dxm = Vector3::new(0.03, -0.01, 0.02);
        let scene = MovingNodes { x1, xn, xm, dx1, dxn, dxm };
        let components: Vec<_> = scene.components().into_iter().map(Octuple::from).collect();
        let exact = MovingNodes::from_slice(&components).unwrap();
        let (duals, differences) = (second_order(&exact), by_differences(&exact));

        let motion = Nodes { x1: dx1, xn: dxn, xm: dxm };
        let typed = Slider::new(x1, xn).unwrap().variations(xm, &motion).unwrap();
        let typed =
            [(typed.value.g1, typed.first.g1, typed.second.g1), (typed.value.g2, typed.first.g2, typed.second.g2)];
        // t1 and t2 rotate by at most the motion divided by the distance of the line from the x axis.
        let h = (xn - x1).yz().norm();
        let turning = 0.1 / h;
        for q in 0..2 {
            let [value, first, second] = duals[q];
            for (order, (dual, difference)) in [(1, (first, differences[q][0])), (2, (second, differences[q][1]))] {
                let size = 1e-40 * turning.max(1.0).powi(order + 4);
                assert!(abs(dual - difference).to_f64() < size, "{dual} {difference} {size:e} {scene:?}");
            }
            let (g, dg, ddg) = typed[q];
            assert_eq!([g, dg, ddg], second_order(&scene)[q]);
            let size = 1e-14 * (xm - x1).norm();
            assert!((g - value.to_f64()).abs() < size);
            assert!((dg - first.to_f64()).abs() < size * turning.max(1.0), "{dg} {first}");
            assert!((ddg - second.to_f64()).abs() < size * (turning * turning).max(1.0), "{ddg} {second}");
        }
    }
}

#[test]
fn mixed_second_derivatives_follow_from_three_motions() {
    let slider = Slider::new(Vector3::new(0.1, -0.2, 0.3), Vector3::new(1.0, 2.0, 2.5)).unwrap();
    let xm = Vector3::new(0.7, 0.4, 1.9);
    let u = Nodes { x1: Vector3::new(0.5, 0.0, -1.0), xn: Vector3::y(), xm: Vector3::new(1.0, 0.25, 0.0) };
    let v = Nodes { x1: Vector3::z(), xn: Vector3::new(0.5, -0.5, 0.0), xm: Vector3::new(0.0, -1.0, 0.5) };
    let sum = Nodes { x1: u.x1 + v.x1, xn: u.xn + v.xn, xm: u.xm + v.xm };
    let second = |motion: &Nodes<f64>| slider.variations(xm, motion).unwrap().second;
    let mixed = (second(&sum).g1 - second(&u).g1 - second(&v).g1) / 2.0;
    // The same from the closed-form Jacobian: the derivative along u of the derivative along v.
    let step = 1e-6;
    let slope = |time: f64| {
        let at = |x: Vector3<f64>, dx: Vector3<f64>| x + dx * time;
        let moved = Slider::new(at(Vector3::new(0.1, -0.2, 0.3), u.x1), at(Vector3::new(1.0, 2.0, 2.5), u.xn)).unwrap();
        let row = moved.constraint_jacobian(at(xm, u.xm)).unwrap().1.g1;
        row.x1.dot(&v.x1) + row.xn.dot(&v.xn) + row.xm.dot(&v.xm)
    };
    let difference = (slope(step) - slope(-step)) / (2.0 * step);
    assert!((mixed - difference).abs() < 1e-9, "{mixed} {difference}");
}
