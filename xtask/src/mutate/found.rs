//! What a run has found so far. It is written after every fault, so that a run that was cut short is gone on with.

use super::bench::Bench;
use super::fault::{Fault, Judged, Verdict};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

/// The file, beside the copy.
const RESULT: &str = "result.json";

/// What the runs before found; nothing where there were none.
pub(super) fn earlier(bench: &Bench) -> Vec<Judged> {
    let text = std::fs::read_to_string(bench.beside(RESULT)).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

/// What this run has found so far.
pub(super) struct Found {
    path: PathBuf,
    /// Of the runs before, the faults that this one leaves alone.
    others: Vec<Judged>,
    /// By the numbers of the faults.
    judged: Mutex<BTreeMap<usize, Judged>>,
}

impl Found {
    /// With what is known already of the faults that are `wanted`.
    pub(super) fn new(
        bench: &Bench,
        earlier: Vec<Judged>,
        known: BTreeMap<usize, Judged>,
        wanted: &[(usize, Fault)],
    ) -> Self {
        let wanted: BTreeSet<u64> = wanted.iter().map(|(_, fault)| fault.hash(0)).collect();
        let others = earlier.into_iter().filter(|one| !wanted.contains(&one.hash)).collect();
        Self { path: bench.beside(RESULT), others, judged: Mutex::new(known) }
    }

    /// One more, by its number.
    ///
    /// # Errors
    /// What the file system says.
    pub(super) fn add(&self, number: usize, one: Judged) -> anyhow::Result<()> {
        let mut judged = self.judged.lock().unwrap_or_else(PoisonError::into_inner);
        judged.insert(number, one);
        let all: Vec<&Judged> = judged.values().chain(&self.others).collect();
        crate::files::write(&self.path, &serde_json::to_string_pretty(&all)?)?;
        Ok(())
    }

    /// What this run has found, in the order of the faults' numbers.
    pub(super) fn all(self) -> Vec<Judged> {
        self.judged.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect()
    }
}

/// The faults that earlier runs noticed, by their hashes.
pub(super) struct Before(BTreeMap<u64, Verdict>);

impl Before {
    /// Of faults that read alike, all must have been noticed.
    pub(super) fn of(judged: &[Judged]) -> Self {
        let is_noticed = |verdict: &Verdict| matches!(verdict, Verdict::Killed(_) | Verdict::Stopped(_));
        let (noticed, others): (Vec<_>, Vec<_>) = judged.iter().partition(|one| is_noticed(&one.verdict));
        let others: BTreeSet<u64> = others.iter().map(|one| one.hash).collect();
        let verdicts = noticed.iter().filter(|one| !others.contains(&one.hash));
        Self(verdicts.map(|one| (one.hash, one.verdict.clone())).collect())
    }

    /// What came of this fault, if a test noticed it.
    pub(super) fn verdict(&self, fault: &Fault) -> Option<Verdict> {
        self.0.get(&fault.hash(0)).cloned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(file: &str, line: usize, becomes: &str) -> Fault {
        Fault {
            id: format!("{file}:{line}:1"),
            area: "sums".into(),
            file: file.into(),
            line,
            was: "+".into(),
            becomes: becomes.into(),
            equivalent: None,
            places: Vec::new(),
        }
    }

    #[test]
    fn what_was_noticed_is_known_wherever_it_moves_and_what_reads_alike_is_not() {
        let killed = || Verdict::Killed("tiny: tests::sums".into());
        let judged = [
            Judged::new(&fault("a.rs", 1, "-"), killed()),
            Judged::new(&fault("a.rs", 2, "*"), Verdict::Survived(3)),
            Judged::new(&fault("a.rs", 3, "/"), killed()),
            Judged::new(&fault("a.rs", 4, "/"), Verdict::Survived(1)),
            Judged { hash: 0, ..Judged::new(&fault("a.rs", 5, "%"), killed()) },
        ];
        let before = Before::of(&judged);
        let known = |line, becomes| before.verdict(&fault("a.rs", line, becomes));
        assert_eq!([known(1, "-"), known(70, "-")], [Some(killed()), Some(killed())]);
        assert_eq!([known(2, "*"), known(3, "/"), known(4, "/"), known(5, "%")], [None, None, None, None]);
        assert_eq!(before.verdict(&fault("b.rs", 1, "-")), None);
    }
}
