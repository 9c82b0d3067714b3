//! FPCore, the exchange format of `FPBench`: an expression for every output and every derivative of a formula, for
//! tools that bound or improve rounding errors.

use super::c::NAMES;
use super::language::{File, Language, Toolchain};
use super::recorded::{Recorded, Subject, Text, stem};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Node, Op, Relation, Unary};

pub(super) struct FpCore;

impl Language for FpCore {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        recorded.iter().map(|one| (format!("{}.fpcore", stem(one)), source(one))).collect()
    }

    fn refuses(&self, one: &Recorded) -> Option<&'static str> {
        if matches!(one.subject, Subject::Element(..)) {
            return Some("its results share operations, and FPCore has an expression for each result alone");
        }
        let searches = one.graph.ops().iter().any(|op| matches!(op, Op::Search(..)));
        searches.then_some("it searches in a loop, and FPCore has expressions alone")
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        Vec::new()
    }
}

/// The names of components: `e1a_1` for the first of a vector.
fn components(fields: &[Field]) -> Vec<String> {
    let of = |field: &Field| match field.len() {
        1 => vec![field.name.to_owned()],
        len => (1..=len).map(|k| format!("{}_{k}", field.name)).collect(),
    };
    fields.iter().flat_map(of).collect()
}

fn source(one: &Recorded) -> String {
    let Subject::Formula(formula) = one.subject else { unreachable!("elements are refused") };
    let spec = formula.spec();
    let (inputs, outputs) = (components(formula.inputs()), components(formula.outputs()));
    let mut text =
        Text::from(format!("; {}: {}\n; Printed by jointproof; free of conditions (CC0-1.0).\n", spec.id, spec.title));
    for (output, &node) in outputs.iter().zip(&one.graph.value) {
        text.push(core(one, &inputs, (output.clone(), format!("{}: {output}", spec.id)), node));
    }
    for (k, &node) in one.graph.jacobian.iter().enumerate() {
        let (output, input) = (&outputs[k / inputs.len()], &inputs[k % inputs.len()]);
        let name = (format!("{output}_by_{input}"), format!("{}: d {output} / d {input}", spec.id));
        text.push(core(one, &inputs, name, node));
    }
    text.finished()
}

/// An expression for one result.
fn core(one: &Recorded, inputs: &[String], (symbol, name): (String, String), result: Node) -> String {
    let printed = Printed { one, inputs };
    let is_bound = |node: &Node| !one.graph.is_atom(*node) && !one.graph.is_answer(*node);
    let bound = one.graph.needed(&[result]).into_iter().filter(is_bound);
    let bindings = bound.map(|node| format!("\n    [{} {}]", printed.text(node), printed.operation(node)));
    let bindings: Vec<_> = bindings.collect();
    format!(
        "\n(FPCore {}_{symbol} ({})\n  :name \"{name}\"\n  :precision binary64\n{}  (let* ({})\n    {}))\n",
        stem(one),
        inputs.join(" "),
        precondition(one),
        bindings.concat(),
        printed.text(result)
    )
}

fn precondition(one: &Recorded) -> String {
    let bound = |field: &Field| {
        let names = components(std::slice::from_ref(field));
        let bounds = field.quantity.domain.comparisons();
        let of = |name: &String| {
            let bounds = bounds.iter().map(|(relation, bound)| format!("({relation} {name} {})", number(*bound)));
            bounds.collect::<Vec<_>>()
        };
        names.iter().flat_map(of).collect::<Vec<_>>()
    };
    let bounds: Vec<_> = one.inputs().iter().flat_map(bound).collect();
    if bounds.is_empty() { String::new() } else { format!("  :pre (and {})\n", bounds.join(" ")) }
}

fn number(x: f64) -> String {
    match x {
        f64::INFINITY => "INFINITY".into(),
        f64::NEG_INFINITY => "(- INFINITY)".into(),
        x => format!("{x:?}"),
    }
}

struct Printed<'a> {
    one: &'a Recorded,
    inputs: &'a [String],
}

impl Printed<'_> {
    /// The text of a result where it is used; Booleans are written in place.
    fn text(&self, node: Node) -> String {
        match self.one.graph.op(node) {
            Op::Input(k) => self.inputs[*k].clone(),
            Op::Number(bits) => number(f64::from_bits(*bits)),
            _ if self.one.graph.is_answer(node) => self.operation(node),
            _ => format!("t{}", node.index()),
        }
    }

    fn operation(&self, node: Node) -> String {
        let call = |function: &str, operands: &[Node]| {
            let operands: Vec<_> = operands.iter().map(|&node| self.text(node)).collect();
            format!("({function} {})", operands.join(" "))
        };
        match self.one.graph.op(node) {
            Op::Unary(Unary::PowerOfTwo, x) => format!("(exp2 (floor (log2 {})))", self.text(*x)),
            Op::Unary(Unary::ArcSine, x) => call("asin", &[*x]),
            Op::Unary(function, x) => call((NAMES.unary)(*function), &[*x]),
            Op::Binary(operation, x, y) => call(binary(*operation), &[*x, *y]),
            Op::MultiplyAdd(x, y, z) => call("fma", &[*x, *y, *z]),
            Op::Norm(parts) => {
                let squares = parts.iter().map(|&part| format!("(* {0} {0})", self.text(part)));
                format!("(sqrt {})", squares.reduce(|sum, square| format!("(+ {sum} {square})")).unwrap_or_default())
            }
            Op::ExactSum(products) => {
                let products = products.iter().map(|product| {
                    let [a, b, c, d] = product.map(|factor| self.text(factor));
                    format!("(* (* (* {a} {b}) {c}) {d})")
                });
                products.reduce(|sum, product| format!("(+ {sum} {product})")).unwrap_or_else(|| "0.0".into())
            }
            Op::Compare(Relation::Less, x, y) => call("<", &[*x, *y]),
            Op::Compare(Relation::LessOrEqual, x, y) => call("<=", &[*x, *y]),
            Op::Compare(Relation::Equal, x, y) => call("==", &[*x, *y]),
            Op::Select(condition, yes, no) => call("if", &[*condition, *yes, *no]),
            Op::Search(..) | Op::Input(_) | Op::Number(_) => {
                unreachable!("searches are left out, and atoms are no operations")
            }
        }
    }
}

