//! The built book in a browser: barriers, widths, weights, search, keyboard; and pictures of pages.

mod queries;
mod screens;

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use serde_json::Value;

pub(crate) use screens::take;

use super::browser::{self, Browser, DESK, PHONE};
use super::calculator::chapters;
use crate::console::{self, count};
use crate::project::Project;
use queries::Answers;

/// What is done in a page.
const VISIT: &str = include_str!("visit.js");

/// Where this says where `axe.min.js` is, every page is searched for barriers.
const AXE: &str = "JOINTPROOF_AXE";

/// Compressed bytes that the first view of a chapter should load at most.
const WANTED: u64 = 400_000;

/// The page on which every control is reached by the keyboard.
const KEYBOARD: &str = "coulomb.html";

/// Listings are alike: the longest stands for all.
const LISTINGS: &str = "source";

/// What was found.
#[derive(Default)]
pub(crate) struct Visited {
    pages: usize,
    /// Pages searched for barriers, in light and in dark colours.
    searched: usize,
    controls: usize,
    answers: Option<Answers>,
    /// Compressed bytes of the first view of each chapter.
    weights: Vec<(u64, String)>,
    off: Vec<String>,
}

impl Visited {
    pub(crate) fn is_well(&self) -> bool {
        self.pages > 0 && self.off.is_empty() && self.answers.as_ref().is_none_or(Answers::are_enough)
    }
}

impl fmt::Display for Visited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on a phone, none wider than it; ", count(self.pages, "page"))?;
        match self.searched {
            0 => write!(f, "not searched for barriers, since {AXE} is not set; ")?,
            searched => write!(f, "{searched} searched for barriers in light and dark; ")?,
        }
        write!(f, "{} reached by keyboard", count(self.controls, "control"))?;
        if let Some((weight, page)) = self.weights.last() {
            let middle = self.weights[self.weights.len() / 2].0;
            write!(f, "\n    first view, compressed: {middle} bytes in the middle of all, at most {weight} ({page})")?;
        }
        if let Some(answers) = &self.answers {
            write!(f, "\n    {answers}")?;
        }
        self.off.iter().take(40).try_for_each(|off| write!(f, "\n    {off}"))?;
        let rest = self.off.len().saturating_sub(40);
        if rest > 0 { write!(f, "\n    and {rest} more") } else { Ok(()) }
    }
}

/// Looks at every page of the book in this folder; `None` where there is no browser, unless one is required.
///
/// # Errors
/// If the browser or a page fails.
pub(crate) fn check(project: &Project, out: &Path) -> Result<Option<Visited>> {
    if !browser::is_here_or_not_required()? {
        return Ok(None);
    }
    let out = out.canonicalize()?;
    let axe = std::env::var_os(AXE).map(|path| fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display())));
    let mut visit = Visit { browser: Browser::start()?, out: out.clone(), axe: axe.transpose()?, visited: Visited::default(), sizes: BTreeMap::new() };
    let mut pages = chapters(&out)?;
    pages.extend(["index.html", "print.html"].map(|name| out.join(name)));
    pages.extend(longest(&out.join(LISTINGS))?);
    let bar = console::progress("pages", pages.len());
    for page in &pages {
        visit.page(page).with_context(|| format!("{} cannot be looked at", project.shown(page)))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    if out.join(KEYBOARD).exists() {
        visit.keyboard(&out.join(KEYBOARD))?;
    }
    let Visit { mut browser, mut visited, .. } = visit;
    visited.answers = queries::ask(project, &out, &mut browser)?;
    visited.off.append(&mut browser.errors);
    visited.weights.sort();
    if let Some((weight, page)) = visited.weights.last().filter(|(weight, _)| *weight > WANTED) {
        visited.off.push(format!("{page}: the first view loads {weight} bytes, wanted are {WANTED}"));
    }
    Ok(Some(visited))
}

/// The longest file of a folder and below.
fn longest(folder: &Path) -> Result<Option<PathBuf>> {
    let mut found: Option<(u64, PathBuf)> = None;
    if folder.exists() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let path = if path.is_dir() { longest(&path)? } else { Some(path) };
            let sized = path.and_then(|path| Some((path.metadata().ok()?.len(), path)));
            found = found.max(sized);
        }
    }
    Ok(found.map(|(_, path)| path))
}

