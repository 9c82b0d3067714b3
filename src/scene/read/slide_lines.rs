//! Slide lines as a scene file states them.

use super::given::{Given, count, numbers};
use super::keys;
use super::names::{named, refer_all};
use crate::error::Error;
use crate::isl::{Interaction, Surface};
use crate::quantity::{Domain, FRACTION};
use crate::scene::json::{Read, Reader};
use crate::scene::model::{Named, SceneNode};
use crate::slide_line::{Interpolation, SlideLine};

/// The slide lines of a scene; their nodes have the numbers of the scene's.
pub(super) fn slide_lines_of(reader: &mut Reader, nodes: &Named<Option<SceneNode>>) -> Read<Named<Option<Surface>>> {
    named(reader, |reader, _| slide_line(reader, nodes))
}

fn slide_line(reader: &mut Reader, nodes: &Named<Option<SceneNode>>) -> Read<Option<Surface>> {
    let place = reader.place();
    let (mut interpolation, mut ends, mut smoothing) = (None, None, None);
    let (mut interaction, mut damping, mut friction) = (Some(Interaction::default()), None, None);
    let is_object = reader.record(&keys::SLIDE_LINE, |reader, key| {
        match key {
            0 => interpolation = Some(type_of(reader)?),
            1 => ends = Some(refer_all(reader, nodes, "an array of nodes, in sequence", "node")?),
            2 => smoothing = reader.number(FRACTION.domain)?,
            3 => interaction = pressure_of(reader)?,
            4 => damping = all_of(reader, keys::DAMPING)?,
            _ => friction = all_of(reader, keys::FRICTION)?,
        }
        Ok(())
    })?;
    for (missing, key) in [(interpolation.is_none(), "type"), (ends.is_none(), "nodes")] {
        if is_object && missing {
            reader.fault(place, format!("a slide line without {key:?}"), "a slide line with type and nodes");
        }
    }
    let numbers = ends.flatten().and_then(|ends| ends.into_iter().collect::<Option<Vec<u32>>>());
    let (Some(interpolation), Some(numbers), Some(interaction)) = (interpolation.flatten(), numbers, interaction)
    else {
        return Ok(None);
    };
    match surface(interpolation, numbers, smoothing, interaction, damping, friction) {
        Ok(surface) => Ok(Some(surface)),
        Err(error) => {
            reader.reject(place, &error);
            Ok(None)
        }
    }
}

fn surface(
    interpolation: Interpolation,
    numbers: Vec<u32>,
    smoothing: Option<f64>,
    mut interaction: Interaction,
    damping: Option<[f64; 3]>,
    friction: Option<[f64; 2]>,
) -> Result<Surface, Error> {
    let mut line = SlideLine::new(interpolation, numbers)?;
    if let Some(f) = smoothing {
        line = line.smoothed(f)?;
    }
    if let Some([mu0, c0, eta]) = damping {
        interaction = interaction.with_damping(mu0, c0, eta)?;
    }
    if let Some([mu, k_stick]) = friction {
        interaction = interaction.with_friction(mu, k_stick)?;
    }
    Ok(Surface { line, interaction })
}

fn type_of(reader: &mut Reader) -> Read<Option<Interpolation>> {
    let allowed = keys::TYPES.map(|(name, _)| name).join(" or ");
    let place = reader.place();
    let Some(name) = reader.string(&allowed)? else { return Ok(None) };
    let found = keys::TYPES.into_iter().find(|(known, _)| *known == name).map(|(_, interpolation)| interpolation);
    if found.is_none() {
        reader.fault(place, format!("{name:?}"), allowed);
    }
    Ok(found)
}

/// The law, by which of its parameters are given.
fn pressure_of(reader: &mut Reader) -> Read<Option<Interaction>> {
    use Given::{Absent, Number};
    let place = reader.place();
    let Some(given) = numbers(reader, keys::PRESSURE)? else { return Ok(None) };
    let law = match given {
        [Number(k), Absent, Absent, Absent] => Interaction::linear(k),
        [Absent, Number(c0), Number(p0), Absent] => Interaction::exponential(c0, p0),
        [Absent, Absent, Absent, Number(tolerance)] => Interaction::hard(tolerance),
        _ => {
            if !given.contains(&Given::Faulty) {
                let found = format!("{} parameters", count(&given));
                reader.fault(place, found, "k alone, c0 and p0, or tolerance alone");
            }
            return Ok(None);
        }
    };
    match law {
        Ok(law) => Ok(Some(law)),
        Err(error) => {
            reader.reject(place, &error);
            Ok(None)
        }
    }
}

/// An object of which every number must be given.
fn all_of<const N: usize>(reader: &mut Reader, keys: [(&str, Domain); N]) -> Read<Option<[f64; N]>> {
    let place = reader.place();
    let Some(given) = numbers(reader, keys)? else { return Ok(None) };
    if given.contains(&Given::Absent) {
        let allowed = format!("all of {}", keys.map(|(name, _)| name).join(", "));
        reader.fault(place, format!("{} parameters", count(&given)), allowed);
    }
    let all: Vec<f64> = given.into_iter().filter_map(Given::number).collect();
    Ok(all.try_into().ok())
}
