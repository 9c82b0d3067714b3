use jointproof::{
    formula::*,
    measure::{self, Options},
    slot::*,
};
use std::hint::black_box;
fn main() {
    let pts = Options::quick().timing_inputs::<Constraint>();
    let t = std::time::Instant::now();
    for _ in 0..60000 {
        for p in &pts {
            black_box(&measure::value_and_jacobian_by_ad::<Constraint>(black_box(p)));
        }
    }
    println!("{}", t.elapsed().as_secs_f64() * 1e9 / (60000.0 * pts.len() as f64));
}
