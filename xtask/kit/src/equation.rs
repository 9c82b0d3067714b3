//! `equation`: whether a reader's own LaTeX is the same function as a formula; without an argument, whether all
//! printed equations are.

use crate::console::{count, figure, green, print, red};
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use crate::prose;
use jointproof::formula::Field;
use jointproof::toolkit::equation::{Equation, Error, Reading, Signature};
use jointproof::toolkit::verify::{Claim, Deviation, Options};
use judge::components;
use judge::mathematics::as_text;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::time::Instant;

/// Compare your own equation with a formula; or check all equations of the book
///
/// Without an equation, every printed one is executed, value and Jacobian, and all mathematics and numbers of the
/// chapters are checked.
///
/// Your own equation is read as LaTeX or as plain text, with the symbols of the formula's entry, those that its equation
/// defines or takes from elsewhere, and the names of inputs and outputs; --let calls an input or output by another one. It is
/// evaluated in 237 bits at the formula's cases, on and beside its kinks, and at random points. Of several outputs those are
/// compared that it defines; a relation such as `\\tan\\alpha = …` holds or does not.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} equation  all that is printed
  {command} equation 'F = \\sqrt{a^2+b^2}' --against slot.contact_force --let a=f2 --let b=f3
  {command} equation 'fc = sqrt(f2^2 + f3^2)' --against slot.contact_force  as plain text
  {command} equation '\\Phi = P - \\mu F_N' --against coulomb.yield")]
pub(crate) struct Arguments {
    /// The equation, in LaTeX or as plain text
    #[arg(requires = "against", allow_hyphen_values = true)]
    latex: Option<String>,
    /// The formula, by its identifier
    #[arg(long, value_name = "ID", requires = "latex")]
    against: Option<String>,
    /// Use this symbol for an input or output of the formula
    #[arg(long = "let", value_name = "SYMBOL=NAME", value_parser = renaming, requires = "latex")]
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
    let options = Options { samples: arguments.samples, seed: arguments.seed };
    let (Some(latex), Some(against)) = (&arguments.latex, &arguments.against) else {
        return all(project, &options);
    };
    let formula = project.named("--against", against)?;
    let (signature, renamed) = (formula.signature(), &arguments.renamed);
    check_names(renamed, &signature)?;
    let renamed: Vec<_> = renamed.iter().map(|(symbol, name)| (symbol.as_str(), name.as_str())).collect();
    let reading = Reading::of(latex, &renamed, &signature).map_err(|error| {
        let (before, from) = latex.split_at_checked(error.at()).unwrap_or((latex, ""));
        Usage(format!("{error}\n  {before}{}{from}{}", red("▸"), instead(&error, &arguments.renamed, &signature)))
    })?;
    let (claim, compared) = match &reading {
        Reading::Function(equation) => (formula.trial(&options).compare(equation), compared(equation, &signature)),
        Reading::Relation(claims) => (formula.claims(claims, &options), Compared::Relation),
    };
    print(&text(against, &claim, &compared))?;
    Ok(verdict(claim.held()))
}

/// What an equation says about a formula.
enum Compared {
    /// All outputs.
    Function,
    /// Some of them.
    Outputs(Vec<String>),
    /// A relation between inputs and outputs.
    Relation,
}

fn compared(equation: &Equation, formula: &Signature) -> Compared {
    let (defined, all) = (equation.places(), components(formula.outputs));
    if defined.len() == all.len() {
        return Compared::Function;
    }
    Compared::Outputs(defined.iter().map(|&place| all[place].clone()).collect())
}

/// What may be meant by a symbol that is not known, and which there are; nothing for other errors.
fn instead(error: &Error, renamed: &[(String, String)], formula: &Signature) -> String {
    let Some(unknown) = error.symbol() else { return String::new() };
    let symbol = |field: &Field| {
        let other = renamed.iter().find(|(_, name)| name == field.name);
        other.map_or_else(|| field.quantity.latex.to_owned(), |(symbol, _)| symbol.clone())
    };
    let plain = |text: &str| -> String {
        let text = as_text(text).replace("(a vector)", "").to_lowercase();
        text.chars().filter(|c| c.is_alphanumeric()).collect()
    };
    let unknown = plain(unknown);
    let fields = || formula.inputs.iter().chain(formula.outputs);
    let distance = |field: &Field| {
        strsim::osa_distance(&plain(&symbol(field)), &unknown).min(strsim::osa_distance(field.name, &unknown))
    };
    let near = fields().min_by_key(|field| distance(field)).filter(|field| distance(field) <= 1 + unknown.len() / 4);
    let near = near.map_or_else(String::new, |field| format!("\n  did you mean `{}` ({})?", symbol(field), field.name));
    let listed = |fields: &[Field]| {
        fields.iter().map(|field| format!("`{}` ({})", symbol(field), field.name)).collect::<Vec<_>>().join(", ")
    };
    let (inputs, outputs) = (listed(formula.inputs), listed(formula.outputs));
    format!("{near}\n  inputs: {inputs}\n  outputs: {outputs}\n  another symbol for one of them: --let SYMBOL=NAME")
}

