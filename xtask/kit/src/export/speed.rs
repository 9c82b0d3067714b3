//! The time of the exported functions in C, compared with the formulas in Rust at the same points; both reject invalid
//! inputs.

use super::c::loops;
use super::recorded::{Recorded, Subject, stem};
use crate::console::{print, progress};
use crate::files;
use crate::project::Project;
use crate::report;
use crate::report::data::Report;
use anyhow::{Context, ensure};
use jointproof::formula::Spec;
use jointproof::toolkit::measure::Options;
use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

/// The compiler options for the comparison with Rust: those of the header, plus -O3 and link-time optimisation, as
/// calls may be inlined in Rust too.
const FLAGS: &str = "-std=c99 -O3 -flto -ffp-contract=off";
/// The number of runs of the C program before Rust's, and after it; the median of its times counts, as for Rust.
const ROUNDS: usize = 3;

/// Prints a table of times and ratios.
pub(super) fn compare<'a>(project: &Project, folder: &Path, recorded: &'a [Recorded]) -> anyhow::Result<()> {
    let options = Options::quick();
    let folder = &folder.canonicalize()?;
    let formula = |one: &'a Recorded| match one.subject {
        Subject::Formula(formula) => Some((one, formula)),
        Subject::Element(..) => None,
    };
    let (recorded, formulas): (Vec<_>, Vec<_>) = recorded.iter().filter_map(formula).unzip();
    for (name, text) in loops::files(&recorded) {
        files::write(&folder.join(name), &text)?;
    }
    for (one, formula) in recorded.iter().zip(&formulas) {
        let bytes: Vec<u8> = formula.timing_inputs(&options).iter().flat_map(|x| x.to_le_bytes()).collect();
        std::fs::write(folder.join(format!("{}.f64", stem(one))), bytes)?;
    }
    let flags = format!("CFLAGS={FLAGS}");
    ask(folder, "make", &["--quiet", "--always-make", "-j2", "speed", "CC=cc", &flags])?;
    let mut c = HashMap::<_, Vec<f64>>::new();
    let bar = progress("C", 2 * ROUNDS);
    let mut run = || -> anyhow::Result<()> {
        for _ in 0..ROUNDS {
            read(&ask(folder, "./speed", &[])?, &mut c)?;
            bar.inc(1);
        }
        Ok(())
    };
    run()?;
    let rust = report::measure(project, &formulas, options, report::OPTIMISED)?;
    run()?;
    bar.finish_and_clear();
    let mut rows = Vec::new();
    for (one, formula) in recorded.into_iter().zip(formulas) {
        let id = formula.spec().id;
        let time = checked(&rust, &formula.spec()).context("the report has the times of the checked call")?;
        let times = c.get_mut(&stem(one)).context("the program printed the time of every formula")?;
        rows.push((id, median(times), time));
    }
    print(&table(rows))
}

/// Times in C and in Rust, the worst of C first, with a summary.
#[expect(clippy::cast_precision_loss, reason = "formulas are few")]
fn table(mut rows: Vec<(&str, f64, f64)>) -> String {
    rows.sort_by(|a, b| (b.1 / b.2).total_cmp(&(a.1 / a.2)));
    let ratios: Vec<_> = rows.iter().map(|(_, c, rust)| c / rust).collect();
    let line = |((id, c, rust), ratio): (&(&str, f64, f64), &f64)| format!("{id:44} {c:8.1} {rust:10.1} {ratio:7.2}\n");
    let lines: String = rows.iter().zip(&ratios).map(line).collect();
    let power = (rows.len() as f64).recip();
    let mean: f64 = ratios.iter().map(|ratio| ratio.powf(power)).product();
    let within = ratios.iter().filter(|ratio| **ratio <= 1.15).count();
    format!(
        "formula                                        C, ns   Rust, ns   ratio\n{lines}{within} of {} at most 1.15; \
         geometric mean {mean:.2}\n",
        rows.len()
    )
}

/// The median, the larger one of two middle values.
fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Parses the output of the program: a name and a time per line.
fn read(printed: &str, times: &mut HashMap<String, Vec<f64>>) -> anyhow::Result<()> {
    for line in printed.lines() {
        let (name, time) = line.split_once(' ').context("the program prints names and times")?;
        times.entry(name.to_owned()).or_default().push(time.parse()?);
    }
    Ok(())
}

/// The time of the exported results of a formula in Rust, in nanoseconds, with invalid inputs rejected: value and
/// Jacobian, or the value if the Jacobian is automatic.
fn checked(report: &Report, spec: &Spec) -> Option<f64> {
    let measured = report.formulas.iter().find(|measured| measured.formula == spec.id)?;
    let method = measured.method("checked")?;
    let figures = if spec.is_closed() { method.jacobian.as_ref()? } else { method.value.as_ref()? };
    figures.time.map(|time| time.median)
}

fn ask(folder: &Path, program: &str, arguments: &[&str]) -> anyhow::Result<String> {
    let path = if program.starts_with("./") { folder.join(program) } else { program.into() };
    let output = Command::new(&path).args(arguments).current_dir(folder).output();
    let output = output.with_context(|| format!("{} cannot be started", path.display()))?;
    ensure!(output.status.success(), "{program} failed:\n{}", String::from_utf8_lossy(&output.stderr));
    Ok(String::from_utf8(output.stdout)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::formula::Document;

    #[test]
    fn a_time_is_read_from_every_line() {
        let mut times = HashMap::new();
        read("a 1.5\nb 2\n", &mut times).unwrap();
        read("a 0.5\n", &mut times).unwrap();
        assert_eq!(times, HashMap::from([("a".into(), vec![1.5, 0.5]), ("b".into(), vec![2.0])]));
        assert_eq!(read("a", &mut times).unwrap_err().to_string(), "the program prints names and times");
    }

    #[test]
    fn as_many_times_are_below_the_one_in_the_middle_as_above() {
        assert_eq!(median(&mut [5.0, 1.0, 40.0, 2.0, 3.0]), 3.0);
        assert_eq!(median(&mut [4.0, 1.0, 3.0, 2.0]), 3.0);
    }

    #[test]
    fn the_worst_of_c_is_first_and_the_mean_is_of_ratios() {
        let rows = vec![("b.even", 3.0, 3.0), ("a.worst", 40.0, 10.0), ("d.bound", 1.15, 1.0), ("c.best", 10.0, 46.0)];
        let expected = "\
formula                                        C, ns   Rust, ns   ratio
a.worst                                          40.0       10.0    4.00
d.bound                                           1.1        1.0    1.15
b.even                                            3.0        3.0    1.00
c.best                                           10.0       46.0    0.22
3 of 4 at most 1.15; geometric mean 1.00
";
        assert_eq!(table(rows), expected);
    }

    #[test]
    fn each_formula_has_its_own_time() {
        let report = crate::sample::report();
        let spec = |id| Spec::new(id, "", Document::new("Notes").printed(""));
        let times = ["t.first", "u.second", "v.third"].map(|id| checked(&report, &spec(id).eta(1.0, 1.0)));
        assert_eq!(times, [Some(13.0 * 2.5), Some(13e3 * 2.5), None]);
        let value = report.formulas[0].method("checked").unwrap().value.as_ref().unwrap().time.unwrap().median;
        assert_eq!(checked(&report, &spec("t.first")), Some(value));
    }
}
