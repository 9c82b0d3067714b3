//! One formula's entry: equation, symbols, source, kinks, evidence, golden cases, code and tests.

use super::calculator;
use super::content::{CodeSpan, Entry, Evidence, GoldenCounts, Kink, Source, Symbol, TestRef};
use super::html::{each, escape, number, relative};
use super::pages::{Pages, Place};
use super::rust;
use super::source::listing_page;
use super::speed;
use crate::extension::Fact;
use crate::looked;
use jointproof::verify::{Audit, Claim, Looked};

/// The entry as one line of HTML.
pub(crate) fn entry(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let id = escape(&entry.id);
    let title = pages.text(at, &entry.title);
    format!(
        "<section class=\"entry\"><h3 id=\"{id}\"><a class=\"header\" href=\"#{id}\">{title}</a> \
         <code class=\"entry-id\">{id}</code></h3>{}{}{}{}{}<dl class=\"facts\">{}</dl>{}{}{}{}</section>",
        pages.block_math(at, &entry.latex),
        given(pages, at, entry),
        view(pages, at, "With everything put in", &entry.closed),
        view(pages, at, "Its variation", &entry.variation),
        symbols(pages, at, entry),
        facts(pages, at, entry),
        pages.later.keep(calculator::folded(entry), ""),
        speed::folded(pages, entry),
        each(&entry.code, |span| code(pages, at, span)),
        tests(pages, at, entry)
    )
}

/// Where the symbols come from that the equation does not define.
fn given(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    match &*entry.given {
        "" => String::new(),
        given => format!("<p class=\"given\">{}</p>", pages.linked_text(at, given)),
    }
}

/// A folded equation that is made from the one above, and executed as that is.
fn view(pages: &Pages<'_>, at: &Place, name: &str, lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let lines: Vec<_> = lines.iter().map(|line| line.replacen(" = ", " &= ", 1)).collect();
    let math = pages.block_math(at, &format!(r"\begin{{aligned}} {} \end{{aligned}}", lines.join(r" \\ ")));
    format!("<details class=\"view\"><summary>{name}</summary>{math}</details>")
}

/// Inputs and outputs in one table, so that their columns line up.
fn symbols(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let rows = |caption: &str, symbols: &[Symbol]| {
        if symbols.is_empty() {
            return String::new();
        }
        let rows = each(symbols, |symbol| symbol_row(pages, at, symbol));
        format!("<tbody><tr class=\"group\"><th colspan=\"6\" scope=\"rowgroup\">{caption}</th></tr>{rows}</tbody>")
    };
    format!(
        "<div class=\"table-wrapper\" tabindex=\"0\"><table class=\"symbols\"><thead><tr><th>Symbol</th><th>Name</th>\
         <th>Shape</th><th>Unit</th><th>Meaning</th><th>Allowed</th></tr></thead>{}{}</table></div>",
        rows("Inputs", &entry.inputs),
        rows("Outputs", &entry.outputs)
    )
}

/// One symbol.
fn symbol_row(pages: &Pages<'_>, at: &Place, symbol: &Symbol) -> String {
    let allowed = match &*symbol.allowed {
        "" => "any finite",
        allowed => allowed,
    };
    format!(
        "<tr><td>{}</td><td><code>{}</code></td><td>{}</td><td>{}</td><td class=\"wide\">{}</td>\
         <td class=\"allowed\">{}</td></tr>",
        pages.inline_math(at, &symbol.latex),
        escape(&symbol.name),
        escape(&symbol.shape),
        escape(&symbol.unit),
        pages.text(at, &symbol.meaning),
        pages.text(at, allowed)
    )
}

/// Source, provenance, what the project adds, kinks, golden cases and evidence.
fn facts(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let source = &entry.source;
    let place = if source.place.is_empty() { String::new() } else { format!(", {}", pages.text(at, &source.place)) };
    let mut out = fact("Source", &format!("{}{place}", document(pages, at, source)));
    out += &fact("Provenance", &pages.text(at, &source.provenance));
    for Fact { name, lines, .. } in pages.content.exhibits.facts.iter().filter(|fact| fact.formula == entry.id) {
        let items = each(lines, |line| format!("<li>{}</li>", pages.text(at, line)));
        out += &fact(&escape(name), &format!("<ul>{items}</ul>"));
    }
    out += &fact("Kinks", &kinks(pages, at, &entry.kinks, entry.evidence.audit.as_ref()));
    out += &fact("Golden cases", &golden(at, entry.golden.as_ref()));
    out += &fact("Evidence", &evidence(&entry.evidence));
    out + &fact("Laws", &laws(entry.evidence.audit.as_ref()))
}

