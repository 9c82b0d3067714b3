//! Checks of made-up calculators, without a browser.

use super::*;
use jointproof::catalog::find;
use jointproof::connector::slot;

/// The result of the check if the calculator of a formula shows this for a case.
fn check_case(formula: &'static dyn AnyFormula, case: &str, shown: &Shown) -> Result<Checked> {
    let golden = formula.golden();
    let mut checked = Checked::default();
    let case = golden.cases.iter().find(|known| known.id == case).context("no such case")?;
    let point = components(formula.inputs(), &case.inputs)?;
    One { formula, golden: &golden, checked: &mut checked }.case(case, &point, shown)?;
    Ok(checked)
}

/// The same for f₂ = 3, f₃ = 4, whose value is 5 and whose derivatives are 0.6 and 0.8.
fn of_contact(shown: &Shown) -> Checked {
    check_case(&slot::ContactForce, "running", shown).unwrap()
}

fn numbers(numbers: &[&str]) -> Shown {
    let numbers = numbers.iter().map(|&text| text.to_owned()).collect();
    Shown { refusal: String::new(), numbers, chosen: None, same: false }
}

fn right() -> Shown {
    numbers(&["5", "0.6", "0.8"])
}

fn refusal(words: &str) -> Shown {
    Shown { refusal: words.to_owned(), ..numbers(&[]) }
}

#[test]
fn where_nothing_was_compared_nothing_is_well() {
    let all = || Checked { numbers: 1, chosen: 1, ..Checked::default() };
    assert!(all().is_well());
    assert!(!Checked { numbers: 0, ..all() }.is_well());
    assert!(!Checked { chosen: 0, ..all() }.is_well());
    assert!(!Checked { off: vec!["t.first".into()], ..all() }.is_well());
}

#[test]
fn the_numbers_of_rust_are_well_and_others_are_named() {
    let checked = of_contact(&right());
    assert_eq!((checked.cases, checked.numbers, checked.differ, checked.near), (1, 3, 0, 0));
    assert_eq!((checked.chosen, checked.off), (0, vec![]));
    let off = of_contact(&numbers(&["5", "0.6", "0.75"]));
    assert_eq!((off.numbers, off.differ), (3, 1));
    assert_eq!(off.off[0], "slot.contact_force, case running: ∂fc/∂f3: 7.5e-1, expected 8e-1");
    assert!(off.off[1].starts_with("slot.contact_force, case running: ∂fc/∂f3: η = "), "{:?}", off.off);
    assert_eq!(off.off.len(), 2, "{:?}", off.off);
    let few = of_contact(&numbers(&["5", "0.6"]));
    assert_eq!(few.off, ["slot.contact_force, case running: it shows 2 of 3 numbers"]);
    assert_eq!(few.numbers, 0);
    let error = check_case(&slot::ContactForce, "running", &numbers(&["5", "x", "0.8"])).err().unwrap();
    assert_eq!(error.to_string(), "\"x\" is no number");
}

#[test]
fn a_case_from_the_menu_fills_the_fields_and_gives_the_same() {
    let chosen = |fields: [&str; 2], same| {
        let chosen = Some(fields.map(String::from).to_vec());
        let checked = of_contact(&Shown { chosen, same, ..right() });
        assert_eq!(checked.chosen, 1);
        checked.off
    };
    let off = ["slot.contact_force, case running: chosen from the menu, it shows something else"];
    assert!(chosen(["3", "4.0"], true).is_empty());
    assert_eq!(chosen(["3", "4"], false), off);
    assert_eq!(chosen(["3", "5"], true), off);
    assert_eq!(chosen(["4", "4"], true), off);
    assert_eq!(chosen(["", "4"], true), off);
}

#[test]
fn what_is_valid_may_not_be_refused() {
    let off = of_contact(&refusal("too long")).off;
    assert_eq!(off, ["slot.contact_force, case running: it refuses what is valid: too long"]);
}

