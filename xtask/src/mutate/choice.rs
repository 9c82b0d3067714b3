//! Which faults are planted: all of the lists, and so many made by rule that every file of an area has its share.

use super::area::Area;
use super::fault::Fault;
use super::rules::Made;
use super::sites::Sites;
use anyhow::Context;
use std::collections::{BTreeMap, BTreeSet};

/// The faults that there could be.
pub(super) struct Choice {
    kept: Vec<Fault>,
    /// Those made by rule, of each area, in the order in which they are taken.
    made: Vec<Vec<Fault>>,
}

impl Choice {
    /// Reads areas and sources. Another seed takes other faults.
    ///
    /// # Errors
    /// What is wrong with a list or a source.
    pub(super) fn read(areas: &[Area], sources: &BTreeMap<String, String>, seed: u64) -> anyhow::Result<Self> {
        let mut choice = Self { kept: Vec::new(), made: Vec::new() };
        for area in areas {
            choice.kept.extend(area.kept(sources)?);
            let mut ranked = Vec::new();
            for (file, text) in sources.iter().filter(|(file, _)| area.has(file)) {
                let sites = Sites::read(text).with_context(|| file.clone())?;
                let mut faults: Vec<_> = sites.rules.made.into_iter().map(|made| fault(area, file, made)).collect();
                for fault in &mut faults {
                    fault.equivalent = area.why_harmless(fault, text);
                }
                faults.sort_by_key(|fault| fault.hash(seed));
                ranked.extend(faults.into_iter().enumerate());
            }
            // First one of every file, then a second one.
            ranked.sort_by_key(|(rank, fault)| (*rank, fault.hash(seed)));
            choice.made.push(ranked.into_iter().map(|(_, fault)| fault).collect());
        }
        Ok(choice)
    }

    /// The names of those of the lists that the compiler refuses.
    pub(super) fn refused(&self, refused: &BTreeSet<String>) -> Vec<&str> {
        self.kept.iter().filter(|fault| refused.contains(&key(fault))).map(|fault| fault.id.as_str()).collect()
    }

    /// All of the lists, and `per_area` that are made by rule, without those that the compiler refuses.
    pub(super) fn take(&self, per_area: usize, refused: &BTreeSet<String>) -> Vec<Fault> {
        let is_taken = |fault: &&Fault| !refused.contains(&key(fault));
        let made = self.made.iter().flat_map(|made| made.iter().filter(is_taken).take(per_area));
        self.kept.iter().filter(is_taken).chain(made).cloned().collect()
    }
}

fn fault(area: &Area, file: &str, made: Made) -> Fault {
    let Made { at: (line, column), was, becomes, place } = made;
    let (id, area, file) = (format!("{file}:{line}:{column}"), area.name.clone(), file.to_owned());
    Fault { id, area, file, line, was, becomes, equivalent: None, places: vec![place] }
}

/// What tells it from every other fault, and from what bore its name before a source was changed.
pub(super) fn key(fault: &Fault) -> String {
    format!("{} {:016x}", fault.id, fault.hash(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutate::area;

    #[test]
    fn every_file_has_its_share_before_one_has_a_second() {
        let root = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(root.path().join(area::FOLDER)).unwrap();
        std::fs::write(root.path().join(area::FOLDER).join("a.toml"), "files = [\"src/**\"]\n").unwrap();
        let text = "fn f(x: f64) -> f64 {\n    x + 1.5 * x - x / 2.5\n}\n";
        let names = ["src/a.rs", "src/b.rs", "src/c.rs", "other/d.rs"];
        let sources = names.map(|name| (name.to_owned(), text.to_owned())).into();
        let choice = Choice::read(&area::read(root.path()).unwrap(), &sources, 0).unwrap();
        for rounds in 1..4 {
            let taken = choice.take(3 * rounds, &BTreeSet::new());
            let of = |file: &str| taken.iter().filter(|fault| fault.file == file).count();
            assert_eq!(names.map(of), [rounds, rounds, rounds, 0]);
        }
        // Those that are refused are made good by others.
        let first = choice.take(1, &BTreeSet::new());
        let others = choice.take(1, &first.iter().map(key).collect());
        assert_eq!((first.len(), others.len()), (1, 1));
        assert!(first[0] != others[0]);
    }
}
