//! Medians and other quantiles of measurements.

use super::{Errors, Quantiles, Time};

/// The smallest number that at least `fraction` of the sorted numbers do not exceed; 0 if there are none.
fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a position in a list of measurements"
    )]
    let rank = (fraction * sorted.len() as f64).ceil() as usize;
    let last = sorted.len().max(1);
    sorted.get(rank.clamp(1, last) - 1).copied().unwrap_or(0.0)
}

impl Quantiles {
    /// From numbers in any order.
    pub(super) fn of(mut errors: Vec<f64>) -> Self {
        errors.sort_by(f64::total_cmp);
        let at = |fraction| quantile(&errors, fraction);
        Self { median: at(0.5), p99: at(0.99), max: at(1.0) }
    }
}

impl Time {
    /// From samples in any order; `None` if there are none.
    pub(super) fn of(mut samples: Vec<f64>) -> Option<Self> {
        samples.sort_by(f64::total_cmp);
        let at = |fraction| quantile(&samples, fraction);
        (!samples.is_empty()).then(|| Self { median: at(0.5), low: at(0.1), high: at(0.9) })
    }
}

impl Errors {
    /// From η and the relative error at each point; points where either is infinite are counted separately.
    pub(super) fn of(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let (mut etas, mut relatives, mut not_finite) = (Vec::new(), Vec::new(), 0);
        for (eta, relative) in points {
            if eta.is_finite() && relative.is_finite() {
                etas.push(eta);
                relatives.push(relative);
            } else {
                not_finite += 1;
            }
        }
        let points = etas.len() + not_finite;
        Self { points, not_finite, eta: Quantiles::of(etas), relative: Quantiles::of(relatives).median }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_members_of_the_set() {
        let hundred: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!(Quantiles::of(hundred.clone()), Quantiles { median: 50.0, p99: 99.0, max: 100.0 });
        assert_eq!(Time::of(hundred), Some(Time { median: 50.0, low: 10.0, high: 90.0 }));
        assert_eq!(Quantiles::of(vec![3.0]), Quantiles { median: 3.0, p99: 3.0, max: 3.0 });
        assert_eq!(Quantiles::of(vec![2.0, 1.0]), Quantiles { median: 1.0, p99: 2.0, max: 2.0 });
    }

    #[test]
    fn of_nothing_there_is_no_time_and_no_error() {
        assert_eq!(Time::of(Vec::new()), None);
        assert_eq!(Quantiles::of(Vec::new()), Quantiles::default());
    }

    #[test]
    fn points_without_a_finite_result_are_counted_and_left_out() {
        let errors = Errors::of([(1.0, 0.5), (f64::INFINITY, 2.0), (3.0, 0.25)]);
        assert_eq!((errors.points, errors.not_finite), (3, 1));
        assert_eq!((errors.eta.max, errors.relative), (3.0, 0.25));
    }
}
