//! One interface for elements: all that a connector with multipliers adds to a step of Newton's method.
//!
//! | | |
//! |---|---|
//! | unknowns | as of [`element`](super): u_a, θ_a, u_b, θ_b, spins about the global axes, and a multiplier for each residual |
//! | equations | forces on the nodes, which balance what else acts there, and the residuals, which vanish |
//! | matrix | the derivative of both: `stiffness` and `by_multipliers` in the rows of the forces, `rows` in those of the residuals |
//! | state | what friction remembers; a step begins from the state of the last converged increment, not of the last step |
//! | signs | forces act on the nodes; a program whose matrix is minus the derivative of its right-hand side, as Abaqus, turns the matrix |
//!
//! SLIDER and SLOT in the plane have other nodes, and fewer degrees of freedom; [`Element`] says how many. A program whose unknowns
//! are rotation vectors or Euler parameters takes [`Contribution::by_rotation_vectors`] or [`Contribution::by_euler_parameters`].
//!
//! Without friction `by_multipliers` is the transpose of `rows`. With it the friction follows the multipliers while it slips, and
//! the matrix is not symmetric.

mod align;
mod contact;
mod join;
mod slider;
mod slot;
mod slot_plane;
mod translator;
mod ujoint;
mod universal;
mod unknowns;

pub use align::AlignElement;
pub use contact::{Isl21a, Isl22a, LineContact, OnLine, Pressed, PressureLaw, SlaveState};
pub use join::JoinElement;
pub use slider::{SliderElement, SliderElement2d};
pub use slot::{SlotContact, SlotElement};
pub use slot_plane::SlotElement2d;
pub use translator::{TranslatorContact, TranslatorElement};
pub use ujoint::{CrossContact, UJointElement, UJointState};
pub use universal::UniversalElement;

use super::join::JoinLoads;
use super::offset::Arms;
use super::universal::UniversalMoments;
use crate::connector::cardan::Triads;
use crate::connector::slot::Positions;
use crate::formula::along;
use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector, Vector3};

/// Where both nodes are, and how they are turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nodes<D> {
    /// The triad of node a, in the global frame.
    pub a: [Vector3<D>; 3],
    /// The triad of node b, in the global frame.
    pub b: [Vector3<D>; 3],
    /// The position of node a.
    pub xa: Vector3<D>,
    /// The position of node b.
    pub xb: Vector3<D>,
}

impl<D: Scalar> Nodes<D> {
    fn positions(&self) -> Positions<D> {
        let ([e1a, e2a, e3a], xa, xb) = (self.a, self.xa, self.xb);
        Positions { e1a, e2a, e3a, xa, xb }
    }

    /// The loads of JOIN here.
    fn join_loads(&self, [f1, f2, f3]: [D; 3]) -> JoinLoads<D> {
        let Positions { e1a, e2a, e3a, xa, xb } = self.positions();
        JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 }
    }

    fn triads(&self) -> Triads<D> {
        Triads::new(self.a, self.b)
    }
}

/// What a connector adds to the residual and the matrix of Newton's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution<D, const MULTIPLIERS: usize, const DOFS: usize = 12> {
    /// By how much its conditions are off.
    pub residuals: SVector<D, MULTIPLIERS>,
    /// The derivative of the residuals by the degrees of freedom.
    pub rows: SMatrix<D, MULTIPLIERS, DOFS>,
    /// What it exerts on its nodes: forces and moments of the multipliers and of friction.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces by the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
    /// Their derivative by the multipliers.
    pub by_multipliers: SMatrix<D, DOFS, MULTIPLIERS>,
}

impl<D: Scalar, const MULTIPLIERS: usize> Contribution<D, MULTIPLIERS> {
    /// The same at the nodes that carry rigid arms to the connector's points, where this is.
    #[must_use]
    pub fn on_arms(&self, arms: &Arms<D>) -> Self {
        Self {
            residuals: self.residuals,
            rows: arms.rows(&self.rows),
            forces: arms.forces(&self.forces),
            stiffness: arms.stiffness(&self.stiffness, &self.forces),
            by_multipliers: arms.rows(&self.by_multipliers.transpose()).transpose(),
        }
    }
}

