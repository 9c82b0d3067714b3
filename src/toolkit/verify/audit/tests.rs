use super::*;
use crate::connector::slot::{ContactForce, CrossForces, Friction};
use crate::contact::coulomb::ReturnMap;
use crate::contact::slide_line::ClosestLinear;
use crate::fields;
use crate::formula::quantity::{F2, X};
use crate::formula::{Component, Document, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;
use crate::toolkit::verify::Part;

fn at(f2: f64, f3: f64) -> Audit {
    audit_at::<ContactForce>(&CrossForces { f2, f3 }).expect("they are valid")
}

#[test]
fn one_claim_that_fails_is_enough() {
    let mut audit = at(3.0, 4.0);
    assert!(audit.passed() && audit.no_claim_failed());
    audit.eta.failures = 1;
    assert!(!audit.passed() && !audit.no_claim_failed());
    // Laws and differences cannot be checked on the kink.
    let on_kink = at(0.0, 0.0);
    assert!(!on_kink.passed() && on_kink.no_claim_failed());
}

#[test]
fn a_single_point_is_looked_at_by_itself() {
    let audit = at(3.0, 4.0);
    assert_eq!((audit.named_points, audit.searched_points, audit.random_points, audit.seed), (1, 0, 0, 0));
    assert!(
        audit.scaled.is_empty() && audit.finite.is_none() && audit.examination.is_none() && audit.register.is_none()
    );
    assert_eq!(
        (audit.closed_against_ad.unwrap().checks, audit.ad_against_differences.checks, audit.eta.checks),
        (2, 2, 2)
    );
    assert!(audit_at::<ContactForce>(&CrossForces { f2: f64::NAN, f3: 4.0 }).is_err());
}

fields! { struct One<T> { x: T = X } }
fields! { struct Same<T> { f2: T = F2 } }

/// An equation that nobody can read.
#[derive(Clone, Copy)]
struct Unreadable;
impl Formula for Unreadable {
    const SPEC: Spec = Spec::new("planted.unreadable", "Unreadable", Document::new("None").printed(""))
        .equation(r"f_2 = \unknown x")
        .eta(1.0, 1.0);
    type Inputs<T: Component> = One<T>;
    type Outputs<T: Component> = Same<T>;
    fn eval<D: Scalar>(i: &One<D>) -> Same<D> {
        Same { f2: i.x }
    }
    fn jacobian<D: Scalar>(_: &One<D>) -> Jacobian<Self, D> {
        Same { f2: One { x: D::one() } }
    }
}
impl Proved for Unreadable {}

/// A wrong derivative by hand, of which no bound is stated: what is said to be automatic is not compared with itself.
#[derive(Clone, Copy)]
struct Unstated;
impl Formula for Unstated {
    const SPEC: Spec = Spec::new("planted.unstated", "Unstated", Document::new("None").printed("")).eta_of_value(1.0);
    type Inputs<T: Component> = One<T>;
    type Outputs<T: Component> = Same<T>;
    fn eval<D: Scalar>(i: &One<D>) -> Same<D> {
        Same { f2: i.x * i.x }
    }
    fn jacobian<D: Scalar>(i: &One<D>) -> Jacobian<Self, D> {
        Same { f2: One { x: i.x } }
    }
}
impl Proved for Unstated {}

#[test]
fn a_derivative_by_hand_has_its_bound_stated() {
    let closed = |x| audit_at::<Unstated>(&One { x }).expect("it is valid").closed_against_ad;
    let claim = closed(3.0).expect("it is no automatic one");
    assert!(claim.failures > 0 && claim.worst.expect("it says why").entry.contains("written by hand"));
    assert!(closed(0.0).is_none());
}

#[test]
fn that_an_equation_cannot_be_read_is_said_once() {
    let failures = |index| {
        let part = Part::of(
            &Subject::of::<Unreadable>(),
            &Options { samples: 0, seed: 1 },
            Shard::new(index, 2).expect("there is one"),
        );
        let part = serde_json::to_value(part).expect("it is sent so");
        part["audit"]["equation"]["failures"].clone()
    };
    assert_eq!([failures(1), failures(2)], [1, 0]);
    let given = audit_at::<Unreadable>(&One { x: 2.0 }).expect("it is valid");
    assert_eq!(given.equation.failures, 1);
    let [value, _] = audit_equation(&Subject::of::<Unreadable>(), &Options { samples: 1, seed: 1 });
    assert_eq!((value.checks, value.failures), (0, 1));
}

#[test]
fn an_equation_is_compared_at_cases_beside_kinks_and_at_random_points() {
    let subject = Subject::of::<ContactForce>();
    let named = named_points(&subject);
    let smooth = named.iter().filter(|point| point.kink.is_none()).count();
    assert!(smooth < named.len());
    for samples in [0, 3] {
        let [value, jacobian] = audit_equation(&Subject::of::<ContactForce>(), &Options { samples, seed: 1 });
        assert_eq!((value.checks, jacobian.checks), (named.len() + samples, 2 * (smooth + samples)));
        assert_eq!((value.failures, jacobian.failures), (0, 0));
    }
}

/// On a kink there may be two closest points, and the equation has no single value.
#[test]
fn an_equation_is_not_compared_where_it_has_several_values() {
    let subject = Subject::of::<ClosestLinear>();
    let kink = &subject.kinks[0];
    let at =
        |inputs: &[f64]| audit_at::<ClosestLinear>(&crate::formula::typed(inputs)).expect("they are valid").equation;
    assert_eq!((at(&kink.at).checks, at(&kink.at).failures), (0, 0));
    let named = named_points(&subject);
    let smooth = named.iter().find(|point| point.kink.is_none()).expect("there is one");
    let claim = at(&smooth.inputs);
    assert!(claim.held(), "{claim:?}");
    let [value, _] = audit_equation(&Subject::of::<ClosestLinear>(), &Options { samples: 0, seed: 1 });
    assert_eq!(value.checks, claim.checks * named.iter().filter(|point| point.kink.is_none()).count());
}

#[test]
fn points_beside_a_kink_are_on_both_sides_near_and_nearer() {
    let subject = Subject::of::<ReturnMap>();
    let points: Vec<_> = beside_kinks(&subject).collect();
    let forces: Vec<_> = points.iter().map(|(_, inputs)| inputs[0]).collect();
    assert_eq!(forces, [2.0, 2.0 + 2e-3, 2.0 - 2e-3, 2.0 + 1e-9, 2.0 - 1e-9]);
    assert!(points.iter().all(|(_, inputs)| inputs[1..] == [0.5, 4.0]));
    assert!(points[2].0.starts_with("kink ") && points[2].0.ends_with(" -0.002"), "{}", points[2].0);
    let named = named_points(&subject);
    assert!(named.len() == (subject.cases)().len() + 5 && named.iter().all(|point| !point.random));
}

#[test]
fn points_that_are_searched_for_are_named_by_the_side_that_they_take() {
    let subject = Subject::of::<ReturnMap>();
    let sticks = Point::new(&subject, "there".into(), true, vec![1.0, 0.5, 4.0]);
    let found = searched_points(&subject, &[], &[sticks]);
    assert!(!found.is_empty() && found.iter().all(|point| point.label.starts_with("searched, ") && !point.random));
    assert!(found.iter().any(|point| point.label.ends_with(": otherwise")));
}

/// An audit without any checks yet.
fn begun(subject: &Subject) -> Audit {
    let starts = Some(Vec::new());
    audit_points(subject, &Points { named: Vec::new(), searched: 0, random: Vec::new(), before: 0, seed: 1, starts })
}

fn point<'a>(subject: &'a Subject, random: bool, inputs: &[f64]) -> Point<'a> {
    Point::new(subject, "there".into(), random, inputs.to_vec())
}

