//! Evidence for the formula of the parent module: cases, kinks, laws, other methods.

use super::{Beta, BetaAxes, BetaTwoArgument};
use crate::Octuple;
use crate::element::cardan::turns;
use crate::formula::proof::{Case, Kink, Law, Method, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{Scalar, norm};
use nalgebra::Vector3;
use num_dual::DualNum;

impl Proved for BetaTwoArgument {
    fn cases() -> Vec<Case<BetaAxes<f64>>> {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let off_axis = |beta: Octuple| {
            let [[e1a, ..], [e1b, e2b, e3b]] = turns::at_angles([Octuple::from(0.3), beta, Octuple::from(-0.7)]);
            BetaAxes { e1a, e1b, e2b, e3b }
        };
        let quarter = Octuple::PI / 2.0;
        let mut cases = vec![
            Case::hand("aligned", "zero where both triads are the same", BetaAxes { e1a: x, e1b: x, e2b: y, e3b: z }),
            Case::hand(
                "45",
                "sine 5, cosine √(3² + 4²): 45° of vectors that are not of length 1",
                BetaAxes { e1a: x, e1b: x * 3.0, e2b: x * 4.0 + y, e3b: x * 5.0 + z },
            ),
            Case::hard("1e-14-below-90", "β within 1e-14 of 90°, in sight of rounding", off_axis(quarter - 1e-14)),
            Case::hard("1e-12-below-90", "β within 1e-12 of 90°", off_axis(quarter - 1e-12)),
            {
                let [e1b, e2b, e3b] = turns::PYTHAGOREAN;
                Case::running("sine 0.6, cosine √(0.64² + 0.48²)", BetaAxes { e1a: x, e1b, e2b, e3b })
            },
        ];
        let on_kink = turns::gimbal_locked().into_iter();
        cases.extend(on_kink.chain(turns::triads()).map(|pair| {
            let [[e1a, ..], [e1b, e2b, e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, BetaAxes { e1a, e1b, e2b, e3b })
        }));
        cases
    }

    fn methods() -> Vec<Method> {
        vec![Method::of_value::<Self>("arc-sine", "plain arc sine", arc_sine)]
    }

    fn invalid_cases() -> Vec<Case<BetaAxes<f64>>> {
        let [_, [e1b, e2b, e3b]] = turns::axes([1, 2, 3]);
        let zero = BetaAxes { e1a: Vector3::zeros(), e1b, e2b, e3b };
        vec![Case::invalid("no-direction", "e1a is zero: sine and cosine vanish", zero)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::subgradient(
            r"\mathbf{e}_{1a}\cdot\mathbf{e}_{1b} = \mathbf{e}_{1a}\cdot\mathbf{e}_{2b} = 0",
            |i| i.e1a.dot(&i.e1b) == 0.0 && i.e1a.dot(&i.e2b) == 0.0,
            {
                let [[e1a, ..], [e1b, e2b, e3b]] = turns::axes([-3, 2, 1]);
                BetaAxes { e1a, e1b, e2b, e3b }
            },
            BetaAxes { e1b: Vector3::x(), ..BetaAxes::filled(0.0) },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the documented arc sine, on orthonormal triads", |i| {
                let [e1b, e2b, e3b] = law::orthonormal([i.e1b, i.e2b, i.e3b]);
                let e1a = i.e1a / norm([i.e1a.x, i.e1a.y, i.e1a.z]);
                let beta = Self::eval(&BetaAxes { e1a, e1b, e2b, e3b }).beta;
                law::equal(beta, e1a.dot(&e3b).asin())
            }),
            Law::<Self>::new(
                "the lengths of the vectors do not matter: doubling all of b's, or e1a, does not change it",
                |i| {
                    let (here, two) = (Self::eval(i).beta, Octuple::from(2.0));
                    let longer_a = Self::eval(&BetaAxes { e1a: i.e1a * two, ..*i }).beta;
                    let (e1b, e2b, e3b) = (i.e1b * two, i.e2b * two, i.e3b * two);
                    law::equal_all([(longer_a, here), (Self::eval(&BetaAxes { e1b, e2b, e3b, ..*i }).beta, here)])
                },
            ),
            Law::<Self>::new("reversing e1a reverses it", |i| {
                law::equal(Self::eval(&BetaAxes { e1a: -i.e1a, ..*i }).beta, -Self::eval(i).beta)
            }),
        ]
    }
}

/// The documented form, which is equal on orthonormal triads only; these are orthonormal only to within rounding errors.
fn arc_sine<D: Scalar>(i: &BetaAxes<D>) -> Beta<D> {
    Beta { beta: i.e1a.dot(&i.e3b).asin() }
}
