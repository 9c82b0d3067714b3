//! Arrays that grow together, row by row.

use super::PIECE;
use super::write::{Entry, little_endian_pieces};
use rawzip::ZipArchiveWriter;
use std::cell::Cell;
use std::io::{self, Seek, SeekFrom, Write};

/// A file of arrays in which each array receives its next row in turn; it has the same bytes as arrays written one after the
/// other by [`Writer`](super::Writer).
///
/// The positions of the numbers of each array follow from the shapes. The bytes between the arrays contain their checksums, and
/// are written at the end. Short rows are buffered.
pub(in crate::scene) struct Rows<W: Write + Seek> {
    to: W,
    arrays: Vec<Growing>,
    /// The maximum count of buffered numbers per array.
    wait: usize,
}

/// The maximum count of buffered numbers of all arrays.
const WAIT: usize = 1 << 20;

struct Growing {
    entry: Entry,
    /// Numbers waiting to be written.
    waiting: Vec<f64>,
    /// The position at which the next number is written.
    at: u64,
    sum: crc32fast::Hasher,
}

impl Growing {
    fn write(&mut self, numbers: &[f64], to: &mut (impl Write + Seek)) -> io::Result<()> {
        to.seek(SeekFrom::Start(self.at))?;
        self.at += size_of_val(numbers) as u64;
        little_endian_pieces(numbers, |bytes| {
            self.sum.update(bytes);
            to.write_all(bytes)
        })
    }

    fn write_waiting(&mut self, to: &mut (impl Write + Seek)) -> io::Result<()> {
        let mut waiting = std::mem::take(&mut self.waiting);
        self.write(&waiting, to)?;
        waiting.clear();
        self.waiting = waiting;
        Ok(())
    }
}

impl<W: Write + Seek> Rows<W> {
    /// Arrays with these names and shapes.
    pub(in crate::scene) fn new(to: W, arrays: impl Iterator<Item = (String, Vec<usize>)>) -> io::Result<Self> {
        let growing = |(name, shape): (String, Vec<usize>)| {
            let entry = Entry::new(&name, &shape)?;
            let mut sum = crc32fast::Hasher::new();
            sum.update(&entry.head);
            Ok(Growing { entry, waiting: Vec::new(), at: 0, sum })
        };
        let mut arrays: Vec<_> = arrays.map(growing).collect::<io::Result<_>>()?;
        let places = frame(io::sink(), &Cell::new(false), &arrays)?;
        arrays.iter_mut().zip(places).for_each(|(array, at)| array.at = at);
        let wait = PIECE.min(WAIT / arrays.len().max(1));
        Ok(Self { to, arrays, wait })
    }

    /// Writes the next numbers of an array.
    pub(in crate::scene) fn push(&mut self, array: usize, numbers: &[f64]) -> io::Result<()> {
        let growing = &mut self.arrays[array];
        if growing.waiting.len() + numbers.len() > self.wait {
            growing.write_waiting(&mut self.to)?;
        }
        if numbers.len() > self.wait {
            return growing.write(numbers, &mut self.to);
        }
        growing.waiting.extend(numbers);
        Ok(())
    }

    /// Ends the file.
    pub(in crate::scene) fn finish(mut self) -> io::Result<()> {
        for growing in &mut self.arrays {
            growing.write_waiting(&mut self.to)?;
        }
        self.to.rewind()?;
        let between = Cell::new(true);
        frame(Gaps { to: &mut self.to, between: &between, ahead: 0 }, &between, &self.arrays)?;
        self.to.flush()
    }
}

/// Writes the bytes between the numbers, and zeros for the numbers while `between` is false. Returns the positions of the
/// numbers.
fn frame(to: impl Write, between: &Cell<bool>, arrays: &[Growing]) -> io::Result<Vec<u64>> {
    static ZEROS: [u8; 1 << 16] = [0; 1 << 16];
    let mut archive = ZipArchiveWriter::new(to);
    let mut places = Vec::new();
    for Growing { entry, sum, .. } in arrays {
        let mut writing = entry.start(&mut archive)?;
        places.push(writing.stream_offset());
        between.set(false);
        let mut left = entry.numbers * size_of::<f64>();
        while left > 0 {
            let piece = left.min(ZEROS.len());
            writing.write_all(&ZEROS[..piece])?;
            left -= piece;
        }
        between.set(true);
        entry.finish(writing, sum.clone().finalize())?;
    }
    archive.finish().map_err(io::Error::other)?;
    Ok(places)
}

/// Skips the bytes that are not `between` the numbers.
struct Gaps<'g, W> {
    to: &'g mut W,
    between: &'g Cell<bool>,
    /// The number of bytes skipped since the last write.
    ahead: i64,
}

impl<W: Write + Seek> Write for Gaps<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if !self.between.get() {
            self.ahead += i64::try_from(bytes.len()).map_err(io::Error::other)?;
            return Ok(bytes.len());
        }
        if self.ahead > 0 {
            self.to.seek_relative(std::mem::take(&mut self.ahead))?;
        }
        self.to.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::npz::Writer;
    use std::io::Cursor;

    fn rows<'a>(to: &'a mut Cursor<Vec<u8>>, shapes: &[usize]) -> Rows<&'a mut Cursor<Vec<u8>>> {
        let arrays = shapes.iter().enumerate().map(|(array, &len)| (format!("a{array}"), vec![len]));
        Rows::new(to, arrays).unwrap()
    }

    #[test]
    fn rows_of_any_length_stand_in_their_order_and_few_numbers_wait() {
        let numbers: Vec<f64> = (0..2 * u32::try_from(PIECE).unwrap() + 7).map(f64::from).collect();
        let mut expected = Vec::new();
        let mut writer = Writer::new(&mut expected);
        writer.write("a0", &[numbers.len()], &numbers).unwrap();
        writer.write("a1", &[3], &numbers[..3]).unwrap();
        writer.finish().unwrap();
        let mut to = Cursor::new(Vec::new());
        let mut rows = rows(&mut to, &[numbers.len(), 3]);
        let mut rest = &numbers[..];
        for len in [5, PIECE, 1, PIECE + 1] {
            let (row, later) = rest.split_at(len);
            rows.push(0, row).unwrap();
            rest = later;
            assert!(rows.arrays[0].waiting.len() <= PIECE);
        }
        rows.push(1, &numbers[..3]).unwrap();
        rows.finish().unwrap();
        assert!(to.into_inner() == expected);
    }

    #[test]
    fn fewer_numbers_of_each_wait_where_there_are_many_arrays() {
        let mut to = Cursor::new(Vec::new());
        assert_eq!(rows(&mut to, &[]).wait, PIECE);
        assert_eq!(rows(&mut to, &[1; 8]).wait, PIECE);
        assert_eq!(rows(&mut to, &[1; 1000]).wait, 1048);
    }
}
