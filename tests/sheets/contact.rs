//! Elements of contact along a line: made up of the formulas on their sheets, slave node by slave node.

use super::{Named, Results, is_general, is_near, lists, named, value};
use crate::common::golden_of_element;
use jointproof::catalog::AnyElement;
use jointproof::toolkit::verify::Layout;
use jointproof::toolkit::verify::golden::components;

/// The formulas on the sheet of a slide-line element, by what they are for.
struct Line<'a> {
    closest: &'a str,
    pressure: &'a str,
    slip: &'a str,
    areas: &'a str,
    torque: &'a str,
    forces: &'a str,
    friction: &'a str,
}

const SLAVES: [&str; 3] = ["xs1", "xs2", "xs3"];
const SEGMENTS: [[&str; 3]; 3] = [["x11", "x12", "x13"], ["x21", "x22", "x23"], ["x31", "x32", "x33"]];
/// The nodes of a segment as formulas name them.
const NODES: [&str; 3] = ["x1", "x2", "x3"];

/// An output of one component.
fn scalar(id: &str, given: &Named, name: &str) -> Option<f64> {
    value(id, given)?.get(name)?.first().copied()
}

/// The same with more inputs.
fn with<const N: usize>(given: &Named, more: [(&'static str, &[f64]); N]) -> Named {
    let mut all = given.clone();
    all.extend(more.map(|(name, numbers)| (name, numbers.to_vec())));
    all
}

impl<'a> Line<'a> {
    fn on(sheet: &'a str) -> Self {
        let lists = lists(sheet);
        let [closest, pressure, slip, areas, torque] = lists["residuals"][..] else { panic!("{sheet}") };
        let ([forces], [friction]) = (&lists["forces"][..], &lists["friction"][..]) else { panic!("{sheet}") };
        Self { closest, pressure, slip, areas, torque, forces, friction }
    }

    /// The length of the path of a slave node between two points of its segment.
    fn path(&self, given: &Named, [from, to]: [f64; 2]) -> Option<f64> {
        let Some(x3) = given.get("x3") else {
            // On a straight segment all positions are measured from the previous point.
            let from =
                with(given, [("g", &[from]), ("dxs", &given["xs"]), ("dx1", &given["x1"]), ("dx2", &given["x2"])]);
            return scalar(self.slip, &from, "dslip");
        };
        // On a curved one the velocity is integrated, by a Gauss rule of two points.
        let (still, reach) = (vec![0.0; x3.len()], (to - from) / 2.0);
        let part = |side: f64| {
            let here = with(given, [("g", &[f64::midpoint(from, to) + side * reach / 3.0_f64.sqrt()])]);
            let along: Vec<_> = value("slide_line.parabolic_point", &here)?["dx"].iter().map(|dx| dx * reach).collect();
            let moving = [("dxs", &along[..]), ("dx1", &still), ("dx2", &still), ("dx3", &still)];
            scalar(self.slip, &with(&here, moving), "dslip")
        };
        Some(part(-1.0)? + part(1.0)?)
    }

    /// What the element would return by these formulas: the torque, and forces and state by their names. `None` if one of them
    /// needs what the element is not given.
    fn results(&self, layout: &Layout, inputs: &Named, rubs: bool) -> Option<(f64, Named, Named)> {
        let nodes = SLAVES.iter().filter(|slave| inputs.contains_key(*slave)).count();
        let at = |places: &[&'static str; 3]| {
            let mut given = inputs.clone();
            given.extend(NODES.iter().zip(places).take(nodes).map(|(node, place)| (*node, inputs[place].clone())));
            given
        };
        let mut forces: Named = layout.forces.iter().map(|field| (field.name, vec![0.0; field.len()])).collect();
        let mut after = Named::from([("g", Vec::new()), ("s12", Vec::new())]);
        // The nodes of the element are the slave nodes.
        let mut element = at(&SLAVES);
        let areas = value(self.areas, &element)?;
        for (k, segment) in SEGMENTS.iter().enumerate().take(nodes) {
            let given = with(&at(segment), [("xs", &inputs[SLAVES[k]])]);
            let foot = value(self.closest, &given)?;
            let g = foot["g"][0];
            // Beyond the ends of its segment a slave node touches nothing. A separation is positive, and h negative, where it is open.
            let [mut pressure, mut shear] = [0.0; 2];
            if g.abs() < 1.0 {
                pressure = scalar(self.pressure, &with(&given, [("h", &[-foot["separation"][0]])]), "p")?;
                if rubs && pressure > 0.0 {
                    let du = self.path(&given, [inputs["g"][k], g])?;
                    let motion = [("du", &[du][..]), ("f_before", &inputs["s12"][k..=k]), ("fn", &[pressure])];
                    shear = scalar(self.friction, &with(inputs, motion), "f")?;
                }
                let area = areas.get(["a1", "a2", "a3"][k])?;
                let loaded = with(&given, [("g", &[g]), ("area", area), ("s11", &[pressure]), ("s12", &[shear])]);
                for (name, force) in value(self.forces, &loaded)? {
                    let node = ["f1", "f2", "f3"].iter().position(|on| *on == name);
                    let on = node.map_or(SLAVES[k], |node| segment[node]);
                    let row = layout.unknowns.iter().position(|unknown| unknown.name[1..] == on[1..])?;
                    forces.insert(layout.forces[row].name, force);
                }
            }
            after.get_mut("g")?.push(g);
            after.get_mut("s12")?.push(shear);
            element.insert(["p1", "p2", "p3"][k], vec![pressure]);
        }
        Some((scalar(self.torque, &element, "t")?, forces, after))
    }
}

/// Contact along a line, at the poses that are drawn: what the formulas on the sheet do not make up.
pub(super) fn off(element: &dyn AnyElement, sheet: &str) -> Vec<String> {
    let line = Line::on(sheet);
    let (mut off, mut rubbed) = (Vec::new(), 0);
    for case in golden_of_element(element).cases.iter().filter(|case| is_general(&case.id) && case.error.is_none()) {
        let rubs = case.inputs.len() == element.inputs(true).len();
        let inputs = components(element.inputs(rubs), &case.inputs).unwrap();
        let results = Results::new(element, &inputs, rubs);
        let given = named(element.inputs(rubs), &inputs);
        // The sheet has no formula of the path from a point beyond the ends.
        if given.get("g").is_some_and(|g| g.iter().any(|g| g.abs() > 1.0)) {
            continue;
        }
        let Some((torque, forces, after)) = line.results(&element.layout(), &given, rubs) else {
            off.push(format!("{}: a formula needs what the element is not given", case.id));
            continue;
        };
        rubbed += after["s12"].iter().filter(|s12| **s12 != 0.0).count();
        let mut differ = |what: &str, found: &[f64], expected: &[f64]| {
            off.extend((!is_near(found, expected)).then(|| format!("{}: {what}", case.id)));
        };
        differ("torque", &[torque], &results.residuals["torque"]);
        for (name, force) in &forces {
            differ(name, force, &results.forces[name]);
        }
        if rubs {
            differ("s12", &after["s12"], &results.after["s12"]);
            // The formula stops at the ends.
            let g: Vec<_> = results.after["g"].iter().map(|g| g.clamp(-1.0, 1.0)).collect();
            differ("g", &after["g"], &g);
        }
    }
    off.extend((rubbed == 0).then(|| "nothing rubs".to_owned()));
    off
}
