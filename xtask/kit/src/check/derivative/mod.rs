//! `check --derivative`: the matrix of anybody's routine against the derivative of its own value, without a formula of ours.

mod causes;
mod compared;
mod driver;
mod quotients;
mod spec;
mod states;

use super::Said;
use super::driver::abi;
use super::line::Digits;
use super::peer::Peer;
use crate::console::{bold, count, green, print, red};
use crate::outcome::{Outcome, verdict};
use compared::{Answered, Compared, Table};
use judge::Answer;
use quotients::Slope;
use serde_json::{Value, json};
use spec::{Spec, Turning};
pub(super) use states::rotation;
use states::{Line, State, line, states};
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

/// The entries that are listed.
const SHOWN: usize = 6;

/// Writes the driver of a routine.
///
/// # Errors
/// A file that is not right, or that cannot be written.
pub(super) fn write_driver(file: &Path, folder: &Path) -> Outcome {
    let spec = Spec::read(file)?;
    let (name, text) = driver::text(&spec)?;
    print(&abi::write_text(name, &text, folder)?)?;
    Ok(verdict(true))
}

/// Compares the derivative of a program at the states of a file.
///
/// # Errors
/// A file that is not right, or a program that cannot be started.
pub(super) fn run(file: &Path, program: &[String], limit: Duration) -> anyhow::Result<Said> {
    let spec = Spec::read(file)?;
    let asked = Asked::new(&spec);
    let numbers = spec.outputs() * (spec.at.len() + 1);
    let peer = Peer { command: program, limit, head: None, numbers, digits: Digits::Decimal };
    let head = |mark: &str| format!("{mark} {} by {}", bold(file.display().to_string()), program.join(" "));
    let Report { is_well, text, mut json, claim } = match peer.answers(&asked.lines())? {
        Ok(answers) => report(&spec, &asked.compared(&answers)),
        Err(why) => Report { is_well: false, text: format!("{why}\n"), json: json!({ "causes": [why] }), claim: why },
    };
    let mark = if is_well { green("ok ") } else { red("off") };
    let subject = file.display().to_string();
    json["derivative"] = subject.as_str().into();
    json["right"] = is_well.into();
    Ok(Said { text: format!("{}: {text}", head(&mark)), subject, is_well, json, claim })
}

/// The points that are asked for.
struct Asked<'a> {
    spec: &'a Spec,
    states: Vec<State>,
    /// Of each state and input, the points along it, and those of the other way to rotate.
    lines: Vec<Vec<(Line, Option<Line>)>>,
}

/// What came of the states.
struct Found {
    compared: Vec<Compared>,
    /// States without an answer, and why.
    without: Vec<(String, String)>,
}

impl<'a> Asked<'a> {
    fn new(spec: &'a Spec) -> Self {
        let other = if spec.by == Turning::Spin { Turning::Vector } else { Turning::Spin };
        let states = states(spec);
        let of_input = |x: &[f64], input: usize| {
            let otherwise = spec.rotation(input).map(|_| line(spec, x, input, other));
            (line(spec, x, input, spec.by), otherwise)
        };
        let of_state = |state: &State| (0..spec.at.len()).map(|input| of_input(&state.x, input)).collect();
        let lines = states.iter().map(of_state).collect();
        Self { spec, states, lines }
    }

    /// Every point in order: of each state itself, its lines, and itself again.
    fn lines(&self) -> Vec<String> {
        let shown = |x: &Vec<f64>| x.iter().map(|&x| Digits::Decimal.show(x)).collect::<Vec<_>>().join(" ");
        let mut lines = Vec::new();
        for (state, of_state) in self.states.iter().zip(&self.lines) {
            lines.push(shown(&state.x));
            for (line, otherwise) in of_state {
                let points = [Some(line), otherwise.as_ref()]
                    .into_iter()
                    .flatten()
                    .flat_map(|line| line.points.iter().flatten());
                lines.extend(points.map(shown));
            }
            lines.push(shown(&state.x));
        }
        lines
    }

    fn compared(&self, answers: &[Answer]) -> Found {
        let mut next = answers.iter();
        let mut found = Found { compared: Vec::new(), without: Vec::new() };
        for (state, of_state) in self.states.iter().zip(&self.lines) {
            match self.at_state(state, of_state, &mut next) {
                Ok(compared) => found.compared.push(compared),
                Err(why) => found.without.push((state.name.clone(), why)),
            }
        }
        found
    }

