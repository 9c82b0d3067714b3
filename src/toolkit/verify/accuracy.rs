//! The exact results at a point, and the backward errors of value and Jacobian in `f64`.

use super::claim::Claim;
use super::difference::{largest_of, of_same_field};
use super::eta::{eta_beside, is_rounding, rounding};
use super::other_side::OtherSide;
use super::point::{Names, Point};
use super::sensitivities::Sensitivities;
use super::subject::Subject;
use super::{Sensitivity, eta};
use crate::Octuple;
use crate::formula::Spec;
use crate::formula::proof::Convention;
use crate::formula::quantity::Domain;
use crate::toolkit::graph::Node;
use std::cell::OnceCell;
use std::iter;

/// The exact results at a point.
pub(super) struct Exact {
    pub(super) values: Vec<Octuple>,
    /// The Jacobian by automatic differentiation, and by the closed form.
    pub(super) ad: Vec<Octuple>,
    pub(super) closed: Vec<Octuple>,
    sensitivities: Sensitivities,
}

impl Exact {
    pub(super) fn at(point: &Point) -> Self {
        let (subject, inputs) = (point.subject, &point.exact);
        let ad = subject.derivative(inputs);
        let closed = if subject.spec.is_closed() { (subject.exact_jacobian)(inputs) } else { ad.clone() };
        Self { values: (subject.exact_value)(inputs), ad, closed, sensitivities: Sensitivities::at(point) }
    }

    /// The sensitivity of the k-th entry of the Jacobian to the inputs.
    pub(super) fn bend(&self, point: &Point, k: usize) -> Sensitivity {
        self.sensitivities.of(point, &self.closed, k)
    }

    /// Lower bounds of this sensitivity, each of which takes longer to compute, and finally the sensitivity itself.
    pub(super) fn sensitivities_up_to(&self, point: &Point, k: usize) -> impl Iterator<Item = Sensitivity> {
        self.sensitivities.up_to(point, &self.closed, k)
    }

    /// The largest entry in the row of the k-th.
    pub(super) fn largest_of_output(&self, k: usize, inputs: usize) -> Octuple {
        let row = k / inputs * inputs;
        largest_of(&self.ad[row..row + inputs])
    }

    /// The largest of the entries beside one, with its sensitivity.
    fn largest_beside(&self, point: &Point, k: usize) -> Sensitivity {
        largest(entries_beside(point, k).map(|entry| self.bend(point, entry).plus(self.ad[entry])))
    }

    /// The sensitivity of every output to the inputs.
    pub(super) fn sensitivities(&self, inputs: &[Octuple]) -> Vec<Sensitivity> {
        self.ad.chunks(inputs.len()).map(|gradient| Sensitivity::new(gradient, inputs)).collect()
    }
}

/// The other components of the output that has this one.
fn outputs_beside(point: &Point, output: usize) -> impl Iterator<Item = usize> + use<> {
    of_same_field(point.subject.outputs, output).filter(move |&other| other != output)
}

/// The entries beside which one is judged normwise: those for the other components of the same input, or where that is a scalar,
/// those of the other components of the same output.
fn entries_beside(point: &Point, k: usize) -> impl Iterator<Item = usize> + use<> {
    let inputs = point.exact.len();
    let (output, input) = (k / inputs, k % inputs);
    let of_input = of_same_field(point.subject.inputs, input);
    let is_scalar = of_input.len() == 1;
    let by_output = outputs_beside(point, output).filter(move |_| is_scalar).map(move |other| other * inputs + input);
    of_input.filter(move |&other| other != input).map(move |other| output * inputs + other).chain(by_output)
}

/// The claims of the bounds of η of the value and of a closed-form Jacobian, for the given sizes.
pub(super) fn claims(spec: &Spec, sizes: &str) -> (Claim, Option<Claim>) {
    let (bounds, by) = spec.bounds();
    let claim = |of, bound| Claim::new(format!("η of the {of} in f64{by}{sizes}"), bound);
    (claim("value", bounds.value), bounds.jacobian.map(|bound| claim("closed-form Jacobian", bound)))
}

