//! The elements of a scene file.

use super::checks::Checks;
use super::columns::{Columns, Reference};
use super::given::Given;
use super::keys;
use super::names::{named_sets, refer, refer_all};
use super::outputs::Outputs;
use super::triads::Inherited;
use crate::formula::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::{Dimension, Kind};
use crate::scene::model::{Members, Named, Parameter, SceneElement, SceneLine, SceneNode};
use crate::scene::npz::{Array, Unfit};

/// The entries to which elements may refer.
pub(super) struct Known<'k> {
    pub(super) nodes: &'k Named<Option<SceneNode>>,
    pub(super) lines: &'k Named<Option<SceneLine>>,
    pub(super) columns: &'k Columns,
}

/// An element, or a set of elements, as far as it was readable.
pub(super) enum Draft {
    Whole(SceneElement),
    /// With a fault: the kind and the nodes that are nevertheless known.
    Faulty(Option<&'static Kind>, Vec<Members>),
}

impl Draft {
    pub(super) fn kind(&self) -> Option<&'static Kind> {
        match self {
            Self::Whole(element) => Some(element.kind),
            Self::Faulty(kind, _) => *kind,
        }
    }

    pub(super) fn nodes(&self) -> &[Members] {
        match self {
            Self::Whole(element) => &element.nodes,
            Self::Faulty(_, nodes) => nodes,
        }
    }

    pub(super) fn whole(self) -> Option<SceneElement> {
        match self {
            Self::Whole(element) => Some(element),
            Self::Faulty(..) => None,
        }
    }
}

pub(super) fn elements_of(
    reader: &mut Reader,
    dimension: Dimension,
    known: &Known,
    wanted: &Outputs,
    inherited: &mut Inherited,
) -> Read<Named<Draft>> {
    let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
    let masks: Vec<_> = kinds.iter().map(|kind| wanted.mask(kind)).collect();
    let mut checks = Checks::default();
    let elements = named_sets(reader, |reader, _| {
        let place = reader.place();
        let Some(index) = kind_of(reader, &kinds)? else { return Ok((None, Draft::Faulty(None, Vec::new()))) };
        reader.go(place);
        let parts = Parts::read(reader, kinds[index], known)?;
        let outputs = parts.outputs.unwrap_or(masks[index]);
        inherited.check(reader, place, parts.kind, parts.nodes.as_deref().unwrap_or_default(), known.nodes);
        // A sliding element has no parameters, and is planned with its line.
        if parts.nodes.is_some() && !parts.kind.slides() {
            checks.run(reader, place, parts.kind, parts.count.unwrap_or(1), &parts.parameters, outputs);
        }
        Ok((parts.count, parts.check(reader, place, outputs)))
    })?;
    // An element of an unknown kind may have any output.
    if let Some(used) = elements.things().iter().map(Draft::kind).collect::<Option<Vec<_>>>() {
        wanted.check(reader, &used);
    }
    Ok(elements)
}

