//! Search: an index that knows the names of formulas, symbols and outputs, in place of mdBook's.
//!
//! mdBook collects the texts of all sections; its script shows the results. In between, `search.js` ranks them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use anyhow::{Context as _, Result};
use serde_json::{Value, json};

use super::content::{Content, Entry, Symbol};
use super::output::write;
use super::tables;

/// The script in the book.
const SCRIPT: &str = include_str!("search.js");

/// The script loaded by mdBook's pages, and ours in its place.
const THEIRS: &str = "elasticlunr.min.js";
const OURS: &str = "search.js";

/// The index of mdBook: a script that contains JSON within quotes.
const INDEX: &str = "searchindex.js";
const BEFORE: &str = "window.search = Object.assign(window.search, JSON.parse('";
const AFTER: &str = "'));";

/// The largest number of characters of a section that are searched.
const LONGEST: usize = 6000;

/// A page that loads our script.
pub(crate) fn in_page(page: &str) -> String {
    page.replace(&format!("{THEIRS}\""), &format!("{OURS}\""))
}

/// Replaces mdBook's script and index, if there are any, by ours.
///
/// # Errors
/// If the index does not have the format of mdBook, or a file cannot be written.
pub(crate) fn replace(out: &Path, content: &Content) -> Result<()> {
    let Ok(text) = fs::read_to_string(out.join(INDEX)) else { return Ok(()) };
    let mut index = read(&text).context("mdBook writes its search index in another way")?;
    let pages = pages(&index, content, symbols_page(out, &index).as_deref())
        .context("mdBook's search index has another layout")?;
    let settings = index.as_object_mut().context("mdBook's search index is no object")?;
    settings.remove("doc_urls");
    let urls: Vec<_> = pages.iter().map(|page| page[0].clone()).collect();
    settings.insert("doc_urls".into(), urls.into());
    settings.insert("index".into(), json!({ "pages": pages }));
    // JSON is valid JavaScript.
    write(&out.join(INDEX), format!("window.search = Object.assign(window.search, {index});\n").as_bytes())?;
    write(&out.join(OURS), format!("'use strict';\n(() => {{\n{SCRIPT}}})();\n").as_bytes())?;
    Ok(fs::remove_file(out.join(THEIRS))?)
}

fn read(text: &str) -> Option<Value> {
    let quoted = text.trim().strip_prefix(BEFORE)?.strip_suffix(AFTER)?;
    serde_json::from_str(&quoted.replace("\\'", "'").replace("\\\\", "\\")).ok()
}

/// The searchable items: sections, the lines of the table of symbols, and outputs of scenes. Each has its address,
/// title, path, text and names.
fn pages(index: &Value, content: &Content, symbols_page: Option<&str>) -> Option<Vec<[Value; 5]>> {
    let docs = index["index"]["documentStore"]["docs"].as_object()?;
    let mut sections = Vec::new();
    for (place, url) in index["doc_urls"].as_array()?.iter().enumerate() {
        let (doc, url) = (docs.get(&place.to_string())?, url.as_str()?);
        let text = |key: &str| doc[key].as_str().map(plain);
        sections.push(section(content, url, [text("title")?, text("breadcrumbs")?, text("body")?]));
    }
    let symbols = symbols_page.map(|page| symbols(content, page)).unwrap_or_default();
    Some([sections, symbols, outputs(content)].concat())
}

/// The page that has the table of all symbols.
fn symbols_page(out: &Path, index: &Value) -> Option<String> {
    let urls = index["doc_urls"].as_array()?.iter().filter_map(Value::as_str);
    let mut pages: Vec<_> = urls.filter_map(|url| url.split('#').next()).collect();
    pages.dedup();
    let begin = format!(" id=\"{}", tables::SYMBOL);
    let has_it = |page: &&str| fs::read_to_string(out.join(page)).is_ok_and(|text| text.contains(&begin));
    pages.into_iter().find(has_it).map(String::from)
}

