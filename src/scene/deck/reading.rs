//! The state of reading a deck: fields as numbers, nodes and names, with a fault where they are something else.

use super::block::Block;
use super::field::{Field, Label, identifier, number, without_blanks};
use super::log::Log;
use super::model::{At, Item, Members, Model, Numbered, Reference, Scope};
use super::motion::Motion;
use super::source::{Place, Sources};

/// What the following keywords belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Context {
    Nothing,
    /// A connector behavior, by its index.
    Behavior(usize),
    /// An interface, by its index.
    Interface(usize),
}

pub(super) struct Reading<'s> {
    pub(super) sources: &'s Sources,
    pub(super) log: Log,
    pub(super) model: Model,
    pub(super) scope: Scope,
    /// How the instance is placed that is being read.
    pub(super) motion: Option<Motion>,
    pub(super) context: Context,
}

/// A value in a message.
pub(super) fn found(text: &str) -> String {
    if text.is_empty() { "a blank field".into() } else { format!("{text:?}") }
}

impl<'s> Reading<'s> {
    pub(super) fn new(sources: &'s Sources, log: Log) -> Self {
        let model = Model { scopes: vec![String::new()], ..Model::default() };
        Self { sources, log, model, scope: 0, motion: None, context: Context::Nothing }
    }

    pub(super) fn fault(&mut self, place: Place, found: impl Into<String>, allowed: impl Into<String>) {
        self.log.fault(place, found, allowed);
    }

    /// A number; `None` if the field is blank, or after a fault.
    pub(super) fn number(&mut self, field: Field) -> Option<f64> {
        if field.text.is_empty() {
            return None;
        }
        let read = number(field.text);
        match read {
            Some(number) if number.is_finite() => return read,
            Some(_) => self.fault(field.place, format!("{}, which no double can hold", field.text), "a finite number"),
            None => self.fault(field.place, found(field.text), "a number"),
        }
        None
    }

    /// The number of a parameter with a value.
    pub(super) fn value(&mut self, block: &Block, name: &str) -> Option<At<f64>> {
        let parameter = block.parameter(name)?;
        let text = parameter.value.as_deref().unwrap_or_default();
        if text.is_empty() {
            self.fault(parameter.place, format!("{name} without a value"), format!("{name}=, followed by a number"));
        }
        self.number(Field { text, place: parameter.place }).map(|number| (number, parameter.place))
    }

    /// The numbers of a line, those of blank fields being 0; a fault if there are more.
    pub(super) fn numbers<'t, const N: usize>(&mut self, all: impl Iterator<Item = Field<'t>>) -> [f64; N] {
        let mut numbers = [0.0; N];
        for (k, field) in all.enumerate() {
            match numbers.get_mut(k) {
                Some(number) => *number = self.number(field).unwrap_or(0.0),
                None if field.text.is_empty() => {}
                None => self.fault(field.place, found(field.text), format!("{N} numbers")),
            }
        }
        numbers
    }

    pub(super) fn identifier(&mut self, field: Field) -> Option<u32> {
        let number = identifier(field.text);
        if number.is_none() {
            self.fault(field.place, found(field.text), "a whole number, at least 1");
        }
        number
    }

    /// The scope of a name, and the name in it: `instance.name` is in an instance.
    pub(super) fn scoped<'t>(&self, text: &'t str) -> (Scope, &'t str) {
        let instance =
            Label::split(text).and_then(|(instance, rest)| Some((*self.model.scope_of.get(&instance.key)?, rest)));
        instance.unwrap_or((self.scope, text))
    }

    /// A node by its number, or by `instance.number`.
    pub(super) fn node(&mut self, field: Field) -> Option<At<Numbered>> {
        let (scope, text) = self.scoped(field.text);
        let number = identifier(text);
        if number.is_none() {
            self.fault(field.place, found(field.text), "the number of a node, or instance.number");
        }
        Some(((scope, number?), field.place))
    }

    /// A number or the name of a set; in an instance if one is named.
    pub(super) fn item(&mut self, field: Field, instance: Option<Scope>) -> Option<Item> {
        let (scope, text) = instance.map_or_else(|| self.scoped(field.text), |scope| (scope, field.text));
        let of = identifier(text).map(Members::One).or_else(|| {
            let starts = text.starts_with(|c: char| c.is_alphabetic() || c == '_' || c == '"');
            Label::new(text).filter(|_| starts).map(|label| Members::Set(label.key))
        });
        if of.is_none() {
            self.fault(field.place, found(field.text), "a number, or the name of a set");
        }
        Some(Item { scope, of: of?, place: field.place })
    }

    pub(super) fn reference(&mut self, field: Field) -> Option<Reference> {
        let Item { scope, of, place } = self.item(field, None)?;
        Some(Reference { scope, of, shown: field.text.into(), place })
    }

    /// The instance that a parameter names.
    pub(super) fn instance(&mut self, block: &Block) -> Option<Scope> {
        let (label, place) = block.label(&mut self.log, "INSTANCE")?;
        let scope = self.model.scope_of.get(&label.key).copied();
        if scope.is_none() {
            self.fault(place, format!("no instance {:?}", label.shown), "the name of an instance above");
        }
        scope
    }

    /// One of these words, as the value of a parameter; the first if it is not given.
    pub(super) fn word<T: Copy>(&mut self, block: &Block, name: &str, words: &[(&str, T)]) -> Option<T> {
        let Some(parameter) = block.parameter(name) else { return words.first().map(|(_, value)| *value) };
        let text = parameter.value.as_deref().unwrap_or_default();
        let written = without_blanks(text).to_uppercase();
        let word = words.iter().find(|(word, _)| without_blanks(word) == written).map(|(_, value)| *value);
        if word.is_none() {
            let allowed = words.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(" or ");
            self.fault(parameter.place, format!("{name}={text}"), format!("{name}={allowed}"));
        }
        word
    }
}
