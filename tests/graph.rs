//! What a formula does, written down, does what the formula does.

use jointproof::catalog::CATALOG;
use jointproof::verify::golden::components;

#[test]
fn print() {
    for formula in CATALOG {
        let start = std::time::Instant::now();
        match formula.graph() {
            Err(why) => println!("{:40} {why} {:?}", formula.spec().id, start.elapsed()),
            Ok(graph) => {
                let golden = formula.golden();
                let mut differ = 0;
                let mut n = 0;
                let mut at = String::new();
                for case in golden.cases.iter().filter(|case| case.out.is_some()) {
                    let inputs = components(formula.inputs(), &case.inputs).unwrap();
                    let (value, jacobian) = graph.run(&inputs);
                    let found: Vec<_> = value.iter().chain(&jacobian).map(|x| x.to_bits()).collect();
                    let (value, jacobian) = formula.value_and_jacobian(&inputs).unwrap_or_default();
                    let expected: Vec<_> = value.iter().chain(&jacobian).map(|x| x.to_bits()).collect();
                    for (k, (a, b)) in found.iter().zip(&expected).enumerate() {
                        n += 1;
                        if a != b {
                            differ += 1;
                            if at.is_empty() {
                                at = format!("{} {k} {} {}", case.id, f64::from_bits(*a), f64::from_bits(*b));
                            }
                        }
                    }
                }
                println!(
                    "{:40} {:6} ops, {} of {} differ {at} {:?}",
                    formula.spec().id,
                    graph.ops().len(),
                    differ,
                    n,
                    start.elapsed()
                );
            }
        }
    }
}
