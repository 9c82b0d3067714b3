use super::*;
use crate::contact::slide_line::{Nodes, SlideLine};
use proptest::prelude::*;

impl<D: Scalar> PlacedLine<D> {
    /// The closest point without the index, in reverse order.
    fn closest_of_all(&self, xs: Vector2<D>) -> Result<ClosestPoint<D>, Error> {
        Error::check_vector("xs", xs.map(|x| x.re()))?;
        let mut nearest = Nearest::new();
        for piece in (0..self.pieces()).rev() {
            self.offer(&mut nearest, piece, xs);
        }
        self.settle(nearest, xs, 0)
    }
}

/// A grid makes ties, right angles, straight corners and reversals common.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![0.0..8.0, (0..8).prop_map(f64::from)]
}

fn smoothing() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), Just(Some(0.2)), (1e-3..0.4999).prop_map(Some), Just(Some(0.5_f64.next_down()))]
}

proptest! {
    #[test]
    fn the_index_changes_nothing(
        segments in 1_usize..40,
        parabolic: bool,
        smoothing in smoothing(),
        places in proptest::collection::vec((coordinate(), coordinate()), 81),
        slaves in proptest::collection::vec((coordinate(), coordinate()), 20),
        offset in prop_oneof![Just(0.0), Just(1e8)],
    ) {
        let kind = if parabolic { Interpolation::Parabolic } else { Interpolation::Linear };
        let count = segments * kind.stride() + 1;
        let nodes = places.iter().zip(1..).map(|(&(r, z), number)| (number, [r + offset, z - offset]));
        let nodes = Nodes::new(nodes).unwrap();
        let line = SlideLine::generate(kind, 1, u32::try_from(count).unwrap(), 1).unwrap();
        let line = match smoothing { Some(f) => line.smoothed(f).unwrap(), None => line };
        let Ok(placed) = line.place(&nodes) else { return Ok(()) };
        for (r, z) in slaves {
            let xs = Vector2::new(r + offset, z - offset);
            let brute = placed.closest_of_all(xs);
            let indexed = placed.closest(xs).map(|closest| ClosestPoint { evaluated: 0, ..closest });
            prop_assert_eq!(indexed, brute);
        }
    }

    /// Segments much shorter than the distance of the slave point, where nearly all of the index is skipped; and a slave point at
    /// the centre, where nothing may be skipped.
    #[test]
    fn the_index_changes_nothing_on_a_fine_arc(
        segments in 50_usize..300,
        parabolic: bool,
        smoothing in smoothing(),
        turn in 0.1_f64..3.0,
        // Each slave point is compared with hundreds of pieces.
        slaves in proptest::collection::vec((0.0_f64..1.2, prop_oneof![0.0_f64..2.0, Just(0.0), Just(1.0)]), 3),
    ) {
        let kind = if parabolic { Interpolation::Parabolic } else { Interpolation::Linear };
        let count = u32::try_from(segments * kind.stride() + 1).unwrap();
        let at = |share: f64, radius: f64| {
            let (sine, cosine) = (turn * share).sin_cos();
            [2.0 - radius * cosine, radius * sine]
        };
        let nodes = Nodes::new((1..=count).map(|k| (k, at(f64::from(k - 1) / f64::from(count - 1), 1.0)))).unwrap();
        let line = SlideLine::generate(kind, 1, count, 1).unwrap();
        let line = match smoothing { Some(f) => line.smoothed(f).unwrap(), None => line };
        let placed = line.place(&nodes).unwrap();
        for (share, radius) in slaves {
            let xs = Vector2::from(at(share, radius));
            let indexed = placed.closest(xs).map(|closest| ClosestPoint { evaluated: 0, ..closest });
            prop_assert_eq!(indexed, placed.closest_of_all(xs));
        }
    }
}

#[test]
fn of_places_that_are_equally_near_all_are_kept() {
    let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [2.0, 0.0]), (3, [3.0, 0.0])]).unwrap();
    let placed = SlideLine::new(Interpolation::Linear, [1, 2, 3]).unwrap().place(&nodes).unwrap();
    let mut nearest = Nearest::new();
    for piece in [1, 0] {
        let foot = placed.foot(placed.piece(piece), Vector2::new(2.0, 1.0));
        assert_eq!(nearest.offer(piece, foot, 0.0), 1.0);
    }
    assert_eq!(nearest.best().map(|(piece, _)| piece), Some(0));
}

/// The line through nodes at these positions, smoothed if requested.
pub(in crate::contact::slide_line::line) fn placed(
    kind: Interpolation,
    smoothing: Option<f64>,
    places: &[[f64; 2]],
) -> PlacedLine {
    let nodes = Nodes::new((1..).zip(places.iter().copied())).unwrap();
    let line = SlideLine::new(kind, (1..).take(places.len()).collect::<Vec<_>>()).unwrap();
    let line = match smoothing {
        Some(f) => line.smoothed(f).unwrap(),
        None => line,
    };
    line.place(&nodes).unwrap()
}

