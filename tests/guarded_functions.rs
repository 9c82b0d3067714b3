//! The guarded functions: value, first and second derivative for the hard cases, over `f64` and 237 bits; and the results of
//! num-dual without the guard, so that we notice when it is fixed.

use jointproof::number::scalar::{Scalar, abs, asin, atan2, direction, norm, sign};
use jointproof::{Octuple, Single};
use num_dual::{Dual, Dual2, Dual64, DualNum, DualSVec, DualStruct, HyperDual, hessian};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A dual number with derivative 1.
fn seeded<T: Scalar>(re: f64) -> Dual<T> {
    Dual::new(T::from(re), T::one())
}

/// Value, gradient and Hessian of a function of two variables, through nested duals, rounded to `f64`.
fn second_order<T: Scalar>(
    f: impl Fn(Dual<Dual<T>>, Dual<Dual<T>>) -> Dual<Dual<T>>,
    x: [f64; 2],
) -> (f64, [f64; 2], [[f64; 2]; 2]) {
    let part = |k: usize, i: usize, j: usize| {
        let unit = |condition| if condition { T::one() } else { T::zero() };
        Dual::new(Dual::new(T::from(x[k]), unit(k == i)), Dual::new(unit(k == j), T::zero()))
    };
    let at = |i, j| f(part(0, i, j), part(1, i, j));
    let gradient = [0, 1].map(|i| at(i, i).re.eps.re());
    let hessian = [0, 1].map(|i| [0, 1].map(|j| at(i, j).eps.eps.re()));
    (at(0, 0).re.re.re(), gradient, hessian)
}

fn close(found: f64, expected: f64) -> bool {
    found == expected || ((found - expected) / expected).abs() < 4.0 * f64::EPSILON
}

fn assert_norm<T: Scalar>(x: [f64; 2]) {
    let (value, gradient, hessian) = second_order::<T>(|a, b| norm([a, b]), x);
    // By scaling: the unit vector, and (I − n nᵀ)/|x|.
    let scale = x[0].abs().max(x[1].abs());
    let [p, q] = [x[0] / scale, x[1] / scale];
    let length = p.hypot(q);
    let n = [p / length, q / length];
    assert!(close(value, length * scale), "norm of {x:?} is {value:e}");
    for i in 0..2 {
        assert!(close(gradient[i], n[i]), "∂{i} of the norm at {x:?} is {:e}, not {:e}", gradient[i], n[i]);
        for j in 0..2 {
            // (q², −pq; −pq, p²)/l³ has no cancellation.
            let (r, s) = ([q, -p][i], [q, -p][j]);
            let expected = r * s / length / length / length / scale;
            assert!(
                (hessian[i][j] - expected).abs() <= 16.0 * f64::EPSILON / length / scale,
                "∂{i}∂{j} of the norm at {x:?} is {:e}, not {expected:e}",
                hessian[i][j]
            );
        }
    }
}

#[test]
fn norm_is_right_to_second_order_where_squares_leave_the_range() {
    for x in
        [[3.0, 4.0], [1.0, 1e-17], [3e-200, -4e-200], [3e200, 4e200], [1e-154, 1e-154], [-1e150, 1e154], [0.0, 2.5]]
    {
        assert_norm::<f64>(x);
        assert_norm::<Octuple>(x);
    }
}

#[test]
fn norm_at_zero_has_derivative_zero_to_second_order() {
    fn check<T: Scalar>() {
        for zero in [0.0, -0.0] {
            let expected = (0.0, [0.0; 2], [[0.0; 2]; 2]);
            assert_eq!(second_order::<T>(|a, b| norm([a, b]), [zero, 0.0]), expected);
        }
    }
    check::<f64>();
    check::<Octuple>();
    assert_eq!(direction([0.0, -0.0, 0.0]), [0.0; 3]);
}

#[test]
fn norm_of_subnormal_numbers_keeps_its_direction() {
    let [x, y] = direction([3e-310, 4e-310]);
    assert!(close(x, 0.6) && close(y, 0.8), "({x}, {y})");
    assert_eq!(norm([f64::from_bits(1), 0.0]), f64::from_bits(1));
    assert_eq!(norm([f64::MAX, 0.0]), f64::MAX);
}

#[test]
fn norm_of_what_is_not_finite_is_not_finite() {
    assert!(norm([f64::NAN, 1.0]).is_nan());
    assert!(norm([f64::INFINITY, 1.0]).is_infinite());
    assert!(norm([f64::NEG_INFINITY, f64::INFINITY]).is_infinite());
}

#[test]
fn norm_in_single_precision_neither_overflows_nor_underflows() {
    for scale in [1e-30, 1.0, 1e30] {
        let found = norm([3.0 * scale, 4.0 * scale].map(Single::from)).re();
        assert!((found / (5.0 * scale) - 1.0).abs() < 1e-6, "{found:e}");
    }
}

