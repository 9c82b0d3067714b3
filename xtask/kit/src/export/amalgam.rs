//! Each formula and each element in one file that needs no other: what the book has to download.

use super::c;
use super::fortran;
use super::javascript::{self, JavaScript};
use super::numpy;
use super::program::functions_of;
use super::recorded::{Recorded, Subject, record};
use super::shell::{self, File, Shell};
use crate::project::Project;
use jointproof::catalog::AnyForm;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A file of a formula or an element.
#[derive(Clone, Debug)]
pub(crate) struct Download {
    /// The identifier of the formula, or of the element.
    pub(crate) id: &'static str,
    pub(crate) is_element: bool,
    /// The language, and for an element whether it has friction.
    pub(crate) label: String,
    pub(crate) name: String,
    pub(crate) text: String,
}

/// The files of all formulas and elements of a project that can be exported.
pub(crate) fn downloads(project: &Project) -> Vec<Download> {
    let formulas = project.catalog().iter().map(|&formula| Subject::Formula(formula));
    let elements = project.elements().iter().flat_map(|&element| Subject::forms(element));
    let subjects: Vec<_> = formulas.chain(elements).collect();
    let (recorded, _) = record(&subjects, Some(project));
    let elements = project.elements().iter().map(|&element| (Shell::Uel, Some(element as &dyn AnyForm)));
    let shells: Vec<_> =
        elements.chain([Shell::Fric, Shell::Mpc, Shell::UmpcUser].map(|shell| (shell, None))).collect();
    let routines = shells.par_iter().flat_map_iter(|&(shell, element)| routine(project, shell, element));
    routines.chain(recorded.par_iter().flat_map_iter(of)).collect()
}

/// A user routine in both forms of Fortran; none if it cannot be exported.
fn routine(project: &Project, shell: Shell, element: Option<&'static dyn AnyForm>) -> Vec<Download> {
    let elements: Vec<_> = element.into_iter().collect();
    let download = |is_fixed| {
        let File { of, name, text } = shell::file(project, shell, &elements, is_fixed).ok()?;
        let label = format!("{}{}", shell.routine(), if is_fixed { " in fixed form" } else { "" });
        Some(Download { id: of, is_element: element.is_some(), label, name, text })
    };
    [false, true].into_iter().filter_map(download).collect()
}

/// The files of one of them, by language.
fn of(one: &Recorded) -> Vec<Download> {
    let (label, is_element) = match one.subject {
        Subject::Formula(_) => ("", false),
        Subject::Element(_, rubs) => (if rubs { " with friction" } else { "" }, true),
    };
    let download = |(language, extension, text): (&str, &str, String)| Download {
        id: one.subject.spec().id,
        is_element,
        label: format!("{language}{label}"),
        name: format!("jp_{}.{extension}", one.subject.stem()),
        text,
    };
    let files = [
        ("C", "c", in_c(one)),
        ("Fortran", "f90", in_fortran(one)),
        ("JavaScript", "mjs", in_javascript(one)),
        ("NumPy", "py", in_numpy(one)),
    ];
    files.map(download).into()
}

/// The headers, and the functions.
fn in_c(one: &Recorded) -> String {
    let [(_, source), (_, header)] = c::files_of(one);
    let includes = |line: &&str| !line.starts_with("#include \"jp_");
    let texts = [c::ARRAYS, c::RUNTIME, &header, &source];
    joined(texts.map(|text| text.lines().filter(includes).flat_map(|line| [line, "\n"]).collect()))
}

/// The runtime, whose module has a name of its own, and the module.
fn in_fortran(one: &Recorded) -> String {
    let modules = [fortran::RUNTIME.to_owned(), fortran::module_of(one)];
    joined(modules).replace("jp_runtime", &format!("jp_runtime_{}", one.subject.stem()))
}

/// One module, which exports what the module of the formula or element does.
fn in_javascript(one: &Recorded) -> String {
    let private = |text: &str| text.replace("\nexport const ", "\nconst ").replace("\nexport function ", "\nfunction ");
    let runtime = private(javascript::RUNTIME).replace("\nfunction refused(", "\nexport function refused(");
    let module = javascript::module(one, functions_of(&JavaScript, one));
    joined([runtime, without_imports(&module)])
}

/// A module without its imports, which end with a semicolon.
fn without_imports(text: &str) -> String {
    let mut is_import = false;
    let is_kept = |line: &&str| {
        is_import |= line.starts_with("import ");
        let is_kept = !is_import;
        is_import &= !line.ends_with(';');
        is_kept
    };
    text.lines().filter(is_kept).flat_map(|line| [line, "\n"]).collect()
}

/// One module: its description, the runtime, and the functions.
fn in_numpy(one: &Recorded) -> String {
    let text = numpy::source(one);
    let (head, rest) = text.split_once("\nfrom jp_runtime import (").expect("a module imports the runtime");
    let (_, functions) = rest.split_once(")\n").expect("an import ends");
    let (_, runtime) = numpy::RUNTIME.split_once("\"\"\"\n").expect("the runtime has a description");
    let runtime = runtime.replacen("import numpy as np\n", "", 1);
    joined([head.to_owned(), runtime, functions.to_owned()])
}

