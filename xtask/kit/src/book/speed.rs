//! Speed and error: the part of an entry about the last report, and the parts of the chapter.

use super::content::Entry;
use super::downloads;
use super::html::{each, escape, number, relative, row, table};
use super::pages::{Pages, Place};
use crate::report::data::Report;
use crate::report::tables::{duration, spread, step};
use crate::report::verdict::Verdict;
use crate::report::{plot, price, spread};
use jointproof::toolkit::measure::{Errors, Figures, Measurement, MethodFigures, Scheme, Time};

/// The folded part of an entry.
pub(crate) fn folded(pages: &Pages<'_>, entry: &Entry) -> String {
    let Some(measurement) = pages.content.report.as_ref().and_then(|report| report.formula(&entry.id)) else {
        return String::new();
    };
    let summary = Verdict::of(measurement).map_or(String::new(), |verdict| {
        let time = measurement.method("closed").and_then(|method| method.jacobian.as_ref()?.time);
        let time = time.map_or(String::new(), |time| duration(time.median));
        format!(": value and Jacobian in {time}, by automatic differentiation {}", times(verdict.speedup))
    });
    let plots = format!("{}{}", plot::plane(measurement), plot::curve(measurement));
    let plots = pages.later.keep(&format!("<div class=\"plots\">{plots}</div>"), "");
    format!(
        "<details class=\"speed\"><summary>Speed against error{summary}</summary>{plots}{}</details>",
        methods(measurement)
    )
}

/// `7.1 times as long`
fn times(ratio: f64) -> String {
    format!("{} times as long", number(ratio))
}

/// One row per method.
fn methods(measurement: &Measurement) -> String {
    let head =
        ["Method", "Value", "With Jacobian", "Spread", "η of value", "hard", "η of Jacobian", "hard", "Relative"];
    let rows = each(&measurement.methods, |method| {
        let (value, jacobian) = (method.value.as_ref(), method.jacobian.as_ref());
        let together = jacobian.and_then(|figures| figures.time);
        row(&[
            ("", escape(&format!("{}{}", method.title, step(method)))),
            ("figure", time(value.and_then(|figures| figures.time))),
            ("figure", time(together)),
            ("figure", together.map_or(String::new(), spread)),
            ("figure", worst(value.map(|figures| &figures.random))),
            ("figure", worst(value.and_then(|figures| figures.hard.as_ref()))),
            ("figure", worst(jacobian.map(|figures| &figures.random))),
            ("figure", worst(jacobian.and_then(|figures| figures.hard.as_ref()))),
            ("figure", jacobian.map_or(String::new(), |figures| number(figures.random.relative))),
        ])
    });
    table("speed", &head, &rows)
}

fn time(time: Option<Time>) -> String {
    time.map_or("–".into(), |time| duration(time.median))
}

/// The largest η, and the number of points without a result.
fn worst(errors: Option<&Errors>) -> String {
    match errors {
        None => "–".into(),
        // Beyond 2⁵³ no digit is right; if the exact number is 0, any other result has an unbounded η.
        Some(Errors { not_finite: 0, eta, .. }) if eta.max > 1e18 => "no digit right".into(),
        Some(Errors { not_finite: 0, eta, .. }) => number(eta.max),
        Some(Errors { not_finite, points, .. }) if not_finite == points => "not finite".into(),
        Some(Errors { not_finite, points, eta, .. }) => {
            format!("{}; not finite at {not_finite} of {points}", number(eta.max))
        }
    }
}

/// The parts of the chapter, by the argument of `{{#speed …}}`; a family may follow, as in `{{#speed own slider}}`.
pub(crate) const PARTS: &str = "speed all, speed methods, speed about, speed verdict, speed overviews, speed table, speed differences and speed own";

/// One part of the chapter, for all formulas or for a family; `None` if there is no such part.
pub(crate) fn part(pages: &Pages<'_>, at: &Place, argument: &str) -> Option<String> {
    let (name, family) = argument.split_once(' ').unwrap_or((argument, ""));
    let part: fn(&Pages<'_>, &Place, &Report) -> String = match name {
        "all" => all,
        "methods" => |_, _, report| every_method(report),
        "about" => |pages, _, report| about(report, pages.content.is_current),
        "verdict" => verdict,
        "overviews" => |pages, _, report| overviews(pages, report),
        "table" => overall,
        "differences" => |_, _, report| differences(report),
        "own" => own,
        _ => return None,
    };
    Some(match &pages.content.report {
        Some(report) if family.is_empty() => part(pages, at, report),
        Some(report) => part(pages, at, &report.of_family(family)),
        None => "<p class=\"missing\">Not measured; run the command <code>report</code>.</p>".into(),
    })
}

