//! Output: results to standard output, messages and progress to standard error, colours only where they are wanted.

use indicatif::{ProgressBar, ProgressStyle};
pub use judge::console::{bold, count, figure, green, plain, red, yellow};
use std::io::{ErrorKind, Write};

/// Writes a result. A reader that has seen enough, as `head`, changes nothing about the verdict, so it is no error.
///
/// # Errors
/// What the stream says otherwise.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut out = anstream::stdout().lock();
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(out, "{text}{end}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => Ok(written?),
    }
}

/// Says something that is not a result. A standard error that is closed is not worth failing for.
pub fn say(text: &str) {
    let _ = writeln!(anstream::stderr(), "{text}");
}

/// Says what went wrong.
pub fn error(text: &str) {
    say(&format!("{} {text}", red("error:")));
}

/// A progress bar, drawn only on a terminal.
pub fn progress(what: &'static str, steps: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{prefix:>8} [{wide_bar}] {pos}/{len} {eta} {msg}");
    let bar = ProgressBar::new(steps as u64).with_prefix(what);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
