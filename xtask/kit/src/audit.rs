//! `audit`: closed form, automatic differentiation and differences compared with each other, and the laws.

use crate::attack;
use crate::console::{count, figure, print, progress, say};
use crate::elements;
use crate::evidence::Evidence;
use crate::golden;
use crate::missing::missing;
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use crate::prove;
use crate::review::{Finding, annotations, of_claim, rdjson, sarif, summarise};
use crate::selection::Selection;
use crate::since::Changes;
use ::attack::Effort;
use anyhow::Context;
use indicatif::ParallelProgressIterator;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::verify::golden::components;
use jointproof::toolkit::verify::{Audit, Claim, ElementAudit, Options, Part, Shard};
use judge::audited::{in_full, text, total};
use judge::examination;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

/// Check every claim about the formulas: derivatives, accuracy, laws
///
/// Each formula's closed-form Jacobian is compared with automatic differentiation, and that with differences, in 237
/// bits; value and Jacobian in f64 are compared with the exact ones; its laws are tested at random points. The worst
/// point is printed with its inputs; --point tests it again.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} audit                                every formula at 1000 random points
  {command} audit --samples 100000 --seed 7      more points, other seed
  {command} audit --filter '{family}.*' --format markdown  to paste into a code review
  {command} audit --since main                   what a change touches
  {command} audit --format github                in a workflow: annotations
  {command} audit --samples 1000000 --shard 3/16 > 3.json  on one of sixteen machines
  {command} audit --merge *.json                 their results together
  {command} audit --attack 60                    refute bounds, a minute each
  {command} audit --filter {formula} --point '{point}'")]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: Selection,
    /// Random points per formula; a tenth of them per element, or fewer
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
    /// Seed of the random points
    #[arg(long, value_name = "S", default_value_t = Options::default().seed)]
    seed: u64,
    /// Only formulas whose evidence depends on a file that has changed since this revision
    #[arg(long, value_name = "REV", conflicts_with = "point")]
    since: Option<String>,
    /// Format of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Audit a share of the random points, as `3/16`, and print it as JSON; the points are the same for any number of shares
    #[arg(long, value_name = "I/N", conflicts_with_all = ["point", "merge", "format"])]
    shard: Option<Shard>,
    /// Audit nothing: join the shares in these files, in any order
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["point", "since", "samples", "seed"])]
    merge: Vec<PathBuf>,
    /// Audit one formula at this point only: its inputs as a JSON object, as in golden files and audits
    #[arg(long, value_name = "JSON", requires = "filter", conflicts_with_all = ["samples", "seed"])]
    point: Option<String>,
    /// Audit nothing else: spend this many seconds on every formula to refute its bounds of accuracy by a search that climbs
    #[arg(long, value_name = "SECONDS", conflicts_with_all = ["samples", "since", "format", "shard", "merge", "point"])]
    attack: Option<f64>,
    /// End the search for each formula after this many evaluations instead, the same on every machine
    #[arg(long, value_name = "N", requires = "attack", hide = true)]
    evaluations: Option<u64>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Format {
    /// For a terminal
    Text,
    /// For a code review
    Markdown,
    /// For a program
    Json,
    /// Workflow commands: annotations at the lines of a pull request, and the step's summary
    Github,
    /// SARIF 2.1.0, to be uploaded
    Sarif,
    /// RDFormat, for reviewdog
    Rdjson,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_sources("audit")?;
    if let Some(seconds) = arguments.attack {
        let seconds = Duration::try_from_secs_f64(seconds)
            .map_err(|error| Usage(format!("--attack is {seconds}; allowed is a time in seconds: {error}")))?;
        let effort = arguments.evaluations.map_or(Effort::Time(seconds), Effort::Evaluations);
        let (text, holds) = attack::run(project, &arguments.selection.formulas(project)?, effort, arguments.seed)?;
        print(&text)?;
        return Ok(verdict(holds));
    }
    let (mut formulas, chosen) = arguments.selection.formulas_and_elements(project)?;
    let changes = arguments.since.as_ref().map(|revision| Changes::since(project, revision)).transpose()?;
    if let Some(changes) = &changes {
        formulas = changes.touched(&formulas);
    }
    let options = Options { samples: arguments.samples, seed: arguments.seed };
    if let Some(shard) = arguments.shard {
        print(&serde_json::to_string(&parts(&formulas, &options, shard))?)?;
        return Ok(verdict(true));
    }
    let audits = match &arguments.point {
        Some(point) => vec![at_point(&formulas, point)?],
        None if !arguments.merge.is_empty() => merged(&formulas, &arguments.merge)?,
        None => audit(project, &formulas, &options)?,
    };
    // Points, shares and changes concern formulas only.
    let is_of_formulas = arguments.point.is_some() || !arguments.merge.is_empty() || arguments.since.is_some();
    let of_elements = if is_of_formulas { Vec::new() } else { elements::audit(&chosen, &options) };
    let elements_text = elements::text(&of_elements)?;
    let of_elements_alone = formulas.is_empty() && !of_elements.is_empty();
    // At a single point on a kink, some claims cannot be checked.
    let passed = if arguments.point.is_some() { Audit::no_claim_failed } else { Audit::passed };
    // An audit at a given point serves another purpose, so that missing evidence is not reported.
    let missing = if arguments.point.is_some() { Vec::new() } else { missing(project, &formulas)? };
    print(&match arguments.format {
        Format::Text if of_elements_alone => elements_text.clone(),
        Format::Text => {
            text(&audits, passed, &|audit| prove::of_audit(project, audit))? + &elements_text + &missing.concat()
        }
        Format::Markdown => {
            markdown(project, &formulas, &audits, passed)? + &elements::markdown(&of_elements) + &fenced(&missing)
        }
        Format::Json => {
            let all = audits.iter().map(One::Formula).chain(of_elements.iter().map(One::Element));
            serde_json::to_string_pretty(&all.collect::<Vec<_>>())?
        }
        Format::Github => {
            let of_both = markdown(project, &formulas, &audits, passed)? + &elements::markdown(&of_elements);
            summarise(&(of_both + &fenced(&missing)))?;
            annotations(&findings(project, &formulas, &audits, changes.as_ref())?) + &total(&audits, passed)
        }
        Format::Sarif => sarif(&findings(project, &formulas, &audits, changes.as_ref())?)?,
        Format::Rdjson => rdjson(&findings(project, &formulas, &audits, changes.as_ref())?)?,
    })?;
    if !matches!(arguments.format, Format::Text | Format::Markdown) && !missing.is_empty() {
        say(missing.concat().trim_end());
    }
    let elements_passed = of_elements.iter().all(ElementAudit::passed);
    if !matches!(arguments.format, Format::Text | Format::Markdown | Format::Json) && !elements_passed {
        say(elements_text.trim_end());
    }
    Ok(verdict(elements_passed && is_well(&missing, &audits, passed)))
}

