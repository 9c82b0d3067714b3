//! `check` on programs that are written as a textbook would, not like ours: each is right, with its limits named; and on
//! every one mistakes are planted, alone and in pairs, and counted are those that are named.
//!
//! The programs are in `tests/ports`, each with a list of edits: a name, words of which a cause has to contain one, and texts of
//! the program with what stands there instead.

use crate::common::{Bench, all_mistakes, is_here};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program, the formula that it computes, what it is asked for, and what is said about its limits.
struct Port {
    file: &'static str,
    formula: &'static str,
    options: &'static [&'static str],
    limits: &'static [&'static str],
}

const PORTS: [Port; 6] = [
    Port {
        file: "slot_friction.c",
        formula: "slot.friction",
        options: &[],
        limits: &["= 1e154 a square in length(f2, f3) overflows", "a square in length(f2, f3) underflows"],
    },
    Port {
        file: "return_map_2d.c",
        formula: "coulomb.return_map_2d",
        options: &[],
        limits: &["= 1e154 a square in length(f_trial[0], f_trial[1]) overflows"],
    },
    Port {
        file: "contact_force.f90",
        formula: "translator.contact_force",
        options: &[],
        limits: &[
            "f2, f3 = 1e154 a square in length(f2, f3) overflows",
            "= 1e154 a square in length(m2, m3) overflows",
        ],
    },
    Port {
        file: "contact_moments.f90",
        formula: "ujoint.contact_moments",
        options: &["--wanted", "value", "--valid-only"],
        limits: &["with extreme numbers"],
    },
    Port {
        file: "nodal_forces_2d.py",
        formula: "slider.nodal_forces_2d",
        options: &[],
        limits: &["small beside others of their vector or matrix: a sum there cancels", "underflows"],
    },
    Port {
        file: "angles.py",
        formula: "universal.angles",
        options: &["--valid-only"],
        limits: &["by another convention"],
    },
];

/// A planted mistake.
struct Edit {
    name: String,
    words: Vec<String>,
    replacements: Vec<[String; 2]>,
}

impl Port {
    fn is_here(&self) -> bool {
        match self.file.rsplit_once('.') {
            Some((_, "c")) => is_here("gcc"),
            Some((_, "f90")) => is_here("gfortran"),
            _ => is_here("python3"),
        }
    }

    fn text(&self) -> String {
        fs::read_to_string(folder().join(self.file)).unwrap()
    }

    fn edits(&self) -> Vec<Edit> {
        let text = fs::read_to_string(folder().join(format!("{}.edits", self.file))).unwrap();
        let mut edits: Vec<Edit> = Vec::new();
        let mut last = ' ';
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            match (line.strip_prefix("- "), line.strip_prefix("+ ")) {
                (Some(from), _) if last == '-' => {
                    let [text, _] = edits.last_mut().unwrap().replacements.last_mut().unwrap();
                    text.extend(["\n", from]);
                }
                (Some(from), _) => edits.last_mut().unwrap().replacements.push([from.to_owned(), String::new()]),
                (_, Some(to)) => {
                    let [_, text] = edits.last_mut().unwrap().replacements.last_mut().unwrap();
                    text.extend([if last == '+' { "\n" } else { "" }, to]);
                }
                _ => {
                    let (name, words) = line.split_once(" | ").unwrap_or_else(|| panic!("{}: {line}", self.file));
                    let words = words.split(';').map(|word| word.trim().to_owned()).collect();
                    edits.push(Edit { name: name.to_owned(), words, replacements: Vec::new() });
                }
            }
            last = line.chars().next().unwrap_or(' ');
        }
        edits
    }

    /// Builds a text of this program in a folder of its own, and checks it.
    fn checked(&self, bench: &Bench, tag: &str, text: &str) -> (i32, String) {
        let folder = bench.path(&format!("{}-{tag}", self.file));
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join(self.file);
        fs::write(&file, text).unwrap();
        let program = folder.join("program");
        let compile = |compiler: &str, last: &[&str]| {
            let output =
                Command::new(compiler).args(["-O1", "-o"]).args([&program, &file]).args(last).output().unwrap();
            assert!(output.status.success(), "{}: {}", self.file, String::from_utf8_lossy(&output.stderr));
            vec![program.to_str().unwrap().to_owned()]
        };
        let program = match self.file.rsplit_once('.') {
            Some((_, "c")) => compile("gcc", &["-lm"]),
            Some((_, "f90")) => compile("gfortran", &[]),
            _ => vec!["python3".to_owned(), file.to_str().unwrap().to_owned()],
        };
        let program: Vec<&str> = program.iter().map(String::as_str).collect();
        let ran = bench.run(&[&["check", "--formula", self.formula], self.options, &["--"], &program].concat());
        (ran.code.expect("it ends by itself"), ran.stdout)
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ports")
}

