//! Neighbourhoods of planted formulas with known jumps.

use super::super::planted::{Function, planted};
use super::*;
use crate::contact::coulomb::Yield;
use crate::toolkit::verify::{exact, rounded};
use num_dual::DualNum;
use num_traits::One;

const FLAT: Function = |_| exact(&[0.0; 6]);

fn number(x: f64) -> Octuple {
    x.into()
}

/// Whether numbers agree to 40 digits.
fn is_close(found: Octuple, expected: Octuple) -> bool {
    (found - expected).abs() <= expected.abs() * 1e-40
}

/// The jumps of a and b with respect to x at x = 0, y = 0 and c = 1.
fn at_zero(value: Function, jacobian: Function) -> [Jump; 2] {
    let (subject, at) = (planted(value, jacobian), exact(&[0.0, 0.0, 1.0]));
    let jumps = Neighbourhood::new(&subject, &at).each_across(&[1.0, 0.0, 0.0]);
    jumps.try_into().expect("two outputs")
}

#[test]
fn the_larger_jump_is_kept_and_the_first_of_two_alike() {
    let jump = |size, output| Jump { size, output, ..Jump::none() };
    let larger = |a: f64, b: f64| jump(a, 1).or_larger(jump(b, 2)).output;
    assert_eq!([larger(1.0, 2.0), larger(2.0, 1.0), larger(1.0, 1.0), larger(1.0, f64::NAN)], [2, 1, 1, 1]);
    assert_eq!((Jump::none().size, Jump::none().output), (0.0, 0));
    let all = vec![jump(1.0, 0), jump(f64::NAN, 1), jump(3.0, 2), jump(2.0, 3)];
    assert_eq!((worst(all).output, worst(Vec::new()).size), (2, 0.0));
    assert!(jump(SMOOTH, 0).is_smooth() && !jump(SMOOTH.next_up(), 0).is_smooth());
}

#[test]
fn both_sides_of_an_input_are_in_the_domain_or_one_or_none() {
    let subject = planted(FLAT, FLAT);
    let sides = |y: Octuple, inputs: &[usize]| {
        let at = [number(-3.0), y, number(2.0)];
        Neighbourhood::new(&subject, &at).sides(inputs)
    };
    let zero = number(0.0);
    assert_eq!(sides(zero, &[0, 1, 2]), (vec![0, 2], vec![(1, 1.0)]));
    assert_eq!(sides(number(4.0), &[2, 1]), (vec![2], vec![(1, -1.0)]));
    assert_eq!(sides(number(3.0), &[1]), (vec![1], vec![]));
    assert_eq!(sides(number(5.0), &[1]), (vec![], vec![]));
    // Nearer to the edge than the longer step, and farther away.
    assert_eq!(sides(number(4.0) - 1e-24, &[1]), (vec![], vec![(1, -1.0)]));
    assert_eq!(sides(number(4.0) - 1e-23, &[1]), (vec![1], vec![]));
}

#[test]
fn a_direction_changes_one_input_by_its_size() {
    let (subject, at) = (planted(FLAT, FLAT), exact(&[-0.0, -3.0, 2.0]));
    let beside = Neighbourhood::new(&subject, &at);
    assert_eq!(beside.dimensions(), 3);
    assert_eq!((beside.axis(2), beside.towards(1, -1.0)), (vec![0.0, 0.0, 1.0], vec![0.0, -1.0, 0.0]));
    // An input that is 0 has the size of inputs with the same unit.
    assert_eq!([0, 1, 2].map(|input| beside.unit(input)), [2.0, 3.0, 2.0].map(number));
    let moved = rounded(&beside.moved(&[0.0, -2.0, 1.0], 0.25));
    // The sign of a zero affects angles.
    assert_eq!(moved.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), [-0.0, -4.5, 2.5].map(f64::to_bits));
    assert_eq!(rounded(&beside.moved(&[1.0, 0.0, 0.0], 0.25)), [0.5, -3.0, 2.0]);
}

