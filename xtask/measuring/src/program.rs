//! The program that measures: it reads a [`Request`] and writes one [`Event`] per line.

use super::{Build, Event, Request};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::measure::{Measurement, Options};
use std::error::Error;
use std::io::{Read, Write, stdin, stdout};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// All formulas that can be requested.
type Catalog<'a> = &'a [&'static dyn AnyFormula];

/// `<dyn AnyFormula>::errors`
type Errors = fn(&(dyn AnyFormula + 'static), &Options) -> Measurement;

/// `<dyn AnyFormula>::times`
type Times = fn(&(dyn AnyFormula + 'static), &Options, &mut Measurement);

/// Reads a request from standard input and writes events to standard output.
///
/// Formulas can be measured if the feature `measure-by-id` of `jointproof` is enabled, which takes long to compile. The program
/// enables it and passes both functions in, so that the commands that communicate with it compile without it.
pub fn main(catalog: &[&'static dyn AnyFormula], errors: Errors, times: Times) -> ExitCode {
    match answer(catalog, (errors, times), stdin().lock(), stdout().lock()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // If standard error is closed, there is no point in failing again.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn answer(
    catalog: Catalog<'_>,
    by: (Errors, Times),
    input: impl Read,
    mut out: impl Write,
) -> Result<(), Box<dyn Error>> {
    let request =
        serde_json::from_reader(input).map_err(|error| format!("no request of `report` on standard input: {error}"))?;
    measure(catalog, by, &request, |event| {
        serde_json::to_writer(&mut out, &event)?;
        out.write_all(b"\n")?;
        Ok(out.flush()?)
    })
}

/// Measures errors on all cores, then times, one formula after the other on an otherwise idle machine, and then all of
/// them again: a disturbance of some seconds affects only one half of the rounds, and shows in the spread. An error of
/// `tell` ends the measurement.
fn measure<E>(
    catalog: Catalog<'_>,
    (errors, times): (Errors, Times),
    request: &Request,
    mut tell: impl FnMut(Event) -> Result<(), E>,
) -> Result<(), E> {
    tell(Event::Begun(Build::this()))?;
    let find = |id: &String| catalog.iter().copied().find(|formula| formula.spec().id == id);
    let formulas: Vec<_> = request.formulas.iter().filter_map(find).collect();
    let mut compared = compare(&formulas, errors, &request.options, |id| tell(Event::Compared(id)))?;
    compared.sort_by_key(|(k, _)| *k);
    let half = half(&request.options);
    for (k, first) in &mut compared {
        times(formulas[*k], &half, first);
        tell(Event::Timed(first.formula.clone()))?;
    }
    for (k, first) in compared {
        let mut second = first.clone();
        times(formulas[k], &half, &mut second);
        tell(Event::Measured(Box::new(first.and(&second))))?;
    }
    Ok(())
}

/// The errors of every formula, with its index.
fn compare<E>(
    formulas: Catalog<'_>,
    errors: Errors,
    options: &Options,
    mut tell: impl FnMut(String) -> Result<(), E>,
) -> Result<Vec<(usize, Measurement)>, E> {
    let next = AtomicUsize::new(0);
    let (done, results) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            let (next, done) = (&next, done.clone());
            scope.spawn(move || {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    let Some(formula) = formulas.get(k) else { break };
                    if done.send((k, errors(*formula, options))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(done);
        let mut compared = Vec::new();
        for result in results {
            tell(result.1.formula.clone())?;
            compared.push(result);
        }
        Ok(compared)
    })
}

/// The options for half of the rounds.
fn half(options: &Options) -> Options {
    Options { rounds: options.rounds.div_ceil(2), ..*options }
}

#[cfg(test)]
mod tests {
    use super::{Errors, Times, answer, compare, half, measure};
    use crate::{Build, Event, Request};
    use jointproof::catalog::{AnyFormula, CATALOG};
    use jointproof::toolkit::measure::Options;
    use std::thread;

    const ERRORS: Errors = <dyn AnyFormula>::errors;
    const BY: (Errors, Times) = (ERRORS, <dyn AnyFormula>::times);

    #[test]
    fn both_halves_have_as_many_rounds_as_are_asked_for() {
        let rounds = [1, 6, 61].map(|rounds| half(&Options { rounds, ..Options::quick() }).rounds);
        assert_eq!(rounds, [1, 3, 31]);
    }

    /// The smallest measurement possible.
    const LEAST: Options = Options {
        random_points: 3,
        timing_points: 2,
        rounds: 2,
        turn_ns: 1e3,
        column_bytes: 1,
        steps_per_decade: 1,
        ..Options::quick()
    };

    /// There are more formulas than threads.
    #[test]
    fn the_errors_of_every_formula_are_found() {
        let count = thread::available_parallelism().map_or(1, usize::from) + 2;
        let formula: &'static dyn AnyFormula = &jointproof::connector::slot::ContactForce;
        let mut reported = Vec::new();
        let options = Options { random_points: 1, ..LEAST };
        let found = compare(&vec![formula; count], ERRORS, &options, |id| {
            reported.push(id);
            Ok::<_, ()>(())
        });
        let mut numbers: Vec<_> = found.unwrap().into_iter().map(|(k, _)| k).collect();
        numbers.sort_unstable();
        assert_eq!(numbers, (0..count).collect::<Vec<_>>());
        assert_eq!(reported, vec!["slot.contact_force"; count]);
    }

    #[test]
    fn nothing_is_told_to_whom_it_failed_to_be_told() {
        let request = Request { formulas: vec!["slot.contact_force".into(); 2], options: LEAST };
        for last in [1, 2, 4, 6] {
            let mut reported = 0;
            let ended = measure(CATALOG, BY, &request, |_| {
                reported += 1;
                if reported == last { Err("enough") } else { Ok(()) }
            });
            assert_eq!((ended, reported), (Err("enough"), last));
        }
    }

    #[test]
    fn a_request_is_answered_event_by_event() {
        // The errors of the second are known before those of the first.
        let ids = ["align.rows", "coulomb.yield"];
        let request = Request { formulas: ids.map(String::from).into(), options: LEAST };
        let mut out = Vec::new();
        answer(CATALOG, BY, serde_json::to_string(&request).unwrap().as_bytes(), &mut out).unwrap();
        let events = String::from_utf8(out).unwrap();
        let mut events: Vec<Event> = events.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        // Errors are measured on all cores, and reported as they arrive.
        events[1..3].sort_by_key(|event| format!("{event:?}"));
        let [begun, events @ ..] = events.as_slice() else { panic!("nothing is told") };
        assert_eq!(*begun, Event::Begun(Build::this()));
        let reported: Vec<_> = events
            .iter()
            .map(|event| match event {
                Event::Begun(_) => panic!("it begins once"),
                Event::Compared(id) => ("compared", id.as_str()),
                Event::Timed(id) => ("timed", id.as_str()),
                Event::Measured(measurement) => {
                    // In two rounds, not all times are the same.
                    let mut times = measurement.methods.iter().filter_map(|method| method.jacobian.as_ref()?.time);
                    assert!(times.any(|time| time.low < time.high), "{measurement:?}");
                    ("measured", measurement.formula.as_str())
                }
            })
            .collect();
        let expected = ["compared", "timed", "measured"].map(|what| ids.map(|id| (what, id)));
        assert_eq!(reported, expected.concat());
        let said = answer(CATALOG, BY, "no".as_bytes(), &mut Vec::new()).unwrap_err().to_string();
        assert!(said.starts_with("no request of `report` on standard input"), "{said}");
    }
}
