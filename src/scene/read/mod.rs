//! From the text of a scene file to a checked [`Scene`].

mod checks;
mod columns;
mod elements;
mod frames;
mod given;
mod history;
pub(super) mod keys;
mod names;
mod nodes;
mod outputs;
mod slide_lines;
mod tables;
mod triads;

use super::angles::AngleUnit;
use super::json::{Faults, Read, Reader};
use super::kind::Dimension;
use super::model::{Frame, History, Scene};
use columns::Columns;
use elements::{Draft, Known, elements_of};
use frames::{Mentions, frames_of};
use history::history_of;
use nodes::{Nodes, nodes_of, orientations_of};
use outputs::Outputs;
use slide_lines::slide_lines_of;
use std::path::Path;
use tables::NamedTables;
use triads::Inherited;

impl Scene {
    /// Reads the text of a scene and checks it.
    ///
    /// # Errors
    /// All faults, each with its JSON path, line and column, and with what was found and what is allowed. Text that is not JSON
    /// is the last fault reported.
    pub fn parse(text: &str) -> Result<Self, Faults> {
        Self::read(text, None)
    }

    /// The same for a text in a file in this folder, next to the file of columns that it may name. All numbers of the history are
    /// checked and left in that file, which stays open and is read again, state by state, by every run.
    ///
    /// # Errors
    /// As [`Scene::parse`], and all faults of the columns: the file, the array, and the index.
    pub fn parse_in(folder: &Path, text: &str) -> Result<Self, Faults> {
        Self::read(text, Some(folder))
    }

    fn read(text: &str, folder: Option<&Path>) -> Result<Self, Faults> {
        let mut reader = Reader::new(text);
        let scene = scene(&mut reader, folder);
        match scene {
            Ok(Some(scene)) if reader.faults.none() => Ok(scene),
            _ => Err(reader.faults),
        }
    }
}

/// Finds the position of each part first, then reads the parts in the order in which they refer to each other. `None` after a
/// fault.
fn scene(reader: &mut Reader, folder: Option<&Path>) -> Read<Option<Scene>> {
    let start = reader.place();
    let mut parts = [None; keys::SCENE.len()];
    let is_object = reader.record(&keys::SCENE, |reader, key| {
        parts[key] = Some(reader.place());
        reader.skip()
    })?;
    reader.end()?;
    if !is_object {
        return Ok(None);
    }
    for (key, part) in keys::SCENE.iter().zip(parts) {
        if part.is_none() && ["dimension", "nodes", "elements"].contains(key) {
            reader.fault(start, format!("no {key:?}"), "a scene with dimension, nodes and elements");
        }
    }
    let [title, dimension, angles, columns, orientations, nodes, lines, elements, frames, outputs] = parts;
    let title = part(reader, "title", title, |reader| reader.string("a string"))?.flatten().unwrap_or_default();
    let dimension = part(reader, "dimension", dimension, dimension_of)?.flatten();
    let Some(dimension) = dimension else { return Ok(None) };
    if let Some(unit) = part(reader, "angles", angles, angles_of)?.flatten() {
        reader.angles = unit;
    }
    let columns = part(reader, "columns", columns, |reader| Columns::read(reader, folder))?.unwrap_or_default();
    let turns = part(reader, "orientations", orientations, |reader| orientations_of(reader, dimension))?;
    let turns = turns.unwrap_or_default();
    // Without these, every reference to them would be another fault.
    let (Some(_), Some(_)) = (nodes, elements) else { return Ok(None) };
    let nodes = part(reader, "nodes", nodes, |reader| nodes_of(reader, dimension, &turns, &columns))?;
    let Some(Nodes { named: nodes, at }) = nodes else { return Ok(None) };
    let lines = lines.filter(|&place| belongs(reader, place, dimension));
    let lines = part(reader, "slide_lines", lines, |reader| slide_lines_of(reader, &nodes))?.unwrap_or_default();
    let outputs = part(reader, "outputs", outputs, |reader| Outputs::read(reader, dimension))?.unwrap_or_default();
    let mut inherited = Inherited::default();
    let elements = part(reader, "elements", elements, |reader| {
        elements_of(
            reader,
            dimension,
            &Known { nodes: &nodes, lines: &lines, columns: &columns },
            &outputs,
            &mut inherited,
        )
    })?;
    let elements = elements.unwrap_or_default();
    let tables = part(reader, "frames", frames, |reader| NamedTables::read(reader, folder))?.flatten();
    let frames = frames.filter(|_| tables.is_none());
    let history = part(reader, "frames", frames, |reader| {
        let mut mentions = Mentions::new(dimension, &nodes, &elements);
        match columns.file() {
            Some(file) if reader.begins_with(b'{') => history_of(reader, &mut mentions, &columns, file),
            _ => frames_of(reader, &mut mentions).map(History::Frames),
        }
    })?;
    let history = history.unwrap_or_else(|| History::Frames(vec![Frame::default()]));
    let angles = reader.angles;
    let whole = || {
        Some(Scene {
            title: title.into(),
            dimension,
            angles,
            orientations: turns.each(|orientation| orientation)?,
            nodes: {
                let mut places = 0..;
                nodes.each(|node| Some(inherited.give(places.next()?, node?)))?
            },
            at,
            lines: lines.each(|line| line)?,
            elements: elements.each(Draft::whole)?,
            history,
        })
    };
    let scene = whole();
    match (tables, scene) {
        (Some(tables), Some(scene)) => Ok(tables.give(reader, scene)),
        (_, scene) => Ok(scene),
    }
}

/// Whether slide lines are allowed in the scene.
fn belongs(reader: &mut Reader, lines: usize, dimension: Dimension) -> bool {
    let belong = dimension == Dimension::Axisymmetric;
    if !belong {
        reader.below("slide_lines", |reader| reader.fault(lines, "slide lines", "none but in an axisymmetric scene"));
    }
    belong
}

/// A part of the scene, if there is one.
fn part<'t, T>(
    reader: &mut Reader<'t>,
    key: &'static str,
    place: Option<usize>,
    read: impl FnOnce(&mut Reader<'t>) -> Read<T>,
) -> Read<Option<T>> {
    let Some(place) = place else { return Ok(None) };
    reader.go(place);
    reader.below(key, read).map(Some)
}

fn dimension_of(reader: &mut Reader) -> Read<Option<Dimension>> {
    named_one_of(reader, Dimension::ALL.map(|dimension| (dimension.name(), dimension)))
}

/// The unit of all angles in the file.
fn angles_of(reader: &mut Reader) -> Read<Option<AngleUnit>> {
    named_one_of(reader, AngleUnit::NAMES)
}

/// One of these things, by its name.
fn named_one_of<T: Copy, const N: usize>(reader: &mut Reader, known: [(&str, T); N]) -> Read<Option<T>> {
    let place = reader.place();
    let allowed = known.map(|(name, _)| name).join(", ");
    let Some(name) = reader.string(&allowed)? else { return Ok(None) };
    let found = known.into_iter().find(|(known, _)| *known == name).map(|(_, thing)| thing);
    if found.is_none() {
        reader.fault(place, format!("{name:?}"), allowed);
    }
    Ok(found)
}
