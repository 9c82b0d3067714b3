//! What the forces along the axes of the cross make on a hinge.

use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{F_AXIAL_HINGE1, F_AXIAL_HINGE3, F_AXIAL1, F_AXIAL3, F_TRANSV_HINGE1, F_TRANSV_HINGE3, LA, RP};
use crate::scalar::{Scalar, abs, sign};
use crate::ujoint::{Arm, AxialFactors, AxialShares};
use crate::verify::{hard, law};

fields! {
    /// The force along the axes of the cross, and an arm.
    pub struct AxialForces<T> { f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, la: T = LA, rp: T = RP }
}
fields! {
    /// Axial and transverse force on each hinge.
    pub struct AxialLoads<T> {
        f_axial_hinge1: T = F_AXIAL_HINGE1, f_axial_hinge3: T = F_AXIAL_HINGE3,
        f_transv_hinge1: T = F_TRANSV_HINGE1, f_transv_hinge3: T = F_TRANSV_HINGE3,
    }
}

/// What the axial forces make on each hinge: a force along an axis pulls on the two hinges of that axis with α_axial of its
/// size, and pushes the two of the other axis sideways with β_axial of it.
#[derive(Clone, Copy, Debug)]
pub struct HingeAxial;

impl Formula for HingeAxial {
    const SPEC: Spec = Spec {
        id: "ujoint.hinge_axial",
        title: "Hinge loads of the axial forces",
        latex: r"F_{\mathrm{axial}k}^{\mathrm{hinge}} = \alpha_{\mathrm{axial}}\lvert F_{\mathrm{axial}k}\rvert\ (k = 1, 3),\quad F_{\mathrm{transv1}}^{\mathrm{hinge}} = \beta_{\mathrm{axial}}\lvert F_{\mathrm{axial3}}\rvert,\quad F_{\mathrm{transv3}}^{\mathrm{hinge}} = \beta_{\mathrm{axial}}\lvert F_{\mathrm{axial1}}\rvert",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = AxialForces<T>;
    type Outputs<T: Element> = AxialLoads<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AxialForces<D>) -> AxialLoads<D> {
        i.loads(&AxialFactors::eval(&i.arm()))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AxialForces<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &AxialForces<D>) -> (AxialLoads<D>, Jacobian<Self, D>) {
        let (shares, slopes) = AxialFactors::linearized(&i.arm());
        let zero = AxialForces::filled(D::zero());
        let by_1 = |share, slope| {
            let Shared { by_force: f_axial1, by_arm: Arm { la, rp }, .. } = share_of(i.f_axial1, share, slope);
            AxialForces { f_axial1, la, rp, ..zero }
        };
        let by_3 = |share, slope| {
            let Shared { by_force: f_axial3, by_arm: Arm { la, rp }, .. } = share_of(i.f_axial3, share, slope);
            AxialForces { f_axial3, la, rp, ..zero }
        };
        let jacobian = AxialLoads {
            f_axial_hinge1: by_1(shares.alpha_axial, slopes.alpha_axial),
            f_axial_hinge3: by_3(shares.alpha_axial, slopes.alpha_axial),
            f_transv_hinge1: by_3(shares.beta_axial, slopes.beta_axial),
            f_transv_hinge3: by_1(shares.beta_axial, slopes.beta_axial),
        };
        (i.loads(&shares), jacobian)
    }

    fn cases() -> Vec<Case<AxialForces<f64>>> {
        let hand = AxialForces { f_axial1: -20.0, f_axial3: 10.0, la: 2.0, rp: 1.0 };
        let mut cases = vec![
            Case::hand("lambda-2", "α = 0.35, β = 0.15: 7, 3.5 along, 1.5, 3 across", hand),
            Case::limit("stubby", "λ → 0: a quarter everywhere", AxialForces { la: 1e-9, ..hand }),
            Case::limit("long", "λ → ∞: half along, nothing across", AxialForces { la: 1e9, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f_axial1, f_axial3] = load.value;
            Case::hard(format!("forces-{}", load.id), load.comment, AxialForces { f_axial1, f_axial3, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, AxialForces { la, rp, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            let (f_axial1, f_axial3) = (-3.0 * size, 7.0 * size);
            Case::hard(arm.id, arm.comment, AxialForces { f_axial1, f_axial3, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: r"F_{\mathrm{axial1}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_axial1 == 0.0,
                at: || AxialForces { f_axial1: 0.0, f_axial3: 10.0, la: 2.0, rp: 1.0 },
                across: || AxialForces { f_axial1: 1.0, ..AxialForces::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial3}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_axial3 == 0.0,
                at: || AxialForces { f_axial1: -20.0, f_axial3: 0.0, la: 2.0, rp: 1.0 },
                across: || AxialForces { f_axial3: 1.0, ..AxialForces::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "two hinges along the force and two across it carry the whole of it",
            sides: |i| {
                let out = Self::eval(i);
                law::equal_all([
                    ((out.f_axial_hinge1 + out.f_transv_hinge3) * 2.0, abs(i.f_axial1)),
                    ((out.f_axial_hinge3 + out.f_transv_hinge1) * 2.0, abs(i.f_axial3)),
                ])
            },
        }]
    }
}

impl<D: Scalar> AxialForces<D> {
    #[inline]
    fn arm(&self) -> Arm<D> {
        Arm { la: self.la, rp: self.rp }
    }

    #[inline]
    fn loads(&self, shares: &AxialShares<D>) -> AxialLoads<D> {
        let (f1, f3) = (abs(self.f_axial1), abs(self.f_axial3));
        AxialLoads {
            f_axial_hinge1: shares.alpha_axial * f1,
            f_axial_hinge3: shares.alpha_axial * f3,
            f_transv_hinge1: shares.beta_axial * f3,
            f_transv_hinge3: shares.beta_axial * f1,
        }
    }
}

/// What a hinge takes of a force, with its derivatives by the force and by the arm.
#[derive(Clone, Copy, Debug)]
pub(in crate::ujoint) struct Shared<D> {
    pub(in crate::ujoint) value: D,
    pub(in crate::ujoint) by_force: D,
    pub(in crate::ujoint) by_arm: Arm<D>,
}

/// A share, given with its derivatives, of the size of a force.
#[inline]
pub(in crate::ujoint) fn share_of<D: Scalar>(force: D, share: D, slope: Arm<D>) -> Shared<D> {
    let size = abs(force);
    Shared {
        value: share * size,
        by_force: share * sign(force),
        by_arm: Arm { la: slope.la * size, rp: slope.rp * size },
    }
}
