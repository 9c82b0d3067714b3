//! Writes the table of batches: the types of the catalog, in its order, so that batches are compiled with this crate; and the first
//! lines of the files of certificates, which say what is proved.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    const CATALOG: &str = "../../src/catalog/list.rs";
    println!("cargo::rerun-if-changed={CATALOG}");
    println!("cargo::rerun-if-changed=build.rs");
    let catalog = fs::read_to_string(CATALOG)?;
    let list = catalog.split_once("static CATALOG").and_then(|(_, rest)| rest.split_once("];"));
    let (list, _) = list.ok_or_else(|| io::Error::other("no `static CATALOG` in src/catalog/list.rs"))?;
    let uses: Vec<_> = catalog.split("use crate::").skip(1).filter_map(|rest| rest.split_once(';')).collect();
    let types = list.lines().filter_map(|line| line.trim().strip_prefix('&')?.strip_suffix(','));
    let batch = |path: &str| {
        let module = path.split("::").next().unwrap_or(path);
        let from = uses.iter().find_map(|(import, _)| parent(import, module));
        let from = from.ok_or_else(|| io::Error::other(format!("{CATALOG} does not import {module}")))?;
        Ok(format!("    Batch::of::<jointproof::{from}{path}>(),\n"))
    };
    let batches: io::Result<String> = types.map(batch).collect();
    let folder = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("cargo sets OUT_DIR"))?;
    let folder = Path::new(&folder);
    fs::write(folder.join("batches.rs"), format!("&[\n{}]\n", batches?))?;
    fs::write(folder.join("proved.jsonl"), first_lines("../../golden/bounds")?)
}

/// The first line of every file of a folder, in order.
fn first_lines(folder: &str) -> io::Result<String> {
    println!("cargo::rerun-if-changed={folder}");
    let mut files = fs::read_dir(folder)?.map(|file| Ok(file?.path())).collect::<io::Result<Vec<_>>>()?;
    files.sort();
    files
        .iter()
        .map(|file| Ok(fs::read_to_string(file)?.lines().next().unwrap_or_default().to_owned() + "\n"))
        .collect()
}

/// What stands in front of a module that this import brings in: `connector::` of `slot` in `connector::{join, slot}`.
fn parent(import: &str, module: &str) -> Option<String> {
    let (from, names) = import.split_once("::{")?;
    let has = |wanted: &str| names.trim_end_matches('}').split(',').any(|name| name.trim() == wanted);
    if has(module) {
        return Some(format!("{from}::"));
    }
    (from == module && has("self")).then(String::new)
}
