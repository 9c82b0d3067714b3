//! `cargo xtask mutate`: faults planted one by one, and the tests that notice them.
//!
//! All faults are written into a copy of the tree at once, each behind a switch, so that one build serves for all: what was
//! `a + b` is `(if ::planted::at(17) { a - b } else { a + b })`. Every test is then run once without a fault, which tells
//! which faults it comes to, and every fault is tried with those tests only, the quickest and likeliest first.

mod area;
mod bench;
mod build;
mod choice;
mod fault;
mod found;
mod judge;
mod kept;
mod noticed;
mod plant;
mod process;
mod reach;
mod rules;
mod sites;
mod table;
#[cfg(test)]
mod tests;
mod workers;

use crate::Outcome;
use crate::console::{count, green, print, red, say, yellow};
use anyhow::ensure;
use bench::Bench;
use build::Programs;
use choice::Choice;
use fault::{Fault, Judged, Verdict};
use found::{Before, Found, earlier};
use judge::Patience;
use kit::{Project, Usage};
use noticed::Noticed;
use std::collections::BTreeMap;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Duration;

pub(crate) use kept::{tables, texts};

/// Plant faults one by one and see which the tests notice
///
/// The faults are those listed in `tests/faults` and some that are made by rule, spread over all files. They are planted in a copy
/// below `target/mutate`, which is built once. The exit code is 1 if in some area fewer than 95 % are noticed.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} mutate                                  all of them, which takes an hour and more
  {command} mutate --area scenes --sample 20        twenty of an area
  {command} mutate --fault scenes.wrap              one, with the test that notices it
  {command} mutate --seed 7 --sample 50             others than those that are always made
  {command} mutate --list                           what would be planted
  {command} mutate --again                          what earlier runs did not notice
  {command} mutate --keep                           all of them, for the book")]
pub(crate) struct Arguments {
    /// Only faults of this area; may be given several times
    #[arg(long, value_name = "AREA")]
    area: Vec<String>,
    /// Only so many, taken at random
    #[arg(long, value_name = "N")]
    sample: Option<usize>,
    /// Only the fault of this name, or those whose names begin with it
    #[arg(long, value_name = "ID")]
    fault: Option<String>,
    /// Faults made by rule in every area
    #[arg(long, value_name = "N", default_value_t = 30)]
    made: usize,
    /// Which faults are made, and which are in a sample
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,
    /// Faults that are tried at the same time
    #[arg(long, value_name = "N", default_value_t = 2)]
    jobs: usize,
    /// How much longer a fault may make a test run before it counts as noticed, beside eight times its own time
    #[arg(long, value_name = "SECONDS", default_value_t = 20)]
    grace: u32,
    /// After so many seconds the tests of a fault that are left are not run
    #[arg(long, value_name = "SECONDS", default_value_t = 600)]
    enough: u64,
    #[command(flatten)]
    programs: Programs,
    /// Tests that take longer without a fault are left out
    #[arg(long, value_name = "SECONDS", default_value_t = 900)]
    longest: u64,
    /// Do not try again what earlier runs noticed
    #[arg(long)]
    again: bool,
    /// Only list the faults
    #[arg(long)]
    list: bool,
    /// Keep what came of whole areas in `tests/data/faults.json`, which the book shows
    #[arg(long, conflicts_with_all = ["sample", "fault", "list"])]
    keep: bool,
}

