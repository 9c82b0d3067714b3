//! The JavaScript of a formula as a classic script. Browsers load no modules from a file, and a book is read from files.

use super::check::{entry, is_near};
use super::javascript::{EPSILONS, JavaScript, RUNTIME};
use super::recorded::Recorded;
use jointproof::catalog::AnyFormula;
use jointproof::graph::NotRecorded;

/// A formula that is printed.
pub(crate) struct Script(Recorded);

/// The script of a formula.
///
/// # Errors
/// What in it cannot be written down.
pub(crate) fn script(formula: &'static dyn AnyFormula) -> Result<Script, NotRecorded> {
    Ok(Script(Recorded { formula, graph: formula.graph()? }))
}

impl Script {
    /// A function that takes the runtime and gives `inputs`, `outputs` and `jacobian`, which gives the value too: the text
    /// of the module without the words that only modules have, and without the function for the value alone.
    pub(crate) fn text(&self) -> String {
        let module = JavaScript.source(&self.0);
        let (head, rest) = module.split_once("\nexport function value").expect("a module has a function for the value");
        let (_, jacobian) = rest.split_once("\nexport function").expect("a module has a function for the Jacobian");
        let import = head.lines().find_map(|line| line.strip_prefix("import ")).unwrap_or_default();
        let imported = import.split_once(" from ").map_or("", |(names, _)| names);
        let body = classic(&format!("{head}\nfunction{jacobian}"));
        format!("({imported}) => {{\n{body}\nreturn {{ inputs, outputs, jacobian }};\n}}")
    }

    /// Whether a number is what Rust finds, but for what the functions of the language may differ by.
    pub(crate) fn is_near(&self, found: f64, expected: f64) -> bool {
        is_near(&self.0, EPSILONS, [found, expected])
    }

    /// The name of a component of the value, or behind these of an entry of the Jacobian.
    pub(crate) fn entry(&self, k: usize) -> String {
        entry(&self.0, k)
    }
}

/// What formulas call and what refuses inputs, as a function without arguments that gives all of it.
pub(crate) fn runtime_script() -> String {
    let exported = RUNTIME.lines().filter_map(|line| line.strip_prefix("export "));
    let name = |line: &'static str| line.split([' ', '(']).nth(1);
    let names: Vec<_> = exported.filter_map(name).collect();
    format!("() => {{\n{}\nreturn {{ {} }};\n}}", classic(RUNTIME), names.join(", "))
}

/// A module's text without `import` and `export`.
fn classic(module: &str) -> String {
    let lines = module.lines().filter(|line| !line.starts_with("import "));
    let lines: Vec<_> = lines.map(|line| line.strip_prefix("export ").unwrap_or(line)).collect();
    lines.join("\n")
}
