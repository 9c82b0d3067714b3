//! Points in branches that neither named nor random points take.
//!
//! There are two methods. From a point in the other branch, Newton's method leads to where the compared numbers are
//! equal, and slightly beyond. And inputs are made special: zero, opposite, equal to each other, tiny, huge.

use super::branches::{Branches, Tally};
use super::subject::Subject;
use crate::formula::Field;
use crate::formula::quantity::Domain;
use crate::number::scalar::direction;
use crate::toolkit::graph::{Node, Op};
use std::ops::Range;

/// The number of points whose inputs are made special.
const SPECIAL_STARTS: usize = 5;
/// The number of points kept for each branch, as starting points towards the other.
const STARTS: usize = 6;
/// The number of repetitions, since one branch leads to others.
const ROUNDS: usize = 3;
/// Steps of Newton's method.
const STEPS: usize = 6;
/// Factors of the Newton step: exact, slightly longer, and clearly longer.
const STRETCHES: [f64; 4] = [1.0, 1.0 + 1e-10, 1.1, 2.0];
/// Factors for a field. With larger factors a kink would be nearer than the steps of differences.
const FACTORS: [f64; 4] = [0.0, -1.0, 1e-9, 1e9];
/// Factors for all fields: products of three such numbers neither overflow nor underflow.
const SCALES: [f64; 4] = [1e-40, 1e40, 1e-90, 1e90];

/// A point, and the comparison that has this outcome at no earlier point.
pub(super) struct Reached {
    pub(super) inputs: Vec<f64>,
    pub(super) comparison: Node,
    pub(super) answer: bool,
}

/// Points that take branches which the given points do not.
pub(super) fn reach(subject: &Subject, branches: &Branches, points: &[&[f64]]) -> Vec<Reached> {
    let mut search = Search::new(subject, branches);
    for point in points {
        search.enter(point);
    }
    let special: Vec<_> = points.iter().take(SPECIAL_STARTS).collect();
    for _ in 0..ROUNDS {
        if search.tally.is_full() {
            break;
        }
        let before = search.found.len();
        search.cross();
        for point in &special {
            search.specialise(point);
        }
        if search.found.len() == before {
            break;
        }
    }
    search.found
}

struct Search<'a> {
    subject: &'a Subject,
    branches: &'a Branches<'a>,
    fields: Vec<Range<usize>>,
    /// The components of unit vectors that are perpendicular to each other.
    triads: Vec<Vec<Range<usize>>>,
    tally: Tally,
    /// Points for each outcome of each comparison.
    starts: Vec<[Vec<Vec<f64>>; 2]>,
    found: Vec<Reached>,
}

impl<'a> Search<'a> {
    fn new(subject: &'a Subject, branches: &'a Branches<'a>) -> Self {
        Self {
            subject,
            branches,
            fields: Field::ranges(subject.inputs).collect(),
            triads: triads(subject.inputs),
            tally: branches.tally(),
            starts: vec![Default::default(); branches.comparisons.len()],
            found: Vec::new(),
        }
    }

    /// Keeps a starting point, and returns the first comparison for which it has a new outcome.
    fn enter(&mut self, point: &[f64]) -> Option<(Node, bool)> {
        let answers = self.branches.answers(point);
        let mut new = None;
        for (k, answer) in answers.iter().enumerate() {
            let Some(answer) = *answer else { continue };
            if !self.tally.has(k, answer) {
                new = new.or(Some((self.branches.comparisons[k], answer)));
            }
            let starts = &mut self.starts[k][usize::from(answer)];
            if starts.len() < STARTS {
                starts.push(point.to_vec());
            }
        }
        self.tally.add(&answers);
        new
    }

    /// Keeps a point that is valid, has finite results, and takes a new branch.
    fn visit(&mut self, point: &[f64]) {
        let is_finite = || (self.subject.linearized)(point).iter().flatten().all(|x| x.is_finite());
        if (self.subject.check)(point).is_ok()
            && is_finite()
            && let Some((comparison, answer)) = self.enter(point)
        {
            self.found.push(Reached { inputs: point.to_vec(), comparison, answer });
        }
    }

