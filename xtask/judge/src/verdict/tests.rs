use super::*;
use crate::question::of_points;
use jointproof::Octuple;
use jointproof::catalog::find;

/// A number that does not depend on the inputs.
fn known(exact: f64) -> Known {
    Known::combined(std::iter::empty()).with(Octuple::from(exact))
}

/// Judges a formula at these named points.
fn with_court<T>(id: &str, points: &[(&str, &[f64])], look: impl FnOnce(&Court<'_>) -> T) -> T {
    let formula = find(id).unwrap();
    let points = points.iter().map(|(name, inputs)| ((*name).to_owned(), inputs.to_vec())).collect();
    let questions = of_points(formula, Wanted::Jacobian, points, 1);
    look(&Court {
        formula,
        wanted: Wanted::Jacobian,
        bounds: Bounds::of(formula),
        questions: &questions,
        is_strict: true,
    })
}

fn numbers(numbers: &[f64]) -> Answer {
    Answer::Numbers(numbers.iter().copied().map(Some).collect())
}

#[test]
fn a_jump_is_more_than_rounding_and_does_not_go_on() {
    assert!(is_jump(1.0, 2.0, 2.0) && is_jump(-1.0, 1.0, 1.5));
    assert!(!is_jump(1.0, 1.0 + 1e-7, 1.0 + 1e-7) && !is_jump(-1.0, -1.0 - 1e-7, -1.0));
    assert!(!is_jump(-1e-3, 1e-3, 3e-3), "it passes through 0");
    assert!(!is_jump(1e-3, -1e-3, -3e-3), "it passes through 0 downwards");
    assert!(!is_jump(1.0, 2.0, 3.0), "it goes on as it came");
    assert!(!is_jump(-1.0, -1.0 - 1e-7, -1.0 - 1e-7), "a little below −1");
    assert!(is_jump(1e-9, 2e-9, 2e-9) && !is_jump(1e9, 1e9 + 1.0, 1e9 + 1.0), "it counts what it is of the numbers");
}

#[test]
fn of_equal_errors_the_first_is_the_worst() {
    let step = 4.0 * f64::EPSILON;
    let mut tally = Tally::default();
    let found = [(7, 1.0 + step), (8, 1.0 - step), (9, 1.0)];
    assert_eq!(found.map(|(question, found)| tally.record(question, found, &known(1.0), 2.0)), [true, true, false]);
    let state = |tally: &Tally| (tally.checked, tally.off, tally.grade, tally.worst.as_ref().unwrap().question);
    assert_eq!(state(&tally), (3, 2, Grade::Inaccurate, 7));
    let of = |question, found| {
        let mut other = Tally::default();
        other.record(question, found, &known(1.0), 2.0);
        other
    };
    tally.add(of(10, 1.0 + step));
    assert_eq!(state(&tally), (4, 3, Grade::Inaccurate, 7));
    tally.add(of(11, 2.0));
    assert_eq!(state(&tally), (5, 4, Grade::Wrong, 11));
    tally.add(of(12, 1.0));
    tally.record(13, 1.0 + step, &known(1.0), 2.0);
    assert_eq!(state(&tally), (7, 5, Grade::Wrong, 11));
}

#[test]
fn an_error_of_just_the_bound_is_allowed() {
    let mut tally = Tally::default();
    assert!(!tally.record(0, 1.0 + f64::EPSILON, &known(1.0), 2.0), "{tally:?}");
    assert!(tally.record(0, 1.0 + f64::EPSILON, &known(1.0), 1.9), "{tally:?}");
}

#[test]
fn all_is_well_where_something_was_judged_and_nothing_is_off() {
    let one = || Verdict { judged: 1, ..Verdict::default() };
    assert!(one().is_strictly_right() && Verdict { same: 1, ..Verdict::default() }.is_strictly_right());
    assert!(Verdict { same: 2, ..one() }.is_strictly_right() && !Verdict::default().is_strictly_right());
    assert!(Verdict { skipped: vec![(0, String::new())], ..one() }.is_strictly_right());
    assert!(!Verdict { off: vec![0], ..one() }.is_strictly_right());
    assert!(!Verdict { refused_wrongly: vec![0], ..one() }.is_strictly_right());
    assert!(!Verdict { accepted: vec![0], ..one() }.is_strictly_right());
    assert!(!Verdict { bad: vec![(0, String::new())], ..one() }.is_strictly_right());
    assert!(!Verdict { two_answers: vec![0], ..one() }.is_strictly_right());
}

#[test]
fn whether_it_refuses_is_told_by_the_first_answer() {
    with_court("coulomb.yield", &[("negative", &[1.0, -1.0, 2.0])], |court| {
        let judged = |first: Answer, second: Answer| court.judge(&[vec![first], vec![second]]);
        let found = judged(Answer::Refused(None), numbers(&[1.0; 4]));
        assert_eq!((found.refused, found.accepted.len()), (1, 0));
        let found = judged(numbers(&[1.0; 4]), Answer::Refused(None));
        assert_eq!((found.refused, found.accepted), (0, vec![0]));
    });
}

#[test]
fn what_is_not_given_or_not_known_is_not_off() {
    with_court("coulomb.yield", &[], |court| {
        let known = [Some(known(1.0)), Some(known(2.0)), None];
        assert!(court.are_right(&[Some(1.0), None, Some(5.0)], &known));
        assert!(!court.are_right(&[Some(1.0), Some(2.0f64.next_up()), None], &known));
        assert!(!court.are_right(&[Some(1.5), Some(2.0), None], &known));
        // Its value may be off by two roundings, its derivatives by none.
        assert!(court.are_right(&[Some(1.0 + f64::EPSILON), Some(2.0), None], &known));
    });
}

#[test]
fn the_lists_of_points_are_in_order() {
    let points = vec![("point", [1.0, 0.5, 4.0].as_slice()); 300];
    with_court("coulomb.yield", &points, |court| {
        let [first, second] = [2.0, 3.0].map(|x| vec![numbers(&[x; 4]); points.len()]);
        let found = court.judge(&[first, second]);
        assert!(found.off.iter().copied().eq(0..300) && found.two_answers == found.off, "{found:?}");
        assert_eq!(found.tallies.iter().map(|tally| tally.checked).collect::<Vec<_>>(), [600; 4]);
    });
}

#[test]
fn the_other_side_of_a_kink_is_a_rounding_of_one_input_away() {
    let on: [f64; 3] = [1.0, 0.5, 2.0];
    let points: [(&str, &[f64]); 3] = [("on", &on), ("off", &[0.75, 0.5, 2.0]), ("random 1 of seed 1", &on)];
    with_court("coulomb.return_map", &points, |court| {
        // At |f| = μ F_N it slips: a smaller f, or larger factors, lead to sticking.
        let sticks = [[on[0].next_down(), 0.5, 2.0], [1.0, on[1].next_up(), 2.0], [1.0, 0.5, on[2].next_up()]];
        assert_eq!(court.other_sides(0).collect::<Vec<_>>(), sticks);
        assert_eq!([0, 1, 2].map(|k| court.other_sides(k).next().is_some()), [true, false, false]);
    });
}

#[test]
fn beside_a_kink_the_answer_of_the_other_side_is_right_and_on_it_there_is_a_convention() {
    // As 0.1 is slightly more than a tenth, it sticks by a rounding error; the program says it slips.
    with_court("coulomb.return_map", &[("beside", &[1.0, 0.1, 10.0])], |court| {
        let found = court.judge(&[0, 1].map(|_| vec![numbers(&[1.0, 0.0, 10.0, 0.1])]));
        assert!(found.beside == 1 && found.judged == 4 && found.is_strictly_right(), "{found:?}");
        let found = court.judge(&[0, 1].map(|_| vec![numbers(&[1.0, 0.0, 10.0, 0.2])]));
        assert!(found.beside == 0 && found.judged == 4 && found.off == [0], "{found:?}");
    });
    with_court("slot.contact_force", &[("on", &[0.0, 0.0])], |court| {
        let found = court.judge(&[0, 1].map(|_| vec![numbers(&[0.0, 1.0, 0.0])]));
        assert!(found.beside == 0 && found.off == [0], "{found:?}");
    });
}

#[test]
fn a_product_may_be_off_by_a_rounding_of_each_term() {
    let formula = find("slot.friction").unwrap();
    let bounds = Bounds { value: 1.0, jacobian: 2.0 };
    let bound = |wanted, place| Court { formula, wanted, bounds, questions: &[], is_strict: true }.bound(place);
    // Three outputs of five inputs.
    assert_eq!([2, 3, 17].map(|place| bound(Wanted::Jacobian, place)), [1.0, 2.0, 2.0]);
    assert_eq!([2, 3, 10].map(|place| bound(Wanted::Products, place)), [1.0, 7.0, 7.0]);
}
