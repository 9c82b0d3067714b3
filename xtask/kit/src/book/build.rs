//! Builds a book: mdBook as a library, entries from the catalog, mathematics set at build time.
//!
//! [`build`] needs no network and no other program. It writes into a temporary folder and renames it when all is well,
//! so that an interrupted or faulty build leaves the last good book in place.

use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail};
use mdbook_driver::MDBook;
use mdbook_driver::builtin_preprocessors::LinkPreprocessor;
use mdbook_driver::config::Config;

use super::calculator;
use super::content::Content;
use super::deferred::Deferred;
use super::fault::Faults;
use super::output::write;
use super::preprocessor::Formulary;
use super::theme::{SHEETS, Theme};
use super::{downloads, links, mend, moving, permalinks, search, source, speed};
use crate::report::spread;

/// The age up to which the partial folder of another run is left alone, in case that run is still going.
const STALE: Duration = Duration::from_mins(10);

/// The destination of the book.
#[derive(Debug, Clone, Default)]
pub(crate) struct Options {
    /// The folder of the finished book; `target/book` under the root if `None`.
    pub(crate) out: Option<PathBuf>,
}

/// A summary of the build.
#[derive(Debug, Clone)]
pub(crate) struct Summary {
    /// The first page.
    pub(crate) index: PathBuf,
    /// Chapters, generated ones included.
    pub(crate) chapters: usize,
    /// Formulas with an entry.
    pub(crate) formulas: usize,
    /// Source files with a listing page.
    pub(crate) listings: usize,
    /// The duration.
    pub(crate) elapsed: Duration,
}

/// Builds the book of the repository at `root`, whose chapters are in `book/`.
///
/// # Errors
/// [`Faults`] (by `downcast_ref`) if something in the book is wrong, with all its faults at once; otherwise an error
/// of the file system or of mdBook. The previous book is kept in either case.
pub(crate) fn build(root: &Path, options: &Options, content: Content) -> Result<Summary> {
    let start = Instant::now();
    let out = options.out.clone().unwrap_or_else(|| root.join("target/book"));
    let partial = Partial::beside(&out)?;
    let content = Rc::new(content);
    let later = Rc::new(Deferred::default());
    let book = root.join("book");
    let theme = Theme::of(&book)?;
    let (title, chapters) = render(&book, theme.folder(), &partial.0, &content, &later)?;
    finish(root, theme.folder(), &partial.0, &title, &content, &later)?;
    partial.replace(&out)?;
    Ok(Summary {
        index: out.join("index.html"),
        chapters,
        formulas: content.entries.len(),
        listings: content.sources.len(),
        elapsed: start.elapsed(),
    })
}

/// Runs mdBook; returns the title of the book and the number of its chapters.
fn render(
    book: &Path,
    theme: &Path,
    out: &Path,
    content: &Rc<Content>,
    later: &Rc<Deferred>,
) -> Result<(String, usize)> {
    let mut config = Config::from_disk(book.join("book.toml"))?;
    // A workflow says where it publishes: MDBOOK_OUTPUT__HTML__SITE_URL.
    config.update_from_env()?;
    config.build.build_dir = out.to_path_buf();
    config.build.create_missing = false;
    config.build.use_default_preprocessors = false;
    // Listing pages and fonts refer to the style sheets by their plain names.
    config.set("output.html.hash-files", false)?;
    config.set("output.html.theme", theme)?;
    let title = config.book.title.clone().unwrap_or_default();
    let mut book_on_disk = MDBook::load_with_config(book, config)?;
    let (content, later) = (Rc::clone(content), Rc::clone(later));
    book_on_disk.with_preprocessor(Formulary { content, later, figures: book.join("figures") });
    book_on_disk.with_preprocessor(LinkPreprocessor::new());
    book_on_disk.build()?;
    Ok((title, book_on_disk.book.chapters().count()))
}

/// Inserts the deferred HTML, adds listings and golden files, and checks every link.
fn finish(root: &Path, theme: &Path, out: &Path, title: &str, content: &Content, later: &Deferred) -> Result<()> {
    fill(out, "", later)?;
    for sheet in SHEETS {
        write(&out.join("theme").join(sheet), &fs::read(theme.join(sheet))?)?;
    }
    for source in &content.sources {
        write(&out.join(source::listing_page(&source.path)), source::listing(source, title).as_bytes())?;
    }
    for golden in &content.golden {
        write(&out.join("golden").join(&golden.name), &golden.bytes)?;
    }
    for download in &content.downloads {
        write(&out.join(downloads::FOLDER).join(&download.name), download.text.as_bytes())?;
    }
    if let Some(report) = &content.report {
        write(&out.join(downloads::FOLDER).join(speed::CSV), spread::csv(report).as_bytes())?;
    }
    for (path, text) in calculator::files(&content.entries) {
        write(&out.join(path), text.as_bytes())?;
    }
    for (path, text) in moving::files(&content.extras.moving) {
        write(&out.join(path), text.as_bytes())?;
    }
    search::replace(out, content)?;
    let mut faults = Faults::default();
    permalinks::write_all(root, out, &later.places.borrow(), &mut faults)?;
    links::check(out, &mut faults)?;
    Ok(faults.into_result()?)
}

