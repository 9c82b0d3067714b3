//! Where a formula has no derivative.

use crate::Octuple;
use crate::formula::{Fields, Formula, typed};

/// The convention where a formula has no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// The minimum-norm subgradient, 0, in both the closed form and automatic differentiation.
    Subgradient,
    /// The value is defined; the Jacobian is one of the one-sided ones and is omitted from golden files.
    Switch,
    /// An angle jumps by a full turn; its derivative is the same on both sides and is returned as usual.
    Cut,
}

/// A condition on inputs in 237 bits.
pub type Condition<F> = Box<dyn Fn(&<F as Formula>::Inputs<Octuple>) -> bool>;

/// Selects inputs from a struct that holds the indices of its components.
type Pick<F, const N: usize> = fn(&<F as Formula>::Inputs<usize>) -> [usize; N];

/// A set of points where a formula has no derivative.
#[non_exhaustive]
pub struct Kink<F: Formula> {
    /// The condition, in LaTeX.
    pub condition: String,
    /// The convention there.
    pub convention: Convention,
    /// Whether inputs, in 237 bits, are on the kink.
    pub holds: Condition<F>,
    /// A point on the kink.
    pub at: F::Inputs<f64>,
    /// A direction that crosses it.
    pub across: F::Inputs<f64>,
}

impl<F: Formula> Kink<F> {
    /// A kink given by its condition in words and in code, a point on it, and a direction across it.
    pub fn new(
        convention: Convention,
        condition: impl Into<String>,
        holds: impl Fn(&F::Inputs<Octuple>) -> bool + 'static,
        at: F::Inputs<f64>,
        across: F::Inputs<f64>,
    ) -> Self {
        Self { condition: condition.into(), convention, holds: Box::new(holds), at, across }
    }

    /// A kink at which the derivative is 0 by convention.
    pub fn subgradient(
        condition: impl Into<String>,
        holds: impl Fn(&F::Inputs<Octuple>) -> bool + 'static,
        at: F::Inputs<f64>,
        across: F::Inputs<f64>,
    ) -> Self {
        Self::new(Convention::Subgradient, condition, holds, at, across)
    }

    /// A kink at which the formula switches from one expression to another.
    pub fn switch(
        condition: impl Into<String>,
        holds: impl Fn(&F::Inputs<Octuple>) -> bool + 'static,
        at: F::Inputs<f64>,
        across: F::Inputs<f64>,
    ) -> Self {
        Self::new(Convention::Switch, condition, holds, at, across)
    }

    /// The kink of the absolute value of one input, at which the derivative is 0 by convention; the other inputs are
    /// as in `near`.
    ///
    /// ```
    /// use jointproof::formula::proof::Kink;
    /// use jointproof::connector::slot::{Friction, SlotLoads};
    /// let near = SlotLoads { f1: 1.0, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 };
    /// let kink = Kink::<Friction>::of_abs(near, |i| [i.f1]);
    /// assert_eq!((kink.condition.as_str(), kink.at.f1, kink.across.f1), ("f_1 = 0", 0.0, 1.0));
    /// ```
    pub fn of_abs(near: F::Inputs<f64>, input: Pick<F, 1>) -> Self {
        Self::of_norm(near, input)
    }

    /// The kink of the norm of some inputs, at which the derivative is 0 by convention.
    pub fn of_norm<const N: usize>(near: F::Inputs<f64>, inputs: Pick<F, N>) -> Self {
        Self::vanishing(Convention::Subgradient, near, inputs)
    }

    /// The kink of a parameter that switches a term off where it is 0.
    pub fn switched_off(near: F::Inputs<f64>, parameter: Pick<F, 1>) -> Self {
        Self::vanishing(Convention::Switch, near, parameter)
    }

    /// The kink where some inputs are all 0. The function `inputs` selects them from a struct that holds the indices
    /// of its components.
    pub fn vanishing<const N: usize>(convention: Convention, near: F::Inputs<f64>, inputs: Pick<F, N>) -> Self {
        let places: Vec<usize> = (0..F::Inputs::<usize>::LEN).collect();
        let vanish = inputs(&typed(&places));
        let mut at = near.components();
        let mut across = vec![0.0; at.len()];
        for place in vanish {
            at[place] = 0.0;
        }
        across[vanish[0]] = 1.0;
        let symbols = vanish.map(|place| symbol::<F>(place));
        let holds = move |i: &F::Inputs<Octuple>| {
            let components = i.components();
            vanish.iter().all(|&place| components[place] == 0.0)
        };
        let condition = format!("{} = 0", symbols.join(" = "));
        Self { condition, convention, holds: Box::new(holds), at: typed(&at), across: typed(&across) }
    }
}

/// The symbol of the component at this index: `f_1`, or `n_2` for the second one of **n**.
fn symbol<F: Formula>(place: usize) -> String {
    let mut first = 0;
    for field in F::Inputs::<f64>::FIELDS {
        if place < first + field.len() {
            let latex = field.quantity.latex;
            let letter = latex.strip_prefix(r"\mathbf{").and_then(|rest| rest.strip_suffix('}')).unwrap_or(latex);
            return if field.len() == 1 { latex.into() } else { format!("{letter}_{}", place - first + 1) };
        }
        first += field.len();
    }
    unreachable!("a place is below the number of components")
}
