//! The derivatives of SLIDER's residuals with m beside the line, and the card of the reduced one.

use jointproof::connector::slider::{Constraint, Nodes, Slider, rows};
use jointproof::formula::Formula;
use kit::Table;
use nalgebra::Vector3;

/// A line along no axis, and m half a diagonal beside its middle.
const X1: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);
const XN: Vector3<f64> = Vector3::new(4.0, 2.0, 4.0);
const XM: Vector3<f64> = Vector3::new(2.25, 1.0, 1.75);

/// The first residual's derivative with respect to each node, as if m were on the line and where it is.
pub(crate) fn table() -> (String, Vec<Table>) {
    let nodes = Nodes { x1: X1, xn: XN, xm: XM };
    let (reduced, exact) = (rows::Rows::eval(&nodes), Constraint::jacobian(&nodes).g1);
    let reduced = [reduced.g1_u1, reduced.g1_un, reduced.g1_um];
    let shown = |v: Vector3<f64>| {
        let all = v.iter().map(|x| ((x * 1e4).round() / 1e4 + 0.0).to_string().replace('-', "−"));
        format!("({})", all.collect::<Vec<_>>().join(", "))
    };
    let row = |(node, (one, other)): (&str, (Vector3<f64>, Vector3<f64>))| {
        vec![format!(r"$\partial g_1/\partial\mathbf{{x}}_{node}$"), shown(one), shown(other)]
    };
    let both = reduced.into_iter().zip([exact.x1, exact.xn, exact.xm]);
    let head = ["m at (2.25, 1, 1.75)", "reduced", "exact"].map(String::from).into();
    let rows = ["1", "n", "m"].into_iter().zip(both).map(row).collect();
    ("slider-derivatives".into(), vec![Table { head, rows, ..Table::default() }])
}

/// The first of both equations at this place as a card.
pub(crate) fn output() -> anyhow::Result<(String, String)> {
    let slider = Slider::new(X1, XN)?;
    Ok(("slider-equation".into(), slider.equations(XM)?[0].card([1, 2, 3]).to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Off the line the directions normal to it turn about it, and a residual changes by the other one.
    #[test]
    fn reduced_and_exact_rows_agree_on_the_line_and_differ_by_the_other_residual_beside_it() {
        let difference = |beside: f64| {
            let nodes = Nodes { x1: X1, xn: XN, xm: Vector3::new(2.0 + beside, 1.0, 2.0 - beside) };
            let exact = Constraint::jacobian(&nodes).g1;
            (rows::Rows::eval(&nodes).g1_un - exact.xn) / Constraint::eval(&nodes).g2
        };
        let [near, far] = [0.125, 0.25].map(difference);
        assert!((near - far).amax() < 1e-14 && near.amax() > 0.01, "{near} {far}");
        let nodes = Nodes { x1: X1, xn: XN, xm: Vector3::new(2.0, 1.0, 2.0) };
        assert!((rows::Rows::eval(&nodes).g1_un - Constraint::jacobian(&nodes).g1.xn).amax() < 1e-15);
    }
}
