//! Expressions written as LaTeX that parses back to the same expressions.

use super::name::Name;
use super::syntax::{Body, Condition, Expr, Function, Kind, Operator, Relation, Statement};
use super::token::LETTERS;

/// A statement.
pub(super) fn statement(statement: &Statement) -> String {
    let mut names: Vec<_> = statement.names.iter().map(name).collect();
    let head = if names.len() == 1 { names.swap_remove(0) } else { format!("({})", names.join(", ")) };
    let parameters = match &statement.parameters[..] {
        [] => String::new(),
        all => format!("({})", all.iter().map(name).collect::<Vec<_>>().join(", ")),
    };
    let body = match &statement.body {
        Body::Equal(sides) => sides.iter().map(sum).collect::<Vec<_>>().join(" = "),
        Body::ArgMin(found) => format!(
            r"\operatorname*{{arg\,min}}_{{{} \le {head} \le {}}}\,{}",
            sum(&found.low),
            sum(&found.high),
            term(&found.objective)
        ),
        Body::Chain(first, rest) => {
            let rest = rest.iter().map(|(relation, side)| format!("{} {}", sign(*relation), sum(side)));
            format!("{} {}", sum(first), rest.collect::<Vec<_>>().join(" "))
        }
    };
    format!("{head}{parameters} = {body}")
}

/// A symbol.
pub(super) fn name(name: &Name) -> String {
    let letter = |word: &str| if LETTERS.contains(&word) { format!(r"\{word}") } else { word.to_owned() };
    let change = |c| match c {
        'd' => r"\mathrm{d}",
        'δ' => r"\delta ",
        _ => r"\Delta ",
    };
    let base = match (name.bold, name.base.chars().count(), LETTERS.contains(&name.base.as_str())) {
        (true, _, true) => format!(r"\boldsymbol{{\{}}}", name.base),
        (true, ..) => format!(r"\mathbf{{{}}}", name.base),
        (false, _, true) => letter(&name.base),
        (false, 1, _) => name.base.clone(),
        _ => format!(r"\mathit{{{}}}", name.base),
    };
    let piece = |piece: &String| match piece.as_str() {
        "min" | "max" | "times" | "perp" => format!(r"\{piece}"),
        word if word.chars().count() == 1 || LETTERS.contains(&word) => letter(word),
        word => format!(r"\mathrm{{{word}}}"),
    };
    let below = name.below.iter().map(piece).fold(String::new(), |all, next| {
        // A letter would otherwise become part of the command before it.
        let is_command = all.rfind('\\').is_some_and(|at| all[at + 1..].chars().all(|c| c.is_ascii_alphabetic()));
        if is_command { all + &spaced(&next) } else { all + &next }
    });
    let below = if below.is_empty() { below } else { format!("_{{{below}}}") };
    let above = match name.above.as_str() {
        "" => String::new(),
        "-" => "^-".into(),
        _ => format!("^{{{}}}", piece(&name.above)),
    };
    let changes: String = name.change.chars().map(change).collect();
    format!("{changes}{base}{}{below}{above}", "'".repeat(name.primes))
}

/// Writes a sum or any other expression.
fn sum(e: &Expr) -> String {
    match &e.kind {
        Kind::Binary(Operator::Add, a, b) => match &b.kind {
            Kind::Negative(b) => format!("{} - {}", sum(a), term(b)),
            Kind::Binary(Operator::Add | Operator::Subtract, ..) => format!("{} + {}", sum(a), sum(b)),
            _ => format!("{} + {}", sum(a), term(b)),
        },
        Kind::Binary(Operator::Subtract, a, b) => format!("{} - {}", sum(a), term(b)),
        _ => term(e),
    }
}

/// Writes a signed product or a simpler expression.
fn term(e: &Expr) -> String {
    match &e.kind {
        Kind::Negative(inside) => format!("-{}", term(inside)),
        Kind::Binary(operator @ (Operator::Times | Operator::Dot | Operator::Cross | Operator::Outer), a, b) => {
            product(*operator, a, b)
        }
        Kind::Sum { index, from, to, body } => format!(r"\sum_{{{index}={from}}}^{{{to}}} {}", term(body)),
        _ => factor(e),
    }
}

