//! `cargo xtask`: the commands of the kit, and those specific to this project: scenes, tidiness, statements of the
//! documents, and generated content of the book.

mod extras;
mod figures;
mod museum;
mod scene;
mod statements;
mod studies;
mod tidy;
mod worked_check;
mod worked_example;

use jointproof::catalog::{CATALOG, ELEMENTS};
use kit::Project;
use kit::{Outcome, console, files};
use std::process::ExitCode;

/// What the sources of the formulas were when they were compiled.
const SOURCES: u64 = match u64::from_str_radix(env!("SOURCES"), 10) {
    Ok(sources) => sources,
    Err(_) => 0,
};

fn main() -> ExitCode {
    kit::main(ours(Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG)))
}

/// Adds the parts of the repository besides formulas.
fn ours(project: Project) -> Project {
    project
        .with_elements(ELEMENTS)
        .in_folder("..")
        .measured_by("measured")
        .built_from(SOURCES)
        .with_permalinks(include_str!("../../book/permalinks.txt"))
        .called("cargo xtask", "jointproof")
        .with_command("scene", scene::run)
        .with_command("tidy", tidy::run)
        .with_golden("scenes", scene::golden)
        .with_check("statements", statements::verify)
        .with_reach(tidy::reach)
        .with_extras(extras::all)
        .with_requirement("an independent implementation", has_oracle, "`@formula(…)` in tests/python/oracle")
}

/// Whether the independent Python implementation has this formula; copies of the repository without it are not checked.
fn has_oracle(project: &Project, id: &str) -> bool {
    let Ok(modules) = std::fs::read_dir(project.root().join("tests/python/oracle")) else { return true };
    let mut texts = modules.flatten().filter_map(|module| std::fs::read_to_string(module.path()).ok());
    texts.any(|text| text.contains(&format!("\"{id}\"")))
}
