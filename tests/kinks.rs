//! Kinks are detected: a planted formula fails if its kink is not registered and passes if it is, and a registered kink that does
//! not exist fails too.

use jointproof::catalog::{AnyFormula, CATALOG, KinkEntry};
use jointproof::formula::proof::{Case, Convention, Kink, Proved};
use jointproof::formula::quantity::{F2, F3, FC};
use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
use jointproof::number::scalar::{Scalar, abs, atan2, direction, norm, sign};
use jointproof::toolkit::verify::{Audit, Examination, Options, Printed, audit, kink};
use jointproof::{Error, fields};

fields! { struct Inputs<T> { f2: T = F2, f3: T = F3 } }
fields! { struct Outputs<T> { fc: T = FC } }

/// A value of two numbers, its gradient, and its kinks.
trait Plant: Copy + Send + Sync + 'static {
    fn value<D: Scalar>(f2: D, f3: D) -> D;
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2];
    fn kinks<const REGISTERED: bool>() -> Vec<Kink<Planted<Self, REGISTERED>>>;
    /// Rejected inputs.
    fn is_refused<D: Scalar>(_: &Inputs<D>) -> bool {
        false
    }
}

/// The formula with its kinks registered, or without.
#[derive(Clone, Copy)]
struct Planted<P, const REGISTERED: bool>(P);

impl<P: Plant, const REGISTERED: bool> Formula for Planted<P, REGISTERED> {
    const SPEC: Spec = Spec::new("planted.kink", "Planted kink", Document::SLOT.printed("Friction"))
        .equation(r"F_C = \sqrt{f_2^2 + f_3^2}")
        .eta(2.0, 2.0);
    type Inputs<E: Component> = Inputs<E>;
    type Outputs<E: Component> = Outputs<E>;
    fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
        Outputs { fc: P::value(i.f2, i.f3) }
    }
    fn jacobian<D: Scalar>(i: &Inputs<D>) -> Jacobian<Self, D> {
        let [f2, f3] = P::gradient(i.f2, i.f3);
        Outputs { fc: Inputs { f2, f3 } }
    }
    fn validate<D: Scalar>(i: &Inputs<D>) -> Result<(), Error> {
        if P::is_refused(i) { Error::check_direction("f2", [i.f2, i.f3].into()) } else { Ok(()) }
    }
}

impl<P: Plant, const REGISTERED: bool> Proved for Planted<P, REGISTERED> {
    fn cases() -> Vec<Case<Inputs<f64>>> {
        vec![Case::hand("somewhere", "", Inputs { f2: 3.0, f3: 4.0 })]
    }
    fn invalid_cases() -> Vec<Case<Inputs<f64>>> {
        let zero = Inputs { f2: 0.0, f3: 0.0 };
        if P::is_refused(&zero) { vec![Case::invalid("zero", "", zero)] } else { Vec::new() }
    }
    fn kinks() -> Vec<Kink<Self>> {
        if REGISTERED { P::kinks() } else { Vec::new() }
    }
}

fn audited<P: Plant, const REGISTERED: bool>() -> Audit {
    audit::<Planted<P, REGISTERED>>(&Options { samples: 20, seed: 3 })
}

/// Without the registration the audit fails at this point, with different slopes found and expected; with it, it passes.
fn assert_demanded<P: Plant>(place: &str, is_there: fn(f64, f64) -> bool) {
    let without = audited::<P, false>();
    let worst = without.kinks.worst.as_ref().expect("something was compared");
    assert!(without.kinks.failures > 0 && !without.passed(), "{place}: {without:#?}");
    assert_eq!((without.formula.as_str(), worst.point.as_str()), ("planted.kink", place));
    let [f2, f3] = ["f2", "f3"].map(|name| worst.inputs[name].as_f64().expect("a number"));
    assert!(is_there(f2, f3), "{place}: {worst:?}");
    assert_ne!(worst.found, worst.expected, "{place}: {worst:?}");
    let with = audited::<P, true>();
    assert!(with.kinks.held(), "{place}: {:#?}", with.kinks);
    let Some(Examination::Graph { search, .. }) = &with.examination else { panic!("it is recorded") };
    assert!(!search.found.is_empty(), "{place}: {search:?}");
    assert!(
        with.register.as_ref().is_some_and(jointproof::toolkit::verify::Claim::held),
        "{place}: {:#?}",
        with.register
    );
}

