//! The audit passes for the catalog, and detects planted faults: a wrong sign, a missing factor 2, a swapped index, a wrong value
//! at a kink, an inaccurate algorithm.

use crate::common;
use jointproof::catalog::CATALOG;
use jointproof::fields;
use jointproof::formula::proof::{Case, Convention, Flag, Kink, Proved};
use jointproof::formula::quantity::{F2, F3, FC};
use jointproof::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use jointproof::number::scalar::{Scalar, abs, direction, norm, sign};
use jointproof::toolkit::verify;
use jointproof::toolkit::verify::golden::Record;
use jointproof::toolkit::verify::{Examination, Options, Rank, Sides, audit};
use rayon::prelude::*;
use std::collections::HashSet;
use std::f64::consts::TAU;

mod laws;
mod planted;

#[test]
fn every_formula_of_the_catalog_passes() {
    // Points of a different seed from those of `verify`, which uses a thousand.
    CATALOG.par_iter().for_each(|formula| {
        let audit = formula.audit(&Options { samples: 25, seed: 2 });
        assert!(audit.passed(), "{audit:#?}");
        // No registered kink is missed: the graph alone leads to each.
        if let Some(Examination::Graph { search, .. }) = audit.examination {
            let lost = formula.kinks().into_iter().find(|kink| !search.found.contains(&kink.condition));
            assert!(lost.is_none(), "{}: {lost:?} is not among {:?}", audit.formula, search.found);
        }
    });
}

/// The audit of a formula uses all its hard cases; here each hard case of some formulas is given alone, as a single point, and
/// one hard case of every other formula.
#[test]
fn hard_cases_alone_pass() {
    CATALOG.par_iter().enumerate().for_each(|(k, formula)| {
        let golden = common::golden(*formula);
        let is_hard = |case: &&Record| case.error.is_none() && !case.flags.contains(&Flag::Random);
        let hard: Vec<_> = golden.cases.iter().filter(is_hard).collect();
        let step = if k % 8 == 0 { 1 } else { hard.len() };
        for case in hard.into_iter().skip(k % step).step_by(step) {
            let inputs = verify::golden::components(formula.inputs(), &case.inputs).unwrap();
            let audit = formula.audit_at(&inputs).unwrap();
            // Laws hold at points in general position; derivatives and accuracy are checked at all.
            let closed = audit.closed_against_ad.iter().chain(&audit.eta_jacobian);
            let claims = [&audit.ad_against_differences, &audit.eta].into_iter().chain(closed);
            let failed: Vec<_> = claims.filter(|claim| claim.failures > 0).collect();
            assert!(failed.is_empty(), "{} {}: {failed:#?}", audit.formula, case.id);
        }
    });
}

#[test]
fn identifiers_are_unique_and_families_are_rooms() {
    let mut seen = HashSet::new();
    for formula in CATALOG {
        let id = formula.spec().id;
        assert!(seen.insert(id), "two formulas are named {id}");
        let family = id.split('.').next().unwrap();
        // Blocks have their own module names in `element`: those of JOIN are in `element::line`.
        let is_module = |module: &str| module == family || module == "element";
        assert!(formula.path().split("::").any(is_module), "{id} is implemented by {}", formula.path());
    }
}

#[test]
fn what_jumps_on_a_kink_is_known_and_is_what_its_convention_says() {
    for formula in CATALOG {
        for kink in formula.kinks() {
            let context = format!("{} at {}: {:?}", formula.spec().id, kink.condition, kink.sides);
            let Some(Sides { rank, sides: [below, above], .. }) = kink.sides else { panic!("{context}") };
            assert_ne!(below, above, "{context}");
            match kink.convention {
                // The returned derivative, 0, is between those on both sides.
                Convention::Subgradient => assert!(rank == Rank::Slope && below * above < 0.0, "{context}"),
                Convention::Cut => assert!(rank == Rank::Value && (above - below).abs() == TAU, "{context}"),
                Convention::Switch => {}
            }
        }
    }
}

fields! { struct Inputs<T> { f2: T = F2, f3: T = F3 } }
fields! { struct Outputs<T> { fc: T = FC } }

/// √(f2² + f3²) with a fault planted in value or Jacobian.
trait Fault: Copy + Send + Sync + 'static {
    const FINITE: Finite = Finite::Between;
    fn value<D: Scalar>(i: &Inputs<D>) -> D {
        norm([i.f2, i.f3])
    }
    fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
        direction([i.f2, i.f3])
    }
}

#[derive(Clone, Copy)]
struct Planted<T>(T);

impl<T: Fault> Formula for Planted<T> {
    const SPEC: Spec = Spec::new("planted.fault", "Planted fault", Document::SLOT.printed("Friction"))
        .equation(r"F_C = \sqrt{f_2^2 + f_3^2}")
        .eta(2.0, 2.0)
        .finite(T::FINITE);
    type Inputs<E: Component> = Inputs<E>;
    type Outputs<E: Component> = Outputs<E>;
    fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
        Outputs { fc: T::value(i) }
    }
    fn jacobian<D: Scalar>(i: &Inputs<D>) -> Jacobian<Self, D> {
        let [f2, f3] = T::gradient(i);
        Outputs { fc: Inputs { f2, f3 } }
    }
}

