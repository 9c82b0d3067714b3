//! Test points, drawn from the declared domains, the same on every machine.

use super::subject::Subject;
use crate::formula::proof::Proved;
use crate::formula::quantity::{Domain, Node, Shape};
use crate::formula::{Field, typed};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::ops::RangeInclusive;

/// A source of test points. Only integer arithmetic, + − × ÷ and √ are used, so a seed gives the same doubles anywhere.
#[derive(Clone, Debug)]
pub struct Sampler(ChaCha8Rng);

/// Numbers are drawn from this many doublings below 1 to as many above.
pub(super) const DOUBLINGS: i64 = 10;

/// After this many rejected draws in a row, `validate` and the domains must contradict each other.
const DRAWS: usize = 1000;

/// A triad, one row per unit vector, in space or in the plane.
type Triad = [[f64; 3]; 3];

impl Sampler {
    /// A sampler with this seed; the points of a formula do not depend on which other formulas are sampled.
    pub fn new<F: Proved>(seed: u64) -> Self {
        Self::for_formula(F::SPEC.id, seed)
    }

    /// A sampler of numbers that belong to no formula.
    pub fn named(name: &str, seed: u64) -> Self {
        Self::for_formula(name, seed)
    }

    /// A number of either sign, from 2⁻¹⁰ to 2¹⁰ in size.
    pub fn real(&mut self) -> f64 {
        self.signed()
    }

    pub(crate) fn for_formula(id: &str, seed: u64) -> Self {
        // FNV-1a of the identifier.
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let stream = id.bytes().fold(0xcbf2_9ce4_8422_2325, hash);
        Self(ChaCha8Rng::seed_from_u64(seed ^ stream))
    }

    /// Inputs of a formula that are valid together.
    ///
    /// Triads are true rotations, never the identity and never the same at both nodes; no number is 0.
    pub fn inputs<F: Proved>(&mut self) -> F::Inputs<f64> {
        typed(&self.components(&Subject::of::<F>()))
    }

    /// The components of valid inputs.
    ///
    /// # Panics
    /// If the formula rejects everything drawn from its domains, which is a mistake in the formula.
    pub(crate) fn components(&mut self, subject: &Subject) -> Vec<f64> {
        for _ in 0..DRAWS {
            let inputs = (subject.placed)(&self.fields(subject.inputs));
            if (subject.check)(&inputs).is_ok() {
                return inputs;
            }
        }
        panic!("{}: {DRAWS} points drawn from the domains were all refused; narrow the domains", subject.spec.id)
    }

    /// Components of these fields, each from its domain.
    pub(crate) fn fields(&mut self, fields: &[Field]) -> Vec<f64> {
        let plane = fields.iter().any(|field| field.quantity.shape == Shape::Vec2);
        let nodes = nodes(fields);
        let triads: Vec<_> = nodes.iter().map(|_| self.triad(plane)).collect();
        let mut drawn = Vec::new();
        for field in fields {
            for component in 0..field.len() {
                drawn.push(match field.quantity.domain {
                    Domain::Direction => triads[0][0][component],
                    Domain::Triad(node, axis) => {
                        let triad = nodes.iter().zip(&triads).find(|(name, _)| **name == node);
                        triad.expect("every node of a field is in the list of nodes").1[(axis - 1) % 3][component]
                    }
                    domain => self.number(domain),
                });
            }
        }
        drawn
    }

    pub(super) fn number(&mut self, domain: Domain) -> f64 {
        match domain {
            Domain::Real
            | Domain::Point
            | Domain::Meridian
            | Domain::Vector
            | Domain::Direction
            | Domain::Triad(..) => self.signed(),
            Domain::NonNegative | Domain::Positive => self.magnitude(),
            Domain::Angle => self.between(-std::f64::consts::PI, std::f64::consts::PI),
            Domain::Between(low, high) | Domain::Within(low, high) | Domain::HalfOpen(low, high) => {
                self.between(low, high)
            }
        }
    }

