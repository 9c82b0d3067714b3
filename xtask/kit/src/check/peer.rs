//! The program to be checked: it is asked line by line, in as many processes as necessary.

use super::line::{self, Digits};
use super::process::{Next, Process};
use crate::console::progress;
use crate::outcome::Usage;
use judge::{Answer, Manners};
use std::collections::BTreeSet;
use std::process::ExitStatus;
use std::time::Duration;

/// After hanging or ending at this many points, a program is not asked any more.
const MOST_FAULTS: usize = 8;

/// The factor on the time limit for the first line of a process: interpreters and libraries need time to start.
const START: u32 = 4;

/// A program to be asked.
pub(super) struct Peer<'a> {
    pub(super) command: &'a [String],
    pub(super) limit: Duration,
    /// The text sent before the first question, which is answered by a line.
    pub(super) head: Option<String>,
    /// The count of numbers in an answer.
    pub(super) numbers: usize,
    pub(super) digits: Digits,
}

/// A program's reaction to a question.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Reply {
    Line(String),
    /// No answer within the limit.
    Hangs,
    /// It ended, in this way.
    Ends(String),
    /// It was not asked, because it had hung or ended too often.
    NotAsked,
}

impl Reply {
    /// What is read of it.
    pub(super) fn answer(&self, read: impl FnOnce(&str) -> Answer) -> Answer {
        match self {
            Self::Line(line) => read(line),
            Self::Hangs => Answer::Bad("no answer within the limit".into()),
            Self::Ends(how) => Answer::Bad(how.clone()),
            Self::NotAsked => Answer::Skipped("not asked any more".into()),
        }
    }
}

/// The layout of a program's output, determined from two questions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Layout {
    /// Lines before the first answer.
    banner: usize,
    /// Whether an answer spans several lines.
    wraps: bool,
}

/// All replies, and additional observations.
#[derive(Debug)]
pub(super) struct Replies {
    pub(super) replies: Vec<Reply>,
    pub(super) noticed: BTreeSet<String>,
}

/// The answers of a process before it ended or was stopped.
struct Session {
    answers: Vec<String>,
    /// Lines after the last answer.
    more: usize,
    end: End,
}

#[derive(Debug)]
enum End {
    /// It ended by itself, in this way.
    Ended(String),
    /// It was silent for too long.
    Hung,
    /// It answered everything, but did not end.
    Lingered,
}

