//! Features of scenes beyond the connectors of the documents: parts of connectors, stops on one side, SLIDER with radius and
//! axis, generated nodes, areas and bases on slide lines, the torque frequency.

use jointproof::connector::align::AlignFromStart;
use jointproof::connector::slot::{Pose, Slot};
use jointproof::connector::translator::{self, Translator};
use jointproof::connector::ujoint::{Stops, UJoint};
use jointproof::contact::isl::IslElement;
use jointproof::contact::slide_line::Nodes;
use jointproof::element::frame::Triad;
use jointproof::scene::{Plan, Results, Scene};
use nalgebra::Vector3;

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

/// An element between two nodes with explicit triads.
fn element(element: &str, outputs: &str) -> String {
    format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"axes": [[1, 0, 0], [0, 1, 0]]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [1, 2, 3], "orientation": "o"}}}},
        "elements": {{"e": {{{element}, "nodes": ["a", "b"]}}}},
        "frames": [{{"time": 0, "nodes": {{"b": {{"u": [0.5, 0.25, 0], "ur": [0.125, 0, 0]}}}},
            "loads": {{"e": {{}}}}}}], "outputs": {outputs}}}"#
    )
}

#[test]
fn a_stop_on_one_side_needs_nothing_of_the_other() {
    for kind in ["slot", "translator"] {
        let upper = scene(&element(&format!(r#""kind": "{kind}", "l1_max": 4"#), r#"["GAPMAX"]"#));
        assert_eq!(Results::of(&upper).unwrap().get("e", "GAPMAX", 0), Some(&[2.5][..]));
        let lower = scene(&element(&format!(r#""kind": "{kind}", "l1_min": -4"#), r#"["GAPMIN"]"#));
        assert_eq!(Results::of(&lower).unwrap().get("e", "GAPMIN", 0), Some(&[5.5][..]));
        let formulas: Vec<_> = Plan::new(&lower).lines().into_iter().map(|line| line.formula).collect();
        assert_eq!(formulas, ["slot.relative_position", "slot.stop"]);
        // Both together are computed by one formula.
        let both =
            scene(&element(&format!(r#""kind": "{kind}", "l1_min": -4, "l1_max": 4"#), r#"["GAPMIN", "GAPMAX"]"#));
        assert_eq!(Plan::new(&both).lines().len(), 2);
        let missing =
            Scene::parse(&element(&format!(r#""kind": "{kind}", "l1_max": 4"#), r#"["GAPMIN"]"#)).unwrap_err();
        assert!(missing.len() == 1 && missing.to_string().contains("no \"l1_min\", needed for slot.stop"), "{missing}");
    }
    let turned = |parameter: &str, output: &str| {
        let scene = scene(&element(&format!(r#""kind": "ujoint", {parameter}"#), &format!("[{output:?}]")));
        Results::of(&scene).unwrap().get("e", output, 0).unwrap()[0]
    };
    assert!((turned(r#""theta1_max": 1"#, "GAP1MAX") - 0.875).abs() < 1e-15);
    assert!((turned(r#""theta1_min": -1"#, "GAP1MIN") - 1.125).abs() < 1e-15);
    assert!((turned(r#""theta3_max": 1"#, "GAP3MAX") - 1.0).abs() < 1e-15);
    assert!((turned(r#""theta3_min": -1"#, "GAP3MIN") - 1.0).abs() < 1e-15);
}

#[test]
fn a_slot_may_have_one_stop() {
    let pose = Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) };
    let slot = Slot::new(&pose).unwrap();
    let gaps = |slot: Slot| slot.gaps(&pose).unwrap().map(|gaps| [gaps.gap_min, gaps.gap_max]);
    assert_eq!(gaps(slot), None);
    assert_eq!(gaps(slot.with_upper_stop(4.0).unwrap()), Some([f64::INFINITY, 3.0]));
    assert_eq!(gaps(slot.with_lower_stop(-4.0).unwrap()), Some([5.0, f64::INFINITY]));
    let both = slot.with_lower_stop(-4.0).unwrap().with_upper_stop(4.0).unwrap();
    assert_eq!(both, slot.with_stops(-4.0, 4.0).unwrap());
    let error = both.with_upper_stop(-5.0).unwrap_err().to_string();
    assert_eq!(error, "l1_min = -4.0 is above l1_max = -5.0; allowed is l1_min ≤ l1_max");
    assert!(slot.with_lower_stop(f64::NAN).is_err());
}

#[test]
fn a_translator_and_a_joint_may_have_one_stop() {
    let (triad, zero) = (Triad::global(), Vector3::zeros());
    let pose = translator::Pose { triad_a: triad, triad_b: triad, xa: zero, xb: Vector3::new(1.0, 2.0, 3.0) };
    let translator = Translator::new(&pose).unwrap();
    let gaps = |one: Translator| one.gaps(&pose).unwrap().map(|gaps| [gaps.gap_min, gaps.gap_max]);
    assert_eq!(gaps(translator.with_upper_stop(4.0).unwrap()), Some([f64::INFINITY, 3.0]));
    assert_eq!(gaps(translator.with_lower_stop(-4.0).unwrap()), Some([5.0, f64::INFINITY]));

    let pose = translator::Pose { xb: zero, ..pose };
    let joint = UJoint::new(&pose).unwrap();
    let gaps = |stops: Stops| {
        let gaps = joint.with_stops(&stops).unwrap().gaps(&pose).unwrap().unwrap();
        [gaps.gap1_min, gaps.gap1_max, gaps.gap3_min, gaps.gap3_max]
    };
    let none = f64::INFINITY;
    assert_eq!(gaps(Stops::NONE), [none; 4]);
    assert_eq!(gaps(Stops { theta1_max: 0.5, ..Stops::NONE }), [none, 0.5, none, none]);
    assert_eq!(gaps(Stops { theta1_min: -0.25, theta3_max: 2.0, ..Stops::NONE }), [0.25, none, none, 2.0]);
    assert_eq!(gaps(Stops { theta3_min: -3.0, theta3_max: 2.0, ..Stops::NONE }), [none, none, 3.0, 2.0]);
    for stops in [Stops { theta1_min: none, ..Stops::NONE }, Stops { theta3_max: -none, ..Stops::NONE }] {
        assert!(joint.with_stops(&stops).is_err(), "{stops:?}");
    }
}

/// Parts give the same results as the whole.
#[test]
fn align_join_and_universal_are_parts_of_translator_and_ujoint() {
    let loads = r#""e": {"f1": 1, "f2": 2, "f3": 3, "m1": 4, "m2": 5, "m3": 6}"#;
    let of = |kind: &str, loads: &str, outputs: &[&str]| {
        let text = element(&format!(r#""kind": "{kind}""#), &format!("{outputs:?}")).replace(r#""e": {}"#, loads);
        let results = Results::of(&scene(&text)).unwrap();
        outputs.iter().map(|output| results.get("e", output, 0).unwrap().to_vec()).collect::<Vec<_>>()
    };
    let moments = r#""e": {"m1": 4, "m2": 5, "m3": 6}"#;
    let forces = r#""e": {"f1": 1, "f2": 2, "f3": 3}"#;
    for (part, of_part, whole, outputs) in [
        ("align", moments, "translator", &["UR1", "UR2", "UR3", "RM"][..]),
        ("join", forces, "ujoint", &["G", "RF"]),
        ("universal", moments, "ujoint", &["GROT", "ALPHA", "GAMMA", "UR1", "UR3", "UR1MAT", "UR3MAT", "RM", "KM"]),
    ] {
        assert_eq!(of(part, of_part, outputs), of(whole, loads, outputs), "{part}");
    }
}

/// A translator that starts at 90° about the second axis, where its own angles are rejected.
#[test]
fn angles_since_the_start_are_those_of_the_typed_connector_wherever_it_starts() {
    for (start, regular) in [(0.5, true), (std::f64::consts::FRAC_PI_2, false), (-1.5706, false), (3.0, true)] {
        let text = |outputs: &str| {
            format!(
                r#"{{"dimension": "3d", "orientations": {{"a": {{"rotation": [0, 0, 0]}}, "b": {{"rotation": [0, {start:?}, 0]}}}},
                "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "a"}}, "b": {{"at": [1, 0, 0], "orientation": "b"}}}},
                "elements": {{"t": {{"kind": "translator", "nodes": ["a", "b"]}}, "u": {{"kind": "align", "nodes": ["a", "b"]}}}},
                "frames": [{{"time": 0}}, {{"time": 1, "nodes": {{"b": {{"ur": [0, 0, 0.25]}}}}}}], "outputs": [{outputs}]}}"#
            )
        };
        assert_eq!(Results::of(&scene(&text(r#""UR1", "UR2", "UR3""#))).is_ok(), regular, "{start}");
        let results = Results::of(&scene(&text(r#""URS1", "URS2", "URS3""#))).unwrap();
        let at = |output, state| results.get("t", output, state).unwrap()[0];
        let ((s, c), (turn_s, turn_c)) = (start.sin_cos(), 0.25_f64.sin_cos());
        let b = |s3: f64, c3: f64| {
            // Rotated about y from the start, then about z.
            let about_z = |v: Vector3<f64>| Vector3::new(c3 * v.x - s3 * v.y, s3 * v.x + c3 * v.y, v.z);
            let axes = [Vector3::new(c, 0.0, -s), Vector3::y(), Vector3::new(s, 0.0, c)].map(about_z);
            Triad::new(axes[0], axes[1], axes[2]).unwrap()
        };
        let align = AlignFromStart::new(&Triad::global(), &b(0.0, 1.0));
        for (state, triad) in [b(0.0, 1.0), b(turn_s, turn_c)].iter().enumerate() {
            let typed = align.constraint(&Triad::global(), triad).unwrap();
            for (output, expected) in [("URS1", typed.ur1), ("URS2", typed.ur2), ("URS3", typed.ur3)] {
                assert!((at(output, state) - expected).abs() < 1e-15, "{start} {output} {state}");
                assert_eq!(results.get("u", output, state), results.get("t", output, state));
            }
        }
        assert!((at("URS3", 1) - 0.25).abs() < 1e-15 && at("URS1", 1).abs() < 1e-15);
    }
}

const PLANE: &str = r#"{"dimension": "2d", "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 2]}, "m": {"at": [3, 1]}},
    "elements": {"rail": {"kind": "slider", "nodes": ["a", "b", "m"]}},
    "frames": [{"time": 0}, {"time": 1, "nodes": {"m": {"u": [1, 0.5]}}},
    {"time": 2, "nodes": {"b": {"u": [0, 4]}, "m": {"u": [1, 3.5]}}}], "outputs": ["N", "L", "G", "R", "XMI", "DXMI"]}"#;

#[test]
fn a_slider_with_radius_and_axis_is_that_of_the_plane() {
    let plane = Results::exact(&scene(PLANE)).unwrap();
    let turned = Results::exact(&scene(&PLANE.replace("2d", "axisymmetric"))).unwrap();
    assert_eq!(plane, turned);
    let at = |output, state| plane.get("rail", output, state).unwrap();
    assert_eq!((at("L", 0)[0], at("N", 0)[2]), (20.0_f64.sqrt(), 0.0));
    assert_eq!((at("XMI", 0), at("XMI", 1)), (&[1.0][..], &[1.5][..]));
    // Along the line nothing is violated; b and m move up by 4 and 3: m lies at three quarters of the line.
    assert_eq!([at("R", 0)[0], at("R", 1)[0], at("G", 1)[0]], [0.0, 0.0, 0.0]);
    let residual = at("R", 2)[0];
    assert!(residual.abs() < 1e-15, "{residual}");
}

/// The residual in the plane is the one in space that is not automatically zero.
#[test]
fn the_residual_in_the_plane_is_that_of_space() {
    let off = PLANE.replace(r#""u": [1, 3.5]"#, r#""u": [1.25, 3]"#);
    let plane = Results::exact(&scene(&off)).unwrap();
    let space = off
        .replace("2d", "3d")
        .replace(r#""outputs": ["N", "L", "G", "R", "XMI", "DXMI"]"#, r#""outputs": ["R1", "R2"]"#);
    let pair = regex_pairs(&space);
    let space = Results::exact(&scene(&pair)).unwrap();
    let [r1, r2] = ["R1", "R2"].map(|output| space.get("rail", output, 2).unwrap()[0]);
    let r = plane.get("rail", "R", 2).unwrap()[0];
    assert_ne!(r, 0.0);
    assert!((r1.hypot(r2) - r.abs()).abs() < 1e-15, "{r1} {r2} {r}");
}

/// Vectors of two numbers get a third.
fn regex_pairs(text: &str) -> String {
    let mut out = String::new();
    for piece in text.split_inclusive(']') {
        let vector =
            piece.rsplit('[').next().is_some_and(|inside| inside.split(',').count() == 2 && !inside.contains('"'));
        out += &if vector { piece.replace(']', ", 0]") } else { piece.into() };
    }
    out
}

const LINE: &str = r#"{"dimension": "axisymmetric",
    "nodes": {"p 2": {"at": [1, 0]}, "p 4": {"at": [2, 0]}, "p 6": {"at": [3, 0]}, "m": {"at": [1.5, -0.5]}, "n": {"at": [2.5, -0.25]}},
    "slide_lines": {"l": {"type": "linear", "nodes": ["p 2", "p 4", "p 6"], "pressure": {"k": 2}}},
    "elements": {"e": {"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "l"}},
    "frames": [{"time": 0}, {"time": 1, "nodes": {"m": {"u": [0.25, 0]}}}, {"time": 2}, {"time": 3}, {"time": 4}], "outputs": ["T"]}"#;
const LISTED: &str = r#""nodes": ["p 2", "p 4", "p 6"]"#;

#[test]
fn generated_nodes_are_the_listed_ones() {
    let generated = |how: &str| LINE.replace(LISTED, &format!(r#""generate": {{{how}}}"#));
    let all = generated(r#""first": "p 2", "last": "p 6", "increment": 2"#);
    assert_eq!(Results::of(&scene(&all)).unwrap(), Results::of(&scene(LINE)).unwrap());
    let fault = |how: &str| {
        let faults = Scene::parse(&generated(how)).unwrap_err();
        assert_eq!(faults.len(), 1, "{faults}");
        faults.to_string()
    };
    for (how, expected) in [
        (
            r#""first": "p 2", "last": "p 7", "increment": 2"#,
            "\"p 7\"; allowed is \"p \" with a number that is 2 and a multiple of 2 more",
        ),
        (r#""first": "p 6", "last": "p 2", "increment": 2"#, "\"p 2\"; allowed is"),
        (r#""first": "p 2", "last": "q 6""#, "\"q 6\"; allowed is \"p \" with"),
        (r#""first": "p", "last": "p 6""#, "\"p\" to \"p 6\"; allowed is names that end in a number"),
        (r#""first": "p 2", "last": "p 4000000000", "increment": 2"#, "no node \"p 8\""),
        (r#""first": "p 2", "last": "p 6", "increment": 0"#, "0.0; allowed is a whole number from 1 to"),
        (r#""first": "p 2", "last": "p 6", "increment": 0.5"#, "0.5; allowed is a whole number from 1 to"),
        (r#""first": "p 2""#, "generated nodes without \"first\" or \"last\""),
    ] {
        assert!(fault(how).contains(expected), "{}", fault(how));
    }
    let both =
        LINE.replace(LISTED, &format!(r#"{LISTED}, "generate": {{"first": "p 2", "last": "p 6", "increment": 2}}"#));
    let faults = Scene::parse(&both).unwrap_err().to_string();
    assert!(faults.contains("a slide line with \"nodes\" and \"generate\""), "{faults}");
}

#[test]
fn the_torque_is_a_result_as_often_as_asked() {
    let shown = |frequency: &str| {
        let results = Results::of(&scene(&LINE.replace(LISTED, &format!("{LISTED}{frequency}")))).unwrap();
        let states =
            |element| (0..5).filter(|&state| !results.get(element, "T", state).unwrap().is_empty()).collect::<Vec<_>>();
        assert_eq!(states("e"), states("l"));
        states("l")
    };
    assert_eq!(shown(""), [0, 1, 2, 3, 4]);
    assert_eq!(shown(r#", "torque_frequency": 1"#), [0, 1, 2, 3, 4]);
    assert_eq!(shown(r#", "torque_frequency": 2"#), [1, 3, 4]);
    assert_eq!(shown(r#", "torque_frequency": 100"#), [4]);
    assert!(shown(r#", "torque_frequency": 0"#).is_empty());
}

#[test]
fn areas_and_bases_are_those_of_element_and_line() {
    let text = LINE
        .replace(r#"["T"]"#, r#"["AREA", "T1", "N"]"#)
        .replace(r#""p 6": {"at": [3, 0]}"#, r#""p 6": {"at": [2, 1]}"#);
    let results = Results::of(&scene(&text)).unwrap();
    let nodes = Nodes::new([(1, [1.75, -0.5]), (2, [2.5, -0.25])]).unwrap();
    let areas = IslElement::isl21a(1, [1, 2]).unwrap().areas(&nodes).unwrap();
    assert_eq!(results.get("e", "AREA", 1), Some(&areas[..]));
    // m is below the first segment, n next to the corner: the closest point is the node, with the normal along the gap.
    let at = |output| results.get("e", output, 1).unwrap();
    assert_eq!((&at("T1")[..2], &at("N")[..2]), (&[1.0, 0.0][..], &[0.0, 1.0][..]));
    let length = 0.5_f64.hypot(0.25);
    for (found, expected) in at("N")[2..].iter().zip([-0.5 / length, 0.25 / length]) {
        assert!((found - expected).abs() < 1e-15, "{:?}", at("N"));
    }
}
