//! The cost of a scene from file to file: as JSON, and as columns.

use super::generate::{Connector, Generated};
use crate::console::say;
use crate::files;
use anyhow::{Context, ensure};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// The scene evaluated, and the number of runs for each format.
const SCENE: Generated = Generated { of: Connector::Slot, connectors: 100_000, states: 10 };
const TIMES: usize = 9;

/// One format, from a scene's file to that of its results.
struct Method {
    name: &'static str,
    scene: PathBuf,
    results: PathBuf,
    /// The bytes read and written.
    bytes: u64,
    /// The time of every run.
    milliseconds: Vec<f64>,
    /// The peak memory of a run, if the system reports it.
    peak: Option<usize>,
}

impl Method {
    fn new(folder: &Path, name: &'static str, scene: &str, results: &str) -> Self {
        let [scene, results] = [scene, results].map(|file| folder.join(file));
        Self { name, scene, results, bytes: 0, milliseconds: Vec::new(), peak: None }
    }

    /// Evaluates the scene in a separate process.
    fn run(&mut self) -> anyhow::Result<()> {
        let mut command = Command::new(std::env::current_exe().context("cannot find this program")?);
        let peak = self.results.with_extension("peak");
        command.arg("scene").arg(&self.scene).arg("--out").arg(&self.results).arg("--peak").arg(&peak);
        // Every run writes a new file, since overwriting an old one takes additional time.
        if self.results.exists() {
            std::fs::remove_file(&self.results).context("cannot remove the results of the run before")?;
        }
        let start = Instant::now();
        let ran = command.stdin(Stdio::null()).output().context("cannot run this program again")?;
        self.milliseconds.push(start.elapsed().as_secs_f64() * 1e3);
        let said = String::from_utf8_lossy(&ran.stderr);
        ensure!(ran.status.success(), "{} cannot be evaluated: {said}", self.scene.display());
        // If the system does not report it, there is no file.
        let peak = std::fs::read_to_string(peak).ok().and_then(|peak| peak.parse().ok());
        self.peak = self.peak.max(peak);
        Ok(())
    }
}

/// Measures both formats in turn, so that a slowdown of the machine affects both.
pub(crate) fn run(report: &mut String) -> anyhow::Result<()> {
    let folder = tempfile::tempdir().context("cannot make a folder")?;
    let folder = folder.path();
    let arrays = "arrays.npz";
    let mut methods = [
        Method::new(folder, "JSON", "many.json", "results.json"),
        Method::new(folder, "columns", "described.json", "results.npz"),
    ];
    files::write_with(&methods[0].scene, |file| SCENE.write(file))?;
    files::write_with(&methods[1].scene, |file| SCENE.write_description(arrays, file))?;
    files::write_with(&folder.join(arrays), |file| Ok(SCENE.write_arrays(file)?))?;
    for turn in 0..TIMES {
        say(&format!("from file to file, {} of {TIMES}", turn + 1));
        methods.iter_mut().try_for_each(Method::run)?;
    }
    let size = |path: &Path| std::fs::metadata(path).map(|file| file.len());
    for method in &mut methods {
        method.bytes = size(&method.scene)? + size(&method.results)?;
    }
    methods[1].bytes += size(&folder.join(arrays))?;
    write_report(report, &methods)?;
    Ok(())
}

fn write_report(report: &mut String, methods: &[Method; 2]) -> std::fmt::Result {
    let Generated { of, connectors, states } = SCENE;
    writeln!(
        report,
        "\nFrom file to file, {connectors} elements of kind `{}` over {states} states, {TIMES} alternating runs:\n\n\
         | Method | Median, ms | Least to most, ms | Files, MB | Peak memory, MB | Peak over files |\n\
         |---|---:|---:|---:|---:|---:|",
        of.kind()
    )?;
    for method in methods {
        let [least, median, most] = spread(&method.milliseconds);
        let peak = method.peak.map_or_else(|| ["–".into(), "–".into()], |peak| over(peak, method.bytes));
        let files = megabytes(method.bytes);
        let [peak, ratio] = peak;
        writeln!(
            report,
            "| {} | {median:.0} | {least:.0} to {most:.0} | {files:.1} | {peak} | {ratio} |",
            method.name
        )?;
    }
    let [json, columns] = methods;
    let ratios: Vec<_> =
        json.milliseconds.iter().zip(&columns.milliseconds).map(|(json, columns)| json / columns).collect();
    let [least, median, most] = spread(&ratios);
    writeln!(report, "\nColumns take {median:.1} times less time than JSON; run by run {least:.1} to {most:.1} times.")
}

/// Memory in megabytes, and relative to the size of the files.
fn over(peak: usize, bytes: u64) -> [String; 2] {
    let peak = megabytes(peak as u64);
    [format!("{peak:.1}"), format!("{:.2}", peak / megabytes(bytes))]
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
fn megabytes(bytes: u64) -> f64 {
    bytes as f64 / 1e6
}

/// Minimum, median and maximum.
fn spread(numbers: &[f64]) -> [f64; 3] {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    [sorted[0], sorted[sorted.len() / 2], sorted[sorted.len() - 1]]
}
