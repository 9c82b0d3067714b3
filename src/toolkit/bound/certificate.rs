//! Certificates: found with the help of a linear programme, checked without.

use super::field::{Rational, to_f64};
use super::parts::{Atom, Inequality, Obstacle, Parts, Rule};
use super::way::{Answers, MOST_WAYS, Way, are_all, ways};
use crate::formula::Field;
use crate::toolkit::graph::{Graph, Node, bounds};
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, Signed, Zero};
use std::collections::BTreeMap;

/// Amounts are rounded to fractions that are as near.
const NEAR: f64 = 1e-7;
/// Their denominators are at most this.
const LARGEST: i128 = 100_000;
/// A rule used less than this was used by a rounding error of the linear programme.
const NOTHING: f64 = 1e-7;

/// The proof of a bound on one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The way.
    pub way: Answers,
    /// The bound of η.
    pub bound: Rational,
    /// Whether what is not of the first order has a relative size of roundings, too.
    pub is_first_order: bool,
    /// How often each rule is used.
    pub steps: Vec<(Rule, Rational)>,
}

/// A linear programme: amounts of rules, none below 0, for which the largest ratio of what a part carries and of its room is least. A
/// part without room may carry nothing.
#[derive(Clone, Debug, Default)]
pub struct Programme {
    /// What each part is loaded with.
    pub load: Vec<f64>,
    /// The room of each part.
    pub room: Vec<f64>,
    /// What each rule adds to parts for each unit of its amount.
    pub rules: Vec<Vec<(usize, f64)>>,
}

/// The certificates of a result, one for each way through its branches; `solve` solves the linear programmes.
///
/// # Errors
/// Why nothing is proved.
pub fn prove(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    solve: impl Fn(&Programme) -> Option<Vec<f64>>,
) -> Result<Vec<Certificate>, String> {
    let ways = ways(graph, result).ok_or_else(|| said(graph, &Obstacle::Ways))?;
    ways.into_iter().map(|answers| prove_on(graph, inputs, result, answers, &solve)).collect()
}

fn prove_on(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    answers: Answers,
    solve: &impl Fn(&Programme) -> Option<Vec<f64>>,
) -> Result<Certificate, String> {
    let way = way(graph, &answers, result)?;
    let mut parts = parts(&way, inputs)?;
    let is_first_order = parts.is_first_order;
    let mut steps = Vec::new();
    if !parts.load.is_empty() {
        let rules = parts.rules();
        if let Some(obstacle) = parts.obstacle(&rules) {
            return Err(said(graph, &obstacle));
        }
        let amounts = solve(&programme(&parts, &rules)).ok_or("the linear programme has no solution")?;
        let used = rules.into_keys().zip(amounts).filter(|&(_, amount)| amount > NOTHING);
        steps.extend(used.map(|(rule, amount)| (rule, fraction(amount))));
    }
    let bound =
        added_up(&mut parts, &steps).map_err(|error| format!("rounding the linear programme's solution: {error}"))?;
    Ok(Certificate { way: answers, bound, is_first_order, steps })
}

/// Checks that certificates prove their bounds of a result, together on all ways.
///
/// # Errors
/// What is wrong with which of them.
pub fn check(graph: &Graph, inputs: &[Field], result: Node, certificates: &[Certificate]) -> Result<(), String> {
    let ways: Vec<_> = certificates.iter().map(|certificate| certificate.way.clone()).collect();
    if !are_all(&ways) {
        return Err("there is a way without a certificate".into());
    }
    for certificate in certificates {
        if certificate.way.keys().any(|node| node.index() >= graph.ops().len()) {
            return Err("its way names an operation that is not there".into());
        }
        let way = way(graph, &certificate.way, result)?;
        let mut parts = parts(&way, inputs)?;
        let needed = added_up(&mut parts, &certificate.steps)?;
        if needed > certificate.bound {
            return Err(format!("its steps prove {needed}, not {}", certificate.bound));
        }
        if certificate.is_first_order && !parts.is_first_order {
            return Err("it says that the first order is all that counts".into());
        }
    }
    Ok(())
}

fn way<'a>(graph: &'a Graph, answers: &'a Answers, result: Node) -> Result<Way<'a>, String> {
    Way::new(graph, answers, result)
        .map_err(|open| format!("the way does not say how comparison {} comes out", open.index()))
}

fn parts<'a>(way: &'a Way<'a>, inputs: &[Field]) -> Result<Parts<'a>, String> {
    let bounds: Vec<_> = inputs.iter().flat_map(|field| vec![bounds(field.quantity.domain); field.len()]).collect();
    Parts::new(way, &bounds).map_err(|obstacle| said(way.graph, &obstacle))
}

