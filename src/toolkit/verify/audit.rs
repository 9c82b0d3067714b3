//! The audit: every claim about a formula, checked at its cases, near its kinks and at random points.

use super::accuracy::{Exact, check_accuracy, claims};
use super::branches::Branches;
use super::claim::{Claim, Deviation};
use super::difference::{Differences, Direction, differences, largest_of_field};
use super::kinks::{self, Comparison, Examination, SMOOTH};
use super::point::{Names, Options, Point, random_points};
use super::printed::{EQUATION, found};
use super::reach::{Reached, reach};
use super::scale::scaled;
use super::sensitivities::Sensitivities;
use super::shard::Shard;
use super::subject::{Law, Subject};
use super::{Sampler, Sensitivity, finite, invariance};
use crate::formula::Fields;
use crate::formula::proof::Proved;
use crate::formula::proof::law::residual;
use crate::toolkit::equation::Equation;
use crate::{Error, Octuple};
use num_traits::{Signed, Zero};
use serde::{Deserialize, Serialize};
use std::cell::OnceCell;
use std::iter;

/// The tolerance between closed form and automatic differentiation in 237 bits.
const CLOSED_AGAINST_AD: f64 = 1e-60;
/// An entry below this fraction of the largest is a rounding error in 237 bits, which are a little more than 71 digits.
const NOTHING: f64 = 1e-68;
/// The tolerance between automatic differentiation and differences in 237 bits, at random points.
const AD_AGAINST_DIFFERENCES: f64 = 1e-50;
/// The same at hard points, where the step of differences must be shorter than the distance to the next kink, and
/// digits are lost.
const AD_AGAINST_DIFFERENCES_HARD: f64 = 1e-35;
/// The number of random points at which, as at all named ones, the printed equation is compared and differences are
/// taken with respect to each input; at the others differences are taken along one direction in all inputs.
const CLOSELY_AT: usize = 200;
/// Branches taken by this many random points need not be searched for.
const REACHED_FROM: usize = 64;
/// The tolerance of laws in 237 bits.
const LAW: f64 = 1e-60;

/// Steps of differences at hard points, of which the best one counts.
const STEPS: [f64; 4] = [3e-19, 1e-22, 1e-26, 1e-30];
/// Steps at random points. The second is used where the first is not accurate enough, as for a slave point near a
/// centre of curvature, whose foot moves far.
const STEPS_AT_RANDOM: [f64; 2] = [STEPS[0], 3e-20];

/// The result of an audit of one formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Audit {
    /// The formula's identifier.
    pub formula: String,
    /// Document and section, and how completely the equation is printed there.
    pub provenance: String,
    /// Named points: the cases, points on and near kinks, and those that were searched for.
    pub named_points: usize,
    /// The number of those that were searched for, since they take a branch that neither a case nor a random point takes.
    pub searched_points: usize,
    /// Random points.
    pub random_points: usize,
    /// The seed of the random points.
    pub seed: u64,
    /// The closed-form Jacobian is the derivative: it equals automatic differentiation, in 237 bits; `None` where it is automatic.
    pub closed_against_ad: Option<Claim>,
    /// Automatic differentiation is right: it equals differences, in 237 bits.
    pub ad_against_differences: Claim,
    /// The value in `f64` is accurate.
    pub eta: Claim,
    /// The closed-form Jacobian in `f64` is accurate; `None` where it is automatic.
    pub eta_jacobian: Option<Claim>,
    /// The same for sizes up to the stated [scale](crate::formula::Spec::scale); empty for a single given point.
    pub scaled: Vec<Claim>,
    /// The printed equation is the value, in 237 bits.
    pub equation: Claim,
    /// The derivative of the printed equation is the Jacobian, in 237 bits.
    pub equation_jacobian: Claim,
    /// Homogeneity, frame indifference, and the formula's own laws.
    pub laws: Vec<Claim>,
    /// Nothing overflows where the formula [says](crate::formula::Spec::finite) so; `None` if it says nothing, and for
    /// a single given point.
    pub finite: Option<Claim>,
    /// Every point where value or derivative jumps, by one-sided differences in 237 bits, is on a registered kink.
    pub kinks: Claim,
    /// On every registered kink something jumps; `None` if there are none.
    pub register: Option<Claim>,
    /// How kinks were searched for; `None` for a single given point.
    pub examination: Option<Examination>,
}

