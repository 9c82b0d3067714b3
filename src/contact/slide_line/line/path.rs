//! The distance along a line from one closest point to another: slip.

use super::interpolation::Interpolation;
use super::place::{ClosestPoint, Foot};
use super::placed::{Piece, PlacedLine};
use crate::Scalar;
use crate::contact::slide_line::length;
use crate::contact::slide_line::shape::{self, LinearCorner, Parabola, ParabolicCorner, Shape};
use crate::contact::slide_line::{LinearMotion, ParabolicMotion, SlipIncrementLinear, SlipIncrementParabolic};
use crate::formula::Formula;
use nalgebra::Vector2;

/// The number of parts into which a curve is divided for each reversal of its direction: within a part Gauss's rule is accurate
/// to the rounding of a double, unless the curve bends more than any element should. For a parabola five times as high as wide
/// the length has an error of 1e-11, for one 150 times as high of 5e-6.
const PARTS: f64 = 24.0;

impl<D: Scalar> PlacedLine<D> {
    /// The increment of E12 between two closest points, positive in the sequence of the nodes: the distance along this line, in
    /// its current configuration, from the material point of the one to that of the other. `before` may belong to an earlier
    /// configuration of the line.
    ///
    /// ```
    /// use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
    /// let line = SlideLine::new(Interpolation::Linear, [1, 2, 3])?;
    /// let placed = line.place(&Nodes::new([(1, [1.0, 0.0]), (2, [2.0, 0.0]), (3, [2.0, 4.0])])?)?;
    /// let [before, now] = [placed.closest([1.5, 0.0].into())?, placed.closest([2.0, 0.25].into())?];
    /// assert_eq!(placed.slip(&before, &now), 0.75); // around the corner
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn slip(&self, before: &ClosestPoint<D>, now: &ClosestPoint<D>) -> D {
        self.path_length(&before.foot, &now.foot)
    }

    pub(crate) fn path_length(&self, from: &Foot<D>, to: &Foot<D>) -> D {
        if (to.piece, to.u.re()) < (from.piece, from.u.re()) {
            return -self.path_length(to, from);
        }
        (from.piece..=to.piece).fold(to.beyond - from.beyond, |path_length, index| {
            let piece = self.piece(index);
            let [start, end] = self.ends(piece).map(D::from);
            let u0 = if index == from.piece { from.u } else { start };
            let u1 = if index == to.piece { to.u } else { end };
            path_length + self.path_length_within(piece, u0, u1)
        })
    }

    /// The number of pieces on the way.
    pub(crate) fn passed(from: &Foot<D>, to: &Foot<D>) -> usize {
        from.piece.abs_diff(to.piece) + 1
    }

    /// The distance within a piece. On a curve it is integrated: the slip formula gives its rate, and the curve is divided where
    /// it bends.
    pub(super) fn path_length_within(&self, piece: Piece, u0: D, u1: D) -> D {
        if (self.interpolation, piece.is_corner()) == (Interpolation::Linear, false) {
            return self.rate_of_slip(piece, u1, u1 - u0);
        }
        let middle = (u0 + u1) * 0.5;
        let [first, halfway, last] = [u0, middle, u1].map(|u| self.rate(piece, u));
        let parts = (PARTS * (turn(first, halfway) + turn(halfway, last))).floor() + 1.0;
        let half = (u1 - u0) * (0.5 / parts);
        let points: [[D; 2]; 5] = gauss();
        let centers = std::iter::successors(Some(1.0), |odd| Some(odd + 2.0)).take_while(|&odd| odd < 2.0 * parts);
        centers.fold(D::zero(), |path_length, odd| {
            let center = u0 + half * odd;
            points.iter().fold(path_length, |path_length, &[place, weight]| {
                path_length + self.rate_of_slip(piece, center + half * place, half * weight)
            })
        })
    }

    /// The slip of a point that moves along the piece by an increment of the coordinate.
    fn rate_of_slip(&self, piece: Piece, u: D, by: D) -> D {
        let (dxs, zero) = (self.rate(piece, u) * by, Vector2::from_element(D::zero()));
        match (self.interpolation, piece.is_corner()) {
            (Interpolation::Linear, false) => {
                let [x1, x2] = self.nodes_of(piece);
                SlipIncrementLinear::eval(&LinearMotion { x1, x2, g: u, dxs, dx1: zero, dx2: zero }).dslip
            }
            (Interpolation::Parabolic, false) => {
                let [x1, x2, x3] = self.nodes_of(piece);
                let motion = ParabolicMotion { x1, x2, x3, g: u, dxs, dx1: zero, dx2: zero, dx3: zero };
                SlipIncrementParabolic::eval(&motion).dslip
            }
            // The motion is along the curve's own tangent.
            (_, true) => length(dxs) * if by < 0.0 { -1.0 } else { 1.0 },
        }
    }

    /// X′(u).
    fn rate(&self, piece: Piece, u: D) -> Vector2<D> {
        match (self.interpolation, piece) {
            (Interpolation::Linear, Piece::Segment(_)) => {
                let [x1, x2] = self.nodes_of(piece);
                (x2 - x1) * D::from(0.5)
            }
            (Interpolation::Linear, Piece::Corner(_, f)) => self.rate_of::<LinearCorner, 3>(piece, f, u),
            (Interpolation::Parabolic, Piece::Segment(_)) => self.rate_of::<Parabola, 3>(piece, 0.0, u),
            (Interpolation::Parabolic, Piece::Corner(_, f)) => self.rate_of::<ParabolicCorner, 5>(piece, f, u),
        }
    }

