//! Bad input gets a typed error that names the parameter, its value and what is allowed.

use crate::common;
use jointproof::Error;
use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::connector::slot::{Pose, Pose2d, Slot, Slot2d, Stop, StopLengths};
use jointproof::element::frame::{PlaneTriad, Triad};
use jointproof::formula::proof::Flag;
use jointproof::formula::quantity::Domain;
use jointproof::formula::{Field, value, value_and_jacobian};
use jointproof::number::scalar::norm;
use jointproof::toolkit::verify::golden::components;
use nalgebra::{Vector2, Vector3};

fn pose() -> Pose {
    Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) }
}

#[track_caller]
fn assert_message<T: std::fmt::Debug>(result: Result<T, Error>, message: &str) {
    assert_eq!(result.unwrap_err().to_string(), message);
}

#[test]
fn every_invalid_case_is_answered_by_its_error() {
    for formula in CATALOG {
        for case in common::golden(*formula).cases.iter().filter(|case| case.flags.contains(&Flag::Invalid)) {
            let inputs = components(formula.inputs(), &case.inputs).unwrap();
            let error = formula.value(&inputs).unwrap_err();
            let id = formula.spec().id;
            assert_eq!(Some(error.kind()), case.error.as_deref(), "{id} {}", case.id);
            assert!(error.to_string().contains("; allowed "), "{id} {}: {error}", case.id);
            assert_eq!(formula.audit_at(&inputs).unwrap_err().to_string(), error.to_string());
        }
    }
}

#[test]
fn the_wrong_number_of_components_is_an_error() {
    for formula in CATALOG {
        assert_eq!(formula.value(&[]).unwrap_err().kind(), "Components");
        let (inputs, [value, jacobian]) = (valid_inputs(*formula), lengths(*formula).map(|len| vec![0.5; len]));
        for [short_value, short_jacobian] in [[1, 0], [0, 1]] {
            let mut found = (value[short_value..].to_vec(), jacobian[short_jacobian..].to_vec());
            let error = formula.value_and_jacobian_into(&inputs, &mut found.0, &mut found.1).unwrap_err();
            assert_eq!(error.kind(), "Components");
            assert!(found.0.iter().chain(&found.1).all(|&x| x == 0.5), "{} has written", formula.spec().id);
        }
    }
}

/// The number of output components, and that of entries of the Jacobian.
fn lengths(formula: &dyn AnyFormula) -> [usize; 2] {
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let outputs = count(formula.outputs());
    [outputs, outputs * count(formula.inputs())]
}

/// The first valid golden case.
fn valid_inputs(formula: &dyn AnyFormula) -> Vec<f64> {
    let golden = common::golden(formula);
    let case = golden.cases.iter().find(|case| !case.flags.contains(&Flag::Invalid)).unwrap();
    components(formula.inputs(), &case.inputs).unwrap()
}

/// Checked value and Jacobian have the same bits as each computed alone, at every valid golden case.
#[test]
fn what_is_checked_is_what_is_computed() {
    for formula in CATALOG {
        let id = formula.spec().id;
        for case in common::golden(*formula).cases.iter().filter(|case| !case.flags.contains(&Flag::Invalid)) {
            let inputs = components(formula.inputs(), &case.inputs).unwrap();
            let (alone, jacobian) = (formula.value(&inputs), formula.jacobian(&inputs).unwrap());
            match formula.value_and_jacobian(&inputs) {
                Ok((value, beside)) => {
                    assert_eq!(bits(&value), bits(&alone.unwrap()), "{id} {}", case.id);
                    assert_eq!(bits(&beside), bits(&jacobian), "{id} {}", case.id);
                    assert!(value.iter().chain(&beside).all(|x| x.is_finite()), "{id} {}", case.id);
                }
                Err(Error::DerivativeOverflow { .. }) => assert!(jacobian.iter().any(|x| !x.is_finite())),
                Err(error) => assert_eq!(alone.unwrap_err(), error, "{id} {}", case.id),
            }
        }
    }
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|x| x.to_bits()).collect()
}

/// One component alone is bad, or it and all after it: the first bad one is named.
#[test]
fn every_component_that_is_bad_is_named() {
    for formula in CATALOG {
        let valid = valid_inputs(*formula);
        let mut start = 0;
        for field in formula.inputs() {
            for component in 0..field.len() {
                let name = match field.len() {
                    1 => field.name.to_owned(),
                    _ => format!("{}[{component}]", field.name),
                };
                let allowed = field.quantity.domain.allowed();
                for bad in
                    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].into_iter().chain(outside(field.quantity.domain))
                {
                    let mut inputs = valid.clone();
                    inputs[start + component] = bad;
                    assert_refused(*formula, &inputs, &format!("{name} is {bad:?}; allowed is {allowed}"));
                    inputs[start + component + 1..].fill(f64::NAN);
                    assert_refused(*formula, &inputs, &format!("{name} is {bad:?}; allowed is {allowed}"));
                }
            }
            start += field.len();
        }
    }
}

