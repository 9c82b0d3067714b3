//! Checks beyond the audit of elements: terms in velocities, penalties, other unknowns, and the convergence of SLIDER.

use super::slider::rows::{GeometricStiffness, SliderLoads};
use super::slider::{self, SliderElement};
use super::slot::{SlotContact, SlotElement, SlotStart, SlotState};
use super::translator::{TranslatorElement, TranslatorStart};
use super::ujoint::{Cross, UJointContact, UJointElement, UJointStart, UJointState};
use crate::Octuple;
use crate::element::cardan::rotation;
use crate::element::motion::{Motion, Moving, still};
use crate::element::products::skew;
use crate::element::rotation::proof::{from_euler, rodrigues};
use crate::element::{Contribution, Element, Forces, Nodes, Nothing, Parameters};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{Scalar, constant};
use nalgebra::{Matrix3, SMatrix, SVector, Vector2, Vector3, Vector4};
use num_dual::{Dual, Dual2};

fn slot<D: Scalar>(contact: Option<SlotContact<D>>) -> Parameters<SlotElement, D, 2> {
    Parameters { start: SlotStart { x0: 0.125.into(), y0: 0.25.into(), z0: (-0.5).into() }, contact }
}

fn translator<D: Scalar>() -> Parameters<TranslatorElement, D, 5> {
    let [x0, y0, z0, alpha0, beta0, gamma0] = [0.125, 0.25, -0.5, 0.4, 0.2, -0.6].map(D::from);
    Parameters { start: TranslatorStart { x0, y0, z0, alpha0, beta0, gamma0 }, contact: None }
}

fn ujoint<D: Scalar>(contact: Option<UJointContact<D>>) -> Parameters<UJointElement, D, 4> {
    let d0 = Vector3::new(0.5, 0.25, 0.125).map(D::from);
    Parameters { start: UJointStart { d0, c0: 0.0.into(), alpha0: 0.1.into(), gamma0: (-0.2).into() }, contact }
}

/// Two separate nodes, rotated relative to each other and to the global axes.
fn nodes() -> Nodes<Octuple> {
    let exact = |m: Matrix3<f64>| [0, 1, 2].map(|k| m.column(k).map(Octuple::from));
    let a = rotation(0.3, -0.5, 0.7);
    let place = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(Octuple::from);
    Nodes::new([exact(a), exact(a * rotation(0.4, 0.2, -0.6))], [place(1.0, 2.0, 3.0), place(2.5, 2.25, 4.0)])
}

/// The nodes under a motion.
fn moving(nodes: &Nodes<Octuple>, motion: &Motion) -> Nodes<Moving> {
    let triads = [nodes.a().map(|e| motion.of_a(e)), nodes.b().map(|e| motion.of_b(e))];
    Nodes::new(triads, motion.places([nodes.xa, nodes.xb]))
}

/// A vector with the derivative 1 in one component, if one is given.
fn growing<const N: usize>(x: SVector<Octuple, N>, component: Option<usize>) -> SVector<Moving, N> {
    SVector::from_fn(|k, _| Dual::new(x[k], Octuple::from(if component == Some(k) { 1.0 } else { 0.0 })))
}

/// The component of a degree of freedom within a part of `size` components, if it belongs to that part.
fn within(degree: usize, part: usize, size: usize) -> Option<usize> {
    (degree / size == part).then_some(degree % size)
}

/// The nodes moving with constant velocities, to second order in time.
fn flying(nodes: &Nodes<Octuple>, velocities: &Forces<Octuple>) -> Nodes<Dual2<Octuple>> {
    let part = |k: usize| velocities.fixed_rows::<3>(k).into_owned();
    let place = |x: Vector3<Octuple>, v: Vector3<Octuple>| x.zip_map(&v, |x, v| Dual2::new(x, v, Octuple::from(0.0)));
    let axis = |e: Vector3<Octuple>, spin: Vector3<Octuple>| {
        let first = spin.cross(&e);
        e.zip_zip_map(&first, &spin.cross(&first), Dual2::new)
    };
    let (of_a, of_b) = (part(3), part(9));
    Nodes::new(
        [nodes.a().map(|e| axis(e, of_a)), nodes.b().map(|e| axis(e, of_b))],
        [place(nodes.xa, part(0)), place(nodes.xb, part(6))],
    )
}

