//! Decks of different styles: each gives the scene that a JSON file by hand gives, bit for bit, and every mistake is named by its line.

use jointproof::scene::{Deck, Dimension, Kind, Scene};
use std::fs;

/// The scene of a deck with files that it includes.
fn scene_of(deck: &str, included: &[(&str, &str)]) -> Scene {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in included {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let deck = Deck::parse_in(folder.path(), deck.into()).unwrap_or_else(|faults| panic!("{faults}"));
    let scene = deck.scene().unwrap_or_else(|faults| panic!("{faults}\n{}", deck.text()));
    // The text says all of it.
    let again = Scene::parse(deck.text()).unwrap();
    assert_eq!(format!("{scene:?}"), format!("{again:?}"));
    scene
}

/// All outputs of these kinds but some.
pub fn outputs(kinds: &[(&str, Dimension)], without: &[&str]) -> String {
    let mut all: Vec<&str> = Vec::new();
    for (kind, dimension) in kinds {
        let kind = Kind::find(kind, *dimension).unwrap();
        all.extend(kind.outputs().map(|(output, _)| output));
    }
    let mut seen = std::collections::HashSet::new();
    all.retain(|output| !without.contains(output) && seen.insert(*output));
    format!("{all:?}")
}

/// A deck, its files, and the same scene by hand, with OUTPUTS for its outputs.
pub fn agree(deck: &str, included: &[(&str, &str)], by_hand: &str, outputs: &str) {
    let by_hand = by_hand.replace("OUTPUTS", outputs);
    let expected = Scene::parse(&by_hand).unwrap_or_else(|faults| panic!("{faults}\n{by_hand}"));
    assert_eq!(format!("{:#?}", scene_of(deck, included)), format!("{expected:#?}"));
}

pub const SPACE: Dimension = Dimension::Space;
const NO_STOPS: [&str; 2] = ["GAPMIN", "GAPMAX"];
/// What a stiffness in stick is needed for: with friction, and anyway.
const STICKING: [&str; 6] = ["KF", "CSF1", "P", "PHI", "SLIP1", "CASU1"];
/// What a slot without a behavior lacks.
pub const BARE: [&str; 5] = ["GAPMIN", "GAPMAX", "CSF1", "SLIP1", "CASU1"];

#[test]
fn lower_case_comments_in_odd_places_and_exponents_of_fortran() {
    agree(
        "\
** before anything
*heading
** between a keyword and its data
  A rail
*node, nset=all
1, 0., 0., 0.
** between data
 2 , 1.D0 , +2.0d+0, 30E-1,
   **** with blanks before it
*element, type=conn3d2, elset=guides
10, 1, 2
*orientation, name=along
1., 0., 0., 0., 1., 0.
*connector section, elset=guides, behavior=rubbing
slot,
along,
*connector behavior, name=rubbing
*connector friction, predefined, stick stiffness=1.d3
2.5
*friction
0.25,
*connector stop, component=1
-1., 3.
** after everything",
        &[],
        r#"{ "title": "A rail", "dimension": "3d", "orientations": { "along": { "axes": [[1, 0, 0], [0, 1, 0]] } },
        "nodes": { "1": { "at": [0, 0, 0], "orientation": "along" }, "2": { "at": [1, 2, 3] } },
        "elements": { "10": { "kind": "slot", "nodes": ["1", "2"], "fc_int": 2.5, "mu": 0.25, "k_stick": 1000,
            "l1_min": -1, "l1_max": 3 } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", SPACE)], &[]),
    );
}

#[test]
fn upper_case_tabs_and_carriage_returns_continued_lines_and_two_basic_types() {
    let deck = "\
*NODE
\t7,\t0.5,\t-0.25
\t9,\t1,\t0,\t2
*ELEMENT,
   TYPE = CONN3D2 ,
** in a continued keyword
 ELSET = T U B E
1,
7,
9
*ORIENTATION, NAME=A, DEFINITION=NODES
9, 7
*ORIENTATION, NAME=B
3.,1.,1., 1.,4.,1., 1.,1.,1.
*CONNECTOR SECTION, ELSET=TUBE, BEHAVIOR=B1
SLOT, ALIGN
B, B
*CONNECTOR BEHAVIOR, NAME=B1
*CONNECTOR FRICTION, PREDEFINED
0.5, , 20.
*FRICTION
0.1
*CONNECTOR CONSTITUTIVE REFERENCE
2.5
";
    agree(
        &deck.replace('\n', "\r\n"),
        &[],
        r#"{ "dimension": "3d", "orientations": { "B": { "axes": [[2, 0, 0], [0, 3, 0]] } },
        "nodes": { "7": { "at": [0.5, -0.25, 0], "orientation": "B" }, "9": { "at": [1, 0, 2], "orientation": "B" } },
        "elements": { "1": { "kind": "translator", "nodes": ["7", "9"], "rr": 0.5, "fc_int": 20, "mu": 0.1, "l1_ref": 2.5 } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("translator", SPACE)], &[&NO_STOPS[..], &STICKING].concat()),
    );
}

#[test]
fn names_in_quotes_sets_that_are_generated_and_angles_in_degrees() {
    agree(
        "\
*Node
11, 0, 0, 0
12, 0, 0, 0
13, 0, 0, 0
14, 0, 0, 0
*Element, type=CONN3D2
3, 11, 12
5, 13, 14
*Elset, elset=\"The pins, all\", generate
3, 5, 2
*Elset, elset=again
\"The pins, all\"
*Orientation, name=\"Pin 1\", system=Rectangular
0., 2., 0., 0., 0., 0.5
*Connector Section, elset=\"The pins, all\", behavior=\"B 1\"
Hinge,
\"Pin 1\",
*Connector Behavior, name=\"B 1\"
*Connector Friction, predefined, stick stiffness=50
0.01, , , 4
*Friction
0.3
*Connector Stop, component=4
-90, 60
*Connector constitutive reference
, , , 30.
",
        &[],
        r#"{ "dimension": "3d", "orientations": { "Pin 1": { "axes": [[0, 2, 0], [0, 0, 0.5]] } },
        "nodes": { "11": { "at": [0, 0, 0], "orientation": "Pin 1" }, "12": { "at": [0, 0, 0] },
            "13": { "at": [0, 0, 0], "orientation": "Pin 1" }, "14": { "at": [0, 0, 0] } },
        "elements": {
            "3": { "kind": "hinge", "nodes": ["11", "12"], "rp": 0.01, "mc_int": 4, "mu": 0.3, "k_stick": 50,
                "theta1_min": -1.5707963267948966, "theta1_max": 1.0471975511965979, "theta1_ref": 0.5235987755982989 },
            "5": { "kind": "hinge", "nodes": ["13", "14"], "rp": 0.01, "mc_int": 4, "mu": 0.3, "k_stick": 50,
                "theta1_min": -1.5707963267948966, "theta1_max": 1.0471975511965979, "theta1_ref": 0.5235987755982989 } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("hinge", SPACE)], &[]),
    );
}

