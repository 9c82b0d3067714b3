//! Requested outputs: *ELEMENT OUTPUT, *EL PRINT, *EL FILE.

use super::block::{Block, Line};
use super::log::Log;
use super::model::{Model, Request};
use super::reading::Reading;
use super::sets::are_in;
use crate::scene::abaqus::{meant, same_outputs};
use crate::scene::kind::Kind;

pub(super) fn read(reading: &mut Reading, block: &Block) {
    let label = block.label(&mut reading.log, "ELSET").map(|(label, _)| label);
    if block.parameter("ELSET").is_some() && label.is_none() {
        return;
    }
    let variable = block.parameter("VARIABLE").and_then(|variable| variable.value.as_deref());
    let is_all = variable.is_some_and(|variable| variable.eq_ignore_ascii_case("ALL"));
    let fields = block.full(reading.sources).flat_map(Line::fields).filter(|field| !field.text.is_empty());
    let names = fields.map(|field| (field.text.to_uppercase(), field.place)).collect();
    let (of, place) = (label.map(|label| (reading.scope, label)), block.place);
    reading.model.requests.push(Request { of, names: (!is_all).then_some(names), place });
}

/// The requests for outputs that a scene has, each with the elements that it is about.
#[derive(Default)]
pub(super) struct Requested(Vec<(Names, Vec<bool>)>);

/// Names of outputs of the scene; `None` stands for all.
type Names = Option<Vec<&'static str>>;

impl Requested {
    /// The requests about elements that the scene has, which are of these kinds; what of them is left out.
    pub(super) fn of(model: &Model, kinds: &[&'static Kind], has: &dyn Fn(usize) -> bool, log: &mut Log) -> Self {
        let mut all = Self::default();
        let known: Vec<_> = kinds.iter().flat_map(|kind| kind.outputs()).map(|(name, _)| name).collect();
        for Request { of, names, place } in &model.requests {
            let is_of = match of {
                None => vec![true; model.elements.len()],
                Some((scope, label)) => are_in(model, *scope, &label.key, *place),
            };
            if !(0..is_of.len()).any(|index| is_of[index] && has(index)) {
                log.leave_out(*place, "outputs of elements that the scene does not have", false);
                continue;
            }
            let Some(names) = names else {
                all.0.push((None, is_of));
                continue;
            };
            let mut ours = Vec::new();
            for (name, place) in names {
                let mut same = same_outputs(name);
                same.retain(|name| known.contains(name));
                if same.is_empty() {
                    let similar = meant(name, &known).map(|similar| format!("; similar is {similar}"));
                    let what = format!("the output {name}{}", similar.as_deref().unwrap_or_default());
                    log.leave_out(*place, what, similar.is_some());
                }
                ours.extend(same);
            }
            if !ours.is_empty() {
                all.0.push((Some(ours), is_of));
            }
        }
        all
    }

    /// Whether nothing is requested that a scene has; then an element has all its outputs.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The requested outputs of an element of a kind, by its index: one bit per output.
    pub(super) fn of_element(&self, index: usize, kind: &Kind) -> u64 {
        let about = self.0.iter().filter(|(_, is_of)| is_of[index]);
        let one = |(names, _): &(Names, _)| {
            let is_wanted = |name: &str| names.as_ref().is_none_or(|names| names.contains(&name));
            let bits = kind.outputs().enumerate().filter(|(_, (name, _))| is_wanted(name));
            bits.fold(0, |mask, (bit, _)| mask | 1 << bit)
        };
        about.fold(0, |mask, request| mask | one(request))
    }
}
