//! Fortran 2008.

use super::c::{Names, common, exact_sum, signed};
use super::language::{Language, Operand, Toolchain};
use super::program::Body;
use super::recorded::{Recorded, Text, bounds, description, stem, unreserved};
use jointproof::formula::Field;
use jointproof::graph::{Op, Relation, Unary};

pub(super) struct Fortran;

const RUNTIME: &str = include_str!("runtime/jp_runtime.f90");
const FLAGS: &str = "-std=f2008 -O2 -ffp-contract=off -Wall -Wextra -pedantic -Werror";
/// Names are one whether written large or small, so that a temporary t12 may not meet an argument T12.
const RESERVED: [&str; 7] = ["code", "dp", "jacobian", "real", "result", "huge", "abs"];

const NAMES: Names = Names {
    unary: |function| match function {
        Unary::Negative => "-",
        Unary::Absolute => "abs",
        Unary::Root => "sqrt",
        Unary::Sine => "sin",
        Unary::Cosine => "cos",
        Unary::ArcSine => "asin",
        Unary::Exponential => "exp",
        Unary::ExponentialMinusOne => "jp_expm1",
        Unary::PowerOfTwo => "jp_power_of_two",
    },
    angle: "atan2",
    maximum: "max",
    multiply_add: "jp_fma",
    norm: "jp_norm",
    search: |name| format!("jp_{name}"),
    equal: "==",
};

impl Language for Fortran {
    fn files(&self, recorded: &[Recorded]) -> Vec<(String, String)> {
        let sources: Vec<_> = recorded.iter().map(|one| format!("jp_{}.f90", stem(one))).collect();
        let mut files = vec![
            ("jp_runtime.f90".to_owned(), RUNTIME.to_owned()),
            ("jointproof.f90".to_owned(), module(recorded)),
            ("driver.f90".to_owned(), driver(recorded)),
            ("Makefile".to_owned(), makefile(&sources)),
        ];
        files.extend(recorded.iter().zip(sources).map(|(one, name)| (name, self.source(one))));
        files
    }

    fn toolchains(&self) -> Vec<Toolchain> {
        let make = ["make", "--quiet", "driver"].map(str::to_owned).to_vec();
        vec![Toolchain { name: "gfortran", commands: vec![make, vec!["./driver".into()]], epsilons: 0.0 }]
    }

    fn number(&self, x: f64) -> String {
        if x.is_infinite() {
            return if x > 0.0 { "jp_infinity()".into() } else { "(-jp_infinity())".into() };
        }
        let text = format!("{x:?}");
        signed(&format!("{text}_dp"), x)
    }

    fn argument(&self, field: &Field, component: usize) -> String {
        let name = unreserved(field.name, &RESERVED);
        if field.len() == 1 { name } else { format!("{name}({})", component + 1) }
    }

