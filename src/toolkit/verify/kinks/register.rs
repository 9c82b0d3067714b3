//! The registered kinks: which of them hold at a point, and what jumps there.

use super::jump::{Neighbourhood, Rank};
use crate::Octuple;
use crate::toolkit::equation::{Claims, Setting, Signature};
use crate::toolkit::verify::claim::{Claim, Deviation};
use crate::toolkit::verify::point::Names;
use crate::toolkit::verify::{Kink, Subject, exact, golden};
use num_traits::Signed;
use std::cell::OnceCell;

/// The tolerance for a computed point to be on a kink, relative to the terms of the kink's condition.
const MET: f64 = 1e-50;
/// The relative distance of nearby points.
pub(super) const BESIDE: f64 = 1e-55;

/// Every input changed by this relative amount.
pub(super) fn beside(at: &[Octuple], part: f64) -> Vec<Octuple> {
    at.iter().map(|&x| x + x * part).collect()
}

/// The registered kinks of a formula, to be tested at computed points.
pub(super) struct Register<'a> {
    subject: &'a Subject,
    /// Their printed conditions; `None` for those in words.
    printed: OnceCell<Vec<Option<Claims>>>,
}

impl<'a> Register<'a> {
    pub(super) fn new(subject: &'a Subject) -> Self {
        Self { subject, printed: OnceCell::new() }
    }

    /// The conditions of the kinks that contain a point.
    pub(super) fn met(&self, at: &[Octuple]) -> Vec<String> {
        let printed = self.printed.get_or_init(|| self.read());
        // A cut has π on one side and −π on the other.
        let beside = [BESIDE, -BESIDE].map(|part| beside(at, part));
        let values = |at: &[Octuple]| [(self.subject.exact_value)(at), (self.subject.exact_jacobian)(at)];
        let places = [at, &beside[0], &beside[1]].map(|at| (at, values(at)));
        let is_near = |claims: &Claims| places.iter().any(|(at, values)| is_near(claims, at, values));
        let kinks = self.subject.kinks.iter().zip(printed);
        let met = kinks.filter(|(kink, printed)| (kink.holds)(at) || printed.as_ref().is_some_and(is_near));
        met.map(|(kink, _)| kink.condition.clone()).collect()
    }

    fn read(&self) -> Vec<Option<Claims>> {
        let Subject { spec, inputs, outputs, .. } = *self.subject;
        let setting = Setting { of: Some(Signature { spec, inputs, outputs }), is_deep: true, ..Setting::default() };
        self.subject.kinks.iter().map(|kink| Claims::read(&kink.condition, &setting).ok()).collect()
    }
}

/// Whether a printed condition holds up to rounding at a point where the formula has these values.
fn is_near(claims: &Claims, at: &[Octuple], [values, jacobian]: &[Vec<Octuple>; 2]) -> bool {
    let point = claims.point(at, Some([values, jacobian]), &[]);
    let sizes: Vec<_> = point.iter().map(Signed::abs).collect();
    claims.at(&point).iter().all(|claim| {
        let terms = claims.terms(claim, &point, &sizes);
        if claim.is_equality { (claim.right - claim.left).abs() <= terms * MET } else { claim.holds }
    })
}

/// The jump at a kink, with the values on both sides, for the output and input with the largest jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// What jumps.
    pub rank: Rank,
    /// The index of the output's component.
    pub output: usize,
    /// The index of the input's component.
    pub input: usize,
    /// The value or derivative where the input is smaller, and where it is larger. If only one side exists: on the
    /// kink and near it. Infinite if it grows without bound.
    pub sides: [f64; 2],
}

/// Distances from the kink, in units of the size of the inputs: a quantity without bound grows from one to the next.
const STEPS: [f64; 2] = [1e-30, 1e-36];
/// A larger relative difference is a jump.
const JUMP: f64 = 1e-9;
/// A quantity that grows by more is unbounded, and one that shrinks by more tends to 0.
const GROWS: f64 = 10.0;

