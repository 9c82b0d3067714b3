//! The evidence from executed checks: kept between commands, and shown in the book.
//!
//! A record counts only for the code it was made with: each formula carries a fingerprint of the files on which its
//! evidence depends, and results of another version are discarded.

use crate::files;
use crate::project::Project;
use crate::sources::hash;
use jointproof::toolkit::verify::{Audit, Options};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The results of the last golden check and audit of this version of the code.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Evidence {
    /// By formula.
    fingerprints: BTreeMap<String, u64>,
    /// By formula.
    pub(crate) golden: BTreeMap<String, GoldenCheck>,
    /// By formula.
    pub(crate) audits: BTreeMap<String, Audit>,
    /// The digest of the program that audited each formula.
    #[serde(default)]
    auditors: BTreeMap<String, String>,
}

/// The result of a golden check.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct GoldenCheck {
    /// Cases regenerated and compared.
    pub(crate) cases: usize,
    /// Whether the file equals the generated one, byte for byte.
    pub(crate) same: bool,
}

impl Evidence {
    /// The evidence on this version of the code; empty if there is none.
    pub(crate) fn load(project: &Project) -> Self {
        let fingerprints = fingerprints(project);
        let text = std::fs::read_to_string(path(project)).unwrap_or_default();
        let stored: Self = serde_json::from_str(&text).unwrap_or_default();
        let is_of_this = |id: &String| {
            let found = fingerprints.get(id);
            found.is_some() && found == stored.fingerprints.get(id)
        };
        let golden = stored.golden.into_iter().filter(|(id, _)| is_of_this(id)).collect();
        let audits = stored.audits.into_iter().filter(|(id, _)| is_of_this(id)).collect();
        Self { fingerprints, golden, audits, auditors: stored.auditors }
    }

    /// Stores the audits of this program.
    pub(crate) fn add_audits(&mut self, audits: &[Audit]) {
        let program = program();
        for audit in audits {
            self.audits.insert(audit.formula.clone(), audit.clone());
            match program {
                Some(program) => self.auditors.insert(audit.formula.clone(), program.to_owned()),
                None => self.auditors.remove(&audit.formula),
            };
        }
    }

    /// By formula, the audits in which this same program with these options found every claim to hold. It would do so
    /// again, since an audit depends on nothing else.
    pub(crate) fn found_by_this_program(mut self, options: &Options) -> BTreeMap<String, Audit> {
        let Some(program) = program() else { return BTreeMap::new() };
        self.audits.retain(|id, audit| {
            let same = (audit.random_points, audit.seed) == (options.samples, options.seed);
            same && audit.passed() && self.auditors.get(id).is_some_and(|auditor| auditor == program)
        });
        self.audits
    }

    /// Saves the evidence.
    pub(crate) fn save(&self, project: &Project) -> anyhow::Result<()> {
        files::write(&path(project), &serde_json::to_string_pretty(self)?).map(drop)
    }
}

fn path(project: &Project) -> PathBuf {
    project.kept("evidence.json")
}

/// For every formula, the files on which its evidence depends.
type Reach = BTreeMap<String, Vec<PathBuf>>;

/// The reach for a version of the sources, which takes a while to determine.
#[derive(Serialize, Deserialize)]
struct Kept {
    fingerprint: u64,
    reach: Reach,
}

