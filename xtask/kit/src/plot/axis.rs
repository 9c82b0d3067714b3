//! An axis of a plot.

/// An axis, linear or logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis<'a> {
    /// The quantity shown, with its unit.
    pub label: &'a str,
    /// The value at the left or the bottom.
    pub from: f64,
    /// The value at the right or the top; less than `from` to run backwards.
    pub to: f64,
    /// Whether it is logarithmic.
    pub logarithmic: bool,
    /// Values with a tick and a number.
    pub ticks: Vec<f64>,
}

impl<'a> Axis<'a> {
    /// A linear axis with round ticks that contains the values.
    pub fn linear(label: &'a str, values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        // A constant needs an interval of non-zero length.
        let margin = if high > low { 0.0 } else { high.abs().max(1e-300) * 0.5 };
        let (low, high) = (low - margin, high + margin);
        let rough = (high - low) / 5.0;
        let decade = 10_f64.powf(rough.log10().floor());
        let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * decade);
        let step = steps.into_iter().find(|&step| step >= rough).unwrap_or(rough);
        let (first, last) = ((low / step).floor(), (high / step).ceil());
        // Divided by the reciprocal if that is an integer, so that 0.1 × 3 is printed as 0.3.
        let tick = |k: f64| if step < 1.0 { k / (1.0 / step).round() } else { k * step };
        let mut ticks = Vec::new();
        let mut k = first;
        while k <= last && ticks.len() < 20 {
            ticks.push(tick(k));
            k += 1.0;
        }
        Self { label, from: first * step, to: last * step, logarithmic: false, ticks }
    }

    /// The shortest logarithmic axis between powers of ten that contains the values, at least a decade, with at most seven ticks;
    /// values of 0 or below `floor` count as `floor`.
    pub(crate) fn decades(label: &'a str, values: impl IntoIterator<Item = f64>, floor: f64) -> Self {
        let exponents = values.into_iter().map(|value| value.clamp(floor, 1e300).log10());
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = exponents.fold(none, |(low, high), exponent| (low.min(exponent), high.max(exponent)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let (low, high) = (rounded((low + 1e-9).floor()), rounded((high - 1e-9).ceil()));
        let high = high.max(low + 1);
        let stride = ((high - low) / 7 + 1).max(1);
        let labelled = (low..=high).filter(|exponent| exponent.rem_euclid(stride) == 0);
        let ticks = labelled.map(|exponent| 10_f64.powi(exponent)).collect();
        Self { label, from: 10_f64.powi(low), to: 10_f64.powi(high), logarithmic: true, ticks }
    }

    /// The position of a value between the ends, from 0 to 1.
    pub(super) fn share(&self, value: f64) -> f64 {
        let scale = |x: f64| if self.logarithmic { x.max(1e-300).log10() } else { x };
        (scale(value) - scale(self.from)) / (scale(self.to) - scale(self.from))
    }

    /// The coordinate of a value, from those of the ends; a value beyond an end is drawn there.
    pub(crate) fn at(&self, value: f64, [from, to]: [f64; 2]) -> f64 {
        from + self.share(value).clamp(0.0, 1.0) * (to - from)
    }

    /// The number at a tick.
    pub(crate) fn number(&self, value: f64) -> String {
        let exponent = value.log10();
        // A power of ten may be rounded, and so may its logarithm.
        if self.logarithmic && (exponent - exponent.round()).abs() < 1e-9 {
            return power(rounded(exponent));
        }
        let text = match value.abs() {
            size if size > 0.0 && !(1e-4..1e6).contains(&size) => format!("{value:.1e}").replace(".0e", "e"),
            _ => value.to_string(),
        };
        text.replace('-', "−")
    }
}

/// A rounded exponent of a double as an integer.
#[expect(clippy::cast_possible_truncation, reason = "exponents of doubles are small")]
pub(crate) fn rounded(exponent: f64) -> i32 {
    exponent.round() as i32
}

/// A power of ten with a raised exponent: 10⁻⁷; 0.1, 1, 10 and 100 as they are.
pub(crate) fn power(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(u32::from(digit) - u32::from('0') + u32::from('⁰')).unwrap_or(digit),
    };
    match exponent {
        -1 => "0.1".into(),
        0 => "1".into(),
        1 => "10".into(),
        2 => "100".into(),
        _ => format!("10{}", exponent.to_string().chars().map(raised).collect::<String>()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_all_values_and_put_zero_at_the_floor() {
        let axis = |values: &[f64]| Axis::decades("", values.iter().copied(), 0.1);
        let ends = |axis: Axis<'_>| [axis.from, axis.to];
        let wide = axis(&[0.0, 3e4]);
        assert_eq!((wide.at(0.0, [0.0, 100.0]), wide.at(1e6, [0.0, 100.0])), (0.0, 100.0));
        assert_eq!(ends(wide), [0.1, 1e5]);
        assert_eq!((ends(axis(&[])), ends(axis(&[10.0]))), ([1.0, 10.0], [10.0, 100.0]));
        assert_eq!(Axis::decades("", [1e-17, 100.0], 1e-17).ticks.len(), 6);
    }

    #[test]
    fn values_lie_where_their_axis_says() {
        let axis = |from, to| Axis { label: "", from, to, logarithmic: true, ticks: Vec::new() };
        assert_eq!((axis(1.0, 100.0).share(10.0), axis(100.0, 1.0).share(100.0)), (0.5, 0.0));
        assert_eq!(axis(1.0, 100.0).share(-1.0), -150.0);
        assert_eq!([1e-8, 0.5, 10.0].map(|x| axis(1.0, 100.0).number(x)), ["10⁻⁸", "0.5", "10"]);
        assert_eq!(Axis::linear("", [0.1, 0.9].into_iter()).ticks, [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        assert_eq!(
            [-3e-17, 0.0, -0.25, 2.5e6].map(|x| Axis::linear("", [0.0].into_iter()).number(x)),
            ["−3e−17", "0", "−0.25", "2.5e6"]
        );
        assert_eq!(Axis::linear("", [2.0].into_iter()).ticks, [1.0, 1.5, 2.0, 2.5, 3.0]);
    }
}
