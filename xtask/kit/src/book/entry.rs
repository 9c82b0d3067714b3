//! One formula's entry: equation, symbols, source, kinks, evidence, golden cases, code and tests.

use super::calculator;
use super::content::{CodeSpan, Content, Entry, Evidence, GoldenCounts, Kink, Source, Symbol, TestRef};
use super::downloads;
use super::glance;
use super::html::{each, escape, number, relative};
use super::pages::{Pages, Place};
use super::rust;
use super::source::listing_page;
use super::speed;
use crate::extension::Fact;
use jointproof::toolkit::verify::{Audit, Claim, Examination};
use judge::examination;
use std::collections::BTreeSet;

/// The entry as one line of HTML.
pub(crate) fn entry(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let id = escape(&entry.id);
    let title = pages.text(at, &entry.title);
    let card = [
        pages.block_math(at, &entry.latex, Some(&entry.id)),
        given(pages, at, entry),
        glance::worked(pages, at, entry),
        glance::view(pages, at, entry, "Variation", true),
        glance::view(pages, at, entry, "Expanded equation", false),
        symbols(pages, at, entry),
        format!("<dl class=\"facts\">{}</dl>", facts(pages, at, entry)),
        calculator::folded(entry),
        proof(pages, at, entry),
        speed::folded(pages, entry),
        each(&entry.code, |span| code(pages, at, span)),
        glance::cite(pages, at, entry),
    ];
    format!(
        "<section class=\"entry\"><h3 id=\"{id}\"><a class=\"header\" href=\"#{id}\">{title}</a> \
         <code class=\"entry-id\">{id}</code></h3>{}</section>",
        pages.later.keep(&card.concat(), &glance::in_words(entry))
    )
}

/// The sources of the symbols that the equation does not define.
fn given(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    match &*entry.given {
        "" => String::new(),
        given => format!("<p class=\"given\">{}</p>", pages.linked_text(at, given)),
    }
}

/// Inputs and outputs in one table, so that their columns line up; what is the same of all is a sentence and no column.
fn symbols(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let columns = Columns::of(entry);
    let names = [("Symbol", true), ("Name", true), ("Shape", columns.shape), ("Unit", columns.unit)];
    let names = names.into_iter().chain([("Meaning", true), ("Allowed", columns.allowed)]);
    let names: Vec<_> = names.filter(|(_, is_shown)| *is_shown).collect();
    let count = names.len();
    let head = each(names, |(name, _)| format!("<th>{name}</th>"));
    let rows = |caption: &str, symbols: &[Symbol]| {
        if symbols.is_empty() {
            return String::new();
        }
        let rows = each(symbols, |symbol| symbol_row(pages, at, symbol, &columns));
        format!(
            "<tbody><tr class=\"group\"><th colspan=\"{count}\" scope=\"rowgroup\">{caption}</th></tr>{rows}</tbody>"
        )
    };
    format!(
        "<div class=\"table-wrapper\" tabindex=\"0\"><table class=\"symbols\"><thead><tr>{head}</tr></thead>{}{}</table></div>{}",
        rows("Inputs", &entry.inputs),
        rows("Outputs", &entry.outputs),
        columns.sentence(entry)
    )
}

/// The columns of the table of symbols that differ from row to row.
struct Columns {
    shape: bool,
    unit: bool,
    allowed: bool,
}

impl Columns {
    fn of(entry: &Entry) -> Self {
        let differs = |of: fn(&Symbol) -> &str| {
            let all: BTreeSet<&str> = entry.inputs.iter().chain(&entry.outputs).map(of).collect();
            all.len() > 1
        };
        Self { shape: differs(|symbol| &symbol.shape), unit: differs(|symbol| &symbol.unit), allowed: differs(allowed) }
    }

