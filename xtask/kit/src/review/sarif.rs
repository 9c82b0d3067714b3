//! SARIF 2.1.0. A result without a location makes the whole upload fail.

use super::{Finding, slug};
use crate::files::short_digest;
use serde_json::{Value, json};

/// One run with every finding; a run without findings clears those shown before.
pub(crate) fn sarif(findings: &[Finding]) -> anyhow::Result<String> {
    let mut claims: Vec<&str> = findings.iter().map(|finding| finding.claim.as_str()).collect();
    claims.sort_unstable();
    claims.dedup();
    let rule = |claim: &&str| json!({ "id": slug(claim), "shortDescription": { "text": claim } });
    let result = |finding: &Finding| {
        let Finding { formula, claim, message, place } = finding;
        let index = claims.iter().position(|known| known == claim);
        json!({
            "ruleId": slug(claim),
            "ruleIndex": index,
            "level": "error",
            "message": { "text": format!("{formula}: {claim}\n{message}") },
            "locations": [{ "physicalLocation": {
                "artifactLocation": { "uri": place.file, "uriBaseId": "%SRCROOT%" },
                "region": { "startLine": place.line },
            } }],
            "partialFingerprints": { "formulaAndClaim/v1": fingerprint(formula, claim) },
        })
    };
    let results: Vec<Value> = findings.iter().map(result).collect();
    let rules: Vec<Value> = claims.iter().map(rule).collect();
    Ok(serde_json::to_string_pretty(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": { "name": "jointproof", "version": env!("CARGO_PKG_VERSION"), "rules": rules } },
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    }))?)
}

/// Identifies a finding even if lines have moved.
fn fingerprint(formula: &str, claim: &str) -> String {
    short_digest(format!("{formula}\n{claim}"))
}

#[cfg(test)]
mod tests {
    use super::fingerprint;

    #[test]
    fn a_finding_is_known_by_formula_and_claim() {
        let one = fingerprint("slot.friction", "closed form");
        assert_eq!(one.len(), 16);
        assert_eq!(one, fingerprint("slot.friction", "closed form"));
        assert!(one != fingerprint("slot.yield", "closed form") && one != fingerprint("slot.friction", "symmetry"));
    }
}
