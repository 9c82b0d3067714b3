//! The rules by which faults are made: an operator for another, a sign lost, a number changed, a condition turned round, a
//! call left out, a function that does nothing.

use super::fault::Shape;
use super::sites::{Sites, has_let};
use syn::spanned::Spanned;
use syn::{BinOp, Block, Expr, ExprLit, Lit, ReturnType, Stmt, UnOp};

/// Methods that are taken for each other.
const METHODS: [(&str, &str); 6] =
    [("min", "max"), ("any", "all"), ("sin", "cos"), ("first", "last"), ("floor", "ceil"), ("is_some", "is_none")];
/// Methods that are forgotten.
const FORGOTTEN: [&str; 4] = ["rev", "abs", "recip", "sqrt"];

/// The faults of an expression itself, not of what it consists of.
pub(super) fn of_expression(sites: &mut Sites, expr: &Expr, shape: Shape) {
    match expr {
        Expr::Binary(binary) => {
            let (left, right) = (sites.text(binary.left.span()), sites.text(binary.right.span()));
            let was = sites.text(binary.op.span());
            if let Some(other) = other(&binary.op) {
                sites.make(binary.op.span(), expr.span(), shape, [was, other, &format!("{left} {other} {right}")]);
            }
        }
        Expr::Unary(unary) if !matches!(unary.op, UnOp::Deref(_)) => {
            let (was, operand) = (sites.text(expr.span()), sites.text(unary.expr.span()));
            sites.make(unary.op.span(), expr.span(), shape, [was, operand, operand]);
        }
        Expr::Lit(literal) => {
            if let Some(other) = another(literal) {
                sites.make(expr.span(), expr.span(), shape, [sites.text(expr.span()), &other, &other]);
            }
        }
        Expr::If(branch) => of_condition(sites, &branch.cond),
        Expr::While(repeated) => of_condition(sites, &repeated.cond),
        Expr::MethodCall(call) => of_method(sites, call, shape),
        _ => {}
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

/// Conditions that are no comparison: those are dealt with where they stand.
fn of_condition(sites: &mut Sites, condition: &Expr) {
    if !has_let(condition) && !matches!(condition, Expr::Binary(_) | Expr::Unary(_) | Expr::Lit(_)) {
        let was = sites.text(condition.span());
        let negated = format!("!({was})");
        sites.make(condition.span(), condition.span(), Shape::Expression, [was, &negated, &negated]);
    }
}

fn of_method(sites: &mut Sites, call: &syn::ExprMethodCall, shape: Shape) {
    let name = call.method.to_string();
    let receiver = sites.text(call.receiver.span());
    let pairs = METHODS.iter().flat_map(|&(one, other)| [(one, other), (other, one)]);
    for (_, other) in pairs.filter(|(one, _)| *one == name) {
        let arguments =
            &sites.text(call.span())[call.method.span().byte_range().end - call.span().byte_range().start..];
        let text = format!("{receiver}.{other}{arguments}");
        sites.make(call.method.span(), call.span(), shape, [&name, other, &text]);
    }
    if FORGOTTEN.contains(&name.as_str()) && call.args.is_empty() {
        sites.make(call.method.span(), call.span(), shape, [sites.text(call.span()), receiver, receiver]);
    }
}

/// A call whose value is not used is left out.
pub(super) fn of_statement(sites: &mut Sites, expr: &Expr) {
    if matches!(expr, Expr::Call(_) | Expr::MethodCall(_)) {
        sites.make(expr.span(), expr.span(), Shape::Statement, [sites.text(expr.span()), "", ""]);
    }
}

/// A function that says the same whatever it is asked.
pub(super) fn of_body(sites: &mut Sites, output: &ReturnType, body: &Block) {
    let ReturnType::Type(_, kind) = output else { return };
    let said: String = sites.text(kind.span()).split_whitespace().collect();
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
    let was = sites.text(body.span());
    for (text, at) in instead.iter().zip([body.brace_token.span.open(), body.brace_token.span.close()]) {
        if !is_word {
            sites.make(at, body.span(), Shape::Body, [was, text, text]);
        }
    }
}
