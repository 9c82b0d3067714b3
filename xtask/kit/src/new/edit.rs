//! The texts of a new formula, and the lines added to other files.

/// A template with its placeholders filled, in the style of the neighbours: whether they are in the crate of the
/// toolkit, whether their evidence is behind a feature, and the document that they are from.
pub(super) fn filled(template: &str, family: &str, name: &str, neighbours: &str) -> String {
    const GATE: &str = "#[cfg(feature = \"verify\")]\n";
    let library = if neighbours.contains("use crate::formula::") { "crate" } else { "jointproof" };
    template
        .replace("{gate}", if neighbours.contains(GATE) { GATE } else { "" })
        .replace("{library}", library)
        .replace("{document}", document(neighbours).unwrap_or("Document::new(\"\")"))
        .replace("{Name}", &type_name(name))
        .replace("{id}", &format!("{family}.{name}"))
}

/// The first document that this source text names, as `Document::SLOT`.
fn document(text: &str) -> Option<&str> {
    const TYPE: &str = "Document::";
    let is_of_name = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    text.match_indices(TYPE).find_map(|(at, _)| {
        let length = text[at + TYPE.len()..].find(|c| !is_of_name(c))?;
        (length > 0).then(|| &text[at..at + TYPE.len() + length])
    })
}

/// `contact_force` as `ContactForce`.
pub(super) fn type_name(name: &str) -> String {
    let capital =
        |word: &str| word.chars().take(1).map(|c| c.to_ascii_uppercase()).chain(word.chars().skip(1)).collect();
    name.split('_').map(capital).collect::<Vec<String>>().concat()
}

/// A family module with one more submodule and its exports.
pub(super) fn with_module(text: &str, name: &str) -> Option<String> {
    let type_name = type_name(name);
    let module = format!("mod {name};\n");
    let export = format!("pub use {name}::{{{type_name}, {type_name}Inputs, {type_name}Outputs}};\n");
    let first = |starts: &[&str]| offset(text, |line| starts.iter().any(|start| line.starts_with(start)));
    match (first(&["mod ", "pub mod "]), first(&["pub use "])) {
        (Some(module_at), Some(export_at)) if module_at < export_at => {
            Some(inserted(&inserted(text, export_at, &export), before_attributes(text, module_at), &module))
        }
        (Some(module_at), None) => {
            let export_at = first(&["use "])?;
            let with_export = inserted(text, export_at, &format!("{export}\n"));
            Some(inserted(&with_export, before_attributes(text, module_at), &module))
        }
        _ => Some(inserted(text, first(&["use "])?, &format!("{module}\n{export}\n"))),
    }
}

/// A catalog with one more formula, after the last one of its family.
pub(super) fn with_entry(catalog: &str, family: &str, type_name: &str) -> Option<String> {
    let start = catalog.find("static CATALOG")?;
    let end = start + catalog[start..].find("];")?;
    let family_entry = format!("&{family}::");
    // A deeper module, as `&slot::plane::Rows`, is another place of the list.
    let is_direct = |at: usize| catalog[start + at + family_entry.len()..].starts_with(char::is_uppercase);
    let (last, _) = catalog[start..end].rmatch_indices(&family_entry).find(|&(at, _)| is_direct(at))?;
    let last = start + last;
    let after = last + catalog[last..end].find([',', ']']).unwrap_or(end - last);
    Some(inserted(catalog, after, &format!(",\n    &{family}::{type_name}")))
}

/// A chapter with an entry after the one on this line, counted from 1.
pub(super) fn with_directive(chapter: &str, line: usize, id: &str) -> String {
    let at: usize = chapter.split_inclusive('\n').take(line).map(str::len).sum();
    let end = if chapter[..at].ends_with('\n') { "" } else { "\n" };
    inserted(chapter, at, &format!("{end}\n{{{{#formula {id}}}}}\n"))
}

/// The offset of the first line that satisfies a condition.
fn offset(text: &str, is_it: impl Fn(&str) -> bool) -> Option<usize> {
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if is_it(line) {
            return Some(at);
        }
        at += line.len();
    }
    None
}

/// The offset of the attributes above the line at `at`.
fn before_attributes(text: &str, at: usize) -> usize {
    let lines = text[..at].split_inclusive('\n').rev();
    at - lines.take_while(|line| line.starts_with("#[") || line.starts_with("///")).map(str::len).sum::<usize>()
}

fn inserted(text: &str, at: usize, what: &str) -> String {
    let (before, after) = text.split_at(at);
    [before, what, after].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rooms_get_a_module_and_its_exports() {
        let text = "//! Room.\n\n#[cfg(feature = \"verify\")]\nmod proof;\n\npub use a::A;\n\nuse b::B;\n";
        let export = "pub use power::{Power, PowerInputs, PowerOutputs};\n";
        let expected = text.replace("#[cfg", "mod power;\n#[cfg").replace("pub use a", &format!("{export}pub use a"));
        assert_eq!(with_module(text, "power").unwrap(), expected);
        let alone = "//! Room.\n\nuse b::B;\n";
        let expected = alone.replace("use b", &format!("mod power;\n\n{export}\nuse b"));
        assert_eq!(with_module(alone, "power").unwrap(), expected);
        assert_eq!(with_module("//! Nothing.\n", "power"), None);
    }

    #[test]
    fn catalogs_get_an_entry_behind_the_family() {
        let catalog = "static CATALOG: C = &[\n    &slot::A,\n    &slot::B,\n    &join::C,\n];\n";
        let expected = catalog.replace("&slot::B,", "&slot::B,\n    &slot::Power,");
        assert_eq!(with_entry(catalog, "slot", "Power").unwrap(), expected);
        let short = "static CATALOG: C = &[&slot::A];\n";
        assert_eq!(
            with_entry(short, "slot", "Power").unwrap(),
            "static CATALOG: C = &[&slot::A,\n    &slot::Power];\n"
        );
        assert_eq!(with_entry(short, "join", "Power"), None);
    }

    #[test]
    fn chapters_get_an_entry_behind_a_line() {
        assert_eq!(
            with_directive("# A\n{{#formula a.b}}\nEnd.\n", 2, "a.c"),
            "# A\n{{#formula a.b}}\n\n{{#formula a.c}}\nEnd.\n"
        );
        assert_eq!(with_directive("{{#formula a.b}}", 1, "a.c"), "{{#formula a.b}}\n\n{{#formula a.c}}\n");
    }

    #[test]
    fn the_document_is_that_of_the_neighbours() {
        assert_eq!(document("Document::new(\"\"), Document::SLOT.printed(\"\")"), Some("Document::SLOT"));
        assert_eq!(document("use formula::Document;"), None);
    }

    #[test]
    fn names_of_types_are_in_camel_case() {
        assert_eq!(["power", "contact_force_2d"].map(type_name), ["Power", "ContactForce2d"]);
    }
}
