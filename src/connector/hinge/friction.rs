//! The moments in the hinge that produce friction, and the friction they allow.

use super::DOCUMENT;
use crate::contact::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::quantity::{CROSS_M1, Domain, F2, F3, JOIN_F1, M2, M3, MU, Quantity, Unit};
use crate::formula::{Component, Fields, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, abs, norm, norm_and_direction, sign};

/// Radius of the pin.
pub const RP: Quantity =
    Quantity::scalar("R_p", Unit::L, Domain::Positive, "effective radius of the pin's cross-section");
/// Arm of the axial force.
pub const RA: Quantity = Quantity::scalar(
    "R_a",
    Unit::L,
    Domain::NonNegative,
    "effective friction arm of the force along the pin; 0 omits this force",
);
/// Overlap.
pub const LS: Quantity = Quantity::scalar(
    "L_s",
    Unit::L,
    Domain::NonNegative,
    "length over which pin and sleeve overlap; 0 omits the bending moments",
);
/// Contact moment.
pub const MC: Quantity = Quantity::scalar(
    "M_C",
    Unit::FL,
    Domain::NonNegative,
    "contact moment of the hinge, which the connector's loads produce",
);
/// Internal contact moment.
pub const MC_INT: Quantity = Quantity::scalar(
    r"M_C^{\mathrm{int}}",
    Unit::FL,
    Domain::Real,
    "self-equilibrated internal contact moment about the pin, for instance from a press fit",
);
/// Normal moment.
pub const MN: Quantity =
    Quantity::scalar("M_N", Unit::FL, Domain::NonNegative, "normal moment that produces friction about the pin");
/// Tangential traction, as a moment.
pub const P_MOMENT: Quantity = Quantity::scalar(
    "P",
    Unit::FL,
    Domain::NonNegative,
    "magnitude of the moment of the frictional tangential tractions",
);
/// Yield function, as a moment.
pub const PHI_MOMENT: Quantity =
    Quantity::scalar(r"\Phi", Unit::FL, Domain::Real, "yield function of the hinge: stick below 0, slip at 0");

fields! {
    /// The constraint forces and moments, and the dimensions of the pin.
    pub struct PinLoads<T> {
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3, m2: T = M2, m3: T = M3, rp: T = RP, ra: T = RA, ls: T = LS,
    }
}
fields! {
    /// Contact moment.
    pub struct Contact<T> { mc: T = MC }
}

/// Contact moment of a HINGE: M_C = |f1| R_a + R_p √(f2² + f3²) + (2 R_p/L_s) √(m2² + m3²).
///
/// The bending moments are a couple of forces at both ends of the sleeve, each M_bend/L_s; where L_s = 0 they are omitted.
#[derive(Clone, Copy, Debug)]
pub struct ContactMoment;

impl<D: Scalar> PinLoads<D> {
    /// 2 R_p/L_s, by which the bending moment enters.
    #[inline]
    fn bending_share(&self) -> D {
        if self.ls == 0.0 { D::zero() } else { self.rp * 2.0 / self.ls }
    }
}

