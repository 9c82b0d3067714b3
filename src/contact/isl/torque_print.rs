//! The torque table (\*TORQUE PRINT).

use super::contact::Contact;
use super::state::ContactState;
use crate::Scalar;
use crate::formula::error::Error;
use std::fmt;

/// A row of the torque table.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "verify", derive(serde::Serialize, serde::Deserialize))]
pub struct TorqueRow {
    /// The increment, counted from 1.
    pub increment: u32,
    /// The name of the slide line.
    pub slide_line: String,
    /// The greatest torque about the z axis that it transmits with friction coefficient 1 (FL).
    pub torque: f64,
}

/// The torque table: a row per slide line, at every n-th increment.
///
/// Printed with `{}` it is a plain-text table; the rows can be serialised like any other data.
///
/// ```
/// use jointproof::contact::isl::TorquePrint;
/// let mut table = TorquePrint::every(2);
/// for increment in 1..=5 {
///     if table.is_due(increment, increment == 5) {
///         table.record(increment, "flank", 12.5 * f64::from(increment));
///     }
/// }
/// assert_eq!(table.rows().iter().map(|row| row.increment).collect::<Vec<_>>(), [2, 4, 5]);
/// assert_eq!(
///     table.to_string(),
///     " INCREMENT  SLIDE LINE          TORQUE\n\
///      \x20        2  flank           2.500000e1\n\
///      \x20        4  flank           5.000000e1\n\
///      \x20        5  flank           6.250000e1\n"
/// );
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "verify", derive(serde::Serialize, serde::Deserialize))]
pub struct TorquePrint {
    frequency: u32,
    rows: Vec<TorqueRow>,
}

impl Default for TorquePrint {
    fn default() -> Self {
        Self::every(1)
    }
}

impl TorquePrint {
    /// A table that prints at every `frequency`-th increment (FREQUENCY); never if that is 0. The default is 1.
    pub fn every(frequency: u32) -> Self {
        Self { frequency, rows: Vec::new() }
    }

    /// Whether the table prints at this increment, counted from 1, which may be the last of a step. At the last one it always
    /// does, unless its frequency is 0.
    pub fn is_due(&self, increment: u32, is_last: bool) -> bool {
        self.frequency > 0 && (is_last || increment.is_multiple_of(self.frequency))
    }

    /// Adds the row of a slide line. The caller must check whether the increment is due, so that no torque is computed that is
    /// not printed.
    pub fn record(&mut self, increment: u32, slide_line: impl Into<String>, torque: f64) {
        self.rows.push(TorqueRow { increment, slide_line: slide_line.into(), torque });
    }

    /// Adds a row for every contact if the increment is due, and returns whether it was.
    ///
    /// # Errors
    /// As [`Contact::torque`].
    pub fn print<'a, D: Scalar>(
        &mut self,
        increment: u32,
        is_last: bool,
        contacts: impl IntoIterator<Item = (&'a Contact, &'a ContactState<D>)>,
    ) -> Result<bool, Error> {
        let is_due = self.is_due(increment, is_last);
        if is_due {
            for (contact, state) in contacts {
                self.record(increment, contact.name(), contact.torque(state)?.re());
            }
        }
        Ok(is_due)
    }

    /// The rows in the order in which they were added.
    pub fn rows(&self) -> &[TorqueRow] {
        &self.rows
    }
}

impl fmt::Display for TorquePrint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let title = "SLIDE LINE";
        let names = self.rows.iter().map(|row| row.slide_line.chars().count());
        let width = names.fold(title.len(), usize::max);
        writeln!(f, "{:>10}  {title:width$}  {:>14}", "INCREMENT", "TORQUE")?;
        let mut rows = self.rows.iter();
        rows.try_for_each(|TorqueRow { increment, slide_line, torque }| {
            writeln!(f, "{increment:>10}  {slide_line:width$}  {torque:>14.6e}")
        })
    }
}
