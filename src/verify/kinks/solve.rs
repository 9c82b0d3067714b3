//! Inputs at which numbers of a graph are equal: Newton's method in `f64`, finished in 237 bits.

use super::candidate::{Candidate, Other};
use crate::Octuple;
use crate::formula::Field;
use crate::graph::{Graph, Node, Number};
use crate::scalar::{Leaf, abs};
use crate::verify::difference::step_size;
use crate::verify::{exact, rounded};

/// Steps in `f64`, from far away.
const STEPS: usize = 15;
/// Steps in 237 bits: each doubles the digits.
const LAST_STEPS: usize = 8;
/// Numbers are equal in `f64` to this part of what they are made of, so that the last steps converge.
const NEAR: f64 = 1e-6;
/// And in 237 bits to this.
const EQUAL: f64 = 1e-62;
/// A component that has become this part of what it was is 0.
const NOTHING: f64 = 1e-40;
/// Halvings of the way between two points.
const HALVINGS: usize = 60;
/// Where equations depend on each other, this is added to their matrix, in proportion.
const RIDGE: [f64; 2] = [1e-12, 1e-36];

/// What is solved for a candidate.
pub(super) struct Solver<'a> {
    graph: &'a Graph,
    fields: &'static [Field],
    pairs: &'a [(Node, Other)],
    negative: Option<Node>,
    needed: Vec<Node>,
}

/// By how much the numbers of each pair differ at a point.
struct Gap<T> {
    residual: T,
    /// The derivatives of the residual in units of the size of each input.
    gradient: Vec<T>,
    /// The numbers are made of terms of this size.
    scale: T,
}

/// What a number is to be, or the node whose result it is to be.
fn goal(value: f64, other: &Other) -> Result<f64, Node> {
    match other {
        Other::Node(node) => Err(*node),
        Other::Number(number) => Ok(*number),
        Other::PowerOfTwo => Ok(value.power_of_two_below()[0] * 2.0),
    }
}

impl<'a> Solver<'a> {
    pub(super) fn new(graph: &'a Graph, fields: &'static [Field], candidate: &'a Candidate) -> Self {
        let others = candidate.pairs.iter().filter_map(|(_, other)| match other {
            Other::Node(node) => Some(*node),
            Other::Number(_) | Other::PowerOfTwo => None,
        });
        let results: Vec<_> = candidate.pairs.iter().map(|(node, _)| *node).chain(others).collect();
        let needed = graph.needed(&results);
        Self { graph, fields, pairs: &candidate.pairs, negative: candidate.negative, needed }
    }

    /// Inputs near a start that meet this too, changed in one component an equation if that will do, so that the others
    /// stay doubles.
    pub(super) fn near(&self, start: &[f64], is_met: impl Fn(&Vec<Octuple>) -> bool) -> Option<Vec<Octuple>> {
        let sizes = self.sizes(&exact(start));
        let goals = self.goals(start);
        let gaps = self.gaps(start, &rounded(&sizes), &goals);
        let moves = |gap: &Gap<f64>, k: usize| gap.gradient[k].is_normal();
        let moved = |k: usize| gaps.iter().filter(|gap| moves(gap, k)).count();
        // Those come first that move no other equation, and move this one most.
        let moving = |gap: &Gap<f64>| {
            let mut columns: Vec<usize> = (0..start.len()).filter(|&k| moves(gap, k)).collect();
            let size = |k: usize| gap.gradient[k].abs();
            columns.sort_by(|&a, &b| moved(a).cmp(&moved(b)).then(size(b).total_cmp(&size(a))));
            columns
        };
        if let [gap] = gaps.as_slice() {
            let few = moving(gap).into_iter().take(2);
            return few.filter_map(|column| self.along(start, &[column], &goals)).find(is_met);
        }
        let mut few = Vec::new();
        for gap in &gaps {
            few.extend(moving(gap).into_iter().find(|column| !few.contains(column)));
        }
        let mut all: Vec<_> = gaps.iter().flat_map(moving).collect();
        all.sort_unstable();
        all.dedup();
        [few, all].iter().filter_map(|columns| self.along(start, columns, &goals)).find(is_met)
    }

