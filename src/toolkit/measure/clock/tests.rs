//! Contestants of known cost, timed by a clock that measures the work they have done.

use super::*;
use crate::toolkit::measure::{Errors, Figures, MethodFigures};
use std::cell::Cell;
use std::rc::Rc;

/// Nanoseconds of work done so far.
type Work = Rc<Cell<f64>>;

/// The cost of a method at a point, in nanoseconds: at random points, whose only component is below 1, and at hard ones.
type Cost = fn(f64) -> f64;

/// A kernel that does nothing but advance the clock.
fn kernel(work: &Work, cost: Cost) -> Kernel {
    let work = work.clone();
    Kernel {
        results: Box::new(|_| Vec::new()),
        runner: Box::new(move |points| {
            let (work, points) = (work.clone(), points.to_vec());
            Box::new(move |count| points[..count].iter().for_each(|point| work.set(work.get() + cost(point[0]))))
        }),
    }
}

fn no_figures() -> Figures {
    let random = Errors::of([]);
    Figures { time: None, ratio: None, hard_times: Vec::new(), random, hard: None }
}

/// The times of methods with these costs of value and Jacobian.
fn timed(methods: &[(&'static str, Cost, Cost)], options: &Options) -> Measurement {
    let work = Work::default();
    let of = |&(id, value, jacobian): &(&'static str, Cost, Cost)| {
        Method::of(id, "").value(kernel(&work, value)).jacobian(kernel(&work, jacobian))
    };
    let kernels: Vec<_> = methods.iter().map(of).collect();
    let figures = |method: &Method| MethodFigures {
        id: method.id.into(),
        title: String::new(),
        step: None,
        value: Some(no_figures()),
        jacobian: Some(no_figures()),
    };
    let mut measurement = Measurement {
        formula: "t.t".into(),
        inputs: 1,
        outputs: 1,
        random_points: 0,
        hard_points: 3,
        copy: None,
        yardstick: None,
        columns: None,
        methods: kernels.iter().map(figures).collect(),
        curves: Vec::new(),
    };
    let hard = |case: &str, x: f64| HardPoint { case: case.into(), inputs: vec![x] };
    let random = (0..8).map(|k| vec![f64::from(k) / 8.0]).collect();
    let points = Points { random, hard: vec![hard("near", 1.5), hard("far", 2.0), hard("extreme", 1e200)] };
    let beside: [Cost; 2] = [|_| 3.0, |_| 12.0];
    let beside = beside.map(|cost| (kernel(&work, cost).runner)(&points.random));
    let clock = {
        let work = work.clone();
        move || work.get()
    };
    time(&kernels, beside, &points, (options, &clock), &mut measurement);
    measurement
}

fn options() -> Options {
    Options { timing_points: 8, rounds: 20, turn_ns: 10e3, ..Options::quick() }
}

fn same(time: f64) -> Time {
    Time { median: time, low: time, high: time }
}

fn assert_time(found: Option<Time>, expected: f64) {
    let found = found.expect("it was timed");
    for (found, expected) in [(found.median, expected), (found.low, expected), (found.high, expected)] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} is not {expected}");
    }
}

/// Hard points cost two and five times as much as random ones, the extreme one forty times.
const CLOSED: Cost = |x| match x {
    x if x < 1.0 => 10.0,
    x if x < 2.0 => 20.0,
    x if x < 10.0 => 50.0,
    _ => 400.0,
};
const WITH_JACOBIAN: Cost = |x| CLOSED(x) * 3.0;
const SLOW: Cost = |_| 700.0;

#[test]
fn times_are_nanoseconds_an_evaluation_and_ratios_are_to_the_value_of_the_closed_form() {
    let measured = timed(&[("closed", CLOSED, WITH_JACOBIAN), ("ad", SLOW, |_| 2e5)], &options());
    let expected = [("closed", 10.0, 30.0), ("ad", 700.0, 2e5)];
    for (id, value, jacobian) in expected {
        let method = measured.method(id).unwrap();
        for (figures, time) in [(&method.value, value), (&method.jacobian, jacobian)] {
            let figures = figures.as_ref().unwrap();
            assert_time(figures.time, time);
            assert_time(figures.ratio, time / 10.0);
        }
    }
    assert_time(measured.copy, 3.0);
    assert_time(measured.yardstick, 12.0);
}

#[test]
fn every_hard_point_is_timed_alone_in_units_of_random_ones() {
    let measured = timed(&[("closed", CLOSED, WITH_JACOBIAN), ("checked", SLOW, SLOW), ("ad", SLOW, SLOW)], &options());
    let closed = measured.method("closed").unwrap();
    for (figures, factor) in [(&closed.value, 1.0), (&closed.jacobian, 3.0)] {
        let figures = figures.as_ref().unwrap();
        let times: Vec<_> = figures.hard_times.iter().map(|at| (at.case.as_str(), at.ordinary)).collect();
        assert_eq!(times, [("near", true), ("far", true), ("extreme", false)]);
        for (at, time) in figures.hard_times.iter().zip([20.0, 50.0, 400.0]) {
            assert_time(Some(at.time), time * factor);
            assert_time(Some(at.ratio), time / 10.0);
        }
        // Points that do not occur in models do not count.
        assert_eq!(figures.hardest().map(|at| at.case.as_str()), Some("far"));
    }
    let timed_at_hard = |id| measured.method(id).unwrap().value.as_ref().unwrap().hard_times.len();
    assert_eq!(["closed", "checked", "ad"].map(timed_at_hard), [3, 3, 0]);
}

