//! Parts of an audit, joined in any groups, equal the audit of one machine byte for byte.

use jointproof::catalog::AnyFormula;
use jointproof::connector::{slot, translator};
use jointproof::contact::coulomb;
use jointproof::toolkit::verify::{Audit, Options, Part, PartError, Shard};

const OPTIONS: Options = Options { samples: 40, seed: 7 };

fn parts(formula: &dyn AnyFormula, of: usize) -> Vec<Part> {
    let part = |index| formula.audit_part(&OPTIONS, Shard::new(index, of).unwrap());
    (1..=of).map(part).collect()
}

/// As JSON, the form in which parts are sent.
fn bytes(audit: &Audit) -> String {
    serde_json::to_string(audit).unwrap()
}

fn sent(part: &Part) -> Part {
    serde_json::from_str(&serde_json::to_string(part).unwrap()).unwrap()
}

fn joined(parts: impl IntoIterator<Item = Part>) -> Part {
    parts.into_iter().reduce(|one, next| one.and(next).unwrap()).unwrap()
}

#[test]
fn parts_are_the_whole_however_many_and_however_joined() {
    let formulas: [&dyn AnyFormula; 4] =
        [&slot::Friction, &coulomb::ReturnMap, &translator::TorqueForce, &slot::RelativePosition];
    for formula in formulas {
        let whole = formula.audit(&OPTIONS);
        assert!(whole.passed(), "{whole:#?}");
        assert_eq!(whole.random_points, OPTIONS.samples);
        // Many of 64 parts have no point.
        for of in [1, 3, 16, 64] {
            let all = parts(formula, of).iter().map(sent).collect::<Vec<_>>();
            let in_order = joined(all.clone()).into_audit().unwrap();
            assert_eq!(bytes(&in_order), bytes(&whole), "{of} parts");
            let groups = all.chunks(of.div_ceil(4)).map(|group| joined(group.to_vec()));
            let backwards = groups.rev().reduce(|later, earlier| earlier.and(later).unwrap());
            assert_eq!(bytes(&backwards.unwrap().into_audit().unwrap()), bytes(&whole), "{of} parts in groups");
        }
    }
}

#[test]
fn parts_are_sorted_by_their_first() {
    let all = parts(&slot::Friction, 3);
    assert_eq!(all.iter().map(Part::first).collect::<Vec<_>>(), [1, 2, 3]);
    assert_eq!(joined(all[1..].to_vec()).first(), 2);
}

#[test]
fn what_is_not_one_audit_is_refused() {
    let all = parts(&slot::Friction, 3);
    let said = |error: PartError| error.to_string();
    let skipped = all[0].clone().and(all[2].clone()).unwrap_err();
    assert_eq!(said(skipped), "slot.friction: part 3 of 3 does not follow 1");
    let missing = all[0].clone().and(all[1].clone()).unwrap().into_audit().unwrap_err();
    assert_eq!(said(missing), "slot.friction: parts 1 to 2 of 3 are not all");
    let other = parts(&slot::ContactForce, 3);
    assert!(all[0].clone().and(other[1].clone()).is_err());
    for wrong in ["0/4", "5/4", "1/0", "1", "a/b", "-1/4"] {
        assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
    }
}
