//! The spatial index of a slide line: a tree of bounding boxes.
//!
//! The pieces of a line are in order along it, so neighbours are close to each other and the tree needs no sorting: the
//! box over boxes 2k and 2k+1 of one level is box k of the next. A search descends into the nearer box first and leaves
//! out every box that is farther than the best place found. For a slave point much nearer to the line than the line is
//! long, the cost grows like the logarithm of the number of pieces; at a point from which all of the line is equally far,
//! as the centre of an arc, all of it must be looked at.

use crate::scalar::norm;
use nalgebra::Vector2;

/// The rounding of a distance, as a part of the distance and of the size of what it is measured from.
pub(super) const BLUR: f64 = 16.0 * f64::EPSILON;

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rectangle {
    low: Vector2<f64>,
    high: Vector2<f64>,
}

impl Rectangle {
    /// Around points that are known up to rounding.
    pub(super) fn around(points: &[Vector2<f64>]) -> Self {
        let empty = Self { low: Vector2::repeat(f64::INFINITY), high: Vector2::repeat(f64::NEG_INFINITY) };
        let exact = points.iter().fold(empty, |all, point| all.with(&Self { low: *point, high: *point }));
        let margin = Vector2::repeat(exact.low.amax().max(exact.high.amax()) * BLUR);
        Self { low: exact.low - margin, high: exact.high + margin }
    }

    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    /// The rounding of a distance from it, as far as it comes from its size.
    fn blur(&self) -> f64 {
        (self.high * BLUR - self.low * BLUR).sum()
    }

    /// No more than the distance of a point from any piece inside, even after rounding by [`BLUR`].
    fn bound(&self, x: Vector2<f64>) -> f64 {
        let outside = (self.low - x).sup(&(x - self.high)).map(|d| d.max(0.0));
        norm([outside.x, outside.y]) * (1.0 - 2.0 * BLUR) - 2.0 * self.blur()
    }
}

/// The boxes, level by level, those of single pieces first.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    levels: Vec<Vec<Rectangle>>,
}

impl Tree {
    /// Over pieces in order.
    pub(super) fn new(pieces: Vec<Rectangle>) -> Self {
        let mut levels = vec![pieces];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let union = |pair: &[Rectangle]| pair.iter().skip(1).fold(pair[0], |all, next| all.with(next));
            let above = level.chunks(2).map(union).collect();
            levels.push(above);
        }
        Self { levels }
    }

    /// The rounding of a distance from a piece.
    pub(super) fn blur(&self, piece: usize, distance: f64) -> f64 {
        self.levels[0][piece].blur() + distance * BLUR
    }

    /// Calls `visit` for pieces, nearer ones first, and leaves out those that are surely farther than the distance that
    /// `visit` last returned. Returns how many were visited.
    pub(super) fn search(&self, x: Vector2<f64>, mut visit: impl FnMut(usize) -> f64) -> usize {
        let (mut reach, mut visited) = (f64::INFINITY, 0);
        let top = self.levels.len() - 1;
        // At most two entries per level.
        let mut todo = Vec::with_capacity(2 * self.levels.len());
        todo.push((f64::NEG_INFINITY, top, 0));
        while let Some((bound, level, index)) = todo.pop() {
            if bound > reach {
                continue;
            }
            let Some(below) = level.checked_sub(1) else {
                reach = visit(index);
                visited += 1;
                continue;
            };
            let child = |k: usize| self.levels[below].get(k).map(|rectangle| (rectangle.bound(x), below, k));
            match (child(2 * index), child(2 * index + 1)) {
                (Some(first), Some(second)) if second.0 < first.0 => todo.extend([first, second]),
                (first, second) => todo.extend([second, first].into_iter().flatten()),
            }
        }
        visited
    }
}
