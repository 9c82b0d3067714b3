//! Which folder may use which: only those above it in the table of `ARCHITECTURE.md`, and formulas nothing of their evidence.

use super::architecture::{Order, PAGE, folder};
use super::edges::{Edges, Place};
use super::finding::Finding;
use super::tree::Tree;
use std::collections::BTreeSet;

/// The part of a folder that has its own place in the order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Layer {
    /// Numbers, quantities, errors.
    Ground,
    /// The definition of a formula.
    Formula,
    /// The vocabulary of evidence: cases, kinks, laws, alternative methods.
    Proof,
    /// Verification and measurement of formulas.
    Toolkit,
    /// Folders in which formulas are defined.
    Formulas,
    /// Every formula by identifier, and scenes.
    Above,
}

impl Layer {
    /// The layer of a file; `None` for `lib.rs`, which only lists the modules, and for files of other crates.
    fn of(path: &str) -> Option<Self> {
        let within = path.strip_prefix("src/").filter(|path| *path != "lib.rs")?;
        let is = |name: &str| within == format!("{name}.rs") || within.starts_with(&format!("{name}/"));
        Some(match folder(path)? {
            "number" => Self::Ground,
            "formula" if is("formula/error") || is("formula/quantity") => Self::Ground,
            "formula" if is("formula/proof") => Self::Proof,
            "formula" => Self::Formula,
            "toolkit" => Self::Toolkit,
            "catalog" | "scene" => Self::Above,
            _ => Self::Formulas,
        })
    }
}

/// Every use that violates the order. Evidence stands next to a formula, and may use the toolkit and any formula.
pub(super) fn crossed(tree: &Tree, edges: &Edges, order: &Order) -> Vec<Finding> {
    let evidence = evidence(tree);
    let findings = edges.iter().filter_map(|(&(from, to), Place { line, text })| {
        let [path, used] = [from, to].map(|file| tree.sources[file].path.as_str());
        let (layer, below) = (Layer::of(path)?, Layer::of(used)?);
        let is_evidence = layer == Layer::Formulas && evidence.contains(&from);
        let proves = matches!(below, Layer::Proof | Layer::Toolkit);
        let why = match (layer, below) {
            (Layer::Formulas, Layer::Formulas) if is_evidence => return None,
            (Layer::Formulas, _) if proves && is_evidence => return None,
            (Layer::Formulas, _) if proves && !tree.sources[from].formulas.is_empty() => {
                "a file of formulas imports neither `proof` nor `verify` nor `measure`; move the evidence to a file beside it".to_owned()
            }
            (Layer::Formulas, _) if proves => {
                "formulas and connectors compile without what proves them; move it to the evidence beside them".to_owned()
            }
            (Layer::Ground | Layer::Formula | Layer::Proof, Layer::Ground | Layer::Formula | Layer::Proof) if layer < below => {
                "numbers, quantities and errors stand below what a formula is, and that below what is said about it; move it there".to_owned()
            }
            _ => {
                let [name, used] = [folder(path)?, folder(used)?];
                if order.place(name)? >= order.place(used)? {
                    return None;
                }
                format!("{PAGE} has `{name}` below `{used}`; hand it in, or move one of them")
            }
        };
        Some(Finding::new(path, *line, format!("`{text}`: {why}")))
    });
    findings.collect()
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
    match Layer::of(path)? {
        Layer::Formulas => Some(Part::Formulas),
        Layer::Above => None,
        _ => (!path.starts_with("src/toolkit/measure")).then_some(Part::Common),
    }
}

/// The files without a formula that prove one, or that are compiled only for evidence.
fn evidence(tree: &Tree) -> BTreeSet<usize> {
    let gated = tree.modules.iter().filter(|module| module.is_proof).map(|module| module.file);
    let proving = tree.sources.iter().enumerate().filter(|(_, source)| source.proves).map(|(file, _)| file);
    gated.chain(proving).filter(|&file| tree.sources[file].formulas.is_empty()).collect()
}
