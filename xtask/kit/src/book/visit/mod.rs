//! The built book in a browser: accessibility, widths, sizes, search, keyboard; and screenshots of pages.

mod queries;
mod screens;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use anyhow::{Context as _, Result};
use serde_json::Value;

pub(crate) use screens::take;

use super::browser::{self, Browser, DESK, PHONE};
use super::calculator::chapters;
use crate::console::{self, count};
use crate::project::Project;
use queries::Answers;

/// The script executed in a page.
const VISIT: &str = include_str!("visit.js");

/// If this variable gives the path of `axe.min.js`, every page is checked for accessibility.
const AXE: &str = "JOINTPROOF_AXE";

/// The target for the compressed bytes loaded by the first view of a chapter.
const WANTED: u64 = 400_000;

/// Listings are alike: only the longest is checked.
const LISTINGS: &str = "source";

/// The result of the checks.
#[derive(Default)]
pub(crate) struct Visited {
    pages: usize,
    /// Pages checked for accessibility, in light and in dark colours.
    searched: usize,
    controls: usize,
    answers: Option<Answers>,
    /// Compressed bytes of the first view of each chapter.
    weights: BTreeSet<(u64, String)>,
    /// The faults, with the pages where they occur.
    off: BTreeMap<String, Vec<String>>,
}

impl Visited {
    pub(crate) fn is_well(&self) -> bool {
        self.pages > 0 && self.off.is_empty() && self.answers.as_ref().is_none_or(Answers::are_enough)
    }

    fn note(&mut self, page: &str, found: impl IntoIterator<Item = String>) {
        for found in found {
            self.off.entry(found).or_default().push(page.to_owned());
        }
    }

    /// Records pages that load too much as faults.
    fn note_heavy(&mut self) {
        let heavy: Vec<_> = self.weights.iter().filter(|(weight, _)| *weight > WANTED).cloned().collect();
        for (weight, page) in heavy {
            self.note(&page, [format!("the first view loads {weight} bytes, wanted are {WANTED}")]);
        }
    }

    /// Merges the results of other pages.
    fn and(mut self, other: Self) -> Self {
        self.pages += other.pages;
        self.searched += other.searched;
        self.controls += other.controls;
        self.weights.extend(other.weights);
        for (found, pages) in other.off {
            self.off.entry(found).or_default().extend(pages);
        }
        self
    }
}

impl fmt::Display for Visited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on a phone and on a desk; ", count(self.pages, "page"))?;
        match self.searched {
            0 => write!(f, "not searched for barriers, since {AXE} is not set; ")?,
            searched => write!(f, "{searched} searched for barriers, in light and dark colours; ")?,
        }
        write!(f, "{} reached by keyboard", count(self.controls, "control"))?;
        if let Some((weight, page)) = self.weights.last() {
            let middle = self.weights.iter().nth(self.weights.len() / 2).map_or(0, |(weight, _)| *weight);
            write!(f, "\n    first view, compressed: {middle} bytes in the middle of all, at most {weight} ({page})")?;
        }
        if let Some(answers) = &self.answers {
            write!(f, "\n    {answers}")?;
        }
        self.off.iter().try_for_each(|(found, pages)| {
            write!(f, "\n    {found} ({}, first {})", count(pages.len(), "page"), pages[0])
        })
    }
}

/// Checks every page of the book in this folder; `None` if there is no browser and none is required.
///
/// # Errors
/// If the browser or a page fails.
pub(crate) fn check(project: &Project, out: &Path) -> Result<Option<Visited>> {
    if !browser::is_here_or_not_required()? {
        return Ok(None);
    }
    let axe = std::env::var_os(AXE)
        .map(|path| fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display())));
    visit(project, out, &mut browsers()?, axe.transpose()?.as_deref()).map(Some)
}

fn browsers() -> Result<[Browser; BROWSERS]> {
    Ok([Browser::start()?, Browser::start()?])
}

