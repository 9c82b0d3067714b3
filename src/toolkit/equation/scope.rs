//! The definitions that the symbols of an equation can refer to: its own, and those taken from others by "where".

use super::error::Error;
use super::name::Name;
use super::statement::{statements, symbols};
use super::syntax::{ArgMin, Body, Statement};
use crate::formula::{Given, Spec};

/// An equation, and the sources of the symbols that it does not define.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// The formula's identifier.
    pub(super) id: &'static str,
    pub(super) statements: Vec<Statement>,
    pub(super) given: Vec<Taken>,
}

/// A symbol that another equation defines.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    pub(super) name: Name,
    pub(super) parameters: Vec<Name>,
    /// The index of that equation in the list of entries.
    pub(super) from: usize,
}

/// The entries that an equation needs; the first is its own.
#[derive(Clone, Debug, Default)]
pub(super) struct Entries(pub(super) Vec<Entry>);

impl Entries {
    /// Reads an equation and all those it refers to.
    pub(super) fn read(id: &'static str, latex: &str, given: &[Given]) -> Result<Self, Error> {
        let mut all = Self::default();
        all.add(id, latex, given)?;
        Ok(all)
    }

    fn add(&mut self, id: &'static str, latex: &str, given: &[Given]) -> Result<usize, Error> {
        if let Some(known) = self.0.iter().position(|entry| entry.id == id) {
            return Ok(known);
        }
        let place = self.0.len();
        self.0.push(Entry { id, statements: Vec::new(), given: Vec::new() });
        let mut taken = Vec::new();
        for source in given {
            let from = self.add_spec(source.from)?;
            let listed = symbols(source.symbols).map_err(|error| error.of_entry(id, "where"))?;
            taken.extend(listed.into_iter().map(|(name, parameters)| Taken { name, parameters, from }));
        }
        let functions = taken.iter().filter(|taken| !taken.parameters.is_empty()).map(|taken| taken.name.clone());
        let statements = statements(latex, functions.collect()).map_err(|error| error.of_entry(id, "equation"))?;
        self.0[place] = Entry { id, statements, given: taken };
        self.check(place)?;
        Ok(place)
    }

    pub(super) fn add_spec(&mut self, spec: &Spec) -> Result<usize, Error> {
        self.add(spec.id, spec.latex, spec.given)
    }

    /// Checks that nothing is defined twice, and that every symbol taken from elsewhere is defined there.
    pub(super) fn check(&self, place: usize) -> Result<(), Error> {
        let entry = &self.0[place];
        for (k, statement) in entry.statements.iter().enumerate() {
            let name = &statement.names[0];
            let twice = entry.statements[..k].iter().any(|earlier| earlier.names[0] == *name)
                || entry.given.iter().any(|taken| taken.name == *name);
            if twice {
                return Err(Error::new(statement.at, format!("{name} is defined twice")).of_entry(entry.id, "equation"));
            }
        }
        for taken in &entry.given {
            let source = &self.0[taken.from];
            let is_there = source.statements.iter().any(|statement| statement.names[0] == taken.name)
                || source.given.iter().any(|other| other.name == taken.name);
            if !is_there {
                let what = format!("{} does not define {}", source.id, taken.name);
                return Err(Error::new(0, what).of_entry(entry.id, "where"));
            }
        }
        Ok(())
    }

    /// The definition of a symbol in the equation itself, if it is a minimiser.
    pub(super) fn arg_min(&self, name: &Name) -> Option<&ArgMin> {
        let mut statements = self.0.iter().take(1).flat_map(|entry| &entry.statements);
        let found = statements.find(|statement| statement.names[0] == *name)?;
        match &found.body {
            Body::ArgMin(found) => Some(found),
            Body::Equal(_) | Body::Chain(..) => None,
        }
    }
}
