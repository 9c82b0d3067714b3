//! The recorded graph of a formula computes the same as the formula.

mod by_rows;

use crate::common;
use by_rows::by_rows_in_words;
use jointproof::catalog::{AnyFormula, CATALOG, ELEMENTS};
use jointproof::connector::slot::{Contact, ContactForce as SlotContactForce, CrossForces};
use jointproof::formula::{Component, Field, Formula, Jacobian, Spec};
use jointproof::number::scalar::norm;
use jointproof::toolkit::graph::{Extremes, Graph, NotRecorded, Op, Statement, record, record_with};
use jointproof::toolkit::measure::Options;
use jointproof::toolkit::verify::golden::components;
use jointproof::{Error, Scalar};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::fmt::Write;
use std::sync::LazyLock;

/// The inputs of all valid golden cases, and random ones.
fn points(formula: &dyn AnyFormula, random: usize) -> Vec<Vec<f64>> {
    let cases = common::golden(formula).cases.into_iter().filter(|case| case.out.is_some());
    let cases = cases.map(|case| components(formula.inputs(), &case.inputs).unwrap());
    let random = formula.timing_inputs(&Options { timing_points: random, ..Options::quick() });
    let count = formula.inputs().iter().map(Field::len).sum();
    cases.chain(random.chunks(count).map(<[f64]>::to_vec)).collect()
}

fn bits(value: &[f64], jacobian: &[f64]) -> Vec<u64> {
    value.iter().chain(jacobian).map(|x| x.to_bits()).collect()
}

/// The graphs of all formulas, recorded once.
static GRAPHS: LazyLock<Vec<Graph>> = LazyLock::new(|| {
    let graph =
        |formula: &&dyn AnyFormula| formula.graph().unwrap_or_else(|why| panic!("{}: {why}", formula.spec().id));
    CATALOG.par_iter().map(graph).collect()
});

#[test]
fn every_formula_is_recorded_and_gives_its_own_bits() {
    CATALOG.par_iter().zip(&*GRAPHS).for_each(|(formula, graph)| {
        let id = formula.spec().id;
        for inputs in points(*formula, 200) {
            let (value, jacobian) = formula.value_and_closed_jacobian(&inputs).unwrap();
            let (found, entries) = graph.run(&inputs);
            assert_eq!(bits(&found, &entries), bits(&value, &jacobian), "{id} at {inputs:?}");
        }
    });
}

/// Where extremes are NaN, some results are NaN too, and their row is computed again.
#[test]
fn every_element_is_recorded_and_gives_its_own_bits() {
    for (element, rubs) in ELEMENTS.iter().flat_map(|element| [(element, false), (element, true)]) {
        if rubs && element.layout().contact.is_empty() {
            continue;
        }
        let id = element.spec().id;
        let [by_rows, alone] = [Extremes::Nan, Extremes::Joined]
            .map(|extremes| element.graph(rubs, extremes).unwrap_or_else(|why| panic!("{id}: {why}")));
        // A contact computes the pressure of an open place too, and leaves it out.
        let shows = by_rows_in_words(&by_rows) != "\n" || element.layout().multipliers.is_empty();
        assert!(shows, "{id}, friction {rubs}: where a number is NaN, a result is");
        let (mut compared, mut valid) = (0, 0);
        for case in common::golden_of_element(*element).cases {
            let Ok(inputs) = components(element.inputs(rubs), &case.inputs) else { continue };
            let Ok(value) = element.value(&inputs, rubs) else { continue };
            valid += 1;
            assert_eq!(bits(&alone.run(&inputs).0, &[]), bits(&value, &[]), "{id} at {inputs:?}");
            let found = by_rows.run(&inputs).0;
            if found.iter().all(|x| x.is_finite()) {
                compared += 1;
                assert_eq!(bits(&found, &[]), bits(&value, &[]), "{id} at {inputs:?}");
            }
        }
        assert!(compared > valid / 2 && valid > 5, "{id}, friction {rubs}: {compared} of {valid} points");
    }
}

/// The line of the table for a formula, from its graph.
fn line(formula: &dyn AnyFormula, graph: &Graph) -> String {
    let is_zero = |entry: usize| graph.constant(graph.jacobian[entry]).is_some_and(|x| x.to_bits() == 0);
    let mut digits = vec![0_u8; graph.jacobian.len().div_ceil(4)];
    for entry in (0..graph.jacobian.len()).filter(|&entry| !is_zero(entry)) {
        digits[entry / 4] |= 1 << (entry % 4);
    }
    let mut line = format!("{} ", formula.spec().id);
    if !formula.spec().is_closed() {
        line.push('-');
    }
    for digit in digits {
        write!(line, "{digit:x}").unwrap();
    }
    let by_rows = formula.graph_with(Extremes::Nan).unwrap();
    line + by_rows_in_words(&by_rows)
}

