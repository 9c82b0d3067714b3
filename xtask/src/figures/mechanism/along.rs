//! Common parts of the mechanisms: sliders and rotated triads.

use jointproof::element::cardan::{CardanAngles, Triads};
use jointproof::formula::Formula;
use kit::{Moving, Slider};
use nalgebra::{Rotation3, Vector3};

use crate::figures::sketch::Point;

/// A slider from one value to another in `steps` steps.
pub(super) struct Along {
    pub(super) label: &'static str,
    /// The unit written after each value.
    pub(super) unit: &'static str,
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) steps: u32,
    pub(super) start: usize,
}

impl Along {
    fn values(&self) -> Vec<f64> {
        (0..=self.steps).map(|k| self.from + (self.to - self.from) * f64::from(k) / f64::from(self.steps)).collect()
    }

    fn slider(&self) -> Slider {
        let shown =
            |x: f64| format!("{}{}", ((x * 100.0).round() / 100.0 + 0.0).to_string().replace('-', "−"), self.unit);
        Slider { label: self.label.into(), values: self.values().into_iter().map(shown).collect(), start: self.start }
    }
}

/// A figure with two sliders.
pub(super) fn moving(name: &str, sliders: &[Along; 2], draw: impl Fn(f64, f64) -> String) -> Moving {
    let [first, second] = sliders.each_ref().map(Along::values);
    let frames = first.iter().flat_map(|&x| second.iter().map(move |&y| (x, y))).map(|(x, y)| draw(x, y)).collect();
    Moving { name: name.into(), sliders: sliders.iter().map(Along::slider).collect(), frames }
}

/// The triad of b, rotated relative to that of a by the Cardan angles, in degrees.
pub(super) fn turned(alpha: f64, beta: f64, gamma: f64) -> [Point; 3] {
    let about = |axis: Vector3<f64>, degrees: f64| Rotation3::new(axis * degrees.to_radians());
    let turn = about(Vector3::x(), alpha) * about(Vector3::y(), beta) * about(Vector3::z(), gamma);
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis)
}

/// The angles between two triads computed by the formula, in degrees.
pub(super) fn angles(a: [Point; 3], b: [Point; 3]) -> [f64; 3] {
    let found = CardanAngles::eval(&Triads::new(a, b));
    [found.alpha, found.beta, found.gamma].map(|angle: f64| angle.to_degrees())
}

/// The triad of a: the axes of the drawing.
pub(super) fn upright() -> [Point; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angles_that_are_shown_are_those_of_the_sliders() {
        let found = angles(upright(), turned(30.0, -20.0, 50.0));
        for (found, set) in found.iter().zip([30.0, -20.0, 50.0]) {
            assert!((found - set).abs() < 1e-12, "{found} {set}");
        }
    }
}
