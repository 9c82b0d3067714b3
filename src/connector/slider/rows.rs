//! SLIDER as an element: two residuals, over the nine translations of nodes 1, n and m, in this order.
//!
//! Rows and forces are those of m on the line: node m takes the force f = λ1 t1 + λ2 t2, nodes 1 and n its opposite, divided by
//! the lever rule into 1 − ξ and ξ. Off the line, by the residual that Newton's method has not yet closed, the residuals have
//! other derivatives; the neglected terms vanish with the residuals. Convergence is quadratic with the Jacobian of [`Forces`] as
//! the matrix; with the stiffness below, which is exact on the line only, two steps square the error.
//!
//! The stiffness is Σ λ ∂²g of the residuals on the line. With d = x_n − x_1 and P = ∂f/∂d its blocks are multiples of P and
//! Pᵀ, and it is symmetric, since there are no spins.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and shares what both have of the line")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::along::{Along, Loaded, LoadsGradient};
use crate::connector::slider::{Axis, Basis, IncrementalConstraint, Line, Nodes};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    FORCE_1, FORCE_M, FORCE_N, K_U1_U1, K_U1_UN, K_UM_UN, K_UN_UN, SLIDER_G1_U1, SLIDER_G1_UM, SLIDER_G1_UN,
    SLIDER_G2_U1, SLIDER_G2_UM, SLIDER_G2_UN, SLIDER_LAMBDA1, SLIDER_LAMBDA2, SLIDER_X1, SLIDER_XM, SLIDER_XN,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// The source of these formulas.
const OURS: Source =
    Document::SLIDER.ours("", "the page has the constraints and their increments, without multipliers");

fields! {
    /// The derivatives of both residuals with respect to the translations of the three nodes.
    pub struct SliderRows<T> {
        g1_u1: Vector3<T> = SLIDER_G1_U1, g1_un: Vector3<T> = SLIDER_G1_UN, g1_um: Vector3<T> = SLIDER_G1_UM,
        g2_u1: Vector3<T> = SLIDER_G2_U1, g2_un: Vector3<T> = SLIDER_G2_UN, g2_um: Vector3<T> = SLIDER_G2_UM,
    }
}

/// The line, with the quantities that the derivatives need.
struct View<D> {
    along: Along<D, 3>,
    t: [Vector3<D>; 2],
    /// ∂t1/∂d and ∂t2/∂d.
    turning: [Matrix3<D>; 2],
}

impl<D: Scalar> View<D> {
    #[inline(always)]
    fn new(x1: &Vector3<D>, xn: &Vector3<D>, xm: &Vector3<D>) -> Self {
        let (d, zero) = (xn - x1, D::zero());
        let axis = Axis::of(&d);
        // From the parts of d along e and normal to it, so that no derivative is a difference of nearly equal terms.
        let (upright, across) = axis.split(&d);
        let (far, [a, b]) = norm_and_direction(across.into());
        let (l, [tilt, lean]) = norm_and_direction([far, upright]);
        let (n, outward) = (axis.vector(lean, tilt * a, tilt * b), axis.vector(zero, a, b));
        let (t1, t2) = (axis.vector(zero, b, -a), axis.vector(-tilt, lean * a, lean * b));
        let (per_length, per_outward) = (l.recip(), far.recip());
        // With the axis e: ∂t1/∂d = −(e × t1) ⊗ t1/(l |n × e|) and ∂t2/∂d = (n·e t1 ⊗ t1/|n × e| − n ⊗ t2)/l.
        let along_t1 = t1.transpose() * per_outward;
        let turning = [-outward * along_t1, t1 * along_t1 * lean - n * t2.transpose() * per_length];
        Self { along: Along::new(x1, xn, xm), t: [t1, t2], turning }
    }

    #[inline(always)]
    fn rows(&self) -> SliderRows<D> {
        let ([t1, t2], [on_1, on_n]) = (self.t, self.along.lever().map(|weight| weight.value));
        SliderRows { g1_u1: t1 * on_1, g1_un: t1 * on_n, g1_um: t1, g2_u1: t2 * on_1, g2_un: t2 * on_n, g2_um: t2 }
    }

