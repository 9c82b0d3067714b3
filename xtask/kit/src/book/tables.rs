//! The generated pages and tables: symbols, kinks, evidence, sources, and the project's own.

use std::collections::BTreeMap;

use super::content::{Content, Entry, Source, Symbol};
use super::entry::{bound, document, of_every, worst};
use super::html::{each, escape, number, row, table};
use super::pages::{Pages, Place};
use crate::extension::Table;
use jointproof::toolkit::verify::{Audit, Claim, Examination};

/// Links to several formulas.
fn links(pages: &Pages<'_>, at: &Place, ids: &[&str]) -> String {
    let links: Vec<String> = ids.iter().map(|id| pages.link(&at.page, id)).collect();
    links.join(", ")
}

/// `{{#symbols}}`: every symbol with its unit and the formulas that use it.
pub(crate) fn symbols(pages: &Pages<'_>, at: &Place) -> String {
    let rows = each(symbol_rows(pages.content), |SymbolRow { anchor, symbol, users }| {
        row(&[
            ("", format!("<span id=\"{}\">{}</span>", escape(&anchor), pages.inline_math(at, &symbol.latex))),
            ("", format!("<code>{}</code>", escape(&symbol.name))),
            ("wide", pages.text(at, &symbol.meaning)),
            ("", escape(&symbol.shape)),
            ("", escape(&symbol.unit)),
            ("wide", links(pages, at, &users)),
        ])
    });
    // Search has an entry for each symbol, which links here.
    let shown = table("index symbols", &["Symbol", "Name", "Meaning", "Shape", "Unit", "Used by"], &rows);
    pages.later.keep(&shown, "")
}

/// The prefix of the anchors of symbols.
pub(crate) const SYMBOL: &str = "symbol-";

/// A symbol, identified by its name, letters, shape and unit, and the formulas that use it.
pub(crate) struct SymbolRow<'a> {
    pub(crate) anchor: String,
    pub(crate) symbol: &'a Symbol,
    pub(crate) users: Vec<&'a str>,
}

/// Every symbol in the order of the names.
pub(crate) fn symbol_rows(content: &Content) -> Vec<SymbolRow<'_>> {
    let mut index: BTreeMap<_, (&Symbol, Vec<&str>)> = BTreeMap::new();
    for entry in &content.entries {
        for symbol in entry.inputs.iter().chain(&entry.outputs) {
            let key = (symbol.name.to_lowercase(), &symbol.name, &symbol.latex, &symbol.shape, &symbol.unit);
            let users = &mut index.entry(key).or_insert((symbol, Vec::new())).1;
            if users.last() != Some(&&*entry.id) {
                users.push(&entry.id);
            }
        }
    }
    let mut rows: Vec<SymbolRow<'_>> = Vec::new();
    for (symbol, users) in index.into_values() {
        let same = rows.iter().filter(|row| row.symbol.name == symbol.name).count();
        let number = if same == 0 { String::new() } else { format!("-{}", same + 1) };
        rows.push(SymbolRow { anchor: format!("{SYMBOL}{}{number}", symbol.name), symbol, users });
    }
    rows
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
    table("kinks", &["Formula", "Where", "What jumps", "From", "To", "Returned"], &rows)
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
    "Printed equation",
    "Its derivative",
    "Places crossed",
    "Laws held",
];

/// `{{#evidence}}`: the executed checks of each formula.
pub(crate) fn evidence(pages: &Pages<'_>, at: &Place) -> String {
    let shown = table("evidence", EVIDENCE, &each(&pages.content.entries, |entry| evidence_row(pages, at, entry)));
    pages.later.keep(&(shown + &of_every(pages, at)), "")
}

/// One formula's evidence.
fn evidence_row(pages: &Pages<'_>, at: &Place, entry: &Entry) -> String {
    let id = escape(&entry.id);
    let broken = id.replace('_', "_<wbr>").replace('.', ".<wbr>");
    let link = pages.link(&at.page, &entry.id).replace(&format!(">{id}<"), &format!(">{broken}<"));
    let golden = entry.evidence.golden_cases.map_or("not checked".to_owned(), |cases| cases.to_string());
    let Some(audit) = &entry.evidence.audit else {
        let columns = EVIDENCE.len() - 2;
        return format!(
            "<tr><td>{link}</td><td class=\"figure\">{golden}</td><td colspan=\"{columns}\" class=\"missing\">not audited on this version</td></tr>"
        );
    };
    let automatic = || "automatic".to_owned();
    let held = audit.laws.iter().filter(|law| law.held()).count();
    row(&[
        ("", link),
        ("figure", golden),
        ("figure", (audit.named_points + audit.random_points).to_string()),
        ("figure", bounded(&audit.eta)),
        ("figure", audit.eta_jacobian.as_ref().map_or_else(automatic, bounded)),
        ("figure", audit.closed_against_ad.as_ref().map_or_else(automatic, gap)),
        ("figure", gap(&audit.ad_against_differences)),
        ("figure", gap(&audit.equation)),
        ("figure", gap(&audit.equation_jacobian)),
        ("figure", crossed(audit)),
        ("figure", format!("{held} of {}", audit.laws.len())),
    ])
}

