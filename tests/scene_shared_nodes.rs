//! Nodes at which connectors have several orientations, and connectors to ground.

use crate::columns::{FILE, array, file, parse};
use jointproof::scene::{Deck, Results, Scene, Table, Tables};
use serde_json::{Value, json};

/// A shaft of three pieces: both of its inner nodes have connectors that measure in different axes.
const SHAFT: &str = "\
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 2., 0.5, 0.
*ORIENTATION, NAME=A
1., 0., 0., 0., 1., 0.
*ORIENTATION, NAME=B
4., 3., 0., -3., 4., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=FIRST
10, 1, 2
*ELEMENT, TYPE=CONN3D2, ELSET=SECOND
20, 2, 3
*ELEMENT, TYPE=CONN3D2, ELSET=GROUNDED
30, , 2
*CONNECTOR SECTION, ELSET=FIRST
UNIVERSAL
A
*CONNECTOR SECTION, ELSET=SECOND
UJOINT
B, A
*CONNECTOR SECTION, ELSET=GROUNDED
REVOLUTE
B
";

/// The scene of a deck as a value.
fn scene_of(deck: &str) -> Value {
    let deck = Deck::parse(deck).unwrap_or_else(|faults| panic!("{faults}"));
    serde_json::from_str(deck.text()).unwrap()
}

fn results(scene: &Value) -> Results {
    let scene = Scene::parse(&scene.to_string()).unwrap_or_else(|faults| panic!("{faults}"));
    Results::of(&scene).unwrap()
}

fn bits(results: &Results) -> Vec<(String, &'static str, Vec<u64>)> {
    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect();
    results.series.iter().map(|series| (series.element.clone(), series.output, bits(series.values.numbers()))).collect()
}

fn frames() -> Value {
    json!([
        { "time": 0, "nodes": { "2": { "u": [0, 0.001, 0], "ur": [0.25, 0, 0] } } },
        { "time": 1, "nodes": { "2": { "ur": [7.5, 0, 0] }, "3": { "u": [0, 0, 0.25], "ur": [0.25, 0.5, 0] } } },
        { "time": 2, "nodes": { "1": { "ur": [0, 0, 0.125] }, "2": { "ur": [0.5, 0.125, 0.25] } } },
    ])
}

#[test]
fn a_deck_with_several_orientations_at_a_node_has_a_node_for_each() {
    let scene = scene_of(SHAFT);
    let nodes = json!({
        "1": { "at": [0.0, 0.0, 0.0], "orientation": "A" },
        "2": { "at": [1.0, 0.0, 0.0], "orientation": "B" },
        "2 (A)": { "with": "2", "orientation": "A" },
        "3": { "at": [2.0, 0.5, 0.0], "orientation": "A" },
        "ground of 30": { "at": [1.0, 0.0, 0.0], "orientation": "B" },
    });
    assert_eq!(scene["nodes"], nodes);
    let ends: Vec<_> = ["10", "20", "30"].iter().map(|name| &scene["elements"][name]["nodes"]).collect();
    assert_eq!(ends, [&json!(["1", "2 (A)"]), &json!(["2", "3"]), &json!(["ground of 30", "2"])]);
}

#[test]
fn a_node_with_another_moves_and_turns_as_if_it_were_told_so_itself() {
    let mut shared = scene_of(SHAFT);
    shared["frames"] = frames();
    let mut apart = shared.clone();
    apart["nodes"]["2 (A)"] = json!({ "at": [1, 0, 0], "orientation": "A" });
    for frame in apart["frames"].as_array_mut().unwrap() {
        if let Some(motion) = frame["nodes"].get("2").cloned() {
            frame["nodes"]["2 (A)"] = motion;
        }
    }
    let (shared, apart) = (results(&shared), results(&apart));
    assert_eq!(bits(&shared), bits(&apart));
    // Its rotation is followed over more than a turn.
    let (_, _, angles) = bits(&shared).into_iter().find(|(name, output, _)| name == "10" && *output == "UR1").unwrap();
    assert!(angles.iter().any(|&angle| f64::from_bits(angle) > std::f64::consts::TAU));
}

