//! The printed equations are executed, and a wrong token in one is detected.
//!
//! Their agreement with the code, in value and Jacobian, is a claim of the audit.

mod mutations;
mod spellings;

use jointproof::catalog::{CATALOG, find};
use jointproof::connector::slot::{Contact, ContactForce, CrossForces};
use jointproof::formula::proof::{Case, Kink, Proved};
use jointproof::formula::quantity::{self, Domain, Quantity, Unit};
use jointproof::formula::{Component, Formula, Jacobian, Spec};
use jointproof::toolkit::equation::{Claims, Equation, Setting, View};
use jointproof::toolkit::verify::{self, Options};
use jointproof::{Scalar, fields};
use mutations::mutants;
use rayon::prelude::*;
use std::cell::LazyCell;

#[test]
fn every_equation_can_be_executed() {
    for formula in CATALOG {
        let read = Equation::of(&formula.spec(), formula.inputs(), formula.outputs());
        assert!(read.is_ok(), "{}: {}", formula.spec().id, read.unwrap_err());
    }
}

/// Mutants that are the same function, with the reason.
const EQUIVALENT: &[(&str, &str, &str)] = &[
    ("slider.basis", "/ →  at 166", "|n×k| is 1 wherever n×i is 0, since n is a unit vector"),
    ("interaction.damping", "c_0 → h at 92", "the first case has taken −h ≤ η c0 already"),
    ("slider.rows", r"\mathbf{t}_q → \mathbf{g}_{q,um} at 75", "the row of m is t_q"),
    ("element.rotation_vector", "1 → 2 at 312", "ψ is 0, and B a factor of it: the derivative tells them apart"),
    ("element.rotation_vector", "2 → 3 at 313", "as above"),
    ("element.rotation_vector", "1 → 2 at 416", "ψ is 0, and C a factor of its square"),
    ("element.rotation_vector", "6 → 7 at 417", "as above"),
    ("slider.rows_2d", r"\mathbf{t} → \mathbf{g}_{um} at 69", "the row of m is t"),
];

/// Every single-token mutant of every equation is rejected, or gives a different value at some point.
#[test]
fn a_wrong_token_is_found() {
    let (mut tried, mut refused, mut equivalent, mut survivors) = (0, 0, 0, Vec::new());
    for formula in CATALOG {
        let spec = formula.spec();
        // Most are detected at the first point; those that survive a few points are tried at many.
        let few = formula.trial(&Options { samples: 3, seed: 7 });
        let many = LazyCell::new(|| formula.trial(&Options { samples: 200, seed: 7 }));
        for mutant in mutants(spec.latex) {
            tried += 1;
            let read = Equation::in_place_of(&spec, &mutant.latex, formula.inputs(), formula.outputs());
            let Ok(equation) = read else {
                refused += 1;
                continue;
            };
            if few.first_difference(&equation).is_some() || many.first_difference(&equation).is_some() {
                continue;
            }
            let is_known = EQUIVALENT.iter().any(|(id, what, _)| (*id, *what) == (spec.id, mutant.what.as_str()));
            if is_known {
                equivalent += 1;
            } else {
                survivors.push(format!("{} {}: {}", spec.id, mutant.what, mutant.latex));
            }
        }
    }
    println!("{tried} mutants: {refused} cannot be read, {equivalent} are equivalent");
    assert!(tried >= 500, "only {tried} mutants");
    assert_eq!(equivalent, EQUIVALENT.len(), "a mutant is no longer equivalent");
    assert!(survivors.is_empty(), "{} survive:\n{}", survivors.len(), survivors.join("\n"));
}

/// Value and Jacobian of every equation at every case, on both sides of every kink, and at random points.
#[test]
fn every_equation_is_its_formula() {
    CATALOG.par_iter().for_each(|formula| {
        for claim in formula.audit_equation(&Options { samples: 3, seed: 2 }) {
            assert!(claim.held(), "{}: {claim:#?}", formula.spec().id);
        }
    });
}