/// A method that becomes slower round by round has the time of the middle round, and four of five rounds between low and high.
#[test]
fn the_spread_is_that_of_the_rounds() {
    let work = Work::default();
    let round = Rc::new(Cell::new(0.0));
    let runner = |growth: f64| -> Runner {
        let (work, round) = (work.clone(), round.clone());
        Box::new(move |count| work.set(work.get() + number(count) * (100.0 + growth * round.get())))
    };
    let clock = {
        let work = work.clone();
        move || work.get()
    };
    let pace = Pace { points: 4, turn_ns: 1e4, every: 1, rounds: 11 };
    let task = Task { method: "closed", with_jacobian: false, hard: None };
    let [mut steady, mut growing] = [0.0, 10.0].map(|growth| Contestant::new(task, runner(growth), pace, &clock));
    for k in 0..11_u8 {
        round.set(f64::from(k));
        steady.take_turn(usize::from(k), &clock);
        growing.take_turn(usize::from(k), &clock);
    }
    assert_time(steady.time(), 100.0);
    let Time { median, low, high } = growing.time().unwrap();
    assert_eq!([median, low, high].map(f64::round), [150.0, 110.0, 190.0]);
    let ratio = Time::of(growing.ratios(&steady)).unwrap();
    assert_eq!([ratio.median, ratio.low, ratio.high].map(|x| (x * 100.0).round()), [150.0, 110.0, 190.0]);
}

/// A turn has the intended length, whatever the cost of an evaluation; contestants with longer turns take part less
/// often, but at least five times.
#[test]
fn turns_are_as_long_as_they_should_be() {
    let pace = Pace { points: 100, turn_ns: 1e4, every: 1, rounds: 40 };
    let task = Task { method: "ad", with_jacobian: false, hard: None };
    // Cost of an evaluation; points per call, calls per turn, and rounds per turn.
    for (cost, expected) in [
        (1.0, (100, 100, 1)),
        (40.0, (100, 2, 1)),
        (500.0, (20, 1, 1)),
        (2e4, (1, 1, 1)),
        (8e4, (1, 1, 2)),
        (1e9, (1, 1, 8)),
    ] {
        let work = Work::default();
        let run: Runner = {
            let work = work.clone();
            Box::new(move |count| work.set(work.get() + number(count) * cost))
        };
        let mut contestant = Contestant::new(task, run, pace, &|| work.get());
        assert_eq!((contestant.points, contestant.calls, contestant.every), expected, "{cost}");
        (0..40).for_each(|round| contestant.take_turn(round, &|| work.get()));
        assert_eq!(contestant.samples.len(), 40_usize.div_ceil(expected.2), "{cost}");
        assert_time(contestant.time(), cost);
    }
    let short = pace.short();
    assert_eq!((short.points, short.turn_ns, short.every, short.rounds), (100, 1250.0, 4, 40));
}

/// Each round starts with another contestant.
#[test]
fn no_contestant_always_follows_the_same() {
    let order = Rc::new(std::cell::RefCell::new(Vec::new()));
    let work = Work::default();
    let runner = |name: char| -> Runner {
        let (order, work) = (order.clone(), work.clone());
        Box::new(move |_| {
            order.borrow_mut().push(name);
            work.set(work.get() + 1e6);
        })
    };
    let no_points = Points { random: Vec::new(), hard: Vec::new() };
    let mut nothing = timed(&[], &options());
    let options = Options { rounds: 4, ..options() };
    order.borrow_mut().clear();
    let clock = {
        let work = work.clone();
        move || work.get()
    };
    time(&[], [runner('c'), runner('y')], &no_points, (&options, &clock), &mut nothing);
    // Four turns each to determine their length, with one call each, and again with as many points as fill a turn.
    let rounds: String = order.borrow().iter().rev().take(8).rev().collect();
    assert_eq!(rounds, "cyyccyyc");
}

/// Rounds are kept apart: a time is divided by that of the other contestant in the same round, and only if it had a turn.
#[test]
fn ratios_are_of_times_of_one_round() {
    let of = |every, samples: &[(usize, f64)]| {
        let task = Task { method: "ad", with_jacobian: true, hard: None };
        Contestant { task, run: Box::new(|_| ()), points: 1, calls: 1, every, samples: samples.to_vec() }
    };
    let unit = of(1, &[(0, 2.0), (1, 8.0), (2, 4.0), (4, 16.0)]);
    assert_eq!(of(1, &[(1, 4.0), (2, 12.0), (3, 5.0), (4, 16.0)]).ratios(&unit), [0.5, 3.0, 1.0]);
}

