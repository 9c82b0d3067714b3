//! TRANSLATOR: the elements of SLOT and ALIGN, with a friction along the slot to which the moments contribute as well as the
//! forces.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::align::MULTIPLIERS as ALIGNING;
use crate::connector::align::Orientations;
use crate::connector::slot::SlotState;
use crate::connector::slot::{RelativePosition, SlotPositions};
use crate::connector::translator::{AllResiduals, Constraint, Friction, FrictionLoads, Placement};
use crate::contact::coulomb::Sliding;
use crate::element::angle::{self, AlignLoads, AlignRows};
use crate::element::cardan::Angles;
use crate::element::nodes::{by_spins, two_nodes};
use crate::element::{Contribution, Element, Nodes, Parameters};
use crate::element::{Rows, line};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{ALPHA0, BETA0, F2, F3, FC_INT, GAMMA0, K_STICK, L_OVERLAP, MU, RR, X0, Y0, Z0};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector3};

/// TRANSLATOR as an element, with the multipliers f2, f3 and those of ALIGN's three angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TranslatorElement;

fields! {
    /// The components of x_b − x_a in a's triad and the Cardan angles at the start.
    pub struct TranslatorStart<T> {
        x0: T = X0, y0: T = Y0, z0: T = Z0, alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0,
    }
}
fields! {
    /// The parameters of the friction of b in the slot: a radius of 0 ignores the torque, a length of 0 bending.
    pub struct TranslatorContact<T> {
        k_stick: T = K_STICK, rr: T = RR, l: T = L_OVERLAP, fc_int: T = FC_INT, mu: T = MU,
    }
}

impl<D: Scalar> TranslatorContact<D> {
    /// The friction force after a motion, with its derivatives with respect to u1 and to f2, f3, m1, m2 and m3.
    fn rub(&self, u1: D, before: &SlotState<D>, [f2, f3]: [D; 2], [m1, m2, m3]: [D; 3]) -> (D, D, [D; 5]) {
        let Self { k_stick, rr, l, fc_int, mu } = *self;
        let loads = FrictionLoads { f1: D::zero(), f2, f3, m1, m2, m3, rr, l, fc_int, mu };
        let (friction, by_loads) = Friction::linearized(&loads);
        let increment = Sliding { du: u1 - before.u1, f_before: before.f1, k_stick, mu, r#fn: friction.r#fn };
        let FrictionLoads { f2, f3, m1, m2, m3, .. } = by_loads.r#fn;
        increment.under([f2, f3, m1, m2, m3])
    }
}

impl<T: Component> TranslatorStart<T> {
    fn placement(&self, nodes: &Nodes<T>) -> Placement<T> {
        let (Nodes { e2a, e3a, xa, xb, .. }, Self { y0, z0, alpha0, beta0, gamma0, .. }) = (*nodes, *self);
        let angles = Angles { alpha: alpha0, beta: beta0, gamma: gamma0 };
        Placement::new(&SlotPositions { e2a, e3a, xa, xb, y0, z0 }, &Orientations::new(&nodes.triads(), &angles))
    }
}

impl Element<5> for TranslatorElement {
    const SPEC: Spec = Spec::new(
        "translator",
        "TRANSLATOR as an element",
        Document::TRANSLATOR
            .ours("Description", "the page names SLOT, ALIGN and friction; the element is derived from them"),
    )
    .eta_of_value(16.0)
    .normwise_of_value(8.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <AllResiduals<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] =
        &[Field::new("f2", &F2), Field::new("f3", &F3), ALIGNING[0], ALIGNING[1], ALIGNING[2]];
    type Start<T: Component> = TranslatorStart<T>;
    type Contact<T: Component> = TranslatorContact<T>;
    type State<T: Component> = SlotState<T>;

    fn validate<D: Scalar>(nodes: &Nodes<D>, _: &Parameters<Self, D, 5>) -> Result<(), Error> {
        angle::Rows::validate(&nodes.triads())
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &SVector<D, 5>,
        parameters: &Parameters<Self, D, 5>,
        before: &SlotState<D>,
    ) -> (Contribution<D, 5>, SlotState<D>) {
        let (positions, triads) = (nodes.positions(), nodes.triads());
        let [f2, f3, l1, l2, l3] = multipliers.data.0[0];
        let AllResiduals { gy, gz, ur1, ur2, ur3 } = Constraint::eval(&parameters.start.placement(nodes));
        let (join_rows, align_rows) = (line::Rows::eval(&positions).matrix(), angle::Rows::eval(&triads));
        let AlignRows { ur1_tb, ur2_tb, ur3_tb } = align_rows;
        let mut rows = Rows::<D, 5>::zeros();
        rows.fixed_rows_mut::<2>(0).copy_from(&join_rows.fixed_rows::<2>(1));
        rows.fixed_rows_mut::<3>(2).copy_from(&align_rows.matrix());

        let aligning = AlignLoads::new(&triads, [l1, l2, l3]);
        let (moments, k_align) = (angle::Moments::eval(&aligning), angle::GeometricStiffness::eval(&aligning));
        // A rotation of b about e1a changes only α, by the same angle, so the moment about e1a is the first multiplier. The sum
        // e1a·m_b would lose digits to the other terms.
        let [_, e2a, e3a] = nodes.a();
        let along_axes = [l1, e2a.dot(&moments.mb), e3a.dot(&moments.mb)];
        let u1 = RelativePosition::eval(&positions).x - parameters.start.x0;
        let rubbed = parameters.contact.map(|contact| contact.rub(u1, before, [f2, f3], along_axes));
        let loads = nodes.join_loads([rubbed.map_or(D::zero(), |(f1, ..)| -f1), f2, f3]);
        let mut found = Contribution::smooth(
            SVector::from([gy, gz, ur1, ur2, ur3]),
            rows,
            line::Forces::eval(&loads).vector() + moments.vector(),
            line::GeometricStiffness::eval(&loads).matrix() + k_align.matrix(),
        );
        let Some((f1, by_u1, [by_f2, by_f3, by_m1, by_m2, by_m3])) = rubbed else { return (found, *before) };
        // The other moments change with m_b, and with the axes when a rotates.
        let pressing: Vector3<D> = e2a * by_m2 + e3a * by_m3;
        let by_ta = pressing.cross(&moments.mb) - k_align.k_tb_tb * pressing;
        let by_tb = k_align.k_tb_tb.transpose() * pressing;
        let along = join_rows.row(0).transpose();
        let [r1, r2, r3] = [ur1_tb, ur2_tb, ur3_tb].map(|row| pressing.dot(&row));
        found.follow_friction(
            &along,
            &(along * by_u1 + by_spins(by_ta, by_tb)),
            &SVector::from([by_f2, by_f3, r1 + by_m1, r2, r3]),
        );
        (found, SlotState { u1, f1 })
    }
}
