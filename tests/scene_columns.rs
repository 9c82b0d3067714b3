//! Scenes whose numbers are stored as arrays in a file: they give the same bits as from JSON, and mistakes are detected as
//! carefully.

use crate::columns::{Array, FILE, array, column_bits, file, parse};
use jointproof::scene::{Columns, Plan, Results, Run, Scene};
use rawzip::ZipArchive;
use serde_json::{Map, Value, json};
use std::fs;
use std::io::Cursor;
use std::path::Path;

/// The scenes of `golden/scenes`, by name.
fn examples() -> Vec<(String, Value)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/scenes");
    let mut names: Vec<_> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.retain(|name| name.matches('.').count() == 1 && name != "schema.json");
    names.sort();
    assert!(names.len() > 5);
    let read = |name: String| {
        let scene = serde_json::from_str(&fs::read_to_string(folder.join(&name)).unwrap()).unwrap();
        (name, scene)
    };
    names.into_iter().map(read).collect()
}

/// The numbers in a value of a frame: one, or several.
fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .map_or_else(|| vec![value.as_f64().unwrap()], |all| all.iter().map(|x| x.as_f64().unwrap()).collect())
}

/// The frames of a scene as arrays over all states: values that a frame does not mention remain unchanged.
fn as_columns(scene: &Value) -> (Value, Vec<Array>) {
    let frames = scene["frames"].as_array().unwrap();
    let times: Vec<_> = frames.iter().map(|frame| frame["time"].as_f64().unwrap()).collect();
    let mut arrays = vec![array("time", &[frames.len()], &times)];
    let mut history = json!({ "time": "time" });
    // Every value given in some frame, by its path.
    let mut paths: Vec<(String, Vec<String>)> = Vec::new();
    for part in ["nodes", "loads", "pressures"] {
        for (name, value) in frames.iter().filter_map(|frame| frame[part].as_object()).flatten() {
            let keys: Vec<_> = value.as_object().map_or_else(Vec::new, |keys| keys.keys().cloned().collect());
            let path = |key: Option<String>| [part.to_owned(), name.clone()].into_iter().chain(key).collect::<Vec<_>>();
            let all =
                if keys.is_empty() { vec![path(None)] } else { keys.into_iter().map(|key| path(Some(key))).collect() };
            paths.extend(all.into_iter().map(|path| (path.join(" of "), path)));
        }
    }
    paths.sort();
    paths.dedup();
    for (name, path) in paths {
        let at = |frame: &Value| path.iter().try_fold(frame.clone(), |value, key| value.get(key).cloned());
        let width = frames.iter().find_map(at).map(|value| (value.is_array(), numbers(&value).len())).unwrap();
        let mut last = vec![0.0; width.1];
        let mut column = Vec::new();
        for frame in frames {
            last = at(frame).map_or(last, |value| numbers(&value));
            column.extend(&last);
        }
        let shape = if width.0 { vec![frames.len(), width.1] } else { vec![frames.len()] };
        arrays.push((name.clone(), shape, column));
        let entry = path[..path.len() - 1].iter().fold(&mut history, |value, key| &mut value[key]);
        entry[path.last().unwrap()] = json!(name);
    }
    let mut scene = scene.clone();
    (scene["columns"], scene["frames"]) = (json!(FILE), history);
    (scene, arrays)
}

/// The results of a scene by element and output: the bits of every number, and NaN in a state without one.
fn bits(results: &Results) -> Vec<(String, Vec<u64>)> {
    let of_state = |width: usize, state: &[f64]| {
        let there = (0..width).map(|k| state.get(k).copied().unwrap_or(f64::NAN).to_bits());
        there.collect::<Vec<_>>()
    };
    let series = results.series.iter().map(|series| {
        let width = series.values.width();
        let values = series.values.iter().flat_map(|state| of_state(width, state)).collect();
        (format!("{}/{}", series.element, series.output), values)
    });
    series.collect()
}

