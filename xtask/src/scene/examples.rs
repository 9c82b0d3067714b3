//! The scenes of `golden/scenes`: their golden results, their figures, and the table of outputs for the book.

use super::plot;
use crate::files;
use anyhow::Context;
use jointproof::scene::{Dimension, Kind, Results, Scene, schema};
use std::fmt::Write;
use std::path::PathBuf;

fn folder() -> PathBuf {
    files::root().join("golden").join("scenes")
}

/// The scenes, by name.
fn scenes() -> anyhow::Result<Vec<(String, Scene)>> {
    let mut scenes = Vec::new();
    let entries = match std::fs::read_dir(folder()) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(scenes),
        entries => entries.context("cannot list golden/scenes/")?,
    };
    for entry in entries {
        let path = entry?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let Some(stem) = name.strip_suffix(".json") else { continue };
        if stem.ends_with(".result") || stem == "schema" {
            continue;
        }
        let scene = super::read(&path)?.map_err(anyhow::Error::msg)?;
        scenes.push((stem.to_owned(), scene));
    }
    scenes.sort_by(|(a, _), (b, _)| a.cmp(b));
    Ok(scenes)
}

/// What the code says that the files beside the scenes are: the schema, and a result per scene, computed in 237 bits.
pub(crate) fn regenerate() -> anyhow::Result<Vec<(PathBuf, String)>> {
    let mut files = vec![(folder().join("schema.json"), serde_json::to_string_pretty(&schema())? + "\n")];
    for (name, scene) in scenes()? {
        let results = Results::exact(&scene).with_context(|| name.clone())?;
        files.push((folder().join(format!("{name}.result.json")), results.golden()?));
    }
    Ok(files)
}

/// A figure of the book: scene, output, label, and what there is to see.
type Figure = (&'static str, &'static str, &'static str, &'static str);

const FIGURES: &[Figure] = &[
    (
        "telescope",
        "CSF1",
        "friction force",
        "The friction force of the telescope over time: it grows while the contact sticks, stays at the limit while it slips, \
        grows with the load, and turns its sign when the telescope is pushed back.",
    ),
    (
        "drive-shaft",
        "ALPHA",
        "angle at the cross, in radians",
        "The angle of the cross about the input yoke over one turn of the shaft, for both joints: it swings between minus and \
        plus the bend of the joint, twice in opposite phase.",
    ),
    (
        "interface",
        "G1",
        "distance from the line",
        "The distances of the nodes through the thickness from the shell's line: zero up to rounding in every state.",
    ),
];

/// The figures, by the name that `{{#figure name}}` gives: `scene-telescope-CSF1`.
pub(crate) fn figures() -> anyhow::Result<Vec<(String, String)>> {
    let mut drawn = Vec::new();
    for (name, scene) in scenes()? {
        for (_, output, label, description) in FIGURES.iter().filter(|(of, ..)| *of == name) {
            let results = Results::exact(&scene).with_context(|| name.clone())?;
            let figure = format!("scene-{name}-{output}");
            drawn.push((figure.clone(), plot::chart(&results, output, &figure, label, description)));
        }
    }
    Ok(drawn)
}

/// Every output of every kind with the formula that computes it, for the book.
pub(crate) fn table() -> String {
    let mut text = String::new();
    for dimension in Dimension::ALL {
        for kind in Kind::all().filter(|kind| kind.dimension == dimension) {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{} in {}: nodes {}", kind.name, dimension.name(), kind.nodes.join(", "));
            let described = |name: &str| {
                let quantity = kind.field(name).map(|field| field.quantity);
                quantity.map_or_else(String::new, |quantity| format!("{} ({})", quantity.meaning, quantity.unit))
            };
            for (parameter, fallback) in kind.parameters() {
                let _ = writeln!(text, "  parameter {parameter:<11} {}, {}", described(parameter), fallback);
            }
            for load in kind.loads() {
                let _ = writeln!(text, "  load      {load:<11} {}", described(load));
            }
            for (output, register) in kind.outputs {
                let writers: Vec<_> = kind.writers(register).map(|formula| formula.step.id()).collect();
                let _ = writeln!(text, "  output    {output:<11} {}: {}", described(register), writers.join(" or "));
            }
            text.push('\n');
        }
    }
    text
}
