//! Elements: their golden files, and their audits.

use crate::console::{bold, count, progress};
use crate::files;
use crate::project::Project;
use indicatif::ParallelProgressIterator;
use jointproof::catalog::AnyElement;
use jointproof::toolkit::verify::{Claim, ElementAudit, ElementFile, Options};
use judge::audited;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A golden file of an element as the code says it is.
pub(crate) struct Golden {
    path: PathBuf,
    text: String,
    cases: usize,
}

/// The golden files of elements in a folder, and their schema.
pub(crate) struct GoldenFiles {
    pub(crate) files: Vec<Golden>,
    schema: Option<(PathBuf, String)>,
}

/// The folder of the golden files of elements below that of formulas.
fn below(folder: &Path) -> PathBuf {
    folder.join("elements")
}

impl GoldenFiles {
    pub(crate) fn made(elements: &[&dyn AnyElement], folder: &Path) -> anyhow::Result<Self> {
        let (folder, bar) = (below(folder), progress("elements", elements.len()));
        let made = |element: &&dyn AnyElement| {
            let file = element.golden();
            let path = folder.join(format!("{}.json", file.element));
            Ok(Golden { path, text: file.render()?, cases: file.cases.len() })
        };
        let files: anyhow::Result<Vec<_>> = elements.par_iter().progress_with(bar).map(made).collect();
        let schema = serde_json::to_string_pretty(&schemars::schema_for!(ElementFile))? + "\n";
        let schema = (!elements.is_empty()).then(|| (folder.join("schema.json"), schema));
        Ok(Self { files: files?, schema })
    }

    /// Every file with its text.
    fn texts(&self) -> impl Iterator<Item = (&PathBuf, &String)> {
        let schema = self.schema.iter().map(|(path, text)| (path, text));
        self.files.iter().map(|golden| (&golden.path, &golden.text)).chain(schema)
    }

    /// Writes what has changed, and says what.
    pub(crate) fn write(&self) -> anyhow::Result<Vec<&PathBuf>> {
        let mut written = Vec::new();
        for (path, text) in self.texts() {
            if files::write(path, text)? {
                written.push(path);
            }
        }
        Ok(written)
    }

    /// What is off with the committed files.
    pub(crate) fn off(&self, project: &Project) -> Vec<String> {
        self.texts().filter_map(|(path, text)| difference(project, path, text)).collect()
    }

    /// Files of elements that no longer exist.
    pub(crate) fn orphans(project: &Project) -> anyhow::Result<Vec<PathBuf>> {
        let known = |id: &str| id == "schema" || project.elements().iter().any(|element| element.spec().id == id);
        files::json_but(&below(&project.golden()), known)
    }

    /// How much there is; nothing where there are no elements.
    pub(crate) fn counts(&self) -> String {
        if self.files.is_empty() {
            return String::new();
        }
        let cases = self.files.iter().map(|golden| golden.cases).sum();
        format!("; {}, {}", count(self.files.len(), "element"), count(cases, "case"))
    }
}

/// Where a committed file first differs from what the code says.
fn difference(project: &Project, path: &Path, text: &str) -> Option<String> {
    let name = bold(project.shown(path));
    let committed = match std::fs::read_to_string(path) {
        Ok(committed) if committed == text => return None,
        Ok(committed) => committed,
        Err(error) => return Some(format!("{name}: {error}\n")),
    };
    let parse = |text: &str| serde_json::from_str::<Value>(text);
    let (committed, now) = match (parse(&committed), parse(text)) {
        (Ok(committed), Ok(now)) => (committed, now),
        (Err(error), _) | (_, Err(error)) => return Some(format!("{name} is no JSON: {error}\n")),
    };
    let place = first_difference("", &committed, &now);
    Some(match place {
        Some((place, committed, now)) => format!("{name}{place}\n    - {committed}\n    + {now}\n"),
        None => format!("{name}: its numbers agree, its text differs\n"),
    })
}

/// The first place where two values differ, as a JSON pointer, and what stands there.
fn first_difference<'a>(place: &str, old: &'a Value, new: &'a Value) -> Option<(String, &'a Value, &'a Value)> {
    let deeper = |key: &str, old: &'a Value, new: &'a Value| first_difference(&format!("{place}/{key}"), old, new);
    match (old, new) {
        (Value::Object(one), Value::Object(other)) if one.len() == other.len() => {
            one.iter().find_map(|(key, old)| deeper(key, old, other.get(key).unwrap_or(&Value::Null)))
        }
        (Value::Array(one), Value::Array(other)) if one.len() == other.len() => {
            one.iter().zip(other).enumerate().find_map(|(k, (old, new))| deeper(&k.to_string(), old, new))
        }
        _ => (old != new).then(|| (place.to_owned(), old, new)),
    }
}

/// An element has hundreds of results, each of which is looked at: it is audited at this part of the random points of a formula.
const FEWER: usize = 10;

/// Audits elements on all cores.
pub(crate) fn audit(elements: &[&dyn AnyElement], options: &Options) -> Vec<ElementAudit> {
    let options = Options { samples: options.samples.div_ceil(FEWER), ..*options };
    let bar = progress("elements", elements.len());
    elements.par_iter().progress_with(bar).map(|element| element.audit(&options)).collect()
}

/// What was found, in words; nothing where there are no elements.
pub(crate) fn text(audits: &[ElementAudit]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    for audit in audits {
        let points = audit.named_points + audit.random_points;
        text += &audited::claims(&audit.element, audit.passed(), points, &audit.provenance, &audit.claims)?;
    }
    Ok(if audits.is_empty() { text } else { text + &total(audits) + "\n" })
}

/// The same for a code review, a line an element, and in full what failed.
pub(crate) fn markdown(audits: &[ElementAudit]) -> String {
    if audits.is_empty() {
        return String::new();
    }
    let line = |audit: &ElementAudit| {
        let failed: Vec<_> =
            audit.claims.iter().filter(|claim| !claim.held()).map(|claim| claim.claim.as_str()).collect();
        let verdict = if failed.is_empty() { "ok".into() } else { format!("off: {}", failed.join("; ")) };
        format!("| `{}` | {} | {verdict} |\n", audit.element, audit.named_points + audit.random_points)
    };
    let lines: String = audits.iter().map(line).collect();
    format!("\n| element | points | found |\n|---|---:|---|\n{lines}\n{}\n", total(audits))
}

/// How much was audited.
pub(crate) fn total(audits: &[ElementAudit]) -> String {
    let claims = || audits.iter().flat_map(|audit| &audit.claims);
    let failed = audits.iter().filter(|audit| !audit.passed()).count();
    let [audited, checks, off] = [
        (audits.len(), "element"),
        (claims().map(|claim: &Claim| claim.checks).sum(), "comparison"),
        (failed, "element"),
    ]
    .map(|(number, noun)| count(number, noun));
    format!("{audited}, {checks}, {off} off")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_first_difference_is_found_where_it_is() {
        let old = json!({"a": [1, {"b": 2}], "c": 3});
        let place = |new| first_difference("", &old, &new).map(|(place, old, new)| (place, old.clone(), new.clone()));
        assert_eq!(place(old.clone()), None);
        assert_eq!(place(json!({"a": [1, {"b": 5}], "c": 3})), Some(("/a/1/b".into(), json!(2), json!(5))));
        assert_eq!(place(json!({"a": [1], "c": 3})), Some(("/a".into(), old["a"].clone(), json!([1]))));
        assert_eq!(place(json!({"a": [1, {"b": 2}], "d": 3})), Some(("/c".into(), json!(3), Value::Null)));
    }
}