    /// `Every symbol is a scalar in FL; any finite number is allowed.`
    fn sentence(&self, entry: &Entry) -> String {
        let Some(first) = entry.inputs.first().or(entry.outputs.first()) else { return String::new() };
        let mut parts = Vec::new();
        if !self.shape {
            parts.push(format!("is a {}", escape(&first.shape)));
        }
        if !self.unit {
            parts.push(format!("has unit {}", escape(&first.unit)));
        }
        let own = match parts.as_slice() {
            [] => String::new(),
            parts => format!("Every symbol {}. ", parts.join(" and ")),
        };
        let rest = if self.allowed { "Where nothing is said, any" } else { "Any" };
        let is_said = !self.allowed && allowed(first) != FINITE;
        let allowed = if is_said {
            format!("Allowed is {}.", escape(allowed(first)))
        } else {
            format!("{rest} finite number is allowed.")
        };
        format!("<p class=\"same\">{own}{allowed}</p>")
    }
}

/// What is allowed where nothing else is said.
const FINITE: &str = "a finite number";

fn allowed(symbol: &Symbol) -> &str {
    if symbol.allowed.is_empty() { FINITE } else { &symbol.allowed }
}

/// One symbol; its attributes are read by the calculator.
fn symbol_row(pages: &Pages<'_>, at: &Place, symbol: &Symbol, columns: &Columns) -> String {
    let allowed = allowed(symbol);
    let cell = |class: &str, text: String, is_shown: bool| {
        if is_shown { format!("<td class=\"{class}\">{text}</td>") } else { String::new() }
    };
    let said = if allowed == FINITE { String::new() } else { pages.text(at, allowed) };
    format!(
        "<tr data-shape=\"{}\" data-unit=\"{}\" data-allowed=\"{}\"><td>{}</td><td><code>{}</code></td>{}{}<td class=\"wide\">{}</td>{}</tr>",
        escape(&symbol.shape),
        escape(&symbol.unit),
        escape(allowed),
        pages.inline_math(at, &symbol.latex),
        escape(&symbol.name),
        cell("shape", escape(&symbol.shape), columns.shape),
        cell("unit", escape(&symbol.unit), columns.unit),
        pages.text(at, &symbol.meaning),
        cell("allowed", said, columns.allowed)
    )
}

/// The formulas it uses, its users, its files in other languages, and its source.
fn facts(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let source = &entry.source;
    let place = if source.place.is_empty() { String::new() } else { format!(", {}", pages.text(at, &source.place)) };
    let provenance = pages.text(at, &source.provenance);
    let uses = [("Uses", glance::uses(pages, at, entry)), ("Used by", glance::used_by(pages, at, entry))];
    let uses = each(uses, |(name, html)| if html.is_empty() { html } else { fact(name, &html) });
    let downloads = downloads::of(pages, at, &entry.id, false);
    let downloads = if downloads.is_empty() { downloads } else { fact("Download", &downloads) };
    uses + &downloads + &fact("Source", &format!("{}{place}; {provenance}", document(pages, at, source)))
}

/// The folded evidence: the project's own facts, kinks, golden cases, measurements, laws and tests.
fn proof(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let mut out = String::new();
    for Fact { name, lines, .. } in pages.content.extras.facts.iter().filter(|fact| fact.formula == entry.id) {
        let items = each(lines, |line| format!("<li>{}</li>", pages.text(at, line)));
        out += &fact(&escape(name), &format!("<ul>{items}</ul>"));
    }
    out += &fact("Accuracy", &accuracy(pages, at, entry));
    out += &fact("Kinks", &kinks(pages, at, &entry.kinks, entry.evidence.audit.as_ref()));
    out += &fact("Golden cases", &golden(at, entry.golden.as_ref()));
    out += &fact("Executed", &evidence(&entry.evidence));
    out += &fact("Laws", &laws(pages, at, entry.evidence.audit.as_ref()));
    format!(
        "<details class=\"proof\"><summary>Evidence <span class=\"chips\">{}</span></summary><dl class=\"facts\">{out}</dl>{}</details>",
        glance::summary(entry),
        tests(pages, at, entry)
    )
}

