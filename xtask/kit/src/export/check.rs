//! The export compiled, run, and compared bit by bit.

use super::language::{Language, Toolchain};
use super::points::{Expected, Point};
use super::recorded::{Function, Output, Recorded, Shape, Subject};
use crate::console::{count as counted, say};
use anyhow::{Context, ensure};
use jointproof::catalog::Rotations;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Op};
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;
use std::process::Command;

/// The result of a comparison.
pub(super) struct Judged {
    toolchain: &'static str,
    compared: usize,
    differ: usize,
    /// Differences within the tolerance for the functions of the language: by formula or element, how many, and the largest, in
    /// units of the distance from 1 to the next number, or of the number's own if that is larger.
    near: BTreeMap<String, (usize, f64)>,
    refused: usize,
    worst: Option<String>,
}

impl Judged {
    pub(super) fn is_well(&self) -> bool {
        self.compared > 0 && self.differ == 0
    }
}

impl fmt::Display for Judged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { toolchain, compared, differ, near, refused, worst } = self;
        write!(f, "{toolchain}: {}, {differ} differ", counted(*compared, "number"))?;
        let all: usize = near.values().map(|(count, _)| count).sum();
        if all > 0 {
            write!(f, ", {all} by functions of the language alone")?;
        }
        write!(f, "; {refused} refused alike")?;
        for (id, (count, largest)) in near {
            write!(f, "\n    {id}: {}, by {largest:.1} ulp at most", counted(*count, "number"))?;
        }
        worst.iter().try_for_each(|worst| write!(f, "\n    {worst}"))
    }
}

/// Every available toolchain.
pub(super) fn all(
    language: &dyn Language,
    folder: &Path,
    recorded: &[Recorded],
    points: &[Vec<Point>],
) -> anyhow::Result<Vec<Judged>> {
    ensure!(!language.toolchains().is_empty(), "nothing here runs this format: it is read by other tools");
    // The driver is started in the folder, by its absolute path.
    let folder = &folder.canonicalize()?;
    write_points(folder, points)?;
    let mut judged = Vec::new();
    for toolchain in language.toolchains() {
        if Command::new(toolchain.name).arg("--version").output().is_err() {
            say(&format!("{} is not here: not compared with it", toolchain.name));
            continue;
        }
        for command in &toolchain.commands {
            run(folder, command)?;
        }
        let found = std::fs::read(folder.join("found.bin")).context("the driver wrote no results")?;
        judged.push(compare(&toolchain, recorded, points, &found)?);
    }
    ensure!(!judged.is_empty(), "no compiler or interpreter of the language is here");
    Ok(judged)
}

fn run(folder: &Path, command: &[String]) -> anyhow::Result<()> {
    let (program, arguments) = command.split_first().context("a command has a program")?;
    let path = if program.starts_with("./") { folder.join(program) } else { program.into() };
    let output = Command::new(&path).args(arguments).current_dir(folder).output();
    let output = output.with_context(|| format!("{} cannot be started", path.display()))?;
    let said = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{} failed:\n{said}", command.join(" "));
    Ok(())
}

/// For every formula and every element the number of points, and the inputs of each, as little-endian doubles.
fn write_points(folder: &Path, points: &[Vec<Point>]) -> anyhow::Result<()> {
    let mut bytes = Vec::new();
    for points in points {
        bytes.extend(u64::try_from(points.len())?.to_le_bytes());
        bytes.extend(points.iter().flat_map(|point| &point.inputs).flat_map(|x| x.to_le_bytes()));
    }
    std::fs::write(folder.join("points.bin"), bytes)?;
    Ok(())
}

