//! Scenes: minimal plans, histories, results compared with the typed API and with closed forms.

use jointproof::connector::slot::{Pose, Slot};
use jointproof::scene::rules::RULES;
use jointproof::scene::{Columns, Plan, Results, Run, Scene, Stopped};
use jointproof::toolkit::verify::Options;
use nalgebra::Vector3;
use std::f64::consts::PI;

const TELESCOPE: &str = include_str!("../golden/scenes/telescope.json");
const DRIVE_SHAFT: &str = include_str!("../golden/scenes/drive-shaft.json");
const INTERFACE: &str = include_str!("../golden/scenes/interface.json");
const RAIL: &str = include_str!("../golden/scenes/rail.json");

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

/// A slot with two loads, and a third in space.
fn one(dimension: &str, element: &str, outputs: &str) -> Scene {
    let (b, u) = if dimension == "3d" { ("[1, 2, 3]", "[0.5, 0, 0.25]") } else { ("[1, 2]", "[0.5, 0.25]") };
    let (a, turn) =
        if dimension == "3d" { ("[0, 0, 0]", "\"rotation\": [0, 0, 0]") } else { ("[0, 0]", "\"angle\": 0") };
    scene(&format!(
        r#"{{"dimension": "{dimension}", "orientations": {{"o": {{{turn}}}}},
        "nodes": {{"a": {{"at": {a}, "orientation": "o"}}, "b": {{"at": {b}}}}},
        "elements": {{"e": {{{element}, "nodes": ["a", "b"]}}}},
        "frames": [{{"time": 0, "nodes": {{"b": {{"u": {u}}}}}, "loads": {{"e": {{"f1": 7, "f2": -3}}}}}}],
        "outputs": {outputs}}}"#
    ))
}

/// The formulas of a plan in order, with those at the start marked.
fn plan(scene: &Scene) -> Vec<String> {
    let lines = Plan::new(scene).lines();
    lines.iter().map(|line| format!("{}{}", if line.once { "start: " } else { "" }, line.formula)).collect()
}

fn sorted(mut plan: Vec<String>) -> Vec<String> {
    plan.sort();
    plan
}