const AT: Inputs<f64> = Inputs { f2: 3.0, f3: 4.0 };
const BY_F2: Inputs<f64> = Inputs { f2: 1.0, f3: 0.0 };

/// √(f2² + f3²), whose guarded length is 0 at the apex, where central differences are 0 too.
#[derive(Clone, Copy)]
struct Apex;
impl Plant for Apex {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        norm([f2, f3])
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        direction([f2, f3])
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::of_norm(AT, |i| [i.f2, i.f3])]
    }
}

/// |f2 − f3|.
#[derive(Clone, Copy)]
struct Difference;
impl Plant for Difference {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        abs(f2 - f3)
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        [sign(f2 - f3), -sign(f2 - f3)]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::subgradient("f_2 = f_3", |i| i.f2 == i.f3, Inputs { f2: 4.0, ..AT }, BY_F2)]
    }
}

/// max(f2, 0) + f3².
#[derive(Clone, Copy)]
struct Ramp;
impl Plant for Ramp {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        (if f2 > 0.0 { f2 } else { D::zero() }) + f3 * f3
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        [if f2 > 0.0 { D::one() } else { D::zero() }, f3 * 2.0]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::switched_off(AT, |i| [i.f2])]
    }
}

/// A slope that becomes steeper by a thousandth beyond f2 f3 = 3/2.
#[derive(Clone, Copy)]
struct Threshold;
impl Threshold {
    const STEEPER: f64 = 0.001;
    fn beyond<D: Scalar>(f2: D, f3: D) -> D {
        f2 * f3 - 1.5
    }
}
impl Plant for Threshold {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        let beyond = Self::beyond(f2, f3);
        if beyond > 0.0 { beyond * Self::STEEPER + beyond } else { beyond }
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        let slope = if Self::beyond(f2, f3) > 0.0 { 1.0 + Self::STEEPER } else { 1.0 };
        [f3 * slope, f2 * slope]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::switch(
            r"f_2 f_3 = \tfrac32",
            |i| i.f2 * i.f3 == 1.5,
            Inputs { f2: 0.375, f3: 4.0 },
            BY_F2,
        )]
    }
}

/// The angle of the point (f3, f2), which jumps by a full turn; the origin is rejected.
#[derive(Clone, Copy)]
struct Angle;
impl Plant for Angle {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        atan2(f2, f3)
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        let square = f2 * f2 + f3 * f3;
        [f3 / square, -f2 / square]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        let at = Inputs { f2: 0.0, f3: -2.0 };
        vec![Kink::<Planted<Self, R>>::new(
            Convention::Cut,
            r"f_2 = 0,\ f_3 < 0",
            |i| i.f2 == 0.0 && i.f3 < 0.0,
            at,
            BY_F2,
        )]
    }
    fn is_refused<D: Scalar>(i: &Inputs<D>) -> bool {
        i.f2 == 0.0 && i.f3 == 0.0
    }
}

/// f2³/(f2² + f3²): it is linear along every line through the origin, and yet it has no derivative there.
#[derive(Clone, Copy)]
struct Lines;
impl Plant for Lines {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        let square = f2 * f2 + f3 * f3;
        if square == 0.0 { square } else { f2 * f2 * f2 / square }
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        let square = f2 * f2 + f3 * f3;
        if square == 0.0 {
            return [D::zero(); 2];
        }
        let part = f2 / square;
        [part * f2 * (part * f2 * -2.0 + 3.0), part * part * f2 * f3 * -2.0]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::of_norm(AT, |i| [i.f2, i.f3])]
    }
}

