//! Slide lines and the elements on them as a program uses them, and what they reject.

#![expect(clippy::float_cmp, reason = "exact results are expected exactly")]

use jointproof::formula::Formula;
use jointproof::slide_line::{
    ClosestPoint, Kind, LinearCornerPlace, LinearPlace, LinearPoint, Nodes, ParabolicCornerPlace, ParabolicPlace,
    ParabolicPoint, Place, SlideLine, SmoothedLinearPoint, SmoothedParabolicPoint,
};
use jointproof::{Error, Octuple};
use nalgebra::Vector2;
use num_dual::Dual64;
use proptest::prelude::*;

/// Nodes numbered from 1.
fn numbered(places: &[[f64; 2]]) -> Nodes {
    Nodes::new((1..).zip(places.iter().copied())).unwrap()
}

fn line(kind: Kind, count: usize, smoothing: Option<f64>) -> SlideLine {
    let line = SlideLine::generate(kind, 1, u32::try_from(count).unwrap(), 1).unwrap();
    smoothing.map_or(line.clone(), |f| line.smoothed(f).unwrap())
}

fn closest(kind: Kind, places: &[[f64; 2]], smoothing: Option<f64>, xs: [f64; 2]) -> ClosestPoint {
    line(kind, places.len(), smoothing).place(&numbered(places)).unwrap().closest(xs.into()).unwrap()
}

// --- Topology and what is rejected -----------------------------------------------------------------------------------

