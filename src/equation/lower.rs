//! Symbols get their meaning, vectors fall apart into components, and the list of operations is written.

use super::error::Error;
use super::name::Name;
use super::scope::Entries;
use super::syntax::{Body, Condition, Expr, Function, Kind, Operator, Relation, Statement, small};
use super::tape::{Id, Op, Tape};
use crate::formula::Field;

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Scalar(Id),
    Vector(Vec<Id>),
    /// The normal of the plane, **s**: its cross product with a vector of the plane turns that to the left.
    Normal,
    /// The zero vector, of any length.
    Zero,
}

/// Where a symbol is looked up: among the parameters, in an entry, and then where that entry is referred to.
#[derive(Clone, Copy)]
pub(super) struct Place<'p> {
    pub(super) entry: usize,
    pub(super) bound: &'p [(Name, Value)],
    pub(super) parent: Option<&'p Place<'p>>,
    /// References inside references.
    depth: usize,
}

impl Place<'_> {
    /// The equation itself.
    pub(super) const ROOT: Self = Self { entry: 0, bound: &[], parent: None, depth: 0 };
}

/// So many references inside references are a circle.
const DEEP: usize = 40;

/// Writes the list of operations.
pub(super) struct Writer<'e> {
    pub(super) tape: Tape,
    pub(super) entries: &'e Entries,
    /// Symbols of the inputs.
    pub(super) inputs: Vec<(Name, Value)>,
    /// Where the place is put in that the equation defines as the smallest of something.
    pub(super) solution: usize,
    /// Statements of the equation itself that were needed.
    pub(super) used: Vec<bool>,
    /// Symbols taken from other entries that were needed.
    pub(super) taken: Vec<bool>,
    /// Forms printed as equal in the equation itself.
    pub(super) equal: Vec<(Id, Id)>,
}

impl<'e> Writer<'e> {
    pub(super) fn new(entries: &'e Entries, fields: &[(Name, Field)]) -> Self {
        let mut tape = Tape::default();
        let mut solution = 0;
        let mut inputs = Vec::new();
        for (name, field) in fields {
            let components: Vec<_> = (solution..solution + field.len()).map(|k| tape.push(Op::Input(k))).collect();
            solution += field.len();
            let value = if field.len() == 1 { Value::Scalar(components[0]) } else { Value::Vector(components) };
            inputs.push((name.clone(), value));
        }
        let own = &entries.0[0];
        Self {
            tape,
            entries,
            inputs,
            solution,
            used: vec![false; own.statements.len()],
            taken: vec![false; own.given.len()],
            equal: Vec::new(),
        }
    }

    /// Whether the equation itself says what a symbol is, or where it comes from.
    pub(super) fn defines(&self, name: &Name) -> bool {
        let own = &self.entries.0[0];
        own.statements.iter().any(|statement| statement.names[0] == *name)
            || own.given.iter().any(|taken| taken.name == *name)
    }

    /// The meaning of a symbol.
    pub(super) fn symbol(&mut self, name: &Name, at: usize, place: Place<'_>) -> Result<Value, Error> {
        if let Some(value) = self.defined(name, at, place)? {
            return Ok(value);
        }
        if let Some((vector, index)) = name.component()
            && let Some(Value::Vector(components)) = self.defined(&vector, at, place)?
        {
            return self.component(&components, index, at, place);
        }
        constant(name, &mut self.tape).ok_or_else(|| Error::new(at, format!("{name} is nobody's symbol")))
    }

    /// A component by a number, or by a symbol that is one.
    fn component(&mut self, of: &[Id], index: &str, at: usize, place: Place<'_>) -> Result<Value, Error> {
        if let Ok(k) = index.parse::<usize>() {
            let component = k.checked_sub(1).and_then(|k| of.get(k));
            return component
                .map(|&id| Value::Scalar(id))
                .ok_or_else(|| Error::new(at, format!("a vector of {} has no component {k}", of.len())));
        }
        let axis = match self.defined(&Name::letter(index), at, place)? {
            Some(Value::Scalar(axis)) => axis,
            _ => return Err(Error::new(at, format!("{index} is neither a number nor the number of an axis"))),
        };
        let nothing = self.tape.number(f64::NAN);
        let chosen = of.iter().enumerate().rev().fold(nothing, |other, (k, &id)| {
            let number = self.tape.number(small(k + 1));
            let is_it = self.tape.push(Op::Compare(Relation::Equal, axis, number));
            self.tape.push(Op::Select(is_it, id, other))
        });
        Ok(Value::Scalar(chosen))
    }