/// The bounds of η, how they are known, and why some are not proved.
fn accuracy(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let how = pages
        .accuracy
        .as_ref()
        .map_or(String::new(), |page| format!(" <a href=\"{}\">How we know</a>", escape(&relative(&at.page, page))));
    let items = each(&entry.not_proved, |why| format!("<li>{}</li>", pages.text(at, why)));
    let items = if items.is_empty() { items } else { format!("<ul>{items}</ul>") };
    format!("{}.{how}{items}", pages.text(at, &entry.accuracy))
}

/// The title of a document, as a link if it has one.
pub(crate) fn document(pages: &Pages<'_>, at: &Place, source: &Source) -> String {
    let title = pages.text(at, &source.title);
    match &*source.link {
        "" => title,
        link => format!("<a href=\"{}\">{title}</a>", escape(link)),
    }
}

/// One row of the list of facts.
fn fact(name: &str, html: &str) -> String {
    format!("<dt>{name}</dt><dd>{html}</dd>")
}

/// The points where value or derivative jumps, and the convention there; if none is registered, how kinks were searched for.
fn kinks(pages: &Pages<'_>, at: &Place, kinks: &[Kink], audit: Option<&Audit>) -> String {
    let examination = audit.filter(|audit| audit.kinks.held()).and_then(|audit| audit.examination.as_ref());
    if kinks.is_empty() {
        return match examination {
            None => "none registered; the search was not run on this version".to_owned(),
            Some(Examination::NamedPoints { .. }) => {
                "none at the named points; its comparisons were not searched".to_owned()
            }
            Some(Examination::Graph { .. }) => "none found: differentiable wherever it is defined".to_owned(),
        };
    }
    let line = |kink: &Kink| {
        format!(
            "<li>{}: {} is {} from one side and {} from the other; {}</li>",
            pages.text(at, &kink.at),
            pages.text(at, &kink.derivative),
            pages.text(at, &kink.left),
            pages.text(at, &kink.right),
            pages.text(at, &kink.convention)
        )
    };
    format!("<ul class=\"kinks\">{}</ul>", each(kinks, line))
}

/// The number of golden cases of each kind, and the file.
fn golden(at: &Place, golden: Option<&GoldenCounts>) -> String {
    let Some(golden) = golden else {
        return "no golden file".to_owned();
    };
    let flag = |(name, count): &(String, usize)| format!("<li><b>{count}</b> {}</li>", escape(name));
    let flags = each(&golden.flags, flag);
    let link = relative(&at.page, &format!("golden/{}", golden.file));
    format!(
        "<ul class=\"chips\"><li><b>{}</b> in all</li>{flags}</ul> <a href=\"{}\"><code>{}</code></a>",
        golden.total,
        escape(&link),
        escape(&golden.file)
    )
}

/// The executed checks, with the largest deviations.
fn evidence(ran: &Evidence) -> String {
    let mut chips = vec![match ran.golden_cases {
        Some(cases) => format!("<b>{cases}</b> golden cases regenerated, identical bytes"),
        None => "golden file not checked on this version".to_owned(),
    }];
    let Some(audit) = &ran.audit else {
        chips.push("not audited on this version".to_owned());
        return format!("<ul class=\"chips\">{}</ul>", each(chips, |chip| format!("<li>{chip}</li>")));
    };
    let points = audit.named_points + audit.random_points;
    chips.push(format!("<b>{points}</b> points audited (seed {})", audit.seed));
    let claims = [
        ("value within η =", Some(&audit.eta)),
        ("Jacobian within η =", audit.eta_jacobian.as_ref()),
        ("closed form against AD", audit.closed_against_ad.as_ref()),
        ("AD against differences", Some(&audit.ad_against_differences)),
        ("printed equation against value", Some(&audit.equation)),
        ("its derivative against the Jacobian", Some(&audit.equation_jacobian)),
    ];
    chips.extend(claims.iter().filter_map(|(what, claim)| Some(format!("{what} {}", worst((*claim)?)))));
    chips.extend(audit.scaled.iter().map(|claim| format!("{}: {}", escape(&claim.claim), worst(claim))));
    chips.extend(audit.examination.iter().flat_map(examination::lines).map(|line| escape(&line)));
    format!("<ul class=\"chips\">{}</ul>", each(chips, |chip| format!("<li>{chip}</li>")))
}

