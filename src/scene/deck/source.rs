//! The files of a deck, and places in them.

/// A place in a file of the deck: the file by its index, and the offset in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Place {
    pub(super) file: u32,
    pub(super) at: u32,
}

impl Place {
    /// A place some bytes further on.
    pub(super) fn after(self, bytes: usize) -> Self {
        // A file that is longer is not read.
        Self { at: self.at + u32::try_from(bytes).unwrap_or(0), ..self }
    }
}

/// A file: its name as the deck or the caller gives it, its text, and where each of its lines begins.
struct Source {
    name: String,
    text: String,
    lines: Vec<u32>,
}

/// The files of a deck, the deck itself first.
#[derive(Default)]
pub(super) struct Sources(Vec<Source>);

impl Sources {
    /// Adds a file. Bytes that are not UTF-8 are replaced: comments may be in any encoding. `None` if the file is too long.
    pub(super) fn add(&mut self, name: &str, bytes: Vec<u8>) -> Option<u32> {
        let text =
            String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
        u32::try_from(text.len()).ok()?;
        let begins = (1_u32..).zip(text.bytes()).filter(|(_, byte)| *byte == b'\n').map(|(next, _)| next);
        let lines = std::iter::once(0).chain(begins).collect();
        self.0.push(Source { name: name.into(), text, lines });
        u32::try_from(self.0.len() - 1).ok()
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    pub(super) fn text(&self, file: u32) -> &str {
        &self.0[file as usize].text
    }

    /// The name of the file of a place; `None` if it is the deck itself.
    pub(super) fn included(&self, place: Place) -> Option<&str> {
        (place.file > 0).then(|| &*self.0[place.file as usize].name)
    }

    /// Line and column of a place, both from 1; the column in characters.
    pub(super) fn locate(&self, place: Place) -> (usize, usize) {
        let Source { text, lines, .. } = &self.0[place.file as usize];
        let line = lines.partition_point(|&begin| begin <= place.at);
        let column = text[lines[line - 1] as usize..place.at as usize].chars().count() + 1;
        (line, column)
    }
}
