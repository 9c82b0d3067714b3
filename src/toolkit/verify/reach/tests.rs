use super::*;
use crate::catalog::find;
use crate::connector::slot::{Constraint2d, RelativePosition};
use crate::contact::coulomb::ReturnMap;
use crate::fields;
use crate::formula::proof::Proved;
use crate::formula::quantity::{E1A, E2A, E2B, F2, FORCE_1_PLANE, FORCE_M_PLANE, MU, SLIDER_N, XA};
use crate::formula::{Component, Document, Formula, Jacobian, Spec, typed};
use crate::number::scalar::Scalar;
use nalgebra::{Vector2, Vector3};

fields! { struct Pair<T> { v: Vector2<T> = FORCE_M_PLANE, w: Vector2<T> = FORCE_1_PLANE } }
fields! { struct Number<T> { s: T = F2 } }

/// The first component, and twice as much at special places.
#[derive(Clone, Copy)]
struct Special<const WHERE: usize>;

fn is_special<const WHERE: usize, D: Scalar>(&Pair { v, w }: &Pair<D>) -> bool {
    match WHERE {
        0 => v.x == 0.0 && v.y == 0.0,
        1 => v.x < 0.0 && v.y < 0.0,
        2 => v.x > 1e6 && v.y > 1e6,
        3 => v.x < 1e-6 && v.y < 1e-6 && v.x > 0.0,
        4 => w.x == v.x && w.y == v.y,
        5 => w.x == -v.x && w.y == -v.y,
        6 => v.x < 1e-30 && w.y < 1e-30 && w.y > 1e-60,
        7 => v.x > 1e30 && w.y > 1e30 && w.y < 1e60,
        8 => w.x < 1e-60 && v.y < 1e-60 && v.y > 0.0,
        9 => w.x > 1e60 && v.y > 1e60,
        10 => v.y == 0.0,
        11 => w.x < 0.0 && w.y > 0.0,
        // So flat that no Newton step leads to it.
        13 => v.x * v.x * v.x * v.x * v.x < 1e-100 && w.x + w.y * 2.0 > 40.0,
        _ => v.x + v.y * 2.0 > 40.0,
    }
}

impl<const WHERE: usize> Formula for Special<WHERE> {
    const SPEC: Spec = Spec::new("planted.special", "Special places", Document::new("None").printed(""));
    type Inputs<T: Component> = Pair<T>;
    type Outputs<T: Component> = Number<T>;
    fn eval<D: Scalar>(i: &Pair<D>) -> Number<D> {
        Number { s: if is_special::<WHERE, D>(i) { i.v.x * 2.0 } else { i.v.x } }
    }
    fn jacobian<D: Scalar>(i: &Pair<D>) -> Jacobian<Self, D> {
        let (zero, one) = (Vector2::new(D::zero(), D::zero()), D::one());
        let slope = if is_special::<WHERE, D>(i) { one * 2.0 } else { one };
        Number { s: Pair { v: Vector2::new(slope, D::zero()), w: zero } }
    }
}
impl<const WHERE: usize> Proved for Special<WHERE> {}

const START: [f64; 4] = [3.0, 5.0, 7.0, 11.0];

/// What a search that has entered the start finds.
fn found_by<F: Proved>(from: &[f64], how: impl Fn(&mut Search)) -> Vec<Reached> {
    let subject = Subject::of::<F>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let mut search = Search::new(&subject, &branches);
    assert!(search.enter(from).is_some());
    how(&mut search);
    search.found
}

