//! The claim that nothing overflows for inputs of the sizes that the formula states, checked at inputs drawn to break it.

use super::claim::Claim;
use super::point::{Names, Point};
use super::sample::Sampler;
use super::subject::Subject;
use crate::formula::Finite;
use crate::number::power::{exponent, power_of_two};

/// The number of draws from each point of the audit.
const DRAWS: usize = 4;

/// The formula's claim about overflow, checked at inputs derived from these points, which `before` others precede;
/// `None` if there is no such claim.
pub(super) fn claim(subject: &Subject, names: &Names, points: &[Point], before: usize, seed: u64) -> Option<Claim> {
    let smallest = match subject.spec.finite {
        Finite::Unknown => return None,
        Finite::Below => f64::MIN_POSITIVE,
        Finite::Between => Finite::SMALLEST,
    };
    let mut claim = Claim::new("nothing overflows at inputs of the size that is stated, of so many results", 0.0);
    let mut draw = Extremes { sampler: Sampler::for_formula(subject.spec.id, !seed), smallest };
    draw.skip(before * DRAWS, names.inputs.len());
    for point in points {
        for _ in 0..DRAWS {
            let inputs = draw.beside(&point.inputs);
            if (subject.check)(&inputs).is_err() {
                continue;
            }
            let [value, jacobian] = (subject.linearized)(&inputs);
            let results = value.iter().chain(&jacobian);
            for (k, &result) in results.enumerate() {
                let entry = || k.checked_sub(value.len()).map_or_else(|| names.outputs[k].clone(), |k| names.entry(k));
                let at = |size| {
                    Point::new(subject, draw.label(&point.label), false, inputs.clone()).deviation(
                        size,
                        entry(),
                        result,
                        0.0,
                    )
                };
                claim.record(if result.is_finite() { 0.0 } else { f64::MAX }, 0.0, at);
            }
        }
    }
    Some(claim)
}

/// A source of inputs at the limits of the stated sizes.
struct Extremes {
    sampler: Sampler,
    smallest: f64,
}

impl Extremes {
    fn label(&self, from: &str) -> String {
        format!("extremes of {from}, from {:e} on", self.smallest)
    }

    /// Skips the draws for this many points and components; they do not depend on the components' values.
    fn skip(&mut self, points: usize, components: usize) {
        let point = vec![0.0; components];
        for _ in 0..points {
            self.beside(&point);
        }
    }

    /// The point with some components replaced: by 0, by another component or nearly that, so that they cancel, by the
    /// smallest and the largest number allowed, and by any number in between.
    fn beside(&mut self, point: &[f64]) -> Vec<f64> {
        let often = 1 + self.sampler.below(8);
        let mut inputs = point.to_vec();
        for k in 0..inputs.len() {
            if self.sampler.below(8) < often {
                let other = inputs[self.sampler.below(inputs.len())];
                let replaced = self.number(other);
                if replaced == 0.0 || (self.smallest..Finite::LARGEST).contains(&replaced.abs()) {
                    inputs[k] = replaced;
                }
            }
        }
        inputs
    }

    fn number(&mut self, other: f64) -> f64 {
        let size = match self.sampler.below(7) {
            0 => 0.0,
            1 => other,
            2 => other.next_up(),
            3 => other.next_down(),
            4 => self.smallest,
            5 => Finite::LARGEST.next_down(),
            _ => self.between(),
        };
        if self.sampler.below(2) == 0 { size } else { -size }
    }