/// The jump on a registered kink, at the point that the kink names; `None` if nothing jumps.
pub(crate) fn sides(subject: &Subject, kink: &Kink) -> Option<Sides> {
    let at = exact(&kink.at);
    let neighbourhood = Neighbourhood::new(subject, &at);
    let across: Vec<_> = (0..at.len()).filter(|&k| kink.across[k] != 0.0).collect();
    let others: Vec<_> = (0..at.len()).filter(|k| !across.contains(k)).collect();
    let ranks = [Rank::Value, Rank::Slope, Rank::Curvature];
    let tried = [across, others];
    let mut ways = tried.iter().flat_map(|inputs| ranks.map(|rank| (inputs, rank)));
    ways.find_map(|(inputs, rank)| {
        let found = inputs.iter().flat_map(|&input| jumps(&neighbourhood, rank, input));
        let most =
            found.fold((JUMP, None), |most, (size, sides)| if size > most.0 { (size, Some(sides)) } else { most });
        most.1
    })
}

/// For every output, its relative jump with an input.
fn jumps(neighbourhood: &Neighbourhood<'_>, rank: Rank, input: usize) -> Vec<(f64, Sides)> {
    let (inner, edge) = neighbourhood.sides(&[input]);
    let signs = match (inner.first(), edge.first()) {
        (Some(_), _) => [-1.0, 1.0],
        (None, Some(&(_, sign))) => [0.0, sign],
        (None, None) => return Vec::new(),
    };
    // A derivative does not exist on the kink itself, only near it.
    let signs = if rank == Rank::Value { signs } else { signs.map(|sign| if sign == 0.0 { signs[1] } else { sign }) };
    let [near, nearer] = STEPS.map(|step| signs.map(|sign| neighbourhood.seen(rank, input, sign * step)));
    let of_output = |output: usize| {
        let side = |k: usize| limit(near[k][output], nearer[k][output]);
        let [below, above] = [side(0), side(1)];
        let size = if below == above { 0.0 } else { difference(below, above) };
        (size, Sides { rank, output, input, sides: [below, above] })
    };
    (0..near[0].len()).map(of_output).collect()
}

/// The relative difference of two numbers; 1 if one of them is infinite.
fn difference(a: f64, b: f64) -> f64 {
    if a.is_infinite() || b.is_infinite() { 1.0 } else { (a - b).abs() / (a.abs() + b.abs()) }
}

/// The limit of a quantity, from its values near a kink and nearer to it.
fn limit(near: Octuple, nearer: Octuple) -> f64 {
    let growth = (nearer / near).abs();
    match growth {
        _ if growth > GROWS => f64::INFINITY.copysign(nearer.to_f64()),
        _ if growth < GROWS.recip() => 0.0,
        _ => nearer.to_f64(),
    }
}

/// The claim that something jumps on every registered kink; `None` if there are none.
pub(in crate::toolkit::verify) fn register(subject: &Subject, names: &Names) -> Option<Claim> {
    let mut claim = Claim::new("on every registered kink something jumps: kinks on which nothing does", 0.0);
    for kink in &subject.kinks {
        let sides = sides(subject, kink);
        let finite = |x: f64| x.clamp(f64::MIN, f64::MAX);
        claim.record(f64::from(u8::from(sides.is_none())), 0.0, |size| Deviation {
            size,
            entry: sides
                .map_or("nothing jumps".into(), |sides| names.entry(sides.output * names.inputs.len() + sides.input)),
            point: format!("kink {}", kink.condition),
            found: sides.map_or(0.0, |sides| finite(sides.sides[1])),
            expected: sides.map_or(0.0, |sides| finite(sides.sides[0])),
            inputs: golden::named(subject.inputs, &kink.at).into(),
        });
    }
    (claim.checks > 0).then_some(claim)
}

