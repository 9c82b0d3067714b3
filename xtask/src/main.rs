//! `cargo xtask`: the commands of the kit, and what is only ours: scenes, and the exhibits of our book.

#[cfg(feature = "commands")]
mod exhibits;
#[cfg(feature = "commands")]
mod figures;
#[cfg(feature = "commands")]
mod scene;
#[cfg(feature = "commands")]
mod worked_example;

use jointproof::catalog::CATALOG;
use kit::Project;
#[cfg(feature = "commands")]
use kit::{Outcome, console, files};
use std::process::ExitCode;

fn main() -> ExitCode {
    kit::main(&ours(Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG)))
}

/// With what the repository has beside formulas.
#[cfg(feature = "commands")]
fn ours(project: Project) -> Project {
    project
        .in_folder("..")
        .called("cargo xtask")
        .with_command("scene", scene::run)
        .with_golden("scenes", scene::golden)
        .with_exhibits(exhibits::all)
}

/// The program that is measured has formulas only.
#[cfg(not(feature = "commands"))]
fn ours(project: Project) -> Project {
    project
}
