//! The arm of the cross: how its slenderness λ = La/Rp distributes a load among the hinges.
//!
//! The source prints no formula, only the limits of the factors: a stubby arm is rigid, a slender one is an Euler–Bernoulli beam,
//! with Timoshenko beams in between. Both pairs of factors follow from one curve,
//!
//! ```text
//! σ(λ) = λ²/(λ² + k),   0 for a rigid arm, 1 for a slender one
//! ```
//!
//! with k = 33/5 for the twisting moment and k = 6 for axial forces. The book derives both and compares them with related models;
//! [`timoshenko`] is the nearest.

#[cfg(feature = "verify")]
mod proof;

use crate::fields;
use crate::formula::quantity::{ALPHA_AXIAL, ALPHA_TWIST, BETA_AXIAL, BETA_TWIST, LA, RP};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, choice, is_between, number_if};
use std::hint::select_unpredictable;

fields! {
    /// An arm of the cross.
    pub struct Arm<T> { la: T = LA, rp: T = RP }
}

/// σ = λ²/(λ² + k), 1 − σ, and the gradient of σ.
struct Slenderness<D> {
    slender: D,
    rigid: D,
    gradient: Arm<D>,
}

impl<D: Scalar> Arm<D> {
    /// σ with k = `above`/`below`, both integers, since k is not always representable as a double.
    #[inline]
    fn slenderness(&self, above: f64, below: f64) -> Slenderness<D> {
        let [slender, rigid, la, rp] = choice(|| {
            let squares = self.la * self.la + self.rp * self.rp;
            let is_usual = is_between(squares, 1e-60, 1e60);
            let Slenderness { slender, rigid, gradient: Self { la, rp } } = if is_usual || !D::has_extremes() {
                self.regular_slenderness(above, below)
            } else {
                self.rescaled_slenderness(above, below)
            };
            [slender, rigid, la, rp].map(|x| number_if(is_usual || D::has_extremes(), x))
        });
        Slenderness { slender, rigid, gradient: Self { la, rp } }
    }

    /// σ = below La²/(below La² + above Rp²). From λ dσ/dλ = 2σ(1 − σ) its gradient is 2σ(1 − σ) (1/La, −1/Rp).
    ///
    /// Only the smaller of σ and 1 − σ is computed as a quotient, and the other is its difference from 1: the derivative of the
    /// larger quotient by automatic differentiation would be the difference of two nearly equal terms.
    #[inline]
    fn regular_slenderness(&self, above: f64, below: f64) -> Slenderness<D> {
        let Self { la, rp } = *self;
        let (slender, rigid) = (la * la * below, rp * rp * above);
        let inverse = (slender + rigid).recip();
        let is_slender = slender > rigid;
        let smaller = select_unpredictable(is_slender, rigid, slender) * inverse;
        let larger = -smaller + 1.0;
        let (slender, rigid) = select_unpredictable(is_slender, (larger, smaller), (smaller, larger));
        let slope = la * rp * (2.0 * above * below) * inverse * inverse;
        Slenderness { slender, rigid, gradient: Self { la: slope * rp, rp: -slope * la } }
    }

    /// Only the ratio of the lengths matters: scales the larger to 1, so that squares neither under- nor overflow.
    #[cold]
    fn rescaled_slenderness(self, above: f64, below: f64) -> Slenderness<D> {
        let larger = if self.la > self.rp { self.la } else { self.rp };
        let Slenderness { slender, rigid, gradient } =
            Self { la: self.la / larger, rp: self.rp / larger }.regular_slenderness(above, below);
        Slenderness { slender, rigid, gradient: Self { la: gradient.la / larger, rp: gradient.rp / larger } }
    }

    /// σ with the k of the twisting moment: ¾ φ λ² = ¾ · 44/5.
    #[inline]
    fn twist_slenderness(&self) -> Slenderness<D> {
        self.slenderness(33.0, 5.0)
    }

    /// σ with the k of axial forces.
    #[inline]
    fn axial_slenderness(&self) -> Slenderness<D> {
        self.slenderness(6.0, 1.0)
    }
}

fields! {
    /// The shares of the twisting moment that a hinge carries: as moment, and as force times arm length.
    pub struct TwistShares<T> { alpha_twist: T = ALPHA_TWIST, beta_twist: T = BETA_TWIST }
}

impl<D: Scalar> TwistShares<D> {
    #[inline]
    fn new(slenderness: &Slenderness<D>) -> Self {
        let alpha_twist = slenderness.slender * 0.125;
        Self { alpha_twist, beta_twist: alpha_twist + 0.25 }
    }
}

