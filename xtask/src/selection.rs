//! Which formulas a command works on.

use crate::outcome::Usage;
use crate::project::Project;
use jointproof::catalog::AnyFormula;

/// `--filter`
#[derive(clap::Args)]
pub(crate) struct Selection {
    /// Only formulas whose identifier matches this pattern; `*` matches anything
    #[arg(long, value_name = "GLOB")]
    filter: Option<String>,
}

impl Selection {
    /// Every formula.
    pub(crate) const ALL: Self = Self { filter: None };

    /// Whether nothing is filtered out.
    pub(crate) fn is_all(&self) -> bool {
        self.filter.is_none()
    }

    /// The formulas selected, in the order of the catalog.
    pub(crate) fn formulas(&self, project: &Project) -> anyhow::Result<Vec<&'static dyn AnyFormula>> {
        let catalog = project.catalog();
        let Some(filter) = &self.filter else { return Ok(catalog.to_vec()) };
        let glob = globset::Glob::new(filter).map_err(|error| Usage(format!("--filter is not a pattern: {error}")))?;
        let matcher = glob.compile_matcher();
        let selected: Vec<_> = catalog.iter().copied().filter(|f| matcher.is_match(f.spec().id)).collect();
        if selected.is_empty() {
            let ids: Vec<_> = catalog.iter().map(|formula| formula.spec().id).collect();
            return Err(
                Usage(format!("--filter '{filter}' matches no formula; there are\n  {}", ids.join("\n  "))).into()
            );
        }
        Ok(selected)
    }
}
