//! ISL21A and ISL22A on a slide line as elements with all their slave nodes, each against the segment that it touches.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations of the slave nodes, then those of the segment under the first of them, under the second, and so on |
//! | residual | the greatest torque that the element transmits, as if μ were 1; there are no multipliers |
//! | state | for every slave node: the position along its segment, and the shear stress |
//! | matrix | the derivative of all forces: those of closest point, pressure, distance along the line, shear stress, area and normal |
//! | signs | forces act on the nodes, as everywhere |
//!
//! Two slave nodes may touch the same segment; assembly adds up the contributions to each node. A slave node past an end of its
//! segment transmits nothing: on a line of several segments the next segment must then be used. A slave node exactly above an end
//! belongs to both.

#[cfg(feature = "verify")]
mod proof;

use super::chain::{Term, components};
use super::fields::{IslContact, PressureLaw};
use super::segment::{Curved, Points, Segment, Straight, Touched};
use crate::contact::coulomb::Sliding;
use crate::contact::slide_line::{check_distinct, check_radii};
use crate::formula::element::{Contribution, Element, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::TORQUE;
use crate::formula::{Component, Document, Field, Fields, Spec};
use crate::number::scalar::{Scalar, choice};
use nalgebra::{SMatrix, SVector, Vector2};
use std::marker::PhantomData;

/// An element of N slave nodes over segments S, with the pressure law P; L is the number of degrees of freedom on
/// which the forces of one slave node depend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isl<S, P, const N: usize, const L: usize>(PhantomData<(S, P)>);

impl<S, P, const N: usize, const L: usize> Isl<S, P, N, L> {
    /// The element.
    pub const ELEMENT: Self = Self(PhantomData);
}

/// ISL21A over straight segments as an element: twelve degrees of freedom.
///
/// ```
/// use jointproof::contact::interaction::PressureLinear;
/// use jointproof::contact::slide_line::element::{Isl21aElement, Isl21aNodes, Isl21aState, IslContact, LinearLaw};
/// use jointproof::element::Parameters;
/// use nalgebra::{Vector1, Vector2};
/// let place = |r: f64, z: f64| Vector2::new(r, z);
/// let washer = [place(1.0, 0.0), place(5.0, 0.0)];
/// // A ring presses from above by 1/8, and has been dragged along by 1/4.
/// let nodes = Isl21aNodes::new([place(2.25, -0.125), place(2.75, -0.125)], [washer; 2]);
/// let ring = Parameters::<Isl21aElement<PressureLinear>, f64, 1, 12> {
///     start: LinearLaw { k: 1000.0 },
///     contact: Some(IslContact { k_stick: 5000.0, mu: 0.25 }),
/// };
/// let before = Isl21aState { g: Vector2::new(-0.5, -0.25), s12: Vector2::zeros() };
/// let (step, after) = ring.newton(&nodes, &Vector1::zeros(), &before)?;
/// assert_eq!(after.s12[0], 31.25); // it slips: 0.25 × the pressure of 125
/// assert_eq!(step.residuals[0], 125.0 * 2.0 * std::f64::consts::PI * (2.75_f64.powi(3) - 2.25_f64.powi(3)) / 3.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
pub type Isl21aElement<P> = Isl<Straight, P, 2, 8>;

/// ISL22A over parabolic segments as an element: twenty-four degrees of freedom.
pub type Isl22aElement<P> = Isl<Curved, P, 3, 12>;

/// Which degree of freedom of the element is the k-th of those of all slave nodes and of the segment under this one.
fn degree<const N: usize>(slave: usize, k: usize) -> usize {
    if k < 2 * N { k } else { k + 2 * N * slave }
}

impl<S, P, const N: usize, const L: usize, const K: usize> Element<1, K> for Isl<S, P, N, L>
where
    S: Segment<N, L, K>,
    P: PressureLaw,
{
    const SPEC: Spec = Spec::new(
        P::NAMES[N - 2][0],
        P::NAMES[N - 2][1],
        Document::SLIDE_LINE
            .ours("Element output", "the section names pressure and shear stress, and prints no forces"),
    )
    .eta_of_value(4.0)
    .normwise_of_value(4.0);
    const UNKNOWNS: &'static [Field] = S::UNKNOWNS;
    const FORCES: &'static [Field] = S::FORCES;
    const RESIDUALS: &'static [Field] = &[Field::new("torque", &TORQUE)];
    const MULTIPLIERS: &'static [Field] = &[];
    const SLAVES: usize = N;
    type Nodes<T: Component> = S::Nodes<T>;
    type Start<T: Component> = P::Parameters<T>;
    type Contact<T: Component> = IslContact<T>;
    type State<T: Component> = S::State<T>;

    fn moved<D: Scalar>(nodes: &S::Nodes<D>, motions: &SVector<D, K>) -> S::Nodes<D> {
        let all = components(nodes, D::zero());
        let mut moved = all.as_ref().iter().zip(motions).map(|(&x, &u)| x + u);
        Fields::from_components(&mut || moved.next().expect("every component moves"))
    }

    fn validate<D: Scalar>(nodes: &S::Nodes<D>, _: &Parameters<Self, D, 1, K>) -> Result<(), Error> {
        let all = components(nodes, D::zero());
        let place = |node: usize| Vector2::new(all.as_ref()[2 * node], all.as_ref()[2 * node + 1]);
        let named = |node: usize| (S::Nodes::<f64>::FIELDS[node].name, place(node));
        (0..N + N * N).try_for_each(|node| check_radii([named(node)]))?;
        (0..N).try_for_each(|slave| {
            let first = N + N * slave;
            check_distinct::<D, N>(std::array::from_fn(|k| named(first + k)))?;
            S::check(place(slave), std::array::from_fn(|k| place(first + k)))
        })
    }

    fn contribution<D: Scalar>(
        nodes: &S::Nodes<D>,
        _: &SVector<D, 1>,
        parameters: &Parameters<Self, D, 1, K>,
        before: &S::State<D>,
    ) -> (Contribution<D, 1, K>, S::State<D>) {
        let Points { slaves, segments } = S::varied(nodes);
        let (areas, places) = (S::areas(&slaves), slaves.map(|x| x.map(|x| x.value)));
        let mut found =
            Contribution::<D, 1, K>::smooth(SVector::zeros(), SMatrix::zeros(), SVector::zeros(), SMatrix::zeros());
        let mut after = components(before, D::zero());
        let pressures: [_; N] = std::array::from_fn(|slave| {
            let [g_before, s12_before] = [slave, N + slave].map(|k| after.as_ref()[k]);
            let (xs, segment) = (slaves[slave], &segments[slave]);
            let Touched { g, separation } = S::touched(xs, segment);
            let slip = S::path_length(xs, segment, g_before, g);
            // A choice for each, so that each is recorded alike for every slave node.
            let [is_inside] = choice(|| {
                let is_inside = S::is_inside(places[slave], segment.map(|x| x.map(|x| x.value)), g.value);
                [if is_inside { D::one() } else { D::zero() }]
            });
            // The stresses, and the derivatives of S11 with respect to E11, and of S12 with respect to E11 and to the slip.
            let [s11, s11_by_e11] = choice(|| {
                if is_inside > 0.0 {
                    let [s11, by_h] = P::pressure(-separation.value, &parameters.start);
                    [s11, -by_h]
                } else {
                    [D::zero(); 2]
                }
            });
            let [s12, s12_by_e11, s12_by_slip] = choice(|| match parameters.contact {
                Some(IslContact { k_stick, mu }) if s11 > 0.0 => {
                    let motion = Sliding { du: slip.value, f_before: s12_before, k_stick, mu, r#fn: s11 };
                    let (s12, by_slip, [by_e11]) = motion.under([s11_by_e11]);
                    [s12, by_e11, by_slip]
                }
                _ => [D::zero(); 3],
            });
            (after.as_mut()[slave], after.as_mut()[N + slave]) = (g.value, s12);
            let s11 = Term::new(s11, separation.slope * s11_by_e11);
            let s12 = Term::new(s12, separation.slope * s12_by_e11 + slip.slope * s12_by_slip);
            let (on_slave, on_line) = S::forces(segment, g, [areas[slave], s11, s12]);
            let on_slave = (2 * slave..).zip(&on_slave);
            for (k, force) in on_slave.chain((2 * N..).zip(on_line.iter().flatten())) {
                let row = degree::<N>(slave, k);
                found.forces[row] += force.value;
                for (k, &by) in force.slope.iter().enumerate() {
                    found.stiffness[(row, degree::<N>(slave, k))] += by;
                }
            }
            s11
        });
        let (torque, by_slaves, by_pressures) = S::torque(&places, &pressures.map(|s11| s11.value));
        found.residuals[0] = torque;
        for (k, by) in by_slaves.into_iter().enumerate() {
            found.rows.fixed_view_mut::<1, 2>(0, 2 * k).copy_from(&by.transpose());
        }
        for (slave, (s11, by_pressure)) in pressures.into_iter().zip(by_pressures).enumerate() {
            for (k, &by) in s11.slope.iter().enumerate() {
                found.rows[degree::<N>(slave, k)] += by * by_pressure;
            }
        }
        let mut state = after.as_ref().iter().copied();
        (found, Fields::from_components(&mut || state.next().expect("every component is followed")))
    }
}
