use jointproof::catalog::CATALOG;
use jointproof::verify::{Looked, Options};
#[test]
fn look() {
    let only = std::env::var("ONLY").unwrap_or_default();
    for f in CATALOG.iter().filter(|f| f.spec().id.starts_with(&only)) {
        let t = std::time::Instant::now();
        let a = f.audit(&Options { samples: 20, seed: 1 });
        println!("{} {:?} {}", f.spec().id, t.elapsed(), if a.passed() { "" } else { "OFF" });
        for c in a.claims().filter(|c| !c.held()) { println!("   FAIL {} {} of {}: {:?}", c.claim, c.failures, c.checks, c.worst); }
        println!("   worst {:?}", a.kinks.worst.as_ref().map(|w| (w.size, &w.entry, &w.point)));
        match &a.looked {
            Some(Looked::Graph(s, c)) => {
                println!("   cand {} points {} smooth {} registered {} notreached {}", s.candidates, s.points, s.smooth, s.registered, s.not_reached.len());
                for n in s.not_reached.iter().take(6) { println!("      NR {n}"); }
                for k in f.kinks() { if !s.found.contains(&k.condition) { println!("      LOST {}", k.condition); } }
                println!("   compares {} asked {}", c.comparisons, c.asked);
                for n in &c.never { println!("      {n}"); }
            }
            other => println!("   {other:?}"),
        }
        for k in f.kinks() { println!("     {:?} {} {:?}", k.convention, k.condition, k.sides); }
    }
}
