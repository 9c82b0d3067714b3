//! ISL21A and ISL22A on a slide line: an element with all its slave nodes, each against the segment that it touches.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations of the nodes of the element, then those of the segment under its first node, under its second, and so on |
//! | state | for every slave node: the position on its segment, and the shear stress |
//! | matrix | the derivative of all forces: those of closest point, pressure, distance along the line, shear stress, area and normal |
//! | signs | forces act on the nodes, as everywhere |
//!
//! Two slave nodes may touch the same segment; assembly adds up the contributions to each node. A slave node past an end of its
//! segment transmits nothing: on a line of several segments the next segment must then be used. A slave node exactly above an end
//! belongs to both.

mod shape;
#[cfg(all(test, feature = "verify"))]
mod tests;

use crate::contact::coulomb::{Response, Sliding};
use crate::contact::interaction::{ExponentialContact, LinearContact, PressureExponential, PressureLinear};
use crate::contact::slide_line::element::chain::{Term, chain};
use crate::formula::check;
use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector, Vector2};
use shape::{Curved, Shape, Straight};

/// The dependence of the pressure on the separation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PressureLaw {
    /// [`PressureLinear`].
    Linear {
        /// Pressure per overclosure.
        k: f64,
    },
    /// [`PressureExponential`].
    Exponential {
        /// The clearance at which contact begins.
        c0: f64,
        /// The pressure at zero overclosure.
        p0: f64,
    },
}

/// The parameters of pressure and friction at slave nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineContact {
    /// The pressure.
    pub law: PressureLaw,
    /// Stiffness in stick, as shear stress per displacement, > 0.
    pub k_stick: f64,
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
}

/// The state of a slave node between increments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlaveState<D> {
    /// The position on its segment.
    pub g: D,
    /// The shear stress S12.
    pub s12: D,
}

/// The contribution of an element to the residual and the matrix of Newton's method; it has as many slave nodes as a segment has
/// nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressed<D, const NODES: usize, const DEGREES: usize> {
    /// The forces of the contact on all nodes.
    pub forces: SVector<D, DEGREES>,
    /// The derivative of these forces.
    pub stiffness: SMatrix<D, DEGREES, DEGREES>,
    /// The pressure at every slave node.
    pub pressures: [D; NODES],
    /// The state of every slave node after the motion.
    pub after: [SlaveState<D>; NODES],
    /// The greatest torque that the element transmits, as if μ were 1.
    pub torque: D,
    /// The derivative of the torque.
    pub torque_row: SVector<D, DEGREES>,
}

/// The positions of the N nodes of an element and of the segments under them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnLine<D, const N: usize> {
    /// The nodes of the element.
    pub nodes: [Vector2<D>; N],
    /// The nodes of the segment under each of them.
    pub segments: [[Vector2<D>; N]; N],
}

impl<D: Scalar, const N: usize> OnLine<D, N> {
    /// The positions with derivatives with respect to all of them.
    fn varied<const K: usize>(&self) -> OnLine<Term<D, K>, N> {
        let point = |x: Vector2<D>, node: usize| Vector2::from_fn(|k, _| Term::variable(x[k], 2 * node + k));
        let segment = |s: usize| std::array::from_fn(|k| point(self.segments[s][k], N + N * s + k));
        OnLine { nodes: std::array::from_fn(|k| point(self.nodes[k], k)), segments: std::array::from_fn(segment) }
    }
}

/// ISL21A over straight segments: twelve degrees of freedom.
///
/// ```
/// use jointproof::contact::slide_line::element::newton::{Isl21a, LineContact, OnLine, PressureLaw, SlaveState};
/// use nalgebra::Vector2;
/// let place = |r: f64, z: f64| Vector2::new(r, z);
/// let washer = [place(1.0, 0.0), place(5.0, 0.0)];
/// // A ring presses from above by 1/8, and has been dragged along by 1/4.
/// let ring = OnLine { nodes: [place(2.25, -0.125), place(2.75, -0.125)], segments: [washer; 2] };
/// let contact = LineContact { law: PressureLaw::Linear { k: 1000.0 }, k_stick: 5000.0, mu: 0.25 };
/// let before = [SlaveState { g: -0.5, s12: 0.0 }, SlaveState { g: -0.25, s12: 0.0 }];
/// let found = Isl21a(contact).newton(&ring, &before)?;
/// assert_eq!((found.pressures[0], found.after[0].s12), (125.0, 31.25)); // it slips: 0.25 × 125
/// assert_eq!(found.torque, 125.0 * 2.0 * std::f64::consts::PI * (2.75_f64.powi(3) - 2.25_f64.powi(3)) / 3.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isl21a(pub LineContact);

/// ISL22A over parabolic segments: twenty-four degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isl22a(pub LineContact);

impl Isl21a {
    /// The contribution of the element, and the state after the motion.
    pub fn contribution<D: Scalar>(&self, places: &OnLine<D, 2>, before: &[SlaveState<D>; 2]) -> Pressed<D, 2, 12> {
        self.0.contribution::<Straight, D, 2, 12>(places, before)
    }

