//! Formatting of results: colours, counts and figures.

const RED: &str = "\x1b[31m";
const GREEN: &str = "\x1b[32m";
const YELLOW: &str = "\x1b[33m";
const BOLD: &str = "\x1b[1m";
const PLAIN: &str = "\x1b[0m";

/// Red text; the stream drops the colour if it is not a terminal or `NO_COLOR` is set.
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
