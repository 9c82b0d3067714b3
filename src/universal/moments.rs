//! The moment that holds the shafts at their angle, and the moments about them.

use crate::cardan::{alpha_gradient, check_alpha};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Formula, Jacobian, Law, Source, Spec, along};
use crate::quantity::{CROSS_M1, CROSS_M3, E1A, E2A, E3A, E3B, MOMENT, TWIST_M2};
use crate::scalar::{Scalar, norm, norm_and_direction};
use crate::verify::{hard, law};
use nalgebra::Vector3;

fields! {
    /// The axes across a's shaft, b's shaft, and the constraint moment.
    pub struct Twisted<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B, m2: T = TWIST_M2 }
}
fields! {
    /// A moment on node b.
    pub struct Moment<T> { m: Vector3<T> = MOMENT }
}

/// The moment that keeps the shafts at their angle: m = m2 (cos α e2a + sin α e3a).
///
/// cos α and sin α are the direction of (e3a·e3b, −e2a·e3b), without an angle in between. Where the shafts are
/// perpendicular this is −m2 e1a × e3b.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintMoment;

/// |(e3a·e3b, e2a·e3b)|, cos α and sin α.
#[inline]
fn turn<D: Scalar>(i: &Twisted<D>) -> (D, [D; 2]) {
    let (length, [cosine, sine]) = norm_and_direction([i.e3a.dot(&i.e3b), i.e2a.dot(&i.e3b)]);
    (length, [cosine, -sine])
}

impl Formula for ConstraintMoment {
    const SPEC: Spec = Spec {
        id: "universal.constraint_moment",
        title: "Constraint moment",
        latex: r"\mathbf{m} = m_2\,(\cos\alpha\,\mathbf{e}_{2a} + \sin\alpha\,\mathbf{e}_{3a})",
        source: Source::UJOINT.section("Friction"),
        eta: 6.0,
        eta_jacobian: 8.0,
        objective: true,
    };
    type Inputs<T: Element> = Twisted<T>;
    type Outputs<T: Element> = Moment<T>;

    fn eval<D: Scalar>(i: &Twisted<D>) -> Moment<D> {
        let (_, [cosine, sine]) = turn(i);
        Moment { m: (i.e2a * cosine + i.e3a * sine) * i.m2 }
    }

    fn jacobian<D: Scalar>(i: &Twisted<D>) -> Jacobian<Self, D> {
        let (length, [cosine, sine]) = turn(i);
        let line_of_nodes = i.e2a * cosine + i.e3a * sine;
        let across = i.e3a * cosine - i.e2a * sine; // across·e3b = length
        let [_, _, by_e3b] = alpha_gradient(&i.e2a, &i.e3a, &i.e3b);
        let shaft = i.e3b / length;
        // ∂α/∂e2a = −cos α e3b/length and ∂α/∂e3a = −sin α e3b/length, so both rows are those of I − across e3bᵀ/length.
        // Its diagonal is a sum over the other two axes, without the 1 that would cancel.
        let row = |k: usize| {
            let mut held = shaft * -across[k];
            held[k] = (0..3).filter(|&j| j != k).fold(D::zero(), |sum, j| sum + across[j] * shaft[j]);
            Twisted {
                e2a: held * (i.m2 * cosine),
                e3a: held * (i.m2 * sine),
                e3b: by_e3b * (i.m2 * across[k]),
                m2: line_of_nodes[k],
            }
        };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }

    fn validate(i: &Twisted<f64>) -> Result<(), Error> {
        check_alpha(&i.e2a, &i.e3a, &i.e3b)
    }

