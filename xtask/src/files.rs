//! Where things are, and how they are written.

use anyhow::Context;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The root of the workspace; tests set `JOINTPROOF_ROOT` to work on a copy.
pub(crate) fn root() -> &'static Path {
    static ROOT: LazyLock<PathBuf> = LazyLock::new(|| {
        let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
        std::env::var_os("JOINTPROOF_ROOT").map_or_else(|| xtask.parent().unwrap_or(xtask).to_path_buf(), PathBuf::from)
    });
    &ROOT
}

/// Where reports and evidence are kept between commands.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join("jointproof")
}

/// Writes a file under a temporary name beside it and renames it, so that an interrupted run leaves the old one whole.
/// A file that already holds the text is not touched. Returns whether it was written.
pub(crate) fn write(path: &Path, text: &str) -> anyhow::Result<bool> {
    if std::fs::read(path).is_ok_and(|present| present == text.as_bytes()) {
        return Ok(false);
    }
    let shown = path.display();
    let directory = path.parent().with_context(|| format!("{shown} has no directory"))?;
    std::fs::create_dir_all(directory).with_context(|| format!("cannot make {}", directory.display()))?;
    let mut file = tempfile::Builder::new()
        .prefix(".writing-")
        .permissions(readable())
        .tempfile_in(directory)
        .with_context(|| format!("cannot write beside {shown}"))?;
    file.write_all(text.as_bytes())
        .and_then(|()| file.as_file().sync_all())
        .with_context(|| format!("cannot write {shown}"))?;
    file.persist(path).with_context(|| format!("cannot rename to {shown}"))?;
    Ok(true)
}

#[cfg(unix)]
fn readable() -> std::fs::Permissions {
    std::os::unix::fs::PermissionsExt::from_mode(0o644)
}

#[cfg(not(unix))]
fn readable() -> std::fs::Permissions {
    let mut permissions = std::fs::metadata(root()).map(|root| root.permissions());
    permissions.as_mut().map(|permissions| permissions.set_readonly(false)).ok();
    permissions.unwrap_or_else(|_| unreachable!("the workspace has a root"))
}

/// A path as one would type it from the root.
pub(crate) fn shown(path: &Path) -> String {
    path.strip_prefix(root()).unwrap_or(path).display().to_string()
}
