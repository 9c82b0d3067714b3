//! The printed equations are executed.

use jointproof::catalog::CATALOG;
use jointproof::equation::Equation;
use jointproof::verify::Options;

#[test]
fn every_equation_can_be_executed() {
    let mut wrong = 0;
    for formula in CATALOG {
        if let Err(error) = Equation::of(&formula.spec(), formula.inputs(), formula.outputs()) {
            println!("{}: {error}", formula.spec().id);
            wrong += 1;
        }
    }
    assert_eq!(wrong, 0);
}

#[test]
fn audits() {
    for formula in CATALOG {
        let audit = formula.audit(&Options { samples: 5, seed: 2 });
        for claim in [&audit.equation, &audit.equation_jacobian] {
            let worst = claim.worst.as_ref().map(|w| (w.size, w.entry.clone(), w.point.clone(), w.found, w.expected));
            println!(
                "{} {} {}/{} {worst:?}",
                if claim.held() { "ok" } else { "OFF" },
                audit.formula,
                claim.failures,
                claim.checks
            );
        }
    }
}
