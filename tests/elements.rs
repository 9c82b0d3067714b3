//! Connectors as elements, as a solver calls them: what each refuses, and what it adds by rubbing.

use jointproof::connector::cardan::{Triads, rotation};
use jointproof::connector::slider;
use jointproof::connector::ujoint::Cross;
use jointproof::element::align;
use jointproof::element::newton::{
    AlignElement, CrossContact, Element, JoinElement, Nodes, SliderElement, SliderElement2d, SlotContact, SlotElement,
    SlotElement2d, TranslatorContact, TranslatorElement, UJointElement, UJointState, UniversalElement,
};
use jointproof::element::offset::Arms;
use jointproof::element::slot_plane::PlanePlaces;
use jointproof::element::translator_friction::{self, TranslatorSliding};
use jointproof::element::ujoint_friction::{self, CrossSliding};
use jointproof::formula::Formula;
use nalgebra::{SVector, Vector2, Vector3};

const START: Vector3<f64> = Vector3::new(0.125, 0.25, -0.5);
const RUBS: SlotContact = SlotContact { k_el: 1e3, fc_int: 1.0, mu: 0.25 };
const SLOT: SlotElement = SlotElement { start: START, contact: None };
const SLOT_2D: SlotElement2d = SlotElement2d { start: Vector2::new(0.25, -0.5), contact: None };
const TRANSLATOR: TranslatorElement = TranslatorElement { start: START, angles0: [0.4, 0.2, -0.6], contact: None };
const SLEEVE: TranslatorContact = TranslatorContact { k_el: 1e3, rr: 0.5, l: 2.0, fc_int: 1.0, mu: 0.25 };
const UJOINT: UJointElement = UJointElement { d0: START, c0: 0.0, angles0: [0.1, -0.2], contact: None };
const HINGES: CrossContact = CrossContact {
    cross: Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 1.0, mc3_int: -2.0 },
    k_el1: 1e3,
    k_el3: 500.0,
};
const AT_REST: UJointState<f64> = UJointState { turns: [0.0; 2], slip: [0.0; 2] };

/// Nodes, whose vectors have names.
trait Named: Copy {
    fn standing() -> Self;
    fn vectors(&mut self) -> Vec<(&'static str, &mut [f64])>;
}

impl Named for Nodes<f64> {
    fn standing() -> Self {
        let a = rotation(0.3, -0.5, 0.7);
        let b = a * rotation(0.4, 0.2, -0.6);
        let [a, b] = [a, b].map(|m| [0, 1, 2].map(|k| m.column(k).into_owned()));
        Self { a, b, xa: Vector3::new(1.0, 2.0, 3.0), xb: Vector3::new(2.5, 2.25, 4.0) }
    }
    fn vectors(&mut self) -> Vec<(&'static str, &mut [f64])> {
        let Self { a: [e1a, e2a, e3a], b: [e1b, e2b, e3b], xa, xb } = self;
        let names = ["e1a", "e2a", "e3a", "e1b", "e2b", "e3b", "xa", "xb"];
        names.into_iter().zip([e1a, e2a, e3a, e1b, e2b, e3b, xa, xb].map(Vector3::as_mut_slice)).collect()
    }
}

impl Named for PlanePlaces<f64> {
    fn standing() -> Self {
        Self { e2a: Vector2::new(-0.6, 0.8), xa: Vector2::new(1.0, 2.0), xb: Vector2::new(2.5, 2.25) }
    }
    fn vectors(&mut self) -> Vec<(&'static str, &mut [f64])> {
        let Self { e2a, xa, xb } = self;
        ["e2a", "xa", "xb"].into_iter().zip([e2a, xa, xb].map(Vector2::as_mut_slice)).collect()
    }
}

impl Named for slider::Nodes<f64> {
    fn standing() -> Self {
        let (x1, d) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(2.0, -1.0, 4.0));
        Self { x1, xn: x1 + d, xm: x1 + d * 0.25 }
    }
    fn vectors(&mut self) -> Vec<(&'static str, &mut [f64])> {
        let Self { x1, xn, xm } = self;
        ["x1", "xn", "xm"].into_iter().zip([x1, xn, xm].map(Vector3::as_mut_slice)).collect()
    }
}

