//! ISL21A and ISL22A as a program uses them, and what they reject.

#![expect(clippy::float_cmp, reason = "exact results are expected exactly")]

use jointproof::contact::interaction::{Damping, DampingContact, ExponentialContact, PressureExponential};
use jointproof::contact::isl::{Contact, ContactState, ElementSet, Increment, Interaction, IslElement, TorquePrint};
use jointproof::contact::slide_line::{Interpolation, LinearMotion, Nodes, Place, SlideLine, SlipIncrementLinear};
use jointproof::formula::value;
use jointproof::{Error, Octuple};
use nalgebra::Vector2;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// A flat line from (1, 0) to (5, 0), nodes 1 and 2, and an ISL21A with nodes 3 and 4.
fn flat(interaction: Interaction) -> Contact {
    let line = SlideLine::new(Interpolation::Linear, [1, 2]).unwrap();
    Contact::new(line, ElementSet::new("ring", [IslElement::isl21a(10, [3, 4]).unwrap()]).unwrap(), interaction)
}

/// The element at the height z, with its first node at the radius r.
fn ring(r: f64, z: f64) -> Nodes {
    Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [r, z]), (4, [r + 1.0, z])]).unwrap()
}

fn second() -> Increment {
    Increment::new(1.0).unwrap()
}

#[test]
fn bad_elements_and_steps_are_named() {
    let message = |error: Error| error.to_string();
    let twice = "has a node twice; allowed are different nodes";
    assert_eq!(message(IslElement::isl21a(8, [1, 1]).unwrap_err()), format!("element 8 {twice}"));
    assert_eq!(message(IslElement::isl22a(9, [1, 2, 1]).unwrap_err()), format!("element 9 {twice}"));
    assert_eq!(IslElement::isl22a(9, [1, 2, 3]).unwrap().number(), 9);
    let empty = ElementSet::new("flank", []).unwrap_err();
    assert_eq!(message(empty), "the element set flank is empty; allowed is at least one element");
    assert_eq!(message(Increment::new(0.0).unwrap_err()), "duration is 0.0; allowed is a finite number > 0");
    let pulling = second().with_pressures([(3, f64::NAN)]).unwrap_err();
    assert_eq!(message(pulling), "node 3 has the pressure NaN; allowed are finite pressures ≥ 0");
    let pulling = second().with_pressures([(3, 1.0), (4, -1.0)]).unwrap_err();
    assert_eq!(message(pulling), "node 4 has the pressure -1; allowed are finite pressures ≥ 0");
    assert!(second().with_pressures([(3, 0.0)]).is_ok());

    let contact = flat(Interaction::default());
    let start = contact.start(ring(2.0, 0.0)).unwrap();
    let elsewhere = second().with_pressures([(1, 5.0)]).unwrap();
    assert_eq!(
        message(contact.advance(&start, ring(2.0, 0.0), &elsewhere).unwrap_err()),
        "node 1 has a pressure, but no element; allowed are pressures of slave nodes"
    );
    assert_eq!(message(start.node(1).unwrap_err()), "node 1 is unknown; allowed are nodes with coordinates");
    let missing = Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [2.0, 0.0])]).unwrap();
    assert!(matches!(contact.start(missing), Err(Error::UnknownNode { node: 4 })));
    let flattened = Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [2.0, 0.0]), (4, [2.0, 0.0])]).unwrap();
    assert!(matches!(contact.start(flattened), Err(Error::CoincidentNodes { first: 3, second: 4 })));
}

