//! The formulas that the sheet of an element names are those of the element: their values make up its results.

use crate::common::golden_of_element;
use jointproof::catalog::{AnyElement, ELEMENTS, find};
use jointproof::formula::Field;
use jointproof::toolkit::verify::golden::components;
use nalgebra::{Vector2, Vector3};
use std::collections::BTreeMap;

mod contact;

/// Numbers by the names of fields.
type Named = BTreeMap<&'static str, Vec<f64>>;

/// By the names of residuals, the blocks of their rows, each with its unknown.
type Labelled<'a> = BTreeMap<&'a str, Vec<(&'a str, &'a Vec<f64>)>>;

/// What a user element returns.
struct Results {
    residuals: Named,
    rows: Vec<Named>,
    forces: Named,
    /// By the names of a force and an unknown.
    stiffness: BTreeMap<(&'static str, &'static str), Vec<f64>>,
    matrix: Vec<f64>,
    after: Named,
}

fn len(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

fn named(fields: &'static [Field], numbers: &[f64]) -> Named {
    let mut rest = numbers;
    let mut next = |field: &Field| {
        let (here, behind) = rest.split_at(field.len());
        rest = behind;
        (field.name, here.to_vec())
    };
    fields.iter().map(&mut next).collect()
}

impl Results {
    fn new(element: &dyn AnyElement, inputs: &[f64], rubs: bool) -> Self {
        let (layout, all) = (element.layout(), element.value(inputs, rubs).unwrap());
        let [m, n, held] = [layout.residuals, layout.unknowns, layout.multipliers].map(len);
        let mut rest = &all[..];
        let [residuals, rows, forces, stiffness, _] = [m, m * n, n, n * n, n * held].map(|count| {
            let (here, behind) = rest.split_at(count);
            rest = behind;
            here
        });
        let mut blocks = BTreeMap::new();
        let mut row = 0;
        for force in layout.forces {
            let mut column = 0;
            for unknown in layout.unknowns {
                let block = (row..row + force.len()).flat_map(|r| &stiffness[r * n + column..][..unknown.len()]);
                blocks.insert((force.name, unknown.name), block.copied().collect());
                column += unknown.len();
            }
            row += force.len();
        }
        Self {
            residuals: named(layout.residuals, residuals),
            rows: rows.chunks(n).map(|row| named(layout.unknowns, row)).collect(),
            forces: named(layout.forces, forces),
            stiffness: blocks,
            matrix: stiffness.to_vec(),
            after: if rubs { named(layout.state, rest) } else { Named::new() },
        }
    }
}

/// The value of a formula where its inputs are; `None` if one is missing.
fn value(id: &str, given: &Named) -> Option<Named> {
    let formula = find(id).unwrap_or_else(|| panic!("there is no {id}"));
    let inputs = formula.inputs().iter().map(|field| given.get(field.name).filter(|x| x.len() == field.len()));
    let inputs = inputs.collect::<Option<Vec<_>>>()?.into_iter().flatten().copied().collect::<Vec<_>>();
    Some(named(formula.outputs(), &formula.value(&inputs).ok()?))
}

fn is_near(a: &[f64], b: &[f64]) -> bool {
    let size = b.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-11 * size)
}

/// The lists of formulas on a sheet.
fn lists(sheet: &str) -> BTreeMap<&str, Vec<&str>> {
    let lists = sheet.split(';').skip(1).filter_map(|list| list.trim().split_once(' '));
    lists.map(|(name, ids)| (name, ids.split(',').map(str::trim).collect())).collect()
}

/// The directive of a sheet: the element, and the lists of formulas.
fn directives() -> Vec<(&'static dyn AnyElement, String)> {
    let folder = format!("{}/book/src", env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("{{#element ")?.strip_suffix("}}"));
        found.extend(line.map(|line| {
            let id = line.split(';').next().unwrap_or_default().trim();
            let element = ELEMENTS.iter().find(|element| element.spec().id == id);
            (*element.unwrap_or_else(|| panic!("there is no element {id}")), line.to_owned())
        }));
    }
    found
}

/// In a pose that is drawn no number is another one by chance.
fn is_general(case: &str) -> bool {
    case.contains("random")
}

