//! Each contribution is the derivative of its own forces and residuals, by automatic differentiation in 237 bits, in stick and in
//! slip.

use super::{
    AlignElement, Contribution, CrossContact, Element, JoinElement, Nodes, SliderElement, SliderElement2d, SlotContact,
    SlotElement, SlotElement2d, TranslatorContact, TranslatorElement, UJointElement, UJointState, UniversalElement,
};
use crate::Octuple;
use crate::connector::cardan::rotation;
use crate::connector::slider;
use crate::connector::ujoint::Cross;
use crate::element::Forces;
use crate::element::motion::{Motion, Moving, still};
use crate::element::products::skew;
use crate::element::rotation::proof::{from_euler, rodrigues};
use crate::element::slider::{GeometricStiffness, SliderLoads};
use crate::element::slot_plane::PlanePlaces;
use crate::formula::Formula;
use crate::number::scalar::{Scalar, constant};
use nalgebra::{Matrix3, SMatrix, SVector, Vector1, Vector2, Vector3, Vector4};
use num_dual::{Dual, Dual2};

const SLOT: SlotElement = SlotElement { start: Vector3::new(0.125, 0.25, -0.5), contact: None };
const TRANSLATOR: TranslatorElement =
    TranslatorElement { start: Vector3::new(0.125, 0.25, -0.5), angles0: [0.4, 0.2, -0.6], contact: None };
const UJOINT: UJointElement =
    UJointElement { d0: Vector3::new(0.5, 0.25, 0.125), c0: 0.0, angles0: [0.1, -0.2], contact: None };

/// Two nodes apart, turned against each other and off the global axes.
fn nodes() -> Nodes<Octuple> {
    let exact = |m: Matrix3<f64>| [0, 1, 2].map(|k| m.column(k).map(Octuple::from));
    let a = rotation(0.3, -0.5, 0.7);
    let place = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(Octuple::from);
    Nodes { a: exact(a), b: exact(a * rotation(0.4, 0.2, -0.6)), xa: place(1.0, 2.0, 3.0), xb: place(2.5, 2.25, 4.0) }
}

/// The nodes as they move.
fn moving(nodes: &Nodes<Octuple>, motion: &Motion) -> Nodes<Moving> {
    let [xa, xb] = motion.places([nodes.xa, nodes.xb]);
    Nodes { a: nodes.a.map(|e| motion.of_a(e)), b: nodes.b.map(|e| motion.of_b(e)), xa, xb }
}

/// A state that does not move.
trait Still<S> {
    fn still(&self) -> S;
}

impl Still<Moving> for Octuple {
    fn still(&self) -> Moving {
        still(*self)
    }
}

impl Still<()> for () {
    fn still(&self) {}
}

impl Still<UJointState<Moving>> for UJointState<Octuple> {
    fn still(&self) -> UJointState<Moving> {
        UJointState { turns: self.turns.map(still), slip: self.slip.map(still) }
    }
}

/// Nodes of which one degree of freedom after the other moves.
trait Movable<E: Element<N, DOFS>, const N: usize, const DOFS: usize> {
    fn moved(&self, degree: usize) -> E::Nodes<Moving>;
}

impl<E: Element<N, 12, Nodes<Moving> = Nodes<Moving>>, const N: usize> Movable<E, N, 12> for Nodes<Octuple> {
    fn moved(&self, degree: usize) -> Nodes<Moving> {
        moving(self, &Motion::alone()[degree / 3][degree % 3])
    }
}

/// A vector, of which a component may grow.
fn growing<const N: usize>(x: SVector<Octuple, N>, component: Option<usize>) -> SVector<Moving, N> {
    SVector::from_fn(|k, _| Dual::new(x[k], Octuple::from(if component == Some(k) { 1.0 } else { 0.0 })))
}

/// The component of the part of so many that a degree of freedom is.
fn within(degree: usize, part: usize, size: usize) -> Option<usize> {
    (degree / size == part).then_some(degree % size)
}

impl Movable<SlotElement2d, 1, 6> for PlanePlaces<Octuple> {
    fn moved(&self, degree: usize) -> PlanePlaces<Moving> {
        let place = |x, part| growing(x, within(degree, part, 3).filter(|&k| k < 2));
        let spin = Octuple::from(if degree == 2 { 1.0 } else { 0.0 });
        let e2a = Vector2::new(Dual::new(self.e2a.x, -self.e2a.y * spin), Dual::new(self.e2a.y, self.e2a.x * spin));
        PlanePlaces { e2a, xa: place(self.xa, 0), xb: place(self.xb, 1) }
    }
}

