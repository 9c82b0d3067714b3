//! A formula as a textbook writes it, with any number of mistakes in it.

use super::change::{self, Change};
use super::sample::Sample;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::equation::Equation;
use jointproof::toolkit::graph::{Binary, Extremes, Graph, Node, Op};

/// The operations of a formula as it is printed; if it is not printed so, those of the code for ordinary numbers.
pub(super) struct Textbook {
    pub(super) graph: Graph,
    /// All operations from which the outputs are computed, in order.
    pub(super) needed: Vec<Node>,
    pub(super) inputs: usize,
}

/// The most operations of a formula in which mistakes are searched for, to limit the time.
const LONGEST: usize = 4000;

impl Textbook {
    /// Where both give the right values at these samples.
    pub(super) fn of(formula: &dyn AnyFormula, samples: &[Sample]) -> Option<Self> {
        let printed = Equation::of(&formula.spec(), formula.inputs(), formula.outputs()).ok();
        let printed = printed.and_then(|equation| equation.graph().cloned());
        let recorded = || formula.graph_with(Extremes::Nan).ok();
        let inputs = super::super::question::sizes(formula)[0];
        let is_right = |graph: Graph| {
            let needed = graph.needed(&graph.value);
            let book = Self { graph, needed, inputs };
            let fits = |sample: &Sample| {
                let all = book.run(&sample.inputs, &[], false).0;
                let mut values = book.graph.value.iter().enumerate();
                values.all(|(i, node)| (all[node.index()] - sample.right[i]).abs() <= 1e-9 * sample.scale[i])
            };
            (book.needed.len() <= LONGEST && samples.iter().take(8).all(fits)).then_some(book)
        };
        printed.and_then(is_right).or_else(|| recorded().and_then(is_right))
    }

    /// The results of all operations with changes of some, and the derivatives of each by its operands; these may be those of
    /// the right operations.
    fn run(
        &self,
        inputs: &[f64],
        changes: &[(Node, Change)],
        are_derivatives_right: bool,
    ) -> (Vec<f64>, Vec<Vec<(Node, f64)>>) {
        let mut slopes = vec![Vec::new(); self.graph.ops().len()];
        let is_value = |(_, change): &(Node, Change)| matches!(change, Change::Value(_));
        // What is taken from elsewhere has to be known, whether it is computed later or changed itself.
        let before = if changes.iter().any(is_value) { self.run(inputs, &[], false).0 } else { Vec::new() };
        let mut all = vec![f64::NAN; self.graph.ops().len()];
        for node in self.order(changes) {
            let op = self.graph.op(node);
            let changed = changes.iter().find(|(place, _)| *place == node);
            let (result, by) = match changed {
                Some((_, change)) => {
                    let values = if let Change::Value(_) = change { &before } else { &all };
                    let (result, by) = change.apply(op, inputs, values);
                    if are_derivatives_right { (result, change::derivatives(op, result, &all)) } else { (result, by) }
                }
                None => change::right(op, inputs, &all),
            };
            all[node.index()] = result;
            slopes[node.index()] = by;
        }
        (all, slopes)
    }

    /// An order in which everything is known that an operation needs, also with these changes.
    fn order(&self, changes: &[(Node, Change)]) -> Vec<Node> {
        let is_later = |(place, change): &(Node, Change)| matches!(change, Change::Instead(_, other) if other > place);
        if !changes.iter().any(is_later) {
            return self.needed.clone();
        }
        let (mut order, mut is_open, mut is_done) =
            (Vec::new(), vec![false; self.graph.ops().len()], vec![false; self.graph.ops().len()]);
        // Operands come before what needs them; a change that needs itself is never done, and its result is no number.
        let mut stack: Vec<(Node, bool)> = self.graph.value.iter().map(|node| (*node, false)).collect();
        while let Some((node, is_last)) = stack.pop() {
            if is_last {
                is_done[node.index()] = true;
                order.push(node);
                continue;
            }
            if is_done[node.index()] || is_open[node.index()] {
                continue;
            }
            is_open[node.index()] = true;
            stack.push((node, true));
            let mut operands = self.graph.op(node).operands();
            operands.extend(changes.iter().filter(|(place, _)| *place == node).filter_map(
                |(_, change)| match change {
                    Change::Instead(_, other) => Some(*other),
                    _ => None,
                },
            ));
            stack.extend(operands.into_iter().map(|node| (node, false)));
        }
        order
    }

    /// The results of all operations.
    pub(super) fn results(&self, inputs: &[f64]) -> Vec<f64> {
        self.run(inputs, &[], false).0
    }

    /// Whether the comparison of this operation holds, with every input as given.
    pub(super) fn holds(&self, node: Node, inputs: &[f64]) -> bool {
        self.run(inputs, &[], false).0[node.index()] == 1.0
    }

