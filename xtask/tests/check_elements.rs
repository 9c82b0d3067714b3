//! `cargo xtask check --element`: exported elements are right, and mistakes in the routine around them are found.

use crate::common::{Bench, Ran, all_mistakes};
use crate::port::Lang;
use jointproof::catalog::{AnyElement, ELEMENTS};
use jointproof::toolkit::graph::Extremes;
use std::process::Command;

/// An exported element: its modules, which are compiled once, and the routine around them.
struct Exported {
    bench: Bench,
    element: &'static str,
    routine: String,
}

fn compile(bench: &Bench, arguments: &[&str]) {
    let output = Command::new("gfortran").args(arguments).current_dir(bench.path("")).output().unwrap();
    assert!(output.status.success(), "{arguments:?}\n{}", String::from_utf8_lossy(&output.stderr));
}

/// As Abaqus compiles it, and fast.
const FLAGS: [&str; 3] = ["-std=legacy", "-O0", "-ffp-contract=off"];
/// The arguments of an interface need not be used.
const STRICT: [&str; 6] = ["-std=f2008", "-fsyntax-only", "-Wall", "-Wextra", "-Wno-unused-dummy-argument", "-Werror"];

impl Exported {
    fn new(element: &'static str) -> Self {
        let bench = Bench::new();
        let out = bench.path("");
        let exported = ["export", "--shell", "uel", "--element", element, "--out", out.to_str().unwrap()];
        bench.run(&exported).exits(0);
        bench.run(&["check", "--element", element, "--abi", "uel", "--out", out.to_str().unwrap()]).exits(0);
        let text = std::fs::read_to_string(bench.path(&format!("uel_{element}.f90"))).unwrap();
        let of_routine = format!("\nmodule jp_uel_{element}\n");
        let (modules, routine) = text.split_once(&of_routine).unwrap();
        std::fs::write(bench.path("modules.f90"), format!("{modules}\n")).unwrap();
        compile(&bench, &[&FLAGS[..], &["-c", "modules.f90", "uel_driver.f90"]].concat());
        Self { bench, element, routine: format!("{of_routine}{routine}") }
    }

    /// What is said about the routine with a text replaced.
    fn checked(&self, [from, to]: [&str; 2]) -> Ran {
        assert!(self.routine.contains(from), "{from}");
        std::fs::write(self.bench.path("routine.f90"), self.routine.replacen(from, to, 1)).unwrap();
        let files = ["-o", "port", "routine.f90", "modules.o", "uel_driver.o"];
        compile(&self.bench, &[&FLAGS[..], &files].concat());
        let program = self.bench.path("port");
        self.bench.run(&["check", "--element", self.element, "--strict", "--", program.to_str().unwrap()])
    }

    /// The statements that say what the routine answers, each with its sign reversed.
    fn turned(&self) -> Vec<[String; 2]> {
        let turned = |line: &str| {
            let (left, right) = line.split_once(" = ")?;
            let is_answer = ["rhs(", "amatrx(", "svars("].iter().any(|name| left.contains(name)) && right != "0";
            let right = right.strip_prefix('-').map_or_else(|| format!("-{right}"), str::to_owned);
            is_answer.then(|| [line.to_owned(), format!("{left} = {right}")])
        };
        self.routine.lines().filter_map(turned).collect()
    }
}

/// Every element whose operations are recorded.
fn elements() -> impl Iterator<Item = &'static str> {
    let is_recorded = |element: &&&dyn AnyElement| element.graph(false, Extremes::Joined).is_ok();
    ELEMENTS.iter().filter(is_recorded).map(|element| element.spec().id)
}

/// Elements without and with friction, with and without multipliers; the others where all mistakes are wanted.
const SOME: [&str; 3] = ["slot_2d", "hinge", "isl21a_exponential"];
/// How many single numbers of a matrix are given the other sign.
const NUMBERS: usize = 6;