impl Movable<SliderElement, 2, 9> for slider::Nodes<Octuple> {
    fn moved(&self, degree: usize) -> slider::Nodes<Moving> {
        let place = |x, part| growing(x, within(degree, part, 3));
        slider::Nodes { x1: place(self.x1, 0), xn: place(self.xn, 1), xm: place(self.xm, 2) }
    }
}

impl Movable<SliderElement2d, 1, 6> for slider::Nodes2d<Octuple> {
    fn moved(&self, degree: usize) -> slider::Nodes2d<Moving> {
        let place = |x, part| growing(x, within(degree, part, 2));
        slider::Nodes2d { x1: place(self.x1, 0), xn: place(self.xn, 1), xm: place(self.xm, 2) }
    }
}

/// The largest difference between a contribution's derivatives and those of its forces and residuals, of two nodes.
fn furthest<E, const N: usize>(element: &E, multipliers: SVector<f64, N>, before: E::State<Octuple>) -> f64
where
    E: Element<N, 12, Nodes<Octuple> = Nodes<Octuple>, Nodes<Moving> = Nodes<Moving>>,
    E::State<Octuple>: Still<E::State<Moving>>,
{
    furthest_at(element, &nodes(), multipliers, before, |found| found)
}

/// The same of any nodes, with a mistake that is planted in what was found.
fn furthest_at<E, P, const N: usize, const DOFS: usize>(
    element: &E,
    nodes: &P,
    multipliers: SVector<f64, N>,
    before: E::State<Octuple>,
    plant: impl Fn(Contribution<Octuple, N, DOFS>) -> Contribution<Octuple, N, DOFS>,
) -> f64
where
    E: Element<N, DOFS, Nodes<Octuple> = P>,
    P: Movable<E, N, DOFS>,
    E::State<Octuple>: Still<E::State<Moving>>,
{
    let multipliers = multipliers.map(Octuple::from);
    let found = plant(element.contribution(nodes, &multipliers, &before).0);
    let here = before.still();
    let mut furthest = 0.0_f64;
    let mut compare = |left: Octuple, right: Octuple| furthest = furthest.max((left - right).to_f64().abs());
    for k in 0..DOFS {
        let (moved, _) = element.contribution(&nodes.moved(k), &multipliers.map(still), &here);
        moved.forces.iter().zip(&found.stiffness.column(k)).for_each(|(force, &entry)| compare(force.eps, entry));
        moved.residuals.iter().zip(&found.rows.column(k)).for_each(|(residual, &entry)| compare(residual.eps, entry));
        moved.forces.iter().zip(&found.forces).for_each(|(force, &value)| compare(force.re, value));
    }
    for k in 0..N {
        // Any motion will do for the numbers, if its derivatives are not asked for.
        let still_nodes = nodes.moved(DOFS - 1);
        let rate = |loaded: SVector<Moving, N>| element.contribution(&still_nodes, &loaded, &here).0.forces;
        let (loaded, unloaded) = (rate(growing(multipliers, Some(k))), rate(multipliers.map(still)));
        let entries = found.by_multipliers.column(k);
        loaded.iter().zip(&unloaded).zip(&entries).for_each(|((f, g), &entry)| compare(f.eps - g.eps, entry));
    }
    furthest
}

/// The nodes as they move with constant velocities, in the second order of time.
fn flying(nodes: &Nodes<Octuple>, velocities: &Forces<Octuple>) -> Nodes<Dual2<Octuple>> {
    let part = |k: usize| velocities.fixed_rows::<3>(k).into_owned();
    let place = |x: Vector3<Octuple>, v: Vector3<Octuple>| x.zip_map(&v, |x, v| Dual2::new(x, v, Octuple::from(0.0)));
    let axis = |e: Vector3<Octuple>, spin: Vector3<Octuple>| {
        let first = spin.cross(&e);
        e.zip_zip_map(&first, &spin.cross(&first), Dual2::new)
    };
    let (of_a, of_b) = (part(3), part(9));
    Nodes {
        a: nodes.a.map(|e| axis(e, of_a)),
        b: nodes.b.map(|e| axis(e, of_b)),
        xa: place(nodes.xa, part(0)),
        xb: place(nodes.xb, part(6)),
    }
}