/// `{{#accuracy}}`: the bounds of η of every formula, and how they are known.
pub(crate) fn accuracy(pages: &Pages<'_>, at: &Place) -> String {
    let rows = each(&pages.content.entries, |entry| {
        row(&[("", pages.link(&at.page, &entry.id)), ("wide", pages.text(at, &entry.accuracy))])
    });
    pages.later.keep(&table("index", &["Formula", "Bounds of η"], &rows), "")
}

/// The largest deviation and its bound, `0.9 ≤ 4`.
fn bounded(claim: &Claim) -> String {
    match &claim.worst {
        Some(worst) if claim.held() => format!("<b>{}</b>\u{a0}≤\u{a0}{}", number(worst.size), bound(claim)),
        _ => worst(claim),
    }
}

/// The number of candidates for kinks on which points were found.
fn crossed(audit: &Audit) -> String {
    match &audit.examination {
        Some(Examination::Graph { search, .. }) => {
            format!("{} of {}", search.candidates - search.not_reached.len(), search.candidates)
        }
        Some(Examination::NamedPoints { .. }) | None => "at named points".into(),
    }
}

/// The largest deviation, for a claim with the same bound for every formula.
fn gap(claim: &Claim) -> String {
    claim.worst.as_ref().filter(|_| claim.held()).map_or_else(|| worst(claim), |worst| number(worst.size))
}

/// `{{#sources}}`: every document cited, with the formulas taken from it.
pub(crate) fn sources(pages: &Pages<'_>, at: &Place) -> String {
    let mut index: BTreeMap<(&str, &str), (&Source, Vec<&str>)> = BTreeMap::new();
    for entry in &pages.content.entries {
        let key: (&str, &str) = (&entry.source.title, &entry.source.link);
        index.entry(key).or_insert((&entry.source, Vec::new())).1.push(&entry.id);
    }
    let rows = each(index.values(), |(source, ids)| {
        row(&[("wide", document(pages, at, source)), ("wide", links(pages, at, ids))])
    });
    table("sources", &["Document", "Formulas"], &rows)
}

/// `{{#table name}}`: the project's tables with this name.
pub(crate) fn named(pages: &Pages<'_>, at: &Place, name: &str) -> String {
    let tables = &pages.content.extras.tables;
    let Some((_, named)) = tables.iter().find(|(known, _)| known == name) else {
        let known: Vec<_> = tables.iter().map(|(name, _)| name.as_str()).collect();
        pages.fault(at, format!("no table `{name}`; there are: {}", known.join(", ")));
        return String::new();
    };
    each(named, |Table { anchor, title, head, rows }| {
        // A column that says the same in every row is a sentence.
        let is_same = |k: &usize| {
            let text = rows.first().and_then(|row| row.get(*k)).filter(|text| text.contains(' '));
            rows.len() > 2 && text.is_some_and(|text| rows.iter().all(|row| row.get(*k) == Some(text)))
        };
        let (same, differ): (Vec<usize>, Vec<usize>) = (0..head.len()).partition(is_same);
        let head_of = |k: &usize| head[*k].as_str();
        let sentence = |k: &usize| {
            format!("<p class=\"same\">{}: {}.</p>", escape(head_of(k)), pages.linked_text(at, &rows[0][*k]))
        };
        let after = each(&same, sentence);
        // A text of several words may use the available width; a name must not be broken.
        let class = |text: &String| if text.contains(' ') { "wide" } else { "" };
        let cell = |text: &String| (class(text), pages.linked_text(at, text));
        let cells =
            |texts: &Vec<String>| row(&differ.iter().filter_map(|k| texts.get(*k)).map(cell).collect::<Vec<_>>());
        let shown: Vec<_> = differ.iter().map(head_of).collect();
        let id = if anchor.is_empty() { String::new() } else { format!(" id=\"{}\"", escape(anchor)) };
        let title = if title.is_empty() { String::new() } else { format!("<p{id}>{}</p>", pages.text(at, title)) };
        // Empty tables are omitted.
        let table = if rows.is_empty() { String::new() } else { table("index", &shown, &each(rows, cells)) };
        title + &table + &after
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_has_a_row_for_each_thing_it_stands_for_and_names_a_formula_once() {
        let symbol = |name: &str, unit: &str| Symbol { name: name.into(), unit: unit.into(), ..Symbol::default() };
        let entry = |id: &str, inputs: Vec<Symbol>, outputs: Vec<Symbol>| Entry {
            id: id.into(),
            inputs,
            outputs,
            ..Entry::default()
        };
        let entries = vec![
            entry("t.a", vec![symbol("x", "F")], vec![symbol("x", "F"), symbol("b", "1")]),
            entry("t.b", vec![symbol("x", "F"), symbol("x", "L")], vec![symbol("x", "F")]),
            entry("t.c", vec![symbol("x", "1")], vec![symbol("X", "1")]),
        ];
        let content = Content { entries, ..Content::default() };
        let rows = symbol_rows(&content);
        let shown: Vec<_> = rows.iter().map(|row| (&*row.anchor, &*row.symbol.unit, row.users.join(" "))).collect();
        let expected = [
            ("symbol-b", "1", "t.a"),
            ("symbol-X", "1", "t.c"),
            ("symbol-x", "1", "t.c"),
            ("symbol-x-2", "F", "t.a t.b"),
            ("symbol-x-3", "L", "t.b"),
        ];
        assert_eq!(shown, expected.map(|(anchor, unit, users)| (anchor, unit, users.to_owned())));
    }
}
