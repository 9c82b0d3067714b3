//! Fortran 2008.

use super::c::{Names, common, exact_sum, signed};
pub(super) mod driver;

use super::language::{File, Language, Operand, Syntax, Toolchain};
use super::program::{Body, Functions, Lines, PartLines, folded, functions_of};
use super::recorded::{Function, Output, Recorded, Shape, Text, description, refusals, stem, unreserved};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Op, Relation, Unary};

pub(super) struct Fortran;

pub(super) const RUNTIME: &str = include_str!("runtime/jp_runtime.f90");
const FLAGS: &str = "-std=f2008 -O2 -ffp-contract=off -Wall -Wextra -pedantic -Werror";
/// Names are case-insensitive, so that a temporary t12 must not clash with an argument T12.
const RESERVED: [&str; 16] = [
    "abs", "anint", "cos", "code", "dp", "exp", "found", "given", "huge", "jacobian", "max", "merge", "real", "result",
    "sin", "sqrt",
];

/// The end of a Boolean that is stored as a number.
const IS_TRUE: &str = " > 0.5_dp)";

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "abs",
        Unary::Root => "sqrt",
        Unary::Sine => "sin",
        Unary::Cosine => "cos",
        Unary::ArcSine => "jp_asin",
        Unary::Exponential => "exp",
        Unary::ExponentialMinusOne => "jp_expm1",
        Unary::PowerOfTwo => "jp_power_of_two",
        Unary::NearestInteger => "anint",
    },
    angle: "jp_angle",
    maximum: "max",
    multiply_add: "jp_fma",
    norm: "jp_norm",
    search: |name| format!("jp_{name}"),
    equal: "==",
};

impl Language for Fortran {
    fn files(&self, recorded: &[Recorded]) -> Vec<File> {
        let modules: Vec<_> = recorded.iter().map(|one| (format!("jp_{}.f90", stem(one)), module_of(one))).collect();
        let drivers = driver::files(recorded);
        let mut files = vec![
            ("jp_runtime.f90".to_owned(), RUNTIME.to_owned()),
            ("jointproof.f90".to_owned(), module(recorded)),
            ("Makefile".to_owned(), makefile(&modules, &drivers)),
        ];
        files.extend(drivers);
        files.extend(modules);
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        let make = ["make", "--quiet", "--always-make", "-j2", "driver"].map(str::to_owned).to_vec();
        vec![Toolchain { name: "gfortran", commands: vec![make, vec!["./driver".into()]], epsilons: 0.0 }]
    }
}

impl Functions for Fortran {
    fn function(&self, one: &Recorded, body: &Body, lines: &Lines, Function { name, outputs }: &Function) -> String {
        let (name, inputs) = (format!("jp_{}_{name}", stem(one)), one.inputs());
        let names: Vec<_> = inputs.iter().map(name_of).chain(outputs.iter().map(output_name)).collect();
        let mut text =
            Text::from(format!("function {name}( &\n        {}) result(code)\n", names.join(", &\n        ")));
        text.push(declared(inputs, 0));
        for output in outputs {
            let shape = match output.shape {
                Shape::Number => String::new(),
                Shape::Vector(len) => format!("({len})"),
                Shape::Matrix(rows, columns) => format!("({rows}, {columns})"),
            };
            text.push(format!("    real(dp), intent(out) :: {}{shape}\n", output_name(output)));
        }
        text.push("    integer :: code\n");
        text.push(temporaries(lines));
        text.push_all(outputs.iter().map(|output| format!("    {} = 0.0_dp\n", output_name(output))));
        text.push_all(inputs.iter().enumerate().map(|(position, field)| refusal(field, position + 1)));
        text.push_all(lines.text.iter().map(|line| format!("{line}\n")));
        if let Some(refusal) = one.graph.refusal {
            let found = body.text(lines, refusal);
            text.push(format!("    code = {} + nint({found})\n    if ({found} > 0.0_dp) return\n", inputs.len()));
        }
        for output in outputs {
            let name = output_name(output);
            for (row, nodes) in one.rows(output) {
                let entries: Vec<_> = nodes.iter().map(|&node| body.text(lines, node)).collect();
                let line = match output.shape {
                    Shape::Number => format!("    {name} = {}", entries[0]),
                    Shape::Vector(_) => format!("    {name} = [{}]", entries.join(", ")),
                    Shape::Matrix(..) => format!("    {name}({}, :) = [{}]", row + 1, entries.join(", ")),
                };
                text.push(folded(&line, " &").join("\n") + "\n");
            }
        }
        text.push(format!("    code = 0\nend function {name}\n"));
        text.finished()
    }