fn binary(operation: Binary) -> &'static str {
    match operation {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Divide => "/",
        Binary::Angle => "atan2",
        Binary::Maximum => "fmax",
    }
}

#[cfg(test)]
mod tests {
    use super::super::recorded::{element_of, formulas};
    use super::*;
    use jointproof::catalog::find;
    use jointproof::toolkit::measure::Options;
    use std::collections::HashMap;

    /// A list, or a word.
    enum Tree {
        List(Vec<Self>),
        Word(String),
    }

    fn parsed(text: &str) -> Vec<Tree> {
        let without_comments: Vec<_> = text.lines().filter(|line| !line.starts_with(';')).collect();
        let spaced = without_comments.join("\n").replace(['(', '['], " ( ").replace([')', ']'], " ) ");
        let mut stack = vec![Vec::new()];
        for word in spaced.split_whitespace() {
            match word {
                "(" => stack.push(Vec::new()),
                ")" => {
                    let list = stack.pop().unwrap();
                    stack.last_mut().expect("parentheses match").push(Tree::List(list));
                }
                word => stack.last_mut().unwrap().push(Tree::Word(word.to_owned())),
            }
        }
        assert_eq!(stack.len(), 1, "parentheses match");
        stack.pop().unwrap()
    }

    fn evaluated(tree: &Tree, names: &mut HashMap<String, f64>) -> f64 {
        let items = match tree {
            Tree::Word(word) => return names.get(word).copied().unwrap_or_else(|| word.parse().unwrap()),
            Tree::List(items) => items,
        };
        let [Tree::Word(function), rest @ ..] = items.as_slice() else { panic!("a call begins with a word") };
        if function == "let*" {
            let [Tree::List(bindings), body] = rest else { panic!("let* has bindings and a body") };
            for binding in bindings {
                let Tree::List(pair) = binding else { panic!("a binding is a pair") };
                let [Tree::Word(name), value] = pair.as_slice() else { panic!("a binding has a name") };
                let value = evaluated(value, names);
                names.insert(name.clone(), value);
            }
            return evaluated(body, names);
        }
        let x: Vec<_> = rest.iter().map(|operand| evaluated(operand, names)).collect();
        let answer = |holds: bool| f64::from(u8::from(holds));
        match (function.as_str(), x.as_slice()) {
            ("+", [x, y]) => x + y,
            ("-", [x]) => -x,
            ("-", [x, y]) => x - y,
            ("*", [x, y]) => x * y,
            ("/", [x, y]) => x / y,
            ("fma", [x, y, z]) => x.mul_add(*y, *z),
            ("sqrt", [x]) => x.sqrt(),
            ("fabs", [x]) => x.abs(),
            ("round", [x]) => x.round(),
            ("asin", [x]) => jointproof::number::scalar::asin(*x),
            ("expm1", [x]) => jointproof::number::scalar::exp_m1(*x),
            ("atan2", [y, x]) => jointproof::number::scalar::atan2(*y, *x),
            ("<", [x, y]) => answer(x < y),
            ("<=", [x, y]) => answer(x <= y),
            ("==", [x, y]) => answer(x == y),
            ("if", [condition, yes, no]) => {
                if *condition == 1.0 {
                    *yes
                } else {
                    *no
                }
            }
            (function, x) => panic!("{function} of {} numbers", x.len()),
        }
    }

    #[test]
    fn searches_and_elements_are_refused() {
        let recorded = formulas(&["slide_line.closest_parabolic", "slot.friction"]);
        let [searches, computes] = [0, 1].map(|k| FpCore.refuses(&recorded[k]));
        assert!(searches.is_some_and(|why| why.contains("it searches in a loop")) && computes.is_none());
        let why = FpCore.refuses(&element_of("universal")[0]);
        assert!(why.is_some_and(|why| why.contains("share operations")));
    }

    /// The output is parsed and evaluated: at ordinary points it has the bits of the formula.
    #[test]
    fn expressions_have_the_bits_of_the_formula() {
        for id in ["slot.friction", "coulomb.return_map", "cardan.angles", "interaction.damping", "join.rows"] {
            let formula = find(id).unwrap();
            let recorded = formulas(&[id]);
            let one = &recorded[0];
            let cores = parsed(&source(one));
            let options = Options { timing_points: 20, ..Options::quick() };
            let names = components(formula.inputs());
            for point in formula.timing_inputs(&options).chunks(names.len()) {
                let (value, jacobian) = one.graph.run(point);
                assert_eq!(cores.len(), value.len() + jacobian.len());
                for (core, expected) in cores.iter().zip(value.iter().chain(&jacobian)) {
                    let Tree::List(items) = core else { panic!("a core is a list") };
                    let mut known = names.iter().cloned().zip(point.iter().copied()).collect();
                    let found = evaluated(items.last().unwrap(), &mut known);
                    assert_eq!(found.to_bits(), expected.to_bits(), "{id} at {point:?}");
                }
            }
        }
    }
}
