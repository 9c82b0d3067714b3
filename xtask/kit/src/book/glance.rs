//! The part of an entry before its evidence: a worked example, its derivative, what it uses and where it is used.

use super::content::{Entry, Symbol, Worked};
use super::html::{each, escape, relative};
use super::pages::{Pages, Place};
use crate::extension::Served;

/// The searchable summary of an entry: its outputs, inputs and source.
pub(crate) fn in_words(entry: &Entry) -> String {
    let listed = |symbols: &[Symbol]| {
        symbols.iter().map(|symbol| format!("{}, {}", symbol.name, symbol.meaning)).collect::<Vec<_>>().join("; ")
    };
    let source = [entry.source.title.as_str(), entry.source.place.as_str()].join(" ");
    let text = format!("Gives {}. Takes {}. {}.", listed(&entry.outputs), listed(&entry.inputs), source.trim());
    text.replace(['$', '`'], "")
}

/// The largest number of LaTeX characters of a derivative that is initially unfolded.
const SHORT: usize = 420;

/// `f2 = 3, f3 = 4: F_C = 5, ∂F_C/∂f2 = 0.6`, from a golden case.
pub(crate) fn worked(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let Some(Worked { case, inputs, outputs, derivatives }) = &entry.worked else { return String::new() };
    let listed = |parts: &[String]| {
        parts.iter().map(|part| format!("<span>{}</span>", pages.text(at, part))).collect::<Vec<_>>().join(", ")
    };
    format!(
        "<p class=\"worked\"><b>In numbers</b> {}: {} <span class=\"case\">(golden case <code>{}</code>)</span></p>",
        listed(inputs),
        listed(&[outputs.as_slice(), derivatives].concat()),
        escape(case)
    )
}

/// An equation derived from the one above and executed like it: the variation, which is unfolded if it is short, or else
/// the closed form.
pub(crate) fn view(pages: &Pages<'_>, at: &Place, entry: &Entry, name: &str, may_be_open: bool) -> String {
    let lines = if may_be_open { &entry.variation } else { &entry.closed };
    if lines.is_empty() {
        return String::new();
    }
    let open = if may_be_open && lines.concat().len() <= SHORT { " open" } else { "" };
    let lines: Vec<_> = lines.iter().map(|line| line.replacen(" = ", " &= ", 1)).collect();
    let anchor = format!("{}-{}", entry.id, name.split(' ').next().unwrap_or_default().to_lowercase());
    let math =
        pages.block_math(at, &format!(r"\begin{{aligned}} {} \end{{aligned}}", lines.join(r" \\ ")), Some(&anchor));
    format!("<details class=\"view\"{open}><summary>{name}</summary>{math}</details>")
}

/// The formulas whose outputs it uses.
pub(crate) fn uses(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let links: Vec<_> = entry.uses.iter().map(|id| pages.link(&at.page, id)).collect();
    links.join(", ")
}

