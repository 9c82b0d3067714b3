//! JavaScript, as ES modules.

use super::c::{Names, common, exact_sum, signed};
use super::language::{Language, Operand, Toolchain};
use super::program::Body;
use super::recorded::{Recorded, Text, bounds, description, stem};
use jointproof::formula::Field;
use jointproof::graph::{Op, Unary};

pub(super) struct JavaScript;

/// By how much functions such as the sine may differ from Rust's: see [`Toolchain::epsilons`].
pub(super) const EPSILONS: f64 = 64.0;

pub(super) const RUNTIME: &str = include_str!("runtime/jp_runtime.mjs");

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "Math.abs",
        Unary::Root => "Math.sqrt",
        Unary::Sine => "Math.sin",
        Unary::Cosine => "Math.cos",
        Unary::ArcSine => "Math.asin",
        Unary::Exponential => "Math.exp",
        Unary::ExponentialMinusOne => "Math.expm1",
        Unary::PowerOfTwo => "powerOfTwo",
    },
    angle: "Math.atan2",
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
    fn files(&self, recorded: &[Recorded]) -> Vec<(String, String)> {
        let mut files = vec![
            ("jp_runtime.mjs".to_owned(), RUNTIME.to_owned()),
            ("jointproof.mjs".to_owned(), index(recorded)),
            ("driver.mjs".to_owned(), driver(recorded)),
        ];
        files.extend(recorded.iter().map(|one| (format!("jp_{}.mjs", stem(one)), self.source(one))));
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        vec![Toolchain { name: "node", commands: vec![vec!["node".into(), "driver.mjs".into()]], epsilons: EPSILONS }]
    }

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
            Op::Select(condition, yes, no) => {
                format!("{} ? {} : {}", operand(*condition), operand(*yes), operand(*no))
            }
            Op::ExactSum(products) => exact_sum(products, operand, ["exactSum([", "[", "]", "])"]),
            op => common(op, operand, &NAMES),
        }
    }

    fn set(&self, name: &str, _: bool, value: &str) -> String {
        format!("const {name} = {value};")
    }

    fn announce(&self, name: &str) -> Option<String> {
        Some(format!("let {name};"))
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) {{"), "} else {".into(), "}".into()]
    }
}

impl JavaScript {
    pub(super) fn source(&self, one: &Recorded) -> String {
        let lines: Vec<_> = description(one).iter().map(|line| format!("// {line}").trim_end().to_owned()).collect();
        let mut text = Text::from(lines.join("\n"));
        text.push("\nimport { exactSum, multiplyAdd, nearestPlace, norm2, norm3, norm4, powerOfTwo } from './jp_runtime.mjs';\n\n");
        text.push("export const inputs = [\n");
        for field in one.formula.inputs() {
            let bounds: Vec<_> = bounds(field.quantity.domain)
                .iter()
                .map(|(relation, bound)| format!("(x) => x {relation} {}", self.number(*bound)))
                .collect();
            let (name, len) = (field.name, field.len());
            text.push(format!("    {{ name: '{name}', length: {len}, allowed: [{}] }},\n", bounds.join(", ")));
        }
        text.push("];\n\nexport const outputs = [\n");
        for field in one.formula.outputs() {
            text.push(format!("    {{ name: '{}', length: {} }},\n", field.name, field.len()));
        }
        text.push("];\n");
        let body = Body { language: self, graph: &one.graph, inputs: one.formula.inputs() };
        for (name, with_jacobian) in [("value", false), ("jacobian", true)] {
            let results = [one.graph.value.as_slice(), if with_jacobian { &one.graph.jacobian } else { &[] }].concat();
            let lines = body.lines(&results, 1).text.join("\n");
            let list = |nodes: &[_]| {
                let entries: Vec<_> = nodes.iter().map(|&node| format!("        {},\n", body.text(node))).collect();
                format!("[\n{}    ]", entries.concat())
            };
            let jacobian =
                if with_jacobian { format!(", jacobian: {}", list(&one.graph.jacobian)) } else { String::new() };
            let value = list(&one.graph.value);
            text.push(format!(
                "\nexport function {name}(i) {{\n{lines}\n    return {{ value: {value}{jacobian} }};\n}}\n"
            ));
        }
        text.finished()
    }
}

fn index(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "// Formulas with their Jacobians, printed by jointproof from the program that it proves.\n\
         // `value(i)` gives the outputs one after the other, `jacobian(i)` every derivative too, output by output, each\n\
         // over all inputs in order; i has the inputs by name. `refused(formula, i)` names the input that is not allowed.\n\n\
         export { refused } from './jp_runtime.mjs';\n",
    );
    for one in recorded {
        text.push(format!("export * as {} from './jp_{}.mjs';\n", stem(one), stem(one)));
    }
    text.finished()
}

fn driver(recorded: &[Recorded]) -> String {
    let formulas: Vec<_> = recorded.iter().map(|one| format!("jp.{}", stem(one))).collect();
    format!(
        "// Evaluates every formula at the points of points.bin, and writes found.bin.\n\
         import {{ readFileSync, writeFileSync }} from 'node:fs';\nimport * as jp from './jointproof.mjs';\n\n\
         const bytes = readFileSync('points.bin');\nconst points = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);\n\
         const found = [];\nlet at = 0;\nconst formulas = [\n    {},\n];\n\
         for (const formula of formulas) {{\n    const count = Number(points.getBigUint64(at, true));\n    at += 8;\n\
         \x20   const next = () => points.getFloat64((at += 8) - 8, true);\n\
         \x20   for (let k = 0; k < count; ++k) {{\n        const i = {{}};\n\
         \x20       for (const {{ name, length }} of formula.inputs) {{\n\
         \x20           i[name] = length === 1 ? next() : Array.from({{ length }}, next);\n        }}\n\
         \x20       const code = jp.refused(formula, i)?.position ?? 0;\n\
         \x20       const {{ value, jacobian }} = formula.jacobian(i);\n\
         \x20       found.push(code, ...value, ...jacobian);\n    }}\n}}\n\
         writeFileSync('found.bin', Buffer.from(new Float64Array(found).buffer));\n",
        formulas.join(",\n    ")
    )
}