/// The claims about the bounds of η, checked at one point with valid inputs.
pub(crate) fn eta_point(subject: &Subject, inputs: Vec<f64>) -> Vec<Claim> {
    let point = Point::new(subject, "found".into(), false, inputs);
    let (mut value, mut jacobian) = claims(&subject.spec, "");
    check_accuracy(&mut value, jacobian.as_mut(), &point, &Names::new(subject), &Exact::at(&point));
    [value].into_iter().chain(jacobian).collect()
}

/// Checks value and closed-form Jacobian in `f64`, each computed alone and together; on a switch there is no derivative. A point that
/// is not as far from a singular one as the formula states does not count against it.
pub(super) fn check_accuracy(
    value: &mut Claim,
    mut jacobian: Option<&mut Claim>,
    point: &Point,
    names: &Names,
    exact: &Exact,
) {
    let spec = &point.subject.spec;
    if spec.apart == 0.0 {
        return check_everywhere(value, jacobian, point, names, exact);
    }
    let before = (value.clone(), jacobian.as_deref().cloned());
    check_everywhere(value, jacobian.as_deref_mut(), point, names, exact);
    let has_failed = |now: &Claim, before: &Claim| now.failures > before.failures;
    if (has_failed(value, &before.0)
        || jacobian.as_deref().zip(before.1.as_ref()).is_some_and(|(now, before)| has_failed(now, before)))
        && point.subject.graph().is_ok_and(|graph| graph.distance_from_singular(&point.inputs) < spec.apart)
    {
        *value = before.0;
        if let (Some(jacobian), Some(before)) = (jacobian, before.1) {
            *jacobian = before;
        }
    }
}

fn check_everywhere(value: &mut Claim, jacobian: Option<&mut Claim>, point: &Point, names: &Names, exact: &Exact) {
    let (subject, inputs) = (point.subject, &point.inputs);
    let [with_jacobian, linearized] = (subject.linearized)(inputs);
    let other = OnceCell::new();
    let other_side = || other.get_or_init(|| OtherSide::at(point)).as_ref();
    check_value(value, point, names, exact, [(subject.value)(inputs), with_jacobian], other_side);
    if let Some(jacobian) = jacobian.filter(|_| point.kink != Some(Convention::Switch)) {
        check_jacobian(jacobian, point, names, exact, [(subject.jacobian)(inputs), linearized], other_side);
    }
}

fn check_value<'a>(
    claim: &mut Claim,
    point: &'a Point,
    names: &Names,
    exact: &Exact,
    values: [Vec<f64>; 2],
    other_side: impl Fn() -> Option<&'a OtherSide<'a>>,
) {
    let (sizes, spec) = (exact.sensitivities(&point.exact), &point.subject.spec);
    let beside = |output: usize| largest(outputs_beside(point, output).map(|k| sizes[k].plus(exact.values[k])));
    for computed in values {
        for (output, ((&computed, &value), &sensitivity)) in computed.iter().zip(&exact.values).zip(&sizes).enumerate()
        {
            let near = |value| if is_angle(point, output) { in_same_turn(value, computed) } else { value };
            let describe = |size| point.deviation(size, names.outputs[output].clone(), computed, value.to_f64());
            let own = eta(computed, near(value), sensitivity);
            let vector = || own.min(eta_beside(computed, near(value), beside(output)));
            let sizes = iter::once(own).chain(spec.normwise.iter().map(|_| vector()));
            let by_fields = || {
                let row = |k: usize| &exact.ad[k * point.exact.len()..][..point.exact.len()];
                let size = |k: usize| by_fields(point, row(k)).plus(exact.values[k]);
                let all = outputs_beside(point, output).chain([output]);
                spec.normwise.map(|_| eta_beside(computed, near(value), largest(all.map(size))))
            };
            let there = || {
                let side = other_side()?;
                let [values, _] = side.outputs();
                let beside = outputs_beside(point, output).map(|k| values[k]);
                Some(eta_there(computed, near(side.result(values[output])), (side, values[output]), beside, point))
            };
            claim.record_last_or(sizes, claim.bound, [&by_fields, &there], describe);
        }
    }
}

