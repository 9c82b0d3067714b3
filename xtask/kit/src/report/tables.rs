//! A report in words and columns.

use super::data::Report;
use super::price;
use super::verdict::Verdict;
use crate::console::{bold, figure, green, red};
use jointproof::toolkit::measure::{Columns, Errors, Measurement, MethodFigures, Time};
use std::fmt::Write;

/// Nanoseconds with three digits, in a suitable unit.
pub(crate) fn duration(nanoseconds: f64) -> String {
    let (number, unit) = match nanoseconds {
        t if t < 1e3 => (t, "ns"),
        t if t < 1e6 => (t / 1e3, "µs"),
        t => (t / 1e6, "ms"),
    };
    let digits = match number {
        x if x < 9.995 => 2,
        x if x < 99.95 => 1,
        _ => 0,
    };
    format!("{number:.digits$} {unit}")
}

/// The deviation of four of five rounds from the median, in percent.
pub(crate) fn spread(time: Time) -> String {
    let off = (time.high - time.median).max(time.median - time.low);
    format!("±{:.0}%", 100.0 * off / time.median)
}

/// The largest error, and the number of points without one.
pub(crate) fn worst(errors: Option<Errors>) -> String {
    match errors {
        None => "–".into(),
        Some(Errors { not_finite: 0, eta, .. }) => figure(eta.max),
        Some(Errors { not_finite, points, .. }) if not_finite == points => "not finite".into(),
        Some(Errors { not_finite, eta, .. }) => format!("{}, {not_finite} not finite", figure(eta.max)),
    }
}

/// The step of differences, as appended to their name.
pub(crate) fn step(method: &MethodFigures) -> String {
    method.step.map_or(String::new(), |step| format!(", step {}", figure(step)))
}

/// The cells of a method: value, value and Jacobian, its spread, ratio, errors of the value and of the Jacobian.
fn cells(method: &MethodFigures) -> [String; 11] {
    let time = |time: Option<Time>| time.map_or("–".into(), |time| duration(time.median));
    let value = method.value.as_ref();
    let jacobian = method.jacobian.as_ref();
    let together = jacobian.and_then(|figures| figures.time);
    let random = jacobian.map(|figures| figures.random);
    let eta = |of: fn(&Errors) -> f64| random.as_ref().map_or("–".into(), |random| figure(of(random)));
    [
        format!("{}{}", method.title, step(method)),
        time(value.and_then(|figures| figures.time)),
        time(together),
        together.map_or(String::new(), spread),
        jacobian.and_then(|figures| figures.ratio).map_or("–".into(), |ratio| figure(ratio.median)),
        worst(value.map(|figures| figures.random)),
        worst(value.and_then(|figures| figures.hard)),
        eta(|errors| errors.eta.median),
        worst(random),
        worst(jacobian.and_then(|figures| figures.hard)),
        eta(|errors| errors.relative),
    ]
}

const HEAD: [&str; 11] = [
    "method",
    "value",
    "with Jacobian",
    "spread",
    "ratio",
    "η value",
    "hard",
    "η Jacobian median",
    "worst",
    "hard",
    "relative",
];

/// What is said of the bounds of a formula, if it is known.
pub(super) type Accuracy<'a> = &'a dyn Fn(&str) -> Option<String>;

pub(super) fn text(report: &Report, accuracy: Accuracy<'_>) -> anyhow::Result<String> {
    let mut text = String::new();
    for measurement in &report.formulas {
        let Measurement { formula, inputs, outputs, random_points, hard_points, .. } = measurement;
        let copy =
            measurement.copy.map_or(String::new(), |copy| format!("; copying all takes {}", duration(copy.median)));
        writeln!(text, "{} {outputs} outputs of {inputs} inputs{copy}", bold(formula))?;
        writeln!(text, "  errors at {random_points} random and {hard_points} hard points")?;
        if let Some(said) = accuracy(formula) {
            writeln!(text, "  {said}")?;
        }
        let rows: Vec<_> = measurement.methods.iter().map(cells).collect();
        let width = |k: usize| {
            let cells = rows.iter().map(|row| row[k].chars().count());
            cells.chain([HEAD[k].chars().count()]).max().unwrap_or(0)
        };
        for row in std::iter::once(&HEAD.map(String::from)).chain(&rows) {
            let first = format!("{:<w$}", row[0], w = width(0));
            let rest: Vec<_> = (1..row.len()).map(|k| format!("{:>w$}", row[k], w = width(k))).collect();
            writeln!(text, "    {first}  {}", rest.join("  "))?;
        }
        if let Some(columns) = &measurement.columns {
            writeln!(text, "    {}", many(columns))?;
        }
        if let Some(verdict) = Verdict::of(measurement) {
            let (mark, why) = if verdict.holds() {
                (green("yes"), format!("automatic differentiation takes {:.1} times as long", verdict.speedup))
            } else {
                (red("not quite"), verdict.exception())
            };
            writeln!(text, "    closed form faster and at least as accurate: {mark}, {why}")?;
        }
        if let Some(said) = price::said(measurement) {
            writeln!(text, "    {said}")?;
        }
        text.push('\n');
    }
    text += &footer(report);
    Ok(text)
}

/// The times for batches of points.
fn many(columns: &Columns) -> String {
    let Columns { rows, bytes, threads, looped, one_thread, all_threads, .. } = columns;
    format!(
        "{rows} rows of columns, {bytes} bytes each: a loop {}; a batch {}, that is {:.2} of the loop and {:.1} of a copy; \
         with {threads} threads {}, {:.2} and {:.1}",
        duration(looped.median),
        duration(one_thread.median),
        columns.one_over_loop.median,
        columns.one_over_copy.median,
        duration(all_threads.median),
        columns.all_over_loop.median,
        columns.all_over_copy.median,
    )
}

