//! Made-up audits and reports in which no two numbers are the same. Output generated from them is kept in
//! `tests/printed`, so that a column with the wrong number, swapped sides or a lost sign show as a difference.

use crate::report::data::{Machine, Report};
use jointproof::toolkit::measure::{
    Curve, Errors, Figures, Measurement, MethodFigures, Options, PointTime, Quantiles, Scheme, Time,
};
use jointproof::toolkit::verify::{Audit, Claim, Coverage, Deviation, Examination, Search};
use measuring::Build;

fn claim(claim: &str, bound: f64, [checks, failures]: [usize; 2], size: f64) -> Claim {
    let inputs = serde_json::json!({ "f2": 3.0 + size, "f3": 4.0 });
    let (found, expected) = (1.0 + size, 1.0 - size);
    let entry = if claim.contains("acobian") { "∂fc/∂f2" } else { "fc" };
    let worst =
        Deviation { size, entry: entry.into(), point: format!("random {checks} of seed 9"), found, expected, inputs };
    Claim { claim: claim.into(), bound, checks, failures, worst: (checks > 0).then_some(worst) }
}

/// An audit that passed.
pub(crate) fn passed() -> Audit {
    Audit {
        formula: "t.first".into(),
        provenance: "Document, section “One”; printed".into(),
        named_points: 7,
        searched_points: 3,
        random_points: 20,
        seed: 9,
        closed_against_ad: Some(claim("closed form = automatic differentiation", 1e-60, [101, 0], 1.1e-61)),
        ad_against_differences: claim("automatic differentiation = differences", 1e-50, [102, 0], 2.2e-52),
        eta: claim("η of the value in f64", 4.0, [103, 0], 1.25),
        eta_jacobian: Some(claim("η of the closed-form Jacobian in f64", 8.0, [104, 0], 2.75)),
        scaled: vec![
            claim("η of the value in f64, at sizes from 1/1e30 to 1e30", 4.0, [112, 0], 1.5),
            claim("η of the closed-form Jacobian in f64, at sizes from 1/1e30 to 1e30", 8.0, [113, 0], 3.25),
        ],
        equation: claim("printed equation = value", 1e-55, [105, 0], 3.3e-57),
        equation_jacobian: claim("derivative of the printed equation", 1e-54, [106, 0], 4.4e-58),
        laws: vec![
            claim("a law of every formula", 1e-60, [107, 0], 5.5e-63),
            claim("its own law", 1e-60, [108, 0], 6.6e-64),
        ],
        finite: Some(claim("nothing overflows", 0.0, [109, 0], 0.0)),
        kinks: claim("where value or derivative jumps a kink is registered", 1e-12, [110, 0], 7.7e-14),
        register: Some(claim("on every registered kink something jumps", 0.0, [111, 0], 0.0)),
        examination: Some(Examination::Graph {
            search: Search {
                candidates: 12,
                points: 30,
                smooth: 5,
                registered: 4,
                not_reached: ["a", "b", "c"].map(|name| format!("{name} = 0")).into(),
                found: vec!["f_2 = 0".into()],
            },
            coverage: Coverage { comparisons: 6, asked: 160, least: 13, never: vec!["x < 0: never so".into()] },
        }),
    }
}

/// An audit with failures in nearly every claim, and one unchecked claim.
pub(crate) fn failed() -> Audit {
    Audit {
        formula: "t.second".into(),
        named_points: 8,
        random_points: 30,
        closed_against_ad: Some(claim("closed form = automatic differentiation", 1e-60, [201, 11], 1.2e-7)),
        ad_against_differences: claim("automatic differentiation = differences", 1e-50, [202, 12], 2.3e-8),
        eta: claim("η of the value in f64", 3.0, [203, 13], 31.5),
        eta_jacobian: Some(claim("η of the closed-form Jacobian in f64", 7.0, [204, 14], 71.5)),
        scaled: vec![
            claim("η of the value in f64, at sizes from 1/1e30 to 1e30", 3.0, [212, 18], 32.5),
            claim("η of the closed-form Jacobian in f64, at sizes from 1/1e30 to 1e30", 7.0, [213, 19], 72.5),
        ],
        equation: claim("printed equation = value", 1e-55, [0, 0], 0.0),
        equation_jacobian: claim("derivative of the printed equation", 1e-54, [206, 15], 4.5e-3),
        laws: vec![
            claim("a law of every formula", 1e-60, [207, 16], 5.6e-4),
            claim("its own law", 1e-60, [0, 0], 0.0),
            claim("one that holds", 1e-60, [209, 0], 8.8e-66),
        ],
        finite: None,
        kinks: claim("where value or derivative jumps a kink is registered", 1e-12, [210, 17], 0.5),
        register: None,
        examination: Some(Examination::NamedPoints { why: "it is a search".into() }),
        ..passed()
    }
}

