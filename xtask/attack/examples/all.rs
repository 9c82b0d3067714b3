#![allow(missing_docs)]
use attack::{Effort, attack};
use jointproof::catalog::CATALOG;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let (seconds, seed): (f64, u64) = (args[1].parse().unwrap(), args[2].parse().unwrap());
    let filter = args.get(3).cloned().unwrap_or_default();
    let chosen: Vec<_> = CATALOG.iter().filter(|f| filter.split(',').any(|p| f.spec().id.contains(p))).collect();
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    let Some(formula) = chosen.get(k) else { return };
                    let start = Instant::now();
                    match attack(**formula, Effort::Time(Duration::from_secs_f64(seconds)), seed) {
                        Err(why) => println!("{} {why}", formula.spec().id),
                        Ok(found) => {
                            let mut text = format!(
                                "{:38} {:>8} evals {:5.1} s",
                                formula.spec().id,
                                found.evaluations,
                                start.elapsed().as_secs_f64()
                            );
                            for (claim, most) in found.claims.iter().zip(&found.first_order) {
                                let worst = claim.worst.as_ref().map_or(0.0, |w| w.size);
                                let entry = claim.worst.as_ref().map_or(String::new(), |w| w.entry.clone());
                                let mark = if worst > claim.bound { "REFUTED" } else { "" };
                                text += &format!(
                                    " | {}{} {worst:.3} of {} (E/S {most:.2}) {mark} {entry}",
                                    if claim.claim.contains("Jacobian") { "J" } else { "V" },
                                    if claim.is_normwise() { "n" } else { "" },
                                    claim.bound
                                );
                                if let Some(w) = &claim.worst {
                                    text += &format!("\n     {}", w.inputs);
                                }
                            }
                            println!("{text}");
                        }
                    }
                }
            });
        }
    });
}
