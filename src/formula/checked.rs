//! A formula at inputs that are checked, with a result that is.

use super::{Component, Field, Fields, Formula, ValueAndJacobian};
use crate::error::Error;

/// Value of a formula at inputs that were checked.
///
/// # Errors
/// [`Error`] naming the input that is not finite or not in its domain, or the output that overflowed.
///
/// ```
/// use jointproof::{formula::value, slot::{ContactForce, CrossForces}};
/// assert_eq!(value::<ContactForce>(&CrossForces { f2: 3.0, f3: 4.0 })?.fc, 5.0);
/// let error = value::<ContactForce>(&CrossForces { f2: f64::NAN, f3: 4.0 }).unwrap_err();
/// assert_eq!(error.to_string(), "f2 is NaN; allowed is a finite number");
/// # Ok::<(), jointproof::Error>(())
/// ```
pub fn value<F: Formula>(i: &F::Inputs<f64>) -> Result<F::Outputs<f64>, Error> {
    check::<F>(i)?;
    let out = F::eval(i);
    finite::<F>(&out)?;
    Ok(out)
}

/// Value and closed-form Jacobian of a formula at inputs that were checked.
///
/// # Errors
/// As [`value`], or naming the output with a derivative that overflowed.
pub fn value_and_jacobian<F: Formula>(i: &F::Inputs<f64>) -> Result<ValueAndJacobian<F, f64>, Error> {
    check::<F>(i)?;
    let (out, jacobian) = F::linearized(i);
    finite::<F>(&out)?;
    let is_finite = |gradient: F::Inputs<f64>| {
        let mut all = true;
        Fields::for_each_component(&gradient, &mut |slope: f64| all &= slope.is_finite());
        all
    };
    match first_where(&jacobian, |gradient| !is_finite(gradient)) {
        Some(field) => Err(Error::DerivativeOverflow { name: field.name }),
        None => Ok((out, jacobian)),
    }
}

/// Whether the inputs are finite, in their domains, and valid together.
///
/// # Errors
/// The first input that is not.
pub fn check<F: Formula>(i: &F::Inputs<f64>) -> Result<(), Error> {
    check_domains(F::Inputs::<f64>::FIELDS, &i.components())?;
    F::validate(i)
}

fn check_domains(fields: &[Field], components: &[f64]) -> Result<(), Error> {
    let mut components = components.iter();
    for field in fields {
        for (component, &value) in components.by_ref().take(field.len()).enumerate() {
            let component = (field.len() > 1).then_some(component);
            Error::check(field.name, component, value, field.quantity.domain)?;
        }
    }
    Ok(())
}

fn finite<F: Formula>(out: &F::Outputs<f64>) -> Result<(), Error> {
    match first_where(out, |value| !value.is_finite()) {
        Some(field) => Err(Error::Overflow { name: field.name }),
        None => Ok(()),
    }
}

/// The first field with a component like this.
fn first_where<T: Component, I: Fields<T>>(fields: &I, is_so: impl Fn(T) -> bool) -> Option<&'static Field> {
    let (mut place, mut found) = (0, None);
    fields.for_each_component(&mut |component| {
        if found.is_none() && is_so(component) {
            found = Some(place);
        }
        place += 1;
    });
    let (found, mut end): (usize, _) = (found?, 0);
    I::FIELDS.iter().find(|field| {
        end += field.len();
        found < end
    })
}
