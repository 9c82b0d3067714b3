//! A node of ISL21A on a straight segment: all that follows from places and from the state before, with the consistent tangent.
//!
//! The derivative is that of everything in a row: closest point, pressure, way along the line, shear stress, area, forces. The
//! segment goes on straight past its ends here; past an end of a line nothing is transmitted, which is for whoever knows the
//! line to say, as [`isl`](crate::contact::isl) does.

#[cfg(feature = "verify")]
mod proof;
mod tangent;

use self::tangent::{BySegment, Parts};
use super::Spot;
use super::forces::{self, LinearForces};
use super::friction::{self, Rubbing};
use crate::contact::interaction::{LinearContact, PressureLinear};
use crate::contact::slide_line::{
    ContactAreaLinear, LinearMotion, LinearNodes, LinearPoint, LinearSlave, LocalBasis, Projection, SegmentFoot,
    SlipIncrementLinear, check_distinct, check_radii, left,
};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    DSLIP, LINE_FORCE_1, LINE_FORCE_2, LINE_FORCE_S, LINE_G, LINE_G_BEFORE, MU, S11, S12, S12_BEFORE, SHEAR_STIFFNESS,
    STIFFNESS, X1, X2, XO, XS,
};
use crate::formula::{Component, Document, Fields, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, choice};
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
///
/// Where a derivative of a force is the product of two that vanish, as with a slave point at the corner of a right triangle whose
/// legs are along the axes and equal, its η grows without limit. It is small there beside the others, so that bounds are normwise.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

/// What value and Jacobian have in common.
struct Contact<D> {
    line: Projection<D>,
    pressed: LinearContact<D>,
    motion: LinearMotion<D>,
    rubbing: Rubbing<D>,
    nodes: LinearNodes<D>,
    spot: Spot<D, 2>,
    /// A, S11 and S12.
    loads: [D; 3],
}

impl<D: Scalar> Contact<D> {
    #[inline(always)]
    fn new(i: &LinearPressed<D>) -> Self {
        let LinearPressed { xs, xo, x1, x2, g_before, s12_before, k, k_el, mu } = *i;
        let line = Projection::new(&LinearSlave { xs, x1, x2 });
        let pressed = LinearContact { h: -line.separation, k };
        let [s11] = choice(|| [PressureLinear::eval(&pressed).p]);
        // From the place before, as it is now, to the slave point: positions in place of displacements.
        let motion = LinearMotion { x1, x2, g: g_before, dxs: xs, dx1: x1, dx2: x2 };
        let rubbing = Rubbing { s11, dslip: SlipIncrementLinear::eval(&motion).dslip, s12_before, k_el, mu };
        let nodes = LinearNodes { x1: xs, x2: xo };
        let [s12] = choice(|| [friction::Response::eval(&rubbing).s12]);
        let loads = [ContactAreaLinear::eval(&nodes).a1, s11, s12];
        // By its weights: from g alone the smaller one would lose digits.
        let Projection { t, weights, per_length, .. } = line;
        let rates = [-per_length, per_length];
        let spot = Spot { t, n: left(t), weights, rates, curvature: D::zero() };
        Self { line, pressed, motion, rubbing, nodes, spot, loads }
    }

    #[inline(always)]
    fn answer(&self) -> LinearAnswer<D> {
        let ([_, s11, s12], LinearForces { fs, f1, f2 }) = (self.loads, forces::Linear::at(&self.spot, self.loads));
        LinearAnswer { g: self.line.foot_on_line().g, dslip: self.rubbing.dslip, s11, s12, fs, f1, f2 }
    }

    #[inline(always)]
    fn gradients(&self, fs: Vector2<D>) -> Jacobian<Linear, D> {
        let SegmentFoot { g, separation } = self.line.gradients_on_line();
        let [by_h, by_k] = choice(|| {
            let LinearContact { h, k } = PressureLinear::jacobian(&self.pressed).p;
            [h, k]
        });
        let [xs, x1, x2] = [separation.xs, separation.x1, separation.x2].map(|by_e11| by_e11 * -by_h);
        let s11 = LinearPressed { k: by_k, ..LinearPressed::by_places(LinearSlave { xs, x1, x2 }) };
        let (by, slip) = (self.of_stress(), self.of_slip());
        let s12 = s12_by(&by, &s11, &slip);
        let slave = self.of_force(&s11, &s12);
        let BySegment { fs: [x1, x2], f1, f2 } = self.parts(by_h, &by).by_segment(&self.line.t);
        LinearAnswer {
            f1: self.of_node(0, fs, &g, &slave, &f1),
            f2: self.of_node(1, fs, &g, &slave, &f2),
            fs: Vector2::from_fn(|k, _| LinearPressed { x1: x1[k], x2: x2[k], ..slave[k] }),
            g: LinearPressed::by_places(g),
            dslip: slip,
            s11,
            s12,
        }
    }

