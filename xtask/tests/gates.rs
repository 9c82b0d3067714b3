//! Each gate detects its own fault, and only that one. This program is both the tests and, on request, a project of
//! one formula with a planted fault; therefore it has no test harness.

mod common;
#[path = "common/gated.rs"]
mod gated;

use common::Ran;
use gated::{PLANT, is_planted};
use kit::{Beside, Project};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

/// Set if this program is to act as the project.
const IS_PROJECT: &str = "JOINTPROOF_TEST_IS_PROJECT";

fn main() -> ExitCode {
    if std::env::var_os(IS_PROJECT).is_some() {
        return kit::main(project());
    }
    // Listing or filtering tests runs none of these.
    if std::env::args().len() == 1 {
        every_gate_closes_for_its_fault_alone();
        every_verdict_is_given_even_if_all_is_off();
        only_the_unfiltered_writing_form_removes_a_file_without_a_formula();
        an_audit_fails_in_every_format();
        evidence_counts_for_the_version_that_it_is_of();
        what_is_missing_closes_every_gate();
        what_this_program_found_is_not_audited_again();
    }
    ExitCode::SUCCESS
}

fn project() -> Project {
    let beside = |project: &Project| {
        let text = if is_planted("beside") { "another text" } else { "a text" };
        let files = vec![(project.golden().join("more/beside.txt"), text.to_owned())];
        Ok(Beside { files, orphans: Vec::new(), counts: "1 text".into() })
    };
    Project::new("gates", env!("CARGO_MANIFEST_DIR"), &[&gated::Square])
        .with_golden("beside", beside)
        .with_check("own", |_| Ok((!is_planted("own"), "1 check".into())))
        .with_requirement("a poem", |_, _| !is_planted("missing"), "in `{id}.txt`")
}

/// A folder in which all is well until a fault is planted.
struct Gate(tempfile::TempDir);

