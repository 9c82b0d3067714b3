#![allow(missing_docs)]
use jointproof::catalog::CATALOG;
use jointproof::toolkit::verify::golden::components;
use serde_json::{Map, Value};
fn main() {
    let kept: Map<String, Value> =
        serde_json::from_str(&std::fs::read_to_string("tests/data/beyond.json").unwrap()).unwrap();
    for formula in CATALOG {
        let id = formula.spec().id;
        let Some(named) = kept.get(id).and_then(Value::as_object) else { continue };
        let inputs = components(formula.inputs(), named).unwrap();
        match formula.audit_at(&inputs) {
            Ok(audit) => {
                let bad = [&audit.eta].into_iter().chain(&audit.eta_jacobian).any(|c| c.failures > 0);
                if !bad {
                    println!(
                        "{id} scale {:e} holds: {:?}",
                        formula.spec().scale,
                        [&audit.eta]
                            .into_iter()
                            .chain(&audit.eta_jacobian)
                            .map(|c| c.worst.as_ref().map(|w| w.size))
                            .collect::<Vec<_>>()
                    );
                    const SCALES: [f64; 15] =
                        [1e3, 1e5, 1e10, 1e15, 1e20, 1e30, 1e40, 1e50, 1e60, 1e80, 1e100, 1e120, 1e150, 1e200, 1e250];
                    let place = SCALES.iter().position(|&k| k == formula.spec().scale).unwrap();
                    for k in place + 1..15 {
                        let found = (1..8).find_map(|seed| {
                            let options = jointproof::toolkit::verify::Options { samples: 1000, seed };
                            formula.eta_at_scale(SCALES[k], &options).into_iter().find(|c| c.failures > 0)
                        });
                        if let Some(c) = found {
                            let w = c.worst.unwrap();
                            println!("  FOUND at {:e} \"{id}\": {} {}", SCALES[k], w.inputs, w.size);
                            break;
                        }
                    }
                }
            }
            Err(e) => println!("{id} {e}"),
        }
    }
}