#[test]
fn bad_interactions_are_named() {
    let message = |result: Result<Interaction, Error>| result.unwrap_err().to_string();
    assert_eq!(message(Interaction::hard(-1.0)), "tolerance is -1.0; allowed is a finite number ≥ 0");
    assert_eq!(message(Interaction::linear(0.0)), "k is 0.0; allowed is a finite number > 0");
    assert_eq!(message(Interaction::exponential(0.0, 1.0)), "c0 is 0.0; allowed is a finite number > 0");
    assert_eq!(message(Interaction::exponential(1.0, f64::NAN)), "p0 is NaN; allowed is a finite number > 0");
    let hard = Interaction::default();
    assert_eq!(message(hard.with_damping(-1.0, 1.0, 0.0)), "mu0 is -1.0; allowed is a finite number ≥ 0");
    assert_eq!(message(hard.with_damping(1.0, 0.0, 0.0)), "c0 is 0.0; allowed is a finite number > 0");
    assert_eq!(message(hard.with_damping(1.0, 1.0, 1.0)), "eta is 1.0; allowed is a number ≥ 0 and < 1");
    assert_eq!(message(hard.with_friction(0.1, 0.0)), "k_stick is 0.0; allowed is a finite number > 0");
}

/// Numbers that are exact in binary.
#[test]
fn an_interaction_says_what_presses_and_rubs() {
    let rubbing = |law: Interaction| law.with_friction(0.25, 64.0).unwrap();
    let [hard, soft] = [Interaction::hard(0.125), Interaction::exponential(0.5, 20.0)].map(|law| rubbing(law.unwrap()));
    let linear = rubbing(Interaction::linear(64.0).unwrap());
    let damped = linear.with_damping(16.0, 1.0, 0.5).unwrap();
    // The overclosure, the closing rate; the pressures, with 7 as the multiplier.
    for (h, v, expected) in [
        (0.25, 0.5, [7.0, 16.0, 24.0]),
        (0.25, -2.0, [7.0, 16.0, -16.0]),
        (-0.125, 1.0, [7.0, 0.0, 16.0]),
        (-0.25, 0.0, [0.0, 0.0, 0.0]),
        (-2.0, 1.0, [0.0, 0.0, 0.0]),
    ] {
        assert_eq!([hard, linear, damped].map(|law| law.pressure(h, v, 7.0)), expected, "{h} {v}");
    }
    assert_eq!([-0.5, 0.0].map(|h| soft.pressure(h, 0.0, 7.0)), [0.0, 20.0]);
    // It sticks, slips in either direction, and transmits nothing if the pressure is negative or there is no friction.
    for (s12, slip, p, expected) in [
        (0.5, 0.03125, 16.0, 2.5),
        (0.5, 0.25, 16.0, 4.0),
        (0.5, -0.25, 16.0, -4.0),
        (0.5, 0.0, 0.0, 0.0),
        (0.5, 0.25, -16.0, 0.0),
    ] {
        assert_eq!(damped.shear(s12, slip, p), expected, "{s12} {slip} {p}");
    }
    assert_eq!(Interaction::default().shear(0.5, 0.25, 16.0), 0.0);
}

#[test]
fn areas_add_up_at_shared_nodes() {
    let line = SlideLine::new(Interpolation::Linear, [1, 2]).unwrap();
    let elements = [IslElement::isl21a(10, [3, 4]).unwrap(), IslElement::isl21a(11, [4, 5]).unwrap()];
    let contact = Contact::new(line, ElementSet::new("two", elements).unwrap(), Interaction::default());
    let places = [(1, [0.0, 0.0]), (2, [9.0, 0.0]), (3, [1.0, 0.0]), (4, [2.0, 0.0]), (5, [4.0, 0.0])];
    let state = contact.start(Nodes::new(places).unwrap()).unwrap();
    let areas: Vec<_> = state.nodes().values().map(|node| node.area).collect();
    assert_eq!(areas, [PI, 2.0 * PI + 4.0 * PI, 8.0 * PI]);
}