/// A section; for an entry, with its names, outputs and inputs.
fn section(content: &Content, url: &str, [title, path, body]: [String; 3]) -> [Value; 5] {
    let id = url.split_once('#').map_or("", |(_, anchor)| anchor);
    let body: String = body.chars().take(LONGEST).collect();
    let Some(entry) = content.entries.iter().find(|entry| entry.id == id) else {
        let page = url.split('.').next().unwrap_or_default();
        let is_list = LISTS.contains(&page);
        return [
            url.into(),
            title.into(),
            path.into(),
            body.into(),
            json!(if is_list { json!({ "kind": "list" }) } else { json!({}) }),
        ];
    };
    // The heading contains the identifier too.
    let name = title.replace(&entry.id, "").trim().to_owned();
    [url.into(), title.into(), path.into(), body.into(), names(content, entry, &name)]
}

/// Pages that repeat content of others.
const LISTS: [&str; 5] = ["symbols", "kinks", "evidence", "traceability", "sources"];

fn names(content: &Content, entry: &Entry, title: &str) -> Value {
    let both = |symbols: &[Symbol]| -> Vec<String> {
        symbols.iter().flat_map(|symbol| [symbol.name.clone(), symbol.latex.clone()]).collect()
    };
    let served = content.extras.served.iter().filter(|served| served.formula == entry.id);
    let serves: BTreeSet<_> = served.map(|served| &served.output).collect();
    // The last part of the identifier, which several formulas may share.
    let tail = entry.id.rsplit('.').next().map(String::from);
    let gives = [both(&entry.outputs), tail.into_iter().collect()].concat();
    json!({
        "kind": "formula", "is": [&entry.id, title], "gives": gives, "serves": serves, "takes": both(&entry.inputs),
        "has": [&entry.latex],
    })
}

/// An item for each symbol, at its location in the table of all symbols.
fn symbols(content: &Content, page: &str) -> Vec<[Value; 5]> {
    let line = |row: &tables::SymbolRow<'_>| {
        let tables::SymbolRow { anchor, symbol, users } = row;
        let title = if symbol.latex == symbol.name {
            symbol.name.clone()
        } else {
            format!("{} {}", shown(&symbol.latex), symbol.name)
        };
        let body = format!("{} ({}). {}", symbol.meaning.replace('$', ""), symbol.unit, users.join(", "));
        let names = json!({ "kind": "symbol", "is": [symbol.name, symbol.latex] });
        [
            format!("{page}#{anchor}").into(),
            title.clone().into(),
            format!("Symbols » {title}").into(),
            body.into(),
            names,
        ]
    };
    tables::symbol_rows(content).iter().map(line).collect()
}

/// The LaTeX of a symbol in plain letters, as shown in results.
fn shown(latex: &str) -> String {
    let mut text = latex.to_owned();
    for (command, letter) in GREEK {
        text = text.replace(&format!("\\{command}"), letter);
    }
    for command in ["mathbf", "boldsymbol", "mathrm", "mathsf", "bar", "hat", "tilde", "text"] {
        text = text.replace(&format!("\\{command}"), "");
    }
    text.replace(['{', '}', '\\'], "").trim().to_owned()
}

const GREEK: [(&str, &str); 21] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("Delta", "Δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("varphi", "φ"),
    ("phi", "φ"),
    ("Phi", "Φ"),
    ("omega", "ω"),
];

/// An item for each output of scenes, at the first table that contains it.
fn outputs(content: &Content) -> Vec<[Value; 5]> {
    let mut all: BTreeMap<&str, (&str, Vec<&str>)> = BTreeMap::new();
    for served in &content.extras.served {
        let ids = &mut all.entry(&served.output).or_insert((&served.place, Vec::new())).1;
        if !ids.contains(&&*served.formula) {
            ids.push(&served.formula);
        }
    }
    let line = |(output, (place, ids)): (&str, (&str, Vec<&str>))| {
        let title = format!("{output}, an output of scenes");
        let names = json!({ "kind": "symbol", "is": [output] });
        [place.into(), title.clone().into(), format!("Scenes » {title}").into(), ids.join(", ").into(), names]
    };
    all.into_iter().map(line).collect()
}

/// Text with single spaces.
fn plain(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_index_of_mdbook_is_read() {
        let text = format!("{BEFORE}{{\"a\":\"it\\'s \\\\\"b\\\\\"\"}}{AFTER}");
        assert_eq!(read(&text).unwrap()["a"], "it's \"b\"");
        assert_eq!(shown(r"\mathbf{e}_{1a}"), "e_1a");
    }
}
