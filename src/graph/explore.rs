//! Every way in which the comparisons of a formula can come out.

use super::join::join;
use super::node::{Graph, Node};
use super::recorder::{self, Escape};
use super::traced::Traced;
use crate::formula::{Fields, Formula, entries, typed};
use std::fmt;

/// More runs than any formula needs that can be printed.
const MOST_RUNS: usize = 4096;

/// Why a formula was not recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotRecorded {
    /// The value of a number that depends on the inputs leaves the graph.
    Value,
    /// It calls a function that the graph does not know.
    Function(&'static str),
    /// Its comparisons come out in more ways than this.
    Ways(usize),
    /// It does not end whatever comparisons say.
    Endless,
    /// It panics, whatever comparisons say.
    Panics,
}

impl fmt::Display for NotRecorded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value => f.write_str("the value of a number that depends on the inputs leaves the graph as a double"),
            Self::Function(name) => write!(f, "it calls {name}, which the graph does not know"),
            Self::Ways(most) => write!(f, "its comparisons come out in more than {most} ways"),
            Self::Endless => f.write_str("it does not end where comparisons come out as they like"),
            Self::Panics => f.write_str("it panics where comparisons come out as they like"),
        }
    }
}

impl std::error::Error for NotRecorded {}

/// The graph of a formula.
///
/// # Errors
/// What in the formula cannot be written down.
pub fn record<F: Formula>() -> Result<Graph, NotRecorded> {
    let run = |inputs: &[Traced]| {
        let (value, jacobian) = F::linearized(&typed::<_, F::Inputs<Traced>>(inputs));
        value.components().into_iter().chain(entries(&jacobian)).collect()
    };
    let mut explorer = Explorer { graph: Graph::default(), runs: 0, run: &run, inputs: F::Inputs::<f64>::LEN, why: None };
    let results = explorer.from(Vec::new())?;
    let results = results.ok_or(explorer.why.unwrap_or(NotRecorded::Panics))?;
    let mut graph = explorer.graph;
    let (value, jacobian) = results.split_at(F::Outputs::<f64>::LEN);
    (graph.value, graph.jacobian) = (value.to_vec(), jacobian.to_vec());
    Ok(graph.pruned())
}

struct Explorer<'a> {
    graph: Graph,
    runs: usize,
    run: &'a dyn Fn(&[Traced]) -> Vec<Traced>,
    inputs: usize,
    /// Why a side was given up.
    why: Option<NotRecorded>,
}

/// The results of a side; `None` of one that nothing can reach, since the formula does not get through it.
type Side = Option<Vec<Node>>;

impl Explorer<'_> {
    /// The results where the first comparisons come out as the script says, and the others in both ways.
    fn from(&mut self, script: Vec<bool>) -> Result<Side, NotRecorded> {
        self.runs += 1;
        if self.runs > MOST_RUNS {
            return Err(NotRecorded::Ways(MOST_RUNS));
        }
        let decided = script.len();
        let (inputs, run) = (self.inputs, self.run);
        let (recorder, results) = recorder::record(std::mem::take(&mut self.graph), script, || {
            let inputs: Vec<_> = (0..inputs).map(Traced::input).collect();
            run(&inputs).into_iter().map(Traced::node).collect::<Vec<_>>()
        });
        self.graph = recorder.graph;
        let mut side = match results {
            Ok(results) => Some(results),
            Err(payload) => match payload.downcast_ref::<Escape>() {
                Some(Escape::Value) => return Err(NotRecorded::Value),
                Some(Escape::Function(name)) => return Err(NotRecorded::Function(name)),
                Some(Escape::Endless) => {
                    self.why = Some(NotRecorded::Endless);
                    None
                }
                None => None,
            },
        };
        let answers: Vec<_> = recorder.taken.iter().map(|&(_, answer)| answer).collect();
        for (k, &(condition, answer)) in recorder.taken.iter().enumerate().skip(decided).rev() {
            let mut other = answers[..k].to_vec();
            other.push(!answer);
            let other = self.from(other)?;
            let [yes, no] = if answer { [side, other] } else { [other, side] };
            side = match (yes, no) {
                (Some(yes), Some(no)) => Some(join(&mut self.graph, condition, &yes, &no)),
                (one, None) | (None, one) => one,
            };
        }
        Ok(side)
    }
}
