//! `cargo xtask check --derivative`: elements that have nothing to do with this project, right ones and wrong ones.

use crate::common::{Bench, Ran};
use crate::port::Lang;
use serde_json::json;
use std::process::Command;

/// An element, with the file that says how it is called.
struct Element {
    file: &'static str,
    text: &'static str,
    toml: &'static str,
}

const TRUSS: Element =
    Element { file: "truss.f", text: include_str!("derivative/truss.f"), toml: include_str!("derivative/truss.toml") };
const QUAD: Element =
    Element { file: "quad.f90", text: include_str!("derivative/quad.f90"), toml: include_str!("derivative/quad.toml") };
const BEAM: Element =
    Element { file: "beam.f90", text: include_str!("derivative/beam.f90"), toml: include_str!("derivative/beam.toml") };

/// A mistake: the texts that are replaced, and the name that it gets; empty if it is only found.
struct Mistake {
    element: Element,
    texts: &'static [[&'static str; 2]],
    says: &'static str,
}

const END: &str = "    ! end of the tangent\n";

const MISTAKES: &[Mistake] = &[
    Mistake {
        element: TRUSS,
        texts: &[["BLOCK(K,J) = STIFF*D", "BLOCK(K,J) = -STIFF*D"], ["BLOCK(K,K) + STIFF", "BLOCK(K,K) - STIFF"]],
        says: "wrong sign: AMATRX is plus the derivative of RHS with respect to U",
    },
    Mistake {
        element: TRUSS,
        texts: &[["        BLOCK(K,K) = BLOCK(K,K) + STIFF*STRAIN\n", ""]],
        says: "the geometric stiffness",
    },
    Mistake {
        element: TRUSS,
        texts: &[
            ["STIFF*D(K)*D(J)/FIRST", "STIFF*(COORDS(K,2)-COORDS(K,1))\n     1     *(COORDS(J,2)-COORDS(J,1))/FIRST"],
            ["        BLOCK(K,K) = BLOCK(K,K) + STIFF*STRAIN\n", ""],
        ],
        says: "the initial stiffness",
    },
    Mistake {
        element: TRUSS,
        texts: &[["BLOCK(K,J) = STIFF*D(K)*D(J)/FIRST", "BLOCK(K,J) = STIFF*D(K)*D(J)/REAL(FIRST/3.D0,4)/3.D0"]],
        says: "single precision",
    },
    Mistake {
        element: TRUSS,
        texts: &[["          AMATRX(K,3+J) = -BLOCK(K,J)\n", ""]],
        says: "missing: AMATRX(1:3,4:6) is 0",
    },
    Mistake {
        element: QUAD,
        texts: &[["+ volume * slope(j, n) * moduli", "+ area * slope(j, n) * moduli"]],
        says: "AMATRX is 1.333333333 times what it should be",
    },
    Mistake {
        element: QUAD,
        texts: &[["(props(2) - props(1) * log(jacobian))", "props(2)"]],
        says: "a term that comes with stresses or strains",
    },
    Mistake { element: QUAD, texts: &[["g(j, k) * g(l, i)", "g(j, i) * g(l, k)"]], says: "" },
    Mistake { element: QUAD, texts: &[[END, "    amatrx(:, 8) = 0\n"]], says: "missing: AMATRX(:,8) is 0" },
    Mistake {
        element: QUAD,
        texts: &[[END, "    amatrx(3:4, 5:6) = -amatrx(3:4, 5:6)\n"]],
        says: "wrong sign: AMATRX(3:4,5:6)",
    },
    Mistake {
        element: BEAM,
        texts: &[["by_vectors = .false.", "by_vectors = .true."]],
        says: "rotation vector for spin",
    },
    Mistake { element: BEAM, texts: &[[END, "    amatrx = transpose(whole)\n"]], says: "AMATRX is transposed" },
    Mistake {
        element: BEAM,
        texts: &[[END, "    amatrx = (whole + transpose(whole)) / 2\n"]],
        says: "AMATRX is symmetrised",
    },
    Mistake { element: BEAM, texts: &[[END, "    amatrx(4:6, 7:9) = 0\n"]], says: "missing: AMATRX(4:6,7:9) is 0" },
    Mistake {
        element: BEAM,
        texts: &[[END, "    amatrx(:, 4:6) = whole(:, 4:6) * (acos(-1.0_dp) / 180)\n"]],
        says: "units: degrees for radians",
    },
    Mistake {
        element: BEAM,
        texts: &[[END, "    amatrx(:, 4) = whole(:, 5)\n    amatrx(:, 5) = whole(:, 4)\n"]],
        says: "columns 4 and 5 of AMATRX are exchanged",
    },
    Mistake {
        element: BEAM,
        texts: &[["m = props(5:7) * curved / (2 * props(1))", "m = props(5:7) * real(curved) / (2 * props(1))"]],
        says: "",
    },
];

