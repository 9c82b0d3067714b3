//! Taking time: all ways take turns, round after round, so that a slow moment of the machine falls on all alike.

use super::{Figures, Measurement, Options, Time};
use crate::formula::{Fields, typed};
use crate::proof::Proved;
use crate::proof::way::{Kernel, Runner, Way};
use std::hint::black_box;
use std::time::Instant;

/// What is timed beside the ways.
const COPY: &str = "copy";
const YARDSTICK: &str = "yardstick";

/// A loop that takes its turn in every round, or in every n-th where a turn is long.
struct Contestant {
    way: &'static str,
    with_jacobian: bool,
    run: Runner,
    /// Points a call of the loop, and calls a turn.
    points: usize,
    calls: usize,
    /// Takes part in every so-manieth round.
    every: usize,
    /// Nanoseconds an evaluation, with the round.
    samples: Vec<(usize, f64)>,
}

/// Fills in the times of a measurement.
pub(super) fn time(ways: &[Way], copy: &Kernel, points: &[Vec<f64>], options: &Options, measurement: &mut Measurement) {
    let of_way = |way: &Way| {
        let kernels = [(&way.value, false), (&way.jacobian, true)];
        let contestant = |(kernel, with_jacobian): (&Option<Kernel>, bool)| {
            let run = (kernel.as_ref()?.runner)(points);
            Some(Contestant::new(way.id, with_jacobian, run, options))
        };
        kernels.map(contestant)
    };
    let mut contestants: Vec<_> = ways.iter().flat_map(of_way).flatten().collect();
    contestants.push(Contestant::new(COPY, true, (copy.runner)(points), options));
    contestants.push(Contestant::new(YARDSTICK, false, yardstick(), options));
    for round in 0..options.rounds.max(1) {
        // Each round begins with another one, so that none always follows the same neighbour's caches.
        let first = round % contestants.len();
        let (head, tail) = contestants.split_at_mut(first);
        tail.iter_mut().chain(head).for_each(|contestant| contestant.take_turn(round));
    }
    enter(&contestants, measurement);
}

impl Contestant {
    /// Finds how many evaluations fill a turn; that warms it up as well.
    fn new(way: &'static str, with_jacobian: bool, run: Runner, options: &Options) -> Self {
        let all = options.timing_points.max(1);
        let mut contestant = Self { way, with_jacobian, run, points: 1, calls: 1, every: 1, samples: Vec::new() };
        let mut one = contestant.least();
        if one * number(all) < options.turn_ns {
            contestant.points = all;
            one = contestant.least();
        }
        let call = (one * number(contestant.points)).max(1.0);
        contestant.calls = whole(options.turn_ns / call);
        if contestant.points == 1 {
            contestant.points = whole(options.turn_ns / call).min(all);
            contestant.calls = 1;
        }
        // A turn that is long even with one evaluation comes less often, but never fewer than five times.
        let long = whole(one / options.turn_ns / 4.0);
        contestant.every = long.min(options.rounds / 5).max(1);
        contestant
    }

    /// The least of some turns: the first is cold, and another may be interrupted.
    fn least(&mut self) -> f64 {
        (0..4).map(|_| self.turn(0)).fold(f64::INFINITY, f64::min)
    }

    /// Nanoseconds an evaluation in one turn.
    fn turn(&mut self, from: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..self.calls {
            (self.run)(from, self.points);
        }
        start.elapsed().as_secs_f64() * 1e9 / number(self.calls * self.points)
    }

    fn take_turn(&mut self, round: usize) {
        if round.is_multiple_of(self.every) {
            let time = self.turn(0);
            self.samples.push((round, time));
        }
    }

    /// Its time in units of another one's, round by round.
    fn ratios(&self, unit: &Self) -> Vec<f64> {
        let unit_in = |round| unit.samples.iter().find(|sample| sample.0 == round);
        let ratio = |&(round, time): &(usize, f64)| Some(time / unit_in(round)?.1);
        self.samples.iter().filter_map(ratio).collect()
    }

    fn time(&self) -> Option<Time> {
        Time::of(self.samples.iter().map(|sample| sample.1).collect())
    }
}

#[expect(clippy::cast_precision_loss, reason = "counts of points and calls are small")]
fn number(count: usize) -> f64 {
    count as f64
}

/// The count below, at least 1.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
fn whole(x: f64) -> usize {
    x.clamp(1.0, 1e9) as usize
}

/// Puts the times where they belong.
fn enter(contestants: &[Contestant], measurement: &mut Measurement) {
    let find = |way: &str, with_jacobian| {
        contestants.iter().find(|contestant| contestant.way == way && contestant.with_jacobian == with_jacobian)
    };
    let unit = find("closed", false);
    let fill = |figures: Option<&mut Figures>, contestant: Option<&Contestant>| {
        if let (Some(figures), Some(contestant)) = (figures, contestant) {
            figures.time = contestant.time();
            figures.ratio = unit.and_then(|unit| Time::of(contestant.ratios(unit)));
        }
    };
    for way in &mut measurement.ways {
        fill(way.value.as_mut(), find(&way.id, false));
        fill(way.jacobian.as_mut(), find(&way.id, true));
    }
    measurement.copy = find(COPY, true).and_then(Contestant::time);
    measurement.yardstick = find(YARDSTICK, false).and_then(Contestant::time);
}

/// Reads every input and writes every output and Jacobian entry, and does nothing else.
pub(super) fn copy<F: Proved>() -> Kernel {
    let written = (F::Outputs::filled(1.0), F::Outputs::filled(F::Inputs::filled(1.0)));
    let compute = move |i: &F::Inputs<f64>| {
        black_box(&{ *i });
        *black_box(&written)
    };
    Kernel::new(typed, compute, |_| Vec::new())
}

/// A chain of multiplications, divisions and square roots, each waiting for the one before.
fn yardstick() -> Runner {
    Box::new(|_, count| {
        for _ in 0..count {
            let mut x = black_box(2.0_f64);
            for _ in 0..4 {
                x = (x * 1.5 + 1.0 / x).sqrt();
            }
            black_box(x);
        }
    })
}
