//! What proves and measures a formula, ours or anybody's. It knows no connector.

#[cfg(feature = "batch")]
pub mod batch;
#[cfg(feature = "verify")]
pub mod bound;
#[cfg(feature = "verify")]
pub mod equation;
#[cfg(feature = "verify")]
pub mod graph;
#[cfg(feature = "measure")]
pub mod measure;
#[cfg(feature = "verify")]
pub mod verify;
