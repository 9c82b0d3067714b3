//! Resolves symbols, splits vectors into components, and writes the list of operations.

use super::error::Error;
use super::name::Name;
use super::scope::Entries;
use super::syntax::{Body, Condition, Expr, Function, Kind, Operator, Relation, Statement, small};
use super::value::{Value, binary, compare, constant, each, euler, norm, power, squares};
use crate::formula::Field;
use crate::number::scalar::{self, Leaf};
use crate::toolkit::graph::{Binary, Graph, Node, Op, Search, Unary};
use std::collections::BTreeSet;

/// The scope in which a symbol is looked up: the parameters, an entry, and then the scope from which that entry is referred to.
#[derive(Clone, Copy)]
pub(super) struct Place<'p> {
    pub(super) entry: usize,
    pub(super) bound: &'p [(Name, Value)],
    pub(super) parent: Option<&'p Place<'p>>,
    /// The depth of nested references.
    depth: usize,
}

impl Place<'_> {
    /// The equation itself.
    pub(super) const ROOT: Self = Self { entry: 0, bound: &[], parent: None, depth: 0 };
}

/// Deeper nesting of references counts as a cycle.
const DEEP: usize = 40;

/// Numbers that do not follow from the inputs by an equation.
#[derive(Debug, Default)]
pub(super) struct Beside {
    /// The outputs of the code, each with its row of the Jacobian of the code.
    pub(super) outputs: Vec<(Node, Vec<Node>)>,
    /// Numbers that vary, and their changes.
    pub(super) changes: Vec<(Node, Node)>,
}

/// Writes the list of operations.
pub(super) struct Writer<'e> {
    pub(super) graph: Graph,
    pub(super) entries: &'e Entries,
    /// Symbols of the inputs.
    pub(super) inputs: Vec<(Name, Value)>,
    /// The index of the input that holds the minimiser defined by the equation.
    pub(super) solution: usize,
    /// Whether each statement of the equation itself was used.
    pub(super) used: Vec<bool>,
    /// Whether each symbol taken from another entry was used.
    pub(super) taken: Vec<bool>,
    /// Forms printed as equal in the equation itself.
    pub(super) equal: BTreeSet<(Node, Node)>,
    /// Additional numbers known to prose.
    pub(super) beside: Beside,
    /// Whether symbols may be written [otherwise](Name::otherwise), as somebody else may write them.
    pub(super) is_lenient: bool,
}

impl<'e> Writer<'e> {
    pub(super) fn new(entries: &'e Entries, fields: &[(Name, Field)]) -> Self {
        let mut graph = Graph::default();
        let mut solution = 0;
        let mut inputs = Vec::new();
        for (name, field) in fields {
            let components: Vec<_> = (solution..solution + field.len()).map(|k| graph.enter(Op::Input(k))).collect();
            solution += field.len();
            let value = if field.len() == 1 { Value::Scalar(components[0]) } else { Value::Vector(components) };
            inputs.push((name.clone(), value));
        }
        let own = &entries.0[0];
        Self {
            graph,
            entries,
            inputs,
            solution,
            used: vec![false; own.statements.len()],
            taken: vec![false; own.given.len()],
            equal: BTreeSet::new(),
            beside: Beside::default(),
            is_lenient: false,
        }
    }

    /// Reads symbols as somebody else may write them: [otherwise](Name::otherwise), inputs also by their own symbols and by
    /// their names in code.
    pub(super) fn be_lenient(&mut self, own: &[(Name, Field)]) {
        self.is_lenient = true;
        let values: Vec<_> = self.inputs.iter().map(|(_, value)| value.clone()).collect();
        let names = own.iter().map(|(name, _)| name.clone());
        let names: Vec<_> = names.chain(own.iter().map(|(_, field)| Name::letter(field.name))).collect();
        self.inputs.extend(names.into_iter().zip([&values[..], &values[..]].concat()));
    }

