//! The printed equation, executed.
//!
//! An equation is parsed from its LaTeX, with the symbols of its entry, into a [`Graph`], the form in which formulas
//! are recorded too. The graph yields values and the Jacobian, with which the equation that readers see is compared
//! with the code.
//!
//! # What is read
//!
//! An equation is a sequence of statements separated by commas or `\quad`.
//!
//! | written | means |
//! |---|---|
//! | `x = a = b` | x is a; a and b are equal |
//! | `r(g) = …` | r is a function: elsewhere `r(g)` applies it, where `g(g-1)` is a product |
//! | `(w_1, w_2) = (…, …)` | both at once |
//! | `g_i = …,\quad i = 1, 2` or `…\ (i = 1, 2)` | one statement for each index |
//! | `\begin{cases} a & x > 0,\ y > 0 \\ b & \text{otherwise} \end{cases}` | the first whose comparisons all hold |
//! | `g = \operatorname*{arg\,min}_{-1\le g\le 1} …` | the minimiser of the expression; a given value is checked |
//! | `\sum_{q=1}^{5} …` | the sum of the product that follows |
//! | `n_2`, `x_{m,k}` of **n**, **x**_m | components, by a number or by a symbol that is the number of an axis |
//! | `\Delta x`, `\mathrm{d}x`, `X'`, `F_C^{\mathrm{int}}` | one symbol each; `f_2^2` is a power |
//! | `\mathbf{a}\cdot\mathbf{b}`, `\times`, `\lvert\mathbf{a}\rvert` | products and length; for numbers, product and absolute value |
//! | `\sqrt{}`, `\sin`, `\cos`, `\arcsin`, `\operatorname{atan2}`, `\operatorname{sign}`, `e^x` | functions |
//! | `\mathbf{a}\otimes\mathbf{b}`, `\mathbf{I}`, `\mathbf{a}\times\mathbf{I}` | matrices: **a** **b**ᵀ for two vectors of the same length, the 3×3 unit matrix, and the one that maps **v** to **a** × **v** |
//! | `\mathbf{i}`, `\mathbf{j}`, `\mathbf{k}`, `\mathbf{0}`, `\pi`, `e` | constants, unless the symbol is defined |
//! | `\mathbf{s}\times\mathbf{n}` | **n** rotated by 90° to the left, in the plane |
//! | `\text{…}` between statements | a remark, of words only |
//!
//! A symbol is an input of the entry, is defined by a statement, or comes from another formula by [`Given`]. Anything
//! else is an error with its position. Every input and every statement must be used.
//!
//! ```
//! use jointproof::toolkit::equation::Equation;
//! use jointproof::formula::{Fields, Formula};
//! use jointproof::connector::slot::{Contact, ContactForce, CrossForces};
//!
//! let (inputs, outputs) = (CrossForces::<f64>::FIELDS, Contact::<f64>::FIELDS);
//! let equation = Equation::of(&ContactForce::SPEC, inputs, outputs)?;
//! assert_eq!(equation.values(&[3.0, 4.0], &[]), [5.0]);
//! let error = Equation::read(r"F_C = \sqrt{f_2^2 + f_4^2}", &[], inputs, outputs).unwrap_err();
//! assert_eq!(error.to_string(), "the equation of yours, byte 20: f_4 is nobody's symbol");
//! # Ok::<(), jointproof::toolkit::equation::Error>(())
//! ```

mod claims;
mod closed;
mod cursor;
mod derivative;
mod error;
mod latex;
mod lower;
mod name;
mod parse;
mod rounding;
mod scope;
mod statement;
mod symbol;
mod syntax;
mod token;
mod value;
mod variation;
mod view;

use crate::formula::quantity::Shape;
use crate::formula::{Field, Given, Spec};
use crate::number::octuple::Octuple;
use crate::toolkit::graph::{self, Graph, Node, Op, Unary};
pub(crate) use claims::{ClaimAt, Free};
pub use claims::{Claims, Setting, Signature};
pub use error::Error;
use lower::{Place, Writer};
use name::Name;
use scope::Entries;
use std::collections::BTreeSet;
use syntax::ArgMin;
use value::Value;
pub use view::View;

