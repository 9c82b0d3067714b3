//! A fault for every claim of an audit that violates this claim alone: just within the bound it passes, at 3 and at 50
//! times the bound it is caught, and the size that is reported is the size that was planted.

use jointproof::formula::proof::law::equal;
use jointproof::formula::proof::{Case, Kink, Law, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Shape, Unit};
use jointproof::formula::{Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian};
use jointproof::number::scalar::{Scalar, abs, constant, direction, leaf, norm, sign};
use jointproof::toolkit::verify::{Audit, Claim, Deviation, Examination, Options, Sampler, audit, audit_at};
use jointproof::{Octuple, fields};
use nalgebra::Vector3;
use std::cell::Cell;

const S: Quantity = Quantity::scalar("s", Unit::F, Domain::Real, "a number");
const V: Quantity = Quantity::new(r"\mathbf{v}", Shape::Vec3, Unit::F, Domain::Vector, "a vector");
const P: Quantity = Quantity::scalar("p", Unit::F.times(Unit::F), Domain::Real, "the number times the vector's length");
fields! { struct Inputs<T> { s: T = S, v: Vector3<T> = V } }
fields! { struct Outputs<T> { p: T = P } }

/// What is wrong with the formula.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    Nothing,
    /// The closed form, in a digit that `f64` does not have.
    ClosedForm,
    /// Automatic differentiation: the value has a part of which it knows no derivative; everywhere, or at a hard point only.
    Rule,
    RuleAtHardPoint,
    /// Where the number is the size of the fault.
    RuleAtNumber,
    /// What rounding does in `f64`; in `linearized` alone, where value and Jacobian come together.
    Value,
    Jacobian,
    ValueTogether,
    JacobianTogether,
    /// The value against the printed equation, and only its derivative.
    PrintedValue,
    PrintedDerivative,
    /// Laws that every formula has, and one of its own.
    Homogeneity,
    Indifference,
    OwnLaw,
    /// A derivative that jumps where nothing is registered.
    Kink,
    /// A derivative that jumps at a named point, where no graph tells.
    Corner,
    /// What rounding does just beside a kink, where a component is the size of the fault; and in the derivative on it.
    BesideKink,
    OnKink,
    /// A number on the way that is too large for `f64`, though the result is not.
    Overflow,
    /// One that is too small, where the inputs are smaller than most.
    Underflow,
    /// NaN in `f64`; just beside every double; on a side of a law.
    NanValue,
    NanBeside,
    NanLaw,
}

thread_local! {
    /// The fault, and its size in units of what the claim allows. Each test has a thread of its own.
    static PLANTED: Cell<(Fault, f64)> = const { Cell::new((Fault::Nothing, 0.0)) };
}

/// How much there is of a fault.
fn amount(fault: Fault, unit: f64) -> f64 {
    let (planted, times) = PLANTED.get();
    if planted == fault { times * unit } else { 0.0 }
}

/// 1 plus a part.
fn more<D: Scalar>(part: f64) -> D {
    D::from(1.0) + part
}

/// 1, but in `f64` less by so many roundings: next to 2²⁰ they are lost.
fn rounded<D: Scalar>(roundings: f64) -> D {
    const BIG: f64 = 1_048_576.0;
    let lost = D::from(roundings * f64::EPSILON / 2.0);
    more::<D>(0.0) + ((D::from(BIG) + lost) - BIG - lost)
}

/// What is left of a number beside the nearest double, and nothing for automatic differentiation.
fn beside<D: Scalar>(x: D) -> D {
    constant::<D>(leaf(x)) - x.re()
}

/// Faults that change value and derivative in proportion.
fn factor<D: Scalar>(i: &Inputs<D>, length: D) -> D {
    let where_so = |is_so: bool, part: f64| if is_so { part } else { 0.0 };
    more::<D>(where_so(length > 1.0, amount(Fault::Homogeneity, 2e-60)))
        * more::<D>(where_so(i.v.x > 0.0, amount(Fault::Indifference, 5.62e-60)))
        * more::<D>(where_so(abs(i.s) > length, amount(Fault::OwnLaw, 2e-60)))
}

#[derive(Clone, Copy)]
struct Product;