/// The index of the kind among these; it determines the other keys, wherever it is among them.
fn kind_of(reader: &mut Reader, kinds: &[&'static Kind]) -> Read<Option<usize>> {
    let place = reader.place();
    let names: Vec<_> = kinds.iter().map(|kind| kind.name).collect();
    let allowed =
        if names.is_empty() { "none yet in this dimension".into() } else { format!("one of {}", names.join(", ")) };
    let (mut kind, mut named) = (None, false);
    let is_object = reader.object("an element", |reader, key, _| {
        if key != "kind" || named {
            return reader.skip();
        }
        named = true;
        let place = reader.place();
        let Some(name) = reader.string(&allowed)? else { return Ok(()) };
        kind = names.iter().position(|known| *known == name);
        if kind.is_none() {
            reader.fault(place, format!("no kind {name:?}"), allowed.clone());
        }
        Ok(())
    })?;
    if is_object && !named {
        reader.fault(place, "an element without \"kind\"", allowed);
    }
    Ok(kind)
}

/// The contents of an element's keys.
struct Parts {
    kind: &'static Kind,
    /// The known nodes, if there are any nodes at all.
    nodes: Option<Vec<Option<Members>>>,
    /// The number of members, if they form a set.
    count: Option<u32>,
    /// Whether a slide line is named, and its index, if it is known.
    names_line: bool,
    line: Option<u32>,
    /// In the order of [`Kind::parameters`]; `None` if one is faulty.
    parameters: Vec<Option<Parameter>>,
    /// One bit per output, if the element specifies them.
    outputs: Option<u64>,
}

impl Parts {
    fn read(reader: &mut Reader, kind: &'static Kind, known: &Known) -> Read<Self> {
        let names: Vec<_> = kind.parameters().map(|(name, _)| name).collect();
        let own = if kind.slides() { &keys::SLIDING_ELEMENT[..] } else { &keys::ELEMENT };
        let keys: Vec<_> = own.iter().chain(&names).copied().collect();
        let parameters = vec![Some(Parameter::Absent); names.len()];
        let mut parts =
            Self { kind, nodes: None, count: None, names_line: false, line: None, parameters, outputs: None };
        let mut arrays = Vec::new();
        reader.record(&keys, |reader, key| {
            match key {
                0 => reader.skip()?,
                1 => parts.nodes = Some(nodes_of(reader, kind, known.nodes)?),
                2 => parts.outputs = Some(Outputs::of_element(reader, kind)?),
                3 if kind.slides() => {
                    parts.names_line = true;
                    parts.line = refer(reader, known.lines, "slide line")?;
                }
                _ => {
                    let index = key - own.len();
                    if let Some(array) = known.columns.refer(reader)? {
                        arrays.push((index, array));
                    } else {
                        let given = Given::read(reader, kind.domain(names[index]))?;
                        parts.parameters[index] = given.number().map(Parameter::One);
                    }
                }
            }
            Ok(())
        })?;
        let ends: Vec<_> = parts.nodes.iter().flatten().copied().flatten().collect();
        parts.count = SceneElement::count(&ends);
        // If the nodes are unknown, so is their number.
        let is_known = parts.count.is_some() || ends.len() == kind.nodes.len();
        for (index, array) in arrays {
            let column = || column_of(reader, known.columns, array, parts.count, kind.domain(names[index]));
            parts.parameters[index] = is_known.then(column).flatten().map(Parameter::Each);
        }
        Ok(parts)
    }

    /// The element, if nothing is missing or wrong.
    fn check(self, reader: &mut Reader, place: usize, outputs: u64) -> Draft {
        let Self { kind, nodes, names_line, line, parameters, .. } = self;
        let Some(ends) = nodes else {
            let roles = format!("an array of {} nodes: {}", kind.nodes.len(), kind.nodes.join(", "));
            reader.fault(place, "an element without \"nodes\"", roles);
            return Draft::Faulty(Some(kind), Vec::new());
        };
        if kind.slides() && !names_line {
            let allowed = "an element with the slide line that it slides on";
            reader.fault(place, "an element without \"slide_line\"", allowed);
        }
        let nodes: Vec<Members> = ends.iter().copied().flatten().collect();
        let all_known = nodes.len() == ends.len() && nodes.len() == kind.nodes.len();
        let parameters = parameters.into_iter().collect::<Option<_>>();
        match parameters.filter(|_| all_known && (!kind.slides() || line.is_some())) {
            Some(parameters) => {
                let nodes = nodes.into_iter().collect();
                Draft::Whole(SceneElement { kind, nodes, line, parameters, outputs })
            }
            None => Draft::Faulty(Some(kind), nodes),
        }
    }
}

/// A number for each element of a set, from an array.
fn column_of(
    reader: &mut Reader,
    columns: &Columns,
    array: Reference,
    count: Option<u32>,
    domain: Domain,
) -> Option<Box<[f64]>> {
    let Some(count) = count else {
        reader.fault_at(array.mark, "an array for one element", domain.allowed());
        return None;
    };
    let angles = reader.angles;
    let load = |mut array: Array| -> Result<Box<[f64]>, Unfit> {
        array.outline().expect(&[count as usize], "elements")?;
        let mut numbers = array.numbers(domain)?;
        if domain == Domain::Angle {
            for angle in &mut numbers {
                *angle = angles.radians(*angle);
            }
        }
        Ok(numbers.into())
    };
    columns.load(reader, array, load)
}

fn nodes_of(reader: &mut Reader, kind: &Kind, nodes: &Named<Option<SceneNode>>) -> Read<Vec<Option<Members>>> {
    let place = reader.place();
    let allowed = format!("an array of {} nodes: {}", kind.nodes.len(), kind.nodes.join(", "));
    let Some(mut ends) = refer_all(reader, nodes, &allowed, "node")? else { return Ok(Vec::new()) };
    if ends.len() != kind.nodes.len() {
        reader.fault(place, format!("an array of {}", ends.len()), allowed);
    }
    let sets: Vec<_> = ends.iter().flatten().filter_map(Members::count).collect();
    let count = sets.first().copied().unwrap_or(1);
    if let Some(other) = sets.into_iter().find(|&other| other != count) {
        let found = format!("sets of {count} and of {other} nodes");
        reader.fault(place, found, "sets of equally many nodes, and single nodes");
        return Ok(vec![None; ends.len()]);
    }
    // One that moves with another is that one, in another orientation.
    let at = |end: &Members, place| {
        let number = end.number(place);
        nodes[number].and_then(|node| node.with).unwrap_or(number)
    };
    for index in 1..ends.len() {
        let Some(end) = ends[index] else { continue };
        let is_twice = |place| ends[..index].iter().flatten().any(|before| at(before, place) == at(&end, place));
        if let Some(twice) = (0..count).find(|&place| is_twice(place)) {
            let node = nodes.name(end.number(twice));
            reader.fault(place, format!("node {node:?} for the second time"), "different nodes");
            ends[index] = None;
        }
    }
    Ok(ends)
}