/// An equation that can be executed.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The outputs are its value.
    graph: Graph,
    /// All nodes to be evaluated, in order.
    needed: Vec<Node>,
    /// Pairs of forms that are printed as equal.
    equal: BTreeSet<(Node, Node)>,
    smallest: Option<Smallest>,
}

/// An output defined as the minimiser of an expression.
#[derive(Clone, Debug)]
struct Smallest {
    /// The index among the components of the outputs.
    output: usize,
    place: Node,
    low: Node,
    high: Node,
    objective: Node,
    /// The derivative of the objective with respect to the minimiser.
    slope: Node,
}

/// The values of an equation at a point.
pub(crate) struct Results {
    pub(crate) outputs: Vec<Octuple>,
    /// Numbers that are printed as equal.
    pub(crate) equal: Vec<(Octuple, Octuple)>,
    pub(crate) smallest: Option<SmallestAt>,
    /// The values of all operations.
    all: Vec<Octuple>,
}

/// A minimiser, which is known rather than searched for.
pub(crate) struct SmallestAt {
    /// The index among the components of the outputs.
    pub(crate) output: usize,
    pub(crate) place: Octuple,
    pub(crate) low: Octuple,
    pub(crate) high: Octuple,
    pub(crate) objective: Octuple,
    /// The derivative of the objective with respect to the minimiser.
    pub(crate) slope: Octuple,
}

impl Equation {
    /// The printed equation of a formula.
    ///
    /// # Errors
    /// If it cannot be read, or does not define every output from all inputs and nothing else.
    pub fn of(spec: &Spec, inputs: &[Field], outputs: &[Field]) -> Result<Self, Error> {
        Self::new(spec.id, spec.latex, spec.given, &named(inputs)?, &named(outputs)?)
    }

    /// Another equation with the symbols of a formula, some of which may be renamed: `("a", "f2")`. If a formula has a
    /// single output that no statement defines, it is what the first statement defines.
    ///
    /// # Errors
    /// As for [`Equation::of`].
    pub fn read(latex: &str, renamed: &[(&str, &str)], inputs: &[Field], outputs: &[Field]) -> Result<Self, Error> {
        let named = |fields| {
            let mut all = named(fields)?;
            for (name, field) in &mut all {
                if let Some((symbol, _)) = renamed.iter().find(|(_, other)| *other == field.name) {
                    *name = symbol_of(symbol)?;
                }
            }
            Ok(all)
        };
        let mut outputs = named(outputs)?;
        // A single output may have any name.
        let written = statement::statements(latex, Vec::new()).map_err(|error| error.of_entry("yours", "equation"))?;
        if let ([(name, _)], Some(first)) = (&mut outputs[..], written.first())
            && !written.iter().any(|statement| statement.names[0] == *name)
        {
            name.clone_from(&first.names[0]);
        }
        Self::new("yours", latex, &[], &named(inputs)?, &outputs)
    }

    /// An equation with the symbols of a formula, treated as that formula's own.
    ///
    /// # Errors
    /// As for [`Equation::of`].
    pub fn in_place_of(spec: &Spec, latex: &str, inputs: &[Field], outputs: &[Field]) -> Result<Self, Error> {
        Self::new(spec.id, latex, spec.given, &named(inputs)?, &named(outputs)?)
    }

    fn new(
        id: &'static str,
        latex: &str,
        given: &[Given],
        inputs: &[(Name, Field)],
        outputs: &[(Name, Field)],
    ) -> Result<Self, Error> {
        let entries = Entries::read(id, latex, given)?;
        let mut writer = Writer::new(&entries, inputs);
        let mut ids = Vec::new();
        let mut smallest = None;
        for (name, field) in outputs {
            if let Some(place) = entries.arg_min(name) {
                smallest = Some((ids.len(), place));
            }
            ids.extend(output(&mut writer, name, field).map_err(|error| error.of_entry(id, "equation"))?);
        }
        let smallest = match smallest {
            None => None,
            Some((output, found)) => Some(place_of_smallest(&mut writer, output, found, id)?),
        };
        let needed = ids.iter().copied().chain(smallest.iter().flat_map(|s| [s.low, s.high, s.slope]));
        check_closed(&writer, &needed.collect::<Vec<_>>(), inputs).map_err(|error| error.of_entry(id, "equation"))?;
        let Writer { mut graph, equal, .. } = writer;
        let of_smallest = smallest.iter().flat_map(|s| [s.place, s.low, s.high, s.objective, s.slope]);
        let asked: Vec<_> =
            ids.iter().copied().chain(equal.iter().flat_map(|&(a, b)| [a, b])).chain(of_smallest).collect();
        let needed = graph.needed(&asked);
        graph.value = ids;
        Ok(Self { graph, needed, equal, smallest })
    }

