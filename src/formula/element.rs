//! The one definition of an element: what a connector with multipliers adds to a step of Newton's method.
//!
//! It is no [`Formula`](super::Formula): it has hundreds of results, and what is asked of it is that they fit together. Rows are the
//! derivative of the residuals, forces are rowsᵀ λ and friction, and the matrix is the derivative of the forces. Nodes, multipliers,
//! parameters and state are scalars of one type, so that derivatives by any of them can be taken, and the element be written down.

use super::checked::check_fields;
use super::finite::bits_unless_finite;
use super::{Component, Field, Fields, Spec, along};
use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector};
use std::marker::PhantomData;

/// A connector as an element with `M` multipliers and `DOFS` degrees of freedom. What is said about it stands in its
/// [`ProvedElement`](super::proof::ProvedElement).
///
/// ```
/// use jointproof::connector::slot::{SlotContact, SlotElement, SlotStart, SlotState};
/// use jointproof::element::{Nodes, Parameters};
/// use nalgebra::{Vector2, Vector3};
/// let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
/// let nodes = Nodes::new([axes; 2], [Vector3::zeros(), Vector3::new(5.0, 0.5, 0.0)]);
/// let contact = SlotContact { k_stick: 100.0, fc_int: 0.0, mu: 0.25 };
/// let slot = Parameters::<SlotElement, f64, 2> { start: SlotStart { x0: 1.0, y0: 0.0, z0: 0.0 }, contact: Some(contact) };
/// // It has moved by 4 since the start, by 0.25 in this increment, and is pressed against the slot by 40.
/// let (step, after) = slot.newton(&nodes, &Vector2::new(40.0, 0.0), &SlotState { u1: 3.75, f1: 1.0 })?;
/// assert_eq!(step.residuals[0], 0.5);
/// assert_eq!(step.forces[6], -10.0); // friction on b, against the motion: μ times 40
/// assert_eq!((step.by_multipliers[(6, 0)], step.rows[(0, 6)]), (-0.25, 0.0)); // it follows the multiplier
/// assert_eq!((after.u1, after.f1), (4.0, 10.0));
/// # Ok::<(), jointproof::Error>(())
/// ```
pub trait Element<const M: usize, const DOFS: usize = 12>:
    Copy + std::fmt::Debug + PartialEq + Send + Sync + 'static
{
    /// What is said about it; the bound of η is that of every number of the contribution.
    const SPEC: Spec;
    /// The degrees of freedom in order.
    const UNKNOWNS: &'static [Field];
    /// What acts on them, in the same order.
    const FORCES: &'static [Field];
    /// The residuals in order.
    const RESIDUALS: &'static [Field];
    /// Their multipliers in the same order.
    const MULTIPLIERS: &'static [Field];
    /// Where its nodes are, and how they are turned.
    type Nodes<T: Component>: Fields<T>;
    /// What was measured at the start.
    type Start<T: Component>: Fields<T>;
    /// How it rubs; [`Nothing`] where it cannot.
    type Contact<T: Component>: Fields<T>;
    /// What friction remembers from one increment to the next.
    type State<T: Component>: Fields<T>;

    /// The nodes after motions so small that only their first power counts: translations add, a spin turns a vector by δθ × e.
    fn moved<D: Scalar>(nodes: &Self::Nodes<D>, motions: &SVector<D, DOFS>) -> Self::Nodes<D>;

    /// What makes numbers invalid beyond the domains of the single fields.
    ///
    /// # Errors
    /// What is wrong with which number.
    fn validate<D: Scalar>(_: &Self::Nodes<D>, _: &Parameters<Self, D, M, DOFS>) -> Result<(), Error> {
        Ok(())
    }

    /// What it adds, and the state after the motion.
    fn contribution<D: Scalar>(
        nodes: &Self::Nodes<D>,
        multipliers: &SVector<D, M>,
        parameters: &Parameters<Self, D, M, DOFS>,
        before: &Self::State<D>,
    ) -> (Contribution<D, M, DOFS>, Self::State<D>);
}

