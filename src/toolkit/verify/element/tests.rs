//! Every element passes, and no faulty one does.

use super::{ElementAudit, audit_element};
use crate::connector::align::AlignElement;
use crate::connector::hinge::HingeElement;
use crate::connector::join::JoinElement;
use crate::connector::slider::{SliderElement, SliderElement2d};
use crate::connector::slot::{SlotElement, SlotElement2d};
use crate::connector::translator::TranslatorElement;
use crate::connector::ujoint::UJointElement;
use crate::connector::universal::UniversalElement;
use crate::contact::interaction::{PressureExponential, PressureLinear};
use crate::contact::slide_line::element::{Isl21aElement, Isl22aElement};
use crate::formula::element::Parameters;
use crate::formula::element::{Contribution, Element};
use crate::formula::error::Error;
use crate::formula::proof::{Case, ProvedElement, Rubbed, Step};
use crate::formula::{Component, Field, Fields, Spec};
use crate::toolkit::verify::Options;
use crate::{Octuple, Scalar};
use nalgebra::SVector;
use std::marker::PhantomData;

const FEW: Options = Options { samples: 3, seed: 1 };

fn failed(audit: &ElementAudit) -> Vec<String> {
    let worst = |claim: &crate::toolkit::verify::Claim| {
        let worst = claim.worst.as_ref();
        let worst = worst.map(|worst| {
            format!("{:e} at {} of {}: {} not {}", worst.size, worst.point, worst.entry, worst.found, worst.expected)
        });
        format!("{}, {} of {}: {}", claim.claim, claim.failures, claim.checks, worst.unwrap_or_default())
    };
    audit.claims.iter().filter(|claim| !claim.held()).map(worst).collect()
}