    /// The same with checked numbers.
    ///
    /// # Errors
    /// The first number that is not valid, or that something overflowed.
    pub fn newton(&self, places: &OnLine<f64, 2>, before: &[SlaveState<f64>; 2]) -> Result<Pressed<f64, 2, 12>, Error> {
        self.0.newton::<Straight, 2, 12>(places, before)
    }
}

impl Isl22a {
    /// The contribution of the element, and the state after the motion.
    pub fn contribution<D: Scalar>(&self, places: &OnLine<D, 3>, before: &[SlaveState<D>; 3]) -> Pressed<D, 3, 24> {
        self.0.contribution::<Curved, D, 3, 24>(places, before)
    }

    /// The same with checked numbers.
    ///
    /// # Errors
    /// The first number that is not valid, or that something overflowed.
    pub fn newton(&self, places: &OnLine<f64, 3>, before: &[SlaveState<f64>; 3]) -> Result<Pressed<f64, 3, 24>, Error> {
        self.0.newton::<Curved, 3, 24>(places, before)
    }
}

impl LineContact {
    fn pressure<D: Scalar, const K: usize>(&self, h: Term<D, K>) -> Term<D, K> {
        let constant = |x: f64| Term::constant(D::from(x));
        match self.law {
            PressureLaw::Linear { k } => chain::<PressureLinear, _, K>(&LinearContact { h, k: constant(k) }).p,
            PressureLaw::Exponential { c0, p0 } => {
                let contact = ExponentialContact { h, c0: constant(c0), p0: constant(p0) };
                chain::<PressureExponential, _, K>(&contact).p
            }
        }
    }

    fn check(&self) -> Result<(), Error> {
        match self.law {
            PressureLaw::Linear { k } => check::<PressureLinear>(&LinearContact { h: 0.0, k })?,
            PressureLaw::Exponential { c0, p0 } => {
                check::<PressureExponential>(&ExponentialContact { h: 0.0, c0, p0 })?;
            }
        }
        let Self { k_stick, mu, .. } = *self;
        check::<Response>(&Sliding { du: 0.0, f_before: 0.0, k_stick, mu, r#fn: 0.0 })
    }

    fn contribution<S: Shape<N>, D: Scalar, const N: usize, const K: usize>(
        &self,
        places: &OnLine<D, N>,
        before: &[SlaveState<D>; N],
    ) -> Pressed<D, N, K> {
        let zero = Term::constant(D::zero());
        let OnLine { nodes, segments } = places.varied::<K>();
        let areas = S::areas(&nodes);
        let (mut forces, mut pressures) = ([zero; K], [zero; N]);
        let after = std::array::from_fn(|slave| {
            let (segment, before) = (&segments[slave], before[slave]);
            let foot = S::foot(nodes[slave], segment);
            if !foot.inside {
                return SlaveState { g: foot.g.value, s12: D::zero() };
            }
            let s11 = self.pressure(-foot.separation);
            let [k_stick, mu] = [self.k_stick, self.mu].map(|x| Term::constant(D::from(x)));
            let (du, f_before) = (S::path_length(nodes[slave], segment, before.g, foot.g), Term::constant(before.s12));
            let s12 = if s11.value > 0.0 {
                chain::<Response, _, K>(&Sliding { du, f_before, k_stick, mu, r#fn: s11 }).f
            } else {
                zero
            };
            let (on_slave, on_line) = S::forces(segment, foot.g, [areas[slave], s11, s12]);
            let mut add = |node: usize, force: Vector2<Term<D, K>>| {
                for axis in 0..2 {
                    forces[2 * node + axis] = forces[2 * node + axis] + force[axis];
                }
            };
            add(slave, on_slave);
            on_line.into_iter().enumerate().for_each(|(k, force)| add(N + N * slave + k, force));
            pressures[slave] = s11;
            SlaveState { g: foot.g.value, s12: s12.value }
        });
        let torque = S::torque(&nodes, &pressures);
        Pressed {
            forces: SVector::from_fn(|row, _| forces[row].value),
            stiffness: SMatrix::from_fn(|row, column| forces[row].slope[column]),
            pressures: pressures.map(|p| p.value),
            after,
            torque: torque.value,
            torque_row: torque.slope,
        }
    }

    fn newton<S: Shape<N>, const N: usize, const K: usize>(
        &self,
        places: &OnLine<f64, N>,
        before: &[SlaveState<f64>; N],
    ) -> Result<Pressed<f64, N, K>, Error> {
        self.check()?;
        for (slave, segment) in places.segments.iter().enumerate() {
            S::check(&places.nodes, slave, segment)?;
        }
        Error::check_vector("g_before", before.map(|slave| slave.g).into())?;
        Error::check_vector("s12_before", before.map(|slave| slave.s12).into())?;
        let found = self.contribution::<S, f64, N, K>(places, before);
        let Pressed { forces, stiffness, torque, torque_row, .. } = &found;
        let finite = forces.iter().chain(stiffness).chain(torque_row).all(|x| x.is_finite()) && torque.is_finite();
        if finite { Ok(found) } else { Err(Error::Overflow { name: "contribution" }) }
    }
}
