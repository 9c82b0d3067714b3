//! Friction of SLOT, TRANSLATOR and UJOINT, and the stops.

use crate::statements::erratum::{Erratum, apart, at, erratum};
use jointproof::connector::{slot, translator, ujoint};
use jointproof::formula::Formula;

pub(super) fn errata() -> Vec<Erratum> {
    vec![roots(), quotients(), sign(), normal_forces(), beta(), stops()]
}

const DOUBLED: &str = "twice the loads, twice the result";

/// The deviation of a function from homogeneity of degree 1 in its loads.
fn degree(f: impl Fn(f64) -> f64) -> f64 {
    apart(f(2.0), 2.0 * f(1.0))
}

fn roots() -> Erratum {
    let contact = |k: f64| slot::ContactForce::eval(&slot::CrossForces { f2: 3.0 * k, f3: 4.0 * k }).fc;
    let contact_printed = |k: f64| (3.0 * k).powi(2) + (4.0 * k).powi(2);
    let bending =
        |k: f64| translator::BendingForce::eval(&translator::Bending { m2: 6.0 * k, m3: 8.0 * k, l: 5.0 }).m_bend;
    let bending_printed = |k: f64| (6.0 * k).powi(2) + (8.0 * k).powi(2);
    let reaction = |k: f64| ujoint::Reaction::eval(&ujoint::JoinForces { f1: 2.0 * k, f2: 3.0 * k, f3: 6.0 * k }).fr;
    let reaction_printed = |k: f64| (2.0 * k).powi(2) + (3.0 * k).powi(2) + (6.0 * k).powi(2);
    erratum(
        "lost-roots",
        vec![
            at("SLOT, $f_2 = 3$, $f_3 = 4$", DOUBLED)
                .printed(r"F_C = f_2^2 + f_3^2", contact_printed(1.0), degree(contact_printed))
                .here::<slot::ContactForce>(r"F_C = \sqrt{f_2^2 + f_3^2}", contact(1.0), degree(contact)),
            at("TRANSLATOR, $m_2 = 6$, $m_3 = 8$", DOUBLED)
                .printed(r"M_{\mathrm{bend}} = m_2^2 + m_3^2", bending_printed(1.0), degree(bending_printed))
                .here::<translator::BendingForce>(
                    r"M_{\mathrm{bend}} = \sqrt{m_2^2 + m_3^2}",
                    bending(1.0),
                    degree(bending),
                ),
            at("UJOINT, $f_1 = 2$, $f_2 = 3$, $f_3 = 6$", DOUBLED)
                .printed(r"F_r = f_1^2 + f_2^2 + f_3^2", reaction_printed(1.0), degree(reaction_printed))
                .here::<ujoint::Reaction>(r"F_r = \sqrt{f_1^2 + f_2^2 + f_3^2}", reaction(1.0), degree(reaction)),
        ],
    )
}

/// The change of a force if lengths are measured in thousandths; `f` is given the unit of length.
fn in_other_units(f: impl Fn(f64) -> f64) -> f64 {
    apart(f(1.0), f(1000.0))
}

