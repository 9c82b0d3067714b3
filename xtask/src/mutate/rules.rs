//! The rules by which faults are made: an operator for another, a sign lost, a number changed, a condition turned round, a
//! call left out, a function that does nothing.

use super::fault::{Place, Shape};
use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{BinOp, Block, Expr, ExprLit, Lit, ReturnType, Stmt, UnOp};

/// Methods that are taken for each other.
const METHODS: [(&str, &str); 6] =
    [("min", "max"), ("any", "all"), ("sin", "cos"), ("first", "last"), ("floor", "ceil"), ("is_some", "is_none")];
/// Methods that are forgotten.
const FORGOTTEN: [&str; 4] = ["rev", "abs", "recip", "sqrt"];

/// A fault made by rule.
pub(super) struct Made {
    /// Where it begins: line and column, from 1.
    pub(super) at: (usize, usize),
    pub(super) was: String,
    pub(super) becomes: String,
    pub(super) place: Place,
}

/// The faults made of a source.
pub(super) struct Rules<'a> {
    text: &'a str,
    pub(super) made: Vec<Made>,
}

impl<'a> Rules<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, made: Vec::new() }
    }

    fn text(&self, span: Span) -> &'a str {
        &self.text[span.byte_range()]
    }

    /// A fault at `at`, which changes the part `span`.
    fn make(&mut self, at: Span, span: Span, shape: Shape, [was, becomes, text]: [&str; 3]) {
        let start = at.start();
        self.made.push(Made {
            at: (start.line, start.column + 1),
            was: was.to_owned(),
            becomes: becomes.to_owned(),
            place: Place { range: span.byte_range(), text: text.to_owned(), shape },
        });
    }

    /// The faults of an expression itself, not of what it consists of.
    pub(super) fn of_expression(&mut self, expr: &Expr, shape: Shape) {
        match expr {
            Expr::Binary(binary) => {
                let (left, right) = (self.text(binary.left.span()), self.text(binary.right.span()));
                let was = self.text(binary.op.span());
                if let Some(other) = other(&binary.op) {
                    self.make(binary.op.span(), expr.span(), shape, [was, other, &format!("{left} {other} {right}")]);
                }
            }
            Expr::Unary(unary) if !matches!(unary.op, UnOp::Deref(_)) => {
                let (was, operand) = (self.text(expr.span()), self.text(unary.expr.span()));
                self.make(unary.op.span(), expr.span(), shape, [was, operand, operand]);
            }
            Expr::Lit(literal) => {
                if let Some(other) = another(literal) {
                    self.make(expr.span(), expr.span(), shape, [self.text(expr.span()), &other, &other]);
                }
            }
            Expr::If(branch) => self.of_condition(&branch.cond),
            Expr::While(repeated) => self.of_condition(&repeated.cond),
            Expr::MethodCall(call) => self.of_method(call, shape),
            _ => {}
        }
    }

    /// Conditions that are no comparison: those are dealt with where they stand.
    fn of_condition(&mut self, condition: &Expr) {
        if !has_let(condition) && !matches!(condition, Expr::Binary(_) | Expr::Unary(_) | Expr::Lit(_)) {
            let was = self.text(condition.span());
            let negated = format!("!({was})");
            self.make(condition.span(), condition.span(), Shape::Expression, [was, &negated, &negated]);
        }
    }

    fn of_method(&mut self, call: &syn::ExprMethodCall, shape: Shape) {
        let name = call.method.to_string();
        let receiver = self.text(call.receiver.span());
        let pairs = METHODS.iter().flat_map(|&(one, other)| [(one, other), (other, one)]);
        for (_, other) in pairs.filter(|(one, _)| *one == name) {
            let arguments =
                &self.text(call.span())[call.method.span().byte_range().end - call.span().byte_range().start..];
            let text = format!("{receiver}.{other}{arguments}");
            self.make(call.method.span(), call.span(), shape, [&name, other, &text]);
        }
        if FORGOTTEN.contains(&name.as_str()) && call.args.is_empty() {
            self.make(call.method.span(), call.span(), shape, [self.text(call.span()), receiver, receiver]);
        }
    }

    /// A call whose value is not used is left out. A hint to the compiler says nothing else, and how far a bar of progress is goes
    /// to terminals alone.
    pub(super) fn of_statement(&mut self, expr: &Expr) {
        let text = self.text(expr.span());
        let is_unseen = text.ends_with("cold_path()") || text.starts_with("bar.") || text.starts_with("self.bar.");
        if matches!(expr, Expr::Call(_) | Expr::MethodCall(_)) && !is_unseen {
            self.make(expr.span(), expr.span(), Shape::Statement, [text, "", ""]);
        }
    }

    /// A function that says the same whatever it is asked.
    pub(super) fn of_body(&mut self, output: &ReturnType, body: &Block) {
        let ReturnType::Type(_, kind) = output else { return };
        let said: String = self.text(kind.span()).split_whitespace().collect();
        let instead: &[&str] = match said.as_str() {
            "bool" => &["true", "false"],
            "usize" | "u64" | "u32" => &["0"],
            "f64" => &["0.0"],
            "String" => &["String::new()"],
            said if said.contains("Result<()") => &["Ok(())"],
            said if said.starts_with("Option<") => &["None"],
            said if said.starts_with("Vec<") => &["Vec::new()"],
            _ => return,
        };
        // A body that is one word is what it is.
        let is_word = matches!(body.stmts.as_slice(), [Stmt::Expr(Expr::Lit(_) | Expr::Path(_), None)]);
        let was = self.text(body.span());
        let is_it = |text: &str| was.trim_matches(['{', '}']).trim() == text;
        for (text, at) in instead.iter().zip([body.brace_token.span.open(), body.brace_token.span.close()]) {
            if !is_word && !is_it(text) {
                self.make(at, body.span(), Shape::Body, [was, text, text]);
            }
        }
    }
}

