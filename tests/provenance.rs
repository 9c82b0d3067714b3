//! The origins of the formulas: the documents' own headings, and a reason for everything that is not printed.

use jointproof::catalog::CATALOG;
use jointproof::formula::{Document, Provenance};

/// The headings of a connector's page.
const CONNECTOR: &[&str] = &["Description", "Friction", "Summary"];
/// The other documents and those of their headings that contain formulas.
const HEADINGS: [(Document, &[&str]); 2] = [
    (Document::SLIDER, &[""]),
    (
        Document::SLIDE_LINE,
        &[
            "Defining the local basis system",
            "Defining a linear slide line",
            "Defining a parabolic slide line",
            "Smoothing the slide line",
            "Defining slide line elements (slave surface)",
            "Defining nondefault mechanical surface interactions with slide line elements",
            "Obtaining the “maximum torque” that can be transmitted across axisymmetric slide lines",
            "Element output",
        ],
    ),
];

#[test]
fn sections_are_headings_of_their_document() {
    for formula in CATALOG {
        let (id, source) = (formula.spec().id, formula.spec().source);
        let other = HEADINGS.iter().find(|(document, _)| *document == source.document);
        let headings = other.map_or(CONNECTOR, |(_, headings)| headings);
        assert!(headings.contains(&source.section), "{id}: {source}");
    }
}

#[test]
fn what_is_not_printed_says_why_in_a_clause() {
    for formula in CATALOG {
        let (id, provenance) = (formula.spec().id, formula.spec().source.provenance);
        let why = provenance.why();
        assert_eq!(provenance == Provenance::Printed, why.is_empty(), "{id}");
        assert!(!why.ends_with('.') && why.len() <= 120, "{id}: {why}");
        let shown = provenance.to_string();
        assert!(shown.starts_with(provenance.kind()) && shown.ends_with(why), "{id}: {shown}");
    }
}

/// A page that was not given cannot have printed anything.
#[test]
fn what_the_pages_of_align_join_and_universal_say_is_ours() {
    for formula in CATALOG {
        let (id, source) = (formula.spec().id, formula.spec().source);
        if ["align.", "cardan.", "join.", "universal."].iter().any(|family| id.starts_with(family)) {
            assert_eq!(source.provenance.kind(), "ours", "{id}");
        }
    }
}
