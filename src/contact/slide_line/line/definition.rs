//! Slide lines as defined in a model: node numbers in sequence.

use super::interpolation::Interpolation;
use super::nodes::{Nodes, check_position};
use super::placed::PlacedLine;
use crate::Scalar;
use crate::contact::slide_line::{
    ClosestLinear, ClosestParabolic, ClosestSmoothedLinear, ClosestSmoothedParabolic, SlipIncrementLinear,
    SlipIncrementParabolic,
};
use crate::formula::Formula;
use crate::formula::error::Error;
use crate::formula::quantity::{EXTENSION_ZONE, SMOOTH};
use nalgebra::Vector2;
use std::sync::Arc;

/// The nodes of a slide line in sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Sequence {
    Listed(Arc<[u32]>),
    /// Not expanded, since an erroneous definition may count billions of nodes.
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
                let number = |node| u32::try_from(node).expect("every node is between the first and the last");
                Box::new(numbers.take(count).map(number))
            }
        }
    }

    /// The expanded sequence; shared if it is already expanded.
    fn numbers(&self) -> Arc<[u32]> {
        match self {
            Self::Listed(nodes) => Arc::clone(nodes),
            Self::Generated { .. } => self.iter().collect(),
        }
    }
}

/// A slide line (\*SLIDE LINE): the master surface, on which slide-line elements slide.
///
/// The sequence of the nodes determines the tangent, and with it the side of the slave: to the left. An open line is extended
/// at either end. A line whose last node is its first has no ends to extend, and is not treated as closed otherwise.
///
/// ```
/// use jointproof::contact::slide_line::{Interpolation, Nodes, Place, SlideLine};
/// let nodes = Nodes::new([(10, [1.0, 0.0]), (20, [2.0, 0.0]), (30, [3.0, 1.0])])?;
/// let line = SlideLine::generate(Interpolation::Linear, 10, 30, 10)?.smoothed(0.2)?;
/// let closest = line.place(&nodes)?.closest([1.5, 0.25].into())?;
/// assert_eq!((closest.place, closest.separation), (Place::Segment { index: 0, g: 0.0 }, 0.25));
///
/// let error = SlideLine::new(Interpolation::Parabolic, [10, 20]).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "2 nodes are given; allowed is an odd number of nodes, at least 3, in a parabolic slide line"
/// );
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SlideLine {
    interpolation: Interpolation,
    sequence: Sequence,
    smoothing: Option<f64>,
    extension: f64,
}

impl SlideLine {
    /// The fraction of the end segment by which an open line is extended if none is given (keyword page of \*SLIDE LINE).
    pub const EXTENSION: f64 = 0.1;

    /// A slide line through these nodes.
    ///
    /// # Errors
    /// [`Error::NodeCount`]: fewer than two nodes, or for a parabolic line fewer than three or an even number.
    pub fn new(interpolation: Interpolation, nodes: impl Into<Vec<u32>>) -> Result<Self, Error> {
        Self::from_sequence(interpolation, Sequence::Listed(nodes.into().into()))
    }

    /// A slide line through the nodes `first`, `first + increment`, …, `last` (GENERATE).
    ///
    /// # Errors
    /// [`Error::Increment`]: an increment of 0, of the wrong sign, or that misses `last`; [`Error::NodeCount`] as in
    /// [`Self::new`].
    pub fn generate(interpolation: Interpolation, first: u32, last: u32, increment: i64) -> Result<Self, Error> {
        let path_length = i64::from(last) - i64::from(first);
        let steps = path_length.checked_div(increment).filter(|&steps| steps >= 0 && steps * increment == path_length);
        let steps = steps.ok_or(Error::Increment { first, last, increment })?;
        let count = usize::try_from(steps).ok().and_then(|steps| steps.checked_add(1));
        let count = count.ok_or(Error::Increment { first, last, increment })?;
        Self::from_sequence(interpolation, Sequence::Generated { first, increment, count })
    }

    fn from_sequence(interpolation: Interpolation, sequence: Sequence) -> Result<Self, Error> {
        if !interpolation.allows(sequence.len()) {
            return Err(Error::NodeCount { count: sequence.len(), allowed: interpolation.allowed() });
        }
        Ok(Self { interpolation, sequence, smoothing: None, extension: Self::EXTENSION })
    }

