use super::*;
use crate::connector::slot::{Contact, ContactForce, CrossForces};
use crate::formula::{Fields, Formula};

fn read(latex: &str, free: &str) -> Claims {
    Claims::read(latex, &Setting { free: free.into(), ..Setting::default() }).expect("it can be read")
}

/// The setting of the contact force √(f2² + f3²).
fn setting() -> Setting {
    let (inputs, outputs) = (CrossForces::<f64>::FIELDS, Contact::<f64>::FIELDS);
    Setting { of: Some(Signature { spec: ContactForce::SPEC, inputs, outputs }), ..Setting::default() }
}

fn why(latex: &str, setting: &Setting) -> String {
    Claims::read(latex, setting).expect_err("it cannot be read").to_string()
}

fn exact(numbers: &[f64]) -> Vec<Octuple> {
    numbers.iter().map(|&x| x.into()).collect()
}

/// Which claims hold for these values of the arbitrary numbers.
fn held(claims: &Claims, free: &[f64]) -> Vec<bool> {
    assert_eq!(claims.free().len(), free.len());
    claims.at(&claims.point(&[], None, &exact(free))).iter().map(|claim| claim.holds).collect()
}

const CHANGE: Free = Free::Signed;
const NUMBER: Free = Free::Positive;

#[test]
fn of_what_may_be_any_that_changes_whose_change_is_written() {
    // b is held fixed.
    let one = read(r"c = a\,b,\quad \mathrm{d}c = b\,\mathrm{d}a", "a, b");
    assert_eq!((one.free(), held(&one, &[2.0, 3.0, -5.0])), (&[NUMBER, NUMBER, CHANGE][..], vec![true]));
    let both = read(r"c = a\,b,\quad \mathrm{d}c = b\,\mathrm{d}a + a\,\mathrm{d}b", "a, b");
    assert_eq!(both.free(), [NUMBER, NUMBER, CHANGE, CHANGE]);
    assert_eq!(held(&both, &[2.0, 3.0, -5.0, 7.0]), [true]);
    // It is also distinguished from others by its subscript.
    let second = read(r"c = a_1 a_2^2,\quad \mathrm{d}c = 2\,a_1 a_2\,\mathrm{d}a_2", "a_1, a_2");
    assert_eq!((second.free(), held(&second, &[2.0, 3.0, -5.0])), (&[NUMBER, NUMBER, CHANGE][..], vec![true]));
    let change = r"\mathrm{d}c = 2\,\mathbf{v}\cdot\mathrm{d}\mathbf{v},\quad c = \mathbf{v}\cdot\mathbf{v}";
    let vector = read(change, r"\mathbf{v}");
    assert_eq!((vector.free(), held(&vector, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0])), (&[CHANGE; 6][..], vec![true]));
}

#[test]
fn vectors_and_changes_that_may_be_any_are_of_either_sign() {
    let claims = read(r"a\,\mathbf{v} = \Delta b\,\mathbf{v}", r"a, \Delta b, \mathbf{v}");
    assert_eq!(claims.free(), [NUMBER, CHANGE, CHANGE, CHANGE, CHANGE]);
    assert_eq!(held(&claims, &[2.0, 2.0, 0.0, -1.0, 5.0]), [true; 3]);
    assert_eq!(held(&claims, &[2.0, 3.0, 0.0, -1.0, 5.0]), [true, false, false]);
}

#[test]
fn a_claim_is_made_of_each_relation_and_number() {
    let claims = read(r"a = b = c,\quad b \ge c", "a, b, c");
    let all = claims.at(&claims.point(&[], None, &exact(&[2.0, 2.0, 3.0])));
    let found: Vec<_> = all.iter().map(|claim| (claim.text, claim.is_equality, claim.holds)).collect();
    assert_eq!(found, [("a = b", true, true), ("b = c", true, false), (r"b \ge c", false, false)]);
    assert_eq!([all[1].left, all[1].right, all[2].right].map(Octuple::to_f64), [2.0, 3.0, 3.0]);
    // A vector has components, and may be compared with 0 as a number or as the zero vector.
    for zero in ["0", r"\mathbf{0}", "(0, 0, 0)"] {
        let claims = read(&format!(r"\mathbf{{v}} = {zero}"), r"\mathbf{v}");
        assert_eq!(held(&claims, &[0.0, 1.0, 0.0]), [true, false, true], "{zero}");
    }
    let dyad = read(r"\mathbf{v}\otimes\mathbf{w} = \mathbf{w}\otimes\mathbf{v}", r"\mathbf{v}, \mathbf{w}");
    assert_eq!(held(&dyad, &[1.0, 2.0, 0.0, 2.0, 4.0, 0.0]), [true; 9]);
    assert_eq!(held(&dyad, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]).iter().filter(|holds| **holds).count(), 7);
    let vectors = Setting { free: r"a, \mathbf{v}, \mathbf{w}".into(), ..Setting::default() };
    for wrong in [
        r"\mathbf{v} = a",
        r"\mathbf{v} < \mathbf{w}",
        r"\mathbf{v} = (a, a)",
        r"\mathbf{v} > 0",
        r"\mathbf{v} > \mathbf{0}",
        r"\mathbf{v}\otimes\mathbf{w} = \mathbf{v}",
        r"\mathbf{v} = 1",
    ] {
        assert!(why(wrong, &vectors).ends_with("the two sides have not the same shape"), "{wrong}");
    }
}

