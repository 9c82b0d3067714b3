//! The program that is measured, as it is built for tests.

use jointproof::catalog::CATALOG;
use kit::{Project, measuring};
use std::process::ExitCode;

fn main() -> ExitCode {
    measuring::main(&Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG))
}
