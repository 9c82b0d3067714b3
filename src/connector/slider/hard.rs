//! Lines that are numerically hard, positions of node m on and off them, and lines at which pivots change; every formula of the
//! slider is tested there.

use crate::Octuple;
use crate::formula::Formula;
use crate::formula::proof::Kink;
use crate::number::scalar::abs;
use nalgebra::{SVector, Vector2, Vector3};

/// A line from x1 to xn, and the reason why it is hard.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HardLine<const N: usize> {
    pub(crate) id: &'static str,
    pub(crate) comment: &'static str,
    pub(crate) x1: SVector<f64, N>,
    pub(crate) xn: SVector<f64, N>,
}

impl<const N: usize> HardLine<N> {
    fn new(id: &'static str, comment: &'static str, x1: [f64; N], xn: [f64; N]) -> Self {
        Self { id, comment, x1: x1.into(), xn: xn.into() }
    }

    /// The point (1 − ξ) x1 + ξ xn, to rounding.
    pub(crate) fn at(&self, xi: f64) -> SVector<f64, N> {
        self.x1 + (self.xn - self.x1) * xi
    }

    /// Arbitrary increments of nodes 1 and n, in proportion to the line.
    pub(crate) fn motion(&self) -> [SVector<f64, N>; 2] {
        [[0.01, -0.02, 0.035], [-0.015, 0.03, 0.0125]].map(|motion| self.scaled(motion))
    }