    /// The k-th component of the force on m.
    #[inline(always)]
    fn loaded(&self, multipliers: [D; 2], k: usize) -> Loaded<D, 3, 2> {
        let ([t1, t2], [by_d1, by_d2]) = (&self.t, &self.turning);
        Loaded::new(multipliers, [t1[k], t2[k]], [by_d1.row(k).transpose(), by_d2.row(k).transpose()])
    }
}

/// The rows of SLIDER: −(1 − ξ) t_q, −ξ t_q and t_q.
///
/// They are the coefficients of the nodes' increments in [`IncrementalConstraint`].
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new("slider.rows", "Rows of SLIDER", OURS)
        .equation(r"\mathbf{g}_{q,u1} = -(1-\xi)\,\mathbf{t}_q,\quad \mathbf{g}_{q,un} = -\xi\,\mathbf{t}_q,\quad \mathbf{g}_{q,um} = \mathbf{t}_q\quad (q = 1, 2)")
        .given(&[
            Given::new(r"\mathbf{t}_1,\ \mathbf{t}_2", &Basis::SPEC),
            Given::new(r"\mathbf{n}", &Line::SPEC),
            Given::new(r"\xi", &IncrementalConstraint::SPEC),
        ])
        // The terms of an entry are due to a rotation of the line and to a motion of m along it. Where the two cancel, and with
        // them their sensitivities to the inputs, their rounding errors remain: of 7 million entries 10 are above 128. Normwise
        // none is above 6.
        // The largest η that `audit --attack` found is 4.01 for the value, and 12 is possible to first order.
        .eta_of_value(6.0)
        .normwise_of_value(12.0)
        .apart(1e-9)
        .scale(1e250)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = Nodes<T>;
    type Outputs<T: Component> = SliderRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Nodes<D>) -> SliderRows<D> {
        View::new(&i.x1, &i.xn, &i.xm).rows()
    }

    #[inline]
    fn validate<D: Scalar>(i: &Nodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line, node m, and the multipliers, which are the forces on m along t1 and t2.
    pub struct SliderLoads<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM,
        lambda_1: T = SLIDER_LAMBDA1, lambda_2: T = SLIDER_LAMBDA2,
    }
}
fields! {
    /// The forces of SLIDER on its nodes.
    pub struct SliderForces<T> {
        force_1: Vector3<T> = FORCE_1, force_n: Vector3<T> = FORCE_N, force_m: Vector3<T> = FORCE_M,
    }
}

impl<D: Scalar> From<LoadsGradient<D, 3, 2>> for SliderLoads<D> {
    #[inline(always)]
    fn from(([x1, xn, xm], [lambda_1, lambda_2]): LoadsGradient<D, 3, 2>) -> Self {
        Self { x1, xn, xm, lambda_1, lambda_2 }
    }
}

impl<D: Scalar> SliderLoads<D> {
    #[inline(always)]
    fn view(&self) -> View<D> {
        View::new(&self.x1, &self.xn, &self.xm)
    }

    const fn multipliers(&self) -> [D; 2] {
        [self.lambda_1, self.lambda_2]
    }

    /// The force on m, and the forces on nodes 1 and n by the lever rule.
    #[inline(always)]
    fn forces(&self, view: &View<D>) -> SliderForces<D> {
        let force_m = view.t[0] * self.lambda_1 + view.t[1] * self.lambda_2;
        let [on_1, on_n] = view.along.lever().map(|weight| weight.value);
        SliderForces { force_1: force_m * on_1, force_n: force_m * on_n, force_m }
    }

