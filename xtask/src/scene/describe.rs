//! What is in a scene: its elements at the start, as text, and as a page with a drawing of each.

use super::load::{Loaded, shown, warn};
use super::out::Target;
use super::show::digits;
use crate::console::{bold, count, print};
use crate::figures::sketch::{Ink, Point, Sketch, View};
use crate::files;
use jointproof::scene::{Dimension, Kind, Scene, Start, StartNode};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The number of drawings of a page.
const DRAWN: usize = 200;

/// Describes scenes, a page only one of them; returns how much was ambiguous.
pub(super) fn run(target: Option<&Target>, scenes: &[(&PathBuf, Loaded)]) -> anyhow::Result<usize> {
    let mut warned = 0;
    for (path, Loaded { scene, left_out, .. }) in scenes {
        let start = scene.start()?;
        match target {
            None => print(&text(&name(path, scene), scene, &start)?)?,
            Some(Target { path: target, .. }) => {
                files::write(target, &page(path, scene, &start)?)?;
            }
        }
        warned += warn(path, &[left_out.clone(), scene.warnings()].concat());
    }
    Ok(warned)
}

fn vector(v: &[f64]) -> String {
    // Without negative zeros.
    let numbers: Vec<_> = v.iter().map(|x| digits(x + 0.0)).collect();
    if let [one] = &numbers[..] { one.clone() } else { format!("({})", numbers.join(", ")) }
}

/// A node: its name, position and axes.
fn node(StartNode { name, at, axes, .. }: &StartNode, coordinates: usize) -> String {
    let axes =
        axes.map(|[e1, e2, _]| format!(", e1 {}, e2 {}", vector(&e1[..coordinates]), vector(&e2[..coordinates])));
    format!("{name} at {}{}", vector(&at[..coordinates]), axes.unwrap_or_default())
}

/// The lines about an element: what each is about, and what it says.
fn lines(start: &Start) -> Vec<(String, String)> {
    let coordinates = start.kind.dimension.coordinates();
    let mut lines: Vec<(String, String)> = Vec::new();
    for (role, of) in start.kind.nodes.iter().zip(&start.nodes) {
        lines.push(((*role).into(), node(of, coordinates)));
    }
    if let [first, .., last] = &start.line[..] {
        let all = format!("{} nodes, {} to {}", start.line.len(), node(first, coordinates), node(last, coordinates));
        lines.push(("slide line".into(), all));
    }
    for (output, values) in &start.geometry {
        // A vector of each node has its components one after the other.
        lines.push(((*output).into(), vector(values)));
    }
    for (parameter, outputs) in &start.missing {
        lines.push(("not given".into(), format!("{parameter}, needed for {}", outputs.join(", "))));
    }
    lines.extend(start.problems.iter().map(|problem| ("undefined".into(), problem.clone())));
    lines
}

/// The title of an element: its name, its kind, and how many it is.
fn title(start: &Start) -> String {
    let several =
        if start.count > 1 { format!(", {} elements, of which this is the first", start.count) } else { String::new() };
    format!("{}, {}{several}", start.element, start.kind.name)
}

/// What the outputs mean.
fn meanings(start: &[Start]) -> Vec<(&'static str, String)> {
    let mut all: Vec<(&str, String)> = Vec::new();
    for Start { kind, geometry, .. } in start {
        for (output, _) in geometry {
            let quantity = kind.output(output).and_then(|register| kind.quantity(register));
            let meaning =
                quantity.map(|quantity| format!("{} ({})", quantity.meaning, quantity.unit)).unwrap_or_default();
            if !all.iter().any(|known| known.0 == *output && known.1 == meaning) {
                all.push((output, meaning));
            }
        }
    }
    all
}

/// What there is, and how much of it is undefined.
fn summary(scene: &Scene, start: &[Start]) -> String {
    let undefined = start.iter().filter(|start| !start.problems.is_empty()).count();
    let lacking = start.iter().filter(|start| !start.missing.is_empty()).count();
    let mut kinds: Vec<(&Kind, u32)> = Vec::new();
    for Start { kind, count, .. } in start {
        match kinds.iter_mut().find(|(known, _)| known.name == kind.name) {
            Some((_, all)) => *all += count,
            None => kinds.push((kind, *count)),
        }
    }
    let kinds: Vec<_> = kinds.iter().map(|(kind, count)| format!("{count} {}", kind.name)).collect();
    format!(
        "{}, {}: {}; undefined at the start: {undefined}, with parameters that are not given: {lacking}",
        scene.dimension().name(),
        count(scene.size(), "element"),
        kinds.join(", ")
    )
}

/// The title of a scene, or the name of its file.
fn name(path: &Path, scene: &Scene) -> String {
    if scene.title().is_empty() { shown(path) } else { scene.title().into() }
}

pub(super) fn text(name: &str, scene: &Scene, start: &[Start]) -> anyhow::Result<String> {
    let mut text = String::new();
    writeln!(text, "{}\n{}", bold(name), summary(scene, start))?;
    for start in start {
        writeln!(text, "\n{}", bold(title(start)))?;
        for (about, what) in lines(start) {
            writeln!(text, "  {about:<10}  {what}")?;
        }
    }
    text.push('\n');
    for (output, meaning) in meanings(start) {
        writeln!(text, "{output:<10}    {meaning}")?;
    }
    Ok(text)
}

