//! What is ambiguous in a scene, or looks like a mistake, is asked about, warned of, or refused with its state, node and value.

use jointproof::scene::{Plan, Results, Run, Scene, Warning};
use std::f64::consts::PI;

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

/// A connector between a, in the global axes, and b, which turns by these rotation vectors.
fn joint(kind: &str, parameters: &str, outputs: &str, turns: &[[f64; 3]]) -> String {
    let frame =
        |(time, turn): (usize, &[f64; 3])| format!(r#"{{"time": {time}, "nodes": {{"b": {{"ur": {turn:?}}}}}}}"#);
    let frames: Vec<_> = turns.iter().enumerate().map(frame).collect();
    format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0]}}}},
        "elements": {{"e": {{"kind": "{kind}", "nodes": ["a", "b"]{parameters}}}}},
        "frames": [{}], "outputs": ["{outputs}"]}}"#,
        frames.join(", ")
    )
}

fn only(results: &Results, output: &str) -> Vec<f64> {
    (0..results.times.len()).map(|state| results.get("e", output, state).unwrap()[0]).collect()
}

fn close(found: &[f64], expected: &[f64]) {
    let is_close = found.len() == expected.len() && found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-13);
    assert!(is_close, "{found:?} and not {expected:?}");
}

#[test]
fn turns_of_half_a_turn_and_more_are_counted() {
    let half_turns: Vec<_> = (0..7_u8).map(|k| [f64::from(k) * PI, 0.0, 0.0]).collect();
    let results = Results::of(&scene(&joint("ujoint", "", "UR1", &half_turns))).unwrap();
    close(&only(&results, "UR1"), &half_turns.iter().map(|turn| turn[0]).collect::<Vec<_>>());
    assert_eq!(results.warnings, Vec::<String>::new());
    for (turns, expected) in [
        (&[[0.0; 3], [3.5, 0.0, 0.0]][..], &[0.0, 3.5][..]),
        (&[[200.0_f64.to_radians(), 0.0, 0.0]], &[200.0_f64.to_radians()]),
    ] {
        close(&only(&Results::of(&scene(&joint("ujoint", "", "UR1", turns))).unwrap(), "UR1"), expected);
    }
    // Along no common axis the way is not known.
    let results = Results::of(&scene(&joint("hinge", "", "UR1", &[[1.0, 0.0, 0.0], [0.0, 4.0, 0.0]]))).unwrap();
    let [warning] = &results.warnings[..] else { panic!("{:?}", results.warnings) };
    assert!(warning.starts_with("frames[1], node \"b\": its rotation vector changes by 4.1231 (236.2°)"), "{warning}");
}

