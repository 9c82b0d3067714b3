//! The claim "the closed form is faster than automatic differentiation, and at least as accurate", formula by formula.

use jointproof::toolkit::measure::{Figures, Measurement, Time};

/// A run's verdict on the claim.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Verdict {
    /// Time of automatic differentiation relative to the closed form.
    pub(crate) speedup: f64,
    /// The verdict on speed.
    pub(crate) speed: Speed,
    /// Whether the closed form is at least as accurate.
    pub(crate) accurate: bool,
    /// Largest η of the closed form and of automatic differentiation, at random and hard points.
    pub(crate) eta: [f64; 2],
}

/// Which is faster, the closed form or automatic differentiation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Speed {
    /// The closed form, beyond the spread of both or by a quarter.
    Faster,
    /// Neither, within the spread of both, or within a nanosecond, which is the cost of the loop around them.
    Same,
    /// Automatic differentiation, beyond the spread of both or by a quarter.
    Slower,
}

/// A median that is larger by this factor is no chance, whatever the spread.
const CLEARLY: f64 = 1.25;

/// The difference of η that two correct roundings of one number can have.
const ROUNDING: f64 = 0.5;

/// The η of a few roundings.
const FEW: f64 = 8.0;

impl Verdict {
    /// The verdict on a complete measurement.
    pub(crate) fn of(measurement: &Measurement) -> Option<Self> {
        let jacobian = |id| measurement.method(id)?.jacobian.as_ref();
        let (closed, ad) = (jacobian("closed")?, jacobian("ad")?);
        let times = (closed.time?, ad.time?);
        let eta = [greatest(closed), greatest(ad)];
        let accurate = failures(closed) <= failures(ad) && eta[0] <= eta[1] + ROUNDING;
        Some(Self { speedup: times.1.median / times.0.median, speed: speed(times.0, times.1), accurate, eta })
    }

    /// Whether the claim holds without qualification.
    pub(crate) fn holds(&self) -> bool {
        self.speed == Speed::Faster && self.accurate
    }

    /// The claim in a word or two.
    pub(crate) fn in_short(&self) -> &'static str {
        match (self.speed, self.accurate) {
            (Speed::Faster, true) => "yes",
            (Speed::Same, true) => "as fast",
            (Speed::Slower, true) => "slower",
            (Speed::Faster, false) => "less accurate",
            (_, false) => "no",
        }
    }

    /// Why the claim does not hold; empty if it does.
    pub(crate) fn exception(&self) -> String {
        let speed = match self.speed {
            Speed::Faster => None,
            Speed::Same => Some(
                "equally fast within the spread: the computation is so short that the compiler generates the same code for both"
                    .to_owned(),
            ),
            Speed::Slower => Some(format!(
                "automatic differentiation takes {:.2} of the closed form's time: the Jacobian is mostly constants, \
                 which the compiler also optimises",
                self.speedup
            )),
        };
        let [closed, ad] = self.eta;
        let accuracy = (!self.accurate).then(|| {
            let why = if closed.max(ad) <= FEW {
                "both errors are a few roundings, in a different order"
            } else {
                "terms cancel in both, and are summed in a different order"
            };
            format!("η of the closed form is up to {closed:.2}, of automatic differentiation {ad:.2}: {why}")
        });
        speed.into_iter().chain(accuracy).collect::<Vec<_>>().join("; ")
    }
}

fn speed(closed: Time, ad: Time) -> Speed {
    let beats = |one: Time, other: Time| one.high < other.low || one.median * CLEARLY < other.median;
    if (closed.median - ad.median).abs() < 1.0 {
        Speed::Same
    } else if beats(closed, ad) {
        Speed::Faster
    } else if beats(ad, closed) {
        Speed::Slower
    } else {
        Speed::Same
    }
}

fn greatest(figures: &Figures) -> f64 {
    let hard = figures.hard.map_or(0.0, |hard| hard.eta.max);
    figures.random.eta.max.max(hard)
}