    fn part(&self, stem: &str, part: &PartLines) -> String {
        let name = format!("jp_{stem}_part{}", part.number);
        let given = (part.given > 0).then(|| "given".to_owned());
        let arguments: Vec<_> =
            part.inputs.iter().map(|field| name_of(field)).chain(given).chain(["found".into()]).collect();
        let head = folded(&format!("subroutine {name}({})", arguments.join(", ")), " &").join("\n");
        let mut text = Text::from(format!("\n{head}\n"));
        text.push(declared(part.inputs.iter().copied(), part.given));
        text.push(format!("    real(dp), intent(out) :: found({})\n", part.found));
        text.push(temporaries(&part.lines));
        text.push(part.lines.text.join("\n"));
        text.push(format!("\nend subroutine {name}\n"));
        text.finished()
    }
}

impl Syntax for Fortran {
    /// Results are assigned where they are computed.
    fn lines_of_part(&self) -> usize {
        280
    }

    fn number(&self, x: f64) -> String {
        if x.is_infinite() {
            return if x > 0.0 { "jp_infinity()".into() } else { "(-jp_infinity())".into() };
        }
        let text = format!("{x:?}");
        signed(&format!("{text}_dp"), x)
    }

    fn argument(&self, field: &Field, component: usize) -> String {
        let name = name_of(field);
        if field.len() == 1 { name } else { format!("{name}({})", component + 1) }
    }

    fn operation(&self, op: &Op, operand: Operand) -> String {
        match op {
            op if let Some([x, y]) = op.both_of() => format!("{} .and. {}", operand(x), operand(y)),
            op if let Some([x, y]) = op.either_of() => format!("{} .or. {}", operand(x), operand(y)),
            Op::Select(condition, yes, no) => {
                format!("merge({}, {}, {})", operand(*yes), operand(*no), operand(*condition))
            }
            Op::Compare(Relation::Equal, x, y) => format!("jp_equal({}, {})", operand(*x), operand(*y)),
            Op::ExactSum(products) => {
                let sum = exact_sum(products, operand, ["jp_exact_sum([", "", "", "])"]);
                let lines: Vec<_> = sum.lines().collect();
                lines.join(" &\n")
            }
            op => common(op, operand, &NAMES),
        }
    }

    fn set(&self, name: &str, _: bool, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn announce(&self, _: &str, _: bool) -> Option<String> {
        None
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn element(&self, array: &str, k: usize, is_answer: bool) -> String {
        if is_answer { format!("({array}({}){IS_TRUE}", k + 1) } else { format!("{array}({})", k + 1) }
    }

    fn as_number(&self, text: &str, is_answer: bool) -> String {
        match text.strip_prefix('(').and_then(|text| text.strip_suffix(IS_TRUE)) {
            Some(number) => number.to_owned(),
            None if is_answer => format!("merge(1.0_dp, 0.0_dp, {text})"),
            None => text.to_owned(),
        }
    }

    fn call(&self, stem: &str, part: usize, inputs: &[[&Field; 2]], given: &[String], found: (&str, usize)) -> String {
        let mut arguments: Vec<_> = inputs.iter().map(|[_, passed]| name_of(passed)).collect();
        if !given.is_empty() {
            arguments.push(format!("[{}]", given.join(", ")));
        }
        arguments.push(found.0.to_owned());
        format!("call jp_{stem}_part{part}({})", arguments.join(", "))
    }

    fn goes_on(&self) -> &'static str {
        " &"
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) then"), "else".into(), "end if".into()]
    }
}

fn name_of(field: &Field) -> String {
    unreserved(field.name, &RESERVED)
}

/// The module of a formula or an element.
pub(super) fn module_of(one: &Recorded) -> String {
    let stem = stem(one);
    let head = [description(one), vec!["The functions give 0, or".into()], refusals(one)].concat();
    let public: Vec<_> = one.functions().iter().map(|function| format!("jp_{stem}_{}", function.name)).collect();
    let mut text = Text::from("");
    text.push_all(head.iter().map(|line| format!("! {line}").trim_end().to_owned() + "\n"));
    text.push(format!("module jp_{stem}\n    use jp_runtime\n    implicit none\n    private\n"));
    text.push(format!("    public :: {}\ncontains\n", public.join(", ")));
    text.push_all(functions_of(&Fortran, one));
    text.push(format!("end module jp_{stem}\n"));
    text.finished()
}

