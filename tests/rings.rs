//! Rings on a slide line as elements: the inputs they reject, and the ends of a segment.

use jointproof::contact::interaction::{ExponentialContact, PressureExponential};
use jointproof::contact::slide_line::element::newton::{Isl21a, Isl22a, LineContact, OnLine, PressureLaw, SlaveState};
use jointproof::formula::Formula;
use nalgebra::Vector2;

#[test]
fn where_nothing_presses_no_shear_follows_anything() {
    // The ring is above the washer.
    let ring = OnLine { nodes: [at(1.5, 0.125), at(2.5, 0.125)], ..ring(at(1.5, 0.125)) };
    let found = Isl21a(LINE).newton(&ring, &[SlaveState { g: 0.25, s12: 1.0 }; 2]).unwrap();
    assert_eq!(found.after.map(|slave| slave.s12.to_bits()), [0; 2]);
    assert_eq!((found.forces.amax(), found.stiffness.amax()), (0.0, 0.0));
}

const LINE: LineContact = LineContact { law: PressureLaw::Linear { k: 64.0 }, k_stick: 0.5, mu: 0.25 };

fn at(r: f64, z: f64) -> Vector2<f64> {
    Vector2::new(r, z)
}

/// A ring of two nodes under a flat washer from 1 to 3, with its first node at this point.
fn ring(first: Vector2<f64>) -> OnLine<f64, 2> {
    OnLine { nodes: [first, at(2.5, -0.125)], segments: [[at(1.0, 0.0), at(3.0, 0.0)]; 2] }
}

/// A ring of three nodes under the same washer as a parabolic segment.
fn broad(first: Vector2<f64>) -> OnLine<f64, 3> {
    let nodes = [first, at(2.25, -0.125), at(2.5, -0.125)];
    OnLine { nodes, segments: [[at(1.0, 0.0), at(2.0, 0.0), at(3.0, 0.0)]; 3] }
}

const BEFORE: SlaveState<f64> = SlaveState { g: 0.0, s12: 0.25 };

/// A straight segment ends on both sides.
#[test]
fn past_either_end_of_a_straight_segment_nothing_is_transmitted() {
    for (r, g, pressure) in [(0.75, -1.25, 0.0), (1.0, -1.0, 8.0), (3.0, 1.0, 8.0), (3.25, 1.25, 0.0)] {
        let found = Isl21a(LINE).newton(&ring(at(r, -0.125)), &[BEFORE; 2]).unwrap();
        assert_eq!((found.after[0].g, found.pressures), (g, [pressure, 8.0]), "{r}");
        let transmits = pressure > 0.0;
        assert_eq!((found.after[0].s12 != 0.0, found.forces[1] != 0.0), (transmits, transmits), "{r}");
        assert_eq!(found.forces.fixed_rows::<4>(4).amax() > 0.0, transmits, "{r}");
        assert!(found.after[1].s12 != 0.0 && found.forces[3] != 0.0);
    }
}

/// The search on a parabolic segment stops at its ends: a node past an end and one above it have the same closest point.
#[test]
fn past_either_end_of_a_parabolic_segment_nothing_is_transmitted() {
    let inside = 1.0 - 2.0_f64.powi(-20);
    for (r, g, pressure) in [
        (0.75, -1.0, 0.0),
        (1.0, -1.0, 8.0),
        (2.0 - inside, -inside, 8.0),
        (2.0 + inside, inside, 8.0),
        (3.0, 1.0, 8.0),
        (3.25, 1.0, 0.0),
    ] {
        let found = Isl22a(LINE).contribution(&broad(at(r, -0.125)), &[BEFORE; 3]);
        assert_eq!((found.after[0].g, found.pressures), (g, [pressure, 8.0, 8.0]), "{r}");
        let transmits = pressure > 0.0;
        assert_eq!((found.after[0].s12 != 0.0, found.forces[1] != 0.0), (transmits, transmits), "{r}");
        assert_eq!(found.forces.fixed_rows::<6>(6).amax() > 0.0, transmits, "{r}");
    }
}

