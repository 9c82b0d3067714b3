//! A slide line where its nodes are: the closest point of the whole line.

use super::closest::{Foot, View};
use super::line::Kind;
use super::shape::{self, LinearCorner, Parabola, ParabolicCorner, Shape};
use super::tree::{Rectangle, Tree};
use super::{LinearSlave, left, length};
use crate::error::Error;
use arrayvec::ArrayVec;
use nalgebra::Vector2;

/// Where on a slide line a point is closest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// On a segment, counted from 0, at its coordinate g from −1 to 1.
    Segment {
        /// Which segment.
        index: usize,
        /// Where on it.
        g: f64,
    },
    /// On the smoothed corner behind a segment, at its coordinate t from 0 to 1.
    Corner {
        /// The segment before the corner.
        index: usize,
        /// Where on the corner.
        t: f64,
    },
    /// At a node between two segments: a corner that is not smoothed and points to the slave point.
    Node {
        /// Its number.
        number: u32,
    },
}

/// The closest point of a slide line to a slave point, and how the separation varies.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosestPoint {
    /// Where it is.
    pub place: Place,
    /// How far the slave point is past an end of the line, along the tangent there; 0 elsewhere. The line is taken to go
    /// on straight.
    pub beyond: f64,
    /// The unit tangent, in the sequence of the nodes.
    pub tangent: Vector2<f64>,
    /// The unit normal, towards the slave. At a node it points to or from the slave point.
    pub normal: Vector2<f64>,
    /// The separation E11, positive when open.
    pub separation: f64,
    /// The nodes that carry the place, with their weights, which add up to 1.
    pub weights: ArrayVec<(u32, f64), 5>,
    /// How many segments and corners were looked at to find it.
    pub evaluated: usize,
}

impl ClosestPoint {
    /// The first variation of the overclosure h = −E11: its gradient with respect to the slave point, −n, and with respect
    /// to the nodes, Nᵢ n.
    ///
    /// ```
    /// use jointproof::slide_line::{Kind, Nodes, SlideLine};
    /// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0])])?;
    /// let closest = SlideLine::new(Kind::Linear, [1, 2])?.place(&nodes)?.closest([2.0, 1.0].into())?;
    /// let (slave, master) = closest.overclosure_variation();
    /// assert_eq!((slave.x, slave.y), (0.0, -1.0));
    /// assert_eq!((master[0].0, master[0].1.y), (1, 0.75));
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn overclosure_variation(&self) -> (Vector2<f64>, ArrayVec<(u32, Vector2<f64>), 5>) {
        (-self.normal, self.weights.iter().map(|&(node, weight)| (node, self.normal * weight)).collect())
    }
}

/// A slide line where its nodes are, with a spatial index. Made by [`SlideLine::place`](super::SlideLine::place).
#[derive(Clone, Debug)]
pub struct PlacedLine {
    kind: Kind,
    smoothing: Option<f64>,
    numbers: Vec<u32>,
    nodes: Vec<Vector2<f64>>,
    tree: Tree,
}

/// The closest point of one piece.
#[derive(Clone, Debug)]
struct PieceFoot {
    /// The coordinate.
    u: f64,
    inside: bool,
    distance: f64,
    beyond: f64,
    tangent: Vector2<f64>,
    separation: f64,
    /// Of the piece's nodes.
    weights: ArrayVec<f64, 5>,
}

impl PlacedLine {
    pub(super) fn new(
        kind: Kind,
        smoothing: Option<f64>,
        numbers: Vec<u32>,
        nodes: Vec<Vector2<f64>>,
    ) -> Result<Self, Error> {
        let mut line = Self { kind, smoothing, numbers, nodes, tree: Tree::new(Vec::new()) };
        for segment in 0..line.segments() {
            line.check_segment(segment)?;
        }
        line.tree = Tree::new((0..line.pieces()).map(|piece| line.bounds(piece)).collect());
        Ok(line)
    }

    /// The number of segments.
    pub fn segments(&self) -> usize {
        self.nodes.len().saturating_sub(1) / self.kind.stride()
    }

    /// Segments and smoothed corners, in order along the line.
    fn pieces(&self) -> usize {
        match self.smoothing {
            None => self.segments(),
            Some(_) => 2 * self.segments() - 1,
        }
    }

    /// The segment of a piece, and whether the piece is the corner behind it.
    fn piece(&self, piece: usize) -> (usize, bool) {
        if self.smoothing.is_some() { (piece / 2, piece % 2 == 1) } else { (piece, false) }
    }

