//! Virtual motions of two nodes, used to state laws: derivatives along them, by automatic differentiation in 237 bits.

use super::{Forces, Stiffness};
use crate::Octuple;
use crate::formula::proof::{Equation, law};
use nalgebra::Vector3;
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector3<Octuple>;
/// A number with its derivative along a motion of the nodes.
pub(crate) type Moving = Dual<Octuple>;

/// Translations and spins of both nodes, or a vector belonging to each of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    pub(crate) ua: Vector,
    pub(crate) ta: Vector,
    pub(crate) ub: Vector,
    pub(crate) tb: Vector,
}

impl Motion {
    pub(crate) fn none() -> Self {
        let none = Vector::from_element(Octuple::zero());
        Self { ua: none, ta: none, ub: none, tb: none }
    }

    /// All unit motions: the k-th component of each translation and spin alone.
    pub(crate) fn alone() -> [[Self; 3]; 4] {
        let none = Self::none();
        let unit = |k: usize| Vector::from_fn(|j, _| if j == k { Octuple::one() } else { Octuple::zero() });
        [
            [0, 1, 2].map(|k| Self { ua: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { ta: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { ub: unit(k), ..none }),
            [0, 1, 2].map(|k| Self { tb: unit(k), ..none }),
        ]
    }

    /// The positions of a and of b under this motion.
    pub(crate) fn places(&self, [xa, xb]: [Vector; 2]) -> [Vector3<Moving>; 2] {
        [xa.zip_map(&self.ua, Dual::new), xb.zip_map(&self.ub, Dual::new)]
    }

    /// A vector of the triad of a under this motion: δe = δθ × e.
    pub(crate) fn of_a(&self, e: Vector) -> Vector3<Moving> {
        e.zip_map(&self.ta.cross(&e), Dual::new)
    }

    /// A vector of the triad of b under this motion.
    pub(crate) fn of_b(&self, e: Vector) -> Vector3<Moving> {
        e.zip_map(&self.tb.cross(&e), Dual::new)
    }
}

/// The derivative of a number with respect to translations and spins.
pub(crate) fn derivative(number: impl Fn(&Motion) -> Moving) -> Motion {
    let by = |motions: &[Motion; 3]| Vector::from_fn(|k, _| number(&motions[k]).eps);
    let [ua, ta, ub, tb] = Motion::alone();
    Motion { ua: by(&ua), ta: by(&ta), ub: by(&ub), tb: by(&tb) }
}

/// A constant: its derivative is 0.
pub(crate) fn still(x: Octuple) -> Moving {
    Dual::from_re(x)
}

/// The derivatives of forces with respect to the twelve degrees of freedom.
pub(crate) fn stiffness(forces: impl Fn(&Motion) -> Forces<Moving>) -> Stiffness<Octuple> {
    let columns = Motion::alone().map(|motions| motions.map(|motion| forces(&motion).map(|force| force.eps)));
    Stiffness::from_fn(|row, column| columns[column / 3][column % 3][row])
}

/// A geometric stiffness and the forces of which it is the derivative, for checking the laws of the stiffness.
pub(crate) struct Tangent {
    pub(crate) matrix: Stiffness<Octuple>,
    pub(crate) forces: Forces<Octuple>,
    /// The sizes of the terms of forces and of moments.
    pub(crate) sizes: [Octuple; 2],
}

impl Tangent {
    /// The size of the terms of an entry: that of moments if row and column belong to spins, otherwise that of forces.
    fn size(&self, row: usize, column: usize) -> Octuple {
        self.sizes[usize::from((row / 3) % 2 == 1 && (column / 3) % 2 == 1)]
    }

    fn equal(&self, left: &Stiffness<Octuple>, right: &Stiffness<Octuple>) -> Vec<Equation> {
        let entries = (0..12).flat_map(|row| (0..12).map(move |column| (row, column)));
        entries.flat_map(|at| law::equal_with(left[at], right[at], self.size(at.0, at.1))).collect()
    }

    /// The matrix is the derivative of the forces.
    pub(crate) fn derives(&self, forces: impl Fn(&Motion) -> Forces<Moving>) -> Vec<Equation> {
        self.equal(&self.matrix, &stiffness(forces))
    }

    /// K − Kᵀ is −\[m×\] in the block of a node's own spin, with the moment m on that node, and 0 elsewhere.
    pub(crate) fn is_symmetric_but_for_own_spins(&self) -> Vec<Equation> {
        // Outside of these blocks the rest of the matrix is symmetric; where the moments at a node add up to zero, the assembled matrix is symmetric.
        let mut expected = Stiffness::zeros();
        for spin in [3, 9] {
            let moment = self.forces.fixed_rows::<3>(spin).into_owned();
            expected.fixed_view_mut::<3, 3>(spin, spin).copy_from(&-super::products::skew(&moment));
        }
        self.equal(&(self.matrix - self.matrix.transpose()), &expected)
    }

    /// If both nodes rotate as one body about a point, forces and moments rotate with them.
    pub(crate) fn turns_with_the_body(&self, [xa, xb]: [Vector; 2], spin: Vector) -> Vec<Equation> {
        let (ua, ub) = (Vector::from_element(Octuple::zero()), spin.cross(&(xb - xa)));
        let parts = [ua, spin, ub, spin];
        let turned = self.matrix * Forces::from_fn(|k, _| parts[k / 3][k % 3]);
        let [force, moment] = self.sizes.map(|size| size * law::length(spin));
        let pairs = (0..4).flat_map(|part| {
            let acts = self.forces.fixed_rows::<3>(3 * part).into_owned();
            let expected = spin.cross(&acts);
            let found = turned.fixed_rows::<3>(3 * part).into_owned();
            let size = if part % 2 == 0 { force } else { moment };
            law::equal_all_with(found.iter().copied().zip(expected.iter().copied()), size)
        });
        pairs.collect()
    }
}
