//! The accuracy of a formula for inputs of very different sizes.

use super::accuracy::{Exact, check_accuracy, claims};
use super::claim::Claim;
use super::point::{Names, Options, Point, random_points};
use super::sample::{DOUBLINGS, Sampler};
use super::subject::Subject;
use crate::Octuple;
use crate::formula::quantity::{Domain, Quantity};
use crate::number::power::{exponent, power_of_two};
use num_traits::Signed;

/// One out of this many random points is rescaled.
const EVERY: usize = 25;
/// The number of attempts to find valid inputs with sizes in the range and results that doubles can represent.
const TRIES: usize = 64;

/// Checks the bounds of η of value and Jacobian at some of these random points after rescaling; `before` other points
/// precede them.
pub(super) fn scaled(subject: &Subject, names: &Names, points: &[Point], before: usize, seed: u64) -> Vec<Claim> {
    let some = (before..).zip(points).filter(|(k, _)| k % EVERY == 0);
    check(subject, names, Range { scale: subject.spec.scale, seed }, some)
}

/// Checks the bounds of η of value and Jacobian at points whose inputs are 0 or from 1/`scale` to `scale` in size.
pub(crate) fn eta_at_scale(subject: &Subject, scale: f64, options: &Options) -> Vec<Claim> {
    let &Options { samples, seed } = options;
    let points = random_points(subject, options, 0..samples);
    check(subject, &Names::new(subject), Range { scale, seed }, (0..).zip(&points))
}

fn check<'a>(
    subject: &Subject,
    names: &Names,
    range: Range,
    points: impl Iterator<Item = (usize, &'a Point<'a>)>,
) -> Vec<Claim> {
    let spec = subject.spec.scale(range.scale);
    let (mut value, mut jacobian) = claims(&spec, &format!(", at sizes {}", spec.sizes()));
    for (point, exact) in points.filter_map(|(k, point)| range.draw(point, k)) {
        check_accuracy(&mut value, jacobian.as_mut(), &point, names, &exact);
    }
    [value].into_iter().chain(jacobian).collect()
}

/// A range of sizes, and the seed of the draws from it.
#[derive(Clone, Copy)]
struct Range {
    scale: f64,
    seed: u64,
}

impl Range {
    /// Whether the size of a component is in the range.
    fn has(self, x: f64) -> bool {
        x == 0.0 || (1.0 / self.scale..=self.scale).contains(&x.abs())
    }

    /// The rescaled point with its exact results. Points do not depend on which others are drawn.
    fn draw<'a>(self, from: &Point<'a>, k: usize) -> Option<(Point<'a>, Exact)> {
        let subject = from.subject;
        let mut sampler = Sampler::named(&format!("{} scaled {k}", subject.spec.id), self.seed);
        (0..TRIES).find_map(|_| {
            let inputs = resized(subject, &from.inputs, self.scale, &mut sampler);
            if !inputs.iter().all(|&x| self.has(x)) || (subject.check)(&inputs).is_err() {
                return None;
            }
            let point = Point::new(subject, format!("{} at another size", from.label), false, inputs);
            let exact = Exact::at(&point);
            let is_double = |x: &Octuple| x.abs() <= Octuple::from(f64::MAX);
            exact.values.iter().chain(&exact.ad).all(is_double).then_some((point, exact))
        })
    }
}

/// Rescales inputs, either by changing the units of length, force and time, or by a separate factor for every field.
/// Directions stay the same, and angles only become smaller.
fn resized(subject: &Subject, inputs: &[f64], scale: f64, sampler: &mut Sampler) -> Vec<f64> {
    let units = [(); 3].map(|()| power(scale, sampler));
    let are_units_changed = sampler.below(2) == 0;
    let mut components = inputs.iter();
    let mut all = Vec::with_capacity(inputs.len());
    for field in subject.inputs {
        let own = power(scale, sampler);
        let power = match field.quantity.domain {
            Domain::Direction | Domain::Triad(..) => 0,
            Domain::Angle | Domain::Between(..) | Domain::Within(..) | Domain::HalfOpen(..) => -own.abs(),
            _ if are_units_changed => in_units(field.quantity, units),
            _ => own,
        };
        // Two factors, since a single power of two may not be representable.
        let (half, rest) = (power_of_two(power / 2), power_of_two(power - power / 2));
        all.extend(components.by_ref().take(field.len()).map(|x| x * half * rest));
    }
    all
}