/// Compares the driver's output: for every point a return code as a double, and all results.
fn compare(
    toolchain: &Toolchain,
    recorded: &[Recorded],
    points: &[Vec<Point>],
    found: &[u8],
) -> anyhow::Result<Judged> {
    let mut found = found.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
    let mut judged =
        Judged { toolchain: toolchain.name, compared: 0, differ: 0, near: BTreeMap::new(), refused: 0, worst: None };
    for (one, points) in recorded.iter().zip(points) {
        let Function { outputs, .. } = one.largest_function();
        let numbers = outputs.iter().map(Output::len).sum();
        for point in points {
            let code = found.next().context("the driver wrote too few results")?;
            let results: Vec<_> = found.by_ref().take(numbers).collect();
            ensure!(results.len() == numbers, "the driver wrote too few results");
            let expected = match &point.expected {
                Expected::TooLarge => continue,
                Expected::Refused(expected) => {
                    judged.refusal(one, point, [code, f64::from(*expected)]);
                    continue;
                }
                Expected::Results(_) if code != 0.0 => {
                    judged.off(one, point, &refusal(code));
                    continue;
                }
                Expected::Results(results) => results,
            };
            let sizes = outputs.iter().flat_map(|output| sizes(one, output, expected));
            for (k, ((&found, &expected), size)) in results.iter().zip(expected).zip(sizes).enumerate() {
                judged.number(toolchain, (one, point), k, [found, expected], size);
            }
        }
    }
    Ok(judged)
}

impl Judged {
    fn number(
        &mut self,
        toolchain: &Toolchain,
        (one, point): (&Recorded, &Point),
        k: usize,
        [found, expected]: [f64; 2],
        size: f64,
    ) {
        self.compared += 1;
        if found.to_bits() == expected.to_bits() {
            return;
        }
        if is_near(one, toolchain.epsilons, [found, expected], size) {
            let (count, largest) = self.near.entry(one.subject.to_string()).or_default();
            *count += 1;
            *largest = largest.max((found - expected).abs() / (f64::EPSILON * size.max(1.0)));
            return;
        }
        self.off(one, point, &format!("{}: {found:e}, expected {expected:e}", entry(one, k)));
    }

    fn refusal(&mut self, one: &Recorded, point: &Point, [found, expected]: [f64; 2]) {
        self.refused += 1;
        if found != expected {
            self.off(one, point, &format!("gives the return code {found}, expected is the refusal {expected}"));
        }
    }

    fn off(&mut self, one: &Recorded, point: &Point, what: &str) {
        self.differ += 1;
        self.worst.get_or_insert_with(|| format!("{} at {}: {what}", one.subject, point.name));
    }
}

/// A non-zero return code; the driver returns −1 if the two functions disagree.
fn refusal(code: f64) -> String {
    if code < 0.0 {
        return "the function for the value gives another one than the function with all results".into();
    }
    format!("refuses input {code}, which is valid")
}

/// The sizes by which the numbers of an output are judged: their own, and that of the largest where the rows or the matrix of an
/// element were multiplied by the matrices of other unknowns, since then terms of that size cancel.
fn sizes(one: &Recorded, output: &Output, expected: &[f64]) -> Vec<f64> {
    let own = expected[output.first..output.first + output.len()].iter().map(|x| x.abs());
    match one.subject {
        Subject::Element(element, _) if element.form().rotations != Rotations::Spins => {
            vec![own.fold(0.0, f64::max); output.len()]
        }
        _ => own.collect(),
    }
}

/// Whether a number, among others of this size, is within the tolerance for results computed with a function of the language, such
/// as the sine.
pub(super) fn is_near(one: &Recorded, epsilons: f64, [found, expected]: [f64; 2], size: f64) -> bool {
    (found - expected).abs() <= f64::EPSILON * epsilons * (1.0 + size) && has_functions(one)
}

/// Whether it calls functions that languages round differently.
fn has_functions(one: &Recorded) -> bool {
    use jointproof::toolkit::graph::Unary::{Cosine, Exponential, ExponentialMinusOne, Sine};
    one.graph.ops().iter().any(|op| match op {
        Op::Unary(function, _) => matches!(function, Sine | Cosine | Exponential | ExponentialMinusOne),
        Op::Binary(operation, ..) => *operation == Binary::Angle,
        _ => false,
    })
}