fn product(operator: Operator, a: &Expr, b: &Expr) -> String {
    let is_product = |e: &Expr, of: &[Operator]| matches!(&e.kind, Kind::Binary(operator, ..) if of.contains(operator));
    if operator == Operator::Times {
        // Numbers come first; a bracket does not follow a symbol, where it could be read as a function argument.
        let (a, b) = match (&a.kind, &b.kind) {
            (Kind::Number(_), _) => (a, b),
            (_, Kind::Number(_)) => (b, a),
            (Kind::Symbol(_), _) if is_bracketed(b) && (a.is_vector() || b.is_vector()) => (b, a),
            _ => (a, b),
        };
        let left = if is_product(a, &[Operator::Times]) { term(a) } else { factor(a) };
        let is_function = matches!(&a.kind, Kind::Symbol(_)) && is_bracketed(b);
        let cut = is_function || matches!((&a.kind, &b.kind), (Kind::Number(_), Kind::Number(_)));
        return format!("{left}{}{}", if cut { r"\cdot " } else { r"\," }, factor(b));
    }
    let sign = match operator {
        Operator::Dot => r"\cdot",
        Operator::Outer => r"\otimes",
        _ => r"\times",
    };
    let left = if is_product(a, &[Operator::Times]) { term(a) } else { factor(a) };
    format!("{left}{sign}{}", spaced(&factor(b)))
}

fn is_bracketed(e: &Expr) -> bool {
    let text = factor(e);
    text.starts_with('(') || text.starts_with(r"\left(")
}

/// Adds a space where a letter would otherwise become part of the command before it.
fn spaced(text: &str) -> String {
    if text.starts_with(|c: char| c.is_ascii_alphabetic()) { format!(" {text}") } else { text.to_owned() }
}

/// Writes a factor of a product.
fn factor(e: &Expr) -> String {
    match &e.kind {
        Kind::Power(base, exponent) => {
            let is_plain = match &base.kind {
                Kind::Symbol(name) => name.above.is_empty() && name.change.is_empty(),
                Kind::Number(_) => true,
                _ => false,
            };
            let base = if is_plain { atom(base) } else { bracket(base) };
            match &exponent.kind {
                Kind::Number(value) => format!("{base}^{value}"),
                _ => format!("{base}^{{{}}}", sum(exponent)),
            }
        }
        _ => atom(e),
    }
}

fn bracket(e: &Expr) -> String {
    let inside = sum(e);
    if is_low(e) { format!("({inside})") } else { format!(r"\left({inside}\right)") }
}

/// Whether an expression contains no fraction, root or cases, so that plain brackets are tall enough.
fn is_low(e: &Expr) -> bool {
    let is_high = matches!(&e.kind, Kind::Binary(Operator::Divide, ..) | Kind::Cases(_) | Kind::Sum { .. });
    !is_high && e.parts().into_iter().all(is_low)
}

fn atom(e: &Expr) -> String {
    let list = |all: &[Expr]| all.iter().map(sum).collect::<Vec<_>>().join(", ");
    match &e.kind {
        Kind::Number(value) => value.to_string(),
        Kind::Symbol(symbol) => name(symbol),
        Kind::Apply(function, arguments) => format!("{}({})", name(function), list(arguments)),
        Kind::Call(function, arguments) => call(*function, arguments),
        Kind::Binary(Operator::Divide, a, b) => match (&a.kind, &b.kind) {
            (Kind::Number(a), Kind::Number(b)) => format!(r"\tfrac{{{a}}}{{{b}}}"),
            _ => format!(r"\frac{{{}}}{{{}}}", sum(a), sum(b)),
        },
        Kind::Size(inside) => format!(r"\lvert {}\rvert", sum(inside)),
        Kind::Cases(rows) => {
            let row = |(value, condition): &(Expr, Condition)| format!("{} & {}", sum(value), cases(condition));
            format!(r"\begin{{cases}} {} \end{{cases}}", rows.iter().map(row).collect::<Vec<_>>().join(r" \\ "))
        }
        Kind::Tuple(items) => format!("({})", list(items)),
        Kind::Partial(of, by) => format!(r"\frac{{\partial {}}}{{\partial {}}}", factor(of), name(by)),
        Kind::Item(tuple, _) => atom(tuple),
        _ => bracket(e),
    }
}

fn call(function: Function, arguments: &[Expr]) -> String {
    let inside = arguments.iter().map(sum).collect::<Vec<_>>().join(", ");
    let is_symbol = matches!(&arguments[0].kind, Kind::Symbol(_));
    let of = if is_symbol && function != Function::Atan2 { spaced(&inside) } else { format!("({inside})") };
    match function {
        Function::Sqrt => format!(r"\sqrt{{{inside}}}"),
        Function::Sin => format!(r"\sin{of}"),
        Function::Cos => format!(r"\cos{of}"),
        Function::ArcSin => format!(r"\arcsin{of}"),
        Function::Sign => format!(r"\operatorname{{sign}}{of}"),
        Function::Round => format!(r"\operatorname{{round}}{of}"),
        Function::Atan2 => format!(r"\operatorname{{atan2}}{of}"),
    }
}

