//! The printed equation at a point, in 237 bits: its values, its Jacobian by dual numbers, and whether what it calls
//! smallest is so.

use super::claim::{Claim, Deviation};
use super::eta::Sensitivity;
use super::jet::differentiate;
use crate::Octuple;
use crate::equation::{Equation, SmallestAt};
use num_traits::{Signed, Zero};

/// The printed equation and the code agree in 237 bits to this.
pub(super) const EQUATION: f64 = 1e-55;

/// What an equation gives.
pub(super) struct Found<'a> {
    equation: &'a Equation,
    point: Vec<Octuple>,
    /// The derivative of the slope that vanishes by the place of something smallest, how that place moves with each
    /// input, and by the place the derivative of each output.
    curvature: Octuple,
    motion: Vec<Octuple>,
    by_place: Vec<Octuple>,
    values: Vec<Octuple>,
    /// The entries, output by output.
    jacobian: Vec<Octuple>,
    /// Numbers that are printed as equal.
    equal: Vec<(Octuple, Octuple)>,
    /// By how much another place is better than the one that should be best, relatively.
    better: Option<f64>,
}

/// So many steps between its bounds are tried for a better place.
const STEPS: u8 = 24;

/// An equation at inputs. Where an output is the place of something smallest, `known` are the outputs, from which it
/// is taken and then checked.
pub(super) fn found<'a>(equation: &'a Equation, inputs: &[Octuple], known: &[Octuple]) -> Found<'a> {
    let point = equation.point(inputs, known);
    let mut at = equation.run(&point);
    let rows = differentiate(&point, &|moved| {
        let at = equation.run(moved);
        at.outputs.into_iter().chain(at.smallest.map(|smallest| smallest.slope)).collect()
    });
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
    /// Compares the values, and what the equation itself says is equal or smallest. `size` says what rounding of the
    /// inputs can do to a value.
    pub(super) fn record_values(
        &self,
        claim: &mut Claim,
        values: &[Octuple],
        size: impl Fn(usize) -> Sensitivity,
        names: &[String],
        describe: impl Fn(f64, String, f64, f64) -> Deviation,
    ) {
        for (output, &value) in values.iter().enumerate() {
            let found = self.values[output];
            let share = match Sensitivity::none().plus(value).share_of(found - value) {
                share if share > EQUATION => judged(size(output).plus(value), found - value, || self.terms(output)),
                share => share,
            };
            let entry = || names[output].clone();
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

    /// Compares the Jacobian; every entry is judged against itself and, where that is too strict, against what rounding
    /// of the inputs can do to it, its bend.
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

    /// Against which rounding is judged: the size of the terms from which an output is summed.
    fn terms(&self, output: usize) -> Octuple {
        let terms = self.equation.terms_of_output(output, None, &self.point);
        if self.curvature.is_zero() {
            return terms;
        }
        terms + (self.equation.terms_of_slope(None, &self.point) / self.curvature).abs()
    }

    /// The same of an entry of the Jacobian.
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

/// A deviation relative to the size of the number; where that would be too much, relative to the terms too from which
/// the equation sums it: evaluated as it stands, it may lose digits that the code keeps.
fn judged(size: Sensitivity, deviation: Octuple, terms: impl FnOnce() -> Octuple) -> f64 {
    match size.share_of(deviation) {
        share if share > EQUATION => size.plus(terms()).share_of(deviation),
        share => share,
    }
}

/// The place of something smallest, by one step of Newton's method from where it is known to be, and how it moves with
/// the inputs. At a bound it stays, if the objective rises from there.
fn settled(smallest: &SmallestAt<Octuple>, slopes: &[Octuple], motion: &mut [Octuple]) -> Octuple {
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

/// The relative excess of the objective over the best of some other places, 0 where none is better.
fn excess(equation: &Equation, smallest: &SmallestAt<Octuple>, mut point: Vec<Octuple>) -> Octuple {
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
