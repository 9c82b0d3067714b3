//! Slide lines in a model: defined by node numbers, placed at the positions of the nodes, searched as a whole.

mod definition;
mod interpolation;
mod nodes;
mod path;
mod place;
mod placed;
mod tree;

pub use definition::SlideLine;
pub use interpolation::Interpolation;
pub use nodes::Nodes;
pub(crate) use nodes::check_position;
pub(crate) use path::gauss;
pub(crate) use place::Foot;
pub use place::{ClosestPoint, OverclosureVariation, Place};
pub use placed::PlacedLine;
