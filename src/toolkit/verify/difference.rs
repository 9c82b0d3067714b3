//! Jacobians by differences, as a check of automatic differentiation itself.

use super::sample::Sampler;
use super::subject::Subject;
use crate::Octuple;
use crate::formula::Field;
use crate::formula::proof::Proved;
use num_traits::{Signed, Zero};
use std::ops::Range;

/// The gradient of every output with respect to input component `k`, by fourth-order central differences in 237 bits:
/// (8(y₊₁ − y₋₁) − (y₊₂ − y₋₂)) / 12h, with h = `step` times the size of the input (if that is 0, of its field or of
/// inputs with the same unit).
///
/// Rounding costs about 2⁻²³⁶/`step` and truncation `step`⁴: at 3e-19 both are far below 1e-50. Near a kink the step
/// must be shorter than the distance to it, and fewer digits remain.
pub fn central_differences<F: Proved>(inputs: &[Octuple], k: usize, step: f64) -> Vec<Octuple> {
    let subject = Subject::of::<F>();
    let along = Direction::of_one(&subject, inputs, k);
    differences(&subject, inputs, &(subject.exact_value)(inputs), &along, step).central
}

/// A direction to move in from a point.
pub(super) struct Direction {
    /// The change of each input component per unit step.
    moves: Vec<Octuple>,
    unit: Octuple,
}

impl Direction {
    /// Moves one component; derivatives are with respect to it.
    pub(super) fn of_one(subject: &Subject, inputs: &[Octuple], k: usize) -> Self {
        let unit = step_size(subject.inputs, inputs, k);
        Self { moves: (0..inputs.len()).map(|i| if i == k { unit } else { Octuple::zero() }).collect(), unit }
    }

    /// Moves every component by between half and all of its size, up or down; derivatives are with respect to the step.
    pub(super) fn of_all(subject: &Subject, inputs: &[Octuple], sampler: &mut Sampler) -> Self {
        let moves = (0..inputs.len()).map(|k| {
            let part = 0.5 + sampler.unit() / 2.0;
            step_size(subject.inputs, inputs, k) * if sampler.coin() { part } else { -part }
        });
        Self { moves: moves.collect(), unit: Octuple::from(1.0) }
    }

    /// The size of the unit step.
    pub(super) fn unit(&self) -> Octuple {
        self.unit
    }

    /// The derivative along the direction of a function with this gradient.
    pub(super) fn derivative(&self, gradient: &[Octuple]) -> Octuple {
        let terms = gradient.iter().zip(&self.moves).map(|(&slope, &way)| slope * way);
        terms.fold(Octuple::zero(), |sum, term| sum + term) / self.unit
    }

    /// The point after `steps` steps of this size.
    fn moved(&self, inputs: &[Octuple], step: f64, steps: f64) -> Vec<Octuple> {
        inputs.iter().zip(&self.moves).map(|(&x, &way)| x + way * step * steps).collect()
    }
}

/// The derivative of every output along a direction.
pub(super) struct Differences {
    /// As in [`central_differences`].
    pub(super) central: Vec<Octuple>,
    /// At the point, backward and forward.
    pub(super) one_sided: [Vec<Octuple>; 2],
}

impl Differences {
    /// The derivatives of an output on both sides.
    pub(super) fn sides_of(&self, output: usize) -> [Octuple; 2] {
        self.one_sided.each_ref().map(|side| side[output])
    }
}

/// Differences of a formula without its types, whose values at the point are `here`.
pub(super) fn differences(
    subject: &Subject,
    inputs: &[Octuple],
    here: &[Octuple],
    along: &Direction,
    step: f64,
) -> Differences {
    let h = along.unit * step;
    let values = |steps: f64| (subject.exact_value)(&along.moved(inputs, step, steps));
    let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(values);
    let near = above.iter().zip(&below).map(|(&above, &below)| (above - below) * 8.0);
    let far = far_above.iter().zip(&far_below).map(|(&above, &below)| above - below);
    let central = near.zip(far).map(|(near, far)| (near - far) / (h * 12.0)).collect();
    let from =
        |values: &[Octuple], sign: f64| values.iter().zip(here).map(|(&y, &here)| (y - here) / (h * sign)).collect();
    Differences { central, one_sided: [from(&below, -1.0), from(&above, 1.0)] }
}

