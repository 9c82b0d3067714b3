//! What goes wrong in a run.

use crate::formula::error::Error;
use std::fmt;

/// Where something went wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Culprit {
    /// In an element.
    Element(String),
    /// On a slide line as a whole.
    SlideLine(String),
    /// At a node that slides on a line.
    SlidingNode {
        /// The line.
        slide_line: String,
        /// The node.
        node: String,
    },
    /// In an element that slides on a line.
    SlidingElement {
        /// The line.
        slide_line: String,
        /// The element.
        element: String,
    },
}

impl fmt::Display for Culprit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Element(element) => write!(f, "element {element:?}"),
            Self::SlideLine(line) => write!(f, "slide line {line:?}"),
            Self::SlidingNode { slide_line, node } => write!(f, "node {node:?} on slide line {slide_line:?}"),
            Self::SlidingElement { slide_line, element } => {
                write!(f, "element {element:?} on slide line {slide_line:?}")
            }
        }
    }
}

/// A formula that rejected its inputs during a run, or gave what no double can hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Where.
    pub culprit: Culprit,
    /// The state, counted from 0; `None` for the initial configuration.
    pub state: Option<usize>,
    /// The formula.
    pub formula: &'static str,
    /// What it says.
    pub error: Error,
    /// The same in words, with nodes called as the scene calls them.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { culprit, state, formula, message, .. } = self;
        match state {
            Some(state) => write!(f, "{culprit}, frames[{state}], {formula}: {message}"),
            None => write!(f, "{culprit}, initial configuration, {formula}: {message}"),
        }
    }
}

/// Problems of a state; a hundred at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Problems(pub Vec<Problem>);

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<_> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for Problems {}

/// An array of the history that cannot be read any more, or is not what it was when the scene was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The JSON path in the scene to where it is named, as `frames.nodes.cars.u`.
    pub path: String,
    /// What is there.
    pub found: String,
    /// What may be there.
    pub allowed: String,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, found, allowed } = self;
        write!(f, "{path}, since the scene was read: {found}; allowed is {allowed}")
    }
}

impl std::error::Error for Unreadable {}

/// Why a run stopped.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Stopped {
    /// Formulas that are undefined in some state.
    Problems(Problems),
    /// The file of arrays, which is read state by state.
    Unreadable(Unreadable),
}

impl From<Problems> for Stopped {
    fn from(problems: Problems) -> Self {
        Self::Problems(problems)
    }
}

impl From<Unreadable> for Stopped {
    fn from(unreadable: Unreadable) -> Self {
        Self::Unreadable(unreadable)
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Problems(problems) => problems.fmt(f),
            Self::Unreadable(unreadable) => unreadable.fmt(f),
        }
    }
}

impl std::error::Error for Stopped {}
