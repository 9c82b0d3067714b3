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

/// A UEL of SLIDER as a textbook has it, with texts replaced.
fn slider(bench: &Bench, texts: &[(&str, &str)]) -> Ran {
    let base = include_str!("families/uel.f90");
    let (head, body) = base.split_once("    ! begin\n").unwrap();
    let calls = body.find("    code = jp_slider_constraint").unwrap()
        ..body.find("    if (lflags(3) == 1 .or. lflags(3) == 5)").unwrap();
    let textbook = concat!(
        "    with_first = first\n    with_second = second\n",
        include_str!("families/textbook.f90"),
        "    g = gaps\n    of_g = of_gaps\n    f = loads\n    of_f = of_loads\n"
    );
    let head: Vec<_> = head.lines().filter(|line| !line.trim_start().starts_with("use ")).collect();
    let declared = include_str!("families/textbook_declared.f90");
    let whole = format!("{}\n{declared}{}{textbook}{}", head.join("\n"), &body[..calls.start], &body[calls.end..]);
    let whole = texts.iter().fold(whole, |whole, (from, to)| {
        assert!(whole.contains(from), "{from}");
        whole.replace(from, to)
    });
    std::fs::write(bench.path("routine.f90"), whole).unwrap();
    compile(bench, &["-ffree-line-length-none", "-o", "port", "routine.f90", "uel_driver.f90"]);
    let program = bench.path("port");
    bench.run(&["check", "--element", "slider", "--", program.to_str().unwrap()])
}

/// Off its line, where an iteration of Newton's method hands it in, a UEL may have the derivative of its conditions or the rows
/// that it has on the line; what is wrong on the line stays wrong.
#[test]
fn a_slider_off_its_line_is_right_in_either_way() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let bench = Bench::new();
    let out = bench.path("");
    bench.run(&["check", "--element", "slider", "--abi", "uel", "--out", out.to_str().unwrap()]).exits(0);
    slider(&bench, &[]).exits(0).prints("with the derivative of its conditions in AMATRX also where they are violated");
    // The rows of m on its line.
    let on_line = [
        (
            "dot_product(moved(7:9) - moved(1:3), t0) + dot_product(xm - x1, dt0)",
            "dot_product(moved(7:9) - (1 - share) * moved(1:3) - share * moved(4:6), t0)",
        ),
        (
            "dot_product(moved(7:9) - moved(1:3), t9) + dot_product(xm - x1, dt9)",
            "dot_product(moved(7:9) - (1 - share) * moved(1:3) - share * moved(4:6), t9)",
        ),
    ];
    slider(&bench, &on_line).exits(0).prints("for LFLAGS(3) = 1, 2 and 5\n");
    for wrong in [
        ("dm = with_first * dt0 + with_second * dt9", "dm = 0"),
        ("dm = with_first * dt0 + with_second * dt9", "dm = with_first * dt0 - with_second * dt9"),
        ("dshare * on_m - (1 - share) * dm", "-(1 - share) * dm"),
        ("rhs(10:11) = g", "rhs(10:11) = -g"),
        ("amatrx(10, 1:9) = -of_g(:, 1)", "amatrx(10, 1:9) = of_g(:, 1)"),
        ("-(1 - share) * on_m, -share * on_m, on_m", "-share * on_m, -(1 - share) * on_m, on_m"),
        ("dot_product(xm - x1, dt0)", "2 * dot_product(xm - x1, dt0)"),
        ("share = dot_product(xm - x1, n0) / length", "share = dot_product(xm - x1, n0)"),
    ] {
        slider(&bench, &[wrong]).exits(1).prints("it is not the element");
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
