use super::*;
use crate::connector::slider::Eliminate2d;
use crate::connector::slot::{ContactForce, RelativePosition};
use crate::contact::coulomb::ReturnMap;
use crate::formula::quantity::{E1A, E1B, E2A, E2A_PLANE, X};

#[test]
fn triads_are_made_orthonormal_each_by_itself() {
    let field = |quantity| Field::new("field", quantity);
    let mut inputs = exact(&[3.0, 4.0, 0.0, 9.0, 1.0, 2.0, 0.0, 3.0, 4.0, 12.0]);
    make_orthonormal(&[&E1A, &X, &E2A, &E1B].map(field), &mut inputs);
    let expected = [0.6, 0.8, 0.0, 9.0, -0.8, 0.6, 0.0, 3.0 / 13.0, 4.0 / 13.0, 12.0 / 13.0];
    let close = |(x, expected): (&Octuple, f64)| (x.to_f64() - expected).abs() < 1e-15;
    assert!(inputs.iter().zip(expected).all(close), "{inputs:?}");
    // To all digits, and in the plane.
    let product = inputs[0] * inputs[4] + inputs[1] * inputs[5];
    assert!(product.to_f64().abs() < 1e-70, "{product:?}");
    let mut inputs = exact(&[3.0, -4.0, 12.0]);
    make_orthonormal(&[&E2A_PLANE, &X].map(field), &mut inputs);
    assert!(inputs.iter().zip([0.6, -0.8, 12.0]).all(close), "{inputs:?}");
}

/// x = e1a·(xb − xa): the error of a component of a unit vector is relative to 1, that of a number relative to itself.
#[test]
fn sizes_are_of_the_inputs_then_of_values_and_derivatives() {
    let subject = Subject::of::<RelativePosition>();
    let inputs = exact(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, -3.0, 4.0]);
    let [values, jacobian] = [(subject.exact_value)(&inputs), (subject.exact_jacobian)(&inputs)];
    let of = |triads| sizes(&subject, &inputs, &values, &jacobian, triads);
    let [rounded, exact] = [true, false].map(|triads| of(triads).iter().map(|x| x.to_f64()).collect::<Vec<_>>());
    assert_eq!((rounded.len(), exact.len()), (15 + 3 + 45, 15 + 3 + 45));
    assert_eq!(
        (&rounded[..9], &rounded[9..15], &exact[..15]),
        ([1.0; 9].as_slice(), [0.0; 6].as_slice(), [0.0; 15].as_slice())
    );
    assert_eq!(rounded[15..18], [9.0 + 2.0 + 2.0, 9.0 + 3.0 + 3.0, 9.0 + 4.0 + 4.0]);
    assert_eq!(exact[15..18], [2.0 + 2.0 + 2.0, 3.0 + 3.0 + 3.0, 4.0 + 4.0 + 4.0]);
    // ∂x/∂e1a = xb − xa, and ∂x/∂xb = e1a.
    assert_eq!((rounded[18..21].to_vec(), rounded[18 + 12], exact[18 + 12]), (vec![4.0, 6.0, 8.0], 2.0, 2.0));
    assert_eq!((rounded[18 + 13], exact[18 + 13]), (1.0, 0.0));
}

fn setting(of: &Subject, free: &str) -> Setting {
    let of = Signature { spec: of.spec, inputs: of.inputs, outputs: of.outputs };
    Setting { of: Some(of), free: free.into(), ..Setting::default() }
}

const OPTIONS: Options = Options { samples: 3, seed: 1 };

/// The result of checking a claim about the contact force √(f2² + f3²).
fn found(latex: &str, free: &str) -> Claim {
    let subject = Subject::of::<ContactForce>();
    let claims = Claims::read(latex, &setting(&subject, free)).expect("it can be read");
    claims_about(&Subject::of::<ContactForce>(), &claims, &OPTIONS)
}

#[test]
fn a_claim_is_checked_at_every_point_that_is_on_no_kink() {
    let subject = Subject::of::<ContactForce>();
    let points = named_points(&subject).iter().filter(|point| point.kink.is_none()).count() + OPTIONS.samples;
    for (latex, free, size) in
        [(r"F_C^2 = f_2^2 + f_3^2", "", 1e-60), (r"F_C > 0", "", 0.0), (r"a F_C + f_2 = f_2 + F_C a", "a", 1e-60)]
    {
        let claim = found(latex, free);
        assert_eq!((claim.checks, claim.failures, claim.bound), (points, 0, EQUATION), "{latex}");
        assert!(claim.worst.expect("it was checked").size <= size, "{latex}");
    }
    let wrong = found(r"F_C = 3 f_2", "");
    assert!(wrong.checks == points && wrong.failures > points / 2, "{wrong:?}");
    let wrong = found(r"F_C < 0", "");
    let worst = wrong.worst.expect("it was checked");
    // Relative to its size, and to its sensitivity to the inputs.
    assert_eq!((wrong.failures, worst.size), (points, 1.0 / 3.0));
}

