//! The mechanisms, drawn by the formulas: where things are and which way forces point comes from `eval`.

mod contact;
mod cross;
mod line;
mod slot;

use jointproof::cardan::{CardanAngles, Triads};
use jointproof::formula::Formula;
use kit::{Moving, Slider};
use nalgebra::{Rotation3, Vector3};

use super::sketch::Point;

/// Every mechanism, by the name that `{{#figure name}}` gives.
pub(super) fn all() -> Vec<Moving> {
    vec![
        slot::slot("introduction-moving"),
        slot::slot("slot-moving"),
        slot::translator(),
        cross::cardan(),
        cross::universal(),
        cross::forces(),
        line::slider(),
        line::smoothed(),
        contact::stick_and_slip(),
        contact::pressure(),
        contact::torque(),
    ]
}

/// A slider from one value to another in so many steps.
struct Along {
    label: &'static str,
    /// What stands behind each value.
    unit: &'static str,
    from: f64,
    to: f64,
    steps: u32,
    start: usize,
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
fn moving(name: &str, sliders: &[Along; 2], draw: impl Fn(f64, f64) -> String) -> Moving {
    let [first, second] = sliders.each_ref().map(Along::values);
    let frames = first.iter().flat_map(|&x| second.iter().map(move |&y| (x, y))).map(|(x, y)| draw(x, y)).collect();
    Moving { name: name.into(), sliders: sliders.iter().map(Along::slider).collect(), frames }
}

/// The triad of b, turned against that of a by the Cardan angles, in degrees.
fn turned(alpha: f64, beta: f64, gamma: f64) -> [Point; 3] {
    let about = |axis: Vector3<f64>, degrees: f64| Rotation3::new(axis * degrees.to_radians());
    let turn = about(Vector3::x(), alpha) * about(Vector3::y(), beta) * about(Vector3::z(), gamma);
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis)
}

/// The angles that the formula finds between two triads, in degrees.
fn angles(a: [Point; 3], b: [Point; 3]) -> [f64; 3] {
    let found = CardanAngles::eval(&Triads::new(a, b));
    [found.alpha, found.beta, found.gamma].map(|angle: f64| angle.to_degrees())
}

/// The triad of a: the axes of the drawing.
fn upright() -> [Point; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_position_of_every_mechanism_is_drawn_and_something_moves() {
        for moving in all() {
            let count: usize = moving.sliders.iter().map(|slider| slider.values.len()).product();
            assert_eq!(moving.frames.len(), count, "{}", moving.name);
            assert!(moving.still().is_some(), "{}", moving.name);
            let lines = moving.frames[0].lines().count();
            for frame in &moving.frames {
                assert_eq!(frame.lines().count(), lines, "{}: positions differ in their number of lines", moving.name);
                assert!(!frame.contains("NaN") && !frame.contains("inf"), "{}", moving.name);
            }
            let mut frames = moving.frames.clone();
            frames.dedup();
            assert!(frames.len() > count / 2, "{} hardly moves", moving.name);
        }
    }

    #[test]
    fn the_angles_that_are_shown_are_those_of_the_sliders() {
        let found = angles(upright(), turned(30.0, -20.0, 50.0));
        for (found, set) in found.iter().zip([30.0, -20.0, 50.0]) {
            assert!((found - set).abs() < 1e-12, "{found} {set}");
        }
    }
}
