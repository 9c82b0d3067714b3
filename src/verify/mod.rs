//! The toolkit that proves a formula: sampler, automatic differentiation, exact reference, error measure, laws, audit
//! and golden files.
//!
//! Everything here takes any type that implements [`Formula`], so that a formula of another
//! crate is audited by the same machinery:
//!
//! ```
//! use jointproof::formula::{Element, Formula, Jacobian, Source, Spec};
//! use jointproof::quantity::{Domain, Quantity, Shape, Unit};
//! use jointproof::{Scalar, fields, verify};
//!
//! const STIFFNESS: Quantity = Quantity {
//!     latex: "k", shape: Shape::Scalar, unit: Unit::new(-1, 1, 0), domain: Domain::Positive, meaning: "spring stiffness",
//! };
//! const LENGTH: Quantity = Quantity {
//!     latex: "x", shape: Shape::Scalar, unit: Unit::L, domain: Domain::Real, meaning: "elongation",
//! };
//! const ENERGY: Quantity = Quantity {
//!     latex: "W", shape: Shape::Scalar, unit: Unit::FL, domain: Domain::NonNegative, meaning: "stored energy",
//! };
//!
//! fields! { struct Spring<T> { k: T = STIFFNESS, x: T = LENGTH } }
//! fields! { struct Stored<T> { w: T = ENERGY } }
//!
//! #[derive(Clone, Copy)]
//! struct SpringEnergy;
//! impl Formula for SpringEnergy {
//!     const SPEC: Spec = Spec {
//!         id: "spring.energy", title: "Energy of a spring", latex: r"W = \tfrac12 k x^2",
//!         source: Source::document("notes.txt", "My notes"), eta: 2.0, eta_jacobian: 2.0, objective: true,
//!     };
//!     type Inputs<T: Element> = Spring<T>;
//!     type Outputs<T: Element> = Stored<T>;
//!     fn eval<D: Scalar>(i: &Spring<D>) -> Stored<D> {
//!         Stored { w: i.k * i.x * i.x * 0.5 }
//!     }
//!     fn jacobian<D: Scalar>(i: &Spring<D>) -> Jacobian<Self, D> {
//!         Stored { w: Spring { k: i.x * i.x * 0.5, x: i.k * i.x } }
//!     }
//! }
//!
//! let audit = verify::audit::<SpringEnergy>(&verify::Options { samples: 50, ..Default::default() });
//! assert!(audit.passed(), "{audit:#?}");
//! ```

mod audit;
mod difference;
mod eta;
pub mod golden;
pub mod hard;
mod jet;
pub mod law;
mod sample;
mod subject;

pub use audit::{Audit, Claim, Deviation, Options, audit, audit_at};
pub use difference::central_differences;
pub use eta::{Sensitivity, eta, relative};
pub use hard::Hard;
pub use jet::{derivative_of_jacobian, jacobian_by_ad};
pub use sample::Sampler;

pub(crate) use subject::{Kink, Subject};

use crate::Octuple;
use crate::formula::{Fields, Formula};

/// Doubles as exact 237-bit numbers.
pub fn exactly<F: Formula>(i: &F::Inputs<f64>) -> F::Inputs<Octuple> {
    let mut next = exact(&i.components()).into_iter();
    F::Inputs::from_components(&mut || next.next().unwrap_or(Octuple::NAN))
}

/// Components as exact 237-bit numbers.
pub(crate) fn exact(components: &[f64]) -> Vec<Octuple> {
    components.iter().map(|&x| x.into()).collect()
}

/// 237-bit numbers as the nearest doubles.
pub(crate) fn rounded(x: &[Octuple]) -> Vec<f64> {
    x.iter().map(|x| x.to_f64()).collect()
}

/// Whether the inputs are on a kink, and the convention there.
pub fn kink<F: Formula>(i: &F::Inputs<f64>) -> Option<crate::formula::Convention> {
    Subject::of::<F>().kink(&exact(&i.components()))
}
