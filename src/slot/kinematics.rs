//! Where b is along the slot, what holds it there, and the forces that do.

use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Law, Source, Spec, along};
use crate::quantity::{
    E1A, E2A, E2A_PLANE, E3A, F1, F2, F3, FORCE, GAP_MAX, GAP_MIN, GY, GZ, L1_MAX, L1_MIN, L1_REF, U1, U1_MAT, X, X0,
    XA, XA_PLANE, XB, XB_PLANE, Y, Y0, Z, Z0,
};
use crate::scalar::Scalar;
use crate::verify::{hard, law};
use nalgebra::{Vector2, Vector3};

fields! {
    /// Where the nodes are, and how node a is turned.
    pub struct Positions<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}
fields! {
    /// The relative position of b in the triad of a.
    pub struct Relative<T> { x: T = X, y: T = Y, z: T = Z }
}

/// Relative position of b in a's triad: x = e1a·(xb − xa), y = e2a·(xb − xa), z = e3a·(xb − xa).
#[derive(Clone, Copy, Debug)]
pub struct RelativePosition;

impl Formula for RelativePosition {
    const SPEC: Spec = Spec {
        id: "slot.relative_position",
        title: "Relative position",
        latex: r"x = \mathbf{e}_{1a}\cdot(\mathbf{x}_b-\mathbf{x}_a),\quad y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a),\quad z = \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a)",
        source: Source::SLOT.section("Description"),
        eta: 4.0,
        eta_jacobian: 1.0,
        objective: true,
    };
    type Inputs<T: Element> = Positions<T>;
    type Outputs<T: Element> = Relative<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Positions<D>) -> Relative<D> {
        let d = i.xb - i.xa;
        Relative { x: i.e1a.dot(&d), y: i.e2a.dot(&d), z: i.e3a.dot(&d) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Positions<D>) -> Jacobian<Self, D> {
        let d = i.xb - i.xa;
        let zero = Positions::filled(D::zero());
        Relative {
            x: Positions { e1a: d, xa: -i.e1a, xb: i.e1a, ..zero },
            y: Positions { e2a: d, xa: -i.e2a, xb: i.e2a, ..zero },
            z: Positions { e3a: d, xa: -i.e3a, xb: i.e3a, ..zero },
        }
    }

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
            Case::hand("axes", "a along the global axes: the plain difference (3, 4, 12)", hand),
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
        vec![Law {
            statement: "the components rebuild the vector from a to b, on orthonormal triads",
            sides: |i| {
                let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e2a, i.e3a]);
                let r = Self::eval(&Positions { e1a, e2a, e3a, ..*i });
                law::equal_vectors(e1a * r.x + e2a * r.y + e3a * r.z, i.xb - i.xa)
            },
        }]
    }
}

fields! {
    /// Where the nodes are, how node a is turned, and where the slot lies.
    pub struct SlotPositions<T> {
        e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, xa: Vector3<T> = XA, xb: Vector3<T> = XB,
        y0: T = Y0, z0: T = Z0,
    }
}
fields! {
    /// By how much b is off the slot.
    pub struct Residuals<T> { gy: T = GY, gz: T = GZ }
}

