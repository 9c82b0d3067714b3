//! The results of friction in scenes are consistent: in slip Φ is 0, and the kinetic force includes the friction.

use jointproof::scene::{Dimension, Kind, Results, Scene};
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};
use serde_json::Value;
use std::fmt::Write as _;

/// The output names of one free direction of a connector: friction, normal force, yield function, traction, slip.
struct Direction {
    kind: &'static str,
    dimension: &'static str,
    friction: &'static str,
    normal: &'static str,
    phi: &'static str,
    p: &'static str,
    slip: &'static str,
    /// Further outputs for the kinetic force or moment, with that itself first.
    kinetic: &'static [&'static str],
}

const fn slot(kind: &'static str, dimension: &'static str) -> Direction {
    Direction { kind, dimension, friction: "CSF1", normal: "FN", phi: "PHI", p: "P", slip: "SLIP1", kinetic: &["KF"] }
}

const DIRECTIONS: [Direction; 5] = [
    slot("slot", "3d"),
    slot("slot", "2d"),
    slot("translator", "3d"),
    Direction {
        friction: "CSM1",
        normal: "MN1",
        phi: "PHI1",
        p: "P1",
        slip: "SLIPR1",
        kinetic: &["KM", "CSM3", "GROT"],
        ..slot("ujoint", "3d")
    },
    Direction {
        friction: "CSM3",
        normal: "MN3",
        phi: "PHI3",
        p: "P3",
        slip: "SLIPR3",
        kinetic: &["KM", "CSM1", "GROT"],
        ..slot("ujoint", "3d")
    },
];

impl Direction {
    fn shown(&self) -> [&'static str; 5] {
        [self.friction, self.normal, self.phi, self.p, self.slip]
    }

    fn outputs(&self) -> Vec<&'static str> {
        [&self.shown(), self.kinetic].concat()
    }

    /// The magnitude of the kinetic force or moment if it includes friction.
    fn kinetic(&self, at: impl Fn(&str) -> f64, load: impl Fn(&str) -> f64) -> f64 {
        if self.kind != "ujoint" {
            return (load("f1") + at("CSF1")).abs();
        }
        // Along e1a and e3b, whose cosine is GROT if they are perpendicular at the start.
        let [m1, m3] = [load("m1") + at("CSM1"), load("m3") + at("CSM3")];
        (m1 * m1 + m3 * m3 + 2.0 * m1 * m3 * at("GROT")).sqrt()
    }
}

/// A load of an element, state by state.
fn loads(file: &Value, element: &str, name: &str) -> Vec<f64> {
    let mut now = 0.0;
    let frames = file["frames"].as_array().unwrap().iter();
    frames
        .map(|frame| {
            now = frame["loads"][element][name].as_f64().unwrap_or(now);
            now
        })
        .collect()
}

fn parsed(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}\n{text}"))
}

/// The number of states in slip, and in stick.
#[derive(Default)]
struct Seen {
    slipped: usize,
    stuck: usize,
}

impl Seen {
    /// Checks every state of an element against the documented friction.
    fn hold(&mut self, results: &Results, file: &Value, element: &str, direction: &Direction) {
        let mu = file["elements"][element]["mu"].as_f64().unwrap();
        let given = ["f1", "m1", "m3"].map(|name| (name, loads(file, element, name)));
        for state in 0..results.times.len() {
            let at = |output: &str| results.get(element, output, state).unwrap()[0];
            let load = |name: &str| given.iter().find(|(known, _)| *known == name).unwrap().1[state];
            let [force, normal, phi, p, slip] = direction.shown().map(at);
            let kinetic = results.get(element, direction.kinetic[0], state).unwrap();
            let kinetic = kinetic.iter().map(|x| x * x).sum::<f64>().sqrt();
            let expected = direction.kinetic(at, load);
            assert!(
                (kinetic - expected).abs() <= 1e-12 * (1.0 + expected + force.abs()),
                "{} of {element}, state {state}: {kinetic} is not load and friction, {expected}",
                direction.kinetic[0]
            );
            let limit = mu * normal;
            let place = format!("{} of {element}, state {state}: {force} of {limit}, Φ {phi}", direction.friction);
            assert_eq!(p, force.abs(), "{place}: P is the friction part alone");
            let rounding = 2.0 * f64::EPSILON * limit;
            assert_eq!(phi < -rounding, force.abs() < limit - rounding, "{place}: it sticks where Φ < 0");
            assert!(phi <= 0.0, "{place}: no state is beyond the limit");
            if slip == 0.0 {
                self.stuck += usize::from(phi < 0.0);
            } else {
                assert!(phi.abs() <= rounding, "{place}: it slips at Φ = 0");
                self.slipped += 1;
            }
        }
    }
}

