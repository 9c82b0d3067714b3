//! The scenes of `golden/scenes`: their golden results and their figures.

use super::show::{self, Format};
use super::{describe, load, plot};
use crate::console::count;
use anyhow::Context;
use jointproof::scene::{Deck, Plan, PlanLine, Results, Scene, Series, Table as Rows, Tables, schema};
use kit::{Beside, Project, Table};
use std::path::{Path, PathBuf};

/// The ending of the name of a golden result.
const RESULT: &str = ".result.json";

fn folder(project: &Project) -> PathBuf {
    project.golden().join("scenes")
}

/// The files of a folder, by name.
fn files(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.with_context(|| format!("cannot list {}", folder.display()))?,
    };
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<anyhow::Result<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

/// The scenes, by name.
fn scenes(project: &Project) -> anyhow::Result<Vec<(String, Scene)>> {
    let mut scenes = Vec::new();
    for path in files(&folder(project))? {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let stem = name.strip_suffix(".json").filter(|_| !name.ends_with(RESULT) && name != "schema.json");
        if let Some(stem) = stem {
            let loaded = load::read(&path, false)?.map_err(anyhow::Error::msg)?;
            scenes.push((stem.to_owned(), loaded.scene));
        }
    }
    Ok(scenes)
}

/// The decks of `golden/decks`, by name, with the histories beside them.
fn decks(project: &Project) -> anyhow::Result<Vec<(String, Deck, Scene)>> {
    let folder = project.golden().join("decks");
    let is_deck = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "inp");
    let read = |path: PathBuf| {
        let deck = Deck::parse_in(&folder, std::fs::read(&path)?)?;
        let (stem, scene) = (load::stem(&path), deck.scene()?);
        let table = |ending: &str| Some(folder.join(format!("{stem}{ending}.csv"))).filter(|path| path.exists());
        let [nodes, loads] = ["", "-loads"].map(|ending| table(ending).map(|path| Rows::file(&path)));
        let tables = Tables { nodes, loads, pressures: None };
        let scene = if tables.nodes.is_some() { scene.with_tables(tables)? } else { scene };
        Ok((stem, deck, scene))
    };
    files(&folder)?.into_iter().filter(is_deck).map(read).collect()
}

/// The schema, a result per scene, computed in 237 bits, and the scene and the result of every deck; results whose scene is gone are
/// orphans.
pub(crate) fn golden(project: &Project) -> anyhow::Result<Beside> {
    let (scenes, folder) = (scenes(project)?, folder(project));
    let (decks, decks_folder) = (decks(project)?, project.golden().join("decks"));
    let mut golden = vec![(folder.join("schema.json"), serde_json::to_string_pretty(&schema())? + "\n")];
    let mut numbers = 0;
    for (name, scene) in &scenes {
        let results = Results::exact(scene).with_context(|| name.clone())?;
        let count = |series: &Series| series.values.numbers().len();
        numbers += results.series.iter().map(count).sum::<usize>();
        golden.push((folder.join(format!("{name}{RESULT}")), results.golden()?));
    }
    for (name, deck, scene) in &decks {
        let result = Results::exact(scene).with_context(|| name.clone())?.golden()?;
        golden.push((decks_folder.join(format!("{name}.json")), deck.text().into()));
        golden.push((decks_folder.join(format!("{name}{RESULT}")), result));
    }
    let mut orphans = [files(&folder)?, files(&decks_folder)?].concat();
    orphans.retain(|path| path.to_string_lossy().ends_with(RESULT) && golden.iter().all(|(known, _)| known != path));
    let counts =
        format!("{}, {}, {}", count(scenes.len(), "scene"), count(numbers, "number"), count(decks.len(), "deck"));
    Ok(Beside { files: golden, orphans, counts })
}

/// The output of `cargo xtask scene` for the scenes, with the name used in `{{#output name}}`: `results-of-telescope`.
pub(crate) fn outputs(project: &Project) -> anyhow::Result<Vec<(String, String)>> {
    let mut outputs = Vec::new();
    for (name, scene) in scenes(project)? {
        let (results, exact) = (Results::of(&scene)?, Results::exact(&scene)?);
        outputs.push((format!("results-of-{name}"), show::results(&scene, &results, Some(&exact), Format::Text)?));
    }
    // Of decks: the scene, what is left out, and where its connectors are.
    for (name, deck, scene) in decks(project)? {
        outputs.push((format!("scene-of-{name}"), deck.text().into()));
        let left_out: Vec<_> = deck.left_out().iter().map(ToString::to_string).collect();
        outputs.push((format!("left-out-of-{name}"), left_out.join("\n")));
        outputs.push((format!("start-of-{name}"), describe::text(&name, &scene, &scene.start()?)?));
    }
    Ok(outputs)
}

/// The plans of the scenes, with the name used in `{{#table name}}`: `plan-of-telescope`.
pub(crate) fn plans(project: &Project) -> anyhow::Result<Vec<(String, Vec<Table>)>> {
    let head = ["Formula", "Evaluated", "Needed for"].map(String::from);
    let plan = |(name, scene): &(String, Scene)| {
        let plan = Plan::new(scene);
        let states = scene.times().len();
        let row = |line: &PlanLine| {
            let when = if line.once { "once, at the start".into() } else { format!("in each of {states} states") };
            vec![
                format!("`{}`", line.formula),
                format!("for {}, {when}", count(line.elements, line.kind)),
                line.why.clone(),
            ]
        };
        let rows = plan.lines().iter().map(row).collect();
        (format!("plan-of-{name}"), vec![Table { head: head.clone().into(), rows, ..Table::default() }])
    };
    Ok(scenes(project)?.iter().map(plan).collect())
}

