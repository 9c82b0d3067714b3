//! The golden scenes: their results are reproduced by the code, and every output of every kind is in one of them.

use jointproof::scene::{Kind, Results, Scene};
use serde_json::Value;
use std::collections::BTreeSet;

/// The golden scenes: path without extension, and text.
fn golden() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/golden/scenes");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path().to_string_lossy().into_owned());
    let stem = |path: String| path.strip_suffix(".json").map(str::to_owned);
    let mut stems: Vec<_> = paths.filter_map(stem).collect();
    stems.retain(|stem| !stem.ends_with(".result") && !stem.ends_with("schema"));
    stems.sort();
    stems.into_iter().map(|stem| (stem.clone(), std::fs::read_to_string(stem + ".json").unwrap())).collect()
}

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|faults| panic!("{faults}"))
}

#[test]
fn golden_results_are_what_the_scenes_give() {
    for (stem, text) in golden() {
        let committed = std::fs::read_to_string(format!("{stem}.result.json")).unwrap();
        let now = Results::exact(&scene(&text)).unwrap().golden().unwrap();
        assert!(committed == now, "{stem}: cargo xtask golden writes what the code says");
    }
}

#[test]
fn doubles_are_close_to_exact() {
    for (stem, text) in golden() {
        let scene = scene(&text);
        let (doubles, exact) = (Results::of(&scene).unwrap(), Results::exact(&scene).unwrap());
        for (series, exact) in doubles.series.iter().zip(&exact.series) {
            // If a history ends in a small difference, its error is that of the large values before it.
            let size = exact.values.iter().flatten().fold(1.0_f64, |size, value| size.max(value.abs()));
            for (a, b) in series.values.iter().flatten().zip(exact.values.iter().flatten()) {
                assert!((a - b).abs() <= 1e-12 * size, "{stem} {} {}: {a} {b}", series.element, series.output);
            }
        }
    }
}

/// An output missing from golden results would not be tested.
#[test]
fn every_output_of_every_kind_is_in_a_golden_scene() {
    let mut shown = BTreeSet::new();
    for (stem, text) in golden() {
        let scene: Value = serde_json::from_str(&text).unwrap();
        let result: Value =
            serde_json::from_str(&std::fs::read_to_string(format!("{stem}.result.json")).unwrap()).unwrap();
        for series in result["series"].as_array().unwrap() {
            let [element, output] = ["element", "output"].map(|key| series[key].as_str().unwrap());
            // The torque of a slide line is listed under the name of the line.
            let Some(kind) = scene["elements"][element]["kind"].as_str() else { continue };
            shown.insert(format!("{kind}@{}/{output}", scene["dimension"].as_str().unwrap()));
        }
    }
    let pair = |kind: &Kind, output: &str| format!("{}@{}/{output}", kind.name, kind.dimension.name());
    let all: Vec<_> = Kind::all().flat_map(|kind| kind.outputs().map(move |(output, _)| pair(kind, output))).collect();
    let missing: Vec<_> = all.iter().filter(|pair| !shown.contains(*pair)).collect();
    assert!(missing.is_empty(), "{} of {} are in no golden scene: {missing:?}", missing.len(), all.len());
}
