//! Results of a scene as columns: one array per output, in a file that numpy can open.

use super::abaqus::own_name;
use super::model::Scene;
use super::npz::{Rows, Writer};
use super::plan::Plan;
use super::run::{Gather, Run, Stopped, Warning, array_name};
use crate::Octuple;
use crate::element::table::Number;
use std::fmt;
use std::io::{self, Seek, Write};

/// All results of a scene over its states, one array for every output of an element, a set of elements or a slide line.
///
/// They contain the numbers of [`Results`](super::Results), without a vector or a name for every element of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// The times of the states.
    pub times: Vec<f64>,
    /// Formulas, and how often each was evaluated.
    pub counts: Vec<(&'static str, usize)>,
    /// First those of slide lines, then those of the other elements in the order of the file.
    pub columns: Vec<Column>,
}

/// The reason why columns could not be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum Unwritten {
    /// There are no results.
    Stopped(Stopped),
    /// An error of the file system, or a name that an archive cannot hold.
    Io(io::Error),
}

impl From<Stopped> for Unwritten {
    fn from(stopped: Stopped) -> Self {
        Self::Stopped(stopped)
    }
}

impl From<io::Error> for Unwritten {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl fmt::Display for Unwritten {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stopped(stopped) => stopped.fmt(f),
            Self::Io(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Unwritten {}

/// An output over the states.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The element, the set of elements or the slide line.
    pub element: String,
    /// The output.
    pub output: &'static str,
    /// The number of numbers along each axis: states; the elements of a set; components, if there are several.
    pub shape: Vec<usize>,
    /// State after state; NaN where an output does not exist.
    pub numbers: Vec<f64>,
}

impl Column {
    /// The name of the array in a file: `guide/FN`.
    pub fn name(&self) -> String {
        array_name(&self.element, self.output)
    }
}

impl Columns {
    /// The name of the array of times in a file.
    pub const TIME: &str = "time";

    /// Evaluates a scene in `f64`.
    ///
    /// # Errors
    /// As [`Results::of`](super::Results::of).
    pub fn of(scene: &Scene) -> Result<Self, Stopped> {
        Self::collect::<f64>(&Plan::new(scene), || ())
    }

    /// Evaluates a scene in 237 bits and rounds once.
    ///
    /// # Errors
    /// As [`Columns::of`].
    pub fn exact(scene: &Scene) -> Result<Self, Stopped> {
        Self::of(scene)?;
        Self::collect::<Octuple>(&Plan::new(scene), || ())
    }

    /// Evaluates a plan; `each` is called after every state.
    ///
    /// # Errors
    /// As [`Columns::of`].
    pub fn collect<T: Number>(plan: &Plan<'_>, mut each: impl FnMut()) -> Result<Self, Stopped> {
        let mut run = Run::<T>::new(plan)?;
        let gathered = run.gathered();
        let times: Vec<_> = plan.scene.times().collect();
        let column = |gather: &Gather<'_>| {
            let shape = gather.shape(times.len());
            let numbers = vec![0.0; shape.iter().product()];
            Column { element: gather.name.into(), output: gather.output, shape, numbers }
        };
        let mut columns: Vec<_> = gathered.columns.iter().map(column).collect();
        for state in 0..times.len() {
            run.advance()?;
            each();
            let rows = columns.iter_mut().map(|column| {
                let row = column.numbers.len() / column.shape[0];
                &mut column.numbers[state * row..][..row]
            });
            run.gather(&gathered, &mut rows.collect::<Vec<_>>());
        }
        Ok(Self { times, counts: run.counts(), columns })
    }

    /// Evaluates a plan in `f64` and writes what [`Columns::write`] would write, state by state, so that memory does not grow
    /// with the number of states; `each` is called after every state. Returns what was ambiguous.
    ///
    /// # Errors
    /// As [`Columns::of`] and [`Columns::write`]; after an error the file is incomplete.
    pub fn stream(
        plan: &Plan<'_>,
        to: impl Write + Seek + Send,
        mut each: impl FnMut(),
    ) -> Result<Vec<Warning>, Unwritten> {
        let mut run = Run::<f64>::new(plan)?;
        let gathered = run.gathered();
        let row = |gather: &Gather<'_>| vec![0.0; gather.shape(1).iter().product()];
        let mut rows: Vec<_> = gathered.columns.iter().map(row).collect();
        let times: Vec<_> = plan.scene.times().collect();
        let time = std::iter::once((Self::TIME.into(), vec![times.len()]));
        let arrays = gathered.columns.iter().map(|gather| (gather.array(), gather.shape(times.len())));
        let mut arrays = Rows::new(to, time.chain(arrays))?;
        arrays.push(0, &times)?;
        let mut push = |rows: &[Vec<f64>]| (1..).zip(rows).try_for_each(|(array, row)| arrays.push(array, row));
        for state in 0..times.len() {
            // A state is written while the next one is evaluated.
            let before = if state == 0 { &[] } else { &rows[..] };
            let (written, evaluated) = rayon::join(|| push(before), || run.advance());
            written?;
            evaluated?;
            each();
            run.gather(&gathered, &mut rows.iter_mut().map(|row| &mut row[..]).collect::<Vec<_>>());
        }
        push(&rows)?;
        arrays.finish()?;
        Ok(run.warnings().to_vec())
    }

    /// An output of an element, of a set of elements or of a slide line, by its name here or [in Abaqus](super::SAME_OUTPUTS).
    pub fn get(&self, element: &str, output: &str) -> Option<&Column> {
        let output = own_name(output);
        self.columns.iter().find(|column| column.element == element && column.output == output)
    }

    /// Writes them to a file of arrays, with the same bytes for the same numbers: `time`, then `guide/FN` and so on.
    ///
    /// # Errors
    /// A name that an archive cannot hold, or an error of the file system.
    pub fn write(&self, to: impl Write) -> io::Result<()> {
        let mut arrays = Writer::new(to);
        arrays.write(Self::TIME, &[self.times.len()], &self.times)?;
        for column in &self.columns {
            arrays.write(&column.name(), &column.shape, &column.numbers)?;
        }
        arrays.finish()
    }
}
