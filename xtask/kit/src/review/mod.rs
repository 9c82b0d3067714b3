//! Findings in the formats that reviewers' tools read. Every finding has a location.

mod github;
mod place;
mod rdjson;
mod sarif;

pub(crate) use github::{annotations, summarise};
pub(crate) use place::{Place, of_claim};
pub(crate) use rdjson::rdjson;
pub(crate) use sarif::sarif;

use std::fmt::Write as _;

/// A failed claim.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    /// The identifier of the formula.
    pub(crate) formula: String,
    /// The claim that fails, in a few words.
    pub(crate) claim: String,
    /// The deviation, its point, and how to reproduce it.
    pub(crate) message: String,
    /// Its location in the sources.
    pub(crate) place: Place,
}

/// One finding for each place, since one fault makes several claims fail, and often of several formulas. The first is kept in full.
fn by_place(findings: &[Finding]) -> Vec<Finding> {
    let mut places = Vec::<Finding>::new();
    for finding in findings {
        match places.iter_mut().find(|first| first.place == finding.place) {
            Some(first) => {
                let _ = write!(first.message, "\nalso: {}: {}", finding.formula, finding.claim);
            }
            None => places.push(finding.clone()),
        }
    }
    places
}

/// A claim as an identifier: lower-case letters, digits and `-`.
fn slug(claim: &str) -> String {
    let words = claim.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn findings(count: usize) -> Vec<Finding> {
        let finding = |k: usize| Finding {
            formula: format!("family.formula{k}"),
            claim: "η of the value in f64".into(),
            message: "found 1, expected 2\n--point '{\"x\": 100%}'".into(),
            place: Place { file: "src/a,b.rs".into(), line: k + 1 },
        };
        (0..count).map(finding).collect()
    }

    #[test]
    fn workflow_commands_are_escaped_and_at_most_ten() {
        let text = annotations(&findings(2));
        let expected = "::error file=src/a%2Cb.rs,line=1,title=family.formula0%3A η of the value in f64::found 1, expected 2%0A--point '{\"x\": 100%25}'";
        assert_eq!(text.lines().next(), Some(expected));
        let ten = annotations(&findings(10));
        assert!(ten.lines().count() == 10 && !ten.contains(" more"), "{ten}");
        let eleven = annotations(&findings(11));
        assert!(
            eleven.lines().count() == 10
                && eleven.ends_with(",line=10,title=family.formula9%3A η of the value in f64::and 2 more\n"),
            "{eleven}"
        );
        let many = annotations(&findings(12));
        assert_eq!(many.lines().count(), 10);
        assert!(many.lines().last().unwrap().ends_with("::and 3 more"), "{many}");
        assert_eq!(annotations(&[]), "");
    }

    #[test]
    fn what_fails_at_one_place_is_one_annotation() {
        let mut findings = findings(3);
        findings[2].place = findings[0].place.clone();
        let text = annotations(&findings);
        assert_eq!(text.lines().count(), 2);
        assert!(
            text.lines().next().unwrap().ends_with("100%25}'%0Aalso: family.formula2: η of the value in f64"),
            "{text}"
        );
    }

    #[test]
    fn sarif_has_what_its_schema_requires() {
        let log: Value = serde_json::from_str(&sarif(&findings(3)).unwrap()).unwrap();
        assert_eq!((&log["version"], log["runs"].as_array().unwrap().len()), (&Value::from("2.1.0"), 1));
        let run = &log["runs"][0];
        assert!(run["tool"]["driver"]["name"].is_string());
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        assert_eq!(rules.len(), 1, "one claim is one rule");
        for result in run["results"].as_array().unwrap() {
            assert_eq!(result["ruleId"], rules[usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap()]["id"]);
            assert!(result["message"]["text"].is_string() && result["level"] == "error");
            let place = &result["locations"][0]["physicalLocation"];
            assert_eq!(place["artifactLocation"]["uri"], "src/a,b.rs");
            assert!(place["region"]["startLine"].as_u64().unwrap() > 0);
            assert!(result["partialFingerprints"]["formulaAndClaim/v1"].is_string());
        }
        // Each claim is one rule, however its findings are mixed with others.
        let mut mixed = findings(4);
        (mixed[0].claim, mixed[2].claim) = ("symmetry".into(), "symmetry".into());
        let log: Value = serde_json::from_str(&sarif(&mixed).unwrap()).unwrap();
        let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
        let ids: Vec<_> = rules.iter().filter_map(|rule| rule["id"].as_str()).collect();
        assert_eq!(ids, ["symmetry", "η-of-the-value-in-f64"]);
        let indices = log["runs"][0]["results"].as_array().unwrap().iter().map(|result| result["ruleIndex"].as_u64());
        assert!(indices.eq([0, 1, 0, 1].map(Some)));
        let empty: Value = serde_json::from_str(&sarif(&[]).unwrap()).unwrap();
        assert_eq!(empty["runs"][0]["results"], Value::Array(Vec::new()), "what was on a page before is taken away");
    }

    #[test]
    fn rdjson_names_path_and_line() {
        let found: Value = serde_json::from_str(&rdjson(&findings(1)).unwrap()).unwrap();
        let diagnostic = &found["diagnostics"][0];
        assert_eq!(diagnostic["location"]["path"], "src/a,b.rs");
        assert_eq!(diagnostic["location"]["range"]["start"]["line"], 1);
        assert_eq!(
            (&diagnostic["severity"], &diagnostic["code"]["value"]),
            (&"ERROR".into(), &"η-of-the-value-in-f64".into())
        );
    }
}
