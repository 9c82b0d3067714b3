//! Heat through surfaces in contact: formulas of another field than those of jointproof, proved by the same kit.

mod gap;
mod quantity;
mod wall;

use jointproof::catalog::AnyFormula;

/// Every formula, in the order of the book.
pub static CATALOG: &[&dyn AnyFormula] = &[&gap::Flux, &wall::Flux];