/// An audit in the form of the JSON output.
#[derive(serde::Serialize)]
#[serde(untagged)]
enum One<'a> {
    Formula(&'a Audit),
    Element(&'a ElementAudit),
}

/// Whether no evidence is missing, and every audit has passed.
fn is_well(missing: &[String], audits: &[Audit], passed: fn(&Audit) -> bool) -> bool {
    missing.is_empty() && audits.iter().all(passed)
}

/// One finding for each failed claim, on the changed line or at the function that it is about.
fn findings(
    project: &Project,
    formulas: &[&dyn AnyFormula],
    audits: &[Audit],
    changes: Option<&Changes>,
) -> anyhow::Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for audit in audits {
        let formula = formulas.iter().find(|formula| formula.spec().id == audit.formula);
        let formula = formula.context("an audit is of a formula that was asked for")?;
        for claim in audit.claims().filter(|claim| claim.failures > 0) {
            let place = of_claim(project, *formula, &claim.claim, changes)?;
            let worst = claim.worst.as_ref().map_or(String::new(), |worst| in_full(claim, worst));
            let lines: Vec<_> = worst.lines().map(str::trim).collect();
            let message = format!("failed {} of {}\n{}", claim.failures, count(claim.checks, "time"), lines.join("\n"));
            findings.push(Finding { formula: audit.formula.clone(), claim: claim.claim.clone(), message, place });
        }
    }
    Ok(findings)
}

/// The missing evidence, for a code review.
fn fenced(missing: &[String]) -> String {
    let text = anstream::adapter::strip_str(&missing.concat()).to_string();
    if text.is_empty() { text } else { format!("## Missing\n\n```text\n{text}```\n") }
}

