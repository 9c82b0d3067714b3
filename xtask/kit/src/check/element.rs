//! `check --element`: a UEL against an element of the catalog, at its golden cases and at points beside them; strictly, within our
//! bounds at all golden cases, and with refusals.

mod found;
mod point;

use super::Said;
use super::driver::abi;
use super::line::Digits;
use super::peer::Peer;
use super::random::Random;
use super::violated::Conditions;
use crate::console::{bold, count, green, print, red};
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::selection;
use crate::template::filled;
use crate::uel::{Interface, len};
use found::Found;
use jointproof::catalog::AnyElement;
use jointproof::formula::Field;
use jointproof::toolkit::verify::golden::components;
use jointproof::toolkit::verify::{ElementRecord, Layout, Out};
use point::Point;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

/// Points beside each golden case.
const BESIDE: usize = 2;
/// How much larger than that of a rounding of the inputs an error may be.
const ROUNDINGS: f64 = 1e4;
/// An error that is always allowed, in parts of the largest number of its kind.
const PRECISION: f64 = 1e-10;
/// The largest length of a comment.
const WIDTH: usize = 120;
/// A rounding of a number of size 1.
const ROUNDING: f64 = 2e-16;
/// The unit of η.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The largest component of a rotation vector.
const TURN: f64 = 1.25;

/// What `--strict` asks for beyond the same element: at every golden case, with nodes that have not turned so that no input is rounded,
/// our bound of η; and refusals of what is not allowed.
fn strict_points(element: &dyn AnyElement, mapping: &Interface) -> Vec<Point> {
    let mut random = Random::new();
    let layout = &mapping.layout;
    // A golden number is rounded once.
    let bound = element.spec().bounds().0.value + 1.0;
    let point = |case: ElementRecord| {
        let rubs = layout.contact.first().is_some_and(|field| case.inputs.contains_key(field.name));
        let inputs = components(element.inputs(rubs), &case.inputs).ok()?;
        let arguments = mapping.arguments(&inputs, rubs, 0.0, &mut random);
        let Some((out, scale)) = case.out.zip(case.out_scale) else {
            // Where the first number of friction is 0 nothing rubs, and nothing is refused.
            let place = element.inputs(rubs).iter().take_while(|field| layout.contact.first() != Some(field));
            let is_off = rubs && inputs[place.map(Field::len).sum::<usize>()] == 0.0;
            let refused = Point { name: case.id, arguments, expected: Vec::new(), allowed: Vec::new() };
            return (!is_off).then_some(refused);
        };
        let [expected, mut scales] = [out, scale].map(|out| mapping.expected(&flat(&out, layout), rubs));
        if element.spec().normwise.is_some() {
            scales = largest_of_blocks(mapping, &scales);
        }
        let allowed = |scale: &Option<f64>| bound * (UNIT * scale.unwrap_or_default() + f64::from_bits(1));
        let allowed = scales.iter().map(allowed).collect();
        Some(Point { name: case.id, arguments, expected: vec![expected], allowed })
    };
    element.golden().cases.into_iter().filter_map(point).collect()
}

/// For each number the largest one of its block.
fn largest_of_blocks(mapping: &Interface, scales: &[Option<f64>]) -> Vec<Option<f64>> {
    let blocks: Vec<_> = (0..scales.len()).map(|place| mapping.block(place)).collect();
    let mut largest = BTreeMap::new();
    for (block, scale) in blocks.iter().zip(scales) {
        let most: &mut Option<f64> = largest.entry(block).or_default();
        *most = if *scale > *most { *scale } else { *most };
    }
    blocks.iter().map(|block| largest[block]).collect()
}

/// The results of an element as numbers in a row.
fn flat(out: &Out, layout: &Layout) -> Vec<f64> {
    let Out { residuals, rows, forces, stiffness, by_multipliers, after } = out;
    let after = after.as_ref().and_then(|after| components(layout.state, after).ok()).unwrap_or_default();
    [residuals.clone(), rows.concat(), forces.clone(), stiffness.concat(), by_multipliers.concat(), after].concat()
}

/// What somebody's element may do where conditions are violated, instead of what ours does.
const WAYS: [&str; 3] = [
    "",
    ", with the derivative of its conditions in AMATRX also where they are violated",
    ", with forces and AMATRX by the derivative of its conditions also where they are violated",
];