    /// Whether the candidate is at a point.
    pub(super) fn is_on(&self, point: &[f64]) -> bool {
        let is_on_side = self.negative.is_none_or(|node| {
            let needed = self.graph.needed(&[node]);
            self.graph.results(point, needed)[node.index()] < 0.0
        });
        is_on_side && self.is_solved(&exact(point), &self.goals(point), 0.0)
    }

    /// Inputs between two points at which a single number is on different sides of what it is to be equal to.
    pub(super) fn between(&self, starts: &[Vec<f64>], is_met: impl Fn(&Vec<Octuple>) -> bool) -> Option<Vec<Octuple>> {
        let side = |point: &[f64]| {
            let all = self.graph.results(point, self.needed.iter().copied());
            let residual = |(node, other): &(Node, Other)| {
                let value = all[node.index()];
                value - goal(value, other).unwrap_or_else(|other| all[other.index()])
            };
            self.pairs.first().map_or(f64::NAN, residual)
        };
        let sides: Vec<_> = starts.iter().map(|start| side(start)).collect();
        let below = sides.iter().position(|&side| side < 0.0)?;
        let above = sides.iter().position(|&side| side > 0.0)?;
        let (mut low, mut high) = (starts[below].clone(), starts[above].clone());
        for _ in 0..HALVINGS {
            let middle: Vec<f64> = low.iter().zip(&high).map(|(a, b)| f64::midpoint(*a, *b)).collect();
            let end = if side(&middle) < 0.0 { &mut low } else { &mut high };
            *end = middle;
        }
        self.near(&low, is_met)
    }

    /// The size of every input.
    fn sizes(&self, inputs: &[Octuple]) -> Vec<Octuple> {
        (0..inputs.len()).map(|k| step_size(self.fields, inputs, k)).collect()
    }

    /// What each first number is to be, where that is no other result.
    fn goals(&self, start: &[f64]) -> Vec<Option<f64>> {
        let all = self.graph.results(start, self.needed.iter().copied());
        self.pairs.iter().map(|(node, other)| goal(all[node.index()], other).ok()).collect()
    }

    fn gaps<T: Number>(&self, inputs: &[T], sizes: &[T], goals: &[Option<f64>]) -> Vec<Gap<T>> {
        let all = self.graph.results(inputs, self.needed.iter().copied());
        let gradient = |node: Node| self.graph.gradient(node, &self.needed, &all, inputs.len());
        let gap = |(&(node, other), goal): (&(Node, Other), &Option<f64>)| {
            let mut slopes = gradient(node);
            let value = all[node.index()];
            let other = match other {
                Other::Node(other) => {
                    slopes.iter_mut().zip(gradient(other)).for_each(|(slope, by)| *slope -= by);
                    all[other.index()]
                }
                Other::Number(_) | Other::PowerOfTwo => T::from(goal.unwrap_or(f64::NAN)),
            };
            slopes.iter_mut().zip(sizes).for_each(|(slope, &size)| *slope *= size);
            let scale = slopes.iter().fold(abs(value) + abs(other), |sum, &slope| sum + abs(slope));
            Gap { residual: value - other, gradient: slopes, scale }
        };
        self.pairs.iter().zip(goals).map(gap).collect()
    }

    /// Changes these components only.
    fn along(&self, start: &[f64], columns: &[usize], goals: &[Option<f64>]) -> Option<Vec<Octuple>> {
        let sizes_at_start = self.sizes(&exact(start));
        let near = self.newton(start.to_vec(), &rounded(&sizes_at_start), (columns, goals), STEPS, RIDGE[0], NEAR)?;
        // Doubles that do are easier to give back.
        let inputs = exact(&near);
        if self.is_solved(&inputs, goals, 0.0) {
            return Some(inputs);
        }
        let sizes = self.sizes(&inputs);
        let mut found = self.newton(inputs, &sizes, (columns, goals), LAST_STEPS, RIDGE[1], EQUAL)?;
        let doubles = exact(&rounded(&found));
        if self.is_solved(&doubles, goals, 0.0) {
            return Some(doubles);
        }
        // What is left of a number that is to vanish.
        for (x, &size) in found.iter_mut().zip(&sizes_at_start).filter(|(x, size)| abs(**x) < **size * NOTHING) {
            *x = size * 0.0;
        }
        Some(found)
    }

