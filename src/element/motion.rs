//! Virtual motions of two nodes, by which laws are stated: what they change, by automatic differentiation in 237 bits.

use crate::Octuple;
use nalgebra::Vector3;
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector3<Octuple>;
/// A number that changes as the nodes move.
pub(super) type Moving = Dual<Octuple>;

/// Translations and spins of both nodes, or what belongs to each of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub(super) ua: Vector,
    pub(super) ta: Vector,
    pub(super) ub: Vector,
    pub(super) tb: Vector,
}

impl Motion {
    pub(super) fn none() -> Self {
        let none = Vector::from_element(Octuple::zero());
        Self { ua: none, ta: none, ub: none, tb: none }
    }

    /// All that moves alone: the k-th component of each.
    fn alone() -> [[Self; 3]; 4] {
        let none = Self::none();
        let unit = |k: usize| Vector::from_fn(|j, _| if j == k { Octuple::one() } else { Octuple::zero() });
        [
            [0, 1, 2].map(|k| Self { ua: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { ta: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { ub: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { tb: unit(k), ..none }),
        ]
    }

    /// A position of a, of b.
    pub(super) fn places(&self, [xa, xb]: [Vector; 2]) -> [Vector3<Moving>; 2] {
        [xa.zip_map(&self.ua, Dual::new), xb.zip_map(&self.ub, Dual::new)]
    }

    /// A vector of the triad of a: δe = δθ × e.
    pub(super) fn of_a(&self, e: Vector) -> Vector3<Moving> {
        e.zip_map(&self.ta.cross(&e), Dual::new)
    }

    /// A vector of the triad of b.
    pub(super) fn of_b(&self, e: Vector) -> Vector3<Moving> {
        e.zip_map(&self.tb.cross(&e), Dual::new)
    }
}

/// The derivative of a number by translations and spins.
pub(super) fn derivative(number: impl Fn(&Motion) -> Moving) -> Motion {
    let by = |motions: &[Motion; 3]| Vector::from_fn(|k, _| number(&motions[k]).eps);
    let [ua, ta, ub, tb] = Motion::alone();
    Motion { ua: by(&ua), ta: by(&ta), ub: by(&ub), tb: by(&tb) }
}

/// A number that stands still.
pub(super) fn still(x: Octuple) -> Moving {
    Dual::from_re(x)
}
