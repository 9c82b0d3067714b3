//! A formula as a step of a plan: it reads its inputs from an element's registers and writes its outputs there.

use crate::error::Error;
use crate::formula::{Field, Fields, Formula};
use crate::scalar::abs;
use crate::{Octuple, Scalar};
use std::cell::Cell;

/// Where in the registers a step finds its inputs and puts its outputs, component by component.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wiring {
    /// A register per input component.
    pub(super) inputs: Vec<u16>,
    /// A register per output component.
    pub(super) outputs: Vec<u16>,
}

/// A number in which a plan is evaluated: `f64` for results, [`Octuple`] for their errors.
pub trait Number: Scalar {
    /// How many blocks of elements make a task that is worth a thread.
    const BLOCKS: usize;
    /// An exact double as this number.
    fn exactly(x: f64) -> Self;
    /// The nearest double.
    fn rounded(self) -> f64;
    /// Whether the inputs are valid together; doubles are asked, the exact run trusts the answer.
    ///
    /// # Errors
    /// What [`Formula::validate`] says.
    fn validate<F: Formula>(i: &F::Inputs<Self>) -> Result<(), Error>;
    /// Runs a step in this number.
    fn run(step: &dyn Step, wiring: &Wiring, lanes: &mut Lanes<'_, Self>, failures: &mut Vec<Failure>);
}

/// Elements that are evaluated together: few enough for their registers to stay in the first-level cache.
pub(super) const LANES: usize = 32;

/// What the elements of a block have in one register.
pub(super) type Column<T> = [T; LANES];

/// The registers of a block of elements, a column each: first those that last from state to state, then the others.
#[derive(Debug)]
pub struct Lanes<'r, T> {
    pub(super) lasting: &'r mut [Column<T>],
    pub(super) scratch: &'r mut [Column<T>],
    /// The first element, by its place in its group.
    pub(super) first: usize,
    /// How many lanes hold an element.
    pub(super) count: usize,
}

impl<T: Copy> Lanes<'_, T> {
    pub(super) fn column(&mut self, register: usize) -> &mut Column<T> {
        let lasting = self.lasting.len();
        if register < lasting { &mut self.lasting[register] } else { &mut self.scratch[register - lasting] }
    }
}

/// A formula that rejected its inputs or overflowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The element, by its place in its group.
    pub element: usize,
    /// The formula.
    pub formula: &'static str,
    /// What it says.
    pub error: Error,
}

/// A [`Formula`] whose type is not known to the compiler, evaluated over registers; every formula is one.
pub trait Step: Sync {
    /// The identifier.
    fn id(&self) -> &'static str;
    /// The title.
    fn title(&self) -> &'static str;
    /// The inputs.
    fn inputs(&self) -> &'static [Field];
    /// The outputs.
    fn outputs(&self) -> &'static [Field];
    /// Whether these input components, in order, are allowed.
    ///
    /// # Errors
    /// As [`check`](crate::formula::check).
    fn check(&self, components: &[f64]) -> Result<(), Error>;
    /// Evaluates every lane in `f64`.
    fn run_double(&self, wiring: &Wiring, lanes: &mut Lanes<'_, f64>, failures: &mut Vec<Failure>);
    /// Evaluates every lane in 237 bits.
    fn run_exact(&self, wiring: &Wiring, lanes: &mut Lanes<'_, Octuple>, failures: &mut Vec<Failure>);
}

impl<F: Formula> Step for F {
    fn id(&self) -> &'static str {
        F::SPEC.id
    }
    fn title(&self) -> &'static str {
        F::SPEC.title
    }
    fn inputs(&self) -> &'static [Field] {
        F::Inputs::<f64>::FIELDS
    }
    fn outputs(&self) -> &'static [Field] {
        F::Outputs::<f64>::FIELDS
    }
    fn check(&self, components: &[f64]) -> Result<(), Error> {
        let (found, expected) = (components.len(), F::Inputs::<f64>::len());
        let inputs = F::Inputs::from_slice(components).ok_or(Error::Components { found, expected })?;
        crate::formula::check::<F>(&inputs)
    }
    fn run_double(&self, wiring: &Wiring, lanes: &mut Lanes<'_, f64>, failures: &mut Vec<Failure>) {
        run::<F, f64>(wiring, lanes, failures);
    }
    fn run_exact(&self, wiring: &Wiring, lanes: &mut Lanes<'_, Octuple>, failures: &mut Vec<Failure>) {
        run::<F, Octuple>(wiring, lanes, failures);
    }
}

/// Components that a formula has at most, in or out.
const MOST: usize = 32;

/// The number of components of these fields.
const fn components(fields: &[Field]) -> usize {
    let (mut sum, mut k) = (0, 0);
    while k < fields.len() {
        sum += fields[k].len();
        k += 1;
    }
    sum
}

fn run<F: Formula, T: Number>(wiring: &Wiring, lanes: &mut Lanes<'_, T>, failures: &mut Vec<Failure>) {
    const {
        assert!(components(F::Inputs::<T>::FIELDS) <= MOST && components(F::Outputs::<T>::FIELDS) <= MOST);
    }
    let lasting = Cell::from_mut(&mut *lanes.lasting).as_slice_of_cells();
    let scratch = Cell::from_mut(&mut *lanes.scratch).as_slice_of_cells();
    let Some(first) = lasting.first() else { return };
    // Looked up once a block, so that the loop below knows where everything is.
    let wired = |registers: &[u16]| {
        let mut wired = [first.as_array_of_cells(); MOST];
        for (place, &at) in wired.iter_mut().zip(registers) {
            let at = usize::from(at);
            let column = lasting.get(at).unwrap_or_else(|| &scratch[at - lasting.len()]);
            *place = column.as_array_of_cells();
        }
        wired
    };
    let (from, to) = (wired(&wiring.inputs), wired(&wiring.outputs));
    let inputs = |lane: usize| {
        let mut next = 0;
        F::Inputs::from_components(&mut || {
            let value = from[next % MOST][lane].get();
            next += 1;
            value
        })
    };
    let count = lanes.count.min(LANES);
    let mut sound = true;
    for lane in 0..count {
        let inputs = inputs(lane);
        sound &= T::validate::<F>(&inputs).is_ok();
        let mut next = 0;
        F::eval(&inputs).for_each_component(&mut |value| {
            sound &= is_double(value);
            to[next % MOST][lane].set(value);
            next += 1;
        });
    }
    if !sound {
        // No formula writes what it reads, so the inputs are still there.
        failures.extend((0..count).filter_map(|lane| {
            let error = error_of::<F, T>(&inputs(lane))?;
            Some(Failure { element: lanes.first + lane, formula: F::SPEC.id, error })
        }));
    }
}

/// What is wrong with these inputs, or with what comes out.
#[cold]
fn error_of<F: Formula, T: Number>(inputs: &F::Inputs<T>) -> Option<Error> {
    if let Err(error) = T::validate::<F>(inputs) {
        return Some(error);
    }
    let mut components = F::eval(inputs).components().into_iter();
    let mut overflows = |field: &&Field| components.by_ref().take(field.len()).any(|value| !is_double(value));
    let field = F::Outputs::<T>::FIELDS.iter().find(|field| overflows(field))?;
    Some(Error::Overflow { name: field.name })
}

/// Neither NaN nor beyond the largest double.
#[inline]
fn is_double<T: Number>(x: T) -> bool {
    abs(x) <= f64::MAX
}

impl Number for f64 {
    const BLOCKS: usize = 32;
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
