//! Formulas whose types the compiler does not know.

use super::worst;
use crate::connector::align;
use crate::formula::proof::{Case, Convention, Flag, Proved};
use crate::formula::{Described, Field, Fields, Formula, check, entries, value, value_and_jacobian};
#[cfg(feature = "measure-by-id")]
use crate::toolkit::batch::{self, ArrayView1, ArrayViewMut1};
use crate::toolkit::equation::{Claims, Signature};
use crate::toolkit::graph::{self, Extremes, Graph, NotRecorded};
#[cfg(feature = "measure")]
use crate::toolkit::measure;
#[cfg(feature = "measure-by-id")]
use crate::toolkit::measure::Measurement;
use crate::toolkit::verify::{
    Audit, Claim, Judge, Kink, Options, Part, Printed, Shard, Sides, Subject, Trial, audit_equation, audit_point,
    claims_about, eta_at_scale, eta_point, exact, golden, kinks_as_printed, number_of, sides,
};
use crate::{Error, Octuple};
use std::borrow::Cow;

/// A formula whose types of inputs and outputs are erased; every [`Proved`] one is.
pub trait AnyFormula: Described {
    /// The Rust path of the type that implements it.
    fn path(&self) -> &'static str;
    /// The formula as the toolkit uses it, with its graph cached.
    fn subject(&self) -> Subject;
    /// The outputs at input components given in order.
    ///
    /// # Errors
    /// As [`value`]; [`Error::Components`] if the number of components is wrong.
    fn value(&self, components: &[f64]) -> Result<Vec<f64>, Error>;
    /// The entries of the Jacobian, output by output, each over all inputs.
    ///
    /// # Errors
    /// As [`AnyFormula::value`], except for overflow, which is not checked.
    fn jacobian(&self, components: &[f64]) -> Result<Vec<f64>, Error>;
    /// Outputs and Jacobian computed together, written into slices of the exact length, without allocation.
    ///
    /// # Errors
    /// As [`AnyFormula::value`], and [`Error::DerivativeOverflow`]; [`Error::Components`] if a slice has another length, and
    /// nothing is written then.
    fn value_and_jacobian_into(&self, i: &[f64], value: &mut [f64], jacobian: &mut [f64]) -> Result<(), Error>;
    /// Its graph: the value, the closed-form Jacobian, and the inputs that it rejects.
    ///
    /// # Errors
    /// The reason why the formula cannot be recorded.
    fn graph(&self) -> Result<Graph, NotRecorded>;
    /// The graph with the given treatment of extreme numbers.
    ///
    /// # Errors
    /// The reason why the formula cannot be recorded.
    fn graph_with(&self, extremes: Extremes) -> Result<Graph, NotRecorded>;
    #[cfg(feature = "measure-by-id")]
    /// See [`batch::entries`].
    fn batch_entries(&self) -> Vec<[usize; 2]>;
    #[cfg(feature = "measure-by-id")]
    /// See [`batch::value`].
    ///
    /// # Errors
    /// As there.
    fn batch_value(&self, inputs: &[ArrayView1<f64>], value: &mut [ArrayViewMut1<f64>]) -> Result<(), batch::Error>;
    #[cfg(feature = "measure-by-id")]
    /// See [`batch::value_and_jacobian`].
    ///
    /// # Errors
    /// As there.
    fn batch_value_and_jacobian(
        &self,
        inputs: &[ArrayView1<f64>],
        value: &mut [ArrayViewMut1<f64>],
        jacobian: &mut [ArrayViewMut1<f64>],
    ) -> Result<(), batch::Error>;
    #[cfg(feature = "measure-by-id")]
    /// The errors of every method of computing it, measured anew.
    fn errors(&self, options: &measure::Options) -> Measurement;
    #[cfg(feature = "measure-by-id")]
    /// Times every method of computing it, and adds the times to the measurement of the errors.
    fn times(&self, options: &measure::Options, measurement: &mut Measurement);
}

