//! The theme of a book: its own folder `theme`, or the one here, which is compiled in.

use std::path::{Path, PathBuf};

use anyhow::Result;
use tempfile::TempDir;

use super::output::write;

/// Style sheets, in addition to those of mdBook.
pub(super) const SHEETS: [&str; 2] = ["book.css", "code.css"];

/// Each file of the theme: its path and its bytes.
macro_rules! files {
    ($($path:literal),* $(,)?) => {
        [$(($path, include_bytes!(concat!("../../theme/", $path)))),*]
    };
}
const FILES: [(&str, &[u8]); 12] = files![
    "book.css",
    "code.css",
    "fonts/fonts.css",
    "fonts/inter.woff2",
    "fonts/jetbrains-mono.woff2",
    "fonts/jetbrains-mono-greek.woff2",
    "fonts/stix-two-math.woff2",
    "fonts/stix-two-text.woff2",
    "fonts/stix-two-text-italic.woff2",
    "fonts/INTER-LICENSE.txt",
    "fonts/JETBRAINS-MONO-LICENSE.txt",
    "fonts/STIX-TWO-LICENSE.txt",
];

/// A theme in a folder, where mdBook reads it.
pub(super) enum Theme {
    Own(PathBuf),
    CompiledIn(TempDir),
}

impl Theme {
    /// The theme of the book in this folder.
    pub(super) fn of(book: &Path) -> Result<Self> {
        let own = book.join("theme");
        if own.exists() {
            return Ok(Self::Own(own));
        }
        let folder = tempfile::tempdir()?;
        for (path, bytes) in FILES {
            write(&folder.path().join(path), bytes)?;
        }
        Ok(Self::CompiledIn(folder))
    }

    pub(super) fn folder(&self) -> &Path {
        match self {
            Self::Own(folder) => folder,
            Self::CompiledIn(folder) => folder.path(),
        }
    }
}
