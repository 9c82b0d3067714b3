//! A program that differs from the formula in one operation: a term omitted, a sign reversed, a branch always taken.

use super::evidence::{Evidence, LEAST, Sample};
use super::mistakes::{Mistake, mistakes};
use jointproof::Octuple;
use jointproof::toolkit::graph::{Graph, Instead, Node, Op};
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// The largest number of operations of a graph in which mistakes are searched for, to limit the time.
const LONGEST: usize = 6000;
/// The number of candidates found in doubles that are verified in 237 bits.
const CANDIDATES: usize = 20;

/// How a mistake affects the Jacobian.
#[derive(Clone, Copy, PartialEq)]
enum Jacobian {
    /// The Jacobian contains the mistake.
    Altered,
    /// It is the derivative of the wrong value.
    Derived,
}

/// The mistake that explains these numbers, in words.
pub(super) fn cause(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let graph = evidence.court.formula.graph().ok()?;
    let samples = evidence.off_samples(off);
    if samples.len() < LEAST || graph.ops().len() > LONGEST {
        return None;
    }
    let m = graph.value.len();
    let results: Vec<Node> = graph.value.iter().chain(&graph.jacobian).copied().collect();
    // An automatic Jacobian is not in the graph; wrong entries of it may follow from a value that is.
    let wanted: Vec<Node> = off.iter().filter_map(|&place| results.get(place).copied()).collect();
    if wanted.is_empty() {
        return None;
    }
    let has_both = off.iter().any(|&place| place < m) && off.iter().any(|&place| place >= m);
    let mistakes = mistakes(&graph, evidence.court.formula.inputs(), &wanted);
    let screens: Vec<_> = samples[..LEAST].iter().map(|sample| Screen::new(evidence, &graph, sample)).collect();
    // Derivatives are not screened in doubles: they follow from a value that fits.
    let screened = |mistake: &&Mistake| {
        let value: Vec<_> = off.iter().copied().filter(|&place| !has_both || place < m).collect();
        screens.iter().all(|screen| screen.fits(evidence, &graph, mistake, &value, &results))
    };
    let mut fitting: Vec<&Mistake> = (&mistakes).into_par_iter().filter(screened).collect();
    fitting.sort_by_key(|mistake| mistake.sort);
    let ways: &[Jacobian] = match (has_both, graph.jacobian.is_empty()) {
        (false, _) => &[Jacobian::Altered],
        (true, false) => &[Jacobian::Altered, Jacobian::Derived],
        (true, true) => &[Jacobian::Derived],
    };
    let is_so = |mistake: &&&Mistake| {
        let altered = graph.altered(mistake.place, &mistake.instead);
        ways.iter().any(|&way| explains(evidence, off, &altered, way))
    };
    fitting.iter().take(CANDIDATES).find(is_so).map(|mistake| mistake.what.clone())
}

/// A sample, with all results of the graph there in doubles.
struct Screen<'a> {
    sample: &'a Sample,
    inputs: &'a [f64],
    all: Vec<f64>,
}

impl<'a> Screen<'a> {
    fn new(evidence: &Evidence<'a>, graph: &Graph, sample: &'a Sample) -> Self {
        let inputs = sample.inputs(evidence);
        let nodes: Vec<_> = graph.needed(&[graph.value.as_slice(), &graph.jacobian].concat());
        Self { sample, inputs, all: graph.results(inputs, nodes) }
    }

    /// Whether the wrong numbers are approximately those that the mistake gives.
    fn fits(&self, evidence: &Evidence<'_>, graph: &Graph, mistake: &Mistake, off: &[usize], results: &[Node]) -> bool {
        let first = mistake.place.index();
        let changed = match &mistake.instead {
            Instead::Op(op) => op.result(self.inputs, &self.all),
            Instead::Result(node) => self.all[node.index()],
        };
        if changed == self.all[first] {
            // Nothing changes here, so that wrong numbers remain unexplained.
            return off.iter().all(|&place| !evidence.is_off(self.sample, place));
        }
        let mut all = self.all.clone();
        all[first] = changed;
        for (place, op) in graph.ops().iter().enumerate().skip(first + 1) {
            if !matches!(op, Op::Input(_) | Op::Number(_)) {
                all[place] = op.result(self.inputs, &all);
            }
        }
        off.iter().all(|&place| match (self.sample.found[place], &self.sample.expected[place]) {
            (Some(found), Some(known)) => {
                let predicted = all[results[place].index()];
                known.with(predicted.into()).eta(found) <= 1e7
            }
            _ => true,
        })
    }
}

/// Whether an altered graph reproduces the numbers found, in 237 bits and at all samples.
fn explains(evidence: &Evidence<'_>, off: &[usize], altered: &Graph, way: Jacobian) -> bool {
    let m = altered.value.len();
    let all_results: Vec<Node> = altered.value.iter().chain(&altered.jacobian).copied().collect();
    let wanted = off.iter().filter_map(|&place| all_results.get(place).copied());
    let nodes = altered.needed(&wanted.chain(altered.value.clone()).collect::<Vec<_>>());
    let fits = |sample: &Sample| {
        let inputs: Vec<Octuple> = sample.inputs(evidence).iter().map(|&x| x.into()).collect();
        let all = altered.results(&inputs, nodes.iter().copied());
        let derived = |place: usize| {
            let value = altered.value[(place - m) / inputs.len()];
            let gradient = altered.gradient(value, &altered.needed(&[value]), &all, inputs.len());
            gradient[(place - m) % inputs.len()]
        };
        off.iter().all(|&place| match (sample.found[place], &sample.expected[place]) {
            (Some(found), Some(known)) => {
                let predicted = match way {
                    Jacobian::Derived if place >= m => derived(place),
                    _ => all[all_results[place].index()],
                };
                // The omitted part may determine the condition of the rest.
                known.with(predicted).eta(found) <= 1000.0 + evidence.tolerance(place)
            }
            _ => true,
        })
    };
    evidence.samples.par_iter().all(fits)
}
