//! `cargo xtask`: the commands of the kit, and what is only ours: scenes, tidiness, what the documents
//! say, and the exhibits of our book.

#[cfg(feature = "ours")]
mod exhibits;
#[cfg(feature = "ours")]
mod figures;
#[cfg(feature = "ours")]
mod museum;
#[cfg(feature = "ours")]
mod mutate;
#[cfg(feature = "ours")]
mod scene;
#[cfg(feature = "ours")]
mod statements;
#[cfg(feature = "ours")]
mod studies;
#[cfg(feature = "ours")]
mod tidy;
#[cfg(feature = "ours")]
mod worked_example;

use jointproof::catalog::CATALOG;
use kit::Project;
#[cfg(feature = "ours")]
use kit::{Outcome, console, files};
use std::process::ExitCode;

fn main() -> ExitCode {
    kit::main(&ours(Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG)))
}

/// With what the repository has beside formulas.
#[cfg(feature = "ours")]
fn ours(project: Project) -> Project {
    project
        .in_folder("..")
        .called(if is_installed() { "jointproof" } else { "cargo xtask" })
        .with_command("scene", scene::run)
        .with_command("tidy", tidy::run)
        .with_command("mutate", mutate::run)
        .with_golden("scenes", scene::golden)
        .with_check("statements", statements::verify)
        .with_reach(tidy::reach)
        .with_exhibits(exhibits::all)
        .with_debt("an independent implementation", has_oracle, "`@formula(…)` in tests/python/oracle")
}

/// Whether this runs by itself, and not through cargo.
#[cfg(feature = "ours")]
fn is_installed() -> bool {
    std::env::var_os("CARGO").is_none()
}

/// Whether the independent implementation in Python has this formula; a copy without that is not asked for it.
#[cfg(feature = "ours")]
fn has_oracle(project: &Project, id: &str) -> bool {
    let Ok(modules) = std::fs::read_dir(project.root().join("tests/python/oracle")) else { return true };
    let mut texts = modules.flatten().filter_map(|module| std::fs::read_to_string(module.path()).ok());
    texts.any(|text| text.contains(&format!("\"{id}\"")))
}

/// The program that is measured has formulas only.
#[cfg(not(feature = "ours"))]
fn ours(project: Project) -> Project {
    project
}
