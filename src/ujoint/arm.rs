//! The arm of the cross: how its slenderness λ = La/Rp shares a load out among the hinges.
//!
//! The source prints no formula, only where the factors end: a stubby arm is rigid, a slender one an Euler–Bernoulli beam,
//! with Timoshenko beams between. Both pairs of factors follow from one curve,
//!
//! ```text
//! σ(λ) = λ²/(λ² + k),   0 for a rigid arm, 1 for a slender one
//! ```
//!
//! with k = 33/5 for the twisting moment and k = 6 for axial forces. The book derives both. [`curves`] sets the
//! neighbouring models beside them.

use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Element, Formula, Jacobian, Law, Source, Spec};
use crate::quantity::{ALPHA_AXIAL, ALPHA_TWIST, BETA_AXIAL, BETA_TWIST, LA, RP};
use crate::scalar::Scalar;
use crate::verify::{hard, law};
use num_dual::DualNum;
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
    /// σ with k = `above`/`below`, both integers, since k is not always a double.
    #[inline]
    fn slenderness(&self, above: f64, below: f64) -> Slenderness<D> {
        let squares = self.la * self.la + self.rp * self.rp;
        if squares > 1e-60 && squares < 1e60 {
            self.regular_slenderness(above, below)
        } else {
            self.rescaled_slenderness(above, below)
        }
    }

    /// σ = below La²/(below La² + above Rp²). From λ dσ/dλ = 2σ(1 − σ) its gradient is 2σ(1 − σ) (1/La, −1/Rp).
    ///
    /// Only the smaller of σ and 1 − σ is a quotient, and the other is what is left of 1: the derivative of the larger
    /// quotient, as automatic differentiation takes it, is the difference of two terms that hardly differ.
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

    /// Only the ratio of the lengths counts: brings the larger to 1, lest squares under- or overflow.
    #[cold]
    fn rescaled_slenderness(self, above: f64, below: f64) -> Slenderness<D> {
        let larger = if self.la > self.rp { self.la } else { self.rp };
        let Slenderness { slender, rigid, gradient } =
            Self { la: self.la / larger, rp: self.rp / larger }.regular_slenderness(above, below);
        Slenderness { slender, rigid, gradient: Self { la: gradient.la / larger, rp: gradient.rp / larger } }
    }

    /// With the k of the twisting moment: ¾ φ λ² = ¾ · 44/5.
    #[inline]
    fn twist_slenderness(&self) -> Slenderness<D> {
        self.slenderness(33.0, 5.0)
    }

    /// With the k of axial forces.
    #[inline]
    fn axial_slenderness(&self) -> Slenderness<D> {
        self.slenderness(6.0, 1.0)
    }
}

fields! {
    /// What share of the twisting moment a hinge carries: as moment, and as force times arm length.
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
    const SPEC: Spec = Spec {
        id: "ujoint.twist_factors",
        title: "Shares of the twisting moment",
        latex: r"\alpha_{\mathrm{twist}} = \frac{1}{8+6\varphi},\quad \beta_{\mathrm{twist}} = \tfrac14 + \alpha_{\mathrm{twist}},\quad \varphi = \frac{44}{5\lambda^2},\quad \lambda = \frac{L_a}{R_p}",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Arm<T>;
    type Outputs<T: Element> = TwistShares<T>;

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

    fn cases() -> Vec<Case<Arm<f64>>> {
        let mut cases = vec![
            Case::hand("lambda-6.6", "σ = 33/38: α = 33/304, β = 109/304", Arm { la: 33.0, rp: 5.0 }),
            Case::limit("stubby", "λ → 0: a rigid arm, α → 0, β → 1/4", Arm { la: 1e-9, rp: 1.0 }),
            Case::limit("long", "λ → ∞: a clamped Euler–Bernoulli arm, α → 1/8, β → 3/8", Arm { la: 1e9, rp: 1.0 }),
        ];
        cases.extend(of_arms());
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "moments about the centre: the hinges bear (β − α) on each of four arms, together the whole moment",
                sides: |i| {
                    let TwistShares { alpha_twist, beta_twist } = Self::eval(i);
                    law::equal((beta_twist - alpha_twist) * 4.0, 1.0.into())
                },
            },
            Law {
                statement: "an Euler–Bernoulli arm that ends in a rotational spring of stiffness 4EI/(La φ) gives the same α",
                sides: |i| {
                    // Unit rotation at the centre, in units of EI/La: M = 4 + 2θ there, 2 + 4θ = −kθ at the spring.
                    let k = Octuple::from(4.0) / phi(i);
                    let theta = Octuple::from(-2.0) / (k + 4.0);
                    law::equal(Self::eval(i).alpha_twist, -k * theta / (theta * 2.0 + 4.0) * 0.25)
                },
            },
            Law {
                statement: "the Timoshenko arm is met to first order in φ: α is above it by 6φ²/((8 + 6φ)(16 + 4φ))",
                sides: |i| {
                    let phi = phi(i);
                    let above = phi * phi * 6.0 / ((phi * 6.0 + 8.0) * (phi * 4.0 + 16.0));
                    law::equal_with(Self::eval(i).alpha_twist - timoshenko(phi), above, timoshenko(phi))
                },
            },
            Law {
                statement: "α grows with λ, between 0 and 1/8",
                sides: |i| {
                    let (alpha, slope) = (Self::eval(i).alpha_twist, Self::jacobian(i).alpha_twist);
                    let inside = alpha > 0.0 && alpha < 0.125 && slope.la > 0.0 && slope.rp < 0.0;
                    law::equal(Octuple::from(f64::from(inside)), 1.0.into())
                },
            },
        ]
    }
}

