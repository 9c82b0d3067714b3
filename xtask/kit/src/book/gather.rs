//! Gathers the content of the book from the catalog, the sources, the golden files and the executed checks.

use super::calculator;
use super::content::{
    self, Calculator, Cited, CodeSpan, Content, Entry, GoldenCounts, GoldenFile, Kink, SourceFile, Symbol,
};
use super::locate::Index;
use super::sheet;
use super::worked;
use crate::evidence::Evidence;
use crate::export;
use crate::files::short_digest;
use crate::project::Project;
use crate::prove;
use crate::report::data::Report;
use anyhow::Context;
use jointproof::catalog::{AnyFormula, KinkEntry};
use jointproof::formula::proof::Convention;
use jointproof::formula::quantity::Shape;
use jointproof::formula::{Field, Given, Source};
use jointproof::toolkit::equation::View;
use jointproof::toolkit::verify::golden::File;
use jointproof::toolkit::verify::{Rank, Sides};
use mdbook_driver::config::Config;
use rayon::prelude::*;
use std::path::Path;

/// The content of a project's book.
pub(crate) fn content(project: &Project, report: Option<Report>) -> anyhow::Result<Content> {
    let mut sources = Vec::new();
    for folder in ["src", "tests"].map(|name| project.root().join(name)).iter().filter(|folder| folder.exists()) {
        read_sources(project, folder, &mut sources)?;
    }
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    let index = Index::new(&sources);
    let evidence = Evidence::load(project);
    let mut entries: Vec<_> =
        project.catalog().iter().map(|formula| entry(project, *formula, &index, &evidence)).collect();
    for (entry, calculator) in entries.iter_mut().zip(calculators(project)) {
        entry.calculator = calculator;
    }
    let catalog_tests = index.tests_over_catalog();
    let mut golden = Vec::new();
    for formula in project.catalog() {
        // A missing golden file is reported by `golden --check`, and by the entry.
        if let Ok(bytes) = std::fs::read(project.golden_file(formula.spec().id)) {
            golden.push(GoldenFile { name: format!("{}.json", formula.spec().id), bytes });
        }
    }
    for element in project.elements() {
        let name = format!("elements/{}.json", element.spec().id);
        if let Ok(bytes) = std::fs::read(project.golden().join(&name)) {
            golden.push(GoldenFile { name, bytes });
        }
    }
    let sheets = project.elements().par_iter().filter_map(|element| sheet::of(project, *element)).collect();
    let mut extras = project.extension.extras.map(|extras| extras(project)).transpose()?.unwrap_or_default();
    for (_, text) in &mut extras.outputs {
        *text = plain(text);
    }
    let is_current = report.as_ref().is_some_and(|report| report.is_current(project));
    let cited = cited(project);
    let downloads = export::downloads(project);
    Ok(Content { entries, sources, catalog_tests, extras, report, is_current, golden, sheets, downloads, cited })
}

/// Text without colours.
fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

fn read_sources(project: &Project, path: &Path, sources: &mut Vec<SourceFile>) -> anyhow::Result<()> {
    if path.is_dir() {
        for entry in std::fs::read_dir(path).with_context(|| format!("cannot list {}", path.display()))? {
            read_sources(project, &entry?.path(), sources)?;
        }
    } else if path.extension().is_some_and(|extension| extension == "rs") {
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        sources.push(SourceFile { path: project.shown(path).replace('\\', "/"), text });
    }
    Ok(())
}

/// The functions of a formula in the sources of its project; none if a macro defines it.
pub(crate) fn functions(project: &Project, formula: &dyn AnyFormula) -> anyhow::Result<Vec<CodeSpan>> {
    let mut sources = Vec::new();
    for file in files(formula.path()) {
        let path = project.root().join("src").join(file);
        if path.exists() {
            read_sources(project, &path, &mut sources)?;
        }
    }
    let type_name = formula.path().rsplit("::").next().unwrap_or_default();
    Ok(code(&Index::new(&sources), formula.path(), type_name))
}

/// The calculator of each formula. Recording the formulas takes a while.
fn calculators(project: &Project) -> Vec<Calculator> {
    let of = |formula: &&'static dyn AnyFormula| {
        let golden = std::fs::read_to_string(project.golden_file(formula.spec().id)).ok();
        calculator::of(*formula, golden.and_then(|text| File::parse(&text).ok()).as_ref())
    };
    project.catalog().par_iter().map(of).collect()
}

