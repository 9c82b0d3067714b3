//! What scenes say about friction agrees with itself: where a contact slips Φ is 0 and the kinetic force holds the friction.

use jointproof::scene::{Dimension, Kind, Results, Scene};
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};
use std::fmt::Write as _;

/// Names of what one free direction of a connector shows: friction, normal force, yield function, traction, slip.
struct Direction {
    kind: &'static str,
    dimension: &'static str,
    friction: &'static str,
    normal: &'static str,
    phi: &'static str,
    p: &'static str,
    slip: &'static str,
}

const fn slot(kind: &'static str, dimension: &'static str) -> Direction {
    Direction { kind, dimension, friction: "CSF1", normal: "FN", phi: "PHI", p: "P", slip: "SLIP1" }
}

const DIRECTIONS: [Direction; 5] = [
    slot("slot", "3d"),
    slot("slot", "2d"),
    slot("translator", "3d"),
    Direction { friction: "CSM1", normal: "MN1", phi: "PHI1", p: "P1", slip: "SLIPR1", ..slot("ujoint", "3d") },
    Direction { friction: "CSM3", normal: "MN3", phi: "PHI3", p: "P3", slip: "SLIPR3", ..slot("ujoint", "3d") },
];

impl Direction {
    fn outputs(&self) -> [&'static str; 5] {
        [self.friction, self.normal, self.phi, self.p, self.slip]
    }
}

fn parsed(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}\n{text}"))
}

/// How many states slipped, and how many stuck.
#[derive(Default)]
struct Seen {
    slipped: usize,
    stuck: usize,
}

impl Seen {
    /// Holds every state of an element to what the documents say of friction.
    fn hold(&mut self, results: &Results, element: &str, mu: f64, direction: &Direction) {
        for state in 0..results.times.len() {
            let at = |output| results.get(element, output, state).unwrap()[0];
            let [force, normal, phi, p, slip] = direction.outputs().map(at);
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
    // The cross is turned by 0.5 about e1a, so that the third axis of b leans.
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

    /// A history of forty states, of which some are still, of a connector of random measures.
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
            let scene = parsed(&numbers.scene(direction, mu));
            seen.hold(&Results::of(&scene).unwrap(), "e", mu, direction);
            seen.hold(&Results::exact(&scene).unwrap(), "e", mu, direction);
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

#[test]
fn golden_scenes_agree_with_themselves() {
    let mut seen = Seen::default();
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/scenes")).unwrap() {
        let path = entry.unwrap().path();
        let file: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        let Some(elements) = file.get("elements").and_then(|elements| elements.as_object().cloned()) else { continue };
        for (name, element) in elements {
            for direction in DIRECTIONS.iter().filter(|d| element["kind"] == d.kind && file["dimension"] == d.dimension)
            {
                let Some(mu) = element["mu"].as_f64() else { continue };
                let mut asked = file.clone();
                asked["outputs"] = [""; 0].to_vec().into();
                asked["elements"][&name]["outputs"] = direction.outputs().to_vec().into();
                let results = Results::of(&parsed(&asked.to_string())).unwrap();
                seen.hold(&results, &name, mu, direction);
            }
        }
    }
    assert!(seen.slipped > 10 && seen.stuck > 2, "{} slipped, {} stuck", seen.slipped, seen.stuck);
}
