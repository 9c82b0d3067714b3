//! `--against`: finds what became slower or less accurate beyond the noise.
//!
//! Times of two runs differ as a whole if the machine was busier, or is another one. This drift is the median, over all formulas,
//! of the ratios for copying and for the yardstick, which contain none of the code compared; the old times are multiplied by it.
//! A remaining difference of more than both spreads, and of more than a tenth, is a change.
//!
//! Errors are exact results for fixed points, so they are compared directly if both runs had the same points, and otherwise by
//! medians only, with a factor of two for the different points.

use super::data::Report;
use super::tables::duration;
use crate::console::{bold, figure, green, red};
use jointproof::toolkit::measure::{Errors, Figures, Measurement, MethodFigures, Time};

/// The differences of two reports.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Comparison {
    /// The ratio of new to old times of code that did not change.
    pub(crate) drift: f64,
    /// Formulas in both reports.
    pub(crate) formulas: usize,
    /// What became worse.
    pub(crate) changes: Vec<Change>,
    /// Obstacles to a full comparison.
    pub(crate) notes: Vec<String>,
}

/// One result that became worse.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Change {
    /// The formula, the method, and the quantity.
    pub(crate) what: String,
    /// `slower`, `less accurate`, `fails at more points`, `missing`.
    pub(crate) how: &'static str,
    /// Before and now.
    pub(crate) figures: String,
}

impl Change {
    fn missing(what: String) -> Self {
        Self { what, how: "missing", figures: "no longer measured".into() }
    }
}

/// Relative changes below this are ignored.
const LEAST: f64 = 1.1;
/// Time differences below this are ignored: a cycle or two.
const LEAST_NS: f64 = 0.5;
/// Differences of η below this are ignored.
const LEAST_ETA: f64 = 0.05;

/// Compares the selected formulas.
pub(crate) fn compare(old: &Report, new: &Report, is_asked: impl Fn(&str) -> bool) -> Comparison {
    let pairs: Vec<_> = new.formulas.iter().filter_map(|now| Some((old.formula(&now.formula)?, now))).collect();
    let mut notes = Vec::new();
    let drift = drift(&pairs).unwrap_or_else(|| {
        notes.push("no times in common: only errors are compared".to_owned());
        1.0
    });
    if old.machine != new.machine || old.build != new.build {
        notes.push("the machine or the build is another one; times are compared after scaling".to_owned());
    }
    let same_points = old.options.seed == new.options.seed && old.options.random_points == new.options.random_points;
    if !same_points {
        notes.push("other points or another number of them: of errors only medians are compared".to_owned());
    }
    let missing = new.formulas.iter().filter(|now| old.formula(&now.formula).is_none()).count();
    if missing > 0 {
        notes.push(format!("{missing} formulas are not in the old report"));
    }
    let gone = old.formulas.iter().filter(|before| is_asked(&before.formula) && new.formula(&before.formula).is_none());
    let gone = gone.map(|before| Change::missing(before.formula.clone()));
    let changes = gone.chain(pairs.iter().flat_map(|(old, new)| formula(old, new, drift, same_points))).collect();
    Comparison { drift, formulas: pairs.len(), changes, notes }
}

fn drift(pairs: &[(&Measurement, &Measurement)]) -> Option<f64> {
    let ratio = |(old, new): (Option<Time>, Option<Time>)| Some(new?.median / old?.median);
    let of_pair = |(old, new): &(&Measurement, &Measurement)| {
        [(old.copy, new.copy), (old.yardstick, new.yardstick)].into_iter().filter_map(ratio).collect::<Vec<_>>()
    };
    let mut ratios: Vec<f64> = pairs.iter().flat_map(of_pair).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied()
}

fn formula(old: &Measurement, new: &Measurement, drift: f64, same_points: bool) -> Vec<Change> {
    let of_method = |before: &MethodFigures| {
        let name = format!("{} {}", new.formula, before.id);
        let Some(now) = new.method(&before.id) else {
            return vec![Change::missing(name)];
        };
        let parts = [("value", &before.value, &now.value), ("Jacobian", &before.jacobian, &now.jacobian)];
        parts
            .into_iter()
            .filter_map(|(part, before, now)| Some((part, before.as_ref()?, now.as_ref()?)))
            .flat_map(|(part, before, now)| figures(&format!("{name} {part}"), before, now, drift, same_points))
            .collect()
    };
    old.methods.iter().flat_map(of_method).collect()
}

