//! UJOINT in scenes: minimal plans, results of the typed connector, friction over a rotation.

use jointproof::connector::ujoint::{Cross, Loads, Pose, Stops, UJoint};
use jointproof::element::frame::Triad;
use jointproof::scene::{Plan, Results, Scene};
use nalgebra::Vector3;

const DRIVE_SHAFT: &str = include_str!("../golden/scenes/drive-shaft.json");

/// A joint at rest under a load, with its triads at an angle.
fn joint(outputs: &str) -> Scene {
    let text = format!(
        r#"{{"dimension": "3d", "orientations": {{"turned": {{"axes": [[1, 0, 0], [0, 0.6, 0.8]]}}, "o": {{"rotation": [0, 0, 0]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0], "orientation": "turned"}}}},
        "elements": {{"e": {{"kind": "ujoint", "nodes": ["a", "b"], "rp": 1, "la": 2, "ra": 0.5, "ls": 4, "mu": 0.25,
            "mc1_int": 4, "k_stick": 10, "theta1_min": -2, "theta1_max": 2, "theta3_min": -1, "theta3_max": 1}}}},
        "frames": [{{"time": 0, "loads": {{"e": {{"f1": 3, "f2": -4, "f3": 16, "m1": 4, "m2": 2.5, "m3": -1}}}}}}],
        "outputs": {outputs}}}"#
    );
    Scene::parse(&text).unwrap_or_else(|faults| panic!("{faults}"))
}

fn plan(outputs: &str) -> Vec<String> {
    let lines = Plan::new(&joint(outputs)).lines();
    lines.iter().map(|line| format!("{}{}", if line.once { "start: " } else { "" }, line.formula)).collect()
}

