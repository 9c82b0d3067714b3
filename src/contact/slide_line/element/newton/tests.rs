//! The stiffness equals the derivative of the forces by automatic differentiation in 237 bits, in stick, in slip and open; and
//! forces and states equal those of `isl`.

use super::{Isl21a, Isl22a, LineContact, OnLine, Pressed, PressureLaw, SlaveState};
use crate::contact::isl::{Contact, ElementSet, Increment, Interaction, IslElement};
use crate::contact::slide_line::{Interpolation, Nodes, SlideLine};
use crate::number::scalar::Scalar;
use crate::{Error, Octuple};
use nalgebra::{SVector, Vector2};
use num_dual::Dual;

const STICKS: LineContact = LineContact { law: PressureLaw::Linear { k: 64.0 }, k_stick: 0.5, mu: 0.25 };
const SLIPS: LineContact = LineContact { k_stick: 1e3, ..STICKS };
const SOFT: LineContact = LineContact { law: PressureLaw::Exponential { c0: 0.5, p0: 20.0 }, ..SLIPS };

fn at(r: f64, z: f64) -> Vector2<f64> {
    Vector2::new(r, z)
}

/// A ring of two nodes that presses on two inclined segments, raised by `height`.
fn ring(height: f64) -> OnLine<f64, 2> {
    let nodes = [at(2.0, 0.25 + height), at(3.5, 0.75 + height)];
    OnLine { nodes, segments: [[at(1.0, 0.0), at(3.0, 1.0)], [at(3.0, 1.0), at(5.0, 1.25)]] }
}

/// A ring of three nodes that presses on one arch, raised by `height`.
fn arched(height: f64) -> OnLine<f64, 3> {
    let nodes = [at(1.5, 0.25 + height), at(2.25, 0.75 + height), at(3.0, 0.5 + height)];
    OnLine { nodes, segments: [[at(1.0, 0.0), at(2.25, 1.0), at(4.0, 0.5)]; 3] }
}

/// The state before the motion.
fn before<const N: usize>() -> [SlaveState<f64>; N] {
    [SlaveState { g: 0.25, s12: 0.125 }; N]
}

/// The positions converted to another type of number.
fn places<A: nalgebra::Scalar + Copy, B, const N: usize>(x: &OnLine<A, N>, of: impl Fn(usize, A) -> B) -> OnLine<B, N> {
    let point = |x: &Vector2<A>, node: usize| Vector2::new(of(2 * node, x.x), of(2 * node + 1, x.y));
    let nodes = std::array::from_fn(|k| point(&x.nodes[k], k));
    OnLine {
        nodes,
        segments: std::array::from_fn(|s| std::array::from_fn(|k| point(&x.segments[s][k], N + N * s + k))),
    }
}

fn state<D: Scalar, const N: usize>(of: impl Fn(f64) -> D) -> [SlaveState<D>; N] {
    before().map(|SlaveState { g, s12 }| SlaveState { g: of(g), s12: of(s12) })
}

/// The largest difference between derivatives and automatic differentiation, and the largest derivative.
fn furthest<const N: usize, const K: usize>(
    ring: &OnLine<f64, N>,
    exact: impl Fn(&OnLine<Octuple, N>, &[SlaveState<Octuple>; N]) -> Pressed<Octuple, N, K>,
    moving: impl Fn(&OnLine<Dual<Octuple>, N>, &[SlaveState<Dual<Octuple>>; N]) -> Pressed<Dual<Octuple>, N, K>,
) -> [f64; 2] {
    let here = places(ring, |_, x| Octuple::from(x));
    let found = exact(&here, &state(Octuple::from));
    let (mut off, mut largest) = (0.0_f64, 0.0_f64);
    for column in 0..K {
        let moved = places(&here, |k, x| Dual::new(x, Octuple::from(if k == column { 1.0 } else { 0.0 })));
        let moved = moving(&moved, &state(|x| Dual::from_re(Octuple::from(x))));
        let entries = found.stiffness.column(column);
        let forces = moved.forces.iter().zip(&entries).map(|(f, &k)| (f.eps, k));
        for (by, entry) in forces.chain([(moved.torque.eps, found.torque_row[column])]) {
            off = off.max((by - entry).to_f64().abs());
            largest = largest.max(entry.to_f64().abs());
        }
    }
    [off, largest]
}

#[test]
fn the_stiffness_of_isl21a_is_the_derivative_of_its_forces() {
    for (contact, height) in [(STICKS, 0.0), (SLIPS, 0.0), (SOFT, 0.0), (SOFT, 0.4)] {
        let element = Isl21a(contact);
        let [off, largest] =
            furthest(&ring(height), |x, s| element.contribution(x, s), |x, s| element.contribution(x, s));
        assert!(off < 1e-60 * largest && largest > 1.0, "{contact:?}: {off:e} of {largest}");
    }
}

#[test]
fn the_stiffness_of_isl22a_is_the_derivative_of_its_forces() {
    for (contact, height) in [(STICKS, 0.0), (SLIPS, 0.0), (SOFT, 0.0), (SOFT, 0.3)] {
        let element = Isl22a(contact);
        let [off, largest] =
            furthest(&arched(height), |x, s| element.contribution(x, s), |x, s| element.contribution(x, s));
        assert!(off < 1e-60 * largest && largest > 1.0, "{contact:?}: {off:e} of {largest}");
    }
}

#[test]
fn what_is_open_or_past_an_end_transmits_nothing() {
    let element = Isl21a(STICKS);
    let open = element.contribution(&ring(2.0), &before());
    assert_eq!((open.forces, open.stiffness.amax(), open.torque), (SVector::zeros(), 0.0, 0.0));
    let mut past = ring(0.0);
    past.nodes[0] = at(0.0, -2.0);
    let past = element.contribution(&past, &before());
    assert_eq!((past.pressures[0], past.forces[0], past.after[0].s12), (0.0, 0.0, 0.0));
    assert!(past.pressures[1] > 0.0);
}