/// The text with these mistakes; `None` if they are planted in the same line.
fn planted(text: &str, edits: &[&Edit]) -> Option<String> {
    let mut text = text.to_owned();
    for [from, to] in edits.iter().flat_map(|edit| &edit.replacements) {
        if !text.contains(from) {
            return None;
        }
        text = text.replacen(from, to, 1);
    }
    Some(text)
}

#[test]
fn textbook_ports_are_right_and_their_limits_are_named() {
    for port in PORTS.iter().filter(|port| port.is_here()) {
        let (code, said) = port.checked(&Bench::new(), "right", &port.text());
        assert_eq!(code, 0, "{said}");
        assert!(said.starts_with("ok  ") && said.contains("right, with limits"), "{said}");
        for limit in port.limits {
            assert!(said.contains(limit), "{limit:?} is not in\n{said}");
        }
    }
}

/// What was said about a planted mistake.
#[derive(Clone, Copy, PartialEq)]
enum Said {
    Right,
    Named,
    Unexplained,
    Otherwise,
}

fn said_of(edits: &[&Edit], code: i32, said: &str) -> Said {
    let causes: Vec<_> = said.lines().filter_map(|line| line.trim().strip_prefix("diagnosis: ")).collect();
    let all = causes.join("\n");
    let is_named = |edit: &&Edit| edit.words.iter().any(|word| all.contains(word.as_str()));
    match code {
        0 => Said::Right,
        _ if all.contains("unexplained") || causes.is_empty() => Said::Unexplained,
        _ if edits.iter().any(is_named) => Said::Named,
        _ => Said::Otherwise,
    }
}

/// One of so many mistakes is planted where not all are wanted.
const SOME: usize = 6;

/// The counts of what was said about all mistakes of a port, or about pairs of them, and a line for each that is not named.
fn count(port: &Port, pairs: bool) -> ([usize; 4], String) {
    let (text, edits) = (port.text(), port.edits());
    assert!(edits.len() >= 25, "{} has {} edits", port.file, edits.len());
    let all: Vec<Vec<&Edit>> = if pairs {
        let every = edits.iter().enumerate().flat_map(|(k, a)| edits[k + 1..].iter().map(move |b| vec![a, b]));
        every.skip(5).step_by(29).collect()
    } else {
        edits.iter().map(|edit| vec![edit]).collect()
    };
    // Some of them where not all are wanted, other ones of each port.
    let (first, every) = if all_mistakes() { (0, 1) } else { (port.file.len() % SOME, SOME) };
    let all: Vec<_> = all.into_iter().skip(first).step_by(every).collect();
    let (mut counts, mut rest) = ([0; 4], String::new());
    let bench = Bench::new();
    for (k, edits) in all.iter().enumerate() {
        let Some(text) = planted(&text, edits) else {
            assert!(pairs, "{}: `{}` does not fit", port.file, edits[0].name);
            continue;
        };
        let (code, said) = port.checked(&bench, &k.to_string(), &text);
        let what = said_of(edits, code, &said);
        counts[what as usize] += 1;
        if what != Said::Named {
            let names: Vec<_> = edits.iter().map(|edit| edit.name.as_str()).collect();
            let causes: Vec<_> = said.lines().filter(|line| line.contains("diagnosis: ")).map(str::trim).collect();
            let _ = writeln!(rest, "  {}: {}", names.join(" + "), causes.join(" // "));
        }
    }
    (counts, rest)
}

/// Every port's counts, two ports at a time.
fn counts(pairs: bool) -> [usize; 4] {
    let ports: Vec<_> = PORTS.iter().filter(|port| port.is_here()).collect();
    let counted: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = ports.iter().map(|port| scope.spawn(move || count(port, pairs))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    println!("{:22} {:>6} {:>6} {:>12} {:>10}", "port", "right", "named", "unexplained", "otherwise");
    let mut sums = [0; 4];
    for (port, (counts, rest)) in ports.iter().zip(counted) {
        let [right, named, unexplained, otherwise] = counts;
        println!("{:22} {right:>6} {named:>6} {unexplained:>12} {otherwise:>10}\n{rest}", port.file);
        sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
    }
    sums
}

#[test]
fn planted_mistakes_are_named() {
    let [right, named, unexplained, otherwise] = counts(false);
    let all = named + unexplained;
    assert_eq!((right, otherwise), (0, 0));
    assert!(named * 100 >= all * 85, "{named} of {all}");
}

#[test]
fn pairs_of_mistakes_are_named() {
    let [right, named, unexplained, _] = counts(true);
    let all = named + unexplained;
    assert_eq!(right, 0);
    assert!(named * 100 >= all * 60, "{named} of {all}");
}
