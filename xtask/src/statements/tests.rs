//! Whole registries: the real one, and planted ones with one fault.

use super::book;
use super::check::faults;
use super::document::{Counts, Document};
use super::documents;
use super::errata;
use super::erratum::{Erratum, at};
use super::statement::{Statement, covered, mended, outside};
use super::world::{World, anchors};
use jointproof::catalog::CATALOG;
use jointproof::connector::slot::{self, Slot};
use jointproof::formula::Formula;
use kit::Project;

fn world() -> World {
    let project = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("..");
    World::read(&project).unwrap()
}

/// The faults after a statement is added to the real ones.
fn planted(statement: Statement) -> Vec<String> {
    let mut documents = documents::all();
    documents[0].statements.push(statement);
    faults(&documents, &errata::all(), &world())
}

#[test]
fn nothing_is_wrong() {
    assert_eq!(faults(&documents::all(), &errata::all(), &world()), Vec::<String>::new());
}

/// With a golden file missing that statements refer to.
#[cfg(unix)]
#[test]
fn verify_is_told_whether_anything_is_wrong() {
    let whole = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("..");
    assert!(super::verify(&whole).unwrap().0);
    let folder = tempfile::tempdir().unwrap();
    let link = |part: &str| std::os::unix::fs::symlink(whole.root().join(part), folder.path().join(part)).unwrap();
    ["src", "tests", "book"].into_iter().for_each(link);
    std::fs::create_dir(folder.path().join("golden")).unwrap();
    for file in std::fs::read_dir(whole.golden()).unwrap().map(|file| file.unwrap().file_name()) {
        if file != "slot.stop.json" {
            link(&format!("golden/{}", file.to_str().unwrap()));
        }
    }
    let output = std::process::Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "statements::tests::what_is_wrong_is_said", "--nocapture"])
        .env(FOLDER, folder.path())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && said.contains("slot.stop"), "{said}");
}

/// The folder of a project with a fault.
const FOLDER: &str = "JOINTPROOF_WRONG_STATEMENTS";

/// Run by the previous test in a separate process, whose messages it reads.
#[test]
fn what_is_wrong_is_said() {
    let Ok(folder) = std::env::var(FOLDER) else { return };
    let part = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder(&folder);
    assert!(!super::verify(&part).unwrap().0);
}

#[test]
fn a_statement_that_nothing_covers_fails() {
    assert_eq!(planted(covered("L99", "It floats.")), ["slot-L99: nothing covers it"]);
    let only_erratum = mended("L99", "It floats.", "lost-roots");
    assert_eq!(planted(only_erratum), ["slot-L99: nothing but an erratum covers it"]);
    assert_eq!(planted(outside("L99", "It floats.", "")), ["slot-L99: it does not say why"]);
    let known = planted(covered("L3-s1", "It floats.").chapter("slot.md"));
    assert_eq!(known, ["slot-L3-s1: a statement of this id is there already"]);
}

#[test]
fn a_reference_to_nothing_fails() {
    let phantoms = [
        (covered("L99", "").law(&slot::Stop, "the gaps sing"), "has not one law that begins with \"the gaps sing\""),
        (covered("L99", "").law(&slot::Friction, ""), "has not one law that begins with \"\""),
        (covered("L99", "").cases(&slot::Stop, &["nowhere"]), "has no golden case nowhere"),
        (covered("L99", "").outputs(&["slot/U9"]), "scenes have no output slot/U9"),
        (covered("L99", "").outputs(&["slot@2d/Z"]), "scenes have no output slot@2d/Z"),
        (covered("L99", "").test("ujoint::nobody_wrote_this"), "there is no test ujoint::nobody_wrote_this"),
        (covered("L99", "").test("ujoint::triad"), "there is no test ujoint::triad"),
        (covered("L99", "").chapter("slot.md#nowhere"), "the book has no slot.md#nowhere"),
        (covered("L99", "").chapter("nothing.md"), "the book has no nothing.md"),
        (covered("L99", "").item::<String>(), "alloc::string::String is not found in its file"),
        (covered("L99", "").method(Slot::new).erratum("no-such"), "there is no erratum no-such"),
    ];
    for (statement, expected) in phantoms {
        let faults = planted(statement);
        assert!(
            faults.len() == 1 && faults[0].starts_with("slot-L99: ") && faults[0].ends_with(expected),
            "{faults:?}"
        );
    }
}

