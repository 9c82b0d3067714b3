//! The slider in space as a program uses it: a line checked once, then evaluated by the formulas.

use super::{
    Basis, Constraint, Coordinates, Direction, Distances, Eliminate, Ends, Increment, Increments, KeptCoordinate,
    KeptIncrement, Line, LineDirection, LinearEquation, Nodes, Pivots, SliderElement, Tangents,
};
use crate::element::{Contribution, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::{Fields, Formula, Jacobian, value, value_and_jacobian};
use nalgebra::{Matrix2x3, SMatrix, SVector, Vector2, Vector3};
use num_dual::Dual2_64;

/// The line through nodes 1 and n, on which node m slides.
///
/// ```
/// use jointproof::connector::slider::{Pivots, Slider};
/// use nalgebra::Vector3;
///
/// let slider = Slider::new(Vector3::zeros(), Vector3::new(2.0, 1.0, 4.0))?;
/// assert_eq!(slider.pivots(), Pivots { i: 1, j: 0, k: 2 }); // y and x follow from z
/// assert_eq!(slider.eliminate(8.0)?.xmi, 2.0);
///
/// let m = slider.place(Vector3::new(0.7, 0.3, 2.0))?; // keep z, put m on the line
/// assert_eq!(m, Vector3::new(1.0, 0.5, 2.0));
/// assert_eq!(slider.constraint(m)?.g1, 0.0);
///
/// let error = Slider::new(m, m).unwrap_err();
/// assert_eq!(error.to_string(), "x1 and xn are 0.0 apart; allowed is a distance ≥ 2.2250738585072014e-308");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    x1: Vector3<f64>,
    xn: Vector3<f64>,
}

/// The coefficients of an eliminated node for a finite-element code: the increments (δxm_i, δxm_j) as a linear function of δx1,
/// δxn and δxm_k.
///
/// ```
/// use jointproof::connector::slider::Slider;
/// use nalgebra::Vector3;
///
/// let slider = Slider::new(Vector3::zeros(), Vector3::new(2.0, 1.0, 4.0))?;
/// let c = slider.coefficients(Vector3::new(1.0, 0.5, 2.0))?; // m in the middle; y and x follow from z
/// assert_eq!(c.x1.row(0), c.xn.row(0));
/// assert_eq!(c.xn.row(0), nalgebra::RowVector3::new(0.0, 0.5, -0.125));
/// assert_eq!(c.xmk, nalgebra::Vector2::new(0.25, 0.5));
/// assert_eq!(c.matrix().ncols(), 7);
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// The axes: rows i and j, and the kept axis k.
    pub pivots: Pivots,
    /// Coefficients of δx1: a row for δxm_i, a row for δxm_j.
    pub x1: Matrix2x3<f64>,
    /// Coefficients of δxn.
    pub xn: Matrix2x3<f64>,
    /// Coefficients of δxm_k.
    pub xmk: Vector2<f64>,
}

impl Coefficients {
    /// All coefficients: columns δx1 (3), δxn (3), δxm_k.
    pub fn matrix(&self) -> SMatrix<f64, 2, 7> {
        let Self { x1, xn, xmk, .. } = self;
        SMatrix::from_fn(|row, column| match column {
            0..3 => x1[(row, column)],
            3..6 => xn[(row, column - 3)],
            _ => xmk[row],
        })
    }

    /// The two equations of the coordinates i and j of node m.
    pub fn equations(&self) -> [LinearEquation; 2] {
        let Self { pivots, x1, xn, xmk } = self;
        [(0, pivots.i), (1, pivots.j)]
            .map(|(row, axis)| LinearEquation::new(axis, (pivots.k, xmk[row]), x1.row(row).iter(), xn.row(row).iter()))
    }
}

/// The constraint, and its first and second derivatives along a motion of the nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variations {
    /// The value.
    pub value: Distances<f64>,
    /// The derivative along the motion: ∂g·δ.
    pub first: Distances<f64>,
    /// The second derivative along the motion: δ·∂²g·δ.
    pub second: Distances<f64>,
}

impl Slider {
    /// The line through two nodes.
    ///
    /// # Errors
    /// A position that is not finite, or nodes that coincide.
    pub fn new(x1: Vector3<f64>, xn: Vector3<f64>) -> Result<Self, Error> {
        value::<Line>(&Ends { x1, xn })?;
        Ok(Self { x1, xn })
    }

