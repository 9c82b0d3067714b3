//! Candidates for kinks: the comparisons and guarded zeros in the graph of a formula, where it may have no derivative.

use super::words::Words;
use crate::formula::Field;
use crate::formula::quantity::Domain;
use crate::toolkit::graph::{Binary, Graph, Node, Op, Relation, Unary};
use crate::toolkit::verify::Subject;
use crate::toolkit::verify::point::Names;
use std::collections::HashSet;

/// The other side of an equality that defines a candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Other {
    /// Another result.
    Node(Node),
    /// A number.
    Number(f64),
    /// The power of two above the number: at that point, the power of two below it jumps.
    PowerOfTwo,
    /// The nearest number halfway between two integers, where the nearest integer jumps.
    Halfway,
}

/// A condition under which a formula may have no derivative.
#[derive(Clone)]
pub(super) struct Candidate {
    /// The operation without a derivative.
    pub(super) node: Node,
    /// The condition in words.
    pub(super) words: String,
    /// It holds if the two numbers of each pair are equal,
    pub(super) pairs: Vec<(Node, Other)>,
    /// and this one is negative.
    pub(super) negative: Option<Node>,
}

/// All candidates of the value of a formula.
pub(super) fn candidates(subject: &Subject, graph: &Graph, names: &Names) -> Vec<Candidate> {
    let is_positive = |field: &Field| matches!(field.quantity.domain, Domain::Positive);
    let positive = subject.inputs.iter().flat_map(|field| vec![is_positive(field); field.len()]).collect();
    let seen = Seen { graph, words: Words { graph, names: &names.inputs }, positive };
    let guards = guards(graph);
    let mut known = HashSet::new();
    let mut all = Vec::new();
    for node in graph.needed(&graph.value) {
        for mut candidate in seen.places(node) {
            // A condition evaluated only where numbers are equal is a candidate only there.
            for guard in guards[node.index()].iter().flat_map(|&guard| seen.places(guard)) {
                candidate.words = format!("{} and {}", candidate.words, guard.words);
                candidate.pairs.extend(guard.pairs);
            }
            if known.insert(format!("{:?} {:?}", candidate.pairs, candidate.negative)) {
                all.push(candidate);
            }
        }
    }
    all
}

/// For every operation, the equalities without which the value does not depend on it.
fn guards(graph: &Graph) -> Vec<Vec<Node>> {
    let mut guards: Vec<Option<Vec<Node>>> = vec![None; graph.ops().len()];
    graph.value.iter().for_each(|node| guards[node.index()] = Some(Vec::new()));
    for user in graph.needed(&graph.value).into_iter().rev() {
        let of_user = guards[user.index()].clone().unwrap_or_default();
        for (k, operand) in graph.op(user).operands().into_iter().enumerate() {
            let mut own = of_user.clone();
            if let (Op::Select(condition, ..), 1) = (graph.op(user), k) {
                own.extend(equalities(graph, *condition));
            }
            let known = &mut guards[operand.index()];
            *known = Some(match known.take() {
                Some(known) => known.into_iter().filter(|guard| own.contains(guard)).collect(),
                None => own,
            });
        }
    }
    guards.into_iter().map(Option::unwrap_or_default).collect()
}

/// The equalities that hold if a Boolean is true.
fn equalities(graph: &Graph, answer: Node) -> Vec<Node> {
    match graph.op(answer) {
        Op::Compare(Relation::Equal, ..) => vec![answer],
        op => op.both_of().into_iter().flatten().flat_map(|answer| equalities(graph, answer)).collect(),
    }
}

/// A graph, and the facts known about its inputs.
struct Seen<'a> {
    graph: &'a Graph,
    words: Words<'a>,
    positive: Vec<bool>,
}

