//! The rotations of the nodes from one state to the next.

use crate::scene::model::{Changes, Frame};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::fmt;

/// A rotation beyond this is followed in parts.
const FOLLOWED: f64 = FRAC_PI_2;
/// The largest rotation of a part.
const PART: f64 = FRAC_PI_4;
/// The largest number of parts: 128 turns.
const MOST_PARTS: f64 = 1024.0;
/// The sine of the largest angle between rotation vectors along one axis, which are given in decimals.
const ALONG: f64 = 1e-9;

/// A rotation that is ambiguous, since only its end is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// The state, counted from 0.
    pub state: usize,
    /// The node.
    pub node: String,
    /// The size of the change of the rotation vector.
    pub angle: f64,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { state, node, angle } = self;
        let degrees = angle.to_degrees();
        write!(
            f,
            "frames[{state}], node {node:?}: its rotation vector changes by {angle:.4} ({degrees:.1}°) and not along one axis, so how it \
             turned is not known; angles take the shortest way. Add states between"
        )
    }
}

/// Rotation vectors of nodes at two states, between which they are known.
pub(super) struct Way {
    /// In how many parts it is followed.
    pub(super) parts: usize,
    turns: Changes<[f64; 3]>,
    from: Vec<[f64; 3]>,
}

impl Way {
    /// From these rotation vectors to those of a frame; and the nodes whose way is not known, with the change.
    pub(super) fn new(from: Vec<[f64; 3]>, frame: &Frame) -> (Self, Vec<(u32, f64)>) {
        let (mut parts, mut unknown) = (1.0_f64, Vec::new());
        let mut way = Self { parts: 1, turns: frame.turns.clone(), from };
        for ((from, to), &node) in way.from.iter_mut().zip(&way.turns.to).zip(&*way.turns.of) {
            let [old, new] = [*from, *to].map(nalgebra::Vector3::from);
            let angle = (new - old).norm();
            let is_along = old.cross(&new).norm() <= ALONG * old.norm() * new.norm();
            if is_along && angle <= MOST_PARTS * PART {
                parts = parts.max(if angle < FOLLOWED { 1.0 } else { (angle / PART).ceil() });
            } else if angle >= PI {
                unknown.push((node, angle));
                // It arrives at once.
                *from = *to;
            }
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is between 1 and 1024")]
        let parts = parts as usize;
        way.parts = parts;
        (way, unknown)
    }

    /// The frame after so many of the parts, with the loads of its end: only nodes turn on the way.
    pub(super) fn after(&self, part: usize, frame: &Frame) -> Frame {
        #[expect(clippy::cast_precision_loss, reason = "there are at most 1024")]
        let share = part as f64 / self.parts as f64;
        let between = |(from, to): (&[f64; 3], &[f64; 3])| std::array::from_fn(|k| from[k] + (to[k] - from[k]) * share);
        let to = self.from.iter().zip(&self.turns.to).map(between).collect();
        let turns = Changes { of: self.turns.of.clone(), to };
        Frame { time: frame.time, turns, loads: frame.loads.clone(), ..Frame::default() }
    }
}