#[test]
fn every_example_gives_the_same_bits_from_json_and_from_columns() {
    let folder = tempfile::tempdir().unwrap();
    for (name, json) in examples() {
        let scene = Scene::parse(&json.to_string()).unwrap();
        let results = Results::of(&scene).unwrap();
        let columns = Columns::of(&scene).unwrap();
        let mut of_results = bits(&results);
        let mut of_columns = column_bits(&columns);
        of_results.sort();
        of_columns.sort();
        assert_eq!(of_results, of_columns, "{name}: results");
        assert_eq!((&results.times, &results.counts), (&columns.times, &columns.counts), "{name}");
        let (described, arrays) = as_columns(&json);
        let from_columns =
            parse(folder.path(), &described, &file(&arrays)).unwrap_or_else(|faults| panic!("{name}: {faults}"));
        assert_eq!(bits(&results), bits(&Results::of(&from_columns).unwrap()), "{name}: history");
        let exact =
            [Columns::exact(&scene), Columns::exact(&from_columns)].map(|columns| column_bits(&columns.unwrap()));
        assert_eq!(exact[0], exact[1], "{name}: exact");
        of_results = exact[0].clone();
        of_results.sort();
        let mut expected = bits(&Results::exact(&scene).unwrap());
        expected.sort();
        assert_eq!(of_results, expected, "{name}: exact results");
    }
}

/// Compares the same scene in two forms: with sets and arrays, and with every member by its name.
fn assert_same(test: &str, sets: &Value, arrays: &[Array], single: &Value) {
    let of_sets = parse(tempfile::tempdir().unwrap().path(), sets, &file(arrays)).unwrap();
    let of_single = Scene::parse(&single.to_string()).unwrap_or_else(|faults| panic!("{faults}"));
    let results = Results::of(&of_sets).unwrap();
    assert_eq!(bits(&results), bits(&Results::of(&of_single).unwrap()), "{test}");
    assert_eq!(results.counts, Results::of(&of_single).unwrap().counts, "{test}");
    // The columns of a set contain those of its members in turn.
    let columns = Columns::of(&of_sets).unwrap();
    // Writing state by state gives the same file as writing array by array.
    let (mut written, mut streamed, mut states) = (Vec::new(), Cursor::new(Vec::new()), 0);
    columns.write(&mut written).unwrap();
    Columns::stream(&Plan::new(&of_sets), &mut streamed, || states += 1).unwrap();
    assert!(written == streamed.into_inner() && states == columns.times.len(), "{test}");
    let mut of_members: Vec<(String, Vec<u64>)> = Vec::new();
    for (column, (name, bits)) in columns.columns.iter().zip(column_bits(&columns)) {
        let (element, output) = name.rsplit_once('/').unwrap();
        let states = columns.times.len();
        let Some(count) = of_sets.kind(&format!("{element}[0]")).map(|_| column.shape[1]) else {
            of_members.push((name, bits));
            continue;
        };
        let width = bits.len() / states / count;
        for member in 0..count {
            let state = |state| &bits[(state * count + member) * width..][..width];
            of_members.push((format!("{element}[{member}]/{output}"), (0..states).flat_map(state).copied().collect()));
        }
    }
    let mut expected = self::bits(&results);
    of_members.sort();
    expected.sort();
    assert_eq!(of_members, expected, "{test}");
}

/// Entries named `name[0]`, `name[1]` and so on, like the members of sets.
fn members(name: &str, count: usize, of: impl Fn(usize) -> Value) -> Map<String, Value> {
    (0..count).map(|k| (format!("{name}[{k}]"), of(k))).collect()
}

fn merged<const N: usize>(all: [Map<String, Value>; N]) -> Value {
    Value::Object(all.into_iter().flatten().collect())
}

#[expect(clippy::cast_precision_loss, reason = "small")]
fn real(count: usize) -> f64 {
    count as f64
}

/// A number that differs for every item and component.
fn some(k: usize, component: usize) -> f64 {
    real((7 * k + 13 * component) % 101) / 64.0
}