/// Fills the placeholders of every page in a folder and below, and adds the theme's style sheets after those of mdBook, which
/// copies only sheets from the book's own folder. `to_root` is the path from the folder to the root of the book.
fn fill(folder: &Path, to_root: &str, later: &Deferred) -> Result<()> {
    let link = |sheet| format!("<link rel=\"stylesheet\" href=\"{to_root}theme/{sheet}\">\n");
    let head_end = SHEETS.map(link).concat() + "</head>";
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            fill(&path, &format!("{to_root}../"), later)?;
        } else if path.extension().is_some_and(|extension| extension == "html") {
            let page = fs::read_to_string(&path)?;
            let page = mend::mended(&search::in_page(&later.fill(&page)));
            let head_end = calculator::head(&page, to_root) + &moving::head(&page, to_root) + &head_end;
            write(&path, page.replace("</head>", &head_end).as_bytes())?;
        }
    }
    Ok(())
}

/// The folder in which a book is built; removed when dropped.
struct Partial(PathBuf);

impl Partial {
    /// An empty folder next to `out`, named after this process; old leftovers of interrupted runs are removed.
    fn beside(out: &Path) -> Result<Self> {
        let name = out.file_name().with_context(|| format!("{} cannot hold a book", out.display()))?;
        check_folder(out)?;
        let prefix = format!("{}.partial-", name.to_string_lossy());
        let parent = out.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(parent)?;
        for entry in fs::read_dir(parent)?.flatten() {
            let old =
                entry.metadata().and_then(|m| m.modified()).is_ok_and(|t| t.elapsed().is_ok_and(|age| age > STALE));
            if old && entry.file_name().to_string_lossy().starts_with(&prefix) {
                fs::remove_dir_all(entry.path())?;
            }
        }
        let folder = std::path::absolute(parent)?.join(format!("{prefix}{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        Ok(Self(folder))
    }

    /// Replaces the old folder by the finished one.
    fn replace(self, out: &Path) -> Result<()> {
        let mut old = self.0.clone().into_os_string();
        old.push(".old");
        let old = PathBuf::from(old);
        if out.exists() {
            fs::rename(out, &old).with_context(|| format!("cannot move {}", out.display()))?;
        }
        if let Err(error) = fs::rename(&self.0, out) {
            let _ = fs::rename(&old, out);
            return Err(error).with_context(|| format!("cannot write {}", out.display()));
        }
        if old.exists() {
            fs::remove_dir_all(&old)?;
        }
        Ok(())
    }
}

/// Rejects a folder in which something would be lost.
pub(crate) fn check_folder(out: &Path) -> Result<()> {
    if !may_hold_a_book(out) {
        bail!("{} holds something else than a book; give a new or an empty folder", out.display());
    }
    Ok(())
}

/// Whether putting a book there overwrites nothing but an older book.
fn may_hold_a_book(out: &Path) -> bool {
    match fs::read_dir(out) {
        Ok(mut entries) => entries.next().is_none() || (out.join(".nojekyll").exists() && out.join("toc.js").exists()),
        Err(_) => !out.exists(),
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_book_goes_where_nothing_or_a_book_was() {
        let folder = tempfile::tempdir().unwrap();
        let holding = |name: &str, files: &[&str]| {
            let path = folder.path().join(name);
            fs::create_dir(&path).unwrap();
            for file in files {
                fs::write(path.join(file), "").unwrap();
            }
            check_folder(&path).map_err(|error| error.to_string().replace(&path.display().to_string(), "it"))
        };
        assert_eq!(holding("empty", &[]), Ok(()));
        assert_eq!(holding("book", &[".nojekyll", "toc.js", "a.html"]), Ok(()));
        for (name, files) in [("letters", ["a.txt"]), ("site", [".nojekyll"]), ("scripts", ["toc.js"])] {
            let refused = "it holds something else than a book; give a new or an empty folder";
            assert_eq!(holding(name, &files), Err(refused.to_owned()), "{name}");
        }
        assert!(check_folder(&folder.path().join("new")).is_ok());
        assert!(check_folder(&folder.path().join("letters/a.txt")).is_err());
    }
}
