//! The planted mistakes.

use super::super::question::Wanted::{self, Jacobian, Products, Value};
use std::f64::consts::PI;

/// The effect of a mistake.
#[derive(Clone, Copy)]
pub(super) enum Plant {
    Nothing,
    /// Alters valid inputs.
    Before(fn(&mut [f64])),
    /// Alters the numbers of an answer, given the inputs.
    After(fn(&[f64], &mut [f64])),
    /// Alters both.
    Both(fn(&mut [f64]), fn(&[f64], &mut [f64])),
    /// Alters both; the last number is omitted if a certain bit of the first input is 0.
    Gaps(fn(&mut [f64]), fn(&[f64], &mut [f64])),
}

use Plant::{After, Before, Both, Gaps, Nothing};

/// A name, the formula, the requested results, and the mistake.
pub(super) const PLANTS: &[(&str, &str, Wanted, Plant)] = &[
    ("right", "slot.friction", Jacobian, Nothing),
    ("right value", "slot.friction", Value, Nothing),
    ("right products", "slot.friction", Products, Nothing),
    ("two factors", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, -1.0), (FN + 2, 2.0)]))),
    (
        "four entries",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[FN + 1, FN + 3, PHI + 2, PHI + 4].map(|k| (k, -1.0)))),
    ),
    (
        "five entries",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[FN + 1, FN + 3, PHI + 1, PHI + 2, PHI + 4].map(|k| (k, 0.25)))),
    ),
    (
        "too many factors",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[(FN + 1, -1.0), (FN + 2, 2.0), (FN + 3, 4.0), (PHI, 0.5)])),
    ),
    (
        "other factors",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[(FN + 1, -2.0), (FN + 2, -0.5), (FN + 3, 4.0)])),
    ),
    (
        "more factors",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[(FN + 1, 0.5), (FN + 2, 0.25), (FN + 3, 0.0)])),
    ),
    (
        "degrees in an entry",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[(FN + 1, PI / 180.0), (FN + 2, 180.0 / PI)])),
    ),
    ("a factor of its own", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, 1.001), (FN + 2, -37.5)]))),
    ("a factor near 1", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, 1.0 + 1e-9)]))),
    ("a factor not so near 1", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, 1.0 + 3e-7)]))),
    ("a factor too near 1", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, 1.0 + 2e-11)]))),
    (
        "a number and its row",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[2, PHI, PHI + 1, PHI + 2, PHI + 3, PHI + 4].map(|k| (k, 3.0)))),
    ),
    ("two rows", "slot.friction", Jacobian, After(|_, y| y[FN..].iter_mut().for_each(|y| *y *= -1.0))),
    ("a row but one", "slot.friction", Jacobian, After(|_, y| scale(y, &[1, 2, 3].map(|k| (PHI + k, 1.5))))),
    ("a factor of infinity", "slot.friction", Jacobian, After(|_, y| scale(y, &[(FN + 1, f64::INFINITY)]))),
    ("a row", "slot.friction", Jacobian, After(|_, y| scale(y, &[0, 1, 2, 3, 4].map(|k| (PHI + k, 1.5))))),
    (
        "two columns",
        "slot.friction",
        Jacobian,
        After(|_, y| scale(y, &[FN + 1, FN + 2, PHI + 1, PHI + 2].map(|k| (k, -2.0)))),
    ),
    ("two components", "slider.line", Jacobian, After(|_, y| y[4..16].iter_mut().for_each(|y| *y *= 0.5))),
    ("all", "universal.angles", Jacobian, After(|_, y| y.iter_mut().for_each(|y| *y *= 180.0 / PI))),
    ("nothing at all", "slot.friction", Jacobian, After(|_, y| y.fill(0.0))),
    ("a rounding too many", "slot.contact_force", Jacobian, After(|_, y| y[0] *= 1.0 + 9.0 * f64::EPSILON)),
    ("a constant of single precision", "slot.contact_force", Jacobian, After(|_, y| y[0] *= f64::from(0.1_f32) / 0.1)),
    ("factors of values", "slot.friction", Value, After(|_, y| scale(y, &[(0, -1.0), (2, -0.5)]))),
    ("transposed", "ujoint.twist_factors", Jacobian, After(|_, y| y.swap(3, 4))),
    ("column by column", "slot.friction", Jacobian, After(|_, y| move_entries(y, |k| (k % 3) * 5 + k / 3))),
    ("read column by column", "slot.friction", Jacobian, After(|_, y| move_entries(y, |k| k / 5 + (k % 5) * 3))),
    ("a block", "element.rotation_vector", Jacobian, After(|_, y| transpose_block(y, 0))),
    (
        "all blocks",
        "element.rotation_vector",
        Jacobian,
        After(|_, y| [0, 3].iter().for_each(|&j| transpose_block(y, j))),
    ),
    (
        "a matrix",
        "element.arm",
        Jacobian,
        After(|_, y| [(4, 6), (5, 9), (8, 10)].iter().for_each(|&(a, b)| exchange_rows(y, [12, 9], a, b))),
    ),
    ("outputs", "slot.friction", Jacobian, After(|_, y| exchange_rows(y, [3, 5], 0, 2))),
    ("components of outputs", "slider.line", Value, After(|_, y| y.swap(0, 2))),
    ("derivatives", "slot.friction", Jacobian, After(|_, y| (0..3).for_each(|i| y.swap(3 + 5 * i + 1, 3 + 5 * i + 4)))),
    ("an index", "slot.friction", Jacobian, After(|_, y| (y[FN + 2], y[PHI + 1]) = (-y[FN + 1], y[PHI + 2]))),
    ("symmetric part", "universal.geometric_stiffness", Jacobian, After(|_, y| symmetrise(y, 0))),
    (
        "symmetric parts",
        "universal.geometric_stiffness",
        Jacobian,
        After(|_, y| [0, 18].iter().for_each(|&first| symmetrise(y, first))),
    ),
    ("a pair of a matrix", "universal.geometric_stiffness", Jacobian, After(|_, y| symmetrise_pair(y, 0, [0, 1]))),
    ("degrees", "element.euler_parameters", Jacobian, Before(|x| x[0] *= PI / 180.0)),
    (
        "degrees, and derivatives with respect to them",
        "element.euler_parameters",
        Jacobian,
        Both(|x| x[0] *= PI / 180.0, |_, y| (0..4).for_each(|i| y[4 + 7 * i] *= PI / 180.0)),
    ),
    ("to degrees", "element.euler_parameters", Value, Before(|x| x[0] *= 180.0 / PI)),
    ("sign of an input", "slot.friction", Jacobian, Before(|x| x[3] *= -1.0)),
    ("an input twice", "slot.friction", Jacobian, Before(|x| x[1] *= 2.0)),
    ("half of an input", "slider.line", Jacobian, Before(|x| x[..3].iter_mut().for_each(|x| *x *= 0.5))),
    ("components of an input", "slider.line", Jacobian, Before(|x| x.swap(3, 5))),
    ("inputs", "slot.friction", Jacobian, Before(|x| x.swap(0, 2))),
    (
        "inputs, and derivatives with respect to them",
        "slot.friction",
        Jacobian,
        Both(|x| x.swap(0, 2), |_, y| (0..3).for_each(|i| y.swap(3 + 5 * i, 3 + 5 * i + 2))),
    ),
    ("inputs of single precision", "slot.friction", Jacobian, Before(|x| x.iter_mut().for_each(|x| *x = single(*x)))),
    (
        "results of single precision",
        "slot.friction",
        Jacobian,
        After(|_, y| y.iter_mut().for_each(|y| *y = single(*y))),
    ),
    ("squares", "slot.contact_force", Value, After(|x, y| y[0] = (x[0] * x[0] + x[1] * x[1]).sqrt())),
    ("a sign in the value", "coulomb.yield", Value, After(|x, y| y[0] = x[0] + x[1] * x[2])),
    (
        "a sign, and its derivatives",
        "coulomb.yield",
        Jacobian,
        After(|x, y| y.copy_from_slice(&[x[0] + x[1] * x[2], 1.0, x[2], x[1]])),
    ),
    (
        "another sign, and the first derivative",
        "coulomb.yield",
        Jacobian,
        After(|x, y| (y[0], y[1]) = (-x[0] - x[1] * x[2], -1.0)),
    ),
    ("nearly a sign", "coulomb.yield", Value, After(|x, y| y[0] = (x[0] + x[1] * x[2]) * (1.0 + 1e-11))),
    ("what never changes", "coulomb.yield", Jacobian, After(|_, y| y[1] = 1.75)),
    ("a branch always", "coulomb.return_map", Jacobian, After(|x, y| y.copy_from_slice(&[x[0], 1.0, 0.0, 0.0]))),
    ("a branch never", "coulomb.return_map", Value, After(|x, y| y[0] = slips(x))),
    (
        "branches exchanged",
        "coulomb.return_map",
        Value,
        After(|x, y| y[0] = if x[0].abs() < x[1] * x[2] { slips(x) } else { x[0] }),
    ),
    ("a factor of two results, in slip", "coulomb.return_map_2d", Jacobian, After(slip_tangent_without_factor)),
    ("a term", "slot.normal_force", Value, After(|x, y| y[0] = x[0].abs())),
    ("another input", "slot.friction", Value, After(|x, y| (y[1], y[2]) = friction(x, x[1].hypot(x[3])))),
    ("half of it explained", "slot.friction", Jacobian, After(|x, y| (y[0], y[PHI + 4]) = (-y[0], x[1]))),
    ("nothing explained", "slot.friction", Jacobian, After(|x, y| (y[0], y[PHI + 4]) = (x[2], x[1]))),
    (
        "NaN at a kink",
        "slot.contact_force",
        Jacobian,
        After(|x, y| {
            if y[0] == 0.0 {
                y[1] = x[0] / y[0];
            }
        }),
    ),
    (
        "NaN at a kink, and another convention",
        "slot.contact_force",
        Jacobian,
        After(|_, y| {
            if y[0] == 0.0 {
                y[1..].copy_from_slice(&[0.6, f64::NAN]);
            }
        }),
    ),
    (
        "a convention at a kink",
        "slot.contact_force",
        Jacobian,
        After(|_, y| {
            if y[0] == 0.0 {
                y[1..].fill(0.6);
            }
        }),
    ),
    (
        "a point alone",
        "slot.contact_force",
        Jacobian,
        After(|x, y| {
            if x == [3.0, 4.0] {
                y[0] += 1.0;
            }
        }),
    ),
    ("an input, with gaps", "slot.friction", Jacobian, Gaps(|x| x[3] *= -1.0, |_, _| {})),
    ("a factor, with gaps", "slot.friction", Jacobian, Gaps(|_| {}, |_, y| y[FN + 9] *= -2.0)),
    (
        "a sign, with gaps",
        "coulomb.yield",
        Jacobian,
        Gaps(|_| {}, |x, y| y.copy_from_slice(&[x[0] + x[1] * x[2], 1.0, x[2], x[1]])),
    ),
    (
        "an index, with gaps",
        "slot.friction",
        Jacobian,
        Gaps(|_| {}, |_, y| (y[FN + 2], y[FN + 9]) = (y[FN + 1], y[FN + 1])),
    ),
    (
        "a matrix of values",
        "universal.geometric_stiffness",
        Value,
        After(|_, y| [(1, 3), (2, 6), (5, 7)].iter().for_each(|&(a, b)| y.swap(a, b))),
    ),
    (
        "0 beside what is large",
        "slot.contact_force",
        Value,
        After(|x, y| {
            if x.contains(&0.0) {
                y[0] = 0.0;
            }
        }),
    ),
    ("sign of a product", "slot.friction", Products, After(|_, y| y[5] *= -1.0)),
    ("another function", "coulomb.yield", Products, After(|_, y| y.iter_mut().for_each(|y| *y *= 3.0))),
    ("nothing of products", "slot.friction", Products, After(|_, y| y.fill(0.0))),
    ("a product by one input", "slot.friction", Products, After(|_, y| y[7] *= 2.0)),
];

