//! Certificates: found with the help of a linear programme, checked without.

use super::field::{Rational, to_f64};
use super::parts::{Atom, Inequality, Obstacle, Parts, Rule};
use super::possible::{MOST_WAYS, are_all, ways};
use super::way::{Answers, Way};
use crate::formula::Field;
use crate::toolkit::graph::{Graph, Node, bounds};
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, Signed, Zero};
use std::collections::BTreeMap;
use std::ops::Range;

/// Amounts are rounded to fractions that are as near.
const NEAR: f64 = 1e-7;
/// Their denominators are at most this.
const LARGEST: i128 = 100_000;
/// A rule used less than this was used by a rounding error of the linear programme.
const NOTHING: f64 = 1e-7;
/// Where such fractions do not add up, amounts are rounded up to multiples of the reciprocal.
const FINE: u32 = 1 << 20;
/// A bound that is mended is rounded up to a multiple of the reciprocal.
const COARSE: i128 = 1000;

/// The proof of a bound on one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The way.
    pub way: Answers,
    /// The other results beside which this one is judged, if the bound is normwise.
    pub beside: Option<Vec<Node>>,
    /// The bound of η.
    pub bound: Rational,
    /// Whether what is not of the first order has a relative size of roundings, too.
    pub is_first_order: bool,
    /// How often each rule is used.
    pub steps: Vec<(Rule, Rational)>,
}

/// A linear programme: amounts of rules, none below 0, for which the largest ratio of what a part carries and of its room is least, added
/// up over the weights. A part without room may carry nothing.
#[derive(Clone, Debug, Default)]
pub struct Programme {
    /// What each part is loaded with.
    pub load: Vec<f64>,
    /// The weight to which the room of each part belongs, and the room.
    pub room: Vec<(usize, f64)>,
    /// What each rule adds to parts for each unit of its amount.
    pub rules: Vec<Vec<(usize, f64)>>,
}

/// The certificates of a result, one for each way through its branches; `solve` solves the linear programmes. A result without a bound by
/// components may have one that is normwise, with the others beside it.
///
/// # Errors
/// Why nothing is proved.
pub fn prove(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    beside: &[Node],
    solve: impl Fn(&Programme) -> Option<Vec<f64>>,
) -> Result<Vec<Certificate>, String> {
    let on_all_ways = |beside: Option<&[Node]>| {
        let all: Vec<Node> = [result].iter().chain(beside.unwrap_or_default()).copied().collect();
        let ways = ways(graph, &all).ok_or_else(|| said(graph, &Obstacle::Ways))?;
        let mut found: Vec<Certificate> = Vec::new();
        for way in ways {
            // What is proved on one way often is on another.
            let most = found.iter().map(|it| it.bound).max();
            let again = found.iter().rev().find_map(|it| {
                let mut same = Certificate { way: way.clone(), ..it.clone() };
                let (bound, is_first_order) = added_up_on(graph, inputs, result, &same).ok()?;
                (same.bound, same.is_first_order) = (bound, is_first_order);
                (Some(bound) <= most).then_some(same)
            });
            let proved = again.map_or_else(|| prove_on(graph, inputs, result, way, beside, &solve), Ok);
            found.push(proved?);
        }
        Ok(found)
    };
    on_all_ways(None).or_else(|_| on_all_ways(Some(beside)))
}

