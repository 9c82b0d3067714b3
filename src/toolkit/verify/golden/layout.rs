//! The line breaks of golden files.

use serde::Serialize;
use std::io::{Result, Write};

/// Objects are broken into lines down to the fields of a case; everything below is on one line.
#[derive(Default)]
pub(super) struct Layout {
    depth: usize,
}

/// A golden file as text.
pub(in crate::toolkit::verify) fn render(file: &impl Serialize) -> serde_json::Result<String> {
    let mut text = Vec::new();
    file.serialize(&mut serde_json::Serializer::with_formatter(&mut text, Layout::default()))?;
    text.push(b'\n');
    String::from_utf8(text).map_err(serde::ser::Error::custom)
}

/// Root, list of cases, case, its inputs.
const OPEN: usize = 4;

impl Layout {
    fn line<W: ?Sized + Write>(&self, writer: &mut W) -> Result<()> {
        write!(writer, "\n{:1$}", "", 2 * self.depth)
    }

    fn begin<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8]) -> Result<()> {
        self.depth += 1;
        writer.write_all(bracket)
    }

    fn separate<W: ?Sized + Write>(&self, writer: &mut W, first: bool, open: bool) -> Result<()> {
        match (open, first) {
            (true, true) => self.line(writer),
            (true, false) => writer.write_all(b",").and_then(|()| self.line(writer)),
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b", "),
        }
    }

    fn end<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8], open: bool) -> Result<()> {
        self.depth -= 1;
        if open {
            self.line(writer)?;
        }
        writer.write_all(bracket)
    }
}

impl serde_json::ser::Formatter for Layout {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        self.begin(writer, b"[")
    }
    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        let open = self.depth == 2;
        self.end(writer, b"]", open)
    }
    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> Result<()> {
        self.separate(writer, first, self.depth == 2)
    }
    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        self.begin(writer, b"{")
    }
    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        let open = self.depth <= OPEN;
        self.end(writer, b"}", open)
    }
    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> Result<()> {
        self.separate(writer, first, self.depth <= OPEN)
    }
    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        writer.write_all(b": ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// The root, its lists, and the cases are broken into lines; lower levels and lists of numbers are not.
    #[test]
    fn each_field_of_a_case_has_a_line() {
        let value = json!({
            "a": [1, 2],
            "cases": [{"in": {"x": [1, 2], "y": {"z": 3, "w": [4]}}, "id": "b"}, {"id": "c"}],
        });
        let mut text = Vec::new();
        value.serialize(&mut serde_json::Serializer::with_formatter(&mut text, Layout::default())).unwrap();
        let expected = r#"{
  "a": [
    1,
    2
  ],
  "cases": [
    {
      "in": {
        "x": [1, 2],
        "y": {"z": 3, "w": [4]}
      },
      "id": "b"
    },
    {
      "id": "c"
    }
  ]
}"#;
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }
}
