//! Timing: all methods take turns in every round, so that a slow moment of the machine affects all alike.

use super::exact::HardPoint;
use super::{Measurement, Options, PointTime, Time};
use crate::formula::proof::Proved;
use crate::formula::proof::method::{Kernel, Method, Runner};
use crate::formula::{Fields, typed};
use std::hint::black_box;
use std::time::Instant;

/// Returns the time in nanoseconds since some fixed moment.
pub(super) type Clock<'a> = &'a dyn Fn() -> f64;

/// A clock of the machine that starts now.
pub(super) fn clock() -> impl Fn() -> f64 {
    let start = Instant::now();
    move || start.elapsed().as_secs_f64() * 1e9
}

/// The references timed alongside the methods.
const COPY: &str = "copy";
const YARDSTICK: &str = "yardstick";

/// The methods that are also timed at every hard point.
const AT_HARD_POINTS: [&str; 2] = ["closed", "checked"];

/// The points at which time is measured.
pub(super) struct Points {
    /// Timed as a whole.
    pub(super) random: Vec<Vec<f64>>,
    /// Timed one by one.
    pub(super) hard: Vec<HardPoint>,
}

/// A quantity to be timed.
#[derive(Clone, Copy, PartialEq)]
struct Task {
    method: &'static str,
    with_jacobian: bool,
    /// The hard point; `None` for the random points.
    hard: Option<usize>,
}

/// The length and frequency of turns.
#[derive(Clone, Copy)]
struct Pace {
    points: usize,
    turn_ns: f64,
    every: usize,
    rounds: usize,
}

impl Pace {
    fn new(options: &Options) -> Self {
        let Options { timing_points, turn_ns, rounds, .. } = *options;
        Self { points: timing_points.max(1), turn_ns, every: 1, rounds }
    }

    /// For hard points, which are many, turns are shorter and less frequent.
    fn short(self) -> Self {
        Self { turn_ns: self.turn_ns / 8.0, every: 4, ..self }
    }
}

/// Stack offsets, in another eighth of a page each and at another position within a cache line. Results lie on the stack, and
/// some formulas take a third longer when a result straddles a cache line, and three times as long at the end of a page. The
/// offset changes from turn to turn, so that times do not depend on that of a particular build or process.
const PLACES: [fn(&mut dyn FnMut()); 8] = [
    with_room::<0>,
    with_room::<528>,
    with_room::<1056>,
    with_room::<1584>,
    with_room::<2112>,
    with_room::<2640>,
    with_room::<3168>,
    with_room::<3696>,
];

/// Runs with BYTES more bytes on the stack.
#[inline(never)]
fn with_room<const BYTES: usize>(run: &mut dyn FnMut()) {
    let mut room = [0_u8; BYTES];
    black_box(&mut room);
    run();
    black_box(&mut room);
}

/// A loop that takes a turn in every round, or in every n-th if its turns are long.
struct Contestant {
    task: Task,
    run: Runner,
    /// Points per call of the loop, and calls per turn.
    points: usize,
    calls: usize,
    /// Takes part in every n-th round.
    every: usize,
    /// Nanoseconds per evaluation, with the round.
    samples: Vec<(usize, f64)>,
}

/// Fills in the times of a measurement.
pub(super) fn time(
    methods: &[Method],
    [copy, yardstick]: [Runner; 2],
    points: &Points,
    (options, clock): (&Options, Clock),
    measurement: &mut Measurement,
) {
    let pace = Pace::new(options);
    let mut contestants: Vec<_> = methods.iter().flat_map(|method| of_method(method, points, pace, clock)).collect();
    let beside = |method, with_jacobian| Task { method, with_jacobian, hard: None };
    for (task, run) in [(beside(COPY, true), copy), (beside(YARDSTICK, false), yardstick)] {
        contestants.push(Contestant::new(task, run, pace, clock));
    }
    for round in 0..options.rounds.max(1) {
        // Each round starts with another contestant, so that none always inherits the caches of the same neighbour.
        let first = round % contestants.len();
        let (head, tail) = contestants.split_at_mut(first);
        tail.iter_mut().chain(head).for_each(|contestant| contestant.take_turn(round, clock));
    }
    enter(&contestants, &points.hard, measurement);
}

/// The value and the Jacobian of a method, over random points and at hard ones.
fn of_method(method: &Method, points: &Points, pace: Pace, clock: Clock) -> Vec<Contestant> {
    let mut contestants = Vec::new();
    for (kernel, with_jacobian) in [(&method.value, false), (&method.jacobian, true)] {
        let Some(kernel) = kernel else { continue };
        let task = Task { method: method.id, with_jacobian, hard: None };
        contestants.push(Contestant::new(task, (kernel.runner)(&points.random), pace, clock));
        if AT_HARD_POINTS.contains(&method.id) {
            contestants.extend(points.hard.iter().enumerate().map(|(k, point)| {
                // The same loop as over random points, with every point equal to this one.
                let run = (kernel.runner)(&vec![point.inputs.clone(); pace.points]);
                Contestant::new(Task { hard: Some(k), ..task }, run, pace.short(), clock)
            }));
        }
    }
    contestants
}