/// The velocity term against the second time derivative of the residuals.
fn off_in_time<E, const N: usize>(element: &E, rest: E::State<Octuple>, moving: E::State<Dual2<Octuple>>) -> f64
where
    E: Element<N, 12, Nodes<Octuple> = Nodes<Octuple>, Nodes<Dual2<Octuple>> = Nodes<Dual2<Octuple>>>,
{
    let velocities = Forces::from_fn(|k, _| {
        Octuple::from([1.0, -2.0, 0.5, 0.25, 3.0, -1.0][k % 6] * if k < 6 { 1.0 } else { -1.5 })
    });
    let term = element.velocity_term(&nodes(), &velocities, &rest);
    let (found, _) = element.smooth().contribution(&flying(&nodes(), &velocities), &SVector::zeros(), &moving);
    found.residuals.iter().zip(&term).map(|(residual, &term)| (residual.v2 - term).to_f64().abs()).fold(0.0, f64::max)
}

#[test]
fn the_velocity_term_is_what_residuals_do_without_acceleration() {
    let zero = Octuple::from(0.0);
    let flat = Dual2::from_re(zero);
    assert!(off_in_time(&SLOT, zero, flat) < 1e-60);
    assert!(off_in_time(&TRANSLATOR, zero, flat) < 1e-60);
    let rest = UJointState { turns: [zero; 2], slip: [zero; 2] };
    assert!(off_in_time(&UJOINT, rest, UJointState { turns: [flat; 2], slip: [flat; 2] }) < 1e-60);
}

#[test]
fn with_penalties_the_stiffness_is_the_derivative_of_the_forces() {
    let slot = SlotElement { contact: Some(SlotContact { k_el: 1e3, fc_int: 1.0, mu: 0.25 }), ..SLOT };
    let exact = |numbers: [f64; 2]| SVector::from(numbers.map(Octuple::from));
    let (multipliers, penalties, before) = (exact([3.0, -4.0]), exact([100.0, 300.0]), Octuple::from(0.5));
    let (found, _) = slot.penalised(&nodes(), &multipliers, &penalties, &before);
    for (k, motion) in Motion::alone().iter().flatten().enumerate() {
        let (multipliers, penalties) = (multipliers.map(still), penalties.map(still));
        let (moved, _) = slot.penalised(&moving(&nodes(), motion), &multipliers, &penalties, &still(before));
        for (force, &entry) in moved.forces.iter().zip(&found.stiffness.column(k)) {
            assert!((force.eps - entry).to_f64().abs() < 1e-55);
        }
    }
    let residuals = slot.contribution(&nodes(), &multipliers, &before).0.residuals;
    assert_eq!(found.multipliers, multipliers - penalties.component_mul(&residuals));
}

fn symmetric<const N: usize>(found: &Contribution<Octuple, N>) -> bool {
    found.by_multipliers == found.rows.transpose()
}

#[test]
fn connectors_without_friction_are_their_own_derivatives() {
    let multipliers = SVector::from([3.0, -4.0, 2.0]);
    assert!(furthest(&JoinElement { d0: Vector3::new(0.5, 0.25, 0.125) }, multipliers, ()) < 1e-60);
    assert!(furthest(&AlignElement { angles0: [0.1, 0.2, 0.3] }, multipliers, ()) < 1e-60);
    assert!(furthest(&UniversalElement { c0: 0.25 }, Vector1::new(3.0), ()) < 1e-60);
}

#[test]
fn slot_in_the_plane_is_its_own_derivative() {
    let exact = |x: f64, y: f64| Vector2::new(x, y).map(Octuple::from);
    let nodes = PlanePlaces { e2a: exact(-0.6, 0.8), xa: exact(1.0, 2.0), xb: exact(2.5, 2.25) };
    let smooth = SlotElement2d { start: Vector2::new(0.25, -0.5), contact: None };
    let rough = |k_el| SlotElement2d { contact: Some(SlotContact { k_el, fc_int: 1.0, mu: 0.25 }), ..smooth };
    for element in [smooth, rough(0.125), rough(1e3)] {
        assert!(
            furthest_at(&element, &nodes, Vector1::new(-4.0), Octuple::from(0.5), |found| found) < 1e-60,
            "{element:?}"
        );
    }
}

