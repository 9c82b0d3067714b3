//! C99.

mod driver;
pub(super) mod loops;

use super::language::{File, Language, Operand, Syntax, Toolchain, files_of};
use super::program::{Body, Lines, PartLines, WIDTH, folded};
use super::recorded::{Recorded, Text, bounds, description, filled, function_name, refusals, stem, unreserved};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Node, Op, Relation, Unary};
use std::path::Path;

pub(super) struct C;

const RUNTIME: &str = include_str!("runtime/jp_runtime.h");
/// Reserved words of C, and names used in the functions themselves.
const RESERVED: [&str; 7] = ["double", "int", "k", "jacobian", "const", "given", "found"];
const FLAGS: [&str; 6] = ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic"];

impl Language for C {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        let formulas: Vec<_> = recorded.iter().flat_map(|one| files_of(self, one)).collect();
        let drivers = driver::files(recorded);
        let mut files = vec![
            ("jp_runtime.h".to_owned(), RUNTIME.to_owned()),
            ("jointproof.h".to_owned(), umbrella(recorded)),
            ("Makefile".to_owned(), makefile(&formulas, &drivers)),
            ("CMakeLists.txt".to_owned(), cmake(&formulas)),
        ];
        files.extend(drivers);
        files.extend(formulas);
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        ["gcc", "clang"].map(toolchain).into()
    }
}

impl Syntax for C {
    fn formula(&self, one: &Recorded, limit: usize) -> Vec<File> {
        let stem = stem(one);
        let (source, parts) = source(one, limit);
        let mut files = vec![(format!("jp_{stem}.c"), source), (format!("jp_{stem}.h"), header(one))];
        if !parts.is_empty() {
            files.push((format!("jp_{stem}_parts.h"), parts_header(&stem, &parts)));
        }
        files.extend(parts.iter().map(|part| (format!("jp_{stem}_part{}.c", part.number), part_source(&stem, part))));
        files
    }

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
        match op {
            Op::ExactSum(products) => {
                let head = format!("jp_exact_sum({}, (const double[][4]){{", products.len());
                exact_sum(products, operand, [&head, "{", "}", "})"])
            }
            op => common(op, operand, &NAMES),
        }
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

