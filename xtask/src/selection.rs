//! Which formulas a command works on.

use anyhow::{Context, bail};
use jointproof::catalog::{AnyFormula, CATALOG};

/// `--filter`
#[derive(clap::Args)]
pub(crate) struct Selection {
    /// Only formulas whose identifier matches, as `slot.*` or `*.friction`
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
    pub(crate) fn formulas(&self) -> anyhow::Result<Vec<&'static dyn AnyFormula>> {
        let Some(filter) = &self.filter else { return Ok(CATALOG.to_vec()) };
        let glob = globset::Glob::new(filter).with_context(|| format!("--filter {filter} is not a pattern"))?;
        let matcher = glob.compile_matcher();
        let selected: Vec<_> = CATALOG.iter().copied().filter(|f| matcher.is_match(f.spec().id)).collect();
        if selected.is_empty() {
            let ids: Vec<_> = CATALOG.iter().map(|formula| formula.spec().id).collect();
            bail!("--filter {filter} matches no formula; there are {}", ids.join(", "));
        }
        Ok(selected)
    }
}
