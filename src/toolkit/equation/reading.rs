//! What somebody has written about a formula: in LaTeX or as plain text, with the symbols of its entry or others.

use super::closed::symbols;
use super::cursor::Vocabulary;
use super::error::Error;
use super::lower::Writer;
use super::name::Name;
use super::scope::{Entries, Entry, Taken};
use super::statement::{relations, written};
use super::syntax::Statement;
use super::{Claims, Equation, Setting, Signature, named_by};
use crate::formula::Field;

/// An equation that somebody has written about a formula.
#[derive(Clone, Debug)]
pub enum Reading {
    /// It defines outputs, which can be compared with those of the formula.
    Function(Equation),
    /// Its sides are expressions, as in `\tan\alpha = …`: it can hold or not.
    Relation(Claims),
}

impl Reading {
    /// Reads an equation with the symbols of a formula, some of which may be renamed: `("a", "f2")`. What the formula's own
    /// equation defines, and what it takes from elsewhere, is known. The outputs that it defines are compared; if the formula
    /// has a single one, it may have any name.
    ///
    /// # Errors
    /// If it cannot be read, has a symbol that is not known, or says nothing about an output.
    pub fn of(latex: &str, renamed: &[(&str, &str)], formula: &Signature) -> Result<Self, Error> {
        let unread = match Equation::read(latex, renamed, formula) {
            Ok(equation) => return Ok(Self::Function(equation)),
            Err(error) => error,
        };
        let vocabulary = Vocabulary::of(&fields(renamed, formula)?);
        if relations(latex, Vec::new(), &vocabulary).is_ok_and(|all| all.iter().all(Statement::begins_with_symbol)) {
            return Err(unread);
        }
        let renamed = renamed.iter().map(|&(symbol, name)| (symbol.to_owned(), name.to_owned())).collect();
        let setting = Setting { of: Some(*formula), is_deep: true, renamed: Some(renamed), ..Setting::default() };
        match Claims::read(latex, &setting) {
            Ok(claims) => Ok(Self::Relation(claims)),
            // Whoever came further knows better what is wrong.
            Err(error) => Err(if error.at() >= unread.at() { error.of_entry("yours", "equation") } else { unread }),
        }
    }
}

/// The inputs and outputs with the symbols that somebody gives them.
fn fields(renamed: &[(&str, &str)], formula: &Signature) -> Result<Vec<(Name, Field)>, Error> {
    Ok([named_by(renamed, formula.inputs)?, named_by(renamed, formula.outputs)?].concat())
}

impl Equation {
    /// The outputs of a formula as somebody has written them; see [`Reading::of`].
    ///
    /// # Errors
    /// As there.
    pub fn read(latex: &str, renamed: &[(&str, &str)], formula: &Signature) -> Result<Self, Error> {
        let of_yours = |error: Error| error.of_entry("yours", "equation");
        let [inputs, mut outputs] = [named_by(renamed, formula.inputs)?, named_by(renamed, formula.outputs)?];
        let mut vocabulary = Vocabulary::of(&[&inputs[..], &outputs[..]].concat());
        let mut entries = Entries::default();
        entries.0.push(Entry { id: "yours", statements: Vec::new(), given: Vec::new() });
        let given = entries.known(formula)?;
        vocabulary.scripts.extend(given.iter().map(|taken| taken.name.below.concat()));
        let functions = given.iter().filter(|taken| !taken.parameters.is_empty()).map(|taken| taken.name.clone());
        let statements = written(latex, functions.collect(), &vocabulary).map_err(of_yours)?;
        call_outputs(&mut outputs, &statements).map_err(of_yours)?;
        // What is compared is not known, be it under its own symbol or under a new one.
        let own = super::named(formula.outputs)?;
        let is_compared = |name: &Name| {
            let compared = own.iter().zip(&outputs).filter(|(_, (name, field))| defines(&statements, name, field));
            compared.into_iter().any(|((own, field), _)| parts(own, field).any(|part| part == *name))
        };
        let given = given.into_iter().filter(|taken| !is_compared(&taken.name));
        let given = given.filter(|taken| !statements.iter().any(|statement| statement.names[0] == taken.name));
        entries.0[0] = Entry { id: "yours", given: given.collect(), statements };
        entries.check(0)?;
        let mut writer = Writer::new(&entries, &inputs);
        writer.be_lenient(&super::named(formula.inputs)?);
        Self::written_by(writer, &inputs, &outputs, "yours")
    }
}

/// A symbol, and its components if it has some.
fn parts(name: &Name, field: &Field) -> impl Iterator<Item = Name> {
    let components = if field.len() > 1 { field.len() } else { 0 };
    std::iter::once(name.clone()).chain((1..=components).map(|k| name.at(k)))
}

/// Whether one of the statements defines an output or a component of it.
fn defines(statements: &[Statement], name: &Name, field: &Field) -> bool {
    parts(name, field).any(|part| statements.iter().any(|statement| statement.names[0] == part))
}

/// Gives outputs the symbols by which they are defined.
fn call_outputs(outputs: &mut [(Name, Field)], statements: &[Statement]) -> Result<(), Error> {
    let names = || statements.iter().map(|statement| &statement.names[0]);
    for (name, _) in outputs.iter_mut().filter(|(name, field)| !defines(statements, name, field)) {
        if let Some(written) = names().find(|written| written.otherwise().contains(name)) {
            name.clone_from(written);
        }
    }
    if outputs.iter().any(|(name, field)| defines(statements, name, field)) {
        return Ok(());
    }
    let Some(first) = statements.first() else { return Err(Error::new(0, "there is no equation")) };
    let [(name, _)] = outputs else { return Err(Error::undefined(first.at, &first.names[0])) };
    // A single output may have any symbol: the one that nothing else needs.
    let mut used = Vec::new();
    statements.iter().flat_map(Statement::expressions).for_each(|side| symbols(side, &mut used));
    let last = names().rfind(|name| !used.contains(name));
    name.clone_from(last.unwrap_or(&first.names[0]));
    Ok(())
}

impl Entries {
    /// The symbols that the equation of a formula defines, directly or through other formulas.
    pub(super) fn known(&mut self, formula: &Signature) -> Result<Vec<Taken>, Error> {
        self.add_spec(&formula.spec)?;
        let mut given: Vec<Taken> = Vec::new();
        for (from, entry) in self.0.iter().enumerate() {
            let own = entry.statements.iter().map(|statement| {
                let (name, parameters) = (statement.names[0].clone(), statement.parameters.clone());
                Taken { name, parameters, from }
            });
            for taken in own.chain(entry.given.iter().cloned()) {
                if !given.iter().any(|known| known.name == taken.name) {
                    given.push(taken);
                }
            }
        }
        Ok(given)
    }
}
