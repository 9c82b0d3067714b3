//! SLIDER in the plane, (x, y) or (r, z), as an element: one residual, over the translations of nodes 1, n and m.
//!
//! As in [space](super::rows), rows and forces are those of m on the line. In the plane t rotates with the line only, so that
//! the stiffness has a single term. The coordinates r and z of an axisymmetric model are treated in the same way; the force is
//! then that on the whole circumference.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and shares what both have of the line")]

#[cfg(feature = "verify")]
mod proof;

use super::along::{Along, Loaded, LoadsGradient};
use super::rows::placed;
use crate::connector::slider::{IncrementalConstraint, Line, Nodes2d};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    FORCE_1_PLANE, FORCE_M_PLANE, FORCE_N_PLANE, K_U1_U1_PLANE, K_U1_UN_PLANE, K_UM_UN_PLANE, K_UN_UN_PLANE,
    SLIDER_G_U1_PLANE, SLIDER_G_UM_PLANE, SLIDER_G_UN_PLANE, SLIDER_LAMBDA, SLIDER_X1_PLANE, SLIDER_XM_PLANE,
    SLIDER_XN_PLANE,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::{Matrix2, Matrix6, Vector2, Vector6};

/// The source of these formulas.
const OURS: Source = Document::SLIDER.ours("", "the page has the constraint and its increment, without a multiplier");

/// The symbols of rows and forces that are defined elsewhere.
const GIVEN: [Given; 2] = [Given::new(r"\mathbf{n}", &Line::SPEC), Given::new(r"\xi", &IncrementalConstraint::SPEC)];

fields! {
    /// The derivatives of the residual with respect to the translations of the three nodes.
    pub struct SliderRow2d<T> {
        g_u1: Vector2<T> = SLIDER_G_U1_PLANE, g_un: Vector2<T> = SLIDER_G_UN_PLANE,
        g_um: Vector2<T> = SLIDER_G_UM_PLANE,
    }
}

/// The line, with the quantities that the derivatives need.
struct View<D> {
    along: Along<D, 2>,
    n: Vector2<D>,
    t: Vector2<D>,
    l: D,
    /// ∂t/∂d = −n ⊗ t/l.
    turning: Matrix2<D>,
}

impl<D: Scalar> View<D> {
    #[inline(always)]
    fn new(x1: &Vector2<D>, xn: &Vector2<D>, xm: &Vector2<D>) -> Self {
        let (l, [c, s]) = norm_and_direction((xn - x1).into());
        let (n, t) = (Vector2::new(c, s), Vector2::new(-s, c));
        Self { along: Along::new(x1, xn, xm), n, t, l, turning: n * t.transpose() * -l.recip() }
    }

    /// The k-th component of the force on m.
    #[inline(always)]
    fn loaded(&self, multiplier: D, k: usize) -> Loaded<D, 2, 1> {
        Loaded::new([multiplier], [self.t[k]], [self.turning.row(k).transpose()])
    }
}

/// The row of SLIDER in the plane: −(1 − ξ) t, −ξ t and t.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new("slider.rows_2d", "Row of SLIDER in the plane", OURS)
        .equation(r"\mathbf{g}_{u1} = -(1-\xi)\,\mathbf{t},\quad \mathbf{g}_{un} = -\xi\,\mathbf{t},\quad \mathbf{g}_{um} = \mathbf{t},\quad \mathbf{t} = \mathbf{s}\times\mathbf{n}")
        .given(&GIVEN)
        // The largest η that `audit --attack` found is 4.14 for the value, and 11.5 is possible to first order.
        .eta_of_value(10.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Nodes2d<T>;
    type Outputs<T: Component> = SliderRow2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Nodes2d<D>) -> SliderRow2d<D> {
        let View { along, t, .. } = View::new(&i.x1, &i.xn, &i.xm);
        let [on_1, on_n] = along.lever().map(|weight| weight.value);
        SliderRow2d { g_u1: t * on_1, g_un: t * on_n, g_um: t }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Nodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line in the plane, node m, and the multiplier, which is the force on m along t.
    pub struct SliderLoads2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        lambda: T = SLIDER_LAMBDA,
    }
}
fields! {
    /// The forces of SLIDER on its nodes in the plane.
    pub struct SliderForces2d<T> {
        force_1: Vector2<T> = FORCE_1_PLANE, force_n: Vector2<T> = FORCE_N_PLANE, force_m: Vector2<T> = FORCE_M_PLANE,
    }
}

impl<D: Scalar> From<LoadsGradient<D, 2, 1>> for SliderLoads2d<D> {
    #[inline(always)]
    fn from(([x1, xn, xm], [lambda]): LoadsGradient<D, 2, 1>) -> Self {
        Self { x1, xn, xm, lambda }
    }
}

impl<D: Scalar> SliderLoads2d<D> {
    #[inline(always)]
    fn view(&self) -> View<D> {
        View::new(&self.x1, &self.xn, &self.xm)
    }
}

