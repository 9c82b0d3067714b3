//! A ring on a conical washer: pressed on, then dragged along, by Newton's method with the consistent tangent of the contact.
//! A verification example, dense and small, not a solver to be grown. Needs no feature.
//!
//! ```sh
//! cargo run --example dragged_ring
//! ```

use jointproof::contact::interaction::PressureExponential;
use jointproof::contact::slide_line::element::{ExponentialLaw, Isl21aElement, Isl21aNodes, Isl21aState, IslContact};
use jointproof::element::{Contribution, Parameters};
use nalgebra::{SMatrix, Vector1, Vector2, Vector4};

/// The free degrees of freedom: the translations of both nodes of the ring. The washer stands still.
const FREE: usize = 4;

type Ring = Parameters<Isl21aElement<PressureExponential>, f64, 1, 12>;

const MU: f64 = 0.5;
const CONTACT: Ring =
    Parameters { start: ExponentialLaw { c0: 0.05, p0: 40.0 }, contact: Some(IslContact { k_stick: 2e3, mu: MU }) };

/// Springs tie each node to its place, which the load moves: how stiff they are.
const SPRING: f64 = 500.0;

/// What counts in the matrix.
#[derive(Clone, Copy, PartialEq)]
pub enum Tangent {
    /// The derivative of all forces.
    Consistent,
    /// While it slips, without what the pressure does to the shear.
    ShearHeld,
}

/// The washer, from its inner edge up.
fn washer() -> [Vector2<f64>; 2] {
    [Vector2::new(1.0, 0.0), Vector2::new(5.0, 2.0)]
}

// ANCHOR: contact
/// What the contact adds at these places of the ring, and the state after.
fn contact(
    element: &Ring,
    ring: &Vector4<f64>,
    before: &Isl21aState<f64>,
) -> (Contribution<f64, 1, 12>, Isl21aState<f64>) {
    let slaves = [ring.fixed_rows::<2>(0).into_owned(), ring.fixed_rows::<2>(2).into_owned()];
    let nodes = Isl21aNodes::new(slaves, [washer(); 2]);
    element.newton(&nodes, &Vector1::zeros(), before).expect("the ring stays over the washer")
}
// ANCHOR_END: contact

/// The same forces with a shear that is held: as if it stuck without a stiffness.
fn shear_held(ring: &Vector4<f64>, after: &Isl21aState<f64>) -> Contribution<f64, 1, 12> {
    let held = Parameters { contact: Some(IslContact { k_stick: 1e-12, mu: 1e12 }), ..CONTACT };
    contact(&held, ring, after).0
}

/// The shear stress over the pressure at both nodes, from the forces along the washer and normal to it.
fn shear(found: &Contribution<f64, 1, 12>) -> [f64; 2] {
    let [inner, outer] = washer();
    let along = outer - inner;
    [0, 2].map(|at| {
        let force = found.forces.fixed_rows::<2>(at).into_owned();
        -along.dot(&force) / along.perp(&force)
    })
}

/// Whether a node slips.
fn slips(found: &Contribution<f64, 1, 12>) -> bool {
    shear(found).iter().any(|ratio| ratio.abs() > MU - 1e-9)
}

/// The size of each step of an increment in which the springs' other ends are at `ends`, until it is below 1e-14, and the state
/// after it.
fn increment(
    ring: &mut Vector4<f64>,
    ends: &Vector4<f64>,
    before: &Isl21aState<f64>,
    tangent: Tangent,
) -> (Vec<f64>, Isl21aState<f64>) {
    let mut sizes = Vec::new();
    while sizes.len() < 60 && sizes.last().is_none_or(|&size| size > 1e-14) {
        // ANCHOR: step
        let (found, after) = contact(&CONTACT, ring, before);
        let forces = found.forces.fixed_rows::<FREE>(0) - (*ring - ends) * SPRING;
        let counts = if tangent == Tangent::ShearHeld && slips(&found) { shear_held(ring, &after) } else { found };
        let of_contact = counts.stiffness.fixed_view::<FREE, FREE>(0, 0).into_owned();
        let matrix = of_contact - SMatrix::<f64, FREE, FREE>::identity() * SPRING;
        let step = matrix.lu().solve(&-forces).expect("the springs hold the ring");
        *ring += step;
        // ANCHOR_END: step
        sizes.push(step.amax());
    }
    (sizes, contact(&CONTACT, ring, before).1)
}

/// The steps of two increments: a push that sticks, and a pull along the washer that slips; and the shear stress over the pressure
/// after each.
pub fn steps(tangent: Tangent) -> [(Vec<f64>, f64); 2] {
    let start = Vector4::new(2.0, 0.52, 2.5, 0.77);
    let mut ring = start;
    let nowhere = Isl21aState { g: Vector2::new(-0.5, -0.5), s12: Vector2::zeros() };
    let mut state = Isl21aState { s12: Vector2::zeros(), ..contact(&CONTACT, &ring, &nowhere).1 };
    [Vector4::new(0.0, -0.1, 0.0, -0.1), Vector4::new(-0.3, -0.25, -0.3, -0.25)].map(|load| {
        let (sizes, after) = increment(&mut ring, &(start + load), &state, tangent);
        let ratio = shear(&contact(&CONTACT, &ring, &state).0)[0];
        state = after;
        (sizes, ratio)
    })
}

fn main() {
    for (tangent, name) in [(Tangent::Consistent, "the consistent tangent"), (Tangent::ShearHeld, "the shear held")] {
        for ((sizes, shear), what) in steps(tangent).into_iter().zip(["pushed", "dragged"]) {
            println!("{what}, with {name}: {} steps, S12/S11 = {shear:.3}", sizes.len());
            for size in sizes {
                println!("  {size:.1e}");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{MU, Tangent, steps};

    /// Once stick and slip no longer change, each step is in proportion to the square of the one before, down to rounding.
    #[test]
    fn with_the_consistent_tangent_the_error_is_squared() {
        let [(pushed, stuck), (dragged, slipped)] = steps(Tangent::Consistent);
        assert!(stuck.abs() < MU - 0.01 && (slipped.abs() - MU).abs() < 1e-12, "{stuck}, {slipped}");
        for sizes in [&pushed, &dragged] {
            assert!(sizes.len() <= 7, "{sizes:?}");
            for pair in sizes.windows(2).filter(|pair| pair[0] < 1e-2) {
                assert!(pair[1] < 100.0 * pair[0] * pair[0] + 1e-15, "{sizes:?}");
            }
        }
    }

    /// Without what the pressure does to the shear it is linear in slip, and no other in stick.
    #[test]
    fn with_the_shear_held_the_convergence_is_linear_in_slip() {
        let [(pushed, _), (dragged, slipped)] = steps(Tangent::ShearHeld);
        let [(as_pushed, _), (_, as_slipped)] = steps(Tangent::Consistent);
        assert_eq!(pushed, as_pushed);
        assert!((slipped - as_slipped).abs() < 1e-12);
        assert!(dragged.len() >= 9, "{dragged:?}");
        let last: Vec<_> = dragged.iter().copied().filter(|&size| (1e-13..1e-4).contains(&size)).collect();
        assert!(last.windows(2).all(|pair| pair[1] > 1e-3 * pair[0]), "{dragged:?}");
    }
}