/// The indices of the first derivatives of the outputs fn and phi of `slot.friction`.
const FN: usize = 8;
const PHI: usize = 13;

fn scale(numbers: &mut [f64], factors: &[(usize, f64)]) {
    for &(k, factor) in factors {
        numbers[k] *= factor;
    }
}

/// The Jacobian of `slot.friction` with entries from elsewhere.
fn move_entries(numbers: &mut [f64], from: fn(usize) -> usize) {
    let jacobian = numbers[3..].to_vec();
    (0..15).for_each(|k| numbers[3 + k] = jacobian[from(k)]);
}

/// Transposes the derivatives of the output of `element.rotation_vector` with respect to the input that starts at this index.
fn transpose_block(numbers: &mut [f64], first: usize) {
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        numbers.swap(3 + 6 * i + first + j, 3 + 6 * j + first + i);
    }
}

fn exchange_rows(numbers: &mut [f64], [m, n]: [usize; 2], a: usize, b: usize) {
    numbers.swap(a, b);
    (0..n).for_each(|j| numbers.swap(m + n * a + j, m + n * b + j));
}

/// The symmetric part of a matrix of `universal.geometric_stiffness`, with its derivatives with respect to seven inputs.
fn symmetrise(numbers: &mut [f64], first: usize) {
    for pair in [[0, 1], [0, 2], [1, 2]] {
        symmetrise_pair(numbers, first, pair);
    }
}

