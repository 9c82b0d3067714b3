//! Times value and Jacobian of a formula by `batch` over columns of doubles in a file, once for every line of input;
//! `compare.py` compares the Python package with it.

use jointproof::toolkit::batch::{ArrayView1, ArrayViewMut1, columns, entries, value_and_jacobian};
use jointproof::formula::{Fields, Formula};
use jointproof::connector::{align, join, slider, slot, translator, ujoint, universal};
use jointproof::element::cardan;
use jointproof::contact::{coulomb, interaction, slide_line};
use jointproof::element;
use std::error::Error;
use std::io::{self, BufRead, Write};
use std::time::Instant;

/// Times a formula over these columns.
type Run = fn(&[f64]) -> Result<(), Box<dyn Error>>;

/// The formulas of `definitions.py`.
const FORMULAS: [(&str, Run); 12] = [
    of::<slot::Friction>(),
    of::<coulomb::Response>(),
    of::<cardan::CardanAngles>(),
    of::<align::ConstraintMoment>(),
    of::<translator::BendingForce>(),
    of::<join::Constraint>(),
    of::<universal::KineticMoment>(),
    of::<ujoint::Decomposition>(),
    of::<slider::Constraint>(),
    of::<slide_line::TorqueLinear>(),
    of::<interaction::PressureExponential>(),
    of::<element::offset::Arm>(),
];

const fn of<F: Formula>() -> (&'static str, Run) {
    (F::SPEC.id, run::<F>)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(id), Some(file)) = (arguments.next(), arguments.next()) else {
        return Err("usage: batch-speed FORMULA FILE".into());
    };
    let (_, run) =
        FORMULAS.iter().find(|(known, _)| *known == id).ok_or("this formula is not among those of definitions.py")?;
    let bytes = std::fs::read(file)?;
    let numbers: Vec<f64> = bytes.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    run(&numbers)
}

fn run<F: Formula>(numbers: &[f64]) -> Result<(), Box<dyn Error>> {
    let [inputs, outputs] = [F::Inputs::<f64>::LEN, F::Outputs::<f64>::LEN];
    let rows = numbers.len() / inputs;
    let inputs: Vec<ArrayView1<f64>> = numbers.chunks(rows).map(ArrayView1::from).collect();
    let mut results = columns(outputs + entries::<F>().len(), rows);
    let mut views: Vec<ArrayViewMut1<f64>> = results.rows_mut().into_iter().collect();
    let (value, jacobian) = views.split_at_mut(outputs);
    for line in io::stdin().lock().lines() {
        line?;
        let start = Instant::now();
        value_and_jacobian::<F>(&inputs, value, jacobian)?;
        println!("{}", start.elapsed().as_secs_f64());
        io::stdout().flush()?;
    }
    Ok(())
}
