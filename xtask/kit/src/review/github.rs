//! GitHub workflow commands: they need no token, and work on forks.

use super::{Finding, by_place};
use anyhow::Context;
use std::io::Write;

/// The largest number of errors that a step shows.
const MOST: usize = 10;

/// One line for each place; the last line summarises all that a step would not show.
pub(crate) fn annotations(findings: &[Finding]) -> String {
    let findings = by_place(findings);
    let shown = if findings.len() > MOST { MOST - 1 } else { findings.len() };
    let mut lines: Vec<_> = findings[..shown].iter().map(annotation).collect();
    if let Some(next) = findings.get(shown) {
        let more = Finding { message: format!("and {} more", findings.len() - shown), ..next.clone() };
        lines.push(annotation(&more));
    }
    lines.concat()
}

fn annotation(finding: &Finding) -> String {
    let Finding { formula, claim, message, place } = finding;
    let title = property(&format!("{formula}: {claim}"));
    format!("::error file={},line={},title={title}::{}\n", property(&place.file), place.line, data(message))
}

fn data(text: &str) -> String {
    text.trim_end().replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

/// Adds Markdown to the summary of the step, if there is one.
pub(crate) fn summarise(markdown: &str) -> anyhow::Result<()> {
    let Some(path) = std::env::var_os("GITHUB_STEP_SUMMARY") else { return Ok(()) };
    let file = std::fs::OpenOptions::new().create(true).append(true).open(&path);
    let mut file = file.with_context(|| format!("cannot open {}", path.display()))?;
    Ok(writeln!(file, "{markdown}")?)
}
