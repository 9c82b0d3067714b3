//! Scenes beside files of arrays.
#![allow(dead_code, reason = "each test file is a crate of its own and uses what it needs")]

use jointproof::scene::npz::Writer;
use jointproof::scene::{Column, Columns, Scene};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The file of arrays of every scene here.
pub const FILE: &str = "arrays.npz";

/// An array: its name, its sizes, its numbers.
pub type Array = (String, Vec<usize>, Vec<f64>);

/// An array of a name and a shape.
pub fn array(name: &str, shape: &[usize], numbers: &[f64]) -> Array {
    (name.into(), shape.into(), numbers.into())
}

/// Arrays as the bytes of a file.
pub fn file(arrays: &[Array]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut writer = Writer::new(&mut bytes);
    for (name, shape, numbers) in arrays {
        writer.write(name, shape, numbers).unwrap();
    }
    writer.finish().unwrap();
    bytes
}

/// Reads a scene beside a file of arrays.
pub fn parse(folder: &Path, scene: &Value, arrays: &[u8]) -> Result<Scene, String> {
    fs::write(folder.join(FILE), arrays).unwrap();
    Scene::parse_in(folder, &scene.to_string()).map_err(|faults| faults.to_string())
}

/// The results by the names of their arrays, every number by its bits.
pub fn column_bits(columns: &Columns) -> Vec<(String, Vec<u64>)> {
    let of = |column: &Column| (column.name(), column.numbers.iter().map(|number| number.to_bits()).collect());
    columns.columns.iter().map(of).collect()
}
