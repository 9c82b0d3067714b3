//! `cargo xtask scene`: scene files evaluated, planned, compared with the exact values, plotted.

mod bare;
mod benchmark;
mod deck;
mod describe;
mod examples;
mod file_to_file;
mod generate;
mod kinds;
mod load;
mod out;
mod plot;
mod show;

pub(crate) use examples::{figures, golden, outputs, plans};
pub(crate) use kinds::{anchor, served};

use crate::console::{print, progress, say};
use crate::{Outcome, files};
use anyhow::Context;
use generate::Generated;
use jointproof::Octuple;
use jointproof::scene::{Columns, Plan, Results, Scene, Table, TableFault, Tables, Unwritten, Warning};
use kit::{Project, Usage};
use load::{Loaded, STANDARD_INPUT, read, shown, stem, warn};
use out::{Form, Target};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Evaluate scenes: connectors and constraints together, over a history of states
///
/// All errors in a scene are reported together, each with its JSON path, line and column; then nothing is evaluated. A scene may also be
/// a deck, an input file of keywords: what of it is left out is said.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} scene golden/scenes/rail.json            a table per output
  {command} scene golden/scenes/rail.json --plan     which formulas, how often, and why
  {command} scene golden/scenes/rail.json --error    each number with its error
  {command} scene golden/scenes/rail.json --plot .   an SVG per output over the history
  {command} scene *.json --format csv > all.csv      for a spreadsheet
  {command} scene - --format json < my.json          from standard input
  {command} scene my.json --history u.csv            displacements
  {command} scene my.json --out results.npz          for numpy: np.load('results.npz')
  {command} scene my.inp --write my.json             the scene that a deck describes
  {command} scene my.inp --describe --out my.html    drawn
  {command} scene --generate 10000 > many.json       a scene to measure with
  {command} scene --generate 100 --columns a.npz > a.json    another, its numbers as arrays
  {command} scene --benchmark                        what an element costs per state")]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub(crate) struct Arguments {
    /// Scene files; `-` is standard input
    #[arg(value_name = "FILE", required_unless_present_any = ["generate", "benchmark"])]
    files: Vec<PathBuf>,
    /// A table of displacements (CSV: time, node, u1 … ur3) as the history, instead of that of the scene
    #[arg(long, value_name = "FILE")]
    history: Option<PathBuf>,
    /// A table of loads (CSV: time, element, f1 … m3) with the times of the history
    #[arg(long, value_name = "FILE")]
    loads: Option<PathBuf>,
    /// A table of pressures of hard contact (CSV: time, node, pressure) with the times of the history
    #[arg(long, value_name = "FILE")]
    pressures: Option<PathBuf>,
    /// Only print which formulas would be evaluated, how often and why
    #[arg(long)]
    plan: bool,
    /// How to print the results
    #[arg(long, value_enum, default_value_t = show::Format::Text)]
    format: show::Format,
    /// Write the results to this file instead, by its name: `.npz` arrays that numpy opens, `.json`, `.csv` or `.txt`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["format", "plan"])]
    out: Option<Target>,
    /// Evaluate in 237 bits too, and give the error of every number
    #[arg(long)]
    error: bool,
    /// Write a plot of every output over the history into this folder, as SVG
    #[arg(long, value_name = "FOLDER")]
    plot: Option<PathBuf>,
    /// Fail if something in a scene is ambiguous; without this it is only said
    #[arg(long)]
    deny_warnings: bool,
    /// Only describe the elements at the start: geometry, parameters that are missing, what is undefined; with `--out FILE.html` as a
    /// page with a drawing of each
    #[arg(long, conflicts_with_all = ["plan", "error", "plot", "write"])]
    describe: bool,
    /// Write the scene that was read from a deck to this file, and evaluate nothing
    #[arg(long, value_name = "FILE", conflicts_with_all = ["out", "plan", "plot", "history", "loads", "pressures"])]
    write: Option<PathBuf>,
    /// Print a scene of N sliding connectors
    #[arg(long, value_name = "N", conflicts_with_all = ["files", "benchmark"])]
    generate: Option<usize>,
    /// The connector of a generated scene
    #[arg(long, value_enum, requires = "generate", default_value_t = generate::Connector::Slot)]
    of: generate::Connector,
    /// The states of a generated scene
    #[arg(long, value_name = "N", requires = "generate", default_value_t = generate::STATES)]
    states: usize,
    /// Write the numbers of a generated scene as arrays into this file, beside which the scene is to stand
    #[arg(long, value_name = "FILE", requires = "generate")]
    columns: Option<PathBuf>,
    /// Measure scenes of 10, 10,000 and 1,000,000 elements against a bare loop of the same formulas; an optimised build does
    /// that better: `cargo run --release -p xtask -- scene --benchmark`
    #[arg(long, conflicts_with = "files")]
    benchmark: bool,
    /// Write into this file how many bytes of memory there were at most
    #[arg(long, value_name = "FILE", hide = true)]
    peak: Option<PathBuf>,
}

