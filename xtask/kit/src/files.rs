//! Writing files, and computing digests of them.

use anyhow::Context;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The SHA-256 of a content, in hexadecimal digits.
pub(crate) fn digest(content: impl AsRef<[u8]>) -> String {
    Sha256::digest(content).iter().fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}

/// The first digits of the digest, enough to distinguish versions.
pub(crate) fn short_digest(content: impl AsRef<[u8]>) -> String {
    let mut digest = digest(content);
    digest.truncate(16);
    digest
}

/// The JSON files of a folder, in order, except those whose base name is known; none if there is no folder.
pub(crate) fn json_but(folder: &Path, is_known: impl Fn(&str) -> bool) -> anyhow::Result<Vec<PathBuf>> {
    with_extension_but(folder, "json", is_known)
}

/// The same of files with another extension.
pub(crate) fn with_extension_but(
    folder: &Path,
    wanted: &str,
    is_known: impl Fn(&str) -> bool,
) -> anyhow::Result<Vec<PathBuf>> {
    let cannot = || format!("cannot list {}", folder.display());
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.with_context(cannot)?,
    };
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.with_context(cannot)?.path();
        let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == wanted) && !is_known(&name) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Writes a file under a temporary name next to it and renames it, so that an interrupted run leaves the old one
/// intact. A file that already contains the text is not touched. Returns whether it was written.
///
/// # Errors
/// An error of the file system, with the path.
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

/// The same for content that is written piece by piece and not compared beforehand.
///
/// # Errors
/// As for [`write()`].
pub fn write_with<T>(path: &Path, content: impl FnOnce(&mut File) -> anyhow::Result<T>) -> anyhow::Result<T> {
    let shown = path.display();
    let directory = path.parent().with_context(|| format!("{shown} has no directory"))?;
    let directory = if directory.as_os_str().is_empty() { Path::new(".") } else { directory };
    std::fs::create_dir_all(directory).with_context(|| format!("cannot make {}", directory.display()))?;
    let mut file = builder().tempfile_in(directory).with_context(|| format!("cannot write beside {shown}"))?;
    // What the content itself could not be made for is not an error of the file.
    let made = content(file.as_file_mut()).map_err(|error| {
        let is_of_file = error.is::<std::io::Error>();
        if is_of_file { error.context(format!("cannot write {shown}")) } else { error }
    })?;
    file.persist(path).with_context(|| format!("cannot rename to {shown}"))?;
    Ok(made)
}

fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".writing-");
    // The default would be readable by the owner only.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The digest of this text is given in the standard.
    #[test]
    fn a_digest_is_that_of_sha_256_in_hexadecimal_digits() {
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(digest("abc"), expected);
        assert_eq!(short_digest("abc"), expected[..16]);
    }

    #[test]
    fn a_file_is_written_once_into_a_folder_that_is_made_and_nothing_is_left_beside_it() {
        let root = tempfile::tempdir().unwrap();
        let path = root.path().join("a/b.txt");
        assert!(write(&path, "one").unwrap() && !write(&path, "one").unwrap() && write(&path, "two").unwrap());
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(std::fs::read_dir(root.path().join("a")).unwrap().count(), 1);
        // A file that cannot be written is left unchanged.
        let full = || std::io::Error::other("no more");
        let refused = write_with(&path, |_| Err::<(), _>(full().into())).unwrap_err();
        assert_eq!(format!("{refused:#}"), format!("cannot write {}: no more", path.display()));
        // What is no error of the file stays as it is.
        let undefined = write_with(&path, |_| -> anyhow::Result<()> { anyhow::bail!("undefined") }).unwrap_err();
        assert_eq!(format!("{undefined:#}"), "undefined");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "two");
    }

    /// Readable by all like other files, but writable only by the owner, and not executable.
    #[cfg(unix)]
    #[test]
    fn others_may_read_what_is_written() {
        use std::os::unix::fs::PermissionsExt;
        let root = tempfile::tempdir().unwrap();
        let [ours, any] = ["ours", "any"].map(|name| root.path().join(name));
        write(&ours, "one").unwrap();
        std::fs::write(&any, "one").unwrap();
        let [ours, any] = [ours, any].map(|path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777);
        assert_eq!(ours, any & 0o644);
    }
}
