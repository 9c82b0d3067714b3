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

/// A file: its name as the deck or the caller gives it, and its text.
struct Source {
    name: String,
    text: String,
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
        self.0.push(Source { name: name.into(), text });
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
        let before = &self.text(place.file)[..place.at as usize];
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
        (line, column)
    }
}
