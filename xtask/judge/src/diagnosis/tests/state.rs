use super::*;

const UNEXPLAINED: &str = "state is kept between calls; what it is does not show";

/// The diagnosis of a program that is asked at some points of the yield function, then again in another order, and
/// keeps a number of an answer.
fn diagnosis_of(count: usize, mut hold: impl FnMut(usize, &mut Numbers)) -> String {
    let numbers = (0_u32..).map(f64::from).take(count);
    let points: Vec<_> = numbers.map(|k| [k + 1.0, 0.5, 4.0 - k]).collect();
    let points: Vec<_> = points.iter().map(<[f64; 3]>::as_slice).collect();
    let what = ("coulomb.yield", Wanted::Jacobian);
    diagnosed(
        what,
        &asked(what.0, what.1, &points),
        |_, _| {},
        |court, right| {
            let mut answers = [right.clone(), right];
            let turns = (0..count).map(|k| (0, k));
            let again = crate::question::other_order(count).into_iter().map(|k| (1, k));
            for (turn, (time, k)) in turns.chain(again).enumerate() {
                let Answer::Numbers(numbers) = &mut answers[time][k] else { panic!() };
                hold(turn, numbers);
                if numbers.is_empty() {
                    answers[time][k] = Answer::Skipped("later".into());
                }
            }
            let said = diagnose(court, &answers, &court.judge(&answers));
            assert_eq!(said.len(), 1, "{said:?}");
            said[0].clone()
        },
    )
}

#[test]
fn three_answers_tell_to_which_point_they_belong() {
    // Two points, asked twice: three answers have a predecessor.
    let before = |skipped: Option<usize>| {
        let mut before = None;
        diagnosis_of(2, move |turn, y| {
            y[2] = before.replace(y[2]).unwrap_or(y[2]);
            if skipped == Some(turn) {
                y.clear();
            }
        })
    };
    assert_eq!(before(None), "∂phi/∂mu is that of the point asked before: state is kept between calls");
    assert_eq!(before(Some(3)), UNEXPLAINED);
}

#[test]
fn a_number_that_is_not_given_belongs_to_any_point() {
    let mut before = None;
    let said = diagnosis_of(4, |turn, y| {
        y[2] = before.replace(y[2]).unwrap_or(y[2]).filter(|_| turn != 2);
    });
    assert_eq!(said, "∂phi/∂mu is that of the point asked before: state is kept between calls");
}

#[test]
fn one_answer_that_is_off_once_belongs_to_no_point() {
    let said = diagnosis_of(4, |turn, y| {
        if turn == 6 {
            times(&mut y[2], 1.5);
        }
    });
    assert_eq!(said, UNEXPLAINED);
}

#[test]
fn every_number_that_is_off_belongs_to_the_same_point() {
    let (mut before, mut factor) = (None, 0.0);
    let said = diagnosis_of(4, |_, y| {
        y[2] = before.replace(y[2]).unwrap_or(y[2]);
        factor += 1.0;
        times(&mut y[0], factor);
    });
    assert_eq!(said, UNEXPLAINED);
}