impl Formula for Product {
    const SPEC: Spec = Spec::new("planted.product", "Planted faults", Document::new("Faults").printed(""))
        .equation(r"p = s\,\lvert\mathbf{v}\rvert")
        .eta(32.0, 32.0)
        .finite(Finite::Between);
    type Inputs<T: Component> = Inputs<T>;
    type Outputs<T: Component> = Outputs<T>;

    fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
        let length = norm([i.v.x, i.v.y, i.v.z]);
        let mut p = i.s * length * factor(i, length) * rounded::<D>(amount(Fault::Value, 96.0));
        match PLANTED.get().0 {
            Fault::Rule => p += length * beside(i.s) * amount(Fault::Rule, 4e-50),
            Fault::RuleAtHardPoint if i.s.re() == 3.0 => {
                p += length * beside(i.s) * amount(Fault::RuleAtHardPoint, 4e-35);
            }
            Fault::RuleAtNumber if i.s.re() == PLANTED.get().1 => p += length * beside(i.s) * 1e-46,
            Fault::PrintedValue => p += constant::<D>(leaf(p)) * amount(Fault::PrintedValue, 5e-55),
            Fault::PrintedDerivative => p += length * (i.s - i.s.re()) * amount(Fault::PrintedDerivative, 3e-55),
            Fault::Kink => p += abs(i.s) * length * amount(Fault::Kink, 1e-12),
            Fault::Corner if i.s.re() > 0.0 => p += abs(i.s - 3.0) * length * amount(Fault::Corner, 1.0),
            Fault::BesideKink if i.v.x.re() == PLANTED.get().1 => p *= rounded::<D>(1e4),
            Fault::Overflow => p = p * 1e290 / 1e290,
            Fault::Underflow => p = p * 1e-290 / 1e-290,
            Fault::NanValue => {
                // 0/0, where 53 bits do not have it.
                let lost = more::<D>(1e-20) - 1.0;
                p *= lost * lost.recip();
            }
            Fault::NanBeside if beside(i.s) != 0.0 => p *= f64::NAN,
            _ => {}
        }
        Outputs { p }
    }

    fn jacobian<D: Scalar>(i: &Inputs<D>) -> Jacobian<Self, D> {
        let components = [i.v.x, i.v.y, i.v.z];
        let length = norm(components);
        let own = more::<D>(amount(Fault::ClosedForm, 2e-60))
            * more::<D>(amount(Fault::PrintedDerivative, 3e-55))
            * rounded::<D>(amount(Fault::Jacobian, 64.0));
        let kink = amount(Fault::Kink, 1e-12);
        let factor = factor(i, length);
        let corner = if i.s > 0.0 { amount(Fault::Corner, 1.0) } else { 0.0 };
        let by_length = (i.s + abs(i.s) * kink + abs(i.s - 3.0) * corner) * factor;
        let nothing =
            if PLANTED.get().0 == Fault::OnKink && length == 0.0 { rounded::<D>(100.0) - 1.0 } else { D::zero() };
        let by_s = (sign(i.s) * kink + sign(i.s - 3.0) * corner + 1.0) * length * factor * own + nothing;
        Outputs { p: Inputs { s: by_s, v: Vector3::from(direction(components)) * by_length } }
    }

    fn linearized<D: Scalar>(i: &Inputs<D>) -> ValueAndJacobian<Self, D> {
        let (mut value, mut jacobian) = (Self::eval(i), Self::jacobian(i));
        value.p *= rounded::<D>(amount(Fault::ValueTogether, 96.0));
        jacobian.p.s *= rounded::<D>(amount(Fault::JacobianTogether, 64.0));
        (value, jacobian)
    }
}

impl Proved for Product {
    fn cases() -> Vec<Case<Inputs<f64>>> {
        vec![
            Case::hand("three", "3 √(1² + 2² + 2²)", Inputs { s: 3.0, v: Vector3::new(1.0, 2.0, 2.0) }),
            Case::hard("long", "", Inputs { s: -0.5, v: Vector3::new(1e8, -2e8, 2e8) }),
        ]
    }
    fn kinks() -> Vec<Kink<Self>> {
        let near = Inputs { s: 2.0, v: Vector3::new(0.0, 0.0, 0.0) };
        vec![Kink::<Self>::of_norm(near, |i| [i.v.x, i.v.y, i.v.z])]
    }
    fn laws() -> Vec<Law<Self>> {
        vec![Law::new("twice the number is twice the product", |i: &Inputs<Octuple>| {
            let twice = Self::eval(&Inputs { s: i.s * 2.0, ..*i }).p;
            let nothing = if PLANTED.get().0 == Fault::NanLaw { f64::NAN } else { 1.0 };
            equal(twice * nothing, Self::eval(i).p * 2.0)
        })]
    }
}