/// The page of a scene.
fn page(path: &Path, scene: &Scene, start: &[Start]) -> anyhow::Result<String> {
    let name = name(path, scene);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{name}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{name}</h1>\n<p>{}</p>\n",
        escaped(&summary(scene, start)),
        name = escaped(&name)
    );
    if start.len() > DRAWN {
        writeln!(page, "<p>The first {DRAWN} elements are drawn.</p>")?;
    }
    for (index, start) in start.iter().enumerate() {
        writeln!(page, "<section>\n<h2>{}</h2>", escaped(&title(start)))?;
        if index < DRAWN {
            page.push_str(&drawing(index, start));
        }
        page.push_str("<table>\n");
        for (about, what) in lines(start) {
            writeln!(page, "<tr><th scope=\"row\">{}</th><td>{}</td></tr>", escaped(&about), escaped(&what))?;
        }
        page.push_str("</table>\n</section>\n");
    }
    page.push_str("<h2>Symbols</h2>\n<table>\n");
    for (output, meaning) in meanings(start) {
        writeln!(page, "<tr><th scope=\"row\">{output}</th><td>{}</td></tr>", escaped(&meaning))?;
    }
    page.push_str("</table>\n</body>\n</html>\n");
    Ok(page)
}

const STYLE: &str = ":root{color-scheme:light dark}body{font:16px/1.5 system-ui,sans-serif;max-width:44rem;margin:2rem auto;padding:0 1rem}\
    svg{width:100%;height:auto}th{text-align:left;vertical-align:top;padding-right:1.5em;font-weight:600}\
    td{font-variant-numeric:tabular-nums;overflow-wrap:anywhere}";

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Labels of a drawing are words with indices: those of a name are not.
fn label(name: &str) -> String {
    escaped(name).replace('_', "&#95;").replace('*', "&#42;")
}

/// The mechanism of an element at its place.
fn drawing(index: usize, start: &Start) -> String {
    let origin = start.nodes.first().map_or([0.0; 3], |node| node.at);
    let from_first = |at: [f64; 3]| Point::from(at) - Point::from(origin);
    let at: Vec<Point> = start.nodes.iter().map(|node| from_first(node.at)).collect();
    let line: Vec<Point> = start.line.iter().map(|node| from_first(node.at)).collect();
    let all = || at.iter().chain(&line);
    let reach = all().flat_map(|a| all().map(move |b| (a - b).norm())).fold(0.0, f64::max);
    let length = if reach > 0.0 { reach * 0.3 } else { 1.0 };
    let triads: Vec<_> =
        at.iter().zip(&start.nodes).map(|(&at, node)| (at, node.axes.map(|axes| axes.map(Point::from)))).collect();
    let ends = triads.iter().flat_map(|(at, axes)| axes.iter().flatten().map(move |axis| at + axis * length));
    let points: Vec<Point> = all().copied().chain(ends).collect();
    let is_flat = start.kind.dimension != Dimension::Space;
    let name = escaped(&start.element);
    let description = format!("The nodes of the element {name}, their axes, and what connects them, at the start.");
    let mut sketch = Sketch::new(
        format!("start-{index}"),
        format!("{name} at the start"),
        description,
        View::fitted(&points, is_flat),
    );
    if line.len() > 1 {
        sketch.path(&line, Ink::Solid);
    }
    connection(&mut sketch, start.kind, &at, &triads, length);
    for (k, (at, axes)) in triads.iter().enumerate() {
        let (ink, of) = if k == 0 { (Ink::Solid, "a") } else { (Ink::Accent, "b") };
        if let Some(axes) = axes {
            // In the plane the third axis is a point.
            let shown = if is_flat { [axes[0], axes[1], axes[1] * 0.0] } else { *axes };
            sketch.triad(*at, shown, length, of, ink);
        }
    }
    for (k, (at, node)) in at.iter().zip(&start.nodes).enumerate() {
        let ink = if k == 0 { Ink::Solid } else { Ink::Accent };
        sketch.dot(*at, ink);
        sketch.label(*at, [-8.0, if k % 2 == 0 { 26.0 } else { -14.0 }], &label(&node.name), ink);
    }
    sketch.html() + "\n"
}

/// A node's place, and its axes.
type Placed = (Point, Option<[Point; 3]>);

/// What connects the nodes.
fn connection(sketch: &mut Sketch, kind: &Kind, at: &[Point], triads: &[Placed], length: f64) {
    let first = triads.first().and_then(|(_, axes)| *axes);
    match (kind.name, at, first) {
        ("slot" | "translator", &[a, b], Some([e1, ..])) => {
            let along = (b - a).dot(&e1);
            let foot = a + e1 * along;
            sketch.band([b - e1 * (along.abs() + length), b + e1 * length], 18.0);
            sketch.path(&[b - e1 * (along.abs() + length), b + e1 * length], Ink::Axis);
            sketch.path(&[a, foot, b], Ink::Dashed);
        }
        ("hinge" | "revolute", &[a, b], Some([e1, ..])) => {
            sketch.path(&[a - e1 * length, a + e1 * length], Ink::Axis);
            sketch.path(&[a, b], Ink::Dashed);
        }
        ("ujoint" | "universal", &[a, b], Some([e1, ..])) => {
            sketch.path(&[a - e1 * length * 0.7, a + e1 * length * 0.7], Ink::Solid);
            let third = triads.get(1).and_then(|(_, axes)| *axes).or(first).map(|axes| axes[2]);
            if let Some(third) = third {
                sketch.path(&[b - third * length * 0.7, b + third * length * 0.7], Ink::Accent);
            }
            sketch.path(&[a, b], Ink::Dashed);
        }
        ("slider", &[first, last, _], _) => sketch.path(&[first, last], Ink::Solid),
        ("isl21a" | "isl22a", nodes, _) => sketch.path(nodes, Ink::Accent),
        (_, nodes, _) => sketch.path(nodes, Ink::Dashed),
    }
}