#[test]
fn what_is_invalid_is_refused_in_the_words_of_rust() {
    let formula: &'static dyn AnyFormula = &slot::Friction;
    let golden = formula.golden();
    let case = golden.cases.iter().find(|case| case.id == "mu-negative").unwrap();
    let point = components(formula.inputs(), &case.inputs).unwrap();
    let error = formula.value_and_jacobian(&point).unwrap_err();
    let right = check_case(formula, "mu-negative", &refusal(&error.to_string())).unwrap();
    assert_eq!((right.refused, right.together, right.off), (1, 0, vec![]));
    // A condition on a single input is reported for that input.
    for words in [format!("Refused; required is {}", error.required()), String::new()] {
        let wrong = check_case(formula, "mu-negative", &refusal(&words)).unwrap();
        let off = format!("slot.friction, case mu-negative: it says {words:?}, and Rust {:?}", error.to_string());
        assert_eq!((wrong.refused, wrong.together, wrong.off), (0, 0, vec![off]));
    }
}

#[test]
fn what_all_inputs_together_must_be_may_be_said_without_their_values() {
    let formula: &'static dyn AnyFormula = &slot::Stop;
    let golden = formula.golden();
    let case = golden.cases.iter().find(|case| case.error.as_deref() == Some("OutOfOrder")).unwrap();
    let point = components(formula.inputs(), &case.inputs).unwrap();
    let error = formula.value_and_jacobian(&point).unwrap_err();
    let right = check_case(formula, &case.id, &refusal(&format!("Refused; required is {}", error.required()))).unwrap();
    assert_eq!((right.refused, right.together, right.off), (0, 1, vec![]));
    let wrong = check_case(formula, &case.id, &refusal("Refused; required is luck")).unwrap();
    assert_eq!((wrong.together, wrong.off.len()), (0, 1));
}

#[test]
fn every_input_alone_must_be_in_its_domain_and_finite() {
    let golden = <dyn AnyFormula>::golden(&slot::Friction);
    let mut checked = Checked::default();
    let one = One { formula: &slot::Friction, golden: &golden, checked: &mut checked };
    let names: Vec<_> = one.formula.inputs().iter().map(|field| field.name).collect();
    let mu = names.iter().position(|name| *name == "mu").unwrap();
    let point = vec![1.0; names.len()];
    assert!(one.are_allowed(&point));
    for (place, x) in [(mu, -1.0), (0, f64::NAN), (0, f64::INFINITY)] {
        let mut point = point.clone();
        point[place] = x;
        assert!(!one.are_allowed(&point), "{x}");
    }
}

#[test]
fn golden_numbers_stand_in_the_order_of_the_calculator() {
    for id in ["slot.friction", "coulomb.return_map_2d", "slider.basis", "ujoint.cross_direction"] {
        let (formula, mut checked) = (find(id).unwrap(), Checked::default());
        let golden = formula.golden();
        let one = One { formula, golden: &golden, checked: &mut checked };
        let with_all = golden.cases.iter().filter(|case| case.jac.is_some());
        for case in with_all.take(5) {
            let (value, jacobian) =
                formula.value_and_jacobian(&components(formula.inputs(), &case.inputs).unwrap()).unwrap();
            let exact = one.exact(case);
            let known: Vec<_> = exact.iter().map(|known| known.unwrap()).collect();
            assert_eq!(known.len(), value.len() + jacobian.len(), "{id}, {}", case.id);
            for (k, (x, found)) in known.iter().zip(value.iter().chain(&jacobian)).enumerate() {
                assert_eq!(x.2, k < value.len(), "{id}, {}", case.id);
                assert!((x.0 - found).abs() <= 1e-9 * x.1, "{id}, {}: {found}, expected {x:?}", case.id);
            }
        }
        let invalid = golden.cases.iter().find(|case| case.out.is_none()).unwrap();
        assert!(one.exact(invalid).is_empty());
    }
}

#[test]
fn the_backward_error_is_counted_in_units_of_the_last_place_and_never_below_the_smallest_number() {
    let next = 1.0 + f64::EPSILON;
    assert_eq!(
        [eta(next, 1.0, 1.0), eta(1.0, next, 1.0), eta(next, 1.0, 4.0), eta(1.0, 1.0, 1.0)],
        [2.0, 2.0, 0.5, 0.0]
    );
    assert_eq!(eta(3.0 * f64::from_bits(1), 0.0, 0.0), 6.0);
}

