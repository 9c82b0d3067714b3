//! Reads arrays, piece by piece into their destination.

use super::unfit::{Unfit, tuple};
use super::{PIECE, header};
use crate::formula::quantity::Domain;
use crate::scene::json::some_of;
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, FileReader, ZipArchive, ZipArchiveEntryWayfinder, ZipVerification};
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

/// The count of numbers of an array for which memory is reserved before it is known that the file has as many as it claims.
const BELIEVED: usize = 1 << 20;

/// The number of bytes read from the file at once, for arrays that are read in smaller pieces.
const BUFFER: u64 = 1 << 16;

/// A file of arrays.
pub(in crate::scene) struct Archive {
    /// The name in the scene.
    name: String,
    bytes: ZipArchive<FileReader>,
    entries: HashMap<String, Entry>,
}

impl fmt::Debug for Archive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Archive").field("name", &self.name).finish_non_exhaustive()
    }
}

/// The location of an array in the file.
#[derive(Clone, Copy)]
struct Entry {
    place: ZipArchiveEntryWayfinder,
    method: CompressionMethod,
}

impl Archive {
    /// Opens a file, which has this name in the scene.
    pub(in crate::scene) fn open(path: &Path, name: &str) -> Result<Self, Unfit> {
        let no_file = |error: io::Error| Unfit::new(format!("no file {name:?}: {error}"), "a file that can be read");
        let broken = |error: rawzip::Error| {
            Unfit::new(format!("{name:?}, which is no whole archive: {error}"), "a .npz file, as numpy.savez writes it")
        };
        let file = File::open(path).map_err(no_file)?;
        let mut buffer = vec![0; rawzip::RECOMMENDED_BUFFER_SIZE];
        let archive = ZipArchive::from_file(file, &mut buffer).map_err(broken)?;
        let mut buffer = vec![0; rawzip::MAX_CENTRAL_DIRECTORY_RECORD_SIZE];
        let mut found = archive.entries(&mut buffer);
        let mut entries = HashMap::new();
        while let Some(entry) = found.next_entry().map_err(broken)? {
            let file = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
            let array = file.strip_suffix(".npy").unwrap_or(&file).to_owned();
            let at = Entry { place: entry.wayfinder(), method: entry.compression_method() };
            if entries.insert(array, at).is_some() {
                return Err(Unfit::new(format!("{file:?} of {name:?} for the second time"), "each array once"));
            }
        }
        Ok(Self { name: name.into(), bytes: archive, entries })
    }

    /// Begins to read an array.
    pub(in crate::scene) fn array(&self, name: &str) -> Result<Array<'_>, Unfit> {
        let Some(&Entry { place, method }) = self.entries.get(name) else {
            let names: BTreeSet<_> = self.entries.keys().collect();
            let names = some_of(names.into_iter());
            let allowed = if names.is_empty() { "none, it is empty".into() } else { format!("one of {names}") };
            return Err(Unfit::new(format!("no array {name:?} in {:?}", self.name), allowed));
        };
        let called = format!("array {name:?} of {:?}", self.name);
        let entry = self.bytes.get_entry(place).map_err(|error| damaged(&called, error))?;
        let stored = entry.reader();
        let expected = stored.claim_verifier();
        let bytes: Box<dyn Read + Send + Sync> = match method {
            CompressionMethod::STORE => {
                let all = usize::try_from(BUFFER.min(expected.uncompressed_size)).unwrap_or_default();
                Box::new(BufReader::with_capacity(all, stored))
            }
            CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(stored)),
            other => {
                return Err(Unfit::new(
                    format!("{called}, compressed by method {other}"),
                    "an array that is stored or deflated: numpy.savez or numpy.savez_compressed",
                ));
            }
        };
        let mut bytes = Summed { bytes, sum: crc32fast::Hasher::new() };
        let (shape, before) = header::read(&mut bytes)
            .map_err(|Unfit { found, allowed }| Unfit { found: format!("{called}: {found}"), allowed })?;
        let size = shape.iter().try_fold(size_of::<f64>() as u64, |size, &axis| size.checked_mul(axis as u64));
        if size.and_then(|size| size.checked_add(before)) != Some(expected.uncompressed_size) {
            let numbers = expected.uncompressed_size.saturating_sub(before);
            let allowed = format!("as many as its shape {} takes", tuple(&shape));
            return Err(Unfit::new(format!("{called} with {numbers} bytes of numbers"), allowed));
        }
        Ok(Array { outline: Outline { called, shape }, bytes, expected, read: 0 })
    }
}

/// The error of an array, with this name, that differs from what was written.
fn damaged(called: &str, error: impl fmt::Display) -> Unfit {
    Unfit::new(format!("{called}, damaged: {error}"), "a whole array")
}

/// Bytes with their checksum so far.
struct Summed<'a> {
    bytes: Box<dyn Read + Send + Sync + 'a>,
    sum: crc32fast::Hasher,
}

impl fmt::Debug for Summed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Summed").field("sum", &self.sum).finish_non_exhaustive()
    }
}

impl Read for Summed<'_> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.bytes.read(to)?;
        self.sum.update(&to[..read]);
        Ok(read)
    }
}

/// The name of an array in errors, and the count of numbers along each axis.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Outline {
    called: String,
    shape: Vec<usize>,
}

