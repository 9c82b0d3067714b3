//! Slide lines in scenes: the thread against closed forms, plans held to the least, hard contact, mistakes.

use jointproof::scene::{Plan, Results, Scene};

const THREAD: &str = include_str!("../golden/scenes/thread.json");

/// The sine and cosine of the taper, 1 in 16.
fn taper() -> (f64, f64) {
    let length = (1.0_f64 + 256.0).sqrt();
    (1.0 / length, 16.0 / length)
}

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-10 * expected.abs().max(1.0), "{found} is not {expected}");
}

/// The thread with other outputs.
fn plan(outputs: &str) -> Vec<(&'static str, usize)> {
    let text = THREAD.replace(r#"["E11", "E12", "S11", "S12", "T"]"#, outputs);
    let scene = scene(&text);
    Plan::new(&scene).lines().iter().map(|line| (line.formula, line.elements)).collect()
}

#[test]
fn only_what_an_output_needs_is_evaluated_and_each_node_once() {
    let search = ("slide_line.closest_smoothed_linear", 5);
    let slip = ("slide_line.slip_increment_linear", 5);
    let (pressure, map) = (("interaction.pressure_linear", 5), ("coulomb.return_map", 5));
    assert_eq!(plan("[]"), []);
    assert_eq!(plan(r#"["E11"]"#), [search]);
    assert_eq!(plan(r#"["E12"]"#), [search, slip]);
    assert_eq!(plan(r#"["S11"]"#), [search, pressure]);
    assert_eq!(plan(r#"["S12"]"#), [search, slip, pressure, map]);
    assert_eq!(plan(r#"["T"]"#), [search, pressure, ("slide_line.torque_linear", 4)]);
}

#[test]
fn an_element_of_which_nothing_is_wanted_is_not_looked_for() {
    let text = THREAD.replace(r#""slide_line": "box" },"#, r#""slide_line": "box", "outputs": [] },"#);
    let last_only = scene(&text);
    assert_eq!(Plan::new(&last_only).lines()[0].elements, 2);
    let (few, all) = (Results::of(&last_only).unwrap(), Results::of(&scene(THREAD)).unwrap());
    for series in few.series.iter().filter(|series| series.element != "box") {
        assert!(all.series.contains(series), "{} has changed", series.output);
    }
}

#[test]
fn far_segments_are_not_looked_at() {
    let results = Results::of(&scene(THREAD)).unwrap();
    let (formula, looked_at) = results.counts[0];
    assert_eq!(formula, "slide_line.closest_smoothed_linear");
    let every = 9 * 5 * results.times.len();
    assert!(looked_at * 2 < every, "{looked_at} of {every}");
}

#[test]
fn the_thread_closes_slips_sticks_and_carries_torque() {
    let results = Results::exact(&scene(THREAD)).unwrap();
    let (sine, cosine) = taper();
    let torque_of_cone =
        |pressure: f64| 2.0 * std::f64::consts::PI * pressure * (52.7_f64.powi(3) - 50.2_f64.powi(3)) / (3.0 * sine);
    let way = [0.0, 0.4, 0.8, 1.2, 1.6, 2.0, 1.999, 1.8, 1.0, 0.0];
    for (state, way) in way.into_iter().enumerate() {
        let closure = (way / 16.0 - 0.05) * cosine;
        let pressure = 2000.0 * closure.max(0.0);
        for (output, expected) in [("E11", -closure), ("E12", -way * cosine), ("S11", pressure)] {
            results.get("thread 2", output, state).unwrap().iter().for_each(|&found| close(found, expected));
        }
        // Where the flanks just touch, the pressure is what the rounding of the coordinates has left.
        let (torque, total) = (torque_of_cone(pressure), results.get("box", "T", state).unwrap()[0]);
        assert!((total - torque).abs() <= 1e-10 * torque_of_cone(150.0), "{total} is not {torque}");
    }
    let shear = |state| results.get("thread 1", "S12", state).unwrap()[0];
    let pressure = |state| results.get("thread 1", "S11", state).unwrap()[0];
    close(shear(5), -0.1 * pressure(5));
    // Backed off by 0.001, it sticks.
    close(shear(6), shear(5) + 0.001 * cosine * 5000.0);
    close(shear(7), 0.1 * pressure(7));
    // Open again, nothing is transmitted.
    assert_eq!((pressure(9), shear(9)), (0.0, 0.0));
}

#[test]
fn hard_contact_pushes_where_it_is_closed_and_only_there() {
    let text = r#"{"dimension": "axisymmetric",
        "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 0]}, "m": {"at": [2, 1]}, "n": {"at": [3, 1]}},
        "slide_lines": {"plate": {"type": "linear", "nodes": ["a", "b"]}},
        "elements": {"ring": {"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "plate"}},
        "frames": [{"time": 0, "pressures": {"m": 7, "n": 8}}, {"time": 1, "nodes": {"m": {"u": [0, -1]}}}],
        "outputs": ["E11", "S11"]}"#;
    let results = Results::of(&scene(text)).unwrap();
    assert_eq!(results.get("ring", "S11", 0), Some(&[0.0, 0.0][..]));
    assert_eq!(results.get("ring", "E11", 1), Some(&[0.0, 1.0][..]));
    assert_eq!(results.get("ring", "S11", 1), Some(&[7.0, 0.0][..]));
}

#[test]
fn what_is_wrong_with_slide_lines_is_said_with_its_place() {
    let text = r#"{
  "dimension": "axisymmetric",
  "nodes": { "a": { "at": [1, 0] }, "b": { "at": [5, 0] }, "m": { "at": [2, 1] } },
  "slide_lines": {
    "p": { "type": "parabolic", "nodes": ["a", "b"] },
    "q": { "type": "straight", "nodes": ["a", "c"], "smoothing": 0.5, "pressure": { "k": 1, "c0": 1 } },
    "r": { "friction": { "mu": 0.1 } }
  },
  "elements": {
    "e": { "kind": "isl21a", "nodes": ["a", "m"] },
    "f": { "kind": "isl21a", "nodes": ["a", "m"], "slide_line": "z" }
  },
  "frames": [ { "time": 0, "loads": {}, "pressures": { "b": -1 } } ]
}"#;
    let faults = Scene::parse(text).unwrap_err();
    let found: Vec<_> = faults.list().iter().map(ToString::to_string).collect();
    let expected = [
        "slide_lines.p (line 5, column 10): 2 nodes are given; allowed is an odd number of nodes",
        "slide_lines.q.type (line 6, column 20): \"straight\"; allowed is linear or parabolic",
        "slide_lines.q.nodes[1] (line 6, column 47): no node \"c\"",
        "slide_lines.q.smoothing (line 6, column 66): 0.5; allowed is",
        "slide_lines.q.pressure (line 6, column 83): 2 parameters; allowed is k alone, c0 and p0, or tolerance alone",
        "slide_lines.r.friction (line 7, column 24): 1 parameters; allowed is all of mu, k_stick",
        "slide_lines.r (line 7, column 10): a slide line without \"type\"",
        "slide_lines.r (line 7, column 10): a slide line without \"nodes\"",
        "elements.e (line 10, column 10): an element without \"slide_line\"",
        "elements.f.slide_line (line 11, column 65): no slide line \"z\"",
        "frames[0].loads (line 13, column 28): unknown key \"loads\"; allowed is one of time, nodes, pressures",
        "frames[0].pressures.b (line 13, column 56): a node of no element",
        "frames[0].pressures.b (line 13, column 61): -1; allowed is a finite number ≥ 0",
    ];
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.starts_with(expected), "found    {found}\nexpected {expected}");
    }
    assert_eq!(found.len(), expected.len(), "{found:#?}");

    let flat = r#"{"dimension": "3d", "nodes": {}, "slide_lines": {}, "elements": {}}"#;
    let faults = Scene::parse(flat).unwrap_err().to_string();
    assert_eq!(faults, "slide_lines (line 1, column 49): slide lines; allowed is none but in an axisymmetric scene");
}

#[test]
fn a_line_that_cannot_be_slid_on_is_named_with_the_state() {
    let text = r#"{"dimension": "axisymmetric",
        "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 0]}, "m": {"at": [2, 1]}, "n": {"at": [3, 1]}},
        "slide_lines": {"plate": {"type": "linear", "nodes": ["a", "b"]}},
        "elements": {"ring": {"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "plate"}},
        "frames": [{"time": 0}, {"time": 1, "nodes": {"b": {"u": [-4, 0]}}}], "outputs": ["E11"]}"#;
    let inside_out = text.replace("\"u\": [-4, 0]", "\"u\": [-6, 0]");
    let problems = Results::of(&scene(&inside_out)).unwrap_err().to_string();
    assert!(problems.contains("node \"b\" has the radius -1"), "{problems}");
    let problems = Results::of(&scene(text)).unwrap_err().to_string();
    assert!(
        problems.contains("\"plate\", frames[1]") && problems.contains("nodes \"a\" and \"b\" are at one place"),
        "{problems}"
    );
}

#[test]
fn threads_change_no_bit() {
    let scene = scene(THREAD);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Results::of(&scene).unwrap())
    };
    assert_eq!(with(1), with(5));
}
