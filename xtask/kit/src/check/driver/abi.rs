//! Drivers for routines whose interface is prescribed by a finite-element program.
//!
//! Every driver is one program, `answer.f90`, that contains the call of the interface: a template consists of notes
//! for its head, a line `---`, and a subroutine that computes values and derivatives at a point.

use crate::outcome::Usage;
use jointproof::catalog::AnyFormula;
use jointproof::connector::slider;
use jointproof::contact::{coulomb, interaction};
use jointproof::formula::Formula;
use judge::sizes;

/// An interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Abi {
    /// A friction model of Abaqus: FRIC
    Fric,
    /// A multi-point constraint of Abaqus, in degree of freedom mode: MPC
    Mpc,
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

const PLANE: Places = &[("dim", "2"), ("_2d", "_2d"), ("multipliers", "the multiplier")];
const SPACE: Places = &[("dim", "3"), ("_2d", ""), ("multipliers", "both multipliers")];

/// The quantities computed by an element.
const FORCES: Places = &[("multiplier", "x(moving + 1:)"), ("rows", "1:moving")];
const DISTANCES: Places = &[("multiplier", "1"), ("rows", "moving + 1:ndofel")];

/// The properties of an interaction, and the quantities it computes.
const LINEAR: Places = &[
    ("props", "the stiffness of the pressure, that of friction while it sticks, and the friction coefficient"),
    ("nprops", "3"),
];
const EXPONENTIAL: Places =
    &[("props", "the clearance at which the pressure is 0, and the pressure at touch"), ("nprops", "2")];
const PRESSURE: Places =
    &[("ndir", "2"), ("get", "y(1) = stress(1)\njacobian(1, 1) = ddsddr(1, 1)\nis_known(1, 2:) = .false.")];
const FRICTION: Places = &[
    ("ndir", "outputs + 1"),
    ("set", "rdisp = [x(inputs), x(1:outputs)]\nprops = [1.0_dp, 1.0_dp, x(outputs + 1)]"),
    (
        "get",
        "y = stress(2:)\njacobian(:, 1:outputs) = ddsddr(2:, 2:)\nis_known(:, outputs + 1) = .false.\n\
         jacobian(:, inputs) = ddsddr(2:, 1)\n! Where surfaces only touch, the pressure has a kink of its own.\n\
         is_known(:, inputs) = x(inputs) > 0",
    ),
];

/// The equations of a line, each of which is a routine.
const ONE_EQUATION: Places = &[
    ("second", ""),
    ("externals", "umpc_user"),
    ("calls", "call umpc_user(x0, u, f, a, jdof, n, force, iit, idiscon)"),
];
const TWO_EQUATIONS: Places = &[
    ("second", " The second of both equations is that of a routine umpc_user_2."),
    ("externals", "umpc_user, umpc_user_2"),
    (
        "calls",
        "if (equation == 1) call umpc_user(x0, u, f, a, jdof, n, force, iit, idiscon)\n\
         if (equation == 2) call umpc_user_2(x0, u, f, a, jdof, n, force, iit, idiscon)",
    ),
];

impl Abi {
    fn interface(self) -> Interface {
        match self {
            Self::Fric => Interface {
                routine: "FRIC",
                template: include_str!("abi/fric.f90"),
                computes: &[(coulomb::ReturnMap::SPEC.id, &[]), (coulomb::ReturnMap2d::SPEC.id, &[])],
            },
            Self::Mpc => Interface {
                routine: "MPC",
                template: include_str!("abi/mpc.f90"),
                computes: &[(slider::Eliminate::SPEC.id, &[SPACE]), (slider::Eliminate2d::SPEC.id, &[PLANE])],
            },
            Self::Uinter => Interface {
                routine: "UINTER",
                template: include_str!("abi/uinter.f90"),
                computes: &[
                    (coulomb::ReturnMap::SPEC.id, &[LINEAR, FRICTION]),
                    (coulomb::ReturnMap2d::SPEC.id, &[LINEAR, FRICTION]),
                    (
                        interaction::PressureLinear::SPEC.id,
                        &[LINEAR, PRESSURE, &[("set", "rdisp = [x(1), 0.0_dp]\nprops = [x(2), 1.0_dp, 0.5_dp]")]],
                    ),
                    (
                        interaction::PressureExponential::SPEC.id,
                        &[EXPONENTIAL, PRESSURE, &[("set", "rdisp = [x(1), 0.0_dp]\nprops = x(2:)")]],
                    ),
                ],
            },
            Self::Uel => Interface {
                routine: "UEL",
                template: include_str!("abi/uel.f90"),
                computes: &[
                    (slider::rows::Forces::SPEC.id, &[FORCES, SPACE]),
                    (slider::rows_plane::Forces::SPEC.id, &[FORCES, PLANE]),
                    (slider::Constraint::SPEC.id, &[DISTANCES, SPACE]),
                    (slider::Constraint2d::SPEC.id, &[DISTANCES, PLANE]),
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
    let (notes, ask) = template.split_once("\n---\n").expect("a template has notes and a subroutine");
    let [inputs, outputs] = sizes(formula).map(|size| size.to_string());
    let file = routine.to_lowercase() + ".f";
    let own = [("notes", notes), ("ask", ask), ("id", id), ("routine", routine), ("file", &file)];
    let sizes = [("inputs", inputs.as_str()), ("outputs", outputs.as_str())];
    let filled_in = own.iter().chain(&sizes).chain(places.iter().copied().flatten());
    Ok(filled_in.fold(include_str!("abi/answer.f90").to_owned(), |text, (name, what)| filled(&text, name, what)))
}

/// A template with `{name}` replaced by a text, whose lines are indented like the first.
fn filled(template: &str, name: &str, what: &str) -> String {
    let hole = format!("{{{name}}}");
    let line = |line: &str| match line.split_once(&hole) {
        Some((indent, "\n")) if indent.trim().is_empty() => {
            what.lines().flat_map(|line| [indent, line, "\n"]).collect()
        }
        _ => line.replace(&hole, what),
    };
    template.split_inclusive('\n').map(line).collect()
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
