//! Checks the claims of the chapters: display equations are executed, and numbers are computed or found in the test
//! that computes them.

use crate::book::prose::{About, Chapter, Display, Formulas, Mark, read};
use crate::book::{Fault, Numeral, Origin, coverage, is_rounded};
use crate::console::{count, figure};
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::equation::{Claims, View};
use jointproof::toolkit::verify::{self, Claim, Options, Printed};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::path::Path;

/// Random points per claim, in addition to the cases of the formula and the points near its kinks.
const SAMPLES: usize = 30;

/// Random points per view, in addition to the same points.
const VIEW_SAMPLES: usize = 5;

/// The counts of what was checked.
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

/// The faults, and the counts of what was checked.
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

/// Executes what an entry shows in addition to its equation.
fn entry(formula: &dyn AnyFormula) -> (Tally, Vec<Fault>) {
    let mut tally = Tally::default();
    let mut off = kinks(formula, &mut tally);
    off.extend(views(formula, &mut tally).err());
    let file = format!("the entry of {}", formula.spec().id);
    let fault = |message| Fault { file: file.clone(), line: 0, message };
    (tally, off.into_iter().map(fault).collect())
}

/// Executes the views that an entry shows below its equation: the closed form and the variation.
fn views(formula: &dyn AnyFormula, tally: &mut Tally) -> Result<(), String> {
    let signature = formula.signature();
    let unread = |error: jointproof::toolkit::equation::Error| error.to_string();
    let view = View::of(&signature).map_err(unread)?;
    // Nothing is shown if two entries use one symbol for different things.
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

/// Executes the claims.
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

/// Whether a number is what it claims to be.
fn held(project: &Project, formulas: &Formulas<'_>, numeral: &Numeral) -> Result<(), String> {
    let Numeral { written, origin, .. } = numeral;
    match origin {
        Origin::Given => Ok(()),
        Origin::Test(test) => in_test(project, test, written),
        Origin::Sentence(test) => {
            let body = body(project, test)?;
            // Comments may be broken into lines.
            let lines = body.lines().map(|line| line.trim().trim_start_matches('/').trim());
            let is_quoted = lines.collect::<Vec<_>>().join(" ").contains(written.as_str());
            if is_quoted { Ok(()) } else { Err(format!("`{test}` does not quote \"{written}\"")) }
        }
        Origin::Value(expression, about) => {
            let (of, setting) = formulas.setting(about, None)?;
            let claims = Claims::expression(expression, &setting).map_err(|error| error.to_string())?;
            let value = of.map_or_else(|| verify::number_at_large(&claims), |formula| formula.number(&claims)).to_f64();
            let is_so = is_rounded(written, value);
            if is_so { Ok(()) } else { Err(format!("{written} is not {value}, which `{expression}` is")) }
        }
    }
}

/// Whether a test or a constant contains the number.
fn in_test(project: &Project, test: &str, written: &str) -> Result<(), String> {
    let body = body(project, test)?;
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let value = written.parse::<f64>().ok();
    let has = body.split(|c| !is_part(c)).any(|number| value.is_some() && number.parse().ok() == value);
    if has { Ok(()) } else { Err(format!("`{test}` has no {written} in it")) }
}

/// The text of a test or a constant with this name: `file::name`, or `name` in any file.
fn body(project: &Project, test: &str) -> Result<String, String> {
    let (file, name) = test.split_once("::").map_or((None, test), |(file, name)| (Some(file), name));
    let mut texts = Vec::new();
    collect(&project.root().join("tests"), file, &mut texts);
    collect(&project.root().join("src"), file, &mut texts);
    collect(&project.root().join("xtask"), file, &mut texts);
    let is_constant = name.chars().all(|c| c.is_ascii_uppercase() || c == '_');
    let (head, end) = if is_constant { (format!("const {name}:"), ";") } else { (format!("fn {name}("), "\n}") };
    let body = texts.iter().find_map(|text| Some(text.split_once(&head)?.1.split(end).next().unwrap_or_default()));
    body.map(String::from).ok_or_else(|| format!("there is no test or constant `{test}`"))
}

/// The Rust files below a folder, or those with one name.
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
    use jointproof::connector::slot::ContactForce;
    use jointproof::formula::proof::{Case, Kink, Proved};
    use jointproof::formula::quantity::{Domain, Quantity, Unit};
    use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
    use jointproof::{Octuple, Scalar, fields};

    const SIDE: Quantity = Quantity::scalar("a", Unit::L, Domain::Real, "side of a square");
    const AREA: Quantity = Quantity::scalar("A", Unit::L.times(Unit::L), Domain::Real, "its area");
    fields! { struct Side<T> { a: T = SIDE } }
    fields! { struct Area<T> { area: T = AREA } }

    /// Its derivative is wrong, and two of its three kinks are where they are said to be.
    #[derive(Clone, Copy)]
    struct Wrong;

    impl Formula for Wrong {
        const SPEC: Spec = Spec::new("t.wrong", "Area of a square", Document::new("Squares").ours("", "we say so"))
            .equation("A = a^2")
            .eta(1.0, 1.0);
        type Inputs<T: Component> = Side<T>;
        type Outputs<T: Component> = Area<T>;
        #[inline]
        fn eval<D: Scalar>(i: &Side<D>) -> Area<D> {
            Area { area: i.a * i.a }
        }
        #[inline]
        fn jacobian<D: Scalar>(i: &Side<D>) -> Jacobian<Self, D> {
            Area { area: Side { a: i.a * 3.0 } }
        }
    }

    impl Proved for Wrong {
        fn cases() -> Vec<Case<Side<f64>>> {
            vec![Case::hand("three", "3² = 9", Side { a: 3.0 })]
        }

        fn kinks() -> Vec<Kink<Self>> {
            let kink = |condition: &str| {
                Kink::subgradient(condition, |i: &Side<Octuple>| i.a == 0.0, Side { a: 0.0 }, Side { a: 1.0 })
            };
            ["a = 0", r"\text{it is nothing}", "a = 1"].map(kink).into()
        }
    }

    #[test]
    fn what_is_wrong_with_an_entry_is_said_and_the_rest_is_counted() {
        let (tally, off) = entry(&Wrong);
        assert_eq!((tally.kinks, tally.in_words, tally.views), (1, 1, 1));
        assert!(off.iter().all(|fault| (fault.file.as_str(), fault.line) == ("the entry of t.wrong", 0)));
        let said: Vec<_> = off.iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(said[0], "a kink: `a = 1` is not so at {\"a\":0.0}");
        assert!(said[1].contains(" differ, most `") && said.len() == 2, "{said:?}");
    }

    #[test]
    fn a_claim_must_have_been_compared_somewhere_and_hold_everywhere() {
        let claim = |failures| {
            let mut claim = crate::sample::passed().eta;
            claim.failures = failures;
            claim
        };
        assert_eq!(verdict(&claim(0)), Ok(()));
        let expected = "1 of 103 comparisons differ, most `fc` at random 103 of seed 9: -0.25 on the left, 2.25 on the right, \
                        off by 1.25 of it\n    at {\"f2\":4.25,\"f3\":4.0}";
        assert_eq!(verdict(&claim(1)), Err(expected.to_owned()));
        let nowhere = Claim { worst: None, ..claim(0) };
        assert_eq!(verdict(&nowhere), Err("this was compared nowhere: its conditions hold at no point".into()));
    }

    #[test]
    fn chapters_and_entries_are_checked_and_counted_together() {
        let root = tempfile::tempdir().unwrap();
        let project = || {
            let project = Project::new("prose", env!("CARGO_MANIFEST_DIR"), &[&ContactForce, &Wrong]);
            project.in_folder(root.path().to_str().unwrap())
        };
        let [(first, nothing), (second, faults)] = [entry(&ContactForce), entry(&Wrong)];
        assert!(nothing.is_empty() && first.in_words == 0);
        let (views, kinks) = (first.views + second.views, first.kinks + second.kinks);
        let comparisons = first.comparisons + second.comparisons;
        // Without a book there are only the entries.
        let (off, counts) = check(&project()).unwrap();
        assert_eq!(off.len(), faults.len());
        let entries = format!("{} of entries and {} executed", count(views, "view"), count(kinks, "kink"));
        assert_eq!(
            counts,
            format!("0 equations, {entries}, 0 for presentation, 1 in words, {comparisons} comparisons, 0 numbers")
        );
        let text = "# One\n\n{{#equation slot.contact_force}}\n\n$$\nF_C^2 = f_2^2 + f_3^2\n$$\n\n\
                    {{#presentation it is so}}\n\n$$\na = b\n$$\n\n{{#equation slot.contact_force}}\n\n$$\nF_C = f_2\n$$\n\n\
                    It is {{2.5 = 5/2}} and {{2.6 = 5/2}}. It {{\"does not depend on x\" in a::shown}},\n\
                    {{\"depends only on y\" in a::shown}}, and it does not depend on z.\n";
        crate::files::write(&root.path().join("book/src/one.md"), text).unwrap();
        let test = "fn shown() {\n    // It does not\n    // depend on x.\n}\n";
        crate::files::write(&root.path().join("tests/a.rs"), test).unwrap();
        let (off, counts) = check(&project()).unwrap();
        let chapter: Vec<_> = off.iter().filter(|fault| fault.file == "book/src/one.md").collect();
        assert_eq!((off.len(), chapter.len()), (faults.len() + 4, 4), "{off:?}");
        assert!(
            chapter[0].line == 22 && chapter[0].message.starts_with("no test shows this claim (`not depend on`)"),
            "{chapter:?}"
        );
        assert!(chapter[1].line == 17 && chapter[1].message.contains("differ"), "{chapter:?}");
        assert_eq!((chapter[2].line, chapter[2].message.as_str()), (21, "2.6 is not 2.5, which `5/2` is"));
        assert_eq!(chapter[3].message, "`a::shown` does not quote \"depends only on y\"");
        assert!(counts.starts_with(&format!("2 equations, {entries}, 1 for presentation, 1 in words, ")), "{counts}");
        let compared =
            counts.split(", ").nth(4).and_then(|part| part.strip_suffix(" comparisons")?.parse::<usize>().ok());
        assert!(compared > Some(comparisons + 2 * SAMPLES) && counts.ends_with(" comparisons, 4 numbers"), "{counts}");
    }

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
