//! The history of a scene: what moves, and what is loaded.

use super::{FRAME_KEYS, MOTION_KEYS, SLIDING_FRAME_KEYS, point, refer};
use crate::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::Dimension;
use crate::scene::model::{Changes, Frame, Scene};
use indexmap::IndexMap;

pub(super) fn frames_of(reader: &mut Reader, scene: &Scene) -> Read<Vec<Frame>> {
    let mut frames: Vec<Frame> = Vec::new();
    let sliding = scene.dimension == Dimension::Axisymmetric;
    let keys = if sliding { &SLIDING_FRAME_KEYS } else { &FRAME_KEYS };
    let place = reader.place();
    let mut moved = Mentioned::none(&scene.nodes, "node");
    let mut pressed = Mentioned::none(&scene.nodes, "node");
    let mut loaded = Mentioned::none(&scene.elements, "element");
    let slides = if sliding { nodes_of_elements(scene) } else { Vec::new() };
    let is_array = reader.array("an array of frames", |reader, index| {
        let place = reader.place();
        let mut frame = Frame { time: f64::NAN, ..Frame::default() };
        let is_object = reader.record(keys, |reader, key| match key {
            0 => {
                let place = reader.place();
                frame.time = reader.number(Domain::Real)?.unwrap_or(f64::INFINITY);
                if let Some(last) = frames.last().map(|last| last.time).filter(|&last| frame.time <= last) {
                    let found = format!("{:?}", frame.time);
                    reader.fault(place, found, format!("a time after the last frame's, {last:?}"));
                }
                Ok(())
            }
            1 => moved.each(reader, index, |reader, node, _| motion_of(reader, scene.dimension, node, &mut frame)),
            _ if sliding => pressed.each(reader, index, |reader, node, place| {
                if !slides[node as usize] {
                    reader.fault(place, "a node of no element", "a node that slides on a line");
                }
                frame.pressures.extend(node, reader.number(Domain::NonNegative)?);
                Ok(())
            }),
            _ => loaded.each(reader, index, |reader, element, _| loads_of(reader, scene, element, &mut frame)),
        })?;
        if is_object && frame.time.is_nan() {
            reader.fault(place, "a frame without \"time\"", "a frame with its time");
        }
        frames.push(frame.sorted());
        Ok(())
    })?;
    if is_array && frames.is_empty() {
        reader.fault(place, "no frame", "one frame or more (or no \"frames\" for the initial configuration alone)");
    }
    Ok(frames)
}

/// Whether each node is one of an element.
fn nodes_of_elements(scene: &Scene) -> Vec<bool> {
    let mut is_one = vec![false; scene.nodes.len()];
    scene.elements.values().flat_map(|element| &element.nodes).for_each(|&node| is_one[node as usize] = true);
    is_one
}

/// What frames mention by name, each once a frame.
struct Mentioned<'k, T> {
    known: &'k IndexMap<Box<str>, T>,
    what: &'static str,
    /// The last frame that mentioned each.
    last: Vec<usize>,
}

impl<'k, T> Mentioned<'k, T> {
    fn none(known: &'k IndexMap<Box<str>, T>, what: &'static str) -> Self {
        Self { known, what, last: vec![usize::MAX; known.len()] }
    }

    /// The members of an object whose keys are names of these; `read` is told which, and where its key stands.
    fn each(
        &mut self,
        reader: &mut Reader,
        frame: usize,
        mut read: impl FnMut(&mut Reader, u32, usize) -> Read<()>,
    ) -> Read<()> {
        let Self { known, what, last } = self;
        reader.object(&format!("an object of {what}s"), |reader, name, place| {
            let Some(index) = refer(reader, known, place, name, what) else { return reader.skip() };
            if std::mem::replace(&mut last[index as usize], frame) == frame {
                reader.fault(place, format!("{name:?} for the second time"), "each name once");
            }
            read(reader, index, place)
        })?;
        Ok(())
    }
}

fn motion_of(reader: &mut Reader, dimension: Dimension, node: u32, frame: &mut Frame) -> Read<()> {
    let keys = if dimension == Dimension::Axisymmetric { &MOTION_KEYS[..1] } else { &MOTION_KEYS };
    reader.record(keys, |reader, key| {
        let (motions, by) = match key {
            0 => (&mut frame.moves, point(reader, dimension)?),
            _ if dimension == Dimension::Space => (&mut frame.turns, reader.vector()?),
            _ => (&mut frame.turns, reader.number(Domain::Angle)?.map(|angle| [0.0, 0.0, angle])),
        };
        motions.extend(node, by);
        Ok(())
    })?;
    Ok(())
}

fn loads_of(reader: &mut Reader, scene: &Scene, element: u32, frame: &mut Frame) -> Read<()> {
    let kind = scene.elements[element as usize].kind;
    let names: Vec<_> = kind.loads().collect();
    reader.record(&names, |reader, key| {
        let value = reader.number(kind.domain(names[key]))?;
        if frame.loads.len() <= key {
            frame.loads.resize_with(key + 1, Changes::default);
        }
        frame.loads[key].extend(element, value);
        Ok(())
    })?;
    Ok(())
}
