//! Finds the pieces to be replaced in a chapter: mathematics, directives, and code spans that name a formula.
//!
//! Parsing is left to pulldown-cmark, which mdBook uses as well, so that `$` and `{{#` inside code stay as they are.

use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// Directives that mdBook itself handles.
const MDBOOK_DIRECTIVES: &[&str] = &["include", "rustdoc_include", "playground", "playpen", "title"];

/// A piece to be replaced.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece {
    /// `$…$`
    InlineMath(String),
    /// `$$…$$`
    DisplayMath(String),
    /// `{{#name argument}}`, alone on its line.
    Directive {
        /// The word after `{{#`.
        name: String,
        /// Everything after the name, trimmed.
        argument: String,
    },
    /// `` `…` `` outside links and headings.
    Code(String),
}

/// A piece and its location in the chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Found {
    /// What it is.
    pub(crate) piece: Piece,
    /// The bytes to replace.
    pub(crate) range: Range<usize>,
    /// The line it begins on, from 1.
    pub(crate) line: usize,
}

/// All pieces of a chapter in order, and its faults as (line, message).
pub(crate) fn scan(chapter: &str) -> (Vec<Found>, Vec<(usize, String)>) {
    let mut scan = Scan { chapter, found: Vec::new(), faults: Vec::new(), opaque: Vec::new() };
    scan.events();
    scan.directives();
    scan.found.sort_by_key(|found| found.range.start);
    (scan.found, scan.faults)
}

/// The text of one line up to the braces that close two opening ones.
pub(crate) fn balanced(text: &str) -> Option<&str> {
    let mut open = 2;
    for (at, c) in text.char_indices() {
        match c {
            '{' => open += 1,
            '}' => open -= 1,
            '\n' => return None,
            _ => {}
        }
        if open == 0 {
            return text[..at].strip_suffix('}');
        }
    }
    None
}

/// The code spans of a chapter.
pub(crate) fn code(chapter: &str) -> Vec<Range<usize>> {
    let events = Parser::new_ext(chapter, options()).into_offset_iter();
    let is_code = |event: &Event<'_>| matches!(event, Event::Code(_) | Event::Start(Tag::CodeBlock(_)));
    events.filter(|(event, _)| is_code(event)).map(|(_, range)| range).collect()
}

/// Text and mathematics within lines, outside code, headings, links and directives without a caption.
pub(crate) fn texts(chapter: &str) -> Vec<Range<usize>> {
    let (mut all, mut not_prose) = (Vec::new(), 0_usize);
    for (event, range) in Parser::new_ext(chapter, options()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::Heading { .. } | Tag::Link { .. } | Tag::Image { .. }) => {
                not_prose += 1;
            }
            Event::End(TagEnd::CodeBlock | TagEnd::Heading(_) | TagEnd::Link | TagEnd::Image) => not_prose -= 1,
            Event::Text(_) | Event::InlineMath(_) if not_prose == 0 => all.push(range),
            _ => {}
        }
    }
    // Captions of directives are prose.
    all.retain(|range| {
        let line = chapter[..range.start].rfind('\n').map_or(0, |at| at + 1);
        !chapter[line..].starts_with("{{#") || chapter[line..].starts_with("{{#figure")
    });
    all
}

/// The extensions mdBook switches on, and mathematics.
fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// A scan in progress.
struct Scan<'a> {
    /// The chapter.
    chapter: &'a str,
    /// The pieces found so far.
    found: Vec<Found>,
    /// The faults found so far.
    faults: Vec<(usize, String)>,
    /// Code and HTML, in which nothing is replaced.
    opaque: Vec<Range<usize>>,
}

