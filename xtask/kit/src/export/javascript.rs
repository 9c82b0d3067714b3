//! JavaScript, as ES modules.

use super::c::{Names, common, exact_sum, signed};
use super::language::{File, Language, Operand, Syntax, Toolchain};
use super::program::{Body, Functions, Lines, PartLines, folded, functions_of};
use super::recorded::{Function, Output, Recorded, Subject, Text, description, refusals, stem};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Node, Op, Unary};

pub(super) struct JavaScript;

/// The tolerance for functions such as the sine, compared with Rust: see [`Toolchain::epsilons`].
pub(super) const EPSILONS: f64 = 64.0;

pub(super) const RUNTIME: &str = include_str!("runtime/jp_runtime.mjs");

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "Math.abs",
        Unary::Root => "Math.sqrt",
        Unary::Sine => "Math.sin",
        Unary::Cosine => "Math.cos",
        Unary::ArcSine => "asin",
        Unary::Exponential => "Math.exp",
        Unary::ExponentialMinusOne => "expm1",
        Unary::PowerOfTwo => "powerOfTwo",
        Unary::NearestInteger => "nearestInteger",
    },
    angle: "angle",
    maximum: "Math.max",
    multiply_add: "multiplyAdd",
    norm: "norm",
    search: camel_case,
    equal: "===",
};

fn camel_case(name: &str) -> String {
    let mut words = name.split('_').map(str::to_owned);
    let first = words.next().unwrap_or_default();
    words.fold(first, |name, word| name + &word[..1].to_uppercase() + &word[1..])
}

impl Language for JavaScript {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        let mut files = vec![
            ("jp_runtime.mjs".to_owned(), RUNTIME.to_owned()),
            ("jointproof.mjs".to_owned(), index(recorded)),
            ("driver.mjs".to_owned(), driver(recorded)),
        ];
        files
            .extend(recorded.iter().map(|one| (format!("jp_{}.mjs", stem(one)), module(one, functions_of(self, one)))));
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        vec![Toolchain { name: "node", commands: vec![vec!["node".into(), "driver.mjs".into()]], epsilons: EPSILONS }]
    }
}

impl Functions for JavaScript {
    /// A formula gives its value and its Jacobian, an element each of its outputs by its name.
    fn function(&self, one: &Recorded, body: &Body, lines: &Lines, Function { name, outputs }: &Function) -> String {
        let list = |nodes: &[Node]| {
            let entries: Vec<_> = nodes.iter().map(|&node| body.text(lines, node)).collect();
            folded(&format!("        {},", entries.join(", ")), "").join("\n")
        };
        let listed = |name: &str, nodes: &[Node]| format!("{name}: [\n{}\n    ]", list(nodes));
        let lists = match one.subject {
            Subject::Formula(_) => {
                let jacobian = (*name == "jacobian").then(|| listed("jacobian", &one.graph.jacobian));
                [listed("value", &one.graph.value)].into_iter().chain(jacobian).collect::<Vec<_>>()
            }
            Subject::Element(..) => outputs.iter().map(|output| listed(output.name, one.nodes(output))).collect(),
        };
        let together = one.graph.refusal.map_or_else(String::new, |node| {
            let code = body.text(lines, node);
            format!("\n    if ({code} > 0) return {{ refusal: {} + {code} }};", one.inputs().len())
        });
        format!(
            "\nexport function {name}(i) {{\n    const refused = refusalOf(inputs, i);\n    if (refused) return refused;\n{}{together}\n\
             \x20   return {{ refusal: 0, {} }};\n}}\n",
            lines.text.join("\n"),
            lists.join(", "),
        )
    }

    fn part(&self, _: &str, part: &PartLines) -> String {
        let found: Vec<_> = (0..part.found).map(|_| "0").collect();
        format!(
            "\nfunction part{}(i, given) {{\n{}\n{}\n    return found;\n}}\n",
            part.number,
            folded(&format!("    const found = [{}];", found.join(", ")), "").join("\n"),
            part.lines.text.join("\n")
        )
    }
}

impl Syntax for JavaScript {
    fn number(&self, x: f64) -> String {
        if x.is_infinite() {
            return if x > 0.0 { "Infinity".into() } else { "(-Infinity)".into() };
        }
        signed(&format!("{x:?}"), x)
    }

    fn argument(&self, field: &Field, component: usize) -> String {
        if field.len() == 1 { format!("i.{}", field.name) } else { format!("i.{}[{component}]", field.name) }
    }

    fn operation(&self, op: &Op, operand: Operand) -> String {
        match op {
            Op::ExactSum(products) => exact_sum(products, operand, ["exactSum([", "[", "]", "])"]),
            op => common(op, operand, &NAMES),
        }
    }

    fn set(&self, name: &str, _: bool, value: &str) -> String {
        format!("const {name} = {value};")
    }