fn at_point(formulas: &[&dyn AnyFormula], point: &str) -> anyhow::Result<Audit> {
    let [formula] = formulas else {
        return Err(Usage(format!("--point needs a --filter that matches one formula, not {}", formulas.len())).into());
    };
    let inputs = serde_json::from_str(point)
        .map_err(|error| Usage(format!("--point is not a JSON object of {}: {error}", names(formula.inputs()))))?;
    let audit = components(formula.inputs(), &inputs).and_then(|point| formula.audit_at(&point));
    audit.map_err(|error| Usage(format!("--point of {}: {error}", formula.spec().id)).into())
}

fn parts(formulas: &[&dyn AnyFormula], options: &Options, shard: Shard) -> Vec<Part> {
    let bar = progress("audit", formulas.len());
    formulas.par_iter().progress_with(bar).map(|formula| formula.audit_part(options, shard)).collect()
}

/// The audits whose shares are all in these files, in the order of the catalog.
fn merged(formulas: &[&dyn AnyFormula], files: &[PathBuf]) -> anyhow::Result<Vec<Audit>> {
    let mut parts = BTreeMap::<String, Vec<Part>>::new();
    for file in files {
        let said = || format!("{} is not what `audit --shard` prints", file.display());
        let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
        for part in serde_json::from_str::<Vec<Part>>(&text).with_context(said)? {
            parts.entry(part.formula().to_owned()).or_default().push(part);
        }
    }
    let mut audits = Vec::new();
    for formula in formulas {
        let Some(mut parts) = parts.remove(formula.spec().id) else { continue };
        parts.sort_by_key(Part::first);
        let mut parts = parts.into_iter();
        let first = parts.next().context("an entry is made with a part in it")?;
        audits.push(
            parts.try_fold(first, Part::and).and_then(Part::into_audit).map_err(|error| Usage(error.to_string()))?,
        );
    }
    if audits.is_empty() {
        return Err(Usage("--merge: no share of a formula that was asked for is in these files".into()).into());
    }
    Ok(audits)
}

fn names(fields: &[Field]) -> String {
    fields.iter().map(|field| field.name).collect::<Vec<_>>().join(", ")
}

/// Audits formulas on all cores, and keeps the results as evidence.
pub(crate) fn audit(project: &Project, formulas: &[&dyn AnyFormula], options: &Options) -> anyhow::Result<Vec<Audit>> {
    let bar = progress("audit", formulas.len());
    let audits: Vec<_> = formulas.par_iter().progress_with(bar).map(|formula| formula.audit(options)).collect();
    let mut evidence = Evidence::load(project);
    evidence.add_audits(&audits);
    evidence.save(project)?;
    Ok(audits)
}

/// Audits those formulas for which this same program, with these options, has not already found every claim to hold;
/// reports how many were known.
pub(crate) fn audit_unknown(
    project: &Project,
    formulas: &[&dyn AnyFormula],
    options: &Options,
) -> anyhow::Result<(Vec<Audit>, usize)> {
    let mut known = Evidence::load(project).found_by_this_program(options);
    let id = |formula: &&dyn AnyFormula| formula.spec().id;
    let unknown: Vec<_> = formulas.iter().copied().filter(|formula| !known.contains_key(id(formula))).collect();
    known.extend(audit(project, &unknown, options)?.into_iter().map(|audit| (audit.formula.clone(), audit)));
    Ok((formulas.iter().filter_map(|formula| known.remove(id(formula))).collect(), formulas.len() - unknown.len()))
}

