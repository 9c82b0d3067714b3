//! The hinges of UJOINT.

use crate::statements::erratum::{Erratum, apart, at, erratum};
use jointproof::connector::ujoint::{
    self, Arm, AxialForces, AxialShares, Bending, CentreLoads, JointLoads, StopAngles, Twist,
};
use jointproof::formula::Formula;
use nalgebra::Vector3;

pub(super) fn errata() -> Vec<Erratum> {
    vec![axial_factors(), bars(), parallel_forces(), end_moment(), stops()]
}

const ARM: Arm<f64> = Arm { la: 3.0, rp: 1.0 };
const FORCE: f64 = 1000.0;

fn axial_factors() -> Erratum {
    let AxialShares { alpha_axial, beta_axial } = ujoint::AxialFactors::eval(&ARM);
    let twist = ujoint::TwistFactors::eval(&ARM);
    let carried = |alpha: f64, beta: f64| 2.0 * alpha + 2.0 * beta;
    let of_twist = carried(twist.alpha_twist, twist.beta_twist);
    let here = carried(alpha_axial, beta_axial);
    erratum(
        "undefined-axial-factors",
        vec![
            at("$L_a/R_p = 3$", "the four hinges carry the whole force")
                .literal(
                    "the factors of twisting",
                    r"2\alpha_{\mathrm{twist}} + 2\beta_{\mathrm{twist}}",
                    of_twist,
                    apart(of_twist, 1.0),
                )
                .here::<ujoint::AxialFactors>(
                    r"2\alpha_{\mathrm{axial}} + 2\beta_{\mathrm{axial}}",
                    here,
                    apart(here, 1.0),
                ),
        ],
    )
}

fn bars() -> Erratum {
    let Arm { la, rp } = ARM;
    let loads = |f1: f64| {
        let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
        JointLoads { e1a, e2a, e3a, e3b: e3a, f1, f2: 0.0, f3: 0.0, m2: 0.0, rp, la, ra: 0.5, ls: 0.5 }
    };
    let here = |f1: f64| ujoint::ContactMoments::eval(&loads(f1)).mc1;
    let printed = |f1: f64| {
        let taken = ujoint::HingeAxial::eval(&AxialForces { f_axial1: f1, f_axial3: 0.0, la, rp }).f_axial_hinge1;
        here(f1) + (taken.copysign(f1) - taken) * loads(f1).ra
    };
    erratum(
        "lost-bars",
        vec![
            at(r"$f_1 = -1000$ along an arm, $L_a/R_p = 3$, $R_a = 0.5$", "reversing all loads does not change it")
                .printed(
                    r"M_{C1} = \alpha_{\mathrm{axial}}F_{\mathrm{axial}1}R_a + \dots",
                    printed(-FORCE),
                    apart(printed(-FORCE), printed(FORCE)),
                )
                .here::<ujoint::ContactMoments>(
                    r"M_{C1} = \alpha_{\mathrm{axial}}\lvert F_{\mathrm{axial}1}\rvert R_a + \dots",
                    here(-FORCE),
                    apart(here(-FORCE), here(FORCE)),
                ),
        ],
    )
}

/// A force along arm 3 pushes both hinges of axis 1 in the same direction. The twisting moment pushes them in opposite
/// directions; it is chosen as large as the force.
fn parallel_forces() -> Erratum {
    let Arm { la, rp } = ARM;
    let pushed = ujoint::HingeAxial::eval(&AxialForces { f_axial1: 0.0, f_axial3: FORCE, la, rp }).f_transv_hinge1;
    let m2 = pushed * la / ujoint::TwistFactors::eval(&ARM).beta_twist;
    let twisted = ujoint::HingeTwist::eval(&Twist { m2, la, rp }).f_twist_hinge;
    let loads = CentreLoads { f_axial1: 0.0, f_axial3: FORCE, f_bend: 0.0, m2, la, rp };
    let both = [ujoint::HingeTransverse::eval(&loads).f_total_hinge1; 2];
    let statics = [pushed + twisted, pushed - twisted].map(f64::abs);
    let off = |hinges: [f64; 2]| apart(hinges.iter().sum(), 2.0 * pushed);
    erratum(
        "parallel-forces",
        vec![
            at(
                r"$F_{\mathrm{axial}3} = 1000$ and a twisting moment that gives an equal force, $L_a/R_p = 3$; both hinges of axis 1",
                r"between them the two hinges take $2\beta_{\mathrm{axial}}F_{\mathrm{axial}3}$",
            )
            .kept::<ujoint::HingeTransverse>("as printed", 
                r"\sqrt{F_{\mathrm{twist}}^2 + F_{\mathrm{transv}1}^2}\text{ on both}",
                &both,
                off(both),
            )
            .right(
                "statics",
                r"\lvert F_{\mathrm{transv}1} + F_{\mathrm{twist}}\rvert,\ \lvert F_{\mathrm{transv}1} - F_{\mathrm{twist}}\rvert",
                &statics,
                off(statics),
            ),
        ],
    )
}

fn end_moment() -> Erratum {
    let Arm { la, rp } = ARM;
    let pushed = ujoint::HingeAxial::eval(&AxialForces { f_axial1: 0.0, f_axial3: FORCE, la, rp }).f_transv_hinge1;
    let documented = ujoint::HingeBending::eval(&Bending { f_bend: 0.0, m2: 0.0, la, rp, ls: 0.5 }).m_total_hinge;
    let statics = pushed * la / 2.0;
    let off = |moment: f64| apart(2.0 * moment, pushed * la);
    erratum(
        "missing-end-moment",
        vec![
            at(
                r"$F_{\mathrm{axial}3} = 1000$ alone, $L_a/R_p = 3$; a hinge of axis 1",
                "the moments at the two ends of an arm balance the force on it",
            )
            .kept::<ujoint::HingeBending>(
                "as printed",
                r"M_{\mathrm{total}} = \sqrt{M_{\mathrm{bend}}^2 + M_{\mathrm{twist}}^2}",
                &[documented],
                off(documented),
            )
            .right("statics", r"\beta_{\mathrm{axial}}F_{\mathrm{axial}3}L_a/2", &[statics], off(statics)),
        ],
    )
}

fn stops() -> Erratum {
    let (theta1_max, turn) = (0.5, 0.25);
    let angles =
        |alpha: f64| StopAngles { alpha, gamma: 0.0, theta1_min: -0.5, theta1_max, theta3_min: -1.0, theta3_max: 1.0 };
    let here = |alpha: f64| ujoint::Stop::eval(&angles(alpha)).gap1_max;
    let printed = |alpha: f64| theta1_max - angles(alpha).gamma;
    let off = |gap: &dyn Fn(f64) -> f64| apart(gap(1.0) - gap(1.0 + turn), turn);
    erratum(
        "one-angle-twice",
        vec![
            at(
                r"$\alpha = 1$, $\gamma = 0$, $\theta_1^{\max} = 0.5$",
                "a rotation by 0.25 about the first arm reduces its gap by 0.25",
            )
            .printed(r"\theta_1^{\max} - \gamma", printed(1.0), off(&printed))
            .here::<ujoint::Stop>(r"\theta_1^{\max} - \alpha", here(1.0), off(&here)),
        ],
    )
}