#[test]
fn what_is_new_is_defined_and_else_claimed() {
    assert_eq!(held(&read(r"b = 2\,a = a + a", "a"), &[3.0]), [true]);
    assert_eq!(held(&read(r"b = 2\,a = a + 1", "a"), &[3.0]), [false]);
    // A function, and several symbols at once.
    assert_eq!(held(&read(r"r(g) = g^2,\quad r(a) = a\,a,\quad r(2) = 5", "a"), &[3.0]), [true, false]);
    assert_eq!(held(&read(r"(b, c) = (a, 2\,a),\quad c = b + a,\quad c = b", "a"), &[3.0]), [true, false]);
    // A statement about a known symbol is a claim, and so is a second definition.
    assert_eq!(held(&read(r"a = 3,\quad a = 4", "a"), &[3.0]), [true, false]);
    assert_eq!(held(&read(r"b = a,\quad b = 4", "a"), &[3.0]), [false]);
    // So is a differential, whereas the variation of a symbol that is not given may be defined.
    assert_eq!(held(&read(r"b = 4\,c,\quad \delta b = 5,\quad \delta b = 4", "c"), &[3.0]), [false]);
    assert_eq!(held(&read(r"b = 4\,c,\quad \mathrm{d}b = 5,\quad \mathrm{d}b = 0", "c"), &[3.0]), [false, true]);
    let free = Setting { free: "a".into(), ..Setting::default() };
    // An inequality defines nothing, nor does a symbol alone.
    for undefined in ["b < a", "b = a < 4", "b", "(b, a) = (1, 2)", "r(g, 2) = g"] {
        assert!(Claims::read(undefined, &free).is_err(), "{undefined}");
    }
    assert_eq!(why("b = a", &free), "byte 0: nothing is claimed: all of it defines new symbols");
}

#[test]
fn earlier_displays_define_and_claim_nothing_here() {
    let above = vec![r"b = 2\,a".to_owned(), r"b = 7,\quad c = b + 1".to_owned()];
    let setting = Setting { free: "a".into(), above, ..Setting::default() };
    let claims = Claims::read(r"c = 2\,a + 1", &setting).unwrap();
    assert_eq!(held(&claims, &[3.0]), [true]);
    let words = Setting { free: "a".into(), definitions: r"b = 2\,a".into(), ..Setting::default() };
    assert_eq!(held(&Claims::read("b = a + a", &words).unwrap(), &[3.0]), [true]);
    let wrong = Setting { definitions: "b = ".into(), ..words };
    assert!(why("b = a", &wrong).starts_with("the definition of words, "), "{}", why("b = a", &wrong));
}

#[test]
fn conditions_must_all_hold() {
    let setting = Setting { free: "a, b".into(), condition: r"a > 1,\ b < 2".into(), ..Setting::default() };
    let claims = Claims::read("a = b", &setting).unwrap();
    let count = |a: f64, b: f64| held(&claims, &[a, b]).len();
    assert_eq!([count(3.0, 1.0), count(1.0, 1.0), count(3.0, 2.0), count(0.5, 2.5)], [1, 0, 0, 0]);
    assert_eq!(held(&read("a = b", "a, b"), &[1.0, 5.0]), [false]);
}

#[test]
fn the_code_is_what_an_output_means() {
    let claims = Claims::read(
        r"F_C = a,\quad \frac{\partial F_C}{\partial f_3} = a",
        &Setting { free: "a".into(), ..setting() },
    );
    let claims = claims.unwrap();
    let code = [exact(&[7.0]), exact(&[8.0, 9.0])];
    let point = claims.point(&exact(&[3.0, 4.0]), Some([&code[0], &code[1]]), &exact(&[7.0]));
    let found: Vec<_> = claims.at(&point).iter().map(|claim| (claim.left.to_f64(), claim.holds)).collect();
    assert_eq!((point.len(), found), (2 + 1 + 2 + 1, vec![(7.0, true), (9.0, false)]));
    // If nothing is known of it, its numbers are NaN.
    let point = claims.point(&exact(&[3.0, 4.0]), None, &exact(&[7.0]));
    assert_eq!(point.iter().map(|x| x.is_nan()).collect::<Vec<_>>(), [false, false, true, true, true, false]);
}