/// The meaning of the columns, and the origin of the numbers.
fn footer(report: &Report) -> String {
    let Report { created, machine, build, options, .. } = report;
    let flags = if build.flags.is_empty() { "default flags" } else { &build.flags };
    let prices = price::summary(report).map_or(String::new(), |summary| summary + "\n");
    format!(
        "{prices}Times are medians of up to {} interleaved rounds over {} points; the spread holds four of five rounds.\n\
         The ratio is to the closed form's value alone. η is in units of 2^-53, each point counting by its worst entry.\n\
         {created}, {} ({} cores), {}, {} {}, {flags}, seed {}\n",
        options.rounds,
        options.timing_points,
        machine.processor,
        machine.cores,
        build.compiler,
        build.target,
        build.profile,
        options.seed,
    )
}

pub(super) fn markdown(report: &Report, accuracy: Accuracy<'_>) -> anyhow::Result<String> {
    let mut text = String::from("## Speed against error\n\n");
    for measurement in &report.formulas {
        writeln!(text, "### `{}`\n", measurement.formula)?;
        writeln!(text, "| {} |\n|---|{}", HEAD.join(" | "), "--:|".repeat(HEAD.len() - 1))?;
        for method in &measurement.methods {
            writeln!(text, "| {} |", cells(method).join(" | "))?;
        }
        if let Some(said) = accuracy(&measurement.formula) {
            writeln!(text, "\nThe closed form, {said}.")?;
        }
        if let Some(columns) = &measurement.columns {
            writeln!(text, "\n{}.", many(columns))?;
        }
        if let Some(said) = price::said(measurement) {
            writeln!(text, "\nThe closed form: {said}.")?;
        }
        text.push('\n');
    }
    text += &footer(report);
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect_file;
    use jointproof::toolkit::measure::Quantiles;

    const BOUNDS: &dyn Fn(&str) -> Option<String> =
        &|_| Some("value: η ≤ 4, measured; Jacobian: η ≤ 5/3, proved".into());

    #[test]
    fn durations_have_three_digits_and_a_fitting_unit() {
        let shown = [0.5124, 9.99, 12.34, 456.7, 1e3, 1234.0, 1e6, 2.5e7].map(duration);
        assert_eq!(shown, ["0.51 ns", "9.99 ns", "12.3 ns", "457 ns", "1.00 µs", "1.23 µs", "1.00 ms", "25.0 ms"]);
        // Numbers that would round to four digits.
        let shown = [9.995, 10.5, 99.94, 99.95, 100.4].map(duration);
        assert_eq!(shown, ["10.0 ns", "10.5 ns", "99.9 ns", "100 ns", "100 ns"]);
    }

    #[test]
    fn a_report_says_what_was_measured() {
        let report = crate::sample::report();
        let plain = |text: String| anstream::adapter::strip_str(&text).to_string();
        expect_file!["../../tests/printed/report.txt"].assert_eq(&plain(text(&report, BOUNDS).unwrap()));
        expect_file!["../../tests/printed/report.md"].assert_eq(&plain(markdown(&report, BOUNDS).unwrap()));
    }

    #[test]
    fn a_spread_is_the_larger_side() {
        assert_eq!(spread(Time { low: 9.0, median: 10.0, high: 10.5 }), "±10%");
        assert_eq!(spread(Time { low: 9.0, median: 10.0, high: 20.0 }), "±100%");
    }

    #[test]
    fn the_worst_error_says_where_there_is_none() {
        let eta = Quantiles { median: 1.0, p99: 2.0, max: 3.0 };
        let errors = |not_finite| Some(Errors { points: 9, not_finite, eta, relative: 0.0 });
        let shown = [None, errors(0), errors(1), errors(8), errors(9)].map(worst);
        assert_eq!(shown, ["–", "3.00", "3.00, 1 not finite", "3.00, 8 not finite", "not finite"]);
    }

    #[test]
    fn many_points_at_once_have_a_line() {
        let time = |median| Time { median, low: 0.5 * median, high: 2.0 * median };
        let [looped, one_thread, all_threads] = [50.0, 20.0, 10.0].map(time);
        let [one_over_loop, all_over_loop, one_over_copy, all_over_copy] = [0.4, 0.2, 2.5, 5.5].map(time);
        let mut report = crate::sample::report();
        report.formulas[1].columns = Some(Columns {
            rows: 300,
            bytes: 40,
            threads: 3,
            looped,
            one_thread,
            all_threads,
            one_over_loop,
            all_over_loop,
            one_over_copy,
            all_over_copy,
        });
        report.build.flags = "-C something".into();
        let line = "300 rows of columns, 40 bytes each: a loop 50.0 ns; a batch 20.0 ns, that is 0.40 of the loop and 2.5 of a \
                    copy; with 3 threads 10.0 ns, 0.20 and 5.5";
        for (text, line) in [
            (text(&report, BOUNDS).unwrap(), format!("\n    {line}\n")),
            (markdown(&report, BOUNDS).unwrap(), format!("\n\n{line}.\n")),
        ] {
            assert_eq!(text.matches(&line).count(), 1, "{text}");
            assert!(text.contains("a target a profile, -C something, seed 9\n"), "{text}");
        }
    }
}