/// φ = 12 EI/(κ G A La²) = (7 + 6ν)/λ² for a round arm of ν = 0.3: how much the arm shears for how much it bends.
fn phi<D: Scalar>(arm: &Arm<D>) -> D {
    let ratio = arm.rp / arm.la;
    ratio * ratio * 44.0 / 5.0
}

/// α_twist of a clamped Timoshenko arm.
fn timoshenko<D: Scalar>(phi: D) -> D {
    (-phi + 2.0) / ((phi + 4.0) * 4.0)
}

fields! {
    /// What share of an axial force the hinges of either axis carry.
    pub struct AxialShares<T> { alpha_axial: T = ALPHA_AXIAL, beta_axial: T = BETA_AXIAL }
}

impl<D: Scalar> AxialShares<D> {
    #[inline]
    fn new(slenderness: &Slenderness<D>) -> Self {
        Self { alpha_axial: slenderness.slender * 0.25 + 0.25, beta_axial: slenderness.rigid * 0.25 }
    }
}

/// Shares of an axial force: α_axial = (λ² + 3)/(2(λ² + 6)) along the loaded axis, β_axial = 3/(2(λ² + 6)) across the other,
/// λ = La/Rp.
///
/// In terms of σ = λ²/(λ² + 6): α_axial = (1 + σ)/4, β_axial = (1 − σ)/4.
#[derive(Clone, Copy, Debug)]
pub struct AxialFactors;

impl Formula for AxialFactors {
    const SPEC: Spec = Spec {
        id: "ujoint.axial_factors",
        title: "Shares of an axial force",
        latex: r"\alpha_{\mathrm{axial}} = \frac{\lambda^2+3}{2(\lambda^2+6)},\quad \beta_{\mathrm{axial}} = \frac{3}{2(\lambda^2+6)},\quad \lambda = \frac{L_a}{R_p}",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Arm<T>;
    type Outputs<T: Element> = AxialShares<T>;

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

    fn cases() -> Vec<Case<Arm<f64>>> {
        let mut cases = vec![
            Case::hand("lambda-2", "σ = 4/10: α = 0.35, β = 0.15", Arm { la: 2.0, rp: 1.0 }),
            Case::hand("lambda-3", "σ = 9/15: α = 0.4, β = 0.1", Arm { la: 4.5, rp: 1.5 }),
            Case::limit("stubby", "λ → 0: four hinges share alike, α, β → 1/4", Arm { la: 1e-9, rp: 1.0 }),
            Case::limit("long", "λ → ∞: two hinges carry all, α → 1/2, β → 0", Arm { la: 1e9, rp: 1.0 }),
        ];
        cases.extend(of_arms());
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the four hinges carry the whole force: 2α + 2β = 1",
                sides: |i| {
                    let AxialShares { alpha_axial, beta_axial } = Self::eval(i);
                    law::equal((alpha_axial + beta_axial) * 2.0, 1.0.into())
                },
            },
            Law {
                statement: "the shares are as the stiffnesses: β/α = 3/(3 + λ²)",
                sides: |i| {
                    let AxialShares { alpha_axial, beta_axial } = Self::eval(i);
                    let lambda = i.la / i.rp;
                    law::equal(beta_axial * (lambda * lambda + 3.0), alpha_axial * 3.0)
                },
            },
            Law {
                statement: "α grows with λ, between 1/4 and 1/2",
                sides: |i| {
                    let (alpha, slope) = (Self::eval(i).alpha_axial, Self::jacobian(i).alpha_axial);
                    let inside = alpha > 0.25 && alpha < 0.5 && slope.la > 0.0 && slope.rp < 0.0;
                    law::equal(Octuple::from(f64::from(inside)), 1.0.into())
                },
            },
        ]
    }
}

