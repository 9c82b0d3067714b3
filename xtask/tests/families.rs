//! Families of routines for `cargo xtask check --abi`, made by rule from a right one: no wrong one is called right, and no
//! right one wrong.

mod mutants;
mod right;

use crate::common::{Bench, Ran, all_mistakes};
use crate::port::{Lang, sources};
use mutants::mutants;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;
use std::process::Command;

/// A family around a right routine.
struct Family {
    abi: &'static str,
    id: &'static str,
    /// The name of the routine.
    routine: &'static str,
    base: &'static str,
    /// The exported formulas that it calls.
    uses: &'static [&'static str],
    /// The arguments and local variables that a wrong routine ignores, with what stands in their place.
    ignored: &'static [(&'static str, &'static str)],
    /// Mutants that compute the same at ordinary sizes: the rule, and the changed line.
    same: &'static [(&'static str, &'static str)],
}

/// A routine of a family.
struct Member {
    name: String,
    text: String,
    is_fixed_form: bool,
}

impl Member {
    /// A member with these statements, behind these declarations.
    fn new(name: String, declarations: &str, body: &str) -> Self {
        Self { name, text: format!("{declarations}    ! begin\n{body}"), is_fixed_form: false }
    }
}

const REAL: &str = "0.0_dp";

const FAMILIES: &[Family] = &[
    Family {
        abi: "fric",
        id: "coulomb.return_map_2d",
        routine: "fric",
        base: include_str!("families/fric.f90"),
        uses: &[],
        ignored: &[
            ("tau", REAL),
            ("dgam", REAL),
            ("press", "1.0_dp"),
            ("props", "1.0_dp"),
            ("limit", REAL),
            ("n1", "1.0_dp"),
        ],
        same: &[],
    },
    Family {
        abi: "uinter",
        id: "coulomb.return_map_2d",
        routine: "uinter",
        base: include_str!("families/uinter.f90"),
        uses: &[],
        ignored: &[("statev", REAL), ("drdisp", REAL), ("rdisp", "1.0_dp"), ("props", "1.0_dp"), ("n2", "1.0_dp")],
        // While surfaces are open the stiffness does not matter, and two entries are never anything but 0.
        same: &[("left out", "ddsddr(1, 1) = 0"), ("left out", "ddsddr(1, 2) = 0"), ("left out", "ddsddr(1, 3) = 0")],
    },
    Family {
        abi: "mpc",
        id: "slider.eliminate",
        routine: "mpc",
        base: include_str!("families/mpc.f90"),
        uses: &["slider.eliminate"],
        ignored: &[("x", REAL), ("u", REAL), ("jtype", "1"), ("slope", REAL), ("e", "1"), ("k", "1"), ("kept", REAL)],
        // The size of the direction does not matter, and the scaling is for the largest: without it squares overflow, which the
        // verdict says among the sizes.
        same: &[
            ("doubled", "d = abs(xn - x1)"),
            ("doubled", "d = scale(d, -exponent(maxval(d)))"),
            ("left out", "d = scale(d, -exponent(maxval(d)))"),
        ],
    },
    Family {
        abi: "mpc-node",
        id: "slider.eliminate",
        routine: "mpc",
        base: include_str!("families/mpc_node.f90"),
        uses: &["slider.eliminate"],
        ignored: &[("x", REAL), ("u", REAL), ("slope", REAL), ("i", "1"), ("j", "1"), ("k", "1"), ("kept", REAL)],
        // The size of the direction does not matter, and the scaling is for the largest: without it squares overflow, which the
        // verdict says among the sizes.
        same: &[
            ("doubled", "d = abs(xn - x1)"),
            ("doubled", "d = scale(d, -exponent(maxval(d)))"),
            ("left out", "d = scale(d, -exponent(maxval(d)))"),
        ],
    },
    Family {
        abi: "umpc_user",
        id: "slider.constraint",
        routine: "umpc_user",
        base: include_str!("families/umpc_user.f90"),
        uses: &["slider.constraint"],
        ignored: &[("x", REAL), ("u", REAL), ("slope", "1.0_dp"), ("equation", "1"), ("row", "1.0_dp"), ("k", "1")],
        // The last term has the coefficient 0, also at first; a swap with itself.
        same: &[("left out", "a(10) = 0"), ("left out", "jdof(10) = 1"), ("always", "if (k /= 1) then")],
    },
    Family {
        abi: "uel",
        id: "slider.nodal_forces",
        routine: "uel",
        base: include_str!("families/uel.f90"),
        uses: &["slider.nodal_forces", "slider.constraint"],
        ignored: &[
            ("coords", REAL),
            ("u", REAL),
            ("of_f", REAL),
            ("of_g", REAL),
            ("f", REAL),
            ("lflags", "1"),
            ("g", REAL),
        ],
        // More than was asked for, and what is 0 at first.
        same: &[
            ("always", "if (lflags(3) == 1 .or. lflags(3) == 5) then"),
            ("lflags(3) ignored", "if (lflags(3) == 1 .or. lflags(3) == 5) then"),
            ("always", "if (lflags(3) == 1 .or. lflags(3) == 2) then"),
            ("lflags(3) ignored", "if (lflags(3) == 1 .or. lflags(3) == 2) then"),
            ("left out", "amatrx(10:11, 10:11) = 0"),
        ],
    },
];