    /// Uniform in (0, 1): an odd multiple of 2⁻⁵³.
    pub(super) fn unit(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "52 bits and the one below them fit")]
        let odd = ((self.0.next_u64() >> 12) * 2 + 1) as f64;
        odd * (f64::EPSILON / 2.0)
    }

    /// A random integer from 0 to `count` − 1; the relative bias is at most `count` in 2⁶⁴.
    pub(super) fn below(&mut self, count: usize) -> usize {
        let count = u64::try_from(count).expect("a count is below 2⁶⁴");
        usize::try_from(self.0.next_u64() % count).expect("it is below a count")
    }

    /// A random integer in a range.
    pub(super) fn whole(&mut self, range: RangeInclusive<i64>) -> i64 {
        let count = range.end().abs_diff(*range.start()) + 1;
        range.start().wrapping_add_unsigned(self.0.next_u64() % count)
    }

    pub(super) fn coin(&mut self) -> bool {
        self.0.next_u32().is_multiple_of(2)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// From 2⁻¹⁰ to 2¹⁰, with every power of two equally likely.
    fn magnitude(&mut self) -> f64 {
        let mantissa = 1.0 + self.unit();
        let doublings = self.0.next_u32() % 20;
        (0..doublings).fold(mantissa / 1024.0, |x, _| x * 2.0)
    }

    fn signed(&mut self) -> f64 {
        let magnitude = self.magnitude();
        if self.coin() { magnitude } else { -magnitude }
    }

    /// A rotation far from the identity, in space from a random quaternion, in the plane from a random direction.
    fn triad(&mut self, plane: bool) -> Triad {
        if plane {
            let [c, s] = self.direction();
            return [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
        }
        let [w, x, y, z]: [f64; 4] = self.direction();
        rotation(w, x, y, z)
    }

    /// A unit vector with no component near 0, so that neither quaternions nor directions are degenerate.
    fn direction<const N: usize>(&mut self) -> [f64; N] {
        let sides = [(); N].map(|()| {
            let side = self.between(0.1, 1.0);
            if self.coin() { side } else { -side }
        });
        crate::number::scalar::direction(sides)
    }
}

/// The nodes that have a triad: a and b, and any others that the fields name.
fn nodes(fields: &[Field]) -> Vec<Node> {
    let mut nodes = vec![Node::A, Node::B];
    for field in fields {
        if let Domain::Triad(node, _) = field.quantity.domain
            && !nodes.contains(&node)
        {
            nodes.push(node);
        }
    }
    nodes
}

/// The triad of a unit quaternion, one row per unit vector.
pub(crate) fn rotation<D: crate::Scalar>(w: D, x: D, y: D, z: D) -> [[D; 3]; 3] {
    let double = |product: D| product * 2.0;
    let diagonal = |p: D, q: D| -double(p * p + q * q) + 1.0;
    [
        [diagonal(y, z), double(x * y + z * w), double(x * z - y * w)],
        [double(x * y - z * w), diagonal(x, z), double(y * z + x * w)],
        [double(x * z + y * w), double(y * z - x * w), diagonal(x, y)],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields;
    use crate::formula::quantity::{E1A, E2A, E2A_PLANE, FRACTION, MU, Quantity, SLIDER_N, X, XA_PLANE};
    use crate::formula::{Component, Document, Formula, Jacobian, Spec};
    use crate::{Error, Scalar};

    fn sampler() -> Sampler {
        Sampler::named("a sampler", 1)
    }

    fn range(numbers: &[f64]) -> [f64; 2] {
        [
            numbers.iter().copied().fold(f64::INFINITY, f64::min),
            numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    fn assert_reaches(numbers: &[f64], low: f64, high: f64) {
        let ([least, most], margin) = (range(numbers), (high - low) / 20.0);
        let is_near = |x: f64, end: f64| (x - end).abs() < margin;
        assert!(low < least && most < high && is_near(least, low) && is_near(most, high), "{least} to {most}");
    }

    #[test]
    fn numbers_are_of_their_domains_and_reach_their_ends() {
        let mut sampler = sampler();
        let mut drawn = |domain| (0..500).map(|_| sampler.number(domain)).collect::<Vec<_>>();
        for domain in [Domain::Real, Domain::Point, Domain::Vector] {
            let numbers = drawn(domain);
            let sizes: Vec<_> = numbers.iter().map(|x| x.abs().log2()).collect();
            assert_reaches(&sizes, -10.0, 10.0);
            let negative = numbers.iter().filter(|x| **x < 0.0).count();
            assert!((200..300).contains(&negative), "{negative}");
        }
        for domain in [Domain::NonNegative, Domain::Positive] {
            let logarithms: Vec<_> = drawn(domain).iter().map(|x| x.log2()).collect();
            assert_reaches(&logarithms, -10.0, 10.0);
        }
        assert_reaches(&drawn(Domain::Angle), -std::f64::consts::PI, std::f64::consts::PI);
        for domain in [Domain::Between(2.0, 5.0), Domain::Within(2.0, 5.0), Domain::HalfOpen(2.0, 5.0)] {
            assert_reaches(&drawn(domain), 2.0, 5.0);
        }
    }

    /// An odd multiple of 2⁻⁵³, so that neither 0 nor 1 is drawn.
    #[test]
    fn the_unit_interval_has_no_ends() {
        let mut sampler = sampler();
        let numbers: Vec<_> = (0..500).map(|_| sampler.unit()).collect();
        assert_reaches(&numbers, 0.0, 1.0);
        assert!(numbers.iter().all(|x| x * 2.0_f64.powi(53) % 2.0 == 1.0));
    }

    #[test]
    fn whole_numbers_are_all_that_there_are() {
        let mut sampler = sampler();
        let mut seen: Vec<_> = (0..100).map(|_| sampler.whole(-2..=1)).collect();
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen, [-2, -1, 0, 1]);
        let mut seen: Vec<_> = (0..100).map(|_| sampler.below(3)).collect();
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen, [0, 1, 2]);
        assert_eq!(sampler.whole(7..=7), 7);
        let heads = (0..1000).filter(|_| sampler.coin()).count();
        assert!((450..550).contains(&heads), "{heads}");
    }

    /// These numbers are the same on every machine; golden files depend on them.
    #[test]
    fn a_seed_and_a_name_give_the_same_numbers_anywhere() {
        let first = |name: &str, seed| Sampler::named(name, seed).real();
        assert_eq!(first("slot.friction", 1), Sampler::new::<crate::connector::slot::Friction>(1).real());
        assert_eq!(
            [first("a", 0), first("a", 1), first("ab", 0)],
            [12.271_636_340_390_55, 1.631_691_907_446_975_8, 59.974_091_053_969_715]
        );
    }

    /// For (cos 30°, 0, 0, sin 30°), a rotation by 60° about the third axis.
    #[test]
    fn a_quaternion_turns_by_twice_its_angle() {
        let (root, half) = (3.0_f64.sqrt() / 2.0, 0.5);
        let found = rotation(root, 0.0, 0.0, half);
        let expected = [[half, root, 0.0], [-root, half, 0.0], [0.0, 0.0, 1.0]];
        let close = |(found, expected): (&f64, &f64)| (found - expected).abs() < 1e-15;
        assert!(found.as_flattened().iter().zip(expected.as_flattened()).all(close), "{found:?}");
        let cyclic = rotation(root, half, 0.0, 0.0);
        assert!((cyclic[1][2] - root).abs() < 1e-15 && (cyclic[2][1] + root).abs() < 1e-15, "{cyclic:?}");
        let cyclic = rotation(root, 0.0, half, 0.0);
        assert!((cyclic[2][0] - root).abs() < 1e-15 && (cyclic[0][2] + root).abs() < 1e-15, "{cyclic:?}");
    }

    #[test]
    fn triads_are_right_handed_and_far_from_the_axes() {
        let mut sampler = sampler();
        for plane in [false, true] {
            for _ in 0..50 {
                let [a, b, c] = sampler.triad(plane).map(nalgebra::Vector3::from);
                assert!((a.cross(&b) - c).norm() < 1e-15 && (a.norm() - 1.0).abs() < 1e-15);
                assert!(a.dot(&b).abs() < 1e-15 && a.x < 0.999);
                assert_eq!(c.z == 1.0, plane);
            }
        }
        let directions: Vec<[f64; 3]> = (0..200).map(|_| sampler.direction()).collect();
        assert!(directions.iter().all(|v| (v.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15));
        // The smallest component is 0.1 next to two of at most 1.
        assert!(directions.as_flattened().iter().all(|x| x.abs() > 0.07 && x.abs() < 0.991));
        assert!(directions.as_flattened().iter().any(|x| x.abs() < 0.12));
        let negative = directions.as_flattened().iter().filter(|x| **x < 0.0).count();
        assert!((240..360).contains(&negative), "{negative}");
    }

    const OTHER: Quantity = Quantity::new("o", Shape::Vec3, X.unit, Domain::Triad(Node("o"), 3), "of another node");

    #[test]
    fn unit_vectors_of_a_node_are_of_one_triad() {
        let fields = |quantities: &[&'static Quantity]| -> Vec<_> {
            quantities.iter().map(|quantity| Field::new("field", quantity)).collect()
        };
        let in_space = fields(&[&E2A, &E1A, &OTHER, &MU]);
        assert_eq!(nodes(&in_space), [Node::A, Node::B, Node("o")]);
        let drawn = sampler().fields(&in_space);
        let mut again = sampler();
        let [a, _, other] = [(); 3].map(|()| again.triad(false));
        assert_eq!(drawn[..9], [a[1], a[0], other[2]].concat());
        assert_eq!((drawn.len(), drawn[9]), (10, again.number(Domain::NonNegative)));
        // A direction is the first vector of a.
        assert_eq!(sampler().fields(&fields(&[&SLIDER_N])), a[0]);
        let in_plane = sampler().fields(&fields(&[&E2A_PLANE, &XA_PLANE, &MU]));
        assert_eq!(in_plane[..2], sampler().triad(true)[1][..2]);
    }

    fields! { struct Part<T> { f: T = FRACTION } }

    /// Draws are refused above a quarter, or all of them; what is drawn is halved.
    #[derive(Clone, Copy)]
    struct Halved<const NONE: bool>;
    impl<const NONE: bool> Formula for Halved<NONE> {
        const SPEC: Spec = Spec::new("planted.half", "Half", Document::new("None").printed(""));
        type Inputs<T: Component> = Part<T>;
        type Outputs<T: Component> = Part<T>;
        fn eval<D: Scalar>(i: &Part<D>) -> Part<D> {
            *i
        }
        fn jacobian<D: Scalar>(_: &Part<D>) -> Jacobian<Self, D> {
            Part { f: Part { f: D::one() } }
        }
        fn validate<D: Scalar>(i: &Part<D>) -> Result<(), Error> {
            if NONE || i.f > 0.125 { Error::check("f", None, f64::NAN, Domain::Real) } else { Ok(()) }
        }
    }
    impl<const NONE: bool> Proved for Halved<NONE> {
        fn placed(drawn: Part<f64>) -> Part<f64> {
            Part { f: drawn.f / 2.0 }
        }
    }

    #[test]
    fn inputs_are_placed_and_drawn_again_until_they_are_valid() {
        let mut sampler = sampler();
        let drawn: Vec<_> = (0..200).map(|_| sampler.inputs::<Halved<false>>().f).collect();
        assert_reaches(&drawn, 0.0, 0.125);
    }

    #[test]
    #[should_panic(expected = "planted.half: 1000 points drawn from the domains were all refused")]
    fn a_formula_that_refuses_everything_is_told_so() {
        sampler().inputs::<Halved<true>>();
    }
}