/// The title of a document, as a link where it can be read.
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

/// Where value or derivative jumps, and what is returned there; where nothing is registered, how it was looked for.
fn kinks(pages: &Pages<'_>, at: &Place, kinks: &[Kink], audit: Option<&Audit>) -> String {
    let looked = audit.filter(|audit| audit.kinks.held()).and_then(|audit| audit.looked.as_ref());
    if kinks.is_empty() {
        return match looked {
            None => "none registered, and not looked for on this version".to_owned(),
            Some(Looked::NamedPoints { .. }) => {
                "none at the named points; its comparisons were not searched".to_owned()
            }
            Some(Looked::Graph { .. }) => "none found: differentiable wherever it is defined".to_owned(),
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

/// How many golden cases there are of each kind, and the file.
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

/// What was executed, with the worst figures.
fn evidence(ran: &Evidence) -> String {
    let mut chips = vec![match ran.golden_cases {
        Some(cases) => format!("<b>{cases}</b> golden cases regenerated to the byte"),
        None => "golden file not checked on this version".to_owned(),
    }];
    let Some(audit) = &ran.audit else {
        chips.push("not audited on this version".to_owned());
        return format!("<ul class=\"chips\">{}</ul>", each(chips, |chip| format!("<li>{chip}</li>")));
    };
    let points = audit.named_points + audit.random_points;
    chips.push(format!("<b>{points}</b> points audited (seed {})", audit.seed));
    let claims = [
        ("value within η =", &audit.eta),
        ("Jacobian within η =", &audit.eta_jacobian),
        ("closed form against AD", &audit.closed_against_ad),
        ("AD against differences", &audit.ad_against_differences),
        ("printed equation against value", &audit.equation),
        ("its derivative against closed form", &audit.equation_jacobian),
    ];
    chips.extend(claims.iter().map(|(what, claim)| format!("{what} {}", worst(claim))));
    chips.extend(audit.looked.iter().flat_map(looked::lines).map(|line| escape(&line)));
    format!("<ul class=\"chips\">{}</ul>", each(chips, |chip| format!("<li>{chip}</li>")))
}

/// The worst deviation from a claim, its bound, and whether it failed.
pub(crate) fn worst(claim: &Claim) -> String {
    let bound = number(claim.bound);
    match (&claim.worst, claim.failures) {
        (None, _) => "not checked".to_owned(),
        (Some(worst), 0) => format!("<b>{}</b> (bound {bound})", number(worst.size)),
        (Some(worst), _) => format!("<b class=\"missing\">{} exceeds {bound}</b>", number(worst.size)),
    }
}

/// The laws that were tried, with counts.
fn laws(audit: Option<&Audit>) -> String {
    let Some(audit) = audit else { return "not tried on this version".to_owned() };
    let law = |law: &Claim| {
        let verdict = if law.held() { "held" } else { "<b class=\"missing\">failed</b>" };
        format!("<li>{}: {verdict}, {} times</li>", escape(&law.claim), law.checks)
    };
    format!("<ul>{}</ul>", each(&audit.laws, law))
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
    let listing = pages.later.keep(rust::block(lines), "");
    format!(
        "<details class=\"code\"><summary><code>{}</code> <a href=\"{}\">{}:{}</a></summary>{listing}</details>",
        escape(&span.name),
        escape(&link),
        escape(&span.file),
        span.first
    )
}

/// The tests that name the formula, and those that run over the whole catalog.
fn tests(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let named = test_list(pages, at, &entry.tests, "names this formula", "name this formula");
    let catalog = &pages.content.catalog_tests;
    named + &test_list(pages, at, catalog, "runs over every formula", "run over every formula")
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
