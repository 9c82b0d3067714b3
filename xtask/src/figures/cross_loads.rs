//! Which hinge of a UJOINT carries what, in the state that its chapter follows.

use super::sketch::{Ink, Point, Sketch, View};
use jointproof::catalog::find;
use jointproof::connector::ujoint::{Decomposition, HingeAxial, HingeBending, HingeTransverse, HingeTwist};
use jointproof::formula::{Formula, Spec};
use jointproof::toolkit::verify::golden::components;

pub(super) const NAME: &str = "ujoint-hinges";

/// The state by its golden cases.
const STATE: &str = "running";

/// The value of a formula in that state.
fn value(Spec { id, .. }: &Spec) -> Vec<f64> {
    let formula = find(id).unwrap_or_else(|| panic!("there is no {id}"));
    let golden = formula.golden();
    let case = golden.cases.iter().find(|case| case.id == STATE).unwrap_or_else(|| panic!("{id} has no case {STATE}"));
    let inputs = components(formula.inputs(), &case.inputs).expect("a golden case has every input");
    formula.value_and_closed_jacobian(&inputs).expect("the state is allowed").0
}

fn number(x: f64) -> String {
    ((x * 1e4).round() / 1e4 + 0.0).to_string().replace('-', "−")
}

/// The cross in its plane, the forces on each of the four hinges, and their numbers below.
pub(super) fn html() -> String {
    let description = "The cross in its plane, with the axis e1a to the right and the axis e3b up. On each of the two hinges of an \
        axis act: along the axis its share of the axial force; in the plane and normal to the axis the force of the twisting moment \
        and the share of the force along the other axis; and normal to the plane a quarter of the force normal to the cross.";
    let mut sketch =
        Sketch::new(NAME, "What each hinge of the cross carries", description, View::plane(58.0, [280.0, 150.0]));
    let (x, y) = (Point::x(), Point::y());
    for (axis, other, name) in [(x, y, "*e_1a"), (y, x, "*e_3b")] {
        sketch.path(&[axis * -2.3, axis * 2.3], Ink::Axis);
        for side in [-1.0, 1.0] {
            let hinge = axis * (1.7 * side);
            sketch.path(&[axis * (0.2 * side), hinge], Ink::Solid);
            sketch.band([axis * (1.45 * side), axis * (1.95 * side)], 26.0);
            sketch.dot(hinge, Ink::Solid);
            sketch.arrow(hinge, axis * 0.55, Ink::Accent);
            sketch.arrow(hinge, other * (0.7 * side), Ink::Force);
        }
        sketch.label(axis * 2.45, [8.0, 6.0], name, Ink::Accent);
    }
    sketch.label(x * 1.7 + y * 0.7, [-14.0, -8.0], "T + V", Ink::Force);
    sketch.label(x * 2.1, [-10.0, 22.0], "H", Ink::Accent);
    let (axial, twist) = (value(&HingeAxial::SPEC), value(&HingeTwist::SPEC));
    let (normal, total) = (value(&Decomposition::SPEC)[2], value(&HingeTransverse::SPEC));
    let bending = value(&HingeBending::SPEC);
    for (k, axis) in ["*e_1a", "*e_3b"].into_iter().enumerate() {
        sketch.note(format!(
            "Each hinge of {axis}: along it H = {}; normal to it T = {} of the twisting moment, V = {} of the other axis, and {} normal \
             to the cross, together {}.",
            number(axial[k]),
            number(twist[1]),
            number(axial[2 + k]),
            number(normal.abs() / 4.0),
            number(total[k])
        ));
    }
    sketch.note(format!(
        "All four: the moments {} of the force normal to the cross and {} of the twisting moment bend the pin, together {}, which \
         presses with {}.",
        number(bending[0]),
        number(twist[0]),
        number(bending[1]),
        number(bending[2])
    ));
    sketch.html()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As on paper: 0.35 · 4.4 and 0.35 · 17.5 along; √(2² + 8.4² + 2.625²) and √(2² + 8.4² + 0.66²) normal.
    #[test]
    fn the_numbers_are_those_of_the_chapter() {
        let shown = html();
        for number in [
            "H = 1.54;",
            "H = 6.125;",
            "T = 8.4 ",
            "V = 2.625 ",
            "V = 0.66 ",
            "together 9.025.",
            "together 8.66.",
            "with 3.5.",
        ] {
            assert!(shown.contains(number), "{number} in {shown}");
        }
    }
}
