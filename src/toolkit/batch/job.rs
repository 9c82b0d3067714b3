//! The requested results of a formula: its value, or its value and Jacobian.

#![expect(clippy::inline_always, reason = "a formula and what is done with its results are compiled as one piece")]

use super::structure;
use crate::formula::error::Error;
use crate::formula::{Component, Fields, Formula, ValueAndJacobian, Visitor, value, value_and_jacobian};
use crate::number::scalar::Scalar;
use std::marker::PhantomData;

/// The requested results of a formula.
pub(crate) trait Job<F: Formula> {
    /// The number of results that are not identically zero.
    const LEN: usize;
    /// Whether several rows are computed together.
    const IS_STRAIGHT: bool;
    /// The results, including zeros.
    type Results<D: Component>;
    /// The results, with inputs and results checked.
    ///
    /// # Errors
    /// The first invalid input or result.
    fn of(i: &F::Inputs<f64>) -> Result<Self::Results<f64>, Error>;
    /// The results for inputs that were checked and guarantee that nothing overflows.
    fn unchecked<D: Scalar>(i: &F::Inputs<D>) -> Self::Results<D>;
    /// Visits the results in order, except those that are identically zero.
    fn show<D: Component>(results: &Self::Results<D>, visitor: &mut impl Visitor<D>);
}

/// The value.
pub(super) struct Value;

impl<F: Formula> Job<F> for Value {
    const LEN: usize = F::Outputs::<f64>::LEN;
    const IS_STRAIGHT: bool = structure::is_straight::<F>();
    type Results<D: Component> = F::Outputs<D>;
    #[inline(always)]
    fn of(i: &F::Inputs<f64>) -> Result<Self::Results<f64>, Error> {
        value::<F>(i)
    }
    #[inline(always)]
    fn unchecked<D: Scalar>(i: &F::Inputs<D>) -> Self::Results<D> {
        F::eval(i)
    }
    #[inline(always)]
    fn show<D: Component>(value: &Self::Results<D>, visitor: &mut impl Visitor<D>) {
        value.accept(visitor);
    }
}

/// The value, then the Jacobian, output by output over all inputs.
pub(crate) struct Linearized;

impl<F: Formula> Job<F> for Linearized {
    const LEN: usize = F::Outputs::<f64>::LEN + structure::entries::<F>();
    // Vectorised dual numbers would be a lot of code for something rarely needed at many points.
    const IS_STRAIGHT: bool = structure::is_straight::<F>() && F::SPEC.is_closed();
    type Results<D: Component> = ValueAndJacobian<F, D>;
    #[inline(always)]
    fn of(i: &F::Inputs<f64>) -> Result<Self::Results<f64>, Error> {
        value_and_jacobian::<F>(i)
    }
    #[inline(always)]
    fn unchecked<D: Scalar>(i: &F::Inputs<D>) -> Self::Results<D> {
        F::linearized(i)
    }
    #[inline(always)]
    fn show<D: Component>((value, jacobian): &Self::Results<D>, visitor: &mut impl Visitor<D>) {
        value.accept(visitor);
        jacobian.accept(&mut Gradients::of(&mut Entries::<F, _> { visitor, entry: 0, formula: PhantomData }));
    }
}

/// Visits the entries of gradients.
struct Gradients<'v, D, V> {
    visitor: &'v mut V,
    of: PhantomData<D>,
}

impl<'v, D, V: Visitor<D>> Gradients<'v, D, V> {
    #[inline(always)]
    fn of(visitor: &'v mut V) -> Self {
        Self { visitor, of: PhantomData }
    }
}

impl<D: Component, I: Fields<D>, V: Visitor<D>> Visitor<I> for Gradients<'_, D, V> {
    #[inline(always)]
    fn visit(&mut self, gradient: I) {
        gradient.accept(self.visitor);
    }
}

/// Visits the entries that are not identically zero.
struct Entries<'v, F, V> {
    visitor: &'v mut V,
    entry: usize,
    formula: PhantomData<F>,
}

impl<F: Formula, D, V: Visitor<D>> Visitor<D> for Entries<'_, F, V> {
    #[inline(always)]
    fn visit(&mut self, x: D) {
        if structure::is_entry::<F>(self.entry) {
            self.visitor.visit(x);
        }
        self.entry += 1;
    }
}