#[test]
fn inputs_become_special_in_every_way() {
    fn assert_leads_to<const WHERE: usize>(expected: [f64; 4]) {
        let found = found_by::<Special<WHERE>>(&START, |search| search.specialise(&START));
        let there = |reached: &&Reached| is_special::<WHERE, f64>(&typed(&reached.inputs));
        let Some(Reached { inputs, answer, .. }) = found.iter().find(there) else { panic!("{WHERE} is not found") };
        let is_close = |(x, expected): (&f64, f64)| (x - expected).abs() <= 1e-12 * expected.abs();
        assert!(*answer && inputs.iter().zip(expected).all(is_close), "{WHERE}: {inputs:?} is not {expected:?}");
    }
    assert_leads_to::<0>([0.0, 0.0, 7.0, 11.0]);
    assert_leads_to::<1>([-3.0, -5.0, 7.0, 11.0]);
    assert_leads_to::<2>([3e9, 5e9, 7.0, 11.0]);
    assert_leads_to::<3>([3e-9, 5e-9, 7.0, 11.0]);
    assert_leads_to::<4>([3.0, 5.0, 3.0, 5.0]);
    assert_leads_to::<5>([3.0, 5.0, -3.0, -5.0]);
    assert_leads_to::<6>([3e-40, 5e-40, 7e-40, 11e-40]);
    assert_leads_to::<7>([3e40, 5e40, 7e40, 11e40]);
    assert_leads_to::<8>([3e-90, 5e-90, 7e-90, 11e-90]);
    assert_leads_to::<9>([3e90, 5e90, 7e90, 11e90]);
    assert_leads_to::<10>([3.0, 0.0, 7.0, 11.0]);
    assert_leads_to::<11>([3.0, 5.0, -7.0, 11.0]);
}

/// The plane is at a distance of 27/√5 along (1, 2)/√5; a step twice as long ends at the same distance beyond it.
#[test]
fn a_step_crosses_where_the_numbers_are_equal() {
    let found = found_by::<Special<12>>(&START, |search| search.towards(0, START.to_vec(), 2.0));
    let [x, y, rest @ ..] = &found[0].inputs[..] else { panic!("there are four") };
    assert!((x - 13.8).abs() < 1e-12 && (y - 26.6).abs() < 1e-12 && rest == [7.0, 11.0], "{x} {y} {rest:?}");
    assert!(found[0].answer && found.len() == 1);
    // From either side to the other.
    for (from, answer) in [(START, true), ([30.0, 30.0, 7.0, 11.0], false)] {
        let found = found_by::<Special<12>>(&from, |search| {
            search.cross();
        });
        assert_eq!(found.iter().map(|reached| reached.answer).collect::<Vec<_>>(), [answer]);
    }
}

#[test]
fn a_search_ends_with_every_side() {
    let subject = Subject::of::<Special<5>>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let found = reach(&subject, &branches, &[&START]);
    let sides: Vec<_> = found.iter().map(|reached| (reached.comparison, reached.answer)).collect();
    let [first, second] = branches.comparisons[..] else { panic!("there are two") };
    // The second comparison is evaluated only if the first is true.
    assert!(sides.contains(&(second, true)) && !sides.contains(&(first, false)), "{sides:?}");
    assert!(sides.len() == 2 || sides.len() == 3, "{sides:?}");
}

/// Special inputs lead to branches that Newton's method then crosses in the next round.
#[test]
fn a_search_goes_on_while_it_finds_something() {
    let subject = Subject::of::<Special<13>>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let found = reach(&subject, &branches, &[&START]);
    let sides: Vec<_> = found.iter().map(|reached| (reached.comparison, reached.answer)).collect();
    let [first, second] = branches.comparisons[..] else { panic!("there are two") };
    assert_eq!(sides, [(first, true), (second, true)]);
    assert!(is_special::<13, f64>(&typed(&found[1].inputs)), "{:?}", found[1].inputs);
}

fields! { struct Turned<T> { e1a: Vector3<T> = E1A } }

/// Twice as much where the unit vector is far from the first axis.
#[derive(Clone, Copy)]
struct Tilted;
impl Formula for Tilted {
    const SPEC: Spec = Spec::new("planted.tilted", "Tilted", Document::new("None").printed(""));
    type Inputs<T: Component> = Turned<T>;
    type Outputs<T: Component> = Number<T>;
    fn eval<D: Scalar>(i: &Turned<D>) -> Number<D> {
        Number { s: if i.e1a.x < 0.5 { i.e1a.y * 2.0 } else { i.e1a.y } }
    }
    fn jacobian<D: Scalar>(i: &Turned<D>) -> Jacobian<Self, D> {
        let slope = if i.e1a.x < 0.5 { D::from(2.0) } else { D::one() };
        Number { s: Turned { e1a: Vector3::new(D::zero(), slope, D::zero()) } }
    }
}
impl Proved for Tilted {}

