//! `formulas`: lists the formulas.

use crate::console::{bold, show};
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::prove;
use crate::selection::Selection;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use judge::mathematics::as_text;
use std::io::{IsTerminal, stdout};

/// List the formulas, or show them in full
///
/// Identifier and title, a line each; with --show also source, equation, inputs and outputs in order, bounds and kinks. On a
/// terminal equations are text and LaTeX; elsewhere they are LaTeX, as the command `equation` reads it.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} formulas                               all of them
  {command} formulas '{family}.*'         of a family
  {command} formulas --show {formula}     in full")]
pub(crate) struct Arguments {
    /// Only formulas whose identifier matches this pattern; `*` matches anything
    #[arg(value_name = "GLOB", conflicts_with = "filter")]
    id: Option<String>,
    #[command(flatten)]
    selection: Selection,
    /// Show all details
    #[arg(long)]
    show: bool,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    let formulas = match &arguments.id {
        Some(id) => Selection::of(id).formulas(project)?,
        None => arguments.selection.formulas(project)?,
    };
    let width = formulas.iter().map(|formula| formula.spec().id.len()).max().unwrap_or_default();
    let line = |formula: &&dyn AnyFormula| format!("{:width$}  {}\n", formula.spec().id, formula.spec().title);
    let mathematics: fn(&str) -> String = if stdout().is_terminal() { as_text } else { str::to_owned };
    let text: Vec<_> = if arguments.show {
        formulas.iter().map(|formula| shown(project, *formula, mathematics)).collect()
    } else {
        formulas.iter().map(line).collect()
    };
    show(&text.concat())?;
    Ok(verdict(true))
}

fn shown(project: &Project, formula: &dyn AnyFormula, mathematics: fn(&str) -> String) -> String {
    let spec = formula.spec();
    let mut text = format!("{}  {}\n    {}; {}\n", bold(spec.id), spec.title, spec.source, spec.source.provenance);
    let mut lines: Vec<_> = mathematics(spec.latex).lines().map(str::to_owned).collect();
    if lines != [spec.latex] {
        lines.push(format!("in LaTeX: {}", spec.latex));
    }
    lines.extend(formula.inputs().iter().map(|field| described("in", field)));
    lines.extend(formula.outputs().iter().map(|field| described("out", field)));
    lines.push(format!("{}, at sizes {}", prove::accuracy(project, formula, None), spec.sizes()));
    lines.extend(prove::reasons(project, formula));
    lines.extend(formula.kinks().iter().map(|kink| format!("kink: {}", mathematics(&kink.condition))));
    text.extend(lines.iter().flat_map(|line| ["    ", line, "\n"]));
    text
}

fn described(role: &str, field: &Field) -> String {
    let shape = if field.len() == 1 { String::new() } else { format!("[{}]", field.len()) };
    let quantity = field.quantity;
    format!("{role:3} {}{shape} ({}): {}; {}", field.name, quantity.unit, quantity.meaning, quantity.domain.allowed())
}
