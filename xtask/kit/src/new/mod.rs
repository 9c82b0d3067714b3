//! `new`: the skeleton of a formula, placed next to its neighbours.

mod edit;

use crate::book::coverage::{Directive, directives};
use crate::book::permalinks;
use crate::console::{bold, print};
use crate::files;
use crate::missing::{is_name, requirements};
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use anyhow::{Context, bail};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Write the skeleton of a formula into its module, the catalog and the book
///
/// The skeleton compiles, but fails its checks: it has no symbols, no equation and no cases. This command, `golden`, `audit`
/// and `verify` list what is still missing.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} new {family}.power  a new formula in the module src/{family}.rs")]
pub(crate) struct Arguments {
    /// The identifier, as `family.name`; the family is an existing module
    #[arg(value_name = "ID")]
    id: String,
}

/// A file and its new text.
type Change = (PathBuf, String);

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_project("new")?;
    let id = arguments.id.as_str();
    let (family, name) = split(project, id)?;
    let mut report = String::new();
    // All changes are determined before any of them is written.
    for (path, text) in changes(project, family, name)? {
        let is_new = !path.exists();
        files::write(&path, &text)?;
        writeln!(report, "{} {}", if is_new { "wrote  " } else { "changed" }, project.shown(&path))?;
    }
    writeln!(report, "\n{} still lacks", bold(id))?;
    for requirement in requirements(project).iter().filter(|requirement| requirement.is_of_author) {
        writeln!(report, "    {}: {}", requirement.what, requirement.how(project, id))?;
    }
    writeln!(report, "    the points where it has no derivative: `Proved::kinks`")?;
    writeln!(
        report,
        "    if an element or a program will call it: `jacobian`, by hand, and its bound, `.eta` in place of `.eta_of_value`"
    )?;
    writeln!(report, "\ncargo fmt, then {} audit --filter {id} says what is left", project.command())?;
    print(&report)?;
    Ok(verdict(true))
}

/// Family and name of an identifier that can be added.
fn split<'a>(project: &Project, id: &'a str) -> anyhow::Result<(&'a str, &'a str)> {
    let usage = |message: String| Err(Usage(message).into());
    match id.split_once('.') {
        _ if project.find(id).is_some() => usage(format!("there is a formula {id} already")),
        Some((family, name)) if is_name(family) && is_name(name) => Ok((family, name)),
        _ => usage(format!("'{id}' is no identifier; it is written family.name, of small letters, digits and _")),
    }
}

/// Every file that is written or changed.
fn changes(project: &Project, family: &str, name: &str) -> anyhow::Result<Vec<Change>> {
    let source = project.root().join("src");
    let module = module(&source, family)?.with_context(|| {
        let shown = project.shown(&source);
        format!("there is no module {family}.rs in {shown}; write it, with what all its formulas share, name it in the crate, and try again")
    })?;
    let folder = module.with_extension("");
    let (formula, proof) = (folder.join(format!("{name}.rs")), folder.join(format!("{name}/proof.rs")));
    if let Some(present) = [&formula, &proof].into_iter().find(|path| path.exists()) {
        bail!("{} is there already; take another name, or move it away", project.shown(present));
    }
    let neighbours = read_all(&module)? + &read_all(&folder)?;
    let skeleton = |template: &str| edit::filled(template, family, name, &neighbours);
    let catalog = catalog(&source)?;
    let chapter = chapter(project, family)?;
    let changed = |path: &Path, text: Option<String>, what: &str| -> anyhow::Result<Change> {
        let shown = project.shown(path);
        Ok((path.to_path_buf(), text.with_context(|| format!("{shown} has no place for {what}; add it by hand"))?))
    };
    let type_name = edit::type_name(name);
    let mut changes = vec![
        (formula, skeleton(include_str!("formula.txt"))),
        (proof, skeleton(include_str!("proof.txt"))),
        changed(&module, edit::with_module(&read(&module)?, name), &format!("`mod {name};`"))?,
        changed(
            &catalog,
            edit::with_entry(&read(&catalog)?, family, &type_name),
            &format!("`&{family}::{type_name}`"),
        )?,
    ];
    if let Some(Directive { file, line, .. }) = chapter {
        let path = project.root().join(&file);
        let text = edit::with_directive(&read(&path)?, line, &format!("{family}.{name}"));
        changes.push((path, text));
    }
    // If the book has a list of permanent addresses, one is added.
    let list = project.root().join(permalinks::LIST);
    if list.exists() {
        let text = permalinks::with(&read(&list)?, [format!("{family}.{name}")]);
        changes.push((list, text));
    }
    Ok(changes)
}

