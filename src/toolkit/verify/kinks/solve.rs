//! Inputs at which numbers of a graph are equal: Newton's method in `f64`, finished in 237 bits.

use super::candidate::{Candidate, Other};
use crate::Octuple;
use crate::formula::Field;
use crate::number::scalar::{Leaf, abs};
use crate::toolkit::graph::{Graph, Node, Number};
use crate::toolkit::verify::difference::step_size;
use crate::toolkit::verify::{exact, rounded};

/// Newton steps in `f64`, from a distant start.
const STEPS: usize = 15;
/// Newton steps in 237 bits, each of which doubles the digits.
const LAST_STEPS: usize = 8;
/// The tolerance of equality in `f64`, relative to the terms of the numbers, for the last steps to converge.
const NEAR: f64 = 1e-6;
/// The tolerance of equality in 237 bits.
const EQUAL: f64 = 1e-62;
/// A component that has shrunk to less than this fraction becomes 0.
const NOTHING: f64 = 1e-40;
/// Bisection steps between two points.
const HALVINGS: usize = 60;
/// Added to the matrix of dependent equations, relative to its size.
const RIDGE: [f64; 2] = [1e-12, 1e-36];

/// The equations of a candidate, and their solver.
pub(super) struct Solver<'a> {
    graph: &'a Graph,
    fields: &'static [Field],
    pairs: &'a [(Node, Other)],
    negative: Option<Node>,
    needed: Vec<Node>,
}

/// The difference of the numbers of each pair at a point.
struct Gap<T> {
    residual: T,
    /// The derivatives of the residual in units of the size of each input.
    gradient: Vec<T>,
    /// The size of the terms that the numbers are made of.
    scale: T,
}

/// The target value of a number, or the node whose result is the target.
fn goal(value: f64, other: &Other) -> Result<f64, Node> {
    match other {
        Other::Node(node) => Err(*node),
        Other::Number(number) => Ok(*number),
        Other::PowerOfTwo => Ok(value.power_of_two_below()[0] * 2.0),
        Other::Halfway => Ok(value.floor() + 0.5),
    }
}

impl<'a> Solver<'a> {
    pub(super) fn new(graph: &'a Graph, fields: &'static [Field], candidate: &'a Candidate) -> Self {
        let others = candidate.pairs.iter().filter_map(|(_, other)| match other {
            Other::Node(node) => Some(*node),
            Other::Number(_) | Other::PowerOfTwo | Other::Halfway => None,
        });
        let results: Vec<_> = candidate.pairs.iter().map(|(node, _)| *node).chain(others).collect();
        let needed = graph.needed(&results);
        Self { graph, fields, pairs: &candidate.pairs, negative: candidate.negative, needed }
    }

