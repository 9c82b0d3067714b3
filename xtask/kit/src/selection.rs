//! The formulas and elements that a command works on.

use crate::outcome::Usage;
use crate::project::Project;
use jointproof::catalog::{AnyElement, AnyFormula};

/// Some formulas of a catalog.
pub(crate) type Formulas = Vec<&'static dyn AnyFormula>;
/// Some elements of a catalog.
pub(crate) type Elements = Vec<&'static dyn AnyElement>;

/// The element of an identifier.
pub(crate) fn element(project: &Project, id: &str) -> Result<&'static dyn AnyElement, Usage> {
    let ids = || project.elements().iter().map(|element| element.spec().id).collect::<Vec<_>>().join(", ");
    let element = project.elements().iter().find(|element| element.spec().id == id);
    element.copied().ok_or_else(|| Usage(format!("--element '{id}' is no element, but there are {}", ids())))
}

/// `--filter`
#[derive(clap::Args)]
pub(crate) struct Selection {
    /// Only formulas, or elements, whose identifier matches this pattern; `*` matches anything
    #[arg(long, value_name = "GLOB")]
    filter: Option<String>,
}

impl Selection {
    /// Every formula.
    pub(crate) const ALL: Self = Self { filter: None };

    /// The formulas whose identifier matches this pattern.
    pub(crate) fn of(pattern: &str) -> Self {
        Self { filter: Some(pattern.to_owned()) }
    }

    /// Whether nothing is filtered out.
    pub(crate) fn is_all(&self) -> bool {
        self.filter.is_none()
    }

    /// The formulas selected, in the order of the catalog.
    pub(crate) fn formulas(&self, project: &Project) -> anyhow::Result<Formulas> {
        let catalog = project.catalog();
        let Some(filter) = &self.filter else { return Ok(catalog.to_vec()) };
        let is_asked = self.is_asked()?;
        let selected: Vec<_> = catalog.iter().copied().filter(|formula| is_asked(formula.spec().id)).collect();
        if selected.is_empty() {
            return Err(Usage(format!("--filter '{filter}' matches no formula; {}", project.instead_of(filter))).into());
        }
        Ok(selected)
    }

    /// The formulas and the elements selected, for a command that works on both.
    pub(crate) fn formulas_and_elements(&self, project: &Project) -> anyhow::Result<(Formulas, Elements)> {
        let is_asked = self.is_asked()?;
        let elements: Vec<_> =
            project.elements().iter().copied().filter(|element| is_asked(element.spec().id)).collect();
        let is_of_elements_alone = !elements.is_empty() && !project.catalog().iter().any(|one| is_asked(one.spec().id));
        let formulas = if is_of_elements_alone { Vec::new() } else { self.formulas(project)? };
        Ok((formulas, elements))
    }

    /// A predicate that tells whether the formula with an identifier is selected.
    pub(crate) fn is_asked(&self) -> Result<impl Fn(&str) -> bool + use<>, Usage> {
        let pattern = self.filter.as_deref().unwrap_or("*");
        let glob = globset::Glob::new(pattern).map_err(|error| Usage(format!("--filter is not a pattern: {error}")))?;
        let matcher = glob.compile_matcher();
        Ok(move |id: &str| matcher.is_match(id))
    }
}