impl Contestant {
    /// Determines how many evaluations fill a turn, which also warms it up.
    fn new(task: Task, run: Runner, pace: Pace, clock: Clock) -> Self {
        let Pace { points: all, turn_ns, every, rounds } = pace;
        let mut contestant = Self { task, run, points: 1, calls: 1, every, samples: Vec::new() };
        let mut one = contestant.least(clock);
        if one * number(all) < turn_ns {
            contestant.points = all;
            one = contestant.least(clock);
        }
        let call = (one * number(contestant.points)).max(1.0);
        contestant.calls = whole(turn_ns / call);
        if contestant.points == 1 {
            contestant.points = whole(turn_ns / call).min(all);
            contestant.calls = 1;
        }
        // A contestant whose turn is long even with one evaluation takes part less often, but at least five times.
        let long = whole(one / turn_ns / 4.0);
        contestant.every = long.min(rounds / 5).max(every);
        contestant
    }

    /// The shortest of several turns: the first is cold, and others may be interrupted.
    fn least(&mut self, clock: Clock) -> f64 {
        (0..4).map(|turn| self.turn(turn, clock)).fold(f64::INFINITY, f64::min)
    }

    /// Nanoseconds per evaluation in its n-th turn.
    fn turn(&mut self, n: usize, clock: Clock) -> f64 {
        let mut time = 0.0;
        PLACES[n % PLACES.len()](&mut || {
            if self.calls > 1 {
                // Brings its code and its points back into the caches, from which other contestants have evicted them.
                (self.run)(self.points);
            }
            let start = clock();
            (0..self.calls).for_each(|_| (self.run)(self.points));
            time = clock() - start;
        });
        time / number(self.calls * self.points)
    }

    fn take_turn(&mut self, round: usize, clock: Clock) {
        if round.is_multiple_of(self.every) {
            let time = self.turn(self.samples.len(), clock);
            self.samples.push((round, time));
        }
    }

    /// Its time relative to that of another contestant, round by round.
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

/// Rounded down, but at least 1.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
fn whole(x: f64) -> usize {
    x.clamp(1.0, 1e9) as usize
}

/// Stores the times in the measurement.
fn enter(contestants: &[Contestant], hard: &[HardPoint], measurement: &mut Measurement) {
    let find = |method: &str, with_jacobian, hard| {
        let is_it = |task: Task| task.method == method && task.with_jacobian == with_jacobian && task.hard == hard;
        contestants.iter().find(|contestant| is_it(contestant.task))
    };
    let unit = find("closed", false, None);
    for method in &mut measurement.methods {
        for (figures, with_jacobian) in [(&mut method.value, false), (&mut method.jacobian, true)] {
            let (Some(figures), Some(contestant)) = (figures, find(&method.id, with_jacobian, None)) else { continue };
            figures.time = contestant.time();
            figures.ratio = unit.and_then(|unit| Time::of(contestant.ratios(unit)));
            let point_time = |(k, point): (usize, &HardPoint)| {
                let at_point = find(&method.id, with_jacobian, Some(k))?;
                Some(PointTime {
                    case: point.case.clone(),
                    ordinary: point.is_ordinary(),
                    time: at_point.time()?,
                    ratio: Time::of(at_point.ratios(contestant))?,
                })
            };
            figures.hard_times = hard.iter().enumerate().filter_map(point_time).collect();
        }
    }
    measurement.copy = find(COPY, true, None).and_then(Contestant::time);
    measurement.yardstick = find(YARDSTICK, false, None).and_then(Contestant::time);
}

/// The references timed alongside the methods, over these points.
pub(super) fn beside<F: Proved>(points: &Points) -> [Runner; 2] {
    [(copy::<F>().runner)(&points.random), yardstick()]
}

/// Reads every input and writes every output and Jacobian entry, and does nothing else.
fn copy<F: Proved>() -> Kernel {
    let written = (F::Outputs::filled(1.0), F::Outputs::filled(F::Inputs::filled(1.0)));
    let compute = move |i: &F::Inputs<f64>| {
        black_box(&{ *i });
        *black_box(&written)
    };
    Kernel::new(typed, compute, |_| Vec::new())
}

/// The same arithmetic for every formula.
fn yardstick() -> Runner {
    Box::new(|count| {
        for _ in 0..count {
            black_box(chain(black_box(2.0)));
        }
    })
}

/// A chain of multiplications, divisions and square roots, each of which depends on the previous one.
fn chain(x: f64) -> f64 {
    (0..4).fold(x, |x, _| (x * 1.5 + 1.0 / x).sqrt())
}

#[cfg(test)]
mod tests;
