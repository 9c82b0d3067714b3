//! The force that the joint transmits, and the direction normal to the cross.

#[cfg(feature = "verify")]
mod proof;

use crate::element::cross::CrossAxes;
use crate::fields;
use crate::formula::quantity::{E_CROSS, F2, F3, JOIN_F1, UJOINT_FR};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, cross_gradient};
use crate::number::scalar::{Scalar, direction, norm};
use nalgebra::Vector3;

fields! {
    /// The force that JOIN transmits, as components in a's triad.
    pub struct JoinForces<T> { f1: T = JOIN_F1, f2: T = F2, f3: T = F3 }
}
fields! {
    /// Its magnitude.
    pub struct ReactionForce<T> { fr: T = UJOINT_FR }
}

/// Reaction force: Fr = √(f1² + f2² + f3²).
#[derive(Clone, Copy, Debug)]
pub struct Reaction;

impl Formula for Reaction {
    const SPEC: Spec =
        Spec::new("ujoint.reaction", "Reaction force", Document::UJOINT.reconstructed("Friction", "the root was lost"))
            .equation(r"F_r = \sqrt{f_1^2 + f_2^2 + f_3^2}")
            .eta(1.5, 3.5)
            .scale(1e250)
            .finite(Finite::Below);
    type Inputs<T: Component> = JoinForces<T>;
    type Outputs<T: Component> = ReactionForce<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JoinForces<D>) -> ReactionForce<D> {
        ReactionForce { fr: norm([i.f1, i.f2, i.f3]) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &JoinForces<D>) -> Jacobian<Self, D> {
        let [f1, f2, f3] = direction([i.f1, i.f2, i.f3]);
        ReactionForce { fr: JoinForces { f1, f2, f3 } }
    }
}

fields! {
    /// The direction normal to them.
    pub struct CrossNormal<T> { e_cross: Vector3<T> = E_CROSS }
}

/// The direction normal to the cross: e_cross = e1a × e3b.
#[derive(Clone, Copy, Debug)]
pub struct CrossDirection;

impl Formula for CrossDirection {
    const SPEC: Spec =
        Spec::new("ujoint.cross_direction", "Direction normal to the cross", Document::UJOINT.printed("Friction"))
            .equation(r"\mathbf{e}_{\mathrm{cross}} = \mathbf{e}_{1a}\times\mathbf{e}_{3b}")
            .eta(1.0, 0.0)
            .scale(1e250)
            .finite(Finite::Below);
    type Inputs<T: Component> = CrossAxes<T>;
    type Outputs<T: Component> = CrossNormal<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossAxes<D>) -> CrossNormal<D> {
        CrossNormal { e_cross: i.e1a.cross(&i.e3b) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossAxes<D>) -> Jacobian<Self, D> {
        let row = |k| {
            let [by_e1a, by_e3b] = cross_gradient(&i.e1a, &i.e3b, k);
            CrossAxes { e1a: by_e1a.vector(), e3b: by_e3b.vector() }
        };
        CrossNormal { e_cross: Vector3::new(row(0), row(1), row(2)) }
    }
}
