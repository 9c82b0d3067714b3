//! Slide lines and the elements on them as a program uses them, and what they reject.

#![expect(clippy::float_cmp, reason = "exact results are expected exactly")]

mod search;

use jointproof::Error;
use jointproof::contact::slide_line::{ClosestPoint, Interpolation, Nodes, Place, SlideLine};

/// Nodes numbered from 1.
fn numbered(places: &[[f64; 2]]) -> Nodes {
    Nodes::new((1..).zip(places.iter().copied())).unwrap()
}

fn line(kind: Interpolation, count: usize, smoothing: Option<f64>) -> SlideLine {
    let line = SlideLine::generate(kind, 1, u32::try_from(count).unwrap(), 1).unwrap();
    smoothing.map_or(line.clone(), |f| line.smoothed(f).unwrap())
}

fn closest(kind: Interpolation, places: &[[f64; 2]], smoothing: Option<f64>, xs: [f64; 2]) -> ClosestPoint {
    line(kind, places.len(), smoothing).place(&numbered(places)).unwrap().closest(xs.into()).unwrap()
}

// --- Topology and rejected input -------------------------------------------------------------------------------------

#[test]
fn bad_lines_are_named() {
    let message = |result: Result<SlideLine, Error>| result.unwrap_err().to_string();
    let odd = "an odd number of nodes, at least 3, in a parabolic slide line";
    for (count, nodes) in [(0, vec![]), (1, vec![1]), (2, vec![1, 2]), (4, vec![1, 2, 3, 4])] {
        let expected = format!("{count} nodes are given; allowed is {odd}");
        assert_eq!(message(SlideLine::new(Interpolation::Parabolic, nodes)), expected);
    }
    for one in [SlideLine::new(Interpolation::Linear, [7]), SlideLine::generate(Interpolation::Linear, 7, 7, 1)] {
        assert_eq!(message(one), "1 nodes are given; allowed is at least 2 nodes in a linear slide line");
    }
    assert_eq!(
        message(SlideLine::generate(Interpolation::Parabolic, 1, 4, 1)),
        format!("4 nodes are given; allowed is {odd}")
    );
    for (first, last, increment) in [(1, 9, 0), (1, 9, -2), (9, 1, 2), (1, 9, 3), (1, 1, 0), (1, 9, i64::MIN)] {
        assert_eq!(
            message(SlideLine::generate(Interpolation::Linear, first, last, increment)),
            format!(
                "increment {increment} does not lead from node {first} to node {last}; \
                 allowed is a divisor of {last} - {first} with its sign"
            )
        );
    }
    let straight = || SlideLine::new(Interpolation::Linear, [1, 2]).unwrap();
    for (f, shown) in [(0.5, "0.5"), (-0.2, "-0.2"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        assert_eq!(message(straight().smoothed(f)), format!("f is {shown}; allowed is a number ≥ 0 and < 0.5"));
    }
    assert_eq!(straight().smoothed(0.0), Ok(straight()));
    for (fraction, shown) in [(-0.1, "-0.1"), (0.21, "0.21"), (f64::NAN, "NaN")] {
        let expected = format!("extension_zone is {shown}; allowed is a number ≥ 0 and ≤ 0.2");
        assert_eq!(message(straight().extended(fraction)), expected);
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
    assert_eq!(
        place(Interpolation::Linear, 3, &[[0.0; 2], [1.0; 2]]),
        "node 3 is unknown; allowed are nodes with coordinates"
    );
    let coincident = "nodes 1 and 3 coincide; allowed are different positions";
    assert_eq!(place(Interpolation::Parabolic, 3, &[[0.0; 2], [1.0; 2], [0.0; 2]]), coincident);
    // Billions of nodes are not expanded only to find that one is unknown.
    let endless = SlideLine::generate(Interpolation::Linear, 1, u32::MAX, 1).unwrap();
    assert!(matches!(endless.place(&numbered(&[[0.0; 2]])), Err(Error::UnknownNode { node: 2 })));
}

#[test]
fn a_line_that_stands_still_or_folds_back_at_the_closest_point_is_rejected() {
    let there_and_back = numbered(&[[1.0, 0.0], [3.0, 0.0], [1.0, 0.0]]);
    let folded = line(Interpolation::Linear, 3, None).place(&there_and_back).unwrap();
    let message = folded.closest([4.0, 0.0].into()).unwrap_err().to_string();
    assert_eq!(message, "the slide line turns straight back at node 2; allowed is any other angle");
    assert!(folded.closest([2.0, 1.0].into()).is_ok(), "elsewhere it has a side");

    let smoothed = line(Interpolation::Linear, 3, Some(0.2)).place(&there_and_back).unwrap();
    assert!(matches!(smoothed.closest([4.0, 0.0].into()), Err(Error::NoTangent { coordinate: "t", .. })));
    let quarter_point = numbered(&[[0.0, 0.0], [0.25, 0.0], [1.0, 0.0]]);
    let still = line(Interpolation::Parabolic, 3, None).place(&quarter_point).unwrap();
    assert!(matches!(still.closest([0.0, 1.0].into()), Err(Error::NoTangent { coordinate: "g", value: -1.0 })));

    let message = still.closest([f64::NAN, 1.0].into()).unwrap_err().to_string();
    assert_eq!(message, "xs[0] is NaN; allowed is a finite number");
}

#[test]
fn generated_nodes_are_the_listed_ones() {
    let numbers = |first, last, increment| {
        SlideLine::generate(Interpolation::Linear, first, last, increment).unwrap().nodes().collect::<Vec<_>>()
    };
    assert_eq!(numbers(10, 40, 10), [10, 20, 30, 40]);
    assert_eq!(numbers(5, 1, -2), [5, 3, 1]);
    let places = [[1.0, 0.0], [2.0, 0.5], [3.0, 0.0]];
    let listed = SlideLine::new(Interpolation::Parabolic, [1, 2, 3]).unwrap().place(&numbered(&places)).unwrap();
    assert_eq!(
        listed.closest([2.0, 2.0].into()).unwrap(),
        closest(Interpolation::Parabolic, &places, None, [2.0, 2.0])
    );
}

// --- The closest point -----------------------------------------------------------------------------------------------

fn is(x: f64, y: f64) -> bool {
    (x - y).abs() < 1e-15
}

const ROOF: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]];

