//! The lines of a table, cell by cell, with their numbers in the file.

use super::fault::TableFault;
use crate::scene::table::{Summed, Table};
use csv_core::{ReadRecordResult, Reader, ReaderBuilder, Terminator};
use std::io::{BufRead, BufReader};

/// The number of bytes that are read at once.
const BUFFER: usize = 1 << 16;

/// A table, line by line.
pub(super) struct Lines<'s> {
    table: &'s Table,
    bytes: BufReader<Summed>,
    reader: Reader,
    line: Vec<u8>,
    /// The number of the line, from 1.
    pub(super) number: u64,
    /// The cells of the line one after another, and where each ends.
    text: Vec<u8>,
    ends: Vec<usize>,
    /// The number of cells.
    count: usize,
}

impl<'s> Lines<'s> {
    /// Opens a table. Of comma, semicolon and tab, that which its first line has most often separates the cells.
    pub(super) fn open(table: &'s Table) -> Result<Self, TableFault> {
        let bytes = table.open().map_err(|error| unreadable(table, 0, &error))?;
        let bytes = BufReader::with_capacity(BUFFER, bytes);
        let (reader, line, text, ends) = (Reader::new(), Vec::new(), vec![0; 256], vec![0; 16]);
        let mut lines = Self { table, bytes, reader, line, number: 0, text, ends, count: 0 };
        if lines.read_line()? {
            if lines.line.starts_with(b"\xef\xbb\xbf") {
                lines.line.drain(..3);
            }
            let count = |separator: u8| lines.line.split(|&byte| byte == separator).count();
            // Of equally frequent ones the last is taken. What Windows has before the end of a line is blank.
            let separator = [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',');
            lines.reader = ReaderBuilder::new().delimiter(separator).terminator(Terminator::Any(b'\n')).build();
            lines.split()?;
        }
        Ok(lines)
    }

    /// Reads the next line that is not blank; `false` at the end.
    pub(super) fn advance(&mut self) -> Result<bool, TableFault> {
        let is_there = self.read_line()?;
        if is_there {
            self.split()?;
        }
        Ok(is_there)
    }

    /// The cells of the line.
    pub(super) fn cells(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.count).map(|index| self.cell(index))
    }

    /// A cell of the line without blanks around it, by its index.
    #[inline]
    pub(super) fn cell(&self, index: usize) -> &[u8] {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        self.text[start..self.ends[index]].trim_ascii()
    }

    /// The number of cells.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// The checksum of the table, once all of it is read.
    pub(super) fn sum(&self) -> u32 {
        self.bytes.get_ref().sum()
    }

    /// The number of bytes that persist from line to line.
    pub(super) const BYTES: usize = BUFFER;

    fn read_line(&mut self) -> Result<bool, TableFault> {
        loop {
            self.line.clear();
            self.number += 1;
            let read = self.bytes.read_until(b'\n', &mut self.line);
            if read.map_err(|error| unreadable(self.table, self.number, &error))? == 0 {
                return Ok(false);
            }
            if !self.line.trim_ascii().is_empty() {
                return Ok(true);
            }
        }
    }

    /// Splits the line into cells.
    fn split(&mut self) -> Result<(), TableFault> {
        self.reader.reset();
        let (mut read, mut written) = (0, 0);
        self.count = 0;
        loop {
            let input = &self.line[read..];
            let (result, taken, put, ended) =
                self.reader.read_record(input, &mut self.text[written..], &mut self.ends[self.count..]);
            (read, written, self.count) = (read + taken, written + put, self.count + ended);
            match result {
                ReadRecordResult::OutputFull => self.text.resize(2 * self.text.len(), 0),
                ReadRecordResult::OutputEndsFull => self.ends.resize(2 * self.ends.len(), 0),
                // A last line may have no end; an empty input ends it.
                ReadRecordResult::InputEmpty if !self.line.ends_with(b"\n") => self.line.push(b'\n'),
                ReadRecordResult::InputEmpty => {
                    return Err(TableFault {
                        table: self.table.name().into(),
                        line: self.number,
                        column: (self.count + 1, String::new()),
                        found: "a quotation mark that does not end in its line".into(),
                        allowed: "cells of one line, in two quotation marks or in none".into(),
                    });
                }
                ReadRecordResult::Record | ReadRecordResult::End => return Ok(()),
            }
        }
    }
}

/// A table that cannot be read at a line, or as a whole.
fn unreadable(table: &Table, line: u64, error: &std::io::Error) -> TableFault {
    TableFault {
        table: table.name().into(),
        line,
        column: (1, String::new()),
        found: error.to_string(),
        allowed: "a table that can be read".into(),
    }
}