fn of_arms() -> impl Iterator<Item = Case<Arm<f64>>> {
    let subnormal = ["lambda-1e-160", "lambda-1e160"].into_iter().zip([[1e-160, 1.0], [1.0, 1e-160]]);
    let subnormal = subnormal.map(|(id, [la, rp])| Case::hard(id, "λ² or its inverse is subnormal", Arm { la, rp }));
    let of_arms = hard::arms().into_iter().map(|arm| {
        let [la, rp] = arm.value;
        Case::hard(arm.id, arm.comment, Arm { la, rp })
    });
    of_arms.chain(subnormal)
}

/// The four shares by one model of the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Share of the twisting moment that bends a hinge.
    pub alpha_twist: f64,
    /// Transverse force on a hinge per twisting moment over arm length.
    pub beta_twist: f64,
    /// Share of an axial force on a hinge of the loaded axis.
    pub alpha_axial: f64,
    /// Share of an axial force on a hinge of the other axis.
    pub beta_axial: f64,
}

impl Model {
    /// From α_twist and from how stiff a bent arm is beside a stretched one: both equilibria give the rest.
    fn new(alpha_twist: f64, bent_to_stretched: f64) -> Self {
        let alpha_axial = 0.5 / (1.0 + bent_to_stretched);
        Self { alpha_twist, beta_twist: 0.25 + alpha_twist, alpha_axial, beta_axial: bent_to_stretched * alpha_axial }
    }
}

/// The models of the arm at one slenderness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Models {
    /// λ = La/Rp.
    pub lambda: f64,
    /// The model used here: [`TwistFactors`] and [`AxialFactors`].
    pub used: Model,
    /// A rigid arm.
    pub rigid: Model,
    /// A clamped Timoshenko beam. Below λ = √4.4 its α_twist is negative, against the source.
    pub timoshenko: Model,
    /// A clamped Euler–Bernoulli beam.
    pub euler_bernoulli: Model,
}

/// All models of the arm at `count` slendernesses, evenly spaced on a logarithmic scale from 10^`first` to 10^`last`: the
/// data of the book's plot. The same on every machine.
///
/// ```
/// use jointproof::ujoint::arm::curves;
/// let curves = curves(-1, 3, 101);
/// let (first, last) = (curves.first().unwrap(), curves.last().unwrap());
/// assert_eq!((first.lambda, last.lambda), (0.1, 1000.0));
/// // The printed limits.
/// assert!(first.used.alpha_twist < 2e-4 && (first.used.beta_twist - 0.25).abs() < 2e-4);
/// assert!((last.used.alpha_twist - 0.125).abs() < 2e-6 && (last.used.beta_twist - 0.375).abs() < 2e-6);
/// // A stubby Timoshenko arm contradicts them.
/// assert!(first.timoshenko.alpha_twist < -0.24);
/// ```
pub fn curves(first: i32, last: i32, count: u32) -> Vec<Models> {
    let (first, last) = (Octuple::from(f64::from(first)), Octuple::from(f64::from(last)));
    let at = |k: u32| {
        let exponent = first + (last - first) * f64::from(k) / f64::from(count.saturating_sub(1).max(1));
        models(Octuple::from(10.0).powd(exponent).to_f64())
    };
    (0..count).map(at).collect()
}

/// All models at one slenderness.
fn models(lambda: f64) -> Models {
    let arm = Arm { la: lambda, rp: 1.0 };
    let TwistShares { alpha_twist, beta_twist } = TwistFactors::eval(&arm);
    let AxialShares { alpha_axial, beta_axial } = AxialFactors::eval(&arm);
    let (phi, bent_to_stretched) = (phi(&arm), 3.0 / (lambda * lambda));
    Models {
        lambda,
        used: Model { alpha_twist, beta_twist, alpha_axial, beta_axial },
        rigid: Model::new(0.0, 1.0),
        timoshenko: Model::new(timoshenko(phi), bent_to_stretched / (1.0 + phi)),
        euler_bernoulli: Model::new(0.125, bent_to_stretched),
    }
}
