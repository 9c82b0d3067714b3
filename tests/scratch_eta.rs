//! scratch
use jointproof::Octuple;
use jointproof::formula::*;
use jointproof::slider::*;
use jointproof::verify::*;
struct R(u64);
impl R {
    fn u(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    fn f(&mut self) -> f64 {
        (self.u() >> 11) as f64 / (1u64 << 53) as f64
    }
    fn mag(&mut self, e: i32) -> f64 {
        let x = (1.0 + self.f()) * 2f64.powi((self.u() % (2 * e as u64)) as i32 - e);
        if self.u() % 2 == 0 { x } else { -x }
    }
}
fn run<F: Formula>(n: usize, jac: bool) {
    let mut r = R(0x9E3779B97F4A7C15);
    for dist in 0..4 {
        let mut hist = [0usize; 4]; let (mut w, mut wj, mut atv, mut atj) = (0.0f64, 0.0f64, String::new(), String::new());
        let len = F::Inputs::<f64>::len();
        let mut sampler = Sampler::new::<F>(99);
        for _ in 0..n {
            let comps: Vec<f64> = match dist {
                0 => sampler.inputs::<F>().components(),
                1 => (0..len).map(|_| r.mag(40)).collect(),
                2 => {
                    // correlated: each component is base of its axis + perturbation
                    let base: Vec<f64> = (0..3).map(|_| r.mag(40)).collect();
                    (0..len)
                        .map(|k| {
                            if r.u() % 3 == 0 {
                                base[k % 3]
                            } else if r.u() % 2 == 0 {
                                base[k % 3] * (1.0 + r.mag(30) * 2f64.powi(-20))
                            } else {
                                r.mag(40)
                            }
                        })
                        .collect()
                }
                _ => (0..len)
                    .map(|_| match r.u() % 4 {
                        0 => 0.0,
                        1 => ((r.u() % 7) as f64 - 3.0) * 0.1,
                        2 => (r.u() % 5) as f64 - 2.0,
                        _ => r.mag(30),
                    })
                    .collect(),
            };
            let i = F::Inputs::from_slice(&comps).unwrap();
            if check::<F>(&i).is_err() {
                continue;
            }
            let e = exactly::<F>(&i);
            let (v, x) = (F::eval(&i).components(), F::eval(&e).components());
            let ad = jacobian_by_ad::<F, Octuple>(&e);
            let inputs = e.components();
            for (k, row) in ad.components().iter().enumerate() {
                let q = eta(v[k], x[k], Sensitivity::new(&row.components(), &inputs));
                if q > w {
                    w = q;
                    atv = format!("out {k} {} {} {:?}", v[k], x[k].to_f64(), comps);
                }
            }
            if jac && kink::<F>(&i) != Some(Convention::Switch) {
                let g = derivative_of_jacobian::<F, Octuple>(&e);
                let c: Vec<f64> = F::jacobian(&i).components().iter().flat_map(|r| r.components()).collect();
                let x: Vec<Octuple> = F::jacobian(&e).components().iter().flat_map(|r| r.components()).collect();
                for k in 0..c.len() {
                    let q = eta(c[k], x[k], Sensitivity::new(&g[k], &inputs));
                    if q > 4.0 { hist[0] += 1; } if q > 8.0 { hist[1] += 1; } if q > 16.0 { hist[2] += 1; } if q > 32.0 { hist[3] += 1; }
                    if q > wj {
                        wj = q;
                        atj = format!("entry {k} {} {} {:?}", c[k], x[k].to_f64(), comps);
                    }
                }
            }
        }
        println!("{:30} dist {dist} value {w:.2} jacobian {wj:.2} entries over 4, 8, 16, 32: {hist:?}", F::SPEC.id);
        if w > 6.0 {
            println!("   {atv}");
        }
        if wj > 12.0 {
            println!("   {atj}");
        }
    }
}
#[test]
fn tails() {
    let n: usize = std::env::var("N").map_or(2000, |s| s.parse().unwrap());
    let jac = std::env::var("J").is_ok();
    if std::env::var("ONLY").is_ok() { run::<IncrementalConstraint>(n, jac); return; }
    run::<Line>(n, jac);
    run::<Basis>(n, jac);
    run::<Constraint>(n, jac);
    run::<Eliminate>(n, jac);
    run::<DirectionVariation>(n, jac);
    run::<BasisVariation>(n, jac);
    run::<IncrementalConstraint>(n, jac);
    run::<Increment>(n, jac);
    run::<Constraint2d>(n, jac);
    run::<Increment2d>(n, jac);
}
