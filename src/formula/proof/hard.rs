//! Points of interest, declared once: every formula with positions, norms or loads as inputs is tested at these.

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
        Hard::new("coincident", "both nodes coincide", near(0.5, 0.0)),
    ]
}

/// Components of a norm: zero, a single component, squares that under- or overflow, components of very different size.
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

/// As [`norms`], for loads that are multiplied before a norm is taken: subnormal ones would lose digits there.
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

/// A triad in space away from every axis, accurate to an ulp: the quaternion (1, 2, 3, 4)/√30.
pub fn triad() -> [Vector3<f64>; 3] {
    FIFTEENTHS.map(|row| Vector3::from(row) / 15.0)
}

/// The global triad rotated by a quaternion of any length, the same on every machine.
pub fn turned(quaternion: [f64; 4]) -> [Vector3<f64>; 3] {
    let [w, x, y, z] = quaternion;
    let per = 2.0 / (w * w + x * x + y * y + z * z);
    let diagonal = |p: f64, q: f64| 1.0 - (p * p + q * q) * per;
    [
        Vector3::new(diagonal(y, z), (x * y + z * w) * per, (x * z - y * w) * per),
        Vector3::new((x * y - z * w) * per, diagonal(x, z), (y * z + x * w) * per),
        Vector3::new((x * z + y * w) * per, (y * z - x * w) * per, diagonal(x, y)),
    ]
}

/// The components of [`triad`] in fifteenths.
pub(crate) const FIFTEENTHS: [[f64; 3]; 3] = [[-10.0, 10.0, 5.0], [2.0, -5.0, 14.0], [11.0, 10.0, 2.0]];

/// A direction in the plane away from both axes (5-12-13), and its left normal.
pub fn plane_triad() -> [Vector2<f64>; 2] {
    [Vector2::new(5.0, 12.0) / 13.0, Vector2::new(-12.0, 5.0) / 13.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// The number that follows a word in an identifier.
    fn named(id: &str, word: &str) -> Option<f64> {
        let said = id.split_once(word)?.1;
        let end = said.find("-loads").unwrap_or(said.len());
        said[..end].parse().ok()
    }

    fn is(found: f64, said: f64) -> bool {
        (found / said - 1.0).abs() < 1e-15 * 2.0
    }

    #[test]
    fn arms_are_as_slender_and_as_loaded_as_they_are_called() {
        let slender = arms().into_iter().filter_map(|arm| Some((named(arm.id, "lambda-")?, arm.value)));
        assert_eq!(slender.filter(|(said, [length, radius])| is(length / radius, *said)).count(), 6);
        let extreme: Vec<_> = loaded_arms()
            .into_iter()
            .map(|arm| {
                let [length, radius, load] = arm.value;
                let [said, said_load] = ["lambda-", "loads-"].map(|word| named(arm.id, word).unwrap());
                assert!(is(length / radius, said) && load == said_load, "{}: {:?}", arm.id, arm.value);
                [said, said_load]
            })
            .collect();
        assert_eq!(extreme, [[1e-12, 1e-150], [1e-12, 1e150], [1e12, 1e-150], [1e12, 1e150]]);
    }

    #[test]
    fn places_are_as_far_apart_as_they_are_called() {
        let all = places::<3>();
        let ids: Vec<_> = all.iter().map(|place| place.id).collect();
        assert_eq!(ids, ["offset-1e8", "offset-1e12", "distance-1e-12", "distance-1e12", "coincident"]);
        for Hard { id, value: [a, b], .. } in &all {
            let far = named(id, "offset-").unwrap_or(if *id == "coincident" { 0.5 } else { 0.0 });
            let apart = named(id, "distance-").unwrap_or(if *id == "coincident" { 0.0 } else { 1.0 });
            assert_eq!(*a, Vector3::new(far, -far, far), "{id}");
            let step = Vector3::new(0.75, -0.5, 0.4375) * apart;
            assert!((b - a - step).amax() <= far * f64::EPSILON, "{id}");
        }
    }

    #[test]
    fn norms_are_of_every_size_and_loads_all_but_subnormal() {
        let all = norms::<2>();
        let values: Vec<_> = all.iter().map(|norm| norm.value).collect();
        let pattern = |scale: f64| [3.0 * scale, -4.0 * scale];
        let [tiny, huge, subnormal] = [1e-200, 1e200, 1e-310].map(pattern);
        assert_eq!(values, [[0.0; 2], [-2.5, 0.0], [0.0, 2.5], tiny, huge, subnormal, [1.0, 1e-17]]);
        let ids = |all: Vec<Hard<[f64; 2]>>| all.into_iter().map(|norm| norm.id).collect::<BTreeSet<_>>();
        let (norms, loads) = (ids(all), ids(loads()));
        assert_eq!(norms.difference(&loads).copied().collect::<Vec<_>>(), ["subnormal"]);
        assert_eq!(norms.len(), 7);
    }

    #[test]
    fn triads_are_rotations() {
        let [e1, e2, e3] = triad();
        assert!((e1.cross(&e2) - e3).amax() < 1e-15 && (e2.cross(&e3) - e1).amax() < 1e-15);
        assert!(e1.dot(&e2).abs() < 1e-15 && (e1.norm() - 1.0).abs() < 1e-15);
        let [t, n] = plane_triad();
        assert!((t.norm() - 1.0).abs() < 1e-15 && n == Vector2::new(-t.y, t.x));
    }
}