impl Named for slider::Nodes2d<f64> {
    fn standing() -> Self {
        let slider::Nodes { x1, xn, xm } = Named::standing();
        Self { x1: x1.xy(), xn: xn.xy(), xm: xm.xy() }
    }
    fn vectors(&mut self) -> Vec<(&'static str, &mut [f64])> {
        let Self { x1, xn, xm } = self;
        ["x1", "xn", "xm"].into_iter().zip([x1, xn, xm].map(Vector2::as_mut_slice)).collect()
    }
}

/// What an element says against what it is given.
fn refusal<E: Element<N, DOFS>, const N: usize, const DOFS: usize>(
    element: &E,
    nodes: &E::Nodes<f64>,
    multipliers: [f64; N],
    before: &E::State<f64>,
) -> Option<String> {
    element.newton(nodes, &multipliers.into(), before).err().map(|error| error.to_string())
}

fn is_nan(name: &str) -> String {
    format!("{name} is NaN; allowed is a finite number")
}

/// Where an element does not refuse what it is to ask, each number of nodes and multipliers in turn, or refuses what it does not.
fn unasked<E, P: Named, const N: usize, const DOFS: usize>(
    element: &E,
    before: &E::State<f64>,
    places: &[&str],
    multipliers: [&str; N],
) -> Vec<String>
where
    E: Element<N, DOFS, Nodes<f64> = P> + std::fmt::Debug,
{
    let mut wrong = Vec::new();
    let mut compare = |found: Option<String>, expected: Option<String>| {
        if found != expected {
            wrong.push(format!("{element:?}: {found:?}, not {expected:?}"));
        }
    };
    let loads: [f64; N] = std::array::from_fn(|k| [3.0, -4.0, 2.0, -1.0, 0.5][k]);
    compare(refusal(element, &P::standing(), loads, before), None);
    let sizes = P::standing().vectors().iter().map(|(name, v)| (*name, v.len())).collect::<Vec<_>>();
    for (k, (name, size)) in sizes.into_iter().enumerate() {
        for component in 0..size {
            let mut nodes = P::standing();
            nodes.vectors()[k].1[component] = f64::NAN;
            let expected = places.contains(&name).then(|| is_nan(&format!("{name}[{component}]")));
            compare(refusal(element, &nodes, loads, before), expected);
        }
    }
    for (k, name) in multipliers.into_iter().enumerate() {
        let mut loads = loads;
        loads[k] = f64::NAN;
        compare(refusal(element, &P::standing(), loads, before), Some(is_nan(name)));
    }
    wrong
}