    /// The comparison at a state; all its answers are taken, also if one is missing.
    fn at_state<'b>(
        &self,
        state: &State,
        of_state: &[(Line, Option<Line>)],
        next: &mut impl Iterator<Item = &'b Answer>,
    ) -> Result<Compared, String> {
        let outputs = self.spec.outputs();
        let first = numbers(next.next());
        let mut slopes = Vec::new();
        let mut others = Vec::new();
        for (line, otherwise) in of_state {
            let here = first.as_ref().map(|numbers| &numbers[..outputs]);
            let own = along(line, here, outputs, next);
            let other = otherwise.as_ref().map(|line| along(line, here, outputs, next));
            others.push(other.unwrap_or_else(|| own.clone()));
            slopes.push(own);
        }
        let last = numbers(next.next());
        let (first, last) = (first?, last?);
        let columns = self.spec.at.len();
        let table = |numbers: &[f64]| Table { columns, entries: numbers[outputs..].to_vec() };
        let found = [table(&first), table(&last)];
        let at = Answered { name: state.name.clone(), x: state.x.clone(), value: first[..outputs].to_vec(), found };
        let slopes = slopes.into_iter().collect::<Result<Vec<_>, _>>()?;
        let others = others.into_iter().collect::<Result<Vec<_>, _>>()?;
        let has_rotations = of_state.iter().any(|(_, otherwise)| otherwise.is_some());
        Ok(Compared::new(at, &slopes, has_rotations.then_some(&others[..]), &self.spec.sizes()))
    }
}

/// The numbers of an answer, or why there are none.
fn numbers(answer: Option<&Answer>) -> Result<Vec<f64>, String> {
    match answer {
        Some(Answer::Numbers(numbers)) => match numbers.iter().copied().collect::<Option<Vec<f64>>>() {
            Some(numbers) if numbers.iter().all(|x| x.is_finite()) => Ok(numbers),
            Some(_) => Err("a number is not finite".into()),
            None => Err("a number is not given".into()),
        },
        Some(Answer::Refused(_)) => Err("refused".into()),
        Some(Answer::Bad(what) | Answer::Skipped(what)) => Err(what.clone()),
        None => Err("no answer".into()),
    }
}

/// The slope of each output along a line. Steps without an answer, such as those that leave the domain, are left out, down to
/// half of all steps.
fn along<'b>(
    line: &Line,
    here: Result<&[f64], &String>,
    outputs: usize,
    next: &mut impl Iterator<Item = &'b Answer>,
) -> Result<Vec<Slope>, String> {
    let answers: Vec<_> = line.points.iter().map(|_| [numbers(next.next()), numbers(next.next())]).collect();
    let here = here.map_err(Clone::clone)?;
    let good: Vec<_> = answers
        .iter()
        .zip(&line.steps)
        .filter_map(|(pair, steps)| match pair {
            [Ok(after), Ok(before)] => Some(([after, before], *steps)),
            _ => None,
        })
        .collect();
    if 2 * good.len() < line.steps.len() {
        let why = answers.into_iter().flatten().find_map(Result::err);
        return Err(format!("beside it, {}", why.unwrap_or_default()));
    }
    let steps: Vec<_> = good.iter().map(|(_, steps)| *steps).collect();
    let slope = |output: usize| {
        let values: Vec<_> = good.iter().map(|(pair, _)| pair.map(|numbers| numbers[output])).collect();
        Slope::new(&steps, &values, here[output])
    };
    Ok((0..outputs).map(slope).collect())
}

/// The verdict with its text, as JSON, and in one sentence.
struct Report {
    is_well: bool,
    text: String,
    json: Value,
    claim: String,
}

