//! The header of an array: the type of its numbers, their order, and how many there are along each axis.

use super::unfit::{Unfit, tuple};
use std::io::{self, Read, Write};

const MAGIC: &[u8] = b"\x93NUMPY";

/// The type of numbers that is read and written: little-endian, 64 bits.
const TYPE: &str = "<f8";

/// Longer headers describe structures.
const LONGEST: usize = 1 << 16;

/// The numbers begin at a multiple of this.
const ALIGNMENT: usize = 64;

/// The contents of a dictionary, as far as present.
#[derive(Default)]
struct Said<'h> {
    descr: Option<&'h str>,
    fortran_order: Option<bool>,
    shape: Option<Vec<usize>>,
}

/// Reads a header: the shape of the array, and the number of bytes before its numbers.
pub(super) fn read(from: &mut dyn Read) -> Result<(Vec<usize>, u64), Unfit> {
    let (text, bytes) = text(from)?;
    let unreadable = || Unfit::new("a header that cannot be read", "what numpy.savez writes");
    let Said { descr, fortran_order, shape } = dictionary(&text).ok_or_else(unreadable)?;
    let (Some(descr), Some(fortran_order), Some(shape)) = (descr, fortran_order, shape) else {
        return Err(unreadable());
    };
    if descr != TYPE {
        let allowed = format!("'{TYPE}', little-endian floats of 64 bits: array.astype('{TYPE}')");
        return Err(Unfit::new(format!("numbers of type '{descr}'"), allowed));
    }
    if fortran_order {
        return Err(Unfit::new("Fortran order", "C order: numpy.ascontiguousarray(array)"));
    }
    Ok((shape, bytes))
}

/// The text of a header, and its number of bytes including those before it.
fn text(from: &mut dyn Read) -> Result<(String, u64), Unfit> {
    let cut = |error: io::Error| Unfit::new(format!("a header that cannot be read: {error}"), "a whole array");
    let mut start = [0; 8];
    from.read_exact(&mut start).map_err(cut)?;
    let [.., major, _] = start;
    if !start.starts_with(MAGIC) || !(1..=3).contains(&major) {
        return Err(Unfit::new("no array", "an array as numpy.savez writes it"));
    }
    let mut len = [0; 4];
    let width = if major == 1 { 2 } else { 4 };
    from.read_exact(&mut len[..width]).map_err(cut)?;
    let len = u32::from_le_bytes(len) as usize;
    if len > LONGEST {
        return Err(Unfit::new(format!("a header of {len} bytes"), format!("{LONGEST} bytes at most")));
    }
    let mut text = vec![0; len];
    from.read_exact(&mut text).map_err(cut)?;
    let text = String::from_utf8(text).map_err(|_| Unfit::new("a header that is no text", "UTF-8"))?;
    Ok((text, (start.len() + width + len) as u64))
}

/// `{'descr': '<f8', 'fortran_order': False, 'shape': (10, 3), }`, with keys in any order.
fn dictionary(text: &str) -> Option<Said<'_>> {
    let mut rest = Rest(text);
    let mut said = Said::default();
    rest.take("{")?;
    while rest.take("}").is_none() {
        let key = rest.quoted()?;
        rest.take(":")?;
        match key {
            "descr" => said.descr = Some(rest.descr()?),
            "fortran_order" => said.fortran_order = Some(rest.boolean()?),
            "shape" => said.shape = Some(rest.shape()?),
            _ => return None,
        }
        if rest.take(",").is_none() && !rest.0.trim_start().starts_with('}') {
            return None;
        }
    }
    rest.0.trim().is_empty().then_some(said)
}

/// The rest of a header.
struct Rest<'h>(&'h str);

impl<'h> Rest<'h> {
    fn take(&mut self, token: &str) -> Option<()> {
        self.0 = self.0.trim_start().strip_prefix(token)?;
        Some(())
    }

    fn quoted(&mut self) -> Option<&'h str> {
        let text = self.0.trim_start();
        let quote = text.chars().next().filter(|quote| ['\'', '"'].contains(quote))?;
        let (inside, rest) = text[1..].split_once(quote)?;
        self.0 = rest;
        Some(inside)
    }

    /// A type. For a structure, all of the remaining text; it is not read in any case.
    fn descr(&mut self) -> Option<&'h str> {
        let text = self.0.trim_start();
        if !text.starts_with('[') {
            return self.quoted();
        }
        let (structure, _) = text.split_at(text.rfind(']')? + 1);
        let rest = text[structure.len()..].trim_start();
        self.0 = rest;
        Some(structure)
    }

    fn boolean(&mut self) -> Option<bool> {
        self.take("True").map(|()| true).or_else(|| self.take("False").map(|()| false))
    }

    fn shape(&mut self) -> Option<Vec<usize>> {
        self.take("(")?;
        let (sizes, rest) = self.0.split_once(')')?;
        self.0 = rest;
        let sizes = sizes.trim().trim_end_matches(',');
        if sizes.is_empty() {
            return Some(Vec::new());
        }
        sizes.split(',').map(|size| size.trim().trim_end_matches('L').parse().ok()).collect()
    }
}