fn cases(condition: &Condition) -> String {
    let one = |(a, relation, b): &(Expr, Relation, Expr)| format!("{} {} {}", sum(a), sign(*relation), sum(b));
    match &condition[..] {
        [] => r"\text{otherwise}".into(),
        all => all.iter().map(one).collect::<Vec<_>>().join(r",\ "),
    }
}

fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => r"\le",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => r"\ge",
        Relation::Equal => "=",
        Relation::Unequal => r"\ne",
    }
}

#[cfg(test)]
mod tests {
    use super::{name, statement};
    use crate::toolkit::equation::statement::{statements, symbols};

    #[test]
    fn brackets_are_as_high_as_what_stands_in_them() {
        for latex in [
            r"a = (b + c)^2",
            r"a = \left(\frac{b}{c}\right)^2",
            r"a = \left(b + \frac{c}{d}\right)\,e",
            r"a = (b - (c + d))\,e",
        ] {
            assert_eq!(statement(&statements(latex, Vec::new()).unwrap()[0]), latex);
        }
    }
    #[test]
    fn what_is_written_is_what_was_read() {
        for latex in [
            "a = b = -c - d",
            r"a = -b\,c\,d",
            r"a = b - (c - d) - e",
            r"a = -(b + c)",
            r"a = 2\,b + c",
            r"a = b\cdot(c - d)",
            r"a = (b + c)\,(d + e)",
            r"a = b^2\,(c + d)",
            r"\mathbf{a} = (b + c)\,\mathbf{d}",
            r"\mathbf{a} = (\mathbf{b}\times\mathbf{c})\times d",
            r"a = \mathbf{b}\cdot(\mathbf{c}\times\mathbf{d}) + \mathbf{b}\otimes\mathbf{d}",
            r"a = \frac{b + c}{d} + \tfrac{1}{2}",
            r"a = \frac{\partial b}{\partial c}",
            r"a = \sum_{q=1}^{3} b_{q}\,c",
            r"a = \left(\sum_{q=1}^{3} b_{q}\right)\,c",
            r"a = \lvert b - c\rvert + \sqrt{b + c} + e^{b - c}",
            r"a = \sin b + \cos(b + c) + \arcsin\alpha",
            r"a = \operatorname{sign} b + \operatorname{round}(b - c) + \operatorname{atan2}(b, c)",
            r"a = (b^{\mathrm{int}})^2 + (\Delta b)^3 + 2^2 + b^9",
            r"a = \begin{cases} b & c > d,\ e \le b \\ c & d \ge e \\ d & e \ne b \\ e & c < d \\ b & c = d \\ c & \text{otherwise} \end{cases}",
            r"a = \left(\begin{cases} b & c > d \end{cases}\right)^2",
            "r(g, h) = g^2",
            r"a = \operatorname*{arg\,min}_{-1 \le a \le b}\,\lvert c\rvert",
        ] {
            assert_eq!(statement(&statements(latex, Vec::new()).unwrap()[0]), latex);
        }
        for (read, written) in [
            (r"a = b + (c - d)", "a = b + c - d"),
            // A bracket after a symbol could be read as a function argument.
            (r"a = b\,(c + d)", r"a = b\cdot (c + d)"),
            (r"\mathbf{a} = \mathbf{b}\,(c + d)", r"\mathbf{a} = (c + d)\,\mathbf{b}"),
            (r"a = (b)", "a = b"),
        ] {
            assert_eq!(statement(&statements(read, Vec::new()).unwrap()[0]), written);
        }
        let functions = statements(r"r(g, h) = g\,h,\quad a = r(b, 2)\,r(c + d, 1)", Vec::new()).unwrap();
        assert_eq!(statement(&functions[1]), r"a = r(b, 2)\,r(c + d, 1)");
    }

    #[test]
    fn names_are_written_as_they_are_read() {
        for latex in [
            "x",
            "x_{2}",
            "x_{m,k}",
            "X''_{1}",
            r"\mathbf{X}'",
            r"F_{C}^{\mathrm{int}}",
            r"\boldsymbol{\theta}_{\mathrm{axial}k}",
            r"\mathit{ab}",
            r"\mathbf{ab}",
            r"\mathrm{d}x",
            r"\Delta x",
            r"\delta \mathrm{d}x",
            r"\delta \Delta \mathbf{x}",
            "c^-",
            r"c^{\max}",
            r"c_{\alpha k}",
            r"c_{\alpha\beta}",
            r"c_{\max}",
            r"c_{\perp1}",
            r"c_{k\alpha}",
            r"\ell",
            r"\alpha_{1}",
        ] {
            assert_eq!(name(&symbols(latex).unwrap()[0].0), latex);
        }
    }
}
