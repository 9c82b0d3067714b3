//! Contact: friction, interaction laws, and slide lines with the elements that slide along them.

pub mod coulomb;
#[cfg(feature = "scene")]
pub mod increments;
pub mod interaction;
pub mod isl;
pub mod slide_line;
