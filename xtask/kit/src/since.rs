//! The formulas that a change affects.

use crate::evidence;
use crate::outcome::Usage;
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;

/// Those of the formulas whose evidence depends on a file that has changed since a revision. If the dependencies are
/// unknown, any change of `src` or `golden` affects all formulas.
pub(crate) fn touched<'a>(
    project: &Project,
    formulas: &[&'a dyn AnyFormula],
    revision: &str,
) -> anyhow::Result<Vec<&'a dyn AnyFormula>> {
    let changed = changed(project, revision)?;
    let reach = evidence::reach(project);
    let files = |formula: &dyn AnyFormula| reach.as_ref().and_then(|reach| reach.get(formula.spec().id));
    Ok(formulas.iter().filter(|formula| is_touched(files(**formula).map(Vec::as_slice), &changed)).copied().collect())
}

/// Whether evidence that depends on these files, if they are known, is affected by a change.
fn is_touched(files: Option<&[PathBuf]>, changed: &BTreeSet<PathBuf>) -> bool {
    match files {
        Some(files) => files.iter().any(|file| changed.contains(file)),
        None => changed.iter().any(|file| file.starts_with("src") || file.starts_with("golden")),
    }
}

/// Every file that differs from the revision, or is new, from the root of the project.
fn changed(project: &Project, revision: &str) -> anyhow::Result<BTreeSet<PathBuf>> {
    let git = |arguments: &[&str]| -> anyhow::Result<String> {
        let output = Command::new("git").args(arguments).current_dir(project.root()).output();
        let output = output.map_err(|error| Usage(format!("--since needs git: {error}")))?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(Usage(format!("--since '{revision}': {}", said.trim())).into());
        }
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let differs = git(&["diff", "--name-only", "--relative", revision, "--"])?;
    let new = git(&["ls-files", "--others", "--exclude-standard"])?;
    Ok(differs.lines().chain(new.lines()).map(PathBuf::from).collect())
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
}