/// An array being read.
#[derive(Debug)]
pub(in crate::scene) struct Array<'a> {
    outline: Outline,
    bytes: Summed<'a>,
    expected: ZipVerification,
    /// The count of numbers read so far.
    read: usize,
}

impl Outline {
    /// The count of numbers along each axis.
    pub(in crate::scene) fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// Checks the shape; `axes` says what is counted along each axis.
    pub(in crate::scene) fn expect(&self, shape: &[usize], axes: &str) -> Result<(), Unfit> {
        if self.shape == shape {
            return Ok(());
        }
        Err(self.misshapen(format!("{}: {axes}", tuple(shape))))
    }

    /// The error of a shape that is not allowed.
    pub(in crate::scene) fn misshapen(&self, allowed: impl Into<String>) -> Unfit {
        Unfit::new(format!("{} of shape {}", self.called, tuple(&self.shape)), allowed)
    }

    /// The error of a number that is not allowed, by its index among all numbers.
    pub(in crate::scene) fn wrong(&self, number: f64, place: usize, allowed: impl Into<String>) -> Unfit {
        let mut index = vec![0; self.shape.len()];
        let mut rest = place;
        for (index, &size) in index.iter_mut().zip(&self.shape).rev() {
            (*index, rest) = (rest % size, rest / size);
        }
        Unfit::new(format!("{} with {number:?} at {index:?}", self.called), allowed)
    }

    fn damaged(&self, error: impl fmt::Display) -> Unfit {
        damaged(&self.called, error)
    }
}

impl Array<'_> {
    pub(in crate::scene) fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Reads the next numbers, all of which must be finite and in a domain.
    pub(in crate::scene) fn fill(&mut self, numbers: &mut [f64], domain: Domain) -> Result<(), Unfit> {
        for piece in numbers.chunks_mut(PIECE) {
            let read = self.bytes.read_exact(bytemuck::cast_slice_mut(piece));
            read.map_err(|error| self.outline.damaged(error))?;
            for number in piece.iter_mut() {
                *number = f64::from_bits(u64::from_le(number.to_bits()));
            }
            let is_sound = |&number: &f64| number.is_finite() && domain.allows(number);
            if !are_all(piece, domain)
                && let Some(place) = piece.iter().position(|number| !is_sound(number))
            {
                return Err(self.outline.wrong(piece[place], self.read + place, domain.allowed()));
            }
            self.read += piece.len();
        }
        Ok(())
    }

    /// Reads all numbers.
    pub(in crate::scene) fn numbers(&mut self, domain: Domain) -> Result<Vec<f64>, Unfit> {
        let len: usize = self.outline.shape.iter().product();
        let mut numbers = Vec::with_capacity(len.min(BELIEVED));
        while numbers.len() < len {
            let from = numbers.len();
            numbers.resize(len.min(from + PIECE), 0.0);
            self.fill(&mut numbers[from..], domain)?;
        }
        self.finish()?;
        Ok(numbers)
    }

    /// Checks that nothing is left, and that the checksum is correct.
    pub(in crate::scene) fn finish(&mut self) -> Result<(), Unfit> {
        let left = self.bytes.read(&mut [0]).map_err(|error| self.outline.damaged(error))?;
        let read = ZipVerification {
            crc: self.bytes.sum.clone().finalize(),
            uncompressed_size: self.expected.uncompressed_size + left as u64,
        };
        self.expected.valid(read).map_err(|error| self.outline.damaged(error))
    }
}

/// Whether all numbers are finite and in a domain. Checking all of them is faster than stopping at the first fault.
fn are_all(numbers: &[f64], domain: Domain) -> bool {
    let are_finite = numbers.iter().fold(true, |all, number| all & number.is_finite());
    are_finite && (domain == Domain::Real || numbers.iter().fold(true, |all, &number| all & domain.allows(number)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_number_is_named_by_its_place_along_each_axis() {
        let said = |shape: &[usize], place| {
            Outline { called: "it".into(), shape: shape.into() }.wrong(0.5, place, "another").found
        };
        assert_eq!(said(&[2, 3, 4], 23), "it with 0.5 at [1, 2, 3]");
        assert_eq!(said(&[2, 3, 4], 5), "it with 0.5 at [0, 1, 1]");
        assert_eq!(said(&[3, 1, 2], 5), "it with 0.5 at [2, 0, 1]");
        assert_eq!(said(&[2, 1], 1), "it with 0.5 at [1, 0]");
        assert_eq!(said(&[9], 8), "it with 0.5 at [8]");
    }

    #[test]
    fn all_numbers_are_finite_and_in_the_domain_or_not_all_are() {
        for (numbers, domain, expected) in [
            ([0.0, -1.0], Domain::Real, true),
            ([0.0, -1.0], Domain::NonNegative, false),
            ([-1.0, 0.0], Domain::NonNegative, false),
            ([0.0, 1.0], Domain::NonNegative, true),
            ([f64::NAN, 1.0], Domain::Real, false),
            ([1.0, f64::INFINITY], Domain::NonNegative, false),
        ] {
            assert_eq!(are_all(&numbers, domain), expected, "{numbers:?}");
        }
        assert!(are_all(&[], Domain::Positive));
    }
}
