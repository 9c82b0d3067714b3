//! The command line: exit codes, help, colours, closed pipes, and the output on each stream.

use crate::common::{self, Bench, Ran};
use jointproof::catalog::{CATALOG, ELEMENTS};
use std::process::Stdio;

/// The commands listed by the help.
fn commands() -> Vec<String> {
    let help = Bench::new().run(&["--help"]).quiet().stdout;
    let (_, after) = help.split_once("Commands:\n").unwrap();
    let names = after.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(String::from).collect()
}

#[test]
fn help_of_every_command_shows_examples_of_it() {
    let commands = commands();
    assert!(commands.len() >= 4, "{commands:?}");
    for command in commands {
        let help = Bench::new().run(&[&command, "--help"]).quiet().stdout;
        let (_, examples) =
            help.split_once("Examples:\n").unwrap_or_else(|| panic!("{command} has no examples\n{help}"));
        for example in examples.lines() {
            assert!(example.trim_start().starts_with(&format!("cargo xtask {command}")), "{example}");
        }
    }
}

#[test]
fn the_readme_lists_every_command_and_no_other() {
    let readme = std::fs::read_to_string(common::repository().join("README.md")).unwrap();
    let rows = readme.lines().filter_map(|line| line.strip_prefix("| `cargo xtask "));
    let listed: Vec<_> = rows.filter_map(|row| row.split('`').next()).collect();
    assert_eq!(listed, commands());
    let counts = format!("{} formulas and {} elements", CATALOG.len(), ELEMENTS.len());
    assert!(readme.contains(&counts), "the README has not: {counts}");
}

#[test]
fn an_unknown_command_or_option_is_bad_usage() {
    let bench = Bench::new();
    bench.run(&["goldne"]).bad_usage("golden");
    bench.run(&["golden", "--chekc"]).bad_usage("--check");
    bench.run(&["audit", "--samples", "many"]).bad_usage("many");
    bench
        .run(&["audit", "--format", "yaml"])
        .bad_usage("[possible values: text, markdown, json, github, sarif, rdjson]");
    // Without a command, the help is shown.
    bench.run(&[]).exits(2).says("Commands:");
}

#[test]
fn a_filter_that_is_no_pattern_is_bad_usage() {
    for command in ["golden", "audit"] {
        Bench::new().run(&[command, "--filter", "slot.[a"]).bad_usage("--filter is not a pattern");
    }
}

#[test]
fn a_filter_that_matches_nothing_is_bad_usage_and_says_what_may_be_meant() {
    for command in ["golden", "audit"] {
        let ran = Bench::new().run(&[command, "--filter", "slit.*"]).bad_usage("--filter 'slit.*' matches no formula");
        ran.says("; did you mean slot.*?").says("formulas` lists all");
    }
    let asked = |id: &str| Bench::new().run(&["formulas", id]).exits(2).stderr;
    assert!(asked("slot.frition").contains("did you mean slot.friction?"));
    assert!(asked("slot.rows").contains("it is now join.rows"));
    assert!(asked("nothing").contains("families are align, cardan, "));
}

#[test]
fn a_name_that_no_input_or_output_has_is_bad_usage() {
    let equation = ["equation", r"r = \sqrt{f_2^2 + f_3^2}", "--against", "slot.contact_force", "--let"];
    let bench = Bench::new();
    bench.run(&[&equation[..], &["r=fd"]].concat()).bad_usage("--let r=fd: fd is none of f2, f3, fc");
    bench.run(&[&equation[..], &["r=fc"]].concat()).quiet().prints("the same function as slot.contact_force");
}

#[test]
fn results_are_printed_and_nothing_else_is_said() {
    let bench = Bench::new();
    let quick = ["audit", "--filter", "slot.contact_force", "--samples", "3"];
    bench.run(&quick).quiet().prints("slot.contact_force");
    bench.run(&["golden", "--check", "--filter", "slot.contact_force"]).quiet().prints("ok 1 formula, ");
}

/// A check that prints a coloured difference.
fn coloured(variables: &[(&str, &str)]) -> Ran {
    let bench = Bench::with(&["golden/schema.json"]);
    let mut command = bench.command(&["golden", "--check", "--filter", "slot.stop"]);
    Ran::from(command.envs(variables.iter().copied()).output().unwrap()).exits(1)
}

#[test]
fn colours_are_for_terminals_unless_forced() {
    const RED: &str = "\u{1b}[31m";
    assert!(!coloured(&[]).stdout.contains('\u{1b}'), "not a terminal");
    assert!(coloured(&[("CLICOLOR_FORCE", "1")]).stdout.contains(RED), "forced");
    assert!(!coloured(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]).stdout.contains('\u{1b}'), "not wanted");
}

/// Runs a command whose reader closes the pipe before it prints.
fn into_closed_pipe(bench: &Bench, arguments: &[&str]) -> Ran {
    let mut child = bench.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    Ran::from(child.wait_with_output().unwrap())
}

#[test]
fn a_closed_pipe_ends_a_command_quietly() {
    let bench = Bench::new();
    for arguments in [&["--help"][..], &["audit", "--help"], &["audit", "--filter", "slot.*_force", "--samples", "3"]] {
        into_closed_pipe(&bench, arguments).quiet();
    }
}

#[test]
fn a_closed_pipe_does_not_hide_that_something_is_off() {
    let bench = Bench::with(&["golden/schema.json"]);
    into_closed_pipe(&bench, &["golden", "--check", "--filter", "slot.stop"]).exits(1);
}

#[test]
fn formulas_are_listed_and_shown() {
    let bench = Bench::new();
    let ran = bench.run(&["formulas"]).quiet();
    let width = CATALOG.iter().map(|formula| formula.spec().id.len()).max().unwrap();
    let line = |id: &str, title: &str| format!("{id:width$}  {title}\n");
    let lines: String = CATALOG.iter().map(|formula| line(formula.spec().id, formula.spec().title)).collect();
    assert_eq!(ran.stdout, lines);
    let shown = ["formulas", "--filter", "coulomb.return_map", "--show"];
    bench
        .run(&shown)
        .quiet()
        .prints("in  f_trial (F): ")
        .prints("a finite number ≥ 0")
        .prints("out f (F): friction")
        .prints("kink: ");
    let ran = bench.run(&["formulas", "--filter", "slider.line", "--show"]).quiet();
    ran.prints("\n    in  x1[3] (L): ").prints("\n    out n[3] (1): ").prints("\n    value: η ≤ ");
}

#[test]
fn completions_name_every_command() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish"] {
        let ran = bench.run(&["complete", shell]).quiet();
        for command in commands() {
            assert!(ran.stdout.contains(&command), "{command} is not completed in {shell}");
        }
    }
}

#[test]
fn what_runs_by_itself_calls_itself_by_its_name() {
    let mut command = Bench::new().command(&["audit", "--help"]);
    let ran = Ran::from(command.env_remove("CARGO").output().unwrap()).quiet();
    ran.prints("  jointproof audit ");
}
