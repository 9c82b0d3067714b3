//! What a project has beside its formulas: other golden files, and exhibits for its book.

use std::path::PathBuf;

/// Golden files that are not of formulas.
#[derive(Clone, Debug, Default)]
pub struct Beside {
    /// Each file, and what the code says that it holds.
    pub files: Vec<(PathBuf, String)>,
    /// Files that nothing stands behind any more.
    pub orphans: Vec<PathBuf>,
    /// How much that is, as `3 scenes, 120 numbers`.
    pub counts: String,
}

/// What the chapters of a book can show beside entries, each by the name that a directive gives.
#[derive(Clone, Debug, Default)]
pub struct Exhibits {
    /// `{{#figure name caption}}`: SVG elements.
    pub figures: Vec<(String, String)>,
    /// `{{#figure name caption}}` too, moved by sliders.
    pub moving: Vec<Moving>,
    /// `{{#output name}}`: what programs print.
    pub outputs: Vec<(String, String)>,
    /// `{{#table name}}`: tables, one below the other.
    pub tables: Vec<(String, Vec<Table>)>,
    /// `{{#text name}}`: Markdown, read as if it stood in the chapter.
    pub texts: Vec<(String, String)>,
    /// What entries say beside what the catalog knows.
    pub facts: Vec<Fact>,
    /// What programs show that evaluate formulas.
    pub served: Vec<Served>,
}

/// A fact on the entry of a formula.
#[derive(Clone, Debug, Default)]
pub struct Fact {
    /// The identifier of the formula.
    pub formula: String,
    /// What it is about, in a word.
    pub name: String,
    /// The lines of it: texts, in which `[…](…)` is a link from the root of the book.
    pub lines: Vec<String>,
}

/// A figure that is moved by sliders where scripts run; elsewhere it stands still.
#[derive(Clone, Debug, Default)]
pub struct Moving {
    /// Its name.
    pub name: String,
    /// Its sliders.
    pub sliders: Vec<Slider>,
    /// An SVG element for each position of the sliders, the last slider running fastest. Most of their lines are the same.
    pub frames: Vec<String>,
}

impl Moving {
    /// What is seen before anything is moved.
    pub fn still(&self) -> Option<&String> {
        let at = self.sliders.iter().fold(0, |at, slider| at * slider.values.len() + slider.start);
        self.frames.get(at)
    }
}

/// A slider of a figure.
#[derive(Clone, Debug, Default)]
pub struct Slider {
    /// What it moves.
    pub label: String,
    /// What is said at each of its positions.
    pub values: Vec<String>,
    /// The position before it is moved.
    pub start: usize,
}

/// An output of a program, and a formula that it is computed with.
#[derive(Clone, Debug, Default)]
pub struct Served {
    /// The identifier of the formula.
    pub formula: String,
    /// The output, as the program calls it.
    pub output: String,
    /// Of what it is an output.
    pub of: String,
    /// Where the book says more, from its root.
    pub place: String,
}

/// A table of texts, in which `$…$` is mathematics and `` `…` `` is code; code that names a formula links to it.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// Its anchor, for links; may be empty.
    pub anchor: String,
    /// What stands above it; may be empty.
    pub title: String,
    /// The heads of the columns.
    pub head: Vec<String>,
    /// The rows, each as long as the head.
    pub rows: Vec<Vec<String>>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_first_is_the_frame_where_all_sliders_start_the_last_running_fastest() {
        let slider = |values: usize, start| Slider { label: String::new(), values: vec![String::new(); values], start };
        let still = |sliders: Vec<Slider>| {
            let frames = (0..24).map(|k| k.to_string()).collect();
            Moving { name: String::new(), sliders, frames }.still().cloned()
        };
        assert_eq!(still(Vec::new()), Some("0".into()));
        assert_eq!(still(vec![slider(24, 5)]), Some("5".into()));
        // (1 · 3 + 2) · 4 + 3
        assert_eq!(still(vec![slider(2, 1), slider(3, 2), slider(4, 3)]), Some("23".into()));
        assert_eq!(still(vec![slider(2, 1), slider(12, 0)]), Some("12".into()));
        assert_eq!(still(vec![slider(24, 24)]), None);
    }
}
