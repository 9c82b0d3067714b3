//! The history of a scene: its states one by one, or as columns.

use super::frame::{Frame, Quantity};
use super::named::Members;
use crate::formula::quantity::Domain;
use crate::scene::angles::AngleUnit;
use crate::scene::npz::{Archive, Array, PIECE, Unfit};
use crate::scene::table::{Subject, Table};
use indexmap::IndexMap;
use std::sync::Arc;

/// The changes from state to state.
#[derive(Clone, Debug)]
pub(in crate::scene) enum History {
    Frames(Vec<Frame>),
    Columns(HistoryColumns),
    Tables(HistoryTables),
}

impl History {
    /// The number of states.
    pub(in crate::scene) fn len(&self) -> usize {
        match self {
            Self::Frames(frames) => frames.len(),
            Self::Columns(columns) => columns.times.len(),
            Self::Tables(tables) => tables.times.len(),
        }
    }

    /// The time of a state.
    pub(in crate::scene) fn time(&self, state: usize) -> f64 {
        match self {
            Self::Frames(frames) => frames[state].time,
            Self::Columns(columns) => columns.times[state],
            Self::Tables(tables) => tables.times[state],
        }
    }

    /// Frames that mention everything that changes in any state.
    pub(in crate::scene) fn mentions(&self) -> &[Frame] {
        match self {
            Self::Frames(frames) => frames,
            Self::Columns(columns) => std::slice::from_ref(&columns.changed),
            Self::Tables(tables) => std::slice::from_ref(&tables.changed),
        }
    }
}

/// A history in which every value is an array in a file. The values stay there, so memory does not grow with the states.
#[derive(Clone, Debug)]
pub(in crate::scene) struct HistoryColumns {
    pub(in crate::scene) file: Arc<Archive>,
    pub(in crate::scene) times: Vec<f64>,
    pub(in crate::scene) columns: Vec<HistoryColumn>,
    /// The unit of the rotations in the file.
    pub(in crate::scene) angles: AngleUnit,
    /// The nodes and elements that every state changes, without values.
    pub(in crate::scene) changed: Frame,
}

/// A history in tables. The values stay there, so memory does not grow with the states.
#[derive(Clone, Debug)]
pub(in crate::scene) struct HistoryTables {
    /// Each with its subject and its checksum.
    pub(in crate::scene) tables: Vec<(Table, Subject, u32)>,
    pub(in crate::scene) times: Vec<f64>,
    /// The nodes and elements that some state changes, without values.
    pub(in crate::scene) changed: Frame,
    /// The columns that are not used.
    pub(in crate::scene) notes: Vec<String>,
    /// Rows about what is not in the scene.
    pub(in crate::scene) warnings: Vec<String>,
}

/// An array whose first axis is the states, followed by the nodes or elements of a set, and the components.
#[derive(Clone, Debug)]
pub(in crate::scene) struct HistoryColumn {
    /// Its name, and the JSON path to it.
    pub(in crate::scene) array: String,
    pub(in crate::scene) path: String,
    pub(in crate::scene) quantity: Quantity,
    pub(in crate::scene) domain: Domain,
    /// The components of a value that it provides.
    pub(in crate::scene) components: Components,
    pub(in crate::scene) of: Members,
    pub(in crate::scene) places: Places,
}

/// Consecutive components of a value.
#[derive(Clone, Copy, Debug)]
pub(in crate::scene) struct Components {
    pub(in crate::scene) first: usize,
    pub(in crate::scene) count: usize,
}

/// The indices of the members among all that change.
#[derive(Clone, Debug)]
pub(in crate::scene) enum Places {
    /// Consecutive, starting with this one.
    From(usize),
    Each(Box<[usize]>),
}

impl HistoryColumns {
    /// Columns of a file; within a quantity, no two of them have the same nodes or elements.
    pub(in crate::scene) fn new(
        file: Arc<Archive>,
        times: Vec<f64>,
        mut columns: Vec<HistoryColumn>,
        angles: AngleUnit,
    ) -> Self {
        let mut changed = Frame::default();
        let mut numbers: IndexMap<_, Vec<u32>> = IndexMap::new();
        for column in &columns {
            numbers.entry(column.quantity).or_default().extend(column.of.numbers());
        }
        for (quantity, mut numbers) in numbers {
            numbers.sort_unstable();
            *changed.of_mut(quantity) = numbers.into();
        }
        for column in &mut columns {
            column.places = Places::new(column.of, changed.of_mut(column.quantity));
        }
        Self { file, times, columns, angles, changed }
    }
}

impl Places {
    /// The indices of members in this sorted list.
    fn new(members: Members, among: &[u32]) -> Self {
        let place = |number| among.partition_point(|&other| other < number);
        let (first, last) = (members.number(0), members.number(members.len() - 1));
        let from = place(first);
        if place(last) - from + 1 == members.len() as usize {
            return Self::From(from);
        }
        Self::Each(members.numbers().map(place).collect())
    }

    /// The index of a member, counted from 0.
    pub(in crate::scene) fn of(&self, member: usize) -> usize {
        match self {
            Self::From(first) => first + member,
            Self::Each(places) => places[member],
        }
    }
}

/// A column being read, state by state.
#[derive(Debug)]
pub(in crate::scene) struct OpenColumn<'s> {
    pub(in crate::scene) column: &'s HistoryColumn,
    array: Array<'s>,
    /// The number of states left.
    left: usize,
    /// A buffer for some members, small enough to stay in the cache.
    piece: Vec<f64>,
}

impl<'s> OpenColumn<'s> {
    /// Opens the array of a history with this number of states and checks its shape.
    pub(in crate::scene) fn new(column: &'s HistoryColumn, file: &'s Archive, states: usize) -> Result<Self, Unfit> {
        let array = file.array(&column.array)?;
        let Components { count: components, .. } = column.components;
        let members = column.of.count().map(|count| (count as usize, "members"));
        let width = Some((components, "components")).filter(|_| components > 1);
        let (shape, axes): (Vec<_>, Vec<_>) = [Some((states, "states")), members, width].into_iter().flatten().unzip();
        array.outline().expect(&shape, &axes.join(", "))?;
        let piece = vec![0.0; (column.of.len() as usize).min(PIECE / components) * components];
        Ok(Self { column, array, left: states, piece })
    }

    /// Reads the next state into its values, which are contiguous.
    pub(in crate::scene) fn advance_to(&mut self, values: &mut [f64]) -> Result<(), Unfit> {
        self.array.fill(values, self.column.domain)?;
        self.end_state()
    }

    /// Reads the next state, piece by piece; `take` receives the index of the first member of each piece.
    pub(in crate::scene) fn advance(&mut self, mut take: impl FnMut(usize, &[f64])) -> Result<(), Unfit> {
        let Components { count: components, .. } = self.column.components;
        let members = self.column.of.len() as usize;
        let at_once = self.piece.len() / components;
        for first in (0..members).step_by(at_once) {
            let piece = &mut self.piece[..at_once.min(members - first) * components];
            self.array.fill(piece, self.column.domain)?;
            take(first, piece);
        }
        self.end_state()
    }

    fn end_state(&mut self) -> Result<(), Unfit> {
        self.left -= 1;
        if self.left == 0 { self.array.finish() } else { Ok(()) }
    }

    /// The number of bytes of the buffer.
    pub(in crate::scene) fn bytes(&self) -> usize {
        size_of_val(&*self.piece)
    }
}
