//! The audit of one formula, and its value in 237 bits. Needs the feature `verify`.
//!
//! ```sh
//! cargo run --example audit --features verify
//! ```

use jointproof::connector::slot::{ContactForce, CrossForces};
use jointproof::formula::Formula;
use jointproof::toolkit::verify::{Options, audit, exactly};

fn main() {
    let audit = audit::<ContactForce>(&Options { samples: 200, seed: 1 });
    for claim in audit.claims() {
        let verdict = if claim.held() { "held" } else { "off" };
        let worst = claim.worst.as_ref().map_or(0.0, |worst| worst.size);
        println!(
            "{verdict}  {}: {} comparisons, worst {worst:.1e}, bound {:.1e}",
            claim.claim, claim.checks, claim.bound
        );
    }
    let forces = CrossForces { f2: 0.1, f3: 0.2 };
    println!("F_C at (0.1, 0.2) is {}", ContactForce::eval(&exactly::<ContactForce>(&forces)).fc);
}
