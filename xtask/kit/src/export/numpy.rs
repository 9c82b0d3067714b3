//! NumPy: every formula over arrays, with both branches of every choice computed.

use super::c::{Names, common, signed};
use super::language::{File, Language, Toolchain};
use super::program::folded;
use super::recorded::{Function, Recorded, Shape, Subject, Text, description, refusals, required, stem, unreserved};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Node, Op, Unary};

pub(super) struct NumPy;

pub(super) const RUNTIME: &str = include_str!("runtime/jp_runtime.py");
const DRIVER: &str = include_str!("runtime/driver.py");
/// Elements as constraints of Exudyn.
const EXUDYN: &str = include_str!("runtime/exudyn_connector.py");
/// Reserved words of Python, and names used in the functions themselves.
const RESERVED: [&str; 4] = ["lambda", "in", "np", "given"];

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "np.abs",
        Unary::Root => "np.sqrt",
        Unary::Sine => "np.sin",
        Unary::Cosine => "np.cos",
        Unary::ArcSine => "asin",
        Unary::Exponential => "np.exp",
        Unary::ExponentialMinusOne => "expm1",
        Unary::PowerOfTwo => "power_of_two",
        Unary::NearestInteger => "nearest_integer",
    },
    angle: "angle",
    maximum: "np.fmax",
    multiply_add: "multiply_add",
    norm: "norm",
    search: str::to_owned,
    equal: "==",
};

impl Language for NumPy {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        let mut files = vec![
            ("jp_runtime.py".to_owned(), RUNTIME.to_owned()),
            ("jointproof_numpy.py".to_owned(), index(recorded)),
            ("driver.py".to_owned(), DRIVER.to_owned()),
        ];
        files.extend(recorded.iter().map(|one| (format!("jp_{}.py", stem(one)), source(one))));
        if recorded.iter().any(|one| matches!(one.subject, Subject::Element(..))) {
            files.push(("exudyn_connector.py".to_owned(), EXUDYN.to_owned()));
        }
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        let commands = vec![vec!["python3".to_owned(), "driver.py".to_owned()]];
        vec![Toolchain { name: "python3", commands, epsilons: 64.0 }]
    }
}

fn index(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "\"\"\"Formulas with their Jacobians, and elements, over arrays, printed by jointproof from the program that it proves.\n\n\
         `jacobian(f1, e1a, ...)` of each module gives the components of the value, an array of shape (m, ...), and the\n\
         Jacobian, of shape (m, n, ...), for inputs that broadcast against each other; a vector has its components along\n\
         its first axis. `step(...)` of an element gives its outputs and matrices, of shapes (m, ...) and (m, n, ...), in the\n\
         order in which its module tells them. They raise ValueError where inputs are refused; `refused(...)` gives 0, or why inputs are refused.\n\"\"\"\n\n",
    );
    for one in recorded {
        text.push(format!("import jp_{0} as {0}\n", stem(one)));
    }
    text.push("\nFORMULAS = [\n");
    for one in recorded {
        text.push(format!("    {},\n", stem(one)));
    }
    text.push("]\n");
    text.finished()
}

fn name_of(field: &Field) -> String {
    unreserved(field.name, &RESERVED)
}

pub(super) fn source(one: &Recorded) -> String {
    let mut text = Text::from(format!("r\"\"\"{}\n\n0 is returned by refused(...), or\n", description(one).join("\n")));
    text.push_all(refusals(one).iter().map(|line| format!("{line}\n")));
    text.push(
        "\"\"\"\n\nimport numpy as np\n\nfrom jp_runtime import (\n    accepted, angle, arrays, asin, code, exact_sum, expm1, multiply_add, nearest_integer, nearest_place, \
         norm2,\n    norm3, norm4, over_arrays, power_of_two, stacked,\n)\n\n",
    );
    let functions = one.functions();
    let inputs: Vec<_> = one.inputs().iter().map(|field| (field.name, field.len())).collect();
    let outputs: Vec<_> = functions[0].outputs.iter().map(|output| (output.name, output.len())).collect();
    for (name, all) in [("INPUTS", inputs), ("OUTPUTS", outputs)] {
        let lines: Vec<_> = all.iter().map(|(name, len)| format!("    ('{name}', {len}),\n")).collect();
        text.push(format!("{name} = [\n{}]\n", lines.concat()));
    }
    let texts = required(one).into_iter().map(|text| format!("    {text:?},\n")).collect::<Vec<_>>().concat();
    text.push(format!("REQUIRED = [\n{texts}]\n"));
    text.push_all(functions.iter().map(|printed| function(one, printed)));
    text.push(refused(one));
    text.finished()
}

