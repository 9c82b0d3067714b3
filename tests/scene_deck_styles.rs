//! Decks in styles that the reader was not written beside, each with the scene that a JSON file by hand gives.

use crate::scene_decks::{BARE, SPACE, agree, outputs};
use jointproof::scene::{Deck, Dimension, Results, Scene, Table, Tables};
use std::path::Path;

const PLANE: Dimension = Dimension::Plane;
const AXISYMMETRIC: Dimension = Dimension::Axisymmetric;

#[test]
fn blanks_in_keywords_blank_fields_and_no_end_of_the_last_line() {
    agree(
        "\
*HEADING
**
* N o d e , n s e t = a l l
1,,-.5d0,
  2,1.D+00,,1E0
\t
** a comment with a comma at its end,
*ele ment, Type = Conn3d2 ,ELSET = The Rods
17,1,
** between the nodes of an element
2
*  ORIENTATION,name = o 1,
** and within a keyword line
  definition = coordinates
0,,1D0,1.
*connector Section,
elset=THERODS
align,slot
O1",
        &[],
        r#"{ "dimension": "3d", "orientations": { "o1": { "axes": [[0, 0, 1], [1, 0, 0]] } },
        "nodes": { "1": { "at": [0, -0.5, 0], "orientation": "o1" }, "2": { "at": [1, 0, 1] } },
        "elements": { "17": { "kind": "translator", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("translator", SPACE)], &BARE),
    );
}

