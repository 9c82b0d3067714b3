//! Connectors as elements, as called by a solver: the inputs that each rejects, and the effects of friction.

use crate::common::golden_of_element;
use jointproof::catalog::ELEMENTS;
use jointproof::connector::align::{AlignElement, AlignStart};
use jointproof::connector::join::{JoinElement, JoinStart};
use jointproof::connector::slider::{self, SliderElement, SliderElement2d};
use jointproof::connector::slot::plane::PlanePlaces;
use jointproof::connector::slot::{SlotContact, SlotElement, SlotElement2d, SlotStart, SlotStart2d, SlotState};
use jointproof::connector::translator::{self, FrictionLoads, TranslatorContact, TranslatorElement, TranslatorStart};
use jointproof::connector::ujoint::{
    AllContactMoments, ContactMoments, Cross, JointLoads, NormalMoments, UJointContact, UJointElement, UJointStart,
    UJointState,
};
use jointproof::connector::universal::{UniversalElement, UniversalStart};
use jointproof::contact::coulomb::{Response, Sliding};
use jointproof::element::cardan::{Triads, rotation};
use jointproof::element::offset::Arms;
use jointproof::element::{Element, Nodes, Nothing, Parameters, angle};
use jointproof::formula::Formula;
use jointproof::toolkit::verify::golden::components;
use nalgebra::{SVector, Vector2, Vector3};

const START: SlotStart<f64> = SlotStart { x0: 0.125, y0: 0.25, z0: -0.5 };
const RUBS: SlotContact<f64> = SlotContact { k_stick: 1e3, fc_int: 1.0, mu: 0.25 };
const SLOT: Parameters<SlotElement, f64, 2> = Parameters { start: START, contact: None };
const SLOT_2D: Parameters<SlotElement2d, f64, 1, 6> =
    Parameters { start: SlotStart2d { x0: 0.25, y0: -0.5 }, contact: None };
const TRANSLATOR: Parameters<TranslatorElement, f64, 5> = Parameters {
    start: TranslatorStart { x0: 0.125, y0: 0.25, z0: -0.5, alpha0: 0.4, beta0: 0.2, gamma0: -0.6 },
    contact: None,
};
const SLEEVE: TranslatorContact<f64> = TranslatorContact { k_stick: 1e3, rr: 0.5, l: 2.0, fc_int: 1.0, mu: 0.25 };
const UJOINT: Parameters<UJointElement, f64, 4> = Parameters {
    start: UJointStart { d0: Vector3::new(0.125, 0.25, -0.5), c0: 0.0, alpha0: 0.1, gamma0: -0.2 },
    contact: None,
};
const CROSS: Cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 };
const HINGES: UJointContact<f64> = UJointContact::new(CROSS, [1e3, 500.0]);
const AT_REST: UJointState<f64> = UJointState { ur1: 0.0, ur3: 0.0, m1: 0.0, m3: 0.0 };
const NOTHING: Nothing<f64> = Nothing::new();
const BEFORE: SlotState<f64> = SlotState { u1: 0.5, f1: -0.25 };

fn standing() -> Nodes<f64> {
    let a = rotation(0.3, -0.5, 0.7);
    let triads = [a, a * rotation(0.4, 0.2, -0.6)].map(|m| [0, 1, 2].map(|k| m.column(k).into_owned()));
    Nodes::new(triads, [Vector3::new(1.0, 2.0, 3.0), Vector3::new(2.5, 2.25, 4.0)])
}

/// Each input in turn is NaN: the error names it.
#[test]
fn every_element_asks_for_all_that_it_computes_from() {
    let mut wrong = Vec::new();
    for element in ELEMENTS {
        let rubs = !element.layout().contact.is_empty();
        let fields = element.inputs(rubs);
        let file = golden_of_element(*element);
        let valid =
            file.cases.iter().find_map(|case| components(fields, &case.inputs).ok().filter(|_| case.error.is_none()));
        let valid = valid.expect("a case is valid");
        assert!(element.value(&valid, rubs).is_ok(), "{}", element.spec().id);
        let names = fields.iter().flat_map(|field| (0..field.len()).map(move |k| (field, k)));
        for (place, (field, k)) in names.enumerate() {
            let mut inputs = valid.clone();
            inputs[place] = f64::NAN;
            let found = element.value(&inputs, rubs).map(|_| ()).map_err(|error| error.to_string());
            let name =
                if field.len() > 1 { format!("{}[{k}] is NaN", field.name) } else { format!("{} is NaN", field.name) };
            if !found.as_ref().is_err_and(|error| error.starts_with(&name)) {
                wrong.push(format!("{}: {found:?}, not {name}", element.spec().id));
            }
        }
        assert!(element.value(&valid[1..], rubs).is_err(), "one is missing");
    }
    assert_eq!(wrong, [""; 0]);
}

