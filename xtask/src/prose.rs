//! What the chapters claim: display equations are executed, numbers are computed or found in the test that computes them.

use crate::book::prose::{About, Chapter, Display, Formulas, Mark, read};
use crate::book::{Fault, Numeral, Origin, coverage, is_rounded};
use crate::console::{count, figure};
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use jointproof::equation::{Claims, Signature, View};
use jointproof::verify::{self, Claim, Options, Printed};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::path::Path;

/// Random points a claim, beside the cases of the formula and the points beside its kinks.
const SAMPLES: usize = 30;

/// Random points a view, beside the same.
const VIEW_SAMPLES: usize = 5;

/// What was checked.
#[derive(Default)]
struct Tally {
    executed: usize,
    presented: usize,
    comparisons: usize,
    numbers: usize,
    views: usize,
    kinks: usize,
    in_words: usize,
}

/// What is off, and how much was checked.
pub(crate) fn check(project: &Project) -> anyhow::Result<(Vec<Fault>, String)> {
    let formulas = Formulas(project.catalog());
    let (mut faults, mut tally) = (Vec::new(), Tally::default());
    let chapters = if project.has_book() { coverage::chapters(project.root())? } else { BTreeMap::default() };
    for (file, text) in chapters {
        let Chapter { displays, numerals, faults: unmarked } = read(&file, &text);
        faults.extend(unmarked);
        let mut note = |line, found: Result<(), String>| {
            faults.extend(found.err().map(|message| Fault { file: file.clone(), line, message }));
        };
        let mut above = None;
        for Display { latex, line, mark } in &displays {
            match mark {
                Some(Mark::Executed(about)) => note(*line, executed(&formulas, latex, about, &mut above, &mut tally)),
                _ => tally.presented += 1,
            }
        }
        tally.numbers += numerals.len();
        for numeral in &numerals {
            note(numeral.line, held(project, &formulas, numeral));
        }
    }
    let entries = project.catalog().par_iter().map(|&formula| entry(formula)).collect::<Vec<_>>();
    for (found, off) in entries {
        tally.comparisons += found.comparisons;
        tally.views += found.views;
        tally.kinks += found.kinks;
        tally.in_words += found.in_words;
        faults.extend(off);
    }
    let Tally { executed, presented, comparisons, numbers, views, kinks, in_words } = tally;
    let counted =
        [(executed, "equation"), (views, "view"), (kinks, "kink"), (comparisons, "comparison"), (numbers, "number")];
    let [executed, views, kinks, comparisons, numbers] = counted.map(|(number, noun)| count(number, noun));
    let other = format!("{presented} for presentation, {in_words} in words");
    Ok((faults, format!("{executed}, {views} of entries and {kinks} executed, {other}, {comparisons}, {numbers}")))
}

/// Executes what an entry shows beside its equation.
fn entry(formula: &dyn AnyFormula) -> (Tally, Vec<Fault>) {
    let mut tally = Tally::default();
    let mut off = kinks(formula, &mut tally);
    off.extend(views(formula, &mut tally).err());
    let file = format!("the entry of {}", formula.spec().id);
    let fault = |message| Fault { file: file.clone(), line: 0, message };
    (tally, off.into_iter().map(fault).collect())
}

/// Executes what an entry shows below its equation: the same with everything put in, and its variation.
fn views(formula: &dyn AnyFormula, tally: &mut Tally) -> Result<(), String> {
    let signature = Signature { spec: formula.spec(), inputs: formula.inputs(), outputs: formula.outputs() };
    let unread = |error: jointproof::equation::Error| error.to_string();
    let view = View::of(&signature).map_err(unread)?;
    // Nothing is shown where two entries call different things by the same symbol.
    let Some(view) = view else { return Ok(()) };
    let options = Options { samples: VIEW_SAMPLES, ..Options::default() };
    let closed = view.equation(&signature).map_err(unread)?.map(|closed| formula.trial(&options).compare(&closed));
    let varied = formula.claims(&view.claims(&signature).map_err(unread)?, &options);
    for claim in closed.iter().chain([&varied]) {
        tally.views += 1;
        tally.comparisons += claim.checks;
        verdict(claim)?;
    }
    Ok(())
}

/// Executes the printed conditions of kinks.
fn kinks(formula: &dyn AnyFormula, tally: &mut Tally) -> Vec<String> {
    let mut off = Vec::new();
    for (_, printed) in formula.kinks_as_printed() {
        match printed {
            Printed::InWords => tally.in_words += 1,
            Printed::Executed(points) => {
                tally.kinks += 1;
                tally.comparisons += points;
            }
            Printed::Off(message) => off.push(format!("a kink: {message}")),
        }
    }
    off
}

