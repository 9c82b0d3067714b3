//! `cargo xtask export --check`: exported code, compiled and run if the compilers are available, has the same bits as
//! this program.

#[cfg(unix)]
use crate::common::reference;
use crate::common::{Bench, assert_accepted, is_here};
use std::process::Command;

#[test]
fn what_is_exported_has_every_bit() {
    for (lang, program) in [("c", "gcc"), ("fortran", "gfortran"), ("js", "node")] {
        if !is_here(program) {
            continue;
        }
        let universal = ["--element", "universal"];
        let all_together = [&universal[..], &["--arms", "--penalty", "--unknowns", "rotation-vectors"]].concat();
        // An element with slave nodes calls the same part for each of them.
        for wanted in [
            vec!["--filter", "slot.*"],
            vec!["--element", "isl21a_linear"],
            vec!["--element", "slot", "--penalty"],
            [&universal[..], &["--unknowns", "euler-parameters"]].concat(),
            all_together,
        ] {
            let bench = Bench::new();
            let out = bench.path("exported");
            let folder = ["--out", out.to_str().unwrap()];
            let checked = [&["export", "--lang", lang][..], &wanted, &folder, &["--check", "--samples", "20"]].concat();
            let ran = bench.run(&checked).exits(0).prints(&format!("ok  {program}: "));
            assert!(ran.stdout.contains(" 0 differ"), "{ran:#?}");
            // Something was compared.
            let said = ran.stdout.lines().find(|line| line.starts_with(&format!("ok  {program}"))).unwrap();
            let numbers: u64 = said.split(' ').find_map(|word| word.parse().ok()).unwrap();
            assert!(numbers > 1000, "{said}");
        }
    }
}

/// Newton's method in C squares its error with the exported element, and does not with a sign turned in what it assembles.
#[test]
fn a_double_cardan_shaft_in_c_converges_quadratically() {
    if !["cc", "make"].into_iter().all(is_here) {
        return;
    }
    let bench = Bench::new();
    let out = bench.path("exported");
    bench.run(&["export", "--lang", "c", "--element", "ujoint", "--out", out.to_str().unwrap()]).exits(0);
    let example = out.join("double_cardan.c");
    let text = std::fs::read_to_string(&example).unwrap();
    assert!(text.lines().count() <= 150 && text.lines().all(|line| line.len() <= 100));
    let runs = |text: &str| {
        std::fs::write(&example, text).unwrap();
        let made = Command::new("make").args(["--quiet", "double_cardan"]).current_dir(&out).output().unwrap();
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        Command::new(out.join("double_cardan")).output().unwrap()
    };
    let ran = runs(&text);
    let lines = String::from_utf8_lossy(&ran.stdout).lines().count();
    assert!(ran.status.success() && lines == 25, "{ran:?}");
    for (from, to) in [
        ("+= motion * stiffness", "-= motion * stiffness"),
        ("+= motion * by_multipliers", "-= motion * by_multipliers"),
        ("+= rows[", "-= rows["),
        ("-= motion * forces", "+= motion * forces"),
        ("= -residuals", "= residuals"),
        ("+= twice[i] * forces", "-= twice[i] * forces"),
    ] {
        assert!(text.contains(from), "{from}");
        let ran = runs(&text.replace(from, to));
        assert!(!ran.status.success(), "{from}: {ran:?}");
    }
}