/// The largest deviation of a claim, its bound, and whether it failed.
pub(crate) fn worst(claim: &Claim) -> String {
    let bound = bound(claim);
    match (&claim.worst, claim.failures) {
        (None, _) => "not checked".to_owned(),
        (Some(worst), 0) => format!("<b>{}</b> (bound {bound})", number(worst.size)),
        (Some(worst), _) => format!("<b class=\"missing\">{} exceeds {bound}</b>", number(worst.size)),
    }
}

/// The bound of a claim, and whether it is normwise.
pub(crate) fn bound(claim: &Claim) -> String {
    number(claim.bound) + if claim.is_normwise() { " normwise" } else { "" }
}

/// The laws that were checked, with counts: its own, and the number of those common to all formulas.
fn laws(pages: &Pages<'_>, at: &Place, audit: Option<&Audit>) -> String {
    let Some(audit) = audit else { return "not tested on this version".to_owned() };
    let law = |law: &Claim| {
        let verdict = if law.held() { "held" } else { "<b class=\"missing\">failed</b>" };
        format!("<li>{}: {verdict}, {} times</li>", escape(&law.claim), law.checks)
    };
    let of_every: Vec<&str> = common_laws(pages.content);
    let is_own = |law: &&Claim| !of_every.contains(&law.claim.as_str()) || !law.held();
    let (own, common): (Vec<_>, Vec<_>) = audit.laws.iter().partition(is_own);
    let times: usize = common.iter().map(|law| law.checks).sum();
    let held = |words: &str| format!("<li>{}: held, {times} times</li>", everywhere(pages, at, words, COMMON));
    let common = match common.len() {
        0 => String::new(),
        1 => held("the law of every formula"),
        count => held(&format!("the {count} laws of every formula")),
    };
    format!("<ul>{}{common}</ul>", each(own, law))
}

/// The anchor on the page of evidence for what is common to all formulas.
const COMMON: &str = "of-every-formula";

/// A text that links to an anchor on the page of evidence, if there is such a page.
fn everywhere(pages: &Pages<'_>, at: &Place, words: &str, anchor: &str) -> String {
    match &pages.evidence {
        Some(page) => format!("<a href=\"{}#{anchor}\">{words}</a>", escape(&relative(&at.page, page))),
        None => words.to_owned(),
    }
}

/// The laws common to all audited formulas, if there are several formulas.
fn common_laws(content: &Content) -> Vec<&str> {
    let audits: Vec<_> = content.entries.iter().filter_map(|entry| entry.evidence.audit.as_ref()).collect();
    let has = |audit: &&Audit, claim: &str| audit.laws.iter().any(|law| law.claim == claim);
    let first = audits.first().filter(|_| audits.len() > 1).map(|audit| audit.laws.as_slice()).unwrap_or_default();
    let claims = first.iter().map(|law| law.claim.as_str());
    claims.filter(|claim| audits.iter().all(|audit| has(audit, claim))).collect()
}

/// The laws and tests common to all formulas, for the page of evidence.
pub(crate) fn of_every(pages: &Pages<'_>, at: &Place) -> String {
    let laws = each(common_laws(pages.content), |law| format!("<li>{}</li>", escape(law)));
    let laws = if laws.is_empty() { laws } else { format!("<p>Laws of every formula:</p><ul>{laws}</ul>") };
    let tests = test_list(pages, at, &pages.content.catalog_tests, "runs over every formula", "run over every formula");
    format!("<div id=\"{COMMON}\" class=\"entry-like\">{laws}{tests}</div>")
}