fn time(median: f64) -> Time {
    Time { median, low: 0.9 * median, high: 1.2 * median }
}

/// Errors that increase with `size`.
fn errors(points: usize, not_finite: usize, size: f64) -> Errors {
    let quantiles = |x: f64| Quantiles { median: x, p99: 2.0 * x, max: 3.0 * x };
    Errors { points, not_finite, eta: quantiles(size), relative: size * 1e-16 }
}

/// A method whose value has this time and this error; those of its Jacobian are larger.
fn method(id: &str, title: &str, ns: f64, error: f64) -> MethodFigures {
    let hard = |case: &str, ordinary, factor: f64| PointTime {
        case: case.into(),
        ordinary,
        time: time(ns * factor),
        ratio: time(factor),
    };
    let figures = |ns: f64, error: f64, not_finite, factor: f64| Figures {
        time: Some(time(ns)),
        ratio: Some(time(ns / 11.0)),
        hard_times: vec![hard("near", true, factor), hard("extreme", false, 99.0)],
        random: errors(50, 0, error),
        hard: Some(errors(9, not_finite, error * 1.5)),
    };
    MethodFigures {
        id: id.into(),
        title: title.into(),
        step: id.starts_with("central").then_some(1e-5),
        value: (id != "ad" && id != "central").then(|| figures(ns, error, 0, 1.5)),
        jacobian: Some(figures(ns * 2.5, error * 1.25, usize::from(id == "plain"), 2.0)),
    }
}

/// The measurement of a formula; all times are multiplied by `slow`.
pub(crate) fn measurement(formula: &str, slow: f64) -> Measurement {
    let curve = |scheme, best, least| Curve {
        scheme,
        errors: (0..15).map(|k| if k == best { least } else { 5e-3 }).collect(),
        best,
    };
    Measurement {
        formula: formula.into(),
        inputs: 2,
        outputs: 1,
        random_points: 50,
        hard_points: 9,
        copy: Some(time(3.0 * slow)),
        yardstick: Some(time(17.0 * slow)),
        columns: None,
        methods: vec![
            method("closed", "closed form", 11.0 * slow, 0.4),
            method("checked", "closed form, checked", 13.0 * slow, 0.4),
            method("single", "single precision", 5.0 * slow, 3e8),
            method("ad", "automatic differentiation", 47.0 * slow, 0.7),
            method("central", "central differences", 61.0 * slow, 8e5),
            method("octuple", "237 bits", 9e4 * slow, 0.0),
            method("plain", "plain square root", 7.0 * slow, 0.9),
        ],
        curves: vec![
            curve(Scheme::Forward, 6, 3e-10),
            curve(Scheme::Central, 3, 9e-12),
            curve(Scheme::Fourth, 1, 1e-12),
        ],
    }
}

/// A report on two formulas.
pub(crate) fn report() -> Report {
    let text = str::to_owned;
    let mut second = measurement("u.second", 1e3);
    second.methods.swap(0, 3);
    let ids: Vec<_> = second.methods.iter().map(|method| method.id.clone()).collect();
    // Automatic differentiation is the faster one there.
    (second.methods[0].id, second.methods[3].id) = (ids[3].clone(), ids[0].clone());
    Report {
        version: 3,
        created: text("2026-11-01T02:03:04Z"),
        sources: text("0123"),
        machine: Machine { processor: text("a processor"), cores: 3, system: text("a system") },
        build: Build {
            compiler: text("a compiler"),
            target: text("a target"),
            profile: text("a profile"),
            flags: text(""),
        },
        options: Options { seed: 9, ..Options::quick() },
        formulas: vec![measurement("t.first", 1.0), second],
    }
}
