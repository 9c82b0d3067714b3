//! The elements of a scene file, and the outputs that are wanted of them.

use super::contact::Line;
use super::json::{Read, Reader};
use super::kind::{Dimension, Fallback, Kind, Origin};
use super::model::{Element, Node};
use super::needs::Needs;
use super::plan::Signature;
use super::read::{named, refer, refer_all};
use crate::quantity::Domain;
use indexmap::IndexMap;
use std::collections::HashMap;

/// The keys of every element; those of its kind's parameters follow.
pub(super) const KEYS: [&str; 3] = ["kind", "nodes", "outputs"];
/// The keys of an element that slides.
pub(super) const SLIDING_KEYS: [&str; 4] = ["kind", "nodes", "outputs", "slide_line"];

/// What elements may refer to.
pub(super) struct Known<'k> {
    pub(super) nodes: &'k IndexMap<Box<str>, Node>,
    pub(super) lines: &'k IndexMap<Box<str>, Line>,
}

/// Outputs wanted of all elements that have them, each with the place where it stands.
#[derive(Debug, Default)]
pub(super) struct Outputs(Vec<(String, usize)>);

impl Outputs {
    pub(super) fn read(reader: &mut Reader, dimension: Dimension) -> Read<Self> {
        let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
        let mut known: Vec<_> = kinds.iter().flat_map(|kind| kind.outputs.iter().map(|&(name, _)| name)).collect();
        known.sort_unstable();
        known.dedup();
        Self::of(reader, &known)
    }

    fn of(reader: &mut Reader, known: &[&str]) -> Read<Self> {
        let mut all: Vec<(String, usize)> = Vec::new();
        reader.array("an array of output names", |reader, _| {
            let place = reader.place();
            let Some(name) = reader.string("the name of an output")? else { return Ok(()) };
            if !known.contains(&name.as_str()) {
                reader.fault(place, format!("no output {name:?}"), format!("one of {}", known.join(", ")));
            } else if all.iter().any(|(other, _)| *other == name) {
                reader.fault(place, format!("{name:?} for the second time"), "each output once");
            } else {
                all.push((name, place));
            }
            Ok(())
        })?;
        Ok(Self(all))
    }

    /// A bit per output of the kind.
    fn mask(&self, kind: &Kind) -> u64 {
        let wanted = |name: &str| self.0.iter().any(|(output, _)| output == name);
        let bits = kind.outputs.iter().enumerate().filter(|(_, (name, _))| wanted(name));
        bits.fold(0, |mask, (bit, _)| mask | 1 << bit)
    }
}

pub(super) fn read(
    reader: &mut Reader,
    dimension: Dimension,
    known: &Known<'_>,
    wanted: &Outputs,
) -> Read<IndexMap<Box<str>, Element>> {
    let mut checks = Checks::default();
    let mut masks = HashMap::new();
    let elements = named(reader, |reader| {
        let element =
            element(reader, dimension, known, |kind| *masks.entry(kind.name).or_insert_with(|| wanted.mask(kind)))?;
        let Some((element, place)) = element else { return Ok(None) };
        checks.run(reader, &element, place);
        Ok(Some(element))
    })?;
    for (name, place) in &wanted.0 {
        if !elements.values().any(|element| element.kind.output(name).is_some()) {
            reader.fault(
                *place,
                format!("output {name:?}, which no element here has"),
                "an output of one of the elements",
            );
        }
    }
    Ok(elements)
}

