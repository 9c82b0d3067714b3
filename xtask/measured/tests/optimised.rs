//! Guarantees that concern optimised builds. `cargo test --release --package measured` shares its build with the
//! program that `report` measures.

use jointproof::catalog::CATALOG;
use jointproof::contact::slide_line::{Interpolation, Nodes, PlacedLine, SlideLine};
use std::path::Path;

/// Golden values do not depend on the optimisation level.
#[test]
#[cfg_attr(debug_assertions, ignore = "without optimisation `golden` of the library's tests does it")]
fn golden_files_have_the_same_bytes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../golden");
    for formula in CATALOG {
        let path = folder.join(format!("{}.json", formula.spec().id));
        let committed = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(formula.golden().render().unwrap() == committed, "{}", path.display());
    }
}

/// Fewer segments than there are slave points, and as many as a model may have.
const FINENESS: [u32; 2] = [100, 1_000_000];
const LINES: [(Interpolation, bool); 4] = [
    (Interpolation::Linear, false),
    (Interpolation::Linear, true),
    (Interpolation::Parabolic, false),
    (Interpolation::Parabolic, true),
];
const SLAVES: u32 = 2_000;

/// An arc of radius 1 about (2, 0).
fn arc(kind: Interpolation, segments: u32, smoothed: bool) -> PlacedLine {
    let stride = if kind == Interpolation::Linear { 1 } else { 2 };
    let count = segments * stride + 1;
    let node = |k: u32| (k + 1, around(f64::from(k) / f64::from(count - 1), 1.0));
    let line = SlideLine::generate(kind, 1, count, 1).unwrap();
    let line = if smoothed { line.smoothed(0.2).unwrap() } else { line };
    line.place(&Nodes::new((0..count).map(node)).unwrap()).unwrap()
}

/// The point at a fraction of the arc, at this distance from its centre.
fn around(share: f64, radius: f64) -> [f64; 2] {
    let (sine, cosine) = (2.5 * share).sin_cos();
    [2.0 - radius * cosine, radius * sine]
}

/// Segments are much shorter than the distance of the slave point, which is up to half the radius of curvature.
#[test]
#[cfg_attr(debug_assertions, ignore = "a million segments take minutes without optimisation")]
fn a_finer_line_costs_few_more_evaluations() {
    for (kind, smoothed) in LINES {
        let mean = |segments| {
            let line = arc(kind, segments, smoothed);
            let share = |k: u32| f64::from(k.wrapping_mul(2_654_435_769)) / f64::from(u32::MAX);
            let slaves = (0..SLAVES).map(|k| around(share(k), 0.5 + share(k.wrapping_mul(40_503))));
            let evaluated: usize = slaves.map(|xs| line.closest(xs.into()).unwrap().evaluated).sum();
            f64::from(u32::try_from(evaluated).unwrap()) / f64::from(SLAVES)
        };
        let [few, many] = FINENESS.map(mean);
        println!(
            "{kind:?}{}: {few:.2} of {}, {many:.2} of {}",
            if smoothed { ", smoothed" } else { "" },
            FINENESS[0],
            FINENESS[1]
        );
        assert!(many <= 3.0 * few, "{few} of {}, {many} of {}", FINENESS[0], FINENESS[1]);
    }
}
