//! The search refutes bounds that are a tenth too low, and finds nothing that is not there.

use crate::exact;
use crate::moves::{Around, Reach};
use crate::pass::{Pass, U};
use crate::rounding;
use crate::space::{Dice, Space};
use crate::target::targets;
use crate::{Attack, Effort, attack};
use jointproof::catalog::AnyFormula;
use jointproof::connector::{hinge, join, slider, slot, translator, ujoint};
use jointproof::contact::{interaction, slide_line};
use jointproof::element::cardan;
use jointproof::formula::proof::Proved;
use jointproof::formula::{Component, Formula, Jacobian, Spec, ValueAndJacobian};
use jointproof::toolkit::bound::Head;
use jointproof::toolkit::graph::Number;
use jointproof::{Error, Octuple, Scalar};
use std::marker::PhantomData;

/// A formula with other bounds, in thousandths.
#[derive(Debug)]
struct Stated<F, const VALUE: u32, const JACOBIAN: u32>(PhantomData<F>);

impl<F, const VALUE: u32, const JACOBIAN: u32> Clone for Stated<F, VALUE, JACOBIAN> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F, const VALUE: u32, const JACOBIAN: u32> Copy for Stated<F, VALUE, JACOBIAN> {}

impl<F: Formula, const VALUE: u32, const JACOBIAN: u32> Formula for Stated<F, VALUE, JACOBIAN> {
    const SPEC: Spec = {
        let spec = F::SPEC;
        let [value, jacobian] = [VALUE as f64 / 1000.0, JACOBIAN as f64 / 1000.0];
        spec.eta(value, jacobian)
    };
    type Inputs<T: Component> = F::Inputs<T>;
    type Outputs<T: Component> = F::Outputs<T>;

    fn eval<D: Scalar>(i: &F::Inputs<D>) -> F::Outputs<D> {
        F::eval(i)
    }
    fn jacobian<D: Scalar>(i: &F::Inputs<D>) -> Jacobian<F, D> {
        F::jacobian(i)
    }
    fn linearized<D: Scalar>(i: &F::Inputs<D>) -> ValueAndJacobian<F, D> {
        F::linearized(i)
    }
    fn validate<D: Scalar>(i: &F::Inputs<D>) -> Result<(), Error> {
        F::validate(i)
    }
}

impl<F: Proved, const VALUE: u32, const JACOBIAN: u32> Proved for Stated<F, VALUE, JACOBIAN> {
    fn placed(drawn: F::Inputs<f64>) -> F::Inputs<f64> {
        F::placed(drawn)
    }
}

/// Attacks a formula that states a bound of its value, or of its Jacobian, nine tenths of what is known to be reached.
fn refuted<F: Proved, const VALUE: u32, const JACOBIAN: u32>() -> Attack {
    let formula = Stated::<F, VALUE, JACOBIAN>(PhantomData);
    let found = attack(&formula, Effort::Evaluations(1_000_000), 1).expect("it is recorded");
    let id = F::SPEC.id;
    assert!(!found.holds(), "{id}: {:?}", found.claims);
    for claim in found.claims.iter().filter(|claim| claim.failures > 0) {
        let worst = claim.worst.as_ref().expect("it failed");
        assert!(worst.size > claim.bound, "{id}: {worst:?}");
    }
    found
}

/// A bound that is not attacked.
const HIGH: u32 = 1_000_000;

#[test]
fn bounds_of_values_that_are_a_tenth_too_low_are_refuted() {
    refuted::<slot::Constraint, 1466, HIGH>();
    refuted::<cardan::BetaTwoArgument, 1680, HIGH>();
    refuted::<join::Constraint, 1480, HIGH>();
    refuted::<hinge::ContactMoment, 1263, HIGH>();
    refuted::<slide_line::LocalBasis, 2177, HIGH>();
    refuted::<slider::Line, 2600, HIGH>();
}

/// What is possible to first order is at most what is proved, also where squares of a ratio underflow.
#[test]
fn no_more_is_possible_than_is_proved() {
    let proved = Head::parse(include_str!("../../../golden/bounds/ujoint.twist_factors.jsonl")).unwrap();
    let proved = [proved.value, proved.jacobian].map(|of| of.bound());
    let attack = attack(&ujoint::TwistFactors, Effort::Evaluations(300_000), 0).unwrap();
    for (possible, proved) in attack.first_order.iter().zip(proved) {
        assert!((0.9 * proved..=proved * (1.0 + 1e-9)).contains(possible), "{possible} of {proved}");
    }
    let graph = ujoint::TwistFactors.graph().unwrap();
    let target = &targets(&ujoint::TwistFactors, &graph)[0];
    let mut pass = Pass::over(&graph, vec![0..1, 1..2]);
    for (inputs, is_rough) in [([1e-115, 1e46], true), ([1.0, 2.0], false)] {
        pass.forwards(&target.needed, &inputs);
        assert_eq!(pass.errors(target.own.0, &target.own.1, false).is_rough, is_rough, "{inputs:?}");
    }
}

#[test]
fn bounds_of_jacobians_that_are_a_tenth_too_low_are_refuted() {
    refuted::<slot::ContactForce, HIGH, 2220>();
    refuted::<translator::RadialForce, HIGH, 2180>();
    refuted::<ujoint::Reaction, HIGH, 2600>();
    refuted::<interaction::Damping, HIGH, 1850>();
}