#[test]
fn angles_may_be_in_degrees() {
    let degrees = joint(
        "hinge",
        r#", "theta1_ref": 90, "theta1_min": -45, "theta1_max": 180"#,
        r#"UR1MAT", "GAP1MAX", "UR1"#,
        &[[0.0, 30.0, 0.0]],
    )
    .replace(r#""rotation": [0, 0, 0]"#, r#""rotation": [0, 0, 90]"#);
    let with = |unit: &str| degrees.replacen(r#""dimension""#, &format!(r#""angles": "{unit}", "dimension""#), 1);
    let results = Results::of(&scene(&with("degrees"))).unwrap();
    let of = |degrees: f64| degrees / 180.0 * PI;
    close(&[only(&results, "UR1MAT")[0], only(&results, "GAP1MAX")[0]], &[of(-60.0), of(150.0)]);
    assert_eq!(results.warnings, Vec::<String>::new());
    // Nobody who says radians is asked.
    assert_eq!(scene(&with("radians")).warnings(), Vec::<String>::new());
    let warnings = scene(&degrees).warnings();
    assert_eq!(warnings.len(), 3);
    assert!(
        warnings.iter().any(|warning| warning.contains("elements.e.theta1_ref is 90, more than a full turn")),
        "{warnings:?}"
    );
    let faults = Scene::parse(&with("grad")).unwrap_err().to_string();
    assert!(faults.starts_with("angles (line 1, column 12): \"grad\"; allowed is radians, degrees"), "{faults}");
}

/// In the third state b has turned by a right angle about the second axis, where α and γ are not defined.
#[test]
fn a_gimbal_lock_is_told_with_state_node_and_angle() {
    for (outputs, expected) in [
        ("ALPHA", r#"element "e", frames[2], scene.angles: node "b" against node "a": beta is 1.57079632679489"#),
        ("UR1", r#"element "e", frames[2], scene.alignment: node "b" against node "a": "#),
    ] {
        let text = joint("align", "", outputs, &[[0.0; 3], [0.0, 0.3, 0.0], [0.0, PI / 2.0, 0.0]]);
        match Results::of(&scene(&text)) {
            Err(stopped) => assert!(stopped.to_string().starts_with(expected), "{stopped}"),
            // In doubles π/2 is not quite a right angle, and the residual is still defined.
            Ok(_) => assert_eq!(outputs, "UR1"),
        }
    }
}

/// Turned by 90° about e2, the arm e3 of b is along the arm e1 of a.
#[test]
fn a_cross_with_parallel_arms_is_refused_at_the_start_and_warned_of_later() {
    for kind in ["ujoint", "universal"] {
        let parallel = joint(kind, "", "UR1", &[[0.0; 3]])
            .replace(r#""b": {"at": [0, 0, 0]}"#, r#""b": {"at": [0, 0, 0], "orientation": "t"}"#);
        let parallel = parallel.replace(r#""o": {"#, &format!(r#""t": {{"rotation": [0, {}, 0]}}, "o": {{"#, PI / 2.0));
        let stopped = Results::of(&scene(&parallel)).unwrap_err().to_string();
        let expected = r#"element "e", initial configuration, scene.angles: node "b" against node "a": beta is 1.5707"#;
        assert!(stopped.starts_with(expected), "{stopped}");
        // Through the parallel position between two states, and into it.
        for (turns, state) in [
            (&[[0.0, 1.2, 0.0], [0.0, 2.0, 0.0], [0.0, 2.2, 0.0]][..], 1),
            (&[[0.0; 3], [0.0, 1.3, 0.0], [0.0, PI / 2.0, 0.0]], 2),
        ] {
            let text = joint(kind, "", "UR1", turns);
            let scene = scene(&text);
            let plan = Plan::new(&scene);
            let mut run = Run::<f64>::new(&plan).unwrap();
            while run.advance().unwrap() {}
            let expected = Warning::ParallelArms { state, element: "e".into(), nodes: ["a".into(), "b".into()] };
            assert_eq!(run.warnings(), [expected], "{kind} {turns:?}");
        }
        // Past it at some distance is no jump.
        let around = [[0.0, 1.2, 0.0], [0.3, 1.5, 0.0], [0.6, 1.2, 0.0]];
        assert_eq!(Results::of(&scene(&joint(kind, "", "UR1", &around))).unwrap().warnings, Vec::<String>::new());
        // Without angles nothing jumps.
        assert!(
            Results::of(&scene(&joint(kind, "", "GROT", &[[0.0, 1.2, 0.0], [0.0, 2.0, 0.0]])))
                .unwrap()
                .warnings
                .is_empty()
        );
    }
}

/// A ring of radius 2 at this height over a washer from r = 1 to r = 5, whose nodes run in this order.
fn ring(height: f64, nodes: &str) -> Scene {
    scene(&format!(
        r#"{{"dimension": "axisymmetric", "nodes": {{"1": {{"at": [1, 0]}}, "2": {{"at": [2, 0]}}, "3": {{"at": [5, 0]}},
        "p": {{"at": [1.5, {height}]}}, "q": {{"at": [1.75, {height}]}}}},
        "slide_lines": {{"washer": {{"type": "linear", "nodes": {nodes}, "pressure": {{"k": 1000}}}}}},
        "elements": {{"e": {{"kind": "isl21a", "nodes": ["p", "q"], "slide_line": "washer"}}}},
        "frames": [{{"time": 0}}, {{"time": 1}}], "outputs": ["S11"]}}"#
    ))
}

#[test]
fn a_node_far_on_the_wrong_side_of_its_line_is_warned_of_once() {
    let warnings = |height, nodes| Results::of(&ring(height, nodes)).unwrap().warnings;
    let [warning] = &warnings(5.0, r#"["3", "2", "1"]"#)[..] else { panic!("one warning") };
    let expected = "frames[0], node \"p\" is 5.0000 on the wrong side of slide line \"washer\", farther than the nearest segment is long \
        (1.0000): do the nodes of the line run the other way?";
    assert_eq!(warning, expected);
    for (height, nodes) in [(5.0, r#"["1", "2", "3"]"#), (-0.5, r#"["1", "2", "3"]"#), (-1.0, r#"["1", "2", "3"]"#)] {
        assert!(warnings(height, nodes).is_empty(), "{height}");
    }
}

/// The washer ends at r = 5 after a segment of 3; its extension ends at 5.3, or where the scene says.
#[test]
fn an_open_line_is_extended_as_the_keyword_page_says() {
    let text = |keys: &str| {
        format!(
            r#"{{"dimension": "axisymmetric", "nodes": {{"1": {{"at": [1, 0]}}, "2": {{"at": [2, 0]}}, "3": {{"at": [5, 0]}},
            "p": {{"at": [5.25, -0.5]}}, "q": {{"at": [5.5, -0.5]}}}},
            "slide_lines": {{"washer": {{"type": "linear", "nodes": ["1", "2", "3"], {keys} "pressure": {{"k": 1000}}}}}},
            "elements": {{"e": {{"kind": "isl21a", "nodes": ["p", "q"], "slide_line": "washer"}}}},
            "frames": [{{"time": 0}}], "outputs": ["E11", "S11"]}}"#
        )
    };
    for (keys, pressures) in [
        ("", [500.0, 0.0]),
        (r#""extension_zone": 0,"#, [0.0, 0.0]),
        (r#""smooth": 0.25, "extension_zone": 0.2,"#, [500.0, 500.0]),
    ] {
        let results = Results::of(&scene(&text(keys))).unwrap();
        assert_eq!(results.get("e", "S11", 0), Some(&pressures[..]), "{keys}");
        assert_eq!(results.get("e", "E11", 0), Some(&[-0.5; 2][..]));
    }
    for (keys, expected) in [
        (
            r#""extension_zone": 0.3,"#,
            "slide_lines.washer.extension_zone (line 3, column 102): 0.3; allowed is a number ≥ 0 and ≤ 0.2",
        ),
        (
            r#""smooth": -0.1,"#,
            "slide_lines.washer.smooth (line 3, column 94): -0.1; allowed is a number ≥ 0 and < 0.5",
        ),
    ] {
        assert_eq!(Scene::parse(&text(keys)).unwrap_err().to_string(), expected);
    }
}

#[test]
fn names_of_abaqus_are_accepted_or_answered() {
    let with = |outputs: &str| joint("hinge", "", outputs, &[[0.5, 0.0, 0.0]]);
    let results = Results::of(&scene(&with("CUR1"))).unwrap();
    assert_eq!(results.series.len(), 1);
    assert_eq!((results.series[0].output, results.get("e", "CUR1", 0)), ("UR1", results.get("e", "UR1", 0)));
    for (outputs, expected) in [
        (
            "CTM1",
            "no output \"CTM1\" (did you mean KM, of load and friction alone and in the global axes?); allowed is one of ",
        ),
        ("ur1", "no output \"ur1\" (did you mean UR1?); allowed is one of "),
        ("CV1", "no output \"CV1\"; allowed is one of "),
        ("UR1\", \"CUR1", "\"CUR1\" for the second time; allowed is each output once"),
    ] {
        let faults = Scene::parse(&with(outputs)).unwrap_err().to_string();
        assert!(faults.contains(expected), "{faults}");
    }
}

#[test]
fn one_cause_is_told_once() {
    let text = r#"{"dimension": "3d", "nodes": {"a": {"at": [0, 0, 0]}, "b": {"at": [0, 0, 0]}, "m": {"at": [0, 0, 0]}},
        "elements": {"e": {"kind": "slider", "nodes": ["a", "b", "m"]}}, "frames": [{"time": 0}], "outputs": OUTPUTS}"#;
    let kind = jointproof::scene::Kind::find("slider", jointproof::scene::Dimension::Space).unwrap();
    let outputs: Vec<_> = kind.outputs().map(|(name, _)| name).collect();
    let stopped = Results::of(&scene(&text.replace("OUTPUTS", &format!("{outputs:?}")))).unwrap_err().to_string();
    assert_eq!(stopped.lines().count(), 1, "{stopped}");
    assert!(stopped.starts_with(r#"element "e", frames[0], slider."#), "{stopped}");
}

#[test]
fn two_states_may_have_one_time_in_order() {
    let text = joint("hinge", "", "UR1", &[[0.1, 0.0, 0.0], [0.2, 0.0, 0.0]]);
    let results = Results::of(&scene(&text.replace(r#""time": 1"#, r#""time": 0"#))).unwrap();
    assert_eq!(results.times, [0.0, 0.0]);
    close(&only(&results, "UR1"), &[0.1, 0.2]);
    let faults = Scene::parse(&text.replace(r#""time": 0"#, r#""time": 2"#)).unwrap_err().to_string();
    assert!(faults.contains("frames[1].time"), "{faults}");
}