#[test]
fn only_what_an_output_needs_is_evaluated() {
    assert_eq!(plan(r#"["MC1"]"#), ["ujoint.contact_moments"]);
    assert_eq!(plan(r#"["MN1", "MN3"]"#), ["ujoint.contact_moments", "ujoint.normal_moments"]);
    // Φ is that of the friction moment, which is computed over the increments.
    let yields = plan(r#"["PHI1"]"#);
    assert_eq!(yields.last().map(String::as_str), Some("coulomb.yield"));
    assert_eq!(yields.iter().filter(|line| *line == "coulomb.response").count(), 1);
    // The angle is followed, and with it the other.
    let passes = plan(r#"["GAP1MAX"]"#);
    assert_eq!(passes[..4], ["start: scene.angles", "universal.angles", "scene.follow", "scene.follow"]);
    assert!(passes.len() == 6 && passes.contains(&"ujoint.stop".into()), "{passes:?}");
    assert_eq!(plan(r#"["FBEND"]"#), ["ujoint.decomposition"]);
    assert_eq!(plan(r#"["GROT"]"#), ["start: universal.constraint", "universal.constraint"]);
    let friction = plan(r#"["CSM1"]"#);
    let count = |formula: &str| friction.iter().filter(|line| *line == formula).count();
    // About one axis only, so one increment and one response.
    assert_eq!(
        (count("scene.increment"), count("coulomb.response"), count("scene.slip_total")),
        (1, 1, 0),
        "{friction:?}"
    );
}

#[test]
fn results_are_those_of_the_typed_connector() {
    let results = Results::of(&joint(r#"["MC1", "MC3", "PHI1", "PHI3", "CSM1", "CSM3", "GAP1MIN", "FR"]"#)).unwrap();
    let turned = Triad::new(Vector3::x(), Vector3::new(0.0, 0.6, 0.8), Vector3::new(0.0, -0.8, 0.6)).unwrap();
    let pose = Pose { triad_a: Triad::global(), triad_b: turned, xa: Vector3::zeros(), xb: Vector3::zeros() };
    let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 4.0, mc3_int: 0.0 };
    let joint = UJoint::new(&pose).unwrap().with_friction(&cross).unwrap();
    let found = |output| results.get("e", output, 0).unwrap()[0];
    let loads = Loads { f1: 3.0, f2: -4.0, f3: 16.0, m1: found("CSM1"), m2: 2.5, m3: found("CSM3") };
    let moments = joint.contact_moments(&pose, &loads).unwrap().unwrap();
    let friction = joint.friction(&pose, &loads).unwrap().unwrap();
    let expected = [("MC1", moments.mc1), ("MC3", moments.mc3), ("PHI1", friction.phi1), ("PHI3", friction.phi3)];
    for (output, expected) in expected {
        let found = results.get("e", output, 0).unwrap()[0];
        assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{output}: {found} is not {expected}");
    }
    assert_eq!(results.get("e", "FR", 0), Some(&[281.0_f64.sqrt()][..]));
}

#[test]
fn friction_of_the_drive_shaft_stays_within_its_limit_and_turns_with_the_swing() {
    let scene = Scene::parse(DRIVE_SHAFT).unwrap_or_else(|faults| panic!("{faults}"));
    let results = Results::of(&scene).unwrap();
    let at = |output, state| results.get("first", output, state).unwrap()[0];
    let states = results.times.len();
    for state in 0..states {
        let limit = 0.08 * at("MN1", state);
        assert!(at("CSM1", state).abs() <= limit * (1.0 + 1e-15), "state {state}");
        assert!(state == 0 || at("CASUR1", state) >= at("CASUR1", state - 1));
        assert!(at("GAP1MAX", state) > 0.0, "the stop is never reached");
    }
    let moments: Vec<_> = (0..states).map(|state| at("CSM1", state)).collect();
    assert!(moments.iter().any(|&moment| moment > 0.0) && moments.iter().any(|&moment| moment < 0.0), "{moments:?}");
    // Fewer outputs of the second joint are requested, and it has no others.
    assert!(results.get("second", "CSM1", 0).is_none() && results.get("second", "ALPHA", 0).is_some());
}

/// From 160° to 200° there is no jump, in a scene and in the typed connector; a stop at 4 rad is found to be passed at 240°.
#[test]
fn turns_are_followed_from_state_to_state() {
    let degrees = [0.0_f64, 90.0, 160.0, 200.0, 240.0, 400.0, 330.0, 160.0, 0.0, -30.0, -190.0];
    let frames: Vec<_> = (0..)
        .zip(degrees)
        .map(|(time, turn)| {
            format!(r#"{{"time": {time}, "nodes": {{"b": {{"ur": [{:?}, 0, 0]}}}}}}"#, turn.to_radians())
        })
        .collect();
    let text = format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}, "turned": {{"rotation": [3, 0, 0]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0], "orientation": "turned"}}}},
        "elements": {{"e": {{"kind": "ujoint", "nodes": ["a", "b"], "theta1_min": -1, "theta1_max": 4, "theta3_min": -1, "theta3_max": 1}},
            "part": {{"kind": "universal", "nodes": ["a", "b"]}}}},
        "frames": [{}], "outputs": ["ALPHA", "UR1", "UR1MAT", "GAP1MAX", "GAP1MIN"]}}"#,
        frames.join(",\n")
    );
    let results = Results::of(&Scene::parse(&text).unwrap_or_else(|faults| panic!("{faults}"))).unwrap();
    let triad = |angle: f64| {
        let (s, c) = angle.sin_cos();
        Triad::new(Vector3::x(), Vector3::new(0.0, c, s), Vector3::new(0.0, -s, c)).unwrap()
    };
    let mut pose = Pose { triad_a: Triad::global(), triad_b: triad(3.0), xa: Vector3::zeros(), xb: Vector3::zeros() };
    let stops = Stops { theta1_min: -1.0, theta1_max: 4.0, theta3_min: -1.0, theta3_max: 1.0 };
    let joint = UJoint::new(&pose).unwrap().with_stops(&stops).unwrap();
    let mut last = joint.universal().initial();
    for (state, turn) in degrees.map(f64::to_radians).into_iter().enumerate() {
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{turn}: {found} is not {expected}");
        let at = |output| results.get("e", output, state).unwrap()[0];
        close(at("UR1"), turn);
        close(at("ALPHA"), 3.0 + turn);
        close(at("GAP1MAX"), 1.0 - turn);
        for output in ["ALPHA", "UR1", "UR1MAT"] {
            assert_eq!(results.get("part", output, state).unwrap()[0], at(output), "UNIVERSAL follows as UJOINT does");
        }
        pose.triad_b = triad(3.0 + turn);
        close(joint.relative_motion_from(&last, &pose).unwrap().ur1, turn);
        close(joint.gaps_from(&last, &pose).unwrap().unwrap().gap1_max, 1.0 - turn);
        last = joint.turns_from(&last, &pose).unwrap();
        // Without a previous state it is within half a turn of the start.
        assert!(joint.relative_motion(&pose).unwrap().ur1.abs() <= std::f64::consts::PI);
    }
}

#[test]
fn the_twisting_moment_is_the_documented_one_and_the_hinge_has_its_share() {
    let results = Results::of(&joint(r#"["MTWIST", "MTWISTH"]"#)).unwrap();
    let at = |output| results.get("e", output, 0).unwrap()[0];
    assert_eq!(at("MTWIST"), 2.5);
    assert!(at("MTWISTH") > 0.0 && at("MTWISTH") < 2.5 / 8.0);
}
