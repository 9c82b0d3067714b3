//! `cargo xtask audit`: its formats, and points that are passed back.

use crate::common::Bench;
use jointproof::catalog::CATALOG;
use jointproof::toolkit::verify::golden::File;
use jointproof::toolkit::verify::{Audit, Claim, Deviation};

/// A formula whose audit takes no time.
const ID: &str = "slot.contact_force";

/// The audit of one formula as JSON.
fn audit(arguments: &[&str]) -> Audit {
    let ran = Bench::new().run(&[&["audit", "--format", "json", "--filter", ID], arguments].concat()).quiet();
    let mut audits: Vec<Audit> = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(audits.len(), 1);
    audits.remove(0)
}

#[test]
fn json_holds_what_was_asked_for() {
    let audit = audit(&["--samples", "17", "--seed", "5"]);
    assert_eq!((audit.formula.as_str(), audit.random_points, audit.seed), (ID, 17, 5));
    assert!(audit.passed());
}

#[test]
fn shares_make_the_whole_and_files_of_something_else_are_named() {
    let bench = Bench::new();
    let of = |more: &[&str]| bench.run(&[&["audit", "--filter", "{slot.contact_force,join.rows}"], more].concat());
    let shares = ["1/2", "2/2"].map(|shard| {
        let file = bench.path(&shard.replace('/', "of"));
        std::fs::write(&file, of(&["--samples", "9", "--seed", "5", "--shard", shard]).quiet().stdout).unwrap();
        file.to_str().unwrap().to_owned()
    });
    let whole = of(&["--samples", "9", "--seed", "5", "--format", "json"]).quiet().stdout;
    let merge = |files: &[&str]| of(&[&["--format", "json", "--merge"], files].concat());
    let [first, second] = shares.each_ref().map(String::as_str);
    assert_eq!(merge(&[second, first]).quiet().stdout, whole, "in any order");
    merge(&[first]).bad_usage("");
    let other = bench.path("other");
    std::fs::write(&other, "[1]").unwrap();
    merge(&[other.to_str().unwrap()]).exits(1).says("other is not what `audit --shard` prints");
    std::fs::write(&other, "[]").unwrap();
    merge(&[other.to_str().unwrap()]).bad_usage("--merge: no share of a formula that was asked for is in these files");
}

#[test]
fn of_many_changes_the_first_are_listed() {
    let bench = Bench::with(&["golden"]);
    let path = bench.path(&format!("golden/{ID}.json"));
    let mut file = File::parse(&std::fs::read_to_string(&path).unwrap()).unwrap();
    for case in file.cases.iter_mut().filter(|case| case.out.is_some()).take(7) {
        case.out.as_mut().unwrap().insert("fc".into(), 1e9.into()).unwrap();
    }
    std::fs::write(&path, file.render().unwrap()).unwrap();
    let ran = bench.run(&["audit", "--filter", ID, "--samples", "1", "--format", "markdown"]).quiet();
    let ran = ran.prints("Against the committed golden file: 7 changes.\n\n").prints("\n- … and 2 more\n\n");
    assert_eq!(ran.stdout.matches("committed 1000000000.0, computed").count(), 5);
}

#[test]
fn a_seed_gives_the_same_points_again_and_another_gives_others() {
    let seed = |seed| audit(&["--samples", "5", "--seed", seed]);
    assert_eq!(seed("5"), seed("5"));
    // It reports the seed; the points differ too.
    assert_ne!(seed("5"), Audit { seed: 5, ..seed("6") });
}

#[test]
fn markdown_has_a_row_for_every_claim() {
    let ran = Bench::new()
        .run(&["audit", "--filter", ID, "--samples", "5", "--format", "markdown"])
        .quiet()
        .prints(&format!("<details><summary>✅ <code>{ID}</code>: "))
        .prints("Against the committed golden file: no change.");
    for claim in audit(&["--samples", "5"]).claims() {
        let row = format!("| {} | {} | 0 | ", claim.claim, claim.checks);
        assert_eq!(ran.stdout.matches(&row).count(), 1, "{row}\n{}", ran.stdout);
    }
    let rows = ran.stdout.lines().filter(|line| line.starts_with('|'));
    rows.for_each(|row| assert_eq!(row.matches('|').count(), 7, "{row}"));
}

