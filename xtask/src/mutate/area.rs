//! Areas: which files belong together, and the faults in them that are kept in a list. They stand in `tests/faults`.

use super::fault::{Fault, Place};
use super::sites::Sites;
use anyhow::{Context, bail, ensure};
use globset::{GlobBuilder, GlobSet, GlobSetBuilder};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// The folder of the lists, from the root.
pub(super) const FOLDER: &str = "tests/faults";

/// An area.
pub(super) struct Area {
    /// Its name, which is that of its file.
    pub(super) name: String,
    files: GlobSet,
    except: GlobSet,
    kept: Vec<Kept>,
    harmless: Vec<Harmless>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    /// The files that belong to the area, as patterns.
    files: Vec<String>,
    /// And those of them that do not.
    #[serde(default)]
    except: Vec<String>,
    #[serde(default)]
    fault: Vec<Kept>,
    #[serde(default)]
    harmless: Vec<Harmless>,
}

/// Faults made by rule that nothing can notice.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Harmless {
    file: String,
    /// The line, without the spaces around it.
    line: String,
    was: String,
    why: String,
}

/// A fault in a list.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Kept {
    id: String,
    file: String,
    /// A text before the one that is changed, where that alone stands there more than once.
    after: Option<String>,
    /// What is changed; an empty line in the report is worse than a long one here.
    find: String,
    put: String,
    /// Why nothing can notice it.
    equivalent: Option<String>,
}

