//! The shared state of all renderers: the content, the converter, the location of each entry, and the list of faults.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::content::{Content, Entry};
use super::deferred::Deferred;
use super::fault::Faults;
use super::html::{escape, relative, text_of};
use super::math::{Math, MathError};

/// A location in the book: a chapter, a line in it, and the resulting page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Place {
    /// The Markdown file, for fault messages.
    pub(crate) file: String,
    /// The line, from 1.
    pub(crate) line: usize,
    /// The page, from the root of the book.
    pub(crate) page: String,
}

/// The state shared by everything that renders.
pub(crate) struct Pages<'a> {
    /// The formulas and files.
    pub(crate) content: &'a Content,
    /// The LaTeX converter.
    pub(crate) math: Math,
    /// HTML to be inserted after rendering.
    pub(crate) later: &'a Deferred,
    /// The location of each formula's entry.
    pub(crate) places: BTreeMap<String, Place>,
    /// The page with the evidence of all formulas.
    pub(crate) evidence: Option<String>,
    /// The page with the bounds of all formulas.
    pub(crate) accuracy: Option<String>,
    /// The number of each chapter that has one, by its page: `2.1`.
    pub(crate) chapters: BTreeMap<String, String>,
    /// How many displayed equations each page has so far.
    equations: RefCell<BTreeMap<String, usize>>,
    /// The faults so far.
    pub(crate) faults: RefCell<Faults>,
}

impl<'a> Pages<'a> {
    /// Without entry locations and faults.
    pub(crate) fn new(content: &'a Content, later: &'a Deferred) -> Self {
        let (places, chapters) = (BTreeMap::new(), BTreeMap::new());
        let (equations, faults) = (RefCell::default(), RefCell::default());
        Self { content, math: Math::new(), later, places, evidence: None, accuracy: None, chapters, equations, faults }
    }

    /// Records a fault.
    pub(crate) fn fault(&self, at: &Place, message: impl Into<String>) {
        self.faults.borrow_mut().push(&at.file, at.line, message);
    }

    /// The formula called `id`.
    pub(crate) fn entry(&self, id: &str) -> Option<&'a Entry> {
        self.content.entries.iter().find(|entry| entry.id == id)
    }

    /// A link from the page `from` to the entry of `id`, or bare code if it has none.
    pub(crate) fn link(&self, from: &str, id: &str) -> String {
        let code = format!("<code>{}</code>", escape(id));
        match self.places.get(id) {
            Some(place) if place.page == from => format!("<a href=\"#{id}\">{code}</a>"),
            Some(place) => format!("<a href=\"{}#{id}\">{code}</a>", relative(from, &place.page)),
            None => code,
        }
    }

    /// A formula within a line, with its bare letters for search; a fault if it cannot be converted.
    pub(crate) fn inline_math(&self, at: &Place, latex: &str) -> String {
        let mathml = self.or_fault(at, self.math.inline(latex));
        let words = text_of(&mathml);
        self.later.keep(&mathml, &words)
    }

    /// A formula on its own line with its number, which is a link to itself; a fault if it cannot be converted. The anchor is
    /// `eq-` and `name`, or the page and the position on it: unlike the number it stays when chapters move.
    pub(crate) fn block_math(&self, at: &Place, latex: &str, name: Option<&str>) -> String {
        let count = {
            let mut equations = self.equations.borrow_mut();
            let count = equations.entry(at.page.clone()).or_default();
            *count += 1;
            *count
        };
        let stem = at.page.trim_end_matches(".html").replace('/', "-");
        let anchor = name.map_or_else(|| format!("eq-{stem}-{count}"), |name| format!("eq-{name}"));
        let number = match self.chapters.get(&at.page) {
            Some(chapter) => format!("{chapter}.{count}"),
            None => count.to_string(),
        };
        let math = self.or_fault(at, self.math.block(latex));
        let address =
            self.content.cited.as_ref().map_or(String::new(), |cited| cited.address(&format!("{}#{anchor}", at.page)));
        let html = format!(
            "<span class=\"equation\" id=\"{0}\">{math}<a class=\"number\" href=\"#{0}\" title=\"{1}\" aria-label=\"Equation {number}\">({number})</a></span>",
            escape(&anchor),
            escape(&address)
        );
        self.later.keep(&html, "")
    }

    /// *Text* as HTML: `$…$` is mathematics, `` `…` `` is code, `[…](…)` is a link, everything else is plain text.
    pub(crate) fn text(&self, at: &Place, text: &str) -> String {
        self.text_with(at, text, |code| format!("<code>{}</code>", escape(code)))
    }

    /// Like [`Pages::text`], with links from code that names a formula.
    pub(crate) fn linked_text(&self, at: &Place, text: &str) -> String {
        self.text_with(at, text, |code| self.link(&at.page, code))
    }

    fn text_with(&self, at: &Place, text: &str, code: impl Fn(&str) -> String) -> String {
        let mut out = String::new();
        let mut rest = text;
        while let Some(Link { before, words, target, after }) = Link::first(rest) {
            out += &self.words_with(at, before, &code);
            let words = self.words_with(at, words, |code| format!("<code>{}</code>", escape(code)));
            out.extend(["<a href=\"", &escape(&relative(&at.page, target)), "\">", &words, "</a>"]);
            rest = after;
        }
        out + &self.words_with(at, rest, &code)
    }

    /// A text without links.
    fn words_with(&self, at: &Place, text: &str, code: impl Fn(&str) -> String) -> String {
        let mut out = String::new();
        let mut rest = text;
        while let Some(open) = rest.find(['$', '`']) {
            let (before, from) = rest.split_at(open);
            let mark = &from[..1];
            let Some((inner, after)) = from[1..].split_once(mark) else {
                self.fault(at, format!("unclosed `{mark}` in the catalog text {text:?}"));
                break;
            };
            out.push_str(&escape(before));
            if mark == "$" {
                out.push_str(&self.inline_math(at, inner));
            } else {
                out += &code(inner);
            }
            rest = after;
        }
        out + &escape(rest)
    }

    /// The HTML, or an empty text and a fault.
    fn or_fault(&self, at: &Place, result: Result<String, MathError>) -> String {
        result.unwrap_or_else(|error| {
            self.fault(at, error.to_string());
            String::new()
        })
    }
}

