//! The source of an equation, and how completely the document prints it.

use std::fmt;

/// A document that equations are taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Document {
    /// Its title.
    pub title: &'static str,
    /// Where it, or its public counterpart, can be read; empty if there is no link.
    pub link: &'static str,
}

impl Document {
    /// The connector SLOT.
    pub const SLOT: Self = Self::new("SLOT")
        .link("https://abaqus-docs.mit.edu/2017/English/SIMACAEELMRefMap/simaelm-c-connectiontypedesc-slot.htm");
    /// The connector UJOINT.
    pub const UJOINT: Self = Self::new("UJOINT")
        .link("https://abaqus-docs.mit.edu/2017/English/SIMACAEELMRefMap/simaelm-c-connectiontypedesc-ujoint.htm");
    /// The sliding multi-point constraint; it has no headings.
    pub const SLIDER: Self = Self::new("Sliding constraint")
        .link("https://abaqus-docs.mit.edu/2017/English/SIMACAETHERefMap/simathe-c-slidermpc.htm");
    /// The connector TRANSLATOR.
    pub const TRANSLATOR: Self = Self::new("TRANSLATOR")
        .link("https://abaqus-docs.mit.edu/2017/English/SIMACAEELMRefMap/simaelm-c-connectiontypedesc-translator.htm");
    /// Slide lines and the elements on them.
    pub const SLIDE_LINE: Self = Self::new("Slide lines")
        .link("https://abaqus-docs.mit.edu/2017/English/SIMACAEITNRefMap/simaitn-c-slidelineelem.htm");

    /// A document with this title.
    pub const fn new(title: &'static str) -> Self {
        Self { title, link: "" }
    }

    /// Where it can be read.
    #[must_use]
    pub const fn link(self, link: &'static str) -> Self {
        Self { link, ..self }
    }

    /// An equation that the section prints.
    pub const fn printed(self, section: &'static str) -> Source {
        self.source(section, Provenance::Printed)
    }

    /// An equation that the section prints with lost symbols, described by `lost`.
    pub const fn reconstructed(self, section: &'static str, lost: &'static str) -> Source {
        self.source(section, Provenance::Reconstructed(lost))
    }

    /// An equation that the section needs but does not print; `why` justifies it.
    pub const fn ours(self, section: &'static str, why: &'static str) -> Source {
        self.source(section, Provenance::Ours(why))
    }

    const fn source(self, section: &'static str, provenance: Provenance) -> Source {
        Source { document: self, section, provenance }
    }
}

/// The place in a document where an equation comes from, and how completely the document prints it. Created by
/// [`Document::printed`], [`Document::reconstructed`] or [`Document::ours`], so that none lacks its provenance:
///
/// ```compile_fail
/// use jointproof::formula::{Document, Spec};
/// const SPEC: Spec = Spec::new("spring.energy", "Energy of a spring", Document::new("My notes"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Source {
    /// The document.
    pub document: Document,
    /// The section, in the document's own headings; empty where it has none.
    pub section: &'static str,
    /// How completely the document prints the equation.
    pub provenance: Provenance,
}

/// The document and the section.
impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.section {
            "" => f.write_str(self.document.title),
            section => write!(f, "{}, {section}", self.document.title),
        }
    }
}

/// How completely a document prints an equation.
///
/// It refers to the equation as [`Spec::latex`](super::Spec::latex) writes it. A quantity that appears in it under its
/// own name, such as F_C in F_N, has its own formula and provenance. A residual counts as the printed equation whose
/// two sides it subtracts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Provenance {
    /// Printed. A dot lost between two vectors leaves no other reading and does not count as lost.
    Printed,
    /// The document's words are there, but symbols, named here, were lost in the text we received.
    Reconstructed(&'static str),
    /// Derived by us, for the reason given here.
    Ours(&'static str),
}

impl Provenance {
    /// `printed`, `reconstructed` or `ours`.
    pub const fn kind(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Reconstructed(_) => "reconstructed",
            Self::Ours(_) => "ours",
        }
    }

    /// What was lost, or why it is ours; empty if printed.
    pub const fn why(self) -> &'static str {
        match self {
            Self::Printed => "",
            Self::Reconstructed(why) | Self::Ours(why) => why,
        }
    }
}

/// The kind, and the explanation if there is one.
impl fmt::Display for Provenance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.why() {
            "" => f.write_str(self.kind()),
            why => write!(f, "{}: {why}", self.kind()),
        }
    }
}