/// Both modes check the code; differences are with respect to each input or along one direction, except on a kink.
#[test]
fn a_point_is_checked_closely_or_not() {
    let subject = Subject::of::<ContactForce>();
    let names = Names::new(&subject);
    for (f2, closely, differences) in [(3.0, true, 2), (3.0, false, 1), (0.0, true, 0), (0.0, false, 0)] {
        let mut audit = begun(&subject);
        let point = point(&subject, true, &[f2, f2]);
        if closely {
            audit.check_closely(&point, &names, None);
        } else {
            audit.check(&point, &names);
        }
        let [closed, jacobian] = [&audit.closed_against_ad, &audit.eta_jacobian].map(|claim| claim.as_ref().unwrap());
        let counts = [closed, &audit.eta, jacobian, &audit.ad_against_differences];
        assert_eq!(counts.map(|claim| claim.checks), [2, 2, 4, differences], "{f2} {closely}");
        assert!(audit.no_claim_failed());
        if let Some(worst) = audit.ad_against_differences.worst {
            // The longest step has the most digits.
            assert!(worst.size < 1e-51, "{worst:?}");
        }
    }
}

/// Only the first part starts from random points, and from no more than requested.
#[test]
fn kinks_are_searched_from_random_points_by_the_first_part() {
    let mut subject = Subject::of::<ReturnMap>();
    subject.cases = Vec::new;
    subject.kinks.clear();
    let shared = |samples, index| {
        let shard = Shard::new(index, 2).expect("there is one");
        let (audit, comparisons) = audit_share(&subject, &Options { samples, seed: 1 }, shard);
        assert!(!comparisons.is_empty());
        let searched = match audit.examination {
            Some(Examination::Graph { search, .. }) => Some(search.points),
            _ => None,
        };
        (searched, audit.searched_points, audit.named_points, audit.random_points)
    };
    assert_eq!(shared(0, 1), (Some(0), 0, 0, 0));
    let (searched, reached, named, random) = shared(1, 1);
    assert!(searched > Some(0) && reached > 0 && named == reached && random == 1, "{searched:?} {reached}");
    assert_eq!(shared(3, 2), (None, 0, 0, 1));
    // Other parts do not check cases and kinks either.
    let (subject, second) = (Subject::of::<ReturnMap>(), Shard::new(2, 2).expect("there is one"));
    assert_eq!(audit_share(&subject, &Options { samples: 0, seed: 1 }, second).0.named_points, 0);
}

