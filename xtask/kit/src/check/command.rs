//! `check`: calls someone else's program, in any language, through a pipe and judges it.

use super::driver::abi::Abi;
use super::driver::{self, Driver, Lang};
use super::listen::{Manner, listen};
use super::{Said, derivative, element};
use crate::console::print;
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use crate::review::{Finding, Place, annotations, rdjson, sarif, summarise};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::verify::Options;
use jointproof::toolkit::verify::golden::components;
use judge::{Bounds, Court, Question, Wanted, of_points, questions};
use serde_json::json;
use std::path::PathBuf;
use std::time::Duration;

/// Check a program of your own, in any language, against a formula
///
/// The program reads lines from standard input and answers each with one line. An input line has the inputs as numbers, in
/// the order of the formula's entry. The answer has the outputs, then the Jacobian row by row, or `refuse`; `-` stands for a
/// number that is not computed. Every answer must be flushed.
///
/// The verdict has parts, and none hides another: whether it is the same function, at points of ordinary sizes; how accurate it
/// is, in digits lost; up to which sizes it works; what it does on kinks, where any one-sided derivative is right; and what it
/// does with inputs that are not allowed. The program is right, and the exit code 0, if it is the same function, also on kinks.
/// Limits are listed; --strict asks for our bounds at all sizes, our convention on kinks, and refusals.
///
/// The inputs are golden cases, points on and next to kinks, random points, a ladder of sizes and invalid inputs; then all of them
/// again in another order. Mistakes are named if one or two known ones explain the answers.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} check --formula {formula} -- ./mine                     value and Jacobian
  {command} check --formula {formula} --wanted value -- python3 mine.py
  {command} check --formula {formula} --driver fortran > mine.f90   to begin with
  {command} check --formula {formula} --json -- node mine.js        JSON lines
  {command} check --formula {formula} --format github --at mine.f90:40 -- ./mine
  {command} check --derivative element.toml --out around    any UEL or FRIC
  {command} check --derivative element.toml -- ./a.out      AMATRX against RHS
  {command} check --element translator --abi uel --out around
  {command} check --element translator --strict -- ./a.out
  {command} check --formula {formula} --point '{point}' -- ./mine")]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub(crate) struct Arguments {
    /// The formula, by its identifier
    #[arg(
        long,
        value_name = "ID",
        required_unless_present_any = ["derivative", "element"],
        default_value = "",
        hide_default_value = true
    )]
    formula: String,
    /// Check the matrix of any routine against the derivative of its own value, without a formula; the file says how it is
    /// called and at which state
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = ["formula", "element", "driver", "abi", "exported", "wanted", "hex", "json", "samples", "seed", "strict", "eta", "valid_only", "point"]
    )]
    derivative: Option<PathBuf>,
    /// Check a UEL against this element, by its identifier: its forces, conditions, stiffness and states
    #[arg(
        long,
        value_name = "ID",
        conflicts_with_all = ["formula", "driver", "exported", "wanted", "hex", "json", "samples", "seed", "eta", "valid_only", "point"]
    )]
    element: Option<String>,
    /// The program and its arguments, after `--`
    #[arg(last = true, value_name = "PROGRAM", required_unless_present_any = ["driver", "abi", "out"])]
    program: Vec<String>,
    /// Print a program in this language to start from; only the call of your own code is missing
    #[arg(long, value_enum, value_name = "LANGUAGE", conflicts_with = "program")]
    driver: Option<Lang>,
    /// Print a Fortran program that calls a routine with this interface
    #[arg(long, value_enum, value_name = "INTERFACE", conflicts_with_all = ["program", "driver"])]
    abi: Option<Abi>,
    /// Write that program to a folder, with ABA_PARAM.INC and with XIT and other utility routines to be linked
    #[arg(long, value_name = "FOLDER", conflicts_with = "program")]
    out: Option<PathBuf>,
    /// In a driver, call the exported formula, as an example that passes
    #[arg(long, requires = "driver")]
    exported: bool,
    /// What the program answers
    #[arg(long, value_parser = wanted())]
    wanted: Option<Wanted>,
    /// Numbers are the 16 hexadecimal digits of their bits
    #[arg(long, conflicts_with = "json")]
    hex: bool,
    /// Inputs and answers are JSON, one object per line
    #[arg(long)]
    json: bool,
    /// Random points, in addition to the named ones
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
    /// Seed of the random points
    #[arg(long, value_name = "S", default_value_t = Options::default().seed)]
    seed: u64,
    /// Time limit of an answer; four times this for the first one
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    limit: f64,
    /// Ask for our bounds at all sizes, our convention on kinks, and refusals of what is not allowed
    #[arg(long)]
    strict: bool,
    /// Bounds of η instead of the formula's own: for the value, and for the Jacobian; they are asked for as with --strict
    #[arg(long, value_name = "BOUND", num_args = 1..=2, value_delimiter = ',')]
    eta: Vec<f64>,
    /// Do not send invalid inputs
    #[arg(long)]
    valid_only: bool,
    /// Format of the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// File and line of your routine, for formats that need a location
    #[arg(long, value_name = "FILE[:LINE]", value_parser = at, required_if_eq_any([("format", "github"), ("format", "sarif"), ("format", "rdjson")]))]
    at: Option<Place>,
    /// Test this point only: its inputs as a JSON object, as in golden files and reports
    #[arg(long, value_name = "JSON")]
    point: Option<String>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// For a terminal
    #[default]
    Text,
    /// The parts of the verdict as JSON
    Json,
    /// Workflow commands: an annotation in a pull request, and the step's summary
    Github,
    /// SARIF 2.1.0, to be uploaded
    Sarif,
    /// RDFormat, for reviewdog
    Rdjson,
}

