//! What a formula still owes before it counts as proved, all at once.

use crate::book::coverage::directives;
use crate::console::{bold, count, red};
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::proof::Flag;
use std::collections::HashSet;

/// One thing that is owed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Debt {
    /// What is missing.
    pub(crate) what: String,
    /// Where it belongs, and how it is written.
    pub(crate) how: String,
}

/// What these formulas owe, a block a formula; empty if nothing is owed.
pub(crate) fn owed(project: &Project, formulas: &[&dyn AnyFormula]) -> anyhow::Result<Vec<String>> {
    let entries = entries(project)?;
    let block = |formula: &&dyn AnyFormula| {
        let debts = debts(project, entries.as_ref(), *formula);
        let lines: String = debts.iter().map(|Debt { what, how }| format!("    {what}: {how}\n")).collect();
        (!debts.is_empty()).then(|| format!("{} {} owes\n{lines}", red("off"), bold(formula.spec().id)))
    };
    Ok(formulas.iter().filter_map(block).collect())
}

/// How many formulas owe something, for a summary.
pub(crate) fn summary(formulas: usize, owed: &[String]) -> String {
    let formulas = count(formulas, "formula");
    match owed.len() {
        0 => format!("{formulas}, nothing owed"),
        debtors => format!("{formulas}, {debtors} owing"),
    }
}

/// The formulas that have an entry; `None` for a project without a book.
fn entries(project: &Project) -> anyhow::Result<Option<HashSet<String>>> {
    if !project.root().join("book/src").exists() {
        return Ok(None);
    }
    Ok(Some(directives(project.root())?.into_iter().map(|directive| directive.id).collect()))
}

/// What one formula owes.
fn debts(project: &Project, entries: Option<&HashSet<String>>, formula: &dyn AnyFormula) -> Vec<Debt> {
    let spec = formula.spec();
    let cases = formula.cases();
    let golden = project.golden_file(spec.id);
    let undescribed = formula.inputs().iter().chain(formula.outputs()).find(|field| !is_described(field));
    let name = undescribed.map_or("", |field| field.name);
    let mut owed = vec![
        (is_id(spec.id), "an identifier", "`family.name` in `SPEC`, of small letters, digits and _".to_owned()),
        (!spec.title.is_empty(), "a title", "the second argument of `Spec::new`".into()),
        (!spec.latex.is_empty(), "its equation", "`.equation(r\"…\")` in `SPEC`".into()),
        (!spec.source.title.is_empty(), "its source", "`Source::new(\"title\").section(\"…\").link(\"…\")`".into()),
        (undescribed.is_none(), "symbol and meaning", format!("in the `Quantity` of `{name}`")),
        (cases.contains(&Flag::Hand), "a case worked by hand", "`Case::hand` in `Proved::cases`".into()),
        (cases.contains(&Flag::Hard), "a hard case", "`Case::hard`: zero, cancelled, tiny, huge; see `hard`".into()),
        (!formula.laws().is_empty(), "a law", "`Law::new` in `Proved::laws`: what physics demands".into()),
        (golden.exists(), "its golden file", format!("{} golden --filter {}", project.command(), spec.id)),
        (
            entries.is_none_or(|entries| entries.contains(spec.id)),
            "an entry in the book",
            format!("{{{{#formula {}}}}} in a chapter", spec.id),
        ),
    ];
    for (what, is_paid, how) in &project.extension.debts {
        owed.push((is_paid(project, spec.id), what, (*how).to_owned()));
    }
    let unpaid = owed.into_iter().filter(|(is_paid, ..)| !is_paid);
    unpaid.map(|(_, what, how)| Debt { what: what.to_owned(), how }).collect()
}

fn is_described(field: &Field) -> bool {
    !field.quantity.latex.is_empty() && !field.quantity.meaning.is_empty()
}

fn is_id(id: &str) -> bool {
    id.split_once('.').is_some_and(|(family, name)| is_name(family) && is_name(name))
}

/// Whether this can be a family or the name of a formula.
pub(crate) fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}
