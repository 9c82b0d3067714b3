//! The variation δ of an equation: how its definitions change with its inputs, as an equation.

use super::closed::symbols;
use super::name::Name;
use super::syntax::{ArgMin, Body, Condition, Expr, Function, Kind, Operator, Relation, Statement};

/// The variations of the statements that vary, in the same order.
pub(super) fn variations(statements: &[Statement], inputs: &[Name]) -> Vec<Statement> {
    let mut rules = Rules { statements, inputs, varying: Vec::new(), by: None, index: None };
    rules.find_varying();
    statements.iter().filter_map(|statement| rules.statement(statement)).collect()
}

struct Rules<'s> {
    statements: &'s [Statement],
    inputs: &'s [Name],
    /// The symbols that vary with the inputs.
    varying: Vec<Name>,
    /// The only symbol that varies, at unit rate; if `None`, all inputs vary.
    by: Option<Name>,
    /// The index of a sum, and one of its values.
    index: Option<(&'s str, usize)>,
}

impl Rules<'_> {
    /// Marks definitions that contain something that varies.
    fn find_varying(&mut self) {
        loop {
            let next = self.statements.iter().find(|statement| {
                let known = self.varying.contains(&statement.names[0]);
                !known && statement.expressions().into_iter().any(|e| self.varies(e, &statement.parameters))
            });
            let Some(next) = next else { return };
            self.varying.push(next.names[0].clone());
        }
    }

    /// Whether any value in the expression varies; conditions do not count.
    fn varies(&self, e: &Expr, held: &[Name]) -> bool {
        let mut names = Vec::new();
        match &e.kind {
            Kind::Cases(rows) => return rows.iter().any(|(value, _)| self.varies(value, held)),
            Kind::Sum { index, from, body, .. } => return self.varies(&body.with_index(index, *from), held),
            Kind::Call(Function::Sign | Function::Round, _) | Kind::Number(_) => return false,
            Kind::Symbol(_) | Kind::Apply(..) => {
                let own = Expr { kind: e.kind.clone(), at: 0 };
                symbols(&own, &mut names);
            }
            _ => return e.parts().into_iter().any(|part| self.varies(part, held)),
        }
        names.iter().any(|name| !held.contains(name) && (self.varying.contains(name) || self.is_input(name)))
    }

    /// The symbol with the index replaced by its value.
    fn indexed(&self, name: &Name) -> Name {
        self.index.map_or_else(|| name.clone(), |(index, value)| name.with_index(index, value))
    }

    fn is_input(&self, name: &Name) -> bool {
        self.inputs.contains(name)
    }

    fn statement(&self, statement: &Statement) -> Option<Statement> {
        let name = &statement.names[0];
        let body = match &statement.body {
            Body::Equal(sides) => self.of(&sides[0], &statement.parameters)?,
            Body::ArgMin(found) => self.place(name, found)?,
            Body::Chain(..) => return None,
        };
        Some(Statement { names: vec![name.varied()], body: Body::Equal(vec![body]), ..statement.clone() })
    }

    /// The variation of a minimiser: between its bounds the slope of the objective remains 0.
    fn place(&self, name: &Name, found: &ArgMin) -> Option<Expr> {
        let Kind::Size(gap) = &found.objective.kind else { return None };
        let gap = self.without_functions(gap);
        let fixed = Self { by: Some(name.clone()), varying: Vec::new(), ..*self };
        let slope = dot(gap.clone(), fixed.of(&gap, &[])?);
        let (numerator, curvature) = (self.of(&slope, std::slice::from_ref(name))?, fixed.of(&slope, &[])?);
        let symbol = |name: &Name| expr(Kind::Symbol(name.clone()));
        let inside: Condition =
            vec![(found.low.clone(), Relation::Less, symbol(name)), (symbol(name), Relation::Less, found.high.clone())];
        let rows = vec![(negative(divide(numerator, curvature)), inside), (number(0.0), Vec::new())];
        Some(expr(Kind::Cases(rows)))
    }

    /// Replaces applications of functions by their bodies.
    fn without_functions(&self, e: &Expr) -> Expr {
        e.replaced(&|part| self.applied(part).map(|inside| self.without_functions(&inside)))
    }

    /// The body of a function with its arguments, or with the symbols of its parameters if there are none.
    fn applied(&self, e: &Expr) -> Option<Expr> {
        let (name, arguments) = match &e.kind {
            Kind::Apply(name, arguments) => (name, Some(arguments)),
            Kind::Symbol(name) => (name, None),
            _ => return None,
        };
        let name = self.indexed(name);
        let statement = self.statements.iter().find(|statement| statement.names[0] == name)?;
        let Body::Equal(sides) = &statement.body else { return None };
        if statement.parameters.is_empty() {
            return None;
        }
        let put = |part: &Expr| match &part.kind {
            Kind::Symbol(symbol) => {
                let k = statement.parameters.iter().position(|parameter| parameter == symbol)?;
                arguments.map(|arguments| arguments[k].clone())
            }
            _ => None,
        };
        Some(sides[0].replaced(&put))
    }

    /// The variation of an expression, `None` if it does not vary; `held` are symbols that do not vary.
    fn of(&self, e: &Expr, held: &[Name]) -> Option<Expr> {
        match &e.kind {
            Kind::Number(_) | Kind::Partial(..) => None,
            Kind::Symbol(name) => self.symbol(name, held),
            Kind::Apply(name, arguments) => {
                if arguments.iter().any(|argument| self.of(argument, held).is_some()) {
                    return self.of(&self.applied(e)?, held);
                }
                let changes = self.varying.contains(&self.indexed(name));
                changes.then(|| expr(Kind::Apply(name.varied(), arguments.clone())))
            }
            Kind::Call(function, arguments) => self.call(*function, arguments, e, held),
            Kind::Negative(inside) => self.of(inside, held).map(negative),
            Kind::Binary(operator, a, b) => self.binary(*operator, a, b, held),
            Kind::Power(base, exponent) => self.power(base, exponent, e, held),
            Kind::Size(inside) => {
                let change = self.of(inside, held)?;
                Some(if inside.is_vector() {
                    divide(dot((**inside).clone(), change), e.clone())
                } else {
                    times(expr(Kind::Call(Function::Sign, vec![(**inside).clone()])), change)
                })
            }
            Kind::Cases(rows) => {
                let changes: Vec<_> = rows.iter().map(|(value, _)| self.of(value, held)).collect();
                if changes.iter().all(Option::is_none) {
                    return None;
                }
                let zero =
                    |value: &Expr| if value.is_vector() { times(number(0.0), value.clone()) } else { number(0.0) };
                let pairs = changes.into_iter().zip(rows);
                let rows = pairs.map(|(change, (value, c))| (change.unwrap_or_else(|| zero(value)), c.clone()));
                Some(expr(Kind::Cases(rows.collect())))
            }
            Kind::Sum { index, from, to, body } => {
                let inside =
                    Rules { index: Some((index, *from)), varying: self.varying.clone(), by: self.by.clone(), ..*self };
                let body = Box::new(inside.of(body, held)?);
                Some(expr(Kind::Sum { index: index.clone(), from: *from, to: *to, body }))
            }
            Kind::Tuple(items) => {
                let changes: Vec<_> = items.iter().map(|item| self.of(item, held)).collect();
                let is_fixed = changes.iter().all(Option::is_none);
                let items = changes.into_iter().map(|change| change.unwrap_or_else(|| number(0.0)));
                (!is_fixed).then(|| expr(Kind::Tuple(items.collect())))
            }
            Kind::Item(tuple, k) => self.of(tuple, held).map(|tuple| expr(Kind::Item(Box::new(tuple), *k))),
        }
    }

    fn symbol(&self, name: &Name, held: &[Name]) -> Option<Expr> {
        if let Some(by) = &self.by {
            return (name == by).then(|| number(1.0));
        }
        let written = name;
        let name = &self.indexed(name);
        let vector = name.component().map(|(vector, _)| vector);
        let is_held = |name: &Name| held.contains(name);
        let changes = |name: &Name| !is_held(name) && (self.is_input(name) || self.varying.contains(name));
        let own = Expr { kind: Kind::Symbol(name.clone()), at: 0 };
        if let Some(body) = self.applied(&own) {
            // A function without arguments also varies with the symbol of its parameter.
            return self.of(&body, held);
        }
        (changes(name) || vector.as_ref().is_some_and(changes)).then(|| expr(Kind::Symbol(written.varied())))
    }

    fn binary(&self, operator: Operator, a: &Expr, b: &Expr, held: &[Name]) -> Option<Expr> {
        let (change_a, change_b) = (self.of(a, held), self.of(b, held));
        let make = |a: Expr, b: Expr| expr(Kind::Binary(operator, Box::new(a), Box::new(b)));
        match operator {
            Operator::Add => plus(change_a, change_b),
            Operator::Subtract => plus(change_a, change_b.map(negative)),
            Operator::Divide => match (change_a, change_b) {
                (above, None) => above.map(|above| divide(above, b.clone())),
                (above, Some(below)) => {
                    let square = expr(Kind::Power(Box::new(b.clone()), Box::new(number(2.0))));
                    let lessened = negative(divide(times(a.clone(), below), square));
                    plus(above.map(|above| divide(above, b.clone())), Some(lessened))
                }
            },
            Operator::Times => {
                plus(change_a.map(|change| times(change, b.clone())), change_b.map(|c| times(a.clone(), c)))
            }
            Operator::Dot | Operator::Cross | Operator::Outer => {
                plus(change_a.map(|change| make(change, b.clone())), change_b.map(|change| make(a.clone(), change)))
            }
        }
    }

    fn power(&self, base: &Expr, exponent: &Expr, whole: &Expr, held: &[Name]) -> Option<Expr> {
        let Kind::Number(power) = exponent.kind else {
            return self.of(exponent, held).map(|change| times(whole.clone(), change));
        };
        let change = self.of(base, held)?;
        let lower = if power == 2.0 {
            base.clone()
        } else {
            expr(Kind::Power(Box::new(base.clone()), Box::new(number(power - 1.0))))
        };
        Some(times(times(number(power), lower), change))
    }

    fn call(&self, function: Function, arguments: &[Expr], whole: &Expr, held: &[Name]) -> Option<Expr> {
        let first = &arguments[0];
        let again = |function| expr(Kind::Call(function, arguments.to_vec()));
        let square = |e: &Expr| expr(Kind::Power(Box::new(e.clone()), Box::new(number(2.0))));
        match function {
            Function::Sign | Function::Round => None,
            Function::Sqrt => {
                let change = self.of(first, held)?;
                let half = halved(&change).unwrap_or_else(|| divide(change, number(2.0)));
                Some(divide(half, whole.clone()))
            }
            Function::Sin => Some(times(again(Function::Cos), self.of(first, held)?)),
            Function::Cos => Some(negative(times(again(Function::Sin), self.of(first, held)?))),
            Function::ArcSin => {
                let rest = minus(number(1.0), square(first));
                Some(divide(self.of(first, held)?, expr(Kind::Call(Function::Sqrt, vec![rest]))))
            }
            Function::Atan2 => {
                let (y, x) = (first, &arguments[1]);
                let left = self.of(y, held).map(|change| times(x.clone(), change));
                let right = self.of(x, held).map(|change| negative(times(y.clone(), change)));
                let below = plus(Some(square(y)), Some(square(x)))?;
                plus(left, right).map(|above| divide(above, below))
            }
        }
    }
}