/// Differences are with respect to both inputs, or along one direction.
#[test]
fn the_first_random_points_of_all_parts_are_checked_closely() {
    let subject = Subject::of::<ContactForce>();
    let checks = |before| {
        let random = vec![point(&subject, true, &[3.0, 4.0])];
        let points = Points { named: Vec::new(), searched: 0, random, before, seed: 1, starts: None };
        audit_points(&subject, &points).ad_against_differences.checks
    };
    assert_eq!([CLOSELY_AT - 1, CLOSELY_AT].map(checks), [2, 1]);
}

/// ∂f₁/∂f2 = 1, compared with which f2 = ∂f₁/∂e2a₁ is large.
#[test]
fn an_entry_that_is_not_nothing_is_judged_by_itself() {
    let subject = Subject::of::<crate::connector::slot::ConstraintForce>();
    let point = point(&subject, true, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1e10, 4.0]);
    let failures = |off: f64| {
        let (mut audit, mut exact) = (begun(&subject), Exact::at(&point));
        exact.closed[6] += Octuple::from(off);
        audit.check_closed_form(&point, &Names::new(&subject), &exact);
        let closed = audit.closed_against_ad.unwrap();
        (closed.checks, closed.failures)
    };
    assert_eq!([0.0, 1e-61, 1e-55].map(failures), [(24, 0), (24, 0), (24, 1)]);
}

/// At a relative distance of 1e-21 from the tie, the first step is too long and the second is not.
#[test]
fn differences_are_by_the_first_step_at_random_points_and_by_the_best_at_others() {
    let subject = Subject::of::<ReturnMap>();
    let failures = |random, beside: f64, off: f64| {
        let (mut audit, mut point) = (begun(&subject), point(&subject, random, &[2.0, 0.5, 4.0]));
        point.exact[0] += beside;
        let mut exact = Exact::at(&point);
        exact.ad.iter_mut().for_each(|slope| *slope *= Octuple::from(off) + 1.0);
        audit.check_ad(&point, &Names::new(&subject), &exact);
        (audit.ad_against_differences.checks, audit.ad_against_differences.failures)
    };
    let both = |beside, off| [true, false].map(|random| failures(random, beside, off));
    assert_eq!(both(1.0, 0.0), [(3, 0), (3, 0)]);
    // During slip, it does not depend on the trial force.
    assert_eq!(both(1.0, 1e-40), [(3, 2), (3, 0)]);
    assert_eq!(both(1.0, 1e-30), [(3, 2), (3, 2)]);
    assert_eq!(both(2e-21, 0.0), [(3, 3), (3, 0)]);
    // Every output has its own entries.
    let subject = Subject::of::<crate::connector::slot::ConstraintForce>();
    let (mut audit, point) = (begun(&subject), point(&subject, true, &[0.5, 2.0, 0.25, 0.75, 3.0, 5.0, 7.0, 4.0]));
    audit.check_ad(&point, &Names::new(&subject), &Exact::at(&point));
    assert_eq!((audit.ad_against_differences.checks, audit.ad_against_differences.failures), (24, 0));
}

