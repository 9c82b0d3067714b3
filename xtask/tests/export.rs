//! `cargo xtask export --check`: what is exported, compiled and run where the compilers are, has every bit of what runs here.

mod common;

use common::{Bench, assert_accepted, is_here};

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

/// What is exported is looked at once, by whoever changes it: branches, functions, a search, programs in parts, user routines.
#[test]
fn every_file_is_as_it_was_accepted() {
    const FORMULAS: &str = "{coulomb.return_map,interaction.pressure_exponential,universal.angles,slide_line.closest_parabolic,\
                            slider.geometric_stiffness,slot.friction}";
    let of = ["c", "fortran", "js", "numpy", "fpcore"].map(|lang| (lang, vec!["--lang", lang, "--filter", FORMULAS]));
    let shells =
        ["uel-slot", "uel-translator", "uel-ujoint", "fric", "mpc"].map(|shell| (shell, vec!["--shell", shell]));
    let mut texts = Vec::new();
    for (name, wanted) in of.into_iter().chain(shells) {
        let bench = Bench::new();
        bench.run(&[&["export", "--out", bench.path("out").to_str().unwrap()], &wanted[..]].concat()).exits(0);
        let files = bench.files("out").into_iter();
        texts.extend(files.map(|(file, (bytes, _))| (format!("{name}/{file}"), String::from_utf8(bytes).unwrap())));
    }
    texts.extend(drivers());
    assert_accepted("export", "exports.txt", &texts);
}

/// Programs to begin with, that call somebody's own code or, as an example, what is exported.
fn drivers() -> impl Iterator<Item = (String, String)> {
    let own = ["c", "cpp", "fortran", "python", "julia"].map(|lang| (lang, "own", vec![]));
    let exported = ["c", "cpp", "fortran", "python"].map(|lang| (lang, "exported", vec!["--exported"]));
    let all = own.into_iter().chain(exported).flat_map(|(lang, of, options)| {
        ["value", "jacobian"]
            .map(|wanted| (lang, of, [&["--driver", lang, "--wanted", wanted], &options[..]].concat(), wanted))
    });
    all.map(|(lang, of, options, wanted)| {
        let ran = Bench::new().run(&[&["check", "--formula", "slider.eliminate"], &options[..]].concat()).exits(0);
        (format!("driver/{lang} {of} {wanted}"), ran.stdout)
    })
}
