//! The definition of an element: what a connector or a contact adds to a step of Newton's method.
//!
//! It is no [`Formula`](super::Formula): it has hundreds of results, which are checked for consistency with each
//! other. Rows are the derivative of the residuals, forces are rowsᵀ λ and friction, and the matrix is the derivative
//! of the forces. Nodes, multipliers, parameters and state are scalars of one type, so that derivatives with respect
//! to all of them are available and the element can be recorded as a graph.
//!
//! An element may have no multipliers: then its forces follow from the positions of its nodes alone, as those of a
//! contact follow from its pressure law, and it holds no condition.

use super::checked::check_fields;
use super::finite::bits_unless_finite;
use super::{Component, Field, Fields, Spec, along};
use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector};
use std::marker::PhantomData;

/// An element with `M` residuals and `DOFS` degrees of freedom. The evidence for it is in its
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
    /// Identifier, source and bounds of the element; the bound of η holds for every number of the contribution.
    const SPEC: Spec;
    /// The degrees of freedom in order.
    const UNKNOWNS: &'static [Field];
    /// The forces and moments on the degrees of freedom, in the same order.
    const FORCES: &'static [Field];
    /// The residuals in order; without multipliers, the results that it reports with their derivatives.
    const RESIDUALS: &'static [Field];
    /// The multipliers of the residuals, in the same order; empty if it has none.
    ///
    /// Without them, multipliers are 0 wherever they appear, they are no inputs, and the derivative with respect to
    /// them is no result.
    const MULTIPLIERS: &'static [Field];
    /// The number of slave nodes, if it does the same at each of them, with a segment of its own; else 1.
    ///
    /// Then its nodes are the slave nodes, followed by those of their segments, the degrees of freedom are translations of
    /// these, and every field of the state has a component for each slave node.
    const SLAVES: usize = 1;
    /// Positions and orientations of its nodes.
    type Nodes<T: Component>: Fields<T>;
    /// What it needs with and without friction: measurements in the initial configuration, or the parameters of a
    /// pressure law.
    type Start<T: Component>: Fields<T>;
    /// Parameters of its friction; [`Nothing`] if it has none.
    type Contact<T: Component>: Fields<T>;
    /// The state of friction from one increment to the next.
    type State<T: Component>: Fields<T>;

    /// The nodes after an infinitesimal motion, to first order: translations are added, and a spin δθ adds δθ × e to a vector e.
    fn moved<D: Scalar>(nodes: &Self::Nodes<D>, motions: &SVector<D, DOFS>) -> Self::Nodes<D>;

    /// Checks conditions beyond the domains of the single fields.
    ///
    /// # Errors
    /// The number at fault, and what is wrong with it.
    fn validate<D: Scalar>(_: &Self::Nodes<D>, _: &Parameters<Self, D, M, DOFS>) -> Result<(), Error> {
        Ok(())
    }

    /// The contribution of the element, and the state after the motion.
    fn contribution<D: Scalar>(
        nodes: &Self::Nodes<D>,
        multipliers: &SVector<D, M>,
        parameters: &Parameters<Self, D, M, DOFS>,
        before: &Self::State<D>,
    ) -> (Contribution<D, M, DOFS>, Self::State<D>);
}

/// The parameters of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<E: Element<M, DOFS>, D: Component, const M: usize, const DOFS: usize = 12> {
    /// What the element needs with and without friction.
    pub start: E::Start<D>,
    /// Parameters of friction, if there is any.
    pub contact: Option<E::Contact<D>>,
}

/// No fields: for an element without parameters or without state.
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
    /// The residuals of its conditions.
    pub residuals: SVector<D, M>,
    /// The derivative of the residuals with respect to the degrees of freedom.
    pub rows: SMatrix<D, M, DOFS>,
    /// The forces and moments on its nodes, from the multipliers and from friction.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces with respect to the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
    /// The derivative of these forces with respect to the multipliers.
    pub by_multipliers: SMatrix<D, DOFS, M>,
}

impl<D: Scalar, const M: usize, const DOFS: usize> Contribution<D, M, DOFS> {
    /// The same with the symmetric part of the stiffness, for programs that solve symmetric equations.
    ///
    /// Without friction it is K + ½ \[m×\] in the block of a node's own spin, with the moment m on that node. Where
    /// nodal moments balance, convergence remains quadratic; otherwise, and during slip, it is linear.
    #[must_use]
    pub fn symmetric(&self) -> Self {
        Self { stiffness: (self.stiffness + self.stiffness.transpose()) * D::from(0.5), ..*self }
    }

    /// Without friction: the derivative of the forces with respect to the multipliers is the transpose of the rows.
    pub(crate) fn smooth(
        residuals: SVector<D, M>,
        rows: SMatrix<D, M, DOFS>,
        forces: SVector<D, DOFS>,
        stiffness: SMatrix<D, DOFS, DOFS>,
    ) -> Self {
        Self { residuals, rows, forces, stiffness, by_multipliers: rows.transpose() }
    }

    /// Adds the derivatives of a friction force that opposes a motion: the forces are −`row`ᵀ times it, and it changes
    /// with the degrees of freedom and with the multipliers.
    pub(crate) fn follow_friction(
        &mut self,
        row: &SVector<D, DOFS>,
        by_motions: &SVector<D, DOFS>,
        by_multipliers: &SVector<D, M>,
    ) {
        self.stiffness -= row * by_motions.transpose();
        self.by_multipliers -= row * by_multipliers.transpose();
    }

