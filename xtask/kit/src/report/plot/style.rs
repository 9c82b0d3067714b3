//! How methods are told apart in plots: by colour, and by the outline of a mark or the dashes of a line.

use crate::plot::{power, rounded};

/// The style of a method in a plot, and its name there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    /// The colour.
    pub(super) class: &'static str,
    /// The outline, relative to the centre.
    pub(super) shape: &'static str,
    /// A short name; that of the method itself if empty.
    pub(super) name: &'static str,
}

const CIRCLE: &str = "m-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z";
/// Thin, since it surrounds the mark of another.
const RING: &str = "m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0zm1.5 0a4 4 0 1 1 8 0a4 4 0 1 1-8 0z";
const SQUARE: &str = "m-4-4h8v8h-8z";
const DIAMOND: &str = "m0-5.5 5.5 5.5-5.5 5.5-5.5-5.5z";
const UP: &str = "m0-5 5 8.6h-10z";
const DOWN: &str = "m0 5-5-8.6h10z";
const BAR: &str = "m-5.5-2h11v4h-11z";
const PLUS: &str = "m-1.7-5h3.4v3.3h3.3v3.4h-3.3v3.3h-3.4v-3.3h-3.3v-3.4h3.3z";
const HOURGLASS: &str = "m-4.5-4.5h9l-9 9h9z";

/// The style of a method.
pub(super) fn style(id: &str) -> Style {
    let (class, shape, name) = match id {
        "closed" => ("method-closed", CIRCLE, "closed form"),
        "checked" => ("method-closed", RING, "checked"),
        "single" => ("method-single", SQUARE, "single"),
        "ad" => ("method-ad", UP, "AD"),
        "complex" => ("method-ad", DIAMOND, "complex step"),
        "forward" => ("method-difference", DIAMOND, "forward"),
        "central" => ("method-difference", PLUS, "central"),
        "fourth" => ("method-difference", BAR, "4th order"),
        "forward-fixed" => ("method-difference", SQUARE, "forward, fixed step"),
        "central-fixed" => ("method-difference", UP, "central, fixed step"),
        "fourth-fixed" => ("method-difference", DOWN, "4th order, fixed step"),
        "octuple" => ("method-octuple", CIRCLE, "237 bits"),
        "octuple-ad" => ("method-octuple", UP, "AD, 237 bits"),
        _ => ("method-own", if id.len().is_multiple_of(2) { DOWN } else { HOURGLASS }, ""),
    };
    Style { class, shape, name }
}

/// Nanoseconds as axis labels: 10 ns, 1 µs, 10 ms.
pub(super) fn time(nanoseconds: f64) -> String {
    let exponent = rounded(nanoseconds.log10());
    let units = ["ps", "ns", "µs", "ms", "s"];
    let unit = usize::try_from(exponent.div_euclid(3) + 1).ok().and_then(|k| units.get(k));
    let number = 10_i32.pow(exponent.rem_euclid(3).unsigned_abs());
    unit.map_or_else(|| format!("{} ns", power(exponent)), |unit| format!("{number} {unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_times_read_well() {
        assert_eq!([-12, -1, 1, 6].map(power), ["10⁻¹²", "0.1", "10", "10⁶"]);
        let times = [0.1, 1.0, 10.0, 1e3, 1e5, 1e6].map(time);
        assert_eq!(times, ["100 ps", "1 ns", "10 ns", "1 µs", "100 µs", "1 ms"]);
    }
}
