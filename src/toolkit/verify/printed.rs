//! The printed equation at a point, in 237 bits: its values, its Jacobian, and whether its minimisers are minimisers.

use super::claim::{Claim, Deviation};
use super::eta::Sensitivity;
use crate::Octuple;
use crate::toolkit::equation::{Equation, SmallestAt};
use num_traits::{Signed, Zero};

/// The tolerance between the printed equation and the code in 237 bits.
pub(super) const EQUATION: f64 = 1e-55;

/// The results of an equation.
pub(super) struct Found<'a> {
    equation: &'a Equation,
    point: Vec<Octuple>,
    /// The derivative of the vanishing slope with respect to the minimiser, the derivative of the minimiser with
    /// respect to each input, and the derivative of each output with respect to the minimiser.
    curvature: Octuple,
    motion: Vec<Octuple>,
    by_place: Vec<Octuple>,
    values: Vec<Octuple>,
    /// The entries, output by output.
    jacobian: Vec<Octuple>,
    /// Numbers that are printed as equal.
    equal: Vec<(Octuple, Octuple)>,
    /// The relative amount by which another point is better than the supposed minimiser.
    better: Option<f64>,
}

/// The number of steps between the bounds at which a better point is sought.
const STEPS: u8 = 24;

/// Evaluates an equation at inputs. If an output is a minimiser, it is taken from the outputs `known` and then
/// checked.
pub(super) fn found<'a>(equation: &'a Equation, inputs: &[Octuple], known: &[Octuple]) -> Found<'a> {
    let point = equation.point(inputs, known);
    let mut at = equation.run(&point);
    let rows = equation.gradients(&at, &point);
    let (rows, slopes) = rows.split_at(at.outputs.len());
    let mut motion = vec![Octuple::zero(); inputs.len()];
    if let (Some(smallest), Some(slope)) = (&at.smallest, slopes.first()) {
        at.outputs[smallest.output] = settled(smallest, slope, &mut motion);
    }
    let by_place = |row: &Vec<Octuple>| row.get(inputs.len()).copied().unwrap_or_else(Octuple::zero);
    let total = |row: &Vec<Octuple>| -> Vec<Octuple> {
        row.iter().zip(&motion).map(|(&direct, &motion)| direct + by_place(row) * motion).collect()
    };
    let jacobian = rows.iter().flat_map(total).collect();
    let better = at.smallest.as_ref().map(|smallest| excess(equation, smallest, point.clone()).to_f64());
    Found {
        equation,
        point,
        curvature: slopes.first().map_or_else(Octuple::zero, by_place),
        by_place: rows.iter().map(by_place).collect(),
        motion,
        values: at.outputs,
        jacobian,
        equal: at.equal,
        better,
    }
}