/// The file of the family's module: in `src`, or in a folder of `src`.
fn module(source: &Path, family: &str) -> anyhow::Result<Option<PathBuf>> {
    let name = format!("{family}.rs");
    let mut folders = Vec::new();
    for entry in std::fs::read_dir(source)? {
        folders.push(entry?.path());
    }
    folders.sort();
    let mut modules = [source.to_path_buf()].into_iter().chain(folders).map(|folder| folder.join(&name));
    Ok(modules.find(|module| module.exists()))
}

/// The file that contains the catalog.
fn catalog(source: &Path) -> anyhow::Result<PathBuf> {
    let candidates = ["catalog/list.rs", "catalog.rs", "lib.rs", "main.rs"].map(|name| source.join(name));
    let has_catalog = |path: &&PathBuf| read(path).is_ok_and(|text| text.contains("static CATALOG"));
    candidates
        .iter()
        .find(has_catalog)
        .cloned()
        .context("no `static CATALOG` in src/catalog/list.rs, catalog.rs, lib.rs or main.rs")
}

/// The last entry in the chapter that contains most of the family, after which the new one belongs.
fn chapter(project: &Project, family: &str) -> anyhow::Result<Option<Directive>> {
    if !project.has_book() {
        return Ok(None);
    }
    let mut directives = directives(project.root())?;
    directives.retain(|directive| directive.id.split('.').next() == Some(family));
    let entries = |file: &str| directives.iter().filter(|directive| directive.file == file).count();
    let last = directives.iter().max_by_key(|directive| (entries(&directive.file), directive.line)).cloned();
    Ok(Some(last.with_context(|| format!("no chapter has an entry of `{family}`; write one, and try again"))?))
}

fn read(path: &Path) -> anyhow::Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

/// The text of a file, or of all files below a folder.
fn read_all(path: &Path) -> anyhow::Result<String> {
    if !path.is_dir() {
        return if path.exists() { read(path) } else { Ok(String::new()) };
    }
    let mut text = String::new();
    for entry in std::fs::read_dir(path)? {
        text += &read_all(&entry?.path())?;
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_belongs_behind_the_last_one_in_the_chapter_that_has_most_of_the_family() {
        let root = tempfile::tempdir().unwrap();
        let project = || Project::new("new", env!("CARGO_MANIFEST_DIR"), &[]).in_folder(root.path().to_str().unwrap());
        assert!(chapter(&project(), "a").unwrap().is_none(), "there is no book");
        let entry = |id: &str| format!("{{{{#formula {id}}}}}\n\n");
        for (file, ids) in [
            ("one.md", &["b.x", "b.y", "b.z", "a.x"][..]),
            ("two.md", &["a.y", "b.u", "a.z", "b.v", "b.w", "b.s"]),
            ("three.md", &["b.r", "b.q", "b.p", "b.o", "a.w"]),
        ] {
            let text: String = ids.iter().map(|id| entry(id)).collect();
            files::write(&root.path().join("book/src").join(file), &text).unwrap();
        }
        let of = |family: &str| chapter(&project(), family).map(|found| found.map(|at| (at.file, at.id, at.line)));
        assert_eq!(of("a").unwrap(), Some(("book/src/two.md".into(), "a.z".into(), 5)));
        assert_eq!(of("b").unwrap().map(|(file, ..)| file), Some("book/src/two.md".into()));
        assert_eq!(of("c").unwrap_err().to_string(), "no chapter has an entry of `c`; write one, and try again");
    }

    #[test]
    fn neighbours_are_the_texts_of_a_file_or_of_all_below_a_folder() {
        let root = tempfile::tempdir().unwrap();
        for file in ["a.rs", "a/b.rs", "a/c/d.rs"] {
            files::write(&root.path().join(file), file).unwrap();
        }
        let read = |path: &str| read_all(&root.path().join(path)).unwrap();
        assert_eq!((read("a.rs"), read("b")), ("a.rs".to_owned(), String::new()));
        let below = read("a");
        assert!(below == "a/b.rsa/c/d.rs" || below == "a/c/d.rsa/b.rs", "{below}");
    }
}
