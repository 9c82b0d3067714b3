//! Cardan angles: correct at every angle, and rejected where they do not exist.

#![expect(clippy::float_cmp, reason = "exact results are expected exactly")]

#[path = "../xtask/src/studies/near_right_angle.rs"]
mod near_right_angle;

use jointproof::element::cardan::turns;
use jointproof::element::cardan::{
    Angles, BetaAxes, BetaTwoArgument, CardanAngles, Triads, accurate, accurate_jacobian, between, rotation, turned,
};
use jointproof::element::frame::Triad;
use jointproof::formula::{Fields, Formula, check, value, value_and_jacobian};
use jointproof::toolkit::verify::{eta, exactly};
use jointproof::{Error, Octuple};
use nalgebra::{Matrix3, Rotation3, Vector3};
use near_right_angle::errors_near_right_angle;
use num_traits::Zero;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn axes(of_b: [i32; 3]) -> Triads<f64> {
    let [a, b] = turns::axes(of_b);
    Triads::new(a, b)
}

/// The triad of a is the global axes, that of b is rotated relative to it by these angles.
fn at(alpha: f64, beta: f64, gamma: f64) -> Triads<f64> {
    let a = [Vector3::x(), Vector3::y(), Vector3::z()];
    Triads::new(a, turned(&a, &rotation(alpha, beta, gamma)))
}

#[test]
fn quarter_and_half_turns_have_exact_values_and_derivatives() {
    for (of_b, alpha, gamma) in [
        ([1, 2, 3], 0.0, 0.0),
        ([1, 3, -2], FRAC_PI_2, 0.0),
        ([1, -3, 2], -FRAC_PI_2, 0.0),
        ([1, -2, -3], -PI, 0.0),
        ([2, -1, 3], 0.0, FRAC_PI_2),
        ([-2, 1, 3], 0.0, -FRAC_PI_2),
        ([-1, -2, 3], 0.0, -PI),
        ([-1, 2, -3], -PI, -PI),
    ] {
        let triads = axes(of_b);
        let expected = Angles { alpha, beta: 0.0, gamma };
        let (angles, jac) = value_and_jacobian::<CardanAngles>(&triads).unwrap();
        assert_eq!(angles, expected, "{of_b:?}");
        assert_eq!(accurate(&triads), expected, "{of_b:?}");
        // Spinning b about e1a changes only α, at rate 1.
        let [_, about] = triads.moments(&jac.alpha);
        assert_eq!(about, Vector3::x(), "{of_b:?}");
    }
}

#[test]
fn the_sign_of_zero_does_not_count() {
    let mut triads = axes([1, -2, -3]);
    for zero in [0.0, -0.0] {
        triads.e2a = Vector3::new(zero, 1.0, zero);
        triads.e3b = Vector3::new(zero, zero, -1.0);
        triads.e1a = Vector3::new(1.0, zero, zero);
        let angles = accurate(&triads);
        assert_eq!(angles.alpha.to_bits(), (-PI).to_bits());
        assert_eq!(angles.beta.to_bits(), 0.0_f64.to_bits());
        assert_eq!(angles.gamma.to_bits(), 0.0_f64.to_bits());
    }
}

#[test]
fn gimbal_lock_is_named() {
    for pair in turns::gimbal_locked() {
        let [a, b] = pair.value.map(|[e1, e2, e3]| Triad::new(e1, e2, e3).unwrap());
        let error = between(&a, &b).unwrap_err();
        assert!(matches!(error, Error::GimbalLock { angle: "alpha", .. }), "{error}");
        let error = check::<CardanAngles>(&Triads::from((&a, &b))).unwrap_err();
        assert!(matches!(error, Error::GimbalLock { .. }), "{error}");
        // Only the second angle exists.
        let beta = value::<BetaTwoArgument>(&BetaAxes::from(&Triads::from((&a, &b)))).unwrap().beta;
        assert_eq!(beta.abs(), FRAC_PI_2);
    }
}

#[test]
fn only_gamma_can_be_undefined_in_inputs_that_are_no_rotations() {
    let mut triads = axes([1, 2, 3]);
    triads.e1b = Vector3::z();
    let error = check::<CardanAngles>(&triads).unwrap_err();
    assert_eq!(
        error.to_string(),
        "gamma is undefined, since e1a·e2b = 0 and e1a·e1b = 0 (gimbal lock, beta = ±90°); allowed is at least one that is not 0"
    );
}