#[test]
fn every_element_asks_for_its_nodes_and_multipliers() {
    let (of_a, triads) = (["e1a", "e2a", "e3a", "xa", "xb"], ["e1a", "e2a", "e3a", "e1b", "e2b", "e3b"]);
    let all = [&triads[..], &["xa", "xb"]].concat();
    let (shafts, jointed) = (["e1a", "e3b"], [&of_a[..], &["e3b"]].concat());
    let (slot, of_translator) = (["f2", "f3"], ["f2", "f3", "lambda_r1", "lambda_r2", "lambda_r3"]);
    let of_ujoint = ["f1", "f2", "f3", "lambda_rot"];
    let wrong = [
        unasked(&JoinElement { d0: START }, &(), &of_a, ["f1", "f2", "f3"]),
        unasked(&AlignElement { angles0: [0.4, 0.2, -0.6] }, &(), &triads, ["lambda_r1", "lambda_r2", "lambda_r3"]),
        unasked(&UniversalElement { c0: 0.25 }, &(), &shafts, ["lambda_rot"]),
        unasked(&SLOT, &0.0, &of_a, slot),
        unasked(&SlotElement { contact: Some(RUBS), ..SLOT }, &0.0, &of_a, slot),
        unasked(&SLOT_2D, &0.0, &["e2a", "xa", "xb"], ["f2"]),
        unasked(&SlotElement2d { contact: Some(RUBS), ..SLOT_2D }, &0.0, &["e2a", "xa", "xb"], ["f2"]),
        unasked(&TRANSLATOR, &0.0, &all, of_translator),
        unasked(&TranslatorElement { contact: Some(SLEEVE), ..TRANSLATOR }, &0.0, &all, of_translator),
        unasked(&UJOINT, &AT_REST, &jointed, of_ujoint),
        unasked(&UJointElement { contact: Some(HINGES), ..UJOINT }, &AT_REST, &all, of_ujoint),
        unasked(&SliderElement, &(), &["x1", "xn", "xm"], ["lambda_1", "lambda_2"]),
        unasked(&SliderElement2d, &(), &["x1", "xn", "xm"], ["lambda"]),
    ]
    .concat();
    assert_eq!(wrong, [""; 0]);
}

/// What each element says of itself where a parameter is changed.
mod changed {
    use super::{
        AT_REST, AlignElement, CrossContact, HINGES, JoinElement, Named, RUBS, SLEEVE, SLOT, SLOT_2D, START,
        SlotContact, SlotElement, SlotElement2d, TRANSLATOR, TranslatorContact, TranslatorElement, UJOINT,
        UJointElement, refusal,
    };

    pub fn join(change: fn(&mut JoinElement)) -> Option<String> {
        let mut element = JoinElement { d0: START };
        change(&mut element);
        refusal(&element, &Named::standing(), [3.0; 3], &())
    }
    pub fn align(change: fn(&mut AlignElement)) -> Option<String> {
        let mut element = AlignElement { angles0: [0.4, 0.2, -0.6] };
        change(&mut element);
        refusal(&element, &Named::standing(), [3.0; 3], &())
    }
    pub fn slot(change: fn(&mut SlotElement, &mut SlotContact)) -> Option<String> {
        let (mut element, mut contact) = (SLOT, RUBS);
        change(&mut element, &mut contact);
        refusal(&SlotElement { contact: Some(contact), ..element }, &Named::standing(), [3.0; 2], &0.0)
    }
    pub fn slot_2d(change: fn(&mut SlotElement2d, &mut SlotContact)) -> Option<String> {
        let (mut element, mut contact) = (SLOT_2D, RUBS);
        change(&mut element, &mut contact);
        refusal(&SlotElement2d { contact: Some(contact), ..element }, &Named::standing(), [3.0], &0.0)
    }
    pub fn translator(change: fn(&mut TranslatorElement, &mut TranslatorContact)) -> Option<String> {
        let (mut element, mut contact) = (TRANSLATOR, SLEEVE);
        change(&mut element, &mut contact);
        refusal(&TranslatorElement { contact: Some(contact), ..element }, &Named::standing(), [3.0; 5], &0.0)
    }
    pub fn ujoint(change: fn(&mut UJointElement, &mut CrossContact)) -> Option<String> {
        let (mut element, mut contact) = (UJOINT, HINGES);
        change(&mut element, &mut contact);
        refusal(&UJointElement { contact: Some(contact), ..element }, &Named::standing(), [3.0; 4], &AT_REST)
    }
}

/// What of this is not refused in these words.
fn not_said<const N: usize>(cases: [(Option<String>, &str); N]) -> Vec<String> {
    let wrong = cases.into_iter().filter(|(found, expected)| found.as_deref() != Some(expected));
    wrong.map(|(found, expected)| format!("{found:?}, not {expected:?}")).collect()
}

