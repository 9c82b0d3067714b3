//! The interaction between slave and master: pressure, damping and friction.

use crate::Scalar;
use crate::contact::coulomb::{Response, Sliding};
use crate::contact::interaction::{
    Damping, DampingContact, ExponentialContact, LinearContact, PressureExponential, PressureLinear,
};
use crate::formula::Formula;
use crate::formula::error::Error;
use crate::formula::quantity::{
    CLEARANCE, DAMPING_FRACTION, Domain, K_STICK, MU, MU0, PRESSURE_AT_TOUCH, Quantity, STIFFNESS,
};

/// The dependence of the pressure on the overclosure h = −E11.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pressure {
    /// The pressure is a multiplier, determined by the solver; it acts only if the contact is closed.
    Hard {
        /// The separation up to which a node counts as closed, ≥ 0, since a solver satisfies E11 = 0 only to a tolerance.
        tolerance: f64,
    },
    /// p = k h ([`PressureLinear`]).
    Linear {
        /// Pressure per overclosure.
        k: f64,
    },
    /// p0 at h = 0, and 0 beyond the clearance c0 ([`PressureExponential`]).
    Exponential {
        /// The clearance at which contact begins.
        c0: f64,
        /// The pressure at zero overclosure.
        p0: f64,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Viscous {
    mu0: f64,
    c0: f64,
    eta: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Frictional {
    mu: f64,
    k_stick: f64,
}

/// A mechanical surface interaction. By default it is hard and without friction or damping.
///
/// ```
/// use jointproof::contact::isl::Interaction;
/// let interaction = Interaction::exponential(0.01, 20.0)?.with_damping(3.0, 0.1, 0.5)?.with_friction(0.15, 1e4)?;
/// let error = interaction.with_friction(-0.1, 1e4).unwrap_err();
/// assert_eq!(error.to_string(), "mu is -0.1; allowed is a finite number ≥ 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    pressure: Pressure,
    damping: Option<Viscous>,
    friction: Option<Frictional>,
}

impl Default for Interaction {
    fn default() -> Self {
        Self::with(Pressure::Hard { tolerance: 0.0 })
    }
}

fn check(name: &'static str, value: f64, quantity: &Quantity) -> Result<(), Error> {
    Error::check(name, None, value, quantity.domain)
}

impl Interaction {
    const fn with(pressure: Pressure) -> Self {
        Self { pressure, damping: None, friction: None }
    }

    /// Hard contact, closed up to the separation `tolerance` ≥ 0 (unit of length).
    ///
    /// # Errors
    /// A `tolerance` that is negative or not finite.
    pub fn hard(tolerance: f64) -> Result<Self, Error> {
        Error::check("tolerance", None, tolerance, Domain::NonNegative)?;
        Ok(Self::with(Pressure::Hard { tolerance }))
    }

    /// Pressure proportional to the overclosure, `k` > 0 (F/L³).
    ///
    /// # Errors
    /// A `k` that is not positive and finite.
    pub fn linear(k: f64) -> Result<Self, Error> {
        check("k", k, &STIFFNESS)?;
        Ok(Self::with(Pressure::Linear { k }))
    }

    /// Exponential pressure from the clearance `c0` > 0 (L), with the pressure `p0` > 0 (F/L²) at zero overclosure.
    ///
    /// # Errors
    /// A parameter that is not positive and finite.
    pub fn exponential(c0: f64, p0: f64) -> Result<Self, Error> {
        check("c0", c0, &CLEARANCE)?;
        check("p0", p0, &PRESSURE_AT_TOUCH)?;
        Ok(Self::with(Pressure::Exponential { c0, p0 }))
    }

    /// Adds viscous damping ([`Damping`]): `mu0` ≥ 0 (FT/L³), falling to 0 between the clearances `eta`·`c0` and `c0`.
    ///
    /// # Errors
    /// A parameter outside its domain.
    pub fn with_damping(self, mu0: f64, c0: f64, eta: f64) -> Result<Self, Error> {
        check("mu0", mu0, &MU0)?;
        check("c0", c0, &CLEARANCE)?;
        check("eta", eta, &DAMPING_FRACTION)?;
        Ok(Self { damping: Some(Viscous { mu0, c0, eta }), ..self })
    }

    /// Adds Coulomb friction: the coefficient `mu` ≥ 0, and the stiffness in stick `k_stick` > 0, as shear stress per displacement
    /// (F/L³).
    ///
    /// # Errors
    /// A parameter outside its domain.
    pub fn with_friction(self, mu: f64, k_stick: f64) -> Result<Self, Error> {
        check("mu", mu, &MU)?;
        check("k_stick", k_stick, &K_STICK)?;
        Ok(Self { friction: Some(Frictional { mu, k_stick }), ..self })
    }

    /// The law of the pressure.
    pub fn pressure_law(&self) -> Pressure {
        self.pressure
    }

    /// The pressure S11 at the overclosure `h` and the closing rate `v`: that of the law plus that of damping, which can be
    /// negative.
    ///
    /// `multiplier` is the pressure of hard contact; it is ignored otherwise.
    pub fn pressure<D: Scalar>(&self, h: D, v: D, multiplier: D) -> D {
        let p = self.law(h, multiplier);
        match self.damping(h, v) {
            Some(damping) => p + damping,
            None => p,
        }
    }

    /// The pressure of the law alone.
    pub(super) fn law<D: Scalar>(&self, h: D, multiplier: D) -> D {
        match self.pressure {
            Pressure::Hard { tolerance } => {
                if -h <= tolerance {
                    multiplier
                } else {
                    D::zero()
                }
            }
            Pressure::Linear { k } => PressureLinear::eval(&LinearContact { h, k: k.into() }).p,
            Pressure::Exponential { c0, p0 } => {
                PressureExponential::eval(&ExponentialContact { h, c0: c0.into(), p0: p0.into() }).p
            }
        }
    }

    /// The formula of the law; hard contact has none.
    pub(super) fn law_formula(&self) -> Option<&'static str> {
        match self.pressure {
            Pressure::Hard { .. } => None,
            Pressure::Linear { .. } => Some(PressureLinear::SPEC.id),
            Pressure::Exponential { .. } => Some(PressureExponential::SPEC.id),
        }
    }

    /// The pressure of damping, if there is any.
    pub(super) fn damping<D: Scalar>(&self, h: D, v: D) -> Option<D> {
        let Viscous { mu0, c0, eta } = self.damping?;
        Some(Damping::eval(&DampingContact { h, v, mu0: mu0.into(), c0: c0.into(), eta: eta.into() }).p)
    }

    pub(super) fn damping_formula(&self) -> Option<&'static str> {
        self.damping.map(|_| Damping::SPEC.id)
    }

    pub(super) fn friction_formula(&self) -> Option<&'static str> {
        self.friction.map(|_| Response::SPEC.id)
    }

    /// The shear stress S12 under the pressure `p` after the slip increment `slip`, from the previous shear stress `s12`.
    ///
    /// It is that of [`Response`]; nothing is transmitted unless the pressure is positive.
    pub fn shear<D: Scalar>(&self, s12: D, slip: D, p: D) -> D {
        let Some(Frictional { mu, k_stick }) = self.friction.filter(|_| p > 0.0) else {
            return D::zero();
        };
        Response::eval(&Sliding { du: slip, f_before: s12, k_stick: k_stick.into(), mu: mu.into(), r#fn: p }).f
    }
}
