//! Heat through surfaces in contact: formulas of another field than those of jointproof, proved by the same kit.

mod gap;
mod quantity;
mod wall;

use kit::{Catalog, Project};
use std::process::ExitCode;

/// Every formula, in the order of the book.
static CATALOG: Catalog = &[&gap::Flux, &wall::Flux];

fn main() -> ExitCode {
    kit::main(&Project::new(env!("CARGO_PKG_NAME"), env!("CARGO_MANIFEST_DIR"), CATALOG))
}
