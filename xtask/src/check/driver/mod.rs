//! Programs that answer `check`, complete but for the call of the user's own code.

mod c;
mod fortran;
mod scripts;

use super::question::{Wanted, sizes};
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;

/// A language that a driver is printed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Lang {
    C,
    Cpp,
    Fortran,
    Python,
    Julia,
}

/// What a driver is for.
pub(super) struct Driver {
    formula: &'static dyn AnyFormula,
    /// Whether the Jacobian is answered, too.
    with_jacobian: bool,
    /// Whether it calls what `export` prints, as an example of what works.
    is_exported: bool,
}

impl Driver {
    /// Of a formula; `None` for products, which have no driver.
    pub(super) fn new(formula: &'static dyn AnyFormula, wanted: Wanted, is_exported: bool) -> Option<Self> {
        (wanted != Wanted::Products).then_some(Self { formula, with_jacobian: wanted == Wanted::Jacobian, is_exported })
    }

    /// The program; `None` where the formula is not exported to this language.
    pub(super) fn text(&self, lang: Lang) -> Option<String> {
        match lang {
            Lang::C => Some(c::text(self, false)),
            Lang::Cpp => Some(c::text(self, true)),
            Lang::Fortran => Some(fortran::text(self)),
            Lang::Python => Some(scripts::python(self)),
            Lang::Julia => (!self.is_exported).then(|| scripts::julia(self)),
        }
    }

    /// A text that only a driver with a Jacobian has.
    fn if_jacobian(&self, text: &'static str) -> &'static str {
        if self.with_jacobian { text } else { "" }
    }

    /// A line that only a driver of the exported formula has.
    fn exported_line(&self, line: impl Fn(&str) -> String) -> String {
        if self.is_exported { line(&self.stem()) } else { String::new() }
    }

    fn sizes(&self) -> [usize; 2] {
        sizes(self.formula)
    }

    fn stem(&self) -> String {
        self.formula.spec().id.replace('.', "_")
    }

    /// The name of the exported function.
    fn exported(&self) -> String {
        format!("jp_{}_{}", self.stem(), if self.with_jacobian { "jacobian" } else { "value" })
    }

    /// What stands at the head of a driver.
    fn head(&self) -> Vec<String> {
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

/// The fields, each with the place of its first component.
fn placed(fields: &'static [Field]) -> impl Iterator<Item = (&'static Field, usize)> {
    let mut next = 0;
    fields.iter().map(move |field| {
        let start = next;
        next += field.len();
        (field, start)
    })
}

/// Words that no name may be in any of these languages.
const RESERVED: [&str; 4] = ["lambda", "in", "real", "code"];

/// A field's name in a program.
fn name(field: &Field) -> String {
    if RESERVED.contains(&field.name) { format!("{}_", field.name) } else { field.name.to_owned() }
}
