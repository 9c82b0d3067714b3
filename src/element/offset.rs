//! A connector at the end of a rigid arm: its rows, forces and stiffness at the node that carries the arm.
//!
//! The connector's point moves with u + θ × r, where r is the arm, from the node to that point, and rotates with the node. A
//! force there has the moment r × f about the node, which changes as the arm rotates.

#[cfg(feature = "verify")]
mod proof;

use super::products::double_cross;
use super::{Forces, Rows, Stiffness};
use crate::fields;
use crate::formula::quantity::{ARM, ARM_FORCE, ARM_MOMENT, K_ARM, NODE_MOMENT};
use crate::formula::{Component, Document, Finite, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

fields! {
    /// The arm, and the force and moment at its end.
    pub struct ArmLoads<T> { r: Vector3<T> = ARM, f: Vector3<T> = ARM_FORCE, m: Vector3<T> = ARM_MOMENT }
}
fields! {
    /// The moment at the node, and the derivative of the force's moment with respect to the node's spin, with the force held.
    pub struct ArmActions<T> { m_node: Vector3<T> = NODE_MOMENT, k_arm: Matrix3<T> = K_ARM }
}

/// The effect of the loads at the end of a rigid arm on its node: the same force, the moment m + r × f, and an additional
/// stiffness.
#[derive(Clone, Copy, Debug)]
pub struct Arm;

impl Formula for Arm {
    const SPEC: Spec = Spec::new(
        "element.arm",
        "A rigid arm between node and connector",
        Document::UJOINT.ours("Description", "the page has the connector at its nodes; programs put rigid arms between"),
    )
    .equation(r"\mathbf{m}_{\mathrm{node}} = \mathbf{m} + \mathbf{r}\times\mathbf{f},\quad \mathbf{K}_{\mathrm{arm}} = \mathbf{r}\otimes\mathbf{f} - (\mathbf{r}\cdot\mathbf{f})\,\mathbf{I}")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = ArmLoads<T>;
    type Outputs<T: Component> = ArmActions<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ArmLoads<D>) -> ArmActions<D> {
        ArmActions { m_node: i.m + i.r.cross(&i.f), k_arm: double_cross(&i.r, &i.f) }
    }
}

/// The rigid arms from nodes a and b to the points that a connector holds.
///
/// ```
/// use jointproof::connector::slot::Positions;
/// use jointproof::element::line::Rows;
/// use jointproof::element::offset::Arms;
/// use jointproof::formula::value;
/// use nalgebra::Vector3;
/// let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
/// let xa = Vector3::zeros();
/// let arms = Arms { a: e2a, b: Vector3::zeros() };
/// // The connector's points are those at the ends of the arms.
/// let rows = value::<Rows>(&Positions { e1a, e2a, e3a, xa: xa + arms.a, xb: e2a })?.matrix();
/// // A turn of a about z takes the end of its arm along −x, so that b is ahead along e1a.
/// assert_eq!((rows[(0, 5)], arms.rows(&rows)[(0, 5)]), (0.0, 1.0));
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arms<D> {
    /// The arm from node a, in the global frame.
    pub a: Vector3<D>,
    /// The arm from node b, in the global frame.
    pub b: Vector3<D>,
}

impl<D: Scalar> Arms<D> {
    /// The arms, each with the first degree of freedom of its node.
    const fn placed(&self) -> [(usize, Vector3<D>); 2] {
        [(0, self.a), (6, self.b)]
    }

    /// The rows over the degrees of freedom of the nodes, from those of the points.
    pub fn rows<const RESIDUALS: usize>(&self, at_points: &Rows<D, RESIDUALS>) -> Rows<D, RESIDUALS> {
        let mut rows = *at_points;
        for mut row in rows.row_iter_mut() {
            for (node, arm) in self.placed() {
                let moment = arm.cross(&row.fixed_columns::<3>(node).transpose());
                let mut spin = row.fixed_columns_mut::<3>(node + 3);
                spin += moment.transpose();
            }
        }
        rows
    }

    /// The forces and moments on the nodes, from those on the points.
    pub fn forces(&self, at_points: &Forces<D>) -> Forces<D> {
        self.rows(&at_points.transpose()).transpose()
    }

    /// The stiffness at the nodes, from the stiffness and the forces at the points.
    pub fn stiffness(&self, at_points: &Stiffness<D>, forces: &Forces<D>) -> Stiffness<D> {
        let by_columns = self.rows(at_points);
        let mut all = self.rows(&by_columns.transpose()).transpose();
        for (node, r) in self.placed() {
            let (f, m) = (forces.fixed_rows::<3>(node).into_owned(), forces.fixed_rows::<3>(node + 3).into_owned());
            let mut block = all.fixed_view_mut::<3, 3>(node + 3, node + 3);
            block += Arm::eval(&ArmLoads { r, f, m }).k_arm;
        }
        all
    }
}
