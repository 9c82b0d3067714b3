//! Many points at once, in columns: a batch on one thread and on all, compared with a plain loop over the same columns
//! and with the memory bandwidth.

use super::options::random;
use super::{Columns, Options, Time};
use crate::formula::proof::Proved;
use crate::formula::{self, Fields};
use crate::toolkit::batch::{
    ArrayView1, ArrayViewMut1, Error, Job, Linearized, Row, columns, of_components, value_and_jacobian,
};
use crate::toolkit::verify::Subject;
use ndarray::Array2;
use rayon::prelude::*;
use std::hint::black_box;

/// The number of distinct points in the columns: enough that the branch predictor cannot memorise them.
const POINTS: usize = 1024;
/// The least number of rows.
const LEAST: usize = 256;
/// Turns are long: each takes place in one of this many rounds.
const EVERY: usize = 12;

/// Returns the time in nanoseconds, on any thread.
type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);

/// The work timed for a formula, as function pointers, so that the timing code is compiled only once.
#[derive(Clone, Copy)]
struct Work {
    inputs: usize,
    outputs: usize,
    /// Results per row.
    results: usize,
    batch: Batch,
    looped: Looped,
}

impl Work {
    fn of<F: Proved>() -> Self {
        Self {
            inputs: F::Inputs::<f64>::LEN,
            outputs: F::Outputs::<f64>::LEN,
            results: <Linearized as Job<F>>::LEN,
            batch: value_and_jacobian::<F>,
            looped: looped::<F>,
        }
    }
}

type Batch = fn(&[ArrayView1<f64>], &mut [ArrayViewMut1<f64>], &mut [ArrayViewMut1<f64>]) -> Result<(), Error>;
type Looped = fn(&[&[f64]], &mut [&mut [f64]]) -> usize;

/// Times value and Jacobian over columns, with all methods taking turns.
pub(super) fn time<F: Proved>(options: &Options, clock: Clock) -> Option<Columns> {
    let points = random(&Subject::of::<F>(), options.seed, POINTS);
    timed(Work::of::<F>(), &points, options, clock)
}

fn timed(work: Work, points: &[Vec<f64>], options: &Options, clock: Clock) -> Option<Columns> {
    let numbers = work.inputs + work.results;
    let bytes = numbers * size_of::<f64>();
    let rows = (options.column_bytes / bytes).max(LEAST);
    let mut tables = Tables::new(points, rows, numbers);
    let thread = one_thread()?;
    let mut turns = [const { Vec::new() }; 5];
    for _ in 0..options.rounds.div_ceil(EVERY) {
        let taken = [
            thread.install(|| a_row(rows, clock, || tables.looped(work))),
            thread.install(|| a_row(rows, clock, || tables.batch(work))),
            a_row(rows, clock, || tables.batch(work)),
            thread.install(|| a_row(rows, clock, || tables.copy())),
            a_row(rows, clock, || tables.copy()),
        ];
        turns.iter_mut().zip(taken).for_each(|(turns, turn)| turns.push(turn));
    }
    let ratios = |of: &[f64], unit: &[f64]| Time::of(of.iter().zip(unit).map(|(of, unit)| of / unit).collect());
    let [looped, one, all, copy, copies] = &turns;
    Some(Columns {
        rows,
        bytes,
        threads: rayon::current_num_threads(),
        one_over_loop: ratios(one, looped)?,
        all_over_loop: ratios(all, looped)?,
        one_over_copy: ratios(one, copy)?,
        all_over_copy: ratios(all, copies)?,
        looped: Time::of(looped.clone())?,
        one_thread: Time::of(one.clone())?,
        all_threads: Time::of(all.clone())?,
    })
}

fn one_thread() -> Option<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().ok()
}

/// The time per row in a second pass: the first one loads the columns into the caches of the processor in use.
#[expect(clippy::cast_precision_loss, reason = "rows are far below 2^53")]
fn a_row(rows: usize, clock: Clock, mut work: impl FnMut()) -> f64 {
    work();
    let start = clock();
    work();
    (clock() - start) / rows as f64
}

