//! C99.

use super::language::{Language, Operand, Toolchain};
use super::program::Body;
use super::recorded::{Recorded, Text, bounds, description, stem, unreserved};
use jointproof::formula::Field;
use jointproof::graph::{Binary, Node, Op, Relation, Unary};

pub(super) struct C;

const RUNTIME: &str = include_str!("runtime/jp_runtime.h");
/// Words of C, and what the functions themselves need.
const RESERVED: [&str; 5] = ["double", "int", "k", "jacobian", "const"];
const FLAGS: [&str; 6] = ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic"];

impl Language for C {
    fn files(&self, recorded: &[Recorded]) -> Vec<(String, String)> {
        let mut files = vec![
            ("jp_runtime.h".to_owned(), RUNTIME.to_owned()),
            ("jointproof.h".to_owned(), header(recorded)),
            ("driver.c".to_owned(), driver(recorded)),
            ("Makefile".to_owned(), makefile()),
            ("CMakeLists.txt".to_owned(), cmake()),
        ];
        files.extend(recorded.iter().map(|one| (format!("jp_{}.c", stem(one)), self.source(one))));
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        ["gcc", "clang"].map(toolchain).into()
    }

    fn number(&self, x: f64) -> String {
        if x.is_infinite() {
            return if x > 0.0 { "HUGE_VAL".into() } else { "(-HUGE_VAL)".into() };
        }
        signed(&format!("{x:?}"), x)
    }

    fn argument(&self, field: &Field, component: usize) -> String {
        let name = unreserved(field.name, &RESERVED);
        if field.len() == 1 { name } else { format!("{name}[{component}]") }
    }

    fn operation(&self, op: &Op, operand: Operand) -> String {
        match op {
            Op::Select(condition, yes, no) => {
                format!("{} ? {} : {}", operand(*condition), operand(*yes), operand(*no))
            }
            Op::ExactSum(products) => {
                let head = format!("jp_exact_sum({}, (const double[][4]){{", products.len());
                exact_sum(products, operand, [&head, "{", "}", "})"])
            }
            op => common(op, operand, &NAMES),
        }
    }

    fn set(&self, name: &str, is_answer: bool, value: &str) -> String {
        let kind = if is_answer { "int" } else { "double" };
        format!("const {kind} {name} = {value};")
    }

    fn announce(&self, name: &str) -> Option<String> {
        Some(format!("double {name};"))
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) {{"), "} else {".into(), "}".into()]
    }
}

/// What functions are called.
pub(super) struct Names {
    pub(super) unary: fn(Unary) -> &'static str,
    pub(super) angle: &'static str,
    pub(super) maximum: &'static str,
    pub(super) multiply_add: &'static str,
    pub(super) norm: &'static str,
    pub(super) search: fn(&str) -> String,
    pub(super) equal: &'static str,
}

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "fabs",
        Unary::Root => "sqrt",
        Unary::Sine => "sin",
        Unary::Cosine => "cos",
        Unary::ArcSine => "asin",
        Unary::Exponential => "exp",
        Unary::ExponentialMinusOne => "expm1",
        Unary::PowerOfTwo => "jp_power_of_two",
    },
    angle: "atan2",
    maximum: "fmax",
    multiply_add: "fma",
    norm: "jp_norm",
    search: |name| format!("jp_{name}"),
    equal: "==",
};

/// What languages write alike, but for names.
pub(super) fn common(op: &Op, operand: Operand, names: &Names) -> String {
    let call = |name: &str, operands: &[Node]| {
        let operands: Vec<_> = operands.iter().map(|&node| operand(node)).collect();
        format!("{name}({})", operands.join(", "))
    };
    let infix = |sign: &str, x: Node, y: Node| format!("{} {sign} {}", operand(x), operand(y));
    match op {
        Op::Unary(Unary::Negative, x) => format!("-{}", operand(*x)),
        Op::Unary(function, x) => call((names.unary)(*function), &[*x]),
        Op::Binary(Binary::Add, x, y) => infix("+", *x, *y),
        Op::Binary(Binary::Subtract, x, y) => infix("-", *x, *y),
        Op::Binary(Binary::Multiply, x, y) => infix("*", *x, *y),
        Op::Binary(Binary::Divide, x, y) => infix("/", *x, *y),
        Op::Binary(Binary::Angle, y, x) => call(names.angle, &[*y, *x]),
        Op::Binary(Binary::Maximum, x, y) => call(names.maximum, &[*x, *y]),
        Op::MultiplyAdd(x, y, z) => call(names.multiply_add, &[*x, *y, *z]),
        Op::Norm(parts) => call(&format!("{}{}", names.norm, parts.len()), parts),
        Op::Search(search, numbers) => call(&(names.search)(search.name), numbers),
        Op::Compare(Relation::Less, x, y) => infix("<", *x, *y),
        Op::Compare(Relation::LessOrEqual, x, y) => infix("<=", *x, *y),
        Op::Compare(Relation::Equal, x, y) => infix(names.equal, *x, *y),
        _ => unreachable!("inputs and numbers are written where they are used, and the rest by each language"),
    }
}

