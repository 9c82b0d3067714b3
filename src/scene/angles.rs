//! The unit of the angles in a file.

use std::f64::consts::PI;

/// The unit of the angles that a scene gives: parameters, orientations and rotations of nodes, as numbers or as arrays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::scene) enum AngleUnit {
    /// Radians, by default.
    #[default]
    Unsaid,
    Radians,
    Degrees,
}

impl AngleUnit {
    /// The units that a scene can name.
    pub(in crate::scene) const NAMES: [(&'static str, Self); 2] =
        [("radians", Self::Radians), ("degrees", Self::Degrees)];

    /// An angle in radians. Half a turn and its multiples are the nearest doubles.
    #[inline]
    pub(in crate::scene) fn radians(self, angle: f64) -> f64 {
        if self == Self::Degrees { angle / 180.0 * PI } else { angle }
    }
}

#[cfg(test)]
mod tests {
    use super::AngleUnit;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

    #[test]
    fn parts_and_multiples_of_half_a_turn_are_the_nearest_doubles() {
        let degrees = [0.0, 45.0, 90.0, 180.0, -180.0, 360.0, 1080.0].map(|angle| AngleUnit::Degrees.radians(angle));
        assert_eq!(degrees, [0.0, FRAC_PI_4, FRAC_PI_2, PI, -PI, TAU, 6.0 * PI]);
        assert_eq!([AngleUnit::Unsaid, AngleUnit::Radians].map(|unit| unit.radians(90.0)), [90.0; 2]);
    }
}