#[test]
fn the_place_is_a_segment_a_corner_a_node_or_past_an_end() {
    let on_roof = |xs| closest(Interpolation::Linear, &ROOF, None, xs);
    let slope = on_roof([0.0, 2.0]);
    let Place::Segment { index: 0, g } = slope.place else { panic!("{slope:?}") };
    assert!(is(g, 0.0) && is(slope.separation, 2.0_f64.sqrt()));
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

    let smoothed = closest(Interpolation::Linear, &ROOF, Some(0.25), [2.0, 5.0]);
    assert_eq!((smoothed.place, smoothed.separation), (Place::Corner { index: 0, t: 0.5 }, 3.25));
    assert_eq!(smoothed.weights.iter().map(|(node, _)| *node).collect::<Vec<_>>(), [1, 2, 3]);
}

/// The fraction is of the length of the end segment, however it is curved and whatever a smoothed corner takes of it.
#[test]
fn an_open_line_is_extended_by_a_part_of_its_end_segments() {
    let places = [[1.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 3.0], [4.0, 6.0]];
    for (kind, smoothing, length) in [
        (Interpolation::Linear, None, 1.0),
        (Interpolation::Linear, Some(0.25), 1.0),
        // The midside node is off the middle, the segment straight.
        (Interpolation::Parabolic, None, 3.0),
    ] {
        let by = |fraction: f64, r: f64| {
            let line = line(kind, places.len(), smoothing).extended(fraction).unwrap();
            line.place(&numbered(&places)).unwrap().closest([r, 0.5].into()).unwrap().place
        };
        for (fraction, distance, extended) in
            [(0.1, 0.0625, true), (0.1, 0.5, false), (0.2, 0.1875, true), (0.0, 1e-9, false)]
        {
            let place = by(fraction, 1.0 - distance * length);
            let (Place::Extension { number: 1, distance: found } | Place::Beyond { number: 1, distance: found }) =
                place
            else {
                panic!("{kind:?}: {place:?}")
            };
            assert!(is(found, 1.0 - (1.0 - distance * length)), "{kind:?}: {found}");
            assert_eq!(
                matches!(place, Place::Extension { .. }),
                extended,
                "{kind:?} {smoothing:?} {fraction} {distance}"
            );
        }
    }
}

/// A line whose last node is its first has no end to extend.
#[test]
fn a_closed_line_is_not_extended() {
    let nodes = numbered(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0]]);
    let place = |numbers: &[u32]| {
        let line = SlideLine::new(Interpolation::Linear, numbers).unwrap();
        line.place(&nodes).unwrap().closest([0.96875, -0.5].into()).unwrap().place
    };
    assert_eq!(place(&[1, 2, 3]), Place::Extension { number: 1, distance: 0.03125 });
    assert_eq!(place(&[1, 2, 3, 1]), Place::Beyond { number: 1, distance: 0.03125 });
}

#[test]
fn a_point_on_the_wrong_side_penetrates() {
    assert!(is(closest(Interpolation::Linear, &ROOF, None, [1.0, 0.0]).separation, -(0.5_f64.sqrt())));
    // The reversed line has the slave below it.
    let back = [ROOF[2], ROOF[1], ROOF[0]];
    assert!(is(closest(Interpolation::Linear, &back, None, [1.0, 0.0]).separation, 0.5_f64.sqrt()));
    assert_eq!(closest(Interpolation::Linear, &back, None, [2.0, 5.0]).separation, -3.0);
}

#[test]
fn ties_go_to_the_smaller_segment() {
    // Below the ridge both slopes are equally near; likewise above a valley.
    let Place::Segment { index: 0, g } = closest(Interpolation::Linear, &ROOF, None, [2.0, 1.0]).place else {
        panic!()
    };
    assert!(is(g, 0.5));
    let valley = [[0.0, 3.0], [1.1, 1.0], [2.2, 3.0]];
    for z in [1.25, 1.7, 2.3, 2.9] {
        let Place::Segment { index: 0, .. } = closest(Interpolation::Linear, &valley, None, [1.1, z]).place else {
            panic!("{z}")
        };
        // Slightly to the right of the medial axis it is the other one.
        let xs = [1.1 + 1e-12, z];
        let Place::Segment { index: 1, .. } = closest(Interpolation::Linear, &valley, None, xs).place else {
            panic!("{z}")
        };
    }
    // Within a parabola it is the smaller coordinate.
    let bowl = [[0.0, 4.0], [2.0, 0.0], [4.0, 4.0]];
    let Place::Segment { g, .. } = closest(Interpolation::Parabolic, &bowl, None, [2.0, 2.0]).place else { panic!() };
    assert!(g < 0.0, "{g}");
}

#[test]
fn a_far_line_is_not_looked_at() {
    let places: Vec<_> = (0..10_001).map(|k| [f64::from(k), 0.25 * f64::from(k % 3)]).collect();
    let placed = line(Interpolation::Linear, places.len(), None).place(&numbered(&places)).unwrap();
    for k in 0..1000 {
        let evaluated = placed.closest([10.0 * f64::from(k) + 0.3, 0.7].into()).unwrap().evaluated;
        assert!(evaluated <= 8, "{evaluated} of 10000 segments");
    }
}
