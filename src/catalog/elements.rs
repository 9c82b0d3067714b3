//! Elements whose types the compiler does not know.

use crate::Error;
use crate::formula::proof::{self, ProvedElement, Step};
use crate::formula::{Field, Spec};
use crate::toolkit::graph::{Extremes, Graph, NotRecorded, record_element};
use crate::toolkit::verify::{ElementAudit, ElementFile, ElementSubject, Layout, Options, audit_element, golden_of};

/// An element whose nodes, parameters and state are not known to the compiler; every [`ProvedElement`] is one by [`Erased`].
pub trait AnyElement: Send + Sync {
    /// What is said about it.
    fn spec(&self) -> Spec;
    /// Its degrees of freedom, forces, residuals, multipliers, parameters and state in order.
    fn layout(&self) -> Layout;
    /// What it computes from, in order: nodes, multipliers, start, and, where it rubs, contact and state.
    fn inputs(&self, rubs: bool) -> &'static [Field];
    /// Its golden file, computed now.
    fn golden(&self) -> ElementFile;
    /// Its audit, executed now.
    fn audit(&self, options: &Options) -> ElementAudit;
    /// What it does, written down: its results are those of [`value`](Self::value).
    ///
    /// # Errors
    /// What in it cannot be written down.
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded>;
    /// Its results at components of the inputs in order: residuals, rows, forces, stiffness, derivative by the multipliers, each
    /// matrix row by row, and, where it rubs, the state after.
    ///
    /// # Errors
    /// The input that is not valid, and where something overflows; [`Error::Components`] where their number is wrong.
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error>;
}

/// An element without its types.
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
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded> {
        record_element::<E, M, DOFS>(rubs, extremes)
    }
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error> {
        super::expect(self.inputs(rubs).iter().map(Field::len).sum(), components.len())?;
        Step::<E, f64, M, DOFS>::of(components, rubs).checked_results()
    }
}