#[test]
fn every_element_passes() {
    let mut wrong = Vec::new();
    for audit in [
        audit_element::<JoinElement, 3, 12>(&FEW),
        audit_element::<AlignElement, 3, 12>(&FEW),
        audit_element::<UniversalElement, 1, 12>(&FEW),
        audit_element::<SlotElement, 2, 12>(&FEW),
        audit_element::<SlotElement2d, 1, 6>(&FEW),
        audit_element::<TranslatorElement, 5, 12>(&FEW),
        audit_element::<UJointElement, 4, 12>(&FEW),
        audit_element::<HingeElement, 5, 12>(&FEW),
        audit_element::<SliderElement, 2, 9>(&FEW),
        audit_element::<SliderElement2d, 1, 6>(&FEW),
        audit_element::<Isl21aElement<PressureLinear>, 1, 12>(&FEW),
        audit_element::<Isl22aElement<PressureExponential>, 1, 24>(&FEW),
    ] {
        wrong.extend(failed(&audit).into_iter().map(|claim| format!("{}: {claim}", audit.element)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A fault of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mistake {
    /// A row has the opposite sign, with all consequences.
    Sign,
    /// The block for the spin of the first node is transposed.
    Transposed,
    /// The matrix is symmetrised, as if for rotation vectors.
    Symmetrised,
    /// The moment on the first node and its derivatives are omitted.
    NoMoment,
    /// Friction is omitted, but not its state.
    NoFriction,
    /// The friction tangent is too stiff: that of stick is used during slip.
    Stick,
    /// Friction does not depend on the normal force.
    FollowsNothing,
    /// Friction has the opposite sign.
    Pushes,
    /// All forces have the opposite sign, and so do their derivatives.
    Pulls,
}

/// An element with a fault, given by its index in the list above.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wrong<E, const MISTAKE: usize>(PhantomData<E>);

const MISTAKES: [Mistake; 9] = [
    Mistake::Sign,
    Mistake::Transposed,
    Mistake::Symmetrised,
    Mistake::NoMoment,
    Mistake::NoFriction,
    Mistake::Stick,
    Mistake::FollowsNothing,
    Mistake::Pushes,
    Mistake::Pulls,
];

fn right<E, D: Component, const K: usize, const M: usize, const DOFS: usize>(
    wrong: &Parameters<Wrong<E, K>, D, M, DOFS>,
) -> Parameters<E, D, M, DOFS>
where
    E: Element<M, DOFS>,
{
    Parameters { start: wrong.start, contact: wrong.contact }
}

/// A step of the element without the fault.
fn rightly<E: Element<M, DOFS>, D: Component, const K: usize, const M: usize, const DOFS: usize>(
    step: Step<Wrong<E, K>, D, M, DOFS>,
) -> Step<E, D, M, DOFS> {
    let Step { nodes, multipliers, parameters, before } = step;
    Step { nodes, multipliers, parameters: right(&parameters), before }
}

/// A step of the faulty element.
fn wrong<E: Element<M, DOFS>, D: Component, const K: usize, const M: usize, const DOFS: usize>(
    step: Step<E, D, M, DOFS>,
) -> Step<Wrong<E, K>, D, M, DOFS> {
    let Step { nodes, multipliers, parameters: Parameters { start, contact }, before } = step;
    Step { nodes, multipliers, parameters: Parameters { start, contact }, before }
}

impl<E: Element<M, DOFS>, const K: usize, const M: usize, const DOFS: usize> Element<M, DOFS> for Wrong<E, K> {
    const SPEC: Spec = E::SPEC;
    const UNKNOWNS: &'static [Field] = E::UNKNOWNS;
    const FORCES: &'static [Field] = E::FORCES;
    const RESIDUALS: &'static [Field] = E::RESIDUALS;
    const MULTIPLIERS: &'static [Field] = E::MULTIPLIERS;
    type Nodes<T: Component> = E::Nodes<T>;
    type Start<T: Component> = E::Start<T>;
    type Contact<T: Component> = E::Contact<T>;
    type State<T: Component> = E::State<T>;

    fn moved<D: Scalar>(nodes: &Self::Nodes<D>, motions: &SVector<D, DOFS>) -> Self::Nodes<D> {
        E::moved(nodes, motions)
    }

    fn validate<D: Scalar>(nodes: &Self::Nodes<D>, with: &Parameters<Self, D, M, DOFS>) -> Result<(), Error> {
        E::validate(nodes, &right(with))
    }

    fn contribution<D: Scalar>(
        nodes: &Self::Nodes<D>,
        multipliers: &SVector<D, M>,
        parameters: &Parameters<Self, D, M, DOFS>,
        before: &Self::State<D>,
    ) -> (Contribution<D, M, DOFS>, Self::State<D>) {
        let parameters = right(parameters);
        let (mut found, after) = parameters.contribution(nodes, multipliers, before);
        let (smooth, _) = parameters.smooth().contribution(nodes, multipliers, before);
        // Degrees of freedom for the spin of the first node, in space and in the plane; of other nodes on a slide line.
        let spin = if DOFS == 6 { 2..3 } else { 3..6 };
        match MISTAKES[K] {
            Mistake::Sign => found.rows.row_mut(0).neg_mut(),
            Mistake::Transposed => {
                let whole = found.stiffness;
                for row in 0..DOFS {
                    for column in spin.clone() {
                        found.stiffness[(row, column)] = whole[(column, row)];
                    }
                }
            }
            Mistake::Symmetrised => found = found.symmetric(),
            Mistake::NoMoment => {
                for row in spin {
                    found.forces[row] = D::zero();
                    found.stiffness.row_mut(row).fill(D::zero());
                    found.by_multipliers.row_mut(row).fill(D::zero());
                }
            }
            Mistake::NoFriction => found = smooth,
            Mistake::Stick => found.stiffness += found.stiffness - smooth.stiffness,
            Mistake::FollowsNothing => found.by_multipliers = smooth.by_multipliers,
            Mistake::Pushes => found.forces = smooth.forces * D::from(2.0) - found.forces,
            Mistake::Pulls => {
                found.forces.neg_mut();
                found.stiffness.neg_mut();
                found.by_multipliers.neg_mut();
            }
        }
        (found, after)
    }
}

impl<E: ProvedElement<M, DOFS>, const K: usize, const M: usize, const DOFS: usize> ProvedElement<M, DOFS>
    for Wrong<E, K>
{
    const EXACT_ROWS: bool = E::EXACT_ROWS;

    fn cases() -> Vec<Case<Step<Self, f64, M, DOFS>>> {
        let cases = E::cases().into_iter().take(10);
        cases.map(|Case { id, flag, comment, inputs }| Case { id, flag, comment, inputs: wrong(inputs) }).collect()
    }

    fn placed(drawn: Step<Self, f64, M, DOFS>) -> Step<Self, f64, M, DOFS> {
        wrong(E::placed(rightly(drawn)))
    }

    fn held(step: Step<Self, Octuple, M, DOFS>) -> Step<Self, Octuple, M, DOFS> {
        wrong(E::held(rightly(step)))
    }

    fn work<D: Scalar>(step: &Step<Self, D, M, DOFS>, after: &Self::State<D>) -> D {
        E::work(&rightly(*step), after)
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, M, DOFS>, after: &Self::State<D>) -> Vec<Rubbed<D>> {
        E::rubbed(&rightly(*step), after)
    }
}

/// The claims that fail for a faulty element.
fn caught<E: ProvedElement<M, DOFS>, const K: usize, const M: usize, const DOFS: usize>() -> Vec<String> {
    failed(&audit_element::<Wrong<E, K>, M, DOFS>(&Options { samples: 1, seed: 1 }))
}

/// The faults that went unnoticed. In the plane, where rotations commute, the matrix is symmetric, so that
/// symmetrising it is no fault.
fn unnoticed<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>(
    has_moments: bool,
    is_symmetric: bool,
) -> Vec<String> {
    let rubs = !<E::Contact<f64> as Fields<f64>>::FIELDS.is_empty();
    let found = [
        caught::<E, 0, M, DOFS>(),
        caught::<E, 1, M, DOFS>(),
        caught::<E, 2, M, DOFS>(),
        caught::<E, 3, M, DOFS>(),
        caught::<E, 4, M, DOFS>(),
        caught::<E, 5, M, DOFS>(),
        caught::<E, 6, M, DOFS>(),
        caught::<E, 7, M, DOFS>(),
        caught::<E, 8, M, DOFS>(),
    ];
    let is_one = |mistake: Mistake| match mistake {
        Mistake::Sign | Mistake::Pulls => true,
        Mistake::Transposed | Mistake::Symmetrised => !is_symmetric,
        Mistake::NoMoment => has_moments,
        Mistake::FollowsNothing => rubs && !E::MULTIPLIERS.is_empty(),
        _ => rubs,
    };
    let missed = MISTAKES.into_iter().zip(found).filter(|(mistake, found)| is_one(*mistake) && found.is_empty());
    missed.map(|(mistake, _)| format!("{}: {mistake:?}", E::SPEC.id)).collect()
}

#[test]
fn mistakes_are_caught_in_every_element() {
    let missed = [
        unnoticed::<JoinElement, 3, 12>(true, false),
        unnoticed::<AlignElement, 3, 12>(true, false),
        unnoticed::<UniversalElement, 1, 12>(true, false),
        unnoticed::<SlotElement, 2, 12>(true, false),
        unnoticed::<SlotElement2d, 1, 6>(true, true),
        unnoticed::<TranslatorElement, 5, 12>(true, false),
        unnoticed::<UJointElement, 4, 12>(true, false),
        unnoticed::<HingeElement, 5, 12>(true, false),
        unnoticed::<SliderElement, 2, 9>(false, false),
        unnoticed::<SliderElement2d, 1, 6>(false, true),
        unnoticed::<Isl21aElement<PressureLinear>, 1, 12>(true, false),
    ]
    .concat();
    assert_eq!(missed, [""; 0]);
}