#[test]
fn instances_in_quotes_moved_and_turned_with_sets_of_the_assembly() {
    agree(
        "\
*Part, name=\"Link, long\"
*Node, nset=Ends
1, 2.5e-1, 0., 0.
7, 1., 0., 0.
*Orientation, name=\"Pin csys\"
0., 0., 1., 1., 0., 0.
*End Part
*Assembly, name=A
*Instance, name=\"Link 1\", part=\"Link, long\"
*End Instance
*Instance, name=\"Link 2\", part=\"Link, long\"
0., 0., 2.D0
0., 0., 0., 1., 0., 0., 180.
*End Instance
*Nset, nset=Tips, instance=\"Link 2\"
Ends,
*Element, type=CONN3D2
3, \"Link 1\".7, \"Link 2\".7
*Elset, elset=\"Wire, all\", internal
3
*Connector Section, elset=\"Wire, all\"
Revolute,
\"Link 1\".\"Pin csys\", \"Link 2\".\"Pin csys\"
*End Assembly
*MPC
SLIDER, Tips, \"Link 1\".1, \"Link 1\".7
",
        &[],
        r#"{ "dimension": "3d",
        "orientations": { "Link 1.Pin csys": { "axes": [[0, 0, 1], [1, 0, 0]] }, "Link 2.Pin csys": { "axes": [[0, 0, -1], [1, 0, 0]] } },
        "nodes": { "Link 1.1": { "at": [0.25, 0, 0] }, "Link 1.7": { "at": [1, 0, 0], "orientation": "Link 1.Pin csys" },
            "Link 2.1": { "at": [0.25, 0, -2] }, "Link 2.7": { "at": [1, 0, -2], "orientation": "Link 2.Pin csys" } },
        "elements": { "3": { "kind": "revolute", "nodes": ["Link 1.7", "Link 2.7"] },
            "slider Link 2.1": { "kind": "slider", "nodes": ["Link 1.1", "Link 1.7", "Link 2.1"] },
            "slider Link 2.7": { "kind": "slider", "nodes": ["Link 1.1", "Link 1.7", "Link 2.7"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("revolute", SPACE), ("slider", SPACE)], &[]),
    );
}

#[test]
fn a_plane_with_axes_turned_by_the_second_line() {
    agree(
        "\
*node\r
1,0,0\r
2,3,4\r
*element,type=conn2d2,elset=e\r
1,1,2\r
*orientation,name=\"Rail\"\r
1,0,0,0,1,0\r
3,90\r
*connector section,elset=e\r
SLOT\r
\"Rail\"\r
",
        &[],
        r#"{ "dimension": "2d", "orientations": { "Rail": { "angle": 1.5707963267948966 } },
        "nodes": { "1": { "at": [0, 0], "orientation": "Rail" }, "2": { "at": [3, 4] } },
        "elements": { "1": { "kind": "slot", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", PLANE)], &BARE),
    );
}

#[test]
fn nodes_and_elements_in_files_of_their_own() {
    agree(
        "\
*NODE, INPUT=nodes.dat, NSET=LINE
21, 1., .5
*ELEMENT, TYPE=ISL22A, ELSET=LIP, INPUT = \"elements.dat\"
*NODE
22, 1., 1.
23, 1., 1.5
*NSET, NSET=LINE
21,
*SLIDE LINE, ELSET=LIP, TYPE=PARABOLIC, GENERATE, EXTENSION ZONE=.05
1, 5
10, 11, 1
*INTERFACE, ELSET=LIP
",
        &[
            ("nodes.dat", "1,0,0\n2,0,1\n3,0,2\n4,0,3\n5,0,4\n** the upper part\n10,0,5\n11,0,6\n12,0,7\n"),
            ("elements.dat", "8, 21, 22, 23\r\n"),
        ],
        r#"{ "dimension": "axisymmetric",
        "nodes": { "1": { "at": [0, 0] }, "2": { "at": [0, 1] }, "3": { "at": [0, 2] }, "4": { "at": [0, 3] }, "5": { "at": [0, 4] },
            "10": { "at": [0, 5] }, "11": { "at": [0, 6] },
            "21": { "at": [1, 0.5] }, "22": { "at": [1, 1] }, "23": { "at": [1, 1.5] } },
        "slide_lines": { "LIP": { "type": "parabolic", "nodes": ["1", "2", "3", "4", "5", "10", "11"], "extension_zone": 0.05 } },
        "elements": { "8": { "kind": "isl22a", "nodes": ["21", "22", "23"], "slide_line": "LIP" } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("isl22a", AXISYMMETRIC)], &[]),
    );
}

#[test]
fn cylindrical_axes_are_those_at_each_node() {
    agree(
        "\
*NODE
1, 2., 0., 0.
2, 2.5, 0., 0.
3, 0., 3., 1.
4, 0., 4., 1.
*ELEMENT, TYPE=CONN3D2, ELSET=SPOKES
1, 1, 2
2, 3, 4
*ORIENTATION, SYSTEM=CYLINDRICAL, NAME=RING
0., 0., 0., 0., 0., 8.
*ORIENTATION, SYSTEM=CYLINDRICAL, NAME=UNUSED, DEFINITION=OFFSET TO NODES
1, 2
*ORIENTATION, NAME=PLIES
THICKNESS OF PLIES
3, 0.
*CONNECTOR SECTION, ELSET=SPOKES
SLOT
RING
",
        &[],
        r#"{ "dimension": "3d",
        "orientations": { "RING at 1": { "axes": [[2, 0, 0], [0, 2, 0]] }, "RING at 3": { "axes": [[0, 3, 0], [-3, 0, 0]] } },
        "nodes": { "1": { "at": [2, 0, 0], "orientation": "RING at 1" }, "2": { "at": [2.5, 0, 0] },
            "3": { "at": [0, 3, 1], "orientation": "RING at 3" }, "4": { "at": [0, 4, 1] } },
        "elements": { "1": { "kind": "slot", "nodes": ["1", "2"] }, "2": { "kind": "slot", "nodes": ["3", "4"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", SPACE)], &BARE),
    );
}

#[test]
fn spherical_axes_of_nodes_and_those_of_a_where_b_has_none() {
    agree(
        "\
*NODE
1, 1., 0., 0.
2, 0., 1., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=BALL
1, 1, 2
*ORIENTATION, SYSTEM=SPHERICAL, NAME=GLOBE, DEFINITION=NODES
8, 9
*NODE
8, 0., 0., 0.
9, 0., 0., 1.
*CONNECTOR SECTION, ELSET=BALL
REVOLUTE
GLOBE
",
        &[],
        r#"{ "dimension": "3d", "orientations": { "GLOBE at 1": { "axes": [[1, 0, 0], [0, 1, 0]] } },
        "nodes": { "1": { "at": [1, 0, 0], "orientation": "GLOBE at 1" }, "2": { "at": [0, 1, 0] } },
        "elements": { "1": { "kind": "revolute", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("revolute", SPACE)], &[]),
    );
}

#[test]
fn requested_outputs_are_those_of_the_scene() {
    let deck = "\
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 0., 1., 0.
4, 1., 1., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=LOW
1, 1, 2
*ELEMENT, TYPE=CONN3D2, ELSET=HIGH
2, 3, 4
*ELSET, ELSET=MESH, GENERATE
1001, 4000000001
*ELSET, ELSET=BOTH
LOW, HIGH
*ORIENTATION, NAME=O
1., 0., 0., 0., 1., 0.
*CONNECTOR SECTION, ELSET=BOTH, BEHAVIOR=B
SLOT
O
*CONNECTOR BEHAVIOR, NAME=B
*CONNECTOR FRICTION, PREDEFINED, STICK STIFFNESS=10.
*FRICTION
0.1
*STEP
*STATIC
*OUTPUT, HISTORY
*ELEMENT OUTPUT, ELSET=LOW
CU, CTF,
CSF1
*ELEMENT OUTPUT, ELSET=MESH
S, PEEQ
*EL PRINT, ELSET=HIGH, FREQUENCY=10
CU1, PEEQ
*OUTPUT, FIELD, VARIABLE=PRESELECT
*END STEP
";
    agree(
        deck,
        &[],
        r#"{ "dimension": "3d", "orientations": { "O": { "axes": [[1, 0, 0], [0, 1, 0]] } },
        "nodes": { "1": { "at": [0, 0, 0], "orientation": "O" }, "2": { "at": [1, 0, 0] },
            "3": { "at": [0, 1, 0], "orientation": "O" }, "4": { "at": [1, 1, 0] } },
        "elements": { "1": { "kind": "slot", "nodes": ["1", "2"], "mu": 0.1, "k_stick": 10, "outputs": ["U1", "CSF1"] },
            "2": { "kind": "slot", "nodes": ["3", "4"], "mu": 0.1, "k_stick": 10 } },
        "outputs": ["U1"] }"#,
        "",
    );
    let left_out = |deck: &str| {
        let deck = Deck::parse(deck).unwrap();
        let shown = |matters| if matters { "! " } else { "" };
        deck.left_out().iter().map(|left_out| format!("{}{left_out}", shown(left_out.matters))).collect::<Vec<_>>()
    };
    assert_eq!(
        left_out(deck)[2..],
        [
            "*OUTPUT (line 25): in a step",
            "! *ELEMENT OUTPUT (line 27): the output CTF; similar is KF, of load and friction alone and in the global axes",
            "*ELEMENT OUTPUT (line 29): outputs of elements that the scene does not have",
            "*EL PRINT (line 32): the output PEEQ",
            "*OUTPUT (line 33): in a step",
        ]
    );
    // All outputs: asked for, or because nothing that is asked for exists here.
    let all = ["*ELEMENT OUTPUT, VARIABLE=ALL\n", "*ELEMENT OUTPUT\nCTF, CRF\n", "*EL PRINT\nS, E\n"].map(|request| {
        let (before, rest) = deck.split_once("*ELEMENT OUTPUT").unwrap();
        let (_, after) = rest.split_once("*OUTPUT, FIELD").unwrap();
        let scene = Deck::parse(&format!("{before}{request}*OUTPUT, FIELD{after}")).unwrap().scene().unwrap();
        Results::of(&scene).unwrap().series
    });
    assert!(all[0] == all[1] && all[0] == all[2]);
    assert!(all[0].len() > 20, "{}", all[0].len());
}

#[test]
fn sets_of_sets_and_ranges_for_the_ends_of_sliders() {
    agree(
        "\
*NODE, NSET=\"The ends\"
1, 0., 0., 0.
2, 0., 0., 4.
*NODE
11, 0., 0., 1.
13, 0., 0., 2.
15, 0., 0., 3.
*NSET, NSET=MIDDLE, GENERATE, UNSORTED
11, 15, 2
*NSET, NSET=FIRST
1
*NSET, NSET=\"First again\"
FIRST,
*NSET, NSET=SOME
MIDDLE, 13
*MPC, MODE=DOF
slider, SOME, \"First again\", 2
",
        &[],
        r#"{ "dimension": "3d",
        "nodes": { "1": { "at": [0, 0, 0] }, "2": { "at": [0, 0, 4] }, "11": { "at": [0, 0, 1] }, "13": { "at": [0, 0, 2] },
            "15": { "at": [0, 0, 3] } },
        "elements": { "slider 11": { "kind": "slider", "nodes": ["1", "2", "11"] },
            "slider 13": { "kind": "slider", "nodes": ["1", "2", "13"] }, "slider 15": { "kind": "slider", "nodes": ["1", "2", "15"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slider", SPACE)], &[]),
    );
}

#[test]
fn join_and_align_need_no_axes_and_have_the_global_ones() {
    agree(
        "\
*Node
1, 0, 0, 0
2, 0, 0, 0
*Element, type=CONN3D2, elset=Weld
1, 1, 2
*Connector Section, elset=Weld
Join, Align
",
        &[],
        r#"{ "dimension": "3d", "orientations": { "global axes": { "axes": [[1, 0, 0], [0, 1, 0]] } },
        "nodes": { "1": { "at": [0, 0, 0], "orientation": "global axes" }, "2": { "at": [0, 0, 0] } },
        "elements": { "1 join": { "kind": "join", "nodes": ["1", "2"] }, "1 align": { "kind": "align", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("join", SPACE), ("align", SPACE)], &[]),
    );
}

#[test]
fn several_frictions_of_one_behavior_and_the_predefined_one_counts() {
    agree(
        "\
*NODE
1, 0., 0., 0.
2, 0., 0., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=E
1, 1, 2
*ORIENTATION, NAME=O
1., 0., 0., 0., 1., 0.
*CONNECTOR BEHAVIOR, NAME=B
*CONNECTOR FRICTION, COMPONENT=4, CONTACT FORCE=1, STICK STIFFNESS=7.
*FRICTION
0.5
*CONNECTOR FRICTION, PREDEFINED, STICK STIFFNESS=20.
0.25
*FRICTION
0.125
*CONNECTOR FRICTION, COMPONENT=4, CONTACT FORCE=2
*FRICTION
0.75
*CONNECTOR STOP, COMPONENT=4
-90., 90.
*CONNECTOR SECTION, ELSET=E, BEHAVIOR=B
HINGE
O
",
        &[],
        r#"{ "dimension": "3d", "orientations": { "O": { "axes": [[1, 0, 0], [0, 1, 0]] } },
        "nodes": { "1": { "at": [0, 0, 0], "orientation": "O" }, "2": { "at": [0, 0, 0] } },
        "elements": { "1": { "kind": "hinge", "nodes": ["1", "2"], "rp": 0.25, "mu": 0.125, "k_stick": 20, "theta1_min": -1.5707963267948966, "theta1_max": 1.5707963267948966 } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("hinge", SPACE)], &[]),
    );
}

/// The decks and tables of the chapters, and their scenes in JSON: every number has the same bits.
#[test]
fn worked_decks_with_histories_give_the_bits_of_their_scenes() {
    type Names = &'static [(&'static str, &'static str)];
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let names: [(&str, bool, Names); 3] = [
        ("telescope", true, &[("telescope", "1")]),
        ("drive-shaft", true, &[("bearing in", "1"), ("bearing out", "2"), ("first", "3"), ("second", "4")]),
        (
            "thread",
            false,
            &[
                ("box", "flank"),
                ("thread 1", "1"),
                ("thread 2", "2"),
                ("thread 3", "3"),
                ("thread 4", "4"),
                ("pin 1", "11"),
                ("pin 2", "12"),
                ("pin 3", "13"),
                ("pin 4", "14"),
                ("pin 5", "15"),
            ],
        ),
    ];
    for (name, has_loads, names) in names {
        let scene = std::fs::read_to_string(golden.join(format!("scenes/{name}.json"))).unwrap();
        let expected = Results::of(&Scene::parse(&scene).unwrap()).unwrap();
        let decks = golden.join("decks");
        let deck = Deck::parse_in(&decks, std::fs::read(decks.join(format!("{name}.inp"))).unwrap()).unwrap();
        let table = |end: &str| Table::file(&decks.join(format!("{name}{end}.csv")));
        let tables = Tables { nodes: Some(table("")), loads: has_loads.then(|| table("-loads")), pressures: None };
        let results = Results::of(&deck.scene().unwrap().with_tables(tables).unwrap()).unwrap();
        assert_eq!(results.times, expected.times, "{name}");
        for series in &expected.series {
            let of = names.iter().find(|(theirs, _)| *theirs == series.element).unwrap().1;
            let is_same = |other: &&jointproof::scene::Series| other.element == of && other.output == series.output;
            let found = results.series.iter().find(is_same).unwrap_or_else(|| panic!("{name} {of} {}", series.output));
            let bits = |series: &jointproof::scene::Series| {
                series.values.numbers().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
            };
            // A deck has no stick stiffness of slide lines, so no friction of them.
            let is_friction = name == "thread" && series.output == "S12";
            assert_eq!(bits(found) == bits(series), !is_friction, "{name} {of} {}", series.output);
        }
    }
}
