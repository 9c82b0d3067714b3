//! Rings on a slide line as elements: the inputs they reject, the ends of a segment, and the increments of `isl`.

use jointproof::contact::interaction::PressureLinear;
use jointproof::contact::isl::{Contact, ElementSet, Increment, Interaction, IslElement};
use jointproof::contact::slide_line::element::{
    Isl21aElement, Isl21aNodes, Isl21aState, Isl22aElement, Isl22aNodes, Isl22aState, IslContact, LinearLaw,
};
use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
use jointproof::element::{Element, Parameters};
use jointproof::formula::Fields;
use nalgebra::{Vector1, Vector2, Vector3};

const LINE: IslContact<f64> = IslContact { k_stick: 0.5, mu: 0.25 };
const NARROW: Parameters<Isl21aElement<PressureLinear>, f64, 1, 12> =
    Parameters { start: LinearLaw { k: 64.0 }, contact: Some(LINE) };
const BROAD: Parameters<Isl22aElement<PressureLinear>, f64, 1, 24> =
    Parameters { start: LinearLaw { k: 64.0 }, contact: Some(LINE) };
const TWO: Isl21aState<f64> = Isl21aState { g: Vector2::new(0.0, 0.0), s12: Vector2::new(0.25, 0.25) };
const THREE: Isl22aState<f64> = Isl22aState { g: Vector3::new(0.0, 0.0, 0.0), s12: Vector3::new(0.25, 0.25, 0.25) };
const NONE: Vector1<f64> = Vector1::new(0.0);

fn at(r: f64, z: f64) -> Vector2<f64> {
    Vector2::new(r, z)
}

/// A ring of two nodes under a flat washer from 1 to 3, with its first node at this point.
fn narrow(first: Vector2<f64>) -> Isl21aNodes<f64> {
    Isl21aNodes::new([first, at(2.5, -0.125)], [[at(1.0, 0.0), at(3.0, 0.0)]; 2])
}

/// A ring of three nodes under the same washer as a parabolic segment.
fn broad(first: Vector2<f64>) -> Isl22aNodes<f64> {
    Isl22aNodes::new([first, at(2.25, -0.125), at(2.5, -0.125)], [[at(1.0, 0.0), at(2.0, 0.0), at(3.0, 0.0)]; 3])
}

#[test]
fn where_nothing_presses_no_shear_follows_anything() {
    let above = Isl21aNodes { xs1: at(1.5, 0.125), xs2: at(2.5, 0.125), ..narrow(at(1.5, 0.125)) };
    let (found, after) = NARROW.newton(&above, &NONE, &TWO).unwrap();
    assert_eq!(after.s12.map(f64::to_bits), Vector2::new(0, 0));
    assert_eq!((found.forces.amax(), found.stiffness.amax(), found.residuals[0]), (0.0, 0.0, 0.0));
}

/// A straight segment ends on both sides.
#[test]
fn past_either_end_of_a_straight_segment_nothing_is_transmitted() {
    for (r, g, transmits) in [(0.75, -1.25, false), (1.0, -1.0, true), (3.0, 1.0, true), (3.25, 1.25, false)] {
        let (found, after) = NARROW.newton(&narrow(at(r, -0.125)), &NONE, &TWO).unwrap();
        assert_eq!(after.g[0], g, "{r}");
        assert_eq!((after.s12[0] != 0.0, found.forces[1] > 0.0), (transmits, transmits), "{r}");
        assert_eq!(found.forces.fixed_rows::<4>(4).amax() > 0.0, transmits, "{r}");
        assert!(after.s12[1] != 0.0 && found.forces[3] > 0.0);
    }
}

/// The search on a parabolic segment stops at its ends: a node past an end and one above it have the same closest point.
#[test]
fn past_either_end_of_a_parabolic_segment_nothing_is_transmitted() {
    let inside = 1.0 - 2.0_f64.powi(-20);
    for (r, g, transmits) in [
        (0.75, -1.0, false),
        (1.0, -1.0, true),
        (2.0 - inside, -inside, true),
        (2.0 + inside, inside, true),
        (3.0, 1.0, true),
        (3.25, 1.0, false),
    ] {
        let (found, after) = BROAD.newton(&broad(at(r, -0.125)), &NONE, &THREE).unwrap();
        assert_eq!(after.g[0], g, "{r}");
        assert_eq!((after.s12[0] != 0.0, found.forces[1] > 0.0), (transmits, transmits), "{r}");
        assert_eq!(found.forces.fixed_rows::<6>(6).amax() > 0.0, transmits, "{r}");
    }
}