    /// Every power of two is equally likely.
    fn between(&mut self) -> f64 {
        let drawn = self.sampler.whole(exponent(self.smallest)..=exponent(Finite::LARGEST) - 1);
        power_of_two(drawn) * (1.0 + self.sampler.unit())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields;
    use crate::formula::proof::Proved;
    use crate::formula::quantity::{K_STICK, MU, P, X};
    use crate::formula::{Component, Document, Formula, Jacobian, Spec};
    use crate::number::scalar::Scalar;
    use crate::toolkit::verify::Options;
    use crate::toolkit::verify::point::random_points;

    fields! { struct Divisor<T> { k: T = K_STICK, x: T = X } }
    fields! { struct Quotient<T> { mu: T = MU, p: T = P } }

    /// x, and k to the power of −10 or −1, whose derivative has k to the power of −11 or −2. Small as k may be, the value is a
    /// double, and the derivative is not.
    #[derive(Clone, Copy)]
    struct Power<const TENTH: bool, const BELOW: bool>;

    impl<const TENTH: bool, const BELOW: bool> Formula for Power<TENTH, BELOW> {
        const SPEC: Spec = Spec::new("planted.power", "Power", Document::new("None").printed("")).finite(if BELOW {
            Finite::Below
        } else {
            Finite::Between
        });
        type Inputs<T: Component> = Divisor<T>;
        type Outputs<T: Component> = Quotient<T>;
        fn eval<D: Scalar>(i: &Divisor<D>) -> Quotient<D> {
            Quotient { mu: i.x, p: i.k.recip().powi(if TENTH { 10 } else { 1 }) }
        }
        fn jacobian<D: Scalar>(i: &Divisor<D>) -> Jacobian<Self, D> {
            let by_k = -i.k.recip().powi(if TENTH { 11 } else { 2 });
            let (zero, one) = (D::zero(), D::one());
            Quotient { mu: Divisor { k: zero, x: one }, p: Divisor { k: by_k, x: zero } }
        }
    }
    impl<const TENTH: bool, const BELOW: bool> Proved for Power<TENTH, BELOW> {}

    fn claimed<F: Proved>(before: usize, points: usize) -> Option<Claim> {
        let subject = Subject::of::<F>();
        let points = random_points(&subject, &Options { samples: 0, seed: 1 }, before..before + points);
        claim(&subject, &Names::new(&subject), &points, before, 1)
    }

    #[test]
    fn a_derivative_that_overflows_is_found_and_named_at_the_smallest_numbers_that_are_stated() {
        for found in [claimed::<Power<true, false>>(0, 20), claimed::<Power<false, true>>(0, 20)] {
            let found = found.expect("something is stated");
            let worst = found.worst.as_ref().expect("it was checked");
            assert!(found.failures > 0 && !worst.found.is_finite(), "{found:?}");
            assert_eq!((worst.size, worst.entry.as_str()), (f64::MAX, "∂p/∂k"));
            assert_eq!((found.bound, worst.expected), (0.0, 0.0));
        }
        let at = |found: Option<Claim>| found.and_then(|claim| claim.worst).expect("it was checked").point;
        let (between, below) = (at(claimed::<Power<true, false>>(0, 20)), at(claimed::<Power<false, true>>(0, 20)));
        assert!(
            between.starts_with("extremes of random ")
                && between.ends_with(" of seed 1, from 7.888609052210118e-31 on")
        );
        assert!(below.ends_with("from 2.2250738585072014e-308 on"), "{below}");
    }

    /// Inputs with a divisor that is 0 or negative are not allowed, and are skipped.
    #[test]
    fn nothing_overflows_where_inputs_are_large_enough() {
        let held = claimed::<Power<false, false>>(0, 20).expect("something is stated");
        assert!(held.held(), "{held:?}");
        // Two values and four derivatives at up to four draws from each point.
        assert!(held.checks.is_multiple_of(6) && (6 * 20..6 * 20 * DRAWS).contains(&held.checks), "{}", held.checks);
    }

    #[test]
    fn what_is_drawn_does_not_depend_on_what_others_looked_at() {
        type Found = Power<true, false>;
        let [one, next, all] = [(0, 7), (7, 5), (0, 12)].map(|(before, points)| claimed::<Found>(before, points));
        assert_eq!(one.zip(next).map(|(one, next)| one.and(next)), all);
    }

    #[test]
    fn nothing_is_claimed_where_nothing_is_stated() {
        #[derive(Clone, Copy)]
        struct Silent;
        impl Formula for Silent {
            const SPEC: Spec = Spec { finite: Finite::Unknown, ..Power::<false, false>::SPEC };
            type Inputs<T: Component> = Divisor<T>;
            type Outputs<T: Component> = Quotient<T>;
            fn eval<D: Scalar>(i: &Divisor<D>) -> Quotient<D> {
                Power::<false, false>::eval(i)
            }
            fn jacobian<D: Scalar>(i: &Divisor<D>) -> Jacobian<Self, D> {
                Power::<false, false>::jacobian(i)
            }
        }
        impl Proved for Silent {}
        assert_eq!(claimed::<Silent>(0, 3), None);
    }

    #[test]
    fn components_are_replaced_by_extremes_each_other_and_what_is_nearly_so() {
        for smallest in [Finite::SMALLEST, f64::MIN_POSITIVE] {
            let mut extremes = Extremes { sampler: Sampler::named("extremes", 1), smallest };
            let point = [3.0, 5.0, 7.0];
            let drawn: Vec<_> = (0..2000).map(|_| extremes.beside(&point)).collect();
            let is_allowed = |x: f64| x == 0.0 || (smallest..Finite::LARGEST).contains(&x.abs());
            assert!(drawn.iter().flatten().all(|&x| is_allowed(x)));
            let is_there = |x: f64| drawn.iter().any(|inputs| inputs[1] == x);
            let neighbours = [3.0, 7.0].into_iter().flat_map(|x: f64| [x, x.next_up(), x.next_down()]);
            let ends = [0.0, 5.0, smallest, Finite::LARGEST.next_down()];
            for x in neighbours.chain(ends) {
                assert!(is_there(x) && is_there(-x), "{x} is never drawn");
            }
            // Some are left unchanged, and in some everything is replaced.
            assert!(drawn.iter().any(|inputs| inputs == &point));
            assert!(drawn.iter().any(|inputs| inputs.iter().zip(point).all(|(x, old)| *x != old)));
        }
    }

    #[test]
    fn sizes_between_have_every_power_of_two() {
        let mut extremes = Extremes { sampler: Sampler::named("powers", 1), smallest: power_of_two(120) };
        let drawn: Vec<_> = (0..200).map(|_| extremes.between()).collect();
        let mut powers: Vec<_> = drawn.iter().map(|&x| exponent(x)).collect();
        powers.sort_unstable();
        powers.dedup();
        assert_eq!(powers, (120..128).collect::<Vec<_>>());
    }
}
