//! What the tables of scenes are made of: what a kind of element is given, its formulas, and its outputs with their names.
//!
//! A table contains only what is not defined elsewhere. Formulas are wired by the names of their fields: an input `x` is read
//! from the output `x` of another formula, or from a given quantity of the element with that name. The meaning of a name, its
//! unit and its allowed values are defined by the field's [`Quantity`].

mod check;
mod dimension;
mod given;
mod lanes;
mod step;

pub(crate) use check::check;
pub use dimension::Dimension;
pub(crate) use given::{FORCES, Given, MOMENTS, NODES, Outputs, SECOND_TRIAD, WITH_FRICTION, WITHOUT_FRICTION};
pub(crate) use lanes::{Column, LANES, Span};
pub use lanes::{Failure, Lanes, Wiring};
pub use step::{Number, Step};

use crate::formula::quantity::{Domain, Quantity};
use crate::formula::{Field, Fields, Formula};

/// The source of a register's value, if no formula computes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// The current position of a node, by its index in the element's list.
    Position(usize),
    /// The change of that position since the last state.
    Increment(usize),
    /// A vector of a node's triad in its current orientation: node, axis from 0.
    Axis(usize, usize),
    /// The value that another register has in the initial configuration.
    Initial(&'static str),
    /// The value that another register had in the last state; 0 before the first.
    Before(&'static str),
    /// A parameter of the element.
    Parameter(Fallback),
    /// A force or moment of the element, from the frames; 0 until given.
    Load,
    /// Zero: a quantity that does not exist in this dimension.
    Zero,
}

/// The value of a parameter that a scene does not give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fallback {
    /// It must be given if an output needs it.
    Required,
    /// A number.
    Number(f64),
    /// The value of another register.
    As(&'static str),
}

impl std::fmt::Display for Fallback {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Required => f.write_str("must be given where an output needs it"),
            Self::Number(number) => write!(f, "{number} if not given"),
            Self::As(other) => write!(f, "{other} if not given"),
        }
    }
}

impl Fallback {
    /// The number, if it is one.
    pub const fn number(self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(number),
            _ => None,
        }
    }
}

/// The condition under which a formula is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// Always.
    Always,
    /// Only if all these parameters are 0, which switches their terms off.
    AllZero(&'static [&'static str]),
    /// Only if one of these parameters is not 0.
    NotAllZero(&'static [&'static str]),
    /// Only if all these parameters are given.
    AllGiven(&'static [&'static str]),
    /// Only if one of these parameters is not given.
    NotAllGiven(&'static [&'static str]),
}

/// A formula of a kind.
#[derive(Clone, Copy)]
pub struct Use {
    /// The formula.
    pub(crate) step: &'static dyn Step,
    /// Its inputs.
    pub(crate) inputs: &'static [Field],
    /// Its outputs.
    pub(crate) outputs: &'static [Field],
    /// Fields that have another name here: `(field, register)`.
    pub(crate) renamed: &'static [(&'static str, &'static str)],
    /// When it is taken.
    pub(crate) when: When,
}

/// A formula under its own names.
pub(crate) const fn always<F: Formula>(step: &'static F) -> Use {
    renamed(step, &[])
}

/// A formula with some fields renamed.
pub(crate) const fn renamed<F: Formula>(step: &'static F, renamed: &'static [(&'static str, &'static str)]) -> Use {
    let (inputs, outputs) = (<F::Inputs<f64> as Fields<f64>>::FIELDS, <F::Outputs<f64> as Fields<f64>>::FIELDS);
    Use { step, inputs, outputs, renamed, when: When::Always }
}

impl Use {
    /// The identifier of the formula.
    pub fn id(&self) -> &'static str {
        self.step.spec().id
    }

    /// The same formula, used only under a condition.
    pub(crate) const fn when(self, when: When) -> Self {
        Self { when, ..self }
    }

    /// The register of a field.
    pub fn register(&self, field: &'static str) -> &'static str {
        self.renamed.iter().find(|(name, _)| *name == field).map_or(field, |(_, register)| register)
    }

    /// The field that this formula writes to a register.
    pub fn writes(&self, register: &str) -> Option<&'static Field> {
        self.outputs.iter().find(|field| self.register(field.name) == register)
    }

    /// The field that this formula reads from a register.
    pub fn reads(&self, register: &str) -> Option<&'static Field> {
        self.inputs.iter().find(|field| self.register(field.name) == register)
    }
}