impl Audit {
    /// Every claim.
    pub fn claims(&self) -> impl Iterator<Item = &Claim> {
        let printed = [&self.equation, &self.equation_jacobian];
        (self.closed_against_ad.iter())
            .chain([&self.ad_against_differences, &self.eta])
            .chain(&self.eta_jacobian)
            .chain(&self.scaled)
            .chain(printed)
            .chain(&self.laws)
            .chain(&self.finite)
            .chain([&self.kinks])
            .chain(&self.register)
    }

    /// The largest η found of value and Jacobian, at all sizes.
    pub fn largest_eta(&self) -> [Option<f64>; 2] {
        ["value", "closed-form Jacobian"].map(|of| {
            let is_of = |claim: &&Claim| claim.claim.starts_with(&format!("η of the {of} "));
            let worst = self.claims().filter(is_of).filter_map(|claim| claim.worst.as_ref());
            worst.map(|worst| worst.size).reduce(f64::max)
        })
    }

    /// Whether no claim failed. For a single point on a kink some claims cannot be checked.
    pub fn no_claim_failed(&self) -> bool {
        self.claims().all(|claim| claim.failures == 0)
    }

    /// Whether every claim was checked, and none failed.
    pub fn passed(&self) -> bool {
        self.claims().all(Claim::held)
    }
}

/// The audit at a share of the random points, and the outcomes of the formula's comparisons there.
pub(super) fn audit_share(subject: &Subject, options: &Options, shard: Shard) -> (Audit, Vec<Comparison>) {
    let (range, is_first) = (shard.range(options.samples), shard.is_first());
    let mut named = if is_first { named_points(subject) } else { Vec::new() };
    let starts = is_first.then(|| random_points(subject, options, 0..options.samples.min(kinks::STARTS_AT)));
    let searched = starts.as_ref().map_or_else(Vec::new, |starts| searched_points(subject, &named, starts));
    let number = searched.len();
    named.extend(searched);
    let random = random_points(subject, options, range.clone());
    let points = Points { named, searched: number, random, before: range.start, seed: options.seed, starts };
    (audit_points(subject, &points), points.comparisons(subject))
}

/// Audits one formula at one point.
///
/// # Errors
/// An error for the invalid input.
pub fn audit_at<F: Proved>(inputs: &F::Inputs<f64>) -> Result<Audit, Error> {
    audit_point(&Subject::of::<F>(), inputs.components())
}

/// As [`audit_at`], without types.
pub(crate) fn audit_point(subject: &Subject, inputs: Vec<f64>) -> Result<Audit, Error> {
    (subject.check)(&inputs)?;
    let named = vec![Point::new(subject, "given".into(), false, inputs)];
    Ok(audit_points(subject, &Points { named, searched: 0, random: Vec::new(), before: 0, seed: 0, starts: None }))
}

/// The points of an audit, or of a part of one.
struct Points<'a> {
    named: Vec<Point<'a>>,
    /// The number of named points that were searched for.
    searched: usize,
    random: Vec<Point<'a>>,
    /// The number of random points before these, in other parts.
    before: usize,
    seed: u64,
    /// Random points from which kinks are searched; only in the first part.
    starts: Option<Vec<Point<'a>>>,
}

impl Points<'_> {
    /// Whether it is a single point given by the user.
    fn is_given(&self) -> bool {
        self.starts.is_none() && !self.named.is_empty()
    }

    /// The outcomes of the formula's comparisons.
    fn comparisons(&self, subject: &Subject) -> Vec<Comparison> {
        let points = self.named.iter().chain(&self.random).map(|point| point.inputs.as_slice());
        kinks::comparisons(subject, &Names::new(subject), points)
    }
}

