//! The states of a history, one after the other.

use super::problem::Unreadable;
use crate::scene::angles::AngleUnit;
use crate::scene::model::{
    Components, Frame, History, HistoryColumn, HistoryColumns, HistoryTables, OpenColumn, Places, Scene,
};
use crate::scene::npz::Unfit;
use crate::scene::tables::{Rows, TableFault};
use rayon::prelude::*;
use std::borrow::Cow;

/// The remaining frames.
#[derive(Debug)]
pub(super) enum States<'s> {
    Frames(std::slice::Iter<'s, Frame>),
    Columns(Reading<'s>),
    Tables(ReadingTables<'s>),
}

/// Columns being read state by state.
#[derive(Debug)]
pub(super) struct Reading<'s> {
    times: std::slice::Iter<'s, f64>,
    /// The columns of each quantity, by its index.
    open: Vec<Vec<OpenColumn<'s>>>,
    angles: AngleUnit,
    /// Memory for the next state.
    frame: Frame,
}

impl<'s> States<'s> {
    pub(super) fn new(scene: &'s Scene) -> Result<Self, Unreadable> {
        Ok(match &scene.history {
            History::Frames(frames) => Self::Frames(frames.iter()),
            History::Columns(columns) => Self::Columns(Reading::new(columns)?),
            History::Tables(tables) => Self::Tables(ReadingTables::new(scene, tables)?),
        })
    }

    /// The next frame, if there is one.
    pub(super) fn advance(&mut self) -> Result<Option<Cow<'s, Frame>>, Unreadable> {
        match self {
            Self::Frames(frames) => Ok(frames.next().map(Cow::Borrowed)),
            Self::Columns(reading) => Ok(reading.advance()?.map(Cow::Owned)),
            Self::Tables(reading) => Ok(reading.advance()?.map(Cow::Owned)),
        }
    }

    /// The number of bytes that persist from state to state.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Frames(_) => 0,
            Self::Columns(Reading { open, frame, .. }) => {
                frame.bytes() + open.iter().flatten().map(OpenColumn::bytes).sum::<usize>()
            }
            Self::Tables(ReadingTables { open, .. }) => open.iter().map(|(rows, _)| rows.bytes()).sum(),
        }
    }

    /// Takes back the memory of a frame.
    pub(super) fn reuse(&mut self, frame: Cow<'s, Frame>) {
        if let (Self::Columns(reading), Cow::Owned(frame)) = (self, frame) {
            reading.frame = frame;
        }
    }
}

impl<'s> Reading<'s> {
    fn new(columns: &'s HistoryColumns) -> Result<Self, Unreadable> {
        let HistoryColumns { file, times, columns, angles, changed } = columns;
        let mut open = Vec::new();
        for column in columns {
            let opened = OpenColumn::new(column, file, times.len());
            let place = column.quantity.place();
            if open.len() <= place {
                open.resize_with(place + 1, Vec::new);
            }
            open[place].push(opened.map_err(|unfit| unreadable(&column.path, unfit))?);
        }
        Ok(Self { times: times.iter(), open, angles: *angles, frame: changed.zeroed() })
    }

    /// Reads the next state, with its quantities on all cores.
    fn advance(&mut self) -> Result<Option<Frame>, Unreadable> {
        let Some(&time) = self.times.next() else { return Ok(None) };
        let mut frame = std::mem::take(&mut self.frame);
        frame.time = time;
        let mut quantities: Vec<_> = self.open.iter_mut().zip(frame.numbers_mut()).collect();
        let read = |(columns, (numbers, width)): &mut (&mut Vec<OpenColumn>, (&mut [f64], usize))| {
            columns.iter_mut().try_for_each(|column| read(column, numbers, *width))
        };
        // Of several faults the first is reported, whichever core is faster.
        let read: Vec<_> = quantities.par_iter_mut().map(read).collect();
        let Some(fault) = read.into_iter().find_map(Result::err) else {
            frame.turns.to.as_flattened_mut().iter_mut().for_each(|angle| *angle = self.angles.radians(*angle));
            return Ok(Some(frame));
        };
        self.frame = frame;
        Err(fault)
    }
}

/// Tables being read state by state.
#[derive(Debug)]
pub(super) struct ReadingTables<'s> {
    times: std::slice::Iter<'s, f64>,
    /// Each with the checksum that it had when the scene was read.
    open: Vec<(Rows<'s>, u32)>,
}

impl<'s> ReadingTables<'s> {
    fn new(scene: &'s Scene, HistoryTables { tables, times, .. }: &'s HistoryTables) -> Result<Self, Unreadable> {
        let open =
            |(table, subject, sum): &'s (_, _, _)| Ok((Rows::open(scene, table, *subject).map_err(changed)?, *sum));
        Ok(Self { times: times.iter(), open: tables.iter().map(open).collect::<Result<_, Unreadable>>()? })
    }

    /// Reads the next state.
    fn advance(&mut self) -> Result<Option<Frame>, Unreadable> {
        let Some(&time) = self.times.next() else { return Ok(None) };
        let is_last = self.times.as_slice().is_empty();
        let mut frame = Frame { time, ..Frame::default() };
        for (rows, sum) in &mut self.open {
            let state = rows.advance().map_err(changed)?;
            let is_same = state.as_ref().is_some_and(|state| state.time == time);
            if !is_same || is_last && (rows.advance().map_err(changed)?.is_some() || rows.sum() != *sum) {
                return Err(Unreadable {
                    path: rows.name().into(),
                    found: "other rows".into(),
                    allowed: "a table that does not change during the run".into(),
                });
            }
            if let Some(state) = state {
                frame.add(state);
            }
        }
        Ok(Some(frame))
    }
}

/// A table that cannot be read any more.
fn changed(fault: TableFault) -> Unreadable {
    Unreadable { path: fault.table.clone(), found: fault.found(), allowed: fault.allowed }
}

/// Reads the next state of a column into the values of its quantity, each of `width` numbers.
fn read(open: &mut OpenColumn, numbers: &mut [f64], width: usize) -> Result<(), Unreadable> {
    let HistoryColumn { path, places, components, of, .. } = open.column;
    let Components { first: from, count } = *components;
    let read = match places {
        Places::From(place) if count == width => {
            open.advance_to(&mut numbers[place * width..][..of.len() as usize * width])
        }
        places => open.advance(|first, piece| {
            for (member, value) in (first..).zip(piece.chunks_exact(count)) {
                numbers[places.of(member) * width + from..][..count].copy_from_slice(value);
            }
        }),
    };
    read.map_err(|unfit| unreadable(path, unfit))
}

fn unreadable(path: &str, Unfit { found, allowed }: Unfit) -> Unreadable {
    Unreadable { path: path.into(), found, allowed }
}
