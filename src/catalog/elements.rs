//! Elements whose types the compiler does not know.

use super::form::{AnyForm, Form};
use super::formed::Formed;
use super::formulas::{count, expect};
use crate::Error;
use crate::formula::proof::{self, Case, ProvedElement, Step};
use crate::formula::{Field, Spec};
use crate::toolkit::graph::{Extremes, Graph, NotRecorded, record_element};
use crate::toolkit::verify::{
    ElementAudit, ElementFile, ElementSubject, Layout, Options, Subject, audit_element, golden, golden_of,
};

/// An element whose types are erased; every [`ProvedElement`] is one by [`Erased`].
pub trait AnyElement: AnyForm {
    /// Its golden file, computed anew.
    fn golden(&self) -> ElementFile;
    /// Its audit, executed anew.
    fn audit(&self, options: &Options) -> ElementAudit;
    /// The element in another form; it is kept while the process runs.
    ///
    /// # Errors
    /// What the form needs and the element does not have.
    fn in_form(&self, form: Form) -> Result<&'static dyn AnyForm, &'static str>;
}

/// An element with its types erased.
#[derive(Clone, Copy, Debug)]
pub struct Erased<E, const M: usize, const DOFS: usize>(pub E);

impl<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize> AnyForm for Erased<E, M, DOFS> {
    fn spec(&self) -> Spec {
        E::SPEC
    }
    fn layout(&self) -> Layout {
        Layout::of::<E, M, DOFS>()
    }
    fn inputs(&self, rubs: bool) -> &'static [Field] {
        proof::inputs::<E, M, DOFS>(rubs)
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

impl<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize> AnyElement for Erased<E, M, DOFS> {
    fn golden(&self) -> ElementFile {
        golden_of(&ElementSubject::of::<E, M, DOFS>())
    }
    fn audit(&self, options: &Options) -> ElementAudit {
        audit_element::<E, M, DOFS>(options)
    }
    fn in_form(&self, form: Form) -> Result<&'static dyn AnyForm, &'static str> {
        // One leak per form that is asked for.
        Ok(Box::leak(Box::new(Formed::<E, M, DOFS>::new(Box::new(*self), form)?)))
    }
}