/// The arguments of a part or a function that it takes.
fn declared<'a>(fields: impl IntoIterator<Item = &'a Field>, given: usize) -> String {
    let shaped = |name: &str, len: usize| if len == 1 { name.to_owned() } else { format!("{name}({len})") };
    let fields = fields.into_iter().map(|field| shaped(&name_of(field), field.len()));
    let all: Vec<_> = fields.chain((given > 0).then(|| format!("given({given})"))).collect();
    let line = format!("    real(dp), intent(in) :: {}", all.join(", "));
    if all.is_empty() { String::new() } else { folded(&line, " &").join("\n") + "\n" }
}

/// The temporaries of a function.
fn temporaries(lines: &Lines) -> String {
    let arrays: Vec<_> = lines.arrays.iter().map(|(name, len)| format!("{name}({len})")).collect();
    let mut text = String::new();
    for (kind, names) in [("real(dp)", &lines.numbers), ("real(dp)", &arrays), ("logical", &lines.answers)] {
        for names in names.chunks(8) {
            text += &(folded(&format!("    {kind} :: {}", names.join(", ")), " &").join("\n") + "\n");
        }
    }
    text + "\n"
}

fn output_name(output: &Output) -> String {
    match output.shape {
        Shape::Matrix(..) => output.name.to_owned(),
        _ => unreserved(output.name, &RESERVED),
    }
}

fn refusal(field: &Field, code: usize) -> String {
    let name = name_of(field);
    let mut conditions = vec![format!("abs({name}) <= huge(0.0_dp)")];
    let bounds = field.quantity.domain.comparisons();
    conditions.extend(bounds.iter().map(|(relation, bound)| format!("{name} {relation} {}", Fortran.number(*bound))));
    let condition = conditions.join(" .and. ");
    let all = if field.len() == 1 { condition } else { format!("all({condition})") };
    format!("    code = {code}\n    if (.not. ({all})) return\n")
}

fn module(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "! Formulas with their Jacobians, and elements, printed by jointproof from the program that it\n\
         ! proves.\n!\n\
         ! ..._value gives the outputs; ..._jacobian, if in closed form, the outputs and every\n\
         ! derivative: jacobian(output, input). ..._step gives all matrices of an element: (row, column).\n\
         ! The result is 0, or says why inputs are refused, as each module tells; the outputs are 0\n\
         ! then. A result that is too large for a double is infinite.\n!\n\
         ! Compile without fused operations and without -ffast-math: -ffp-contract=off.\nmodule jointproof\n",
    );
    for one in recorded {
        text.push(format!("    use jp_{}\n", stem(one)));
    }
    text.push("    implicit none\nend module jointproof\n");
    text.finished()
}

fn makefile(modules: &[File], drivers: &[File]) -> String {
    let object = |(name, _): &File| name.replace(".f90", ".o");
    let objects: Vec<_> = modules.iter().map(object).collect();
    let drivers: Vec<_> = drivers.iter().map(object).collect();
    let mut text = Text::from(format!(
        "FC = gfortran\nFFLAGS = {FLAGS}\nOBJECTS = {}\nDRIVERS = {}\n\n\
         driver: jp_runtime.o $(OBJECTS) jointproof.o $(DRIVERS)\n\t$(FC) -o $@ $^\n\n\
         $(OBJECTS): jp_runtime.o\njointproof.o: $(OBJECTS)\n$(DRIVERS): jointproof.o\n\n",
        objects.join(" \\\n    "),
        drivers.join(" ")
    ));
    for pair in drivers.windows(2) {
        text.push(format!("{}: {}\n", pair[1], pair[0]));
    }
    text.push("\n%.o: %.f90\n\t$(FC) $(FFLAGS) -c $<\n\nclean:\n\trm -f *.o *.mod driver\n");
    text.finished()
}

#[cfg(test)]
mod tests {
    use super::Fortran;
    use crate::export::program::{Functions, Lines, PartLines};

    /// Results of earlier parts as arguments, and none if a part needs none.
    #[test]
    fn a_part_takes_what_it_is_given() {
        let source = |given| {
            Fortran.part("t", &PartLines { number: 2, inputs: Vec::new(), given, found: 3, lines: Lines::default() })
        };
        for given in [1, 2] {
            let text = source(given);
            assert!(text.contains("subroutine jp_t_part2(given, found)\n"), "{text}");
            assert!(text.contains(&format!("real(dp), intent(in) :: given({given})\n")), "{text}");
        }
        let text = source(0);
        assert!(text.contains("subroutine jp_t_part2(found)\n") && !text.contains("given"), "{text}");
    }
}