/// A figure of the book: an output of a scene over its history.
struct Figure {
    scene: &'static str,
    output: &'static str,
    /// The label of the axis, with the unit.
    label: &'static str,
    /// The size of that unit in the units of the scene.
    unit: f64,
    /// The elements shown.
    of: &'static [&'static str],
    /// What it is drawn over instead of time.
    over: Option<Over>,
    /// A description of the picture for readers who cannot see it.
    description: &'static str,
}

/// The first component of an output, over which another one is drawn.
struct Over {
    name: &'static str,
    element: &'static str,
    output: &'static str,
    label: &'static str,
    unit: f64,
}

const FIGURES: &[Figure] = &[
    Figure {
        scene: "telescope",
        output: "CSF1",
        label: "friction force, in N",
        unit: 1.0,
        of: &["telescope"],
        over: None,
        description: "The friction force of the telescope over time: it grows while the contact sticks, stays at the limit \
            while it slips, grows with the load, and changes its sign when the telescope is pushed back.",
    },
    Figure {
        scene: "telescope",
        output: "CASU1",
        label: "accumulated slip, in mm",
        unit: 1e-3,
        of: &["telescope"],
        over: None,
        description: "The slip of the telescope, added up: it rises while the contact slips in either direction and \
            never falls.",
    },
    Figure {
        scene: "drive-shaft",
        output: "ALPHA",
        label: "angle at the cross, in radians",
        unit: 1.0,
        of: &["first", "second"],
        over: None,
        description: "The angle of the cross about the input yoke over one turn of the shaft, for both joints: it swings \
            between minus and plus the bend of the joint, twice in opposite phase.",
    },
    Figure {
        scene: "drive-shaft",
        output: "CSM1",
        label: "friction moment, in N m",
        unit: 1.0,
        of: &["first"],
        over: None,
        description: "The moment of friction about the arm of the input yoke over one turn: it stays at the limit while the \
            cross swings one way, and passes over to the other limit where the swing turns back.",
    },
    Figure {
        scene: "thread",
        output: "T",
        label: "torque, in kN m",
        unit: 1e6,
        of: &["box"],
        over: None,
        description: "The torque that the thread can transmit over its history: zero until the flanks touch, then in \
            proportion to how far the pin is made up, and back to zero as it is backed off.",
    },
    Figure {
        scene: "interface",
        output: "G2",
        label: "distance from the normal, in units of length",
        unit: 1.0,
        of: &["inner", "middle", "outer"],
        over: None,
        description: "The distances of the nodes through the thickness from the shell's normal: zero up to rounding until \
            in the last state the outer node leaves it.",
    },
    Figure {
        scene: "telescope",
        output: "CSF1",
        label: "friction force, in N",
        unit: 1.0,
        of: &["telescope"],
        over: Some(Over { name: "loop", element: "telescope", output: "U1", label: "extension, in m", unit: 1.0 }),
        description: "The friction force of the telescope over its extension: a loop, above while it slides out, below while it \
            is pushed back, with steep sides where the contact sticks.",
    },
    Figure {
        scene: "drive-shaft",
        output: "RM",
        label: "moment on the input shaft, in N m",
        unit: -1.0,
        of: &["first"],
        over: Some(Over {
            name: "angle",
            element: "bearing in",
            output: "UR1",
            label: "angle of the input shaft, in degrees",
            unit: DEGREE,
        }),
        description: "The moment that the first joint transmits to the input shaft over one turn: it varies between 173 and 200, \
            twice in each turn, since the cross is inclined to the shaft.",
    },
    Figure {
        scene: "drive-shaft",
        output: "CSM1",
        label: "friction moment of the bearings, in N m",
        unit: 1.0,
        of: &["bearing in", "bearing out"],
        over: Some(Over {
            name: "bearings",
            element: "bearing in",
            output: "UR1",
            label: "angle of the input shaft, in degrees",
            unit: DEGREE,
        }),
        description: "The friction moments of both bearings over one turn: each grows in the first increment and stays at its limit.",
    },
    Figure {
        scene: "thread",
        output: "T",
        label: "torque, in kN m",
        unit: 1e6,
        of: &["box"],
        over: Some(Over {
            name: "make-up",
            element: "thread 1",
            output: "E12",
            label: "slip of the pin along the box, in mm",
            unit: -1.0,
        }),
        description: "The torque of the thread over how far the pin is made up: zero until the flanks touch at 0.8, then a straight \
            line, up while it is made up and down while it is backed off.",
    },
];

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The figures, with the name used in `{{#figure name}}`: `scene-telescope-CSF1`, `scene-telescope-CSF1-loop`.
pub(crate) fn figures(project: &Project) -> anyhow::Result<Vec<(String, String)>> {
    let mut drawn = Vec::new();
    for (name, scene) in scenes(project)? {
        let results = Results::exact(&scene).with_context(|| name.clone())?;
        for Figure { output, label, unit, of, over, description, .. } in
            FIGURES.iter().filter(|figure| figure.scene == name)
        {
            let mut shown = results.clone();
            if let Some(Over { element, output, unit, .. }) = over {
                let at =
                    |state| results.get(element, output, state).and_then(<[f64]>::first).map_or(f64::NAN, |x| x / unit);
                shown.times = (0..results.times.len()).map(at).collect();
            }
            shown.series.retain(|series| of.contains(&series.element.as_str()));
            shown.series.iter_mut().flat_map(|series| series.values.numbers_mut()).for_each(|value| *value /= unit);
            let (figure, x) = match over {
                None => (format!("scene-{name}-{output}"), "time"),
                Some(Over { name: over, label, .. }) => (format!("scene-{name}-{output}-{over}"), *label),
            };
            drawn.push((figure.clone(), plot::chart(&shown, output, &figure, [x, label], description)));
        }
    }
    Ok(drawn)
}
