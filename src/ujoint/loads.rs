//! The force at the centre of the cross, and its parts along the axes of the cross.

use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec, along};
use crate::quantity::{CROSS_F_BEND, E_CROSS, E1A, E2A, E3A, E3B, F_AXIAL1, F_AXIAL3, F1, F2, F3, UJOINT_FR};
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

fields! {
    /// How the nodes are turned, and the force that JOIN transmits.
    pub struct CrossLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = F1, f2: T = F2, f3: T = F3,
    }
}
fields! {
    /// The force along the axes of the cross and across them.
    pub struct CrossForces<T> { f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, f_bend: T = CROSS_F_BEND }
}

/// The force F = f1 e1a + f2 e2a + f3 e3a along the axes of the cross and across them: F·e1a, F·e3b, F·(e1a × e3b).
///
/// The part f1 e1a has nothing across the cross, whatever the vectors are; it is left out there, lest its rounding show.
/// The signs of all three are right: where one force alone acts along an axis of a's triad, F·e1a is what rounding
/// has left in the triad, and the derivative of |F·e1a| hangs on its sign.
#[derive(Clone, Copy, Debug)]
pub struct Decomposition;

impl<D: Scalar> CrossLoads<D> {
    /// f2 e2a + f3 e3a: the part of F that is not along e1a.
    #[inline]
    pub(super) fn force_beside_e1a(&self) -> Vector3<D> {
        self.e2a * self.f2 + self.e3a * self.f3
    }

    #[inline]
    pub(super) fn e_cross(&self) -> Vector3<D> {
        CrossDirection::eval(&CrossAxes { e1a: self.e1a, e3b: self.e3b }).e_cross
    }

    /// The three products as they stand.
    #[inline]
    fn decomposed(&self) -> CrossForces<D> {
        let beside = self.force_beside_e1a();
        let force = self.e1a * self.f1 + beside;
        CrossForces {
            f_axial1: force.dot(&self.e1a),
            f_axial3: force.dot(&self.e3b),
            f_bend: beside.dot(&self.e_cross()),
        }
    }
}

/// The rounding error of [`CrossLoads::decomposed`] is below this part of the sum of the sizes of all products.
const ROUNDING: f64 = 8.0 * f64::EPSILON / 2.0;

impl<D: Scalar> CrossLoads<D> {
    /// Whether rounding may have decided a sign.
    #[inline]
    fn is_doubtful(&self, rough: &CrossForces<D>) -> bool {
        let size = |v: &Vector3<D>| v.x.re().abs() + v.y.re().abs() + v.z.re().abs();
        let (e1a, e3b) = (size(&self.e1a), size(&self.e3b));
        let beside = size(&self.e2a) * self.f2.re().abs() + size(&self.e3a) * self.f3.re().abs();
        let force = e1a * self.f1.re().abs() + beside;
        let is_lost = |x: D, size: f64| x.re().abs() < size * ROUNDING;
        is_lost(rough.f_axial1, force * e1a)
            | is_lost(rough.f_axial3, force * e3b)
            | is_lost(rough.f_bend, beside * (e1a * e3b))
    }

    /// Replaces what rounding may have spoilt by what 237 bits give.
    #[cold]
    fn recomputed(self, rough: CrossForces<D>) -> CrossForces<D> {
        let exact = |v: &Vector3<D>| v.map(Scalar::exact);
        let [e1a, e2a, e3a, e3b] = [&self.e1a, &self.e2a, &self.e3a, &self.e3b].map(exact);
        let [f1, f2, f3] = [self.f1, self.f2, self.f3].map(Scalar::exact);
        let exact = CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 }.decomposed();
        CrossForces {
            f_axial1: rough.f_axial1.with_value(exact.f_axial1),
            f_axial3: rough.f_axial3.with_value(exact.f_axial3),
            f_bend: rough.f_bend.with_value(exact.f_bend),
        }
    }
}