#[test]
fn changes_of_inputs_may_be_any() {
    // All inputs vary where a change is written.
    let claims = Claims::read(r"F_C\,\mathrm{d}F_C = f_2\,\mathrm{d}f_2 + f_3\,\mathrm{d}f_3", &setting()).unwrap();
    assert_eq!(claims.free(), [CHANGE, CHANGE]);
    let code = [exact(&[5.0]), exact(&[0.6, 0.8])];
    let point = claims.point(&exact(&[3.0, 4.0]), Some([&code[0], &code[1]]), &exact(&[10.0, 100.0]));
    let claim = &claims.at(&point)[0];
    assert_eq!(claim.right, 430.0);
    assert!((claim.left.to_f64() - 430.0).abs() < 1e-10, "{}", claim.left.to_f64());
    let varied = Claims::read(r"F_C\,\delta F_C = f_2\,\delta f_2 + f_3\,\delta f_3", &setting()).unwrap();
    assert_eq!(varied.free(), [CHANGE, CHANGE]);
    assert!(Claims::read("F_C = f_2", &setting()).unwrap().free().is_empty());
}

#[test]
fn what_an_equation_defines_is_known_unless_it_is_closed() {
    let mut open = setting();
    let of = open.of.as_mut().expect("it is of a formula");
    of.spec = of.spec.equation(r"F_C = \sqrt{g},\quad g = f_2^2 + f_3^2");
    let closed = Setting { is_closed: true, ..open.clone() };
    let claim = r"g = f_2^2 + f_3^2,\quad g = f_2";
    let held = |setting: &Setting| -> Vec<_> {
        let claims = Claims::read(claim, setting).unwrap();
        claims.at(&claims.point(&exact(&[3.0, 4.0]), None, &[])).iter().map(|claim| claim.holds).collect()
    };
    assert_eq!([held(&open), held(&closed)], [vec![true, false], vec![false]]);
    // Definitions in prose take precedence.
    let definitions = "g = f_2".into();
    assert_eq!(held(&Setting { definitions, ..open }), [false, true]);
    let from = vec![("F_C".into(), ContactForce::SPEC)];
    let from = Setting { from, free: "f_2, f_3".into(), ..Setting::default() };
    let claims = Claims::read("F_C = f_2 + f_3", &from).unwrap();
    assert_eq!([[0.0, 2.0], [3.0, 4.0]].map(|free| self::held(&claims, &free)), [[true], [false]]);
}

#[test]
fn numbers_are_put_in_for_inputs() {
    let with = |put: &str| Claims::expression("F_C", &Setting { put: put.into(), ..setting() });
    let inputs = |put: &str| with(put).unwrap().inputs(&exact(&[3.0, 4.0]), &[]);
    assert_eq!(inputs(""), exact(&[3.0, 4.0]));
    assert_eq!(inputs("f_3 = 7"), exact(&[3.0, 7.0]));
    // In terms of the other inputs, too.
    assert_eq!(inputs(r"f_3 = 2\,f_2,\ f_2 = 5"), exact(&[5.0, 6.0]));
    let why = |put: &str| with(put).unwrap_err().to_string();
    assert_eq!(why(r"f_3 = 1,\ f_4 = 2"), "byte 10: f_4 is no input");
    assert_eq!(why("f_2 = (1, 2)"), "byte 0: f_2 has 1 components");
}

#[test]
fn two_forms_of_a_definition_are_compared_even_if_nobody_needs_it() {
    let setting = Setting {
        definitions: r"c = 2\,a = a + a,\quad r(g) = g\,a = a".into(),
        free: "a".into(),
        ..Setting::default()
    };
    let claims = Claims::read("a = a", &setting).unwrap();
    let all = claims.at(&claims.point(&[], None, &exact(&[3.0])));
    let found: Vec<_> =
        all.iter().map(|claim| (claim.text, claim.left.to_f64(), claim.right.to_f64(), claim.is_equality)).collect();
    assert_eq!(found, [("a = a", 3.0, 3.0, true), ("two forms of a definition", 6.0, 6.0, true)]);
}

#[test]
fn the_terms_of_a_claim_are_those_of_both_sides() {
    let claims = read("a - b = c", "a, b, c");
    let point = claims.point(&[], None, &exact(&[3.0, 2.0, 1.0]));
    let claim = &claims.at(&point)[0];
    // The difference is 1.
    let terms = |sizes: [f64; 3]| claims.terms(claim, &point, &exact(&sizes)).to_f64();
    assert_eq!([terms([0.0; 3]), terms([3.0, 2.0, 10.0])], [1.0, 16.0]);
}