/// The areas of nodes use the radius of the node; the figures are those of the book.
#[test]
fn areas_of_nodes_against_their_integrals() {
    let errors = |nodes: &[[f64; 2]]| -> Vec<f64> {
        let places = Nodes::new((1..).zip(nodes.iter().copied())).unwrap();
        let element = match nodes.len() {
            2 => IslElement::isl21a(1, [1, 2]).unwrap(),
            _ => IslElement::isl22a(1, [1, 2, 3]).unwrap(),
        };
        let weights = |g: f64| match nodes.len() {
            2 => vec![0.5 * (1.0 - g), 0.5 * (1.0 + g)],
            _ => vec![0.5 * g * (g - 1.0), 1.0 - g * g, 0.5 * g * (g + 1.0)],
        };
        let point = |g| -> Vector2<f64> { weights(g).iter().zip(nodes).map(|(n, x)| Vector2::from(*x) * *n).sum() };
        let (steps, mut integrals) = (4000, vec![0.0; nodes.len()]);
        for step in 0..steps {
            let at = |part: f64| -1.0 + 2.0 * (f64::from(step) + part) / f64::from(steps);
            let band = 2.0 * PI * point(at(0.5)).x * (point(at(1.0)) - point(at(0.0))).norm();
            integrals.iter_mut().zip(weights(at(0.5))).for_each(|(sum, n)| *sum += n * band);
        }
        let areas = element.areas(&places).unwrap();
        areas.iter().zip(&integrals).map(|(area, integral)| 100.0 * (area / integral - 1.0)).collect()
    };
    let expect = |nodes: &[[f64; 2]], percent: &[f64], to: f64| {
        let found = errors(nodes);
        assert!(found.iter().zip(percent).all(|(found, percent)| (found - percent).abs() < to), "{found:?}");
    };
    expect(&[[1.0, 0.0], [2.0, 0.0]], &[-25.0, 20.0], 1e-4);
    expect(&[[3.0, 0.0], [14.0, 0.0]], &[-55.0, 35.483_871], 1e-4);
    expect(&[[0.0, 0.0], [1.0, 0.0]], &[-100.0, 50.0], 1e-4);
    // On a straight ISL22A with the midside node in the middle there is no difference; at r = 1, 1.7 and 3 there is.
    expect(&[[1.0, 0.0], [1.5, 0.5], [2.0, 1.0]], &[0.0, 0.0, 0.0], 1e-4);
    expect(&[[1.0, 0.0], [1.7, 0.0], [3.0, 0.0]], &[257.0, -10.0, 10.0], 0.5);
    expect(&[[1.0, 0.0], [2.0 - FRAC_1_SQRT_2, FRAC_1_SQRT_2], [2.0, 1.0]], &[19.0, -9.15, 14.0], 0.05);
}

#[test]
fn hard_contact_presses_only_when_closed() {
    let contact = flat(Interaction::default());
    let pressed = second().with_pressures([(3, 20.0), (4, 30.0)]).unwrap();
    let start = contact.start(ring(2.0, 0.0)).unwrap();
    assert_eq!(start.node(3).unwrap().s11, 0.0);
    let pressures = |z| {
        let state = contact.advance(&start, ring(2.0, z), &pressed).unwrap();
        [3, 4].map(|node| state.node(node).unwrap().s11)
    };
    assert_eq!((pressures(0.0), pressures(-1e-9), pressures(1e-9)), ([20.0, 30.0], [20.0, 30.0], [0.0, 0.0]));
    // A node that is not named has no pressure.
    let one = second().with_pressures([(3, 20.0)]).unwrap();
    let state = contact.advance(&start, ring(2.0, 0.0), &one).unwrap();
    assert_eq!([3, 4].map(|node| state.node(node).unwrap().s11), [20.0, 0.0]);
    let tolerant = flat(Interaction::hard(1e-6).unwrap());
    assert_eq!(tolerant.advance(&start, ring(2.0, 1e-9), &pressed).unwrap().node(4).unwrap().s11, 30.0);
}

