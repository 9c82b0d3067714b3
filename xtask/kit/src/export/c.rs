//! C99.

mod driver;
pub(super) mod loops;

use super::language::{File, Language, Operand, Syntax, Toolchain};
use super::program::{Body, Functions, Lines, PartLines, WIDTH, folded, functions_of};
use super::recorded::{Function, Output, Recorded, Shape, Text, description, filled, refusals, stem, unreserved};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Node, Op, Relation, Unary};
use std::path::Path;

pub(super) struct C;

pub(super) const RUNTIME: &str = include_str!("runtime/jp_runtime.h");
/// What marks arrays that results are written to, in C and in C++.
pub(super) const ARRAYS: &str = include_str!("runtime/jp_arrays.h");
/// Whether the compiler keeps the order of operations.
const SELF_TEST: &str = include_str!("runtime/jp_self_test.c");
/// A program that calls an element.
const EXAMPLE: &str = include_str!("runtime/double_cardan.c");
const EXAMPLE_CALLS: &str = "element_ujoint_smooth";
/// How other projects find the library.
const PKG_CONFIG: &str = include_str!("runtime/jointproof.pc.in");
/// Reserved words of C and C++ that could be the name of a quantity, and names used in the functions themselves.
const RESERVED: [&str; 37] = [
    "auto",
    "bool",
    "break",
    "case",
    "char",
    "class",
    "const",
    "default",
    "delete",
    "do",
    "double",
    "exp",
    "explicit",
    "float",
    "found",
    "given",
    "goto",
    "inline",
    "int",
    "jacobian",
    "k",
    "long",
    "namespace",
    "new",
    "operator",
    "private",
    "public",
    "register",
    "round",
    "short",
    "signed",
    "switch",
    "template",
    "this",
    "union",
    "using",
    "volatile",
];
const FLAGS: [&str; 6] = ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic"];

impl Language for C {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        let mut sources = vec![("jp_self_test.c".to_owned(), SELF_TEST.to_owned())];
        sources.extend(recorded.iter().flat_map(files_of));
        let drivers = driver::files(recorded);
        let mut files = vec![
            ("jp_runtime.h".to_owned(), RUNTIME.to_owned()),
            ("jp_arrays.h".to_owned(), ARRAYS.to_owned()),
            ("jointproof.h".to_owned(), umbrella(recorded)),
            ("Makefile".to_owned(), makefile(recorded, &sources, &drivers)),
            ("CMakeLists.txt".to_owned(), cmake(recorded, &sources)),
            ("jointproof.pc.in".to_owned(), PKG_CONFIG.replace("{version}", env!("CARGO_PKG_VERSION"))),
        ];
        files.extend(drivers);
        files.extend(sources);
        if recorded.iter().any(|one| stem(one) == EXAMPLE_CALLS) {
            files.push(("double_cardan.c".to_owned(), EXAMPLE.to_owned()));
        }
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        ["gcc", "clang"].map(toolchain).into()
    }
}

impl Functions for C {
    fn function(&self, one: &Recorded, body: &Body, lines: &Lines, function: &Function) -> String {
        let mut text = Text::from(format!("\n{}\n{{\n", prototype(one, function)));
        let inputs = one.inputs();
        for (position, field) in inputs.iter().enumerate() {
            text.push(refusal(field, position + 1));
        }
        for line in &lines.text {
            text.push(format!("{line}\n"));
        }
        if let Some(refusal) = one.graph.refusal {
            let code = body.text(lines, refusal);
            text.push(format!("    if ({code} > 0.0) return {} + (int)({code});\n", inputs.len()));
        }
        for output in &function.outputs {
            let name = output_name(output);
            if output.shape == Shape::Number {
                text.push(format!("    *{name} = {};\n", body.text(lines, one.nodes(output)[0])));
                continue;
            }
            let (zeros, entries) = one.entries(output);
            text.push(zeroed(&name, &zeros, output.len()));
            let entries = entries.iter().map(|(k, node)| format!("{name}[{k}] = {};", body.text(lines, *node)));
            text.push(statements(entries));
        }
        text.push("    return 0;\n}\n");
        text.finished()
    }

    fn part(&self, stem: &str, part: &PartLines) -> String {
        let inputs = part.inputs.iter().map(|field| taken(field));
        let given = (part.given > 0).then(|| format!("const double given[{}]", part.given));
        let arguments: Vec<_> = inputs.chain(given).chain([format!("double found[{}]", part.found)]).collect();
        let head = format!("static void jp_{stem}_part{}({})", part.number, arguments.join(", "));
        format!("\n{}\n{{\n{}\n}}\n", folded(&head, "").join("\n"), part.lines.text.join("\n"))
    }
}

impl Syntax for C {
    fn number(&self, x: f64) -> String {
        if x.is_infinite() {
            return if x > 0.0 { "HUGE_VAL".into() } else { "(-HUGE_VAL)".into() };
        }
        signed(&format!("{x:?}"), x)
    }