fn prove_on(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    answers: Answers,
    beside: Option<&[Node]>,
    solve: &impl Fn(&Programme) -> Option<Vec<f64>>,
) -> Result<Certificate, String> {
    let (way, fields) =
        (way(graph, &answers, result, beside)?, beside.map(|_| Field::ranges(inputs).collect::<Vec<_>>()));
    let mut parts = parts(&way, inputs, fields.as_deref())?;
    let is_first_order = parts.is_first_order;
    let mut used: Vec<(Rule, f64)> = Vec::new();
    if !parts.load.is_empty() {
        let rules = parts.rules();
        if let Some(obstacle) = parts.obstacle(&rules) {
            return Err(said(graph, &obstacle));
        }
        let amounts = solve(&programme(&parts, &rules)).ok_or("the linear programme has no solution")?;
        used.extend(rules.into_keys().zip(amounts).filter(|&(_, amount)| amount > NOTHING));
    }
    let steps: Vec<_> = used.iter().map(|(rule, amount)| (rule.clone(), fraction(*amount))).collect();
    let (bound, steps) = added_up(&mut parts, &steps)
        .map(|bound| (bound, steps))
        .or_else(|error| mended(&mut parts, &used).ok_or(error))
        .map_err(|error| format!("rounding the linear programme's solution: {error}"))?;
    Ok(Certificate { way: answers, beside: beside.map(<[_]>::to_vec), bound, is_first_order, steps })
}

/// Checks that certificates prove their bounds of a result, together on all ways. `others` are the results beside it.
///
/// # Errors
/// What is wrong with which of them.
pub fn check(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    others: &[Node],
    certificates: &[Certificate],
) -> Result<(), String> {
    let ways: Vec<_> = certificates.iter().map(|certificate| certificate.way.clone()).collect();
    if !are_all(graph, &ways, &Answers::new()) {
        return Err("there is a way without a certificate".into());
    }
    for certificate in certificates {
        if certificate.way.keys().any(|node| node.index() >= graph.ops().len()) {
            return Err("its way names an operation that is not there".into());
        }
        if let Some(other) = certificate.beside.iter().flatten().find(|node| !others.contains(node)) {
            return Err(format!("{} is not beside it", other.index()));
        }
        let (needed, is_first_order) = added_up_on(graph, inputs, result, certificate)?;
        if needed > certificate.bound {
            return Err(format!("its steps prove {needed}, not {}", certificate.bound));
        }
        if certificate.is_first_order && !is_first_order {
            return Err("it says that the first order is all that counts".into());
        }
    }
    Ok(())
}

/// The bound that the steps of a certificate prove on its way, and whether more than the first order counts.
fn added_up_on(
    graph: &Graph,
    inputs: &[Field],
    result: Node,
    certificate: &Certificate,
) -> Result<(Rational, bool), String> {
    let way = way(graph, &certificate.way, result, certificate.beside.as_deref())?;
    let fields = certificate.beside.as_ref().map(|_| Field::ranges(inputs).collect::<Vec<_>>());
    let mut parts = parts(&way, inputs, fields.as_deref())?;
    Ok((added_up(&mut parts, &certificate.steps)?, parts.is_first_order))
}

fn way<'a>(graph: &'a Graph, answers: &'a Answers, result: Node, beside: Option<&[Node]>) -> Result<Way<'a>, String> {
    let results: Vec<Node> = [result].iter().chain(beside.unwrap_or_default()).copied().collect();
    let way = Way::new(graph, answers, &results)
        .map_err(|open| format!("the way does not say how comparison {} comes out", open.index()))?;
    Ok(if beside.is_some() { way.with_inputs() } else { way })
}

fn parts<'a>(way: &'a Way<'a>, inputs: &[Field], fields: Option<&'a [Range<usize>]>) -> Result<Parts<'a>, String> {
    let bounds: Vec<_> = inputs.iter().flat_map(|field| vec![bounds(field.quantity.domain); field.len()]).collect();
    Parts::new(way, &bounds, fields).map_err(|obstacle| said(way.graph, &obstacle))
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
    let mut programme =
        Programme { load: vec![0.0; parts.count()], room: vec![(0, 0.0); parts.count()], rules: Vec::new() };
    parts.load.iter().for_each(|(&atom, (load, _))| programme.load[atom] = double(load));
    parts.room.iter().for_each(|(&atom, (weight, room))| programme.room[atom] = (*weight, double(room)));
    programme.rules.extend(rules.values().map(|rule| {
        let mut adds: BTreeMap<Atom, f64> = BTreeMap::new();
        rule.left.iter().for_each(|(factor, atom)| *adds.entry(*atom).or_default() -= double(factor));
        rule.right.iter().for_each(|(factor, atom)| *adds.entry(*atom).or_default() += double(factor));
        adds.into_iter().collect()
    }));
    programme
}