    fn announce(&self, name: &str, _: bool) -> Option<String> {
        Some(format!("let {name};"))
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn element(&self, array: &str, k: usize, _: bool) -> String {
        format!("{array}[{k}]")
    }

    fn call(&self, _: &str, part: usize, inputs: &[[&Field; 2]], given: &[String], found: (&str, usize)) -> String {
        let others: Vec<_> = inputs.iter().filter(|[name, passed]| name != passed).collect();
        let others: Vec<_> = others.iter().map(|[name, passed]| format!("{}: i.{}", name.name, passed.name)).collect();
        let inputs = if others.is_empty() { "i".to_owned() } else { format!("{{ ...i, {} }}", others.join(", ")) };
        format!("const {} = part{part}({inputs}, [{}]);", found.0, given.join(", "))
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) {{"), "} else {".into(), "}".into()]
    }
}

/// The module of these functions of a formula or an element.
pub(super) fn module(one: &Recorded, functions: Vec<String>) -> String {
    let head = [description(one), vec!["refusal is 0, or the only result:".into()], refusals(one)].concat();
    let lines: Vec<_> = head.iter().map(|line| format!("// {line}").trim_end().to_owned()).collect();
    let mut text = Text::from(lines.join("\n") + "\n");
    text.push(
        "import {\n    angle, asin, exactSum, expm1, multiplyAdd, nearestInteger, nearestPlace, norm2, norm3, norm4,\n    \
         powerOfTwo, refusalOf,\n} from './jp_runtime.mjs';\n",
    );
    text.push(fields(one));
    text.push_all(functions);
    text.finished()
}

/// Inputs and outputs, and the conditions that inputs must satisfy together.
fn fields(one: &Recorded) -> String {
    let mut text = Text::from("\nexport const inputs = [\n");
    for field in one.inputs() {
        let bounds = field.quantity.domain.comparisons();
        let bounds =
            bounds.iter().map(|(relation, bound)| format!("(x) => x {relation} {}", JavaScript.number(*bound)));
        let (name, len) = (field.name, field.len());
        let bounds: Vec<_> = bounds.collect();
        text.push(format!("    {{ name: '{name}', length: {len}, allowed: [{}] }},\n", bounds.join(", ")));
    }
    text.push("];\n\nexport const outputs = [\n");
    for output in &one.functions()[0].outputs {
        text.push(format!("    {{ name: '{}', length: {} }},\n", output.name, output.len()));
    }
    text.push("];\n\n// What inputs must be beside that.\nexport const required = [\n");
    for error in &one.graph.refusals {
        text.push(format!("    '{}',\n", error.required()));
    }
    text.push("];\n");
    text.finished()
}

fn index(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "// Formulas with their Jacobians, and elements, printed by jointproof from the program that it\n\
         // proves. `value(i)` gives the outputs one after the other, `jacobian(i)` every derivative too,\n\
         // output by output, each over all inputs in order; i has the inputs by name. `step(i)` of an\n\
         // element gives its outputs by their names, matrices row by row. Where inputs are refused,\n\
         // `refusal` is not 0, and there is no other result; `refused(formula, i)` says why. A result\n\
         // that is too large for a number is infinite.\n\n\
         export { refused } from './jp_runtime.mjs';\n",
    );
    for one in recorded {
        text.push(format!("export * as {} from './jp_{}.mjs';\n", stem(one), stem(one)));
    }
    text.finished()
}

fn driver(recorded: &[Recorded]) -> String {
    let formula = |one: &Recorded| {
        let numbers: usize = one.largest_function().outputs.iter().map(Output::len).sum();
        format!("[jp.{}, {numbers}]", stem(one))
    };
    let formulas: Vec<_> = recorded.iter().map(formula).collect();
    format!(
        "// Evaluates every formula and every element at the points of points.bin, and writes found.bin.\n\
         import {{ readFileSync, writeFileSync }} from 'node:fs';\nimport * as jp from './jointproof.mjs';\n\n\
         const bytes = readFileSync('points.bin');\nconst points = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);\n\
         const found = [];\nlet at = 0;\nconst formulas = [\n    {},\n];\n\
         for (const [formula, numbers] of formulas) {{\n    const count = Number(points.getBigUint64(at, true));\n    at += 8;\n\
         \x20   const next = () => points.getFloat64((at += 8) - 8, true);\n\
         \x20   for (let k = 0; k < count; ++k) {{\n        const i = {{}};\n\
         \x20       for (const {{ name, length }} of formula.inputs) {{\n\
         \x20           i[name] = length === 1 ? next() : Array.from({{ length }}, next);\n        }}\n\
         \x20       const {{ refusal, ...results }} = (formula.step ?? formula.jacobian ?? formula.value)(i);\n\
         \x20       const all = Object.values(results).flat();\n\
         \x20       found.push(refusal, ...(refusal > 0 ? Array(numbers).fill(0) : all));\n    }}\n}}\n\
         writeFileSync('found.bin', Buffer.from(new Float64Array(found).buffer));\n",
        formulas.join(",\n    ")
    )
}
