//! The normal moments of the hinges.

#[cfg(feature = "verify")]
mod proof;

use crate::fields;
use crate::formula::quantity::{MC1, MC1_INT, MC3, MC3_INT, MN1, MN3};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, sign};

fields! {
    /// Contact moments of the loads, and the internal ones.
    pub struct AllContactMoments<T> { mc1: T = MC1, mc3: T = MC3, mc1_int: T = MC1_INT, mc3_int: T = MC3_INT }
}
fields! {
    /// Normal moments about both axes of the cross.
    pub struct NormalMomentPair<T> { mn1: T = MN1, mn3: T = MN3 }
}

/// Normal moments: M_Nk = 2|M_Ck| + |M_Ck_int|; there are two hinges on each axis.
#[derive(Clone, Copy, Debug)]
pub struct NormalMoments;

impl Formula for NormalMoments {
    const SPEC: Spec = Spec::new("ujoint.normal_moments", "Normal moments", Document::UJOINT.printed("Friction"))
        .equation(r"M_{Nk} = 2\lvert M_{Ck}\rvert + \lvert M_{Ck}^{\mathrm{int}}\rvert\quad (k = 1, 3)")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = AllContactMoments<T>;
    type Outputs<T: Component> = NormalMomentPair<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AllContactMoments<D>) -> NormalMomentPair<D> {
        NormalMomentPair { mn1: abs(i.mc1) * 2.0 + abs(i.mc1_int), mn3: abs(i.mc3) * 2.0 + abs(i.mc3_int) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AllContactMoments<D>) -> Jacobian<Self, D> {
        let zero = AllContactMoments::filled(D::zero());
        let slope = |factor: f64, x: D| sign(x) * factor;
        NormalMomentPair {
            mn1: AllContactMoments { mc1: slope(2.0, i.mc1), mc1_int: slope(1.0, i.mc1_int), ..zero },
            mn3: AllContactMoments { mc3: slope(2.0, i.mc3), mc3_int: slope(1.0, i.mc3_int), ..zero },
        }
    }
}