/// The two conditions that hold b on the slot: y − y0 = 0, z − z0 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "slot.constraint",
        title: "Constraint",
        latex: r"g_y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0,\quad g_z = \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - z_0",
        source: Source::SLOT.section("Description"),
        eta: 4.0,
        eta_jacobian: 1.0,
        objective: true,
    };
    type Inputs<T: Element> = SlotPositions<T>;
    type Outputs<T: Element> = Residuals<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotPositions<D>) -> Residuals<D> {
        let d = i.xb - i.xa;
        Residuals { gy: i.e2a.dot(&d) - i.y0, gz: i.e3a.dot(&d) - i.z0 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotPositions<D>) -> Jacobian<Self, D> {
        let d = i.xb - i.xa;
        let zero = SlotPositions::filled(D::zero());
        Residuals {
            gy: SlotPositions { e2a: d, xa: -i.e2a, xb: i.e2a, y0: -D::one(), ..zero },
            gz: SlotPositions { e3a: d, xa: -i.e3a, xb: i.e3a, z0: -D::one(), ..zero },
        }
    }

    fn cases() -> Vec<Case<SlotPositions<f64>>> {
        let [_, e2a, e3a] = hard::triad();
        let hand = SlotPositions {
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            xa: Vector3::zeros(),
            xb: Vector3::new(7.0, 2.0, -3.0),
            y0: 2.0,
            z0: -3.0,
        };
        let mut cases = vec![
            Case::hand("on-the-slot", "b at (y0, z0): both residuals vanish", hand),
            Case::hand("off-the-slot", "y - y0 = 2 - 5, z - z0 = -3 - 1", SlotPositions { y0: 5.0, z0: 1.0, ..hand }),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            Case::hard(place.id, place.comment, SlotPositions { e2a, e3a, xa, xb, y0: 0.25, z0: -0.5 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "moving b along the slot leaves the residuals",
                sides: |i| {
                    let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                    let moved = |xb| Self::eval(&SlotPositions { e2a, e3a, xb, ..*i });
                    let (here, there) = (moved(i.xb), moved(i.xb + e1a));
                    law::equal_all_with(
                        [(here.gy, there.gy), (here.gz, there.gz)],
                        law::length(i.xa) + law::length(i.xb),
                    )
                },
            },
            Law {
                statement: "the constraint force is Jacobianᵀ · multiplier: f2 ∂gy/∂xb + f3 ∂gz/∂xb = f",
                sides: |i| {
                    let jac = Self::jacobian(i);
                    let (f2, f3) = (i.y0, i.z0); // any two numbers will do
                    let f = ConstraintForce::eval(&CrossFrame { e2a: i.e2a, e3a: i.e3a, f2, f3 }).f;
                    law::equal_vectors(jac.gy.xb * f2 + jac.gz.xb * f3, f)
                },
            },
        ]
    }
}

fields! {
    /// As [`SlotPositions`], in the plane.
    pub struct SlotPositions2d<T> {
        e2a: Vector2<T> = E2A_PLANE, xa: Vector2<T> = XA_PLANE, xb: Vector2<T> = XB_PLANE, y0: T = Y0,
    }
}
fields! {
    /// By how much b is off the slot in the plane.
    pub struct Residual2d<T> { gy: T = GY }
}

/// The condition that holds b on the slot in the plane: y − y0 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint2d;

impl Formula for Constraint2d {
    const SPEC: Spec = Spec {
        id: "slot.constraint_2d",
        title: "Constraint in the plane",
        latex: r"g_y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0",
        source: Source::SLOT.section("Description"),
        eta: 4.0,
        eta_jacobian: 1.0,
        objective: true,
    };
    type Inputs<T: Element> = SlotPositions2d<T>;
    type Outputs<T: Element> = Residual2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotPositions2d<D>) -> Residual2d<D> {
        Residual2d { gy: i.e2a.dot(&(i.xb - i.xa)) - i.y0 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotPositions2d<D>) -> Jacobian<Self, D> {
        Residual2d { gy: SlotPositions2d { e2a: i.xb - i.xa, xa: -i.e2a, xb: i.e2a, y0: -D::one() } }
    }

    fn cases() -> Vec<Case<SlotPositions2d<f64>>> {
        let [_, e2a] = hard::plane_triad();
        let hand = SlotPositions2d { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(7.0, 2.0), y0: 2.0 };
        let mut cases = vec![
            Case::hand("on-the-slot", "b at y0: the residual vanishes", hand),
            Case::hand("off-the-slot", "y - y0 = 2 - 5", SlotPositions2d { y0: 5.0, ..hand }),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            Case::hard(place.id, place.comment, SlotPositions2d { e2a, xa, xb, y0: 0.25 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "it is gy of the constraint in space, in the plane z = 0",
            sides: |i| {
                let space = |v: Vector2<_>| Vector3::new(v.x, v.y, num_traits::Zero::zero());
                let plane = SlotPositions {
                    e2a: space(i.e2a),
                    xa: space(i.xa),
                    xb: space(i.xb),
                    y0: i.y0,
                    ..SlotPositions::filled(i.y0)
                };
                law::equal(Self::eval(i).gy, Constraint::eval(&plane).gy)
            },
        }]
    }
}

fields! {
    /// The two directions across the slot, and the constraint force along them.
    pub struct CrossFrame<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, f2: T = F2, f3: T = F3 }
}
fields! {
    /// A force on node b.
    pub struct Force<T> { f: Vector3<T> = FORCE }
}

/// The force that holds b on the slot: f = f2 e2a + f3 e3a. In the plane f3 = 0.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintForce;

impl Formula for ConstraintForce {
    const SPEC: Spec = Spec {
        id: "slot.constraint_force",
        title: "Constraint force",
        latex: r"\mathbf{f} = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a}",
        source: Source::SLOT.section("Description"),
        eta: 2.0,
        eta_jacobian: 1.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossFrame<T>;
    type Outputs<T: Element> = Force<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossFrame<D>) -> Force<D> {
        Force { f: i.e2a * i.f2 + i.e3a * i.f3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossFrame<D>) -> Jacobian<Self, D> {
        let row = |k| CrossFrame { e2a: along(k, i.f2), e3a: along(k, i.f3), f2: i.e2a[k], f3: i.e3a[k] };
        Force { f: Vector3::new(row(0), row(1), row(2)) }
    }

    fn cases() -> Vec<Case<CrossFrame<f64>>> {
        let [_, e2a, e3a] = hard::triad();
        let axes = CrossFrame { e2a: Vector3::y(), e3a: Vector3::z(), f2: 3.0, f3: 4.0 };
        let mut cases = vec![
            Case::hand("axes", "f = (0, 3, 4)", axes),
            Case::limit("plane", "in the plane f3 = 0", CrossFrame { f3: 0.0, ..axes }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f2, f3] = load.value;
            Case::hard(load.id, "loads of extreme size", CrossFrame { e2a, e3a, f2, f3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "it does no work along the slot, on orthonormal triads",
            sides: |i| {
                let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                law::no_work(Self::eval(&CrossFrame { e2a, e3a, ..*i }).f, e1a)
            },
        }]
    }
}

fields! {
    /// Where b is along the slot, and from where that is counted.
    pub struct SlotLengths<T> { x: T = X, x0: T = X0, l1_ref: T = L1_REF }
}
fields! {
    /// Displacement along the slot.
    pub struct Displacements<T> { u1: T = U1, u1_mat: T = U1_MAT }
}

/// Displacement along the slot, from the start and from the reference length: u1 = x − x0, u1_mat = x − l1_ref.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion;

impl Formula for RelativeMotion {
    const SPEC: Spec = Spec {
        id: "slot.relative_motion",
        title: "Relative motion",
        latex: r"u_1 = x - x_0,\quad u_1^{\mathrm{mat}} = x - l_1^{\mathrm{ref}}",
        source: Source::SLOT.section("Description"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = SlotLengths<T>;
    type Outputs<T: Element> = Displacements<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotLengths<D>) -> Displacements<D> {
        Displacements { u1: i.x - i.x0, u1_mat: i.x - i.l1_ref }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &SlotLengths<D>) -> Jacobian<Self, D> {
        let (zero, one) = (D::zero(), D::one());
        Displacements {
            u1: SlotLengths { x: one, x0: -one, l1_ref: zero },
            u1_mat: SlotLengths { x: one, x0: zero, l1_ref: -one },
        }
    }

    fn cases() -> Vec<Case<SlotLengths<f64>>> {
        let hand = SlotLengths { x: 5.0, x0: 2.0, l1_ref: 1.5 };
        vec![
            Case::hand("extended", "u1 = 5 - 2, u1_mat = 5 - 1.5", hand),
            Case::limit("start", "no displacement at the start", SlotLengths { x: 2.0, ..hand }),
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
        vec![Law {
            statement: "both displacements grow as x does",
            sides: |i| {
                let (here, there) = (Self::eval(i), Self::eval(&SlotLengths { x: i.x + 1.0, ..*i }));
                law::equal_all_with([(there.u1 - here.u1, 1.0.into()), (there.u1_mat - here.u1_mat, 1.0.into())], i.x)
            },
        }]
    }
}

fields! {
    /// The direction of the slot, and the force along it.
    pub struct SlotForce<T> { e1a: Vector3<T> = E1A, f1: T = F1 }
}

/// The force along the slot: f = f1 e1a.
#[derive(Clone, Copy, Debug)]
pub struct KineticForce;

impl Formula for KineticForce {
    const SPEC: Spec = Spec {
        id: "slot.kinetic_force",
        title: "Kinetic force",
        latex: r"\mathbf{f} = f_1\,\mathbf{e}_{1a}",
        source: Source::SLOT.section("Description"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = SlotForce<T>;
    type Outputs<T: Element> = Force<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotForce<D>) -> Force<D> {
        Force { f: i.e1a * i.f1 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotForce<D>) -> Jacobian<Self, D> {
        let row = |k| SlotForce { e1a: along(k, i.f1), f1: i.e1a[k] };
        Force { f: Vector3::new(row(0), row(1), row(2)) }
    }

    fn cases() -> Vec<Case<SlotForce<f64>>> {
        let [e1a, ..] = hard::triad();
        let mut cases = vec![Case::hand("axes", "f = (-2, 0, 0)", SlotForce { e1a: Vector3::x(), f1: -2.0 })];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f1] = load.value;
            Case::hard(load.id, "a load of extreme size", SlotForce { e1a, f1 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "its power is f1 times the velocity along the slot: f·∂x/∂xb = f1 e1a·e1a",
            sides: |i| law::equal(Self::eval(i).f.dot(&i.e1a), i.f1 * i.e1a.dot(&i.e1a)),
        }]
    }
}

fields! {
    /// Where b is along the slot, and the stops.
    pub struct StopLengths<T> { x: T = X, l1_min: T = L1_MIN, l1_max: T = L1_MAX }
}
fields! {
    /// Distances to the stops.
    pub struct Gaps<T> { gap_min: T = GAP_MIN, gap_max: T = GAP_MAX }
}

/// Distances to the stops, both ≥ 0 between them: x − l1_min, l1_max − x.
#[derive(Clone, Copy, Debug)]
pub struct Stop;

impl Formula for Stop {
    const SPEC: Spec = Spec {
        id: "slot.stop",
        title: "Stops",
        latex: r"\mathit{gap}_{\min} = x - l_1^{\min},\quad \mathit{gap}_{\max} = l_1^{\max} - x",
        source: Source::SLOT.section("Summary"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = StopLengths<T>;
    type Outputs<T: Element> = Gaps<T>;

    #[inline]
    fn eval<D: Scalar>(i: &StopLengths<D>) -> Gaps<D> {
        Gaps { gap_min: i.x - i.l1_min, gap_max: i.l1_max - i.x }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &StopLengths<D>) -> Jacobian<Self, D> {
        let (zero, one) = (D::zero(), D::one());
        Gaps {
            gap_min: StopLengths { x: one, l1_min: -one, l1_max: zero },
            gap_max: StopLengths { x: -one, l1_min: zero, l1_max: one },
        }
    }

    fn validate(i: &StopLengths<f64>) -> Result<(), Error> {
        Error::check_order(("l1_min", i.l1_min), ("l1_max", i.l1_max))
    }

    fn cases() -> Vec<Case<StopLengths<f64>>> {
        let hand = StopLengths { x: 3.0, l1_min: 1.0, l1_max: 7.0 };
        vec![
            Case::hand("between", "2 above the lower stop, 4 below the upper", hand),
            Case::limit("at-lower", "the lower gap is 0", StopLengths { x: 1.0, ..hand }),
            Case::limit("at-upper", "the upper gap is 0", StopLengths { x: 7.0, ..hand }),
            Case::hand("beyond", "the upper gap is negative", StopLengths { x: 8.0, ..hand }),
            Case::limit("closed", "both stops at one place", StopLengths { l1_min: 7.0, ..hand }),
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
        vec![Law {
            statement: "the gaps add up to the distance between the stops",
            sides: |i| law::equal_with(Self::eval(i).gap_min + Self::eval(i).gap_max, i.l1_max - i.l1_min, i.x),
        }]
    }
}