fn audit_points(subject: &Subject, points: &Points<'_>) -> Audit {
    let Points { named, searched, random, before, seed, starts } = points;
    // Laws hold at points in general position; a single given point is checked as it is.
    let general = if points.is_given() { named } else { random };
    let names = Names::new(subject);
    let (printed, [equation, equation_jacobian]) = read_equation(subject);
    let (eta, eta_jacobian) = claims(&subject.spec, "");
    let scaled = if points.is_given() { Vec::new() } else { scaled(subject, &names, random, *before, *seed) };
    let mut audit = Audit {
        formula: subject.spec.id.into(),
        provenance: format!("{}; {}", subject.spec.source, subject.spec.source.provenance),
        named_points: named.len(),
        searched_points: *searched,
        random_points: random.len(),
        seed: *seed,
        closed_against_ad: closed_form(subject, named),
        ad_against_differences: Claim::new(
            "automatic differentiation = differences, in 237 bits",
            AD_AGAINST_DIFFERENCES,
        ),
        eta,
        eta_jacobian,
        scaled,
        equation,
        equation_jacobian,
        laws: invariance::of_all(subject).iter().chain(&subject.laws).map(|law| check_law(law, general)).collect(),
        finite: (!points.is_given()).then(|| finite::claim(subject, &names, random, *before, *seed)).flatten(),
        kinks: Claim::new("where value or derivative jumps a kink is registered, by one-sided differences", SMOOTH),
        register: starts.is_some().then(|| kinks::register(subject, &names)).flatten(),
        examination: None,
    };
    if let Some(starts) = starts {
        audit.examination = Some(kinks::look(subject, &names, [named, starts], &mut audit.kinks));
    } else if !points.is_given() {
        // Only the first part reports an equation that cannot be read.
        audit.equation = audit.equation.begun_anew();
    }
    let closely = CLOSELY_AT.saturating_sub(*before).min(random.len());
    for point in named.iter().chain(&random[..closely]) {
        audit.check_closely(point, &names, printed.as_ref());
    }
    for point in &random[closely..] {
        audit.check(point, &names);
    }
    audit
}

/// The claim about a closed form. A Jacobian without a stated bound is automatic; a hand-written one would go
/// unchecked.
fn closed_form(subject: &Subject, points: &[Point]) -> Option<Claim> {
    let mut claim = Claim::new("closed form = automatic differentiation, in 237 bits", CLOSED_AGAINST_AD);
    let bits = |entries: Vec<f64>| entries.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let is_automatic =
        |point: &Point| bits((subject.jacobian)(&point.inputs)) == bits((subject.automatic)(&point.inputs));
    if !subject.spec.is_closed() {
        if points.iter().all(is_automatic) {
            return None;
        }
        claim.fail("the Jacobian is written by hand; state its bound by `eta`, or leave it out".into());
    }
    Some(claim)
}

/// Audits the printed equation alone: its value and its Jacobian, at all points at which an audit compares them.
pub(crate) fn audit_equation(subject: &Subject, options: &Options) -> [Claim; 2] {
    let (printed, mut claims) = read_equation(subject);
    let Some(printed) = printed else { return claims };
    let names = Names::new(subject);
    let random = random_points(subject, options, 0..options.samples.min(CLOSELY_AT));
    for point in named_points(subject).into_iter().chain(random) {
        if printed.is_defined(point.kink.is_some()) {
            let (values, closed) = ((subject.exact_value)(&point.exact), (subject.exact_jacobian)(&point.exact));
            // Few numbers are so close to cancellation that their sensitivity to the inputs is needed.
            let (gradients, sensitivities) = (OnceCell::new(), Sensitivities::at(&point));
            let gradients = || gradients.get_or_init(|| subject.derivative(&point.exact)).as_slice();
            let bend = |k: usize| sensitivities.of(&point, &closed, k);
            check_equation(claims.each_mut(), &point, &names, [&values, &closed], gradients, bend, &printed);
        }
    }
    claims
}