#[test]
fn a_state_that_slips_shows_no_distance_to_the_limit_and_its_friction() {
    let rail: String = include_str!("../golden/scenes/rail.json").into();
    let outputs = rail.find("\"outputs\"").unwrap();
    let scene = parsed(&format!(r#"{} "outputs": ["CSF1", "SLIP1", "P", "PHI", "KF"] }}"#, &rail[..outputs]));
    let results = Results::of(&scene).unwrap();
    let at = |output, state| results.get("guide", output, state).unwrap().to_vec();
    assert_eq!((at("PHI", 1), at("P", 1), at("KF", 1)), (vec![0.0], vec![1.25], vec![1.25, 0.0, 0.0]));
    assert!(at("SLIP1", 1)[0] > 2.49 && at("PHI", 0)[0] < 0.0);
}

#[test]
fn a_load_and_friction_make_the_kinetic_force_together() {
    let element = |kind: &str, given: &str| {
        parsed(&format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
            "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0], "orientation": "o"}}}},
            "elements": {{"e": {{"kind": "{kind}", "nodes": ["a", "b"], "k_stick": 1000, {given}}}}},
            "frames": [{{"time": 0, "nodes": {{"b": {{"u": [1, 0, 0], "ur": [0.5, 0, 0]}}}},
                "loads": {{"e": {{"f1": 7, "f2": 3, "f3": 4 {}}}}}}}]}}"#,
            if kind == "slot" { "" } else { r#", "m1": 2, "m3": 5"# }
        ))
    };
    let get = |scene: &Scene, output| Results::of(scene).unwrap().get("e", output, 0).unwrap().to_vec();
    let rubs = element("slot", r#""mu": 0.5, "outputs": ["KF", "P", "PHI"]"#);
    assert_eq!(get(&rubs, "KF"), [7.0 + 2.5, 0.0, 0.0]);
    assert_eq!((get(&rubs, "P"), get(&rubs, "PHI")), (vec![2.5], vec![0.0]));
    let smooth = element("slot", r#""outputs": ["KF", "P", "PHI"]"#);
    assert_eq!(
        (get(&smooth, "KF"), get(&smooth, "P"), get(&smooth, "PHI")),
        (vec![7.0, 0.0, 0.0], vec![0.0], vec![0.0])
    );

    let shown = r#""outputs": ["KM", "P1", "PHI1", "MN1", "RF"]"#;
    let joint = element("ujoint", &format!(r#""mu": 0.5, "rp": 1, "la": 2, "mc1_int": 4, {shown}"#));
    let limit = 0.5 * get(&joint, "MN1")[0];
    assert_eq!((get(&joint, "P1"), get(&joint, "PHI1")), (vec![limit], vec![0.0]));
    // The cross is rotated by 0.5 about e1a, so that the third axis of b is tilted.
    let moment = [2.0 + limit, -5.0 * 0.5_f64.sin(), 5.0 * 0.5_f64.cos()];
    for (found, expected) in get(&joint, "KM").into_iter().zip(moment) {
        assert!((found - expected).abs() < 1e-14, "{found} is not {expected}");
    }
    assert_eq!(get(&joint, "RF"), [7.0, 3.0, 4.0]);
}

/// Numbers from -1 to 1, the same in every run.
struct Numbers(TestRng);

impl Numbers {
    fn next(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn vector(&mut self, dimension: &str, by: f64) -> String {
        let count = if dimension == "3d" { 3 } else { 2 };
        let numbers: Vec<_> = (0..count).map(|_| format!("{:?}", by * self.next())).collect();
        format!("[{}]", numbers.join(", "))
    }

    /// A history of forty states, some without motion, of a connector with random dimensions.
    fn scene(&mut self, direction: &Direction, mu: f64) -> String {
        let Direction { kind, dimension, .. } = *direction;
        let space = dimension == "3d";
        let mut parameters = format!(r#""mu": {mu:?}, "k_stick": {:?}"#, 1.0 + 10.0 * self.next().abs());
        let measures: &[&str] = match kind {
            "slot" => &["fc_int"],
            "translator" => &["fc_int", "rr", "l"],
            _ => &["rp", "la", "ra", "ls", "mc1_int", "mc3_int"],
        };
        for name in measures {
            write!(parameters, r#", "{name}": {:?}"#, 0.1 + self.next().abs()).unwrap();
        }
        let loads: Vec<_> =
            Kind::find(kind, if space { Dimension::Space } else { Dimension::Plane }).unwrap().loads().collect();
        let mut frames = Vec::new();
        for time in 0..40 {
            let u = self.vector(dimension, 1.0);
            let turn = if space { format!(r#", "ur": {}"#, self.vector(dimension, 0.5)) } else { String::new() };
            let given: Vec<_> = loads.iter().map(|name| format!(r#""{name}": {:?}"#, self.next())).collect();
            let moved =
                if self.next() > 0.5 { String::new() } else { format!(r#", "nodes": {{"b": {{"u": {u}{turn}}}}}"#) };
            frames.push(format!(r#"{{"time": {time}{moved}, "loads": {{"e": {{{}}}}}}}"#, given.join(", ")));
        }
        let (origin, turn) =
            if space { ("[0, 0, 0]", "\"rotation\": [0.3, -0.2, 0.1]") } else { ("[0, 0]", "\"angle\": 0.3") };
        format!(
            r#"{{"dimension": "{dimension}", "orientations": {{"o": {{{turn}}}}}, "nodes": {{"a": {{"at": {origin}, "orientation": "o"}},
            "b": {{"at": {origin}, "orientation": "o"}}}}, "elements": {{"e": {{"kind": "{kind}", "nodes": ["a", "b"], {parameters}}}}},
            "frames": [{}], "outputs": {:?}}}"#,
            frames.join(",\n"),
            direction.outputs()
        )
    }
}

#[test]
fn random_histories_agree_with_themselves() {
    let mut numbers = Numbers(TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]));
    for direction in &DIRECTIONS {
        let mut seen = Seen::default();
        for _ in 0..40 {
            let mu = 0.1 + numbers.next().abs();
            let text = numbers.scene(direction, mu);
            let (scene, file) = (parsed(&text), serde_json::from_str(&text).unwrap());
            seen.hold(&Results::of(&scene).unwrap(), &file, "e", direction);
            seen.hold(&Results::exact(&scene).unwrap(), &file, "e", direction);
        }
        let Seen { slipped, stuck } = seen;
        assert!(
            slipped > 200 && stuck > 200,
            "{} {}: {slipped} slipped, {stuck} stuck",
            direction.kind,
            direction.friction
        );
    }
}

/// The scenes of `golden/scenes`.
fn golden() -> Vec<Value> {
    let folder = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/scenes")).unwrap();
    let read = |path| serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let files = folder.map(|entry| read(entry.unwrap().path()));
    files.filter(|file: &Value| file.get("elements").is_some()).collect()
}

#[test]
fn golden_scenes_agree_with_themselves() {
    let mut seen = Seen::default();
    for file in golden() {
        for (name, element) in file["elements"].as_object().unwrap() {
            let given = element["mu"].is_number();
            let of_kind = |d: &&Direction| given && element["kind"] == d.kind && file["dimension"] == d.dimension;
            for direction in DIRECTIONS.iter().filter(of_kind) {
                let mut asked = file.clone();
                asked["outputs"] = [""; 0].to_vec().into();
                asked["elements"][name]["outputs"] = direction.outputs().into();
                let results = Results::of(&parsed(&asked.to_string())).unwrap();
                seen.hold(&results, &file, name, direction);
            }
        }
    }
    assert!(seen.slipped > 20 && seen.stuck > 10, "{} slipped, {} stuck", seen.slipped, seen.stuck);
}

impl Seen {
    /// Checks every node of an element on a slide line in the same way: below μ p it sticks, and its shear stress follows the
    /// motion with the stick stiffness; in slip it transmits μ p.
    fn hold_contact(&mut self, results: &Results, file: &Value, element: &str) {
        let line = file["elements"][element]["slide_line"].as_str().unwrap();
        let [mu, k_stick] = ["mu", "k_stick"].map(|name| file["slide_lines"][line]["friction"][name].as_f64().unwrap());
        let at = |output, state| results.get(element, output, state).unwrap();
        for node in 0..at("S12", 0).len() {
            let (mut before, mut way) = (0.0, 0.0);
            for state in 0..results.times.len() {
                let [s11, s12, e12] = ["S11", "S12", "E12"].map(|output| at(output, state)[node]);
                let (limit, trial) = (mu * s11, before + k_stick * (e12 - way));
                let rounding = 1e-13 * (1.0 + limit + trial.abs() + k_stick * e12.abs());
                let place = format!("node {node} of {element}, state {state}: {s12} of {limit}, trial {trial}");
                assert!(s11 >= 0.0 && s12.abs() <= limit + rounding, "{place}: no state is beyond the limit");
                if s12.abs() < limit - rounding {
                    assert!((s12 - trial).abs() <= rounding, "{place}: it sticks below the limit");
                    self.stuck += usize::from(trial != 0.0);
                } else if trial.abs() > limit + rounding {
                    assert!((s12 - limit.copysign(trial)).abs() <= rounding, "{place}: it slips at the limit");
                    self.slipped += usize::from(limit > 0.0);
                }
                (before, way) = (s12, e12);
            }
        }
    }
}

/// A ring above a bent line, pressed against it and dragged along it, in forty states.
fn ring(numbers: &mut Numbers) -> String {
    let mut number = |from: f64, to: f64| from + (to - from) * (0.5 + 0.5 * numbers.next());
    let (kind, line, nodes) = if number(0.0, 1.0) > 0.5 {
        ("isl21a", "linear", vec!["a", "b"])
    } else {
        ("isl22a", "parabolic", vec!["a", "b", "c"])
    };
    let [mu, k_stick, k] = [number(0.1, 1.0), number(5.0, 50.0), number(1.0, 20.0)];
    let frames: Vec<_> = (0..40)
        .map(|time| {
            let mut moved = |node| format!(r#""{node}": {{"u": [{:?}, {:?}]}}"#, number(-0.4, 0.4), number(-0.4, 0.1));
            let nodes: Vec<_> = nodes.iter().map(&mut moved).collect();
            format!(r#"{{"time": {time}, "nodes": {{{}}}}}"#, nodes.join(", "))
        })
        .collect();
    format!(
        r#"{{"dimension": "axisymmetric", "nodes": {{"1": {{"at": [1, 0]}}, "2": {{"at": [2, 0.125]}}, "3": {{"at": [3, 0]}},
        "a": {{"at": [1.5, 0.125]}}, "b": {{"at": [2, 0.25]}}, "c": {{"at": [2.5, 0.125]}}}},
        "slide_lines": {{"l": {{"type": "{line}", "nodes": ["1", "2", "3"], "pressure": {{"k": {k:?}}},
            "friction": {{"mu": {mu:?}, "k_stick": {k_stick:?}}}}}}},
        "elements": {{"e": {{"kind": "{kind}", "nodes": {nodes:?}, "slide_line": "l"}}}},
        "frames": [{}], "outputs": ["E12", "S11", "S12"]}}"#,
        frames.join(",\n")
    )
}

#[test]
fn random_histories_on_slide_lines_agree_with_themselves() {
    let mut numbers = Numbers(TestRng::from_seed(RngAlgorithm::ChaCha, &[8; 32]));
    let mut seen = Seen::default();
    for _ in 0..60 {
        let text = ring(&mut numbers);
        let (scene, file) = (parsed(&text), serde_json::from_str(&text).unwrap());
        seen.hold_contact(&Results::of(&scene).unwrap(), &file, "e");
        seen.hold_contact(&Results::exact(&scene).unwrap(), &file, "e");
    }
    assert!(seen.slipped > 200 && seen.stuck > 200, "{} slipped, {} stuck", seen.slipped, seen.stuck);
}

#[test]
fn golden_slide_lines_agree_with_themselves() {
    let mut seen = Seen::default();
    for mut file in golden() {
        let elements = file["elements"].as_object().unwrap();
        let slide = elements.iter().filter(|(_, element)| element.get("slide_line").is_some());
        let names: Vec<_> = slide.map(|(name, _)| name.clone()).collect();
        file["outputs"] = [""; 0].to_vec().into();
        for name in &names {
            file["elements"][name]["outputs"] = ["E12", "S11", "S12"].to_vec().into();
        }
        if !names.is_empty() {
            let results = Results::of(&parsed(&file.to_string())).unwrap();
            for name in &names {
                seen.hold_contact(&results, &file, name);
            }
        }
    }
    assert!(seen.slipped > 20 && seen.stuck > 5, "{} slipped, {} stuck", seen.slipped, seen.stuck);
}