#[test]
fn slider_on_the_line_is_its_own_derivative() {
    let (x1, d) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(2.0, -1.0, 4.0));
    let [x1, xn, xm] = [x1, x1 + d, x1 + d * 0.25].map(|x| x.map(Octuple::from));
    let nodes = slider::Nodes { x1, xn, xm };
    assert!(furthest_at(&SliderElement, &nodes, Vector2::new(3.0, -4.0), (), |found| found) < 1e-60);
    let [x1, xn, xm] = [x1, xn, xm].map(|x| x.xy());
    assert!(
        furthest_at(&SliderElement2d, &slider::Nodes2d { x1, xn, xm }, Vector1::new(3.0), (), |found| found) < 1e-60
    );
}

/// How far from the solution each step of Newton's method is: three nodes on springs, loaded, and held by SLIDER, with the
/// derivative of its forces or with Σ λ ∂²g.
fn errors_of_slider(with_its_own_derivative: bool) -> Vec<f64> {
    let rest = SVector::<f64, 9>::from([0.0, 0.0, 0.0, 4.0, 1.0, -1.0, 1.0, 0.5, 1.0]);
    let loads = SVector::<f64, 9>::from([0.0, 1.0, -2.0, 0.0, 3.0, 1.0, 2.0, -4.0, 3.0]);
    let springs = SVector::<f64, 9>::from([9.0, 9.0, 9.0, 8.0, 8.0, 8.0, 7.0, 7.0, 7.0]);
    let (mut x, mut multipliers, mut steps) = (rest, Vector2::zeros(), Vec::new());
    for _ in 0..12 {
        let [x1, xn, xm] = [0, 3, 6].map(|k| x.fixed_rows::<3>(k).into_owned());
        let (found, ()) = SliderElement.newton(&slider::Nodes { x1, xn, xm }, &multipliers, &()).unwrap();
        let load = SliderLoads { x1, xn, xm, lambda_1: multipliers.x, lambda_2: multipliers.y };
        let geometric = GeometricStiffness::eval(&load).matrix();
        let k = if with_its_own_derivative { found.stiffness } else { geometric };
        let mut matrix = SMatrix::<f64, 11, 11>::zeros();
        matrix.fixed_view_mut::<9, 9>(0, 0).copy_from(&(k - SMatrix::from_diagonal(&springs)));
        matrix.fixed_view_mut::<9, 2>(0, 9).copy_from(&found.by_multipliers);
        matrix.fixed_view_mut::<2, 9>(9, 0).copy_from(&found.rows);
        let mut off = SVector::<f64, 11>::zeros();
        off.fixed_rows_mut::<9>(0).copy_from(&(found.forces + loads - springs.component_mul(&(x - rest))));
        off.fixed_rows_mut::<2>(9).copy_from(&found.residuals);
        let step = matrix.lu().solve(&-off).unwrap();
        x += step.fixed_rows::<9>(0);
        multipliers += step.fixed_rows::<2>(9);
        steps.push((x, multipliers));
    }
    let (end, _) = steps[steps.len() - 1];
    steps.into_iter().map(|(x, _)| (x - end).norm()).collect()
}

#[test]
fn slider_converges_quadratically_with_its_own_derivative() {
    let is_squared = |errors: &[f64], factor: f64| errors.windows(2).all(|e| e[1] < factor * e[0] * e[0] + 1e-14);
    assert!(is_squared(&errors_of_slider(true), 2.0), "{:?}", errors_of_slider(true));
    // An error in the residual comes back a step later: two steps square it, not one.
    let errors = errors_of_slider(false);
    assert!(!is_squared(&errors, 100.0) && errors[8] < 1e-14, "{errors:?}");
}

/// Both nodes of a rubbing UJOINT as other unknowns turn them, and what it adds by these.
fn turned<D: Scalar<Leaf = Octuple>>(places: [Vector3<D>; 2], turns: [Matrix3<D>; 2]) -> Contribution<D, 4> {
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
    let element = UJointElement { contact: Some(CrossContact { cross, k_el1: 1e3, k_el3: 0.125 }), ..UJOINT };
    let Nodes { a, b, .. } = nodes();
    let turn = |turn: Matrix3<D>, axes: [Vector3<Octuple>; 3]| axes.map(|e| turn * e.map(constant::<D>));
    let nodes = Nodes { a: turn(turns[0], a), b: turn(turns[1], b), xa: places[0], xb: places[1] };
    let zero = D::zero();
    let multipliers = Vector4::new(3.0, -4.0, 12.0, 5.0).map(D::from);
    element.contribution(&nodes, &multipliers, &UJointState { turns: [zero; 2], slip: [zero; 2] }).0
}

