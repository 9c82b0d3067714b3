//! The history of a scene: what moves, and what is loaded.

use super::elements::Draft;
use super::given::Given;
use super::keys;
use super::names::look_up;
use super::nodes::point;
use crate::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::{Dimension, Kind};
use crate::scene::model::{Changes, Frame, Named, SceneNode};

pub(super) fn frames_of(
    reader: &mut Reader,
    dimension: Dimension,
    nodes: &Named<Option<SceneNode>>,
    elements: &Named<Draft>,
) -> Read<Vec<Frame>> {
    let place = reader.place();
    let mut history = History::new(dimension, nodes, elements);
    let (mut frames, mut last, mut any) = (Vec::new(), None, false);
    let is_array = reader.array("an array of frames", |reader, index| {
        any = true;
        let place = reader.place();
        let frame = history.frame(reader, index, last)?;
        match frame.time {
            _ if !frame.is_object => {}
            Given::Absent => reader.fault(place, "a frame without \"time\"", "a frame with its time"),
            Given::Faulty => {}
            Given::Number(time) => {
                last = Some(time);
                frames.push(Frame { time, ..frame.changes }.sorted());
            }
        }
        Ok(())
    })?;
    if is_array && !any {
        reader.fault(place, "no frame", "one frame or more (or no \"frames\" for the initial configuration alone)");
    }
    Ok(frames)
}

/// A frame as far as it could be read.
struct ReadFrame {
    is_object: bool,
    time: Given,
    changes: Frame,
}

/// What frames may mention.
struct History<'k> {
    dimension: Dimension,
    moved: Mentioned<'k, Option<SceneNode>>,
    pressed: Mentioned<'k, Option<SceneNode>>,
    loaded: Mentioned<'k, Draft>,
    /// Whether each node may be one of an element, where elements slide; any may be of an element whose nodes are not known.
    slides: Vec<bool>,
}

impl<'k> History<'k> {
    fn new(dimension: Dimension, nodes: &'k Named<Option<SceneNode>>, elements: &'k Named<Draft>) -> Self {
        let is_open =
            |draft: &Draft| draft.kind().is_none_or(|kind| kind.slides() && draft.nodes().len() < kind.nodes.len());
        let mut slides = vec![elements.things().iter().any(is_open); nodes.len()];
        let sliding = |draft: &&Draft| draft.kind().is_some_and(Kind::slides);
        let of_elements = elements.things().iter().filter(sliding).flat_map(Draft::nodes);
        of_elements.for_each(|&node| slides[node as usize] = true);
        let [moved, pressed] = [Mentioned::none(nodes, "node"), Mentioned::none(nodes, "node")];
        Self { dimension, moved, pressed, loaded: Mentioned::none(elements, "element"), slides }
    }

    /// Reads a frame; `last` is the time of the one before it.
    fn frame(&mut self, reader: &mut Reader, index: usize, last: Option<f64>) -> Read<ReadFrame> {
        let Self { dimension, moved, pressed, loaded, slides } = self;
        let sliding = *dimension == Dimension::Axisymmetric;
        let keys = if sliding { &keys::SLIDING_FRAME } else { &keys::FRAME };
        let (mut time, mut frame) = (Given::Absent, Frame::default());
        let is_object = reader.record(keys, |reader, key| match key {
            0 => {
                time = time_of(reader, last)?;
                Ok(())
            }
            1 => moved.each(reader, index, |reader, node, _| motion_of(reader, *dimension, node, &mut frame)),
            _ if sliding => pressed.each(reader, index, |reader, node, place| {
                if !slides[node as usize] {
                    reader.fault(place, "a node of no element", "a node that slides on a line");
                }
                if let Some(pressure) = reader.number(Domain::NonNegative)? {
                    frame.pressures.push(node, pressure);
                }
                Ok(())
            }),
            _ => {
                let elements = loaded.known;
                loaded.each(reader, index, |reader, element, _| match elements[element].kind() {
                    Some(kind) => loads_of(reader, kind, element, &mut frame),
                    None => reader.skip(),
                })
            }
        })?;
        Ok(ReadFrame { is_object, time, changes: frame })
    }
}

fn time_of(reader: &mut Reader, last: Option<f64>) -> Read<Given> {
    let place = reader.place();
    let time = Given::read(reader, Domain::Real)?;
    if let (Some(time), Some(last)) = (time.number(), last)
        && time <= last
    {
        reader.fault(place, format!("{time:?}"), format!("a time after the last frame's, {last:?}"));
    }
    Ok(time)
}

/// What frames mention by name, each once a frame.
struct Mentioned<'k, T> {
    known: &'k Named<T>,
    what: &'static str,
    /// The last frame that mentioned each, if one did.
    last: Vec<Option<usize>>,
}

impl<'k, T> Mentioned<'k, T> {
    fn none(known: &'k Named<T>, what: &'static str) -> Self {
        Self { known, what, last: vec![None; known.len()] }
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
            let Some(index) = look_up(reader, known, place, name, what) else { return reader.skip() };
            if last[index as usize].replace(frame) == Some(frame) {
                reader.fault(place, format!("{name:?} for the second time"), "each name once");
            }
            read(reader, index, place)
        })?;
        Ok(())
    }
}

fn motion_of(reader: &mut Reader, dimension: Dimension, node: u32, frame: &mut Frame) -> Read<()> {
    let keys = if dimension == Dimension::Axisymmetric { &keys::MOTION[..1] } else { &keys::MOTION };
    reader.record(keys, |reader, key| {
        let (motions, by) = match key {
            0 => (&mut frame.moves, point(reader, dimension)?),
            _ if dimension == Dimension::Space => (&mut frame.turns, reader.vector()?),
            _ => (&mut frame.turns, reader.number(Domain::Angle)?.map(|angle| [0.0, 0.0, angle])),
        };
        if let Some(by) = by {
            motions.push(node, by);
        }
        Ok(())
    })?;
    Ok(())
}

fn loads_of(reader: &mut Reader, kind: &Kind, element: u32, frame: &mut Frame) -> Read<()> {
    let names: Vec<_> = kind.loads().collect();
    reader.record(&names, |reader, key| {
        let value = reader.number(kind.domain(names[key]))?;
        if frame.loads.len() <= key {
            frame.loads.resize_with(key + 1, Changes::default);
        }
        if let Some(value) = value {
            frame.loads[key].push(element, value);
        }
        Ok(())
    })?;
    Ok(())
}
