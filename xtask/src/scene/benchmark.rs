//! The cost of a scene's element per state, compared with a bare loop over the same formulas.

use super::bare::{Bare, Joint, Slot, Translator};
use super::file_to_file;
use super::generate::{Generated, STATES};
use crate::console::{print, say};
use anyhow::ensure;
use jointproof::scene::{Plan, Run, Scene};
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

/// Numbers of elements, and how often each is measured.
const SIZES: [(usize, usize); 3] = [(10, 4001), (10_000, 401), (1_000_000, 21)];

pub(crate) fn run() -> anyhow::Result<()> {
    let mut report = format!("Medians, with {} threads and {STATES} states.\n", rayon::current_num_threads());
    if cfg!(debug_assertions) {
        say("this build is not optimised; `cargo run --release -p xtask -- scene --benchmark` is");
    }
    of::<Slot>(&mut report)?;
    of::<Translator>(&mut report)?;
    file_to_file::run(&mut report)?;
    print(&report)
}

/// Measures one kind of connector.
fn of<J: Joint>(report: &mut String) -> anyhow::Result<()> {
    let kind = J::SORT.kind();
    writeln!(
        report,
        "\n`{kind}` with friction, outputs `{}`:\n\n\
         | Elements | Read, ns | Scene, ns | Bare, ns | Scene over bare | Bytes per element | Bytes per node | Resident, bytes |\n\
         |---:|---:|---:|---:|---:|---:|---:|---:|",
        J::SORT.outputs().join(" ")
    )?;
    for (elements, times) in SIZES {
        say(&format!("{elements} elements of kind {kind}"));
        let before = resident();
        let mut text = Vec::new();
        Generated { of: J::SORT, connectors: elements, states: STATES }.write(&mut text)?;
        let text = String::from_utf8(text)?;
        let start = Instant::now();
        let scene = Scene::parse(&text)?;
        let reading = per(start.elapsed().as_secs_f64() * 1e9, elements);
        drop(text);
        // The memory of a small scene is hidden in what the process has reserved already.
        let resident = resident().zip(before).filter(|_| elements > 100_000);
        let resident = resident.map(|(now, before)| per_count(now.saturating_sub(before), elements));
        let resident = resident.map_or_else(|| "–".into(), |bytes| format!("{bytes:.0}"));
        let Measured { scene: of_scene, bare, bytes } = measure::<J>(&scene, elements, times)?;
        writeln!(
            report,
            "| {elements} | {reading:.0} | {of_scene:.1} | {bare:.1} | {:.2} | {:.1} | {:.1} | {resident} |",
            of_scene / bare,
            per_count(bytes[0], elements),
            per_count(bytes[1], scene.nodes()),
        )?;
    }
    Ok(())
}

/// Nanoseconds per element and state, and bytes per element and node.
struct Measured {
    scene: f64,
    bare: f64,
    bytes: [usize; 2],
}

/// Both take turns, so that a slowdown of the machine affects both; only the states are timed, because everything
/// before is reading.
fn measure<J: Joint>(scene: &Scene, elements: usize, times: usize) -> anyhow::Result<Measured> {
    let plan = Plan::new(scene);
    let mut bare = Bare::<J>::new(elements);
    let (mut of_scene, mut of_bare) = (Vec::new(), Vec::new());
    let mut bytes = [0, 0];
    for _ in 0..times {
        let mut run = Run::<f64>::new(&plan)?;
        let start = Instant::now();
        while run.advance()? {}
        of_scene.push(start.elapsed().as_secs_f64());
        bytes = run.bytes();
        bare.restart();
        let start = Instant::now();
        black_box(&mut bare).run();
        of_bare.push(start.elapsed().as_secs_f64());
        if of_bare.len() == times {
            compare(&run, &bare)?;
        }
    }
    let median = |mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        per(seconds[times / 2] * 1e9, elements * STATES)
    };
    Ok(Measured { scene: median(of_scene), bare: median(of_bare), bytes })
}

/// Checks that the results of the last state have the same bits.
fn compare<J: Joint>(run: &Run<'_, f64>, bare: &Bare<J>) -> anyhow::Result<()> {
    let mut expected = bare.results();
    let mut same = true;
    run.for_each_result(usize::MAX, |_, _, components| same &= expected.next() == components.first().copied());
    ensure!(same && expected.next().is_none(), "the scene and the bare loop differ");
    Ok(())
}

/// The resident memory of this process in bytes, if the system reports it.
fn resident() -> Option<usize> {
    memory("VmRSS:")
}

/// The peak memory of this process in bytes, if the system reports it.
pub(super) fn peak() -> Option<usize> {
    memory("VmHWM:")
}

fn memory(which: &str) -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(which))?;
    line.split_whitespace().next()?.parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
fn per(what: f64, count: usize) -> f64 {
    what / count as f64
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
fn per_count(what: usize, count: usize) -> f64 {
    per(what as f64, count)
}