/// The error of an element with these inputs.
fn refusal<E: Element<M, DOFS>, const M: usize, const DOFS: usize>(
    element: &Parameters<E, f64, M, DOFS>,
    nodes: &E::Nodes<f64>,
    multipliers: [f64; M],
    before: &E::State<f64>,
) -> Option<String> {
    element.newton(nodes, &multipliers.into(), before).err().map(|error| error.to_string())
}

/// The cases without the expected error.
fn not_said<const N: usize>(cases: [(Option<String>, &str); N]) -> Vec<String> {
    let wrong = cases.into_iter().filter(|(found, expected)| found.as_deref() != Some(expected));
    wrong.map(|(found, expected)| format!("{found:?}, not {expected:?}")).collect()
}

/// Inputs that are not read may be anything.
#[test]
fn without_friction_nobody_asks_for_what_it_needs() {
    const NAN: f64 = f64::NAN;
    let nowhere = SlotState { u1: NAN, f1: NAN };
    assert_eq!(refusal(&SLOT, &standing(), [3.0; 2], &nowhere), None);
    assert_eq!(refusal(&TRANSLATOR, &standing(), [3.0; 5], &nowhere), None);
    let turned = UJointState { ur1: NAN, ur3: NAN, m1: NAN, m3: NAN };
    assert_eq!(refusal(&UJOINT, &standing(), [3.0; 4], &turned), None);
}

#[test]
fn nodes_are_refused_where_a_line_or_an_angle_is_not_defined() {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let locked = Nodes::new([[x, y, z], [y, z, x]], [Vector3::zeros(), x]);
    let words = "alpha is undefined, since e2a·e3b = 0 and e3a·e3b = 0 (gimbal lock, beta = ±90°); allowed is at least one that is not 0";
    let (x1, xm) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.5, 1.75, 4.0));
    let (in_space, in_plane) =
        (slider::Nodes { x1, xn: x1, xm }, slider::Nodes2d { x1: x1.xy(), xn: x1.xy(), xm: xm.xy() });
    let align = Parameters::<AlignElement, f64, 3> {
        start: AlignStart { alpha0: 0.0, beta0: 0.0, gamma0: 0.0 },
        contact: None,
    };
    let universal = Parameters::<UniversalElement, f64, 1> { start: UniversalStart { c0: 0.0 }, contact: None };
    let (slider, slider_2d) = (
        Parameters::<SliderElement, f64, 2, 9> { start: NOTHING, contact: None },
        Parameters::<SliderElement2d, f64, 1, 6> { start: NOTHING, contact: None },
    );
    let apart = "x1 and xn are 0.0 apart; allowed is a distance ≥ 2.2250738585072014e-308";
    let rubbing = Parameters::<UJointElement, f64, 4> { contact: Some(HINGES), ..UJOINT };
    let wrong = not_said([
        (refusal(&align, &locked, [3.0; 3], &NOTHING), words),
        (refusal(&TRANSLATOR, &locked, [3.0; 5], &BEFORE), words),
        (refusal(&rubbing, &locked, [3.0; 4], &AT_REST), words),
        (refusal(&slider, &in_space, [3.0; 2], &NOTHING), apart),
        (refusal(&slider_2d, &in_plane, [3.0], &NOTHING), apart),
    ]);
    assert_eq!(wrong, [""; 0]);
    assert_eq!(refusal(&UJOINT, &locked, [3.0; 4], &AT_REST), None, "without friction nobody needs an angle");
    assert_eq!(refusal(&universal, &locked, [3.0], &NOTHING), None);
}

