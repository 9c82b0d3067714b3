//! A fault tried with the tests that come to it, the quickest first, until one fails.

use super::build::Built;
use super::fault::{Fault, Verdict};
use super::process::{self, Ended, How};
use super::reach::{Test, command};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Tests of one program that take less together are run together.
const QUICK: f64 = 4.0;
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
    number: usize,
    fault: &Fault,
    Patience { grace, enough }: Patience,
) -> anyhow::Result<Verdict> {
    let reaching: Vec<&Test> = tests.iter().filter(|test| test.reached.contains(&fault.id)).collect();
    let (from, mut run) = (Instant::now(), 0);
    for batch in batches(&reaching) {
        if from.elapsed().as_secs() >= enough {
            break;
        }
        run += batch.len();
        let binary = &built.binaries[batch[0].binary];
        let names: Vec<&str> = batch.iter().map(|test| test.name.as_str()).filter(|name| !name.is_empty()).collect();
        let mut command = command(binary, &names);
        command.env("JOINTPROOF_FAULT", number.to_string()).env_remove("JOINTPROOF_FAULTS_ASKED");
        let seconds: f64 = batch.iter().map(|test| test.seconds).sum();
        let ended = process::run(command, Duration::from_secs_f64(seconds * TIMES + f64::from(grace)))?;
        let all = names.join(", ");
        let named = |test: &str| format!("{}: {test}", binary.name);
        match ended.how {
            How::Well => {}
            How::Badly => return Ok(Verdict::Killed(named(failed(&ended).unwrap_or(&all)))),
            How::Aborted | How::Late => return Ok(Verdict::Stopped(named(running(&ended).unwrap_or(&all)))),
        }
    }
    Ok(Verdict::Survived(run))
}

/// What is run together: quick tests of one program, then the others by themselves. What takes least comes first.
fn batches<'a>(tests: &[&'a Test]) -> Vec<Vec<&'a Test>> {
    let mut sorted = tests.to_vec();
    sorted.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let mut open: BTreeMap<usize, (f64, Vec<&Test>)> = BTreeMap::new();
    let mut batches = Vec::new();
    for test in sorted {
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
    use std::collections::BTreeSet;

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
        let names: Vec<Vec<_>> = batches(&tests).iter().map(|b| b.iter().map(|t| t.name.as_str()).collect()).collect();
        assert_eq!(names, [vec!["c"], vec!["b", "a"], vec!["slow"]]);
    }
}