    fn rate_of<S: Shape<N>, const N: usize>(&self, piece: Piece, f: f64, u: D) -> Vector2<D> {
        let f = D::from(f);
        shape::combination(&self.nodes_of(piece), S::rates(f, u)) * S::factor(f)
    }
}

/// A measure of the change between two derivatives of a curve: 0 on a straight line with uniform speed, 1 where it reverses.
fn turn<D: Scalar>(first: Vector2<D>, last: Vector2<D>) -> f64 {
    let [first, last] = [first, last].map(|rate| rate.map(|x| x.re()));
    let size = length(first) + length(last);
    if size > 0.0 { length(last - first) / size } else { 0.0 }
}

/// Points from −1 to 1 and weights of the five-point Gauss rule.
pub(crate) fn gauss<D: Scalar>() -> [[D; 2]; 5] {
    let root = |x: D| x.sqrt();
    let (by_places, by_weights) = (root(D::from(10.0) / 7.0) * 2.0, root(D::from(70.0)) * 13.0);
    let [near, far] = [-by_places + 5.0, by_places + 5.0].map(|square| root(square) / 3.0);
    let [heavy, light] = [by_weights + 322.0, -by_weights + 322.0].map(|weight| weight / 900.0);
    [[-far, light], [-near, heavy], [D::zero(), D::from(128.0) / 225.0], [near, heavy], [far, light]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::slide_line::line::placed::tests::placed;

    #[test]
    fn the_rate_of_slip_has_the_sign_of_the_step_and_is_the_length_of_the_rate_times_it() {
        let places = [[0.0, 0.0], [3.0, 4.0], [6.0, 8.0], [9.0, 12.0], [12.0, 16.0]];
        // Collinear nodes with a spacing of 5: X′ is half a segment, twice a quarter of one at a corner, and so on.
        for (kind, smoothing, piece, u, rate) in [
            (Interpolation::Linear, None, 0, 0.25, 2.5),
            (Interpolation::Linear, Some(0.25), 1, 0.25, 2.5),
            (Interpolation::Parabolic, None, 1, 0.25, 5.0),
            (Interpolation::Parabolic, Some(0.25), 1, 0.5, 5.0),
        ] {
            let line = placed(kind, smoothing, &places);
            let piece = line.piece(piece);
            for by in [0.25, -0.25, 2.0, -2.0] {
                let slip = line.rate_of_slip(piece, u, by);
                assert!((slip - rate * by).abs() < 1e-14, "{kind:?} {smoothing:?} by {by}: {slip}");
            }
        }
    }

    /// The exact length is ∫ √(1 + (2hg)²) dg, which is elementary. If the curve bends within a twentieth of its width, ten
    /// digits are correct.
    #[test]
    fn the_way_along_a_parabola_is_its_length_however_bent() {
        for (height, error) in [(0.0, 1e-14), (0.5, 1e-14), (1.0, 1e-14), (10.0, 1e-10)] {
            let line = placed(Interpolation::Parabolic, None, &[[0.0, height], [1.0, 0.0], [2.0, height]]);
            let length = |g: f64| {
                let slope = 2.0 * height * g;
                if slope == 0.0 { g } else { 0.5 * g * (slope.hypot(1.0) + slope.asinh() / slope) }
            };
            for [from, to] in [[-1.0, 1.0], [-0.5, 0.75], [0.25, 0.5]] {
                let path_length = line.path_length_within(line.piece(0), from, to);
                let expected = length(to) - length(from);
                assert!(
                    (path_length / expected - 1.0).abs() < error,
                    "{height} {from} {to}: {path_length} and not {expected}"
                );
            }
        }
    }

    /// A right angle smoothed over half of either side is a parabola, too.
    #[test]
    fn the_way_around_a_smoothed_corner_is_its_length() {
        let line = placed(Interpolation::Linear, Some(0.25), &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]]);
        let path_length = line.path_length_within(line.piece(1), 0.0, 1.0);
        // X′ = 2 (1 − t, t): ∫ 2 √(1 − 2t + 2t²) dt.
        let expected = 1.0 + 1.0_f64.asinh() / 2.0_f64.sqrt();
        assert!((path_length - expected).abs() < 1e-13, "{path_length} and not {expected}");
    }

    #[test]
    fn a_turn_is_0_straight_on_and_1_backwards() {
        let turn = |first: [f64; 2], last: [f64; 2]| turn(Vector2::from(first), Vector2::from(last));
        assert_eq!((turn([1.0, 2.0], [1.0, 2.0]), turn([1.0, 2.0], [-1.0, -2.0])), (0.0, 1.0));
        assert_eq!(
            (turn([3.0, 0.0], [1.0, 0.0]), turn([0.0; 2], [0.0; 2]), turn([0.0; 2], [0.0, 0.25])),
            (0.5, 0.0, 1.0)
        );
    }

    #[test]
    fn the_rule_is_right_for_polynomials_of_degree_9() {
        for degree in 0..10 {
            let found: f64 = gauss::<f64>().iter().map(|&[x, weight]| weight * (x + 1.0).powi(degree)).sum();
            let expected = 2.0_f64.powi(degree + 1) / f64::from(degree + 1);
            assert!((found / expected - 1.0).abs() < 1e-15 * 8.0, "{degree}: {found}");
        }
    }
}
