//! A slide line where its nodes are: the closest point of the whole line.

use super::closest::{PieceFoot, curved_foot, straight_foot};
use super::shape::{self, LinearCorner, Parabola, ParabolicCorner, Shape};
use super::tree::{BLUR, Rectangle, Tree};
use super::{ClosestPoint, Kind, Place, left, length};
use super::{LinearMotion, LinearSlave, ParabolicMotion, SlipIncrementLinear, SlipIncrementParabolic};
use crate::Scalar;
use crate::error::Error;
use crate::formula::Formula;
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use std::ops::RangeInclusive;

/// A slide line where its nodes are, with a spatial index. Made by [`SlideLine::place`](super::SlideLine::place).
#[derive(Clone, Debug)]
pub struct PlacedLine<D = f64> {
    kind: Kind,
    smoothing: Option<f64>,
    numbers: Vec<u32>,
    nodes: Vec<Vector2<D>>,
    tree: Tree,
}

impl<D: Scalar> PlacedLine<D> {
    pub(super) fn new(
        kind: Kind,
        smoothing: Option<f64>,
        numbers: Vec<u32>,
        nodes: Vec<Vector2<D>>,
    ) -> Result<Self, Error> {
        let mut line = Self { kind, smoothing, numbers, nodes, tree: Tree::new(Vec::new()) };
        (0..line.segments()).try_for_each(|segment| line.check_segment(segment))?;
        line.tree = Tree::new((0..line.pieces()).map(|piece| line.bounds(piece)).collect());
        Ok(line)
    }

    /// The number of segments.
    pub fn segments(&self) -> usize {
        self.nodes.len().saturating_sub(1) / self.kind.stride()
    }

    /// Segments and smoothed corners, in order along the line.
    fn pieces(&self) -> usize {
        let corners = if self.smoothing.is_some() { self.segments() - 1 } else { 0 };
        self.segments() + corners
    }

    /// The segment of a piece, and whether the piece is the corner behind it.
    fn piece(&self, piece: usize) -> (usize, bool) {
        if self.smoothing.is_some() { (piece / 2, piece % 2 == 1) } else { (piece, false) }
    }

    /// The indices of the nodes of a segment, or of the two that meet at the corner behind it.
    fn range(&self, segment: usize, corner: bool) -> RangeInclusive<usize> {
        let (stride, reach) = (self.kind.stride(), if corner { 2 } else { 1 });
        segment * stride..=(segment + reach) * stride
    }

    fn check_segment(&self, segment: usize) -> Result<(), Error> {
        let range = self.range(segment, false);
        let at = |k: usize| self.nodes[k].map(|x| x.re());
        let mut pairs = range.clone().flat_map(|k| range.clone().skip_while(move |&j| j <= k).map(move |j| (k, j)));
        match pairs.find(|&(k, j)| at(k) == at(j)) {
            Some((k, j)) => Err(Error::CoincidentNodes { first: self.numbers[k], second: self.numbers[j] }),
            None => Ok(()),
        }
    }

    /// The part of a piece that counts: of a segment, what its smoothed corners leave of it.
    fn ends(&self, segment: usize, corner: bool) -> [f64; 2] {
        let cut = |at_corner: bool| 1.0 - self.smoothing.filter(|_| at_corner).map_or(0.0, |f| 2.0 * f);
        if corner { [0.0, 1.0] } else { [-cut(segment > 0), cut(segment + 1 < self.segments())] }
    }

    /// A box around the points that span a piece: the control points of its Bézier form.
    fn bounds(&self, piece: usize) -> Rectangle {
        let (segment, corner) = self.piece(piece);
        let nodes = self.nodes[self.range(segment, corner)].iter();
        let x: ArrayVec<Vector2<f64>, 5> = nodes.map(|x| x.map(|x| x.re())).collect();
        let f = self.smoothing.unwrap_or_default();
        match *x {
            [a, b, c] if corner => Rectangle::around(&[b + (a - b) * f, b, b + (c - b) * f]),
            [a, b, c] => Rectangle::around(&[a, b * 2.0 - (a + c) * 0.5, c]),
            [a, b, c, d, e] => {
                // A third of X′ leads to the inner control point, forwards at the start and backwards at the end.
                let nodes = [a, b, c, d, e];
                let controls = [(0.0, f / 3.0), (1.0, -f / 3.0)].map(|(t, third)| {
                    let end = -shape::gap(Vector2::zeros(), &nodes, ParabolicCorner::weights(f, t));
                    [end, end + shape::combination(&nodes, ParabolicCorner::rates(f, t)) * third]
                });
                Rectangle::around(controls.as_flattened())
            }
            _ => Rectangle::around(&x),
        }
    }

    /// The closest point of the whole line to a slave point in the plane (r, z).
    ///
    /// Of places that are equally near, up to the rounding of their distances, one between the ends of its segment or
    /// corner comes first, then that of the smaller segment index, then that of the smaller coordinate.
    ///
    /// # Errors
    /// A slave point that is not finite; [`Error::NoTangent`] or [`Error::FoldsBack`] where the line stands still or turns
    /// back at the closest point; [`Error::Overflow`].
    pub fn closest(&self, xs: Vector2<D>) -> Result<ClosestPoint<D>, Error> {
        Error::check_vector("xs", xs.map(|x| x.re()))?;
        let mut nearest = Nearest::new();
        let evaluated = self.tree.search(xs.map(|x| x.re()), |piece| self.offer(&mut nearest, piece, xs));
        self.settle(nearest, xs, evaluated)
    }

