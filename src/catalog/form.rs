//! The form of an element: at its nodes or on rigid arms, by which unknowns of rotations, with multipliers or with penalties.

use crate::Error;
use crate::formula::proof::Case;
use crate::formula::quantity::{
    ARM, Domain, EULER_MOMENT, EULER_MOMENT0, EULER_Q, EULER_Q0, PSI, PSI_MOMENT, Quantity, Unit,
};
use crate::formula::{Field, Spec};
use crate::toolkit::graph::{Extremes, Graph, NotRecorded};
use crate::toolkit::verify::Layout;

/// An element in one of its forms, with the types of nodes, parameters and state erased: what is computed, recorded and exported.
pub trait AnyForm: Send + Sync {
    /// The specification of the element.
    fn spec(&self) -> Spec;
    /// Its form.
    fn form(&self) -> Form {
        Form::default()
    }
    /// The identifier of the element, with its form.
    fn name(&self) -> String {
        format!("{}{}", self.spec().id, self.form().suffix())
    }
    /// Its degrees of freedom, forces, residuals, multipliers, parameters and state in order.
    fn layout(&self) -> Layout;
    /// Its inputs in order: nodes, multipliers, start, and, with friction, contact and state.
    fn inputs(&self, rubs: bool) -> &'static [Field];
    /// Its cases without or with friction: its own, every kind of invalid input, and this many random ones.
    fn cases(&self, rubs: bool, random: usize) -> Vec<Case<Vec<f64>>>;
    /// Its graph, whose results are those of [`value`](Self::value).
    ///
    /// # Errors
    /// The reason why the element cannot be recorded.
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded>;
    /// Its results from components of the inputs in order: residuals, rows, forces, stiffness, derivative with respect to the
    /// multipliers, each matrix row by row, and, with friction, the state after the step.
    ///
    /// # Errors
    /// The input that is not valid, or an overflow; [`Error::Components`] if the number of components is wrong.
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error>;
}

/// The unknowns of the rotation of a node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotations {
    /// Spins, in the global frame.
    #[default]
    Spins,
    /// The rotation vector ψ.
    Vectors,
    /// The Euler parameters q0, q.
    EulerParameters,
}

/// The form of an element: by default at its nodes, by spins, and with multipliers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// Whether rigid arms are between the nodes and the points of the connector.
    pub has_arms: bool,
    /// The unknowns of rotations.
    pub rotations: Rotations,
    /// Whether penalties times the residuals are in place of multipliers.
    pub has_penalties: bool,
}

/// The unknowns of both nodes, which are inputs, and the moments conjugate to them; those of node a first.
pub(super) type OfRotations = [&'static [Field]; 2];

pub(super) const ARMS: &[Field] = &[Field::new("arm_a", &ARM), Field::new("arm_b", &ARM)];
const VECTORS: OfRotations = [
    &[Field::new("psi_a", &PSI), Field::new("psi_b", &PSI)],
    &[Field::new("m_psi_a", &PSI_MOMENT), Field::new("m_psi_b", &PSI_MOMENT)],
];
const EULER: OfRotations = [
    &[
        Field::new("q0_a", &EULER_Q0),
        Field::new("q_a", &EULER_Q),
        Field::new("q0_b", &EULER_Q0),
        Field::new("q_b", &EULER_Q),
    ],
    &[
        Field::new("m_q0_a", &EULER_MOMENT0),
        Field::new("m_q_a", &EULER_MOMENT),
        Field::new("m_q0_b", &EULER_MOMENT0),
        Field::new("m_q_b", &EULER_MOMENT),
    ],
];

/// κ of residuals that are lengths.
const KAPPA: Quantity =
    Quantity::scalar(r"\kappa", Unit::F.per(Unit::L), Domain::NonNegative, "penalty: force per length of a residual");
/// κ of residuals that are angles or cosines.
const KAPPA_R: Quantity = Quantity::scalar(
    r"\kappa_r",
    Unit::FL,
    Domain::NonNegative,
    "penalty: moment per radian or unit of a residual that is an angle or a cosine",
);
pub(super) const PENALTIES: [Field; 2] = [Field::new("kappa", &KAPPA), Field::new("kappa_r", &KAPPA_R)];

impl Form {
    /// What follows the identifier of the element.
    pub(super) fn suffix(self) -> String {
        let rotations = match self.rotations {
            Rotations::Spins => "",
            Rotations::Vectors => "_vectors",
            Rotations::EulerParameters => "_euler",
        };
        let [arms, penalty] =
            [(self.has_arms, "_arms"), (self.has_penalties, "_penalty")].map(|(has, name)| if has { name } else { "" });
        [arms, rotations, penalty].concat()
    }

    /// What its inputs and results are, beyond those of the element.
    pub fn remarks(self) -> Vec<&'static str> {
        let rotations = match self.rotations {
            Rotations::Spins => None,
            Rotations::Vectors => Some(
                "The triad of a node is that at psi = 0 rotated by psi, and both are inputs; derivatives are with respect to \
                 psi, and moments are conjugate to it. The length of psi must stay well below a full turn.",
            ),
            Rotations::EulerParameters => Some(
                "The triad of a node is that at (q0, q) = (1, 0) rotated by the unit quaternion (q0, q), and both are inputs; \
                 derivatives are with respect to (q0, q), and moments are conjugate to them. The program holds the length of (q0, q).",
            ),
        };
        let arms = self.has_arms.then_some(
            "The connector is at the ends of rigid arms, xa + arm_a and xb + arm_b; an arm rotates with its node, and the input \
             is its current position.",
        );
        let penalties = self.has_penalties.then_some(
            "Penalties instead of multipliers: each multiplier is minus its penalty times its residual, and the stiffness includes \
             their change. kappa is the penalty of lengths, kappa_r that of angles and cosines.",
        );
        arms.into_iter().chain(rotations).chain(penalties).collect()
    }

    /// The input that is the penalty of a residual: one for lengths, another for the rest.
    pub fn penalty(residual: &Field) -> Field {
        PENALTIES[usize::from(residual.quantity.unit != Unit::L)]
    }

    pub(super) const fn of_rotations(self) -> Option<OfRotations> {
        match self.rotations {
            Rotations::Spins => None,
            Rotations::Vectors => Some(VECTORS),
            Rotations::EulerParameters => Some(EULER),
        }
    }
}
