//! Ports of formulas: compiled drivers that call exported code, with planted mistakes.

use crate::common::{Bench, is_here};
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// A language of ports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lang {
    C,
    Cpp,
    Fortran,
    Python,
}

/// Where a mistake is planted.
#[derive(Clone, Copy, Debug)]
pub enum Plant {
    /// No mistake.
    Nothing,
    /// Code inserted after the inputs.
    Before(&'static str),
    /// Code inserted after the results.
    After(&'static str),
    /// A text of the exported formula, and its replacement.
    Within(&'static str, &'static str),
    /// A text of the driver, and its replacement.
    Driver(&'static str, &'static str),
}

impl Lang {
    pub const ALL: [Self; 4] = [Self::C, Self::Cpp, Self::Fortran, Self::Python];

    fn name(self) -> &'static str {
        match self {
            Self::C => "c",
            Self::Cpp => "cpp",
            Self::Fortran => "fortran",
            Self::Python => "python",
        }
    }

    fn exported(self) -> &'static str {
        match self {
            Self::C | Self::Cpp => "c",
            Self::Fortran => "fortran",
            Self::Python => "numpy",
        }
    }

    fn extension(self) -> &'static str {
        match self {
            Self::C => "c",
            Self::Cpp => "cpp",
            Self::Fortran => "f90",
            Self::Python => "py",
        }
    }

    /// Whether everything needed is available; if not, a message says so. Python may lack NumPy even if compilers are required.
    pub fn is_here(self) -> bool {
        match self {
            Self::C => is_here("gcc"),
            Self::Cpp => is_here("g++"),
            Self::Fortran => is_here("gfortran"),
            Self::Python => {
                let numpy = Command::new("python3").args(["-c", "import numpy"]).output();
                let is_here = numpy.is_ok_and(|output| output.status.success());
                if !is_here {
                    eprintln!("skipped: there is no NumPy");
                }
                is_here
            }
        }
    }

    /// The text after which inputs are known, and the text before which results are.
    fn sites(self) -> [&'static str; 2] {
        match self {
            Self::C | Self::Cpp => {
                ["        if (yours(", "        for (int i = 0; i < outputs; ++i) printf(\" %.17g\", y[i]);"]
            }
            Self::Fortran => ["        call yours(", "            write (*, '(*(es"],
            Self::Python => ["    try:\n", "        print(*map(repr"],
        }
    }
}

/// A port with a planted mistake: the program and its arguments.
pub fn port(bench: &Bench, lang: Lang, id: &str, plant: Plant) -> Vec<String> {
    let folder = bench.path(&format!("{}-{id}", lang.name()));
    let stem = id.replace('.', "_");
    bench.run(&["export", "--lang", lang.exported(), "--filter", id, "--out", folder.to_str().unwrap()]).exits(0);
    let ran = bench.run(&["check", "--formula", id, "--driver", lang.name(), "--exported"]).quiet();
    let driver = planted(lang, ran.stdout, plant);
    if let Plant::Within(from, to) = plant {
        let mut found = false;
        for file in fs::read_dir(&folder).unwrap().map(|file| file.unwrap().path()) {
            if file.file_stem().unwrap().to_str().unwrap().starts_with(&format!("jp_{stem}")) {
                let text = fs::read_to_string(&file).unwrap();
                found |= text.contains(from);
                fs::write(&file, text.replace(from, to)).unwrap();
            }
        }
        assert!(found, "{from:?} is not in the export of {id}");
    }
    let file = folder.join(format!("port.{}", lang.extension()));
    fs::write(&file, driver).unwrap();
    compile(lang, &folder, &stem)
}

fn planted(lang: Lang, driver: String, plant: Plant) -> String {
    let [before, after] = lang.sites();
    let (from, to) = match plant {
        Plant::Nothing | Plant::Within(..) => return driver,
        Plant::Before(code) if lang == Lang::Python => (before, format!("{before}        {code}\n")),
        Plant::Before(code) => (before, format!("        {code}\n{before}")),
        Plant::After(code) => (after, format!("        {code}\n{after}")),
        Plant::Driver(from, to) => (from, to.to_owned()),
    };
    assert_eq!(driver.matches(from).count(), 1, "{from:?} is not once in\n{driver}");
    driver.replace(from, &to)
}

/// The sources of an export whose names start with `stem`.
pub fn sources(folder: &PathBuf, stem: &str, extension: &str) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
    let is_own = |name: &String| name.starts_with(&format!("jp_{stem}")) && name.ends_with(&format!(".{extension}"));
    let mut names: Vec<_> = names.filter(is_own).collect();
    // Parts come before the formula that uses them, in numerical order.
    names.sort_by_key(|name| (!name.contains("_part"), name.len(), name.clone()));
    names
}

fn compile(lang: Lang, folder: &PathBuf, stem: &str) -> Vec<String> {
    let run = |program: &str, arguments: &[&str], files: &[String]| {
        let output = Command::new(program).args(arguments).args(files).current_dir(folder).output().unwrap();
        assert!(output.status.success(), "{program} {files:?}: {}", String::from_utf8_lossy(&output.stderr));
    };
    let program = folder.join("port").to_str().unwrap().to_owned();
    let own = |name: &str| vec![name.to_owned()];
    match lang {
        Lang::C => {
            let flags =
                ["-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-pedantic", "-o", "port", "port.c"];
            run("gcc", &flags, &[sources(folder, stem, "c"), own("-lm")].concat());
        }
        Lang::Cpp => {
            run("gcc", &["-std=c99", "-O1", "-ffp-contract=off", "-c"], &sources(folder, stem, "c"));
            let objects: Vec<_> = sources(folder, stem, "c").iter().map(|name| name.replace(".c", ".o")).collect();
            let flags = ["-O1", "-Wall", "-Wextra", "-pedantic", "-Werror", "-o", "port", "port.cpp"];
            run("g++", &flags, &[objects, own("-lm")].concat());
        }
        Lang::Fortran => {
            let flags = ["-std=f2008", "-O1", "-ffp-contract=off", "-o", "port"];
            let files = [own("jp_runtime.f90"), sources(folder, stem, "f90"), own("port.f90")].concat();
            run("gfortran", &flags, &files);
        }
        Lang::Python => return ["python3".to_owned(), folder.join("port.py").to_str().unwrap().to_owned()].into(),
    }
    vec![program]
}

/// The text output of `check` for a port; the exit code is asserted.
pub fn check(bench: &Bench, id: &str, program: &[String], options: &[&str], code: i32) -> String {
    let program: Vec<_> = program.iter().map(String::as_str).collect();
    let ran = bench.run(&[&["check", "--formula", id], options, &["--"], program.as_slice()].concat());
    ran.exits(code).stdout
}