/// The results that can be requested, by name.
fn wanted() -> impl TypedValueParser<Value = Wanted> {
    let described = |wanted: Wanted| {
        PossibleValue::new(wanted.name()).help(match wanted {
            Wanted::Value => "The outputs alone",
            Wanted::Jacobian => "The outputs, then the Jacobian row by row",
            Wanted::Products => "The outputs, then J v and wᵀJ for directions v and w, which follow the inputs",
        })
    };
    PossibleValuesParser::new(Wanted::ALL.map(described))
        .map(|name| Wanted::ALL.into_iter().find(|wanted| wanted.name() == name).unwrap_or_default())
}

/// A file, with a line if a number follows the last colon.
#[expect(clippy::unnecessary_wraps, reason = "a parser of clap's")]
fn at(text: &str) -> Result<Place, String> {
    let split = text.rsplit_once(':').and_then(|(file, line)| Some((file, line.parse().ok()?)));
    let (file, line) = split.unwrap_or((text, 1));
    Ok(Place { file: file.to_owned(), line: line.max(1) })
}

impl Arguments {
    /// The requested results, or those exported for the formula: automatic Jacobians are not exported.
    fn wanted(&self, formula: &dyn AnyFormula) -> Wanted {
        let exported = if formula.spec().is_closed() { Wanted::Jacobian } else { Wanted::Value };
        self.wanted.unwrap_or(exported)
    }
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    let limit = Duration::try_from_secs_f64(arguments.limit).ok().filter(|limit| !limit.is_zero());
    let limit = limit.ok_or_else(|| Usage("--limit is not a time above 0 in seconds".into()))?;
    if let Some(id) = &arguments.element {
        return match arguments.abi {
            Some(Abi::Uel) => element::driver(project, id, arguments.out.as_deref()),
            Some(_) => Err(Usage("--element: elements are routines UEL: --abi uel".into()).into()),
            None => said(arguments, element::run(project, id, &arguments.program, limit, arguments.strict)?),
        };
    }
    if let Some(file) = &arguments.derivative {
        return match &arguments.out {
            Some(folder) => derivative::write_driver(file, folder),
            None => said(arguments, derivative::run(file, &arguments.program, limit)?),
        };
    }
    if arguments.out.is_some() && arguments.abi.is_none() {
        return Err(Usage("--out is for a driver: with --abi, or with --derivative FILE".into()).into());
    }
    let formula = project.named("--formula", &arguments.formula)?;
    if let Some(lang) = arguments.driver {
        print(&driver(formula, arguments, lang)?)?;
        return Ok(verdict(true));
    }
    if let Some(abi) = arguments.abi {
        print(&match &arguments.out {
            Some(folder) => driver::abi::write(abi, formula, folder)?,
            None => driver::abi::text(abi, formula)?,
        })?;
        return Ok(verdict(true));
    }
    let mut questions = asked(formula, arguments)?;
    if arguments.valid_only {
        questions.retain(|question| !question.must_be_refused());
    }
    let bounds = match *arguments.eta.as_slice() {
        [both] => Bounds { value: both, jacobian: both },
        [value, jacobian, ..] => Bounds { value, jacobian },
        [] => Bounds::of(formula),
    };
    let court = Court {
        formula,
        wanted: arguments.wanted(formula),
        bounds,
        questions: &questions,
        is_strict: arguments.strict || !arguments.eta.is_empty(),
    };
    let manner = Manner {
        program: &arguments.program,
        wanted: arguments.wanted(formula),
        is_json: arguments.json,
        is_hex: arguments.hex,
        limit,
    };
    let subject = arguments.formula.clone();
    let (answers, heard) = match listen(formula, &manner, &questions)? {
        Ok(heard) => heard,
        Err(why) => {
            let text = court.silent(&arguments.program, &why);
            let json = json!({ "formula": subject, "right": false, "causes": [why] });
            return said(arguments, Said { subject, is_well: false, text, json, claim: "it does not answer".into() });
        }
    };
    let judged = court.judged(&arguments.program, &answers, &heard);
    let claim = judged.causes.first().map_or("its answers are those of the formula", String::as_str).to_owned();
    said(arguments, Said { subject, is_well: judged.is_well(), text: judged.text, json: judged.json, claim })
}

