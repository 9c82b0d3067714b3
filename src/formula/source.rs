//! Where an equation is from, and how much of it the document says.

use std::fmt;

/// A document that equations are taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Document {
    /// Its title.
    pub title: &'static str,
    /// Where it can be read; empty where it cannot be linked.
    pub link: &'static str,
}

impl Document {
    /// The connector SLOT.
    pub const SLOT: Self = Self::new("SLOT");
    /// The connector UJOINT.
    pub const UJOINT: Self = Self::new("UJOINT");
    /// The sliding multi-point constraint; it has no headings.
    pub const SLIDER: Self = Self::new("Sliding constraint");
    /// The connector TRANSLATOR.
    pub const TRANSLATOR: Self = Self::new("TRANSLATOR");
    /// Slide lines and the elements on them.
    pub const SLIDE_LINE: Self = Self::new("Slide lines");

    /// A document of this title.
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

    /// An equation that the section prints with symbols lost: which.
    pub const fn reconstructed(self, section: &'static str, lost: &'static str) -> Source {
        self.source(section, Provenance::Reconstructed(lost))
    }

    /// An equation that the section needs and does not print: why it is as it is.
    pub const fn ours(self, section: &'static str, why: &'static str) -> Source {
        self.source(section, Provenance::Ours(why))
    }

    const fn source(self, section: &'static str, provenance: Provenance) -> Source {
        Source { document: self, section, provenance }
    }
}

/// The place in a document that an equation is from, and what the document says of it. Made by
/// [`Document::printed`], [`Document::reconstructed`] or [`Document::ours`], so that none is without its provenance:
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
    /// What the document says of the equation.
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

/// How much of an equation its document says.
///
/// It is said of the equation as [`Spec::latex`](super::Spec::latex) writes it. What stands in it under a name of its own,
/// as F_C in F_N, has a formula and a provenance of its own. A residual counts as the printed equation whose two sides it
/// subtracts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Provenance {
    /// Printed. A dot that was lost between two vectors leaves no other reading and is not counted as lost.
    Printed,
    /// The document's words stand, symbols were lost in the text that was passed on: which.
    Reconstructed(&'static str),
    /// Ours, and why.
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

    /// What was lost, or why it is ours; empty for what is printed.
    pub const fn why(self) -> &'static str {
        match self {
            Self::Printed => "",
            Self::Reconstructed(why) | Self::Ours(why) => why,
        }
    }
}

/// The kind, and why.
impl fmt::Display for Provenance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.why() {
            "" => f.write_str(self.kind()),
            why => write!(f, "{}: {why}", self.kind()),
        }
    }
}