#[test]
fn bad_lines_are_named() {
    let message = |result: Result<SlideLine, Error>| result.unwrap_err().to_string();
    let odd = "an odd number of nodes, at least 3, in a parabolic slide line";
    for (count, nodes) in [(0, vec![]), (1, vec![1]), (2, vec![1, 2]), (4, vec![1, 2, 3, 4])] {
        let expected = format!("{count} nodes are given; allowed is {odd}");
        assert_eq!(message(SlideLine::new(Kind::Parabolic, nodes)), expected);
    }
    assert_eq!(
        message(SlideLine::new(Kind::Linear, [7])),
        "1 nodes are given; allowed is at least 2 nodes in a linear slide line"
    );
    assert_eq!(message(SlideLine::generate(Kind::Parabolic, 1, 4, 1)), format!("4 nodes are given; allowed is {odd}"));
    for (first, last, increment) in [(1, 9, 0), (1, 9, -2), (9, 1, 2), (1, 9, 3), (1, 1, 0), (1, 9, i64::MIN)] {
        assert_eq!(
            message(SlideLine::generate(Kind::Linear, first, last, increment)),
            format!(
                "increment {increment} does not lead from node {first} to node {last}; \
                 allowed is a divisor of {last} - {first} with its sign"
            )
        );
    }
    let straight = || SlideLine::new(Kind::Linear, [1, 2]).unwrap();
    for (f, shown) in [(0.0, "0.0"), (0.5, "0.5"), (-0.2, "-0.2"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        assert_eq!(message(straight().smoothed(f)), format!("f is {shown}; allowed is a number > 0 and < 0.5"));
    }
}

#[test]
fn bad_nodes_are_named() {
    let message = |result: Result<Nodes, Error>| result.unwrap_err().to_string();
    let allowed = "allowed are finite coordinates with r ≥ 0, once per node";
    assert_eq!(message(Nodes::new([(3, [-0.5, 0.0])])), format!("node 3 has the radius -0.5; {allowed}"));
    assert_eq!(message(Nodes::new([(3, [f64::NAN, 0.0])])), format!("node 3 is at (NaN, 0); {allowed}"));
    assert_eq!(message(Nodes::new([(3, [0.0, f64::INFINITY])])), format!("node 3 is at (0, inf); {allowed}"));
    assert_eq!(message(Nodes::new([(3, [0.0; 2]), (3, [1.0; 2])])), format!("node 3 is given twice; {allowed}"));

    let place =
        |kind, count, places: &[[f64; 2]]| line(kind, count, None).place(&numbered(places)).unwrap_err().to_string();
    assert_eq!(place(Kind::Linear, 3, &[[0.0; 2], [1.0; 2]]), "node 3 is unknown; allowed are nodes with coordinates");
    let coincident = "nodes 1 and 3 are at one place; allowed are different places";
    assert_eq!(place(Kind::Parabolic, 3, &[[0.0; 2], [1.0; 2], [0.0; 2]]), coincident);
    // Billions of nodes are not written out to find that one is unknown.
    let endless = SlideLine::generate(Kind::Linear, 1, u32::MAX, 1).unwrap();
    assert!(matches!(endless.place(&numbered(&[[0.0; 2]])), Err(Error::UnknownNode { node: 2 })));
}

#[test]
fn a_line_that_stands_still_or_folds_back_at_the_closest_point_is_rejected() {
    let there_and_back = numbered(&[[1.0, 0.0], [3.0, 0.0], [1.0, 0.0]]);
    let folded = line(Kind::Linear, 3, None).place(&there_and_back).unwrap();
    let message = folded.closest([4.0, 0.0].into()).unwrap_err().to_string();
    assert_eq!(message, "the slide line turns straight back at node 2; allowed is any other angle");
    assert!(folded.closest([2.0, 1.0].into()).is_ok(), "elsewhere it has a side");

    let smoothed = line(Kind::Linear, 3, Some(0.2)).place(&there_and_back).unwrap();
    assert!(matches!(smoothed.closest([4.0, 0.0].into()), Err(Error::NoTangent { coordinate: "t", .. })));
    let quarter_point = numbered(&[[0.0, 0.0], [0.25, 0.0], [1.0, 0.0]]);
    let still = line(Kind::Parabolic, 3, None).place(&quarter_point).unwrap();
    assert!(matches!(still.closest([0.0, 1.0].into()), Err(Error::NoTangent { coordinate: "g", value: -1.0 })));

    let message = still.closest([f64::NAN, 1.0].into()).unwrap_err().to_string();
    assert_eq!(message, "xs[0] is NaN; allowed is a finite number");
}

#[test]
fn generated_nodes_are_the_listed_ones() {
    let numbers = |first, last, increment| {
        SlideLine::generate(Kind::Linear, first, last, increment).unwrap().nodes().collect::<Vec<_>>()
    };
    assert_eq!(numbers(10, 40, 10), [10, 20, 30, 40]);
    assert_eq!(numbers(5, 1, -2), [5, 3, 1]);
    let places = [[1.0, 0.0], [2.0, 0.5], [3.0, 0.0]];
    let listed = SlideLine::new(Kind::Parabolic, [1, 2, 3]).unwrap().place(&numbered(&places)).unwrap();
    assert_eq!(listed.closest([2.0, 2.0].into()).unwrap(), closest(Kind::Parabolic, &places, None, [2.0, 2.0]));
}

// --- The closest point -----------------------------------------------------------------------------------------------

fn is(x: f64, y: f64) -> bool {
    (x - y).abs() < 1e-15
}

const ROOF: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]];

#[test]
fn the_place_is_a_segment_a_corner_a_node_or_past_an_end() {
    let on_roof = |xs| closest(Kind::Linear, &ROOF, None, xs);
    let slope = on_roof([0.0, 2.0]);
    assert_eq!(slope.place, Place::Segment { index: 0, g: 0.0 });
    assert!(is(slope.separation, 2.0_f64.sqrt()));
    let ridge = on_roof([2.0, 5.0]);
    assert_eq!((ridge.place, ridge.separation), (Place::Node { number: 2 }, 3.0));
    assert_eq!((ridge.normal.y, ridge.tangent.x), (1.0, 1.0));
    let on_the_ridge = on_roof([2.0, 2.0]);
    assert_eq!((on_the_ridge.place, on_the_ridge.separation), (Place::Node { number: 2 }, 0.0));
    assert_eq!((on_the_ridge.normal.x, on_the_ridge.normal.y), (0.0, 1.0));
    let eaves = on_roof([5.0, -1.0]);
    let Place::Beyond { number: 3, distance } = eaves.place else { panic!("{eaves:?}") };
    assert!(is(distance, 2.0_f64.sqrt()) && is(eaves.separation, 0.0));
    let at_the_eaves = on_roof([5.0, 1.0]);
    assert_eq!(at_the_eaves.place, Place::Segment { index: 1, g: 1.0 });

    let smoothed = closest(Kind::Linear, &ROOF, Some(0.25), [2.0, 5.0]);
    assert_eq!((smoothed.place, smoothed.separation), (Place::Corner { index: 0, t: 0.5 }, 3.25));
    assert_eq!(smoothed.weights.iter().map(|(node, _)| *node).collect::<Vec<_>>(), [1, 2, 3]);
}

