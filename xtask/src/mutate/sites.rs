//! Where in a source a fault can be planted, and the faults that are made by rule.

use super::fault::Shape;
use super::rules::{Rules, has_let};
use anyhow::Context;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Block, Expr, Item, Stmt};

/// What was found in a source.
pub(super) struct Sites<'a> {
    /// Every part that can be there twice.
    pub(super) places: Vec<(Range<usize>, Shape)>,
    /// Faults made by rule.
    pub(super) rules: Rules<'a>,
}

impl<'a> Sites<'a> {
    /// Reads a source. Tests and what the compiler computes itself are left out.
    ///
    /// # Errors
    /// That it is not Rust.
    pub(super) fn read(text: &'a str) -> anyhow::Result<Self> {
        let file = syn::parse_file(text).context("this cannot be read")?;
        let mut sites = Self { places: Vec::new(), rules: Rules::new(text) };
        sites.visit_file(&file);
        Ok(sites)
    }

    fn expression(&mut self, expr: &Expr, shape: Shape) {
        if !is_place(expr) && !has_let(expr) {
            self.places.push((expr.span().byte_range(), shape));
        }
        if !has_let(expr) {
            self.rules.of_expression(expr, shape);
        }
        visit::visit_expr(self, expr);
    }

    fn function(&mut self, attributes: &[Attribute], signature: &syn::Signature, body: &Block) {
        if signature.constness.is_some() || is_elsewhere(attributes) {
            return;
        }
        self.places.push((body.span().byte_range(), Shape::Body));
        // How a value is shown to a person who debugs is no claim.
        if signature.ident != "fmt" {
            self.rules.of_body(&signature.output, body);
            self.visit_block(body);
        }
    }
}

impl<'ast> Visit<'ast> for Sites<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Const(_) | Item::Static(_) | Item::Enum(_) | Item::Struct(_) | Item::Type(_) | Item::Macro(_) => {}
            Item::Fn(function) => self.function(&function.attrs, &function.sig, &function.block),
            Item::Mod(module) if is_elsewhere(&module.attrs) => {}
            Item::Impl(implementation) if is_elsewhere(&implementation.attrs) => {}
            item => visit::visit_item(self, item),
        }
    }

    fn visit_impl_item(&mut self, item: &'ast syn::ImplItem) {
        if let syn::ImplItem::Fn(function) = item {
            self.function(&function.attrs, &function.sig, &function.block);
        }
    }

    fn visit_trait_item(&mut self, item: &'ast syn::TraitItem) {
        if let syn::TraitItem::Fn(function) = item
            && let Some(body) = &function.default
        {
            self.function(&function.attrs, &function.sig, body);
        }
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        self.expression(expr, Shape::Expression);
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        match statement {
            Stmt::Expr(expr, None) => self.expression(expr, Shape::Bare),
            Stmt::Expr(expr, Some(_)) => {
                self.rules.of_statement(expr);
                self.expression(expr, Shape::Expression);
            }
            statement => visit::visit_stmt(self, statement),
        }
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        if let Some((_, guard)) = &arm.guard {
            self.visit_expr(guard);
        }
        self.expression(&arm.body, Shape::Bare);
    }

    fn visit_expr_if(&mut self, branch: &'ast syn::ExprIf) {
        self.visit_expr(&branch.cond);
        self.visit_block(&branch.then_branch);
        // Behind `else` stands a block or an `if`, and nothing else can.
        if let Some((_, otherwise)) = &branch.else_branch {
            self.rules.of_expression(otherwise, Shape::Expression);
            visit::visit_expr(self, otherwise);
        }
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        if let Some(init) = &local.init {
            self.visit_expr(&init.expr);
            if let Some((_, otherwise)) = &init.diverge {
                visit::visit_expr(self, otherwise);
            }
        }
    }

    fn visit_expr_closure(&mut self, closure: &'ast syn::ExprClosure) {
        match (&closure.output, &*closure.body) {
            // Where a type is given a block must stand.
            (syn::ReturnType::Type(..), body) => visit::visit_expr(self, body),
            (syn::ReturnType::Default, body) => self.visit_expr(body),
        }
    }

    fn visit_expr_repeat(&mut self, repeat: &'ast syn::ExprRepeat) {
        self.visit_expr(&repeat.expr);
    }

    // What the compiler computes itself has no switch.
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_generic_argument(&mut self, _: &'ast syn::GenericArgument) {}
    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
}

/// Whether it names a place, which a value cannot stand for.
fn is_place(expr: &Expr) -> bool {
    match expr {
        Expr::Path(_) | Expr::Field(_) | Expr::Index(_) | Expr::Infer(_) => true,
        Expr::Unary(unary) => matches!(unary.op, syn::UnOp::Deref(_)),
        Expr::Paren(inner) => is_place(&inner.expr),
        _ => false,
    }
}

/// Whether what has these attributes is there only for tests, or on another system.
fn is_elsewhere(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let path = attribute.path();
        let condition = || {
            let wanted = attribute.parse_args::<proc_macro2::TokenStream>().map(|tokens| tokens.to_string());
            wanted.is_ok_and(|wanted| matches!(wanted.as_str(), "test" | "doctest" | "not (unix)"))
        };
        path.is_ident("test") || (path.is_ident("cfg") && condition())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(text: &str) -> Vec<String> {
        let made = Sites::read(text).unwrap().rules.made;
        let mut made: Vec<_> = made.iter().map(|made| (made.at, format!("{} → {}", made.was, made.becomes))).collect();
        made.sort();
        made.into_iter().map(|(_, change)| change).collect()
    }

    #[test]
    fn faults_are_made_wherever_code_can_stand() {
        assert_eq!(made("fn f(x: A) -> A { match x { _ if x > y => z, _ => w } }"), ["> → >="]);
        assert_eq!(made("fn f(x: A) -> A { [x + y; 3] }"), ["+ → -"]);
        assert_eq!(made("fn f(x: A) -> A { |y| -> A { x + y } }"), ["+ → -"]);
        assert_eq!(made("fn f(x: A) -> A { |y| x * y }"), ["* → /"]);
        assert_eq!(made("fn f(x: A) -> A { let y: [A; 2] = g::<4>(x)[5]; y }"), ["5 → 6"]);
        assert_eq!(made("fn f(x: A) { x[1] = 2; x.y += 3; }"), ["1 → 2", "2 → 3", "+= → -=", "3 → 4"]);
        assert_eq!(made("fn f(x: A) -> A { let Some(y) = x else { return -x }; y }"), ["-x → x"]);
        assert_eq!(made("const X: A = 1 + 2; fn f(x: A) -> A { const { 3 + 4 } }"), [""; 0]);
    }

    /// What is not shown to a person who debugs is a claim.
    #[test]
    fn how_a_value_is_shown_has_no_faults() {
        assert_eq!(made("impl Debug for A { fn fmt(&self) -> u32 { 1 + 2 } fn other(&self) -> A { 3 } }"), ["3 → 4"]);
    }
}
