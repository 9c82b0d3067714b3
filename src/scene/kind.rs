//! The kinds of elements. The table of each is in the folder of its connector.

pub use crate::element::table::{Dimension, Fallback, Kind, Origin, Use, When};

use crate::connector::align::table::ALIGN;
use crate::connector::hinge::table::HINGE;
use crate::connector::join::table::JOIN;
use crate::connector::revolute::table::REVOLUTE;
use crate::connector::slider::table::{SLIDER, SLIDER_2D, SLIDER_AXISYMMETRIC};
use crate::connector::slot::table::{SLOT, SLOT_2D};
use crate::connector::translator::table::TRANSLATOR;
use crate::connector::ujoint::table::UJOINT;
use crate::connector::universal::table::UNIVERSAL;
use crate::contact::isl::table::{ISL21A, ISL22A};
use crate::element::table::check;

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

    /// Whether it has a cross, whose arms e1a and e3b keep their angle and must not become parallel.
    pub(crate) fn has_cross(&self) -> bool {
        self.given("c0").is_some()
    }

    /// The kind of this name and dimension.
    pub fn find(name: &str, dimension: Dimension) -> Option<&'static Self> {
        Self::all().find(|kind| kind.name == name && kind.dimension == dimension)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parameters of a kind whose bits are set.
    fn switches(kind: &str, dimension: Dimension) -> Vec<&'static str> {
        let kind = Kind::find(kind, dimension).unwrap();
        let switches = kind.switches();
        assert!(switches.checked_shr(u32::try_from(kind.parameters().count()).unwrap()) == Some(0), "no other bit");
        let bits = kind.parameters().enumerate().filter(|(bit, _)| switches >> bit & 1 == 1);
        bits.map(|(_, (name, _))| name).collect()
    }

    #[test]
    fn a_parameter_has_a_bit_where_it_decides_about_a_formula_by_being_zero() {
        use Dimension::{Axisymmetric, Plane, Space};
        for (kind, dimension, expected) in [
            ("slot", Space, &["mu"][..]),
            ("slot", Plane, &["mu"]),
            ("align", Space, &[]),
            ("join", Space, &[]),
            ("universal", Space, &[]),
            ("slider", Space, &[]),
            ("isl21a", Axisymmetric, &[]),
        ] {
            assert_eq!(switches(kind, dimension), expected, "{kind}");
        }
        let mut of_translator = switches("translator", Space);
        of_translator.sort_unstable();
        assert_eq!(of_translator, ["l", "mu", "rr"]);
    }
}
