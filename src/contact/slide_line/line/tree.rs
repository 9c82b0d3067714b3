//! The spatial index of a slide line: a tree of oriented boxes.
//!
//! The pieces of a line are ordered along it, so neighbours are close to each other and the tree needs no sorting: the box over
//! boxes 2k and 2k+1 of one level is box k of the next. It is aligned with the line from one centre to the other, and so it is
//! the thinner the straighter the line is there: a part of length s and radius of curvature R is s²/8R thick, which is less than
//! the growth of the distance from a slave point along that part, if that point is nearer than half of R. A search descends into
//! the nearer box first and skips every box that is farther than the nearest point found. For such a slave point it examines the
//! few pieces next to the foot, and a number of boxes proportional to the logarithm of the number of pieces; for a point equally
//! far from all of the line, such as the centre of an arc, it must examine everything.

use crate::number::scalar::norm;
use nalgebra::Vector2;

/// The rounding error of a distance, relative to the distance and to the size of the object from which it is measured.
pub(super) const BLUR: f64 = 16.0 * f64::EPSILON;

/// Vectors shorter than this have too few digits for a direction.
const SHORTEST: f64 = 1e-290;

/// A rectangle of any orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OrientedBox {
    center: Vector2<f64>,
    /// The direction of its first side, of length 1.
    along: Vector2<f64>,
    /// Half of its sides.
    half: Vector2<f64>,
}

impl OrientedBox {
    const EVERYWHERE: Self = Self {
        center: Vector2::new(0.0, 0.0),
        along: Vector2::new(1.0, 0.0),
        half: Vector2::new(f64::INFINITY, f64::INFINITY),
    };

    /// A box around points that are known to within rounding errors, aligned with the line from the first to the last.
    pub(super) fn around<const N: usize>(points: &[Vector2<f64>; N]) -> Self {
        Self::directed(points[N - 1] - points[0], points).unwrap_or_else(|| Self::aligned(points))
    }

    fn with(&self, next: &Self) -> Self {
        let corners = [self, next].map(Self::corners);
        Self::directed(next.center - self.center, corners.as_flattened()).unwrap_or(Self::EVERYWHERE)
    }

    /// For points whose differences overflow: a box computed without differences, aligned with the axes.
    fn aligned(points: &[Vector2<f64>]) -> Self {
        let from = points[0] * 0.5;
        let [low, high] = points.iter().map(|x| x * 0.5).fold([from; 2], |[low, high], x| [low.inf(&x), high.sup(&x)]);
        Self { center: low + high, along: Vector2::x(), half: high - low }.with_margin()
    }

    /// `None` if a number overflows.
    fn directed(direction: Vector2<f64>, points: &[Vector2<f64>]) -> Option<Self> {
        let length = norm([direction.x, direction.y]);
        let along = if (SHORTEST..f64::INFINITY).contains(&length) { direction / length } else { Vector2::x() };
        let from = points[0];
        let mut extent = Some([Vector2::zeros(); 2]);
        for x in points {
            let x = components(x - from, along);
            let finite = x.iter().all(|x| x.is_finite());
            extent = extent.filter(|_| finite).map(|[low, high]| [low.inf(&x), high.sup(&x)]);
        }
        let [low, high] = extent?;
        let middle = (low + high) * 0.5;
        let center = from + along * middle.x + Vector2::new(-along.y, along.x) * middle.y;
        Some(Self { center, along, half: (high - low) * 0.5 }.with_margin())
    }

    /// The box widened by the rounding errors of its construction.
    fn with_margin(self) -> Self {
        let margin = (self.center.amax() + self.half.amax()) * BLUR;
        Self { half: self.half.add_scalar(margin), ..self }
    }

    fn corners(&self) -> [Vector2<f64>; 4] {
        let along = self.along * self.half.x;
        let across = Vector2::new(-self.along.y, self.along.x) * self.half.y;
        [-along - across, -along + across, along - across, along + across].map(|corner| self.center + corner)
    }

