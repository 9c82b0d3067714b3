//! A formula as the toolkit works with it: functions of components in order.
//!
//! Everything else in the toolkit is written over slices and compiled once. Only what stands here is compiled once a
//! formula.

use super::jet::{Sweep, differentiate};
use crate::formula::{self, Case, Convention, Element, Equation, Field, Fields, Formula, Spec};
use crate::scalar::Scalar;
use crate::{Error, Octuple};

/// A formula without its types.
pub(crate) struct Subject {
    pub(crate) spec: Spec,
    pub(crate) inputs: &'static [Field],
    pub(crate) outputs: &'static [Field],
    /// Whether inputs are valid.
    pub(crate) check: fn(&[f64]) -> Result<(), Error>,
    /// The value, and the closed-form Jacobian output by output.
    pub(crate) value: fn(&[f64]) -> Vec<f64>,
    pub(crate) jacobian: fn(&[f64]) -> Vec<f64>,
    /// The same in 237 bits.
    pub(crate) exact_value: fn(&[Octuple]) -> Vec<Octuple>,
    pub(crate) exact_jacobian: fn(&[Octuple]) -> Vec<Octuple>,
    /// The same in dual numbers over 237 bits.
    dual_value: fn(&[Sweep<Octuple>]) -> Vec<Sweep<Octuple>>,
    dual_jacobian: fn(&[Sweep<Octuple>]) -> Vec<Sweep<Octuple>>,
    /// The formula's own cases, and those that it rejects.
    pub(crate) cases: fn() -> Vec<Case<Vec<f64>>>,
    pub(crate) invalid_cases: fn() -> Vec<Case<Vec<f64>>>,
    pub(crate) kinks: Vec<Kink>,
    pub(crate) laws: Vec<Law>,
}

/// A [kink](formula::Kink) without its types.
pub(crate) struct Kink {
    pub(crate) condition: &'static str,
    pub(crate) convention: Convention,
    pub(crate) holds: Box<dyn Fn(&[Octuple]) -> bool>,
    pub(crate) at: Vec<f64>,
    pub(crate) across: Vec<f64>,
}

/// A [law](formula::Law) without its types.
pub(crate) struct Law {
    pub(crate) statement: &'static str,
    pub(crate) sides: Box<dyn Fn(&[Octuple]) -> Vec<Equation>>,
}

impl Subject {
    pub(crate) fn of<F: Formula>() -> Self {
        Self {
            spec: F::SPEC,
            inputs: F::Inputs::<f64>::FIELDS,
            outputs: F::Outputs::<f64>::FIELDS,
            check: |i| formula::check::<F>(&typed::<F, _>(i)),
            value: value::<F, _>,
            jacobian: jacobian::<F, _>,
            exact_value: value::<F, _>,
            exact_jacobian: jacobian::<F, _>,
            dual_value: value::<F, _>,
            dual_jacobian: jacobian::<F, _>,
            cases: || F::cases().into_iter().map(flat::<F>).collect(),
            invalid_cases: || F::invalid_cases().into_iter().map(flat::<F>).collect(),
            kinks: F::kinks().into_iter().map(Kink::of).collect(),
            laws: F::laws().into_iter().map(Law::of).collect(),
        }
    }

    /// The Jacobian by automatic differentiation.
    pub(crate) fn derivative(&self, exact: &[Octuple]) -> Vec<Octuple> {
        differentiate(exact, &self.dual_value).concat()
    }

    /// The gradient of every entry of the Jacobian.
    pub(crate) fn second_derivative(&self, exact: &[Octuple]) -> Vec<Vec<Octuple>> {
        differentiate(exact, &self.dual_jacobian)
    }

    /// The kink that these inputs are on.
    pub(crate) fn kink(&self, exact: &[Octuple]) -> Option<Convention> {
        self.kinks.iter().find(|kink| (kink.holds)(exact)).map(|kink| kink.convention)
    }
}

impl Kink {
    fn of<F: Formula>(kink: formula::Kink<F>) -> Self {
        Self {
            condition: kink.condition,
            convention: kink.convention,
            holds: Box::new(move |i| (kink.holds)(&typed::<F, _>(i))),
            at: (kink.at)().components(),
            across: (kink.across)().components(),
        }
    }
}

impl Law {
    fn of<F: Formula>(law: formula::Law<F>) -> Self {
        Self { statement: law.statement, sides: Box::new(move |i| (law.sides)(&typed::<F, _>(i))) }
    }
}

/// The components of the value.
pub(super) fn value<F: Formula, T: Scalar>(i: &[T]) -> Vec<T> {
    F::eval(&typed::<F, T>(i)).components()
}

/// The entries of the Jacobian, output by output, each over all inputs.
pub(super) fn jacobian<F: Formula, T: Scalar>(i: &[T]) -> Vec<T> {
    F::jacobian(&typed::<F, T>(i)).components().iter().flat_map(Fields::components).collect()
}

/// The inputs of these components. The toolkit hands out as many as there are fields for.
fn typed<F: Formula, T: Element + From<f64>>(components: &[T]) -> F::Inputs<T> {
    F::Inputs::from_slice(components).unwrap_or_else(|| F::Inputs::filled(T::from(f64::NAN)))
}

fn flat<F: Formula>(case: Case<F::Inputs<f64>>) -> Case<Vec<f64>> {
    Case { id: case.id, flag: case.flag, comment: case.comment, inputs: case.inputs.components() }
}
