//! The arguments of a UEL that is an element of the catalog.

use jointproof::catalog::AnyForm;
use jointproof::formula::Field;
use jointproof::toolkit::verify::Layout;
use std::collections::BTreeMap;

/// How the arguments of a UEL are made of an element's inputs: PROPS are the orientations of the nodes at the start, then the
/// parameters, SVARS the state; the multipliers are the degrees of freedom of a last node.
pub(crate) struct Interface {
    pub(crate) layout: Layout,
    /// The numbers of coordinates and of nodes.
    pub(crate) mcrd: usize,
    pub(crate) nodes: usize,
    /// Where the orientations of each node are among the inputs: vectors of each.
    pub(crate) triads: Vec<Vec<usize>>,
    /// Where the position of each node is among the inputs.
    pub(crate) positions: Vec<usize>,
}

pub(crate) fn len(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

impl Interface {
    pub(crate) fn new(element: &dyn AnyForm) -> Self {
        let layout = element.layout();
        let (mut triads, mut positions): (BTreeMap<String, Vec<usize>>, _) = (BTreeMap::new(), Vec::new());
        let (mut at, mut mcrd) = (0, 3);
        for field in layout.nodes {
            if is_position(field) {
                positions.push(at);
                mcrd = field.len();
            } else {
                // The orientation of a node ends with its name: e1a, e2a, e3a.
                triads.entry(field.name[2..].to_owned()).or_default().push(at);
            }
            at += field.len();
        }
        let internal = usize::from(!layout.multipliers.is_empty());
        Self { mcrd, nodes: positions.len() + internal, triads: triads.into_values().collect(), positions, layout }
    }

    pub(crate) fn ndofel(&self) -> usize {
        len(self.layout.unknowns) + len(self.layout.multipliers)
    }

    pub(crate) fn orientations(&self) -> usize {
        self.triads.iter().map(|triad| triad.len() * self.mcrd).sum()
    }

    /// The number of properties; an array has one at least.
    pub(crate) fn nprops(&self) -> usize {
        (self.orientations() + len(self.layout.start) + len(self.layout.contact)).max(1)
    }

    /// The number of masses that a VUEL needs: of translations, and of rotations if it has any.
    pub(crate) fn masses(&self) -> usize {
        1 + usize::from(self.layout.unknowns.iter().any(is_rotation))
    }

    /// The number of states; an array has one at least.
    pub(crate) fn svars(&self) -> usize {
        len(self.layout.state).max(1)
    }
}

/// Whether an input of a node is its position, and not its orientation.
pub(crate) fn is_position(field: &Field) -> bool {
    field.name.starts_with('x')
}

/// Whether a degree of freedom is a rotation.
pub(crate) fn is_rotation(field: &Field) -> bool {
    field.name.starts_with('t')
}

/// The place of each field in an array, from this place on.
pub(crate) fn places(fields: &'static [Field], mut from: usize) -> Vec<(String, &'static Field)> {
    let place = |field: &'static Field| {
        let to = from + field.len() - 1;
        let range = if to > from { format!("{from}-{to}") } else { from.to_string() };
        from = to + 1;
        (range, field)
    };
    fields.iter().map(place).collect()
}

/// The degrees of freedom of Abaqus: 1-3 are translations, 4-6 rotations.
pub(crate) fn degrees(unknown: &Field, mcrd: usize) -> Vec<usize> {
    match (is_rotation(unknown), mcrd) {
        (false, mcrd) => (1..=mcrd).collect(),
        (true, 3) => vec![4, 5, 6],
        (true, _) => vec![6],
    }
}