    /// Named positions of node m: on the line inside and far outside the segment, near and at node n, and off the line.
    pub(crate) fn places(&self) -> [(&'static str, SVector<f64, N>); 6] {
        [
            ("", self.at(0.375)),
            ("-near-n", self.at(0.9375)),
            ("-far-out", self.at(1e6)),
            ("-far-back", self.at(-1e6)),
            ("-aside", self.at(0.75) + self.scaled([0.5, -0.25, 0.375])),
            ("-at-n", self.xn),
        ]
    }

    fn scaled(&self, pattern: [f64; 3]) -> SVector<f64, N> {
        SVector::from_fn(|axis, _| pattern[axis % 3]) * (self.xn - self.x1).amax()
    }
}

/// Every line with node m on it, and again with m at one of the harder positions in turn, with names.
pub(crate) fn scenes<const N: usize>(lines: Vec<HardLine<N>>) -> Vec<(String, HardLine<N>, SVector<f64, N>)> {
    let of_line = |(turn, line): (usize, HardLine<N>)| {
        let places = line.places();
        [0, 1 + turn % 5].map(|k| (format!("{}{}", line.id, places[k].0), line, places[k].1))
    };
    lines.into_iter().enumerate().flat_map(of_line).collect()
}

/// Lines in space: nearly along ±i, along the axes, at ties of the pivots and one ulp from them, with common offsets,
/// short and long ones, and one whose ends are of very different size.
pub(crate) fn lines() -> Vec<HardLine<3>> {
    let origin = [0.0; 3];
    let from_origin = |id, comment, xn| HardLine::new(id, comment, origin, xn);
    let tilted = "nearly along i: t1 and t2 turn wildly, what is constrained does not";
    let axis = "along an axis";
    let tie = "a tie of the pivot rule";
    let beside = "one ulp beside a tie of the pivot rule";
    let offset = "common offset: the difference must be taken before any product";
    vec![
        from_origin("tilt-1e-16", tilted, [1.0, 0.75e-16, -0.5e-16]),
        from_origin("tilt-1e-12", tilted, [1.0, -0.5e-12, -0.75e-12]),
        from_origin("tilt-1e-8", tilted, [1.0, 0.75e-8, 0.5e-8]),
        from_origin("tilt-1e-4", tilted, [1.0, 0.5e-4, 0.75e-4]),
        from_origin("reversed-tilt-1e-16", tilted, [-1.0, 0.5e-16, 0.75e-16]),
        from_origin("reversed-tilt-1e-8", tilted, [-1.0, -0.75e-8, 0.5e-8]),
        HardLine::new("tilt-one-ulp", tilted, [0.25, 0.5, 0.75], [1.25, 0.5_f64.next_up(), 0.75]),
        from_origin("along-i", "along i exactly: t1 and t2 jump", [2.0, 0.0, 0.0]),
        from_origin("against-i", "against i exactly: t1 and t2 jump", [-2.0, 0.0, 0.0]),
        from_origin("along-j", axis, [0.0, 2.0, 0.0]),
        from_origin("against-k", axis, [0.0, 0.0, -2.0]),
        from_origin("diagonal", tie, [1.0, 1.0, 1.0]),
        from_origin("face-diagonal-xy", tie, [1.0, -1.0, 0.0]),
        from_origin("face-diagonal-yz", tie, [0.0, -1.0, -1.0]),
        from_origin("extremal", "both comparisons tie, and |n_k| = 1/√6", [2.0, 1.0, 1.0]),
        from_origin("second-tie", "p² + q² = p |d1|, q < p", [-5.0, 2.0, 4.0]),
        from_origin("extremal-above", beside, [2.0_f64.next_up(), 1.0, 1.0_f64.next_down()]),
        from_origin("extremal-below", beside, [2.0_f64.next_down(), 1.0, 1.0_f64.next_up()]),
        from_origin("second-tie-above", beside, [-5.0_f64.next_up(), 2.0, 4.0]),
        from_origin("second-tie-below", beside, [-5.0_f64.next_down(), 2.0, 4.0]),
        HardLine::new(
            "rounded-tie",
            "|d2| and |d3| differ by less than their rounding",
            [0.0, 0.5, 0.1],
            [1.0, 0.8, 0.4],
        ),
        HardLine::new("offset-1e8", offset, [1e8, -1e8, 1e8], [1e8 + 0.75, -1e8 - 0.5, 1e8 + 0.4375]),
        HardLine::new("offset-1e12", offset, [1e12, -1e12, 1e12], [1e12 + 0.4375, -1e12 - 0.5, 1e12 + 0.75]),
        HardLine::new(
            "offset-tilt",
            offset,
            [1e12, -1e12, 1e12],
            [1e12 + 1e3, -1e12 - 0.000_488_281_25, 1e12 + 0.000_976_562_5],
        ),
        from_origin("length-1e-12", "a short line", [0.75e-12, -0.5e-12, 0.4375e-12]),
        from_origin("length-1e12", "a long line", [0.75e12, -0.5e12, 0.4375e12]),
        from_origin("length-1e-200", "squares underflow", [2e-200, 3e-200, 6e-200]),
        from_origin("length-1e200", "squares overflow", [6e200, -2e200, 3e200]),
        HardLine::new(
            "far-end",
            "node 1 is far away: where m is near n, only distances from n are small",
            [1e12, -2e12, 0.5e12],
            [0.3, 0.2, -0.1],
        ),
    ]
}

/// The lines in the plane.
pub(crate) fn plane_lines() -> Vec<HardLine<2>> {
    let from_origin = |id, comment, xn| HardLine::new(id, comment, [0.0; 2], xn);
    let tilted = "nearly along an axis";
    let axis = "along an axis";
    let tie = "a tie of the pivot rule";
    let beside = "one ulp beside a tie of the pivot rule";
    let offset = "common offset: the difference must be taken before any product";
    vec![
        from_origin("tilt-1e-16", tilted, [1.0, 1e-16]),
        from_origin("tilt-1e-8", tilted, [1e-8, -1.0]),
        from_origin("along-x", axis, [2.0, 0.0]),
        from_origin("against-y", axis, [0.0, -2.0]),
        from_origin("diagonal", tie, [1.0, -1.0]),
        from_origin("diagonal-above", beside, [1.0_f64.next_up(), 1.0]),
        from_origin("diagonal-below", beside, [1.0_f64.next_down(), 1.0]),
        HardLine::new("rounded-tie", "|d1| and |d2| differ by less than their rounding", [0.1, 0.5], [0.4, 0.8]),
        HardLine::new("offset-1e8", offset, [1e8, -1e8], [1e8 + 0.75, -1e8 - 0.5]),
        HardLine::new("offset-1e12", offset, [1e12, -1e12], [1e12 + 0.4375, -1e12 - 0.5]),
        from_origin("length-1e-12", "a short line", [0.75e-12, -0.5e-12]),
        from_origin("length-1e12", "a long line", [0.75e12, -0.5e12]),
        from_origin("length-1e-200", "squares underflow", [3e-200, 4e-200]),
        from_origin("length-1e200", "squares overflow", [-4e200, 3e200]),
        HardLine::new(
            "far-end",
            "node 1 is far away: where m is near n, only distances from n are small",
            [1e12, -2e12],
            [0.3, 0.2],
        ),
    ]
}

/// The kinks where the documented pivots change, for any formula that depends on them, at lines from the origin: `line` is
/// xn − x1 of inputs, `at` gives inputs with this xn, and `across` those in which only xn is not 0.
pub(crate) fn changes_of_pivots<F: Formula>(
    line: fn(&F::Inputs<Octuple>) -> Vector3<Octuple>,
    at: fn(Vector3<f64>) -> F::Inputs<f64>,
    across: fn(Vector3<f64>) -> F::Inputs<f64>,
) -> Vec<Kink<F>> {
    // i may be axis 2 or 3.
    let first = |d: &Vector3<Octuple>| abs(d.y) == abs(d.z);
    // j may be axis 1 or the longer one of i and k.
    let second = |d: &Vector3<Octuple>| {
        let p = if abs(d.y) > abs(d.z) { abs(d.y) } else { abs(d.z) };
        d.y * d.y + d.z * d.z == p * abs(d.x)
    };
    vec![
        Kink::switch(
            r"\lvert d_2\rvert = \lvert d_3\rvert",
            move |i| first(&line(i)),
            at(Vector3::new(1.0, 2.0, 2.0)),
            across(Vector3::z()),
        ),
        Kink::switch(
            r"d_2^2 + d_3^2 = \lvert d_1\rvert\max(\lvert d_2\rvert,\lvert d_3\rvert)",
            move |i| second(&line(i)),
            at(Vector3::new(-5.0, 2.0, 4.0)),
            across(-Vector3::x()),
        ),
    ]
}

/// The kink where the pivot in the plane changes.
pub(crate) fn change_of_pivot<F: Formula>(
    line: fn(&F::Inputs<Octuple>) -> Vector2<Octuple>,
    at: fn(Vector2<f64>) -> F::Inputs<f64>,
    across: fn(Vector2<f64>) -> F::Inputs<f64>,
) -> Vec<Kink<F>> {
    vec![Kink::switch(
        r"\lvert d_1\rvert = \lvert d_2\rvert",
        move |i| abs(line(i).x) == abs(line(i).y),
        at(Vector2::new(2.0, -2.0)),
        across(Vector2::x()),
    )]
}
