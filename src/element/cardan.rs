//! Cardan angles of node b's triad relative to node a's.
//!
//! The frames are the triads of both nodes, orthonormal and right-handed. With `R_ij = e_ia·e_jb`, row i and column j, the angles
//! are those of R = R1(α) R2(β) R3(γ) ([`rotation`]), three rotations by the right-hand rule, each about an axis as rotated by
//! the previous ones:
//!
//! ```text
//!     ⎡           cos β cos γ                      −cos β sin γ                   sin β    ⎤
//! R = ⎢ cos α sin γ + sin α sin β cos γ   cos α cos γ − sin α sin β sin γ   −sin α cos β  ⎥
//!     ⎣ sin α sin γ − cos α sin β cos γ   sin α cos γ + cos α sin β sin γ    cos α cos β  ⎦
//! ```
//!
//! All three are 0 where both triads are equal.
//!
//! α rotates about e1a, γ about e3b, and β about the line of nodes between them, cos α e2a + sin α e3a.
//!
//! [`alpha`] and [`gamma`] with [`alpha_gradient`] and [`gamma_gradient`] are correct at every angle, ±90° and ±180° included:
//! value and derivative need no quotient of the two scalar products. They lie in [−π, π); half a turn is −π. Only at gimbal lock,
//! where β = ±90° and both scalar products vanish, are they undefined, mathematically and here: [`check_alpha`] and
//! [`check_gamma`] reject it.
//!
//! β has two forms. [`CardanAngles`] is the documented arc sine. [`BetaTwoArgument`] is ours: equal on orthonormal triads and
//! accurate up to ±90°, where the arc sine amplifies a rounding error of 1e-16 to 1e-8. [`between`] uses ours.

#![expect(clippy::inline_always, reason = "a call would write the vectors to memory, and wait for them there")]

mod accurate;
mod angles;
mod arc_sine;
mod beta;
mod triads;
#[cfg(feature = "verify")]
pub mod turns;

pub use accurate::{MOST_CONDITION, accurate, accurate_jacobian, between, check_start, condition};
pub use angles::{Angles, CardanAngles};
pub(crate) use arc_sine::arc_sine_slope;
pub use beta::{Beta, BetaAxes, BetaTwoArgument};
pub(crate) use triads::Oriented;
pub use triads::{Triads, check_turns};

use crate::formula::error::Error;
use crate::number::scalar::{
    Scalar, angles, choice, constant, has_length, is_between, leaf, nearest_integer, norm_and_direction, number_if, pi,
};
use nalgebra::{Matrix3, Vector3};

/// The first angle, α = −atan2(e2a·e3b, e3a·e3b).
#[inline]
pub fn alpha<D: Scalar>(e2a: &Vector3<D>, e3a: &Vector3<D>, e3b: &Vector3<D>) -> D {
    turn(e3b, e2a, e3a)
}

/// The derivatives of [`alpha`] with respect to its arguments, in their order.
#[inline]
pub fn alpha_gradient<D: Scalar>(e2a: &Vector3<D>, e3a: &Vector3<D>, e3b: &Vector3<D>) -> [Vector3<D>; 3] {
    let [by_e3b, by_e2a, by_e3a] = turn_gradient([e3b, e2a, e3a], (e3b.dot(e2a), e3b.dot(e3a)));
    [by_e2a, by_e3a, by_e3b]
}

/// Rejects inputs at which [`alpha`] is undefined.
///
/// # Errors
/// [`Error::GimbalLock`].
#[inline]
pub fn check_alpha<D: Scalar>(e2a: &Vector3<D>, e3a: &Vector3<D>, e3b: &Vector3<D>) -> Result<(), Error> {
    if is_turn(e3b, e2a, e3a) {
        return Ok(());
    }
    Err(Error::GimbalLock { angle: "alpha", sine: "e2a·e3b", cosine: "e3a·e3b" })
}

/// The third angle, γ = −atan2(e1a·e2b, e1a·e1b).
#[inline]
pub fn gamma<D: Scalar>(e1a: &Vector3<D>, e1b: &Vector3<D>, e2b: &Vector3<D>) -> D {
    turn(e1a, e2b, e1b)
}

/// The derivatives of [`gamma`] with respect to its arguments, in their order.
#[inline]
pub fn gamma_gradient<D: Scalar>(e1a: &Vector3<D>, e1b: &Vector3<D>, e2b: &Vector3<D>) -> [Vector3<D>; 3] {
    let [by_e1a, by_e2b, by_e1b] = turn_gradient([e1a, e2b, e1b], (e1a.dot(e2b), e1a.dot(e1b)));
    [by_e1a, by_e1b, by_e2b]
}

/// Rejects inputs at which [`gamma`] is undefined.
///
/// # Errors
/// [`Error::GimbalLock`].
#[inline]
pub fn check_gamma<D: Scalar>(e1a: &Vector3<D>, e1b: &Vector3<D>, e2b: &Vector3<D>) -> Result<(), Error> {
    if is_turn(e1a, e2b, e1b) {
        return Ok(());
    }
    Err(Error::GimbalLock { angle: "gamma", sine: "e1a·e2b", cosine: "e1a·e1b" })
}

/// −atan2(v·p, v·q).
#[inline]
fn turn<D: Scalar>(v: &Vector3<D>, p: &Vector3<D>, q: &Vector3<D>) -> D {
    let [turn] = turns([v.dot(p)], [v.dot(q)]);
    turn
}