/// A visit under way.
struct Visit {
    browser: Browser,
    out: PathBuf,
    axe: Option<String>,
    visited: Visited,
    /// Compressed bytes of files that were met.
    sizes: BTreeMap<PathBuf, u64>,
}

impl Visit {
    /// One page: on a phone in light colours, then in dark ones.
    fn page(&mut self, page: &Path) -> Result<()> {
        let name = page.strip_prefix(&self.out).unwrap_or(page).display().to_string();
        self.visited.pages += 1;
        self.browser.screen(PHONE)?;
        self.browser.prefer(false, false)?;
        self.open(page)?;
        let weight = self.weight(page)?;
        if !page.ends_with("print.html") {
            self.visited.weights.push((weight, name.clone()));
        }
        self.note(&name, "", "wider()")?;
        self.browser.evaluate("unfold()")?;
        self.note(&name, "unfolded, ", "wider()")?;
        let Some(axe) = self.axe.clone() else { return Ok(()) };
        self.visited.searched += 1;
        self.browser.screen(DESK)?;
        self.browser.evaluate(&axe)?;
        self.note(&name, "", "barriers()")?;
        self.browser.prefer(true, true)?;
        self.open(page)?;
        self.browser.evaluate("unfold()")?;
        self.browser.evaluate(&axe)?;
        self.note(&name, "in dark colours, ", "barriers(['color-contrast'])")?;
        self.note(&name, "with less motion wanted, ", "moving()")
    }

    fn open(&mut self, page: &Path) -> Result<()> {
        self.browser.open(page)?;
        self.browser.evaluate(VISIT).map(drop)
    }

    /// What an expression finds is off.
    fn note(&mut self, name: &str, when: &str, expression: &str) -> Result<()> {
        let found: Vec<String> = serde_json::from_value(self.browser.evaluate(expression)?)?;
        let off = &mut self.visited.off;
        off.extend(found.into_iter().map(|found| format!("{name}: {when}{found}")));
        off.extend(self.browser.errors.drain(..).map(|error| format!("{name}: {error}")));
        Ok(())
    }

    /// Compressed bytes of a page and of all that it loads.
    fn weight(&mut self, page: &Path) -> Result<u64> {
        let loaded: Vec<String> = serde_json::from_value(self.browser.evaluate("loaded()")?)?;
        let mut files: Vec<PathBuf> = loaded.iter().filter_map(|url| url.strip_prefix("file://").map(PathBuf::from)).collect();
        files.push(page.to_path_buf());
        files.sort();
        files.dedup();
        let mut sum = 0;
        for file in files {
            sum += match self.sizes.get(&file) {
                Some(size) => *size,
                None => self.size(&file)?,
            };
        }
        Ok(sum)
    }

    /// Of a text, compressed; fonts and pictures are compressed already.
    fn size(&mut self, file: &Path) -> Result<u64> {
        let bytes = fs::read(file).with_context(|| format!("the page loads {}, which cannot be read", file.display()))?;
        let size = match String::from_utf8(bytes) {
            Ok(text) => self.browser.evaluate(&format!("compressed({})", Value::from(text)))?.as_u64().context("no size")?,
            Err(error) => error.as_bytes().len() as u64,
        };
        self.sizes.insert(file.to_path_buf(), size);
        Ok(size)
    }

    /// Goes through a page with the tabulator: every control is reached, and is marked when it is.
    fn keyboard(&mut self, page: &Path) -> Result<()> {
        self.browser.screen(DESK)?;
        self.browser.prefer(false, false)?;
        self.open(page)?;
        let controls = self.browser.evaluate("controls().length")?.as_u64().context("no number of controls")?;
        let mut off = Vec::new();
        for _ in 0..controls + 20 {
            self.browser.press("Tab")?;
            let fault = self.browser.evaluate("focused()")?;
            off.extend(fault.as_str().filter(|fault| !fault.is_empty()).map(String::from));
        }
        let unreached: Vec<String> = serde_json::from_value(self.browser.evaluate("unreached()")?)?;
        off.extend(unreached);
        off.dedup();
        self.visited.controls = usize::try_from(controls)?;
        self.visited.off.extend(off.into_iter().map(|fault| format!("{KEYBOARD}: {fault}")));
        Ok(())
    }
}