/// Amounts that are rounded up, and raised where what is left has no room, with the bound that they prove.
fn mended(parts: &mut Parts, used: &[(Rule, f64)]) -> Option<(Rational, Vec<(Rule, Rational)>)> {
    let up = |x: Rational, parts: i128| (x * parts).ceil() / parts;
    let rules: Vec<Inequality> = used.iter().map(|(rule, _)| parts.inequality(rule).ok()).collect::<Option<_>>()?;
    #[expect(clippy::cast_possible_truncation, reason = "amounts are small")]
    let whole = |amount: f64| Rational::new((amount * f64::from(FINE)).ceil() as i128, FINE.into());
    let mut steps: Vec<_> = used.iter().map(|(rule, amount)| (rule.clone(), whole(*amount))).collect();
    // Each round moves what is left by one rule.
    for _ in 0..=2 * used.len() {
        let left = carried(parts, &steps).ok()?.into_iter();
        let left: Vec<_> = left.filter(|(atom, rest)| rest.is_positive() && !parts.room.contains_key(atom)).collect();
        if left.is_empty() {
            break;
        }
        for (atom, rest) in left {
            let moves = |rule: &Inequality| rule.left.iter().find(|term| term.1 == atom).map(|term| term.0);
            let by = rules.iter().enumerate().filter_map(|(k, rule)| Some((steps[k].1, k, moves(rule)?)));
            let (_, k, factor) = by.max()?;
            steps[k].1 = up(steps[k].1 + rest / factor, FINE.into());
        }
    }
    Some((up(added_up(parts, &steps).ok()?, COARSE), steps))
}

/// Why rationals of this size do not do.
fn too_large() -> String {
    "a sum of its amounts has too many digits".into()
}

/// What parts carry after these steps.
fn carried(parts: &mut Parts, steps: &[(Rule, Rational)]) -> Result<BTreeMap<Atom, Rational>, String> {
    let mut carried: BTreeMap<Atom, Rational> = parts.load.iter().map(|(&atom, &(load, _))| (atom, load)).collect();
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
    Ok(carried)
}

