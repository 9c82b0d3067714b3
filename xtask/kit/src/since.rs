//! What has changed since a revision, and the formulas that it affects.

use crate::evidence;
use crate::outcome::Usage;
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The changed lines of each file that differs from a revision or is new; paths are from the root of the project.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    lines: BTreeMap<PathBuf, Vec<RangeInclusive<usize>>>,
    /// The files on which the evidence of each formula depends, if they are known.
    reach: Option<BTreeMap<String, Vec<PathBuf>>>,
}

impl Changes {
    pub(crate) fn since(project: &Project, revision: &str) -> anyhow::Result<Self> {
        let git = |arguments: &[&str]| -> anyhow::Result<String> {
            let output = Command::new("git").args(arguments).current_dir(project.root()).output();
            let output = output.map_err(|error| Usage(format!("--since needs git: {error}")))?;
            if !output.status.success() {
                let said = String::from_utf8_lossy(&output.stderr);
                return Err(Usage(format!("--since '{revision}': {}", said.trim())).into());
            }
            Ok(String::from_utf8_lossy(&output.stdout).into_owned())
        };
        let plain = ["-c", "core.quotePath=false", "-c", "diff.noprefix=false", "-c", "diff.mnemonicPrefix=false"];
        let diff = ["diff", "--unified=0", "--no-color", "--no-ext-diff", "--no-renames", "--relative", revision, "--"];
        let mut lines = hunks(&git(&[plain.as_slice(), &diff].concat())?);
        for new in git(&["ls-files", "--others", "--exclude-standard"])?.lines() {
            lines.insert(new.into(), vec![1..=usize::MAX]);
        }
        Ok(Self { lines, reach: evidence::reach(project) })
    }

    /// Those of the formulas whose evidence depends on a changed file. If the dependencies are unknown, any change of `src`
    /// or `golden` affects all formulas.
    pub(crate) fn touched<'a>(&self, formulas: &[&'a dyn AnyFormula]) -> Vec<&'a dyn AnyFormula> {
        let changed = self.lines.keys().cloned().collect();
        formulas.iter().filter(|formula| is_touched(self.files_of(**formula), &changed)).copied().collect()
    }

    fn files_of(&self, formula: &dyn AnyFormula) -> Option<&[PathBuf]> {
        self.reach.as_ref()?.get(formula.spec().id).map(Vec::as_slice)
    }

    /// The first changed line of a file within these.
    pub(crate) fn first(&self, file: &Path, within: RangeInclusive<usize>) -> Option<usize> {
        let changed = self.lines.get(file)?.iter();
        changed
            .map(|lines| *lines.start().max(within.start())..=*lines.end().min(within.end()))
            .find_map(|mut both| both.next())
    }

    /// The first changed line of Rust on which the evidence of a formula depends.
    pub(crate) fn below(&self, formula: &dyn AnyFormula) -> Option<(&Path, usize)> {
        let files =
            self.files_of(formula)?.iter().filter(|file| file.extension().is_some_and(|extension| extension == "rs"));
        files.map(PathBuf::as_path).find_map(|file| Some((file, self.first(file, 1..=usize::MAX)?)))
    }
}

/// The lines that a diff without context adds to each file. Where it only removes, it is the line before.
fn hunks(diff: &str) -> BTreeMap<PathBuf, Vec<RangeInclusive<usize>>> {
    let mut files = BTreeMap::<PathBuf, Vec<_>>::new();
    let mut file = PathBuf::new();
    for line in diff.lines() {
        if let Some(path) = line.strip_prefix("+++ ").or_else(|| line.strip_prefix("--- ")) {
            // What is gone has no new path.
            if let Some(path) = path.strip_prefix("a/").or_else(|| path.strip_prefix("b/")) {
                file = path.into();
                files.entry(file.clone()).or_default();
            }
        } else if let Some(added) = line.strip_prefix("@@ ").and_then(|hunk| hunk.split(['+', ' ']).nth(2)) {
            let (first, count) = added.split_once(',').unwrap_or((added, "1"));
            if let (Ok(first), Ok(count)) = (first.parse::<usize>(), count.parse::<usize>()) {
                let first = first.max(1);
                files.entry(file.clone()).or_default().push(first..=(first + count.saturating_sub(1)));
            }
        }
    }
    files
}

/// Whether evidence that depends on these files, if they are known, is affected by a change.
fn is_touched(files: Option<&[PathBuf]>, changed: &BTreeSet<PathBuf>) -> bool {
    match files {
        Some(files) => files.iter().any(|file| changed.contains(file)),
        None => changed.iter().any(|file| file.starts_with("src") || file.starts_with("golden")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_touches_what_rests_on_it() {
        let changed = |names: &[&str]| names.iter().map(PathBuf::from).collect::<BTreeSet<_>>();
        let slot = changed(&["README.md", "src/slot.rs"]);
        let [eft, slots] = ["src/eft.rs", "src/slot.rs"].map(PathBuf::from);
        assert!(is_touched(Some(&[slots, eft.clone()]), &slot) && !is_touched(Some(&[eft]), &slot));
        assert!(is_touched(None, &slot) && is_touched(None, &changed(&["golden/a.json", "README.md"])));
        assert!(!is_touched(None, &changed(&["README.md"])));
    }

    #[test]
    fn changed_lines_are_those_that_a_diff_adds() {
        let diff = "diff --git a/src/a.rs b/src/a.rs\nindex 1..2 100644\n--- a/src/a.rs\n+++ b/src/a.rs\n\
            @@ -3 +3,2 @@ fn a()\n-x\n+y\n+z\n@@ -9,2 +10,0 @@ fn b() -> (u8 + 1, 2)\n-x\n-y\n\
            diff --git a/src/b.rs b/src/b.rs\ndeleted file mode 100644\n--- a/src/b.rs\n+++ /dev/null\n@@ -1 +0,0 @@\n-x\n";
        let lines = hunks(diff);
        assert_eq!(lines[Path::new("src/a.rs")], [3..=4, 10..=10]);
        assert!(lines.contains_key(Path::new("src/b.rs")) && lines.len() == 2, "{lines:?}");
        let changes = Changes { lines, reach: None };
        let first = |within| changes.first(Path::new("src/a.rs"), within);
        assert_eq!([first(1..=9), first(4..=9), first(5..=9), first(5..=20)], [Some(3), Some(4), None, Some(10)]);
    }
}