fn points(element: &dyn AnyElement, mapping: &Interface) -> Vec<Point> {
    let mut random = Random::new();
    let nodes = len(mapping.layout.nodes);
    let is_position =
        |k: usize| k >= nodes || mapping.positions.iter().any(|&from| (from..from + mapping.mcrd).contains(&k));
    let [conditions, unknowns] = [mapping.layout.residuals, mapping.layout.unknowns].map(len);
    let has_ways = mapping.triads.is_empty() && len(mapping.layout.multipliers) == conditions;
    let violated = has_ways.then(|| Conditions::new(element, conditions, unknowns)).flatten();
    let mut points = Vec::new();
    for case in element.golden().cases.iter().filter(|case| case.out.is_some()) {
        let rubs = mapping.layout.contact.first().is_some_and(|field| case.inputs.contains_key(field.name));
        let Ok(given) = components(element.inputs(rubs), &case.inputs) else { continue };
        for beside in 0..=BESIDE {
            let mut inputs = given.clone();
            if beside > 0 {
                (0..inputs.len()).filter(|&k| is_position(k)).for_each(|k| inputs[k] *= 1.0 + 0.25 * random.next());
            }
            if inputs.iter().any(|x| *x != 0.0 && !(1e-100..1e100).contains(&x.abs())) {
                continue;
            }
            let Ok(results) = element.value(&inputs, rubs) else { continue };
            let rounded = [(); 3].map(|()| {
                let moved =
                    |(k, &x): (usize, &f64)| x + ROUNDING * random.next() * if is_position(k) { x } else { 1.0 };
                let inputs: Vec<_> = inputs.iter().enumerate().map(moved).collect();
                element.value(&inputs, rubs)
            });
            let expected = mapping.expected(&results, rubs);
            let rounded: Vec<_> = rounded.iter().flatten().map(|results| mapping.expected(results, rubs)).collect();
            let allowed = |place: usize| {
                let size = expected[mapping.kind(place)].iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
                let rounding = rounded.iter().filter_map(|one| Some((one[place]? - expected[place]?).abs()));
                PRECISION * size + ROUNDINGS * rounding.fold(0.0, f64::max)
            };
            let otherwise = violated.iter().flat_map(|conditions| conditions.otherwise(&inputs, &results));
            let otherwise: Vec<_> = otherwise.map(|results| mapping.expected(&results, rubs)).collect();
            let name = if beside == 0 { case.id.clone() } else { format!("{}, varied {beside}", case.id) };
            let arguments = mapping.arguments(&inputs, rubs, TURN, &mut random);
            let allowed = (0..expected.len()).map(allowed).collect();
            points.push(Point { name, arguments, expected: [vec![expected], otherwise].concat(), allowed });
        }
    }
    points
}

/// Prints or writes the driver of an element.
///
/// # Errors
/// If there is no such element, or a file cannot be written.
pub(super) fn driver(project: &Project, id: &str, out: Option<&Path>) -> Outcome {
    let element = selection::element(project, id)?;
    let text = text(element);
    print(&match out {
        Some(folder) => abi::write_text("uel", &text, folder)?,
        None => text,
    })?;
    Ok(verdict(true))
}