#[test]
fn unit_vectors_that_are_found_are_unit_vectors() {
    let start = [0.6, 0.8, 0.0];
    let ways = [
        found_by::<Tilted>(&start, |search| search.towards(0, start.to_vec(), 2.0)),
        found_by::<Tilted>(&start, |search| search.specialise(&start)),
    ];
    for found in ways {
        let [Reached { inputs, answer: true, .. }] = &found[..] else { panic!("there is one such side") };
        let length = inputs.iter().map(|x| x * x).sum::<f64>();
        assert!(inputs[0] < 0.5 && (length - 1.0).abs() < 1e-15, "{inputs:?}");
    }
}

#[test]
fn the_first_new_side_is_told_and_few_points_are_kept() {
    let subject = Subject::of::<Special<0>>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let mut search = Search::new(&subject, &branches);
    let (first, second) = (branches.comparisons[0], branches.comparisons[1]);
    assert_eq!(search.enter(&[0.0, 1.0, 1.0, 1.0]), Some((first, true)));
    assert_eq!(search.enter(&[0.0, 1.0, 1.0, 1.0]), None);
    assert_eq!(search.enter(&[0.0, 0.0, 1.0, 1.0]), Some((second, true)));
    for _ in 0..10 {
        search.enter(&START);
    }
    let kept = |search: &Search| search.starts.iter().map(|sides| sides.each_ref().map(Vec::len)).collect::<Vec<_>>();
    assert_eq!(kept(&search), [[STARTS, 3], [2, 1]]);
    assert_eq!(search.tally.0, [[10, 3], [2, 1]]);
}

#[test]
fn points_that_are_refused_or_overflow_are_not_kept() {
    let tie = |search: &mut Search| search.visit(&[3.0, -0.5, 4.0]);
    assert!(found_by::<ReturnMap>(&[1.0, 0.5, 4.0], tie).is_empty());
    let slip = found_by::<ReturnMap>(&[1.0, 0.5, 4.0], |search| search.visit(&[3.0, 0.5, 4.0]));
    assert_eq!((slip.len(), &*slip[0].inputs), (1, [3.0, 0.5, 4.0].as_slice()));
    let huge = |search: &mut Search| search.visit(&[1e308, 1e308, 7.0, 11.0]);
    assert!(found_by::<Special<2>>(&START, huge).is_empty());
}

#[test]
fn vectors_of_a_triad_are_made_perpendicular_in_order() {
    let subject = Subject::of::<RelativePosition>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let search = Search::new(&subject, &branches);
    let mut point = vec![2.0, 2.0, 0.0, 0.0, 3.0, 0.0, 1.0, 5.0, -7.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    search.make_perpendicular(&mut point);
    let half = 0.5_f64.sqrt();
    let expected = [half, half, 0.0, -half, half, 0.0, 0.0, 0.0, -1.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    assert!(point.iter().zip(expected).all(|(x, expected)| (x - expected).abs() < 1e-15), "{point:?}");
    let subject = Subject::of::<Constraint2d>();
    let branches = Branches::of(subject.graph().expect("it is recorded"));
    let mut point = vec![3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
    Search::new(&subject, &branches).make_perpendicular(&mut point);
    assert_eq!(point, [0.6, 0.8, 5.0, 6.0, 7.0, 8.0, 9.0]);
}

#[test]
fn the_vectors_of_a_node_are_one_triad() {
    let of = |id| triads(find(id).expect("it is there").inputs());
    assert_eq!(of("cardan.angles"), [[0..3, 3..6, 6..9], [9..12, 12..15, 15..18]]);
    let quantities = [&MU, &SLIDER_N, &E2B, &E1A, &XA, &SLIDER_N, &E2A];
    let fields = quantities.map(|quantity| Field::new("field", quantity));
    assert!(Field::ranges(&fields).eq([0..1, 1..4, 4..7, 7..10, 10..13, 13..16, 16..19]));
    // A direction forms a group of its own.
    let starts = triads(&fields).into_iter().map(|triad| triad.iter().map(|axis| axis.start).collect());
    assert_eq!(starts.collect::<Vec<Vec<_>>>(), [vec![1], vec![4], vec![7, 16], vec![13]]);
}
