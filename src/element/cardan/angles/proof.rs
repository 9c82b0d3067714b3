//! Evidence for the formula of the parent module: cases, kinks, laws, other methods.

use super::{Angles, CardanAngles};
use crate::Octuple;
use crate::element::cardan::{Triads, rotation, turns};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Method, Proved, hard, law};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;
use num_dual::DualNum;

impl Proved for CardanAngles {
    fn cases() -> Vec<Case<Triads<f64>>> {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let hand = Triads::new([x, y, z], [x + y, y - x, Vector3::new(0.5, -0.5, 0.5)]);
        let mut cases = vec![
            Case::hand("aligned", "all zero where both triads are the same", Triads::new([x, y, z], [x, y, z])),
            Case::hand("45-30-45", "exact components, though not of length 1: atan 1, asin 0.5, atan 1", hand),
            Case::hard(
                "right-angle",
                "e1a·e3b = 1: β = 90°, where the derivative of the arc sine is infinite",
                Triads { e3b: Vector3::new(1.0, -0.5, 0.5), ..hand },
            ),
            Case::hard(
                "right-angle-back",
                "e1a·e3b = -1: β = -90°",
                Triads { e3b: Vector3::new(-1.0, -0.5, 0.5), ..hand },
            ),
            Case::hard(
                "below-right-angle",
                "e1a·e3b = 1 - 2⁻⁵³, the last double before 1",
                Triads { e3b: Vector3::new(1.0_f64.next_down(), -0.5, 0.5), ..hand },
            ),
            Case::hard(
                "nearly-right-angle",
                "e1a·e3b = 1 - 2⁻⁶⁰, which rounds to 1",
                Triads { e1a: Vector3::new(1.0, 1.0, 0.0), e3b: Vector3::new(1.0, -(2.0_f64.powi(-60)), 0.5), ..hand },
            ),
            Case::running("all three have the sine 0.6 and the cosine 0.8", Triads::new([x, y, z], turns::PYTHAGOREAN)),
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [a, b] = pair.value;
            Case::hard(pair.id, pair.comment, Triads::new(a, b))
        }));
        cases
    }

    fn methods() -> Vec<Method> {
        vec![Method::new::<Self>("unguarded", "plain arc sine and arc tangent", unguarded, unguarded)]
    }

    fn invalid_cases() -> Vec<Case<Triads<f64>>> {
        let hand = Triads::new([Vector3::x(), Vector3::y(), Vector3::z()], hard::triad());
        let steep = |x, y| Triads { e1a: Vector3::new(1.0, 1.0, 0.0), e3b: Vector3::new(x, y, 0.5), ..hand };
        let locked = turns::gimbal_locked().into_iter();
        let mut cases: Vec<_> = locked
            .map(|pair| Case::invalid(pair.id, pair.comment, Triads::new(pair.value[0], pair.value[1])))
            .collect();
        cases.extend([
            Case::invalid("above-1", "e1a·e3b = 1 + 2⁻⁵² has no arc sine", steep(1.0_f64.next_up(), 0.0)),
            Case::invalid("below-minus-1", "e1a·e3b = -1 - 2⁻⁵²", steep(-1.0_f64.next_up(), 0.0)),
            Case::invalid("barely-above-1", "e1a·e3b = 1 + 2⁻⁶⁰, which rounds to 1", steep(1.0, 2.0_f64.powi(-60))),
        ]);
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        turns::kinks()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("R1(α) R2(β) R3(γ) rebuilds every e_ia·e_jb, on orthonormal triads", |i| {
                let (a, b) = i.orthonormal();
                let Angles { alpha, beta, gamma } = Self::eval(&Triads::new(a, b));
                let rebuilt = rotation(alpha, beta, gamma);
                let pairs = (0..9).map(|k| (k / 3, k % 3));
                pairs.flat_map(|(i, j)| law::equal_with(rebuilt[(i, j)], a[i].dot(&b[j]), 1.0.into())).collect()
            }),
            Law::<Self>::new("reversing two axes of both nodes reverses the angles about those two", |i| {
                let Angles { alpha, beta, gamma } = Self::eval(i);
                let about_1 = Self::eval(&Triads { e2a: -i.e2a, e3a: -i.e3a, e2b: -i.e2b, e3b: -i.e3b, ..*i });
                let about_2 = Self::eval(&Triads { e1a: -i.e1a, e3a: -i.e3a, e1b: -i.e1b, e3b: -i.e3b, ..*i });
                let about_3 = Self::eval(&Triads { e1a: -i.e1a, e2a: -i.e2a, e1b: -i.e1b, e2b: -i.e2b, ..*i });
                law::equal_all([
                    (about_1.alpha, alpha),
                    (about_1.beta, -beta),
                    (about_1.gamma, -gamma),
                    (about_2.alpha, -alpha),
                    (about_2.beta, beta),
                    (about_2.gamma, -gamma),
                    (about_3.alpha, -alpha),
                    (about_3.beta, -beta),
                    (about_3.gamma, gamma),
                ])
            }),
            Law::<Self>::new("exchanging the nodes and the names of axes 1 and 3 exchanges −α and γ", |i| {
                let exchanged = Triads::new([i.e3b, -i.e2b, i.e1b], [i.e3a, -i.e2a, i.e1a]);
                let (here, there) = (Self::eval(i), Self::eval(&exchanged));
                law::equal_all([(there.alpha, -here.gamma), (there.beta, here.beta), (there.gamma, -here.alpha)])
            }),
            Law::<Self>::new(
                "spinning b about e1a, the line of nodes or e3b changes α, β or γ alone, at rate 1",
                |i| {
                    let (a, b) = i.orthonormal();
                    let triads = Triads::new(a, b);
                    let alpha = Self::eval(&triads).alpha;
                    let line_of_nodes = a[1] * alpha.cos() + a[2] * alpha.sin();
                    let jac = Self::jacobian(&triads);
                    let rates = |gradient: &Triads<Octuple>| {
                        let [_, moment] = triads.moments(gradient);
                        [a[0], line_of_nodes, b[2]].map(|spin| moment.dot(&spin))
                    };
                    let found = [jac.alpha, jac.beta, jac.gamma].iter().flat_map(rates).collect::<Vec<_>>();
                    let expected = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0].map(Octuple::from);
                    let pairs = found.into_iter().zip(expected);
                    pairs.flat_map(|(found, expected)| law::equal_with(found, expected, 1.0.into())).collect()
                },
            ),
        ]
    }
}

/// The equations as documented: without regard to the digits that a scalar product loses near ±1, and with the quotient rule for
/// the derivative of the arc tangent, which fails at right angles.
fn unguarded<D: Scalar>(i: &Triads<D>) -> Angles<D> {
    Angles {
        alpha: -i.e2a.dot(&i.e3b).atan2(i.e3a.dot(&i.e3b)),
        beta: i.e1a.dot(&i.e3b).asin(),
        gamma: -i.e1a.dot(&i.e2b).atan2(i.e1a.dot(&i.e1b)),
    }
}
