//! The rotations of the nodes from one state to the next.

use crate::scene::model::Frame;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A rotation beyond this is followed in parts.
const FOLLOWED: f64 = FRAC_PI_2;
/// The largest rotation of a part.
const PART: f64 = FRAC_PI_4;
/// The largest number of parts: 128 turns.
const MOST_PARTS: f64 = 1024.0;
/// The sine of the largest angle between rotation vectors along one axis, which are given in decimals.
const ALONG: f64 = 1e-9;

/// Rotation vectors of nodes at two states, between which they are known.
pub(super) struct Way<'f> {
    /// In how many parts it is followed.
    pub(super) parts: usize,
    from: Vec<[f64; 3]>,
    frame: &'f Frame,
}

impl<'f> Way<'f> {
    /// From these rotation vectors to those of a frame; and the nodes whose way is not known, with the change.
    pub(super) fn new(mut from: Vec<[f64; 3]>, frame: &'f Frame) -> (Self, Vec<(u32, f64)>) {
        let (mut parts, mut unknown) = (1.0_f64, Vec::new());
        for ((from, to), &node) in from.iter_mut().zip(&frame.turns.to).zip(&*frame.turns.of) {
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
        (Self { parts, from, frame }, unknown)
    }

    /// A frame for states on the way, with the loads of its end: only nodes turn.
    pub(super) fn between(&self) -> Frame {
        let Frame { time, turns, loads, .. } = self.frame;
        Frame { time: *time, turns: turns.clone(), loads: loads.clone(), ..Frame::default() }
    }

    /// Turns the nodes in such a frame as far as after so many of the parts.
    pub(super) fn turn(&self, part: usize, between: &mut Frame) {
        #[expect(clippy::cast_precision_loss, reason = "there are at most 1024")]
        let share = part as f64 / self.parts as f64;
        let ends = self.from.iter().zip(&self.frame.turns.to);
        for (turn, (from, to)) in between.turns.to.iter_mut().zip(ends) {
            *turn = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * share);
        }
    }
}
