//! The two conditions that hold node m on the line, and the resulting conditions on increments.

#[cfg(feature = "verify")]
mod proof;

use super::across::{self, Across, AcrossLine};
use super::basis::Basis;
use super::line::Line;
use super::span::{Span, Station};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    SLIDER_DX1, SLIDER_DXM, SLIDER_DXN, SLIDER_G1, SLIDER_G2, SLIDER_R1, SLIDER_R2, SLIDER_X1, SLIDER_XM, SLIDER_XN,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The line, and node m.
    pub struct Nodes<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM }
}
fields! {
    /// The distances of m from the line.
    pub struct Distances<T> { g1: T = SLIDER_G1, g2: T = SLIDER_G2 }
}

/// The two conditions that hold m on the line: g1 = (xm − x1)·t1 = 0, g2 = (xm − x1)·t2 = 0.
///
/// Any point of the line may replace x1; the nearer of nodes 1 and n is used.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

/// The position of node m relative to both directions normal to the line.
struct View<D> {
    across: Across<D>,
    /// The position along the line.
    station: Station<D, 3>,
    /// The position along the projection of the line that t1 depends on.
    projected: Station<D, 2>,
}

impl<D: Scalar> View<D> {
    #[inline(always)]
    fn new(i: &Nodes<D>) -> Self {
        let across = Across::new(&(i.xn - i.x1));
        let project = |v: &Vector3<D>| across.split(v).1;
        let projected = Station::new(&across.projected, &project(&i.x1), &project(&i.xn), &project(&i.xm));
        Self { across, station: Station::new(&Span::new(&i.x1, &i.xn), &i.x1, &i.xn, &i.xm), projected }
    }

    /// g1 times the length of the first ray.
    #[inline]
    fn sideward(&self) -> D {
        self.projected.offset.perp(&self.across.projected.d)
    }

    #[inline]
    fn distances(&self) -> Distances<D> {
        let ([_, along_2], [root_1, root_2]) = (self.across.along_rays(&self.station.offset), self.across.roots);
        Distances { g1: self.sideward() / root_1, g2: along_2 / root_2 }
    }

    /// With d = xn − x1, ∂g1/∂d = −ξ′ t1, where ξ′ is the fraction of m along the projection that t1 depends on, and ∂g2/∂d = −ξ
    /// t2 + (n·i) g1/|i × d| t1: t2 rotates with the line, and with t1 about i.
    #[inline]
    fn gradients(&self) -> Distances<Nodes<D>> {
        let ([ray_1, ray_2], [root_1, root_2]) = (self.across.rays(), self.across.roots);
        let (per_1, per_2) = (root_1.recip(), root_2.recip());
        let (t1, t2, turn) = (ray_1 * per_1, ray_2 * per_2, self.across.twist(self.sideward()) * per_2);
        let ([share, rest], [share_1, rest_1]) = (self.station.shares(), self.projected.shares());
        Distances {
            g1: Nodes { x1: t1 * -rest_1, xn: t1 * -share_1, xm: t1 },
            g2: Nodes { x1: -turn - t2 * rest, xn: turn - t2 * share, xm: t2 },
        }
    }
}

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "slider.constraint",
        "Constraint",
        Document::SLIDER.reconstructed(
            "",
            "every symbol was lost; the words: the line from node 1 to m is perpendicular to both normals",
        ),
    )
    .equation(r"g_q = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}_q,\quad q = 1, 2")
    .given(&[Given::new(r"\mathbf{t}_1,\ \mathbf{t}_2", &Basis::SPEC), Given::new(r"\mathbf{n}", &Line::SPEC)])
    // An entry of ∂g2 is the sum of the effects of a rotation about i and of one normal to it; where they cancel, their rounding
    // errors remain in the sum.
    // The largest η that `audit --attack` found is 2.15 for the value, and 5.49 is possible to first order; for the Jacobian 3.12 and 10.4.
    .eta(4.0, 24.0)
    .normwise(8.0, 12.0)
    .apart(1e-9)
    .scale(1e250)
    .finite(Finite::Between)
    .not_objective();
    type Inputs<T: Component> = Nodes<T>;
    type Outputs<T: Component> = Distances<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Nodes<D>) -> Distances<D> {
        View::new(i).distances()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Nodes<D>) -> Jacobian<Self, D> {
        View::new(i).gradients()
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Nodes<D>) -> ValueAndJacobian<Self, D> {
        let view = View::new(i);
        (view.distances(), view.gradients())
    }

    #[inline]
    fn validate<D: Scalar>(i: &Nodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line and node m, and increments of all three nodes.
    pub struct MovingNodes<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN, dxm: Vector3<T> = SLIDER_DXM,
    }
}
fields! {
    /// The residuals of the two conditions for increments.
    pub struct IncrementalResiduals<T> { r1: T = SLIDER_R1, r2: T = SLIDER_R2 }
}

