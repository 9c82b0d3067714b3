//! `{{#figure name caption}}`: a drawing from `book/figures` or made by the build, put into the page itself so that it takes
//! the theme's colours.

use std::path::Path;

use super::html::escape;
use super::moving;
use super::pages::{Pages, Place};
use crate::extension::Moving;

/// The figure with its caption; a fault if there is no such file, or it is not fit to be inlined.
pub(crate) fn figure(pages: &Pages<'_>, at: &Place, folder: &Path, argument: &str) -> String {
    let (name, caption) = argument.split_once(char::is_whitespace).unwrap_or((argument, ""));
    let exhibits = &pages.content.exhibits;
    let moving = exhibits.moving.iter().find(|moving| moving.name == name);
    let made = exhibits.figures.iter().find(|(known, _)| known == name).map(|(_, svg)| svg);
    let made = moving.and_then(Moving::still).or(made).cloned();
    let Some(svg) = made.or_else(|| read(folder, name)) else {
        let made = exhibits.figures.iter().map(|(name, _)| name.clone());
        let made = made.chain(exhibits.moving.iter().map(|moving| moving.name.clone()));
        let known: Vec<_> = made.chain(names(folder)).collect();
        pages.fault(at, format!("no figure `{name}`; there are: {}", known.join(", ")));
        return String::new();
    };
    if let Some(reason) = unfit(&svg) {
        pages.fault(at, format!("figure `{name}` {reason}"));
        return String::new();
    }
    let drawing = pages.later.keep(&format!("<div class=\"drawing\" tabindex=\"0\">{}</div>", svg_element(&svg)), "");
    let caption = match caption.trim() {
        "" => String::new(),
        caption => format!("<figcaption>{}</figcaption>", pages.text(at, caption)),
    };
    let sliders = moving.map(|moving| pages.later.keep(&moving::sliders(moving), "")).unwrap_or_default();
    format!("<figure id=\"figure-{}\">{drawing}{sliders}{caption}</figure>", escape(name))
}

/// The file, unless the name would leave the folder.
fn read(folder: &Path, name: &str) -> Option<String> {
    let plain = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c));
    if plain { std::fs::read_to_string(folder.join(format!("{name}.svg"))).ok() } else { None }
}

/// All drawings there are.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let stem = |path: std::path::PathBuf| Some(path.file_name()?.to_str()?.strip_suffix(".svg")?.to_owned());
    let mut names: Vec<String> = entries.filter_map(|entry| stem(entry.path())).collect();
    names.sort();
    names
}

/// Why a drawing cannot be inlined.
fn unfit(svg: &str) -> Option<&'static str> {
    if !svg.contains("<svg") || !svg.contains("</svg>") {
        return Some("is not an SVG drawing");
    }
    if svg.contains("<script") || svg.contains("<style") {
        return Some("has a script or style sheet, which would act on the whole page");
    }
    (!svg.contains("<title")).then_some("has no <title>, which readers who cannot see it need")
}

/// The drawing without XML declaration and comments before it.
fn svg_element(svg: &str) -> &str {
    svg.find("<svg").map_or(svg, |start| svg[start..].trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_safe_drawings_are_inlined() {
        assert_eq!(unfit("<svg><title>t</title></svg>"), None);
        assert!(unfit("<svg><title>t</title><script/></svg>").is_some());
        assert!(unfit("<svg></svg>").is_some_and(|reason| reason.contains("title")));
    }

    #[test]
    fn names_stay_in_the_folder() {
        assert_eq!(read(Path::new("/"), "../etc/passwd"), None);
        assert_eq!(svg_element("<?xml version=\"1.0\"?>\n<svg></svg>\n"), "<svg></svg>");
    }
}
