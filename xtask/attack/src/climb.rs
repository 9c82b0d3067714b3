//! The search itself: which result, from where, how far.

use crate::exact;
use crate::moves::{Around, Reach};
use crate::pass::Pass;
use crate::space::{Dice, Space};
use crate::target::{Target, fields, targets};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::graph::{Graph, NotRecorded};
use jointproof::toolkit::verify::{Claim, Options};
use std::time::{Duration, Instant};

/// When a search ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Effort {
    /// After this time.
    Time(Duration),
    /// After so many evaluations, wherever it runs.
    Evaluations(u64),
}

/// What a search has found.
#[derive(Clone, Debug)]
pub struct Attack {
    /// The claims about the bounds of η, of the value and of a Jacobian in closed form, with the worst point found.
    pub claims: Vec<Claim>,
    /// For each of them, the largest E/S found: how large a bound must be for all roundings that are possible there.
    pub first_order: Vec<f64>,
    /// The number of points evaluated.
    pub evaluations: u64,
}

impl Attack {
    /// Whether no bound is refuted.
    pub fn holds(&self) -> bool {
        self.claims.iter().all(|claim| claim.failures == 0)
    }
}

/// Random points from which the search starts, beside golden cases and points on and near kinks.
const STARTS: usize = 60;
/// Starts that are tried for every result at first.
const TRIED: usize = 40;
/// The best points kept for each result.
const KEPT: usize = 4;
/// The steps of one climb in `f64`, and in 237 bits.
const STEPS: [usize; 2] = [300, 12];
/// A point is confirmed if it raises the worst η by this factor.
const RAISE: f64 = 1.002;

/// What is climbed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Height {
    /// E/S.
    Most,
    /// The error by the roundings that occur, relative to u S.
    Actual,
    /// η in 237 bits.
    Exact,
}

/// Searches the largest η of a formula.
///
/// # Errors
/// The reason why the formula cannot be recorded.
pub fn attack(formula: &dyn AnyFormula, effort: Effort, seed: u64) -> Result<Attack, NotRecorded> {
    let graph = formula.graph()?;
    let space = Space::of(formula);
    let targets = targets(formula, &graph);
    let mut dice = Dice::of(formula.spec().id, seed);
    let options = Options { samples: STARTS, seed };
    let points = formula.judge().points(&options).into_iter().map(|(_, inputs)| inputs);
    let pool: Vec<_> = points.filter(|inputs| space.has(inputs) && formula.value(inputs).is_ok()).collect();
    let states = targets.iter().map(|_| State::default()).collect();
    let pass = Pass::over(&graph, fields(formula));
    let claims = pool.first().and_then(|inputs| formula.eta_at(inputs).ok()).unwrap_or_default();
    let mut climb = Climb {
        formula,
        graph: &graph,
        space: &space,
        targets: &targets,
        pool: &pool,
        states,
        pass,
        first_order: vec![0.0; claims.len()],
        claims,
        evaluations: 0,
    };
    if !targets.is_empty() && !pool.is_empty() {
        climb.run(effort, &mut dice);
    }
    let Climb { claims, first_order, evaluations, .. } = climb;
    Ok(Attack { claims, first_order, evaluations })
}

/// The best points of a result, the best one first, with their η.
#[derive(Default)]
struct State {
    kept: Vec<(f64, Vec<f64>)>,
}

struct Climb<'a> {
    formula: &'a dyn AnyFormula,
    graph: &'a Graph,
    space: &'a Space,
    targets: &'a [Target],
    pool: &'a [Vec<f64>],
    states: Vec<State>,
    pass: Pass<'a>,
    claims: Vec<Claim>,
    first_order: Vec<f64>,
    evaluations: u64,
}

