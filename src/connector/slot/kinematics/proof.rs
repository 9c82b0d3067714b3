//! Evidence for the formulas of the parent module: cases, laws.

use super::{
    Constraint, Constraint2d, ConstraintForce, CrossFrame, KineticForce, RelativeMotion, RelativePosition, SlotForce,
    SlotLengths, SlotPositions, SlotPositions2d, Stop, StopLengths,
};
use crate::element::line::Positions;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use nalgebra::{Vector2, Vector3};

impl Proved for RelativePosition {
    fn cases() -> Vec<Case<Positions<f64>>> {
        let [e1a, e2a, e3a] = hard::triad();
        let hand = Positions {
            e1a: Vector3::x(),
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            xa: Vector3::new(1.0, 2.0, 3.0),
            xb: Vector3::new(4.0, 6.0, 15.0),
        };
        let mut cases = vec![
            Case::running("a along the global axes: the plain difference (3, 4, 12)", hand),
            Case::hand(
                "quarter-turn",
                "a turned by 90° about 3: x along the global y",
                Positions { e1a: Vector3::y(), e2a: -Vector3::x(), ..hand },
            ),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            Case::hard(place.id, place.comment, Positions { e1a, e2a, e3a, xa, xb })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the components rebuild the vector from a to b, on orthonormal triads", |i| {
            let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e2a, i.e3a]);
            let r = Self::eval(&Positions { e1a, e2a, e3a, ..*i });
            law::equal_vectors(e1a * r.x + e2a * r.y + e3a * r.z, i.xb - i.xa)
        })]
    }
}