#[test]
fn a_formula_that_no_statement_names_fails() {
    let mut documents = documents::all();
    let id = slot::KineticForce::SPEC.id;
    let count = |documents: &[Document]| documents.iter().map(|document| document.statements.len()).sum::<usize>();
    let before = count(&documents);
    for document in &mut documents {
        document.statements.retain(|statement| !statement.names(id));
    }
    assert!(count(&documents) < before);
    let expected = format!("{id}: no statement of a document names this formula, and it is not ours");
    assert_eq!(faults(&documents, &errata::all(), &world()), [expected]);
}

#[test]
fn an_erratum_without_its_place_in_the_chapter_fails() {
    let mut errata = errata::all();
    errata[0].anchor = "elsewhere";
    let faults = faults(&documents::all(), &errata, &world());
    assert!(faults.iter().any(|fault| fault.starts_with("erratum elsewhere: errata.md has no heading")), "{faults:?}");
    assert!(faults.iter().any(|fault| fault.ends_with("there is no erratum lost-roots")), "{faults:?}");
}

#[test]
fn an_erratum_has_a_heading_and_its_tables() {
    let errata = |chapter: &str| {
        let mut errata = errata::all();
        errata.truncate(1);
        errata[0].anchor = "lost";
        let faults = faults(&[], &errata, &World::of(&[("book/src/errata.md", chapter)], &[]));
        faults.into_iter().filter(|fault| fault.starts_with("erratum lost: ")).count()
    };
    assert_eq!(errata("## Lost {#lost}\n\n{{#text erratum-lost}}\n"), 0);
    assert_eq!(errata("## Lost {#lost}\n"), 1);
    assert_eq!(errata("## Found\n\n{{#text erratum-lost}}\n"), 1);
}

#[test]
fn what_is_outside_is_covered_by_nothing() {
    let both = outside("L99", "It floats.", "nothing to code").chapter("slot.md");
    assert_eq!(planted(both), ["slot-L99: it is outside, and covered"]);
    assert!(planted(outside("L99", "It floats.", "nothing to code")).is_empty());
    assert!(planted(mended("L99", "It floats.", "lost-roots").chapter("slot.md")).is_empty());
}

#[test]
fn a_formula_is_of_a_section_of_its_document() {
    let mut documents = documents::all();
    let (id, source) = (slot::KineticForce::SPEC.id, slot::KineticForce::SPEC.source);
    let own = documents.iter_mut().find(|document| document.source == source.document).unwrap();
    assert!(own.sections.contains(&source.section));
    own.sections = &["Elsewhere"];
    let expected = format!("{id}: its section \"{}\" is not one of {}", source.section, source.document.title);
    assert!(faults(&documents, &errata::all(), &world()).contains(&expected));
}

#[test]
fn an_erratum_that_shows_nothing_fails() {
    assert_eq!(
        Erratum { anchor: "empty", comparisons: Vec::new() }.faults(),
        ["erratum empty: no literal reading beside a right one"]
    );
}

#[test]
fn a_literal_reading_that_obeys_and_a_right_one_that_breaks_the_law_fail() {
    let comparison = at("", "the law").printed("", 1.0, 0.0).here::<slot::Stop>("", 1.0, 0.5);
    let faults = Erratum { anchor: "wrong", comparisons: vec![comparison] }.faults();
    let id = slot::Stop::SPEC.id;
    let expected = [
        "erratum wrong: as printed, it obeys the law \"the law\": off by 0e0".to_owned(),
        format!("erratum wrong: here: `{id}`, it breaks the law \"the law\": off by 5e-1"),
    ];
    assert_eq!(faults, expected);
}

#[test]
fn the_counts_add_up() {
    let documents = documents::all();
    let Counts { all, covered, errata, outside } = Counts::of(&documents);
    assert_eq!(all, covered + errata + outside);
}

#[test]
fn anchors_are_those_of_headings_and_entries() {
    let text = "# One $x$ two\n\n## Three `four` {#five}\n\n### What's six?\n\n{{#formula slot.stop}}\n";
    let expected = ["five", "one--two", "slot.stop", "whats-six"];
    assert_eq!(anchors(text).into_iter().collect::<Vec<_>>(), expected);
}

#[test]
fn an_entry_has_its_statements_with_links() {
    let lines = book::of_formula(&documents::all(), &world(), slot::ConstraintForce::SPEC.id);
    let line = lines.iter().find(|line| line.contains("[SLOT L32](traceability.html#slot-L32)")).unwrap();
    for link in [
        "[case `running`](golden/slot.constraint_force.json)",
        "[`Slot::constraint_force`](source/src/connector/slot/connector.rs.html#L",
    ] {
        assert!(line.contains(link), "{line}");
    }
    assert!(line.contains("[slot/RF](scenes.html#slot-3d)"));
}