impl<D: Scalar, const MULTIPLIERS: usize, const DOFS: usize> Contribution<D, MULTIPLIERS, DOFS> {
    /// The same with the symmetric part of the stiffness, for programs that solve symmetric equations.
    ///
    /// Without friction it is K + ½ \[m×\] in the block of a node's own spin, with the moment m on that node. Where nodal moments
    /// balance nothing is lost; the convergence is linear otherwise, and where it slips.
    #[must_use]
    pub fn symmetric(&self) -> Self {
        Self { stiffness: (self.stiffness + self.stiffness.transpose()) * D::from(0.5), ..*self }
    }

    /// Without friction: what the multipliers do on the nodes is what the nodes do to the residuals.
    fn smooth(
        residuals: SVector<D, MULTIPLIERS>,
        rows: SMatrix<D, MULTIPLIERS, DOFS>,
        forces: SVector<D, DOFS>,
        stiffness: SMatrix<D, DOFS, DOFS>,
    ) -> Self {
        Self { residuals, rows, forces, stiffness, by_multipliers: rows.transpose() }
    }

    /// Adds to the derivatives what a friction does that works against a motion: the forces are −`row`ᵀ times it, and it
    /// changes with the degrees of freedom and with the multipliers.
    fn follow_friction(
        &mut self,
        row: &SVector<D, DOFS>,
        by_motions: &SVector<D, DOFS>,
        by_multipliers: &SVector<D, MULTIPLIERS>,
    ) {
        self.stiffness -= row * by_motions.transpose();
        self.by_multipliers -= row * by_multipliers.transpose();
    }

    fn is_finite(&self) -> bool {
        let Self { residuals, rows, forces, stiffness, by_multipliers } = self;
        let numbers = residuals.iter().chain(rows).chain(forces).chain(stiffness).chain(by_multipliers);
        numbers.fold(true, |finite, x| finite & x.re().is_finite())
    }
}

/// What a connector adds where multipliers are no unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalised<D, const MULTIPLIERS: usize, const DOFS: usize = 12> {
    /// What penalties make of the residuals, with the multipliers that were there before.
    pub multipliers: SVector<D, MULTIPLIERS>,
    /// What it exerts on its nodes.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces by the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
}

/// A connector as an element with multipliers.
///
/// ```
/// use jointproof::element::newton::{Element, Nodes, SlotContact, SlotElement};
/// use nalgebra::{Vector2, Vector3};
/// let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
/// let nodes = Nodes { a: axes, b: axes, xa: Vector3::zeros(), xb: Vector3::new(5.0, 0.5, 0.0) };
/// let contact = SlotContact { k_el: 100.0, fc_int: 0.0, mu: 0.25 };
/// let slot = SlotElement { start: Vector3::new(1.0, 0.0, 0.0), contact: Some(contact) };
/// // It has slipped by 3 before, has moved by 4 now, and is pressed against the slot by 40.
/// let (step, slip) = slot.newton(&nodes, &Vector2::new(40.0, 0.0), &3.0)?;
/// assert_eq!(step.residuals[0], 0.5);
/// assert_eq!(step.forces[6], -10.0); // friction on b, against the motion: μ times 40
/// assert_eq!((step.by_multipliers[(6, 0)], step.rows[(0, 6)]), (-0.25, 0.0)); // it follows the multiplier
/// assert_eq!(slip, 4.0 - 10.0 / 100.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
pub trait Element<const MULTIPLIERS: usize, const DOFS: usize = 12> {
    /// Where its nodes are.
    type Nodes<D: Scalar>: Copy;
    /// What friction remembers from one increment to the next.
    type State<D: Scalar>: Copy;

