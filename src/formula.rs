//! The one definition of a formula, from which everything else follows.
//!
//! To add a formula: declare its inputs and outputs with [`fields!`](crate::fields), write a unit struct, implement
//! [`Formula`] for it, state its evidence in a file beside it, and name it in the catalog. The closed-form Jacobian has
//! the type `Outputs<Inputs<D>>`: the outputs, with every component replaced by its gradient, whose fields have the names
//! of the inputs. `jac.fc.f2` is ∂fc/∂f2.

mod checked;
pub(crate) mod error;
mod few;
mod fields;
mod finite;
pub(crate) mod forward;
#[cfg(feature = "verify")]
pub mod proof;
pub mod quantity;
mod source;

#[cfg(feature = "batch")]
pub(crate) use checked::{are_allowed, is_plain};
pub use checked::{check, value, value_and_jacobian};
pub(crate) use few::cross_gradient;
pub use fields::{Component, Field, Fields, Part, Visitor};
#[cfg(feature = "verify")]
pub(crate) use fields::{entries, typed};
pub use finite::Finite;
#[cfg(feature = "batch")]
pub(crate) use finite::bits_unless_finite;
pub use source::{Document, Provenance, Source};

use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::SVector;

/// Symbols that another formula defines: "where α from universal.angles".
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Given {
    /// The symbols in LaTeX with commas between them, each perhaps a function: `\mathbf{X}(g)`.
    pub symbols: &'static str,
    /// The formula whose equation defines them.
    pub from: &'static Spec,
}

impl Given {
    /// Symbols, and the formula whose equation defines them. What that formula takes for its inputs are the symbols of the
    /// same name in the equation that refers to it.
    pub const fn new(symbols: &'static str, from: &'static Spec) -> Self {
        Self { symbols, from }
    }
}

/// What is said about a formula, once.
///
/// ```
/// use jointproof::formula::{Document, Spec};
/// const NOTES: Document = Document::new("My notes").link("https://example.org/notes");
/// const SPEC: Spec = Spec::new("spring.energy", "Energy of a spring", NOTES.printed("Springs"))
///     .equation(r"W = \tfrac12 k x^2")
///     .eta(2.0, 2.0);
/// assert!(SPEC.objective);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Spec {
    /// The identifier, `family.name`.
    pub id: &'static str,
    /// A title of a few words.
    pub title: &'static str,
    /// Where it is documented, and how much of it.
    pub source: Source,
    /// The equation in LaTeX.
    pub latex: &'static str,
    /// Where the symbols of the equation come from that are neither inputs nor defined in it.
    pub given: &'static [Given],
    /// The stated bounds of the backward error η in `f64`, on random and hard cases, of every component.
    pub eta: Bounds,
    /// Normwise bounds of η, where no bound of every component is known: then those above hold at the golden cases.
    pub normwise: Option<Bounds>,
    /// Both bounds of η hold where every component of the inputs is 0, or from one part in so many to so many in size.
    pub scale: f64,
    /// Whether moving and turning the whole model moves and turns the outputs with it (frame indifference). A formula
    /// that refers to the global axes is not objective.
    pub objective: bool,
    /// The inputs at which neither an output nor a derivative overflows.
    pub finite: Finite,
}

/// Bounds of the backward error η in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Of the value.
    pub value: f64,
    /// Of the closed-form Jacobian; `None` where the Jacobian is automatic.
    pub jacobian: Option<f64>,
}

/// What is said of [normwise](Spec::normwise) bounds.
pub(crate) const NORMWISE: &str = ", normwise";

impl Spec {
    /// The scale of a formula that says nothing of it: products of ten numbers of such sizes neither over- nor underflow.
    pub const SCALE: f64 = 1e30;

    /// An objective formula; its equation and its bounds follow.
    pub const fn new(id: &'static str, title: &'static str, source: Source) -> Self {
        let (latex, given, eta) = ("", [].as_slice(), Bounds { value: 0.0, jacobian: None });
        let (normwise, scale, objective, finite) = (None, Self::SCALE, true, Finite::Unknown);
        Self { id, title, source, latex, given, eta, normwise, scale, objective, finite }
    }

    /// The equation in LaTeX.
    #[must_use]
    pub const fn equation(self, latex: &'static str) -> Self {
        Self { latex, ..self }
    }

    /// Where the symbols of the equation come from that are neither inputs nor defined in it.
    #[must_use]
    pub const fn given(self, given: &'static [Given]) -> Self {
        Self { given, ..self }
    }

    /// The bounds of η of a formula whose Jacobian is in closed form: of the value, and of every entry of the Jacobian.
    #[must_use]
    pub const fn eta(self, value: f64, jacobian: f64) -> Self {
        Self { eta: Bounds { value, jacobian: Some(jacobian) }, ..self }
    }

    /// The bound of η of the value of a formula whose Jacobian is automatic.
    #[must_use]
    pub const fn eta_of_value(self, value: f64) -> Self {
        Self { eta: Bounds { value, jacobian: None }, ..self }
    }

    /// Whether the Jacobian is derived by hand; otherwise it is found by automatic differentiation.
    pub const fn is_closed(&self) -> bool {
        self.eta.jacobian.is_some()
    }

    /// Normwise bounds of η, of value and Jacobian: a component of a vector or matrix, or a derivative by one, that is beyond the
    /// bound is judged beside the largest other one of it, as if it were as large and changed as much. Which component is small
    /// depends on the axes, and what cancels in it does not in the others.
    #[must_use]
    pub const fn normwise(self, value: f64, jacobian: f64) -> Self {
        Self { normwise: Some(Bounds { value, jacobian: Some(jacobian) }), ..self }
    }

