//! Orientations and rotations of the nodes of a scene: every description of a triad, and whose triad an element reads among
//! thousands.

use jointproof::scene::{Results, Scene};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The position of b in the triad of a, with the orientation of a as described and rotated by a rotation vector.
fn seen(orientation: &str, turned: &str) -> [f64; 3] {
    let scene = scene(&format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{{orientation}}}}},
        "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [1, 2, 3]}}}},
        "elements": {{"e": {{"kind": "slot", "nodes": ["a", "b"]}}}},
        "frames": [{{"time": 0, "nodes": {{"a": {{"ur": {turned}}}}}}}], "outputs": ["X", "Y", "Z"]}}"#
    ));
    let results = Results::of(&scene).unwrap();
    ["X", "Y", "Z"].map(|output| results.get("e", output, 0).unwrap()[0])
}

fn assert_close(found: [f64; 3], expected: [f64; 3], what: &str) {
    let far = found.iter().zip(expected).any(|(found, expected)| (found - expected).abs() > 4e-15);
    assert!(!far, "{what}: {found:?}, expected {expected:?}");
}

/// A quarter turn to the left about z maps e1 to y and e2 to −x.
#[test]
fn every_description_turns_the_same_way() {
    let left = [2.0, -1.0, 3.0];
    let quarter = format!("[0, 0, {FRAC_PI_2}]");
    assert_close(seen(r#""rotation": [0, 0, 0]"#, "[0, 0, 0]"), [1.0, 2.0, 3.0], "no rotation");
    assert_close(seen(&format!(r#""rotation": {quarter}"#), "[0, 0, 0]"), left, "rotation");
    assert_close(seen(r#""quaternion": [1, 0, 0, 1]"#, "[0, 0, 0]"), left, "quaternion");
    assert_close(seen(r#""quaternion": [-300, 0, 0, -300]"#, "[0, 0, 0]"), left, "its opposite, not of length 1");
    assert_close(seen(r#""axes": [[0, 9, 0], [-2, 5, 0]]"#, "[0, 0, 0]"), left, "axes, neither of length 1 nor square");
    assert_close(seen(r#""rotation": [0, 0, 0]"#, &quarter), left, "a turn in a frame");
    assert_close(
        seen(r#""quaternion": [1, 1, 1, 1]"#, "[0, 0, 0]"),
        [2.0, 3.0, 1.0],
        "a third of a turn about (1, 1, 1)",
    );
    // The rotation of a frame follows the orientation, about the global axes.
    assert_close(seen(r#""quaternion": [1, 1, 0, 0]"#, &quarter), [2.0, 3.0, 1.0], "x to x, y to z, then x to y");
}

#[test]
fn a_rotation_of_any_size_keeps_lengths() {
    for angle in [1e-9_f64, 1e-3, 0.5, 3.0, 3.2, 6.0, 100.0] {
        let [x, y, z] = seen(&format!(r#""rotation": [{angle}, 0, 0]"#), "[0, 0, 0]");
        let expected = [1.0, 2.0 * angle.cos() + 3.0 * angle.sin(), 3.0 * angle.cos() - 2.0 * angle.sin()];
        assert_close([x, y, z], expected, &angle.to_string());
    }
}

#[test]
fn what_tells_no_triad_is_refused() {
    let refused = |orientation: &str| {
        let text = format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{{orientation}}}}}, "nodes": {{}}, "elements": {{}}}}"#
        );
        Scene::parse(&text).err().map(|faults| faults.to_string()).unwrap_or_default()
    };
    assert!(refused(r#""quaternion": [0, 0, 0, 0]"#).contains("the quaternion 0"));
    assert!(!refused(r#""quaternion": [0, 0, 0, 1e-300]"#).contains("quaternion"));
    assert!(refused(r#""axes": [[1, 0, 0], [3, 0, 0]]"#).contains("parallel"));
    assert!(refused(r#""axes": [[1, 0, 0], [-3, 0, 0.0000029]]"#).contains("parallel"), "an angle below 1e-6");
    assert!(!refused(r#""axes": [[1, 0, 0], [-3, 0, 0.0000031]]"#).contains("parallel"), "an angle above 1e-6");
    assert!(refused(r#""axes": [[1, 0, 0]]"#).contains("1 vectors"));
    assert!(refused(r#""rotation": [0, 0, 0], "quaternion": [1, 0, 0, 0]"#).contains("2 descriptions"));
    assert!(refused("").contains("0 descriptions"));
    for once in
        [r#""axes": 5"#, r#""axes": [[1, 0, 0], true]"#, r#""axes": []"#, r#""quaternion": [1, 0]"#, r#""rotation": 0"#]
    {
        assert_eq!(refused(once).lines().count(), 1, "{once}: {}", refused(once));
    }
}

/// Elements of a group share registers in blocks, and blocks are distributed over tasks: each element must have the triads and
/// loads of its own nodes, not those of a previous block or task. Some loads change and triads recur; in the first half some
/// nodes rotate, so that they have triads of their own.
#[test]
fn each_of_thousands_of_elements_is_as_if_it_were_alone() {
    const COUNT: usize = 5300;
    let orientation = |k: usize| ["o1", "o2", "o1", "o3"][k / 64 % 4];
    let node = |k: usize| {
        let (a, b) = (format!(r#""a{k}": {{"at": [0, {k}, 0], "orientation": "{}"}}"#, orientation(k)), k % 7);
        format!(r#"{a}, "b{k}": {{"at": [1, {k}.5, {b}]}}"#)
    };
    let element = |k: usize| format!(r#""e{k}": {{"kind": "slot", "nodes": ["a{k}", "b{k}"]}}"#);
    let moved = |k: usize| match k % 5 {
        0 if k < COUNT / 2 => Some(format!(r#""a{k}": {{"ur": [0.1, 0, 0.{k}]}}, "b{k}": {{"u": [0, 0, 0.{k}]}}"#)),
        1 => Some(format!(r#""b{k}": {{"u": [0.{k}, 0, 0]}}"#)),
        _ => None,
    };
    let loaded = |k: usize| (k % 3 == 1 || (k / 64).is_multiple_of(2)).then(|| format!(r#""e{k}": {{"f2": {k}}}"#));
    let of = |these: &[usize]| {
        let list =
            |of: &dyn Fn(usize) -> Option<String>| these.iter().filter_map(|&k| of(k)).collect::<Vec<_>>().join(", ");
        let mut text = String::from(
            r#"{"dimension": "3d", "orientations": {"o1": {"rotation": [0, 0, 0]}, "o2": {"rotation": [0, 0, 1]},
            "o3": {"quaternion": [1, 2, 3, 4]}}, "#,
        );
        let (nodes, elements) = (list(&|k| Some(node(k))), list(&|k| Some(element(k))));
        let _ = write!(text, r#""nodes": {{{nodes}}}, "elements": {{{elements}}}, "#);
        let (nodes, loads) = (list(&moved), list(&loaded));
        let _ =
            write!(text, r#""frames": [{{"time": 0}}, {{"time": 1, "nodes": {{{nodes}}}, "loads": {{{loads}}}}}], "#);
        scene(&(text + r#""outputs": ["X", "Y", "U1", "RF"]}"#))
    };
    let all: Vec<usize> = (0..COUNT).collect();
    let results =
        rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap().install(|| Results::of(&of(&all)).unwrap());
    for k in (0..COUNT).step_by(61).chain([63, 64, 127, 128, 4095, 4096, COUNT - 1]) {
        let alone = Results::of(&of(&[k])).unwrap();
        for output in ["X", "Y", "U1", "RF"] {
            for state in 0..2 {
                let name = format!("e{k}");
                assert_eq!(
                    results.get(&name, output, state),
                    alone.get(&name, output, state),
                    "{name} {output} {state}"
                );
            }
        }
    }
}

#[test]
fn in_the_plane_an_angle_turns_to_the_left() {
    let scene = scene(
        r#"{"dimension": "2d", "orientations": {"o": {"angle": 0}},
        "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": [1, 2]}},
        "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["X", "Y"],
        "frames": [{"time": 0}, {"time": 1, "nodes": {"a": {"ur": 1.5707963267948966}}}]}"#,
    );
    let results = Results::of(&scene).unwrap();
    let at = |state| ["X", "Y"].map(|output| results.get("e", output, state).unwrap()[0]);
    assert_eq!(at(0), [1.0, 2.0]);
    let [x, y] = at(1);
    assert_close([x, y, 0.0], [2.0, -1.0, 0.0], "a quarter of a turn");
}

/// More nodes than one thread takes, some of which move and rotate again in later frames.
#[test]
fn some_of_thousands_of_nodes_move_and_turn_on() {
    const COUNT: usize = 4200;
    const EXAMINED: [usize; 8] = [0, 1, 2, 4095, 4096, 4097, 4198, 4199];
    let list = |of: &dyn Fn(usize) -> String| (0..COUNT).map(of).collect::<Vec<_>>().join(", ");
    let nodes = list(&|k| format!(r#""n{k}": {{"at": [0, {k}, 0]}}"#));
    let element = |k| {
        format!(
            r#""s{k}": {{"kind": "slot", "nodes": ["a", "n{k}"]}}, "t{k}": {{"kind": "align", "nodes": ["a", "n{k}"]}}"#
        )
    };
    let elements = EXAMINED.map(element).join(", ");
    let motion = |k: usize, u: f64, ur: f64| format!(r#""n{k}": {{"u": [{u:?}, 0, 0], "ur": [0, 0, {ur:?}]}}"#);
    let first = |k: usize| f64::from(u32::try_from(k).unwrap()) / 8192.0;
    let again = [(1, 1), (1, 4096), (1, 4199), (2, 4097)];
    let frame = |state| {
        let motions = again.iter().filter(|&&(of, _)| of == state).map(|&(_, k)| motion(k, 7.0, -0.25));
        motions.collect::<Vec<_>>().join(", ")
    };
    let scene = scene(&format!(
        r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}}, "outputs": ["X", "GAMMA"],
        "nodes": {{{nodes}, "a": {{"at": [0, 0, 0], "orientation": "o"}}}}, "elements": {{{elements}}},
        "frames": [{{"time": 0, "nodes": {{{}}}}}, {{"time": 1, "nodes": {{{}}}}}, {{"time": 2, "nodes": {{{}}}}}]}}"#,
        list(&|k| motion(k, first(k), first(k))),
        frame(1),
        frame(2)
    ));
    let results =
        rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap().install(|| Results::of(&scene).unwrap());
    for (k, state) in EXAMINED.into_iter().flat_map(|k| [0, 1, 2].map(|state| (k, state))) {
        let moved = again.iter().any(|&(since, node)| node == k && since <= state);
        let (u, ur) = if moved { (7.0, -0.25) } else { (first(k), first(k)) };
        let of = |element: char, output| results.get(&format!("{element}{k}"), output, state).unwrap()[0];
        assert_eq!(of('s', "X"), u, "{k} {state}");
        assert!((of('t', "GAMMA") - ur).abs() < 1e-15, "{k} {state}: {}", of('t', "GAMMA"));
    }
}

/// A rotation about the diagonal by √3, which is not zero.
#[test]
fn equal_parts_of_a_rotation_vector_turn_too() {
    let (at_once, later) =
        (seen(r#""rotation": [1, 1, 1]"#, "[0, 0, 0]"), seen(r#""rotation": [0, 0, 0]"#, "[1, 1, 1]"));
    assert_close(at_once, later, "from the start or after it");
    // b is (−1, 0, 1) from the diagonal, and relative to a it rotates towards (−1, 2, −1)/√3.
    let (sine, cosine) = 3_f64.sqrt().sin_cos();
    let across = [-1.0, 2.0, -1.0].map(|part| part * sine / 3_f64.sqrt());
    assert_close(at_once, [2.0 - cosine + across[0], 2.0 + across[1], 2.0 + cosine + across[2]], "about the diagonal");
}
