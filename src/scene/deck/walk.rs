//! Through the blocks of a deck: parts, their instances, steps, and every keyword by its table.

use super::block::{Block, Parameter};
use super::keywords::Keyword;
use super::motion::Motion;
use super::reading::{Context, Reading};
use super::source::Place;
use std::collections::HashMap;
use std::ops::Range;

/// Keywords that make nodes and elements that a connector may have.
const MAKERS: [&str; 5] = ["NFILL", "NCOPY", "NMAP", "ELCOPY", "IMPORT"];

/// A part: its blocks, and whether there is an instance of it.
struct Part {
    blocks: Range<usize>,
    place: Place,
    is_used: bool,
}

pub(super) fn walk(reading: &mut Reading, blocks: &[Block]) {
    let mut parts: HashMap<String, Part> = HashMap::new();
    let (mut k, mut in_step) = (0, false);
    while let Some(block) = blocks.get(k) {
        k += 1;
        match &*block.name {
            "PART" => {
                let rest = blocks[k..].iter().position(|block| block.name == "ENDPART");
                let end = rest.map_or(blocks.len(), |rest| k + rest);
                if rest.is_none() {
                    reading.fault(block.place, "a part without an end", "*END PART after it");
                }
                if let Some((label, place)) = block.required(&mut reading.log, "NAME") {
                    let part = Part { blocks: k..end, place: block.place, is_used: false };
                    if parts.insert(label.key, part).is_some() {
                        reading.fault(place, format!("part {:?} for the second time", label.shown), "each name once");
                    }
                }
                k = end + 1;
            }
            "INSTANCE" => instance(reading, block, blocks, &mut parts),
            "ENDINSTANCE" if reading.scope > 0 => leave(reading),
            "ENDPART" | "ENDINSTANCE" => {
                reading.fault(block.place, format!("{} of nothing", block.shown), "an end below a beginning");
            }
            "ASSEMBLY" | "ENDASSEMBLY" => reading.context = Context::Nothing,
            "STEP" => {
                in_step = true;
                reading.log.leave_out(block.place, "a step: its motions and loads are those of a history", false);
            }
            "ENDSTEP" => in_step = false,
            name if in_step && !Keyword::find(name).is_some_and(|keyword| keyword.in_steps) => {
                reading.log.leave_out(block.place, "in a step", false);
            }
            _ => one(reading, block),
        }
    }
    if reading.scope > 0 {
        let shown = reading.model.scopes[reading.scope as usize].clone();
        if let Some(block) = blocks.last() {
            reading.fault(block.place, format!("instance {shown:?} without an end"), "*END INSTANCE after it");
        }
    }
    for part in parts.into_values().filter(|part| !part.is_used) {
        reading.log.leave_out(part.place, "a part without an instance", false);
    }
}

fn leave(reading: &mut Reading) {
    (reading.scope, reading.motion, reading.context) = (0, None, Context::Nothing);
}

fn one(reading: &mut Reading, block: &Block) {
    let Some(keyword) = Keyword::find(&block.name) else { return unknown(reading, block) };
    for Parameter { name, place, .. } in block.parameters() {
        let is_known = [keyword.parameters, keyword.without_effect].concat().contains(&&**name);
        match keyword.meant_parameter(name).filter(|_| !is_known) {
            Some(meant) => reading.fault(*place, format!("the parameter {name}"), format!("{meant}, spelled out")),
            None if is_known => {}
            None => reading.log.leave_out(*place, format!("the parameter {name}"), true),
        }
    }
    if !keyword.is_below {
        reading.context = Context::Nothing;
    }
    (keyword.read)(reading, block);
}

fn unknown(reading: &mut Reading, block: &Block) {
    if let Some(meant) = Keyword::meant(&block.name) {
        return reading.fault(block.place, "an unknown keyword", format!("*{meant}, spelled out"));
    }
    if matches!(reading.context, Context::Behavior(_)) && block.name.starts_with("CONNECTOR") {
        return super::connector::other(reading, block);
    }
    reading.context = Context::Nothing;
    match &*block.name {
        "SYSTEM" => reading.fault(block.place, "a system of the nodes below", "nodes in global coordinates"),
        "PARAMETER" => reading.fault(block.place, "parameters, which are computed", "their values where they are used"),
        name => reading.log.leave_out(block.place, "not read", MAKERS.contains(&name)),
    }
}

fn instance(reading: &mut Reading, block: &Block, blocks: &[Block], parts: &mut HashMap<String, Part>) {
    if reading.scope > 0 {
        reading.fault(block.place, "an instance in an instance", "*END INSTANCE before it");
        leave(reading);
    }
    if block.parameter("INSTANCE").is_some() || block.parameter("LIBRARY").is_some() {
        reading.log.leave_out(block.place, "an instance of an earlier analysis", true);
    }
    let (name, part) = (block.required(&mut reading.log, "NAME"), block.required(&mut reading.log, "PART"));
    let Some((name, place)) = name else { return };
    let scope = u32::try_from(reading.model.scopes.len()).unwrap_or(u32::MAX);
    reading.model.scopes.push(name.shown.clone());
    if reading.model.scope_of.insert(name.key, scope).is_some() {
        reading.fault(place, format!("instance {:?} for the second time", name.shown), "each name once");
    }
    reading.motion = placed(reading, block);
    reading.scope = scope;
    let Some((label, place)) = part else { return };
    let Some(part) = parts.get_mut(&label.key) else {
        return reading.fault(place, format!("no part {:?}", label.shown), "the name of a part above");
    };
    part.is_used = true;
    for block in &blocks[part.blocks.clone()] {
        match &*block.name {
            "PART" | "ASSEMBLY" | "ENDASSEMBLY" | "INSTANCE" | "ENDINSTANCE" | "STEP" => {
                reading.fault(block.place, format!("{} in a part", block.shown), "*END PART before it");
            }
            _ => one(reading, block),
        }
    }
    reading.context = Context::Nothing;
}

/// How an instance is placed: moved by its first data line, then rotated by the second.
fn placed(reading: &mut Reading, block: &Block) -> Option<Motion> {
    let mut lines = block.full(reading.sources);
    let by = reading.numbers(lines.next()?.fields());
    let Some(line) = lines.next() else { return Motion::new(by, None) };
    let [ax, ay, az, bx, by_, bz, angle] = reading.numbers(line.fields());
    if let Some(line) = lines.next() {
        reading.fault(line.place, "a third data line", "a translation and a rotation");
    }
    let motion = Motion::new(by, Some(([ax, ay, az], [bx, by_, bz], angle)));
    if motion.is_none() {
        reading.fault(
            line.place,
            "an axis of which both points are the same",
            "two points of the axis, and an angle in degrees",
        );
    }
    motion
}