/// The audit with so much of a fault.
fn with(fault: Fault, times: f64) -> Audit {
    PLANTED.set((fault, times));
    audit::<Product>(&Options { samples: 24, seed: 3 })
}

/// The claims that did not hold.
fn caught(audit: &Audit) -> Vec<&Claim> {
    audit.claims().filter(|claim| !claim.held()).collect()
}

fn assert_caught(audit: &Audit, expected: &[&str], context: &str) {
    let caught: Vec<_> = caught(audit).iter().map(|claim| claim.claim.as_str()).collect();
    let all =
        caught.len() == expected.len() && caught.iter().zip(expected).all(|(claim, start)| claim.starts_with(start));
    assert!(all && audit.passed() == expected.is_empty(), "{context}: {caught:#?} is not {expected:?}");
}

const VALUE_AT_SIZES: &str = "η of the value in f64, at sizes from 1/1e30 to 1e30";

/// Fault, the claim that catches it, and how exactly its size is known.
const PLANTS: &[(Fault, &str, f64)] = &[
    (Fault::ClosedForm, "closed form = automatic differentiation", 1e-6),
    (Fault::Rule, "automatic differentiation = differences", 1e-3),
    (Fault::RuleAtHardPoint, "automatic differentiation = differences", 1e-3),
    (Fault::Value, "η of the value", 0.05),
    (Fault::Jacobian, "η of the closed-form Jacobian", 0.05),
    (Fault::ValueTogether, "η of the value", 0.05),
    (Fault::JacobianTogether, "η of the closed-form Jacobian", 0.05),
    (Fault::PrintedValue, "printed equation = value", 1e-6),
    (Fault::PrintedDerivative, "derivative of the printed equation", 1e-6),
    (Fault::Homogeneity, "dimensional homogeneity", 1e-6),
    (Fault::Indifference, "frame indifference", 0.01),
    (Fault::OwnLaw, "twice the number is twice the product", 1e-6),
];

#[test]
fn each_claim_catches_its_fault_alone_and_from_its_bound_on() {
    for &(fault, name, exact) in PLANTS {
        for times in [0.9, 3.0, 50.0] {
            let audit = with(fault, times);
            let context = format!("{times} times {fault:?}");
            // What rounding does it does at any size.
            let claims = 1 + usize::from(name.starts_with('η'));
            assert_caught(&audit, &[name; 2][..if times > 1.0 { claims } else { 0 }], &context);
            let claim = audit.claims().find(|claim| claim.claim.starts_with(name)).expect("the audit has it");
            // A bound of the differences at random points stands for those at hard ones.
            let bound = if fault == Fault::RuleAtHardPoint { 1e-35 } else { claim.bound };
            let found = claim.worst.as_ref().map_or(0.0, |worst| worst.size) / bound;
            assert!((found - times).abs() <= exact * times, "{context}: {found} times the bound");
        }
    }
}

/// Where there are many random points, differences by one input after another are at the first of them alone.
#[test]
fn a_direction_of_all_inputs_sees_what_single_ones_do() {
    let (samples, seed) = (202, 3);
    let mut sampler = Sampler::new::<Product>(seed);
    let numbers: Vec<_> = (0..samples).map(|_| sampler.inputs::<Product>().s).collect();
    for (at, entry) in [(199, "∂p/∂s"), (200, "p along a direction of all inputs")] {
        PLANTED.set((Fault::RuleAtNumber, numbers[at]));
        let audit = audit::<Product>(&Options { samples, seed });
        assert_caught(&audit, &["automatic differentiation = differences"], entry);
        // Four derivatives at each named point but the one on the kink, and at the first 200 random ones.
        let closely = audit.named_points - 1 + 200;
        let claim = audit.ad_against_differences;
        assert_eq!((claim.checks, claim.failures), (closely * 4 + 2, 1));
        let worst = claim.worst.expect("it was compared");
        assert_eq!((worst.entry.as_str(), &worst.point), (entry, &format!("random {at} of seed {seed}")));
        let size = worst.size / 1e-46;
        assert!((0.1..=1.0).contains(&size), "{entry}: {size} of what was planted");
        assert!(
            worst.expected == worst.found && worst.found != 0.0,
            "they differ where doubles have no digits: {worst:?}"
        );
    }
}

