//! Writing arrays.

use super::{PIECE, header};
use rawzip::{DataDescriptorOutput, ZipArchiveWriter, ZipEntryWriter, path::ZipFilePath};
use std::io::{self, BufWriter, Write};

/// Writes a file of arrays, one after the other.
///
/// ```
/// use jointproof::scene::npz::Writer;
///
/// let mut bytes = Vec::new();
/// let mut arrays = Writer::new(&mut bytes);
/// arrays.write("time", &[2], &[0.0, 0.5])?;
/// arrays.write("u", &[2, 1, 3], &[0.0, 0.0, 0.0, 0.5, 0.0, 0.0])?; // state, node, component
/// arrays.finish()?;
/// assert_eq!(&bytes[..2], b"PK");
/// # Ok::<(), std::io::Error>(())
/// ```
pub struct Writer<W: Write> {
    archive: ZipArchiveWriter<BufWriter<W>>,
}

impl<W: Write> Writer<W> {
    /// An empty file.
    pub fn new(to: W) -> Self {
        Self { archive: ZipArchiveWriter::new(BufWriter::with_capacity(1 << 16, to)) }
    }

    /// Writes the next array: its name, its size along each axis, and its numbers, with the last axis contiguous.
    ///
    /// # Errors
    /// A name that an archive cannot hold, numbers that do not fill the shape, or an error of the file system.
    pub fn write(&mut self, name: &str, shape: &[usize], numbers: &[f64]) -> io::Result<()> {
        let entry = Entry::new(name, shape)?;
        if entry.numbers != numbers.len() {
            return Err(invalid(format!("array {name:?}: {} numbers for a shape of {shape:?}", numbers.len())));
        }
        let mut sum = crc32fast::Hasher::new();
        sum.update(&entry.head);
        let mut writing = entry.start(&mut self.archive)?;
        little_endian_pieces(numbers, |bytes| {
            sum.update(bytes);
            writing.write_all(bytes)
        })?;
        entry.finish(writing, sum.finalize())
    }

    /// Ends the file.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn finish(self) -> io::Result<()> {
        self.archive.finish().map_err(io::Error::other)?.flush()
    }
}

fn invalid(what: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, what)
}

/// An array in an archive.
pub(super) struct Entry {
    file: String,
    /// The bytes before its numbers.
    pub(super) head: Vec<u8>,
    pub(super) numbers: usize,
}

impl Entry {
    pub(super) fn new(name: &str, shape: &[usize]) -> io::Result<Self> {
        let file = format!("{name}.npy");
        if ZipFilePath::from_str(&file).as_ref() != file {
            let allowed = "no \"\\\", no \"/\" at an end, and no \".\" or \"..\" between";
            return Err(invalid(format!("an array of the name {name:?}; allowed is a name with {allowed}")));
        }
        let numbers = shape.iter().try_fold(1_usize, |all, &size| all.checked_mul(size));
        let numbers = numbers.ok_or_else(|| invalid(format!("array {name:?} of more numbers than can be counted")))?;
        let mut head = Vec::new();
        header::write(shape, &mut head)?;
        Ok(Self { file, head, numbers })
    }

    /// Writes the bytes before the numbers.
    pub(super) fn start<'a, W: Write>(&self, to: &'a mut ZipArchiveWriter<W>) -> io::Result<ZipEntryWriter<'a, W>> {
        let (mut writing, _) = to.new_file(self.file.as_str()).start().map_err(io::Error::other)?;
        writing.write_all(&self.head)?;
        Ok(writing)
    }

    /// Writes the bytes after the numbers, given their checksum.
    pub(super) fn finish<W: Write>(&self, writing: ZipEntryWriter<'_, W>, sum: u32) -> io::Result<()> {
        let size = self.head.len() + self.numbers * size_of::<f64>();
        writing.finish(DataDescriptorOutput::new(sum, size as u64)).map_err(io::Error::other)?;
        Ok(())
    }
}

/// Writes numbers in the order of the file, piece by piece.
pub(super) fn little_endian_pieces(numbers: &[f64], mut write: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
    for piece in numbers.chunks(PIECE) {
        if cfg!(target_endian = "little") {
            write(bytemuck::cast_slice(piece))?;
        } else {
            write(&piece.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>())?;
        }
    }
    Ok(())
}