#[test]
fn a_point_on_the_wrong_side_penetrates() {
    assert!(is(closest(Kind::Linear, &ROOF, None, [1.0, 0.0]).separation, -(0.5_f64.sqrt())));
    // The same line the other way round has the slave below.
    let back = [ROOF[2], ROOF[1], ROOF[0]];
    assert!(is(closest(Kind::Linear, &back, None, [1.0, 0.0]).separation, 0.5_f64.sqrt()));
    assert_eq!(closest(Kind::Linear, &back, None, [2.0, 5.0]).separation, -3.0);
}

#[test]
fn ties_go_to_the_smaller_segment() {
    // Under the ridge both slopes are equally near; above a valley too.
    let Place::Segment { index: 0, g } = closest(Kind::Linear, &ROOF, None, [2.0, 1.0]).place else { panic!() };
    assert!(is(g, 0.5));
    let valley = [[0.0, 3.0], [1.1, 1.0], [2.2, 3.0]];
    for z in [1.25, 1.7, 2.3, 2.9] {
        let Place::Segment { index: 0, .. } = closest(Kind::Linear, &valley, None, [1.1, z]).place else {
            panic!("{z}")
        };
        // A hair to the right of the medial axis it is the other one.
        let xs = [1.1 + 1e-12, z];
        let Place::Segment { index: 1, .. } = closest(Kind::Linear, &valley, None, xs).place else { panic!("{z}") };
    }
    // Within a parabola the smaller coordinate.
    let bowl = [[0.0, 4.0], [2.0, 0.0], [4.0, 4.0]];
    let Place::Segment { g, .. } = closest(Kind::Parabolic, &bowl, None, [2.0, 2.0]).place else { panic!() };
    assert!(g < 0.0, "{g}");
}

#[test]
fn a_far_line_is_not_looked_at() {
    let places: Vec<_> = (0..10_001).map(|k| [f64::from(k), 0.25 * f64::from(k % 3)]).collect();
    let placed = line(Kind::Linear, places.len(), None).place(&numbered(&places)).unwrap();
    for k in 0..1000 {
        let evaluated = placed.closest([10.0 * f64::from(k) + 0.3, 0.7].into()).unwrap().evaluated;
        assert!(evaluated <= 8, "{evaluated} of 10000 segments");
    }
}

/// Points of the whole line, close to each other: the curves as the formulas give them, cut where they are smoothed.
fn dense(kind: Kind, x: &[Vector2<f64>], smoothing: Option<f64>) -> Vec<Vector2<f64>> {
    const STEPS: u32 = 400;
    let share = |k: u32| f64::from(k) / f64::from(STEPS);
    let stride = if kind == Kind::Linear { 1 } else { 2 };
    let segments = (x.len() - 1) / stride;
    let cut = smoothing.map_or(0.0, |f| 2.0 * f);
    let mut points = Vec::new();
    for s in 0..segments {
        let from = -1.0 + if s > 0 { cut } else { 0.0 };
        let to = 1.0 - if s + 1 < segments { cut } else { 0.0 };
        let corner = smoothing.filter(|_| s + 1 < segments);
        for k in 0..=STEPS {
            let (g, t) = (from + (to - from) * share(k), share(k));
            let here = &x[s * stride..];
            points.push(match kind {
                Kind::Linear => LinearPoint::eval(&LinearPlace { x1: here[0], x2: here[1], g }).x,
                Kind::Parabolic => ParabolicPoint::eval(&ParabolicPlace { x1: here[0], x2: here[1], x3: here[2], g }).x,
            });
            points.extend(corner.map(|f| match (kind, here) {
                (Kind::Linear, &[x1, x2, x3, ..]) => {
                    SmoothedLinearPoint::eval(&LinearCornerPlace { x1, x2, x3, f, t }).x
                }
                (_, &[x1, x2, x3, x4, x5, ..]) => {
                    SmoothedParabolicPoint::eval(&ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t }).x
                }
                _ => unreachable!(),
            }));
        }
    }
    points
}