#[test]
fn without_a_fault_every_claim_is_checked_and_holds() {
    let audit = with(Fault::Nothing, 0.0);
    assert!(audit.passed() && audit.no_claim_failed(), "{:#?}", caught(&audit));
    assert_eq!(audit.claims().count(), 14, "a claim is missing");
    assert!(audit.claims().all(|claim| claim.checks > 0 && claim.worst.is_some()), "{audit:#?}");
    // Both cases, five points on and beside the kink, one that was searched for, and the random ones; four derivatives; value
    // and Jacobian alone and together, and so at one of the random points at another size. On the kink there are no differences and
    // no derivative of the equation; laws are for random points.
    assert_eq!((audit.named_points, audit.searched_points, audit.random_points, audit.seed), (8, 1, 24, 3));
    let checks: Vec<_> = audit.claims().take(11).map(|claim| claim.checks).collect();
    assert_eq!(checks, [32 * 4, 31 * 4, 32 * 2, 32 * 4 * 2, 2, 4 * 2, 32, 31 * 4, 24, 24, 24]);
}

/// What jumps is told from the side where the input is smaller to the other.
#[test]
fn the_register_tells_the_sides_in_order() {
    let register = with(Fault::Nothing, 0.0).register.expect("there is a kink");
    let Deviation { entry, point, found, expected, .. } = register.worst.expect("it was looked at");
    assert_eq!((entry.as_str(), point.as_str()), ("∂p/∂v[0]", "kink v_1 = v_2 = v_3 = 0"));
    assert_eq!((expected, found), (-2.0, 2.0));
}

#[test]
fn points_on_a_kink_and_beside_it_are_looked_at() {
    for step in [2e-3, -2e-3, 1e-9, -1e-9] {
        let audit = with(Fault::BesideKink, step);
        assert_caught(&audit, &["η of the value"], &format!("{step}"));
        assert_eq!(audit.eta.failures, 2, "alone and together");
        assert_eq!(audit.eta.worst.unwrap().point, format!("kink v_1 = v_2 = v_3 = 0 {step:+}"));
    }
    let audit = with(Fault::OnKink, 1.0);
    assert_caught(&audit, &["η of the closed-form Jacobian"], "on the kink");
    assert_eq!(audit.eta_jacobian.unwrap().worst.unwrap().point, "kink v_1 = v_2 = v_3 = 0 +0");
}

#[test]
fn a_corner_at_a_named_point_is_found_where_no_graph_tells() {
    let audit = with(Fault::Corner, 0.5);
    assert!(matches!(audit.examination, Some(Examination::NamedPoints { .. })), "{:?}", audit.examination);
    let worst = audit.kinks.worst.as_ref().expect("it was compared");
    assert!(audit.kinks.failures > 0 && !audit.passed());
    assert_eq!((worst.entry.as_str(), worst.point.as_str()), ("∂p/∂s", "three"));
    // Half of the length less below than above.
    assert!((worst.expected - 1.5).abs() < 1e-9 && (worst.found - 4.5).abs() < 1e-9, "{worst:?}");
}

#[test]
fn an_intermediate_overflow_is_caught() {
    assert_caught(&with(Fault::Overflow, 1.0), &["nothing overflows at inputs"], "overflow");
}

#[test]
fn an_intermediate_underflow_is_caught_at_the_sizes_that_are_stated() {
    PLANTED.set((Fault::Underflow, 1.0));
    let audit = audit::<Product>(&Options { samples: 200, seed: 3 });
    assert_caught(&audit, &[VALUE_AT_SIZES], "underflow");
}

