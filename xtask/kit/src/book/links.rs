//! Checks every link inside the finished book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use anyhow::Result;

use super::fault::Faults;

/// One page: its anchors and its links.
#[derive(Default)]
struct Page {
    /// All `id`s.
    anchors: BTreeSet<String>,
    /// All `href`s within the book.
    links: BTreeSet<String>,
}

/// Records each local link to a missing file, or to a missing anchor of a page.
///
/// # Errors
/// If a page cannot be read.
pub(crate) fn check(root: &Path, faults: &mut Faults) -> Result<()> {
    let mut pages = BTreeMap::new();
    for path in html_files(root)? {
        let text = std::fs::read_to_string(&path)?;
        pages.insert(path, Page { anchors: values(&text, "id"), links: values(&text, "href") });
    }
    for (path, page) in &pages {
        for link in page.links.iter().filter(|link| is_local(link)) {
            if let Some(reason) = dead(root, path, link, &pages) {
                let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy();
                faults.push(&name, 0, format!("the link `{link}` {reason}"));
            }
        }
    }
    Ok(())
}

/// Why a link is dead.
fn dead(root: &Path, from: &Path, link: &str, pages: &BTreeMap<PathBuf, Page>) -> Option<String> {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = if file.is_empty() { from.to_path_buf() } else { normal(&from.parent().unwrap_or(root).join(file)) };
    if !target.starts_with(root) || !target.is_file() {
        return Some("names no file of the book".to_owned());
    }
    let page = pages.get(&target)?;
    (!anchor.is_empty() && !page.anchors.contains(anchor)).then(|| "names an anchor its page does not have".to_owned())
}

/// The path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        if part.as_os_str() == ".." {
            out.pop();
        } else {
            out.push(part);
        }
    }
    out
}

/// Whether a link stays within the book.
fn is_local(link: &str) -> bool {
    let before_slash = link.split(['/', '#', '?']).next().unwrap_or("");
    !before_slash.contains(':') && !link.starts_with("//") && link != "#"
}

/// The values of an attribute in tags; scripts contain no `<a` or `id=` of ours.
fn values(text: &str, attribute: &str) -> BTreeSet<String> {
    let pattern = format!(" {attribute}=\"");
    let value = |(at, _): (usize, &str)| text[at + pattern.len()..].split('"').next().map(|v| v.replace("&amp;", "&"));
    text.match_indices(&pattern).filter_map(value).collect()
}

/// All pages except the two whose links mdBook rewrites for another location.
fn html_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(html_files(&path)?);
        } else if path.extension().is_some_and(|e| e == "html")
            && !path.ends_with("print.html")
            && !path.ends_with("404.html")
        {
            files.push(path);
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dead_links_are_named_and_live_ones_are_not() {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("book");
        std::fs::create_dir_all(folder.join("s")).unwrap();
        let good =
            "<h1 id=\"top\"></h1> <a href=\"s/b.html#L1\"></a> <a href=\"#top\"></a> <a href=\"https://x.y/#z\"></a>";
        std::fs::write(folder.join("a.html"), format!("{good} <a href=\"c.html\"></a> <a href=\"#no\"></a>")).unwrap();
        let listing = "<b id=\"L1\"></b> <a href=\"../a.html#top\"></a> <a href=\"../../letter.txt\"></a> <a href=\"../c.css#x\"></a>";
        std::fs::write(folder.join("s/b.html"), listing).unwrap();
        std::fs::write(folder.join("c.css"), "").unwrap();
        // Pages that mdBook writes for another location, and a file that is no page.
        for name in ["print.html", "404.html", "d.txt"] {
            std::fs::write(folder.join(name), "<a href=\"gone.html\"></a>").unwrap();
        }
        // A file outside does not belong to the book, though it exists.
        std::fs::write(outer.path().join("letter.txt"), "").unwrap();
        let mut faults = Faults::default();
        check(&folder, &mut faults).unwrap();
        let text: Vec<String> = faults.0.iter().map(ToString::to_string).collect();
        assert_eq!(
            text,
            [
                "a.html: the link `#no` names an anchor its page does not have",
                "a.html: the link `c.html` names no file of the book",
                "s/b.html: the link `../../letter.txt` names no file of the book"
            ]
        );
    }

    #[test]
    fn what_names_a_scheme_or_a_host_leads_out_of_the_book() {
        for link in ["a.html", "a/b:c.html", "a.html?x:y", "#x:y", "a.html#"] {
            assert!(is_local(link), "{link}");
        }
        for link in ["https://x.y/z", "mailto:x@y.z", "//x.y/z", "#"] {
            assert!(!is_local(link), "{link}");
        }
    }
}