/// Strictly, and not with a sign turned: of all numbers of a kind, and of single numbers of the stiffness.
#[test]
fn exported_elements_are_those_of_the_catalog_and_none_with_a_turned_sign_is() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let mut planted = 0;
    for element in elements().filter(|element| all_mistakes() || SOME.contains(element)) {
        let exported = Exported::new(element);
        exported.checked(["", ""]).exits(0).prints("those of the element at").prints("within η");
        for [from, to] in exported.turned() {
            exported.checked([&from, &to]).exits(1).prints("it is not the element at");
            planted += 1;
        }
        let file = ELEMENTS.iter().find(|one| one.spec().id == element).unwrap().golden();
        let matrices: Vec<_> = file.cases.iter().filter_map(|case| Some(&case.out.as_ref()?.stiffness)).collect();
        let size = matrices[0].len();
        // Not those that are always 0, nor those that are small beside others of their row.
        let is_large = |row: usize, column: usize| {
            matrices.iter().any(|matrix| {
                let most = matrix[row].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                matrix[row][column].abs() > 1e-3 * most
            })
        };
        let places = (0..size * size).map(|k| (k / size, k % size)).filter(|&(row, column)| is_large(row, column));
        let places: Vec<_> = places.collect();
        for (row, column) in
            places.iter().step_by(places.len().div_ceil(NUMBERS)).map(|(row, column)| (row + 1, column + 1))
        {
            let matrix = "amatrx(:motions, :motions) = -stiffness";
            let turned = format!("stiffness({row}, {column}) = -stiffness({row}, {column})\n{matrix}");
            exported.checked([matrix, &turned]).exits(1).prints(&format!("AMATRX({row},{column}) is "));
            planted += 1;
        }
    }
    println!("{planted} signs turned, each found");
}

/// The longest file and the longest line that a shell may have, in bytes and in columns, and the longest routine in it, in lines.
const LONGEST: [usize; 3] = [400_000, 100, 400];

/// The length of a shell, its longest line, and its longest routine.
fn lengths(text: &str) -> [usize; 3] {
    let (mut longest, mut lines) = (0, 0);
    let mut columns = 0;
    for line in text.lines() {
        columns = columns.max(line.chars().count());
        let words: Vec<_> = line.split([' ', '(']).filter(|word| !word.is_empty()).collect();
        lines = match words[..] {
            ["end", "subroutine" | "function", ..] => {
                longest = longest.max(lines + 1);
                0
            }
            ["subroutine" | "function", ..] | ["pure" | "elemental", "subroutine" | "function", ..] => 1,
            _ if lines > 0 => lines + 1,
            _ => 0,
        };
    }
    [text.len(), columns, longest]
}

#[test]
fn lines_of_a_shell_are_counted() {
    assert_eq!(lengths("module a\nsubroutine b(x)\n  x = 1\nend subroutine b\nend module a\n"), [63, 16, 3]);
    let two = "pure function b(x)\nend function b\nx\nx\n      subroutine c\n\n\n      end subroutine c\n";
    assert_eq!(lengths(two)[1..], [22, 4]);
}

/// In both forms, in words of the standard, where Abaqus's own file has others; and none is too long.
#[test]
fn exported_shells_are_short_and_compile_without_a_warning() {
    let bench = Bench::new();
    let out = bench.path("");
    for include in ["ABA_PARAM.INC", "vaba_param.inc"] {
        std::fs::write(bench.path(include), "      implicit double precision (a-h, o-z)\n").unwrap();
    }
    let written = |arguments: &[&str]| {
        let ran = bench.run(&[&["export", "--out", out.to_str().unwrap(), "--shell"], arguments].concat()).exits(0);
        let path = ran.stdout.trim_end().rsplit_once('/').unwrap().1.to_owned();
        path.rsplit_once('.').unwrap().0.to_owned()
    };
    let elements = elements().flat_map(|element| ["uel", "vuel"].map(|shell| vec![shell, "--element", element]));
    let with_penalties = vec!["uel", "--element", "hinge", "--penalty"];
    let by_hand = ["fric", "mpc", "umpc-user"].map(|shell| vec![shell]);
    for shell in elements.chain([with_penalties]).chain(by_hand) {
        let name = written(&shell);
        assert_eq!(name, written(&[&shell[..], &["--fixed"]].concat()));
        for (form, file) in [("-ffree-form", format!("{name}.f90")), ("-ffixed-form", format!("{name}.f"))] {
            let lengths = lengths(&std::fs::read_to_string(bench.path(&file)).unwrap());
            let is_short = lengths.iter().zip(LONGEST).all(|(length, longest)| (1..=longest).contains(length));
            assert!(is_short, "{file}: {lengths:?} bytes, columns, and lines of a routine");
            if Lang::Fortran.is_here() {
                compile(&bench, &[&STRICT[..], &[form, &file]].concat());
            }
        }
    }
}

