use jointproof::catalog::AnyFormula;
use jointproof::ujoint::*;
use jointproof::verify::Options;

fn formulas() -> Vec<&'static dyn AnyFormula> {
    vec![&TwistFactors, &AxialFactors, &Reaction, &CrossDirection, &Decomposition, &HingeTwist, &HingeAxial, &HingeTransverse, &HingeBending]
}

#[test]
fn audits() {
    let samples = std::env::var("SAMPLES").map_or(100, |s| s.parse().unwrap());
    let seeds: Vec<u64> = std::env::var("SEEDS").map_or(vec![1], |s| s.split(',').map(|s| s.parse().unwrap()).collect());
    let filter = std::env::var("FILTER").unwrap_or_default();
    let mut failed = false;
    for formula in formulas() {
        if !formula.spec().id.contains(&filter) { continue; }
        for &seed in &seeds {
            let audit = formula.audit(&Options { samples, seed });
            for claim in &audit.claims {
                let worst = claim.worst.as_ref();
                let ok = claim.held();
                failed |= !ok;
                println!("{} {} | {} | {} checks, {} failures, bound {:e}, worst {:.3e} at {} {}", if ok {"ok  "} else {"FAIL"}, audit.formula, claim.claim, claim.checks, claim.failures, claim.bound,
                    worst.map_or(0.0, |w| w.size), worst.map_or("", |w| &w.point), worst.map_or("", |w| &w.entry));
                if !ok { println!("      {:?}", worst.map(|w| (w.found, w.expected, w.inputs.to_string()))); }
            }
        }
    }
    assert!(!failed);
}

#[test]
fn golden() {
    let dir = std::env::var("GOLDEN").unwrap_or("/tmp/w/ujoint-golden".into());
    std::fs::create_dir_all(&dir).unwrap();
    for formula in formulas() {
        std::fs::write(format!("{dir}/{}.json", formula.spec().id), formula.golden().render().unwrap()).unwrap();
    }
}
