//! `cargo xtask new`: what it writes, where, and what it rejects.

use crate::common::Bench;
use std::fs;

const PARTS: [&str; 3] = ["src", "book/src", "tests/python/oracle"];

#[test]
fn a_skeleton_is_written_in_the_places_of_its_neighbours() {
    let bench = Bench::with(&PARTS);
    let ran = bench.run(&["new", "slot.made_power"]).quiet();
    let changed =
        ["src/connector/slot.rs", "src/catalog/list.rs", "book/src/slot.md"].map(|file| format!("changed {file}\n"));
    let written = ["src/connector/slot/made_power.rs", "src/connector/slot/made_power/proof.rs"]
        .map(|file| format!("wrote   {file}\n"));
    let reported = written.concat() + &changed.concat();
    assert!(ran.stdout.starts_with(&reported), "{ran:#?}");
    ran.prints("a case worked by hand")
        .prints("an independent implementation")
        .prints("golden --filter slot.made_power");
    for (file, expected) in [
        ("src/connector/slot/made_power.rs", "\n#[cfg(feature = \"verify\")]\nmod proof;\n\nuse crate::fields;\n"),
        ("src/connector/slot/made_power.rs", "Spec::new(\"slot.made_power\", \"\", Document::SLOT.ours("),
        ("src/connector/slot/made_power/proof.rs", "impl Proved for MadePower {"),
        ("src/connector/slot.rs", "pub use made_power::{MadePower, MadePowerInputs, MadePowerOutputs};\n"),
        ("src/catalog/list.rs", "    &slot::Stop,\n    &slot::MadePower,\n"),
        ("book/src/slot.md", "{{#formula slot.friction}}\n\n{{#formula slot.made_power}}\n"),
    ] {
        let text = fs::read_to_string(bench.path(file)).unwrap();
        assert!(text.contains(expected), "{expected:?} is not in {file}:\n{text}");
        let is_parsed = !file.starts_with("src") || syn::parse_file(&text).is_ok();
        assert!(is_parsed, "{file} is not Rust:\n{text}");
    }
    assert!(!bench.path("book/permalinks.txt").exists(), "there is no list, and none is made");
    // On a second run, nothing is overwritten.
    bench.run(&["new", "slot.made_power"]).exits(1).says("src/connector/slot/made_power.rs is there already");
}

#[test]
fn a_new_entry_gets_an_address_where_they_are_listed() {
    let bench = Bench::with(&[&PARTS[..], &["book/permalinks.txt"]].concat());
    let before = fs::read_to_string(bench.path("book/permalinks.txt")).unwrap();
    bench.run(&["new", "slot.made_power"]).quiet().prints("changed book/permalinks.txt\n");
    let after = fs::read_to_string(bench.path("book/permalinks.txt")).unwrap();
    assert_eq!(after, format!("{}\nslot.made_power\n", before.trim_end()));
}

#[test]
fn what_cannot_be_added_is_refused_with_advice_and_nothing_is_written() {
    let bench = Bench::with(&PARTS);
    bench.run(&["new", "slot.friction"]).bad_usage("there is a formula slot.friction already");
    for id in ["slot", "Slot.power", "slot.Power", "slot.", "slot.a-b"] {
        bench.run(&["new", id]).bad_usage("is no identifier; it is written family.name");
    }
    bench.run(&["new", "spring.energy"]).exits(1).says("there is no module spring.rs in src; write it");
    assert!(!bench.path("src/spring").exists());
}