fn in_units(quantity: &Quantity, units: [i64; 3]) -> i64 {
    let powers = [quantity.unit.length, quantity.unit.force, quantity.unit.time];
    powers.iter().zip(units).map(|(&power, unit)| i64::from(power) * unit).sum::<i64>().clamp(-2000, 2000)
}

/// A power of two: the largest for which the draws stay within the scale, or any smaller one.
fn power(scale: f64, sampler: &mut Sampler) -> i64 {
    let most = (exponent(scale) - DOUBLINGS).max(0);
    match sampler.below(4) {
        0 => -most,
        1 => most,
        _ => sampler.whole(-most..=most),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_its_ends_and_zero() {
        let range = Range { scale: 8.0, seed: 0 };
        let [inside, outside] =
            [[0.0, 0.125, -0.125, 8.0, -8.0], [1e-300, 0.125_f64.next_down(), 8.0_f64.next_up(), -9.0, f64::NAN]];
        assert!(inside.into_iter().all(|x| range.has(x)) && !outside.into_iter().any(|x| range.has(x)));
    }

    use crate::connector::slot::{ContactForce, RelativePosition};
    use crate::connector::ujoint::Stop;
    use crate::contact::coulomb::Response;
    use crate::formula::quantity::Unit;

    /// The exponents of two by which components changed.
    fn powers(inputs: &[f64], scale: f64, sampler: &mut Sampler, subject: &Subject) -> Vec<i64> {
        let resized = resized(subject, inputs, scale, sampler);
        resized.iter().zip(inputs).map(|(x, before)| exponent(x / before)).collect()
    }

    /// Up to 2³⁰, which leaves 2¹⁰ for the draws themselves.
    #[test]
    fn powers_reach_as_far_as_the_scale_allows_and_no_farther() {
        let mut sampler = Sampler::named("powers", 1);
        let mut of = |scale: f64, count: usize| (0..count).map(|_| power(scale, &mut sampler)).collect::<Vec<_>>();
        let drawn = of(2.0_f64.powi(30), 400);
        assert_eq!((drawn.iter().min(), drawn.iter().max()), (Some(&-20), Some(&20)));
        let inner = drawn.iter().filter(|power| power.abs() < 20).count();
        // Each end is drawn in a quarter of the cases, and something in between in the rest.
        assert!((120..280).contains(&inner), "{inner}");
        assert!([-20, 20].iter().all(|end| drawn.iter().filter(|power| *power == end).count() > 60));
        assert!((-5..5).all(|power| drawn.contains(&power)));
        assert_eq!(of(2.0, 50), [0; 50]);
    }

    #[test]
    fn directions_stay_and_positions_are_resized_together_or_each_by_itself() {
        let subject = Subject::of::<RelativePosition>();
        let mut sampler = Sampler::named("resized", 1);
        let mut ways = [0, 0];
        for _ in 0..40 {
            let powers = powers(&[1.5; 15], 1e30, &mut sampler, &subject);
            assert_eq!(powers[..9], [0; 9]);
            let (xa, xb) = (&powers[9..12], &powers[12..]);
            assert!(xa.iter().all(|power| *power == xa[0]) && xb.iter().all(|power| *power == xb[0]));
            ways[usize::from(xa[0] == xb[0])] += 1;
        }
        assert!(ways.iter().all(|&count| count > 5), "{ways:?}");
    }

    #[test]
    fn angles_become_smaller_alone() {
        let subject = Subject::of::<Stop>();
        let mut sampler = Sampler::named("angles", 1);
        let angles: Vec<_> = (0..20).flat_map(|_| powers(&[0.5; 6], 1e30, &mut sampler, &subject)).collect();
        assert!(angles.iter().all(|&power| power <= 0) && angles.iter().any(|&power| power < -50), "{angles:?}");
    }

    #[test]
    fn units_are_multiplied_as_a_quantity_has_them() {
        let of = |unit: Unit| in_units(&Quantity::scalar("q", unit, Domain::Real, "any"), [3, 50, 700]);
        assert_eq!([Unit::L, Unit::F, Unit::T, Unit::ONE].map(of), [3, 50, 700, 0]);
        assert_eq!([Unit::new(-2, 1, 0), Unit::new(1, 0, -1)].map(of), [44, -697]);
        // Beyond the range of doubles, one exponent is as good as another.
        assert_eq!([Unit::new(0, 0, 3), Unit::new(0, 0, -3)].map(of), [2000, -2000]);
    }

    #[test]
    fn some_points_are_taken_to_another_size_and_named_so() {
        let subject = Subject::of::<ContactForce>();
        let (options, names) = (Options { samples: 0, seed: 1 }, Names::new(&subject));
        let checks = |before: usize, end: usize| {
            let points = random_points(&subject, &options, before..end);
            scaled(&subject, &names, &points, before, 1).into_iter().map(|claim| claim.checks).collect::<Vec<_>>()
        };
        // Value and two derivatives, alone and together, at the points 0, 25 and 50.
        assert_eq!(
            (checks(0, 1), checks(1, 25), checks(1, 26), checks(0, 51)),
            (vec![2, 4], vec![0, 0], vec![2, 4], vec![6, 12])
        );
        let claims = eta_at_scale(&subject, 1e6, &Options { samples: 3, seed: 1 });
        let [value, jacobian] = <[Claim; 2]>::try_from(claims).expect("the Jacobian is in closed form");
        assert_eq!((value.claim.as_str(), value.bound), ("η of the value in f64, at sizes from 1/1e6 to 1e6", 1.0));
        assert!(jacobian.claim.starts_with("η of the closed-form Jacobian in f64"), "{}", jacobian.claim);
        assert_eq!((value.checks, jacobian.checks), (6, 12));
        assert!(value.worst.expect("it was checked").point.ends_with(" of seed 1 at another size"));
    }

    #[test]
    fn what_is_drawn_is_of_the_range_and_exact() {
        let subject = Subject::of::<ContactForce>();
        let from = Point::new(&subject, "there".into(), true, vec![3.0, -4.0]);
        let range = Range { scale: 1e6, seed: 1 };
        let drawn: Vec<_> = (0..50).filter_map(|k| range.draw(&from, k)).collect();
        assert_eq!(drawn.len(), 50);
        assert!(drawn.iter().all(|(point, _)| point.inputs.iter().all(|&x| range.has(x)) && !point.random));
        assert!(drawn.iter().any(|(point, _)| point.inputs[0] != drawn[0].0.inputs[0]));
        let (point, exact) = &drawn[7];
        let again = range.draw(&from, 7).expect("it was drawn before").0;
        assert_eq!(again.inputs, point.inputs);
        assert_eq!(exact.values, (subject.exact_value)(&point.exact));
    }

    /// Powers beyond the range of doubles, applied in two factors.
    #[test]
    fn inputs_are_resized_by_powers_that_are_drawn() {
        let subject = Subject::of::<ContactForce>();
        let mut sampler = Sampler::named("powers", 1);
        for (scale, most) in [(2.0_f64.powi(30), 20), (f64::MAX, 1013)] {
            let drawn: Vec<_> = (0..60).flat_map(|_| powers(&[1.5; 2], scale, &mut sampler, &subject)).collect();
            assert_eq!((drawn.iter().min(), drawn.iter().max()), (Some(&-most), Some(&most)));
        }
    }

    /// A stiffness scales with the units of force and length, which may take it out of range.
    #[test]
    fn what_is_out_of_range_or_overflows_is_not_drawn() {
        let subject = Subject::of::<Response>();
        let from = Point::new(&subject, "there".into(), true, vec![3.0, 2.0, 1000.0, 0.5, 7.0]);
        let range = Range { scale: 1e6, seed: 1 };
        let drawn: Vec<_> = (0..50).filter_map(|k| range.draw(&from, k)).collect();
        assert!(drawn.len() > 40 && drawn.iter().all(|(point, _)| point.inputs.iter().all(|&x| range.has(x))));
        let subject = Subject::of::<ContactForce>();
        let from = Point::new(&subject, "there".into(), true, vec![2000.0, 2000.0]);
        let range = Range { scale: f64::MAX, seed: 1 };
        let drawn: Vec<_> = (0..50).filter_map(|k| range.draw(&from, k)).collect();
        assert!(drawn.len() > 40 && drawn.iter().all(|(_, exact)| exact.values[0].to_f64().is_finite()));
    }

    #[test]
    fn a_point_is_resized_alike_whoever_asks() {
        let subject = Subject::of::<ContactForce>();
        let options = Options { samples: 1, seed: 1 };
        let points = random_points(&subject, &options, 0..1);
        let asked = eta_at_scale(&subject, subject.spec.scale, &options);
        assert_eq!(scaled(&subject, &Names::new(&subject), &points, 0, 1), asked);
    }
}
