//! The history of a scene: motions and loads.

use super::elements::Draft;
use super::given::Given;
use super::keys;
use super::names::look_up_all;
use super::nodes::point;
use crate::formula::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::{Dimension, Kind};
use crate::scene::model::{Frame, Members, Named, SceneNode, Unsorted, moves_with};
use arrayvec::ArrayVec;

pub(super) fn frames_of(reader: &mut Reader, mentions: &mut Mentions) -> Read<Vec<Frame>> {
    let place = reader.place();
    let (mut frames, mut last, mut any) = (Vec::new(), None, false);
    let is_array = reader.array("an array of frames", |reader, index| {
        any = true;
        let place = reader.place();
        let frame = mentions.frame(reader, index, last)?;
        match frame.time {
            _ if !frame.is_object => {}
            Given::Absent => reader.fault(place, "a frame without \"time\"", "a frame with its time"),
            Given::Faulty => {}
            Given::Number(time) => {
                last = Some(time);
                frames.push(frame.changes.sorted(time));
            }
        }
        Ok(())
    })?;
    if is_array && !any {
        reader.fault(place, "no frame", "one frame or more (or no \"frames\" for the initial configuration alone)");
    }
    Ok(frames)
}

/// A frame as far as it was readable.
struct ReadFrame {
    is_object: bool,
    time: Given,
    changes: ReadChanges,
}

/// The changes of a frame, as read.
#[derive(Default)]
struct ReadChanges {
    moves: Unsorted<[f64; 3]>,
    turns: Unsorted<[f64; 3]>,
    loads: Vec<Unsorted<f64>>,
    pressures: Unsorted<f64>,
}

impl ReadChanges {
    fn sorted(self, time: f64) -> Frame {
        let Self { moves, turns, loads, pressures } = self;
        let loads = loads.into_iter().map(Unsorted::sorted).collect();
        Frame { time, moves: moves.sorted(), turns: turns.sorted(), loads, pressures: pressures.sorted() }
    }
}

/// The names that frames may mention.
pub(super) struct Mentions<'k> {
    pub(super) dimension: Dimension,
    pub(super) moved: Mentioned<'k, Option<SceneNode>>,
    pub(super) pressed: Mentioned<'k, Option<SceneNode>>,
    pub(super) loaded: Mentioned<'k, Draft>,
    /// Whether each node may belong to a sliding element; if the nodes of such an element are unknown, any node may.
    pub(super) slides: Vec<bool>,
}

impl<'k> Mentions<'k> {
    pub(super) fn new(dimension: Dimension, nodes: &'k Named<Option<SceneNode>>, elements: &'k Named<Draft>) -> Self {
        let is_open =
            |draft: &Draft| draft.kind().is_none_or(|kind| kind.slides() && draft.nodes().len() < kind.nodes.len());
        let mut slides = vec![elements.things().iter().any(is_open); nodes.len()];
        let sliding = |draft: &&Draft| draft.kind().is_some_and(Kind::slides);
        let of_elements = elements.things().iter().filter(sliding).flat_map(Draft::nodes);
        of_elements.for_each(|nodes| nodes.numbers().for_each(|node| slides[node as usize] = true));
        let [moved, pressed] = [Mentioned::none(nodes, "node"), Mentioned::none(nodes, "node")];
        Self { dimension, moved, pressed, loaded: Mentioned::none(elements, "element"), slides }
    }

    /// Whether elements slide, so that frames have other keys.
    pub(super) fn sliding(&self) -> bool {
        self.dimension == Dimension::Axisymmetric
    }