/// Drawn values must have the right sign.
#[test]
fn numbers_that_may_be_any_are_drawn() {
    let claims = Claims::read(r"(a+b)^2 = a^2 + 2 a b + b^2", &Setting { free: "a, b".into(), ..Setting::default() });
    let claims = claims.expect("it can be read");
    let right = claims_at_large(&claims, &OPTIONS);
    assert_eq!((right.checks, right.failures), (3, 0));
    let numbers = free(&claims, &mut Sampler::for_formula("prose", 1));
    assert_eq!(numbers.len(), 2);
    assert_ne!(numbers[0], numbers[1]);
    let close = Claims::read("1.000000001 = 1", &Setting::default()).expect("it can be read");
    assert!(claims_at_large(&close, &OPTIONS).worst.is_some_and(|worst| worst.size > 1e-10 && worst.size < 1e-9));
    let wrong = Claims::read("a + 1 = a", &Setting { free: "a".into(), ..Setting::default() }).expect("it can be read");
    let wrong = claims_at_large(&wrong, &Options { samples: 1, seed: 1 });
    let worst = wrong.worst.expect("it was checked");
    assert_eq!((wrong.failures, worst.point.as_str()), (1, "random 0"));
    // Off by 1, relative to both sides and to the terms of the first.
    let a = worst.expected.min(worst.found);
    assert!(worst.size < 1.0 / (2.0 * a + 1.0) && worst.size > 0.1 / (2.0 * a + 1.0), "{worst:?}");
}

/// Triads in doubles are orthonormal to 53 bits only.
#[test]
fn what_holds_of_triads_holds_where_they_are_made_orthonormal() {
    let subject = Subject::of::<RelativePosition>();
    let failures = |triads| {
        let setting = Setting { triads, ..setting(&subject, "") };
        let claims = Claims::read(r"\mathbf{e}_{1a}\cdot\mathbf{e}_{1a} = 1", &setting).expect("it can be read");
        claims_about(&Subject::of::<RelativePosition>(), &claims, &OPTIONS).failures
    };
    assert_eq!(failures(true), 0);
    assert!(failures(false) > 0);
}

/// The result for the kink of the contact force, if its condition is printed like this.
fn printed_as(condition: &str) -> Printed {
    let mut subject = Subject::of::<ContactForce>();
    subject.kinks[0].condition = condition.into();
    kinks_as_printed(&subject).swap_remove(0).1
}