/// Two thousand slots on one rail, every third of them without friction, and as many on rails of their own.
#[test]
fn sets_are_their_members() {
    const COUNT: usize = 2000;
    let at = |k: usize| [some(k, 0), some(k, 1), some(k, 2)];
    let own = |k: usize| [some(k, 3), some(k, 4), some(k, 5)];
    let mu = |k: usize| if k.is_multiple_of(3) { 0.0 } else { some(k, 1) };
    let moved = |state: usize, k: usize| [some(k, state), some(k, 2 * state + 1), -some(k, state + 5)];
    let turned = |state: usize, k: usize| [some(k, state + 1) / 9.0, 0.0, some(k, state) / 7.0];
    let load = |state: usize, k: usize| some(k, 3 * state) - 0.5;
    let outputs = json!(["RF", "U1", "GY", "CSF1", "CASU1", "UR1"]);
    let orientations = json!({ "along": { "axes": [[1, 0, 0], [0, 1, 0]] }, "askew": { "rotation": [0.1, 0.2, 0.3] } });
    let sets = json!({
        "dimension": "3d", "columns": FILE, "orientations": orientations, "outputs": outputs,
        "nodes": {
            "rail": { "at": [0.25, 0, 0], "orientation": "along" }, "a": { "at": "at", "orientation": "askew" }, "b": { "at": "own" },
        },
        "elements": {
            "one": { "kind": "slot", "nodes": ["rail", "b[7]"], "mu": 0.5, "k_stick": 10 },
            "slots": { "kind": "slot", "nodes": ["rail", "a"], "mu": "mu", "k_stick": 1e3 },
            "turning": { "kind": "translator", "nodes": ["a[::2]", "b[1000:]"], "mu": 0.125, "k_stick": 1e3, "rr": 0.25, "l": 2 },
        },
        "frames": {
            "time": "time", "nodes": { "b": { "u": "ub" }, "a": { "u": "ua", "ur": "ur" } },
            "loads": { "turning": { "f2": "m" }, "slots": { "f2": "f", "f3": "f" } },
        },
    });
    let each = |of: &dyn Fn(usize, usize) -> Vec<f64>, count: usize| -> Vec<f64> {
        (0..3).flat_map(|state| (0..count).flat_map(move |k| of(state, k))).collect()
    };
    let all = |of: &dyn Fn(usize) -> [f64; 3]| (0..COUNT).flat_map(of).collect::<Vec<_>>();
    let arrays = [
        array("time", &[3], &[0.0, 1.0, 1.5]),
        array("at", &[COUNT, 3], &all(&at)),
        array("own", &[COUNT, 3], &all(&own)),
        array("mu", &[COUNT], &(0..COUNT).map(mu).collect::<Vec<_>>()),
        array("ua", &[3, COUNT, 3], &each(&|state, k| moved(state, k).into(), COUNT)),
        array("ub", &[3, COUNT, 3], &each(&|state, k| moved(state + 1, k).into(), COUNT)),
        array("ur", &[3, COUNT, 3], &each(&|state, k| turned(state, k).into(), COUNT)),
        array("f", &[3, COUNT], &each(&|state, k| vec![load(state, k)], COUNT)),
        array("m", &[3, COUNT / 2], &each(&|state, k| vec![-load(state, k)], COUNT / 2)),
    ];
    let slot = |k| json!({ "kind": "slot", "nodes": ["rail", format!("a[{k}]")], "mu": mu(k), "k_stick": 1e3 });
    let turning = |k| {
        let nodes = [format!("a[{}]", 2 * k), format!("b[{}]", COUNT / 2 + k)];
        json!({ "kind": "translator", "nodes": nodes, "mu": 0.125, "k_stick": 1e3, "rr": 0.25, "l": 2 })
    };
    let frame = |state: usize| {
        let a = members("a", COUNT, |k| json!({ "u": moved(state, k), "ur": turned(state, k) }));
        let b = members("b", COUNT, |k| json!({ "u": moved(state + 1, k) }));
        let slots = members("slots", COUNT, |k| json!({ "f2": load(state, k), "f3": load(state, k) }));
        let turning = members("turning", COUNT / 2, |k| json!({ "f2": -load(state, k) }));
        json!({ "time": ([0.0, 1.0, 1.5][state]), "nodes": merged([a, b]), "loads": merged([slots, turning]) })
    };
    let one = json!({ "one": { "kind": "slot", "nodes": ["rail", "b[7]"], "mu": 0.5, "k_stick": 10 } });
    let rail = json!({ "rail": { "at": [0.25, 0, 0], "orientation": "along" } });
    let a = members("a", COUNT, |k| json!({ "at": at(k), "orientation": "askew" }));
    let b = members("b", COUNT, |k| json!({ "at": own(k) }));
    let slots = members("slots", COUNT, slot);
    let single = json!({
        "dimension": "3d", "orientations": orientations, "outputs": outputs,
        "nodes": merged([rail.as_object().unwrap().clone(), a, b]),
        "elements": merged([one.as_object().unwrap().clone(), slots, members("turning", COUNT / 2, turning)]),
        "frames": (0..3).map(frame).collect::<Vec<_>>(),
    });
    assert_same("sets", &sets, &arrays, &single);
}

