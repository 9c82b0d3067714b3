//! RDFormat, which `reviewdog` forwards to GitLab, Gerrit and Gitea.

use super::{Finding, by_place, slug};
use serde_json::{Value, json};

/// A diagnostic for each place.
pub(crate) fn rdjson(findings: &[Finding]) -> anyhow::Result<String> {
    let diagnostic = |finding: &Finding| {
        let Finding { formula, claim, message, place } = finding;
        json!({
            "message": format!("{formula}: {claim}\n{message}"),
            "location": { "path": place.file, "range": { "start": { "line": place.line, "column": 1 } } },
            "severity": "ERROR",
            "code": { "value": slug(claim) },
        })
    };
    let diagnostics: Vec<Value> = by_place(findings).iter().map(diagnostic).collect();
    Ok(serde_json::to_string_pretty(&json!({ "source": { "name": "jointproof" }, "diagnostics": diagnostics }))?)
}