impl Peer<'_> {
    /// The answers to every question, as lines of numbers.
    ///
    /// # Errors
    /// As [`Peer::ask`].
    pub(super) fn answers(&self, questions: &[String]) -> anyhow::Result<Result<Vec<Answer>, String>> {
        let read = |line: &str| line::read(line, self.numbers, self.digits, &mut Manners::new());
        let answers = |all: Replies| all.replies.iter().map(|reply| reply.answer(read)).collect();
        Ok(self.ask(questions)?.map(answers))
    }

    /// Asks every question; the first two, which it should be able to answer, determine its layout.
    ///
    /// # Errors
    /// If it cannot be started. The inner error describes a program that does not answer at all.
    pub(super) fn ask(&self, questions: &[String]) -> anyhow::Result<Result<Replies, String>> {
        let mut noticed = BTreeSet::new();
        let layout = match self.look(&questions[..questions.len().min(2)], &mut noticed)? {
            Ok(layout) => layout,
            Err(why) => return Ok(Err(why)),
        };
        let mut replies = vec![Reply::NotAsked; questions.len()];
        let (mut faults, mut is_blind) = (0, false);
        // Ranges still to be asked, the next one last, and whether a range was asked separately because an answer was missing.
        let mut left = vec![(0..questions.len(), false)];
        while let Some((range, is_suspect)) = left.pop() {
            if faults == MOST_FAULTS {
                noticed.insert(format!("not asked any more after {MOST_FAULTS} points at which it hung or ended"));
                break;
            }
            let session = self.session(&questions[range.clone()], layout)?;
            let answered = range.start + session.answers.len();
            for (reply, line) in replies[range.clone()].iter_mut().zip(session.answers) {
                *reply = Reply::Line(line);
            }
            if answered == range.end {
                // Its earlier answers were lost with it, because its output is buffered.
                is_blind |= is_suspect;
                notice(&mut noticed, session.more, &session.end);
                continue;
            }
            if range.len() == 1 {
                replies[range.start] = match session.end {
                    End::Ended(how) => Reply::Ends(how),
                    End::Hung | End::Lingered => Reply::Hangs,
                };
                faults += 1;
            } else if is_blind {
                let middle = (answered + range.end).div_ceil(2);
                left.extend([middle..range.end, answered..middle].map(|half| (half, is_suspect)));
            } else {
                left.extend([(answered + 1..range.end, false), (answered..answered + 1, true)]);
            }
            left.retain(|(range, _)| !range.is_empty());
        }
        if is_blind {
            noticed.insert("it keeps its output back: it should flush after every line".into());
        }
        Ok(Ok(Replies { replies, noticed }))
    }

    /// Asks a few questions in a separate process, closes its input, and examines its whole output.
    fn look(&self, questions: &[String], noticed: &mut BTreeSet<String>) -> anyhow::Result<Result<Layout, String>> {
        let process = self.start(questions)?;
        let mut lines = Vec::new();
        let most = 100 + questions.len() * (self.numbers + 1);
        let silent = loop {
            let limit = if lines.is_empty() { self.limit * START } else { self.limit };
            match process.line(limit) {
                Next::Line(line) if lines.len() < most => lines.push(line),
                Next::Line(_) | Next::End => break false,
                Next::Silence => break true,
            }
        };
        let said = process.last_words();
        let (status, _) = process.finish(if silent { Duration::ZERO } else { self.limit })?;
        let with = |what: &str| if said.is_empty() { what.to_owned() } else { format!("{what}; it says:\n{said}") };
        if self.head.is_some() {
            // For JSON, errors are diagnosed from the answers themselves.
            return Ok(if lines.is_empty() { Err(with("it prints nothing")) } else { Ok(Layout::default()) });
        }
        let is_answer = |line: &&String| {
            let mut tokens = line::tokens(line).peekable();
            let has_any = tokens.peek().is_some();
            line::is_without_numbers(line) || has_any && tokens.all(|token| line::is_number(token, self.digits))
        };
        let banner = lines.iter().take_while(|line| !is_answer(line)).count();
        let answers: Vec<_> = lines[banner..].iter().filter(is_answer).collect();
        if answers.is_empty() {
            let how = if silent { "nothing comes within the limit".into() } else { how_ended(status) };
            return Ok(Err(match lines.first() {
                None => with(&format!("it prints nothing: {how}")),
                Some(line) => with(&format!("it prints no answer but `{line}`")),
            }));
        }
        if banner > 0 {
            noticed.insert(format!("lines before the first answer, as `{}`", lines[0]));
        }
        let numbers: usize = answers.iter().map(|line| line::tokens(line).count()).sum();
        let wraps = answers.len() > questions.len() && numbers == questions.len() * self.numbers;
        if wraps {
            noticed.insert("an answer goes over several lines".into());
        } else if answers.len() > questions.len() {
            let [asked, answered] = [questions.len(), answers.len()];
            return Ok(Err(with(&format!(
                "it prints {answered} lines for {asked} points, each of which has one line"
            ))));
        }
        Ok(Ok(Layout { banner, wraps }))
    }

    fn start(&self, questions: &[String]) -> anyhow::Result<Process> {
        let text: String = self.head.iter().chain(questions).flat_map(|line| [line.as_str(), "\n"]).collect();
        Process::start(self.command, text).map_err(|error| {
            let program = self.command.first().map_or("", String::as_str);
            Usage(format!("{program} cannot be started: {error}")).into()
        })
    }

    fn session(&self, questions: &[String], layout: Layout) -> anyhow::Result<Session> {
        let process = self.start(questions)?;
        let before = layout.banner + usize::from(self.head.is_some());
        let mut answers = Vec::with_capacity(questions.len());
        let limit = |line: usize| if line == 0 { self.limit * START } else { self.limit };
        let mut next = (0..before).map(|k| process.line(limit(k))).find(|next| !matches!(next, Next::Line(_)));
        let bar = progress("asked", questions.len());
        while next.is_none() && answers.len() < questions.len() {
            match self.answer(&process, layout, limit(before + answers.len())) {
                Next::Line(line) => answers.push(line),
                other => next = Some(other),
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let mut more = 0;
        while next.is_none() {
            match process.line(self.limit) {
                Next::Line(_) if more < questions.len() => more += 1,
                Next::Line(_) => next = Some(Next::Silence),
                other => next = Some(other),
            }
        }
        let all = answers.len() == questions.len();
        let hung = next == Some(Next::Silence);
        let said = if hung || all { String::new() } else { process.last_words() };
        let (status, by_itself) = process.finish(if hung { Duration::ZERO } else { self.limit })?;
        let end = match (hung, by_itself) {
            (true, _) if all => End::Lingered,
            (true, _) => End::Hung,
            (false, false) => End::Lingered,
            (false, true) if said.is_empty() => End::Ended(how_ended(status)),
            (false, true) => {
                let last = said.lines().last().unwrap_or_default();
                End::Ended(format!("{}: {last}", how_ended(status)))
            }
        };
        Ok(Session { answers, more, end })
    }

    /// The next answer, joined into one line.
    fn answer(&self, process: &Process, layout: Layout, limit: Duration) -> Next {
        let first = process.line(limit);
        let Next::Line(mut answer) = first else { return first };
        while layout.wraps && !line::is_without_numbers(&answer) && line::tokens(&answer).count() < self.numbers {
            match process.line(self.limit) {
                Next::Line(line) => answer = format!("{answer} {line}"),
                other => return other,
            }
        }
        Next::Line(answer)
    }
}

fn notice(noticed: &mut BTreeSet<String>, more: usize, end: &End) {
    if more > 0 {
        noticed.insert("lines behind the last answer".into());
    }
    match end {
        End::Ended(how) if how != SUCCESS => drop(noticed.insert(format!("behind the last answer it {how}"))),
        End::Hung | End::Lingered => drop(noticed.insert("it does not end with its input".into())),
        End::Ended(_) => {}
    }
}

const SUCCESS: &str = "ends by itself";

fn how_ended(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return format!("dies of signal {signal}");
    }
    match status.code() {
        Some(0) => SUCCESS.into(),
        Some(code) => format!("ends with exit code {code}"),
        None => "ends".into(),
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::time::Instant;

    /// Longer than any working program takes, however busy the machine is.
    const PATIENT: Duration = Duration::from_mins(1);
    /// The time to wait for a program that is expected to be silent, but may also answer.
    const SHORT: Duration = Duration::from_secs(3);

    /// A shell program, asked for two numbers at each of these points.
    fn asked(script: &str, questions: usize) -> Result<Replies, String> {
        asked_within(PATIENT, script, questions)
    }

    fn asked_within(limit: Duration, script: &str, questions: usize) -> Result<Replies, String> {
        let command = ["sh", "-c", script].map(str::to_owned);
        let peer = Peer { command: &command, limit, head: None, numbers: 2, digits: Digits::Decimal };
        let questions: Vec<_> = (0..questions).map(|k| k.to_string()).collect();
        peer.ask(&questions).unwrap()
    }

    fn lines(replies: &Replies) -> usize {
        replies.replies.iter().filter(|reply| matches!(reply, Reply::Line(_))).count()
    }

    #[test]
    fn every_answer_is_read() {
        let found = asked("while read x; do echo $x 2; done", 50).unwrap();
        assert_eq!(found.replies[49], Reply::Line("49 2".into()));
        assert!(lines(&found) == 50 && found.noticed.is_empty(), "{found:?}");
        // A message at its normal end is no fault.
        let found = asked("while read x; do echo $x 2; done; echo bye >&2", 50).unwrap();
        assert!(lines(&found) == 50 && found.noticed.is_empty(), "{found:?}");
    }

    #[test]
    fn a_point_at_which_it_hangs_is_found_and_the_rest_is_asked() {
        let found = asked_within(SHORT, "while read x; do [ $x = 7 ] && sleep 60; echo $x 2; done", 20).unwrap();
        assert_eq!((lines(&found), &found.replies[7]), (19, &Reply::Hangs));
    }

    #[test]
    fn a_point_at_which_it_dies_is_found_and_the_rest_is_asked() {
        let found =
            asked("while read x; do [ $x = 7 ] && kill -9 $$; [ $x = 9 ] && exit 3; echo $x 2; done", 20).unwrap();
        assert_eq!(lines(&found), 18);
        assert_eq!(found.replies[7], Reply::Ends("dies of signal 9".into()));
        assert_eq!(found.replies[9], Reply::Ends("ends with exit code 3".into()));
        assert!(!found.noticed.iter().any(|what| what.contains("flush")), "{found:?}");
    }

    #[test]
    fn what_dies_again_and_again_is_given_up() {
        let after = |deaths: usize| {
            let script =
                format!("while read x; do [ $x -ge 3 ] && [ $x -lt {} ] && exit 3; echo $x 2; done", 3 + deaths);
            asked(&script, 20).unwrap()
        };
        let gives_up =
            |found: &Replies| found.noticed.iter().any(|what| what.starts_with("not asked any more after 8 points"));
        let (all, some) = (after(MOST_FAULTS - 1), after(MOST_FAULTS));
        assert!(lines(&all) == 20 - (MOST_FAULTS - 1) && !gives_up(&all), "{all:?}");
        assert!(lines(&some) == 3 && gives_up(&some), "{some:?}");
        assert_eq!(some.replies[3 + MOST_FAULTS..], vec![Reply::NotAsked; 20 - 3 - MOST_FAULTS]);
    }

    #[test]
    fn output_that_is_kept_back_is_told_and_the_culprit_found() {
        let script = "a=; while read x; do [ $x = 5 ] && kill -9 $$; a=\"$a$x 2\n\"; done; printf %s \"$a\"";
        let found = asked(script, 16).unwrap();
        assert_eq!((lines(&found), &found.replies[5]), (15, &Reply::Ends("dies of signal 9".into())));
        assert!(found.noticed.iter().any(|what| what.contains("flush")), "{found:?}");
    }

    #[test]
    fn banners_and_wrapped_lines_are_understood() {
        // A line in which only half of the tokens are numbers is not part of an answer.
        let found = asked("echo solver 2; while read x; do echo $x 2; done", 9).unwrap();
        assert!(lines(&found) == 9 && found.noticed.len() == 1, "{found:?}");
        let found = asked("echo hello world; while read x; do echo $x; echo 2; done", 9).unwrap();
        assert_eq!(found.replies[8], Reply::Line("8 2".into()));
        assert_eq!(found.noticed.len(), 2, "{found:?}");
    }

    #[test]
    fn a_long_banner_is_read_over() {
        let script =
            "k=0; while [ $k -lt 100 ]; do echo hello; k=$((k + 1)); done; while read x; do echo $x; echo 2; done";
        let found = asked(script, 4).unwrap();
        assert_eq!(found.replies[3], Reply::Line("3 2".into()));
    }

    #[test]
    fn the_first_line_of_a_process_may_take_four_times_as_long() {
        let found = asked_within(SHORT, "sleep 3.5; while read x; do echo $x 2; done", 3).unwrap();
        assert!(lines(&found) == 3 && found.noticed.is_empty(), "{found:?}");
    }

    #[test]
    fn one_that_ends_late_ends_by_itself() {
        let found = asked("while read x; do echo $x 2; done; exec 1>&- 2>&-; sleep 0.2", 3).unwrap();
        assert!(lines(&found) == 3 && found.noticed.is_empty(), "{found:?}");
        let why = asked("exec 1>&- 2>&-; sleep 0.2; exit 3", 3).unwrap_err();
        assert_eq!(why, "it prints nothing: ends with exit code 3");
    }

    #[test]
    fn the_last_that_it_says_is_told_where_it_ends() {
        let script = "while read x; do [ $x = 3 ] && { echo oh >&2; echo no >&2; exit 3; }; echo $x 2; done";
        assert_eq!(asked(script, 5).unwrap().replies[3], Reply::Ends("ends with exit code 3: no".into()));
        let found = asked("while read x; do echo $x 2; done; exit 4", 5).unwrap();
        assert!(found.noticed.contains("behind the last answer it ends with exit code 4"), "{found:?}");
    }

    #[test]
    fn a_line_behind_the_last_answer_is_told() {
        let found = asked("while read x; do echo $x 2; done; echo done", 5).unwrap();
        assert!(lines(&found) == 5 && found.noticed.iter().eq(["lines behind the last answer"]), "{found:?}");
    }

    #[test]
    fn a_program_that_is_not_there_is_named_without_its_arguments() {
        let command = ["./no-such-program", "argument"].map(str::to_owned);
        let peer = Peer { command: &command, limit: PATIENT, head: None, numbers: 2, digits: Digits::Decimal };
        let error = peer.ask(&["1".to_owned()]).unwrap_err().to_string();
        assert!(error.starts_with("./no-such-program cannot be started: "), "{error}");
    }

    #[test]
    fn what_never_answers_is_told_at_once() {
        assert!(asked("echo no >&2; exit 3", 9).unwrap_err().contains("ends with exit code 3; it says:\nno"));
        assert!(asked_within(Duration::ZERO, "sleep 60", 9).unwrap_err().contains("nothing comes within the limit"));
        assert!(asked("echo usage: f x; echo more", 9).unwrap_err().contains("`usage: f x`"));
        assert!(asked("while read x; do echo 1 2; echo 3 4; done", 9).unwrap_err().contains("4 lines for 2 points"));
        assert!(asked_within(SHORT, "yes", 9).is_err());
    }

    #[test]
    fn one_that_does_not_end_is_told_and_nothing_is_left_running() {
        let mark = format!("601.{}", std::process::id());
        let script = format!("sleep {mark} & while read x; do echo $x 2; done; exec 1>&-; sleep {mark}");
        let found = asked_within(SHORT, &script, 3).unwrap();
        assert!(found.noticed.contains("it does not end with its input"), "{found:?}");
        let is_running = || {
            let running = std::process::Command::new("ps").args(["-eo", "args"]).output().unwrap();
            String::from_utf8_lossy(&running.stdout).contains(&format!("sleep {mark}"))
        };
        // A killed process disappears with some delay; one left running would go on for ten minutes.
        let end = Instant::now() + PATIENT;
        while is_running() {
            assert!(Instant::now() < end, "sleep {mark} is left running");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}
