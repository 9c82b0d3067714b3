//! From the text of a scene file to a checked [`Scene`].

mod frames;
mod orientations;

use super::contact::lines_of;
use super::elements::{Known, Outputs};
use super::fault::Faults;
use super::json::{Read, Reader};
use super::kind::Dimension;
use super::model::{Frame, Node, Orientation, Scene};
use frames::frames_of;
use indexmap::IndexMap;
use orientations::orientations_of;

/// The keys of a scene.
pub(super) const KEYS: [&str; 8] =
    ["title", "dimension", "orientations", "nodes", "slide_lines", "elements", "frames", "outputs"];
pub(super) const NODE_KEYS: [&str; 2] = ["at", "orientation"];
pub(super) const FRAME_KEYS: [&str; 3] = ["time", "nodes", "loads"];
/// Those of a frame of an axisymmetric scene.
pub(super) const SLIDING_FRAME_KEYS: [&str; 3] = ["time", "nodes", "pressures"];
pub(super) const MOTION_KEYS: [&str; 2] = ["u", "ur"];
pub(super) const SPACE_ORIENTATION_KEYS: [&str; 3] = ["axes", "rotation", "quaternion"];
pub(super) const PLANE_ORIENTATION_KEYS: [&str; 1] = ["angle"];

impl Scene {
    /// Reads a scene file and checks it.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its JSON path, line, column, what was found and what is allowed.
    /// Text that is not JSON is the last fault that is found.
    pub fn parse(text: &str) -> Result<Self, Faults> {
        let mut reader = Reader::new(text);
        let scene = scene(&mut reader).ok().flatten();
        match scene {
            Some(scene) if reader.faults.none() => Ok(scene),
            _ => {
                if reader.faults.none() {
                    reader.fault(0, "no scene", "a scene");
                }
                Err(reader.faults)
            }
        }
    }
}

/// First where each part stands, then the parts in the order in which they refer to each other.
fn scene(reader: &mut Reader) -> Read<Option<Scene>> {
    let start = reader.place();
    let mut parts = [None; KEYS.len()];
    let is_object = reader.record(&KEYS, |reader, key| {
        parts[key] = Some(reader.place());
        reader.skip()
    })?;
    reader.end()?;
    if !is_object {
        return Ok(None);
    }
    let [title, dimension, orientations, nodes, lines, elements, frames, outputs] = parts;
    for (key, part) in KEYS.iter().zip(parts) {
        if part.is_none() && ["dimension", "nodes", "elements"].contains(key) {
            reader.fault(start, format!("no {key:?}"), "a scene with dimension, nodes and elements");
        }
    }
    let title = part(reader, "title", title, |reader| reader.string("a string"))?.flatten().unwrap_or_default();
    let dimension = part(reader, "dimension", dimension, dimension_of)?.flatten();
    let Some(dimension) = dimension else { return Ok(None) };
    let turns = part(reader, "orientations", orientations, |reader| orientations_of(reader, dimension))?;
    let turns = turns.unwrap_or_default();
    let nodes = part(reader, "nodes", nodes, |reader| nodes_of(reader, dimension, &turns))?.unwrap_or_default();
    if let Some(place) = lines.filter(|_| dimension != Dimension::Axisymmetric) {
        reader.go(place);
        reader.below("slide_lines", |reader| reader.fault(place, "slide lines", "none but in an axisymmetric scene"));
    }
    let lines = lines.filter(|_| dimension == Dimension::Axisymmetric);
    let lines = part(reader, "slide_lines", lines, |reader| lines_of(reader, &nodes))?.unwrap_or_default();
    let outputs = part(reader, "outputs", outputs, |reader| Outputs::read(reader, dimension))?.unwrap_or_default();
    let elements = part(reader, "elements", elements, |reader| {
        super::elements::read(reader, dimension, &Known { nodes: &nodes, lines: &lines }, &outputs)
    })?;
    let elements = elements.unwrap_or_default();
    let mut scene = Scene {
        title,
        dimension,
        orientations: turns.into_values().collect(),
        nodes,
        lines,
        elements,
        frames: Vec::new(),
    };
    scene.frames = match part(reader, "frames", frames, |reader| frames_of(reader, &scene))? {
        Some(frames) => frames,
        None => vec![Frame::default()],
    };
    Ok(Some(scene))
}

