//! Evidence for the formula of the parent module: cases, laws.

use super::{Constraint, Joined};
use crate::connector::slot::Positions;
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector3;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Joined<f64>>> {
        let [e1a, e2a, e3a] = hard::triad();
        let axes = Positions {
            e1a: Vector3::x(),
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            xa: Vector3::new(1.0, 2.0, 3.0),
            xb: Vector3::new(4.0, 6.0, 15.0),
        };
        let mut cases = vec![
            Case::hand(
                "in-place",
                "b at its initial position (3, 4, 12)",
                Joined::of(axes, Vector3::new(3.0, 4.0, 12.0)),
            ),
            Case::hand(
                "pulled-off",
                "the whole distance is the residual where the nodes coincided",
                Joined::of(axes, Vector3::zeros()),
            ),
            Case::running("(3, 4, 12) - (2.75, 4.25, 11.5)", Joined::of(axes, Vector3::new(2.75, 4.25, 11.5))),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            let here = Positions { e1a, e2a, e3a, xa, xb };
            Case::hard(place.id, place.comment, Joined::of(here, Vector3::new(0.25, -0.5, 0.125)))
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "the force on b is Jacobianᵀ · multipliers: Σ f_i ∂g_i/∂xb = f1 e1a + f2 e2a + f3 e3a, and a takes the opposite",
            |i| {
                let jac = Self::jacobian(i);
                let f = i.d0; // arbitrary numbers
                let on_b = jac.g[0].xb * f[0] + jac.g[1].xb * f[1] + jac.g[2].xb * f[2];
                let on_a = jac.g[0].xa * f[0] + jac.g[1].xa * f[1] + jac.g[2].xa * f[2];
                let documented = i.e1a * f[0] + i.e2a * f[1] + i.e3a * f[2];
                [law::equal_vectors(on_b, documented), law::equal_vectors(on_a, -documented)].concat()
            },
        )]
    }
}
