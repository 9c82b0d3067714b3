//! Errors during a run.

use crate::formula::error::Error;
use std::fmt;

/// The location of an error.
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

/// A formula that rejected its inputs during a run, or gave a result that a double cannot represent.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The location.
    pub culprit: Culprit,
    /// The state, counted from 0; `None` for the initial configuration.
    pub state: Option<usize>,
    /// The formula.
    pub formula: &'static str,
    /// The error.
    pub error: Error,
    /// The same in words, with the names of the scene for nodes.
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

/// Problems of a state; at most a hundred.
#[derive(Clone, Debug, PartialEq)]
pub struct Problems(pub Vec<Problem>);

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<_> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for Problems {}

/// An array of the history that cannot be read any more, or has changed since the scene was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The JSON path in the scene where it is named, such as `frames.nodes.cars.u`.
    pub path: String,
    /// What was found there.
    pub found: String,
    /// What is allowed there.
    pub allowed: String,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, found, allowed } = self;
        write!(f, "{path}, since the scene was read: {found}; allowed is {allowed}")
    }
}

impl std::error::Error for Unreadable {}

/// The reason why a run stopped.
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
