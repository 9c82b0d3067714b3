//! `cargo xtask mutate` on a crate of a few lines.

use crate::common::Bench;
use std::fs;
use std::process::Command;

const LIST: &str = "\
files = [\"src/**\"]
[[fault]]
id = \"sign\"
file = \"src/lib.rs\"
find = \"x + 1\"
put = \"x - 1\"
";
const UNASKED: &str = "\
[[fault]]
id = \"unasked\"
file = \"src/lib.rs\"
find = \"x + 2\"
put = \"x - 2\"
";

/// A crate with a test for one function of two, and this list of faults.
fn tiny(list: &str) -> Bench {
    let bench = Bench::with(&[]);
    let source = "pub fn next(x: i64) -> i64 {\n    x + 1\n}\n\npub fn after(x: i64) -> i64 {\n    x + 2\n}\n\n\
                  #[test]\nfn test() {\n    assert_eq!(next(2), 3);\n}\n";
    let manifest = "[package]\nname = \"tiny\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n";
    for (file, text) in [
        ("Cargo.toml", manifest),
        ("src/lib.rs", source),
        ("tests/faults/sums.toml", list),
        (".gitignore", "target/\n"),
    ] {
        fs::create_dir_all(bench.path(file).parent().unwrap()).unwrap();
        fs::write(bench.path(file), text).unwrap();
    }
    assert!(Command::new("git").args(["init", "--quiet"]).current_dir(bench.path("")).status().unwrap().success());
    bench
}

#[test]
fn a_list_builds_nothing_and_an_area_must_be_there() {
    let bench = tiny(LIST);
    let other = "files = [\"other/**\"]\n";
    for name in ["zeros", "roots"] {
        fs::write(bench.path(&format!("tests/faults/{name}.toml")), other).unwrap();
    }
    bench.run(&["mutate", "--area", "sum", "--list"]).bad_usage("there is no area sum; there are roots, sums, zeros");
    let ran = bench.run(&["mutate", "--area", "sums", "--list", "--made", "0"]).exits(0);
    assert_eq!(ran.stdout, "sums sums.sign: src/lib.rs:2: `x + 1` → `x - 1`\n");
    assert!(!bench.path("target/mutate/target").exists());
}

#[test]
fn a_test_that_fails_without_a_fault_tells_nothing() {
    let bench = tiny(LIST);
    let source = fs::read_to_string(bench.path("src/lib.rs")).unwrap();
    fs::write(bench.path("src/lib.rs"), source.replace("next(2), 3", "next(2), 4")).unwrap();
    let ran = bench
        .run(&["mutate", "--made", "0"])
        .exits(1)
        .says("1 fault planted, 1 to be tried")
        .says("tiny: 1 tests, ")
        .says("tiny test fails or takes too long without a fault, so it tells nothing")
        .says("1/1 sums.sign survived, no test comes there");
    ran.prints("survived: sums.sign");
}

#[test]
fn the_exit_code_says_whether_enough_is_noticed_and_the_book_gets_what_is_kept() {
    let all = ["mutate", "--made", "0", "--grace", "5"];
    let well = tiny(LIST);
    well.run(&all).exits(0).prints("100.0% sums");
    assert!(!well.path("tests/data/faults.json").exists());
    let badly = tiny(&(LIST.to_owned() + UNASKED));
    badly.run(&[&all[..], &["--keep"]].concat()).exits(1).prints("survived: sums.unasked");
    let kept = fs::read_to_string(badly.path("tests/data/faults.json")).unwrap();
    assert!(kept.contains("those of every package, 600 s a fault, seed 0") && kept.contains("sums.unasked"), "{kept}");
}
