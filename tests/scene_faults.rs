//! Mistakes in scene files: each is reported with its location, several at once, and none causes a panic or a hang.

use jointproof::scene::{Kind, Plan, Results, Scene};
use proptest::prelude::*;

const SCENES: [&str; 4] = [
    include_str!("../golden/scenes/telescope.json"),
    include_str!("../golden/scenes/drive-shaft.json"),
    include_str!("../golden/scenes/interface.json"),
    include_str!("../golden/scenes/thread.json"),
];

fn faults(text: &str) -> Vec<String> {
    let faults = Scene::parse(text).expect_err("this scene is wrong");
    faults.list().iter().map(ToString::to_string).collect()
}

#[test]
fn eight_names_are_listed_and_what_is_more_is_said() {
    let allowed = |nodes: usize| {
        let named: Vec<_> = (1..=nodes).map(|k| format!(r#""n{k}": {{ "at": [0, 0, 0] }}"#)).collect();
        let elements = r#"{ "s": { "kind": "slot", "nodes": ["n1", "q"] } }"#;
        let scene = format!(r#"{{ "dimension": "3d", "nodes": {{ {} }}, "elements": {elements} }}"#, named.join(", "));
        let about_q = faults(&scene).into_iter().find(|fault| fault.contains("no node \"q\"")).unwrap();
        about_q.split_once("one of ").unwrap().1.to_owned()
    };
    let eight = r#""n1", "n2", "n3", "n4", "n5", "n6", "n7", "n8""#;
    assert_eq!([allowed(8), allowed(9)], [eight.to_owned(), format!("{eight}, …")]);
}

#[test]
fn every_mistake_is_reported_with_its_place() {
    let text = r#"{
  "dimension": "3d",
  "colour": "red",
  "nodes": {
    "a": { "at": [0, 0] },
    "b": { "at": [0, "NaN", 0], "orientation": "none" },
    "b": { "at": [1, 2, 3] }
  },
  "elements": {
    "s 1": { "kind": "slot", "nodes": ["a", "c"], "mu": -0.5, "l1_min": 2, "l1_max": 1, "outputs": ["GAPMIN", "CSF1"] },
    "s 2": { "kind": "slott", "nodes": ["a", "b"] },
    "s 3": { "nodes": ["a"] },
    "s 4": { "kind": "translator", "nodes": ["a"], "mu": 1e400 }
  },
  "frames": [
    { "time": 0, "loads": { "s 1": { "f9": 1, "f1": null } } },
    { "time": -1, "nodes": { "q": { "u": [0, 0, 0] } } },
    {}
  ],
  "outputs": ["U1", "U1", "U9", "UR1", "ALPHA"]
}"#;
    let found = faults(text);
    let expected = [
        "colour (line 3, column 3): unknown key \"colour\"; allowed is one of title, dimension, angles, columns, orientations, nodes, slide_lines, elements, frames, outputs",
        "nodes.a.at (line 5, column 18): an array of 2; allowed is an array of 3 numbers",
        "nodes.b.at[1] (line 6, column 22): \"NaN\"; allowed is a finite number",
        "nodes.b.orientation (line 6, column 48): no orientation \"none\"; allowed is no orientation, there are none",
        "nodes.b (line 7, column 5): \"b\" for the second time; allowed is each name once",
        "outputs[1] (line 20, column 21): \"U1\" for the second time; allowed is each output once",
        "outputs[2] (line 20, column 27): no output \"U9\"; allowed is one of ",
        "elements.\"s 1\".nodes[1] (line 10, column 45): no node \"c\"; allowed is one of \"a\", \"b\"",
        "elements.\"s 1\".mu (line 10, column 57): -0.5; allowed is a finite number ≥ 0",
        "elements.\"s 1\" (line 10, column 12): no \"k_stick\", needed for coulomb.response; allowed is a number, the stiffness in stick",
        "elements.\"s 1\" (line 10, column 12): l1_min = 2.0 is above l1_max = 1.0; allowed is l1_min ≤ l1_max",
        "elements.\"s 2\".kind (line 11, column 22): no kind \"slott\"; allowed is one of slot, translator, align, ujoint, ",
        "elements.\"s 3\" (line 12, column 12): an element without \"kind\"; allowed is one of slot, translator, align, ujoint, ",
        "elements.\"s 4\".nodes (line 13, column 45): an array of 1; allowed is an array of 2 nodes: a, b",
        "elements.\"s 4\".mu (line 13, column 58): 1e400, which no double can hold; allowed is a finite number ≥ 0",
        "frames[0].loads.\"s 1\".f9 (line 16, column 38): unknown key \"f9\"; allowed is one of f1, f2, f3",
        "frames[0].loads.\"s 1\".f1 (line 16, column 53): null; allowed is a finite number",
        "frames[1].time (line 17, column 15): -1.0; allowed is a time of at least the last frame's, 0.0",
        "frames[1].nodes.q (line 17, column 30): no node \"q\"; allowed is one of \"a\", \"b\"",
        "frames[2] (line 18, column 5): a frame without \"time\"; allowed is a frame with its time",
    ];
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.starts_with(expected), "found    {found}\nexpected {expected}");
    }
    assert_eq!(found.len(), expected.len(), "{found:#?}");
}

