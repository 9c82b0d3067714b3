//! `cargo xtask check --element`: exported elements are right, and mistakes in the routine around them are found.

use crate::common::{Bench, Ran};
use crate::port::Lang;
use std::process::Command;

/// An exported element: its modules, which are compiled once, and the routine around them.
struct Exported {
    bench: Bench,
    element: &'static str,
    routine: String,
}

fn compile(bench: &Bench, arguments: &[&str]) {
    let flags = ["-std=legacy", "-O0", "-ffp-contract=off"];
    let output = Command::new("gfortran").args(flags).args(arguments).current_dir(bench.path("")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

impl Exported {
    fn new(element: &'static str) -> Self {
        let bench = Bench::new();
        let out = bench.path("");
        bench.run(&["export", "--shell", &format!("uel-{element}"), "--out", out.to_str().unwrap()]).exits(0);
        bench.run(&["check", "--element", element, "--abi", "uel", "--out", out.to_str().unwrap()]).exits(0);
        let text = std::fs::read_to_string(bench.path(&format!("uel_{element}.f90"))).unwrap();
        let (modules, routine) = text.split_once("\nsubroutine uel(").unwrap();
        std::fs::write(bench.path("modules.f90"), format!("{modules}\n")).unwrap();
        compile(&bench, &["-c", "modules.f90", "uel_driver.f90"]);
        Self { bench, element, routine: format!("subroutine uel({routine}") }
    }

    /// What is said about the routine with a text replaced.
    fn checked(&self, [from, to]: [&str; 2]) -> Ran {
        assert!(self.routine.contains(from), "{from}");
        std::fs::write(self.bench.path("routine.f90"), self.routine.replacen(from, to, 1)).unwrap();
        compile(&self.bench, &["-o", "port", "routine.f90", "modules.o", "uel_driver.o"]);
        let program = self.bench.path("port");
        self.bench.run(&["check", "--element", self.element, "--", program.to_str().unwrap()])
    }
}

#[test]
fn exported_elements_are_those_of_the_catalog() {
    if !Lang::Fortran.is_here() {
        return;
    }
    for element in ["slot", "translator", "ujoint", "hinge"] {
        Exported::new(element).checked(["", ""]).exits(0).prints("those of the element at");
    }
}

/// Mistakes in the routine around SLOT, with what is said.
const MISTAKES: &[([&str; 2], &str)] = &[
    (["= -transpose(reshape(results(stiffness", "= transpose(reshape(results(stiffness"], "AMATRX(1,1)"),
    (["= -transpose(reshape(results(by_multipliers", "= transpose(reshape(results(by_multipliers"], "AMATRX("),
    (["= -transpose(reshape(results(rows", "= transpose(reshape(results(rows"], "AMATRX(13,"),
    (["= -transpose(reshape(results(stiffness + 1:by_multipliers), [12, 12]))", "= 0"], "AMATRX("),
    (
        [
            "= -transpose(reshape(results(stiffness + 1:by_multipliers), [12, 12]))",
            "= -reshape(results(stiffness + 1:by_multipliers), [12, 12])",
        ],
        "AMATRX(",
    ),
    (["rhs(:12, 1) = results", "rhs(:12, 1) = -results"], "RHS("),
    (["rhs(13:all_motions, 1) = results", "rhs(13:all_motions, 1) = -results"], "RHS(13)"),
    (["if (rubs) svars(:states) = results(after + 1:)", ""], "SVARS("),
    (["svars(:states) = results(after + 1:)", "svars(:states) = -9d9"], "SVARS("),
    (["svars(:states) = results(after + 1:)", "svars(:states + 3) = 1"], "writes behind the array SVARS"),
    (["coords(:3, 1) + u(1:3)", "coords(:3, 1)"], "RHS("),
    (["coords(:3, 2) + u(7:9)", "u(7:9)"], "RHS("),
    (["turned(u(4:6), props(1:9))", "reshape(props(1:9), [3, 3])"], "RHS("),
    (["turned(u(10:12), props(10:18))", "turned(u(4:6), props(10:18))"], ""),
    (["if (lflags(3) == 5) return", ""], ""),
    (["if (lflags(3) /= 2) then", "if (lflags(3) == 1) then"], "RHS for LFLAGS(3) = 5 is not that for LFLAGS(3) = 1"),
    (["if (lflags(3) == 5) return", "if (lflags(3) /= 1) return"], "AMATRX for LFLAGS(3) = 2 is not that"),
    (["rubs = props", "rubs = .false. .and. props"], "RHS("),
    (["(sin(angle / 2) / angle)**2", "(sin(angle) / angle)**2"], "RHS("),
    (["    results = 0\n", "    results = 0\n    pnewdt = 0.5_dp\n"], "refused by PNEWDT"),
];

#[test]
fn mistakes_around_an_element_are_found() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let exported = Exported::new("slot");
    for (texts, says) in MISTAKES {
        let ran = exported.checked(*texts);
        println!("{texts:?}\n{}", ran.stdout);
        // An empty text is a change that changes nothing: SLOT does not ask how node b is turned, and more may be answered.
        ran.exits(i32::from(!says.is_empty())).prints(says);
    }
}

#[test]
fn what_is_no_element_is_told() {
    let bench = Bench::new();
    bench
        .run(&["check", "--element", "slots", "--abi", "uel"])
        .bad_usage("'slots' is no element, but there are slot, slot_2d");
    bench.run(&["check", "--element", "slot", "--abi", "fric"]).bad_usage("elements are routines UEL");
}
