//! A formula as a step of a plan: it reads its inputs from an element's registers and writes its outputs there.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::lanes::{Column, Failure, LANES, Lanes, Wiring};
use crate::formula::error::Error;
use crate::formula::{Described, Fields, Formula, first_where};
use crate::number::scalar::abs;
use crate::{Octuple, Scalar};
use std::cell::Cell;
use std::marker::PhantomData;

/// A number type in which a plan is evaluated: `f64` for results, [`Octuple`] for their errors.
pub trait Number: Scalar {
    /// The least number of blocks of elements in a task that is worth a thread.
    const BLOCKS: usize;
    /// Converts an exact double to this type.
    fn exactly(x: f64) -> Self;
    /// The nearest double.
    fn rounded(self) -> f64;
    /// Whether the inputs are valid together; this is checked in doubles, and the exact run relies on it.
    ///
    /// # Errors
    /// The error of [`Formula::validate`].
    fn validate<F: Formula>(i: &F::Inputs<Self>) -> Result<(), Error>;
    /// Runs a step in this number type.
    fn run(step: &dyn Step, wiring: &Wiring, lanes: &mut Lanes<'_, Self>, failures: &mut Vec<Failure>);
}

/// A [`Formula`] whose type is erased, evaluated over registers; every formula is one.
pub trait Step: Described {
    /// Evaluates every lane in `f64`.
    fn run_double(&self, wiring: &Wiring, lanes: &mut Lanes<'_, f64>, failures: &mut Vec<Failure>);
    /// Evaluates every lane in 237 bits.
    fn run_exact(&self, wiring: &Wiring, lanes: &mut Lanes<'_, Octuple>, failures: &mut Vec<Failure>);
}

impl<F: Formula> Step for F {
    fn run_double(&self, wiring: &Wiring, lanes: &mut Lanes<'_, f64>, failures: &mut Vec<Failure>) {
        pulp::Arch::new().dispatch(Vectors::<F> { wiring, lanes, failures, formula: PhantomData });
    }
    fn run_exact(&self, wiring: &Wiring, lanes: &mut Lanes<'_, Octuple>, failures: &mut Vec<Failure>) {
        run::<F, Octuple>(wiring, lanes, failures);
    }
}

/// A step in `f64`, compiled a second time for processors with vectors of four doubles. Both versions give the same bits.
struct Vectors<'j, 'r, F> {
    wiring: &'j Wiring,
    lanes: &'j mut Lanes<'r, f64>,
    failures: &'j mut Vec<Failure>,
    formula: PhantomData<F>,
}

impl<F: Formula> pulp::WithSimd for Vectors<'_, '_, F> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        run::<F, f64>(self.wiring, self.lanes, self.failures);
    }
}

/// The maximum number of components of a formula, in or out.
const MOST: usize = 32;

/// The lanes of a column.
fn cells<T>(column: &Cell<Column<T>>) -> &[Cell<T>; LANES] {
    let column: &Cell<[T]> = column;
    column.as_slice_of_cells().try_into().expect("a column has this length")
}

/// Evaluates a formula for every lane. The loops have no dependence between lanes, so that the compiler can vectorise them.
#[inline(always)]
fn run<F: Formula, T: Number>(wiring: &Wiring, lanes: &mut Lanes<'_, T>, failures: &mut Vec<Failure>) {
    const { assert!(F::Inputs::<f64>::LEN <= MOST && F::Outputs::<f64>::LEN <= MOST) };
    let lasting = Cell::from_mut(&mut *lanes.lasting).as_slice_of_cells();
    let passing = Cell::from_mut(&mut *lanes.passing).as_slice_of_cells();
    let column = |register: u16| {
        let register = usize::from(register);
        lasting.get(register).unwrap_or_else(|| &passing[register - lasting.len()])
    };
    // Looked up once per block, so that the loops below have all addresses.
    let mut from = [cells(column(0)); MOST];
    for (place, &register) in from.iter_mut().zip(&wiring.inputs) {
        *place = cells(column(register));
    }
    let count = lanes.count.min(LANES);
    // Kept separate from the registers, so that no input waits for an output that might be the same.
    let mut outputs = F::Outputs::<Column<T>>::array_of([T::zero(); LANES]);
    let outputs = outputs.as_mut();
    for lane in 0..count {
        let mut columns = outputs.iter_mut();
        F::eval(&inputs_of::<F, T>(&from, lane)).for_each_component(&mut |value| {
            columns.next().into_iter().for_each(|column| column[lane] = value);
        });
    }
    let mut sound = true;
    for lane in 0..count {
        sound &= T::validate::<F>(&inputs_of::<F, T>(&from, lane)).map_or_else(rejected, |()| true);
    }
    for (output, &register) in outputs.iter().zip(&wiring.outputs) {
        sound &= output[..count].iter().fold(true, |sound, &value| sound & is_double(value));
        // No formula writes a register that it reads, so the inputs are still available.
        column(register).set(*output);
    }
    if !sound {
        for lane in 0..count {
            if let Some(error) = error_of::<F, T>(&inputs_of::<F, T>(&from, lane)) {
                failures.push(Failure { element: lanes.first + lane, formula: F::SPEC.id, error });
            }
        }
    }
}

/// The inputs of a lane.
#[inline(always)]
fn inputs_of<F: Formula, T: Number>(columns: &[&[Cell<T>; LANES]; MOST], lane: usize) -> F::Inputs<T> {
    let mut next = 0;
    F::Inputs::from_components(&mut || {
        let value = columns[next % MOST][lane].get();
        next += 1;
        value
    })
}

/// Cold and out of line, so that dropping an error costs the loop nothing.
#[cold]
fn rejected(_: Error) -> bool {
    false
}

/// The error of these inputs, or of their results.
#[cold]
fn error_of<F: Formula, T: Number>(inputs: &F::Inputs<T>) -> Option<Error> {
    if let Err(error) = T::validate::<F>(inputs) {
        return Some(error);
    }
    let field = first_where(&F::eval(inputs), |value| !is_double(value))?;
    Some(Error::Overflow { name: field.name })
}

/// Neither NaN nor larger than the largest double.
#[inline]
fn is_double<T: Number>(x: T) -> bool {
    abs(x) <= f64::MAX
}

impl Number for f64 {
    const BLOCKS: usize = 16;
    #[inline]
    fn exactly(x: f64) -> Self {
        x
    }
    #[inline]
    fn rounded(self) -> f64 {
        self
    }
    #[inline]
    fn validate<F: Formula>(i: &F::Inputs<Self>) -> Result<(), Error> {
        F::validate(i)
    }
    fn run(step: &dyn Step, wiring: &Wiring, lanes: &mut Lanes<'_, Self>, failures: &mut Vec<Failure>) {
        step.run_double(wiring, lanes, failures);
    }
}

impl Number for Octuple {
    const BLOCKS: usize = 1;
    fn exactly(x: f64) -> Self {
        Self::from(x)
    }
    fn rounded(self) -> f64 {
        self.to_f64()
    }
    fn validate<F: Formula>(_: &F::Inputs<Self>) -> Result<(), Error> {
        Ok(())
    }
    fn run(step: &dyn Step, wiring: &Wiring, lanes: &mut Lanes<'_, Self>, failures: &mut Vec<Failure>) {
        step.run_exact(wiring, lanes, failures);
    }
}