/// Angle and its derivatives at the four axes and between them, at sizes from 1e-150 to 1e150.
#[test]
fn atan2_is_right_to_second_order_everywhere_but_at_the_origin() {
    fn check<T: Scalar>() {
        let angles =
            [(0.0, 1.0, 0.0), (1.0, 1.0, FRAC_PI_4), (1.0, 0.0, FRAC_PI_2), (0.0, -1.0, PI), (-1.0, 0.0, -FRAC_PI_2)];
        for (y, x, angle) in angles {
            for size in [1e-150, 1.0, 1e150] {
                let at = [y * size, x * size];
                let (value, gradient, hessian) = second_order::<T>(atan2, at);
                let square = x * x + y * y;
                assert!(close(value, angle), "atan2 at {at:?} is {value}");
                // ∂θ/∂y = x/r², ∂θ/∂x = −y/r²; ∂²θ/∂y² = −2xy/r⁴ = −∂²θ/∂x², ∂²θ/∂x∂y = (y² − x²)/r⁴.
                assert!(close(gradient[0], x / square / size), "∂y at {at:?} is {}", gradient[0]);
                assert!(close(gradient[1], -y / square / size), "∂x at {at:?} is {}", gradient[1]);
                let bent = -2.0 * x * y / square / square / size / size;
                let mixed = (y * y - x * x) / square / square / size / size;
                for (found, expected) in
                    [(hessian[0][0], bent), (hessian[1][1], -bent), (hessian[0][1], mixed), (hessian[1][0], mixed)]
                {
                    assert!(
                        close(found, expected) || found.abs() < 1e-15 / size / size,
                        "∂∂ at {at:?}: {found:e}, not {expected:e}"
                    );
                }
            }
        }
    }
    check::<f64>();
    check::<Octuple>();
}

#[test]
fn atan2_honours_signed_zeros_as_ieee_does() {
    assert_eq!(atan2(-0.0, -1.0), -PI);
    assert_eq!(atan2(Dual64::from_re(-0.0), Dual64::from_re(-1.0)).re, -PI);
    assert_eq!(atan2(Octuple::from(-0.0), Octuple::from(-1.0)).to_f64(), -PI);
}

#[test]
fn atan2_at_the_origin_has_derivative_zero_and_not_nan() {
    let angle = atan2(seeded::<f64>(0.0), seeded(0.0));
    assert_eq!((angle.re, angle.eps), (0.0, 0.0));
}

#[test]
fn asin_is_right_to_second_order() {
    fn check<T: Scalar>() {
        for sine in [0.3_f64, 0.6, -0.8, 0.999] {
            let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
            let (found, [first, _], [[second, _], _]) = second_order::<T>(|x, _| asin(x), [sine, 0.0]);
            assert!(close(found, sine.asin()) && close(first, cosine.recip()), "{sine}: {found} {first}");
            assert!(close(second, sine / cosine.powi(3)), "{sine}: {second}");
        }
    }
    check::<f64>();
    check::<Octuple>();
}

#[test]
fn abs_has_derivative_zero_at_both_zeros() {
    for zero in [0.0, -0.0] {
        let x = HyperDual::new(zero, 1.0, 1.0, 0.0);
        let y = abs(x);
        assert_eq!((y.re, y.eps1, y.eps2, y.eps1eps2), (0.0, 0.0, 0.0, 0.0));
        assert!(y.re.is_sign_positive());
        assert_eq!(sign(seeded::<Octuple>(zero)), 0.0);
    }
    assert_eq!(abs(seeded::<Octuple>(-2.0)).eps.to_f64(), -1.0);
    assert!(abs(seeded::<f64>(f64::NAN)).re.is_nan());
}

#[test]
fn every_second_order_type_agrees() {
    let f = |x: [HyperDual<f64>; 2]| norm(x) * atan2(x[0], x[1]);
    let g = |x: [Dual2<f64>; 2]| norm(x) * atan2(x[0], x[1]);
    let hyper = f([HyperDual::new(3.0, 1.0, 1.0, 0.0), HyperDual::new(4.0, 0.0, 0.0, 0.0)]);
    let second = g([Dual2::new(3.0, 1.0, 0.0), Dual2::new(4.0, 0.0, 0.0)]);
    let (value, gradient, matrix) =
        hessian(|x| norm([x[0], x[1]]) * atan2(x[0], x[1]), &nalgebra::Vector2::new(3.0, 4.0));
    assert!(close(hyper.re, value) && close(second.re, value));
    assert!(close(hyper.eps1, gradient[0]) && close(second.v1, gradient[0]));
    assert!(close(hyper.eps1eps2, matrix[(0, 0)]) && close(second.v2, matrix[(0, 0)]), "{hyper} {second} {matrix}");
    let vector: DualSVec<f64, 2> = norm([DualSVec::from_re(3.0).derivative(0), DualSVec::from_re(4.0).derivative(1)]);
    assert_eq!(vector.eps.unwrap_generic(nalgebra::Const::<2>, nalgebra::U1), nalgebra::vector![0.6, 0.8]);
}

/// The results of num-dual 0.15 without the guards. A failure here means that upstream has fixed it: then remove the guard.
mod upstream {
    use super::*;
    use num_traits::Signed;

    #[test]
    fn sqrt_of_a_square_at_zero_has_derivative_nan() {
        let x = seeded::<f64>(0.0);
        assert!((x * x).sqrt().eps.is_nan());
    }

    #[test]
    fn atan2_at_ninety_degrees_has_derivative_nan() {
        assert!(DualNum::atan2(&seeded::<f64>(1.0), Dual64::from_re(0.0)).eps.is_nan());
    }

    #[test]
    fn abs_takes_its_branch_from_the_sign_of_zero() {
        assert_eq!(Signed::abs(&seeded::<f64>(0.0)).eps, 1.0);
        assert_eq!(Signed::abs(&seeded::<f64>(-0.0)).eps, -1.0);
    }

    #[test]
    fn equality_looks_at_the_real_part_only() {
        assert_eq!(Dual64::new(1.0, 2.0), Dual64::new(1.0, 3.0));
    }
}