impl Arguments {
    /// Which tests were run, for how long, and on which faults.
    fn in_words(&self) -> String {
        let again = if self.again { "; what was noticed before was not tried again" } else { "" };
        format!("those of {}, {} s a fault, seed {}{again}", self.programs, self.enough, self.seed)
    }
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_repository("mutate", "")?;
    let root = project.root();
    let areas = area::read(root)?;
    for name in &arguments.area {
        if !areas.iter().any(|area| area.name == *name) {
            let names: Vec<_> = areas.iter().map(|area| area.name.as_str()).collect();
            return Err(Usage(format!("there is no area {name}; there are {}", names.join(", "))).into());
        }
    }
    let bench = Bench::new(root, root.join("target/mutate"))?;
    let choice = Choice::read(&areas, &bench.sources()?, arguments.seed)?;
    // Before they are built, too: a name that is none is told at once.
    let faults = wanted(arguments, &choice.take(arguments.made, &build::refused(&bench)))?;
    if arguments.list {
        print(&faults.iter().map(|(_, fault)| line(fault)).collect::<String>())?;
        return Ok(ExitCode::SUCCESS);
    }
    let judged = judge_all(&bench, &choice, arguments)?;
    print(&table::text(&judged))?;
    if arguments.keep {
        kept::keep(root, &judged, &arguments.in_words())?;
    }
    Ok(if is_enough(&judged) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Whether in every area enough is noticed.
fn is_enough(judged: &[Judged]) -> bool {
    table::by(judged, |one| Some(&one.area)).values().all(table::Score::is_enough)
}

fn line(fault: &Fault) -> String {
    let verdict = Verdict::Equivalent(fault.equivalent.clone().unwrap_or_default());
    let change = Judged::new(fault, verdict).change();
    let note = fault.equivalent.as_ref().map_or(String::new(), |why| format!(" (nothing can notice it: {why})"));
    format!("{} {}: {change}{note}\n", fault.area, fault.id)
}

/// Plants all faults, and tries those that are wanted.
fn judge_all(bench: &Bench, choice: &Choice, arguments: &Arguments) -> anyhow::Result<Vec<Judged>> {
    say("building");
    let built = build::build(bench, choice, arguments.made, &arguments.programs)?;
    let faults = wanted(arguments, &built.faults)?;
    let earlier = earlier(bench);
    let before = Before::of(if arguments.again { &earlier } else { &[] });
    let noticed = Noticed::of(&[&earlier[..], &kept::judged(bench.root())].concat());
    let known = |fault: &Fault| match &fault.equivalent {
        // Whoever names it wants to see.
        Some(why) if arguments.fault.is_none() => Some(Verdict::Equivalent(why.clone())),
        _ => before.verdict(fault),
    };
    let (mut judged, mut open) = (BTreeMap::new(), Vec::new());
    for (number, fault) in &faults {
        match known(fault) {
            Some(verdict) => drop(judged.insert(*number, Judged::new(fault, verdict))),
            None => open.push((*number, fault)),
        }
    }
    say(&format!("{} planted, {} to be tried", count(built.faults.len(), "fault"), open.len()));
    process::limit_memory()?;
    let tests = reach::reach(bench, &built, Duration::from_secs(arguments.longest), arguments.jobs)?;
    let patience = Patience { grace: arguments.grace, enough: arguments.enough };
    let progress = Progress { done: AtomicUsize::default(), of: open.len() };
    let found = Found::new(bench, earlier, judged, &faults);
    workers::in_parallel(arguments.jobs, &open, |&(number, fault)| {
        let verdict = judge::judge(&built, &tests, &noticed, (number, fault), patience)?;
        noticed.add(&fault.file, &verdict);
        say(&progress.after(fault, &verdict));
        found.add(number, Judged::new(fault, verdict))
    })?;
    Ok(found.all())
}

/// How far all faults have been tried, by any number of threads.
struct Progress {
    done: AtomicUsize,
    of: usize,
}

impl Progress {
    /// One more has been tried: how many these are, and what came of it.
    fn after(&self, fault: &Fault, verdict: &Verdict) -> String {
        let number = self.done.fetch_add(1, Relaxed) + 1;
        format!("{number}/{} {} {}", self.of, fault.id, in_words(verdict))
    }
}

fn in_words(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Killed(test) => format!("{} by {test}", green("killed")),
        Verdict::Stopped(test) => format!("{} in {test}", green("stopped")),
        Verdict::Survived(0) => red("survived, no test comes there"),
        Verdict::Survived(tests) => red(format!("survived {}", count(*tests, "test"))),
        Verdict::Equivalent(_) => yellow("equivalent"),
    }
}

/// The faults that the arguments name, with their numbers.
fn wanted(arguments: &Arguments, faults: &[Fault]) -> anyhow::Result<Vec<(usize, Fault)>> {
    let is_wanted = |fault: &Fault| {
        let is_named = |name: &String| fault.id.starts_with(name.as_str());
        (arguments.area.is_empty() || arguments.area.contains(&fault.area))
            && arguments.fault.as_ref().is_none_or(is_named)
    };
    let mut wanted: Vec<_> = faults.iter().cloned().enumerate().filter(|(_, fault)| is_wanted(fault)).collect();
    if let Some(sample) = arguments.sample {
        wanted.sort_by_key(|(_, fault)| fault.hash(arguments.seed));
        wanted.truncate(sample);
    }
    ensure!(!wanted.is_empty(), Usage("no fault is like that; --list without --fault and --sample shows all".into()));
    Ok(wanted)
}
