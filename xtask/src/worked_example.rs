//! The worked example of the chapter on code review: a submitted derivative, and the audit's verdict.

use jointproof::connector::slot::{Contact, CrossForces};
use jointproof::formula::proof::Proved;
use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
use jointproof::number::scalar::{Scalar, direction, norm};
use jointproof::toolkit::verify::{Audit, Options, audit};

// ANCHOR: submitted
/// The contact force as submitted for review.
#[derive(Clone, Copy)]
struct Submitted;

impl Formula for Submitted {
    const SPEC: Spec =
        Spec::new("review.contact_force", "Contact force, as submitted", Document::SLOT.printed("Friction"))
            .equation(r"F_C = \sqrt{f_2^2 + f_3^2}")
            .eta(2.0, 2.0);
    type Inputs<T: Component> = CrossForces<T>;
    type Outputs<T: Component> = Contact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
        Contact { fc: norm([i.f2, i.f3]) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossForces<D>) -> Jacobian<Self, D> {
        let [f2, f3] = direction([i.f2, i.f3]);
        Contact { fc: CrossForces { f2, f3: -f3 } }
    }
}
impl Proved for Submitted {}
// ANCHOR_END: submitted

/// The result of the audit.
pub(crate) fn run() -> Audit {
    audit::<Submitted>(&Options { samples: 200, seed: 1 })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_audit_names_the_wrong_entry() {
        let audit = super::run();
        let worst = audit.closed_against_ad.as_ref().unwrap().worst.as_ref().unwrap();
        assert_eq!((audit.passed(), worst.entry.as_str()), (false, "∂fc/∂f3"));
    }
}
