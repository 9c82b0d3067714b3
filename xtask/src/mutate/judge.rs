//! A fault tried with the tests that come to it, until one fails: the quickest first, and sooner those that have noticed faults of
//! its file.

use super::build::{Binary, Built};
use super::fault::{Fault, Verdict};
use super::noticed::Noticed;
use super::process::{self, Ended, How};
use super::reach::{Test, command};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Tests of one program that take less together are run together.
const QUICK: f64 = 4.0;
/// The part of its time that a test which has noticed faults of the file is reckoned with, where tests are put into their order.
const LIKELY: f64 = 0.1;
/// How much longer than without a fault tests may take.
const TIMES: f64 = 8.0;

/// How long a fault is tried.
#[derive(Clone, Copy)]
pub(super) struct Patience {
    /// Tests may take so many seconds longer than some times what they take without the fault.
    pub(super) grace: u32,
    /// After so many seconds the tests that are left are not run.
    pub(super) enough: u64,
}

/// Tries a fault.
///
/// # Errors
/// That a test cannot be started.
pub(super) fn judge(
    built: &Built,
    tests: &[Test],
    noticed: &Noticed,
    (number, fault): (usize, &Fault),
    Patience { grace, enough }: Patience,
) -> anyhow::Result<Verdict> {
    let reaching: Vec<&Test> = tests.iter().filter(|test| test.reached.contains(&fault.id)).collect();
    let likely = noticed.in_file(&fault.file);
    let is_likely = |test: &Test| likely.contains(&named(&built.binaries[test.binary], &test.name));
    let (from, mut run) = (Instant::now(), 0);
    for batch in batches(&reaching, is_likely) {
        if from.elapsed().as_secs() >= enough {
            break;
        }
        run += batch.len();
        let binary = &built.binaries[batch[0].binary];
        let names: Vec<&str> = batch.iter().map(|test| test.name.as_str()).filter(|name| !name.is_empty()).collect();
        let mut command = command(binary, &names);
        command.env("JOINTPROOF_FAULT", number.to_string()).env_remove("JOINTPROOF_FAULTS_ASKED");
        let seconds: f64 = batch.iter().map(|test| test.seconds).sum();
        let ended = process::run(command, longest(seconds, grace))?;
        let all = names.join(", ");
        match ended.how {
            How::Well => {}
            How::Badly => return Ok(Verdict::Killed(named(binary, failed(&ended).unwrap_or(&all)))),
            How::Aborted | How::Late => return Ok(Verdict::Stopped(named(binary, running(&ended).unwrap_or(&all)))),
        }
    }
    Ok(Verdict::Survived(run))
}

/// How long tests may take that take so many seconds without a fault.
fn longest(seconds: f64, grace: u32) -> Duration {
    Duration::from_secs_f64(seconds * TIMES + f64::from(grace))
}

/// A test with its program, as a verdict names it.
fn named(binary: &Binary, test: &str) -> String {
    format!("{}: {test}", binary.name)
}

/// What is run together: quick tests of one program, then the others by themselves. What takes least comes first, where a likely
/// test is alone and counts as quicker than it is.
fn batches<'a>(tests: &[&'a Test], is_likely: impl Fn(&Test) -> bool) -> Vec<Vec<&'a Test>> {
    let (likely, mut others): (Vec<&Test>, Vec<&Test>) = tests.iter().partition(|test| is_likely(test));
    let mut batches: Vec<_> = likely.into_iter().map(|test| (LIKELY * test.seconds, vec![test])).collect();
    others.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let mut open: BTreeMap<usize, (f64, Vec<&Test>)> = BTreeMap::new();
    for test in others {
        let (seconds, batch) = open.entry(test.binary).or_default();
        if !batch.is_empty() && *seconds + test.seconds > QUICK {
            batches.push((*seconds, std::mem::take(batch)));
            *seconds = 0.0;
        }
        *seconds += test.seconds;
        batch.push(test);
    }
    batches.extend(open.into_values());
    batches.sort_by(|a, b| a.0.total_cmp(&b.0));
    batches.into_iter().map(|(_, batch)| batch).collect()
}

/// The first test that is said to have failed.
fn failed(ended: &Ended) -> Option<&str> {
    ended.said.lines().find_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... FAILED"))
}

/// The test that was begun last.
fn running(ended: &Ended) -> Option<&str> {
    ended.said.lines().rev().find_map(|line| Some(line.strip_prefix("test ")?.split_once(" ... ")?.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutate::process::How;
    use std::collections::BTreeSet;

    fn ended(said: &str) -> Ended {
        Ended { how: How::Badly, time: Duration::ZERO, said: said.into() }
    }

    #[test]
    fn the_first_test_that_failed_is_named_and_the_last_that_was_begun() {
        let said = ended("test a ... ok\ntest b ... FAILED\ntest c ... FAILED\ntest d ... ");
        assert_eq!((failed(&said), running(&said)), (Some("b"), Some("d")));
        let silent = ended("running 2 tests\n");
        assert_eq!((failed(&silent), running(&silent)), (None, None));
    }

    #[test]
    fn tests_may_take_some_times_as_long_as_without_a_fault_and_a_while_more() {
        assert_eq!(longest(2.5, 3), Duration::from_secs(23));
        assert_eq!(longest(0.0, 1), Duration::from_secs(1));
    }

    /// A program that fails has noticed any fault, if it is run.
    #[cfg(unix)]
    #[test]
    fn when_it_is_enough_no_test_is_run() {
        let binary = Binary { name: "no".into(), path: "false".into(), folder: std::env::temp_dir() };
        let built = Built { faults: Vec::new(), binaries: vec![binary] };
        let reached = BTreeSet::from(["a.one".to_owned()]);
        let test = Test { binary: 0, name: String::new(), seconds: 0.0, succeeds: true, reached };
        let fault = Fault {
            id: "a.one".into(),
            area: "a".into(),
            file: "src/a.rs".into(),
            line: 1,
            was: "+".into(),
            becomes: "-".into(),
            equivalent: None,
            places: Vec::new(),
        };
        let after = |enough| {
            let patience = Patience { grace: 20, enough };
            judge(&built, std::slice::from_ref(&test), &Noticed::default(), (0, &fault), patience).unwrap()
        };
        assert_eq!(after(0), Verdict::Survived(0));
        assert_eq!(after(60), Verdict::Killed("no: ".into()));
    }

    #[test]
    fn quick_tests_of_one_program_run_together_and_what_takes_least_comes_first() {
        let test = |binary, name: &str, seconds| Test {
            binary,
            name: name.into(),
            seconds,
            succeeds: true,
            reached: BTreeSet::new(),
        };
        let tests = [test(0, "slow", 60.0), test(0, "a", 1.5), test(1, "c", 0.5), test(0, "b", 0.25)];
        let tests: Vec<&Test> = tests.iter().collect();
        let names = |likely: &str| -> Vec<Vec<&str>> {
            let batches = batches(&tests, |test| test.name == likely);
            batches.iter().map(|batch| batch.iter().map(|test| test.name.as_str()).collect()).collect()
        };
        assert_eq!(names(""), [vec!["c"], vec!["b", "a"], vec!["slow"]]);
        assert_eq!(names("a"), [vec!["a"], vec!["b"], vec!["c"], vec!["slow"]]);
        assert_eq!(names("slow"), [vec!["c"], vec!["b", "a"], vec!["slow"]]);
    }
}
