//! Which formulas a change touches.

use crate::evidence;
use crate::outcome::Usage;
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;

/// Those of the formulas whose evidence rests on a file that is not as it was at a revision. Where nobody says on what it rests,
/// any change of `src` or `golden` touches all.
pub(crate) fn touched<'a>(
    project: &Project,
    formulas: &[&'a dyn AnyFormula],
    revision: &str,
) -> anyhow::Result<Vec<&'a dyn AnyFormula>> {
    project.needs_repository("audit --since", "")?;
    let changed = changed(project, revision)?;
    let reach = evidence::reach(project);
    let is_touched = |formula: &&&dyn AnyFormula| {
        let files = reach.as_ref().and_then(|reach| reach.get(formula.spec().id));
        files.map_or_else(
            || changed.iter().any(|file| file.starts_with("src") || file.starts_with("golden")),
            |files| files.iter().any(|file| changed.contains(file)),
        )
    };
    Ok(formulas.iter().filter(is_touched).copied().collect())
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
