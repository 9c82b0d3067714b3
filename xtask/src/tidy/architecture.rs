//! The folders of the library in their order, as `ARCHITECTURE.md` lists them, and whether that page is true.

use super::finding::Finding;
use super::tree::Tree;
use pulldown_cmark::{Event, Parser, Tag};
use std::collections::BTreeSet;
use std::path::Path;

/// The page, from the root of the project.
pub(super) const PAGE: &str = "ARCHITECTURE.md";

/// The pages whose links are followed.
const PAGES: [&str; 4] = [PAGE, "CONTRIBUTING.md", "README.md", "SECURITY.md"];

/// The folders of `src`, from the lowest to the highest: the first column of the table below the heading about `src`.
pub(super) struct Order(Vec<String>);

impl Order {
    pub(super) fn read(root: &Path) -> anyhow::Result<Self> {
        let page = root.join(PAGE);
        let text = std::fs::read_to_string(&page).map_err(|error| anyhow::anyhow!("{}: {error}", page.display()))?;
        let table = text.lines().skip_while(|line| !(line.starts_with('#') && line.contains("`src`")));
        let rows = table.skip(1).take_while(|line| !line.starts_with('#'));
        let name = |row: &str| Some(row.strip_prefix("| `")?.split_once('`')?.0.to_owned());
        Ok(Self(rows.filter_map(name).collect()))
    }

    /// The place of a folder in the order.
    pub(super) fn place(&self, folder: &str) -> Option<usize> {
        self.0.iter().position(|name| name == folder)
    }
}

/// What the page leaves out or invents, and links of any page that lead nowhere.
pub(super) fn untrue(root: &Path, tree: &Tree, order: &Order) -> Vec<Finding> {
    let mut findings = Vec::new();
    let text = |page: &str| std::fs::read_to_string(root.join(page)).unwrap_or_default();
    let architecture = text(PAGE);
    let entries = std::fs::read_dir(root.join("src")).into_iter().flatten().flatten().map(|entry| entry.path());
    let rust = entries.filter(|path| path.is_dir() || path.extension().is_some_and(|extension| extension == "rs"));
    let names = rust.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()));
    let folders: BTreeSet<_> = names.filter(|name| name != "lib").collect();
    for name in &folders {
        if order.place(name).is_none() {
            findings.push(Finding::new(
                PAGE,
                0,
                format!("the table of folders has no row for `{name}` of src; add one at its place"),
            ));
        }
    }
    for name in order.0.iter().filter(|name| !folders.contains(*name)) {
        findings.push(Finding::new(
            PAGE,
            0,
            format!("the table of folders has a row for `{name}`, which is not in src"),
        ));
    }
    for member in &tree.members {
        let name = member.rsplit('/').next().unwrap_or(member);
        if !architecture.contains(&format!("`{name}`")) {
            findings.push(Finding::new(PAGE, 0, format!("the crate `{member}` is not named; say what it is for")));
        }
    }
    for page in PAGES {
        let text = text(page);
        for (event, at) in Parser::new(&text).into_offset_iter() {
            let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event else { continue };
            let path = dest_url.split('#').next().unwrap_or_default();
            if !path.is_empty() && !path.contains(':') && !root.join(path).exists() {
                let line = 1 + text[..at.start].matches('\n').count();
                findings.push(Finding::new(page, line, format!("the link leads to {path}, which is not there")));
            }
        }
    }
    findings
}

/// The folder or file directly below `src` to which a source belongs.
pub(super) fn folder(path: &str) -> Option<&str> {
    path.strip_prefix("src/")?.split(['/', '.']).next()
}