#[test]
fn every_element_asks_for_its_parameters() {
    use changed::{align, join, slot, slot_2d, translator, ujoint};
    const NAN: f64 = f64::NAN;
    let universal = refusal(&UniversalElement { c0: NAN }, &Named::standing(), [3.0], &());
    let wrong = not_said([
        (join(|e| e.d0.x = NAN), "d0[0] is NaN; allowed is a finite number"),
        (join(|e| e.d0.y = NAN), "d0[1] is NaN; allowed is a finite number"),
        (join(|e| e.d0.z = NAN), "d0[2] is NaN; allowed is a finite number"),
        (align(|e| e.angles0[0] = NAN), "alpha0 is NaN; allowed is a finite number"),
        (align(|e| e.angles0[1] = NAN), "beta0 is NaN; allowed is a finite number"),
        (align(|e| e.angles0[2] = NAN), "gamma0 is NaN; allowed is a finite number"),
        (universal, "c0 is NaN; allowed is a finite number"),
        (slot(|e, _| e.start.x = NAN), "x0 is NaN; allowed is a finite number"),
        (slot(|e, _| e.start.y = NAN), "y0 is NaN; allowed is a finite number"),
        (slot(|e, _| e.start.z = NAN), "z0 is NaN; allowed is a finite number"),
        (slot(|_, c| c.k_el = 0.0), "k_el is 0.0; allowed is a finite number > 0"),
        (slot(|_, c| c.fc_int = NAN), "fc_int is NaN; allowed is a finite number"),
        (slot(|_, c| c.mu = -1.0), "mu is -1.0; allowed is a finite number ≥ 0"),
        (slot_2d(|e, _| e.start.x = NAN), "x0 is NaN; allowed is a finite number"),
        (slot_2d(|e, _| e.start.y = NAN), "y0 is NaN; allowed is a finite number"),
        (slot_2d(|_, c| c.k_el = 0.0), "k_el is 0.0; allowed is a finite number > 0"),
        (slot_2d(|_, c| c.fc_int = NAN), "fc_int is NaN; allowed is a finite number"),
        (slot_2d(|_, c| c.mu = -1.0), "mu is -1.0; allowed is a finite number ≥ 0"),
        (translator(|e, _| e.start.x = NAN), "x0 is NaN; allowed is a finite number"),
        (translator(|e, _| e.start.y = NAN), "y0 is NaN; allowed is a finite number"),
        (translator(|e, _| e.start.z = NAN), "z0 is NaN; allowed is a finite number"),
        (translator(|e, _| e.angles0[0] = NAN), "alpha0 is NaN; allowed is a finite number"),
        (translator(|e, _| e.angles0[1] = NAN), "beta0 is NaN; allowed is a finite number"),
        (translator(|e, _| e.angles0[2] = NAN), "gamma0 is NaN; allowed is a finite number"),
        (translator(|_, c| c.k_el = 0.0), "k_el is 0.0; allowed is a finite number > 0"),
        (translator(|_, c| c.rr = -1.0), "rr is -1.0; allowed is a finite number ≥ 0"),
        (translator(|_, c| c.l = -1.0), "l is -1.0; allowed is a finite number ≥ 0"),
        (translator(|_, c| c.fc_int = NAN), "fc_int is NaN; allowed is a finite number"),
        (translator(|_, c| c.mu = -1.0), "mu is -1.0; allowed is a finite number ≥ 0"),
        (ujoint(|e, _| e.d0.x = NAN), "d0[0] is NaN; allowed is a finite number"),
        (ujoint(|e, _| e.d0.y = NAN), "d0[1] is NaN; allowed is a finite number"),
        (ujoint(|e, _| e.d0.z = NAN), "d0[2] is NaN; allowed is a finite number"),
        (ujoint(|e, _| e.c0 = NAN), "c0 is NaN; allowed is a finite number"),
        (ujoint(|e, _| e.angles0[0] = NAN), "alpha0 is NaN; allowed is a finite number"),
        (ujoint(|e, _| e.angles0[1] = NAN), "gamma0 is NaN; allowed is a finite number"),
        (ujoint(|_, c| c.k_el1 = 0.0), "k_el1 is 0.0; allowed is a finite number > 0"),
        (ujoint(|_, c| c.k_el3 = 0.0), "k_el3 is 0.0; allowed is a finite number > 0"),
        (ujoint(|_, c| c.cross.rp = 0.0), "rp is 0.0; allowed is a finite number > 0"),
        (ujoint(|_, c| c.cross.la = 0.0), "la is 0.0; allowed is a finite number > 0"),
        (ujoint(|_, c| c.cross.ra = -1.0), "ra is -1.0; allowed is a finite number ≥ 0"),
        (ujoint(|_, c| c.cross.ls = -1.0), "ls is -1.0; allowed is a finite number ≥ 0"),
        (ujoint(|_, c| c.cross.mu = -1.0), "mu is -1.0; allowed is a finite number ≥ 0"),
        (ujoint(|_, c| c.cross.mc1_int = NAN), "mc1_int is NaN; allowed is a finite number"),
        (ujoint(|_, c| c.cross.mc3_int = NAN), "mc3_int is NaN; allowed is a finite number"),
    ]);
    assert_eq!(wrong, [""; 0]);
    let smooth = UJointElement { angles0: [NAN; 2], ..UJOINT };
    assert_eq!(
        refusal(&smooth, &Named::standing(), [3.0; 4], &AT_REST),
        None,
        "without friction nobody needs its angles"
    );
}