fn quotients() -> Erratum {
    const UNITS: &str = "a force does not change if lengths are given in mm instead of m";
    let torque = |mm: f64| translator::TorqueForce::eval(&translator::Torque { m1: 12.0 * mm, rr: 0.5 * mm }).f_torq;
    let torque_printed = |mm: f64| 12.0 * mm * 0.5 * mm;
    let bending = |mm: f64| {
        translator::BendingForce::eval(&translator::Bending { m2: 6.0 * mm, m3: 8.0 * mm, l: 5.0 * mm }).f_bend
    };
    let bending_printed = |mm: f64| 2.0 * (10.0 * mm) * (5.0 * mm);
    let twist =
        |mm: f64| ujoint::HingeTwist::eval(&ujoint::Twist { m2: 12.0 * mm, la: 3.0 * mm, rp: mm }).f_twist_hinge;
    let twist_printed = |mm: f64| {
        ujoint::TwistFactors::eval(&ujoint::Arm { la: 3.0 * mm, rp: mm }).beta_twist * (12.0 * mm) * (3.0 * mm)
    };
    let sleeve = |mm: f64| {
        let [la, rp, ls] = [3.0, 1.0, 0.5].map(|length| length * mm);
        ujoint::HingeBending::eval(&ujoint::Bending { f_bend: 16.0, m2: 0.0, la, rp, ls }).f_total_bend
    };
    let sleeve_printed = |mm: f64| 2.0 * (6.0 * mm) * (0.5 * mm);
    let (f_bend, la, rp) = (16.0, 3.0, 1.0);
    let m_bend = ujoint::HingeBending::eval(&ujoint::Bending { f_bend, m2: 0.0, la, rp, ls: 0.5 }).m_bend_hinge;
    let across = ujoint::CentreLoads { f_axial1: 0.0, f_axial3: 0.0, f_bend, m2: 0.0, la, rp };
    let share = ujoint::HingeTransverse::eval(&across).f_total_hinge1;
    erratum(
        "lost-quotients",
        vec![
            at("TRANSLATOR, $m_1 = 12$, $R_r = 0.5$", UNITS)
                .printed(
                    r"F_{\mathrm{torq}} = M_{\mathrm{torq}} R_r",
                    torque_printed(1.0),
                    in_other_units(torque_printed),
                )
                .here::<translator::TorqueForce>(
                    r"F_{\mathrm{torq}} = M_{\mathrm{torq}}/R_r",
                    torque(1.0),
                    in_other_units(torque),
                ),
            at("TRANSLATOR, $m_2 = 6$, $m_3 = 8$, $L = 5$", UNITS)
                .printed(
                    r"F_{\mathrm{bend}} = 2M_{\mathrm{bend}} L",
                    bending_printed(1.0),
                    in_other_units(bending_printed),
                )
                .here::<translator::BendingForce>(
                    r"F_{\mathrm{bend}} = 2M_{\mathrm{bend}}/L",
                    bending(1.0),
                    in_other_units(bending),
                ),
            at("UJOINT, $m_2 = 12$, $L_a = 3$, $R_p = 1$", UNITS)
                .printed(
                    r"F_{\mathrm{twist}} = \beta_{\mathrm{twist}} M_{\mathrm{twist}} L_a",
                    twist_printed(1.0),
                    in_other_units(twist_printed),
                )
                .here::<ujoint::HingeTwist>(
                    r"F_{\mathrm{twist}} = \beta_{\mathrm{twist}} M_{\mathrm{twist}}/L_a",
                    twist(1.0),
                    in_other_units(twist),
                ),
            at(r"UJOINT, $F_{\mathrm{bend}} = 16$, $m_2 = 0$, $L_a = 3$, $L_s = 0.5$", UNITS)
                .printed(
                    r"F_{\mathrm{totalbend}} = 2M_{\mathrm{total}} L_s",
                    sleeve_printed(1.0),
                    in_other_units(sleeve_printed),
                )
                .here::<ujoint::HingeBending>(
                    r"F_{\mathrm{totalbend}} = 2M_{\mathrm{total}}/L_s",
                    sleeve(1.0),
                    in_other_units(sleeve),
                ),
            at(
                r"UJOINT, $F_{\mathrm{bend}} = 16$, $L_a = 3$",
                r"half of the force on a beam of length $2L_a$ clamped at both ends: with the equal moment in its middle, $F_{\mathrm{bend}}L_a/4$",
            )
            .printed(r"M_{\mathrm{bend}} = 18 F_{\mathrm{bend}} L_a", 18.0 * f_bend * la, apart(2.0 * 18.0 * f_bend * la, f_bend * la / 4.0))
            .here::<ujoint::HingeBending>(
                r"M_{\mathrm{bend}} = \tfrac18 F_{\mathrm{bend}} L_a",
                m_bend,
                apart(2.0 * m_bend, f_bend * la / 4.0),
            ),
            at(r"UJOINT, $F_{\mathrm{bend}} = 16$ alone", "the four hinges carry the whole force")
                .printed(r"F_{\mathrm{bend}}^{\mathrm{hinge}} = F_{\mathrm{bend}}\,4", f_bend * 4.0, apart(4.0 * 4.0 * f_bend, f_bend))
                .here::<ujoint::HingeTransverse>(
                    r"F_{\mathrm{bend}}^{\mathrm{hinge}} = F_{\mathrm{bend}}/4",
                    share,
                    apart(4.0 * share, f_bend),
                ),
        ],
    )
}

