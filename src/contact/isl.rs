//! ISL21A and ISL22A: the axisymmetric elements that slide along a slide line.
//!
//! The elements are the slave surface, a [slide line](crate::contact::slide_line) is the master surface. [`Contact`] associates a
//! set of elements with a line and with an [`Interaction`]; from the positions of the nodes it computes, increment by increment,
//! at every slave node the separation E11, the slip E12, the pressure S11 and the shear stress S12, the forces on slave and
//! master nodes, and the torque that the line can transmit. [`TorquePrint`] tabulates the torque.
//!
//! | sign | |
//! |---|---|
//! | E11 | positive when open, along n |
//! | E12 | positive when the slave has moved along t, the sequence of the line's nodes |
//! | S11 | positive when it pushes the slave along n |
//! | S12 | positive when it resists positive slip, pushing the slave along −t |
//!
//! Forces and areas are those of the whole circumference. All quantities are in the axes (r, z), in any consistent units.
//!
//! ```
//! use jointproof::contact::isl::{Contact, ElementSet, Increment, Interaction, IslElement};
//! use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
//!
//! // A ring of radius 2 presses from above on a flat washer.
//! let washer = SlideLine::new(Interpolation::Linear, [1, 2])?;
//! let ring = ElementSet::new("ring", [IslElement::isl21a(10, [3, 4])?])?;
//! let contact = Contact::new(washer, ring, Interaction::linear(1000.0)?.with_friction(0.25, 5000.0)?);
//!
//! let at = |slave_r: f64, slave_z: f64| {
//!     Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [slave_r, slave_z]), (4, [slave_r + 0.5, slave_z])])
//! };
//! let start = contact.start(at(2.0, 0.125)?)?;
//! let state = contact.advance(&start, at(2.0, -0.125)?, &Increment::new(1.0)?)?;
//! let state = contact.advance(&state, at(2.25, -0.125)?, &Increment::new(1.0)?)?;
//!
//! let node = state.node(3)?;
//! assert_eq!((node.e11, node.s11), (-0.125, 125.0));
//! assert_eq!((node.e12, node.s12), (0.25, 31.25)); // it slips: 0.25 × 125
//! assert_eq!(contact.torque(&state)?, 125.0 * 2.0 * std::f64::consts::PI * (2.75_f64.powi(3) - 2.25_f64.powi(3)) / 3.0);
//! # Ok::<(), jointproof::Error>(())
//! ```

mod contact;
mod element;
#[cfg_attr(not(feature = "scene"), expect(dead_code, reason = "scenes ask for a part of it, and count what ran"))]
mod engine;
mod interaction;
mod state;
#[cfg(feature = "scene")]
pub(crate) mod table;
mod torque_print;

pub use contact::{Contact, Increment};
pub use element::{ElementSet, IslElement};
#[cfg(feature = "scene")]
pub(crate) use engine::{
    Culprit, Failure, Motion, Slave, SlaveState, Stage, Surface, Tally, Wanted, areas, torque, total_torque,
};
pub use interaction::{Interaction, Pressure};
pub use state::{ContactState, SlaveNode};
pub use torque_print::{TorquePrint, TorqueRow};