/// The printed equation and the claims about it, including that it can be read.
fn read_equation(subject: &Subject) -> (Option<Equation>, [Claim; 2]) {
    let mut values = Claim::new("printed equation = value, in 237 bits", EQUATION);
    let jacobian = Claim::new("derivative of the printed equation = Jacobian, in 237 bits", EQUATION);
    let equation = Equation::of(&subject.spec, subject.inputs, subject.outputs);
    let equation = equation.map_err(|error| values.fail(error.to_string())).ok();
    (equation, [values, jacobian])
}

/// The formula's own cases, the worst points that a search found, and points on both sides of every kink and on it.
pub(super) fn named_points(subject: &Subject) -> Vec<Point<'_>> {
    let cases = (subject.cases)().into_iter().chain(subject.worst.iter().cloned());
    cases
        .map(|case| (case.id, case.inputs))
        .chain(beside_kinks(subject))
        .filter(|(_, inputs)| (subject.check)(inputs).is_ok())
        .map(|(label, inputs)| Point::new(subject, label, false, inputs))
        .collect()
}

/// Named points on every kink and on both sides of it, at two distances; some may be invalid inputs.
pub(crate) fn beside_kinks(subject: &Subject) -> impl Iterator<Item = (String, Vec<f64>)> {
    subject.kinks.iter().flat_map(|kink| {
        [0.0, 2e-3, -2e-3, 1e-9, -1e-9].map(|step| {
            let moved = kink.at.iter().zip(&kink.across).map(|(x, direction)| x + step * direction).collect();
            (format!("kink {} {step:+}", kink.condition), moved)
        })
    })
}

/// Points in branches that neither named points nor the first random ones take.
fn searched_points<'a>(subject: &'a Subject, named: &[Point], random: &[Point]) -> Vec<Point<'a>> {
    let Ok(graph) = subject.telling_graph() else { return Vec::new() };
    let names = Names::new(subject);
    let words = kinks::Words { graph, names: &names.inputs };
    let starts: Vec<_> = random.iter().take(REACHED_FROM).chain(named).map(|point| point.inputs.as_slice()).collect();
    let point = |reached: Reached| {
        let side = if reached.answer { "so" } else { "otherwise" };
        let label = format!("searched, {}: {side}", words.of(reached.comparison));
        Point::new(subject, label, false, reached.inputs)
    };
    reach(subject, &Branches::of(graph), &starts).into_iter().map(point).collect()
}

/// The checks made for every formula.
impl Audit {
    /// Checks all claims at a point.
    fn check_closely(&mut self, point: &Point, names: &Names, equation: Option<&Equation>) {
        let exact = Exact::at(point);
        self.check_code(point, names, &exact);
        if point.kink.is_none() {
            self.check_ad(point, names, &exact);
        }
        if let Some(equation) = equation.filter(|equation| equation.is_defined(point.kink.is_some())) {
            let claims = [&mut self.equation, &mut self.equation_jacobian];
            let bend = |k: usize| exact.bend(point, k);
            let known = [&exact.values, &exact.closed].map(Vec::as_slice);
            check_equation(claims, point, names, known, || exact.ad.as_slice(), bend, equation);
        }
    }

    /// The same without the printed equation, and with differences in one direction only.
    fn check(&mut self, point: &Point, names: &Names) {
        let exact = Exact::at(point);
        self.check_code(point, names, &exact);
        if point.kink.is_none() {
            self.check_ad_along(point, names, &exact);
        }
    }

    /// Checks the closed form in 237 bits, and everything computed in `f64`.
    fn check_code(&mut self, point: &Point, names: &Names, exact: &Exact) {
        self.check_closed_form(point, names, exact);
        check_accuracy(&mut self.eta, self.eta_jacobian.as_mut(), point, names, exact);
    }