/// What HINGE puts in place of the symbols of UNIVERSAL, once for each of its two parts; the others put nothing.
fn variants(element: &str, id: &str) -> &'static [&'static [(&'static str, &'static str)]] {
    match element {
        "hinge" if id.starts_with("universal.") => {
            &[&[("e3b", "e2b"), ("lambda_rot", "lambda2")], &[("lambda_rot", "lambda3")]]
        }
        _ => &[&[]],
    }
}

/// The values of formulas, each in all variants.
fn values(element: &str, ids: &[&str], given: &Named, off: &mut Vec<String>) -> Vec<Named> {
    let mut found = Vec::new();
    // Symbols that a formula takes from the equations of others: "where n from slider.line".
    let mut given = given.clone();
    for from in ids.iter().filter_map(|id| find(id)).flat_map(|formula| formula.spec().given) {
        let outputs = value(from.from.id, &given).unwrap_or_default();
        for (name, numbers) in outputs {
            given.entry(name).or_insert(numbers);
        }
    }
    for id in ids {
        for variant in variants(element, id) {
            let mut here = given.clone();
            here.extend(variant.iter().map(|(to, from)| (*to, given[from].clone())));
            match value(id, &here) {
                Some(outputs) => found.push(outputs),
                None => off.push(format!("{id} needs what the element is not given")),
            }
        }
    }
    found
}

/// Without friction: the formulas on the sheet that are not those of the element.
fn off(element: &dyn AnyElement, sheet: &str) -> Vec<String> {
    let (id, layout, lists) = (element.spec().id, element.layout(), lists(sheet));
    let cases = golden_of_element(element).cases;
    let fields = element.inputs(false);
    let drawn = cases.iter().filter(|case| is_general(&case.id) && case.error.is_none());
    let mut smooth = drawn.filter(|case| case.inputs.len() == fields.len());
    let inputs = components(fields, &smooth.next().expect("a case has no friction").inputs).unwrap();
    let results = Results::new(element, &inputs, false);
    let mut given = named(element.inputs(false), &inputs);
    // A force of JOIN that an element does not hold is 0.
    for force in ["f1", "f2", "f3"] {
        given.entry(force).or_insert_with(|| vec![0.0]);
    }
    let mut off = Vec::new();
    let of = |list: &str| lists.get(list).cloned().unwrap_or_default();

    let mut residuals = Named::new();
    for outputs in values(id, &of("residuals"), &given, &mut off) {
        residuals.extend(outputs.into_iter().filter(|(name, _)| results.residuals.contains_key(name)));
    }
    let differ = |name: &&str| !residuals.get(name).is_some_and(|found| is_near(found, &results.residuals[name]));
    off.extend(results.residuals.keys().copied().filter(|name| differ(name)).map(|name| format!("residual {name}")));

    let rows = values(id, &of("rows"), &given, &mut off);
    let mut labelled: Vec<Labelled> = Vec::new();
    for outputs in &rows {
        let mut labels: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for (name, block) in outputs {
            let (label, unknown) = name.rsplit_once('_').unwrap();
            labels.entry(label).or_default().push((unknown, block));
        }
        labelled.push(labels);
    }
    let is_row = |row: &Named, blocks: &[(&str, &Vec<f64>)]| blocks.iter().all(|(u, block)| is_near(block, &row[u]));
    for (k, row) in results.rows.iter().enumerate() {
        let is_found = labelled.iter().any(|labels| labels.values().any(|blocks| is_row(row, blocks)));
        off.extend((!is_found).then(|| format!("row {k}")));
    }
    for labels in &labelled {
        let is_used = labels.values().any(|blocks| results.rows.iter().any(|row| is_row(row, blocks)));
        off.extend((!is_used).then(|| format!("rows {:?}", labels.keys())));
    }

    let mut forces: Named = layout.forces.iter().map(|field| (field.name, vec![0.0; field.len()])).collect();
    for outputs in values(id, &of("forces"), &given, &mut off) {
        for (name, part) in outputs {
            match forces.get_mut(name) {
                Some(force) => force.iter_mut().zip(part).for_each(|(x, y)| *x += y),
                None => off.push(format!("there is no force {name}")),
            }
        }
    }
    off.extend(
        forces.iter().filter(|(name, f)| !is_near(f, &results.forces[*name])).map(|(name, _)| (*name).to_string()),
    );

    let mut stiffness: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for outputs in values(id, &of("stiffness"), &given, &mut off) {
        for (name, part) in outputs {
            let block = stiffness.entry(name).or_insert_with(|| vec![0.0; part.len()]);
            block.iter_mut().zip(part).for_each(|(x, y)| *x += y);
        }
    }
    // The blocks of SLIDER are those of m on the line, in motions that keep it there; its matrix is said to be a Jacobian.
    if id.starts_with("slider") {
        stiffness.clear();
        let forces = of("forces").concat();
        let jacobian = find(&forces).and_then(|formula| formula.jacobian(&inputs).ok());
        let is_so = jacobian.is_some_and(|jacobian| {
            let width = inputs.len();
            let matrix: Vec<f64> =
                jacobian.chunks(width).flat_map(|row| &row[..len(layout.unknowns)]).copied().collect();
            is_near(&matrix, &results.matrix)
        });
        off.extend((!is_so).then(|| "matrix".to_owned()));
    }
    // ALIGN's other blocks are in words on its sheet.
    if of("stiffness").len() > 1 && of("stiffness").contains(&"align.geometric_stiffness") {
        stiffness.remove("k_ta_ta");
    }
    for (name, block) in &stiffness {
        let (row, column) = name[2..].split_once('_').unwrap();
        let force = layout.unknowns.iter().position(|unknown| unknown.name == row).map(|k| layout.forces[k].name);
        let of_element = force.and_then(|force| results.stiffness.iter().find(|(key, _)| **key == (force, column)));
        let is_so = of_element.is_some_and(|(_, expected)| is_near(block, expected));
        off.extend((!is_so).then(|| format!("stiffness {name}")));
    }
    off
}

