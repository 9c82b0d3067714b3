//! A crate of a few lines, whose tests miss two faults.

use super::*;
use crate::console::plain;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

const MANIFEST: &str = "[package]\nname = \"tiny\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n";
const SOURCE: &str = "\
/// A sum of squares, unless it is too large.
pub fn squares(x: &[f64], largest: f64) -> Option<f64> {
    let mut sum = 0.0;
    for x in x {
        sum += x * x;
    }
    if sum > largest { None } else { Some(sum) }
}

/// Counts down.
pub fn steps(mut from: u32) -> u64 {
    let mut steps = 0;
    while from > 0 {
        from -= 1;
        steps += 1;
    }
    steps
}

/// Both of a pair.
pub fn both(x: f64) -> usize {
    let pair = [x; 2];
    pair.len()
}

/// Nobody asks.
pub fn unasked(x: f64) -> f64 {
    x - 1.5
}

#[cfg(test)]
mod tests {
    #[test]
    fn squares() {
        assert_eq!(super::squares(&[1.0, 2.0], 9.0), Some(5.0));
        assert_eq!(super::squares(&[1.0, 4.0], 9.0), None);
    }

    #[test]
    fn steps() {
        assert_eq!(super::steps(3), 3);
    }

    #[test]
    fn both() {
        assert_eq!(super::both(1.0), 2);
    }
}
";
const LIST: &str = "\
files = [\"src/**\"]
[[fault]]
id = \"sign\"
file = \"src/lib.rs\"
find = \"sum += x * x\"
put = \"sum -= x * x\"
[[fault]]
id = \"equal\"
file = \"src/lib.rs\"
find = \"sum > largest\"
put = \"sum >= largest\"
[[fault]]
id = \"endless\"
file = \"src/lib.rs\"
find = \"from -= 1;\"
put = \"\"
[[fault]]
id = \"name\"
file = \"src/lib.rs\"
after = \"mut from\"
find = \"let mut steps = 0;\"
put = \"let mut steps = 0_u64;\"
equivalent = \"the type is the same\"
[[fault]]
id = \"three\"
file = \"src/lib.rs\"
find = \"[x; 2]\"
put = \"[x; 3]\"
[[fault]]
id = \"unasked\"
file = \"src/lib.rs\"
find = \"1.5\"
put = \"1.6\"
";

fn every() -> Programs {
    Programs { package: None, test: Vec::new() }
}

fn arguments() -> Arguments {
    Arguments {
        area: Vec::new(),
        sample: None,
        fault: None,
        made: 3,
        seed: 0,
        jobs: 2,
        grace: 5,
        enough: 60,
        programs: every(),
        longest: 900,
        again: false,
        list: false,
        keep: false,
    }
}

fn tiny() -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    for (file, text) in [
        ("Cargo.toml", MANIFEST),
        ("src/lib.rs", SOURCE),
        ("tests/faults/sums.toml", LIST),
        (".gitignore", "target/\n"),
    ] {
        let path = root.path().join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let git = Command::new("git").args(["init", "--quiet"]).current_dir(root.path()).status().unwrap();
    assert!(git.success());
    root
}