/// How far the rows and the stiffness are from the derivatives of residuals and forces by these unknowns.
fn furthest_by<const DOFS: usize>(
    found: &Contribution<Octuple, 4, DOFS>,
    moved: impl Fn(usize) -> Contribution<Moving, 4, DOFS>,
) -> f64 {
    let mut furthest = 0.0_f64;
    let mut compare = |left: Octuple, right: Octuple| furthest = furthest.max((left - right).to_f64().abs());
    for k in 0..DOFS {
        let moved = moved(k);
        moved.forces.iter().zip(&found.stiffness.column(k)).for_each(|(force, &entry)| compare(force.eps, entry));
        moved.residuals.iter().zip(&found.rows.column(k)).for_each(|(residual, &entry)| compare(residual.eps, entry));
    }
    furthest
}

#[test]
fn by_rotation_vectors_it_is_its_own_derivative() {
    let [xa, xb, psi_a, psi_b] = [[1.0, 2.0, 3.0], [2.5, 2.25, 4.0], [0.5, -1.0, 0.25], [1.5, 2.0, -1.0]]
        .map(|x| Vector3::from(x).map(Octuple::from));
    let found = turned([xa, xb], [rodrigues(&psi_a), rodrigues(&psi_b)]).by_rotation_vectors([psi_a, psi_b]);
    let moved = |k: usize| {
        let [xa, psi_a, xb, psi_b]: [Vector3<Moving>; 4] =
            [(xa, 0), (psi_a, 1), (xb, 2), (psi_b, 3)].map(|(x, part)| growing(x, within(k, part, 3)));
        turned([xa, xb], [rodrigues(&psi_a), rodrigues(&psi_b)]).by_rotation_vectors([psi_a, psi_b])
    };
    assert!(furthest_by(&found, moved) < 1e-60);
}

/// Rotation vectors are coordinates, so that the second derivative of λ·g by them is symmetric; by spins it is not.
#[test]
fn by_rotation_vectors_the_stiffness_without_friction_is_symmetric() {
    let psi = [[0.5, -1.0, 0.25], [1.5, 2.0, -1.0]].map(|x| Vector3::from(x).map(Octuple::from));
    let Nodes { a, b, xa, xb } = nodes();
    let [a, b] = [(a, psi[0]), (b, psi[1])].map(|(axes, psi)| axes.map(|e| rodrigues(&psi) * e));
    let (found, _) = TRANSLATOR.contribution(
        &Nodes { a, b, xa, xb },
        &SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]).map(Octuple::from),
        &Octuple::from(0.0),
    );
    let asymmetry =
        |k: SMatrix<Octuple, 12, 12>| (k - k.transpose()).iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    assert!(asymmetry(found.stiffness) > 1.0);
    assert!(asymmetry(found.by_rotation_vectors(psi).stiffness) < 1e-60);
}

/// K + ½ \[m×\] in the blocks of own spins, and K elsewhere.
#[test]
fn the_symmetric_stiffness_adds_half_of_the_moments() {
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]).map(Octuple::from);
    let (found, _) = TRANSLATOR.contribution(&nodes(), &multipliers, &Octuple::from(0.0));
    let mut expected = found.stiffness;
    for spin in [3, 9] {
        let moment: Vector3<Octuple> = found.forces.fixed_rows::<3>(spin).into_owned();
        let mut block = expected.fixed_view_mut::<3, 3>(spin, spin);
        block += skew(&moment) * Octuple::from(0.5);
    }
    let off = (found.symmetric().stiffness - expected).iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    assert!(off < 1e-60, "{off:e}");
}

/// The turn by a quaternion of any length.
fn by_quaternion<D: Scalar>(q: &Vector4<D>) -> Matrix3<D> {
    let unit = q / q.dot(q).sqrt();
    from_euler(unit[0], &unit.fixed_rows::<3>(1).into_owned())
}

