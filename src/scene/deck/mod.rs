//! Decks: input files of keywords and data lines, read as scenes.
//!
//! A deck becomes the text of a [`Scene`], which says what was understood, and which [`Scene::parse`] checks like any other;
//! faults that it finds are those of the places in the deck from which the text is. So there is one set of rules for both.

mod block;
mod connector;
mod contact;
mod ends;
mod field;
mod generate;
mod keywords;
mod log;
mod mesh;
mod model;
mod motion;
mod plan;
mod reading;
mod requests;
mod sets;
mod source;
mod terms;
mod text;
mod triads;
mod walk;
mod write;

pub use keywords::table;

use super::json::{Fault, Faults};
use super::model::Scene;
use block::{Block, blocks_of};
use log::{Log, Note, Raw};
use reading::Reading;
use source::{Place, Sources};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use text::Text;

/// A deck that has been read: the text of its scene, and what of it the scene does not have.
pub struct Deck {
    sources: Sources,
    starts: Starts,
    text: Text,
    left_out: Vec<LeftOut>,
    folder: Option<PathBuf>,
}

/// Something in a deck that its scene does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The included file; `None` for the deck itself.
    pub file: Option<String>,
    /// The line in it, from 1.
    pub line: usize,
    /// The keyword, such as `*MATERIAL`.
    pub keyword: String,
    /// What is left out.
    pub what: String,
    /// Whether connectors depend on it.
    pub matters: bool,
}

impl Deck {
    /// Reads a deck that includes no files.
    ///
    /// # Errors
    /// As [`Deck::parse_in`].
    pub fn parse(text: &str) -> Result<Self, Faults> {
        Self::read(None, text.as_bytes().to_vec())
    }

    /// Reads a deck in a folder, and the files there that it includes. Bytes that are not UTF-8 may be in comments.
    ///
    /// # Errors
    /// All faults, each with its keyword and included file, line and column, and with what was found and what is allowed.
    pub fn parse_in(folder: &Path, bytes: Vec<u8>) -> Result<Self, Faults> {
        Self::read(Some(folder), bytes)
    }

    fn read(folder: Option<&Path>, bytes: Vec<u8>) -> Result<Self, Faults> {
        let (mut sources, mut log) = (Sources::default(), Log::default());
        let Some(file) = sources.add("", bytes) else {
            let (path, found, allowed) = (String::new(), "a deck that is too long".into(), "less than 4 GiB".into());
            let mut faults = Faults::default();
            faults.push(Fault { path, line: 1, column: 1, found, allowed });
            return Err(faults);
        };
        let blocks = blocks_of(&mut sources, file, folder, &mut log);
        let starts = Starts::of(&blocks);
        let mut reading = Reading::new(&sources, log);
        walk::walk(&mut reading, &blocks);
        let Reading { mut model, mut log, .. } = reading;
        model.add_grounds();
        let text = if log.faults.is_empty() { write::write(&model, &mut log) } else { Text::default() };
        drop((model, blocks));
        let Log { faults, more, mut notes, .. } = log;
        if !faults.is_empty() {
            return Err(located(&sources, &starts, faults, more));
        }
        notes.sort_by_key(|note| note.place);
        let left_out = notes.into_iter().map(|note| left_out(&sources, &starts, note)).collect();
        Ok(Self { sources, starts, text, left_out, folder: folder.map(Path::to_owned) })
    }

    /// The scene as text, which says what was understood of the deck.
    pub fn text(&self) -> &str {
        &self.text.json
    }

    /// The same, without the deck.
    pub fn into_text(self) -> String {
        self.text.json
    }

    /// What of the deck the scene does not have, in order.
    pub fn left_out(&self) -> &[LeftOut] {
        &self.left_out
    }

    /// The scene.
    ///
    /// # Errors
    /// The faults of [`Scene::parse_in`], at the places of the deck.
    pub fn scene(&self) -> Result<Scene, Faults> {
        let parsed = match &self.folder {
            Some(folder) => Scene::parse_in(folder, &self.text.json),
            None => Scene::parse(&self.text.json),
        };
        parsed.map_err(|faults| {
            let mut log = Log::default();
            for Fault { line, column, found, allowed, .. } in faults.list() {
                let place = self.text.origin(*line, *column).unwrap_or(Place { file: 0, at: 0 });
                log.fault(place, &**found, &**allowed);
            }
            let more = faults.len() - faults.list().len();
            located(&self.sources, &self.starts, log.faults, more)
        })
    }
}

/// Where keyword lines and data lines begin, in order, each with its keyword as it is shown.
struct Starts(Vec<(Place, Arc<str>)>);

impl Starts {
    fn of(blocks: &[Block]) -> Self {
        let of_block = |block: &Block| {
            let shown: Arc<str> = (*block.shown).into();
            block.starts().map(|start| (start, Arc::clone(&shown))).collect::<Vec<_>>()
        };
        let mut starts: Vec<_> = blocks.iter().flat_map(of_block).collect();
        starts.sort_by_key(|(start, _)| *start);
        Self(starts)
    }

    /// The keyword of a place; empty before the first.
    fn keyword(&self, place: Place) -> &str {
        let before = self.0.partition_point(|(start, _)| *start <= place);
        let last = before.checked_sub(1).map(|last| &self.0[last]);
        last.filter(|(start, _)| start.file == place.file).map_or("", |(_, keyword)| keyword)
    }
}

fn located(sources: &Sources, starts: &Starts, mut raw: Vec<Raw>, more: usize) -> Faults {
    raw.sort_by_key(|raw| raw.place);
    let mut faults = Faults::default();
    for Raw { place, found, allowed } in raw {
        let (line, column) = sources.locate(place);
        let keyword = starts.keyword(place);
        let path = match sources.included(place) {
            Some(file) if keyword.is_empty() => file.into(),
            Some(file) => format!("{keyword} in {file}"),
            None => keyword.to_owned(),
        };
        faults.push(Fault { path, line, column, found, allowed });
    }
    faults.count_more(more);
    faults
}

fn left_out(sources: &Sources, starts: &Starts, Note { place, what, matters }: Note) -> LeftOut {
    let (line, _) = sources.locate(place);
    let (file, keyword) = (sources.included(place).map(String::from), starts.keyword(place).to_owned());
    LeftOut { file, line, keyword, what, matters }
}

impl std::fmt::Display for LeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { file, line, keyword, what, .. } = self;
        write!(
            f,
            "{keyword} ({}line {line}): {what}",
            file.as_ref().map(|file| format!("{file}, ")).unwrap_or_default()
        )
    }
}
