//! The scenes of `golden/scenes`: their golden results and their figures.

use super::plot;
use super::show::{self, Format};
use crate::files;
use anyhow::Context;
use jointproof::scene::{Plan, Results, Scene, Series, schema};
use std::path::PathBuf;

/// How the name of a golden result ends.
const RESULT: &str = ".result.json";

fn folder() -> PathBuf {
    files::root().join("golden").join("scenes")
}

/// The files there, by name.
fn files() -> anyhow::Result<Vec<PathBuf>> {
    let entries = match std::fs::read_dir(folder()) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.context("cannot list golden/scenes/")?,
    };
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<anyhow::Result<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

/// The scenes, by name.
fn scenes() -> anyhow::Result<Vec<(String, Scene)>> {
    let mut scenes = Vec::new();
    for path in files()? {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let stem = name.strip_suffix(".json").filter(|_| !name.ends_with(RESULT) && name != "schema.json");
        if let Some(stem) = stem {
            let scene = super::read(&path)?.map_err(anyhow::Error::msg)?;
            scenes.push((stem.to_owned(), scene));
        }
    }
    Ok(scenes)
}

/// A file beside the scenes, and what the code says that it is.
type Regenerated = (PathBuf, String);

/// The schema, and a result per scene, computed in 237 bits.
pub(crate) fn regenerate() -> anyhow::Result<Vec<Regenerated>> {
    let mut files = vec![(folder().join("schema.json"), serde_json::to_string_pretty(&schema())? + "\n")];
    for (name, scene) in scenes()? {
        let results = Results::exact(&scene).with_context(|| name.clone())?;
        files.push((folder().join(format!("{name}.result.json")), results.golden()?));
    }
    Ok(files)
}

/// What a check of the scenes found.
pub(crate) struct Checked {
    /// Scenes, each with a golden result.
    pub(crate) scenes: usize,
    /// Numbers compared.
    pub(crate) numbers: usize,
    /// Files that are not what the code says.
    pub(crate) off: Vec<PathBuf>,
}

/// Compares the committed files with what the code says, and looks for results that have no scene.
pub(crate) fn check() -> anyhow::Result<Checked> {
    let regenerated = regenerate()?;
    let (mut numbers, mut off) = (0, Vec::new());
    for (_, scene) in scenes()? {
        let count = |series: &Series| series.values.iter().map(Vec::len).sum::<usize>();
        numbers += Results::of(&scene)?.series.iter().map(count).sum::<usize>();
    }
    for (path, text) in &regenerated {
        if !std::fs::read_to_string(path).is_ok_and(|committed| committed == *text) {
            off.push(path.clone());
        }
    }
    off.extend(orphans(&regenerated)?);
    Ok(Checked { scenes: regenerated.len() - 1, numbers, off })
}

/// Golden results whose scene is gone.
pub(crate) fn orphans(regenerated: &[Regenerated]) -> anyhow::Result<Vec<PathBuf>> {
    let results = files()?.into_iter().filter(|path| path.to_string_lossy().ends_with(RESULT));
    Ok(results.filter(|path| regenerated.iter().all(|(known, _)| known != path)).collect())
}

/// What `cargo xtask scene` prints about the scenes, by the name that `{{#output name}}` gives: `plan-of-telescope`,
/// `results-of-telescope`.
pub(crate) fn outputs() -> anyhow::Result<Vec<(String, String)>> {
    let mut outputs = Vec::new();
    for (name, scene) in scenes()? {
        let plan = Plan::new(&scene);
        let (results, exact) = (Results::of(&scene)?, Results::exact(&scene)?);
        outputs.push((format!("plan-of-{name}"), show::plan(&plan, Format::Text)?));
        outputs.push((format!("results-of-{name}"), show::results(&scene, &results, Some(&exact), Format::Text)?));
    }
    Ok(outputs)
}

/// A figure of the book: an output of a scene over its history.
struct Figure {
    scene: &'static str,
    output: &'static str,
    label: &'static str,
    /// The elements that are shown.
    of: &'static [&'static str],
    /// What there is to see, for readers who cannot.
    description: &'static str,
}

const FIGURES: &[Figure] = &[
    Figure {
        scene: "telescope",
        output: "CSF1",
        label: "friction force",
        of: &["telescope"],
        description: "The friction force of the telescope over time: it grows while the contact sticks, stays at the limit \
            while it slips, grows with the load, and turns its sign when the telescope is pushed back.",
    },
    Figure {
        scene: "telescope",
        output: "CASU1",
        label: "accumulated slip",
        of: &["telescope"],
        description: "The slip of the telescope, added up: it rises while the contact slips in either direction and \
            never falls.",
    },
    Figure {
        scene: "drive-shaft",
        output: "ALPHA",
        label: "angle at the cross, in radians",
        of: &["first", "second"],
        description: "The angle of the cross about the input yoke over one turn of the shaft, for both joints: it swings \
            between minus and plus the bend of the joint, twice in opposite phase.",
    },
    Figure {
        scene: "drive-shaft",
        output: "CSM1",
        label: "friction moment",
        of: &["first"],
        description: "The moment of friction about the arm of the input yoke over one turn: it stays at the limit while the \
            cross swings one way, and passes over to the other limit where the swing turns back.",
    },
    Figure {
        scene: "thread",
        output: "T",
        label: "torque",
        of: &["box"],
        description: "The torque that the thread can transmit over its history: zero until the flanks touch, then in \
            proportion to how far the pin is made up, and back to zero as it is backed off.",
    },
    Figure {
        scene: "interface",
        output: "G2",
        label: "distance from the normal",
        of: &["inner", "middle", "outer"],
        description: "The distances of the nodes through the thickness from the shell's normal: zero up to rounding until \
            in the last state the outer node leaves it.",
    },
];

/// The figures, by the name that `{{#figure name}}` gives: `scene-telescope-CSF1`.
pub(crate) fn figures() -> anyhow::Result<Vec<(String, String)>> {
    let mut drawn = Vec::new();
    for (name, scene) in scenes()? {
        let results = Results::exact(&scene).with_context(|| name.clone())?;
        for Figure { output, label, of, description, .. } in FIGURES.iter().filter(|figure| figure.scene == name) {
            let mut shown = results.clone();
            shown.series.retain(|series| of.contains(&series.element.as_str()));
            let figure = format!("scene-{name}-{output}");
            drawn.push((figure.clone(), plot::chart(&shown, output, &figure, label, description)));
        }
    }
    Ok(drawn)
}
