//! The specification of a formula: identifier, source, equation, and bounds of its accuracy.

use super::{Finite, Source};

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
    /// Symbols, and the formula whose equation defines them. The inputs of that formula are the symbols of the same
    /// name in the referring equation.
    pub const fn new(symbols: &'static str, from: &'static Spec) -> Self {
        Self { symbols, from }
    }
}

/// The specification of a formula.
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
    /// Where it is documented, and how completely.
    pub source: Source,
    /// The equation in LaTeX.
    pub latex: &'static str,
    /// Where the symbols of the equation come from that are neither inputs nor defined in it.
    pub given: &'static [Given],
    /// The stated bounds of the backward error η in `f64`, for random and hard cases, of every component.
    pub eta: Bounds,
    /// Normwise bounds of η, if no bound of every component is known: then the bounds above hold for the golden cases.
    pub normwise: Option<Bounds>,
    /// Both bounds of η hold if every component of the inputs is 0 or has a magnitude from 1/`scale` to `scale`.
    pub scale: f64,
    /// Both bounds of η hold where no divisor, root, length or angle's point vanishes if the inputs change by less than this part
    /// of their sizes; 0 if they hold everywhere. Nearer to a singular point, roundings are not small changes.
    pub apart: f64,
    /// Whether translating and rotating the whole model does the same to the outputs (frame indifference). A formula
    /// that refers to the global axes is not objective.
    pub objective: bool,
    /// The inputs for which neither an output nor a derivative overflows.
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

/// The suffix that marks [normwise](Spec::normwise) bounds.
pub(crate) const NORMWISE: &str = ", normwise";

impl Spec {
    /// The default scale: products of ten numbers of such sizes neither over- nor underflow.
    pub const SCALE: f64 = 1e30;

    /// An objective formula; the equation and the bounds are added by the methods below.
    pub const fn new(id: &'static str, title: &'static str, source: Source) -> Self {
        let (latex, given, eta) = ("", [].as_slice(), Bounds { value: 0.0, jacobian: None });
        let (normwise, scale, apart, objective, finite) = (None, Self::SCALE, 0.0, true, Finite::Unknown);
        Self { id, title, source, latex, given, eta, normwise, scale, apart, objective, finite }
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

    /// Normwise bounds of η, of value and Jacobian. A number that exceeds the bound is judged by what changes of whole vectors cause,
    /// Σ |∂y/∂x| |x| + |y| over the inputs x, and by the largest such size of the numbers beside it: the other components of the same
    /// vector or matrix; of a derivative, those with respect to the other components of the same input, or where that is a scalar, the
    /// derivatives of the other components of the same output. Which component is small depends on the axes, and what cancels in one
    /// does not cancel in the others.
    #[must_use]
    pub const fn normwise(self, value: f64, jacobian: f64) -> Self {
        Self { normwise: Some(Bounds { value, jacobian: Some(jacobian) }), ..self }
    }

    /// The bounds that the audit checks, and the suffix that says how they are meant.
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

    /// The sizes for which the bounds of η hold: every component of the inputs is 0, or from 1/`scale` to `scale`.
    /// Beyond, a product of some of them may under- or overflow although the result does not.
    #[must_use]
    pub const fn scale(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// The bounds of η hold where no divisor, root, length or angle's point vanishes if the inputs change by less than this part of
    /// their sizes.
    #[must_use]
    pub const fn apart(self, apart: f64) -> Self {
        Self { apart, ..self }
    }

    /// The sizes of inputs at which the bounds of η hold, in words.
    ///
    /// ```
    /// use jointproof::formula::Formula;
    /// use jointproof::connector::ujoint::HingeAxial;
    /// assert_eq!(HingeAxial::SPEC.sizes(), "from 1/1e50 to 1e50");
    /// ```
    pub fn sizes(&self) -> String {
        let sizes = format!("from 1/{0:e} to {0:e}", self.scale);
        if self.apart == 0.0 { sizes } else { format!("{sizes}, {:e} from singular points", self.apart) }
    }

    /// The inputs for which neither an output nor a derivative overflows, which makes checked calls cheap there.
    #[must_use]
    pub const fn finite(self, finite: Finite) -> Self {
        Self { finite, ..self }
    }

    /// With the bounds, the scale and the finite inputs of another formula that computes the same.
    #[must_use]
    pub const fn accurate_as(self, other: &Self) -> Self {
        let Self { eta, normwise, scale, apart, finite, .. } = *other;
        Self { eta, normwise, scale, apart, finite, ..self }
    }

    /// It refers to the global axes, so that rotating the model does not rotate the outputs with it.
    #[must_use]
    pub const fn not_objective(self) -> Self {
        Self { objective: false, ..self }
    }
}