impl Found<'_> {
    /// Compares the values, and what the equation itself states to be equal or a minimiser. `size` is the sensitivity
    /// of a value to the inputs.
    pub(super) fn record_values(
        &self,
        claim: &mut Claim,
        values: &[Octuple],
        size: impl Fn(usize) -> Sensitivity,
        names: &[String],
        describe: impl Fn(f64, String, f64, f64) -> Deviation,
    ) {
        for (output, (&place, &found)) in self.equation.places().iter().zip(&self.values).enumerate() {
            let value = values[place];
            let share = match Sensitivity::none().plus(value).share_of(found - value) {
                share if share > EQUATION => judged(size(place).plus(value), found - value, || self.terms(output)),
                share => share,
            };
            let entry = || names[place].clone();
            claim.record(share, EQUATION, |share| describe(share, entry(), found.to_f64(), value.to_f64()));
        }
        for &(first, next) in &self.equal {
            let share = Sensitivity::none().plus(first).plus(next).share_of(next - first);
            let entry = || "the form after the next sign of equality".into();
            claim.record(share, EQUATION, |share| describe(share, entry(), next.to_f64(), first.to_f64()));
        }
        if let Some(better) = self.better {
            let entry = || "the objective at a better place".into();
            claim.record(better, EQUATION, |share| describe(share, entry(), better, 0.0));
        }
    }

    /// Compares the Jacobian; every entry is judged relative to itself and, where that is too strict, relative to its
    /// sensitivity to the inputs.
    pub(super) fn record_jacobian(
        &self,
        claim: &mut Claim,
        closed: &[Octuple],
        bend: impl Fn(usize) -> Sensitivity,
        entry: impl Fn(usize) -> String,
        describe: impl Fn(f64, String, f64, f64) -> Deviation,
    ) {
        for (k, (&found, &closed)) in self.jacobian.iter().zip(closed).enumerate() {
            let share = match Sensitivity::none().plus(closed).share_of(found - closed) {
                share if share > EQUATION => judged(bend(k).plus(closed), found - closed, || self.terms_of_entry(k)),
                share => share,
            };
            claim.record(share, EQUATION, |share| describe(share, entry(k), found.to_f64(), closed.to_f64()));
        }
    }

    /// The size of the terms from which an output is summed, against which rounding is judged.
    fn terms(&self, output: usize) -> Octuple {
        let terms = self.equation.terms_of_output(output, None, &self.point);
        if self.curvature.is_zero() {
            return terms;
        }
        terms + (self.equation.terms_of_slope(None, &self.point) / self.curvature).abs()
    }

    /// The same for an entry of the Jacobian.
    fn terms_of_entry(&self, entry: usize) -> Octuple {
        let (output, input, place) = (entry / self.motion.len(), entry % self.motion.len(), self.motion.len());
        let direct = self.equation.terms_of_output(output, Some(input), &self.point);
        if self.motion[input].is_zero() {
            return direct;
        }
        let by_place = self.equation.terms_of_output(output, Some(place), &self.point);
        let slope = |by| self.equation.terms_of_slope(Some(by), &self.point);
        let motion = (slope(input) + slope(place) * self.motion[input].abs()) / self.curvature.abs();
        direct + by_place * self.motion[input].abs() + motion * self.by_place[output].abs()
    }
}

/// A deviation relative to the size of the number or, if that is too strict, also to the terms from which the equation
/// sums it: evaluated as printed, it may lose digits that the code keeps.
fn judged(size: Sensitivity, deviation: Octuple, terms: impl FnOnce() -> Octuple) -> f64 {
    match size.share_of(deviation) {
        share if share > EQUATION => size.plus(terms()).share_of(deviation),
        share => share,
    }
}

/// The minimiser, by one step of Newton's method from its known value, and its derivatives with respect to the inputs.
/// At a bound it stays if the objective increases from there.
fn settled(smallest: &SmallestAt, slopes: &[Octuple], motion: &mut [Octuple]) -> Octuple {
    let SmallestAt { place, low, high, slope, .. } = *smallest;
    let zero = Octuple::zero();
    if place == low && slope >= zero || place == high && slope <= zero {
        return place;
    }
    let Some(&curvature) = slopes.last().filter(|_| low < place && place < high) else {
        return Octuple::NAN;
    };
    for (motion, &by_input) in motion.iter_mut().zip(slopes) {
        *motion = -by_input / curvature;
    }
    place - slope / curvature
}

