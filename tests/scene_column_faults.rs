//! Faults in the arrays of a scene: all of them are reported, with their locations, and nothing panics.

use crate::columns::{Array, FILE, array, column_bits, file, parse};
use jointproof::scene::npz::Writer;
use jointproof::scene::{Columns, Plan, Results, Run, Scene, Stopped};
use rawzip::{CompressionMethod, ZipArchiveWriter};
use serde_json::{Value, json};
use std::io::Write;

/// A scene with every kind of array, and the arrays.
fn sound() -> (Value, Vec<Array>) {
    let scene = json!({
        "dimension": "3d", "columns": FILE, "orientations": { "o": { "rotation": [0, 0, 0] } },
        "nodes": { "a": { "at": [0, 0, 0], "orientation": "o" }, "b": { "at": "b" } },
        "elements": { "e": { "kind": "slot", "nodes": ["a", "b"], "mu": "mu", "k_stick": 1 } },
        "frames": { "time": "time", "nodes": { "b": { "u": "u" } }, "loads": { "e": { "f2": "f" } } },
        "outputs": ["U1", "CSF1"],
    });
    let arrays = vec![
        array("b", &[2, 3], &[1.0; 6]),
        array("mu", &[2], &[0.25, 0.5]),
        array("time", &[3], &[0.0, 1.0, 2.0]),
        array("u", &[3, 2, 3], &[0.5; 18]),
        array("f", &[3, 2], &[2.0; 6]),
    ];
    (scene, arrays)
}

