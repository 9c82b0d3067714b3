//! The toolkit that proves a formula: sampler, automatic differentiation, exact reference, error measure, laws, audit
//! and golden files.
//!
//! Everything here accepts any type that implements [`Proved`], so that formulas of other crates are audited in the
//! same way:
//!
//! ```
//! use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
//! use jointproof::formula::proof::{Case, Proved};
//! use jointproof::formula::quantity::{Domain, Quantity, Unit};
//! use jointproof::{Scalar, fields, toolkit::verify};
//!
//! const STIFFNESS: Quantity = Quantity::scalar("k", Unit::new(-1, 1, 0), Domain::Positive, "spring stiffness");
//! const LENGTH: Quantity = Quantity::scalar("x", Unit::L, Domain::Real, "elongation");
//! const ENERGY: Quantity = Quantity::scalar("W", Unit::FL, Domain::NonNegative, "stored energy");
//!
//! fields! { struct Spring<T> { k: T = STIFFNESS, x: T = LENGTH } }
//! fields! { struct Stored<T> { w: T = ENERGY } }
//!
//! #[derive(Clone, Copy)]
//! struct SpringEnergy;
//! impl Formula for SpringEnergy {
//!     const SPEC: Spec = Spec::new("spring.energy", "Energy of a spring", Document::new("My notes").printed(""))
//!         .equation(r"W = \tfrac12 k x^2")
//!         .eta(2.0, 2.0);
//!     type Inputs<T: Component> = Spring<T>;
//!     type Outputs<T: Component> = Stored<T>;
//!     fn eval<D: Scalar>(i: &Spring<D>) -> Stored<D> {
//!         Stored { w: i.k * i.x * i.x * 0.5 }
//!     }
//!     fn jacobian<D: Scalar>(i: &Spring<D>) -> Jacobian<Self, D> {
//!         Stored { w: Spring { k: i.x * i.x * 0.5, x: i.k * i.x } }
//!     }
//! }
//! impl Proved for SpringEnergy {
//!     fn cases() -> Vec<Case<Spring<f64>>> {
//!         vec![Case::hand("two", "0.5 × 3 × 2²", Spring { k: 3.0, x: 2.0 })]
//!     }
//! }
//!
//! let audit = verify::audit::<SpringEnergy>(&verify::Options { samples: 50, ..Default::default() });
//! assert!(audit.passed(), "{audit:#?}");
//! ```

mod accuracy;
mod audit;
mod branches;
mod claim;
mod difference;
mod element;
mod eta;
mod finite;
pub mod golden;
mod invariance;
mod jet;
mod judge;
mod kinks;
mod other_side;
mod part;
mod point;
mod printed;
mod prose;
mod reach;
mod sample;
mod scale;
mod sensitivities;
mod shard;
mod subject;
mod trial;

pub(crate) use accuracy::eta_point;
#[cfg(feature = "measure")]
pub(crate) use audit::beside_kinks;
pub use audit::{Audit, audit_at};
pub(crate) use audit::{audit_equation, audit_point};
pub use claim::{Claim, Deviation};
pub use difference::central_differences;
pub use element::{ELEMENT_LAYOUT, ElementAudit, ElementFile, ElementRecord, Layout, Out, audit_element};
pub(crate) use element::{ElementSubject, golden_of};
#[cfg(feature = "measure")]
pub(crate) use eta::U;
pub use eta::{Sensitivity, eta, relative};
pub use jet::derivative_of_jacobian;
pub use judge::{Judge, Known, Truth};
pub use kinks::{Comparison, Coverage, Examination, Rank, Search, Sides};
pub use part::{Part, audit};
pub use point::Options;
pub use prose::{Printed, claims_at_large, number_at_large};
pub(crate) use prose::{claims_about, kinks_as_printed, number_of};
pub use sample::Sampler;
pub(crate) use scale::eta_at_scale;
pub use shard::{PartError, Shard};
pub use trial::Trial;

pub(crate) use kinks::sides;
pub(crate) use subject::Kink;
pub use subject::Subject;

use crate::Octuple;
use crate::formula::proof::{Convention, Proved};
use crate::formula::{Fields, Formula, typed};

/// Doubles as exact 237-bit numbers.
pub fn exactly<F: Formula>(i: &F::Inputs<f64>) -> F::Inputs<Octuple> {
    typed(&exact(&i.components()))
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
pub fn kink<F: Proved>(i: &F::Inputs<f64>) -> Option<Convention> {
    Subject::of::<F>().kink(&exact(&i.components()))
}