/// What an element was made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<E: Element<M, DOFS>, D: Component, const M: usize, const DOFS: usize = 12> {
    /// What was measured at the start.
    pub start: E::Start<D>,
    /// How it rubs, if it does.
    pub contact: Option<E::Contact<D>>,
}

/// No fields: of an element that has no parameters, or no state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nothing<T>(PhantomData<T>);

impl<T> Nothing<T> {
    /// The only value.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Component> Fields<T> for Nothing<T> {
    const FIELDS: &'static [Field] = &[];
    type Array = [T; 0];
    fn from_components(_: &mut impl FnMut() -> T) -> Self {
        Self::new()
    }
    fn for_each_of_field(&self, _: &mut impl FnMut(&'static Field, T)) {}
    fn accept(&self, _: &mut impl super::Visitor<T>) {}
    fn array_of(_: T) -> [T; 0] {
        []
    }
}

/// What a connector adds to the residual and the matrix of Newton's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution<D, const M: usize, const DOFS: usize = 12> {
    /// By how much its conditions are off.
    pub residuals: SVector<D, M>,
    /// The derivative of the residuals by the degrees of freedom.
    pub rows: SMatrix<D, M, DOFS>,
    /// What it exerts on its nodes: forces and moments of the multipliers and of friction.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces by the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
    /// Their derivative by the multipliers.
    pub by_multipliers: SMatrix<D, DOFS, M>,
}

impl<D: Scalar, const M: usize, const DOFS: usize> Contribution<D, M, DOFS> {
    /// The same with the symmetric part of the stiffness, for programs that solve symmetric equations.
    ///
    /// Without friction it is K + ½ \[m×\] in the block of a node's own spin, with the moment m on that node. Where nodal moments
    /// balance nothing is lost; the convergence is linear otherwise, and where it slips.
    #[must_use]
    pub fn symmetric(&self) -> Self {
        Self { stiffness: (self.stiffness + self.stiffness.transpose()) * D::from(0.5), ..*self }
    }

    /// Without friction: what the multipliers do on the nodes is what the nodes do to the residuals.
    pub(crate) fn smooth(
        residuals: SVector<D, M>,
        rows: SMatrix<D, M, DOFS>,
        forces: SVector<D, DOFS>,
        stiffness: SMatrix<D, DOFS, DOFS>,
    ) -> Self {
        Self { residuals, rows, forces, stiffness, by_multipliers: rows.transpose() }
    }

    /// Adds to the derivatives what a friction does that works against a motion: the forces are −`row`ᵀ times it, and it
    /// changes with the degrees of freedom and with the multipliers.
    pub(crate) fn follow_friction(
        &mut self,
        row: &SVector<D, DOFS>,
        by_motions: &SVector<D, DOFS>,
        by_multipliers: &SVector<D, M>,
    ) {
        self.stiffness -= row * by_motions.transpose();
        self.by_multipliers -= row * by_multipliers.transpose();
    }

    /// All numbers in order: residuals, rows, forces, stiffness and derivative by the multipliers, matrices row by row.
    pub(crate) fn for_each(&self, visit: &mut impl FnMut(D)) {
        let Self { residuals, rows, forces, stiffness, by_multipliers } = self;
        residuals.iter().for_each(|&x| visit(x));
        rows.row_iter().for_each(|row| row.iter().for_each(|&x| visit(x)));
        forces.iter().for_each(|&x| visit(x));
        stiffness.row_iter().for_each(|row| row.iter().for_each(|&x| visit(x)));
        by_multipliers.row_iter().for_each(|row| row.iter().for_each(|&x| visit(x)));
    }
}

/// What a connector adds where multipliers are no unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalised<D, const M: usize, const DOFS: usize = 12> {
    /// What penalties make of the residuals, with the multipliers that were there before.
    pub multipliers: SVector<D, M>,
    /// What it exerts on its nodes.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces by the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
}

