use super::*;

const CONTACT_FORCE: (&str, Wanted) = ("slot.contact_force", Wanted::Value);

#[expect(clippy::cast_possible_truncation, reason = "the mistake that is planted")]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

#[test]
fn single_precision_shows_in_three_numbers_that_are_finite() {
    let points: &[&[f64]] = &[&[1.0, 2.0], &[2.0, 3.0], &[1.0, 5.0], &[1e300, 2e300]];
    let rounded = |_: &[f64], y: &mut Numbers| y[0] = y[0].map(single);
    assert_eq!(cause(CONTACT_FORCE, &points[..3], rounded), "results are rounded to single precision");
    assert_eq!(cause(CONTACT_FORCE, points, rounded), "results are rounded to single precision");
    assert_eq!(cause(CONTACT_FORCE, &points[1..], rounded), "unexplained");
}

#[test]
fn other_numbers_of_single_precision_are_no_rounded_ones() {
    let points: &[&[f64]] = &[&[1.0, 2.0], &[2.0, 3.0], &[1.0, 5.0]];
    let other = |x: &[f64], y: &mut Numbers| y[0] = y[0].map(|y| single(y * (1.0 + x[1] * 1e-4)));
    assert_eq!(cause(CONTACT_FORCE, points, other), "unexplained");
    // Nor if one of them has all digits.
    let one = |x: &[f64], y: &mut Numbers| y[0] = y[0].map(|y| if x[0] == 2.0 { y * (1.0 + 1e-6) } else { single(y) });
    assert_eq!(cause(CONTACT_FORCE, points, one), "unexplained");
}

/// The report where squares of the contact forces are out of range.
fn beyond(lost: usize, points: usize) -> String {
    format!(
        "right but for inputs below 1e-140 or above 1e140, where {lost} of {points} points give 0, NaN or an infinity: a \
         square or a product on the way leaves the range of doubles"
    )
}

#[test]
fn squares_out_of_range_show_where_inputs_are_extreme() {
    let small: [&[f64]; 4] = [&[1e-200, 3e-200], &[-2e-180, 1e-180], &[1e-160, 0.0], &[3.0, 4.0]];
    let large: [&[f64]; 4] = [&[1e200, 3e200], &[2e180, -1e180], &[1e160, 1.0], &[-3.0, 0.0]];
    let squared = |x: &[f64], y: &mut Numbers| y[0] = Some((x[0] * x[0] + x[1] * x[1]).sqrt());
    // A subnormal number is still a number, though an inaccurate one.
    for (points, lost) in [(small, 2), (large, 3)] {
        let said = causes(CONTACT_FORCE, &points, squared);
        assert_eq!(said, [format!("{}: this explains all 4 points looked at", beyond(lost, 3))], "{points:?}");
    }
}

#[test]
fn one_number_that_is_lost_shows_it_and_none_does_not() {
    let points: &[&[f64]] = &[&[1e-200, 3e-200], &[-2e-180, 1e-180], &[1e-160, 2e-160]];
    let lost = |most: f64, as_what: f64| {
        move |x: &[f64], y: &mut Numbers| y[0] = if x[1] < most { Some(as_what) } else { Some(x[0].abs() + x[1].abs()) }
    };
    for as_what in [0.0, f64::INFINITY, f64::NAN] {
        assert_eq!(cause(CONTACT_FORCE, points, lost(1e-199, as_what)), beyond(1, 3));
    }
    assert_eq!(cause(CONTACT_FORCE, points, lost(0.0, 0.0)), "unexplained");
    // One number of an answer suffices.
    let derivatives = |_: &[f64], y: &mut Numbers| *y = [0.0, 0.5, 0.25].map(Some).to_vec();
    assert_eq!(cause(("slot.contact_force", Wanted::Jacobian), points, derivatives), beyond(3, 3));
}

#[test]
fn what_is_off_elsewhere_too_does_not_leave_the_range() {
    let extreme: [&[f64]; 2] = [&[1e-200, 3e-200], &[2e200, 1e200]];
    for other in [[-3.0, 4.0], [0.0, 2.0], [-1.0, 0.0]] {
        let points = [extreme[0], extreme[1], &other];
        let lost = |x: &[f64], y: &mut Numbers| y[0] = Some(if x[0] > 1e100 { f64::INFINITY } else { 0.0 });
        assert_eq!(cause(CONTACT_FORCE, &points, lost), "unexplained", "{other:?}");
    }
}