/// Columns of inputs and results, and the same number of bytes to be copied.
struct Tables {
    inputs: Array2<f64>,
    results: Array2<f64>,
    from: Vec<f64>,
    to: Vec<f64>,
}

impl Tables {
    fn new(points: &[Vec<f64>], rows: usize, numbers: usize) -> Self {
        let mut inputs = columns(points[0].len(), rows);
        for (k, mut column) in inputs.rows_mut().into_iter().enumerate() {
            column.iter_mut().zip(points.iter().cycle()).for_each(|(x, point)| *x = point[k]);
        }
        let mut results = columns(numbers - points[0].len(), rows);
        // Pages that were never written are not yet allocated.
        results.fill(1.0);
        let half = rows * numbers / 2;
        Self { inputs, results, from: vec![1.0; half], to: vec![2.0; half] }
    }

    fn batch(&mut self, work: Work) {
        let inputs: Vec<_> = self.inputs.rows().into_iter().collect();
        let mut results: Vec<_> = self.results.rows_mut().into_iter().collect();
        let (value, jacobian) = results.split_at_mut(work.outputs);
        // Rejected rows count too.
        let _ = black_box((work.batch)(black_box(&inputs), value, jacobian));
        black_box(&mut self.results);
    }

    fn looped(&mut self, work: Work) {
        let inputs: Vec<_> =
            self.inputs.rows().into_iter().filter_map(|column: ArrayView1<f64>| column.to_slice()).collect();
        let results = self.results.rows_mut().into_iter();
        let mut results: Vec<_> = results.filter_map(ArrayViewMut1::into_slice).collect();
        black_box((work.looped)(black_box(&inputs), &mut results));
        black_box(&mut self.results);
    }

    fn copy(&mut self) {
        let share = self.from.len().div_ceil(rayon::current_num_threads());
        let shares = self.to.par_chunks_mut(share).zip(self.from.par_chunks(share));
        shares.for_each(|(to, from)| black_box(to).copy_from_slice(black_box(from)));
    }
}

