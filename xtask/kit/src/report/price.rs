//! The cost of checks, and of the hardest points.

use super::data::Report;
use crate::console::figure;
use jointproof::toolkit::measure::{Measurement, PointTime};

/// The bound claimed for every formula: time at the hardest ordinary point, relative to that at random ones.
pub(crate) const HARDEST: f64 = 10.0;

/// Time of the checked value and Jacobian relative to the unchecked.
pub(crate) fn of_checks(measurement: &Measurement) -> Option<f64> {
    let time = |id| Some(measurement.method(id)?.jacobian.as_ref()?.time?.median);
    Some(time("checked")? / time("closed")?)
}

/// The ordinary point at which the closed form takes longest, and whether that is the value or the value with Jacobian.
pub(crate) fn hardest(measurement: &Measurement) -> Option<(&'static str, &PointTime)> {
    let closed = measurement.method("closed")?;
    let parts = [("value", &closed.value), ("value and Jacobian", &closed.jacobian)];
    let points = parts.into_iter().filter_map(|(part, figures)| Some((part, figures.as_ref()?.hardest()?)));
    points.max_by(|a, b| a.1.ratio.median.total_cmp(&b.1.ratio.median))
}

/// The sentence about one formula.
pub(crate) fn said(measurement: &Measurement) -> Option<String> {
    let checks = of_checks(measurement)?;
    let hardest = hardest(measurement).map_or(String::new(), |(part, point)| {
        let ratio = figure(point.ratio.median);
        format!(
            "; at its hardest ordinary point, {}, the {part} takes {ratio} times as long as at random ones",
            point.case
        )
    });
    Some(format!("checked, value and Jacobian take {checks:.2} times as long{hardest}"))
}

/// The sentence about all formulas.
pub(crate) fn summary(report: &Report) -> Option<String> {
    let mut checks: Vec<_> = report.formulas.iter().filter_map(|one| Some((of_checks(one)?, one))).collect();
    checks.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (worst, dearest) = checks.last()?;
    let mean =
        (checks.iter().map(|(ratio, _)| ratio.ln()).sum::<f64>() / f64::from(u32::try_from(checks.len()).ok()?)).exp();
    let beyond = report.formulas.iter().filter_map(|one| Some((one, hardest(one)?)));
    let beyond: Vec<_> = beyond
        .filter(|(_, (_, point))| point.ratio.median > HARDEST)
        .map(|(one, (_, point))| format!("{} at {} ({})", one.formula, point.case, figure(point.ratio.median)))
        .collect();
    let beyond = if beyond.is_empty() { "none".to_owned() } else { beyond.join(", ") };
    Some(format!(
        "Checks: value and Jacobian take {mean:.2} times as long in the geometric mean, {worst:.2} times in the worst \
         ({}). Above {HARDEST} times the time of random points at an ordinary hard one: {beyond}.",
        dearest.formula
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A report in which the closed form of the first formula takes this many times as long at its ordinary hard point.
    fn with(value: f64, jacobian: f64) -> Report {
        let mut report = crate::sample::report();
        let closed = &mut report.formulas[0].methods[0];
        for (figures, ratio) in [(&mut closed.value, value), (&mut closed.jacobian, jacobian)] {
            figures.as_mut().unwrap().hard_times[0].ratio.median = ratio;
        }
        report
    }

    #[test]
    fn the_hardest_point_is_an_ordinary_one_of_value_or_jacobian() {
        for (value, jacobian, expected) in [(3.0, 2.0, ("value", 3.0)), (2.0, 4.0, ("value and Jacobian", 4.0))] {
            let report = with(value, jacobian);
            let (part, point) = hardest(&report.formulas[0]).unwrap();
            assert_eq!((part, point.ratio.median, point.case.as_str()), (expected.0, expected.1, "near"));
            let said = said(&report.formulas[0]).unwrap();
            let expected = format!(
                "checked, value and Jacobian take 1.18 times as long; at its hardest ordinary point, near, the {part} takes \
                 {:.2} times as long as at random ones",
                expected.1
            );
            assert_eq!(said, expected);
        }
        let mut nothing = with(1.0, 1.0).formulas.remove(0);
        for figures in nothing.methods.iter_mut().flat_map(|method| [&mut method.value, &mut method.jacobian]).flatten()
        {
            figures.hard_times.clear();
        }
        assert_eq!(said(&nothing).unwrap(), "checked, value and Jacobian take 1.18 times as long");
        nothing.methods.remove(1);
        assert_eq!(said(&nothing), None);
    }

    #[test]
    fn what_takes_more_than_ten_times_as_long_is_named() {
        let said = |value, jacobian| summary(&with(value, jacobian)).unwrap();
        for (value, jacobian) in [(1.0, 1.0), (10.0, 1.0), (10.0, 10.0)] {
            let said = said(value, jacobian);
            assert!(
                said.ends_with("Above 10 times the time of random points at an ordinary hard one: none."),
                "{said}"
            );
        }
        for (value, jacobian, named) in [(10.5, 1.0, "(10.50)"), (11.0, 12.0, "(12.00)")] {
            let said = said(value, jacobian);
            assert!(said.ends_with(&format!("at an ordinary hard one: t.first at near {named}.")), "{said}");
        }
        let mut both = with(20.0, 1.0);
        both.formulas[1] = both.formulas[0].clone();
        assert!(summary(&both).unwrap().ends_with("t.first at near (20.00), t.first at near (20.00)."));
    }

    /// The geometric mean of 2 and 8 is 4.
    #[test]
    fn the_price_of_checks_is_a_mean_and_the_worst() {
        let mut report = crate::sample::report();
        for (measurement, price) in report.formulas.iter_mut().zip([8.0, 2.0]) {
            for (id, factor) in [("closed", 1.0), ("checked", price)] {
                let method = measurement.methods.iter_mut().find(|method| method.id == id).unwrap();
                method.jacobian.as_mut().unwrap().time.as_mut().unwrap().median = 3.0 * factor;
            }
        }
        let said = summary(&report).unwrap();
        let expected = "Checks: value and Jacobian take 4.00 times as long in the geometric mean, 8.00 times in the worst (t.first).";
        assert!(said.starts_with(expected), "{said}");
        report.formulas.clear();
        assert_eq!(summary(&report), None);
    }
}
