//! Animated figures. Every position of the sliders is drawn by the build; a script shows the current one.

use serde_json::json;

use super::html::{each, escape};
use crate::extension::{Moving, Slider};

/// The folder in the book.
const FOLDER: &str = "figures";

/// The beginning of a figure's sliders.
const MARK: &str = "<div class=\"sliders\" data-figure=";

/// The script of a page with sliders.
const SCRIPT: &str = include_str!("moving.js");

/// The sliders of a figure, hidden until the script shows them.
pub(crate) fn sliders(moving: &Moving) -> String {
    let slider = |slider: &Slider| {
        let Slider { label, values, start } = slider;
        format!(
            "<label><span>{}</span><input type=\"range\" min=\"0\" max=\"{}\" value=\"{start}\"><output>{}</output></label>",
            escape(label),
            values.len().saturating_sub(1),
            escape(values.get(*start).map_or("", String::as_str))
        )
    };
    format!("{MARK}\"{}\" hidden>{}</div>", escape(&moving.name), each(&moving.sliders, slider))
}

/// The additions to the head of a page with sliders.
pub(crate) fn head(page: &str, to_root: &str) -> String {
    if page.contains(MARK) {
        format!("<script defer src=\"{to_root}{FOLDER}/moving.js\"></script>\n")
    } else {
        String::new()
    }
}

/// The script, and a file of positions for each figure.
pub(crate) fn files(all: &[Moving]) -> Vec<(String, String)> {
    let mut files: Vec<_> =
        all.iter().map(|moving| (format!("{FOLDER}/{}.js", moving.name), positions(moving))).collect();
    if !files.is_empty() {
        files.push((format!("{FOLDER}/moving.js"), format!("'use strict';\n(() => {{\n{SCRIPT}}})();\n")));
    }
    files
}

/// The positions: the lines of the drawing, and for each position the lines that vary.
fn positions(moving: &Moving) -> String {
    let frames: Vec<Vec<&str>> = moving.frames.iter().map(|frame| frame.trim_end().split('\n').collect()).collect();
    let first = frames.first().map_or(&[] as &[&str], Vec::as_slice);
    let differs = |k: &usize| frames.iter().any(|frame| frame.get(*k) != first.get(*k));
    let moved: Vec<usize> = (0..first.len()).filter(differs).collect();
    let of_frame = |frame: &Vec<&str>| -> Vec<String> {
        moved.iter().map(|&k| frame.get(k).copied().unwrap_or_default().to_owned()).collect()
    };
    let values: Vec<_> = moving.sliders.iter().map(|slider| &slider.values).collect();
    let data = json!({ "lines": first, "moved": moved, "frames": frames.iter().map(of_frame).collect::<Vec<_>>(), "values": values });
    format!("jointproofMoving('{}', {data});\n", moving.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_moves_is_kept_of_every_position() {
        let slider = Slider { label: "x".into(), values: vec!["0".into(), "1".into()], start: 1 };
        let frames = vec!["<svg>\n<a/>\n</svg>\n".into(), "<svg>\n<b/>\n</svg>\n".into()];
        let moving = Moving { name: "m".into(), sliders: vec![slider], frames };
        assert_eq!(moving.still().map(String::as_str), Some("<svg>\n<b/>\n</svg>\n"));
        let text = positions(&moving);
        assert!(text.contains(r#""moved":[1]"#) && text.contains(r#""frames":[["<a/>"],["<b/>"]]"#), "{text}");
        let frames = vec!["<a/>\n<c/>\n".into(), "<b/>\n<c/>\n".into()];
        assert!(
            positions(&Moving { frames, ..moving.clone() }).contains(r#""moved":[0]"#),
            "the first line moves, too"
        );
        assert!(sliders(&moving).contains("max=\"1\" value=\"1\"><output>1</output>"));
    }
}
