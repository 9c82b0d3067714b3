//! The force that the joint transmits, and the direction across the cross.

use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec, along};
use crate::quantity::{E_CROSS, E1A, E3B, F1, F2, F3, UJOINT_FR};
use crate::scalar::{Scalar, direction, norm};
use crate::verify::{hard, law};
use nalgebra::Vector3;

fields! {
    /// The force that JOIN transmits, as components in a's triad.
    pub struct JoinForces<T> { f1: T = F1, f2: T = F2, f3: T = F3 }
}
fields! {
    /// Its magnitude.
    pub struct ReactionForce<T> { fr: T = UJOINT_FR }
}

/// Reaction force: Fr = √(f1² + f2² + f3²).
#[derive(Clone, Copy, Debug)]
pub struct Reaction;

impl Formula for Reaction {
    const SPEC: Spec = Spec {
        id: "ujoint.reaction",
        title: "Reaction force",
        latex: r"F_r = \sqrt{f_1^2 + f_2^2 + f_3^2}",
        source: Source::UJOINT.section("Friction"),
        eta: 1.5,
        eta_jacobian: 3.5,
        objective: true,
    };
    type Inputs<T: Element> = JoinForces<T>;
    type Outputs<T: Element> = ReactionForce<T>;

    fn eval<D: Scalar>(i: &JoinForces<D>) -> ReactionForce<D> {
        ReactionForce { fr: norm([i.f1, i.f2, i.f3]) }
    }

    fn jacobian<D: Scalar>(i: &JoinForces<D>) -> Jacobian<Self, D> {
        let [f1, f2, f3] = direction([i.f1, i.f2, i.f3]);
        ReactionForce { fr: JoinForces { f1, f2, f3 } }
    }

    fn cases() -> Vec<Case<JoinForces<f64>>> {
        let mut cases = vec![Case::hand("pythagoras", "3-4-12-13", JoinForces { f1: 3.0, f2: -4.0, f3: 12.0 })];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f1, f2, f3] = load.value;
            Case::hard(load.id, load.comment, JoinForces { f1, f2, f3 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "f_1 = f_2 = f_3 = 0",
            convention: Convention::Subgradient,
            holds: |i| i.f1 == 0.0 && i.f2 == 0.0 && i.f3 == 0.0,
            at: || JoinForces { f1: 0.0, f2: 0.0, f3: 0.0 },
            across: || JoinForces { f1: 1.0, f2: 2.0, f3: -2.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "it is the length of f1 e1a + f2 e2a + f3 e3a on an orthonormal triad",
            sides: |i| {
                let [e1a, e2a, e3a] = hard::triad().map(|e| e.map(Octuple::from));
                let [e1a, e2a, e3a] = law::orthonormal([e1a, e2a, e3a]);
                let f = e1a * i.f1 + e2a * i.f2 + e3a * i.f3;
                law::equal(Self::eval(i).fr, norm([f.x, f.y, f.z]))
            },
        }]
    }
}

fields! {
    /// The axes of the cross.
    pub struct CrossAxes<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B }
}
fields! {
    /// The direction across them.
    pub struct CrossNormal<T> { e_cross: Vector3<T> = E_CROSS }
}

/// The direction across the cross: e_cross = e1a × e3b.
#[derive(Clone, Copy, Debug)]
pub struct CrossDirection;

impl Formula for CrossDirection {
    const SPEC: Spec = Spec {
        id: "ujoint.cross_direction",
        title: "Direction across the cross",
        latex: r"\mathbf{e}_{\mathrm{cross}} = \mathbf{e}_{1a}\times\mathbf{e}_{3b}",
        source: Source::UJOINT.section("Friction"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossAxes<T>;
    type Outputs<T: Element> = CrossNormal<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossAxes<D>) -> CrossNormal<D> {
        CrossNormal { e_cross: i.e1a.cross(&i.e3b) }
    }

    fn jacobian<D: Scalar>(i: &CrossAxes<D>) -> Jacobian<Self, D> {
        let row = |k| {
            let unit = along(k, D::one());
            CrossAxes { e1a: i.e3b.cross(&unit), e3b: unit.cross(&i.e1a) }
        };
        CrossNormal { e_cross: Vector3::new(row(0), row(1), row(2)) }
    }

    fn cases() -> Vec<Case<CrossAxes<f64>>> {
        let [e1a, e2a, e3a] = hard::triad();
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let mut cases = vec![
            Case::hand("straight", "x × z = -y", CrossAxes { e1a: x, e3b: z }),
            Case::hand("alpha-90", "b turned by 90° about e1a: x × -y = -z", CrossAxes { e1a: x, e3b: -y }),
            Case::limit("folded", "the axes of the cross coincide: no direction", CrossAxes { e1a: x, e3b: x }),
            Case::hard("off-axis", "e1a × e3a = -e2a, every component a difference", CrossAxes { e1a, e3b: e3a }),
            Case::hard("parallel", "the zero vector: every product cancels", CrossAxes { e1a, e3b: -e1a }),
        ];
        for (id, angle) in
            [("nearly-parallel-1e-4", 1e-4), ("nearly-parallel-1e-8", 1e-8), ("nearly-parallel-1e-12", 1e-12)]
        {
            let e3b = e1a + e2a * angle;
            cases.push(Case::hard(id, "axes of the cross that nearly coincide", CrossAxes { e1a, e3b }));
        }
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "it is perpendicular to both axes",
                sides: |i| {
                    let e_cross = Self::eval(i).e_cross;
                    [law::no_work(e_cross, i.e1a), law::no_work(e_cross, i.e3b)].concat()
                },
            },
            Law {
                statement: "exchanging the axes reverses it",
                sides: |i| {
                    let exchanged = Self::eval(&CrossAxes { e1a: i.e3b, e3b: i.e1a }).e_cross;
                    law::equal_vectors(Self::eval(i).e_cross, -exchanged)
                },
            },
        ]
    }
}
