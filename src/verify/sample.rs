//! Test points, drawn from the declared domains, the same on every machine.

use super::subject::Subject;
use crate::formula::{Field, typed};
use crate::proof::Proved;
use crate::quantity::{Domain, Node, Shape};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::ops::RangeInclusive;

/// A source of test points. Only integer arithmetic, + − × ÷ and √ are used, so a seed gives the same doubles anywhere.
#[derive(Clone, Debug)]
pub struct Sampler(ChaCha8Rng);

/// Numbers are drawn from so many doublings below 1 to as many above.
pub(super) const DOUBLINGS: i64 = 10;

/// So many draws refused one after another are no chance: `validate` and the domains contradict each other.
const DRAWS: usize = 1000;

/// A triad, a row per unit vector, in space or in the plane.
type Triad = [[f64; 3]; 3];

impl Sampler {
    /// A sampler with this seed; a formula's points do not depend on which other formulas are sampled.
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
    /// If the formula refuses whatever is drawn from its domains, which only its author can mend.
    pub(crate) fn components(&mut self, subject: &Subject) -> Vec<f64> {
        for _ in 0..DRAWS {
            let inputs = (subject.placed)(&self.fields(subject.inputs));
            if (subject.check)(&inputs).is_ok() {
                return inputs;
            }
        }
        panic!("{}: {DRAWS} points drawn from the domains were all refused; narrow the domains", subject.spec.id)
    }

    fn fields(&mut self, fields: &[Field]) -> Vec<f64> {
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
            Domain::Real | Domain::Point | Domain::Vector | Domain::Direction | Domain::Triad(..) => self.signed(),
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

    /// One of the first `count` whole numbers, 0 among them; none is rarer than another by more than `count` in 2⁶⁴.
    pub(super) fn below(&mut self, count: usize) -> usize {
        let count = u64::try_from(count).expect("a count is below 2⁶⁴");
        usize::try_from(self.0.next_u64() % count).expect("it is below a count")
    }

    /// A whole number of a range.
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

    /// From 2⁻¹⁰ to 2¹⁰, every power of two equally likely.
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
        crate::scalar::direction(sides)
    }
}

/// The nodes that have a triad: a and b, and whatever others the fields name.
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

/// The triad of a unit quaternion, a row per unit vector.
pub(crate) fn rotation<D: crate::Scalar>(w: D, x: D, y: D, z: D) -> [[D; 3]; 3] {
    let double = |product: D| product * 2.0;
    let diagonal = |p: D, q: D| -double(p * p + q * q) + 1.0;
    [
        [diagonal(y, z), double(x * y + z * w), double(x * z - y * w)],
        [double(x * y - z * w), diagonal(x, z), double(y * z + x * w)],
        [double(x * z + y * w), double(y * z - x * w), diagonal(x, y)],
    ]
}
