//! Drivers for routines whose interface is prescribed by a finite-element program.
//!
//! Every driver is one program, `answer.f90`, that contains the call of the interface: a template consists of notes
//! for its head, a line `---`, and a subroutine that computes values and derivatives at a point.

use crate::files;
use crate::outcome::Usage;
use crate::template::filled;
use jointproof::catalog::AnyFormula;
use jointproof::connector::slider;
use jointproof::contact::{coulomb, interaction};
use jointproof::formula::Formula;
use judge::sizes;
use std::path::Path;

/// Utility routines of Abaqus.
const STUBS: &str = include_str!("abi/stubs.f90");
/// What every routine of Abaqus includes.
const ABA_PARAM: &str = include_str!("abi/ABA_PARAM.INC");

/// An interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Abi {
    /// A friction model of Abaqus: FRIC
    Fric,
    /// A multi-point constraint of Abaqus, in degree of freedom mode: MPC
    Mpc,
    /// A multi-point constraint of Abaqus, in nodal mode: MPC
    #[value(aliases = ["mpc_node", "mpc-nodal", "mpc_nodal"])]
    MpcNode,
    /// An interaction of surfaces of Abaqus, pressure and friction: UINTER
    Uinter,
    /// An element of Abaqus, with multipliers: UEL
    Uel,
    /// A multi-point constraint of CalculiX: `umpc_user`
    #[value(name = "umpc_user")]
    UmpcUser,
}

/// The replacements of `{…}` in a template.
type Places = &'static [(&'static str, &'static str)];

/// An interface, as used by drivers.
struct Interface {
    routine: &'static str,
    template: &'static str,
    /// The formulas that routines with this interface compute.
    computes: &'static [(&'static str, &'static [Places])],
}

const PLANE: Places = &[
    ("dim", "2"),
    ("_2d", "_2d"),
    ("multipliers", "the multiplier"),
    ("axes", "d = abs(x(3:4) - x(1:2))\nin_order = merge([2, 1], [1, 2], d(1) >= d(2))"),
    ("inverted", "determinant = a(1, 1, 1)\nfound(rows(1), :) = right(1, :) / determinant"),
];
const SPACE: Places = &[
    ("dim", "3"),
    ("_2d", ""),
    ("multipliers", "both multipliers"),
    (
        "axes",
        "integer :: p, q\nd = abs(x(4:6) - x(1:3))\nd = scale(d, -exponent(maxval(d)))\np = merge(3, 2, d(3) >= d(2))\nq = 5 - p\nin_order = [q, p, 1]\n\
         if (d(p) > 0 .and. d(p)**2 + d(q)**2 >= d(p) * d(1)) in_order = [q, 1, p]",
    ),
    (
        "inverted",
        "determinant = a(1, 1, 1) * a(2, 2, 1) - a(1, 2, 1) * a(2, 1, 1)\n\
         found(rows(1), :) = (a(2, 2, 1) * right(1, :) - a(1, 2, 1) * right(2, :)) / determinant\n\
         found(rows(2), :) = (a(1, 1, 1) * right(2, :) - a(2, 1, 1) * right(1, :)) / determinant",
    ),
];

/// The call of `MPC`, of `UEL`.
const CONSTRAIN: Places = &[("constrain", include_str!("abi/mpc_call.f90"))];
pub(in crate::check) const ELEMENT: Places = &[("element", include_str!("abi/uel_call.f90"))];

/// The quantities computed by an element.
const FORCES: Places = &[("multiplier", "x(moving + 1:)"), ("rows", "1:moving")];
const DISTANCES: Places = &[("multiplier", "0.75_dp * most"), ("rows", "moving + 1:ndofel")];

/// The properties of an interaction, and the quantities it computes.
const LINEAR: Places = &[
    ("props", "the stiffness of the pressure, that of friction while it sticks, and the friction coefficient"),
    ("nprops", "3"),
];
const EXPONENTIAL: Places =
    &[("props", "the clearance at which the pressure is 0, and the pressure at touch"), ("nprops", "2")];
const PRESSURE: Places = &[
    ("ndir", "2"),
    (
        "history",
        "! There are two increments, the second of which, in a second step, ends at the overclosure in question.",
    ),
    ("problem", include_str!("abi/uinter_pressure.f90")),
    ("open", "! What a pressure is while surfaces are apart, its law says."),
];
const FRICTION: Places = &[
    ("ndir", "outputs + 1"),
    (
        "history",
        "! Both stiffnesses differ from point to point. There are three increments: it slips, then sticks, then, in a second step,\n\
         ! goes to the trial traction STRESS + PROPS(2) DRDISP.",
    ),
    ("problem", include_str!("abi/uinter_friction.f90")),
    ("open", "if (any(abs(stress) > 0)) call fail('STRESS is not 0 while the surfaces are apart')"),
];

/// The equations of a line.
const ONE_EQUATION: Places =
    &[("more", ""), ("nodes", "The nodes of the terms are m, node 1 and\n! node n, twice each.")];
const TWO_EQUATIONS: Places = &[
    ("more", " + 1"),
    (
        "nodes",
        "The nodes of the terms of the\n! first equation are m, node 1 and node n, three times each, and those of the second node 1, node n and m: CalculiX refuses\n\
         ! two of them with the same first node. There is one more term, whose node has the number of the equation, 1 or 2, as its\n\
         ! first coordinate X(1, N); its coefficient is 0.",
    ),
];

