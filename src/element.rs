//! From equations to an element: what a connector with multipliers adds to the residual and the matrix of Newton's method.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations u_a, u_b and the spins θ_a, θ_b of both nodes, in the global frame, and a multiplier for each residual |
//! | spin | a small rotation by the right-hand rule: δe = δθ × e for every vector e of the node's triad; it multiplies from the left, δR = \[δθ×\] R |
//! | rows | ∂g/∂(u_a, θ_a, u_b, θ_b), a vector for each node: the entries of a row of the matrix |
//! | matrix | twelve degrees of freedom in the order u_a, θ_a, u_b, θ_b; the geometric stiffness is Σ λ ∂²g, the derivative of Rowsᵀ λ with respect to them, with the multipliers held |
//! | zero position | where the residuals of the constraint are zero; rows and forces have none |
//! | signs | a positive multiplier times its row acts on the node: Rowsᵀ λ, with the forces of JOIN along a's triad on b, as everywhere |
//!
//! The rows of g_i = e_i·(x_b − x_a), e_i fixed in a, are −e_i, e_i × d, e_i and 0, with d = x_b − x_a. Those of
//! g = e1a·e3b are 0, e1a × e3b, 0 and e3b × e1a. SLOT is two of the first,
//! JOIN three, UNIVERSAL one of the second, UJOINT is JOIN and UNIVERSAL.
//!
//! The stiffness K is symmetric except for the blocks of a node's own spin: there K − Kᵀ = −\[m×\] with the moment m on that
//! node, since spins about different axes do not commute. If nodal moments balance, it is symmetric after assembly.

pub mod angle;
mod assembly;
pub mod cardan;
pub mod cross;
pub mod frame;
pub mod line;
#[cfg(feature = "verify")]
pub(crate) mod motion;
pub(crate) mod nodes;
pub mod offset;
pub(crate) mod products;
pub mod rotation;
#[cfg(feature = "scene")]
pub mod table;
mod turn;
mod unknowns;

pub use crate::formula::element::{Contribution, Element, Nothing, Parameters, Penalised};
pub use nodes::Nodes;

use crate::fields;
use crate::formula::quantity::{FORCE_A, FORCE_B, MOMENT_A, MOMENT_B};
use nalgebra::{SMatrix, SVector, Vector3};

fields! {
    /// The forces and moments of a connector on its two nodes.
    pub struct NodalForces<T> {
        fa: Vector3<T> = FORCE_A, ma: Vector3<T> = MOMENT_A, fb: Vector3<T> = FORCE_B, mb: Vector3<T> = MOMENT_B,
    }
}

/// A row for each residual, over the twelve degrees of freedom.
pub type Rows<D, const RESIDUALS: usize> = SMatrix<D, RESIDUALS, 12>;
/// Forces and moments that work on the twelve degrees of freedom.
pub type Forces<D> = SVector<D, 12>;
/// Their derivatives with respect to the twelve degrees of freedom.
pub type Stiffness<D> = SMatrix<D, 12, 12>;
