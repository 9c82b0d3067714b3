//! Derivatives as written in prose: `\frac{\partial F_C}{\partial f_2}`, and `\mathrm{d}F_C` for everything that varies.

use super::error::Error;
use super::lower::{Place, Writer};
use super::name::Name;
use super::syntax::Expr;
use super::value::Value;
use crate::toolkit::graph::{Node, Op};

impl Writer<'_> {
    /// A partial derivative. For an output of the code with respect to an input, it is an entry of the code's
    /// Jacobian; for anything else, it follows from the equation, with all other symbols held fixed.
    pub(super) fn partial(&mut self, of: &Expr, by: &Name, at: usize, place: Place<'_>) -> Result<Value, Error> {
        let (of, by) = (self.expression(of, place)?, self.symbol(by, at, place)?);
        match (of, by) {
            (Value::Scalar(of), Value::Scalar(by)) => Ok(Value::Scalar(self.entry(of, by))),
            (Value::Vector(of), Value::Scalar(by)) => {
                Ok(Value::Vector(of.into_iter().map(|of| self.entry(of, by)).collect()))
            }
            (Value::Scalar(of), Value::Vector(by)) => {
                Ok(Value::Vector(by.into_iter().map(|by| self.entry(of, by)).collect()))
            }
            _ => Err(Error::new(at, "a vector by a vector is a matrix, which is not read here")),
        }
    }

    fn entry(&mut self, of: Node, by: Node) -> Node {
        let row = self.beside.outputs.iter().find(|(output, _)| *output == of);
        if let &Op::Input(input) = self.graph.op(by)
            && let Some(&entry) = row.and_then(|(_, row)| row.get(input))
        {
            return entry;
        }
        self.graph.derivative(of, by)
    }

    /// `\mathrm{d}x` or `\delta x` of something that is defined and varies.
    pub(super) fn change(&mut self, name: &Name, at: usize, place: Place<'_>) -> Result<Option<Value>, Error> {
        let Some(of) = name.unchanged() else { return Ok(None) };
        if let Some(value) = self.defined(&of, at, place)? {
            return Ok(Some(match value {
                Value::Scalar(id) => Value::Scalar(self.total(id)),
                Value::Vector(parts) => Value::Vector(parts.into_iter().map(|id| self.total(id)).collect()),
                Value::Matrix(parts) => Value::Matrix(parts.into_iter().map(|id| self.total(id)).collect()),
                Value::Normal | Value::Zero => return Ok(None),
            }));
        }
        Ok(None)
    }

    /// The same for a component.
    pub(super) fn change_of_component(
        &mut self,
        name: &Name,
        at: usize,
        place: Place<'_>,
    ) -> Result<Option<Value>, Error> {
        let of = name.unchanged();
        let Some((vector, index)) = of.as_ref().and_then(Name::component) else { return Ok(None) };
        let Some(Value::Vector(parts)) = self.defined(&vector, at, place)? else { return Ok(None) };
        let changes: Vec<_> = parts.into_iter().map(|id| self.total(id)).collect();
        self.component(&changes, index, at, place).map(Some)
    }

    /// The total change of a number, directly and through the outputs of the code it contains.
    fn total(&mut self, of: Node) -> Node {
        let mut sum = self.graph.number(0.0);
        for (by, change) in self.beside.changes.clone() {
            let slope = self.graph.derivative(of, by);
            let term = self.graph.product(slope, change);
            sum = self.graph.sum(sum, term);
        }
        for (output, row) in self.beside.outputs.clone() {
            let slope = self.graph.derivative(of, output);
            for (by, change) in self.beside.changes.clone() {
                if let &Op::Input(input) = self.graph.op(by)
                    && let Some(&entry) = row.get(input)
                {
                    let step = self.graph.product(entry, change);
                    let term = self.graph.product(slope, step);
                    sum = self.graph.sum(sum, term);
                }
            }
        }
        sum
    }
}