/// The name of a number among the outputs: a component, a derivative, or an entry of a matrix.
pub(super) fn entry(one: &Recorded, mut k: usize) -> String {
    let names = |fields: &[Field]| -> Vec<String> {
        let of = |field: &Field| match field.len() {
            1 => vec![field.name.to_owned()],
            len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
        };
        fields.iter().flat_map(of).collect()
    };
    for output in one.largest_function().outputs {
        if k < output.len() {
            return match (output.shape, one.subject) {
                (Shape::Number, _) => output.name.to_owned(),
                (Shape::Vector(_), _) => format!("{}[{k}]", output.name),
                (Shape::Matrix(_, columns), Subject::Formula(formula)) => {
                    let (outputs, inputs) = (names(formula.outputs()), names(formula.inputs()));
                    format!("∂{}/∂{}", outputs[k / columns], inputs[k % columns])
                }
                (Shape::Matrix(_, columns), _) => format!("{}[{}, {}]", output.name, k / columns, k % columns),
            };
        }
        k -= output.len();
    }
    unreachable!("there are as many results as the outputs have numbers")
}

#[cfg(test)]
mod tests {
    use super::super::c::C;
    use super::super::fortran::Fortran;
    use super::super::javascript::JavaScript;
    use super::super::numpy::NumPy;
    use super::super::points;
    use super::super::recorded::{element_of, formulas, record};
    use super::*;
    use crate::files;
    use jointproof::catalog::{ELEMENTS, Form, find};
    use jointproof::toolkit::graph::{Instead, Unary};

    /// The report of the check for an export in which a text of a file is replaced by another.
    fn judged(id: &str, file: &str, from: &str, to: &str) -> String {
        let folder = tempfile::tempdir().unwrap();
        let recorded = formulas(&[id]);
        for (name, text) in C.files(&recorded) {
            let planted = if name == file { text.replace(from, to) } else { text.clone() };
            assert_eq!(name == file, planted != text, "{from} is not in {name}");
            files::write(&folder.path().join(name), &planted).unwrap();
        }
        let points = points::all(&recorded, 20);
        let judged = all(&C, folder.path(), &recorded, &points).unwrap();
        let said: Vec<_> = judged.iter().map(|judged| format!("{} {judged}", judged.is_well())).collect();
        said.join("\n")
    }

    #[test]
    fn a_changed_operation_is_named_with_formula_entry_and_point() {
        let said = judged("slot.contact_force", "jp_slot_contact_force.c", "jp_norm2(f2, f3)", "jp_norm2(f2, f2)");
        assert!(said.starts_with("false") && said.contains("slot.contact_force at "), "{said}");
        assert!(said.contains(": fc: ") || said.contains(": ∂fc/∂f2: "), "{said}");
    }

    /// Each language rounds by its own function or by that of its runtime, also beside halves and where integers are all.
    #[test]
    fn the_nearest_integer_has_the_same_bits_in_every_language() {
        let mut recorded = formulas(&["slot.contact_force"]);
        let graph = &mut recorded[0].graph;
        let f2 = graph.needed(&graph.value).into_iter().find(|&node| *graph.op(node) == Op::Input(0)).unwrap();
        *graph = graph.altered(graph.value[0], &Instead::Op(Op::Unary(Unary::NearestInteger, f2)));
        graph.jacobian = graph.value.repeat(2);
        let sizes =
            [0.0, 0.25, 0.5_f64.next_down(), 0.5, 1.0, 1.5, 2.5, 2.5_f64.next_up(), 4_503_599_627_370_495.5, 1e300];
        let point = |inputs: Vec<f64>| {
            let (value, jacobian) = recorded[0].graph.run(&inputs);
            Point { name: String::new(), inputs, expected: Expected::Results([value, jacobian].concat()) }
        };
        let points = vec![sizes.into_iter().flat_map(|x| [x, -x]).map(|x| point(vec![x, 1.0])).collect::<Vec<_>>()];
        let numpy = Command::new("python3").args(["-c", "import numpy"]).output();
        let numpy = numpy.is_ok_and(|output| output.status.success()).then_some(&NumPy as &dyn Language);
        for language in [&C as &dyn Language, &Fortran, &JavaScript].into_iter().chain(numpy) {
            let folder = tempfile::tempdir().unwrap();
            for (name, text) in language.files(&recorded) {
                files::write(&folder.path().join(name), &text).unwrap();
            }
            for judged in all(language, folder.path(), &recorded, &points).unwrap() {
                assert!(judged.is_well() && judged.compared == 60, "{judged}");
            }
        }
    }

