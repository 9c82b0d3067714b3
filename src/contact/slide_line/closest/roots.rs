//! Roots of polynomials of degree 5 and lower in an interval, in any precision.
//!
//! Between two neighbouring extrema a polynomial crosses zero at most once, and its extrema are the roots of its derivative: so
//! the roots of every degree are bracketed by those one degree lower, down to the straight line (Yuksel 2022, "High-Performance
//! Polynomial Root Finding for Graphics"). Inside a bracket a step is Newton's if it stays inside and at least halves the last
//! step, and a bisection otherwise, so each step halves either the step or the bracket, and the search terminates for every
//! polynomial. For numbers longer than doubles the search starts from the root in doubles and accepts the result only if the sign
//! changes next to it.
//!
//! The crate polycool does the same in `f64`. The exact reference needs all 237 bits, and where two feet merge, at a centre of
//! curvature, a root found in `f64` is wrong after eight digits or is not found at all; hence this implementation, which the
//! tests compare with polycool.

use crate::number::scalar::{Leaf, abs};
use arrayvec::ArrayVec;

/// A double has 1074 + 53 binary digits after the point; more bisections cannot be needed.
const MOST_STEPS: usize = 1200;

/// The roots at which the polynomial, with its constant term first, falls through zero between two ends.
///
/// Its values at the ends are given, since the caller may know their signs better; an end where the value is 0 is not a root. If
/// the first is positive and the last negative, there is at least one root.
pub(super) fn falling<L: Leaf>(p: &[L; 6], ends: [L; 2], values: [L; 2]) -> ArrayVec<L, 5> {
    let p = trimmed(p);
    let mut brackets = brackets(p, ends, values);
    if let Some(last) = brackets.last_mut().filter(|last| last.high == 0.0) {
        last.high = last.low; // no change of sign
    }
    let falls = brackets.into_iter().filter(|b| b.low > 0.0 && b.high <= 0.0);
    falls.map(|bracket| bracket.crossing(p)).collect()
}

/// The roots at which it changes sign, in either direction.
fn crossings<L: Leaf>(p: &[L], ends: [L; 2]) -> ArrayVec<L, 5> {
    let values = ends.map(|u| value_and_slope(p, u).0);
    let changes = brackets(p, ends, values).into_iter().filter(|b| (b.low < 0.0) != (b.high < 0.0));
    changes.map(|bracket| bracket.crossing(p)).collect()
}

/// An interval without an extremum inside, and the values at its ends.
struct Bracket<L> {
    from: L,
    to: L,
    low: L,
    high: L,
}

fn brackets<L: Leaf>(p: &[L], ends: [L; 2], [first, last]: [L; 2]) -> ArrayVec<Bracket<L>, 5> {
    let extrema = match p.len() {
        0..=2 => ArrayVec::new(),
        _ => crossings(trimmed(&derivative(p)), ends),
    };
    let inner = extrema.into_iter().map(|u| (u, value_and_slope(p, u).0));
    let mut start = (ends[0], first);
    let mut brackets = ArrayVec::new();
    for end in inner.chain([(ends[1], last)]) {
        brackets.push(Bracket { from: start.0, to: end.0, low: start.1, high: end.1 });
        start = end;
    }
    brackets
}

impl<L: Leaf> Bracket<L> {
    /// The point where the polynomial changes sign.
    fn crossing(&self, p: &[L]) -> L {
        if self.high == 0.0 {
            return self.to;
        }
        let is_long = L::EPSILON < f64::EPSILON;
        is_long.then(|| self.refined(p)).flatten().unwrap_or_else(|| self.searched(p))
    }

    /// Newton's method from the root in doubles; `None` unless the polynomial is 0 or changes sign at the result.
    fn refined(&self, p: &[L]) -> Option<L> {
        let doubles: ArrayVec<f64, 6> = p.iter().map(L::re).collect();
        let [from, to, low, high] = [self.from, self.to, self.low, self.high].map(|x| x.re());
        let mut u = L::from(Bracket { from, to, low, high }.searched(&doubles));
        for _ in 0..MOST_REFINEMENTS {
            let (value, slope) = value_and_slope(p, u);
            if value == 0.0 {
                break;
            }
            let step = value / slope;
            u -= step;
            if abs(step) <= abs(u) * LAST {
                break;
            }
        }
        let value = |u| value_and_slope(p, u).0;
        let short = short_fraction(u);
        if abs(u - short) < BESIDE && value(short) == 0.0 {
            u = short;
        }
        let beside = abs(u) * BESIDE;
        let [below, above] = [u - beside, u + beside];
        let is_inside = self.from < below && above < self.to;
        let is_root = is_inside && (value(u) == 0.0 || (value(below) > 0.0) != (value(above) > 0.0));
        is_root.then_some(u)
    }

