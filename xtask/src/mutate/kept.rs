//! What came of whole areas, kept for the book.

use super::fault::{Judged, Verdict};
use super::table::{Score, by, checker};
use anyhow::Context;
use kit::{Project, Table};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// The file, from the root.
const FILE: &str = "tests/data/faults.json";

/// What is kept of an area.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Kept {
    /// The day, as `2026-11-23`.
    date: String,
    /// The revision that the faults were planted in.
    commit: String,
    machine: String,
    /// Which tests were run, and how long.
    tests: String,
    faults: Vec<Judged>,
}

/// Puts these areas in the place of what is kept of them.
///
/// # Errors
/// What the file system says.
pub(super) fn keep(root: &Path, judged: &[Judged], tests: &str) -> anyhow::Result<()> {
    let path = root.join(FILE);
    let mut kept = if path.exists() { read(root)? } else { BTreeMap::new() };
    let said = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).current_dir(root).output();
        output.map_or(String::new(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let date = said("date", &["-u", "+%Y-%m-%d"]);
    let commit = said("git", &["rev-parse", "--short=10", "HEAD"]);
    let machine = format!("{}, {} cores", said("uname", &["-sm"]), std::thread::available_parallelism()?);
    for name in by(judged, |one| Some(&one.area)).into_keys() {
        let faults = judged.iter().filter(|one| one.area == name).cloned().collect();
        let (date, commit, machine) = (date.clone(), commit.clone(), machine.clone());
        let area = Kept { date, commit, machine, tests: tests.to_owned(), faults };
        kept.insert(name.to_owned(), area);
    }
    crate::files::write(&path, &(serde_json::to_string_pretty(&kept)? + "\n"))?;
    Ok(())
}

/// Every fault that is kept, of all areas; none where there is no such file.
pub(super) fn judged(root: &Path) -> Vec<Judged> {
    read(root).unwrap_or_default().into_values().flat_map(|area| area.faults).collect()
}

fn read(root: &Path) -> anyhow::Result<BTreeMap<String, Kept>> {
    let path = root.join(FILE);
    let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    serde_json::from_str(&text).with_context(|| path.display().to_string())
}

/// The tables of the chapter: `faults-by-area`, `faults-by-file`, `faults-by-checker`, `faults-that-live`.
///
/// # Errors
/// That what is kept cannot be read.
pub(crate) fn tables(project: &Project) -> anyhow::Result<Vec<(String, Vec<Table>)>> {
    let kept = read(project.root())?;
    let judged: Vec<Judged> = kept.values().flat_map(|area| area.faults.iter().cloned()).collect();
    let tables = [
        ("faults-by-area", by_area(&kept, &judged)),
        ("faults-by-formula", by_formula(project, &judged)),
        ("faults-by-checker", by_checker(&judged)),
        ("faults-that-live", that_live(&judged)),
        ("faults-equivalent", equivalent(&judged)),
    ];
    Ok(tables.map(|(name, table)| (name.to_owned(), vec![table])).into())
}

/// How many there are in all, for the text.
///
/// # Errors
/// That what is kept cannot be read.
pub(crate) fn texts(project: &Project) -> anyhow::Result<Vec<(String, String)>> {
    let kept = read(project.root())?;
    let score = Score::of(kept.values().flat_map(|area| &area.faults));
    let Score { killed, stopped, survived, equivalent } = score;
    let text = format!(
        "Of {} faults in {} areas, {equivalent} change nothing that could be noticed. Of the others, tests noticed \
         **{killed}**, {stopped} of them because the program ran on or ended without a word, and did not notice **{survived}**: \
         {:.1} %.",
        killed + survived + equivalent,
        kept.len(),
        100.0 * score.rate(),
    );
    Ok(vec![("faults".to_owned(), text)])
}

fn table(head: &[&str], rows: Vec<Vec<String>>) -> Table {
    Table { head: head.iter().map(|&cell| cell.to_owned()).collect(), rows, ..Table::default() }
}

fn cells(name: &str, score: Score) -> Vec<String> {
    let Score { killed, survived, equivalent, .. } = score;
    let rate = if killed + survived == 0 { "–".to_owned() } else { format!("{:.0} %", 100.0 * score.rate()) };
    vec![name.to_owned(), killed.to_string(), survived.to_string(), equivalent.to_string(), rate]
}

fn by_area(kept: &BTreeMap<String, Kept>, judged: &[Judged]) -> Table {
    let row = |(name, score): (&str, Score)| {
        let run = kept.get(name).map_or(String::new(), |area| {
            format!("{}, `{}`, {}, {}", area.date, area.commit, area.machine, area.tests)
        });
        [cells(name, score), vec![run]].concat()
    };
    let rows = by(judged, |one| Some(&one.area)).into_iter().map(row).collect();
    table(
        &[
            "area",
            "noticed",
            "not noticed",
            "change nothing",
            "rate",
            "when, at which revision, on what, with which tests",
        ],
        rows,
    )
}

/// A formula's faults are those in the file that it is written in.
fn by_formula(project: &Project, judged: &[Judged]) -> Table {
    let files = by(judged, |one| Some(&one.file));
    let row = |formula: &&dyn jointproof::catalog::AnyFormula| {
        let name = formula.path().rsplit("::").next()?;
        let is_its = |file: &&&str| defines(&project.root().join(file), name);
        let score = files.get(files.keys().find(is_its)?)?;
        Some(cells(&format!("`{}`", formula.spec().id), *score))
    };
    let rows = project.catalog().iter().filter_map(row).collect();
    table(&["formula", "noticed", "not noticed", "change nothing", "rate"], rows)
}

/// Whether the equation of this type is written in this file.
fn defines(file: &Path, name: &str) -> bool {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    text.contains(&format!("impl Formula for {name} "))
}

fn by_checker(judged: &[Judged]) -> Table {
    let mut rows: Vec<_> = by(judged, checker).into_iter().map(|(name, score)| (score.killed, name)).collect();
    rows.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(b.1)));
    let rows = rows.into_iter().map(|(killed, name)| vec![format!("`{name}`"), killed.to_string()]).collect();
    table(&["tests", "noticed first"], rows)
}