#[test]
fn the_laws_are_the_formulas() {
    let (c0, p0, mu0, eta) = (0.25, 40.0, 6.0, 0.5);
    let contact = flat(Interaction::exponential(c0, p0).unwrap().with_damping(mu0, c0, eta).unwrap());
    let start = contact.start(ring(2.0, 0.5)).unwrap();
    for z in [0.3, 0.2, 0.1, 0.0, -0.25] {
        let node =
            contact.advance(&start, ring(2.0, z), &Increment::new(0.5).unwrap()).unwrap().node(3).unwrap().clone();
        let law = value::<PressureExponential>(&ExponentialContact { h: -z, c0, p0 }).unwrap().p;
        let v = (0.5 - z) / 0.5;
        let damping = value::<Damping>(&DampingContact { h: -z, v, mu0, c0, eta }).unwrap().p;
        assert_eq!((node.e11, node.s11), (z, law + damping));
    }
}

#[test]
fn friction_sticks_slips_and_returns() {
    let contact = flat(Interaction::linear(100.0).unwrap().with_friction(0.5, 40.0).unwrap());
    let mut state = contact.start(ring(2.0, -0.25)).unwrap();
    // p = 25, so that it slips at S12 = 12.5; on the way back it sticks until the shear stress is reversed.
    let history = [(2.25, 0.25, 10.0), (2.5, 0.5, 12.5), (2.75, 0.75, 12.5), (2.5, 0.5, 2.5), (2.0, 0.0, -12.5)];
    for (r, e12, s12) in history {
        state = contact.advance(&state, ring(r, -0.25), &second()).unwrap();
        let node = state.node(3).unwrap();
        assert_eq!((node.e12, node.s11, node.s12), (e12, 25.0, s12), "at {r}");
        // Friction pushes back: along −r while S12 > 0.
        assert_eq!(node.force(), Vector2::new(-s12, 25.0) * node.area);
    }
    // After lift-off the shear stress is 0; the slip remains.
    state = contact.advance(&state, ring(2.5, 0.25), &second()).unwrap();
    let node = state.node(3).unwrap();
    assert_eq!((node.e12, node.s11, node.s12), (0.5, 0.0, 0.0));
}

#[test]
fn the_slip_is_the_way_along_the_line_and_a_common_motion_is_none() {
    let contact = flat(Interaction::linear(100.0).unwrap().with_friction(0.5, 40.0).unwrap());
    let start = contact.start(ring(2.0, -0.25)).unwrap();
    let places = [(1, [1.5, 0.0]), (2, [5.25, 0.5]), (3, [2.5, 0.0]), (4, [3.5, 0.25])];
    let state = contact.advance(&start, Nodes::new(places).unwrap(), &second()).unwrap();
    let node = state.node(3).unwrap();
    let Place::Segment { g, .. } = node.closest.place else { panic!() };
    // It was at g = -0.5. The line is now stretched and rotated; the formula gives the distance from there.
    let (x1, x2) = (Vector2::new(1.5, 0.0), Vector2::new(5.25, 0.5));
    let zero = Vector2::zeros();
    let motion = LinearMotion { x1, x2, g, dxs: (x2 - x1) * (0.5 * (g + 0.5)), dx1: zero, dx2: zero };
    assert_eq!(node.e12, value::<SlipIncrementLinear>(&motion).unwrap().dslip);

    let carried = [(1, [65.0, 3.0]), (2, [69.0, 3.0]), (3, [66.0, 2.75]), (4, [67.0, 2.75])];
    let state = contact.advance(&start, Nodes::new(carried).unwrap(), &second()).unwrap();
    assert_eq!((state.node(3).unwrap().e12, state.node(3).unwrap().s12), (0.0, 0.0));
}

/// A sharp corner of 90° at (2, 2), node 2, on a line that comes along the axis of r and turns to the left or right; next to it
/// the element 4, 5, of which node 4 is moved.
fn around(turn: f64, increments: u32, way: impl Fn(f64) -> [f64; 2]) -> f64 {
    let line = SlideLine::new(Interpolation::Linear, [1, 2, 3]).unwrap();
    let elements = ElementSet::new("ring", [IslElement::isl21a(10, [4, 5]).unwrap()]).unwrap();
    let contact = Contact::new(line, elements, Interaction::default());
    let places = |part: f64| {
        let master = [(1, [1.0, 2.0]), (2, [2.0, 2.0]), (3, [2.0, 2.0 + turn])];
        Nodes::new(master.into_iter().chain([(4, way(part)), (5, [1.0, 2.5])])).unwrap()
    };
    let mut state = contact.start(places(0.0)).unwrap();
    for increment in 1..=increments {
        state = contact.advance(&state, places(f64::from(increment) / f64::from(increments)), &second()).unwrap();
    }
    state.node(4).unwrap().e12
}

