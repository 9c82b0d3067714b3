//! A process with pipes that is stopped when dropped, together with all processes it has started.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// The largest number of bytes in a line.
const LONGEST: u64 = 1 << 20;
/// The number of bytes of standard error that are kept.
const KEPT: usize = 2000;
/// The interval for polling whether a process has ended.
const LOOK: Duration = Duration::from_millis(1);
/// The time limit for the rest of its standard error.
const LAST: Duration = Duration::from_secs(3);

/// A running program.
pub(super) struct Process {
    /// `None` once it has been waited for: its process ID may then be reused.
    child: Option<Child>,
    lines: Receiver<String>,
    said: Receiver<Vec<u8>>,
}

/// The result of waiting for a line.
#[derive(Debug, PartialEq)]
pub(super) enum Next {
    Line(String),
    /// Nothing came in time.
    Silence,
    /// There are no more lines.
    End,
}

impl Process {
    /// Starts a program, writes a text to its standard input, and closes that.
    pub(super) fn start(command: &[String], input: String) -> io::Result<Self> {
        let (program, arguments) = command.split_first().ok_or(io::ErrorKind::InvalidInput)?;
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // A separate group, so that the processes it starts can be stopped with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let (mut stdin, stdout, stderr) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        thread::spawn(move || {
            // A program that has ended does not read its input; its answers tell.
            let _ = stdin.as_mut().map(|stdin| stdin.write_all(input.as_bytes()));
        });
        let (line, lines) = mpsc::channel();
        thread::spawn(move || {
            let mut stdout = BufReader::new(stdout.expect("standard output is piped"));
            while let Some(text) = line_of(&mut stdout) {
                if line.send(text).is_err() {
                    break;
                }
            }
        });
        let (all, said) = mpsc::channel();
        thread::spawn(move || {
            let mut text = Vec::new();
            let stderr = stderr.expect("standard error is piped");
            let mut chunks = BufReader::new(stderr);
            while let Ok(chunk) = chunks.fill_buf() {
                let length = chunk.len();
                if length == 0 {
                    break;
                }
                text.extend_from_slice(chunk);
                chunks.consume(length);
                text.drain(..text.len().saturating_sub(KEPT));
            }
            // The receiver may be gone.
            let _ = all.send(text);
        });
        Ok(Self { child: Some(child), lines, said })
    }

    /// The next line that it prints.
    pub(super) fn line(&self, limit: Duration) -> Next {
        match self.lines.recv_timeout(limit) {
            Ok(line) => Next::Line(line),
            Err(RecvTimeoutError::Timeout) => Next::Silence,
            Err(RecvTimeoutError::Disconnected) => Next::End,
        }
    }

    /// Waits until it ends by itself, or stops it; returns its exit status, and whether it ended by itself. The
    /// processes it has started are stopped, too.
    pub(super) fn finish(mut self, limit: Duration) -> io::Result<(ExitStatus, bool)> {
        let from = Instant::now();
        let mut child = self.child.take().expect("nobody else waits for it");
        let mut by_itself = has_ended(&mut child);
        while !by_itself && from.elapsed() < limit {
            thread::sleep(LOOK);
            by_itself = has_ended(&mut child);
        }
        kill(&mut child);
        Ok((child.wait()?, by_itself))
    }

    /// The end of its standard error; processes that have left its group but keep the stream open are not waited for.
    pub(super) fn last_words(&self) -> String {
        let said = self.said.recv_timeout(LAST).unwrap_or_default();
        String::from_utf8_lossy(&said).trim().to_owned()
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        if let Some(child) = &mut self.child {
            kill(child);
            // It was killed: nothing else can be done.
            let _ = child.wait();
        }
    }
}

/// The next line; if it is too long, its beginning, and then nothing more.
fn line_of(stdout: &mut impl BufRead) -> Option<String> {
    let mut bytes = Vec::new();
    let read = stdout.by_ref().take(LONGEST).read_until(b'\n', &mut bytes).ok()?;
    (read > 0).then(|| String::from_utf8_lossy(&bytes).trim_end_matches(['\n', '\r']).to_owned())
}

/// Whether it has ended. Its process ID is not reused until it is waited for, so that no other process can be killed by mistake.
#[cfg(unix)]
fn has_ended(child: &mut Child) -> bool {
    use rustix::process::{Pid, WaitId, WaitIdOptions, waitid};
    let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
    !matches!(waitid(WaitId::Pid(Pid::from_child(child)), options), Ok(None))
}

#[cfg(unix)]
fn kill(child: &mut Child) {
    use rustix::process::{Pid, Signal, kill_process_group};
    // If the group is gone there is nothing to kill.
    let _ = kill_process_group(Pid::from_child(child), Signal::KILL);
}

#[cfg(not(unix))]
fn has_ended(child: &mut Child) -> bool {
    !matches!(child.try_wait(), Ok(None))
}

#[cfg(not(unix))]
fn kill(child: &mut Child) {
    // If it is gone there is nothing to kill.
    let _ = child.kill();
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str) -> Process {
        Process::start(&["sh", "-c", script].map(str::to_owned), String::new()).unwrap()
    }

    #[test]
    fn an_empty_line_is_a_line() {
        let process = shell("printf '\\n1\\r\\n\\n2'");
        let lines: Vec<_> = (0..5).map(|_| process.line(Duration::from_mins(1))).collect();
        let line = |text: &str| Next::Line(text.to_owned());
        assert_eq!(lines, [line(""), line("1"), line(""), line("2"), Next::End]);
    }

    #[test]
    fn one_that_ends_late_is_waited_for() {
        let (status, by_itself) = shell("exec 1>&-; sleep 0.1; exit 3").finish(Duration::from_mins(1)).unwrap();
        assert_eq!((status.code(), by_itself), (Some(3), true));
    }

    #[test]
    fn one_that_is_dropped_is_ended() {
        let process = shell("sleep 60");
        let pid = rustix::process::Pid::from_child(process.child.as_ref().unwrap());
        let from = Instant::now();
        drop(process);
        assert!(rustix::process::test_kill_process(pid).is_err() && from.elapsed() < Duration::from_secs(30));
    }

    #[test]
    fn only_the_last_that_is_said_is_kept() {
        let command = ["sh", "-c", "printf '%05000d' 7 >&2"].map(str::to_owned);
        let process = Process::start(&command, String::new()).unwrap();
        while process.line(Duration::from_mins(1)) != Next::End {}
        assert_eq!(process.said.recv().unwrap(), [vec![b'0'; KEPT - 1], vec![b'7']].concat());
    }
}
