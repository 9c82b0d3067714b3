//! The speed/error plane of one formula.

use super::style::{style, time};
use crate::plot::{Axis, BY_CLASS, Drawing, power, rounded};
use crate::report::pareto::front;
use crate::report::tables::duration;
use jointproof::toolkit::measure::Measurement;

const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 270.0;
const ACROSS: [f64; 2] = [46.0, WIDTH - 12.0];
const UP: [f64; 2] = [232.0, 26.0];

/// Smaller values of η are drawn at this value.
const FLOOR: f64 = 0.1;
/// Larger values of η are drawn at this value: no digit is right, or a result is not 0 where the exact number is.
const CEILING: f64 = 1e18;

/// A method in the plane.
struct Point<'a> {
    id: &'a str,
    time: f64,
    eta: f64,
}

/// Time of value and Jacobian against η of the Jacobian, with the Pareto-optimal methods joined by a line.
pub(crate) fn plane(measurement: &Measurement) -> String {
    let point = |method: &'_ jointproof::toolkit::measure::MethodFigures| {
        let jacobian = method.jacobian.as_ref()?;
        Some((jacobian.time?.median, jacobian.random.eta.p99))
    };
    let points: Vec<Point<'_>> = measurement
        .methods
        .iter()
        .filter_map(|method| point(method).map(|(time, eta)| Point { id: &method.id, time, eta }))
        .collect();
    let x = Axis::decades("time for value and Jacobian", points.iter().map(|point| point.time), 0.1);
    let y = Axis::decades(
        "η of the Jacobian (99 % of random points)",
        points.iter().map(|point| point.eta.min(CEILING)).chain([1.0]),
        FLOOR,
    );
    let places: Vec<_> =
        points.iter().map(|point| [x.at(point.time, ACROSS), y.at(point.eta.max(FLOOR), UP)]).collect();
    // Points drawn at the same position are equal here too.
    let ranked: Vec<_> = points.iter().map(|point| (point.time, point.eta.max(FLOOR))).collect();
    let unbeaten = front(&ranked);

    let mut drawing = Drawing::new([WIDTH, HEIGHT], &BY_CLASS, &title(measurement), &description(&points, &unbeaten));
    drawing.below(&x, ACROSS, UP, time);
    let number = |eta: f64| match rounded(eta.log10()) {
        -1 => "≤ 0.1".to_owned(),
        exponent => power(exponent),
    };
    drawing.left(&y, UP, ACROSS, number);
    drawing.path("front", &unbeaten.iter().map(|&k| places[k]).collect::<Vec<_>>());
    for (point, &place) in points.iter().zip(&places) {
        let style = style(point.id);
        drawing.mark(style.class, style.shape, place);
    }
    let mut taken: Vec<Box> = places.iter().map(|&[x, y]| Box { left: x - 5.0, right: x + 5.0, middle: y }).collect();
    for (point, &place) in points.iter().zip(&places) {
        let name = match style(point.id).name {
            "" => point.id,
            name => name,
        };
        let (class, at) = label_place(name, place, &mut taken);
        drawing.text(&format!("label {class}"), at, name);
    }
    drawing.finish()
}

fn title(measurement: &Measurement) -> String {
    format!("{}: speed against error", measurement.formula)
}

fn description(points: &[Point<'_>], unbeaten: &[usize]) -> String {
    let one = |point: &Point<'_>| format!("{} takes {} with η {:.2e}", point.id, duration(point.time), point.eta);
    let all: Vec<_> = points.iter().map(one).collect();
    let best: Vec<_> = unbeaten.iter().map(|&k| points[k].id).collect();
    format!("{}. Unbeaten in speed or error: {}.", all.join("; "), best.join(", "))
}

/// The area covered by a label or a mark, one line high.
struct Box {
    left: f64,
    right: f64,
    middle: f64,
}

/// The first position around a mark where its label covers nothing.
fn label_place(name: &str, [x, y]: [f64; 2], taken: &mut Vec<Box>) -> (&'static str, [f64; 2]) {
    #[expect(clippy::cast_precision_loss, reason = "a short name")]
    let width = 7.0 * name.chars().count() as f64;
    let around = |distance: f64| {
        [y - distance, y + distance].map(|y| [("middle", x, y), ("", x + 6.0, y), ("end", x - 6.0, y)]).concat()
    };
    let beside = vec![("", x + 8.0, y), ("end", x - 8.0, y)];
    let lines = (1..=12).flat_map(|lines| around(13.0 * f64::from(lines)));
    let candidates: Vec<_> = beside.into_iter().chain(lines).collect();
    let covered = |&(class, x, y): &(&str, f64, f64)| {
        let left = match class {
            "end" => x - width,
            "middle" => x - width / 2.0,
            _ => x,
        };
        Box { left, right: left + width, middle: y }
    };
    let free = |candidate: &&(&str, f64, f64)| {
        let here = covered(candidate);
        let inside = here.left > ACROSS[0] && here.right < WIDTH && here.middle > 32.0 && here.middle < UP[0];
        let apart = |other: &Box| {
            here.right < other.left || other.right < here.left || (here.middle - other.middle).abs() > 12.5
        };
        inside && taken.iter().all(apart)
    };
    let chosen = candidates.iter().find(free).unwrap_or(&candidates[0]);
    taken.push(covered(chosen));
    (chosen.0, [chosen.1, chosen.2 + 3.5])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_evade_each_other() {
        let mut taken = vec![Box { left: 95.0, right: 105.0, middle: 100.0 }];
        let first = label_place("closed form", [100.0, 100.0], &mut taken);
        let second = label_place("closed form", [102.0, 100.0], &mut taken);
        assert_eq!(first.0, "");
        assert_ne!(first.1, second.1);
    }
}