/// Checks every page, with several browsers in parallel, and for accessibility if there is a script for it.
fn visit(project: &Project, out: &Path, browsers: &mut [Browser; BROWSERS], axe: Option<&str>) -> Result<Visited> {
    let out = out.canonicalize()?;
    let mut pages = chapters(&out)?;
    // It is served in place of a missing page, so its links start at the root of a server.
    pages.retain(|page| !page.ends_with("404.html"));
    pages.extend(["index.html", "print.html"].map(|name| out.join(name)));
    pages.extend(longest(&out.join(LISTINGS))?);
    // The largest first, so that all browsers finish at about the same time.
    pages.sort_by_key(|page| std::cmp::Reverse(page.metadata().map_or(0, |metadata| metadata.len())));
    let bar = console::progress("pages", pages.len());
    let next = AtomicUsize::new(0);
    let browse = |browser| -> Result<Visited> {
        let (visited, sizes) = (Visited::default(), BTreeMap::new());
        let mut visit = Visit { browser, out: &out, axe, visited, sizes };
        while let Some(page) = pages.get(next.fetch_add(1, Ordering::Relaxed)) {
            visit.page(page).with_context(|| format!("{} cannot be looked at", project.shown(page)))?;
            bar.inc(1);
        }
        Ok(visit.visited)
    };
    let mut visited = std::thread::scope(|scope| {
        let browse = &browse;
        let visits = browsers.each_mut().map(|browser| scope.spawn(move || browse(browser)));
        visits.into_iter().try_fold(Visited::default(), |visited, visit| match visit.join() {
            Ok(found) => Ok::<_, anyhow::Error>(visited.and(found?)),
            Err(panic) => std::panic::resume_unwind(panic),
        })
    })?;
    bar.finish_and_clear();
    let [browser, _] = browsers;
    if let Some(page) = with_controls(&pages)? {
        keyboard(browser, &page, &mut visited)?;
    }
    visited.answers = queries::ask(project, &out, browser, VISIT)?;
    visited.note("index.html", browser.errors.drain(..));
    visited.note_heavy();
    Ok(visited)
}

/// The number of browsers that check pages in parallel.
const BROWSERS: usize = 2;

/// The smallest chapter with sliders and calculators, which contains every kind of control.
fn with_controls(pages: &[PathBuf]) -> Result<Option<PathBuf>> {
    // They are sorted, the largest first; the first page repeats a chapter.
    for page in pages.iter().rev().filter(|page| !page.ends_with("index.html")) {
        let text = fs::read_to_string(page)?;
        if text.contains("class=\"calculator\"") && text.contains("class=\"sliders\"") {
            return Ok(Some(page.clone()));
        }
    }
    Ok(None)
}

/// The longest file in a folder and below it.
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

/// A visit in progress.
struct Visit<'a> {
    browser: &'a mut Browser,
    out: &'a Path,
    axe: Option<&'a str>,
    visited: Visited,
    /// Compressed sizes of the files loaded so far.
    sizes: BTreeMap<PathBuf, u64>,
}

/// The files loaded by a page.
#[derive(serde::Deserialize)]
struct Loaded {
    files: Vec<String>,
    /// Family, style and character range.
    fonts: Vec<[String; 3]>,
}

impl Visit<'_> {
    /// Checks one page: on a phone in light colours, on paper, then on a desktop in both.
    fn page(&mut self, page: &Path) -> Result<()> {
        let name = page.strip_prefix(self.out).unwrap_or(page).display().to_string();
        self.visited.pages += 1;
        self.browser.screen(PHONE)?;
        self.browser.prefer(false, false)?;
        open(self.browser, page)?;
        let weight = self.weight(page)?;
        if !page.ends_with("print.html") {
            self.visited.weights.insert((weight, name.clone()));
        }
        self.letters(&name)?;
        self.note(&name, "", "wider()")?;
        // It repeats all chapters, whose folded parts and colours are checked individually.
        let repeats = page.ends_with("print.html");
        if !repeats {
            self.browser.evaluate("unfold()")?;
            self.note(&name, "unfolded, ", "wider()")?;
            self.note(&name, "on a phone, ", "unmarked()")?;
            self.browser.print()?;
            self.note(&name, "on paper, ", "cut()")?;
            self.browser.screen(DESK)?;
            self.browser.prefer(false, false)?;
            for fault in ["cut()", "illegible()", "repeated()", "joined()"] {
                self.note(&name, "", fault)?;
            }
        }
        let Some(axe) = self.axe else { return Ok(()) };
        self.visited.searched += 1;
        self.browser.screen(DESK)?;
        self.browser.evaluate(axe)?;
        if repeats {
            return self.note(&name, "", "barriers({ rules: { 'color-contrast': { enabled: false } } })");
        }
        self.note(&name, "", "barriers()")?;
        self.browser.prefer(true, true)?;
        open(self.browser, page)?;
        self.browser.evaluate("unfold()")?;
        self.browser.evaluate(axe)?;
        self.note(&name, "in dark colours, ", "barriers({ runOnly: ['color-contrast'] })")?;
        self.note(&name, "with less motion wanted, ", "moving()")
    }

    /// Checks that the mathematical font contains all characters of formulas.
    fn letters(&mut self, name: &str) -> Result<()> {
        let css = fs::read_to_string(self.out.join("fonts/fonts.css")).unwrap_or_default();
        let is_it = |face: &&str| declared(face, "font-family").is_some_and(|family| family == MATHEMATICAL);
        let face = css.split("@font-face").find(is_it).unwrap_or_default();
        let Some(range) = declared(face, "unicode-range") else { return Ok(()) };
        let used: Vec<char> = serde_json::from_value(self.browser.evaluate("characters()")?)?;
        let lost = used.into_iter().filter(|c| !c.is_whitespace() && !is_within(*c, &range));
        let lost = lost.map(|c| format!("{MATHEMATICAL} has no `{c}`, U+{:X}", u32::from(c)));
        self.visited.note(name, lost);
        Ok(())
    }

    /// Records everything that an expression finds as faults.
    fn note(&mut self, name: &str, when: &str, expression: &str) -> Result<()> {
        let found: Vec<String> = serde_json::from_value(self.browser.evaluate(expression)?)?;
        self.visited.note(name, found.into_iter().map(|found| format!("{when}{found}")));
        self.visited.note(name, self.browser.errors.drain(..));
        Ok(())
    }

    /// Compressed bytes of a page and of everything it loads.
    fn weight(&mut self, page: &Path) -> Result<u64> {
        let loaded: Loaded = serde_json::from_value(self.browser.evaluate("loaded()")?)?;
        let path = |url: &String| url.strip_prefix("file://").map(PathBuf::from);
        let mut files: Vec<PathBuf> = loaded.files.iter().filter_map(path).collect();
        files.extend(fonts(&self.out.join("fonts"), &loaded.fonts)?);
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

    /// The size of a file; text is compressed, fonts are compressed already.
    fn size(&mut self, file: &Path) -> Result<u64> {
        let bytes =
            fs::read(file).with_context(|| format!("the page loads {}, which cannot be read", file.display()))?;
        let size = match String::from_utf8(bytes) {
            Ok(text) => {
                self.browser.evaluate(&format!("compressed({})", Value::from(text)))?.as_u64().context("no size")?
            }
            Err(error) => error.as_bytes().len() as u64,
        };
        self.sizes.insert(file.to_path_buf(), size);
        Ok(size)
    }
}