    /// The sum or difference that is smallest beside its terms, if it is less than a tenth of them.
    pub(super) fn cancellation(&self, inputs: &[f64]) -> Option<(Node, f64)> {
        let all = self.run(inputs, &[], false).0;
        let share = |node: &Node| match self.graph.op(*node) {
            Op::Binary(Binary::Add | Binary::Subtract, x, y) => {
                let terms = all[x.index()].abs().max(all[y.index()].abs());
                let share = (all[node.index()] / terms).abs();
                (share > 0.0 && share < 0.1).then_some((*node, share))
            }
            _ => None,
        };
        self.needed.iter().filter_map(share).min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// A length whose squares over- or underflow.
    pub(super) fn length_out_of_range(&self, inputs: &[f64]) -> Option<Node> {
        let all = self.run(inputs, &[], false).0;
        let is_lost = |node: &Node| {
            let x = all[node.index()].abs();
            x > 1e153 || x > 0.0 && x < 1e-153
        };
        self.needed.iter().copied().find(|node| match self.graph.op(*node) {
            Op::Norm(parts) => parts.iter().any(is_lost),
            _ => false,
        })
    }

    /// Values, and their Jacobian if it is wanted, with these changes.
    fn answer(&self, inputs: &[f64], model: &Model, changes: &[(Node, Change)], with_jacobian: bool) -> Vec<f64> {
        let (all, mut slopes) = self.run(inputs, changes, model.scope == Scope::Used);
        let mut answer: Vec<f64> = self.graph.value.iter().map(|node| all[node.index()]).collect();
        if !with_jacobian {
            return answer;
        }
        for link in &model.links {
            for (operand, slope) in &mut slopes[link.of.index()] {
                if link.by.is_none_or(|by| by == *operand) {
                    *slope *= match link.times {
                        Times::Number(factor) => factor,
                        Times::Result(node, power) => all[node.index()].powi(power),
                        Times::Sign(x) => {
                            if all[x.index()] < 0.0 {
                                -1.0
                            } else {
                                1.0
                            }
                        }
                        Times::Tanh(x, width) => (all[x.index()].abs() / width).tanh(),
                        Times::Squares(x, y) => all[x.index()].powi(2) + all[y.index()].powi(2),
                    };
                }
            }
        }
        let order = self.order(changes);
        for &of in &self.graph.value {
            let mut adjoint = vec![0.0; all.len()];
            let mut gradient = vec![0.0; self.inputs];
            adjoint[of.index()] = 1.0;
            for &node in order.iter().rev() {
                let slope = adjoint[node.index()];
                if slope == 0.0 {
                    continue;
                }
                if let Op::Input(k) = self.graph.op(node) {
                    gradient[*k] += slope;
                }
                for &(operand, by) in &slopes[node.index()] {
                    adjoint[operand.index()] += slope * by;
                }
            }
            answer.extend(gradient);
        }
        answer
    }
}

/// Results of the formula, and the powers of them that are multiplied.
pub(super) type Powers = Vec<(Node, i32)>;

/// The product of these powers of results.
pub(super) fn product(results: &[f64], powers: &[(Node, i32)]) -> f64 {
    powers.iter().map(|(node, power)| results[node.index()].powi(*power)).product()
}

/// A factor too much in the derivative of an operation by one of its operands, or by all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Link {
    pub(super) of: Node,
    pub(super) by: Option<Node>,
    pub(super) times: Times,
}

/// A factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Times {
    Number(f64),
    Result(Node, i32),
    /// The sign of a result.
    Sign(Node),
    /// The hyperbolic tangent of the size of a result, divided by a width.
    Tanh(Node, f64),
    /// The sum of the squares of two results.
    Squares(Node, Node),
}

/// Which numbers of an answer contain a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// All that follow from it.
    All,
    /// Those computed from the wrong result, in the value and in derivatives that are right otherwise.
    Used,
    /// The value alone.
    Value,
    /// The Jacobian alone.
    Jacobian,
}

/// Other inputs instead of those given: for every component where it comes from, and its factor.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Inputs {
    pub(super) from: Vec<(usize, f64)>,
    pub(super) is_single: bool,
    /// Whether derivatives are by the inputs as they were given.
    pub(super) by_given: bool,
}

impl Inputs {
    fn of(&self, inputs: &[f64]) -> Vec<f64> {
        let rounded = |x: f64| if self.is_single { f64::from(super::sample::single(x)) } else { x };
        self.from.iter().map(|&(place, factor)| rounded(inputs[place] * factor)).collect()
    }
}

/// For some numbers of an answer, the numbers from which each is summed, with factors.
pub(super) type Map = Vec<(usize, Vec<(usize, f64)>)>;

/// A program with mistakes.
#[derive(Clone, Debug)]
pub(super) struct Model {
    /// Every mistake in words.
    pub(super) what: Vec<String>,
    pub(super) inputs: Option<Inputs>,
    pub(super) changes: Vec<(Node, Change)>,
    pub(super) links: Vec<Link>,
    pub(super) scope: Scope,
    /// The numbers that are affected; all, if none are named.
    pub(super) only: Vec<usize>,
    pub(super) maps: Vec<Map>,
    /// Numbers that are multiplied by powers of results.
    pub(super) scaled: Vec<(Vec<usize>, Powers)>,
}

