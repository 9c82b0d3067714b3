//! The location in the sources of a claim about a formula.

use crate::book::{CodeSpan, functions};
use crate::project::Project;
use crate::since::Changes;
use jointproof::catalog::AnyFormula;
use std::path::Path;

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    /// Its path from the root of the project, with forward slashes.
    pub(crate) file: String,
    /// Counted from 1.
    pub(crate) line: usize,
}

/// The place of a claim. If it is known what has changed: the first changed line of the function that the claim is about, of the
/// formula's other functions, or of what the formula depends on. Else the head of the function: for derivatives `jacobian` or
/// `linearized`, else `eval`. For a formula defined by a macro it is the file of its module, and for one whose sources are
/// not here the manifest.
pub(crate) fn of_claim(
    project: &Project,
    formula: &dyn AnyFormula,
    claim: &str,
    changes: Option<&Changes>,
) -> anyhow::Result<Place> {
    let is_derivative = ["Jacobian", "closed form", "derivative"].iter().any(|word| claim.contains(word));
    let order = if is_derivative { ["jacobian", "linearized", "eval"] } else { ["eval", "linearized", "jacobian"] };
    let mut spans = functions(project, formula)?;
    spans.sort_by_key(|span| order.iter().position(|name| span.name == *name));
    if let Some(changes) = changes {
        let within = |span: &CodeSpan| {
            let line = changes.first(Path::new(&span.file), span.first..=span.last)?;
            Some(Place { file: span.file.clone(), line })
        };
        let below = || {
            let (file, line) = changes.below(formula)?;
            Some(Place { file: file.to_string_lossy().replace('\\', "/"), line })
        };
        if let Some(place) = spans.iter().find_map(within).or_else(below) {
            return Ok(place);
        }
    }
    if let Some(CodeSpan { file, last, first, .. }) = spans.first() {
        return Ok(Place { file: file.clone(), line: head(project, file, *first, *last) });
    }
    let modules: Vec<_> = formula.path().split("::").skip(1).collect();
    let files = (1..modules.len()).rev().map(|depth| format!("src/{}.rs", modules[..depth].join("/")));
    let file = files.into_iter().find(|file| project.root().join(file).exists());
    Ok(Place { file: file.unwrap_or_else(|| "Cargo.toml".into()), line: 1 })
}

/// The line of `fn` after documentation and attributes.
fn head(project: &Project, file: &str, first: usize, last: usize) -> usize {
    let text = std::fs::read_to_string(project.root().join(Path::new(file))).unwrap_or_default();
    let lines = text.lines().enumerate().skip(first - 1).take(last + 1 - first);
    let is_head = |line: &str| line.trim_start().starts_with("fn ");
    lines.into_iter().find(|(_, line)| is_head(line)).map_or(first, |(line, _)| line + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;

    #[test]
    fn the_head_of_a_function_is_behind_its_documentation_and_attributes() {
        let root = tempfile::tempdir().unwrap();
        let text = "fn a() {}\n/// Doc.\n#[inline]\n    fn b() {\n}\nconst C: u8 = 1;\nfn d() {}\n";
        std::fs::write(root.path().join("a.rs"), text).unwrap();
        let project = Project::new("head", env!("CARGO_MANIFEST_DIR"), &[]).in_folder(root.path().to_str().unwrap());
        let of = |first, last| head(&project, "a.rs", first, last);
        assert_eq!([of(1, 1), of(2, 5), of(3, 4), of(4, 5), of(7, 7)], [1, 4, 4, 4, 7]);
        // If there is none, the first line.
        assert_eq!([of(2, 3), of(5, 6), head(&project, "none.rs", 8, 9)], [2, 5, 8]);
    }

    /// Without functions it is the module, and without that the manifest.
    #[test]
    fn a_claim_stands_at_the_nearest_place_that_there_is() {
        use jointproof::connector::slot::ContactForce;
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("place", env!("CARGO_MANIFEST_DIR"), &[]).in_folder(root.path().to_str().unwrap());
        let place = |claim: &str| {
            let Place { file, line } = of_claim(&project, &ContactForce, claim, None).unwrap();
            format!("{file}:{line}")
        };
        assert_eq!(ContactForce.path(), "jointproof::connector::slot::friction::ContactForce");
        assert_eq!(place("symmetry"), "Cargo.toml:1");
        let write = |file: &str, text: &str| crate::files::write(&root.path().join(file), text).unwrap();
        write("src/connector/slot.rs", "mod friction;\n");
        assert_eq!(place("symmetry"), "src/connector/slot.rs:1");
        write("src/connector/slot/friction.rs", "made! {}\n");
        assert_eq!(place("symmetry"), "src/connector/slot/friction.rs:1");
        let functions = "impl Formula for ContactForce {\n    fn eval() {}\n\n    fn linearized() {}\n}\n";
        write("src/connector/slot/friction.rs", functions);
        assert_eq!(place("symmetry"), "src/connector/slot/friction.rs:2");
        assert_eq!(place("derivative of the printed equation"), "src/connector/slot/friction.rs:4");
    }

    #[test]
    fn every_claim_has_a_place_and_nearly_every_formula_its_functions() {
        let project = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("../..");
        let mut found = 0;
        for formula in CATALOG {
            for (claim, head) in
                [("η of the closed-form Jacobian in f64", "fn jacobian"), ("η of the value in f64", "fn eval")]
            {
                let Place { file, line } = of_claim(&project, *formula, claim, None).unwrap();
                let text = std::fs::read_to_string(project.root().join(&file)).unwrap();
                let text = text.lines().nth(line - 1).unwrap();
                found += usize::from(text.contains(head));
                assert!(text.contains("fn ") || line == 1, "{}: {file}:{line}: {text}", formula.spec().id);
            }
        }
        assert!(found > CATALOG.len(), "{found} functions were found of {} formulas", CATALOG.len());
    }
}
