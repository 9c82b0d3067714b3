//! Connectors as elements: all that one with multipliers adds to a step of Newton's method.
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
#[cfg(feature = "verify")]
mod proof;
mod slider;
mod slot;
mod slot_plane;
mod translator;
mod ujoint;
mod universal;
mod unknowns;

pub use crate::formula::element::{Contribution, Element, Nothing, Parameters, Penalised};
pub use align::{Align, AlignElement, AlignStart};
pub use contact::{Isl21a, Isl22a, LineContact, OnLine, Pressed, PressureLaw, SlaveState};
pub use join::{Join, JoinElement, JoinStart};
pub use slider::{Slider, Slider2d, SliderElement, SliderElement2d};
pub use slot::{Slot, SlotContact, SlotElement, SlotStart, SlotState};
pub use slot_plane::{Slot2d, SlotElement2d, SlotStart2d};
pub use translator::{Translator, TranslatorContact, TranslatorElement, TranslatorStart};
pub use ujoint::{UJoint, UJointContact, UJointElement, UJointStart, UJointState};
pub use universal::{Universal, UniversalElement, UniversalStart};

use super::join::JoinLoads;
use super::offset::Arms;
use super::universal::UniversalMoments;
use super::{Forces, NodalForces};
use crate::connector::cardan::Triads;
use crate::connector::slot::Positions;
use crate::fields;
use crate::formula::quantity::{E1A, E1B, E2A, E2B, E3A, E3B, SPIN_A, SPIN_B, TRANSLATION_A, TRANSLATION_B, XA, XB};
use crate::formula::{Component, Field, Fields};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// Where both nodes are, and how they are turned.
    pub struct Nodes<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}

/// The degrees of freedom of two nodes in space, and what acts on them.
const UNKNOWNS: &[Field] = &[
    Field::new("ua", &TRANSLATION_A),
    Field::new("ta", &SPIN_A),
    Field::new("ub", &TRANSLATION_B),
    Field::new("tb", &SPIN_B),
];
const FORCES: &[Field] = <NodalForces<f64> as Fields<f64>>::FIELDS;

impl<T: Component> Nodes<T> {
    /// From the triads of a and of b, and the places of a and of b.
    #[inline]
    pub const fn new(triads: [[Vector3<T>; 3]; 2], places: [Vector3<T>; 2]) -> Self {
        let ([[e1a, e2a, e3a], [e1b, e2b, e3b]], [xa, xb]) = (triads, places);
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb }
    }

    /// The triad of a.
    #[inline]
    pub const fn a(&self) -> [Vector3<T>; 3] {
        [self.e1a, self.e2a, self.e3a]
    }

    /// The triad of b.
    #[inline]
    pub const fn b(&self) -> [Vector3<T>; 3] {
        [self.e1b, self.e2b, self.e3b]
    }

    fn positions(&self) -> Positions<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        Positions { e1a, e2a, e3a, xa, xb }
    }

    /// The loads of JOIN here.
    fn join_loads(&self, [f1, f2, f3]: [T; 3]) -> JoinLoads<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 }
    }

    fn triads(&self) -> Triads<T> {
        Triads::new(self.a(), self.b())
    }
}

impl<D: Scalar> Nodes<D> {
    /// After small motions u_a, θ_a, u_b, θ_b.
    fn moved(&self, motions: &Forces<D>) -> Self {
        let [ua, ta, ub, tb] = [0, 3, 6, 9].map(|k| motions.fixed_rows::<3>(k).into_owned());
        let turned = |triad: [Vector3<D>; 3], spin: Vector3<D>| triad.map(|e| e + spin.cross(&e));
        Self::new([turned(self.a(), ta), turned(self.b(), tb)], [self.xa + ua, self.xb + ub])
    }
}

impl<D: Scalar, const M: usize> Contribution<D, M> {
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

/// What belongs to the spins alone.
fn by_spins<D: Scalar>(ma: Vector3<D>, mb: Vector3<D>) -> Forces<D> {
    UniversalMoments { ma, mb }.vector()
}

#[cfg(all(test, feature = "verify"))]
mod tests;
