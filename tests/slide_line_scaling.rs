//! The cost of the closest point of a slide line per slave point, for short and for long lines.
//!
//! `cargo test --release --test all slide_line_scaling:: -- --ignored --nocapture`

use jointproof::contact::slide_line::{Interpolation, Nodes, PlacedLine, SlideLine};
use nalgebra::Vector2;
use std::hint::black_box;
use std::time::Instant;

const SEGMENTS: [u32; 3] = [10, 1_000, 100_000];
const LINES: [(Interpolation, bool); 4] = [
    (Interpolation::Linear, false),
    (Interpolation::Linear, true),
    (Interpolation::Parabolic, false),
    (Interpolation::Parabolic, true),
];
const SLAVES: u32 = 2_000;
/// A batch is short, so that most batches are not interrupted by other activity of the machine.
const BATCH: usize = 50;
const ROUNDS: usize = 801;

/// A bumpy line along r with segments of about 1 length unit.
fn bumpy(kind: Interpolation, segments: u32, smoothed: bool) -> PlacedLine {
    let stride = if kind == Interpolation::Linear { 1 } else { 2 };
    let count = segments * stride + 1;
    let node = |k: u32| (k + 1, [f64::from(k) / f64::from(stride), f64::from((k % 7) * (k % 7) % 7) / 16.0]);
    let line = SlideLine::generate(kind, 1, count, 1).unwrap();
    let line = if smoothed { line.smoothed(0.2).unwrap() } else { line };
    line.place(&Nodes::new((0..count).map(node)).unwrap()).unwrap()
}

/// Slave points half a segment above the line, distributed over all of it.
fn slaves(segments: u32) -> Vec<Vector2<f64>> {
    let share = |k: u32| f64::from(k.wrapping_mul(2_654_435_769)) / f64::from(u32::MAX);
    (0..SLAVES).map(|k| Vector2::new(share(k) * f64::from(segments), 0.75)).collect()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

#[test]
fn a_longer_line_costs_few_more_evaluations() {
    for (kind, smoothed) in LINES {
        for segments in SEGMENTS {
            let line = bumpy(kind, segments, smoothed);
            let evaluated = slaves(segments).into_iter().take(200).map(|xs| line.closest(xs).unwrap().evaluated);
            let most = evaluated.max().unwrap();
            assert!(most <= 8, "{most} of {segments}");
        }
    }
}

#[test]
#[ignore = "a measurement, to be run alone and in release"]
fn slide_line_scaling() {
    println!("{:30} {:>9} {:>12} {:>12}", "line", "segments", "ns per point", "to 10");
    for (kind, smoothed) in LINES {
        let benches = SEGMENTS.map(|segments| (bumpy(kind, segments, smoothed), slaves(segments)));
        let mut times = SEGMENTS.map(|_| Vec::new());
        // Interleaved, so that a change of the machine's speed affects all equally.
        for round in 0..ROUNDS {
            for ((line, slaves), times) in benches.iter().zip(&mut times) {
                let batch = slaves.chunks(BATCH).nth(round % (slaves.len() / BATCH)).unwrap();
                let start = Instant::now();
                for &xs in batch {
                    black_box(line.closest(black_box(xs)).unwrap());
                }
                times.push(start.elapsed().as_secs_f64() * 1e9 / f64::from(u32::try_from(batch.len()).unwrap()));
            }
        }
        let medians = times.map(median);
        for (segments, time) in SEGMENTS.into_iter().zip(medians) {
            let name = format!("{kind:?}{}", if smoothed { ", smoothed" } else { "" });
            println!("{name:30} {segments:>9} {time:>12.0} {:>12.2}", time / medians[0]);
        }
    }
}