#[test]
fn what_is_not_valid_is_refused() {
    let (flat, bent) = (narrow(at(2.0, -0.125)), broad(at(2.0, -0.125)));
    let refused = |k, contact, nodes: Isl21aNodes<f64>| {
        let mut ring = NARROW;
        (ring.start.k, ring.contact) = (k, Some(contact));
        ring.newton(&nodes, &NONE, &TWO).unwrap_err().to_string()
    };
    assert_eq!(refused(0.0, LINE, flat), "k is 0.0; allowed is a finite number > 0");
    assert_eq!(
        refused(1.0, IslContact { k_stick: 0.0, ..LINE }, flat),
        "k_stick is 0.0; allowed is a finite number > 0"
    );
    assert_eq!(refused(1.0, IslContact { mu: -1.0, ..LINE }, flat), "mu is -1.0; allowed is a finite number ≥ 0");
    let least = "allowed is a distance ≥ 2.2250738585072014e-308";
    assert_eq!(
        refused(1.0, LINE, Isl21aNodes { x22: flat.x21, ..flat }),
        format!("x21 and x22 are 0.0 apart; {least}")
    );
    let inside_out = Isl21aNodes { xs2: at(-1.0, 0.0), ..flat };
    assert_eq!(refused(1.0, LINE, inside_out), "xs2[0] is -1.0; allowed is a finite number ≥ 0");
    let folded = Isl22aNodes { x33: bent.x32, ..bent };
    let said = BROAD.newton(&folded, &NONE, &THREE).unwrap_err().to_string();
    assert_eq!(said, format!("x32 and x33 are 0.0 apart; {least}"));
}

/// A torque that overflows although all forces and derivatives are finite, and a derivative that overflows although the torque is
/// finite.
#[test]
fn a_ring_tells_that_forces_or_a_torque_overflow() {
    for (k, unit, depth) in [(1e270, 1e10, 1e10), (1e308, 1.0, 1e-6)] {
        let ring = Parameters { start: LinearLaw { k }, ..NARROW };
        let washer = [at(1.0, 0.0) * unit, at(3.0, 0.0) * unit];
        let nodes = Isl21aNodes::new([at(2.0 * unit, -depth), at(2.5 * unit, -depth)], [washer; 2]);
        let error = ring.newton(&nodes, &NONE, &TWO).map(|_| ()).unwrap_err();
        assert_eq!(error.found(), "contribution is too large for a double", "{k:e}");
        let (found, _) = ring.contribution(&nodes, &NONE, &TWO);
        let finite = found.forces.iter().chain(&found.stiffness).chain(&found.rows).all(|x| x.is_finite());
        assert_ne!(finite, found.residuals[0].is_finite(), "{k:e}");
    }
}

/// The slave nodes as 11, 12, …, and those of the first segment as 1, 2, ….
fn numbered<const N: usize>(nodes: &impl Fields<f64>) -> Nodes<f64> {
    let all = nodes.components();
    let place = |(number, k): (usize, usize)| (u32::try_from(number).unwrap(), [all[2 * k], all[2 * k + 1]]);
    Nodes::new((0..N).flat_map(|k| [(11 + k, k), (1 + k, N + k)]).map(place)).unwrap()
}

/// Two increments by `isl` and by the element on one segment: forces, shear stresses and torque agree.
fn agrees<E: Element<1, DOFS>, const N: usize, const DOFS: usize>(
    line: Interpolation,
    isl: IslElement,
    element: Parameters<E, f64, 1, DOFS>,
    [start, pressed, dragged]: [E::Nodes<f64>; 3],
) {
    let master = SlideLine::generate(line, 1, u32::try_from(N).unwrap(), 1).unwrap();
    let interaction = Interaction::linear(64.0).unwrap().with_friction(0.25, 1e3).unwrap();
    let contact = Contact::new(master, ElementSet::new("ring", [isl]).unwrap(), interaction);
    let mut theirs = contact.start(numbered::<N>(&start)).unwrap();
    let (_, mut state) = element.newton(&start, &NONE, &E::State::filled(0.0)).unwrap();
    for nodes in [pressed, dragged] {
        let (ours, after) = element.newton(&nodes, &NONE, &state).unwrap();
        theirs = contact.advance(&theirs, numbered::<N>(&nodes), &Increment::new(1.0).unwrap()).unwrap();
        state = after;
        for (k, s12) in state.components().split_off(N).into_iter().enumerate() {
            let node = theirs.node(u32::try_from(11 + k).unwrap()).unwrap();
            assert!((node.s12 - s12).abs() < 1e-11 && s12.abs() > 0.1, "{k}: {node:?}");
            assert!((node.force() - ours.forces.fixed_rows::<2>(2 * k)).amax() < 1e-10);
        }
        assert!((contact.torque(&theirs).unwrap() - ours.residuals[0]).abs() < 1e-10 * ours.residuals[0]);
    }
}

#[test]
fn increments_are_those_of_isl() {
    let rough = Some(IslContact { k_stick: 1e3, mu: 0.25 });
    let places = [at(0.0, 1.0), at(0.0, 0.0), at(0.05, 0.01)];
    let straight = places.map(|shift| {
        Isl21aNodes::new([at(2.0, 0.25), at(3.5, 0.75)].map(|x| x + shift), [[at(1.0, 0.0), at(5.0, 2.0)]; 2])
    });
    let isl = IslElement::isl21a(1, [11, 12]).unwrap();
    agrees::<_, 2, 12>(Interpolation::Linear, isl, Parameters { contact: rough, ..NARROW }, straight);
    let arch = [at(1.0, 0.0), at(2.25, 1.0), at(4.0, 0.5)];
    let curved = places
        .map(|shift| Isl22aNodes::new([at(1.5, 0.25), at(2.25, 0.75), at(3.0, 0.5)].map(|x| x + shift), [arch; 3]));
    let isl = IslElement::isl22a(1, [11, 12, 13]).unwrap();
    agrees::<_, 3, 24>(Interpolation::Parabolic, isl, Parameters { contact: rough, ..BROAD }, curved);
}
