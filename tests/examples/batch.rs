//! The contact force of a slot at many points: columns in, columns out.

use jointproof::connector::slot::ContactForce;
use jointproof::toolkit::batch::{ArrayView1, ArrayViewMut1, entries, value_and_jacobian};
use ndarray::{Array2, arr0};

fn main() -> Result<(), jointproof::toolkit::batch::Error> {
    // ANCHOR: example
    let f2 = vec![3.0; 10_000];
    let f3 = arr0(4.0); // the same in all rows
    let inputs: [ArrayView1<f64>; 2] = [(&f2).into(), f3.broadcast(10_000).expect("one number fills a column")];

    let entries = entries::<ContactForce>(); // [[0, 0], [0, 1]]: ∂fc/∂f2, ∂fc/∂f3
    let mut fc = vec![0.0; 10_000];
    let mut jacobian = Array2::zeros((entries.len(), 10_000));
    let mut columns: Vec<ArrayViewMut1<f64>> = jacobian.rows_mut().into_iter().collect();
    value_and_jacobian::<ContactForce>(&inputs, &mut [(&mut fc).into()], &mut columns)?;
    assert_eq!((fc[9_999], jacobian[[1, 9_999]]), (5.0, 0.8));
    // ANCHOR_END: example
    Ok(())
}