    fn call(&self, stem: &str, part: usize, inputs: &[&Field], given: &[String], found: (&str, usize)) -> String {
        let mut arguments: Vec<_> = inputs.iter().map(|field| name_of(field)).collect();
        if !given.is_empty() {
            arguments.push(format!("(const double[]){{{}}}", given.join(", ")));
        }
        let (array, len) = found;
        format!("double {array}[{len}];\njp_{stem}_part{part}({}, {array});", arguments.join(", "))
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

/// The text of a formula's functions, and the parts that they call.
fn source(one: &Recorded, limit: usize) -> (String, Vec<PartLines>) {
    let stem = stem(one);
    let body = Body { language: &C, graph: &one.graph, inputs: one.formula.inputs(), names: &one.names, stem: &stem };
    let mut parts = Vec::new();
    let mut functions = Vec::new();
    for with_jacobian in one.functions() {
        let (lines, more) = body.program(&one.results(with_jacobian), limit, parts.len() + 1);
        parts.extend(more);
        functions.push(function(one, &body, &lines, with_jacobian));
    }
    let mut text = Text::from(comment(&description(one)));
    let with_parts = if parts.is_empty() { String::new() } else { format!("#include \"jp_{stem}_parts.h\"\n") };
    text.push(format!("#include \"jp_{stem}.h\"\n{with_parts}#include \"jp_runtime.h\"\n"));
    text.push_all(functions);
    (text.finished(), parts)
}

fn function(one: &Recorded, body: &Body, lines: &Lines, with_jacobian: bool) -> String {
    let mut text = Text::from(format!("\n{}\n{{\n", prototype(one, with_jacobian)));
    let inputs = one.formula.inputs();
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
    let mut value = one.graph.value.iter();
    for field in one.formula.outputs() {
        for (k, &node) in value.by_ref().take(field.len()).enumerate() {
            let name = name_of(field);
            let place = if field.len() == 1 { format!("*{name}") } else { format!("{name}[{k}]") };
            text.push(format!("    {place} = {};\n", body.text(lines, node)));
        }
    }
    if with_jacobian {
        let (zeros, entries) = one.entries();
        text.push(zeroed(&zeros, one.graph.jacobian.len()));
        let entries = entries.iter().map(|(k, node)| format!("jacobian[{k}] = {};", body.text(lines, *node)));
        text.push(statements(entries));
    }
    text.push("    return 0;\n}\n");
    text.finished()
}

/// Up to this many zeros are written one by one: compilers turn longer loops into memset, which takes longer than
/// small formulas do.
const FEW_ZEROS: usize = 64;

/// The entries that are always 0, or all entries if there are many.
fn zeroed(zeros: &[usize], entries: usize) -> String {
    if zeros.len() > FEW_ZEROS {
        return format!("    memset(jacobian, 0, {entries} * sizeof *jacobian);\n");
    }
    let last = zeros.len().saturating_sub(1);
    let end = |n: usize| if n < last { "" } else { " 0.0;" };
    statements(zeros.iter().enumerate().map(|(n, k)| format!("jacobian[{k}] ={}", end(n))))
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
        let bounds = bounds(field.quantity.domain);
        let bounds = bounds.iter().map(|(relation, bound)| format!(" && {x} {relation} {}", C.number(*bound)));
        format!("if (!(fabs({x}) <= DBL_MAX{})) return {code};", bounds.collect::<String>())
    };
    match field.len() {
        1 => format!("    {}\n", allowed(&name)),
        len => format!("    for (int k = 0; k < {len}; ++k)\n        {}\n", allowed(&format!("{name}[k]"))),
    }
}

fn argument(field: &Field, kind: [&str; 2]) -> String {
    let name = name_of(field);
    match field.len() {
        1 => format!("{}{name}", kind[0]),
        len => format!("{}{name}[{len}]", kind[1]),
    }
}

fn taken(field: &Field) -> String {
    argument(field, ["double ", "const double "])
}

fn prototype(one: &Recorded, with_jacobian: bool) -> String {
    let inputs = one.formula.inputs().iter().map(taken);
    let outputs = one.formula.outputs().iter().map(|field| argument(field, ["double *", "double "]));
    let jacobian = with_jacobian.then(|| format!("double jacobian[{}]", one.graph.jacobian.len()));
    let what = function_name(with_jacobian);
    let arguments: Vec<_> = inputs.chain(outputs).chain(jacobian).collect();
    format!("int jp_{}_{what}(\n    {})", stem(one), arguments.join(",\n    "))
}

/// A header with its guard.
fn guarded(name: &str, text: &str) -> String {
    let guard = name.to_uppercase();
    format!(
        "#ifndef {guard}_H\n#define {guard}_H\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{text}\n\
         #ifdef __cplusplus\n}}\n#endif\n\n#endif\n"
    )
}

fn header(one: &Recorded) -> String {
    let spec = one.formula.spec();
    let mut lines = vec![format!("{}: {}", spec.id, spec.title), String::new(), "Return code 0: done.".into()];
    lines.extend(refusals(one.formula.inputs(), &one.graph));
    let prototypes: Vec<_> = one.functions().into_iter().map(|with| format!("{};\n", prototype(one, with))).collect();
    let text = prototypes.join("\n");
    comment(&lines) + &guarded(&format!("jp_{}", stem(one)), &text)
}

/// The header that includes all others.
fn umbrella(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "/*\n * Formulas with their Jacobians, printed by jointproof from the program that it proves.\n *\n\
         \x20* ..._value gives the outputs; ..._jacobian, where it is in closed form, the outputs and\n\
         \x20* every derivative, output by output, each over all inputs in order. A return code is 0, or says\n\
         \x20* why inputs are refused, as each header tells; nothing is written then. A result that is too\n\
         \x20* large for a double is infinite.\n *\n\
         \x20* Compile without fused operations and without -ffast-math: -std=c99 -ffp-contract=off.\n */\n\
         #ifndef JOINTPROOF_H\n#define JOINTPROOF_H\n\n",
    );
    for one in recorded {
        text.push(format!("#include \"jp_{}.h\"\n", stem(one)));
    }
    text.push("\n#endif\n");
    text.finished()
}