    fn cases() -> Vec<Case<Twisted<f64>>> {
        let axes = Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::z(), m2: 2.0 };
        let mut cases = vec![
            Case::hand("aligned", "α = 0: about e2a", axes),
            Case::hand("quarter-turn", "α = 90°: about e3a", Twisted { e3b: -Vector3::y(), ..axes }),
            Case::hand("half-turn", "α = -180°: about -e2a", Twisted { e3b: -Vector3::z(), ..axes }),
            Case::hand(
                "3-4-5",
                "cos α = 0.8, sin α = 0.6, and the size of e3b does not count",
                Twisted { e3b: Vector3::new(0.0, -3.0, 4.0), ..axes },
            ),
        ];
        cases.extend(hard::triads().into_iter().map(|pair| {
            let [[_, e2a, e3a], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Twisted { e2a, e3a, e3b, m2: -1.5 })
        }));
        let [_, e2a, e3a] = hard::triad();
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2] = load.value;
            Case::hard(
                format!("moment-{}", load.id),
                "a moment of extreme size",
                Twisted { e2a, e3a, e3b: Vector3::new(0.6, 0.0, 0.8), m2 },
            )
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Twisted<f64>>> {
        let locked = Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::x(), m2: 2.0 };
        vec![Case::invalid("gimbal-lock", "b's shaft in line with a's: no line of nodes", locked)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "on perpendicular shafts it is -m2 e1a × e3b",
                sides: |i| {
                    let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                    let across = i.e3b - e1a * e1a.dot(&i.e3b);
                    let e3b = across / law::length(across);
                    law::equal_vectors(Self::eval(&Twisted { e2a, e3a, e3b, ..*i }).m, -e1a.cross(&e3b) * i.m2)
                },
            },
            Law {
                statement: "it does no work on turns about either shaft, on orthonormal triads",
                sides: |i| {
                    let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                    let m = Self::eval(&Twisted { e2a, e3a, ..*i }).m;
                    [law::no_work(m, e1a), law::no_work(m, i.e3b)].concat()
                },
            },
            Law {
                statement: "in any position Jacobianᵀ · m2, with the constraint of UNIVERSAL and the spin of b, is cos β times it",
                sides: |i| {
                    let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                    let e3b = i.e3b / law::length(i.e3b);
                    let jac = super::Constraint::jacobian(&super::Shafts { e1a, e3b, c0: i.m2 });
                    let on_b = e3b.cross(&jac.g.e3b) * i.m2;
                    let cos_beta = norm([e2a.dot(&e3b), e3a.dot(&e3b)]);
                    law::equal_vectors(on_b, Self::eval(&Twisted { e2a, e3a, e3b, ..*i }).m * cos_beta)
                },
            },
        ]
    }
}

fields! {
    /// The two shafts, and the moments about them.
    pub struct Driven<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, m1: T = CROSS_M1, m3: T = CROSS_M3 }
}

/// The moment about the free axes: m = m1 e1a + m3 e3b.
#[derive(Clone, Copy, Debug)]
pub struct KineticMoment;

impl Formula for KineticMoment {
    const SPEC: Spec = Spec {
        id: "universal.kinetic_moment",
        title: "Kinetic moment",
        latex: r"\mathbf{m} = m_1\,\mathbf{e}_{1a} + m_3\,\mathbf{e}_{3b}",
        source: Source::UJOINT.section("Summary"),
        eta: 1.5,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = Driven<T>;
    type Outputs<T: Element> = Moment<T>;

    fn eval<D: Scalar>(i: &Driven<D>) -> Moment<D> {
        Moment { m: i.e1a * i.m1 + i.e3b * i.m3 }
    }

    fn jacobian<D: Scalar>(i: &Driven<D>) -> Jacobian<Self, D> {
        let row = |k: usize| Driven { e1a: along(k, i.m1), e3b: along(k, i.m3), m1: i.e1a[k], m3: i.e3b[k] };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }

    fn cases() -> Vec<Case<Driven<f64>>> {
        let axes = Driven { e1a: Vector3::x(), e3b: Vector3::z(), m1: 2.0, m3: -3.0 };
        let [e1a, _, e3b] = hard::triad();
        let mut cases = vec![Case::hand("axes", "m = (2, 0, -3)", axes)];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m1, m3] = load.value;
            Case::hard(load.id, "moments of extreme size", Driven { e1a, e3b, m1, m3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "it works with m1 on turns about e1a and with m3 on turns about e3b, on perpendicular shafts",
            sides: |i| {
                let [e1a, e3b, _] = law::orthonormal([i.e1a, i.e3b, i.e1a.cross(&i.e3b)]);
                let m = Self::eval(&Driven { e1a, e3b, ..*i }).m;
                law::equal_all_with([(m.dot(&e1a), i.m1), (m.dot(&e3b), i.m3)], law::length(m))
            },
        }]
    }
}