    /// Judged relative to the entry and its sensitivity to the inputs, as an entry may be the result of a
    /// cancellation. An entry that is negligible compared with others of its output is rounding error of their terms
    /// in 237 bits, and is judged relative to them.
    fn check_closed_form(&mut self, point: &Point, names: &Names, exact: &Exact) {
        let Some(claim) = &mut self.closed_against_ad else { return };
        for (k, (&closed, &ad)) in exact.closed.iter().zip(&exact.ad).enumerate() {
            let describe = |size| point.deviation(size, names.entry(k), closed.to_f64(), ad.to_f64());
            let share_beside = |bend: Sensitivity| bend.plus(ad).share_of(closed - ad);
            let share = || {
                let (own, largest) = (exact.bend(point, k).plus(ad), exact.largest_of_output(k, point.exact.len()));
                let scale = if own.size() < largest * NOTHING { own.plus(largest) } else { own };
                scale.share_of(closed - ad)
            };
            let sizes = exact.sensitivities_up_to(point, k).map(share_beside).chain(iter::once_with(share));
            claim.record_last(sizes, CLOSED_AGAINST_AD, describe);
        }
    }

    /// Compares with differences with respect to each input.
    fn check_ad(&mut self, point: &Point, names: &Names, exact: &Exact) {
        let (inputs, rounding) = (point.exact.len(), rounding_of_values(point, exact));
        let bound = if point.random { AD_AGAINST_DIFFERENCES } else { AD_AGAINST_DIFFERENCES_HARD };
        for input in 0..inputs {
            let along = Direction::of_one(point.subject, &point.exact, input);
            let expected = exact.ad.chunks(inputs).map(|gradient| gradient[input]).collect();
            let compared = Compared::new(point, exact, &along, &rounding, expected);
            for output in 0..rounding.len() {
                let entry = output * inputs + input;
                let describe = |size| compared.describe(point, names.entry(entry), output, size);
                self.ad_against_differences.record(compared.deviation(output), bound, describe);
                if !point.random {
                    let sides: Vec<_> = compared.attempts.iter().map(|rows| rows.sides_of(output)).collect();
                    self.check_sides(point, names, entry, compared.scales[output].size(), &sides);
                }
            }
        }
    }

    /// Compares with differences along one direction in all inputs, a different one at every point.
    fn check_ad_along(&mut self, point: &Point, names: &Names, exact: &Exact) {
        let (subject, inputs) = (point.subject, point.exact.as_slice());
        let mut sampler = Sampler::named(&format!("{} along {}", subject.spec.id, point.label), 0);
        let along = Direction::of_all(subject, inputs, &mut sampler);
        let expected = exact.ad.chunks(inputs.len()).map(|gradient| along.derivative(gradient)).collect();
        let compared = Compared::new(point, exact, &along, &rounding_of_values(point, exact), expected);
        for (output, name) in names.outputs.iter().enumerate() {
            let entry = || format!("{name} along a direction of all inputs");
            let describe = |size| compared.describe(point, entry(), output, size);
            self.ad_against_differences.record(compared.deviation(output), AD_AGAINST_DIFFERENCES, describe);
        }
    }

    /// At a named point, which may be a special position, the derivatives on both sides must agree.
    fn check_sides(&mut self, point: &Point, names: &Names, entry: usize, scale: Octuple, sides: &[[Octuple; 2]]) {
        let relative = |[below, above]: &[Octuple; 2]| {
            let jump = (*above - *below).abs();
            let size = if jump == 0.0 { 0.0 } else { (jump / (scale + below.abs() + above.abs())).to_f64() };
            (size, [*below, *above])
        };
        let smallest = sides.iter().map(relative).reduce(|best, next| if next.0 < best.0 { next } else { best });
        let Some((size, [below, above])) = smallest else { return };
        let inputs = point.exact.len();
        // The steps may be longer than the distance to a kink.
        let size = if size <= SMOOTH { size } else { size.min(kinks::jump(point, entry / inputs, entry % inputs)) };
        let describe = |size| point.deviation(size, names.entry(entry), above.to_f64(), below.to_f64());
        self.kinks.record(size, SMOOTH, describe);
    }
}