#[test]
fn what_overflows_is_told() {
    let apart = Nodes { xb: Vector3::new(5.0, 0.0, 0.0), ..standing() };
    let join = Parameters::<JoinElement, f64, 3> { start: JoinStart { d0: Vector3::zeros() }, contact: None };
    let error = join.newton(&apart, &[1e308; 3].into(), &NOTHING).unwrap_err();
    assert_eq!(error.found(), "contribution is too large for a double");
}

#[test]
fn a_smooth_element_does_not_rub() {
    assert_eq!(Parameters::<SlotElement, f64, 2> { contact: Some(RUBS), ..SLOT }.smooth(), SLOT);
    assert_eq!(Parameters::<SlotElement2d, f64, 1, 6> { contact: Some(RUBS), ..SLOT_2D }.smooth(), SLOT_2D);
    assert_eq!(Parameters::<TranslatorElement, f64, 5> { contact: Some(SLEEVE), ..TRANSLATOR }.smooth(), TRANSLATOR);
    assert_eq!(Parameters::<UJointElement, f64, 4> { contact: Some(HINGES), ..UJOINT }.smooth(), UJOINT);
}

/// Pressed against the slot by 40 it slips under a friction of 10, and a carries the moment of both about itself.
#[test]
fn slot_in_the_plane_rubs_against_the_motion() {
    let nodes = PlanePlaces { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(5.0, 0.5) };
    let contact = SlotContact { k_stick: 100.0, fc_int: 0.0, mu: 0.25 };
    let slot =
        Parameters::<SlotElement2d, f64, 1, 6> { start: SlotStart2d { x0: 1.0, y0: 0.25 }, contact: Some(contact) };
    let (step, after) = slot.newton(&nodes, &[40.0].into(), &SlotState { u1: 3.75, f1: 1.0 }).unwrap();
    assert_eq!(step.residuals[0], 0.25);
    assert_eq!(step.forces, SVector::from([10.0, -40.0, -205.0, -10.0, 40.0, 0.0]));
    assert_eq!((step.by_multipliers[(3, 0)], step.by_multipliers[(4, 0)], step.rows[(0, 3)]), (-0.25, 1.0, 0.0));
    assert_eq!(after, SlotState { u1: 4.0, f1: 10.0 });
}

#[test]
fn translator_rubs_by_forces_and_moments_along_the_axes_of_a() {
    let nodes = standing();
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]);
    let (smooth, held) = TRANSLATOR.newton(&nodes, &multipliers, &BEFORE).unwrap();
    assert_eq!(held, BEFORE);
    let moment: Vector3<f64> = smooth.forces.fixed_rows::<3>(9).into_owned();
    let [m1, m2, m3] = nodes.a().map(|axis| axis.dot(&moment));
    let u1 = nodes.e1a.dot(&(nodes.xb - nodes.xa)) - START.x0;
    for k_stick in [0.125, 1e3] {
        let TranslatorContact { rr, l, fc_int, mu, .. } = SLEEVE;
        let element = Parameters::<TranslatorElement, f64, 5> {
            contact: Some(TranslatorContact { k_stick, ..SLEEVE }),
            ..TRANSLATOR
        };
        let (found, after) = element.newton(&nodes, &multipliers, &BEFORE).unwrap();
        let loads = FrictionLoads { f1: 0.0, f2: 3.0, f3: -4.0, m1, m2, m3, rr, l, fc_int, mu };
        let r#fn = translator::Friction::eval(&loads).r#fn;
        let increment = Sliding { du: u1 - BEFORE.u1, f_before: BEFORE.f1, k_stick, mu, r#fn };
        let expected = Response::eval(&increment).f;
        assert!((after.f1 - expected).abs() < 1e-12 && (after.u1 - u1).abs() < 1e-12, "{after:?}: {expected}");
        let rubs = found.forces - smooth.forces;
        assert!((rubs.fixed_rows::<3>(6) + nodes.e1a * expected).amax() < 1e-12, "{rubs:?}");
        assert!((rubs.fixed_rows::<3>(0) - nodes.e1a * expected).amax() < 1e-12 && expected.abs() > 0.01);
    }
}