/// Half of the expression, if every term has the factor 2.
fn halved(e: &Expr) -> Option<Expr> {
    match &e.kind {
        Kind::Binary(Operator::Times, a, b) => match &a.kind {
            Kind::Number(2.0) => Some((**b).clone()),
            _ => Some(times(halved(a)?, (**b).clone())),
        },
        Kind::Binary(Operator::Add, a, b) => plus(Some(halved(a)?), Some(halved(b)?)),
        Kind::Negative(inside) => halved(inside).map(negative),
        _ => None,
    }
}

fn expr(kind: Kind) -> Expr {
    Expr { kind, at: 0 }
}

fn number(value: f64) -> Expr {
    expr(Kind::Number(value))
}

fn negative(e: Expr) -> Expr {
    match e.kind {
        Kind::Negative(inside) => *inside,
        Kind::Number(0.0) => e,
        _ => expr(Kind::Negative(Box::new(e))),
    }
}

fn plus(a: Option<Expr>, b: Option<Expr>) -> Option<Expr> {
    match (a, b) {
        (Some(a), Some(b)) => Some(match b.kind {
            Kind::Negative(b) => minus(a, *b),
            _ => expr(Kind::Binary(Operator::Add, Box::new(a), Box::new(b))),
        }),
        (a, b) => a.or(b),
    }
}