impl Formula for Decomposition {
    const SPEC: Spec = Spec {
        id: "ujoint.decomposition",
        title: "Force in the axes of the cross",
        latex: r"F_{\mathrm{axial1}} = \mathbf{F}\cdot\mathbf{e}_{1a},\quad F_{\mathrm{axial3}} = \mathbf{F}\cdot\mathbf{e}_{3b},\quad F_{\mathrm{bend}} = \mathbf{F}\cdot\mathbf{e}_{\mathrm{cross}},\quad \mathbf{F} = f_1\mathbf{e}_{1a} + f_2\mathbf{e}_{2a} + f_3\mathbf{e}_{3a}",
        source: Source::UJOINT.section("Friction"),
        eta: 4.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossLoads<T>;
    type Outputs<T: Element> = CrossForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossLoads<D>) -> CrossForces<D> {
        let rough = i.decomposed();
        if i.is_doubtful(&rough) { i.recomputed(rough) } else { rough }
    }

    fn jacobian<D: Scalar>(i: &CrossLoads<D>) -> Jacobian<Self, D> {
        let beside = i.force_beside_e1a();
        let force = i.e1a * i.f1 + beside;
        let e_cross = i.e_cross();
        let [e1a, e2a, e3a, e3b] = [i.e1a, i.e2a, i.e3a, i.e3b];
        let zero = CrossLoads::filled(D::zero());
        CrossForces {
            f_axial1: CrossLoads {
                e1a: force + e1a * i.f1,
                e2a: e1a * i.f2,
                e3a: e1a * i.f3,
                f1: e1a.dot(&e1a),
                f2: e2a.dot(&e1a),
                f3: e3a.dot(&e1a),
                ..zero
            },
            f_axial3: CrossLoads {
                e1a: e3b * i.f1,
                e2a: e3b * i.f2,
                e3a: e3b * i.f3,
                e3b: force,
                f1: e1a.dot(&e3b),
                f2: e2a.dot(&e3b),
                f3: e3a.dot(&e3b),
            },
            f_bend: CrossLoads {
                e1a: e3b.cross(&beside),
                e2a: e_cross * i.f2,
                e3a: e_cross * i.f3,
                e3b: beside.cross(&e1a),
                f1: D::zero(),
                f2: e2a.dot(&e_cross),
                f3: e3a.dot(&e_cross),
            },
        }
    }

    fn cases() -> Vec<Case<CrossLoads<f64>>> {
        let hand = CrossLoads {
            e1a: Vector3::x(),
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            e3b: Vector3::new(0.0, -0.6, 0.8),
            f1: 2.0,
            f2: 5.0,
            f3: 10.0,
        };
        let mut cases = vec![
            Case::hand(
                "bent",
                "sin α = 0.6: 2, -0.6 × 5 + 0.8 × 10 = 5, e_cross = (0, -0.8, -0.6): -4 - 6 = -10",
                hand,
            ),
            Case::hand("straight", "e3b = e3a: 2, 10, -5", CrossLoads { e3b: Vector3::z(), ..hand }),
        ];
        cases.extend(hard_loads().into_iter().map(|load| Case::hard(load.id, load.comment, load.inputs)));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "where the axes of the cross are perpendicular, the three parts rebuild the force",
                sides: |i| {
                    let [e1a, e3b, across] = law::orthonormal([i.e1a, i.e3b, i.e3b]);
                    let i = CrossLoads { e1a, e3b, ..*i };
                    let CrossForces { f_axial1, f_axial3, f_bend } = Self::eval(&i);
                    let force = i.e1a * i.f1 + i.force_beside_e1a();
                    law::equal_vectors(e1a * f_axial1 + e3b * f_axial3 + across * f_bend, force)
                },
            },
            Law {
                statement: "f1 does not bend the cross, whatever the vectors are",
                sides: |i| {
                    let without = Self::eval(&CrossLoads { f1: Octuple::from(0.0), ..*i });
                    law::equal(Self::eval(i).f_bend, without.f_bend)
                },
            },
            Law {
                statement: "exchanging the axes of the cross under the same force exchanges the axial parts and reverses the other",
                sides: |i| {
                    let (one, zero) = (Octuple::from(1.0), Octuple::from(0.0));
                    let force = i.e1a * i.f1 + i.force_beside_e1a();
                    let exchanged =
                        CrossLoads { e1a: i.e3b, e2a: force, e3a: force, e3b: i.e1a, f1: zero, f2: one, f3: zero };
                    let (here, there) = (Self::eval(i), Self::eval(&exchanged));
                    let size = norm([force.x, force.y, force.z]);
                    [
                        law::equal_with(here.f_axial1, there.f_axial3, size),
                        law::equal_with(here.f_axial3, there.f_axial1, size),
                        law::equal_with(here.f_bend, -there.f_bend, size),
                    ]
                    .concat()
                },
            },
        ]
    }
}

