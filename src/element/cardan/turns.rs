//! Pairs of triads of interest, declared once: every formula of the orientations of two nodes is tested on these.

use super::{Oriented, Triads, rotation, turned};
use crate::Octuple;
use crate::formula::proof::hard::{FIFTEENTHS, Hard, triad};
use crate::formula::proof::{Convention, Kink, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{Scalar, abs};
use nalgebra::Vector3;

/// The triads of node a and node b.
pub type TriadPair = [[Vector3<f64>; 3]; 2];

/// A triad whose three Cardan angles have the sine 0.6, relative to the global axes: every component has few digits.
pub const PYTHAGOREAN: [Vector3<f64>; 3] =
    [Vector3::new(0.64, 0.768, -0.024), Vector3::new(-0.48, 0.424, 0.768), Vector3::new(0.6, -0.48, 0.64)];

/// Triads at angles where naive code loses value or derivative; all Cardan angles are defined.
pub fn triads() -> Vec<Hard<TriadPair>> {
    let quarter = Octuple::PI / 2.0;
    let small = |size: f64| Octuple::from(size);
    let [alpha, gamma] = [0.3, -0.7].map(Octuple::from);
    let (zero, beta) = (small(0.0), small(0.4));
    vec![
        Hard::new("equal-axes", "both triads are the global axes", axes([1, 2, 3])),
        Hard::new("equal", "equal triads off the axes", [triad(), triad()]),
        Hard::new("tiny", "angles of 1e-9", at_angles([small(1e-9), small(-2e-9), small(3e-9)])),
        Hard::new("alpha+90", "α = 90°: e3a·e3b is 0", axes([1, 3, -2])),
        Hard::new("alpha-90", "α = -90°: e3a·e3b is 0", axes([1, -3, 2])),
        Hard::new("alpha-180", "α = ±180°: the value is -π, the derivative that of any other angle", axes([1, -2, -3])),
        Hard::new("gamma+90", "γ = 90°: e1a·e1b is 0", axes([2, -1, 3])),
        Hard::new("gamma-90", "γ = -90°: e1a·e1b is 0", axes([-2, 1, 3])),
        Hard::new("gamma-180", "γ = ±180°: the value is -π, the derivative that of any other angle", axes([-1, -2, 3])),
        Hard::new("flipped", "half a turn about the second axis: β = 0, α = γ = -π", axes([-1, 2, -3])),
        Hard::new(
            "alpha+90-gamma-90",
            "a quarter turn about the first axis, one back about the third",
            axes([-3, 1, -2]),
        ),
        Hard::new("alpha+90-off-axis", "α = 90° to rounding", at_angles([quarter, beta, gamma])),
        Hard::new("gamma-90-off-axis", "γ = -90° to rounding", at_angles([alpha, beta, -quarter])),
        Hard::new(
            "below-180",
            "α, γ 1e-8 inside the cut",
            at_angles([quarter * 2.0 - 1e-8, beta, -quarter * 2.0 + 1e-8]),
        ),
        Hard::new(
            "beyond-180",
            "α, γ 1e-8 beyond the cut",
            at_angles([quarter * 2.0 + 1e-8, beta, -quarter * 2.0 - 1e-8]),
        ),
        Hard::new("beta-1e-4", "β within 1e-4 of 90°", at_angles([alpha, quarter - 1e-4, gamma])),
        Hard::new("beta-1e-8", "β within 1e-8 of 90°", at_angles([alpha, quarter - 1e-8, gamma])),
        Hard::new("beta+1e-4", "β within 1e-4 of -90°", at_angles([alpha, -quarter + 1e-4, gamma])),
        Hard::new("beta+1e-8", "β within 1e-8 of -90°", at_angles([alpha, -quarter + 1e-8, gamma])),
        Hard::new("alpha-zero", "a turn about the second and third axes alone", at_angles([zero, beta, gamma])),
    ]
}

/// Gimbal lock: β = ±90°, where α and γ rotate about the same axis and neither is defined.
pub fn gimbal_locked() -> Vec<Hard<TriadPair>> {
    vec![
        Hard::new("gimbal+90", "β = 90°: α and γ are undefined", axes([-3, 2, 1])),
        Hard::new("gimbal-90", "β = -90°: α and γ are undefined", axes([3, 2, -1])),
    ]
}

/// The triad of a is the global axes, that of b consists of these of them, counted from 1, reversed if negative.
pub fn axes(of_b: [i32; 3]) -> TriadPair {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let axis = |k: i32| [x, y, z][(k.unsigned_abs() as usize - 1) % 3] * f64::from(k.signum());
    [[x, y, z], of_b.map(axis)]
}

/// The triad of a as in [`triad`], that of b at these Cardan angles relative to it, every component rounded once.
pub fn at_angles([alpha, beta, gamma]: [Octuple; 3]) -> TriadPair {
    let a = FIFTEENTHS.map(|row| Vector3::from(row.map(Octuple::from)) / Octuple::from(15.0));
    let b = turned(&a, &rotation(alpha, beta, gamma));
    [a, b].map(|triad| triad.map(|e| e.map(Octuple::to_f64)))
}

impl<D: Scalar> Triads<D> {
    /// Both triads, orthonormal to 237 bits.
    pub(crate) fn orthonormal(&self) -> ([Vector3<D>; 3], [Vector3<D>; 3]) {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b } = *self;
        (law::orthonormal([e1a, e2a, e3a]), law::orthonormal([e1b, e2b, e3b]))
    }
}

