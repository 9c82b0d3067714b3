//! The search for kinks among the candidates of a formula's graph.

use super::candidate::{Candidate, candidates};
use super::jump::{Jump, Neighbourhood, SMOOTH};
use super::register::{BESIDE, Register, beside};
use super::solve::Solver;
use crate::Octuple;
use crate::formula::quantity::Domain;
use crate::number::power::power_of_two_below;
use crate::toolkit::graph::{Graph, Node, Op};
use crate::toolkit::verify::claim::{Claim, Deviation};
use crate::toolkit::verify::point::{Names, Point};
use crate::toolkit::verify::{Sampler, Subject, exact, golden, rounded};
use serde::{Deserialize, Serialize};

/// The number of points sought on every candidate.
const POINTS: usize = 3;
/// The number of starting points tried.
const STARTS: usize = 14;

/// The number of starting points that are first rounded to a single binary digit, so that solutions are doubles.
const SIMPLE: usize = 8;

/// The result of a search for kinks.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Search {
    /// Candidates where the formula might have no derivative: comparisons and guarded zeros of its graph.
    pub candidates: usize,
    /// Points that were found on them.
    pub points: usize,
    /// Candidates at which nothing jumps.
    pub smooth: usize,
    /// Candidates at which a registered kink holds wherever something jumps.
    pub registered: usize,
    /// Candidates on which no point was found, in words.
    pub not_reached: Vec<String>,
    /// The conditions of the registered kinks found from candidates.
    pub found: Vec<String>,
}

/// Searches a formula for kinks, and records unregistered ones in the claim.
pub(in crate::toolkit::verify) fn search(
    subject: &Subject,
    graph: &Graph,
    names: &Names,
    points: &[&Point<'_>],
    claim: &mut Claim,
) -> Search {
    let mut search = Search::default();
    // A kink that is met must be that of the candidate, not one that the starting point is on.
    let starts: Vec<_> = points.iter().filter(|point| point.kink.is_none()).map(|point| point.inputs.clone()).collect();
    let simple = starts.iter().take(SIMPLE).map(|start| start.iter().map(|&x| power_of_two_near(x)).collect());
    let simple =
        simple.filter(|start: &Vec<f64>| (subject.check)(start).is_ok() && subject.kink(&exact(start)).is_none());
    let starts: Vec<_> = simple.chain(starts.iter().cloned()).collect();
    let mut looking = Looking::new(subject, graph, names);
    let candidates = candidates(subject, graph, names);
    for candidate in &candidates {
        search.candidates += 1;
        let found = looking.points_on(candidate, &starts);
        search.points += found.len();
        if found.is_empty() {
            search.not_reached.push(candidate.words.clone());
            continue;
        }
        let inputs = looking.inputs_of(candidate);
        let mut is_smooth = true;
        for at in &found {
            let jump = looking.jump(&Neighbourhood::new(subject, at), &inputs, candidate.pairs.len() > 1);
            let is_settled = jump.is_smooth() && search.lacks(subject) == 0;
            let met = if is_settled { Vec::new() } else { looking.register.met(at) };
            if jump.is_smooth() || met.is_empty() {
                claim
                    .record(jump.size, SMOOTH, |size| looking.described(candidate, at, &inputs, Jump { size, ..jump }));
            }
            is_smooth &= jump.is_smooth();
            search.met(met);
        }
        *(if is_smooth { &mut search.smooth } else { &mut search.registered }) += 1;
    }
    // A kink with an additional condition may contain none of the first points.
    for starts in starts.chunks(STARTS).skip(1) {
        for candidate in &candidates {
            if search.lacks(subject) == 0 {
                return search;
            }
            for at in looking.points_on(candidate, starts) {
                search.points += 1;
                search.met(looking.register.met(&at));
            }
        }
    }
    search
}

impl Search {
    /// The number of registered kinks not yet found from any candidate.
    fn lacks(&self, subject: &Subject) -> usize {
        subject.kinks.len() - self.found.len()
    }

    /// Keeps the conditions of kinks that hold at a point.
    fn met(&mut self, conditions: Vec<String>) {
        let new: Vec<_> = conditions.into_iter().filter(|condition| !self.found.contains(condition)).collect();
        self.found.extend(new);
    }
}

struct Looking<'a> {
    subject: &'a Subject,
    graph: &'a Graph,
    names: &'a Names,
    /// All operations of the value.
    of_value: Vec<Node>,
    register: Register<'a>,
    /// Inputs that the formula rejects.
    refused: Vec<Vec<f64>>,
    directions: Sampler,
}

impl<'a> Looking<'a> {
    fn new(subject: &'a Subject, graph: &'a Graph, names: &'a Names) -> Self {
        let refused = (subject.invalid_cases)().into_iter().map(|case| case.inputs);
        Self {
            subject,
            graph,
            names,
            of_value: graph.needed(&graph.value),
            register: Register::new(subject),
            refused: refused.filter(|inputs| inputs.iter().all(|x| x.is_finite())).collect(),
            directions: Sampler::for_formula(subject.spec.id, 0),
        }
    }