/// The formulas that use its outputs, and the program outputs that it computes.
pub(crate) fn used_by(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let entries = pages.content.entries.iter().filter(|other| other.uses.contains(&entry.id));
    let formulas: Vec<_> = entries.map(|other| pages.link(&at.page, &other.id)).collect();
    let served: Vec<_> = pages.content.extras.served.iter().filter(|served| served.formula == entry.id).collect();
    let mut outputs: Vec<(&str, Vec<&Served>)> = Vec::new();
    for one in served {
        match outputs.iter_mut().find(|(output, _)| *output == one.output) {
            Some((_, of)) if of.iter().any(|known| (&known.of, &known.place) == (&one.of, &one.place)) => {}
            Some((_, of)) => of.push(one),
            None => outputs.push((&one.output, vec![one])),
        }
    }
    let output = |(output, of): &(&str, Vec<&Served>)| {
        let of = of.iter().map(|served| {
            format!("<a href=\"{}\">{}</a>", escape(&relative(&at.page, &served.place)), escape(&served.of))
        });
        format!("<code>{}</code> of {}", escape(output), with_and(&of.collect::<Vec<_>>()))
    };
    let outputs = outputs.iter().map(output).collect::<Vec<_>>().join(", ");
    let outputs = if outputs.is_empty() { outputs } else { format!("outputs of scenes {outputs}") };
    [formulas, vec![outputs]].concat().into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

/// Words separated by commas, with "and" before the last.
fn with_and(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [only] => only.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// How to cite it: in words and for BibTeX, with the permanent address.
pub(crate) fn cite(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let Some(cited) = &pages.content.cited else { return String::new() };
    let (id, book) = (&entry.id, &cited.book);
    let page = super::permalinks::page(id);
    let address = cited.address(&page);
    let title = entry.title.replace('$', "");
    let digest = entry.digest.as_ref().map_or(String::new(), |digest| format!("Golden file SHA-256 {digest}"));
    let year = if cited.year.is_empty() { String::new() } else { format!(" ({})", cited.year) };
    let words = format!("{}: {title}. Formula {id} of {book} {}{year}. {digest}", cited.authors, cited.version);
    // An author in two pairs of braces is an organisation.
    let fields = [
        ("title", format!("{title} ({id})")),
        ("author", format!("{{{}}}", cited.authors)),
        ("year", cited.year.clone()),
        ("howpublished", format!("{book} {}", cited.version)),
        ("url", if cited.site.is_empty() { String::new() } else { address.clone() }),
        ("note", digest),
    ];
    let fields = fields.iter().filter(|(_, value)| !value.is_empty());
    let bib =
        fields.fold(format!("@misc{{{id}"), |bib, (name, value)| format!("{bib},\n  {name} = {{{value}}}")) + "\n}";
    // The page itself is beside the others here; its address is where all versions are.
    format!(
        "<details class=\"cite\"><summary>Cite this entry</summary><p>{}. {}: <a href=\"{}\"><code>{}</code></a></p><pre><code class=\"nohighlight\">{}</code></pre></details>",
        escape(words.trim_end_matches(". ")),
        if cited.site.is_empty() { "Address within the book" } else { "Permanent address" },
        escape(&relative(&at.page, &page)),
        escape(&address),
        escape(&bib)
    )
}

/// A one-line summary of the folded evidence.
pub(crate) fn summary(entry: &Entry) -> String {
    let count = |number: usize, one: &str, many: &str| match number {
        0 => format!("no {many}"),
        1 => format!("1 {one}"),
        number => format!("{number} {many}"),
    };
    let mut parts = vec![
        entry
            .golden
            .as_ref()
            .map_or("no golden file".into(), |golden| count(golden.total, "golden case", "golden cases")),
        count(entry.kinks.len(), "kink", "kinks"),
    ];
    match &entry.evidence.audit {
        Some(audit) => {
            let held = audit.laws.iter().filter(|law| law.held()).count();
            parts.push(format!("{} points audited", audit.named_points + audit.random_points));
            parts.push(format!("{held} of {} held", count(audit.laws.len(), "law", "laws")));
            if !audit.passed() {
                parts.push("<b class=\"missing\">failed</b>".into());
            }
        }
        None => parts.push("not audited on this version".into()),
    }
    each(parts, |part| format!("<span>{part}</span>"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::book::content::{Cited, Content};
    use crate::book::deferred::Deferred;
    use crate::extension::Extras;

    fn place() -> Place {
        Place { file: "a.md".into(), line: 1, page: "a.html".into() }
    }

    #[test]
    fn a_derivative_is_open_where_it_is_short_and_may_be() {
        let (content, later) = (Content::default(), Deferred::default());
        let pages = Pages::new(&content, &later);
        let shown = |lines: &[String], may_be_open| {
            let (variation, closed) = if may_be_open { (lines.into(), vec![]) } else { (vec![], lines.into()) };
            let entry = Entry { id: "t.a".into(), variation, closed, ..Entry::default() };
            later.fill(&view(&pages, &place(), &entry, "V", may_be_open))
        };
        let (short, long) = (vec!["a = b = c".to_owned()], vec!["a = b".to_owned(); 100]);
        assert_eq!(shown(&[], true), "");
        assert!(shown(&short, true).starts_with("<details class=\"view\" open><summary>V</summary>"));
        assert!(shown(&short, false).starts_with("<details class=\"view\"><summary>"));
        assert!(shown(&long, true).starts_with("<details class=\"view\"><summary>"));
        // The equals signs are aligned, one per line.
        assert!(shown(&short, true).contains(r"\begin&#123;aligned} a &amp;= b = c \end&#123;aligned}"));
    }

    #[test]
    fn it_is_cited_with_its_year_at_an_address_that_is_a_url() {
        let cited = |site: &str, year: &str| {
            let cited = Cited {
                book: "joints".into(),
                authors: "A. Smith".into(),
                version: "1.2.0".into(),
                year: year.into(),
                site: site.into(),
            };
            let content = Content { cited: Some(cited), ..Content::default() };
            let later = Deferred::default();
            let entry = Entry { id: "t.a".into(), title: "Force $F$".into(), ..Entry::default() };
            cite(&Pages::new(&content, &later), &place(), &entry).replace("&#123;", "{").replace("&#10;", "\n")
        };
        let html = cited("https://joints.test/", "2026");
        assert!(
            html.contains("<a href=\"id/t.a.html\"><code>https://joints.test/v1.2.0/id/t.a.html</code></a>"),
            "{html}"
        );
        let bib = "@misc{t.a,\n  title = {Force F (t.a)},\n  author = {{A. Smith}},\n  year = {2026},\n  howpublished = {joints 1.2.0},\n  \
                   url = {https://joints.test/v1.2.0/id/t.a.html}\n}";
        assert!(html.contains(bib) && html.contains("Formula t.a of joints 1.2.0 (2026)"), "{html}");
        let html = cited("", "");
        // A relative path is no permanent address.
        assert!(
            html.contains("Address within the book: <a href=\"id/t.a.html\">") && !html.contains("ermanent"),
            "{html}"
        );
        assert!(!html.contains("url = ") && !html.contains("year") && !html.contains("()"), "{html}");
    }

    #[test]
    fn outputs_that_a_formula_computes_are_named_once_with_all_their_places() {
        let served = |formula: &str, output: &str, of: &str, place: &str| Served {
            formula: formula.into(),
            output: output.into(),
            of: of.into(),
            place: place.into(),
        };
        let all = vec![
            served("t.a", "U1", "slot", "s.html#3d"),
            served("t.a", "U1", "slot", "s.html#3d"),
            served("t.a", "U1", "slot", "s.html#2d"),
            served("t.b", "U2", "slot", "s.html#3d"),
            served("t.a", "RF", "slot", "s.html#3d"),
            served("t.a", "U1", "join", "s.html#3d"),
            served("t.a", "U1", "slot", "s.html#3d"),
        ];
        let uses = Entry { id: "t.c".into(), uses: vec!["t.a".into()], ..Entry::default() };
        let extras = Extras { served: all, ..Extras::default() };
        let content = Content { entries: vec![uses], extras, ..Content::default() };
        let later = Deferred::default();
        let pages = Pages::new(&content, &later);
        let of = |id: &str| used_by(&pages, &place(), &Entry { id: id.into(), ..Entry::default() });
        let link = |anchor: &str, of: &str| format!("<a href=\"s.html#{anchor}\">{of}</a>");
        let slots = format!("{}, {} and {}", link("3d", "slot"), link("2d", "slot"), link("3d", "join"));
        let rf = format!("<code>RF</code> of {}", link("3d", "slot"));
        assert_eq!(of("t.a"), format!("<code>t.c</code>, outputs of scenes <code>U1</code> of {slots}, {rf}"));
        assert_eq!(of("t.c"), "");
    }
}