    fn argument(&self, field: &Field, component: usize) -> String {
        let name = name_of(field);
        if field.len() == 1 { name } else { format!("{name}[{component}]") }
    }

    fn operation(&self, op: &Op, operand: Operand) -> String {
        common(op, operand, &NAMES)
    }

    /// C++ has no arrays without a name.
    fn statement(&self, name: &str, is_answer: bool, op: &Op, operand: Operand) -> String {
        let Op::ExactSum(products) = op else { return self.set(name, is_answer, &self.operation(op, operand)) };
        let head = format!("const double {name}_terms[{}][4] = {{", products.len());
        let terms = exact_sum(products, operand, [&head, "{", "}", "};"]);
        format!("{terms}\nconst double {name} = jp_exact_sum({}, {name}_terms);", products.len())
    }

    fn set(&self, name: &str, is_answer: bool, value: &str) -> String {
        let kind = kind(is_answer);
        format!("const {kind} {name} = {value};")
    }

    fn announce(&self, name: &str, is_answer: bool) -> Option<String> {
        let kind = kind(is_answer);
        Some(format!("{kind} {name};"))
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn element(&self, array: &str, k: usize, is_answer: bool) -> String {
        if is_answer { format!("({array}[{k}] != 0.0)") } else { format!("{array}[{k}]") }
    }

    fn as_number(&self, text: &str, is_answer: bool) -> String {
        if is_answer { format!("(double){text}") } else { text.to_owned() }
    }

    fn call(&self, stem: &str, part: usize, inputs: &[[&Field; 2]], given: &[String], found: (&str, usize)) -> String {
        let mut arguments: Vec<_> = inputs.iter().map(|[_, passed]| name_of(passed)).collect();
        let mut text = String::new();
        let (array, len) = found;
        if !given.is_empty() {
            let name = array.replace("part", "given");
            text = format!("const double {name}[{}] = {{{}}};\n", given.len(), given.join(", "));
            arguments.push(name);
        }
        arguments.push(array.to_owned());
        format!("{text}double {array}[{len}];\njp_{stem}_part{part}({});", arguments.join(", "))
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) {{"), "} else {".into(), "}".into()]
    }
}

/// The type of a result.
fn kind(is_answer: bool) -> &'static str {
    if is_answer { "int" } else { "double" }
}

/// The names of functions.
pub(super) struct Names {
    pub(super) unary: fn(Unary) -> &'static str,
    pub(super) angle: &'static str,
    pub(super) maximum: &'static str,
    pub(super) multiply_add: &'static str,
    pub(super) norm: &'static str,
    pub(super) search: fn(&str) -> String,
    pub(super) equal: &'static str,
}

/// The names of C, which other languages share.
pub(super) const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "fabs",
        Unary::Root => "sqrt",
        Unary::Sine => "sin",
        Unary::Cosine => "cos",
        Unary::ArcSine => "jp_asin",
        Unary::Exponential => "exp",
        Unary::ExponentialMinusOne => "jp_expm1",
        Unary::PowerOfTwo => "jp_power_of_two",
        Unary::NearestInteger => "round",
    },
    angle: "jp_angle",
    maximum: "fmax",
    multiply_add: "fma",
    norm: "jp_norm",
    search: |name| format!("jp_{name}"),
    equal: "==",
};

/// Operations that languages write alike, apart from names.
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
        op if let Some([x, y]) = op.both_of() => infix("&&", x, y),
        op if let Some([x, y]) = op.either_of() => infix("||", x, y),
        Op::Select(condition, yes, no) => {
            format!("{} ? {} : {}", operand(*condition), operand(*yes), operand(*no))
        }
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

/// A negative number in parentheses, so that two signs do not meet.
pub(super) fn signed(text: &str, x: f64) -> String {
    if x.is_sign_negative() { format!("({text})") } else { text.to_owned() }
}

fn name_of(field: &Field) -> String {
    unreserved(field.name, &RESERVED)
}

/// The source of a formula or an element, and its header.
pub(super) fn files_of(one: &Recorded) -> [File; 2] {
    let stem = stem(one);
    let mut text = Text::from(comment(&description(one)));
    text.push(format!("#include \"jp_{stem}.h\"\n#include \"jp_runtime.h\"\n"));
    text.push_all(functions_of(&C, one));
    [(format!("jp_{stem}.c"), text.finished()), (format!("jp_{stem}.h"), header(one))]
}

/// Up to this many zeros are written one by one: compilers turn longer loops into memset, which takes longer than
/// small formulas do.
const FEW_ZEROS: usize = 64;

/// The entries that are always 0, or all entries if there are many.
fn zeroed(name: &str, zeros: &[usize], entries: usize) -> String {
    if zeros.len() > FEW_ZEROS {
        return format!("    memset({name}, 0, {entries} * sizeof *{name});\n");
    }
    let last = zeros.len().saturating_sub(1);
    let end = |n: usize| if n < last { "" } else { " 0.0;" };
    statements(zeros.iter().enumerate().map(|(n, k)| format!("{name}[{k}] ={}", end(n))))
}