/// The threads of a pin on a box: each element lies between neighbours of one set.
#[test]
fn elements_lie_between_neighbours_of_a_set() {
    const PINS: usize = 9;
    let pin = |k: usize| [0.5 + some(k, 0) / 50.0, some(k, 0) / 3.0 + real(k)];
    let moved = |state: usize, k: usize| [0.01 * real(state), -some(k, state) / 4.0];
    let elements = |kind: &str, nodes: &[&str]| json!({ "kind": kind, "nodes": nodes, "slide_line": "box" });
    let line = json!({ "type": "linear", "nodes": ["box"], "smooth": 0.25, "pressure": { "k": 100 },
        "friction": { "mu": 0.25, "k_stick": 1e3 }, "torque_frequency": 2 });
    let outputs = json!(["E11", "E12", "S11", "S12", "T", "AREA", "T1"]);
    let sets = json!({
        "dimension": "axisymmetric", "columns": FILE, "outputs": outputs,
        "nodes": { "box": { "at": "box" }, "pin": { "at": "pin" } }, "slide_lines": { "box": line },
        "elements": {
            "first": elements("isl21a", &["pin[:-1]", "pin[1:]"]),
            "second": elements("isl22a", &["pin[:-2:2]", "pin[1:-1:2]", "pin[2::2]"]),
        },
        "frames": { "time": "time", "nodes": { "pin": { "u": "u" } } },
    });
    let path = [[1.0, -5.0], [1.25, 3.0], [1.0, 12.0], [0.75, 20.0]];
    let arrays = [
        array("time", &[3], &[0.0, 0.5, 2.0]),
        array("box", &[4, 2], path.as_flattened()),
        array("pin", &[PINS, 2], &(0..PINS).flat_map(pin).collect::<Vec<_>>()),
        array("u", &[3, PINS, 2], &(0..3).flat_map(|s| (0..PINS).flat_map(move |k| moved(s, k))).collect::<Vec<_>>()),
    ];
    let between = |kind: &str, at: usize, count: usize| json!({ "kind": kind, "nodes": (at..=at + count).map(|k| format!("pin[{k}]")).collect::<Vec<_>>(), "slide_line": "box" });
    let mut single = sets.clone();
    single.as_object_mut().unwrap().remove("columns");
    single["nodes"] =
        merged([members("box", 4, |k| json!({ "at": path[k] })), members("pin", PINS, |k| json!({ "at": pin(k) }))]);
    single["slide_lines"]["box"]["nodes"] = json!((0..4).map(|k| format!("box[{k}]")).collect::<Vec<_>>());
    single["elements"] = merged([
        members("first", PINS - 1, |k| between("isl21a", k, 1)),
        members("second", PINS / 2, |k| between("isl22a", 2 * k, 2)),
    ]);
    let frame = |state| json!({ "time": ([0.0, 0.5, 2.0][state]), "nodes": members("pin", PINS, |k| json!({ "u": moved(state, k) })) });
    single["frames"] = (0..3).map(frame).collect();
    assert_same("neighbours", &sets, &arrays, &single);
}

