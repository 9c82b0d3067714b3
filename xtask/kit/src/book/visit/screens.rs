//! Screenshots of the pages listed in `book/screens.txt`, to be viewed by people.

use std::fs;
use std::path::Path;

use anyhow::{Context as _, Result};

use crate::book::browser::{self, Browser, DESK, PHONE, Screen};
use crate::book::output::write;
use crate::project::Project;

const LIST: &str = "book/screens.txt";

/// The settings in which each page is shown.
const WAYS: [(&str, Screen, bool); 4] = [
    ("desk-light", DESK, false),
    ("desk-dark", DESK, true),
    ("phone-light", PHONE, false),
    ("phone-dark", PHONE, true),
];

/// Writes a PNG for each page of the list and each setting; returns how many, or `None` if there is no browser.
///
/// # Errors
/// If a page or a picture fails.
pub(crate) fn take(project: &Project, out: &Path, folder: &Path) -> Result<Option<usize>> {
    if !browser::is_here_or_not_required()? {
        return Ok(None);
    }
    let list = fs::read_to_string(project.root().join(LIST))
        .with_context(|| format!("{LIST} names the pages, and cannot be read"))?;
    let out = out.canonicalize()?;
    let mut browser = Browser::start()?;
    let mut count = 0;
    let pages = list.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    for (number, page) in (1..).zip(pages) {
        // A page, its anchor, and the script to run before the screenshot.
        let (page, script) = page.split_once(" ! ").unwrap_or((page, ""));
        for (way, screen, dark) in WAYS {
            browser.screen(screen)?;
            browser.prefer(dark, true)?;
            browser.open(&out.join(page))?;
            browser.evaluate(&format!("(async () => {{ await document.fonts.ready; {script}; await new Promise((done) => setTimeout(done, 150)); }})()"))?;
            let name = page.replace(['#', '/'], "-").replace(".html", "");
            write(&folder.join(format!("{number:02}-{name}.{way}.png")), &browser.screenshot()?)?;
            count += 1;
        }
    }
    Ok(Some(count))
}