/// The derivative of every output along a direction, compared with differences.
struct Compared {
    expected: Vec<Octuple>,
    scales: Vec<Sensitivity>,
    /// One entry for each step tried.
    attempts: Vec<Differences>,
}

impl Compared {
    fn new(point: &Point, exact: &Exact, along: &Direction, rounding: &[Sensitivity], expected: Vec<Octuple>) -> Self {
        let scale = |(&expected, rounding): (&Octuple, &Sensitivity)| {
            Sensitivity::none().plus(expected).plus(rounding.per(along.unit()))
        };
        let scales = expected.iter().zip(rounding).map(scale).collect();
        let mut compared = Self { expected, scales, attempts: Vec::new() };
        let steps = if point.random { &STEPS_AT_RANDOM[..] } else { &STEPS[..] };
        for &step in steps {
            compared.attempts.push(differences(point.subject, &point.exact, &exact.values, along, step));
            if point.random && compared.is_near() {
                break;
            }
        }
        compared
    }

    fn is_near(&self) -> bool {
        (0..self.expected.len()).all(|output| self.deviation(output) <= AD_AGAINST_DIFFERENCES)
    }

    /// The deviation for the best step, unless the first one gives no number.
    fn deviation(&self, output: usize) -> f64 {
        let deviations = self.attempts.iter().map(|rows| (self.expected[output] - rows.central[output]).abs());
        let best = deviations.reduce(|best, next| if next < best { next } else { best });
        best.map_or(f64::INFINITY, |best| self.scales[output].share_of(best))
    }

    fn describe(&self, point: &Point, entry: String, output: usize, size: f64) -> Deviation {
        let found = self.attempts[0].central[output].to_f64();
        point.deviation(size, entry, self.expected[output].to_f64(), found)
    }
}

/// The size of rounding errors in the values, from |y| and its sensitivity to the inputs, against which differences are judged in
/// addition to the derivative itself. If both are 0, because the terms of y cancel, the largest output of the same field is used.
fn rounding_of_values(point: &Point, exact: &Exact) -> Vec<Sensitivity> {
    let sizes = exact.sensitivities(&point.exact);
    let rounding = |(output, (size, &value)): (usize, (Sensitivity, &Octuple))| {
        let own = size.plus(value);
        let largest = || largest_of_field(point.subject.outputs, &exact.values, output);
        if own.size().is_zero() { own.plus(largest()) } else { own }
    };
    sizes.into_iter().zip(&exact.values).enumerate().map(rounding).collect()
}

/// Checks value and Jacobian of the printed equation by the same criteria as those of the code.
fn check_equation<'g>(
    [values, jacobian]: [&mut Claim; 2],
    point: &Point,
    names: &Names,
    [exact, closed]: [&[Octuple]; 2],
    gradients: impl Fn() -> &'g [Octuple],
    bend: impl Fn(usize) -> Sensitivity,
    equation: &Equation,
) {
    let found = found(equation, &point.exact, exact);
    let size = |k: usize| Sensitivity::new(&gradients()[k * point.exact.len()..], &point.exact);
    let describe = |size, entry, found, expected| point.deviation(size, entry, found, expected);
    found.record_values(values, exact, size, &names.outputs, describe);
    if point.kink.is_none() {
        found.record_jacobian(jacobian, closed, bend, |k| names.entry(k), describe);
    }
}

fn check_law(law: &Law, points: &[Point]) -> Claim {
    let mut claim = Claim::new(law.statement.as_str(), LAW);
    // On a kink or a cut a law may hold on one side only.
    for point in points.iter().filter(|point| point.kink.is_none()) {
        for (k, equation) in (law.sides)(&point.exact).iter().enumerate() {
            let (left, right) = (equation.left.to_f64(), equation.right.to_f64());
            let describe = |size| point.deviation(size, format!("equation {k}"), left, right);
            claim.record(residual(equation), LAW, describe);
        }
    }
    claim
}

#[cfg(test)]
mod tests;