    /// Points of the domain on a candidate, at which the value depends on it.
    fn points_on(&self, candidate: &Candidate, starts: &[Vec<f64>]) -> Vec<Vec<Octuple>> {
        let solver = Solver::new(self.graph, self.subject.inputs, candidate);
        // If the formula rejects such points, only `check` can tell whether a point is valid, and it takes doubles. A
        // single equality may also hold at other points, on both sides of which the formula is valid.
        let is_refused = self.refused.iter().any(|invalid| solver.is_on(invalid));
        let is_inside = |at: &[Octuple]| candidate.pairs.len() == 1 && self.is_valid_beside(at);
        let is_met = |at: &Vec<Octuple>| {
            let doubles = rounded(at);
            let is_certain = !is_refused || exact(&doubles) == *at || is_inside(at);
            let is_valid = (self.subject.check)(&doubles).is_ok() && is_certain;
            is_valid && {
                let all = self.graph.results(&doubles, self.of_value.iter().copied());
                let is_on_side = candidate.negative.is_none_or(|node| all[node.index()] < 0.0);
                is_on_side && self.graph.live(&self.graph.value, &all)[candidate.node.index()]
            }
        };
        let mut found: Vec<Vec<Octuple>> = Vec::new();
        for start in starts.iter().take(STARTS) {
            if let Some(at) = solver.near(start, is_met)
                && !found.contains(&at)
            {
                found.push(at);
            }
            if found.len() == POINTS {
                return found;
            }
        }
        if found.is_empty() && candidate.pairs.len() == 1 {
            found.extend(solver.between(starts, is_met));
        }
        found
    }

    /// Whether slightly larger and slightly smaller inputs are valid together.
    fn is_valid_beside(&self, at: &[Octuple]) -> bool {
        [BESIDE, -BESIDE].iter().all(|&part| (self.subject.is_valid)(&beside(at, part)))
    }

    /// The inputs that a candidate depends on.
    fn inputs_of(&self, candidate: &Candidate) -> Vec<usize> {
        let inputs = self.graph.needed(&[candidate.node]).into_iter().filter_map(|node| match self.graph.op(node) {
            Op::Input(k) => Some(*k),
            _ => None,
        });
        inputs.collect()
    }

    /// The largest jump along directions that are not special to any symmetry of the formula.
    fn jump(&mut self, neighbourhood: &Neighbourhood<'_>, inputs: &[usize], is_point: bool) -> Jump {
        let (inner, edge) = neighbourhood.sides(inputs);
        let [a, b] = [(); 2].map(|()| {
            let mut direction = vec![0.0; neighbourhood.dimensions()];
            for &k in &inner {
                direction[k] = self.directions.number(Domain::Between(-1.0, 1.0));
            }
            direction
        });
        let mut jump = Jump::none();
        if !inner.is_empty() {
            jump = jump.or_larger(neighbourhood.across(&a)).or_larger(neighbourhood.across(&b));
        }
        if is_point && inner.len() > 1 {
            jump = jump.or_larger(neighbourhood.additive([&a, &b]));
        }
        for (k, sign) in edge {
            jump = jump.or_larger(neighbourhood.inward(&neighbourhood.towards(k, sign)));
        }
        jump
    }

    /// Describes the largest jump of the derivative, with respect to the input that shows it best. There may be none,
    /// if only the derivative along a sum of directions differs from the sum of derivatives.
    fn described(&self, candidate: &Candidate, at: &[Octuple], inputs: &[usize], jump: Jump) -> Deviation {
        let neighbourhood = Neighbourhood::new(self.subject, at);
        let (inner, edge) = neighbourhood.sides(inputs);
        let across = inner.iter().map(|&k| ((k, 1.0), neighbourhood.across(&neighbourhood.axis(k))));
        let inward = edge.iter().map(|&(k, sign)| ((k, sign), neighbourhood.inward(&neighbourhood.towards(k, sign))));
        let most = across.chain(inward).max_by(|(_, a), (_, b)| a.size.total_cmp(&b.size));
        let (entry, sides) = match most.filter(|(_, most)| !most.is_smooth() || jump.is_smooth()) {
            Some(((input, sign), Jump { output, sides, .. })) => {
                let entry = self.names.entry(output * self.names.inputs.len() + input);
                (entry, sides.map(|slope| slope / (neighbourhood.unit(input) * sign)))
            }
            None => (format!("∂{} along the sum of two directions", self.names.outputs[jump.output]), jump.sides),
        };
        let [expected, found] = sides.map(Octuple::to_f64);
        let point = format!("where {}", candidate.words);
        let inputs = golden::named(self.subject.inputs, &rounded(at)).into();
        Deviation { size: jump.size, entry, point, found, expected, inputs }
    }
}

/// A number of the same sign with a single binary digit, whose products and sums are doubles; 0 for 0.
fn power_of_two_near(x: f64) -> f64 {
    power_of_two_below(x)[0].copysign(x)
}

#[cfg(test)]
mod tests;