#[test]
fn the_slip_around_a_sharp_corner_does_not_depend_on_the_increments() {
    for turn in [-1.0, 1.0] {
        for increments in [1, 3, 9] {
            let way = |part: f64| [2.0 - (0.5 - part).max(0.0), 2.0 + turn * (part - 0.5).max(0.0)];
            let slip = around(turn, increments, way);
            assert!((slip - 1.0).abs() < 1e-15, "{slip} in {increments}");
        }
    }
}

/// The closest point determines the slip: a node that circles a corner at a distance does not move along the line.
#[test]
fn a_node_that_circles_a_corner_does_not_slip() {
    for increments in [1, 3, 9] {
        let circle = |part: f64| [2.0 + 0.25 * (part * PI / 2.0).sin(), 2.0 + 0.25 * (part * PI / 2.0).cos()];
        assert_eq!(around(-1.0, increments, circle), 0.0, "in {increments}");
    }
}

#[test]
fn stretch_and_rotation_of_the_line_are_no_slip() {
    let contact = flat(Interaction::default());
    let start = contact.start(ring(2.0, 0.25)).unwrap();
    // Node 3 stays at the material point a quarter along the line, which is stretched by half.
    let stretched = [(1, [1.0, 0.0]), (2, [7.0, 0.0]), (3, [2.5, 0.25]), (4, [3.0, 0.25])];
    let state = contact.advance(&start, Nodes::new(stretched).unwrap(), &second()).unwrap();
    assert_eq!(state.node(3).unwrap().e12, 0.0);
    // Everything is rotated together by 90° about (3, 0), with the node above the line.
    let turned = [(1, [3.0, -2.0]), (2, [3.0, 2.0]), (3, [2.75, -1.0]), (4, [2.75, 0.0])];
    let state = contact.advance(&start, Nodes::new(turned).unwrap(), &second()).unwrap();
    assert_eq!([3, 4].map(|node| state.node(node).unwrap().e12), [0.0, 0.0]);
}

/// On curves the distance is that of a fine polyline, whether in one increment or in many.
#[test]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number from 0 to 3")]
fn the_slip_on_curves_is_the_length_of_the_way() {
    let master = [[1.0, 2.0], [2.0, 1.25], [3.0, 1.0], [4.0, 1.5], [5.0, 2.5]];
    let nodes = Nodes::new((1..).zip(master)).unwrap();
    for (interpolation, smoothing) in [
        (Interpolation::Linear, 0.2),
        (Interpolation::Linear, 0.45),
        (Interpolation::Parabolic, 0.2),
        (Interpolation::Parabolic, 0.45),
    ] {
        let line = SlideLine::generate(interpolation, 1, 5, 1).unwrap().smoothed(smoothing).unwrap();
        let placed = line.place(&nodes).unwrap();
        // Near the line, so that the closest point does not jump.
        let slave = |part: f64| -> Vector2<f64> {
            let between = 0.25 + 3.5 * part;
            let [a, b] = [0, 1].map(|next| Vector2::from(master[between.floor() as usize + next]));
            a + (b - a) * between.fract() + Vector2::new(0.0, 0.02)
        };
        let at = |part: f64| placed.closest(slave(part)).unwrap();
        let foot = |part: f64| {
            let closest = at(part);
            slave(part) - closest.normal * closest.separation
        };
        let whole = placed.slip(&at(0.0), &at(1.0));
        let steps = 7;
        let part = |step: i32| f64::from(step) / f64::from(steps);
        let added: f64 = (0..steps).map(|step| placed.slip(&at(part(step)), &at(part(step + 1)))).sum();
        assert!((whole - added).abs() < 1e-14, "{interpolation:?} {smoothing}: {whole} {added}");
        assert_eq!(placed.slip(&at(1.0), &at(0.0)), -whole);
        let chords = |count: i32| -> f64 {
            let part = |step: i32| f64::from(step) / f64::from(count);
            (0..count).map(|step| (foot(part(step + 1)) - foot(part(step))).norm()).sum()
        };
        // Chords are too short by the square of their length; Richardson extrapolation eliminates this.
        let [coarse, fine] = [chords(2000), chords(4000)];
        let length = fine + (fine - coarse) / 3.0;
        assert!((whole - length).abs() < 1e-7, "{interpolation:?} {smoothing}: {whole} {length}");
    }
}