    fn operation(&self, op: &Op, operand: Operand) -> String {
        match op {
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

    fn announce(&self, _: &str) -> Option<String> {
        None
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn goes_on(&self) -> &'static str {
        " &"
    }

    fn choose(&self, condition: &str) -> [String; 3] {
        [format!("if ({condition}) then"), "else".into(), "end if".into()]
    }
}

impl Fortran {
    fn source(&self, one: &Recorded) -> String {
        let lines: Vec<_> = description(one).iter().map(|line| format!("! {line}").trim_end().to_owned()).collect();
        let name = stem(one);
        let mut text = Text::from(lines.join("\n"));
        text.push(format!(
            "\nmodule jp_{name}\n    use jp_runtime\n    implicit none\n    private\n    public :: jp_{name}_value, jp_{name}_jacobian\ncontains\n"
        ));
        for with_jacobian in [false, true] {
            text.push(self.function(one, with_jacobian));
        }
        text.push(format!("end module jp_{name}\n"));
        text.finished()
    }

    fn function(&self, one: &Recorded, with_jacobian: bool) -> String {
        let what = if with_jacobian { "jacobian" } else { "value" };
        let name = format!("jp_{}_{what}", stem(one));
        let (inputs, outputs) = (one.formula.inputs(), one.formula.outputs());
        let called = |field: &Field| unreserved(field.name, &RESERVED);
        let names = inputs.iter().chain(outputs).map(called);
        let names: Vec<_> = names.chain(with_jacobian.then(|| "jacobian".to_owned())).collect();
        let mut text = Text::from(format!(
            "    function {name}( &\n            {}) result(code)\n",
            names.join(", &\n            ")
        ));
        let declare = |field: &Field, intent: &str| {
            let shape = if field.len() == 1 { String::new() } else { format!("({})", field.len()) };
            format!("        real(dp), intent({intent}) :: {}{shape}\n", called(field))
        };
        for field in inputs {
            text.push(declare(field, "in"));
        }
        for field in outputs {
            text.push(declare(field, "out"));
        }
        if with_jacobian {
            text.push(format!("        real(dp), intent(out) :: jacobian({})\n", one.graph.jacobian.len()));
        }
        text.push("        integer :: code\n");
        let body = Body { language: self, graph: &one.graph, inputs };
        let results = [one.graph.value.as_slice(), if with_jacobian { &one.graph.jacobian } else { &[] }].concat();
        let lines = body.lines(&results, 2);
        for (kind, names) in [("real(dp)", &lines.numbers), ("logical", &lines.answers)] {
            for names in names.chunks(8) {
                text.push(format!("        {kind} :: {}\n", names.join(", ")));
            }
        }
        text.push("\n");
        for field in outputs {
            text.push(format!("        {} = 0.0_dp\n", called(field)));
        }
        if with_jacobian {
            text.push("        jacobian = 0.0_dp\n");
        }
        for (position, field) in inputs.iter().enumerate() {
            text.push(self.refusal(field, position + 1));
        }
        for line in &lines.text {
            text.push(format!("{line}\n"));
        }
        let mut value = one.graph.value.iter();
        for field in outputs {
            for (k, &node) in value.by_ref().take(field.len()).enumerate() {
                let place = if field.len() == 1 { called(field) } else { format!("{}({})", called(field), k + 1) };
                text.push(format!("        {place} = {}\n", body.text(node)));
            }
        }
        if with_jacobian {
            for (k, &node) in one.graph.jacobian.iter().enumerate() {
                text.push(format!("        jacobian({}) = {}\n", k + 1, body.text(node)));
            }
        }
        text.push(format!("        code = 0\n    end function {name}\n"));
        text.finished()
    }

    fn refusal(&self, field: &Field, code: usize) -> String {
        let name = unreserved(field.name, &RESERVED);
        let mut conditions = vec![format!("abs({name}) <= huge(0.0_dp)")];
        let bounds = bounds(field.quantity.domain);
        conditions.extend(bounds.iter().map(|(relation, bound)| format!("{name} {relation} {}", self.number(*bound))));
        let condition = conditions.join(" .and. ");
        let all = if field.len() == 1 { condition } else { format!("all({condition})") };
        format!("        code = {code}\n        if (.not. ({all})) return\n")
    }
}

fn module(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "! Formulas with their Jacobians, printed by jointproof from the program that it proves.\n!\n\
         ! ..._value gives the outputs; ..._jacobian the outputs and every derivative, output by output, each\n\
         ! over all inputs in order. The result is 0, or the position of the first input that is not finite or\n\
         ! not in its domain; the outputs are 0 then.\n!\n\
         ! Compile without fused operations and without -ffast-math: -ffp-contract=off.\nmodule jointproof\n",
    );
    for one in recorded {
        text.push(format!("    use jp_{}\n", stem(one)));
    }
    text.push("    implicit none\nend module jointproof\n");
    text.finished()
}

fn makefile(sources: &[String]) -> String {
    let objects: Vec<_> = sources.iter().map(|source| source.replace(".f90", ".o")).collect();
    format!(
        "FC = gfortran\nFFLAGS = {FLAGS}\nOBJECTS = {}\n\n\
         driver: jp_runtime.o $(OBJECTS) jointproof.o driver.o\n\t$(FC) -o $@ $^\n\n\
         $(OBJECTS): jp_runtime.o\njointproof.o: $(OBJECTS)\ndriver.o: jointproof.o\n\n\
         %.o: %.f90\n\t$(FC) $(FFLAGS) -c $<\n\nclean:\n\trm -f *.o *.mod driver\n",
        objects.join(" \\\n    ")
    )
}

fn driver(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "! Evaluates every formula at the points of points.bin, and writes found.bin.\nprogram driver\n\
         \x20   use jointproof\n    use jp_runtime, only: dp\n    use iso_fortran_env, only: int64\n    implicit none\n\
         \x20   integer(int64) :: left\n    integer :: code\n\
         \x20   open (10, file='points.bin', access='stream', form='unformatted', status='old')\n\
         \x20   open (11, file='found.bin', access='stream', form='unformatted', status='replace')\n",
    );
    for one in recorded {
        text.push(format!("    call run_{}()\n", stem(one)));
    }
    text.push("    close (11)\ncontains\n");
    for one in recorded {
        let (inputs, outputs) = (one.formula.inputs(), one.formula.outputs());
        let passed = |fields: &[Field], array: &str| {
            let mut from = 0;
            let arguments = fields.iter().map(|field| {
                let start = from + 1;
                from += field.len();
                if field.len() == 1 { format!("{array}({start})") } else { format!("{array}({start}:{from})") }
            });
            arguments.collect::<Vec<_>>()
        };
        let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
        let arguments = [passed(inputs, "x"), passed(outputs, "y"), vec!["jacobian".into()]].concat();
        let [n, m, entries] = [count(inputs), count(outputs), one.graph.jacobian.len()];
        let name = stem(one);
        text.push(format!(
            "    subroutine run_{name}()\n        real(dp) :: x({n}), y({m}), jacobian({entries})\n\
             \x20       read (10) left\n        do while (left > 0)\n            read (10) x\n\
             \x20           code = jp_{name}_jacobian( &\n                {})\n\
             \x20           write (11) real(code, dp), y, jacobian\n            left = left - 1\n        end do\n\
             \x20   end subroutine run_{name}\n",
            arguments.join(", &\n                ")
        ));
    }
    text.push("end program driver\n");
    text.finished()
}