/// Two elements, told apart by their types, and two other routines, each exported alone, in one file of either form.
#[test]
fn shells_in_one_file_do_not_clash() {
    if !Lang::Fortran.is_here() {
        return;
    }
    for (form, extension) in [(&[][..], "f90"), (&["--fixed"], "f")] {
        for [first, second] in [["slot_2d", "universal"], ["universal", "slot_2d"]] {
            let bench = Bench::new();
            let out = bench.path("");
            let export = |arguments: &[&str]| {
                let arguments = [&["export", "--out", out.to_str().unwrap()], arguments, form].concat();
                bench.run(&arguments).exits(0);
            };
            export(&["--shell", "uel", "--element", first, "--element", second]);
            export(&["--shell", "fric"]);
            export(&["--shell", "mpc"]);
            bench.run(&["check", "--element", first, "--abi", "uel", "--out", out.to_str().unwrap()]).exits(0);
            let files = [format!("uel_{first}_{second}"), "fric".into(), "mpc".into()];
            let text = |name| std::fs::read_to_string(bench.path(&format!("{name}.{extension}"))).unwrap();
            let all = format!("all.{extension}");
            std::fs::write(bench.path(&all), files.map(text).concat()).unwrap();
            let program = ["-o", "port", &all, "uel_driver.f90", "jp_stubs.f90"];
            compile(&bench, &[&FLAGS[..], &program].concat());
            let program = bench.path("port");
            bench.run(&["check", "--element", first, "--", program.to_str().unwrap()]).exits(0);
        }
    }
}

#[test]
fn a_shell_is_of_an_element_that_can_be_exported() {
    let bench = Bench::new();
    let out = bench.path("out");
    let export =
        |arguments: &[&str]| bench.run(&[&["export", "--out", out.to_str().unwrap(), "--shell"], arguments].concat());
    export(&["uel"]).bad_usage("--shell uel: an element, by --element slot|slot_2d|");
    export(&["vuel"]).bad_usage("--shell vuel: an element, by --element slot|slot_2d|");
    export(&["fric", "--element", "slot"]).bad_usage("--element: elements are routines UEL or VUEL");
    export(&["uel", "--element", "slot", "--arms"]).bad_usage("cannot be used with");
    export(&["uel", "--element", "isl21a_linear", "--penalty"])
        .bad_usage("--element isl21a_linear: it has no multipliers that penalties could replace");
}

/// Mistakes in the routine around SLOT, with what is said.
const MISTAKES: &[([&str; 2], &str)] = &[
    (["= -stiffness", "= stiffness"], "AMATRX(1,1)"),
    (["= -by_multipliers", "= by_multipliers"], "AMATRX("),
    (["= -rows", "= rows"], "AMATRX(13,"),
    (["= -stiffness", "= 0"], "AMATRX("),
    (["= -stiffness", "= -transpose(stiffness)"], "AMATRX("),
    (["1) = forces", "1) = -forces"], "RHS("),
    (["1) = residuals", "1) = -residuals"], "RHS(13)"),
    (["if (rubs) svars(:2) = after", ""], "SVARS("),
    (["svars(:2) = after", "svars(:2) = -9d9"], "SVARS("),
    (["svars(:2) = after", "svars(:5) = 1"], "writes behind the array SVARS"),
    (["coords(:3, 1) + u(1:3)", "coords(:3, 1)"], "RHS("),
    (["coords(:3, 2) + u(7:9)", "u(7:9)"], "RHS("),
    (["turned(u(4:6), props(1:9))", "reshape(props(1:9), [3, 3])"], "RHS("),
    (["turned(u(10:12), props(10:18))", "turned(u(4:6), props(10:18))"], ""),
    (["if (lflags(3) == 5) return", ""], ""),
    (["if (lflags(3) /= 2) then", "if (lflags(3) == 1) then"], "RHS for LFLAGS(3) = 5 is not that for LFLAGS(3) = 1"),
    (["if (lflags(3) == 5) return", "if (lflags(3) /= 1) return"], "AMATRX for LFLAGS(3) = 2 is not that"),
    (["rubs = .not.", "rubs = .false. .and. .not."], "RHS("),
    (["rubs = .not. abs(props(22)) <= 0", "rubs = props(22) > 0"], "not refused, though it is not allowed"),
    (["(sin(angle / 2) / angle)**2", "(sin(angle) / angle)**2"], "RHS("),
    (["is_well = code == 0", "is_well = code == 0; pnewdt = 0.5_dp"], "refused by PNEWDT"),
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
        ("amatrx(10, 1:9) = -of_g(1, :)", "amatrx(10, 1:9) = of_g(1, :)"),
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
    bench.run(&["check", "--element", "slot", "--eta", "3", "--", "cat"]).bad_usage("cannot be used with '--eta");
    let ran = bench.run(&["check", "--element", "slot", "--format", "json", "--", "cat"]).exits(1);
    let said: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(said["points"], said["faults"][0]["points"], "{said}");
    bench.run(&["check", "--element", "slot", "--abi", "fric"]).bad_usage("elements are routines UEL");
}
