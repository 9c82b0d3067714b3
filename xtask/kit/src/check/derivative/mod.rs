//! `check --derivative`: the matrix of anybody's routine against the derivative of its own value, without a formula of ours.

mod causes;
mod compared;
mod driver;
mod quotients;
mod spec;
mod states;

use super::driver::abi;
use super::line::{self, Digits};
use super::peer::{Peer, Replies, Reply};
use crate::console::{bold, count, green, print, red};
use crate::outcome::{Outcome, verdict};
use compared::{Answered, Compared, Table};
use judge::{Answer, Manners};
use quotients::Slope;
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
pub(super) fn run(file: &Path, program: &[String], limit: Duration) -> Outcome {
    let spec = Spec::read(file)?;
    let asked = Asked::new(&spec);
    let numbers = spec.outputs() * (spec.at.len() + 1);
    let peer = Peer { command: program, limit, head: None, numbers, digits: Digits::Decimal };
    let head = |mark: &str| format!("{mark} {} by {}", bold(file.display().to_string()), program.join(" "));
    let replies = match peer.ask(&asked.lines())? {
        Ok(Replies { replies, .. }) => replies,
        Err(why) => {
            print(&format!("{}: {why}\n", head(&red("off"))))?;
            return Ok(verdict(false));
        }
    };
    let read = |reply: &Reply| match reply {
        Reply::Line(line) => line::read(line, numbers, Digits::Decimal, &mut Manners::new()),
        Reply::Hangs => Answer::Bad("no answer within the limit".into()),
        Reply::Ends(how) => Answer::Bad(how.clone()),
        Reply::NotAsked => Answer::Skipped("not asked any more".into()),
    };
    let answers: Vec<_> = replies.iter().map(read).collect();
    let found = asked.compared(&answers);
    let report = report(&spec, &found);
    let mark = if report.is_well { green("ok ") } else { red("off") };
    print(&format!("{}: {}", head(&mark), report.text))?;
    Ok(verdict(report.is_well))
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

/// The verdict with its text.
struct Report {
    is_well: bool,
    text: String,
}

fn report(spec: &Spec, found: &Found) -> Report {
    let names @ [value, input, name] = spec.names();
    let all = &found.compared;
    let matrix = name.trim_start_matches('-');
    let mut text = String::new();
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
    let _ = if all.is_empty() {
        writeln!(text, "there is no state at which it answers")
    } else if off > 0 {
        writeln!(text, "{matrix} is not {minus}the derivative of {value} with respect to {input} at {off} of {states}")
    } else if decided == 0 {
        writeln!(text, "no derivative could be determined at {states}")
    } else {
        let [least, median] = digits(all);
        writeln!(
            text,
            "{matrix} is {minus}the derivative of {value} with respect to {input} at {states}, to {least:.1} digits and more, {median:.1} in the median"
        )
    };
    if off > 0 {
        let cause = causes::cause(all, names, spec.by, spec.coords.first().map_or(1, Vec::len)).unwrap_or_else(|| {
            format!("none of the known mistakes explains it; wrong are {matrix}{}", causes::place(all))
        });
        let _ = writeln!(text, "    cause: {cause}");
        list(all, &wrong, spec.names(), &mut text);
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
    Report { is_well, text }
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

/// The wrong entries at the first state that has some.
fn list(all: &[Compared], wrong: &[Vec<(usize, usize)>], [value, input, name]: [&str; 3], text: &mut String) {
    let Some((one, wrong)) = all.iter().zip(wrong).find(|(_, wrong)| !wrong.is_empty()) else { return };
    let (sign, minus) = if name.starts_with('-') { (-1.0, "-") } else { (1.0, "") };
    let matrix = name.trim_start_matches('-');
    for &(row, column) in wrong.iter().take(SHOWN) {
        let _ = writeln!(
            text,
            "    {matrix}({r},{c}) is {:.9e}, and {minus}d{value}({r})/d{input}({c}) is {:.9e} ± {:.0e} at {}",
            sign * one.found().at(row, column),
            sign * one.exact.at(row, column),
            one.errors.at(row, column),
            one.at.name,
            r = row + 1,
            c = column + 1,
        );
    }
    if wrong.len() > SHOWN {
        let _ = writeln!(text, "    and {} more there", wrong.len() - SHOWN);
    }
}