/// The line is 4 long, and its extension 0.4; on that, `scene_clarity` holds that contact is transmitted.
#[test]
fn past_the_extension_of_the_line_nothing_is_transmitted() {
    let contact = flat(Interaction::linear(100.0).unwrap().with_friction(0.5, 40.0).unwrap());
    let start = contact.start(ring(3.5, -0.25)).unwrap();
    let state = contact.advance(&start, ring(4.5, -0.25), &second()).unwrap();
    let [inside, outside] = [3, 4].map(|node| state.node(node).unwrap());
    assert_eq!((inside.s11, outside.s11, outside.s12, outside.e11), (25.0, 0.0, 0.0, -0.25));
    assert_eq!(outside.closest.place, Place::Beyond { number: 2, distance: 0.5 });
}

/// The distance continues along the tangent past either end, with its sign.
#[test]
fn past_the_ends_slip_goes_on() {
    let line = SlideLine::new(Interpolation::Linear, [1, 2]).unwrap();
    let placed = line.place(&Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0])]).unwrap()).unwrap();
    let slip = |from: f64, to: f64| {
        let [from, to] = [from, to].map(|r| placed.closest([r, 0.5].into()).unwrap());
        placed.slip(&from, &to)
    };
    for (from, to) in [(0.75, 0.25), (0.25, 0.75), (1.5, 0.5), (0.5, 1.5), (5.5, 6.0), (4.5, 5.5), (6.0, 0.5)] {
        assert_eq!(slip(from, to), to - from, "{from} to {to}");
    }
}

// --- Equilibrium -----------------------------------------------------------------------------------------------------

/// A corner that is curved, smoothed or sharp, and elements of both types that press into it.
fn pressed(
    kind: Interpolation,
    smoothing: Option<f64>,
    slave: [[f64; 2]; 5],
    shift: [f64; 2],
) -> Result<[ContactState; 2], Error> {
    let line = SlideLine::generate(kind, 1, 5, 1)?;
    let line = if let Some(f) = smoothing { line.smoothed(f)? } else { line };
    let elements = [IslElement::isl21a(1, [11, 12])?, IslElement::isl22a(2, [13, 14, 15])?];
    let interaction = Interaction::exponential(0.5, 10.0)?.with_friction(0.3, 25.0)?.with_damping(2.0, 1.0, 0.5)?;
    let contact = Contact::new(line, ElementSet::new("both", elements)?, interaction);
    let master = [[1.0, 2.0], [2.0, 1.25], [3.0, 1.0], [4.0, 1.5], [5.0, 2.5]];
    let places = |by: [f64; 2]| {
        let slaves = (11..).zip(slave.map(|[r, z]| [r + by[0], z + by[1]]));
        Nodes::new((1..).zip(master).chain(slaves))
    };
    let start = contact.start(places([0.0, 0.0])?)?;
    let end = contact.advance(&start, places(shift)?, &second())?;
    Ok([start, end])
}

fn moments(forces: &BTreeMap<u32, Vector2<f64>>, places: &Nodes) -> f64 {
    forces.iter().map(|(&node, force)| places.position(node).unwrap().perp(force)).sum()
}