/// A folded function with a link into the listing.
fn code(pages: &Pages<'_>, at: &Place, span: &CodeSpan) -> String {
    let Some(file) = pages.content.sources.iter().find(|source| source.path == span.file) else {
        pages.fault(at, format!("no listing of `{}`, which holds `{}`", span.file, span.name));
        return String::new();
    };
    let lines = rust::highlight(&file.text);
    let Some(lines) = lines.get(span.first.wrapping_sub(1)..span.last) else {
        pages.fault(at, format!("`{}` ends before line {}", span.file, span.last));
        return String::new();
    };
    let link = format!("{}#L{}", relative(&at.page, &listing_page(&span.file)), span.first);
    let listing = rust::block(lines);
    format!(
        "<details class=\"code\"><summary><code>{}</code></summary><p class=\"place\"><a href=\"{}\">{}:{}</a></p>{listing}</details>",
        escape(&span.name),
        escape(&link),
        escape(&span.file),
        span.first
    )
}

/// The tests that name the formula, and the number of those that run over all formulas.
fn tests(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let named = test_list(pages, at, &entry.tests, "names this formula", "name this formula");
    let over_all = match (pages.content.catalog_tests.len(), &pages.evidence) {
        (0, _) | (_, None) => return named,
        (count, _) => format!("{count} tests over every formula"),
    };
    format!("{named}<p class=\"over-all\">And {}.</p>", everywhere(pages, at, &over_all, COMMON))
}

/// A folded list of tests.
fn test_list(pages: &Pages<'_>, at: &Place, tests: &[TestRef], singular: &str, plural: &str) -> String {
    let items = each(tests, |test| {
        let place = format!("{}:{}", escape(&test.file), test.line);
        let link = format!("{}#L{}", relative(&at.page, &listing_page(&test.file)), test.line);
        let listed = pages.content.sources.iter().any(|source| source.path == test.file);
        let place = if listed { format!("<a href=\"{}\">{place}</a>", escape(&link)) } else { place };
        format!("<li><code>{}</code> {place}</li>", escape(&test.name))
    });
    match tests.len() {
        0 => String::new(),
        1 => format!("<details><summary>1 test {singular}</summary><ul>{items}</ul></details>"),
        count => format!("<details><summary>{count} tests {plural}</summary><ul>{items}</ul></details>"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn laws_of_every_formula_are_those_that_each_audit_has() {
        let of = |laws: &[&[&str]]| {
            let entry = |claims: &&[&str]| {
                let mut audit = sample::passed();
                let law = audit.laws[0].clone();
                audit.laws = claims.iter().map(|claim| Claim { claim: (*claim).into(), ..law.clone() }).collect();
                Entry { evidence: Evidence { audit: Some(audit), golden_cases: None }, ..Entry::default() }
            };
            let mut content = Content { entries: laws.iter().map(entry).collect(), ..Content::default() };
            // A formula that was not audited does not count as lacking a law.
            content.entries.push(Entry::default());
            common_laws(&content).into_iter().map(String::from).collect::<Vec<_>>()
        };
        assert_eq!(of(&[&["a", "b", "c"], &["c", "d", "a"], &["c", "a", "b"]]), ["a", "c"]);
        assert!(of(&[&["a"], &["b"]]).is_empty() && of(&[&["a"]]).is_empty() && of(&[]).is_empty());
    }

    #[test]
    fn a_normwise_bound_is_said_to_be_one() {
        let of = |by: &str| bound(&Claim { claim: format!("η of the value in f64{by}"), ..sample::passed().eta });
        assert_eq!(["", ", normwise"].map(of), ["4", "4 normwise"]);
    }
}