    /// Solutions near a start that also satisfy this condition. If possible, one component per equation is changed, so
    /// that the others remain doubles.
    pub(super) fn near(&self, start: &[f64], is_met: impl Fn(&Vec<Octuple>) -> bool) -> Option<Vec<Octuple>> {
        let sizes = self.sizes(&exact(start));
        let goals = self.goals(start);
        let gaps = self.gaps(start, &rounded(&sizes), &goals);
        let moves = |gap: &Gap<f64>, k: usize| gap.gradient[k].is_normal();
        let moved = |k: usize| gaps.iter().filter(|gap| moves(gap, k)).count();
        // Components that affect no other equation come first, then those that affect this one most.
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

    /// Whether a point is on the candidate.
    pub(super) fn is_on(&self, point: &[f64]) -> bool {
        let is_on_side = self.negative.is_none_or(|node| {
            let needed = self.graph.needed(&[node]);
            self.graph.results(point, needed)[node.index()] < 0.0
        });
        is_on_side && self.is_solved(&exact(point), &self.goals(point), 0.0)
    }

    /// A solution between two points on different sides of a single equation.
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

    /// The target value of each first number, if the target is not another result.
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
                Other::Number(_) | Other::PowerOfTwo | Other::Halfway => T::from(goal.unwrap_or(f64::NAN)),
            };
            slopes.iter_mut().zip(sizes).for_each(|(slope, &size)| *slope *= size);
            let scale = slopes.iter().fold(abs(value) + abs(other), |sum, &slope| sum + abs(slope));
            Gap { residual: value - other, gradient: slopes, scale }
        };
        self.pairs.iter().zip(goals).map(gap).collect()
    }

    /// Solves by changing these components only.
    fn along(&self, start: &[f64], columns: &[usize], goals: &[Option<f64>]) -> Option<Vec<Octuple>> {
        let sizes_at_start = self.sizes(&exact(start));
        let near = self.newton(start.to_vec(), &rounded(&sizes_at_start), (columns, goals), STEPS, RIDGE[0], NEAR)?;
        // Solutions in doubles are preferred.
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
        // Removes the remainder of a number that should vanish.
        for (x, &size) in found.iter_mut().zip(&sizes_at_start).filter(|(x, size)| abs(**x) < **size * NOTHING) {
            *x = size * 0.0;
        }
        Some(found)
    }

    fn is_solved(&self, inputs: &[Octuple], goals: &[Option<f64>], bound: f64) -> bool {
        let gaps = self.gaps(inputs, &self.sizes(inputs), goals);
        gaps.iter().all(|gap| abs(gap.residual) <= gap.scale * bound)
    }

    /// Iterates as long as the residual decreases.
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

/// The smallest changes of these inputs, relative to their sizes, that close all gaps to first order.
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

/// Gaussian elimination of a symmetric positive definite matrix, with the right-hand side as its last column; `None`
/// if a pivot falls to this fraction of its original value.
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

#[cfg(test)]
mod tests {
    use super::super::planted::Inputs;
    use super::*;
    use crate::formula::Fields;
    use crate::toolkit::graph::Binary::{Add, Multiply, Subtract};
    use crate::toolkit::graph::{Relation, Unary};

    /// A number of x, y and c, and its target.
    type Equation = fn(&mut Graph, [Node; 3]) -> (Node, Other);