fn part_prototype(stem: &str, part: &PartLines) -> String {
    let inputs = part.inputs.iter().map(|field| taken(field));
    let given = (part.given > 0).then(|| format!("const double given[{}]", part.given));
    let arguments: Vec<_> = inputs.chain(given).chain([format!("double found[{}]", part.found)]).collect();
    folded(&format!("void jp_{stem}_part{}({})", part.number, arguments.join(", ")), "").join("\n")
}

fn parts_header(stem: &str, parts: &[PartLines]) -> String {
    let prototypes: Vec<_> = parts.iter().map(|part| part_prototype(stem, part) + ";\n").collect();
    comment(&["What the functions of this formula call; for nobody else.".into()])
        + &guarded(&format!("jp_{stem}_parts"), &prototypes.concat())
}

fn part_source(stem: &str, part: &PartLines) -> String {
    format!(
        "#include \"jp_{stem}_parts.h\"\n#include \"jp_runtime.h\"\n\n{}\n{{\n{}\n}}\n",
        part_prototype(stem, part),
        part.lines.text.join("\n")
    )
}

/// The sources among files.
fn sources(files: &[File]) -> impl Iterator<Item = &str> {
    files
        .iter()
        .map(|(name, _)| name.as_str())
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "c"))
}

fn makefile(formulas: &[File], drivers: &[File]) -> String {
    let objects = |files| sources(files).map(|name| name.replace(".c", ".o")).collect::<Vec<_>>().join(" \\\n    ");
    format!(
        "CC ?= cc\nCFLAGS ?= {}\nOBJECTS = {}\nDRIVER = {}\n\
         SPEED = $(patsubst %.c,%.o,$(wildcard speed*.c))\n\n\
         libjointproof.a: $(OBJECTS)\n\t$(AR) rcs $@ $(OBJECTS)\n\n\
         driver: $(DRIVER) libjointproof.a\n\t$(CC) -o $@ $(DRIVER) libjointproof.a -lm\n\n\
         speed: $(SPEED) $(OBJECTS)\n\t$(CC) $(CFLAGS) -o $@ $(SPEED) $(OBJECTS) -lm\n\n\
         clean:\n\trm -f *.o libjointproof.a driver speed\n",
        FLAGS.join(" "),
        objects(formulas),
        objects(drivers)
    )
}

fn cmake(formulas: &[File]) -> String {
    let sources: Vec<_> = sources(formulas).collect();
    format!(
        "cmake_minimum_required(VERSION 3.10)\nproject(jointproof C)\nadd_library(jointproof\n    {})\n\
         set_property(TARGET jointproof PROPERTY C_STANDARD 99)\n\
         target_compile_options(jointproof PRIVATE -ffp-contract=off)\n\
         target_include_directories(jointproof PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})\n\
         target_link_libraries(jointproof m)\n",
        sources.join("\n    ")
    )
}

fn toolchain(name: &'static str) -> Toolchain {
    let flags = format!("CFLAGS={} -Werror", FLAGS.join(" "));
    let make = ["make", "--quiet", "--always-make", "-j2", "driver", &format!("CC={name}"), &flags];
    let commands = vec![make.map(str::to_owned).into(), vec!["./driver".into()]];
    Toolchain { name, commands, epsilons: 0.0 }
}
