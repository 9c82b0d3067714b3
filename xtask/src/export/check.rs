//! The export compiled, run, and compared bit by bit.

use super::Recorded;
use super::language::Language;
use super::points::Point;
use crate::console::{count, say};
use anyhow::{Context, ensure};
use jointproof::formula::Field;
use jointproof::graph::{Binary, Op};
use std::fmt;
use std::path::Path;
use std::process::Command;

/// What builds and runs a driver: commands in the folder of the export.
pub(super) struct Toolchain {
    /// The program that must be here.
    pub(super) name: &'static str,
    /// The commands, each a program and its arguments; the last one is the driver.
    pub(super) commands: Vec<Vec<String>>,
    /// By how much results that come from functions such as the sine may differ from those of Rust, in units of the distance
    /// from 1 to the next number: the language has its own, which may be off by a rounding, and angles are of the size 1.
    pub(super) epsilons: f64,
}

/// What a comparison found.
pub(super) struct Judged {
    toolchain: &'static str,
    compared: usize,
    differ: usize,
    /// Differences within what the functions of the language may have.
    near: usize,
    refused: usize,
    worst: Option<String>,
}

impl Judged {
    pub(super) fn is_well(&self) -> bool {
        self.compared > 0 && self.differ == 0
    }
}

impl fmt::Display for Judged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { toolchain, compared, differ, near, refused, worst } = self;
        write!(f, "{toolchain}: {}, {differ} differ", count(*compared, "number"))?;
        if *near > 0 {
            write!(f, ", {near} by functions of the language alone")?;
        }
        write!(f, "; {refused} refused alike")?;
        worst.iter().try_for_each(|worst| write!(f, "\n    {worst}"))
    }
}

/// Every toolchain that is here.
pub(super) fn all(
    language: &dyn Language,
    folder: &Path,
    recorded: &[Recorded],
    points: &[Vec<Point>],
) -> anyhow::Result<Vec<Judged>> {
    write_points(folder, points)?;
    let mut judged = Vec::new();
    for toolchain in language.toolchains() {
        if Command::new(toolchain.name).arg("--version").output().is_err() {
            say(&format!("{} is not here: not compared with it", toolchain.name));
            continue;
        }
        for command in &toolchain.commands {
            run(folder, command)?;
        }
        let found = std::fs::read(folder.join("found.bin")).context("the driver wrote no results")?;
        judged.push(compare(&toolchain, recorded, points, &found)?);
    }
    ensure!(!judged.is_empty(), "no compiler or interpreter of the language is here");
    Ok(judged)
}

fn run(folder: &Path, command: &[String]) -> anyhow::Result<()> {
    let (program, arguments) = command.split_first().context("a command has a program")?;
    let path = if program.starts_with("./") { folder.join(program) } else { program.into() };
    let output = Command::new(&path).args(arguments).current_dir(folder).output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{} failed:\n{said}", command.join(" "));
    Ok(())
}

/// For every formula the number of points, and the inputs of each, as little-endian doubles.
fn write_points(folder: &Path, points: &[Vec<Point>]) -> anyhow::Result<()> {
    let mut bytes = Vec::new();
    for points in points {
        bytes.extend(u64::try_from(points.len())?.to_le_bytes());
        bytes.extend(points.iter().flat_map(|point| &point.inputs).flat_map(|x| x.to_le_bytes()));
    }
    std::fs::write(folder.join("points.bin"), bytes)?;
    Ok(())
}

/// What the driver wrote: for every point a return code as a double, value, and Jacobian.
fn compare(
    toolchain: &Toolchain,
    recorded: &[Recorded],
    points: &[Vec<Point>],
    found: &[u8],
) -> anyhow::Result<Judged> {
    let mut found = found.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
    let mut judged = Judged { toolchain: toolchain.name, compared: 0, differ: 0, near: 0, refused: 0, worst: None };
    for (one, points) in recorded.iter().zip(points) {
        let numbers = one.graph.value.len() + one.graph.jacobian.len();
        for point in points {
            let code = found.next().context("the driver wrote too few results")?;
            let results: Vec<_> = found.by_ref().take(numbers).collect();
            ensure!(results.len() == numbers, "the driver wrote too few results");
            let Some(expected) = &point.results else {
                judged.refused += usize::from(code != 0.0);
                continue;
            };
            if code != 0.0 {
                judged.off(one, point, format!("refuses input {code}, which is valid"));
                continue;
            }
            for (k, (&found, &expected)) in results.iter().zip(expected).enumerate() {
                judged.number(toolchain, (one, point), k, [found, expected]);
            }
        }
    }
    Ok(judged)
}

impl Judged {
    fn number(
        &mut self,
        toolchain: &Toolchain,
        (one, point): (&Recorded, &Point),
        k: usize,
        [found, expected]: [f64; 2],
    ) {
        self.compared += 1;
        if found.to_bits() == expected.to_bits() {
            return;
        }
        let near = f64::EPSILON * toolchain.epsilons * (1.0 + expected.abs());
        if (found - expected).abs() <= near && has_functions(one) {
            self.near += 1;
            return;
        }
        self.off(one, point, format!("{}: {found:e}, expected {expected:e}", entry(one, k)));
    }

    fn off(&mut self, one: &Recorded, point: &Point, what: String) {
        self.differ += 1;
        self.worst.get_or_insert_with(|| format!("{} at {}: {what}", one.formula.spec().id, point.name));
    }
}

/// Whether a formula calls functions that languages round in their own ways.
fn has_functions(one: &Recorded) -> bool {
    use jointproof::graph::Unary::{ArcSine, Cosine, Exponential, ExponentialMinusOne, Sine};
    one.graph.ops().iter().any(|op| match op {
        Op::Unary(function, _) => matches!(function, Sine | Cosine | ArcSine | Exponential | ExponentialMinusOne),
        Op::Binary(operation, ..) => *operation == Binary::Angle,
        _ => false,
    })
}

/// The name of a component of the value, or of an entry of the Jacobian.
fn entry(one: &Recorded, k: usize) -> String {
    let names = |fields: &[Field]| -> Vec<String> {
        let of = |field: &Field| match field.len() {
            1 => vec![field.name.to_owned()],
            len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
        };
        fields.iter().flat_map(of).collect()
    };
    let (inputs, outputs) = (names(one.formula.inputs()), names(one.formula.outputs()));
    match k.checked_sub(outputs.len()) {
        None => outputs[k].clone(),
        Some(k) => format!("∂{}/∂{}", outputs[k / inputs.len()], inputs[k % inputs.len()]),
    }
}
