//! Slide lines as a model states them: node numbers in sequence.

use super::{Nodes, PlacedLine};
use crate::Scalar;
use crate::error::Error;
use crate::quantity::FRACTION;

/// The segments of a slide line (TYPE).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Straight, from node to node.
    Linear,
    /// Parabolic, over three nodes each.
    Parabolic,
}

impl Kind {
    /// How many nodes further the next segment begins.
    pub(super) const fn stride(self) -> usize {
        match self {
            Self::Linear => 1,
            Self::Parabolic => 2,
        }
    }

    fn allows(self, count: usize) -> bool {
        count > self.stride() && (count - 1).is_multiple_of(self.stride())
    }

    const fn allowed(self) -> &'static str {
        match self {
            Self::Linear => "at least 2 nodes in a linear slide line",
            Self::Parabolic => "an odd number of nodes, at least 3, in a parabolic slide line",
        }
    }
}

/// The nodes of a slide line in sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Sequence {
    Listed(Vec<u32>),
    /// Not written out, since a wrong one may count billions.
    Generated {
        first: u32,
        increment: i64,
        count: usize,
    },
}

impl Sequence {
    fn len(&self) -> usize {
        match self {
            Self::Listed(nodes) => nodes.len(),
            Self::Generated { count, .. } => *count,
        }
    }

    fn iter(&self) -> Box<dyn Iterator<Item = u32> + '_> {
        match *self {
            Self::Listed(ref nodes) => Box::new(nodes.iter().copied()),
            Self::Generated { first, increment, count } => {
                let numbers = std::iter::successors(Some(i64::from(first)), move |node| Some(node + increment));
                Box::new(numbers.take(count).filter_map(|node| u32::try_from(node).ok()))
            }
        }
    }
}

/// A slide line (\*SLIDE LINE): the master surface, on which slide-line elements slide.
///
/// The sequence of the nodes gives the tangent, and with it the side of the slave: to the left. A line whose last node
/// is its first is not taken to be closed.
///
/// ```
/// use jointproof::slide_line::{Kind, Nodes, Place, SlideLine};
/// let nodes = Nodes::new([(10, [1.0, 0.0]), (20, [2.0, 0.0]), (30, [3.0, 1.0])])?;
/// let line = SlideLine::generate(Kind::Linear, 10, 30, 10)?.smoothed(SlideLine::SMOOTHING)?;
/// let closest = line.place(&nodes)?.closest([1.5, 0.25].into())?;
/// assert_eq!((closest.place, closest.separation), (Place::Segment { index: 0, g: 0.0 }, 0.25));
///
/// let error = SlideLine::new(Kind::Parabolic, [10, 20]).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "2 nodes are given; allowed is an odd number of nodes, at least 3, in a parabolic slide line"
/// );
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SlideLine {
    kind: Kind,
    sequence: Sequence,
    smoothing: Option<f64>,
}

impl SlideLine {
    /// The smoothing fraction that is usual where none is given.
    pub const SMOOTHING: f64 = 0.2;

    /// A slide line through these nodes.
    ///
    /// # Errors
    /// [`Error::NodeCount`]: fewer than two nodes, or of a parabolic line fewer than three or an even number.
    pub fn new(kind: Kind, nodes: impl Into<Vec<u32>>) -> Result<Self, Error> {
        Self::from_sequence(kind, Sequence::Listed(nodes.into()))
    }

    /// A slide line through the nodes `first`, `first + increment`, …, `last` (GENERATE).
    ///
    /// # Errors
    /// [`Error::Increment`]: an increment of 0, of the wrong sign, or that misses `last`; [`Error::NodeCount`] as in
    /// [`Self::new`].
    pub fn generate(kind: Kind, first: u32, last: u32, increment: i64) -> Result<Self, Error> {
        let way = i64::from(last) - i64::from(first);
        let steps = way.checked_div(increment).filter(|&steps| steps >= 0 && steps * increment == way);
        let steps = steps.ok_or(Error::Increment { first, last, increment })?;
        let count = usize::try_from(steps).unwrap_or(usize::MAX).saturating_add(1);
        Self::from_sequence(kind, Sequence::Generated { first, increment, count })
    }

    fn from_sequence(kind: Kind, sequence: Sequence) -> Result<Self, Error> {
        if !kind.allows(sequence.len()) {
            return Err(Error::NodeCount { count: sequence.len(), allowed: kind.allowed() });
        }
        Ok(Self { kind, sequence, smoothing: None })
    }

    /// Smooths the corners over the fraction `f` of each segment, 0 < f < ½; [`Self::SMOOTHING`] is usual.
    ///
    /// A corner between straight segments becomes a parabola, one between parabolas a cubic.
    ///
    /// # Errors
    /// `f` outside these bounds.
    pub fn smoothed(self, f: f64) -> Result<Self, Error> {
        Error::check("f", None, f, FRACTION.domain)?;
        Ok(Self { smoothing: Some(f), ..self })
    }

    /// Whether its segments are straight or parabolic.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The smoothing fraction, if its corners are smoothed.
    pub fn smoothing(&self) -> Option<f64> {
        self.smoothing
    }

    /// The numbers of its nodes in sequence.
    pub fn nodes(&self) -> impl Iterator<Item = u32> {
        self.sequence.iter()
    }

    /// The line where its nodes are now, ready to be asked for closest points.
    ///
    /// # Errors
    /// [`Error::UnknownNode`], or [`Error::CoincidentNodes`] of one segment.
    pub fn place<D: Scalar>(&self, nodes: &Nodes<D>) -> Result<PlacedLine<D>, Error> {
        let (mut numbers, mut positions) = (Vec::new(), Vec::new());
        for node in self.nodes() {
            positions.push(nodes.position(node)?);
            numbers.push(node);
        }
        PlacedLine::new(self.kind, self.smoothing, numbers, positions)
    }
}