/// A kind of element in one dimension.
pub struct Kind {
    /// The name in scene files.
    pub name: &'static str,
    /// The dimension in which it can be used.
    pub dimension: Dimension,
    /// Its nodes, by their roles.
    pub nodes: &'static [&'static str],
    /// Registers that no formula computes, with their sources; in groups, some of which are shared by several kinds.
    pub given: &'static [&'static [(&'static str, Origin)]],
    /// Pairs of parameters of which the first must not exceed the second.
    pub ordered: &'static [(&'static str, &'static str)],
    /// Its formulas, of which only one at a time computes a register; in groups, some of which are shared by several kinds.
    pub formulas: &'static [&'static [Use]],
    /// Registers whose meaning differs from that of the fields of their formulas.
    pub meanings: &'static [(&'static str, &'static Quantity)],
    /// Its outputs: the name in scene files, and the register that is shown; in groups, some of which are shared by several
    /// kinds.
    pub outputs: &'static [&'static [(&'static str, &'static str)]],
}

impl Kind {
    /// The registers that no formula computes, with their sources.
    fn registers(&self) -> impl Iterator<Item = (&'static str, Origin)> + use<> {
        self.given.iter().copied().flatten().copied()
    }

    /// Its formulas, of which only one at a time computes a register.
    pub fn formulas(&self) -> impl Iterator<Item = &'static Use> + use<> {
        self.formulas.iter().copied().flatten()
    }

    /// Its outputs: the name in scene files, and the register that is shown.
    pub fn outputs(&self) -> impl Iterator<Item = (&'static str, &'static str)> + use<> {
        self.outputs.iter().copied().flatten().copied()
    }

    /// The sources of the registers that no formula computes.
    pub(crate) fn origins(&self) -> impl Iterator<Item = Origin> + use<> {
        self.registers().map(|(_, origin)| origin)
    }

    /// The source of a register, if no formula computes it.
    pub fn given(&self, register: &str) -> Option<Origin> {
        self.registers().find(|(name, _)| *name == register).map(|(_, from)| from)
    }

    /// The field of a formula that writes or reads a register.
    pub(crate) fn field(&self, register: &str) -> Option<&'static Field> {
        let writes = self.formulas().find_map(|formula| formula.writes(register));
        writes.or_else(|| self.formulas().find_map(|formula| formula.reads(register)))
    }

    /// The quantity in a register.
    pub fn quantity(&self, register: &str) -> Option<&'static Quantity> {
        let meaning = self.meanings.iter().find(|(name, _)| *name == register).map(|(_, quantity)| *quantity);
        meaning.or_else(|| self.field(register).map(|field| field.quantity))
    }

    /// The meaning of a register of this kind, in words.
    pub(crate) fn meaning(&self, register: &str) -> &'static str {
        self.quantity(register).expect("a formula reads every register that is given").meaning
    }

    /// The allowed values of a given register of this kind.
    pub(crate) fn domain(&self, register: &str) -> Domain {
        self.quantity(register).expect("a formula reads every register that is given").domain
    }

    /// The parameters, in order.
    pub fn parameters(&self) -> impl Iterator<Item = (&'static str, Fallback)> {
        self.registers().filter_map(|(name, from)| match from {
            Origin::Parameter(default) => Some((name, default)),
            _ => None,
        })
    }

    /// The loads, in order.
    pub fn loads(&self) -> impl Iterator<Item = &'static str> {
        self.registers().filter(|(_, from)| *from == Origin::Load).map(|(name, _)| name)
    }

    /// The formulas that compute a register.
    pub fn writers<'r>(&'static self, register: &'r str) -> impl Iterator<Item = &'static Use> + use<'r> {
        self.formulas().filter(move |formula| formula.writes(register).is_some())
    }

    /// One bit per parameter, set if the choice of a formula depends on it.
    pub(crate) fn switches(&self) -> u64 {
        let decides = |name: &str| {
            self.formulas().any(|formula| match formula.when {
                When::Always | When::AllGiven(_) | When::NotAllGiven(_) => false,
                When::AllZero(names) | When::NotAllZero(names) => names.contains(&name),
            })
        };
        self.parameters().enumerate().fold(0, |bits, (bit, (name, _))| bits | u64::from(decides(name)) << bit)
    }

    /// Whether it slides on a slide line. Such a kind has no given registers.
    pub fn slides(&self) -> bool {
        self.given.is_empty()
    }

    /// The register of an output.
    pub fn output(&self, name: &str) -> Option<&'static str> {
        self.outputs().find(|(output, _)| *output == name).map(|(_, register)| register)
    }
}

impl std::fmt::Debug for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.name, self.dimension.name())
    }
}