#[test]
fn tables_and_arrays_move_nodes_with_others_too() {
    let mut scene = scene_of(SHAFT);
    let alone = Scene::parse(&scene.to_string()).unwrap();
    let table = "time,node,u1,u2,u3,ur1,ur2,ur3\n\
        0,2,0,0.001,0,0.25,0,0\n1,2,0,0.001,0,7.5,0,0\n1,3,0,0,0.25,0.25,0.5,0\n\
        2,1,0,0,0,0,0,0.125\n2,2,0,0.001,0,0.5,0.125,0.25\n";
    let tables = |nodes: &str| Tables { nodes: Some(Table::text("u.csv", nodes.as_bytes())), ..Tables::default() };
    let of_tables = Results::of(&alone.clone().with_tables(tables(table)).unwrap()).unwrap();
    let turns = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.125];
    let of_2 = [[0.25, 0.0, 0.0], [7.5, 0.0, 0.0], [0.5, 0.125, 0.25]].concat();
    let of_3 = [[0.0; 3], [0.25, 0.5, 0.0], [0.25, 0.5, 0.0]].concat();
    let [along, beside] = [[0.0, 0.001, 0.0].repeat(3), [[0.0; 3], [0.0, 0.0, 0.25], [0.0, 0.0, 0.25]].concat()];
    let arrays = [("t1", &turns[..]), ("t2", &of_2), ("t3", &of_3), ("u2", &along), ("u3", &beside)];
    let mut arrays: Vec<_> = arrays.iter().map(|&(name, numbers)| array(name, &[3, 3], numbers)).collect();
    arrays.push(array("time", &[3], &[0.0, 1.0, 2.0]));
    scene["columns"] = json!(FILE);
    let mut of_arrays = scene.clone();
    of_arrays["frames"] = json!({ "time": "time",
        "nodes": { "1": { "ur": "t1" }, "2": { "u": "u2", "ur": "t2" }, "3": { "u": "u3", "ur": "t3" } } });
    let folder = tempfile::tempdir().unwrap();
    let of_arrays = parse(folder.path(), &of_arrays, &file(&arrays)).unwrap();
    let mut of_frames = scene_of(SHAFT);
    of_frames["frames"] = frames();
    let expected = results(&of_frames);
    assert_eq!(bits(&of_tables), bits(&expected));
    assert_eq!(bits(&Results::of(&of_arrays).unwrap()), bits(&expected));
    // But it has no motion of its own.
    let fault = alone.with_tables(tables("time,node,u1\n0,2 (A),1\n")).unwrap_err();
    let said = "u.csv, line 2, column 2 (\"node\"): node \"2 (A)\", which moves with \"2\"; allowed is \"2\", with which it moves";
    assert_eq!(fault.to_string(), said);
    scene["frames"] = json!({ "time": "time", "nodes": { "2 (A)": { "u": "u2" } } });
    let faults = parse(folder.path(), &scene, &file(&arrays)).unwrap_err();
    assert!(faults.contains("node \"2 (A)\", which moves with \"2\""), "{faults}");
}

