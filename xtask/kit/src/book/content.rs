//! The interface between the library and the book: everything the book needs to know about the formulas, as plain data.
//!
//! The book generator never accesses the library. The caller of [`super::build`] fills these structs from the catalog, the last
//! audit and the golden files; anything `None` or empty is printed as "not run", never as proof.
//!
//! Fields marked *text* contain plain text in which `$…$` is mathematics and `` `…` `` is code.

use crate::export::Download;
use crate::extension::Extras;
use crate::report::data::Report;
use jointproof::toolkit::verify::Audit;

/// The content of the book, apart from the chapters on disk.
#[derive(Debug, Clone, Default)]
pub(crate) struct Content {
    /// Every catalog formula, in book order.
    pub(crate) entries: Vec<Entry>,
    /// Rust files that get a listing page; code and tests link into them.
    pub(crate) sources: Vec<SourceFile>,
    /// Tests that run over the whole catalog.
    pub(crate) catalog_tests: Vec<TestRef>,
    /// The project's content in addition to its formulas.
    pub(crate) extras: Extras,
    /// The last report on speed and error.
    pub(crate) report: Option<Report>,
    /// Whether the report is about this version of the code.
    pub(crate) is_current: bool,
    /// Golden files to be copied next to the pages.
    pub(crate) golden: Vec<GoldenFile>,
    /// The sheets of the elements.
    pub(crate) sheets: Vec<Sheet>,
    /// Formulas and elements in other languages.
    pub(crate) downloads: Vec<Download>,
    /// The data for citing entries.
    pub(crate) cited: Option<Cited>,
}

/// The data for citing entries.
#[derive(Debug, Clone)]
pub(crate) struct Cited {
    /// The name of the project.
    pub(crate) book: String,
    /// The authors of the book.
    pub(crate) authors: String,
    /// Its version.
    pub(crate) version: String,
    /// The year of its release; empty if that is not known.
    pub(crate) year: String,
    /// Where all versions are published, ending in a slash; empty if that is nowhere.
    pub(crate) site: String,
}

impl Cited {
    /// The address of a place in this version of the book, which stays; a relative path if the book is published nowhere.
    pub(crate) fn address(&self, place: &str) -> String {
        if self.site.is_empty() { place.to_owned() } else { format!("{}v{}/{place}", self.site, self.version) }
    }
}

/// One Rust file of the repository.
#[derive(Debug, Clone)]
pub(crate) struct SourceFile {
    /// Path from the repository root with forward slashes, for instance `src/slot.rs`.
    pub(crate) path: String,
    /// The whole file.
    pub(crate) text: String,
}

/// One golden file, byte for byte.
#[derive(Debug, Clone)]
pub(crate) struct GoldenFile {
    /// File name, for instance `slot.contact_force.json`.
    pub(crate) name: String,
    /// The bytes of the file.
    pub(crate) bytes: Vec<u8>,
}

/// What the sheet of an element says apart from the equations of the formulas that its page names, in Markdown.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sheet {
    /// The identifier of the element.
    pub(crate) id: String,
    /// The table of its degrees of freedom and multipliers.
    pub(crate) degrees: String,
    /// Whether it holds conditions by multipliers.
    pub(crate) is_held: bool,
    /// Whether its nodes rotate in space.
    pub(crate) rotates: bool,
    /// The tables of its parameters.
    pub(crate) parameters: String,
    /// The parameters of friction and its state; empty if it has none.
    pub(crate) friction: String,
    /// One step in numbers.
    pub(crate) state: String,
    /// How a program of one's own is checked.
    pub(crate) check: String,
}

/// One documented formula.
#[derive(Debug, Clone, Default)]
pub(crate) struct Entry {
    /// Stable identifier, for instance `slot.contact_force`; also the anchor in the book.
    pub(crate) id: String,
    /// Heading (text).
    pub(crate) title: String,
    /// The equation, in LaTeX without dollar signs.
    pub(crate) latex: String,
    /// The sources of symbols that the equation does not define (text); may be empty.
    pub(crate) given: String,
    /// The equation with all definitions substituted, one statement per line; empty if there is nothing to substitute.
    pub(crate) closed: Vec<String>,
    /// The variation of its outputs, one statement per line.
    pub(crate) variation: Vec<String>,
    /// The formulas whose outputs it uses.
    pub(crate) uses: Vec<String>,
    /// The SHA-256 of its golden file.
    pub(crate) digest: Option<String>,
    /// A worked example from a golden case.
    pub(crate) worked: Option<Worked>,
    /// Where the equation comes from.
    pub(crate) source: Source,
    /// Inputs in the order of the golden file.
    pub(crate) inputs: Vec<Symbol>,
    /// Outputs in the order of the golden file.
    pub(crate) outputs: Vec<Symbol>,
    /// Points where the derivative jumps.
    pub(crate) kinks: Vec<Kink>,
    /// Its bounds of η, and how they are known (text); may be empty.
    pub(crate) accuracy: String,
    /// Why some entries have no proved bound (text).
    pub(crate) not_proved: Vec<String>,
    /// The functions to show, normally `eval` and `jacobian`.
    pub(crate) code: Vec<CodeSpan>,
    /// Tests that name the id.
    pub(crate) tests: Vec<TestRef>,
    /// The number of golden cases by flag.
    pub(crate) golden: Option<GoldenCounts>,
    /// The executed checks of the formula.
    pub(crate) evidence: Evidence,
    /// The calculator on its page.
    pub(crate) calculator: Calculator,
}