#[test]
fn by_euler_parameters_it_is_its_own_derivative() {
    let places = [[1.0, 2.0, 3.0], [2.5, 2.25, 4.0]].map(|x| Vector3::from(x).map(Octuple::from));
    // Of whole numbers of a seventh, and of a ninth.
    let parameters = [([2.0, 3.0, 6.0, 0.0], 7.0), ([4.0, -4.0, 7.0, 0.0], 9.0)]
        .map(|(q, length)| Vector4::from(q).map(|x| Octuple::from(x) / Octuple::from(length)));
    let found = turned(places, parameters.map(|q| by_quaternion(&q))).by_euler_parameters(parameters);
    let moved = |k: usize| {
        let places = [0, 1].map(|n| growing(places[n], k.checked_sub(7 * n).filter(|&k| k < 3)));
        let parameters = [0, 1].map(|n| growing(parameters[n], k.checked_sub(7 * n + 3).filter(|&k| k < 4)));
        turned(places, parameters.map(|q| by_quaternion(&q))).by_euler_parameters(parameters)
    };
    assert!(furthest_by(&found, moved) < 1e-60);
}

#[test]
fn slot_is_its_own_derivative() {
    let slot = SLOT;
    let rough = |k_el| SlotElement { contact: Some(SlotContact { k_el, fc_int: 1.0, mu: 0.25 }), ..slot };
    let (multipliers, before) = (SVector::from([3.0, -4.0]), Octuple::from(0.5));
    for element in [slot, rough(0.125), rough(1e3)] {
        assert!(furthest(&element, multipliers, before) < 1e-60, "{element:?}");
    }
    assert!(symmetric(&slot.contribution(&nodes(), &multipliers.map(Octuple::from), &before).0));
    assert!(!symmetric(&rough(1e3).contribution(&nodes(), &multipliers.map(Octuple::from), &before).0));
}

#[test]
fn translator_is_its_own_derivative() {
    let smooth = TRANSLATOR;
    let contact = |k_el| TranslatorContact { k_el, rr: 0.5, l: 2.0, fc_int: 1.0, mu: 0.25 };
    let rough = |k_el| TranslatorElement { contact: Some(contact(k_el)), ..smooth };
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]);
    for element in [smooth, rough(0.125), rough(1e3)] {
        assert!(furthest(&element, multipliers, Octuple::from(0.5)) < 1e-60, "{element:?}");
    }
}

#[test]
fn ujoint_is_its_own_derivative() {
    let smooth = UJOINT;
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
    let rough = |k_el1, k_el3| UJointElement { contact: Some(CrossContact { cross, k_el1, k_el3 }), ..smooth };
    let before = UJointState { turns: [0.0, 6.0], slip: [-1.0, 8.0] }.map();
    for element in [smooth, rough(0.125, 0.125), rough(1e3, 0.125), rough(1e3, 1e3)] {
        assert!(furthest(&element, SVector::from([3.0, -4.0, 12.0, 5.0]), before) < 1e-60, "{element:?}");
    }
}

impl UJointState<f64> {
    fn map(self) -> UJointState<Octuple> {
        UJointState { turns: self.turns.map(Octuple::from), slip: self.slip.map(Octuple::from) }
    }
}

/// Whether a mistake in an element that slips is found.
fn is_caught<E, const N: usize>(
    element: &E,
    multipliers: SVector<f64, N>,
    before: E::State<Octuple>,
    plant: impl Fn(Contribution<Octuple, N>) -> Contribution<Octuple, N>,
) -> bool
where
    E: Element<N, 12, Nodes<Octuple> = Nodes<Octuple>, Nodes<Moving> = Nodes<Moving>>,
    E::State<Octuple>: Still<E::State<Moving>> + Copy,
{
    furthest_at(element, &nodes(), multipliers, before, plant) > 1e-3
}

