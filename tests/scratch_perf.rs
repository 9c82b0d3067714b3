//! scratch
use jointproof::formula::*;
use jointproof::slider::*;
use jointproof::verify::*;
use std::hint::black_box;
#[inline(never)]
pub fn one(i: &KeptIncrement<f64>) -> (Increments<f64>, Increments<KeptIncrement<f64>>) { (Increment::eval(i), Increment::jacobian(i)) }
#[inline(never)]
pub fn elim(i: &KeptCoordinate<f64>) -> Coordinates<f64> { Eliminate::eval(i) }
#[test]
fn time() {
    let mut s = Sampler::new::<Increment>(5);
    let inputs: Vec<_> = (0..1024).map(|_| s.inputs::<Increment>()).collect();
    for _ in 0..20000 { for i in &inputs { black_box(one(black_box(i))); } }
    let mut s = Sampler::new::<Eliminate>(5);
    let inputs: Vec<_> = (0..1024).map(|_| s.inputs::<Eliminate>()).collect();
    for _ in 0..20000 { for i in &inputs { black_box(elim(black_box(i))); } }
}