    /// The part of the rounding error of a distance from it that is due to its size.
    fn blur(&self) -> f64 {
        (self.half * (2.0 * BLUR)).sum()
    }

    /// A lower bound of the distance of a point from any piece inside, even after rounding by [`BLUR`].
    fn bound(&self, x: Vector2<f64>) -> f64 {
        let outside = (components(x - self.center, self.along).abs() - self.half).map(|d| d.max(0.0));
        norm([outside.x, outside.y]) * (1.0 - 2.0 * BLUR) - 2.0 * self.blur()
    }
}

/// The components along a direction and normal to it.
fn components(x: Vector2<f64>, along: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(along.dot(&x), along.perp(&x))
}

/// The boxes, level by level, those of single pieces first.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    levels: Vec<Vec<OrientedBox>>,
}

impl Tree {
    /// Builds the tree over pieces in order.
    pub(super) fn new(pieces: Vec<OrientedBox>) -> Self {
        let mut levels = vec![pieces];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let union = |pair: &[OrientedBox]| pair.iter().skip(1).fold(pair[0], |all, next| all.with(next));
            let above = level.chunks(2).map(union).collect();
            levels.push(above);
        }
        Self { levels }
    }

    /// The rounding error of a distance from a piece.
    pub(super) fn blur(&self, piece: usize, distance: f64) -> f64 {
        self.levels[0][piece].blur() + distance * BLUR
    }

    /// Calls `visit` for pieces, nearer ones first, and skips those that are certainly farther than the distance that `visit`
    /// last returned. Returns how many were visited.
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
            let child = |k: usize| self.levels[below].get(k).map(|inside| (inside.bound(x), below, k));
            match (child(2 * index), child(2 * index + 1)) {
                (Some(first), Some(second)) if second.0 < first.0 => todo.extend([first, second]),
                (first, second) => todo.extend([second, first].into_iter().flatten()),
            }
        }
        visited
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_near(found: Vector2<f64>, x: f64, y: f64) {
        assert!((found - Vector2::new(x, y)).amax() < 1e-13, "{found} and not ({x}, {y})");
    }

    #[test]
    fn a_box_lies_along_the_way_from_the_first_point_to_the_last() {
        // 5 along (0.6, 0.8); the second point is in the middle and 1 to the left.
        let OrientedBox { center, along, half } =
            OrientedBox::around(&[Vector2::new(1.0, 1.0), Vector2::new(1.7, 3.6), Vector2::new(4.0, 5.0)]);
        is_near(along, 0.6, 0.8);
        is_near(center, 2.1, 3.3);
        is_near(half, 2.5, 0.5);
        let there_and_back =
            OrientedBox::around(&[Vector2::new(1.0, 1.0), Vector2::new(3.0, 2.0), Vector2::new(1.0, 1.0)]);
        assert_eq!(there_and_back.along, Vector2::x());
        is_near(there_and_back.half, 1.0, 0.5);
    }

    #[test]
    fn a_box_is_wider_than_its_points_by_the_rounding_of_its_place_and_of_its_size() {
        let found = OrientedBox::around(&[Vector2::new(10.0, 0.0), Vector2::new(12.0, 2.0), Vector2::new(14.0, 0.0)]);
        assert_eq!((found.center, found.along), (Vector2::new(12.0, 1.0), Vector2::x()));
        assert_eq!(found.half, Vector2::new(2.0 + 14.0 * BLUR, 1.0 + 14.0 * BLUR));
    }

    /// A square box, and one that is rotated: each corner of it is the farthest in some direction.
    #[test]
    fn a_box_over_two_has_the_corners_of_both() {
        let upright = OrientedBox { center: Vector2::zeros(), along: Vector2::x(), half: Vector2::new(1.0, 1.0) };
        let turned = OrientedBox {
            center: Vector2::new(10.0, 0.0),
            along: Vector2::new(0.6, 0.8),
            half: Vector2::new(2.0, 1.0),
        };
        let both = upright.with(&turned);
        is_near(both.along, 1.0, 0.0);
        is_near(both.center, 5.5, 0.0);
        is_near(both.half, 6.5, 2.2);
        let back = turned.with(&upright);
        is_near(back.along, -1.0, 0.0);
        is_near(back.center, 5.5, 0.0);
        is_near(back.half, 6.5, 2.2);
    }

    #[test]
    fn a_bound_is_below_the_distance_by_its_rounding_and_by_that_of_the_box() {
        let inside = OrientedBox { center: Vector2::new(1.0, 2.0), along: Vector2::y(), half: Vector2::new(3.0, 1.0) };
        let blur = 8.0 * BLUR;
        assert_eq!(inside.blur(), blur);
        // The first side is upright: the points are 3 and 4 beyond a corner, on either side; then next to a side, and inside.
        for (x, y, distance) in
            [(6.0, 8.0, 5.0), (-4.0, -4.0, 5.0), (6.0, -4.0, 5.0), (1.5, 8.0, 3.0), (-4.0, 2.5, 4.0), (1.5, 2.5, 0.0)]
        {
            let below = distance - inside.bound(Vector2::new(x, y));
            assert!(
                (below - (2.0 * distance * BLUR + 2.0 * blur)).abs() <= 8.0 * f64::EPSILON,
                "({x}, {y}): {below:e}"
            );
        }
        let tree = Tree::new(vec![OrientedBox::EVERYWHERE, inside]);
        assert_eq!(tree.blur(1, 2.0), blur + 2.0 * BLUR);
    }

    #[test]
    fn each_level_has_half_as_many_boxes_as_that_below() {
        let at = |x: f64| OrientedBox::around(&[Vector2::new(x, 0.0), Vector2::new(x + 1.0, 0.0)]);
        let sizes = |count: u32| {
            let tree = Tree::new((0..count).map(|x| at(f64::from(x))).collect());
            tree.levels.iter().map(Vec::len).collect::<Vec<_>>()
        };
        assert_eq!((sizes(1), sizes(2), sizes(5)), (vec![1], vec![2, 1], vec![5, 3, 2, 1]));
    }

    #[test]
    fn nearer_boxes_are_visited_first_and_of_equal_ones_the_first() {
        let at = |x: f64| OrientedBox::around(&[Vector2::new(x, 0.0), Vector2::new(x + 1.0, 0.0)]);
        let visited = |x: f64, boxes: &[f64], reach: f64| {
            let mut order = Vec::new();
            let tree = Tree::new(boxes.iter().map(|&x| at(x)).collect());
            let count = tree.search(Vector2::new(x, 1.0), |piece| {
                order.push(piece);
                reach
            });
            assert_eq!(count, order.len());
            order
        };
        assert_eq!(visited(0.5, &[0.0, 0.0, 0.0, 0.0, 0.0], f64::INFINITY), [0, 1, 2, 3, 4]);
        assert_eq!(visited(4.5, &[0.0, 1.0, 2.0, 3.0, 4.0], f64::INFINITY), [4, 3, 2, 1, 0]);
        assert_eq!(visited(2.5, &[0.0, 1.0, 2.0, 3.0, 4.0], 1.0), [2]);
    }

    #[test]
    fn a_box_around_points_whose_difference_overflows_is_no_larger_than_they_need() {
        let points = [Vector2::new(1.5e308, 4e307), Vector2::new(-1.0e308, 1.2e308), Vector2::new(5e307, -2e307)];
        let OrientedBox { center, along, half } = OrientedBox::around(&points);
        assert_eq!(along, Vector2::x());
        for (center, half, [low, high]) in
            [(center.x, half.x, [-1.0e308, 1.5e308]), (center.y, half.y, [-2e307, 1.2e308])]
        {
            let [below, above] = [low - (center - half), (center + half) - high];
            assert!(below >= 0.0 && above >= 0.0, "{low:e} to {high:e} in {center:e} ± {half:e}");
            assert!(below.max(above) <= 1e-14 * 1.5e308, "{low:e} to {high:e} in {center:e} ± {half:e}");
        }
    }
}
