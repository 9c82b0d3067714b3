//! Histories in tables: the numbers of frames in JSON, whatever wrote the table, and faults with line and column.

use jointproof::scene::{Plan, Results, Run, Scene, Table, Tables};
use std::fs;

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

/// A telescope and a hinge, without frames or with these.
fn model(frames: &str) -> String {
    format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"axes": [[4, 3, 0], [-3, 4, 0]]}}}},
        "nodes": {{"1": {{"at": [0, 0, 0], "orientation": "o"}}, "2": {{"at": [1, 0.75, 0], "orientation": "o"}}, "PART-1.3": {{"at": [1, 0.75, 0]}}}},
        "elements": {{"tube": {{"kind": "translator", "nodes": ["1", "2"], "mu": 0.25, "k_stick": 1000}},
            "pin": {{"kind": "hinge", "nodes": ["2", "PART-1.3"]}}}},
        {frames} "outputs": ["U1", "UR1", "CSF1", "KF", "GY"]}}"#
    )
}

const FRAMES: &str = r#""frames": [
    {"time": 0.1, "nodes": {"2": {"u": [0.08, 0.06, 0], "ur": [0, 0, 0]}, "PART-1.3": {"u": [0.08, 0.06, 0], "ur": [0.25, 0, 0]}},
        "loads": {"tube": {"f2": 3, "f3": 4}}},
    {"time": 0.1, "nodes": {"2": {"u": [0.16, 0.12, 0.001], "ur": [0, 0, 0]}, "PART-1.3": {"u": [0.16, 0.12, 0], "ur": [5, 0, 0]}}},
    {"time": 0.25, "nodes": {"PART-1.3": {"u": [0, 0, 0], "ur": [0.5, 0, 1e-3]}}, "loads": {"tube": {"f2": -3, "f3": 0}}}
],"#;
const NODES: &str = "time,node,u1,u2,u3,ur1,ur3\n\
    0.1,2,0.08,0.06,0,0,0\n0.1,PART-1.3,0.08,0.06,0,0.25,0\n\
    0.1,2,0.16,0.12,0.001,0,0\n0.1,PART-1.3,0.16,0.12,0,5,0\n\
    0.25,PART-1.3,0,0,0,0.5,1e-3\n";
const LOADS: &str = "time,element,f2,f3\n0.1,tube,3,4\n0.1,tube,3,4\n0.25,tube,-3,0\n";

fn tables(nodes: &str, loads: &str) -> Tables {
    let table = |name: &str, text: &str| Some(Table::text(name, text.as_bytes())).filter(|_| !text.is_empty());
    Tables { nodes: table("u.csv", nodes), loads: table("f.csv", loads), pressures: None }
}

fn assert_same(tables: Tables, expected: &Results) {
    let scene = scene(&model("")).with_tables(tables).unwrap_or_else(|fault| panic!("{fault}"));
    let results = Results::of(&scene).unwrap();
    assert_eq!(results.times, expected.times);
    for (found, expected) in results.series.iter().zip(&expected.series) {
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!((&found.element, found.output), (&expected.element, expected.output));
        assert_eq!(bits(found.values.numbers()), bits(expected.values.numbers()), "{}", found.output);
    }
}

