//! Mutated scenes: whatever the input, reading and evaluating end with results or with faults that have a location, never with a
//! panic.

use crate::draw::Draw;
use jointproof::scene::{Results, Scene};
use serde_json::{Map, Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Values of every type, most of them invalid where they are inserted.
fn odd(draw: &mut Draw) -> Value {
    let all = [
        json!(null),
        json!(true),
        json!(0),
        json!(-1),
        json!(1),
        json!(-0.0),
        json!(0.5),
        json!(1e308),
        json!(-1e308),
        json!(5e-324),
        json!(1e-300),
        json!(""),
        json!("a"),
        json!("slot"),
        json!("isl22a"),
        json!("3d"),
        json!("2d"),
        json!("axisymmetric"),
        json!([]),
        json!({}),
        json!([0, 0]),
        json!([0, 0, 0]),
        json!([1, 0, 0, 0]),
        json!(["a", "a"]),
        json!({ "u": [0, 0, 0] }),
    ];
    all[draw.below(all.len())].clone()
}

/// The values in a value, itself first.
fn count(value: &Value) -> usize {
    1 + match value {
        Value::Array(items) => items.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum(),
        _ => 0,
    }
}

/// The value with this number, counting the value itself as 0.
fn nth(value: &mut Value, mut number: usize) -> &mut Value {
    if number == 0 {
        return value;
    }
    number -= 1;
    let parts: Vec<&mut Value> = match value {
        Value::Array(items) => items.iter_mut().collect(),
        Value::Object(members) => members.values_mut().collect(),
        _ => unreachable!("a number below the count"),
    };
    for part in parts {
        match number.checked_sub(count(part)) {
            None => return nth(part, number),
            Some(rest) => number = rest,
        }
    }
    unreachable!("a number below the count")
}

/// Changes one value in a scene, or in an already mutated one.
fn mutate(scene: &mut Value, draw: &mut Draw) {
    let [one, other] = [draw.below(count(scene)), draw.below(count(scene))];
    match draw.below(6) {
        0 => *nth(scene, one) = odd(draw),
        1 => {
            let copy = nth(scene, other).clone();
            *nth(scene, one) = copy;
        }
        how => match nth(scene, one) {
            Value::Object(members) if !members.is_empty() => mutate_members(members, how, draw),
            Value::Array(items) if !items.is_empty() => mutate_items(items, how, draw),
            Value::Number(number) => {
                let x = number.as_f64().unwrap();
                let scales = [-1.0, 0.0, 1e-200, 1e200, 1.0 + f64::EPSILON, 1e16];
                *nth(scene, one) = json!(x * scales[draw.below(scales.len())]);
            }
            Value::String(text) => text.extend(text.clone().chars().rev().take(draw.below(3))),
            value => *value = odd(draw),
        },
    }
}

fn mutate_members(members: &mut Map<String, Value>, how: usize, draw: &mut Draw) {
    let key = members.keys().nth(draw.below(members.len())).unwrap().clone();
    let value = if how == 5 { members[&key].clone() } else { members.shift_remove(&key).unwrap() };
    match how {
        2 => {}
        // Misspelt, or moved to the end.
        3 => drop(members.insert(format!("{key}s"), value)),
        4 => drop(members.insert(key, value)),
        _ => drop(members.insert(format!("{key} too"), value)),
    }
}

fn mutate_items(items: &mut Vec<Value>, how: usize, draw: &mut Draw) {
    let [one, other] = [draw.below(items.len()), draw.below(items.len())];
    match how {
        2 => drop(items.remove(one)),
        3 => items.swap(one, other),
        4 => items.insert(one, odd(draw)),
        _ => items.insert(one, items[other].clone()),
    }
}

/// The numbers in a value, or the arrays of numbers.
fn parts<'v>(value: &'v mut Value, wanted: fn(&Value) -> bool, found: &mut Vec<&'v mut Value>) {
    if wanted(value) {
        found.push(value);
        return;
    }
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| parts(item, wanted, found)),
        Value::Object(members) => members.values_mut().for_each(|member| parts(member, wanted, found)),
        _ => {}
    }
}