impl Model {
    /// Without a mistake, in words that come first.
    pub(super) fn new(what: String) -> Self {
        Self {
            what: vec![what],
            inputs: None,
            changes: Vec::new(),
            links: Vec::new(),
            scope: Scope::All,
            only: Vec::new(),
            maps: Vec::new(),
            scaled: Vec::new(),
        }
    }

    /// Whether numbers are only moved, or change their signs.
    pub(super) fn is_of_numbers_alone(&self) -> bool {
        let is_moved =
            |(_, terms): &(usize, Vec<(usize, f64)>)| matches!(terms.as_slice(), [(_, factor)] if factor.abs() == 1.0);
        !self.maps.is_empty() && self.maps.iter().flatten().all(is_moved)
    }

    /// A program that has the mistakes of both; `None` if they exclude each other.
    pub(super) fn and(&self, other: &Self) -> Option<Self> {
        let inputs = match (&self.inputs, &other.inputs) {
            (Some(_), Some(_)) => return None,
            (one, two) => one.clone().or_else(|| two.clone()),
        };
        let is_graph = |model: &Self| !model.changes.is_empty();
        if is_graph(self)
            && is_graph(other)
            && (self.scope != other.scope || self.only.is_empty() != other.only.is_empty())
            || other.changes.iter().any(|(node, _)| self.changes.iter().any(|(place, _)| place == node))
            || self.what == other.what
        {
            return None;
        }
        Some(Self {
            what: [self.what.clone(), other.what.clone()].concat(),
            inputs,
            changes: [self.changes.clone(), other.changes.clone()].concat(),
            links: [self.links.clone(), other.links.clone()].concat(),
            scope: if is_graph(other) { other.scope } else { self.scope },
            only: [self.only.clone(), other.only.clone()].concat(),
            maps: [self.maps.clone(), other.maps.clone()].concat(),
            scaled: [self.scaled.clone(), other.scaled.clone()].concat(),
        })
    }

    /// All numbers that the program would answer.
    pub(super) fn predicted(&self, book: Option<&Textbook>, formula: &dyn AnyFormula, sample: &Sample) -> Vec<f64> {
        let m = book.map_or_else(|| super::super::question::sizes(formula)[1], |book| book.graph.value.len());
        let n = sample.inputs.len();
        let has_jacobian = sample.right.len() == m + m * n;
        let mut answer = if self.changes.is_empty() && self.links.is_empty() && self.inputs.is_none() {
            sample.right.clone()
        } else {
            let there = self.inputs.as_ref().map(|inputs| inputs.of(&sample.inputs));
            let there = there.as_deref().unwrap_or(&sample.inputs);
            let computed = match book {
                Some(book) => {
                    let mut answer = book.answer(there, self, &self.changes, has_jacobian);
                    if matches!(self.scope, Scope::Value | Scope::Jacobian) && !self.changes.is_empty() && has_jacobian
                    {
                        let right = book.answer(there, self, &[], has_jacobian);
                        let part = if self.scope == Scope::Value { m..right.len() } else { 0..m };
                        answer[part.clone()].copy_from_slice(&right[part]);
                        if !self.only.is_empty() {
                            let others = (0..right.len()).filter(|place| !self.only.contains(place));
                            others.for_each(|place| answer[place] = right[place]);
                        }
                    }
                    Some(answer)
                }
                None => formula
                    .value_and_jacobian(there)
                    .ok()
                    .map(|(value, jacobian)| [value, if has_jacobian { jacobian } else { Vec::new() }].concat()),
            };
            let Some(mut answer) = computed else { return vec![f64::NAN; sample.right.len()] };
            if let Some(inputs) = self.inputs.as_ref().filter(|inputs| inputs.by_given && has_jacobian) {
                let mut by_given = vec![0.0; m * n];
                for i in 0..m {
                    for (k, &(from, factor)) in inputs.from.iter().enumerate() {
                        by_given[i * n + from] += answer[m + i * n + k] * factor;
                    }
                }
                answer[m..].copy_from_slice(&by_given);
            }
            answer
        };
        if let Some(book) = book.filter(|_| !self.scaled.is_empty()) {
            let results = book.results(&sample.inputs);
            for (places, powers) in &self.scaled {
                let factor = product(&results, powers);
                for &place in places {
                    // What becomes of zero times infinity depends on how it is computed.
                    let is_open = answer[place] == 0.0 && !factor.is_finite();
                    answer[place] = sample.found[place].filter(|_| is_open).unwrap_or(answer[place] * factor);
                }
            }
        }
        // Maps of different numbers do not follow each other.
        let right = answer.clone();
        let mut changed = vec![false; answer.len()];
        for map in &self.maps {
            let is_apart = map.iter().all(|(place, _)| !changed[*place]);
            let before = if is_apart { right.clone() } else { answer.clone() };
            for (place, terms) in map {
                answer[*place] = terms.iter().map(|&(from, factor)| before[from] * factor).sum();
                changed[*place] = true;
            }
        }
        answer
    }
}