#[test]
fn batches_know_the_structure_of_every_formula() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/toolkit/batch/structure.txt");
    let now: String = CATALOG.par_iter().zip(&*GRAPHS).map(|(formula, graph)| line(*formula, graph)).collect();
    if now != std::fs::read_to_string(path).unwrap() {
        let beside = std::env::temp_dir().join("structure.txt");
        std::fs::write(&beside, now).unwrap();
        panic!("{path} is not what was recorded; to accept: mv {} {path}", beside.display());
    }
}

/// Both sides of a comparison are recorded, whichever is taken: those of a pressure, and those of a length that is 0 or large.
#[test]
fn a_graph_has_both_sides() {
    let graph = |id| jointproof::catalog::find(id).unwrap().graph().unwrap();
    let run = |graph: &Graph, inputs: &[f64]| graph.run(inputs).0;
    let law = graph("interaction.pressure_linear");
    assert_eq!((run(&law, &[2.0, 3.0]), run(&law, &[-2.0, 3.0])), (vec![6.0], vec![0.0]));
    let force = graph("slot.contact_force");
    assert_eq!(force.run(&[0.0, 0.0]), (vec![0.0], vec![0.0, 0.0]));
    assert_eq!(force.run(&[3.0, 4.0]), (vec![5.0], vec![0.6, 0.8]));
    let large = 2.0_f64.powi(600);
    assert_eq!(force.run(&[3.0 * large, 4.0 * large]), (vec![5.0 * large], vec![0.6, 0.8]));
}

/// A planted formula of two forces.
trait Planted: Copy + Send + Sync + 'static {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D;
    fn validate<D: Scalar>(_: &CrossForces<D>) -> Result<(), Error> {
        Ok(())
    }
}

/// The formula of it; its derivative is not used.
#[derive(Clone, Copy, Debug)]
struct Of<P>(P);

impl<P: Planted> Formula for Of<P> {
    const SPEC: Spec = SlotContactForce::SPEC;
    type Inputs<T: Component> = CrossForces<T>;
    type Outputs<T: Component> = Contact<T>;

    fn eval<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
        Contact { fc: P::fc(i) }
    }

    fn jacobian<D: Scalar>(i: &CrossForces<D>) -> Jacobian<Self, D> {
        Contact { fc: CrossForces { f2: i.f2, f3: i.f3 } }
    }

    fn validate<D: Scalar>(i: &CrossForces<D>) -> Result<(), Error> {
        P::validate(i)
    }
}

/// The ways in which a NaN length shows: in a result computed from it, in a result chosen by a comparison that is then false, or
/// in none.
macro_rules! by_a_length {
    ($($name:ident: |$i:ident, $length:ident| $fc:expr;)*) => {
        $(#[derive(Clone, Copy, Debug)]
        struct $name;

        impl Planted for $name {
            fn fc<D: Scalar>($i: &CrossForces<D>) -> D {
                let $length = norm([$i.f2, $i.f3]);
                $fc
            }
        })*
    };
}
by_a_length! {
    IsIt: |i, length| length + i.f2;
    ChoosesBetweenMultiples: |i, length| if length < 1.0 { length * i.f2 } else { length * i.f3 };
    ChoosesItWhereNot: |i, length| if length < 1.0 { i.f2 } else { length };
    ChoosesItWhereSo: |i, length| if length < 1.0 { length } else { i.f2 };
    HidesIt: |i, length| if length < 1.0 { i.f2 } else { i.f3 };
}

/// A formula that rejects inputs by a length, while no result shows whether the length is NaN.
#[derive(Clone, Copy, Debug)]
struct RefusesByIt;

impl Planted for RefusesByIt {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        i.f2 + i.f3
    }

    fn validate<D: Scalar>(i: &CrossForces<D>) -> Result<(), Error> {
        if norm([i.f2, i.f3]) < 1.0 { Err(Error::Overflow { name: "f2" }) } else { Ok(()) }
    }
}

#[test]
fn rows_are_together_only_where_every_extreme_one_is_told() {
    fn words<P: Planted>() -> &'static str {
        by_rows_in_words(&record_with::<Of<P>>(Extremes::Nan).unwrap())
    }
    let described = [words::<IsIt>(), words::<ChoosesBetweenMultiples>(), words::<ChoosesItWhereNot>()];
    assert_eq!(described, [" guarded\n"; 3]);
    assert_eq!([words::<ChoosesItWhereSo>(), words::<HidesIt>(), words::<RefusesByIt>()], ["\n"; 3]);
}

/// A formula that uses a double where it should compare scalars.
#[derive(Clone, Copy, Debug)]
struct LooksAtTheValue;

