//! Scenes from files: JSON, or decks.

use super::deck;
use crate::console::{say, yellow};
use anyhow::Context;
use jointproof::scene::{Deck, Faults, Scene};
use std::io::Read;
use std::path::Path;

/// The path that denotes standard input.
pub(super) const STANDARD_INPUT: &str = "-";

pub(super) fn shown(path: &Path) -> String {
    if path.as_os_str() == STANDARD_INPUT { "standard input".into() } else { path.display().to_string() }
}

fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    if path.as_os_str() != STANDARD_INPUT {
        return std::fs::read(path);
    }
    let mut bytes = Vec::new();
    std::io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// A scene that was read from a file.
pub(super) struct Loaded {
    pub(super) scene: Scene,
    /// If it was a deck: the scene as text, if that is wanted, and what is left out of it though connectors depend on it.
    pub(super) text: Option<String>,
    pub(super) left_out: Vec<String>,
}

/// The scene in a file, or its faults; as text, too, if it is wanted and a deck.
pub(super) fn read(path: &Path, wants_text: bool) -> anyhow::Result<Result<Loaded, String>> {
    let shown = shown(path);
    let report = |faults: Faults| {
        let lines = faults.list().iter().map(|fault| format!("{shown}: {fault}\n")).collect::<Vec<_>>().concat();
        let count = faults.len();
        format!("{lines}{shown}: {count} {}", if count == 1 { "fault" } else { "faults" })
    };
    let bytes = bytes(path).with_context(|| format!("cannot read {shown}"))?;
    // A path without a folder is relative to the current one, as is standard input.
    let folder = path.parent().unwrap_or(Path::new(""));
    if deck::is_deck(path, &bytes) {
        let read = Deck::parse_in(folder, bytes).and_then(|deck| Ok((deck.scene()?, deck)));
        let loaded = |(scene, deck): (Scene, Deck)| Loaded {
            scene,
            left_out: deck::left_out(&shown, &deck),
            text: wants_text.then(|| deck.into_text()),
        };
        return Ok(read.map(loaded).map_err(report));
    }
    let text = match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => return Ok(Err(format!("{shown}: byte {} is not UTF-8", error.utf8_error().valid_up_to()))),
    };
    let scene = Scene::parse_in(folder, &text).map_err(report);
    Ok(scene.map(|scene| Loaded { scene, text: None, left_out: Vec::new() }))
}

/// Says what is ambiguous about a scene; returns how much.
pub(super) fn warn(path: &Path, warnings: &[String]) -> usize {
    for warning in warnings {
        say(&format!("{} {}: {warning}", yellow("warning:"), shown(path)));
    }
    warnings.len()
}

/// The name of a file without what follows the last period.
pub(super) fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}
