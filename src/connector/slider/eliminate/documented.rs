//! The documented route: through the directions normal to the line, t1 and t2, and a system of two equations.
//!
//! It defines what [`Eliminate`](crate::connector::slider::Eliminate) and [`Increment`](crate::connector::slider::Increment)
//! compute by the direct route. In exact arithmetic both give the same result; in doubles this one is more expensive, and its
//! increments lose digits where t1 and t2 rotate fast, near n = ±i.

use super::{Coordinates, Increments, KeptCoordinate, KeptIncrement};
use crate::connector::slider::{
    Basis, BasisVariation, Direction, DirectionChange, DirectionVariation, Ends, Line, LineDirection, MovingEnds,
    Pivots, TangentChanges, Tangents, TurningDirection,
};
use crate::formula::Formula;
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// Two coordinates of m from the third: t_q·(xm − x1) = 0 for q = 1, 2, solved for those of axes i and j.
///
/// ```
/// use jointproof::connector::slider::{KeptCoordinate, documented};
/// use nalgebra::Vector3;
/// let line = KeptCoordinate { x1: Vector3::zeros(), xn: Vector3::new(2.0, 0.0, 4.0), xmk: 8.0 };
/// let m = documented::eliminate(&line);
/// assert!(m.xmi.abs() < 1e-15 && (m.xmj - 4.0).abs() < 1e-14); // k = 3, i = 2, j = 1
/// ```
pub fn eliminate<D: Scalar>(i: &KeptCoordinate<D>) -> Coordinates<D> {
    let n = Line::eval(&Ends { x1: i.x1, xn: i.xn }).n;
    let pivots = Pivots::new(&i.x1, &i.xn);
    let [along_i, along_j] = solve(&Basis::eval(&LineDirection { n }), pivots, [D::zero(); 2], i.xmk - i.x1[pivots.k]);
    Coordinates { xmi: i.x1[pivots.i] + along_i, xmj: i.x1[pivots.j] + along_j }
}

/// Two increments of m from the third: t_q·(dxm − dx1) + dt_q·(xm − x1) = 0 for q = 1, 2, solved for those of axes i and j.
///
/// It presumes that m is on the line; otherwise the rotation of t1 and t2 adds to the result, which then differs from that of
/// [`Increment`](crate::connector::slider::Increment).
pub fn increment<D: Scalar>(i: &KeptIncrement<D>) -> Increments<D> {
    let Direction { n, .. } = Line::eval(&Ends { x1: i.x1, xn: i.xn });
    let DirectionChange { dn, .. } =
        DirectionVariation::eval(&MovingEnds { x1: i.x1, xn: i.xn, dx1: i.dx1, dxn: i.dxn });
    let TangentChanges { dt1, dt2 } = BasisVariation::eval(&TurningDirection { n, dn });
    let pivots = Pivots::new(&i.x1, &i.xn);
    let offset = i.xm - i.x1;
    let turning = [dt1.dot(&offset), dt2.dot(&offset)];
    let [along_i, along_j] = solve(&Basis::eval(&LineDirection { n }), pivots, turning, i.dxmk - i.dx1[pivots.k]);
    Increments { dxmi: i.dx1[pivots.i] + along_i, dxmj: i.dx1[pivots.j] + along_j }
}

/// [`increment`] at the projection of m onto the line, x1 + ξ (xn − x1): the result of
/// [`Increment`](crate::connector::slider::Increment), wherever m is.
pub fn increment_on_line<D: Scalar>(i: &KeptIncrement<D>) -> Increments<D> {
    let d = i.xn - i.x1;
    let share = (i.xm - i.x1).dot(&d) / d.dot(&d);
    increment(&KeptIncrement { xm: i.x1 + d * share, ..*i })
}

/// (v_i, v_j) of the vector v that satisfies t_q·v = −turning_q for the given v_k. The determinant is ±n_k.
fn solve<D: Scalar>(basis: &Tangents<D>, pivots: Pivots, turning: [D; 2], kept: D) -> [D; 2] {
    let Pivots { i, j, k } = pivots;
    let equation = |t: &Vector3<D>, turning: D| (t[i], t[j], -(turning + t[k] * kept));
    let (a, b, right_1) = equation(&basis.t1, turning[0]);
    let (c, d, right_2) = equation(&basis.t2, turning[1]);
    let determinant = a * d - b * c;
    [(right_1 * d - b * right_2) / determinant, (a * right_2 - right_1 * c) / determinant]
}