#[cfg(test)]
mod tests {
    use super::super::planted::{Function, kink, planted};
    use super::*;
    use crate::toolkit::verify::rounded;
    use num_dual::DualNum;

    const X: [f64; 3] = [1.0, 0.0, 0.0];
    const Y: [f64; 3] = [0.0, 1.0, 0.0];
    const FLAT: Function = |_| exact(&[0.0; 6]);

    fn number(x: f64) -> Octuple {
        x.into()
    }

    /// A formula with registered kinks where the printed conditions say so.
    fn with_printed(value: Function, conditions: &[&str]) -> Subject {
        let mut subject = planted(value, FLAT);
        subject.kinks = conditions.iter().map(|condition| kink(condition, |_| false, [0.0; 3], X)).collect();
        subject
    }

    #[test]
    fn beside_a_point_every_input_is_changed_in_proportion() {
        assert_eq!(rounded(&beside(&exact(&[2.0, 0.0, -8.0]), 0.25)), [2.5, 0.0, -10.0]);
        assert_eq!(rounded(&beside(&exact(&[2.0, 0.0, -8.0]), -0.5)), [1.0, 0.0, -4.0]);
    }

    #[test]
    fn kinks_are_met_that_hold_or_are_printed_so() {
        let mut subject = with_printed(FLAT, &["x = 1", "y = 2"]);
        subject.kinks.push(kink("in words", |i| i[2] == 3.0, [0.0; 3], X));
        let met = |at: [f64; 3]| Register::new(&subject).met(&exact(&at));
        assert_eq!(met([1.0, 2.0, 3.0]), ["x = 1", "y = 2", "in words"]);
        assert_eq!(met([1.0, 3.0, 3.0]), ["x = 1", "in words"]);
        assert_eq!(met([2.0, 2.0, 2.0]), ["y = 2"]);
    }

    #[test]
    fn a_printed_equality_holds_but_for_rounding() {
        let subject = with_printed(FLAT, &["x = y"]);
        let is_met =
            |x: f64, off: Octuple| !Register::new(&subject).met(&[number(x) + off, number(x), number(1.0)]).is_empty();
        for sign in [1.0, -1.0] {
            let off = |by: f64| number(by) * sign;
            assert!(is_met(2.0, off(1e-50)) && is_met(-2.0, off(1e-50)) && is_met(0.0, off(0.0)));
            assert!(!is_met(2.0, off(1e-48)) && !is_met(-2.0, off(1e-48)));
        }
    }

    #[test]
    fn all_of_a_printed_condition_must_hold() {
        let subject = with_printed(FLAT, &[r"x = 1,\ y < 2"]);
        let is_met = |x: f64, y: f64| !Register::new(&subject).met(&exact(&[x, y, 1.0])).is_empty();
        assert_eq!([is_met(1.0, 1.0), is_met(1.0, 3.0), is_met(2.0, 1.0)], [true, false, false]);
    }

    /// The value of a on either side of x = 2, and in between.
    #[test]
    fn a_kink_of_a_value_that_jumps_is_met_from_both_sides() {
        let value: Function = |i| {
            let side = i[0] - 2.0;
            exact(&[
                if side > 0.0 {
                    1.0
                } else if side < 0.0 {
                    -1.0
                } else {
                    0.0
                },
                0.0,
            ])
        };
        let met =
            |condition| !Register::new(&with_printed(value, &[condition])).met(&exact(&[2.0, 1.0, 1.0])).is_empty();
        assert_eq!(["a = 1", "a = -1", "a = 0", "a = 2"].map(met), [true, true, true, false]);
    }

