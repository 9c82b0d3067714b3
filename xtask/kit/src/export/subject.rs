//! What is exported, and the shapes of its outputs.

use crate::project::Project;
use crate::prove;
use jointproof::catalog::{AnyForm, AnyFormula, Form};
use jointproof::formula::{Bounds, Field, Spec};
use jointproof::toolkit::bound;
use jointproof::toolkit::graph::{Extremes, Graph, NotRecorded};
use std::fmt;

/// What is exported.
#[derive(Clone, Copy)]
pub(super) enum Subject {
    Formula(&'static dyn AnyFormula),
    /// An element in a form, and whether it has friction.
    Element(&'static dyn AnyForm, bool),
}

impl Subject {
    /// An element without friction, and with friction if it can have any.
    pub(super) fn forms(element: &'static dyn AnyForm) -> Vec<Self> {
        let with_friction = (!element.layout().contact.is_empty()).then_some(Self::Element(element, true));
        [Self::Element(element, false)].into_iter().chain(with_friction).collect()
    }

    pub(super) fn spec(self) -> Spec {
        match self {
            Self::Formula(formula) => formula.spec(),
            Self::Element(element, _) => element.spec(),
        }
    }

    pub(super) fn inputs(self) -> &'static [Field] {
        match self {
            Self::Formula(formula) => formula.inputs(),
            Self::Element(element, rubs) => element.inputs(rubs),
        }
    }

    /// `slot_constraint` of the formula `slot.constraint`, `element_slot_rubbing` of the element SLOT with friction.
    pub(super) fn stem(self) -> String {
        match self {
            Self::Formula(formula) => formula.spec().id.replace('.', "_"),
            Self::Element(element, rubs) => {
                format!("element_{}_{}", element.name(), if rubs { "rubbing" } else { "smooth" })
            }
        }
    }

    pub(super) fn graph(self) -> Result<Graph, NotRecorded> {
        match self {
            Self::Formula(formula) => formula.graph(),
            Self::Element(element, rubs) => element.graph(rubs, Extremes::Joined),
        }
    }

    /// Its bounds of η in words.
    pub(super) fn accuracy(self, project: Option<&Project>) -> String {
        match (self, project) {
            (Self::Formula(formula), Some(project)) => prove::accuracy(project, formula, None),
            (Self::Formula(formula), None) => bound::accuracy(&formula.spec(), None, [None; 2]),
            (Self::Element(element, _), _) if element.form() != Form::default() => {
                "no bound of eta is stated in this form".into()
            }
            (Self::Element(element, _), _) => {
                let (Bounds { value, .. }, by) = element.spec().bounds();
                format!("every number: η ≤ {value}, measured{by}")
            }
        }
    }

    /// The path of its golden file below the folder of those; an element has one in its own form alone.
    pub(super) fn golden(self) -> Option<String> {
        let id = self.spec().id;
        match self {
            Self::Formula(_) => Some(format!("{id}.json")),
            Self::Element(element, _) => (element.form() == Form::default()).then(|| format!("elements/{id}.json")),
        }
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Formula(formula) => f.write_str(formula.spec().id),
            Self::Element(element, rubs) => {
                write!(f, "element {} {} friction", element.name(), if *rubs { "with" } else { "without" })
            }
        }
    }
}

/// A function that is printed, and its outputs in the order of its arguments.
pub(super) struct Function {
    pub(super) name: &'static str,
    pub(super) outputs: Vec<Output>,
}

/// An output of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Output {
    pub(super) name: &'static str,
    pub(super) shape: Shape,
    /// The place of its first number among the results of the graph.
    pub(super) first: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Number,
    Vector(usize),
    /// Rows and columns.
    Matrix(usize, usize),
}

impl Output {
    pub(super) fn len(&self) -> usize {
        match self.shape {
            Shape::Number => 1,
            Shape::Vector(len) => len,
            Shape::Matrix(rows, columns) => rows * columns,
        }
    }
}

/// Outputs of these shapes, one after the other.
pub(super) fn placed(shapes: impl IntoIterator<Item = (&'static str, Shape)>) -> Vec<Output> {
    let mut first = 0;
    let place = |(name, shape)| {
        let output = Output { name, shape, first };
        first += output.len();
        output
    };
    shapes.into_iter().map(place).collect()
}
