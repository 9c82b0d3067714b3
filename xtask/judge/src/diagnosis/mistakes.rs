//! The mistakes searched for in the operations of a formula.

use super::observed::rounded;
use super::wording::{component, expression};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Graph, Instead, Node, Op, Unary};

/// A mistake: its description, its location, and the replacement there.
pub(super) struct Mistake {
    pub(super) sort: Sort,
    pub(super) what: String,
    pub(super) place: Node,
    pub(super) instead: Instead,
}

/// The kind of a mistake; kinds listed first are reported first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sort {
    Constant,
    Branch,
    Sign,
    Term,
    Index,
    Function,
    Factor,
}

/// Possible replacements of an operation: the kind of mistake, its name, and the replacement.
type Instances = Vec<(Sort, String, Instead)>;

/// All mistakes searched for in the operations that these results need, those near the results first.
pub(super) fn mistakes(graph: &Graph, inputs: &[Field], wanted: &[Node]) -> Vec<Mistake> {
    let all = graph.needed(&[graph.value.as_slice(), &graph.jacobian].concat());
    let input = |node: Node| if let Op::Input(k) = graph.op(node) { Some((*k, node)) } else { None };
    let known: Vec<_> = all.into_iter().filter_map(input).collect();
    let formula = Formula { graph, inputs, known };
    let at = |place: Node| {
        let mistake = move |(sort, what, instead)| Mistake { sort, what, place, instead };
        formula.mistakes(place).into_iter().map(mistake)
    };
    graph.needed(wanted).into_iter().rev().flat_map(at).collect()
}

struct Formula<'a> {
    graph: &'a Graph,
    inputs: &'a [Field],
    /// The components it uses, and their nodes.
    known: Vec<(usize, Node)>,
}

impl Formula<'_> {
    fn show(&self, node: Node) -> String {
        expression(self.graph, self.inputs, node)
    }

    fn mistakes(&self, node: Node) -> Instances {
        let mut instances = match *self.graph.op(node) {
            Op::Compare(..) => self.branches(node),
            Op::Binary(Binary::Add, x, y) => self.sum(node, [x, y]),
            Op::Binary(Binary::Subtract, x, y) => self.difference(node, [x, y]),
            Op::MultiplyAdd(..) | Op::Norm(_) | Op::ExactSum(_) => self.terms(node),
            Op::Binary(Binary::Multiply | Binary::Divide, x, y) => self.factors(node, [x, y]),
            Op::Unary(function, x) => self.function(function, x),
            Op::Number(bits) => constant(f64::from_bits(bits)),
            _ => Vec::new(),
        };
        instances.extend(self.other_inputs(node));
        instances
    }

    fn branches(&self, node: Node) -> Instances {
        let Op::Compare(relation, x, y) = *self.graph.op(node) else { return Vec::new() };
        let always = |answer: f64, word: &str| {
            let what = format!("one branch for all: as if it {word} held: {}", self.show(node));
            (Sort::Branch, what, Instead::Op(Op::Number(answer.to_bits())))
        };
        let exchanged = format!("the branches are exchanged: {}", self.show(node));
        let exchanged = (Sort::Branch, exchanged, Instead::Op(Op::Compare(relation, y, x)));
        vec![always(1.0, "always"), always(0.0, "never"), exchanged]
    }

    fn sum(&self, node: Node, [x, y]: [Node; 2]) -> Instances {
        vec![
            (Sort::Sign, self.turned(y, node), Instead::Op(Op::Binary(Binary::Subtract, x, y))),
            (Sort::Sign, self.turned(x, node), Instead::Op(Op::Binary(Binary::Subtract, y, x))),
            (Sort::Term, self.left_out(&self.show(y), node), Instead::Result(x)),
            (Sort::Term, self.left_out(&self.show(x), node), Instead::Result(y)),
        ]
    }

    fn difference(&self, node: Node, [x, y]: [Node; 2]) -> Instances {
        let whole = format!("the sign of {} is turned", self.show(node));
        vec![
            (Sort::Sign, self.turned(y, node), Instead::Op(Op::Binary(Binary::Add, x, y))),
            (Sort::Sign, whole, Instead::Op(Op::Binary(Binary::Subtract, y, x))),
            (Sort::Term, self.left_out(&self.show(y), node), Instead::Result(x)),
            (Sort::Term, self.left_out(&self.show(x), node), Instead::Op(Op::Unary(Unary::Negative, y))),
        ]
    }

    fn terms(&self, node: Node) -> Instances {
        let without = |term: String, instead| (Sort::Term, self.left_out(&term, node), instead);
        match self.graph.op(node) {
            &Op::MultiplyAdd(x, y, z) => vec![
                without(format!("{} {}", self.show(x), self.show(y)), Instead::Result(z)),
                without(self.show(z), Instead::Op(Op::Binary(Binary::Multiply, x, y))),
            ],
            Op::Norm(parts) => {
                let all_but = |k: usize| {
                    let rest: Vec<_> =
                        parts.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, x)| *x).collect();
                    let op =
                        if let [x] = *rest.as_slice() { Op::Unary(Unary::Absolute, x) } else { Op::Norm(rest.into()) };
                    without(self.show(parts[k]), Instead::Op(op))
                };
                (0..parts.len()).map(all_but).collect()
            }
            Op::ExactSum(products) => {
                let all_but = |k: usize| {
                    let mut rest = products.to_vec();
                    let product = rest.remove(k).map(|factor| self.show(factor)).join(" ");
                    without(product, Instead::Op(Op::ExactSum(rest.into())))
                };
                (0..products.len()).map(all_but).collect()
            }
            _ => Vec::new(),
        }
    }

    fn factors(&self, node: Node, [x, y]: [Node; 2]) -> Instances {
        let within = self.show(node);
        if let Op::Binary(Binary::Divide, ..) = self.graph.op(node) {
            let by = self.show(y);
            let product = Instead::Op(Op::Binary(Binary::Multiply, x, y));
            return vec![
                (Sort::Factor, format!("the division by {by} is missing in {within}"), Instead::Result(x)),
                (Sort::Factor, format!("a product for the quotient {within}"), product),
            ];
        }
        let missing = |factor: Node| format!("the factor {} is missing in {within}", self.show(factor));
        vec![(Sort::Factor, missing(x), Instead::Result(y)), (Sort::Factor, missing(y), Instead::Result(x))]
    }

    fn function(&self, function: Unary, x: Node) -> Instances {
        let of = self.show(x);
        match function {
            Unary::Negative => vec![(Sort::Sign, format!("a minus is missing before {of}"), Instead::Result(x))],
            Unary::Absolute => vec![(Sort::Function, format!("{of} for its absolute value"), Instead::Result(x))],
            Unary::Sine => {
                vec![(Sort::Function, format!("cos for sin of {of}"), Instead::Op(Op::Unary(Unary::Cosine, x)))]
            }
            Unary::Cosine => {
                vec![(Sort::Function, format!("sin for cos of {of}"), Instead::Op(Op::Unary(Unary::Sine, x)))]
            }
            _ => Vec::new(),
        }
    }

    /// Another input in place of this one.
    fn other_inputs(&self, node: Node) -> Instances {
        let op = self.graph.op(node);
        if matches!(op, Op::Select(..) | Op::Compare(..) | Op::ExactSum(_) | Op::Search(..)) {
            return Vec::new();
        }
        let operands = op.operands();
        let mut instances = Vec::new();
        for (place, operand) in operands.iter().enumerate() {
            let Op::Input(own) = *self.graph.op(*operand) else { continue };
            for &(other, input) in self.known.iter().filter(|(other, _)| *other != own) {
                let mut operands = operands.clone();
                operands[place] = input;
                let [other, own] = [other, own].map(|k| component(self.inputs, k));
                let what = format!("{other} for {own} in {}", self.show(node));
                instances.push((Sort::Index, what, Instead::Op(op.on(&operands))));
            }
        }
        instances
    }

    fn turned(&self, term: Node, within: Node) -> String {
        format!("the sign of {} is turned in {}", self.show(term), self.show(within))
    }

    fn left_out(&self, term: &str, within: Node) -> String {
        format!("the term {term} is left out of {}", self.show(within))
    }
}

