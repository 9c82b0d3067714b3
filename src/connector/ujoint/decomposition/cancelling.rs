//! The three products if their terms cancel, computed in the arithmetic of the number type without losing the sign.
//!
//! Products of pairs double the digits. If the sign is still uncertain, which includes terms that cancel exactly, exact
//! expansions decide.

use super::{CrossForces, CrossLoads};
use crate::number::binade::Binade;
use crate::number::eft::Pair;
use crate::number::scalar::{Leaf, Scalar, abs, choice, leaf, with_leaf};
use nalgebra::Vector3;

/// The rounding error of a sum in pairs is below this fraction of the sum of the sizes of all products: at most 90 u² = 22.5 ε².
const fn rounding_of_pairs<L: Leaf>() -> f64 {
    32.0 * L::EPSILON * L::EPSILON
}

impl<D: Scalar> CrossLoads<D> {
    /// Replaces doubtful results. `self` is passed by value, since a reference would keep the loads in memory on the paths that
    /// do not call this.
    #[cold]
    pub(super) fn settled(self, rough: CrossForces<D>) -> CrossForces<D> {
        let doubtful = rough.below(&self.rounding());
        // The forces are scaled to about 1, so that no product over- or underflows.
        let Binade { unit, per_unit } = Binade::of([self.f1, self.f2, self.f3].map(leaf));
        let loads = self.leaves(per_unit);
        let settle = |doubtful: bool, rough: D, settled: fn(&CrossLoads<D::Leaf>) -> D::Leaf| {
            if !doubtful {
                return rough;
            }
            let settled = settled(&loads) * unit;
            // A zero keeps its sign. If vectors are so far from unit length that a product overflows, the rounding errors cannot
            // be recovered.
            let is_new = settled != leaf(rough) && abs(settled) < f64::INFINITY;
            if is_new { with_leaf(rough, settled) } else { rough }
        };
        let settle = |doubtful, rough, settled: fn(&CrossLoads<D::Leaf>) -> D::Leaf| {
            let [force] = choice(|| [settle(doubtful, rough, settled)]);
            force
        };
        CrossForces {
            f_axial1: settle(doubtful.f_axial1, rough.f_axial1, |i| i.along(&i.e1a)),
            f_axial3: settle(doubtful.f_axial3, rough.f_axial3, |i| i.along(&i.e3b)),
            f_bend: settle(doubtful.f_bend, rough.f_bend, CrossLoads::across),
        }
    }

    /// Bounds of the rounding errors of the three products: 4 ε times the sums of the sizes of all products.
    fn rounding(&self) -> CrossForces<D::Leaf> {
        let size = |v: &Vector3<D>| abs(leaf(v.x)) + abs(leaf(v.y)) + abs(leaf(v.z));
        let (e1a, e3b) = (size(&self.e1a), size(&self.e3b));
        let beside = size(&self.e2a) * abs(leaf(self.f2)) + size(&self.e3a) * abs(leaf(self.f3));
        let force = e1a * abs(leaf(self.f1)) + beside;
        let rounding = |size: D::Leaf| size * (4.0 * D::Leaf::EPSILON);
        CrossForces {
            f_axial1: rounding(force * e1a),
            f_axial3: rounding(force * e3b),
            f_bend: rounding(beside * (e1a * e3b)),
        }
    }

    /// The loads without derivatives, with scaled forces.
    fn leaves(&self, per_unit: D::Leaf) -> CrossLoads<D::Leaf> {
        let vector = |v: &Vector3<D>| v.map(leaf);
        let force = |f: D| leaf(f) * per_unit;
        CrossLoads {
            e1a: vector(&self.e1a),
            e2a: vector(&self.e2a),
            e3a: vector(&self.e3a),
            e3b: vector(&self.e3b),
            f1: force(self.f1),
            f2: force(self.f2),
            f3: force(self.f3),
        }
    }
}

impl<D: Scalar> CrossForces<D> {
    /// The results whose sign may be due to rounding.
    fn below(&self, rounding: &CrossForces<D::Leaf>) -> CrossForces<bool> {
        let is_below = |x: D, rounding: D::Leaf| abs(leaf(x)) < rounding;
        CrossForces {
            f_axial1: is_below(self.f_axial1, rounding.f_axial1),
            f_axial3: is_below(self.f_axial3, rounding.f_axial3),
            f_bend: is_below(self.f_bend, rounding.f_bend),
        }
    }
}

impl<L: Leaf> CrossLoads<L> {
    /// F·v.
    fn along(&self, v: &Vector3<L>) -> L {
        let size = |e: &Vector3<L>| abs(e.x) * abs(v.x) + abs(e.y) * abs(v.y) + abs(e.z) * abs(v.z);
        let in_pairs = |e: &Vector3<L>| {
            let product = |c: usize| Pair::product(e[c], v[c]);
            product(0) + product(1) + product(2)
        };
        let exact = |f: L, e: &Vector3<L>| [0, 1, 2].map(|c| [f, e[c], v[c], L::one()]);
        settled(&[(self.f1, self.e1a), (self.f2, self.e2a), (self.f3, self.e3a)], size, in_pairs, exact)
    }

