//! What the sources of a project are, as a number: compiled into its program, and compared with the folder that it judges.
//!
//! A build script may use this file as a module: it needs only the standard library.

use std::hash::{DefaultHasher, Hasher};
use std::path::Path;

/// A hash of everything in the folder `src`; another version of the standard library may give another.
#[must_use]
pub fn sources(root: &Path) -> u64 {
    let mut hasher = DefaultHasher::new();
    hash(root, Path::new("src"), &mut hasher);
    hasher.finish()
}

/// Hashes a file, or everything in a folder, with paths relative to the root, so that the result does not depend on its location.
pub(crate) fn hash(root: &Path, path: &Path, hasher: &mut impl Hasher) {
    if let Ok(entries) = std::fs::read_dir(root.join(path)) {
        let mut paths: Vec<_> = entries.flatten().map(|entry| path.join(entry.file_name())).collect();
        paths.sort();
        for path in paths {
            hash(root, &path, hasher);
        }
    } else {
        hasher.write(path.to_string_lossy().as_bytes());
        hasher.write(&std::fs::read(root.join(path)).unwrap_or_default());
    }
}