    #[test]
    fn what_is_off_by_functions_of_the_language_is_counted() {
        let recorded = formulas(&["interaction.pressure_exponential"]);
        let points = points::all(&recorded, 1);
        let toolchain = Toolchain { name: "node", commands: Vec::new(), epsilons: 4.0 };
        let mut judged =
            Judged { toolchain: "node", compared: 0, differ: 0, near: BTreeMap::new(), refused: 0, worst: None };
        for found in [1.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 1.0 + 16.0 * f64::EPSILON] {
            judged.number(&toolchain, (&recorded[0], &points[0][0]), 0, [found, 1.0], 1.0);
        }
        let said = judged.to_string();
        assert!(
            said.starts_with("node: 4 numbers, 1 differ, 2 by functions of the language alone; 0 refused"),
            "{said}"
        );
        assert!(said.contains("interaction.pressure_exponential: 2 numbers, by 1.0 ulp at most"), "{said}");
    }

    fn nothing() -> Judged {
        Judged { toolchain: "node", compared: 0, differ: 0, near: BTreeMap::new(), refused: 0, worst: None }
    }

    #[test]
    fn all_is_well_where_something_was_compared_and_nothing_differs() {
        let is_well = |compared, differ| Judged { compared, differ, ..nothing() }.is_well();
        assert!(is_well(1, 0) && is_well(9, 0));
        assert!(!is_well(0, 0) && !is_well(9, 1) && !is_well(9, 9));
    }

    #[test]
    fn how_far_off_functions_are_is_in_units_of_1_or_of_what_is_larger() {
        let recorded = formulas(&["interaction.pressure_exponential"]);
        let points = points::all(&recorded, 1);
        let toolchain = Toolchain { name: "node", commands: Vec::new(), epsilons: 4.0 };
        let largest = |found: f64, expected: f64| {
            let mut judged = nothing();
            judged.number(&toolchain, (&recorded[0], &points[0][0]), 0, [found, expected], expected.abs());
            judged.near.into_values().next()
        };
        let unit = f64::EPSILON;
        assert_eq!(largest(-4.0 - 8.0 * unit, -4.0), Some((1, 2.0)));
        assert_eq!(largest(0.5 - 3.0 * unit, 0.5), Some((1, 3.0)));
        assert_eq!(largest(-4.0 - 40.0 * unit, -4.0), None);
        assert_eq!(largest(0.5, 0.5), None);
    }