/// The obstacle in words.
fn said(graph: &Graph, obstacle: &Obstacle) -> String {
    match obstacle {
        Obstacle::Ways => format!("its comparisons come out in more than {MOST_WAYS} ways"),
        Obstacle::Search => "it needs the result of a search".into(),
        Obstacle::Roots => "its roots do not exist at the points where parts are compared".into(),
        Obstacle::Rounding(node) => {
            format!("no rule bounds the rounding of operation {}, {}", node.index(), graph.op(*node).name())
        }
    }
}

fn programme(parts: &Parts, rules: &BTreeMap<Rule, Inequality>) -> Programme {
    let double = |x: &Rational| to_f64(*x);
    let mut programme = Programme { load: vec![0.0; parts.count()], room: vec![0.0; parts.count()], rules: Vec::new() };
    parts.load.iter().for_each(|(&atom, (load, _))| programme.load[atom] = double(load));
    parts.room.iter().for_each(|(&atom, room)| programme.room[atom] = double(room));
    programme.rules.extend(rules.values().map(|rule| {
        let mut adds: BTreeMap<Atom, f64> = BTreeMap::new();
        rule.left.iter().for_each(|(factor, atom)| *adds.entry(*atom).or_default() -= double(factor));
        rule.right.iter().for_each(|(factor, atom)| *adds.entry(*atom).or_default() += double(factor));
        adds.into_iter().collect()
    }));
    programme
}

/// The bound that these steps prove.
fn added_up(parts: &mut Parts, steps: &[(Rule, Rational)]) -> Result<Rational, String> {
    let mut carried: BTreeMap<Atom, Rational> = parts.load.iter().map(|(&atom, &(load, _))| (atom, load)).collect();
    let too_large = || "a sum of its amounts has too many digits".to_owned();
    for (name, amount) in steps {
        let rule = parts.inequality(name)?;
        if amount.is_negative() {
            return Err(format!("the amount of {name:?} is negative: {amount}"));
        }
        let adds = rule.left.iter().map(|&(factor, atom)| (-factor, atom)).chain(rule.right.iter().copied());
        for (factor, atom) in adds {
            let carried = carried.entry(atom).or_default();
            let more = factor.checked_mul(amount).ok_or_else(too_large)?;
            *carried = carried.checked_add(&more).ok_or_else(too_large)?;
        }
    }
    let mut bound = Rational::zero();
    for (atom, carried) in carried.into_iter().filter(|(_, carried)| carried.is_positive()) {
        let room = parts
            .room
            .get(&atom)
            .ok_or_else(|| format!("{carried} of a part is left that is none of inputs and result"))?;
        bound = bound.max(carried.checked_div(room).ok_or_else(too_large)?);
    }
    Ok(bound)
}

/// The fraction with the smallest denominator that is as near as can be asked.
fn fraction(x: f64) -> Rational {
    let (mut rest, mut last, mut this) = (x, (0_i128, 1_i128), (1_i128, 0_i128));
    loop {
        #[expect(clippy::cast_possible_truncation, reason = "amounts are small")]
        let whole = rest.floor() as i128;
        let next = (whole * this.0 + last.0, whole * this.1 + last.1);
        if next.1 > LARGEST {
            return Rational::new(this.0, this.1);
        }
        (last, this) = (this, next);
        let found = Rational::new(this.0, this.1);
        let distance = (to_f64(found) - x).abs();
        if distance <= NEAR * x.max(1.0) || rest.fract() == 0.0 {
            return found;
        }
        rest = rest.fract().recip();
    }
}

#[cfg(test)]
mod tests {
    use super::super::parts::Part;
    use super::*;
    use crate::formula::quantity::{F1, F2};
    use crate::toolkit::graph::{Binary, Op, Relation};

    const INPUTS: [Field; 2] = [Field::new("f1", &F1), Field::new("f2", &F2)];

    /// A graph with two inputs.
    fn graph() -> (Graph, [Node; 2]) {
        let mut graph = Graph::default();
        let inputs = [0, 1].map(|k| graph.enter(Op::Input(k)));
        (graph, inputs)
    }

    /// The bound that no steps prove, on the only way.
    fn without_steps(graph: &Graph, result: Node) -> Result<Rational, String> {
        added_up(&mut parts(&way(graph, &Answers::new(), result)?, &INPUTS)?, &[])
    }