/// −atan2(sine, cosine), independent of the signs of zeros: half a turn is −π, no turn is +0.
#[inline(always)]
fn turns<D: Scalar, const N: usize>(sines: [D; N], cosines: [D; N]) -> [D; N] {
    angles(sines.map(|sine| sine + 0.0), cosines).map(|angle| D::zero() - angle)
}

/// The derivatives of −atan2(v·p, v·q) with respect to v, p and q, from v·p and v·q.
///
/// With s and c for the two scalar products: −c v and s v for p and q, s q − c p for v, all divided by s² + c². Rounding s or c does
/// what a small change of p or q does: so the derivative is as accurate as its vectors for any v, p and q.
#[inline]
fn turn_gradient<D: Scalar>(of: [&Vector3<D>; 3], (sine, cosine): (D, D)) -> [Vector3<D>; 3] {
    let [gradient] = turn_gradients([of], [sine], [cosine], difference);
    gradient
}

/// s q − c p.
#[inline(always)]
fn difference<D: Scalar>([_, p, q]: [&Vector3<D>; 3], [sine, cosine]: [D; 2]) -> Vector3<D> {
    q * sine - p * cosine
}

/// Several such derivatives; `of_v` is [`difference`], or another way to compute it.
#[inline(always)]
fn turn_gradients<D: Scalar, const N: usize>(
    of: [[&Vector3<D>; 3]; N],
    sines: [D; N],
    cosines: [D; N],
    of_v: impl Fn([&Vector3<D>; 3], [D; 2]) -> Vector3<D>,
) -> [[Vector3<D>; 3]; N] {
    let squares: [D; N] = std::array::from_fn(|k| sines[k] * sines[k] + cosines[k] * cosines[k]);
    let are_usual = squares.iter().fold(true, |all, &square| all & is_between(square, 1e-30, 1e30));
    if !are_usual && D::has_extremes() {
        return std::array::from_fn(|k| extreme_turn_gradient(of[k].map(|v| *v), (sines[k], cosines[k]), &of_v));
    }
    let by = squares.map(|square| number_if(are_usual, square.recip()));
    std::array::from_fn(|k| {
        let v = of[k][0];
        [of_v(of[k], [sines[k], cosines[k]]) * by[k], v * (-cosines[k] * by[k]), v * (sines[k] * by[k])]
    })
}

/// [`turn_gradient`] where squares under- or overflow. Passed by value: references would keep the vectors in memory on all paths.
#[cold]
fn extreme_turn_gradient<D: Scalar>(
    [v, p, q]: [Vector3<D>; 3],
    (sine, cosine): (D, D),
    of_v: impl Fn([&Vector3<D>; 3], [D; 2]) -> Vector3<D>,
) -> [Vector3<D>; 3] {
    let (length, [sine, cosine]) = norm_and_direction([sine, cosine]);
    let by = length.recip();
    [of_v([&(v * by), &p, &q], [sine, cosine]) * by, v * (-cosine * by), v * (sine * by)]
}

/// Whether [`turn`] and its derivatives are defined. If several rows are computed at once, the results are NaN otherwise.
#[inline]
fn is_turn<D: Scalar>(v: &Vector3<D>, p: &Vector3<D>, q: &Vector3<D>) -> bool {
    !(D::has_extremes() || D::ignores_extremes()) || has_length([v.dot(p), v.dot(q)])
}

/// The angle plus the number of full turns that brings it nearest to another one: this follows a joint from state to state,
/// provided that it rotates by less than half a turn between them. Of two angles that are equally near, it is the one with more
/// full turns.
#[inline]
pub(crate) fn nearest<D: Scalar>(angle: D, to: D) -> D {
    let turns = constant::<D>(nearest_integer(leaf(to - angle) / (pi::<D::Leaf>() * 2.0)));
    let [nearest] = choice(|| [if turns == 0.0 { angle } else { angle + pi::<D>() * (turns * 2.0) }]);
    nearest
}

/// R1(α) R2(β) R3(γ): three rotations about the first, the second and the third axis, each about an axis as rotated by the
/// previous ones. Row i, column j is `e_ia·e_jb`.
///
/// ```
/// use jointproof::element::cardan::rotation;
/// let quarter = std::f64::consts::FRAC_PI_2;
/// let r = rotation(quarter, 0.0, 0.0); // b turned by 90° about the first axis: e2b is e3a, e3b is −e2a
/// assert!((r[(2, 1)] - 1.0).abs() < 1e-15 && (r[(1, 2)] + 1.0).abs() < 1e-15);
/// ```
pub fn rotation<D: Scalar>(alpha: D, beta: D, gamma: D) -> Matrix3<D> {
    let [(sa, ca), (sb, cb), (sc, cc)] = [alpha, beta, gamma].map(|angle| angle.sin_cos());
    Matrix3::new(
        cb * cc,
        -cb * sc,
        sb,
        ca * sc + sa * sb * cc,
        ca * cc - sa * sb * sc,
        -sa * cb,
        sa * sc - ca * sb * cc,
        sa * cc + ca * sb * sc,
        ca * cb,
    )
}

/// The triad of b, rotated relative to the triad of a by this matrix.
pub fn turned<D: Scalar>(a: &[Vector3<D>; 3], r: &Matrix3<D>) -> [Vector3<D>; 3] {
    std::array::from_fn(|j| a[0] * r[(0, j)] + a[1] * r[(1, j)] + a[2] * r[(2, j)])
}