    /// A formula with a value and two entries, at three points: one with results, one rejected, one too large.
    #[test]
    fn what_a_driver_wrote_is_compared_point_by_point() {
        let recorded = formulas(&["slot.contact_force"]);
        let toolchain = Toolchain { name: "gcc", commands: Vec::new(), epsilons: 0.0 };
        let points = || {
            let point = |name: &str, expected| Point { name: name.into(), inputs: vec![3.0, 4.0], expected };
            let results = Expected::Results(vec![5.0, 0.5, 0.75]);
            vec![vec![point("a", results), point("b", Expected::Refused(2)), point("c", Expected::TooLarge)]]
        };
        let compared = |found: &[f64]| {
            let bytes: Vec<_> = found.iter().flat_map(|x| x.to_le_bytes()).collect();
            compare(&toolchain, &recorded, &points(), &bytes).map(|judged| (judged.is_well(), judged.to_string()))
        };
        let [well, refused, large] = [[0.0, 5.0, 0.5, 0.75], [2.0, 9.0, 9.0, 9.0], [7.0; 4]];
        let of = |points: [[f64; 4]; 3]| compared(points.as_flattened()).unwrap();
        assert_eq!(of([well, refused, large]), (true, "gcc: 3 numbers, 0 differ; 1 refused alike".into()));
        let off = |numbers, differ, what: &str| {
            let said = format!("gcc: {numbers}, {differ} differ; 1 refused alike\n    slot.contact_force at {what}");
            (false, said)
        };
        let other = [0.0, 5.0, 0.25, 0.5];
        assert_eq!(of([other, refused, large]), off("3 numbers", 2, "a: ∂fc/∂f2: 2.5e-1, expected 5e-1"));
        let valid = off("0 numbers", 1, "a: refuses input 1, which is valid");
        assert_eq!(of([[1.0, 5.0, 0.5, 0.75], refused, large]), valid);
        let two =
            off("0 numbers", 1, "a: the function for the value gives another one than the function with all results");
        assert_eq!(of([[-1.0, 5.0, 0.5, 0.75], refused, large]), two);
        let another = off("3 numbers", 1, "b: gives the return code 1, expected is the refusal 2");
        assert_eq!(of([well, [1.0; 4], large]), another);
        for short in [&well[..2], &[well, refused].as_flattened()[..5], &[well, refused].concat()] {
            assert_eq!(compared(short).unwrap_err().to_string(), "the driver wrote too few results");
        }
    }

    #[test]
    fn entries_are_named_by_outputs_and_inputs_and_their_components() {
        let named = |id: &str, all: std::ops::Range<usize>| {
            let recorded = formulas(&[id]);
            all.map(|k| entry(&recorded[0], k)).collect::<Vec<_>>()
        };
        assert_eq!(named("slot.contact_force", 0..3), ["fc", "∂fc/∂f2", "∂fc/∂f3"]);
        let line = named("slider.line", 0..17);
        assert_eq!(line[..4], ["n[0]", "n[1]", "n[2]", "l"]);
        assert_eq!(line[4..6], ["∂n[0]/∂x1[0]", "∂n[0]/∂x1[1]"]);
        assert_eq!(line[9..11], ["∂n[0]/∂xn[2]", "∂n[1]/∂x1[0]"]);
    }

    #[test]
    fn an_entry_of_a_matrix_of_an_element_is_named() {
        let recorded = element_of("slot_2d");
        let points = points::all(&recorded, 5);
        let folder = tempfile::tempdir().unwrap();
        let files = |from: &str, to: &str| {
            for (name, text) in C.files(&recorded) {
                let text = if name == "jp_element_slot_2d_rubbing.c" { text.replace(from, to) } else { text };
                files::write(&folder.path().join(name), &text).unwrap();
            }
            all(&C, folder.path(), &recorded, &points).unwrap().remove(0)
        };
        let right = files("", "");
        assert!(right.is_well() && right.refused > 0, "{right}");
        let wrong = files("stiffness[1] = ", "stiffness[1] = 1.0 + ").to_string();
        assert!(
            wrong.contains("element slot_2d with friction at ") && wrong.contains(": stiffness[0, 1]: "),
            "{wrong}"
        );
    }

    #[test]
    fn a_penalty_of_the_other_sign_is_found() {
        let slot = ELEMENTS.iter().find(|element| element.spec().id == "slot_2d").unwrap();
        let form = Form { has_penalties: true, ..Form::default() };
        let (recorded, _) = record(&[Subject::Element(slot.in_form(form).unwrap(), false)], None);
        let points = points::all(&recorded, 20);
        let folder = tempfile::tempdir().unwrap();
        let well = |sign: &str| {
            for (name, text) in C.files(&recorded) {
                let text = text
                    .replace("kappa * ", &format!("{sign}kappa * "))
                    .replace(" * kappa", &format!(" * {sign}kappa"));
                files::write(&folder.path().join(name), &text).unwrap();
            }
            all(&C, folder.path(), &recorded, &points).unwrap().iter().all(Judged::is_well)
        };
        assert!(well("") && !well("-"));
    }

