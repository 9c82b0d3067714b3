//! `cargo xtask golden`: what it finds, writes, and leaves alone.

use crate::common::{self, Bench};
use jointproof::catalog::CATALOG;
use jointproof::formula::proof::Flag;
use jointproof::toolkit::verify::golden::File;
use std::collections::BTreeMap;
use std::fs;

const ID: &str = "slot.contact_force";
const NAME: &str = "slot.contact_force.json";
const CHECK: [&str; 4] = ["golden", "--check", "--filter", ID];
const WRITE: [&str; 3] = ["golden", "--filter", ID];

/// A bench with one formula's golden file and the schema.
fn bench() -> Bench {
    Bench::with(&["golden/schema.json", "golden/slot.contact_force.json"])
}

fn parse(bench: &Bench) -> File {
    File::parse(&fs::read_to_string(bench.path("golden").join(NAME)).unwrap()).unwrap()
}

/// Changes the file as if by hand.
fn plant(bench: &Bench, change: impl FnOnce(&mut File)) {
    let mut file = parse(bench);
    change(&mut file);
    fs::write(bench.path("golden").join(NAME), file.render().unwrap()).unwrap();
}

#[test]
fn a_wrong_last_bit_is_found_and_nothing_is_written() {
    let bench = bench();
    let (mut case, mut right, mut wrong) = (String::new(), 0.0, 0.0);
    plant(&bench, |file| {
        let record = file.cases.iter_mut().find(|case| case.id == "random-1").unwrap();
        case.clone_from(&record.id);
        let fc = record.out.as_mut().unwrap().get_mut("fc").unwrap();
        right = fc.as_f64().unwrap();
        wrong = f64::next_up(right);
        *fc = wrong.into();
    });
    let before = bench.files("golden");
    bench
        .run(&CHECK)
        .exits(1)
        .prints(&format!("golden/{NAME}: 1 difference\n"))
        .prints(&format!("case {case} out.fc  (1 ulp apart)\n    - {wrong:?}\n    + {right:?}\n"))
        .prints("off 1 formula, ")
        .says("cargo xtask golden");
    assert_eq!(bench.files("golden"), before);
}

#[test]
fn the_first_golden_file_makes_the_folder() {
    let bench = Bench::with(&[]);
    bench.run(&WRITE).exits(0);
    assert!(bench.path("golden").join(NAME).exists());
    bench.run(&CHECK).exits(0);
}

#[test]
fn another_project_gets_as_many_random_cases_as_it_wants() {
    let bench = bench();
    let out = bench.path("cases");
    let with_random = ["golden", "--filter", ID, "--random", "40"];
    bench.run(&[&with_random[..], &["--out", out.to_str().unwrap()]].concat()).exits(0).prints("1 formula, ");
    let wanted = File::parse(&fs::read_to_string(out.join(NAME)).unwrap()).unwrap();
    let random = |file: &File| file.cases.iter().filter(|case| case.flags.contains(&Flag::Random)).count();
    assert!(random(&wanted) == 40 && random(&parse(&bench)) < 40);
    // All committed files have the same number of random cases.
    bench.run(&with_random).exits(2).says("--out <FOLDER>");
}

#[test]
fn every_kind_of_difference_is_named() {
    type Change = fn(&mut File);
    let changes: [(Change, &str); 6] = [
        (|file| file.cases[0].jac = None, "case running jac\n    - null\n    + {"),
        (|file| drop(file.cases.remove(1)), "case plane\n    - absent\n    + present\n"),
        (|file| file.cases[1].id = "stranger".into(), "case stranger\n    - present\n    + absent\n"),
        (|file| file.cases[0].comment = "changed".into(), "case running comment\n    - \"changed\""),
        (|file| file.cases.swap(0, 1), "the cases agree, the description or the layout differs"),
        (|file| file.title = "Changed".into(), "the cases agree, the description or the layout differs"),
    ];
    for (change, expected) in changes {
        let bench = bench();
        plant(&bench, change);
        bench.run(&CHECK).exits(1).prints(expected);
    }
}

#[test]
fn a_file_that_is_missing_or_not_golden_is_named() {
    let bench = bench();
    fs::write(bench.path("golden").join(NAME), "{\"schema\": 1}").unwrap();
    bench.run(&CHECK).exits(1).prints("slot.contact_force.json is not a golden file: invalid type: integer `1`");
    fs::remove_file(bench.path("golden").join(NAME)).unwrap();
    bench.run(&CHECK).exits(1).prints("golden/slot.contact_force.json: No such file");
}

