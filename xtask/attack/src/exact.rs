//! The backward error of one result in 237 bits, without computing those that nobody asks for.

use crate::pass::{Pass, U};
use crate::target::Target;
use jointproof::Octuple;
use jointproof::toolkit::graph::{Graph, Node, Op, Unary};
use num_traits::Signed;

/// η of a target at inputs, given the pass forwards in `f64` there. Where the double takes another branch than the exact
/// number, since they are within roundings of a kink, the result may be that of either branch.
pub(crate) fn eta(graph: &Graph, target: &Target, inputs: &[f64], pass: &Pass) -> f64 {
    let inputs: Vec<_> = inputs.iter().map(|&x| Octuple::from(x)).collect();
    let exact = results(graph, target, &inputs, None);
    let eta = eta_beside(graph, target, &inputs, pass, &exact);
    let differs = |node: &Node| pass.at(*node) != exact[node.index()].to_f64();
    if !target.needed.iter().any(|node| matches!(graph.op(*node), Op::Compare(..)) && differs(node)) {
        return eta;
    }
    eta.min(eta_beside(graph, target, &inputs, pass, &results(graph, target, &inputs, Some(pass))))
}

/// All results in 237 bits, with the comparisons as they come out there or, if given, in a pass in `f64`.
fn results(graph: &Graph, target: &Target, inputs: &[Octuple], forced: Option<&Pass>) -> Vec<Octuple> {
    let mut all = vec![Octuple::from(f64::NAN); graph.ops().len()];
    for &node in &target.needed {
        all[node.index()] = match (graph.op(node), forced) {
            (Op::Compare(..), Some(pass)) => pass.at(node).into(),
            (op, _) => op.result(inputs, &all),
        };
    }
    all
}

fn eta_beside(graph: &Graph, target: &Target, inputs: &[Octuple], pass: &Pass, all: &[Octuple]) -> f64 {
    let square = |all: &[Octuple]| all.iter().fold(Octuple::from(0.0), |sum, &x| sum + x * x);
    let size = |(node, needed): &(Node, Vec<Node>)| {
        let gradient = graph.gradient(*node, needed, all, inputs.len());
        let parts = pass.fields.iter().cloned();
        let terms = parts.map(|part| Unary::Root.of(square(&gradient[part.clone()]) * square(&inputs[part])));
        terms.fold(all[node.index()].abs(), |sum, term| sum + term)
    };
    let own = size(&target.own);
    let size = target.beside.iter().map(size).fold(own, |most, size| if size > most { size } else { most });
    let node = target.own.0;
    let mut deviation = (Octuple::from(pass.at(node)) - all[node.index()]).abs();
    if target.is_angle && deviation > Octuple::PI {
        deviation = (deviation - Octuple::PI * 2.0).abs();
    }
    // Half the smallest subnormal, since no double is closer than that to an exact result.
    (deviation / (size * U + Octuple::from(f64::from_bits(1)) * 0.5)).to_f64()
}
