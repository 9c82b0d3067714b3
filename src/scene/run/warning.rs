//! What is ambiguous in a run, or looks like a mistake.

use std::fmt;

/// Something ambiguous, or that looks like a mistake.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// A rotation of which only the end is known.
    UnknownWay {
        /// The state, counted from 0.
        state: usize,
        /// The node.
        node: String,
        /// The size of the change of the rotation vector.
        angle: f64,
    },
    /// The arms of a cross that were parallel in a state or on the way to it, where its angles jump by half a turn.
    ParallelArms {
        /// The state, counted from 0.
        state: usize,
        /// The element.
        element: String,
        /// Its nodes a and b.
        nodes: [String; 2],
    },
    /// A node that is farther on the wrong side of its slide line than the nearest segment is long.
    WrongSide {
        /// The state, counted from 0.
        state: usize,
        /// The line.
        slide_line: String,
        /// The node.
        node: String,
        /// The overclosure −E11.
        overclosure: f64,
        /// The length of the segment.
        segment: f64,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownWay { state, node, angle } => write!(
                f,
                "frames[{state}], node {node:?}: its rotation vector changes by {angle:.4} ({:.1}°) and not along one axis, so how it \
                 turned is not known; angles take the shortest way. Add states between",
                angle.to_degrees()
            ),
            Self::ParallelArms { state, element, nodes: [a, b] } => write!(
                f,
                "frames[{state}], element {element:?}: the arms of its cross, e1 of node {a:?} and e3 of node {b:?}, become parallel; \
                 there its angles jump by half a turn"
            ),
            Self::WrongSide { state, slide_line, node, overclosure, segment } => write!(
                f,
                "frames[{state}], node {node:?} is {overclosure:.4} on the wrong side of slide line {slide_line:?}, farther than the \
                 nearest segment is long ({segment:.4}): do the nodes of the line run the other way?"
            ),
        }
    }
}
