//! Derivatives of functions of components, and of Jacobians, by forward automatic differentiation.

use crate::Scalar;
use crate::formula::{self, WIDTH};
use crate::formula::{Fields, Formula, entries, typed};
use nalgebra::{Const, U1};

pub(super) type Sweep<T> = formula::Jet<T>;
/// A function of components, in dual numbers.
type Swept<'a, T> = dyn Fn(&[Sweep<T>]) -> Vec<Sweep<T>> + 'a;

/// The derivative of every entry of the closed-form Jacobian: one row per output and input, in order.
pub fn derivative_of_jacobian<F: Formula, T: Scalar>(i: &F::Inputs<T>) -> Vec<Vec<T>> {
    differentiate(&i.components(), &jacobian::<F, _>)
}

/// The gradient of every number that `function` returns.
pub(super) fn differentiate<T: Scalar>(inputs: &[T], function: &Swept<'_, T>) -> Vec<Vec<T>> {
    let mut rows: Vec<Vec<T>> = Vec::new();
    for start in (0..inputs.len()).step_by(WIDTH) {
        let seeded: Vec<_> = inputs.iter().enumerate().map(|(k, &x)| seed(x, k.checked_sub(start))).collect();
        let results = function(&seeded);
        rows.resize(results.len(), Vec::new());
        for (row, result) in rows.iter_mut().zip(results) {
            let gradient = result.eps.unwrap_generic(Const::<WIDTH>, U1);
            row.extend(gradient.iter().take(inputs.len() - start));
        }
    }
    rows
}

/// Unlike a zero derivative, an absent one costs no arithmetic.
fn seed<T: Scalar>(x: T, direction: Option<usize>) -> Sweep<T> {
    match direction {
        Some(direction) if direction < WIDTH => Sweep::from_re(x).derivative(direction),
        _ => Sweep::from_re(x),
    }
}

/// The components of the value.
pub(super) fn value<F: Formula, T: Scalar>(i: &[T]) -> Vec<T> {
    F::eval(&typed(i)).components()
}

/// The entries of the Jacobian at these components.
pub(super) fn jacobian<F: Formula, T: Scalar>(i: &[T]) -> Vec<T> {
    entries(&F::jacobian(&typed(i)))
}

/// Like [`jacobian`], except that an automatic one uses slices, which are compiled once instead of for every formula.
pub(super) fn exact_jacobian<F: Formula, T: Scalar>(i: &[T]) -> Vec<T> {
    if const { F::SPEC.is_closed() } { jacobian::<F, T>(i) } else { differentiate(i, &value::<F, _>).concat() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::{ContactForce, CrossForces};

    /// For √(x² + y²): y²/r³, −x y/r³, x²/r³.
    #[test]
    fn derivatives_of_a_jacobian_are_second_derivatives() {
        let found = derivative_of_jacobian::<ContactForce, f64>(&CrossForces { f2: 3.0, f3: 4.0 });
        let expected = [[16.0, -12.0], [-12.0, 9.0]].map(|row| row.map(|x| x / 125.0));
        assert!(found.len() == 2 && found.iter().all(|row| row.len() == 2));
        for (found, expected) in found.iter().flatten().zip(expected.as_flattened()) {
            assert!((found - expected).abs() < 1e-15, "{found} is not {expected}");
        }
    }

    /// Σ k xₖ², and x₀ x₆.
    #[test]
    fn there_may_be_more_inputs_than_a_sweep_carries() {
        let inputs = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0];
        let found = differentiate(&inputs, &|x: &[Sweep<f64>]| {
            let squares = x.iter().zip([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).map(|(&x, k)| x * x * k);
            vec![squares.fold(Sweep::from_re(0.0), |sum, term| sum + term), x[0] * x[6]]
        });
        assert_eq!(found[0], [0.0, 6.0, 20.0, 42.0, 88.0, 130.0, 204.0]);
        assert_eq!(found[1], [17.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0]);
        assert_eq!(found.len(), 2);
    }
}