#[test]
fn a_table_gives_the_bits_of_frames_however_it_is_written() {
    let expected = Results::of(&scene(&model(FRAMES))).unwrap();
    assert_same(tables(NODES, LOADS), &expected);
    // As Windows and spreadsheets write it, with a mark of its encoding; and with padded cells.
    let crlf = format!("\u{feff}{}", NODES.replace('\n', "\r\n").replace(',', ";"));
    assert_same(tables(&crlf, &LOADS.replace(',', "\t")), &expected);
    assert_same(tables(&NODES.replace(',', " , "), &LOADS.replace(',', ",  ")), &expected);
    // Names of postprocessors, columns in another order, and columns that are not used.
    let renamed = NODES.replace("time,node,u1,u2,u3,ur1,ur3", "Time,Node Label,U-U1,UY,u_3,UR-UR1,URZ");
    assert_same(tables(&renamed, LOADS), &expected);
    let turned: Vec<_> =
        NODES.lines().map(|line| line.split(',').rev().collect::<Vec<_>>().join(",") + ",7\n").collect();
    let noted =
        scene(&model("")).with_tables(tables(&turned.concat().replacen(",7", ",\"Frame, last\"", 1), LOADS)).unwrap();
    assert_eq!(noted.notes(), ["u.csv: the columns Frame, last are not used"]);
    assert_same(tables(&turned.concat().replacen(",7", ",step", 1), LOADS), &expected);
    // Names in upper case.
    assert_same(tables(NODES, &LOADS.replace("tube", "TUBE")), &expected);
    // A part instance in a column of its own.
    let split = NODES
        .replace("node", "Part Instance Name,Node Label")
        .replace("PART-1.3", "PART-1,3")
        .replace("0.1,2", "0.1,,2");
    assert_same(tables(&split, LOADS), &expected);
}