    /// Newton's method and bisection, starting in the middle.
    fn searched(&self, p: &[L]) -> L {
        let Self { mut from, mut to, low, .. } = *self;
        let middle = |from: L, to: L| from + (to - from) * 0.5;
        let mut u = middle(from, to);
        let mut step = to - from;
        for _ in 0..MOST_STEPS {
            let (value, slope) = value_and_slope(p, u);
            if value == 0.0 {
                return u;
            }
            if (value > 0.0) == (low > 0.0) {
                from = u;
            } else {
                to = u;
            }
            let newton = u - value / slope;
            let halves = abs(newton - u) <= abs(step) * 0.5;
            let next = if from < newton && newton < to && halves { newton } else { middle(from, to) };
            step = next - u;
            if step == 0.0 || next == from || next == to {
                return next;
            }
            u = next;
            if abs(step) < SHORT * SHORT {
                let short = short_fraction(u);
                if self.from <= short && short <= self.to && value_and_slope(p, short).0 == 0.0 {
                    return short;
                }
            }
        }
        u
    }
}

/// The number of steps that lead from a double to full precision, unless roots nearly coincide.
const MOST_REFINEMENTS: usize = 5;
/// After a step that is this small relative to the root, no further one is needed.
const LAST: f64 = 1e-40;
/// The relative distance from a root at which a polynomial with well separated roots has changed sign.
const BESIDE: f64 = 1e-55;

/// The search tries multiples of this fraction as exact roots.
const SHORT: f64 = 1.0 / (1 << 20) as f64;

/// The nearest multiple of [`SHORT`]. Roots of model problems are often such multiples, and are then found exactly, including
/// multiple roots, to which Newton's method converges slowly.
fn short_fraction<L: Leaf>(u: L) -> L {
    L::from((u.re() / SHORT).round() * SHORT)
}

/// The polynomial without zero leading coefficients.
fn trimmed<L: Leaf>(p: &[L]) -> &[L] {
    let degree = p.iter().rposition(|&c| c != 0.0).map_or(0, |k| k + 1);
    &p[..degree]
}

fn derivative<L: Leaf>(p: &[L]) -> ArrayVec<L, 5> {
    let powers = [1.0, 2.0, 3.0, 4.0, 5.0];
    p.iter().skip(1).zip(powers).map(|(&c, power)| c * power).collect()
}

