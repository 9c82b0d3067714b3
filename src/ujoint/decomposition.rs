//! The force at the centre of the cross in parts along its axes and across them.

mod cancelling;

use super::{CrossAxes, CrossDirection};
use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Law, Source, Spec};
use crate::quantity::{CROSS_F_BEND, E1A, E2A, E3A, E3B, F_AXIAL1, F_AXIAL3, F1, F2, F3};
use crate::scalar::{Leaf, Scalar, norm};
use crate::verify::{hard, law};
use nalgebra::Vector3;

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
const fn rounding<L: Leaf>() -> f64 {
    4.0 * L::EPSILON
}

impl<D: Scalar> CrossLoads<D> {
    /// Which of them rounding may have given their sign.
    #[inline]
    fn doubtful(&self, rough: &CrossForces<D>) -> CrossForces<bool> {
        let size = |v: &Vector3<D>| v.x.re().abs() + v.y.re().abs() + v.z.re().abs();
        let (e1a, e3b) = (size(&self.e1a), size(&self.e3b));
        let beside = size(&self.e2a) * self.f2.re().abs() + size(&self.e3a) * self.f3.re().abs();
        let force = e1a * self.f1.re().abs() + beside;
        let is_lost = |x: D, size: f64| x.re().abs() < size * rounding::<D::Leaf>();
        CrossForces {
            f_axial1: is_lost(rough.f_axial1, force * e1a),
            f_axial3: is_lost(rough.f_axial3, force * e3b),
            f_bend: is_lost(rough.f_bend, beside * (e1a * e3b)),
        }
    }
}

impl Formula for Decomposition {
    const SPEC: Spec = Spec {
        id: "ujoint.decomposition",
        title: "Force in the axes of the cross",
        latex: r"F_{\mathrm{axial1}} = \mathbf{F}\cdot\mathbf{e}_{1a},\quad F_{\mathrm{axial3}} = \mathbf{F}\cdot\mathbf{e}_{3b},\quad F_{\mathrm{bend}} = \mathbf{F}\cdot\mathbf{e}_{\mathrm{cross}},\quad \mathbf{F} = f_1\mathbf{e}_{1a} + f_2\mathbf{e}_{2a} + f_3\mathbf{e}_{3a}",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 2.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossLoads<T>;
    type Outputs<T: Element> = CrossForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossLoads<D>) -> CrossForces<D> {
        let rough = i.decomposed();
        let CrossForces { f_axial1, f_axial3, f_bend } = i.doubtful(&rough);
        if f_axial1 | f_axial3 | f_bend { i.settled(rough) } else { rough }
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
        // A force of few digits could make a result that lies exactly between two doubles, which 237 bits do not see.
        add(format!("{id}-f1"), comment, a, e3b, [-2.3, 0.0, 0.0]);
        add(format!("{id}-f2"), comment, a, e3b, [0.0, 2.3, 0.0]);
        add(format!("{id}-f3"), comment, a, e3b, [0.0, 0.0, 2.3]);
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
