//! The parser of functions, and powers as roots and quotients.

use super::cursor::Parser;
use super::error::Error;
use super::name::Name;
use super::syntax::{Expr, Function, Kind, Operator, Relation, binary};
use super::token::Kind as Word;

impl Parser<'_> {
    /// Parses the arguments of a function.
    pub(super) fn function(&mut self, name: &str, at: usize) -> Result<Kind, Error> {
        let call = |function, argument| Kind::Call(function, vec![argument]);
        Ok(match name {
            "sqrt" if self.sees('[') => {
                return Err(self.expected("a square root: others are powers, as in `x^{3/2}`;"));
            }
            "sqrt" if self.sees('(') => call(Function::Sqrt, self.base()?),
            "sqrt" => call(Function::Sqrt, self.argument()?),
            "sin" | "cos" | "tan" | "cot" => return self.trigonometric(name, at),
            "asin" | "acos" | "atan" | "arcsin" | "arccos" | "arctan" => {
                inverse(name.trim_start_matches("arc").trim_start_matches('a'), self.single_argument()?, at)
            }
            "sign" | "sgn" => call(Function::Sign, self.single_argument()?),
            "round" => call(Function::Round, self.single_argument()?),
            "abs" | "norm" => Kind::Size(Box::new(self.single_argument()?)),
            "exp" => {
                let e = Expr { kind: Kind::Symbol(Name::letter('e')), at };
                Kind::Power(Box::new(e), Box::new(self.single_argument()?))
            }
            "min" | "max" => {
                let relation = if name == "max" { Relation::GreaterOrEqual } else { Relation::LessOrEqual };
                self.expect('(')?;
                let mut all = self.list(')')?.into_iter();
                let first = all.next().ok_or_else(|| Error::new(at, format!("{name} has 2 arguments or more")))?;
                let chosen = |a: Expr, b: Expr| {
                    let is_first = vec![(a.clone(), relation, b.clone())];
                    Expr { kind: Kind::Cases(vec![(a, is_first), (b, Vec::new())]), at }
                };
                all.fold(first, chosen).kind
            }
            _ => {
                self.expect('(')?;
                let two = self.list(')')?;
                let [a, b] = <[Expr; 2]>::try_from(two)
                    .map_err(|other| Error::new(at, format!("{name} has 2 arguments, not {}", other.len())))?;
                match name {
                    "dot" => binary(Operator::Dot, a, b, at).kind,
                    "cross" => binary(Operator::Cross, a, b, at).kind,
                    "hypot" => call(Function::Sqrt, binary(Operator::Add, square(a), square(b), at)),
                    _ => Kind::Call(Function::Atan2, vec![a, b]),
                }
            }
        })
    }

    /// `\cos\beta`, `\cos^2\beta`, `\tan^{-1}\beta`
    fn trigonometric(&mut self, name: &str, at: usize) -> Result<Kind, Error> {
        let power = if self.took_sign('^') { Some(self.argument()?) } else { None };
        let is_bracketed = self.sees('(') || self.sees('[');
        let argument = self.single_argument()?;
        if self.sees('^') && !is_bracketed {
            return Err(Error::new(
                self.peek().at,
                format!(r"this is read in two ways: write `\{name}^2 x` or `\{name}(x^2)`"),
            ));
        }
        let is_inverse = |power: &Expr| exact(power) == Some((-1.0, 1.0));
        if power.as_ref().is_some_and(is_inverse) {
            return Ok(inverse(name, argument, at));
        }
        let call = |function| Expr { kind: Kind::Call(function, vec![argument.clone()]), at };
        let value = match name {
            "sin" => call(Function::Sin),
            "cos" => call(Function::Cos),
            "tan" => binary(Operator::Divide, call(Function::Sin), call(Function::Cos), at),
            _ => binary(Operator::Divide, call(Function::Cos), call(Function::Sin), at),
        };
        Ok(match power {
            Some(power) => power_of(value, power, at).kind,
            None => value.kind,
        })
    }

    /// Parses the argument of a function without brackets: a symbol, or an expression in brackets.
    fn single_argument(&mut self) -> Result<Expr, Error> {
        match self.peek().kind {
            Word::Digit(_) => Err(self.expected("a bracket around the argument")),
            _ => self.base(),
        }
    }
}

fn square(e: Expr) -> Expr {
    let (at, two) = (e.at, Expr { kind: Kind::Number(2.0), at: e.at });
    Expr { kind: Kind::Power(Box::new(e), Box::new(two)), at }
}

/// A power, by roots and quotients if the exponent is half a number or negative.
pub(super) fn power_of(base: Expr, exponent: Expr, at: usize) -> Expr {
    let Some((above, below)) = exact(&exponent) else {
        return Expr { kind: Kind::Power(Box::new(base), Box::new(exponent)), at };
    };
    let number = |value| Expr { kind: Kind::Number(value), at: exponent.at };
    let halves = 2.0 * above / below;
    if halves.fract() != 0.0 || halves == 0.0 {
        return Expr { kind: Kind::Power(Box::new(base), Box::new(number(above / below))), at };
    }
    let is_whole = (halves / 2.0).fract() == 0.0;
    let root = if is_whole { base } else { Expr { kind: Kind::Call(Function::Sqrt, vec![base]), at } };
    let whole = if is_whole { halves.abs() / 2.0 } else { halves.abs() };
    let power =
        if whole == 1.0 { root } else { Expr { kind: Kind::Power(Box::new(root), Box::new(number(whole))), at } };
    if halves < 0.0 { binary(Operator::Divide, number(1.0), power, at) } else { power }
}

/// A number, or a quotient of two.
fn exact(e: &Expr) -> Option<(f64, f64)> {
    match &e.kind {
        Kind::Number(value) => Some((*value, 1.0)),
        Kind::Negative(inside) => exact(inside).map(|(above, below)| (-above, below)),
        Kind::Binary(Operator::Divide, a, b) => match (exact(a)?, exact(b)?) {
            ((a, b), (c, d)) if b * c != 0.0 => Some((a * d, b * c)),
            _ => None,
        },
        _ => None,
    }
}

/// The angle with this sine, cosine, tangent or cotangent.
fn inverse(name: &str, of: Expr, at: usize) -> Kind {
    let one = || Expr { kind: Kind::Number(1.0), at };
    let rest = |of: &Expr| {
        let rest = binary(Operator::Subtract, one(), square(of.clone()), at);
        Expr { kind: Kind::Call(Function::Sqrt, vec![rest]), at }
    };
    match name {
        "sin" => Kind::Call(Function::ArcSin, vec![of]),
        "cos" => Kind::Call(Function::Atan2, vec![rest(&of), of]),
        "tan" => Kind::Call(Function::Atan2, vec![of, one()]),
        _ => Kind::Call(Function::Atan2, vec![one(), of]),
    }
}