    /// Moves from a known branch to a missing one, comparison by comparison.
    fn cross(&mut self) {
        for k in 0..self.branches.comparisons.len() {
            for answer in [false, true] {
                let starts = self.starts[k][usize::from(!answer)].clone();
                for (start, stretch) in starts.iter().flat_map(|start| STRETCHES.map(|stretch| (start, stretch))) {
                    if self.tally.has(k, answer) {
                        break;
                    }
                    self.towards(k, start.clone(), stretch);
                }
            }
        }
    }

    /// Newton's method towards equality of the numbers of a comparison.
    fn towards(&mut self, k: usize, mut point: Vec<f64>, stretch: f64) {
        let graph = self.branches.graph;
        let Op::Compare(_, x, y) = *graph.op(self.branches.comparisons[k]) else { return };
        let needed = graph.needed(&[x, y]);
        for _ in 0..STEPS {
            let all = graph.results(&point, needed.iter().copied());
            let gap = all[x.index()] - all[y.index()];
            let [of_x, of_y] = [x, y].map(|node| graph.gradient(node, &needed, &all, point.len()));
            let slopes: Vec<_> = of_x.iter().zip(&of_y).map(|(x, y)| x - y).collect();
            let steepest = slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
            let square: f64 = slopes.iter().map(|slope| (slope / steepest).powi(2)).sum();
            for (x, slope) in point.iter_mut().zip(&slopes) {
                *x -= stretch * (gap / steepest) / square * (slope / steepest);
            }
            // This happens if the numbers are not finite, or if no input changes them.
            if point.iter().any(|x| x.is_nan()) {
                return;
            }
            self.make_perpendicular(&mut point);
            self.visit(&point);
        }
    }

    fn specialise(&mut self, start: &[f64]) {
        for (k, field) in self.fields.clone().into_iter().enumerate() {
            for component in field.clone() {
                for value in [0.0, -start[component]] {
                    self.changed(start, |point| point[component] = value);
                }
            }
            for factor in FACTORS {
                self.changed(start, |point| point[field.clone()].iter_mut().for_each(|x| *x *= factor));
            }
            let same: Vec<_> = self.fields[..k].iter().filter(|other| other.len() == field.len()).cloned().collect();
            for other in same {
                for sign in [1.0, -1.0] {
                    let others: Vec<_> = start[other.clone()].iter().map(|x| sign * x).collect();
                    self.changed(start, |point| point[field.clone()].copy_from_slice(&others));
                }
            }
        }
        for scale in SCALES {
            self.changed(start, |point| point.iter_mut().for_each(|x| *x *= scale));
        }
    }

    fn changed(&mut self, start: &[f64], change: impl Fn(&mut [f64])) {
        let mut point = start.to_vec();
        change(&mut point);
        self.make_perpendicular(&mut point);
        self.visit(&point);
    }

    /// The Gram–Schmidt process: the vectors of every triad become unit vectors again, perpendicular to those before them.
    fn make_perpendicular(&self, point: &mut [f64]) {
        for triad in &self.triads {
            for (k, axis) in triad.iter().enumerate() {
                for before in &triad[..k] {
                    let shared: f64 = axis.clone().zip(before.clone()).map(|(a, b)| point[a] * point[b]).sum();
                    axis.clone().zip(before.clone()).for_each(|(a, b)| point[a] -= shared * point[b]);
                }
                let mut vector = [0.0; 3];
                vector[..axis.len()].copy_from_slice(&point[axis.clone()]);
                point[axis.clone()].copy_from_slice(&direction(vector)[..axis.len()]);
            }
        }
    }
}

/// The components of the unit vectors of each node, and of each direction.
fn triads(fields: &[Field]) -> Vec<Vec<Range<usize>>> {
    let mut triads: Vec<(Domain, Vec<Range<usize>>)> = Vec::new();
    for (field, range) in fields.iter().zip(Field::ranges(fields)) {
        let (Domain::Triad(..) | Domain::Direction) = field.quantity.domain else { continue };
        let is_same = |domain: &Domain| match (domain, field.quantity.domain) {
            (Domain::Triad(node, _), Domain::Triad(other, _)) => *node == other,
            _ => false,
        };
        match triads.iter_mut().find(|(domain, _)| is_same(domain)) {
            Some((_, ranges)) => ranges.push(range),
            None => triads.push((field.quantity.domain, vec![range])),
        }
    }
    triads.into_iter().map(|(_, ranges)| ranges).collect()
}

#[cfg(test)]
mod tests;
