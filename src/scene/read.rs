//! From the text of a scene file to a checked [`Scene`].

use super::elements::Outputs;
use super::fault::Faults;
use super::json::{Read, Reader};
use super::kind::Dimension;
use super::model::{Frame, Load, Motion, Node, Orientation, Scene};
use crate::quantity::Domain;
use indexmap::IndexMap;

/// The keys of a scene.
pub(super) const KEYS: [&str; 7] = ["title", "dimension", "orientations", "nodes", "elements", "frames", "outputs"];
pub(super) const NODE_KEYS: [&str; 2] = ["at", "orientation"];
pub(super) const FRAME_KEYS: [&str; 3] = ["time", "nodes", "loads"];
pub(super) const MOTION_KEYS: [&str; 2] = ["u", "ur"];
pub(super) const SPACE_ORIENTATION_KEYS: [&str; 3] = ["axes", "rotation", "quaternion"];
pub(super) const PLANE_ORIENTATION_KEYS: [&str; 1] = ["angle"];

/// How parallel two axes may be: the least sine of the angle between them.
const PARALLEL: f64 = 1e-6;

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
    let [title, dimension, orientations, nodes, elements, frames, outputs] = parts;
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
    let outputs = part(reader, "outputs", outputs, |reader| Outputs::read(reader, dimension))?.unwrap_or_default();
    let elements =
        part(reader, "elements", elements, |reader| super::elements::read(reader, dimension, &nodes, &outputs))?;
    let elements = elements.unwrap_or_default();
    let mut scene =
        Scene { title, dimension, orientations: turns.into_values().collect(), nodes, elements, frames: Vec::new() };
    scene.frames = match part(reader, "frames", frames, |reader| frames_of(reader, &scene))? {
        Some(frames) => frames,
        None => vec![Frame { time: 0.0, motions: Vec::new(), loads: Vec::new() }],
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

fn orientations_of(reader: &mut Reader, dimension: Dimension) -> Read<IndexMap<Box<str>, Orientation>> {
    named(reader, |reader| {
        let place = reader.place();
        let mut found = Vec::new();
        if dimension == Dimension::Space {
            reader.record(&SPACE_ORIENTATION_KEYS, |reader, key| {
                found.push(match key {
                    0 => axes(reader)?,
                    1 => reader.vector()?.map(Orientation::Rotation),
                    _ => quaternion(reader)?,
                });
                Ok(())
            })?;
        } else {
            reader.record(&PLANE_ORIENTATION_KEYS, |reader, _| {
                let angle = reader.number(Domain::Angle)?;
                found.push(angle.map(|angle| Orientation::Rotation([0.0, 0.0, angle])));
                Ok(())
            })?;
        }
        if found.len() != 1 {
            let keys: &[&str] =
                if dimension == Dimension::Space { &SPACE_ORIENTATION_KEYS } else { &PLANE_ORIENTATION_KEYS };
            reader.fault(place, format!("{} descriptions", found.len()), format!("exactly one of {}", keys.join(", ")));
        }
        // A faulty one still has a name that nodes may refer to.
        Ok(Some(found.into_iter().flatten().next().unwrap_or(Orientation::Rotation([0.0; 3]))))
    })
}

fn axes(reader: &mut Reader) -> Read<Option<Orientation>> {
    let place = reader.place();
    let mut axes = Vec::new();
    let is_array = reader.array("an array of two vectors", |reader, _| {
        axes.push(reader.vector()?);
        Ok(())
    })?;
    let [Some(first), Some(second)] = axes[..] else {
        if is_array && axes.len() != 2 {
            reader.fault(
                place,
                format!("{} vectors", axes.len()),
                "two: along the first axis, and in the plane of the first two",
            );
        }
        return Ok(None);
    };
    let [a, b] = [first, second].map(|v| nalgebra::Vector3::from(crate::scalar::direction(v)));
    if a.cross(&b).norm() < PARALLEL {
        reader.fault(place, "two vectors that are parallel, or zero", "two vectors that span a plane");
        return Ok(None);
    }
    Ok(Some(Orientation::Axes(first, second)))
}

fn quaternion(reader: &mut Reader) -> Read<Option<Orientation>> {
    let place = reader.place();
    let Some(quaternion) = reader.vector()? else { return Ok(None) };
    if quaternion == [0.0; 4] {
        reader.fault(place, "the quaternion 0", "a quaternion other than 0, real part first");
        return Ok(None);
    }
    Ok(Some(Orientation::Quaternion(quaternion)))
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

fn frames_of(reader: &mut Reader, scene: &Scene) -> Read<Vec<Frame>> {
    let mut frames: Vec<Frame> = Vec::new();
    let place = reader.place();
    // The last frame that moved each node.
    let mut moved = vec![usize::MAX; scene.nodes.len()];
    let is_array = reader.array("an array of frames", |reader, index| {
        let place = reader.place();
        let mut frame = Frame { time: f64::NAN, motions: Vec::new(), loads: Vec::new() };
        let is_object = reader.record(&FRAME_KEYS, |reader, key| {
            match key {
                0 => {
                    let place = reader.place();
                    frame.time = reader.number(Domain::Real)?.unwrap_or(f64::INFINITY);
                    if let Some(last) = frames.last().map(|last| last.time).filter(|&last| frame.time <= last) {
                        reader.fault(
                            place,
                            format!("{:?}", frame.time),
                            format!("a time after the last frame's, {last:?}"),
                        );
                    }
                }
                1 => {
                    motions_of(reader, scene, index, &mut moved, &mut frame.motions)?;
                }
                _ => {
                    loads_of(reader, scene, &mut frame.loads)?;
                }
            }
            Ok(())
        })?;
        if is_object && frame.time.is_nan() {
            reader.fault(place, "a frame without \"time\"", "a frame with its time");
        }
        frames.push(frame);
        Ok(())
    })?;
    if is_array && frames.is_empty() {
        reader.fault(place, "no frame", "one frame or more (or no \"frames\" for the initial configuration alone)");
    }
    Ok(frames)
}

fn motions_of(
    reader: &mut Reader,
    scene: &Scene,
    frame: usize,
    moved: &mut [usize],
    motions: &mut Vec<Motion>,
) -> Read<bool> {
    let dimension = scene.dimension;
    reader.object("an object of nodes", |reader, name, place| {
        let Some(node) = refer(reader, &scene.nodes, place, name, "node") else { return reader.skip() };
        let mut motion = Motion { node, u: None, ur: None };
        let last = moved.get_mut(node as usize);
        if last.is_some_and(|last| std::mem::replace(last, frame) == frame) {
            reader.fault(place, format!("{name:?} for the second time"), "each name once");
        }
        let keys = if dimension == Dimension::Axisymmetric { &MOTION_KEYS[..1] } else { &MOTION_KEYS };
        reader.record(keys, |reader, key| {
            match key {
                0 => motion.u = point(reader, dimension)?,
                _ if dimension == Dimension::Space => motion.ur = reader.vector()?,
                _ => motion.ur = reader.number(Domain::Angle)?.map(|angle| [0.0, 0.0, angle]),
            }
            Ok(())
        })?;
        motions.push(motion);
        Ok(())
    })
}

fn loads_of(reader: &mut Reader, scene: &Scene, loads: &mut Vec<Load>) -> Read<bool> {
    reader.object("an object of elements", |reader, name, place| {
        let Some(element) = refer(reader, &scene.elements, place, name, "element") else { return reader.skip() };
        let Some((_, of)) = scene.elements.get_index(element as usize) else { return reader.skip() };
        let names: Vec<_> = of.kind.loads().collect();
        reader.record(&names, |reader, key| {
            let domain = of.kind.field(names[key]).map_or(Domain::Real, |field| field.quantity.domain);
            if let (Some(value), Ok(index)) = (reader.number(domain)?, u16::try_from(key)) {
                loads.push(Load { element, index, value });
            }
            Ok(())
        })?;
        Ok(())
    })
}
