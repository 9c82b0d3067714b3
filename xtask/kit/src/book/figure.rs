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
    use crate::book::content::Content;
    use crate::book::deferred::Deferred;

    #[test]
    fn only_safe_drawings_are_inlined() {
        assert_eq!(unfit("<svg><title>t</title></svg>"), None);
        let acts = Some("has a script or style sheet, which would act on the whole page");
        assert_eq!(unfit("<svg><title>t</title><script/></svg>"), acts);
        assert_eq!(unfit("<svg><title>t</title><style/></svg>"), acts);
        for part in ["<svg><title>t</title>", "<title>t</title></svg>", "words"] {
            assert_eq!(unfit(part), Some("is not an SVG drawing"), "{part}");
        }
        assert!(unfit("<svg></svg>").is_some_and(|reason| reason.contains("title")));
    }

    #[test]
    fn a_drawing_that_is_not_fit_is_a_fault() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("bad.svg"), "<svg></svg>").unwrap();
        let (content, later) = (Content::default(), Deferred::default());
        let pages = Pages::new(&content, &later);
        let at = Place { file: "a.md".into(), line: 3, page: "a.html".into() };
        assert_eq!(figure(&pages, &at, folder.path(), "bad It."), "");
        assert_eq!(figure(&pages, &at, folder.path(), "worse"), "");
        let faults: Vec<_> = pages.faults.borrow().0.iter().map(ToString::to_string).collect();
        let untitled = "a.md:3: figure `bad` has no <title>, which readers who cannot see it need";
        assert_eq!(faults, [untitled, "a.md:3: no figure `worse`; there are: bad"]);
    }

    #[test]
    fn names_stay_in_the_folder() {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("figures");
        std::fs::create_dir(&folder).unwrap();
        for name in ["b-2_x.y", "a", "", "../outside", "c d"] {
            std::fs::write(folder.join(format!("{name}.svg")), name).unwrap();
        }
        std::fs::write(folder.join("notes.txt"), "").unwrap();
        assert_eq!(["a", "b-2_x.y"].map(|name| read(&folder, name).as_deref() == Some(name)), [true; 2]);
        assert_eq!(["", "../outside", "c d", "none"].map(|name| read(&folder, name)), [const { None }; 4]);
        assert_eq!(names(&folder), ["", "a", "b-2_x.y", "c d"]);
        assert_eq!(svg_element("<?xml version=\"1.0\"?>\n<svg></svg>\n"), "<svg></svg>");
    }
}
