//! The matrix of a routine beside the derivative of its own value, at a state.

use super::quotients::Slope;

/// An entry that is off by more than this, in parts of the largest of its row, has fewer than eight digits.
const EIGHT_DIGITS: f64 = 1e-8;
/// An entry that is off by more than this, in parts of itself, is wrong however small it is.
const FOUR_DIGITS: f64 = 1e-4;
/// How much larger than its estimate an error may be.
const SAFETY: f64 = 10.0;

/// A matrix, row by row.
#[derive(Clone, Debug)]
pub(super) struct Table {
    pub(super) columns: usize,
    pub(super) entries: Vec<f64>,
}

impl Table {
    pub(super) fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.columns + column]
    }

    pub(super) fn rows(&self) -> usize {
        self.entries.len() / self.columns
    }

    /// A matrix of the same shape.
    pub(super) fn like(&self, entry: impl Fn(usize, usize) -> f64) -> Self {
        let entries = (0..self.entries.len()).map(|k| entry(k / self.columns, k % self.columns)).collect();
        Self { columns: self.columns, entries }
    }
}

/// What a routine answers at a state.
pub(super) struct Answered {
    pub(super) name: String,
    pub(super) x: Vec<f64>,
    pub(super) value: Vec<f64>,
    /// The matrix, at first and at last.
    pub(super) found: [Table; 2],
}

/// The matrix beside the derivative.
pub(super) struct Compared {
    pub(super) at: Answered,
    /// The derivative of the value; on a kink that of the side that is nearer to the matrix.
    pub(super) exact: Table,
    /// The errors of the derivative.
    pub(super) errors: Table,
    /// The derivative with rotations varied in the other way.
    pub(super) otherwise: Option<Table>,
    /// For each entry, the largest of its row by the sizes of the inputs.
    pub(super) units: Table,
    /// Where the derivative jumps: row, column, and both sides.
    pub(super) kinks: Vec<(usize, usize, [f64; 2])>,
}

impl Compared {
    /// From the slope of each output, input by input.
    pub(super) fn new(at: Answered, slopes: &[Vec<Slope>], otherwise: Option<&[Vec<Slope>]>, sizes: &[f64]) -> Self {
        let found = &at.found[0];
        let central = found.like(|row, column| slopes[column][row].central.value);
        let units = found.like(|row, column| {
            let entry = |k: usize| central.at(row, k).abs().max(found.at(row, k).abs()) * sizes[k];
            (0..found.columns).map(entry).filter(|x| x.is_finite()).fold(0.0, f64::max) / sizes[column]
        });
        let mut kinks = Vec::new();
        for row in 0..found.rows() {
            for (column, slopes) in slopes.iter().enumerate() {
                if slopes[row].is_kink(EIGHT_DIGITS.sqrt() * units.at(row, column)) {
                    kinks.push((row, column, slopes[row].sides.map(|side| side.value)));
                }
            }
        }
        let taken = |row: usize, column: usize| {
            let slope = slopes[column][row];
            let is_kink = kinks.iter().any(|&(r, c, _)| (r, c) == (row, column));
            let far = |k: usize| (slope.sides[k].value - found.at(row, column)).abs();
            if !is_kink {
                slope.central
            } else if far(0) <= far(1) {
                slope.sides[0]
            } else {
                slope.sides[1]
            }
        };
        let (exact, errors) = (found.like(|r, c| taken(r, c).value), found.like(|r, c| taken(r, c).error));
        let otherwise = otherwise.map(|slopes| found.like(|row, column| slopes[column][row].central.value));
        Self { at, exact, errors, otherwise, units, kinks }
    }

    /// The matrix of the routine.
    pub(super) fn found(&self) -> &Table {
        &self.at.found[0]
    }

    /// Whether an entry is decided: its derivative is known to more digits than are asked for.
    pub(super) fn is_decided(&self, row: usize, column: usize) -> bool {
        SAFETY * self.errors.at(row, column) <= EIGHT_DIGITS * self.units.at(row, column)
    }

    /// Whether a number is not that of another table, by more than the derivative's error and eight digits.
    pub(super) fn differs(&self, row: usize, column: usize, [one, other]: [f64; 2]) -> bool {
        let (off, error) = ((one - other).abs(), SAFETY * self.errors.at(row, column));
        let by_row = off > error + EIGHT_DIGITS * self.units.at(row, column);
        let by_itself = off > error + 3.0 * FOUR_DIGITS * one.abs().max(other.abs());
        !off.is_finite() || self.errors.at(row, column).is_finite() && (by_row || by_itself && off > 3.0 * error)
    }

    /// The entries of the matrix that are not the derivative.
    pub(super) fn wrong(&self) -> Vec<(usize, usize)> {
        let found = self.found();
        let is_wrong = |&(row, column): &(usize, usize)| {
            self.differs(row, column, [found.at(row, column), self.exact.at(row, column)])
        };
        (0..found.entries.len()).map(|k| (k / found.columns, k % found.columns)).filter(is_wrong).collect()
    }

    /// The digits that an entry and its derivative have in common, in parts of the largest of the row.
    pub(super) fn digits(&self, row: usize, column: usize) -> f64 {
        let off = (self.found().at(row, column) - self.exact.at(row, column)).abs();
        let unit = self.units.at(row, column);
        if unit > 0.0 { -(off / unit).max(1e-16).log10() } else { 16.0 }
    }
}
