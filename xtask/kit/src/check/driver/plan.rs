//! The parts of a driver that do not depend on its language.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use judge::{Wanted, sizes};

/// The specification of a driver.
pub(crate) struct Driver {
    pub(super) formula: &'static dyn AnyFormula,
    /// Whether the Jacobian is computed, too.
    pub(super) with_jacobian: bool,
    /// Whether it calls the exported code, as a working example.
    pub(super) is_exported: bool,
}

impl Driver {
    /// A driver for a formula; `None` for products, which have no driver.
    pub(crate) fn new(formula: &'static dyn AnyFormula, wanted: Wanted, is_exported: bool) -> Option<Self> {
        (wanted != Wanted::Products).then_some(Self { formula, with_jacobian: wanted == Wanted::Jacobian, is_exported })
    }

    /// A text that is only in drivers with a Jacobian.
    pub(super) fn if_jacobian(&self, text: &'static str) -> &'static str {
        if self.with_jacobian { text } else { "" }
    }

    /// A line that is only in drivers for exported code.
    pub(super) fn exported_line(&self, line: impl Fn(&str) -> String) -> String {
        if self.is_exported { line(&self.stem()) } else { String::new() }
    }

    pub(super) fn sizes(&self) -> [usize; 2] {
        sizes(self.formula)
    }

    pub(super) fn stem(&self) -> String {
        self.formula.spec().id.replace('.', "_")
    }

    /// The name of the exported function.
    pub(super) fn exported(&self) -> String {
        format!("jp_{}_{}", self.stem(), if self.with_jacobian { "jacobian" } else { "value" })
    }

    /// The comment at the head of a driver.
    pub(super) fn head(&self) -> Vec<String> {
        let (spec, wanted) = (self.formula.spec(), if self.with_jacobian { "" } else { " --wanted value" });
        let mut lines = vec![
            format!("Answers `jointproof check --formula {}{wanted} -- PROGRAM`: {}.", spec.id, spec.title),
            "Put your own code where `yours` is; everything else can stay.".into(),
            String::new(),
        ];
        let of = |role: &'static str, fields: &'static [Field]| fields.iter().map(move |field| described(role, field));
        lines.extend(of("in ", self.formula.inputs()).chain(of("out", self.formula.outputs())));
        lines
    }
}

fn described(role: &str, field: &Field) -> String {
    let shape = if field.len() == 1 { String::new() } else { format!("({})", field.len()) };
    format!("{role} {}{shape} [{}] {}", field.name, field.quantity.unit, field.quantity.meaning)
}

/// The fields, each with the index of its first component.
pub(super) fn placed(fields: &'static [Field]) -> impl Iterator<Item = (&'static Field, usize)> {
    let mut next = 0;
    fields.iter().map(move |field| {
        let start = next;
        next += field.len();
        (field, start)
    })
}

/// Words reserved in one of these languages.
const RESERVED: [&str; 4] = ["lambda", "in", "real", "code"];

/// A field's name in a program.
pub(super) fn name(field: &Field) -> String {
    if RESERVED.contains(&field.name) { format!("{}_", field.name) } else { field.name.to_owned() }
}
