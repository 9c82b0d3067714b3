//! The eliminated form at a state as linear equations, whose order of terms shows what is eliminated and what is kept.

use arrayvec::ArrayVec;
use std::fmt::{Display, Formatter, Result};

/// A node of a SLIDER.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LineNode {
    /// Node 1, the start of the line.
    One,
    /// Node n, the end of the line.
    N,
    /// Node m, which slides.
    M,
}

/// A coefficient times a displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// The displaced node.
    pub node: LineNode,
    /// The axis of the displacement, counted from 0.
    pub axis: usize,
    /// The coefficient of the displacement; never 0.
    pub coefficient: f64,
}

/// A sum of displacements that is 0. The first term is the eliminated displacement, with the coefficient 1; the second is the
/// kept one of node m, unless its coefficient is 0.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearEquation {
    terms: ArrayVec<Term, 8>,
}

impl LinearEquation {
    /// δx_m,axis as a linear function of the kept increment of m and of those of nodes 1 and n.
    pub(super) fn new<'a>(
        axis: usize,
        kept: (usize, f64),
        x1: impl Iterator<Item = &'a f64>,
        xn: impl Iterator<Item = &'a f64>,
    ) -> Self {
        let term = |node, (axis, coefficient): (usize, f64)| Term { node, axis, coefficient };
        let of = |node| move |(axis, &coefficient): (usize, &f64)| Term { node, axis, coefficient: -coefficient };
        let mut terms = ArrayVec::from_iter([term(LineNode::M, (axis, 1.0)), term(LineNode::M, (kept.0, -kept.1))]);
        terms.extend(x1.enumerate().map(of(LineNode::One)));
        terms.extend(xn.enumerate().map(of(LineNode::N)));
        terms.retain(|term| term.coefficient != 0.0);
        Self { terms }
    }

    /// The terms whose sum is 0.
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// As `*EQUATION` of Abaqus and CalculiX, with the numbers of nodes 1, n and m. These programs read 20 characters per number,
    /// so 13 digits are written.
    ///
    /// ```
    /// use jointproof::connector::slider::Slider2d;
    /// use nalgebra::Vector2;
    ///
    /// let slider = Slider2d::new(Vector2::zeros(), Vector2::new(4.0, 2.0))?;
    /// let equation = slider.equation(Vector2::new(2.0, 1.0))?; // m in the middle; y follows from x
    /// assert_eq!(
    ///     equation.card([1, 2, 3]).to_string(),
    ///     "*EQUATION\n6\n\
    ///      3, 2, 1.000000000000e0, 3, 1, -5.000000000000e-1, 1, 1, 2.500000000000e-1, 1, 2, -5.000000000000e-1\n\
    ///      2, 1, 2.500000000000e-1, 2, 2, -5.000000000000e-1\n"
    /// );
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub const fn card(&self, nodes: [u32; 3]) -> impl Display {
        Card { equation: self, nodes }
    }
}

/// An equation, and the numbers of its nodes.
struct Card<'a> {
    equation: &'a LinearEquation,
    nodes: [u32; 3],
}

impl Display for Card<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let terms = self.equation.terms();
        writeln!(f, "*EQUATION\n{}", terms.len())?;
        for line in terms.chunks(4) {
            for (k, Term { node, axis, coefficient }) in line.iter().enumerate() {
                let node = self.nodes[*node as usize];
                write!(f, "{}{node}, {}, {coefficient:.12e}", if k == 0 { "" } else { ", " }, axis + 1)?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