/// Prints the result in the requested format.
fn said(arguments: &Arguments, said: Said) -> Outcome {
    let is_well = said.is_well;
    print(&written(arguments, said)?)?;
    Ok(verdict(is_well))
}

/// The result in the requested format; if all is well there is no finding.
fn written(arguments: &Arguments, Said { subject, is_well, text, json, claim }: Said) -> anyhow::Result<String> {
    if arguments.format == Format::Json {
        return Ok(serde_json::to_string_pretty(&json)? + "\n");
    }
    let Some(place) = arguments.at.clone().filter(|_| arguments.format != Format::Text) else {
        return Ok(text);
    };
    let message = anstream::adapter::strip_str(&text).to_string();
    let finding = Finding { formula: subject, claim, message, place };
    let findings: Vec<_> = (!is_well).then_some(finding).into_iter().collect();
    match arguments.format {
        Format::Sarif => sarif(&findings),
        Format::Rdjson => rdjson(&findings),
        Format::Text | Format::Json | Format::Github => {
            let first = text.lines().next().unwrap_or_default();
            let fenced =
                findings.iter().map(|finding| format!("```text\n{}```\n", finding.message)).collect::<Vec<_>>();
            summarise(&format!("{}\n\n{}", anstream::adapter::strip_str(first), fenced.concat()))?;
            Ok(annotations(&findings) + first + "\n")
        }
    }
}

fn driver(formula: &'static dyn AnyFormula, arguments: &Arguments, lang: Lang) -> anyhow::Result<String> {
    if arguments.exported && arguments.wanted(formula) == Wanted::Jacobian && !formula.spec().is_closed() {
        return Err(Usage("--exported: the Jacobian is automatic, and its value alone is exported".into()).into());
    }
    let driver = Driver::new(formula, arguments.wanted(formula), arguments.exported);
    let driver = driver.ok_or_else(|| Usage("--driver is for a value or a Jacobian, not for products".into()))?;
    let text = driver::text(&driver, lang);
    Ok(text.ok_or_else(|| Usage("--exported: nothing is exported to this language".into()))?)
}

fn asked(formula: &dyn AnyFormula, arguments: &Arguments) -> anyhow::Result<Vec<Question>> {
    let Some(point) = &arguments.point else {
        let options = Options { samples: arguments.samples, seed: arguments.seed };
        return Ok(questions(formula, arguments.wanted(formula), &options));
    };
    let names = || formula.inputs().iter().map(|field| field.name).collect::<Vec<_>>().join(", ");
    let inputs = serde_json::from_str(point)
        .map_err(|error| Usage(format!("--point is not a JSON object of {}: {error}", names())))?;
    let inputs = components(formula.inputs(), &inputs).map_err(|error| Usage(format!("--point: {error}")))?;
    Ok(of_points(formula, arguments.wanted(formula), vec![("given".into(), inputs)], arguments.seed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_has_a_line_from_1_on() {
        for (text, file, line) in [
            ("mine.f90", "mine.f90", 1),
            ("mine.f90:40", "mine.f90", 40),
            ("mine.f90:0", "mine.f90", 1),
            ("c:/mine.f90", "c:/mine.f90", 1),
            ("c:/mine.f90:7", "c:/mine.f90", 7),
        ] {
            let place = at(text).unwrap();
            assert_eq!((place.file.as_str(), place.line), (file, line), "{text}");
        }
    }
}