/// The difference between the velocity term and the second time derivative of the residuals.
fn off_in_time<E, const M: usize>(
    still: &Parameters<E, Octuple, M>,
    flying_by: &Parameters<E, Dual2<Octuple>, M>,
) -> f64
where
    E: Element<M, 12, Nodes<Octuple> = Nodes<Octuple>, Nodes<Dual2<Octuple>> = Nodes<Dual2<Octuple>>>,
{
    let velocities = Forces::from_fn(|k, _| {
        Octuple::from([1.0, -2.0, 0.5, 0.25, 3.0, -1.0][k % 6] * if k < 6 { 1.0 } else { -1.5 })
    });
    let term = still.velocity_term(&nodes(), &velocities);
    let at_rest = Fields::filled(Dual2::from_re(Octuple::from(0.0)));
    let (found, _) = flying_by.contribution(&flying(&nodes(), &velocities), &SVector::zeros(), &at_rest);
    found.residuals.iter().zip(&term).map(|(residual, &term)| (residual.v2 - term).to_f64().abs()).fold(0.0, f64::max)
}

#[test]
fn the_velocity_term_is_what_residuals_do_without_acceleration() {
    assert!(off_in_time(&slot(None), &slot(None)) < 1e-60);
    assert!(off_in_time(&translator(), &translator()) < 1e-60);
    assert!(off_in_time(&ujoint(None), &ujoint(None)) < 1e-60);
}

#[test]
fn with_penalties_the_stiffness_is_the_derivative_of_the_forces() {
    fn rubbing<D: Scalar>() -> Parameters<SlotElement, D, 2> {
        slot(Some(SlotContact { k_stick: 1e3.into(), fc_int: 1.0.into(), mu: 0.25.into() }))
    }
    let exact = |numbers: [f64; 2]| SVector::from(numbers.map(Octuple::from));
    let (multipliers, penalties) = (exact([3.0, -4.0]), exact([100.0, 300.0]));
    let before = SlotState { u1: Octuple::from(0.5), f1: Octuple::from(-0.25) };
    let (found, _) = rubbing().penalised(&nodes(), &multipliers, &penalties, &before);
    for (k, motion) in Motion::alone().iter().flatten().enumerate() {
        let (multipliers, penalties) = (multipliers.map(still), penalties.map(still));
        let before = SlotState { u1: still(before.u1), f1: still(before.f1) };
        let (moved, _) = rubbing().penalised(&moving(&nodes(), motion), &multipliers, &penalties, &before);
        for (force, &entry) in moved.forces.iter().zip(&found.stiffness.column(k)) {
            assert!((force.eps - entry).to_f64().abs() < 1e-55);
        }
    }
    let residuals = rubbing().contribution(&nodes(), &multipliers, &before).0.residuals;
    assert_eq!(found.multipliers, multipliers - penalties.component_mul(&residuals));
}

