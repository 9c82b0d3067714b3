//! A curve in powers of its coordinate, for the search of the foot.

use crate::number::scalar::{Leaf, abs};
use nalgebra::Vector2;
use std::cmp::Ordering;

/// xs − X(0), c, and the coefficients of u, u², u³ in Y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expansion<D> {
    pub(super) gap: Vector2<D>,
    pub(super) factor: D,
    pub(super) y: [Vector2<D>; 3],
}

impl<D: Leaf> Expansion<D> {
    /// The coefficients of (xs − X)·Y′.
    pub(super) fn residual(&self) -> [D; 6] {
        let Self { gap, factor, y: [y1, y2, y3] } = *self;
        [
            gap.dot(&y1),
            gap.dot(&y2) * 2.0 - factor * y1.dot(&y1),
            (gap.dot(&y3) - factor * y1.dot(&y2)) * 3.0,
            -(factor * (y1.dot(&y3) * 2.0 + y2.dot(&y2)) * 2.0),
            -(factor * y2.dot(&y3) * 5.0),
            -(factor * y3.dot(&y3) * 3.0),
        ]
    }

    pub(super) fn y_at(&self, u: D) -> Vector2<D> {
        let [y1, y2, y3] = self.y;
        ((y3 * u + y2) * u + y1) * u
    }

    /// Compares the distance at u with that at v, both being minima; equal if rounding hides which is smaller.
    pub(super) fn compare(&self, u: D, v: D) -> Ordering {
        // |G_u|² − |G_v|² = (G_u − G_v)·(G_u + G_v)
        let [reach_u, reach_v] = [u, v].map(|u| self.y_at(u) * self.factor);
        let (step, twice) = (reach_v - reach_u, self.gap * D::from(2.0));
        let excess = step.dot(&(twice - (reach_u + reach_v)));
        let size = |v: Vector2<D>| v.map(abs);
        let blur = size(step).dot(&(size(twice) + size(reach_u) + size(reach_v))) * (16.0 * D::EPSILON);
        if excess < -blur {
            Ordering::Less
        } else if excess > blur {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_residual_is_the_gap_along_the_rate_as_a_polynomial() {
        let [gap, y1, y2, y3] = [[1.0, 2.0], [3.0, -1.0], [2.0, 5.0], [-1.0, 4.0]].map(Vector2::from);
        let expansion = Expansion { gap, factor: 0.5, y: [y1, y2, y3] };
        for u in [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, 0.5_f64] {
            let y = y1 * u + y2 * (u * u) + y3 * (u * u * u);
            assert_eq!(expansion.y_at(u), y);
            let rate = y1 + y2 * (2.0 * u) + y3 * (3.0 * u * u);
            let residual = expansion.residual().iter().rev().fold(0.0, |sum, c| sum * u + c);
            assert_eq!(residual, (gap - y * 0.5).dot(&rate), "{u}");
        }
    }

    /// On the line (2u, 0) scaled by ½, from `gap`: u and v are equally far if their mean is the foot.
    #[test]
    fn distances_that_are_equal_but_for_rounding_compare_as_equal_whatever_is_large() {
        let compare = |gap: f64, u: f64, v: f64| {
            let y = [Vector2::new(2.0, 0.0), Vector2::zeros(), Vector2::zeros()];
            // Also with the axes exchanged.
            let turned = Expansion { gap: Vector2::new(0.5, gap), factor: 0.5, y: y.map(|y| y.yx()) };
            let found = Expansion { gap: Vector2::new(gap, 0.5), factor: 0.5, y }.compare(u, v);
            assert_eq!(turned.compare(u, v), found);
            assert_eq!(turned.compare(v, u), found.reverse());
            found
        };
        let a_little = 4.0 * f64::EPSILON;
        // Reaches of either sign and no gap; a gap and one reach only; a large gap.
        for (gap, u, v) in [(0.0, -1.0, 1.0), (1.0, 0.0, 2.0), (-1.0, 0.0, -2.0), (8.0, 7.0, 9.0)] {
            assert_eq!(compare(gap, u, v), Ordering::Equal);
            for size in [1.0 - a_little, 1.0 + a_little] {
                assert_eq!(compare(gap, u, v * size), Ordering::Equal, "{gap} {u} {v} {size}");
            }
            let [nearer, farther] = [1.0 - 1e-12, 1.0 + 1e-12].map(|size| compare(gap, u, gap + (v - gap) * size));
            assert_eq!([nearer, farther], [Ordering::Greater, Ordering::Less], "{gap} {u} {v}");
            assert_eq!(compare(gap, u, u), Ordering::Equal);
        }
    }
}