fn report(spec: &Spec, found: &Found) -> Report {
    let names @ [value, input, name] = spec.names();
    let all = &found.compared;
    let matrix = name.trim_start_matches('-');
    let wrong: Vec<_> = all.iter().map(Compared::wrong).collect();
    let off = wrong.iter().filter(|wrong| !wrong.is_empty()).count();
    let states = count(all.len(), "state");
    let minus = if name.starts_with('-') { "minus " } else { "" };
    let faults: Vec<_> = found.without.iter().filter(|(_, why)| !why.ends_with("refused")).collect();
    let decided = all.iter().flat_map(|one| {
        let entries = 0..one.found().entries.len();
        entries
            .map(move |k| (k / one.found().columns, k % one.found().columns))
            .filter(move |&(r, c)| one.is_decided(r, c))
    });
    let decided = decided.count();
    let total: usize = all.iter().map(|one| one.found().entries.len()).sum();
    let is_well = off == 0 && faults.is_empty() && decided > 0;
    let [least, median] = digits(all);
    let claim = if all.is_empty() {
        "there is no state at which it answers".to_owned()
    } else if off > 0 {
        format!("{matrix} is not {minus}the derivative of {value} with respect to {input} at {off} of {states}")
    } else if decided == 0 {
        format!("no derivative could be determined at {states}")
    } else {
        format!(
            "{matrix} is {minus}the derivative of {value} with respect to {input} at {states}, to {least:.1} digits and more, {median:.1} in the median"
        )
    };
    let mut text = format!("{claim}\n");
    let cause = (off > 0).then(|| {
        let known = causes::cause(all, names, spec.by, spec.coords.first().map_or(1, Vec::len));
        let unknown = || format!("none of the known mistakes explains it; wrong are {matrix}{}", causes::place(all));
        known.unwrap_or_else(unknown)
    });
    let listed = listed(all, &wrong);
    if let Some(cause) = &cause {
        let _ = writeln!(text, "    cause: {cause}");
        list(&listed, spec.names(), &mut text);
    }
    if decided < total {
        let _ = writeln!(
            text,
            "    {} of {total} entries are not decided to eight digits: the quotients do not converge, as beside a kink or with large rounding",
            total - decided
        );
    }
    for one in all {
        for (row, column, [after, before]) in one.kinks.iter().take(SHOWN) {
            let _ = writeln!(
                text,
                "    kink at {}: d{value}({})/d{input}({}) is {before:.6} before it and {after:.6} behind; {matrix} has {:.6}",
                one.at.name,
                row + 1,
                column + 1,
                if name.starts_with('-') { -one.found().at(*row, *column) } else { one.found().at(*row, *column) }
            );
        }
    }
    for (state, why) in &found.without {
        let _ = writeln!(text, "    no answer at {state}: {why}");
    }
    let without = |(state, why): &(String, String)| json!({ "state": state, "why": why });
    let json = json!({
        "states": all.len(),
        "off": off,
        "digits": (decided > 0).then_some(json!({ "least": least, "median": median })),
        "entries": { "all": total, "decided": decided },
        "causes": cause.as_slice(),
        "wrong": listed,
        "without_answer": found.without.iter().map(without).collect::<Vec<_>>(),
    });
    Report { is_well, text, json, claim }
}

/// The least and the median number of digits.
fn digits(all: &[Compared]) -> [f64; 2] {
    let mut digits: Vec<_> = all
        .iter()
        .flat_map(|one| {
            let entries = (0..one.found().entries.len()).map(|k| (k / one.found().columns, k % one.found().columns));
            entries.filter(|&(r, c)| one.is_decided(r, c)).map(move |(r, c)| one.digits(r, c))
        })
        .collect();
    digits.sort_by(f64::total_cmp);
    [digits.first(), digits.get(digits.len() / 2)].map(|digits| digits.copied().unwrap_or_default())
}

/// A wrong entry of a matrix, in parts counted from 1; the derivative with the error of its quotients.
#[derive(serde::Serialize)]
struct Entry<'a> {
    row: usize,
    column: usize,
    found: f64,
    expected: f64,
    uncertainty: f64,
    state: &'a str,
}

/// The wrong entries at the first state that has some.
fn listed<'a>(all: &'a [Compared], wrong: &[Vec<(usize, usize)>]) -> Vec<Entry<'a>> {
    let Some((one, wrong)) = all.iter().zip(wrong).find(|(_, wrong)| !wrong.is_empty()) else { return Vec::new() };
    let entry = |&(row, column): &(usize, usize)| Entry {
        row: row + 1,
        column: column + 1,
        found: one.found().at(row, column),
        expected: one.exact.at(row, column),
        uncertainty: one.errors.at(row, column),
        state: &one.at.name,
    };
    wrong.iter().map(entry).collect()
}

fn list(wrong: &[Entry<'_>], [value, input, name]: [&str; 3], text: &mut String) {
    let (sign, minus) = if name.starts_with('-') { (-1.0, "-") } else { (1.0, "") };
    let matrix = name.trim_start_matches('-');
    for Entry { row, column, found, expected, uncertainty, state } in wrong.iter().take(SHOWN) {
        let [found, expected] = [found, expected].map(|x| sign * x);
        let _ = writeln!(
            text,
            "    {matrix}({row},{column}) is {found:.9e}, and {minus}d{value}({row})/d{input}({column}) is {expected:.9e} ± {uncertainty:.0e} at {state}"
        );
    }
    if wrong.len() > SHOWN {
        let _ = writeln!(text, "    and {} more there", wrong.len() - SHOWN);
    }
}
