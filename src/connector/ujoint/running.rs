//! The state that the chapter on UJOINT follows from the centre of the cross to the friction in its hinges: the triad of a is that of
//! the global axes, sin α = 0.6 and λ = 2, so that every number of the chain has few digits.

use nalgebra::Vector3;

/// The third axis of b.
pub(crate) const E3B: Vector3<f64> = Vector3::new(0.0, -0.6, 0.8);
/// The components of the force.
pub(crate) const FORCE: [f64; 3] = [-4.4, -4.1, 18.8];
/// What they are along e1a, along e3b and normal to both.
pub(crate) const PARTS: [f64; 3] = [-4.4, 17.5, -8.0];
/// The twisting moment.
pub(crate) const M2: f64 = 59.36;
/// The pin: its radius, the length of the arm, and the overlap.
pub(crate) const RP: f64 = 1.05;
/// See [`RP`].
pub(crate) const LA: f64 = 2.1;
/// See [`RP`].
pub(crate) const LS: f64 = 2.0;