#[track_caller]
fn assert_refused(formula: &dyn AnyFormula, inputs: &[f64], message: &str) {
    let [mut value, mut jacobian] = lengths(formula).map(|len| vec![0.0; len]);
    let id = formula.spec().id;
    assert_eq!(formula.value(inputs).unwrap_err().to_string(), message, "{id}");
    assert_eq!(formula.jacobian(inputs).unwrap_err().to_string(), message, "{id}");
    let error = formula.value_and_jacobian_into(inputs, &mut value, &mut jacobian).unwrap_err();
    assert_eq!(error.to_string(), message, "{id}");
}

/// Finite numbers just outside a domain.
fn outside(domain: Domain) -> Vec<f64> {
    match domain {
        Domain::NonNegative => vec![-5e-324, -1.0],
        Domain::Positive => vec![-0.0, 0.0, -5e-324],
        Domain::Between(low, high) => vec![low, high],
        Domain::Within(low, high) => vec![low.next_down(), high.next_up()],
        Domain::HalfOpen(low, high) => vec![low.next_down(), high],
        _ => Vec::new(),
    }
}

/// Overflow is looked for in results that are known to be infinite: those of the formula without checks.
#[test]
fn outputs_and_derivatives_that_overflow_are_named() {
    let mut found = [0; 2];
    for formula in CATALOG {
        for scale in [1e90, 1e155, 1e200, 1e300] {
            let inputs: Vec<f64> = valid_inputs(*formula).iter().map(|x| x * scale).collect();
            let Ok(jacobian) = formula.jacobian(&inputs) else { continue };
            let id = formula.spec().id;
            match (formula.value(&inputs), formula.value_and_jacobian(&inputs)) {
                (Err(Error::Overflow { name }), beside) => {
                    assert!(formula.outputs().iter().any(|field| field.name == name), "{id} {name}");
                    assert_eq!(beside.unwrap_err(), Error::Overflow { name }, "{id}");
                    found[0] += 1;
                }
                (Ok(value), Err(Error::DerivativeOverflow { name })) => {
                    assert!(value.iter().all(|y| y.is_finite()), "{id}");
                    let at = jacobian.iter().position(|slope| !slope.is_finite()).unwrap();
                    assert_eq!(name, output_at(*formula, at / inputs.len()), "{id}");
                    found[1] += 1;
                }
                (value, beside) => {
                    assert_eq!(value.unwrap(), beside.unwrap().0, "{id}");
                    assert!(jacobian.iter().all(|slope| slope.is_finite()), "{id}");
                }
            }
        }
    }
    assert!(found.iter().all(|&count| count > 10), "{found:?}");
}

/// The output to which this component belongs.
fn output_at(formula: &dyn AnyFormula, component: usize) -> &'static str {
    let names = formula.outputs().iter().flat_map(|field| std::iter::repeat_n(field.name, field.len()));
    names.collect::<Vec<_>>()[component]
}

#[test]
fn the_first_output_that_overflows_is_named() {
    let at = |x: f64, size: f64| StopLengths { x, l1_min: -size, l1_max: size };
    let named = |stop: &StopLengths<f64>| {
        let overflow = value::<Stop>(stop).unwrap_err();
        assert_eq!(value_and_jacobian::<Stop>(stop).unwrap_err(), overflow);
        overflow
    };
    assert!(value_and_jacobian::<Stop>(&at(1e307, 1e308)).is_ok());
    assert_eq!(named(&at(f64::MAX, 1e308)), Error::Overflow { name: "gap_min" });
    assert_eq!(named(&at(-f64::MAX, 1e308)), Error::Overflow { name: "gap_max" });
    let both = StopLengths { x: f64::MAX, l1_min: -f64::MAX, l1_max: -f64::MAX };
    assert!(value::<Stop>(&StopLengths { x: 0.0, ..both }).is_ok());
    assert_eq!(named(&both), Error::Overflow { name: "gap_min" });
}