/// A sum of products over several lines.
pub(super) fn exact_sum(products: &[[Node; 4]], operand: Operand, [head, open, close, end]: [&str; 4]) -> String {
    let rows = products.iter().map(|product| {
        let factors = product.map(operand);
        format!("    {open}{}{close}", factors.join(", "))
    });
    let rows: Vec<_> = rows.collect();
    format!("{head}\n{}\n{end}", rows.join(",\n"))
}

/// A negative number in parentheses, lest two signs meet.
pub(super) fn signed(text: &str, x: f64) -> String {
    if x.is_sign_negative() { format!("({text})") } else { text.to_owned() }
}

impl C {
    fn source(&self, one: &Recorded) -> String {
        let mut text = Text::from(comment(&description(one)));
        text.push("#include \"jointproof.h\"\n#include \"jp_runtime.h\"\n");
        for with_jacobian in [false, true] {
            text.push(format!("\n{}\n{{\n", prototype(one, with_jacobian)));
            for (position, field) in one.formula.inputs().iter().enumerate() {
                text.push(refusal(field, position + 1));
            }
            let body = Body { language: self, graph: &one.graph, inputs: one.formula.inputs() };
            let mut results = one.graph.value.clone();
            if with_jacobian {
                results.extend(&one.graph.jacobian);
            }
            for line in body.lines(&results, 1).text {
                text.push(line + "\n");
            }
            let mut value = one.graph.value.iter();
            for field in one.formula.outputs() {
                let name = unreserved(field.name, &RESERVED);
                for (k, node) in value.by_ref().take(field.len()).enumerate() {
                    let place = if field.len() == 1 { format!("*{name}") } else { format!("{name}[{k}]") };
                    text.push(format!("    {place} = {};\n", body.text(*node)));
                }
            }
            if with_jacobian {
                for (k, node) in one.graph.jacobian.iter().enumerate() {
                    text.push(format!("    jacobian[{k}] = {};\n", body.text(*node)));
                }
            }
            text.push("    return 0;\n}\n");
        }
        text.finished()
    }
}

fn comment(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| format!(" * {line}").trim_end().to_owned()).collect();
    format!("/*\n{}\n */\n", lines.join("\n"))
}

/// Return codes: 0, or the position of the input, from 1, that is not finite or not in its domain.
fn refusal(field: &Field, code: usize) -> String {
    let name = unreserved(field.name, &RESERVED);
    let allowed = |x: &str| {
        let bounds = bounds(field.quantity.domain);
        let bounds = bounds.iter().map(|(relation, bound)| format!(" && {x} {relation} {}", C.number(*bound)));
        format!("if (!(fabs({x}) <= DBL_MAX{})) return {code};", bounds.collect::<String>())
    };
    match field.len() {
        1 => format!("    {}\n", allowed(&name)),
        len => format!("    for (int k = 0; k < {len}; ++k)\n        {}\n", allowed(&format!("{name}[k]"))),
    }
}

fn prototype(one: &Recorded, with_jacobian: bool) -> String {
    let argument = |field: &Field, kind: [&str; 2]| {
        let name = unreserved(field.name, &RESERVED);
        match field.len() {
            1 => format!("{}{name}", kind[0]),
            len => format!("{}{name}[{len}]", kind[1]),
        }
    };
    let inputs = one.formula.inputs().iter().map(|field| argument(field, ["double ", "const double "]));
    let outputs = one.formula.outputs().iter().map(|field| argument(field, ["double *", "double "]));
    let jacobian = with_jacobian.then(|| format!("double jacobian[{}]", one.graph.jacobian.len()));
    let what = if with_jacobian { "jacobian" } else { "value" };
    let arguments: Vec<_> = inputs.chain(outputs).chain(jacobian).collect();
    format!("int jp_{}_{what}(\n    {})", stem(one), arguments.join(",\n    "))
}

fn header(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "/*\n * Formulas with their Jacobians, printed by jointproof from the program that it proves.\n *\n\
         \x20* ..._value gives the outputs; ..._jacobian the outputs and every derivative, output by output,\n\
         \x20* each over all inputs in order. A return code is 0, or the position from 1 of the first input\n\
         \x20* that is not finite or not in its domain; nothing is written then.\n *\n\
         \x20* Compile without fused operations and without -ffast-math: -std=c99 -ffp-contract=off.\n */\n\
         #ifndef JOINTPROOF_H\n#define JOINTPROOF_H\n\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n",
    );
    for one in recorded {
        let spec = one.formula.spec();
        text.push(format!("\n/* {}: {} */\n", spec.id, spec.title));
        text.push(format!("{};\n{};\n", prototype(one, false), prototype(one, true)));
    }
    text.push("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    text.finished()
}

