//! The laws that every formula satisfies: dimensional homogeneity and frame indifference.

use super::sample::rotation;
use super::subject::{Law, Subject};
use crate::Octuple;
use crate::formula::Field;
use crate::formula::proof::Equation;
use crate::formula::proof::law::equal_all;
use crate::formula::quantity::{Domain, Shape, Unit};
use crate::number::scalar::direction;
use num_traits::{One, Signed, Zero};

/// The laws that every formula satisfies.
pub(crate) fn of_all(subject: &Subject) -> Vec<Law> {
    let (inputs, outputs, value) = (subject.inputs, subject.outputs, subject.exact_value);
    let homogeneity = Law {
        statement: "dimensional homogeneity: other base units only rescale the outputs".into(),
        sides: Box::new(move |i| equal_all(value(&rescale(inputs, i)).into_iter().zip(rescale(outputs, &value(i))))),
    };
    let indifference = Law {
        statement: "frame indifference: a rigid-body motion of the model displaces and rotates the outputs with it"
            .into(),
        sides: Box::new(move |i| {
            let reach = reach(inputs, i);
            let sides = value(&moved(inputs, i, reach)).into_iter().zip(moved(outputs, &value(i), reach));
            // Cancellation leaves rounding errors proportional to the inputs, in outputs of any size.
            let size = i.iter().fold(Octuple::from(1.0), |size, x| size + x.abs());
            sides.map(|(left, right)| Equation { left, right, scale: size * size + left.abs() }).collect()
        }),
    };
    if subject.spec.objective { vec![homogeneity, indifference] } else { vec![homogeneity] }
}

/// Scales every field by its unit.
pub(super) fn rescale(fields: &[Field], components: &[Octuple]) -> Vec<Octuple> {
    let factor = |unit: Unit| {
        Octuple::from(2.0_f64.powi(3 * unit.length - 5 * unit.force + 7 * unit.time + 11 * unit.temperature))
    };
    let factors = fields.iter().flat_map(|field| vec![factor(field.quantity.unit); field.len()]);
    components.iter().zip(factors).map(|(&x, factor)| x * factor).collect()
}

/// The largest coordinate of a point, or 1: the translation is proportional to it, so that it does not swamp a small model.
pub(super) fn reach(fields: &[Field], components: &[Octuple]) -> Octuple {
    let is_point = |domain| matches!(domain, Domain::Point | Domain::Meridian);
    let is_point = fields.iter().flat_map(|field| vec![is_point(field.quantity.domain); field.len()]);
    let coordinates = components.iter().zip(is_point).filter(|(_, is_point)| *is_point).map(|(x, _)| x.abs());
    coordinates
        .reduce(|largest, x| if x > largest { x } else { largest })
        .filter(|x| !x.is_zero())
        .unwrap_or_else(Octuple::one)
}

/// Rotates vectors and matrices, and rotates and translates points.
pub(super) fn moved(fields: &[Field], components: &[Octuple], reach: Octuple) -> Vec<Octuple> {
    let mut rest = components;
    let mut result = Vec::new();
    for field in fields {
        let (part, tail) = rest.split_at(field.len().min(rest.len()));
        rest = tail;
        result.extend(move_part(part, field.quantity.domain, field.quantity.shape, reach));
    }
    result
}