#[test]
fn four_turns_tell_how_long_one_is() {
    let pace = Pace { points: 100, turn_ns: 1e4, every: 1, rounds: 40 };
    let task = Task { method: "ad", with_jacobian: false, hard: None };
    // Two calls fill a turn, after an untimed one; or a single long one does.
    for (cost, expected, first) in [(40.0, &[1, 1, 1, 1, 100, 100, 100, 100][..], 3), (500.0, &[1; 4][..], 1)] {
        let (work, counts) = (Work::default(), Rc::new(std::cell::RefCell::new(Vec::new())));
        let run: Runner = {
            let (work, counts) = (work.clone(), counts.clone());
            Box::new(move |count| {
                counts.borrow_mut().push(count);
                work.set(work.get() + number(count) * cost);
            })
        };
        let mut contestant = Contestant::new(task, run, pace, &|| work.get());
        assert_eq!(*counts.borrow(), expected, "{cost}");
        contestant.take_turn(0, &|| work.get());
        assert_eq!(counts.borrow().len() - expected.len(), first, "{cost}");
    }
    // A call without measurable time counts as a nanosecond.
    let contestant = Contestant::new(task, Box::new(|_| ()), pace, &|| 7.0);
    assert_eq!((contestant.points, contestant.calls, contestant.every), (100, 10_000, 1));
}

#[test]
fn every_round_and_every_point_count_unless_there_are_none() {
    let pace = |timing_points| {
        let Pace { points, turn_ns, every, rounds } = Pace::new(&Options { timing_points, ..options() });
        (points, turn_ns, every, rounds)
    };
    assert_eq!([0, 1, 8].map(pace), [1, 1, 8].map(|points| (points, 10e3, 1, 20)));
    let no_points = Points { random: Vec::new(), hard: Vec::new() };
    let mut calls = [0, 1, 2].map(|rounds| {
        let (work, calls) = (Work::default(), Rc::new(Cell::new(0)));
        let runner = || -> Runner {
            let (work, calls) = (work.clone(), calls.clone());
            Box::new(move |_| {
                calls.set(calls.get() + 1);
                work.set(work.get() + 1e6);
            })
        };
        let mut measurement = timed(&[], &options());
        time(
            &[],
            [runner(), runner()],
            &no_points,
            (&Options { rounds, ..options() }, &|| work.get()),
            &mut measurement,
        );
        calls.get()
    });
    let one_round = calls[1];
    for calls in &mut calls {
        *calls -= one_round;
    }
    assert_eq!(calls, [0, 0, 2]);
}

#[test]
fn a_clock_goes_on() {
    let clock = clock();
    let before = clock();
    std::thread::sleep(std::time::Duration::from_millis(2));
    let passed = clock() - before;
    assert!(passed >= 2e6, "{passed} ns in two milliseconds");
}

#[test]
fn both_halves_count_alike() {
    let time = |median, low, high| Some(Time { median, low, high });
    let half = |scale: f64| {
        let mut half = timed(&[("closed", CLOSED, WITH_JACOBIAN)], &options());
        half.copy = time(3.0 * scale, 2.0 * scale, 5.0 * scale);
        half.yardstick = time(12.0 * scale, 11.0 * scale, 13.0 * scale);
        let figures = half.methods[0].value.as_mut().unwrap();
        figures.time = time(10.0 * scale, 9.0 * scale, 12.0 * scale);
        figures.ratio = time(1.0 * scale, 0.9 * scale, 1.2 * scale);
        let at = &mut figures.hard_times[2];
        (at.time, at.ratio) = (same(400.0 * scale), same(40.0 * scale));
        half
    };
    let both = half(1.0).and(&half(2.0));
    assert_eq!((both.copy, both.yardstick), (time(4.5, 2.0, 10.0), time(18.0, 11.0, 26.0)));
    let figures = both.methods[0].value.as_ref().unwrap();
    assert_eq!((figures.time, figures.ratio), (time(15.0, 9.0, 24.0), time(1.5, 0.9, 2.4)));
    assert_eq!(Some(figures.hard_times[2].time), time(600.0, 400.0, 800.0));
    assert_eq!(Some(figures.hard_times[2].ratio), time(60.0, 40.0, 80.0));
    let jacobian = both.methods[0].jacobian.as_ref().unwrap();
    assert_time(jacobian.time, 30.0);
    assert_eq!(half(2.0).and(&half(1.0)), half(1.0).and(&half(2.0)));
    // Nothing is invented for a half without times.
    let mut untimed = half(1.0);
    untimed.copy = None;
    assert_eq!(half(1.0).and(&untimed).copy, None);
}

/// The number was computed by a Python interpreter.
#[test]
fn the_yardstick_is_the_same_arithmetic_in_every_version() {
    assert_eq!(chain(2.0).to_bits(), 1.808_775_336_651_888_f64.to_bits());
}