/// What nobody reads may be anything.
#[test]
fn an_element_that_rubs_asks_for_what_it_remembers() {
    let slot = |contact| refusal(&SlotElement { contact, ..SLOT }, &Named::standing(), [3.0; 2], &f64::NAN);
    let slot_2d = |contact| refusal(&SlotElement2d { contact, ..SLOT_2D }, &Named::standing(), [3.0], &f64::NAN);
    let translator =
        |contact| refusal(&TranslatorElement { contact, ..TRANSLATOR }, &Named::standing(), [3.0; 5], &f64::NAN);
    let slipped = Some(is_nan("slip_before"));
    assert_eq!([slot(Some(RUBS)), slot_2d(Some(RUBS)), translator(Some(SLEEVE))], [(); 3].map(|()| slipped.clone()));
    assert_eq!([slot(None), slot_2d(None), translator(None)], [const { None }; 3]);

    for (k, name) in ["turns[0]", "turns[1]", "slip1_before", "slip3_before"].into_iter().enumerate() {
        let mut numbers = [0.0; 4];
        numbers[k] = f64::NAN;
        let [turns, slip] = [[numbers[0], numbers[1]], [numbers[2], numbers[3]]];
        let ujoint = |contact| {
            let before = UJointState { turns, slip };
            refusal(&UJointElement { contact, ..UJOINT }, &Named::standing(), [3.0; 4], &before)
        };
        assert_eq!([ujoint(Some(HINGES)), ujoint(None)], [Some(is_nan(name)), None]);
    }
}

