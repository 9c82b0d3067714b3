//! A node of ISL21A on a straight segment: all that follows from places and from the state before, with the consistent tangent.
//!
//! The derivative is that of everything in a row: closest point, pressure, way along the line, shear stress, area, forces. The
//! segment goes on straight past its ends here; past an end of a line nothing is transmitted, which is for whoever knows the
//! line to say, as [`isl`](crate::isl) does.

#[cfg(feature = "verify")]
mod proof;

use super::Spot;
use super::forces::{self, LinearForces};
use super::friction::{self, Rubbing};
use crate::element::chain::{Term, chain, each, gradients, through, variables};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Document, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::interaction::{LinearContact, PressureLinear};
use crate::quantity::{
    DSLIP, LINE_FORCE_1, LINE_FORCE_2, LINE_FORCE_S, LINE_G, LINE_G_BEFORE, MU, S11, S12, S12_BEFORE, SHEAR_STIFFNESS,
    STIFFNESS, X1, X2, XO, XS,
};
use crate::scalar::Scalar;
use crate::slide_line::{
    Basis, ClosestLinear, ContactAreaLinear, Direction, LinearMotion, LinearNodes, LinearPoint, LinearSlave,
    LocalBasis, SlipIncrementLinear, check_distinct, check_radii,
};
use nalgebra::Vector2;

fields! {
    /// Where both nodes of the element and both of the segment are, the state before, and what the contact is made of.
    pub struct LinearPressed<T> {
        xs: Vector2<T> = XS, xo: Vector2<T> = XO, x1: Vector2<T> = X1, x2: Vector2<T> = X2,
        g_before: T = LINE_G_BEFORE, s12_before: T = S12_BEFORE, k: T = STIFFNESS, k_el: T = SHEAR_STIFFNESS, mu: T = MU,
    }
}
fields! {
    /// The state after, and what the contact exerts.
    pub struct LinearAnswer<T> {
        g: T = LINE_G, dslip: T = DSLIP, s11: T = S11, s12: T = S12,
        fs: Vector2<T> = LINE_FORCE_S, f1: Vector2<T> = LINE_FORCE_1, f2: Vector2<T> = LINE_FORCE_2,
    }
}

/// The response of a node of ISL21A on a straight segment, with its consistent tangent.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    /// N₁ and N₂ at the place g, which changes as it does; from g alone the smaller one would lose digits.
    fn weights<D: Scalar, const K: usize>(slave: &LinearSlave<Term<D, K>>, g: Term<D, K>) -> [Term<D, K>; 2] {
        let values: LinearSlave<D> = each(slave, Term::constant(D::zero()), |term: Term<D, K>| term.value);
        let [n1, n2] = ClosestLinear::weights_on_line(&values);
        let half = g.slope * D::from(0.5);
        [Term::new(n1, -half), Term::new(n2, half)]
    }

    #[inline(always)]
    #[expect(clippy::inline_always, reason = "where derivatives are 0 is seen where it is compiled in place")]
    fn at<D: Scalar, const K: usize>(i: &LinearPressed<Term<D, K>>) -> LinearAnswer<Term<D, K>> {
        let LinearPressed { xs, xo, x1, x2, g_before, s12_before, k, k_el, mu } = *i;
        let slave = LinearSlave { xs, x1, x2 };
        let foot = through::<ClosestLinear, _, K>(&slave, ClosestLinear::on_line);
        let s11 = chain::<PressureLinear, _, K>(&LinearContact { h: -foot.separation, k }).p;
        // From the place before, as it is now, to the slave point: positions in place of displacements.
        let motion = LinearMotion { x1, x2, g: g_before, dxs: xs, dx1: x1, dx2: x2 };
        let dslip = chain::<SlipIncrementLinear, _, K>(&motion).dslip;
        let s12 = chain::<friction::Response, _, K>(&Rubbing { s11, dslip, s12_before, k_el, mu }).s12;
        let area = chain::<ContactAreaLinear, _, K>(&LinearNodes { x1: xs, x2: xo }).a1;
        let Basis { t, n } = chain::<LocalBasis, _, K>(&Direction { dx: x2.zip_map(&x1, |to, from| to + -from) });
        let (zero, weights) = (Term::constant(D::zero()), Self::weights(&slave, foot.g));
        let LinearForces { fs, f1, f2 } =
            forces::Linear::at(&Spot { t, n, weights, rates: [zero; 2], curvature: zero }, [area, s11, s12]);
        LinearAnswer { g: foot.g, dslip, s11, s12, fs, f1, f2 }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new(
        "slide_line.contact_response_linear",
        "Response of ISL21A on a straight segment",
        Document::SLIDE_LINE.ours("Element output", "the section names what is put out; how it follows from places is ours"),
    )
        .equation(r"\begin{aligned} g &= \frac{2\,(\mathbf{x}_s-\mathbf{x}_1)\cdot\mathbf{t}}{\ell} - 1,\quad \Delta E_{12} = \tfrac12\ell\,(g - g^{\mathrm{before}}),\quad S_{11} = \begin{cases} -k E_{11} & E_{11} < 0 \\ 0 & \text{otherwise}\end{cases},\quad S_{12} = \begin{cases} S^{\mathrm{trial}} & \lvert S^{\mathrm{trial}}\rvert < \mu S_{11} \\ \mu S_{11} \operatorname{sign} S^{\mathrm{trial}} & \text{otherwise}\end{cases}, \\ \mathbf{f}_s &= A\,(S_{11}\,\mathbf{n} - S_{12}\,\mathbf{t}),\quad \mathbf{f}_1 = -\tfrac12(1-g)\,\mathbf{f}_s,\quad \mathbf{f}_2 = -\tfrac12(1+g)\,\mathbf{f}_s, \\ E_{11} &= (\mathbf{x}_s-\mathbf{x}_1)\cdot\mathbf{n},\quad S^{\mathrm{trial}} = S_{12}^{\mathrm{before}} + k_{\mathrm{el}}\,\Delta E_{12},\quad A = \pi\,x_{s,1}\,\lvert\mathbf{x}_o-\mathbf{x}_s\rvert,\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        .eta(4.0, 16.0)
        .scale(1e3)
        .not_objective();
    type Inputs<T: Component> = LinearPressed<T>;
    type Outputs<T: Component> = LinearAnswer<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearPressed<D>) -> LinearAnswer<D> {
        let still: LinearPressed<Term<D, 0>> = each(i, D::zero(), Term::constant);
        each(&Self::at(&still), Term::constant(D::zero()), |term: Term<D, 0>| term.value)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearPressed<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &LinearPressed<D>) -> ValueAndJacobian<Self, D> {
        let answer = Self::at(&variables::<13, _, _, _>(i));
        (each(&answer, Term::constant(D::zero()), |term: Term<D, 13>| term.value), gradients(&answer))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearPressed<D>) -> Result<(), Error> {
        check_radii([("xs", i.xs)])?;
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}
