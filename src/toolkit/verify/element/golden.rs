//! Golden files of elements: state and parameters in, right-hand side and matrix out, against which an element in
//! another program is tested.

use super::form::{ElementSubject, Form, Layout};
use crate::Octuple;
use crate::formula::proof::{Case, Flag};
use crate::toolkit::verify::golden::{Description, Provenance, cases_with, describe, four_digits_up, named, render};
use crate::toolkit::verify::{Sensitivity, exact, rounded};
use num_traits::{Signed, Zero};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The version of the layout of golden files of elements.
pub const ELEMENT_LAYOUT: u32 = 1;

/// The number of random cases, without and with friction: each has hundreds of numbers.
const RANDOM: usize = 4;

/// The golden file of one element.
///
/// Degrees of freedom, forces, residuals and multipliers are in the order in which they are described, and so are the rows and
/// columns of matrices. Forces act on the nodes; the matrix is their derivative. A program whose matrix is minus the derivative of
/// its right-hand side, as Abaqus, turns its sign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Golden file of an element", extend("$id" = "urn:jointproof:element"))]
pub struct ElementFile {
    /// Where the schema of this file is.
    #[schemars(extend("const" = "schema.json"))]
    pub schema: String,
    /// The version of this layout.
    #[schemars(extend("const" = ELEMENT_LAYOUT))]
    pub layout: u32,
    /// The element's identifier, which is also the file's name.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub element: String,
    /// Its title.
    #[schemars(length(min = 1))]
    pub title: String,
    /// The document and section it is from.
    #[schemars(length(min = 1))]
    pub source: String,
    /// How much of it is printed there.
    pub provenance: Provenance,
    /// The bound of the backward error η of every number that the implementation in Rust keeps.
    #[schemars(range(min = 0))]
    pub eta: f64,
    /// The degrees of freedom in order.
    #[schemars(length(min = 1))]
    pub unknowns: Vec<Description>,
    /// What acts on them.
    #[schemars(length(min = 1))]
    pub forces: Vec<Description>,
    /// The residuals; without multipliers, what is reported with its derivative.
    pub residuals: Vec<Description>,
    /// Their multipliers, if there are any.
    pub multipliers: Vec<Description>,
    /// Where the nodes are, and how they are turned.
    #[schemars(length(min = 1))]
    pub nodes: Vec<Description>,
    /// What it needs with and without friction: measurements at the start, or the parameters of a pressure law.
    pub start: Vec<Description>,
    /// How it rubs; a case without these does not.
    pub contact: Vec<Description>,
    /// What friction remembers, before and after.
    pub state: Vec<Description>,
    /// The cases.
    #[schemars(length(min = RANDOM))]
    pub cases: Vec<ElementRecord>,
}

/// A case: rejected with an error, or answered by `out`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ElementRecord {
    /// Identifier, unique within the file.
    #[schemars(regex(pattern = r"^\S+$"))]
    pub id: String,
    /// What the case is for.
    #[schemars(length(min = 1))]
    pub flags: Vec<Flag>,
    /// What is to be seen in it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(length(min = 1))]
    pub comment: String,
    /// Nodes, multipliers and start by name, and contact and state where it rubs: exact doubles, or "NaN", "Infinity", "-Infinity".
    #[serde(rename = "in")]
    pub inputs: Map<String, Value>,
    /// The results, exact at the inputs and rounded once to the nearest double.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub out: Option<Out>,
    /// The scale of every number y of them, Σᵢ |∂y/∂xᵢ · xᵢ| + |y| over all inputs, rounded up to four digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub out_scale: Option<Out>,
    /// The kind of error with which the case is rejected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String", regex(pattern = r"^[A-Z][A-Za-z]+$"))]
    pub error: Option<String>,
}

/// What an element adds to a step of Newton's method, matrices row by row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Out {
    /// By how much the conditions are off; without multipliers, what is reported.
    pub residuals: Vec<f64>,
    /// Their derivative with respect to the degrees of freedom.
    pub rows: Vec<Vec<f64>>,
    /// What acts on the nodes.
    pub forces: Vec<f64>,
    /// The derivative of the forces by the degrees of freedom.
    pub stiffness: Vec<Vec<f64>>,
    /// The derivative of the forces by the multipliers; its rows are empty if there are none.
    pub by_multipliers: Vec<Vec<f64>>,
    /// The state after the step; absent where it does not rub.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub after: Option<Map<String, Value>>,
}