fn part<'t, T>(
    reader: &mut Reader<'t>,
    key: &str,
    place: Option<usize>,
    read: impl FnOnce(&mut Reader<'t>) -> Read<T>,
) -> Read<Option<T>> {
    let Some(place) = place else { return Ok(None) };
    reader.go(place);
    reader.below(key, read).map(Some)
}

fn dimension_of(reader: &mut Reader) -> Read<Option<Dimension>> {
    let place = reader.place();
    let allowed = Dimension::ALL.map(Dimension::name).join(", ");
    let Some(name) = reader.string(&allowed)? else { return Ok(None) };
    let dimension = Dimension::ALL.into_iter().find(|dimension| dimension.name() == name);
    if dimension.is_none() {
        reader.fault(place, format!("{name:?}"), allowed);
    }
    Ok(dimension)
}

/// The members of an object whose keys are names of the author's choice, each once.
pub(super) fn named<'t, T>(
    reader: &mut Reader<'t>,
    mut item: impl FnMut(&mut Reader<'t>) -> Read<Option<T>>,
) -> Read<IndexMap<Box<str>, T>> {
    let mut all = IndexMap::new();
    reader.object("an object of named entries", |reader, name, place| {
        if name.is_empty() {
            reader.fault(place, "an empty name", "a name");
        }
        let value = item(reader)?;
        if all.contains_key(name) {
            reader.fault(place, format!("{name:?} for the second time"), "each name once");
        } else if let Some(value) = value {
            all.insert(name.into(), value);
        }
        Ok(())
    })?;
    Ok(all)
}

/// An array of names that must be known: what each of those that are has for its place.
pub(super) fn refer_all<T>(
    reader: &mut Reader,
    known: &IndexMap<Box<str>, T>,
    allowed: &str,
    what: &str,
) -> Read<Option<Vec<u32>>> {
    let mut found = Vec::new();
    let is_array = reader.array(allowed, |reader, _| {
        let place = reader.place();
        if let Some(name) = reader.string(&format!("the name of a {what}"))? {
            found.push(refer(reader, known, place, &name, what).unwrap_or(0));
        }
        Ok(())
    })?;
    Ok(is_array.then_some(found))
}

/// Names that an error lists.
const SHOWN: usize = 8;

/// A name that must be one of those known.
pub(super) fn refer<T>(
    reader: &mut Reader,
    known: &IndexMap<Box<str>, T>,
    place: usize,
    name: &str,
    what: &str,
) -> Option<u32> {
    if let Some(index) = known.get_index_of(name) {
        return u32::try_from(index).ok();
    }
    let mut names: Vec<_> = known.keys().take(SHOWN).map(|name| format!("{name:?}")).collect();
    if known.len() > SHOWN {
        names.push("…".into());
    }
    let allowed =
        if names.is_empty() { format!("no {what}, there are none") } else { format!("one of {}", names.join(", ")) };
    reader.fault(place, format!("no {what} {name:?}"), allowed);
    None
}

/// Coordinates or a displacement.
fn point(reader: &mut Reader, dimension: Dimension) -> Read<Option<[f64; 3]>> {
    if dimension == Dimension::Space {
        return reader.vector();
    }
    Ok(reader.vector()?.map(|[x, y]: [f64; 2]| [x, y, 0.0]))
}

fn nodes_of(
    reader: &mut Reader,
    dimension: Dimension,
    orientations: &IndexMap<Box<str>, Orientation>,
) -> Read<IndexMap<Box<str>, Node>> {
    named(reader, |reader| {
        let place = reader.place();
        let (mut given, mut node) = (false, Node { at: [0.0; 3], orientation: None });
        let is_object = reader.record(&NODE_KEYS, |reader, key| {
            let place = reader.place();
            if key == 0 {
                given = true;
                node.at = point(reader, dimension)?.unwrap_or_default();
            } else if let Some(name) = reader.string("the name of an orientation")? {
                node.orientation = refer(reader, orientations, place, &name, "orientation");
            }
            Ok(())
        })?;
        if is_object && !given {
            reader.fault(place, "a node without \"at\"", "a node with its coordinates");
        }
        Ok(Some(node))
    })
}
