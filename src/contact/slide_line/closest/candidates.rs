//! The points of a curve that may be the closest one.

use super::expansion::Expansion;
use super::roots;
use super::view::View;
use crate::contact::slide_line::shape::Shape;
use crate::number::scalar::{Leaf, Scalar, Search, constant, leaf};
use arrayvec::ArrayVec;
use nalgebra::Vector2;

/// A point of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place<L> {
    /// An end, by its coordinate.
    End(L),
    /// A point between the ends, by its coordinate.
    Inside(L),
}

impl<L: Copy> Place<L> {
    pub(super) fn coordinate(self) -> L {
        match self {
            Self::End(u) | Self::Inside(u) => u,
        }
    }
}

/// The points of a curve where the distance has a minimum, in order, including ends.
pub(super) struct Candidates<L> {
    pub(super) expansion: Expansion<L>,
    pub(super) places: ArrayVec<Place<L>, 7>,
}

/// The input of the search: the curve between two coordinates, and (xs − X)·Y′ at both, which shows whether the distance
/// decreases.
///
/// This is evaluated with the full equation, and the search relies on it. So either an end is a candidate or, between ends
/// towards which the distance increases, a root is found, however close to an end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach<L> {
    pub(super) expansion: Expansion<L>,
    pub(super) ends: [L; 2],
    pub(super) residuals: [L; 2],
}

impl<L: Leaf> Reach<L> {
    pub(super) fn new<D: Scalar<Leaf = L>, S: Shape<N>, const N: usize>(view: &View<D, S, N>, ends: [L; 2]) -> Self {
        let residuals = ends.map(|u| leaf(view.at(constant(u)).residual()));
        Self { expansion: view.expansion(), ends, residuals }
    }

    pub(super) fn candidates(&self) -> Candidates<L> {
        let Self { expansion, ends, residuals: [low, high] } = *self;
        let mut places = ArrayVec::new();
        if low <= 0.0 {
            places.push(Place::End(ends[0]));
        }
        places.extend(roots::falling(&expansion.residual(), ends, [low, high]).into_iter().map(Place::Inside));
        // Also if nothing was found because a number overflowed: the result then shows it.
        if high >= 0.0 || places.is_empty() {
            places.push(Place::End(ends[1]));
        }
        Candidates { expansion, places }
    }

    /// The nearest point.
    pub(super) fn nearest(&self) -> Place<L> {
        let Expansion { gap, factor, y: [y1, y2, y3] } = self.expansion;
        let ([from, to], [low, high]) = (self.ends, self.residuals);
        let numbers = [gap.x, gap.y, factor, y1.x, y1.y, y2.x, y2.y, y3.x, y3.y, from, to, low, high];
        let u = L::find::<NearestPlace, 13>(numbers);
        if u < from {
            Place::End(from)
        } else if u > to {
            Place::End(to)
        } else {
            Place::Inside(u)
        }
    }
}

impl<L: Leaf> Candidates<L> {
    /// The nearest point; of two that are equally near, the one with the smaller coordinate.
    pub(super) fn nearest(&self) -> Place<L> {
        let is_nearer =
            |place: Place<L>, than: Place<L>| self.expansion.compare(place.coordinate(), than.coordinate()).is_lt();
        let nearer = |best, next| if is_nearer(next, best) { next } else { best };
        self.places.iter().copied().reduce(nearer).expect("where nothing else is, an end is")
    }
}

/// The search of [`Reach::nearest`]: it returns a number below the first coordinate for the first end, and above the last for the
/// last end.
struct NearestPlace;

impl Search<13> for NearestPlace {
    const NAME: &'static str = "nearest_place";

    fn find<L: Leaf>([gx, gy, factor, x1, y1, x2, y2, x3, y3, from, to, low, high]: [L; 13]) -> L {
        let y = [Vector2::new(x1, y1), Vector2::new(x2, y2), Vector2::new(x3, y3)];
        let expansion = Expansion { gap: Vector2::new(gx, gy), factor, y };
        let reach = Reach { expansion, ends: [from, to], residuals: [low, high] };
        match reach.candidates().nearest() {
            Place::Inside(u) => u,
            Place::End(u) if u == from => from - 1.0,
            Place::End(_) => to + 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The line (u, 0), with the slave point at (foot, 1).
    fn reach(foot: f64, residuals: [f64; 2]) -> Reach<f64> {
        let y = [Vector2::x(), Vector2::zeros(), Vector2::zeros()];
        let expansion = Expansion { gap: Vector2::new(foot, 1.0), factor: 1.0, y };
        Reach { expansion, ends: [-1.0, 1.0], residuals }
    }

    #[test]
    fn an_end_is_a_candidate_unless_the_distance_falls_from_it() {
        let places = |residuals| reach(0.25, residuals).candidates().places.to_vec();
        let [from, to, inside] = [Place::End(-1.0), Place::End(1.0), Place::Inside(0.25)];
        assert_eq!(places([1.25, -0.75]), [inside]);
        for (low, high) in [(-1.0, 1.0), (0.0, 1.0), (-1.0, 0.0), (0.0, 0.0)] {
            assert_eq!(places([low, high]), [from, to], "{low} {high}");
        }
        assert_eq!((places([1.0, 0.0]), places([0.0, -1.0]), places([-1.0, -1.0])), (vec![to], vec![from], vec![from]));
        assert_eq!(places([f64::NAN; 2]), [to]);
    }

    #[test]
    fn the_nearest_place_is_an_end_or_inside_and_of_equal_ones_the_first() {
        let nearest = |foot, residuals| reach(foot, residuals).nearest();
        assert_eq!(nearest(0.25, [1.25, -0.75]), Place::Inside(0.25));
        assert_eq!((nearest(-3.0, [-2.0, -4.0]), nearest(3.0, [4.0, 2.0])), (Place::End(-1.0), Place::End(1.0)));
        assert_eq!((nearest(0.0, [-1.0, 1.0]), nearest(0.5, [-1.0, 1.0])), (Place::End(-1.0), Place::End(1.0)));
    }
}
