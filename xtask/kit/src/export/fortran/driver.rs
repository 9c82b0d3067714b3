//! The program that evaluates formulas at given points, for the comparison with Rust.

use super::super::language::File;
use super::super::recorded::{Recorded, Text, stem};
use jointproof::formula::Field;

/// The number of formulas in one file.
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
    let (inputs, outputs) = (one.formula.inputs(), one.formula.outputs());
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let [n, m, entries] = [count(inputs), count(outputs), one.graph.jacobian.len()];
    let jacobian = if entries > 0 { vec!["jacobian".to_owned()] } else { Vec::new() };
    let arguments = [passed(inputs, "x", 1), passed(outputs, "y", 1), jacobian].concat();
    let what = one.largest_function();
    let name = stem(one);
    format!(
        "    subroutine run_{name}()\n        real(dp) :: x({n}), y({m}), jacobian({entries})\n\
         \x20       integer(int64) :: left\n        integer :: code\n\
         \x20       read (10) left\n        do while (left > 0)\n            read (10) x\n\
         \x20           code = jp_{name}_{what}( &\n                {})\n\
         \x20           write (11) real(code, dp), y, jacobian\n            left = left - 1\n        end do\n\
         \x20   end subroutine run_{name}\n",
        arguments.join(", &\n                ")
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
