//! A formula of this project with an error in it.

use jointproof::formula::proof::{Case, Kink, Proved};
use jointproof::formula::{Component, Fields, Finite, Formula, Jacobian, Spec, ValueAndJacobian, value_and_jacobian};
use jointproof::number::scalar::Scalar;
use jointproof::toolkit::verify::Options;
use jointproof::{Error, catalog};
use judge::{Answer, Called, Judged};

/// Few points are enough: every error shows at most of them.
pub(super) const OPTIONS: Options = Options { samples: 40, seed: 1 };

/// The inputs of the formula in which an error is re-enacted.
pub(super) type Inputs<M, D> = <<M as Mistake>::Of as Formula>::Inputs<D>;
/// Its outputs.
pub(super) type Outputs<M, D> = <<M as Mistake>::Of as Formula>::Outputs<D>;
/// Its Jacobian, row by row.
pub(super) type Rows<D> = Vec<Vec<D>>;

/// The deviations from the formula; methods not overridden are those of the formula.
pub(super) trait Mistake: Copy + Send + Sync + 'static {
    /// The formula.
    type Of: Proved;

    /// The components of the value.
    fn value<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        Self::Of::eval(i).components()
    }

    /// The entries of the Jacobian.
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        rows::<Self::Of, D>(i)
    }

    /// The value that comes with the Jacobian.
    fn value_with_jacobian<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        Self::value(i)
    }
}

/// The Jacobian of a formula, row by row.
pub(super) fn rows<F: Formula, D: Scalar>(i: &F::Inputs<D>) -> Rows<D> {
    F::jacobian(i).components().iter().map(Fields::components).collect()
}

/// The inputs with some components replaced.
pub(super) fn changed<D: Scalar, I: Fields<D>>(i: &I, change: impl Fn(&[D], usize) -> D) -> I {
    let components = i.components();
    filled(&(0..components.len()).map(|k| change(&components, k)).collect::<Vec<_>>())
}

fn filled<T: Component, I: Fields<T>>(components: &[T]) -> I {
    I::from_slice(components).expect("there are as many components as before")
}

/// The formula without an error, in the same wrapping.
#[derive(Clone, Copy)]
pub(super) struct Right<F>(F);

impl<F: Proved> Mistake for Right<F> {
    type Of = F;
}

/// A formula with an error in it.
#[derive(Clone, Copy)]
pub(super) struct Shipped<M>(M);

impl<M: Mistake> Formula for Shipped<M> {
    // If our Jacobian is automatic, the published one was written by hand.
    const SPEC: Spec = {
        let spec = M::Of::SPEC.finite(Finite::Unknown);
        if spec.is_closed() { spec } else { spec.eta(spec.eta.value, 8.0) }
    };
    type Inputs<T: Component> = <M::Of as Formula>::Inputs<T>;
    type Outputs<T: Component> = <M::Of as Formula>::Outputs<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Inputs<M, D>) -> Outputs<M, D> {
        filled(&M::value(i))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Inputs<M, D>) -> Jacobian<Self, D> {
        let rows: Vec<Inputs<M, D>> = M::rows(i).iter().map(|row| filled(row)).collect();
        filled(&rows)
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Inputs<M, D>) -> ValueAndJacobian<Self, D> {
        (filled(&M::value_with_jacobian(i)), Self::jacobian(i))
    }

    #[inline]
    fn validate<D: Scalar>(i: &Inputs<M, D>) -> Result<(), Error> {
        M::Of::validate(i)
    }
}

impl<M: Mistake> Proved for Shipped<M> {
    fn cases() -> Vec<Case<Inputs<M, f64>>> {
        M::Of::cases()
    }

    fn kinks() -> Vec<Kink<Self>> {
        let same = |kink: Kink<M::Of>| Kink::new(kink.convention, kink.condition, kink.holds, kink.at, kink.across);
        M::Of::kinks().into_iter().map(same).collect()
    }
}

/// The judgement of the formula with the error, as of anybody's program.
pub(super) fn judged<M: Mistake>() -> Judged {
    let id = M::Of::SPEC.id;
    let called = Called::new(catalog::find(id).expect("it is in the catalog"), true, &OPTIONS, true);
    let answer = |inputs: &[f64]| {
        let inputs = Inputs::<M, f64>::from_slice(inputs);
        let answered = inputs.and_then(|i| value_and_jacobian::<Shipped<M>>(&i).ok());
        let Some((value, rows)) = answered else { return Answer::Refused(None) };
        let rows = rows.components().into_iter().flat_map(|row| row.components());
        Answer::Numbers(value.components().into_iter().chain(rows).map(Some).collect())
    };
    let answers: Vec<_> = called.points().map(answer).collect();
    called.judge("the formula", &[answers.clone(), answers], false, Vec::new()).expect("every point is answered")
}
