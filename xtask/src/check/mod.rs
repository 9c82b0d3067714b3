//! `check`: a program of somebody else's, in any language, asked over a pipe and judged.

mod answer;
mod diagnosis;
mod driver;
mod json;
mod map;
mod peer;
mod process;
mod question;
mod report;
mod verdict;

use crate::console::{print, progress};
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use answer::{Answer, Digits, Manners};
use driver::{Driver, Lang};
use jointproof::catalog::AnyFormula;
use jointproof::verify::Options;
use jointproof::verify::golden::components;
use peer::{Peer, Replies, Reply};
use question::{Question, Wanted, of_points, other_order, questions, sizes};
use std::time::Duration;
use verdict::{Bounds, Court};

/// Check a program of your own, in any language, against a formula
///
/// The program reads lines and answers each with a line. A question is the inputs as numbers, in the order in which the
/// formula's entry lists them; an answer is the outputs, then the Jacobian row by row, or `refuse`. A number that it does not
/// compute is `-`. Every answer is flushed. Each number is judged by its backward error η against 237 bits, within the bounds
/// that the formula itself has to keep.
///
/// It is asked at golden cases, on and beside kinks, at random points and at what must be refused, and at all of these a second
/// time in another order. What is wrong with it is named if one mistake explains all that is seen.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} check --formula {formula} -- ./mine                     value and Jacobian
  {command} check --formula {formula} --wanted value -- python3 mine.py
  {command} check --formula {formula} --driver fortran > mine.f90   a program to put your code in
  {command} check --formula {formula} --json -- node mine.js        JSON lines
  {command} check --formula {formula} --point '{point}' -- ./mine")]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub(crate) struct Arguments {
    /// The formula, by its identifier
    #[arg(long, value_name = "ID")]
    formula: String,
    /// The program and its arguments, behind `--`
    #[arg(last = true, value_name = "PROGRAM", required_unless_present = "driver")]
    program: Vec<String>,
    /// Print a program in this language that answers, complete but for the call of your own code
    #[arg(long, value_enum, value_name = "LANGUAGE", conflicts_with = "program")]
    driver: Option<Lang>,
    /// In a driver, call what `export` prints, as an example of what passes
    #[arg(long, requires = "driver")]
    exported: bool,
    /// What the program answers
    #[arg(long, value_enum, default_value_t)]
    wanted: Wanted,
    /// Numbers are the 16 hexadecimal digits of their bits
    #[arg(long, conflicts_with = "json")]
    hex: bool,
    /// Questions and answers are JSON, one a line
    #[arg(long)]
    json: bool,
    /// Random points, beside the named ones
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
    /// Seed of the random points
    #[arg(long, value_name = "S", default_value_t = Options::default().seed)]
    seed: u64,
    /// How long an answer may take
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    limit: f64,
    /// Other bounds of η than the formula's own: of the value, and of the Jacobian
    #[arg(long, value_name = "BOUND", num_args = 1..=2, value_delimiter = ',')]
    eta: Vec<f64>,
    /// Do not ask at what must be refused
    #[arg(long)]
    valid_only: bool,
    /// Ask at this point only: the inputs as a JSON object, as golden files and reports give them
    #[arg(long, value_name = "JSON")]
    point: Option<String>,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    let formula = formula(project, &arguments.formula)?;
    if let Some(lang) = arguments.driver {
        print(&driver(formula, arguments, lang)?)?;
        return Ok(verdict(true));
    }
    let limit = Duration::try_from_secs_f64(arguments.limit).ok().filter(|limit| !limit.is_zero());
    let limit = limit.ok_or_else(|| Usage("--limit is not a time above 0 in seconds".into()))?;
    let mut questions = asked(formula, arguments)?;
    if arguments.valid_only {
        questions.retain(|question| !question.must_be_refused());
    }
    let spec = formula.spec();
    let [value, jacobian] = match *arguments.eta.as_slice() {
        [both] => [both; 2],
        [value, jacobian, ..] => [value, jacobian],
        [] => [spec.eta, spec.eta_jacobian],
    };
    let bounds = Bounds { value, jacobian };
    let court = Court { formula, wanted: arguments.wanted, bounds, questions: &questions };
    let (answers, heard) = match listen(formula, arguments, limit, &questions)? {
        Ok(heard) => heard,
        Err(why) => {
            print(&report::silent(&court, &arguments.program, &why))?;
            return Ok(verdict(false));
        }
    };
    let found = court.judge(&answers);
    let causes = diagnosis::diagnose(&court, &answers, &found);
    print(&report::text(&court, &arguments.program, &found, &heard, &causes))?;
    Ok(verdict(found.is_well()))
}

