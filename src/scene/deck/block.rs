//! From the files of a deck to its blocks: a keyword line with its parameters, and the data lines below it.

use super::field::{Field, Label, fields, without_blanks};
use super::log::Log;
use super::source::{Place, Sources};
use std::path::Path;

/// Keywords whose data lines may begin in a file that they name.
const WITH_FILE: [&str; 2] = ["NODE", "ELEMENT"];

/// The maximum depth of files that include files, and the maximum number of files.
const DEPTH: usize = 16;
const FILES: usize = 10_000;

/// A keyword line, and its data lines.
#[derive(Debug)]
pub(super) struct Block {
    /// In upper case without blanks: `CONNECTORSECTION`.
    pub(super) name: String,
    /// As it is shown: `*CONNECTOR SECTION`.
    pub(super) shown: String,
    pub(super) place: Place,
    parameters: Vec<Parameter>,
    /// Its lines: more than one piece if a file is included between them.
    data: Vec<Piece>,
}

/// A parameter of a keyword line.
#[derive(Debug)]
pub(super) struct Parameter {
    /// In upper case without blanks.
    pub(super) name: String,
    pub(super) value: Option<String>,
    pub(super) place: Place,
}

/// Consecutive lines of a file.
#[derive(Clone, Copy, Debug)]
struct Piece {
    start: Place,
    end: u32,
}

/// A data line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'t> {
    pub(super) text: &'t str,
    pub(super) place: Place,
}

impl<'t> Line<'t> {
    pub(super) fn fields(self) -> impl Iterator<Item = Field<'t>> {
        fields(self.text, self.place)
    }

    pub(super) fn is_blank(self) -> bool {
        self.text.trim().is_empty()
    }
}

/// The lines of a text with their offsets, without what ends them.
fn lines(text: &str, start: usize, end: usize) -> impl Iterator<Item = (&str, usize)> {
    let mut at = start;
    std::iter::from_fn(move || {
        if at >= end {
            return None;
        }
        let from = at;
        let line = text[at..end].split_once('\n').map_or(&text[at..end], |(line, _)| line);
        at += line.len() + 1;
        Some((line.strip_suffix('\r').unwrap_or(line), from))
    })
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with("**")
}

fn is_keyword(line: &str) -> bool {
    line.trim_start().starts_with('*')
}

impl Block {
    pub(super) fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    pub(super) fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// The label that is the value of a parameter; a fault if it has none.
    pub(super) fn label(&self, log: &mut Log, name: &str) -> Option<(Label, Place)> {
        let Parameter { value, place, .. } = self.parameter(name)?;
        let label = value.as_deref().and_then(Label::new);
        if label.is_none() {
            let found =
                value.as_deref().map_or_else(|| format!("{name} without a value"), |value| format!("{value:?}"));
            log.fault(*place, found, format!("{name}=, followed by a name"));
        }
        Some((label?, *place))
    }

    /// The same for a parameter that must be there.
    pub(super) fn required(&self, log: &mut Log, name: &str) -> Option<(Label, Place)> {
        if self.parameter(name).is_none() {
            log.fault(self.place, format!("no {name}"), format!("{name}=, followed by a name"));
        }
        self.label(log, name)
    }

    /// The data lines, without comments.
    pub(super) fn lines<'t>(&self, sources: &'t Sources) -> impl Iterator<Item = Line<'t>> {
        self.data.iter().flat_map(move |&Piece { start, end }| {
            let all = lines(sources.text(start.file), start.at as usize, end as usize);
            let all = all.filter(|(line, _)| !is_comment(line));
            all.map(move |(text, at)| Line { text, place: start.after(at - start.at as usize) })
        })
    }

    /// The lines that are not blank.
    pub(super) fn full<'t>(&self, sources: &'t Sources) -> impl Iterator<Item = Line<'t>> {
        self.lines(sources).filter(|line| !line.is_blank())
    }

    /// Where its keyword line and its data lines begin; more than once if files are included.
    pub(super) fn starts(&self) -> impl Iterator<Item = Place> {
        std::iter::once(self.place).chain(self.data.iter().map(|piece| piece.start))
    }

    fn extend(&mut self, start: Place, end: u32) {
        match self.data.last_mut() {
            Some(piece) if piece.start.file == start.file && piece.end == start.at => piece.end = end,
            _ => self.data.push(Piece { start, end }),
        }
    }
}

/// Reads the blocks of a file and of those that it includes; these are in `folder`.
pub(super) fn blocks_of(sources: &mut Sources, file: u32, folder: Option<&Path>, log: &mut Log) -> Vec<Block> {
    let mut blocks = Vec::new();
    // Files that are being read: the index, and the offset at which reading goes on.
    let mut open = vec![(file, 0)];
    while let Some((file, start)) = open.pop() {
        let Some((input, next)) = until_include(sources, file, start, &mut blocks, log) else { continue };
        open.push((file, next));
        if let Some((name, place)) = input {
            match include(sources, &name, folder, open.len()) {
                Ok(included) => open.push((included, 0)),
                Err((found, allowed)) => log.fault(place, format!("the included file {found}"), allowed),
            }
        }
    }
    blocks
}