impl Proved for Constraint {
    fn cases() -> Vec<Case<SlotPositions<f64>>> {
        let [_, e2a, e3a] = hard::triad();
        let hand = SlotPositions {
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            xa: Vector3::new(1.0, 2.0, 3.0),
            xb: Vector3::new(4.0, 6.0, 15.0),
            y0: 4.0,
            z0: 12.0,
        };
        let mut cases = vec![
            Case::hand("on-the-slot", "b at (y0, z0): both residuals vanish", hand),
            Case::running("y - y0 = 4 - 5, z - z0 = 12 - 10", SlotPositions { y0: 5.0, z0: 10.0, ..hand }),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            Case::hard(place.id, place.comment, SlotPositions { e2a, e3a, xa, xb, y0: 0.25, z0: -0.5 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("moving b along the slot does not change the residuals", |i| {
                let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                let moved = |xb| Self::eval(&SlotPositions { e2a, e3a, xb, ..*i });
                let (here, there) = (moved(i.xb), moved(i.xb + e1a));
                law::equal_all_with([(here.gy, there.gy), (here.gz, there.gz)], law::length(i.xa) + law::length(i.xb))
            }),
            Law::<Self>::new(
                "the constraint force is Jacobianᵀ · multiplier: f2 ∂gy/∂xb + f3 ∂gz/∂xb = f",
                |i| {
                    let jac = Self::jacobian(i);
                    let (f2, f3) = (i.y0, i.z0); // arbitrary numbers
                    let f = ConstraintForce::eval(&CrossFrame { e2a: i.e2a, e3a: i.e3a, f2, f3 }).f;
                    law::equal_vectors(jac.gy.xb * f2 + jac.gz.xb * f3, f)
                },
            ),
        ]
    }
}

impl Proved for Constraint2d {
    fn cases() -> Vec<Case<SlotPositions2d<f64>>> {
        let [_, e2a] = hard::plane_triad();
        let hand = SlotPositions2d { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(7.0, 2.0), y0: 2.0 };
        let mut cases = vec![
            Case::hand("on-the-slot", "b at y0: the residual vanishes", hand),
            Case::hand("off-the-slot", "y - y0 = 2 - 5", SlotPositions2d { y0: 5.0, ..hand }),
            Case::running(
                "y - y0 = 4 - 5",
                SlotPositions2d { xa: Vector2::new(1.0, 2.0), xb: Vector2::new(4.0, 6.0), y0: 5.0, ..hand },
            ),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            Case::hard(place.id, place.comment, SlotPositions2d { e2a, xa, xb, y0: 0.25 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("it is gy of the constraint in space, in the plane z = 0", |i| {
            let space = |v: Vector2<_>| Vector3::new(v.x, v.y, num_traits::Zero::zero());
            let plane = SlotPositions {
                e2a: space(i.e2a),
                xa: space(i.xa),
                xb: space(i.xb),
                y0: i.y0,
                ..SlotPositions::filled(i.y0)
            };
            law::equal(Self::eval(i).gy, Constraint::eval(&plane).gy)
        })]
    }
}

impl Proved for ConstraintForce {
    fn cases() -> Vec<Case<CrossFrame<f64>>> {
        let [_, e2a, e3a] = hard::triad();
        let axes = CrossFrame { e2a: Vector3::y(), e3a: Vector3::z(), f2: 3.0, f3: 4.0 };
        let mut cases = vec![
            Case::running("f = (0, 3, 4)", axes),
            Case::limit("plane", "in the plane f3 = 0", CrossFrame { f3: 0.0, ..axes }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f2, f3] = load.value;
            Case::hard(load.id, "loads of extreme size", CrossFrame { e2a, e3a, f2, f3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("it does no work along the slot, on orthonormal triads", |i| {
            let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
            law::no_work(Self::eval(&CrossFrame { e2a, e3a, ..*i }).f, e1a)
        })]
    }
}

impl Proved for RelativeMotion {
    fn cases() -> Vec<Case<SlotLengths<f64>>> {
        let hand = SlotLengths { x: 3.0, x0: 1.0, l1_ref: 0.5 };
        vec![
            Case::running("u1 = 3 - 1, u1_mat = 3 - 0.5", hand),
            Case::hand("start", "no displacement at the start", SlotLengths { x: 1.0, ..hand }),
            Case::hard(
                "far",
                "lengths of 1e12 that differ by 1",
                SlotLengths { x: 1e12 + 1.0, x0: 1e12, l1_ref: 1e12 - 1.0 },
            ),
            Case::hard(
                "ulp",
                "lengths one ulp apart",
                SlotLengths { x: 1.0_f64.next_up(), x0: 1.0, l1_ref: 1.0_f64.next_down() },
            ),
            Case::hard("huge", "1e200 against 1e-200", SlotLengths { x: 1e200, x0: 1e-200, l1_ref: -1e200 }),
            Case::hard("tiny", "lengths of 1e-200", SlotLengths { x: 3e-200, x0: 1e-200, l1_ref: -1e-200 }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("both displacements grow as x does", |i| {
            let (here, there) = (Self::eval(i), Self::eval(&SlotLengths { x: i.x + 1.0, ..*i }));
            law::equal_all_with([(there.u1 - here.u1, 1.0.into()), (there.u1_mat - here.u1_mat, 1.0.into())], i.x)
        })]
    }
}

impl Proved for KineticForce {
    fn cases() -> Vec<Case<SlotForce<f64>>> {
        let [e1a, ..] = hard::triad();
        let mut cases = vec![Case::running("f = (-2, 0, 0)", SlotForce { e1a: Vector3::x(), f1: -2.0 })];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f1] = load.value;
            Case::hard(load.id, "a load of extreme size", SlotForce { e1a, f1 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("its power is f1 times the velocity along the slot: f·∂x/∂xb = f1 e1a·e1a", |i| {
            law::equal(Self::eval(i).f.dot(&i.e1a), i.f1 * i.e1a.dot(&i.e1a))
        })]
    }
}

impl Proved for Stop {
    fn cases() -> Vec<Case<StopLengths<f64>>> {
        let hand = StopLengths { x: 3.0, l1_min: 1.0, l1_max: 7.0 };
        vec![
            Case::running("2 above the lower stop, 4 below the upper", hand),
            Case::limit("at-lower", "the lower gap is 0", StopLengths { x: 1.0, ..hand }),
            Case::limit("at-upper", "the upper gap is 0", StopLengths { x: 7.0, ..hand }),
            Case::hand("beyond", "the upper gap is negative", StopLengths { x: 8.0, ..hand }),
            Case::hand("closed", "both stops coincide", StopLengths { l1_min: 7.0, ..hand }),
            Case::hard(
                "ulp",
                "one ulp from both stops",
                StopLengths { x: 1.0, l1_min: 1.0_f64.next_down(), l1_max: 1.0_f64.next_up() },
            ),
            Case::hard(
                "far",
                "lengths of 1e12 that differ by 1",
                StopLengths { x: 1e12, l1_min: 1e12 - 1.0, l1_max: 1e12 + 1.0 },
            ),
            Case::hard("huge", "stops at ±1e200", StopLengths { x: 1e-200, l1_min: -1e200, l1_max: 1e200 }),
        ]
    }

    fn invalid_cases() -> Vec<Case<StopLengths<f64>>> {
        vec![Case::invalid(
            "crossed-stops",
            "the lower stop is above the upper",
            StopLengths { x: 3.0, l1_min: 7.0, l1_max: 1.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the gaps add up to the distance between the stops", |i| {
            law::equal_with(Self::eval(i).gap_min + Self::eval(i).gap_max, i.l1_max - i.l1_min, i.x)
        })]
    }
}
