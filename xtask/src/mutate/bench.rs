//! A copy of the tree, in which faults are planted, built and run. Nothing of it gets into what is shipped.

use super::fault::Fault;
use super::plant::{Planted, plant};
use anyhow::{Context, ensure};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// The crate that every switch asks.
const SWITCH: &str = include_str!("switch.rs.txt");
const SWITCH_MANIFEST: &str = "[package]\nname = \"planted\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n";
/// It is asked often.
const SWITCH_PROFILE: &str = "\n[profile.dev.package.planted]\nopt-level = 3\n";

/// The copy.
pub(super) struct Bench {
    root: PathBuf,
    folder: PathBuf,
    /// Every file of the project, from the root.
    files: Vec<String>,
}

impl Bench {
    /// Copies the files of the project at `root` that git knows or would be told of.
    ///
    /// # Errors
    /// What the file system or git says.
    pub(super) fn new(root: &Path, folder: PathBuf) -> anyhow::Result<Self> {
        let files = files(root)?;
        let bench = Self { root: root.to_path_buf(), folder, files };
        for file in &bench.files {
            bench.restore(file)?;
        }
        let known: BTreeSet<&str> = bench.files.iter().map(String::as_str).collect();
        for file in below(&bench.tree())? {
            if !known.contains(file.as_str()) && !file.starts_with("target/") && !file.ends_with("Cargo.lock") {
                fs::remove_file(bench.tree().join(&file))?;
            }
        }
        bench.keep("planted/Cargo.toml", SWITCH_MANIFEST)?;
        bench.keep("planted/src/lib.rs", SWITCH)?;
        Ok(bench)
    }

    /// The project.
    pub(super) fn root(&self) -> &Path {
        &self.root
    }

    /// The copy of the project.
    pub(super) fn tree(&self) -> PathBuf {
        self.folder.join("tree")
    }

