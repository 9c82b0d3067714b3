//! The mdBook preprocessor, run within this process: directives become entries and pages, LaTeX becomes `MathML`.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use mdbook_preprocessor::book::{Book, Chapter};
use mdbook_preprocessor::errors::Result;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

use super::content::Content;
use super::coverage::{self, Directive};
use super::deferred::Deferred;
use super::html::escape;
use super::markdown::{Found, Piece, scan};
use super::pages::{Pages, Place};
use super::prose::{self, Mark};
use super::sheet::Half;
use super::{downloads, entry, figure, numeral, sheet, speed, tables};

/// Expands chapters; see the module.
pub(crate) struct Formulary {
    /// The formulas and files.
    pub(crate) content: Rc<Content>,
    /// Collects the HTML to be inserted after rendering.
    pub(crate) later: Rc<Deferred>,
    /// The folder of the figures.
    pub(crate) figures: PathBuf,
}

impl Preprocessor for Formulary {
    fn name(&self) -> &'static str {
        "formulary"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let mut pages = Pages::new(&self.content, &self.later);
        let (mut scans, mut entries) = (Vec::new(), Vec::new());
        book.for_each_chapter_mut(|chapter| {
            let (shown, _) = numeral::shown(&chapter.content);
            chapter.content = with_texts(&self.content, &shown);
            let found = read(chapter, &pages, &mut entries);
            if let Some(number) = &chapter.number {
                pages.chapters.insert(page(chapter), number.to_string().trim_end_matches('.').to_owned());
            }
            for (table, place) in [("evidence", &mut pages.evidence), ("accuracy", &mut pages.accuracy)] {
                if found.iter().any(|found| is_directive(found, table)) {
                    *place = Some(page(chapter));
                }
            }
            scans.push(found);
        });
        note(entries, &mut pages);
        let places = pages.places.iter().map(|(id, at)| (id.clone(), format!("{}#{id}", at.page)));
        self.later.places.replace(places.collect());
        let mut scans = scans.into_iter();
        book.for_each_chapter_mut(|chapter| {
            let found = scans.next().unwrap_or_default();
            chapter.content = self.expand(&pages, chapter, &found);
        });
        pages.faults.into_inner().into_result()?;
        Ok(book)
    }
}

impl Formulary {
    /// The chapter with every piece replaced.
    fn expand(&self, pages: &Pages<'_>, chapter: &Chapter, found: &[Found]) -> String {
        let mut out = String::new();
        let (mut done, mut mark) = (0, None);
        for Found { piece, range, line } in found {
            out.push_str(&chapter.content[done..range.start]);
            let at = place(chapter, *line);
            let before = std::mem::replace(&mut mark, prose::mark(piece));
            match self.replacement(pages, &at, piece, before.as_ref()) {
                Some(replacement) => out.push_str(&replacement),
                None => out.push_str(&chapter.content[range.clone()]),
            }
            done = range.end;
        }
        out + &chapter.content[done..]
    }

    /// The replacement of a piece; `None` leaves it as it is.
    fn replacement(&self, pages: &Pages<'_>, at: &Place, piece: &Piece, mark: Option<&Mark>) -> Option<String> {
        match piece {
            Piece::InlineMath(latex) => Some(pages.inline_math(at, latex)),
            Piece::DisplayMath(latex) => {
                Some(pages.block_math(at, latex, None) + &mark.map(|mark| note_of(pages, at, mark)).unwrap_or_default())
            }
            Piece::Code(text) => pages.places.contains_key(text).then(|| pages.link(&at.page, text)),
            Piece::Directive { name, argument } => Some(format!("\n{}\n", self.directive(pages, at, name, argument))),
        }
    }

    /// The replacement of a directive; a fault if there is no such directive.
    fn directive(&self, pages: &Pages<'_>, at: &Place, name: &str, argument: &str) -> String {
        match (name, argument) {
            ("formula", id) => pages.entry(id).map(|formula| entry::entry(pages, at, formula)).unwrap_or_default(),
            ("figure", argument) => figure::figure(pages, at, &self.figures, argument),
            ("output", name) => Self::output(pages, at, name),
            // It annotates the display that follows.
            ("equation" | "presentation", _) => String::new(),
            ("text", name) => no_text(pages, at, name),
            ("symbols", "") => tables::symbols(pages, at),
            ("kinks", "") => tables::kinks(pages, at),
            ("evidence", "") => tables::evidence(pages, at),
            ("accuracy", "") => tables::accuracy(pages, at),
            ("sources", "") => tables::sources(pages, at),
            ("downloads", "") => downloads::table_of_elements(pages, at),
            ("downloads", element) => downloads::of(pages, at, element, true),
            ("element" | "element-in-numbers", argument) => no_sheet(pages, at, argument),
            ("speed", part) => speed::part(pages, at, part).unwrap_or_else(|| unknown(pages, at, name, argument)),
            ("table", name) => tables::named(pages, at, name),
            _ => unknown(pages, at, name, argument),
        }
    }

    /// `{{#output name}}`: the output of a program for this build.
    fn output(pages: &Pages<'_>, at: &Place, name: &str) -> String {
        let Some((_, text)) = pages.content.extras.outputs.iter().find(|(known, _)| known == name) else {
            let known: Vec<_> = pages.content.extras.outputs.iter().map(|(name, _)| name.as_str()).collect();
            pages.fault(at, format!("no output `{name}`; there are: {}", known.join(", ")));
            return String::new();
        };
        pages.later.keep(&format!("<pre class=\"output\"><code>{}</code></pre>", escape(text)), "")
    }
}