    /// The stiffness where each multiplier changes by −κ times its residual: that with the multipliers held, less the derivative with
    /// respect to them times κ times the rows.
    pub(crate) fn stiffness_with(&self, penalties: &SVector<D, M>) -> SMatrix<D, DOFS, DOFS> {
        let stiff_rows = SMatrix::from_fn(|row, column| self.rows[(row, column)] * penalties[row]);
        self.stiffness - self.by_multipliers * stiff_rows
    }

    /// All numbers in order: residuals, rows, forces, stiffness and derivative with respect to so many multipliers,
    /// matrices row by row.
    pub(crate) fn for_each(&self, multipliers: usize, visit: &mut impl FnMut(D)) {
        let Self { residuals, rows, forces, stiffness, by_multipliers } = self;
        residuals.iter().for_each(|&x| visit(x));
        rows.row_iter().for_each(|row| row.iter().for_each(|&x| visit(x)));
        forces.iter().for_each(|&x| visit(x));
        stiffness.row_iter().for_each(|row| row.iter().for_each(|&x| visit(x)));
        by_multipliers.row_iter().for_each(|row| row.iter().take(multipliers).for_each(|&x| visit(x)));
    }
}

/// The contribution of a connector whose multipliers are no unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalised<D, const M: usize, const DOFS: usize = 12> {
    /// The multipliers after the penalties are applied to the residuals.
    pub multipliers: SVector<D, M>,
    /// The forces and moments on its nodes.
    pub forces: SVector<D, DOFS>,
    /// The derivative of these forces with respect to the degrees of freedom.
    pub stiffness: SMatrix<D, DOFS, DOFS>,
}

impl<E: Element<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize> Parameters<E, D, M, DOFS> {
    /// The contribution of the element and the state after the motion, for valid numbers.
    pub fn contribution(
        &self,
        nodes: &E::Nodes<D>,
        multipliers: &SVector<D, M>,
        before: &E::State<D>,
    ) -> (Contribution<D, M, DOFS>, E::State<D>) {
        E::contribution(nodes, multipliers, self, before)
    }

    /// The same element without friction.
    #[must_use]
    pub fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    /// The second time derivative of the residuals minus rows times accelerations, (∂(G q̇)/∂q) q̇, which multibody
    /// programs subtract on the right-hand side of the acceleration equations.
    ///
    /// Velocities are those of the translations and the angular velocities of the nodes, in the global frame. It is
    /// q̇ᵀ ∂²g q̇, computed from the geometric stiffness of each residual alone.
    ///
    /// An element without multipliers, which holds no condition, does not compile here.
    pub fn velocity_term(&self, nodes: &E::Nodes<D>, velocities: &SVector<D, DOFS>) -> SVector<D, M> {
        const { assert!(!E::MULTIPLIERS.is_empty(), "the element holds no condition") };
        let (smooth, at_rest) = (self.smooth(), E::State::filled(D::zero()));
        SVector::from_fn(|k, _| {
            let (alone, _) = smooth.contribution(nodes, &along(k, D::one()), &at_rest);
            velocities.dot(&(alone.stiffness * velocities))
        })
    }

    /// The element for programs without multipliers: penalties times the residuals replace them, or are added to them
    /// (the augmented Lagrangian).
    ///
    /// With penalties κ the multipliers are λ − κ g. The result contains them, the forces, and the derivative of the
    /// forces with respect to the degrees of freedom with the multipliers eliminated; a program with an augmented
    /// Lagrangian starts its next iteration from these multipliers.
    ///
    /// An element without multipliers, which holds no condition, does not compile here.
    pub fn penalised(
        &self,
        nodes: &E::Nodes<D>,
        multipliers: &SVector<D, M>,
        penalties: &SVector<D, M>,
        before: &E::State<D>,
    ) -> (Penalised<D, M, DOFS>, E::State<D>) {
        const { assert!(!E::MULTIPLIERS.is_empty(), "the element holds no condition") };
        let multipliers = self.penalty_multipliers(nodes, multipliers, penalties);
        let (found, after) = self.contribution(nodes, &multipliers, before);
        (Penalised { multipliers, forces: found.forces, stiffness: found.stiffness_with(penalties) }, after)
    }

    /// The multipliers λ − κ g; friction has no influence on the residuals.
    pub(crate) fn penalty_multipliers(
        &self,
        nodes: &E::Nodes<D>,
        multipliers: &SVector<D, M>,
        penalties: &SVector<D, M>,
    ) -> SVector<D, M> {
        let (held, _) = self.smooth().contribution(nodes, multipliers, &E::State::filled(D::zero()));
        multipliers - penalties.component_mul(&held.residuals)
    }
}

impl<E: Element<M, DOFS>, const M: usize, const DOFS: usize> Parameters<E, f64, M, DOFS> {
    /// Checks the parameters, the nodes, the multipliers and the state of friction.
    ///
    /// # Errors
    /// The first number that is not valid.
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

    /// [`contribution`](Self::contribution), with its numbers checked.
    ///
    /// # Errors
    /// As for [`check`](Self::check), or an error that something overflowed.
    pub fn newton(
        &self,
        nodes: &E::Nodes<f64>,
        multipliers: &SVector<f64, M>,
        before: &E::State<f64>,
    ) -> Result<(Contribution<f64, M, DOFS>, E::State<f64>), Error> {
        self.check(nodes, multipliers, before)?;
        let (found, after) = self.contribution(nodes, multipliers, before);
        let mut bits = 0;
        found.for_each(E::MULTIPLIERS.len(), &mut |x| bits |= bits_unless_finite(x));
        if bits == 0 { Ok((found, after)) } else { Err(Error::Overflow { name: "contribution" }) }
    }
}