/// What follows for any formula from what the trait asks for, compiled once for all of them.
impl dyn AnyFormula + '_ {
    /// The flags of its own cases.
    pub fn cases(&self) -> Vec<Flag> {
        (self.subject().cases)().iter().map(|case| case.flag).collect()
    }
    /// Its own laws in words.
    pub fn laws(&self) -> Vec<String> {
        self.subject().laws.into_iter().map(|law| law.statement).collect()
    }
    /// Its kinks.
    pub fn kinks(&self) -> Vec<KinkEntry> {
        let subject = self.subject();
        subject.kinks.iter().map(|kink| KinkEntry::of(&subject, kink)).collect()
    }
    /// Its golden file, computed anew.
    pub fn golden(&self) -> golden::File {
        self.golden_with(golden::LEAST_RANDOM)
    }
    /// Its golden file with at least this many random cases.
    pub fn golden_with(&self, least_random: usize) -> golden::File {
        golden::of(&self.subject(), least_random)
    }
    /// The cases of its golden file without their results; inputs by components in order.
    pub fn golden_cases(&self) -> Vec<Case<Vec<f64>>> {
        golden::cases(&self.subject(), golden::LEAST_RANDOM)
    }
    /// Its audit, executed anew.
    pub fn audit(&self, options: &Options) -> Audit {
        self.audit_part(options, Shard::WHOLE).complete()
    }
    /// A part of its audit, with its share of the random points.
    pub fn audit_part(&self, options: &Options, shard: Shard) -> Part {
        Part::of(&self.subject(), options, shard)
    }
    /// Its audit at one point, given by components in order.
    ///
    /// # Errors
    /// As [`AnyFormula::value`].
    pub fn audit_at(&self, components: &[f64]) -> Result<Audit, Error> {
        expect(count(self.inputs()), components.len())?;
        audit_point(&self.subject(), components.to_vec())
    }
    /// The claims about the bounds of η at one point, given by components in order: of the value, and of a Jacobian in closed form.
    ///
    /// # Errors
    /// As [`AnyFormula::value`], and if a result overflows.
    pub fn eta_at(&self, components: &[f64]) -> Result<Vec<Claim>, Error> {
        self.value_and_closed_jacobian(components)?;
        Ok(eta_point(&self.subject(), components.to_vec()))
    }
    /// The specification with inputs and outputs, as equations refer to it.
    pub fn signature(&self) -> Signature {
        Signature { spec: self.spec(), inputs: self.inputs(), outputs: self.outputs() }
    }
    /// Points at which an equation written by somebody else can be tried.
    pub fn trial(&self, options: &Options) -> Trial {
        Trial::of(&self.subject(), options)
    }
    /// The judge of another program's results for it.
    pub fn judge(&self) -> Judge {
        Judge::of(self.subject())
    }
    /// The claims of its audit about the printed equation: about its value and about its Jacobian.
    pub fn audit_equation(&self, options: &Options) -> [Claim; 2] {
        audit_equation(&self.subject(), options)
    }
    /// The claims of prose about it, checked anew.
    pub fn claims(&self, claims: &Claims, options: &Options) -> Claim {
        claims_about(&self.subject(), claims, options)
    }
    /// The conditions of its kinks, executed as printed.
    pub fn kinks_as_printed(&self) -> Vec<(String, Printed)> {
        kinks_as_printed(&self.subject())
    }
    /// The value of an expression about it.
    pub fn number(&self, expression: &Claims) -> Octuple {
        number_of(&self.subject(), expression)
    }
    /// The bounds of η of value and Jacobian, checked at this many points whose inputs are 0 or from 1/`scale` to `scale` in
    /// size.
    pub fn eta_at_scale(&self, scale: f64, options: &Options) -> Vec<Claim> {
        eta_at_scale(&self.subject(), scale, options)
    }
    /// Outputs and Jacobian computed together.
    ///
    /// # Errors
    /// As [`AnyFormula::value_and_jacobian_into`].
    pub fn value_and_jacobian(&self, components: &[f64]) -> Result<(Vec<f64>, Vec<f64>), Error> {
        let mut value = vec![0.0; count(self.outputs())];
        let mut jacobian = vec![0.0; value.len() * count(self.inputs())];
        self.value_and_jacobian_into(components, &mut value, &mut jacobian)?;
        Ok((value, jacobian))
    }
    /// Outputs, and the Jacobian if it is in closed form: the contents of golden files and of exports.
    ///
    /// # Errors
    /// As [`AnyFormula::value_and_jacobian_into`].
    pub fn value_and_closed_jacobian(&self, components: &[f64]) -> Result<(Vec<f64>, Vec<f64>), Error> {
        if self.spec().is_closed() {
            self.value_and_jacobian(components)
        } else {
            Ok((self.value(components)?, Vec::new()))
        }
    }
    #[cfg(feature = "measure")]
    /// The points used for timing: all components of the first point, then of the next.
    pub fn timing_inputs(&self, options: &measure::Options) -> Vec<f64> {
        options.timing_inputs(&self.subject()).concat()
    }
}