/// The chapter with `{{#text name}}` and the sheets of elements replaced by Markdown, which is then treated as part of it.
fn with_texts(content: &Content, chapter: &str) -> String {
    let mut out = String::new();
    let mut done = 0;
    for Found { piece, range, .. } in scan(chapter).0 {
        let Piece::Directive { name, argument } = piece else { continue };
        let text = match &*name {
            "text" => content.extras.texts.iter().find(|(known, _)| *known == argument).map(|(_, text)| text.clone()),
            name => Half::of(name).and_then(|half| sheet::markdown(content, half, &argument).ok()),
        };
        if let Some(text) = text {
            out.extend([&chapter[done..range.start], &text]);
            done = range.end;
        }
    }
    out + &chapter[done..]
}

/// The note below a display that says how it is checked.
fn note_of(pages: &Pages<'_>, at: &Place, mark: &Mark) -> String {
    let text = match mark {
        Mark::Presentation(why) => format!("Not executed: {why}."),
        Mark::Executed(about) => {
            let parts: Vec<_> = about.split(';').map(str::trim).collect();
            let of = parts.iter().find(|part| !part.is_empty() && !part.contains(char::is_whitespace));
            let of = of.map_or("for random numbers".into(), |id| format!("against `{id}`"));
            let where_ = parts.iter().find_map(|part| part.strip_prefix("if ")).map(|what| format!(", where ${what}$"));
            format!("Executed {of}{}.", where_.unwrap_or_default())
        }
    };
    format!("<span class=\"held\">{}</span>", pages.linked_text(at, &text))
}

/// An empty text, and a fault: texts with known names were inserted before.
fn no_text(pages: &Pages<'_>, at: &Place, name: &str) -> String {
    let known: Vec<_> = pages.content.extras.texts.iter().map(|(name, _)| name.as_str()).collect();
    pages.fault(at, format!("no text `{name}`; there are: {}", known.join(", ")));
    String::new()
}

/// An empty text, and a fault: sheets of elements were inserted before.
fn no_sheet(pages: &Pages<'_>, at: &Place, argument: &str) -> String {
    if let Err(message) = sheet::markdown(pages.content, Half::Equations, argument) {
        pages.fault(at, message);
    }
    String::new()
}

/// An empty text, and a fault.
fn unknown(pages: &Pages<'_>, at: &Place, name: &str, argument: &str) -> String {
    let known = format!(
        "formula ID, equation ID, presentation WHY, figure NAME, output NAME, table NAME, text NAME, element ID, downloads, symbols, kinks, evidence, accuracy, sources, {}",
        speed::PARTS
    );
    let written = format!("{name} {argument}");
    pages.fault(at, format!("unknown directive `{{{{#{}}}}}`; there are {known}", written.trim()));
    String::new()
}

/// Whether this is the directive for a table over all formulas.
fn is_directive(found: &Found, table: &str) -> bool {
    matches!(&found.piece, Piece::Directive { name, .. } if name == table)
}

/// The location of a line in a chapter.
fn place(chapter: &Chapter, line: usize) -> Place {
    Place { file: format!("book/src/{}", slashed(chapter.source_path.as_deref())), line, page: page(chapter) }
}

/// The page that a chapter becomes.
fn page(chapter: &Chapter) -> String {
    let page = PathBuf::from(slashed(chapter.path.as_deref())).with_extension("html");
    page.to_string_lossy().into_owned()
}

fn slashed(path: Option<&Path>) -> String {
    path.unwrap_or(Path::new("")).to_string_lossy().replace('\\', "/")
}

/// Finds the pieces of a chapter, and records the locations of entries.
fn read(chapter: &Chapter, pages: &Pages<'_>, entries: &mut Vec<(Directive, Place)>) -> Vec<Found> {
    let (found, faults) = scan(&chapter.content);
    for (line, message) in faults {
        pages.fault(&place(chapter, line), message);
    }
    for Found { piece, line, .. } in &found {
        if let Piece::Directive { name, argument } = piece
            && name == "formula"
        {
            let at = place(chapter, *line);
            entries.push((Directive { id: argument.clone(), file: at.file.clone(), line: at.line }, at));
        }
    }
    found
}

/// Keeps the location of each formula's first entry; records the faults found by [`coverage`].
fn note(entries: Vec<(Directive, Place)>, pages: &mut Pages<'_>) {
    let ids: Vec<&str> = pages.content.entries.iter().map(|entry| entry.id.as_str()).collect();
    let (directives, places): (Vec<_>, Vec<_>) = entries.into_iter().unzip();
    pages.faults.borrow_mut().0.extend(coverage::faults(&ids, &directives));
    for (directive, at) in directives.into_iter().zip(places) {
        pages.places.entry(directive.id).or_insert(at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn below_a_display_it_is_said_how_it_is_held() {
        let (content, later) = (Content::default(), Deferred::default());
        let pages = Pages::new(&content, &later);
        let at = Place { file: "a.md".into(), line: 1, page: "a.html".into() };
        let said = |mark: Mark| later.fill(&note_of(&pages, &at, &mark)).replace("<code>", "`").replace("</code>", "`");
        let executed = |about: &str| said(Mark::Executed(about.into()));
        let held = |text: &str| format!("<span class=\"held\">{text}</span>");
        assert_eq!(said(Mark::Presentation("as it is".into())), held("Not executed: as it is."));
        assert_eq!(executed("let a = 1; slot.stop"), held("Executed against `slot.stop`."));
        assert_eq!(executed("; let a = 1"), held("Executed for random numbers."));
        assert!(executed("if a").starts_with("<span class=\"held\">Executed for random numbers, where <math"));
        assert!(
            executed("slot.stop; if a").starts_with("<span class=\"held\">Executed against `slot.stop`, where <math")
        );
    }
}