/// The same for two entries of it.
fn symmetrise_pair(numbers: &mut [f64], first: usize, [i, j]: [usize; 2]) {
    let (a, b) = (first + 3 * i + j, first + 3 * j + i);
    let mut halve = |a: usize, b: usize| {
        let half = f64::midpoint(numbers[a], numbers[b]);
        (numbers[a], numbers[b]) = (half, half);
    };
    halve(a, b);
    (0..7).for_each(|k| halve(27 + 7 * a + k, 27 + 7 * b + k));
}

#[expect(clippy::cast_possible_truncation, reason = "the mistake that is planted")]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The normal force and Φ of `slot.friction` with another contact force.
fn friction(x: &[f64], fc: f64) -> (f64, f64) {
    let normal = (fc + x[3]).abs();
    (normal, x[0].abs() - x[4] * normal)
}

/// The tangent of `coulomb.return_map_2d` where it slips, without μ `F_N` / |f|.
fn slip_tangent_without_factor(x: &[f64], y: &mut [f64]) {
    let (trial, limit) = (x[0].hypot(x[1]), x[2] * x[3]);
    if trial >= limit && trial > 0.0 {
        let [a, b] = [x[0], x[1]].map(|component| component / trial);
        (y[2], y[3], y[6], y[7]) = (b * b, -a * b, -a * b, a * a);
    }
}

/// The force transmitted by `coulomb.return_map` during slip.
fn slips(x: &[f64]) -> f64 {
    if x[0] == 0.0 { 0.0 } else { (x[1] * x[2]).copysign(x[0]) }
}
