//! The error of both forms of β near 90°, as `book/figures/beta-near-90.svg`.

use std::fmt::Write;

use jointproof::cardan::errors_near_right_angle;

/// Distances from 90°, in radians.
const DISTANCES: [f64; 15] = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8];

/// Half an ulp: an error below it is one pose's luck, and is drawn here.
const FLOOR: f64 = f64::EPSILON / 2.0;

/// The drawing: both errors over the distance, on logarithmic axes.
pub fn beta_near_90() -> String {
    let table = errors_near_right_angle(&DISTANCES);
    let mut svg = String::from(HEAD);
    for decade in 1..=8 {
        let x = horizontal(10_f64.powi(-decade));
        let _ = writeln!(svg, r#"    <path d="M{x:.1} 24V270"/>"#);
    }
    for decade in [-16, -14, -12, -10, -8] {
        let y = vertical(10_f64.powi(decade));
        let _ = writeln!(svg, r#"    <path d="M84 {y:.1}H500"/>"#);
    }
    svg.push_str("  </g>\n  <g fill=\"currentColor\" font-size=\"13\">\n");
    for decade in [1, 2, 4, 6, 8] {
        let x = horizontal(10_f64.powi(-decade));
        let _ = writeln!(svg, r#"    <text x="{x:.1}" y="290" text-anchor="middle">{}</text>"#, power_of_ten(-decade));
    }
    for decade in [-16, -14, -12, -10, -8] {
        let y = vertical(10_f64.powi(decade)) + 4.5;
        let _ = writeln!(svg, r#"    <text x="76" y="{y:.1}" text-anchor="end">{}</text>"#, power_of_ten(decade));
    }
    svg.push_str("  </g>\n");
    curve(&mut svg, "var(--accent, #0b57b0)", table.iter().map(|row| (row.distance, row.arc_sine)));
    curve(&mut svg, "currentColor", table.iter().map(|row| (row.distance, row.two_argument)));
    svg.push_str(LABELS);
    svg.push_str("</svg>\n");
    svg
}

fn curve(svg: &mut String, colour: &str, points: impl Iterator<Item = (f64, f64)>) {
    let points: Vec<_> = points.map(|(distance, error)| (horizontal(distance), vertical(error.max(FLOOR)))).collect();
    let path: Vec<_> = points.iter().map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
    let _ = writeln!(svg, r#"  <path d="M{}" stroke="{colour}" stroke-width="1.8"/>"#, path.join("L"));
    let _ = writeln!(svg, r#"  <g fill="{colour}">"#);
    for (x, y) in points {
        let _ = writeln!(svg, r#"    <circle cx="{x:.1}" cy="{y:.1}" r="3.2"/>"#);
    }
    svg.push_str("  </g>\n");
}

/// 1e-1 on the left, 1e-8 on the right.
fn horizontal(distance: f64) -> f64 {
    100.0 - 56.0 * (distance.log10() + 1.0)
}

/// 1e-17 at the bottom, 1e-7 at the top.
fn vertical(error: f64) -> f64 {
    270.0 - 24.0 * (error.log10() + 17.0)
}

fn power_of_ten(exponent: i32) -> String {
    format!(r#"10<tspan dy="-5" font-size="10">−{}</tspan>"#, exponent.abs())
}

const HEAD: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 520 326" role="img" aria-labelledby="beta-near-90-title beta-near-90-desc" fill="none" stroke-linecap="round" stroke-linejoin="round" font-size="15">
  <title id="beta-near-90-title">Relative error of both forms of β near 90°</title>
  <desc id="beta-near-90-desc">Logarithmic axes: the distance of β from 90° in radians, from 0.1 down to 1e-8, against the largest relative error of 64 poses. The error of the arc sine grows in proportion to one over the distance, from 1e-15 to nearly 1e-8. That of the two-argument form stays at half an ulp, 1e-16.</desc>
  <g stroke="currentColor" stroke-opacity="0.18" stroke-width="1">
"#;

const LABELS: &str = r#"  <text class="label" x="300" y="316" font-size="14" text-anchor="middle" fill="currentColor">90° − β, in radians</text>
  <text class="label" x="20" y="147" font-size="14" text-anchor="middle" transform="rotate(-90 20 147)" fill="currentColor">relative error</text>
  <text x="316" y="110" text-anchor="end" fill="var(--accent, #0b57b0)">arc sine</text>
  <text x="316" y="232" text-anchor="middle" fill="currentColor">two arguments</text>
"#;