fn constant(number: f64) -> Instances {
    let single = f64::from(rounded(number));
    let what = || format!("the constant {number} has single precision");
    let instance = || (Sort::Constant, what(), Instead::Op(Op::Number(single.to_bits())));
    (single != number && single.is_finite()).then(instance).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect_file;

    #[test]
    fn constants_of_single_precision_are_others() {
        let others = |number: f64| constant(number).into_iter().map(|(_, what, _)| what).collect::<Vec<_>>();
        assert_eq!(others(0.1), ["the constant 0.1 has single precision"]);
        assert_eq!([0.5, -2.0, 1e300].map(|number| others(number).len()), [0; 3]);
    }

    /// All mistakes in the values of a few formulas, and the resulting outputs.
    #[test]
    fn all_mistakes_and_what_comes_of_them() {
        let of = |(id, at): (&str, &[f64])| {
            let formula = jointproof::catalog::find(id).unwrap();
            let graph = formula.graph().unwrap();
            let described = |mistake: Mistake| {
                let altered = graph.altered(mistake.place, &mistake.instead);
                let all = altered.results(at, altered.needed(&altered.value));
                let values: Vec<_> = altered.value.iter().map(|node| format!("{:.5}", all[node.index()])).collect();
                format!("  {:?}: {}: {}\n", mistake.sort, mistake.what, values.join(" "))
            };
            let mistakes = mistakes(&graph, formula.inputs(), &graph.value);
            format!("{id}\n{}", mistakes.into_iter().map(described).collect::<String>())
        };
        let formulas: [(&str, &[f64]); 5] = [
            ("slot.friction", &[-7.0, 3.0, 4.5, -1.5, 0.3]),
            ("coulomb.return_map", &[-7.0, 0.3, 11.0]),
            ("interaction.pressure_exponential", &[0.1, 0.7, 1.3]),
            ("slider.line", &[0.3, -0.7, 1.1, 2.3, 0.9, -1.7]),
            ("slot.constraint_2d", &[0.6, 0.8, 1.1, -0.3, 2.7, 1.9, 0.2]),
        ];
        expect_file!["../../tests/printed/mistakes.txt"].assert_eq(&formulas.map(of).concat());
    }
}
