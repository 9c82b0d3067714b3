//! scratch
use jointproof::formula::*;
use jointproof::slider::*;
use jointproof::verify::*;
use std::hint::black_box;
use std::time::Instant;
fn bench<F: Formula>() {
    let mut s = Sampler::new::<F>(5);
    let inputs: Vec<_> = (0..1024).map(|_| s.inputs::<F>()).collect();
    let mut best = [f64::MAX; 4];
    for _ in 0..200 {
        let t = Instant::now();
        for i in &inputs { black_box(F::eval(black_box(i))); }
        best[0] = best[0].min(t.elapsed().as_nanos() as f64 / 1024.0);
        let t = Instant::now();
        for i in &inputs { black_box(F::eval(black_box(i))); black_box(F::jacobian(i)); }
        best[1] = best[1].min(t.elapsed().as_nanos() as f64 / 1024.0);
        let t = Instant::now();
        for _ in 0..1024 { let i = black_box(&inputs[0]); black_box(F::eval(i)); }
        best[2] = best[2].min(t.elapsed().as_nanos() as f64 / 1024.0);
        let t = Instant::now();
        for _ in 0..1024 { let i = black_box(&inputs[0]); black_box((F::eval(i), F::jacobian(i))); }
        best[3] = best[3].min(t.elapsed().as_nanos() as f64 / 1024.0);
    }
    println!("bench {:32} varied: value {:.1} both {:.1}; same point: value {:.1} both {:.1} ns", F::SPEC.id, best[0], best[1], best[2], best[3]);
}
#[test]
fn time() {
    bench::<Line>(); bench::<Basis>(); bench::<Constraint>(); bench::<Eliminate>(); bench::<DirectionVariation>();
    bench::<BasisVariation>(); bench::<IncrementalConstraint>(); bench::<Increment>(); bench::<Constraint2d>(); bench::<Increment2d>();
}