/// The Jacobian returns the point at which it was evaluated.
#[test]
fn the_closed_form_is_asked_just_beside_the_point() {
    let jacobian: Function = |i| {
        let infinite = number(f64::INFINITY);
        vec![i[0], Octuple::zero(), infinite, Octuple::zero(), i[1], infinite]
    };
    let (subject, at) = (planted(FLAT, jacobian), exact(&[0.0, 3.0, 2.0]));
    let [by_x, by_y] = Neighbourhood::new(&subject, &at).beside(&[1.0, -2.0, 0.0], 0.5)[..] else { panic!("two") };
    assert!(is_close(by_x, number(1e-300) * 2.0 * 0.5 * 2.0));
    let moved = (by_y / -6.0 - 3.0) / 1e-50;
    assert!((moved + 3.0).abs() < 1e-15, "{moved}");
}

/// a = x y², b = x² c.
#[test]
fn value_slope_and_curvature_are_seen_at_a_step() {
    let value: Function = |i| vec![i[0] * i[1] * i[1], i[0] * i[0] * i[2]];
    let jacobian: Function = |i| {
        let row = |by_x, by_y, by_c| [by_x, by_y, by_c];
        let a = row(i[1] * i[1], i[0] * i[1] * 2.0, Octuple::zero());
        [a, row(i[0] * i[2] * 2.0, Octuple::zero(), i[0] * i[0])].concat()
    };
    let (subject, at) = (planted(value, jacobian), exact(&[5.0, 2.0, 3.0]));
    let beside = Neighbourhood::new(&subject, &at);
    let seen = |rank, input, step| rounded(&beside.seen(rank, input, step));
    assert_eq!(seen(Rank::Value, 1, 0.0), [20.0, 75.0]);
    // y becomes 3, and x 15.
    assert_eq!(seen(Rank::Value, 1, 0.5), [45.0, 75.0]);
    assert_eq!(seen(Rank::Slope, 1, 0.5), [25.0, 0.0]);
    assert_eq!(seen(Rank::Slope, 0, 2.0), [4.0, 60.0]);
    assert_eq!(seen(Rank::Curvature, 1, 0.5), [10.0, 0.0]);
    assert_eq!(seen(Rank::Curvature, 0, 2.0), [0.0, 6.0]);
}

#[test]
fn an_absolute_value_jumps_by_all_of_its_derivative() {
    let [a, b] = at_zero(
        |i| vec![i[0], -i[0].abs()],
        |i| {
            let zero = Octuple::zero();
            vec![Octuple::one(), zero, zero, if i[0] > 0.0 { -Octuple::one() } else { Octuple::one() }, zero, zero]
        },
    );
    assert_eq!((a.size, a.output, b.output, b.sides.map(Octuple::to_f64)), (0.0, 0, 1, [1.0, -1.0]));
    // The size of x is that of c. In addition to 2, the closed form at the point contributes.
    assert_eq!(b.size, 2.0 / (2.0 + 1.0));
}

/// −5 + 3 x where x is positive and −5 − x elsewhere, with −7 as the closed-form derivative with respect to y.
#[test]
fn a_jump_is_relative_to_derivatives_value_and_terms() {
    let value: Function = |i| vec![if i[0] > 0.0 { i[0] * 3.0 } else { -i[0] } - 5.0, Octuple::zero()];
    let jacobian: Function = |i| exact(&[if i[0] > 0.0 { 3.0 } else { -1.0 }, -7.0, 0.0, 0.0, 0.0, 0.0]);
    let [a, b] = at_zero(value, jacobian);
    assert_eq!(a.sides.map(Octuple::to_f64), [-1.0, 3.0]);
    let terms = 1.0 + 7.0;
    assert!((a.size - 4.0 / (1.0 + 3.0 + 5.0 + terms)).abs() < 1e-11, "{a:?}");
    assert_eq!((b.size, b.output), (0.0, 1));
}