impl Formula for ContactMoment {
    const SPEC: Spec = Spec::new(
        "hinge.contact_moment",
        "Contact moment",
        DOCUMENT.reconstructed("Friction", "all equations were lost; the parts are those that UJOINT's page prints of each hinge"),
    )
        .equation(r"M_C = \lvert f_1\rvert R_a + R_p\sqrt{f_2^2 + f_3^2} + \beta\sqrt{m_2^2 + m_3^2},\quad \beta = \begin{cases} 2R_p/L_s & L_s > 0 \\ 0 & L_s = 0 \end{cases}")
        .eta(2.0, 3.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = PinLoads<T>;
    type Outputs<T: Component> = Contact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &PinLoads<D>) -> Contact<D> {
        Contact { mc: abs(i.f1) * i.ra + i.rp * norm([i.f2, i.f3]) + i.bending_share() * norm([i.m2, i.m3]) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &PinLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &PinLoads<D>) -> ValueAndJacobian<Self, D> {
        let (radial, [n2, n3]) = norm_and_direction([i.f2, i.f3]);
        let (bending, [b2, b3]) = norm_and_direction([i.m2, i.m3]);
        let (share, zero) = (i.bending_share(), D::zero());
        let (by_rp, by_ls) = if i.ls == 0.0 { (zero, zero) } else { (bending * 2.0 / i.ls, -(share * bending) / i.ls) };
        let by = PinLoads {
            f1: sign(i.f1) * i.ra,
            f2: i.rp * n2,
            f3: i.rp * n3,
            m2: share * b2,
            m3: share * b3,
            rp: radial + by_rp,
            ra: abs(i.f1),
            ls: by_ls,
        };
        (Contact { mc: abs(i.f1) * i.ra + i.rp * radial + share * bending }, Contact { mc: by })
    }
}

fields! {
    /// All loads of a HINGE, and its friction parameters.
    pub struct HingeLoads<T> {
        m1: T = CROSS_M1, f1: T = JOIN_F1, f2: T = F2, f3: T = F3, m2: T = M2, m3: T = M3,
        rp: T = RP, ra: T = RA, ls: T = LS, mc_int: T = MC_INT, mu: T = MU,
    }
}
fields! {
    /// Moment of the tangential tractions, normal moment and yield function.
    pub struct HingeFriction<T> { p: T = P_MOMENT, mn: T = MN, phi: T = PHI_MOMENT }
}

/// The friction of a HINGE: P = |m1|, M_N = |M_C| + |M_C_int|, Φ = P − μ M_N.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl<D: Scalar> HingeLoads<D> {
    #[inline]
    fn pin(&self) -> PinLoads<D> {
        let Self { f1, f2, f3, m2, m3, rp, ra, ls, .. } = *self;
        PinLoads { f1, f2, f3, m2, m3, rp, ra, ls }
    }

    /// A gradient by the loads of the pin, times a factor.
    #[inline]
    fn by_pin(by: &PinLoads<D>, factor: D) -> Self {
        let PinLoads { f1, f2, f3, m2, m3, rp, ra, ls } = *by;
        let [f1, f2, f3, m2, m3, rp, ra, ls] = [f1, f2, f3, m2, m3, rp, ra, ls].map(|x| x * factor);
        Self { f1, f2, f3, m2, m3, rp, ra, ls, ..Self::filled(D::zero()) }
    }
}

impl Formula for Friction {
    const SPEC: Spec = Spec::new(
        "hinge.friction",
        "Friction",
        DOCUMENT.reconstructed(
            "Friction",
            "all equations were lost; the normal moment is that of UJOINT's page, of one hinge",
        ),
    )
    .equation(
        r"P = \lvert m_1\rvert,\quad M_N = \lvert M_C\rvert + \lvert M_C^{\mathrm{int}}\rvert,\quad \Phi = P - \mu M_N",
    )
    .given(&[Given::new("M_C", &ContactMoment::SPEC)])
    .eta(4.0, 3.0)
    .scale(1e50)
    .finite(Finite::Between);
    type Inputs<T: Component> = HingeLoads<T>;
    type Outputs<T: Component> = HingeFriction<T>;

    #[inline]
    fn eval<D: Scalar>(i: &HingeLoads<D>) -> HingeFriction<D> {
        let (p, mn) = (abs(i.m1), ContactMoment::eval(&i.pin()).mc + abs(i.mc_int));
        HingeFriction { p, mn, phi: Yield::eval(&Tractions { p, mu: i.mu, r#fn: mn }).phi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &HingeLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &HingeLoads<D>) -> ValueAndJacobian<Self, D> {
        let (Contact { mc }, Contact { mc: by }) = ContactMoment::linearized(&i.pin());
        let (p, mn, none) = (abs(i.m1), mc + abs(i.mc_int), HingeLoads::filled(D::zero()));
        let phi = Yield::eval(&Tractions { p, mu: i.mu, r#fn: mn }).phi;
        let (turning, fit) = (sign(i.m1), sign(i.mc_int));
        let by = HingeFriction {
            p: HingeLoads { m1: turning, ..none },
            mn: HingeLoads { mc_int: fit, ..HingeLoads::by_pin(&by, D::one()) },
            phi: HingeLoads { m1: turning, mc_int: -i.mu * fit, mu: -mn, ..HingeLoads::by_pin(&by, -i.mu) },
        };
        (HingeFriction { p, mn, phi }, by)
    }
}
