//! Finds all missing evidence that a formula needs before it counts as proved.

use crate::book::coverage::directives;
use crate::console::{bold, count, red};
use crate::project::Project;
use jointproof::catalog::AnyFormula;
use jointproof::formula::proof::Flag;
use jointproof::formula::{Field, Provenance};
use std::collections::HashSet;

/// A requirement on every formula.
pub(crate) struct Requirement {
    /// A short description.
    pub(crate) what: &'static str,
    /// Where it belongs and how it is written; `{id}` and `{command}` are replaced by those of the formula and the project.
    how: &'static str,
    /// Whether it is still unmet after `new` has written a skeleton.
    pub(crate) is_of_author: bool,
    is_met: Box<dyn Fn(&Candidate<'_>) -> bool>,
}

/// A formula to be checked.
struct Candidate<'a> {
    project: &'a Project,
    formula: &'a dyn AnyFormula,
    /// The formulas that have an entry; `None` for a project without a book.
    entries: Option<&'a HashSet<String>>,
}

impl Requirement {
    fn new(what: &'static str, how: &'static str, is_met: fn(&Candidate<'_>) -> bool) -> Self {
        Self { what, how, is_of_author: true, is_met: Box::new(is_met) }
    }

    fn met_by_skeleton(self) -> Self {
        Self { is_of_author: false, ..self }
    }

    /// Where it belongs and how it is written, for the formula with this identifier.
    pub(crate) fn how(&self, project: &Project, id: &str) -> String {
        self.how.replace("{id}", id).replace("{command}", project.command())
    }
}

/// All requirements on a formula of this project.
pub(crate) fn requirements(project: &Project) -> Vec<Requirement> {
    let mut requirements = vec![
        Requirement::new("an identifier", "`family.name` in `SPEC`, of small letters, digits and _", |candidate| {
            candidate.formula.spec().id.split_once('.').is_some_and(|(family, name)| is_name(family) && is_name(name))
        })
        .met_by_skeleton(),
        Requirement::new("a title", "the second argument of `Spec::new`", |candidate| {
            !candidate.formula.spec().title.is_empty()
        }),
        Requirement::new(
            "source and provenance",
            "in `SPEC`: `Document::new(\"…\").link(\"…\")` or one of its constants, then `.printed(section)`, or \
             `.reconstructed(section, reason)`, or `.ours(section, reason)`",
            |candidate| {
                let source = candidate.formula.spec().source;
                let is_explained = source.provenance == Provenance::Printed || !source.provenance.why().is_empty();
                !source.document.title.is_empty() && is_explained
            },
        ),
        Requirement::new("its equation", "`.equation(r\"…\")` in `SPEC`", |candidate| {
            !candidate.formula.spec().latex.is_empty()
        }),
        Requirement::new("symbols and meanings", "a `Quantity` for every input and output", |candidate| {
            candidate.formula.inputs().iter().chain(candidate.formula.outputs()).all(is_described)
        }),
        Requirement::new("a case worked by hand", "`Case::hand` in `Proved::cases`", |candidate| {
            candidate.formula.cases().contains(&Flag::Hand)
        }),
        Requirement::new(
            "a hard case",
            "`Case::hard`: zero, cancelled, tiny, huge; many are in `proof::hard`",
            |candidate| candidate.formula.cases().contains(&Flag::Hard),
        ),
        Requirement::new("a law", "`Law::new` in `Proved::laws`: what physics requires of it", |candidate| {
            !candidate.formula.laws().is_empty()
        }),
        Requirement::new("its golden file", "{command} golden --filter {id}", |candidate| {
            candidate.project.golden_file(candidate.formula.spec().id).exists()
        }),
        Requirement::new("an entry in the book", "{{#formula {id}}} in a chapter", |candidate| {
            candidate.entries.is_none_or(|entries| entries.contains(candidate.formula.spec().id))
        })
        .met_by_skeleton(),
    ];
    requirements.extend(project.extension.requirements.iter().map(|&(what, is_met, how)| Requirement {
        what,
        how,
        is_of_author: true,
        is_met: Box::new(move |candidate| is_met(candidate.project, candidate.formula.spec().id)),
    }));
    requirements
}

/// The unmet requirements of these formulas, one block per formula; empty if there are none. Without the repository
/// they cannot be checked, and the result is empty too.
pub(crate) fn missing(project: &Project, formulas: &[&dyn AnyFormula]) -> anyhow::Result<Vec<String>> {
    if !project.is_here() {
        return Ok(Vec::new());
    }
    let requirements = requirements(project);
    let entries = entries(project)?;
    let block = |formula: &&dyn AnyFormula| {
        let candidate = Candidate { project, formula: *formula, entries: entries.as_ref() };
        let id = formula.spec().id;
        let line = |requirement: &Requirement| format!("    {}: {}\n", requirement.what, requirement.how(project, id));
        let lines: String =
            requirements.iter().filter(|requirement| !(requirement.is_met)(&candidate)).map(line).collect();
        (!lines.is_empty()).then(|| format!("{} {} lacks\n{lines}", red("off"), bold(id)))
    };
    Ok(formulas.iter().filter_map(block).collect())
}

/// How many formulas have unmet requirements, for a summary.
pub(crate) fn summary(formulas: usize, missing: &[String]) -> String {
    let formulas = count(formulas, "formula");
    match missing.len() {
        0 => format!("{formulas}, nothing missing"),
        debtors => format!("{formulas}, {debtors} owing"),
    }
}

/// The formulas that have an entry; `None` for a project without a book.
fn entries(project: &Project) -> anyhow::Result<Option<HashSet<String>>> {
    if !project.has_book() {
        return Ok(None);
    }
    Ok(Some(directives(project.root())?.into_iter().map(|directive| directive.id).collect()))
}

fn is_described(field: &Field) -> bool {
    !field.quantity.latex.is_empty() && !field.quantity.meaning.is_empty()
}

/// Whether this is a valid name of a family or a formula.
pub(crate) fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::formula::proof::Proved;
    use jointproof::formula::quantity::{Domain, Quantity, Unit};
    use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
    use jointproof::{Scalar, fields};