#[test]
fn every_ring_asks_for_its_parameters_and_places() {
    let (straight, curved) = (ring(at(2.0, -0.125)), broad(at(2.0, -0.125)));
    let of_two = |contact: LineContact, places: &OnLine<f64, 2>| {
        Isl21a(contact).newton(places, &[BEFORE; 2]).err().map(|error| error.to_string())
    };
    let of_three = |contact: LineContact, places: &OnLine<f64, 3>| {
        Isl22a(contact).newton(places, &[BEFORE; 3]).err().map(|error| error.to_string())
    };
    let (exponential, linear) = (|c0, p0| PressureLaw::Exponential { c0, p0 }, |k| PressureLaw::Linear { k });
    for (contact, words) in [
        (LINE, None),
        (LineContact { law: exponential(1e-3, 1e-3), ..LINE }, None),
        (LineContact { law: linear(0.0), ..LINE }, Some("k is 0.0; allowed is a finite number > 0")),
        (LineContact { law: exponential(0.0, 1.0), ..LINE }, Some("c0 is 0.0; allowed is a finite number > 0")),
        (LineContact { law: exponential(1.0, -1.0), ..LINE }, Some("p0 is -1.0; allowed is a finite number > 0")),
        (LineContact { k_stick: 0.0, ..LINE }, Some("k_stick is 0.0; allowed is a finite number > 0")),
        (LineContact { mu: -1.0, ..LINE }, Some("mu is -1.0; allowed is a finite number ≥ 0")),
    ] {
        assert_eq!(of_two(contact, &straight).as_deref(), words);
        assert_eq!(of_three(contact, &curved).as_deref(), words);
    }
    for (node, axis) in (0..6).map(|k| (k / 2, k % 2)) {
        let expected = Some(format!("x{}[{axis}] is NaN; allowed is a finite number", node + 1));
        let outside = Some(format!("x{}[0] is -1.0; allowed is a finite number ≥ 0", node + 1));
        if node < 2 {
            let [mut lost, mut negative] = [straight; 2];
            (lost.nodes[node][axis], negative.nodes[node].x) = (f64::NAN, -1.0);
            assert_eq!((of_two(LINE, &lost), of_two(LINE, &negative)), (expected.clone(), outside.clone()));
        }
        let [mut lost, mut negative] = [curved; 2];
        (lost.nodes[node][axis], negative.nodes[node].x) = (f64::NAN, -1.0);
        assert_eq!((of_three(LINE, &lost), of_three(LINE, &negative)), (expected.clone(), outside));
        for segment in 0..3 {
            if segment < 2 && node < 2 {
                let mut lost = straight;
                lost.segments[segment][node][axis] = f64::NAN;
                assert_eq!(of_two(LINE, &lost), expected, "{segment}");
            }
            let mut lost = curved;
            lost.segments[segment][node][axis] = f64::NAN;
            assert_eq!(of_three(LINE, &lost), expected, "{segment}");
        }
    }
}

#[test]
fn every_ring_asks_for_what_its_nodes_remember() {
    let (straight, curved) = (ring(at(2.0, -0.125)), broad(at(2.0, -0.125)));
    let lost = [SlaveState { g: f64::NAN, ..BEFORE }, SlaveState { s12: f64::NAN, ..BEFORE }];
    for (slave, (before, name)) in (0..3).flat_map(|slave| lost.into_iter().zip(["g", "s12"]).map(move |x| (slave, x)))
    {
        let words = Some(format!("{name}_before[{slave}] is NaN; allowed is a finite number"));
        let mut three = [BEFORE; 3];
        three[slave] = before;
        assert_eq!(Isl22a(LINE).newton(&curved, &three).err().map(|error| error.to_string()), words);
        if slave < 2 {
            let two = [three[0], three[1]];
            assert_eq!(Isl21a(LINE).newton(&straight, &two).err().map(|error| error.to_string()), words);
        }
    }
}