#[test]
fn text_has_a_line_for_every_claim() {
    let ran = Bench::new().run(&["audit", "--filter", ID, "--samples", "5"]).quiet();
    for claim in audit(&["--samples", "5"]).claims() {
        assert_eq!(ran.stdout.lines().filter(|line| line.ends_with(&claim.claim)).count(), 1, "{claim:?}");
    }
}

#[test]
fn the_worst_point_can_be_given_back() {
    type Figure = fn(&Audit) -> &Claim;
    let figures: [(&str, Figure); 2] =
        [("value", |audit| &audit.eta), ("Jacobian", |audit| audit.eta_jacobian.as_ref().unwrap())];
    let audited = audit(&["--samples", "50"]);
    for (name, figure) in figures {
        let worst = figure(&audited).worst.as_ref().unwrap();
        assert!(worst.size > 0.0, "{name}");
        let again = audit(&["--point", &worst.inputs.to_string()]);
        let there = figure(&again).worst.as_ref().unwrap();
        let compared = |worst: &Deviation| (worst.entry.clone(), worst.size, worst.found, worst.expected);
        assert_eq!(compared(there), compared(worst), "{name}");
    }
}

#[test]
fn the_text_gives_a_point_as_the_option_takes_it() {
    let ran = Bench::new().run(&["audit", "--filter", ID, "--samples", "5"]).quiet();
    let line = ran.stdout.lines().find_map(|line| line.trim().strip_prefix("--point '")).unwrap();
    let again = audit(&["--point", line.strip_suffix('\'').unwrap()]);
    assert_eq!((again.named_points, again.random_points), (1, 0));
}

#[test]
fn a_point_on_a_kink_is_audited_as_far_as_can_be() {
    let point = r#"{"f_trial": 2.0, "mu": 0.5, "fn": 4.0}"#;
    Bench::new()
        .run(&["audit", "--filter", "coulomb.return_map", "--point", point])
        .quiet()
        .prints("ok  coulomb.return_map at 1 point\n")
        .prints("NOT CHECKED")
        .prints(" 0 formulas off");
}

