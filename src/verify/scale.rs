//! How accurate a formula is at inputs of very different sizes.

use super::accuracy::{Exact, check_accuracy};
use super::claim::Claim;
use super::point::{Names, Options, Point, random_points};
use super::sample::{DOUBLINGS, Sampler};
use super::subject::Subject;
use crate::Octuple;
use crate::power::{exponent, power_of_two};
use crate::proof::Proved;
use crate::quantity::{Domain, Quantity};
use num_traits::Signed;

/// One of so many random points is taken to another size.
const EVERY: usize = 25;
/// So many sizes are tried until inputs are valid, of a size in the range, and have results that doubles can hold.
const TRIES: usize = 64;

/// The bounds of η of value and Jacobian, at some of these random points taken to other sizes; there are so many others before.
pub(super) fn scaled(subject: &Subject, names: &Names, points: &[Point], before: usize, seed: u64) -> [Claim; 2] {
    let some = (before..).zip(points).filter(|(k, _)| k % EVERY == 0);
    check(subject, names, Range { scale: subject.spec.scale, seed }, some)
}

/// The bounds of η of value and Jacobian, at so many points whose inputs are 0 or from 1/`scale` to `scale` in size.
pub fn eta_at_scale<F: Proved>(scale: f64, options: &Options) -> [Claim; 2] {
    at_scale(&Subject::of::<F>(), scale, options)
}

fn at_scale(subject: &Subject, scale: f64, options: &Options) -> [Claim; 2] {
    let &Options { samples, seed } = options;
    let points = random_points(subject, options, 0..samples);
    check(subject, &Names::new(subject), Range { scale, seed }, (0..).zip(&points))
}

fn check<'a>(
    subject: &Subject,
    names: &Names,
    range: Range,
    points: impl Iterator<Item = (usize, &'a Point<'a>)>,
) -> [Claim; 2] {
    let spec = subject.spec.scale(range.scale);
    let claim = |of, bound| Claim::new(format!("η of {of} in f64, at sizes {}", spec.sizes()), bound);
    let mut value = claim("the value", spec.eta);
    let mut jacobian = claim("the closed-form Jacobian", spec.eta_jacobian);
    for (point, exact) in points.filter_map(|(k, point)| range.draw(point, k)) {
        check_accuracy([&mut value, &mut jacobian], &point, names, &exact);
    }
    [value, jacobian]
}

/// Sizes, and what is drawn from them.
#[derive(Clone, Copy)]
struct Range {
    scale: f64,
    seed: u64,
}

impl Range {
    /// Whether a component has a size of the range.
    fn has(self, x: f64) -> bool {
        x == 0.0 || (1.0 / self.scale..=self.scale).contains(&x.abs())
    }

    /// The point at another size, and what is exact there. Points do not depend on which others are drawn.
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

/// Inputs with units of their own for length, force and time, or with a size of its own for every field. Directions stay as they
/// are, and angles only become smaller.
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
        // Two factors, since the power of one may be no double.
        let (half, rest) = (power_of_two(power / 2), power_of_two(power - power / 2));
        all.extend(components.by_ref().take(field.len()).map(|x| x * half * rest));
    }
    all
}

fn in_units(quantity: &Quantity, units: [i64; 3]) -> i64 {
    let powers = [quantity.unit.length, quantity.unit.force, quantity.unit.time];
    powers.iter().zip(units).map(|(&power, unit)| i64::from(power) * unit).sum::<i64>().clamp(-2000, 2000)
}

/// Of two: as far as what is drawn stays within the scale, or any below.
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
}
