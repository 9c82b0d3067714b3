//! The laws that every formula obeys see every unit, points, vectors and matrices; and what laws are stated with.

use jointproof::formula::proof::law::{
    equal, equal_vectors, equal_with, no_work, orthonormal, parallel, residual, vanish,
};
use jointproof::formula::proof::{Equation, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Shape, Unit};
use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
use jointproof::number::scalar::{Scalar, norm};
use jointproof::toolkit::verify::{Claim, Options, Sensitivity, audit, eta, relative};
use jointproof::{Octuple, fields};
use nalgebra::{Matrix3, Vector3};
use std::cell::Cell;

const L: Quantity = Quantity::scalar("l", Unit::L, Domain::Positive, "a length");
const F: Quantity = Quantity::scalar("f", Unit::F, Domain::Positive, "a force");
const T: Quantity = Quantity::scalar("t", Unit::T, Domain::Positive, "a time");
const H: Quantity = Quantity::scalar("h", Unit::TEMPERATURE, Domain::Positive, "a temperature");
const X: Quantity = Quantity::new(r"\mathbf{x}", Shape::Vec3, Unit::L, Domain::Point, "a point");
const V: Quantity = Quantity::new(r"\mathbf{v}", Shape::Vec3, Unit::L, Domain::Vector, "a vector");
const M: Quantity = Quantity::new(r"\mathbf{M}", Shape::Mat3, Unit::L, Domain::Vector, "a matrix");
const Y: Quantity = Quantity::scalar("y", Unit::ONE, Domain::Real, "a ratio");
fields! {
    struct Inputs<S> {
        l: S = L, f: S = F, t: S = T, h: S = H, x: Vector3<S> = X, o: Vector3<S> = X, v: Vector3<S> = V, m: Matrix3<S> = M,
    }
}
fields! { struct Outputs<S> { first: S = Y, y: S = Y } }

thread_local! {
    /// What the ratio is of.
    static OF: Cell<&'static str> = const { Cell::new("") };
}

#[derive(Clone, Copy)]
struct Ratio;

impl Formula for Ratio {
    const SPEC: Spec =
        Spec::new("planted.ratio", "Ratio", Document::new("Ratios").printed("")).equation("y = 1").eta(0.0, 0.0);
    type Inputs<S: Component> = Inputs<S>;
    type Outputs<S: Component> = Outputs<S>;
    fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
        let length = |v: Vector3<D>| norm([v.x, v.y, v.z]);
        let y = match OF.get() {
            "a length" => i.l,
            "a force" => i.f,
            "a time" => i.t,
            "a temperature" => i.h,
            "the distance from the origin" => length(i.x) / i.l,
            "a component of a point" => (i.x.x - i.o.x) / i.l,
            "a component of a vector" => i.v.x / i.l,
            "an entry of a matrix" => i.m[(0, 1)] / i.l,
            "a row of a matrix" => length(Vector3::new(i.m[(0, 0)], i.m[(0, 1)], i.m[(0, 2)])) / i.l,
            _ => (length(i.x - i.o) + length(i.v) + i.m.trace() + (i.m * i.v).dot(&i.v) / (i.l * i.l)) / i.l,
        };
        Outputs { first: D::one(), y }
    }
    fn jacobian<D: Scalar>(_: &Inputs<D>) -> Jacobian<Self, D> {
        let none = Inputs {
            l: D::zero(),
            f: D::zero(),
            t: D::zero(),
            h: D::zero(),
            x: Vector3::zeros(),
            o: Vector3::zeros(),
            v: Vector3::zeros(),
            m: Matrix3::zeros(),
        };
        Outputs { first: none, y: none }
    }
}

impl Proved for Ratio {}

/// Whether homogeneity and frame indifference hold.
fn laws_of(what: &'static str) -> [bool; 2] {
    OF.set(what);
    let audit = audit::<Ratio>(&Options { samples: 4, seed: 1 });
    let laws: Vec<_> = audit.laws.iter().map(Claim::held).collect();
    laws.try_into().expect("there are two laws of every formula")
}

#[test]
fn units_points_vectors_and_matrices_are_all_seen() {
    assert_eq!(laws_of("nothing wrong"), [true, true]);
    for what in ["a length", "a force", "a time", "a temperature"] {
        assert_eq!(laws_of(what), [false, true], "{what}");
    }
    for what in [
        "the distance from the origin",
        "a component of a point",
        "a component of a vector",
        "an entry of a matrix",
        "a row of a matrix",
    ] {
        assert_eq!(laws_of(what), [true, false], "{what}");
    }
}

