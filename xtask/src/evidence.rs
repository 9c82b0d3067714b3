//! What was executed: kept between commands, and shown in the book.
//!
//! A record counts only for the code it was made with: each carries a fingerprint of the sources and golden files, and
//! one of another version is as good as none.

use crate::files;
use crate::project::Project;
use jointproof::verify::Audit;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hasher};
use std::path::Path;

/// What the last golden check and audit found about this version of the code.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Evidence {
    fingerprint: u64,
    /// By formula.
    pub(crate) golden: BTreeMap<String, GoldenCheck>,
    /// By formula.
    pub(crate) audits: BTreeMap<String, Audit>,
}

/// What a golden check compared.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct GoldenCheck {
    /// Cases regenerated and compared.
    pub(crate) cases: usize,
    /// Whether the file was what the code says, byte for byte.
    pub(crate) same: bool,
}

impl Evidence {
    /// The evidence on this version of the code; empty if there is none.
    pub(crate) fn load(project: &Project) -> Self {
        let fingerprint = fingerprint(project);
        let text = std::fs::read_to_string(path(project)).unwrap_or_default();
        let stored: Option<Self> = serde_json::from_str(&text).ok();
        stored.filter(|stored| stored.fingerprint == fingerprint).unwrap_or(Self { fingerprint, ..Self::default() })
    }

    /// Keeps it.
    pub(crate) fn save(&self, project: &Project) -> anyhow::Result<()> {
        files::write(&path(project), &serde_json::to_string_pretty(self)?).map(drop)
    }
}

fn path(project: &Project) -> std::path::PathBuf {
    project.kept("evidence.json")
}

/// A hash of all sources and golden files.
pub(crate) fn fingerprint(project: &Project) -> u64 {
    let mut hasher = DefaultHasher::new();
    for directory in ["src", "golden"] {
        add(&project.root().join(directory), &mut hasher);
    }
    hasher.finish()
}

fn add(path: &Path, hasher: &mut impl Hasher) {
    if let Ok(entries) = std::fs::read_dir(path) {
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        for path in paths {
            add(&path, hasher);
        }
    } else {
        hasher.write(path.to_string_lossy().as_bytes());
        hasher.write(&std::fs::read(path).unwrap_or_default());
    }
}
