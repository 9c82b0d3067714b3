//! A stiffness with respect to rotation vectors instead of spins.
//!
//! Spins about different axes do not commute: the block of a node's own spin has a skew part, given by the node's
//! moment. With respect to rotation vectors measured from the current orientation, it has none.
//!
//! With respect to a rotation vector θ measured from another orientation, the stiffness is K T(θ), where T maps a
//! change of θ to a spin. This case is not diagnosed: no formula has θ among its inputs. Orientations are given as
//! unit vectors, often a single one for the second node, and only the program knows the triad from which it measures.
//! Fitting θ to its answers would use three free numbers per point, whereas all the other mistakes tried have none.

use super::model::Map;
use super::permuted::transpose;
use super::sample::Evidence;
use crate::question::sizes;
use jointproof::formula::Field;

/// The symmetric parts of each block, and of all, with words for them.
pub(super) fn parts(evidence: &Evidence<'_>) -> Vec<(String, Map)> {
    let m = sizes(evidence.court.formula)[1];
    let blocks = blocks(evidence.court.formula.outputs());
    let all = Some(blocks.as_slice()).filter(|blocks| blocks.len() > 1);
    let part = |blocks: &[(&str, usize)]| {
        let mut mirrored: Vec<_> = (0..evidence.names.len()).collect();
        // As many derivatives as there are inputs, or none.
        let derivatives = (mirrored.len() - m) / m;
        for (_, first) in blocks {
            transpose(&mut mirrored, *first, [m, derivatives]);
        }
        let halves = mirrored.iter().enumerate().filter(|(place, other)| place != *other);
        let map = halves.map(|(place, &other)| (place, vec![(place, 0.5), (other, 0.5)])).collect();
        let names: Vec<_> = blocks.iter().map(|(name, _)| *name).collect();
        (format!("by rotation vectors, not by spins: the symmetric part of {}", names.join(", ")), map)
    };
    blocks.chunks(1).chain(all).map(part).collect()
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