/// Inputs with a name.
pub(super) struct HardLoads {
    pub(super) id: String,
    pub(super) comment: &'static str,
    pub(super) inputs: CrossLoads<f64>,
}

/// Each force alone in each position of the joint, and forces of extreme size.
pub(super) fn hard_loads() -> Vec<HardLoads> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let [e1a, e2a, e3a] = hard::triad();
    let lost = "what the force has along an axis of the cross is rounding of the triad, whose sign counts";
    let positions = [
        ("straight", "the other forces are 0: on kinks", axes, axes[2]),
        ("quarter", "α = 90°", axes, -axes[1]),
        ("quarter-back", "α = -90°", axes, axes[1]),
        ("half", "α = ±180°", axes, -axes[2]),
        ("off-axis-straight", lost, hard::triad(), e3a),
        ("off-axis-quarter", lost, hard::triad(), -e2a),
        ("off-axis-bent", lost, hard::triad(), e3a * 0.8 - e2a * 0.6),
        ("nearly-folded", "the axes of the cross coincide to 1e-8", hard::triad(), e1a + e2a * 1e-8),
    ];
    let mut loads = Vec::new();
    let mut add = |id: String, comment, [e1a, e2a, e3a]: [Vector3<f64>; 3], e3b, [f1, f2, f3]: [f64; 3]| {
        loads.push(HardLoads { id, comment, inputs: CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 } });
    };
    for (id, comment, a, e3b) in positions {
        add(format!("{id}-f1"), comment, a, e3b, [-2.5, 0.0, 0.0]);
        add(format!("{id}-f2"), comment, a, e3b, [0.0, 2.5, 0.0]);
        add(format!("{id}-f3"), comment, a, e3b, [0.0, 0.0, 2.5]);
    }
    let bent = e3a * 0.8 - e2a * 0.6;
    add("unloaded".into(), "no force at all", hard::triad(), bent, [0.0; 3]);
    for size in [1e-200, 1e-150, 1e-100, 1e100, 1e150, 1e200] {
        let forces = [3.0, -4.0, 12.0].map(|f| f * size);
        add(format!("forces-{size:e}"), "forces of extreme size", hard::triad(), bent, forces);
    }
    for size in [1e-150, 1e150] {
        let alone = "one force of extreme size alone";
        add(format!("f1-alone-{size:e}"), alone, hard::triad(), bent, [-size, 0.0, 0.0]);
        add(format!("f2-alone-{size:e}"), alone, hard::triad(), bent, [0.0, size, 0.0]);
        add(format!("f3-alone-{size:e}"), alone, hard::triad(), bent, [0.0, 0.0, size]);
    }
    for (id, forces) in [("large-f1", [1e17, 1.0, 1.0]), ("large-f2", [1.0, 1e17, 1.0]), ("large-f3", [1.0, 1.0, 1e17])]
    {
        add(id.into(), "one force 1e17 times the others", hard::triad(), bent, forces);
    }
    loads
}
