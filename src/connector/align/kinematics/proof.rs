//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Constraint, ConstraintMoment, Moments, Orientations};
use crate::Octuple;
use crate::element::cardan::turns;
use crate::element::cardan::{Angles, CardanAngles, Oriented, Triads};
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::norm;
use crate::toolkit::verify::exactly;
use nalgebra::Vector3;
use num_dual::DualNum;
use num_traits::Zero;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Orientations<f64>>> {
        let [a, b] = turns::axes([1, 2, 3]);
        let aligned = Orientations::new(&Triads::new(a, b), &Angles::filled(0.0));
        let mut cases = vec![
            Case::hand("aligned", "both triads agree, at the start and now: no residual", aligned),
            Case::hand(
                "offset",
                "both triads agree, which they did not at the start",
                Orientations { alpha0: 0.5, beta0: -0.25, gamma0: 3.0, ..aligned },
            ),
            Case::running(
                "0.6435 - 0.6, 0.6435 - 0.7, 0.6435 - 0.5",
                Orientations::new(&Triads::new(a, turns::PYTHAGOREAN), &Angles { alpha: 0.6, beta: 0.7, gamma: 0.5 }),
            ),
        ];
        let [a, b] = turns::axes([1, -2, -3]);
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
        turns::kinks()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("at the initial angles the residuals vanish", |i| {
                let initial = CardanAngles::eval(&i.triads());
                let here = Self::eval(&Orientations::new(&i.triads(), &initial));
                let all = [(here.ur1, initial.alpha), (here.ur2, initial.beta), (here.ur3, initial.gamma)];
                all.iter().flat_map(|&(residual, angle)| law::equal_with(residual, Octuple::zero(), angle)).collect()
            }),
            Law::<Self>::new("aligned, the moment on b is Jacobianᵀ · multipliers, and a takes the opposite", |i| {
                let (a, _) = i.triads().orthonormal();
                let multipliers = [i.alpha0, i.beta0, i.gamma0]; // arbitrary numbers
                let [on_a, on_b] = moments(&Orientations::of(Triads::new(a, a)), multipliers);
                let [e1a, e2a, e3a] = a;
                let [m1, m2, m3] = multipliers;
                let m = ConstraintMoment::eval(&Moments { e1a, e2a, e3a, m1, m2, m3 }).m;
                [law::equal_vectors(on_b, m), law::equal_vectors(on_a, -m)].concat()
            }),
            Law::<Self>::new(
                "in any position, Jacobianᵀ · multipliers has the moments m1 about e1a, m2 about the line of nodes and m3 about e3b",
                |i| {
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
            ),
        ]
    }
}

impl Proved for ConstraintMoment {
    fn cases() -> Vec<Case<Moments<f64>>> {
        let [[x, y, z], _] = turns::axes([1, 2, 3]);
        let axes = Moments { e1a: x, e2a: y, e3a: z, m1: 2.0, m2: -3.0, m3: 6.0 };
        let [e1a, e2a, e3a] = hard::triad();
        let mut cases = vec![
            Case::hand("axes", "m = (2, -3, 6)", axes),
            Case::running("m = (-6, 5, -12)", Moments { m1: -6.0, m2: 5.0, m3: -12.0, ..axes }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m1, m2, m3] = load.value;
            Case::hard(load.id, "moments of extreme size", Moments { e1a, e2a, e3a, m1, m2, m3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("its components along a's axes are m1, m2, m3, on orthonormal triads", |i| {
            let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e2a, i.e3a]);
            let m = Self::eval(&Moments { e1a, e2a, e3a, ..*i }).m;
            let size = norm([i.m1, i.m2, i.m3]);
            let components = [(e1a, i.m1), (e2a, i.m2), (e3a, i.m3)];
            components.iter().flat_map(|(e, expected)| law::equal_with(m.dot(e), *expected, size)).collect()
        })]
    }
}

/// The Cardan angles, each rounded to the nearest double, on any machine.
fn angles_to_rounding(i: &Triads<f64>) -> Angles<f64> {
    let Angles { alpha, beta, gamma } = CardanAngles::eval(&exactly::<CardanAngles>(i));
    Angles { alpha: alpha.to_f64(), beta: beta.to_f64(), gamma: gamma.to_f64() }
}

/// The moments on a and on b from Jacobianᵀ · multipliers.
fn moments(i: &Orientations<Octuple>, [m1, m2, m3]: [Octuple; 3]) -> [Vector3<Octuple>; 2] {
    let jac = Constraint::jacobian(i);
    let rows = [(jac.ur1, m1), (jac.ur2, m2), (jac.ur3, m3)];
    rows.iter().fold([Vector3::from_element(Octuple::zero()); 2], |[on_a, on_b], (row, m)| {
        let [unit_a, unit_b] = i.triads().moments(&row.triads());
        [on_a + unit_a * *m, on_b + unit_b * *m]
    })
}
