//! The space of inputs: the sizes and the values that a formula states, and the random numbers to move in it.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::formula::quantity::{Domain, Node, Unit};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::ops::Range;

/// A field of the inputs.
pub(crate) struct Place {
    pub(crate) range: Range<usize>,
    pub(crate) domain: Domain,
    pub(crate) unit: Unit,
}

/// The unit vectors of a node that are inputs: the first component of each, by axis.
pub(crate) struct Triad {
    pub(crate) axes: [Option<usize>; 3],
    pub(crate) is_plane: bool,
}

pub(crate) struct Space {
    pub(crate) places: Vec<Place>,
    pub(crate) triads: Vec<Triad>,
    /// The components that are not of a triad.
    pub(crate) free: Vec<usize>,
    scale: f64,
}

impl Space {
    pub(crate) fn of(formula: &dyn AnyFormula) -> Self {
        let fields = formula.inputs();
        let place = |(field, range): (&jointproof::formula::Field, Range<usize>)| Place {
            range,
            domain: field.quantity.domain,
            unit: field.quantity.unit,
        };
        let places: Vec<_> = fields.iter().zip(Field::ranges(fields)).map(place).collect();
        let mut nodes: Vec<(Node, Triad)> = Vec::new();
        let mut free = Vec::new();
        for Place { range, domain, .. } in &places {
            let (node, axis) = match *domain {
                Domain::Direction => (Node::A, 1),
                Domain::Triad(node, axis) => (node, axis),
                _ => {
                    free.extend(range.clone());
                    continue;
                }
            };
            let known = nodes.iter().position(|(known, _)| *known == node).unwrap_or_else(|| {
                nodes.push((node, Triad { axes: [None; 3], is_plane: range.len() == 2 }));
                nodes.len() - 1
            });
            nodes[known].1.axes[axis - 1] = Some(range.start);
        }
        let triads = nodes.into_iter().map(|(_, triad)| triad).collect();
        Self { places, triads, free, scale: formula.spec().scale }
    }

    /// Whether every component is in its domain and of the stated sizes.
    pub(crate) fn has(&self, inputs: &[f64]) -> bool {
        let is_sized = |x: f64| x == 0.0 || (1.0 / self.scale..=self.scale).contains(&x.abs());
        let is_in = |place: &Place| inputs[place.range.clone()].iter().all(|&x| is_sized(x) && place.domain.allows(x));
        self.places.iter().all(is_in)
    }

    /// The exponent of two of the largest stated size.
    pub(crate) fn most_doublings(&self) -> f64 {
        self.scale.log2()
    }
}

/// Random numbers.
pub(crate) struct Dice(ChaCha8Rng);

impl Dice {
    /// The same for a name and a seed on every machine.
    pub(crate) fn of(name: &str, seed: u64) -> Self {
        // FNV-1a.
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        Self(ChaCha8Rng::seed_from_u64(name.bytes().fold(0xcbf2_9ce4_8422_2325, hash) ^ seed))
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        let count = u64::try_from(count.max(1)).unwrap_or(1);
        usize::try_from(self.0.next_u64() % count).unwrap_or(0)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
        let bits = (self.0.next_u64() >> 11) as f64;
        bits * (f64::EPSILON / 2.0)
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn sign(&mut self) -> f64 {
        if self.below(2) == 0 { 1.0 } else { -1.0 }
    }

    pub(crate) fn one_of<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len()))
    }

    /// A number of either sign whose magnitude is a power of two with an exponent drawn from a range.
    pub(crate) fn doublings(&mut self, low: f64, high: f64) -> f64 {
        self.sign() * self.between(low, high).exp2()
    }
}