/// The point of the line that a closest point names.
fn foot(closest: &ClosestPoint, nodes: &Nodes) -> Vector2<f64> {
    match closest.place {
        Place::Beyond { number, .. } => nodes.position(number).unwrap(),
        _ => closest.weights.iter().map(|&(node, weight)| nodes.position(node).unwrap() * weight).sum(),
    }
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![0.0..8.0, (0..8).prop_map(f64::from)]
}

fn point() -> impl Strategy<Value = [f64; 2]> {
    [coordinate(), coordinate()]
}

/// Any double: of everyday size, of any size, or not finite.
fn any_double() -> impl Strategy<Value = f64> {
    prop_oneof![8 => coordinate(), 4 => 0.0..1e308, 2 => 0.0..1e-300, 1 => any::<f64>()]
}

fn smoothing() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), Just(Some(SlideLine::SMOOTHING)), (1e-2..0.49).prop_map(Some)]
}

/// Any line: random, nearly straight, or with midside nodes at the quarter points.
fn any_line() -> impl Strategy<Value = (Kind, Vec<[f64; 2]>, Option<f64>)> {
    let midside = prop_oneof![Just(None), Just(Some((0.5, 0.0))), Just(Some((0.5, 1e-8))), Just(Some((0.25, 1e-3)))];
    (any::<bool>(), proptest::collection::vec(point(), 2..8), midside, smoothing()).prop_map(
        |(parabolic, corners, midside, smoothing)| {
            if !parabolic {
                return (Kind::Linear, corners, smoothing);
            }
            let mut nodes = vec![corners[0]];
            for pair in corners.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(Vector2::from);
                let (along, across) = midside.unwrap_or((0.625, 0.25));
                let chord = b - a;
                let middle = a + chord * along + Vector2::new(-chord.y, chord.x) * across;
                nodes.extend([[middle.x.max(0.0), middle.y], pair[1]]);
            }
            (Kind::Parabolic, nodes, smoothing)
        },
    )
}