#[test]
fn an_arc_sine_beyond_1_is_rejected_even_where_the_scalar_product_rounds_to_1() {
    let mut triads = axes([1, 2, 3]);
    triads.e1a = Vector3::new(1.0, 1.0, 0.0);
    triads.e3b = Vector3::new(1.0, 2.0_f64.powi(-60), 0.5);
    assert_eq!(triads.e1a.dot(&triads.e3b), 1.0);
    assert_eq!(
        value::<CardanAngles>(&triads).unwrap_err().to_string(),
        "|e1a·e3b| is above 1 by 8.673617379884035e-19; allowed is at most 1 (or use the two-argument angle, which has \
         no such limit)"
    );
    // Just as far below 1, value and derivative are correct to an ulp.
    triads.e3b.y *= -1.0;
    let (angles, jac) = value_and_jacobian::<CardanAngles>(&triads).unwrap();
    let exact = exactly::<CardanAngles>(&triads);
    assert_eq!(angles.beta, CardanAngles::eval(&exact).beta.to_f64());
    let expected = CardanAngles::jacobian(&exact).beta.e1a.x.to_f64();
    assert!((jac.beta.e1a.x / expected - 1.0).abs() < 4e-16, "{} {expected}", jac.beta.e1a.x);
}

/// No axis has a component of 0, and the first axis of a is nearest to the third: the largest product is subtracted from 1 last,
/// so that sums are rounded like products.
#[test]
fn near_90_degrees_the_arc_sine_is_that_of_the_components_as_they_are() {
    let a = turned(&[Vector3::z(), Vector3::x(), Vector3::y()], &rotation(0.3, -0.4, 0.5));
    for distance in [0.1, 1e-2, 1e-4, 1e-6] {
        for beta in [FRAC_PI_2 - distance, distance - FRAC_PI_2] {
            let triads = Triads::new(a, turned(&a, &rotation(0.7, beta, -0.2)));
            let exact = exactly::<CardanAngles>(&triads);
            let (angles, jac) = value_and_jacobian::<CardanAngles>(&triads).unwrap();
            let off = (CardanAngles::eval(&exact).beta - angles.beta).to_f64();
            assert!(off.abs() <= 2e-16, "{beta}: {off:e}");
            let slopes = jac.beta.components().into_iter().zip(CardanAngles::jacobian(&exact).beta.components());
            for (slope, exact) in slopes.filter(|(_, exact)| !exact.is_zero()) {
                let off = (exact / slope - 1.0).to_f64();
                assert!(off.abs() <= 1e-15, "{beta}: {off:e}");
            }
        }
    }
}

#[test]
fn a_zero_axis_has_no_second_angle() {
    let mut triads = axes([1, 2, 3]);
    triads.e1a = Vector3::zeros();
    assert_eq!(
        value::<BetaTwoArgument>(&BetaAxes::from(&triads)).unwrap_err().to_string(),
        "beta is undefined, since e1a is perpendicular to e1b, e2b and e3b; allowed is a unit vector and a triad"
    );
}

#[test]
fn at_90_degrees_to_rounding_the_two_argument_form_is_right() {
    let quarter = Octuple::PI / 2.0;
    for (beta, expected) in [(quarter, FRAC_PI_2), (-quarter, -FRAC_PI_2)] {
        let [a, b] = turns::at_angles([Octuple::from(0.3), beta, Octuple::from(-0.7)]);
        let axes = BetaAxes::from(&Triads::new(a, b));
        let (angle, jac) = value_and_jacobian::<BetaTwoArgument>(&axes).unwrap();
        assert!((angle.beta - expected).abs() <= f64::EPSILON, "{}", angle.beta);
        assert!(jac.beta.components().iter().all(|slope| slope.abs() <= 1.0 + f64::EPSILON), "{jac:?}");
    }
}

/// The rounding error of an orthonormal triad, u = 2⁻⁵³, becomes an error of about u/(90° − β) in the arc sine; the two-argument
/// form stays at u. No arithmetic can improve the arc sine: the error is in the components.
#[test]
fn the_arc_sine_loses_half_of_the_digits_near_90_degrees() {
    let u = f64::EPSILON / 2.0;
    let table = errors_near_right_angle(&[1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]);
    for near in &table {
        assert!(near.two_argument < 2.0 * u, "{near:?}");
        assert!(near.arc_sine * near.distance < 3.0 * u, "{near:?}");
        assert!(near.arc_sine * near.distance > 0.2 * u, "{near:?}");
    }
    let [first, .., last] = table[..] else { panic!("eight rows") };
    assert_eq!(first.rejected, 0.0);
    assert!(last.rejected > 0.1 && last.arc_sine > 1e-9, "{last:?}");
}

