//! `equation`: whether a reader's own LaTeX is the same function as a formula.

use crate::console::{count, figure, green, print, red};
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use jointproof::equation::Equation;
use jointproof::formula::Field;
use jointproof::verify::{Claim, Deviation, Options};

/// Compare an equation of your own, in LaTeX, with a formula
///
/// The equation is read with the symbols of the formula's entry; --let calls an input or output by another one. It is
/// evaluated in 237 bits at the formula's cases, on and beside its kinks, and at random points.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} equation 'F = \\sqrt{a^2+b^2}' --against slot.contact_force --let a=f2 --let b=f3
  {command} equation '\\Phi = P - \\mu F_N' --against coulomb.yield  with the entry's own symbols")]
pub(crate) struct Arguments {
    /// The equation, in LaTeX
    latex: String,
    /// The formula, by its identifier
    #[arg(long, value_name = "ID")]
    against: String,
    /// A symbol of the equation for an input or output of the formula
    #[arg(long = "let", value_name = "SYMBOL=NAME", value_parser = renaming)]
    renamed: Vec<(String, String)>,
    /// Random points
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
    /// Seed of the random points
    #[arg(long, value_name = "S", default_value_t = Options::default().seed)]
    seed: u64,
}

fn renaming(text: &str) -> Result<(String, String), String> {
    let (symbol, name) = text.rsplit_once('=').ok_or("a symbol, =, and the name of an input or output")?;
    Ok((symbol.trim().into(), name.trim().into()))
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    let formula = formula(project, &arguments.against)?;
    let (inputs, outputs) = (formula.inputs(), formula.outputs());
    check_names(&arguments.renamed, inputs, outputs)?;
    let renamed: Vec<_> = arguments.renamed.iter().map(|(symbol, name)| (symbol.as_str(), name.as_str())).collect();
    let equation = Equation::read(&arguments.latex, &renamed, inputs, outputs).map_err(|error| {
        let (before, from) = arguments.latex.split_at_checked(error.at()).unwrap_or((&arguments.latex, ""));
        Usage(format!("{error}\n  {before}{}{from}", red("▸")))
    })?;
    let options = Options { samples: arguments.samples, seed: arguments.seed };
    let claim = formula.trial(&options).compare(&equation);
    print(&text(&arguments.against, &claim))?;
    Ok(verdict(claim.held()))
}

fn formula(project: &Project, id: &str) -> anyhow::Result<&'static dyn AnyFormula> {
    let found = project.catalog().iter().copied().find(|formula| formula.spec().id == id);
    found.ok_or_else(|| {
        let ids: Vec<_> = project.catalog().iter().map(|formula| formula.spec().id).collect();
        Usage(format!("--against '{id}' is no formula; there are\n  {}", ids.join("\n  "))).into()
    })
}

fn check_names(renamed: &[(String, String)], inputs: &[Field], outputs: &[Field]) -> anyhow::Result<()> {
    let names: Vec<_> = inputs.iter().chain(outputs).map(|field| field.name).collect();
    match renamed.iter().find(|(_, name)| !names.contains(&name.as_str())) {
        Some((symbol, name)) => {
            Err(Usage(format!("--let {symbol}={name}: {name} is none of {}", names.join(", "))).into())
        }
        None => Ok(()),
    }
}

fn text(id: &str, claim: &Claim) -> String {
    let compared = count(claim.checks, "comparison");
    if claim.held() {
        return format!("{} the same function as {id}: {compared} in 237 bits\n", green("ok "));
    }
    let failures = format!("{} not {id}: {} of {compared} differ\n", red("off"), claim.failures);
    let worst = claim.worst.as_ref().map(|Deviation { size, entry, point, found, expected, inputs }| {
        let size = figure(*size);
        format!(
            "  most at {point}: {entry} is {expected:?}, the equation gives {found:?}, off by {size} of it\n  at {inputs}\n"
        )
    });
    failures + &worst.unwrap_or_default()
}