    #[test]
    fn another_refusal_is_named() {
        let said = judged("slider.line", "jp_slider_line.c", "return 2 + (int)", "return 1 + (int)");
        assert!(
            said.starts_with("false") && said.contains("gives the return code 2, expected is the refusal 3"),
            "{said}"
        );
    }

    #[test]
    fn functions_of_a_language_may_be_off_in_units_of_what_is_larger_1_or_the_number() {
        let is_near = |id, found: f64, expected| {
            let recorded = formulas(&[id]);
            is_near(&recorded[0], 4.0, [found, expected], expected.abs())
        };
        let calling = "interaction.pressure_exponential";
        assert!(is_near(calling, 1.0 + 8.0 * f64::EPSILON, 1.0) && !is_near(calling, 1.0 + 9.0 * f64::EPSILON, 1.0));
        assert!(is_near(calling, -3.0 + 16.0 * f64::EPSILON, -3.0) && is_near(calling, 4.0 * f64::EPSILON, 0.0));
        assert!(!is_near("slot.contact_force", 1.0 + f64::EPSILON, 1.0));
    }

    #[test]
    fn the_head_of_a_file_says_what_the_formula_is() {
        let formula = find("slot.contact_force").unwrap();
        let recorded = formulas(&[formula.spec().id]);
        for language in [&C as &dyn Language, &Fortran, &JavaScript, &NumPy] {
            let files = language.files(&recorded);
            let (name, text) = files.iter().find(|(name, _)| name.starts_with("jp_slot_contact_force")).unwrap();
            for said in [formula.spec().title, formula.spec().latex, "slot.contact_force", "eta <= ", "norm2("] {
                assert!(text.contains(said), "{said} is not in {name}");
            }
        }
        let files = NumPy.files(&recorded);
        let (_, text) = files.iter().find(|(name, _)| name.starts_with("jp_slot_contact_force")).unwrap();
        assert!(text.contains("INPUTS = [\n    ('f2', 1),\n    ('f3', 1),\n]\n"), "{text}");
        assert!(text.contains("OUTPUTS = [\n    ('fc', 1),\n]\n"), "{text}");
    }

    #[test]
    fn no_line_and_no_routine_is_too_long() {
        let ids = ["ujoint.friction", "join.geometric_stiffness", "slider.increment", "cardan.angles"];
        let recorded = formulas(&ids);
        let of_fortran =
            |line: &str| ["end function", "end subroutine"].iter().any(|end| line.trim_start().starts_with(end));
        let ends = |line: &str| line == "}" || of_fortran(line);
        for language in [&C as &dyn Language, &Fortran, &JavaScript] {
            let files = language.files(&recorded);
            assert!(files == language.files(&recorded), "other files for the same formulas");
            for (name, text) in files {
                let lines: Vec<&str> = text.lines().collect();
                let longest = lines.split(|line| ends(line)).map(<[&str]>::len).max();
                assert!(longest < Some(400), "{name}: a routine of {longest:?} lines");
                assert_eq!(lines.iter().find(|line| line.chars().count() > 100), None, "{name}");
            }
        }
    }

    #[test]
    fn a_changed_hook_is_named_too() {
        let said = judged("slider.line", "jp_runtime.h", "(x * x + y * y) + z * z", "(x * x - y * y) + z * z");
        assert!(said.starts_with("false") && said.contains("slider.line at "), "{said}");
    }

    #[test]
    fn a_refusal_too_many_is_named() {
        let said = judged("slot.normal_force", "jp_slot_normal_force.c", "<= DBL_MAX", "<= 1.0");
        assert!(said.starts_with("false") && said.contains("refuses input 1, which is valid"), "{said}");
    }
}
