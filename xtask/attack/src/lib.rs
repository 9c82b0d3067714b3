//! A search that climbs: the largest backward errors η of a formula in `f64`, over all inputs of the stated sizes.
//!
//! Random points do not find maxima. Here the recorded graph is differentiated backwards at a point, so that the part of
//! each rounding in the error of one result is known. To first order, the error is at most E = u Σ ρₖ |∂y/∂tₖ · tₖ| over all
//! rounded operations k. The search first climbs E/S, where S is the denominator of η, and then the sum of the roundings
//! that really occur, which error-free transformations give in `f64`. What it finds is confirmed in 237 bits, by the same
//! code as in an audit.
//!
//! This crate is optimised in every build: a search is as good as the number of points that it visits.

mod climb;
mod exact;
mod moves;
mod pass;
mod rounding;
mod space;
mod target;
#[cfg(test)]
mod tests;

pub use climb::{Attack, Effort, attack};