    /// Direction and length of the line ([`Line`]).
    pub fn line(&self) -> Direction<f64> {
        Line::eval(&Ends { x1: self.x1, xn: self.xn })
    }

    /// The documented directions normal to the line ([`Basis`]).
    pub fn basis(&self) -> Tangents<f64> {
        Basis::eval(&LineDirection { n: self.line().n })
    }

    /// Which coordinates of m are eliminated, and which is kept.
    pub fn pivots(&self) -> Pivots {
        Pivots::new(&self.x1, &self.xn)
    }

    /// The distance of m from the line ([`Constraint`]).
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn constraint(&self, xm: Vector3<f64>) -> Result<Distances<f64>, Error> {
        value::<Constraint>(&self.nodes(xm))
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn constraint_jacobian(&self, xm: Vector3<f64>) -> Result<(Distances<f64>, Jacobian<Constraint, f64>), Error> {
        value_and_jacobian::<Constraint>(&self.nodes(xm))
    }

    /// The constraint with its first and second derivative along a motion of the three nodes: δg = ∂g·δ and δ²g = δ·∂²g·δ,
    /// by second-order dual numbers.
    ///
    /// Newton's method needs both: the first is a row of the constraint's matrix, and the second, times the Lagrange multiplier,
    /// is the contribution of the constraint to the stiffness along this motion. The mixed derivative of two motions u and v
    /// follows from three calls: 2 u·∂²g·v = δ²g(u + v) − δ²g(u) − δ²g(v).
    ///
    /// ```
    /// use jointproof::connector::slider::{Nodes, Slider};
    /// use nalgebra::Vector3;
    ///
    /// let slider = Slider::new(Vector3::zeros(), Vector3::new(0.0, 4.0, 0.0))?;
    /// // Node n moves sideways by z: g1 = (2z − 4)/√(16 + z²).
    /// let motion = Nodes { x1: Vector3::zeros(), xn: Vector3::z(), xm: Vector3::zeros() };
    /// let g = slider.variations(Vector3::new(0.0, 2.0, 1.0), &motion)?;
    /// assert_eq!((g.value.g1, g.first.g1, g.second.g1), (-1.0, 0.5, 0.0625));
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// A position or motion that is not finite, or a derivative that overflows.
    pub fn variations(&self, xm: Vector3<f64>, motion: &Nodes<f64>) -> Result<Variations, Error> {
        let nodes = self.nodes(xm);
        value::<Constraint>(&nodes)?;
        for (name, motion) in [("motion.x1", motion.x1), ("motion.xn", motion.xn), ("motion.xm", motion.xm)] {
            Error::check_vector(name, motion)?;
        }
        let along = |x: f64, speed: f64| Dual2_64::new(x, speed, 0.0);
        let Distances { g1, g2 } = Constraint::eval(&Nodes {
            x1: nodes.x1.zip_map(&motion.x1, along),
            xn: nodes.xn.zip_map(&motion.xn, along),
            xm: nodes.xm.zip_map(&motion.xm, along),
        });
        for (name, g) in [("g1", g1), ("g2", g2)] {
            if !(g.v1.is_finite() && g.v2.is_finite()) {
                return Err(Error::DerivativeOverflow { name });
            }
        }
        Ok(Variations {
            value: Distances { g1: g1.re, g2: g2.re },
            first: Distances { g1: g1.v1, g2: g2.v1 },
            second: Distances { g1: g1.v2, g2: g2.v2 },
        })
    }

    /// Two coordinates of m from the kept one ([`Eliminate`]).
    ///
    /// # Errors
    /// A coordinate that is not finite, or so large that a result overflows.
    pub fn eliminate(&self, xmk: f64) -> Result<Coordinates<f64>, Error> {
        value::<Eliminate>(&KeptCoordinate { x1: self.x1, xn: self.xn, xmk })
    }

    /// Moves m onto the line: keeps its coordinate k and replaces the other two.
    ///
    /// # Errors
    /// As [`Slider::eliminate`].
    pub fn place(&self, xm: Vector3<f64>) -> Result<Vector3<f64>, Error> {
        Error::check_vector("xm", xm)?;
        let Pivots { i, j, k } = self.pivots();
        let Coordinates { xmi, xmj } = self.eliminate(xm[k])?;
        Ok(placed([(i, xmi), (j, xmj), (k, xm[k])]))
    }

    /// The increment of m from the increments of nodes 1 and n and the kept increment of m ([`Increment`]).
    ///
    /// ```
    /// use jointproof::connector::slider::Slider;
    /// use nalgebra::Vector3;
    ///
    /// let slider = Slider::new(Vector3::zeros(), Vector3::new(2.0, 1.0, 4.0))?;
    /// let middle = Vector3::new(1.0, 0.5, 2.0);
    /// // m in the middle follows half of node n, and keeps its z.
    /// let dxm = slider.increment(middle, Vector3::zeros(), Vector3::new(0.5, 1.0, 0.0), 0.0)?;
    /// assert_eq!(dxm, Vector3::new(0.25, 0.5, 0.0));
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// An increment or position that is not finite, or so large that a result overflows.
    pub fn increment(
        &self,
        xm: Vector3<f64>,
        dx1: Vector3<f64>,
        dxn: Vector3<f64>,
        dxmk: f64,
    ) -> Result<Vector3<f64>, Error> {
        let Self { x1, xn } = *self;
        let Pivots { i, j, k } = self.pivots();
        let Increments { dxmi, dxmj } = value::<Increment>(&KeptIncrement { x1, xn, xm, dx1, dxn, dxmk })?;
        Ok(placed([(i, dxmi), (j, dxmj), (k, dxmk)]))
    }

    /// The eliminated increments as a linear function of the others.
    ///
    /// # Errors
    /// A position that is not finite, or a line so short that a coefficient overflows.
    pub fn coefficients(&self, xm: Vector3<f64>) -> Result<Coefficients, Error> {
        let Self { x1, xn } = *self;
        let inputs = KeptIncrement { x1, xn, xm, ..KeptIncrement::filled(0.0) };
        let (_, Increments { dxmi, dxmj }) = value_and_jacobian::<Increment>(&inputs)?;
        Ok(Coefficients {
            pivots: self.pivots(),
            x1: Matrix2x3::from_rows(&[dxmi.dx1.transpose(), dxmj.dx1.transpose()]),
            xn: Matrix2x3::from_rows(&[dxmi.dxn.transpose(), dxmj.dxn.transpose()]),
            xmk: Vector2::new(dxmi.dxmk, dxmj.dxmk),
        })
    }

    /// The same as two linear equations, ready to be written as `*EQUATION`: the first term of each is eliminated, the second is
    /// kept.
    ///
    /// ```
    /// use jointproof::connector::slider::{LineNode, Slider, Term};
    /// use nalgebra::Vector3;
    ///
    /// let slider = Slider::new(Vector3::zeros(), Vector3::new(2.0, 1.0, 4.0))?;
    /// let [first, second] = slider.equations(Vector3::new(1.0, 0.5, 2.0))?; // y and x of m follow from its z
    /// assert_eq!(first.terms()[0], Term { node: LineNode::M, axis: 1, coefficient: 1.0 });
    /// assert_eq!(first.terms()[1], Term { node: LineNode::M, axis: 2, coefficient: -0.25 });
    /// assert_eq!(second.terms()[0], Term { node: LineNode::M, axis: 0, coefficient: 1.0 });
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Slider::coefficients`].
    pub fn equations(&self, xm: Vector3<f64>) -> Result<[LinearEquation; 2], Error> {
        Ok(self.coefficients(xm)?.equations())
    }

    fn nodes(&self, xm: Vector3<f64>) -> Nodes<f64> {
        Nodes { x1: self.x1, xn: self.xn, xm }
    }

    /// The contribution to a step of Newton's method, with m at this position.
    ///
    /// # Errors
    /// As [`Parameters::newton`].
    pub fn newton(&self, xm: Vector3<f64>, multipliers: &Vector2<f64>) -> Result<Contribution<f64, 2, 9>, Error> {
        let (nodes, nothing) = (Nodes { x1: self.x1, xn: self.xn, xm }, Nothing::new());
        let element = Parameters::<SliderElement, f64, 2, 9> { start: nothing, contact: None };
        element.newton(&nodes, multipliers, &nothing).map(|(found, _)| found)
    }
}

/// A vector from its components by axis.
pub(super) fn placed<const N: usize>(components: [(usize, f64); N]) -> SVector<f64, N> {
    let mut v = SVector::zeros();
    for (axis, x) in components {
        v[axis] = x;
    }
    v
}
