//! A slide line at the positions of its nodes: the closest point of the whole line.

use super::interpolation::Interpolation;
use super::place::{ClosestPoint, Foot, Place};
use super::tree::{BLUR, OrientedBox, Tree};
use crate::Scalar;
use crate::contact::slide_line::closest::{PieceFoot, curved_foot, straight_foot};
use crate::contact::slide_line::shape::{self, LinearCorner, Parabola, ParabolicCorner, Shape};
use crate::contact::slide_line::{LinearSlave, left, length};
use crate::formula::error::Error;
use nalgebra::Vector2;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// A slide line at the positions of its nodes, with a spatial index. Created by [`SlideLine::place`](super::SlideLine::place).
#[derive(Clone, Debug)]
pub struct PlacedLine<D = f64> {
    pub(super) interpolation: Interpolation,
    smoothing: Option<f64>,
    /// The fraction of an end segment by which the line is extended.
    extension: f64,
    numbers: Arc<[u32]>,
    nodes: Vec<Vector2<D>>,
    tree: Tree,
}

/// A piece of a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Piece {
    /// A segment, by its index.
    Segment(usize),
    /// The corner after a segment, smoothed over this fraction.
    Corner(usize, f64),
}

impl Piece {
    pub(super) fn is_corner(self) -> bool {
        matches!(self, Self::Corner(..))
    }
}

impl<D: Scalar> PlacedLine<D> {
    /// A line of at least one whole segment, as ensured by [`SlideLine`](super::SlideLine).
    pub(super) fn new(
        interpolation: Interpolation,
        smoothing: Option<f64>,
        extension: f64,
        numbers: Arc<[u32]>,
        nodes: Vec<Vector2<D>>,
    ) -> Result<Self, Error> {
        let is_open = numbers.first() != numbers.last();
        let extension = if is_open { extension } else { 0.0 };
        let mut line = Self { interpolation, smoothing, extension, numbers, nodes, tree: Tree::new(Vec::new()) };
        (0..line.segments()).try_for_each(|segment| line.check_segment(segment))?;
        line.tree = Tree::new((0..line.pieces()).map(|piece| line.bounds(line.piece(piece))).collect());
        Ok(line)
    }

    /// The number of segments.
    pub fn segments(&self) -> usize {
        (self.nodes.len() - 1) / self.interpolation.stride()
    }

    /// The number of segments and smoothed corners, in order along the line.
    fn pieces(&self) -> usize {
        let corners = if self.smoothing.is_some() { self.segments() - 1 } else { 0 };
        self.segments() + corners
    }

    pub(super) fn piece(&self, index: usize) -> Piece {
        match self.smoothing {
            None => Piece::Segment(index),
            Some(f) if index % 2 == 1 => Piece::Corner(index / 2, f),
            Some(_) => Piece::Segment(index / 2),
        }
    }

    /// The indices of the nodes of a segment, or of the two that meet at the corner after it.
    fn range(&self, piece: Piece) -> RangeInclusive<usize> {
        let (first, segments) = match piece {
            Piece::Segment(segment) => (segment, 1),
            Piece::Corner(segment, _) => (segment, 2),
        };
        let stride = self.interpolation.stride();
        first * stride..=(first + segments) * stride
    }

    /// The nodes of a piece that has N of them.
    pub(super) fn nodes_of<const N: usize>(&self, piece: Piece) -> [Vector2<D>; N] {
        let nodes = self.nodes[self.range(piece)].try_into();
        nodes.expect("the interpolation and the piece tell how many nodes there are")
    }

    /// The distance between the ends of the segment of a closest point.
    #[cfg(feature = "scene")]
    pub(crate) fn segment_length(&self, closest: &ClosestPoint<D>) -> D {
        let (Piece::Segment(index) | Piece::Corner(index, _)) = self.piece(closest.foot.piece);
        let range = self.range(Piece::Segment(index));
        length(self.nodes[*range.end()] - self.nodes[*range.start()])
    }

    fn check_segment(&self, segment: usize) -> Result<(), Error> {
        let range = self.range(Piece::Segment(segment));
        let at = |k: usize| self.nodes[k].map(|x| x.re());
        let mut pairs = range.clone().flat_map(|k| range.clone().skip_while(move |&j| j <= k).map(move |j| (k, j)));
        match pairs.find(|&(k, j)| at(k) == at(j)) {
            Some((k, j)) => Err(Error::CoincidentNodes { first: self.numbers[k], second: self.numbers[j] }),
            None => Ok(()),
        }
    }

