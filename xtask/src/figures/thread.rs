//! The worked example of the chapter on the threaded connector: four flanks of a thread as slide lines.

use jointproof::Error;
use jointproof::contact::isl::{Contact, ContactState, ElementSet, Increment, Interaction, IslElement, TorquePrint};
use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
use kit::{Axis, Chart, Curve};
use std::f64::consts::PI;

/// Lengths in mm, forces in N. The load flank of the box runs from the radius 46 to 52, that of the pin from 47 to 51.
const PITCH: f64 = 6.0;
/// The excess of the pin's pitch.
const PITCH_ERROR: f64 = 0.001;
/// Pressure per overclosure, N/mm³.
const STIFFNESS: f64 = 2e5;
/// The rise of a flank per unit of radius: a flank with a radial extent of 4 mm is 5 mm long.
const SLOPE: f64 = 0.75;

// ANCHOR: model
/// The flanks, each a slide line of the box and an element of the pin, with nodes 10 f + 1, 2 and 10 f + 3, 4.
fn flanks() -> Result<Vec<Contact>, Error> {
    (1..=4)
        .map(|flank| {
            let line = SlideLine::new(Interpolation::Linear, [10 * flank + 1, 10 * flank + 2])?;
            let pin = [IslElement::isl21a(flank, [10 * flank + 3, 10 * flank + 4])?];
            let pin = ElementSet::new(format!("flank {flank}"), pin)?;
            Ok(Contact::new(line, pin, Interaction::linear(STIFFNESS)?))
        })
        .collect()
}

/// Where the nodes are when the pin has been drawn into the box by `makeup`, against z.
///
/// The last flank touches at 0, each one before it a pitch error later.
fn places(makeup: f64) -> Result<Nodes, Error> {
    Nodes::new((1..=4_u32).flat_map(|flank| {
        let z = f64::from(flank) * PITCH;
        let late = f64::from(4 - flank) * PITCH_ERROR;
        let on = |r: f64, lift: f64| [r, z + (r - 46.0) * SLOPE + lift];
        let pin = late - makeup;
        let nodes = [on(46.0, 0.0), on(52.0, 0.0), on(47.0, pin), on(51.0, pin)];
        (10 * flank + 1..).zip(nodes)
    }))
}

/// Makes the connector up by `advance` in each increment; the table has the torque of each flank at every
/// `frequency`-th one.
fn make_up(increments: u32, advance: f64, frequency: u32) -> Result<TorquePrint, Error> {
    let flanks = flanks()?;
    let start = places(0.0)?;
    let mut states: Vec<ContactState> =
        flanks.iter().map(|flank| flank.start(start.clone())).collect::<Result<_, _>>()?;
    let mut table = TorquePrint::every(frequency);
    for increment in 1..=increments {
        let now = places(f64::from(increment) * advance)?;
        for (flank, state) in flanks.iter().zip(&mut states) {
            *state = flank.advance(state, now.clone(), &Increment::new(1.0)?)?;
        }
        table.print(increment, increment == increments, flanks.iter().zip(&states))?;
    }
    Ok(table)
}
// ANCHOR_END: model

/// The make-up and the torque of all flanks together, increment by increment.
fn torques(increments: u32, advance: f64) -> Result<Vec<(f64, f64)>, Error> {
    let table = make_up(increments, advance, 1)?;
    let of = |increment| table.rows().iter().filter(move |row| row.increment == increment).map(|row| row.torque);
    Ok((1..=increments).map(|increment| (f64::from(increment) * advance, of(increment).sum())).collect())
}

/// The closed form: each closed flank has a uniform pressure k h, h = (make-up − lateness) × 4/5, and
/// T = 2π p ∫ r² ds = 2π p ℓ (r1² + r1 r2 + r2²)/3.
fn closed_form(makeup: f64) -> f64 {
    let moment = 2.0 * PI * 5.0 * (47.0 * 47.0 + 47.0 * 51.0 + 51.0 * 51.0) / 3.0;
    (0..4).map(|late| STIFFNESS * (0.8 * (makeup - f64::from(late) * PITCH_ERROR)).max(0.0) * moment).sum()
}

/// Torque against make-up, by the elements and in closed form.
pub(crate) fn torque_of_a_thread() -> Chart<'static> {
    let kilo = 1e-6;
    let exact = (0..=60).map(|k| f64::from(k) * 0.1).map(|x| (x, closed_form(x * 1e-3) * kilo));
    let found = torques(6, 0.001).unwrap_or_default().into_iter().map(|(x, t)| (x * 1e3, t * kilo));
    // The curves coincide, so their names are written elsewhere: each at a separate point after a gap.
    let named = |points: Vec<(f64, f64)>, name, place| {
        let points = [points, vec![(f64::NAN, f64::NAN), place]].concat();
        Curve { name, label_at: points.len() - 1, points }
    };
    Chart {
        name: "thread-torque",
        title: "Greatest torque of a threaded connector during make-up",
        description: "The make-up from 0 to 6 micrometres against the torque in kilonewton metres. The torque grows in \
            straight pieces, steeper at 1, 2 and 3 micrometres, where one more flank closes, up to 217. The sums over the \
            elements are on the closed form.",
        x: Axis {
            label: "make-up, in µm",
            from: 0.0,
            to: 6.0,
            logarithmic: false,
            ticks: vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
        },
        y: Axis {
            label: "torque with friction 1, in kN m",
            from: 0.0,
            to: 250.0,
            logarithmic: false,
            ticks: vec![0.0, 50.0, 100.0, 150.0, 200.0, 250.0],
        },
        curves: vec![
            named(exact.collect(), "closed form", (1.1, 72.0)),
            named([(0.0, 0.0)].into_iter().chain(found).collect(), "elements", (4.7, 128.0)),
        ],
    }
}