/// Writes the header of an array of this shape, as numpy does.
pub(super) fn write(shape: &[usize], to: &mut impl Write) -> io::Result<()> {
    let text = format!("{{'descr': '{TYPE}', 'fortran_order': False, 'shape': {}, }}", tuple(shape));
    let before = MAGIC.len() + 4;
    // A line break ends the header.
    let len = (before + text.len() + 1).next_multiple_of(ALIGNMENT) - before;
    let size = u16::try_from(len).map_err(|_| io::Error::other("an array of too many axes"))?;
    to.write_all(MAGIC)?;
    to.write_all(&[1, 0])?;
    to.write_all(&size.to_le_bytes())?;
    to.write_all(format!("{text:width$}\n", width = len - 1).as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn array(version: u8, text: &str) -> Vec<u8> {
        let len = u32::try_from(text.len()).unwrap().to_le_bytes();
        let len = if version == 1 { &len[..2] } else { &len[..] };
        [MAGIC, &[version, 0], len, text.as_bytes()].concat()
    }

    #[test]
    fn headers_are_read_as_numpy_may_write_them() {
        for shape in [vec![], vec![7], vec![2, 3], vec![10, 100_000, 3]] {
            let mut bytes = Vec::new();
            write(&shape, &mut bytes).unwrap();
            assert_eq!((bytes.len() % ALIGNMENT, bytes.last()), (0, Some(&b'\n')));
            assert_eq!(read(&mut &*bytes).unwrap(), (shape, bytes.len() as u64));
        }
        for (version, text) in [
            (1, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }   \n"),
            (2, "{\"shape\":(2,3),\"fortran_order\":False,\"descr\":\"<f8\"}"),
            (3, " { 'shape' : ( 2 , 3L, ) , 'descr' : '<f8' , 'fortran_order' : False } "),
        ] {
            let bytes = array(version, text);
            assert_eq!(read(&mut &*bytes).unwrap(), (vec![2, 3], bytes.len() as u64), "{text}");
        }
    }

    #[test]
    fn what_is_no_header_is_said() {
        let found = |bytes: &[u8]| read(&mut &*bytes).unwrap_err().found;
        let said = |text: &str| found(&array(1, text));
        assert_eq!(said("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }"), "numbers of type '<f4'");
        assert_eq!(said("{'descr': '|O', 'fortran_order': False, 'shape': (2,), }"), "numbers of type '|O'");
        let structure = "{'descr': [('x', '<f8'), ('y', '<f8')], 'fortran_order': False, 'shape': (2,), }";
        assert_eq!(said(structure), "numbers of type '[('x', '<f8'), ('y', '<f8')]'");
        assert_eq!(said("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }"), "Fortran order");
        let unreadable = "a header that cannot be read";
        for text in [
            "",
            "{",
            "{'descr': '<f8'}",
            "{'descr': '<f8', 'fortran_order': 0, 'shape': (2,)}",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (-2,)}",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999,)}",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2,)} more",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), 'more': 1}",
            "{'descr': '<f8' 'fortran_order': False, 'shape': (2,)}",
            "{'descr': [[[[[[[[, 'fortran_order': False, 'shape': (2,)}",
            "{'é': '<f8'}",
        ] {
            assert_eq!(said(text), unreadable, "{text}");
        }
        assert_eq!(found(b"PK no array at all"), "no array");
        assert_eq!(found(&array(9, "{}")), "no array");
        assert!(found(&MAGIC[..4]).starts_with(unreadable));
        assert!(found(&array(1, "{'descr': '<f8'}")[..15]).starts_with(unreadable));
        let claim = [MAGIC, &[2, 0], &u32::MAX.to_le_bytes()].concat();
        assert_eq!(found(&claim), "a header of 4294967295 bytes");
        assert_eq!(found(&[MAGIC, &[1, 0, 1, 0, 0xFF]].concat()), "a header that is no text");
    }

    #[test]
    fn a_header_may_be_as_long_as_a_structure_needs_and_no_longer() {
        let start = "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }";
        let padded = |len: usize| array(2, &[start, &" ".repeat(len - start.len())].concat());
        assert_eq!(read(&mut &*padded(LONGEST)).unwrap().0, [2]);
        assert_eq!(read(&mut &*padded(LONGEST + 1)).unwrap_err().found, "a header of 65537 bytes");
    }

    #[test]
    fn versions_from_one_to_three_are_known() {
        let text = "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }";
        assert!([1, 2, 3].iter().all(|&version| read(&mut &*array(version, text)).is_ok()));
        assert!([0, 4].iter().all(|&version| read(&mut &*array(version, text)).unwrap_err().found == "no array"));
    }
}