fn minus(a: Expr, b: Expr) -> Expr {
    expr(Kind::Binary(Operator::Subtract, Box::new(a), Box::new(b)))
}

fn dot(a: Expr, b: Expr) -> Expr {
    match (a.kind, b.kind) {
        (Kind::Negative(a), Kind::Negative(b)) => dot(*a, *b),
        (Kind::Negative(a), b) => negative(dot(*a, expr(b))),
        (a, Kind::Negative(b)) => negative(dot(expr(a), *b)),
        (a, b) => expr(Kind::Binary(Operator::Dot, Box::new(expr(a)), Box::new(expr(b)))),
    }
}

fn divide(a: Expr, b: Expr) -> Expr {
    match a.kind {
        Kind::Negative(a) => negative(divide(*a, b)),
        _ => expr(Kind::Binary(Operator::Divide, Box::new(a), Box::new(b))),
    }
}

/// A product from left to right, its number first; signs and factors of 1 are omitted.
fn times(a: Expr, b: Expr) -> Expr {
    match (a.kind, b.kind) {
        (Kind::Negative(a), b) => negative(times(*a, expr(b))),
        (a, Kind::Negative(b)) => negative(times(expr(a), *b)),
        (Kind::Number(1.0), other) | (other, Kind::Number(1.0)) => expr(other),
        (Kind::Number(a), Kind::Number(b)) => number(a * b),
        (a, Kind::Binary(Operator::Times, b, c)) => times(times(expr(a), *b), *c),
        (Kind::Binary(Operator::Times, a, rest), Kind::Number(b)) if matches!(a.kind, Kind::Number(_)) => {
            times(times(*a, number(b)), *rest)
        }
        (a, Kind::Number(b)) => times(number(b), expr(a)),
        (a, b) => expr(Kind::Binary(Operator::Times, Box::new(expr(a)), Box::new(expr(b)))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::equation::latex;
    use crate::toolkit::equation::statement::statements;

    #[test]
    fn what_does_not_change_in_one_case_is_zero_there() {
        let given = r"\mathbf{a} = \begin{cases} \mathbf{b} & c > 0 \\ \mathbf{d} & \text{otherwise} \end{cases},\quad e = \begin{cases} 2\,f & c > 0 \\ g & \text{otherwise} \end{cases}";
        let given = statements(given, Vec::new()).unwrap();
        let changing = [Name { bold: true, ..Name::letter("b") }, Name::letter("f")];
        let varied: Vec<_> = variations(&given, &changing).iter().map(latex::statement).collect();
        let expected = [
            r"\delta \mathbf{a} = \begin{cases} \delta \mathbf{b} & c > 0 \\ 0\,\mathbf{d} & \text{otherwise} \end{cases}",
            r"\delta e = \begin{cases} 2\,\delta f & c > 0 \\ 0 & \text{otherwise} \end{cases}",
        ];
        assert_eq!(varied, expected);
    }

    /// The variations of statements with a, b and **v** as inputs.
    fn varied(given: &str) -> Vec<String> {
        let inputs = [Name::letter("a"), Name::letter("b"), Name { bold: true, ..Name::letter("v") }];
        variations(&statements(given, Vec::new()).unwrap(), &inputs).iter().map(latex::statement).collect()
    }

    #[test]
    fn each_operation_has_its_rule() {
        for (given, expected) in [
            ("a + k", r"\delta a"),
            ("k - a", r"-\delta a"),
            ("a - b", r"\delta a - \delta b"),
            ("-a", r"-\delta a"),
            (r"a\,b", r"\delta a\,b + a\,\delta b"),
            (r"2\,a", r"2\,\delta a"),
            (r"\frac{a}{k}", r"\frac{\delta a}{k}"),
            (r"\frac{k}{a}", r"-\frac{k\,\delta a}{a^2}"),
            (r"\frac{a}{b}", r"\frac{\delta a}{b} - \frac{a\,\delta b}{b^2}"),
            ("a^2", r"2\,a\,\delta a"),
            ("a^3", r"3\,a^2\,\delta a"),
            ("e^{a}", r"e^{a}\,\delta a"),
            (r"\sqrt{a}", r"\frac{\frac{\delta a}{2}}{\sqrt{a}}"),
            (r"\sqrt{a^2 + b^2}", r"\frac{a\,\delta a + b\,\delta b}{\sqrt{a^2 + b^2}}"),
            (r"\sqrt{k - a^2}", r"-\frac{a\,\delta a}{\sqrt{k - a^2}}"),
            (r"\sin a", r"\cos a\,\delta a"),
            (r"\cos a", r"-\sin a\,\delta a"),
            (r"\arcsin a", r"\frac{\delta a}{\sqrt{1 - a^2}}"),
            (r"\operatorname{atan2}(a, b)", r"\frac{b\,\delta a - a\,\delta b}{a^2 + b^2}"),
            (r"\operatorname{atan2}(k, b)", r"-\frac{k\,\delta b}{k^2 + b^2}"),
            (r"\lvert a\rvert", r"\operatorname{sign} a\,\delta a"),
            (r"\lvert\mathbf{v}\rvert", r"\frac{\mathbf{v}\cdot\delta \mathbf{v}}{\lvert \mathbf{v}\rvert}"),
            (r"\mathbf{v}\times\mathbf{c}", r"\delta \mathbf{v}\times\mathbf{c}"),
            (r"\mathbf{c}\cdot\mathbf{v}", r"\mathbf{c}\cdot\delta \mathbf{v}"),
            ("(a, k)", r"(\delta a, 0)"),
            ("v_2", r"\delta v_{2}"),
            (r"\sum_{q=1}^{2} v_q", r"\sum_{q=1}^{2} \delta v_{q}"),
        ] {
            assert_eq!(varied(&format!("y = {given}")), [format!(r"\delta y = {expected}")], "{given}");
        }
    }

    #[test]
    fn what_does_not_change_has_no_variation() {
        let condition = r"\begin{cases} k & a > 0 \\ 2 & \text{otherwise} \end{cases}";
        let index = r"\sum_{q=1}^{2} k_q";
        for fixed in ["k", "2", "k^2", r"\operatorname{sign} a", r"\operatorname{round}(a)", "(k, 0)", condition, index]
        {
            assert_eq!(varied(&format!("y = {fixed}")), [""; 0], "{fixed}");
        }
    }

    #[test]
    fn what_is_defined_changes_with_what_it_is_made_from_in_any_order() {
        assert_eq!(varied(r"y = c + k,\quad c = a,\quad k = 2"), [r"\delta y = \delta c", r"\delta c = \delta a"]);
        // A function varies at fixed arguments, its parameter being local even if an input has the same letter, and
        // with its arguments.
        let functions = r"r(b) = b^2\,a,\quad y = r(k),\quad z = r(b)";
        assert_eq!(
            varied(functions),
            [
                r"\delta r(b) = b^2\,\delta a",
                r"\delta y = \delta r(k)",
                r"\delta z = 2\,b\,\delta b\,a + b^2\,\delta a"
            ]
        );
    }
}