/// Changes numbers only, so that the scene is normally readable, and its evaluation may be undefined: coincident nodes, vectors
/// that are not triads, products that overflow.
fn strain(scene: &mut Value, draw: &mut Draw) {
    let mut found = Vec::new();
    if draw.below(2) == 0 {
        parts(scene, Value::is_number, &mut found);
        let scales = [-1.0, 0.0, 1e-200, 1e160, 1e300, 1e16];
        let (number, scale) = (draw.below(found.len()), scales[draw.below(scales.len())]);
        *found[number] = json!(found[number].as_f64().unwrap() * scale);
    } else {
        parts(scene, |value| value.as_array().is_some_and(|items| items.iter().all(Value::is_number)), &mut found);
        let [one, other] = [draw.below(found.len()), draw.below(found.len())];
        let copy = found[other].clone();
        if copy.as_array().map(Vec::len) == found[one].as_array().map(Vec::len) {
            *found[one] = copy;
        }
    }
}

/// Damages text: truncates it, flips bytes, duplicates a piece.
fn damage(text: &str, draw: &mut Draw) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let [start, end] = [draw.below(bytes.len()), draw.below(bytes.len())];
    match draw.below(4) {
        0 => bytes.truncate(start),
        1 => bytes[start] ^= 1 << draw.below(8),
        2 => bytes[start] = b"{}[],:\"0-e\\ "[draw.below(12)],
        _ => drop(bytes.splice(start..start, bytes[start.min(end)..start.max(end)].to_vec())),
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn mutant(scenes: &[Value], number: u64) -> String {
    let mut draw = Draw(number.wrapping_mul(0x1000_0001));
    let mut scene = scenes[draw.below(scenes.len())].clone();
    if draw.below(3) == 0 {
        (0..=draw.below(3)).for_each(|_| strain(&mut scene, &mut draw));
        return scene.to_string();
    }
    (0..draw.below(4)).for_each(|_| mutate(&mut scene, &mut draw));
    let text = scene.to_string();
    if draw.below(4) == 0 { damage(&text, &mut draw) } else { text }
}

/// The golden scenes, with only a few of their states, so that a mutant takes little time.
fn golden() -> Vec<Value> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/golden/scenes");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path().to_string_lossy().into_owned());
    let is_scene = |path: &String| !path.ends_with(".result.json") && !path.ends_with("schema.json");
    let mut paths: Vec<_> = paths.filter(is_scene).collect();
    paths.sort();
    let read = |path: String| {
        let mut scene: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        scene["frames"].as_array_mut().unwrap().truncate(4);
        scene
    };
    paths.into_iter().map(read).collect()
}

/// The outcome of a mutant; a panic is reported with its text.
fn judge(text: &str) -> Outcome {
    let read = || match Scene::parse(text) {
        Err(faults) => {
            assert!(!faults.list().is_empty());
            for fault in faults.list() {
                assert!(fault.line >= 1 && fault.line <= text.lines().count().max(1) + 1, "{fault}");
                assert!(fault.column >= 1 && !fault.found.is_empty() && !fault.allowed.is_empty(), "{fault}");
            }
            Outcome::Refused
        }
        Ok(scene) => match Results::of(&scene) {
            Ok(_) => Outcome::Evaluated,
            Err(_) => Outcome::Undefined,
        },
    };
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| panic!("a panic about this scene:\n{text}"))
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Outcome {
    Refused,
    Evaluated,
    Undefined,
}

/// Judges this many mutants; every outcome must occur, so that each of the three is tested.
fn judge_mutants(count: u64) {
    let scenes = golden();
    let mut outcomes = [(Outcome::Refused, 0), (Outcome::Evaluated, 0), (Outcome::Undefined, 0)];
    for number in 0..count {
        let outcome = judge(&mutant(&scenes, number));
        outcomes.iter_mut().filter(|(known, _)| *known == outcome).for_each(|(_, times)| *times += 1);
    }
    println!("{outcomes:?}");
    assert!(outcomes.iter().all(|(_, times)| times * 500 > count), "{outcomes:?}");
}

#[test]
fn a_few_thousand_mutants_do_not_panic() {
    judge_mutants(4000);
}

#[test]
#[ignore = "takes minutes, and wants an optimised build: cargo test --release --test all scene_mutations:: -- --ignored"]
fn a_million_mutants_do_not_panic() {
    judge_mutants(1_000_000);
}