/// The distance from the solution at each step of Newton's method: three loaded nodes on springs, held by SLIDER, with the
/// derivative of its forces or with Σ λ ∂²g.
fn errors_of_slider(with_its_own_derivative: bool) -> Vec<f64> {
    let rest = SVector::<f64, 9>::from([0.0, 0.0, 0.0, 4.0, 1.0, -1.0, 1.0, 0.5, 1.0]);
    let loads = SVector::<f64, 9>::from([0.0, 1.0, -2.0, 0.0, 3.0, 1.0, 2.0, -4.0, 3.0]);
    let springs = SVector::<f64, 9>::from([9.0, 9.0, 9.0, 8.0, 8.0, 8.0, 7.0, 7.0, 7.0]);
    let (mut x, mut multipliers, mut steps) = (rest, Vector2::zeros(), Vec::new());
    for _ in 0..12 {
        let [x1, xn, xm] = [0, 3, 6].map(|k| x.fixed_rows::<3>(k).into_owned());
        let slider = Parameters::<SliderElement, f64, 2, 9> { start: Nothing::new(), contact: None };
        let (found, _) = slider.newton(&slider::Nodes { x1, xn, xm }, &multipliers, &Nothing::new()).unwrap();
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
    // An error in the residual reappears one step later: it is squared in two steps, not in one.
    let errors = errors_of_slider(false);
    assert!(!is_squared(&errors, 100.0) && errors[8] < 1e-14, "{errors:?}");
}

/// The contribution of a UJOINT with friction, with nodes at these positions and rotated by these matrices, both functions of
/// other unknowns.
fn turned<D: Scalar<Leaf = Octuple>>(places: [Vector3<D>; 2], turns: [Matrix3<D>; 2]) -> Contribution<D, 4> {
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
    let contact = UJointContact::new(cross, [1e3, 0.125]).components();
    let contact = Fields::from_slice(&contact.into_iter().map(D::from).collect::<Vec<_>>());
    let turn = |turn: Matrix3<D>, axes: [Vector3<Octuple>; 3]| axes.map(|e| turn * e.map(constant::<D>));
    let nodes = Nodes::new([turn(turns[0], nodes().a()), turn(turns[1], nodes().b())], places);
    let multipliers = Vector4::new(3.0, -4.0, 12.0, 5.0).map(D::from);
    ujoint(contact).contribution(&nodes, &multipliers, &UJointState::filled(D::zero())).0
}

/// The largest deviation of the rows and the stiffness from the derivatives of residuals and forces with respect to these
/// unknowns.
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

/// Rotation vectors are coordinates, so that the second derivative of λ·g with respect to them is symmetric; with respect to
/// spins it is not.
#[test]
fn by_rotation_vectors_the_stiffness_without_friction_is_symmetric() {
    let psi = [[0.5, -1.0, 0.25], [1.5, 2.0, -1.0]].map(|x| Vector3::from(x).map(Octuple::from));
    let turned = [(nodes().a(), psi[0]), (nodes().b(), psi[1])].map(|(axes, psi)| axes.map(|e| rodrigues(&psi) * e));
    let (found, _) = translator().contribution(
        &Nodes::new(turned, [nodes().xa, nodes().xb]),
        &SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]).map(Octuple::from),
        &SlotState::filled(Octuple::from(0.0)),
    );
    let asymmetry =
        |k: SMatrix<Octuple, 12, 12>| (k - k.transpose()).iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    assert!(asymmetry(found.stiffness) > 1.0);
    assert!(asymmetry(found.by_rotation_vectors(psi).stiffness) < 1e-60);
}

/// K + ½ \[m×\] in the diagonal blocks of the spins, and K elsewhere.
#[test]
fn the_symmetric_stiffness_adds_half_of_the_moments() {
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]).map(Octuple::from);
    let (found, _) = translator().contribution(&nodes(), &multipliers, &SlotState::filled(Octuple::from(0.0)));
    let mut expected = found.stiffness;
    for spin in [3, 9] {
        let moment: Vector3<Octuple> = found.forces.fixed_rows::<3>(spin).into_owned();
        let mut block = expected.fixed_view_mut::<3, 3>(spin, spin);
        block += skew(&moment) * Octuple::from(0.5);
    }
    let off = (found.symmetric().stiffness - expected).iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    assert!(off < 1e-60, "{off:e}");
}

/// The rotation of a quaternion of any length.
fn by_quaternion<D: Scalar>(q: &Vector4<D>) -> Matrix3<D> {
    let unit = q / q.dot(q).sqrt();
    from_euler(unit[0], &unit.fixed_rows::<3>(1).into_owned())
}

#[test]
fn by_euler_parameters_it_is_its_own_derivative() {
    let places = [[1.0, 2.0, 3.0], [2.5, 2.25, 4.0]].map(|x| Vector3::from(x).map(Octuple::from));
    // Unit quaternions of multiples of 1/7 and of 1/9.
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
