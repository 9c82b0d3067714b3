//! Elements whose types the compiler does not know.

use super::formulas::{count, expect};
use crate::Error;
use crate::formula::proof::{self, Case, ProvedElement, Step};
use crate::formula::{Field, Spec};
use crate::toolkit::graph::{Extremes, Graph, NotRecorded, record_element};
use crate::toolkit::verify::{
    ElementAudit, ElementFile, ElementSubject, Layout, Options, Subject, audit_element, golden, golden_of,
};

/// An element whose types of nodes, parameters and state are erased; every [`ProvedElement`] is one by [`Erased`].
pub trait AnyElement: Send + Sync {
    /// Its specification.
    fn spec(&self) -> Spec;
    /// Its degrees of freedom, forces, residuals, multipliers, parameters and state in order.
    fn layout(&self) -> Layout;
    /// Its inputs in order: nodes, multipliers, start, and, with friction, contact and state.
    fn inputs(&self, rubs: bool) -> &'static [Field];
    /// Its golden file, computed anew.
    fn golden(&self) -> ElementFile;
    /// Its audit, executed anew.
    fn audit(&self, options: &Options) -> ElementAudit;
    /// Its cases without or with friction: its own, every kind of invalid input, and this many random ones.
    fn cases(&self, rubs: bool, random: usize) -> Vec<Case<Vec<f64>>>;
    /// Its graph, whose results are those of [`value`](Self::value).
    ///
    /// # Errors
    /// The reason why the element cannot be recorded.
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded>;
    /// Its results from components of the inputs in order: residuals, rows, forces, stiffness, derivative with respect to the
    /// multipliers, each matrix row by row, and, with friction, the state after the step.
    ///
    /// # Errors
    /// The input that is not valid, or an overflow; [`Error::Components`] if the number of components is wrong.
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error>;
}

/// An element with its types erased.
#[derive(Clone, Copy, Debug)]
pub struct Erased<E, const M: usize, const DOFS: usize>(pub E);

impl<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize> AnyElement for Erased<E, M, DOFS> {
    fn spec(&self) -> Spec {
        E::SPEC
    }
    fn layout(&self) -> Layout {
        Layout::of::<E, M, DOFS>()
    }
    fn inputs(&self, rubs: bool) -> &'static [Field] {
        proof::inputs::<E, M, DOFS>(rubs)
    }
    fn golden(&self) -> ElementFile {
        golden_of(&ElementSubject::of::<E, M, DOFS>())
    }
    fn audit(&self, options: &Options) -> ElementAudit {
        audit_element::<E, M, DOFS>(options)
    }
    fn cases(&self, rubs: bool, random: usize) -> Vec<Case<Vec<f64>>> {
        let of = if rubs { Subject::of_element::<E, M, DOFS, true> } else { Subject::of_element::<E, M, DOFS, false> };
        golden::cases_drawn(&of(), random)
    }
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded> {
        record_element::<E, M, DOFS>(rubs, extremes)
    }
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error> {
        expect(count(self.inputs(rubs)), components.len())?;
        Step::<E, f64, M, DOFS>::of(components, rubs).checked_results()
    }
}
