use jointproof::catalog::CATALOG;
use jointproof::verify::Options;

fn mine() -> impl Iterator<Item = &'static &'static dyn jointproof::catalog::AnyFormula> {
    let filter = std::env::var("FILTER").unwrap_or_default();
    CATALOG.iter().filter(move |f| {
        let id = f.spec().id;
        (id.starts_with("slide_line") || id.starts_with("interaction")) && id.contains(&filter)
    })
}

#[test]
fn audit() {
    let samples = std::env::var("SAMPLES").map_or(50, |s| s.parse().unwrap());
    let seeds: u64 = std::env::var("SEEDS").map_or(1, |s| s.parse().unwrap());
    let mut bad = 0;
    for f in mine() {
        for seed in 1..=seeds {
            let start = std::time::Instant::now();
            let audit = f.audit(&Options { samples, seed });
            println!("{} seed {seed} {:?}: named {}", audit.formula, start.elapsed(), audit.named_points);
            for c in audit.claims() {
                let w = c.worst.as_ref();
                let mark = if c.held() { "  " } else { bad += 1; "!!" };
                println!("  {mark} {:70} bound {:e} checks {} fail {} worst {:.3e} {} @ {}", c.claim, c.bound, c.checks, c.failures,
                    w.map_or(0.0, |w| w.size), w.map_or("", |w| &w.entry), w.map_or("", |w| &w.point));
                if !c.held() { if let Some(w) = w { println!("       found {:e} expected {:e} in {}", w.found, w.expected, w.inputs); } }
            }
        }
    }
    assert_eq!(bad, 0);
}

#[test]
fn golden() {
    let Ok(dir) = std::env::var("GOLDEN") else { return };
    for f in mine() {
        let start = std::time::Instant::now();
        let text = f.golden().render().unwrap();
        std::fs::write(format!("{dir}/{}.json", f.spec().id), text).unwrap();
        println!("{} {:?}", f.spec().id, start.elapsed());
    }
}

#[test]
fn closed_against_ad() {
    use jointproof::formula::{Fields, Formula};
    use jointproof::verify::{exactly, jacobian_by_ad, relative};
    fn check<F: Formula>() {
        for case in F::cases() {
            let exact = exactly::<F>(&case.inputs);
            let closed: Vec<_> = F::jacobian(&exact).components().iter().flat_map(Fields::components).collect();
            let ad: Vec<_> = jacobian_by_ad::<F, _>(&exact).components().iter().flat_map(Fields::components).collect();
            for (k, (&c, &a)) in closed.iter().zip(&ad).enumerate() {
                if relative(c, a) > 1e-60 { println!("{} entry {k}: {:e} {:e} rel {:e}", case.id, c.to_f64(), a.to_f64(), relative(c, a)); }
            }
        }
    }
    check::<jointproof::slide_line::ClosestParabolic>();
    check::<jointproof::slide_line::ClosestSmoothedLinear>();
    check::<jointproof::slide_line::ClosestSmoothedParabolic>();
}
