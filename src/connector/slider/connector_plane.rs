//! The slider in the plane as a program uses it: a line checked once, then evaluated by the formulas.

use super::connector::placed;
use super::{
    Constraint2d, Distance2d, Eliminate2d, Increment2d, IncrementalConstraint2d, KeptCoordinate2d, KeptIncrement2d,
    LinearEquation, MovingNodes2d, Nodes2d, Pivots2d, SliderElement2d,
};
use crate::element::{Contribution, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::{Fields, Jacobian, value, value_and_jacobian};
use crate::number::scalar::norm;
use nalgebra::{SMatrix, Vector1, Vector2};

/// The line in the plane through nodes 1 and n, on which node m slides.
///
/// ```
/// use jointproof::connector::slider::{Pivots2d, Slider2d};
/// use nalgebra::Vector2;
///
/// let slider = Slider2d::new(Vector2::zeros(), Vector2::new(4.0, 2.0))?;
/// assert_eq!(slider.pivots(), Pivots2d { i: 1, k: 0 }); // y follows from x
/// assert_eq!(slider.eliminate(3.0)?, 1.5);
/// assert_eq!(slider.place(Vector2::new(2.0, 7.0))?, Vector2::new(2.0, 1.0));
/// assert_eq!(slider.constraint(Vector2::new(6.0, 3.0))?.g, 0.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider2d {
    x1: Vector2<f64>,
    xn: Vector2<f64>,
}

/// The coefficients of an eliminated node for a finite-element code, in the plane: δxm_i as a linear function of δx1, δxn and
/// δxm_k.
///
/// ```
/// use jointproof::connector::slider::Slider2d;
/// use nalgebra::{Matrix1x5, Vector2};
///
/// let slider = Slider2d::new(Vector2::zeros(), Vector2::new(4.0, 2.0))?;
/// let c = slider.coefficients(Vector2::new(2.0, 1.0))?; // m in the middle; y follows from x
/// assert_eq!(c.matrix(), Matrix1x5::new(-0.25, 0.5, -0.25, 0.5, 0.5));
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients2d {
    /// The eliminated axis i and the kept axis k.
    pub pivots: Pivots2d,
    /// Coefficients of δx1.
    pub x1: Vector2<f64>,
    /// Coefficients of δxn.
    pub xn: Vector2<f64>,
    /// Coefficient of δxm_k.
    pub xmk: f64,
}

impl Coefficients2d {
    /// All coefficients: columns δx1 (2), δxn (2), δxm_k.
    pub fn matrix(&self) -> SMatrix<f64, 1, 5> {
        SMatrix::from([[self.x1.x], [self.x1.y], [self.xn.x], [self.xn.y], [self.xmk]])
    }

    /// The equation of the coordinate i of node m.
    pub fn equation(&self) -> LinearEquation {
        let Self { pivots, x1, xn, xmk } = self;
        LinearEquation::new(pivots.i, (pivots.k, *xmk), x1.iter(), xn.iter())
    }
}

impl Slider2d {
    /// The line through two nodes.
    ///
    /// # Errors
    /// A position that is not finite, or nodes that coincide.
    pub fn new(x1: Vector2<f64>, xn: Vector2<f64>) -> Result<Self, Error> {
        Error::check_vector("x1", x1)?;
        Error::check_vector("xn", xn)?;
        Error::check_apart(("x1", x1), ("xn", xn))?;
        finite("l", norm((xn - x1).into()))?;
        Ok(Self { x1, xn })
    }

    /// Which coordinate of m is eliminated, and which is kept.
    pub fn pivots(&self) -> Pivots2d {
        Pivots2d::new(&self.x1, &self.xn)
    }