    #[test]
    fn what_grows_has_no_bound_and_what_shrinks_tends_to_nothing() {
        let tends = |near: f64, nearer: f64| limit(number(near), number(nearer));
        assert_eq!([tends(2.0, 3.0), tends(2.0, -3.0), tends(1.0, 10.0), tends(-1.0, 0.5)], [3.0, -3.0, 10.0, 0.5]);
        assert_eq!([tends(1.0, 11.0), tends(1.0, -11.0)], [f64::INFINITY, f64::NEG_INFINITY]);
        assert_eq!([tends(1.0, 0.09), tends(-1.0, 0.09), tends(16.0, 2.0)], [0.0, 0.0, 2.0]);
        assert_eq!(tends(0.0, 0.0), 0.0);
    }

    #[test]
    fn a_difference_is_a_part_of_both_numbers() {
        let infinite = f64::INFINITY;
        assert_eq!([difference(3.0, 1.0), difference(-1.0, -3.0), difference(1.0, -1.0)], [0.5, 0.5, 1.0]);
        assert_eq!([difference(infinite, 1.0), difference(1.0, -infinite), difference(infinite, -infinite)], [1.0; 3]);
    }

    /// The jump on a kink at a point, crossed in this direction.
    fn sides_of(value: Function, jacobian: Function, at: [f64; 3], across: [f64; 3]) -> Option<Sides> {
        sides(&planted(value, jacobian), &kink("x = y", |_| false, at, across))
    }

    #[test]
    fn the_sides_of_a_slope_are_by_an_input_that_crosses_the_kink() {
        let jump = |output, input, sides| Some(Sides { rank: Rank::Slope, output, input, sides });
        // |x − y| in units of length and of force.
        let absolute: Function = |i| vec![number(0.0), (i[0] - i[1]).abs()];
        assert_eq!(sides_of(absolute, FLAT, [2.0, 2.0, 1.0], X), jump(1, 0, [-1.0, 1.0]));
        assert_eq!(sides_of(absolute, FLAT, [2.0, 2.0, 1.0], Y), jump(1, 1, [-1.0, 1.0]));
        // An input that does not cross it is used if no other shows a jump.
        let other: Function = |i| vec![i[0].abs() * -3.0, i[1]];
        assert_eq!(sides_of(other, FLAT, [0.0, 2.0, 1.0], Y), jump(0, 0, [3.0, -3.0]));
        // The largest over all outputs and inputs, and the first of equal ones.
        let some: Function = |i| vec![i[0].abs() + i[0] * 9.0, i[0].abs() + i[2]];
        assert_eq!(sides_of(some, FLAT, [0.0, 2.0, 1.0], X), jump(1, 0, [-1.0, 1.0]));
        let same: Function = |i| vec![i[0].abs(), i[0].abs()];
        assert_eq!(sides_of(same, FLAT, [0.0, 2.0, 1.0], X), jump(0, 0, [-1.0, 1.0]));
    }

    #[test]
    fn a_value_that_jumps_comes_before_its_derivatives_and_these_one_by_one() {
        let rank =
            |value, jacobian| sides_of(value, jacobian, [0.0, 2.0, 1.0], X).map(|sides| (sides.rank, sides.sides));
        let step: Function = |i| vec![number(if i[0] > 0.0 { 3.0 } else { 1.0 }) + i[0].abs(), number(0.0)];
        assert_eq!(rank(step, FLAT), Some((Rank::Value, [1.0, 3.0])));
        // x |x|, whose slope is 2 |x|.
        let bent: Function = |i| vec![i[0] * i[0].abs(), number(0.0)];
        let slope: Function = |i| [vec![i[0].abs() * 2.0], exact(&[0.0; 5])].concat();
        assert_eq!(rank(bent, slope), Some((Rank::Curvature, [-2.0, 2.0])));
        assert_eq!(rank(|i| vec![i[0] * 3.0, i[1]], FLAT), None);
    }

    #[test]
    fn a_part_in_a_thousand_million_is_no_jump() {
        let has_sides = |value| sides_of(value, FLAT, [0.0, 2.0, 1.0], X).is_some();
        assert!(has_sides(|i| vec![i[0] + i[0].abs() * 2e-9, i[1]]));
        assert!(!has_sides(|i| vec![i[0] + i[0].abs() * 5e-10, i[1]]));
    }