/// The forces of SLIDER on its nodes in the plane, the multiplier times the row: on m the force normal to the line, on nodes 1
/// and n its opposite by the lever rule.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new("slider.nodal_forces_2d", "Nodal forces of SLIDER in the plane", OURS)
        .equation(r"\mathbf{f}_m = \lambda\,\mathbf{t},\quad \mathbf{f}_1 = -(1-\xi)\,\mathbf{f}_m,\quad \mathbf{f}_n = -\xi\,\mathbf{f}_m,\quad \mathbf{t} = \mathbf{s}\times\mathbf{n}")
        .given(&GIVEN)
        // The largest η that `audit --attack` found is 2.13 for the value, and 5.54 is possible to first order; for the Jacobian 8.48
        // and 23.
        .eta(6.0, 23.0)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = SliderLoads2d<T>;
    type Outputs<T: Component> = SliderForces2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SliderLoads2d<D>) -> SliderForces2d<D> {
        Self::linearized(i).0
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SliderLoads2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &SliderLoads2d<D>) -> ValueAndJacobian<Self, D> {
        let view = i.view();
        let (force, along) = (Vector2::new(view.loaded(i.lambda, 0), view.loaded(i.lambda, 1)), &view.along);
        let [on_1, on_n] = along.lever();
        let gradients = SliderForces2d {
            force_1: force.map(|part| part.weighted(along, on_1).into()),
            force_n: force.map(|part| part.weighted(along, on_n).into()),
            force_m: force.map(|part| part.turned().into()),
        };
        let [by_1, by_n] = [on_1, on_n].map(|weight| weight.value * i.lambda);
        (SliderForces2d { force_1: view.t * by_1, force_n: view.t * by_n, force_m: view.t * i.lambda }, gradients)
    }

    #[inline]
    fn validate<D: Scalar>(i: &SliderLoads2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The derivatives of SLIDER's nodal forces in the plane with respect to the translations, with the multiplier held: the
    /// distinct blocks.
    ///
    /// [`matrix`](SliderStiffness2d::matrix) assembles the whole matrix.
    pub struct SliderStiffness2d<T> {
        k_u1_u1: Matrix2<T> = K_U1_U1_PLANE, k_u1_un: Matrix2<T> = K_U1_UN_PLANE,
        k_un_un: Matrix2<T> = K_UN_UN_PLANE, k_um_un: Matrix2<T> = K_UM_UN_PLANE,
    }
}

/// The geometric stiffness of SLIDER in the plane, λ ∂²g with respect to translations, on the line: symmetric.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new("slider.geometric_stiffness_2d", "Geometric stiffness of SLIDER in the plane", OURS)
        .equation(r"\begin{aligned} \mathbf{P} &= -\frac{\lambda}{l}\,\mathbf{n}\otimes\mathbf{t},\quad \mathbf{Q} = -\frac{\lambda}{l}\,\mathbf{t}\otimes\mathbf{n},\quad \mathbf{t} = \mathbf{s}\times\mathbf{n}, \\ \mathbf{K}_{um,un} &= \mathbf{P},\quad \mathbf{K}_{u1,un} = \xi\,\mathbf{Q} - (1-\xi)\,\mathbf{P},\quad \mathbf{K}_{u1,u1} = (1-\xi)(\mathbf{P}+\mathbf{Q}),\quad \mathbf{K}_{un,un} = -\xi\,(\mathbf{P}+\mathbf{Q}) \end{aligned}")
        .given(&[Given::new(r"\mathbf{n},\ l", &Line::SPEC), Given::new(r"\xi", &IncrementalConstraint::SPEC)])
        // The largest η that `audit --attack` found is 6.38 for the value, and 12.6 is possible to first order.
        .eta_of_value(14.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = SliderLoads2d<T>;
    type Outputs<T: Component> = SliderStiffness2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SliderLoads2d<D>) -> SliderStiffness2d<D> {
        let view = i.view();
        // The components of n are small in products with large multipliers: in this order nothing underflows before the result.
        let p = view.n * -(i.lambda / view.l) * view.t.transpose();
        let (q, both) = (p.transpose(), p + p.transpose());
        let [rest, share] = [view.along.rest(1.0), view.along.share(1.0)].map(|weight| weight.value);
        SliderStiffness2d { k_u1_u1: both * rest, k_u1_un: q * share - p * rest, k_un_un: both * -share, k_um_un: p }
    }

    #[inline]
    fn validate<D: Scalar>(i: &SliderLoads2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

impl<D: Scalar> SliderRow2d<D> {
    /// The row in the order of the translations of nodes 1, n and m.
    pub fn vector(&self) -> Vector6<D> {
        in_order([self.g_u1, self.g_un, self.g_um])
    }
}

impl<D: Scalar> SliderForces2d<D> {
    /// The forces in the order of the translations of nodes 1, n and m.
    pub fn vector(&self) -> Vector6<D> {
        in_order([self.force_1, self.force_n, self.force_m])
    }
}

fn in_order<D: Scalar>(parts: [Vector2<D>; 3]) -> Vector6<D> {
    Vector6::from_fn(|k, _| parts[k / 2][k % 2])
}

impl<D: Scalar> SliderStiffness2d<D> {
    /// The assembled matrix for the translations of nodes 1, n and m.
    pub fn matrix(&self) -> Matrix6<D> {
        placed([self.k_u1_u1, self.k_u1_un, self.k_un_un, self.k_um_un])
    }
}