#[test]
fn what_tests_miss_survives_and_the_rest_does_not() {
    let root = tiny();
    let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
    let areas = area::read(root.path()).unwrap();
    let choice = Choice::read(&areas, &bench.sources().unwrap(), 0).unwrap();
    let judged = judge_all(&bench, &choice, &arguments()).unwrap();
    let of =
        |id: &str| judged.iter().find(|one| one.id == format!("sums.{id}")).map(|one| one.verdict.clone()).unwrap();
    assert_eq!(of("sign"), Verdict::Killed("tiny: tests::squares".into()));
    assert_eq!(of("equal"), Verdict::Survived(1));
    assert_eq!(of("endless"), Verdict::Stopped("tiny: tests::steps".into()));
    assert_eq!(of("name"), Verdict::Equivalent("the type is the same".into()));
    // The compiler refuses it as an expression, and takes it as a block.
    assert_eq!(of("three"), Verdict::Killed("tiny: tests::both".into()));
    assert_eq!(of("unasked"), Verdict::Survived(0));
    assert_eq!(judged.len(), 9);
    let text = table::text(&judged);
    assert!(
        text.contains("survived: sums.equal\n    src/lib.rs:7: `sum > largest` → `sum >= largest`; 1 test comes there"),
        "{text}"
    );
    assert!(text.contains(" 75.0% sums  too few"), "{text}");
    // What was not noticed is tried again, with a test that is new, and what was noticed is not.
    let tests = fs::read_to_string(root.path().join("src/lib.rs")).unwrap().replace(
        "    #[test]\n    fn steps() {",
        "    #[test]\n    fn at_most() {\n        assert_eq!(super::squares(&[3.0], 9.0), Some(9.0));\n    }\n\n    #[test]\n    fn steps() {",
    );
    let source = tests.replace("assert_eq!(super::steps(3), 3);", "");
    fs::write(root.path().join("src/lib.rs"), &source).unwrap();
    let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
    let choice = Choice::read(&areas, &bench.sources().unwrap(), 0).unwrap();
    let again = judge_all(&bench, &choice, &Arguments { again: true, ..arguments() }).unwrap();
    let changed: Vec<_> =
        again.iter().filter(|one| judged.iter().all(|old| old.verdict != one.verdict || old.id != one.id)).collect();
    assert_eq!(changed.iter().map(|one| &*one.id).collect::<Vec<_>>(), ["sums.equal"]);
    assert_eq!(changed[0].verdict, Verdict::Killed("tiny: tests::at_most".into()));
    assert_eq!(earlier(&bench), again);
    // A run of one fault leaves the others as they were found.
    let one = Arguments { fault: Some("sums.unasked".into()), ..arguments() };
    assert_eq!(judge_all(&bench, &choice, &one).unwrap().len(), 1);
    let sorted = |mut all: Vec<Judged>| {
        all.sort_by(|a, b| a.id.cmp(&b.id));
        all
    };
    assert_eq!(sorted(earlier(&bench)), sorted(again));
    assert_eq!(arguments().in_words(), "those of every package, 60 s a fault, seed 0");
    // Tests that read sources see them as they are.
    assert_eq!(fs::read_to_string(bench.tree().join("src/lib.rs")).unwrap(), source);
}

#[test]
fn a_list_that_does_not_fit_is_refused() {
    let root = tiny();
    let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
    let refused = |list: &str| {
        fs::write(root.path().join("tests/faults/sums.toml"), list).unwrap();
        let areas = area::read(root.path()).unwrap();
        format!("{:#}", Choice::read(&areas, &bench.sources().unwrap(), 0).err().unwrap())
    };
    let fault =
        |rest: &str| format!("files = [\"src/**\"]\n[[fault]]\nid = \"a\"\nfile = \"src/lib.rs\"\nput = \"\"\n{rest}");
    assert!(refused(&fault("find = \"there is none\"")).contains("sums: a: src/lib.rs has no \"there is none\""));
    assert!(refused(&fault("find = \"steps += 1\"\nafter = \"steps\"")).contains("times: `after` says which"));
    assert!(refused(&fault("find = \"steps\"")).contains("times: `after` says which"));
    assert!(refused(&fault("find = \"super::squares(&[1.0, 2.0]\"")).contains("no function has it"));
    assert!(refused(&fault("find = \"1.5\"").replace("src/**", "other/**")).contains("is not of this area"));
}

#[test]
fn faults_have_names_of_their_own() {
    let root = tiny();
    let source = "pub fn near(x: f64) -> bool {\n    x.abs().sqrt() < 1.0 && is_near(x)\n}\n";
    fs::write(root.path().join("src/lib.rs"), source).unwrap();
    let list = "files = [\"src/**\"]\n[[harmless]]\nfile = \"src/lib.rs\"\nline = \"x.abs().sqrt() < 1.0 && is_near(x)\"\n\
                was = \"<\"\nwhy = \"it is a matter of taste\"\n";
    fs::write(root.path().join("tests/faults/sums.toml"), list).unwrap();
    let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
    let areas = area::read(root.path()).unwrap();
    let choice = Choice::read(&areas, &bench.sources().unwrap(), 0).unwrap();
    let first = |seed| Choice::read(&areas, &bench.sources().unwrap(), seed).unwrap().take(1, &BTreeSet::new());
    let firsts: BTreeSet<_> = (0..20).flat_map(first).map(|fault| fault.id).collect();
    assert!(firsts.len() > 3, "another seed takes others: {firsts:?}");
    let faults = choice.take(100, &BTreeSet::new());
    let harmless: Vec<_> = faults.iter().filter(|fault| fault.equivalent.is_some()).map(|fault| &*fault.was).collect();
    assert_eq!(harmless, ["<"]);
    let mut names: Vec<_> = faults.into_iter().map(|fault| fault.id).collect();
    let all = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), all);
    assert!(all > 5, "{names:?}");
}