    /// The operations that are printed, from the inputs to the outputs; `None` if an output is a minimiser, which has to be searched for.
    pub fn graph(&self) -> Option<&Graph> {
        self.smallest.is_none().then_some(&self.graph)
    }

    /// The outputs. An output that is a minimiser is not searched for but taken from the known outputs.
    pub fn values<T: graph::Number>(&self, inputs: &[T], known: &[T]) -> Vec<T> {
        let all = self.graph.results(&self.point(inputs, known), self.needed.iter().copied());
        self.graph.value.iter().map(|output| all[output.index()]).collect()
    }

    /// Whether it has a single value: on a kink there may be several minimisers.
    pub(crate) fn is_defined(&self, on_kink: bool) -> bool {
        !on_kink || self.smallest.is_none()
    }

    /// The inputs, followed by the minimiser if there is one.
    pub(crate) fn point<T: graph::Number>(&self, inputs: &[T], known: &[T]) -> Vec<T> {
        let nowhere = || T::from(f64::NAN);
        let place = self.smallest.iter().map(|s| known.get(s.output).copied().unwrap_or_else(nowhere));
        inputs.iter().copied().chain(place).collect()
    }

    /// All results at a [`point`](Self::point).
    pub(crate) fn run(&self, point: &[Octuple]) -> Results {
        let all = self.graph.results(point, self.needed.iter().copied());
        let at = |node: Node| all[node.index()];
        let smallest = self.smallest.as_ref().map(|s| SmallestAt {
            output: s.output,
            place: at(s.place),
            low: at(s.low),
            high: at(s.high),
            objective: at(s.objective),
            slope: at(s.slope),
        });
        let outputs = self.graph.value.iter().map(|&node| at(node)).collect();
        let equal = self.equal.iter().map(|&(a, b)| (at(a), at(b))).collect();
        Results { outputs, equal, smallest, all }
    }

    /// The gradients of all outputs, and of the slope that vanishes at the minimiser, with respect to the numbers of
    /// the point.
    pub(crate) fn gradients(&self, at: &Results, point: &[Octuple]) -> Vec<Vec<Octuple>> {
        let of = self.graph.value.iter().copied().chain(self.smallest.as_ref().map(|s| s.slope));
        of.map(|node| self.graph.gradient(node, &self.graph.needed(&[node]), &at.all, point.len())).collect()
    }
}

/// The sizes of the terms from which numbers of the equation are summed, at a [`point`](Equation::point), as a measure
/// of the rounding errors.
impl Equation {
    /// For an output, or for its derivative with respect to a number of the point.
    pub(crate) fn terms_of_output(&self, output: usize, by: Option<usize>, point: &[Octuple]) -> Octuple {
        self.terms(self.graph.value[output], by, point)
    }

    /// For the slope that vanishes at the minimiser, or for its derivative with respect to a number of the point.
    pub(crate) fn terms_of_slope(&self, by: Option<usize>, point: &[Octuple]) -> Octuple {
        self.smallest.as_ref().map_or_else(Octuple::default, |smallest| self.terms(smallest.slope, by, point))
    }

    fn terms(&self, of: Node, by: Option<usize>, point: &[Octuple]) -> Octuple {
        let Some(by) = by else { return rounding::terms(&self.graph, of, point, &[]) };
        let mut graph = self.graph.clone();
        let by = graph.enter(Op::Input(by));
        let slope = graph.derivative(of, by);
        rounding::terms(&graph, slope, point, &[])
    }
}

/// The fields with their symbols.
fn named(fields: &[Field]) -> Result<Vec<(Name, Field)>, Error> {
    fields.iter().map(|&field| Ok((symbol_of(field.quantity.latex)?, field))).collect()
}

