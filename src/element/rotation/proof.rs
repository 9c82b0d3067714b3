//! Evidence for the formulas of the parent module: cases, laws.

use super::{EulerParameters, QuaternionLoad, RotationVector, TurnedLoad};
use crate::Octuple;
use crate::element::products::skew;
use crate::formula::proof::{Case, Equation, Law, Proved, hard, law};
use crate::formula::{Formula, along};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};
use num_dual::{Dual, DualNum};
use num_traits::{One, Zero};

/// The spin due to a change of unknowns: \[δθ×\] = δR Rᵀ.
fn spin(turned: impl Fn() -> Matrix3<Dual<Octuple>>) -> Vector3<Octuple> {
    let moved = turned();
    let rate = moved.map(|x| x.eps) * moved.map(|x| x.re).transpose();
    Vector3::new(rate[(2, 1)] - rate[(1, 2)], rate[(0, 2)] - rate[(2, 0)], rate[(1, 0)] - rate[(0, 1)])
        * Octuple::from(0.5)
}

/// A vector whose k-th component has the derivative 1.
fn growing<const N: usize>(x: nalgebra::SVector<Octuple, N>, k: usize) -> nalgebra::SVector<Dual<Octuple>, N> {
    x.zip_map(&along(k, Octuple::one()), Dual::new)
}

/// The rotation of a rotation vector, by Rodrigues' formula in half the angle.
pub(crate) fn rodrigues<D: Scalar>(psi: &Vector3<D>) -> Matrix3<D> {
    let half = psi.dot(psi).sqrt() * 0.5;
    let (sin, cos) = half.sin_cos();
    from_euler(cos, &(psi * (sin / half * 0.5)))
}

/// The rotation of Euler parameters.
pub(crate) fn from_euler<D: Scalar>(q0: D, q: &Vector3<D>) -> Matrix3<D> {
    let (cross, two) = (skew(q), D::from(2.0));
    Matrix3::identity() + cross * (q0 * two) + cross * cross * two
}

/// The generalised moments equal the work of the moment on the spin of each unknown.
fn works<const N: usize>(found: [Octuple; N], spins: [Vector3<Octuple>; N], m: Vector3<Octuple>) -> Vec<Equation> {
    let size = spins.iter().map(|&spin| law::length(spin)).fold(Octuple::one(), |a, b| if b > a { b } else { a });
    law::equal_all_with(found.into_iter().zip(spins.map(|spin| m.dot(&spin))), size * law::length(m))
}

