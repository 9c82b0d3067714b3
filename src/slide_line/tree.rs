//! The spatial index of a slide line: a tree of bounding boxes.
//!
//! The pieces of a line are in order along it, so neighbours are close to each other and the tree needs no sorting: the
//! box over pieces 2k and 2k+1 is box k of the next level. A search descends into the nearer box first and leaves out
//! every box that is farther than the best place found. For a slave point much nearer to the line than the line is long,
//! the cost grows like the logarithm of the number of pieces; at a point from which all of the line is equally far, as
//! the centre of an arc, all of it must be looked at.

use crate::scalar::norm;
use nalgebra::Vector2;

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rectangle {
    low: Vector2<f64>,
    high: Vector2<f64>,
}

impl Rectangle {
    /// Around points.
    pub(super) fn around(points: &[Vector2<f64>]) -> Self {
        let empty = Self { low: Vector2::repeat(f64::INFINITY), high: Vector2::repeat(f64::NEG_INFINITY) };
        points.iter().fold(empty, |all, point| all.with(&Self { low: *point, high: *point }))
    }

    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    /// No more than the distance of a point from anything inside.
    fn distance(&self, x: Vector2<f64>) -> f64 {
        let outside = (self.low - x).sup(&(x - self.high)).map(|d| d.max(0.0));
        norm([outside.x, outside.y]) * (1.0 - 4.0 * f64::EPSILON)
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
            let pair = |pair: &[Rectangle]| pair.iter().skip(1).fold(pair[0], |all, next| all.with(next));
            levels.push(level.chunks(2).map(pair).collect());
        }
        Self { levels }
    }

    /// Calls `visit` for pieces, nearer ones first, until no other can be as near as the smallest distance that it
    /// returned; an error ends the search.
    pub(super) fn search<E>(
        &self,
        x: Vector2<f64>,
        mut visit: impl FnMut(usize) -> Result<f64, E>,
    ) -> Result<(), E> {
        let mut nearest = f64::INFINITY;
        // At most two entries per level.
        let mut todo = Vec::with_capacity(2 * self.levels.len());
        if let Some(top) = self.levels.len().checked_sub(1) {
            todo.push((0.0, top, 0));
        }
        while let Some((bound, level, index)) = todo.pop() {
            if bound > nearest {
                continue;
            }
            let Some(below) = level.checked_sub(1) else {
                nearest = nearest.min(visit(index)?);
                continue;
            };
            let child = |k: usize| self.levels[below].get(k).map(|rectangle| (rectangle.distance(x), below, k));
            match (child(2 * index), child(2 * index + 1)) {
                (Some(first), Some(second)) if second.0 < first.0 => todo.extend([first, second]),
                (first, second) => todo.extend([second, first].into_iter().flatten()),
            }
        }
        Ok(())
    }
}