/// Short statements, several per line.
fn statements(texts: impl Iterator<Item = String>) -> String {
    filled(texts, WIDTH - 4).iter().map(|line| ["    ", line, "\n"].concat()).collect()
}

fn comment(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| format!(" * {line}").trim_end().to_owned()).collect();
    format!("/*\n{}\n */\n", lines.join("\n"))
}

/// Return codes: 0, or the position of the input, from 1, that is not finite or not in its domain.
fn refusal(field: &Field, code: usize) -> String {
    let name = name_of(field);
    let allowed = |x: &str| {
        let bounds = field.quantity.domain.comparisons();
        let bounds = bounds.iter().map(|(relation, bound)| format!(" && {x} {relation} {}", C.number(*bound)));
        format!("if (!(fabs({x}) <= DBL_MAX{})) return {code};", bounds.collect::<String>())
    };
    match field.len() {
        1 => format!("    {}\n", allowed(&name)),
        len => format!("    for (int k = 0; k < {len}; ++k)\n        {}\n", allowed(&format!("{name}[k]"))),
    }
}

fn taken(field: &Field) -> String {
    let name = name_of(field);
    match field.len() {
        1 => format!("double {name}"),
        len => format!("const double {name}[{len}]"),
    }
}

fn output_name(output: &Output) -> String {
    match output.shape {
        Shape::Matrix(..) => output.name.to_owned(),
        _ => unreserved(output.name, &RESERVED),
    }
}

fn given(output: &Output) -> String {
    let name = output_name(output);
    match output.shape {
        Shape::Number => format!("double *JP_RESTRICT {name}"),
        _ => format!("double JP_ARRAY({name}, {})", output.len()),
    }
}

fn prototype(one: &Recorded, function: &Function) -> String {
    let arguments: Vec<_> = one.inputs().iter().map(taken).chain(function.outputs.iter().map(given)).collect();
    format!("int jp_{}_{}(\n    {})", stem(one), function.name, arguments.join(",\n    "))
}

/// A header with its guard.
fn guarded(name: &str, includes: &str, text: &str) -> String {
    let guard = name.to_uppercase();
    format!(
        "#ifndef {guard}_H\n#define {guard}_H\n\n{includes}#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{text}\n\
         #ifdef __cplusplus\n}}\n#endif\n\n#endif\n"
    )
}

fn header(one: &Recorded) -> String {
    let mut lines = vec![format!("{}: {}", one.subject, one.subject.spec().title), String::new()];
    lines.push("Return code 0: done.".into());
    lines.extend(refusals(one));
    let prototypes: Vec<_> = one.functions().iter().map(|function| prototype(one, function) + ";\n").collect();
    let text = prototypes.join("\n");
    comment(&lines) + &guarded(&format!("jp_{}", stem(one)), "#include \"jp_arrays.h\"\n\n", &text)
}

/// The header that includes all others.
fn umbrella(recorded: &[Recorded]) -> String {
    let includes: Vec<_> = recorded.iter().map(|one| format!("#include \"jp_{}.h\"\n", stem(one))).collect();
    include_str!("runtime/jointproof.h").replace("{includes}", &includes.concat())
}

/// The sources among files.
fn sources(files: &[File]) -> impl Iterator<Item = &str> {
    files
        .iter()
        .map(|(name, _)| name.as_str())
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "c"))
}

/// The headers that callers include.
fn headers(recorded: &[Recorded]) -> Vec<String> {
    let own = ["jointproof.h", "jp_arrays.h"].map(str::to_owned);
    own.into_iter().chain(recorded.iter().map(|one| format!("jp_{}.h", stem(one)))).collect()
}

fn makefile(recorded: &[Recorded], library: &[File], drivers: &[File]) -> String {
    let objects = |files| sources(files).map(|name| name.replace(".c", ".o")).collect::<Vec<_>>().join(" \\\n    ");
    include_str!("runtime/Makefile")
        .replace("{flags}", &FLAGS.join(" "))
        .replace("{objects}", &objects(library))
        .replace("{driver}", &objects(drivers))
        .replace("{headers}", &headers(recorded).join(" \\\n    "))
}

fn cmake(recorded: &[Recorded], library: &[File]) -> String {
    let sources: Vec<_> = sources(library).collect();
    include_str!("runtime/CMakeLists.txt")
        .replace("{version}", env!("CARGO_PKG_VERSION"))
        .replace("{sources}", &sources.join("\n    "))
        .replace("{headers}", &headers(recorded).join("\n    "))
}

fn toolchain(name: &'static str) -> Toolchain {
    let flags = format!("CFLAGS={} -Werror", FLAGS.join(" "));
    let make = ["make", "--quiet", "--always-make", "-j2", "driver", &format!("CC={name}"), &flags];
    let commands = vec![make.map(str::to_owned).into(), vec!["./driver".into()]];
    Toolchain { name, commands, epsilons: 0.0 }
}