/// Control points calculated by hand; all numbers are exact.
#[test]
fn a_box_is_around_the_control_points_of_its_piece() {
    let points = [[0.0, 0.0], [16.0, 8.0], [32.0, 0.0], [48.0, -8.0], [64.0, 32.0]];
    let sum =
        |weights: &[f64]| -> Vector2<f64> { points.iter().zip(weights).map(|(&x, &w)| Vector2::from(x) * w).sum() };
    let straight = placed(Interpolation::Linear, Some(0.25), &points);
    assert_eq!(straight.bounds(Piece::Segment(1)), OrientedBox::around(&[sum(&[0.0, 1.0]), sum(&[0.0, 0.0, 1.0])]));
    let corner = [sum(&[0.25, 0.75]), sum(&[0.0, 1.0]), sum(&[0.0, 0.75, 0.25])];
    assert_eq!(straight.bounds(straight.piece(1)), OrientedBox::around(&corner));
    let curved = placed(Interpolation::Parabolic, Some(0.375), &points);
    let parabola = [sum(&[1.0]), sum(&[-0.5, 2.0, -0.5]), sum(&[0.0, 0.0, 1.0])];
    assert_eq!(curved.bounds(Piece::Segment(0)), OrientedBox::around(&parabola));
    // From g = 1/4 on the one to g = −1/4 on the other, where dg/dt is 3/2.
    let ends = [sum(&[-0.093_75, 0.937_5, 0.156_25]), sum(&[0.0, 0.0, 0.156_25, 0.937_5, -0.093_75])];
    let [to_first, to_last] = [sum(&[-0.125, -0.25, 0.375]), sum(&[0.0, 0.0, 0.375, -0.25, -0.125])];
    let corner = [ends[0], ends[0] + to_first, ends[1] + to_last, ends[1]];
    assert_eq!(curved.bounds(curved.piece(1)), OrientedBox::around(&corner));
}

#[test]
fn at_a_node_the_side_is_that_of_both_segments() {
    let at =
        |places: &[[f64; 2]], xs: [f64; 2]| placed(Interpolation::Linear, None, places).closest(xs.into()).unwrap();
    let hill = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-15, "{found} and not {expected}");
    for (xs, separation, [x, y]) in [
        ([1.0, 1.25], 0.25, [0.0, 1.0]),
        ([1.15, 1.2], 0.25, [0.6, 0.8]),
        ([1.0, 3.0], 2.0, [0.0, 1.0]),
        ([1.0, 1.0], 0.0, [0.0, 1.0]),
    ] {
        let closest = at(&hill, xs);
        assert_eq!(closest.place, Place::Node { number: 2 });
        close(closest.separation, separation);
        close(closest.normal.x, x);
        close(closest.normal.y, y);
        close(closest.tangent.x, y);
        close(closest.tangent.y, -x);
        assert_eq!(closest.foot, Foot { piece: 1, u: -1.0, beyond: 0.0 });
        assert_eq!(closest.weights.as_slice(), [(2, 1.0)]);
    }
    // In the reverse direction the outside is the right-hand side, and no component of the normals is positive.
    let closest = at(&[[4.0, 0.0], [2.0, 2.0], [0.0, 2.0]], [2.15, 2.2]);
    assert_eq!(closest.place, Place::Node { number: 2 });
    close(closest.separation, -0.25);
    close(closest.normal.x, -0.6);
    close(closest.normal.y, -0.8);
}

/// The second parabola has its midside node at the quarter point, so that its derivative vanishes at its start.
#[test]
fn where_the_next_segment_stands_still_a_node_has_no_normal() {
    let places = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 4.0]];
    let placed = placed(Interpolation::Parabolic, None, &places);
    let standing = Error::NoTangent { coordinate: "g", value: -1.0 };
    assert_eq!(placed.tangent(1, -1.0).unwrap_err(), standing);
    assert_eq!(placed.tangent(0, 1.0).unwrap(), Vector2::x());
    assert_eq!(placed.tangent(1, 1.0).unwrap(), Vector2::y());
    assert_eq!(placed.closest([3.0, -1.0].into()).unwrap_err(), standing);
}

#[test]
fn past_either_end_the_way_goes_on_and_a_corner_takes_its_part_of_the_segments() {
    let line = placed(Interpolation::Linear, Some(0.25), &[[1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [4.0, 0.0]]);
    assert_eq!((line.segments(), line.pieces()), (3, 5));
    let ends: Vec<_> = (0..5).map(|k| line.ends(line.piece(k))).collect();
    assert_eq!(ends, [[-1.0, 0.5], [0.0, 1.0], [-0.5, 0.5], [0.0, 1.0], [-0.5, 1.0]]);
    let before = line.closest([0.5, 1.0].into()).unwrap();
    assert_eq!(before.place, Place::Beyond { number: 1, distance: 0.5 });
    assert_eq!(before.foot, Foot { piece: 0, u: -1.0, beyond: -0.5 });
    let behind = line.closest([5.5, 1.0].into()).unwrap();
    assert_eq!(behind.place, Place::Beyond { number: 4, distance: 1.5 });
    assert_eq!(behind.foot, Foot { piece: 4, u: 1.0, beyond: 1.5 });
    assert_eq!(
        (line.slip(&before, &behind), line.slip(&behind, &before), line.slip(&before, &before)),
        (5.0, -5.0, 0.0)
    );
    assert_eq!(PlacedLine::passed(&before.foot, &behind.foot), 5);
}
