//! Slide lines in scenes: the thread compared with closed forms, minimal plans, hard contact, mistakes.

use jointproof::contact::isl::{Contact, ElementSet, Increment, Interaction, IslElement};
use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
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

/// The thread with different outputs.
fn plan(outputs: &str) -> Vec<(&'static str, usize)> {
    let text = THREAD.replace(r#"["E11", "E12", "S11", "S12", "T"]"#, outputs);
    let scene = scene(&text);
    Plan::new(&scene).lines().iter().map(|line| (line.formula, line.elements)).collect()
}

#[test]
fn only_what_an_output_needs_is_evaluated_and_each_node_once() {
    let search = ("slide_line.closest_smoothed_linear", 5);
    let slip = ("slide_line.slip_increment_linear", 5);
    let (pressure, map) = (("interaction.pressure_linear", 5), ("coulomb.response", 5));
    assert_eq!(plan("[]"), []);
    assert_eq!(plan(r#"["E11"]"#), [search]);
    assert_eq!(plan(r#"["E12"]"#), [search, slip]);
    assert_eq!(plan(r#"["S11"]"#), [search, pressure]);
    assert_eq!(plan(r#"["S12"]"#), [search, slip, pressure, map]);
    assert_eq!(plan(r#"["T"]"#), [search, pressure, ("slide_line.torque_linear", 4)]);
}

#[test]
fn a_plan_counts_the_slave_nodes_of_one_line_and_its_elements() {
    let lines = Plan::new(&scene(THREAD)).lines();
    let counted = lines.iter().map(|line| (line.elements, line.kind));
    assert_eq!(counted.collect::<Vec<_>>(), [[(5, "slave node"); 4].as_slice(), &[(4, "element")]].concat());
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
    let (formula, examined) = results.counts[0];
    assert_eq!(formula, "slide_line.closest_smoothed_linear");
    let every = 9 * 5 * results.times.len();
    assert!(examined * 2 < every, "{examined} of {every}");
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
        // Where the flanks just touch, the pressure consists of rounding errors of the coordinates.
        let (torque, total) = (torque_of_cone(pressure), results.get("box", "T", state).unwrap()[0]);
        assert!((total - torque).abs() <= 1e-10 * torque_of_cone(150.0), "{total} is not {torque}");
    }
    let shear = |state| results.get("thread 1", "S12", state).unwrap()[0];
    let pressure = |state| results.get("thread 1", "S11", state).unwrap()[0];
    close(shear(5), -0.1 * pressure(5));
    // Moved back by 0.001, it sticks.
    close(shear(6), shear(5) + 0.001 * cosine * 5000.0);
    close(shear(7), 0.1 * pressure(7));
    // Open again, it transmits nothing.
    assert_eq!((pressure(9), shear(9)), (0.0, 0.0));
}

#[test]
fn hard_contact_pushes_where_it_is_closed_and_only_there() {
    let text = r#"{"dimension": "axisymmetric",
        "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 0]}, "m": {"at": [2, 1]}, "n": {"at": [3, 1]}},
        "slide_lines": {"plate": {"type": "linear", "nodes": ["a", "b"]}},
        "elements": {"ring": {"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "plate"}},
        "frames": [{"time": 0, "pressures": {"m": 7, "n": 8}}, {"time": 1, "nodes": {"m": {"u": [0, -1]}}},
        {"time": 2, "pressures": {"m": 4}}],
        "outputs": ["E11", "S11"]}"#;
    let results = Results::of(&scene(text)).unwrap();
    assert_eq!(results.get("ring", "S11", 0), Some(&[0.0, 0.0][..]));
    assert_eq!(results.get("ring", "E11", 1), Some(&[0.0, 1.0][..]));
    assert_eq!(results.get("ring", "S11", 1), Some(&[7.0, 0.0][..]));
    // A pressure that is given again replaces the previous one.
    assert_eq!(results.get("ring", "S11", 2), Some(&[4.0, 0.0][..]));
}

#[test]
fn what_is_wrong_with_slide_lines_is_said_with_its_place() {
    let text = r#"{
  "dimension": "axisymmetric",
  "nodes": { "a": { "at": [1, 0] }, "b": { "at": [5, 0] }, "m": { "at": [2, 1] } },
  "slide_lines": {
    "p": { "type": "parabolic", "nodes": ["a", "b"] },
    "q": { "type": "straight", "nodes": ["a", "c"], "smooth": 0.5, "pressure": { "k": 1, "c0": 1 } },
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
        "slide_lines.q.smooth (line 6, column 63): 0.5; allowed is",
        "slide_lines.q.pressure (line 6, column 80): 2 parameters; allowed is k alone, c0 and p0, or tolerance alone",
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
        problems.contains("\"plate\", frames[1]") && problems.contains("nodes \"a\" and \"b\" coincide"),
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

/// An ISL22A ring on a plate: its size, the interaction, and the requested outputs. The last frame presses it down by a
/// thousandth of its height.
fn ring(size: f64, interaction: &str, outputs: &str) -> String {
    let at = |r: f64, z: f64| format!("[{:e}, {:e}]", r * size, z * size);
    let nodes = RING.map(|(name, [r, z])| format!(r#""{name}": {{"at": {}}}"#, at(r, z)));
    let pressed = ["m", "n", "o"].map(|name| format!(r#""{name}": {{"u": {}}}"#, at(PRESSED[0], PRESSED[1])));
    format!(
        r#"{{"dimension": "axisymmetric", "nodes": {{{}}},
        "slide_lines": {{"plate": {{"type": "linear", "nodes": ["a", "b"], {interaction}}}}},
        "elements": {{"ring": {{"kind": "isl22a", "nodes": ["m", "n", "o"], "slide_line": "plate"}}}},
        "frames": [{{"time": 0}}, {{"time": 0.5, "nodes": {{{}}}}}], "outputs": {outputs}}}"#,
        nodes.join(", "),
        pressed.join(", ")
    )
}

const RING: [(&str, [f64; 2]); 5] =
    [("a", [1.0, 0.0]), ("b", [5.0, 0.0]), ("m", [2.0, 1.0]), ("n", [2.5, 1.0]), ("o", [3.0, 1.0])];
const PRESSED: [f64; 2] = [0.5, -1.001];
const ALL: &str = r#"["E11", "E12", "S11", "S12", "T"]"#;
const RUBBING: &str = r#""pressure": {"c0": 0.1, "p0": 7}, "damping": {"mu0": 3, "c0": 0.2, "eta": 0.5},
    "friction": {"mu": 0.25, "k_stick": 9}"#;

#[test]
fn an_overflow_is_blamed_on_the_formula_and_the_place_where_it_was() {
    let expect = |text: &str, expected: &str| {
        let first = Results::of(&scene(text)).unwrap_err().to_string();
        assert!(first.starts_with(expected), "found    {first}\nexpected {expected}");
    };
    let node = |formula: &str| format!("node \"m\" on slide line \"plate\", frames[1], {formula}");
    let steep = r#""pressure": {"k": 1e200}"#;
    let of_element =
        "element \"ring\" on slide line \"plate\", frames[1], slide_line.torque_parabolic: torque is too large";
    expect(&ring(1e50, steep, r#"["T"]"#), of_element);
    expect(&ring(1.0, r#""pressure": {"c0": 1e-9, "p0": 1}"#, r#"["S11"]"#), &node("interaction.pressure_exponential"));
    let viscous = r#""damping": {"mu0": 1e308, "c0": 1, "eta": 0}"#;
    expect(&ring(1e9, viscous, r#"["S11"]"#), &node("interaction.damping"));
    let sticking = r#""pressure": {"k": 1}, "friction": {"mu": 1e308, "k_stick": 1e308}"#;
    expect(&ring(1e9, sticking, r#"["S12"]"#), &node("coulomb.response: s12 is too large"));

    // Two elements whose torques are each representable as a double, but not their sum.
    let torque = Results::of(&scene(&ring(10.0, r#""pressure": {"k": 1}"#, r#"["T"]"#))).unwrap();
    let k = 1.2e308 / torque.get("plate", "T", 1).unwrap()[0];
    let one = ring(10.0, &format!(r#""pressure": {{"k": {k:e}}}"#), r#"["T"]"#);
    assert!(Results::of(&scene(&one)).is_ok());
    let element = one.split("\"ring\": ").nth(1).and_then(|rest| rest.split('}').next()).unwrap();
    let two = one.replace("\"ring\": ", &format!("\"other\": {element}}}, \"ring\": "));
    expect(&two, "slide line \"plate\", frames[1], slide_line.torque_parabolic: torque is too large");
}

#[test]
fn a_scene_and_a_contact_give_the_same_bits() {
    let results = Results::of(&scene(&ring(1.0, RUBBING, ALL))).unwrap();
    let line = SlideLine::new(Interpolation::Linear, [0, 1]).unwrap();
    let elements = ElementSet::new("ring", [IslElement::isl22a(0, [2, 3, 4]).unwrap()]).unwrap();
    let interaction = Interaction::exponential(0.1, 7.0).unwrap().with_damping(3.0, 0.2, 0.5).unwrap();
    let contact = Contact::new(line, elements, interaction.with_friction(0.25, 9.0).unwrap());
    let places = |by: [f64; 2]| {
        let by = |number| if number < 2 { [0.0; 2] } else { by };
        let place = |(number, (_, [r, z])): (u32, (_, [f64; 2]))| (number, [r + by(number)[0], z + by(number)[1]]);
        Nodes::new((0..).zip(RING).map(place)).unwrap()
    };
    let start = contact.start(places([0.0; 2])).unwrap();
    let pressed = contact.advance(&start, places(PRESSED), &Increment::new(0.5).unwrap()).unwrap();
    for (state, of_contact) in [start, pressed].iter().enumerate() {
        let get = |output| results.get("ring", output, state).unwrap();
        for (k, node) in of_contact.nodes().values().enumerate() {
            let found = [get("E11")[k], get("E12")[k], get("S11")[k], get("S12")[k]];
            // The reference for displacements is rounded differently: here the position, there the frame.
            for (found, expected) in found.into_iter().zip([node.e11, node.e12, node.s11, node.s12]) {
                assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{found} is not {expected}");
            }
        }
        assert_eq!(get("T")[0], contact.torque(of_contact).unwrap());
    }
}

#[test]
fn what_ran_is_counted_where_it_runs() {
    let plan_and_run = |text: &str| {
        let scene = scene(text);
        let planned = Plan::new(&scene).counts(scene.times().len());
        (planned, Results::of(&scene).unwrap().counts)
    };
    for text in [ring(1.0, RUBBING, ALL), ring(1.0, RUBBING, r#"["E12"]"#), ring(1.0, RUBBING, r#"["T"]"#)] {
        let (planned, ran) = plan_and_run(&text);
        assert_eq!(planned, ran, "one segment: every node is compared with it alone");
    }
    // Past the end of the line the pressure is 0, so that no law is evaluated.
    let (planned, ran) =
        plan_and_run(&ring(1.0, RUBBING, ALL).replace(r#""b": {"at": [5e0, 0e0]}"#, r#""b": {"at": [2.25, 0]}"#));
    let count = |counts: &[(&str, usize)], id| counts.iter().find(|(formula, _)| *formula == id).unwrap().1;
    let [law, slip] = ["interaction.pressure_exponential", "slide_line.slip_increment_linear"];
    assert_eq!((count(&planned, law), count(&planned, slip)), (6, 6));
    assert_eq!((count(&ran, law), count(&ran, slip)), (1, 6));
}

/// If a node has moved in the first state, its previous position needs an additional search.
#[test]
fn the_search_for_the_place_before_is_counted() {
    let moved = ring(1.0, RUBBING, r#"["E12"]"#).replace(r#"{"time": 0}, "#, "");
    let still = ring(1.0, RUBBING, r#"["E12"]"#);
    let searches = |text: &str| {
        let counts = Results::of(&scene(text)).unwrap().counts;
        counts.iter().find(|(formula, _)| *formula == "slide_line.closest_linear").unwrap().1
    };
    assert_eq!(
        (searches(&moved), searches(&still)),
        (6, 6),
        "three nodes: one state with two searches, or two with one"
    );
}

/// If a node moves away fast enough, damping makes the pressure negative; a negative pressure transmits no torque.
#[test]
fn a_node_that_damping_pulls_has_no_part_in_the_torque() {
    let text = r#"{"dimension": "axisymmetric",
        "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 0]}, "m": {"at": [2, -0.25]}, "n": {"at": [3, -0.25]}},
        "slide_lines": {"plate": {"type": "linear", "nodes": ["a", "b"], "pressure": {"k": 100},
            "damping": {"mu0": 50, "c0": 10, "eta": 0.5}}},
        "elements": {"ring": {"kind": "isl21a", "nodes": ["m", "n"], "slide_line": "plate"}},
        "frames": [{"time": 0}, {"time": 2, "nodes": {"m": {"u": [0, 0.2]}, "n": {"u": [0, -0.05]}}}],
        "outputs": ["S11", "T"]}"#;
    let results = Results::of(&scene(text)).unwrap();
    let &[pulled, pushed] = results.get("ring", "S11", 1).unwrap() else { panic!("two nodes") };
    // The law gives 5 and 30; the rates are those of two seconds.
    close(pulled, 5.0 - 50.0 * 0.2 / 2.0);
    close(pushed, 30.0 + 50.0 * 0.05 / 2.0);
    let quicker = Results::of(&scene(&text.replace("\"time\": 2", "\"time\": 1"))).unwrap();
    let &[pulled, pushed] = quicker.get("ring", "S11", 1).unwrap() else { panic!("two nodes") };
    close(pulled, -5.0);
    let places = Nodes::new([(3, [2.0, -0.05]), (4, [3.0, -0.3])]).unwrap();
    let element = IslElement::isl21a(1, [3, 4]).unwrap();
    let torque = |on_m: f64| element.torque(&places, |node| Ok(if node == 3 { on_m } else { pushed })).unwrap();
    let found = quicker.get("ring", "T", 1).unwrap()[0];
    assert!((found / torque(0.0) - 1.0).abs() < 1e-12, "{found}");
    assert!((torque(pulled) / torque(0.0) - 1.0).abs() > 1e-3);
}

#[test]
fn an_element_that_has_a_node_twice_is_refused() {
    let text = ring(1.0, RUBBING, ALL).replace(r#"["m", "n", "o"]"#, r#"["m", "n", "m"]"#);
    let faults = Scene::parse(&text).unwrap_err().to_string();
    let expected = ": node \"m\" for the second time; allowed is different nodes";
    assert!(faults.starts_with("elements.ring.nodes (line ") && faults.ends_with(expected), "{faults}");
}

#[test]
fn a_fault_of_an_element_is_not_also_one_of_its_nodes() {
    let text = ring(1.0, RUBBING, ALL)
        .replace(r#""slide_line": "plate"}"#, r#""slide_line": "plateau"}"#)
        .replace(r#""time": 0}"#, r#""time": 0, "pressures": {"m": 1}}"#);
    assert_eq!(Scene::parse(&text).unwrap_err().len(), 1);
}

#[test]
fn the_torque_of_a_line_is_that_of_the_elements_that_are_asked_for_it() {
    let text = THREAD.replace(
        r#""nodes": ["pin 1", "pin 2"], "slide_line": "box" }"#,
        r#""nodes": ["pin 1", "pin 2"], "slide_line": "box", "outputs": ["S11"] }"#,
    );
    let results = Results::of(&scene(&text)).unwrap();
    let torque = |name: &str, state| results.get(name, "T", state).map(|torque| torque[0]);
    let mut carries = false;
    for state in 0..results.times.len() {
        assert_eq!(torque("thread 1", state), None);
        let of_three: f64 = ["thread 2", "thread 3", "thread 4"].map(|name| torque(name, state).unwrap()).iter().sum();
        close(torque("box", state).unwrap(), of_three);
        carries |= of_three > 0.0;
    }
    assert!(carries);
}

/// The faults of a slide line over nodes named `n1` to `n7`.
fn wrong(line: &str) -> Vec<String> {
    let nodes = (1..=7).map(|k| format!(r#""n{k}": {{"at": [{k}, 0]}}"#)).collect::<Vec<_>>().join(", ");
    let text = format!(
        r#"{{"dimension": "axisymmetric", "nodes": {{{nodes}}}, "slide_lines": {{"l": {line}}}, "elements": {{}}}}"#
    );
    let faults = Scene::parse(&text).err();
    faults.map_or_else(Vec::new, |faults| faults.list().iter().map(ToString::to_string).collect())
}

#[test]
fn whole_numbers_are_of_their_range_and_generated_names_of_their_line() {
    let line = |rest: &str| wrong(&format!(r#"{{"type": "linear"{rest}}}"#));
    let generate = |rest: &str| line(&format!(r#", "generate": {{{rest}}}"#));
    let frequency = |number: &str| line(&format!(r#", "nodes": ["n1", "n2"], "torque_frequency": {number}"#));
    let to_7 = r#""first": "n1", "last": "n7""#;
    for sound in ["", r#", "increment": 1"#, r#", "increment": 2"#, r#", "increment": 3"#, r#", "increment": 6"#] {
        assert_eq!(generate(&format!("{to_7}{sound}")), [""; 0], "{sound}");
    }
    assert!(["0", "1", "4294967295"].iter().all(|number| frequency(number).is_empty()));
    for number in ["-1", "0.5", "4294967296"] {
        let found = frequency(number);
        assert!(found.len() == 1 && found[0].ends_with("a whole number from 0 to 4294967295"), "{found:?}");
    }
    for number in ["0", "1.5", "-2", "4294967296"] {
        let found = generate(&format!(r#"{to_7}, "increment": {number}"#));
        assert!(found.len() == 1 && found[0].ends_with("a whole number from 1 to 4294967295"), "{found:?}");
    }
    let multiple = |from: &str, step: &str| format!("\"n\" with a number that is {from} and a multiple of {step} more");
    for (rest, expected) in [
        (format!(r#"{to_7}, "increment": 4"#), multiple("1", "4")),
        (format!(r#"{to_7}, "increment": 8"#), multiple("1", "8")),
        (r#""first": "n7", "last": "n1""#.into(), multiple("7", "1")),
        (r#""first": "n1", "last": "m7""#.into(), multiple("1", "1")),
        (r#""first": "n1", "last": "n""#.into(), "names that end in a number".into()),
        (r#""first": "n1""#.into(), "first, last, and increment if it is not 1".into()),
    ] {
        let found = generate(&rest);
        assert!(found.len() == 1 && found[0].ends_with(&expected), "{rest}: {found:?}");
    }
    let found = generate(r#""first": "n5", "last": "n9""#);
    assert!(found.len() == 1 && found[0].contains("no node \"n8\""), "{found:?}");
    // The fault is the single node of the line, not its names.
    let found = generate(r#""first": "n2", "last": "n2""#);
    assert!(found.len() == 1 && !found[0].contains("multiple"), "{found:?}");
}

#[test]
fn one_mistake_in_a_slide_line_is_one_fault() {
    let line = |rest: &str| wrong(&format!(r#"{{"type": "linear", "nodes": ["n1", "n2"]{rest}}}"#));
    assert_eq!(line(""), [""; 0]);
    for (found, expected) in [
        (wrong("5"), "5; allowed is an object"),
        (wrong(r#"{"type": "linear", "generate": 5}"#), "5; allowed is an object"),
        (line(r#", "generate": {"first": "n1", "last": "n2"}"#), "a slide line with \"nodes\" and \"generate\""),
        (line(r#", "pressure": {"k": -1}"#), "-1; allowed is"),
        (line(r#", "pressure": {"k": 1, "c0": "x"}"#), "\"x\"; allowed is"),
        (line(r#", "pressure": {}"#), "0 parameters; allowed is k alone"),
        (line(r#", "friction": {"mu": 0.1, "k_stick": "x"}"#), "\"x\"; allowed is"),
        (line(r#", "friction": 5"#), "5; allowed is an object"),
        (line(r#", "damping": {"mu0": 1, "eta": 0.5}"#), "2 parameters; allowed is all of mu0, c0, eta"),
    ] {
        assert!(found.len() == 1 && found[0].contains(expected), "{expected}: {found:?}");
    }
    let turned = r#"{"dimension": "axisymmetric", "nodes": {"a": {"at": [1, 0]}}, "elements": {},
        "frames": [{"time": 0, "nodes": {"a": {"ur": 0.5}}}]}"#;
    let found = Scene::parse(turned).unwrap_err().to_string();
    assert!(found.ends_with("unknown key \"ur\"; allowed is one of u"), "{found}");
}

#[test]
fn a_plan_has_its_formulas_in_order_whichever_element_comes_first() {
    let wants = |text: String, element: &str, outputs: &str| {
        let (before, rest) = text.split_once(&format!("\"{element}\": {{")).unwrap();
        format!("{before}\"{element}\": {{ \"outputs\": {outputs}, {rest}")
    };
    let text = THREAD.replace(r#"["E11", "E12", "S11", "S12", "T"]"#, "[]");
    let text = wants(wants(text, "thread 1", r#"["T"]"#), "thread 3", r#"["AREA", "E12"]"#);
    let scene = scene(&text);
    let lines = Plan::new(&scene).lines();
    let formulas: Vec<_> = lines.iter().map(|line| (line.formula, line.elements, line.once)).collect();
    assert_eq!(
        formulas,
        [
            ("slide_line.closest_smoothed_linear", 4, false),
            ("slide_line.slip_increment_linear", 2, false),
            ("interaction.pressure_linear", 2, false),
            ("slide_line.contact_area_linear", 1, false),
            ("slide_line.torque_linear", 1, false),
        ]
    );
}

#[test]
fn results_of_the_first_elements_on_a_line_alone_are_kept() {
    let scene = scene(THREAD);
    let first = Results::collect::<f64>(&Plan::new(&scene), 2, || ()).unwrap();
    let mut elements: Vec<_> = first.series.iter().map(|series| &*series.element).collect();
    elements.dedup();
    assert_eq!(elements, ["thread 1", "thread 2", "box"]);
}
