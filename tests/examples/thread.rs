//! A thread that carries an axial load: how the turns share it, by Newton's method with the consistent tangent of the contact.
//! A verification example, dense and small, not a solver to be grown. Needs no feature.
//!
//! ```sh
//! cargo run --example thread
//! ```

use jointproof::contact::interaction::PressureExponential;
use jointproof::contact::slide_line::element::{ExponentialLaw, Isl21aElement, Isl21aNodes, Isl21aState, IslContact};
use jointproof::element::{Contribution, Parameters};
use nalgebra::{SMatrix, SVector, Vector1, Vector2};

/// Turns of the thread, each a ring; every one has a flank with two nodes.
pub const TURNS: usize = 4;
/// The translations of all nodes of the pin, in the order of the turns. The box is rigid.
const FREE: usize = 4 * TURNS;

const MU: f64 = 0.1;
/// In mm, N/mm², N/mm³.
const CONTACT: Parameters<Isl21aElement<PressureExponential>, f64, 1, 12> =
    Parameters { start: ExponentialLaw { c0: 1e-3, p0: 20.0 }, contact: Some(IslContact { k_stick: 1e5, mu: MU }) };

/// In N/mm: of the pin along its axis, from a node to that of the next turn, and of the hoop at a node.
const AXIAL: f64 = 4e7;
const HOOP: f64 = 1e8;

/// The flank of a turn of the box: it runs outwards and up, and that of the pin rests on it.
fn flank(turn: usize) -> [Vector2<f64>; 2] {
    let up = 6.0 * [0.0, 1.0, 2.0, 3.0][turn];
    [Vector2::new(46.0, up), Vector2::new(52.0, up + 4.5)]
}

/// The nodes of the pin, on their flanks.
fn start() -> SVector<f64, FREE> {
    SVector::from_fn(|k, _| {
        let [inner, outer] = flank(k / 4);
        let along = [1.0 / 6.0, 5.0 / 6.0][k / 2 % 2];
        (inner + (outer - inner) * along)[k % 2]
    })
}

type States = [Isl21aState<f64>; TURNS];
type Found = (Contribution<f64, 1, 12>, Isl21aState<f64>);

// ANCHOR: turn
/// What a turn adds at these places of the pin, and its state after.
fn contact(turn: usize, pin: &SVector<f64, FREE>, before: &States) -> Found {
    let node = |k: usize| pin.fixed_rows::<2>(4 * turn + 2 * k).into_owned();
    let nodes = Isl21aNodes::new([node(0), node(1)], [flank(turn); 2]);
    CONTACT.newton(&nodes, &Vector1::zeros(), &before[turn]).expect("the nodes stay over their flank")
}
// ANCHOR_END: turn

/// The shear stress over the pressure at both nodes of a turn, from the forces along the flank and normal to it.
fn shear(turn: usize, forces: &SVector<f64, 12>) -> [f64; 2] {
    let [inner, outer] = flank(turn);
    let along = outer - inner;
    [0, 2].map(|at| {
        let force = forces.fixed_rows::<2>(at).into_owned();
        -along.dot(&force) / along.perp(&force)
    })
}

/// How stiff the pin is: hoops, and springs along the axis from turn to turn.
fn pin_stiffness() -> SMatrix<f64, FREE, FREE> {
    let mut k = SMatrix::zeros();
    for r in (0..FREE).step_by(2) {
        k[(r, r)] += HOOP;
    }
    for z in (1..FREE - 4).step_by(2) {
        for (row, column, sign) in [(z, z, 1.0), (z + 4, z + 4, 1.0), (z, z + 4, -1.0), (z + 4, z, -1.0)] {
            k[(row, column)] += AXIAL * sign;
        }
    }
    k
}

/// What an increment came to.
pub struct Increment {
    /// The load, N.
    pub load: f64,
    /// The size of each step of Newton's method, mm.
    pub steps: Vec<f64>,
    /// The axial force of every turn, N.
    pub shares: [f64; TURNS],
    /// The greatest torque that the thread transmits, as if μ were 1, N mm.
    pub torque: f64,
    /// The shear stress over the pressure at every node.
    pub shear: [[f64; 2]; TURNS],
}

