//! Test points, drawn from the declared domains, the same on every machine.

use super::subject::Subject;
use crate::formula::{Field, Fields, Formula};
use crate::quantity::{Domain, Node, Shape};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A source of test points. Only integer arithmetic, + − × ÷ and √ are used, so a seed gives the same doubles anywhere.
#[derive(Clone, Debug)]
pub struct Sampler(ChaCha8Rng);

/// The triads of the two nodes, a row per unit vector, in space or in the plane.
type Triads = [[[f64; 3]; 3]; 2];

impl Sampler {
    /// A sampler with this seed; a formula's points do not depend on which other formulas are sampled.
    pub fn new<F: Formula>(seed: u64) -> Self {
        Self::for_formula(F::SPEC.id, seed)
    }

    pub(super) fn for_formula(id: &str, seed: u64) -> Self {
        // FNV-1a of the identifier.
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let stream = id.bytes().fold(0xcbf2_9ce4_8422_2325, hash);
        Self(ChaCha8Rng::seed_from_u64(seed ^ stream))
    }

    /// Inputs of a formula that are valid together.
    ///
    /// Triads are true rotations, never the identity and never the same at both nodes; no number is 0.
    pub fn inputs<F: Formula>(&mut self) -> F::Inputs<f64> {
        let mut drawn = self.components(&Subject::of::<F>()).into_iter();
        F::Inputs::from_components(&mut || drawn.next().unwrap_or(f64::NAN))
    }

    /// The components of valid inputs.
    pub(super) fn components(&mut self, subject: &Subject) -> Vec<f64> {
        // Nearly every draw is valid; the bound only makes the loop's end evident.
        for _ in 0..1000 {
            let inputs = self.fields(subject.inputs);
            if (subject.check)(&inputs).is_ok() {
                return inputs;
            }
        }
        self.fields(subject.inputs)
    }

    fn fields(&mut self, fields: &[Field]) -> Vec<f64> {
        let plane = fields.iter().any(|field| field.quantity.shape == Shape::Vec2);
        let triads = [self.triad(plane), self.triad(plane)];
        let mut drawn = Vec::new();
        for field in fields {
            for component in 0..field.len() {
                drawn.push(self.number(field.quantity.domain, &triads, component));
            }
        }
        drawn
    }

    fn number(&mut self, domain: Domain, triads: &Triads, component: usize) -> f64 {
        match domain {
            Domain::Real | Domain::Point | Domain::Vector => self.signed(),
            Domain::NonNegative | Domain::Positive => self.magnitude(),
            Domain::Angle => self.between(-std::f64::consts::PI, std::f64::consts::PI),
            Domain::Direction => triads[0][0][component],
            Domain::Between(low, high) | Domain::Within(low, high) | Domain::HalfOpen(low, high) => {
                self.between(low, high)
            }
            Domain::Triad(node, axis) => {
                let triad = match node {
                    Node::A => triads[0],
                    Node::B => triads[1],
                };
                triad[(axis - 1) % 3][component]
            }
        }
    }

    /// Uniform in (0, 1): an odd multiple of 2⁻⁵³.
    fn unit(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "52 bits and the one below them fit")]
        let odd = ((self.0.next_u64() >> 12) * 2 + 1) as f64;
        odd * (f64::EPSILON / 2.0)
    }

    fn coin(&mut self) -> bool {
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
    fn triad(&mut self, plane: bool) -> [[f64; 3]; 3] {
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