/// What is found is found again, at the same point.
#[test]
fn a_search_that_counts_its_evaluations_is_the_same_anywhere() {
    let found = || attack(&slot::ContactForce, Effort::Evaluations(20_000), 7).expect("it is recorded");
    let (first, second) = (found(), found());
    assert_eq!((first.claims, first.evaluations), (second.claims, second.evaluations));
    assert_eq!(first.first_order, second.first_order);
}

/// √(a² + b²) has no η above 1, nor its derivatives one above 3: what exceeds that would be a mistake of the search.
#[test]
fn a_bound_that_is_proved_is_not_refuted() {
    let found = attack(&slot::ContactForce, Effort::Evaluations(300_000), 3).expect("it is recorded");
    assert!(found.holds(), "{:?}", found.claims);
    assert!(found.first_order[0] <= 1.0 + 1e-9 && found.first_order[1] <= 3.0 + 1e-9, "{:?}", found.first_order);
    let reached: Vec<_> =
        found.claims.iter().map(|claim| claim.worst.as_ref().map_or(0.0, |worst| worst.size)).collect();
    assert!(reached[0] > 0.9 && reached[1] > 2.2, "{reached:?}");
}

/// Visits points of a formula by moves of both kinds.
fn visit(formula: &dyn AnyFormula, mut visit: impl FnMut(&Space, &Around, &[f64], &mut Pass)) {
    let graph = formula.graph().expect("it is recorded");
    let (space, targets, mut dice) = (Space::of(formula), targets(formula, &graph), Dice::of("visit", 1));
    let starts = formula.judge().points(&jointproof::toolkit::verify::Options { samples: 3, seed: 1 });
    let start = &starts.last().expect("random ones are the last").1;
    for target in &targets {
        let around = Around { graph: &graph, space: &space, target };
        let (mut inputs, mut pass) = (start.clone(), Pass::over(&graph, crate::target::fields(formula)));
        for k in 0..60 {
            let mut moved = inputs.clone();
            around.step(&mut moved, &mut pass, if k % 2 == 0 { Reach::Far } else { Reach::Near }, &mut dice);
            if space.has(&moved) && formula.value_and_closed_jacobian(&moved).is_ok() {
                inputs = moved;
                pass.forwards(&target.needed, &inputs);
                visit(&space, &around, &inputs, &mut pass);
            }
        }
    }
}

/// The error by the roundings that occur is the error in 237 bits, but for products of roundings.
#[test]
fn errors_in_double_are_those_in_237_bits() {
    let mut compared = 0;
    visit(&slot::Friction, |_, around, inputs, pass| {
        let errors = pass.errors(around.target.own.0, &around.target.own.1, true);
        let eta = exact::eta(around.graph, around.target, inputs, pass);
        if errors.size > 1e-250 && eta > 0.01 {
            let found = errors.actual.abs() / errors.size;
            assert!((found / eta - 1.0).abs() < 1e-6, "{found} {eta} at {inputs:?}");
            assert!(eta <= errors.most / errors.size * (1.0 + 1e-9), "{eta} of {errors:?} at {inputs:?}");
            compared += 1;
        }
    });
    assert!(compared > 100, "{compared}");
}

/// Every rounding is at most as large as it is said to be.
#[test]
fn no_rounding_is_larger_than_the_largest() {
    let mut roundings = 0;
    for formula in [&slot::Friction as &dyn AnyFormula, &cardan::CardanAngles, &interaction::PressureExponential] {
        visit(formula, |_, around, _, pass| {
            for &node in &around.target.own.1 {
                let result = pass.at(node);
                if result.is_finite() && result.abs() > 1e-290 {
                    let [most, actual] = [rounding::most, rounding::actual].map(|of| of(around.graph, node, &pass.all));
                    assert!(actual.abs() <= most * U * result.abs() * (1.0 + 1e-9), "{:?}", around.graph.op(node));
                    roundings += usize::from(actual != 0.0);
                }
            }
        });
    }
    assert!(roundings > 1000, "{roundings}");
}

/// Triads stay orthonormal up to roundings, however long the way.
#[test]
fn triads_stay_triads() {
    let mut turned = 0;
    visit(&cardan::CardanAngles, |space, _, inputs, _| {
        for triad in &space.triads {
            let vectors: Vec<_> = triad.axes.iter().flatten().map(|&k| &inputs[k..k + 3]).collect();
            for (i, a) in vectors.iter().enumerate() {
                for (j, b) in vectors.iter().enumerate() {
                    let product: f64 = a.iter().zip(*b).map(|(a, b)| a * b).sum();
                    assert!((product - f64::from(u8::from(i == j))).abs() < 1e-15, "{vectors:?}");
                }
            }
            turned += 1;
        }
    });
    assert!(turned > 200, "{turned}");
}

/// The search judges by the graph, in which 1/(e − 1) of this formula is recorded as a double, half a rounding off or less. What it
/// reports is judged by the formula itself.
#[test]
fn the_graph_in_237_bits_is_nearly_the_formula() {
    assert_eq!(Octuple::constant(std::f64::consts::PI), Octuple::PI);
    visit(&interaction::PressureExponential, |_, around, inputs, pass| {
        let claims = <dyn AnyFormula>::eta_at(&interaction::PressureExponential, inputs).expect("it is valid");
        let most = claims[usize::from(around.target.is_jacobian)].worst.as_ref().map_or(0.0, |worst| worst.size);
        let eta = exact::eta(around.graph, around.target, inputs, pass);
        assert!(eta <= most + 0.5, "{eta} of {most} at {inputs:?}");
    });
}