    /// F·(a × b) for the axes a = e1a and b = e3b of the cross.
    fn across(&self) -> L {
        let (a, b) = (&self.e1a, &self.e3b);
        // A force along an axis of the cross has no component normal to it; nor has any force if the two axes coincide.
        let across =
            |f: L, e: &Vector3<L>| choice(|| [if f == 0.0 || are_dependent([e, a, b]) { L::zero() } else { f }]);
        let ([f2], [f3]) = (across(self.f2, &self.e2a), across(self.f3, &self.e3a));
        let forces = [(f2, self.e2a), (f3, self.e3a)];
        if forces.iter().all(|(f, _)| *f == 0.0) {
            return L::zero();
        }

        let cross_size = |c: usize, d: usize| abs(a[c]) * abs(b[d]) + abs(a[d]) * abs(b[c]);
        let cross_sizes = [cross_size(1, 2), cross_size(2, 0), cross_size(0, 1)];
        let cross = |c: usize, d: usize| Pair::product(a[c], b[d]) - Pair::product(a[d], b[c]);
        let cross = [cross(1, 2), cross(2, 0), cross(0, 1)];

        let size = |e: &Vector3<L>| abs(e.x) * cross_sizes[0] + abs(e.y) * cross_sizes[1] + abs(e.z) * cross_sizes[2];
        let in_pairs = |e: &Vector3<L>| cross[0] * e.x + cross[1] * e.y + cross[2] * e.z;
        let exact = |f: L, e: &Vector3<L>| {
            let [x, y, z] = [(e.x, 1, 2), (e.y, 2, 0), (e.z, 0, 1)]
                .map(|(component, c, d)| [[f, component, a[c], b[d]], [f, component, -a[d], b[c]]]);
            [x[0], x[1], y[0], y[1], z[0], z[1]]
        };
        settled(&forces, size, in_pairs, exact)
    }
}

/// The sum of forces times a product of their directions: in pairs, if its sign is certain compared with the sum of the sizes;
/// otherwise exactly.
#[inline]
fn settled<L: Leaf, const N: usize, const TERMS: usize>(
    forces: &[(L, Vector3<L>); N],
    size: impl Fn(&Vector3<L>) -> L,
    in_pairs: impl Fn(&Vector3<L>) -> Pair<L>,
    exact: impl Fn(L, &Vector3<L>) -> [[L; 4]; TERMS],
) -> L {
    let [sizes, fine] = choice(|| {
        let (mut sizes, mut fine) = (L::zero(), None);
        for (f, e) in forces {
            if *f == 0.0 {
                continue;
            }
            sizes += abs(*f) * size(e);
            // A single force is multiplied last, where it costs only one rounding.
            fine = Some(match fine {
                None => (in_pairs(e), *f),
                Some((sum, g)) => (sum * g + in_pairs(e) * *f, L::one()),
            });
        }
        [sizes, fine.map_or(sizes, |(sum, f)| sum.value() * f)]
    });
    let [settled] = choice(|| {
        let is_certain = sizes == 0.0 || abs(fine) > sizes * rounding_of_pairs::<L>();
        [if is_certain { fine } else { L::exact_sum(forces.iter().flat_map(|(f, e)| exact(*f, e))) }]
    });
    settled
}

/// Whether two of three vectors are equal or opposite.
fn are_dependent<L: Leaf>([a, b, c]: [&Vector3<L>; 3]) -> bool {
    let is_zero = |v: Vector3<L>| abs(v.x).or_larger(abs(v.y)).or_larger(abs(v.z)) == 0.0;
    [(a, b), (b, c), (c, a)].iter().any(|&(v, w)| is_zero(v - w) || is_zero(v + w))
}

#[cfg(test)]
mod tests {
    use super::super::Parts;
    use super::*;
    use crate::connector::ujoint::Decomposition;
    use crate::formula::Formula;
    use num_dual::Dual64;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vector3<f64>> {
        prop::array::uniform3(-1000..1000_i32).prop_map(|v| Vector3::from(v.map(f64::from)) / 1024.0)
    }

    proptest! {
        /// The cheaper bound is above the others, whatever the sizes.
        #[test]
        fn most_rounding_is_above_each(
            vectors in prop::array::uniform4(vector()), forces in prop::array::uniform3(-4.0..4.0_f64),
            sizes in prop::array::uniform4(-600..160_i32), common in -300..300_i32,
        ) {
            let power = |exponent| 2.0_f64.powi(exponent);
            let [e1a, e2a, e3a, e3b] = std::array::from_fn(|k| vectors[k] * power(sizes[k]));
            let [f1, f2, f3] = forces.map(|f| f * power(common));
            let i = CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 };
            let (most, CrossForces { f_axial1, f_axial3, f_bend }) = (i.most_rounding(), i.rounding());
            for each in [f_axial1, f_axial3, f_bend] {
                prop_assert!(most >= each, "{most:e} is below {each:e}");
            }
        }