#[test]
fn triads_must_be_finite_orthonormal_and_right_handed() {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    assert!(Triad::new(x, y, z).is_ok());
    assert_message(Triad::new(x, Vector3::new(0.0, f64::NAN, 0.0), z), "e2[1] is NaN; allowed is a finite number");
    assert_message(Triad::new(x, y, z * f64::INFINITY), "e3[0] is NaN; allowed is a finite number");
    assert_message(Triad::new(x * 2.0, y, z), "e1 has length 2.0; allowed is 1 within 1e-10");
    assert_message(Triad::new(x, x, z), "e1·e2 is 1.0; allowed is 0 within 1e-10");
    assert_message(
        Triad::new(x, y, -z),
        "e3 points against e1 × e2; allowed is a right-handed triad (reverse one vector)",
    );
    assert_message(
        Triad::new(Vector3::repeat(1e300), y, z),
        "e1 has length 1.7320508075688774e300; allowed is 1 within 1e-10",
    );
}

#[test]
fn plane_triads_too() {
    let (x, y) = (Vector2::x(), Vector2::y());
    assert!(PlaneTriad::new(x, y).is_ok());
    assert_message(
        PlaneTriad::new(x, -y),
        "e2 points to the right of e1; allowed is e1 turned left by 90° (reverse one vector)",
    );
    assert_message(PlaneTriad::new(x, y * 0.5), "e2 has length 0.5; allowed is 1 within 1e-10");
    assert_message(PlaneTriad::new(x, Vector2::new(0.6, 0.8)), "e1·e2 is 0.6; allowed is 0 within 1e-10");
}

#[test]
fn slots_name_the_parameter() {
    let slot = Slot::new(&pose()).unwrap();
    assert_message(slot.with_stops(2.0, 1.0), "l1_min = 2.0 is above l1_max = 1.0; allowed is l1_min ≤ l1_max");
    assert_message(slot.with_stops(f64::NEG_INFINITY, 1.0), "l1_min is -inf; allowed is a finite number");
    assert_message(slot.with_friction(-0.1, 0.0), "mu is -0.1; allowed is a finite number ≥ 0");
    assert_message(slot.with_friction(0.1, f64::NAN), "fc_int is NaN; allowed is a finite number");
    assert_message(slot.with_reference_length(f64::INFINITY), "l1_ref is inf; allowed is a finite number");
    assert_message(slot.friction(1.0, f64::NAN, 0.0), "f2 is NaN; allowed is a finite number");
    let far = Pose { xb: Vector3::new(f64::MAX, 0.0, 0.0), xa: Vector3::new(-f64::MAX, 0.0, 0.0), ..pose() };
    assert_message(
        Slot::new(&far),
        "x is too large for a double; allowed are results below 1.8e308 (use units in which the inputs are closer to 1)",
    );
    let lost = Pose { xb: Vector3::new(0.0, f64::NAN, 0.0), ..pose() };
    assert_message(slot.constraint(&lost), "xb[1] is NaN; allowed is a finite number");
}

#[test]
fn plane_slots_too() {
    let pose = Pose2d { triad: PlaneTriad::global(), xa: Vector2::zeros(), xb: Vector2::new(1.0, f64::NAN) };
    assert_message(Slot2d::new(&pose), "xb[1] is NaN; allowed is a finite number");
    let slot = Slot2d::new(&Pose2d { xb: Vector2::x(), ..pose }).unwrap();
    assert_message(slot.with_friction(f64::NAN, 0.0), "mu is NaN; allowed is a finite number ≥ 0");
}

/// Whether two points coincide is mostly decided by a sum of magnitudes; at the limit the length must decide.
#[test]
fn points_are_apart_where_their_distance_is_a_normal_number() {
    let directions = [[1.0, 0.0, 0.0], [0.0, -1.0, 1.0], [1.0, 1.0, -1.0], [0.6, 0.0, 0.8], [1.0, 1e-3, 0.0]];
    let sizes = (0..=600).map(|k| f64::MIN_POSITIVE * (f64::from(k) / 100.0)).chain([1e-300, 1.0, f64::MAX]);
    let mut decided = [0, 0];
    for (direction, size) in sizes.flat_map(|size| directions.map(|direction| (Vector3::from(direction), size))) {
        let x = direction * size;
        let apart = Error::check_apart(("a", Vector3::zeros()), ("b", x)).is_ok();
        assert_eq!(apart, norm(<[f64; 3]>::from(x)) >= f64::MIN_POSITIVE, "{x:?}");
        assert_eq!(apart, Error::check_direction("d", x).is_ok());
        decided[usize::from(apart)] += 1;
    }
    assert!(decided.iter().all(|&count| count > 300), "{decided:?}");
    let nowhere = Vector3::new(1.0, f64::NAN, f64::INFINITY);
    assert!(Error::check_apart(("a", Vector3::zeros()), ("b", nowhere)).is_err());
}