fn markdown(
    project: &Project,
    formulas: &[&dyn AnyFormula],
    audits: &[Audit],
    passed: fn(&Audit) -> bool,
) -> anyhow::Result<String> {
    let failed: Vec<_> = audits.iter().filter(|audit| !passed(audit)).map(|audit| audit.formula.as_str()).collect();
    let mut text = String::from("## Audit of derivatives\n\n");
    match failed.as_slice() {
        [] => writeln!(text, "{} formulas audited, every claim held.\n", audits.len())?,
        failed => writeln!(text, "**Off: {}**\n", failed.join(", "))?,
    }
    let (well, off): (Vec<&Audit>, Vec<&Audit>) = audits.iter().partition(|audit| passed(audit));
    for audit in off.into_iter().chain(well) {
        let points = count(audit.named_points + audit.random_points, "point");
        if passed(audit) {
            let claims = count(audit.claims().count(), "claim");
            writeln!(
                text,
                "<details><summary>✅ <code>{}</code>: {claims} held at {points}</summary>\n",
                audit.formula
            )?;
        } else {
            writeln!(text, "### ❌ `{}`\n", audit.formula)?;
        }
        writeln!(text, "{}.\n", audit.provenance)?;
        if let Some(accuracy) = prove::of_audit(project, audit) {
            writeln!(text, "{accuracy}.\n")?;
        }
        writeln!(text, "{} named and {} random points.\n", audit.named_points, audit.random_points)?;
        writeln!(text, "| claim | checked | failed | worst | bound | at |\n|---|--:|--:|--:|--:|---|")?;
        for claim in audit.claims() {
            let worst = claim.worst.as_ref();
            let size = figure(worst.map_or(0.0, |worst| worst.size));
            let at = worst
                .filter(|worst| worst.size > 0.0)
                .map_or(String::new(), |worst| format!("`{}`, {}", worst.entry, worst.point));
            let Claim { claim, bound, checks, failures, .. } = claim;
            writeln!(text, "| {claim} | {checks} | {failures} | {size} | {} | {at} |", figure(*bound))?;
        }
        text.push('\n');
        for line in audit.examination.iter().flat_map(examination::lines) {
            writeln!(text, "- {line}")?;
        }
        text.push('\n');
        for claim in audit.claims().filter(|claim| !claim.held()) {
            let Some(worst) = &claim.worst else { continue };
            writeln!(text, "Worst of *{}*: found {:?}, expected {:?} at\n", claim.claim, worst.found, worst.expected)?;
            writeln!(text, "```json\n{}\n```\n", worst.inputs)?;
        }
        let formula = formulas.iter().find(|formula| formula.spec().id == audit.formula);
        text += &formula.map_or(String::new(), |formula| against_golden(project, *formula));
        if passed(audit) {
            text += "</details>\n\n";
        }
    }
    Ok(text)
}

/// The number of changes of a golden file that are listed before the rest is only counted.
const LISTED: usize = 5;

/// The changes compared with the committed golden file.
fn against_golden(project: &Project, formula: &dyn AnyFormula) -> String {
    match golden::changes(project, formula).as_deref() {
        Err(reason) => format!("There is no committed golden file to compare with: {reason}\n\n"),
        Ok([]) => "Against the committed golden file: no change.\n\n".into(),
        Ok(changes) => listed(changes),
    }
}