/// A function that returns results: of a formula the value, and the Jacobian, of an element each output.
fn function(one: &Recorded, function: &Function) -> String {
    let Function { name, outputs } = function;
    let inputs: Vec<_> = one.inputs().iter().map(name_of).collect();
    let (value, jacobian) = (&one.graph.value[..], &one.graph.jacobian[..]);
    let lists: Vec<(&[Node], Option<usize>)> = match one.subject {
        Subject::Formula(_) if outputs.iter().any(|output| matches!(output.shape, Shape::Matrix(..))) => {
            vec![(value, None), (jacobian, Some(value.len()))]
        }
        Subject::Formula(_) => vec![(value, None)],
        Subject::Element(..) => {
            let rows = |shape| if let Shape::Matrix(rows, _) = shape { Some(rows) } else { None };
            outputs.iter().map(|output| (one.nodes(output), rows(output.shape))).collect()
        }
    };
    let stacked = lists.iter().map(|(nodes, rows)| {
        let texts: Vec<_> = nodes.iter().map(|&node| text(one, node)).collect();
        let rows = rows.map_or(String::new(), |rows| format!(", rows={rows}"));
        format!("stacked(given, [{}]{rows})", texts.join(", "))
    });
    let stacked: Vec<_> = stacked.collect();
    let all: Vec<Node> = lists.iter().flat_map(|(nodes, _)| *nodes).copied().collect();
    let accepted = short(&format!("    accepted(refused({}), given, REQUIRED)", inputs.join(", ")));
    let returned = short(&format!("    return ({})", stacked.join(", ")));
    format!("{}{accepted}\n{}{returned}\n", head(name, &inputs), lines(one, &all))
}

/// The head of a function whose inputs are lists of components.
fn head(name: &str, inputs: &[String]) -> String {
    let inputs = inputs.join(", ");
    let def = short(&format!("def {name}({inputs}):"));
    format!("\n\n@over_arrays\n{def}\n{}\n", short(&format!("    given = arrays(INPUTS, [{inputs}])")))
}

fn short(line: &str) -> String {
    folded(line, "").join("\n")
}

/// The inputs by name, and a line for every operation that these results need.
fn lines(one: &Recorded, results: &[Node]) -> String {
    let mut lines = Vec::new();
    for (k, field) in one.inputs().iter().enumerate() {
        let name = name_of(field);
        lines.push(if field.len() == 1 {
            format!("    [{name}] = given[{k}]\n")
        } else {
            format!("    {name} = given[{k}]\n")
        });
    }
    for node in one.graph.needed(results) {
        if !one.graph.is_atom(node) {
            lines.push(short(&format!("    {} = {}", text(one, node), operation(one, node))) + "\n");
        }
    }
    lines.concat()
}

/// The text of a result where it is used.
fn text(one: &Recorded, node: Node) -> String {
    match one.graph.op(node) {
        Op::Input(k) => input(one.inputs(), *k),
        Op::Number(bits) => match f64::from_bits(*bits) {
            x if x.is_infinite() => {
                if x > 0.0 {
                    "np.inf".into()
                } else {
                    "(-np.inf)".into()
                }
            }
            x => signed(&format!("{x:?}"), x),
        },
        _ => one.names.get(&node).cloned().unwrap_or_else(|| format!("t{}", node.index())),
    }
}

fn input(fields: &[Field], mut k: usize) -> String {
    for field in fields {
        if k < field.len() {
            return if field.len() == 1 { name_of(field) } else { format!("{}[{k}]", name_of(field)) };
        }
        k -= field.len();
    }
    unreachable!("a graph has the inputs of its formula")
}

fn operation(one: &Recorded, node: Node) -> String {
    let operand = |node| text(one, node);
    match one.graph.op(node) {
        Op::Select(condition, yes, no) => {
            format!("np.where({}, {}, {})", operand(*condition), operand(*yes), operand(*no))
        }
        Op::ExactSum(products) => {
            let factors: Vec<_> = products.iter().flatten().map(|&factor| operand(factor)).collect();
            format!("exact_sum({})", factors.join(", "))
        }
        op => common(op, &operand, &NAMES),
    }
}

fn refused(one: &Recorded) -> String {
    let inputs: Vec<_> = one.inputs().iter().map(name_of).collect();
    let bounds = one.inputs().iter().map(|field| {
        let bounds: Vec<_> = field
            .quantity
            .domain
            .comparisons()
            .iter()
            .map(|(relation, bound)| format!("lambda x: x {relation} {bound:?}"))
            .collect();
        format!("        [{}],\n", bounds.join(", "))
    });
    let refusal: Vec<Node> = one.graph.refusal.into_iter().collect();
    let together = refusal.first().map_or_else(|| "0.0".to_owned(), |&node| text(one, node));
    let bounds: Vec<_> = bounds.collect();
    let (head, lines) = (head("refused", &inputs), lines(one, &refusal));
    format!("{head}{lines}    return code(given, [\n{}    ], {together})\n", bounds.concat())
}

#[cfg(test)]
mod tests {
    use super::super::recorded::formulas;
    use super::*;

    #[test]
    fn the_module_names_every_formula() {
        let files = NumPy.files(&formulas(&["coulomb.yield", "slot.contact_force"]));
        let named = |text: &str| text.contains("FORMULAS = [\n    coulomb_yield,\n    slot_contact_force,\n]\n");
        assert_eq!(files.iter().filter(|(_, text)| named(text)).count(), 1);
    }
}