/// Every area, in the order of their names.
///
/// # Errors
/// What is wrong with a list.
pub(super) fn read(root: &Path) -> anyhow::Result<Vec<Area>> {
    let folder = root.join(FOLDER);
    let entries = std::fs::read_dir(&folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut paths: Vec<_> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    let lists = paths.iter().filter(|path| path.extension().is_some_and(|end| end == "toml"));
    lists.map(|path| Area::read(path).with_context(|| path.display().to_string())).collect()
}

impl Area {
    fn read(path: &Path) -> anyhow::Result<Self> {
        let List { files, except, fault, harmless } = toml::from_str(&std::fs::read_to_string(path)?)?;
        let name = path.file_stem().context("a file has a name")?.to_string_lossy().into_owned();
        Ok(Self { name, files: globs(&files)?, except: globs(&except)?, kept: fault, harmless })
    }

    pub(super) fn has(&self, file: &str) -> bool {
        self.files.is_match(file) && !self.except.is_match(file)
    }

    /// Why nothing can notice a fault made by rule in this source, if so.
    pub(super) fn why_harmless(&self, fault: &Fault, text: &str) -> Option<String> {
        let line = text.lines().nth(fault.line - 1)?.trim();
        let is_it = |known: &&Harmless| (&*known.file, &*known.line, &*known.was) == (&*fault.file, line, &*fault.was);
        self.harmless.iter().find(is_it).map(|known| known.why.clone())
    }

    /// The faults of the list.
    ///
    /// # Errors
    /// A text that is not there, or more than once; a file that belongs to another area; a line of what is harmless that is gone.
    pub(super) fn kept(&self, sources: &BTreeMap<String, String>) -> anyhow::Result<Vec<Fault>> {
        for Harmless { file, line, .. } in &self.harmless {
            let is_there = sources.get(file).is_some_and(|text| text.lines().any(|there| there.trim() == line));
            ensure!(is_there, "{}: {file} has no line {line:?} that could be harmless", self.name);
        }
        self.kept
            .iter()
            .map(|kept| self.fault(kept, sources).with_context(|| format!("{}: {}", self.name, kept.id)))
            .collect()
    }

    fn fault(&self, kept: &Kept, sources: &BTreeMap<String, String>) -> anyhow::Result<Fault> {
        let Kept { id, file, find, put, equivalent, .. } = kept;
        ensure!(self.has(file), "{file} is not of this area");
        let text = sources.get(file).with_context(|| format!("there is no {file}"))?;
        let range = kept.find(text)?;
        let places = places(text, &range, put)?;
        ensure!(!places.is_empty(), "no function has it, so that it cannot be switched");
        let line = 1 + text[..range.start].matches('\n').count();
        Ok(Fault {
            id: format!("{}.{id}", self.name),
            area: self.name.clone(),
            file: file.clone(),
            line,
            was: find.clone(),
            becomes: put.clone(),
            equivalent: equivalent.clone(),
            places,
        })
    }
}

impl Kept {
    /// Where the text that is changed stands.
    fn find(&self, text: &str) -> anyhow::Result<Range<usize>> {
        let once = |text: &str, wanted: &str| match text.matches(wanted).count() {
            0 => bail!("{} has no {wanted:?}", self.file),
            1 => Ok(text.find(wanted).expect("it was counted")),
            times => bail!("{} has {wanted:?} {times} times: `after` says which", self.file),
        };
        let start = match &self.after {
            None => once(text, &self.find)?,
            Some(after) => {
                let from = once(text, after)? + after.len();
                from + text[from..]
                    .find(&self.find)
                    .with_context(|| format!("behind {after:?} is no {:?}", self.find))?
            }
        };
        Ok(start..start + self.find.len())
    }
}

/// What encloses a change and can be there twice, the smallest first.
fn places(text: &str, change: &Range<usize>, put: &str) -> anyhow::Result<Vec<Place>> {
    let sites = Sites::read(text)?;
    let enclosing =
        sites.places.into_iter().filter(|(range, _)| range.start <= change.start && change.end <= range.end);
    let place = |(range, shape): (Range<usize>, _)| {
        let text = [&text[range.start..change.start], put, &text[change.end..range.end]].concat();
        Place { range, text, shape }
    };
    let mut places: Vec<_> = enclosing.map(place).collect();
    places.sort_by_key(|place| place.range.len());
    Ok(places)
}

/// A `*` is within a folder, `**` is any folders.
fn globs(patterns: &[String]) -> anyhow::Result<GlobSet> {
    let mut set = GlobSetBuilder::new();
    for pattern in patterns {
        set.add(GlobBuilder::new(pattern).literal_separator(true).build()?);
    }
    Ok(set.build()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_found_once_or_behind_another() {
        let find = |after: Option<&str>, wanted: &str| {
            let kept = Kept {
                id: "a".into(),
                file: "src/a.rs".into(),
                after: after.map(str::to_owned),
                find: wanted.into(),
                put: String::new(),
                equivalent: None,
            };
            kept.find("one two three two").map_err(|error| error.to_string())
        };
        assert_eq!(find(None, "three"), Ok(8..13));
        assert_eq!(find(Some("three"), "two"), Ok(14..17));
        assert_eq!(find(Some("one"), "two"), Ok(4..7));
        // Behind it, not in it.
        assert_eq!(find(Some("one two "), "t"), Ok(8..9));
        assert_eq!(find(None, "two"), Err("src/a.rs has \"two\" 2 times: `after` says which".into()));
        assert_eq!(find(Some("three two"), "two"), Err("behind \"three two\" is no \"two\"".into()));
    }

    #[test]
    fn a_harmless_line_that_is_gone_is_refused() {
        let known =
            |line: &str| Harmless { file: "src/a.rs".into(), line: line.into(), was: "+".into(), why: String::new() };
        let kept = |line: &str| {
            let (files, except) = (globs(&["src/**".into()]).unwrap(), GlobSet::empty());
            let area = Area { name: "a".into(), files, except, kept: Vec::new(), harmless: vec![known(line)] };
            let sources = [("src/a.rs".to_owned(), "fn f() {\n    x + 1;\n}\n".to_owned())].into();
            area.kept(&sources).map(|faults| faults.len()).map_err(|error| error.to_string())
        };
        assert_eq!(kept("x + 1;"), Ok(0));
        assert_eq!(kept("x + 1"), Err("a: src/a.rs has no line \"x + 1\" that could be harmless".into()));
    }

    #[test]
    fn of_the_places_around_a_change_the_smallest_comes_first() {
        let text = "fn f() -> u8 { g(a + b, c) }\nfn h() -> u8 { 3 }\n";
        let at = text.find('+').unwrap();
        let places = places(text, &(at..at + 1), "-").unwrap();
        let put: Vec<_> = places.iter().map(|place| place.text.as_str()).collect();
        assert_eq!(put, ["a - b", "g(a - b, c)", "{ g(a - b, c) }"]);
    }

    #[test]
    fn areas_are_in_the_order_of_their_names_and_a_star_is_within_a_folder() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join(FOLDER);
        std::fs::create_dir_all(&folder).unwrap();
        for name in ["d.toml", "b.toml", "f.toml", "a.toml", "e.toml", "c.toml", "none.txt"] {
            let list = "files = [\"src/*.rs\", \"src/a/**\"]\nexcept = [\"**/tests.rs\"]\n";
            std::fs::write(folder.join(name), list).unwrap();
        }
        let areas = read(root.path()).unwrap();
        assert!(areas.iter().map(|area| area.name.as_str()).eq(["a", "b", "c", "d", "e", "f"]));
        let files = ["src/a.rs", "src/b/a.rs", "src/a/b/c.rs", "src/tests.rs", "src/a/tests.rs", "other/a.rs"];
        assert_eq!(files.map(|file| areas[0].has(file)), [true, false, true, false, false, false]);
    }
}