/// y, whose size is 1, has no other side.
#[test]
fn where_one_side_has_no_value_the_derivative_has_a_limit_or_none() {
    fn where_positive(x: Octuple, value: Octuple) -> Octuple {
        if x < 0.0 { number(f64::NAN) } else { value }
    }
    let root: Function = |i| vec![where_positive(i[0], i[0].sqrt()), i[0].abs()];
    let root_back: Function = |i| vec![where_positive(-i[0], (-i[0]).sqrt()), i[0].abs()];
    let slope: Function = |i| {
        let slope = number(0.5) / i[0].abs().sqrt();
        let zero = Octuple::zero();
        vec![slope, zero, zero, Octuple::one(), zero, zero]
    };
    for value in [root, root_back] {
        let [a, b] = at_zero(value, slope);
        // Over a millionth of the step the slope is a thousand times larger, and both count.
        assert!((a.size - 999.0 / 1001.0).abs() < 1e-9, "{a:?}");
        assert!(a.sides[0].to_f64() > 0.9e12 && (a.sides[1] / a.sides[0]).to_f64() > 999.0, "{a:?}");
        assert_eq!(b.size, 0.0);
    }
    let line: Function = |i| vec![where_positive(i[0], i[0]), i[0].abs()];
    assert_eq!(at_zero(line, slope).map(|jump| jump.size), [0.0; 2]);
    let nowhere: Function = |i| vec![number(f64::NAN), i[0].abs()];
    assert_eq!(at_zero(nowhere, slope).map(|jump| jump.size), [0.0; 2]);
}

#[test]
fn the_largest_jump_of_all_outputs_is_told_across_and_inwards() {
    let value: Function = |i| vec![i[0].abs() + 1.0, i[0].abs()];
    let jacobian: Function = |i| exact(&[if i[0] > 0.0 { 1.0 } else { -1.0 }, 0.0, 0.0].repeat(2));
    let (subject, at) = (planted(value, jacobian), exact(&[0.0, 0.0, 1.0]));
    let beside = Neighbourhood::new(&subject, &at);
    assert_eq!(beside.across(&[1.0, 0.0, 0.0]).output, 1);
    assert!(beside.inward(&[1.0, 0.0, 0.0]).is_smooth());
    let root: Function = |i| vec![i[1], i[1].sqrt()];
    let slope: Function = |i| exact(&[0.0, 1.0, 0.0, 0.0, 0.5, 0.0]).iter().map(|&by| by / i[1].sqrt()).collect();
    let subject = planted(root, slope);
    let inward = Neighbourhood::new(&subject, &at).inward(&[0.0, 1.0, 0.0]);
    assert!(inward.output == 1 && inward.size > 0.99, "{inward:?}");
}

/// The larger of x and y, where every one-sided derivative exists.
#[test]
fn derivatives_along_two_directions_add_up_where_there_is_one() {
    let larger: Function = |i| vec![if i[0] < i[1] { i[1] } else { i[0] }, i[0] + i[1] * 3.0];
    let slopes: Function = |i| {
        let of_larger = if i[0] < i[1] { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
        exact(&[of_larger, [1.0, 3.0, 0.0]].concat())
    };
    let subject = planted(larger, slopes);
    let additive = |at: [f64; 3]| {
        let at = exact(&at);
        Neighbourhood::new(&subject, &at).additive([&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]])
    };
    let apex = additive([0.0, 0.0, 1.0]);
    assert_eq!((apex.output, apex.sides.map(Octuple::to_f64)), (0, [2.0, 1.0]));
    // 1 relative to the sum of both and the contribution of x.
    assert_eq!(apex.size, 1.0 / (2.0 + 1.0 + 1.0));
    assert!(additive([1.0, 2.0, 1.0]).is_smooth());
}

/// The size of the jump of b alone.
fn size(value: Function, jacobian: Function) -> f64 {
    let [a, b] = at_zero(value, jacobian);
    assert_eq!((a.size, b.output), (0.0, 1));
    b.size
}

fn b(value: Octuple) -> Vec<Octuple> {
    vec![Octuple::zero(), value]
}

fn by_x(slope: f64) -> Vec<Octuple> {
    exact(&[0.0, 0.0, 0.0, slope, 0.0, 0.0])
}