/// Executes what is claimed.
fn executed(
    formulas: &Formulas<'_>,
    latex: &str,
    about: &str,
    above: &mut Option<(About, String)>,
    tally: &mut Tally,
) -> Result<(), String> {
    let (of, setting) = formulas.setting(about, above.as_ref())?;
    *above = Some(((of, setting.clone()), latex.into()));
    let claims = Claims::read(latex, &setting).map_err(|error| {
        let from = latex.get(error.at()..).unwrap_or_default();
        format!("{error}: `{}`", from.lines().next().unwrap_or_default())
    })?;
    let options = Options { samples: SAMPLES, ..Options::default() };
    let claim = match of {
        Some(formula) => formula.claims(&claims, &options),
        None => verify::claims_at_large(&claims, &options),
    };
    tally.executed += 1;
    tally.comparisons += claim.checks;
    verdict(&claim)
}

fn verdict(claim: &Claim) -> Result<(), String> {
    match &claim.worst {
        None => Err("this was compared nowhere: its conditions hold at no point".into()),
        Some(_) if claim.failures == 0 => Ok(()),
        Some(worst) => Err(format!(
            "{} of {} differ, most `{}` at {}: {:?} on the left, {:?} on the right, off by {} of it\n    at {}",
            claim.failures,
            count(claim.checks, "comparison"),
            worst.entry,
            worst.point,
            worst.expected,
            worst.found,
            figure(worst.size),
            worst.inputs
        )),
    }
}

/// Whether a number is what it says it is.
fn held(project: &Project, formulas: &Formulas<'_>, numeral: &Numeral) -> Result<(), String> {
    let Numeral { written, origin, .. } = numeral;
    match origin {
        Origin::Given => Ok(()),
        Origin::Test(test) => in_test(project, test, written),
        Origin::Value(expression, about) => {
            let (of, setting) = formulas.setting(about, None)?;
            let claims = Claims::expression(expression, &setting).map_err(|error| error.to_string())?;
            let value = of.map_or_else(|| verify::number_at_large(&claims), |formula| formula.number(&claims)).to_f64();
            let is_so = is_rounded(written, value);
            if is_so { Ok(()) } else { Err(format!("{written} is not {value}, which `{expression}` is")) }
        }
    }
}

/// Whether a test or a constant of this name has the number in it: `file::name`, or `name` anywhere.
fn in_test(project: &Project, test: &str, written: &str) -> Result<(), String> {
    let (file, name) = test.split_once("::").map_or((None, test), |(file, name)| (Some(file), name));
    let mut texts = Vec::new();
    collect(&project.root().join("tests"), file, &mut texts);
    collect(&project.root().join("src"), file, &mut texts);
    let is_constant = name.chars().all(|c| c.is_ascii_uppercase() || c == '_');
    let (head, end) = if is_constant { (format!("const {name}:"), ";") } else { (format!("fn {name}("), "\n}") };
    let body = texts.iter().find_map(|text| Some(text.split_once(&head)?.1.split(end).next().unwrap_or_default()));
    let Some(body) = body else { return Err(format!("there is no test or constant `{test}`")) };
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let value = written.parse::<f64>().ok();
    let has = body.split(|c| !is_part(c)).any(|number| value.is_some() && number.parse().ok() == value);
    if has { Ok(()) } else { Err(format!("`{test}` has no {written} in it")) }
}

/// The Rust files below a folder, or those of one name.
fn collect(path: &Path, name: Option<&str>, texts: &mut Vec<String>) {
    if let Ok(entries) = std::fs::read_dir(path) {
        entries.flatten().for_each(|entry| collect(&entry.path(), name, texts));
    } else if path.extension().is_some_and(|extension| extension == "rs")
        && name.is_none_or(|name| path.file_stem().is_some_and(|stem| stem == name))
    {
        texts.extend(std::fs::read_to_string(path));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_of_a_name_are_collected_from_all_folders_and_nothing_else() {
        let root = tempfile::tempdir().unwrap();
        for file in ["a.rs", "a.txt", "b.rs", "inner/a.rs"] {
            let path = root.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, file).unwrap();
        }
        let collected = |name: Option<&str>| {
            let mut texts = Vec::new();
            collect(root.path(), name, &mut texts);
            texts.sort();
            texts
        };
        assert_eq!(collected(Some("a")), ["a.rs", "inner/a.rs"]);
        assert_eq!(collected(None), ["a.rs", "b.rs", "inner/a.rs"]);
    }
}