proptest! {
    #[test]
    fn the_closest_point_is_the_global_one((kind, places, smoothing) in any_line(), xs in point()) {
        let nodes = numbered(&places);
        let Ok(placed) = line(kind, places.len(), smoothing).place(&nodes) else { return Ok(()) };
        let Ok(closest) = placed.closest(xs.into()) else { return Ok(()) };
        let xs = Vector2::from(xs);
        let gap = xs - foot(&closest, &nodes);
        let x: Vec<_> = places.iter().copied().map(Vector2::from).collect();
        let best = dense(kind, &x, smoothing).into_iter().map(|x| (xs - x).norm()).fold(f64::INFINITY, f64::min);
        prop_assert!(gap.norm() <= best + 1e-12, "{} and {best}", gap.norm());
        // The foot is on the line: no farther from the nearest sample than samples are from each other.
        prop_assert!(gap.norm() >= best - 0.2, "{} and {best}", gap.norm());
        if !matches!(closest.place, Place::Beyond { .. }) {
            prop_assert!((closest.normal * closest.separation - gap).norm() < 1e-7, "{closest:?}");
        }
        let whole: f64 = closest.weights.iter().map(|(_, weight)| weight).sum();
        let terms: f64 = closest.weights.iter().map(|(_, weight)| weight.abs()).sum();
        prop_assert!((whole - 1.0).abs() <= 4.0 * f64::EPSILON * terms, "{closest:?}");
        prop_assert!((closest.normal.norm() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_line_reversed_is_as_near((kind, places, smoothing) in any_line(), xs in point()) {
        let back: Vec<_> = places.iter().rev().copied().collect();
        let distance = |places: &[[f64; 2]]| {
            let nodes = numbered(places);
            let closest = line(kind, places.len(), smoothing).place(&nodes)?.closest(xs.into())?;
            Ok::<_, Error>((Vector2::from(xs) - foot(&closest, &nodes)).norm())
        };
        let (Ok(there), Ok(back)) = (distance(&places), distance(&back)) else { return Ok(()) };
        prop_assert!((there - back).abs() < 1e-12, "{there} {back}");
    }

    #[test]
    fn the_variation_of_the_overclosure_is_its_derivative(
        (kind, places, smoothing) in any_line(),
        xs in point(),
        rates in proptest::collection::vec([-1.0..1.0, -1.0..1.0], 17),
    ) {
        let dual = |[x, y]: [f64; 2], [dx, dy]: [f64; 2]| [Dual64::new(x, dx), Dual64::new(y, dy)];
        let moving = places.iter().zip(&rates).zip(1..).map(|((&x, &rate), number)| (number, dual(x, rate)));
        let placed = line(kind, places.len(), smoothing).place(&Nodes::new(moving).unwrap());
        let Ok(closest) = placed.and_then(|placed| placed.closest(dual(xs, rates[16]).into())) else { return Ok(()) };
        let variation = closest.overclosure_variation();
        let real = |v: Vector2<Dual64>| v.map(|x| x.re);
        let slave = real(variation.slave).dot(&Vector2::from(rates[16]));
        let masters: f64 = variation.masters.iter().map(|&(node, gradient)| {
            real(gradient).dot(&Vector2::from(rates[node as usize - 1]))
        }).sum();
        let expected = -closest.separation.eps;
        prop_assert!((slave + masters - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{closest:?}");
    }

    #[test]
    fn no_input_makes_it_panic(
        parabolic: bool,
        places in proptest::collection::vec([any_double(), any_double()], 0..12),
        f in prop_oneof![Just(0.2), any_double()],
        smooth: bool,
        xs in [any_double(), any_double()],
    ) {
        let kind = if parabolic { Kind::Parabolic } else { Kind::Linear };
        let Ok(nodes) = Nodes::new((1..).zip(places.iter().copied())) else { return Ok(()) };
        let numbers: Vec<_> = (1..=u32::try_from(places.len()).unwrap()).collect();
        let line = SlideLine::new(kind, numbers).and_then(|line| if smooth { line.smoothed(f) } else { Ok(line) });
        let closest = line.and_then(|line| line.place(&nodes)?.closest(xs.into()));
        if let Ok(closest) = closest {
            prop_assert!(closest.separation.is_finite(), "{closest:?}");
        }
    }

    #[test]
    fn the_exact_separation_is_that_of_doubles((kind, places, smoothing) in any_line(), xs in point()) {
        let (nodes, line) = (numbered(&places), line(kind, places.len(), smoothing));
        let exact = line.place(&nodes.convert::<Octuple>());
        let exact = exact.and_then(|placed| placed.closest(Vector2::from(xs).map(Octuple::from)));
        let found = line.place(&nodes).and_then(|placed| placed.closest(xs.into()));
        let (Ok(found), Ok(exact)) = (found, exact) else { return Ok(()) };
        // How far the nodes' rounding can move it: past an end next to a quarter-point node the tangent hangs on little.
        let condition: f64 = found.weights.iter().map(|(_, weight)| 8.0 * weight.abs()).sum::<f64>() + 8.0;
        let error = found.separation - exact.separation.to_f64();
        prop_assert!(error.abs() < 4.0 * f64::EPSILON * condition, "{found:?} {exact:?}");
    }
}