#[test]
fn nodes_are_refused_where_a_line_or_an_angle_is_not_defined() {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let locked = Nodes { a: [x, y, z], b: [y, z, x], xa: Vector3::zeros(), xb: x };
    let words =
        "alpha is undefined, since e2a·e3b = 0 and e3a·e3b = 0 (gimbal lock); allowed is at least one that is not 0";
    let mut in_space: slider::Nodes<f64> = Named::standing();
    in_space.xn = in_space.x1;
    let mut in_plane: slider::Nodes2d<f64> = Named::standing();
    in_plane.xn = in_plane.x1;
    let apart = "x1 and xn are 0.0 apart; allowed is a distance ≥ 2.2250738585072014e-308";
    let rubbing = UJointElement { contact: Some(HINGES), ..UJOINT };
    let wrong = not_said([
        (refusal(&AlignElement { angles0: [0.0; 3] }, &locked, [3.0; 3], &()), words),
        (refusal(&TRANSLATOR, &locked, [3.0; 5], &0.0), words),
        (refusal(&rubbing, &locked, [3.0; 4], &AT_REST), words),
        (refusal(&SliderElement, &in_space, [3.0; 2], &()), apart),
        (refusal(&SliderElement2d, &in_plane, [3.0], &()), apart),
    ]);
    assert_eq!(wrong, [""; 0]);
    assert_eq!(refusal(&UJOINT, &locked, [3.0; 4], &AT_REST), None, "without friction nobody needs an angle");
    assert_eq!(refusal(&UniversalElement { c0: 0.0 }, &locked, [3.0], &()), None);
}

#[test]
fn what_overflows_is_told() {
    let apart = Nodes { xb: Vector3::new(5.0, 0.0, 0.0), ..Named::standing() };
    let error = JoinElement { d0: START }.newton(&apart, &[1e308; 3].into(), &()).unwrap_err();
    assert_eq!(error.found(), "contribution is too large for a double");
}

#[test]
fn a_smooth_element_does_not_rub() {
    assert_eq!(SlotElement { contact: Some(RUBS), ..SLOT }.smooth(), SLOT);
    assert_eq!(SlotElement2d { contact: Some(RUBS), ..SLOT_2D }.smooth(), SLOT_2D);
    assert_eq!(TranslatorElement { contact: Some(SLEEVE), ..TRANSLATOR }.smooth(), TRANSLATOR);
    assert_eq!(UJointElement { contact: Some(HINGES), ..UJOINT }.smooth(), UJOINT);
}

/// Pressed against the slot by 40 it slips under a friction of 10, and a carries the moment of both about itself.
#[test]
fn slot_in_the_plane_rubs_against_the_motion() {
    let nodes = PlanePlaces { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(5.0, 0.5) };
    let contact = SlotContact { k_el: 100.0, fc_int: 0.0, mu: 0.25 };
    let slot = SlotElement2d { start: Vector2::new(1.0, 0.25), contact: Some(contact) };
    let (step, slip) = slot.newton(&nodes, &[40.0].into(), &3.0).unwrap();
    assert_eq!(step.residuals[0], 0.25);
    assert_eq!(step.forces, SVector::from([10.0, -40.0, -205.0, -10.0, 40.0, 0.0]));
    assert_eq!((step.by_multipliers[(3, 0)], step.by_multipliers[(4, 0)], step.rows[(0, 3)]), (-0.25, 1.0, 0.0));
    assert_eq!(slip, 3.9);
}

#[test]
fn translator_rubs_by_forces_and_moments_along_the_axes_of_a() {
    let nodes: Nodes<f64> = Named::standing();
    let multipliers = SVector::from([3.0, -4.0, 2.0, -1.0, 0.5]);
    let (smooth, held) = TRANSLATOR.newton(&nodes, &multipliers, &0.5).unwrap();
    assert_eq!(held, 0.5);
    let moment: Vector3<f64> = smooth.forces.fixed_rows::<3>(9).into_owned();
    let [m1, m2, m3] = nodes.a.map(|axis| axis.dot(&moment));
    let u1 = nodes.a[0].dot(&(nodes.xb - nodes.xa)) - START.x;
    for k_el in [0.125, 1e3] {
        let TranslatorContact { rr, l, fc_int, mu, .. } = SLEEVE;
        let element = TranslatorElement { contact: Some(TranslatorContact { k_el, ..SLEEVE }), ..TRANSLATOR };
        let (found, slip) = element.newton(&nodes, &multipliers, &0.5).unwrap();
        let (slip_before, f2, f3) = (0.5, 3.0, -4.0);
        let expected = translator_friction::Response::eval(&TranslatorSliding {
            u1,
            slip_before,
            k_el,
            f2,
            f3,
            m1,
            m2,
            m3,
            rr,
            l,
            fc_int,
            mu,
        });
        assert!((slip - expected.slip).abs() < 1e-12, "{slip}: {expected:?}");
        let rubs = found.forces - smooth.forces;
        assert!((rubs.fixed_rows::<3>(6) + nodes.a[0] * expected.f1).amax() < 1e-12, "{rubs:?}");
        assert!((rubs.fixed_rows::<3>(0) - nodes.a[0] * expected.f1).amax() < 1e-12 && expected.f1.abs() > 0.01);
    }
}