#[test]
fn an_audit_of_the_equation_alone_compares_it_where_an_audit_does() {
    let (formula, options) = (find("slot.contact_force").unwrap(), Options { samples: 230, seed: 1 });
    let checks = |claims: [&verify::Claim; 2]| claims.map(|claim| claim.checks);
    let (alone, whole) = (formula.audit_equation(&options), formula.audit(&options));
    assert_eq!(checks(alone.each_ref()), checks([&whole.equation, &whole.equation_jacobian]));
}

#[test]
fn what_cannot_be_read_is_named_with_its_place() {
    let formula = find("slot.contact_force").unwrap();
    let error = |latex| {
        let error = Equation::read(latex, &[], &formula.signature()).unwrap_err();
        assert!(error.to_string().contains(&format!("byte {}: ", error.at())), "{error} at {}", error.at());
        error.to_string()
    };
    let mut wrong = Vec::new();
    for (latex, expected) in [
        (r"F_C = \sqrt{f_2^2 + f_4^2}", "byte 20: f_4 is nobody's symbol"),
        (r"F_C = \sqrt{f_2^2 + }", "byte 20: a number, a symbol or a bracket was expected here"),
        (r"F_C = f_2 f_3,\quad x = f_2", "byte 20: x is defined and not needed"),
        (r"F_C = f_2 f_3,\quad F_C = f_2", "byte 20: F_C is defined twice"),
        (r"F_C = a f_2 f_3,\quad a = b,\quad b = a", "a is defined by itself"),
        (r"F_C = \hat{f}_2 + f_3", "byte 6: hat f_2 is nobody's symbol"),
        (r"F_C = \sqrt[3]{f_2}", "byte 11: a square root: others are powers, as in `x^{3/2}`; was expected here"),
        (r"F_C = \sin f_2^2", r"byte 14: this is read in two ways: write `\sin^2 x` or `\sin(x^2)`"),
        (
            r"F_C = f_2^{1/3} + f_3",
            "byte 12: a power is a whole number up to 9, half of one, or the negative of either",
        ),
        (r"F_C = |f_2 + f_3", r"byte 16: the bar that closes this size, `\rvert` or `|`, was expected here"),
        (r"F_C = f_2/f_3 f_2", "byte 14: what follows a slash and its divisor is read in two ways: use a fraction"),
        (r"F_C = f_2 f_3\quad \text{if } f_2 > 0", r"byte 30: an operator, a comma or `\quad` was expected here"),
        (r"F_C = f_2 f_3\quad\text{twice 2}", "byte 18: a remark holds words only, not `2`: mathematics is executed"),
        (r"F_C = f_2 f_3 \pm 1", r"byte 14: `\pm` is not read here: two equations are two calls"),
        (r"F_C = \mathbf{f}\cdot\mathbf{f} f_2 f_3", "f (a vector) is nobody's symbol"),
    ] {
        let found = error(latex);
        if !found.starts_with("the equation of yours, ") || !found.contains(expected) {
            wrong.push(format!("{latex}: {found}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The forms that an entry shows below its equation are the same function, and its derivative.
#[test]
fn what_is_made_from_an_equation_is_its_formula() {
    let options = Options { samples: 5, seed: 3 };
    for formula in CATALOG {
        let signature = formula.signature();
        let (id, view) = (signature.spec.id, View::of(&signature).unwrap().expect("no symbol has two meanings"));
        if let Some(closed) = view.equation(&signature).unwrap() {
            let difference = formula.trial(&options).first_difference(&closed);
            assert!(difference.is_none(), "{id}: {difference:#?}");
        }
        let claim = formula.claims(&view.claims(&signature).unwrap(), &options);
        assert!(claim.held(), "{id}: {claim:#?}");
    }
}

/// The contact force of SLOT with a wrong symbol for an input.
#[derive(Clone, Copy)]
struct WrongSymbol;

/// It should be f_3.
const WRONG: Quantity = Quantity::scalar("f_4", Unit::F, Domain::Real, "a force whose symbol is mistyped");

fields! { struct Forces<T> { f2: T = quantity::F2, f3: T = WRONG } }

impl Formula for WrongSymbol {
    const SPEC: Spec = ContactForce::SPEC;
    type Inputs<T: Component> = Forces<T>;
    type Outputs<T: Component> = Contact<T>;
    fn eval<D: Scalar>(i: &Forces<D>) -> Contact<D> {
        ContactForce::eval(&CrossForces { f2: i.f2, f3: i.f3 })
    }
    fn jacobian<D: Scalar>(i: &Forces<D>) -> Jacobian<Self, D> {
        let fc = ContactForce::jacobian(&CrossForces { f2: i.f2, f3: i.f3 }).fc;
        Contact { fc: Forces { f2: fc.f2, f3: fc.f3 } }
    }
}

impl Proved for WrongSymbol {
    fn cases() -> Vec<Case<Forces<f64>>> {
        vec![Case::hand("3-4-5", "a right triangle", Forces { f2: 3.0, f3: 4.0 })]
    }
    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_norm(Forces { f2: 0.0, f3: 0.0 }, |i| [i.f2, i.f3])]
    }
}

#[test]
fn a_wrong_symbol_fails_the_audit_and_nothing_else_does() {
    let audit = verify::audit::<WrongSymbol>(&Options { samples: 20, seed: 1 });
    assert!(!audit.passed());
    let failed: Vec<_> = audit.claims().filter(|claim| claim.failures > 0).map(|claim| &claim.claim).collect();
    assert_eq!(failed, [&audit.equation.claim]);
    let reason = &audit.equation.worst.as_ref().unwrap().entry;
    assert!(reason.ends_with("f_3 is nobody's symbol"), "{reason}");
}

/// The claims of prose are compared with the code, not with the printed equation.
#[test]
fn claims_of_prose_are_held_or_not() {
    let formula = find("coulomb.return_map").unwrap();
    let of = formula.signature();
    let verdict = |latex: &str, condition: &str| {
        let setting = Setting { of: Some(of), condition: condition.into(), ..Setting::default() };
        let claims = Claims::read(latex, &setting).map_err(|error| error.to_string())?;
        let claim = formula.claims(&claims, &Options { samples: 20, seed: 1 });
        Ok::<_, String>((claim.checks > 0, claim.failures == 0))
    };
    let slips = r"\lvert f^{\mathrm{trial}}\rvert > \mu F_N";
    let right = r"\frac{\partial f}{\partial F_N} = \mu \operatorname{sign} f^{\mathrm{trial}}";
    assert_eq!(verdict(right, slips), Ok((true, true)));
    assert_eq!(verdict(right, ""), Ok((true, false)), "it does not hold where the contact sticks");
    assert_eq!(verdict(&right.replace(r"\mu", "2"), slips), Ok((true, false)));
    assert_eq!(verdict(r"\lvert f\rvert \le \mu F_N", ""), Ok((true, true)));
    assert_eq!(verdict(r"\lvert f\rvert \ge \mu F_N", ""), Ok((true, false)));
    assert_eq!(verdict("f = 0", "F_N < 0"), Ok((false, true)));
    let change = r"\mathrm{d}f = \frac{\partial f}{\partial f^{\mathrm{trial}}}\,\mathrm{d}f^{\mathrm{trial}}";
    assert_eq!(verdict(change, &slips.replace('>', "<")), Ok((true, true)));
    for (latex, expected) in [
        ("a = f", "byte 0: nothing is claimed: all of it defines new symbols"),
        (r"\frac{\partial f}{\partial q} = 1", "byte 0: q is nobody's symbol"),
        ("f = F_N +", "byte 9: a number, a symbol or a bracket was expected here"),
    ] {
        assert_eq!(verdict(latex, ""), Err(expected.into()));
    }
}

#[test]
fn decimals_are_what_they_say() {
    let formula = find("slot.contact_force").unwrap();
    let value = |latex| {
        let equation = Equation::read(latex, &[], &formula.signature()).unwrap();
        equation.values(&[3.0_f64, 5.0], &[])[0]
    };
    assert_eq!(value(r"F_C = 12.375\,f_2 + 0.25\,f_3"), 38.375);
    assert_eq!(value(r"F_C = f_2^2 + 100\,f_3"), 509.0);
}
