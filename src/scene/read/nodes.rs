//! Nodes and their orientations: triads by two axes, as a rotation vector, as a quaternion, or by an angle in the plane.

use super::columns::Columns;
use super::keys;
use super::names::{named, named_sets, refer};
use crate::formula::quantity::Domain;
use crate::scene::json::{Read, Reader, Stop};
use crate::scene::kind::Dimension;
use crate::scene::model::{Named, Orientation, SceneNode};
use crate::scene::npz::{Array, Unfit};

/// The limit for two axes to count as parallel: the least sine of the angle between them.
const PARALLEL: f64 = 1e-6;

/// Coordinates or a displacement.
pub(super) fn point(reader: &mut Reader, dimension: Dimension) -> Read<Option<[f64; 3]>> {
    if dimension == Dimension::Space {
        return reader.vector();
    }
    Ok(reader.vector()?.map(in_plane))
}

/// A point of the plane.
fn in_plane([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Nodes and sets of nodes, and the position of each node, by its number.
pub(super) struct Nodes {
    pub(super) named: Named<Option<SceneNode>>,
    pub(super) at: Vec<[f64; 3]>,
}

pub(super) fn nodes_of(
    reader: &mut Reader,
    dimension: Dimension,
    orientations: &Named<Option<Orientation>>,
    columns: &Columns,
) -> Read<Nodes> {
    let mut all = Vec::new();
    let named = named_sets(reader, |reader, above: &Named<Option<SceneNode>>| {
        let place = reader.place();
        let (mut given, mut at, mut with, mut orientation, mut sound) = (0, None, None, None, true);
        let is_object = reader.record(&keys::NODE, |reader, key| {
            match key {
                0 => {
                    given += 1;
                    at = positions(reader, dimension, columns)?;
                }
                1 => {
                    orientation = refer(reader, orientations, "orientation")?;
                    // An unknown orientation is not also reported as missing.
                    sound = orientation.is_some();
                }
                _ => {
                    given += 1;
                    let other = refer(reader, above, "node above")?;
                    with = other.map(|other| above[other].and_then(|node| node.with).unwrap_or(other));
                    at = with.map(|with| At::One(all.get(with as usize).copied().unwrap_or_default()));
                }
            }
            Ok(())
        })?;
        if is_object && given != 1 {
            let found = if given == 0 { "a node without \"at\"" } else { "a node with \"at\" and \"with\"" };
            let allowed = "a node with its coordinates, or with the name of a node above, with which it moves";
            reader.fault(place, found, allowed);
        }
        let node = at.as_ref().filter(|_| sound).map(|_| SceneNode { orientation, with });
        let count = match at {
            Some(At::One(at)) => {
                all.push(at);
                None
            }
            Some(At::Each(numbers)) => {
                let before = all.len();
                if dimension == Dimension::Space {
                    all.extend_from_slice(numbers.as_chunks().0);
                } else {
                    all.extend(numbers.as_chunks().0.iter().copied().map(in_plane));
                }
                Some(u32::try_from(all.len() - before).unwrap_or(u32::MAX))
            }
            // It still has a number, to which others can refer; the missing position is a fault, and ends the reading.
            None => None,
        };
        Ok((count, node))
    })?;
    Ok(Nodes { named, at: all })
}

/// The position of a node, or the coordinates of each node of a set.
enum At {
    One([f64; 3]),
    Each(Vec<f64>),
}

/// Coordinates, or an array of the coordinates of a set of nodes.
fn positions(reader: &mut Reader, dimension: Dimension, columns: &Columns) -> Read<Option<At>> {
    let Some(array) = columns.refer(reader)? else { return Ok(point(reader, dimension)?.map(At::One)) };
    let coordinates = dimension.coordinates();
    let load = |mut array: Array| -> Result<At, Unfit> {
        let is_fit = matches!(*array.outline().shape(), [count, components] if count > 0 && components == coordinates);
        if !is_fit {
            let allowed = format!("(n, {coordinates}): nodes, at least one, and coordinates");
            return Err(array.outline().misshapen(allowed));
        }
        array.numbers(Domain::Real).map(At::Each)
    };
    // Without the array the number of nodes is unknown, and every reference to them would be another fault.
    columns.load(reader, array, load).map(Some).ok_or(Stop)
}

pub(super) fn orientations_of(reader: &mut Reader, dimension: Dimension) -> Read<Named<Option<Orientation>>> {
    let keys: &[&str] = if dimension == Dimension::Space { &keys::SPACE_ORIENTATION } else { &keys::PLANE_ORIENTATION };
    named(reader, |reader| {
        let place = reader.place();
        let mut found = Vec::new();
        reader.record(keys, |reader, key| {
            found.push(match (dimension, key) {
                (Dimension::Space, 0) => axes(reader)?,
                (Dimension::Space, 1) => reader.rotation()?.map(Orientation::Rotation),
                (Dimension::Space, _) => quaternion(reader)?,
                _ => reader.number(Domain::Angle)?.map(|angle| Orientation::Rotation([0.0, 0.0, angle])),
            });
            Ok(())
        })?;
        if let [orientation] = found[..] {
            return Ok(orientation);
        }
        reader.fault(place, format!("{} descriptions", found.len()), format!("exactly one of {}", keys.join(", ")));
        Ok(None)
    })
}

fn axes(reader: &mut Reader) -> Read<Option<Orientation>> {
    let place = reader.place();
    let mut axes = Vec::new();
    let is_array = reader.array("an array of two vectors", |reader, _| {
        axes.push(reader.vector()?);
        Ok(())
    })?;
    let [Some(first), Some(second)] = axes[..] else {
        if is_array && axes.len() != 2 {
            reader.fault(
                place,
                format!("{} vectors", axes.len()),
                "two: along the first axis, and in the plane of the first two",
            );
        }
        return Ok(None);
    };
    let [a, b] = [first, second].map(|v| nalgebra::Vector3::from(crate::number::scalar::direction(v)));
    if a.cross(&b).norm() < PARALLEL {
        reader.fault(place, "two vectors that are parallel, or zero", "two vectors that span a plane");
        return Ok(None);
    }
    Ok(Some(Orientation::Axes(first, second)))
}

fn quaternion(reader: &mut Reader) -> Read<Option<Orientation>> {
    let place = reader.place();
    let Some(quaternion) = reader.vector()? else { return Ok(None) };
    if quaternion == [0.0; 4] {
        reader.fault(place, "the quaternion 0", "a quaternion other than 0, real part first");
        return Ok(None);
    }
    Ok(Some(Orientation::Quaternion(quaternion)))
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_point_of_the_plane_is_at_height_zero() {
        assert_eq!(super::in_plane([1.0, 2.0]), [1.0, 2.0, 0.0]);
    }
}