/// The relative excess of the objective over the best of some other points, 0 if none is better.
fn excess(equation: &Equation, smallest: &SmallestAt, mut point: Vec<Octuple>) -> Octuple {
    let last = point.len() - 1;
    let mut worst = Octuple::zero();
    for step in 0..=STEPS {
        point[last] = smallest.low + (smallest.high - smallest.low) * (f64::from(step) / f64::from(STEPS));
        let Some(there) = equation.run(&point).smallest else { continue };
        let excess = (smallest.objective - there.objective) / (smallest.objective + there.objective);
        worst = if excess > worst { excess } else { worst };
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::formula::quantity::{F2, F3, FC, SEGMENT_G, X};
    use crate::formula::{Field, Formula};

    fn smallest(place: f64, slope: f64) -> SmallestAt {
        let [place, low, high, objective, slope] = [place, -1.0, 1.0, 0.0, slope].map(Octuple::from);
        SmallestAt { output: 0, place, low, high, objective, slope }
    }

    #[test]
    fn a_place_stays_at_a_bound_from_which_the_objective_rises() {
        let slopes = [2.0, 3.0, 4.0].map(Octuple::from);
        let at = |place, slope| {
            let mut motion = [Octuple::zero(); 2];
            let settled = settled(&smallest(place, slope), &slopes, &mut motion).to_f64();
            (settled, motion.map(Octuple::to_f64))
        };
        for (place, slope) in [(-1.0, 0.0), (-1.0, 2.0), (1.0, 0.0), (1.0, -2.0)] {
            assert_eq!(at(place, slope), (place, [0.0; 2]), "{place} {slope}");
        }
        for (place, slope) in [(-1.0, -2.0), (1.0, 2.0), (-1.5, 2.0), (1.5, -2.0)] {
            assert!(at(place, slope).0.is_nan(), "{place} {slope}");
        }
        // A step of Newton's method, and the derivative of the minimiser with respect to each input.
        assert_eq!(at(0.5, 1.0), (0.25, [-0.5, -0.75]));
    }

    #[test]
    fn a_deviation_is_judged_by_its_terms_where_its_own_size_is_too_small() {
        let (one, deviation) = (Sensitivity::none().plus(1.0.into()), Octuple::from(1e-50));
        assert_eq!(judged(one, Octuple::from(1e-56), || panic!("it is small enough")), 1e-56);
        assert!((judged(one, deviation, || Octuple::from(9.0)) * 1e51 - 1.0).abs() < 1e-9);
    }

    const PLACE: [Field; 1] = [Field::new("g", &SEGMENT_G)];
    const NEAREST: &str = r"g = \operatorname*{arg\,min}_{-1\le g\le 1} (x-g)^2";

    #[test]
    fn the_place_of_something_smallest_is_settled_from_where_it_is_known_to_be() {
        let equation = Equation::in_place_of(&ContactForce::SPEC, NEAREST, &[Field::new("x", &X)], &PLACE)
            .expect("it can be read");
        let at = |x: f64, place: f64| {
            let found = found(&equation, &[x.into()], &[place.into()]);
            let numbers = [&found.values, &found.jacobian, &found.motion, &found.by_place];
            (numbers.map(|numbers| numbers[0].to_f64()), found.curvature.to_f64(), found.better)
        };
        assert_eq!(at(0.25, 0.25), ([0.25, 1.0, 1.0, 1.0], 2.0, Some(0.0)));
        // The minimiser is not the given one: a Newton step leads to it, and another point is better.
        let (numbers, curvature, better) = at(0.5, 0.0);
        assert_eq!((numbers, curvature), ([0.5, 1.0, 1.0, 1.0], 2.0));
        assert_eq!(better, Some(1.0));
        assert_eq!(at(3.0, 1.0), ([1.0, 0.0, 0.0, 1.0], 2.0, Some(0.0)));
    }

    fn described(size: f64, entry: String, found: f64, expected: f64) -> Deviation {
        let (point, inputs) = ("there".into(), serde_json::Value::Null);
        Deviation { size, entry, point, found, expected, inputs }
    }

    /// The comparison of the equation of a number at (3, 4) with this value of the code, whose sensitivity equals the
    /// value.
    fn recorded(latex: &str, value: Octuple) -> (usize, usize, Deviation) {
        let fields = [Field::new("f2", &F2), Field::new("f3", &F3)];
        let equation = Equation::in_place_of(&ContactForce::SPEC, latex, &fields, &[Field::new("fc", &FC)])
            .expect("it can be read");
        let (mut claim, point) = (Claim::new("so", EQUATION), [3.0, 4.0].map(Octuple::from));
        let size = |_| Sensitivity::none().plus(value);
        found(&equation, &point, &[]).record_values(&mut claim, &[value], size, &["fc".into()], described);
        (claim.checks, claim.failures, claim.worst.expect("it was compared"))
    }

    const ROOT: &str = r"F_C = \sqrt{f_2^2 + f_3^2}";

    #[test]
    fn values_are_judged_by_themselves_and_else_by_what_rounding_does() {
        let five = Octuple::from(5.0);
        let (checks, failures, worst) = recorded(ROOT, five);
        assert_eq!((checks, failures, worst.entry.as_str(), worst.found, worst.expected), (1, 0, "fc", 5.0, 5.0));
        let size = |part: f64| recorded(ROOT, five + five * part).2.size / part;
        // Within the bound relative to themselves; else relative to twice their size; and else also relative to the
        // terms, 5 or more.
        assert!((size(5e-56) - 1.0).abs() < 1e-9);
        assert!((size(1.5e-55) - 0.5).abs() < 1e-9);
        assert!((0.05..0.4).contains(&size(1e-30)), "{}", size(1e-30));
        assert_eq!(recorded(ROOT, 6.0.into()).1, 1);
    }

    #[test]
    fn forms_that_are_printed_as_equal_are_compared() {
        let (checks, failures, worst) = recorded(&format!("{ROOT} = f_2 + f_3"), 5.0.into());
        assert_eq!((checks, failures, worst.found, worst.expected), (2, 1, 7.0, 5.0));
        assert_eq!(worst.entry, "the form after the next sign of equality");
        assert_eq!(recorded(&format!(r"{ROOT} = \sqrt{{f_3^2 + f_2^2}}"), 5.0.into()).1, 0);
    }

    #[test]
    fn a_better_place_is_recorded_beside_the_values() {
        let equation = Equation::in_place_of(&ContactForce::SPEC, NEAREST, &[Field::new("x", &X)], &PLACE)
            .expect("it can be read");
        let recorded = |x: f64, place: f64| {
            let (mut claim, place) = (Claim::new("so", EQUATION), [Octuple::from(place)]);
            let size = |_| Sensitivity::none();
            found(&equation, &[x.into()], &place).record_values(&mut claim, &place, size, &["g".into()], described);
            (claim.checks, claim.failures, claim.worst.expect("it was compared"))
        };
        assert_eq!(recorded(0.25, 0.25).1, 0);
        // At the lower bound, which is among the points tried.
        let (checks, failures, worst) = recorded(-1.0, -0.5);
        assert_eq!((checks, failures, worst.size, worst.expected), (2, 2, 1.0, 0.0));
        assert_eq!(worst.entry, "the objective at a better place");
    }

    /// For the root, whose first derivative is 0.6.
    #[test]
    fn entries_of_the_jacobian_are_compared() {
        let fields = [Field::new("f2", &F2), Field::new("f3", &F3)];
        let equation = Equation::in_place_of(&ContactForce::SPEC, ROOT, &fields, &[Field::new("fc", &FC)])
            .expect("it can be read");
        let found = found(&equation, &[3.0, 4.0].map(Octuple::from), &[]);
        let off = |part: f64| {
            let mut claim = Claim::new("so", EQUATION);
            let closed = [Octuple::from(3.0) / 5.0 * (Octuple::from(1.0) + part), Octuple::from(4.0) / 5.0];
            let bend = |k: usize| Sensitivity::none().plus(closed[k]);
            found.record_jacobian(&mut claim, &closed, bend, |k| format!("entry {k}"), described);
            let worst = claim.worst.expect("it was compared");
            (claim.checks, claim.failures, worst.entry, worst.size / part)
        };
        let is_near = |(checks, failures, entry, size): (usize, usize, String, f64), expected: f64| {
            (checks, failures, entry.as_str()) == (2, 0, "entry 0") && (size - expected).abs() < 1e-9
        };
        assert!(is_near(off(5e-56), 1.0) && is_near(off(1.5e-55), 0.5));
        assert_eq!(off(1e-50).1, 1);
    }

    /// By hand at x = 1/4, f = −5 and g = 1/2. The error of every operation is one rounding of its result, plus the
    /// errors of its operands times its derivatives with respect to them:
    ///
    /// | number | value | terms |
    /// |---|---|---|
    /// | u = 3 x + g | 5/4 | 5/4 + 3/4 = 2 |
    /// | u + u | 5/2 | 5/2 + 2 · 2 = 13/2 |
    /// | the slope, f (u + u) | −25/2 | 25/2 + 5 · 13/2 = 45 |
    /// | its derivative with respect to x, f (3 + 3) | −30 | 30 + 5 · 6 = 60 |
    /// | with respect to f, u + u | 5/2 | 13/2 |
    /// | with respect to the minimiser, f (1 + 1) | −10 | 10 + 5 · 2 = 20 |
    /// | g³ = (g g) g | 1/8 | 1/8 + 1/2 · 1/4 = 1/4 |
    /// | F_C = f x − x g³ | −41/32 | 41/32 + 5/4 + (1/32 + 1/4 · 1/4) = 21/8 |
    /// | its derivative with respect to x, f − g³ | −41/8 | 41/8 + 1/4 = 43/8 |
    /// | with respect to f, x | 1/4 | 0 |
    /// | with respect to the minimiser, −x (g (g + g) + g g) | −3/16 | 3/16 + 1/4 · (3/4 + (1/2 + 1/2 · 1) + 1/4) = 11/16 |
    ///
    /// The derivative of the minimiser with respect to x is −30/10 = −3, and with respect to f it is (5/2)/10 = 1/4.
    #[test]
    fn terms_are_those_of_a_number_and_of_the_place_that_it_depends_on() {
        let fields = [Field::new("x", &X), Field::new("f2", &F2)];
        let latex = r"g = \operatorname*{arg\,min}_{-1\le g\le 1} f_2 (3 x+g)^2,\quad F_C = f_2 x - x g^3";
        let equation = Equation::in_place_of(&ContactForce::SPEC, latex, &fields, &[PLACE[0], Field::new("fc", &FC)]);
        let equation = equation.expect("it can be read");
        let found = found(&equation, &[0.25, -5.0].map(Octuple::from), &[0.5.into(), 0.0.into()]);
        let sizes = |of: &dyn Fn(Option<usize>) -> Octuple| [None, Some(0), Some(1), Some(2)].map(|by| of(by).to_f64());
        assert_eq!(sizes(&|by| equation.terms_of_slope(by, &found.point)), [45.0, 60.0, 6.5, 20.0]);
        assert_eq!(sizes(&|by| equation.terms_of_output(1, by, &found.point)), [2.625, 5.375, 0.0, 0.6875]);
        let place = [&found.curvature, &found.motion[0], &found.motion[1], &found.by_place[1]].map(|x| x.to_f64());
        assert_eq!(place, [-10.0, -3.0, 0.25, -0.1875]);
        let terms: Vec<_> = (0..2).map(|k| found.terms(k)).chain((0..4).map(|k| found.terms_of_entry(k))).collect();
        // The terms of the number itself, and those of the minimiser, on which the number depends.
        let by_x = (60.0 + 20.0 * 3.0) / 10.0;
        let by_f = (6.5 + 20.0 / 4.0) / 10.0;
        let expected = [4.5, 7.125, by_x, by_f, 5.375 + 0.6875 * 3.0 + by_x * 0.1875, 0.6875 / 4.0 + by_f * 0.1875];
        let is_close = |(found, expected): (&Octuple, f64)| (found.to_f64() - expected).abs() < 1e-12;
        assert!(terms.iter().zip(expected).all(is_close), "{terms:?} is not {expected:?}");
    }
}
