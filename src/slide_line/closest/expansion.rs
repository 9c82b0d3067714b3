//! A curve in powers of its coordinate, for the search of the foot.

use crate::scalar::{Leaf, abs};
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

    /// How the distance at u compares with that at v, both being minima; equal where rounding hides which is less.
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