fn move_part(part: &[Octuple], domain: Domain, shape: Shape, reach: Octuple) -> Vec<Octuple> {
    let translation = [1.25, -7.0, 3.5].map(|x| reach * x);
    if let (Domain::Meridian, &[r, z]) = (domain, part) {
        return vec![r, z + translation[1]];
    }
    if !domain.turns() || shape == Shape::Scalar {
        return part.to_vec();
    }
    let number = Octuple::from;
    let triad = if matches!(shape, Shape::Vec2 | Shape::Mat2) {
        let (c, s, zero) = (number(3.0) / 5.0, number(4.0) / 5.0, number(0.0));
        [[c, s, zero], [-s, c, zero], [zero; 3]]
    } else {
        let [w, x, y, z] = direction([2.0, -1.0, 3.0, 4.0].map(number));
        rotation(w, x, y, z)
    };
    if let [rows, _] = *shape.dimensions() {
        // Row i and column j are combinations of both axes.
        let turned = |row: usize, column: usize| {
            let product = |k: usize| part[k] * triad[k / rows][row] * triad[k % rows][column];
            (0..part.len()).map(product).fold(Octuple::zero(), |sum, x| sum + x)
        };
        return (0..part.len()).map(|k| turned(k / rows, k % rows)).collect();
    }
    let shift = |axis: usize| if domain == Domain::Point { translation[axis] } else { Octuple::zero() };
    (0..part.len())
        .map(|axis| part.iter().enumerate().fold(shift(axis), |sum, (k, &x)| sum + x * triad[k][axis]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slider::Basis;
    use crate::connector::slot::{ContactForce, RelativePosition};
    use crate::formula::proof::law::residual;
    use crate::formula::quantity::{
        D0, E1A, FORCE, FORCE_M_PLANE, K_STICK, K_U1_U1, K_U1_U1_PLANE, MU0, Quantity, X, XA, XA_PLANE,
    };
    use crate::toolkit::verify::exact;

    const HEAT: Quantity = Quantity::scalar("h", Unit::TEMPERATURE, Domain::Real, "a temperature");

    #[test]
    fn every_unit_is_scaled_by_a_factor_of_its_own() {
        let fields = [
            Field::new("xa", &XA),
            Field::new("k_stick", &K_STICK),
            Field::new("mu0", &MU0),
            Field::new("h", &HEAT),
            Field::new("e1a", &E1A),
        ];
        // L, F/L, FT/L³, Θ and 1, with 2³, 2⁻⁵, 2⁷ and 2¹¹ for L, F, T and Θ.
        let found = rescale(&fields, &exact(&[1.0; 9])).iter().map(|x| x.to_f64().log2()).collect::<Vec<_>>();
        assert_eq!(found, [3.0, 3.0, 3.0, -8.0, -7.0, 11.0, 0.0, 0.0, 0.0]);
        assert_eq!(rescale(&fields[..1], &exact(&[2.0, 3.0, -5.0])), exact(&[16.0, 24.0, -40.0]));
    }

    #[test]
    fn the_reach_is_the_largest_coordinate_of_a_point() {
        let fields = [Field::new("x", &X), Field::new("xa", &XA)];
        assert_eq!(reach(&fields, &exact(&[9.0, 2.0, -5.0, 3.0])), 5.0);
        assert_eq!(reach(&fields, &exact(&[9.0, 0.0, 0.0, 0.0])), 1.0);
        assert_eq!(reach(&fields[..1], &exact(&[9.0])), 1.0);
    }

    /// The value of a field after a model of this reach has moved.
    fn after(quantity: &'static Quantity, numbers: &[f64], reach: f64) -> Vec<Octuple> {
        moved(&[Field::new("field", quantity)], &exact(numbers), reach.into())
    }

    fn assert_close(found: &[Octuple], expected: &[Octuple]) {
        let is_close = |(found, expected): (&Octuple, &Octuple)| (*found - *expected).abs() < 1e-65;
        let all = found.len() == expected.len() && found.iter().zip(expected).all(is_close);
        assert!(all, "{found:?} is not {expected:?}");
    }

    #[test]
    fn points_are_moved_in_proportion_and_vectors_are_not() {
        assert_close(&after(&XA, &[0.0; 3], 2.0), &exact(&[2.5, -14.0, 7.0]));
        assert_close(&after(&XA_PLANE, &[0.0; 2], 2.0), &exact(&[2.5, -14.0]));
        assert_close(&after(&FORCE, &[0.0; 3], 2.0), &exact(&[0.0; 3]));
        // Numbers, and components in a triad, stay the same.
        assert_close(&after(&X, &[3.0], 2.0), &exact(&[3.0]));
        assert_close(&after(&D0, &[3.0, 4.0, 5.0], 2.0), &exact(&[3.0, 4.0, 5.0]));
    }

    /// Lengths of and angles between rotated vectors are preserved, and the rotation is right-handed.
    #[test]
    fn vectors_are_turned() {
        let of = |numbers: [f64; 3]| after(&FORCE, &numbers, 1.0);
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(of);
        // (w, x, y, z) = (2, −1, 3, 4)/√30.
        let by_hand = [[-20.0, 10.0, -20.0], [-22.0, -4.0, 20.0], [4.0, 28.0, 10.0]];
        let thirtieth = |row: [f64; 3]| exact(&row).iter().map(|&x| x / 30.0).collect::<Vec<_>>();
        let rows = by_hand.map(thirtieth);
        assert_close(&[x.clone(), y.clone(), z.clone()].concat(), &rows.concat());
        let sum: Vec<_> = (0..3).map(|k| x[k] * 2.0 - y[k] + z[k] * 3.0).collect();
        assert_close(&of([2.0, -1.0, 3.0]), &sum);
        let [c, s] = [3.0, 4.0].map(|x| Octuple::from(x) / 5.0);
        assert_close(&after(&FORCE_M_PLANE, &[1.0, 0.0], 1.0), &[c, s]);
        assert_close(&after(&FORCE_M_PLANE, &[0.0, 1.0], 1.0), &[-s, c]);
    }

    /// A matrix a bᵀ becomes that of the rotated a and b.
    #[test]
    fn matrices_are_turned_on_both_sides() {
        fn check<const N: usize>(matrix: &'static Quantity, vector: &'static Quantity, [a, b]: [[f64; N]; 2]) {
            let product: Vec<_> = a.iter().flat_map(|a| b.map(|b| a * b)).collect();
            let [a, b] = [a, b].map(|numbers| after(vector, &numbers, 1.0));
            let expected: Vec<_> = a.iter().flat_map(|&a| b.iter().map(move |&b| a * b)).collect();
            assert_close(&after(matrix, &product, 1.0), &expected);
        }
        check(&K_U1_U1, &FORCE, [[1.0, 2.0, -3.0], [5.0, -7.0, 11.0]]);
        check(&K_U1_U1_PLANE, &FORCE_M_PLANE, [[1.0, 2.0], [5.0, -7.0]]);
    }

    #[test]
    fn a_formula_that_is_not_objective_is_homogeneous_alone() {
        let statements = |subject: &Subject| -> Vec<_> {
            of_all(subject).into_iter().map(|law| law.statement.split(':').next().map(str::to_owned)).collect()
        };
        let [homogeneity, indifference] =
            ["dimensional homogeneity", "frame indifference"].map(|name| Some(name.into()));
        assert_eq!(statements(&Subject::of::<ContactForce>()), [homogeneity.clone(), indifference]);
        assert_eq!(statements(&Subject::of::<Basis>()), [homogeneity]);
    }

    #[test]
    fn laws_hold_at_a_point_and_rounding_is_judged_by_the_sizes_of_the_inputs() {
        let subject = Subject::of::<RelativePosition>();
        let inputs = exact(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 3.0, -2.0, 5.0, 7.0, 1.0, 4.0]);
        for law in of_all(&subject) {
            let sides = (law.sides)(&inputs);
            assert_eq!(sides.len(), 3);
            assert!(sides.iter().all(|equation| residual(equation) < 1e-60), "{}: {sides:?}", law.statement);
            if law.statement.starts_with("frame") {
                // The square of the sum of 1 and all inputs, plus the value itself: (4, 3, −1).
                let scales: Vec<_> = sides.iter().map(|equation| equation.scale.to_f64()).collect();
                assert_eq!(scales, [26.0 * 26.0 + 4.0, 26.0 * 26.0 + 3.0, 26.0 * 26.0 + 1.0]);
            }
        }
    }
}