    fn is_solved(&self, inputs: &[Octuple], goals: &[Option<f64>], bound: f64) -> bool {
        let gaps = self.gaps(inputs, &self.sizes(inputs), goals);
        gaps.iter().all(|gap| abs(gap.residual) <= gap.scale * bound)
    }

    /// The steps go on while they bring something.
    fn newton<T: Number>(
        &self,
        mut inputs: Vec<T>,
        sizes: &[T],
        (columns, goals): (&[usize], &[Option<f64>]),
        steps: usize,
        ridge: f64,
        bound: f64,
    ) -> Option<Vec<T>> {
        let share =
            |gaps: &[Gap<T>]| gaps.iter().fold(T::zero(), |worst, gap| worst.or_larger(abs(gap.residual) / gap.scale));
        let mut gaps = self.gaps(&inputs, sizes, goals);
        for _ in 0..steps {
            if gaps.iter().all(|gap| gap.residual == 0.0) {
                break;
            }
            let moves = least_change(&gaps, columns, ridge)?;
            let mut next = inputs.clone();
            columns.iter().zip(moves).for_each(|(&k, change)| next[k] -= change * sizes[k]);
            let next_gaps = self.gaps(&next, sizes, goals);
            if next_gaps.iter().any(|gap| gap.residual.re().is_nan()) {
                return None;
            }
            let has_settled = share(&gaps) < bound && share(&next_gaps) >= share(&gaps);
            if has_settled {
                break;
            }
            (inputs, gaps) = (next, next_gaps);
        }
        (share(&gaps) <= bound).then_some(inputs)
    }
}

/// The smallest changes of these inputs, in units of their sizes, that close all gaps to first order.
fn least_change<T: Number>(gaps: &[Gap<T>], columns: &[usize], ridge: f64) -> Option<Vec<T>> {
    let product =
        |a: &Gap<T>, b: &Gap<T>| columns.iter().fold(T::zero(), |sum, &k| sum + a.gradient[k] * b.gradient[k]);
    let mut rows: Vec<Vec<T>> = gaps.iter().map(|a| gaps.iter().map(|b| product(a, b)).collect()).collect();
    rows.iter_mut().zip(gaps).for_each(|(row, gap)| row.push(gap.residual));
    let weights = eliminate(rows.clone(), ridge).or_else(|| {
        let largest = (0..rows.len()).fold(T::zero(), |largest, k| largest.or_larger(rows[k][k]));
        (0..rows.len()).for_each(|k| rows[k][k] += largest * ridge);
        eliminate(rows, 0.0)
    })?;
    let change =
        |&k: &usize| gaps.iter().zip(&weights).fold(T::zero(), |sum, (gap, &weight)| sum + gap.gradient[k] * weight);
    Some(columns.iter().map(change).collect())
}

/// Gauss elimination of a symmetric positive matrix, with the right side as its last column; `None` where a pivot is as
/// small a part of what it was.
fn eliminate<T: Number>(mut rows: Vec<Vec<T>>, part: f64) -> Option<Vec<T>> {
    let count = rows.len();
    let diagonal: Vec<_> = (0..count).map(|k| rows[k][k]).collect();
    for k in 0..count {
        let pivot = rows[k].clone();
        let is_sound = pivot[k] > diagonal[k] * part;
        if !is_sound {
            return None;
        }
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(entry, &by)| *entry -= factor * by);
        }
    }
    let mut solution = vec![T::zero(); count];
    for k in (0..count).rev() {
        let known = (k + 1..count).fold(T::zero(), |sum, j| sum + rows[k][j] * solution[j]);
        solution[k] = (rows[k][count] - known) / rows[k][k];
    }
    Some(solution)
}
