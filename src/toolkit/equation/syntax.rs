//! The syntax tree of an equation, before symbols are resolved.

use super::name::Name;

/// An expression, and the byte offset at which it begins.
#[derive(Clone, Debug)]
pub(super) struct Expr {
    pub(super) kind: Kind,
    pub(super) at: usize,
}

#[derive(Clone, Debug)]
pub(super) enum Kind {
    Number(f64),
    Symbol(Name),
    /// A declared function with arguments.
    Apply(Name, Vec<Expr>),
    Call(Function, Vec<Expr>),
    Negative(Box<Expr>),
    Binary(Operator, Box<Expr>, Box<Expr>),
    Power(Box<Expr>, Box<Expr>),
    /// Absolute value or length.
    Size(Box<Expr>),
    Cases(Vec<(Expr, Condition)>),
    Sum {
        index: String,
        from: usize,
        to: usize,
        body: Box<Expr>,
    },
    Tuple(Vec<Expr>),
    /// The k-th item of a tuple, counted from 0.
    Item(Box<Expr>, usize),
    /// `\frac{\partial a}{\partial x}`
    Partial(Box<Expr>, Name),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Function {
    Sqrt,
    Sin,
    Cos,
    ArcSin,
    Sign,
    /// The nearest integer.
    Round,
    Atan2,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Add,
    Subtract,
    /// Juxtaposition.
    Times,
    /// `\cdot`
    Dot,
    /// `\times`
    Cross,
    /// `\otimes`
    Outer,
    Divide,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Relation {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    Unequal,
}

/// Comparisons that must all hold; none for "otherwise".
pub(super) type Condition = Vec<(Expr, Relation, Expr)>;

/// `name = …`, a family of them, or a range.
#[derive(Clone, Debug)]
pub(super) struct Statement {
    /// One name, or a tuple of them.
    pub(super) names: Vec<Name>,
    /// The parameters, if a function is declared.
    pub(super) parameters: Vec<Name>,
    pub(super) body: Body,
    pub(super) at: usize,
}

#[derive(Clone, Debug)]
pub(super) enum Body {
    /// Expressions that are all equal.
    Equal(Vec<Expr>),
    ArgMin(Box<ArgMin>),
    /// In prose: sides and their relations. Whether it defines its first side is not yet known.
    Chain(Expr, Vec<(Relation, Expr)>),
}

/// The minimiser of an expression between two bounds.
#[derive(Clone, Debug)]
pub(super) struct ArgMin {
    pub(super) low: Expr,
    pub(super) high: Expr,
    pub(super) objective: Expr,
}

impl Statement {
    /// Whether an index appears in a subscript.
    pub(super) fn has_index(&self, index: &str) -> bool {
        self.names.iter().any(|name| name.has_index(index)) || self.expressions().iter().any(|e| e.has_index(index))
    }

    /// The statement with an index replaced by a number.
    pub(super) fn with_index(&self, index: &str, value: usize) -> Self {
        let put = |e: &Expr| e.with_index(index, value);
        let body = match &self.body {
            Body::Equal(sides) => Body::Equal(sides.iter().map(put).collect()),
            Body::ArgMin(found) => {
                let ArgMin { low, high, objective } = &**found;
                Body::ArgMin(Box::new(ArgMin { low: put(low), high: put(high), objective: put(objective) }))
            }
            Body::Chain(first, rest) => {
                Body::Chain(put(first), rest.iter().map(|(relation, side)| (*relation, put(side))).collect())
            }
        };
        Self { names: self.names.iter().map(|name| name.with_index(index, value)).collect(), body, ..self.clone() }
    }

    /// Whether its first side is a symbol, or a function of symbols, so that it can define it.
    pub(super) fn begins_with_symbol(&self) -> bool {
        match &self.body {
            Body::Chain(first, _) => matches!(first.kind, Kind::Symbol(_) | Kind::Apply(..) | Kind::Tuple(_)),
            Body::Equal(_) | Body::ArgMin(_) => true,
        }
    }

    /// Its expressions.
    pub(super) fn expressions(&self) -> Vec<&Expr> {
        match &self.body {
            Body::Equal(sides) => sides.iter().collect(),
            Body::ArgMin(found) => vec![&found.low, &found.high, &found.objective],
            Body::Chain(first, rest) => std::iter::once(first).chain(rest.iter().map(|(_, side)| side)).collect(),
        }
    }
}

impl Expr {
    fn has_index(&self, index: &str) -> bool {
        match &self.kind {
            Kind::Symbol(name) => name.has_index(index),
            Kind::Apply(name, arguments) => name.has_index(index) || arguments.iter().any(|e| e.has_index(index)),
            Kind::Partial(of, by) => by.has_index(index) || of.has_index(index),
            // A sum over the same letter has its own index.
            Kind::Sum { index: own, .. } if own == index => false,
            _ => self.parts().iter().any(|e| e.has_index(index)),
        }
    }

    /// Whether it is a vector or a matrix, judging by the type of its letters.
    pub(super) fn is_vector(&self) -> bool {
        match &self.kind {
            Kind::Symbol(name) | Kind::Apply(name, _) => name.bold,
            Kind::Negative(e) | Kind::Sum { body: e, .. } => e.is_vector(),
            Kind::Binary(Operator::Add | Operator::Subtract | Operator::Times, a, b) => a.is_vector() || b.is_vector(),
            Kind::Binary(Operator::Dot, a, b) => a.is_vector() != b.is_vector(),
            Kind::Binary(Operator::Divide, a, _) => a.is_vector(),
            Kind::Binary(Operator::Cross | Operator::Outer, ..) | Kind::Tuple(_) => true,
            Kind::Cases(rows) => rows.first().is_some_and(|(value, _)| value.is_vector()),
            Kind::Partial(of, by) => of.is_vector() || by.bold,
            Kind::Number(_) | Kind::Call(..) | Kind::Power(..) | Kind::Size(_) | Kind::Item(..) => false,
        }
    }

    /// Replaces every symbol and function for which `put` returns a replacement.
    pub(super) fn replaced(&self, put: &dyn Fn(&Expr) -> Option<Self>) -> Self {
        if let Some(other) = put(self) {
            return other;
        }
        let boxed = |e: &Expr| Box::new(e.replaced(put));
        let all = |list: &[Expr]| list.iter().map(|e| e.replaced(put)).collect();
        let kind = match &self.kind {
            Kind::Apply(name, arguments) => Kind::Apply(name.clone(), all(arguments)),
            Kind::Call(function, arguments) => Kind::Call(*function, all(arguments)),
            Kind::Tuple(items) => Kind::Tuple(all(items)),
            Kind::Negative(e) => Kind::Negative(boxed(e)),
            Kind::Size(e) => Kind::Size(boxed(e)),
            Kind::Item(e, k) => Kind::Item(boxed(e), *k),
            Kind::Partial(of, by) => Kind::Partial(boxed(of), by.clone()),
            Kind::Binary(operator, a, b) => Kind::Binary(*operator, boxed(a), boxed(b)),
            Kind::Power(a, b) => Kind::Power(boxed(a), boxed(b)),
            Kind::Sum { index, from, to, body } => {
                Kind::Sum { index: index.clone(), from: *from, to: *to, body: boxed(body) }
            }
            Kind::Cases(rows) => {
                let condition =
                    |all: &Condition| all.iter().map(|(a, r, b)| (a.replaced(put), *r, b.replaced(put))).collect();
                Kind::Cases(rows.iter().map(|(e, c)| (e.replaced(put), condition(c))).collect())
            }
            Kind::Number(_) | Kind::Symbol(_) => self.kind.clone(),
        };
        Self { kind, at: self.at }
    }

    /// Its direct subexpressions.
    pub(super) fn parts(&self) -> Vec<&Expr> {
        match &self.kind {
            Kind::Number(_) | Kind::Symbol(_) => Vec::new(),
            Kind::Apply(_, all) | Kind::Call(_, all) | Kind::Tuple(all) => all.iter().collect(),
            Kind::Negative(e) | Kind::Size(e) | Kind::Item(e, _) | Kind::Partial(e, _) | Kind::Sum { body: e, .. } => {
                vec![e]
            }
            Kind::Binary(_, a, b) | Kind::Power(a, b) => vec![a, b],
            Kind::Cases(rows) => {
                let mut all = Vec::new();
                for (value, condition) in rows {
                    all.push(value);
                    all.extend(condition.iter().flat_map(|(a, _, b)| [a, b]));
                }
                all
            }
        }
    }

    /// The expression with an index replaced by a number, in subscripts and as a symbol.
    pub(super) fn with_index(&self, index: &str, value: usize) -> Self {
        let put = |e: &Expr| e.with_index(index, value);
        let boxed = |e: &Expr| Box::new(put(e));
        let all = |list: &[Expr]| list.iter().map(put).collect();
        let kind = match &self.kind {
            Kind::Symbol(name) if name.is_letter(index) => Kind::Number(small(value)),
            Kind::Symbol(name) => Kind::Symbol(name.with_index(index, value)),
            Kind::Apply(name, arguments) => Kind::Apply(name.with_index(index, value), all(arguments)),
            Kind::Call(function, arguments) => Kind::Call(*function, all(arguments)),
            Kind::Tuple(items) => Kind::Tuple(all(items)),
            Kind::Negative(e) => Kind::Negative(boxed(e)),
            Kind::Size(e) => Kind::Size(boxed(e)),
            Kind::Item(e, k) => Kind::Item(boxed(e), *k),
            Kind::Partial(of, by) => Kind::Partial(boxed(of), by.with_index(index, value)),
            Kind::Binary(operator, a, b) => Kind::Binary(*operator, boxed(a), boxed(b)),
            Kind::Power(a, b) => Kind::Power(boxed(a), boxed(b)),
            Kind::Sum { index: own, from, to, body } if own != index => {
                Kind::Sum { index: own.clone(), from: *from, to: *to, body: boxed(body) }
            }
            Kind::Cases(rows) => {
                let condition = |all: &Condition| all.iter().map(|(a, r, b)| (put(a), *r, put(b))).collect();
                Kind::Cases(rows.iter().map(|(e, c)| (put(e), condition(c))).collect())
            }
            same => same.clone(),
        };
        Self { kind, at: self.at }
    }
}

/// An operation on two expressions.
pub(super) fn binary(operator: Operator, left: Expr, right: Expr, at: usize) -> Expr {
    Expr { kind: Kind::Binary(operator, Box::new(left), Box::new(right)), at }
}

/// A small number as a double.
pub(super) fn small(value: usize) -> f64 {
    u32::try_from(value).map_or(f64::NAN, f64::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::equation::latex;
    use crate::toolkit::equation::statement::{chains, statements};

    fn read(latex: &str) -> Vec<Statement> {
        statements(latex, vec![Name::letter("f")]).expect("it can be read")
    }

    /// The only side of the definition of a.
    fn side(latex: &str) -> Expr {
        read(&format!("a = {latex}"))[0].expressions()[0].clone()
    }

    /// One expression of each kind, with z in every position.
    const KINDS: &[&str] = &[
        "z",
        "f(b, z)",
        r"\operatorname{atan2}(z, z)",
        r"\sin z",
        "(z, b, z)",
        "-z",
        r"\lvert z\rvert",
        "z + z",
        r"z\cdot z",
        "z^{z}",
        r"\frac{\partial z}{\partial b}",
        r"\sum_{k=1}^{3} z",
        r"\begin{cases} z & z < b,\ b < z \\ b & c > z \\ z & \text{otherwise} \end{cases}",
    ];

    #[test]
    fn an_index_in_any_place_makes_a_family() {
        let count = |latex: &str| match chains(&format!(r"{latex},\quad q = 1, 2"), vec![Name::letter("f")]) {
            Ok(all) => all.len(),
            Err(_) => 0,
        };
        // On either side or in the middle, in the name of a function, in the denominator of a partial derivative.
        for one in ["a_q = 0", "0 = a_q", "0 = a_q = b", "0 = f_q(a)", "0 = f(a, b_q)"] {
            assert_eq!(count(one), 2, "{one}");
        }
        assert_eq!(count(r"0 = \frac{\partial a}{\partial b_q}"), 2);
        for kind in KINDS {
            assert_eq!([count(&format!("0 = {}", kind.replace('z', "b_q"))), count(&format!("0 = {kind}"))], [2, 0]);
        }
        // A sum over the same letter has its own index; another may appear next to it.
        let sum = r"0 = \sum_{q=1}^{3} a_q";
        assert_eq!([count(sum), count(&format!("{sum} + b_q"))], [0, 2]);
        // Statements without the index stay as they are.
        assert_eq!(count(r"a = 0,\ a_q = 1"), 3);
    }

    #[test]
    fn a_number_stands_in_every_place_of_an_index() {
        let same = |a: &Expr, b: &Expr| assert_eq!(format!("{a:?}"), format!("{b:?}"));
        for kind in KINDS {
            same(&side(&kind.replace('z', "c_q")).with_index("q", 2), &side(&kind.replace('z', "c_2")));
        }
        // As a symbol of its own it becomes a number. Kinds where a number would not parse, after a sine or as the
        // name of a symbol, are omitted.
        for kind in KINDS.iter().filter(|kind| !kind.contains("sin") && !kind.contains("partial")) {
            same(&side(&kind.replace('z', "q")).with_index("q", 2), &side(&kind.replace('z', "2")));
        }
        same(&side(r"\frac{\partial a}{\partial b_q}").with_index("q", 3), &side(r"\frac{\partial a}{\partial b_3}"));
        let own = side(r"\sum_{q=1}^{3} a_q");
        same(&own.with_index("q", 2), &own);
        let statement = |latex: &str| statements(latex, Vec::new()).unwrap().swap_remove(0);
        let functions = ["f_q(g) = f_q(a)", "f_2(g) = f_2(a)"].map(statement);
        same(&functions[0].expressions()[0].with_index("q", 2), functions[1].expressions()[0]);
        assert_eq!(small(7), 7.0);
    }

    #[test]
    fn a_family_is_written_out() {
        let written = |latex: &str| read(latex).iter().map(latex::statement).collect::<Vec<_>>();
        assert_eq!(written(r"a_q = b_q = c,\quad q = 2, 5"), ["a_{2} = b_{2} = c", "a_{5} = b_{5} = c"]);
        assert_eq!(
            written(r"a_q = \operatorname*{arg\,min}_{b_q \le a_q \le c_q} d_q,\quad q = 1, 2"),
            [1, 2].map(|q| r"a_{q} = \operatorname*{arg\,min}_{b_{q} \le a_{q} \le c_{q}}\,d_{q}"
                .replace("{q}", &format!("{{{q}}}")))
        );
        let items = read(r"(a_q, b_q) = f(c_q),\quad q = 1, 2");
        let of = |k: usize| format!("{:?}", items[k].expressions()[0].kind);
        assert!(of(0).starts_with("Item(") && of(0).ends_with(", 0)") && of(1).ends_with(", 1)"), "{}", of(1));
        assert!(items.len() == 4 && of(3).contains(r#"["2"]"#) && !of(3).contains(r#"["q"]"#), "{}", of(3));
    }

    #[test]
    fn symbols_are_replaced_in_every_place() {
        let put = |e: &Expr| match &e.kind {
            Kind::Symbol(name) if *name == Name::letter("z") => {
                Some(Expr { kind: Kind::Symbol(Name::letter("u")), at: e.at })
            }
            _ => None,
        };
        for kind in KINDS {
            assert_eq!(format!("{:?}", side(kind).replaced(&put)), format!("{:?}", side(&kind.replace('z', "u"))));
        }
        let item = Expr { kind: Kind::Item(Box::new(side("z")), 1), at: 0 };
        let Kind::Item(inside, 1) = item.replaced(&put).kind else { panic!("it is the same item") };
        assert_eq!(format!("{inside:?}"), format!("{:?}", side("u")));
    }

    #[test]
    fn a_vector_is_told_by_its_letters() {
        for vector in [
            r"\mathbf{v}",
            r"-\mathbf{v}",
            r"\mathbf{v} + b",
            r"b - \mathbf{v}",
            r"b\,\mathbf{v}",
            r"\mathbf{v}\,b",
            r"b\cdot\mathbf{v}",
            r"\mathbf{v}\cdot b",
            r"\frac{\mathbf{v}}{b}",
            r"b\times c",
            r"b\otimes c",
            "(b, c)",
            r"\sum_{k=1}^{2} \mathbf{v}_k",
            r"\begin{cases} \mathbf{v} & b > 0 \end{cases}",
            r"\frac{\partial\mathbf{v}}{\partial b}",
            r"\frac{\partial b}{\partial\mathbf{v}}",
        ] {
            assert!(side(vector).is_vector(), "{vector}");
        }
        for number in [
            "2",
            "b",
            "-b",
            "b + c",
            r"b\,c",
            r"b\cdot c",
            r"\mathbf{v}\cdot\mathbf{w}",
            r"\frac{b}{c}",
            r"\frac{b}{\mathbf{v}}",
            r"\sum_{k=1}^{2} b_k",
            r"\lvert\mathbf{v}\rvert",
            r"\sqrt{b}",
            "b^2",
            r"\begin{cases} b & \mathbf{v} = \mathbf{0} \end{cases}",
            r"\frac{\partial b}{\partial c}",
        ] {
            assert!(!side(number).is_vector(), "{number}");
        }
        let function = statements(r"\mathbf{r}(g) = g\,\mathbf{v},\quad a = \mathbf{r}(b)", Vec::new()).unwrap();
        assert!(function[1].expressions()[0].is_vector());
    }
}