    /// Smooths the corners over the fraction `f` of each segment, 0 ≤ f < ½ (SMOOTH). The default is 0: corners are sharp.
    ///
    /// A corner between straight segments becomes a parabola, one between parabolas a cubic.
    ///
    /// # Errors
    /// `f` outside these bounds.
    pub fn smoothed(self, f: f64) -> Result<Self, Error> {
        Error::check("f", None, f, SMOOTH.domain)?;
        Ok(Self { smoothing: Some(f).filter(|&f| f > 0.0), ..self })
    }

    /// Extends an open line at either end by a fraction of the length of its end segment, from 0 to 0.2 (EXTENSION ZONE).
    /// The default is [`Self::EXTENSION`]; with 0 the line ends at its nodes.
    ///
    /// The line continues along the tangent at its end. Contact is transmitted there, and not beyond.
    ///
    /// ```
    /// use jointproof::contact::slide_line::{Interpolation, Nodes, Place, SlideLine};
    /// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [3.0, 0.0])])?;
    /// let line = SlideLine::new(Interpolation::Linear, [1, 2])?;
    /// let place = |line: &SlideLine| Ok::<_, jointproof::Error>(line.place(&nodes)?.closest([3.125, 1.0].into())?.place);
    /// assert_eq!(place(&line)?, Place::Extension { number: 2, distance: 0.125 });
    /// assert_eq!(place(&line.extended(0.0)?)?, Place::Beyond { number: 2, distance: 0.125 });
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// A `fraction` outside these bounds.
    pub fn extended(self, fraction: f64) -> Result<Self, Error> {
        Error::check("extension_zone", None, fraction, EXTENSION_ZONE.domain)?;
        Ok(Self { extension: fraction, ..self })
    }

    /// Whether its segments are straight or parabolic.
    pub fn interpolation(&self) -> Interpolation {
        self.interpolation
    }

    /// The smoothing fraction, if its corners are smoothed.
    pub fn smoothing(&self) -> Option<f64> {
        self.smoothing
    }

    /// The fraction of the end segment by which it is extended if it is open.
    pub fn extension(&self) -> f64 {
        self.extension
    }

    /// The numbers of its nodes in sequence.
    pub fn nodes(&self) -> impl Iterator<Item = u32> {
        self.sequence.iter()
    }

    /// The formula by which the closest point of a segment or corner is found; if corners are smoothed, the formula of the
    /// corners.
    pub(crate) fn closest_formula(&self) -> &'static str {
        match (self.interpolation, self.smoothing) {
            (Interpolation::Linear, None) => ClosestLinear::SPEC.id,
            (Interpolation::Linear, Some(_)) => ClosestSmoothedLinear::SPEC.id,
            (Interpolation::Parabolic, None) => ClosestParabolic::SPEC.id,
            (Interpolation::Parabolic, Some(_)) => ClosestSmoothedParabolic::SPEC.id,
        }
    }

    /// The formula of the slip increment on a segment.
    pub(crate) fn slip_formula(&self) -> &'static str {
        match self.interpolation {
            Interpolation::Linear => SlipIncrementLinear::SPEC.id,
            Interpolation::Parabolic => SlipIncrementParabolic::SPEC.id,
        }
    }

    /// The line at the current positions of its nodes, ready for searches of closest points.
    ///
    /// # Errors
    /// [`Error::UnknownNode`], or [`Error::CoincidentNodes`] of one segment.
    pub fn place<D: Scalar>(&self, nodes: &Nodes<D>) -> Result<PlacedLine<D>, Error> {
        self.place_by(|node| nodes.position(node))
    }

    /// The same, with positions provided by the caller.
    pub(crate) fn place_by<D: Scalar>(
        &self,
        position: impl Fn(u32) -> Result<Vector2<D>, Error>,
    ) -> Result<PlacedLine<D>, Error> {
        // Done before the numbers are expanded: the first unknown node ends it.
        let positions = self.nodes().map(|node| check_position(node, position(node)?)).collect::<Result<_, _>>()?;
        let Self { interpolation, smoothing, extension, sequence } = self;
        PlacedLine::new(*interpolation, *smoothing, *extension, sequence.numbers(), positions)
    }
}