/// The motion, the friction, the stick stiffness and the normal force of an element.
fn frictions(element: &str) -> &'static [[&'static str; 4]] {
    match element {
        "ujoint" => &[["ur1", "m1", "k_stick1", "mn1"], ["ur3", "m3", "k_stick3", "mn3"]],
        "hinge" => &[["ur1", "m1", "k_stick", "mn"]],
        _ => &[["u1", "f1", "k_stick", "fn"]],
    }
}

/// The documented moments, as the sheets define them by the moment on b.
fn documented(element: &str, given: &mut Named, moment: &[f64]) {
    let vector = |name: &str| Vector3::from_column_slice(&given[name]);
    let moment = Vector3::from_column_slice(moment);
    let along: Vec<(&'static str, f64)> = match element {
        "translator" => {
            ["m1", "m2", "m3"].into_iter().zip(["e1a", "e2a", "e3a"].map(|e| vector(e).dot(&moment))).collect()
        }
        "hinge" => vec![("m2", vector("e2a").dot(&moment)), ("m3", vector("e3a").dot(&moment))],
        "ujoint" => {
            let normal =
                Vector2::new(vector("e3a").dot(&vector("e3b")), -vector("e2a").dot(&vector("e3b"))).normalize();
            vec![("m2", (vector("e2a") * normal.x + vector("e3a") * normal.y).dot(&moment))]
        }
        _ => Vec::new(),
    };
    given.extend(along.into_iter().map(|(name, x)| (name, vec![x])));
}