/// A routine compiled with its driver.
fn compiled(bench: &Bench, file: &str, text: &str, toml: &str) -> String {
    std::fs::write(bench.path("element.toml"), toml).unwrap();
    std::fs::write(bench.path(file), text).unwrap();
    let (out, toml) = (bench.path(""), bench.path("element.toml"));
    bench.run(&["check", "--derivative", toml.to_str().unwrap(), "--out", out.to_str().unwrap()]).exits(0);
    let driver = if text.contains("subroutine fric(") { "fric_driver.f90" } else { "uel_driver.f90" };
    let flags = ["-std=legacy", "-O1", "-Wall", "-Wno-unused-dummy-argument", "-ffp-contract=off", "-o", "port"];
    let files = [driver, "jp_stubs.f90", file];
    let output = Command::new("gfortran").args(flags).args(files).current_dir(&out).output().unwrap();
    assert!(output.status.success(), "{file}: {}", String::from_utf8_lossy(&output.stderr));
    bench.path("port").to_str().unwrap().to_owned()
}

fn checked(file: &str, text: &str, toml: &str) -> Ran {
    let bench = Bench::new();
    let program = compiled(&bench, file, text, toml);
    bench.run(&["check", "--derivative", bench.path("element.toml").to_str().unwrap(), "--", &program])
}

/// The number before " digits and more".
fn digits(ran: &Ran) -> f64 {
    let (before, _) = ran.stdout.split_once(" digits and more").unwrap();
    before.rsplit_once(' ').unwrap().1.parse().unwrap()
}

#[test]
fn right_elements_have_more_than_eight_digits() {
    if !Lang::Fortran.is_here() {
        return;
    }
    for Element { file, text, toml } in [TRUSS, QUAD, BEAM] {
        let ran = checked(file, text, toml).exits(0);
        println!("{file}: {}", ran.stdout);
        assert!(digits(&ran) >= 8.0, "{ran:?}");
    }
}

#[test]
fn mistakes_of_elements_are_found_and_named() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let mut named = 0;
    for Mistake { element, texts, says } in MISTAKES {
        let wrong = texts.iter().fold(element.text.to_owned(), |text, [from, to]| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        let ran = checked(element.file, &wrong, element.toml).exits(1);
        println!("{}", ran.stdout);
        if says.is_empty() {
            assert!(ran.stdout.contains("none of the known mistakes explains it"), "{ran:?}");
        } else {
            named += 1;
            ran.prints(says);
        }
    }
    println!("{} mistakes, all found, {named} named", MISTAKES.len());
}

/// An element that takes DU, with states at the start, and the interface with a material.
#[test]
fn an_element_in_increments_is_compared_from_the_start_of_its_increment() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let text = include_str!("derivative/plastic.f90");
    let toml = "routine = \"uelmat\"\ncoords = [[0.0], [10.0]]\nprops = [200.0, 1.0, 20.0, 3.0]\nsvars = [0.01, 0.5]\n\
                at = [0.02, 0.5]\nincrement = [0.0, 0.4]\nscales = [0.05, 0.05]\n";
    let ran = checked("plastic.f90", text, toml).exits(0);
    assert!(digits(&ran) >= 8.0, "{ran:?}");
    checked("plastic.f90", &text.replace("modulus = props(1) * props(3)", "modulus = props(1) * props(1)"), toml)
        .exits(1);
}