/// 3 f2 + f3, computed in two ways selected by a comparison; the registered kink does not exist.
#[derive(Clone, Copy)]
struct Technical;
impl Plant for Technical {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        if f2 * f2 > f3 { f2 * 3.0 + f3 } else { f2 + f2 * 2.0 + f3 }
    }
    fn gradient<D: Scalar>(_: D, _: D) -> [D; 2] {
        [D::from(3.0), D::one()]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        vec![Kink::<Planted<Self, R>>::of_abs(AT, |i| [i.f2])]
    }
}

#[test]
fn a_point_on_a_kink_is_told_with_the_convention_there() {
    let at = |f2, f3| kink::<Planted<Apex, true>>(&Inputs { f2, f3 });
    assert_eq!([at(0.0, 0.0), at(3.0, 0.0)], [Some(Convention::Subgradient), None]);
}

#[test]
fn an_apex_is_demanded() {
    assert_demanded::<Apex>("where |(f2, f3)| = 0", |f2, f3| f2 == 0.0 && f3 == 0.0);
}

#[test]
fn the_absolute_value_of_a_difference_is_demanded() {
    assert_demanded::<Difference>("where f2 − f3 = 0", |f2, f3| f2 == f3);
}

#[test]
fn the_end_of_a_ramp_is_demanded() {
    assert_demanded::<Ramp>("where f2 = 0", |f2, _| f2 == 0.0);
}

#[test]
fn a_step_of_a_thousandth_in_a_slope_is_demanded() {
    assert_demanded::<Threshold>("where f2 f3 − 1.5 = 0", |f2, f3| (f2 * f3 - 1.5).abs() < 1e-15);
}

#[test]
fn the_cut_of_an_angle_is_demanded_and_a_refused_origin_is_not() {
    assert_demanded::<Angle>("where f2 = 0, f3 < 0", |f2, f3| f2 == 0.0 && f3 < 0.0);
    let Some(Examination::Graph { search, .. }) = audited::<Angle, true>().examination else {
        panic!("it is recorded")
    };
    assert_eq!(search.not_reached, ["f2 = f3 = 0"]);
}

#[test]
fn an_origin_is_demanded_through_which_every_line_is_straight() {
    assert_demanded::<Lines>("where f2 f2 + f3 f3 = 0", |f2, f3| f2 == 0.0 && f3 == 0.0);
}

#[test]
fn a_comparison_that_changes_nothing_is_shown_smooth() {
    let audit = audited::<Technical, false>();
    assert!(audit.kinks.held(), "{:#?}", audit.kinks);
    let Some(Examination::Graph { search, coverage }) = audit.examination else { panic!("it is recorded") };
    assert_eq!((search.candidates, search.smooth, search.registered), (1, 1, 0));
    assert_eq!((coverage.comparisons, coverage.asked), (1, 21));
    assert!(coverage.never.is_empty(), "{coverage:?}");
}

#[test]
fn a_register_of_what_does_not_happen_fails() {
    let audit = audited::<Technical, true>();
    let register = audit.register.as_ref().expect("there is a register");
    let worst = register.worst.as_ref().expect("it was compared");
    assert_eq!((register.failures, worst.entry.as_str(), worst.point.as_str()), (1, "nothing jumps", "kink f_2 = 0"));
    assert!(!audit.passed());
}

/// f2² + f3², unless it is negative.
#[derive(Clone, Copy)]
struct Impossible;
impl Plant for Impossible {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        let square = f2 * f2 + f3 * f3;
        if square < 0.0 { D::zero() } else { square }
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        [f2 * 2.0, f3 * 2.0]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        Vec::new()
    }
}

#[test]
fn a_side_that_no_point_takes_is_searched_for_and_named_where_nothing_reaches_it() {
    let searched = |audit: Audit| match audit.examination {
        Some(Examination::Graph { coverage, .. }) => (audit.searched_points, coverage.never),
        _ => panic!("it is recorded"),
    };
    assert_eq!(searched(audited::<Apex, true>()), (0, Vec::new()));
    assert_eq!(searched(audited::<Lines, false>()), (1, Vec::new()));
    assert_eq!(searched(audited::<Impossible, false>()), (0, vec!["f2 f2 + f3 f3 < 0: never so".to_string()]));
}

