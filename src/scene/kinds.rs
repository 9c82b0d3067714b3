//! The tables of the kinds: a room each, and here what several of them have.

mod slide_line;
mod slider;
mod slot;
mod translator;
mod ujoint;

use super::kind::{Fallback, Kind, Origin, Use, always, renamed};
use super::rules;
use crate::{coulomb, slot as formulas};
use Fallback::{As, Number, Required};
use Origin::{Axis, Before, Initial, Load, Parameter, Position};

/// Every kind of element.
pub(super) static KINDS: &[Kind] = &[
    slot::SLOT,
    slot::SLOT_2D,
    translator::TRANSLATOR,
    ujoint::UJOINT,
    slider::SLIDER,
    slider::SLIDER_2D,
    slide_line::ISL21A,
    slide_line::ISL22A,
];

type Given = (&'static str, Origin);

/// Two nodes, and the triad of the first, in every connector.
const NODES: &[Given] =
    &[("xa", Position(0)), ("xb", Position(1)), ("e1a", Axis(0, 0)), ("e2a", Axis(0, 1)), ("e3a", Axis(0, 2))];
/// The triad of the second, where angles are measured.
const SECOND_TRIAD: &[Given] = &[("e1b", Axis(1, 0)), ("e2b", Axis(1, 1)), ("e3b", Axis(1, 2))];
const FORCES: &[Given] = &[("f1", Load), ("f2", Load), ("f3", Load)];
const MOMENTS: &[Given] = &[("m1", Load), ("m2", Load), ("m3", Load)];

/// What motion and friction along a slot are given, in every connector with one; friction goes over increments.
const INITIAL: &[Given] = &[("x0", Initial("x")), ("y0", Initial("y")), ("z0", Initial("z"))];
const LENGTHS: &[Given] =
    &[("l1_ref", Parameter(As("x0"))), ("l1_min", Parameter(Required)), ("l1_max", Parameter(Required))];
const FRICTION: &[Given] = &[
    ("mu", Parameter(Number(0.0))),
    ("fc_int", Parameter(Number(0.0))),
    ("k_stick", Parameter(Required)),
    ("u1_before", Before("u1")),
    ("f_before", Before("csf")),
    ("slip_before", Before("slip_total")),
];

/// Formulas of motion and friction along a slot, in every connector with one.
const MOTION: Use = always(&formulas::RelativeMotion);
const STOP: Use = always(&formulas::Stop);
const NORMAL: Use = always(&formulas::NormalForce);
const TRIAL: Use = always(&rules::Stick);
const RETURN_MAP: Use = renamed(&coulomb::ReturnMap, &[("f", "csf")]);
const SLIP: Use = always(&rules::Slip);
const CONSTRAINT_FORCE: Use = renamed(&formulas::ConstraintForce, &[("f", "rf")]);
const KINETIC_FORCE: Use = renamed(&formulas::KineticForce, &[("f", "kf")]);
