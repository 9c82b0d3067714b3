//! Our formulas, measured: `report` has this built with optimisation.

use jointproof::catalog::{AnyFormula, CATALOG};
use std::process::ExitCode;

fn main() -> ExitCode {
    measuring::main(CATALOG, <dyn AnyFormula>::errors, <dyn AnyFormula>::times)
}