/// Reads a file of the deck's folder.
fn include(sources: &mut Sources, name: &str, folder: Option<&Path>, depth: usize) -> Result<u32, (String, String)> {
    let Some(folder) = folder else {
        return Err((format!("{name:?} in a text that is in no folder"), "a deck that is read from a file".into()));
    };
    if depth > DEPTH {
        return Err((format!("{name:?}, included by {DEPTH} files"), format!("at most {DEPTH} files in each other")));
    }
    if sources.count() == FILES {
        return Err((format!("{name:?} after {FILES} files"), format!("at most {FILES} files")));
    }
    let bytes = std::fs::read(folder.join(name))
        .map_err(|error| (format!("{name:?}: {error}"), "a file that can be read".to_owned()))?;
    sources.add(name, bytes).ok_or_else(|| (format!("{name:?}, which is too long"), "a file of less than 4 GiB".into()))
}

/// An included file, and where it is named.
type Input = Option<(String, Place)>;

/// Reads blocks up to the next file to be included, or to the end; returns the file and the offset after its line.
fn until_include(
    sources: &Sources,
    file: u32,
    start: usize,
    blocks: &mut Vec<Block>,
    log: &mut Log,
) -> Option<(Input, usize)> {
    let text = sources.text(file);
    let mut all = lines(text, start, text.len()).peekable();
    let offset = |at: usize| Place { file, at: 0 }.after(at);
    while let Some((line, at)) = all.next() {
        let end = |next: Option<&(&str, usize)>| next.map_or(text.len(), |&(_, at)| at);
        if is_comment(line) || !is_keyword(line) {
            let past = end(all.peek());
            match blocks.last_mut() {
                Some(block) => block.extend(offset(at), offset(past).at),
                None if is_comment(line) || line.trim().is_empty() => {}
                None => log.fault(offset(at), "data before the first keyword", "a line that begins with * or **"),
            }
            continue;
        }
        let mut parts = vec![(line, at)];
        while parts.last().is_some_and(|(line, _)| line.trim_end().ends_with(',')) {
            // Comments may be anywhere; a keyword line that ends in a comma may also be the last one.
            match all.next_if(|(line, _)| is_comment(line) || !is_keyword(line)) {
                Some((line, _)) if is_comment(line) => {}
                Some(part) => parts.push(part),
                None => break,
            }
        }
        let past = end(all.peek());
        let block = keyword(&parts, offset, log);
        let includes = block.name == "INCLUDE";
        let wanted = includes || WITH_FILE.contains(&&*block.name) && block.parameter("INPUT").is_some();
        let input = block.parameter("INPUT").and_then(|input| Some((input.value.as_deref()?, input.place)));
        let file = input.map(|(name, place)| (name.trim_matches('"').to_owned(), place));
        let file = file.filter(|(name, _)| !name.is_empty());
        if wanted && file.is_none() {
            let found = format!("{} without the name of a file", block.shown);
            log.fault(block.place, found, "INPUT=, followed by the name of a file");
        }
        if !includes {
            blocks.push(block);
        }
        if wanted && file.is_some() {
            return Some((file, past));
        }
    }
    None
}

/// A keyword line, in parts that end in a comma.
fn keyword(parts: &[(&str, usize)], offset: impl Fn(usize) -> Place, log: &mut Log) -> Block {
    let mut all = parts.iter().flat_map(|&(line, at)| fields(line, offset(at)));
    let first = all.next().expect("a line has a field, if an empty one");
    let words: Vec<_> = first.text.trim_start_matches('*').split_whitespace().map(str::to_uppercase).collect();
    let (name, shown) = (words.concat(), format!("*{}", words.join(" ")));
    let mut block = Block { name, shown, place: first.place, parameters: Vec::new(), data: Vec::new() };
    if block.name.is_empty() {
        log.fault(first.place, "a star", "a star followed by a keyword, or two stars and a comment");
    }
    for Field { text, place } in all.filter(|field| !field.text.is_empty()) {
        let (name, value) =
            text.split_once('=').map_or((text, None), |(name, value)| (name, Some(value.trim().into())));
        let parameter = Parameter { name: without_blanks(name).to_uppercase(), value, place };
        if block.parameter(&parameter.name).is_some() {
            log.fault(place, format!("{} for the second time", parameter.name), "each parameter once");
        } else {
            block.parameters.push(parameter);
        }
    }
    block
}
