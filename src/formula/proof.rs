//! The evidence *about* a formula that the toolkit checks: cases, kinks, laws, and alternative computations.
//!
//! A formula's own file shows its equation and its derivative. Its evidence is [`Proved`], in the file `proof.rs` next
//! to it. [`verify`](crate::toolkit::verify) and [`measure`](crate::toolkit::measure) accept any formula that has it,
//! also from other crates.

mod case;
mod element;
pub mod hard;
mod kink;
pub mod law;
pub(crate) mod method;

pub use case::{Case, Flag, RUNNING};
pub(crate) use element::inputs;
pub use element::{ProvedElement, Rubbed, Step};
pub use hard::Hard;
pub use kink::{Condition, Convention, Kink};
pub use law::{Equation, Law};
pub use method::Method;

use crate::formula::Formula;
pub use crate::formula::{Jet, value_and_jacobian_by_ad};

/// The evidence for a formula.
pub trait Proved: Formula {
    /// Hand-worked, limit and hard cases.
    fn cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Realistic inputs made from inputs whose components were drawn one by one. For a closest point, for instance, the foot and
    /// the distance are drawn instead of the slave point, which would be beyond an end more often than not.
    fn placed(drawn: Self::Inputs<f64>) -> Self::Inputs<f64> {
        drawn
    }

    /// Inputs that [`validate`](Formula::validate) rejects; inputs outside the domains are added automatically.
    fn invalid_cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Where the formula has no derivative, and the convention used there.
    fn kinks() -> Vec<Kink<Self>> {
        Vec::new()
    }

    /// Physical laws it must satisfy, beyond frame indifference and homogeneity, which are checked for every formula.
    fn laws() -> Vec<Law<Self>> {
        Vec::new()
    }

    /// Alternative computations of the value, as in textbooks or as the document words it, measured alongside
    /// [`eval`](Formula::eval).
    fn methods() -> Vec<Method> {
        Vec::new()
    }
}
