//! Measures the formulas of this project: `report` builds this program with optimisation.

use jointproof::catalog::{AnyFormula, CATALOG};
use std::process::ExitCode;

fn main() -> ExitCode {
    measuring::main(CATALOG, <dyn AnyFormula>::errors, <dyn AnyFormula>::times)
}