#[test]
fn the_lists_of_this_project_fit_its_sources() {
    let (root, target) = (Path::new(env!("CARGO_MANIFEST_DIR")).join(".."), tempfile::tempdir().unwrap());
    let bench = Bench::new(&root, target.path().to_owned()).unwrap();
    let areas = area::read(&root).unwrap();
    let choice = Choice::read(&areas, &bench.sources().unwrap(), 0).unwrap();
    let faults = choice.take(usize::MAX, &BTreeSet::new());
    let names: BTreeSet<_> = faults.iter().map(|fault| &fault.id).collect();
    assert_eq!(names.len(), faults.len());
}

/// What git does not know is gone from the copy, but not what was built there.
#[test]
fn the_copy_has_the_files_of_the_project_and_no_others() {
    let root = tiny();
    let folder = root.path().join("target/mutate");
    let old = ["src/old.rs", "target/kept", "Cargo.lock"].map(|file| folder.join("tree").join(file));
    for file in &old {
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, "").unwrap();
    }
    Bench::new(root.path(), folder.clone()).unwrap();
    assert_eq!(old.map(|file| file.exists()), [false, true, true]);
    for file in ["Cargo.toml", "src/lib.rs", "tests/faults/sums.toml", ".gitignore"] {
        assert_eq!(fs::read(folder.join("tree").join(file)).unwrap(), fs::read(root.path().join(file)).unwrap());
    }
}

/// The switch is a dependency of the workspace's head and of every package that a fault is in, and of no other.
#[test]
fn packages_with_faults_and_the_head_get_the_switch() {
    let root = tiny();
    let package = |name: &str| format!("[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n");
    for (file, text) in
        [("with/Cargo.toml", package("with")), ("with/src/lib.rs", "pub fn two() -> u32 {\n    2\n}\n".into())]
    {
        for folder in ["", "with/inner/", "without/"] {
            let file = if folder.is_empty() { file.to_owned() } else { file.replace("with/", folder) };
            fs::create_dir_all(root.path().join(&file).parent().unwrap()).unwrap();
            fs::write(root.path().join(&file), &text).unwrap();
        }
    }
    fs::write(root.path().join("tests/faults/sums.toml"), "files = [\"with/inner/**\", \"src/**\"]\n").unwrap();
    let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
    let sources = bench.sources().unwrap();
    let choice = Choice::read(&area::read(root.path()).unwrap(), &sources, 0).unwrap();
    let faults: Vec<_> = choice.take(9, &BTreeSet::new()).into_iter().map(|fault| (fault, 0)).collect();
    let files: BTreeSet<_> = faults.iter().map(|(fault, _)| fault.file.as_str()).collect();
    assert!(files.iter().eq(&["src/lib.rs", "with/inner/src/lib.rs"]), "{files:?}");
    bench.plant(&faults, &sources).unwrap();
    let manifest = |folder: &str| fs::read_to_string(bench.tree().join(folder).join("Cargo.toml")).unwrap();
    let switch = |up: &str| format!("\n[dependencies]\nplanted = {{ path = \"{up}planted\" }}\n");
    assert!(manifest("").contains(&switch("../")) && manifest("").contains("[profile.dev.package.planted]"));
    assert!(manifest("with/inner").ends_with(&switch("../../../")), "{}", manifest("with/inner"));
    assert_eq!(["with", "without"].map(manifest), [package("with"), package("with")]);
    for file in [".gitignore", "without/src/lib.rs"] {
        let [copy, original] = [bench.tree(), root.path().to_owned()].map(|at| fs::read(at.join(file)).unwrap());
        assert_eq!(copy, original, "{file}");
    }
}

#[test]
fn a_line_of_the_list_says_what_is_changed_and_what_nothing_can_notice() {
    let fault = Fault {
        id: "sums.sign".into(),
        area: "sums".into(),
        file: "src/lib.rs".into(),
        was: "+".into(),
        becomes: "-".into(),
        ..nameless()
    };
    let harmless = Fault { equivalent: Some("nobody asks".into()), ..fault.clone() };
    assert_eq!(line(&fault), "sums sums.sign: src/lib.rs:1: `+` → `-`\n");
    assert_eq!(line(&harmless), "sums sums.sign: src/lib.rs:1: `+` → `-` (nothing can notice it: nobody asks)\n");
}

