//! The registered kinks: which hold at a point, and what jumps on them.

use super::jump::{Neighbourhood, Rank};
use crate::Octuple;
use crate::equation::{Claims, Setting, Signature};
use crate::verify::claim::{Claim, Deviation};
use crate::verify::point::Names;
use crate::verify::{Kink, Subject, exact, golden};
use num_traits::Signed;
use std::cell::OnceCell;

/// A point that was solved for is on a kink to this part of the terms that its condition is made of.
const MET: f64 = 1e-50;
/// Beside it, by this part.
pub(super) const BESIDE: f64 = 1e-55;

/// Every input changed by this part of it.
pub(super) fn beside(at: &[Octuple], part: f64) -> Vec<Octuple> {
    at.iter().map(|&x| x + x * part).collect()
}

/// The registered kinks of a formula, to be asked of points that were solved for.
pub(super) struct Register<'a> {
    subject: &'a Subject,
    /// Their conditions as they are printed; `None` where they are in words.
    printed: OnceCell<Vec<Option<Claims>>>,
}

impl<'a> Register<'a> {
    pub(super) fn new(subject: &'a Subject) -> Self {
        Self { subject, printed: OnceCell::new() }
    }

    /// The conditions of the kinks on which a point is.
    pub(super) fn met(&self, at: &[Octuple]) -> Vec<String> {
        let printed = self.printed.get_or_init(|| self.read());
        // A cut is at π on one side and at −π on the other.
        let beside = [BESIDE, -BESIDE].map(|part| beside(at, part));
        let values = |at: &[Octuple]| [(self.subject.exact_value)(at), (self.subject.exact_jacobian)(at)];
        let places = [at, &beside[0], &beside[1]].map(|at| (at, values(at)));
        let is_near = |claims: &Claims| places.iter().any(|(at, values)| is_near(claims, at, values));
        let kinks = self.subject.kinks.iter().zip(printed);
        let met = kinks.filter(|(kink, printed)| (kink.holds)(at) || printed.as_ref().is_some_and(is_near));
        met.map(|(kink, _)| kink.condition.clone()).collect()
    }

    fn read(&self) -> Vec<Option<Claims>> {
        let Subject { spec, inputs, outputs, .. } = *self.subject;
        let setting = Setting { of: Some(Signature { spec, inputs, outputs }), is_deep: true, ..Setting::default() };
        self.subject.kinks.iter().map(|kink| Claims::read(&kink.condition, &setting).ok()).collect()
    }
}

/// Whether a printed condition holds but for the rounding of a point, at which the formula has these values.
fn is_near(claims: &Claims, at: &[Octuple], [values, jacobian]: &[Vec<Octuple>; 2]) -> bool {
    let point = claims.point(at, Some([values, jacobian]), &[]);
    let sizes: Vec<_> = point.iter().map(Signed::abs).collect();
    claims.at(&point).iter().all(|claim| {
        let terms = claims.terms(claim, &point, &sizes);
        if claim.is_equality { (claim.right - claim.left).abs() <= terms * MET } else { claim.holds }
    })
}

/// What jumps on a kink, and from where to where: the output and the input that show it best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// What jumps.
    pub rank: Rank,
    /// The place of the output's component.
    pub output: usize,
    /// The place of the input's component.
    pub input: usize,
    /// The value or derivative where the input is smaller, and where it is larger. Where it can be only one of them, on the
    /// kink and beside it. Infinite where it grows without bound.
    pub sides: [f64; 2],
}

/// Steps from the kink, in units of the size of the inputs: what grows without bound grows from one to the next.
const STEPS: [f64; 2] = [1e-30, 1e-36];
/// Numbers that differ by a larger part jump.
const JUMP: f64 = 1e-9;
/// What grows by more has no bound, and what shrinks by more tends to 0.
const GROWS: f64 = 10.0;

/// What jumps on a registered kink, at the point that it names; `None` where nothing does.
pub(crate) fn sides(subject: &Subject, kink: &Kink) -> Option<Sides> {
    let at = exact(&kink.at);
    let neighbourhood = Neighbourhood::new(subject, &at);
    let across: Vec<_> = (0..at.len()).filter(|&k| kink.across[k] != 0.0).collect();
    let others: Vec<_> = (0..at.len()).filter(|k| !across.contains(k)).collect();
    let ranks = [Rank::Value, Rank::Slope, Rank::Curvature];
    let tried = [across, others];
    let mut ways = tried.iter().flat_map(|inputs| ranks.map(|rank| (inputs, rank)));
    ways.find_map(|(inputs, rank)| {
        let found = inputs.iter().flat_map(|&input| jumps(&neighbourhood, rank, input));
        let most =
            found.fold((JUMP, None), |most, (size, sides)| if size > most.0 { (size, Some(sides)) } else { most });
        most.1
    })
}

/// Of every output, by how much it jumps with an input, relatively.
fn jumps(neighbourhood: &Neighbourhood<'_>, rank: Rank, input: usize) -> Vec<(f64, Sides)> {
    let (inner, edge) = neighbourhood.sides(&[input]);
    let signs = match (inner.first(), edge.first()) {
        (Some(_), _) => [-1.0, 1.0],
        (None, Some(&(_, sign))) => [0.0, sign],
        (None, None) => return Vec::new(),
    };
    // Of a derivative there is none on the kink itself, only beside it.
    let signs = if rank == Rank::Value { signs } else { signs.map(|sign| if sign == 0.0 { signs[1] } else { sign }) };
    let [near, nearer] = STEPS.map(|step| signs.map(|sign| neighbourhood.seen(rank, input, sign * step)));
    let of_output = |output: usize| {
        let side = |k: usize| limit(near[k][output], nearer[k][output]);
        let [below, above] = [side(0), side(1)];
        let size = if below == above { 0.0 } else { difference(below, above) };
        (size, Sides { rank, output, input, sides: [below, above] })
    };
    (0..near[0].len()).map(of_output).collect()
}

/// Of two numbers, relatively; 1 at least where one of them has no bound.
fn difference(a: f64, b: f64) -> f64 {
    if a.is_infinite() || b.is_infinite() { 1.0 } else { (a - b).abs() / (a.abs() + b.abs()) }
}

/// What numbers tend to that were seen near a kink and nearer to it.
fn limit(near: Octuple, nearer: Octuple) -> f64 {
    let growth = (nearer / near).abs();
    match growth {
        _ if growth > GROWS => f64::INFINITY.copysign(nearer.to_f64()),
        _ if growth < GROWS.recip() => 0.0,
        _ => nearer.to_f64(),
    }
}

/// On every registered kink something jumps; `None` where there is none.
pub(in crate::verify) fn register(subject: &Subject, names: &Names) -> Option<Claim> {
    let mut claim = Claim::new("on every registered kink something jumps: kinks on which nothing does", 0.0);
    for kink in &subject.kinks {
        let sides = sides(subject, kink);
        let finite = |x: f64| x.clamp(f64::MIN, f64::MAX);
        claim.record(f64::from(u8::from(sides.is_none())), 0.0, |size| Deviation {
            size,
            entry: sides
                .map_or("nothing jumps".into(), |sides| names.entry(sides.output * names.inputs.len() + sides.input)),
            point: format!("kink {}", kink.condition),
            found: sides.map_or(0.0, |sides| finite(sides.sides[1])),
            expected: sides.map_or(0.0, |sides| finite(sides.sides[0])),
            inputs: golden::named(subject.inputs, &kink.at).into(),
        });
    }
    (claim.checks > 0).then_some(claim)
}
