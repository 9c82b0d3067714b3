//! The forms shown below an equation: closed over its inputs, and its variation.

use super::closed::{flat, put_in};
use super::error::Error;
use super::scope::Entries;
use super::syntax::{Body, Statement};
use super::variation::variations;
use super::{Claims, Equation, Setting, Signature, latex, named};

/// An equation closed over its inputs, and the variations of its outputs; derived from the equation, in LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct View {
    /// The equation with definitions from other entries included, one statement per line; empty if there are none.
    pub closed: Vec<String>,
    /// The variations of its definitions, one statement per line.
    pub variation: Vec<String>,
    /// Further definitions that the variations refer to.
    definitions: Vec<String>,
}

impl View {
    /// The views of a formula's equation; `None` if entries that it refers to use one symbol for different things.
    ///
    /// # Errors
    /// If the equation cannot be read.
    pub fn of(formula: &Signature) -> Result<Option<Self>, Error> {
        let Signature { spec, inputs, outputs } = formula;
        let (inputs, outputs) = (named(inputs)?, named(outputs)?);
        let inputs: Vec<_> = inputs.into_iter().map(|(name, _)| name).collect();
        let is_output = |name: &super::Name| {
            outputs.iter().any(|(output, _)| output == name || name.component().is_some_and(|(of, _)| of == *output))
        };
        let entries = Entries::read(spec.id, spec.latex, spec.given)?;
        let Some(statements) = flat(&entries) else { return Ok(None) };
        let lines = |all: &[Statement]| all.iter().map(latex::statement).collect::<Vec<_>>();
        let is_definition = |s: &&Statement| !is_output(&s.names[0]) && !matches!(s.body, Body::ArgMin(_));
        let definitions: Vec<_> = statements.iter().filter(is_definition).cloned().collect();
        Ok(Some(Self {
            variation: lines(&variations(&statements, &inputs)),
            definitions: lines(&definitions),
            closed: if spec.given.is_empty() { Vec::new() } else { lines(&put_in(statements, is_output)) },
        }))
    }

    /// The closed equation, as an executable equation.
    ///
    /// # Errors
    /// If it cannot be read, which would be a bug of the LaTeX writer.
    pub fn equation(&self, formula: &Signature) -> Result<Option<Equation>, Error> {
        let Signature { spec, inputs, outputs } = formula;
        if self.closed.is_empty() {
            return Ok(None);
        }
        let closed = self.closed.join(r",\quad ");
        Equation::new(spec.id, &closed, &[], &named(inputs)?, &named(outputs)?).map(Some)
    }

    /// The variations as claims about the formula.
    ///
    /// # Errors
    /// As for [`View::equation`].
    pub fn claims(&self, formula: &Signature) -> Result<Claims, Error> {
        let setting = Setting {
            of: Some(*formula),
            is_closed: true,
            definitions: self.definitions.join(r",\quad "),
            ..Setting::default()
        };
        Claims::read(&self.variation.join(r",\quad "), &setting)
    }
}
