//! The differences between two golden files.

use super::file::{File, Record};
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;

impl File {
    /// The differences of `other`, which has been read from the committed file, from this one.
    pub fn differences(&self, other: &Self) -> Vec<Difference> {
        let mut differences = Vec::new();
        for case in &self.cases {
            match other.cases.iter().find(|candidate| candidate.id == case.id) {
                None => differences.push(Difference::new(&case.id, "", "absent", "present")),
                Some(committed) => case.compare(committed, &mut differences),
            }
        }
        for case in &other.cases {
            if !self.cases.iter().any(|candidate| candidate.id == case.id) {
                differences.push(Difference::new(&case.id, "", "present", "absent"));
            }
        }
        differences
    }
}

impl Record {
    fn compare(&self, committed: &Self, differences: &mut Vec<Difference>) {
        let tree = |record: &Self| serde_json::to_value(record).unwrap_or_default();
        compare_values(&self.id, "", &tree(committed), &tree(self), differences);
    }
}

fn compare_values(case: &str, field: &str, committed: &Value, now: &Value, differences: &mut Vec<Difference>) {
    match (committed, now) {
        (Value::Object(committed), Value::Object(now)) => {
            let mut names: Vec<_> = committed.keys().chain(now.keys()).collect();
            names.sort();
            names.dedup();
            for name in names {
                let part = |map: &Map<_, _>| map.get(name).cloned().unwrap_or_default();
                let path = if field.is_empty() { name.clone() } else { format!("{field}.{name}") };
                compare_values(case, &path, &part(committed), &part(now), differences);
            }
        }
        (Value::Array(committed), Value::Array(now)) if committed.len() == now.len() => {
            for (k, (committed, now)) in committed.iter().zip(now).enumerate() {
                compare_values(case, &format!("{field}[{k}]"), committed, now, differences);
            }
        }
        // -0.0 and 0.0 are equal, but differ as text.
        _ if text(committed) == text(now) => {}
        _ => {
            let mut difference = Difference::new(case, field, &text(committed), &text(now));
            difference.ulps = committed.as_f64().zip(now.as_f64()).map(|(a, b)| ulps(a, b));
            differences.push(difference);
        }
    }
}

fn text(value: &Value) -> String {
    value.to_string()
}

/// The number of doubles between two doubles.
pub fn ulps(a: f64, b: f64) -> u64 {
    let ordered = |x: f64| {
        let magnitude = i128::from(x.abs().to_bits());
        if x.is_sign_negative() { -magnitude } else { magnitude }
    };
    u64::try_from(ordered(a).abs_diff(ordered(b))).unwrap_or(u64::MAX)
}

/// A difference between a committed golden file and the current results.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// The case.
    pub case: String,
    /// The field: `out.fc`, `jac.fc.f2`; empty if the whole case differs.
    pub field: String,
    /// The value in the committed file.
    pub committed: String,
    /// The current value.
    pub now: String,
    /// Their distance, for numbers.
    pub ulps: Option<u64>,
}

impl Difference {
    fn new(case: &str, field: &str, committed: &str, now: &str) -> Self {
        let [case, field, committed, now] = [case, field, committed, now].map(String::from);
        Self { case, field, committed, now, ulps: None }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "case {}", self.case)?;
        if !self.field.is_empty() {
            write!(f, ", {}", self.field)?;
        }
        write!(f, ": committed {}, computed {}", self.committed, self.now)?;
        self.ulps.map_or(Ok(()), |ulps| write!(f, " ({ulps} ulp apart)"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::toolkit::verify::golden;
    use serde_json::json;

    #[test]
    fn doubles_between_two_are_counted_through_zero() {
        let tiny = f64::from_bits(1);
        for (a, b, expected) in [
            (1.0, 1.0, 0),
            (1.0, 1.0_f64.next_up(), 1),
            (-1.0, (-1.0_f64).next_up().next_up(), 2),
            (-tiny, tiny, 2),
            (0.0, -0.0, 0),
            (0.0, 1.0, 1.0_f64.to_bits()),
            (-1.0, 1.0, 2 * 1.0_f64.to_bits()),
        ] {
            assert_eq!((ulps(a, b), ulps(b, a)), (expected, expected), "{a} and {b}");
        }
    }

    fn differences(committed: &Value, now: &Value) -> Vec<String> {
        let mut all = Vec::new();
        compare_values("a", "", committed, now, &mut all);
        all.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_difference_says_where_it_is_and_how_large() {
        let committed = json!({"out": {"f": [1.0, 2.0]}, "only": 1, "zero": -0.0, "list": [1]});
        let now = json!({"out": {"f": [1.0, 2.0_f64.next_up()]}, "zero": 0.0, "list": [1, 2], "new": "so"});
        let expected = [
            "case a, list: committed [1], computed [1,2]",
            "case a, new: committed null, computed \"so\"",
            "case a, only: committed 1, computed null",
            "case a, out.f[1]: committed 2.0, computed 2.0000000000000004 (1 ulp apart)",
            "case a, zero: committed -0.0, computed 0.0 (0 ulp apart)",
        ];
        assert_eq!(differences(&committed, &now), expected);
        assert_eq!(differences(&now, &now), [""; 0]);
    }

    #[test]
    fn cases_that_are_in_one_file_alone_are_named() {
        let file = golden::of(&crate::toolkit::verify::Subject::of::<ContactForce>(), golden::LEAST_RANDOM);
        let [mut now, mut committed] = [file.clone(), file.clone()];
        now.cases.truncate(3);
        committed.cases.drain(..1);
        committed.cases.truncate(3);
        committed.cases[0].comment = "another".into();
        let ids: Vec<_> = file.cases.iter().map(|case| case.id.as_str()).collect();
        let [first, changed, last] = [ids[0], ids[1], ids[3]];
        let found: Vec<_> = now.differences(&committed).iter().map(ToString::to_string).collect();
        assert_eq!(found.len(), 3);
        assert_eq!(found[0], format!("case {first}: committed absent, computed present"));
        assert!(
            found[1].starts_with(&format!("case {changed}, comment: committed \"another\", computed ")),
            "{}",
            found[1]
        );
        assert_eq!(found[2], format!("case {last}: committed present, computed absent"));
        assert_eq!(file.differences(&file), []);
    }
}
