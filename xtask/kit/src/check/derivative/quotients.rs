//! Derivatives from differences: quotients at many steps, extrapolated to the step 0, with an error estimate of each.

/// The number of steps, each half of the one before.
pub(super) const STEPS: usize = 12;
/// The largest step, in parts of the size of an input.
pub(super) const FIRST: f64 = 1.0 / 64.0;
/// The most columns of an extrapolation.
const COLUMNS: usize = 6;

/// A derivative with an estimate of its error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// The derivatives at a point: by both sides, and if they agree by central differences.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    pub(super) central: Estimate,
    /// Behind the point, and before it.
    pub(super) sides: [Estimate; 2],
}

impl Slope {
    /// From the step and the values on both sides at every step, in order from the largest, and the value at the point.
    pub(super) fn new(steps: &[[f64; 2]], values: &[[f64; 2]], here: f64) -> Self {
        let size = values.iter().flatten().fold(here.abs(), |most, value| most.max(value.abs()));
        let central = quotients(
            steps,
            size,
            |k| (values[k][0] - values[k][1]) / (steps[k][0] + steps[k][1]),
            |k| steps[k][0] + steps[k][1],
        );
        let sides = [0, 1].map(|side| {
            let sign = if side == 0 { 1.0 } else { -1.0 };
            quotients(steps, size, |k| sign * (values[k][side] - here) / steps[k][side], |k| steps[k][side])
        });
        Self { central: extrapolated(&central, 4.0), sides: sides.map(|quotients| extrapolated(&quotients, 2.0)) }
    }

    /// Whether the derivative jumps here, by more than this and than the errors allow.
    pub(super) fn is_kink(&self, least: f64) -> bool {
        let [after, before] = self.sides;
        let apart = (after.value - before.value).abs();
        apart > 20.0 * (after.error + before.error) && apart > least
    }
}

/// Quotients with their rounding error.
fn quotients(
    steps: &[[f64; 2]],
    size: f64,
    quotient: impl Fn(usize) -> f64,
    step: impl Fn(usize) -> f64,
) -> Vec<Estimate> {
    (0..steps.len()).map(|k| Estimate { value: quotient(k), error: f64::EPSILON * size / step(k) }).collect()
}

/// Richardson's extrapolation, where an error is a power series in the step whose ratio from step to step is `ratio`. Of the
/// whole table the number is taken whose neighbours and rounding tell the least error.
fn extrapolated(quotients: &[Estimate], ratio: f64) -> Estimate {
    let mut best = Estimate { value: f64::NAN, error: f64::INFINITY };
    let mut last: Vec<f64> = Vec::new();
    for quotient in quotients {
        let mut row = vec![quotient.value];
        let mut power = 1.0;
        for column in 1..=last.len().min(COLUMNS) {
            power *= ratio;
            let (newer, older) = (row[column - 1], last[column - 1]);
            let value = newer + (newer - older) / (power - 1.0);
            let error = (value - newer).abs().max((value - older).abs()) + quotient.error;
            if error < best.error {
                best = Estimate { value, error };
            }
            row.push(value);
        }
        last = row;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(f: impl Fn(f64) -> f64, x: f64) -> Slope {
        let steps: Vec<_> = (0..STEPS).map(|k| [FIRST / f64::from(1 << k); 2]).collect();
        let values: Vec<_> = steps.iter().map(|[h, _]| [f(x + h), f(x - h)]).collect();
        Slope::new(&steps, &values, f(x))
    }

    #[test]
    fn a_smooth_derivative_has_ten_digits_and_its_error_is_not_underrated() {
        for (f, exact) in [
            (f64::sin as fn(f64) -> f64, 1.0_f64.cos()),
            (f64::exp, 1.0_f64.exp()),
            (|x| x * x * x, 3.0),
            (|x: f64| 1.0 / (1.0 + 25.0 * x * x), -50.0 / 26.0 / 26.0),
        ] {
            let Slope { central, .. } = slope(f, 1.0);
            let off = (central.value - exact).abs();
            assert!(off < 1e-10 * exact.abs() && off <= 3.0 * central.error, "{central:?} {exact}");
            assert!(!slope(f, 1.0).is_kink(1e-6));
        }
    }

    #[test]
    fn a_kink_is_told_from_its_neighbourhood() {
        let kink = slope(|x| if x > 1.0 { 3.0 * x } else { x + 2.0 }, 1.0);
        assert!(kink.is_kink(1e-6), "{kink:?}");
        assert!((kink.sides[0].value - 3.0).abs() < 1e-9 && (kink.sides[1].value - 1.0).abs() < 1e-9, "{kink:?}");
        let beside = slope(|x| if x > 1.001 { 3.0 * x } else { x + 2.002 }, 1.0);
        assert!(!beside.is_kink(1e-6) && (beside.central.value - 1.0).abs() < 1e-9, "{beside:?}");
    }
}