/// Arrays of parts of a set, in any order, equal those of the set; in the plane, where values have two components or one.
#[test]
fn a_history_may_be_given_in_parts() {
    const COUNT: usize = 5;
    const STATES: usize = 3;
    let scene = |nodes: Value, loads: Value| {
        json!({ "dimension": "2d", "columns": FILE, "orientations": { "o": { "angle": 0.5 } },
            "nodes": { "b": { "at": "b" }, "a": { "at": "a", "orientation": "o" } },
            "elements": { "e": { "kind": "slot", "nodes": ["a", "b"], "mu": 0.25, "k_stick": 8 } },
            "outputs": ["U1", "CSF1", "RF"], "frames": { "time": "time", "nodes": nodes, "loads": loads } })
    };
    let each = |from: usize, step: usize, of: &dyn Fn(usize, usize) -> Vec<f64>| -> Vec<f64> {
        (0..STATES).flat_map(|state| (from..COUNT).step_by(step).flat_map(move |k| of(state, k))).collect()
    };
    let u = |state, k| vec![some(k, state), some(k, state + 4)];
    let ur = |state, k| vec![some(k, 2 * state) / 8.0];
    let f = |state, k| vec![some(k, 3 * state) - 0.5];
    let at = |shift: usize| (0..COUNT).flat_map(|k| [some(k, shift), real(k)]).collect::<Vec<_>>();
    let arrays = file(&[
        array("a", &[COUNT, 2], &at(0)),
        array("b", &[COUNT, 2], &at(5)),
        array("time", &[STATES], &[0.0, 1.0, 1.5]),
        array("u", &[STATES, COUNT, 2], &each(0, 1, &u)),
        array("even", &[STATES, 3, 2], &each(0, 2, &u)),
        array("odd", &[STATES, 2, 2], &each(1, 2, &u)),
        array("ur", &[STATES, COUNT], &each(0, 1, &ur)),
        array("last", &[STATES], &each(4, 1, &ur)),
        array(
            "others",
            &[STATES, 4],
            &(0..STATES).flat_map(|state| (0..4).flat_map(move |k| ur(state, k))).collect::<Vec<_>>(),
        ),
        array("f", &[STATES, COUNT], &each(0, 1, &f)),
        array("f even", &[STATES, 3], &each(0, 2, &f)),
        array("f odd", &[STATES, 2], &each(1, 2, &f)),
    ]);
    let whole = scene(json!({ "b": { "u": "u" }, "a": { "ur": "ur" } }), json!({ "e": { "f2": "f" } }));
    let parts = scene(
        json!({ "b[1::2]": { "u": "odd" }, "b[::2]": { "u": "even" }, "a[-1]": { "ur": "last" }, "a[:-1]": { "ur": "others" } }),
        json!({ "e[::2]": { "f2": "f even" }, "e[1::2]": { "f2": "f odd" } }),
    );
    let folder = tempfile::tempdir().unwrap();
    let results = |scene: &Value| column_bits(&Columns::of(&parse(folder.path(), scene, &arrays).unwrap()).unwrap());
    assert_eq!(results(&whole), results(&parts));
    let moved = Columns::of(&parse(folder.path(), &parts, &arrays).unwrap()).unwrap();
    assert!(moved.get("e", "RF").unwrap().numbers.iter().any(|&number| number != 0.0));
}

/// Only the values of one state of a history in columns are in memory.
#[test]
fn memory_does_not_grow_with_the_states() {
    const COUNT: usize = 50;
    let scene = json!({ "dimension": "2d", "columns": FILE, "orientations": { "o": { "angle": 0.5 } },
        "nodes": { "a": { "at": [0, 0], "orientation": "o" }, "b": { "at": "b" } },
        "elements": { "e": { "kind": "slot", "nodes": ["a", "b"], "mu": 0.25, "k_stick": 8 } }, "outputs": ["CSF1"],
        "frames": { "time": "time", "nodes": { "b": { "u": "u" } }, "loads": { "e": { "f2": "f" } } } });
    let folder = tempfile::tempdir().unwrap();
    let bytes = |states: usize| {
        let arrays = file(&[
            array("b", &[COUNT, 2], &[1.0; 2 * COUNT]),
            array("time", &[states], &(0..states).map(real).collect::<Vec<_>>()),
            array("u", &[states, COUNT, 2], &vec![0.5; states * COUNT * 2]),
            array("f", &[states, COUNT], &vec![2.0; states * COUNT]),
        ]);
        let scene = parse(folder.path(), &scene, &arrays).unwrap();
        let plan = Plan::new(&scene);
        let mut run = Run::<f64>::new(&plan).unwrap();
        let before = run.bytes();
        while run.advance().unwrap() {}
        assert_eq!(before, run.bytes(), "{states} states");
        before
    };
    let [elements, nodes] = bytes(2);
    assert_eq!(bytes(200), [elements, nodes]);
    // Their positions, and their displacements in the evaluated state and in the next.
    assert!(nodes > 3 * COUNT * size_of::<[f64; 3]>(), "{nodes}");
}

