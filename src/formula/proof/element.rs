//! The evidence for an element that the toolkit checks.

use super::Case;
use crate::Octuple;
use crate::formula::element::{Contribution, Element, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::X0;
use crate::formula::{Component, Field, Fields};
use crate::number::scalar::Scalar;
use nalgebra::SVector;
use std::marker::PhantomData;

/// Everything an element computes from, at one step of Newton's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<E: Element<M, DOFS>, D: Component, const M: usize, const DOFS: usize = 12> {
    /// Positions and orientations of its nodes.
    pub nodes: E::Nodes<D>,
    /// The multipliers; 0 if the element has none.
    pub multipliers: SVector<D, M>,
    /// The parameters of the element.
    pub parameters: Parameters<E, D, M, DOFS>,
    /// The state of friction; irrelevant without friction.
    pub before: E::State<D>,
}

impl<E: Element<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize> Step<E, D, M, DOFS> {
    /// From components in the order of [`inputs`]; the state is 0 without friction.
    pub(crate) fn of(components: &[D], rubs: bool) -> Self {
        let mut rest = components.iter().copied();
        let mut next = || rest.next().expect("there is a component for every field");
        Self {
            nodes: Fields::from_components(&mut next),
            multipliers: SVector::from_fn(|k, _| if k < E::MULTIPLIERS.len() { next() } else { D::zero() }),
            parameters: Parameters {
                start: Fields::from_components(&mut next),
                contact: rubs.then(|| Fields::from_components(&mut next)),
            },
            before: if rubs { Fields::from_components(&mut next) } else { Fields::filled(D::zero()) },
        }
    }

    /// The components in the order of [`inputs`].
    pub(crate) fn components(&self) -> Vec<D> {
        let mut all = self.nodes.components();
        all.extend(self.multipliers.iter().take(E::MULTIPLIERS.len()));
        all.extend(self.parameters.start.components());
        if let Some(contact) = &self.parameters.contact {
            all.extend(contact.components());
            all.extend(self.before.components());
        }
        all
    }

    /// The results of the element: residuals, rows, forces, stiffness, derivative with respect to the multipliers,
    /// and, with friction, the state after the step.
    pub(crate) fn results(&self) -> Vec<D> {
        self.in_order(self.parameters.contribution(&self.nodes, &self.multipliers, &self.before))
    }

    fn in_order(&self, (found, after): (Contribution<D, M, DOFS>, E::State<D>)) -> Vec<D> {
        let mut all = Vec::new();
        found.for_each(E::MULTIPLIERS.len(), &mut |x| all.push(x));
        if self.parameters.contact.is_some() {
            all.extend(after.components());
        }
        all
    }
}

impl<E: Element<M, DOFS>, const M: usize, const DOFS: usize> Step<E, f64, M, DOFS> {
    /// The results, with the numbers checked.
    ///
    /// # Errors
    /// As for [`Parameters::newton`].
    pub(crate) fn checked_results(&self) -> Result<Vec<f64>, Error> {
        Ok(self.in_order(self.parameters.newton(&self.nodes, &self.multipliers, &self.before)?))
    }
}

/// The largest number of fields that an element may have.
const MOST: usize = 64;

/// The input fields of an element, concatenated at compile time.
struct Inputs<E, const M: usize, const DOFS: usize>(PhantomData<E>);

impl<E: Element<M, DOFS>, const M: usize, const DOFS: usize> Inputs<E, M, DOFS> {
    const SMOOTH_FIELDS: &'static ([Field; MOST], usize) =
        &joined(&[<E::Nodes<f64> as Fields<f64>>::FIELDS, E::MULTIPLIERS, <E::Start<f64> as Fields<f64>>::FIELDS]);
    const RUBBING_FIELDS: &'static ([Field; MOST], usize) = &joined(&[
        Self::SMOOTH_FIELDS.0.split_at(Self::SMOOTH_FIELDS.1).0,
        <E::Contact<f64> as Fields<f64>>::FIELDS,
        <E::State<f64> as Fields<f64>>::FIELDS,
    ]);
}

const fn joined(lists: &[&[Field]]) -> ([Field; MOST], usize) {
    let (mut all, mut count, mut list) = ([Field::new("", &X0); MOST], 0, 0);
    while list < lists.len() {
        let mut k = 0;
        while k < lists[list].len() {
            all[count] = lists[list][k];
            (count, k) = (count + 1, k + 1);
        }
        list += 1;
    }
    (all, count)
}

/// The inputs of an element: nodes, multipliers, start, and, with friction, contact and state.
pub(crate) const fn inputs<E: Element<M, DOFS>, const M: usize, const DOFS: usize>(rubs: bool) -> &'static [Field] {
    let (all, count) = if rubs { Inputs::<E, M, DOFS>::RUBBING_FIELDS } else { Inputs::<E, M, DOFS>::SMOOTH_FIELDS };
    all.split_at(*count).0
}

/// A friction force and the motion that it opposes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubbed<D> {
    /// The displacement in the step.
    pub motion: D,
    /// The friction force before and after the step.
    pub force: [D; 2],
    /// The stiffness in stick.
    pub k_stick: D,
    /// The yield function of the document, ≤ 0.
    pub phi: D,
}

/// The evidence for an element.
pub trait ProvedElement<const M: usize, const DOFS: usize = 12>: Element<M, DOFS> {
    /// Whether the rows are the derivative of the residuals for all positions of the nodes, not only where the residuals vanish.
    const EXACT_ROWS: bool = true;

    /// Hand-worked and hard cases, the first of them valid; random ones are added automatically.
    fn cases() -> Vec<Case<Step<Self, f64, M, DOFS>>>;

    /// A realistic step, made from one whose components were drawn one by one.
    fn placed(drawn: Step<Self, f64, M, DOFS>) -> Step<Self, f64, M, DOFS> {
        drawn
    }

    /// The step with its nodes moved to where the residuals vanish, for an element without [`EXACT_ROWS`](Self::EXACT_ROWS).
    fn held(step: Step<Self, Octuple, M, DOFS>) -> Step<Self, Octuple, M, DOFS> {
        step
    }

    /// For an element without multipliers: the virtual work of its loads, by the formulas of the document. The loads,
    /// and the directions in which they act, are constant; the nodes move, and the forces on them are the derivative of
    /// the work.
    fn work<D: Scalar>(_: &Step<Self, D, M, DOFS>, _: &Self::State<D>) -> D {
        D::zero()
    }

    /// Its friction forces after the step, by the formulas of the document.
    fn rubbed<D: Scalar>(_: &Step<Self, D, M, DOFS>, _: &Self::State<D>) -> Vec<Rubbed<D>> {
        Vec::new()
    }
}
