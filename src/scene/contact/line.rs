//! A slide line as a scene file states it.

use crate::error::Error;
use crate::isl::{Interaction, Pressure};
use crate::quantity::{CLEARANCE, DAMPING_FRACTION, Domain, FRACTION, MU, MU0, PRESSURE_AT_TOUCH, STIFFNESS};
use crate::scene::json::{Read, Reader};
use crate::scene::model::Node;
use crate::scene::read::{named, refer_all};
use crate::slide_line::{Interpolation, SlideLine};
use indexmap::IndexMap;

/// The keys of a slide line.
pub(in crate::scene) const LINE_KEYS: [&str; 6] = ["type", "nodes", "smoothing", "pressure", "damping", "friction"];
/// The keys of a pressure law: linear has the first, exponential the two in the middle, hard contact the last.
pub(in crate::scene) const PRESSURE_KEYS: [(&str, Domain); 4] = [
    ("k", STIFFNESS.domain),
    ("c0", CLEARANCE.domain),
    ("p0", PRESSURE_AT_TOUCH.domain),
    ("tolerance", Domain::NonNegative),
];
pub(in crate::scene) const DAMPING_KEYS: [(&str, Domain); 3] =
    [("mu0", MU0.domain), ("c0", CLEARANCE.domain), ("eta", DAMPING_FRACTION.domain)];
pub(in crate::scene) const FRICTION_KEYS: [(&str, Domain); 2] = [("mu", MU.domain), ("k_stick", STIFFNESS.domain)];
/// The types of segments.
pub(in crate::scene) const TYPES: [(&str, Interpolation); 2] = [("linear", Interpolation::Linear), ("parabolic", Interpolation::Parabolic)];

/// A slide line and what acts on it. Its nodes are numbered by their place in the scene, from 1.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Line {
    pub(super) path: SlideLine,
    pub(super) interaction: Interaction,
    pub(super) damped: bool,
    pub(super) rubs: bool,
}

/// The slide lines of a scene.
pub(in crate::scene) fn lines_of(
    reader: &mut Reader,
    nodes: &IndexMap<Box<str>, Node>,
) -> Read<IndexMap<Box<str>, Line>> {
    named(reader, |reader| line(reader, nodes))
}

fn line(reader: &mut Reader, nodes: &IndexMap<Box<str>, Node>) -> Read<Option<Line>> {
    let place = reader.place();
    let (mut kind, mut ends, mut smoothing) = (None, None, None);
    let (mut interaction, mut damping, mut friction) = (Some(Interaction::default()), None, None);
    let is_object = reader.record(&LINE_KEYS, |reader, key| {
        match key {
            0 => kind = Some(type_of(reader)?),
            1 => ends = Some(refer_all(reader, nodes, "an array of nodes, in sequence", "node")?),
            2 => smoothing = reader.number(FRACTION.domain)?,
            3 => interaction = pressure_of(reader)?,
            4 => damping = all_of(reader, DAMPING_KEYS)?,
            _ => friction = all_of(reader, FRICTION_KEYS)?,
        }
        Ok(())
    })?;
    for (missing, key) in [(kind.is_none(), "type"), (ends.is_none(), "nodes")] {
        if is_object && missing {
            reader.fault(place, format!("a slide line without {key:?}"), "a slide line with type and nodes");
        }
    }
    let (Some(Some(kind)), Some(Some(ends)), Some(interaction)) = (kind, ends, interaction) else { return Ok(None) };
    let numbers: Vec<_> = ends.into_iter().map(|node| node + 1).collect();
    let made = SlideLine::new(kind, numbers).and_then(|line| match smoothing {
        Some(f) => line.smoothed(f),
        None => Ok(line),
    });
    let interaction = complete(interaction, damping, friction);
    match made.and_then(|path| Ok((path, interaction?))) {
        Ok((path, interaction)) => {
            Ok(Some(Line { path, interaction, damped: damping.is_some(), rubs: friction.is_some() }))
        }
        Err(error) => {
            reader.reject(place, &error);
            Ok(None)
        }
    }
}

fn complete(
    interaction: Interaction,
    damping: Option<[f64; 3]>,
    friction: Option<[f64; 2]>,
) -> Result<Interaction, Error> {
    let damped = match damping {
        Some([mu0, c0, eta]) => interaction.with_damping(mu0, c0, eta)?,
        None => interaction,
    };
    match friction {
        Some([mu, k_stick]) => damped.with_friction(mu, k_stick),
        None => Ok(damped),
    }
}

fn type_of(reader: &mut Reader) -> Read<Option<Interpolation>> {
    let allowed = TYPES.map(|(name, _)| name).join(" or ");
    let place = reader.place();
    let Some(name) = reader.string(&allowed)? else { return Ok(None) };
    let kind = TYPES.into_iter().find(|(known, _)| *known == name).map(|(_, kind)| kind);
    if kind.is_none() {
        reader.fault(place, format!("{name:?}"), allowed);
    }
    Ok(kind)
}

/// The law, by which of its parameters are given.
fn pressure_of(reader: &mut Reader) -> Read<Option<Interaction>> {
    let place = reader.place();
    let law = match numbers(reader, PRESSURE_KEYS)? {
        None => return Ok(None),
        Some([Some(k), None, None, None]) => Interaction::linear(k),
        Some([None, Some(c0), Some(p0), None]) => Interaction::exponential(c0, p0),
        Some([None, None, None, Some(tolerance)]) => Interaction::hard(tolerance),
        Some(given) => {
            let count = given.iter().flatten().count();
            reader.fault(place, format!("{count} parameters"), "k alone, c0 and p0, or tolerance alone");
            return Ok(None);
        }
    };
    // Each parameter is within its domain already.
    Ok(law.ok())
}

/// An object of which every number must be given.
fn all_of<const N: usize>(reader: &mut Reader, keys: [(&str, Domain); N]) -> Read<Option<[f64; N]>> {
    let place = reader.place();
    let Some(given) = numbers(reader, keys)? else { return Ok(None) };
    if given.contains(&None) {
        reader.fault(
            place,
            format!("{} parameters", given.iter().flatten().count()),
            format!("all of {}", keys.map(|(name, _)| name).join(", ")),
        );
        return Ok(None);
    }
    Ok(Some(given.map(Option::unwrap_or_default)))
}

/// An object of numbers; one that is given badly is a fault and counts as ½.
fn numbers<const N: usize>(reader: &mut Reader, keys: [(&str, Domain); N]) -> Read<Option<[Option<f64>; N]>> {
    let mut given = [None; N];
    let is_object = reader.record(&keys.map(|(name, _)| name), |reader, key| {
        given[key] = reader.number(keys[key].1)?.or(Some(0.5));
        Ok(())
    })?;
    Ok(is_object.then_some(given))
}

impl Line {
    /// The formula of its pressure; hard contact has none.
    pub(super) fn law(&self) -> Option<&'static str> {
        match self.interaction.pressure_law() {
            Pressure::Hard { .. } => None,
            Pressure::Linear { .. } => Some("interaction.pressure_linear"),
            Pressure::Exponential { .. } => Some("interaction.pressure_exponential"),
        }
    }
}