#[test]
fn a_scene_names_its_tables() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("u.csv"), NODES).unwrap();
    fs::write(folder.path().join("f.csv"), LOADS).unwrap();
    let text = model(r#""frames": {"nodes": "u.csv", "loads": "f.csv"},"#);
    let scene = Scene::parse_in(folder.path(), &text).unwrap();
    let expected = Results::of(&self::scene(&model(FRAMES))).unwrap();
    assert_eq!(Results::of(&scene).unwrap().series, expected.series);
    let wrong = |frames: &str| Scene::parse_in(folder.path(), &model(frames)).unwrap_err().to_string();
    fs::write(folder.path().join("f.csv"), LOADS.replace("-3", "x")).unwrap();
    let found = wrong(r#""frames": {"nodes": "u.csv", "loads": "f.csv"},"#);
    let expected =
        "frames.loads (line 5, column 47): f.csv, line 4, column 3 (\"f2\"): \"x\"; allowed is a finite number";
    assert_eq!(found, expected);
    let found = wrong(r#""frames": {"time": "t", "nodes": "u.csv"},"#);
    assert!(found.starts_with("frames.time (line 5, column 20): unknown key \"time\""), "{found}");
    assert!(wrong(r#""frames": {"nodes": "none.csv"},"#).starts_with("frames.nodes (line 5, column 29): none.csv: "));
    assert!(Scene::parse(&text).unwrap_err().to_string().contains("a table in a text that is in no folder"));
}

#[test]
fn every_mistake_in_a_table_is_told_with_line_and_column() {
    for (nodes, expected) in [
        ("", "u.csv, line 1, column 1: no row; allowed is a first row with the names of the columns"),
        (
            "node,u1\n1,2\n",
            "u.csv, line 1, column 1: no column \"time\" among node, u1; allowed is a first row with the names of the columns, here one of time, ",
        ),
        ("time,u1\n1,2\n", "u.csv, line 1, column 1: no column \"node\" among time, u1; "),
        (
            "time,node,x\n1,2,3\n",
            "u.csv, line 1, column 1: no column of numbers that is known among time, node, x; allowed is some of u1, u2, u3, ur1, ur2, ur3",
        ),
        (
            "time,node,u1,U1\n1,2,3,4\n",
            "u.csv, line 1, column 4 (\"U1\"): this column for the second time; allowed is each once",
        ),
        ("time,node,u1\n1,2\n", "u.csv, line 2, column 3: 2 cells; allowed is 3, as in the first row"),
        (
            "time,node,u1\r\n\r\n1,2,3\r\n1,\"2\r\n",
            "u.csv, line 4, column 2: a quotation mark that does not end in its line; ",
        ),
        ("\n\r\ntime,node,u1\r\n1,2,3\r\n1,2,x", "u.csv, line 5, column 3 (\"u1\"): \"x\"; "),
        ("time,node,u1\n\n1,2,1.5e\n", "u.csv, line 3, column 3 (\"u1\"): \"1.5e\"; allowed is a finite number"),
        ("time;node;u1\n1;2;0,5\n", "u.csv, line 2, column 3 (\"u1\"): \"0,5\"; allowed is a finite number"),
        ("time,node,u1\n1,2,\n", "u.csv, line 2, column 3 (\"u1\"): an empty cell; allowed is a finite number"),
        ("time,node,u1\n1,2,nan\n", "u.csv, line 2, column 3 (\"u1\"): \"nan\"; allowed is a finite number"),
        ("time,node,u1\n1,2,1e999\n", "u.csv, line 2, column 3 (\"u1\"): \"1e999\"; allowed is a finite number"),
        ("time,node,u1\nx,2,1\n", "u.csv, line 2, column 1 (\"time\"): \"x\"; allowed is a finite number"),
        (
            "time,node,u1\n1,2,0\n2,2,0\n1,1,0\n",
            "u.csv, line 4, column 1 (\"time\"): 1.0 after 2.0; allowed is a time of at least 2.0: the rows of a state together, and states in order of time; sort by time",
        ),
        (
            "time,node,u1\n1,2,0\n1,1,0\n1,1,0\n",
            "u.csv, line 4, column 2 (\"node\"): \"1\" for the second time in the state at time 1.0; allowed is each once in a state, or the whole state again",
        ),
        (
            "time,node,u1\n1,7,0\n1,8,0\n",
            "u.csv, line 2, column 2 (\"node\"): \"7\", and no node of the scene; allowed is rows about each node that changes",
        ),
        ("time,node,u1\n", "u.csv, line 1, column 2 (\"node\"): no row; allowed is "),
    ] {
        let tables = Tables { nodes: Some(Table::text("u.csv", nodes.as_bytes())), ..Tables::default() };
        let fault = scene(&model("")).with_tables(tables).unwrap_err().to_string();
        assert!(fault.contains(expected), "{nodes:?}: {fault}");
    }
    for (loads, expected) in [
        (
            "time,element,f1\n0.1,pin,1\n",
            "f.csv, line 2, column 1 (\"time\"): the last of 1 states; allowed is 3, as in u.csv",
        ),
        (
            "time,element,f1\n0.2,pin,1\n",
            "f.csv, line 2, column 1 (\"time\"): the time 0.2 of state 0; allowed is 0.1, as in u.csv",
        ),
        (
            "time,element,f1,m1\n0.1,tube,1,2\n0.1,tube,1,2\n0.25,tube,1,2\n1,tube,1,2\n",
            "f.csv, line 5, column 1 (\"time\"): the time 1.0 of state 3; allowed is no further state, as in u.csv",
        ),
        ("time,element,f1\n0.1,pin,1\n0.1,gear,1\n0.1,pin,1\n0.25,pin,1\n", ""),
    ] {
        let given = scene(&model("")).with_tables(tables(NODES, loads));
        match given {
            Err(fault) => assert_eq!(fault.to_string(), expected),
            Ok(scene) => {
                let warned =
                    "f.csv: 1 rows name no element of the scene, the first in line 3 \"gear\"; they are ignored";
                assert_eq!((expected, scene.warnings()), ("", vec![warned.into()]));
            }
        }
    }
}

/// In the plane nodes do not leave it, and an element has the loads of its kind.
#[test]
fn what_the_scene_cannot_have_must_be_0() {
    let plane = r#"{"dimension": "2d", "orientations": {"o": {"angle": 0}}, "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": [1, 0]}},
        "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["U1"]}"#;
    let given = |nodes: &str| {
        scene(plane).with_tables(Tables { nodes: Some(Table::text("u.csv", nodes.as_bytes())), ..Tables::default() })
    };
    let moved = given("time,node,u1,u2,u3,ur1,ur2,ur3\n1,b,0.5,0,0,0,0,0.25\n").unwrap();
    assert_eq!(Results::of(&moved).unwrap().get("e", "U1", 0), Some(&[0.5][..]));
    let fault = given("time,node,u1,u3\n1,b,0.5,1\n").unwrap_err().to_string();
    assert_eq!(fault, "u.csv, line 2, column 4 (\"u3\"): 1.0; allowed is 0, since the scene is 2d");
    let loads = Table::text("f.csv", "time,element,f3,m1\n1,e,0,2\n".as_bytes());
    let fault = scene(plane).with_tables(Tables { loads: Some(loads), ..Tables::default() }).unwrap_err().to_string();
    assert_eq!(fault, "f.csv, line 2, column 4 (\"m1\"): 2.0; allowed is no m1, which slot does not have");
}

#[test]
fn pressures_are_a_table_too() {
    let seat = |frames: &str| {
        format!(
            r#"{{"dimension": "axisymmetric", "nodes": {{"1": {{"at": [1, 0]}}, "2": {{"at": [5, 0]}}, "p": {{"at": [2, 0]}}, "q": {{"at": [3, 0]}}}},
            "slide_lines": {{"seat": {{"type": "linear", "nodes": ["1", "2"], "pressure": {{"tolerance": 1e-6}}}}}},
            "elements": {{"e": {{"kind": "isl21a", "nodes": ["p", "q"], "slide_line": "seat"}}}}, {frames} "outputs": ["S11", "T"]}}"#
        )
    };
    let frames = r#""frames": [{"time": 0, "pressures": {"p": 3}}, {"time": 1, "nodes": {"q": {"u": [0.5, 0]}}, "pressures": {"p": 4, "q": 5}}],"#;
    let given = Tables {
        nodes: Some(Table::text("u.csv", "time,node,u1\n0,q,0\n1,q,0.5\n".as_bytes())),
        loads: None,
        pressures: Some(Table::text("p.csv", "time,node,CPRESS\n0,p,3\n1,p,4\n1,q,5\n".as_bytes())),
    };
    let found = Results::of(&scene(&seat("")).with_tables(given).unwrap()).unwrap();
    assert_eq!(found.series, Results::of(&scene(&seat(frames))).unwrap().series);
}

/// The states are read one by one, so what lasts does not depend on their number.
#[test]
fn memory_does_not_grow_with_the_states_of_a_table() {
    let bytes = |states: u32| {
        let rows: Vec<_> = (0..states).map(|time| format!("{time},2,0.5,0\n{time},PART-1.3,0.25,1\n")).collect();
        let rows = rows.concat();
        let scene = scene(&model("")).with_tables(tables(&format!("time,node,u1,ur1\n{rows}"), "")).unwrap();
        let plan = Plan::new(&scene);
        let mut run = Run::<f64>::new(&plan).unwrap();
        assert!(run.advance().unwrap());
        run.bytes()
    };
    assert_eq!(bytes(10), bytes(1000));
}

#[test]
fn a_table_that_changes_after_the_scene_was_read_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("u.csv");
    for changed in [
        NODES.replace("0.08", "0.09"),
        NODES.replace("0.25,PART", "0.5,PART"),
        NODES[..100].into(),
        format!("{NODES}1,2,0,0,0,0,0\n"),
        "x".into(),
    ] {
        fs::write(&path, NODES).unwrap();
        let tables = Tables { nodes: Some(Table::file(&path)), ..Tables::default() };
        let scene = scene(&model("")).with_tables(tables).unwrap();
        assert!(Results::of(&scene).is_ok());
        fs::write(&path, &changed).unwrap();
        let stopped = Results::of(&scene).unwrap_err().to_string();
        assert!(stopped.contains("u.csv") && stopped.contains("since the scene was read"), "{changed}: {stopped}");
        fs::remove_file(&path).unwrap();
        assert!(Results::of(&scene).is_err());
    }
}
