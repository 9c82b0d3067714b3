//! A formula as a step of a plan: it reads its inputs from an element's registers and writes its outputs there.

use super::recipe::Span;
use crate::error::Error;
use crate::formula::{Field, Fields, Formula};
use crate::scalar::abs;
use crate::{Octuple, Scalar};
use nalgebra::Vector3;
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
    /// Whether lanes that hold no element are left out. To tell them apart costs a double more than to evaluate them.
    const SPARES: bool;
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
pub(super) const LANES: usize = 64;
/// Lanes that are evaluated side by side, for which the compiler may then use vector instructions.
const ABREAST: usize = 8;

/// What the elements of a block have in one register.
pub(super) type Column<T> = [[T; ABREAST]; LANES / ABREAST];

/// A column that is the same for all.
pub(super) fn column<T: Number>(value: T) -> Column<T> {
    [[value; ABREAST]; LANES / ABREAST]
}

/// A block of elements: a column per register.
#[derive(Debug)]
pub struct Lanes<'r, T> {
    /// The registers that last from state to state.
    pub(super) lasting: &'r mut [Column<T>],
    /// The registers after them, which every block of a task uses in turn.
    pub(super) passing: &'r mut [Column<T>],
    /// The first element, by its place in its group.
    pub(super) first: usize,
    /// How many lanes hold an element.
    pub(super) count: usize,
}

impl<T: Number> Lanes<'_, T> {
    /// What all lanes have in these registers.
    pub(super) fn columns(&mut self, span: Span) -> &mut [Column<T>] {
        match span.at.checked_sub(self.lasting.len()) {
            Some(at) => &mut self.passing[at..at + span.len],
            None => &mut self.lasting[span.range()],
        }
    }

    /// Copies registers to others.
    pub(super) fn copy(&mut self, from: Span, to: Span) {
        for k in 0..from.len {
            let column = self.columns(from)[k];
            self.columns(to)[k] = column;
        }
    }

    /// Fills the registers of a vector, or of its part in the plane, with the same for all lanes.
    pub(super) fn spread(&mut self, span: Span, vector: Vector3<T>) {
        for (register, &component) in self.columns(span).iter_mut().zip(&vector) {
            *register = column(component);
        }
    }

    /// Fills them with a vector for each lane.
    pub(super) fn fill(&mut self, span: Span, vectors: impl Iterator<Item = Vector3<T>>) {
        match self.columns(span) {
            [x, y, z] => {
                let [x, y, z] = [x, y, z].map(|column| column.as_flattened_mut());
                vectors.zip(x).zip(y).zip(z).for_each(|(((v, x), y), z)| (*x, *y, *z) = (v.x, v.y, v.z));
            }
            [x, y] => {
                let [x, y] = [x, y].map(|column| column.as_flattened_mut());
                vectors.zip(x).zip(y).for_each(|((v, x), y)| (*x, *y) = (v.x, v.y));
            }
            _ => {}
        }
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
    let reads = const { components(F::Inputs::<f64>::FIELDS) };
    let writes = const { components(F::Outputs::<f64>::FIELDS) };
    const {
        assert!(components(F::Inputs::<f64>::FIELDS) <= MOST && components(F::Outputs::<f64>::FIELDS) <= MOST);
    }
    let lasting = Cell::from_mut(&mut *lanes.lasting).as_slice_of_cells();
    let passing = Cell::from_mut(&mut *lanes.passing).as_slice_of_cells();
    let column = |register: u16| {
        let register = usize::from(register);
        let column = lasting.get(register).unwrap_or_else(|| &passing[register - lasting.len()]);
        column.as_array_of_cells()
    };
    // Looked up once a block, so that the loop below knows where everything is.
    let mut from = [column(0); MOST];
    let mut to = from;
    for (place, &register) in from[..reads].iter_mut().zip(&wiring.inputs[..reads]) {
        *place = column(register);
    }
    for (place, &register) in to[..writes].iter_mut().zip(&wiring.outputs[..writes]) {
        *place = column(register);
    }
    let mut sound = true;
    let (mut inputs, mut outputs) = ([[T::zero(); ABREAST]; MOST], [[T::zero(); ABREAST]; MOST]);
    for (pack, first) in (0..lanes.count.min(LANES)).step_by(ABREAST).enumerate() {
        let count = (lanes.count - first).min(ABREAST);
        for (input, column) in inputs[..reads].iter_mut().zip(&from[..reads]) {
            *input = column[pack].get();
        }
        let mut valid = [true; ABREAST];
        for (j, valid) in valid.iter_mut().enumerate().take(if T::SPARES { count } else { ABREAST }) {
            let inputs = inputs_of::<F, T>(&inputs, j);
            *valid = T::validate::<F>(&inputs).map_or_else(rejected, |()| true);
            let mut next = 0;
            F::eval(&inputs).for_each_component(&mut |value| {
                outputs[next % MOST][j] = value;
                next += 1;
            });
        }
        for (output, column) in outputs[..writes].iter().zip(&to[..writes]) {
            column[pack].set(*output);
            for (valid, &value) in valid.iter_mut().zip(output) {
                *valid &= is_double(value);
            }
        }
        valid[count..].fill(true);
        sound &= valid == [true; ABREAST];
    }
    if !sound {
        // No formula writes what it reads, so the inputs are still there.
        failures.extend((0..lanes.count).filter_map(|lane| {
            let inputs = from.map(|column| column[lane / ABREAST].get());
            let error = error_of::<F, T>(&inputs_of::<F, T>(&inputs, lane % ABREAST))?;
            Some(Failure { element: lanes.first + lane, formula: F::SPEC.id, error })
        }));
    }
}

/// The inputs of one of the lanes that stand side by side.
#[inline]
fn inputs_of<F: Formula, T: Number>(columns: &[[T; ABREAST]; MOST], lane: usize) -> F::Inputs<T> {
    let mut next = 0;
    F::Inputs::from_components(&mut || {
        let value = columns[next % MOST][lane];
        next += 1;
        value
    })
}

/// Kept apart from the loop, which goes on without it.
#[cold]
fn rejected(_: Error) -> bool {
    false
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
    const BLOCKS: usize = 16;
    const SPARES: bool = false;
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
    const SPARES: bool = true;
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