/// A torque that overflows although all forces and derivatives are finite, and a derivative that overflows although the torque is
/// finite.
#[test]
fn a_ring_tells_that_forces_or_a_torque_overflow() {
    let places = |unit: f64, depth: f64| {
        let segments = [[at(1.0, 0.0) * unit, at(3.0, 0.0) * unit]; 2];
        OnLine { nodes: [at(2.0 * unit, -depth), at(2.5 * unit, -depth)], segments }
    };
    for (k, unit, depth) in [(1e270, 1e10, 1e10), (1e308, 1.0, 1e-6)] {
        let element = Isl21a(LineContact { law: PressureLaw::Linear { k }, ..LINE });
        let before = [SlaveState { g: 0.0, s12: 0.0 }; 2];
        let Err(error) = element.newton(&places(unit, depth), &before) else { panic!("{k:e} is refused") };
        assert_eq!(error.found(), "contribution is too large for a double");
        let found = element.contribution(&places(unit, depth), &before);
        let finite = found.forces.iter().chain(&found.stiffness).chain(&found.torque_row).all(|x| x.is_finite());
        assert_ne!(finite, found.torque.is_finite(), "{k:e}");
    }
}

/// Between the ends, pressed and dragged: the force on a node is distributed over its own segment, and over no other.
#[test]
fn what_acts_on_a_node_acts_back_on_its_segment() {
    let nodes = [at(2.0, 0.25), at(3.5, 0.75)];
    let segments = [[at(1.0, 0.0), at(3.0, 1.0)], [at(3.0, 1.0), at(5.0, 1.25)]];
    let before = SlaveState { g: 0.25, s12: 0.125 };
    let found = Isl21a(LINE).newton(&OnLine { nodes, segments }, &[before; 2]).unwrap();
    let force = |node: usize| found.forces.fixed_rows::<2>(2 * node).into_owned();
    for slave in 0..2 {
        let (g, on_slave) = (found.after[slave].g, force(slave));
        let shares = [0.5 * (1.0 - g), 0.5 * (1.0 + g)];
        for (k, share) in shares.into_iter().enumerate() {
            assert!((force(2 + 2 * slave + k) + on_slave * share).amax() < 1e-12 * on_slave.amax(), "{slave}, {k}");
        }
    }
    let nodes = [at(1.5, 0.25), at(2.25, 0.75), at(3.0, 0.5)];
    let segments = [[at(1.0, 0.0), at(2.25, 1.0), at(4.0, 0.5)]; 3];
    let found = Isl22a(LINE).newton(&OnLine { nodes, segments }, &[before; 3]).unwrap();
    let force = |node: usize| found.forces.fixed_rows::<2>(2 * node).into_owned();
    for slave in 0..3 {
        let (g, on_slave) = (found.after[slave].g, force(slave));
        let shares = [0.5 * g * (g - 1.0), 1.0 - g * g, 0.5 * g * (g + 1.0)];
        for (k, share) in shares.into_iter().enumerate() {
            assert!((force(3 + 3 * slave + k) + on_slave * share).amax() < 1e-12 * on_slave.amax(), "{slave}, {k}");
        }
    }
}

#[test]
fn the_exponential_law_presses_by_its_clearance() {
    let (c0, p0) = (0.5, 20.0);
    for h in [-0.75, -0.25, 0.125] {
        let mut places = ring(at(2.0, -h));
        places.nodes[1].y = -h;
        let law = PressureLaw::Exponential { c0, p0 };
        let found = Isl21a(LineContact { law, ..LINE }).newton(&places, &[BEFORE; 2]).unwrap();
        let expected = PressureExponential::eval(&ExponentialContact { h, c0, p0 }).p;
        assert_eq!((found.pressures, expected > 0.0), ([expected; 2], h > -c0));
    }
}