/// The files on which the evidence of every formula depends; `None` if the project does not define them, or the
/// sources cannot be read.
pub(crate) fn reach(project: &Project) -> Option<Reach> {
    let find = project.extension.reach?;
    let (fingerprint, path) = (fingerprint(project), project.kept("reach.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    if let Some(kept) = serde_json::from_str::<Kept>(&text).ok().filter(|kept| kept.fingerprint == fingerprint) {
        return Some(kept.reach);
    }
    let kept = Kept { fingerprint, reach: find(project).ok()? };
    // If it cannot be saved, it is determined again the next time.
    let _ = serde_json::to_string(&kept).map(|text| files::write(&path, &text));
    Some(kept.reach)
}

/// For every formula, a hash of the files on which its evidence depends.
fn fingerprints(project: &Project) -> BTreeMap<String, u64> {
    let Some(reach) = reach(project) else {
        let all = fingerprint(project);
        return project.catalog().iter().map(|formula| (formula.spec().id.to_owned(), all)).collect();
    };
    let mut known = BTreeMap::<PathBuf, u64>::new();
    let mut of_file = |file: &PathBuf| {
        *known.entry(file.clone()).or_insert_with(|| {
            let mut hasher = DefaultHasher::new();
            hash(project.root(), file, &mut hasher);
            hasher.finish()
        })
    };
    let mut of_files = |files: &Vec<PathBuf>| {
        let mut hasher = DefaultHasher::new();
        for file in files {
            hasher.write_u64(of_file(file));
        }
        hasher.finish()
    };
    reach.iter().map(|(id, files)| (id.clone(), of_files(files))).collect()
}

/// A hash of all sources and golden files.
pub(crate) fn fingerprint(project: &Project) -> u64 {
    let mut hasher = DefaultHasher::new();
    for directory in ["src", "golden"] {
        hash(project.root(), Path::new(directory), &mut hasher);
    }
    hasher.finish()
}

/// The SHA-256 of the running program; `None` if it cannot be read.
fn program() -> Option<&'static str> {
    static PROGRAM: LazyLock<Option<String>> =
        LazyLock::new(|| std::fs::read(std::env::current_exe().ok()?).ok().map(files::digest));
    PROGRAM.as_deref()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn what_was_reached_is_kept_for_this_version_alone() {
        let root = tempfile::tempdir().unwrap();
        let found = |_: &Project| Ok(Reach::from([("found".to_owned(), Vec::new())]));
        let project = Project::new("reached", root.path().to_str().unwrap().to_owned().leak(), &[]).with_reach(found);
        let keep = |fingerprint| {
            let kept = Kept { fingerprint, reach: Reach::from([("kept".to_owned(), Vec::new())]) };
            files::write(&project.kept("reach.json"), &serde_json::to_string(&kept).unwrap()).unwrap();
        };
        let is = |name| reach(&project).unwrap().into_keys().eq([name]);
        assert!(is("found") && is("found"));
        keep(fingerprint(&project));
        assert!(is("kept"));
        keep(!fingerprint(&project));
        assert!(is("found"));
    }

    /// The fingerprint of a formula depends on the content and the names of the files that it reaches.
    #[test]
    fn a_fingerprint_is_of_the_files_that_are_reached() {
        let root = tempfile::tempdir().unwrap();
        let write = |file: &str, text: &str| files::write(&root.path().join(file), text).unwrap();
        let reached = |_: &Project| {
            let reach = [("a.b", &["src/a.rs"][..]), ("a.c", &["src/a.rs", "src/c"])];
            Ok(reach.map(|(id, files)| (id.to_owned(), files.iter().map(PathBuf::from).collect())).into())
        };
        let project = Project::new("reached", root.path().to_str().unwrap().to_owned().leak(), &[]).with_reach(reached);
        let of = || fingerprints(&project).into_values().collect::<Vec<_>>();
        write("src/a.rs", "one");
        write("src/c/d.rs", "two");
        let first = of();
        assert_eq!(first, of());
        assert_ne!(first[0], first[1]);
        write("src/c/d.rs", "three");
        let second = of();
        assert!(second[0] == first[0] && second[1] != first[1]);
        std::fs::rename(root.path().join("src/c/d.rs"), root.path().join("src/c/e.rs")).unwrap();
        let third = of();
        assert!(third[0] == first[0] && third[1] != second[1]);
        write("src/a.rs", "four");
        assert!(of().iter().zip(&third).all(|(now, before)| now != before));
    }

    /// Measurements from one checkout are valid in any other with the same files.
    #[test]
    fn a_fingerprint_is_that_of_the_same_files_elsewhere() {
        let of = |text: &str| {
            let root = tempfile::tempdir().unwrap();
            files::write(&root.path().join("src/a/b.rs"), text).unwrap();
            fingerprint(&Project::new("elsewhere", root.path().to_str().unwrap().to_owned().leak(), &[]))
        };
        assert_eq!(of("one"), of("one"));
        assert_ne!(of("one"), of("two"));
    }

    /// Evidence is kept by formula: that of one does not affect the others.
    #[test]
    fn what_was_found_is_loaded_again_where_nothing_has_changed() {
        let root = tempfile::tempdir().unwrap();
        let found = |_: &Project| Ok(Reach::from([("t.first".to_owned(), vec![PathBuf::from("src/a.rs")])]));
        let project = Project::new("loaded", root.path().to_str().unwrap().to_owned().leak(), &[]).with_reach(found);
        let edit = |text: &str| files::write(&root.path().join("src/a.rs"), text).unwrap();
        let loaded = || Evidence::load(&project).audits.into_keys().collect::<Vec<_>>();
        edit("one");
        let mut evidence = Evidence::load(&project);
        // The files on which the second formula depends are unknown.
        evidence.add_audits(&[sample::passed(), sample::failed()]);
        evidence.save(&project).unwrap();
        assert_eq!(loaded(), ["t.first"]);
        edit("two");
        assert_eq!(loaded(), [""; 0]);
    }

    #[test]
    fn what_holds_is_known_to_the_program_that_found_it_with_these_options_alone() {
        let [passed, failed] = [sample::passed(), sample::failed()];
        let options = Options { samples: passed.random_points, seed: passed.seed };
        let known = |change: fn(&mut Evidence), options| {
            let mut evidence = Evidence::default();
            evidence.add_audits(&[passed.clone(), failed.clone()]);
            change(&mut evidence);
            evidence.found_by_this_program(&options).into_keys().collect::<Vec<_>>()
        };
        assert_eq!(known(|_| (), options), [passed.formula.as_str()]);
        let other = |evidence: &mut Evidence| evidence.auditors.values_mut().for_each(|program| program.push('0'));
        let none: [String; 0] = [];
        assert_eq!(known(other, options), none);
        assert_eq!(known(|evidence| evidence.auditors.clear(), options), none);
        assert_eq!(known(|_| (), Options { samples: options.samples + 1, ..options }), none);
        assert_eq!(known(|_| (), Options { seed: options.seed + 1, ..options }), none);
    }
}
