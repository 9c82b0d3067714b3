//! A small book that is looked at in a browser, as it is and with planted faults.

use std::fs;
use std::path::PathBuf;

use jointproof::catalog::AnyFormula;
use jointproof::{coulomb, slot};
use tempfile::TempDir;

use super::{BROWSERS, Visited, browsers, visit};
use crate::book::browser::{self, Browser};
use crate::book::build::{Options, build};
use crate::book::gather::content;
use crate::book::output::write;
use crate::extension::{Moving, Slider};
use crate::project::Project;

static FORMULAS: &[&dyn AnyFormula] = &[&slot::ContactForce, &coulomb::Yield];

const CHAPTER: &str = "# One\n\n{{#figure moved It moves.}}\n\n{{#formula slot.contact_force}}\n\n{{#formula coulomb.yield}}\n\n{{#symbols}}\n";

const QUERIES: &str = "contact force => coulomb.html#slot.contact_force\n\\Phi => coulomb.html#coulomb.yield\nF_C => coulomb.html#slot.contact_force\n\
    μ => coulomb.html#symbol-mu\nmu => coulomb.html#symbol-mu\n";

struct Book {
    folder: TempDir,
    project: Project,
}

impl Book {
    /// None where there is no browser, unless one is required.
    fn new(chapter: &str, queries: &str) -> Option<Self> {
        if !browser::is_here_or_not_required().unwrap() {
            eprintln!("skipped: chromium is not here");
            return None;
        }
        let folder = tempfile::tempdir().unwrap();
        let file = |path: &str, text: &str| write(&folder.path().join(path), text.as_bytes()).unwrap();
        file("book/book.toml", "[book]\ntitle = \"T\"\nauthors = [\"A\"]\n");
        file("book/src/SUMMARY.md", "# Summary\n\n- [One](coulomb.md)\n");
        file("book/src/coulomb.md", chapter);
        file("book/queries.txt", queries);
        let root = folder.path().to_str().unwrap().to_owned().leak();
        let project = Project::new("small", root, FORMULAS);
        let mut content = content(&project, None).unwrap();
        let frame = |text: &str| {
            format!("<svg viewBox=\"0 0 9 9\" role=\"img\">\n<title>Moved</title>\n<text>{text}</text>\n</svg>\n")
        };
        content.exhibits.moving.push(Moving {
            name: "moved".into(),
            sliders: vec![Slider { label: "way".into(), values: vec!["0".into(), "1 mm".into()], start: 0 }],
            frames: vec![frame("here"), frame("there")],
        });
        build(folder.path(), &Options::default(), content).unwrap();
        Some(Self { folder, project })
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("target/book").canonicalize().unwrap()
    }

    fn said(&self, browsers: &mut [Browser; BROWSERS]) -> String {
        let visited = visit(&self.project, &self.out(), browsers).unwrap();
        format!("{} {visited}", visited.is_well())
    }
}

#[test]
fn a_good_book_is_well_and_planted_faults_are_named() {
    let Some(book) = Book::new(CHAPTER, QUERIES) else { return };
    let mut browsers = browsers().unwrap();
    let said = book.said(&mut browsers);
    assert!(said.starts_with("true") && said.contains("5 of 5 queries"), "{said}");
    let controls = said.split("; ").find_map(|part| part.split_once(" controls reached")?.0.parse::<usize>().ok());
    assert!(controls > Some(10), "{said}");
    let page = book.out().join("coulomb.html");
    let good = fs::read_to_string(&page).unwrap();
    let mut faults = vec![
        ("<p style=\"width: 500px\">wide</p>", "wider than the screen"),
        ("<script>console.error('planted')</script>", "planted"),
        ("<a href=\"#one\" style=\"outline: none !important; box-shadow: none\">a</a>", "nothing marks <a"),
        ("<math><mi>𓀀</mi></math>", "has no `𓀀`"),
    ];
    if std::env::var_os(super::AXE).is_some() {
        faults.push(("<p style=\"color: #ccc; background: #fff\">pale</p>", "serious: color-contrast"));
        faults.push(("<img src=\"favicon.svg\">", "critical: image-alt"));
    }
    for (planted, expected) in faults {
        fs::write(&page, good.replacen("</main>", &format!("{planted}</main>"), 1)).unwrap();
        let said = book.said(&mut browsers);
        assert!(said.starts_with("false") && said.contains(expected), "{planted}: {said}");
    }
}

#[test]
fn a_wrong_answer_of_search_is_named() {
    let Some(book) = Book::new(CHAPTER, "yield => coulomb.html#one\n") else { return };
    let said = book.said(&mut browsers().unwrap());
    assert!(said.starts_with("false"), "{said}");
    assert!(said.contains("yield: wanted is coulomb.html#one, found coulomb.html#coulomb.yield"), "{said}");
}

#[test]
fn sliders_show_the_position_they_are_at() {
    let Some(book) = Book::new(CHAPTER, QUERIES) else { return };
    let mut browser = Browser::start().unwrap();
    browser.open(&book.out().join("coulomb.html")).unwrap();
    let shown = browser
        .evaluate(
            "(async () => {
                const figure = document.getElementById('figure-moved');
                const slider = figure.querySelector('input');
                const before = figure.querySelector('.drawing').textContent.trim();
                slider.value = 1;
                slider.dispatchEvent(new Event('input'));
                const drawn = () => figure.querySelector('.drawing').textContent.trim();
                for (let left = 300; left > 0 && drawn() === before; --left) await new Promise((done) => setTimeout(done, 10));
                return [before, drawn(), figure.querySelector('output').textContent, slider.getAttribute('aria-valuetext')].join('|');
            })()",
        )
        .unwrap();
    let text = shown.as_str().unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(text, "Moved here|Moved there|1 mm|1 mm");
}

#[test]
fn what_was_found_in_some_pages_is_added_to_what_was_found_in_others() {
    let found = |pages: usize| Visited {
        pages,
        searched: 2 * pages,
        controls: 3 * pages,
        answers: None,
        weights: [(7, format!("{pages}.html"))].into(),
        off: [("too wide".to_owned(), vec![pages.to_string()])].into(),
    };
    let both = found(1).and(found(10));
    assert_eq!((both.pages, both.searched, both.controls, both.weights.len()), (11, 22, 33, 2));
    assert_eq!(both.off["too wide"], ["1", "10"]);
}