fn entry(project: &Project, formula: &dyn AnyFormula, index: &Index<'_>, evidence: &Evidence) -> Entry {
    let spec = formula.spec();
    let type_name = formula.path().rsplit("::").next().unwrap_or_default();
    let text = std::fs::read_to_string(project.golden_file(spec.id)).ok();
    let golden = text.as_ref().and_then(|text| File::parse(text).ok());
    let checked = evidence.golden.get(spec.id);
    // An equation that cannot be read is reported by the audit.
    let view = View::of(&formula.signature()).ok().flatten();
    Entry {
        id: spec.id.into(),
        title: spec.title.into(),
        latex: spec.latex.into(),
        given: given(spec.given),
        closed: view.as_ref().map(|view| view.closed.clone()).unwrap_or_default(),
        variation: view.map(|view| view.variation).unwrap_or_default(),
        uses: uses(spec.given),
        digest: text.map(short_digest),
        worked: golden.as_ref().and_then(|golden| worked::of(formula, golden)),
        source: source(spec.source),
        inputs: formula.inputs().iter().map(symbol).collect(),
        outputs: formula.outputs().iter().map(symbol).collect(),
        kinks: formula.kinks().iter().map(|entry| kink(entry, [formula.inputs(), formula.outputs()])).collect(),
        accuracy: prove::accuracy(project, formula, evidence.audits.get(spec.id)),
        not_proved: prove::reasons(project, formula),
        code: code(index, formula.path(), type_name),
        tests: index.tests_naming(spec.id, type_name),
        golden: golden.as_ref().map(counts),
        evidence: content::Evidence {
            golden_cases: checked.filter(|check| check.same).map(|check| check.cases),
            audit: evidence.audits.get(spec.id).cloned(),
        },
        calculator: Calculator::Absent,
    }
}

/// The data for citing entries: the authors of the book, and the first version in the manifest.
fn cited(project: &Project) -> Option<Cited> {
    let mut config = Config::from_disk(project.root().join("book/book.toml")).ok()?;
    config.update_from_env().ok()?;
    let manifest = std::fs::read_to_string(project.root().join("Cargo.toml")).ok()?;
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'))?;
    let citation = std::fs::read_to_string(project.root().join("CITATION.cff")).unwrap_or_default();
    let released = citation.lines().find_map(|line| line.strip_prefix("date-released: "));
    let year = released.and_then(|date| date.get(..4)).unwrap_or_default();
    Some(Cited {
        book: project.name().into(),
        authors: config.book.authors.join(" and "),
        version: version.into(),
        year: year.into(),
        site: site(&config),
    })
}

/// Where the book is published, with all its versions: the `site-url` of its configuration, if that is a URL.
fn site(config: &Config) -> String {
    let site: Option<String> = config.get("output.html.site-url").ok().flatten();
    let site = site.filter(|site| site.starts_with("http")).unwrap_or_default();
    if site.is_empty() || site.ends_with('/') { site } else { site + "/" }
}

/// The formulas that symbols are taken from, each once.
fn uses(given: &[Given]) -> Vec<String> {
    let mut ids: Vec<String> = Vec::new();
    for given in given {
        if !ids.iter().any(|id| id == given.from.id) {
            ids.push(given.from.id.into());
        }
    }
    ids
}

/// "where F_C from slot.contact_force"
fn given(given: &[Given]) -> String {
    let from = |given: &Given| format!("${}$ from `{}`", given.symbols, given.from.id);
    let all: Vec<_> = given.iter().map(from).collect();
    if all.is_empty() { String::new() } else { format!("where {}", all.join(", ")) }
}

fn source(source: Source) -> content::Source {
    let place = if source.section.is_empty() { String::new() } else { format!("section “{}”", source.section) };
    content::Source {
        title: source.document.title.into(),
        link: source.document.link.into(),
        place,
        provenance: source.provenance.to_string(),
    }
}