/// The components of the field to which this one belongs, including itself.
pub(super) fn of_same_field(fields: &[Field], component: usize) -> Range<usize> {
    Field::ranges(fields).find(|range| range.contains(&component)).unwrap_or(component..component)
}

/// The size of the largest of these numbers.
pub(super) fn largest_of(numbers: &[Octuple]) -> Octuple {
    numbers.iter().map(Signed::abs).fold(Octuple::zero(), |largest, x| if x > largest { x } else { largest })
}

/// The largest number of the field of the k-th component.
pub(super) fn largest_of_field(fields: &[Field], numbers: &[Octuple], k: usize) -> Octuple {
    largest_of(numbers.get(of_same_field(fields, k)).unwrap_or_default())
}

/// |x|, or the largest of its field where x is 0, or the largest of its unit where the whole field is 0, or 1.
pub(super) fn step_size(fields: &[Field], inputs: &[Octuple], k: usize) -> Octuple {
    if let Some(own) = inputs.get(k).map(Signed::abs).filter(|own| !own.is_zero()) {
        return own;
    }
    let field_of: Vec<_> = fields.iter().enumerate().flat_map(|(f, field)| vec![f; field.len()]).collect();
    let largest_where = |counts: &dyn Fn(usize) -> bool| {
        let sizes = inputs.iter().zip(&field_of).filter(|(_, field)| counts(**field)).map(|(x, _)| x.abs());
        sizes.fold(Octuple::zero(), |largest, x| if x > largest { x } else { largest })
    };
    let Some(&field) = field_of.get(k) else { return Octuple::from(1.0) };
    let unit = |f: usize| fields[f].quantity.unit;
    let candidates = [largest_where(&|f| f == field), largest_where(&|f| unit(f) == unit(field))];
    candidates.into_iter().find(|size| !size.is_zero()).unwrap_or_else(|| Octuple::from(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::contact::coulomb::ReturnMap;
    use crate::contact::slide_line::LocalBasis;
    use crate::formula::quantity::{F2, MU, X, XA};
    use crate::toolkit::verify::exact;

    /// For √(x² + y²) at (3, 4), whose gradient is (0.6, 0.8).
    #[test]
    fn derivatives_are_by_one_component_or_along_a_direction_of_all() {
        let (subject, inputs) = (Subject::of::<ContactForce>(), exact(&[3.0, 4.0]));
        let gradient = subject.derivative(&inputs);
        let mut sampler = Sampler::named("direction", 1);
        let of_all = Direction::of_all(&subject, &inputs, &mut sampler);
        for (way, size) in of_all.moves.iter().zip([3.0, 4.0]) {
            let part = way.abs().to_f64() / size;
            assert!((0.5..=1.0).contains(&part), "{part}");
        }
        assert_eq!(of_all.unit().to_f64(), 1.0);
        let of_one = [0, 1].map(|k| Direction::of_one(&subject, &inputs, k));
        assert_eq!(of_one.each_ref().map(|along| along.unit().to_f64()), [3.0, 4.0]);
        let by_hand = of_all.moves[0].to_f64() * 0.6 + of_all.moves[1].to_f64() * 0.8;
        for (along, expected) in of_one.iter().chain([&of_all]).zip([0.6, 0.8, by_hand]) {
            let found = differences(&subject, &inputs, &exact(&[5.0]), along, 3e-19);
            assert!((along.derivative(&gradient).to_f64() - expected).abs() < 1e-15);
            assert!((found.central[0] - along.derivative(&gradient)).abs() < 1e-50);
            assert!(found.sides_of(0).iter().all(|side| (side.to_f64() - expected).abs() < 1e-15));
        }
    }

    #[test]
    fn directions_of_all_go_up_and_down_by_between_half_and_all() {
        let (subject, inputs) = (Subject::of::<ContactForce>(), exact(&[2.0, -1.0]));
        let mut sampler = Sampler::named("directions", 1);
        let parts = (0..100).flat_map(|_| {
            let moves = Direction::of_all(&subject, &inputs, &mut sampler).moves;
            [moves[0].to_f64() / 2.0, moves[1].to_f64()]
        });
        let parts: Vec<_> = parts.collect();
        assert!(parts.iter().all(|part| (0.5..=1.0).contains(&part.abs())), "{parts:?}");
        for range in [-1.0..-0.9, -0.6..-0.5, 0.5..0.6, 0.9..1.0] {
            assert!(parts.iter().any(|part| range.contains(part)), "{range:?}: {parts:?}");
        }
    }

    const FIELDS: &[Field] =
        &[Field::new("xa", &XA), Field::new("mu", &MU), Field::new("x", &X), Field::new("f2", &F2)];

    #[test]
    fn a_step_is_of_the_size_of_a_number_or_of_what_is_most_like_it() {
        let step = |inputs: [f64; 6], k| step_size(FIELDS, &exact(&inputs), k).to_f64();
        let inputs = [0.0, -3.0, 2.0, 0.0, -7.0, 0.0];
        // Its own size, that of its field, and 1 if nothing has its unit.
        assert_eq!([0, 1, 2, 3, 4, 5].map(|k| step(inputs, k)), [3.0, 3.0, 2.0, 1.0, 7.0, 1.0]);
        // The size of inputs with the same unit, if its whole field is zero.
        assert_eq!(step([0.0, 0.0, 0.0, 5.0, -7.0, 9.0], 1), 7.0);
        assert_eq!(step([1.0, -3.0, 2.0, 5.0, 0.0, 9.0], 4), 3.0);
    }

    #[test]
    fn the_largest_of_a_field_is_of_no_other_field() {
        let numbers = exact(&[1.0, -3.0, 2.0, 8.0, -7.0, 9.0]);
        let largest = [0, 1, 2, 3, 4, 5].map(|k| largest_of_field(FIELDS, &numbers, k).to_f64());
        assert_eq!(largest, [3.0, 3.0, 3.0, 8.0, 7.0, 9.0]);
        assert_eq!(largest_of_field(FIELDS, &exact(&[0.0; 6]), 1), Octuple::zero());
    }

    /// The transmitted force is at most μ F_N, here 2.
    #[test]
    fn sides_are_told_apart_in_order() {
        let (subject, inputs) = (Subject::of::<ReturnMap>(), exact(&[2.0, 0.5, 4.0]));
        let along = Direction::of_one(&subject, &inputs, 0);
        let found = differences(&subject, &inputs, &exact(&[2.0]), &along, 3e-19);
        assert_eq!(found.sides_of(0).map(Octuple::to_f64), [1.0, 0.0]);
    }

    #[test]
    fn central_differences_are_by_one_component() {
        for (k, expected) in [(0, 0.6), (1, 0.8)] {
            let found = central_differences::<ContactForce>(&exact(&[3.0, 4.0]), k, 3e-19);
            assert!(found.len() == 1 && (found[0].to_f64() - expected).abs() < 1e-15, "{found:?}");
        }
    }

    #[test]
    fn a_component_is_of_the_field_that_it_lies_in() {
        let subject = Subject::of::<LocalBasis>();
        let of = |component| of_same_field(subject.outputs, component);
        assert_eq!([0, 1, 2, 3, 4].map(of), [0..2, 0..2, 2..4, 2..4, 4..4]);
    }
}
