//! The commands for these formulas.

use contact_heat::CATALOG;
use kit::Project;
use std::process::ExitCode;

fn main() -> ExitCode {
    kit::main(
        Project::new("contact-heat", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("..").measured_by("../measured"),
    )
}