/// The two conditions on increments, with the variations of t1 and t2 eliminated:
/// r_q = t_q·(dxm − (1−ξ) dx1 − ξ dxn) = 0, ξ = (xm − x1)·n/l.
#[derive(Clone, Copy, Debug)]
pub struct IncrementalConstraint;

impl AcrossLine for IncrementalConstraint {
    #[inline(always)]
    fn line<D: Scalar>(i: &MovingNodes<D>) -> Vector3<D> {
        i.xn - i.x1
    }

    #[inline(always)]
    fn value<D: Scalar>(i: &MovingNodes<D>, across: &Across<D>) -> IncrementalResiduals<D> {
        let station = Station::new(&Span::new(&i.x1, &i.xn), &i.x1, &i.xn, &i.xm);
        let ([along_1, along_2], [root_1, root_2]) =
            (across.along_rays(&(i.dxm - station.blend(&i.dx1, &i.dxn))), across.roots);
        IncrementalResiduals { r1: along_1 / root_1, r2: along_2 / root_2 }
    }

    /// With v = dxm − (1−ξ) dx1 − ξ dxn and γ_q = t_q·(dxn − dx1), the line enters through t_q, whose variation is that in
    /// [`Constraint`] with v for xm − x1, and through ξ: ∂r_q = v·∂t_q − γ_q ∂ξ.
    #[inline(always)]
    fn gradients<D: Scalar>(i: &MovingNodes<D>, across: &Across<D>) -> Jacobian<Self, D> {
        let span = Span::new(&i.x1, &i.xn);
        let station = Station::new(&span, &i.x1, &i.xn, &i.xm);
        let ([share, rest], [share_x1, share_xn, share_xm]) = (station.shares(), station.gradients(&span));
        let v = i.dxm - station.blend(&i.dx1, &i.dxn);
        let share_v = v.dot(&span.d) * span.factor();
        // All terms are multiplied by the length of the ray; the rows are divided by it at the end.
        let (ray, gain) = (across.rays(), across.along_rays(&(i.dxn - i.dx1)));
        let twist = across.twist(across.split(&v).1.perp(&across.projected.d));
        let turning = [ray[0] * -across.share_outward(&v), twist - ray[1] * share_v];
        let row = |q: usize| {
            let per = across.roots[q].recip();
            let t = ray[q] * per;
            MovingNodes {
                x1: -(turning[q] + share_x1 * gain[q]) * per,
                xn: (turning[q] - share_xn * gain[q]) * per,
                xm: share_xm * -(gain[q] * per),
                dx1: t * -rest,
                dxn: t * -share,
                dxm: t,
            }
        };
        IncrementalResiduals { r1: row(0), r2: row(1) }
    }
}

impl Formula for IncrementalConstraint {
    const SPEC: Spec = Spec::new(
        "slider.incremental_constraint",
        "Incremental constraint",
        Document::SLIDER.reconstructed(
            "",
            "every symbol was lost; the words: the derivatives of the constraints, reduced",
        ),
    )
        .equation(r"r_q = \mathbf{t}_q\cdot\bigl(\mathrm{d}\mathbf{x}_m - (1-\xi)\,\mathrm{d}\mathbf{x}_1 - \xi\,\mathrm{d}\mathbf{x}_n\bigr),\quad \xi = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{n}/l,\quad q = 1, 2")
.given(&[Given::new(r"\mathbf{t}_1,\ \mathbf{t}_2", &Basis::SPEC), Given::new(r"\mathbf{n},\ l", &Line::SPEC)])
        // The largest η that `audit --attack` found is 1.64 for the value, and 6.67 is possible to first order; for the Jacobian 3.5
        // and 10.7.
        .eta(4.0, 16.0)
        .normwise(8.0, 14.0)
        .scale(1e50)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = MovingNodes<T>;
    type Outputs<T: Component> = IncrementalResiduals<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &MovingNodes<D>) -> IncrementalResiduals<D> {
        across::value::<Self, D>(i)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &MovingNodes<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &MovingNodes<D>) -> ValueAndJacobian<Self, D> {
        across::linearized::<Self, D>(i)
    }

    #[inline]
    fn validate<D: Scalar>(i: &MovingNodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
