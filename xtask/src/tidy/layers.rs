//! Which layer may use which. Lower layers know nothing of higher ones, and formulas nothing of their evidence.

use super::edges::{Edges, Place};
use super::finding::Finding;
use super::tree::Tree;
use std::collections::BTreeSet;

/// A layer of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Layer {
    /// Numbers, quantities, errors.
    Ground,
    /// The definition of a formula.
    Formula,
    /// What connectors are made of: nodes, frames, angles, blocks.
    Element,
    /// Friction, pressure and slide lines.
    Contact,
    /// The connectors.
    Connector,
    /// The vocabulary of evidence: cases, kinks, laws, alternative methods.
    Proof,
    /// Verification and measurement of formulas.
    Toolkit,
    /// Every formula by identifier.
    Catalog,
    /// Scene files.
    Scene,
}

impl Layer {
    /// The layer of a file below `src`.
    fn of(path: &str) -> Self {
        match path {
            "formula/error.rs" | "formula/quantity.rs" => return Self::Ground,
            _ if path.starts_with("formula/error/") || path.starts_with("formula/quantity/") => return Self::Ground,
            _ if path.starts_with("formula/proof") => return Self::Proof,
            _ => {}
        }
        match path.split(['/', '.']).next() {
            Some("number") => Self::Ground,
            Some("formula") => Self::Formula,
            Some("toolkit") => Self::Toolkit,
            Some("catalog") => Self::Catalog,
            Some("scene") => Self::Scene,
            Some("element") => Self::Element,
            Some("contact") => Self::Contact,
            _ => Self::Connector,
        }
    }

    /// Whether formulas are defined in it.
    const fn has_formulas(self) -> bool {
        matches!(self, Self::Element | Self::Contact | Self::Connector)
    }
}

/// The layers in which formulas are defined.
const FORMULAS: [Layer; 3] = [Layer::Element, Layer::Contact, Layer::Connector];

/// Layers that a layer may not use.
struct Forbidden {
    from: &'static [Layer],
    to: &'static [Layer],
    /// The reason, and what to do.
    why: &'static str,
}

/// Every use that is forbidden between layers. Evidence is excepted: it is next to a formula and uses the toolkit.
const FORBIDDEN: &[Forbidden] = &[
    Forbidden {
        from: &[Layer::Ground],
        to: &[
            Layer::Formula,
            Layer::Element,
            Layer::Contact,
            Layer::Connector,
            Layer::Proof,
            Layer::Toolkit,
            Layer::Catalog,
            Layer::Scene,
        ],
        why: "numbers, quantities and errors stand below the formulas; hand it in, or move it up",
    },
    Forbidden {
        from: &[Layer::Formula],
        to: &[
            Layer::Element,
            Layer::Contact,
            Layer::Connector,
            Layer::Proof,
            Layer::Toolkit,
            Layer::Catalog,
            Layer::Scene,
        ],
        why: "what a formula is does not depend on what is made of it or said about it; move it there",
    },
    Forbidden {
        from: &FORMULAS,
        to: &[Layer::Proof, Layer::Toolkit],
        why: "formulas and connectors compile without what proves them; move it to the evidence beside them",
    },
    Forbidden {
        from: &FORMULAS,
        to: &[Layer::Catalog, Layer::Scene],
        why: "a formula knows only what is below it; let the caller hand it in",
    },
    Forbidden {
        from: &[Layer::Element],
        to: &[Layer::Contact, Layer::Connector],
        why: "what connectors are made of knows neither contact nor connectors; move it up, or what it uses down",
    },
    Forbidden {
        from: &[Layer::Contact],
        to: &[Layer::Connector],
        why: "friction and slide lines know no connector; move it up, or what it uses down",
    },
    Forbidden {
        from: &[Layer::Proof],
        to: &[Layer::Element, Layer::Contact, Layer::Connector, Layer::Toolkit, Layer::Catalog, Layer::Scene],
        why: "in what words evidence is stated depends on no formula and on nothing that checks it; move it there",
    },
    Forbidden {
        from: &[Layer::Toolkit],
        to: &[Layer::Element, Layer::Contact, Layer::Connector, Layer::Catalog, Layer::Scene],
        why: "the toolkit proves formulas of other crates too and knows none by name; hand it in, or move it down",
    },
];

/// Every use that violates the order of layers.
pub(super) fn crossed(tree: &Tree, edges: &Edges) -> Vec<Finding> {
    let evidence = evidence(tree);
    let findings = edges.iter().filter_map(|(&(from, to), Place { line, text })| {
        let path = &tree.sources[from].path;
        let (lower, upper) = (layer(path)?, layer(&tree.sources[to].path)?);
        let said = matches!(upper, Layer::Proof | Layer::Toolkit);
        let why = if (said || upper.has_formulas()) && evidence.contains(&from) && lower.has_formulas() {
            None
        } else if said && lower.has_formulas() && !tree.sources[from].formulas.is_empty() {
            Some("a file of formulas imports neither `proof` nor `verify` nor `measure`; move the evidence to a file beside it")
        } else {
            let rules = FORBIDDEN.iter().filter(|rule| rule.from.contains(&lower) && rule.to.contains(&upper));
            rules.map(|rule| rule.why).next()
        };
        why.map(|why| Finding::new(path, *line, format!("`{text}`: {why}")))
    });
    findings.collect()
}

/// The layer of a file; `None` for `lib.rs`, which only lists the modules, and for files of other crates.
fn layer(path: &str) -> Option<Layer> {
    let path = path.strip_prefix("src/").filter(|path| *path != "lib.rs")?;
    Some(Layer::of(path))
}

/// The role of a library file for the evidence of formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// Formulas and connectors.
    Formulas,
    /// Code common to all formulas.
    Common,
}

/// The role of a library file; `None` for code that depends on formulas and on which they do not depend.
pub(super) fn part(path: &str) -> Option<Part> {
    match layer(path)? {
        Layer::Element | Layer::Contact | Layer::Connector => Some(Part::Formulas),
        Layer::Ground | Layer::Formula | Layer::Proof | Layer::Toolkit if !path.starts_with("src/toolkit/measure") => {
            Some(Part::Common)
        }
        Layer::Ground | Layer::Formula | Layer::Proof | Layer::Toolkit | Layer::Catalog | Layer::Scene => None,
    }
}

/// The files without a formula that prove one, or that are compiled only for evidence.
fn evidence(tree: &Tree) -> BTreeSet<usize> {
    let gated = tree.modules.iter().filter(|module| module.is_proof).map(|module| module.file);
    let proving = tree.sources.iter().enumerate().filter(|(_, source)| source.proves).map(|(file, _)| file);
    gated.chain(proving).filter(|&file| tree.sources[file].formulas.is_empty()).collect()
}
