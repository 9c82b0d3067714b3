use super::*;
use crate::console::plain;
use crate::question::{Wanted, of_points};
use crate::verdict::{Bounds, Tally};
use jointproof::catalog::find;

/// The report of results at this many points of a formula, line by line.
fn lines(id: &str, wanted: Wanted, points: usize, found: &Verdict) -> Vec<String> {
    with_court(id, wanted, points, |court| {
        let text = text(court, &["mine".to_owned()], found, &Heard::default(), None, &[]);
        plain(&text).lines().map(|line| line.trim().to_owned()).collect()
    })
}

fn with_court<T>(id: &str, wanted: Wanted, points: usize, look: impl FnOnce(&Court<'_>) -> T) -> T {
    let formula = find(id).unwrap();
    let inputs = vec![0.5; crate::question::sizes(formula)[0]];
    let points = (0..points).map(|k| (format!("p{k}"), inputs.clone())).collect();
    let questions = of_points(formula, wanted, points, 1);
    look(&Court { formula, wanted, bounds: Bounds::of(formula), questions: &questions })
}

fn tally(grade: Grade, off: usize) -> Tally {
    let worst = Worst { eta: 9.0, question: 0, found: 2.0, exact: 1.0 };
    Tally { checked: 3, off, grade, worst: (off > 0).then_some(worst), ..Tally::default() }
}

#[test]
fn where_all_is_well_there_are_two_lines() {
    let found = Verdict { judged: 1, tallies: vec![tally(Grade::Right, 0)], ..Verdict::default() };
    let said = lines("coulomb.yield", Wanted::Value, 2, &found);
    let judged = "1 number judged in 237 bits, 0 have the bits of jointproof, 0 refused as they must be";
    let first = format!("ok  coulomb.yield by mine: 2 points, each asked twice; {judged}");
    assert_eq!(said, [&first, "η of the value at most 0 (bound 2.00)"]);
}

#[test]
fn what_is_understood_is_told_from_the_first_time_on() {
    let found = Verdict { judged: 1, refused_by_nan: 1, beside: 1, ..Verdict::default() };
    let said = lines("coulomb.yield", Wanted::Value, 2, &found);
    assert_eq!(said[1], "taken for a refusal: NaN or infinity, 1 time");
    let beside = "1 answer taken for right a rounding of an input beside the point, on the other side of a kink";
    assert_eq!(said[2..], [beside]);
}

#[test]
fn six_refusals_are_shown_and_the_others_counted() {
    let refused = |count: usize| {
        let found = Verdict { refused_wrongly: (0..count).collect(), ..Verdict::default() };
        lines("coulomb.yield", Wanted::Value, 8, &found)
    };
    let (six, seven) = (refused(6), refused(7));
    assert_eq!((six.len(), six[11].as_str()), (13, "refuses what is valid: p5"));
    assert_eq!((seven.len(), seven[13].as_str()), (14, "refuses 1 more"));
}

#[test]
fn three_points_are_named_and_of_more_the_first_three() {
    let named = |count: usize| {
        let skipped = (0..count).map(|k| (k, "later".to_owned())).collect();
        lines("coulomb.yield", Wanted::Value, 5, &Verdict { skipped, ..Verdict::default() })[1].clone()
    };
    assert_eq!(named(3), "skipped p0, p1, p2: later");
    assert_eq!(named(4), "skipped 4 points (p0, p1, p2, …): later");
}

#[test]
fn the_worst_numbers_come_first_and_six_are_told() {
    let of = |off: usize| {
        let mut tallies = vec![tally(Grade::Right, 0); 18];
        tallies[4..4 + off].fill(tally(Grade::Inaccurate, 1));
        tallies[3 + off].grade = Grade::Wrong;
        let said = lines("slot.friction", Wanted::Jacobian, 1, &Verdict { tallies, judged: 1, ..Verdict::default() });
        said.into_iter().skip_while(|line| !line.starts_with("+ right")).skip(1).collect::<Vec<_>>()
    };
    let six = of(6);
    assert_eq!(six.len(), 3 * 6, "{six:#?}");
    assert_eq!(six[0], "∂fn/∂f2 wrong at 1 of 3 answers: η 9.00 (bound 4.00) at p0");
    assert_eq!(six[3], "∂p/∂f2 inaccurate at 1 of 3 answers: η 9.00 (bound 4.00) at p0");
    let seven = of(7);
    assert_eq!((seven.len(), seven[18].as_str()), (3 * 6 + 1, "and 1 more"), "{seven:#?}");
}

#[test]
fn the_name_of_a_program_has_sixty_letters_at_most() {
    let silent = |words: &[&str]| {
        let words: Vec<_> = words.iter().map(|word| (*word).to_owned()).collect();
        with_court("coulomb.yield", Wanted::Value, 0, |court| plain(&court.silent(&words, "is silent")))
    };
    assert_eq!(silent(&["python3", "-c", "\n  a =  1\n"]), "off coulomb.yield by python3 -c a = 1: is silent\n");
    let (sixty, more) = ("ä".repeat(60), "ä".repeat(61));
    assert_eq!(silent(&[&sixty]), format!("off coulomb.yield by {sixty}: is silent\n"));
    assert_eq!(silent(&[&more]), format!("off coulomb.yield by {sixty}…: is silent\n"));
}