#[test]
fn enough_must_be_noticed_in_every_area() {
    let judged = |area: &str, verdict| Judged::new(&Fault { area: area.into(), ..nameless() }, verdict);
    let well = judged("sums", Verdict::Killed("tiny: tests::squares".into()));
    let badly = judged("roots", Verdict::Survived(1));
    assert!(is_enough(&[]) && is_enough(std::slice::from_ref(&well)) && !is_enough(&[well, badly]));
}

fn nameless() -> Fault {
    let (id, area, file) = Default::default();
    let (was, becomes) = Default::default();
    Fault { id, area, file, line: 1, was, becomes, equivalent: None, places: Vec::new() }
}

#[test]
fn a_sample_has_as_many_faults_as_are_asked_for() {
    let faults = vec![nameless(); 5];
    let of = |sample| wanted(&Arguments { sample, ..arguments() }, &faults).unwrap().len();
    assert_eq!([of(None), of(Some(2)), of(Some(9))], [5, 2, 5]);
    // Which they are is drawn, by the seed.
    let faults: Vec<_> = (0..9).map(|k| Fault { was: k.to_string(), ..nameless() }).collect();
    let drawn = |seed| -> Vec<usize> {
        let arguments = Arguments { sample: Some(3), seed, ..arguments() };
        wanted(&arguments, &faults).unwrap().into_iter().map(|(number, _)| number).collect()
    };
    assert_eq!(drawn(1), drawn(1));
    assert!((2..9).any(|seed| drawn(seed) != drawn(1)) && (1..9).all(|seed| drawn(seed).len() == 3));
}

#[test]
fn a_name_that_no_fault_has_is_an_error() {
    let named = |fault: &str| wanted(&Arguments { fault: Some(fault.into()), ..arguments() }, &[nameless()]);
    assert_eq!(named("").unwrap().len(), 1);
    let error = named("norm").err().unwrap();
    assert_eq!(error.to_string(), "no fault is like that; --list without --fault and --sample shows all");
    assert!(error.is::<Usage>());
}

#[test]
fn progress_counts_what_was_tried_and_says_what_came_of_it() {
    let progress = Progress { done: AtomicUsize::default(), of: 5 };
    let verdicts = [
        Verdict::Killed("tiny: tests::squares".into()),
        Verdict::Stopped("tiny: tests::steps".into()),
        Verdict::Survived(0),
        Verdict::Survived(2),
        Verdict::Equivalent("it is a matter of taste".into()),
    ];
    let fault = Fault { id: "sums.sign".into(), ..nameless() };
    let said = verdicts.map(|verdict| plain(&progress.after(&fault, &verdict)));
    let expected = [
        "1/5 sums.sign killed by tiny: tests::squares",
        "2/5 sums.sign stopped in tiny: tests::steps",
        "3/5 sums.sign survived, no test comes there",
        "4/5 sums.sign survived 2 tests",
        "5/5 sums.sign equivalent",
    ];
    assert_eq!(said, expected);
}

/// `+` can be no `-` between texts, whatever is there twice; a longer body that `-` stands in is refused as well.
#[test]
fn what_the_compiler_refuses_everywhere_is_given_up() {
    let root = tiny();
    fs::write(root.path().join("src/lib.rs"), "pub fn loud(word: String) -> String {\n    word + \"!\"\n}\n").unwrap();
    let built = |list: &str| {
        fs::write(root.path().join("tests/faults/sums.toml"), format!("files = [\"src/**\"]\n{list}")).unwrap();
        let bench = Bench::new(root.path(), root.path().join("target/mutate")).unwrap();
        let choice = Choice::read(&area::read(root.path()).unwrap(), &bench.sources().unwrap(), 0).unwrap();
        let of = |faults: Vec<Fault>| faults.into_iter().map(|fault| fault.becomes).collect::<Vec<_>>();
        let all = of(choice.take(9, &BTreeSet::new()));
        let built = build::build(&bench, &choice, 9, &every()).map(|built| of(built.faults));
        (all, built, of(choice.take(9, &build::refused(&bench))))
    };
    let (all, taken, left) = built("");
    assert_eq!(
        (all.len(), taken.unwrap(), left),
        (2, vec!["String::new()".to_owned()], vec!["String::new()".to_owned()])
    );
    let (_, refused, _) =
        built("[[fault]]\nid = \"word\"\nfile = \"src/lib.rs\"\nfind = \"word +\"\nput = \"word *\"\n");
    assert_eq!(refused.unwrap_err().to_string(), "the compiler refuses faults of the lists: sums.word");
}