/// In frames of numbers, a set is moved as a whole.
#[test]
fn a_number_in_a_frame_is_that_of_every_member() {
    let scene = |nodes: Value| {
        json!({ "dimension": "2d", "columns": FILE, "orientations": { "o": { "angle": 0 } },
            "nodes": { "a": { "at": [0, 0], "orientation": "o" }, "b": { "at": "b" } },
            "elements": { "e": { "kind": "slot", "nodes": ["a", "b"] } }, "outputs": ["U1"],
            "frames": [{ "time": 0, "nodes": nodes, "loads": { "e[1:]": { "f2": 3 }, "e[0]": { "f2": 1 } } }] })
    };
    let arrays = file(&[array("b", &[3, 2], &[1.0, 0.0, 2.0, 0.0, 3.0, 0.0])]);
    let folder = tempfile::tempdir().unwrap();
    let moved = parse(folder.path(), &scene(json!({ "b[1]": { "u": [0.5, 0] }, "b[0]": { "u": [0.25, 0] } })), &arrays);
    let columns = Columns::of(&moved.unwrap()).unwrap();
    assert_eq!(
        columns.get("e", "U1").map(|column| (&*column.shape, &*column.numbers)),
        Some((&[1, 3][..], &[0.25, 0.5, 0.0][..]))
    );
    let moved =
        Columns::of(&parse(folder.path(), &scene(json!({ "b": { "u": [0.5, 0] } })), &arrays).unwrap()).unwrap();
    assert_eq!(moved.get("e", "U1").unwrap().numbers, [0.5; 3]);
    let twice = parse(folder.path(), &scene(json!({ "b": { "u": [0.5, 0] }, "b[2]": { "u": [0.5, 0] } })), &arrays);
    assert!(twice.unwrap_err().contains("\"b[2]\" for the second time"));
}

/// The loads of a part of a set are those of its own kind, whatever kind follows it.
#[test]
fn the_last_member_of_a_set_is_of_the_kind_of_the_set() {
    let scene = |frames: Value| {
        json!({ "dimension": "3d", "columns": FILE, "orientations": { "o": { "rotation": [0, 0, 0] } },
            "nodes": { "a": { "at": [0, 0, 0], "orientation": "o" }, "b": { "at": "b" } },
            "elements": { "e": { "kind": "slot", "nodes": ["a", "b"] }, "t": { "kind": "align", "nodes": ["a", "b[0]"] } },
            "outputs": ["FC", "RM"], "frames": frames })
    };
    let arrays = file(&[array("b", &[3, 3], &[1.0; 9]), array("time", &[1], &[0.0]), array("f", &[1, 1], &[3.0])]);
    let folder = tempfile::tempdir().unwrap();
    for frames in [
        json!([{ "time": 0, "loads": { "e[2:]": { "f2": 3 } } }]),
        json!({ "time": "time", "loads": { "e[2:]": { "f2": "f" } } }),
    ] {
        let scene = parse(folder.path(), &scene(frames), &arrays).unwrap();
        assert_eq!(Columns::of(&scene).unwrap().get("e", "FC").unwrap().numbers, [0.0, 0.0, 3.0]);
    }
}

#[test]
fn the_same_results_have_the_same_bytes() {
    let text = include_str!("../golden/scenes/thread.json");
    let written = || {
        let mut bytes = Vec::new();
        Columns::of(&Scene::parse(text).unwrap()).unwrap().write(&mut bytes).unwrap();
        bytes
    };
    assert_eq!(written(), written());
    let mut streamed = Cursor::new(Vec::new());
    Columns::stream(&Plan::new(&Scene::parse(text).unwrap()), &mut streamed, || ()).unwrap();
    assert_eq!(streamed.into_inner(), written());
    // Independent of the clock: the time of every entry is the earliest possible.
    let bytes = written();
    let archive = ZipArchive::from_slice(&bytes).unwrap();
    let mut entries = archive.entries();
    let mut names = Vec::new();
    while let Some(entry) = entries.next_entry().unwrap() {
        names.push(String::from_utf8(entry.file_path().as_bytes().to_vec()).unwrap());
        let modified = entry.last_modified();
        assert_eq!((modified.year(), modified.month(), modified.day()), (1980, 1, 1));
    }
    assert_eq!(names[..3], ["time.npy", "thread 1/E11.npy", "thread 1/E12.npy"]);
}
