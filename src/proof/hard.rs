//! Points of interest, declared once: every formula that takes positions, norms or loads is tested on these.

use nalgebra::{SVector, Vector2, Vector3};

/// A named value, and what is hard about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hard<T> {
    /// Part of the case's identifier.
    pub id: &'static str,
    /// What is hard about it.
    pub comment: &'static str,
    /// The value.
    pub value: T,
}

impl<T> Hard<T> {
    /// A hard value.
    pub const fn new(id: &'static str, comment: &'static str, value: T) -> Self {
        Self { id, comment, value }
    }
}

/// Positions of two nodes: common offsets with unit distance, and distances from 1e-12 to 1e12.
pub fn places<const N: usize>() -> Vec<Hard<[SVector<f64, N>; 2]>> {
    let near = |offset: f64, distance: f64| {
        let base = SVector::from_fn(|k, _| [offset, -offset, offset][k % 3]);
        let step = SVector::from_fn(|k, _| [0.75, -0.5, 0.4375][k % 3] * distance);
        [base, base + step]
    };
    let cancels = "common offset: the difference must be taken before any product";
    vec![
        Hard::new("offset-1e8", cancels, near(1e8, 1.0)),
        Hard::new("offset-1e12", cancels, near(1e12, 1.0)),
        Hard::new("distance-1e-12", "nodes that nearly coincide", near(0.0, 1e-12)),
        Hard::new("distance-1e12", "nodes far apart", near(0.0, 1e12)),
        Hard::new("coincident", "both nodes at one place", near(0.5, 0.0)),
    ]
}

/// Components of a norm: zero, one component alone, squares that under- or overflow, components of very different size.
pub fn norms<const N: usize>() -> Vec<Hard<[f64; N]>> {
    let with = |scale: f64, others: f64| {
        let mut components = [others; N];
        components[0] = scale;
        components
    };
    let pattern = |scale: f64| std::array::from_fn(|k| [3.0, -4.0, 12.0][k % 3] * scale);
    vec![
        Hard::new("zero", "the zero vector: derivative 0 by convention", [0.0; N]),
        Hard::new("first-alone", "one component alone", with(-2.5, 0.0)),
        Hard::new(
            "last-alone",
            "the other component alone",
            std::array::from_fn(|k| if k + 1 == N { 2.5 } else { 0.0 }),
        ),
        Hard::new("tiny", "squares underflow", pattern(1e-200)),
        Hard::new("huge", "squares overflow", pattern(1e200)),
        Hard::new("subnormal", "subnormal components", pattern(1e-310)),
        Hard::new("uneven", "one component 1e-17 of the other", with(1.0, 1e-17)),
    ]
}

/// As [`norms`], for loads that are multiplied before a norm is taken: subnormal ones would lose their digits there.
pub fn loads<const N: usize>() -> Vec<Hard<[f64; N]>> {
    norms().into_iter().filter(|load| load.id != "subnormal").collect()
}

/// Length and radius of an arm, from stubby to slender.
pub fn arms() -> Vec<Hard<[f64; 2]>> {
    vec![
        Hard::new("rigid", "λ = 1e-200: the limit of a rigid arm, to every digit", [1e-200, 1.0]),
        Hard::new("slender", "λ = 1e200: the limit of a slender arm, to every digit", [1.0, 1e-200]),
        Hard::new("lambda-1e-12", "a disc with pins", [3e-12, 3.0]),
        Hard::new("lambda-1e-4", "a stubby arm", [2e-4, 2.0]),
        Hard::new("lambda-1", "as long as thick", [0.7, 0.7]),
        Hard::new("lambda-2.1", "near φ = 2, where a Timoshenko arm would turn negative", [2.1, 1.0]),
        Hard::new("lambda-20", "where slender arms begin", [5.0, 0.25]),
        Hard::new("lambda-1e12", "a hair", [3.0, 3e-12]),
        Hard::new("large", "lengths of 1e200", [3e200, 1e200]),
        Hard::new("small", "lengths of 1e-150", [3e-150, 1e-150]),
    ]
}

/// Length and radius of an arm of extreme slenderness, and an extreme size for its loads.
pub fn loaded_arms() -> Vec<Hard<[f64; 3]>> {
    let both = "an extreme arm under extreme loads";
    vec![
        Hard::new("lambda-1e-12-loads-1e-150", both, [3e-12, 3.0, 1e-150]),
        Hard::new("lambda-1e-12-loads-1e150", both, [3e-12, 3.0, 1e150]),
        Hard::new("lambda-1e12-loads-1e-150", both, [3.0, 3e-12, 1e-150]),
        Hard::new("lambda-1e12-loads-1e150", both, [3.0, 3e-12, 1e150]),
    ]
}

/// A triad in space away from every axis, right to an ulp: the quaternion (1, 2, 3, 4)/√30.
pub fn triad() -> [Vector3<f64>; 3] {
    FIFTEENTHS.map(|row| Vector3::from(row) / 15.0)
}

/// The components of [`triad`] in fifteenths.
pub(crate) const FIFTEENTHS: [[f64; 3]; 3] = [[-10.0, 10.0, 5.0], [2.0, -5.0, 14.0], [11.0, 10.0, 2.0]];

/// A direction in the plane away from both axes (5-12-13), and its left normal.
pub fn plane_triad() -> [Vector2<f64>; 2] {
    [Vector2::new(5.0, 12.0) / 13.0, Vector2::new(-12.0, 5.0) / 13.0]
}