#[test]
fn entries_are_named_by_output_and_component() {
    OF.set("a component of a vector");
    let audit = audit::<Ratio>(&Options { samples: 1, seed: 1 });
    // The closed form of nothing is wrong: in the second output, by the first component of v and by l.
    let worst = audit.eta_jacobian.unwrap().worst.expect("it was compared");
    assert!(["∂y/∂v[0]", "∂y/∂l"].contains(&worst.entry.as_str()), "{worst:?}");
    let worst = audit.closed_against_ad.unwrap().worst.expect("it was compared");
    assert!(["∂y/∂v[0]", "∂y/∂l"].contains(&worst.entry.as_str()), "{worst:?}");
}

fn number(x: f64) -> Octuple {
    x.into()
}

fn assert_residual(equations: &[Equation], expected: &[f64]) {
    let found: Vec<_> = equations.iter().map(residual).collect();
    let is_near = |(found, expected): (&f64, &f64)| (found - expected).abs() <= 1e-12 * expected;
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(is_near), "{found:?} is not {expected:?}");
}

#[test]
fn residuals_are_relative_to_what_is_compared() {
    let vector = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(number);
    assert_residual(&equal(number(3.0), number(3.0)), &[0.0]);
    assert_residual(&equal(number(0.0), number(0.0)), &[0.0]);
    for (left, right) in [(3.0, 1.0), (1.0, 3.0), (-3.0, -1.0)] {
        assert_residual(&equal(number(left), number(right)), &[0.5]);
        assert_residual(&equal_with(number(left), number(right), number(-6.0)), &[0.2]);
    }
    assert_residual(&equal(number(1.0), number(-1.0)), &[1.0]);
    assert_residual(&vanish([number(0.0), number(-2.0)], number(6.0)), &[0.0, 0.25]);
    assert_residual(
        &equal_vectors(vector(3.0, 0.0, 4.0), vector(3.0, 5.0, 0.0)),
        &[0.0, 5.0, 4.0].map(|x| x / (5.0 + 34.0_f64.sqrt())),
    );
    assert_residual(&no_work(vector(3.0, 4.0, 0.0), vector(0.0, 2.0, 0.0)), &[0.8]);
    assert_residual(&no_work(vector(3.0, 4.0, 0.0), vector(-4.0, 3.0, 7.0)), &[0.0]);
    assert_residual(&parallel(vector(2.0, 0.0, 0.0), vector(0.0, 0.0, -3.0)), &[0.0, 1.0, 0.0]);
    assert_residual(&parallel(vector(1.0, 2.0, 3.0), vector(-2.0, -4.0, -6.0)), &[0.0; 3]);
    let triad = orthonormal([Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 3.0, 0.0), Vector3::new(9.0, 9.0, 9.0)]);
    assert_eq!(triad, [Vector3::x(), Vector3::y(), Vector3::z()]);
}

#[test]
fn errors_are_relative_to_what_rounding_does() {
    let none = Sensitivity::new(&[], &[]);
    let unit = f64::EPSILON / 2.0;
    // |∂y/∂x₁ x₁| + |∂y/∂x₂ x₂| + |y| = 6 + 20 + 4.
    let some = Sensitivity::new(&[2.0, -5.0].map(number), &[-3.0, 4.0].map(number));
    for off in [unit, -unit] {
        assert!((eta(-4.0 * (1.0 + 2.0 * off), number(-4.0), some) - 8.0 / 30.0).abs() < 1e-15);
    }
    assert_eq!(some.plus(number(-4.0)).share_of(number(-15.0)), 0.5);
    assert_eq!((some.share_of(number(0.0)), none.share_of(number(0.0))), (0.0, 0.0));
    assert_eq!([some, none].map(|of| of.share_of(Octuple::NAN)), [f64::INFINITY; 2]);
    // No double is nearer to 0 than half of the smallest one.
    assert_eq!(eta(5e-324, number(0.0), none), 2.0);
    assert_eq!((eta(0.0, number(0.0), none), eta(f64::NAN, number(0.0), none)), (0.0, f64::INFINITY));
    assert_eq!(eta(f64::INFINITY, number(1.0), some), f64::INFINITY);
    for (a, b, expected) in [(1.0, 4.0, 0.75), (4.0, 1.0, 0.75), (-4.0, 1.0, 1.25), (2.0, 2.0, 0.0), (0.0, 0.0, 0.0)] {
        assert_eq!(relative(number(a), number(b)), expected, "{a} {b}");
    }
    assert_eq!(
        (relative(Octuple::NAN, number(1.0)), relative(number(1.0), Octuple::NAN)),
        (f64::INFINITY, f64::INFINITY)
    );
}