/// −1, 0 and 1.
const SIGN: Function = |i| by_x(i[0].to_f64().partial_cmp(&0.0).map_or(0.0, |order| f64::from(order as i8)));

#[test]
fn a_jump_is_one_over_the_shorter_step_too() {
    // Over the shorter step, the difference is 10⁻¹² of what it was.
    let shrinks = size(|i| b(i[0] * i[0] * 1e14), SIGN);
    assert!((shrinks / 1e-12 - 1.0).abs() < 1e-9, "{shrinks}");
    // Half of the slope persists, and is a smaller fraction of the total.
    let halved = size(|i| b(if i[0].abs() > 1e-30 { i[0].abs() } else { i[0].abs() * 0.5 } + 1.0), SIGN);
    assert!((halved - 0.5 * 0.5).abs() < 1e-15, "{halved}");
    // Twice the slope is a larger fraction, and no more than all persists.
    let doubled = size(|i| b(if i[0].abs() > 1e-30 { i[0].abs() } else { i[0].abs() * 2.0 } + 1.0), SIGN);
    assert!((doubled - 2.0 / 3.0).abs() < 1e-15, "{doubled}");
}

#[test]
fn a_jump_is_one_in_the_closed_form_too() {
    let absolute: Function = |i| b(i[0].abs());
    assert_eq!(size(absolute, FLAT), 0.0);
    assert_eq!(size(absolute, SIGN), 1.0);
    assert_eq!(size(absolute, |_| by_x(f64::NAN)), 1.0);
    // If the closed form jumps by half of it, half is confirmed.
    assert_eq!(size(absolute, |i| by_x(if i[0] > 0.0 { 1.0 } else { 0.0 })), 0.5);
}

#[test]
fn a_value_that_jumps_needs_no_closed_form_that_does() {
    assert_eq!(size(|i| b(number(if i[0] > 0.0 { 1.0 } else { 0.0 })), FLAT), 1.0);
    // Over the shorter step it jumps by a thousandth of the jump over the longer one, or by more.
    assert_eq!(
        size(
            |i| b(number(if i[0] > 1e-30 {
                1.0
            } else if i[0] > 0.0 {
                VALUE
            } else {
                0.0
            })),
            FLAT
        ),
        0.0
    );
    assert_eq!(
        size(
            |i| b(number(if i[0] > 1e-30 {
                1.0
            } else if i[0] > 0.0 {
                0.002
            } else {
                0.0
            })),
            FLAT
        ),
        1.0
    );
}

#[test]
fn where_nothing_seems_to_jump_the_closed_form_is_not_asked() {
    let jumps = at_zero(|i| vec![i[0] + i[1], i[2] * 2.0 - i[0] * 3.0], |_| unreachable!("it is not asked"));
    assert!(jumps.iter().all(Jump::is_smooth), "{jumps:?}");
    assert_eq!(jumps.map(|jump| jump.sides[0].to_f64()), [1.0, -3.0]);
}

#[test]
fn rounding_is_in_proportion_to_the_sizes_of_all_terms() {
    let (subject, at) = (Subject::of::<Yield>(), exact(&[7.0, 0.5, 3.0]));
    let beside = Neighbourhood::new(&subject, &at);
    // P − μ F
    let [p, mu, force] = [0, 1, 2].map(|input| beside.unit(input));
    assert_eq!(beside.terms(), [p + mu * 3.0 + force * 0.5]);
    let (subject, at) = (planted(FLAT, |_| exact(&[f64::INFINITY, 2.0, f64::NAN, -1.0, 0.0, -4.0])), exact(&[3.0; 3]));
    assert_eq!(Neighbourhood::new(&subject, &at).terms(), exact(&[6.0, 15.0]));
}

#[test]
fn of_nothing_there_is_no_part() {
    let part = |part, whole| share(number(part), number(whole));
    assert_eq!([part(0.0, 0.0), part(1.0, 4.0), part(1.0, 0.0)], [0.0, 0.25, f64::INFINITY]);
}