    /// Reads a frame; `last` is the time of the previous one.
    fn frame(&mut self, reader: &mut Reader, index: usize, last: Option<f64>) -> Read<ReadFrame> {
        let sliding = self.sliding();
        let Self { dimension, moved, pressed, loaded, slides } = self;
        let keys = if sliding { &keys::SLIDING_FRAME } else { &keys::FRAME };
        let (mut time, mut frame) = (Given::Absent, ReadChanges::default());
        let is_object = reader.record(keys, |reader, key| match key {
            0 => {
                time = time_of(reader, last)?;
                Ok(())
            }
            1 => {
                let known = moved.known;
                moved.each(reader, index, |reader, nodes, place| {
                    check_own(reader, place, known, nodes);
                    motion_of(reader, *dimension, nodes, &mut frame)
                })
            }
            _ if sliding => pressed.each(reader, index, |reader, nodes, place| {
                check_sliding(reader, place, slides, nodes);
                if let Some(pressure) = reader.number(Domain::NonNegative)? {
                    frame.pressures.push_all(nodes, pressure);
                }
                Ok(())
            }),
            _ => {
                let elements = loaded.known;
                loaded.each(reader, index, |reader, of, _| match elements[of.number(0)].kind() {
                    Some(kind) => loads_of(reader, kind, of, &mut frame),
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
        && time < last
    {
        reader.fault(place, format!("{time:?}"), format!("a time of at least the last frame's, {last:?}"));
    }
    Ok(time)
}

/// Records a fault if one of these nodes does not slide on a line.
pub(super) fn check_sliding(reader: &mut Reader, place: usize, slides: &[bool], nodes: Members) {
    if nodes.numbers().any(|node| !slides[node as usize]) {
        reader.fault(place, "a node of no element", "a node that slides on a line");
    }
}

/// Records a fault if this node moves with another.
pub(super) fn check_own(reader: &mut Reader, place: usize, known: &Named<Option<SceneNode>>, nodes: Members) {
    if let Some(with) = known[nodes.number(0)].and_then(|node| node.with) {
        let [found, allowed] = moves_with(known.name(nodes.number(0)), known.name(with));
        reader.fault(place, found, allowed);
    }
}

/// The entries that frames mention by name, each once per frame.
pub(super) struct Mentioned<'k, T> {
    pub(super) known: &'k Named<T>,
    what: &'static str,
    /// The last frame that mentioned each, counted from 1; 0 if none did.
    last: Vec<usize>,
}

impl<'k, T> Mentioned<'k, T> {
    fn none(known: &'k Named<T>, what: &'static str) -> Self {
        Self { known, what, last: vec![0; known.len()] }
    }

    /// The members of an object whose keys are names of these entries; `read` receives them, and the position of the key.
    pub(super) fn each(
        &mut self,
        reader: &mut Reader,
        frame: usize,
        mut read: impl FnMut(&mut Reader, Members, usize) -> Read<()>,
    ) -> Read<()> {
        let Self { known, what, last } = self;
        let mut next = 0;
        reader.object(format_args!("an object of {what}s"), |reader, name, place| {
            let found = known.members_near(&mut next, name);
            let found = found.or_else(|| look_up_all(reader, known, place, name, what));
            let Some(members) = found else { return reader.skip() };
            let mut is_twice = false;
            for number in members.numbers() {
                is_twice |= std::mem::replace(&mut last[number as usize], frame + 1) == frame + 1;
            }
            if is_twice {
                reader.fault(place, format!("{name:?} for the second time"), "each name once");
            }
            read(reader, members, place)
        })?;
        Ok(())
    }
}

/// The possible motions of nodes: in the plane of a slide line they do not rotate.
pub(super) fn motions(dimension: Dimension) -> &'static [&'static str] {
    if dimension == Dimension::Axisymmetric { &keys::MOTION[..1] } else { &keys::MOTION }
}

fn motion_of(reader: &mut Reader, dimension: Dimension, nodes: Members, frame: &mut ReadChanges) -> Read<()> {
    reader.record(motions(dimension), |reader, key| {
        let (motions, by) = match key {
            0 => (&mut frame.moves, point(reader, dimension)?),
            _ if dimension == Dimension::Space => (&mut frame.turns, reader.rotation()?),
            _ => (&mut frame.turns, reader.number(Domain::Angle)?.map(in_plane)),
        };
        if let Some(by) = by {
            motions.push_all(nodes, by);
        }
        Ok(())
    })?;
    Ok(())
}

/// The rotation vector of an angle.
fn in_plane(angle: f64) -> [f64; 3] {
    [0.0, 0.0, angle]
}

/// The maximum number of loads of a kind: forces and moments.
const MOST_LOADS: usize = 6;

fn loads_of(reader: &mut Reader, kind: &Kind, elements: Members, frame: &mut ReadChanges) -> Read<()> {
    let names: ArrayVec<_, MOST_LOADS> = kind.loads().collect();
    reader.record(&names, |reader, key| {
        let value = reader.number(kind.domain(names[key]))?;
        if frame.loads.len() <= key {
            frame.loads.resize_with(key + 1, Unsorted::default);
        }
        if let Some(value) = value {
            frame.loads[key].push_all(elements, value);
        }
        Ok(())
    })?;
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn an_angle_in_the_plane_turns_about_the_third_axis() {
        assert_eq!(super::in_plane(0.5), [0.0, 0.0, 0.5]);
    }
}