#[test]
fn axes_from_the_third_axis_turned_by_an_angle_and_both_orientations() {
    agree(
        "\
*NODE, SYSTEM=C
1, 2., 30., 0.
2, 1., 90., 4.
*ELEMENT, TYPE=CONN3D2, ELSET=JOINTS
1, 1, 2
*ORIENTATION, NAME=IN, SYSTEM=Z RECTANGULAR
0., 0., 2., 3., 0., 1.
*ORIENTATION, NAME=OUT
2., 0., 0., 1., 1., 0.
1, 90.
*CONNECTOR SECTION, ELSET=JOINTS
UNIVERSAL, JOIN
IN, OUT
",
        &[],
        r#"{ "dimension": "3d", "orientations": { "IN": { "axes": [[1, 0, 0], [0, 1, 0]] }, "OUT": { "axes": [[1, 0, 0], [0, 0, 1]] } },
        "nodes": { "1": { "at": [1.7320508075688772, 1, 0], "orientation": "IN" }, "2": { "at": [0, 1, 4], "orientation": "OUT" } },
        "elements": { "1": { "kind": "ujoint", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(
            &[("ujoint", SPACE)],
            &[
                "GAP1MIN",
                "GAP1MAX",
                "GAP3MIN",
                "GAP3MAX",
                "ALPHATWIST",
                "BETATWIST",
                "ALPHAAXIAL",
                "BETAAXIAL",
                "MTWISTH",
                "FTWIST",
                "FHINGE1",
                "FHINGE3",
                "FTRANSV1",
                "FTRANSV3",
                "FTOTAL1",
                "FTOTAL3",
                "MBEND",
                "MTOTAL",
                "FTOTALBEND",
                "MC1",
                "MC3",
                "MN1",
                "MN3",
                "PHI1",
                "PHI3",
                "SLIPR1",
                "SLIPR3",
                "CASUR1",
                "CASUR3",
                "CSM1",
                "CSM3",
            ],
        ),
    );
}

#[test]
fn parts_instances_and_an_assembly() {
    agree(
        "\
*Heading
** Job name: door
*Part, name=Post
*Node
      1,           0.,           0.,           0.
      2,           1.,           0.,         0.5
*Nset, nset=ends
 2,
*Orientation, name=hinge-csys
 1., 0., 0., 0., 1., 0.
*End Part
*Part, name=Spare
*Node
1, 5., 5., 5.
*End Part
*Assembly, name=Assembly
*Instance, name=Post-1, part=Post
*End Instance
*Instance, name=\"Post 2\", part=Post
 0.,  3.,  0.
 0.,  3.,  0.,  0.,  3.,  1.,  90.
*End Instance
*Nset, nset=_pair, internal, instance=Post-1
 1, 2
*Element, type=CONN3D2
1, Post-1.2, \"Post 2\".2
2, POST-1.1, \"Post 2\".1
*Elset, elset=first
 1
*Elset, elset=second
 2
*Orientation, name=world
 0., 0., 1., 1., 0., 0.
*Connector Section, elset=first
Slot,
Post-1.hinge-csys,
*Connector Section, elset=second
Align,
world, world
*End Assembly
",
        &[],
        r#"{ "dimension": "3d",
        "orientations": { "Post-1.hinge-csys": { "axes": [[1, 0, 0], [0, 1, 0]] }, "world": { "axes": [[0, 0, 1], [1, 0, 0]] } },
        "nodes": { "Post-1.1": { "at": [0, 0, 0], "orientation": "world" },
            "Post-1.2": { "at": [1, 0, 0.5], "orientation": "Post-1.hinge-csys" },
            "Post 2.1": { "at": [0, 3, 0], "orientation": "world" }, "Post 2.2": { "at": [0, 4, 0.5] } },
        "elements": { "1": { "kind": "slot", "nodes": ["Post-1.2", "Post 2.2"] },
            "2": { "kind": "align", "nodes": ["Post-1.1", "Post 2.1"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", SPACE), ("align", SPACE)], &BARE),
    );
}

#[test]
fn connectors_in_parts_are_those_of_every_instance_with_axes_that_turn() {
    agree(
        "\
*Part, name=Slide
*Node, nset=n
1, 1., 0., 0.
2, 2., 0., 0.
*Element, type=CONN3D2, elset=s
1, 1, 2
*Orientation, name=o
1., 0., 0., 0., 1., 0.
*Connector Section, elset=s
Slot
o
*End Part
*Assembly, name=A
*Instance, name=a, part=Slide
*End Instance
*Instance, name=b, part=Slide
0., 0., 1.
0., 0., 0., 0., 0., 1., -90.
*End Instance
*End Assembly
",
        &[],
        r#"{ "dimension": "3d",
        "orientations": { "a.o": { "axes": [[1, 0, 0], [0, 1, 0]] }, "b.o": { "axes": [[0, -1, 0], [1, 0, 0]] } },
        "nodes": { "a.1": { "at": [1, 0, 0], "orientation": "a.o" }, "a.2": { "at": [2, 0, 0] },
            "b.1": { "at": [0, -1, 1], "orientation": "b.o" }, "b.2": { "at": [0, -2, 1] } },
        "elements": { "a.1": { "kind": "slot", "nodes": ["a.1", "a.2"] }, "b.1": { "kind": "slot", "nodes": ["b.1", "b.2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", SPACE)], &BARE),
    );
}

#[test]
fn included_files_between_keywords_and_between_data() {
    agree(
        "\
*NODE
1, 0, 0, 0
*INCLUDE, INPUT=more nodes.txt
3, 3, 0, 0
*INCLUDE,
INPUT = connectors.inp
*Connector Section, elset=all
Revolute
Axes
*Material, name=steel
*Elastic
210000., 0.3
",
        &[
            ("more nodes.txt", "** nodes\n2, 2, 0, 0\n"),
            ("connectors.inp", "*element, type=CONN3D2, elset=all\n8, 1, 2\n*include, input=orientation.inp\n"),
            ("orientation.inp", "*ORIENTATION, NAME=AXES\n0,0,1, 1,0,0\n*ELEMENT, TYPE=CONN3D2, ELSET=ALL\n9, 2, 3"),
        ],
        r#"{ "dimension": "3d", "orientations": { "AXES": { "axes": [[0, 0, 1], [1, 0, 0]] } },
        "nodes": { "1": { "at": [0, 0, 0], "orientation": "AXES" }, "2": { "at": [2, 0, 0], "orientation": "AXES" },
            "3": { "at": [3, 0, 0] } },
        "elements": { "8": { "kind": "revolute", "nodes": ["1", "2"] }, "9": { "kind": "revolute", "nodes": ["2", "3"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("revolute", SPACE)], &[]),
    );
}

#[test]
fn a_slot_in_the_plane() {
    agree(
        "\
*NODE
1, 0., 0.
2, 1., 2.
*ELEMENT, TYPE=CONN2D2, ELSET=E
1, 1, 2
*ELEMENT, TYPE=CPS4R, ELSET=PLATE
100, 1, 2, 3, 4
*ORIENTATION, NAME=UP
0., 1., 0., -1., 0., 0.
*CONNECTOR SECTION, ELSET=E
SLOT
UP
",
        &[],
        r#"{ "dimension": "2d", "orientations": { "UP": { "angle": 1.5707963267948966 } },
        "nodes": { "1": { "at": [0, 0], "orientation": "UP" }, "2": { "at": [1, 2] } },
        "elements": { "1": { "kind": "slot", "nodes": ["1", "2"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slot", Dimension::Plane)], &BARE),
    );
}

#[test]
fn slide_lines_of_an_axisymmetric_model() {
    agree(
        "\
*HEADING
THREAD
*NODE, NSET=BOX
2, 49.375, -10.
4, 50.125, 2.
6, 50.875, 14.
*NODE
21, 50.2, 4.
22, 50.825, 13.
*ELEMENT, TYPE=ISL21A, ELSET=PIN
1, 21, 22
*SLIDE LINE, ELSET=PIN, TYPE=LINEAR, GENERATE, SMOOTH=0.2
2, 6, 2
*INTERFACE, ELSET=PIN
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
2.E3
*STEP
*STATIC
*TORQUE PRINT, FREQUENCY=2
*END STEP
",
        &[],
        r#"{ "title": "THREAD", "dimension": "axisymmetric",
        "nodes": { "2": { "at": [49.375, -10] }, "4": { "at": [50.125, 2] }, "6": { "at": [50.875, 14] },
            "21": { "at": [50.2, 4] }, "22": { "at": [50.825, 13] } },
        "slide_lines": { "PIN": { "type": "linear", "nodes": ["2", "4", "6"], "smooth": 0.2, "pressure": { "k": 2000 },
            "torque_frequency": 2 } },
        "elements": { "1": { "kind": "isl21a", "nodes": ["21", "22"], "slide_line": "PIN" } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("isl21a", Dimension::Axisymmetric)], &[]),
    );
}

#[test]
fn parabolic_slide_lines_over_several_data_lines() {
    agree(
        "\
*node
1,0,0
2,0,1
3,0,2
4,0,3
5,0,4
11,1,.5
12,1,1.5
13,1,2.5
*element,type=ISL22A
1,11,12,
13
*elset,elset=seal
1
*slide line,elset=seal,type=parabolic
1,2,3,
4,5
*interface,elset=seal
*surface behavior,pressure-overclosure=exponential
0.01,5
",
        &[],
        r#"{ "dimension": "axisymmetric",
        "nodes": { "1": { "at": [0, 0] }, "2": { "at": [0, 1] }, "3": { "at": [0, 2] }, "4": { "at": [0, 3] },
            "5": { "at": [0, 4] }, "11": { "at": [1, 0.5] }, "12": { "at": [1, 1.5] }, "13": { "at": [1, 2.5] } },
        "slide_lines": { "seal": { "type": "parabolic", "nodes": ["1", "2", "3", "4", "5"], "pressure": { "c0": 0.01, "p0": 5 } } },
        "elements": { "1": { "kind": "isl22a", "nodes": ["11", "12", "13"], "slide_line": "seal" } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("isl22a", Dimension::Axisymmetric)], &[]),
    );
}

#[test]
fn constraints_of_sets_between_other_keywords() {
    agree(
        "\
*NODE
1, 0., 0., -.5
5, 0., 0., .5
*NODE, NSET=MID
2, 0., 0., -.25
3, 0., 0., 0.
4, 0., 0., .25
*ELEMENT, TYPE=S4
1, 1, 2, 3, 4
*MPC
SLIDER, MID, 1, 5
BEAM, 1, 5
*BOUNDARY
1, 1, 3
",
        &[],
        r#"{ "dimension": "3d",
        "nodes": { "1": { "at": [0, 0, -0.5] }, "5": { "at": [0, 0, 0.5] }, "2": { "at": [0, 0, -0.25] },
            "3": { "at": [0, 0, 0] }, "4": { "at": [0, 0, 0.25] } },
        "elements": { "slider 2": { "kind": "slider", "nodes": ["1", "5", "2"] },
            "slider 3": { "kind": "slider", "nodes": ["1", "5", "3"] }, "slider 4": { "kind": "slider", "nodes": ["1", "5", "4"] } },
        "outputs": OUTPUTS }"#,
        &outputs(&[("slider", SPACE)], &[]),
    );
}