/// The kinks of the three angles, in any formula that contains them.
pub(crate) fn kinks<F: Formula>() -> Vec<Kink<F>>
where
    F::Inputs<f64>: Oriented<f64>,
    F::Inputs<Octuple>: Oriented<Octuple>,
{
    let arc_sine = Kink::<F>::switch(
        r"\lvert\mathbf{e}_{1a}\cdot\mathbf{e}_{3b}\rvert = 1",
        |i: &F::Inputs<Octuple>| {
            let Triads { e1a, e3b, .. } = i.triads();
            abs(e1a.dot(&e3b)) == 1.0
        },
        Oriented::of(Triads { e3b: Vector3::new(1.0, -0.5, 0.5), ..of_axes([1, 2, 3]) }),
        Oriented::of(Triads { e1a: Vector3::x(), ..Triads::filled(0.0) }),
    );
    std::iter::once(arc_sine).chain(cuts()).collect()
}

/// The cuts of α and γ at half a turn, in any formula that contains them.
pub(crate) fn cuts<F: Formula>() -> [Kink<F>; 2]
where
    F::Inputs<f64>: Oriented<f64>,
    F::Inputs<Octuple>: Oriented<Octuple>,
{
    [
        Kink::<F>::new(
            Convention::Cut,
            r"\alpha = -\pi",
            |i| {
                let Triads { e2a, e3a, e3b, .. } = i.triads();
                e2a.dot(&e3b) == 0.0 && e3a.dot(&e3b) < 0.0
            },
            Oriented::of(of_axes([1, -2, -3])),
            Oriented::of(Triads { e3b: Vector3::y(), ..Triads::filled(0.0) }),
        ),
        Kink::<F>::new(
            Convention::Cut,
            r"\gamma = -\pi",
            |i| {
                let Triads { e1a, e1b, e2b, .. } = i.triads();
                e1a.dot(&e2b) == 0.0 && e1a.dot(&e1b) < 0.0
            },
            Oriented::of(of_axes([-1, -2, 3])),
            Oriented::of(Triads { e2b: Vector3::x(), ..Triads::filled(0.0) }),
        ),
    ]
}

/// The triad of a is the global axes, that of b consists of these of them.
pub(crate) fn of_axes(of_b: [i32; 3]) -> Triads<f64> {
    let [a, b] = axes(of_b);
    Triads::new(a, b)
}