impl<T: Fault> Proved for Planted<T> {
    fn cases() -> Vec<Case<Inputs<f64>>> {
        vec![
            Case::hard("zero", "", Inputs { f2: 0.0, f3: 0.0 }),
            Case::hard("huge", "", Inputs { f2: 3e200, f3: 4e200 }),
        ]
    }
    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_norm(Inputs { f2: 0.0, f3: 0.0 }, |i| [i.f2, i.f3])]
    }
}

/// The claims that failed, with the entry and point of the worst deviation.
fn caught<T: Fault>() -> Vec<(String, String, String)> {
    let audit = audit::<Planted<T>>(&Options { samples: 20, seed: 3 });
    let failed = audit.claims().filter(|claim| claim.failures > 0).cloned();
    failed.filter_map(|claim| claim.worst.map(|worst| (claim.claim, worst.entry, worst.point))).collect()
}

fn assert_names(caught: &[(String, String, String)], claim: &str, entry: &str) {
    let named = caught.iter().any(|(failed, at, _)| failed.contains(claim) && at == entry);
    assert!(named, "{claim} at {entry} is not among {caught:?}");
}

#[test]
fn without_a_fault_nothing_is_caught() {
    #[derive(Clone, Copy)]
    struct None;
    impl Fault for None {}
    assert!(audit::<Planted<None>>(&Options { samples: 20, seed: 3 }).passed());
}

#[test]
fn a_wrong_sign_is_caught() {
    #[derive(Clone, Copy)]
    struct WrongSign;
    impl Fault for WrongSign {
        fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
            let [f2, f3] = direction([i.f2, i.f3]);
            [f2, -f3]
        }
    }
    assert_names(&caught::<WrongSign>(), "closed form = automatic", "∂fc/∂f3");
}

#[test]
fn a_missing_factor_two_is_caught() {
    #[derive(Clone, Copy)]
    struct MissingFactor;
    impl Fault for MissingFactor {
        fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
            let [f2, f3] = direction([i.f2, i.f3]);
            [f2 * 0.5, f3]
        }
    }
    assert_names(&caught::<MissingFactor>(), "closed form = automatic", "∂fc/∂f2");
}

#[test]
fn a_swapped_index_is_caught() {
    #[derive(Clone, Copy)]
    struct Swapped;
    impl Fault for Swapped {
        fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
            let [f2, f3] = direction([i.f2, i.f3]);
            [f3, f2]
        }
    }
    let caught = caught::<Swapped>();
    assert!(
        caught.iter().any(|(claim, entry, _)| claim.contains("closed form = automatic") && entry.starts_with("∂fc/∂f")),
        "{caught:?}"
    );
}

#[test]
fn a_wrong_value_at_a_kink_is_caught() {
    #[derive(Clone, Copy)]
    struct WrongAtKink;
    impl Fault for WrongAtKink {
        fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
            if i.f2 == 0.0 && i.f3 == 0.0 { [D::one(), D::zero()] } else { direction([i.f2, i.f3]) }
        }
    }
    let caught = caught::<WrongAtKink>();
    assert_names(&caught, "closed form = automatic", "∂fc/∂f2");
    assert!(caught.iter().all(|(.., point)| point == "zero"), "{caught:?}");
}

#[test]
fn an_overflowing_algorithm_is_caught() {
    #[derive(Clone, Copy)]
    struct Naive;
    impl Fault for Naive {
        fn value<D: Scalar>(i: &Inputs<D>) -> D {
            let sum = i.f2 * i.f2 + i.f3 * i.f3;
            if sum == 0.0 { D::zero() } else { sum.sqrt() }
        }
    }
    let caught = caught::<Naive>();
    assert_names(&caught, "η of the value", "fc");
    assert!(caught.iter().any(|(.., point)| point == "huge"), "{caught:?}");
}

/// The square of a number below 1e-154 is 0, and the reciprocal of 0 infinite.
#[derive(Clone, Copy)]
struct DividesBySquare<const WHERE_TINY: bool>;
impl<const WHERE_TINY: bool> Fault for DividesBySquare<WHERE_TINY> {
    const FINITE: Finite = if WHERE_TINY { Finite::Below } else { Finite::Between };
    fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
        let square = i.f2 * i.f2 + i.f3 * i.f3;
        if i.f2 == 0.0 && i.f3 == 0.0 { [D::zero(); 2] } else { [i.f2, i.f3].map(|f| f * norm([i.f2, i.f3]) / square) }
    }
}

#[test]
fn an_overflow_where_none_is_stated_is_caught() {
    let overflow = |caught: Vec<(String, _, _)>| caught.iter().any(|(claim, ..)| claim.contains("overflows"));
    assert!(overflow(caught::<DividesBySquare<true>>()));
    assert!(!overflow(caught::<DividesBySquare<false>>()));
}

#[test]
fn a_law_that_does_not_hold_is_caught() {
    #[derive(Clone, Copy)]
    struct NotHomogeneous;
    impl Fault for NotHomogeneous {
        fn value<D: Scalar>(i: &Inputs<D>) -> D {
            abs(i.f2) + 1.0
        }
        fn gradient<D: Scalar>(i: &Inputs<D>) -> [D; 2] {
            [sign(i.f2), D::zero()]
        }
    }
    assert_names(&caught::<NotHomogeneous>(), "homogeneity", "equation 0");
}