    /// The gradient of S12 by what the return map takes.
    #[inline(always)]
    fn of_stress(&self) -> Rubbing<D> {
        let [s11, dslip, s12_before, k_el, mu] = choice(|| {
            let Rubbing { s11, dslip, s12_before, k_el, mu } = friction::Response::jacobian(&self.rubbing).s12;
            [s11, dslip, s12_before, k_el, mu]
        });
        Rubbing { s11, dslip, s12_before, k_el, mu }
    }

    #[inline(always)]
    fn of_slip(&self) -> LinearPressed<D> {
        let LinearMotion { x1, x2, g, dxs, dx1, dx2 } = SlipIncrementLinear::jacobian(&self.motion).dslip;
        let places = LinearSlave { xs: dxs, x1: x1 + dx1, x2: x2 + dx2 };
        LinearPressed { g_before: g, ..LinearPressed::by_places(places) }
    }

    /// The gradients of the force on the slave point, apart from those by the segment.
    #[inline(always)]
    fn of_force(&self, s11: &LinearPressed<D>, s12: &LinearPressed<D>) -> Vector2<LinearPressed<D>> {
        let change = forces::by_loads(&self.spot, self.loads);
        let area = ContactAreaLinear::jacobian(&self.nodes).a1;
        let component = |k: usize| {
            let [by_area, by_s11, by_s12] = change.map(|by| by[k]);
            LinearPressed {
                xs: s11.xs * by_s11 + s12.xs * by_s12 + area.x1 * by_area,
                xo: area.x2 * by_area,
                g_before: s12.g_before * by_s12,
                s12_before: s12.s12_before * by_s12,
                k: s11.k * by_s11 + s12.k * by_s12,
                k_el: s12.k_el * by_s12,
                mu: s12.mu * by_s12,
                ..LinearPressed::filled(D::zero())
            }
        };
        Vector2::new(component(0), component(1))
    }

    /// What the tangent is made of, where S11 falls by `stiffness` times E11 and `by` is the gradient of S12.
    #[inline(always)]
    fn parts(&self, stiffness: D, by: &Rubbing<D>) -> Parts<D> {
        let before = [self.motion.g, self.rubbing.s12_before];
        Parts::new(&self.line, before, self.loads, stiffness, [by.s11, by.dslip, by.s12_before])
    }

    /// The gradients of the force on a node, −Nᵢ fs, where Nᵢ changes by ∓½ δg; `slave` are those of fs.
    #[inline(always)]
    fn of_node(
        &self,
        node: usize,
        fs: Vector2<D>,
        g: &LinearSlave<D>,
        slave: &Vector2<LinearPressed<D>>,
        by_segment: &[[Vector2<D>; 2]; 2],
    ) -> Vector2<LinearPressed<D>> {
        let (weight, half) = (self.line.weights[node], [0.5, -0.5][node]);
        Vector2::from_fn(|k, _| {
            let by = &slave[k];
            LinearPressed {
                xs: by.xs * -weight + g.xs * (fs[k] * half),
                xo: by.xo * -weight,
                x1: by_segment[0][k],
                x2: by_segment[1][k],
                g_before: by.g_before * -weight,
                s12_before: by.s12_before * -weight,
                k: by.k * -weight,
                k_el: by.k_el * -weight,
                mu: by.mu * -weight,
            }
        })
    }
}

/// The gradient of S12, by those of S11 and of the slip.
#[inline(always)]
fn s12_by<D: Scalar>(by: &Rubbing<D>, s11: &LinearPressed<D>, slip: &LinearPressed<D>) -> LinearPressed<D> {
    LinearPressed {
        xs: s11.xs * by.s11 + slip.xs * by.dslip,
        xo: slip.xo,
        x1: s11.x1 * by.s11 + slip.x1 * by.dslip,
        x2: s11.x2 * by.s11 + slip.x2 * by.dslip,
        g_before: slip.g_before * by.dslip,
        s12_before: by.s12_before,
        k: s11.k * by.s11,
        k_el: by.k_el,
        mu: by.mu,
    }
}

/// As gradients.
impl<D: Scalar> LinearPressed<D> {
    /// By the slave point and the segment alone.
    #[inline(always)]
    fn by_places(LinearSlave { xs, x1, x2 }: LinearSlave<D>) -> Self {
        Self { xs, x1, x2, ..Self::filled(D::zero()) }
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
        .normwise(4.0, 32.0)
        .scale(1e20)
        .not_objective();
    type Inputs<T: Component> = LinearPressed<T>;
    type Outputs<T: Component> = LinearAnswer<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearPressed<D>) -> LinearAnswer<D> {
        Contact::new(i).answer()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearPressed<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &LinearPressed<D>) -> ValueAndJacobian<Self, D> {
        let contact = Contact::new(i);
        let answer = contact.answer();
        (answer, contact.gradients(answer.fs))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearPressed<D>) -> Result<(), Error> {
        check_radii([("xs", i.xs)])?;
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}