    /// The bounds of η of value and Jacobian that the audit checks, in words.
    ///
    /// ```
    /// use jointproof::element::slider::Rows;
    /// use jointproof::formula::Formula;
    /// use jointproof::connector::ujoint::HingeAxial;
    /// assert_eq!(HingeAxial::SPEC.accuracy(), "η at most 2 of the value, 3 of the Jacobian");
    /// assert_eq!(Rows::SPEC.accuracy(), "η at most 5 of the value, normwise; the Jacobian is automatic");
    /// ```
    pub fn accuracy(&self) -> String {
        let (Bounds { value, jacobian }, by) = self.bounds();
        match jacobian {
            Some(jacobian) => format!("η at most {value} of the value, {jacobian} of the Jacobian{by}"),
            None => format!("η at most {value} of the value{by}; the Jacobian is automatic"),
        }
    }

    /// These bounds, and how they are to be understood.
    pub const fn bounds(&self) -> (Bounds, &'static str) {
        match self.normwise {
            Some(bounds) => (bounds, NORMWISE),
            None => (self.eta, ""),
        }
    }

    /// The normwise bound of η of the value of a formula whose Jacobian is automatic.
    #[must_use]
    pub const fn normwise_of_value(self, value: f64) -> Self {
        Self { normwise: Some(Bounds { value, jacobian: None }), ..self }
    }

    /// The sizes up to which the bounds of η hold: every component of the inputs is 0, or from 1/`scale` to `scale`. Beyond, a
    /// product of some of them may under- or overflow on the way to a result that does not.
    #[must_use]
    pub const fn scale(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// The sizes of inputs at which the bounds of η hold, in words.
    ///
    /// ```
    /// use jointproof::formula::Formula;
    /// use jointproof::connector::ujoint::HingeAxial;
    /// assert_eq!(HingeAxial::SPEC.sizes(), "from 1/1e50 to 1e50");
    /// ```
    pub fn sizes(&self) -> String {
        format!("from 1/{0:e} to {0:e}", self.scale)
    }

    /// The inputs at which neither an output nor a derivative overflows, which makes checked calls cheap there.
    #[must_use]
    pub const fn finite(self, finite: Finite) -> Self {
        Self { finite, ..self }
    }

    /// It refers to the global axes, so that turning the model does not turn the outputs with it.
    #[must_use]
    pub const fn not_objective(self) -> Self {
        Self { objective: false, ..self }
    }
}

/// The Jacobian of `F`: its outputs, every component replaced by its gradient.
pub type Jacobian<F, D> = <F as Formula>::Outputs<<F as Formula>::Inputs<D>>;

/// Value and Jacobian of `F`.
pub type ValueAndJacobian<F, D> = (<F as Formula>::Outputs<D>, Jacobian<F, D>);

/// A documented equation: its value, and its Jacobian in closed form where somebody calls or reads it. What is said about it stands in its `Proved`.
pub trait Formula: Copy + Send + Sync + 'static {
    /// What is said about it.
    const SPEC: Spec;
    /// Its inputs, made by [`fields!`](crate::fields).
    type Inputs<T: Component>: Fields<T>;
    /// Its outputs, made by [`fields!`](crate::fields).
    type Outputs<T: Component>: Fields<T>;

    /// The equation.
    fn eval<D: Scalar>(i: &Self::Inputs<D>) -> Self::Outputs<D>;

    /// Its derivative: `jacobian(i).out.input` is ∂out/∂input. By default it is automatic; derived by hand, its
    /// [bound](Spec::eta) is stated, and it is proved equal to the automatic one.
    #[inline]
    fn jacobian<D: Scalar>(i: &Self::Inputs<D>) -> Jacobian<Self, D> {
        forward::differentiate::<Self, D>(i, Self::eval).1
    }

    /// Both at once; overridden where they share work. The value has the bits of [`eval`](Self::eval).
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn linearized<D: Scalar>(i: &Self::Inputs<D>) -> ValueAndJacobian<Self, D> {
        (Self::eval(i), Self::jacobian(i))
    }

    /// What makes inputs invalid beyond the domains of the single fields.
    ///
    /// It is decided by comparisons of scalars, so that it can be written down as the formula is; only an error has doubles.
    ///
    /// # Errors
    /// What is wrong with which input.
    #[inline]
    fn validate<D: Scalar>(_: &Self::Inputs<D>) -> Result<(), Error> {
        Ok(())
    }

    /// [`eval`](Self::eval) of inputs that are valid together; overridden where telling that takes as long as the value.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    #[inline]
    fn try_eval(i: &Self::Inputs<f64>) -> Result<Self::Outputs<f64>, Error> {
        Self::validate(i)?;
        Ok(Self::eval(i))
    }

    /// [`linearized`](Self::linearized) of inputs that are valid together; overridden where [`try_eval`](Self::try_eval) is.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    #[inline]
    fn try_linearized(i: &Self::Inputs<f64>) -> Result<ValueAndJacobian<Self, f64>, Error> {
        Self::validate(i)?;
        Ok(Self::linearized(i))
    }
}

/// A unit vector of the i-th axis times `value`: the gradient of a product's i-th component.
#[inline]
pub fn along<D: Scalar, const N: usize>(i: usize, value: D) -> SVector<D, N> {
    SVector::from_fn(|k, _| if k == i { value } else { D::zero() })
}
