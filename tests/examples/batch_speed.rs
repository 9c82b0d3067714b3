//! Times value and Jacobian of a formula by `batch` over columns of doubles in a file, for every line that is read:
//! `xtask/wheel/speed/compare.py` compares the Python package with it.

use jointproof::batch::{ArrayView1, ArrayViewMut1, columns};
use jointproof::catalog::find;
use jointproof::formula::Field;
use std::error::Error;
use std::io::{self, BufRead, Write};
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(id), Some(file)) = (arguments.next(), arguments.next()) else {
        return Err("usage: batch_speed FORMULA FILE".into());
    };
    let formula = find(&id).ok_or("there is no such formula")?;
    let numbers: Vec<f64> =
        std::fs::read(file)?.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let [inputs, outputs] = [formula.inputs(), formula.outputs()].map(|fields| fields.iter().map(Field::len).sum::<usize>());
    let rows = numbers.len() / inputs;
    let inputs: Vec<ArrayView1<f64>> = numbers.chunks(rows).map(ArrayView1::from).collect();
    let mut results = columns(outputs + formula.batch_entries().len(), rows);
    let mut views: Vec<ArrayViewMut1<f64>> = results.rows_mut().into_iter().collect();
    let (value, jacobian) = views.split_at_mut(outputs);
    for line in io::stdin().lock().lines() {
        line?;
        let start = Instant::now();
        formula.batch_value_and_jacobian(&inputs, value, jacobian)?;
        println!("{}", start.elapsed().as_secs_f64());
        io::stdout().flush()?;
    }
    Ok(())
}