    /// The blocks, from P = ∂f/∂d for the force f on m.
    #[inline(always)]
    fn stiffness(&self, view: &View<D>) -> SliderStiffness<D> {
        let [first, second] = view.turning;
        let p = first * self.lambda_1 + second * self.lambda_2;
        let (q, share, rest) = (p.transpose(), view.along.share, view.along.rest);
        SliderStiffness {
            k_u1_u1: (p + q) * rest,
            k_u1_un: q * share - p * rest,
            k_un_un: (p + q) * -share,
            k_um_un: p,
        }
    }
}

/// The forces of SLIDER on its nodes, Rowsᵀ λ: on m the force normal to the line, on nodes 1 and n its opposite by the lever
/// rule.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new("slider.nodal_forces", "Nodal forces of SLIDER", OURS)
        .equation(r"\mathbf{f}_m = \lambda_1\,\mathbf{t}_1 + \lambda_2\,\mathbf{t}_2,\quad \mathbf{f}_1 = -(1-\xi)\,\mathbf{f}_m,\quad \mathbf{f}_n = -\xi\,\mathbf{f}_m")
        .given(&[
            Given::new(r"\mathbf{t}_1,\ \mathbf{t}_2", &Basis::SPEC),
            Given::new(r"\mathbf{n}", &Line::SPEC),
            Given::new(r"\xi", &IncrementalConstraint::SPEC),
        ])
        // The largest η that `audit --attack` found is 1.8 for the value, and 5.33 is possible to first order; for the Jacobian 4.57
        // and 10.7.
        .eta(6.0, 16.0)
        .normwise(6.5, 14.0)
        .scale(1e80)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = SliderLoads<T>;
    type Outputs<T: Component> = SliderForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SliderLoads<D>) -> SliderForces<D> {
        i.forces(&i.view())
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SliderLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &SliderLoads<D>) -> ValueAndJacobian<Self, D> {
        let view = i.view();
        let (multipliers, along) = (i.multipliers(), &view.along);
        let force = Vector3::new(view.loaded(multipliers, 0), view.loaded(multipliers, 1), view.loaded(multipliers, 2));
        let [on_1, on_n] = along.lever();
        let gradients = SliderForces {
            force_1: force.map(|part| part.weighted(along, on_1).into()),
            force_n: force.map(|part| part.weighted(along, on_n).into()),
            force_m: force.map(|part| part.turned().into()),
        };
        (i.forces(&view), gradients)
    }

    #[inline]
    fn validate<D: Scalar>(i: &SliderLoads<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The derivatives of SLIDER's nodal forces with respect to the translations, with the multipliers held: the distinct blocks.
    ///
    /// [`matrix`](SliderStiffness::matrix) assembles the whole matrix.
    pub struct SliderStiffness<T> {
        k_u1_u1: Matrix3<T> = K_U1_U1, k_u1_un: Matrix3<T> = K_U1_UN, k_un_un: Matrix3<T> = K_UN_UN,
        k_um_un: Matrix3<T> = K_UM_UN,
    }
}