/// The numbers of elements for the tilted flank.
const DIVISIONS: [u32; 10] = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512];

/// The overclosure of a tilted flank at a fraction of its length, open beyond the fraction `closed`.
fn tilted(share: f64, closed: f64) -> f64 {
    0.004 * (closed - share)
}

/// The torque of a tilted flank divided into `elements` elements, relative to the closed form, minus 1.
///
/// With h linear along the flank and r = 47 + 4 s, the closed form is 2π k ℓ ∫ r² h ds over the closed part.
fn error_of_a_tilted_flank(elements: u32, closed: f64) -> Result<f64, Error> {
    let set = (1..=elements).map(|e| IslElement::isl21a(e, [e + 2, e + 3])).collect::<Result<Vec<_>, _>>()?;
    let line = SlideLine::new(Interpolation::Linear, [1, 2])?;
    let flank = Contact::new(line, ElementSet::new("tilted", set)?, Interaction::linear(STIFFNESS)?);
    let pin = (0..=elements).map(|e| {
        let share = f64::from(e) / f64::from(elements);
        [47.0 + 4.0 * share, -tilted(share, closed)]
    });
    let nodes = Nodes::new((1..).zip([[46.0, 0.0], [52.0, 0.0]].into_iter().chain(pin)))?;
    let found = flank.torque(&flank.start(nodes.clone())?)?;
    let c = closed.min(1.0);
    // ∫ r² (closed − s) ds from 0 to c, with r² = 47² + 8·47 s + 16 s².
    let [r0, r1, r2] = [47.0 * 47.0, 8.0 * 47.0, 16.0];
    let antiderivative =
        |s: f64| closed * s * (r0 + s * (r1 / 2.0 + s * r2 / 3.0)) - s * s * (r0 / 2.0 + s * (r1 / 3.0 + s * r2 / 4.0));
    // The element is inclined by its overclosure, and therefore slightly longer than 4.
    let length = 4.0_f64.hypot(0.004);
    let exact = 2.0 * PI * STIFFNESS * 0.004 * length * antiderivative(c);
    Ok((found / exact - 1.0).abs())
}

/// The error for a tilted flank, closed completely and in part.
pub(crate) fn tilted_flank() -> Chart<'static> {
    let errors = |closed: f64| {
        let error = |n: u32| error_of_a_tilted_flank(n, closed).unwrap_or(f64::NAN).max(f64::EPSILON / 2.0);
        DIVISIONS.iter().map(|&n| (f64::from(n), error(n))).collect()
    };
    Chart {
        name: "tilted-flank",
        title: "Error of the torque of a tilted flank over the number of elements",
        description: "Logarithmic axes: the number of elements from 1 to 512 against the relative error of the torque. On a \
            flank that is closed all along, the error is rounding, below 1e-12, for any number. On one that is open from \
            61 percent of its length on, it falls by a factor of about four for twice the elements.",
        x: Axis {
            label: "elements along the flank",
            from: 1.0,
            to: 512.0,
            logarithmic: true,
            ticks: vec![1.0, 4.0, 16.0, 64.0, 256.0],
        },
        y: Axis {
            label: "relative error of the torque",
            from: 1e-17,
            to: 1.0,
            logarithmic: true,
            ticks: vec![1e-16, 1e-12, 1e-8, 1e-4, 1.0],
        },
        curves: vec![
            Curve { name: "open from 61 % on", label_at: 4, points: errors(0.61) },
            Curve { name: "closed all along", label_at: 4, points: errors(1.5) },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elements_give_the_closed_form() {
        for (makeup, torque) in torques(60, 1e-4).unwrap() {
            // The overclosure is a difference of coordinates of 30 mm, whose rounding determines the error.
            let blur = 30.0 * f64::EPSILON / makeup;
            let error = (torque / closed_form(makeup) - 1.0).abs();
            assert!(error < blur, "{error} at {makeup}");
        }
    }

    #[test]
    fn a_tilted_flank_is_exact_where_it_is_closed() {
        for n in DIVISIONS {
            assert!(error_of_a_tilted_flank(n, 1.5).unwrap() < 1e-12);
            let [coarse, fine] = [n, 4 * n].map(|n| error_of_a_tilted_flank(n, 0.61).unwrap());
            assert!(fine < coarse / 4.0, "{n}: {coarse} {fine}");
        }
    }

    #[test]
    fn the_table_in_the_book_is_what_is_printed() {
        assert_eq!(
            make_up(5, 0.0012, 2).unwrap().to_string(),
            include_str!("../../../book/examples/thread_torque.txt")
        );
    }
}