/// What is taken for an operator.
fn other(op: &BinOp) -> Option<&'static str> {
    Some(match op {
        BinOp::Add(_) => "-",
        BinOp::Sub(_) => "+",
        BinOp::Mul(_) | BinOp::Rem(_) => "/",
        BinOp::Div(_) => "*",
        BinOp::And(_) => "||",
        BinOp::Or(_) => "&&",
        BinOp::Lt(_) => "<=",
        BinOp::Le(_) => "<",
        BinOp::Gt(_) => ">=",
        BinOp::Ge(_) => ">",
        BinOp::Eq(_) => "!=",
        BinOp::Ne(_) => "==",
        BinOp::BitAnd(_) => "|",
        BinOp::BitOr(_) => "&",
        BinOp::Shl(_) => ">>",
        BinOp::Shr(_) => "<<",
        BinOp::AddAssign(_) => "-=",
        BinOp::SubAssign(_) => "+=",
        BinOp::MulAssign(_) => "/=",
        BinOp::DivAssign(_) => "*=",
        _ => return None,
    })
}

/// Another number or truth value. Where powers of ten stand, a tolerance is meant: one a little larger is none that is wrong.
fn another(literal: &ExprLit) -> Option<String> {
    match &literal.lit {
        Lit::Bool(bool) => Some((!bool.value).to_string()),
        Lit::Int(int) => Some(format!("{}{}", int.base10_parse::<u64>().ok()?.checked_add(1)?, int.suffix())),
        Lit::Float(float) if !float.base10_digits().contains(['e', 'E']) => {
            let value: f64 = float.base10_parse().ok()?;
            Some(format!("{:?}{}", value + 1.0, float.suffix()))
        }
        _ => None,
    }
}

/// Whether it binds names for what stands behind it.
pub(super) fn has_let(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use crate::mutate::sites::Sites;

    fn made(text: &str) -> Vec<String> {
        let made = Sites::read(text).unwrap().rules.made;
        made.iter().map(|made| format!("{} → {}", made.was, made.becomes)).collect()
    }

    #[test]
    fn a_function_says_what_its_type_allows_unless_it_says_no_other_thing() {
        let instead = |output: &str| {
            let made = made(&format!("fn f(x: A) -> {output} {{ g(x) }}"));
            made.into_iter().map(|change| change.replace("{ g(x) } → ", "")).collect::<Vec<_>>().join(", ")
        };
        for (output, expected) in [
            ("bool", "true, false"),
            ("usize", "0"),
            ("u64", "0"),
            ("u32", "0"),
            ("f64", "0.0"),
            ("String", "String::new()"),
            ("anyhow::Result<()>", "Ok(())"),
            ("Result<(), Error>", "Ok(())"),
            ("Option<A>", "None"),
            ("Vec < A >", "Vec::new()"),
            ("A", ""),
            ("i32", ""),
        ] {
            assert_eq!(instead(output), expected, "{output}");
        }
        for word in
            ["fn f() -> bool { x }", "fn f() -> Vec<A> { Vec::new() }", "fn f() -> Option<A> { None }", "fn f() {}"]
        {
            assert_eq!(made(word), [""; 0], "{word}");
        }
    }

    #[test]
    fn a_condition_is_turned_round_where_it_is_neither_compared_nor_bound() {
        assert_eq!(made("fn f(x: A) -> A { while g(x) {} y }"), ["g(x) → !(g(x))"]);
        assert_eq!(made("fn f(x: A) -> A { while x < y {} y }"), ["< → <="]);
        assert_eq!(made("fn f(x: A) -> A { if let Some(y) = x { y } else { x } }"), [""; 0]);
        assert_eq!(made("fn f(x: A) -> A { if let Some(y) = x && g(y) { y } else { x } }"), [""; 0]);
        assert_eq!(made("fn f(x: A) -> A { if !x { y } else { x } }"), ["!x → x"]);
    }

    #[test]
    fn methods_are_taken_for_others_and_forgotten_where_they_have_no_arguments() {
        assert_eq!(made("fn f(x: A) -> A { x.min(y) }"), ["min → max"]);
        assert_eq!(made("fn f(x: A) -> A { x.last() }"), ["last → first"]);
        assert_eq!(made("fn f(x: A) -> A { x.sqrt() }"), ["x.sqrt() → x"]);
        assert_eq!(made("fn f(x: A) -> A { x.sqrt(y) }"), [""; 0]);
        let sites = Sites::read("fn f(x: A) -> A { x.min::<B>(y) }").unwrap();
        assert_eq!(sites.rules.made[0].place.text, "x.max::<B>(y)");
    }

    #[test]
    fn calls_are_left_out_but_hints_and_bars() {
        assert_eq!(made("fn f() { g(x); y.h(); }"), ["g(x) → ", "y.h() → "]);
        assert_eq!(made("fn f() { cold_path(); bar.inc(x); self.bar.inc(x); x.bar.inc(x); }"), ["x.bar.inc(x) → "]);
        assert_eq!(made("fn f() { x; y?; }"), [""; 0]);
    }

    #[test]
    fn numbers_are_one_larger_but_not_powers_of_ten() {
        assert_eq!(
            made("fn f() -> A { [7, 8_usize, 0.5, 2.0_f32, 1e-9, 'a'] }"),
            ["7 → 8", "8_usize → 9usize", "0.5 → 1.5", "2.0_f32 → 3.0f32"]
        );
    }
}