/// Mistakes that are made by hand, in an element that slips; `stuck` is the same element while it sticks.
fn mistakes_are_caught<E, const N: usize>(slips: &E, stuck: &E, multipliers: SVector<f64, N>, before: E::State<Octuple>)
where
    E: Element<N, 12, Nodes<Octuple> = Nodes<Octuple>, Nodes<Moving> = Nodes<Moving>>,
    E::State<Octuple>: Still<E::State<Moving>> + Copy,
{
    let exact = multipliers.map(Octuple::from);
    let of = |element: &E| element.contribution(&nodes(), &exact, &before).0;
    let (right, sticking) = (of(slips), of(stuck));
    let wrong = |planted: Contribution<Octuple, N>| is_caught(slips, multipliers, before, |_| planted);
    assert!(!wrong(right));
    assert!(wrong(Contribution { stiffness: sticking.stiffness, ..right }), "the stiffness of stick in slip");
    assert!(
        wrong(Contribution { by_multipliers: sticking.by_multipliers, ..right }),
        "as if friction followed nothing"
    );
    assert!(wrong(Contribution { stiffness: right.stiffness.transpose(), ..right }), "transposed");
    let half = Octuple::from(0.5);
    let symmetric = (right.stiffness + right.stiffness.transpose()) * half;
    assert!(wrong(Contribution { stiffness: symmetric, ..right }), "symmetrised, as by rotation vectors");
    assert!(wrong(Contribution { forces: -right.forces, ..right }), "the other sign");
    for (row, column) in (0..16).map(|k| (k / 4 * 3, k % 4 * 3)) {
        let mut stiffness = right.stiffness;
        stiffness.fixed_view_mut::<3, 3>(row, column).fill(Octuple::from(0.0));
        let is_empty = stiffness == right.stiffness;
        assert!(is_empty || wrong(Contribution { stiffness, ..right }), "without the block at {row}, {column}");
    }
    for row in 0..N {
        let mut rows = right.rows;
        rows.row_mut(row).neg_mut();
        assert!(wrong(Contribution { rows, ..right }), "the other sign of row {row}");
    }
}

#[test]
fn mistakes_that_are_planted_are_caught() {
    let slot = |k_el| SlotElement { contact: Some(SlotContact { k_el, fc_int: 1.0, mu: 0.25 }), ..SLOT };
    mistakes_are_caught(&slot(1e3), &slot(0.125), SVector::from([3.0, -4.0]), Octuple::from(0.5));
    let contact = |k_el| TranslatorContact { k_el, rr: 0.5, l: 2.0, fc_int: 1.0, mu: 0.25 };
    let translator = |k_el| TranslatorElement { contact: Some(contact(k_el)), ..TRANSLATOR };
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]);
    mistakes_are_caught(&translator(1e3), &translator(0.125), multipliers, Octuple::from(0.5));
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
    let ujoint = |k_el| UJointElement { contact: Some(CrossContact { cross, k_el1: k_el, k_el3: k_el }), ..UJOINT };
    let before = UJointState { turns: [0.0, 6.0], slip: [-1.0, 8.0] }.map();
    mistakes_are_caught(&ujoint(1e3), &ujoint(0.125), SVector::from([3.0, -4.0, 12.0, 5.0]), before);
}

/// Whether multipliers are refused by the formulas that take them.
fn refuses<E: Element<N, Nodes<f64> = Nodes<f64>, State<f64> = ()>, const N: usize>(e: &E, at: &Nodes<f64>) -> bool {
    matches!(e.newton(at, &SVector::repeat(f64::NAN), &()), Err(crate::Error::NonFinite { .. }))
}

#[test]
fn what_is_not_valid_is_refused() {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let nodes = Nodes { a: axes, b: axes, xa: Vector3::zeros(), xb: Vector3::x() };
    let slot = SlotElement { start: Vector3::zeros(), contact: Some(SlotContact { k_el: 0.0, fc_int: 0.0, mu: 0.25 }) };
    let refused =
        |found: Result<_, crate::Error>| found.map(|_: (Contribution<f64, 2>, f64)| ()).unwrap_err().to_string();
    assert_eq!(refused(slot.newton(&nodes, &SVector::zeros(), &0.0)), "k_el is 0.0; allowed is a finite number > 0");
    let smooth = SlotElement { contact: None, ..slot };
    let lost = Nodes { xb: Vector3::new(f64::NAN, 0.0, 0.0), ..nodes };
    assert_eq!(refused(smooth.newton(&lost, &SVector::zeros(), &0.0)), "xb[0] is NaN; allowed is a finite number");
    assert!(refuses(&AlignElement { angles0: [0.1, 0.2, -0.3] }, &nodes));
    assert!(refuses(&JoinElement { d0: Vector3::y() }, &nodes) && refuses(&UniversalElement { c0: 0.0 }, &nodes));
    let found = UJOINT.newton(&nodes, &SVector::repeat(f64::NAN), &UJointState { turns: [0.0; 2], slip: [0.0; 2] });
    assert!(matches!(found, Err(crate::Error::NonFinite { .. })));
}