impl Planted for LooksAtTheValue {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        if i.f2.re() > 0.0 { i.f2 } else { i.f3 }
    }
}

/// A formula that uses a double in its validation, and rejects other inputs.
#[derive(Clone, Copy, Debug)]
struct LooksWhetherValid;

impl Planted for LooksWhetherValid {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        i.f2 + i.f3
    }

    fn validate<D: Scalar>(i: &CrossForces<D>) -> Result<(), Error> {
        let is_valid = i.f2 < i.f3 && i.f2.re().partial_cmp(&1e300) != Some(Ordering::Greater);
        if is_valid { Ok(()) } else { Err(Error::Overflow { name: "f2" }) }
    }
}

/// A formula that calls a function unknown to the graph.
#[derive(Clone, Copy, Debug)]
struct CallsTheUnknown;

impl Planted for CallsTheUnknown {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        i.f2.cbrt()
    }
}

/// Formulas that use the sign of a number, a comparison that is not recorded.
#[derive(Clone, Copy, Debug)]
struct AsksWhetherPositive;

impl Planted for AsksWhetherPositive {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        if i.f2.is_positive() { i.f2 } else { i.f3 }
    }
}

#[derive(Clone, Copy, Debug)]
struct AsksWhetherNegative;

impl Planted for AsksWhetherNegative {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        if i.f2.is_negative() { i.f2 } else { i.f3 }
    }
}

/// A formula with seventeen independent branches.
#[derive(Clone, Copy, Debug)]
struct HasManyWays;

impl Planted for HasManyWays {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        (0..17).fold(i.f2, |sum, k| if i.f3 > f64::from(k) { sum + 1.0 } else { sum * 2.0 })
    }
}

/// A formula that creates numbers from integers.
#[derive(Clone, Copy, Debug)]
struct MakesNumbers;

impl Planted for MakesNumbers {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        let number = |x: Option<D>| x.expect("it is a number");
        i.f2 * number(D::from_i64(-3)) + i.f3 * number(D::from_u64(5)) + number(D::from_f64(0.25))
    }
}

#[test]
fn numbers_are_recorded_however_they_are_made() {
    let graph = record::<Of<MakesNumbers>>().unwrap();
    assert_eq!(graph.run(&[2.0, 7.0]).0, [-6.0 + 35.0 + 0.25]);
}

#[test]
fn what_is_not_recorded_says_why() {
    assert_eq!(record::<Of<LooksAtTheValue>>().unwrap_err(), NotRecorded::Value);
    assert_eq!(record::<Of<LooksWhetherValid>>().unwrap_err(), NotRecorded::Value);
    assert_eq!(record::<Of<CallsTheUnknown>>().unwrap_err(), NotRecorded::Function("cbrt"));
    assert_eq!(record::<Of<AsksWhetherPositive>>().unwrap_err(), NotRecorded::Function("is_sign_positive"));
    assert_eq!(record::<Of<AsksWhetherNegative>>().unwrap_err(), NotRecorded::Function("is_sign_negative"));
    assert_eq!(record::<Of<HasManyWays>>().unwrap_err(), NotRecorded::Combinations(65_536));
}

/// Rejections beyond the domains of single inputs are numbered by reason; the values in these are not known.
#[test]
fn refusals_are_recorded() {
    let graph = jointproof::catalog::find("slider.line").unwrap().graph().unwrap();
    let required: Vec<_> = graph.refusals.iter().map(jointproof::Error::required).collect();
    assert_eq!(required, ["x1 and xn at least 2.2250738585072014e-308 apart"]);
    assert!(graph.refusal.is_some());
    assert!(jointproof::catalog::find("slot.friction").unwrap().graph().unwrap().refusal.is_none());
}

/// A formula whose sums are computed exactly if either is lost to rounding, as those of UJOINT are.
#[derive(Clone, Copy, Debug)]
struct SettlesWhatIsLost;

impl Planted for SettlesWhatIsLost {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        let shared = || (0..20).fold(i.f2, |sum, _| (sum + i.f3).sin());
        let settled = |rough: D, factor: f64| if rough < D::from(1e-9) { shared() * D::from(factor) } else { rough };
        let [sum, difference] = [i.f2 + i.f3, i.f2 - i.f3];
        settled(sum, 3.0) * settled(difference, 5.0)
    }
}

/// The number of operations that are executed whatever the conditions are.
fn always(statements: &[Statement]) -> usize {
    statements.iter().filter(|statement| matches!(statement, Statement::Compute(_))).count()
}