fn sign() -> Erratum {
    let loads = slot::SlotLoads { f1: 1.5, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 };
    let here = slot::Friction::eval(&loads);
    let unloaded = slot::Friction::eval(&slot::SlotLoads { f2: 0.0, f3: 0.0, ..loads }).r#fn;
    let printed = here.p - loads.mu * unloaded;
    erratum(
        "lost-sign",
        vec![
            at(
                r"$f_1 = 1.5$, $f_2 = 3$, $f_3 = 4$, $F_C^{\mathrm{int}} = 1$, $\mu = 0.25$, with the force of the unloaded slot for $F_{N0}$",
                r"at the friction force, $P = \mu F_N$, it is 0",
            )
            .printed(r"\Phi = P - \mu F_{N0}", printed, apart(printed + here.p, here.p))
            .here::<slot::Friction>(r"\Phi = P - \mu F_N \le 0", here.phi, apart(here.phi + here.p, here.p)),
        ],
    )
}

fn normal_forces() -> Erratum {
    let here = |mc1: f64, mc1_int: f64| {
        ujoint::NormalMoments::eval(&ujoint::AllContactMoments { mc1, mc3: 0.0, mc1_int, mc3_int: 0.0 }).mn1
    };
    let as_slot =
        |mc1: f64, mc1_int: f64| 2.0 * slot::NormalForce::eval(&slot::ContactForces { fc: mc1, fc_int: mc1_int }).r#fn;
    let [mc1, internal] = [5.0, 9.0];
    erratum(
        "two-normal-forces",
        vec![
            at(r"$M_{C1} = 5$, $M_{C1}^{\mathrm{int}} = -9$", "reversing the internal moment does not change it")
                .literal(
                    "by the rule of SLOT",
                    r"M_{N1} = 2\lvert M_{C1} + M_{C1}^{\mathrm{int}}\rvert",
                    as_slot(mc1, -internal),
                    apart(as_slot(mc1, -internal), as_slot(mc1, internal)),
                )
                .here::<ujoint::NormalMoments>(
                    r"M_{N1} = 2\lvert M_{C1}\rvert + \lvert M_{C1}^{\mathrm{int}}\rvert",
                    here(mc1, -internal),
                    apart(here(mc1, -internal), here(mc1, internal)),
                ),
        ],
    )
}

fn beta() -> Erratum {
    let (m2, l, angle) = (10.0, 5.0, 0.1);
    let here = translator::BendingForce::eval(&translator::Bending { m2, m3: 0.0, l }).f_bend;
    erratum(
        "two-meanings-of-beta",
        vec![
            at(
                r"$m_2 = 10$, $L = 5$, b turned by 0.1",
                "two opposite forces of half the size, $L$ apart, carry the moment",
            )
            .literal(
                "the Cardan angle",
                r"F_{\mathrm{bend}} = \lvert\beta m_2\rvert",
                angle * m2,
                apart(angle * m2 * l / 2.0, m2),
            )
            .here::<translator::BendingForce>(
                r"F_{\mathrm{bend}} = 2\lvert m_2\rvert/L",
                here,
                apart(here * l / 2.0, m2),
            ),
        ],
    )
}

fn stops() -> Erratum {
    let (x, y, l1_max, step) = (4.0, 3.0, 4.5, 1.0);
    let here = |x: f64| slot::Stop::eval(&slot::StopLengths { x, l1_min: 0.0, l1_max }).gap_max;
    let distance = |x: f64| l1_max - f64::hypot(x, y);
    let off = |gap: &dyn Fn(f64) -> f64| apart(gap(x) - gap(x + step), step);
    erratum(
        "length-at-the-stops",
        vec![
            at(
                r"b is at $x = 4$, $y = y_0 = 3$, and $l_1^{\max} = 4.5$",
                "moving b by 1 along the slot reduces the gap by 1",
            )
            .literal(
                "$l$ as the distance of the nodes",
                r"l_1^{\max} - \lvert\mathbf{x}_b-\mathbf{x}_a\rvert",
                distance(x),
                off(&distance),
            )
            .here::<slot::Stop>(r"l_1^{\max} - x", here(x), off(&here)),
        ],
    )
}