        /// Terms may be small multiples of the smallest number: a result whose sign rounding may decide is still not above the
        /// bound.
        #[test]
        fn most_rounding_does_not_underflow(m in 1..8_i32, n in 1..8_i32, size in 60..300_i32) {
            let (m, n, smallest, large) = (f64::from(m), f64::from(n), f64::from_bits(1), 2.0_f64.powi(size));
            let e1a = Vector3::new(n, -m * (1.0 + f64::EPSILON), 0.0) * large;
            let (e2a, e3a, e3b) = (Vector3::new(m, n, 0.0), Vector3::zeros(), Vector3::new(1.0, 2.0, 3.0));
            let i = CrossLoads { e1a, e2a, e3a, e3b, f1: 0.0, f2: smallest, f3: 0.0 };
            let rough = Parts::new(&i).decomposed(&i);
            prop_assert!(rough.smallest() > 0.0 && rough.below(&i.rounding()).f_axial1);
            prop_assert!(rough.smallest() <= i.most_rounding());
        }

        /// If large terms cancel exactly, tiny ones remain, unaffected by rounding.
        #[test]
        fn what_remains_beside_terms_that_cancel_is_told(
            e1a in vector(), e3a in vector(), factors in prop::array::uniform2(-8..8_i8), size in -600..600_i32,
        ) {
            let [m, n] = factors.map(f64::from);
            let e2a = Vector3::new(e1a.y, -e1a.x, 0.0);
            let large = 1.1 * 2.0_f64.powi(size);
            let tiny = -large * 2.0_f64.powi(-300);
            let i = CrossLoads { e1a, e2a, e3a, e3b: e1a * m + e2a * n, f1: 0.0, f2: large, f3: tiny };
            let out = Decomposition::eval(&i);
            prop_assert_eq!(out.f_axial1, tiny * e3a.dot(&e1a));
            prop_assert_eq!(out.f_bend, tiny * e3a.dot(&i.e1a.cross(&i.e3b)));
            let alone = Decomposition::eval(&CrossLoads { f3: 0.0, ..i });
            prop_assert_eq!((alone.f_axial1, alone.f_bend), (0.0, 0.0));
        }
    }

    #[test]
    fn what_pairs_lose_is_summed_exactly_whatever_the_size() {
        const TINY: f64 = f64::EPSILON;
        let none = CrossLoads {
            e1a: Vector3::zeros(),
            e2a: Vector3::zeros(),
            e3a: Vector3::zeros(),
            e3b: Vector3::zeros(),
            f1: 0.0,
            f2: 0.0,
            f3: 0.0,
        };
        for size in [1.0, 2.0_f64.powi(60), 2.0_f64.powi(-60)] {
            // (1 + ε)(1 − ε) − 1, from two forces.
            let [e1a, e2a, e3a] = [1.0 + TINY, 1.0 - TINY, 1.0].map(|x| Vector3::new(x, 0.0, 0.0));
            let (f2, f3) = ((1.0 + TINY) * size, -size);
            let two = Decomposition::eval(&CrossLoads { e1a, e2a, e3a, f2, f3, ..none });
            assert_eq!(two.f_axial1, -TINY * TINY * (1.0 + TINY) * size);
            // (1 + ε)² − (1 + 2ε) + ε²/4, from one force; in doubles only the last term remains.
            let e3a = Vector3::new(1.0 + TINY, 1.0 + 2.0 * TINY, 0.5 * TINY);
            let e1a = Vector3::new(1.0 + TINY, -1.0, 0.5 * TINY);
            let one = Decomposition::eval(&CrossLoads { e1a, e3a, f3: size, ..none });
            assert_eq!(one.f_axial1, 1.25 * TINY * TINY * size);
            let one = Decomposition::eval(&CrossLoads { e1a, e2a: e3a, f2: size, ..none });
            assert_eq!(one.f_axial1, 1.25 * TINY * TINY * size);
            // The remainder is below the last digits of a pair.
            let [small, smaller] = [-60, -120].map(|n| 2.0_f64.powi(n));
            let e1a = Vector3::new(1.0, 1.0, 1.0);
            let [e2a, e3a] = [smaller, 0.0].map(|z| Vector3::new(1.0, small, z));
            let left = Decomposition::eval(&CrossLoads { e1a, e2a, e3a, f2: size, f3: -size, ..none });
            assert_eq!(left.f_axial1, smaller * size);
        }
    }

    #[test]
    fn derivatives_stay() {
        let [x, y] = [0.6, 0.8].map(Dual64::from);
        let zero = Dual64::from(0.0);
        let (e1a, e2a) = (Vector3::new(x, y, zero), Vector3::new(-y, x.derivative(), zero));
        let e3 = Vector3::new(zero, zero, Dual64::from(1.0));
        let out =
            Decomposition::eval(&CrossLoads { e1a, e2a, e3a: e3, e3b: e3, f1: zero, f2: Dual64::from(2.3), f3: zero });
        assert_eq!((out.f_axial1.re, out.f_axial1.eps), (0.0, 2.3 * 0.8));
    }
}