/// The times of Rust are given, those of C are measured; no time is judged.
#[test]
#[cfg(unix)]
fn times_of_c_and_of_rust_are_printed_with_their_ratio() {
    const RUST: [(&str, f64); 2] = [("slot.contact_force", 8.0), ("coulomb.yield", 0.5)];
    if !["cc", "make"].into_iter().all(is_here) {
        return;
    }
    let mut report = reference();
    for measured in report["formulas"].as_array_mut().unwrap() {
        let time = RUST.iter().find(|(id, _)| measured["formula"] == *id).map_or(1e6, |(_, time)| *time);
        let ways = measured["methods"].as_array_mut().unwrap().iter_mut();
        for way in ways.filter(|way| way["jacobian"]["time"].is_object()) {
            // The other methods take longer.
            way["jacobian"]["time"]["median"] = if way["id"] == "checked" { time } else { 1e6 }.into();
        }
    }
    let bench = Bench::new();
    let out = bench.path("exported");
    let wanted = ["--filter", "{slot.contact_force,coulomb.yield}", "--out", out.to_str().unwrap()];
    let ran = bench.run_measured(&report, 0, &[&["export", "--lang", "c", "--speed"][..], &wanted].concat()).exits(0);
    let (_, table) = ran.stdout.split_once("formula   ").expect("there is a table");
    let lines: Vec<Vec<_>> = table.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
    let (last, rows) = lines.split_last().unwrap();
    let mut ids: Vec<_> = rows.iter().map(|row| row[0]).collect();
    ids.sort_unstable();
    assert_eq!(ids, ["coulomb.yield", "slot.contact_force"]);
    let mut ratios = Vec::new();
    for row in rows {
        let [c, rust, ratio] = [1, 2, 3].map(|k| row[k].parse::<f64>().unwrap());
        assert!(c > 0.0 && ratio > 0.0, "{row:?}");
        assert_eq!(RUST.iter().find(|(id, _)| *id == row[0]).unwrap().1, rust);
        // To the precision of the printed digits.
        assert!((ratio * rust - c).abs() <= 0.05 + 0.005 * rust + 1e-9, "{row:?}");
        ratios.push(ratio);
    }
    assert!(ratios[0] >= ratios[1], "{table}");
    let [fewest, most] = [f64::lt, f64::le].map(|is| ratios.iter().filter(|ratio| is(ratio, &1.15)).count());
    let within: usize = last[0].parse().unwrap();
    assert!(fewest <= within && within <= most, "{table}");
    assert_eq!(last[1..6], ["of", "2", "at", "most", "1.15;"]);
    let mean: f64 = last[8].parse().unwrap();
    assert!(ratios[1] <= mean && mean <= ratios[0], "{table}");
}

#[test]
fn only_c_is_timed() {
    let bench = Bench::new();
    let out = bench.path("exported");
    let wanted = ["--filter", "slot.contact_force", "--out", out.to_str().unwrap()];
    let ran = bench.run(&[&["export", "--lang", "js", "--speed"][..], &wanted].concat()).exits(1);
    ran.says("--speed takes the time of C: --lang c");
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

/// Changes of exported files are reviewed once, by their author: branches, functions, a search, programs in parts, user routines.
#[test]
fn every_file_is_as_it_was_accepted() {
    const FORMULAS: &str = "{coulomb.return_map,interaction.pressure_exponential,universal.angles,slide_line.closest_parabolic,\
                            slider.geometric_stiffness,slot.friction}";
    let of = ["c", "fortran", "js", "numpy", "fpcore"].map(|lang| (lang, vec!["--lang", lang, "--filter", FORMULAS]));
    let shells = [
        ("element in c", vec!["--lang", "c", "--element", "slot_2d"]),
        ("element in fortran", vec!["--lang", "fortran", "--element", "slot_2d"]),
        ("element in js", vec!["--lang", "js", "--element", "slot_2d"]),
        ("element in numpy", vec!["--lang", "numpy", "--element", "slot_2d"]),
        ("uel", vec!["--shell", "uel", "--element", "slot"]),
        ("uels in fixed form", vec!["--shell", "uel", "--element", "universal", "--element", "slider_2d", "--fixed"]),
        ("fric", vec!["--shell", "fric"]),
        ("mpc", vec!["--shell", "mpc", "--fixed"]),
        ("umpc_user", vec!["--shell", "umpc-user"]),
    ];
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

/// Initial drivers that call a user's own code or, as an example, the exported code.
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
