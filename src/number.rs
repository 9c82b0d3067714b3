//! What a formula may do to a number, and the numbers it runs in.
//!
//! A formula is generic over [`Scalar`](scalar::Scalar). It runs in `f64`, in the dual numbers of `num-dual` over it, and, to be
//! proved, in 237 bits and in single precision.

pub(crate) mod angle;
mod asin;
pub(crate) mod binade;
mod double;
mod dual;
pub(crate) mod eft;
mod exp;
#[cfg(any(feature = "verify", feature = "batch"))]
pub(crate) mod newtype;
#[cfg(feature = "verify")]
pub mod octuple;
#[cfg(feature = "batch")]
pub(crate) mod ordinary;
pub(crate) mod power;
#[cfg(any(feature = "batch", feature = "scene"))]
pub(crate) mod prefetch;
pub mod scalar;
#[cfg(feature = "verify")]
pub mod single;
pub(crate) mod squares;
