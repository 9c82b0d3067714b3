//! Jacobians by forward automatic differentiation.

use crate::Scalar;
use crate::formula::{Fields, Formula, Jacobian};
use nalgebra::{Const, U1};
use num_dual::DualSVec;

/// Directions a sweep carries. Chunks of a fixed width keep the number of inputs out of the types.
const WIDTH: usize = 4;
type Sweep<T> = DualSVec<T, WIDTH>;

/// The Jacobian of `F` at `i`, by differentiating `F::eval`.
pub fn jacobian_by_ad<F: Formula, T: Scalar>(i: &F::Inputs<T>) -> Jacobian<F, T> {
    let rows = differentiate::<F, T>(i, |i| F::eval(i).components());
    let mut next = rows.iter();
    let zero = F::Inputs::filled(T::zero());
    F::Outputs::from_components(&mut || next.next().and_then(|row| F::Inputs::from_slice(row)).unwrap_or(zero))
}

/// The derivative of every entry of the closed-form Jacobian: a row per output and input, in order.
pub fn derivative_of_jacobian<F: Formula, T: Scalar>(i: &F::Inputs<T>) -> Vec<Vec<T>> {
    differentiate::<F, T>(i, |i| entries::<F, _>(&F::jacobian(i)))
}

/// The entries of a Jacobian, output by output, each over all inputs.
pub(crate) fn entries<F: Formula, T: Scalar>(jacobian: &Jacobian<F, T>) -> Vec<T> {
    jacobian.components().iter().flat_map(Fields::components).collect()
}

/// The gradient of every number that `function` returns.
fn differentiate<F: Formula, T: Scalar>(
    i: &F::Inputs<T>,
    function: impl Fn(&F::Inputs<Sweep<T>>) -> Vec<Sweep<T>>,
) -> Vec<Vec<T>> {
    let inputs = i.components();
    let mut rows: Vec<Vec<T>> = Vec::new();
    for start in (0..inputs.len()).step_by(WIDTH) {
        let seeded: Vec<_> = inputs.iter().enumerate().map(|(k, &x)| seed(x, k.checked_sub(start))).collect();
        let Some(seeded) = F::Inputs::from_slice(&seeded) else { continue };
        let results = function(&seeded);
        rows.resize(results.len(), Vec::new());
        for (row, result) in rows.iter_mut().zip(results) {
            let gradient = result.eps.unwrap_generic(Const::<WIDTH>, U1);
            row.extend(gradient.iter().take(inputs.len() - start));
        }
    }
    rows
}

fn seed<T: Scalar>(x: T, direction: Option<usize>) -> Sweep<T> {
    match direction {
        Some(direction) if direction < WIDTH => Sweep::from_re(x).derivative(direction),
        _ => Sweep::from_re(x),
    }
}