impl<F: Proved> AnyFormula for F {
    fn path(&self) -> &'static str {
        std::any::type_name::<F>()
    }
    fn subject(&self) -> Subject {
        let mut subject = Subject::of::<F>();
        subject.record = || Cow::Borrowed(graph::recorded::<F>());
        subject.worst = worst::cases(F::SPEC.id, subject.inputs);
        subject
    }
    fn value(&self, components: &[f64]) -> Result<Vec<f64>, Error> {
        Ok(value::<F>(&from_components::<F>(components)?)?.components())
    }
    fn value_and_jacobian_into(&self, i: &[f64], value: &mut [f64], jacobian: &mut [f64]) -> Result<(), Error> {
        let i = from_components::<F>(i)?;
        expect(F::Outputs::<f64>::LEN, value.len())?;
        expect(F::Outputs::<f64>::LEN * F::Inputs::<f64>::LEN, jacobian.len())?;
        let (out, gradients) = value_and_jacobian::<F>(&i)?;
        write(&out, &mut value.iter_mut());
        let places = &mut jacobian.iter_mut();
        gradients.for_each_component(&mut |gradient| write(&gradient, places));
        Ok(())
    }
    fn jacobian(&self, components: &[f64]) -> Result<Vec<f64>, Error> {
        let inputs = from_components::<F>(components)?;
        check::<F>(&inputs)?;
        Ok(entries(&F::jacobian(&inputs)))
    }
    fn graph(&self) -> Result<Graph, NotRecorded> {
        graph::recorded::<F>().clone()
    }
    fn graph_with(&self, extremes: Extremes) -> Result<Graph, NotRecorded> {
        graph::record_with::<F>(extremes)
    }
    #[cfg(feature = "measure-by-id")]
    fn batch_entries(&self) -> Vec<[usize; 2]> {
        batch::entries::<F>()
    }
    #[cfg(feature = "measure-by-id")]
    fn batch_value(&self, inputs: &[ArrayView1<f64>], value: &mut [ArrayViewMut1<f64>]) -> Result<(), batch::Error> {
        batch::value::<F>(inputs, value)
    }
    #[cfg(feature = "measure-by-id")]
    fn batch_value_and_jacobian(
        &self,
        inputs: &[ArrayView1<f64>],
        value: &mut [ArrayViewMut1<f64>],
        jacobian: &mut [ArrayViewMut1<f64>],
    ) -> Result<(), batch::Error> {
        batch::value_and_jacobian::<F>(inputs, value, jacobian)
    }
    #[cfg(feature = "measure-by-id")]
    fn errors(&self, options: &measure::Options) -> Measurement {
        measure::errors::<F>(options)
    }
    #[cfg(feature = "measure-by-id")]
    fn times(&self, options: &measure::Options, measurement: &mut Measurement) {
        measure::times::<F>(options, measurement);
    }
}

/// A kink, with the jump there.
#[derive(Clone, Debug, PartialEq)]
pub struct KinkEntry {
    /// The condition, in LaTeX.
    pub condition: String,
    /// The convention used there.
    pub convention: Convention,
    /// The components of a point on the kink.
    pub at: Vec<f64>,
    /// The components of a direction across it.
    pub across: Vec<f64>,
    /// For every output component, the derivatives across the kink from below and from above.
    pub one_sided: Vec<[f64; 2]>,
    /// The jump at the point of the register; `None` if there is none, which an audit reports.
    pub sides: Option<Sides>,
}

impl KinkEntry {
    fn of(subject: &Subject, kink: &Kink) -> Self {
        Self {
            condition: kink.condition.clone(),
            convention: kink.convention,
            at: kink.at.clone(),
            across: kink.across.clone(),
            one_sided: one_sided(subject, kink),
            sides: sides(subject, kink),
        }
    }
}

fn from_components<F: Formula>(components: &[f64]) -> Result<F::Inputs<f64>, Error> {
    let (found, expected) = (components.len(), F::Inputs::<f64>::LEN);
    F::Inputs::from_slice(components).ok_or(Error::Components { found, expected })
}

/// The number of their components.
pub(super) fn count(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

/// Rejects a wrong number of components.
pub(super) fn expect(expected: usize, found: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::Components { found, expected }) }
}

/// Writes the components in order, one after the other; their number was checked before.
#[inline]
fn write<'a>(fields: &impl Fields<f64>, places: &mut impl Iterator<Item = &'a mut f64>) {
    fields.for_each_component(&mut |x| *places.next().expect("a place for every component") = x);
}

/// The derivatives of every output across a kink, from below and from above: one-sided differences in 237 bits, with a step so
/// short that nothing else is close.
fn one_sided(subject: &Subject, kink: &Kink) -> Vec<[f64; 2]> {
    let (at, across) = (exact(&kink.at), exact(&kink.across));
    let step = Octuple::from(1e-40);
    let value = |h: Octuple| {
        let moved: Vec<_> = at.iter().zip(&across).map(|(&x, &direction)| x + direction * h).collect();
        (subject.exact_value)(&moved)
    };
    let (below, here, above) = (value(-step), value(step * 0.0), value(step));
    let less_turns = |difference: Octuple| match kink.convention {
        Convention::Cut => align::wrapped(difference),
        _ => difference,
    };
    let sides = |k: usize| [here[k] - below[k], above[k] - here[k]];
    (0..here.len()).map(|k| sides(k).map(|d| (less_turns(d) / step).to_f64())).collect()
}
