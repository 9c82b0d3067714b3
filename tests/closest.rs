//! The closest point is the global one, on every kind of curve, and no input makes the search loop or panic.

use jointproof::catalog::find;
use jointproof::contact::slide_line::{
    ClosestLinear, ClosestParabolic, ClosestSmoothedLinear, ClosestSmoothedParabolic, CornerFoot, LinearCornerPlace,
    LinearCornerSlave, LinearPlace, LinearPoint, LinearSlave, ParabolicCornerPlace, ParabolicCornerSlave,
    ParabolicPlace, ParabolicPoint, ParabolicSlave, SegmentFoot, SmoothedLinearPoint, SmoothedParabolicPoint,
};
use jointproof::formula::{Component, Fields, Formula, Jacobian, check, value, value_and_jacobian};
use jointproof::toolkit::verify::golden::components;
use jointproof::toolkit::verify::{Sensitivity, eta, exactly};
use jointproof::{Error, Octuple};
use nalgebra::Vector2;
use proptest::prelude::*;
use serde_json::{Map, Value};

type Point = Vector2<f64>;

/// A curve that can be searched by any method, and the formula's own result.
trait Curve: Formula {
    const ENDS: [f64; 2];
    fn slave(i: &Self::Inputs<f64>) -> Point;
    fn at(i: &Self::Inputs<f64>, u: f64) -> Point;
    fn coordinate<T: Component>(foot: &Self::Outputs<T>) -> T;
    fn separation<T: Component>(foot: &Self::Outputs<T>) -> T;
}

/// Names the parts of a formula.
macro_rules! curve {
    ($formula:ty, $inputs:ident { $($field:ident),* }, $point:ty, $place:ident, $foot:ident.$u:ident, $ends:expr) => {
        impl Curve for $formula {
            const ENDS: [f64; 2] = $ends;
            fn slave(i: &$inputs<f64>) -> Point {
                i.xs
            }
            fn at(i: &$inputs<f64>, u: f64) -> Point {
                <$point>::eval(&$place { $($field: i.$field,)* $u: u }).x
            }
            fn coordinate<T: Component>(foot: &$foot<T>) -> T {
                foot.$u
            }
            fn separation<T: Component>(foot: &$foot<T>) -> T {
                foot.separation
            }
        }
    };
}

curve!(ClosestLinear, LinearSlave { x1, x2 }, LinearPoint, LinearPlace, SegmentFoot.g, [-1.0, 1.0]);
curve!(ClosestParabolic, ParabolicSlave { x1, x2, x3 }, ParabolicPoint, ParabolicPlace, SegmentFoot.g, [-1.0, 1.0]);
curve!(
    ClosestSmoothedLinear,
    LinearCornerSlave { x1, x2, x3, f },
    SmoothedLinearPoint,
    LinearCornerPlace,
    CornerFoot.t,
    [0.0, 1.0]
);
curve!(
    ClosestSmoothedParabolic,
    ParabolicCornerSlave { x1, x2, x3, x4, x5, f },
    SmoothedParabolicPoint,
    ParabolicCornerPlace,
    CornerFoot.t,
    [0.0, 1.0]
);

/// The number of points of the dense search.
const DENSE: u32 = 1000;

/// The least distance found by a dense search: on a grid, then by trisection around each of its minima.
fn dense_search<F: Curve>(i: &F::Inputs<f64>) -> f64 {
    let distance = |u: f64| (F::slave(i) - F::at(i, u)).norm();
    let [from, to] = F::ENDS;
    let coordinate = |k: u32| from + (to - from) * f64::from(k) / f64::from(DENSE);
    let grid: Vec<f64> = (0..=DENSE).map(|k| distance(coordinate(k))).collect();
    let mut least = f64::INFINITY;
    for k in 0..=DENSE {
        let [before, after] = [k.saturating_sub(1), (k + 1).min(DENSE)];
        let here = grid[k as usize];
        if here <= grid[before as usize] && here <= grid[after as usize] {
            let (mut low, mut high) = (coordinate(before), coordinate(after));
            for _ in 0..60 {
                let third = (high - low) / 3.0;
                if distance(low + third) < distance(high - third) {
                    high -= third;
                } else {
                    low += third;
                }
            }
            least = least.min(here).min(distance(low));
        }
    }
    least
}