/// η on the other side of a kink, of the result of an operation; `beside` are those of the other components.
fn eta_there(
    computed: f64,
    exact: Octuple,
    (side, node): (&OtherSide, Node),
    beside: impl Iterator<Item = Node>,
    point: &Point,
) -> f64 {
    if point.subject.spec.normwise.is_none() {
        return eta_beside(computed, exact, side.size(node));
    }
    let size = |node| side.size_by_fields(point.subject.inputs, node);
    eta_beside(computed, exact, largest(iter::once(node).chain(beside).map(size)))
}

/// The sensitivity to whole vectors of a number with this gradient.
fn by_fields(point: &Point, gradient: &[Octuple]) -> Sensitivity {
    Sensitivity::by_fields(point.subject.inputs, gradient, &point.exact)
}

/// Whether an output is an angle, which is the same after a full turn.
fn is_angle(point: &Point, output: usize) -> bool {
    let mut fields = point.subject.outputs.iter().flat_map(|field| iter::repeat_n(field, field.len()));
    fields.nth(output).is_some_and(|field| field.quantity.domain == Domain::Angle)
}

/// The angle, or the one that is a full turn before or after it, whichever is nearest to a computed one: an angle of nearly half a
/// turn may be rounded to the other end of its range.
fn in_same_turn(angle: Octuple, computed: f64) -> Octuple {
    let (turn, off) = (Octuple::PI * 2.0, Octuple::from(computed) - angle);
    if off > Octuple::PI {
        angle + turn
    } else if off < -Octuple::PI {
        angle - turn
    } else {
        angle
    }
}

/// Judges the closed form in `f64` against automatic differentiation, so that a wrong one does not judge itself.
fn check_jacobian<'a>(
    claim: &mut Claim,
    point: &'a Point,
    names: &Names,
    exact: &Exact,
    jacobians: [Vec<f64>; 2],
    other_side: impl Fn() -> Option<&'a OtherSide<'a>>,
) {
    let ([alone, together], spec) = (jacobians, &point.subject.spec);
    let second = OnceCell::new();
    for (entry, ((&alone, &together), &ad)) in alone.iter().zip(&together).zip(&exact.ad).enumerate() {
        let mut judge = |computed| {
            let own = exact.sensitivities_up_to(point, entry).map(|bend| eta(computed, ad, bend));
            let vector = || {
                let own = eta(computed, ad, exact.bend(point, entry));
                own.min(eta_beside(computed, ad, exact.largest_beside(point, entry)))
            };
            let sizes = own.chain(spec.normwise.iter().map(|_| vector()));
            let by_fields = || {
                let gradients =
                    spec.normwise.map(|_| second.get_or_init(|| point.subject.second_derivative(&point.exact)))?;
                let size = |k: usize| by_fields(point, &gradients[k]).plus(exact.ad[k]);
                let all = entries_beside(point, entry).chain([entry]);
                Some(eta_beside(computed, ad, largest(all.map(size))))
            };
            let there = || {
                let side = other_side()?;
                let [_, entries] = side.outputs();
                let beside = entries_beside(point, entry).map(|k| entries[k]);
                Some(eta_there(computed, side.result(entries[entry]), (side, entries[entry]), beside, point))
            };
            let nothing = || {
                let largest = exact.largest_of_output(entry, point.exact.len());
                let rounding = rounding(ad, exact.closed[entry], largest);
                is_rounding(computed, ad, exact.bend(point, entry), rounding).then_some(0.0)
            };
            let describe = |size| point.deviation(size, names.entry(entry), computed, ad.to_f64());
            claim.record_last_or(sizes, claim.bound, [&by_fields, &there, &nothing], describe)
        };
        let size = judge(alone);
        // The same number is judged only once.
        if together.to_bits() == alone.to_bits() {
            claim.count(size, claim.bound);
        } else {
            judge(together);
        }
    }
}