    /// The indices of the nodes of a segment, or of the two that meet at the corner behind it.
    fn range(&self, segment: usize, corner: bool) -> std::ops::RangeInclusive<usize> {
        let (stride, reach) = (self.kind.stride(), if corner { 2 } else { 1 });
        segment * stride..=(segment + reach) * stride
    }

    fn check_segment(&self, segment: usize) -> Result<(), Error> {
        let range = self.range(segment, false);
        for k in range.clone() {
            if let Some(other) = range.clone().skip_while(|&j| j <= k).find(|&j| self.nodes[j] == self.nodes[k]) {
                return Err(Error::CoincidentNodes { first: self.numbers[k], second: self.numbers[other] });
            }
        }
        Ok(())
    }

    /// The part of a segment that its smoothed corners leave of it.
    fn ends(&self, segment: usize) -> [f64; 2] {
        let cut = |at_corner: bool| 1.0 - self.smoothing.filter(|_| at_corner).map_or(0.0, |f| 2.0 * f);
        [-cut(segment > 0), cut(segment + 1 < self.segments())]
    }

    /// A box around the points that span a piece: the control points of its Bézier form.
    fn bounds(&self, piece: usize) -> Rectangle {
        let (segment, corner) = self.piece(piece);
        let x = &self.nodes[self.range(segment, corner)];
        let f = self.smoothing.unwrap_or_default();
        let handle = |a: Vector2<f64>, b: Vector2<f64>, c: Vector2<f64>| b * 2.0 - (a + c) * 0.5;
        match *x {
            [a, b] => Rectangle::around(&[a, b]),
            [a, b, c] if corner => Rectangle::around(&[b + (a - b) * f, b, b + (c - b) * f]),
            [a, b, c] => Rectangle::around(&[a, handle(a, b, c), c]),
            [a, b, c, d, e] => {
                let weights = [0.0, 1.0].map(|t| (ParabolicCorner::weights(f, t), ParabolicCorner::rates(f, t), t));
                let nodes = [a, b, c, d, e];
                let controls = weights.map(|(weights, rates, t)| {
                    let end = -shape::gap(Vector2::zeros(), &nodes, weights);
                    // A third of X′ leads to the inner control point, forwards at the start and backwards at the end.
                    let third = shape::combination(&nodes, rates) * (f * (1.0 - 2.0 * t) / 3.0);
                    [end, end + third]
                });
                Rectangle::around(controls.as_flattened())
            }
            _ => Rectangle::around(x),
        }
    }

    /// The closest point of the whole line; of two that are equally near, the earlier one.
    ///
    /// # Errors
    /// A slave point that is not finite; [`Error::NoTangent`] where the line stands still or folds back at the closest
    /// point; [`Error::Overflow`].
    pub fn closest(&self, xs: Vector2<f64>) -> Result<ClosestPoint, Error> {
        Error::check_vector("xs", xs)?;
        let mut best: Option<(usize, PieceFoot)> = None;
        let mut evaluated = 0;
        self.tree.search(xs, |piece| {
            evaluated += 1;
            let foot = self.foot(piece, xs)?;
            let distance = foot.distance;
            let nearer = |(other, old): &(usize, PieceFoot)| {
                distance < old.distance || distance == old.distance && piece < *other
            };
            if best.as_ref().is_none_or(nearer) {
                best = Some((piece, foot));
            }
            Ok(distance)
        })?;
        let (piece, foot) = best.ok_or(Error::Overflow { name: "separation" })?;
        let closest = self.closest_point(piece, foot, xs, evaluated)?;
        if closest.separation.is_finite() { Ok(closest) } else { Err(Error::Overflow { name: "separation" }) }
    }

    fn foot(&self, piece: usize, xs: Vector2<f64>) -> Result<PieceFoot, Error> {
        let (segment, corner) = self.piece(piece);
        let ends = if corner { [0.0, 1.0] } else { self.ends(segment) };
        let f = self.smoothing.unwrap_or_default();
        match self.nodes[self.range(segment, corner)] {
            [x1, x2] => Ok(straight_foot(&LinearSlave { xs, x1, x2 }, ends)),
            [x1, x2, x3] if corner => curved_foot(&View::<_, LinearCorner, 3>::new(xs, [x1, x2, x3], f), ends, "t"),
            [x1, x2, x3] => curved_foot(&View::<_, Parabola, 3>::new(xs, [x1, x2, x3], f), ends, "g"),
            [x1, x2, x3, x4, x5] => {
                curved_foot(&View::<_, ParabolicCorner, 5>::new(xs, [x1, x2, x3, x4, x5], f), ends, "t")
            }
            _ => Err(Error::NodeCount { count: self.nodes.len(), allowed: "whole segments" }),
        }
    }