/// Shares of the twisting moment: α_twist = 1/(8 + 6φ), β_twist = 1/4 + α_twist, φ = (44/5)/λ², λ = La/Rp.
///
/// In terms of σ = λ²/(λ² + 33/5): α_twist = σ/8.
#[derive(Clone, Copy, Debug)]
pub struct TwistFactors;

impl Formula for TwistFactors {
    const SPEC: Spec = Spec::new(
        "ujoint.twist_factors",
        "Shares of the twisting moment",
        Document::UJOINT.ours(
            "Friction",
            "the page prints the limits and names the beam theories; the curve between is ours",
        ),
    )
        .equation(r"\alpha_{\mathrm{twist}} = \frac{1}{8+6\varphi},\quad \beta_{\mathrm{twist}} = \tfrac14 + \alpha_{\mathrm{twist}},\quad \varphi = \frac{44}{5\lambda^2},\quad \lambda = \frac{L_a}{R_p}")
        // Both are proved, and reached to first order: 8/3 for the value, 15/2 for the Jacobian. The largest η that `audit --attack`
        // found is 1.35 for the value, for the Jacobian 4.12.
        .eta(8.0 / 3.0, 11.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = Arm<T>;
    type Outputs<T: Component> = TwistShares<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Arm<D>) -> TwistShares<D> {
        TwistShares::new(&i.twist_slenderness())
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Arm<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Arm<D>) -> (TwistShares<D>, Jacobian<Self, D>) {
        let slenderness = i.twist_slenderness();
        let Arm { la, rp } = slenderness.gradient;
        let slope = Arm { la: la * 0.125, rp: rp * 0.125 };
        (TwistShares::new(&slenderness), TwistShares { alpha_twist: slope, beta_twist: slope })
    }
}

fields! {
    /// The shares of an axial force that the hinges of either axis carry.
    pub struct AxialShares<T> { alpha_axial: T = ALPHA_AXIAL, beta_axial: T = BETA_AXIAL }
}

impl<D: Scalar> AxialShares<D> {
    #[inline]
    fn new(slenderness: &Slenderness<D>) -> Self {
        Self { alpha_axial: slenderness.slender * 0.25 + 0.25, beta_axial: slenderness.rigid * 0.25 }
    }
}

/// Shares of an axial force: α_axial = (λ² + 3)/(2(λ² + 6)) along the loaded axis, β_axial = 3/(2(λ² + 6)) transverse to the
/// other, λ = La/Rp.
///
/// In terms of σ = λ²/(λ² + 6): α_axial = (1 + σ)/4, β_axial = (1 − σ)/4.
#[derive(Clone, Copy, Debug)]
pub struct AxialFactors;

impl Formula for AxialFactors {
    const SPEC: Spec = Spec::new(
        "ujoint.axial_factors",
        "Shares of an axial force",
        Document::UJOINT.ours("Friction", "the page uses both factors and defines neither"),
    )
        .equation(r"\alpha_{\mathrm{axial}} = \frac{\lambda^2+3}{2(\lambda^2+6)},\quad \beta_{\mathrm{axial}} = \frac{3}{2(\lambda^2+6)},\quad \lambda = \frac{L_a}{R_p}")
        // The largest η that `audit --attack` found is 1.2 for the value, and 2.5 is possible to first order; for the Jacobian 3.96
        // and 7.25.
        .eta(2.5, 7.5)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = Arm<T>;
    type Outputs<T: Component> = AxialShares<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Arm<D>) -> AxialShares<D> {
        AxialShares::new(&i.axial_slenderness())
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Arm<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Arm<D>) -> (AxialShares<D>, Jacobian<Self, D>) {
        let slenderness = i.axial_slenderness();
        let (la, rp) = (slenderness.gradient.la * 0.25, slenderness.gradient.rp * 0.25);
        let slopes = AxialShares { alpha_axial: Arm { la, rp }, beta_axial: Arm { la: -la, rp: -rp } };
        (AxialShares::new(&slenderness), slopes)
    }
}

/// α_twist of a clamped Timoshenko arm.
#[inline]
pub fn timoshenko<D: Scalar>(phi: D) -> D {
    (-phi + 2.0) / ((phi + 4.0) * 4.0)
}

/// φ = 12 EI/(κ G A La²) = (7 + 6ν)/λ² for a round arm of ν = 0.3: the ratio of shear to bending deformation of the arm.
#[inline]
pub fn phi<D: Scalar>(arm: &Arm<D>) -> D {
    let ratio = arm.rp / arm.la;
    ratio * ratio * 44.0 / 5.0
}