/// An element, and where it stands.
fn element(
    reader: &mut Reader,
    dimension: Dimension,
    known: &Known<'_>,
    mut wanted: impl FnMut(&'static Kind) -> u64,
) -> Read<Option<(Element, usize)>> {
    let place = reader.place();
    let Some(kind) = kind_of(reader, dimension, place)? else { return Ok(None) };
    reader.go(place);
    let parameters: Vec<_> = kind.parameters().map(|(name, _)| name).collect();
    let own = if kind.slides() { &SLIDING_KEYS[..] } else { &KEYS };
    let keys: Vec<_> = own.iter().chain(&parameters).copied().collect();
    let mut given = vec![None; parameters.len()];
    let (mut ends, mut outputs, mut line) = (None, None, None);
    reader.record(&keys, |reader, key| {
        match key {
            0 => reader.skip()?,
            1 => ends = Some(nodes_of(reader, kind, known.nodes)?),
            2 => {
                let known: Vec<_> = kind.outputs.iter().map(|&(name, _)| name).collect();
                outputs = Some(Outputs::of(reader, &known)?.mask(kind));
            }
            3 if kind.slides() => {
                let place = reader.place();
                let name = reader.string("the name of a slide line")?;
                // One that is not known is a fault, but not also a missing one.
                line = Some(name.and_then(|name| refer(reader, known.lines, place, &name, "slide line")).unwrap_or(0));
            }
            _ => {
                let index = key - own.len();
                // One that was given badly is not also a missing one.
                given[index] = reader.number(kind.domain(parameters[index]))?.or(Some(0.0));
            }
        }
        Ok(())
    })?;
    let roles = kind.nodes.join(", ");
    let Some(ends) = ends else {
        reader.fault(place, "an element without \"nodes\"", format!("an array of {} nodes: {roles}", kind.nodes.len()));
        return Ok(None);
    };
    if kind.slides() && line.is_none() {
        reader.fault(place, "an element without \"slide_line\"", "an element with the slide line that it slides on");
    }
    // Nodes that were not found are faults already.
    let mut ends = ends;
    ends.resize(kind.nodes.len(), 0);
    let outputs = outputs.unwrap_or_else(|| wanted(kind));
    Ok(Some((Element { kind, nodes: ends.into(), line, parameters: given.into(), outputs }, place)))
}

/// The kind, which decides about the other keys, wherever it stands among them.
fn kind_of(reader: &mut Reader, dimension: Dimension, place: usize) -> Read<Option<&'static Kind>> {
    let mut names: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).map(|kind| kind.name).collect();
    names.dedup();
    let allowed =
        if names.is_empty() { "none yet in this dimension".into() } else { format!("one of {}", names.join(", ")) };
    let mut kind = None;
    let mut named = false;
    let is_object = reader.object("an element", |reader, key, _| {
        if key != "kind" || named {
            return reader.skip();
        }
        named = true;
        let place = reader.place();
        let Some(name) = reader.string(&allowed)? else { return Ok(()) };
        kind = Kind::find(&name, dimension);
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

fn nodes_of(reader: &mut Reader, kind: &Kind, nodes: &IndexMap<Box<str>, Node>) -> Read<Vec<u32>> {
    let place = reader.place();
    let allowed = format!("an array of {} nodes: {}", kind.nodes.len(), kind.nodes.join(", "));
    let ends = refer_all(reader, nodes, &allowed, "node")?;
    if let Some(count) = ends.as_ref().map(Vec::len).filter(|&count| count != kind.nodes.len()) {
        reader.fault(place, format!("an array of {count}"), allowed);
    }
    Ok(ends.unwrap_or_default())
}

/// What the needed formulas say about parameters, worked out once for elements alike.
#[derive(Default)]
struct Checks {
    known: HashMap<Signature, Needs>,
}

impl Checks {
    fn run(&mut self, reader: &mut Reader, element: &Element, place: usize) {
        let signature = Signature::of(element);
        let needs = self.known.entry(signature).or_insert_with(|| Needs::of_outputs(&signature));
        for &(name, origin) in &needs.given {
            if origin == Origin::Parameter(Fallback::Required) && !signature.gives(name) {
                let meaning = element.kind.quantity(name).map_or("", |quantity| quantity.meaning);
                let why = needs.reasons(name);
                reader.fault(place, format!("no {name:?}, needed for {why}"), format!("a number, the {meaning}"));
            }
        }
        let parameters: Vec<_> = element.kind.parameters().zip(&element.parameters).collect();
        let given = |name: &str| {
            let parameter = parameters.iter().find(|((parameter, _), _)| *parameter == name);
            parameter.map(|((_, fallback), value)| value.or(fallback.number()))
        };
        for (formula, _) in &needs.formulas {
            let fields = formula.step.inputs();
            let of_parameters = fields.iter().filter(|field| given(formula.register(field.name)).is_some()).count();
            if of_parameters < 2 || fields.iter().any(|field| given(formula.register(field.name)) == Some(None)) {
                continue;
            }
            let components = fields.iter().flat_map(|field| match given(formula.register(field.name)).flatten() {
                Some(number) => vec![number],
                None => harmless(field.quantity.domain, field.len()),
            });
            if let Err(error) = formula.step.check(&components.collect::<Vec<_>>()) {
                reader.reject(place, &error);
            }
        }
    }
}

/// Components that no formula rejects, where only parameters are in question.
fn harmless(domain: Domain, len: usize) -> Vec<f64> {
    match domain {
        Domain::Triad(_, axis) => (1..=len).map(|k| f64::from(u8::from(k == axis))).collect(),
        Domain::Positive => vec![1.0; len],
        _ => vec![0.0; len],
    }
}
