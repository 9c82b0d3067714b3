//! How much pages load.

use std::fmt;
use std::fs;
use std::path::Path;

use anyhow::{Context as _, Result};
use serde_json::Value;

use super::FOLDER;
use super::browser::Browser;

/// What the program and one formula should have together.
const WANTED: u64 = 15_000;

/// Compressed bytes.
#[derive(Default)]
pub(super) struct Sizes {
    /// What a page loads.
    pub(super) page: u64,
    /// With what the first calculator that is opened loads beside its formula.
    pub(super) shared: u64,
    /// Of every formula.
    pub(super) all: Vec<(u64, String)>,
}

impl Sizes {
    pub(super) fn of(out: &Path, browser: &mut Browser) -> Result<Self> {
        let mut size = |name: &str| -> Result<u64> {
            let text = fs::read_to_string(out.join(FOLDER).join(name))?;
            let size = browser.evaluate(&format!("compressed({})", Value::from(text)))?;
            size.as_u64().context("the page did not compress")
        };
        let page = size("calculator.js")? + size("calculator.css")?;
        let shared = page + size("runtime.js")? + size("panel.js")?;
        let mut all = Vec::new();
        for entry in fs::read_dir(out.join(FOLDER))? {
            let name = entry?.file_name().to_string_lossy().into_owned();
            // Formulas have a dot in their names.
            if let Some(id) = name.strip_suffix(".js").filter(|id| id.contains('.')) {
                all.push((size(&name)?, id.to_owned()));
            }
        }
        all.sort();
        Ok(Self { page, shared, all })
    }
}

impl fmt::Display for Sizes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { page, shared, all } = self;
        write!(f, "compressed {page} bytes a page, {shared} with a calculator open")?;
        let large: Vec<_> = all.iter().filter(|(size, _)| shared + size > WANTED).collect();
        write!(f, ", and with its formula below {WANTED} for {} of {}", all.len() - large.len(), all.len())?;
        large.iter().try_for_each(|(size, id)| write!(f, "\n    {id}: {} bytes", shared + size))
    }
}