/// Executes every printed equation, and the claims in the chapters.
fn all(project: &Project, options: &Options) -> Outcome {
    let start = Instant::now();
    let (mut checks, mut off) = ([0; 2], Vec::new());
    let audited: Vec<_> =
        project.catalog().par_iter().map(|formula| (formula, formula.audit_equation(options))).collect();
    for (formula, claims) in &audited {
        for (checks, claim) in checks.iter_mut().zip(claims) {
            *checks += claim.checks;
        }
        off.extend(claims.iter().filter(|claim| !claim.held()).map(|claim| failed(formula.spec().id, claim)));
    }
    let (printed, chapters_from) = (start.elapsed(), Instant::now());
    let (faults, chapters) = prose::check(project)?;
    off.extend(faults.iter().map(|fault| format!("{} {fault}\n", red("off"))));
    let equations = count(project.catalog().len(), "equation");
    let [values, entries] = checks;
    let times = [printed, chapters_from.elapsed()].map(|time| format!("{:.2} s", time.as_secs_f64()));
    let mark = if off.is_empty() { green("ok ") } else { off.concat() };
    print(&format!(
        "{mark} {equations}: {} and {} compared in {}\n    chapters: {chapters} in {}\n",
        count(values, "value"),
        count(entries, "derivative"),
        times[0],
        times[1]
    ))?;
    Ok(verdict(off.is_empty()))
}

fn check_names(renamed: &[(String, String)], formula: &Signature) -> anyhow::Result<()> {
    let names: Vec<_> = formula.inputs.iter().chain(formula.outputs).map(|field| field.name).collect();
    match renamed.iter().find(|(_, name)| !names.contains(&name.as_str())) {
        Some((symbol, name)) => {
            Err(Usage(format!("--let {symbol}={name}: {name} is none of {}", names.join(", "))).into())
        }
        None => Ok(()),
    }
}

fn text(id: &str, claim: &Claim, compared: &Compared) -> String {
    if !claim.held() {
        return failed(id, claim);
    }
    let comparisons = count(claim.checks, "comparison");
    let what = match compared {
        Compared::Function => format!("the same function as {id}"),
        Compared::Outputs(names) => format!("{} as in {id}", names.join(", ")),
        Compared::Relation => format!("this holds for {id}"),
    };
    format!("{} {what}: {comparisons} in 237 bits\n", green("ok "))
}

/// The failure of a claim about a formula.
fn failed(id: &str, claim: &Claim) -> String {
    let compared = count(claim.checks, "comparison");
    let failures = format!("{} not {id}: {} of {compared} differ\n", red("off"), claim.failures);
    let worst = claim.worst.as_ref().map(|Deviation { size, entry, point, found, expected, inputs }| {
        let size = figure(*size);
        format!(
            "  most at {point}: {entry} is {expected:?}, the equation gives {found:?}, off by {size} of it\n  at {inputs}\n"
        )
    });
    failures + &worst.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::console::plain;

    #[test]
    fn what_was_compared_is_told_with_the_worst_of_it() {
        let audit = crate::sample::failed();
        let said = |claim: &Claim| plain(&text("t.second", claim, &Compared::Function));
        let differs = "off not t.second: 15 of 206 comparisons differ\n  \
            most at random 206 of seed 9: fc is 0.9955, the equation gives 1.0045, off by 4e-3 of it\n  \
            at {\"f2\":3.0045,\"f3\":4.0}\n";
        assert_eq!(said(&audit.equation_jacobian), differs);
        let holds = "ok  the same function as t.second: 105 comparisons in 237 bits\n";
        assert_eq!(said(&crate::sample::passed().equation), holds);
    }
}