/// The book's tables of what is read.
pub(crate) fn tables() -> Vec<(String, Vec<kit::Table>)> {
    [kinds::tables(), deck::tables()].concat()
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    if let Some(elements) = arguments.generate {
        let generated = Generated { of: arguments.of, connectors: elements, states: arguments.states };
        match &arguments.columns {
            None => piped(generated.write(&mut anstream::stdout().lock()))?,
            Some(path) => {
                let name = path.file_name().context("--columns needs the name of a file")?.to_string_lossy();
                files::write_with(path, |file| Ok(generated.write_arrays(file)?))?;
                piped(generated.write_description(&name, &mut anstream::stdout().lock()))?;
            }
        }
        return Ok(ExitCode::SUCCESS);
    }
    if arguments.benchmark {
        benchmark::run()?;
        return Ok(ExitCode::SUCCESS);
    }
    let is_page = arguments.out.as_ref().is_some_and(|target| target.form == Form::Page);
    if arguments.out.is_some() && is_page != arguments.describe {
        return Err(Usage("--describe writes a page, .html, and nothing else does".into()).into());
    }
    if arguments.out.is_some() && arguments.files.len() > 1 {
        return Err(Usage("--out takes the results of one scene".into()).into());
    }
    let is_arrays = arguments.out.as_ref().is_some_and(|target| target.form == Form::Arrays);
    if is_arrays && (arguments.error || arguments.plot.is_some()) {
        return Err(Usage("arrays are written without --error and --plot".into()).into());
    }
    let mut scenes = Vec::new();
    for path in &arguments.files {
        match read(path, arguments.write.is_some())? {
            Ok(Loaded { scene, text, left_out }) => match with_tables(arguments, scene) {
                Ok(scene) => scenes.push((path, Loaded { scene, text, left_out })),
                Err(fault) => say(&fault.to_string()),
            },
            Err(report) => say(&report),
        }
    }
    if scenes.len() < arguments.files.len() {
        return Ok(ExitCode::FAILURE);
    }
    if let Some(target) = &arguments.write {
        let texts: Vec<_> = scenes.iter().filter_map(|(_, loaded)| loaded.text.as_deref()).collect();
        let [text] = texts[..] else { return Err(Usage("--write takes the scene of one deck".into()).into()) };
        files::write(target, text)?;
        let warned = warn(scenes[0].0, &scenes[0].1.left_out);
        return Ok(arguments.exit(warned));
    }
    if arguments.describe {
        return Ok(arguments.exit(describe::run(arguments.out.as_ref(), &scenes)?));
    }
    // Threads are started before the timing begins.
    rayon::broadcast(|_| ());
    let several = arguments.files.len() > 1;
    let (mut documents, mut warned) = (Vec::new(), 0);
    for (path, Loaded { scene, left_out, .. }) in &scenes {
        if several && arguments.format == show::Format::Text {
            print(&format!("{}\n", shown(path)))?;
        }
        let (text, of_scene) = one(project, arguments, path, scene)?;
        let warnings = [left_out.clone(), of_scene].concat();
        scene.notes().iter().for_each(|note| say(&format!("note: {}: {note}", shown(path))));
        warned += warn(path, &warnings);
        match text {
            Some(document) if several && arguments.format == show::Format::Json => documents.push(document),
            Some(text) => print(&text)?,
            None => {}
        }
    }
    if !documents.is_empty() {
        print(&format!("[{}]", documents.join(",")))?;
    }
    if let Some((path, peak)) = arguments.peak.as_ref().zip(benchmark::peak()) {
        files::write(path, &peak.to_string())?;
    }
    Ok(arguments.exit(warned))
}

impl Arguments {
    /// The exit code after so many warnings.
    fn exit(&self, warned: usize) -> ExitCode {
        if self.deny_warnings && warned > 0 { ExitCode::FAILURE } else { ExitCode::SUCCESS }
    }
}

/// A reader that stops reading, such as `head`, is no error.
fn piped<T: Default>(written: anyhow::Result<T>) -> anyhow::Result<T> {
    written.or_else(|error| match error.downcast_ref::<std::io::Error>().map(std::io::Error::kind) {
        Some(std::io::ErrorKind::BrokenPipe) => Ok(T::default()),
        _ => Err(error),
    })
}