impl ElementFile {
    /// The text of the file.
    ///
    /// # Errors
    /// None in practice; those of `serde_json` are passed on.
    pub fn render(&self) -> serde_json::Result<String> {
        render(self)
    }
}

/// The golden file of an element, computed now.
pub(crate) fn of(element: &ElementSubject) -> ElementFile {
    let (spec, layout) = (&element.spec, &element.layout);
    let many = element.forms.len() > 1;
    let cases = element.forms.iter().flat_map(|form| {
        let rubs = if form.rubs { "rubbing-" } else { "smooth-" };
        let mut records: Vec<_> = of_form(form, layout, element.forms.len()).collect();
        if many {
            for record in &mut records {
                record.id.insert_str(0, rubs);
            }
        }
        records
    });
    ElementFile {
        schema: "schema.json".into(),
        layout: ELEMENT_LAYOUT,
        element: spec.id.into(),
        title: spec.title.into(),
        source: spec.source.to_string(),
        provenance: spec.source.provenance.into(),
        eta: spec.bounds().0.value,
        unknowns: describe(layout.unknowns),
        forces: describe(layout.forces),
        residuals: describe(layout.residuals),
        multipliers: describe(layout.multipliers),
        nodes: describe(layout.nodes),
        start: describe(layout.start),
        contact: describe(layout.contact),
        state: describe(layout.state),
        cases: cases.collect(),
    }
}

/// All cases of one of `forms` forms; invalid cases are in the file only once, with the most complete form. On a kink the
/// matrix is that of one side, which another program need not take: such cases are in no file.
fn of_form<'a>(form: &'a Form, layout: &'a Layout, forms: usize) -> impl Iterator<Item = ElementRecord> + 'a {
    let is_last = form.rubs || forms == 1;
    // The numbers of the first case are short.
    let own = (form.subject.cases)();
    let all = cases_with(&form.subject, RANDOM, own.first().map(|case| case.inputs.as_slice()));
    let is_shown = move |case: &Case<_>| case.flag != Flag::Kink && (is_last || case.flag != Flag::Invalid);
    all.into_iter().filter(is_shown).map(|case| record(form, layout, &case))
}

fn record(form: &Form, layout: &Layout, case: &Case<Vec<f64>>) -> ElementRecord {
    let mut record = ElementRecord {
        id: case.id.clone(),
        flags: vec![case.flag],
        comment: case.comment.into(),
        inputs: named(form.subject.inputs, &case.inputs),
        out: None,
        out_scale: None,
        error: None,
    };
    if let Err(error) = (form.subject.check)(&case.inputs) {
        record.error = Some(error.kind().into());
        return record;
    }
    let inputs = exact(&case.inputs);
    let gradients = form.subject.derivative(&inputs);
    let results = (form.subject.exact_value)(&inputs).into_iter().zip(gradients.chunks(inputs.len()));
    let (values, scales): (Vec<_>, Vec<_>) =
        results.map(|(y, gradient)| exact_beside_scale(y, gradient, &inputs)).unzip();
    record.out = Some(out(form, layout, &rounded(&values)));
    record.out_scale = Some(out(form, layout, &scales));
    record
}

/// Numbers below this fraction of their scale are rounding errors in 237 bits of terms that cancel.
const NOTHING: f64 = 1e-60;

/// A number with its scale as in golden files.
fn exact_beside_scale(y: Octuple, gradient: &[Octuple], inputs: &[Octuple]) -> (Octuple, f64) {
    let scale = Sensitivity::new(gradient, inputs).plus(y).size();
    let is_nothing = y.abs() <= scale * NOTHING;
    (if is_nothing { Octuple::zero() } else { y }, four_digits_up(scale.to_f64()))
}

/// Numbers as matrices.
fn out(form: &Form, layout: &Layout, results: &[f64]) -> Out {
    let found = layout.part(results);
    let rows = |matrix: &nalgebra::DMatrix<f64>| matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
    Out {
        residuals: found.residuals.as_slice().to_vec(),
        rows: rows(&found.rows),
        forces: found.forces.as_slice().to_vec(),
        stiffness: rows(&found.stiffness),
        by_multipliers: rows(&found.by_multipliers),
        after: form.rubs.then(|| named(layout.state, &found.after)),
    }
}
