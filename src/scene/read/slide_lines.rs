//! Slide lines as defined in a scene file.

use super::given::{Given, count, numbers};
use super::keys;
use super::names::{look_up, named, refer_all};
use crate::contact::isl::{Interaction, Surface};
use crate::contact::slide_line::{Interpolation, SlideLine};
use crate::formula::error::Error;
use crate::formula::quantity::{Domain, EXTENSION_ZONE, SMOOTH};
use crate::scene::json::{Read, Reader};
use crate::scene::model::{Members, Named, SceneLine, SceneNode};
use std::ops::RangeInclusive;

/// The slide lines of a scene; their nodes have the numbers of the scene.
pub(super) fn slide_lines_of(reader: &mut Reader, nodes: &Named<Option<SceneNode>>) -> Read<Named<Option<SceneLine>>> {
    named(reader, |reader| slide_line(reader, nodes))
}

fn slide_line(reader: &mut Reader, nodes: &Named<Option<SceneNode>>) -> Read<Option<SceneLine>> {
    let place = reader.place();
    let (mut interpolation, mut ends, mut frequency) = (None, Vec::new(), Some(1));
    let (mut smooth, mut extension) = (0.0, SlideLine::EXTENSION);
    let (mut interaction, mut damping, mut friction) = (Some(Interaction::default()), None, None);
    let is_object = reader.record(&keys::SLIDE_LINE, |reader, key| {
        match key {
            0 => interpolation = Some(type_of(reader)?),
            1 => ends.push(refer_all(reader, nodes, "an array of nodes, in sequence", "node")?.map(in_sequence)),
            2 => ends.push(generated(reader, nodes)?),
            3 => smooth = reader.number(SMOOTH.domain)?.unwrap_or_default(),
            4 => extension = reader.number(EXTENSION_ZONE.domain)?.unwrap_or(extension),
            5 => interaction = pressure_of(reader)?,
            6 => damping = all_of(reader, keys::DAMPING)?,
            7 => friction = all_of(reader, keys::FRICTION)?,
            _ => frequency = whole(reader, 0..=u32::MAX)?,
        }
        Ok(())
    })?;
    if is_object && interpolation.is_none() {
        reader.fault(place, "a slide line without \"type\"", "a slide line with type and nodes");
    }
    if is_object && ends.len() != 1 {
        let found = if ends.is_empty() { "without \"nodes\"" } else { "with \"nodes\" and \"generate\"" };
        reader.fault(place, format!("a slide line {found}"), "a slide line with type and nodes, or generate");
    }
    let numbers = ends.into_iter().next().flatten().and_then(|ends| ends.into_iter().collect::<Option<Vec<u32>>>());
    let (Some(interpolation), Some(numbers), Some(interaction)) = (interpolation.flatten(), numbers, interaction)
    else {
        return Ok(None);
    };
    let line = || SlideLine::new(interpolation, numbers)?.smoothed(smooth)?.extended(extension);
    match line().and_then(|line| surface(line, interaction, damping, friction)) {
        Ok(surface) => Ok(frequency.map(|torque_frequency| SceneLine { surface, torque_frequency })),
        Err(error) => {
            reader.reject(place, &error);
            Ok(None)
        }
    }
}

/// The nodes one by one; those of a set in their order.
fn in_sequence(nodes: Vec<Option<Members>>) -> Vec<Option<u32>> {
    let each = |members: Members| members.numbers().map(Some);
    nodes.into_iter().flat_map(|nodes| nodes.map_or_else(|| vec![None], |members| each(members).collect())).collect()
}

/// A whole number in a range.
fn whole(reader: &mut Reader, range: RangeInclusive<u32>) -> Read<Option<u32>> {
    let place = reader.place();
    let Some(number) = reader.number(Domain::Real)? else { return Ok(None) };
    let within = number.fract() == 0.0 && (f64::from(*range.start())..=f64::from(*range.end())).contains(&number);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number in the range")]
    let found = within.then_some(number as u32);
    if found.is_none() {
        let allowed = format!("a whole number from {} to {}", range.start(), range.end());
        reader.fault(place, format!("{number:?}"), allowed);
    }
    Ok(found)
}

/// Nodes whose names are a common word followed by numbers, from a first to a last: `rail 1`, `rail 3`, `rail 5`.
fn generated(reader: &mut Reader, nodes: &Named<Option<SceneNode>>) -> Read<Option<Vec<Option<u32>>>> {
    let place = reader.place();
    let (mut ends, mut increment) = ([None, None], Some(1));
    let is_object = reader.record(&keys::GENERATE, |reader, key| {
        match key {
            2 => increment = whole(reader, 1..=u32::MAX)?,
            end => {
                let at = reader.place();
                ends[end] = Some(reader.string("the name of a node")?.map(|name| (name, at)));
            }
        }
        Ok(())
    })?;
    let [Some(first), Some(last)] = ends else {
        if is_object {
            reader.fault(
                place,
                "generated nodes without \"first\" or \"last\"",
                "first, last, and increment if it is not 1",
            );
        }
        return Ok(None);
    };
    let (Some((first, _)), Some((last, at)), Some(increment)) = (first, last, increment) else { return Ok(None) };
    let (Some((word, from)), Some((other, to))) = (numbered(&first), numbered(&last)) else {
        reader.fault(at, format!("{first:?} to {last:?}"), "names that end in a number");
        return Ok(None);
    };
    if word != other || from > to || !(to - from).is_multiple_of(increment) {
        let allowed = format!("{word:?} with a number that is {from} and a multiple of {increment} more");
        reader.fault(at, format!("{last:?}"), allowed);
        return Ok(None);
    }
    let mut found = Vec::new();
    for number in (from..=to).step_by(increment as usize) {
        found.push(look_up(reader, nodes, place, &format!("{word}{number}"), "node"));
        // An erroneous end may count billions.
        if found.ends_with(&[None]) {
            break;
        }
    }
    Ok(Some(found))
}

/// A name that ends in a number: the text before it, and the number.
fn numbered(name: &str) -> Option<(&str, u32)> {
    let word = name.trim_end_matches(|c: char| c.is_ascii_digit());
    Some((word, name[word.len()..].parse().ok()?))
}

fn surface(
    line: SlideLine,
    mut interaction: Interaction,
    damping: Option<[f64; 3]>,
    friction: Option<[f64; 2]>,
) -> Result<Surface, Error> {
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

/// The pressure law, determined by which of its parameters are given.
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

/// An object in which every number must be given.
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