#[test]
fn friction_makes_the_matrix_unsymmetric_in_slip() {
    let skew = |contact| {
        let k = Isl21a(contact).contribution(&ring(0.0), &before()).stiffness;
        (k - k.transpose()).amax() / k.amax()
    };
    assert!(skew(SLIPS) > 0.1);
}

/// The nodes of the line are 1, 2, …, those of the element 11, 12, ….
fn numbered<const N: usize>(places: &OnLine<f64, N>) -> Nodes<f64> {
    let slaves = places.nodes.iter().enumerate().map(|(k, x)| (11 + k, *x));
    let masters = places.segments[0].iter().enumerate().map(|(k, x)| (1 + k, *x));
    let number = |k: usize| u32::try_from(k).unwrap();
    Nodes::new(slaves.chain(masters).map(|(k, x)| (number(k), [x.x, x.y]))).unwrap()
}

/// Two increments by `isl` and by the element on one segment: forces, pressures, shear stresses and torque agree.
fn agrees<const N: usize, const K: usize>(
    [line, element]: [Interpolation; 2],
    isl: IslElement,
    [start, pressed, dragged]: [OnLine<f64, N>; 3],
    element_of: impl Fn(&OnLine<f64, N>, &[SlaveState<f64>; N]) -> Result<Pressed<f64, N, K>, Error>,
) {
    assert_eq!(line, element);
    let master = SlideLine::generate(line, 1, u32::try_from(N).unwrap(), 1).unwrap();
    let interaction = Interaction::linear(64.0).unwrap().with_friction(0.25, 1e3).unwrap();
    let contact = Contact::new(master, ElementSet::new("ring", [isl]).unwrap(), interaction);
    let step = Increment::new(1.0).unwrap();
    let at_start = contact.start(numbered(&start)).unwrap();
    let mut theirs = contact.advance(&at_start, numbered(&pressed), &step).unwrap();
    let open = [SlaveState { g: 0.0, s12: 0.0 }; N];
    let mut ours = element_of(&start, &open).unwrap();
    for places in [&pressed, &dragged] {
        ours = element_of(places, &ours.after).unwrap();
        if places == &dragged {
            theirs = contact.advance(&theirs, numbered(places), &step).unwrap();
        }
        for (k, (pressure, after)) in ours.pressures.iter().zip(&ours.after).enumerate() {
            let node = theirs.node(u32::try_from(11 + k).unwrap()).unwrap();
            assert!((node.s11 - pressure).abs() < 1e-12 && (node.s12 - after.s12).abs() < 1e-11, "{k}: {node:?}");
            assert!((node.force() - ours.forces.fixed_rows::<2>(2 * k)).amax() < 1e-10);
        }
        assert!((contact.torque(&theirs).unwrap() - ours.torque).abs() < 1e-10 * ours.torque);
    }
    assert!(ours.after.iter().any(|after| after.s12.abs() > 0.1));
}

#[test]
fn increments_are_those_of_isl() {
    let straight = |shift: f64, height: f64| OnLine {
        nodes: [at(2.0 + shift, 0.25 + height), at(3.5 + shift, 0.75 + height)],
        segments: [[at(1.0, 0.0), at(5.0, 2.0)]; 2],
    };
    agrees(
        [Interpolation::Linear; 2],
        IslElement::isl21a(1, [11, 12]).unwrap(),
        [straight(0.0, 1.0), straight(0.0, 0.0), straight(0.05, 0.01)],
        |x, s| Isl21a(SLIPS).newton(x, s),
    );
    let curved = |shift: f64, height: f64| {
        let places = arched(height);
        OnLine { nodes: places.nodes.map(|x| x + at(shift, 0.0)), ..places }
    };
    agrees(
        [Interpolation::Parabolic; 2],
        IslElement::isl22a(1, [11, 12, 13]).unwrap(),
        [curved(0.0, 1.0), curved(0.0, 0.0), curved(0.02, 0.01)],
        |x, s| Isl22a(SLIPS).newton(x, s),
    );
}

#[test]
fn what_is_not_valid_is_refused() {
    let refused = |contact: LineContact, places| Isl21a(contact).newton(&places, &before()).unwrap_err().to_string();
    let soft = LineContact { law: PressureLaw::Linear { k: 0.0 }, ..STICKS };
    assert_eq!(refused(soft, ring(0.0)), "k is 0.0; allowed is a finite number > 0");
    let rough = LineContact { mu: -1.0, ..STICKS };
    assert_eq!(refused(rough, ring(0.0)), "mu is -1.0; allowed is a finite number ≥ 0");
    let mut folded = ring(0.0);
    folded.segments[1][1] = folded.segments[1][0];
    assert!(refused(STICKS, folded).contains("x2"));
    let mut inside_out = ring(0.0);
    inside_out.nodes[1].x = -1.0;
    assert_eq!(refused(STICKS, inside_out), "x2[0] is -1.0; allowed is a finite number ≥ 0");
    let of_three = |places| Isl22a(STICKS).newton(&places, &before()).unwrap_err().to_string();
    let [mut folded, mut inside_out] = [arched(0.0); 2];
    folded.segments[2][2] = folded.segments[2][1];
    assert_eq!(of_three(folded), "x2 and x3 are 0.0 apart; allowed is a distance ≥ 2.2250738585072014e-308");
    inside_out.nodes[1].x = -1.0;
    assert_eq!(of_three(inside_out), "x2[0] is -1.0; allowed is a finite number ≥ 0");
}