/// Horner's scheme.
fn value_and_slope<L: Leaf>(p: &[L], u: L) -> (L, L) {
    p.iter().rev().fold((L::zero(), L::zero()), |(value, slope), &c| (value * u + c, slope * u + value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use crate::number::power::power_of_two;

    #[test]
    fn a_short_root_is_met_exactly_where_three_merge() {
        // (1/4 − u)³ (1 + u²) falls through 0.
        let p = [1.0, -12.0, 49.0, -76.0, 48.0, -64.0].map(|c| Octuple::from(c / 64.0));
        let at = |u: f64| value_and_slope(&p, Octuple::from(u)).0;
        let ends = [-1.0, 1.0];
        assert_eq!(falling(&p, ends.map(Octuple::from), ends.map(at)).as_slice(), [Octuple::from(0.25)]);
    }

    fn bracket(p: &[Octuple], ends: [f64; 2]) -> Bracket<Octuple> {
        let [from, to] = ends.map(Octuple::from);
        let [low, high] = [from, to].map(|u| value_and_slope(p, u).0);
        Bracket { from, to, low, high }
    }

    #[test]
    fn a_root_very_near_a_short_fraction_but_not_on_it_stays_where_it_is() {
        let root = Octuple::from(0.25) + power_of_two(-200);
        let p = [root, Octuple::from(-1.0)];
        assert_eq!(bracket(&p, [-1.0, 1.0]).refined(&p), Some(root));
        let p = [Octuple::from(0.25), Octuple::from(-1.0)];
        assert_eq!(bracket(&p, [-1.0, 1.0]).refined(&p), Some(Octuple::from(0.25)));
    }

    /// Another root may be this close.
    #[test]
    fn a_short_root_outside_of_the_bracket_is_not_taken() {
        let [other, root] = [0.5, 0.5 + 2.0_f64.powi(-30)].map(Octuple::from);
        let p = [other * root, -(other + root), Octuple::from(1.0)];
        let beyond = bracket(&p, [0.5 + 2.0_f64.powi(-31), 1.0]);
        assert!([beyond.searched(&p), beyond.crossing(&p)].iter().all(|&u| abs(u - root) < 1e-60));
        assert_eq!(bracket(&p, [0.25, 0.5 + 2.0_f64.powi(-31)]).crossing(&p), other);
    }

    #[test]
    fn from_the_root_in_doubles_few_steps_lead_to_all_digits() {
        let p = [2.0, 0.0, -1.0].map(Octuple::from);
        let root = bracket(&p, [1.0, 2.0]).refined(&p).unwrap();
        assert!(abs(root * root - 2.0) < 1e-70);
        assert_eq!(bracket(&p, [1.0, 2.0]).crossing(&p), root);
    }

    /// Newton's method converges slowly to a triple root, and at a root at an end there is no sign beyond it.
    #[test]
    fn what_is_no_simple_root_between_the_ends_is_not_refined() {
        // (1/3 − u)³
        let third = Octuple::from(1.0) / 3.0;
        let p = [third * third * third, -(third * third * 3.0), third * 3.0, Octuple::from(-1.0)];
        assert_eq!(bracket(&p, [-1.0, 1.0]).refined(&p), None);
        let root = bracket(&p, [-1.0, 1.0]).crossing(&p);
        assert!(abs(root - third) < 1e-20, "{:e}", (root - third).to_f64());
        for ends in [[0.25, 1.0], [0.0, 0.25]] {
            let p = [Octuple::from(0.25), Octuple::from(-1.0)];
            assert_eq!(bracket(&p, ends).refined(&p), None);
        }
    }

    #[test]
    fn values_of_0_at_the_ends_are_no_roots_and_one_inside_counts_once() {
        let falling = |p: [f64; 6], ends: [f64; 2]| falling(&p, ends, ends.map(|u| value_and_slope(&p, u).0)).to_vec();
        let line = [1.0, -1.0, 0.0, 0.0, 0.0, 0.0];
        assert_eq!((falling(line, [0.0, 1.0]), falling(line, [1.0, 2.0])), (vec![], vec![]));
        assert_eq!((falling(line, [0.0, 4.0]), falling([0.0; 6], [0.0, 1.0])), (vec![1.0], vec![]));
        // −(u + 1) u (u − 1) rises at 0, between two falls; (u − 1)² (3 − u) only touches 0 at 1, which counts.
        assert_eq!(falling([0.0, 1.0, 0.0, -1.0, 0.0, 0.0], [-2.0, 2.0]), [-1.0, 1.0]);
        assert_eq!(falling([3.0, -7.0, 5.0, -1.0, 0.0, 0.0], [0.0, 4.0]), [1.0, 3.0]);
        // −u (u² − 1) (u² − 4), with five roots, and its opposite.
        assert_eq!(falling([0.0, -4.0, 0.0, 5.0, 0.0, -1.0], [-3.0, 3.0]), [-2.0, 0.0, 2.0]);
        assert_eq!(falling([0.0, 4.0, 0.0, -5.0, 0.0, 1.0], [-3.0, 3.0]), [-1.0, 1.0]);
    }

    #[test]
    fn polynomials_are_evaluated_derived_and_trimmed() {
        assert_eq!(value_and_slope(&[1.0, 2.0, 3.0], 2.0), (17.0, 14.0));
        assert_eq!(derivative(&[7.0, 1.0, 1.0, 1.0, 1.0, 1.0]).as_slice(), [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!((trimmed(&[0.0, 1.0, 0.0, 0.0]), trimmed(&[0.0; 3])), (&[0.0, 1.0][..], &[][..]));
        assert_eq!([0.3, -0.3, 0.75].map(|u| short_fraction(u) * 1_048_576.0), [314_573.0, -314_573.0, 786_432.0]);
    }
}