impl Seen<'_> {
    /// The conditions under which an operation may have no derivative.
    fn places(&self, node: Node) -> Vec<Candidate> {
        let of = |node| self.words.of(node);
        let place = |words: String, pairs| Candidate { node, words, pairs, negative: None };
        let equal = |x: Node, other: Other, to: &str| vec![place(format!("{} = {to}", of(x)), vec![(x, other)])];
        let zero = |node: Node| {
            let pairs = self.vanish(node).into_iter().map(|node| (node, Other::Number(0.0))).collect();
            vec![place(format!("{} = 0", of(node)), pairs)]
        };
        match self.graph.op(node) {
            Op::Compare(_, x, y) | Op::Binary(Binary::Maximum, x, y) => {
                match [self.graph.constant(*x), self.graph.constant(*y)] {
                    // No finite numbers satisfy it.
                    [Some(c), _] | [_, Some(c)] if c.is_infinite() => Vec::new(),
                    [Some(0.0), _] => zero(*y),
                    [_, Some(0.0)] => zero(*x),
                    [Some(c), _] => equal(*y, Other::Number(c), &of(*x)),
                    [_, Some(c)] => equal(*x, Other::Number(c), &of(*y)),
                    _ => equal(*x, Other::Node(*y), &of(*y)),
                }
            }
            Op::Unary(Unary::Absolute | Unary::Root, x) => zero(*x),
            Op::Norm(_) => zero(node),
            Op::Unary(Unary::ArcSine, x) => {
                [1.0, -1.0].into_iter().flat_map(|c| equal(*x, Other::Number(c), &c.to_string())).collect()
            }
            Op::Unary(Unary::PowerOfTwo, x) => equal(*x, Other::PowerOfTwo, "a power of two"),
            Op::Unary(Unary::NearestInteger, x) => equal(*x, Other::Halfway, "an integer and a half"),
            Op::Binary(Binary::Angle, y, x) => {
                let [on_y, on_x] = [*y, *x].map(|node| (node, Other::Number(0.0)));
                let origin = place(format!("{} = {} = 0", of(*y), of(*x)), vec![on_y, on_x]);
                let cut = place(format!("{} = 0, {} < 0", of(*y), of(*x)), vec![on_y]);
                vec![origin, Candidate { negative: Some(*x), ..cut }]
            }
            _ => Vec::new(),
        }
    }

    /// The results that all vanish where this one does; a sum of squares is 0 only if every term is.
    fn vanish(&self, node: Node) -> Vec<Node> {
        match self.graph.op(node) {
            Op::Number(bits) if f64::from_bits(*bits) == 0.0 => Vec::new(),
            Op::Norm(parts) => parts.iter().flat_map(|&part| self.vanish(part)).collect(),
            Op::Unary(Unary::Absolute | Unary::Root | Unary::Negative, x) | Op::Binary(Binary::Divide, x, _) => {
                self.vanish(*x)
            }
            Op::Binary(Binary::Multiply, x, y) if x == y => self.vanish(*x),
            Op::Binary(Binary::Multiply, x, y) if self.is_factor(*y) => self.vanish(*x),
            Op::Binary(Binary::Multiply, x, y) if self.is_factor(*x) => self.vanish(*y),
            Op::Binary(Binary::Add | Binary::Maximum, x, y) if [*x, *y].iter().all(|&term| self.is_size(term)) => {
                [*x, *y].iter().flat_map(|&term| self.vanish(term)).collect()
            }
            _ => vec![node],
        }
    }

    /// Whether it is a factor that is never 0: a number, a power of two, a positive input, or a product of these.
    fn is_factor(&self, node: Node) -> bool {
        match self.graph.op(node) {
            Op::Number(bits) => f64::from_bits(*bits) != 0.0,
            Op::Input(k) => self.positive[*k],
            Op::Unary(Unary::PowerOfTwo, _) => true,
            Op::Binary(Binary::Divide | Binary::Multiply, x, y) => self.is_factor(*x) && self.is_factor(*y),
            _ => false,
        }
    }

    /// Whether the operation is never negative.
    fn is_size(&self, node: Node) -> bool {
        match self.graph.op(node) {
            Op::Norm(_) | Op::Unary(Unary::Absolute | Unary::Root, _) => true,
            Op::Number(bits) => f64::from_bits(*bits) >= 0.0,
            Op::Binary(Binary::Multiply, x, y) => x == y || self.is_size(*x) && self.is_size(*y),
            Op::Binary(Binary::Add | Binary::Maximum, x, y) => self.is_size(*x) && self.is_size(*y),
            Op::Input(k) => self.positive[*k],
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::planted::planted;
    use super::*;
    use Binary::{Add, Angle, Divide, Maximum, Multiply, Subtract};
    use Unary::{Absolute, ArcSine, NearestInteger, Negative, PowerOfTwo, Root, Sine};

    /// The candidates of a value of x, y and c > 0: their words, and the equations to solve.
    fn found(value: impl FnOnce(&mut Graph, [Node; 3]) -> Vec<Node>) -> Vec<String> {
        let subject = planted(|_| Vec::new(), |_| Vec::new());
        let (mut graph, names) = (Graph::default(), Names::new(&subject));
        let inputs = graph.inputs();
        graph.value = value(&mut graph, inputs);
        let words = Words { graph: &graph, names: &names.inputs };
        let shown = |Candidate { words: place, pairs, negative, .. }: Candidate| {
            let equal = |(node, other): (Node, Other)| match other {
                Other::Node(other) => format!("{} = {}", words.of(node), words.of(other)),
                Other::Number(number) => format!("{} = {number}", words.of(node)),
                Other::PowerOfTwo => format!("{} = 2ᵏ", words.of(node)),
                Other::Halfway => format!("{} = k + ½", words.of(node)),
            };
            let pairs: Vec<_> = pairs.into_iter().map(equal).collect();
            let negative = negative.map(|node| format!(", {} < 0", words.of(node))).unwrap_or_default();
            format!("{place}: {}{negative}", pairs.join(", "))
        };
        candidates(&subject, &graph, &names).into_iter().map(shown).collect()
    }

    /// The equations to solve for this number to be 0.
    fn zeros(value: impl FnOnce(&mut Graph, [Node; 3]) -> Node) -> String {
        let found = found(|graph, inputs| {
            let value = value(graph, inputs);
            let end = graph.number(0.0);
            vec![graph.compare(Relation::Less, value, end)]
        });
        found.last().and_then(|place| place.split_once(": ")).map(|(_, pairs)| pairs.to_owned()).unwrap_or_default()
    }

    #[test]
    fn numbers_that_are_compared_are_equal_to_each_other() {
        let compared = |a: Option<f64>, b: Option<f64>| {
            found(|graph, [x, y, _]| {
                let [a, b] = [(a, x), (b, y)].map(|(c, node)| c.map_or(node, |c| graph.number(c)));
                vec![graph.compare(Relation::LessOrEqual, a, b)]
            })
        };
        assert_eq!(compared(None, None), ["x = y: x = y"]);
        assert_eq!(compared(Some(2.0), None), ["y = 2: y = 2"]);
        assert_eq!(compared(None, Some(-2.0)), ["x = −2: x = -2"]);
        assert_eq!(compared(Some(0.0), None), ["y = 0: y = 0"]);
        assert_eq!(compared(None, Some(0.0)), ["x = 0: x = 0"]);
        assert_eq!(compared(Some(f64::INFINITY), None), [""; 0]);
        assert_eq!(compared(None, Some(f64::NEG_INFINITY)), [""; 0]);
        let larger = found(|graph, [x, y, _]| vec![graph.binary(Maximum, x, y)]);
        assert_eq!(larger, ["x = y: x = y"]);
    }

    #[test]
    fn functions_have_no_derivative_at_their_ends_and_where_they_jump() {
        let of = |function| found(|graph, [x, ..]| vec![graph.unary(function, x)]);
        assert_eq!([Absolute, Root].map(of), [["x = 0: x = 0"]; 2]);
        assert_eq!(of(ArcSine), ["x = 1: x = 1", "x = -1: x = -1"]);
        assert_eq!(of(PowerOfTwo), ["x = a power of two: x = 2ᵏ"]);
        assert_eq!(of(NearestInteger), ["x = an integer and a half: x = k + ½"]);
        assert_eq!([Sine, Negative].map(of), [[""; 0]; 2]);
        let angle = found(|graph, [x, y, _]| vec![graph.binary(Angle, y, x)]);
        assert_eq!(angle, ["y = x = 0: y = 0, x = 0", "y = 0, x < 0: y = 0, x < 0"]);
        let length = found(|graph, [x, y, _]| vec![graph.enter(Op::Norm([x, y].into()))]);
        assert_eq!(length, ["|(x, y)| = 0: x = 0, y = 0"]);
    }

    #[test]
    fn a_candidate_is_at_the_operation_that_has_no_derivative() {
        let subject = planted(|_| Vec::new(), |_| Vec::new());
        let mut graph = Graph::default();
        let [x, ..] = graph.inputs::<3>();
        let size = graph.unary(Absolute, x);
        graph.value = vec![graph.unary(Negative, size)];
        let nodes: Vec<_> = candidates(&subject, &graph, &Names::new(&subject)).iter().map(|all| all.node).collect();
        assert_eq!(nodes, [size]);
    }

    #[test]
    fn a_place_is_listed_once_and_that_of_one_half_of_it_again() {
        let both = found(|graph, [x, y, _]| {
            let end = graph.number(0.0);
            vec![graph.unary(Absolute, y), graph.compare(Relation::Less, end, y), graph.binary(Angle, y, x)]
        });
        assert_eq!(both, ["y = 0: y = 0", "y = x = 0: y = 0, x = 0", "y = 0, x < 0: y = 0, x < 0"]);
        assert_eq!(found(|_, [x, ..]| vec![x]), [""; 0]);
    }

    #[test]
    fn where_a_product_vanishes_its_factor_does_that_can() {
        assert_eq!(zeros(|graph, [x, ..]| graph.binary(Multiply, x, x)), "x = 0");
        assert_eq!(zeros(|graph, [x, y, _]| graph.binary(Multiply, x, y)), "x y = 0");
        assert_eq!(zeros(|graph, [x, _, c]| graph.binary(Multiply, x, c)), "x = 0");
        assert_eq!(zeros(|graph, [x, _, c]| graph.binary(Multiply, c, x)), "x = 0");
        assert_eq!(zeros(|graph, [x, y, _]| graph.binary(Divide, x, y)), "x = 0");
        let times = |factor: f64| {
            zeros(|graph, [x, ..]| {
                let factor = graph.number(factor);
                graph.binary(Multiply, factor, x)
            })
        };
        assert_eq!([2.0, -2.0, 0.0].map(times), ["x = 0", "x = 0", "0 x = 0"]);
        let scaled = |function| {
            zeros(|graph, [x, y, _]| {
                let factor = graph.unary(function, y);
                graph.binary(Multiply, x, factor)
            })
        };
        assert_eq!([PowerOfTwo, Sine].map(scaled), ["x = 0", "x sin(y) = 0"]);
    }

    #[test]
    fn a_factor_of_factors_is_one_where_both_are() {
        let times = |operation, [a, b]: [usize; 2]| {
            zeros(|graph, inputs| {
                let factor = graph.binary(operation, inputs[a], inputs[b]);
                graph.binary(Multiply, inputs[0], factor)
            })
        };
        assert_eq!([Multiply, Divide].map(|operation| times(operation, [2, 2])), ["x = 0"; 2]);
        assert_eq!([[1, 2], [2, 1]].map(|of| times(Multiply, of)), ["x y c = 0", "x c y = 0"]);
        assert_eq!([[1, 2], [2, 1]].map(|of| times(Divide, of)), ["x y/c = 0", "x c/y = 0"]);
        assert_eq!(times(Add, [2, 2]), "x (c + c) = 0");
    }

    #[test]
    fn sizes_vanish_where_what_they_are_of_does() {
        let of = |function| zeros(|graph, [x, ..]| graph.unary(function, x));
        assert_eq!([Absolute, Root, Negative, Sine].map(of), ["x = 0", "x = 0", "x = 0", "sin(x) = 0"]);
        let length = |length: f64| {
            zeros(|graph, [x, y, _]| {
                let parts = [x, graph.number(length), y];
                graph.enter(Op::Norm(parts.into()))
            })
        };
        assert_eq!([0.0, 1.0].map(length), ["x = 0, y = 0", "x = 0, 1 = 0, y = 0"]);
    }

    /// The sum, or the larger, of x² and another number.
    fn beside_a_square(operation: Binary, other: impl Fn(&mut Graph, [Node; 3]) -> Node) -> [String; 2] {
        [false, true].map(|is_first| {
            zeros(|graph, inputs| {
                let (square, other) = (graph.binary(Multiply, inputs[0], inputs[0]), other(graph, inputs));
                let [first, second] = if is_first { [other, square] } else { [square, other] };
                graph.binary(operation, first, second)
            })
        })
    }

    #[test]
    fn a_sum_vanishes_with_its_terms_where_none_is_negative() {
        let of = |function| beside_a_square(Add, move |graph, [_, y, _]| graph.unary(function, y));
        assert_eq!([Absolute, Root].map(of), [["x = 0, y = 0", "y = 0, x = 0"]; 2]);
        assert_eq!(of(Sine), ["x x + sin(y) = 0", "sin(y) + x x = 0"]);
        assert_eq!(beside_a_square(Maximum, |_, [.., c]| c), ["x = 0, c = 0", "c = 0, x = 0"]);
        assert_eq!(beside_a_square(Add, |_, [_, y, _]| y), ["x x + y = 0", "y + x x = 0"]);
        assert_eq!(beside_a_square(Subtract, |_, [.., c]| c), ["x x − c = 0", "c − x x = 0"]);
        let length = beside_a_square(Add, |graph, [_, y, c]| graph.enter(Op::Norm([y, c].into())));
        assert_eq!(length[0], "x = 0, y = 0, c = 0");
        let number = |c: f64| beside_a_square(Add, move |graph, _| graph.number(c));
        assert_eq!(number(2.0)[0], "x = 0, 2 = 0");
        assert_eq!(number(0.0)[0], "x = 0");
        assert_eq!(number(-2.0)[0], "x x + −2 = 0");
    }

    #[test]
    fn terms_of_terms_are_not_negative_where_none_of_them_is() {
        let of = |operation, [first, second]: [Option<Unary>; 2]| {
            let [whole, _] = beside_a_square(Add, move |graph, [_, y, c]| {
                let [y, c] = [(first, y), (second, c)].map(|(f, node)| f.map_or(node, |f| graph.unary(f, node)));
                graph.binary(operation, y, c)
            });
            whole
        };
        let size = Some(Absolute);
        assert_eq!(of(Add, [size, size]), "x = 0, y = 0, c = 0");
        assert_eq!(of(Maximum, [size, size]), "x = 0, y = 0, c = 0");
        assert_eq!(of(Multiply, [size, size]), "x = 0, |y| |c| = 0");
        for operation in [Add, Maximum, Multiply] {
            assert!(of(operation, [None, size]).starts_with("x x + "), "{operation:?}");
            assert!(of(operation, [size, Some(Sine)]).starts_with("x x + "), "{operation:?}");
        }
        assert_eq!(of(Subtract, [size, size]), "x x + |y| − |c| = 0");
    }

    /// |y| if a condition made of equalities of x and c with 1 holds, else √c.
    fn guarded(condition: impl FnOnce(&mut Graph, [Node; 2]) -> Node) -> Vec<String> {
        let found = found(|graph, [x, y, c]| {
            let one = graph.number(1.0);
            let equal = [x, c].map(|node| graph.compare(Relation::Equal, node, one));
            let condition = condition(graph, equal);
            let sides = [graph.unary(Absolute, y), graph.unary(Root, c)];
            vec![graph.select(condition, sides[0], sides[1])]
        });
        found.into_iter().filter(|place| place.starts_with("y = 0") || place.starts_with("c = 0")).collect()
    }

    #[test]
    fn what_is_asked_only_where_numbers_are_equal_is_there_alone() {
        let free = ["y = 0: y = 0", "c = 0: c = 0"];
        assert_eq!(guarded(|_, [x, _]| x), ["y = 0 and x = 1: y = 0, x = 1", free[1]]);
        let both = guarded(|graph, [x, c]| graph.select(x, c, x));
        assert_eq!(both, ["y = 0 and x = 1 and c = 1: y = 0, x = 1, c = 1", free[1]]);
        assert_eq!(guarded(|graph, [x, c]| graph.select(x, x, c)), free);
        let less = |graph: &mut Graph, [x, c]: [Node; 2]| graph.compare(Relation::LessOrEqual, x, c);
        assert_eq!(guarded(less), free);
    }

    #[test]
    fn an_operation_that_is_used_elsewhere_too_is_asked_under_what_all_users_have_in_common() {
        let found = |outer: fn(&mut Graph, Node, [Node; 2]) -> Vec<Node>| {
            let found = found(|graph, [x, y, c]| {
                let one = graph.number(1.0);
                let [by_x, by_c] = [x, c].map(|node| graph.compare(Relation::Equal, node, one));
                let size = graph.unary(Absolute, y);
                let negative = graph.unary(Negative, size);
                let inner = graph.select(by_c, negative, one);
                let both = graph.select(by_x, inner, size);
                let single = graph.select(by_x, inner, one);
                outer(graph, size, [both, single])
            });
            found.into_iter().find(|place| place.starts_with("y = 0")).unwrap_or_default()
        };
        assert_eq!(found(|_, _, [both, _]| vec![both]), "y = 0: y = 0");
        assert_eq!(found(|_, _, [_, single]| vec![single]), "y = 0 and x = 1 and c = 1: y = 0, x = 1, c = 1");
        assert_eq!(found(|_, size, [_, single]| vec![size, single]), "y = 0: y = 0");
        // Only the condition x = 1 is common to both uses.
        let partly = found(|graph, size, [_, single]| {
            let one = graph.number(1.0);
            let [x] = graph.inputs();
            let by_x = graph.compare(Relation::Equal, x, one);
            let other = graph.select(by_x, size, one);
            vec![single, other]
        });
        assert_eq!(partly, "y = 0 and x = 1: y = 0, x = 1");
    }
}