    /// The distance of m from the line ([`Constraint2d`]).
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn constraint(&self, xm: Vector2<f64>) -> Result<Distance2d<f64>, Error> {
        value::<Constraint2d>(&Nodes2d { x1: self.x1, xn: self.xn, xm })
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn constraint_jacobian(
        &self,
        xm: Vector2<f64>,
    ) -> Result<(Distance2d<f64>, Jacobian<Constraint2d, f64>), Error> {
        value_and_jacobian::<Constraint2d>(&Nodes2d { x1: self.x1, xn: self.xn, xm })
    }

    /// The eliminated coordinate of m from the kept one ([`Eliminate2d`]).
    ///
    /// # Errors
    /// A coordinate that is not finite, or so large that the result overflows.
    pub fn eliminate(&self, xmk: f64) -> Result<f64, Error> {
        Ok(value::<Eliminate2d>(&KeptCoordinate2d { x1: self.x1, xn: self.xn, xmk })?.xmi)
    }

    /// Moves m onto the line: keeps its coordinate k and replaces the other.
    ///
    /// # Errors
    /// As [`Slider2d::eliminate`].
    pub fn place(&self, xm: Vector2<f64>) -> Result<Vector2<f64>, Error> {
        Error::check_vector("xm", xm)?;
        let Pivots2d { i, k } = self.pivots();
        Ok(placed([(i, self.eliminate(xm[k])?), (k, xm[k])]))
    }

    /// The residual of the condition for increments of all three nodes ([`IncrementalConstraint2d`]).
    ///
    /// ```
    /// use jointproof::connector::slider::Slider2d;
    /// use nalgebra::Vector2;
    ///
    /// let slider = Slider2d::new(Vector2::zeros(), Vector2::new(4.0, 3.0))?;
    /// let (xm, up) = (Vector2::new(2.0, 1.5), Vector2::new(0.0, 1.0));
    /// // m in the middle follows half of node n, and does not.
    /// assert_eq!(slider.incremental_constraint(xm, Vector2::zeros(), up, up / 2.0)?, 0.0);
    /// assert_eq!(slider.incremental_constraint(xm, Vector2::zeros(), up, Vector2::zeros())?, -0.4);
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// An increment or position that is not finite, or so large that the result overflows.
    pub fn incremental_constraint(
        &self,
        xm: Vector2<f64>,
        dx1: Vector2<f64>,
        dxn: Vector2<f64>,
        dxm: Vector2<f64>,
    ) -> Result<f64, Error> {
        let Self { x1, xn } = *self;
        Ok(value::<IncrementalConstraint2d>(&MovingNodes2d { x1, xn, xm, dx1, dxn, dxm })?.r)
    }

    /// The increment of m from the increments of nodes 1 and n and the kept increment of m ([`Increment2d`]).
    ///
    /// # Errors
    /// An increment or position that is not finite, or so large that a result overflows.
    pub fn increment(
        &self,
        xm: Vector2<f64>,
        dx1: Vector2<f64>,
        dxn: Vector2<f64>,
        dxmk: f64,
    ) -> Result<Vector2<f64>, Error> {
        let Self { x1, xn } = *self;
        let Pivots2d { i, k } = self.pivots();
        let dxmi = value::<Increment2d>(&KeptIncrement2d { x1, xn, xm, dx1, dxn, dxmk })?.dxmi;
        Ok(placed([(i, dxmi), (k, dxmk)]))
    }

    /// The eliminated increment as a linear function of the others.
    ///
    /// # Errors
    /// A position that is not finite, or a line so short that a coefficient overflows.
    pub fn coefficients(&self, xm: Vector2<f64>) -> Result<Coefficients2d, Error> {
        let Self { x1, xn } = *self;
        let inputs = KeptIncrement2d { x1, xn, xm, ..KeptIncrement2d::filled(0.0) };
        let KeptIncrement2d { dx1, dxn, dxmk, .. } = value_and_jacobian::<Increment2d>(&inputs)?.1.dxmi;
        Ok(Coefficients2d { pivots: self.pivots(), x1: dx1, xn: dxn, xmk: dxmk })
    }

    /// The same as a linear equation, ready to be written as `*EQUATION`: the first term is eliminated, the second is kept.
    ///
    /// # Errors
    /// As [`Slider2d::coefficients`].
    pub fn equation(&self, xm: Vector2<f64>) -> Result<LinearEquation, Error> {
        Ok(self.coefficients(xm)?.equation())
    }

    /// The contribution to a step of Newton's method, with m at this position.
    ///
    /// # Errors
    /// As [`Parameters::newton`].
    pub fn newton(&self, xm: Vector2<f64>, multipliers: &Vector1<f64>) -> Result<Contribution<f64, 1, 6>, Error> {
        let (nodes, nothing) = (Nodes2d { x1: self.x1, xn: self.xn, xm }, Nothing::new());
        let element = Parameters::<SliderElement2d, f64, 1, 6> { start: nothing, contact: None };
        element.newton(&nodes, multipliers, &nothing).map(|(found, _)| found)
    }
}

fn finite(name: &'static str, x: f64) -> Result<f64, Error> {
    if x.is_finite() { Ok(x) } else { Err(Error::Overflow { name }) }
}