#[test]
fn ujoint_rubs_about_both_axes_and_counts_whole_turns() {
    let nodes: Nodes<f64> = Named::standing();
    let (multipliers, before) =
        (SVector::from([3.0, -4.0, 12.0, 5.0]), UJointState { turns: [0.5, 6.0], slip: [0.25, 6.5] });
    let (smooth, held) = UJOINT.newton(&nodes, &multipliers, &before).unwrap();
    assert_eq!(held, before);
    // It stands at 0.4, 0.2 and −0.6, and began at 0.1 and −0.2.
    let turns = [0.3, std::f64::consts::TAU - 0.4];
    let ([e1a, e2a, e3a], [e1b, e2b, e3b]) = (nodes.a, nodes.b);
    let rows = align::Rows::eval(&Triads { e1a, e2a, e3a, e1b, e2b, e3b });
    for [k_el1, k_el3] in [[0.125, 0.25], [1e3, 0.25], [0.125, 1e3]] {
        let element = UJointElement { contact: Some(CrossContact { k_el1, k_el3, ..HINGES }), ..UJOINT };
        let (found, after) = element.newton(&nodes, &multipliers, &before).unwrap();
        let Cross { rp, la, ra, ls, mu, mc1_int, mc3_int } = HINGES.cross;
        let ([ur1, ur3], [slip1_before, slip3_before]) = (turns, before.slip);
        let ([f1, f2, f3], m2) = ([3.0, -4.0, 12.0], 5.0 * 0.2_f64.cos());
        let expected = ujoint_friction::Response::eval(&CrossSliding {
            ur1,
            ur3,
            slip1_before,
            slip3_before,
            k_el1,
            k_el3,
            e1a,
            e2a,
            e3a,
            e3b,
            f1,
            f2,
            f3,
            m2,
            rp,
            la,
            ra,
            ls,
            mc1_int,
            mc3_int,
            mu,
        });
        let off = [
            after.turns[0] - ur1,
            after.turns[1] - ur3,
            after.slip[0] - expected.slip1,
            after.slip[1] - expected.slip3,
        ];
        assert!(off.iter().all(|off| off.abs() < 1e-12), "{after:?}: {expected:?}");
        let (rubs, on_b) = (found.forces - smooth.forces, -(rows.ur1_tb * expected.m1 + rows.ur3_tb * expected.m3));
        assert!((rubs.fixed_rows::<3>(9) - on_b).amax() < 1e-12 && (rubs.fixed_rows::<3>(3) + on_b).amax() < 1e-12);
        assert_eq!((rubs.fixed_rows::<3>(0).amax(), rubs.fixed_rows::<3>(6).amax()), (0.0, 0.0));
    }
}

/// Forces, and what follows the multipliers, have the moments of their arms; stick and slip differ in what follows them.
#[test]
fn on_arms_forces_and_what_follows_multipliers_have_moments() {
    let arms = Arms { a: Vector3::new(0.5, -1.0, 2.0), b: Vector3::new(-3.0, 0.25, 1.0) };
    let slot = SlotElement { contact: Some(RUBS), ..SLOT };
    let (at_points, _) = slot.newton(&Named::standing(), &[3.0, -4.0].into(), &0.5).unwrap();
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