impl Scan<'_> {
    /// Finds mathematics and code with the Markdown parser.
    fn events(&mut self) {
        let (mut in_code_block, mut no_links) = (false, 0_usize);
        for (event, range) in Parser::new_ext(self.chapter, options()).into_offset_iter() {
            match event {
                Event::Start(Tag::CodeBlock(_)) => {
                    in_code_block = true;
                    self.opaque.push(range);
                }
                Event::End(TagEnd::CodeBlock) => in_code_block = false,
                Event::Start(Tag::Link { .. } | Tag::Heading { .. } | Tag::Image { .. }) => no_links += 1,
                Event::End(TagEnd::Link | TagEnd::Heading(_) | TagEnd::Image) => no_links -= 1,
                Event::Html(_) | Event::InlineHtml(_) => self.opaque.push(range),
                Event::InlineMath(latex) => self.push(Piece::InlineMath(latex.into_string()), range),
                Event::DisplayMath(latex) => self.push(Piece::DisplayMath(latex.into_string()), range),
                Event::Code(text) => {
                    self.opaque.push(range.clone());
                    if no_links == 0 {
                        self.push(Piece::Code(text.into_string()), range);
                    }
                }
                Event::Text(_) if !in_code_block => self.stray_dollar(range),
                _ => {}
            }
        }
    }

    /// Reports a dollar sign left in the text: either a formula that the parser could not close, or a price that was not escaped.
    fn stray_dollar(&mut self, range: Range<usize>) {
        let start = range.start;
        for (offset, _) in self.chapter[range].match_indices('$') {
            let at = start + offset;
            let line = self.line(at);
            let known = self.faults.last().is_some_and(|fault| fault.0 == line);
            if !known && !self.chapter[..at].ends_with('\\') {
                let text = self.chapter[at..].lines().next().unwrap_or("");
                let hint =
                    "are its braces balanced, and is there no `|` in it within a table? A dollar sign is written `\\$`";
                self.faults.push((line, format!("no formula is closed in `{text}`; {hint}")));
            }
        }
    }

    /// Directives outside code.
    fn directives(&mut self) {
        for (start, _) in self.chapter.match_indices("{{#") {
            if self.chapter[..start].ends_with('\\') || self.opaque.iter().any(|range| range.contains(&start)) {
                continue;
            }
            let line = self.line(start);
            let Some(inner) = balanced(&self.chapter[start + 2..]).and_then(|inside| inside.strip_prefix('#')) else {
                self.faults.push((line, "this directive has no `}}` on its line".to_owned()));
                continue;
            };
            let range = start..start + inner.len() + 5;
            let (name, argument) = inner.trim().split_once(char::is_whitespace).unwrap_or((inner.trim(), ""));
            if MDBOOK_DIRECTIVES.contains(&name) {
                continue;
            }
            if !self.alone(&range) {
                self.faults.push((line, format!("`{{{{#{inner}}}}}` must stand alone on its line")));
            }
            let (name, argument) = (name.to_owned(), argument.trim().to_owned());
            self.found.retain(|found| !range.contains(&found.range.start));
            self.push(Piece::Directive { name, argument }, range);
        }
    }

    /// Whether there is nothing else on the lines of `range`.
    fn alone(&self, range: &Range<usize>) -> bool {
        let before = self.chapter[..range.start].rsplit('\n').next().unwrap_or("");
        let after = self.chapter[range.end..].split('\n').next().unwrap_or("");
        before.is_empty() && after.trim().is_empty()
    }

    /// Records a piece.
    fn push(&mut self, piece: Piece, range: Range<usize>) {
        let line = self.line(range.start);
        self.found.push(Found { piece, range, line });
    }

    /// The line of a byte offset, from 1.
    fn line(&self, at: usize) -> usize {
        self.chapter[..at].matches('\n').count() + 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(chapter: &str) -> Vec<Piece> {
        scan(chapter).0.into_iter().map(|found| found.piece).collect()
    }

    fn inline(latex: &str) -> Piece {
        Piece::InlineMath(latex.to_owned())
    }

    fn directive(name: &str, argument: &str) -> Piece {
        Piece::Directive { name: name.to_owned(), argument: argument.to_owned() }
    }

    #[test]
    fn mathematics_is_found_and_code_is_left_alone() {
        let chapter = "a $x_1^2 * y_1$ and\n\n```\n$no$ {{#formula no}}\n```\n\n    $no$\n\n$$\nF = 1 \\\\\n$$\n";
        assert_eq!(pieces(chapter), [inline("x_1^2 * y_1"), Piece::DisplayMath("\nF = 1 \\\\\n".to_owned())]);
        assert_eq!(pieces("`$no$`"), [Piece::Code("$no$".to_owned())]);
    }

    #[test]
    fn escaped_dollars_stay_and_stray_ones_are_faults() {
        assert_eq!(scan("costs \\$5 and \\$6"), (vec![], vec![]));
        let (found, faults) = scan("fine\n\ncosts $ 5");
        assert!(found.is_empty());
        assert_eq!(faults.len(), 1);
        assert_eq!(faults[0].0, 3);
        assert_eq!(scan("$$\na = b").1.len(), 1, "unclosed display formula");
    }

    #[test]
    fn mathematics_works_in_tables_emphasis_headings_and_lists() {
        let chapter = "# Force $F$\n\n| a | b |\n|---|---|\n| $x$ | *in $y_1 z_1$* |\n\n- item $u$\n";
        assert_eq!(pieces(chapter), [inline("F"), inline("x"), inline("y_1 z_1"), inline("u")]);
    }

    #[test]
    fn a_bar_in_a_table_is_a_fault_rather_than_a_broken_table() {
        assert!(!scan("| a | b |\n|---|---|\n| $|x|$ | c |\n").1.is_empty());
    }

    #[test]
    fn directives_are_found_with_name_argument_and_line() {
        let chapter = "# T\n\n{{#formula slot.contact_force}}\n\n{{#figure slot The $x$ axis}}\n";
        let (found, faults) = scan(chapter);
        assert!(faults.is_empty());
        assert_eq!(found[0].piece, directive("formula", "slot.contact_force"));
        assert_eq!(found[0].line, 3);
        assert_eq!(found[1].piece, directive("figure", "slot The $x$ axis"));
        assert_eq!(found.len(), 2, "mathematics in an argument belongs to the directive");
    }

    /// The lines of the faults.
    fn wrong(chapter: &str) -> Vec<usize> {
        scan(chapter).1.into_iter().map(|(line, _)| line).collect()
    }

    #[test]
    fn stray_dollars_are_named_once_a_line_and_not_in_code() {
        assert_eq!(wrong("a $ b\n\nc $ d $ e\n\nf $ g"), [1, 3, 5]);
        assert_eq!(wrong("```\na $ b\n```\n\nc $ d"), [5]);
        assert!(scan("ab *c* 5 $ d").1[0].1.starts_with("no formula is closed in `$ d`; "));
    }

    #[test]
    fn pieces_are_in_order_and_their_places_are_theirs_alone() {
        let chapter = "a $x$\n\n{{#kinks}}\n\n`b` and $y$\n\n{{#speed own t}}\nc";
        let found = scan(chapter).0;
        let texts: Vec<_> = found.iter().map(|found| &chapter[found.range.clone()]).collect();
        assert_eq!(texts, ["$x$", "{{#kinks}}", "`b`", "$y$", "{{#speed own t}}"]);
        assert_eq!(found.iter().map(|found| found.line).collect::<Vec<_>>(), [1, 3, 5, 5, 7]);
    }

    #[test]
    fn directives_in_code_are_left_alone_wherever_it_stands() {
        let chapter = "```\n{{#kinks}}\n```\n\n```\n{{#symbols}}\n```\n\n`{{#sources}}`\n";
        assert_eq!(pieces(chapter), [Piece::Code("{{#sources}}".to_owned())]);
        assert!(wrong(chapter).is_empty());
        assert_eq!(wrong("a {{#kinks}}\n\n{{#kinks}} b\n"), [1, 3]);
    }

    #[test]
    fn a_directive_must_stand_alone_and_be_closed() {
        assert!(scan("see {{#kinks}}").1[0].1.contains("alone"));
        assert!(scan("{{#kinks").1[0].1.contains("}}"));
        assert_eq!(scan("\\{{#kinks}}").0, []);
        assert_eq!(scan("{{#include a.py}}").0, []);
    }

    #[test]
    fn code_in_links_and_headings_is_not_offered() {
        assert_eq!(pieces("## `a`\n\n[`b`](c.md) `d`"), [Piece::Code("d".to_owned())]);
    }
}