/// The functions of a formula, located by the path of its type: `jointproof::connector::slot::friction::Friction` is
/// in `src/connector/slot/friction.rs`, in the `mod.rs` of that folder, or, if there are no modules in the path, in
/// the crate's root file.
fn code(index: &Index<'_>, path: &str, type_name: &str) -> Vec<CodeSpan> {
    let spans = |file: &String| index.functions(&format!("src/{file}"), type_name, &["eval", "jacobian", "linearized"]);
    files(path).iter().map(spans).find(|spans| !spans.is_empty()).unwrap_or_default()
}

/// The files below `src` in which the type with this path may be defined.
fn files(path: &str) -> [String; 4] {
    let (modules, _) = path.rsplit_once("::").unwrap_or_default();
    let modules: Vec<_> = modules.split("::").skip(1).collect();
    let module = modules.join("/");
    [format!("{module}.rs"), format!("{module}/mod.rs"), "lib.rs".into(), "main.rs".into()]
}

fn symbol(field: &Field) -> Symbol {
    let quantity = field.quantity;
    let shape = match quantity.shape {
        Shape::Scalar => "scalar",
        Shape::Vec2 => "vec2",
        Shape::Vec3 => "vec3",
        Shape::Mat2 => "mat2",
        Shape::Mat3 => "mat3",
    };
    Symbol {
        name: field.name.into(),
        latex: quantity.latex.into(),
        shape: shape.into(),
        unit: quantity.unit.to_string().replace("^2", "²").replace("^3", "³"),
        allowed: quantity.domain.allowed(),
        meaning: quantity.meaning.into(),
    }
}

/// The kink, described by the output and the input with the largest jump.
fn kink(entry: &KinkEntry, [inputs, outputs]: [&[Field]; 2]) -> Kink {
    let convention = match entry.convention {
        Convention::Subgradient => "0 is returned, the subgradient of least norm",
        Convention::Switch => "the value is defined; the Jacobian is one-sided and not in the golden file",
        Convention::Cut => "the value jumps by a full turn, the derivative does not",
    };
    let Some(Sides { rank, output, input, sides: [below, above] }) = entry.sides else { return Kink::default() };
    let (output, input) = (component(outputs, output), component(inputs, input));
    let derivative = match rank {
        Rank::Value => format!("the value of ${output}$, along ${input}$"),
        Rank::Slope => format!(r"$\partial {output}/\partial {input}$"),
        Rank::Curvature => format!(r"$\partial^2 {output}/\partial {input}^2$"),
    };
    Kink {
        at: format!("${}$", entry.condition),
        derivative,
        left: four_digits(below),
        right: four_digits(above),
        convention: convention.into(),
    }
}

/// The symbol of the component at this index: `f_1`, or `(\mathbf{n})_2` for the second one of **n**.
fn component(fields: &[Field], mut place: usize) -> String {
    for field in fields {
        if place < field.len() {
            let latex = field.quantity.latex;
            return if field.len() == 1 { latex.into() } else { format!("({latex})_{{{}}}", place + 1) };
        }
        place -= field.len();
    }
    unreachable!("a place is below the number of components")
}