fn joined(texts: impl IntoIterator<Item = String>) -> String {
    texts.into_iter().collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::c::C;
    use crate::export::language::Language;
    use crate::export::recorded::{element_of, formulas};
    use crate::files;
    use jointproof::catalog::{CATALOG, ELEMENTS};
    use std::process::Command;

    /// A formula in parts, one with conditions on several inputs, one with an exact sum, and an element.
    #[test]
    fn a_file_needs_no_other() {
        let ids = ["slot.friction", "slider.eliminate", "slide_line.closest_parabolic", "universal.angles"];
        let all: Vec<_> = formulas(&ids).into_iter().chain(element_of("slot_2d")).collect();
        let folder = tempfile::tempdir().unwrap();
        let commands = [
            ("C", "cc -std=c99 -Wall -Wextra -Wpedantic -Werror -c"),
            ("C", "c++ -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -c"),
            ("Fortran", "gfortran -std=f2008 -Wall -Wextra -pedantic -Werror -c"),
            ("JavaScript", "node"),
            ("NumPy", "python3 -m py_compile"),
        ];
        for download in all.iter().flat_map(of) {
            files::write(&folder.path().join(&download.name), &download.text).unwrap();
            let of_language = commands.iter().filter(|(language, _)| download.label.starts_with(language));
            for (_, command) in of_language {
                let (program, arguments) = command.split_once(' ').unwrap_or((command, ""));
                if Command::new(program).arg("--version").output().is_err() {
                    continue;
                }
                let arguments = arguments.split_whitespace().chain([download.name.as_str()]);
                let output = Command::new(program).args(arguments).current_dir(folder.path()).output().unwrap();
                assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
            }
        }
        let names: Vec<_> =
            all.iter().flat_map(of).map(|download| format!("{} {}", download.label, download.name)).collect();
        assert!(names.contains(&"NumPy with friction jp_element_slot_2d_rubbing.py".to_owned()), "{names:?}");
    }

    /// The element with the most operations in every language, and its user routine in both forms.
    #[test]
    fn no_file_is_larger_than_a_page_would_link() {
        let project = &Project::new("downloads", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("../..");
        let element = ELEMENTS.iter().find(|element| element.spec().id == "isl22a_exponential").unwrap();
        let files = element_of("isl22a_exponential").iter().flat_map(of).collect::<Vec<_>>();
        let all: Vec<_> = files.into_iter().chain(routine(project, Shell::Uel, Some(*element))).collect();
        assert_eq!(all.len(), 10);
        for download in all {
            assert!((50_000..=400_000).contains(&download.text.len()), "{}: {}", download.name, download.text.len());
        }
    }

    /// Arithmetic that is not kept is told: by the compiler that says so, and by the test of the library.
    #[test]
    fn fast_arithmetic_is_refused() {
        if Command::new("gcc").arg("--version").output().is_err() {
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in C.files(&formulas(&["coulomb.yield"])) {
            files::write(&folder.path().join(name), &text).unwrap();
        }
        let main = "#include \"jointproof.h\"\nint main(void) { return jp_self_test(); }\n";
        files::write(&folder.path().join("main.c"), main).unwrap();
        let build = |flags: &str| {
            let arguments = flags.split(' ').chain(["-O2", "main.c", "jp_self_test.c", "-lm", "-o", "main"]);
            Command::new("gcc").args(arguments).current_dir(folder.path()).output().unwrap()
        };
        let run = || Command::new(folder.path().join("main")).status().unwrap().code();
        let output = build("-ffast-math");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains("-ffast-math changes the results"), "{said}");
        assert!(build("-std=c99 -ffp-contract=off").status.success());
        assert_eq!(run(), Some(0));
        // The options of -ffast-math that reorder sums, without its macro.
        assert!(build("-fassociative-math -fno-signed-zeros -fno-trapping-math").status.success());
        assert_eq!(run(), Some(1));
    }

    #[test]
    fn numpy_refuses_what_c_refuses() {
        let has_numpy = Command::new("python3").args(["-c", "import numpy"]).output();
        if !has_numpy.is_ok_and(|output| output.status.success()) {
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        for download in of(&formulas(&["coulomb.return_map"])[0]) {
            files::write(&folder.path().join(download.name), &download.text).unwrap();
        }
        let said = |call: &str| {
            let program = format!("import jp_coulomb_return_map as jp; print(jp.{call})");
            let output = Command::new("python3").args(["-c", &program]).current_dir(folder.path()).output().unwrap();
            String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()
        };
        assert!(said("value(3.0, 0.5, 4.0)").contains("[2.]"), "{}", said("value(3.0, 0.5, 4.0)"));
        for function in ["value", "jacobian"] {
            let said = said(&format!("{function}(3.0, [0.5, -1.0], 4.0)"));
            assert!(said.contains("ValueError: required is mu: ") && said.contains("which is -1.0 at (1,)"), "{said}");
        }
    }

    #[test]
    fn imports_are_left_out_to_their_end() {
        assert_eq!(
            without_imports("// a\nimport {\n    b,\n} from './c';\nimport d from './e';\nf();\n"),
            "// a\nf();\n"
        );
    }
}
