//! The elements of a scene file.

use super::checks::Checks;
use super::given::Given;
use super::keys;
use super::names::{named, refer, refer_all};
use super::outputs::Outputs;
use super::triads::Inherited;
use crate::isl::IslElement;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::{Dimension, Kind};
use crate::scene::model::{Named, SceneElement, SceneLine, SceneNode, Sliding};

/// An element as far as it could be read.
pub(super) enum Draft {
    Whole(SceneElement),
    /// With a fault: the kind and the nodes that are known all the same.
    Faulty(Option<&'static Kind>, Vec<u32>),
}

impl Draft {
    pub(super) fn kind(&self) -> Option<&'static Kind> {
        match self {
            Self::Whole(element) => Some(element.kind),
            Self::Faulty(kind, _) => *kind,
        }
    }

    pub(super) fn nodes(&self) -> &[u32] {
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
    nodes: &Named<Option<SceneNode>>,
    lines: &Named<Option<SceneLine>>,
    wanted: &Outputs,
    inherited: &mut Inherited,
) -> Read<Named<Draft>> {
    let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
    let masks: Vec<_> = kinds.iter().map(|kind| wanted.mask(kind)).collect();
    let mut checks = Checks::default();
    let elements = named(reader, |reader, number| {
        let place = reader.place();
        let Some(index) = kind_of(reader, &kinds)? else { return Ok(Draft::Faulty(None, Vec::new())) };
        reader.go(place);
        let parts = Parts::read(reader, kinds[index], nodes, lines)?;
        let outputs = parts.outputs.unwrap_or(masks[index]);
        inherited.check(reader, place, parts.kind, parts.nodes.as_deref().unwrap_or_default(), nodes);
        // An element that slides has no parameters, and is planned with its line.
        if parts.nodes.is_some() && !parts.kind.slides() {
            checks.run(reader, place, parts.kind, &parts.parameters, outputs);
        }
        Ok(parts.check(reader, place, number, outputs))
    })?;
    // An element of an unknown kind may have any output.
    if let Some(used) = elements.things().iter().map(Draft::kind).collect::<Option<Vec<_>>>() {
        wanted.check(reader, &used);
    }
    Ok(elements)
}

/// The kind, by its place among these; it decides about the other keys, wherever it stands among them.
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

/// What an element's keys give.
struct Parts {
    kind: &'static Kind,
    /// Those that are known, if there are any nodes at all.
    nodes: Option<Vec<Option<u32>>>,
    /// Whether a slide line is named, and which, if it is known.
    names_line: bool,
    line: Option<u32>,
    /// In the order of [`Kind::parameters`].
    parameters: Vec<Given>,
    /// A bit per output, where the element says which.
    outputs: Option<u64>,
}

impl Parts {
    fn read(
        reader: &mut Reader,
        kind: &'static Kind,
        nodes: &Named<Option<SceneNode>>,
        lines: &Named<Option<SceneLine>>,
    ) -> Read<Self> {
        let names: Vec<_> = kind.parameters().map(|(name, _)| name).collect();
        let own = if kind.slides() { &keys::SLIDING_ELEMENT[..] } else { &keys::ELEMENT };
        let keys: Vec<_> = own.iter().chain(&names).copied().collect();
        let parameters = vec![Given::Absent; names.len()];
        let mut parts = Self { kind, nodes: None, names_line: false, line: None, parameters, outputs: None };
        reader.record(&keys, |reader, key| {
            match key {
                0 => reader.skip()?,
                1 => parts.nodes = Some(nodes_of(reader, kind, nodes)?),
                2 => parts.outputs = Some(Outputs::of_element(reader, kind)?),
                3 if kind.slides() => {
                    parts.names_line = true;
                    parts.line = refer(reader, lines, "slide line")?;
                }
                _ => {
                    let index = key - own.len();
                    parts.parameters[index] = Given::read(reader, kind.domain(names[index]))?;
                }
            }
            Ok(())
        })?;
        Ok(parts)
    }

    /// The element with this number, if nothing is missing or wrong.
    fn check(self, reader: &mut Reader, place: usize, number: u32, outputs: u64) -> Draft {
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
        let nodes: Vec<u32> = ends.iter().copied().flatten().collect();
        let all_known = nodes.len() == ends.len() && nodes.len() == kind.nodes.len();
        if !all_known || parameters.contains(&Given::Faulty) || (kind.slides() && line.is_none()) {
            return Draft::Faulty(Some(kind), nodes);
        }
        let sliding = line.map(|line| sliding(number, &nodes, line));
        let parameters = parameters.into_iter().map(Given::number).collect();
        Draft::Whole(SceneElement { kind, nodes: nodes.into(), sliding, parameters, outputs })
    }
}

/// An element on its line.
fn sliding(number: u32, nodes: &[u32], line: u32) -> Sliding {
    let element = match *nodes {
        [a, b] => IslElement::isl21a(number, [a, b]),
        [a, b, c] => IslElement::isl22a(number, [a, b, c]),
        _ => unreachable!("the kinds that slide have two or three nodes"),
    };
    Sliding { line, element: element.expect("no element that has a node twice gets here") }
}

fn nodes_of(reader: &mut Reader, kind: &Kind, nodes: &Named<Option<SceneNode>>) -> Read<Vec<Option<u32>>> {
    let place = reader.place();
    let allowed = format!("an array of {} nodes: {}", kind.nodes.len(), kind.nodes.join(", "));
    let Some(mut ends) = refer_all(reader, nodes, &allowed, "node")? else { return Ok(Vec::new()) };
    if ends.len() != kind.nodes.len() {
        reader.fault(place, format!("an array of {}", ends.len()), allowed);
    }
    for index in 1..ends.len() {
        if let (Some(node), before) = (ends[index], &ends[..index])
            && before.contains(&Some(node))
        {
            reader.fault(place, format!("node {:?} for the second time", nodes.name(node)), "different nodes");
            ends[index] = None;
        }
    }
    Ok(ends)
}