#[test]
fn an_invalid_point_is_refused() {
    PLANTED.set((Fault::Nothing, 0.0));
    let refused = audit_at::<Product>(&Inputs { s: f64::NAN, v: Vector3::x() });
    assert_eq!(refused.unwrap_err().to_string(), "s is NaN; allowed is a finite number");
}

/// The slope at s = 0 jumps by twice the part; the equation, which says nothing of it, is off too.
#[test]
fn a_jump_is_demanded_from_its_bound_on() {
    let printed = ["printed equation = value", "derivative of the printed equation"];
    let jumps = [printed.as_slice(), &["where value or derivative jumps"]].concat();
    for (times, expected) in [(0.9, printed.as_slice()), (3.0, &jumps), (50.0, &jumps)] {
        let audit = with(Fault::Kink, times);
        assert_caught(&audit, expected, &format!("{times} times a jump"));
        let worst = audit.kinks.worst.expect("it was compared");
        // On the kink, where candidates of the graph and where sides of comparisons were searched for.
        assert!(["where s = 0", "searched, s < 0: otherwise"].contains(&worst.point.as_str()), "{worst:?}");
        assert_eq!(worst.entry, "∂p/∂s");
        let jump = (worst.found - worst.expected) / (worst.found + worst.expected);
        assert!(
            (jump / (times * 1e-12) - 1.0).abs() < 1e-2,
            "{times}: the sides are those of s < 0 and s > 0: {worst:?}"
        );
    }
}

#[test]
fn what_is_not_a_number_is_never_within_a_bound() {
    let finite = "nothing overflows at inputs";
    let plants: [(Fault, &[&str]); 3] = [
        (Fault::NanValue, &["η of the value", VALUE_AT_SIZES, finite]),
        (Fault::NanBeside, &["automatic differentiation = differences"]),
        (Fault::NanLaw, &["twice the number is twice the product"]),
    ];
    for (fault, claims) in plants {
        let audit = with(fault, 1.0);
        assert_caught(&audit, claims, &format!("{fault:?}"));
        // What was found is kept, also through the file that keeps it.
        let text = serde_json::to_string(&audit).unwrap();
        let read: Audit = serde_json::from_str(&text).unwrap();
        assert_eq!(serde_json::to_string(&read).unwrap(), text);
        assert!(!read.passed());
    }
}

/// What was not looked at is not known to be right.
#[test]
fn a_claim_that_was_never_checked_does_not_hold() {
    let mut audit = with(Fault::Nothing, 0.0);
    let checks = |claim: &mut Claim| (claim.checks, claim.worst) = (0, None);
    let closed = audit.closed_against_ad.as_mut().unwrap();
    checks(closed);
    assert!(!closed.held());
    assert!(audit.no_claim_failed() && !audit.passed());
    assert_eq!(caught(&audit), [audit.closed_against_ad.as_ref().unwrap()]);
    // On the kink itself there is no difference to compare with.
    PLANTED.set((Fault::Nothing, 0.0));
    let on_kink = audit_at::<Product>(&Inputs { s: 2.0, v: Vector3::zeros() }).unwrap();
    assert!(on_kink.no_claim_failed() && !on_kink.passed());
    assert_eq!((on_kink.ad_against_differences.checks, on_kink.laws[0].checks), (0, 0));
}

/// At a single point everything is checked that can be.
#[test]
fn a_fault_is_caught_at_a_single_point() {
    let point = Inputs { s: 3.0, v: Vector3::new(1.0, 2.0, 2.0) };
    for &(fault, name, _) in PLANTS {
        for times in [0.0, 50.0] {
            PLANTED.set((fault, times));
            let audit = audit_at::<Product>(&point).unwrap();
            let failed: Vec<_> = audit.claims().filter(|claim| claim.failures > 0).map(|claim| &claim.claim).collect();
            // A given point may be a hard one, at which less is asked of differences.
            let is_seen = times > 0.0 && fault != Fault::Rule;
            assert_eq!(failed.len(), usize::from(is_seen), "{times} times {fault:?}: {failed:?}");
            assert!(failed.iter().all(|claim| claim.starts_with(name)), "{fault:?}: {failed:?}");
            assert_eq!((audit.named_points, audit.random_points), (1, 0));
        }
    }
}