/// The pin is pulled at its first turn, on and partly back.
///
/// # Panics
/// Where a node leaves its flank, which these loads do not make it do.
pub fn loaded() -> Vec<Increment> {
    let (start, elastic) = (start(), pin_stiffness());
    let mut pin = start;
    // Nothing sheared yet, where the nodes are.
    let none = Vector2::zeros();
    let nowhere = [Isl21aState { g: none, s12: none }; TURNS];
    let mut states = [0, 1, 2, 3].map(|turn| Isl21aState { s12: none, ..contact(turn, &start, &nowhere).1 });
    let mut increments = Vec::new();
    for load in [2.5e5, 5e5, 1e6, 5e5] {
        let mut steps = Vec::new();
        while steps.len() < 60 && steps.last().is_none_or(|&size| size > 1e-13) {
            // ANCHOR: step
            let mut forces = -elastic * (pin - start);
            let mut matrix = -elastic;
            for node in [1, 3] {
                forces[node] -= load / 2.0;
            }
            for turn in 0..TURNS {
                let ((found, _), at) = (contact(turn, &pin, &states), 4 * turn);
                let mut of_turn = forces.fixed_rows_mut::<4>(at);
                of_turn += found.forces.fixed_rows::<4>(0);
                let mut block = matrix.fixed_view_mut::<4, 4>(at, at);
                block += found.stiffness.fixed_view::<4, 4>(0, 0);
            }
            let step = matrix.lu().solve(&-forces).expect("hoops and flanks hold the pin");
            pin += step;
            // ANCHOR_END: step
            steps.push(step.amax());
        }
        let found: [_; TURNS] = std::array::from_fn(|turn| contact(turn, &pin, &states));
        states = found.map(|(_, after)| after);
        let found = found.map(|(turn, _)| turn);
        increments.push(Increment {
            load,
            steps,
            shares: std::array::from_fn(|turn| found[turn].forces[1] + found[turn].forces[3]),
            torque: found.iter().map(|turn| turn.residuals[0]).sum(),
            shear: std::array::from_fn(|turn| shear(turn, &found[turn].forces)),
        });
    }
    increments
}

fn main() {
    for Increment { load, steps, shares, torque, shear } in loaded() {
        println!("{load:7.0} N: the turns carry {shares:.0?}, torque {torque:.3e} N mm, {} steps", steps.len());
        println!("           S12/S11 {shear:.3?}");
        for size in steps {
            println!("  {size:.1e}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Increment, MU, loaded};

    #[test]
    fn the_turns_carry_the_load_the_first_the_most() {
        for Increment { load, shares, .. } in loaded() {
            assert!((shares.iter().sum::<f64>() - load).abs() < 1e-9 * load, "{shares:?}");
            assert!(shares.is_sorted_by(|one, next| one > next), "{shares:?}");
        }
    }

    /// Once stick and slip no longer change, each step is in proportion to the square of the one before, down to rounding.
    #[test]
    fn the_error_is_squared() {
        for Increment { load, steps, .. } in loaded() {
            assert!(steps.len() <= 8, "{load}: {steps:?}");
            for pair in steps.windows(2).filter(|pair| pair[0] < 1e-4) {
                assert!(pair[1] < 1e4 * pair[0] * pair[0] + 1e-14, "{load}: {steps:?}");
            }
        }
    }

    /// Pulled, all slip; where the load is taken back, the first turn slips the other way and the others stick.
    #[test]
    fn it_slips_under_the_load_and_sticks_where_it_is_taken_back() {
        let [.., pulled, back] = loaded().try_into().ok().map(|all: [Increment; 4]| all.map(|one| one.shear)).unwrap();
        let slips = |ratio: f64| ratio.abs() > MU - 1e-9;
        assert!(pulled.iter().flatten().all(|&ratio| slips(ratio) && ratio < 0.0), "{pulled:?}");
        assert!(back[0].iter().all(|&ratio| slips(ratio) && ratio > 0.0), "{back:?}");
        assert!(back[1..].iter().flatten().all(|&ratio| !slips(ratio)), "{back:?}");
    }
}
