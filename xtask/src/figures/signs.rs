//! The sign convention of forces: the forces of a slot on its two nodes, computed by the formulas.

use jointproof::connector::slot::{ConstraintForce, CrossFrame, KineticForce, SlotForce};
use jointproof::formula::Formula;
use nalgebra::{Vector2, Vector3};
use std::fmt::Write;

pub(super) const NAME: &str = "signs";

/// The positions of the nodes in the drawing, with y downwards.
const A: Vector2<f64> = Vector2::new(120.0, 196.0);
const B: Vector2<f64> = Vector2::new(360.0, 116.0);

/// Half the side lengths of a body.
const BODY: Vector2<f64> = Vector2::new(36.0, 24.0);
/// SVG units per unit of length, and per unit of force.
const UNIT: f64 = 64.0;
const PER_FORCE: f64 = 26.0;
/// The forces that are drawn.
const F1: f64 = 3.0;
const F2: f64 = 2.5;

/// The projection of a vector on the plane of e1a and e2a, in the drawing: e1a to the right, e2a up.
fn on_paper(v: &Vector3<f64>) -> Vector2<f64> {
    Vector2::new(v.x, -v.y)
}

/// The kinetic force and the constraint force, by the formulas.
fn forces() -> [Vector2<f64>; 2] {
    let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let kinetic = KineticForce::eval(&SlotForce { e1a, f1: F1 }).f;
    let constraint = ConstraintForce::eval(&CrossFrame { e2a, e3a, f2: F2, f3: 0.0 }).f;
    [kinetic, constraint].map(|force| on_paper(&force) * PER_FORCE)
}

/// An arrow from a point, in the text colour or the accent colour.
fn arrow(svg: &mut String, from: Vector2<f64>, by: Vector2<f64>, accent: bool) {
    let to = from + by;
    let (colour, tip) = if accent { ("var(--accent, #0b57b0)", "accent") } else { ("currentColor", "tip") };
    let _ = writeln!(
        svg,
        r#"  <path d="M{} {} {} {}" stroke="{colour}" stroke-width="2.2" marker-end="url(#{NAME}-{tip})"/>"#,
        from.x, from.y, to.x, to.y
    );
}

/// A label next to a point, in parts that may be subscripts.
fn label(svg: &mut String, at: Vector2<f64>, accent: bool, parts: &[(&str, &str)]) {
    let colour = if accent { "var(--accent, #0b57b0)" } else { "currentColor" };
    let _ = write!(svg, r#"  <text x="{}" y="{}" fill="{colour}">"#, at.x, at.y);
    for (text, index) in parts {
        let weight = if text.ends_with('e') { "700" } else { "400" };
        let _ = write!(
            svg,
            r#"<tspan font-weight="{weight}">{text}</tspan><tspan dy="5" font-size="12">{index}</tspan><tspan dy="-5"> </tspan>"#
        );
    }
    svg.push_str("</text>\n");
}

fn body(svg: &mut String, at: Vector2<f64>, name: &str, label_at: Vector2<f64>) {
    let corner = at - BODY;
    let _ = writeln!(
        svg,
        r#"  <rect x="{}" y="{}" width="{}" height="{}" rx="8" fill="currentColor" fill-opacity="0.07" stroke="currentColor" stroke-width="1.4"/>
  <circle cx="{}" cy="{}" r="5" fill="currentColor"/>
  <text x="{}" y="{}" fill="currentColor">body <tspan font-style="italic">{name}</tspan></text>"#,
        corner.x,
        corner.y,
        2.0 * BODY.x,
        2.0 * BODY.y,
        at.x,
        at.y,
        label_at.x,
        label_at.y
    );
}

/// Bodies a and b, the triad of a, the motion u1, and the forces of the connector on both.
pub(super) fn svg() -> String {
    let mut svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 560 300" role="img" aria-labelledby="{NAME}-title {NAME}-desc" fill="none" stroke-linecap="round" stroke-linejoin="round" font-size="16">
  <title id="{NAME}-title">Signs of the forces of a slot</title>
  <desc id="{NAME}-desc">Body a with its axes e1a to the right and e2a up, and body b to the right of it on the line of the slot, which is parallel to e1a. The motion u1 of b is positive to the right. The connector pushes b to the left with minus f1 e1a and up with f2 e2a. On a act the opposites: f1 e1a to the right and minus f2 e2a down.</desc>
  <defs>
    <marker id="{NAME}-tip" viewBox="0 0 10 10" refX="8.5" refY="5" markerWidth="7" markerHeight="7" orient="auto"><path d="M0 1 9 5 0 9Z" fill="currentColor" stroke="none"/></marker>
    <marker id="{NAME}-accent" viewBox="0 0 10 10" refX="8.5" refY="5" markerWidth="7" markerHeight="7" orient="auto"><path d="M0 1 9 5 0 9Z" fill="var(--accent, #0b57b0)" stroke="none"/></marker>
  </defs>
"#
    );
    let _ = writeln!(
        svg,
        r#"  <path d="M20 {0} 540 {0}" stroke="currentColor" stroke-width="1.1" stroke-dasharray="14 4 2 4"/>"#,
        B.y
    );
    body(&mut svg, A, "a", A + Vector2::new(-30.0, -34.0));
    body(&mut svg, B, "b", B + Vector2::new(-26.0, 44.0));
    // The triad is drawn next to the forces on a.
    let origin = Vector2::new(28.0, 272.0);
    for (axis, index, beside) in
        [(Vector3::x(), "1a", Vector2::new(6.0, 5.0)), (Vector3::y(), "2a", Vector2::new(8.0, 4.0))]
    {
        let by = on_paper(&axis) * UNIT;
        arrow(&mut svg, origin, by, false);
        label(&mut svg, origin + by + beside, false, &[("e", index)]);
    }
    // The motion, which is positive along e1a.
    let motion = on_paper(&Vector3::x()) * UNIT;
    let from = B + Vector2::new(BODY.x + 24.0, -44.0);
    arrow(&mut svg, from, motion, false);
    label(&mut svg, from + Vector2::new(22.0, -10.0), false, &[("u", "1")]);
    let [kinetic, constraint] = forces();
    arrow(&mut svg, B, -kinetic, true);
    label(&mut svg, B - kinetic + Vector2::new(-28.0, -12.0), true, &[("−f", "1"), ("e", "1a")]);
    arrow(&mut svg, B, constraint, true);
    label(&mut svg, B + constraint + Vector2::new(8.0, 2.0), true, &[("f", "2"), ("e", "2a")]);
    arrow(&mut svg, A, kinetic, true);
    label(&mut svg, A + kinetic + Vector2::new(6.0, 6.0), true, &[("f", "1"), ("e", "1a")]);
    arrow(&mut svg, A, -constraint, true);
    label(&mut svg, A - constraint + Vector2::new(8.0, 6.0), true, &[("−f", "2"), ("e", "2a")]);
    svg + "</svg>\n"
}