/// What an `MPC` computes.
const ELIMINATED: &[(&str, &[Places])] =
    &[(slider::Eliminate::SPEC.id, &[CONSTRAIN, SPACE]), (slider::Eliminate2d::SPEC.id, &[CONSTRAIN, PLANE])];

impl Abi {
    fn interface(self) -> Interface {
        match self {
            Self::Fric => Interface {
                routine: "FRIC",
                template: include_str!("abi/fric.f90"),
                computes: &[(coulomb::ReturnMap::SPEC.id, &[]), (coulomb::ReturnMap2d::SPEC.id, &[])],
            },
            Self::Mpc => Interface { routine: "MPC", template: include_str!("abi/mpc.f90"), computes: ELIMINATED },
            Self::MpcNode => {
                Interface { routine: "MPC", template: include_str!("abi/mpc_node.f90"), computes: ELIMINATED }
            }
            Self::Uinter => Interface {
                routine: "UINTER",
                template: include_str!("abi/uinter.f90"),
                computes: &[
                    (coulomb::ReturnMap::SPEC.id, &[LINEAR, FRICTION]),
                    (coulomb::ReturnMap2d::SPEC.id, &[LINEAR, FRICTION]),
                    (
                        interaction::PressureLinear::SPEC.id,
                        &[LINEAR, PRESSURE, &[("set", "props = [x(2), 4.0_dp, 0.375_dp]")]],
                    ),
                    (interaction::PressureExponential::SPEC.id, &[EXPONENTIAL, PRESSURE, &[("set", "props = x(2:)")]]),
                ],
            },
            Self::Uel => Interface {
                routine: "UEL",
                template: include_str!("abi/uel.f90"),
                computes: &[
                    (slider::rows::Forces::SPEC.id, &[ELEMENT, FORCES, SPACE]),
                    (slider::rows_plane::Forces::SPEC.id, &[ELEMENT, FORCES, PLANE]),
                    (slider::Constraint::SPEC.id, &[ELEMENT, DISTANCES, SPACE]),
                    (slider::Constraint2d::SPEC.id, &[ELEMENT, DISTANCES, PLANE]),
                ],
            },
            Self::UmpcUser => Interface {
                routine: "umpc_user",
                template: include_str!("abi/umpc_user.f90"),
                computes: &[
                    (slider::Constraint::SPEC.id, &[TWO_EQUATIONS, SPACE]),
                    (slider::Constraint2d::SPEC.id, &[ONE_EQUATION, PLANE]),
                ],
            },
        }
    }
}

/// The driver of an interface.
///
/// # Errors
/// If routines with this interface do not compute the formula.
pub(crate) fn text(abi: Abi, formula: &dyn AnyFormula) -> Result<String, Usage> {
    let Interface { routine, template, computes } = abi.interface();
    let id = formula.spec().id;
    let Some((_, places)) = computes.iter().find(|(computed, _)| *computed == id) else {
        let ids: Vec<_> = computes.iter().map(|(id, _)| *id).collect();
        return Err(Usage(format!("--abi: a routine {routine} does not compute {id}, but\n  {}", ids.join("\n  "))));
    };
    let asked = format!("check --formula {id} --valid-only");
    let text = around(routine, template, sizes(formula), &asked).replace("{id}", id);
    Ok(places.iter().fold(text, |text, places| filled(&text, places)))
}

/// The program around a call: a template has notes for its head, a line `---`, and the module with the call.
pub(in crate::check) fn around(routine: &str, template: &str, [inputs, outputs]: [usize; 2], asked: &str) -> String {
    let (notes, ask) = template.split_once("\n---\n").expect("a template has notes and a module");
    let file = routine.to_lowercase() + ".f";
    let (inputs, outputs) = (inputs.to_string(), outputs.to_string());
    let places = [
        ("notes", notes),
        ("ask", ask),
        ("asked", asked),
        ("routine", routine),
        ("file", &file),
        ("inputs", &inputs),
        ("outputs", &outputs),
    ];
    filled(include_str!("abi/answer.f90"), &places)
}

/// Writes the driver of an interface to a folder, and beside it what routines of Abaqus include and call.
///
/// # Errors
/// If routines with this interface do not compute the formula, or a file cannot be written.
pub(crate) fn write(abi: Abi, formula: &dyn AnyFormula, folder: &Path) -> anyhow::Result<String> {
    write_text(&abi.interface().routine.to_lowercase(), &text(abi, formula)?, folder)
}

/// Writes a driver to a folder, and beside it what routines of Abaqus include and call.
///
/// # Errors
/// If a file cannot be written.
pub(in crate::check) fn write_text(routine: &str, text: &str, folder: &Path) -> anyhow::Result<String> {
    let driver = format!("{routine}_driver.f90");
    let all = [(driver.as_str(), text), ("jp_stubs.f90", STUBS), ("ABA_PARAM.INC", ABA_PARAM)];
    for (name, text) in all {
        files::write(&folder.join(name), text)?;
    }
    let names: Vec<_> = all.iter().map(|(name, _)| folder.join(name).display().to_string()).collect();
    Ok(names.join("\n") + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::ValueEnum;
    use jointproof::catalog::CATALOG;

    #[test]
    fn every_driver_is_complete() {
        for abi in Abi::value_variants() {
            for (id, _) in abi.interface().computes {
                let formula =
                    CATALOG.iter().find(|formula| formula.spec().id == *id).expect("a formula of the catalog");
                let text = text(*abi, *formula).unwrap();
                assert!(!text.contains(['{', '}']), "{id}:\n{text}");
                assert!(text.lines().all(|line| line.len() <= 132), "{id}:\n{text}");
            }
        }
    }
}
