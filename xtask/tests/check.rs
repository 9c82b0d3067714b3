//! `cargo xtask check`: how programs are asked, and the reports on those that answer wrongly.

use crate::common::{Bench, Ran};

const ID: &str = "coulomb.yield";
/// Φ = P − μ F_N and its derivatives.
const RIGHT: &str = r#"{ printf "%.17g 1 %.17g %.17g\n", $1 - $2 * $3, -$3, -$2; fflush() }"#;

/// Checks an awk program, which rejects nothing.
fn awk(options: &[&str], program: &str) -> Ran {
    let before = ["check", "--formula", ID, "--valid-only", "--samples", "100"];
    Bench::new().run(&[&before, options, &["--", "awk", program]].concat())
}

/// Checks a Python program.
fn python(options: &[&str], program: &str) -> Ran {
    let before = ["check", "--formula", ID, "--samples", "100"];
    Bench::new().run(&[&before, options, &["--", "python3", "-c", program]].concat())
}

#[test]
fn a_right_program_costs_a_line_for_each_part() {
    let ran = awk(&[], RIGHT).quiet().prints("ok  coulomb.yield by awk ").prints("the same function?           yes");
    assert!(ran.stdout.lines().count() <= 12, "{ran:#?}");
    awk(&["--wanted", "value"], r#"{ printf "%.17g\n", $1 - $2 * $3; fflush() }"#).quiet();
}

#[test]
fn products_are_judged_by_those_who_have_no_jacobian() {
    // The inputs are followed by v and then w.
    let product = |sign: &str| {
        format!(
            r#"{{ printf "%.17g %.17g %.17g %.17g %.17g\n", $1 - $2 * $3, $4 {sign} $3 * $5 - $2 * $6, $7, -$3 * $7, -$2 * $7; fflush() }}"#
        )
    };
    let own = "J v are the derivatives of its own values along 6 directions: the remainder falls as h^2.0";
    awk(&["--wanted", "products"], &product("-")).quiet().prints(own);
    awk(&["--wanted", "products"], &product("+")).exits(1).prints("(J v) of phi is ").prints(
        "J v are not the derivatives of its own values of phi along 6 directions: the remainder falls as h^1.0",
    );
    // The slope is computed from the first pass; in the second pass the sign is reversed.
    let first = format!("{{ if (seen[$0]++) $4 = -$4 }} {}", product("-"));
    awk(&["--wanted", "products"], &first).exits(1).prints(own).prints("state is kept between calls");
    // Another function, with its own products.
    let other = r#"{ printf "%.17g %.17g %.17g %.17g %.17g\n", $1 + $2 * $3, $4 + $3 * $5 + $2 * $6, $7, $3 * $7, $2 * $7; fflush() }"#;
    awk(&["--wanted", "products"], other).exits(1).prints(own);
}

#[test]
fn json_and_bits_are_spoken_too() {
    let json = "
import json, sys
print(json.dumps({'ready': json.loads(input())['formula']}), flush=True)
for line in sys.stdin:
    asked = json.loads(line)
    x = {name: float(value) for name, value in asked['in'].items()}
    answer = {'seq': asked['seq']}
    if all(abs(v) < 1e300 for v in x.values()) and x['mu'] >= 0 and x['fn'] >= 0 and x['p'] >= 0:
        answer |= {'out': {'phi': x['p'] - x['mu'] * x['fn']}, 'jac': {'phi': {'p': 1, 'mu': -x['fn'], 'fn': -x['mu']}}}
    else:
        answer['refuse'] = 'something'
    print(json.dumps(answer), flush=True)
";
    python(&["--json"], json).quiet();
    python(&["--json"], &json.replace("-x['fn']", "x['fn']")).exits(1).prints("wrong sign: ∂phi/∂mu");
    let skipped = json.replace("answer = {'seq': asked['seq']}", "answer = {'seq': asked['seq'], 'skipped': 'later'}");
    python(&["--json"], &skipped).exits(1).prints("no answer at an ordinary point").prints(", …): later");
    let bits = "
import struct, sys
for line in sys.stdin:
    p, mu, fn = (struct.unpack('>d', bytes.fromhex(bits))[0] for bits in line.split())
    print(*(struct.pack('>d', x).hex() for x in (p - mu * fn, 1.0, -fn, -mu)), flush=True)
";
    python(&["--hex", "--valid-only"], bits).quiet();
}

#[test]
fn oddities_of_print_are_understood_and_told() {
    awk(&[], &format!("BEGIN {{ print \"my program\" }} {RIGHT}"))
        .exits(0)
        .prints("lines before the first answer, as `my program`");
    let wrapped = r#"{ printf "%.17g\n1 %.17g\n%.17g\n", $1 - $2 * $3, -$3, -$2; fflush() }"#;
    awk(&[], wrapped).exits(0).prints("an answer goes over several lines");
    let with_d = r#"{ y = sprintf("%.17g", $1 - $2 * $3); sub("e", "D", y); print y, "1.0D0", sprintf("%.17g %.17g", -$3, -$2); fflush() }"#;
    awk(&[], with_d).exits(0).prints("understood: D exponents");
    awk(&[], &format!("{RIGHT} END {{ print \"done\" }}")).exits(0).prints("lines behind the last answer");
}

#[test]
fn what_is_no_answer_is_named_and_the_run_goes_on() {
    let at = |what: &str| format!("NR == 40 {{ {what} }} NR != 40 {RIGHT}");
    let odd = |what: &str| awk(&["--limit", "3"], &at(what)).exits(1);
    odd("print 1; fflush()").prints("no answer").prints("1 numbers instead of 4");
    odd("print \"1 2 3 many\"; fflush()").prints("`many` is no number");
    // A separate process gets this point as its first one.
    awk(&["--limit", "3"], &format!("$1 == 1.5 {{ exit 3 }} {RIGHT}")).exits(1).prints("ends with exit code 3");
}

#[test]
fn a_program_that_hangs_is_ended_at_its_limit() {
    let hanging = format!("$1 == 1.5 {{ while (1) {{}} }} {RIGHT}");
    awk(&["--limit", "1"], &hanging).exits(1).prints("no answer within the limit");
    awk(&["--limit", "1"], "{ while (1) {} }").exits(1).prints("it prints nothing: nothing comes within the limit");
}

#[test]
fn what_must_be_refused_and_is_not_is_named() {
    let careless = "
import sys
for line in sys.stdin:
    p, mu, fn = map(float, line.split())
    print(p - mu * fn, 1.0, -fn, -mu, flush=True)
";
    // It is the same function; only strictly this is wrong.
    let ran = python(&[], careless).quiet().prints("and computes the others");
    // NaN returned for an input of NaN counts as a rejection.
    ran.prints("is -1.0; allowed is a finite number ≥ 0").prints("taken for a refusal: NaN or infinity");
    python(&["--strict"], careless).exits(1).prints("right, but not strictly");
}

#[test]
fn state_between_calls_is_found() {
    let stale = r#"{ printf "%.17g 1 %.17g %.17g\n", $1 - $2 * $3, -before, -$2; before = $3; fflush() }"#;
    awk(&[], stale)
        .exits(1)
        .prints("state is kept between calls at ")
        .prints("∂phi/∂mu is that of the point asked before");
    let counts = r#"{ printf "%.17g 1 %.17g %.17g\n", $1 - $2 * $3 + NR, -$3, -$2; fflush() }"#;
    awk(&[], counts).exits(1).prints("state is kept between calls; what it is does not show");
    // One derivative is that of the previous point, the other is a counter: neither explains both.
    let two = r#"{ printf "%.17g 1 %.17g %.17g\n", $1 - $2 * $3, -before, -$2 - NR; before = $3; fflush() }"#;
    awk(&[], two).exits(1).prints("state is kept between calls; what it is does not show");
}

#[test]
fn what_is_off_at_a_single_case_is_named_and_not_explained() {
    let ran = awk(&[], &format!("$1 == 1.5 {{ $1 = 1.25 }} {RIGHT}"));
    let ran = ran.exits(1).prints("off coulomb.yield").prints("phi x | + + +\n");
    ran.prints("diagnosis: unexplained: it is off at 1 point alone");
}

#[test]
fn a_mistake_that_explains_some_points_alone_is_not_named() {
    // The sign is reversed, except for large p, where something else is wrong.
    let two = r#"{ y = $1 < 8 ? $1 + $2 * $3 : $1 * 1.001 - $2 * $3; printf "%.17g 1 %.17g %.17g\n", y, -$3, -$2; fflush() }"#;
    awk(&[], two).exits(1).prints("diagnosis: unexplained");
    let one = two.replace("$1 < 8", "1");
    awk(&[], &one).exits(1).prints("diagnosis: value: the sign of ");
}

#[test]
fn numbers_that_leave_the_range_are_told_whatever_else_is_off_there() {
    let naive = "
import math, sys
for line in sys.stdin:
    f2, f3 = map(float, line.split())
    fc = math.sqrt(f2 * f2 + f3 * f3)
    if 0 < fc < math.inf:
        rows = [f2 / fc, f3 / fc]
    else:
        rows = [0.5, 0.0] if f2 or f3 else [0.0, 0.0]
    print(fc, *rows, flush=True)
";
    let options = ["check", "--formula", "slot.contact_force", "--valid-only", "--samples", "100"];
    let ran = Bench::new().run(&[&options[..], &["--", "python3", "-c", naive]].concat());
    ran.quiet().prints("f2, f3 = 1e154 a square in length(f2, f3) overflows: infinity");
    let strictly = [&options[..], &["--strict", "--", "python3", "-c", naive]].concat();
    Bench::new().run(&strictly).exits(1).prints("beyond its bound");
}

#[test]
fn the_worst_point_can_be_given_back() {
    let wrong = RIGHT.replace("-$3", "$3");
    let ran = awk(&[], &wrong).exits(1).prints("diagnosis: wrong sign: ∂phi/∂mu");
    let point = ran.stdout.lines().find_map(|line| line.trim().strip_prefix("--point '")).unwrap();
    awk(&["--point", point.trim_end_matches('\'')], &wrong).exits(1).prints("1 point, each asked twice");
    awk(&["--point", point.trim_end_matches('\'')], RIGHT).quiet();
}

#[test]
fn bad_usage_is_told() {
    let bench = Bench::new();
    bench
        .run(&["check", "--formula", "slot.frictoin", "--", "cat"])
        .bad_usage("'slot.frictoin' is no formula; did you mean slot.friction?");
    bench.run(&["check", "--formula", ID, "--", "./no-such-program"]).bad_usage("./no-such-program cannot be started");
    bench.run(&["check", "--formula", ID]).bad_usage("PROGRAM");
    bench.run(&["check", "--formula", ID, "--limit", "0", "--", "cat"]).bad_usage("--limit");
    bench
        .run(&["check", "--formula", ID, "--point", "[]", "--", "cat"])
        .bad_usage("--point is not a JSON object of p, mu, fn");
    bench.run(&["check", "--formula", ID, "--driver", "julia", "--exported"]).bad_usage("nothing is exported");
}

#[test]
fn a_driver_says_what_goes_in_and_out() {
    let ran = Bench::new().run(&["check", "--formula", "slider.line", "--driver", "python"]).quiet();
    let ran = ran
        .prints("in  x1(3) [L] position of node 1")
        .prints("out l [L] distance")
        .prints("your code is still missing");
    assert!(!ran.stdout.contains("exported"), "{ran:#?}");
    let ran = Bench::new().run(&["check", "--formula", "slider.line", "--driver", "python", "--exported"]).quiet();
    ran.prints("import jp_slider_line as exported").prints("if exported.refused(x1, xn):");
}

#[test]
fn a_driver_for_julia_is_printed() {
    let ran = Bench::new().run(&["check", "--formula", "slider.line", "--driver", "julia"]).quiet();
    ran.prints("function yours(x1, xn)").prints("yours(x[1:3], x[4:6])").prints("for line in eachline(stdin)");
}

#[test]
fn reviewers_are_told_on_the_line_of_the_routine() {
    let wrong = RIGHT.replace("-$3", "$3");
    let summary = tempfile::NamedTempFile::new().unwrap();
    let arguments =
        ["check", "--formula", ID, "--valid-only", "--format", "github", "--at", "mine.f90:40", "--", "awk"];
    let github = |program: &str| {
        let mut command = Bench::new().command(&[&arguments, [program].as_slice()].concat());
        Ran::from(command.env("GITHUB_STEP_SUMMARY", summary.path()).output().unwrap())
    };
    github(&wrong).exits(1).prints("::error file=mine.f90,line=40,title=coulomb.yield%3A wrong sign%3A ∂phi/∂mu");
    let written = std::fs::read_to_string(summary.path()).unwrap();
    assert!(written.contains("diagnosis: wrong sign: ∂phi/∂mu"), "{written}");
    // Of two causes the first becomes the title.
    let two = RIGHT.replace("-$3", "$3").replace("$1 - $2 * $3", "$1 * $1 - $2");
    github(&two).exits(1).prints("title=coulomb.yield%3A value%3A unexplained");
    github("BEGIN { exit 3 }")
        .exits(1)
        .prints("::error file=mine.f90,line=40,title=coulomb.yield%3A it does not answer");
    assert_eq!(github(RIGHT).quiet().stdout.lines().count(), 1, "what is right costs a line");
    for format in ["sarif", "rdjson"] {
        let ran = awk(&["--format", format, "--at", "mine.f90"], &wrong).exits(1).prints("mine.f90");
        serde_json::from_str::<serde_json::Value>(&ran.stdout).unwrap();
    }
    awk(&["--format", "sarif"], RIGHT).bad_usage("--at");
}
