//! How files are written, and told from one another.

use anyhow::Context;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Write;
use std::path::Path;

/// The SHA-256 of a content, in hexadecimal digits.
pub(crate) fn digest(content: impl AsRef<[u8]>) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The first digits of it, which are enough to tell one version from another.
pub(crate) fn short_digest(content: impl AsRef<[u8]>) -> String {
    let mut digest = digest(content);
    digest.truncate(16);
    digest
}

/// Writes a file under a temporary name beside it and renames it, so that an interrupted run leaves the old one whole.
/// A file that already holds the text is not touched. Returns whether it was written.
///
/// # Errors
/// What the file system says, and where.
pub fn write(path: &Path, text: &str) -> anyhow::Result<bool> {
    if std::fs::read(path).is_ok_and(|present| present == text.as_bytes()) {
        return Ok(false);
    }
    write_with(path, |file| {
        file.write_all(text.as_bytes())?;
        Ok(file.sync_all()?)
    })?;
    Ok(true)
}

/// The same for what is written piece by piece, and not compared before.
///
/// # Errors
/// As [`write()`].
pub fn write_with(path: &Path, content: impl FnOnce(&mut File) -> anyhow::Result<()>) -> anyhow::Result<()> {
    let shown = path.display();
    let directory = path.parent().with_context(|| format!("{shown} has no directory"))?;
    let directory = if directory.as_os_str().is_empty() { Path::new(".") } else { directory };
    std::fs::create_dir_all(directory).with_context(|| format!("cannot make {}", directory.display()))?;
    let mut file = builder().tempfile_in(directory).with_context(|| format!("cannot write beside {shown}"))?;
    content(file.as_file_mut()).with_context(|| format!("cannot write {shown}"))?;
    file.persist(path).with_context(|| format!("cannot rename to {shown}"))?;
    Ok(())
}

fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".writing-");
    // Else only the owner could read it.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder
}