    /// Whether the equation itself defines a symbol or says where it comes from; somebody else's does not say.
    pub(super) fn defines(&self, name: &Name) -> bool {
        let own = &self.entries.0[0];
        own.statements.iter().any(|statement| statement.names[0] == *name)
            || !self.is_lenient && own.given.iter().any(|taken| taken.name == *name)
    }

    /// The value of a symbol.
    pub(super) fn symbol(&mut self, name: &Name, at: usize, place: Place<'_>) -> Result<Value, Error> {
        if let Some(value) = self.defined(name, at, place)? {
            return Ok(value);
        }
        if let Some(value) = self.change(name, at, place)? {
            return Ok(value);
        }
        if let Some((vector, index)) = name.component()
            && let Some(Value::Vector(components)) = self.defined(&vector, at, place)?
        {
            return self.component(&components, index, at, place);
        }
        if let Some(value) = self.change_of_component(name, at, place)? {
            return Ok(value);
        }
        if let Some(value) = constant(name, &mut self.graph) {
            return Ok(value);
        }
        for other in if self.is_lenient { name.otherwise() } else { Vec::new() } {
            if let Some(value) = self.defined(&other, at, place)? {
                return Ok(value);
            }
        }
        Err(Error::unknown(at, name))
    }

    /// A component with a numeric index, or with a symbol as index.
    pub(super) fn component(&mut self, of: &[Node], index: &str, at: usize, place: Place<'_>) -> Result<Value, Error> {
        if let Ok(k) = index.parse::<usize>() {
            let component = k.checked_sub(1).and_then(|k| of.get(k));
            return component
                .map(|&id| Value::Scalar(id))
                .ok_or_else(|| Error::new(at, format!("a vector of {} has no component {k}", of.len())));
        }
        let Some(Value::Scalar(axis)) = self.defined(&Name::letter(index), at, place)? else {
            return Err(Error::new(at, format!("{index} is neither a number nor the number of an axis")));
        };
        let nothing = self.graph.number(f64::NAN);
        let chosen = of.iter().enumerate().rev().fold(nothing, |other, (k, &id)| {
            let number = self.graph.number(small(k + 1));
            let is_it = compare(&mut self.graph, Relation::Equal, axis, number);
            self.graph.enter(Op::Select(is_it, id, other))
        });
        Ok(Value::Scalar(chosen))
    }

    /// The value of a symbol that has a definition.
    pub(super) fn defined(&mut self, name: &Name, at: usize, place: Place<'_>) -> Result<Option<Value>, Error> {
        if place.depth > DEEP {
            return Err(Error::new(at, format!("{name} is defined by itself")));
        }
        if let Some((_, value)) = place.bound.iter().find(|(bound, _)| bound == name) {
            return Ok(Some(value.clone()));
        }
        if let Some((statement, parameters)) = self.statement(name, place) {
            // A function without arguments is taken at the symbols of its parameters.
            let bound = parameters
                .iter()
                .map(|p| Ok((p.clone(), self.symbol(p, at, place)?)))
                .collect::<Result<Vec<_>, _>>()?;
            return self.body(statement, &Place { bound: &bound, depth: place.depth + 1, ..place }).map(Some);
        }
        if let Some((_, from)) = self.taken(name, place) {
            return self.defined(
                name,
                at,
                Place { entry: from, bound: &[], parent: Some(&place), depth: place.depth + 1 },
            );
        }
        match place.parent {
            Some(parent) => self.defined(name, at, Place { depth: place.depth + 1, ..*parent }),
            None => Ok(self.inputs.iter().find(|(input, _)| input == name).map(|(_, value)| value.clone())),
        }
    }

