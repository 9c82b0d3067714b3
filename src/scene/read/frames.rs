//! The history of a scene: what moves, and what is loaded.

use super::{FRAME_KEYS, MOTION_KEYS, SLIDING_FRAME_KEYS, point, refer};
use crate::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::Dimension;
use crate::scene::model::{Frame, Load, Motion, Scene};

pub(super) fn frames_of(reader: &mut Reader, scene: &Scene) -> Read<Vec<Frame>> {
    let mut frames: Vec<Frame> = Vec::new();
    let sliding = scene.dimension == Dimension::Axisymmetric;
    let keys = if sliding { &SLIDING_FRAME_KEYS } else { &FRAME_KEYS };
    let place = reader.place();
    // The last frame that moved each node.
    let mut moved = vec![usize::MAX; scene.nodes.len()];
    let is_array = reader.array("an array of frames", |reader, index| {
        let place = reader.place();
        let mut frame = Frame::at(f64::NAN);
        let is_object = reader.record(keys, |reader, key| {
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
                _ if sliding => {
                    pressures_of(reader, scene, &mut frame.pressures)?;
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

/// Pressures of hard contact, of nodes that slide.
fn pressures_of(reader: &mut Reader, scene: &Scene, pressures: &mut Vec<(u32, f64)>) -> Read<bool> {
    reader.object("an object of nodes", |reader, name, place| {
        let Some(node) = refer(reader, &scene.nodes, place, name, "node") else { return reader.skip() };
        if !scene.elements.values().any(|element| element.nodes.contains(&node)) {
            reader.fault(place, format!("node {name:?}, which is of no element"), "a node that slides on a line");
        }
        pressures.extend(reader.number(Domain::NonNegative)?.map(|pressure| (node, pressure)));
        Ok(())
    })
}

fn loads_of(reader: &mut Reader, scene: &Scene, loads: &mut Vec<Load>) -> Read<bool> {
    reader.object("an object of elements", |reader, name, place| {
        let Some(element) = refer(reader, &scene.elements, place, name, "element") else { return reader.skip() };
        let Some((_, of)) = scene.elements.get_index(element as usize) else { return reader.skip() };
        let names: Vec<_> = of.kind.loads().collect();
        reader.record(&names, |reader, key| {
            let domain = of.kind.domain(names[key]);
            if let (Some(value), Ok(index)) = (reader.number(domain)?, u16::try_from(key)) {
                loads.push(Load { element, index, value });
            }
            Ok(())
        })?;
        Ok(())
    })
}