    /// The part of a piece that belongs to the line: for a segment, the part between its smoothed corners.
    pub(super) fn ends(&self, piece: Piece) -> [f64; 2] {
        let Piece::Segment(segment) = piece else { return [0.0, 1.0] };
        let end = |at_corner: bool| match self.smoothing {
            Some(f) if at_corner => 1.0 - 2.0 * f,
            _ => 1.0,
        };
        [-end(segment > 0), end(segment + 1 < self.segments())]
    }

    /// A box around the control points of the Bézier form of a piece, which enclose it.
    fn bounds(&self, piece: Piece) -> OrientedBox {
        let leaves = |x: Vector2<D>| x.map(|x| x.re());
        match (self.interpolation, piece) {
            (Interpolation::Linear, Piece::Segment(_)) => OrientedBox::around(&self.nodes_of::<2>(piece).map(leaves)),
            (Interpolation::Linear, Piece::Corner(_, f)) => {
                let [a, b, c] = self.nodes_of::<3>(piece).map(leaves);
                OrientedBox::around(&[b + (a - b) * f, b, b + (c - b) * f])
            }
            (Interpolation::Parabolic, Piece::Segment(_)) => {
                let [a, b, c] = self.nodes_of::<3>(piece).map(leaves);
                OrientedBox::around(&[a, b * 2.0 - (a + c) * 0.5, c])
            }
            (Interpolation::Parabolic, Piece::Corner(_, f)) => {
                // A third of X′ leads to the inner control point, forwards at the start and backwards at the end.
                let nodes = self.nodes_of::<5>(piece).map(leaves);
                let [[first, second], [fourth, third]] = [(0.0, f / 3.0), (1.0, -f / 3.0)].map(|(t, third)| {
                    let end = -shape::gap(Vector2::zeros(), &nodes, ParabolicCorner::weights(f, t));
                    [end, end + shape::combination(&nodes, ParabolicCorner::rates(f, t)) * third]
                });
                OrientedBox::around(&[first, second, third, fourth])
            }
        }
    }

    /// The closest point of the whole line to a slave point in the plane (r, z).
    ///
    /// If several points are equally near, to within the rounding of their distances, one between the ends of its segment or
    /// corner comes first, then that of the smaller segment index, then that of the smaller coordinate.
    ///
    /// # Errors
    /// A slave point that is not finite; [`Error::NoTangent`] or [`Error::FoldsBack`] if the line's derivative vanishes or the
    /// line folds back at the closest point; [`Error::Overflow`].
    pub fn closest(&self, xs: Vector2<D>) -> Result<ClosestPoint<D>, Error> {
        Error::check_vector("xs", xs.map(|x| x.re()))?;
        let mut nearest = Nearest::new();
        let evaluated = self.tree.search(xs.map(|x| x.re()), |piece| self.offer(&mut nearest, piece, xs));
        self.settle(nearest, xs, evaluated)
    }

    /// The distance up to which, with rounding, a farther piece still matters.
    fn offer(&self, nearest: &mut Nearest<D>, piece: usize, xs: Vector2<D>) -> f64 {
        let foot = self.foot(self.piece(piece), xs);
        let blur = self.tree.blur(piece, foot.distance);
        nearest.offer(piece, foot, blur)
    }

    fn foot(&self, piece: Piece, xs: Vector2<D>) -> PieceFoot<D> {
        let ends = self.ends(piece);
        match (self.interpolation, piece) {
            (Interpolation::Linear, Piece::Segment(_)) => {
                let [x1, x2] = self.nodes_of(piece);
                straight_foot(&LinearSlave { xs, x1, x2 }, ends)
            }
            (Interpolation::Linear, Piece::Corner(_, f)) => {
                curved_foot::<_, LinearCorner, 3>(xs, self.nodes_of(piece), f, ends)
            }
            // A segment has no smoothing fraction; its shape ignores it.
            (Interpolation::Parabolic, Piece::Segment(_)) => {
                curved_foot::<_, Parabola, 3>(xs, self.nodes_of(piece), 0.0, ends)
            }
            (Interpolation::Parabolic, Piece::Corner(_, f)) => {
                curved_foot::<_, ParabolicCorner, 5>(xs, self.nodes_of(piece), f, ends)
            }
        }
    }

