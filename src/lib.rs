//! The documented equations of sliding and universal joints, coded once and proved.
//!
//! Finite-element manuals document connectors, constraints and contact by equations. Here each equation is written
//! **once**, generic over its number type; everything else (value, check of the hand-derived Jacobian, exact
//! reference, golden file, error figure, book entry) is derived from that one definition, so that none can drift.
//!
//! | module | what is in it |
//! |---|---|
//! | [`slot`], [`coulomb`], [`cardan`], [`align`], [`translator`], [`join`], [`universal`], [`ujoint`], [`slider`], [`slide_line`], [`interaction`] | the documents' rooms: formulas, Jacobians, and the typed connectors |
//! | [`element`] | from equations to an element: rows, nodal forces and geometric stiffness by translations and spins |
//! | [`isl`] | the axisymmetric elements that slide along a slide line |
//! | [`frame`] | validated triads |
//! | [`formula`], [`quantity`] | what a formula is; the vocabulary of symbols, units and domains |
//! | [`scalar`] | the numbers a formula runs in: `f64`, dual numbers over it, and those of `verify` |
//! | `proof` | what is said about a formula: cases, kinks, laws, other ways |
//! | `verify`, `catalog` | the toolkit that proves a formula, yours too; every formula by identifier |
//! | `equation` | the printed equation, read and executed |
//! | `batch` | a formula at many points: columns in, columns out, on all cores |
//! | `measure` | how fast and how wrong every way to compute a formula is |
//! | `scene` | scene files: parsed, validated, planned, evaluated |
//!
//! # Features
//!
//! Without features there are the formulas, their connectors and what these need. Nothing is on by default.
//!
//! | feature | what it adds |
//! |---|---|
//! | `batch` | `batch` |
//! | `batch-avx512` | `batch`, and its rows eight at a time where the processor has AVX-512 |
//! | `verify` | `Octuple` (237 bits, the exact reference) and `Single`, `proof`, `graph`, `equation`, `verify`, and formulas by name: `catalog::AnyFormula` |
//! | `catalog` | every formula by identifier, with its proof: `catalog::CATALOG` and `catalog::find` |
//! | `batch-by-id` | batches by `catalog::AnyFormula`, and `batch` and `verify` with them |
//! | `measure` | `measure`, and `batch` and `verify` with it |
//! | `measure-by-id` | the same by `catalog::AnyFormula`, and `batch-by-id` and `batch-avx512` with it |
//! | `scene` | `scene`, and `verify` with it: a scene can show the error of every number |
//!
//! ```
//! use jointproof::formula::value_and_jacobian;
//! use jointproof::slot::{ContactForce, CrossForces};
//!
//! let forces = CrossForces { f2: 3.0, f3: 4.0 };
//! let (contact, jac) = value_and_jacobian::<ContactForce>(&forces)?;
//! assert_eq!(contact.fc, 5.0);
//! assert_eq!((jac.fc.f2, jac.fc.f3), (0.6, 0.8));
//! # Ok::<(), jointproof::Error>(())
//! ```
#![cfg_attr(
    feature = "verify",
    doc = "
The same definition, in 237 bits:

```
use jointproof::formula::Formula;
use jointproof::slot::{ContactForce, CrossForces};

let forces = CrossForces { f2: 3.0, f3: 4.0 };
let exact = ContactForce::eval(&jointproof::verify::exactly::<ContactForce>(&forces));
assert_eq!(exact.fc.to_f64(), 5.0);
```"
)]

pub mod align;
mod angle;
mod asin;
#[cfg(feature = "batch")]
pub mod batch;
mod binade;
pub mod cardan;
#[cfg(feature = "verify")]
pub mod catalog;
pub mod coulomb;
mod double;
mod dual;
mod eft;
pub mod element;
#[cfg(feature = "verify")]
pub mod equation;
mod error;
mod exp;
pub mod formula;
pub mod frame;
#[cfg(feature = "verify")]
pub mod graph;
pub mod interaction;
pub mod isl;
pub mod join;
#[cfg(feature = "measure")]
pub mod measure;
#[cfg(any(feature = "verify", feature = "batch"))]
mod newtype;
#[cfg(feature = "verify")]
pub mod octuple;
#[cfg(feature = "batch")]
mod ordinary;
mod power;
#[cfg(any(feature = "batch", feature = "scene"))]
mod prefetch;
#[cfg(feature = "verify")]
pub mod proof;
pub mod quantity;
pub mod scalar;
#[cfg(feature = "scene")]
pub mod scene;
#[cfg(feature = "verify")]
pub mod single;
pub mod slide_line;
pub mod slider;
pub mod slot;
mod squares;
pub mod translator;
pub mod ujoint;
pub mod universal;
#[cfg(feature = "verify")]
pub mod verify;

pub use error::{Error, Name};
#[cfg(feature = "verify")]
pub use octuple::Octuple;
pub use scalar::Scalar;
#[cfg(feature = "verify")]
pub use single::Single;

/// The examples of both READMEs are compiled and run.
#[cfg(all(doctest, feature = "verify"))]
mod readme {
    #[doc = include_str!("../README.md")]
    struct OfTheRepository;
    #[doc = include_str!("README.md")]
    struct OfTheCrate;
}