fn driver(formula: &'static dyn AnyFormula, arguments: &Arguments, lang: Lang) -> anyhow::Result<String> {
    let driver = Driver::new(formula, arguments.wanted, arguments.exported);
    let driver = driver.ok_or_else(|| Usage("--driver is for a value or a Jacobian, not for products".into()))?;
    let text = driver.text(lang);
    Ok(text.ok_or_else(|| Usage("--exported: nothing is exported to this language".into()))?)
}

fn formula(project: &Project, id: &str) -> anyhow::Result<&'static dyn AnyFormula> {
    project.find(id).ok_or_else(|| {
        let ids: Vec<_> = project.catalog().iter().map(|formula| formula.spec().id).collect();
        Usage(format!("--formula '{id}' is no formula; there are\n  {}", ids.join("\n  "))).into()
    })
}

fn asked(formula: &dyn AnyFormula, arguments: &Arguments) -> anyhow::Result<Vec<Question>> {
    let Some(point) = &arguments.point else {
        let options = Options { samples: arguments.samples, seed: arguments.seed };
        return Ok(questions(formula, arguments.wanted, &options));
    };
    let names = || formula.inputs().iter().map(|field| field.name).collect::<Vec<_>>().join(", ");
    let inputs = serde_json::from_str(point)
        .map_err(|error| Usage(format!("--point is not a JSON object of {}: {error}", names())))?;
    let inputs = components(formula.inputs(), &inputs).map_err(|error| Usage(format!("--point: {error}")))?;
    Ok(of_points(formula, arguments.wanted, vec![("given".into(), inputs)], arguments.seed))
}

/// How a program answered, beside what.
#[derive(Debug, Default)]
struct Heard {
    manners: Manners,
    noticed: Vec<String>,
}

/// What the program answers the first and the second time, or why it answers nothing.
type Listened = Result<([Vec<Answer>; 2], Heard), String>;

/// Asks everything twice, the second time in another order.
fn listen(
    formula: &dyn AnyFormula,
    arguments: &Arguments,
    limit: Duration,
    questions: &[Question],
) -> anyhow::Result<Listened> {
    let again = other_order(questions.len());
    let order: Vec<usize> = (0..questions.len()).chain(again).collect();
    let digits = if arguments.hex { Digits::Hex } else { Digits::Decimal };
    let numbers = arguments.wanted.numbers(sizes(formula));
    let line = |(k, &place): (usize, &usize)| {
        if arguments.json { json::question(formula, k, &questions[place]) } else { questions[place].line(digits) }
    };
    let lines: Vec<_> = order.iter().enumerate().map(line).collect();
    let head = arguments.json.then(|| json::head(formula, arguments.wanted));
    let peer = Peer { command: &arguments.program, limit, head, numbers, digits };
    let bar = progress("check", 1);
    let replies = peer.ask(&lines)?;
    bar.finish_and_clear();
    let Replies { replies, noticed } = match replies {
        Ok(replies) => replies,
        Err(why) => return Ok(Err(why)),
    };
    let mut heard = Heard { manners: Manners::new(), noticed: noticed.into_iter().collect() };
    let mut answers = [(); 2].map(|()| vec![Answer::Skipped(String::new()); questions.len()]);
    for (k, (reply, &place)) in replies.into_iter().zip(&order).enumerate() {
        let answer = match reply {
            Reply::Line(line) if arguments.json => json::read(formula, arguments.wanted, k, &line),
            Reply::Line(line) => answer::read(&line, numbers, digits, &mut heard.manners),
            Reply::Hangs => Answer::Bad("no answer within the limit".into()),
            Reply::Ends(how) => Answer::Bad(how),
            Reply::NotAsked => Answer::Skipped("not asked any more".into()),
        };
        answers[usize::from(k >= questions.len())][place] = answer;
    }
    Ok(Ok((answers, heard)))
}