const FRIC: &str = include_str!("derivative/fric.f90");
const SLIPS: &str = "routine = \"fric\"\nat = [0.5, 10.0]\ntau = [1.0]\nprops = [0.2, 0.4, 1.5, 100.0]\ndtime = 0.5\n";

#[test]
fn a_friction_model_is_compared_with_itself_and_its_kink_is_told() {
    if !Lang::Fortran.is_here() {
        return;
    }
    checked("fric.f90", FRIC, SLIPS).exits(0).prints("(DDTDDG,DDTDDP) is the derivative of TAU");
    let wrong = FRIC.replace("s * dmu * press * sign", "-s * dmu * press * sign");
    checked("fric.f90", &wrong, SLIPS).exits(1).prints("wrong sign: (DDTDDG,DDTDDP)(1,1)");
    // On the limit itself: 1 + 100 · 0.02 is 0.3 · 10, at a rate of 0 in the exponent.
    let limit = "routine = \"fric\"\nat = [0.02, 10.0]\ntau = [1.0]\nprops = [0.3, 0.3, 1.5, 100.0]\n";
    let ran = checked("fric.f90", FRIC, limit).exits(0);
    assert!(ran.stdout.contains("kink at the given state: dTAU(1)/d(DGAM,PRESS)(1)"), "{ran:?}");
}

/// A program in any language: the norm of a vector, on its kink and beside it.
#[test]
fn any_program_is_compared_and_what_is_wrong_in_the_file_is_told() {
    let bench = Bench::new();
    let toml = |text: &str| {
        std::fs::write(bench.path("f.toml"), text).unwrap();
        bench.path("f.toml").to_str().unwrap().to_owned()
    };
    let program = "while read x y; do awk -v x=$x -v y=$y 'BEGIN { r = sqrt(x * x + y * y); \
                   printf \"%.17g %.17g %.17g\\n\", r, x / r, S * y / r }'; done";
    let of = |sign: &str| program.replace('S', sign);
    let file = toml("routine = \"program\"\nat = [3.0, 4.0]\noutputs = 1\n");
    let run = |program: &str| bench.run(&["check", "--derivative", &file, "--", "sh", "-c", program]);
    run(&of("1")).exits(0).prints("J is the derivative of f with respect to x");
    run(&of("-1")).exits(1).prints("wrong sign: J(1,2)");
    let ran = bench.run(&["check", "--derivative", &file, "--format", "json", "--", "sh", "-c", &of("-1")]).exits(1);
    let said: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(
        [&said["right"], &said["wrong"][0]["column"], &said["wrong"][0]["found"]],
        [&json!(false), &json!(2), &json!(-0.8)]
    );
    let at = ["--format", "rdjson", "--at", "mine.f90:7", "--", "sh", "-c", &of("-1")];
    bench.run(&[&["check", "--derivative", &file][..], &at].concat()).exits(1).prints("\"line\": 7");
    for (text, says) in [
        ("routine = \"program\"\nat = [1.0]\n", "`outputs` is needed"),
        ("routine = \"uel\"\nat = [1.0]\n", "`coords` is needed"),
        ("routine = \"uel\"\nat = [1.0]\ncoords = [[0.0]]\nrotations = [[1, 2, 3]]\n", "degrees of freedom are 1 to 1"),
        ("routine = \"fric\"\nat = [1.0, 2.0]\n", "`tau` needs 1 numbers"),
        ("routine = \"umat\"\nat = [1.0]\n", "umat"),
    ] {
        let file = toml(text);
        bench.run(&["check", "--derivative", &file, "--", "true"]).bad_usage(says);
    }
}
