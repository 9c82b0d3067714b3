//! Results of an element whose conditions are violated, as an iteration of Newton's method hands them in.
//!
//! Where its conditions hold, the rows of an element are their derivative. Where they do not, an element may keep the rows that it has
//! where they hold, as SLIDER does; somebody else's may have the derivative at the state itself, and forces of its own by these. All
//! lead to the same solution.

use jointproof::Octuple;
use jointproof::catalog::AnyElement;
use jointproof::toolkit::graph::{Extremes, Graph, Node};
use std::ops::Range;

/// The conditions of an element whose nodes have positions alone, and their derivatives.
pub(super) struct Conditions {
    graph: Graph,
    needed: Vec<Node>,
    of: Vec<Node>,
    unknowns: usize,
}

/// A step between two states, in 237 bits.
const STEP: f64 = 1e-30;

impl Conditions {
    /// Those of an element with so many conditions and unknowns, which are the first inputs; `None` if there are none or they cannot
    /// be recorded.
    pub(super) fn new(element: &dyn AnyElement, conditions: usize, unknowns: usize) -> Option<Self> {
        let graph = element.graph(false, Extremes::Nan).ok()?;
        let conditions = graph.value.get(..conditions).filter(|conditions| !conditions.is_empty())?.to_vec();
        let needed = graph.needed(&conditions);
        Some(Self { graph, needed, of: conditions, unknowns })
    }

    /// The derivatives of the conditions by the unknowns, condition by condition.
    fn rows(&self, inputs: &[Octuple]) -> Vec<Vec<Octuple>> {
        let all = self.graph.results(inputs, self.needed.iter().copied());
        let gradient = |&of: &Node| self.graph.gradient(of, &self.needed, &all, inputs.len());
        self.of.iter().map(|of| gradient(of)[..self.unknowns].to_vec()).collect()
    }

    /// The results of the element with the derivative of its conditions for their rows, and those of one whose forces are by these
    /// rows, too. The multipliers follow the unknowns among the inputs.
    pub(super) fn otherwise(&self, inputs: &[f64], results: &[f64]) -> [Vec<f64>; 2] {
        let (m, n) = (self.of.len(), self.unknowns);
        let exact: Vec<_> = inputs.iter().copied().map(Octuple::from).collect();
        let rows = self.rows(&exact);
        let multipliers = &exact[n..n + m];
        let forces = |rows: &[Vec<Octuple>]| -> Vec<Octuple> {
            let force =
                |k: usize| rows.iter().zip(multipliers).fold(Octuple::from(0.0), |sum, (row, &by)| sum + row[k] * by);
            (0..n).map(force).collect()
        };
        let flat = |rows: &[Vec<Octuple>]| rows.iter().flatten().map(|x| x.to_f64()).collect::<Vec<_>>();
        let put = |results: &mut [f64], at: Range<usize>, with: &[f64]| results[at].copy_from_slice(with);
        let [of_forces, of_stiffness] = [m + m * n, m + m * n + n];
        let by_multipliers = of_stiffness + n * n;
        let mut own = results.to_vec();
        put(&mut own, m..of_forces, &flat(&rows));
        let mut all = own.clone();
        put(&mut all, of_forces..of_stiffness, &flat(&[forces(&rows)]));
        for k in 0..n {
            let at = |step: f64| {
                let mut moved = exact.clone();
                moved[k] += Octuple::from(step);
                forces(&self.rows(&moved))
            };
            let [before, after] = [at(-STEP), at(STEP)];
            for (row, (before, after)) in before.into_iter().zip(after).enumerate() {
                all[of_stiffness + row * n + k] = ((after - before) / (2.0 * STEP)).to_f64();
            }
            for (condition, row) in rows.iter().enumerate() {
                all[by_multipliers + k * m + condition] = row[k].to_f64();
            }
        }
        [own, all]
    }
}