/// The foot is on the curve between its ends, nothing is nearer, and the separation is its distance unless it is an end.
fn is_global<F: Curve>(i: &F::Inputs<f64>) -> Result<(), TestCaseError> {
    let foot = match value::<F>(i) {
        Ok(foot) => foot,
        Err(Error::NoTangent { .. } | Error::TooClose { .. }) => return Ok(()),
        Err(error) => return Err(TestCaseError::fail(error.to_string())),
    };
    let (u, [from, to]) = (F::coordinate(&foot), F::ENDS);
    prop_assert!((from..=to).contains(&u), "{u}");
    let found = (F::slave(i) - F::at(i, u)).norm();
    let size = i.components().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    // Points of the curve are accurate to some ulps of the largest coordinate.
    let blur = 1e-14 * size;
    let least = dense_search::<F>(i);
    prop_assert!(found <= least + blur, "{found} at {u}, but {least} elsewhere");
    if from < u && u < to {
        let separation = F::separation(&foot).abs();
        // The rounding of u affects the distance to second order, or to first order if the distance is that small.
        prop_assert!((separation - found).abs() <= 10.0 * blur + 1e-7 * found, "{separation} against {found}");
    }
    Ok(())
}

fn point() -> impl Strategy<Value = Point> {
    [-10.0..10.0, -10.0..10.0].prop_map(Point::from)
}

/// Nodes of a parabola: arbitrary, nearly straight, and with the midside node at or near the quarter point.
fn parabola() -> impl Strategy<Value = [Point; 3]> {
    let sagitta = prop_oneof![Just(0.0), Just(1e-14), Just(1e-8), Just(1e-4), -2.0..2.0];
    let middle = prop_oneof![Just(0.5), Just(0.25), Just(0.75), 0.2..0.8];
    let shaped = (point(), point(), middle, sagitta).prop_map(|(x1, x3, middle, sagitta)| {
        let chord = x3 - x1;
        [x1, x1 + chord * middle + Point::new(-chord.y, chord.x) * sagitta, x3]
    });
    prop_oneof![shaped, [point(), point(), point()]]
}

fn fraction() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.2), Just(1e-8), Just(0.5_f64.next_down()), 0.001..0.499]
}

/// A slave point: anywhere, or at any height above the middle of the curve, so that centres of curvature occur.
fn slave(nodes: &[Point], anywhere: Point, height: Option<f64>) -> Point {
    let (first, middle, last) = (nodes[0], nodes[nodes.len() / 2], nodes[nodes.len() - 1]);
    let across = Point::new(first.y - last.y, last.x - first.x);
    height.map_or(anywhere, |height| middle + across * height)
}

fn height() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), (-2.0..2.0).prop_map(Some)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn nothing_is_nearer_on_a_straight_segment(nodes in [point(), point()], xs in point(), height in height()) {
        let [x1, x2] = nodes;
        is_global::<ClosestLinear>(&LinearSlave { xs: slave(&nodes, xs, height), x1, x2 })?;
    }

    #[test]
    fn nothing_is_nearer_on_a_parabola(nodes in parabola(), xs in point(), height in height()) {
        let [x1, x2, x3] = nodes;
        is_global::<ClosestParabolic>(&ParabolicSlave { xs: slave(&nodes, xs, height), x1, x2, x3 })?;
    }

    #[test]
    fn nothing_is_nearer_on_a_corner(nodes in parabola(), f in fraction(), xs in point(), height in height()) {
        let [x1, x2, x3] = nodes;
        is_global::<ClosestSmoothedLinear>(&LinearCornerSlave { xs: slave(&nodes, xs, height), x1, x2, x3, f })?;
    }

    #[test]
    fn nothing_is_nearer_on_a_corner_between_parabolas(
        before in parabola(),
        after in parabola(),
        f in fraction(),
        xs in point(),
        height in height(),
    ) {
        let ([x1, x2, x3], move_by) = (before, before[2] - after[0]);
        let [x4, x5] = [after[1] + move_by, after[2] + move_by];
        let xs = slave(&[x1, x2, x3, x4, x5], xs, height);
        is_global::<ClosestSmoothedParabolic>(&ParabolicCornerSlave { xs, x1, x2, x3, x4, x5, f })?;
    }

    /// The crate polycool finds the roots of the same cubic.
    #[test]
    fn polycool_finds_nothing_nearer(nodes in parabola(), xs in point()) {
        let [x1, x2, x3] = nodes;
        let i = ParabolicSlave { xs, x1, x2, x3 };
        let Ok(foot) = value::<ClosestParabolic>(&i) else { return Ok(()) };
        // (xs − X)·X′ with X = x2 + g c + g² b.
        let (gap, c, b) = (xs - x2, (x3 - x1) * 0.5, (x1 + x3) * 0.5 - x2);
        let cubic = [gap.dot(&c), 2.0 * gap.dot(&b) - c.dot(&c), -3.0 * b.dot(&c), -2.0 * b.dot(&b)];
        let roots = polycool::Poly::new(cubic).roots_between(-1.0, 1.0, 1e-14);
        let distance = |g: f64| (xs - ClosestParabolic::at(&i, g)).norm();
        let least = roots.iter().copied().chain([-1.0, 1.0]).map(distance).fold(f64::INFINITY, f64::min);
        prop_assert!(distance(foot.g) <= least + 1e-13, "{} against {least}", distance(foot.g));
    }
}