impl Climb<'_> {
    fn run(&mut self, effort: Effort, dice: &mut Dice) {
        let start = Instant::now();
        let targets = self.targets.len();
        let mut order = 0;
        loop {
            let is_over = match effort {
                Effort::Time(time) => start.elapsed() >= time,
                Effort::Evaluations(most) => self.evaluations >= most,
            };
            if is_over {
                return;
            }
            if order < targets {
                self.start(order, dice);
                order += 1;
                continue;
            }
            // Half of the time any result, else the most promising of a few.
            let best = |k: &usize| self.states[*k].kept.first().map_or(0.0, |kept| kept.0 / self.bound(*k));
            let drawn = [(); 4].map(|()| dice.below(targets));
            let target = match dice.below(2) {
                0 => drawn[0],
                _ => drawn.into_iter().max_by(|a, b| best(a).total_cmp(&best(b))).unwrap_or(0),
            };
            self.climb_once(target, dice);
        }
    }

    /// The index of the claim about a result.
    fn claim(&self, target: usize) -> usize {
        usize::from(self.targets[target].is_jacobian)
    }

    fn bound(&self, target: usize) -> f64 {
        self.claims[self.claim(target)].bound
    }

    /// Keeps the best of some starts.
    fn start(&mut self, target: usize, dice: &mut Dice) {
        for _ in 0..TRIED {
            let Some(inputs) = dice.one_of(self.pool).cloned() else { return };
            let height = self.height(target, &inputs, Height::Actual);
            self.keep(target, height, inputs);
        }
    }

    fn climb_once(&mut self, target: usize, dice: &mut Dice) {
        let kept = dice.one_of(&self.states[target].kept).map(|kept| kept.1.clone());
        let fresh = dice.one_of(self.pool).cloned().unwrap_or_default();
        let [many, few] = STEPS;
        let (mut inputs, plan): (_, &[_]) = match (dice.below(10), kept) {
            (0..4, Some(kept)) => (kept, &[(Height::Actual, Reach::Near, many)]),
            (4, Some(kept)) => (kept, &[(Height::Exact, Reach::Near, few)]),
            (5, Some(kept)) => (kept, &[(Height::Most, Reach::Far, many), (Height::Actual, Reach::Near, many)]),
            (6, _) => (fresh, &[(Height::Exact, Reach::Far, few)]),
            _ => (fresh, &[(Height::Most, Reach::Far, many), (Height::Actual, Reach::Near, many)]),
        };
        for &(height, reach, steps) in plan {
            self.climb(target, &mut inputs, height, reach, steps, dice);
        }
        let eta = self.height(target, &inputs, Height::Exact);
        let claim = self.claim(target);
        let worst = self.claims[claim].worst.as_ref().map_or(0.0, |worst| worst.size);
        if eta > worst * RAISE
            && let Ok(claims) = self.formula.eta_at(&inputs)
        {
            for (known, found) in self.claims.iter_mut().zip(claims) {
                if size(&found) > size(known) {
                    *known = found;
                }
            }
        }
        self.keep(target, eta, inputs);
    }

    fn climb(
        &mut self,
        target: usize,
        inputs: &mut Vec<f64>,
        height: Height,
        reach: Reach,
        steps: usize,
        dice: &mut Dice,
    ) {
        let around = Around { graph: self.graph, space: self.space, target: &self.targets[target] };
        let mut best = self.height(target, inputs, height);
        for _ in 0..steps {
            let mut moved = inputs.clone();
            around.step(&mut moved, &mut self.pass, reach, dice);
            let found = self.height(target, &moved, height);
            if found >= best && found.is_finite() {
                (best, *inputs) = (found, moved);
            }
        }
        if height == Height::Most && best > self.first_order[self.claim(target)] {
            let claim = self.claim(target);
            self.first_order[claim] = best;
        }
    }

    /// The height of a point; −∞ if it is refused or beyond the stated sizes, and where nothing can be said in `f64`.
    fn height(&mut self, target: usize, inputs: &[f64], height: Height) -> f64 {
        self.evaluations += 1;
        let bound = self.bound(target);
        let target = &self.targets[target];
        if !self.space.has(inputs) {
            return f64::NEG_INFINITY;
        }
        self.pass.forwards(&target.needed, inputs);
        let is_refused = self.graph.refusal.is_some_and(|refusal| self.pass.at(refusal) != 0.0);
        if is_refused || !self.pass.at(target.own.0).is_finite() {
            return f64::NEG_INFINITY;
        }
        let apart = self.formula.spec().apart;
        if height == Height::Exact {
            if !self.pass.is_apart(target, apart) {
                return f64::NEG_INFINITY;
            }
            let eta = exact::eta(self.graph, target, inputs, &self.pass);
            return if eta.is_finite() { eta } else { f64::NEG_INFINITY };
        }
        let errors = self.pass.errors(target.own.0, &target.own.1, height == Height::Actual);
        let mut size = errors.size;
        for (node, needed) in &target.beside {
            size = size.max(self.pass.errors(*node, needed, false).size);
        }
        let found = if height == Height::Most { errors.most } else { errors.actual.abs() } / size;
        // At the ends of the range, what is possible to first order cannot be told in `f64`.
        let is_trusted = height != Height::Most || !errors.is_rough;
        let is_sound = is_trusted && found.is_finite() && size > f64::MIN_POSITIVE / f64::EPSILON;
        // Few points are so high that the distance from singular ones matters.
        if is_sound && (found < bound / 2.0 || self.pass.is_apart(target, apart)) { found } else { f64::NEG_INFINITY }
    }

    fn keep(&mut self, target: usize, eta: f64, inputs: Vec<f64>) {
        let kept = &mut self.states[target].kept;
        if eta > f64::NEG_INFINITY && kept.iter().all(|known| known.0 != eta) {
            kept.push((eta, inputs));
            kept.sort_by(|a, b| b.0.total_cmp(&a.0));
            kept.truncate(KEPT);
        }
    }
}

/// The worst η of a claim.
fn size(claim: &Claim) -> f64 {
    claim.worst.as_ref().map_or(0.0, |worst| worst.size)
}