    /// The statement of the entry that defines this symbol.
    fn statement(&mut self, name: &Name, place: Place<'_>) -> Option<(&'e Statement, &'e [Name])> {
        let entries: &'e Entries = self.entries;
        let entry = &entries.0[place.entry];
        let found = entry.statements.iter().position(|statement| statement.names[0] == *name)?;
        if place.entry == 0 {
            self.used[found] = true;
        }
        Some((&entry.statements[found], &entry.statements[found].parameters))
    }

    /// The other entry that defines this symbol.
    fn taken(&mut self, name: &Name, place: Place<'_>) -> Option<(usize, usize)> {
        let entry = &self.entries.0[place.entry];
        let found = entry.given.iter().position(|taken| taken.name == *name)?;
        if place.entry == 0 {
            self.taken[found] = true;
        }
        Some((found, entry.given[found].from))
    }

    fn body(&mut self, statement: &Statement, place: &Place<'_>) -> Result<Value, Error> {
        let id = self.entries.0[place.entry].id;
        self.sides(statement, place).map_err(|error| error.of_entry(id, "equation"))
    }

    fn sides(&mut self, statement: &Statement, place: &Place<'_>) -> Result<Value, Error> {
        let sides = match &statement.body {
            Body::Equal(sides) => sides,
            Body::ArgMin(_) => return Ok(Value::Scalar(self.graph.enter(Op::Input(self.solution)))),
            Body::Chain(..) => return Err(Error::new(statement.at, "this defines nothing")),
        };
        let mut value = None;
        for side in sides {
            let next = self.expression(side, *place)?;
            match &value {
                None => value = Some(next),
                Some(first) => self.note_equal(first, &next, side.at, place)?,
            }
        }
        value.ok_or_else(|| Error::new(statement.at, "nothing is on the other side"))
    }

    /// Records two forms of the same quantity for comparison, if the equation itself has them.
    fn note_equal(&mut self, first: &Value, next: &Value, at: usize, place: &Place<'_>) -> Result<(), Error> {
        let pairs: Vec<_> = match (first, next) {
            (Value::Scalar(a), Value::Scalar(b)) => vec![(*a, *b)],
            (Value::Vector(a), Value::Vector(b)) | (Value::Matrix(a), Value::Matrix(b)) if a.len() == b.len() => {
                a.iter().copied().zip(b.iter().copied()).collect()
            }
            _ => return Err(Error::new(at, "the two sides have not the same shape")),
        };
        if place.entry == 0 {
            self.equal.extend(pairs.into_iter().filter(|pair| pair.0 != pair.1));
        }
        Ok(())
    }

    /// A declared function applied to arguments.
    fn apply(&mut self, name: &Name, arguments: &[Expr], at: usize, place: Place<'_>) -> Result<Value, Error> {
        let values = arguments.iter().map(|e| self.expression(e, place)).collect::<Result<Vec<_>, _>>()?;
        let bind = |parameters: &[Name]| -> Result<Vec<(Name, Value)>, Error> {
            if parameters.len() != values.len() {
                return Err(Error::new(
                    at,
                    format!("{name} is a function of {}, not {}", parameters.len(), values.len()),
                ));
            }
            Ok(parameters.iter().cloned().zip(values.iter().cloned()).collect())
        };
        let depth = place.depth + 1;
        if let Some((statement, parameters)) = self.statement(name, place) {
            return self.body(statement, &Place { bound: &bind(parameters)?, depth, ..place });
        }
        if let Some((k, from)) = self.taken(name, place) {
            let bound = bind(&self.entries.0[place.entry].given[k].parameters)?;
            let parent = Place { bound: &bound, ..place };
            let there = Place { entry: from, bound: &[], parent: Some(&parent), depth };
            if let Some(value) = self.defined(name, at, there)? {
                return Ok(value);
            }
        }
        Err(Error::new(at, format!("{name} is nobody's function")))
    }

