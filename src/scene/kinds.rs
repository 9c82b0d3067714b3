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
use Origin::{Before, Initial, Parameter};

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

/// What friction over increments is given, in every connector with a slot.
const STICK: [Given; 4] = [
    ("k_stick", Parameter(Required)),
    ("u1_before", Before("u1")),
    ("f_before", Before("csf")),
    ("slip_before", Before("slip_total")),
];
const MU: Given = ("mu", Parameter(Number(0.0)));
const FC_INT: Given = ("fc_int", Parameter(Number(0.0)));
const X0: Given = ("x0", Initial("x"));
const Y0: Given = ("y0", Initial("y"));
const Z0: Given = ("z0", Initial("z"));
const L1_REF: Given = ("l1_ref", Parameter(As("x0")));
const L1_MIN: Given = ("l1_min", Parameter(Required));
const L1_MAX: Given = ("l1_max", Parameter(Required));

/// Formulas of motion and friction along a slot, in every connector with one.
const MOTION: Use = always(&formulas::RelativeMotion);
const STOP: Use = always(&formulas::Stop);
const NORMAL: Use = always(&formulas::NormalForce);
const TRIAL: Use = always(&rules::Stick);
const RETURN_MAP: Use = renamed(&coulomb::ReturnMap, &[("f", "csf")]);
const SLIP: Use = always(&rules::Slip);
const CONSTRAINT_FORCE: Use = renamed(&formulas::ConstraintForce, &[("f", "rf")]);
const KINETIC_FORCE: Use = renamed(&formulas::KineticForce, &[("f", "kf")]);
