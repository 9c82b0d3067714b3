use jointproof::{catalog::CATALOG, measure::Options};
fn main() {
    let mut o = Options::quick();
    if std::env::args().nth(1).as_deref() == Some("full") {
        o = Options::full();
    }
    for f in CATALOG {
        let t0 = std::time::Instant::now();
        let mut m = f.errors(&o);
        let t1 = t0.elapsed();
        f.times(&o, &mut m);
        println!(
            "{} {}x{} copy {:.1} yard {:.1} errors {:?} times {:?} random {} hard {}",
            m.formula,
            m.outputs,
            m.inputs,
            m.copy.unwrap().median,
            m.yardstick.unwrap().median,
            t1,
            t0.elapsed() - t1,
            m.random_points,
            m.hard_points
        );
        for w in &m.ways {
            for (n, g) in [("v", &w.value), ("j", &w.jacobian)] {
                if let Some(g) = g {
                    let (t, r) = (g.time.unwrap(), g.ratio.unwrap());
                    println!(
                        "   {:12}{n} {:9.1} [{:.1} {:.1}] x{:.2} [{:.2} {:.2}] eta {:.2} {:.2} {:.2} rel {:.0e} hard {:?}",
                        w.id,
                        t.median,
                        t.low,
                        t.high,
                        r.median,
                        r.low,
                        r.high,
                        g.random.eta.median,
                        g.random.eta.p99,
                        g.random.eta.max,
                        g.random.relative.median,
                        g.hard.map(|h| (h.eta.max, h.not_finite))
                    );
                }
            }
        }
    }
}
