//! A table of a history: its bytes, and what it is about.

use std::fmt;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a table is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) enum Subject {
    Motions,
    Loads,
    Pressures,
}

/// A table: a file, or its text.
#[derive(Clone)]
pub struct Table {
    name: String,
    source: Source,
}

#[derive(Clone)]
enum Source {
    File(PathBuf),
    Text(Arc<[u8]>),
}

impl Table {
    /// The table in a file. Its name in messages is that of the path.
    pub fn file(path: &Path) -> Self {
        Self::file_called(path, &path.display().to_string())
    }

    /// The table in a file, which messages call by this name.
    pub(in crate::scene) fn file_called(path: &Path, name: &str) -> Self {
        Self { name: name.into(), source: Source::File(path.into()) }
    }

    /// The table in a text, which messages call by this name.
    pub fn text(name: &str, text: impl Into<Arc<[u8]>>) -> Self {
        Self { name: name.into(), source: Source::Text(text.into()) }
    }

    /// Its name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Begins to read it.
    pub(in crate::scene) fn open(&self) -> io::Result<Summed> {
        let bytes: Box<dyn Read + Send + Sync> = match &self.source {
            Source::File(path) => Box::new(File::open(path)?),
            Source::Text(text) => Box::new(Cursor::new(Arc::clone(text))),
        };
        Ok(Summed { bytes, sum: crc32fast::Hasher::new() })
    }
}

impl fmt::Debug for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Table").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Bytes with their checksum so far, by which a table that has changed is recognised.
pub(in crate::scene) struct Summed {
    bytes: Box<dyn Read + Send + Sync>,
    sum: crc32fast::Hasher,
}

impl Summed {
    /// The checksum of what has been read.
    pub(in crate::scene) fn sum(&self) -> u32 {
        self.sum.clone().finalize()
    }
}

impl Read for Summed {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        self.sum.update(&buffer[..count]);
        Ok(count)
    }
}