/// The geometric stiffness of SLIDER, Σ λ ∂²g with respect to translations, on the line: symmetric.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new("slider.geometric_stiffness", "Geometric stiffness of SLIDER", OURS)
        .equation(r"\begin{aligned} \mathbf{P} &= \frac{\lambda_2}{l}\Bigl(\frac{\mathbf{n}\cdot\mathbf{e}}{h}\,\mathbf{t}_1\otimes\mathbf{t}_1 - \mathbf{n}\otimes\mathbf{t}_2\Bigr) - \frac{\lambda_1}{l h}\,(\mathbf{e}\times\mathbf{t}_1)\otimes\mathbf{t}_1, \\ \mathbf{Q} &= \frac{\lambda_2}{l}\Bigl(\frac{\mathbf{n}\cdot\mathbf{e}}{h}\,\mathbf{t}_1\otimes\mathbf{t}_1 - \mathbf{t}_2\otimes\mathbf{n}\Bigr) - \frac{\lambda_1}{l h}\,\mathbf{t}_1\otimes(\mathbf{e}\times\mathbf{t}_1), \\ \mathbf{K}_{um,un} &= \mathbf{P},\quad \mathbf{K}_{u1,un} = \xi\,\mathbf{Q} - (1-\xi)\,\mathbf{P},\quad \mathbf{K}_{u1,u1} = (1-\xi)(\mathbf{P}+\mathbf{Q}),\quad \mathbf{K}_{un,un} = -\xi\,(\mathbf{P}+\mathbf{Q}), \\ h &= \lvert\mathbf{n}\times\mathbf{e}\rvert,\quad \mathbf{e} = \begin{cases} \mathbf{i} & \mathbf{n}\times\mathbf{i} \ne \mathbf{0} \\ \mathbf{k} & \text{otherwise} \end{cases} \end{aligned}")
        .given(&[
            Given::new(r"\mathbf{t}_1,\ \mathbf{t}_2", &Basis::SPEC),
            Given::new(r"\mathbf{n},\ l", &Line::SPEC),
            Given::new(r"\xi", &IncrementalConstraint::SPEC),
        ])
        // As for the rows.
        // The largest η that `audit --attack` found is 2.64 for the value, and 10.7 is possible to first order.
        .eta_of_value(8.0)
        .normwise_of_value(12.0)
        .scale(1e120)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = SliderLoads<T>;
    type Outputs<T: Component> = SliderStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SliderLoads<D>) -> SliderStiffness<D> {
        i.stiffness(&i.view())
    }

    #[inline]
    fn validate<D: Scalar>(i: &SliderLoads<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

/// The distinct blocks assembled for nodes 1, n and m: N rows and columns each, ALL together.
pub(super) fn placed<D: Scalar, const N: usize, const ALL: usize>(
    [k11, k1n, knn, kmn]: [SMatrix<D, N, N>; 4],
) -> SMatrix<D, ALL, ALL> {
    let rows = [[k11, k1n, -kmn.transpose()], [k1n.transpose(), knn, kmn.transpose()], [-kmn, kmn, SMatrix::zeros()]];
    SMatrix::from_fn(|row, column| rows[row / N][column / N][(row % N, column % N)])
}

impl<D: Scalar> SliderRows<D> {
    /// Both rows, over the translations of nodes 1, n and m.
    pub fn matrix(&self) -> SMatrix<D, 2, 9> {
        let Self { g1_u1, g1_un, g1_um, g2_u1, g2_un, g2_um } = *self;
        let parts = [[g1_u1, g1_un, g1_um], [g2_u1, g2_un, g2_um]];
        SMatrix::from_fn(|row, column| parts[row][column / 3][column % 3])
    }
}

impl<D: Scalar> SliderForces<D> {
    /// The forces in the order of the translations of nodes 1, n and m.
    pub fn vector(&self) -> SVector<D, 9> {
        let parts = [self.force_1, self.force_n, self.force_m];
        SVector::from_fn(|k, _| parts[k / 3][k % 3])
    }
}

impl<D: Scalar> SliderStiffness<D> {
    /// The assembled matrix for the translations of nodes 1, n and m.
    ///
    /// ```
    /// use jointproof::connector::slider::rows::{GeometricStiffness, SliderLoads};
    /// use jointproof::formula::value;
    /// use nalgebra::Vector3;
    /// // A line along y, m in its middle: t1 = −k, and P = −(λ1/l) j ⊗ t1.
    /// let (x1, xn, xm) = (Vector3::zeros(), Vector3::y() * 4.0, Vector3::y() * 2.0);
    /// let loads = SliderLoads { x1, xn, xm, lambda_1: 2.0, lambda_2: 0.0 };
    /// let k = value::<GeometricStiffness>(&loads)?.matrix();
    /// assert_eq!((k[(7, 5)], k[(7, 2)]), (0.5, -0.5)); // the force on m along y, by z of n and of 1
    /// assert_eq!(k, k.transpose());
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn matrix(&self) -> SMatrix<D, 9, 9> {
        placed([self.k_u1_u1, self.k_u1_un, self.k_un_un, self.k_um_un])
    }
}