proptest! {
    #[test]
    fn slave_and_master_forces_balance(
        parabolic: bool,
        smoothing in prop_oneof![Just(None), Just(Some(0.2)), Just(Some(0.45))],
        slave in [[0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5]],
        shift in [-0.25..0.25, -0.25..0.25],
    ) {
        let kind = if parabolic { Interpolation::Parabolic } else { Interpolation::Linear };
        let Ok([_, state]) = pressed(kind, smoothing, slave, shift) else { return Ok(()) };
        let forces = state.forces();
        let size = 1.0 + forces.values().map(Vector2::norm).sum::<f64>();
        prop_assert!(forces.values().sum::<Vector2<f64>>().norm() < 1e-14 * size);
        // Friction acts at the slave node and, at the distance E11 from it, on the line. That leaves a couple, and nothing else.
        let couple: f64 = state.nodes().values().map(|node| node.area * node.s12 * node.e11).sum();
        prop_assert!((moments(&forces, state.places()) - couple).abs() < 1e-12 * size, "{state:?}");
    }

    #[test]
    fn the_forces_do_the_work_of_pressure_and_shear(
        smoothing in prop_oneof![Just(None), Just(Some(0.2))],
        slave in [[0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5]],
        motion in proptest::collection::vec([-1.0..1.0, -1.0..1.0], 16),
    ) {
        let Ok([_, state]) = pressed(Interpolation::Parabolic, smoothing, slave, [0.1, -0.1]) else { return Ok(()) };
        let moved = |node: u32| Vector2::from(motion[node as usize]);
        let work: f64 = state.forces().iter().map(|(&node, force)| force.dot(&moved(node))).sum();
        let expected: f64 = state.nodes().iter().map(|(&number, node)| {
            let variation = node.closest.overclosure_variation();
            let masters = variation.masters.iter().map(|&(node, gradient)| gradient.dot(&moved(node)));
            let closing = variation.slave.dot(&moved(number)) + masters.sum::<f64>();
            let dx: Vec<_> = node.closest.weights.iter().map(|&(node, _)| moved(node)).collect();
            let slip = node.closest.tangent.dot(&node.closest.relative_motion(moved(number), &dx));
            -node.area * (node.s11 * closing + node.s12 * slip)
        }).sum();
        prop_assert!((work - expected).abs() < 1e-11 * (1.0 + expected.abs()), "{work} {expected}");
    }

    #[test]
    fn the_same_input_gives_the_same_bits(
        slave in [[0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5], [0.5..5.5, 1.0..2.5]],
    ) {
        let run = || pressed(Interpolation::Linear, Some(0.2), slave, [0.1, -0.1]);
        prop_assert_eq!(format!("{:?}", run().map(|states| states.map(|s| (s.forces(), s.nodes().clone())))),
            format!("{:?}", run().map(|states| states.map(|s| (s.forces(), s.nodes().clone())))));
    }

    #[test]
    fn no_input_makes_it_panic(
        r in prop_oneof![0.0..1e308, 0.0..8.0, any::<f64>()],
        z in prop_oneof![-1e308..1e308, -2.0..2.0, any::<f64>()],
        k in prop_oneof![1e-300..1e300, any::<f64>()],
        mu in prop_oneof![0.0..1.0, any::<f64>()],
    ) {
        let Ok(interaction) = Interaction::exponential(k, 1.0).and_then(|law| law.with_friction(mu, 1.0)) else { return Ok(()) };
        let contact = flat(interaction);
        let places = [(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [r, z]), (4, [2.0, z])];
        let Ok(nodes) = Nodes::new(places) else { return Ok(()) };
        if let Ok(state) = contact.start(ring(2.0, 0.25)).and_then(|start| contact.advance(&start, nodes, &second())) {
            prop_assert!(state.nodes().values().all(|node| node.s11.is_finite() && node.s12.is_finite()));
        }
    }
}

// --- Torque ----------------------------------------------------------------------------------------------------------