    fn certificate(way: &[(Node, bool)], bound: i128, steps: Vec<(Rule, Rational)>) -> Certificate {
        Certificate { way: way.iter().copied().collect(), bound: bound.into(), is_first_order: true, steps }
    }

    /// The rounding of a sum is taken back by the rest that is added to it; what is left is that of the last sum, and on the first input
    /// that of a difference.
    #[test]
    fn a_number_that_is_always_zero_hands_derivatives_on() {
        let (mut graph, [a, b]) = graph();
        let sum = graph.binary(Binary::Add, a, b);
        let of_b = graph.binary(Binary::Subtract, sum, a);
        let of_a = graph.binary(Binary::Subtract, sum, of_b);
        let [rest_a, rest_b] = [(a, of_a), (b, of_b)].map(|(x, y)| graph.binary(Binary::Subtract, x, y));
        let rest = graph.binary(Binary::Add, rest_a, rest_b);
        let result = graph.binary(Binary::Add, sum, rest);
        assert_eq!(without_steps(&graph, result), Ok(1.into()));
    }

    /// A double of many digits stands for a number without end, and so does its third.
    #[test]
    fn constants_made_of_inexact_ones_are_inexact() {
        let (mut graph, [a, _]) = graph();
        let [pi, three, six, half] = [std::f64::consts::PI, 3.0, 6.0, 0.5].map(|x| graph.number(x));
        let bound = |graph: &mut Graph, constant: Node| {
            let result = graph.binary(Binary::Multiply, a, constant);
            without_steps(graph, result)
        };
        let third = graph.quotient(pi, three);
        let [two, sixth] = [graph.quotient(six, three), graph.quotient(three, six)];
        let seventh = graph.quotient(half, three);
        let bounds = [pi, third, two, sixth, seventh, three, half].map(|constant| bound(&mut graph, constant));
        let halves = [2, 3, 1, 1, 2, 1, 0].map(|halves| Ok(Rational::new(halves, 2)));
        assert_eq!(bounds, halves);
    }

    #[test]
    fn nothing_is_discharged_on_constants_and_what_cancels_is_not_bounded() {
        let (mut graph, [a, b]) = graph();
        let tenth = graph.number(0.1);
        let sum = graph.binary(Binary::Add, a, tenth);
        assert!(without_steps(&graph, sum).is_err_and(|why| why.contains("none of inputs and result")));
        let part = |factor: i128, place: usize| (Rational::from(factor), Part(sum, 0, place));
        let terms = vec![part(1, 2), part(1, 1), part(-1, 0)];
        let steps = vec![(Rule::Sum(terms), Rational::from(1))];
        assert_eq!(check(&graph, &INPUTS, sum, &[certificate(&[], 2, steps)]), Ok(()));
        let longer = graph.binary(Binary::Add, a, b);
        let back = graph.binary(Binary::Subtract, longer, b);
        let why = prove(&graph, &INPUTS, back, |_| None).unwrap_err();
        assert_eq!(why, format!("no rule bounds the rounding of operation {}, add", longer.index()));
    }

    #[test]
    fn every_way_needs_a_certificate() {
        let (mut graph, [a, b]) = graph();
        let less = graph.enter(Op::Compare(Relation::Less, a, b));
        let [sum, difference] = [Binary::Add, Binary::Subtract].map(|operation| graph.binary(operation, a, b));
        let result = graph.enter(Op::Select(less, sum, difference));
        let ways = [true, false].map(|answer| certificate(&[(less, answer)], 1, Vec::new()));
        let checked = |certificates: &[Certificate]| check(&graph, &INPUTS, result, certificates);
        assert_eq!(checked(&ways), Ok(()));
        for some in [&ways[..1], &ways[1..], &[]] {
            assert_eq!(checked(some), Err("there is a way without a certificate".into()));
        }
        let [open, unknown] = [vec![], vec![(Node::at(99), true)]].map(|way| certificate(&way, 1, Vec::new()));
        assert_eq!(checked(&[open]), Err(format!("the way does not say how comparison {} comes out", less.index())));
        assert!(checked(&[unknown.clone(), Certificate { way: [(Node::at(99), false)].into(), ..unknown }]).is_err());
    }

    #[test]
    fn an_amount_is_the_simplest_fraction_near_it() {
        let fractions = [0.0, 2.0, 1.0 / 3.0, 0.666_666_67, 17.0 / 113.0, 1e-9];
        let simplest = [(0, 1), (2, 1), (1, 3), (2, 3), (17, 113), (0, 1)];
        assert_eq!(fractions.map(fraction), simplest.map(|(above, below)| Rational::new(above, below)));
    }
}
