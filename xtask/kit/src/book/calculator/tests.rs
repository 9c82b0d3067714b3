//! A small book whose calculators are checked, unmodified and with planted faults.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use jointproof::catalog::{AnyFormula, find};
use jointproof::connector::slot;
use jointproof::contact::coulomb;
use jointproof::element;
use jointproof::toolkit::verify::golden::components;
use tempfile::TempDir;

use super::check::{Checked, DRIVE, check, use_all};
use crate::book::browser::{self, Browser};
use crate::book::build::{Options, build};
use crate::book::gather::content;
use crate::book::output::write;
use crate::export;
use crate::project::Project;

static FORMULAS: &[&dyn AnyFormula] = &[&slot::Friction, &coulomb::ReturnMap, &element::line::GeometricStiffness];

/// A book with an entry for each of these formulas.
struct Book {
    folder: TempDir,
    project: Project,
}

impl Book {
    /// `None` if there is no browser and none is required.
    fn new() -> Option<Self> {
        if !browser::is_here_or_not_required().unwrap() {
            eprintln!("skipped: chromium is not here");
            return None;
        }
        let folder = tempfile::tempdir().unwrap();
        let file = |path: &str, text: &str| write(&folder.path().join(path), text.as_bytes()).unwrap();
        file("book/book.toml", "[book]\ntitle = \"T\"\n");
        file("book/src/SUMMARY.md", "# Summary\n\n- [Zero](zero.md)\n- [One](one.md)\n");
        file("book/src/zero.md", "# Zero\n");
        let directive = |formula: &&dyn AnyFormula| format!("{{{{#formula {}}}}}\n\n", formula.spec().id);
        file("book/src/one.md", &format!("# One\n\n{}", FORMULAS.iter().map(directive).collect::<String>()));
        for formula in FORMULAS {
            let golden = format!("golden/{}.json", formula.spec().id);
            let repository = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap();
            fs::copy(repository.join(&golden), {
                file(&golden, "");
                folder.path().join(&golden)
            })
            .unwrap();
        }
        let root = folder.path().to_str().unwrap().to_owned().leak();
        let project = Project::new("small", root, FORMULAS);
        let content = content(&project, None).unwrap();
        build(folder.path(), &Options::default(), content).unwrap();
        Some(Self { folder, project })
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("target/book")
    }

    fn checked(&self, browser: &mut Browser) -> anyhow::Result<Checked> {
        use_all(&self.project, &self.out(), browser)
    }

    /// The result of the check with a text of a script replaced; the script is restored afterwards.
    fn with(&self, browser: &mut Browser, [script, from, to]: [&str; 3]) -> String {
        let path = self.out().join("calculator").join(script);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{from} is not in {text}");
        fs::write(&path, text.replace(from, to)).unwrap();
        let said = match self.checked(browser) {
            Ok(checked) => format!("{} {checked}", checked.is_well()),
            Err(error) => format!("error {error:#}"),
        };
        fs::write(&path, text).unwrap();
        said
    }
}

#[test]
fn calculators_show_the_numbers_of_rust_and_a_planted_fault_is_named() {
    let Some(book) = Book::new() else { return };
    let checked = check(&book.project, &book.out()).unwrap().expect("the browser is here");
    assert!(checked.is_well(), "{checked}");
    assert!(checked.to_string().starts_with("3 calculators: "), "{checked}");
    let mut browser = Browser::start().unwrap();
    browser.open(&book.out().join("one.html").canonicalize().unwrap()).unwrap();
    browser.evaluate(DRIVE).unwrap();
    let mut loaded = |names: [&str; 2]| -> u64 {
        let text = |name: &str| fs::read_to_string(book.out().join("calculator").join(name)).unwrap();
        let mut size =
            |name| browser.evaluate(&format!("compressed({})", serde_json::Value::from(text(name)))).unwrap();
        names.into_iter().map(|name| size(name).as_u64().unwrap()).sum()
    };
    let (page, opened) = (loaded(["calculator.js", "calculator.css"]), loaded(["runtime.js", "panel.js"]));
    assert!(page > 500 && opened > 500, "{page} and {opened} bytes");
    let said = format!("; compressed {page} bytes a page, {} with a calculator open, ", page + opened);
    assert!(checked.to_string().contains(&said), "{checked}");
    let friction = "slot.friction.js";
    for (script, from, to, said) in [
        (friction, "norm2(i.f2, i.f3)", "norm2(i.f2, i.f2)", "slot.friction, case "),
        (
            friction,
            "x >= 0.0",
            "x >= -9.0",
            "case mu-negative: it says \"\", and Rust \"mu is -1.0; allowed is a finite",
        ),
        ("coulomb.return_map.js", "return { refusal", "console.error('planted'); return { refusal", "planted"),
        ("coulomb.return_map.js", "{ 0: 3 }", "{ 0: 3.5 }", "case slip: chosen from the menu, it shows something else"),
        (
            "calculator.css",
            ".calculator .row {",
            ".calculator .row { min-width: 500px;",
            "one.html on a phone: a calculator sticks out by ",
        ),
        ("panel.js", "'aria-label': `${name}", "'aria-lable': `${name}", "has no name"),
        ("runtime.js", "Math.sqrt(sum);", "Math.sqrt(sum) * (1 + 2 ** -52);", ", expected "),
    ] {
        let found = book.with(&mut browser, [script, from, to]);
        assert!(found.starts_with("false") && found.contains(said), "{to}: {found}");
    }
    let found = book.with(&mut browser, [friction, "jointproof.define", "jointproof.defined"]);
    assert!(found.starts_with("error"), "{found}");
    // A superfluous script, and one that is too long even when compressed.
    fs::write(book.out().join("calculator/slot.more.js"), "").unwrap();
    let digits: String = (1..9000_u32).map(|k| k.wrapping_mul(2_654_435_769).to_string()).collect();
    let found = book.with(&mut browser, ["runtime.js", "'use strict';\n", &format!("'use strict';\n// {digits}\n")]);
    for said in ["4 scripts for 3 calculators", "calculators without formulas have "] {
        assert!(found.starts_with("false") && found.contains(said), "{said}: {found}");
    }
}