    /// How far a farther piece may be, up to rounding, to matter still.
    fn offer(&self, nearest: &mut Nearest<D>, piece: usize, xs: Vector2<D>) -> f64 {
        let foot = self.foot(piece, xs);
        let blur = self.tree.blur(piece, foot.distance);
        nearest.offer(piece, foot, blur)
    }

    fn foot(&self, piece: usize, xs: Vector2<D>) -> PieceFoot<D> {
        let (segment, corner) = self.piece(piece);
        let ends = self.ends(segment, corner);
        let f = self.smoothing.unwrap_or_default();
        match self.nodes[self.range(segment, corner)] {
            [x1, x2, x3, x4, x5] => curved_foot::<_, ParabolicCorner, 5>(xs, [x1, x2, x3, x4, x5], f, ends),
            [x1, x2, x3] if corner => curved_foot::<_, LinearCorner, 3>(xs, [x1, x2, x3], f, ends),
            [x1, x2, x3] => curved_foot::<_, Parabola, 3>(xs, [x1, x2, x3], f, ends),
            ref x => straight_foot(&LinearSlave { xs, x1: x[0], x2: x[1] }, ends),
        }
    }

    fn settle(&self, nearest: Nearest<D>, xs: Vector2<D>, evaluated: usize) -> Result<ClosestPoint<D>, Error> {
        let overflow = Error::Overflow { name: "separation" };
        let (piece, foot) = nearest.best().ok_or(overflow.clone())?;
        let (index, corner) = self.piece(piece);
        let coordinate = if corner { "t" } else { "g" };
        if foot.stands_still {
            return Err(Error::NoTangent { coordinate, value: foot.u.re() });
        }
        let range = self.range(index, corner);
        let at_start = foot.u < 0.0;
        let is_end = if at_start { index == 0 } else { index + 1 == self.segments() };
        let place = match (corner, foot.inside) {
            (true, _) => Place::Corner { index, t: foot.u },
            (false, false) if is_end && foot.beyond > 0.0 => {
                let node = if at_start { *range.start() } else { *range.end() };
                Place::Beyond { number: self.numbers[node], distance: foot.beyond }
            }
            (false, false) if !is_end && self.smoothing.is_none() => {
                return self.at_vertex(if at_start { index } else { index + 1 }, xs, evaluated);
            }
            _ => Place::Segment { index, g: foot.u },
        };
        let closest = ClosestPoint {
            place,
            tangent: foot.tangent,
            normal: left(foot.tangent),
            separation: foot.separation,
            first: *range.start(),
            weights: range.zip(foot.weights).map(|(k, weight)| (self.numbers[k], weight)).collect(),
            evaluated,
        };
        if closest.separation.re().is_finite() { Ok(closest) } else { Err(overflow) }
    }

    /// At the node where a segment begins and the one before it ends. The sign of the separation is that of the side on
    /// which the slave point lies of both together; at the node itself the normal halves the angle.
    fn at_vertex(&self, segment: usize, xs: Vector2<D>, evaluated: usize) -> Result<ClosestPoint<D>, Error> {
        let first = *self.range(segment, false).start();
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
            first,
            weights: std::iter::once((number, D::one())).collect(),
            evaluated,
        })
    }

    /// The unit tangent at an end of a segment.
    fn tangent(&self, segment: usize, end: f64) -> Result<Vector2<D>, Error> {
        let rate = match self.nodes[self.range(segment, false)] {
            [x1, x2, x3] => shape::combination(&[x1, x2, x3], shape::parabolic_rates(D::from(end))),
            [x1, x2] => x2 - x1,
            _ => Vector2::from_element(D::zero()),
        };
        let size = length(rate);
        if size > 0.0 { Ok(rate / size) } else { Err(Error::NoTangent { coordinate: "g", value: end }) }
    }

    /// The increment of E12 at a closest point: t·(Δxs − Σ Nᵢ Δxᵢ), positive in the sequence of the nodes.
    ///
    /// `dx` are the displacement increments of the nodes of [`ClosestPoint::weights`].
    pub fn slip_increment(&self, at: &ClosestPoint<D>, dxs: Vector2<D>, dx: &[Vector2<D>]) -> D {
        match (at.place, self.nodes.get(at.first..).unwrap_or_default(), dx) {
            (Place::Segment { g, .. }, &[x1, x2, x3, ..], &[dx1, dx2, dx3]) => {
                SlipIncrementParabolic::eval(&ParabolicMotion { x1, x2, x3, g, dxs, dx1, dx2, dx3 }).dslip
            }
            (Place::Segment { g, .. }, &[x1, x2, ..], &[dx1, dx2]) => {
                SlipIncrementLinear::eval(&LinearMotion { x1, x2, g, dxs, dx1, dx2 }).dslip
            }
            // On smoothed corners and at nodes it is the same sum over other nodes.
            _ => at.tangent.dot(&at.relative_motion(dxs, dx)),
        }
    }
}

/// The places that may be nearest, as far as rounding tells.
struct Nearest<D> {
    /// A distance that the nearest does not exceed.
    reach: f64,
    /// Pieces, their feet, and the least that their distances can be.
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

    /// By the rule for ties; the order of the offers does not matter.
    fn best(self) -> Option<(usize, PieceFoot<D>)> {
        let ranked = self.tied.into_iter().min_by_key(|(piece, foot, _)| (!foot.inside, *piece));
        ranked.map(|(piece, foot, _)| (piece, foot))
    }
}

#[cfg(test)]
mod tests;
