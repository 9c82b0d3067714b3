//! The program that `report` times.

use contact_heat::CATALOG;
use jointproof::catalog::AnyFormula;
use std::process::ExitCode;

fn main() -> ExitCode {
    measuring::main(CATALOG, <dyn AnyFormula>::errors, <dyn AnyFormula>::times)
}
