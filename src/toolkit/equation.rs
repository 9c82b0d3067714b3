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
//! Spellings that mean the same are read too, such as `|x|`, `\left|x\right|`, `^{1/2}`, `\vec{x}`, `_{\text{C}}`, `\arctan`, `\min`
//! and displays in `$…$` or `\begin{equation}`; a [`Reading`] of what somebody else has written also characters such as √ and α, and
//! plain text: `fc = sqrt(f2**2 + f3**2)`.
//!
//! A symbol is an input of the entry, is defined by a statement, or comes from another formula by [`Given`]. Anything
//! else is an error with its position. Every input and every statement must be used.
//!
//! ```
//! use jointproof::toolkit::equation::Equation;
//! use jointproof::catalog::AnyFormula;
//! use jointproof::connector::slot::ContactForce;
//!
//! let formula: &dyn AnyFormula = &ContactForce;
//! let equation = Equation::read(r"F_C = \sqrt{f_2^2 + f_3^2}", &[], &formula.signature())?;
//! assert_eq!(equation.values(&[3.0, 4.0], &[]), [5.0]);
//! let error = Equation::read(r"F_C = \sqrt{f_2^2 + f_4^2}", &[], &formula.signature()).unwrap_err();
//! assert_eq!(error.to_string(), "the equation of yours, byte 20: f_4 is nobody's symbol");
//! # Ok::<(), jointproof::toolkit::equation::Error>(())
//! ```

mod call;
mod claims;
mod closed;
mod cursor;
mod derivative;
mod error;
mod latex;
mod lower;
mod name;
mod parse;
mod reading;
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
pub use reading::Reading;
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
    /// The components of the formula's outputs that these are.
    places: Vec<usize>,
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
        Self::written_by(Writer::new(&entries, inputs), inputs, outputs, id)
    }

    fn written_by(
        mut writer: Writer<'_>,
        inputs: &[(Name, Field)],
        outputs: &[(Name, Field)],
        id: &'static str,
    ) -> Result<Self, Error> {
        let (mut ids, mut places, mut component) = (Vec::new(), Vec::new(), 0);
        let mut smallest = None;
        for (name, field) in outputs {
            if let Some(place) = writer.entries.arg_min(name) {
                smallest = Some((ids.len(), place));
            }
            let found = output(&mut writer, name, field).map_err(|error| error.of_entry(id, "equation"))?;
            let known = found.into_iter().enumerate().filter_map(|(k, id)| id.map(|id| (component + k, id)));
            for (place, id) in known {
                places.push(place);
                ids.push(id);
            }
            component += field.len();
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
        Ok(Self { graph, places, needed, equal, smallest })
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

    /// The components of the formula's outputs that it defines, in order.
    pub fn places(&self) -> &[usize] {
        &self.places
    }

    /// The inputs, followed by the minimiser if there is one.
    pub(crate) fn point<T: graph::Number>(&self, inputs: &[T], known: &[T]) -> Vec<T> {
        let nowhere = || T::from(f64::NAN);
        let place = self.smallest.iter().map(|s| known.get(self.places[s.output]).copied().unwrap_or_else(nowhere));
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
    named_by(&[], fields)
}

/// The fields with their symbols, some of which are renamed: `("a", "f2")`.
fn named_by(renamed: &[(&str, &str)], fields: &[Field]) -> Result<Vec<(Name, Field)>, Error> {
    let symbol = |field: &Field| {
        let other = renamed.iter().find(|(_, name)| *name == field.name);
        symbol_of(other.map_or(field.quantity.latex, |(symbol, _)| symbol))
    };
    fields.iter().map(|&field| Ok((symbol(&field)?, field))).collect()
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

/// The components of an output, which the equation defines either as a whole or one by one; somebody else's equation need not define all.
fn output(writer: &mut Writer<'_>, name: &Name, field: &Field) -> Result<Vec<Option<Node>>, Error> {
    let at = 0;
    let wrong = || Error::new(at, format!("{name} should have {} components", field.len()));
    let parts: Vec<_> = (1..=field.len()).map(|k| field.len() > 1 && writer.defines(&name.at(k))).collect();
    let needs_all = !writer.is_lenient;
    if parts.iter().any(|&is_defined| is_defined) && (needs_all || !writer.defines(name)) {
        let part = |(k, is_defined): (usize, bool)| {
            if !is_defined && !needs_all {
                return Ok(None);
            }
            match writer.symbol(&name.at(k + 1), at, Place::ROOT)? {
                Value::Scalar(id) => Ok(Some(id)),
                _ => Err(wrong()),
            }
        };
        return parts.into_iter().enumerate().map(part).collect();
    }
    if !writer.defines(name) {
        let undefined = || Error::new(at, format!("the output {name} is not defined"));
        return if needs_all { Err(undefined()) } else { Ok(vec![None; field.len()]) };
    }
    match writer.symbol(name, at, Place::ROOT)? {
        Value::Scalar(id) if field.len() == 1 => Ok(vec![Some(id)]),
        Value::Vector(parts) if !is_matrix(field) && field.len() == parts.len() => Ok(wrapped(parts)),
        Value::Matrix(parts) if is_matrix(field) && field.len() == parts.len() => Ok(wrapped(parts)),
        _ => Err(wrong()),
    }
}

fn wrapped(parts: Vec<Node>) -> Vec<Option<Node>> {
    parts.into_iter().map(Some).collect()
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
    if writer.is_lenient {
        return Ok(());
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
    use crate::catalog::AnyFormula;
    use crate::connector::slot::ContactForce;

    #[test]
    fn a_number_is_not_defined_by_what_looks_like_a_component_of_it() {
        let latex = r"F = \sqrt{F_1 + f_3^2},\quad F_1 = f_2^2";
        let equation =
            Equation::read(latex, &[("F", "fc")], &<dyn AnyFormula>::signature(&ContactForce)).expect("it can be read");
        assert_eq!(equation.values(&[3.0, 4.0], &[]), [5.0]);
    }
}
