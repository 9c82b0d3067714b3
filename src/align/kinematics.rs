//! The residuals of the three angles, and the moment that holds them.

use crate::Octuple;
use crate::cardan::{self, Angles, CardanAngles, Oriented, Triads};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec, along};
use crate::quantity::{ALPHA0, BETA0, E1A, E1B, E2A, E2B, E3A, E3B, GAMMA0, M1, M2, M3, MOMENT, UR1, UR2, UR3};
use crate::scalar::{Scalar, norm};
use crate::verify::{exactly, hard, law};
use nalgebra::Vector3;
use num_dual::DualNum;
use num_traits::Zero;

fields! {
    /// How both nodes are turned, and the initial angles.
    pub struct Orientations<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0,
    }
}
fields! {
    /// By how much b is out of alignment.
    pub struct Misalignment<T> { ur1: T = UR1, ur2: T = UR2, ur3: T = UR3 }
}

impl<T: Element> Orientations<T> {
    /// From both triads and the initial angles.
    pub const fn new(triads: &Triads<T>, initial: &Angles<T>) -> Self {
        let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = *triads;
        let Angles { alpha: alpha0, beta: beta0, gamma: gamma0 } = *initial;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 }
    }

    /// The initial angles.
    pub const fn initial(&self) -> Angles<T> {
        Angles { alpha: self.alpha0, beta: self.beta0, gamma: self.gamma0 }
    }
}

impl<D: Scalar> Oriented<D> for Orientations<D> {
    fn triads(&self) -> Triads<D> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = *self;
        Triads { e1a, e2a, e3a, e1b, e2b, e3b }
    }
    fn of(triads: Triads<D>) -> Self {
        Self::new(&triads, &Angles::filled(D::zero()))
    }
}