impl Proved for RotationVector {
    fn cases() -> Vec<Case<TurnedLoad<f64>>> {
        let (zero, [e1, e2, e3]) = (Vector3::zeros(), hard::triad());
        let m = Vector3::new(2.0, -3.0, 6.0);
        let mut cases = vec![
            Case::hand("not-turned", "T is the unit matrix", TurnedLoad { psi: zero, m }),
            Case::hand("about-its-own-axis", "a moment along ψ is as it is", TurnedLoad { psi: m * 0.25, m }),
            Case::hand("no-moment", "nothing", TurnedLoad { psi: Vector3::x(), m: zero }),
            Case::running("sin ψ = 0.96, cos ψ = -0.28", TurnedLoad { psi: Vector3::z() * 1.8546, m }),
        ];
        let sizes = [1e-30, 1e-12, 1e-4, 0.5, 1.0, 1.999_999_999, 2.000_000_001, 3.0, 6.0, 7.0, 1e3, 1e12];
        cases.extend(sizes.into_iter().flat_map(|size| {
            let case = |id: &str, m| {
                let comment = "an angle, and a moment along the vector or across";
                Case::hard(format!("{id}-{size:e}"), comment, TurnedLoad { psi: e1 * size, m })
            };
            [case("along", e1), case("across", e2), case("oblique", e1 + e2 * 2.0 - e3)]
        }));
        let turns = [("half-a-turn", 1.0), ("a-whole-turn", 2.0), ("two-turns", 4.0)];
        cases.extend(turns.map(|(id, halves)| {
            let psi = e1 * (halves * std::f64::consts::PI);
            Case::hard(id, "as nearly as doubles can", TurnedLoad { psi, m })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("the work in any change of ψ is that of the moment in the spin δR Rᵀ", |i| {
                if i.psi.dot(&i.psi) < 1e-6 {
                    return Vec::new(); // Rodrigues' formula has 0/0 there
                }
                let spins = [0, 1, 2].map(|k| spin(|| rodrigues(&growing(i.psi, k))));
                works(Self::eval(i).m_psi.into(), spins, i.m)
            }),
            Law::<Self>::new("where ψ grows in proportion, the spin is along it: ψ·m_ψ = ψ·m", |i| {
                let size = law::length(i.psi) * law::length(i.m);
                law::equal_with(i.psi.dot(&Self::eval(i).m_psi), i.psi.dot(&i.m), size)
            }),
            Law::<Self>::new(
                "from the other end of the turn it is the moment, turned back: T(−ψ)ᵀ m = T(ψ)ᵀ R m",
                |i| {
                    if i.psi.dot(&i.psi) < 1e-6 {
                        return Vec::new();
                    }
                    let turned = TurnedLoad { m: rodrigues(&i.psi) * i.m, ..*i };
                    let back = TurnedLoad { psi: -i.psi, ..*i };
                    let (left, right) = (Self::eval(&back).m_psi, Self::eval(&turned).m_psi);
                    law::equal_all_with(left.iter().copied().zip(right.iter().copied()), law::length(i.m))
                },
            ),
        ]
    }
}

impl Proved for EulerParameters {
    fn cases() -> Vec<Case<QuaternionLoad<f64>>> {
        let (zero, m) = (Vector3::zeros(), Vector3::new(2.0, -3.0, 6.0));
        let mut cases = vec![
            Case::hand("not-turned", "2 m", QuaternionLoad { q0: 1.0, q: zero, m }),
            Case::hand("half-a-turn", "about x: -2 m1, and -2 i × m", QuaternionLoad { q0: 0.0, q: Vector3::x(), m }),
            Case::running("of whole fifths", QuaternionLoad { q0: 0.6, q: Vector3::z() * 0.8, m }),
        ];
        cases.extend([1e-30, 1e-8, 1e8, 1e30].map(|size| {
            let [_, axis, _] = hard::triad();
            let q = QuaternionLoad { q0: 1.0, q: axis * 1e-8, m: m * size };
            Case::hard(format!("size-{size:e}"), "a small turn, moments of extreme size", q)
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "the work in any change of the parameters that keeps their length is that of the moment",
                |i| {
                    let (q0, q, m) = unit(i);
                    let load = Self::eval(&QuaternionLoad { q0, q, m });
                    let found = nalgebra::Vector4::new(load.m_q0, load.m_q.x, load.m_q.y, load.m_q.z);
                    let here = nalgebra::Vector4::new(q0, q.x, q.y, q.z);
                    // The six planes of four dimensions: one parameter grows at the expense of another.
                    let planes = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)].map(|(j, k)| {
                        let mut change = here * Octuple::zero();
                        (change[j], change[k]) = (-here[k], here[j]);
                        change
                    });
                    let spins = planes.map(|change| {
                        spin(|| {
                            let moved = here.zip_map(&change, Dual::new);
                            from_euler(moved[0], &moved.fixed_rows::<3>(1).into_owned())
                        })
                    });
                    works(planes.map(|change| found.dot(&change)), spins, m)
                },
            ),
            Law::<Self>::new("it does no work where all grow in proportion", |i| {
                let load = Self::eval(i);
                law::vanish([i.q0 * load.m_q0 + i.q.dot(&load.m_q)], law::length(i.m) * (i.q0 * i.q0 + i.q.dot(&i.q)))
            }),
        ]
    }
}

/// The parameters normalised to a unit quaternion.
fn unit(i: &QuaternionLoad<Octuple>) -> (Octuple, Vector3<Octuple>, Vector3<Octuple>) {
    let length = (i.q0 * i.q0 + i.q.dot(&i.q)).sqrt();
    if length.is_zero() { (Octuple::one(), i.q, i.m) } else { (i.q0 / length, i.q / length, i.m) }
}
