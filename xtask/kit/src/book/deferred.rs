//! HTML that is inserted into the pages after mdBook has rendered them.
//!
//! mdBook parses and rewrites every piece of HTML it is given, and indexes all its text. `MathML`, figures and code
//! bypass both: a chapter contains a numbered placeholder, which [`Deferred::fill`] replaces in the finished page. A
//! placeholder may contain words; only these are indexed for search.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::html::escape_markdown;

/// The beginning of a placeholder; its number and `">` follow.
const OPEN: &str = "<span data-later=\"";

/// The pieces of HTML of one build.
#[derive(Debug, Default)]
pub(crate) struct Deferred {
    /// The pieces; a placeholder contains the index of its piece.
    pieces: RefCell<Vec<String>>,
    /// The address of each formula's entry, from the root of the book.
    pub(crate) places: RefCell<BTreeMap<String, String>>,
}

impl Deferred {
    /// Keeps `html`, which may itself contain placeholders, for later and returns a placeholder that is safe in both
    /// Markdown and HTML.
    pub(crate) fn keep(&self, html: &str, words_for_search: &str) -> String {
        let html = self.fill(html);
        let mut pieces = self.pieces.borrow_mut();
        pieces.push(html);
        format!("{OPEN}{}\">{}</span>", pieces.len() - 1, escape_markdown(words_for_search))
    }

    /// Replaces every placeholder in a finished page.
    pub(crate) fn fill(&self, page: &str) -> String {
        let pieces = self.pieces.borrow();
        let mut out = String::new();
        let mut rest = page;
        while let Some(start) = rest.find(OPEN) {
            out.push_str(&rest[..start]);
            rest = &rest[start + OPEN.len()..];
            let Some((number, tail)) = rest.split_once("\">") else {
                break;
            };
            let piece = number.parse().ok().and_then(|n: usize| pieces.get(n));
            out.push_str(piece.map_or("", String::as_str));
            rest = tail.split_once("</span>").map_or("", |(_, after)| after);
        }
        out.push_str(rest);
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_are_replaced_with_their_words() {
        let later = Deferred::default();
        let a = later.keep("<b>A</b>", "a_1");
        let b = later.keep("<b>B</b>", "");
        assert!(a.contains("a&#95;1"));
        assert_eq!(later.fill(&format!("x {a} y {b} z")), "x <b>A</b> y <b>B</b> z");
        let both = later.keep(&format!("<i>{a}</i>{b}"), "");
        assert_eq!(later.fill(&both), "<i><b>A</b></i><b>B</b>");
        assert_eq!(later.fill("nothing"), "nothing");
    }
}