/// The scene with the history in the given tables, if there are any.
fn with_tables(arguments: &Arguments, scene: Scene) -> Result<Scene, TableFault> {
    let Arguments { history, loads, pressures, .. } = arguments;
    let [nodes, loads, pressures] = [history, loads, pressures].map(|path| path.as_deref().map(Table::file));
    if [&nodes, &loads, &pressures].iter().all(|table| table.is_none()) {
        return Ok(scene);
    }
    scene.with_tables(Tables { nodes, loads, pressures })
}

/// What to do about a scene without outputs.
fn nothing_wanted(path: &Path, scene: &Scene) -> String {
    let kinds = scene.elements().filter_map(|element| scene.kind(element));
    let mut outputs: Vec<_> = kinds.flat_map(|kind| kind.outputs().map(|(name, _)| name)).collect();
    let mut seen = std::collections::HashSet::new();
    outputs.retain(|output| seen.insert(*output));
    format!(
        "{}: no outputs are wanted, so nothing would be computed; name some of {} in \"outputs\"",
        shown(path),
        outputs.join(", ")
    )
}

/// The text to be printed for a scene, except results that are printed state by state, and what was ambiguous.
fn one(
    project: &Project,
    arguments: &Arguments,
    path: &Path,
    scene: &Scene,
) -> anyhow::Result<(Option<String>, Vec<String>)> {
    let plan = Plan::new(scene);
    if arguments.plan {
        return Ok((Some(show::plan(&plan, arguments.format)?), scene.warnings()));
    }
    if plan.lines().is_empty() {
        return Err(Usage(nothing_wanted(path, scene)).into());
    }
    let in_words = |warnings: Vec<Warning>| {
        let on_the_way = warnings.iter().map(ToString::to_string);
        scene.warnings().into_iter().chain(on_the_way).collect()
    };
    let format = match &arguments.out {
        Some(Target { path, form: Form::Arrays }) => {
            let bar = progress("scene", scene.times().len());
            let stream = |file: &mut File| {
                Columns::stream(&plan, file, || bar.inc(1)).map_err(|unwritten| match unwritten {
                    Unwritten::Io(error) => error.into(),
                    unwritten => anyhow::Error::from(unwritten),
                })
            };
            let warnings = files::write_with(path, stream)?;
            bar.finish_and_clear();
            return Ok((None, in_words(warnings)));
        }
        Some(Target { form: Form::Printed(format), .. }) => *format,
        Some(Target { form: Form::Page, .. }) | None => arguments.format,
    };
    if format == show::Format::Csv && !arguments.error && arguments.plot.is_none() {
        let warnings = match &arguments.out {
            Some(Target { path, .. }) => files::write_with(path, |file| show::stream(&plan, file))?,
            None => piped(show::stream(&plan, &mut anstream::stdout().lock()))?,
        };
        return Ok((None, in_words(warnings)));
    }
    let limit = if format == show::Format::Text { show::SHOWN } else { usize::MAX };
    let (results, time) = timed("f64", scene, |each| Results::collect::<f64>(&plan, limit, each))?;
    let exact = if arguments.error {
        Some(timed("237 bits", scene, |each| Results::collect::<Octuple>(&plan, limit, each))?)
    } else {
        None
    };
    let text = show::results(scene, &results, exact.as_ref().map(|(exact, _)| exact), format)?;
    if let Some((_, exact_time)) = exact {
        let microseconds = |time: Duration| time.as_secs_f64() * 1e6;
        say(&format!("{:.1} µs in f64, {:.1} µs in 237 bits", microseconds(time), microseconds(exact_time)));
    }
    if let Some(folder) = &arguments.plot {
        let stem = if path.as_os_str() == STANDARD_INPUT { "scene".into() } else { stem(path) };
        for (output, svg) in plot::charts(&results) {
            let target = folder.join(format!("{stem}.{output}.svg"));
            files::write(&target, &svg)?;
            say(&format!("wrote {}", project.shown(&target)));
        }
    }
    if let Some(Target { path, .. }) = &arguments.out {
        files::write_with(path, |file| Ok(file.write_all(text.as_bytes())?))?;
        return Ok((None, results.warnings));
    }
    Ok((Some(text), results.warnings))
}

fn timed<R, E: std::error::Error + Send + Sync + 'static>(
    what: &'static str,
    scene: &Scene,
    job: impl FnOnce(&mut dyn FnMut()) -> Result<R, E>,
) -> anyhow::Result<(R, Duration)> {
    let bar = progress(what, scene.times().len());
    let start = Instant::now();
    let result = job(&mut || bar.inc(1))?;
    let time = start.elapsed();
    bar.finish_and_clear();
    Ok((result, time))
}
