//! The program that evaluates formulas at given points, for the comparison with Rust.

use super::super::language::File;
use super::super::program::folded;
use super::super::recorded::{Recorded, Shape, Text, stem};
use jointproof::formula::Field;

/// The number of formulas and elements in one file.
const FORMULAS: usize = 12;

/// Reads points.bin, writes found.bin. The program is the last file.
pub(super) fn files(recorded: &[Recorded]) -> Vec<File> {
    let groups = recorded.chunks(FORMULAS).enumerate();
    let mut files: Vec<_> = groups.map(|(k, group)| (format!("driver_{}.f90", k + 1), module(k + 1, group))).collect();
    files.push(("driver.f90".into(), program(recorded, files.len())));
    files
}

fn program(recorded: &[Recorded], modules: usize) -> String {
    let mut text =
        Text::from("! Evaluates every formula at the points of points.bin, and writes found.bin.\nprogram driver\n");
    for k in 1..=modules {
        text.push(format!("    use driver_{k}\n"));
    }
    text.push(
        "    implicit none\n\
         \x20   open (10, file='points.bin', access='stream', form='unformatted', status='old')\n\
         \x20   open (11, file='found.bin', access='stream', form='unformatted', status='replace')\n",
    );
    for one in recorded {
        text.push(format!("    call run_{}()\n", stem(one)));
    }
    text.push("    close (11)\nend program driver\n");
    text.finished()
}

fn module(number: usize, group: &[Recorded]) -> String {
    let mut text = Text::from(format!(
        "module driver_{number}\n    use jointproof\n    use jp_runtime, only: dp\n\
         \x20   use, intrinsic :: iso_fortran_env, only: int64\n    implicit none\n    private :: dp, int64\ncontains\n"
    ));
    for one in group {
        text.push(subroutine(one));
    }
    text.push(format!("end module driver_{number}\n"));
    text.finished()
}

fn subroutine(one: &Recorded) -> String {
    let (n, name, function) = (one.row(), stem(one), one.largest_function());
    let mut declared = vec![format!("x({n})")];
    let mut written = vec!["real(code, dp)".to_owned()];
    for output in &function.outputs {
        let name = format!("out_{}", output.name);
        match output.shape {
            Shape::Number => declared.push(name.clone()),
            Shape::Vector(len) => declared.push(format!("{name}({len})")),
            Shape::Matrix(rows, columns) => declared.push(format!("{name}({rows}, {columns})")),
        }
        written.push(if matches!(output.shape, Shape::Matrix(..)) { format!("transpose({name})") } else { name });
    }
    let outputs = function.outputs.iter().map(|output| format!("out_{}", output.name));
    let arguments: Vec<_> = passed(one.inputs(), "x", 1).into_iter().chain(outputs).collect();
    let line = |line: String| folded(&line, " &").join("\n");
    format!(
        "    subroutine run_{name}()\n{}\n\
         \x20       integer(int64) :: left\n        integer :: code\n\
         \x20       read (10) left\n        do while (left > 0)\n            read (10) x\n\
         \x20           code = jp_{name}_{}( &\n                {})\n{}\n\
         \x20           left = left - 1\n        end do\n\
         \x20   end subroutine run_{name}\n",
        line(format!("        real(dp) :: {}", declared.join(", "))),
        function.name,
        arguments.join(", &\n                "),
        line(format!("            write (11) {}", written.join(", "))),
    )
}

/// Elements of an array for these fields, from this place on.
pub(in crate::export) fn passed(fields: &[Field], array: &str, mut from: usize) -> Vec<String> {
    let mut next = |field: &Field| {
        let start = from;
        from += field.len();
        if field.len() == 1 { format!("{array}({start})") } else { format!("{array}({start}:{})", from - 1) }
    };
    fields.iter().map(&mut next).collect()
}
