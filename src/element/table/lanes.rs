//! The registers of a block of elements, and the wiring of a formula to them.

use crate::Scalar;
use crate::formula::error::Error;
use nalgebra::Vector3;
use std::ops::Range;

/// The registers in which a step finds its inputs and stores its outputs, component by component.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wiring {
    /// A register per input component.
    pub(crate) inputs: Vec<u16>,
    /// A register per output component.
    pub(crate) outputs: Vec<u16>,
}

/// A range of consecutive registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) at: usize,
    pub(crate) len: usize,
}

impl Span {
    #[inline]
    pub(crate) fn range(self) -> Range<usize> {
        self.at..self.at + self.len
    }
}

/// The number of elements that are evaluated together: few enough for their registers to stay in the first-level cache.
pub(crate) const LANES: usize = 64;

/// The values of one register for all elements of a block.
pub(crate) type Column<T> = [T; LANES];

/// A block of elements: a column per register. Lanes beyond the last element are not modified.
#[derive(Debug)]
pub struct Lanes<'r, T> {
    /// The registers that persist from state to state.
    pub(crate) lasting: &'r mut [Column<T>],
    /// The registers after them, which all blocks of a task use in turn.
    pub(crate) passing: &'r mut [Column<T>],
    /// The index of the first element in its group.
    pub(crate) first: usize,
    /// The number of lanes that hold an element.
    pub(crate) count: usize,
}

impl<T: Scalar> Lanes<'_, T> {
    /// The columns of these registers.
    fn columns(&mut self, span: Span) -> &mut [Column<T>] {
        match span.at.checked_sub(self.lasting.len()) {
            Some(at) => &mut self.passing[at..at + span.len],
            None => &mut self.lasting[span.range()],
        }
    }

    /// Copies persistent registers to temporary ones.
    pub(crate) fn copy(&mut self, lasting: Span, passing: Span) {
        let at = passing.at - self.lasting.len();
        self.passing[at..at + passing.len].copy_from_slice(&self.lasting[lasting.range()]);
    }

    /// Fills the registers of a vector, or of its part in the plane, with the same value for all lanes.
    pub(crate) fn spread(&mut self, span: Span, vector: Vector3<T>) {
        for (register, &component) in self.columns(span).iter_mut().zip(&vector) {
            *register = [component; LANES];
        }
    }

    /// Fills the registers with a vector of each lane's node.
    #[inline]
    pub(crate) fn fill(&mut self, span: Span, nodes: &Column<u32>, vector: impl Fn(u32) -> Vector3<T>) {
        let count = self.count.min(LANES);
        match self.columns(span) {
            [x, y, z] => {
                for lane in 0..count {
                    let vector = vector(nodes[lane]);
                    (x[lane], y[lane], z[lane]) = (vector.x, vector.y, vector.z);
                }
            }
            [x, y] => {
                for lane in 0..count {
                    let vector = vector(nodes[lane]);
                    (x[lane], y[lane]) = (vector.x, vector.y);
                }
            }
            others => unreachable!("a position has two or three components, not {}", others.len()),
        }
    }
}

/// A formula that rejected its inputs or overflowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The index of the element in its group.
    pub element: usize,
    /// The formula.
    pub formula: &'static str,
    /// The error.
    pub error: Error,
}