/// The name of the report as a table of numbers, among the downloads.
pub(crate) const CSV: &str = "speed.csv";

/// The picture above in numbers: medians over the formulas, and of time and error a tenth and nine tenths.
fn every_method(report: &Report) -> String {
    let range = |[low, middle, high]: spread::Quantiles| {
        format!("<b>{}</b><br>{} to {}", number(middle), number(low), number(high))
    };
    let rows = each(spread::spreads(report), |spread| {
        row(&[
            ("", escape(&spread.title)),
            ("figure", spread.evaluations.into()),
            ("figure", number(spread.times[1])),
            ("figure", range(spread.ratios)),
            ("figure", number(spread.each[1])),
            ("figure", range(spread.errors)),
        ])
    });
    let head =
        ["Method", "Evaluations", "Time, ns", "Closed form = 1", "For each evaluation, value = 1", "Relative error"];
    table("speed", &head, &rows)
}

/// The picture of all methods over all formulas.
fn all(pages: &Pages<'_>, at: &Place, report: &Report) -> String {
    let picture = plot::all(&spread::spreads(report));
    let picture = pages.later.keep(&format!("<div class=\"plots wide\">{picture}</div>"), "");
    let data = escape(&relative(&at.page, &format!("{}/{CSV}", downloads::FOLDER)));
    format!(
        "<figure id=\"speed-all\">{picture}<figcaption>Every method over all {} formulas: a mark at the medians of time and \
         error, bars from a tenth of the formulas to nine tenths, a dot for each formula. \
         <a href=\"{data}\" download>The data (CSV)</a>.</figcaption></figure>",
        report.formulas.len()
    )
}

/// When and where the report was made.
fn about(report: &Report, is_current: bool) -> String {
    let Report { created, machine, build, options, .. } = report;
    let flags = match &*build.flags {
        "" => "no other flags".to_owned(),
        flags => format!("the flags <code>{}</code>", escape(flags)),
    };
    let version = if is_current { "this version" } else { "<b>another version</b>" };
    let processor = escape(&machine.processor);
    format!(
        "<p>All figures on this page and in the entries are from one run, on {version} of the code: {created}, on {processor} \
         with {} cores, built by {} for {} (profile {}, {flags}); at {} random points of seed {} and at every hard point, \
         timed over {} points in {} rounds.</p>",
        machine.cores,
        escape(&build.compiler),
        escape(&build.target),
        escape(&build.profile),
        options.random_points,
        options.seed,
        options.timing_points,
        options.rounds,
    )
}

/// Whether the closed form is faster than automatic differentiation and at least as accurate, and the exceptions.
fn verdict(pages: &Pages<'_>, at: &Place, report: &Report) -> String {
    let verdicts = report.formulas.iter().filter_map(|measurement| Some((measurement, Verdict::of(measurement)?)));
    let verdicts: Vec<_> = verdicts.collect();
    let mut speedups: Vec<f64> = verdicts.iter().map(|(_, verdict)| verdict.speedup).collect();
    speedups.sort_by(f64::total_cmp);
    let exceptions: Vec<_> = verdicts.iter().filter(|(_, verdict)| !verdict.holds()).collect();
    let held = verdicts.len() - exceptions.len();
    let range = match speedups.as_slice() {
        [] => String::new(),
        [least, .., most] => format!(
            " Automatic differentiation takes between {} and {} times the time of the closed form, in the median {}.",
            number(*least),
            number(*most),
            number(speedups[speedups.len() / 2])
        ),
        [only] => format!(" Automatic differentiation takes {} times the time of the closed form.", number(*only)),
    };
    let mut out = format!(
        "<p>The closed form is faster than automatic differentiation and at least as accurate for <b>{held}</b> of {} formulas.{range}</p>",
        verdicts.len()
    );
    if !exceptions.is_empty() {
        let rows = each(exceptions, |(measurement, verdict)| {
            row(&[("", pages.link(&at.page, &measurement.formula)), ("wide", escape(&verdict.exception()))])
        });
        out += &table("speed", &["Not so for", "because"], &rows);
    }
    out + &price::summary(report).map_or(String::new(), |summary| format!("<p>{}</p>", escape(&summary)))
}

/// A plot for every family.
fn overviews(pages: &Pages<'_>, report: &Report) -> String {
    let family = |measurement: &Measurement| measurement.formula.split('.').next().unwrap_or_default().to_owned();
    let mut families: Vec<(String, Vec<&Measurement>)> = Vec::new();
    for measurement in &report.formulas {
        match families.iter_mut().find(|(name, _)| *name == family(measurement)) {
            Some((_, members)) => members.push(measurement),
            None => families.push((family(measurement), vec![measurement])),
        }
    }
    each(families, |(name, members)| {
        let svg = pages.later.keep(&format!("<div class=\"plots wide\">{}</div>", plot::overview(&name, &members)), "");
        format!("<figure id=\"speed-{name}\">{svg}</figure>")
    })
}