/// The copied calls, compiled with the export and executed, give the same bits as Rust.
#[test]
fn what_is_copied_compiles_and_gives_the_same_numbers() {
    let Some(book) = Book::new() else { return };
    let mut browser = Browser::start().unwrap();
    browser.open(&book.out().join("one.html").canonicalize().unwrap()).unwrap();
    browser.evaluate(DRIVE).unwrap();
    for formula in FORMULAS {
        let id = formula.spec().id;
        let case = formula.golden().cases.into_iter().find(|case| case.out.is_some()).unwrap();
        let point = components(formula.inputs(), &case.inputs).unwrap();
        let copies = browser.evaluate(&format!("copies('{id}', '{}')", case.id)).unwrap();
        let text = |language: &str| copies[language].as_str().unwrap().to_owned();
        assert_eq!(serde_json::from_str::<serde_json::Map<_, _>>(&text("JSON")).unwrap(), case.inputs);
        let (_, of_point) =
            text("--point").split_once('\'').map(|(head, tail)| (head.to_owned(), tail.to_owned())).unwrap();
        assert_eq!(of_point.trim_end().trim_end_matches('\''), text("JSON").trim_end());
        let (value, jacobian) = find(id).unwrap().value_and_jacobian(&point).unwrap();
        let numbers = if formula.spec().is_closed() { &jacobian[..] } else { &value[..formula.outputs()[0].len()] };
        let expected: Vec<_> = numbers.iter().map(|x| x.to_bits().cast_signed()).collect();
        assert_eq!(run_c(&book, *formula, &text("C")), expected, "{}", text("C"));
        assert_eq!(run_fortran(&book, *formula, &text("Fortran")), expected, "{}", text("Fortran"));
    }
}

/// The numbers compared: the Jacobian, or the first output if it is automatic.
fn compared(formula: &dyn AnyFormula) -> &'static str {
    if formula.spec().is_closed() { "jacobian" } else { formula.outputs()[0].name }
}

fn run_c(book: &Book, formula: &'static dyn AnyFormula, call: &str) -> Vec<i64> {
    let of = compared(formula);
    let main = format!(
        "#include \"jointproof.h\"\n#include <stdio.h>\n#include <string.h>\nint main(void)\n{{\n{call}\
         for (unsigned k = 0; code == 0 && k < sizeof {of} / sizeof *{of}; ++k) {{\n\
         long long bits; memcpy(&bits, {of} + k, 8); printf(\"%lld\\n\", bits); }}\nreturn code;\n}}\n"
    );
    ran(book, formula, "c", ("main.c", &main), "gcc -std=c99 -ffp-contract=off jp_*.c main.c -lm -o run && ./run")
}

fn run_fortran(book: &Book, formula: &'static dyn AnyFormula, call: &str) -> Vec<i64> {
    let of = compared(formula);
    let (declared, called) = call.split_once("code = ").unwrap();
    // Row by row.
    let flat = if of == "jacobian" { format!("reshape(transpose({of}), [size({of})])") } else { format!("[{of}]") };
    let main = format!(
        "program main\nuse jointproof\nuse iso_fortran_env, only: int64\nimplicit none\n{declared}integer :: k\n\
         real(dp), allocatable :: flat(:)\ncode = {called}flat = {flat}\n\
         do k = 1, size(flat)\nprint '(i0)', transfer(flat(k), 0_int64)\nend do\nend program\n"
    );
    let build = "gfortran -ffp-contract=off jp_runtime.f90 $(ls jp_*.f90 | grep -v runtime) jointproof.f90 main.f90 -o run && ./run";
    ran(book, formula, "fortran", ("main.f90", &main), build)
}

fn ran(book: &Book, formula: &'static dyn AnyFormula, lang: &str, (name, main): (&str, &str), build: &str) -> Vec<i64> {
    let folder = book.folder.path().join(format!("{lang}-{}", formula.spec().id));
    for (name, text) in export::files_in(lang, &[formula]) {
        write(&folder.join(name), text.as_bytes()).unwrap();
    }
    write(&folder.join(name), main.as_bytes()).unwrap();
    let output = Command::new("sh").args(["-c", build]).current_dir(&folder).output().unwrap();
    assert!(output.status.success(), "{}\n{main}", String::from_utf8_lossy(&output.stderr));
    let numbers = String::from_utf8(output.stdout).unwrap();
    numbers.lines().map(|line| line.parse().unwrap()).collect()
}