fn figures(what: &str, old: &Figures, new: &Figures, drift: f64, same_points: bool) -> Vec<Change> {
    let mut changes = Vec::new();
    if let (Some(before), Some(now)) = (old.time, new.time)
        && slower(before, now, drift)
    {
        let scaled = if (drift - 1.0).abs() < 0.005 { String::new() } else { format!(" × drift {drift:.2}") };
        let figures = format!("{}{scaled} → {}", duration(before.median), duration(now.median));
        changes.push(Change { what: what.into(), how: "slower", figures });
    }
    changes.extend(errors(&format!("{what}, random points"), &old.random, &new.random, same_points));
    if let (Some(old), Some(new)) = (&old.hard, &new.hard) {
        // Hard points are the same in every run, as long as the formula's cases are.
        changes.extend(errors(&format!("{what}, hard points"), old, new, old.points == new.points));
    }
    changes
}

fn slower(before: Time, now: Time, drift: f64) -> bool {
    let (median, high) = (before.median * drift, before.high * drift);
    now.low > high && now.median > median * LEAST && now.median > median + LEAST_NS
}

fn errors(what: &str, old: &Errors, new: &Errors, same_points: bool) -> Option<Change> {
    let change = |how, figures| Some(Change { what: what.into(), how, figures });
    if same_points && new.not_finite > old.not_finite {
        return change("fails at more points", format!("{} → {}", old.not_finite, new.not_finite));
    }
    let quantiles = [
        ("median", old.eta.median, new.eta.median),
        ("99 %", old.eta.p99, new.eta.p99),
        ("max", old.eta.max, new.eta.max),
    ];
    let (compared, factor) = if same_points { (&quantiles[..], LEAST) } else { (&quantiles[..1], 2.0) };
    let worse = compared.iter().find(|(_, before, now)| *now > before * factor && *now > before + LEAST_ETA)?;
    let (quantile, before, now) = worse;
    change("less accurate", format!("η {quantile} {} → {}", figure(*before), figure(*now)))
}