/// One row per formula.
fn overall(pages: &Pages<'_>, at: &Place, report: &Report) -> String {
    let head = [
        "Formula",
        "Copying",
        "Value",
        "With Jacobian",
        "Spread",
        "Checked",
        "Hardest",
        "Single",
        "AD",
        "Central",
        "237 bits",
        "η Jacobian, AD",
        "Faster, as accurate",
    ];
    let rows = each(&report.formulas, |measurement| {
        let jacobian = |id| measurement.method(id).and_then(|method| method.jacobian.as_ref());
        let together = |id| jacobian(id).and_then(|figures: &Figures| figures.time);
        let closed = together("closed");
        let ratio = |id| match (closed, together(id)) {
            (Some(closed), Some(time)) => format!("× {}", number(time.median / closed.median)),
            _ => "–".into(),
        };
        let eta = |id| jacobian(id).map_or("–".into(), |figures| number(figures.random.eta.max));
        let value =
            measurement.method("closed").and_then(|method| method.value.as_ref()).and_then(|figures| figures.time);
        row(&[
            ("", pages.link(&at.page, &measurement.formula)),
            ("figure", time(measurement.copy)),
            ("figure", time(value)),
            ("figure", time(closed)),
            ("figure", closed.map_or(String::new(), spread)),
            ("figure", ratio("checked")),
            ("figure", hardest(measurement)),
            ("figure", ratio("single")),
            ("figure", ratio("ad")),
            ("figure", ratio("central")),
            ("figure", ratio("octuple")),
            ("figure", format!("{}, {}", eta("closed"), eta("ad"))),
            ("", Verdict::of(measurement).map_or("–", |verdict| verdict.in_short()).into()),
        ])
    });
    table("speed", &head, &rows)
}

/// The time at the hardest ordinary point relative to that at random ones, and the name of the point.
fn hardest(measurement: &Measurement) -> String {
    price::hardest(measurement).map_or("–".into(), |(_, point)| {
        format!("<span title=\"{}\">× {}</span>", escape(&point.case), number(point.ratio.median))
    })
}

/// The best accuracy of differences, over all formulas.
fn differences(report: &Report) -> String {
    let rows = each(Scheme::ALL, |scheme| {
        let best = |measurement: &Measurement| {
            let curve = measurement.curves.iter().find(|curve| curve.scheme == scheme)?;
            // For a formula linear in its inputs there is no truncation error, and any step is best.
            curve.best().filter(|(_, error)| *error > 0.0)
        };
        let best: Vec<_> = report.formulas.iter().filter_map(best).collect();
        let median = |of: fn(&(f64, f64)) -> f64| {
            let mut sorted: Vec<f64> = best.iter().map(of).collect();
            sorted.sort_by(f64::total_cmp);
            sorted.get(sorted.len() / 2).map_or("–".into(), |&x| number(x))
        };
        let worst = best.iter().map(|best| best.1).fold(0.0, f64::max);
        row(&[
            ("", scheme.title().into()),
            ("figure", median(|best| best.0)),
            ("figure", median(|best| best.1)),
            ("figure", number(worst)),
        ])
    });
    table("speed", &["Scheme", "Best step", "Relative error there", "of the worst formula"], &rows)
}

/// The formulas with additional methods, naive ones or those of the document, compared with the closed form.
fn own(pages: &Pages<'_>, at: &Place, report: &Report) -> String {
    let others = |measurement: &'_ Measurement| -> Vec<MethodFigures> {
        measurement.methods.iter().filter(|method| !spread::is_common(&method.id)).cloned().collect()
    };
    let mut rows = String::new();
    for measurement in &report.formulas {
        let others = others(measurement);
        let Some(closed) = measurement.method("closed").filter(|_| !others.is_empty()) else { continue };
        for method in std::iter::once(closed).chain(&others) {
            let (value, jacobian) = (method.value.as_ref(), method.jacobian.as_ref());
            rows += &row(&[
                ("", pages.link(&at.page, &measurement.formula)),
                ("wide", escape(&method.title)),
                ("figure", time(value.and_then(|figures| figures.time))),
                ("figure", worst(value.map(|figures| &figures.random))),
                ("figure", worst(value.and_then(|figures| figures.hard.as_ref()))),
                ("figure", time(jacobian.and_then(|figures| figures.time))),
                ("figure", worst(jacobian.and_then(|figures| figures.hard.as_ref()))),
            ]);
        }
    }
    let head =
        ["Formula", "Method", "Value", "η of value", "at hard points", "With Jacobian", "η of Jacobian at hard points"];
    table("speed", &head, &rows)
}