/// Work shared by several choices is not done if none of them needs it.
#[test]
fn shared_work_waits_for_its_condition() {
    let graph = record::<Of<SettlesWhatIsLost>>().unwrap();
    let done = always(&graph.statements(&graph.value));
    assert!(done < 10, "{done} operations are always done");
    for inputs in [[3.0, 1.0], [1.0, 3.0], [-3.0, 1.0], [-1.0, -3.0]] {
        let expected = Of::<SettlesWhatIsLost>::eval(&CrossForces { f2: inputs[0], f3: inputs[1] }).fc;
        assert_eq!(graph.run(&inputs).0, [expected]);
    }
}

/// The same, but the work is needed in any case.
#[derive(Clone, Copy, Debug)]
struct SettlesAndSums;

impl Planted for SettlesAndSums {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        let shared = (0..20).fold(i.f2, |sum, _| (sum + i.f3).sin());
        SettlesWhatIsLost::fc(i) + shared
    }
}

#[test]
fn work_that_is_needed_elsewhere_joins_no_choices() {
    let has_joined = |graph: &Graph| graph.ops().iter().any(|op| op.either_of().is_some());
    assert!(has_joined(&record::<Of<SettlesWhatIsLost>>().unwrap()));
    assert!(!has_joined(&record::<Of<SettlesAndSums>>().unwrap()));
}

/// A result that is computed if one of two conditions fails belongs to one side.
#[derive(Clone, Copy, Debug)]
struct FastWhereBothHold;

impl Planted for FastWhereBothHold {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        if i.f2 > D::one() && i.f3 > D::one() {
            return i.f2 + i.f3;
        }
        (0..20).fold(i.f2, |sum, _| (sum * i.f3).sin())
    }
}

/// A formula with comparisons whose outcomes follow from earlier ones.
#[derive(Clone, Copy, Debug)]
struct AsksAgain;

impl Planted for AsksAgain {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        if i.f2 <= i.f3 {
            i.f2
        } else if i.f2 < i.f3 {
            i.f3 * 3.0
        } else if i.f2 == i.f3 {
            i.f2 * 3.0
        } else {
            i.f2 * 2.0
        }
    }
}

#[test]
fn what_follows_from_a_comparison_is_not_asked() {
    let graph = record::<Of<AsksAgain>>().unwrap();
    let asked = graph.ops().iter().any(|op| *op == Op::Number(3.0_f64.to_bits()));
    assert!(!asked, "{:?}", graph.ops());
    assert_eq!([graph.run(&[1.0, 2.0]).0, graph.run(&[2.0, 1.0]).0], [[1.0], [4.0]]);
}

#[test]
fn the_gradient_of_a_value_is_its_row_of_the_jacobian() {
    for id in ["cardan.beta_two_argument", "interaction.pressure_exponential", "slot.friction", "translator.friction"] {
        let formula = jointproof::catalog::find(id).unwrap();
        let graph = formula.graph().unwrap();
        for inputs in points(formula, 20) {
            let jacobian = formula.value_and_jacobian(&inputs).unwrap().1;
            for (value, row) in graph.value.iter().zip(jacobian.chunks(inputs.len())) {
                let needed = graph.needed(&[*value]);
                let all = graph.results(&inputs, needed.iter().copied());
                let gradient = graph.gradient(*value, &needed, &all, inputs.len());
                let largest = row.iter().fold(0.0_f64, |largest, slope| largest.max(slope.abs()));
                let off = gradient.iter().zip(row).map(|(found, slope)| (found - slope).abs());
                assert!(off.into_iter().all(|off| off <= 1e-9 * largest || off.is_nan()), "{id} at {inputs:?}");
            }
        }
    }
}

/// A formula that uses the order of two numbers.
#[derive(Clone, Copy, Debug)]
struct AsksForTheOrder;

impl Planted for AsksForTheOrder {
    fn fc<D: Scalar>(i: &CrossForces<D>) -> D {
        D::from(match i.f2.partial_cmp(&i.f3) {
            Some(Ordering::Less) => -1.0,
            Some(Ordering::Equal) => 0.0,
            Some(Ordering::Greater) | None => 1.0,
        })
    }
}

#[test]
fn the_order_of_two_numbers_is_recorded() {
    let graph = record::<Of<AsksForTheOrder>>().unwrap();
    let found = [[1.0, 2.0], [2.0, 2.0], [2.0, 1.0]].map(|inputs| graph.run(&inputs).0);
    assert_eq!(found, [[-1.0], [0.0], [1.0]]);
}

#[test]
fn two_conditions_become_one() {
    let graph = record::<Of<FastWhereBothHold>>().unwrap();
    let done = always(&graph.statements(&graph.value));
    assert!(done < 5, "{done} operations are always done");
    for inputs in [[3.0, 4.0], [0.5, 4.0], [4.0, 0.5], [0.25, 0.5]] {
        let expected = Of::<FastWhereBothHold>::eval(&CrossForces { f2: inputs[0], f3: inputs[1] }).fc;
        assert_eq!(graph.run(&inputs).0, [expected]);
    }
}
