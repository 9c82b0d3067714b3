//! Which tests have noticed faults of a file: they are likely to notice others of it.

use super::fault::{Judged, Verdict};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, PoisonError};

/// Tests by the file whose faults they noticed, each as `program: test`.
#[derive(Default)]
pub(super) struct Noticed(Mutex<BTreeMap<String, BTreeSet<String>>>);

impl Noticed {
    /// What earlier runs found.
    pub(super) fn of(judged: &[Judged]) -> Self {
        let noticed = Self::default();
        for one in judged {
            noticed.add(&one.file, &one.verdict);
        }
        noticed
    }

    /// What came of a fault of this file.
    pub(super) fn add(&self, file: &str, verdict: &Verdict) {
        if let Verdict::Killed(test) | Verdict::Stopped(test) = verdict {
            let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            all.entry(file.to_owned()).or_default().insert(test.clone());
        }
    }

    /// The tests that have noticed faults of this file.
    pub(super) fn in_file(&self, file: &str) -> BTreeSet<String> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(file).cloned().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_the_tests_that_noticed_faults_of_it() {
        let judged = |file: &str, verdict| Judged {
            id: "a.b".into(),
            area: "a".into(),
            file: file.into(),
            line: 1,
            was: "+".into(),
            becomes: "-".into(),
            hash: 1,
            verdict,
        };
        let noticed = Noticed::of(&[
            judged("src/a.rs", Verdict::Killed("p: one".into())),
            judged("src/a.rs", Verdict::Stopped("p: two".into())),
            judged("src/a.rs", Verdict::Survived(3)),
            judged("src/b.rs", Verdict::Killed("p: three".into())),
        ]);
        noticed.add("src/b.rs", &Verdict::Killed("p: one".into()));
        let of = |file: &str| noticed.in_file(file).into_iter().collect::<Vec<_>>();
        assert_eq!(
            (of("src/a.rs"), of("src/b.rs")),
            (vec!["p: one".into(), "p: two".into()], vec!["p: one".to_owned(), "p: three".into()])
        );
        assert!(of("src/c.rs").is_empty());
    }
}
