//! Texts with holes.

/// A template with each `{name}` replaced by its text, one after the other; where it is alone in a line, all lines of the text
/// are indented like it.
pub(crate) fn filled(template: &str, places: &[(&str, &str)]) -> String {
    let one = |template: String, (name, what): &(&str, &str)| {
        let hole = format!("{{{name}}}");
        let line = |line: &str| match line.split_once(&hole) {
            Some((indent, "\n")) if indent.trim().is_empty() => {
                what.lines().flat_map(|line| [if line.is_empty() { "" } else { indent }, line, "\n"]).collect()
            }
            _ => line.replace(&hole, what),
        };
        template.split_inclusive('\n').map(line).collect()
    };
    places.iter().fold(template.to_owned(), one)
}
