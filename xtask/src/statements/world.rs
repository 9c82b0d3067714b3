//! The targets of references: chapters and their anchors, golden cases, tests and other code, outputs of scenes.

use anyhow::Context;
use jointproof::scene::Kind;
use jointproof::toolkit::verify::golden;
use kit::Project;
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The parts of the repository that a statement can refer to.
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
    /// Reads the current state on disk.
    pub(super) fn read(project: &Project) -> anyhow::Result<Self> {
        let mut world = Self { chapters: BTreeMap::new(), code: BTreeMap::new(), golden: project.golden() };
        read(project, &project.root().join("book/src"), "md", &mut world.chapters)?;
        for folder in ["src", "tests"] {
            read(project, &project.root().join(folder), "rs", &mut world.code)?;
        }
        Ok(world)
    }

    /// A repository with these chapters and this code, without golden files.
    #[cfg(test)]
    pub(super) fn of(chapters: &[(&str, &str)], code: &[(&str, &str)]) -> Self {
        let named =
            |files: &[(&str, &str)]| files.iter().map(|(name, text)| ((*name).into(), (*text).into())).collect();
        Self { chapters: named(chapters), code: named(code), golden: PathBuf::new() }
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

    /// The location of a test, given as `ujoint::a_name` of `tests/ujoint.rs`.
    pub(super) fn test(&self, test: &str) -> Option<Place> {
        let (file, name) = test.split_once("::")?;
        let file = format!("tests/{file}.rs");
        let lines: Vec<_> = self.code.get(&file)?.lines().collect();
        let line = lines.iter().position(|line| defines(line, "fn", name))?;
        let attributes = lines[..line].iter().rev().take_while(|line| line.trim_start().starts_with(['#', '/']));
        let is_test = attributes.into_iter().any(|line| line.trim() == "#[test]");
        is_test.then_some(Place { file, line: line + 1 })
    }

    /// The location of a function or type of the library, given by its Rust path.
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

/// The kind with this output, given as `slot/U1`, or as `slider@2d/G` in one dimension; the first if there are several.
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

/// The line of a method of a type or, if a macro makes it for several types, of the function with that name.
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

/// The anchors of a chapter: its headings as named by mdBook, and its entries.
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

/// The anchor made of the words of a heading.
fn normal(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || "_- ".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

/// Reads all files with this ending in a folder and below it.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn place(found: Option<Place>) -> Option<(String, usize)> {
        found.map(|place| (place.file, place.line))
    }

    #[test]
    fn tests_are_functions_with_the_attribute_right_above_them() {
        let code = "#[test]\nfn one() {}\n\nfn helper() {}\n\n#[test]\n/// About it.\n  #[ignore]\nfn two() {\n}\nfn three() {}\n";
        let world = World::of(&[], &[("tests/a.rs", code), ("src/a.rs", "#[test]\nfn four() {}\n")]);
        let line = |test: &str| place(world.test(test));
        assert_eq!(line("a::one"), Some(("tests/a.rs".into(), 2)));
        assert_eq!(line("a::two"), Some(("tests/a.rs".into(), 9)));
        for none in ["a::helper", "a::three", "a::four", "b::one", "one"] {
            assert_eq!(line(none), None, "{none}");
        }
    }

    #[test]
    fn functions_and_types_are_found_by_their_paths() {
        let code = "use b::Two;\nstruct One<T>(T);\npub enum Two { A }\nfn free() {}\n// Two has make too.\nimpl One<f64> {\n  fn make(&self) {}\n}\nimpl Two {\n  pub fn make() {}\n}\nmacro! {\n  fn made() {}\n}\n";
        let world = World::of(&[], &[("src/a/b.rs", code), ("src/c.rs", "pub(crate) fn top() {}\n")]);
        let line = |path: &str| place(world.item(path)).map(|(file, line)| format!("{file}:{line}"));
        for (path, found) in [
            ("x::a::b::One<f64>", Some("src/a/b.rs:2")),
            ("x::a::b::Two", Some("src/a/b.rs:3")),
            ("x::a::b::free", Some("src/a/b.rs:4")),
            ("x::a::b::One<x::a::b::Two>::make", Some("src/a/b.rs:7")),
            ("x::a::b::Two::make", Some("src/a/b.rs:10")),
            ("x::a::b::Two::made", Some("src/a/b.rs:13")),
            ("x::c::top", Some("src/c.rs:1")),
            ("x::a::b::A", None),
            ("x::a::b::Two::none", None),
            ("x::a::b::none", None),
            ("x::c::free", None),
        ] {
            assert_eq!(line(path).as_deref(), found, "{path}");
        }
    }

    #[test]
    fn a_path_is_plain_without_its_parameters() {
        assert_eq!(plain("a::B<c::D<E>, F>::g"), "a::B::g");
        assert_eq!(plain("a>b<c"), "ab");
    }

    #[test]
    fn a_line_defines_what_follows_the_word() {
        assert!(defines("pub fn  name<T>(", "fn", "name") && defines("struct Name;", "struct", "Name"));
        for line in ["fn names() {}", "let fn_name = 1;", "// of fn: other name", "name fn", "enum name {", ""] {
            assert!(!defines(line, "fn", "name"), "{line}");
        }
    }

    #[test]
    fn places_are_chapters_and_their_anchors() {
        let world = World::of(&[("book/src/a.md", "# One two\n")], &[]);
        assert!(world.has_place("a.md") && world.has_place("a.md#one-two"));
        assert!(!world.has_place("b.md") && !world.has_place("a.md#one") && !world.has_place("b.md#one-two"));
    }

    #[test]
    fn outputs_are_those_of_a_kind_or_of_one_dimension_of_it() {
        let found = |name: &str| output(name).map(|kind| format!("{} {}", kind.name, kind.dimension.name()));
        assert_eq!(found("slot/U1"), found("slot@3d/U1"));
        assert_eq!(found("slot@2d/U1").as_deref(), Some("slot 2d"));
        for none in ["slot/U9", "slot", "nothing/U1", "slot@4d/U1"] {
            assert_eq!(found(none), None, "{none}");
        }
    }
}
