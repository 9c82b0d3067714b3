//! The documented equations of sliding and universal joints, coded once and proved.
//!
//! Finite-element manuals document connectors, constraints and contact by equations. Here each equation is written **once**,
//! generic over its number type; everything else (value, check of the hand-derived Jacobian, exact reference, golden file, error
//! figure, book entry) is derived from that one definition, so that none can diverge.
//!
//! | module | contents |
//! |---|---|
//! | [`number`] | the operations of formulas on numbers, and the number types: `f64`, dual numbers over it, 237 bits |
//! | [`formula`] | the definition of a formula; the vocabulary of symbols, units and domains; errors; the evidence of a formula: cases, kinks, laws |
//! | [`contact`] | friction, interaction laws, slide lines and the axisymmetric elements that slide along them |
//! | [`connector`] | SLOT, ALIGN, TRANSLATOR, JOIN, UNIVERSAL, UJOINT and SLIDER: formulas, Jacobians, and the typed connectors; frames and Cardan angles |
//! | [`element`] | from equations to an element: rows, nodal forces and geometric stiffness with respect to translations and spins |
//! | `toolkit` | for any formula: `verify` proves it, `graph` records it, `bound` proves bounds of its rounding errors, `equation` executes its printed equation, `measure` measures its speed and its errors, `batch` evaluates it at many points |
//! | `catalog` | every formula by identifier |
//! | `scene` | scene files: parsed, validated, planned, evaluated |
//!
//! # Features
//!
//! Without features the crate contains the formulas, their connectors and what these need. No feature is enabled by default.
//!
//! | feature | what it adds |
//! |---|---|
//! | `batch` | `batch` |
//! | `batch-avx512` | `batch`, with eight rows at a time on processors with AVX-512 |
//! | `verify` | `Octuple` (237 bits, the exact reference) and `Single`, `proof`, `graph`, `equation`, `verify`, and formulas by name: `catalog::AnyFormula` |
//! | `catalog` | every formula by identifier, with its proof: `catalog::CATALOG` and `catalog::find` |
//! | `measure` | `measure`, including `batch` and `verify` |
//! | `measure-by-id` | the same and batches by `catalog::AnyFormula`, including `batch-avx512` |
//! | `scene` | `scene`, including `verify`: a scene can show the error of every number |
//!
//! ```
//! use jointproof::formula::value_and_jacobian;
//! use jointproof::connector::slot::{ContactForce, CrossForces};
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
use jointproof::connector::slot::{ContactForce, CrossForces};

let forces = CrossForces { f2: 3.0, f3: 4.0 };
let exact = ContactForce::eval(&jointproof::toolkit::verify::exactly::<ContactForce>(&forces));
assert_eq!(exact.fc.to_f64(), 5.0);
```"
)]

#[cfg(feature = "verify")]
pub mod catalog;
pub mod connector;
pub mod contact;
pub mod element;
pub mod formula;
pub mod number;
#[cfg(feature = "scene")]
pub mod scene;
#[cfg(any(feature = "batch", feature = "verify"))]
pub mod toolkit;

pub use formula::error::{Error, Name};
#[cfg(feature = "verify")]
pub use number::octuple::Octuple;
pub use number::scalar::Scalar;
#[cfg(feature = "verify")]
pub use number::single::Single;

/// The examples of both READMEs are compiled and run.
#[cfg(all(doctest, feature = "verify"))]
mod readme {
    #[doc = include_str!("../README.md")]
    struct OfTheRepository;
    #[doc = include_str!("README.md")]
    struct OfTheCrate;
}