impl<E: Element<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize> Parameters<E, D, M, DOFS> {
    /// What the element adds, and the state after the motion, at numbers that are valid.
    pub fn contribution(
        &self,
        nodes: &E::Nodes<D>,
        multipliers: &SVector<D, M>,
        before: &E::State<D>,
    ) -> (Contribution<D, M, DOFS>, E::State<D>) {
        E::contribution(nodes, multipliers, self, before)
    }

    /// The same element, which does not rub.
    #[must_use]
    pub fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    /// The second time derivative of the residuals less rows times accelerations, (∂(G q̇)/∂q) q̇: what multibody programs
    /// subtract on the right-hand side of the equations of accelerations.
    ///
    /// Velocities are those of the translations and the angular velocities of the nodes, in the global frame. It is
    /// q̇ᵀ ∂²g q̇, with the geometric stiffness of each residual alone.
    pub fn velocity_term(&self, nodes: &E::Nodes<D>, velocities: &SVector<D, DOFS>) -> SVector<D, M> {
        let (smooth, at_rest) = (self.smooth(), E::State::filled(D::zero()));
        SVector::from_fn(|k, _| {
            let (alone, _) = smooth.contribution(nodes, &along(k, D::one()), &at_rest);
            velocities.dot(&(alone.stiffness * velocities))
        })
    }

    /// The element for programs without multipliers: penalties times the residuals take their place, or are added to them
    /// (the augmented Lagrangian).
    ///
    /// With penalties κ the multipliers are λ − κ g. The result has them, the forces, and the derivative of these by the
    /// degrees of freedom, in which the multipliers are no unknowns any more; a program with an augmented Lagrangian begins the
    /// next round from these multipliers.
    pub fn penalised(
        &self,
        nodes: &E::Nodes<D>,
        multipliers: &SVector<D, M>,
        penalties: &SVector<D, M>,
        before: &E::State<D>,
    ) -> (Penalised<D, M, DOFS>, E::State<D>) {
        let (held, _) = self.contribution(nodes, multipliers, before);
        let multipliers = multipliers - penalties.component_mul(&held.residuals);
        let (found, after) = self.contribution(nodes, &multipliers, before);
        let pressed = SMatrix::from_fn(|row, column| held.rows[(row, column)] * penalties[row]);
        let stiffness = found.stiffness - found.by_multipliers * pressed;
        (Penalised { multipliers, forces: found.forces, stiffness }, after)
    }
}

impl<E: Element<M, DOFS>, const M: usize, const DOFS: usize> Parameters<E, f64, M, DOFS> {
    /// Whether the parameters, these nodes and multipliers, and what friction remembers are valid.
    ///
    /// # Errors
    /// The first number that is not.
    pub fn check(
        &self,
        nodes: &E::Nodes<f64>,
        multipliers: &SVector<f64, M>,
        before: &E::State<f64>,
    ) -> Result<(), Error> {
        check_fields(&self.start)?;
        check_fields(nodes)?;
        for (field, &multiplier) in E::MULTIPLIERS.iter().zip(multipliers) {
            Error::check(field.name, None, multiplier, field.quantity.domain)?;
        }
        if let Some(contact) = &self.contact {
            check_fields(contact)?;
            check_fields(before)?;
        }
        E::validate(nodes, self)
    }

    /// [`contribution`](Self::contribution) at numbers that are checked.
    ///
    /// # Errors
    /// As [`check`](Self::check), or that something overflowed.
    pub fn newton(
        &self,
        nodes: &E::Nodes<f64>,
        multipliers: &SVector<f64, M>,
        before: &E::State<f64>,
    ) -> Result<(Contribution<f64, M, DOFS>, E::State<f64>), Error> {
        self.check(nodes, multipliers, before)?;
        let (found, after) = self.contribution(nodes, multipliers, before);
        let mut bits = 0;
        found.for_each(&mut |x| bits |= bits_unless_finite(x));
        if bits == 0 { Ok((found, after)) } else { Err(Error::Overflow { name: "contribution" }) }
    }
}
