//! A test program run within limits.

use anyhow::Context;
use std::fs::File;
use std::io::{Read, Seek};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// How often it is looked whether a program has ended.
const LOOK: Duration = Duration::from_millis(2);
/// The memory that a program may take: a fault can make a loop without end, and a loop take all there is.
const MEMORY: u64 = 4 << 30;

/// How a program ended.
pub(super) struct Ended {
    pub(super) how: How,
    pub(super) time: Duration,
    /// What it printed.
    pub(super) said: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    Well,
    /// With an exit code.
    Badly,
    /// By a signal.
    Aborted,
    /// It did not end in time.
    Late,
}

/// Limits the memory of every program that is started from now on: what it writes to, since browsers reserve much more.
pub(super) fn limit_memory() -> anyhow::Result<()> {
    #[cfg(unix)]
    {
        use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
        let Rlimit { maximum, .. } = getrlimit(Resource::Data);
        let current = Some(allowed(maximum));
        setrlimit(Resource::Data, Rlimit { current, maximum }).context("cannot limit memory")?;
    }
    Ok(())
}

/// How much memory a program may take where there is a limit already, or none.
#[cfg(unix)]
fn allowed(maximum: Option<u64>) -> u64 {
    maximum.map_or(MEMORY, |maximum| maximum.min(MEMORY))
}

/// Runs a program to its end or to the end of the time, with all that it starts.
///
/// # Errors
/// That it cannot be started.
pub(super) fn run(mut command: Command, limit: Duration) -> anyhow::Result<Ended> {
    let mut said = tempfile::tempfile()?;
    command.stdin(Stdio::null()).stdout(said.try_clone()?).stderr(Stdio::null());
    // So that what it starts can be ended with it.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    let from = Instant::now();
    let mut child = command.spawn().with_context(|| Path::new(command.get_program()).display().to_string())?;
    let status = loop {
        match child.try_wait()? {
            Some(status) => break Some(status),
            None if from.elapsed() > limit => break None,
            None => thread::sleep(LOOK),
        }
    };
    let time = from.elapsed();
    let how = match status {
        None => {
            kill(&mut child);
            child.wait()?;
            How::Late
        }
        Some(status) if status.success() => How::Well,
        Some(status) if status.code().is_some() => How::Badly,
        Some(_) => How::Aborted,
    };
    Ok(Ended { how, time, said: text(&mut said)? })
}

fn text(file: &mut File) -> anyhow::Result<String> {
    let mut bytes = Vec::new();
    file.rewind()?;
    file.read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(unix)]
fn kill(child: &mut Child) {
    use rustix::process::{Pid, Signal, kill_process_group};
    // Where the group is gone there is nothing to kill.
    let _ = kill_process_group(Pid::from_child(child), Signal::KILL);
}

#[cfg(not(unix))]
fn kill(child: &mut Child) {
    // Where it is gone there is nothing to kill.
    let _ = child.kill();
}

#[cfg(all(test, unix))]
mod tests {
    use super::{MEMORY, allowed, limit_memory};
    use rustix::process::{Resource, getrlimit};

    #[test]
    fn a_limit_that_there_is_already_is_not_raised() {
        assert_eq!([None, Some(MEMORY - 1), Some(MEMORY + 1)].map(allowed), [MEMORY, MEMORY - 1, MEMORY]);
    }

    #[test]
    fn memory_is_limited() {
        limit_memory().unwrap();
        assert!(getrlimit(Resource::Data).current.is_some_and(|limit| limit <= MEMORY));
    }
}