    /// The meaning of a symbol that somebody defines.
    fn defined(&mut self, name: &Name, at: usize, place: Place<'_>) -> Result<Option<Value>, Error> {
        if place.depth > DEEP {
            return Err(Error::new(at, format!("{name} is defined by itself")));
        }
        if let Some((_, value)) = place.bound.iter().find(|(bound, _)| bound == name) {
            return Ok(Some(value.clone()));
        }
        if let Some((statement, parameters)) = self.statement(name, place) {
            // Without a bracket behind it a function means: of the symbols of its parameters.
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

    /// The statement of the entry that defines this.
    fn statement(&mut self, name: &Name, place: Place<'_>) -> Option<(&'e Statement, &'e [Name])> {
        let entries: &'e Entries = self.entries;
        let entry = &entries.0[place.entry];
        let found = entry.statements.iter().position(|statement| statement.names[0] == *name)?;
        if place.entry == 0 {
            self.used[found] = true;
        }
        Some((&entry.statements[found], &entry.statements[found].parameters))
    }

    /// The other entry that defines this.
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
        let Body::Equal(sides) = &statement.body else {
            return Ok(Value::Scalar(self.tape.push(Op::Input(self.solution))));
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

    /// Two forms of the same: of the equation itself, both are compared.
    fn note_equal(&mut self, first: &Value, next: &Value, at: usize, place: &Place<'_>) -> Result<(), Error> {
        let pairs: Vec<_> = match (first, next) {
            (Value::Scalar(a), Value::Scalar(b)) => vec![(*a, *b)],
            (Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                a.iter().copied().zip(b.iter().copied()).collect()
            }
            _ => return Err(Error::new(at, "the two sides have not the same shape")),
        };
        if place.entry == 0 {
            self.equal.extend(pairs.into_iter().filter(|pair| pair.0 != pair.1));
        }
        Ok(())
    }

    /// A declared function of arguments.
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
            Kind::Number(value) => Ok(Value::Scalar(self.tape.number(*value))),
            Kind::Symbol(name) => self.symbol(name, e.at, place),
            Kind::Apply(name, arguments) => self.apply(name, arguments, e.at, place),
            Kind::Call(Function::Sqrt, arguments) => self.root(&arguments[0], place),
            Kind::Call(function, arguments) => {
                let first = self.number(&arguments[0], place)?;
                let second = match arguments.get(1) {
                    Some(second) => self.number(second, place)?,
                    None => first,
                };
                Ok(Value::Scalar(self.tape.push(Op::Call(*function, first, second))))
            }
            Kind::Negative(inside) => {
                let value = self.expression(inside, place)?;
                self.each(value, e.at, Tape::negative)
            }
            Kind::Binary(operator, a, b) => {
                let (left, right) = (self.expression(a, place)?, self.expression(b, place)?);
                self.binary(*operator, left, right, e.at)
            }
            Kind::Power(base, exponent) => self.power(base, exponent, place),
            Kind::Size(inside) => match self.expression(inside, place)? {
                Value::Scalar(id) => Ok(Value::Scalar(self.tape.push(Op::Abs(id)))),
                Value::Vector(parts) => Ok(Value::Scalar(self.norm(&parts))),
                _ => Err(Error::new(e.at, "this has no size that is worth a sign")),
            },
            Kind::Cases(rows) => self.cases(rows, e.at, place),
            Kind::Sum { index, from, to, body } => {
                let mut sum = None;
                for k in *from..=*to {
                    let next = self.expression(&body.with_index(index, k), place)?;
                    sum = Some(match sum {
                        None => next,
                        Some(sum) => self.binary(Operator::Add, sum, next, e.at)?,
                    });
                }
                sum.ok_or_else(|| Error::new(e.at, "the sum is empty"))
            }
            Kind::Tuple(items) => {
                let numbers = items.iter().map(|item| self.number(item, place)).collect::<Result<_, _>>()?;
                Ok(Value::Vector(numbers))
            }
            Kind::Item(tuple, k) => match self.expression(tuple, place)? {
                Value::Vector(parts) if *k < parts.len() => Ok(Value::Scalar(parts[*k])),
                _ => Err(Error::new(e.at, format!("this has no item {}", k + 1))),
            },
        }
    }

    /// An expression that must be a number.
    pub(super) fn number(&mut self, e: &Expr, place: Place<'_>) -> Result<Id, Error> {
        match self.expression(e, place)? {
            Value::Scalar(id) => Ok(id),
            _ => Err(Error::new(e.at, "a number was expected here, not a vector")),
        }
    }

    fn each(&mut self, value: Value, at: usize, change: impl Fn(&mut Tape, Id) -> Id) -> Result<Value, Error> {
        match value {
            Value::Scalar(id) => Ok(Value::Scalar(change(&mut self.tape, id))),
            Value::Vector(parts) => Ok(Value::Vector(parts.into_iter().map(|id| change(&mut self.tape, id)).collect())),
            Value::Normal | Value::Zero => {
                Err(Error::new(at, "only a cross product or a comparison is written with this"))
            }
        }
    }

    fn binary(&mut self, operator: Operator, left: Value, right: Value, at: usize) -> Result<Value, Error> {
        use Operator::{Add, Cross, Divide, Dot, Subtract, Times};
        let tape = &mut self.tape;
        let pairs = |a: &[Id], b: &[Id]| a.iter().copied().zip(b.iter().copied()).collect::<Vec<_>>();
        Ok(match (operator, left, right) {
            (Add, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.add(a, b)),
            (Subtract, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.subtract(a, b)),
            (Times | Dot, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.multiply(a, b)),
            (Divide, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.divide(a, b)),
            (Divide, Value::Vector(a), Value::Scalar(b)) => {
                Value::Vector(a.into_iter().map(|a| tape.divide(a, b)).collect())
            }
            (Times, Value::Scalar(a), Value::Vector(b)) | (Times, Value::Vector(b), Value::Scalar(a)) => {
                Value::Vector(b.into_iter().map(|b| tape.multiply(a, b)).collect())
            }
            (Add, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| tape.add(a, b)).collect())
            }
            (Subtract, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| tape.subtract(a, b)).collect())
            }
            (Dot, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                let products: Vec<_> = pairs(&a, &b).into_iter().map(|(a, b)| tape.multiply(a, b)).collect();
                let zero = tape.number(0.0);
                Value::Scalar(products.into_iter().fold(zero, |sum, product| tape.add(sum, product)))
            }
            (Cross, Value::Vector(a), Value::Vector(b)) if a.len() == 3 && b.len() == 3 => {
                let mut minor = |i: usize, j: usize| {
                    let (plus, minus) = (tape.multiply(a[i], b[j]), tape.multiply(a[j], b[i]));
                    tape.subtract(plus, minus)
                };
                Value::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)])
            }
            (Cross, Value::Normal, Value::Vector(b)) if b.len() == 2 => Value::Vector(vec![tape.negative(b[1]), b[0]]),
            (operator, ..) => return Err(Error::new(at, format!("{} is not defined for these", word(operator)))),
        })
    }

    /// Whole powers, and the exponential function as a power of e.
    fn power(&mut self, base: &Expr, exponent: &Expr, place: Place<'_>) -> Result<Value, Error> {
        if let Kind::Number(value) = exponent.kind {
            let whole = (2..=9).find(|&k| f64::from(k) == value);
            let whole = whole.ok_or_else(|| Error::new(exponent.at, "a power is a whole number from 2 to 9"))?;
            let base = self.number(base, place)?;
            return Ok(Value::Scalar(self.tape.push(Op::Power(base, whole))));
        }
        let (euler, base_value) = (self.tape.push(Op::Euler), self.number(base, place)?);
        if base_value != euler {
            return Err(Error::new(exponent.at, "a power is a whole number, but for powers of e"));
        }
        let exponent = self.number(exponent, place)?;
        Ok(Value::Scalar(self.tape.push(Op::Exp(exponent))))
    }

    /// A square root; of a sum of squares it is a length, which has a derivative at 0 as lengths have.
    fn root(&mut self, inside: &Expr, place: Place<'_>) -> Result<Value, Error> {
        let radicand = self.number(inside, place)?;
        Ok(Value::Scalar(match self.squares(radicand) {
            Some(parts) => self.norm(&parts),
            None => self.tape.push(Op::Call(Function::Sqrt, radicand, radicand)),
        }))
    }

    /// What is squared in a sum of squares.
    fn squares(&self, sum: Id) -> Option<Vec<Id>> {
        match self.tape.op(sum) {
            Op::Power(base, 2) => Some(vec![base]),
            Op::Add(a, b) => Some([self.squares(a)?, self.squares(b)?].concat()),
            _ => None,
        }
    }

    /// The length of a vector of any number of components.
    fn norm(&mut self, parts: &[Id]) -> Id {
        let zero = self.tape.number(0.0);
        let length = |tape: &mut Tape, parts: &[Id]| {
            let at = |k: usize| parts.get(k).copied().unwrap_or(zero);
            tape.push(Op::Norm([at(0), at(1), at(2)]))
        };
        match parts {
            [first, second, third, rest @ ..] if !rest.is_empty() => {
                let start = length(&mut self.tape, &[*first, *second, *third]);
                self.norm(&[&[start], rest].concat())
            }
            _ => length(&mut self.tape, parts),
        }
    }

    /// The first case whose condition holds.
    fn cases(&mut self, rows: &[(Expr, Condition)], at: usize, place: Place<'_>) -> Result<Value, Error> {
        let mut values = Vec::new();
        for (value, condition) in rows {
            values.push((self.expression(value, place)?, self.condition(condition, place)?));
        }
        let (last, condition) = values.pop().ok_or_else(|| Error::new(at, "there are no cases"))?;
        // Where no case holds there is no value.
        let nothing = self.tape.number(f64::NAN);
        let last = match condition {
            None => last,
            Some(condition) => self.each(last, at, |tape, id| tape.push(Op::Select(condition, id, nothing)))?,
        };
        values.into_iter().rev().try_fold(last, |other, (value, condition)| {
            let Some(condition) = condition else { return Err(Error::new(at, "only the last case is \"otherwise\"")) };
            let mut select = |a: Id, b: Id| self.tape.push(Op::Select(condition, a, b));
            match (value, other) {
                (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(select(a, b))),
                (Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                    Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| select(a, b)).collect()))
                }
                _ => Err(Error::new(at, "the cases have not the same shape")),
            }
        })
    }

    /// 1 where all comparisons hold; nothing for "otherwise".
    fn condition(&mut self, condition: &Condition, place: Place<'_>) -> Result<Option<Id>, Error> {
        let mut all = None;
        for (left, relation, right) in condition {
            let holds = self.comparison(left, *relation, right, place)?;
            all = Some(all.map_or(holds, |all| self.tape.multiply(all, holds)));
        }
        Ok(all)
    }

    fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr, place: Place<'_>) -> Result<Id, Error> {
        let (left, right) = (self.expression(a, place)?, self.expression(b, place)?);
        match (left, right) {
            (Value::Scalar(left), Value::Scalar(right)) => Ok(self.tape.push(Op::Compare(relation, left, right))),
            // A vector is compared with the zero vector only.
            (Value::Vector(parts), Value::Zero) if matches!(relation, Relation::Equal | Relation::Unequal) => {
                let (length, zero) = (self.norm(&parts), self.tape.number(0.0));
                Ok(self.tape.push(Op::Compare(relation, length, zero)))
            }
            _ => Err(Error::new(a.at, "numbers are compared, or a vector with the zero vector")),
        }
    }
}

/// Symbols that mean the same everywhere, unless somebody defines them.
fn constant(name: &Name, tape: &mut Tape) -> Option<Value> {
    let plain = name.below.is_empty() && name.above.is_empty() && name.primes == 0 && name.change.is_empty();
    if !plain {
        return None;
    }
    let mut axis = |k: usize| Value::Vector((0..3).map(|i| tape.number(f64::from(u8::from(i == k)))).collect());
    match (name.bold, name.base.as_str()) {
        (true, "i") => Some(axis(0)),
        (true, "j") => Some(axis(1)),
        (true, "k") => Some(axis(2)),
        (true, "s") => Some(Value::Normal),
        (true, "0") => Some(Value::Zero),
        (false, "pi") => Some(Value::Scalar(tape.push(Op::Pi))),
        (false, "e") => Some(Value::Scalar(tape.push(Op::Euler))),
        _ => None,
    }
}

fn word(operator: Operator) -> &'static str {
    match operator {
        Operator::Add => "a sum",
        Operator::Subtract => "a difference",
        Operator::Times => "a product without a sign",
        Operator::Dot => "the product `\\cdot`",
        Operator::Cross => "the product `\\times`",
        Operator::Divide => "a quotient",
    }
}
