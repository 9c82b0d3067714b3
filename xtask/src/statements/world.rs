//! What there is to refer to: chapters and their anchors, golden cases, tests and other code, outputs of scenes.

use anyhow::Context;
use jointproof::scene::Kind;
use jointproof::verify::golden;
use kit::Project;
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The repository, as far as a statement can refer to it.
pub(super) struct World {
    /// The chapters by file name.
    chapters: BTreeMap<String, String>,
    /// The Rust files below `src` and `tests`, by path.
    code: BTreeMap<String, String>,
    /// The folder of the golden files.
    golden: PathBuf,
}

/// A line of a Rust file.
pub(super) struct Place {
    /// Path from the root of the repository.
    pub(super) file: String,
    /// Line, from 1.
    pub(super) line: usize,
}

impl World {
    /// What is on disk now.
    pub(super) fn read(project: &Project) -> anyhow::Result<Self> {
        let mut world = Self { chapters: BTreeMap::new(), code: BTreeMap::new(), golden: project.golden() };
        read(project, &project.root().join("book/src"), "md", &mut world.chapters)?;
        for folder in ["src", "tests"] {
            read(project, &project.root().join(folder), "rs", &mut world.code)?;
        }
        Ok(world)
    }

    /// The text of a chapter.
    pub(super) fn chapter(&self, file: &str) -> Option<&str> {
        self.chapters.get(&format!("book/src/{file}")).map(String::as_str)
    }

    /// Whether a chapter has an anchor, as `slot.md#forces`.
    pub(super) fn has_place(&self, place: &str) -> bool {
        let (file, anchor) = place.split_once('#').unwrap_or((place, ""));
        self.chapter(file).is_some_and(|text| anchor.is_empty() || anchors(text).contains(anchor))
    }

    /// Whether the golden file of a formula has a case.
    pub(super) fn has_case(&self, formula: &str, case: &str) -> bool {
        let text = std::fs::read_to_string(self.golden.join(format!("{formula}.json"))).ok();
        let file = text.and_then(|text| golden::File::parse(&text).ok());
        file.is_some_and(|file| file.cases.iter().any(|record| record.id == case))
    }

    /// Where a test is, given as `ujoint::a_name` of `tests/ujoint.rs`.
    pub(super) fn test(&self, test: &str) -> Option<Place> {
        let (file, name) = test.split_once("::")?;
        let file = format!("tests/{file}.rs");
        let lines: Vec<_> = self.code.get(&file)?.lines().collect();
        let line = lines.iter().position(|line| defines(line, "fn", name))?;
        let attributes = lines[..line].iter().rev().take_while(|line| line.trim_start().starts_with(['#', '/']));
        let is_test = attributes.into_iter().any(|line| line.trim() == "#[test]");
        is_test.then_some(Place { file, line: line + 1 })
    }

    /// Where a function or type of the library is, given by its Rust path.
    pub(super) fn item(&self, path: &str) -> Option<Place> {
        let plain = plain(path);
        let parts: Vec<_> = plain.split("::").skip(1).collect();
        let is_type = |part: &&str| part.starts_with(char::is_uppercase);
        let owner = parts.iter().position(is_type);
        let (modules, rest) = parts.split_at(owner.unwrap_or(parts.len() - 1));
        let file = format!("src/{}.rs", modules.join("/"));
        let lines: Vec<_> = self.code.get(&file)?.lines().collect();
        let line = match (owner, rest) {
            (Some(_), [owner]) => {
                lines.iter().position(|line| ["struct", "enum"].iter().any(|key| defines(line, key, owner)))
            }
            (Some(_), [owner, name]) => method(&lines, owner, name),
            (_, [name]) => lines.iter().position(|line| defines(line, "fn", name)),
            _ => None,
        }?;
        Some(Place { file, line: line + 1 })
    }
}

/// Whether scenes have an output, given as `slot/U1`, or as `slider@2d/G` in one dimension: its first kind.
pub(super) fn output(name: &str) -> Option<&'static Kind> {
    let (kind, output) = name.split_once('/')?;
    let (kind, dimension) = kind.split_once('@').map_or((kind, None), |(kind, dimension)| (kind, Some(dimension)));
    let fits = |candidate: &&'static Kind| {
        candidate.name == kind && dimension.is_none_or(|dimension| candidate.dimension.name() == dimension)
    };
    Kind::all().filter(fits).find(|kind| kind.output(output).is_some())
}

/// A path without type parameters.
pub(super) fn plain(path: &str) -> String {
    let mut depth = 0_usize;
    let outside = |c: &char| {
        match c {
            '<' => depth += 1,
            '>' => depth = depth.saturating_sub(1),
            _ => return depth == 0,
        }
        false
    };
    path.chars().filter(outside).collect()
}

/// A function of a type, or, made by a macro for several types, the function of that name.
fn method(lines: &[&str], owner: &str, name: &str) -> Option<usize> {
    let is_owners = |line: &&str| line.starts_with("impl") && line.contains(owner);
    let start = lines.iter().position(is_owners)?;
    let is_it = |line: &&str| defines(line, "fn", name);
    let own = lines[start..].iter().position(is_it).map(|line| start + line);
    own.or_else(|| lines.iter().position(is_it))
}

/// Whether a line defines `fn name`, `struct name` and so on.
fn defines(line: &str, key: &str, name: &str) -> bool {
    let mut words = line.split([' ', '(', '<', ':', ';', '{']).filter(|word| !word.is_empty());
    words.any(|word| word == key) && words.next() == Some(name)
}

/// The anchors of a chapter: its headings as mdBook names them, and its entries.
pub(super) fn anchors(text: &str) -> BTreeSet<String> {
    let options = Options::ENABLE_MATH | Options::ENABLE_HEADING_ATTRIBUTES;
    let (mut found, mut heading): (BTreeSet<String>, Option<String>) = Default::default();
    for event in Parser::new_ext(text, options) {
        match event {
            Event::Start(Tag::Heading { id: Some(id), .. }) => {
                found.insert(id.into_string());
            }
            Event::Start(Tag::Heading { level: HeadingLevel::H1 | HeadingLevel::H2 | HeadingLevel::H3, .. }) => {
                heading = Some(String::new());
            }
            Event::Text(words) | Event::Code(words) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&words);
                }
            }
            Event::End(TagEnd::Heading(_)) => found.extend(heading.take().map(|heading| normal(&heading))),
            _ => {}
        }
    }
    let entries = text.lines().filter_map(|line| line.strip_prefix("{{#formula ")?.strip_suffix("}}"));
    found.extend(entries.map(str::to_owned));
    found
}

/// The words of a heading as an anchor.
fn normal(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || "_- ".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

/// Reads the files of a folder and below that have an ending.
fn read(project: &Project, folder: &Path, ending: &str, into: &mut BTreeMap<String, String>) -> anyhow::Result<()> {
    for entry in std::fs::read_dir(folder).with_context(|| format!("cannot list {}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            read(project, &path, ending, into)?;
        } else if path.extension().is_some_and(|extension| extension == ending) {
            let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
            into.insert(project.shown(&path).replace('\\', "/"), text);
        }
    }
    Ok(())
}