#[test]
fn accurate_and_documented_angles_have_the_same_derivative_along_rotations() {
    let triads = at(0.3, -1.2, 2.5);
    let (ours, documented) = (accurate_jacobian(&triads), CardanAngles::jacobian(&triads));
    assert_eq!((ours.alpha, ours.gamma), (documented.alpha, documented.gamma));
    let [ours, documented] = [ours.beta, documented.beta].map(|gradient| triads.moments(&gradient));
    for node in 0..2 {
        assert!((ours[node] - documented[node]).norm() < 1e-14);
    }
}

/// The result is a typed error, or consists of numbers only.
fn gives_no_nan(components: &[f64]) -> Result<(), TestCaseError> {
    let triads = Triads::from_slice(components).unwrap();
    if let Ok((angles, jac)) = value_and_jacobian::<CardanAngles>(&triads) {
        prop_assert!(angles.components().iter().all(|angle| angle.is_finite()));
        let entries = jac.components().into_iter().flat_map(|row| row.components());
        prop_assert!(entries.into_iter().all(f64::is_finite), "{jac:?}");
    }
    let axes = BetaAxes::from(&triads);
    if let Ok((_, jac)) = value_and_jacobian::<BetaTwoArgument>(&axes) {
        prop_assert!(jac.beta.components().into_iter().all(f64::is_finite), "{jac:?}");
    }
    Ok(())
}

/// Products of two of these components overflow.
#[test]
fn huge_vectors_that_are_no_triads_give_no_nan() {
    let mut components = [0.0; 18];
    (components[2], components[11], components[15]) = (1.0, 1e160, 1e160);
    gives_no_nan(&components).unwrap();
}

proptest! {
    #[test]
    fn any_angles_come_back(
        alpha in -PI..PI,
        beta in -FRAC_PI_2..FRAC_PI_2,
        gamma in -PI..PI,
    ) {
        let triads = at(alpha, beta, gamma);
        let found = accurate(&triads);
        // Near gimbal lock the effect of rounding errors of the triads on α and γ grows as 1/cos β.
        let conditioned = 1e-15 / beta.cos() + 1e-15;
        let apart = |a: f64, b: f64| ((a - b + PI).rem_euclid(2.0 * PI) - PI).abs();
        prop_assert!(apart(found.alpha, alpha) < conditioned, "{found:?}");
        prop_assert!((found.beta - beta).abs() < 1e-15, "{found:?}");
        prop_assert!(apart(found.gamma, gamma) < conditioned, "{found:?}");
    }

    /// Independent code: nalgebra's Euler angles (roll, pitch, yaw) of a matrix are those of R3(yaw) R2(pitch) R1(roll), so for
    /// the transposed R they are our angles, reversed.
    #[test]
    fn the_angles_are_those_of_nalgebra(alpha in -3.0..3.0, beta in -1.5..1.5, gamma in -3.0..3.0) {
        let triads = at(alpha, beta, gamma);
        let [a, b] = [[triads.e1a, triads.e2a, triads.e3a], [triads.e1b, triads.e2b, triads.e3b]];
        let r = Matrix3::from_fn(|i, j| a[i].dot(&b[j]));
        let (roll, pitch, yaw) = Rotation3::from_matrix_unchecked(r.transpose()).euler_angles();
        let found = value::<CardanAngles>(&triads).unwrap();
        for (ours, theirs) in [(found.alpha, -roll), (found.beta, -pitch), (found.gamma, -yaw)] {
            prop_assert!((ours - theirs).abs() < 1e-14 / beta.cos(), "{ours} {theirs}");
        }
    }

    /// Components of any kind, including zeros and extremes: a typed error, or numbers only.
    #[test]
    fn no_input_gives_nan(components in proptest::collection::vec(
        prop_oneof![Just(0.0), Just(1.0), Just(-1.0), Just(0.5), -1.0..1.0, Just(1e-160), Just(-1e-200), Just(1e160)],
        18,
    )) {
        gives_no_nan(&components)?;
    }

    /// The stated bound, at points that the sampler's rotations do not reach.
    #[test]
    fn the_stated_error_bound_holds_for_any_vectors(components in proptest::collection::vec(-1.0..1.0, 18)) {
        let triads = Triads::from_slice(&components).unwrap();
        prop_assume!(check::<CardanAngles>(&triads).is_ok());
        let exact = exactly::<CardanAngles>(&triads);
        let gradients = CardanAngles::jacobian(&exact).components();
        let inputs = exact.components();
        let values = CardanAngles::eval(&exact).components();
        for ((computed, exact), gradient) in CardanAngles::eval(&triads).components().into_iter().zip(values).zip(gradients) {
            let size = eta(computed, exact, jointproof::toolkit::verify::Sensitivity::new(&gradient.components(), &inputs));
            prop_assert!(size <= CardanAngles::SPEC.eta.value, "η = {size}");
        }
    }
}