fn open(browser: &mut Browser, page: &Path) -> Result<()> {
    browser.open(page)?;
    browser.evaluate(VISIT).map(drop)
}

/// The font files that `fonts.css` assigns to these families, styles and ranges.
fn fonts(folder: &Path, loaded: &[[String; 3]]) -> Result<Vec<PathBuf>> {
    let css = fs::read_to_string(folder.join("fonts.css")).unwrap_or_default();
    let faces: Vec<&str> = css.split("@font-face").collect();
    let mut files = Vec::new();
    for [family, style, range] in loaded {
        let is_it = |face: &&&str| {
            declared(face, "font-family").is_some_and(|known| known == *family)
                && declared(face, "font-style").as_deref().unwrap_or("normal") == style
                && declared(face, "unicode-range").is_some() == (range != ANY)
        };
        let face = faces.iter().find(is_it).with_context(|| format!("fonts.css has no {family}, {style}, {range}"))?;
        let url = face.split_once("url(").and_then(|(_, rest)| rest.split_once(')'));
        files.push(folder.join(url.context("a font without address")?.0.replace('"', "")));
    }
    Ok(files)
}

/// A declaration in a font face of `fonts.css`.
fn declared(face: &str, key: &str) -> Option<String> {
    let rest = face.split_once(&format!("{key}:"))?.1;
    Some(rest.split(';').next()?.trim().replace('"', ""))
}

/// Whether a character is in a range in CSS notation: `U+20-7E, U+131`.
fn is_within(c: char, range: &str) -> bool {
    let number = |text: &str| u32::from_str_radix(text, 16).ok();
    range.split(',').filter_map(|part| part.trim().strip_prefix("U+")).any(|part| {
        let (from, to) = part.split_once('-').unwrap_or((part, part));
        number(from).zip(number(to)).is_some_and(|(from, to)| (from..=to).contains(&u32::from(c)))
    })
}

/// The font in which formulas are set.
const MATHEMATICAL: &str = "STIX Two Math";

/// Every character.
const ANY: &str = "U+0-10FFFF";

/// Steps through a page with the tab key: every control must be reached, and have a visible focus.
fn keyboard(browser: &mut Browser, page: &Path, visited: &mut Visited) -> Result<()> {
    let name = page.file_name().unwrap_or_default().to_string_lossy().into_owned();
    browser.screen(DESK)?;
    browser.prefer(false, false)?;
    open(browser, page)?;
    let controls = browser.evaluate("controls().length")?.as_u64().context("no number of controls")?;
    for _ in 0..controls + 20 {
        browser.press_tab()?;
        let fault = browser.evaluate("focused()")?;
        visited.note(&name, fault.as_str().filter(|fault| !fault.is_empty()).map(String::from));
    }
    let unreached: Vec<String> = serde_json::from_value(browser.evaluate("unreached()")?)?;
    visited.controls = usize::try_from(controls)?.saturating_sub(unreached.len());
    visited.note(&name, unreached);
    Ok(())
}
