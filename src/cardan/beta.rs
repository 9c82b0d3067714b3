//! β by the two-argument arc tangent, accurate up to ±90°.

use super::{Triads, turn_gradient};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::measure::Way;
use crate::quantity::{BETA, E1A, E1B, E2B, E3B};
use crate::scalar::{Scalar, atan2, has_length, norm, norm_and_direction};
use crate::verify::{hard, law};
use nalgebra::Vector3;
use num_dual::DualNum;

fields! {
    /// The first axis of a, and how node b is turned.
    pub struct BetaAxes<T> {
        e1a: Vector3<T> = E1A, e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
    }
}
fields! {
    /// The second Cardan angle.
    pub struct Beta<T> { beta: T = BETA }
}

impl<T: Element> From<&Triads<T>> for BetaAxes<T> {
    fn from(i: &Triads<T>) -> Self {
        Self { e1a: i.e1a, e1b: i.e1b, e2b: i.e2b, e3b: i.e3b }
    }
}

/// The documented form, equal on orthonormal triads only, and these are orthonormal to rounding only.
fn arc_sine<D: Scalar>(i: &BetaAxes<D>) -> Beta<D> {
    Beta { beta: i.e1a.dot(&i.e3b).asin() }
}

/// The second Cardan angle from its sine and its cosine: β = atan2(e1a·e3b, √((e1a·e1b)² + (e1a·e2b)²)).
///
/// On orthonormal triads it is the documented arc sine. At ±90° it has a tip like that of a cone, for the cosine is a
/// length: the derivative there is 0 by convention.
#[derive(Clone, Copy, Debug)]
pub struct BetaTwoArgument;

impl Formula for BetaTwoArgument {
    const SPEC: Spec = Spec {
        id: "cardan.beta_two_argument",
        title: "Second Cardan angle, two-argument form",
        latex: r"\beta = \operatorname{atan2}\!\left(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\ \sqrt{(\mathbf{e}_{1a}\cdot\mathbf{e}_{1b})^2 + (\mathbf{e}_{1a}\cdot\mathbf{e}_{2b})^2}\right)",
        source: Source::TRANSLATOR.section("Description"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = BetaAxes<T>;
    type Outputs<T: Element> = Beta<T>;

    #[inline]
    fn eval<D: Scalar>(i: &BetaAxes<D>) -> Beta<D> {
        let cosine = norm([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b)]);
        Beta { beta: atan2(i.e1a.dot(&i.e3b) + 0.0, cosine) }
    }

    /// The cosine is e1a·m with m = n1 e1b + n2 e2b, n the direction of (e1a·e1b, e1a·e2b), and a change of n leaves it to
    /// first order. So β is the angle of e1a between the axes m and e3b, and m may be taken as fixed.
    fn jacobian<D: Scalar>(i: &BetaAxes<D>) -> Jacobian<Self, D> {
        let (cosine, [n1, n2]) = norm_and_direction([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b)]);
        let m = i.e1b * n1 + i.e2b * n2;
        let [by_e1a, by_e3b, by_m] = turn_gradient([&i.e1a, &i.e3b, &m], (i.e1a.dot(&i.e3b), cosine));
        Beta { beta: BetaAxes { e1a: -by_e1a, e1b: by_m * -n1, e2b: by_m * -n2, e3b: -by_e3b } }
    }

    #[inline]
    fn validate(i: &BetaAxes<f64>) -> Result<(), Error> {
        if has_length([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b), i.e1a.dot(&i.e3b)]) {
            return Ok(());
        }
        Err(Error::UndefinedAngle { angle: "beta", vector: "e1a", axes: "e1b, e2b and e3b" })
    }

    fn cases() -> Vec<Case<BetaAxes<f64>>> {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let off_axis = |beta: Octuple| {
            let [[e1a, ..], [e1b, e2b, e3b]] = hard::at_angles([Octuple::from(0.3), beta, Octuple::from(-0.7)]);
            BetaAxes { e1a, e1b, e2b, e3b }
        };
        let quarter = Octuple::PI / 2.0;
        let mut cases = vec![
            Case::limit("aligned", "zero where both triads are the same", BetaAxes { e1a: x, e1b: x, e2b: y, e3b: z }),
            Case::hand(
                "45",
                "sine 5, cosine √(3² + 4²): 45° of vectors that are not of length 1",
                BetaAxes { e1a: x, e1b: x * 3.0, e2b: x * 4.0 + y, e3b: x * 5.0 + z },
            ),
            Case::hard("1e-14-below-90", "β within 1e-14 of 90°, in sight of rounding", off_axis(quarter - 1e-14)),
            Case::hard("1e-12-below-90", "β within 1e-12 of 90°", off_axis(quarter - 1e-12)),
        ];
        let on_kink = hard::gimbal_locked().into_iter();
        cases.extend(on_kink.chain(hard::triads()).map(|pair| {
            let [[e1a, ..], [e1b, e2b, e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, BetaAxes { e1a, e1b, e2b, e3b })
        }));
        cases
    }

    fn ways() -> Vec<Way> {
        vec![Way::of_value::<Self>("arc-sine", "plain arc sine", arc_sine)]
    }

    fn invalid_cases() -> Vec<Case<BetaAxes<f64>>> {
        let [_, [e1b, e2b, e3b]] = hard::axes([1, 2, 3]);
        let zero = BetaAxes { e1a: Vector3::zeros(), e1b, e2b, e3b };
        vec![Case::invalid("no-direction", "e1a is zero: sine and cosine vanish", zero)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{e}_{1a}\cdot\mathbf{e}_{1b} = \mathbf{e}_{1a}\cdot\mathbf{e}_{2b} = 0",
            convention: Convention::Subgradient,
            holds: |i| i.e1a.dot(&i.e1b) == 0.0 && i.e1a.dot(&i.e2b) == 0.0,
            at: || {
                let [[e1a, ..], [e1b, e2b, e3b]] = hard::axes([-3, 2, 1]);
                BetaAxes { e1a, e1b, e2b, e3b }
            },
            across: || BetaAxes { e1b: Vector3::x(), ..BetaAxes::filled(0.0) },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "it is the documented arc sine, on orthonormal triads",
                sides: |i| {
                    let [e1b, e2b, e3b] = law::orthonormal([i.e1b, i.e2b, i.e3b]);
                    let e1a = i.e1a / norm([i.e1a.x, i.e1a.y, i.e1a.z]);
                    let beta = Self::eval(&BetaAxes { e1a, e1b, e2b, e3b }).beta;
                    law::equal(beta, e1a.dot(&e3b).asin())
                },
            },
            Law {
                statement: "the lengths of the vectors do not count: doubling all of b's, or e1a, leaves it",
                sides: |i| {
                    let (here, two) = (Self::eval(i).beta, Octuple::from(2.0));
                    let longer_a = Self::eval(&BetaAxes { e1a: i.e1a * two, ..*i }).beta;
                    let (e1b, e2b, e3b) = (i.e1b * two, i.e2b * two, i.e3b * two);
                    law::equal_all([(longer_a, here), (Self::eval(&BetaAxes { e1b, e2b, e3b, ..*i }).beta, here)])
                },
            },
            Law {
                statement: "reversing e1a reverses it",
                sides: |i| law::equal(Self::eval(&BetaAxes { e1a: -i.e1a, ..*i }).beta, -Self::eval(i).beta),
            },
        ]
    }
}
