//! Links to formulas and elements in other languages.

use super::html::{each, escape, relative, row, table};
use super::pages::{Pages, Place};
use crate::export::Download;

/// The folder of the files in other languages.
pub(crate) const FOLDER: &str = "downloads";

/// Links to the files of a formula or an element.
pub(crate) fn of(pages: &Pages<'_>, at: &Place, id: &str, is_element: bool) -> String {
    let own = |download: &&Download| download.is_element == is_element && download.id == id;
    let link = |download: &Download| {
        let path = relative(&at.page, &format!("{FOLDER}/{}", download.name));
        format!("<a href=\"{}\" download>{}</a>", escape(&path), escape(&download.label))
    };
    pages.content.downloads.iter().filter(own).map(link).collect::<Vec<_>>().join(", ")
}

/// `{{#downloads}}`: the files of every element.
pub(crate) fn table_of_elements(pages: &Pages<'_>, at: &Place) -> String {
    let mut ids: Vec<&str> = Vec::new();
    for file in pages.content.downloads.iter().filter(|file| file.is_element) {
        if !ids.contains(&file.id) {
            ids.push(file.id);
        }
    }
    let rows = each(ids, |id| row(&[("", format!("<code>{}</code>", escape(id))), ("wide", of(pages, at, id, true))]));
    table("downloads", &["Element", "Files"], &rows)
}
