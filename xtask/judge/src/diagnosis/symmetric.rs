//! A stiffness by rotation vectors in the place of one by spins.
//!
//! Spins about different axes do not commute: the block of a node's own spin has a skew part, the node's moment. By rotation
//! vectors, counted from where the node is, it has none.
//!
//! By a rotation vector θ that is counted from elsewhere, the stiffness is K T(θ), where T turns a change of θ into a spin.
//! That is not named: no formula has θ among its inputs. Orientations come as unit vectors, of the second node often one
//! alone, and the triad from which a program counts is known to that alone. A θ fitted to its answers would be three free
//! numbers a point, where no repair that is tried has any.

use super::evidence::{Evidence, Sample};
use super::permuted::transpose;
use crate::question::sizes;
use jointproof::formula::Field;
use jointproof::toolkit::verify::Known;

/// The blocks whose symmetric parts explain these numbers, in words.
pub(super) fn cause(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let blocks = blocks(evidence.court.formula.outputs());
    let which = blocks.chunks(1).chain([blocks.as_slice()]).find(|blocks| explains(evidence, off, blocks))?;
    let names: Vec<_> = which.iter().map(|(name, _)| *name).collect();
    Some(format!("by rotation vectors, not by spins: the symmetric part of {}", names.join(", ")))
}

/// The blocks of a node's own spin: names, and where they begin.
fn blocks(outputs: &'static [Field]) -> Vec<(&'static str, usize)> {
    let mut first = 0;
    let mut blocks = Vec::new();
    for output in outputs {
        let nodes: Vec<_> = output.name.split('_').skip(1).collect();
        if let [one, other] = *nodes
            && one == other
            && one.starts_with('t')
            && output.len() == 9
        {
            blocks.push((output.name, first));
        }
        first += output.len();
    }
    blocks
}

/// Whether every number that is off, and every other one of the same part, is what the symmetric parts of these blocks have.
fn explains(evidence: &Evidence<'_>, off: &[usize], blocks: &[(&str, usize)]) -> bool {
    let m = sizes(evidence.court.formula)[1];
    let mut mirrored: Vec<_> = (0..evidence.names.len()).collect();
    // As many as there are inputs, or none.
    let derivatives = (mirrored.len() - m) / m;
    for (_, first) in blocks {
        transpose(&mut mirrored, *first, [m, derivatives]);
    }
    let half = |sample: &Sample, place: usize| {
        let pair = [sample.expected[place]?, sample.expected[mirrored[place]]?];
        Some(Known::combined(pair.into_iter().map(|known| (known, 0.5))))
    };
    let is_touched = |place: usize| mirrored[place] != place;
    off.iter().all(|&place| is_touched(place))
        && evidence.parts().into_iter().filter(|part| off.iter().any(|place| part.contains(place))).all(|part| {
            part.filter(|&place| is_touched(place)).all(|place| evidence.is_always(place, |sample| half(sample, place)))
        })
}