#[test]
fn markdown_says_what_changed_against_the_committed_golden_file() {
    let audit = ["audit", "--filter", ID, "--samples", "1", "--format", "markdown"];
    let bench = Bench::with(&["golden"]);
    let path = bench.path(&format!("golden/{ID}.json"));
    let mut file = File::parse(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let outputs = file.cases[0].out.as_mut().unwrap();
    let right = outputs.insert("fc".into(), 1e9.into()).unwrap();
    std::fs::write(&path, file.render().unwrap()).unwrap();
    bench
        .run(&audit)
        .quiet()
        .prints("Against the committed golden file: 1 change.\n\n")
        .prints(&format!("- case {}, out.fc: committed 1000000000.0, computed {right} (", file.cases[0].id));
    std::fs::remove_file(path).unwrap();
    let ran = bench.run(&audit).exits(1).prints("There is no committed golden file to compare with: No such file");
    ran.prints(&format!("{ID} lacks\n    its golden file: cargo xtask golden --filter {ID}\n"));
}

#[test]
fn a_point_that_cannot_be_audited_is_bad_usage() {
    let refused = |filter: &str, point: &str, expected: &str| {
        Bench::new().run(&["audit", "--filter", filter, "--point", point]).bad_usage(expected);
    };
    let force = "slot.contact_force";
    refused(force, r#"{"f2": 3, "f4": 4}"#, "--point of slot.contact_force: f4 is no input; allowed is f2, f3");
    refused(force, r#"{"f2": 3}"#, "f3 is missing; allowed is a number");
    refused(force, r#"{"f2": 3, "f3": [4]}"#, "f3 is [4]; allowed is a number");
    refused(force, r#"{"f2": 3, "f3": "NaN"}"#, "f3 is NaN; allowed is a finite number");
    refused(force, r#"{"f2": 3, "f3": "-Infinity"}"#, "f3 is -inf; allowed is a finite number");
    refused(force, r#"{"f2": 3, "f3": 1e999}"#, "--point is not a JSON object of f2, f3: number out of range");
    refused(force, "{f2: 3}", "--point is not a JSON object of f2, f3: key must be a string");
    refused(force, "[3, 4]", "--point is not a JSON object of f2, f3: invalid type: sequence");
    refused("slot.constraint_2d", r#"{"e2a": 1}"#, "e2a is 1; allowed is an array of 2 numbers");
    refused("coulomb.yield", r#"{"p": 1, "mu": -0.1, "fn": 1}"#, "mu is -0.1; allowed is a finite number ≥ 0");
    let of_slot = CATALOG.iter().filter(|formula| formula.spec().id.starts_with("slot.")).count();
    refused("slot.*", "{}", &format!("--point needs a --filter that matches one formula, not {of_slot}"));
    Bench::new().run(&["audit", "--point", "{}"]).bad_usage("--filter <GLOB>");
    Bench::new()
        .run(&["audit", "--filter", force, "--samples", "9", "--point", "{}"])
        .bad_usage("'--samples <N>' cannot be used with '--point <JSON>'");
}

#[test]
fn reviewers_are_told_on_the_line_of_the_function() {
    // A given point is audited alone; every claim holds there.
    let quick = ["audit", "--filter", ID, "--samples", "3", "--format"];
    let run = |format: &str| Bench::new().run(&[quick.as_slice(), &[format]].concat()).quiet().stdout;
    assert!(run("github").starts_with("1 formula, "), "nothing that is well is annotated");
    let sarif: serde_json::Value = serde_json::from_str(&run("sarif")).unwrap();
    assert_eq!(sarif["runs"][0]["results"], serde_json::Value::Array(Vec::new()));
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&run("rdjson")).unwrap()["diagnostics"][0],
        serde_json::Value::Null
    );
}

#[test]
fn a_change_is_audited_where_it_reaches() {
    let bench = Bench::with(&["Cargo.toml", "Cargo.lock", "src", "golden", "xtask/Cargo.toml", "xtask/src"]);
    let git = |arguments: &[&str]| {
        let identity = ["-c", "user.name=a", "-c", "user.email=a@b"];
        let output =
            std::process::Command::new("git").args(identity).args(arguments).current_dir(bench.path("")).output();
        assert!(output.unwrap().status.success(), "{arguments:?}");
    };
    git(&["init", "--quiet"]);
    git(&["add", "."]);
    git(&["commit", "--quiet", "--message", "before"]);
    let audited = || bench.run(&["audit", "--since", "HEAD", "--samples", "2"]).exits(0).stdout;
    assert_eq!(audited(), "0 formulas, 0 comparisons, 0 formulas off\n");
    let edit = |file: &str| {
        let text = std::fs::read_to_string(bench.path(file)).unwrap();
        std::fs::write(bench.path(file), text + "\n// Edited.\n").unwrap();
    };
    edit("src/contact/coulomb/proof.rs");
    let said = audited();
    assert!(said.contains("coulomb.yield") && !said.contains("join.") && !said.contains("slider."), "{said}");
    edit("golden/join.rows.json");
    let said = audited();
    assert!(said.contains("join.rows") && !said.contains("join.constraint"), "{said}");
    bench.run(&["audit", "--since", "no-such-revision"]).bad_usage("--since 'no-such-revision'");
}

/// What a search finds is a point that an audit judges alike.
#[test]
fn an_attack_shows_points_that_can_be_audited() {
    let ran = Bench::new().run(&["audit", "--filter", ID, "--attack", "1", "--evaluations", "30000"]).quiet();
    let ran = ran.prints("possible    found    bound   proved").prints("1 formula, ").prints(", 0 formulas refuted");
    let points: Vec<_> = ran.stdout.lines().filter_map(|line| line.trim().strip_prefix("--point ")).collect();
    assert_eq!(points.len(), 2, "{}", ran.stdout);
    for (point, claim) in points.into_iter().zip(["η of the value in f64: ", "η of the closed-form Jacobian in f64: "])
    {
        let audit = audit(&["--point", point.trim_matches('\'')]);
        let claims = [&audit.eta].into_iter().chain(&audit.eta_jacobian);
        let sizes: Vec<_> = claims.map(|claim| claim.worst.as_ref().unwrap().size).collect();
        assert!(
            sizes.iter().any(|size| ran.stdout.contains(&format!("{claim}{size:.2} at"))),
            "{sizes:?} {}",
            ran.stdout
        );
    }
}

#[test]
fn an_attack_takes_a_time_and_no_points() {
    let bench = Bench::new();
    bench.run(&["audit", "--filter", ID, "--attack=-1"]).bad_usage("--attack is -1; allowed is a time in seconds");
    bench
        .run(&["audit", "--filter", ID, "--attack", "1", "--samples", "5"])
        .bad_usage("cannot be used with '--samples");
}