/// Rounded to four decimals, without trailing zeros, with a true minus sign.
fn four_digits(x: f64) -> String {
    if x.is_infinite() {
        return "unbounded".into();
    }
    // A negative zero is written as 0.
    ((x * 1e4).round() / 1e4 + 0.0).to_string().replace('-', "−")
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

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;
    use jointproof::formula::proof::Flag;
    use jointproof::toolkit::verify::golden::Record;

    fn entry_of(formula: &dyn AnyFormula) -> Entry {
        let project = Project::new("gather", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("../..");
        entry(&project, formula, &Index::new(&[]), &Evidence::default())
    }

    fn find(id: &str) -> &'static dyn AnyFormula {
        jointproof::catalog::find(id).unwrap_or_else(|| panic!("there is no {id}"))
    }

    /// Each column contains the field of the catalog with its name, not a neighbouring one.
    #[test]
    fn symbols_are_those_of_the_fields() {
        for formula in CATALOG {
            for field in formula.inputs().iter().chain(formula.outputs()) {
                let quantity = field.quantity;
                let Symbol { name, latex, shape, unit, allowed, meaning } = symbol(field);
                assert_eq!(
                    (name.as_str(), latex.as_str(), meaning.as_str()),
                    (field.name, quantity.latex, quantity.meaning)
                );
                let dimensions = quantity.shape.dimensions();
                let kind = if dimensions.len() == 2 { "mat" } else { "vec" };
                let expected = dimensions.first().map_or("scalar".into(), |count| format!("{kind}{count}"));
                assert_eq!((shape, allowed), (expected, quantity.domain.allowed()));
                assert_eq!(unit.replace('²', "^2").replace('³', "^3"), quantity.unit.to_string());
            }
        }
    }

    #[test]
    fn sides_of_a_kink_are_in_the_order_of_the_input() {
        let of = |id: &str| entry_of(find(id)).kinks;
        let abs = &of("slot.friction")[0];
        let Kink { at, derivative, left, right, .. } = abs;
        assert_eq!((at.as_str(), left.as_str(), right.as_str()), ("$f_1 = 0$", "−1", "1"));
        assert_eq!(derivative, r"$\partial P/\partial f_1$");
        for formula in CATALOG {
            for (shown, known) in entry_of(*formula).kinks.iter().zip(formula.kinks()) {
                let Some(Sides { sides, .. }) = known.sides else { panic!("{}: {known:?}", formula.spec().id) };
                assert_eq!(
                    [&shown.left, &shown.right].map(String::as_str),
                    sides.map(four_digits).each_ref().map(String::as_str)
                );
                assert_eq!(shown.at, format!("${}$", known.condition));
            }
        }
    }

    #[test]
    fn golden_cases_are_counted_by_what_they_are_for() {
        let formula = find("slot.contact_force");
        let file = formula.golden();
        let GoldenCounts { total, flags, .. } = entry_of(formula).golden.expect("it is committed");
        assert_eq!(total, file.cases.len());
        for flag in [Flag::Hand, Flag::Hard, Flag::Random, Flag::Invalid, Flag::Kink] {
            let with = file.cases.iter().filter(|case: &&Record| case.flags.contains(&flag)).count();
            let shown = flags.iter().find(|(name, _)| name == flag.name()).map_or(0, |(_, count)| *count);
            assert_eq!(shown, with, "{flag:?}");
        }
    }

    #[test]
    fn numbers_have_four_decimals_at_most_and_components_their_place() {
        let shown = [0.0, -0.0, 0.25, -1.0 / 3.0, 12.0, 1e-9, f64::NEG_INFINITY].map(four_digits);
        assert_eq!(shown, ["0", "0", "0.25", "−0.3333", "12", "0", "unbounded"]);
        let fields = find("slide_line.basis").inputs();
        let count: usize = fields.iter().map(Field::len).sum();
        let names: Vec<_> = (0..count).map(|place| component(fields, place)).collect();
        let expected = fields.iter().flat_map(|field| {
            let latex = field.quantity.latex;
            let of_many = move |k| format!("({latex})_{{{k}}}");
            if field.len() == 1 { vec![latex.to_owned()] } else { (1..=field.len()).map(of_many).collect() }
        });
        assert_eq!(names, expected.collect::<Vec<_>>());
    }

    #[test]
    fn formulas_are_named_once_however_many_symbols_are_from_them() {
        for formula in CATALOG {
            let all = formula.spec().given;
            let [mut expected, mut found]: [Vec<String>; 2] =
                [all.iter().map(|given| given.from.id.to_owned()).collect(), uses(all)];
            let words: Vec<_> =
                all.iter().map(|given| format!("${}$ from `{}`", given.symbols, given.from.id)).collect();
            assert_eq!(given(all).strip_prefix("where ").unwrap_or_default(), words.join(", "));
            expected.sort();
            expected.dedup();
            found.sort();
            assert_eq!(found, expected, "{}", formula.spec().id);
        }
        assert_eq!((given(&[]).as_str(), uses(&[]).len()), ("", 0));
    }

    /// A golden check with a difference is no evidence, nor is a missing one.
    #[test]
    fn only_what_was_executed_and_the_same_is_evidence() {
        let project = Project::new("gather", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("../..");
        let formula = find("slot.stop");
        for (same, cases) in [(true, Some(5)), (false, None)] {
            let mut evidence = Evidence::default();
            evidence.golden.insert("slot.stop".into(), crate::evidence::GoldenCheck { cases: 5, same });
            let entry = entry(&project, formula, &Index::new(&[]), &evidence);
            assert_eq!((entry.evidence.golden_cases, entry.evidence.audit), (cases, None));
        }
    }
}