    fn settle(&self, nearest: Nearest<D>, xs: Vector2<D>, evaluated: usize) -> Result<ClosestPoint<D>, Error> {
        let overflow = Error::Overflow { name: "separation" };
        let (number, foot) = nearest.best().ok_or(overflow.clone())?;
        let piece = self.piece(number);
        let (Piece::Segment(index) | Piece::Corner(index, _)) = piece;
        let coordinate = if piece.is_corner() { "t" } else { "g" };
        if foot.stands_still {
            return Err(Error::NoTangent { coordinate, value: foot.u.re() });
        }
        let range = self.range(piece);
        let at_start = foot.u < 0.0;
        let is_end = if at_start { index == 0 } else { index + 1 == self.segments() };
        let place = match (piece.is_corner(), foot.inside) {
            (true, _) => Place::Corner { index, t: foot.u },
            (false, false) if is_end && foot.beyond > 0.0 => {
                let number = self.numbers[if at_start { *range.start() } else { *range.end() }];
                let distance = foot.beyond;
                let extended = self.path_length_within(Piece::Segment(index), -D::one(), D::one()) * self.extension;
                if distance <= extended {
                    Place::Extension { number, distance }
                } else {
                    Place::Beyond { number, distance }
                }
            }
            (false, false) if !is_end && self.smoothing.is_none() => {
                return self.at_vertex(if at_start { index } else { index + 1 }, xs, evaluated);
            }
            _ => Place::Segment { index, g: foot.u },
        };
        let beyond = match place {
            Place::Extension { distance, .. } | Place::Beyond { distance, .. } if at_start => -distance,
            Place::Extension { distance, .. } | Place::Beyond { distance, .. } => distance,
            _ => D::zero(),
        };
        let closest = ClosestPoint {
            place,
            tangent: foot.tangent,
            normal: left(foot.tangent),
            separation: foot.separation,
            foot: Foot { piece: number, u: foot.u, beyond },
            weights: range.zip(foot.weights).map(|(k, weight)| (self.numbers[k], weight)).collect(),
            evaluated,
        };
        if closest.separation.re().is_finite() { Ok(closest) } else { Err(overflow) }
    }

    /// The closest point at the node between a segment and the one before it. The sign of the separation is determined by the
    /// side of both segments together on which the slave point lies; at the node itself the normal bisects the angle.
    fn at_vertex(&self, segment: usize, xs: Vector2<D>, evaluated: usize) -> Result<ClosestPoint<D>, Error> {
        let first = *self.range(Piece::Segment(segment)).start();
        let number = self.numbers[first];
        let middle = left(self.tangent(segment - 1, 1.0)? + self.tangent(segment, -1.0)?);
        if middle.iter().all(|x| x.re().abs() <= BLUR) {
            return Err(Error::FoldsBack { node: number });
        }
        let gap = xs - self.nodes[first];
        let side = if middle.dot(&gap) < 0.0 { -D::one() } else { D::one() };
        let distance = length(gap);
        let (normal, separation) = if distance > 0.0 {
            (gap * (side / distance), distance * side)
        } else {
            let normal = middle / length(middle);
            (normal, normal.dot(&gap))
        };
        Ok(ClosestPoint {
            place: Place::Node { number },
            tangent: -left(normal),
            normal,
            separation,
            foot: Foot { piece: segment, u: -D::one(), beyond: D::zero() },
            weights: std::iter::once((number, D::one())).collect(),
            evaluated,
        })
    }

    /// The unit tangent at an end of a segment.
    fn tangent(&self, segment: usize, end: f64) -> Result<Vector2<D>, Error> {
        let piece = Piece::Segment(segment);
        let rate = match self.interpolation {
            Interpolation::Parabolic => shape::combination(&self.nodes_of(piece), shape::parabolic_rates(D::from(end))),
            Interpolation::Linear => {
                let [x1, x2] = self.nodes_of(piece);
                x2 - x1
            }
        };
        let size = length(rate);
        if size > 0.0 { Ok(rate / size) } else { Err(Error::NoTangent { coordinate: "g", value: end }) }
    }
}

/// The points that may be nearest, to within rounding errors.
struct Nearest<D> {
    /// An upper bound of the distance of the nearest.
    reach: f64,
    /// Pieces, their feet, and lower bounds of their distances.
    tied: Vec<(usize, PieceFoot<D>, f64)>,
}

impl<D: Scalar> Nearest<D> {
    fn new() -> Self {
        Self { reach: f64::INFINITY, tied: Vec::new() }
    }

    fn offer(&mut self, piece: usize, foot: PieceFoot<D>, blur: f64) -> f64 {
        let (least, most) = (foot.distance - blur, foot.distance + blur);
        if most < self.reach {
            self.reach = most;
            self.tied.retain(|&(.., least)| least <= most);
        }
        if least <= self.reach {
            self.tied.push((piece, foot, least));
        }
        self.reach
    }

    /// The best one by the rule for ties, whatever the order of the offers.
    fn best(self) -> Option<(usize, PieceFoot<D>)> {
        let ranked = self.tied.into_iter().min_by_key(|(piece, foot, _)| (!foot.inside, *piece));
        ranked.map(|(piece, foot, _)| (piece, foot))
    }
}

#[cfg(test)]
pub(super) mod tests;