#[test]
fn conditions_of_kinks_are_executed_on_them_beside_them_and_at_cases() {
    let cases = (Subject::of::<ContactForce>().cases)().len();
    let executed = Printed::Executed(cases + 3);
    assert_eq!(kinks_as_printed(&Subject::of::<ContactForce>()), [("f_2 = f_3 = 0".into(), executed.clone())]);
    assert_eq!(printed_as(r"f_2^2 + f_3^2 \le 0"), executed);
    assert_eq!(printed_as(r"\text{no force}"), Printed::InWords);
    let off = |condition: &str| match printed_as(condition) {
        Printed::Off(why) => why,
        other => panic!("{condition}: {other:?}"),
    };
    assert_eq!(off("f_3 = 0"), r#"`f_3 = 0` is so at {"f2":0.002,"f3":0.0}"#);
    assert_eq!(off("f_2 = 1"), r#"`f_2 = 1` is not so at {"f2":0.0,"f3":0.0}"#);
    assert_eq!(off(r"f_2 > -0.001,\ f_2 < 1"), r#"`f_2 > -0.001,\ f_2 < 1` is so at {"f2":0.002,"f3":0.0}"#);
    assert_eq!(off(r"f_2 < 0.001,\ f_2 > -1"), r#"`f_2 < 0.001,\ f_2 > -1` is so at {"f2":-0.002,"f3":0.0}"#);
    assert!(off("f_2 + f_9 = 0").contains("f_9"));
    let [(_, tie)] = &kinks_as_printed(&Subject::of::<ReturnMap>())[..] else { panic!("there is one") };
    assert_eq!(*tie, Printed::Executed((Subject::of::<ReturnMap>().cases)().len() + 3));
}

#[test]
fn a_condition_must_hold_at_just_those_cases_at_which_the_kink_does() {
    let mut subject = Subject::of::<ContactForce>();
    let off = |subject: &Subject| match kinks_as_printed(subject).swap_remove(0) {
        (_, Printed::Off(why)) => why,
        other => panic!("{other:?}"),
    };
    subject.kinks[0].holds = Box::new(|i| i[1] == 0.0);
    assert_eq!(off(&subject), r#"`f_2 = f_3 = 0` is not so at {"f2":-2.0,"f3":0.0}"#);
    subject.kinks[0].holds = Box::new(|_| false);
    subject.kinks[0].condition = r"f_2 (f_2 + 2) = 0,\ f_3 = 0".into();
    assert_eq!(off(&subject), r#"`f_2 (f_2 + 2) = 0,\ f_3 = 0` is so at {"f2":-2.0,"f3":0.0}"#);
}

#[test]
fn a_printed_equality_holds_to_so_many_digits_and_an_order_as_it_is() {
    let subject = Subject::of::<ContactForce>();
    let holds = |condition: &str, off: f64| {
        let claims = Claims::read(condition, &setting(&subject, "")).expect("it can be read");
        is_met(&subject, &claims, &[Octuple::from(1.0) + Octuple::from(off) * 2.0, Octuple::from(0.0)])
    };
    // Relative to the sum of both sides.
    assert_eq!([0.0, EQUATION, 1.01 * EQUATION].map(|off| holds("f_2 = 1", off)), [true, true, false]);
    assert_eq!([-1e-60, 0.0, 1e-60].map(|off| holds("f_2 > 1", off)), [false, false, true]);
    let both = r"f_2 = 1,\ f_3 > -1";
    assert_eq!((holds(both, 0.0), holds(both, 0.5), holds(r"f_2 = 1,\ f_3 > 1", 0.0)), (true, false, false));
}

#[test]
fn terms_are_asked_for_where_two_sides_differ_too_much_alone() {
    let claims = Claims::read("f_2 = 1", &setting(&Subject::of::<ContactForce>(), "")).expect("it can be read");
    let point = [Octuple::from(1.0) + Octuple::from(EQUATION) * 2.0, Octuple::from(0.0)];
    let point = claims.point(&point, None, &[]);
    assert_eq!(share(&claims, &claims.at(&point)[0], &point, || panic!("it is close enough")), EQUATION);
}

/// Kinks are at doubles, in which nothing is rounded, not even triads.
#[test]
fn a_printed_equality_of_triads_is_of_these_as_they_are() {
    let subject = Subject::of::<RelativePosition>();
    let equality = r"\mathbf{e}_{1a}\cdot(\mathbf{x}_b-\mathbf{x}_a) = 0";
    let claims = Claims::read(equality, &setting(&subject, "")).expect("it can be read");
    let holds = |x: f64| {
        let triad = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        is_met(&subject, &claims, &exact(&[&triad[..], &[0.0; 3], &[x, 1.0, 0.0]].concat()))
    };
    assert_eq!([0.0, 1e-60].map(holds), [true, false]);
}

/// The differences of lengths are taken from another formula, and defined in its equation.
#[test]
fn a_condition_may_be_in_symbols_of_equations_that_are_referred_to() {
    let printed = kinks_as_printed(&Subject::of::<Eliminate2d>());
    assert!(printed.iter().any(|(condition, _)| condition == r"\lvert d_1\rvert = \lvert d_2\rvert"));
    assert!(printed.iter().all(|(_, printed)| matches!(printed, Printed::Executed(_))), "{printed:?}");
}

#[test]
fn an_expression_is_the_number_that_it_is() {
    let subject = Subject::of::<ContactForce>();
    let setting = Setting { put: r"f_2 = 3,\ f_3 = 4".into(), ..setting(&subject, "") };
    let expression = Claims::expression("2 F_C", &setting).expect("it can be read");
    assert_eq!(number_of(&Subject::of::<ContactForce>(), &expression), 10.0);
    let sum = Claims::expression("1 + 2", &Setting::default()).expect("it can be read");
    assert_eq!(number_at_large(&sum), 3.0);
}