/// For f = f2 e2a + f3 e3a, the second component is off by 10⁻⁵⁰.
#[test]
fn values_of_an_equation_are_judged_by_their_own_gradients() {
    let subject = Subject::of::<crate::connector::slot::ConstraintForce>();
    let names = Names::new(&subject);
    let point = point(&subject, true, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 3.0, 4.0]);
    let (Some(equation), _) = read_equation(&subject) else { panic!("it can be read") };
    let (mut values, closed) = ((subject.exact_value)(&point.exact), (subject.exact_jacobian)(&point.exact));
    values[1] += Octuple::from(1e-50);
    let mut gradients = vec![Octuple::zero(); 24];
    // The derivative with respect to f2, which is 3.
    gradients[8 + 6] = Octuple::from(1e10);
    let mut claims = [(); 2].map(|()| Claim::new("the equation is the value", EQUATION));
    let bend = |_| Sensitivity::none();
    check_equation(claims.each_mut(), &point, &names, [&values, &closed], || &gradients, bend, &equation);
    let [values, jacobian] = claims;
    assert_eq!((values.checks, values.failures, jacobian.checks, jacobian.failures), (3, 0, 24, 0));
    let worst = values.worst.expect("it was checked");
    assert!((worst.size * 3e60 - 1.0).abs() < 1e-8 && worst.entry.ends_with("[1]"), "{worst:?}");
}

/// Of the sides over several steps those count that differ least; and only if the derivative actually jumps there.
#[test]
fn sides_that_differ_are_looked_at_once_more() {
    let subject = Subject::of::<Friction>();
    let names = Names::new(&subject);
    let checked = |inputs: [f64; 5], entry, scale: f64, sides: &[[f64; 2]]| {
        let (mut audit, point) = (begun(&subject), point(&subject, false, &inputs));
        let before = audit.kinks.checks;
        audit.kinks.worst = None;
        let sides: Vec<_> = sides.iter().map(|sides| sides.map(Octuple::from)).collect();
        audit.check_sides(&point, &names, entry, scale.into(), &sides);
        assert_eq!(audit.kinks.checks, before + 1);
        let worst = audit.kinks.worst.expect("it was checked");
        (worst.size, worst.expected, worst.found, worst.entry)
    };
    // P = |f1| has a corner at f1 = 0, with respect to f1 only.
    let [corner, smooth] = [0.0, 1.0].map(|f1| [f1, 3.0, 4.0, 1.0, 0.25]);
    let of = |entry, scale, sides: &[[f64; 2]]| checked(corner, entry, scale, sides).0;
    assert_eq!(of(0, 4.0, &[[1.0, -3.0]]), 0.5);
    assert_eq!(of(0, 0.0, &[[-1.0, -2.0], [1.0, -3.0]]), 1.0 / 3.0);
    assert_eq!(of(0, 1.0, &[[1.0, -3.0], [-1.0, -2.0]]), 0.25);
    assert_eq!(of(0, 0.0, &[[0.0, 0.0]]), 0.0);
    assert_eq!(of(0, 4.0, &[[1.0, -3.0], [7.0, 7.0]]), 0.0);
    assert_eq!(of(1, 4.0, &[[1.0, -3.0]]), 0.0);
    assert_eq!(checked(smooth, 0, 4.0, &[[1.0, -3.0]]).0, 0.0);
    assert_eq!(checked(smooth, 0, 1e12 - 1.0, &[[0.0, 1.0]]).0, SMOOTH);
    // Of two equally good steps the longer is shown.
    let (_, below, above, entry) = checked(corner, 0, 4.0, &[[1.0, -3.0], [3.0, -1.0]]);
    assert_eq!((below, above, entry.as_str()), (1.0, -3.0, "∂p/∂f1"));
}

/// If the terms cancel, the largest of the field determines the rounding error.
#[test]
fn values_are_rounded_by_their_own_size_or_by_that_of_their_field() {
    let subject = Subject::of::<crate::connector::slot::ConstraintForce>();
    let point = point(&subject, true, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 3.0, 4.0]);
    let rounding = rounding_of_values(&point, &Exact::at(&point));
    // f = f2 e2a + f3 e3a = (0, 3, 4), each with the contributions of both its factors.
    assert_eq!(rounding.iter().map(|size| size.size().to_f64()).collect::<Vec<_>>(), [4.0, 9.0, 12.0]);
}

#[test]
fn laws_are_not_checked_on_kinks() {
    let subject = Subject::of::<ContactForce>();
    let points = [[3.0, 4.0], [0.0, 0.0], [1.0, 2.0]].map(|inputs| point(&subject, true, &inputs));
    let claim = check_law(&subject.laws[0], &points);
    assert_eq!((claim.checks, claim.failures, claim.bound), (4, 0, LAW));
}
