//! Triads: by two axes, as a rotation vector, as a quaternion, or by an angle in the plane.

use super::{PLANE_ORIENTATION_KEYS, SPACE_ORIENTATION_KEYS, named};
use crate::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::Dimension;
use crate::scene::model::Orientation;
use indexmap::IndexMap;

/// How parallel two axes may be: the least sine of the angle between them.
const PARALLEL: f64 = 1e-6;

pub(super) fn orientations_of(reader: &mut Reader, dimension: Dimension) -> Read<IndexMap<Box<str>, Orientation>> {
    named(reader, |reader| {
        let place = reader.place();
        let mut found = Vec::new();
        if dimension == Dimension::Space {
            reader.record(&SPACE_ORIENTATION_KEYS, |reader, key| {
                found.push(match key {
                    0 => axes(reader)?,
                    1 => reader.vector()?.map(Orientation::Rotation),
                    _ => quaternion(reader)?,
                });
                Ok(())
            })?;
        } else {
            reader.record(&PLANE_ORIENTATION_KEYS, |reader, _| {
                let angle = reader.number(Domain::Angle)?;
                found.push(angle.map(|angle| Orientation::Rotation([0.0, 0.0, angle])));
                Ok(())
            })?;
        }
        if found.len() != 1 {
            let keys: &[&str] =
                if dimension == Dimension::Space { &SPACE_ORIENTATION_KEYS } else { &PLANE_ORIENTATION_KEYS };
            reader.fault(place, format!("{} descriptions", found.len()), format!("exactly one of {}", keys.join(", ")));
        }
        // A faulty one still has a name that nodes may refer to.
        Ok(Some(found.into_iter().flatten().next().unwrap_or(Orientation::Rotation([0.0; 3]))))
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
    let [a, b] = [first, second].map(|v| nalgebra::Vector3::from(crate::scalar::direction(v)));
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
