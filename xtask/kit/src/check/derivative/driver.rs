//! Programs that call a routine at the states asked for.

use super::super::driver::abi::around;
use super::spec::{Routine, Spec};
use crate::outcome::Usage;
use crate::template::filled;

/// The driver of a routine, after the name of its file.
///
/// # Errors
/// A program needs none.
pub(super) fn text(spec: &Spec) -> Result<(&'static str, String), Usage> {
    let (routine, template) = match spec.routine {
        Routine::Uel => ("UEL", include_str!("uel_at.f90")),
        Routine::Uelmat => ("UELMAT", include_str!("uel_at.f90")),
        Routine::Fric => ("FRIC", include_str!("fric_at.f90")),
        Routine::Program => {
            return Err(Usage(
                "--out: a program answers for itself; only `uel`, `uelmat` and `fric` have a driver".into(),
            ));
        }
    };
    let numbers = |numbers: &[f64]| -> Vec<String> { numbers.iter().map(|x| format!("{x:e}_dp")).collect() };
    let integers = |numbers: &[i32]| -> Vec<String> { numbers.iter().map(i32::to_string).collect() };
    let coords: Vec<f64> = spec.coords.iter().flatten().copied().collect();
    // An array has one number at least.
    let or_zero = |list: Vec<String>, zero: &str| if list.is_empty() { vec![zero.to_owned()] } else { list };
    let start: Vec<f64> = spec.increment.iter().zip(&spec.at).map(|(increment, at)| at - increment).collect();
    let start = if start.is_empty() { vec![0.0; spec.at.len()] } else { start };
    let [material, more] = match spec.routine {
        Routine::Uelmat => ["        character(len=80) :: materiallib = 'MATERIAL'\n", ", materiallib"],
        _ => ["", ""],
    };
    let values = [
        ("routine", routine.to_lowercase()),
        ("coords", listed(&or_zero(numbers(&coords), "0.0_dp"))),
        ("props", listed(&or_zero(numbers(&spec.props), "0.0_dp"))),
        ("jprops", listed(&or_zero(integers(&spec.jprops), "0"))),
        ("svars", listed(&or_zero(numbers(&spec.svars), "0.0_dp"))),
        ("start", listed(&numbers(&start))),
        ("material", material.to_owned()),
        ("more", more.to_owned()),
        ("tau", listed(&or_zero(numbers(&spec.tau), "0.0_dp"))),
        ("lflags", listed(&integers(&spec.lflags))),
        ("nnode", spec.coords.len().max(1).to_string()),
        ("mcrd", spec.coords.first().map_or(1, Vec::len).to_string()),
        ("nprops", spec.props.len().to_string()),
        ("njprop", spec.jprops.len().to_string()),
        ("nsvars", spec.svars.len().to_string()),
        ("jtype", spec.jtype.to_string()),
        ("dtime", format!("{:e}_dp", spec.dtime)),
    ];
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let template = filled(template, &values);
    let name = if spec.routine == Routine::Fric { "fric" } else { "uel" };
    let sizes = [spec.at.len(), spec.outputs()];
    Ok((name, around(routine, &template, sizes, "check --derivative FILE")))
}

/// Numbers of an array, a few in a line.
fn listed(numbers: &[String]) -> String {
    let lines: Vec<_> = numbers.chunks(4).map(|line| line.join(", ")).collect();
    format!("[{}]", lines.join(", &\n            "))
}