/// With friction: what the state after the step would be by the formulas on the sheet, beside what it is.
fn friction_off(element: &dyn AnyElement, sheet: &str) -> Vec<String> {
    let (id, lists) = (element.spec().id, lists(sheet));
    let fields = element.inputs(true);
    let (mut off, mut slips) = (Vec::new(), 0);
    for case in golden_of_element(element).cases.iter().filter(|case| case.error.is_none()) {
        if !is_general(&case.id) && !case.id.contains("turned") {
            continue;
        }
        let Some(inputs) = components(fields, &case.inputs).ok().filter(|_| case.inputs.len() == fields.len()) else {
            continue;
        };
        let results = Results::new(element, &inputs, true);
        let before = named(fields, &inputs);
        let mut given = before.clone();
        // The moment on b without friction.
        let smooth = &inputs[..len(element.inputs(false))];
        let moment = Results::new(element, smooth, false).forces["mb"].clone();
        given.extend(results.after.clone());
        if moment.len() == 3 {
            documented(id, &mut given, &moment);
        } else {
            given.insert("f3", vec![0.0]);
        }
        let ids: Vec<_> = lists["friction"].iter().copied().filter(|id| *id != "coulomb.response").collect();
        // Each finds what those before have found; an order of the sheet need not be that of the computation.
        for _ in 0..ids.len() {
            let found: Vec<_> = ids.iter().filter_map(|id| value(id, &given)).flatten().collect();
            given.extend(found.into_iter().filter(|(name, _)| !before.contains_key(name)));
        }
        for [motion, friction, stick, normal] in frictions(id) {
            let Some(normal) = given.get(normal) else {
                off.push(format!("{}: no {normal}", case.id));
                continue;
            };
            let [du, f_before] = [results.after[motion][0] - before[motion][0], before[friction][0]];
            let sliding = [("du", du), ("f_before", f_before), ("k_stick", before[stick][0])];
            let mut sliding: Named = sliding.into_iter().map(|(name, x)| (name, vec![x])).collect();
            sliding.extend([("mu", before["mu"].clone()), ("fn", normal.clone())]);
            let found = value("coulomb.response", &sliding).unwrap();
            slips += usize::from(found["slip"][0] != 0.0);
            let is_so = is_near(&found["f"], &results.after[friction]);
            off.extend((!is_so).then(|| format!("{}: {friction}", case.id)));
        }
    }
    off.extend((slips == 0).then(|| "nothing slips".to_owned()));
    off
}

/// Contact has no multipliers; its forces follow from a search.
fn is_held(element: &dyn AnyElement) -> bool {
    !element.layout().multipliers.is_empty()
}

#[test]
fn the_formulas_on_a_sheet_make_up_the_element() {
    let sheets = directives();
    assert_eq!(sheets.iter().filter(|(element, _)| is_held(*element)).count(), 10);
    for (element, sheet) in sheets.iter().filter(|(element, _)| is_held(*element)) {
        assert_eq!(off(*element, sheet), [""; 0], "{}", element.spec().id);
        if !element.layout().contact.is_empty() {
            assert_eq!(friction_off(*element, sheet), [""; 0], "{}", element.spec().id);
        }
    }
    let of_contact: Vec<_> = sheets.iter().filter(|(element, _)| !is_held(*element)).collect();
    assert_eq!(of_contact.len(), 2);
    for (element, sheet) in of_contact {
        assert_eq!(contact::off(*element, sheet), [""; 0], "{}", element.spec().id);
    }
}

#[test]
fn a_sheet_that_names_another_formula_is_found() {
    let wrong = [
        ("slot", "residuals slot.constraint", "residuals slot.relative_position"),
        ("slot", "rows join.rows", "rows universal.rows"),
        ("join", "forces join.nodal_forces", "forces universal.nodal_moments"),
        ("universal", "stiffness universal.geometric_stiffness", "stiffness join.geometric_stiffness"),
        ("translator", "rows join.rows, align.rows", "rows join.rows, universal.rows"),
    ];
    let sheets = directives();
    let of = |id: &str| sheets.iter().find(|(element, _)| element.spec().id == id).unwrap();
    for (id, right, planted) in wrong {
        let (element, sheet) = of(id);
        assert!(sheet.contains(right) && !off(*element, &sheet.replace(right, planted)).is_empty(), "{id}: {planted}");
    }
    for (id, right, planted) in [
        ("translator", "translator.friction", "slot.friction"),
        ("ujoint", "ujoint.normal_moments", "hinge.friction"),
        ("isl21a_linear", "slide_line.torque_linear", "slide_line.contact_area_linear"),
        ("isl21a_linear", "slide_line.closest_linear", "slide_line.closest_parabolic"),
        ("isl21a_linear", "coulomb.response", "coulomb.return_map"),
        ("isl22a_linear", "closest_parabolic", "closest_smoothed_parabolic"),
    ] {
        let (element, sheet) = of(id);
        let planted = sheet.replace(right, planted);
        let found = if is_held(*element) { friction_off(*element, &planted) } else { contact::off(*element, &planted) };
        assert!(sheet.contains(right) && !found.is_empty(), "{id}: {planted}");
    }
}