fn largest(sizes: impl Iterator<Item = Sensitivity>) -> Sensitivity {
    sizes.fold(Sensitivity::none(), |most, size| if size.size() > most.size() { size } else { most })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::contact::coulomb::ReturnMap;
    use crate::contact::slide_line::LocalBasis;
    use crate::formula::Bounds;
    use crate::number::power::power_of_two;

    #[test]
    fn the_largest_entry_is_that_of_the_output() {
        let ad = [1.0, -5.0, 2.0, 0.25, 0.5, -0.125].map(Octuple::from).to_vec();
        let subject = Subject::of::<ContactForce>();
        let exact = Exact { ad, ..Exact::at(&point(&subject, false, &[3.0, 4.0])) };
        let largest: Vec<_> = (0..6).map(|k| exact.largest_of_output(k, 3).to_f64()).collect();
        assert_eq!(largest, [5.0, 5.0, 5.0, 0.5, 0.5, 0.5]);
    }

    fn point<'a>(subject: &'a Subject, random: bool, inputs: &[f64]) -> Point<'a> {
        Point::new(subject, "here".into(), random, inputs.to_vec())
    }

    /// An error in one part of the exact results is found there, with its size.
    #[test]
    fn value_and_jacobian_are_judged_by_their_own_errors() {
        let subject = Subject::of::<ContactForce>();
        let (point, names) = (point(&subject, false, &[3.0, 4.0]), Names::new(&subject));
        let off = |x: &mut Octuple| *x *= 1.0 + power_of_two(-40);
        let [mut value, mut jacobian] = ["value", "Jacobian"].map(|claim| Claim::new(claim, 2.0));
        let mut exact = Exact::at(&point);
        exact.values.iter_mut().for_each(off);
        off(&mut exact.ad[1]);
        check_accuracy(&mut value, Some(&mut jacobian), &point, &names, &exact);
        // Computed alone and together; 2¹³ roundings, divided by the sensitivity.
        assert_eq!((value.checks, value.failures, jacobian.checks, jacobian.failures), (2, 2, 4, 2));
        let worst = [value, jacobian].map(|claim| claim.worst.expect("it was checked"));
        assert_eq!(worst.each_ref().map(|worst| worst.entry.as_str()), ["fc", "∂fc/∂f3"]);
        for (worst, (expected, number)) in worst.iter().zip([(8192.0 / 2.0, 5.0), (8192.0 * 0.8 / 1.376, 0.8)]) {
            assert!((worst.size / expected - 1.0).abs() < 1e-3, "{worst:?}");
            assert!((worst.found - number).abs() < 1e-15 && worst.expected > worst.found, "{worst:?}");
        }
    }

    /// The first component of a tangent nearly along the second axis, and its derivative with respect to itself, are
    /// off by less than a rounding of the second component.
    #[test]
    fn normwise_a_component_that_cancels_is_judged_beside_the_largest() {
        let failures = |normwise, off: f64| {
            let mut subject = Subject::of::<LocalBasis>();
            subject.spec.normwise = normwise;
            let (point, names) = (point(&subject, false, &[3e-9, 4.0]), Names::new(&subject));
            let (mut value, jacobian) = claims(&subject.spec, "");
            let mut jacobian = jacobian.expect("it is in closed form");
            let mut exact = Exact::at(&point);
            exact.values[0] += off;
            exact.ad[1] += off;
            check_accuracy(&mut value, Some(&mut jacobian), &point, &names, &exact);
            [value, jacobian].map(|claim| (claim.failures, claim.claim.ends_with(", normwise")))
        };
        let bounds = Some(Bounds { value: 2.0, jacobian: Some(2.0) });
        assert_eq!(failures(None, 1e-17), [(2, false), (2, false)]);
        assert_eq!(failures(bounds, 1e-17), [(0, true), (0, true)]);
        assert_eq!(failures(bounds, 1e-15), [(2, true), (2, true)]);
    }

    #[test]
    fn on_a_switch_no_derivative_is_judged() {
        let subject = Subject::of::<ReturnMap>();
        let checks = |f_trial| {
            let (point, names) = (point(&subject, false, &[f_trial, 0.5, 4.0]), Names::new(&subject));
            let [mut value, mut jacobian] = ["value", "Jacobian"].map(|claim| Claim::new(claim, 2.0));
            check_accuracy(&mut value, Some(&mut jacobian), &point, &names, &Exact::at(&point));
            (value.checks, jacobian.checks)
        };
        assert_eq!((checks(2.0), checks(3.0)), ((2, 0), (2, 6)));
    }
}