/// Any double: ordinary, tiny, huge, subnormal, infinite, not a number.
fn any_double() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -10.0..10.0,
        2 => prop::num::f64::ANY,
        1 => prop_oneof![Just(0.0), Just(1.0), Just(-1.0), Just(f64::NAN), Just(f64::INFINITY), Just(f64::MAX)],
    ]
}

/// The formula returns numbers or an error; in any case it returns.
fn answers<F: Curve>(components: &[f64]) -> Result<(), TestCaseError> {
    let Some(i) = F::Inputs::from_slice(components) else { return Err(TestCaseError::fail("components")) };
    // Also without checks: a solver may call it with anything in its inner loop.
    let (out, gradients) = F::linearized(&i);
    let bits = |components: Vec<f64>| {
        components.into_iter().map(|x| if x.is_nan() { None } else { Some(x.to_bits()) }).collect::<Vec<_>>()
    };
    prop_assert_eq!(bits(out.components()), bits(F::eval(&i).components()));
    let entries = |rows: Jacobian<F, f64>| rows.components().iter().flat_map(Fields::components).collect::<Vec<_>>();
    prop_assert_eq!(bits(entries(gradients)), bits(entries(F::jacobian(&i))));
    if let Ok((foot, jacobian)) = value_and_jacobian::<F>(&i) {
        prop_assert!((F::ENDS[0]..=F::ENDS[1]).contains(&F::coordinate(&foot)));
        prop_assert!(foot.components().iter().all(|x| x.is_finite()));
        prop_assert!(entries(jacobian).into_iter().all(f64::is_finite));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn any_input_is_answered(components in proptest::collection::vec(any_double(), 13)) {
        answers::<ClosestLinear>(&components[..6])?;
        answers::<ClosestParabolic>(&components[..8])?;
        answers::<ClosestSmoothedLinear>(&components[..9])?;
        answers::<ClosestSmoothedParabolic>(&components)?;
    }
}

#[test]
fn degenerate_curves_are_rejected_by_name() {
    let on = |r: f64| Point::new(r, 1.0);
    let (xs, f) = (Point::new(2.0, 5.0), 0.25);
    let too_close = |error: Error| match error {
        Error::TooClose { first, second, .. } => [first, second],
        error => panic!("{error}"),
    };
    let linear = value::<ClosestLinear>(&LinearSlave { xs, x1: on(1.0), x2: on(1.0) });
    assert_eq!(too_close(linear.unwrap_err()), ["x1", "x2"]);
    let parabola = ParabolicSlave { xs, x1: on(1.0), x2: on(2.0), x3: on(2.0) };
    assert_eq!(too_close(value::<ClosestParabolic>(&parabola).unwrap_err()), ["x2", "x3"]);
    let corner = LinearCornerSlave { xs, x1: on(1.0), x2: on(2.0), x3: on(2.0), f };
    assert_eq!(too_close(value::<ClosestSmoothedLinear>(&corner).unwrap_err()), ["x2", "x3"]);
    let corner = ParabolicCornerSlave { xs, x1: on(1.0), x2: on(2.0), x3: on(3.0), x4: on(4.0), x5: on(4.0), f };
    assert_eq!(too_close(value::<ClosestSmoothedParabolic>(&corner).unwrap_err()), ["x4", "x5"]);
    // The midside node at the quarter point, and the slave point before the end where X′ = 0.
    let quarter = ParabolicSlave { xs: Point::new(0.0, 1.0), x1: on(1.0), x2: on(2.0), x3: on(5.0) };
    let error = value::<ClosestParabolic>(&quarter).unwrap_err();
    assert_eq!(error, Error::NoTangent { coordinate: "g", value: -1.0 });
    let outside = LinearCornerSlave { f: 0.5, x3: on(4.0), ..LinearCornerSlave::filled(0.0) };
    assert_eq!(check::<ClosestSmoothedLinear>(&outside).unwrap_err().kind(), "OutOfRange");
}

/// On a tie the smaller coordinate wins, and at an end the separation is from the curve's own tangent.
#[test]
fn ties_and_ends_follow_their_rules() {
    let bowl = |r, z| ParabolicSlave {
        xs: Point::new(r, z),
        x1: Point::new(-1.0, 1.0),
        x2: Point::zeros(),
        x3: Point::new(1.0, 1.0),
    };
    let tied = value::<ClosestParabolic>(&bowl(0.0, 1.0)).unwrap().g;
    assert!((tied + 0.5_f64.sqrt()).abs() < 1e-15, "{tied}");
    let (ends, jacobian) = value_and_jacobian::<ClosestParabolic>(&bowl(0.0, 9.0)).unwrap();
    assert_eq!(ends.g, -1.0);
    assert_eq!(jacobian.g, ParabolicSlave::filled(0.0));
    // The separation from the tangent z = -2r - 1 at the end.
    assert!((ends.separation - 10.0 / 5.0_f64.sqrt()).abs() < 1e-15);
}

/// Close to a centre of curvature the condition of the coordinate is inversely proportional to the distance from it: its error is
/// within the effect of rounding the inputs, and that of the separation is a few ulps all the way.
#[test]
fn near_a_centre_of_curvature_the_foot_is_as_good_as_its_condition() {
    let mut last = 0.0;
    for exponent in 1..=15 {
        let beside = 0.1_f64.powi(exponent);
        // z = r² has its centre of curvature for r = 0 at z = 1/2; shifted, so that no coordinate is 0.
        let at = |r: f64, z: f64| Point::new(r + 3.0, z + 2.0);
        let i = ParabolicSlave { xs: at(beside, 0.5), x1: at(-1.0, 1.0), x2: at(0.0, 0.0), x3: at(1.0, 1.0) };
        let exact = exactly::<ClosestParabolic>(&i);
        let (found, truth) = (ClosestParabolic::eval(&i), ClosestParabolic::eval(&exact));
        let gradients = ClosestParabolic::jacobian(&exact);
        let inputs = exact.components();
        let sensitivity = |gradient: &ParabolicSlave<Octuple>| Sensitivity::new(&gradient.components(), &inputs);
        let foot = eta(found.g, truth.g, sensitivity(&gradients.g));
        let separation = eta(found.separation, truth.separation, sensitivity(&gradients.separation));
        let condition = (sensitivity(&gradients.g).per(truth.g)).to_f64();
        println!("{beside:e}: condition of g {condition:.1e}, η of g {foot:.2}, of the separation {separation:.2}");
        assert!(foot <= 8.0 && separation <= 8.0, "{beside:e}: {foot} {separation}");
        assert!(condition > last, "the condition grows towards the centre");
        last = condition;
    }
    assert!(last > 1e14);
}

/// Points at which a search refuted bounds of η, each as `audit --attack` prints it: beyond an end, where the separation was taken
/// from the end; near an end, where ∂X/∂f is nearly tangential; near a node that nothing depends on; with sides nearly along the gap.
#[test]
fn where_terms_cancel_the_bounds_hold() {
    let points: Map<String, Value> = serde_json::from_str(include_str!("data/cancelling.json")).unwrap();
    for (id, points) in points {
        let formula = find(&id).unwrap();
        for point in points.as_array().unwrap() {
            let inputs = components(formula.inputs(), point.as_object().unwrap()).unwrap();
            for claim in formula.eta_at(&inputs).unwrap() {
                assert_eq!(claim.failures, 0, "{id} {point}: {claim:?}");
            }
        }
    }
}