/// A program without batches: the checked call at every row. Returns the number of rejected rows.
#[inline(never)]
fn looped<F: Proved>(inputs: &[&[f64]], results: &mut [&mut [f64]]) -> usize {
    let inputs = &inputs[..F::Inputs::<f64>::LEN];
    let columns = &mut results[..<Linearized as Job<F>>::LEN];
    let mut refused = 0;
    (0..inputs[0].len()).for_each(|row| match formula::value_and_jacobian::<F>(&of_components(|k| inputs[k][row])) {
        Ok(results) => <Linearized as Job<F>>::show(&results, &mut Row::new(columns, row)),
        Err(_) => refused += 1,
    });
    refused
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::formula::quantity::{Domain, Quantity, Unit};
    use crate::formula::{Component, Document, Formula, Jacobian, Spec};
    use crate::{Scalar, fields};
    use std::sync::Mutex;

    const X: Quantity = Quantity::scalar("x", Unit::ONE, Domain::Real, "a number");
    const Y: Quantity = Quantity::scalar("y", Unit::ONE, Domain::Real, "its square");
    fields! { struct Number<T> { x: T = X } }
    fields! { struct Squared<T> { y: T = Y } }

    #[derive(Clone, Copy)]
    struct Square;

    impl Formula for Square {
        const SPEC: Spec = Spec::new("t.square", "Square", Document::new("Squares").printed(""));
        type Inputs<T: Component> = Number<T>;
        type Outputs<T: Component> = Squared<T>;
        fn eval<D: Scalar>(i: &Number<D>) -> Squared<D> {
            Squared { y: i.x * i.x }
        }
        fn jacobian<D: Scalar>(i: &Number<D>) -> Jacobian<Self, D> {
            Squared { y: Number { x: i.x * 2.0 } }
        }
    }

    impl Proved for Square {}

    #[test]
    fn a_formula_of_one_number_has_one_column() {
        let mut results = [[0.0; 2]; 2];
        let mut columns: Vec<_> = results.iter_mut().map(<[f64; 2]>::as_mut_slice).collect();
        assert_eq!(looped::<Square>(&[&[3.0, -4.0]], &mut columns), 0);
        assert_eq!(results, [[9.0, 16.0], [6.0, -8.0]]);
    }

    /// The loop, a batch on one thread and on all, and copying on one thread and on all, round by round.
    #[test]
    fn every_ratio_is_of_times_of_its_own() {
        // Two inputs, one output, and its two derivatives.
        let bytes = 5 * 8;
        for (column_bytes, rows) in [(bytes * 300, 300), (bytes, 256)] {
            // One turn within the first twelve rounds, and another in the rest.
            let options = Options { column_bytes, rounds: 25, ..Options::quick() };
            let (took, factors) = ([14.0, 7.0, 3.5, 2.0, 0.5], [1.0, 3.0, 5.0]);
            let turns = factors
                .iter()
                .flat_map(|factor| took.map(|took| took * factor * f64::from(u16::try_from(rows).unwrap())));
            // The clock advances between the first and the second reading.
            let state = Mutex::new((0.0, turns.flat_map(|turn| [0.0, turn]).collect::<Vec<_>>().into_iter()));
            let clock = || {
                let mut state = state.lock().unwrap();
                state.0 += state.1.next().expect("there are three rounds");
                state.0
            };
            let found = time::<ContactForce>(&options, &clock).unwrap();
            assert_eq!((found.rows, found.bytes, found.threads), (rows, bytes, rayon::current_num_threads()));
            let times = [found.looped, found.one_thread, found.all_threads];
            assert_eq!(
                times.map(|time| [time.low, time.median, time.high]),
                [14.0, 7.0, 3.5].map(|x| [x, 3.0 * x, 5.0 * x])
            );
            let ratios = [found.one_over_loop, found.all_over_loop, found.one_over_copy, found.all_over_copy];
            assert_eq!(
                ratios.map(|ratio| [ratio.low, ratio.median, ratio.high]),
                [0.5, 0.25, 3.5, 7.0].map(|x| [x; 3])
            );
            assert!(state.into_inner().unwrap().1.next().is_none(), "a round is missing");
        }
    }

    #[test]
    fn the_time_of_a_row_is_that_of_the_work_by_rows() {
        let (now, mut times) = (Mutex::new(100.0), 0);
        let time = a_row(4, &|| *now.lock().unwrap(), || {
            times += 1;
            *now.lock().unwrap() += 5.0 * f64::from(times);
        });
        assert_eq!((times, time), (2, 2.5));
    }

    #[test]
    fn a_loop_and_a_batch_write_what_the_formula_gives() {
        let points = [vec![3.0, 4.0], vec![f64::NAN, 1.0], vec![-6.0, 8.0]];
        let expected = [[5.0, 0.6, 0.8], [1.0; 3], [10.0, -0.6, 0.8], [5.0, 0.6, 0.8]];
        for run in [Tables::looped, Tables::batch] {
            let mut tables = Tables::new(&points, 4, 5);
            run(&mut tables, Work::of::<ContactForce>());
            for (row, expected) in tables.results.columns().into_iter().zip(expected) {
                // Results of rejected rows are not written, or written as NaN.
                assert!(
                    row.iter().zip(expected).all(|(x, y)| *x == y || x.is_nan() && y == 1.0),
                    "{row}: {expected:?}"
                );
            }
        }
        let inputs = [[3.0, -1.0, 1.0], [4.0, f64::NAN, 0.0]];
        let mut results = [[0.0; 3]; 3];
        let mut results: Vec<_> = results.iter_mut().map(<[f64; 3]>::as_mut_slice).collect();
        assert_eq!(looped::<ContactForce>(&inputs.each_ref().map(<[f64; 3]>::as_slice), &mut results), 1);
    }

    #[test]
    fn one_thread_is_one() {
        assert_eq!(one_thread().unwrap().current_num_threads(), 1);
    }

    /// Half of the bytes are read and half are written.
    #[test]
    fn as_many_numbers_are_copied_as_a_batch_reads_and_writes() {
        let mut tables = Tables::new(&[vec![3.0, 4.0]], 10, 5);
        assert_eq!((tables.inputs.dim(), tables.results.dim()), ((2, 10), (3, 10)));
        tables.copy();
        assert!(tables.from == [1.0; 25] && tables.to == tables.from);
    }
}