#[test]
fn ujoint_rubs_about_both_axes_and_counts_whole_turns() {
    let nodes = standing();
    let (multipliers, before) =
        (SVector::from([3.0, -4.0, 12.0, 5.0]), UJointState { ur1: 0.5, ur3: 6.0, m1: 0.25, m3: -0.5 });
    let (smooth, held) = UJOINT.newton(&nodes, &multipliers, &before).unwrap();
    assert_eq!(held, before);
    // The angles are 0.4, 0.2 and −0.6, and began at 0.1 and −0.2.
    let turns = [0.3, std::f64::consts::TAU - 0.4];
    let Nodes { e1a, e2a, e3a, e1b, e2b, e3b, .. } = nodes;
    let rows = angle::Rows::eval(&Triads { e1a, e2a, e3a, e1b, e2b, e3b });
    for [k_stick1, k_stick3] in [[0.125, 0.25], [1e3, 0.25], [0.125, 1e3]] {
        let element = Parameters::<UJointElement, f64, 4> {
            contact: Some(UJointContact { k_stick1, k_stick3, ..HINGES }),
            ..UJOINT
        };
        let (found, after) = element.newton(&nodes, &multipliers, &before).unwrap();
        let Cross { rp, la, ra, ls, mu, mc1_int, mc3_int } = CROSS;
        let ([f1, f2, f3], m2) = ([3.0, -4.0, 12.0], 5.0 * 0.2_f64.cos());
        let loads = JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls };
        let contact = ContactMoments::eval(&loads);
        let normal = NormalMoments::eval(&AllContactMoments { mc1: contact.mc1, mc3: contact.mc3, mc1_int, mc3_int });
        let about = |du, f_before, k_stick, r#fn| Response::eval(&Sliding { du, f_before, k_stick, mu, r#fn }).f;
        let [ur1, ur3] = turns;
        let m1 = about(ur1 - before.ur1, before.m1, k_stick1, normal.mn1);
        let m3 = about(ur3 - before.ur3, before.m3, k_stick3, normal.mn3);
        let off = [after.ur1 - ur1, after.ur3 - ur3, after.m1 - m1, after.m3 - m3];
        assert!(off.iter().all(|off| off.abs() < 1e-12), "{after:?}: {m1}, {m3}");
        let (rubs, on_b) = (found.forces - smooth.forces, -(rows.ur1_tb * m1 + rows.ur3_tb * m3));
        assert!((rubs.fixed_rows::<3>(9) - on_b).amax() < 1e-12 && (rubs.fixed_rows::<3>(3) + on_b).amax() < 1e-12);
        assert_eq!((rubs.fixed_rows::<3>(0).amax(), rubs.fixed_rows::<3>(6).amax()), (0.0, 0.0));
    }
}

/// Forces and their derivatives with respect to the multipliers have the moments of their arms; stick and slip differ in these
/// derivatives.
#[test]
fn on_arms_forces_and_what_follows_multipliers_have_moments() {
    let arms = Arms { a: Vector3::new(0.5, -1.0, 2.0), b: Vector3::new(-3.0, 0.25, 1.0) };
    let slot = Parameters::<SlotElement, f64, 2> { contact: Some(RUBS), ..SLOT };
    let (at_points, _) = slot.newton(&standing(), &[3.0, -4.0].into(), &BEFORE).unwrap();
    let on_arms = at_points.on_arms(&arms);
    assert_ne!(at_points.by_multipliers, at_points.rows.transpose(), "it slips");
    assert_eq!(on_arms.residuals, at_points.residuals);
    let moved = |actions: SVector<f64, 12>| {
        let mut actions = actions;
        for (node, arm) in [(0, arms.a), (6, arms.b)] {
            let moment = arm.cross(&actions.fixed_rows::<3>(node));
            let mut spin = actions.fixed_rows_mut::<3>(node + 3);
            spin += moment;
        }
        actions
    };
    assert_eq!(on_arms.forces, moved(at_points.forces));
    for k in 0..2 {
        assert_eq!(on_arms.by_multipliers.column(k), moved(at_points.by_multipliers.column(k).into_owned()));
        let row = moved(at_points.rows.row(k).transpose());
        assert_eq!(on_arms.rows.row(k).transpose(), row);
    }
}