impl Gate {
    fn new() -> Self {
        let gate = Self(tempfile::tempdir().unwrap());
        let files = [
            ("src/lib.rs", "//! Nothing.\n"),
            ("book/book.toml", "[book]\ntitle = \"Gates\"\n"),
            ("book/src/SUMMARY.md", "# Summary\n\n- [One](one.md)\n"),
            ("book/src/one.md", "# One\n\n{{#formula gate.square}}\n"),
        ];
        for (file, text) in files {
            fs::create_dir_all(gate.path(file).parent().unwrap()).unwrap();
            fs::write(gate.path(file), text).unwrap();
        }
        gate.run("", &["golden"]).exits(0);
        gate
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    /// Appends this to a file.
    fn append(&self, file: &str, text: &str) {
        let before = fs::read_to_string(self.path(file)).unwrap();
        fs::write(self.path(file), before + text).unwrap();
    }

    fn run(&self, fault: &str, arguments: &[&str]) -> Ran {
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.args(arguments).env(IS_PROJECT, "yes").env(PLANT, fault).env("JOINTPROOF_ROOT", self.0.path());
        command.env("CARGO_TARGET_DIR", self.path("target")).env("NO_COLOR", "1").env_remove("CLICOLOR_FORCE");
        command.env("GITHUB_STEP_SUMMARY", self.path("summary.md"));
        Ran::from(command.output().unwrap())
    }

    /// The steps of `verify` that fail.
    fn off(&self, fault: &str) -> (Vec<String>, Ran) {
        let ran = self.run(fault, &["verify", "--samples", "20"]);
        let lines: Vec<_> = ran.stdout.lines().filter_map(|line| line.split_once(' ')).collect();
        let steps: Vec<_> = lines.iter().filter_map(|(_, rest)| rest.split_whitespace().next()).collect();
        assert_eq!(steps, ["missing", "golden", "beside", "audit", "own", "prose", "book"], "{ran:#?}");
        let off =
            lines.iter().zip(steps).filter(|((mark, _), _)| *mark == "off").map(|(_, step)| step.into()).collect();
        (off, ran)
    }
}

/// A fault, a change of the project in addition to the environment, the message, and whether `golden --check` and
/// `audit` detect it.
type Planted = (&'static str, fn(&Gate), &'static str, [bool; 2]);

const FAULTS: [Planted; 8] = {
    fn golden(gate: &Gate) {
        let file = gate.path("golden/gate.square.json");
        let text = fs::read_to_string(&file).unwrap();
        assert_eq!(text.matches("\"area\": 9.0").count(), 1, "{text}");
        fs::write(file, text.replace("\"area\": 9.0", "\"area\": 9.000000000000002")).unwrap();
    }
    [
        ("", |_| (), "", [false, false]),
        ("missing", |_| (), "a poem: in `gate.square.txt`", [true, true]),
        ("golden", golden, "case three out.area  (1 ulp apart)", [true, false]),
        ("beside", |_| (), "golden/more/beside.txt differs", [true, false]),
        ("audit", |_| (), "FAILED", [false, true]),
        ("own", |_| (), "", [false, false]),
        (
            "prose",
            |gate| gate.append("book/src/one.md", "\n$$\na = b\n$$\n"),
            "one.md:5: this equation",
            [false, false],
        ),
        ("book", |gate| gate.append("book/src/one.md", "\n[x](two.md)\n"), "the link `two.html`", [false, false]),
    ]
};

fn every_gate_closes_for_its_fault_alone() {
    for (fault, plant, said, seen) in FAULTS {
        let gate = Gate::new();
        plant(&gate);
        let (off, ran) = gate.off(fault);
        let expected = [fault];
        assert_eq!(off, expected[usize::from(fault.is_empty())..], "{ran:#?}");
        ran.exits(i32::from(!fault.is_empty())).says(said);
        for (command, is_seen) in [&["golden", "--check"][..], &["audit", "--samples", "20"]].iter().zip(seen) {
            let ran = gate.run(fault, command).exits(i32::from(is_seen));
            assert!(!is_seen || ran.stdout.contains(said), "{ran:#?}");
        }
    }
}

fn every_verdict_is_given_even_if_all_is_off() {
    let gate = Gate::new();
    for (_, plant, ..) in FAULTS {
        plant(&gate);
    }
    let named = FAULTS.map(|(fault, ..)| fault);
    let (off, mut ran) = gate.off(&named.join(","));
    assert_eq!(off, named[1..], "{ran:#?}");
    for (.., said, _) in FAULTS {
        ran = ran.says(said);
    }
    ran.says("to make the files what the code says: ").exits(1);
}

fn only_the_unfiltered_writing_form_removes_a_file_without_a_formula() {
    let gate = Gate::new();
    let before = fs::read(gate.path("golden/gate.square.json")).unwrap();
    let orphan = gate.path("golden/gate.gone.json");
    fs::copy(gate.path("golden/gate.square.json"), &orphan).unwrap();
    let filtered = ["golden", "--filter", "gate.square"];
    let check = [&filtered[..], &["--check"]].concat();
    gate.run("", &check).exits(1).prints("golden/gate.gone.json has no formula").says("golden");
    gate.run("", &filtered).quiet();
    assert!(orphan.exists());
    gate.run("", &["golden"]).quiet().prints("removed golden/gate.gone.json: no such formula");
    assert!(!orphan.exists());
    gate.run("", &check).quiet();
    assert_eq!(fs::read(gate.path("golden/gate.square.json")).unwrap(), before);
}

fn an_audit_fails_in_every_format() {
    let gate = Gate::new();
    for format in ["text", "markdown", "json", "github", "sarif", "rdjson"] {
        let audit = ["audit", "--samples", "20", "--format", format];
        gate.run("", &audit).exits(0);
        let ran = gate.run("audit", &audit).exits(1);
        assert!(ran.stdout.contains("η of the value"), "{ran:#?}");
    }
    let point = ["audit", "--filter", "gate.square", "--point", "{\"a\": 3}"];
    gate.run("", &point).exits(0);
    // An unchecked claim does not count as held, though it did not fail.
    gate.run("unchecked", &["audit", "--samples", "20"]).exits(1).prints("NOT CHECKED: a square turned over");
    let (off, ran) = gate.off("unchecked");
    assert_eq!(off, ["audit"]);
    ran.exits(1).says("NOT CHECKED: a square turned over");
    gate.run("unchecked", &point).exits(0);
    gate.run("audit", &point).exits(1).prints("FAILED 2 TIMES: η of the value");
}

fn evidence_counts_for_the_version_that_it_is_of() {
    let gate = Gate::new();
    let entry = || {
        gate.run("", &["book", "--unmeasured"]).exits(0);
        let page = fs::read_to_string(gate.path("target/book/one.html")).unwrap();
        page.split("<h3 id=\"gate.square\">").nth(1).unwrap().split("</section>").next().unwrap().to_owned()
    };
    let [audited, checked] = ["points audited", "golden cases regenerated"];
    let none = entry();
    assert!(!none.contains(audited) && !none.contains(checked), "{none}");
    gate.run("", &["audit", "--samples", "20"]).exits(0);
    let some = entry();
    assert!(some.contains(audited) && !some.contains(checked), "{some}");
    gate.run("", &["golden", "--check"]).exits(0);
    let all = entry();
    assert!(all.contains(audited) && all.contains(checked), "one does not drop the other: {all}");
    // A failed audit is shown as such, even if its worst point contains NaN.
    gate.run("nan", &["audit", "--samples", "20"]).exits(1);
    let failed = entry();
    assert!(failed.contains("<b class=\"missing\">failed</b>") && failed.contains(checked), "{failed}");
    gate.append("src/lib.rs", "//! Edited.\n");
    let old = entry();
    assert!(!old.contains(audited) && !old.contains(checked) && old.contains("not audited on this version"), "{old}");
    // A file with a difference is not evidence either.
    gate.append("golden/gate.square.json", " ");
    gate.run("", &["golden", "--check"]).exits(1);
    assert!(!entry().contains(checked));
}

fn what_is_missing_closes_every_gate() {
    let gate = Gate::new();
    gate.run("missing", &["golden"]).exits(1).prints("gate.square lacks");
    gate.run("missing", &["audit", "--samples", "3", "--format", "json"]).exits(1).says("gate.square lacks");
}

fn what_this_program_found_is_not_audited_again() {
    let gate = Gate::new();
    let known = ", 1 known from before in ";
    let verify = |fault: &str, more: &[&str]| gate.run(fault, &[&["verify", "--samples", "20"], more].concat());
    let first = verify("", &[]).exits(0);
    assert!(!first.stdout.contains("known from before"), "{first:#?}");
    // Nothing is audited again, so the planted fault goes unnoticed.
    verify("audit", &[]).exits(0).prints(known);
    let fresh = verify("audit", &["--fresh"]).exits(1);
    assert!(!fresh.stdout.contains("known from before"), "{fresh:#?}");
    // What failed is audited again.
    let again = verify("", &[]).exits(0);
    assert!(!again.stdout.contains(known), "{again:#?}");
    let more = gate.run("", &["verify", "--samples", "21"]).exits(0);
    assert!(!more.stdout.contains(known), "{more:#?}");
}
