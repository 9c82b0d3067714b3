//! Output: results to standard output, messages and progress to standard error, colours only where they are wanted.

use indicatif::{ProgressBar, ProgressStyle};
pub use judge::console::{bold, count, figure, green, plain, red, yellow};
use std::borrow::Cow;
use std::io::{ErrorKind, IsTerminal, Write, stderr, stdout};

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

/// Writes a result that a person reads: on a terminal, lines end at its width.
///
/// # Errors
/// As of [`print()`].
pub fn show(text: &str) -> anyhow::Result<()> {
    print(&fitted(text, width(stdout().is_terminal())))
}

/// Writes a message that is not a result. A closed standard error is ignored.
pub fn say(text: &str) {
    let _ = writeln!(anstream::stderr(), "{}", fitted(text, width(stderr().is_terminal())));
}

/// The columns of the terminal, if it is one.
fn width(is_terminal: bool) -> Option<usize> {
    is_terminal.then(textwrap::termwidth)
}

/// Lines of at most this width, where words allow it; what follows stands below the first word, a little further in. Options of a
/// command are for copying, and stay on their line.
fn fitted(text: &str, width: Option<usize>) -> Cow<'_, str> {
    let Some(width) = width else { return text.into() };
    let line = |line: &str| {
        let start = line.len() - line.trim_start().len();
        if line.trim_start().starts_with("--") {
            return line.to_owned();
        }
        let indent = " ".repeat(start + 4);
        let options = textwrap::Options::new(width).subsequent_indent(&indent).break_words(false);
        textwrap::fill(line, options.word_splitter(textwrap::WordSplitter::NoHyphenation))
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n").into()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_at_the_width_of_a_terminal_and_nowhere_else() {
        let text = "ok\n  one two three four\n    --point '{\"a\": 1, \"b\": 2}'\n";
        assert_eq!(fitted(text, None), text);
        assert_eq!(
            fitted(text, Some(14)),
            "ok\n  one two\n      three\n      four\n    --point '{\"a\": 1, \"b\": 2}'\n"
        );
        assert_eq!(fitted(&red("one two"), Some(7)), red("one two"), "colours take no room");
    }
}