#[test]
fn what_a_node_with_another_cannot_be_is_said() {
    for (node, said) in [
        (json!({ "at": [1, 0, 0], "with": "2" }), "\"at\" and \"with\"; allowed is a node with its coordinates, or"),
        (json!({ "orientation": "A" }), "a node without \"at\"; allowed is a node with its coordinates, or with the"),
        (json!({ "with": "3" }), "no node above \"3\"; allowed is one of \"1\", \"2\""),
        (json!({ "with": 3 }), "3; allowed is the name of a node above"),
    ] {
        let mut scene = scene_of(SHAFT);
        scene["nodes"]["2 (A)"] = node;
        let faults = Scene::parse(&scene.to_string()).unwrap_err().to_string();
        assert!(faults.contains(said), "{faults}");
    }
    let mut scene = scene_of(SHAFT);
    scene["elements"]["10"]["nodes"] = json!(["2", "2 (A)"]);
    let faults = Scene::parse(&scene.to_string()).unwrap_err().to_string();
    assert!(faults.contains("node \"2 (A)\" for the second time; allowed is different nodes"), "{faults}");
    let mut scene = scene_of(SHAFT);
    scene["frames"] = json!([{ "time": 0, "nodes": { "2 (A)": { "u": [0, 0, 0] } } }]);
    let faults = Scene::parse(&scene.to_string()).unwrap_err().to_string();
    assert!(
        faults.contains("node \"2 (A)\", which moves with \"2\"; allowed is \"2\", with which it moves"),
        "{faults}"
    );
    // With a node with another, it is with that other one.
    let mut scene = scene_of(SHAFT);
    scene["nodes"]["2 again"] = json!({ "with": "2 (A)", "orientation": "B" });
    scene["elements"]["20"]["nodes"] = json!(["2 again", "3"]);
    scene["frames"] = frames();
    let again = results(&scene);
    scene["elements"]["20"]["nodes"] = json!(["2", "3"]);
    assert_eq!(bits(&again), bits(&results(&scene)));
}

#[test]
fn a_connector_to_ground_has_one_node_in_any_spelling() {
    let ground = |line: &str| {
        let scene = scene_of(&SHAFT.replace("30, , 2\n", &format!("{line}\n31, 3, 2\n")));
        (scene["elements"]["30"]["nodes"].clone(), scene["elements"]["31"]["nodes"].clone())
    };
    let to = |first: &str, second: &str| (json!([first, second]), json!(["3 (B)", "2"]));
    for line in ["30, , 2", "30,,2", " 30 , , 2 ,"] {
        assert_eq!(ground(line), to("ground of 30", "2"), "{line}");
    }
    for line in ["30, 2", "30, 2,", "30, 2, ,"] {
        assert_eq!(ground(line), to("2", "ground of 30"), "{line}");
    }
    // A line goes on after a comma, if one node follows.
    assert_eq!(ground("30,\n2,\n1"), to("2", "1 (B)"));
    let faults = |deck: String| Deck::parse(&deck).err().unwrap().to_string();
    let no_node = faults(SHAFT.replace("30, , 2", "30, ,"));
    assert!(no_node.contains("*ELEMENT (line 14, column 5): a blank field"), "{no_node}");
    let unknown = faults(SHAFT.replace("30, , 2", "30, , 9"));
    assert!(unknown.contains("no node 9") && !unknown.contains("ground"), "{unknown}");
    let three = faults(SHAFT.replace("30, , 2", "30, 1, 2, 3"));
    assert!(three.contains("3 nodes; allowed is 2 nodes, or 1 and ground, for CONN3D2"), "{three}");
    let sliding = faults("*NODE\n1, 1., 0.\n2, 1., 1.\n*ELEMENT, TYPE=ISL21A, ELSET=S\n1, , 2\n".into());
    assert!(sliding.contains("a blank field; allowed is the number of a node"), "{sliding}");
}

#[test]
fn a_connector_to_ground_in_an_instance_is_at_its_moved_node() {
    let scene = scene_of(
        "\
*PART, NAME=ARM
*NODE
1, 1., 0., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=E
1, 1
*CONNECTOR SECTION, ELSET=E
JOIN
*END PART
*ASSEMBLY, NAME=A
*INSTANCE, NAME=Left, PART=ARM
0., 2., 0.
*END INSTANCE
*NODE
1, 5., 0., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=E
1, , 1
*CONNECTOR SECTION, ELSET=E
JOIN
*END ASSEMBLY
",
    );
    assert_eq!(scene["nodes"]["ground of Left.1"]["at"], json!([1.0, 2.0, 0.0]));
    assert_eq!(scene["nodes"]["ground of 1"]["at"], json!([5.0, 0.0, 0.0]));
    assert_eq!(scene["elements"]["Left.1"]["nodes"], json!(["Left.1", "ground of Left.1"]));
}