    /// x and c are inside their domains, y is at an end of its domain.
    #[test]
    fn at_the_edge_of_a_domain_the_kink_itself_is_the_other_side() {
        let at = |y: f64, input: usize| {
            let value: Function = |i| {
                let y = i[1];
                let end = if y == 0.0 {
                    5.0
                } else if y == 4.0 {
                    7.0
                } else {
                    1.0
                };
                vec![number(end), i[0]]
            };
            let subject = planted(value, FLAT);
            let at = exact(&[1.0, y, 1.0]);
            let jumps = jumps(&Neighbourhood::new(&subject, &at), Rank::Value, input);
            jumps.into_iter().map(|(size, sides)| (size, sides.output, sides.sides)).collect::<Vec<_>>()
        };
        assert_eq!(at(0.0, 1), [(4.0 / 6.0, 0, [5.0, 1.0]), (0.0, 1, [1.0, 1.0])]);
        assert_eq!(at(4.0, 1), [(6.0 / 8.0, 0, [7.0, 1.0]), (0.0, 1, [1.0, 1.0])]);
        assert_eq!(at(5.0, 1), []);
        assert_eq!(at(0.0, 2)[0], (0.0, 0, [5.0, 5.0]));
    }

    /// A root has no slope at its end point, but has one near it.
    #[test]
    fn at_the_edge_of_a_domain_a_slope_is_seen_beside_it_alone() {
        let value: Function = |i| vec![i[1].sqrt(), i[1] * 3.0];
        let subject = planted(value, FLAT);
        let at = exact(&[1.0, 0.0, 1.0]);
        let jumps = jumps(&Neighbourhood::new(&subject, &at), Rank::Slope, 1);
        let infinite = f64::INFINITY;
        let found: Vec<_> = jumps.iter().map(|(size, sides)| (*size, sides.sides)).collect();
        assert_eq!(found, [(0.0, [infinite, infinite]), (0.0, [3.0, 3.0])]);
    }

    #[test]
    fn the_claim_counts_kinks_and_shows_one_on_which_nothing_jumps() {
        let value: Function = |i| vec![number(0.0), i[0].abs()];
        let claimed = |conditions: &[(&str, [f64; 3])]| {
            let mut subject = planted(value, FLAT);
            subject.kinks = conditions.iter().map(|(name, at)| kink(name, |_| false, *at, X)).collect();
            register(&subject, &Names::new(&subject))
        };
        assert_eq!(claimed(&[]), None);
        let shown = |conditions: &[(&str, [f64; 3])]| {
            let claim = claimed(conditions).expect("there are kinks");
            let Deviation { size, entry, point, found, expected, inputs } = claim.worst.expect("they were checked");
            (claim.checks, claim.failures, size, entry, point, [expected, found], inputs["y"].as_f64())
        };
        let (kink, none) = (("x = 0", [0.0, 3.0, 1.0]), ("x = 1", [1.0, 2.0, 1.0]));
        assert_eq!(shown(&[kink]), (1, 0, 0.0, "∂b/∂x".into(), "kink x = 0".into(), [-1.0, 1.0], Some(3.0)));
        let nothing = "nothing jumps".to_owned();
        assert_eq!(shown(&[kink, none]), (2, 1, 1.0, nothing, "kink x = 1".into(), [0.0, 0.0], Some(2.0)));
    }

    #[test]
    fn a_side_without_bound_is_shown_as_the_largest_number() {
        let mut subject = planted(|i| vec![number(1.0) / i[0], number(0.0)], FLAT);
        subject.kinks.push(kink("x = 0", |_| false, [0.0, 1.0, 1.0], X));
        let claim = register(&subject, &Names::new(&subject)).expect("there is a kink");
        let worst = claim.worst.expect("it was checked");
        assert_eq!([worst.expected, worst.found], [f64::MIN, f64::MAX]);
    }
}