/// The calculator in the entry of a formula.
#[derive(Debug, Clone, Default)]
pub(crate) enum Calculator {
    /// Nothing.
    #[default]
    Absent,
    /// The script of the formula, with its golden cases and kinks.
    Script(String),
    /// Why the formula is not exported.
    Refused(String),
}

/// A golden case in numbers, each as text: `$f_2 = 3$`.
#[derive(Debug, Clone, Default)]
pub(crate) struct Worked {
    /// The name of the case.
    pub(crate) case: String,
    /// The inputs.
    pub(crate) inputs: Vec<String>,
    /// The outputs.
    pub(crate) outputs: Vec<String>,
    /// Some of its derivatives.
    pub(crate) derivatives: Vec<String>,
}

/// The document an equation was taken from.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Source {
    /// Its title (text), for instance `SLOT`.
    pub(crate) title: String,
    /// Where it can be read; may be empty.
    pub(crate) link: String,
    /// Place within the document (text); may be empty.
    pub(crate) place: String,
    /// How completely the document prints the equation (text).
    pub(crate) provenance: String,
}

/// One named field of a formula's inputs or outputs.
#[derive(Debug, Clone, Default)]
pub(crate) struct Symbol {
    /// The name in Rust, in golden files and in reports.
    pub(crate) name: String,
    /// The symbol in LaTeX.
    pub(crate) latex: String,
    /// `scalar`, `vec2`, `vec3`, `mat2`, `mat3`.
    pub(crate) shape: String,
    /// `L`, `F`, `FL` or `1`.
    pub(crate) unit: String,
    /// Values allowed (text); empty means any finite number.
    pub(crate) allowed: String,
    /// Its meaning (text).
    pub(crate) meaning: String,
}

/// A point where the formula has no derivative, and what is returned there.
#[derive(Debug, Clone, Default)]
pub(crate) struct Kink {
    /// Where it is (text), for instance `$f_2 = f_3 = 0$`.
    pub(crate) at: String,
    /// The derivative that jumps there (text), for instance `$\partial F_C/\partial f_2$`.
    pub(crate) derivative: String,
    /// Its value on one side (text).
    pub(crate) left: String,
    /// Its value on the other side (text).
    pub(crate) right: String,
    /// The value returned, and by which convention (text).
    pub(crate) convention: String,
}

/// A run of lines in a source file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CodeSpan {
    /// The name of the function, for instance `eval`.
    pub(crate) name: String,
    /// Path as in [`SourceFile::path`].
    pub(crate) file: String,
    /// First line, counted from 1.
    pub(crate) first: usize,
    /// Last line, inclusive.
    pub(crate) last: usize,
}

/// A test that names a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TestRef {
    /// The test function.
    pub(crate) name: String,
    /// Path as in [`SourceFile::path`].
    pub(crate) file: String,
    /// Line of the function.
    pub(crate) line: usize,
}

/// The number of golden cases with each flag. A case may have several flags.
#[derive(Debug, Clone, Default)]
pub(crate) struct GoldenCounts {
    /// File name as in [`GoldenFile::name`].
    pub(crate) file: String,
    /// All cases.
    pub(crate) total: usize,
    /// Flag and number of cases, in the order to be shown.
    pub(crate) flags: Vec<(String, usize)>,
}

/// The checks executed by the last golden check and audit of this version of the code.
#[derive(Debug, Clone, Default)]
pub(crate) struct Evidence {
    /// Golden cases that were regenerated and equal the file, byte for byte.
    pub(crate) golden_cases: Option<usize>,
    /// The audit.
    pub(crate) audit: Option<Audit>,
}
