//! A stiffness with respect to rotation vectors instead of spins.
//!
//! Spins about different axes do not commute: the block of a node's own spin has a skew part, given by the node's
//! moment. With respect to rotation vectors measured from the current orientation, it has none.
//!
//! With respect to a rotation vector θ measured from another orientation, the stiffness is K T(θ), where T maps a
//! change of θ to a spin. This case is not diagnosed: no formula has θ among its inputs. Orientations are given as
//! unit vectors, often a single one for the second node, and only the program knows the triad from which it measures.
//! Fitting θ to its answers would use three free numbers per point, whereas all the other mistakes tried have none.

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

/// The blocks of a node's own spin: their names and first indices.
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

/// Whether all numbers of the part, wrong or right, are those obtained with the symmetric parts of these blocks.
fn explains(evidence: &Evidence<'_>, off: &[usize], blocks: &[(&str, usize)]) -> bool {
    let m = sizes(evidence.court.formula)[1];
    let mut mirrored: Vec<_> = (0..evidence.names.len()).collect();
    // As many derivatives as there are inputs, or none.
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
