//! `cargo xtask export --check`: what is exported, compiled and run where the compilers are, has every bit of what runs here.

mod common;

use common::{Bench, is_here};

#[test]
fn what_is_exported_has_every_bit() {
    for (lang, program) in [("c", "gcc"), ("fortran", "gfortran"), ("js", "node")] {
        if !is_here(program) {
            continue;
        }
        let bench = Bench::new();
        let out = bench.path("exported");
        let wanted = ["--filter", "slot.*", "--out", out.to_str().unwrap()];
        let checked = [&["export", "--lang", lang][..], &wanted, &["--check", "--samples", "20"]].concat();
        let ran = bench.run(&checked).exits(0).prints(&format!("ok  {program}: "));
        assert!(ran.stdout.contains(" 0 differ"), "{ran:#?}");
        // Something was compared.
        let said = ran.stdout.lines().find(|line| line.starts_with(&format!("ok  {program}"))).unwrap();
        let numbers: u64 = said.split(' ').find_map(|word| word.parse().ok()).unwrap();
        assert!(numbers > 1000, "{said}");
    }
}

#[test]
fn lines_are_counted() {
    let bench = Bench::new();
    let ran = bench.run(&[
        "export",
        "--lang",
        "numpy",
        "--filter",
        "coulomb.*",
        "--out",
        bench.path("out").to_str().unwrap(),
    ]);
    let files = std::fs::read_dir(bench.path("out")).unwrap().map(|entry| entry.unwrap().path());
    let lines: usize = files.map(|file| std::fs::read_to_string(file).unwrap().lines().count()).sum();
    ran.exits(0).prints(&format!(" formulas, {lines} lines in "));
}