#[test]
fn the_torque_is_that_of_the_pressures() {
    // p = 25 on the flat ring from r = 2 to 3: 2π p (3³ − 2³)/3.
    let contact = flat(Interaction::linear(100.0).unwrap());
    let state = contact.start(ring(2.0, -0.25)).unwrap();
    let expected = 2.0 * PI * 25.0 * 19.0 / 3.0;
    assert!((contact.torque(&state).unwrap() / expected - 1.0).abs() < 4.0 * f64::EPSILON);
    assert_eq!(contact.torque(&contact.start(ring(2.0, 0.25)).unwrap()).unwrap(), 0.0);

    let exact = contact.start(ring(2.0, -0.25).convert::<Octuple>()).unwrap();
    let expected = Octuple::PI * 2.0 * 25.0 * 19.0 / 3.0;
    assert!((contact.torque(&exact).unwrap() / expected - 1.0).to_f64().abs() < 1e-70);
}

/// If a node moves away fast enough, damping makes the pressure negative; a negative pressure transmits no torque.
#[test]
fn a_node_that_damping_pulls_has_no_part_in_the_torque() {
    let contact = flat(Interaction::linear(100.0).unwrap().with_damping(50.0, 10.0, 0.5).unwrap());
    let start = contact.start(ring(2.0, -0.25)).unwrap();
    let places = Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0]), (3, [2.0, -0.05]), (4, [3.0, -0.3])]).unwrap();
    let state = contact.advance(&start, places.clone(), &second()).unwrap();
    let [pulled, pushed] = [3, 4].map(|node| state.node(node).unwrap().s11);
    assert!((pulled + 5.0).abs() < 1e-12 && (pushed - 32.5).abs() < 1e-12, "{pulled} {pushed}");
    let [element] = contact.elements().elements() else { panic!("one") };
    assert_eq!(element.number(), 10);
    let expected = element.torque(&places, |node| Ok(if node == 3 { 0.0 } else { pushed })).unwrap();
    assert_eq!(contact.torque(&state).unwrap(), expected);
}

#[test]
fn the_table_prints_as_often_as_asked() {
    let contact = flat(Interaction::linear(100.0).unwrap());
    let run = |frequency| {
        let mut table = TorquePrint::every(frequency);
        let mut state = contact.start(ring(2.0, 0.0)).unwrap();
        for increment in 1..=7 {
            state = contact.advance(&state, ring(2.0, -0.03125 * f64::from(increment)), &second()).unwrap();
            table.print(increment, increment == 7, [(&contact, &state)]).unwrap();
        }
        table
    };
    let increments = |frequency| run(frequency).rows().iter().map(|row| row.increment).collect::<Vec<_>>();
    assert_eq!(increments(1), [1, 2, 3, 4, 5, 6, 7]);
    assert_eq!(increments(3), [3, 6, 7]);
    assert_eq!(increments(100), [7]);
    assert!(increments(0).is_empty());
    assert_eq!(TorquePrint::default(), TorquePrint::every(1));

    let table = run(3);
    let row = &table.rows()[1];
    assert_eq!((row.slide_line.as_str(), row.torque), ("ring", 2.0 * table.rows()[0].torque));
    let lines: Vec<_> = table.to_string().lines().map(str::to_owned).collect();
    assert_eq!(lines[0], " INCREMENT  SLIDE LINE          TORQUE");
    assert_eq!(lines[1], format!("         3  ring        {:>14.6e}", table.rows()[0].torque));
    let json = serde_json::to_string(&table).unwrap();
    assert!(json.contains(r#"{"increment":3,"slide_line":"ring","torque":"#), "{json}");
    assert_eq!(serde_json::from_str::<TorquePrint>(&json).unwrap(), table);
}

#[test]
fn an_area_that_overflows_is_refused_also_beside_one_that_does_not() {
    let nodes = Nodes::new([(3, [1.0, 0.0]), (4, [1e200, 0.0])]).unwrap();
    let refused = IslElement::isl21a(10, [3, 4]).unwrap().areas(&nodes);
    assert_eq!(refused.unwrap_err(), Error::Overflow { name: "area" });
}
