//! The kinds of elements: the given quantities of each, its formulas, and its outputs with their names.
//!
//! The tables contain only what is not defined elsewhere. Formulas are wired by the names of their fields: an input `x` is read
//! from the output `x` of another formula, or from a given quantity of the element with that name. The meaning of a name, its
//! unit and its allowed values are defined by the field's [`Quantity`](crate::formula::quantity::Quantity).

mod check;
mod dimension;
mod hinge;
mod isl;
mod parts;
mod shared;
mod slider;
mod slot;
mod table;
mod translator;
mod ujoint;

pub use dimension::Dimension;
pub use table::{Fallback, Kind, Origin, Use, When};

use self::check::check;
use self::hinge::{HINGE, REVOLUTE};
use self::isl::{ISL21A, ISL22A};
use self::parts::{ALIGN, JOIN, UNIVERSAL};
use self::slider::{SLIDER, SLIDER_2D, SLIDER_AXISYMMETRIC};
use self::slot::{SLOT, SLOT_2D};
use self::translator::TRANSLATOR;
use self::ujoint::UJOINT;

/// Every kind of element.
static KINDS: [Kind; 14] = TABLES;
const TABLES: [Kind; 14] = [
    SLOT,
    SLOT_2D,
    TRANSLATOR,
    ALIGN,
    UJOINT,
    HINGE,
    REVOLUTE,
    JOIN,
    UNIVERSAL,
    SLIDER,
    SLIDER_2D,
    SLIDER_AXISYMMETRIC,
    ISL21A,
    ISL22A,
];

const _: () = {
    let mut k = 0;
    while k < TABLES.len() {
        check(&TABLES[k]);
        k += 1;
    }
};

impl Kind {
    /// Every kind.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        KINDS.iter()
    }

    /// The kind of this name and dimension.
    pub fn find(name: &str, dimension: Dimension) -> Option<&'static Self> {
        Self::all().find(|kind| kind.name == name && kind.dimension == dimension)
    }
}