fn text(element: &dyn AnyElement) -> String {
    let mapping = Interface::new(element);
    let Layout { unknowns, multipliers, start, contact, state, .. } = &mapping.layout;
    let names = |fields: &[Field]| {
        let name = |field: &Field| match field.len() {
            1 => field.name.to_owned(),
            len => format!("{}({len})", field.name),
        };
        fields.iter().map(name).collect::<Vec<_>>().join(", ")
    };
    let or_none = |text: String| if text.is_empty() { "not used".to_owned() } else { text };
    let triads = match (mapping.orientations(), mapping.mcrd) {
        (0, _) => String::new(),
        (_, 3) => "both triads at the start, e1, e2, e3 of a and of b; ".into(),
        _ => "e2 of node a at the start; ".into(),
    };
    let internal = if multipliers.is_empty() {
        "There are no multipliers.".into()
    } else {
        format!("The last node has as degrees of freedom {}; its COORDS are anything.", names(multipliers))
    };
    let props = or_none(format!("{triads}{}", names(&[*start, *contact].concat())));
    let friction = contact.first().map_or(String::new(), |field| format!("; where {} is 0 nothing rubs", field.name));
    let residuals = if multipliers.is_empty() { "" } else { ", and by how much its conditions are off" };
    let sizes = [mapping.ndofel(), mapping.nodes, mapping.mcrd, mapping.svars(), mapping.nprops()];
    let [ndofel, nnode, mcrd, nsvars, nprops] = sizes.map(|size| size.to_string());
    let id = element.spec().id;
    let values = [
        ("id", id),
        ("unknowns", &names(unknowns)),
        ("internal", &internal),
        ("props", &format!("{props}{friction}")),
        ("svars", &or_none(names(state))),
        ("residuals", residuals),
        ("ndofel", &ndofel),
        ("nnode", &nnode),
        ("mcrd", &mcrd),
        ("nsvars", &nsvars),
        ("nprops", &nprops),
    ];
    let template = filled(include_str!("driver/abi/uel_element.f90"), abi::ELEMENT);
    let template = filled(&template, &values);
    let is_note = |line: &str| line.starts_with("! ") && line.len() > WIDTH;
    let lines = template.lines().map(|line| if is_note(line) { wrapped(line) } else { line.to_owned() });
    let template = lines.collect::<Vec<_>>().join("\n");
    abi::around("UEL", &template, mapping.numbers(), &format!("check --element {id}"))
}

/// A comment in lines that are not too long.
fn wrapped(line: &str) -> String {
    let mut lines = vec!["!".to_owned()];
    for word in line.split_whitespace().skip(1) {
        let last = lines.len() - 1;
        if lines[last].len() + word.len() < WIDTH {
            lines[last].extend([" ", word]);
        } else {
            lines.push(format!("! {word}"));
        }
    }
    lines.join("\n")
}

/// Compares a routine with an element.
///
/// # Errors
/// If there is no such element, or the program cannot be started.
pub(super) fn run(
    project: &Project,
    id: &str,
    program: &[String],
    limit: Duration,
    is_strict: bool,
) -> anyhow::Result<Said> {
    let element = selection::element(project, id)?;
    let mapping = Interface::new(element);
    let mut points = points(element, &mapping);
    let beside = points.len();
    if is_strict {
        points.extend(strict_points(element, &mapping));
    }
    let [inputs, numbers] = mapping.numbers();
    let shown = |point: &Point| point.arguments.iter().map(|&x| Digits::Decimal.show(x)).collect::<Vec<_>>().join(" ");
    debug_assert!(points.iter().all(|point| point.arguments.len() == inputs), "{id}: every argument");
    let peer = Peer { command: program, limit, head: None, numbers, digits: Digits::Decimal };
    let lines: Vec<_> = points.iter().map(shown).collect();
    let found = peer.answers(&lines)?.map(|answers| Found::new(&mapping, &points, answers, is_strict));
    let is_well = found.as_ref().is_ok_and(|found| found.off == 0);
    let head = format!("{} {} by {}", if is_well { green("ok ") } else { red("off") }, bold(id), program.join(" "));
    let refused = points[beside..].iter().filter(|point| point.must_be_refused()).count();
    let claim = match &found {
        Err(why) => why.clone(),
        Ok(found) if found.off > 0 => {
            format!("it is not the element at {} of {}", found.off, count(points.len(), "point"))
        }
        Ok(found) => {
            let (how, all) = (WAYS[found.way], count(points.len(), "point"));
            let strictly = is_strict.then(|| {
                let eta = element.spec().bounds().0.value;
                let golden = count(points.len() - beside - refused, "golden case");
                format!(", within η ≤ {eta} at {golden}; all {refused} that are not allowed are refused")
            });
            let strictly = strictly.unwrap_or_default();
            format!(
                "RHS, AMATRX and SVARS are those of the element at {all}, for LFLAGS(3) = 1, 2 and 5{how}{strictly}"
            )
        }
    };
    let details = found.as_ref().map(Found::text).unwrap_or_default();
    let json = match &found {
        Ok(found) => {
            json!({ "element": id, "right": is_well, "points": points.len(), "off": found.off, "faults": found.faults, "wrong": found.wrong })
        }
        Err(why) => json!({ "element": id, "right": false, "causes": [why] }),
    };
    Ok(Said { subject: id.into(), is_well, text: format!("{head}: {claim}\n{details}"), json, claim })
}
