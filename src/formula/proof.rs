//! What is said *about* a formula, so that the toolkit can check it: cases, kinks, laws, and other ways to compute it.
//!
//! A formula's own file shows its equation and its derivative. Its evidence is [`Proved`], in the file `proof.rs` next
//! door. [`verify`](crate::toolkit::verify) and [`measure`](crate::toolkit::measure) take any formula that has it, of other crates too.

mod case;
mod element;
pub mod hard;
mod kink;
pub mod law;
pub(crate) mod way;

pub use case::{Case, Flag};
pub(crate) use element::inputs;
pub use element::{ProvedElement, Rubbed, Step};
pub use hard::Hard;
pub use kink::{Condition, Convention, Kink};
pub use law::{Equation, Law};
pub use way::Way;

use crate::formula::Formula;
pub use crate::formula::{Jet, value_and_jacobian_by_ad};

/// The evidence for a formula.
pub trait Proved: Formula {
    /// Hand-worked, limit and hard cases.
    fn cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Inputs put where the formula is used, from inputs whose components were drawn one by one: of a closest point the foot
    /// and the distance are drawn, and not the slave point, which would be beyond an end more often than not.
    fn placed(drawn: Self::Inputs<f64>) -> Self::Inputs<f64> {
        drawn
    }

    /// Inputs that [`validate`](Formula::validate) rejects; what the domains reject is added by itself.
    fn invalid_cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Where the formula has no derivative, and what is done there.
    fn kinks() -> Vec<Kink<Self>> {
        Vec::new()
    }

    /// What physics demands of it beyond frame indifference and homogeneity, which are checked for every formula.
    fn laws() -> Vec<Law<Self>> {
        Vec::new()
    }

    /// Other ways to compute the value, as textbooks have it or as the document words it, to be measured beside
    /// [`eval`](Formula::eval).
    fn ways() -> Vec<Way> {
        Vec::new()
    }
}
