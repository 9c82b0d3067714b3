use super::*;
use crate::slide_line::{Nodes, SlideLine};
use proptest::prelude::*;

impl<D: Scalar> PlacedLine<D> {
    /// Without the index, in reverse.
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

    /// Segments much shorter than the slave point is far, where nearly all of the index is left out; and at the centre,
    /// where nothing may be.
    #[test]
    fn the_index_changes_nothing_on_a_fine_arc(
        segments in 50_usize..300,
        parabolic: bool,
        smoothing in smoothing(),
        turn in 0.1_f64..3.0,
        // Each is offered to hundreds of pieces.
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
