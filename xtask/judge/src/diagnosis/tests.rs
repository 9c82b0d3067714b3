//! Diagnoses of answers at a few points, constructed for the purpose.

mod observed;
mod state;
mod tried;

use super::*;
use crate::question::{Own, Question, of_points};
use crate::verdict::Bounds;
use jointproof::catalog::find;

/// The numbers of an answer, to be altered.
type Numbers = Vec<Option<f64>>;

/// The questions about a formula at some points.
fn asked(id: &str, wanted: Wanted, points: &[&[f64]]) -> Vec<Question> {
    let named = points.iter().enumerate().map(|(k, inputs)| (format!("point {k}"), inputs.to_vec()));
    of_points(find(id).unwrap(), wanted, named.collect(), 1)
}

/// The result of examining the answers to these questions after a mistake.
fn diagnosed<T>(
    (id, wanted): (&'static str, Wanted),
    questions: &[Question],
    mistake: impl Fn(&[f64], &mut Numbers),
    look: impl FnOnce(&Court<'_>, Vec<Answer>) -> T,
) -> T {
    let formula = find(id).unwrap();
    let answer = |question: &Question| {
        let Own::Results(own) = &question.own else { return Answer::Refused(None) };
        let mut numbers = own.iter().copied().map(Some).collect();
        mistake(&question.inputs, &mut numbers);
        Answer::Numbers(numbers)
    };
    let answers = questions.iter().map(answer).collect();
    look(&Court { formula, wanted, bounds: Bounds::of(formula), questions }, answers)
}

/// The causes, one line each.
fn causes(what: (&'static str, Wanted), points: &[&[f64]], mistake: impl Fn(&[f64], &mut Numbers)) -> Vec<String> {
    diagnosed(what, &asked(what.0, what.1, points), mistake, |court, answers| {
        let answers = [answers.clone(), answers];
        diagnose(court, &answers, &court.judge(&answers))
    })
}

/// The single cause of everything.
#[track_caller]
fn cause(what: (&'static str, Wanted), points: &[&[f64]], mistake: impl Fn(&[f64], &mut Numbers)) -> String {
    let causes = causes(what, points, mistake);
    let [cause] = causes.as_slice() else { panic!("{causes:?}") };
    cause.replace(&format!(": this explains all {} points looked at", points.len()), "")
}

fn times(number: &mut Option<f64>, factor: f64) {
    *number = number.map(|x| x * factor);
}

const CONTACT: &[&[f64]] = &[&[3.0, 4.0], &[1.0, 2.0], &[2.0, -5.0]];
const YIELD: &[&[f64]] = &[&[3.0, 0.5, 4.0], &[1.0, 0.25, 3.0], &[2.0, 0.75, 5.0]];
/// Inputs of slot friction with all terms present.
const FRICTION: &[&[f64]] = &[&[-2.0, 3.0, 4.0, 1.0, 0.25], &[3.0, -1.0, 2.0, 0.5, 0.5], &[1.5, 2.0, 7.0, 3.0, 0.75]];
/// The indices of the first derivatives of the outputs fn and phi of a slot.
const FN: usize = 8;
const PHI: usize = 13;

#[test]
fn two_points_may_be_chance_and_three_are_none() {
    let thrice = |_: &[f64], y: &mut Numbers| times(&mut y[0], 3.0);
    let contact = ("slot.contact_force", Wanted::Value);
    assert_eq!(cause(contact, &CONTACT[..1], thrice), "unexplained: it is off at 1 point alone");
    assert_eq!(cause(contact, &CONTACT[..2], thrice), "unexplained: it is off at 2 points alone");
    assert_eq!(cause(contact, CONTACT, thrice), "a factor of 3.000000 too much in fc");
    let normal: &[&[f64]] = &[&[3.0, 1.0], &[5.0, -2.0], &[4.0, 2.5]];
    let turned = |x: &[f64], y: &mut Numbers| y[0] = Some((x[0] - x[1]).abs());
    assert_eq!(cause(("slot.normal_force", Wanted::Value), normal, turned), "the sign of the input fc_int is turned");
    let added = |x: &[f64], y: &mut Numbers| y[0] = Some(x[0] + x[1] * x[2]);
    let said = cause(("coulomb.yield", Wanted::Value), YIELD, added);
    assert_eq!(said, "the sign of mu fn is turned in p − mu fn");
    let index = |_: &[f64], y: &mut Numbers| y[FN + 2] = y[FN + 1];
    let said = cause(("slot.friction", Wanted::Jacobian), FRICTION, index);
    assert_eq!(said, "an index is wrong: ∂fn/∂f3 holds ∂fn/∂f2");
}

#[test]
fn four_indices_may_be_wrong() {
    // Each contains the derivative with respect to the next input.
    let shifted = |count: usize| {
        move |_: &[f64], y: &mut Numbers| {
            let own = y.clone();
            (0..count).for_each(|k| y[PHI + k] = own[if k < 4 { PHI + k + 1 } else { FN + 1 }].map(|x| -x));
        }
    };
    let friction = ("slot.friction", Wanted::Jacobian);
    let said = cause(friction, FRICTION, shifted(4));
    let held = ["∂phi/∂f1 holds −∂phi/∂f2", "∂phi/∂f2 holds −∂phi/∂f3", "∂phi/∂f3 holds −∂phi/∂fc_int"];
    assert_eq!(said, format!("an index is wrong: {}; ∂phi/∂fc_int holds −∂phi/∂mu", held.join("; ")));
    assert_eq!(cause(friction, FRICTION, shifted(5)), "unexplained");
}

#[test]
fn an_index_is_wrong_where_three_points_show_another_number() {
    let friction = ("slot.friction", Wanted::Jacobian);
    let index = |y: &mut Numbers| y[FN + 2] = y[FN + 1];
    // A sign is not an index: no number contains its own opposite.
    let and_sign = |_: &[f64], y: &mut Numbers| {
        index(y);
        times(&mut y[PHI + 4], -1.0);
    };
    assert_eq!(cause(friction, FRICTION, and_sign), "unexplained");
    let and_two = |x: &[f64], y: &mut Numbers| {
        index(y);
        y[PHI + 4] = y[PHI + 3].filter(|_| x[0] != 3.0);
    };
    assert_eq!(cause(friction, FRICTION, and_two), "unexplained");
}

#[test]
fn a_factor_is_told_with_what_it_is_of_in_the_fewest_words() {
    let turned = |places: &'static [usize]| {
        move |_: &[f64], y: &mut Numbers| places.iter().for_each(|&place| times(&mut y[place], -1.0))
    };
    let friction = |points, places| cause(("slot.friction", Wanted::Jacobian), points, turned(places));
    // A row and a column with one non-zero derivative, and with two.
    assert_eq!(friction(FRICTION, &[3]), "the sign is turned of ∂p/∂f1");
    assert_eq!(friction(FRICTION, &[PHI + 4]), "the sign is turned of ∂phi/∂mu");
    assert_eq!(friction(FRICTION, &[FN + 1, PHI + 1]), "the sign is turned of the derivatives by f2");
    let plane: &[&[f64]] = &[&[-2.0, 3.0, 0.0, 1.0, 0.25], &[3.0, -1.0, 0.0, 0.5, 0.5], &[1.0, 2.0, 0.0, 3.0, 0.75]];
    assert_eq!(friction(plane, &[FN + 1, FN + 3]), "the sign is turned of the derivatives of fn");
    // A Jacobian with one non-zero derivative, and with two.
    let sticks: &[&[f64]] = &[&[1.0, 0.5, 4.0], &[-0.5, 0.25, 3.0], &[0.75, 0.75, 5.0]];
    let said = cause(("coulomb.return_map", Wanted::Jacobian), sticks, turned(&[1]));
    assert_eq!(said, "the sign is turned of ∂f/∂f_trial");
    let said = cause(("slot.contact_force", Wanted::Jacobian), CONTACT, turned(&[1, 2]));
    assert_eq!(said, "the sign is turned of the whole Jacobian");
}

#[test]
fn of_a_number_that_never_changes_a_factor_needs_a_name() {
    let by_p = |x: f64| cause(("coulomb.yield", Wanted::Jacobian), YIELD, move |_, y| y[1] = Some(x));
    assert_eq!(by_p(-1.0), "the sign is turned of ∂phi/∂p");
    assert_eq!(by_p(0.0), "left out (always 0): ∂phi/∂p");
    assert_eq!(by_p(1.75), "unexplained");
}

#[test]
fn what_is_not_given_is_not_off() {
    let mistake = |x: &[f64], y: &mut Numbers| {
        times(&mut y[0], 2.0);
        y[2] = y[2].filter(|_| x[0] != 3.0);
    };
    let said = cause(("slot.contact_force", Wanted::Jacobian), CONTACT, mistake);
    assert_eq!(said, "a factor of 2 too much in fc");
}

#[test]
fn what_is_off_at_one_point_does_not_hide_what_is_off_at_all() {
    let mistake = |x: &[f64], y: &mut Numbers| {
        times(&mut y[2], -1.0);
        times(&mut y[0], if x[0] == 3.0 { 1.5 } else { 1.0 });
    };
    let points = [YIELD, &[&[5.0, 0.5, 3.0]]].concat();
    let said = causes(("coulomb.yield", Wanted::Jacobian), &points, mistake);
    let explained = "Jacobian: the sign is turned of ∂phi/∂mu: this explains all 4 points looked at";
    assert_eq!(said, ["value: unexplained", explained]);
}

#[test]
fn a_mistake_may_be_in_one_derivative_alone() {
    let points: &[&[f64]] =
        &[&[1.0, 2.0, 3.0, 4.0, 7.0, 5.0], &[-1.0, 0.5, 2.0, 3.0, 1.0, -4.0], &[0.5, 0.25, -3.0, 2.0, -1.0, 1.5]];
    // The first output is a unit vector: its derivatives are divided by the length, which is the last output.
    let undivided = |_: &[f64], y: &mut Numbers| y[4] = y[4].zip(y[3]).map(|(slope, length)| slope * length);
    let said = cause(("slider.line", Wanted::Jacobian), points, undivided);
    assert!(said.starts_with("the factor 1 / length("), "{said}");
}

#[test]
fn a_mistake_may_be_in_the_value_and_in_one_derivative() {
    let without = |x: &[f64], y: &mut Numbers| (y[0], y[1]) = (Some(-x[1] * x[2]), Some(0.0));
    // Where the term is 0 the value is right without it.
    let with_none: [&[f64]; 4] = [&[0.0, 0.5, 4.0], YIELD[0], YIELD[1], YIELD[2]];
    for points in [YIELD, &with_none] {
        let said = cause(("coulomb.yield", Wanted::Jacobian), points, without);
        assert_eq!(said, "the term p is left out of p − mu fn");
    }
}

#[test]
fn of_two_mistakes_the_simpler_one_is_named() {
    // If p is 1, a missing factor fn is an equally good explanation.
    let points: &[&[f64]] = &[&[1.0, 0.5, 4.0], &[1.0, 0.25, 3.0], &[1.0, 0.75, 5.0]];
    let said = cause(("coulomb.yield", Wanted::Value), points, |x, y| y[0] = Some(1.0 - x[1]));
    assert_eq!(said, "p for fn in mu fn");
}

#[test]
fn an_explanation_holds_where_the_program_would_have_refused() {
    // Inputs are exchanged, except where an exchanged input would be rejected.
    let exchanged = |x: &[f64], y: &mut Numbers| {
        if x[0] >= 0.0 {
            let (value, _) =
                find("slot.friction").unwrap().value_and_jacobian(&[x[4], x[1], x[2], x[3], x[0]]).unwrap();
            *y = value.into_iter().map(Some).collect();
        }
    };
    let friction = ("slot.friction", Wanted::Value);
    let positive = [FRICTION[1], FRICTION[2], &[1.0, 2.0, 3.0, 4.0, 0.5]];
    assert_eq!(cause(friction, &positive, exchanged), "exchanged: the inputs f1 and mu");
    assert_eq!(causes(friction, &[&positive, FRICTION].concat(), exchanged), ["unexplained"]);
}

#[test]
fn other_inputs_may_lie_on_a_kink() {
    // At the first point it sticks, and twice the force is exactly the friction limit.
    let points: &[&[f64]] = &[&[1.0, 0.5, 4.0], &[0.5, 0.25, 5.0], &[3.0, 0.5, 4.0], &[0.25, 0.75, 5.0]];
    let twice = |x: &[f64], y: &mut Numbers| {
        let of = find("coulomb.return_map").unwrap().value_and_jacobian(&[2.0 * x[0], x[1], x[2]]).unwrap();
        *y = [of.0, of.1].concat().into_iter().map(Some).collect();
    };
    assert_eq!(cause(("coulomb.return_map", Wanted::Jacobian), points, twice), "the input f_trial is taken twice");
}

#[test]
fn other_inputs_have_to_explain_the_derivatives_too() {
    let points: &[&[f64]] = &[&[3.0, 1.0], &[5.0, -2.0], &[4.0, 2.5]];
    let turned = |x: &[f64], y: &mut Numbers| {
        let sign = (x[0] - x[1]).signum();
        *y = [(x[0] - x[1]).abs(), sign * (1.0 + 1e-10), -sign * (1.0 + x[0] * 1e-10)].map(Some).to_vec();
    };
    let said = causes(("slot.normal_force", Wanted::Jacobian), points, turned);
    let explained = "value: the sign of the input fc_int is turned: this explains all 3 points looked at";
    assert_eq!(said, [explained, "Jacobian: unexplained"]);
}

#[test]
fn an_exchange_explains_all_that_is_off_in_a_part_and_needs_no_other_part() {
    let points: &[&[f64]] =
        &[&[1.0, 2.0, 3.0, 4.0, 7.0, 5.0], &[-1.0, 0.5, 2.0, 3.0, 1.0, -4.0], &[0.5, 0.0, 3.0, 2.0, -1.0, 1.5]];
    let line = ("slider.line", Wanted::Jacobian);
    assert_eq!(cause(line, points, |_, y| y.swap(0, 2)), "exchanged: the outputs n[0] and n[2]");
    let and_another = |x: &[f64], y: &mut Numbers| {
        y.swap(0, 2);
        times(&mut y[3], x[1] + 3.0);
    };
    assert_eq!(cause(line, points, and_another), "unexplained");
}

#[test]
fn beside_a_kink_no_answer_tells() {
    // It sticks by a rounding error.
    let said = causes(("coulomb.return_map", Wanted::Jacobian), &[&[1.0, 0.1, 10.0]], |_, y| y[0] = Some(1.5));
    assert_eq!(said, ["it is off where a rounding decides on which side of a kink it is, and nowhere else"]);
}

#[test]
fn the_first_answers_are_explained() {
    let contact = ("slot.contact_force", Wanted::Value);
    let said = diagnosed(
        contact,
        &asked(contact.0, contact.1, CONTACT),
        |_, y| times(&mut y[0], 2.0),
        |court, first| {
            let answers = [first, vec![Answer::Skipped("later".into()); CONTACT.len()]];
            diagnose(court, &answers, &court.judge(&answers))
        },
    );
    assert_eq!(said, ["a factor of 2 too much in fc: this explains all 3 points looked at"]);
}

#[test]
fn a_part_of_what_is_right_is_evidence_too() {
    let points: Vec<_> = (0..300).map(|k| [f64::from(k) + 1.0, 0.5]).collect();
    let points: Vec<_> = points.iter().map(<[f64; 2]>::as_slice).collect();
    let contact = ("slot.contact_force", Wanted::Value);
    let mistake = |x: &[f64], y: &mut Numbers| times(&mut y[0], if x[0] < 4.0 { 2.0 } else { 1.0 });
    let (seen, off) = diagnosed(contact, &asked(contact.0, contact.1, &points), mistake, |court, answers| {
        let both = [answers.clone(), answers];
        let evidence = Evidence::new(court, &both[0], &court.judge(&both));
        (evidence.samples.len(), evidence.off_samples(&evidence.off).len())
    });
    assert_eq!((seen, off), (203, 3));
}

#[test]
fn symmetric_parts_explain_all_of_a_part_or_nothing() {
    let points: &[&[f64]] = &[
        &[0.6, 0.8, 0.0, 0.0, 0.6, 0.8, 1.5],
        &[0.0, 0.6, 0.8, 0.8, 0.0, 0.6, -0.5],
        &[0.8, 0.0, 0.6, 0.6, 0.8, 0.0, 2.5],
    ];
    // The first of three blocks is symmetrised, and the entries of its derivatives are transposed.
    let mistake = |_: &[f64], y: &mut Numbers| {
        for (a, b) in [(1, 3), (2, 6), (5, 7)] {
            let half = y[a].zip(y[b]).map(|(x, y)| f64::midpoint(x, y));
            (y[a], y[b]) = (half, half);
            (0..7).for_each(|k| [a, b].iter().for_each(|i| times(&mut y[27 + 7 * i + k], 1.5)));
        }
    };
    let said = causes(("universal.geometric_stiffness", Wanted::Jacobian), points, mistake);
    let explained = "value: by rotation vectors, not by spins: the symmetric part of k_ta_ta";
    assert_eq!(said, [&format!("{explained}: this explains all 3 points looked at"), "Jacobian: unexplained"]);
    // The diagonal is unaffected.
    let stiffness = ("universal.geometric_stiffness", Wanted::Value);
    let said = causes(stiffness, points, |_, y| {
        y[0] = y[0].map(|x| 1.0 + 2.0 * x * x);
        for (a, b) in [(1, 3), (2, 6), (5, 7)] {
            let half = y[a].zip(y[b]).map(|(x, y)| f64::midpoint(x, y));
            (y[a], y[b]) = (half, half);
        }
    });
    assert_eq!(said, ["unexplained"]);
}
