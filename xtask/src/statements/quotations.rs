//! Quotations of the documents in the chapter of errata: each is in the document that it is from, symbol for symbol.

use std::path::Path;

/// Everything that the chapter quotes, and a document that has it. A quotation that is new or changed is compared with the text
/// where that is present, and is then added here, so that a wrong one is noticed without the texts, too.
const QUOTED: [(&str, &str); 11] = [
    ("f22+f32", "SLOT"),
    ("MtorqRr", "TRANSLATOR"),
    ("2MbendL", "TRANSLATOR"),
    ("βtwistMtwistLa", "UJOINT"),
    ("2MtotalhingeLs", "UJOINT"),
    ("18FbendLa", "UJOINT"),
    ("Fbend4", "UJOINT"),
    ("|m1Rr|", "TRANSLATOR"),
    ("β=2L", "TRANSLATOR"),
    ("Φ=P(f)-μFN0", "SLOT"),
    ("width", "Slide lines"),
];

/// What stands in straight double quotes outside of code, claims with the test that executes them aside.
fn quotations(chapter: &str) -> Vec<&str> {
    let lines = chapter.lines().filter(|line| !line.starts_with("{{"));
    let quoted = lines.flat_map(|line| {
        let pieces: Vec<_> = line.split('"').collect();
        (1..pieces.len()).step_by(2).filter(|k| !pieces[k - 1].ends_with("{{")).map(|k| pieces[k]).collect::<Vec<_>>()
    });
    quoted.collect()
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

#[test]
fn what_the_errata_quote_is_listed() {
    let chapter = std::fs::read_to_string(root().join("book/src/errata.md")).unwrap();
    let quoted = quotations(&chapter);
    assert!(quoted.len() >= QUOTED.len());
    for quotation in &quoted {
        let is_listed = QUOTED.iter().any(|(known, _)| known == quotation);
        assert!(is_listed, "\"{quotation}\" is not among the quotations that were compared with a document");
    }
    for (known, _) in QUOTED {
        assert!(quoted.contains(&known), "\"{known}\" is quoted no more");
    }
}

#[test]
fn what_is_listed_is_in_its_document() {
    let folder = root().join("../shared/seeds");
    let Ok(texts) = std::fs::read_dir(&folder) else {
        eprintln!("skipped: the documents are not here");
        return;
    };
    let texts: Vec<_> = texts.flatten().map(|text| std::fs::read_to_string(text.path()).unwrap()).collect();
    let documents = super::documents::all();
    for (quotation, title) in QUOTED {
        let document = documents.iter().find(|document| document.source.title == title).unwrap();
        let (size, _) = document.text.unwrap();
        let text = texts.iter().find(|text| text.len() == size).unwrap_or_else(|| panic!("no text of {title}"));
        assert!(text.contains(quotation), "{title} has no \"{quotation}\"");
    }
    // The kind of mistake that this is for.
    assert!(texts.iter().all(|text| !text.contains("2MtotalLs")));
}
