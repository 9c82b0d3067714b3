//! The audit of an element, common to all elements: its numbers are consistent in 237 bits.
//!
//! Rows are the derivative of the residuals, forces are rowsᵀ λ and friction, the matrix is the derivative of the
//! forces; forces and moments do no work in a rigid-body motion; friction dissipates.

mod compare;
mod form;
mod golden;
mod laws;
mod linear;
#[cfg(test)]
mod tests;

pub(crate) use form::ElementSubject;
pub use form::Layout;
pub(crate) use golden::of as golden_of;
pub use golden::{ELEMENT_LAYOUT, ElementFile, ElementRecord, Out};

use super::Sensitivity;
use super::claim::Claim;
use super::eta::eta_beside;
use super::point::{Options, Point, random_points};
use crate::Octuple;
use crate::formula::proof::{Case, Convention, Flag, ProvedElement};
use compare::{DIFFERENCES, EXACT, compare, largest};
use form::{Form, Here, Names};
use laws::Laws;
use linear::{Matrix, Vector, beside, column};
use serde::{Deserialize, Serialize};
use std::iter;

/// The result of an audit of one element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ElementAudit {
    /// The element's identifier.
    pub element: String,
    /// Document and section, and how completely it is printed there.
    pub provenance: String,
    /// Its own cases, without and with friction.
    pub named_points: usize,
    /// Random points, without and with friction.
    pub random_points: usize,
    /// The seed of the random points.
    pub seed: u64,
    /// Every claim.
    pub claims: Vec<Claim>,
}

impl ElementAudit {
    /// Whether every claim was checked, and none failed.
    pub fn passed(&self) -> bool {
        self.claims.iter().all(Claim::held)
    }
}

/// Audits one element.
pub fn audit_element<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>(options: &Options) -> ElementAudit {
    audit(&ElementSubject::of::<E, M, DOFS>(), options)
}

pub(crate) fn audit(element: &ElementSubject, options: &Options) -> ElementAudit {
    let mut claims = Claims::new(element);
    let names = element.layout.names();
    let (mut named_points, mut random) = (0, 0);
    for form in &element.forms {
        let cases = (form.subject.cases)().into_iter().filter(|case| (form.subject.check)(&case.inputs).is_ok());
        let named = |case: Case<Vec<f64>>| {
            let kink = (case.flag == Flag::Kink).then_some(Convention::Switch);
            Point { kink, ..Point::new(&form.subject, case.id, false, case.inputs) }
        };
        let named: Vec<_> = cases.map(named).collect();
        let drawn = random_points(&form.subject, options, 0..options.samples);
        (named_points, random) = (named_points + named.len(), random + drawn.len());
        for point in named.iter().chain(&drawn) {
            claims.check(&element.layout, &names, form, point);
        }
    }
    ElementAudit {
        element: element.spec.id.into(),
        provenance: format!("{}; {}", element.spec.source, element.spec.source.provenance),
        named_points,
        random_points: random,
        seed: options.seed,
        claims: claims.all(),
    }
}

/// All claims about an element.
struct Claims {
    rows: Claim,
    forces: Claim,
    stiffness: Claim,
    differences: Claim,
    laws: Laws,
    eta: Claim,
}

impl Claims {
    fn new(element: &ElementSubject) -> Self {
        let (bounds, by) = element.spec.bounds();
        Self {
            rows: Claim::new(
                "rows = derivative of the residuals with respect to the degrees of freedom, in 237 bits",
                EXACT,
            ),
            forces: Claim::new(
                if element.layout.held() > 0 {
                    "forces = rowsᵀ λ, and friction against its motions, in 237 bits"
                } else {
                    "forces = derivative of the virtual work of pressure and shear, with these held, in 237 bits"
                },
                EXACT,
            ),
            stiffness: Claim::new(
                "matrix = derivative of the forces with respect to degrees of freedom and multipliers, in 237 bits",
                EXACT,
            ),
            differences: Claim::new("automatic differentiation = differences, in 237 bits", DIFFERENCES),
            laws: Laws::new(element),
            eta: Claim::new(format!("η of every number in f64{by}"), bounds.value),
        }
    }

    fn all(self) -> Vec<Claim> {
        let mut all = vec![self.rows, self.forces, self.stiffness, self.differences];
        all.extend(self.laws.all());
        all.push(self.eta);
        all
    }

    fn check(&mut self, layout: &Layout, names: &Names, form: &Form, point: &Point) {
        let here = form.at(layout, point.exact.clone());
        // Points where the residuals vanish, if the rows are their derivative only there.
        let elsewhere = (!form.has_exact_rows).then(|| form.at(layout, (form.held)(&point.exact)));
        let held = elsewhere.as_ref().unwrap_or(&here);

        let (by, zeros) = (&held.derivative.residuals, Matrix::zeros(layout.conditions(), layout.held()));
        let rows = beside(&held.found.rows, &zeros);
        compare(&mut self.rows, point, &rows, by, &beside(&held.sizes.rows, &zeros), |row, k| {
            format!("∂{}/∂{}", names.residuals[row], names.variables[k])
        });
        let [forces, work, size] = [&here.found.forces, &here.work(), &here.sizes.forces].map(column);
        compare(&mut self.forces, point, &forces, &work, &size, |row, _| names.forces[row].clone());
        let [matrix, size] = [&here.found, &here.sizes].map(|found| beside(&found.stiffness, &found.by_multipliers));
        compare(&mut self.stiffness, point, &matrix, &here.derivative.forces, &size, |row, k| {
            format!("∂{}/∂{}", names.forces[row], names.variables[k])
        });
        // Differences across a kink are not the derivative on its one side.
        if point.kink.is_none() {
            let [found, expected, size] = form.along(layout, &here, &point.label).map(|x| column(&Vector::from_vec(x)));
            compare(&mut self.differences, point, &found, &expected, &size, |k, _| {
                format!("{} along a motion of everything", names.conditions_and_forces(k))
            });
        }
        self.laws.check(layout, form, point, &here, held);
        self.check_eta(names, form, point, &here);
    }

    /// Checks every number in `f64`; if bounds are normwise, relative to the largest number of its block.
    fn check_eta(&mut self, names: &Names, form: &Form, point: &Point, here: &Here) {
        let of_size = |size: Octuple| Sensitivity::none().plus(size);
        let computed = (form.subject.value)(&point.inputs);
        for (k, ((&computed, &exact), &size)) in computed.iter().zip(&here.results).zip(&here.scales).enumerate() {
            let own = eta_beside(computed, exact, of_size(size));
            let block = || {
                let same = here.scales.iter().zip(&names.blocks).filter(|(_, block)| **block == names.blocks[k]);
                own.min(eta_beside(computed, exact, of_size(largest(same.map(|(&size, _)| size)))))
            };
            let sizes = iter::once(own).chain(form.subject.spec.normwise.iter().map(|_| block()));
            let describe = |size| point.deviation(size, names.results[k].clone(), computed, exact.to_f64());
            self.eta.record_last(sizes, self.eta.bound, describe);
        }
    }
}
