//! A formula as the toolkit uses it: functions of components in order.
//!
//! Everything else in the toolkit is written for slices and compiled once. Only this file is compiled for each
//! formula.

use super::jet::{Sweep, differentiate, exact_jacobian, jacobian, value};
use crate::formula::proof::{self, Case, Convention, Equation, Proved, ProvedElement, Step};
use crate::formula::{self, Field, Fields, Formula, Spec, entries, typed};
use crate::toolkit::graph::{self, Extremes, Graph, NotRecorded, Op};
use crate::{Error, Octuple, Scalar};
use std::borrow::Cow;
use std::cell::OnceCell;

/// A formula with its types erased: what the toolkit works on.
pub struct Subject {
    pub(crate) spec: Spec,
    pub(crate) inputs: &'static [Field],
    pub(crate) outputs: &'static [Field],
    /// Whether inputs are valid.
    pub(crate) check: fn(&[f64]) -> Result<(), Error>,
    /// Whether inputs in 237 bits are valid together.
    pub(crate) is_valid: fn(&[Octuple]) -> bool,
    /// Realistic inputs, from components that were drawn one by one.
    pub(crate) placed: fn(&[f64]) -> Vec<f64>,
    /// The value, and the closed-form Jacobian output by output.
    pub(crate) value: fn(&[f64]) -> Vec<f64>,
    pub(crate) jacobian: fn(&[f64]) -> Vec<f64>,
    /// The Jacobian by automatic differentiation, for a formula without a closed-form Jacobian.
    pub(crate) automatic: fn(&[f64]) -> Vec<f64>,
    /// Value and Jacobian in one pass.
    pub(crate) linearized: fn(&[f64]) -> [Vec<f64>; 2],
    /// Value and Jacobian in 237 bits.
    pub(crate) exact_value: fn(&[Octuple]) -> Vec<Octuple>,
    pub(crate) exact_jacobian: fn(&[Octuple]) -> Vec<Octuple>,
    /// Value and Jacobian in dual numbers over 237 bits.
    dual_value: fn(&[Sweep<Octuple>]) -> Vec<Sweep<Octuple>>,
    dual_jacobian: fn(&[Sweep<Octuple>]) -> Vec<Sweep<Octuple>>,
    /// The formula's own cases, and invalid ones.
    pub(crate) cases: fn() -> Vec<Case<Vec<f64>>>,
    pub(crate) invalid_cases: fn() -> Vec<Case<Vec<f64>>>,
    /// The points with the largest backward errors that a search found.
    pub(crate) worst: Vec<Case<Vec<f64>>>,
    /// Records the graph, which is slow.
    pub(crate) record: fn() -> Cow<'static, Result<Graph, NotRecorded>>,
    /// The recorded graph, once it was requested.
    graph: OnceCell<Cow<'static, Result<Graph, NotRecorded>>>,
    pub(crate) kinks: Vec<Kink>,
    pub(crate) laws: Vec<Law>,
}

/// A function of components.
type AtComponents<T> = Box<dyn Fn(&[Octuple]) -> T>;

/// A [kink](proof::Kink) with its types erased.
pub(crate) struct Kink {
    pub(crate) condition: String,
    pub(crate) convention: Convention,
    pub(crate) holds: AtComponents<bool>,
    pub(crate) at: Vec<f64>,
    pub(crate) across: Vec<f64>,
}

/// A [law](proof::Law) with its types erased.
pub(crate) struct Law {
    pub(crate) statement: String,
    pub(crate) sides: AtComponents<Vec<Equation>>,
}