#[test]
fn a_fault_within_another_is_in_what_was_there() {
    let text = "fn f() { a + b * c }";
    let place = |range: std::ops::Range<usize>, put: &str| fault::Place {
        range,
        text: put.into(),
        shape: fault::Shape::Expression,
    };
    let fault = |places| Fault { places, ..nameless() };
    let [outer, inner] = [fault(vec![place(9..18, "a - b * c")]), fault(vec![place(13..18, "b / c")])];
    let planted = plant::plant(text, &[(0, &outer, 0), (1, &inner, 0)]);
    let expected =
        "fn f() { (if ::planted::at(0) { a - b * c } else { a + (if ::planted::at(1) { b / c } else { b * c }) }) }";
    assert_eq!(planted.text, expected);
    let at = |part: &str| planted.text.find(part).map(|start| planted.blamed(&(start..start + part.len()))).unwrap();
    assert_eq!(at("a - b"), [0]);
    assert_eq!(at("b / c"), [1]);
    assert_eq!(at("(if ::planted::at(1) { b / c } else { b * c })"), [1]);
    assert_eq!(at("a + (if"), [0]);
    assert_eq!(at(expected), [1, 0]);
}

#[test]
fn every_rule_makes_its_fault_where_it_can_and_nowhere_else() {
    let source = "
fn f(x: f64, all: &[f64]) -> bool {
    let whole = -x.abs() * 2.0 + 1e-9;
    if is_far(x) { note(x); }
    bar.inc(1); let still = true;
    let near = match x { _ if is_near(x) => 3, _ => all.iter().rev().map(|y| y - x).len() };
    all.iter().any(|y| *y > whole) || !done && near != 4
}
trait Far {
    fn is_far(&self) -> usize { if self.no() { 6 } else if self.yes() { 7 } else { 8 } }
    fn near(&self) -> f32;
}
impl Far for f64 {
    fn yes(&self) -> Two { let Some(x) = self else { return go(9) }; x }
    const fn fixed() -> u32 { 10 }
    #[test]
    fn tested() -> u32 { 11 }
    #[doctest]
    fn kept() -> Two { [self; 12] }
}
#[cfg(test)]
mod tests { fn g() -> bool { 1 == 2 } }
#[cfg(doctest)]
mod examples { fn g() -> bool { 1 == 2 } }
#[cfg(unix)]
mod here { fn g() -> Two { 13 } }
#[cfg(not(unix))]
fn there() -> u32 { 14 }
fn bound(x: Two) -> Two { if let Some(y) = x && y > 15.5 { y } else { z } }
";
    let sites = sites::Sites::read(source).unwrap();
    let places: Vec<_> = sites.places.iter().map(|(range, _)| &source[range.clone()]).collect();
    for part in ["-x.abs() * 2.0", "note(x)", "*y > whole", "go(9)", "{ 13 }"] {
        assert!(places.contains(&part), "{part} is not in {places:?}");
    }
    // What can be written to stands for a place, and not for a value.
    assert!(!places.iter().any(|part| ["x", "self", "*y"].contains(part)), "{places:?}");
    let made = sites.rules.made;
    let mut made: Vec<_> = made.iter().map(|made| (made.at, made.was.as_str(), made.becomes.as_str())).collect();
    made.sort_unstable();
    let (bodies, parts): (Vec<_>, Vec<_>) = made.into_iter().partition(|(_, was, _)| was.starts_with('{'));
    assert_eq!(bodies.iter().map(|(_, _, becomes)| *becomes).collect::<Vec<_>>(), ["true", "false", "0"]);
    let shown: Vec<_> = parts.iter().map(|((line, _), was, becomes)| format!("{line}: {was} → {becomes}")).collect();
    let expected = [
        "3: -x.abs() → x.abs()",
        "3: x.abs() → x",
        "3: * → /",
        "3: 2.0 → 3.0",
        "3: + → -",
        "4: is_far(x) → !(is_far(x))",
        "4: note(x) → ",
        "5: 1 → 2",
        "5: true → false",
        "6: 3 → 4",
        "6: all.iter().rev() → all.iter()",
        "6: - → +",
        "7: any → all",
        "7: > → >=",
        "7: || → &&",
        "7: !done → done",
        "7: && → ||",
        "7: != → ==",
        "7: 4 → 5",
        "10: self.no() → !(self.no())",
        "10: 6 → 7",
        "10: self.yes() → !(self.yes())",
        "10: 7 → 8",
        "10: 8 → 9",
        "14: 9 → 10",
        "26: 13 → 14",
        "29: > → >=",
        "29: 15.5 → 16.5",
    ];
    assert_eq!(shown, expected);
}
