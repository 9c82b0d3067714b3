//! Permanent addresses: a page for each formula that redirects to its entry, wherever that is.
//!
//! The list `book/permalinks.txt` only grows. A renamed formula keeps its old line, with the new name appended.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::Result;

use super::fault::Faults;
use super::html::escape;
use super::output::write;

/// The list of all addresses ever published.
pub(crate) const LIST: &str = "book/permalinks.txt";

/// The list with these names added that it lacks.
pub(crate) fn with(list: &str, ids: impl IntoIterator<Item = String>) -> String {
    let is_listed = |id: &str| list.lines().any(|line| line.split(['-', '#']).next().unwrap_or_default().trim() == id);
    let missing = ids.into_iter().filter(|id| !is_listed(id)).map(|id| id + "\n");
    format!("{}\n{}", list.trim_end(), missing.collect::<String>())
}

/// The address of a formula, from the root of the book.
pub(crate) fn page(id: &str) -> String {
    format!("id/{id}.html")
}

/// Writes the pages for all entries and for all names in the list.
///
/// # Errors
/// If a page cannot be written.
pub(crate) fn write_all(root: &Path, out: &Path, places: &BTreeMap<String, String>, faults: &mut Faults) -> Result<()> {
    let list = fs::read_to_string(root.join(LIST)).ok();
    for (id, to) in resolved(list.as_deref(), places, faults) {
        let (id, to) = (escape(&id), escape(&format!("../{to}")));
        let text = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"UTF-8\">\n<title>{id}</title>\n<meta name=\"robots\" content=\"noindex\">\n\
             <meta http-equiv=\"refresh\" content=\"0; url={to}\">\n<link rel=\"canonical\" href=\"{to}\">\n\
             <p><a href=\"{to}\">{id}</a></p>\n</html>\n"
        );
        write(&out.join(page(&id)), text.as_bytes())?;
    }
    Ok(())
}

/// Every name with the location of its entry; a listed name without an entry is a fault, and so is an unlisted one.
fn resolved<'a>(
    list: Option<&str>,
    places: &'a BTreeMap<String, String>,
    faults: &mut Faults,
) -> Vec<(String, &'a str)> {
    let mut all: BTreeMap<String, &str> = places.iter().map(|(id, to)| (id.clone(), to.as_str())).collect();
    let Some(list) = list else { return all.into_iter().collect() };
    let mut listed = Vec::new();
    for (at, line) in list.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() {
            continue;
        }
        let (id, now) = line.split_once("->").map_or((line, line), |(old, new)| (old.trim(), new.trim()));
        listed.push(id);
        match places.get(now) {
            Some(to) => {
                all.insert(id.into(), to);
            }
            None => faults.push(
                LIST,
                at + 1,
                format!("`{now}` has no entry; a formula that was renamed is written `{id} -> new.name`"),
            ),
        }
    }
    for id in places.keys().filter(|id| !listed.contains(&id.as_str())) {
        faults.push(
            LIST,
            0,
            format!("`{id}` has an entry and is not listed; add a line with it, which stays for good"),
        );
    }
    all.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_names_lead_to_new_entries_and_lost_ones_are_faults() {
        let places = BTreeMap::from([
            ("a.new".to_owned(), "a.html#a.new".to_owned()),
            ("a.b".to_owned(), "a.html#a.b".to_owned()),
        ]);
        let mut faults = Faults::default();
        let all = resolved(Some("# names\na.new\na.old -> a.new\na.lost\n"), &places, &mut faults);
        let places: Vec<_> = all.iter().map(|(id, to)| format!("{id} {to}")).collect();
        assert_eq!(places, ["a.b a.html#a.b", "a.new a.html#a.new", "a.old a.html#a.new"]);
        let said: Vec<_> = faults.0.iter().map(ToString::to_string).collect();
        assert!(said[0].starts_with("book/permalinks.txt:4: `a.lost` has no entry"), "{said:?}");
        assert!(said[1].starts_with("book/permalinks.txt: `a.b` has an entry and is not listed"), "{said:?}");
    }
}