impl Subject {
    /// This formula.
    pub fn of<F: Proved>() -> Self {
        Self {
            spec: F::SPEC,
            inputs: F::Inputs::<f64>::FIELDS,
            outputs: F::Outputs::<f64>::FIELDS,
            check: |i| formula::check::<F>(&typed(i)),
            is_valid: |i| F::validate(&typed::<Octuple, _>(i)).is_ok(),
            placed: |i| F::placed(typed(i)).components(),
            value: value::<F, _>,
            jacobian: jacobian::<F, _>,
            automatic: |i| {
                if const { F::SPEC.is_closed() } {
                    return Vec::new();
                }
                entries(&proof::value_and_jacobian_by_ad::<F, f64>(&typed(i)).1)
            },
            linearized: |i| {
                let (value, jacobian) = F::linearized(&typed(i));
                [value.components(), entries(&jacobian)]
            },
            exact_value: value::<F, _>,
            exact_jacobian: exact_jacobian::<F, _>,
            dual_value: value::<F, _>,
            dual_jacobian: exact_jacobian::<F, _>,
            cases: || F::cases().into_iter().map(flat::<F>).collect(),
            invalid_cases: || F::invalid_cases().into_iter().map(flat::<F>).collect(),
            worst: Vec::new(),
            record: || Cow::Owned(graph::record::<F>()),
            graph: OnceCell::new(),
            kinks: F::kinks().into_iter().map(Kink::of).collect(),
            laws: F::laws().into_iter().map(Law::of).collect(),
        }
    }

    /// An element with or without friction, as a formula without a closed-form Jacobian.
    pub(crate) fn of_element<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize, const RUBS: bool>() -> Self {
        Self {
            spec: E::SPEC,
            inputs: proof::inputs::<E, M, DOFS>(RUBS),
            outputs: &[],
            check: |i| {
                let Step { nodes, multipliers, parameters, before } = Step::<E, _, M, DOFS>::of(i, RUBS);
                parameters.check(&nodes, &multipliers, &before)
            },
            is_valid: |i| {
                let Step { nodes, parameters, .. } = Step::<E, _, M, DOFS>::of(i, RUBS);
                E::validate(&nodes, &parameters).is_ok()
            },
            placed: |i| E::placed(Step::of(i, RUBS)).components(),
            value: results::<E, _, M, DOFS, RUBS>,
            jacobian: derivatives::<E, _, M, DOFS, RUBS>,
            automatic: derivatives::<E, _, M, DOFS, RUBS>,
            linearized: |i| [results::<E, _, M, DOFS, RUBS>(i), derivatives::<E, _, M, DOFS, RUBS>(i)],
            exact_value: results::<E, _, M, DOFS, RUBS>,
            exact_jacobian: derivatives::<E, _, M, DOFS, RUBS>,
            dual_value: results::<E, _, M, DOFS, RUBS>,
            // The second derivative is needed only for closed forms.
            dual_jacobian: |_| Vec::new(),
            cases: || {
                let cases = E::cases().into_iter().filter(|case| case.inputs.parameters.contact.is_some() == RUBS);
                cases
                    .map(|Case { id, flag, comment, inputs }| Case { id, flag, comment, inputs: inputs.components() })
                    .collect()
            },
            invalid_cases: Vec::new,
            worst: Vec::new(),
            record: || Cow::Owned(graph::record_element::<E, M, DOFS>(RUBS, Extremes::Nan)),
            graph: OnceCell::new(),
            kinks: Vec::new(),
            laws: Vec::new(),
        }
    }

    /// The Jacobian by automatic differentiation.
    pub(crate) fn derivative(&self, exact: &[Octuple]) -> Vec<Octuple> {
        self.derivative_of()(exact)
    }

    /// [`derivative`](Self::derivative) as a function that can be stored.
    pub(crate) fn derivative_of(&self) -> impl Fn(&[Octuple]) -> Vec<Octuple> + Copy + 'static {
        let value = self.dual_value;
        move |exact| differentiate(exact, &value).concat()
    }

    /// The gradient of every entry of the Jacobian.
    pub(crate) fn second_derivative(&self, exact: &[Octuple]) -> Vec<Vec<Octuple>> {
        differentiate(exact, &self.dual_jacobian)
    }

    /// Its recorded operations.
    pub(crate) fn graph(&self) -> Result<&Graph, &NotRecorded> {
        self.graph.get_or_init(self.record).as_ref().as_ref()
    }

    /// The graph, or why it cannot reveal kinks.
    pub(crate) fn telling_graph(&self) -> Result<&Graph, String> {
        let graph = self.graph().map_err(ToString::to_string)?;
        if graph.ops().iter().any(|op| matches!(op, Op::Search(..))) {
            return Err(
                "the formula is an iterative search, and no single operation shows where its result jumps".into()
            );
        }
        Ok(graph)
    }

    /// The kink that these inputs are on.
    pub(crate) fn kink(&self, exact: &[Octuple]) -> Option<Convention> {
        self.kinks.iter().find(|kink| (kink.holds)(exact)).map(|kink| kink.convention)
    }
}

