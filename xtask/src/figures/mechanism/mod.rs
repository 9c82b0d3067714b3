//! The mechanisms, drawn from results of the formulas: positions and directions of forces come from `eval`.

mod along;
mod contact;
mod cross;
mod hinge;
mod line;
mod pose;
mod slot;

use kit::Moving;

/// Every mechanism, with the name used in `{{#figure name}}`.
pub(super) fn all() -> Vec<Moving> {
    vec![
        slot::slot("introduction-moving"),
        slot::slot("slot-moving"),
        pose::align(),
        slot::translator(),
        cross::cardan(),
        pose::join(),
        cross::universal(),
        cross::forces(),
        hinge::hinge(),
        line::slider(),
        line::smoothed(),
        contact::stick_and_slip(),
        contact::pressure(),
        contact::torque(),
    ]
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
}
