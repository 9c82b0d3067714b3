//! Output: results to standard output, messages and progress to standard error, colours only where they are wanted.

#[cfg(feature = "commands")]
use indicatif::{ProgressBar, ProgressStyle};
#[cfg(feature = "commands")]
use std::io::{ErrorKind, Write};

const RED: &str = "\x1b[31m";
const GREEN: &str = "\x1b[32m";
const YELLOW: &str = "\x1b[33m";
const BOLD: &str = "\x1b[1m";
const PLAIN: &str = "\x1b[0m";

/// Red text; the stream drops the colour where it is not a terminal, or `NO_COLOR` is set.
pub fn red(text: impl std::fmt::Display) -> String {
    format!("{RED}{text}{PLAIN}")
}

/// Green text.
pub fn green(text: impl std::fmt::Display) -> String {
    format!("{GREEN}{text}{PLAIN}")
}

/// Yellow text.
pub fn yellow(text: impl std::fmt::Display) -> String {
    format!("{YELLOW}{text}{PLAIN}")
}

/// Bold text.
pub fn bold(text: impl std::fmt::Display) -> String {
    format!("{BOLD}{text}{PLAIN}")
}

/// A text without its colours.
pub fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

/// `1 case`, `2 cases`.
pub fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

/// A deviation or an error in two or three digits.
pub fn figure(size: f64) -> String {
    match size {
        0.0 => "0".into(),
        size if (1e-2..1e4).contains(&size) => format!("{size:.2}"),
        size => format!("{size:.0e}"),
    }
}

/// Writes a result. A reader that has seen enough, as `head`, changes nothing about the verdict, so it is no error.
///
/// # Errors
/// What the stream says otherwise.
#[cfg(feature = "commands")]
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut out = anstream::stdout().lock();
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(out, "{text}{end}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => Ok(written?),
    }
}

/// Says something that is not a result. A standard error that is closed is not worth failing for.
#[cfg(feature = "commands")]
pub fn say(text: &str) {
    let _ = writeln!(anstream::stderr(), "{text}");
}

/// Says what went wrong.
#[cfg(feature = "commands")]
pub fn error(text: &str) {
    say(&format!("{} {text}", red("error:")));
}

/// A progress bar, drawn only on a terminal.
#[cfg(feature = "commands")]
pub fn progress(what: &'static str, steps: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{prefix:>8} [{wide_bar}] {pos}/{len} {eta} {msg}");
    let bar = ProgressBar::new(steps as u64).with_prefix(what);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