impl Kink {
    fn of<F: Formula>(kink: proof::Kink<F>) -> Self {
        Self {
            condition: kink.condition,
            convention: kink.convention,
            holds: Box::new(move |i| (kink.holds)(&typed(i))),
            at: kink.at.components(),
            across: kink.across.components(),
        }
    }
}

impl Law {
    fn of<F: Formula>(law: proof::Law<F>) -> Self {
        Self { statement: law.statement, sides: Box::new(move |i| (law.sides)(&typed(i))) }
    }
}

/// The results of an element, from components.
fn results<E: ProvedElement<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize, const RUBS: bool>(
    i: &[D],
) -> Vec<D> {
    Step::<E, D, M, DOFS>::of(i, RUBS).results()
}

/// The derivatives of all results with respect to all components, output by output.
fn derivatives<E: ProvedElement<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize, const RUBS: bool>(
    i: &[D],
) -> Vec<D> {
    differentiate(i, &results::<E, _, M, DOFS, RUBS>).concat()
}

fn flat<F: Formula>(case: Case<F::Inputs<f64>>) -> Case<Vec<f64>> {
    Case { id: case.id, flag: case.flag, comment: case.comment, inputs: case.inputs.components() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::coulomb::ReturnMap;
    use crate::contact::slide_line::ClosestParabolic;
    use crate::toolkit::verify::exact;

    #[test]
    fn a_subject_is_its_formula() {
        let subject = Subject::of::<ReturnMap>();
        let (sticks, slips) = ([1.0, 0.5, 4.0], [3.0, 0.5, 4.0]);
        assert_eq!(((subject.value)(&sticks), (subject.value)(&slips)), (vec![1.0], vec![2.0]));
        assert_eq!((subject.jacobian)(&slips), [0.0, 4.0, 0.5]);
        assert_eq!((subject.linearized)(&slips), [vec![2.0], vec![0.0, 4.0, 0.5]]);
        assert_eq!((subject.exact_value)(&exact(&slips)), exact(&[2.0]));
        assert_eq!((subject.exact_jacobian)(&exact(&sticks)), exact(&[1.0, 0.0, 0.0]));
        assert_eq!(subject.derivative(&exact(&slips)), exact(&[0.0, 4.0, 0.5]));
        let second = subject.second_derivative(&exact(&slips));
        assert_eq!(second, [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]].map(|row| exact(&row)));
        assert!((subject.check)(&slips).is_ok() && (subject.check)(&[1.0, -0.5, 4.0]).is_err());
        assert_eq!((subject.placed)(&slips), slips);
        assert_eq!((subject.cases)()[1].inputs, slips);
    }

    #[test]
    fn the_kink_is_that_on_which_the_inputs_are() {
        let subject = Subject::of::<ReturnMap>();
        let at = |f_trial| subject.kink(&exact(&[f_trial, 0.5, 4.0]));
        assert_eq!([1.0, 2.0, -2.0].map(at), [None, Some(Convention::Switch), Some(Convention::Switch)]);
        let kink = &subject.kinks[0];
        assert_eq!((&*kink.at, &*kink.across), ([2.0, 0.5, 4.0].as_slice(), [1.0, 0.0, 0.0].as_slice()));
    }

    #[test]
    fn the_graph_of_a_search_does_not_tell() {
        assert!(Subject::of::<ReturnMap>().telling_graph().is_ok());
        let why = Subject::of::<ClosestParabolic>().telling_graph().expect_err("it is a search");
        assert!(why.starts_with("the formula is an iterative search"), "{why}");
    }
}