/// The three conditions that keep b aligned: α − α0 = 0, β − β0 = 0, γ − γ0 = 0.
///
/// The differences are plain ones, as documented: where α or γ passes ±180° the residual jumps by a full turn.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "align.constraint",
        title: "Constraint",
        latex: r"u_{r1} = \alpha - \alpha_0,\quad u_{r2} = \beta - \beta_0,\quad u_{r3} = \gamma - \gamma_0",
        source: Source::TRANSLATOR.section("Description"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Orientations<T>;
    type Outputs<T: Element> = Misalignment<T>;

    fn eval<D: Scalar>(i: &Orientations<D>) -> Misalignment<D> {
        let Angles { alpha, beta, gamma } = CardanAngles::eval(&i.triads());
        Misalignment { ur1: alpha - i.alpha0, ur2: beta - i.beta0, ur3: gamma - i.gamma0 }
    }

    fn jacobian<D: Scalar>(i: &Orientations<D>) -> Jacobian<Self, D> {
        let Angles { alpha, beta, gamma } = CardanAngles::jacobian(&i.triads());
        Misalignment {
            ur1: Orientations { alpha0: -D::one(), ..Orientations::of(alpha) },
            ur2: Orientations { beta0: -D::one(), ..Orientations::of(beta) },
            ur3: Orientations { gamma0: -D::one(), ..Orientations::of(gamma) },
        }
    }

    fn validate(i: &Orientations<f64>) -> Result<(), Error> {
        CardanAngles::validate(&i.triads())
    }

    fn cases() -> Vec<Case<Orientations<f64>>> {
        let [a, b] = hard::axes([1, 2, 3]);
        let aligned = Orientations::new(&Triads::new(a, b), &Angles::filled(0.0));
        let mut cases = vec![
            Case::limit("aligned", "both triads agree, at the start and now: no residual", aligned),
            Case::hand(
                "offset",
                "both triads agree, which they did not at the start",
                Orientations { alpha0: 0.5, beta0: -0.25, gamma0: 3.0, ..aligned },
            ),
        ];
        let [a, b] = hard::axes([1, -2, -3]);
        cases.push(Case::hard(
            "across-180",
            "α = -π from α0 = 3.125 on the other side: the plain difference is nearly a full turn",
            Orientations { alpha0: 3.125, ..Orientations::of(Triads::new(a, b)) },
        ));
        cases.extend(CardanAngles::cases().into_iter().map(|case| {
            let unmoved = Orientations::new(&case.inputs, &angles_to_rounding(&case.inputs));
            Case::new(case.flag, format!("unmoved-{}", case.id), case.comment, unmoved)
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Orientations<f64>>> {
        let of_angles = CardanAngles::invalid_cases().into_iter();
        of_angles.map(|case| Case::invalid(case.id, case.comment, Orientations::of(case.inputs))).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        cardan::kinks()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "at the initial angles the residuals vanish",
                sides: |i| {
                    let initial = CardanAngles::eval(&i.triads());
                    let here = Self::eval(&Orientations::new(&i.triads(), &initial));
                    let all = [(here.ur1, initial.alpha), (here.ur2, initial.beta), (here.ur3, initial.gamma)];
                    all.iter()
                        .flat_map(|&(residual, angle)| law::equal_with(residual, Octuple::zero(), angle))
                        .collect()
                },
            },
            Law {
                statement: "aligned, the moment on b is Jacobianᵀ · multipliers, and a takes the opposite",
                sides: |i| {
                    let (a, _) = i.triads().orthonormal();
                    let multipliers = [i.alpha0, i.beta0, i.gamma0]; // any three numbers will do
                    let [on_a, on_b] = moments(&Orientations::of(Triads::new(a, a)), multipliers);
                    let [e1a, e2a, e3a] = a;
                    let [m1, m2, m3] = multipliers;
                    let m = ConstraintMoment::eval(&Moments { e1a, e2a, e3a, m1, m2, m3 }).m;
                    [law::equal_vectors(on_b, m), law::equal_vectors(on_a, -m)].concat()
                },
            },
            Law {
                statement: "in any position, Jacobianᵀ · multipliers has the moments m1 about e1a, m2 about the line of nodes and m3 about e3b",
                sides: |i| {
                    let (a, b) = i.triads().orthonormal();
                    let triads = Triads::new(a, b);
                    let multipliers = [i.alpha0, i.beta0, i.gamma0];
                    let [on_a, on_b] = moments(&Orientations::of(triads), multipliers);
                    let alpha = CardanAngles::eval(&triads).alpha;
                    let axes = [a[0], a[1] * alpha.cos() + a[2] * alpha.sin(), b[2]];
                    let size = norm([on_b.x, on_b.y, on_b.z]);
                    let about = axes.iter().zip(multipliers);
                    let mut sides = law::equal_vectors(on_a, -on_b);
                    sides.extend(about.flat_map(|(axis, m)| law::equal_with(on_b.dot(axis), m, size)));
                    sides
                },
            },
        ]
    }
}

/// The Cardan angles, each the nearest double on any machine.
fn angles_to_rounding(i: &Triads<f64>) -> Angles<f64> {
    let Angles { alpha, beta, gamma } = CardanAngles::eval(&exactly::<CardanAngles>(i));
    Angles { alpha: alpha.to_f64(), beta: beta.to_f64(), gamma: gamma.to_f64() }
}

/// The moments on a and on b that Jacobianᵀ · multipliers gives.
fn moments(i: &Orientations<Octuple>, [m1, m2, m3]: [Octuple; 3]) -> [Vector3<Octuple>; 2] {
    let jac = Constraint::jacobian(i);
    let rows = [(jac.ur1, m1), (jac.ur2, m2), (jac.ur3, m3)];
    rows.iter().fold([Vector3::from_element(Octuple::zero()); 2], |[on_a, on_b], (row, m)| {
        let [unit_a, unit_b] = i.triads().moments(&row.triads());
        [on_a + unit_a * *m, on_b + unit_b * *m]
    })
}

fields! {
    /// The triad of a, and the moments about its axes.
    pub struct Moments<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, m1: T = M1, m2: T = M2, m3: T = M3,
    }
}
fields! {
    /// A moment on node b.
    pub struct Moment<T> { m: Vector3<T> = MOMENT }
}

/// The moment that keeps b aligned: m = m1 e1a + m2 e2a + m3 e3a.
///
/// Where the triads agree, it is the one that does work on (α, β, γ) as m1, m2, m3 do; elsewhere it is not, see the laws
/// of [`Constraint`].
#[derive(Clone, Copy, Debug)]
pub struct ConstraintMoment;

impl Formula for ConstraintMoment {
    const SPEC: Spec = Spec {
        id: "align.constraint_moment",
        title: "Constraint moment",
        latex: r"\mathbf{m} = m_1\,\mathbf{e}_{1a} + m_2\,\mathbf{e}_{2a} + m_3\,\mathbf{e}_{3a}",
        source: Source::TRANSLATOR.section("Summary"),
        eta: 1.5,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = Moments<T>;
    type Outputs<T: Element> = Moment<T>;

    fn eval<D: Scalar>(i: &Moments<D>) -> Moment<D> {
        Moment { m: i.e1a * i.m1 + i.e2a * i.m2 + i.e3a * i.m3 }
    }

    fn jacobian<D: Scalar>(i: &Moments<D>) -> Jacobian<Self, D> {
        let row = |k| Moments {
            e1a: along(k, i.m1),
            e2a: along(k, i.m2),
            e3a: along(k, i.m3),
            m1: i.e1a[k],
            m2: i.e2a[k],
            m3: i.e3a[k],
        };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }

    fn cases() -> Vec<Case<Moments<f64>>> {
        let [[x, y, z], _] = hard::axes([1, 2, 3]);
        let axes = Moments { e1a: x, e2a: y, e3a: z, m1: 2.0, m2: -3.0, m3: 6.0 };
        let [e1a, e2a, e3a] = hard::triad();
        let mut cases = vec![Case::hand("axes", "m = (2, -3, 6)", axes)];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m1, m2, m3] = load.value;
            Case::hard(load.id, "moments of extreme size", Moments { e1a, e2a, e3a, m1, m2, m3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "its components along a's axes are m1, m2, m3, on orthonormal triads",
            sides: |i| {
                let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e2a, i.e3a]);
                let m = Self::eval(&Moments { e1a, e2a, e3a, ..*i }).m;
                let size = norm([i.m1, i.m2, i.m3]);
                let components = [(e1a, i.m1), (e2a, i.m2), (e3a, i.m3)];
                components.iter().flat_map(|(e, expected)| law::equal_with(m.dot(e), *expected, size)).collect()
            },
        }]
    }
}
