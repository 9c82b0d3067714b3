//! The JavaScript of a formula as a classic script, since browsers do not load modules from `file://`.

use super::check::{entry, is_near};
use super::javascript::{EPSILONS, JavaScript, RUNTIME, module};
use super::program::functions_within;
use super::recorded::{Recorded, Subject, record};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::graph::NotRecorded;

/// A formula in printed form.
pub(crate) struct Script(Recorded);

/// The script of a formula.
///
/// # Errors
/// The reason why it cannot be recorded.
pub(crate) fn script(formula: &'static dyn AnyFormula) -> Result<Script, NotRecorded> {
    let (recorded, refused) = record(&[Subject::Formula(formula)], None);
    let why = |(_, why): (_, NotRecorded)| why;
    recorded
        .into_iter()
        .next()
        .map(Script)
        .ok_or_else(|| refused.into_iter().next().map(why).expect("a formula is recorded or not"))
}

impl Script {
    /// A function that takes the runtime and returns the exports of the module: the text of the module in one part,
    /// without module syntax, and without the function for the value, which that for the Jacobian computes too.
    pub(crate) fn text(&self) -> String {
        let module = module(&self.0, functions_within(usize::MAX, &JavaScript, &self.0));
        let (head, rest) = module.split_once("\nexport function value").expect("a module has a function for the value");
        let largest = rest.split_once("\nexport function jacobian").map_or(rest, |(_, jacobian)| jacobian);
        let (before, import) = head.split_once("import ").expect("a module imports the runtime");
        let (imported, import) = import.split_once(" from ").expect("it is imported from a file");
        let (_, after) = import.split_once(";\n").expect("an import ends");
        let body = classic(&format!("{before}{after}\nfunction compute{largest}"));
        format!(
            "({imported}) => {{\n{body}\nreturn {{ inputs, outputs, required, value: compute, isClosed: {} }};\n}}",
            self.0.subject.spec().is_closed()
        )
    }

    /// Whether a number agrees with Rust's within the tolerance for functions of the language.
    pub(crate) fn is_near(&self, found: f64, expected: f64) -> bool {
        is_near(&self.0, EPSILONS, [found, expected], expected.abs())
    }

    /// The name of a component of the value, or, after these, of an entry of the Jacobian.
    pub(crate) fn entry(&self, k: usize) -> String {
        entry(&self.0, k)
    }
}

/// The runtime of formulas and of input checks, as a function without arguments that returns all of it.
pub(crate) fn runtime_script() -> String {
    let exported = RUNTIME.lines().filter_map(|line| line.strip_prefix("export "));
    let name = |line: &'static str| line.split([' ', '(']).nth(1);
    let names: Vec<_> = exported.filter_map(name).collect();
    format!("() => {{\n{}\nreturn {{ {} }};\n}}", classic(RUNTIME), names.join(", "))
}

/// A module's text without `export`.
fn classic(module: &str) -> String {
    let lines: Vec<_> = module.lines().map(|line| line.strip_prefix("export ").unwrap_or(line)).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_near_but_for_roundings() {
        let of = |id| script(jointproof::catalog::find(id).unwrap()).unwrap();
        let (exponential, products) = (of("interaction.pressure_exponential"), of("coulomb.yield"));
        assert!(exponential.is_near(1.5, 1.5_f64.next_up()) && !exponential.is_near(1.5, 1.501));
        assert!(!products.is_near(1.5, 1.5_f64.next_up()));
    }

    #[test]
    fn numbers_are_told_by_their_names() {
        let script = script(jointproof::catalog::find("slider.line").unwrap()).unwrap();
        assert_eq!([0, 3, 4, 27].map(|k| script.entry(k)), ["n[0]", "l", "∂n[0]/∂x1[0]", "∂l/∂xn[2]"]);
    }

    #[test]
    fn everything_that_is_exported_comes_back() {
        let script = runtime_script();
        let (_, given) = script.rsplit_once("return { ").unwrap();
        let names: Vec<_> = given.split_once(" }").unwrap().0.split(", ").collect();
        assert_eq!(names.len(), RUNTIME.matches("\nexport ").count());
        for name in names {
            assert!(
                script.contains(&format!("function {name}(")) || script.contains(&format!("const {name} =")),
                "{name}"
            );
        }
    }
}
