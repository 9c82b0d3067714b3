//! The readers of golden files in C and Fortran shown in the book: a right port passes, and wrong ones fail. The
//! Python reader is tested with the oracle.

use crate::common::{is_here, repository};
use std::path::Path;
use std::process::Command;

/// Compiles a reader with a text replaced, and runs it on the golden file; returns whether all is right, and the output.
fn read(command: &[&str], file: &str, [from, to]: [&str; 2]) -> (bool, String) {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(repository().join("book/examples").join(file)).unwrap();
    assert!(text.contains(from), "{from:?} is not in {file}");
    std::fs::write(folder.path().join(file), text.replace(from, to)).unwrap();
    let run = |program: &Path, arguments: &[&str]| {
        Command::new(program).args(arguments).current_dir(folder.path()).output().unwrap()
    };
    let compiled = run(Path::new(command[0]), &[&command[1..], &["-o", "reader", file, "-lm"]].concat());
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let golden = repository().join("golden/slider.line.json");
    let ran = run(&folder.path().join("reader"), &[golden.to_str().unwrap()]);
    (ran.status.success(), String::from_utf8(ran.stdout).unwrap())
}

/// Wrong ports, each given by a replaced text of the reader.
fn judges(command: &[&str], file: &str, wrong: &[[&str; 2]]) {
    if !is_here(command[0]) {
        return;
    }
    let (right, said) = read(command, file, ["", ""]);
    assert!(right && said.ends_with(" passed, 0 failed\n"), "{said}");
    for plant in wrong {
        let (right, said) = read(command, file, *plant);
        assert!(!right && said.contains("wrong: "), "{plant:?}: {said}");
    }
}

#[test]
fn c() {
    let command = ["gcc", "-std=c99", "-O1", "-Wall", "-Wextra", "-pedantic", "-Werror"];
    let wrong = [
        ["= -jac->n_xn[i][j];", "= jac->n_xn[i][j];"],
        // A cancellation, and a missing rejection.
        ["(i == j ? a * a + b * b :", "(i == j ? (void)a, (void)b, 1 - n[i] * n[i] :"],
        ["if (largest < 2.2250738585072014e-308) return 0;", ""],
        ["*l = largest * sqrt(sum);", "*l = largest * sqrt(sum) * (1 + 1e-14);"],
    ];
    judges(&command, "read_golden.c", &wrong);
}

#[test]
fn fortran() {
    let wrong = [
        ["[reshape(-transpose(turn), [9]),", "[reshape(transpose(turn), [9]),"],
        [".and. maxval(abs(d)) >= tiny(1.0_dp)", ""],
        ["l = l * maxval(abs(d))", "l = l * maxval(abs(d)) * (1 + 1e-14_dp)"],
    ];
    judges(&["gfortran", "-std=f2008", "-O1"], "read_golden.f90", &wrong);
}