fn that_live(judged: &[Judged]) -> Table {
    let rows = judged.iter().filter_map(|one| match one.verdict {
        Verdict::Survived(tests) => Some(vec![one.area.clone(), one.change(), tests.to_string()]),
        _ => None,
    });
    table(&["area", "change", "tests that come there"], rows.collect())
}

fn equivalent(judged: &[Judged]) -> Table {
    let rows = judged.iter().filter_map(|one| match &one.verdict {
        Verdict::Equivalent(why) => Some(vec![one.area.clone(), one.change(), why.clone()]),
        _ => None,
    });
    table(&["area", "change", "why nothing can notice it"], rows.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutate::fault::Verdict;

    #[test]
    fn a_run_replaces_its_areas_and_leaves_the_others() {
        let root = tempfile::tempdir().unwrap();
        let judged_in = |area: &str, id: &str, verdict| Judged {
            id: id.to_owned(),
            area: area.to_owned(),
            file: "src/a.rs".to_owned(),
            line: 1,
            was: "+".to_owned(),
            becomes: "-".to_owned(),
            hash: 1,
            verdict,
        };
        let [first, other, second] = [
            judged_in("sums", "first", Verdict::Survived(2)),
            judged_in("roots", "other", Verdict::Survived(0)),
            judged_in("sums", "second", Verdict::Killed("tiny: tests::sums".into())),
        ];
        keep(root.path(), &[first, other.clone()], "all").unwrap();
        keep(root.path(), std::slice::from_ref(&second), "few").unwrap();
        let found: Vec<_> = judged(root.path()).into_iter().map(|one| (one.id, one.verdict)).collect();
        assert_eq!(found, [other, second].map(|one| (one.id, one.verdict)));
    }

    #[test]
    fn tables_show_areas_checkers_and_what_lives_or_changes_nothing() {
        let one = |area: &str, verdict| Judged {
            id: "a.b".to_owned(),
            area: area.to_owned(),
            file: "src/a.rs".to_owned(),
            line: 3,
            was: "+".to_owned(),
            becomes: "-".to_owned(),
            hash: 1,
            verdict,
        };
        let killed = |test: &str| Verdict::Killed(test.to_owned());
        let judged = [
            one("sums", killed("late: a")),
            one("sums", Verdict::Stopped("often: b".into())),
            one("sums", killed("often: c")),
            one("sums", killed("early: d")),
            one("roots", Verdict::Survived(4)),
            one("roots", Verdict::Equivalent("nobody asks".into())),
        ];
        let kept = Kept {
            date: "today".into(),
            commit: "0123".into(),
            machine: "a machine".into(),
            tests: "all".into(),
            faults: Vec::new(),
        };
        let rows = |table: Table| {
            assert!(table.rows.iter().all(|row| row.len() == table.head.len()));
            table.rows.iter().map(|row| row.join(" | ")).collect::<Vec<_>>()
        };
        let areas = by_area(&BTreeMap::from([("sums".to_owned(), kept)]), &judged);
        assert_eq!(
            rows(areas),
            ["roots | 0 | 1 | 1 | 0 % | ", "sums | 4 | 0 | 0 | 100 % | today, `0123`, a machine, all"]
        );
        assert_eq!(rows(by_checker(&judged)), ["`often` | 2", "`early` | 1", "`late` | 1"]);
        assert_eq!(rows(that_live(&judged)), ["roots | src/a.rs:3: `+` → `-` | 4"]);
        assert_eq!(rows(equivalent(&judged)), ["roots | src/a.rs:3: `+` → `-` | nobody asks"]);
    }

    #[test]
    fn a_rate_is_of_what_can_be_noticed() {
        let rate = |killed, survived| cells("", Score { killed, survived, equivalent: 3, stopped: 0 })[4].clone();
        assert_eq!([rate(0, 0), rate(1, 0), rate(3, 1)], ["–", "100 %", "75 %"]);
    }

    #[test]
    fn a_formula_is_where_it_is_implemented() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/slot/friction.rs");
        assert!(defines(&file, "Friction") && !defines(&file, "RelativePosition"));
        assert!(!defines(&file.with_file_name("none.rs"), "Friction"));
    }
}