/// f2 + f3, which has no comparison.
#[derive(Clone, Copy)]
struct Smooth;
impl Plant for Smooth {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        f2 + f3
    }
    fn gradient<D: Scalar>(_: D, _: D) -> [D; 2] {
        [D::one(); 2]
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        Vec::new()
    }
}

#[test]
fn that_there_is_no_place_to_look_at_is_one_check() {
    let audit = audited::<Smooth, false>();
    // In addition, both derivatives at the case.
    assert_eq!((audit.kinks.checks, audit.kinks.failures), (1 + 2, 0));
}

/// max(f2, 0) with a printed condition that holds in a whole strip around its kink, and is correct everywhere else.
#[derive(Clone, Copy)]
struct Strip;
impl Plant for Strip {
    fn value<D: Scalar>(f2: D, f3: D) -> D {
        Ramp::value(f2, f3)
    }
    fn gradient<D: Scalar>(f2: D, f3: D) -> [D; 2] {
        Ramp::gradient(f2, f3)
    }
    fn kinks<const R: bool>() -> Vec<Kink<Planted<Self, R>>> {
        let on_it = Inputs { f2: 0.0, ..AT };
        vec![Kink::<Planted<Self, R>>::subgradient(r"f_2^2 \le 0.0001", |i| i.f2 == 0.0, on_it, BY_F2)]
    }
}

#[test]
fn a_printed_condition_that_holds_beside_its_kink_is_off() {
    let printed = <dyn AnyFormula>::kinks_as_printed(&Planted::<_, true>(Strip));
    let [(_, Printed::Off(why))] = printed.as_slice() else { panic!("{printed:?}") };
    assert_eq!(why, r#"`f_2^2 \le 0.0001` is so at {"f2":0.002,"f3":4.0}"#);
    let printed = <dyn AnyFormula>::kinks_as_printed(&Planted::<_, true>(Difference));
    assert_eq!(printed, [("f_2 = f_3".to_owned(), Printed::Executed(4))]);
}

#[test]
fn every_printed_condition_of_the_catalog_is_that_of_its_register() {
    for formula in CATALOG {
        let (id, kinks, printed) = (formula.spec().id, formula.kinks(), formula.kinks_as_printed());
        assert!(kinks.iter().map(|kink| &kink.condition).eq(printed.iter().map(|(condition, _)| condition)), "{id}");
        assert!(printed.iter().all(|(_, printed)| !matches!(printed, Printed::Off(_))), "{id}: {printed:?}");
    }
}

/// The derivatives on either side of a kink, which the catalog finds by differences, are those of the closed form there. If a
/// value jumps or grows without bound there are none; this occurs only at a switch.
#[test]
fn the_derivatives_beside_every_kink_are_those_of_the_closed_form() {
    for formula in CATALOG {
        for KinkEntry { condition, convention, at, across, one_sided, .. } in formula.kinks() {
            if convention == Convention::Switch && one_sided.iter().flatten().any(|slope| slope.abs() > 1e10) {
                continue;
            }
            for (side, step) in [-1e-7, 1e-7].into_iter().enumerate() {
                let inputs: Vec<_> = at.iter().zip(&across).map(|(at, by)| at + step * by).collect();
                let rows = formula.jacobian(&inputs).unwrap();
                for (row, slopes) in rows.chunks(inputs.len()).zip(&one_sided) {
                    let slope: f64 = row.iter().zip(&across).map(|(derivative, by)| derivative * by).sum();
                    let off = (slope - slopes[side]).abs();
                    assert!(off <= 1e-6 * (1.0 + slope.abs()), "{} {condition} {slope} {slopes:?}", formula.spec().id);
                }
            }
        }
    }
}
