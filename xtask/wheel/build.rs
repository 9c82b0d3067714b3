//! Writes the table of batches: the types of the catalog, in its order, so that batches are compiled with this crate.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    const CATALOG: &str = "../../src/catalog/list.rs";
    println!("cargo::rerun-if-changed={CATALOG}");
    println!("cargo::rerun-if-changed=build.rs");
    let catalog = fs::read_to_string(CATALOG)?;
    let list = catalog.split_once("static CATALOG").and_then(|(_, rest)| rest.split_once("];"));
    let (list, _) = list.ok_or_else(|| io::Error::other("no `static CATALOG` in src/catalog/list.rs"))?;
    let types = list.lines().filter_map(|line| line.trim().strip_prefix('&')?.strip_suffix(','));
    let batches: Vec<_> = types.map(|path| format!("    Batch::of::<{path}>(),\n")).collect();
    let folder = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("cargo sets OUT_DIR"))?;
    fs::write(Path::new(&folder).join("batches.rs"), format!("&[\n{}]\n", batches.concat()))
}
