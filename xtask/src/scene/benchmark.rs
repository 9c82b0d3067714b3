//! What an element of a scene costs per state, against a bare loop of the same formulas.

use super::generate::{self, STATES};
use crate::console::{print, say};
use jointproof::coulomb::{ReturnMap, Trial};
use jointproof::formula::Formula;
use jointproof::scene::rules::{Slip, SlipLoads, Stick, StickLoads};
use jointproof::scene::{Plan, Run, Scene};
use jointproof::slot::{
    Constraint, ContactForce, ContactForces, CrossForces, NormalForce, Positions, RelativeMotion, RelativePosition,
    SlotLengths, SlotPositions,
};
use nalgebra::Vector3;
use rayon::prelude::*;
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

const SIZES: [usize; 3] = [10, 10_000, 1_000_000];

/// Nanoseconds that the best of some runs takes per element and state.
fn best(elements: usize, states: usize, mut job: impl FnMut()) -> f64 {
    let runs = (200_000 / elements).clamp(5, 10_000);
    let one = |_| {
        let start = Instant::now();
        job();
        start.elapsed().as_secs_f64()
    };
    let best = (0..runs).map(one).fold(f64::INFINITY, f64::min);
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
    let evaluations = (elements * states) as f64;
    best * 1e9 / evaluations
}

pub(crate) fn run() -> anyhow::Result<()> {
    let mut report = format!(
        "{} threads, {STATES} states, outputs GY GZ U1 CSF1 CASU1 of a slot with friction\n\
        {:>9} {:>9} {:>9} {:>9} {:>7} {:>13} {:>11} {:>13}\n",
        rayon::current_num_threads(),
        "elements",
        "read ns",
        "scene ns",
        "bare ns",
        "ratio",
        "bytes/element",
        "bytes/node",
        "resident",
    );
    for elements in SIZES {
        say(&format!("{elements} elements"));
        let mut text = Vec::new();
        generate::write(elements, &mut text)?;
        let text = String::from_utf8(text)?;
        let start = Instant::now();
        let scene = Scene::parse(&text)?;
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
        let reading = start.elapsed().as_secs_f64() * 1e9 / elements as f64;
        drop(text);
        let resident = resident().map_or_else(|| "unknown".into(), |bytes| format!("{:.0}", per(bytes, elements)));
        let plan = Plan::new(&scene);
        let (mut failed, mut bytes) = (None, [0, 0]);
        // The states only: what comes before is reading.
        let mut fastest = f64::INFINITY;
        for _ in 0..(100_000 / elements).clamp(5, 1000) {
            let mut run = Run::<f64>::new(&scene, &plan)?;
            let time = best_of_states(&mut run, elements, &mut failed);
            fastest = fastest.min(time);
            bytes = run.bytes();
        }
        if let Some(problems) = failed {
            return Err(problems.into());
        }
        let bare = bare(elements);
        writeln!(
            report,
            "{elements:>9} {reading:>9.0} {fastest:>9.1} {bare:>9.1} {:>7.2} {:>13.1} {:>11.1} {resident:>13}",
            fastest / bare,
            per(bytes[0], elements),
            per(bytes[1], scene.nodes()),
        )?;
    }
    print(&report)
}

/// Bytes of memory that this process has, where the system tells.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.split_whitespace().next()?.parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
fn per(bytes: usize, count: usize) -> f64 {
    bytes as f64 / count as f64
}

fn best_of_states(run: &mut Run<'_, f64>, elements: usize, failed: &mut Option<jointproof::scene::Problems>) -> f64 {
    let start = Instant::now();
    loop {
        match run.advance() {
            Ok(true) => {}
            Ok(false) => break,
            Err(problems) => {
                *failed = Some(problems);
                break;
            }
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
    let evaluations = (elements * STATES) as f64;
    start.elapsed().as_secs_f64() * 1e9 / evaluations
}

/// Everything an element needs, side by side in memory.
#[derive(Clone, Copy)]
struct Bare {
    axes: [Vector3<f64>; 3],
    xa: Vector3<f64>,
    xb: Vector3<f64>,
    initial: [f64; 3],
    mu: f64,
    u1: f64,
    force: f64,
    slip: f64,
    results: [f64; 5],
}

/// The same formulas over the same elements, written out.
fn bare(elements: usize) -> f64 {
    let element = Bare {
        axes: [Vector3::x(), Vector3::y(), Vector3::z()],
        xa: Vector3::zeros(),
        xb: Vector3::new(0.5, 0.25, 1.0),
        initial: [0.5, 0.25, 1.0],
        mu: 0.3,
        u1: 0.0,
        force: 0.0,
        slip: 0.0,
        results: [0.0; 5],
    };
    let mut all = vec![element; elements];
    best(elements, 1, || all.par_iter_mut().with_min_len(256).for_each(|element| step(black_box(element))))
}

fn step(b: &mut Bare) {
    let [e1a, e2a, e3a] = b.axes;
    let [x0, y0, z0] = b.initial;
    let (xa, xb, k_stick) = (b.xa, b.xb, 1e5);
    b.xb.x += 0.01;
    let x = RelativePosition::eval(&Positions { e1a, e2a, e3a, xa, xb }).x;
    let residuals = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
    let u1 = RelativeMotion::eval(&SlotLengths { x, x0, l1_ref: x0 }).u1;
    let fc = ContactForce::eval(&CrossForces { f2: b.results[0] + 2.5, f3: -1.0 }).fc;
    let normal = NormalForce::eval(&ContactForces { fc, fc_int: 0.0 }).r#fn;
    let f_trial = Stick::eval(&StickLoads { u1, u1_before: b.u1, f_before: b.force, k_stick }).f_trial;
    let csf = ReturnMap::eval(&Trial { f_trial, mu: b.mu, r#fn: normal }).f;
    let slip = Slip::eval(&SlipLoads { f_trial, csf, k_stick, slip_before: b.slip });
    (b.u1, b.force, b.slip) = (u1, csf, slip.slip_total);
    b.results = [residuals.gy, residuals.gz, u1, csf, slip.slip_total];
}
