use jointproof::catalog::CATALOG;
use jointproof::verify::Options;
#[test]
fn scratch() {
    let samples = std::env::var("SAMPLES").map_or(1000, |s| s.parse().unwrap());
    let seeds: Vec<u64> =
        std::env::var("SEEDS").map_or(vec![1], |s| s.split(',').map(|x| x.parse().unwrap()).collect());
    let filter = std::env::var("FILTER").unwrap_or_default();
    let dir = std::env::var("GOLDEN").ok();
    for f in CATALOG.iter().filter(|f| f.spec().id.starts_with("slider.") && f.spec().id.contains(&filter)) {
        if let Some(dir) = &dir {
            let g = f.golden();
            let t = g.render().unwrap();
            println!("{} {} cases {} bytes", g.formula, g.cases.len(), t.len());
            std::fs::write(format!("{dir}/{}.json", g.formula), t).unwrap();
            continue;
        }
        if std::env::var("CASES").is_ok() {
            for case in f.golden().cases.iter().filter(|case| case.error.is_none()) {
                let inputs = jointproof::verify::golden::components(f.inputs(), &case.inputs).unwrap();
                let a = f.audit_at(&inputs).unwrap();
                for c in a.claims().filter(|c| c.failures > 0) {
                    let w = c.worst.as_ref().unwrap();
                    println!(
                        "{} {}: {:.70} fail {} worst {:.3e} {} found {:e} expected {:e}",
                        a.formula, case.id, c.claim, c.failures, w.size, w.entry, w.found, w.expected
                    );
                }
            }
            continue;
        }
        for &seed in &seeds {
            let a = f.audit(&Options { samples, seed });
            println!("== {} seed {seed} named {} passed {}", a.formula, a.named_points, a.passed());
            for c in a.claims() {
                let w = c.worst.as_ref();
                println!(
                    "   {:5} {:<90.90} bound {:.1e} checks {} fail {} worst {:.3e} {} @ {}",
                    if c.held() { "ok" } else { "FAIL" },
                    c.claim,
                    c.bound,
                    c.checks,
                    c.failures,
                    w.map_or(0.0, |w| w.size),
                    w.map_or("", |w| &w.entry),
                    w.map_or("", |w| &w.point)
                );
                if !c.held() {
                    if let Some(w) = w {
                        println!("        found {:e} expected {:e} {}", w.found, w.expected, w.inputs);
                    }
                }
            }
        }
    }
}