fn makefile() -> String {
    let flags = FLAGS.join(" ");
    format!(
        "CC ?= cc\nCFLAGS ?= {flags}\nOBJECTS = $(patsubst %.c,%.o,$(wildcard jp_*.c))\n\n\
         libjointproof.a: $(OBJECTS)\n\t$(AR) rcs $@ $(OBJECTS)\n\n\
         driver: driver.o libjointproof.a\n\t$(CC) -o $@ driver.o libjointproof.a -lm\n\n\
         clean:\n\trm -f *.o libjointproof.a driver\n"
    )
}

fn cmake() -> String {
    "cmake_minimum_required(VERSION 3.10)\nproject(jointproof C)\nfile(GLOB SOURCES jp_*.c)\n\
     add_library(jointproof ${SOURCES})\nset_property(TARGET jointproof PROPERTY C_STANDARD 99)\n\
     target_compile_options(jointproof PRIVATE -ffp-contract=off)\n\
     target_include_directories(jointproof PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})\n\
     target_link_libraries(jointproof m)\n"
        .into()
}

/// Reads points.bin, writes found.bin.
fn driver(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "/* Evaluates every formula at the points of points.bin, and writes found.bin. */\n\
         #include \"jointproof.h\"\n#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n\n\
         static FILE *points, *found;\n\n\
         static void take(double *x, size_t n)\n{\n    if (fread(x, sizeof *x, n, points) != n) exit(2);\n}\n\n\
         static void give(const double *x, size_t n)\n{\n    if (fwrite(x, sizeof *x, n, found) != n) exit(2);\n}\n\n\
         static uint64_t number_of_points(void)\n{\n    uint64_t n;\n    if (fread(&n, sizeof n, 1, points) != 1) exit(2);\n    return n;\n}\n",
    );
    for one in recorded {
        let (inputs, outputs) = (one.formula.inputs(), one.formula.outputs());
        let passed = |fields: &[Field], array: &str, by_address: &str| {
            let mut from = 0;
            let arguments = fields.iter().map(|field| {
                let start = from;
                from += field.len();
                if field.len() == 1 { format!("{by_address}{array}[{start}]") } else { format!("{array} + {start}") }
            });
            arguments.collect::<Vec<_>>()
        };
        let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
        let values = [passed(inputs, "x", ""), passed(outputs, "y", "&")].concat();
        let both = [passed(inputs, "x", ""), passed(outputs, "both", "&")].concat();
        let [n, m, entries] = [count(inputs), count(outputs), one.graph.jacobian.len()];
        let name = stem(one);
        text.push(format!(
            "\nstatic void {name}(void)\n{{\n    double x[{n}], y[{m}], both[{m} + {entries}];\n\
             \x20   for (uint64_t left = number_of_points(); left > 0; --left) {{\n        take(x, {n});\n\
             \x20       for (int k = 0; k < {m} + {entries}; ++k) both[k] = 0;\n\
             \x20       double code = jp_{name}_jacobian(\n            {},\n            both + {m});\n\
             \x20       const int alone = jp_{name}_value(\n            {});\n\
             \x20       if (alone != (int)code) code = -1;\n\
             \x20       for (int k = 0; k < {m} && alone == 0; ++k)\n            if (y[k] != both[k] && y[k] == y[k]) code = -1;\n\
             \x20       give(&code, 1);\n        give(both, {m} + {entries});\n    }}\n}}\n",
            both.join(",\n            "),
            values.join(",\n            "),
        ));
    }
    text.push(
        "\nint main(void)\n{\n    points = fopen(\"points.bin\", \"rb\");\n    found = fopen(\"found.bin\", \"wb\");\n    if (!points || !found) return 2;\n",
    );
    for one in recorded {
        text.push(format!("    {}();\n", stem(one)));
    }
    text.push("    return fclose(found) != 0;\n}\n");
    text.finished()
}

fn toolchain(name: &'static str) -> Toolchain {
    let all = "set -e; for f in jp_*.c driver.c; do";
    let compile =
        format!("{all} {name} {} -Werror -c $f -o ${{f%.c}}.o; done; {name} -o driver *.o -lm", FLAGS.join(" "));
    Toolchain { name, commands: vec![vec!["sh".into(), "-c".into(), compile], vec!["./driver".into()]], epsilons: 0.0 }
}