#[test]
fn the_largest_share_of_each_bound_is_kept_and_more_than_all_is_off() {
    let mut golden = <dyn AnyFormula>::golden(&slot::ContactForce);
    (golden.eta.value, golden.eta.jacobian) = (0.5, Some(4.0));
    let mut checked = Checked::default();
    let case = golden.cases[0].clone();
    let mut one = One { formula: &slot::ContactForce, golden: &golden, checked: &mut checked };
    let next = 1.0 + f64::EPSILON;
    for (scale, is_value) in [(16.0, true), (4.0, true), (8.0, true), (2.0, false), (1.0, false), (16.0, false)] {
        one.accuracy((&case, 0), next, 1.0, scale, is_value).unwrap();
    }
    assert_eq!((one.checked.eta, one.checked.off.len()), ([1.0, 0.5], 0));
    one.accuracy((&case, 0), next, 1.0, 1.0, true).unwrap();
    one.accuracy((&case, 1), next, 1.0, 0.25, false).unwrap();
    assert_eq!(one.checked.eta, [1.0, 0.5]);
    let off: Vec<_> = one.checked.off.iter().map(|off| off.split_once(": ").unwrap().1.to_owned()).collect();
    let stated = "of the golden number, stated is";
    assert_eq!(off, [format!("fc: η = 2.00 {stated} 0.5"), format!("∂fc/∂f2: η = 8.00 {stated} 4")]);
}

#[test]
fn where_languages_have_their_own_functions_the_last_digits_may_differ() {
    let formula = find("cardan.angles").unwrap();
    let golden = formula.golden();
    let case = golden.cases.iter().find(|case| case.jac.is_some()).unwrap();
    let mut checked = Checked::default();
    One { formula, golden: &golden, checked: &mut checked }.number(case, 0, 1.0 + f64::EPSILON, 1.0).unwrap();
    assert_eq!((checked.numbers, checked.near, checked.differ, checked.off.len()), (1, 1, 0, 0));
    One { formula, golden: &golden, checked: &mut checked }.number(case, 0, 1.5, 1.0).unwrap();
    assert_eq!((checked.numbers, checked.near, checked.differ, checked.off.len()), (2, 1, 1, 1));
    // Square roots are the same in every language.
    let mut checked = Checked::default();
    let (formula, case) = (&slot::ContactForce, &<dyn AnyFormula>::golden(&slot::ContactForce).cases[0]);
    One { formula, golden: &golden, checked: &mut checked }.number(case, 0, 1.0 + f64::EPSILON, 1.0).unwrap();
    assert_eq!((checked.near, checked.differ), (0, 1));
}

#[test]
fn doubles_are_written_in_hexadecimal_digits_as_c_reads_them() {
    for (x, text) in [
        (1.0, "0x1.0000000000000p+0"),
        (-0.1, "-0x1.999999999999ap-4"),
        (0.0, "0x0.0000000000000p-1022"),
        (-0.0, "-0x0.0000000000000p-1022"),
        (f64::from_bits(1), "0x0.0000000000001p-1022"),
        (f64::MIN_POSITIVE, "0x1.0000000000000p-1022"),
        (f64::MAX, "0x1.fffffffffffffp+1023"),
        (f64::NEG_INFINITY, "-inf"),
        (f64::NAN, "NaN"),
    ] {
        assert_eq!(hexadecimal(x), text);
    }
}

#[test]
fn chapters_are_the_pages_of_the_first_folder_in_order() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("source")).unwrap();
    let names = [
        "z.html",
        "y.html",
        "b.html",
        "x.html",
        "a.html",
        "print.html",
        "index.html",
        "a.css",
        "html",
        "source/c.html",
    ];
    for name in names {
        fs::write(folder.path().join(name), "").unwrap();
    }
    let pages = pages(folder.path()).unwrap();
    let found: Vec<_> = pages.iter().map(|page| page.strip_prefix(folder.path()).unwrap().to_str().unwrap()).collect();
    assert_eq!(found, ["a.html", "b.html", "x.html", "y.html", "z.html"]);
}

#[test]
fn calculators_are_found_by_their_formulas() {
    let page = format!(
        "a {MARK} data-formula=\"t.a\"></details> b {MARK} data-formula=\"t.b\"></details> data-formula=\"t.c\""
    );
    assert_eq!(calculators(&page), ["t.a", "t.b"]);
    assert!(calculators("a page").is_empty());
}

#[test]
fn numbers_are_taken_from_nested_lists_and_words() {
    let value = serde_json::json!([[1.5, "NaN"], [["Infinity"], -2]]);
    let found = leaves(&value);
    assert!(found[1].is_nan());
    assert_eq!((found[0], found[2], found[3], found.len()), (1.5, f64::INFINITY, -2.0, 4));
}