#[test]
fn a_frame_says_everything_once() {
    let found = faults(
        r#"{"dimension": "2d", "orientations": {"o": {"angle": 0}}, "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": [1, 0]}},
  "elements": {"s": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["FC"],
  "frames": [{"time": 0, "loads": {"s": {"f2": 1}}, "nodes": {"a": {"u": [0, 0]}}},
    {"time": 1, "loads": {"s": {"f2": 1}, "s": {"f2": 2}}, "nodes": {"a": {"u": [0, 0]}, "a": {"ur": 0}}}]}"#,
    );
    let expected = [
        "frames[1].loads.s (line 4, column 43): \"s\" for the second time; allowed is each name once",
        "frames[1].nodes.a (line 4, column 90): \"a\" for the second time; allowed is each name once",
    ];
    assert_eq!(found, expected);
}

#[test]
fn text_that_is_not_json_ends_the_reading_where_it_is() {
    for (text, expected) in [
        ("", "line 1, column 1"),
        ("{", "found"),
        (r#"{"dimension": "3d",}"#, "'}'; allowed is a name in double quotes"),
        (r#"{"dimension": 01}"#, "a number without leading zeros"),
        (r#"{"dimension": -}"#, "a digit after the minus sign"),
        (r#"{"dimension": 1.}"#, "a digit after the point"),
        (r#"{"dimension": 1e}"#, "a digit in the exponent"),
        (r#"{"dimension": "3d" "nodes"}"#, "a comma or"),
        (r#"{"dimension": "3d}"#, "a closing quote"),
        (r#"{"dimension": "\q"}"#, "a string with JSON's escapes"),
        (r#"{"dimension": "3d", "nodes": {}, "elements": {}} x"#, "nothing after the scene"),
        (r#"{"dimension": NaN}"#, "a JSON value"),
        (r#"{"a": [1 2]}"#, "a comma or the closing bracket"),
        ("[]", "an array; allowed is an object"),
        ("7", "7; allowed is an object"),
    ] {
        let found = faults(text).join("\n");
        assert!(expected == "found" || found.contains(expected), "{text}: {found}");
    }
}

#[test]
fn ten_megabytes_of_brackets_are_an_error() {
    // An algorithm of quadratic time would not finish.
    for bracket in ["[", "{\"a\":", "[{\"a\":", "[[],", "\"", "9", "["] {
        let text = bracket.repeat(10_000_000 / bracket.len());
        for text in [text.clone(), format!("{{\"dimension\": \"3d\", \"nodes\": {text}")] {
            assert!(!faults(&text).is_empty());
        }
    }
}

#[test]
fn a_hundred_faults_are_listed_and_the_rest_is_counted() {
    let nodes: Vec<_> = (0..100_000).map(|i| format!("\"n{i}\": 0")).collect();
    let text = format!(r#"{{"dimension": "3d", "nodes": {{{}}}, "elements": {{}}}}"#, nodes.join(","));
    let faults = Scene::parse(&text).unwrap_err();
    assert_eq!((faults.list().len(), faults.len()), (100, 100_000));
    assert!(faults.to_string().ends_with("… and 99900 more"));
}

/// Coordinates of a node, and an orientation, in the dimension of a kind.
fn place_and_turn(kind: &Kind) -> (&'static str, &'static str) {
    if kind.dimension.coordinates() == 3 {
        ("[1, 2, 3]", r#""rotation": [0, 0, 0]"#)
    } else {
        ("[1, 2]", r#""angle": 0"#)
    }
}

/// Friction given as 0 needs no more parameters than friction that is not given.
#[test]
fn a_coefficient_of_zero_needs_no_stiffness() {
    let read = |mu: &str| {
        Scene::parse(&format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
            "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [1, 0, 0]}}}},
            "elements": {{"e": {{"kind": "slot", "nodes": ["a", "b"]{mu}}}}}, "outputs": ["PHI"]}}"#
        ))
    };
    assert!(read("").is_ok() && read(r#", "mu": 0"#).is_ok() && read(r#", "mu": 0.5, "k_stick": 1"#).is_ok());
    assert!(read(r#", "mu": 0.5"#).unwrap_err().to_string().contains("no \"k_stick\", needed for coulomb.response"));
}

/// The kinds define which parameters must be in order, and so does the formula that reads them.
#[test]
fn stops_in_the_wrong_order_are_refused() {
    let mut pairs = 0;
    for kind in Kind::all() {
        let (at, turn) = place_and_turn(kind);
        for (lower, upper) in kind.ordered {
            let with = |low: f64, high: f64| {
                Scene::parse(&format!(
                    r#"{{"dimension": "{}", "orientations": {{"o": {{{turn}}}}},
                    "nodes": {{"a": {{"at": {at}, "orientation": "o"}}, "b": {{"at": {at}}}}}, "elements":
                    {{"e": {{"kind": "{}", "nodes": ["a", "b"], "{lower}": {low}, "{upper}": {high}}}}}}}"#,
                    kind.dimension.name(),
                    kind.name
                ))
            };
            assert!(with(1.0, 1.0).is_ok());
            let faults = with(1.0, 0.5).unwrap_err();
            let fault = &faults.list()[0];
            assert_eq!(fault.found, format!("{lower} = 1.0 is above {upper} = 0.5"));
            assert_eq!((fault.allowed.as_str(), faults.len()), (format!("{lower} ≤ {upper}").as_str(), 1));
            pairs += 1;
        }
    }
    assert!(pairs > 4, "{pairs}");
}

#[test]
fn what_refers_to_a_faulty_element_or_node_is_not_another_fault() {
    let found = faults(
        r#"{"dimension": "3d", "nodes": {"a": {"at": [0, 0]}, "b": {"at": [1, 0, 0]}},
  "elements": {"s": {"kind": "slott", "nodes": ["a", "b"]}, "t": {"kind": "slot", "nodes": ["a", "b"], "mu": true}},
  "frames": [{"time": 0, "loads": {"s": {"f2": 1}, "t": {"f2": 1}}, "nodes": {"a": {"u": [0, 0, 0]}}}]}"#,
    );
    let places = ["nodes.a.at (", "elements.s.kind (", "elements.t.mu ("];
    assert!(found.iter().zip(places).all(|(found, place)| found.starts_with(place)), "{found:#?}");
    assert_eq!(found.len(), places.len(), "{found:#?}");
}

#[test]
fn an_output_that_no_element_has_is_a_fault() {
    let found = faults(
        r#"{"dimension": "3d", "orientations": {"o": {"rotation": [0, 0, 0]}}, "nodes": {"a": {"at": [0, 0, 0], "orientation": "o"}, "b": {"at": [1, 0, 0]}},
        "elements": {"s": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["U1", "ALPHA"]}"#,
    );
    let expected = "elements (line 2, column 85): output \"ALPHA\", which no element here has; \
        allowed is an output of one of the elements";
    assert_eq!(found, [expected]);
}

#[test]
fn an_element_of_an_unknown_kind_is_one_fault() {
    let connector = r#"{"dimension": "3d", "nodes": {"a": {"at": [0, 0, 0]}, "b": {"at": [1, 0, 0]}},
        "elements": {"s": {"kind": "slott", "nodes": ["a", "b"]}}, "outputs": ["U1"],
        "frames": [{"time": 0, "loads": {"s": {"f2": 1}}}]}"#;
    let sliding = r#"{"dimension": "axisymmetric", "nodes": {"a": {"at": [1, 0]}, "b": {"at": [5, 0]}},
        "slide_lines": {"l": {"type": "linear", "nodes": ["a", "b"]}},
        "elements": {"s": {"kind": "isl21", "nodes": ["a", "b"], "slide_line": "l"}}, "outputs": ["E11"],
        "frames": [{"time": 0, "pressures": {"a": 1}}]}"#;
    for text in [connector, sliding] {
        let found = faults(text);
        assert!(found.len() == 1 && found[0].starts_with("elements.s.kind ("), "{found:#?}");
    }
}

/// References to a missing part are not further faults.
#[test]
fn a_part_that_is_missing_or_no_object_is_one_fault() {
    let thread = include_str!("../golden/scenes/thread.json");
    for (key, part) in [("nodes", 0), ("elements", 0), ("nodes", 1), ("slide_lines", 1), ("elements", 1)] {
        let mut scene: serde_json::Value = serde_json::from_str(thread).unwrap();
        let parts = scene.as_object_mut().unwrap();
        let whole = parts.remove(key).unwrap();
        let (name, value) = if part == 0 { (format!("{key}s"), whole) } else { (key.into(), serde_json::json!([])) };
        parts.insert(name, value);
        let found = faults(&scene.to_string());
        // A misspelt key is unknown, and the correct one is missing.
        assert_eq!(found.len(), 2 - part, "{key}: {found:#?}");
        assert!(found.iter().all(|fault| fault.contains(key)), "{found:#?}");
    }
}

#[test]
fn an_element_between_a_node_and_itself_is_refused() {
    for kind in Kind::all() {
        let (at, turn) = place_and_turn(kind);
        let ends = vec!["\"car\""; kind.nodes.len()].join(", ");
        let lines = if kind.slides() {
            (r#""slide_lines": {"l": {"type": "linear", "nodes": ["p", "q"]}}, "#, r#", "slide_line": "l""#)
        } else {
            ("", "")
        };
        let found = faults(&format!(
            r#"{{"dimension": "{}", "orientations": {{"o": {{{turn}}}}}, "nodes": {{"car": {{"at": {at}, "orientation": "o"}}, "p": {{"at": {at}}}, "q": {{"at": {at}}}}}, {}
            "elements": {{"e": {{"kind": "{}", "nodes": [{ends}]{}}}}}}}"#,
            kind.dimension.name(),
            lines.0,
            kind.name,
            lines.1
        ));
        let twice = "node \"car\" for the second time; allowed is different nodes";
        assert_eq!(found.len(), kind.nodes.len() - 1, "{kind:?}: {found:#?}");
        assert!(
            found.iter().all(|fault| fault.starts_with("elements.e.nodes (") && fault.ends_with(twice)),
            "{found:#?}"
        );
    }
}

/// Every output of every kind can be planned and evaluated, alone and together with all others.
#[test]
fn every_output_of_every_kind_evaluates() {
    for kind in Kind::all() {
        let places = if kind.dimension.coordinates() == 3 {
            ["[0, 0, 0]", "[1, 0.5, 0.25]", "[0.5, 0.25, 0.125]"]
        } else {
            ["[0, 0]", "[1, 0.5]", "[0.5, 0.25]"]
        };
        let (_, turn) = place_and_turn(kind);
        let node = |(i, at)| format!(r#""n{i}": {{"at": {at}, "orientation": "o"}}"#);
        let nodes: Vec<_> = places.iter().enumerate().map(node).collect();
        let ends: Vec<_> = (0..kind.nodes.len()).map(|i| format!("\"n{i}\"")).collect();
        let parameters = kind.parameters().map(|(name, _)| format!(r#", "{name}": 1"#)).collect::<Vec<_>>().concat();
        let (lines, on_line) = if kind.slides() {
            (
                r#""slide_lines": {"l": {"type": "linear", "nodes": ["n0", "n2"], "friction": {"mu": 0.1, "k_stick": 1}}},"#,
                r#", "slide_line": "l""#,
            )
        } else {
            ("", "")
        };
        let all: Vec<_> = kind.outputs().map(|(name, _)| format!("{name:?}")).collect();
        for outputs in all.iter().cloned().chain([all.join(", ")]) {
            let text = format!(
                r#"{{"dimension": "{}", "orientations": {{"o": {{{turn}}}}}, "nodes": {{{}}}, "outputs": [{outputs}], {lines}
                "elements": {{"e": {{"kind": "{}", "nodes": [{}]{parameters}{on_line}}}}}}}"#,
                kind.dimension.name(),
                nodes.join(", "),
                kind.name,
                ends.join(", ")
            );
            let scene = Scene::parse(&text).unwrap_or_else(|faults| panic!("{kind:?} {outputs}: {faults}"));
            let results = Results::of(&scene).unwrap_or_else(|problems| panic!("{kind:?} {outputs}: {problems}"));
            let torque = usize::from(kind.slides() && outputs.contains("\"T\""));
            assert_eq!(results.series.len(), outputs.split(", ").count() + torque, "{kind:?} {outputs}");
            assert!(!Plan::new(&scene).lines().is_empty());
        }
    }
}

/// Replaces, drops, doubles or retypes a piece of a scene's text.
fn mutated() -> impl Strategy<Value = String> {
    let junk = prop::sample::select(vec![
        "",
        "null",
        "true",
        "\"NaN\"",
        "1e400",
        "-1e400",
        "-0",
        "[]",
        "{}",
        "[[[[[[",
        "}",
        "]",
        ",",
        ":",
        "\"",
        "\\",
        "\\u0000",
        "\"a\"",
        "1e-400",
        "99999999999999999999",
        "\u{1F529}",
        "\u{0}",
        "\"kind\"",
        "\"slot\"",
        "[0,0,0]",
        "\n",
    ]);
    let mutation = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), junk, 0..4_u8);
    (0..SCENES.len(), prop::collection::vec(mutation, 1..4)).prop_map(|(scene, mutations)| {
        let mut text = SCENES[scene].to_owned();
        for (from, to, junk, how) in mutations {
            // Cut at characters that end tokens, so that many mutants are still JSON.
            let cuts: Vec<_> = text.match_indices([',', ':', '{', '}', '[', ']', '"']).map(|(at, _)| at).collect();
            if cuts.len() < 2 {
                break;
            }
            let start = from.index(cuts.len() - 1);
            let near = (start + 1 + to.index(6)).min(cuts.len() - 1);
            let (start, end) = (cuts[start], cuts[near]);
            let piece = text[start..end].to_owned();
            match how {
                0 => text.replace_range(start..end, junk),
                1 => text.insert_str(end, &piece),
                2 => text.replace_range(start..end, ""),
                _ => text.insert_str(start, junk),
            }
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    /// The outcome is an error or a result; every fault has a location in the text.
    #[test]
    fn a_mutant_is_an_error_or_a_result(text in mutated()) {
        match Scene::parse(&text) {
            Ok(scene) => drop(Results::of(&scene)),
            Err(faults) => {
                prop_assert!(!faults.list().is_empty());
                for fault in faults.list() {
                    prop_assert!(fault.line >= 1 && fault.line <= text.lines().count().max(1) + 1);
                    prop_assert!(fault.column >= 1 && !fault.found.is_empty() && !fault.allowed.is_empty());
                }
            }
        }
    }

    /// Everything that the reader accepts is JSON.
    #[test]
    fn no_scene_that_is_not_json(text in mutated()) {
        if Scene::parse(&text).is_ok() {
            prop_assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
        }
    }
}

const TRIADS: &str = r#"{"dimension": "3d", "orientations": {"along": {"rotation": [0, 0, 0]}, "askew": {"rotation": [0, 0, 0.5]}},
    "nodes": {"a": {"at": [0, 0, 0], "orientation": "askew"}, "b": {"at": [0, 0, 0]}, "c": {"at": [0, 0, 0], "orientation": "along"}},
    "elements": {"joint": {"kind": "ujoint", "nodes": ["a", "b"]}}, "outputs": ["GROT", "ALPHA", "GAMMA"],
    "frames": [{"time": 0}, {"time": 1, "nodes": {"a": {"ur": [0, 0, 0.1]}, "b": {"ur": [0, 0, 0.25]}}}]}"#;

/// The first node's triad is required; a second node without one has the triad of the first at the start.
#[test]
fn a_required_triad_is_required_and_the_second_is_the_first() {
    for kind in ["slot", "translator", "ujoint"] {
        let text = TRIADS.replace("ujoint", kind).replace(r#"["a", "b"]"#, r#"["b", "c"]"#).replace("GROT", "");
        let found = faults(&text.replace(r#""outputs": ["", "ALPHA", "GAMMA"],"#, ""));
        assert_eq!(found.len(), 1, "{found:?}");
        let said = "node a, \"b\", without an orientation; allowed is a node a with an \"orientation\"";
        assert!(found[0].contains(said), "{found:?}");
    }
    let results = Results::of(&Scene::parse(TRIADS).unwrap()).unwrap();
    for state in 0..2 {
        assert!(results.get("joint", "GROT", state).unwrap()[0].abs() < 1e-16, "the cross is at right angles");
    }
    assert!((results.get("joint", "GAMMA", 1).unwrap()[0] - 0.15).abs() < 1e-15);

    // Two connectors that would give one node two triads.
    let other = r#""elements": {"other": {"kind": "ujoint", "nodes": ["c", "b"]}, "#;
    let found = faults(&TRIADS.replace("\"elements\": {", other));
    assert!(found.len() == 1 && found[0].contains("two connectors that differ in theirs"), "{found:?}");
}

#[test]
fn a_translator_that_starts_near_a_right_angle_is_refused() {
    for (beta, refused) in [(1.5, false), (1.57, true)] {
        let text = TRIADS.replace("ujoint", "translator").replace(r#""GROT", "ALPHA", "GAMMA""#, r#""UR2""#);
        let text = text.replace(r#""rotation": [0, 0, 0.5]"#, &format!(r#""rotation": [0, {beta}, 0]"#));
        let text = text.replace(r#"["a", "b"]"#, r#"["a", "c"]"#);
        let results = Results::of(&Scene::parse(&text).unwrap());
        assert_eq!(results.is_err(), refused);
        if let Err(problems) = results {
            let said = problems.to_string();
            let expected = "initial configuration, scene.angles: node \"c\" against node \"a\": beta is -1.57";
            assert!(said.contains(expected), "{said}");
        }
    }
}

/// The consequences of a mistake are not reported as further faults.
#[test]
fn one_mistake_is_one_fault() {
    let found = |element: &str, frames: &str| {
        let node = |name: &str| format!(r#""{name}": {{"at": [0, 0, 0], "orientation": "o"}}"#);
        faults(&format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}}, "nodes": {{{}}},
            "elements": {{"e": {element}}}, "frames": {frames}}}"#,
            ["a", "b", "c", "d"].map(node).join(", ")
        ))
    };
    let slot = |rest: &str| format!(r#"{{"kind": "slot"{rest}}}"#);
    let sound = slot(r#", "nodes": ["a", "b"]"#);
    for (frames, expected) in [
        ("[]", "frames (line 2, column 81): no frame; allowed is one frame or more"),
        ("5", "frames (line 2, column 81): 5; allowed is an array of frames"),
        ("[5]", "frames[0] (line 2, column 82): 5; allowed is an object"),
        (r#"[{"time": "0"}]"#, "frames[0].time (line 2, column 91): \"0\"; allowed is a finite number"),
        (r#"[{"time": 0, "nodes": 5}]"#, "frames[0].nodes (line 2, column 103): 5; allowed is an object of nodes"),
    ] {
        let found = found(&sound, frames);
        assert!(found.len() == 1 && found[0].starts_with(expected), "{found:#?}");
    }
    for (element, expected) in [
        ("5".into(), "5; allowed is an element"),
        (slot(r#", "mu": 0.5, "outputs": ["CSF1"]"#), "an element without \"nodes\""),
        (slot(r#", "nodes": 5"#), "5; allowed is an array of 2 nodes: a, b"),
        (slot(r#", "nodes": ["a", "b", "c", "d"]"#), "an array of 4; allowed is an array of 2 nodes"),
        (slot(r#", "nodes": ["a", "b"], "kind": "slott""#), "\"kind\" for the second time"),
        (slot(r#", "nodes": ["a", "b"], "outputs": ["CSF1"], "mu": 1, "k_stick": "x""#), "\"x\"; allowed is"),
        (slot(r#", "nodes": ["a", "b"], "outputs": 5"#), "5; allowed is an array of output names"),
        (r#"{"kind": "slider", "nodes": ["a", "b", "a"]}"#.into(), "node \"a\" for the second time"),
        (r#"{"kind": "slider", "nodes": ["a", "b", "b"]}"#.into(), "node \"b\" for the second time"),
    ] {
        let found = found(&element, r#"[{"time": 0}]"#);
        assert!(found.len() == 1 && found[0].contains(expected), "{element}: {found:#?}");
    }
}
