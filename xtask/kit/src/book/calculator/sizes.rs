//! The amount of data that pages load.

use std::fmt;
use std::fs;
use std::path::Path;

use anyhow::{Context as _, Result};
use serde_json::Value;

use super::{CASES, FOLDER};
use crate::book::browser::Browser;

/// The target for the size of the program with one formula.
pub(super) const WANTED: u64 = 15_000;

/// Compressed bytes.
#[derive(Default)]
pub(super) struct Sizes {
    /// The scripts of a page.
    pub(super) page: u64,
    /// Including what the first opened calculator loads in addition to its formula.
    pub(super) shared: u64,
    /// The code of every formula, without and with the golden cases of its menu.
    pub(super) all: Vec<([u64; 2], String)>,
}

impl Sizes {
    pub(super) fn of(out: &Path, browser: &mut Browser) -> Result<Self> {
        let read = |name: &str| fs::read_to_string(out.join(FOLDER).join(name));
        let mut compressed = |text: &str| -> Result<u64> {
            let size = browser.evaluate(&format!("compressed({})", Value::from(text)))?;
            size.as_u64().context("the page did not compress")
        };
        let mut size = |name: &str| compressed(&read(name)?);
        let page = size("calculator.js")? + size("calculator.css")?;
        let shared = page + size("runtime.js")? + size("panel.js")?;
        let mut all = Vec::new();
        for entry in fs::read_dir(out.join(FOLDER))? {
            let name = entry?.file_name().to_string_lossy().into_owned();
            // Formulas have a dot in their names.
            if let Some(id) = name.strip_suffix(".js").filter(|id| id.contains('.')) {
                let text = read(&name)?;
                let code = text.split(CASES).next().unwrap_or_default();
                all.push(([compressed(code)?, compressed(&text)?], id.to_owned()));
            }
        }
        Ok(Self::new(page, shared, all))
    }

    fn new(page: u64, shared: u64, mut all: Vec<([u64; 2], String)>) -> Self {
        all.sort();
        Self { page, shared, all }
    }
}

impl fmt::Display for Sizes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { page, shared, all } = self;
        write!(f, "compressed {page} bytes a page, {shared} with a calculator open")?;
        let large: Vec<_> = all.iter().filter(|([code, _], _)| shared + code > WANTED).collect();
        let middle = all.get(all.len() / 2).map_or(0, |([_, whole], _)| shared + whole);
        write!(f, ", {middle} with a formula and its golden cases in the middle of all;\n    ")?;
        write!(f, "code with the formula below {WANTED} for {} of {}", all.len() - large.len(), all.len())?;
        large.iter().try_for_each(|([code, whole], id)| {
            write!(f, "\n    {id}: {} bytes, {} with golden cases", shared + code, shared + whole)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Sizes;

    #[test]
    fn sizes_are_told_by_the_one_in_the_middle_and_those_that_are_large() {
        let all = [(300, 900), (20_000, 30_000), (100, 500)];
        let all = all.iter().map(|&(code, whole)| ([code, whole], format!("f.{code}"))).collect();
        assert_eq!(
            Sizes::new(1000, 2000, all).to_string(),
            "compressed 1000 bytes a page, 2000 with a calculator open, 2900 with a formula and its golden cases in the middle \
             of all;\n    code with the formula below 15000 for 2 of 3\n    f.20000: 22000 bytes, 32000 with golden cases"
        );
    }
}