    fn closest_point(
        &self,
        piece: usize,
        foot: PieceFoot,
        xs: Vector2<f64>,
        evaluated: usize,
    ) -> Result<ClosestPoint, Error> {
        let (index, corner) = self.piece(piece);
        let range = self.range(index, corner);
        let vertex = match (foot.inside, self.smoothing, foot.u > 0.0) {
            (true, ..) | (_, Some(_), _) => None,
            (_, _, false) => index.checked_sub(1).map(|before| (before, *range.start())),
            (_, _, true) => (index + 1 < self.segments()).then_some((index, *range.end())),
        };
        if let Some((before, node)) = vertex {
            return self.at_vertex(before, node, xs, evaluated);
        }
        let weights = range.zip(&foot.weights).map(|(k, &weight)| (self.numbers[k], weight)).collect();
        Ok(ClosestPoint {
            place: if corner { Place::Corner { index, t: foot.u } } else { Place::Segment { index, g: foot.u } },
            beyond: foot.beyond,
            tangent: foot.tangent,
            normal: left(foot.tangent),
            separation: foot.separation,
            weights,
            evaluated,
        })
    }

    /// At the node between two segments. The sign of the separation is that of the side on which the slave point lies
    /// of both segments together; at the node itself the normal halves the angle.
    fn at_vertex(
        &self,
        before: usize,
        node: usize,
        xs: Vector2<f64>,
        evaluated: usize,
    ) -> Result<ClosestPoint, Error> {
        let gap = xs - self.nodes[node];
        let along = |segment: usize, end: f64| self.tangent(segment, end);
        let middle = along(before, 1.0)? + along(before + 1, -1.0)?;
        let distance = length(gap);
        let side = left(middle).dot(&gap);
        let normal = match (distance > 0.0, side < 0.0) {
            (false, _) => left(middle) / length(middle),
            (true, false) => gap / distance,
            (true, true) => -gap / distance,
        };
        if !normal.iter().all(|n| n.is_finite()) {
            return Err(Error::NoTangent { coordinate: "g", value: 1.0 });
        }
        Ok(ClosestPoint {
            place: Place::Node { number: self.numbers[node] },
            beyond: 0.0,
            tangent: -left(normal),
            normal,
            separation: if side < 0.0 { -distance } else { distance },
            weights: std::iter::once((self.numbers[node], 1.0)).collect(),
            evaluated,
        })
    }

    /// The unit tangent at an end of a segment.
    fn tangent(&self, segment: usize, end: f64) -> Result<Vector2<f64>, Error> {
        let rate = match self.nodes[self.range(segment, false)] {
            [x1, x2] => x2 - x1,
            [x1, x2, x3] => shape::combination(&[x1, x2, x3], shape::parabolic_rates(end)),
            _ => Vector2::zeros(),
        };
        let size = length(rate);
        if size > 0.0 { Ok(rate / size) } else { Err(Error::NoTangent { coordinate: "g", value: end }) }
    }
}

fn straight_foot(i: &LinearSlave<f64>, [from, to]: [f64; 2]) -> PieceFoot {
    let foot = super::closest::Projection::new(i);
    let [n1, n2] = foot.weights;
    let g = n2 - n1;
    let u = g.clamp(from, to);
    let beyond = (g - u) * 0.5 * foot.length;
    let separation = foot.separation();
    PieceFoot {
        u,
        inside: from < g && g < to,
        distance: if beyond == 0.0 { separation.abs() } else { length(i.xs - foot.point(i, u)) },
        beyond,
        tangent: foot.t,
        separation,
        weights: [n1, n2].into_iter().collect(),
    }
}

fn curved_foot<S: Shape<N>, const N: usize>(
    view: &View<f64, S, N>,
    ends: [f64; 2],
    coordinate: &'static str,
) -> Result<PieceFoot, Error> {
    let foot = Foot::between(view, ends);
    let _ = coordinate;
    Ok(PieceFoot {
        u: foot.u,
        inside: foot.inside,
        distance: 0.0,
        beyond: 0.0,
        tangent: -left(foot.normal()),
        separation: foot.separation() * view.unit,
        weights: foot.weights.into_iter().collect(),
    })
}