impl Family {
    /// The text before the first statement, with the name of a member instead of that of the routine.
    fn head(&self, name: &str) -> String {
        let (head, _) = self.base.split_once("    ! begin\n").unwrap();
        head.replacen(&format!("subroutine {}(", self.routine), &format!("subroutine {name}("), 1)
    }

    /// The arguments.
    fn arguments(&self) -> &str {
        let (_, rest) = self.base.split_once('(').unwrap();
        rest.split_once(')').unwrap().0
    }

    /// The statements.
    fn body(&self) -> &str {
        let (_, rest) = self.base.split_once("    ! begin\n").unwrap();
        rest.split_once("    ! end\n").unwrap().0
    }

    /// A member that is the right routine with texts replaced.
    fn replaced(&self, name: &str, texts: &[(&str, &str)]) -> Member {
        let text = texts.iter().fold(format!("    ! begin\n{}", self.body()), |text, (from, to)| {
            assert!(text.contains(from), "{name}: {from}");
            text.replace(from, to)
        });
        Member { name: name.to_owned(), text, is_fixed_form: false }
    }

    /// A program that calls the member whose number it is given.
    fn compiled(&self, bench: &Bench, members: &[Member]) {
        let mut free = String::new();
        let mut fixed = String::new();
        let mut calls = String::new();
        for (k, member) in members.iter().enumerate() {
            let name = format!("{}_{k}", self.routine);
            if member.is_fixed_form {
                fixed += &member.text.replace('@', &name.to_uppercase());
            } else {
                let text = member.text.replace('@', &name);
                let _ = write!(free, "{}{text}end subroutine\n\n", self.head(&name).trim_end_matches(' '));
            }
            let _ = writeln!(calls, "    case ({k})\n        call {name}({})", self.arguments());
        }
        let chosen = "    character(len=8) :: chosen\n    integer :: member\n    call get_command_argument(1, chosen)\n    \
                      read (chosen, *) member\n    select case (member)\n";
        let _ =
            write!(free, "{}{chosen}{calls}    end select\nend subroutine {}\n", self.head(self.routine), self.routine);
        let out = bench.path("");
        bench.run(&["check", "--formula", self.id, "--abi", self.abi, "--out", out.to_str().unwrap()]).exits(0);
        std::fs::write(bench.path("members.f90"), free).unwrap();
        std::fs::write(bench.path("fixed.f"), fixed).unwrap();
        let mut files = Vec::new();
        for used in self.uses {
            bench.run(&["export", "--lang", "fortran", "--filter", used, "--out", out.to_str().unwrap()]).exits(0);
            files.extend(sources(&out, &used.replace('.', "_"), "f90"));
        }
        if !files.is_empty() {
            files.insert(0, "jp_runtime.f90".to_owned());
        }
        files.extend(
            ["members.f90", "fixed.f", &format!("{}_driver.f90", self.routine), "jp_stubs.f90"].map(str::to_owned),
        );
        let flags = ["-std=legacy", "-O0", "-ffp-contract=off", "-ffree-line-length-none", "-o", "port"];
        let output = Command::new("gfortran").args(flags).args(files).current_dir(&out).output().unwrap();
        assert!(output.status.success(), "{}: {}", self.abi, String::from_utf8_lossy(&output.stderr));
    }

    /// What `check` says about a member.
    fn checked(&self, bench: &Bench, member: usize) -> Ran {
        let (program, member) = (bench.path("port"), member.to_string());
        let asked = ["check", "--formula", self.id, "--valid-only", "--samples", "40", "--", program.to_str().unwrap()];
        bench.run(&[&asked[..], &[&member]].concat())
    }

    /// The members that are not judged so; prints the figures.
    fn misjudged(&self, bench: &Bench, what: &str, members: &[Member], code: i32) -> Vec<String> {
        self.compiled(bench, members);
        let numbers: Vec<_> = (0..members.len()).collect();
        let judged: Vec<_> = numbers.par_iter().map(|&k| self.checked(bench, k)).collect();
        let is_off = |(member, ran): (&Member, Ran)| {
            let says = || format!("{} {}: {}\n{}{}", self.abi, what, member.name, ran.stdout, ran.stderr);
            (ran.code != Some(code)).then(says)
        };
        let off: Vec<_> = members.iter().zip(judged).filter_map(is_off).collect();
        println!("{:10} {:6} {:4} members, {} misjudged", self.abi, what, members.len(), off.len());
        off
    }
}

/// The least sizes of a family.
const LEAST: [usize; 2] = [40, 10];
/// About how many wrong routines of a family are compiled where not all are wanted.
const SOME: usize = 12;

fn spread(members: Vec<Member>) -> Vec<Member> {
    let every = if all_mistakes() { 1 } else { members.len().div_ceil(SOME) };
    members.into_iter().step_by(every).collect()
}

/// The figures are printed: `JOINTPROOF_ALL_MISTAKES=1 cargo test -p xtask --test all families:: -- --nocapture`.
#[test]
fn no_wrong_routine_is_called_right_and_no_right_one_wrong() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let mut misjudged = Vec::new();
    for family in FAMILIES {
        for (what, members, code, least) in
            [("wrong", mutants(family), 1, LEAST[0]), ("right", right::members(family), 0, LEAST[1])]
        {
            assert!(members.len() >= least, "{}: {} {what} members", family.abi, members.len());
            let members = if code == 0 { members } else { spread(members) };
            misjudged.extend(family.misjudged(&Bench::new(), what, &members, code));
        }
    }
    assert!(misjudged.is_empty(), "{}", misjudged.join("\n"));
}