/// Parses a single symbol.
fn symbol_of(latex: &str) -> Result<Name, Error> {
    let one = statement::symbols(latex).map(|mut all| (all.len() == 1).then(|| all.swap_remove(0)));
    match one {
        Ok(Some((name, parameters))) if parameters.is_empty() => Ok(name),
        Ok(_) => Err(Error::new(0, format!("`{latex}` is not one symbol"))),
        Err(error) => Err(error.of_symbol(latex)),
    }
}

/// The components of an output, which the equation must define either as a whole or one by one.
fn output(writer: &mut Writer<'_>, name: &Name, field: &Field) -> Result<Vec<Node>, Error> {
    let at = 0;
    let wrong = || Error::new(at, format!("{name} should have {} components", field.len()));
    if field.len() > 1 && writer.defines(&name.at(1)) {
        let parts = (1..=field.len()).map(|k| match writer.symbol(&name.at(k), at, Place::ROOT)? {
            Value::Scalar(id) => Ok(id),
            _ => Err(wrong()),
        });
        return parts.collect();
    }
    if !writer.defines(name) {
        return Err(Error::new(at, format!("the output {name} is not defined")));
    }
    match writer.symbol(name, at, Place::ROOT)? {
        Value::Scalar(id) if field.len() == 1 => Ok(vec![id]),
        Value::Vector(parts) if !is_matrix(field) && field.len() == parts.len() => Ok(parts),
        Value::Matrix(parts) if is_matrix(field) && field.len() == parts.len() => Ok(parts),
        _ => Err(wrong()),
    }
}

const fn is_matrix(field: &Field) -> bool {
    matches!(field.quantity.shape, Shape::Mat2 | Shape::Mat3)
}

fn place_of_smallest(writer: &mut Writer<'_>, output: usize, found: &ArgMin, id: &str) -> Result<Smallest, Error> {
    let ArgMin { low, high, objective } = found;
    let place = writer.graph.enter(Op::Input(writer.solution));
    let mut number = |e| writer.number(e, Place::ROOT).map_err(|error| error.of_entry(id, "equation"));
    let (low, high, objective) = (number(low)?, number(high)?, number(objective)?);
    // A length has the same minimiser as its square, which is differentiable at 0 too.
    let objective = match writer.graph.op(objective) {
        Op::Norm(_) | Op::Unary(Unary::Absolute, _) => {
            let (parts, zero) = (writer.graph.op(objective).operands(), writer.graph.number(0.0));
            parts.into_iter().fold(zero, |sum, part| {
                let square = writer.graph.product(part, part);
                writer.graph.sum(sum, square)
            })
        }
        _ => objective,
    };
    let slope = writer.graph.derivative(objective, place);
    Ok(Smallest { output, place, low, high, objective, slope })
}

/// Checks that every input, every statement and every symbol from elsewhere is used.
fn check_closed(writer: &Writer<'_>, needed: &[Node], inputs: &[(Name, Field)]) -> Result<(), Error> {
    let own = &writer.entries.0[0];
    let idle = own.statements.iter().zip(&writer.used).find(|(_, used)| !*used);
    if let Some((statement, _)) = idle {
        return Err(Error::new(statement.at, format!("{} is defined and not needed", statement.names[0])));
    }
    let idle = own.given.iter().zip(&writer.taken).find(|(_, used)| !*used);
    if let Some((taken, _)) = idle {
        return Err(Error::new(0, format!("{} is taken from elsewhere and not needed", taken.name)));
    }
    let input = |node| if let Op::Input(k) = writer.graph.op(node) { Some(*k) } else { None };
    let reached: Vec<_> = writer.graph.needed(needed).into_iter().filter_map(input).collect();
    let mut next = 0;
    for (name, field) in inputs {
        next += field.len();
        if !reached.iter().any(|k| (next - field.len()..next).contains(k)) {
            return Err(Error::new(0, format!("the input {name} is not needed for any output")));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::quantity::{F2, F3, FC};

    #[test]
    fn a_number_is_not_defined_by_what_looks_like_a_component_of_it() {
        let (inputs, outputs) = ([Field::new("f2", &F2), Field::new("f3", &F3)], [Field::new("fc", &FC)]);
        let latex = r"F = \sqrt{F_1 + f_3^2},\quad F_1 = f_2^2";
        let equation = Equation::read(latex, &[("F", "fc")], &inputs, &outputs).expect("it can be read");
        assert_eq!(equation.values(&[3.0, 4.0], &[]), [5.0]);
    }
}