#[test]
fn plans_hold_nothing_that_no_output_needs() {
    let slot = |outputs| plan(&one("3d", r#""kind": "slot""#, outputs));
    assert_eq!(slot("[]"), [""; 0]);
    assert_eq!(slot(r#"["FC"]"#), ["slot.contact_force"]);
    assert_eq!(slot(r#"["X"]"#), ["slot.relative_position"]);
    assert_eq!(slot(r#"["GY"]"#), ["start: slot.relative_position", "slot.constraint"]);
    // If μ is 0, no friction is computed, and Φ is 0.
    let yields = ["slot.contact_force", "slot.normal_force", "scene.traction", "coulomb.yield"];
    assert_eq!(sorted(slot(r#"["FN", "PHI"]"#)), sorted(yields.map(String::from).into()));
    assert_eq!(slot(r#"["KF"]"#), ["slot.kinetic_force"]);
    assert_eq!(slot(r#"["FN"]"#), ["slot.contact_force", "slot.normal_force"]);
}

#[test]
fn no_third_axis_in_the_plane() {
    let constraint = plan(&one("2d", r#""kind": "slot""#, r#"["GY"]"#));
    assert_eq!(constraint, ["start: slot.relative_position", "slot.constraint_2d"]);
    let scene = one("2d", r#""kind": "slot""#, r#"["FC", "U1", "GY", "RF"]"#);
    let results = Results::of(&scene).unwrap();
    assert_eq!(results.get("e", "FC", 0), Some(&[3.0][..]));
    assert_eq!(results.get("e", "U1", 0), Some(&[0.5][..]));
    assert_eq!(results.get("e", "GY", 0), Some(&[0.25][..]));
    assert_eq!(results.get("e", "RF", 0), Some(&[0.0, -3.0, 0.0][..]));
    // The values computed at the start are not used in place of the missing force.
    for outputs in [r#"["FC", "GY"]"#, r#"["FC", "U1"]"#, r#"["FC", "U1", "GY"]"#, r#"["FC", "X", "GY"]"#] {
        let results = Results::of(&one("2d", r#""kind": "slot""#, outputs)).unwrap();
        assert_eq!(results.get("e", "FC", 0), Some(&[3.0][..]), "{outputs}");
    }
    let error = Scene::parse(
        r#"{"dimension": "2d", "orientations": {"o": {"angle": 0}}, "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": [0, 0]}},
        "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}}, "frames": [{"time": 0, "loads": {"e": {"f3": 1}}}]}"#,
    );
    assert!(error.unwrap_err().to_string().contains("unknown key \"f3\"; allowed is one of f1, f2"));
}

#[test]
fn no_lever_no_moment_term() {
    let translator = |levers| plan(&one("3d", &format!(r#""kind": "translator"{levers}"#), r#"["FC", "PHI"]"#));
    assert_eq!(translator("")[0], "slot.contact_force");
    assert_eq!(translator(r#", "rr": 0, "l": 0"#)[0], "slot.contact_force");
    assert_eq!(translator(r#", "rr": 2"#)[0], "translator.contact_force");
    assert!([translator(""), translator(r#", "rr": 2"#)].iter().all(|plan| plan.len() == 4));
}

#[test]
fn a_reference_length_saves_the_initial_one() {
    let motion = |given| plan(&one("3d", &format!(r#""kind": "slot"{given}"#), r#"["U1MAT"]"#));
    assert_eq!(motion("").len(), 3);
    let length = |given: &str| {
        let scene = one("3d", &format!(r#""kind": "slot"{given}"#), r#"["U1", "U1MAT"]"#);
        let results = Results::of(&scene).unwrap();
        ["U1", "U1MAT"].map(|output| results.get("e", output, 0).unwrap()[0])
    };
    // From x = 1 to 1.5.
    assert_eq!((length(""), length(r#", "l1_ref": 2"#)), ([0.5, 0.5], [0.5, -0.5]));
    // relative_motion gives u1 too, which needs x0.
    assert_eq!(
        motion(r#", "l1_ref": 2"#),
        ["start: slot.relative_position", "slot.relative_position", "slot.relative_motion"]
    );
}

#[test]
fn the_scene_of_the_readme_is_the_first_example() {
    let readme = include_str!("../README.md");
    let block = readme.split("```json").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let of_readme: serde_json::Value = serde_json::from_str(block).unwrap();
    let mut of_example: serde_json::Value = serde_json::from_str(RAIL).unwrap();
    of_example.as_object_mut().unwrap().remove("title");
    assert_eq!(of_readme, of_example);
    let results = Results::of(&scene(block)).unwrap();
    let sticking = results.get("guide", "CSF1", 0).unwrap()[0];
    assert!((sticking - 1.0).abs() < 1e-12, "it sticks: 1000 times 0.001, less the rounding of the way");
    assert_eq!(results.get("guide", "CSF1", 1), Some(&[1.25][..]), "it slips at μ times 5");
}

/// A hinge between two coincident nodes, of which this one has these rotation vectors in turn; its angle in every state.
fn hinged(node: &str, turns: &[[f64; 3]]) -> (Vec<f64>, Vec<String>) {
    let frame =
        |(time, ur): (usize, &[f64; 3])| format!(r#"{{"time": {time}, "nodes": {{"{node}": {{"ur": {ur:?}}}}}}}"#);
    let frames: Vec<_> = turns.iter().enumerate().map(frame).collect();
    let scene = scene(&format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0]}}}},
        "elements": {{"e": {{"kind": "hinge", "nodes": ["a", "b"]}}}}, "frames": [{}], "outputs": ["UR1"]}}"#,
        frames.join(", ")
    ));
    let results = Results::of(&scene).unwrap();
    let angles = (0..turns.len()).map(|state| results.get("e", "UR1", state).unwrap()[0]).collect();
    (angles, results.warnings)
}

#[test]
fn angles_follow_rotation_vectors_along_one_axis_however_far() {
    let near = |found: &[f64], expected: &[f64]| {
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12), "{found:?}");
    };
    let half_turns: Vec<f64> = (0..=6).map(|k| f64::from(k) * PI).collect();
    let along: Vec<_> = half_turns.iter().map(|&angle| [angle, 0.0, 0.0]).collect();
    let (angles, warnings) = hinged("b", &along);
    near(&angles, &half_turns);
    assert!(warnings.is_empty(), "{warnings:?}");
    near(&hinged("a", &along).0, &half_turns.iter().map(|angle| -angle).collect::<Vec<_>>());
    // At once, at the start, and back through many turns.
    near(&hinged("b", &[[3.5, 0.0, 0.0], [-100.0, 0.0, 0.0], [0.0; 3]]).0, &[3.5, -100.0, 0.0]);
}

#[test]
fn a_large_rotation_about_another_axis_is_warned_of() {
    let (angles, warnings) = hinged("b", &[[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 3.5, 0.0]]);
    assert_eq!(angles[0], 3.0);
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(warning.starts_with("frames[1], node \"b\": its rotation vector changes by 4.2426 (243.1°)"), "{warning}");
}

#[test]
fn angles_beyond_a_turn_are_asked_about() {
    let of = |angle: &str| {
        let element = format!(r#""kind": "hinge", "theta1_ref": {angle}"#);
        one("3d", &element, r#"["UR1MAT"]"#).warnings()
    };
    assert_eq!(of("6.25"), Vec::<String>::new());
    assert_eq!(
        of("90"),
        ["elements.e.theta1_ref is 90, more than a full turn: angles are in radians, and 90° would be 1.570796; \
          say \"angles\": \"degrees\" or \"radians\""]
    );
}

#[test]
fn counts_are_what_ran() {
    let results = Results::of(&scene(TELESCOPE)).unwrap();
    assert_eq!(results.times.len(), 9);
    assert_eq!(one("3d", r#""kind": "slot""#, "[]").nodes(), 2);
    let count = |id| results.counts.iter().find(|(formula, _)| *formula == id).map_or(0, |&(_, count)| count);
    assert_eq!((count("slot.constraint"), count("slot.relative_position"), count("scene.angles")), (9, 10, 1));
    assert_eq!((count("translator.contact_force"), count("slot.contact_force")), (9, 0));
}

#[test]
fn an_unrelated_element_changes_no_bit() {
    let alone = Results::of(&scene(TELESCOPE)).unwrap();
    let element = r#""elements": { "other": { "kind": "slot", "nodes": ["inner", "outer"], "mu": 0.5, "k_stick": 10,
        "outputs": ["CSF1", "GZ"] }, "#;
    let more = Results::of(&scene(&TELESCOPE.replace("\"elements\": {", element))).unwrap();
    for series in &alone.series {
        assert!(more.series.contains(series), "{} has changed", series.output);
    }
    assert_eq!(more.series.len(), alone.series.len() + 2);
}

#[test]
fn results_are_those_of_the_typed_api() {
    let given = r#""kind": "slot", "mu": 0.25, "fc_int": 2, "k_stick": 1"#;
    let scene = one("3d", given, r#"["GY", "GZ", "U1", "CSF1", "P", "FN", "PHI"]"#);
    let results = Results::of(&scene).unwrap();
    let triad = jointproof::element::frame::Triad::global();
    let mut pose = Pose { triad, xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) };
    let slot = Slot::new(&pose).unwrap().with_friction(0.25, 2.0).unwrap();
    pose.xb += Vector3::new(0.5, 0.0, 0.25);
    let (g, u) = (slot.constraint(&pose).unwrap(), slot.relative_motion(&pose).unwrap());
    let found = results.get("e", "CSF1", 0).unwrap()[0];
    let friction = slot.friction(found, -3.0, 0.0).unwrap();
    let expected =
        [("GY", g.gy), ("GZ", g.gz), ("U1", u.u1), ("P", friction.p), ("FN", friction.r#fn), ("PHI", friction.phi)];
    for (output, expected) in expected {
        assert_eq!(results.get("e", output, 0), Some(&[expected][..]), "{output}");
    }
}

#[test]
fn the_telescope_sticks_slips_turns_back_and_meets_its_stops() {
    let results = Results::exact(&scene(TELESCOPE)).unwrap();
    let at = |output, state| results.get("telescope", output, state).unwrap()[0];
    // 1.5/0.02 + |(30, -40)| + 2 |(6, -8)|/0.25 + 20 of press fit
    assert_eq!(at("FN", 0), 225.0);
    assert_eq!(at("CSF1", 0), 0.0);
    // 200 µm need a force of 40, the limit is 33.75: the rest is slip.
    assert_eq!(at("CSF1", 1), 33.75);
    assert!((at("CASU1", 1) - (0.0002 - 33.75 / 200_000.0)).abs() < 1e-18);
    assert_eq!(at("CSF1", 2), 33.75);
    // It moves back by 250 µm: the force falls by 50 and nothing slips.
    assert_eq!(at("CASU1", 6), at("CASU1", 5));
    assert!((at("CSF1", 5) - at("CSF1", 6) - 50.0).abs() < 1e-9);
    assert!(at("CSF1", 7) < 0.0 && at("FTORQ", 7) == 0.0);
    let slips = (1..9).all(|state| at("CASU1", state) >= at("CASU1", state - 1));
    assert!(slips, "accumulated slip never falls");
    assert!((at("GAPMIN", 0) - 0.1).abs() < 1e-15 && at("GAPMAX", 5).abs() < 1e-15, "the upper stop closes");
    assert!(at("GAPMIN", 8).abs() < 1e-15, "the lower stop closes");
}

/// tan θ2 = tan θ1 / cos δ, if the arm of the input yoke starts in the plane of the shafts.
#[test]
fn universal_joints_turn_as_the_closed_form_says() {
    let results = Results::of(&scene(DRIVE_SHAFT)).unwrap();
    for series in results.series.iter().filter(|series| ["GROT", "G"].contains(&series.output)) {
        let worst = series.values.iter().flatten().fold(0.0_f64, |worst, g| worst.max(g.abs()));
        assert!(worst < 1e-15, "{} {}: {worst:e}", series.element, series.output);
    }
    // The residual changes its sign exactly where the closed form predicts.
    let delta = std::f64::consts::FRAC_PI_6;
    for degrees in [10.0_f64, 40.0, 75.0, 130.0, 200.0, 300.0] {
        let theta = degrees.to_radians();
        let turned = theta.sin().atan2(theta.cos() * delta.cos());
        let residual = |off: f64| {
            let (axis, angle) = ([delta.cos(), delta.sin()], turned + off);
            let frame = format!(
                r#""frames": [{{"time": 0, "nodes": {{"input": {{"ur": [{theta}, 0, 0]}},
                "middle 1": {{"ur": [{}, {}, 0]}}}}}}], "outputs": ["GROT"]}}"#,
                axis[0] * angle,
                axis[1] * angle
            );
            let text = DRIVE_SHAFT.split("\"frames\"").next().unwrap().to_owned() + &frame;
            Results::of(&scene(&text)).unwrap().get("first", "GROT", 0).unwrap()[0]
        };
        assert!(residual(0.0).abs() < 1e-15);
        assert!(residual(1e-6) * residual(-1e-6) < 0.0, "{degrees}°");
    }
}

#[test]
fn two_joints_in_phase_keep_the_ratio_constant() {
    // The scene rotates input and output equally; the residual of the second joint shows that this is the correct output.
    let results = Results::exact(&scene(DRIVE_SHAFT)).unwrap();
    for state in 0..results.times.len() {
        assert!(results.get("second", "GROT", state).unwrap()[0].abs() < 1e-15);
    }
}

#[test]
fn sliders_stay_on_the_line_until_one_leaves_it() {
    let results = Results::of(&scene(INTERFACE)).unwrap();
    let off = |element, state| {
        let g = |output| results.get(element, output, state).unwrap()[0];
        g("G1").hypot(g("G2"))
    };
    for element in ["inner", "middle", "outer"] {
        assert!((0..5).all(|state| off(element, state) < 1e-11));
    }
    assert!(off("middle", 5) < 1e-11);
    let expected = 0.01 * 0.25_f64.cos();
    assert!((off("outer", 5) - expected).abs() < 1e-10, "{} {expected}", off("outer", 5));
}

/// On a rotating line, the increment from the documented formula is that of the node, which stays on the line.
#[test]
fn a_slider_in_the_plane_follows_its_line() {
    let scene = scene(
        r#"{"dimension": "2d", "nodes": {"a": {"at": [0, 0]}, "b": {"at": [4, 2]}, "m": {"at": [2, 1]}},
        "elements": {"rail": {"kind": "slider", "nodes": ["a", "b", "m"]}},
        "frames": [{"time": 0}, {"time": 1, "nodes": {"m": {"u": [1, 0.5]}}},
        {"time": 2, "nodes": {"b": {"u": [0, 4]}, "m": {"u": [1, 3.5]}}}], "outputs": ["G", "DXMI"]}"#,
    );
    let results = Results::exact(&scene).unwrap();
    let at = |output, state| results.get("rail", output, state).unwrap()[0];
    assert_eq!([at("G", 0), at("G", 1), at("DXMI", 0), at("DXMI", 1)], [0.0, 0.0, 0.0, 0.5]);
    // The line is now steep, so that x follows from y: w = (0, 3), dx = 2/3 × (3 - 3).
    assert_eq!([at("G", 2), at("DXMI", 2)], [0.0, 0.0]);
}

#[test]
fn threads_change_no_bit() {
    // Two kinds alternate, and in the frames the last comes first.
    let nodes = (1..5000).map(|i| format!(r#""a{i}": {{"at": [{i}, 0.1, 0]}}, "#)).collect::<Vec<_>>().concat();
    let kind = |i: usize| if i.is_multiple_of(3) { "translator" } else { "slot" };
    let element =
        |i| format!(r#""e{i}": {{"kind": "{}", "nodes": ["a0", "a{i}"], "mu": 0.{i}, "k_stick": 1e4}}"#, kind(i));
    let elements: Vec<_> = (1..5000).map(element).collect();
    let moved = |i| format!(r#""a{i}": {{"u": [0.00{i}, 0.1, 0.2], "ur": [0, 0.0{i}, 0.1]}}"#);
    let moves: Vec<_> = (1..5000).rev().map(moved).collect();
    let loads: Vec<_> = (1..5000).rev().map(|i| format!(r#""e{i}": {{"f3": 0.5, "f2": {i}}}"#)).collect();
    let of = |elements: &[String], loads: &[String]| {
        scene(&format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}}, "nodes": {{{nodes}"a0": {{"at": [0, 0.1, 0], "orientation": "o"}}}}, "elements": {{{}}}, "frames": [
            {{"time": 0, "loads": {{{}}}}}, {{"time": 1, "nodes": {{{}}}}}, {{"time": 2, "nodes": {{"a1": {{"u": [0, 0, 0]}}}}}}],
            "outputs": ["GY", "GZ", "U1", "CSF1", "CASU1", "PHI"]}}"#,
            elements.join(", "),
            loads.join(", "),
            moves.join(", ")
        ))
    };
    let only = |i: usize| of(&elements[i - 1..i], &loads[4999 - i..5000 - i]);
    let scene = of(&elements, &loads);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Results::of(&scene).unwrap())
    };
    let results = with(1);
    assert_eq!(results, with(5));
    // One by one, they give the same results.
    for i in [1, 64, 66, 4095, 4999] {
        let alone = Results::of(&only(i)).unwrap();
        let of_element = results.series.iter().filter(|series| series.element == format!("e{i}"));
        assert!(of_element.eq(&alone.series), "e{i}");
    }
}

/// Frames that repeat everything give the same results as frames that mention only changes.
#[test]
fn what_a_frame_does_not_mention_stays() {
    let results = |frames: [&str; 4]| {
        Results::of(&scene(&format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
            "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [4, 2, 1]}}, "m": {{"at": [2, 1, 0.5]}}, "n": {{"at": [3, 1, 0], "orientation": "o"}}}},
            "elements": {{
                "rail": {{"kind": "slider", "nodes": ["a", "b", "m"], "outputs": ["G1", "G2", "R1", "DXMI"]}},
                "pin": {{"kind": "translator", "nodes": ["a", "n"], "mu": 0.5, "k_stick": 10, "rr": 1, "l": 2,
                    "outputs": ["U1", "UR1", "FC", "CSF1"]}},
                "guide": {{"kind": "translator", "nodes": ["n", "m"], "mu": 0.5, "k_stick": 10, "rr": 1, "l": 2,
                    "outputs": ["U1", "UR1", "FC", "CSF1"]}}
            }}, "frames": [{}]}}"#,
            frames.join(", ")
        )))
        .unwrap()
    };
    let brief = results([
        r#"{"time": 0, "loads": {"pin": {"f2": 3, "m1": 1}, "guide": {"f2": 1}}}"#,
        r#"{"time": 1, "nodes": {"m": {"u": [1, 0.5, 0.25]}, "n": {"u": [1, 0, 0], "ur": [0.1, 0, 0]}, "b": {"u": [0, 0, 1]}}}"#,
        r#"{"time": 2, "nodes": {"b": {"u": [0, 1, 0]}}, "loads": {"guide": {"f2": -2, "f3": 5}}}"#,
        r#"{"time": 3}"#,
    ]);
    let [pin, m] = [r#""pin": {"f2": 3, "f3": 0, "m1": 1}"#, r#""m": {"u": [1, 0.5, 0.25], "ur": [0, 0, 0]}"#];
    let n = r#""n": {"u": [1, 0, 0], "ur": [0.1, 0, 0]}"#;
    let last = format!(
        r#""nodes": {{"b": {{"u": [0, 1, 0]}}, {n}, {m}}}, "loads": {{{pin}, "guide": {{"m1": 0, "f3": 5, "f2": -2}}}}"#
    );
    let full = results([
        &format!(
            r#"{{"time": 0, "nodes": {{"n": {{"u": [0, 0, 0]}}, "m": {{"u": [0, 0, 0]}}, "b": {{"u": [0, 0, 0]}}}}, "loads": {{"guide": {{"f2": 1}}, {pin}}}}}"#
        ),
        &format!(
            r#"{{"time": 1, "nodes": {{{m}, {n}, "b": {{"u": [0, 0, 1]}}}}, "loads": {{{pin}, "guide": {{"f2": 1, "f3": 0}}}}}}"#
        ),
        &format!(r#"{{"time": 2, {last}}}"#),
        &format!(r#"{{"time": 3, {last}}}"#),
    ]);
    assert_eq!(brief.series, full.series);
    let moved = |state| brief.get("rail", "DXMI", state).unwrap()[0];
    assert_eq!([moved(0) != 0.0, moved(1) != 0.0, moved(2) != 0.0, moved(3) != 0.0], [false, true, true, false]);
}

#[test]
fn the_rules_of_scenes_pass_the_audit() {
    let audits = RULES.iter().map(|rule| rule.audit(&Options { samples: 60, ..Options::default() }));
    let failed: Vec<_> = audits.filter(|audit| !audit.passed()).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    let smooth = RULES.iter().filter(|rule| rule.kinks_as_printed().is_empty()).map(|rule| rule.spec().id);
    let known =
        ["scene.increment", "scene.follow", "scene.kinetic", "scene.join_force", "scene.bearing", "scene.turned_back"];
    assert_eq!(smooth.collect::<Vec<_>>(), known);
}

#[test]
fn what_a_formula_rejects_in_a_state_names_element_and_state() {
    let scene = scene(
        r#"{"dimension": "3d", "nodes": {"a": {"at": [0, 0, 0]}, "b": {"at": [0, 0, 1]}, "m": {"at": [0, 0, 0.5]}},
        "elements": {"rail": {"kind": "slider", "nodes": ["a", "b", "m"]}},
        "frames": [{"time": 0}, {"time": 1, "nodes": {"b": {"u": [0, 0, -1]}}}], "outputs": ["G1"]}"#,
    );
    let problems = Results::of(&scene).unwrap_err().to_string();
    assert!(problems.starts_with("element \"rail\", frames[1], slider.constraint: x1 and xn are 0"), "{problems}");
    assert_eq!(Results::exact(&scene).unwrap_err().to_string(), problems);
}

#[test]
fn a_plan_counts_what_runs_and_the_start_runs_once() {
    for text in [TELESCOPE, DRIVE_SHAFT, INTERFACE, RAIL] {
        let scene = scene(text);
        let plan = Plan::new(&scene);
        let results = Results::of(&scene).unwrap();
        assert_eq!(plan.counts(results.times.len()), results.counts);
        // Nothing was evaluated for any state before the first.
        let run = Run::<f64>::new(&plan).unwrap();
        let mut at_start: Vec<_> = plan.lines().into_iter().filter(|line| line.once).map(|line| line.formula).collect();
        at_start.dedup();
        let mut counted: Vec<_> = run.counts().into_iter().map(|(formula, _)| formula).collect();
        assert!(run.counts().iter().all(|&(_, count)| count > 0));
        at_start.sort_unstable();
        at_start.dedup();
        counted.sort_unstable();
        assert_eq!(counted, at_start);
    }
}

#[test]
fn results_of_the_first_elements_alone_are_kept() {
    let scene = scene(DRIVE_SHAFT);
    let plan = Plan::new(&scene);
    let (all, mut states) = (Results::of(&scene).unwrap(), 0);
    let first = Results::collect::<f64>(&plan, 1, || states += 1).unwrap();
    assert_eq!(states, all.times.len());
    let name = &all.series[0].element;
    assert!(first.series.iter().eq(all.series.iter().filter(|series| series.element == *name)));
    assert!(first.series.len() < all.series.len() && !first.series.is_empty());
}

#[test]
fn a_column_is_that_of_an_element_and_an_output() {
    let scene = one("3d", r#""kind": "slot""#, r#"["U1", "FC"]"#);
    let columns = Columns::of(&scene).unwrap();
    let numbers = |element, output| columns.get(element, output).map(|column| &*column.numbers);
    assert_eq!([numbers("e", "U1"), numbers("e", "FC")], [Some(&[0.5][..]), Some(&[3.0][..])]);
    assert_eq!([numbers("e", "X"), numbers("a", "U1")], [None; 2]);
}

#[test]
fn the_largest_double_is_a_result() {
    let text = r#"{"dimension": "2d", "orientations": {"o": {"angle": 0}},
        "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": [1, 0]}},
        "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["KF"],
        "frames": [{"time": 0, "loads": {"e": {"f1": -1.7976931348623157e308}}}]}"#;
    assert_eq!(Results::of(&scene(text)).unwrap().get("e", "KF", 0).unwrap()[0], f64::MIN);
}

#[test]
fn a_hundred_problems_are_listed_at_most() {
    let listed = |text: &str| match Results::of(&scene(text)) {
        Err(Stopped::Problems(problems)) => problems.0.len(),
        other => panic!("{other:?}"),
    };
    // At the start: two groups of sixty.
    let outputs = |k: usize| if k.is_multiple_of(2) { r#""UR2""# } else { r#""UR1", "UR2""# };
    let element = |k| format!(r#""e{k}": {{"kind": "translator", "nodes": ["a", "b"], "outputs": [{}]}}"#, outputs(k));
    let elements = (0..120).map(element).collect::<Vec<_>>().join(", ");
    let start = format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 1.57, 0]}}, "p": {{"rotation": [0, 0, 0]}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0], "orientation": "p"}}}},
        "elements": {{{elements}}}}}"#
    );
    assert_eq!(listed(&start), 100);
    // In a state: as many slide lines.
    let each = |of: fn(usize) -> String| (0..101).map(of).collect::<Vec<_>>().join(", ");
    let lines = each(|k| format!(r#""l{k}": {{"type": "linear", "nodes": ["a", "b"]}}"#));
    let rings = each(|k| format!(r#""r{k}": {{"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "l{k}"}}"#));
    let state = format!(
        r#"{{"dimension": "axisymmetric", "slide_lines": {{{lines}}}, "elements": {{{rings}}}, "outputs": ["E11"],
        "nodes": {{"a": {{"at": [1, 0]}}, "b": {{"at": [5, 0]}}, "m": {{"at": [2, 1]}}, "n": {{"at": [3, 1]}}}},
        "frames": [{{"time": 0}}, {{"time": 1, "nodes": {{"b": {{"u": [-4, 0]}}}}}}]}}"#
    );
    assert_eq!(listed(&state), 100);
}

#[test]
fn nodes_may_turn_whose_triad_nobody_reads() {
    let results = |turn: &str| {
        let text = format!(
            r#"{{"dimension": "3d", "nodes": {{"a": {{"at": [0, 0, 0]}}, "b": {{"at": [2, 0, 0]}}, "m": {{"at": [1, 1, 0]}}}},
            "elements": {{"rail": {{"kind": "slider", "nodes": ["a", "b", "m"]}}}}, "outputs": ["G1", "G2"],
            "frames": [{{"time": 0, "nodes": {{"m": {{"u": [0, 1, 0]{turn}}}}}}}]}}"#
        );
        Results::of(&scene(&text)).unwrap()
    };
    assert_eq!(results(""), results(r#", "ur": [0, 0, 1]"#));
}