/// The changes, or the first of them if there are many.
fn listed(changes: &[impl ToString]) -> String {
    let mut listed: Vec<_> = changes.iter().take(LISTED).map(ToString::to_string).collect();
    if changes.len() > LISTED {
        listed.push(format!("… and {} more", changes.len() - LISTED));
    }
    let changed = count(changes.len(), "change");
    format!("Against the committed golden file: {changed}.\n\n- {}\n\n", listed.join("\n- "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use expect_test::expect_file;
    use jointproof::connector::slot::{ContactForce, Friction};
    use jointproof::formula::Formula;

    /// The two audits of the sample.
    fn audits() -> [Audit; 2] {
        [sample::passed(), sample::failed()]
    }

    const ACCURACY: &str =
        "value: η ≤ 4, measured (largest found 1.50); Jacobian: η ≤ 5/3, proved (largest found 1.25)";

    fn without_colours(text: &str) -> String {
        anstream::adapter::strip_str(text).to_string()
    }

    #[test]
    fn text_says_what_the_audits_found() {
        let printed = text(&audits(), Audit::passed, &|_| Some(ACCURACY.into())).unwrap();
        expect_file!["../tests/printed/audit.txt"].assert_eq(&without_colours(&printed));
    }

    /// A deviation of 0 has no worst point: the first one is as bad as all others.
    #[test]
    fn a_figure_of_0_has_no_point_to_look_at() {
        let mut audit = sample::passed();
        let figures = [&mut audit.eta].into_iter().chain(&mut audit.eta_jacobian).chain(&mut audit.scaled);
        figures.filter_map(|claim| claim.worst.as_mut()).for_each(|worst| worst.size = 0.0);
        let printed = without_colours(&text(&[audit], Audit::passed, &|_| None).unwrap());
        assert!(printed.contains("103        0    4.00  η of the value in f64\n"), "{printed}");
        assert!(!printed.contains("worst of"), "{printed}");
        let mut audit = sample::passed();
        audit.eta.worst.as_mut().unwrap().size = 0.5;
        let printed = without_colours(&text(&[audit], Audit::passed, &|_| None).unwrap());
        assert!(printed.contains("worst of η of the value in f64: 0.50 at fc"), "any other has: {printed}");
    }

    #[test]
    fn markdown_says_what_the_audits_found() {
        let project = Project::new("sample", env!("CARGO_MANIFEST_DIR"), &[]);
        let printed = markdown(&project, &[], &audits(), Audit::passed).unwrap();
        expect_file!["../tests/printed/audit.md"].assert_eq(&without_colours(&printed));
        let all_well = markdown(&project, &[], &audits()[..1], Audit::passed).unwrap();
        assert!(all_well.contains("1 formulas audited, every claim held.") && !all_well.contains("Off"), "{all_well}");
    }

    #[test]
    fn all_must_have_passed_and_nothing_be_owed() {
        let [passed, failed] = audits();
        let is_well = |missing: &[String], audits: &[Audit]| is_well(missing, audits, Audit::passed);
        assert!(is_well(&[], &[]) && is_well(&[], &[passed.clone(), passed.clone()]));
        assert!(!is_well(&[], &[passed.clone(), failed.clone()]) && !is_well(&[], &[failed, passed.clone()]));
        assert!(!is_well(&["a poem".into()], &[passed]));
    }

    #[test]
    fn what_failed_even_once_is_a_finding_on_the_line_of_its_function() {
        let project = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), &[]).in_folder("../..");
        let (mut well, mut badly) = (sample::passed(), sample::passed());
        (well.formula, badly.formula) = (ContactForce::SPEC.id.into(), Friction::SPEC.id.into());
        badly.closed_against_ad.as_mut().unwrap().failures = 1;
        badly.eta.failures = 2;
        let found = findings(&project, &[&ContactForce, &Friction], &[well, badly], None).unwrap();
        let line = |place: &crate::review::Place| {
            let text = std::fs::read_to_string(project.root().join(&place.file)).unwrap();
            format!("{}: {}", place.file, text.lines().nth(place.line - 1).unwrap().trim())
        };
        let places: Vec<_> = found.iter().map(|finding| line(&finding.place)).collect();
        assert!(places[0].starts_with("src/connector/slot/friction.rs: fn jacobian<"), "{places:?}");
        assert!(places[1].starts_with("src/connector/slot/friction.rs: fn eval<"), "{places:?}");
        let claims: Vec<_> = found.iter().map(|finding| (finding.formula.as_str(), finding.claim.as_str())).collect();
        let expected = ["closed form = automatic differentiation", "η of the value in f64"];
        assert_eq!(claims, expected.map(|claim| ("slot.friction", claim)));
        assert_eq!(
            found[1].message,
            "failed 2 of 103 times\nworst of η of the value in f64: 1.25 at fc, random 103 of seed 9\n\
             found 2.25, expected -0.25\n--point '{\"f2\":4.25,\"f3\":4.0}'"
        );
    }

    #[test]
    fn what_is_missing_stands_in_a_fence_of_its_own() {
        assert_eq!(fenced(&[]), "");
        let missing = [format!("{} lacks\n    a poem\n", crate::console::bold("a.b")), "c.d lacks\n".into()];
        assert_eq!(fenced(&missing), "## Missing\n\n```text\na.b lacks\n    a poem\nc.d lacks\n```\n");
    }

    #[test]
    fn of_more_than_five_changes_the_rest_is_counted() {
        let of = |number: usize| listed(&["a", "b", "c", "d", "e", "f"][..number]);
        let head = "Against the committed golden file: ";
        assert_eq!(of(1), format!("{head}1 change.\n\n- a\n\n"));
        assert_eq!(of(5), format!("{head}5 changes.\n\n- a\n- b\n- c\n- d\n- e\n\n"));
        assert_eq!(of(6), format!("{head}6 changes.\n\n- a\n- b\n- c\n- d\n- e\n- … and 1 more\n\n"));
    }

    /// An unchecked claim has not held, except at a single point where it could not be checked.
    #[test]
    fn a_claim_that_was_not_checked_is_off_but_at_a_single_point() {
        let mut audit = sample::passed();
        (audit.equation.checks, audit.equation.worst) = (0, None);
        let [strict, lenient] = [Audit::passed, Audit::no_claim_failed]
            .map(|passed| without_colours(&text(std::slice::from_ref(&audit), passed, &|_| None).unwrap()));
        assert!(strict.starts_with("off t.first at 27 points") && strict.ends_with(", 1 formula off\n"), "{strict}");
        assert!(
            lenient.starts_with("ok  t.first at 27 points") && lenient.ends_with(", 0 formulas off\n"),
            "{lenient}"
        );
        assert!(strict.contains("NOT CHECKED: printed equation = value"), "{strict}");
    }
}
