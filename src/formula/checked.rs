//! Formulas with checked inputs and checked results.
//!
//! Where the inputs alone guarantee that nothing overflows ([`Finite`](super::Finite)), nothing else is checked.
//! Elsewhere one pass over all numbers detects whether anything is wrong, and only then is the culprit located.

#![expect(clippy::inline_always, reason = "the pass over the inputs is a part of every checked call")]

use super::finite::bits_unless_finite;
use super::{Component, Field, Fields, Formula, ValueAndJacobian};
use crate::formula::error::Error;

/// The value of a formula, with its inputs and results checked.
///
/// # Errors
/// [`Error`] naming the input that is not finite or not in its domain, or the output that overflowed.
///
/// ```
/// use jointproof::{formula::value, connector::slot::{ContactForce, CrossForces}};
/// assert_eq!(value::<ContactForce>(&CrossForces { f2: 3.0, f3: 4.0 })?.fc, 5.0);
/// let error = value::<ContactForce>(&CrossForces { f2: f64::NAN, f3: 4.0 }).unwrap_err();
/// assert_eq!(error.to_string(), "f2 is NaN; allowed is a finite number");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[inline]
pub fn value<F: Formula>(i: &F::Inputs<f64>) -> Result<F::Outputs<f64>, Error> {
    if is_plain::<F>(i) { F::try_eval(i) } else { value_checked::<F>(i) }
}

/// Whether the inputs are in their domains and guarantee that nothing overflows.
#[inline(always)]
pub(crate) fn is_plain<F: Formula>(i: &F::Inputs<f64>) -> bool {
    F::SPEC.finite.covers(i) & are_in_domain(i)
}

#[inline(never)]
fn value_checked<F: Formula>(i: &F::Inputs<f64>) -> Result<F::Outputs<f64>, Error> {
    if !are_allowed(i) {
        return Err(not_allowed(i));
    }
    let out = F::try_eval(i)?;
    if are_finite(&out) { Ok(out) } else { Err(overflow::<F>(i)) }
}

/// The value and closed-form Jacobian of a formula, with its inputs and results checked.
///
/// # Errors
/// As for [`value`], or an error naming the output with a derivative that overflowed.
#[inline]
pub fn value_and_jacobian<F: Formula>(i: &F::Inputs<f64>) -> Result<ValueAndJacobian<F, f64>, Error> {
    if is_plain::<F>(i) { F::try_linearized(i) } else { both_checked::<F>(i) }
}

#[inline(never)]
fn both_checked<F: Formula>(i: &F::Inputs<f64>) -> Result<ValueAndJacobian<F, f64>, Error> {
    if !are_allowed(i) {
        return Err(not_allowed(i));
    }
    // Checked in the returned value itself, so that large Jacobians are not copied.
    let mut found = F::try_linearized(i);
    if let Ok((out, jacobian)) = &found
        && !(are_finite(out) & are_finite_gradients(jacobian))
    {
        found = Err(derivative_overflow::<F>(i));
    }
    found
}

/// Whether the inputs are finite, in their domains, and valid together.
///
/// # Errors
/// An error for the first input that is not.
#[inline]
pub fn check<F: Formula>(i: &F::Inputs<f64>) -> Result<(), Error> {
    if are_allowed(i) { F::validate(i) } else { Err(not_allowed(i)) }
}

/// Whether every component is finite and in its domain.
///
/// # Errors
/// An error for the first that is not.
pub(super) fn check_fields(fields: &impl Fields<f64>) -> Result<(), Error> {
    if are_allowed(fields) { Ok(()) } else { Err(not_allowed(fields)) }
}

/// Whether every component is finite and in its domain.
#[inline(always)]
pub(crate) fn are_allowed(i: &impl Fields<f64>) -> bool {
    are_in_domain(i) & are_finite(i)
}

#[inline(always)]
fn are_in_domain(i: &impl Fields<f64>) -> bool {
    let mut allowed = true;
    i.for_each_of_field(&mut |field, x| allowed &= field.quantity.domain.allows(x));
    allowed
}

#[inline(always)]
fn are_finite(fields: &impl Fields<f64>) -> bool {
    let mut bits = 0;
    fields.for_each_component(&mut |x| bits |= bits_unless_finite(x));
    bits == 0
}

#[inline(always)]
fn are_finite_gradients<I: Fields<f64>>(jacobian: &impl Fields<I>) -> bool {
    let mut bits = 0;
    jacobian.for_each_component(&mut |gradient| gradient.for_each_component(&mut |x| bits |= bits_unless_finite(x)));
    bits == 0
}

/// The error of the first input that is not allowed.
#[cold]
#[inline(never)]
fn not_allowed(i: &impl Fields<f64>) -> Error {
    let (mut error, mut before) = (None, ("", 0));
    i.for_each_of_field(&mut |field, x| {
        let component = if before.0 == field.name { before.1 + 1 } else { 0 };
        before = (field.name, component);
        if error.is_none() {
            error = Error::check(field.name, (field.len() > 1).then_some(component), x, field.quantity.domain).err();
        }
    });
    error.expect("one component was not allowed")
}

/// Recomputes the outputs and names the first that is not finite.
#[cold]
#[inline(never)]
fn overflow<F: Formula>(i: &F::Inputs<f64>) -> Error {
    let name = first_where(&F::eval(i), |y| !y.is_finite()).expect("one output was not finite").name;
    Error::Overflow { name }
}

/// Recomputes outputs and derivatives and names the first output that is not finite, or else the first with a
/// derivative that is not.
#[cold]
#[inline(never)]
fn derivative_overflow<F: Formula>(i: &F::Inputs<f64>) -> Error {
    let (out, jacobian) = F::linearized(i);
    if let Some(field) = first_where(&out, |y| !y.is_finite()) {
        return Error::Overflow { name: field.name };
    }
    let field = first_where(&jacobian, |gradient| !are_finite(&gradient));
    Error::DerivativeOverflow { name: field.expect("one derivative was not finite").name }
}

/// The first field with a component that satisfies the condition.
pub(crate) fn first_where<T: Component>(fields: &impl Fields<T>, is_so: impl Fn(T) -> bool) -> Option<&'static Field> {
    let mut found = None;
    fields.for_each_of_field(&mut |field, component| {
        if found.is_none() && is_so(component) {
            found = Some(field);
        }
    });
    found
}
