//! Exports for programs in other languages: the points used for timing, and the times here.

use super::data::{Machine, Report};
use crate::console::{count, say};
use crate::files;
use anyhow::Context;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::measure::{Figures, Measurement, Options, Time};
use measuring::Build;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// The description of a file of points.
#[derive(Serialize)]
struct Description {
    formula: &'static str,
    /// The file of doubles.
    file: String,
    /// How to read it.
    layout: &'static str,
    /// The number of points.
    count: usize,
    /// Doubles per point.
    stride: usize,
    seed: u64,
    inputs: Vec<FieldDescription>,
    outputs: Vec<FieldDescription>,
}

#[derive(Serialize)]
struct FieldDescription {
    name: &'static str,
    shape: Vec<usize>,
    unit: String,
}

impl From<&Field> for FieldDescription {
    fn from(field: &Field) -> Self {
        let quantity = field.quantity;
        Self { name: field.name, shape: quantity.shape.dimensions(), unit: quantity.unit.to_string() }
    }
}

/// Writes `<id>.f64` and `<id>.json` for every formula.
pub(super) fn inputs(folder: &Path, formulas: &[&dyn AnyFormula], options: &Options) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    for formula in formulas {
        let id = formula.spec().id;
        let doubles = formula.timing_inputs(options);
        let file = format!("{id}.f64");
        let bytes: Vec<u8> = doubles.iter().flat_map(|x| x.to_le_bytes()).collect();
        let path = folder.join(&file);
        std::fs::write(&path, bytes).with_context(|| format!("cannot write {}", path.display()))?;
        let description = Description {
            formula: id,
            file,
            layout: "little-endian IEEE doubles without header; all inputs of the first point, then of the next",
            count: options.timing_points,
            stride: formula.inputs().iter().map(|field| field.quantity.shape.len()).sum(),
            seed: options.seed,
            inputs: formula.inputs().iter().map(Into::into).collect(),
            outputs: formula.outputs().iter().map(Into::into).collect(),
        };
        let text = serde_json::to_string_pretty(&description)? + "\n";
        files::write(&folder.join(format!("{id}.json")), &text)?;
    }
    say(&format!("wrote the points of {} into {}", count(formulas.len(), "formula"), folder.display()));
    Ok(())
}

/// Times of the closed form, for comparison with another program's.
#[derive(Serialize)]
struct Timing<'a> {
    created: &'a str,
    machine: &'a Machine,
    build: &'a Build,
    /// The number of points, which are those written by `--inputs`.
    points: usize,
    seed: u64,
    formulas: BTreeMap<&'a str, Nanoseconds<'a>>,
}

/// Nanoseconds per evaluation: the median, and the interval that contains four of five rounds.
#[derive(Serialize)]
struct Nanoseconds<'a> {
    value: Option<Time>,
    value_and_jacobian: Option<Time>,
    copy: Option<Time>,
    /// Value with Jacobian at a single hard point, by the name of the case.
    hard: BTreeMap<&'a str, Time>,
}

/// Writes the times of the closed forms.
pub(super) fn timing(path: &Path, report: &Report) -> anyhow::Result<()> {
    let timing = Timing {
        created: &report.created,
        machine: &report.machine,
        build: &report.build,
        points: report.options.timing_points,
        seed: report.options.seed,
        formulas: report.formulas.iter().map(|m| (m.formula.as_str(), of_formula(m))).collect(),
    };
    let path = std::path::absolute(path)?;
    files::write(&path, &(serde_json::to_string_pretty(&timing)? + "\n"))?;
    say(&format!("wrote times of {} into {}", count(report.formulas.len(), "formula"), path.display()));
    Ok(())
}

fn of_formula(measurement: &Measurement) -> Nanoseconds<'_> {
    let closed = measurement.method("closed");
    let (value, jacobian) =
        (closed.and_then(|method| method.value.as_ref()), closed.and_then(|method| method.jacobian.as_ref()));
    let time = |figures: Option<&Figures>| figures.and_then(|figures| figures.time);
    let hard = jacobian.into_iter().flat_map(|figures| &figures.hard_times);
    Nanoseconds {
        value: time(value),
        value_and_jacobian: time(jacobian),
        copy: measurement.copy,
        hard: hard.map(|point| (point.case.as_str(), point.time)).collect(),
    }
}
