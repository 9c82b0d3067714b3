//! The tables of the kinds.

use super::check::check;
use super::dimension::Dimension;
use super::isl::{ISL21A, ISL22A};
use super::parts::{ALIGN, JOIN, UNIVERSAL};
use super::slider::{SLIDER, SLIDER_2D, SLIDER_AXISYMMETRIC};
use super::slot::{SLOT, SLOT_2D};
use super::table::Kind;
use super::translator::TRANSLATOR;
use super::ujoint::UJOINT;

/// Every kind of element.
static KINDS: [Kind; 12] = TABLES;
const TABLES: [Kind; 12] =
    [SLOT, SLOT_2D, TRANSLATOR, ALIGN, UJOINT, JOIN, UNIVERSAL, SLIDER, SLIDER_2D, SLIDER_AXISYMMETRIC, ISL21A, ISL22A];

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