    const NAMELESS: Quantity = Quantity::scalar("", Unit::ONE, Domain::Real, "");
    fields! { struct Input<T> { x: T = NAMELESS } }
    fields! { struct Output<T> { y: T = NAMELESS } }

    #[derive(Clone, Copy)]
    struct Bare;

    impl Formula for Bare {
        const SPEC: Spec = Spec::new("bare", "", Document::new("").ours("", ""));
        type Inputs<T: Component> = Input<T>;
        type Outputs<T: Component> = Output<T>;
        #[inline]
        fn eval<D: Scalar>(i: &Input<D>) -> Output<D> {
            Output { y: i.x }
        }
        #[inline]
        fn jacobian<D: Scalar>(_: &Input<D>) -> Jacobian<Self, D> {
            Output { y: Input { x: D::one() } }
        }
    }

    impl Proved for Bare {}

    #[test]
    fn an_input_needs_a_symbol_and_a_meaning() {
        const fn quantity(latex: &'static str, meaning: &'static str) -> Quantity {
            Quantity::scalar(latex, Unit::ONE, Domain::Real, meaning)
        }
        static QUANTITIES: [Quantity; 3] = [quantity("x", "a number"), quantity("x", ""), quantity("", "a number")];
        let described = QUANTITIES.each_ref().map(|quantity| is_described(&Field::new("x", quantity)));
        assert_eq!(described, [true, false, false]);
    }

    #[test]
    fn a_name_is_of_small_letters_digits_and_underscores_and_begins_with_a_letter() {
        for name in ["a", "a1", "contact_force_2d", "x_"] {
            assert!(is_name(name), "{name}");
        }
        for name in ["", "1a", "_a", "A", "aB", "a-b", "a b", "ä"] {
            assert!(!is_name(name), "{name}");
        }
    }

    #[test]
    fn a_skeleton_pays_what_can_be_known_and_leaves_the_rest_to_its_author() {
        let project =
            Project::new("bare", env!("CARGO_MANIFEST_DIR"), &[]).with_requirement("a poem", |_, _| false, "");
        let requirements = requirements(&project);
        let skeletal: Vec<_> = requirements
            .iter()
            .filter(|requirement| !requirement.is_of_author)
            .map(|requirement| requirement.what)
            .collect();
        assert_eq!((skeletal, requirements.len()), (vec!["an identifier", "an entry in the book"], 11));
    }

    #[test]
    fn all_that_is_owed_is_named_at_once() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join("book/src")).unwrap();
        let project = Project::new("bare", env!("CARGO_MANIFEST_DIR"), &[&Bare])
            .with_requirement("a poem", |_, id| id == "other.formula", "in `{id}.txt`")
            .in_folder(folder.path().to_str().unwrap());
        let missing = missing(&project, project.catalog()).unwrap();
        assert_eq!(missing.len(), 1);
        for requirement in requirements(&project) {
            let line = format!("    {}: {}\n", requirement.what, requirement.how(&project, "bare"));
            assert!(missing[0].contains(&line), "{line:?} is not in\n{}", missing[0]);
        }
        assert!(missing[0].ends_with("    a poem: in `bare.txt`\n"), "{}", missing[0]);
        assert_eq!(summary(1, &missing), "1 formula, 1 owing");
    }
}
