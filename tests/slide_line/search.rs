//! The closest point of whole lines against a dense search, derivatives, exact arithmetic and any input at all.

use super::{line, numbered};
use jointproof::contact::slide_line::{
    ClosestPoint, Interpolation, LinearCornerPlace, LinearPlace, LinearPoint, Nodes, ParabolicCornerPlace,
    ParabolicPlace, ParabolicPoint, Place, SlideLine, SmoothedLinearPoint, SmoothedParabolicPoint,
};
use jointproof::formula::Formula;
use jointproof::{Error, Octuple};
use nalgebra::Vector2;
use num_dual::Dual64;
use proptest::prelude::*;

/// Points of the whole line, close to each other: the curves as the formulas give them, cut where they are smoothed.
fn dense(kind: Interpolation, x: &[Vector2<f64>], smoothing: Option<f64>) -> Vec<Vector2<f64>> {
    const STEPS: u32 = 400;
    let share = |k: u32| f64::from(k) / f64::from(STEPS);
    let stride = if kind == Interpolation::Linear { 1 } else { 2 };
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
                Interpolation::Linear => LinearPoint::eval(&LinearPlace { x1: here[0], x2: here[1], g }).x,
                Interpolation::Parabolic => {
                    ParabolicPoint::eval(&ParabolicPlace { x1: here[0], x2: here[1], x3: here[2], g }).x
                }
            });
            points.extend(corner.map(|f| match (kind, here) {
                (Interpolation::Linear, &[x1, x2, x3, ..]) => {
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
        Place::Extension { number, .. } | Place::Beyond { number, .. } => nodes.position(number).unwrap(),
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
    prop_oneof![Just(None), Just(Some(0.2)), (1e-2..0.49).prop_map(Some)]
}

/// Any line: random, nearly straight, or with midside nodes at the quarter points.
fn any_line() -> impl Strategy<Value = (Interpolation, Vec<[f64; 2]>, Option<f64>)> {
    let midside = prop_oneof![Just(None), Just(Some((0.5, 0.0))), Just(Some((0.5, 1e-8))), Just(Some((0.25, 1e-3)))];
    (any::<bool>(), proptest::collection::vec(point(), 2..8), midside, smoothing()).prop_map(
        |(parabolic, corners, midside, smoothing)| {
            if !parabolic {
                return (Interpolation::Linear, corners, smoothing);
            }
            let mut nodes = vec![corners[0]];
            for pair in corners.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(Vector2::from);
                let (along, across) = midside.unwrap_or((0.625, 0.25));
                let chord = b - a;
                let middle = a + chord * along + Vector2::new(-chord.y, chord.x) * across;
                nodes.extend([[middle.x.max(0.0), middle.y], pair[1]]);
            }
            (Interpolation::Parabolic, nodes, smoothing)
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
        if !matches!(closest.place, Place::Extension { .. } | Place::Beyond { .. }) {
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
        let kind = if parabolic { Interpolation::Parabolic } else { Interpolation::Linear };
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
        // Of two places that doubles cannot tell apart, the exact arithmetic may find the other one nearer.
        if (found.tangent - exact.tangent.map(Octuple::to_f64)).norm() > 1e-6 {
            return Ok(());
        }
        // How far the nodes' rounding can move it: past an end next to a quarter-point node the tangent hangs on little.
        let condition: f64 = found.weights.iter().map(|(_, weight)| 8.0 * weight.abs()).sum::<f64>() + 8.0;
        let error = found.separation - exact.separation.to_f64();
        prop_assert!(error.abs() < 4.0 * f64::EPSILON * condition, "{found:?} {exact:?}");
    }
}