    /// A file or folder beside the copy.
    pub(super) fn beside(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The Rust sources, by their paths from the root.
    ///
    /// # Errors
    /// What the file system says.
    pub(super) fn sources(&self) -> anyhow::Result<BTreeMap<String, String>> {
        let read = |file: &String| Ok((file.clone(), self.original(file)?));
        self.files.iter().filter(|file| is_source(file)).map(read).collect()
    }

    /// Writes faults into the copy, each at one of its places. Their numbers are their positions.
    ///
    /// # Errors
    /// What the file system says.
    pub(super) fn plant(
        &self,
        faults: &[(Fault, usize)],
        sources: &BTreeMap<String, String>,
    ) -> anyhow::Result<BTreeMap<String, Planted>> {
        let mut of_files: BTreeMap<&str, Vec<(usize, &Fault, usize)>> = BTreeMap::new();
        for (number, (fault, place)) in faults.iter().enumerate() {
            of_files.entry(&fault.file).or_default().push((number, fault, *place));
        }
        let mut all = BTreeMap::new();
        for (file, faults) in of_files {
            let planted = plant(sources.get(file).with_context(|| format!("there is no {file}"))?, &faults);
            all.insert(file.to_owned(), planted);
        }
        for file in self.files.iter().filter(|file| is_source(file) || is_manifest(file)) {
            match (all.get(file), is_manifest(file)) {
                (Some(planted), _) => self.put(file, &planted.text)?,
                (None, true) if self.is_built(file, faults) => self.put(file, &self.manifest(file)?)?,
                // Where there were faults before, the compiler has to be told that there are none.
                (None, _) if self.beside(&format!("texts/{file}")).exists() => self.put(file, &self.original(file)?)?,
                (None, _) => self.restore(file)?,
            }
        }
        Ok(all)
    }

    /// Whether this is the manifest of the workspace or of a package with faults.
    fn is_built(&self, manifest: &str, faults: &[(Fault, usize)]) -> bool {
        let folder = |manifest: &str| manifest.strip_suffix("Cargo.toml").map(str::to_owned).unwrap_or_default();
        let manifests: Vec<_> = self.files.iter().filter(|file| is_manifest(file)).map(|m| folder(m)).collect();
        let own =
            |file: &str| manifests.iter().filter(|folder| file.starts_with(folder.as_str())).max_by_key(|f| f.len());
        let this = folder(manifest);
        this.is_empty() || faults.iter().any(|(fault, _)| own(&fault.file) == Some(&this))
    }

    /// A manifest with the crate of the switch.
    fn manifest(&self, file: &str) -> anyhow::Result<String> {
        let text = self.original(file)?;
        let up = "../".repeat(1 + file.matches('/').count());
        let entry = format!("\n[dependencies]\nplanted = {{ path = \"{up}planted\" }}\n");
        let text = if text.contains("\n[dependencies]\n") {
            text.replacen("\n[dependencies]\n", &entry, 1)
        } else {
            text + &entry
        };
        Ok(if file == "Cargo.toml" { text + SWITCH_PROFILE } else { text })
    }

    fn original(&self, file: &str) -> anyhow::Result<String> {
        fs::read_to_string(self.root.join(file)).with_context(|| file.to_owned())
    }

    /// Puts everything back as it is in the project: tests read sources, too.
    ///
    /// # Errors
    /// What the file system says.
    pub(super) fn clear(&self) -> anyhow::Result<()> {
        self.files.iter().filter(|file| is_source(file) || is_manifest(file)).try_for_each(|file| self.restore(file))
    }

    /// A file as it is in the project, with the time it was written, so that nothing is built for it again.
    fn restore(&self, file: &str) -> anyhow::Result<()> {
        let (from, to) = (self.root.join(file), self.tree().join(file));
        let modified = fs::metadata(&from)?.modified()?;
        if fs::metadata(&to).is_ok_and(|there| there.modified().is_ok_and(|time| time == modified)) {
            return Ok(());
        }
        fs::create_dir_all(to.parent().context("a file has a folder")?)?;
        fs::copy(&from, &to).with_context(|| from.display().to_string())?;
        File::options().write(true).open(&to)?.set_modified(modified)?;
        Ok(())
    }

    /// A file with another text than in the project, with the time when that text was first put there.
    fn put(&self, file: &str, text: &str) -> anyhow::Result<()> {
        let modified = self.keep(&format!("texts/{file}"), text)?;
        let to = self.tree().join(file);
        fs::write(&to, text)?;
        File::options().write(true).open(&to)?.set_modified(modified)?;
        Ok(())
    }

    /// Writes a file beside the copy unless it is as it should be; when it was written.
    fn keep(&self, file: &str, text: &str) -> anyhow::Result<SystemTime> {
        let path = self.beside(file);
        crate::files::write(&path, text)?;
        Ok(fs::metadata(&path)?.modified()?)
    }
}

fn is_source(file: &str) -> bool {
    Path::new(file).extension().is_some_and(|end| end == "rs")
}

fn is_manifest(file: &str) -> bool {
    Path::new(file).file_name().is_some_and(|name| name == "Cargo.toml")
}

fn files(root: &Path) -> anyhow::Result<Vec<String>> {
    let arguments = ["ls-files", "-z", "--cached", "--others", "--exclude-standard"];
    let output = Command::new("git").args(arguments).current_dir(root).output().context("this needs git")?;
    ensure!(output.status.success(), "git ls-files: {}", String::from_utf8_lossy(&output.stderr).trim());
    let listed = String::from_utf8(output.stdout)?;
    Ok(listed.split_terminator('\0').filter(|f| root.join(f).is_file()).map(str::to_owned).collect())
}

/// Every file below a folder, from there.
fn below(folder: &Path) -> anyhow::Result<Vec<String>> {
    let (mut files, mut folders) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let inside = path.strip_prefix(folder).context("it is below")?;
                files.push(inside.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    Ok(files)
}