impl Comparison {
    /// For a terminal.
    pub(crate) fn text(&self) -> String {
        let notes = self.notes.iter().map(|note| format!("note: {note}\n")).collect::<Vec<_>>().concat();
        let line = |change: &Change| format!("{} {}: {}\n", red(change.how), bold(&change.what), change.figures);
        let changes = self.changes.iter().map(line).collect::<Vec<_>>().concat();
        let Self { drift, formulas, .. } = self;
        let verdict = match self.changes.len() {
            0 => format!("{} nothing became slower or less accurate", green("ok")),
            count => format!("{} {count} figures became worse", red("off")),
        };
        format!("{notes}{changes}{verdict} in {formulas} formulas; unchanged code took {drift:.2} of its old time\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::data::Machine;
    use jointproof::toolkit::measure::{Options, Quantiles};
    use measuring::Build;

    fn time(median: f64) -> Time {
        Time { median, low: 0.95 * median, high: 1.05 * median }
    }

    fn report(scale: f64) -> Report {
        let errors =
            Errors { points: 24, not_finite: 0, eta: Quantiles { median: 0.3, p99: 1.0, max: 1.2 }, relative: 0.0 };
        let figures = |ns| {
            Some(Figures {
                time: Some(time(ns * scale)),
                ratio: None,
                hard_times: Vec::new(),
                random: errors,
                hard: Some(errors),
            })
        };
        let method = |id: &str, ns| MethodFigures {
            id: id.into(),
            title: id.into(),
            step: None,
            value: figures(ns),
            jacobian: figures(2.0 * ns),
        };
        let measurement = |id: &str| Measurement {
            formula: id.into(),
            inputs: 2,
            outputs: 1,
            random_points: 24,
            hard_points: 24,
            copy: Some(time(3.0 * scale)),
            yardstick: Some(time(12.0 * scale)),
            columns: None,
            methods: vec![method("closed", 10.0), method("ad", 100.0)],
            curves: Vec::new(),
        };
        let text = |text: &str| text.to_owned();
        Report {
            version: 1,
            created: text("2025-01-01T00:00:00Z"),
            sources: String::new(),
            machine: Machine { processor: text("p"), cores: 2, system: text("s") },
            build: Build { compiler: text("c"), target: text("t"), profile: text("p"), flags: text("") },
            options: Options::quick(),
            formulas: vec![measurement("t.first"), measurement("t.second")],
        }
    }

    /// A disturbance of one yardstick of four, the first, is not taken for a slower machine.
    #[test]
    fn the_drift_is_the_median_however_ratios_follow_each_other() {
        let (old, mut new) = (report(1.0), report(2.0));
        new.formulas[0].copy = Some(time(3.0 * 50.0));
        new.formulas[1].copy = Some(time(3.0 * 1.9));
        new.formulas[1].yardstick = Some(time(12.0 * 1.8));
        assert_eq!(against(&old, &new).drift, 2.0);
    }

    /// The comparison of complete reports.
    fn against(old: &Report, new: &Report) -> Comparison {
        compare(old, new, |_| true)
    }

    /// The changes between a report and an altered copy.
    fn changes(tamper: impl FnOnce(&mut Report)) -> Vec<(String, &'static str)> {
        let mut new = report(1.0);
        tamper(&mut new);
        against(&report(1.0), &new).changes.into_iter().map(|change| (change.what, change.how)).collect()
    }

    fn closed(report: &mut Report) -> &mut Figures {
        report.formulas[1].methods[0].jacobian.as_mut().unwrap()
    }

    #[test]
    fn the_same_report_has_no_changes() {
        assert_eq!(changes(|_| ()), []);
    }

    #[test]
    fn a_slower_machine_is_drift_and_no_change() {
        let comparison = against(&report(1.0), &report(1.7));
        assert!((comparison.drift - 1.7).abs() < 1e-12);
        assert_eq!(comparison.changes, []);
    }

    #[test]
    fn a_planted_slowdown_is_found_and_named() {
        let found = changes(|new| closed(new).time = Some(time(26.0)));
        assert_eq!(found, [("t.second closed Jacobian".to_owned(), "slower")]);
        let mut slow = report(1.7);
        closed(&mut slow).time = Some(time(26.0 * 1.7));
        assert_eq!(against(&report(1.0), &slow).changes.len(), 1, "on a slower machine too");
    }

    #[test]
    fn a_slowdown_within_the_spread_is_noise() {
        assert_eq!(changes(|new| closed(new).time = Some(time(21.5))), []);
        let less_than_a_tenth = Some(Time { median: 21.5, low: 21.2, high: 21.6 });
        assert_eq!(changes(|new| closed(new).time = less_than_a_tenth), []);
        let wide = Some(Time { median: 26.0, low: 20.0, high: 40.0 });
        assert_eq!(changes(|new| closed(new).time = wide), []);
    }

    #[test]
    fn a_planted_error_is_found_and_named() {
        let found = changes(|new| closed(new).random.eta.max = 1.4);
        assert_eq!(found, [("t.second closed Jacobian, random points".to_owned(), "less accurate")]);
        assert_eq!(changes(|new| closed(new).random.eta.max = 1.23), [], "a fiftieth more");
        let found = changes(|new| closed(new).hard.as_mut().unwrap().not_finite = 1);
        assert_eq!(found, [("t.second closed Jacobian, hard points".to_owned(), "fails at more points")]);
    }

    #[test]
    fn with_other_points_only_medians_count() {
        let others: [fn(&mut Report); 2] = [|new| new.options.random_points = 400, |new| new.options.seed = 7];
        for other in others {
            let mut greater_maximum = report(1.0);
            other(&mut greater_maximum);
            closed(&mut greater_maximum).random.eta.max = 1.9;
            assert_eq!(against(&report(1.0), &greater_maximum).changes, []);
            closed(&mut greater_maximum).random.eta.median = 0.7;
            assert_eq!(against(&report(1.0), &greater_maximum).changes.len(), 1);
        }
    }

    #[test]
    fn a_way_that_is_gone_is_a_change_and_a_new_formula_is_not() {
        let found = changes(|new| drop(new.formulas[0].methods.pop()));
        assert_eq!(found, [("t.first ad".to_owned(), "missing")]);
        let mut old = report(1.0);
        old.formulas.pop();
        assert_eq!(against(&old, &report(1.0)).changes, []);
    }

    #[test]
    fn a_formula_that_vanished_is_a_change_if_it_was_asked_for() {
        let mut new = report(1.0);
        new.formulas.remove(0);
        let found = against(&report(1.0), &new).changes;
        assert_eq!(found, [Change::missing("t.first".into())]);
        assert_eq!(compare(&report(1.0), &new, |id| id == "t.second").changes, []);
    }

    /// The drift is the median over unchanged code; a single disturbed ratio does not count, in either direction.
    #[test]
    fn drift_is_the_median() {
        for (outlier, scale) in [(0.1, 1.7), (20.0, 1.7), (0.1, 1.0), (20.0, 1.0)] {
            let mut new = report(scale);
            let copy = new.formulas[0].copy.as_mut().unwrap();
            copy.median *= outlier;
            let comparison = against(&report(1.0), &new);
            assert!((comparison.drift - scale).abs() < 1e-12, "{outlier}: {}", comparison.drift);
            assert_eq!(comparison.changes, []);
        }
        // A faster machine does not hide what became slower on it.
        let mut fast = report(0.5);
        closed(&mut fast).time = Some(time(13.0));
        assert_eq!(against(&report(1.0), &fast).changes.len(), 1);
        let [mut old, mut new] = [report(1.0), report(1.0)];
        for formula in old.formulas.iter_mut().chain(&mut new.formulas) {
            (formula.copy, formula.yardstick) = (None, None);
        }
        let comparison = against(&old, &new);
        assert_eq!((comparison.drift, comparison.notes.len()), (1.0, 1));
    }

    /// A time is slower if it exceeds the spread, a tenth and half a nanosecond, all of them; at the limit itself it is not.
    #[test]
    fn slower_is_beyond_every_limit() {
        let exactly = |median| Time { median, low: median, high: median };
        for (before, now, is_slower) in
            [(2.0, 2.5, false), (2.0, 2.625, true), (2.0, 3.0, true), (10.0, 10.0 * LEAST, false), (10.0, 11.5, true)]
        {
            assert_eq!(slower(exactly(before), exactly(now), 1.0), is_slower, "{before} {now}");
        }
        let [before, now] =
            [(9.0, 10.0, 12.0), (12.0, 20.0, 21.0)].map(|(low, median, high)| Time { median, low, high });
        assert!(!slower(before, now, 1.0), "the spreads touch each other");
        assert!(slower(before, Time { low: 12.5, ..now }, 1.0));
        // The spread is scaled to the slower machine.
        let [wide, far] =
            [(20.0, 30.0, 31.0), (25.0, 30.0, 31.0)].map(|(low, median, high)| Time { median, low, high });
        assert_eq!([wide, far].map(|now| slower(before, now, 2.0)), [false, true]);
        assert!(slower(before, Time { low: 6.5, median: 8.0, high: 9.0 }, 0.5));
    }

    #[test]
    fn less_accurate_is_beyond_every_limit() {
        let of =
            |median, p99, max| Errors { points: 9, not_finite: 0, eta: Quantiles { median, p99, max }, relative: 0.0 };
        let found = |before, now, same_points| errors("it", &before, &now, same_points).map(|change| change.figures);
        // The largest errors before and now.
        for (before, now, is_worse) in [
            (0.0, LEAST_ETA, false),
            (0.0, 0.0625, true),
            (0.25, 0.28125, false),
            (1.25, 1.3125, false),
            (10.0, 10.0 * LEAST, false),
            (10.0, 11.5, true),
        ] {
            let found = found(of(0.0, 0.0, before), of(0.0, 0.0, now), true);
            assert_eq!(found.is_some(), is_worse, "{before} {now}: {found:?}");
        }
        // At other points only medians are compared, and a factor of two counts as chance.
        let before = of(0.25, 0.5, 0.75);
        for (now, expected) in [
            (of(0.5, 0.5, 0.75), None),
            (of(0.25, 9.0, 9.5), None),
            (of(0.625, 0.625, 0.75), Some("η median 0.25 → 0.62")),
        ] {
            assert_eq!(found(before, now, false).as_deref(), expected);
        }
        // The first quantity that is worse is reported.
        assert_eq!(found(before, of(0.25, 1.5, 9.5), true).as_deref(), Some("η 99 % 0.50 → 1.50"));
        let failing = |not_finite| Errors { not_finite, ..before };
        assert_eq!(found(failing(1), failing(3), true).as_deref(), Some("1 → 3"));
        for (before, now, same_points) in [(1, 3, false), (3, 1, true), (3, 3, true)] {
            assert_eq!(found(failing(before), failing(now), same_points), None);
        }
    }

    #[test]
    fn drift_is_told_where_there_is_some() {
        for (scale, expected) in [(1.0, "20.0 ns → 40.0 ns"), (0.5, "20.0 ns × drift 0.50 → 20.0 ns")] {
            let mut new = report(scale);
            closed(&mut new).time = Some(time(40.0 * scale));
            let found = against(&report(1.0), &new).changes;
            assert_eq!(found.iter().map(|change| change.figures.as_str()).collect::<Vec<_>>(), [expected]);
        }
    }

    #[test]
    fn what_is_in_the_way_of_a_comparison_is_noted() {
        type Tamper = fn(&mut Report);
        let machine = "the machine or the build is another one; times are compared after scaling";
        let points = "other points or another number of them: of errors only medians are compared";
        let notes: [(Tamper, &[&str]); 5] = [
            (|_| (), &[]),
            (|new| new.machine.cores = 3, &[machine]),
            (|new| new.build.flags = "-C x".into(), &[machine]),
            (|new| new.options.seed = 7, &[points]),
            (|new| new.options.random_points = 7, &[points]),
        ];
        for (tamper, expected) in notes {
            let mut new = report(1.0);
            tamper(&mut new);
            assert_eq!(against(&report(1.0), &new).notes, expected);
        }
    }

    /// The errors at hard or at random points.
    fn of(figures: &mut Figures, is_hard: bool) -> &mut Errors {
        if is_hard { figures.hard.as_mut().unwrap() } else { &mut figures.random }
    }

    #[test]
    fn every_figure_of_every_way_is_compared() {
        type Figure = fn(&mut MethodFigures) -> &mut Option<Figures>;
        let parts: [(Figure, &str, f64); 2] =
            [(|method| &mut method.value, "value", 10.0), (|method| &mut method.jacobian, "Jacobian", 20.0)];
        for (k, (id, factor)) in [("closed", 1.0), ("ad", 10.0)].into_iter().enumerate() {
            for (part, name, ns) in parts {
                let with = |change: &dyn Fn(&mut Figures)| {
                    let found = changes(|new| change(part(&mut new.formulas[1].methods[k]).as_mut().unwrap()));
                    assert_eq!(found.len(), 1, "{id} {name}: {found:?}");
                    found[0].clone()
                };
                let whole = format!("t.second {id} {name}");
                assert_eq!(with(&|figures| figures.time = Some(time(1.5 * factor * ns))), (whole.clone(), "slower"));
                for (points, is_hard) in [("random", false), ("hard", true)] {
                    let what = format!("{whole}, {points} points");
                    let less = (what.clone(), "less accurate");
                    assert_eq!(with(&|figures| of(figures, is_hard).eta.median = 0.4), less);
                    assert_eq!(with(&|figures| of(figures, is_hard).eta.p99 = 1.15), less);
                    assert_eq!(with(&|figures| of(figures, is_hard).eta.max = 1.35), less);
                    assert_eq!(with(&|figures| of(figures, is_hard).not_finite = 1), (what, "fails at more points"));
                }
            }
        }
    }

    #[test]
    fn what_became_better_is_no_change() {
        let better = |new: &mut Report| {
            for figures in new
                .formulas
                .iter_mut()
                .flat_map(|one| &mut one.methods)
                .flat_map(|method| [&mut method.value, &mut method.jacobian])
            {
                let figures = figures.as_mut().unwrap();
                (figures.time, figures.random.eta) = (Some(time(1.0)), Quantiles::default());
            }
        };
        assert_eq!(changes(better), []);
    }

    #[test]
    fn a_comparison_is_told_with_figures_before_and_now() {
        let mut new = report(1.5);
        closed(&mut new).time = Some(time(45.0));
        new.formulas[0].methods[1].value.as_mut().unwrap().random.eta.max = 2.5;
        new.machine.cores = 3;
        new.formulas.push(Measurement { formula: "t.new".into(), ..report(1.0).formulas.remove(0) });
        let text = anstream::adapter::strip_str(&against(&report(1.0), &new).text()).to_string();
        let expected = "note: the machine or the build is another one; times are compared after scaling\n\
                        note: 1 formulas are not in the old report\n\
                        less accurate t.first ad value, random points: η max 1.20 → 2.50\n\
                        slower t.second closed Jacobian: 20.0 ns × drift 1.50 → 45.0 ns\n\
                        off 2 figures became worse in 2 formulas; unchanged code took 1.50 of its old time\n";
        assert_eq!(text, expected);
        let same = anstream::adapter::strip_str(&against(&report(1.0), &report(1.0)).text()).to_string();
        assert_eq!(
            same,
            "ok nothing became slower or less accurate in 2 formulas; unchanged code took 1.00 of its old time\n"
        );
    }
}
