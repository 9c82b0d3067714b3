//! Evidence for the formula of the parent module: cases, laws.

use super::{CrossForces, CrossLoads, Decomposition};
use crate::Octuple;
use crate::connector::ujoint::running::{E3B, FORCE};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use crate::number::scalar::norm;
use nalgebra::Vector3;

impl Proved for Decomposition {
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
        let [f1, f2, f3] = FORCE;
        let mut cases = vec![
            Case::running("-4.4, 2.46 + 15.04, 3.28 - 11.28", CrossLoads { e3b: E3B, f1, f2, f3, ..hand }),
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
            Law::<Self>::new("where the axes of the cross are perpendicular, the three parts rebuild the force", |i| {
                let [e1a, e3b, across] = law::orthonormal([i.e1a, i.e3b, i.e3b]);
                let i = CrossLoads { e1a, e3b, ..*i };
                let CrossForces { f_axial1, f_axial3, f_bend } = Self::eval(&i);
                let force = i.e1a * i.f1 + i.force_beside_e1a();
                law::equal_vectors(e1a * f_axial1 + e3b * f_axial3 + across * f_bend, force)
            }),
            Law::<Self>::new("f1 does not bend the cross, for any vectors", |i| {
                let without = Self::eval(&CrossLoads { f1: Octuple::from(0.0), ..*i });
                law::equal(Self::eval(i).f_bend, without.f_bend)
            }),
            Law::<Self>::new(
                "exchanging the axes of the cross under the same force exchanges the axial parts and reverses the other",
                |i| {
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
            ),
        ]
    }
}

/// Each force alone in each position of the joint, and forces of extreme size.
pub(crate) fn hard_loads() -> Vec<HardLoads> {
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
        // A force with few digits could give a result exactly halfway between two doubles, which 237 bits do not detect.
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

/// Inputs with a name.
pub(crate) struct HardLoads {
    pub(crate) id: String,
    pub(crate) comment: &'static str,
    pub(crate) inputs: CrossLoads<f64>,
}
