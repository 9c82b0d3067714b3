//! Slide lines as a model states them: node numbers in sequence, and where the nodes are.

use super::placed::PlacedLine;
use crate::error::Error;
use crate::quantity::FRACTION;
use nalgebra::Vector2;
use std::collections::HashMap;

/// Where the nodes of a model are: (r, z) by number.
///
/// ```
/// use jointproof::slide_line::Nodes;
/// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [2.0, 0.5])])?;
/// assert_eq!(nodes.position(2)?.y, 0.5);
/// assert_eq!(nodes.position(3).unwrap_err().to_string(), "node 3 is unknown; allowed are nodes with coordinates");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nodes(HashMap<u32, Vector2<f64>>);

impl Nodes {
    /// The nodes of these numbers and coordinates.
    ///
    /// # Errors
    /// A coordinate that is not finite, a radius below 0, or a number given twice.
    pub fn new(nodes: impl IntoIterator<Item = (u32, [f64; 2])>) -> Result<Self, Error> {
        let mut positions = HashMap::new();
        for (node, x) in nodes {
            let allowed = "finite coordinates with r ≥ 0, once per node";
            let fault = |what| Error::Node { node, what, allowed };
            if !x.iter().all(|x| x.is_finite()) {
                return Err(fault(format!("is at ({}, {})", x[0], x[1])));
            }
            if x[0] < 0.0 {
                return Err(fault(format!("has the radius {}", x[0])));
            }
            if positions.insert(node, Vector2::from(x)).is_some() {
                return Err(fault("is given twice".into()));
            }
        }
        Ok(Self(positions))
    }

    /// Where a node is.
    ///
    /// # Errors
    /// [`Error::UnknownNode`].
    pub fn position(&self, node: u32) -> Result<Vector2<f64>, Error> {
        self.0.get(&node).copied().ok_or(Error::UnknownNode { node })
    }
}

/// The segments of a slide line.
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
    /// First number, increment and count; not written out, since a wrong one may count billions.
    Generated(u32, i64, usize),
}

impl Sequence {
    fn len(&self) -> usize {
        match self {
            Self::Listed(nodes) => nodes.len(),
            Self::Generated(_, _, count) => *count,
        }
    }

    fn iter(&self) -> Box<dyn Iterator<Item = u32> + '_> {
        match self {
            Self::Listed(nodes) => Box::new(nodes.iter().copied()),
            Self::Generated(first, increment, count) => {
                let numbers = std::iter::successors(Some(i64::from(*first)), |node| Some(node + increment));
                Box::new(numbers.take(*count).filter_map(|node| u32::try_from(node).ok()))
            }
        }
    }
}

/// A slide line (\*SLIDE LINE): the master surface, on which slide-line elements slide.
///
/// The sequence of the nodes gives the tangent, and with it the side of the slave: to the left.
///
/// ```
/// use jointproof::slide_line::{Kind, Nodes, Place, SlideLine};
/// let nodes = Nodes::new([(10, [1.0, 0.0]), (20, [2.0, 0.0]), (30, [3.0, 1.0])])?;
/// let line = SlideLine::generate(Kind::Linear, 10, 30, 10)?.smoothed(0.2)?;
/// let closest = line.place(&nodes)?.closest([1.5, 0.25].into())?;
/// assert_eq!((closest.place, closest.separation), (Place::Segment { index: 0, g: 0.0 }, 0.25));
///
/// let error = SlideLine::new(Kind::Parabolic, [10, 20]).unwrap_err();
/// assert_eq!(error.to_string(), "2 nodes are given; allowed is an odd number of nodes, at least 3, in a parabolic slide line");
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
        Self::from_sequence(kind, Sequence::Generated(first, increment, count))
    }

    fn from_sequence(kind: Kind, sequence: Sequence) -> Result<Self, Error> {
        if !kind.allows(sequence.len()) {
            return Err(Error::NodeCount { count: sequence.len(), allowed: kind.allowed() });
        }
        Ok(Self { kind, sequence, smoothing: None })
    }

    /// Smooths the corners over the fraction `f` of each segment, 0 < f < ½; [`Self::SMOOTHING`] is usual.
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

    /// The line where its nodes are now, ready to be asked for closest points.
    ///
    /// # Errors
    /// An unknown node, or two nodes of a segment at one place.
    pub fn place(&self, nodes: &Nodes) -> Result<PlacedLine, Error> {
        let mut numbers = Vec::new();
        let mut positions = Vec::new();
        for node in self.sequence.iter() {
            positions.push(nodes.position(node)?);
            numbers.push(node);
        }
        PlacedLine::new(self.kind, self.smoothing, numbers, positions)
    }
}