    pub(super) fn expression(&mut self, e: &Expr, place: Place<'_>) -> Result<Value, Error> {
        match &e.kind {
            Kind::Number(value) => Ok(Value::Scalar(self.graph.number(*value))),
            Kind::Symbol(name) => self.symbol(name, e.at, place),
            Kind::Apply(name, arguments) => self.apply(name, arguments, e.at, place),
            Kind::Call(Function::Sqrt, arguments) => self.root(&arguments[0], place),
            Kind::Call(function, arguments) => {
                let numbers = arguments.iter().map(|e| self.number(e, place)).collect::<Result<Vec<_>, _>>()?;
                Ok(Value::Scalar(call(&mut self.graph, *function, &numbers)))
            }
            Kind::Negative(inside) => {
                let value = self.expression(inside, place)?;
                each(&mut self.graph, value, e.at, Graph::negative)
            }
            Kind::Binary(operator, a, b) => {
                let (left, right) = (self.expression(a, place)?, self.expression(b, place)?);
                binary(&mut self.graph, *operator, left, right, e.at)
            }
            Kind::Power(base, exponent) => self.power(base, exponent, place),
            Kind::Size(inside) => match self.expression(inside, place)? {
                Value::Scalar(id) => Ok(Value::Scalar(self.graph.unary(Unary::Absolute, id))),
                Value::Vector(parts) => Ok(Value::Scalar(norm(&mut self.graph, &parts))),
                _ => Err(Error::new(e.at, "this has no size that is worth a sign")),
            },
            Kind::Cases(rows) => self.cases(rows, e.at, place),
            Kind::Sum { index, from, to, body } => {
                let mut sum = None;
                for k in *from..=*to {
                    let next = self.expression(&body.with_index(index, k), place)?;
                    sum = Some(match sum {
                        None => next,
                        Some(sum) => binary(&mut self.graph, Operator::Add, sum, next, e.at)?,
                    });
                }
                sum.ok_or_else(|| Error::new(e.at, "the sum is empty"))
            }
            Kind::Tuple(items) => {
                let numbers = items.iter().map(|item| self.number(item, place)).collect::<Result<_, _>>()?;
                Ok(Value::Vector(numbers))
            }
            Kind::Partial(of, by) => self.partial(of, by, e.at, place),
            Kind::Item(tuple, k) => match self.expression(tuple, place)? {
                Value::Vector(parts) if *k < parts.len() => Ok(Value::Scalar(parts[*k])),
                _ => Err(Error::new(e.at, format!("this has no item {}", k + 1))),
            },
        }
    }

    /// An expression that must be a number.
    pub(super) fn number(&mut self, e: &Expr, place: Place<'_>) -> Result<Node, Error> {
        match self.expression(e, place)? {
            Value::Scalar(id) => Ok(id),
            _ => Err(Error::new(e.at, "a number was expected here, not a vector")),
        }
    }

    /// Integer powers, and the exponential function as a power of e.
    fn power(&mut self, base: &Expr, exponent: &Expr, place: Place<'_>) -> Result<Value, Error> {
        if let Kind::Number(value) = exponent.kind {
            let whole = (2..=9).find(|&k| small(k) == value);
            let whole = whole.ok_or_else(|| {
                Error::new(exponent.at, "a power is a whole number up to 9, half of one, or the negative of either")
            })?;
            return match self.expression(base, place)? {
                Value::Scalar(base) => Ok(Value::Scalar(power(&mut self.graph, base, whole))),
                square @ Value::Vector(_) if whole == 2 => {
                    binary(&mut self.graph, Operator::Dot, square.clone(), square, base.at)
                }
                _ => Err(Error::new(base.at, "only the square of a vector is defined, not other powers")),
            };
        }
        if self.number(base, place)? != euler(&mut self.graph) {
            return Err(Error::new(exponent.at, "a power is a number, but for powers of e"));
        }
        let exponent = self.number(exponent, place)?;
        Ok(Value::Scalar(self.graph.unary(Unary::Exponential, exponent)))
    }

