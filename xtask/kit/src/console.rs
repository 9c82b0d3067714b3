//! Output: results to standard output, messages and progress to standard error, colours only where they are wanted.

use indicatif::{ProgressBar, ProgressStyle};
pub use judge::console::{bold, count, figure, green, plain, red, yellow};
use std::io::{ErrorKind, Write};

/// Writes a result. It is no error if the reader stops reading, like `head`, since that does not affect the verdict.
///
/// # Errors
/// Any other error of the stream.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut out = anstream::stdout().lock();
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(out, "{text}{end}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => Ok(written?),
    }
}

/// Writes a message that is not a result. A closed standard error is ignored.
pub fn say(text: &str) {
    let _ = writeln!(anstream::stderr(), "{text}");
}

/// Writes an error message.
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
