//! The generated pages and tables: symbols, kinks, evidence, sources, kinds of elements.

use std::collections::BTreeMap;

use super::content::{Entry, Given, Kind, Symbol};
use super::entry::worst;
use super::html::{each, escape, number};
use super::pages::{Pages, Place};
use jointproof::verify::Claim;

/// A table that scrolls inside its box on narrow screens.
pub(crate) fn table(class: &str, head: &[&str], rows: &str) -> String {
    let head = each(head, |name| format!("<th>{name}</th>"));
    format!(
        "<div class=\"table-wrapper\" tabindex=\"0\"><table class=\"{class}\"><thead><tr>{head}</tr></thead>\
         <tbody>{rows}</tbody></table></div>"
    )
}

/// A row; a cell whose text can be long is `wide`, a number is a `figure`.
pub(crate) fn row(cells: &[(&str, String)]) -> String {
    let cell = |(class, html): &(&str, String)| format!("<td class=\"{class}\">{html}</td>");
    format!("<tr>{}</tr>", each(cells, cell))
}

/// Links to several formulas.
fn links(pages: &Pages<'_>, at: &Place, ids: &[&str]) -> String {
    let links: Vec<String> = ids.iter().map(|id| pages.link(&at.page, id)).collect();
    links.join(", ")
}

/// `{{#symbols}}`: every symbol with its unit and the formulas that use it.
pub(crate) fn symbols(pages: &Pages<'_>, at: &Place) -> String {
    let mut index: BTreeMap<_, (&Symbol, Vec<&str>)> = BTreeMap::new();
    for entry in &pages.content.entries {
        for symbol in entry.inputs.iter().chain(&entry.outputs) {
            let key = (symbol.name.to_lowercase(), &symbol.name, &symbol.latex, &symbol.shape, &symbol.unit);
            let users = &mut index.entry(key).or_insert((symbol, Vec::new())).1;
            if users.last() != Some(&&*entry.id) {
                users.push(&entry.id);
            }
        }
    }
    let rows = each(index.values(), |(symbol, users)| {
        row(&[
            ("", pages.inline_math(at, &symbol.latex)),
            ("", format!("<code>{}</code>", escape(&symbol.name))),
            ("", escape(&symbol.shape)),
            ("", escape(&symbol.unit)),
            ("wide", pages.text(at, &symbol.meaning)),
            ("wide", links(pages, at, users)),
        ])
    });
    table("index", &["Symbol", "Name", "Shape", "Unit", "Meaning", "Used by"], &rows)
}

/// `{{#kinks}}`: the register of kinks.
pub(crate) fn kinks(pages: &Pages<'_>, at: &Place) -> String {
    let all = pages.content.entries.iter().flat_map(|entry| entry.kinks.iter().map(move |kink| (entry, kink)));
    let rows = each(all, |(entry, kink)| {
        row(&[
            ("", pages.link(&at.page, &entry.id)),
            ("", pages.text(at, &kink.at)),
            ("", pages.text(at, &kink.derivative)),
            ("", pages.text(at, &kink.left)),
            ("", pages.text(at, &kink.right)),
            ("wide", pages.text(at, &kink.convention)),
        ])
    });
    table("kinks", &["Formula", "Where", "Derivative", "One side", "Other side", "Returned"], &rows)
}

/// The columns of the evidence table.
const EVIDENCE: &[&str] = &[
    "Formula",
    "Golden cases",
    "Points audited",
    "Value, η",
    "Jacobian, η",
    "Closed form against AD",
    "AD against differences",
    "Laws held",
];

/// `{{#evidence}}`: what was executed on each formula.
pub(crate) fn evidence(pages: &Pages<'_>, at: &Place) -> String {
    table("evidence", EVIDENCE, &each(&pages.content.entries, |entry| evidence_row(pages, at, entry)))
}

/// One formula's evidence.
fn evidence_row(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let link = pages.link(&at.page, &entry.id);
    let golden = entry.evidence.golden_cases.map_or("not checked".to_owned(), |cases| cases.to_string());
    let Some(audit) = &entry.evidence.audit else {
        let columns = EVIDENCE.len() - 2;
        return format!(
            "<tr><td>{link}</td><td class=\"figure\">{golden}</td><td colspan=\"{columns}\" class=\"missing\">not audited on this version</td></tr>"
        );
    };
    let held = audit.laws.iter().filter(|law| law.held()).count();
    row(&[
        ("", link),
        ("figure", golden),
        ("figure", (audit.named_points + audit.random_points).to_string()),
        ("figure", worst(&audit.eta)),
        ("figure", worst(&audit.eta_jacobian)),
        ("figure", gap(&audit.closed_against_ad)),
        ("figure", gap(&audit.ad_against_differences)),
        ("figure", format!("{held} of {}", audit.laws.len())),
    ])
}

/// The worst deviation where the bound is the same for every formula.
fn gap(claim: &Claim) -> String {
    claim.worst.as_ref().filter(|_| claim.held()).map_or_else(|| worst(claim), |worst| number(worst.size))
}

/// `{{#sources}}`: every document cited, with the formulas taken from it.
pub(crate) fn sources(pages: &Pages<'_>, at: &Place) -> String {
    let mut index: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for entry in &pages.content.entries {
        index.entry((&entry.source.name, &entry.source.citation)).or_default().push(&entry.id);
    }
    let rows = each(&index, |((name, citation), ids)| {
        row(&[("", pages.text(at, name)), ("wide", pages.text(at, citation)), ("wide", links(pages, at, ids))])
    });
    table("sources", &["Source", "Document", "Formulas"], &rows)
}

/// `{{#kinds 3d}}`: what the elements of a dimension are given, and their outputs with the formulas behind them.
pub(crate) fn kinds(pages: &Pages<'_>, at: &Place, dimension: &str) -> String {
    let kinds: Vec<_> = pages.content.kinds.iter().filter(|kind| kind.dimension == dimension).collect();
    if kinds.is_empty() {
        pages.fault(at, format!("no kinds of elements in the dimension `{dimension}`"));
    }
    each(kinds, |kind| kind_of_element(pages, at, kind))
}

fn kind_of_element(pages: &Pages<'_>, at: &Place, kind: &Kind) -> String {
    let Kind { name, dimension, nodes, parameters, loads, outputs } = kind;
    let code = |name: &str| ("", format!("<code>{}</code>", escape(name)));
    let given = |given: &Given, without: &str| {
        row(&[code(&given.name), ("wide", pages.text(at, &given.meaning)), ("", pages.text(at, without))])
    };
    let rows = each(parameters, |parameter| given(parameter, &parameter.without))
        + &each(loads, |load| given(load, "a load, 0 until a frame gives it"));
    let inputs = if rows.is_empty() { rows } else { table("index", &["Given", "Meaning", "If not given"], &rows) };
    let rows = each(outputs, |output| {
        let formulas: Vec<_> = output.formulas.iter().map(String::as_str).collect();
        row(&[code(&output.name), ("wide", pages.text(at, &output.meaning)), ("wide", links(pages, at, &formulas))])
    });
    let outputs = table("index", &["Output", "Meaning", "Formula"], &rows);
    let (name, nodes) = (escape(name), escape(nodes));
    format!("<p id=\"{name}-{dimension}\"><strong><code>{name}</code></strong>, nodes {nodes}</p>{inputs}{outputs}")
}