    /// A square root; that of a sum of squares is a length, which has a derivative at 0.
    fn root(&mut self, inside: &Expr, place: Place<'_>) -> Result<Value, Error> {
        let radicand = self.number(inside, place)?;
        Ok(Value::Scalar(match squares(&self.graph, radicand) {
            Some(parts) => norm(&mut self.graph, &parts),
            None => self.graph.unary(Unary::Root, radicand),
        }))
    }

    /// The first case whose condition holds.
    fn cases(&mut self, rows: &[(Expr, Condition)], at: usize, place: Place<'_>) -> Result<Value, Error> {
        let mut values = Vec::new();
        for (value, condition) in rows {
            values.push((self.expression(value, place)?, self.condition(condition, place)?));
        }
        let (last, condition) = values.pop().ok_or_else(|| Error::new(at, "there are no cases"))?;
        // If no case holds, there is no value.
        let nothing = self.graph.number(f64::NAN);
        let last = match condition {
            None => last,
            Some(condition) => {
                each(&mut self.graph, last, at, |graph, id| graph.enter(Op::Select(condition, id, nothing)))?
            }
        };
        values.into_iter().rev().try_fold(last, |other, (value, condition)| {
            let Some(condition) = condition else { return Err(Error::new(at, "only the last case is \"otherwise\"")) };
            let mut select = |a: Node, b: Node| self.graph.enter(Op::Select(condition, a, b));
            match (value, other) {
                (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(select(a, b))),
                (Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                    Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| select(a, b)).collect()))
                }
                _ => Err(Error::new(at, "the cases have not the same shape")),
            }
        })
    }

    /// A node that is 1 if all comparisons hold; `None` for "otherwise".
    fn condition(&mut self, condition: &Condition, place: Place<'_>) -> Result<Option<Node>, Error> {
        let mut all = None;
        for (left, relation, right) in condition {
            let holds = self.comparison(left, *relation, right, place)?;
            all = Some(all.map_or(holds, |all| self.graph.enter(Op::both(all, holds))));
        }
        Ok(all)
    }

    fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr, place: Place<'_>) -> Result<Node, Error> {
        let (left, right) = (self.expression(a, place)?, self.expression(b, place)?);
        match (left, right) {
            (Value::Scalar(left), Value::Scalar(right)) => Ok(compare(&mut self.graph, relation, left, right)),
            // A vector is compared with the zero vector only.
            (Value::Vector(parts), Value::Zero) if matches!(relation, Relation::Equal | Relation::Unequal) => {
                let (length, zero) = (norm(&mut self.graph, &parts), self.graph.number(0.0));
                Ok(compare(&mut self.graph, relation, length, zero))
            }
            _ => Err(Error::new(a.at, "numbers are compared, or a vector with the zero vector")),
        }
    }
}

/// Any function except the root, which depends on its argument.
fn call(graph: &mut Graph, function: Function, of: &[Node]) -> Node {
    let first = of[0];
    match function {
        Function::Sqrt => graph.unary(Unary::Root, first),
        Function::Sin => graph.unary(Unary::Sine, first),
        Function::Cos => graph.unary(Unary::Cosine, first),
        Function::ArcSin => graph.unary(Unary::ArcSine, first),
        Function::Sign => graph.sign(first),
        Function::Round => graph.enter(Op::Search(Search::of::<WholeNumber, 1>(), of.into())),
        Function::Atan2 => {
            // Mathematical zeros have no sign.
            let zero = graph.number(0.0);
            let unsigned = graph.enter(Op::Binary(Binary::Add, first, zero));
            graph.enter(Op::Binary(Binary::Angle, unsigned, of[1]))
        }
    }
}

/// The nearest integer.
struct WholeNumber;

impl scalar::Search<1> for WholeNumber {
    const NAME: &'static str = "round";
    fn find<L: Leaf>([x]: [L; 1]) -> L {
        x.re().round().into()
    }
}
