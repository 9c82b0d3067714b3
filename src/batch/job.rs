//! What is computed of a formula: its value, or its Jacobian too.

#![expect(clippy::inline_always, reason = "a formula and what is done with its results are compiled as one piece")]

use super::zeros;
use crate::error::Error;
use crate::formula::{Fields, Formula, ValueAndJacobian, value, value_and_jacobian};

/// What is computed of a formula.
pub(super) trait Job<F: Formula> {
    /// How many numbers that is, without those that are zero everywhere.
    const LEN: usize;
    /// Its numbers, zeros and all.
    type Results;
    /// Of inputs whose components are allowed.
    ///
    /// # Errors
    /// What is wrong with them together.
    fn of_allowed(i: &F::Inputs<f64>) -> Result<Self::Results, Error>;
    /// Hands out the numbers in order, without those that are zero everywhere.
    fn hand_out(results: &Self::Results, to: &mut impl FnMut(f64));
    /// What the checked call says of these inputs.
    ///
    /// # Errors
    /// What is wrong with them, or with the results.
    fn check(i: &F::Inputs<f64>) -> Result<(), Error>;
}

/// The value.
pub(super) struct Value;

impl<F: Formula> Job<F> for Value {
    const LEN: usize = F::Outputs::<f64>::LEN;
    type Results = F::Outputs<f64>;
    #[inline(always)]
    fn of_allowed(i: &F::Inputs<f64>) -> Result<Self::Results, Error> {
        F::try_eval(i)
    }
    #[inline(always)]
    fn hand_out(value: &Self::Results, to: &mut impl FnMut(f64)) {
        value.for_each_component(to);
    }
    #[cold]
    fn check(i: &F::Inputs<f64>) -> Result<(), Error> {
        value::<F>(i).map(|_| ())
    }
}

/// The value, then the Jacobian, output by output over all inputs.
pub(super) struct Linearized;

impl<F: Formula> Job<F> for Linearized {
    const LEN: usize = F::Outputs::<f64>::LEN + zeros::entries::<F>();
    type Results = ValueAndJacobian<F, f64>;
    #[inline(always)]
    fn of_allowed(i: &F::Inputs<f64>) -> Result<Self::Results, Error> {
        F::try_linearized(i)
    }
    #[inline(always)]
    fn hand_out((value, jacobian): &Self::Results, to: &mut impl FnMut(f64)) {
        value.for_each_component(to);
        let mut entry = 0;
        jacobian.for_each_component(&mut |gradient| {
            gradient.for_each_component(&mut |x| {
                if zeros::is_entry::<F>(entry) {
                    to(x);
                }
                entry += 1;
            });
        });
    }
    #[cold]
    fn check(i: &F::Inputs<f64>) -> Result<(), Error> {
        value_and_jacobian::<F>(i).map(|_| ())
    }
}