#[test]
fn a_schema_that_the_code_does_not_write_is_found_and_mended() {
    let bench = bench();
    fs::write(bench.path("golden/schema.json"), "{}").unwrap();
    bench.run(&CHECK).exits(1).prints("golden/schema.json is not the schema that the code writes");
    bench.run(&WRITE).quiet().prints("wrote golden/schema.json");
    bench.run(&CHECK).quiet();
}

#[test]
fn writing_mends_and_then_has_nothing_to_do() {
    let bench = bench();
    let good = bench.files("golden");
    plant(&bench, |file| file.cases[0].comment = "changed".into());
    let ran = bench.run(&WRITE).quiet();
    assert_eq!(ran.stdout.lines().next(), Some("wrote golden/slot.contact_force.json"));
    assert_eq!(ran.stdout.matches("wrote").count(), 1);
    let mended = bench.files("golden");
    assert_eq!(mended[NAME].0, good[NAME].0);
    assert_eq!(mended["schema.json"], good["schema.json"]);

    let again = bench.run(&WRITE).quiet();
    assert!(!again.stdout.contains("wrote"), "{again:#?}");
    assert_eq!(bench.files("golden"), mended);
}

/// The first formula of every family represents the others, whose files `golden --check` makes on all cores.
#[test]
fn files_are_the_same_to_the_byte_whatever_the_number_of_threads() {
    let mut first = BTreeMap::new();
    for id in CATALOG.iter().map(|formula| formula.spec().id) {
        first.entry(id.split('.').next()).or_insert(id);
    }
    let filter = format!("{{{}}}", first.values().copied().collect::<Vec<_>>().join(","));
    for threads in ["1", "2", "5"] {
        let bench = Bench::with(&[]);
        let mut command = bench.command(&["golden", "--filter", &filter]);
        let status = command.env("RAYON_NUM_THREADS", threads).output().unwrap().status;
        assert!(status.success());
        let files = bench.files("golden");
        assert_eq!(files.len(), first.len() + 1, "the schema and {filter}");
        for (name, (bytes, _)) in files {
            let committed = fs::read(common::repository().join("golden").join(&name)).unwrap();
            assert!(bytes == committed, "{name} with {threads} threads");
        }
    }
}

#[test]
fn a_file_is_replaced_and_not_overwritten() {
    let bench = bench();
    plant(&bench, |file| file.cases[0].comment = "changed".into());
    // A process that has the old file open still sees it whole.
    fs::hard_link(bench.path("golden").join(NAME), bench.path("old.json")).unwrap();
    let old = fs::read(bench.path("old.json")).unwrap();
    bench.run(&WRITE).quiet().prints("wrote");
    assert_eq!(fs::read(bench.path("old.json")).unwrap(), old);
    assert_ne!(fs::read(bench.path("golden").join(NAME)).unwrap(), old);
}

#[cfg(unix)]
#[test]
fn a_run_that_is_killed_while_it_writes_leaves_the_old_file_whole() {
    let bench = bench();
    plant(&bench, |file| file.cases[0].comment = "changed".into());
    let old = fs::read(bench.path("golden").join(NAME)).unwrap();
    // The system kills a process that writes more than this; the file is longer.
    let limited = bench.command(&WRITE);
    let mut shell = std::process::Command::new("sh");
    shell
        .args(["-c", "ulimit -c 0; ulimit -f 1; exec \"$@\"", "sh"])
        .arg(limited.get_program())
        .args(limited.get_args());
    for (variable, value) in limited.get_envs() {
        match value {
            Some(value) => shell.env(variable, value),
            None => shell.env_remove(variable),
        };
    }
    let ran = common::Ran::from(shell.output().unwrap());
    assert_eq!(ran.code, None, "{ran:#?}");
    assert_eq!(fs::read(bench.path("golden").join(NAME)).unwrap(), old);
    assert!(bench.files("golden").keys().any(|name| name.starts_with(".writing-")), "killed too early");

    // Leftovers are no obstacle.
    bench.run(&WRITE).quiet().prints("wrote golden/slot.contact_force.json");
    bench.run(&CHECK).quiet();
}