/// The bound that these steps prove.
fn added_up(parts: &mut Parts, steps: &[(Rule, Rational)]) -> Result<Rational, String> {
    let mut bounds: BTreeMap<usize, Rational> = BTreeMap::new();
    for (atom, carried) in carried(parts, steps)?.into_iter().filter(|(_, carried)| carried.is_positive()) {
        let (weight, room) = parts
            .room
            .get(&atom)
            .ok_or_else(|| format!("{carried} of a part is left that is none of inputs and result"))?;
        let bound = bounds.entry(*weight).or_default();
        *bound = carried.checked_div(room).ok_or_else(too_large)?.max(*bound);
    }
    bounds.values().try_fold(Rational::zero(), |sum, bound| sum.checked_add(bound)).ok_or_else(too_large)
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
    use crate::formula::quantity::{F1, F2, SLIDER_X1_PLANE};
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
        added_up_on(graph, &INPUTS, result, &certificate(&[], 0, Vec::new())).map(|(bound, _)| bound)
    }

    fn certificate(way: &[(Node, bool)], bound: i128, steps: Vec<(Rule, Rational)>) -> Certificate {
        let (way, bound) = (way.iter().copied().collect(), bound.into());
        Certificate { way, beside: None, bound, is_first_order: true, steps }
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
        assert_eq!(check(&graph, &INPUTS, sum, &[], &[certificate(&[], 2, steps)]), Ok(()));
        let longer = graph.binary(Binary::Add, a, b);
        let back = graph.binary(Binary::Subtract, longer, b);
        let why = prove(&graph, &INPUTS, back, &[], |_| None).unwrap_err();
        assert_eq!(why, format!("no rule bounds the rounding of operation {}, add", longer.index()));
    }

    #[test]
    fn every_way_needs_a_certificate() {
        let (mut graph, [a, b]) = graph();
        let less = graph.enter(Op::Compare(Relation::Less, a, b));
        let [sum, difference] = [Binary::Add, Binary::Subtract].map(|operation| graph.binary(operation, a, b));
        let result = graph.enter(Op::Select(less, sum, difference));
        let ways = [true, false].map(|answer| certificate(&[(less, answer)], 1, Vec::new()));
        let checked = |certificates: &[Certificate]| check(&graph, &INPUTS, result, &[], certificates);
        assert_eq!(checked(&ways), Ok(()));
        for some in [&ways[..1], &ways[1..], &[]] {
            assert_eq!(checked(some), Err("there is a way without a certificate".into()));
        }
        let [open, unknown] = [vec![], vec![(Node::at(99), true)]].map(|way| certificate(&way, 1, Vec::new()));
        assert_eq!(checked(&[open]), Err(format!("the way does not say how comparison {} comes out", less.index())));
        assert!(checked(&[unknown.clone(), Certificate { way: [(Node::at(99), false)].into(), ..unknown }]).is_err());
    }

    /// Of (a + b) − b, with a and b the components of a vector, the rounding of the first sum is at most |a| + |b|.
    #[test]
    fn normwise_a_part_may_end_on_another_component() {
        let (mut graph, [a, b]) = graph();
        let sum = graph.binary(Binary::Add, a, b);
        let result = graph.binary(Binary::Subtract, sum, b);
        let inputs = [Field::new("x1", &SLIDER_X1_PLANE)];
        let checked =
            |others: &[Node], certificate: Certificate| check(&graph, &inputs, result, others, &[certificate]);
        let [whole, size] = [Part(sum, 0, 0), Part(result, 1, 0)];
        let [by_a, by_b] = [a, b].map(|node| Part(node, if node == a { 1 } else { 3 }, 0));
        let one = Rational::from(1);
        let steps = vec![
            (Rule::Sum(vec![(one, whole), (-one, by_a), (-one, by_b)]), one),
            (Rule::Beside(by_a.0, by_a.1), one),
            (Rule::Beside(by_b.0, by_b.1), one),
            (Rule::Beside(size.0, size.1), one),
        ];
        let normwise = |bound| Certificate { beside: Some(Vec::new()), ..certificate(&[], bound, steps.clone()) };
        assert_eq!(checked(&[], normwise(2)), Ok(()));
        assert_eq!(checked(&[], normwise(1)), Err("its steps prove 2, not 1".into()));
        let beside = |others: &[Node]| checked(others, Certificate { beside: Some(vec![sum]), ..normwise(2) });
        assert_eq!((beside(&[sum]), beside(&[])), (Ok(()), Err(format!("{} is not beside it", sum.index()))));
        assert!(checked(&[], certificate(&[], 2, steps.clone())).is_err_and(|why| why.contains("no part")));
    }

    /// Of a/(h(2 − h)) with h = 1 − b, the part of h is −2b/(1 + b) times the result: at most twice the result where 0 ≤ b.
    #[test]
    fn a_sign_bounds_a_ratio() {
        let (mut graph, [a, b]) = graph();
        let [zero, one, two] = [0.0, 1.0, 2.0].map(|x| graph.number(x));
        let is_up = graph.enter(Op::Compare(Relation::LessOrEqual, zero, b));
        let h = graph.binary(Binary::Subtract, one, b);
        let rest = graph.binary(Binary::Subtract, two, h);
        let product = graph.binary(Binary::Multiply, h, rest);
        let quotient = graph.binary(Binary::Divide, a, product);
        let [where_up, where_down] =
            [[quotient, a], [a, quotient]].map(|[yes, no]| graph.enter(Op::Select(is_up, yes, no)));
        let range = vec![(Rule::Range(Part(h, 0, 0), Part(quotient, 0, 0), b), 1.into())];
        let checked = |result: Node, answer: bool, bound: i128, steps: &[(Rule, Rational)]| {
            let ways = [(answer, bound, steps), (!answer, 0, &[])].map(|(answer, bound, steps)| Certificate {
                is_first_order: false,
                ..certificate(&[(is_up, answer)], bound, steps.to_vec())
            });
            check(&graph, &INPUTS, result, &[], &ways)
        };
        assert_eq!(checked(where_up, true, 3, &range), Ok(()));
        assert_eq!(checked(where_up, true, 2, &range), Err("its steps prove 5/2, not 2".into()));
        assert!(checked(where_up, true, 3, &[]).is_err_and(|why| why.contains("none of inputs and result")));
        assert!(checked(where_down, false, 3, &range).is_err_and(|why| why.contains("say nothing")));
    }

    /// A length that is 0 has no part that is not.
    #[test]
    fn ways_that_contradict_themselves_need_no_certificate() {
        let (mut graph, [a, b]) = graph();
        let [zero, least] = [0.0, f64::MIN_POSITIVE].map(|x| graph.number(x));
        let is_zero = graph.enter(Op::Compare(Relation::Equal, a, zero));
        let length = graph.enter(Op::Norm([a, b].into()));
        let is_normal = graph.enter(Op::Compare(Relation::LessOrEqual, least, length));
        let on = |answers: [bool; 2]| Answers::from([(is_zero, answers[0]), (is_normal, answers[1])]);
        let all = [[true, true], [true, false], [false, true]].map(on);
        assert!(are_all(&graph, &all, &Answers::new()));
        for k in 0..3 {
            let some: Vec<_> = (0..3).filter(|&other| other != k).map(|other| all[other].clone()).collect();
            assert!(!are_all(&graph, &some, &Answers::new()), "{k}");
        }
    }

    /// What is made of numbers that are 0 alone is 0: the length of a vector, and of a multiple of it.
    #[test]
    fn what_is_made_of_zeros_is_zero() {
        let (mut graph, [a, b]) = graph();
        let [zero, least, factor] = [0.0, f64::MIN_POSITIVE, 1e18].map(|x| graph.number(x));
        let scaled = [a, b].map(|x| graph.binary(Binary::Multiply, x, factor));
        let [length, multiple] = [[a, b], scaled].map(|parts| graph.enter(Op::Norm(parts.into())));
        let is_normal = graph.enter(Op::Compare(Relation::LessOrEqual, least, length));
        let is_zero = graph.enter(Op::Compare(Relation::Equal, multiple, zero));
        let both = [true, false].map(|normal| Answers::from([(is_normal, normal), (is_zero, !normal)]));
        let are_all = |ways: &[Answers]| are_all(&graph, ways, &Answers::new());
        assert_eq!([are_all(&both), are_all(&both[..1]), are_all(&both[1..])], [true, false, false]);
    }

    /// A linear programme that moves too little is no proof until the rest is moved, too.
    #[test]
    fn amounts_that_leave_a_rest_are_mended() {
        let (mut graph, [a, _]) = graph();
        let tenth = graph.number(0.1);
        let sum = graph.binary(Binary::Add, a, tenth);
        let too_little = |programme: &Programme| {
            let moves = |&(part, by): &(usize, f64)| by < 0.0 && programme.room[part].1 == 0.0;
            Some(programme.rules.iter().map(|adds| if adds.iter().any(moves) { 0.99 } else { 0.0 }).collect())
        };
        let certificates = prove(&graph, &INPUTS, sum, &[], too_little).unwrap();
        assert_eq!(check(&graph, &INPUTS, sum, &[], &certificates), Ok(()));
        assert!((2.into()..Rational::new(201, 100)).contains(&certificates[0].bound), "{}", certificates[0].bound);
    }

    #[test]
    fn an_amount_is_the_simplest_fraction_near_it() {
        let fractions = [0.0, 2.0, 1.0 / 3.0, 0.666_666_67, 17.0 / 113.0, 1e-9];
        let simplest = [(0, 1), (2, 1), (1, 3), (2, 3), (17, 113), (0, 1)];
        assert_eq!(fractions.map(fraction), simplest.map(|(above, below)| Rational::new(above, below)));
    }
}