    /// Whether the parameters, these nodes and multipliers, and what friction remembers are valid.
    ///
    /// # Errors
    /// The first number that is not.
    fn check(
        &self,
        nodes: &Self::Nodes<f64>,
        multipliers: &SVector<f64, MULTIPLIERS>,
        before: &Self::State<f64>,
    ) -> Result<(), Error>;

    /// What it adds, and the state after the motion, at numbers that [`check`](Self::check) allows.
    fn contribution<D: Scalar>(
        &self,
        nodes: &Self::Nodes<D>,
        multipliers: &SVector<D, MULTIPLIERS>,
        before: &Self::State<D>,
    ) -> (Contribution<D, MULTIPLIERS, DOFS>, Self::State<D>);

    /// The same element, which does not rub.
    #[must_use]
    fn smooth(&self) -> Self
    where
        Self: Sized;

    /// The second time derivative of the residuals less rows times accelerations, (∂(G q̇)/∂q) q̇: what multibody programs
    /// subtract on the right-hand side of the equations of accelerations.
    ///
    /// Velocities are those of the translations and the angular velocities of both nodes, in the global frame. It is
    /// q̇ᵀ ∂²g q̇, with the geometric stiffness of each residual alone.
    fn velocity_term<D: Scalar>(
        &self,
        nodes: &Self::Nodes<D>,
        velocities: &SVector<D, DOFS>,
        at_rest: &Self::State<D>,
    ) -> SVector<D, MULTIPLIERS>
    where
        Self: Sized,
    {
        let smooth = self.smooth();
        SVector::from_fn(|k, _| {
            let (alone, _) = smooth.contribution(nodes, &along(k, D::one()), at_rest);
            velocities.dot(&(alone.stiffness * velocities))
        })
    }

    /// The element for programs without multipliers: penalties times the residuals take their place, or are added to them
    /// (the augmented Lagrangian).
    ///
    /// With penalties κ the multipliers are λ − κ g. The result has them, the forces, and the derivative of these by the
    /// degrees of freedom, in which the multipliers are no unknowns any more; a program with an augmented Lagrangian begins the
    /// next round from these multipliers.
    fn penalised<D: Scalar>(
        &self,
        nodes: &Self::Nodes<D>,
        multipliers: &SVector<D, MULTIPLIERS>,
        penalties: &SVector<D, MULTIPLIERS>,
        before: &Self::State<D>,
    ) -> (Penalised<D, MULTIPLIERS, DOFS>, Self::State<D>) {
        let (held, _) = self.contribution(nodes, multipliers, before);
        let multipliers = multipliers - penalties.component_mul(&held.residuals);
        let (found, after) = self.contribution(nodes, &multipliers, before);
        let pressed = SMatrix::from_fn(|row, column| held.rows[(row, column)] * penalties[row]);
        let stiffness = found.stiffness - found.by_multipliers * pressed;
        (Penalised { multipliers, forces: found.forces, stiffness }, after)
    }

    /// [`contribution`](Self::contribution) at numbers that are checked.
    ///
    /// # Errors
    /// As [`check`](Self::check), or that something overflowed.
    fn newton(
        &self,
        nodes: &Self::Nodes<f64>,
        multipliers: &SVector<f64, MULTIPLIERS>,
        before: &Self::State<f64>,
    ) -> Result<(Contribution<f64, MULTIPLIERS, DOFS>, Self::State<f64>), Error> {
        self.check(nodes, multipliers, before)?;
        let (found, after) = self.contribution(nodes, multipliers, before);
        if found.is_finite() { Ok((found, after)) } else { Err(Error::Overflow { name: "contribution" }) }
    }
}

/// What belongs to the spins alone.
fn by_spins<D: Scalar>(ma: Vector3<D>, mb: Vector3<D>) -> SVector<D, 12> {
    UniversalMoments { ma, mb }.vector()
}

#[cfg(all(test, feature = "verify"))]
mod tests;