    /// Calls the solver for these equations.
    fn solved<T>(equations: &[Equation], ask: impl FnOnce(&Solver<'_>) -> T) -> T {
        let mut graph = Graph::default();
        let inputs = graph.inputs();
        let pairs = equations.iter().map(|equation| equation(&mut graph, inputs)).collect();
        let candidate = Candidate { node: inputs[0], words: String::new(), pairs, negative: None };
        ask(&Solver::new(&graph, Inputs::<f64>::FIELDS, &candidate))
    }

    /// Solutions near a start.
    fn near(equations: &[Equation], start: [f64; 3], is_met: fn(&[f64]) -> bool) -> Option<Vec<f64>> {
        solved(equations, |solver| solver.near(&start, |at| is_met(&rounded(at))).map(|at| rounded(&at)))
    }

    /// A sum of x, y and c with these factors.
    fn sum(graph: &mut Graph, inputs: [Node; 3], factors: [f64; 3]) -> Node {
        let mut sum = graph.number(0.0);
        for (input, factor) in inputs.into_iter().zip(factors).filter(|(_, factor)| *factor != 0.0) {
            let factor = graph.number(factor);
            let term = graph.binary(Multiply, factor, input);
            sum = graph.binary(Add, sum, term);
        }
        sum
    }

    #[test]
    fn a_number_is_to_be_another_one_or_where_a_function_of_it_jumps() {
        let [x] = Graph::default().inputs();
        assert_eq!((goal(3.0, &Other::Number(2.0)), goal(3.0, &Other::Node(x))), (Ok(2.0), Err(x)));
        assert_eq!([3.0, 4.0, 0.75].map(|value| goal(value, &Other::PowerOfTwo)), [Ok(4.0), Ok(8.0), Ok(1.0)]);
        assert_eq!([3.0, 3.75, -0.25].map(|value| goal(value, &Other::Halfway)), [Ok(3.5), Ok(3.5), Ok(-0.5)]);
    }

    #[test]
    fn gaps_are_in_units_of_the_inputs_and_of_their_terms() {
        let product: Equation = |graph, [x, _, c]| (graph.binary(Multiply, x, c), Other::Number(4.0));
        let other: Equation = |graph, [x, y, c]| (graph.binary(Multiply, x, c), Other::Node(y));
        let power: Equation = |graph, [x, _, c]| (graph.binary(Multiply, c, x), Other::PowerOfTwo);
        let shown = |start: [f64; 3]| {
            solved(&[product, other, power], |solver| {
                let goals = solver.goals(&start);
                let sizes = rounded(&solver.sizes(&exact(&start)));
                let gaps = solver.gaps(&start, &sizes, &goals);
                let gaps = gaps.into_iter().map(|gap| (gap.residual, gap.gradient, gap.scale)).collect::<Vec<_>>();
                (goals, gaps)
            })
        };
        let (goals, gaps) = shown([2.0, 3.0, 5.0]);
        assert_eq!(goals, [Some(4.0), None, Some(16.0)]);
        assert_eq!(gaps[0], (6.0, vec![10.0, 0.0, 10.0], 10.0 + 4.0 + 20.0));
        assert_eq!(gaps[1], (7.0, vec![10.0, -3.0, 10.0], 10.0 + 3.0 + 23.0));
        assert_eq!(gaps[2], (-6.0, vec![10.0, 0.0, 10.0], 10.0 + 16.0 + 20.0));
        let (_, gaps) = shown([-2.0, 3.0, 5.0]);
        assert_eq!(gaps[1], (-13.0, vec![10.0, -3.0, -10.0], 10.0 + 3.0 + 23.0));
    }

    #[test]
    fn one_component_changes_that_moves_the_number_most() {
        let equation: Equation = |graph, inputs| (sum(graph, inputs, [1.0, 2.0, 4.0]), Other::Number(11.0));
        let near = |is_met| near(&[equation], [1.0, 1.0, 1.0], is_met);
        assert_eq!(near(|_| true), Some(vec![1.0, 1.0, 2.0]));
        assert_eq!(near(|at| at[2] == 1.0), Some(vec![1.0, 3.0, 1.0]));
        // A third component is not tried.
        assert_eq!(near(|at| at[0] != 1.0), None);
    }

    #[test]
    fn of_several_equations_each_has_its_own_component() {
        let first: Equation = |graph, inputs| (sum(graph, inputs, [1.0, 1.0, 4.0]), Other::Number(10.0));
        let second: Equation = |_, [.., c]| (c, Other::Number(2.0));
        let near_ones = |is_met| near(&[first, second], [1.0, 1.0, 1.0], is_met);
        assert_eq!(near_ones(|_| true), Some(vec![1.0, 1.0, 2.0]));
        // c affects both equations, though it affects the first most.
        let near_others = |is_met| near(&[first, second], [2.0, 1.0, 1.0], is_met);
        assert_eq!(near_others(|_| true), Some(vec![1.0, 1.0, 2.0]));
        // If that does not help, all of them change slightly.
        let all = near_others(|at| at[1] != 1.0).expect("a solution");
        assert_eq!((all[0] + all[1], all[2]), (2.0, 2.0));
        assert!((all[0] - 1.2).abs() < 1e-12 && (all[1] - 0.8).abs() < 1e-12, "{all:?}");
    }

    #[test]
    fn a_component_that_another_equation_has_taken_is_left_to_it() {
        let first: Equation = |graph, inputs| (sum(graph, inputs, [4.0, 1.0, 2.0]), Other::Number(15.0));
        let second: Equation = |graph, inputs| (sum(graph, inputs, [4.0, 1.0, -2.0]), Other::Number(7.0));
        assert_eq!(near(&[first, second], [1.0, 1.0, 1.0], |_| true), Some(vec![2.5, 1.0, 2.0]));
    }

    #[test]
    fn what_is_no_double_has_all_its_digits_and_what_is_one_no_more() {
        let third: Equation = |graph, inputs| (sum(graph, inputs, [3.0, 0.0, 0.0]), Other::Number(1.0));
        let at = solved(&[third], |solver| solver.near(&[1.0, 1.0, 1.0], |_| true)).expect("a solution");
        assert!(abs(at[0] * 3.0 - 1.0) < 1e-62 && at[0] != Octuple::from(at[0].to_f64()), "{at:?}");
        assert_eq!(rounded(&at[1..]), [1.0, 1.0]);
        for start in [1.0, 2.0, 5.0, 100.0] {
            let cube: Equation = |graph, [x, ..]| {
                let square = graph.binary(Multiply, x, x);
                (graph.binary(Multiply, square, x), Other::Number(27.0))
            };
            let at = solved(&[cube], |solver| solver.near(&[start, 1.0, 1.0], |_| true)).expect("a solution");
            assert_eq!(at, exact(&[3.0, 1.0, 1.0]), "from {start}");
        }
    }

    #[test]
    fn what_is_left_of_a_number_that_vanishes_is_nothing() {
        for start in [1.0, 0.3, -1.0] {
            let equation: Equation = |graph, [x, ..]| {
                let exponential = graph.unary(Unary::ExponentialMinusOne, x);
                let tenths = sum(graph, [exponential; 3], [0.1, 0.7, 0.0]);
                (tenths, Other::Number(0.0))
            };
            let at = solved(&[equation], |solver| solver.near(&[start, 1.0, 1.0], |_| true));
            assert_eq!(at, Some(exact(&[0.0, 1.0, 1.0])), "from {start}");
        }
    }

    #[test]
    fn where_nothing_solves_an_equation_nothing_is_found() {
        let square: Equation = |graph, [x, ..]| (graph.binary(Multiply, x, x), Other::Number(-1.0));
        let root: Equation = |graph, [x, ..]| (graph.unary(Unary::Root, x), Other::Number(-1.0));
        let flat: Equation = |graph, _| (graph.number(2.0), Other::Number(1.0));
        let contrary: Equation = |_, [x, ..]| (x, Other::Number(1.0));
        let other: Equation = |_, [x, ..]| (x, Other::Number(2.0));
        for equations in [&[square][..], &[root], &[flat], &[contrary, other]] {
            assert_eq!(near(equations, [1.0, 1.0, 1.0], |_| true), None);
        }
        let both = near(&[contrary, contrary], [3.0, 1.0, 1.0], |_| true);
        assert_eq!(both, Some(vec![1.0, 1.0, 1.0]));
    }

    #[test]
    fn a_point_is_on_a_candidate_exactly_and_on_its_side() {
        let mut graph = Graph::default();
        let [x, y, c] = graph.inputs();
        let below = graph.binary(Subtract, y, c);
        let pairs = vec![(x, Other::Number(2.0))];
        let is_on = |negative, point: [f64; 3]| {
            let candidate = Candidate { node: x, words: String::new(), pairs: pairs.clone(), negative };
            Solver::new(&graph, Inputs::<f64>::FIELDS, &candidate).is_on(&point)
        };
        assert!(is_on(None, [2.0, 1.0, 1.0]) && !is_on(None, [2.0_f64.next_up(), 1.0, 1.0]));
        assert!(is_on(Some(below), [2.0, 1.0, 3.0]) && !is_on(Some(below), [3.0, 1.0, 3.0]));
        assert!(!is_on(Some(below), [2.0, 1.0, 1.0]) && !is_on(Some(below), [2.0, 2.0, 1.0]));
    }

    #[test]
    fn between_points_on_different_sides_there_is_one_on_none() {
        let between = |equation: Equation, starts: &[[f64; 3]], is_met: fn(&[f64]) -> bool| {
            let starts: Vec<_> = starts.iter().map(|start| start.to_vec()).collect();
            solved(&[equation], |solver| solver.between(&starts, |at| is_met(&rounded(at))).map(|at| rounded(&at)))
        };
        let one: Equation = |_, [x, ..]| (x, Other::Number(1.0));
        // A start on the candidate itself is on neither side.
        let starts = [[1.0, 9.0, 1.0], [4.0, 4.0, 1.0], [0.0, 0.0, 1.0], [8.0, 1.0, 1.0], [-8.0, 1.0, 1.0]];
        let found = between(one, &starts, |_| true).expect("one is between");
        assert!(found[0] == 1.0 && (found[1] - 1.0).abs() < 1e-15 && found[2] == 1.0, "{found:?}");
        assert_eq!(between(one, &starts, |at| at[1] > 3.0), None);
        assert_eq!(between(one, &starts[..2], |_| true), None);
        assert_eq!(between(one, &starts[2..3], |_| true), None);
        let other: Equation = |_, [x, y, _]| (x, Other::Node(y));
        let found = between(other, &[[0.0, 2.0, 1.0], [8.0, 2.0, 1.0]], |_| true).expect("one is between");
        assert!(found[0] == found[1] && (found[1] - 2.0).abs() < 1e-15, "{found:?}");
        // Newton's method converges from neither of these.
        let flat: Equation = |graph, [x, ..]| {
            let [one, three] = [1.0, 3.0].map(|c| graph.number(c));
            let [is_low, is_inside] = [one, three].map(|end| graph.compare(Relation::Less, x, end));
            let upper = graph.select(is_inside, x, three);
            (graph.select(is_low, one, upper), Other::Number(2.0))
        };
        let starts = [[0.0, 1.0, 1.0], [8.0, 1.0, 1.0]];
        assert_eq!(starts.map(|start| near(&[flat], start, |_| true)), [None, None]);
        assert_eq!(between(flat, &starts, |_| true), Some(vec![2.0, 1.0, 1.0]));
    }

    #[test]
    fn the_smallest_changes_close_all_gaps() {
        let gap = |residual: f64, gradient: [f64; 3]| Gap { residual, gradient: gradient.into(), scale: 1.0 };
        assert_eq!(least_change(&[gap(25.0, [3.0, 9.0, -4.0])], &[0, 2], 0.0), Some(vec![3.0, -4.0]));
        assert_eq!(least_change(&[gap(10.0, [3.0, 9.0, -4.0])], &[2], 0.0), Some(vec![-2.5]));
        let two = [gap(2.0, [1.0, 1.0, 0.0]), gap(3.0, [0.0, 1.0, 1.0])];
        let changes = least_change(&two, &[0, 1, 2], 1e-12).expect("they are independent");
        let expected = [1.0 / 3.0, 5.0 / 3.0, 4.0 / 3.0];
        assert!(changes.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-14), "{changes:?}");
        // The same equation twice, and one that no input affects.
        let same = [gap(2.0, [1.0, 0.0, 1.0]), gap(2.0, [1.0, 0.0, 1.0])];
        let changes = least_change(&same, &[0, 2], 1e-12).expect("a little is added");
        assert!(changes.iter().all(|change| (change - 1.0).abs() < 1e-9), "{changes:?}");
        assert_eq!(least_change(&[gap(1.0, [0.0; 3])], &[0, 1, 2], 1e-12), None);
    }

    #[test]
    fn a_matrix_is_eliminated_while_its_pivots_are_sound() {
        let three = vec![vec![4.0, 2.0, 2.0, 8.0], vec![2.0, 5.0, 3.0, 10.0], vec![2.0, 3.0, 6.0, 4.0]];
        let solution = eliminate(three.clone(), 0.0).expect("it is positive");
        for row in &three {
            let left: f64 = row.iter().zip(&solution).map(|(entry, x)| entry * x).sum();
            assert!((left - row[3]).abs() < 1e-14, "{solution:?}");
        }
        // The second pivot is half of its original value.
        let half = |part| eliminate(vec![vec![4.0, 2.0, 8.0], vec![2.0, 2.0, 6.0]], part);
        assert_eq!((half(0.49), half(0.5)), (Some(vec![1.0, 2.0]), None));
        assert_eq!(
            (eliminate(vec![vec![2.0, 6.0]], 0.0), eliminate(vec![vec![0.0, 6.0]], 0.0)),
            (Some(vec![3.0]), None)
        );
    }
}
