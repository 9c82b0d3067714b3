//! `cargo xtask book`: fills the seam from the catalog, the golden files and the evidence, and builds.

use super::content::{Content, Entry, GoldenCounts, GoldenFile, Kink, Source, SourceFile, Symbol};
use super::fault::Faults;
use super::locate::Index;
use super::{Options, Summary, build, worked_example};
use crate::evidence::Evidence;
use crate::report::{self, data::Report};
use crate::{Outcome, console, figures, files, scene, statements};
use anyhow::Context;
use jointproof::catalog::{AnyFormula, CATALOG, KinkEntry};
use jointproof::formula::Field;
use jointproof::proof::Convention;
use jointproof::quantity::Shape;
use jointproof::verify::Audit;
use jointproof::verify::golden::File;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// Build the book: every formula with its source, code, tests, golden cases and evidence
///
/// The evidence shown is what the last `golden --check` and `audit` found about this very version of the code; speed and
/// error are those of the last `report` on all formulas, or of a quick one made now if there is none.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  cargo xtask book           build into target/book; open target/book/index.html, no server needed
  cargo xtask book --open    and show it in the browser")]
pub(crate) struct Arguments {
    /// Show the book in the browser
    #[arg(long)]
    open: bool,
    /// Where to put the book
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Leave speed and error out if no report is kept, and measure nothing
    #[arg(long)]
    unmeasured: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Outcome {
    let report = if arguments.unmeasured { Report::kept() } else { Some(report::kept_or_quick()?) };
    let summary = build_book(arguments.out.clone(), report)?;
    console::print(&format!("{}\n", files::shown(&summary.index)))?;
    console::say(&format!(
        "{} chapters, {} formulas, {} listings in {:.1} s",
        summary.chapters,
        summary.formulas,
        summary.listings,
        summary.elapsed.as_secs_f64()
    ));
    if arguments.open {
        open(&summary.index)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Builds the book, and lists all that is wrong with it if it is.
pub(crate) fn build_book(out: Option<PathBuf>, report: Option<Report>) -> anyhow::Result<Summary> {
    let out = out.or_else(|| files::target().parent().map(|target| target.join("book")));
    build(files::root(), &Options { out }, content(report)?).map_err(|error| match error.downcast::<Faults>() {
        Ok(faults) => anyhow::anyhow!("the book cannot be built\n{faults}"),
        Err(error) => error,
    })
}

fn open(index: &Path) -> anyhow::Result<()> {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let shown = index.display();
    Command::new(opener)
        .arg(index)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .with_context(|| format!("cannot run {opener}; open {shown} by hand"))?;
    Ok(())
}

fn content(report: Option<Report>) -> anyhow::Result<Content> {
    let mut sources = Vec::new();
    for directory in ["src", "tests"] {
        read_sources(&files::root().join(directory), &mut sources)?;
    }
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    let index = Index::new(&sources);
    let evidence = Evidence::load();
    let statements = statements::book::Named::read()?;
    let entry_of = |formula: &&dyn AnyFormula| Entry {
        statements: statements.of(formula.spec().id),
        ..entry(*formula, &index, &evidence)
    };
    let entries = CATALOG.iter().map(entry_of).collect();
    let catalog_tests = index.tests_over_catalog();
    let mut golden = Vec::new();
    for formula in CATALOG {
        let name = format!("{}.json", formula.spec().id);
        let path = files::root().join("golden").join(&name);
        // A formula without its file is an off of `golden --check`; the entry says so.
        if let Ok(bytes) = std::fs::read(path) {
            golden.push(GoldenFile { name, bytes });
        }
    }
    let mut outputs = vec![("audit".to_owned(), crate::audit::text(&[worked_example::run()], Audit::passed)?)];
    outputs.extend(figures::outputs());
    outputs.extend(scene::outputs()?);
    for (_, text) in &mut outputs {
        *text = plain(text);
    }
    let figures = [figures::all(), scene::figures()?].concat();
    let (texts, kinds) = (statements::book::texts()?, scene::kinds());
    Ok(Content { entries, sources, catalog_tests, figures, texts, outputs, report, golden, kinds })
}

/// Text without colours.
fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

fn read_sources(path: &Path, sources: &mut Vec<SourceFile>) -> anyhow::Result<()> {
    if path.is_dir() {
        for entry in std::fs::read_dir(path).with_context(|| format!("cannot list {}", path.display()))? {
            read_sources(&entry?.path(), sources)?;
        }
    } else if path.extension().is_some_and(|extension| extension == "rs") {
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        sources.push(SourceFile { path: files::shown(path).replace('\\', "/"), text });
    }
    Ok(())
}

fn entry(formula: &dyn AnyFormula, index: &Index<'_>, evidence: &Evidence) -> Entry {
    let spec = formula.spec();
    let (file, type_name) = place(formula.path());
    let golden = std::fs::read_to_string(files::root().join("golden").join(format!("{}.json", spec.id)));
    let checked = evidence.golden.get(spec.id);
    Entry {
        id: spec.id.into(),
        title: spec.title.into(),
        latex: spec.latex.into(),
        source: Source {
            name: spec.source.title.into(),
            citation: spec.source.title.into(),
            place: format!("section “{}”", spec.source.section),
        },
        inputs: formula.inputs().iter().map(symbol).collect(),
        outputs: formula.outputs().iter().map(symbol).collect(),
        statements: Vec::new(),
        kinks: formula.kinks().iter().map(|entry| kink(entry, formula.outputs())).collect(),
        code: index.functions(&file, type_name, &["eval", "jacobian", "linearized"]),
        tests: index.tests_naming(spec.id, type_name),
        golden: golden.ok().and_then(|text| File::parse(&text).ok()).map(|file| counts(&file)),
        evidence: super::content::Evidence {
            golden_cases: checked.filter(|check| check.same).map(|check| check.cases),
            audit: evidence.audits.get(spec.id).cloned(),
        },
    }
}

/// The file and name of a type from its path: `jointproof::slot::friction::Friction` is in `src/slot/friction.rs`.
fn place(path: &str) -> (String, &str) {
    let (modules, name) = path.rsplit_once("::").unwrap_or(("", path));
    let modules: Vec<_> = modules.split("::").skip(1).collect();
    (format!("src/{}.rs", modules.join("/")), name)
}

fn symbol(field: &Field) -> Symbol {
    let quantity = field.quantity;
    let shape = match quantity.shape {
        Shape::Scalar => "scalar",
        Shape::Vec2 => "vec2",
        Shape::Vec3 => "vec3",
        Shape::Mat3 => "mat3",
    };
    Symbol {
        name: field.name.into(),
        latex: quantity.latex.into(),
        shape: shape.into(),
        unit: quantity.unit.to_string(),
        allowed: quantity.domain.allowed(),
        meaning: quantity.meaning.into(),
    }
}

/// The kink as the output that bends most shows it.
fn kink(entry: &KinkEntry, outputs: &[Field]) -> Kink {
    let names = outputs.iter().flat_map(|field| vec![field; field.len()]);
    let jump = |[below, above]: &[f64; 2]| (above - below).abs();
    let bent = names.zip(&entry.one_sided).max_by(|(_, a), (_, b)| jump(a).total_cmp(&jump(b)));
    let Some((output, [below, above])) = bent else { return Kink::default() };
    let convention = match entry.convention {
        Convention::Subgradient => "0 is returned, the subgradient of least norm",
        Convention::Switch => "the value is defined; the Jacobian is one-sided and left out of the golden file",
        Convention::Cut => "the value jumps by a whole turn there, its derivative does not",
    };
    Kink {
        at: format!("${}$", entry.condition),
        derivative: format!("the derivative of ${}$ across it", output.quantity.latex),
        left: four_digits(*below),
        right: four_digits(*above),
        convention: convention.into(),
    }
}

/// To four decimals, without zeros that say nothing, with a true minus sign. A difference over a step of 1e-40 that is
/// this large has no limit.
fn four_digits(x: f64) -> String {
    if x.abs() > 1e15 {
        return "without bound".into();
    }
    ((x * 1e4).round() / 1e4).to_string().replace('-', "−")
}

fn counts(file: &File) -> GoldenCounts {
    let mut flags: Vec<(String, usize)> = Vec::new();
    for flag in file.cases.iter().flat_map(|case| &case.flags) {
        let name = flag.name();
        match flags.iter_mut().find(|(present, _)| present == name) {
            Some((_, count)) => *count += 1,
            None => flags.push((name.into(), 1)),
        }
    }
    GoldenCounts { file: format!("{}.json", file.formula), total: file.cases.len(), flags }
}