/// A file of one array, whose header, numbers and compression are as given.
fn made(header: &str, numbers: &[u8], method: CompressionMethod) -> Vec<u8> {
    let text = format!("{header}\n");
    let len = u16::try_from(text.len()).unwrap().to_le_bytes();
    let array = [b"\x93NUMPY\x01\x00", &len[..], text.as_bytes(), numbers].concat();
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    let (mut entry, config) = archive.new_file("time.npy").compression_method(method).start().unwrap();
    if method == CompressionMethod::DEFLATE {
        let mut writer = config.wrap(flate2::write::DeflateEncoder::new(&mut entry, flate2::Compression::default()));
        writer.write_all(&array).unwrap();
        let (encoder, descriptor) = writer.finish().unwrap();
        encoder.finish().unwrap();
        entry.finish(descriptor).unwrap();
    } else {
        let mut writer = config.wrap(&mut entry);
        writer.write_all(&array).unwrap();
        let (_, descriptor) = writer.finish().unwrap();
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

#[test]
fn every_mistake_in_an_array_is_said_with_its_place() {
    let (scene, arrays) = sound();
    let folder = tempfile::tempdir().unwrap();
    parse(folder.path(), &scene, &file(&arrays)).unwrap();
    let with = |name: &str, shape: &[usize], numbers: &[f64]| {
        let mut arrays = arrays.clone();
        *arrays.iter_mut().find(|(known, ..)| known == name).unwrap() = array(name, shape, numbers);
        parse(folder.path(), &scene, &file(&arrays)).map(|_| ()).unwrap_err()
    };
    let place = |message: String, path: &str| {
        let rest = message.strip_prefix(path).unwrap_or_else(|| panic!("{message} is not at {path}"));
        rest.split_once("): ").unwrap().1.to_owned()
    };
    let nan = |len: usize, at: usize| (0..len).map(|k| if k == at { f64::NAN } else { 1.0 }).collect::<Vec<_>>();
    for (message, path, expected) in [
        (
            with("b", &[6], &[1.0; 6]),
            "nodes.b.at",
            r#"array "b" of "arrays.npz" of shape (6,); allowed is (n, 3): nodes, at least one, and coordinates"#,
        ),
        (
            with("b", &[0, 3], &[]),
            "nodes.b.at",
            r#"array "b" of "arrays.npz" of shape (0, 3); allowed is (n, 3): nodes, at least one, and coordinates"#,
        ),
        (
            with("b", &[2, 3], &nan(6, 4)),
            "nodes.b.at",
            r#"array "b" of "arrays.npz" with NaN at [1, 1]; allowed is a finite number"#,
        ),
        (
            with("mu", &[3], &[0.0; 3]),
            "elements.e.mu",
            r#"array "mu" of "arrays.npz" of shape (3,); allowed is (2,): elements"#,
        ),
        (
            with("mu", &[2], &[0.5, -0.5]),
            "elements.e.mu",
            r#"array "mu" of "arrays.npz" with -0.5 at [1]; allowed is a finite number ≥ 0"#,
        ),
        (
            with("time", &[3], &[0.0, 1.0, 0.5]),
            "frames.time",
            r#"array "time" of "arrays.npz" with 0.5 at [2]; allowed is times that do not fall, here at least 1.0"#,
        ),
        (
            with("time", &[], &[1.0]),
            "frames.time",
            r#"array "time" of "arrays.npz" of shape (); allowed is (n,): states, at least one"#,
        ),
        (
            with("u", &[2, 3, 3], &[1.0; 18]),
            "frames.nodes.b.u",
            r#"array "u" of "arrays.npz" of shape (2, 3, 3); allowed is (3, 2, 3): states, members, components"#,
        ),
        (
            with("u", &[3, 2, 3], &nan(18, 17)),
            "frames.nodes.b.u",
            r#"array "u" of "arrays.npz" with NaN at [2, 1, 2]; allowed is a finite number"#,
        ),
        (
            with("u", &[3, 2, 3], &[f64::INFINITY; 18]),
            "frames.nodes.b.u",
            r#"array "u" of "arrays.npz" with inf at [0, 0, 0]; allowed is a finite number"#,
        ),
        (
            with("f", &[3], &[1.0; 3]),
            "frames.loads.e.f2",
            r#"array "f" of "arrays.npz" of shape (3,); allowed is (3, 2): states, members"#,
        ),
    ] {
        assert_eq!(place(message, path), expected);
    }
    let message = parse(folder.path(), &scene, &file(&arrays[..4])).unwrap_err();
    assert_eq!(
        place(message, "frames.loads.e.f2"),
        r#"no array "f" in "arrays.npz"; allowed is one of "b", "mu", "time", "u""#
    );
    // All faults are reported together.
    let message = parse(folder.path(), &scene, &file(&arrays[..1])).unwrap_err();
    assert_eq!(message.lines().count(), 2, "{message}");
}

#[test]
fn every_mistake_in_a_file_is_said() {
    let (mut scene, _) = sound();
    let folder = tempfile::tempdir().unwrap();
    scene["nodes"] = json!({ "a": { "at": [0, 0, 0] } });
    (scene["elements"], scene["outputs"], scene["frames"]) = (json!({}), json!([]), json!({ "time": "time" }));
    let said = |bytes: &[u8]| parse(folder.path(), &scene, bytes).map(|scene| scene.times().collect::<Vec<_>>());
    let header = |descr: &str, order: &str, shape: &str| {
        format!("{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}")
    };
    let numbers = [0.0_f64, 2.0].map(f64::to_le_bytes).concat();
    let good = header("'<f8'", "False", "(2,)");
    for method in [CompressionMethod::STORE, CompressionMethod::DEFLATE] {
        assert_eq!(said(&made(&good, &numbers, method)).unwrap(), [0.0, 2.0], "{method}");
    }
    let stored = |header: &str| said(&made(header, &numbers, CompressionMethod::STORE)).unwrap_err();
    for (message, expected) in [
        (
            stored(&header("'>f8'", "False", "(2,)")),
            "numbers of type '>f8'; allowed is '<f8', little-endian floats of 64 bits: array.astype('<f8')",
        ),
        (stored(&header("'<i8'", "False", "(2,)")), "numbers of type '<i8'"),
        (
            stored(&header("'<f8'", "True", "(2, 1)")),
            "Fortran order; allowed is C order: numpy.ascontiguousarray(array)",
        ),
        (
            stored(&header("'<f8'", "False", "(3,)")),
            "with 16 bytes of numbers; allowed is as many as its shape (3,) takes",
        ),
        (stored(&header("'<f8'", "False", "(9999999999, 9999999999)")), "with 16 bytes of numbers"),
        (stored("no dictionary"), "a header that cannot be read"),
        (said(&made(&good, &numbers, CompressionMethod::ZSTD)).unwrap_err(), "compressed by method"),
        (said(b"no archive").unwrap_err(), "which is no whole archive"),
        (said(b"").unwrap_err(), "which is no whole archive"),
        (said(&file(&[])).unwrap_err(), r#"no array "time" in "arrays.npz"; allowed is none, it is empty"#),
    ] {
        assert!(message.contains(expected), "{message}");
    }
    let twice = file(&[array("time", &[1], &[0.0]), array("time", &[1], &[1.0])]);
    assert!(said(&twice).unwrap_err().contains("\"time.npy\" of \"arrays.npz\" for the second time"));
    scene["columns"] = json!("none.npz");
    let message = parse(folder.path(), &scene, b"").unwrap_err();
    assert!(message.starts_with("columns (line 1, column ") && message.contains("no file \"none.npz\""), "{message}");
    let message = Scene::parse(&scene.to_string()).unwrap_err().to_string();
    assert!(message.contains("columns in a text that is in no folder"), "{message}");
}

/// Whatever happens to a byte, nothing panics; if an array is read nevertheless, it equals what was written.
#[test]
fn no_damage_goes_unseen_or_panics() {
    let (scene, arrays) = sound();
    let folder = tempfile::tempdir().unwrap();
    let bytes = file(&arrays);
    let read =
        |bytes: &[u8]| parse(folder.path(), &scene, bytes).ok().map(|scene| column_bits(&Columns::of(&scene).unwrap()));
    let whole = read(&bytes).unwrap();
    let compressed =
        made("{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }", &[0; 24], CompressionMethod::DEFLATE);
    for bytes in [&bytes, &compressed] {
        for cut in (0..bytes.len()).step_by(7) {
            assert_eq!(read(&bytes[..cut]), None, "cut at {cut}");
        }
    }
    let mut harmless = 0;
    for at in 0..bytes.len() {
        for flip in [0x01, 0x80] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            if let Some(found) = read(&damaged) {
                assert_eq!(found, whole, "byte {at}");
                harmless += 1;
            }
        }
    }
    // The times of entries, for example, on which nothing depends.
    assert!(harmless < bytes.len() / 2, "{harmless} of {} flips are not seen", 2 * bytes.len());
}

/// The history is read again during evaluation, from the file in its state at that time.
#[test]
fn a_file_that_changes_after_the_scene_was_read_is_seen() {
    let (scene, arrays) = sound();
    let folder = tempfile::tempdir().unwrap();
    let whole = file(&arrays);
    let said = |changed: &[u8]| {
        let read = parse(folder.path(), &scene, &whole).unwrap();
        let of_whole = column_bits(&Columns::of(&read).unwrap());
        assert_eq!(of_whole, column_bits(&Columns::of(&read).unwrap()), "what is read twice is the same");
        std::fs::write(folder.path().join(FILE), changed).unwrap();
        let plan = Plan::new(&read);
        if let Ok(mut run) = Run::<f64>::new(&plan) {
            let ended: Vec<_> = (0..5).map(|_| run.advance().ok()).collect();
            assert!(ended.contains(&None), "{ended:?}: it goes on, and does not panic");
        }
        match [Columns::of(&read).map(|_| ()), Results::of(&read).map(|_| ())] {
            [Err(Stopped::Unreadable(columns)), Err(Stopped::Unreadable(results))] if columns == results => columns,
            other => panic!("{other:?}"),
        }
    };
    let u_with_nan_at = |place: usize| {
        let numbers: Vec<_> = (0..18).map(|k| if k == place { f64::NAN } else { 0.5 }).collect();
        array("u", &[3, 2, 3], &numbers)
    };
    let with = |changed: &[Array]| {
        let known = |array: &Array| changed.iter().find(|(name, ..)| *name == array.0).unwrap_or(array).clone();
        file(&arrays.iter().map(known).collect::<Vec<_>>())
    };
    // A different number with the old checksum; only in "u" there are two equal numbers side by side.
    let mut other = whole.clone();
    let two = [0.5; 2].map(f64::to_le_bytes).concat();
    let at = whole.windows(two.len()).position(|bytes| bytes == two).unwrap();
    other[at..][..8].copy_from_slice(&0.375_f64.to_le_bytes());
    for (changed, found) in [
        (with(&[u_with_nan_at(7)]), r#"array "u" of "arrays.npz" with NaN at [1, 0, 1]"#),
        (other, r#"array "u" of "arrays.npz", damaged: "#),
        (whole[..100].to_vec(), "damaged: "),
        (Vec::new(), "damaged: "),
    ] {
        let unreadable = said(&changed);
        assert!(unreadable.found.contains(found), "{unreadable}");
        assert!(unreadable.path.starts_with("frames."), "{unreadable}");
    }
    // Of two faults the first is reported: that of the first state, and within it that of the displacement.
    let no_load = array("f", &[3, 2], &[f64::NAN; 6]);
    for (place, path) in [(7, "frames.loads.e.f2"), (0, "frames.nodes.b.u")] {
        assert_eq!(said(&with(&[u_with_nan_at(place), no_load.clone()])).path, path);
    }
    let unreadable = said(&with(&[u_with_nan_at(7)]));
    assert_eq!(unreadable.path, "frames.nodes.b.u");
    assert!(unreadable.to_string().ends_with("allowed is a finite number"), "{unreadable}");
}

#[test]
fn references_that_do_not_fit_are_said() {
    let (scene, arrays) = sound();
    let folder = tempfile::tempdir().unwrap();
    let bytes = file(&arrays);
    let said = |change: &dyn Fn(&mut Value)| {
        let mut scene = scene.clone();
        change(&mut scene);
        parse(folder.path(), &scene, &bytes).map(|_| ()).unwrap_err()
    };
    for (message, expected) in [
        (
            said(&|scene| scene["elements"]["e"]["nodes"] = json!(["a", "b[2:]"])),
            "no node \"b[2:]\"; allowed is one of \"a\", \"b\"",
        ),
        (said(&|scene| scene["elements"]["e"]["nodes"] = json!(["b[0]", "b"])), "node \"b[0]\" for the second time"),
        (said(&|scene| scene["elements"]["e"]["nodes"] = json!(["a", "b[0]"])), "an array for one element"),
        (said(&|scene| scene["frames"]["time"] = json!(1)), "frames.time"),
        (said(&|scene| scene["frames"]["nodes"]["b"]["u"] = json!([0, 0, 0])), "allowed is the name of an array"),
        (said(&|scene| scene["frames"] = json!({})), "frames without \"time\""),
        (said(&|scene| scene["nodes"]["c"] = json!({ "at": "mu" })), "of shape (2,); allowed is (n, 3)"),
    ] {
        assert!(message.contains(expected), "{message}");
    }
    let mut sets = scene.clone();
    sets["nodes"]["c"] = json!({ "at": "c", "orientation": "o" });
    sets["elements"]["e"]["nodes"] = json!(["c", "b"]);
    let with_c = [arrays.clone(), vec![array("c", &[3, 3], &[0.0; 9])]].concat();
    let message = parse(folder.path(), &sets, &file(&with_c)).map(|_| ()).unwrap_err();
    assert!(message.contains("sets of 3 and of 2 nodes"), "{message}");
    // Without a file, a string does not name an array.
    let mut without = scene.clone();
    without.as_object_mut().unwrap().remove("columns");
    let message = Scene::parse(&without.to_string()).unwrap_err().to_string();
    assert!(message.contains("nodes.b.at") && message.contains("an array of 3 numbers"), "{message}");
    assert!(message.contains("an array of frames"), "{message}");
}

#[test]
fn a_name_that_no_archive_holds_is_refused() {
    let mut writer = Writer::new(Vec::new());
    for name in ["../up", "a\\b", "/a", "a//b"] {
        assert!(writer.write(name, &[1], &[0.0]).is_err(), "{name}");
    }
    assert!(writer.write("short", &[2], &[0.0]).is_err());
    assert!(writer.write("long", &[usize::MAX, 2], &[0.0]).is_err());
    writer.write("größe of a/b", &[1], &[0.0]).unwrap();
}
