//! What of the scene each connector section gives: kinds, parameters and the outputs that they suffice for.

use super::log::Log;
use super::model::{Behavior, Model, Section, Stop};
use super::motion::radians;
use super::source::Place;
use super::terms::{ASSEMBLED, COMPONENTS, PREDEFINED, is_rotation, kind};
use crate::scene::json::some_of;
use crate::scene::kind::{Dimension, Fallback, Kind};
use crate::scene::model::Parameter;
use crate::scene::plan::answerable;

/// An element of the scene for each connector of a section.
pub(super) struct Planned {
    pub(super) kind: &'static Kind,
    pub(super) parameters: Vec<(&'static str, f64, Place)>,
    /// One bit per output of the kind, set if no parameter is missing for it.
    pub(super) outputs: u64,
}

/// The elements that each connector of a section is.
pub(super) fn planned(model: &Model, section: &Section, dimension: Dimension, log: &mut Log) -> Vec<Planned> {
    let kinds = kinds(section, dimension, log);
    let Some(behavior) = behavior(model, section, log) else { return with(kinds, |_| Vec::new()) };
    for (what, place) in &behavior.others {
        log.leave_out(*place, *what, true);
    }
    let mut used = Used::default();
    let planned = with(kinds, |kind| parameters(kind, behavior, &mut used, log));
    if !planned.is_empty() {
        used.check(behavior, log);
    }
    planned
}

fn with(
    kinds: Vec<&'static Kind>,
    mut parameters: impl FnMut(&'static Kind) -> Vec<(&'static str, f64, Place)>,
) -> Vec<Planned> {
    let plan = |kind: &'static Kind| {
        let parameters = parameters(kind);
        let given = |name| parameters.iter().find(|(known, ..)| *known == name).map(|&(_, number, _)| number);
        let all: Vec<_> =
            kind.parameters().map(|(name, _)| given(name).map_or(Parameter::Absent, Parameter::One)).collect();
        Planned { kind, outputs: answerable(kind, &all, 1), parameters }
    };
    kinds.into_iter().map(plan).collect()
}

fn kinds(section: &Section, dimension: Dimension, log: &mut Log) -> Vec<&'static Kind> {
    if let [(first, _), (second, _)] = &section.kinds[..] {
        let is_pair = |pair: &&([&str; 2], &str)| pair.0 == [first, second] || pair.0 == [second, first];
        if let Some(kind) = ASSEMBLED.iter().find(is_pair).and_then(|(_, name)| kind(name, dimension)) {
            return vec![kind];
        }
    }
    let mut kinds = Vec::new();
    for (name, place) in &section.kinds {
        match kind(name, dimension) {
            Some(kind) => kinds.push(kind),
            None => log.leave_out(*place, format!("connectors of type {name}"), true),
        }
    }
    kinds
}

fn behavior<'m>(model: &'m Model, section: &Section, log: &mut Log) -> Option<&'m Behavior> {
    let (label, place) = section.behavior.as_ref()?;
    let behavior = model.behaviors.get(&label.key);
    if behavior.is_none() {
        let names = some_of(model.behaviors.keys());
        let allowed = if names.is_empty() { "no behavior, there are none".into() } else { format!("one of {names}") };
        log.fault(*place, format!("no connector behavior {:?}", label.shown), allowed);
    }
    behavior
}

/// What of a behavior the kinds of a section use.
#[derive(Default)]
struct Used {
    friction: bool,
    stops: Vec<u8>,
    references: Vec<u8>,
}

impl Used {
    /// What no kind of the section uses is left out.
    fn check(&self, behavior: &Behavior, log: &mut Log) {
        if let Some(friction) = behavior.predefined().filter(|_| !self.friction) {
            log.leave_out(friction.place, "friction of this type of connection", true);
        }
        for Stop { component, place, .. } in behavior.stops.iter().filter(|stop| !self.stops.contains(&stop.component))
        {
            log.leave_out(*place, format!("component {component}, in which this type of connection has no stop"), true);
        }
        for (component, (_, place)) in &behavior.reference {
            if !self.references.contains(component) {
                let what = format!("component {component}, in which this type of connection has no reference");
                log.leave_out(*place, what, true);
            }
        }
    }
}

fn parameters(
    kind: &'static Kind,
    behavior: &Behavior,
    used: &mut Used,
    log: &mut Log,
) -> Vec<(&'static str, f64, Place)> {
    let mut all = friction(kind, behavior, used, log);
    let has = |name: &str| kind.parameters().any(|(known, _)| known == name);
    let named = |component: u8, which: usize| COMPONENTS[usize::from(component - 1)][which];
    for Stop { component, limits, .. } in &behavior.stops {
        let is_used = has(named(*component, 1));
        for (limit, which) in limits.iter().zip(1..) {
            if let Some((number, place)) = limit.filter(|_| is_used) {
                all.push((named(*component, which), in_radians(*component, number), place));
                if is_rotation(*component) && number != 0.0 && number.abs() < std::f64::consts::TAU {
                    let what = format!("{number:?}, read in degrees: in radians it would be {:?}", number.to_degrees());
                    log.leave_out(place, what, true);
                }
            }
        }
        if is_used {
            used.stops.push(*component);
        }
    }
    for &(component, (number, place)) in &behavior.reference {
        if has(named(component, 0)) {
            all.push((named(component, 0), in_radians(component, number), place));
            used.references.push(component);
        }
    }
    all
}

fn in_radians(component: u8, number: f64) -> f64 {
    if is_rotation(component) { radians(number) } else { number }
}

fn friction(
    kind: &'static Kind,
    behavior: &Behavior,
    used: &mut Used,
    log: &mut Log,
) -> Vec<(&'static str, f64, Place)> {
    let Some(friction) = behavior.predefined() else { return Vec::new() };
    let Some((_, names)) = PREDEFINED.iter().find(|(name, _)| *name == kind.name) else { return Vec::new() };
    used.friction = true;
    let mut all = Vec::new();
    for (k, name) in names.iter().enumerate() {
        match friction.parameters.get(k) {
            Some(&(Some(number), place)) => all.push((*name, number, place)),
            given => {
                let is_required = kind.parameters().any(|parameter| parameter == (*name, Fallback::Required));
                if is_required {
                    let place = given.map_or(friction.place, |&(_, place)| place);
                    let allowed = format!("a number in field {}, the {}", k + 1, kind.meaning(name));
                    log.fault(
                        place,
                        format!("no {name:?}, needed for the friction of {}", kind.name.to_uppercase()),
                        allowed,
                    );
                }
            }
        }
    }
    if let Some(&(Some(number), place)) = friction.parameters.get(names.len()) {
        let allowed = format!("{} fields: {}", names.len(), names.join(", "));
        log.fault(place, format!("{number:?} in field {}", names.len() + 1), allowed);
    }
    match friction.mu {
        Some((mu, place)) => all.push(("mu", mu, place)),
        None => log.fault(friction.place, "friction without a coefficient", "*FRICTION below it"),
    }
    match friction.stick {
        Some((stick, place)) => all.push(("k_stick", stick, place)),
        None => {
            log.leave_out(friction.place, "STICK STIFFNESS is not given: outputs that need it are not wanted", true);
        }
    }
    all
}