/// A link in a text.
struct Link<'t> {
    before: &'t str,
    words: &'t str,
    target: &'t str,
    after: &'t str,
}

impl<'t> Link<'t> {
    /// The first link.
    fn first(text: &'t str) -> Option<Self> {
        let (head, tail) = text.split_once("](")?;
        let (before, words) = head.rsplit_once('[')?;
        let (target, after) = tail.split_once(')')?;
        Some(Self { before, words, target, after })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(page: &str) -> Place {
        Place { file: "a.md".into(), line: 7, page: page.into() }
    }

    #[test]
    fn texts_have_mathematics_code_and_links() {
        let (content, later) = (Content::default(), Deferred::default());
        let mut pages = Pages::new(&content, &later);
        pages.places.insert("t.one".into(), place("b/c.html"));
        let at = place("b/a.html");
        let shown = |html: String| later.fill(&html);
        let link = "<a href=\"../b/c.html#t.one\"><code>t.one</code></a>";
        assert_eq!(
            pages.text(&at, "a < `t.one` [`d` e](f.html#g) h"),
            "a &lt; <code>t.one</code> <a href=\"../f.html#g\"><code>d</code> e</a> h"
        );
        assert_eq!(pages.linked_text(&at, "`t.one`, `x`"), format!("{link}, <code>x</code>"));
        assert_eq!(pages.link("b/c.html", "t.one"), "<a href=\"#t.one\"><code>t.one</code></a>");
        let mathematics = shown(pages.text(&at, "of $x$!"));
        assert!(
            mathematics.starts_with("of <math alttext=\"x\">") && mathematics.ends_with("</math>!"),
            "{mathematics}"
        );
        assert!(pages.faults.borrow().0.is_empty());
    }

    #[test]
    fn displays_are_numbered_by_chapter_and_have_anchors_that_stay() {
        let (content, later) = (Content::default(), Deferred::default());
        let mut pages = Pages::new(&content, &later);
        pages.chapters.insert("b.html".into(), "2.1".into());
        let shown = |page: &str, name| {
            let html = later.fill(&pages.block_math(&place(page), "x", name));
            let anchor = html.split_once(" id=\"").unwrap().1.split_once('"').unwrap().0.to_owned();
            let number = html.rsplit_once("\">").unwrap().1.split_once('<').unwrap().0.to_owned();
            assert!(html.contains(&format!("href=\"#{anchor}\"")), "{html}");
            [anchor, number]
        };
        assert_eq!(shown("b.html", None), ["eq-b-1", "(2.1.1)"]);
        assert_eq!(shown("a.html", None), ["eq-a-1", "(1)"]);
        assert_eq!(shown("b.html", Some("t.one")), ["eq-t.one", "(2.1.2)"]);
    }

    #[test]
    fn what_is_not_closed_or_cannot_be_set_is_a_fault() {
        let (content, later) = (Content::default(), Deferred::default());
        let pages = Pages::new(&content, &later);
        let at = place("a.html");
        assert_eq!(pages.text(&at, "a `b"), "a `b");
        assert_eq!(later.fill(&pages.inline_math(&at, "\\nonsense")), "");
        let faults: Vec<_> = pages.faults.borrow().0.iter().map(ToString::to_string).collect();
        assert_eq!(faults.len(), 2, "{faults:?}");
        assert_eq!(faults[0], "a.md:7: unclosed ``` in the catalog text \"a `b\"");
        assert!(faults[1].starts_with("a.md:7: cannot set the formula `\\nonsense`"), "{faults:?}");
    }
}