fn failures(figures: &Figures) -> usize {
    figures.random.not_finite + figures.hard.map_or(0, |hard| hard.not_finite)
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::toolkit::measure::{Errors, Quantiles};

    fn time(low: f64, median: f64, high: f64) -> Time {
        Time { median, low, high }
    }

    #[test]
    fn speeds_are_told_apart_beyond_their_spread_only() {
        assert_eq!(speed(time(4.0, 5.0, 6.0), time(30.0, 31.0, 32.0)), Speed::Faster);
        assert_eq!(speed(time(30.0, 31.0, 32.0), time(4.0, 5.0, 6.0)), Speed::Slower);
        assert_eq!(speed(time(9.0, 10.0, 13.0), time(11.0, 12.0, 14.0)), Speed::Same);
        let [short, long, longer] = [20.0, 24.0, 26.0].map(|median| time(10.0, median, 40.0));
        assert_eq!([speed(short, long), speed(short, longer)], [Speed::Same, Speed::Faster]);
        assert_eq!([speed(long, short), speed(longer, short)], [Speed::Same, Speed::Slower]);
        assert_eq!(speed(time(1.4, 1.4, 1.4), time(0.7, 0.7, 0.7)), Speed::Same, "less than a nanosecond apart");
        assert_eq!(speed(time(4.0, 4.0, 4.0), time(5.0, 5.0, 5.0)), Speed::Faster, "a nanosecond apart");
        // Touching spreads, and a quarter to the last bit.
        assert_eq!(speed(time(90.0, 100.0, 104.0), time(104.0, 105.0, 106.0)), Speed::Same);
        assert_eq!(speed(time(10.0, 20.0, 40.0), time(10.0, 25.0, 40.0)), Speed::Same);
    }

    /// The verdict on a measurement with altered closed form and automatic differentiation.
    fn of(tamper: impl FnOnce(&mut Figures, &mut Figures)) -> Verdict {
        let mut measurement = crate::sample::measurement("t.first", 1.0);
        let [closed, _, _, ad, ..] = measurement.methods.as_mut_slice() else { panic!("there are seven ways") };
        tamper(closed.jacobian.as_mut().unwrap(), ad.jacobian.as_mut().unwrap());
        Verdict::of(&measurement).unwrap()
    }

    #[test]
    fn as_accurate_is_within_a_rounding() {
        for (closed, ad, accurate) in
            [(5.0, 5.0, true), (5.5, 5.0, true), (5.5_f64.next_up(), 5.0, false), (7.0, 5.0, false), (5.0, 9.0, true)]
        {
            let verdict = of(|one, other| (one.random.eta.max, other.random.eta.max) = (closed, ad));
            assert_eq!((verdict.accurate, verdict.eta), (accurate, [closed, ad]));
        }
    }

    #[test]
    fn as_accurate_is_without_more_failures() {
        // At random and at hard points.
        for (closed, ad, accurate) in [
            ((0, Some(0)), (0, Some(0)), true),
            ((2, Some(0)), (1, Some(1)), true),
            ((0, Some(2)), (2, Some(0)), true),
            ((0, None), (0, Some(0)), true),
            ((2, Some(1)), (1, Some(1)), false),
            ((1, Some(2)), (2, Some(0)), false),
            ((1, None), (0, None), false),
            ((0, Some(1)), (2, Some(3)), true),
        ] {
            let set = |figures: &mut Figures, (random, hard)| {
                figures.random.not_finite = random;
                figures.hard = figures.hard.zip(hard).map(|(errors, not_finite)| Errors { not_finite, ..errors });
            };
            let verdict = of(|one, other| {
                set(one, closed);
                set(other, ad);
            });
            assert_eq!(verdict.accurate, accurate, "{closed:?} {ad:?}");
        }
    }

    #[test]
    fn the_claim_is_of_speed_and_of_accuracy() {
        let said = |speed, accurate| {
            let verdict = Verdict { speedup: 2.0, speed, accurate, eta: [1.0; 2] };
            (verdict.holds(), verdict.in_short())
        };
        let speeds = [Speed::Faster, Speed::Same, Speed::Slower];
        assert_eq!(speeds.map(|speed| said(speed, true)), [(true, "yes"), (false, "as fast"), (false, "slower")]);
        assert_eq!(speeds.map(|speed| said(speed, false)), [(false, "less accurate"), (false, "no"), (false, "no")]);
        assert_eq!(of(|_, ad| ad.time = Some(time(55.0, 55.0, 55.0))).speedup, 2.0);
    }

    #[test]
    fn the_greatest_error_is_of_random_and_hard_points_where_there_are_any() {
        let of = |max: f64| Quantiles { max, ..Quantiles::default() };
        let errors = |max| Errors { points: 1, not_finite: 0, eta: of(max), relative: 0.0 };
        let figures = |hard: Option<f64>| Figures {
            time: None,
            ratio: None,
            hard_times: Vec::new(),
            random: errors(0.25),
            hard: hard.map(errors),
        };
        assert_eq!([None, Some(0.125), Some(2.0)].map(|hard| greatest(&figures(hard))), [0.25, 0.25, 2.0]);
    }

    #[test]
    fn an_exception_says_why() {
        let why = |speed, accurate, eta| Verdict { speedup: 0.5, speed, accurate, eta }.exception();
        assert_eq!(why(Speed::Faster, true, [1.0, 2.0]), "");
        assert!(why(Speed::Slower, true, [1.0, 2.0]).starts_with("automatic differentiation takes 0.50 of"));
        let few = why(Speed::Faster, false, [3.0, 2.0]);
        assert_eq!(
            few,
            "η of the closed form is up to 3.00, of automatic differentiation 2.00: both errors are a few roundings, in a different order"
        );
        assert_eq!(why(Speed::Faster, false, [8.0, 7.0]).split(": ").last(), few.split(": ").last());
        for eta in [[90.0, 2.0], [3.0, 50.0], [8.0_f64.next_up(), 7.0]] {
            assert!(
                why(Speed::Faster, false, eta).ends_with("terms cancel in both, and are summed in a different order")
            );
        }
        assert_eq!(why(Speed::Same, false, [3.0, 2.0]).split("; ").count(), 2);
    }
}
